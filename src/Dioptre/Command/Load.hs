-- |
-- Module      : Dioptre.Command.Load
-- Description : From a path to a scene or a picture
module Dioptre.Command.Load
  ( Loaded (..),
    loadScene,
    loadBuiltIn,
    sceneOf,
    loadPicture,
    drawnOrLoaded,
  )
where

import Control.Exception (evaluate)
import Data.Bifunctor (first)
import Data.Char (toLower)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Command.Wording (fileFault, undecodable)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Picture (Picture)
import Dioptre.Picture.Png (decode)
import Dioptre.Render (renderWith)
import Dioptre.Render.Row (plan)
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Scene.Configuration (defaultSceneFile)
import Dioptre.Scene.Default (defaultScene)
import Dioptre.Source.Diagnostic (Diagnostic)
import Dioptre.Source.Language (Language)
import Dioptre.Source.Text (Source, fromText)
import qualified Dioptre.Source.Text as Source
import Dioptre.Syntax.Grammar (parse)
import GHC.Conc (getNumCapabilities)
import System.FilePath (takeExtension)

-- | A scene with its text, and what there is to say of it.
data Loaded = Loaded
  { loadedSource :: Source,
    loadedScene :: Scene,
    loadedDiagnostics :: [Diagnostic]
  }

-- | The scene in the file at a path, read to its end; or why there is none, in words.
loadScene :: Language -> FilePath -> IO (Either Text Loaded)
loadScene l path =
  readWhole path >>= \bytes -> case sceneOf . Source.decode path <$> bytes of
    Left fault -> pure (Left (fileFault l fault))
    Right loaded -> Right loaded <$ evaluate (length (loadedDiagnostics loaded))

-- | The scene of a text.
sceneOf :: Source -> Loaded
sceneOf source = uncurry (Loaded source) (checkScene (parse source))

-- | The scene that is built in.
loadBuiltIn :: Loaded
loadBuiltIn = sceneOf (fromText (Text.unpack defaultSceneFile) defaultScene)

-- | The picture in the file at a path, or why there is none, in words.
loadPicture :: Language -> FilePath -> IO (Either Text Picture)
loadPicture l path = (>>= first (undecodable l path) . decode) . first (fileFault l) <$> readWhole path

-- | The picture at a path: for a scene (a path that ends in @.txt@) the one that it draws, and its scene; otherwise the one in the file.
drawnOrLoaded :: Language -> FilePath -> IO (Either Text (Picture, Maybe Loaded))
drawnOrLoaded l path
  | map toLower (takeExtension path) /= ".txt" = fmap (\p -> (p, Nothing)) <$> loadPicture l path
  | otherwise =
    loadScene l path >>= \loaded -> case loaded of
      Left fault -> pure (Left fault)
      Right scene -> do
        workers <- getNumCapabilities
        (drawn, _) <- renderWith workers (pure ()) (plan (loadedScene scene))
        pure (Right (drawn, Just scene))
