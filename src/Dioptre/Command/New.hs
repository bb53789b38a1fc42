{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TemplateHaskell #-}

-- |
-- Module      : Dioptre.Command.New
-- Description : dioptre new: a scene to start from
--
-- The scenes stand in the folder @starters@, one in each language, and are compiled in. They draw the same picture, and
-- are named @my_scene@ inside until they have a name.
module Dioptre.Command.New
  ( new,
    starter,
    starterNamed,
  )
where

import Control.Exception (bracketOnError, tryJust)
import Control.Monad (guard, void)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isAlphaNum, isAscii, isControl, toLower)
import Data.FileEmbed (embedFile)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayFault)
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Descriptor (createExclusively)
import Dioptre.Files.Fault (orFault)
import Dioptre.Files.Temporary (withTemporary)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Source.Language (Language, inLanguage)
import qualified Dioptre.Source.Text as Source
import System.Directory (renameFile)
import System.Exit (ExitCode (..))
import System.FilePath (dropExtension, takeDirectory, takeExtension, takeFileName)
import System.IO.Error (isAlreadyExistsError)
import System.Posix.Files (removeLink)

-- | Writes a scene to start from, commented in the journal's language, to a path, to which @.txt@ is added where it
-- does not end so; prints the path that it has. Exit codes: 0 written, 2 this is no name for a scene, 3 there is
-- something of that name, which stays as it is, or it cannot be written.
new :: Journal -> FilePath -> IO ExitCode
new journal name
  | any isControl name || dropExtension (takeFileName path) `elem` ["", ".", ".."] =
    ExitFailure 2 <$ sayFault journal (inLanguage l "this is no name for a scene: " "ce n'est pas un nom de scène\xA0: " <> Text.pack (show name))
  | otherwise =
    orFault path (tryJust (guard . isAlreadyExistsError) written) >>= \case
      Left fault -> ExitFailure 3 <$ sayFault journal (fileFault l fault)
      Right (Left ()) -> ExitFailure 3 <$ sayFault journal (Text.pack path <> inLanguage l ": there is a file of this name; it stays as it is" "\xA0: un fichier porte déjà ce nom\xA0; il reste comme il est")
      Right (Right ()) -> ExitSuccess <$ Text.putStrLn (Text.pack path)
  where
    l = journalLanguage journal
    path = if map toLower (takeExtension name) == ".txt" then name else name <> ".txt"
    -- The name is claimed first, by an empty file, which then gives way to the whole one at once.
    written =
      bracketOnError (createExclusively path) (const (removeLink path)) . const $
        void (withTemporary (takeDirectory path) Nothing (contents (Lazy.fromStrict (Text.encodeUtf8 (starterNamed path (starter l))))) (`renameFile` path))

-- | The scene, commented in a language.
starter :: Language -> Text
starter l = Source.sourceText (Source.decode "" (inLanguage l english french))

english, french :: ByteString
english = $(embedFile "starters/scene.en.txt")
french = $(embedFile "starters/scene.fr.txt")

-- | The scene under its own name: the path in the commands that its comments show, and the name of its pictures.
--
-- Law: it stays free of faults, and draws the same picture.
starterNamed :: FilePath -> Text -> Text
starterNamed path = Text.intercalate (quoted (Text.pack path)) . map (Text.replace "my_scene" stem) . Text.splitOn "my_scene.txt"
  where
    file = Text.pack (dropExtension (takeFileName path))
    -- What cannot name a picture leaves it the name that it has.
    stem = if Text.null file || Text.any (== '\\') file || Text.strip file /= file then "my_scene" else file
    -- As a shell takes it for one word.
    quoted t
      | Text.all (\c -> isAscii c && isAlphaNum c || c `elem` ("._-/" :: String)) t = t
      | otherwise = "'" <> Text.replace "'" "'\\''" t <> "'"
