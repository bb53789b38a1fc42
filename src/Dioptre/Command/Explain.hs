{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Explain
-- Description : dioptre explain: the story of one pixel
--
-- The rim of IO round "Dioptre.Explain.Story": the scene is loaded as for drawing, and what is told of the pixel
-- is data until it is printed, in words or as JSON. Specification: 11.6.
module Dioptre.Command.Explain
  ( explain,
  )
where

import Data.Aeson (encode)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Journal (Journal, journalLanguage, sayDiagnostics, sayFault)
import Dioptre.Explain.Json (storyJson)
import Dioptre.Explain.Wording (storyText)
import Dioptre.Load (Loaded (..), loadScene, storyAt)
import Dioptre.Scene (sceneViewport)
import Dioptre.Scene.Camera (viewportHeight, viewportWidth)
import Dioptre.Source.Language (inLanguage)
import Dioptre.Source.Phrase (safe)
import System.Exit (ExitCode (..))

-- | Prints the story of the pixel at a column and a row of a scene's picture on standard output; what is wrong with the
-- scene is said as when it is rendered. Exit codes: 0 told, 2 for a pixel outside of the picture, 3 for a scene that
-- cannot be read.
--
-- Spec: cli.explain.
explain :: Journal -> Format -> FilePath -> Int -> Int -> IO ExitCode
explain journal format path column row = do
  result <- loadScene l path
  case result of
    Left fault -> ExitFailure 3 <$ sayFault journal fault
    Right loaded -> do
      sayDiagnostics journal (loadedDiagnostics loaded)
      case storyAt loaded column row of
        Nothing -> ExitFailure 2 <$ sayFault journal (outside (sceneViewport (loadedScene loaded)))
        Just story -> do
          case format of
            AsText -> Text.putStr (Text.unlines (map safe (Text.lines (storyText l name story))))
            AsJson -> Lazy.putStrLn (encode (storyJson name story))
          pure ExitSuccess
  where
    l = journalLanguage journal
    name = Text.pack path
    outside port =
      inLanguage l "the pixel is outside of the picture: columns go from 0 to " "le pixel est hors de l'image\xA0: les colonnes vont de 0 à "
        <> shown (viewportWidth port - 1)
        <> inLanguage l ", rows from 0 to " ", les lignes de 0 à "
        <> shown (viewportHeight port - 1)
    shown = Text.pack . show
