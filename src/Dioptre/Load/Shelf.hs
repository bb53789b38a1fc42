{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.Load.Shelf
-- Description : Files that have been loaded already
--
-- A scene may name a picture or a model a thousand times, in many spellings, and its models may name it as well. Each
-- file is read once: what came of it stays on a shelf, under the file's own path.
module Dioptre.Load.Shelf
  ( -- * The shelf
    Shelf (..),
    emptyShelf,
    Loading,
    once,

    -- * What stands on it
    Shelved (..),

    -- * Finding files
    Found (..),
    findFile,
    seek,

    -- * Pictures
    loadPictures,
  )
where

import Control.Monad (forM)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.State.Strict (StateT, gets, modify')
import Data.Bifunctor (first)
import Data.Containers.ListUtils (nubOrd)
import Data.Foldable (toList)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Sequence (Seq)
import qualified Data.Sequence as Seq
import Data.Text (Text)
import Dioptre.Files.Search (Place (..), SearchFault (..), search)
import Dioptre.Files.Stamp (Stamp, stampOf)
import Dioptre.Files.Whole (readPlain)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Load.Amount (ModelRead)
import Dioptre.Load.Decoding (attempted)
import Dioptre.Model.Content (Content)
import Dioptre.Model.Library (Instance)
import Dioptre.Model.Mtl (Mtl)
import Dioptre.Picture (Picture)
import Dioptre.Picture.Png (decodeTexture)
import Dioptre.Render.Texture (Texture)
import Dioptre.Scene.Model (UvFormat)
import Dioptre.Source.Diagnostic (Diagnostic (..), FileTrouble (..), FileUse, Problem (UnusableFile))
import Dioptre.Source.Language (Language)
import Dioptre.Source.Span (Span)
import Dioptre.Source.Text (Source)
import System.Directory (canonicalizePath)
import System.FilePath ((</>))

-- | What has been loaded so far. Files are known by their canonical paths.
data Shelf = Shelf
  { -- | What was found for a name in a folder.
    shelfFound :: Map (FilePath, Text) (Either FileTrouble Found),
    -- | The pictures.
    shelfPictures :: Map FilePath (Either FileTrouble Picture),
    -- | The material libraries.
    shelfMaterials :: Map FilePath (Either FileTrouble (Mtl Picture)),
    -- | What is in the library.
    shelfModels :: Map FilePath (Either FileTrouble Shelved),
    -- | The models, by their numbers.
    shelfLibrary :: Seq (Content Instance Texture),
    -- | The models' files, as their reading ends.
    shelfRead :: Seq ModelRead,
    -- | What is wrong with models and their materials, by files, as their reading ends; each in its order, and none is
    -- empty.
    shelfFaults :: Seq (Source, [Diagnostic])
  }

-- | Nothing has been loaded.
emptyShelf :: Shelf
emptyShelf = Shelf Map.empty Map.empty Map.empty Map.empty Seq.empty Seq.empty Seq.empty

-- | Work that loads files.
type Loading = StateT Shelf IO

-- | A model in the library.
data Shelved = Shelved
  { -- | Its number there.
    shelvedNumber :: !Int,
    -- | Whether its file has nothing to draw in it: no shape, no triangle, and no other model, not even one that
    -- is left out.
    shelvedIsEmpty :: !Bool,
    -- | Its shapes and triangles, those of the models in it counted as often as they are there.
    shelvedSize :: !Integer,
    -- | 1 for a model without others in it, otherwise one more than the highest of those.
    shelvedHeight :: !Int,
    -- | As the first model that named the file stated it.
    shelvedUvFormat :: !UvFormat,
    -- | Whether that matters.
    shelvedHasPictures :: !Bool
  }

-- | What stands on a part of the shelf under a key; or else, from now on, what some work makes for it.
--
-- Spec: models.once.
once :: Ord k => (Shelf -> Map k v) -> (Map k v -> Shelf -> Shelf) -> k -> Loading v -> Loading v
once part put key work =
  gets (Map.lookup key . part) >>= maybe make pure
  where
    make = do
      v <- work
      modify' (\shelf -> put (Map.insert key v (part shelf)) shelf)
      pure v

-- | A file that was looked for.
data Found = Found
  { -- | As one calls it from the working directory.
    foundPath :: FilePath,
    -- | Without links: the same for every way to the file.
    foundFile :: FilePath,
    -- | What it was then.
    foundStamp :: Maybe Stamp
  }
  deriving stock (Eq, Show)

-- | The file that a name means in a file of a folder.
--
-- Spec: code.files.
findFile :: FilePath -> Text -> Loading (Either FileTrouble Found)
findFile folder name = once shelfFound (\m shelf -> shelf {shelfFound = m}) (folder, name) (liftIO (seek folder name))

-- | The same, without a shelf.
seek :: FilePath -> Text -> IO (Either FileTrouble Found)
seek folder name = search "." folder name >>= either (pure . Left . trouble) (\path -> Right <$> (Found path <$> canonicalizePath path <*> stampOf path))
  where
    trouble fault = case fault of
      NoName _ -> NoSuchFile [] Nothing
      NotFound _ places near -> NoSuchFile (map folderOf (toList places)) near
      SeveralFound _ paths -> SeveralFiles (toList paths)
    folderOf place = case place of
      Within f -> f
      Below f -> f </> "..."

-- | The pictures that a file in a folder names; and what is wrong with each place that names one.
--
-- Spec: code.files, files.pictures.
loadPictures :: Language -> FilePath -> [(Text, FileUse, Span)] -> Loading (Map Text Picture, [Diagnostic])
loadPictures l folder wanted = do
  loaded <- fmap Map.fromList . forM (nubOrd [name | (name, _, _) <- wanted]) $ \name ->
    (,) name <$> (findFile folder name >>= either (pure . Left) (loadTexture l))
  pure
    ( Map.mapMaybe (either (const Nothing) Just) loaded,
      [ Diagnostic place (UnusableFile name use trouble)
        | (name, use, place) <- wanted,
          Just (Left trouble) <- [Map.lookup name loaded]
      ]
    )

-- | The picture in a file.
--
-- Spec: models.texture.formats.
loadTexture :: Language -> Found -> Loading (Either FileTrouble Picture)
loadTexture l found =
  once shelfPictures (\m shelf -> shelf {shelfPictures = m}) (foundFile found) . liftIO $
    readPlain path >>= \case
      Left fault -> pure (Left (Unreadable (fileFault l fault)))
      Right bytes -> first Undecodable <$> attempted (decodeTexture path) bytes
  where
    path = foundPath found
