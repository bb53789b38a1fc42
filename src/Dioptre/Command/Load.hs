{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Dioptre.Command.Load
-- Description : From a path to a scene or a picture
module Dioptre.Command.Load
  ( Loaded (..),
    loadScene,
    loadBuiltIn,
    loadPicture,
    drawnOrLoaded,
  )
where

import Control.Exception (SomeAsyncException (..), SomeException, evaluate, fromException, tryJust)
import Control.Monad (forM, (<=<))
import Data.Bifunctor (first)
import Data.Char (toLower)
import Data.Containers.ListUtils (nubOrd)
import Data.Foldable (toList)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Command.Wording (fileFault, undecodable)
import Dioptre.Files.Search (Place (..), SearchFault (..), search)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Picture (Picture)
import Dioptre.Picture.Png (decode, decodeTexture)
import Dioptre.Render (renderWith)
import Dioptre.Render.Row (plan)
import Dioptre.Render.Texture (Assets)
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkScene, pictureNames)
import Dioptre.Scene.Configuration (defaultSceneFile)
import Dioptre.Scene.Default (defaultScene)
import Dioptre.Source.Diagnostic (Diagnostic (..), FileTrouble (..), FileUse, Problem (UnusableFile))
import Dioptre.Source.Language (Language)
import Dioptre.Source.Span (Span)
import Dioptre.Source.Text (Source, fromText)
import qualified Dioptre.Source.Text as Source
import Dioptre.Syntax.Grammar (parse)
import GHC.Conc (getNumCapabilities)
import System.FilePath (takeDirectory, takeExtension, (</>))

-- | A scene with its text, the pictures that it uses, and what there is to say of it.
data Loaded = Loaded
  { loadedSource :: Source,
    loadedScene :: Scene,
    loadedAssets :: Assets,
    loadedDiagnostics :: [Diagnostic]
  }

-- | The scene in the file at a path, with its pictures; or why there is none, in words.
loadScene :: Language -> FilePath -> IO (Either Text Loaded)
loadScene l path =
  readWhole path >>= \bytes -> case Source.decode path <$> bytes of
    Left fault -> pure (Left (fileFault l fault))
    Right source -> do
      let tree = parse source
          (scene, diagnostics) = checkScene tree
      (assets, troubles) <- loadPictures l (takeDirectory path) (pictureNames tree)
      let everything = sortOn diagnosticSpan (diagnostics <> troubles)
      Right (Loaded source scene assets everything) <$ evaluate (length everything)

-- | The scene that is built in. It uses no pictures.
loadBuiltIn :: Loaded
loadBuiltIn = uncurry (\scene -> Loaded source scene mempty) (checkScene (parse source))
  where
    source = fromText (Text.unpack defaultSceneFile) defaultScene

-- | The pictures that a scene in a folder names, each loaded once; and what is wrong with each place that names one.
loadPictures :: Language -> FilePath -> [(Text, FileUse, Span)] -> IO (Assets, [Diagnostic])
loadPictures l folder wanted = do
  loaded <- forM (nubOrd [name | (name, _, _) <- wanted]) $ \name -> (,) name <$> loadTexture l folder name
  pure
    ( Map.fromList [(name, p) | (name, Right p) <- loaded],
      [ Diagnostic place (UnusableFile name use trouble)
        | (name, use, place) <- wanted,
          Just (Left trouble) <- [lookup name loaded]
      ]
    )

loadTexture :: Language -> FilePath -> Text -> IO (Either FileTrouble Picture)
loadTexture l folder name =
  search "." folder name >>= \case
    Left (NoName _) -> pure (Left (NoSuchFile []))
    Left (NotFound _ places) -> pure (Left (NoSuchFile (map folderOf (toList places))))
    Left (SeveralFound _ paths) -> pure (Left (SeveralFiles (toList paths)))
    Right path ->
      readWhole path >>= \case
        Left fault -> pure (Left (Unreadable (fileFault l fault)))
        -- The decoder is not ours: what it throws on a broken file is its complaint.
        Right b -> either (Left . Unreadable) (first Unreadable) <$> tryJust thrown (evaluate (decodeTexture path b) >>= traverse evaluate)
  where
    folderOf place = case place of
      Within f -> f
      Below f -> f </> "..."
    thrown :: SomeException -> Maybe Text
    thrown e = case fromException e of
      Just (SomeAsyncException _) -> Nothing
      Nothing -> Just (Text.pack (takeWhile (/= '\n') (show e)))

-- | The picture in the file at a path, or why there is none, in words.
loadPicture :: Language -> FilePath -> IO (Either Text Picture)
loadPicture l path = (first (undecodable l path) . decode <=< first (fileFault l)) <$> readWhole path

-- | The picture at a path: for a scene (a path that ends in @.txt@) the one that it draws, and its scene; otherwise the one in the file.
drawnOrLoaded :: Language -> FilePath -> IO (Either Text (Picture, Maybe Loaded))
drawnOrLoaded l path
  | map toLower (takeExtension path) /= ".txt" = fmap (,Nothing) <$> loadPicture l path
  | otherwise =
    loadScene l path >>= \case
      Left fault -> pure (Left fault)
      Right scene -> do
        workers <- getNumCapabilities
        (drawn, _) <- renderWith workers (pure ()) (plan (loadedAssets scene) (loadedScene scene))
        pure (Right (drawn, Just scene))
