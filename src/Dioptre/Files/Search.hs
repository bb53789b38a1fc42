{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Files.Search
-- Description : Finding the file that a scene means
--
-- Scenes name models, textures and masks, and a configuration names its scene, by name alone: folders that stand in
-- front of the name are dropped (they are those of somebody else's computer), upper and lower case are one. The
-- search goes in steps, nearest first:
--
-- > 1. beside the file that names it
-- > 2. in scenes/ and in models/ of the working directory
-- > 3. anywhere below the working directory, seven folders deep
--
-- The first step that finds anything decides, and it has to be one file: where two answer to the name in the same
-- step, nobody can know which was meant, so that is a fault, even if one has the very spelling that was asked for. A
-- file is counted once, however many links lead to it.
--
-- Left out of step 3: hidden folders, those that tools fill (@.stack-work@, @dist@, @dist-newstyle@, @node_modules@),
-- links to folders (they may go in circles), and folders that may not be read.
--
-- All paths that go in and come out are relative to the working directory, or absolute: @working \<\/> found@ opens
-- the file.
--
-- Sources: Unicode Standard 3.13, default case folding
-- (<https://www.unicode.org/Public/UCD/latest/ucd/CaseFolding.txt>).
module Dioptre.Files.Search
  ( -- * Searching
    search,
    wantedName,
    knownName,

    -- * What can go wrong
    SearchFault (..),
    Place (..),
  )
where

import Control.Exception (IOException, try)
import Control.Monad (filterM)
import Data.Bifunctor (first)
import qualified Data.ByteString as Bytes
import Data.Char (isAscii)
import Data.Either (fromRight)
import Data.List (find, sort)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Text.Encoding (decodeLatin1, decodeUtf8')
import Dioptre.Files.Identity (identity)
import Dioptre.Syntax.Spelling (suggest)
import qualified GHC.Foreign as Foreign
import GHC.IO.Encoding (getFileSystemEncoding)
import System.Directory (canonicalizePath, listDirectory)
import System.FilePath (isRelative, makeRelative, normalise, (</>))
import System.Posix.Files (getFileStatus, getSymbolicLinkStatus, isDirectory, isRegularFile)

-- | Why a name leads to no file. The name is given as it was written.
data SearchFault
  = -- | Nothing is left of the name once blanks and folders are dropped.
    NoName Text
  | -- | No file has that name in any of these places, nearest first; the name of one that nearly has it.
    NotFound Text (NonEmpty Place) (Maybe Text)
  | -- | Several files have it, all found in the same step: at least two paths, sorted.
    SeveralFound Text (NonEmpty FilePath)
  deriving stock (Eq, Show)

-- | Where files are looked for.
data Place
  = -- | In this folder itself.
    Within FilePath
  | -- | In this folder and the folders below it.
    Below FilePath
  deriving stock (Eq, Show)

-- | @search working folder name@ finds the file that @name@ means in a file of @folder@. The path is relative to
-- @working@ where the file is below it.
--
-- Cost: steps 1 and 2 list three folders; step 3 looks at every file below the working directory.
--
-- Spec: files.steps, files.several, run.search.
search :: FilePath -> FilePath -> Text -> IO (Either SearchFault FilePath)
search working folder written = case wantedName written of
  Nothing -> pure (Left (NoName written))
  Just name -> do
    beside <- pleasant working folder
    let inStep [] = Left . NotFound written (Within beside :| common <> [everywhere]) <$> nearName working name [beside, "scenes", "models"]
        inStep (places : later) = do
          hits <- traverse (look working name) places
          found <- distinct working (sort (concat hits))
          case found of
            [] -> inStep later
            [path] -> pure (Right path)
            path : others -> pure (Left (SeveralFound written (path :| others)))
    inStep [[Within beside], common, [everywhere]]
  where
    common = [Within "scenes", Within "models"]
    everywhere = Below "."

-- | The part of a written name that counts, in the form in which names are compared: without folders (after @\/@ or
-- @\\@) and without blanks around it, case folded. Nothing where that leaves no name of a file.
--
-- >>> wantedName (Text.pack " C:\\Users\\moi\\Th\233i\232re.OBJ ")
-- Just "th\233i\232re.obj"
-- >>> wantedName (Text.pack "models/..")
-- Nothing
--
-- Spec: files.named.
wantedName :: Text -> Maybe Text
wantedName written
  | name `elem` map Text.pack ["", ".", ".."] = Nothing
  | otherwise = Just (Text.toCaseFold name)
  where
    name = Text.strip (Text.takeWhileEnd (`notElem` "/\\") written)

-- Looking

-- | The files of this name in a place.
--
-- Spec: files.steps.
look :: FilePath -> Text -> Place -> IO [FilePath]
look working name (Within folder) = do
  entries <- entriesOf (working </> folder)
  among working name folder entries
look working name (Below top) = descend (0 :: Int) top
  where
    descend depth folder = do
      entries <- entriesOf (working </> folder)
      here <- among working name folder entries
      let inner = if depth < deepest then filter (not . isLeftOut) entries else []
      folders <- filterM (isFolder . (working </>)) (map (joined folder) inner)
      deeper <- traverse (descend (depth + 1)) folders
      pure (here <> concat deeper)

-- | The files of this name among a folder's entries.
among :: FilePath -> Text -> FilePath -> [FilePath] -> IO [FilePath]
among working name folder entries = do
  named <- filterM (hasName name) entries
  filterM (isFile . (working </>)) (map (joined folder) named)

-- | The name of a file in these folders that has the same ending and nearly the same letters before it: nearly as in
-- 'suggest'. The first folder that has one decides.
--
-- Spec: check.texts.
nearName :: FilePath -> Text -> [FilePath] -> IO (Maybe Text)
nearName working name = foldr (\folder later -> nearIn folder >>= maybe later (pure . Just)) (pure Nothing)
  where
    (stem, ending) = parts name
    nearIn folder = do
      alike <- filterM (fmap ((== ending) . snd . parts) . knownName) . sort =<< entriesOf (working </> folder)
      names <- traverse textOf =<< filterM (isFile . (working </>) . joined folder) alike
      pure (suggest (map (fst . parts) names) stem >>= \near -> find ((== near) . fst . parts) names)
    parts = first (Text.dropEnd 1) . Text.breakOnEnd (Text.pack ".")

-- | How many folders below the working directory the search goes.
--
-- Spec: limits.files.
deepest :: Int
deepest = 7

-- | Whether the search stays out of folders of this name.
--
-- Spec: files.left-out.
isLeftOut :: FilePath -> Bool
isLeftOut name = take 1 name == "." || name `elem` ["dist", "dist-newstyle", "node_modules"]

-- | Whether this is a file, or a link to one; pipes and devices are none.
--
-- Spec: files.left-out.
isFile :: FilePath -> IO Bool
isFile path = orElse False (isRegularFile <$> getFileStatus path)

-- | Whether this is a folder itself, and not a link to one.
--
-- Spec: files.left-out.
isFolder :: FilePath -> IO Bool
isFolder path = orElse False (isDirectory <$> getSymbolicLinkStatus path)

-- | The names in a folder; none where there is no such folder, or it may not be read.
entriesOf :: FilePath -> IO [FilePath]
entriesOf = orElse [] . listDirectory

-- | Whether a file's name is this one, case folded.
hasName :: Text -> FilePath -> IO Bool
hasName wanted entry = (== wanted) <$> knownName entry

-- | The name of a file without its folder, in the form in which names are compared.
knownName :: FilePath -> IO Text
knownName entry = Text.toCaseFold <$> textOf entry

-- | A file's name as text: its bytes are UTF-8, or else Latin-1.
--
-- The locale has no say in this. Under @LC_ALL=C@ the run-time system knows no letter beyond ASCII and hands every
-- other byte over in disguise; so the bytes are asked for again.
--
-- Spec: files.bytes.
textOf :: FilePath -> IO Text
textOf entry
  | all isAscii entry = pure (Text.pack entry)
  | otherwise = do
    encoding <- getFileSystemEncoding
    bytes <- Foreign.withCStringLen encoding entry Bytes.packCStringLen
    pure (fromRight (decodeLatin1 bytes) (decodeUtf8' bytes))

-- | One path for each file: of several that lead to the same file, the first.
--
-- Spec: files.several.
distinct :: FilePath -> [FilePath] -> IO [FilePath]
distinct working paths = keepNew Set.empty <$> traverse identified paths
  where
    identified path = do
      file <- identity (working </> path)
      pure (maybe (Left path) Right file, path)
    keepNew _ [] = []
    keepNew seen ((file, path) : rest)
      | file `Set.member` seen = keepNew seen rest
      | otherwise = path : keepNew (Set.insert file seen) rest

-- Paths

-- | A folder as one would call it from the working directory: relative where it is below, else as it is given.
pleasant :: FilePath -> FilePath -> IO FilePath
pleasant working folder = orElse asGiven $ do
  base <- canonicalizePath (if null working then "." else working)
  relative <- makeRelative base <$> canonicalizePath (working </> asGiven)
  pure (if isRelative relative then relative else asGiven)
  where
    asGiven = if null folder then "." else normalise folder

-- | An entry of a folder, without a @.\/@ in front.
joined :: FilePath -> FilePath -> FilePath
joined "." entry = entry
joined folder entry = folder </> entry

-- | The action's result, or this one where the file system refuses.
orElse :: a -> IO a -> IO a
orElse value action = fromRight value <$> tryIO action
  where
    tryIO :: IO b -> IO (Either IOException b)
    tryIO = try
