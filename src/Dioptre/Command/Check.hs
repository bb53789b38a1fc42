{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Check
-- Description : dioptre check: diagnostics only
--
-- The same diagnostics that @render@ shows before it draws, as a result: on standard output, all files one after
-- the other, so that an editor or a script can read them. A file that cannot be read does not keep the others from
-- being checked. Specification: 11.6.
module Dioptre.Command.Check
  ( check,
    checkWithOriginal,
  )
where

import Control.Monad (forM, forM_)
import Data.Aeson (encode, object, (.=))
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Char (toLower)
import Data.Either (lefts, rights)
import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Journal (Journal, journalLanguage, sayFault, toConsole)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Load (Loaded (..), loadScene)
import Dioptre.Scene.Configuration (checkConfiguration)
import Dioptre.Scene.Original (departures)
import Dioptre.Source.Diagnostic (Diagnostic (..), needsMending)
import Dioptre.Source.Language (inLanguage)
import Dioptre.Source.Report (pretty, summary, toJson)
import Dioptre.Source.Text (Source, decode, sourceName)
import Dioptre.Syntax.Grammar (parse)
import System.Exit (ExitCode (..))
import System.FilePath (takeExtension)
import System.IO (stdout)

-- | Prints the diagnostics of files on standard output: scenes with the files that they need, and configurations (whose
-- names end in @.cfg@). Exit codes: 0 nothing to mend, 1 errors or warnings, 3 a file that cannot be read.
--
-- Spec: cli.exit, cli.check, cli.check.json.
check :: Journal -> Format -> [FilePath] -> IO ExitCode
check = checked id

-- | The same, with notes on what the original program does otherwise with the scenes ("Dioptre.Scene.Original"). Notes
-- do not change the exit code.
checkWithOriginal :: Journal -> Format -> [FilePath] -> IO ExitCode
checkWithOriginal = checked $ \case
  -- Of a scene and its files the scene comes first.
  (source, diagnostics) : files -> (source, sortOn diagnosticSpan (diagnostics <> departures source (parse source) diagnostics)) : files
  [] -> []

-- | The diagnostics of files, of which those of a scene pass through the function.
checked :: ([(Source, [Diagnostic])] -> [(Source, [Diagnostic])]) -> Journal -> Format -> [FilePath] -> IO ExitCode
checked ofScene journal format paths = do
  results <- forM paths $ \path -> if isConfiguration path then checkedConfiguration path else fmap (ofScene . loadedDiagnostics) <$> loadScene l path
  let files = concat (rights results)
  case format of
    AsText -> forM_ files $ \(source, diagnostics) -> do
      forM_ diagnostics (toConsole stdout . pretty l source)
      Text.putStrLn (Text.pack (sourceName source) <> inLanguage l ": " "\xA0: " <> fromMaybe (inLanguage l "no faults" "aucune faute") (summary l diagnostics))
    AsJson ->
      Lazy.putStrLn . encode $
        object ["diagnostics" .= [toJson l (sourceName source) d | (source, diagnostics) <- files, d <- diagnostics]]
  forM_ (lefts results) (sayFault journal)
  pure $ case () of
    _ | not (null (lefts results)) -> ExitFailure 3
    _ | any (any needsMending . snd) files -> ExitFailure 1
    _ -> ExitSuccess
  where
    l = journalLanguage journal
    isConfiguration path = map toLower (takeExtension path) == ".cfg"
    checkedConfiguration path = either (Left . fileFault l) (Right . configurationOf . decode path) <$> readWhole path
    configurationOf source = [(source, snd (checkConfiguration (parse source)))]
