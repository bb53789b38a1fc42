{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Dioptre.Load
-- Description : From a path to a scene or a picture
--
-- Where files come in. A scene is read and checked without any other file; then come the pictures and models that it
-- names, each looked for beside the scene and read once. Nothing that is missing stops anything: the place that names
-- it is told, and the scene does without.
--
-- > path -- decode, parse, check --> scene, and the names in it
-- >                                         |
-- >              pictures, models, materials, on one shelf --> assets, library, what is wrong
--
-- Specification: chapters 9 and 11.
module Dioptre.Load
  ( -- * Loading
    Loaded (..),
    loadedFiles,
    loadScene,
    loadSource,
    sceneText,
    drawnOrLoaded,

    -- * What becomes of a scene
    loadedPlan,
    storyAt,
  )
where

import Control.Exception (evaluate)
import Control.Monad.Trans.State.Strict (runStateT)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Char (toLower)
import Data.Foldable (toList)
import Data.List (sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Dioptre.Explain.Story (Story)
import Dioptre.Explain.Tell (tell)
import Dioptre.Files.Fault (FileFault (..), Reason (IsAPicture))
import Dioptre.Files.Whole (readPlain, readWhole)
import Dioptre.Files.Wording (fileFault, undecodable)
import Dioptre.Load.Amount (ModelRead (..))
import Dioptre.Load.Decoding (attempted)
import Dioptre.Load.Models (loadModels, sceneSite)
import Dioptre.Load.Shelf (Found (..), Shelf (..), emptyShelf, loadPictures)
import Dioptre.Model.Library (Library (..))
import Dioptre.Picture (Picture)
import Dioptre.Picture.Header (isSurelyPicture)
import Dioptre.Picture.Png (decode)
import Dioptre.Render (renderWith)
import Dioptre.Render.Row (Plan, plan)
import Dioptre.Render.Texture (Assets, Texture)
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkSceneFile, pictureNames)
import Dioptre.Source.Diagnostic (Diagnostic (..), FileTrouble)
import Dioptre.Source.Language (Language)
import Dioptre.Source.Text (Source, sourceName)
import qualified Dioptre.Source.Text as Source
import Dioptre.Syntax.Grammar (parse)
import GHC.Conc (getNumCapabilities)
import System.FilePath (takeDirectory, takeExtension)

-- | A scene, all files that it needs, and what there is to say of them.
data Loaded = Loaded
  { -- | The scene, checked.
    loadedScene :: Scene,
    -- | The pictures that the scene itself names.
    loadedAssets :: Assets,
    -- | The models that it names, and those that they name.
    loadedLibrary :: Library Texture,
    -- | The models' files, as their reading ended.
    loadedModels :: [ModelRead],
    -- | What is wrong, file by file: first the scene, then the models and their materials, as their reading ended; each
    -- in its order.
    loadedDiagnostics :: [(Source, [Diagnostic])],
    -- | What was found for each name of a file, which the scene or one of its models or their materials has, and which
    -- was looked for from that folder on.
    loadedSought :: Map (FilePath, Text) (Either FileTrouble Found)
  }

-- | All files that were found for a scene, each once, as one calls them from the working directory: models, their
-- materials, and pictures; not the scene's own.
loadedFiles :: Loaded -> [FilePath]
loadedFiles loaded = map foundPath (Map.elems (Map.fromList [(foundFile file, file) | Right file <- Map.elems (loadedSought loaded)]))

-- | The scene in the file at a path, with its pictures and models; or why there is none, in words.
--
-- Spec: files.command-line.
loadScene :: Language -> FilePath -> IO (Either Text Loaded)
loadScene l path = readWhole path >>= either (pure . Left . fileFault l) (fmap Right . loadSource l) . (>>= sceneText path)

-- | The text of a scene's file, given its path and its bytes, which may not be those of a picture: as a text they would
-- be a scene with nothing in it, and faults without end.
--
-- Spec: files.picture.
sceneText :: FilePath -> ByteString -> Either FileFault Source
sceneText path bytes
  | isSurelyPicture bytes = Left (FileFault path IsAPicture)
  | otherwise = Right (Source.decode path bytes)

-- | The scene of a text, with its pictures and models, which are looked for as if the text stood in the file whose path
-- is its name.
loadSource :: Language -> Source -> IO Loaded
loadSource l source = do
  let tree = parse source
      (scene, mentions, diagnostics) = checkSceneFile tree
      folder = takeDirectory (sourceName source)
  (((assets, missing), (instances, refused)), shelf) <-
    runStateT ((,) <$> loadPictures l folder (pictureNames tree) <*> loadModels (sceneSite l folder) mentions) emptyShelf
  let own = (source, sortOn diagnosticSpan (diagnostics <> missing <> refused))
      loaded =
        Loaded
          { loadedScene = scene,
            loadedAssets = assets,
            loadedLibrary = Library (Vector.fromList (toList (shelfLibrary shelf))) instances,
            loadedModels = toList (shelfRead shelf),
            loadedDiagnostics = own : toList (shelfFaults shelf),
            loadedSought = shelfFound shelf
          }
  loaded <$ evaluate (sum (map (length . snd) (loadedDiagnostics loaded)))

-- | The picture in the file at a path, or why there is none, in words.
loadPicture :: Language -> FilePath -> IO (Either Text Picture)
loadPicture l path = readPlain path >>= either (pure . Left . fileFault l) (fmap (first (undecodable l path)) . attempted decode)

-- | The picture at a path: for a scene (a path that ends in @.txt@) the one that it draws, and its scene; otherwise the
-- one in the file.
--
-- Spec: compare.pictures.
drawnOrLoaded :: Language -> FilePath -> IO (Either Text (Picture, Maybe Loaded))
drawnOrLoaded l path
  | map toLower (takeExtension path) /= ".txt" = fmap (,Nothing) <$> loadPicture l path
  | otherwise =
    loadScene l path >>= \case
      Left fault -> pure (Left fault)
      Right scene -> do
        workers <- getNumCapabilities
        (drawn, _) <- renderWith workers (pure ()) (loadedPlan scene)
        pure (Right (drawn, Just scene))

-- | The plan of a scene's whole picture.
loadedPlan :: Loaded -> Plan
loadedPlan loaded = plan (loadedAssets loaded) (loadedLibrary loaded) (loadedScene loaded)

-- | The story of the pixel at a column and a row of a scene's picture; 'Nothing' outside of it.
storyAt :: Loaded -> Int -> Int -> Maybe Story
storyAt loaded = tell (loadedAssets loaded) files (loadedLibrary loaded) (loadedScene loaded)
  where
    -- A model comes into the library as its reading ends: its number there is its place among those read.
    files = map (Text.pack . modelReadPath) (loadedModels loaded)
