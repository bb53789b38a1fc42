{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Dioptre.Command.Render
-- Description : dioptre render: one scene, one picture
--
-- What the options ask for that the scene cannot give, and what would keep the picture from being written, is found
-- before anything is drawn.
module Dioptre.Command.Render
  ( Options (..),
    Output (..),
    render,
  )
where

import Control.Exception (evaluate)
import Data.Bifunctor (bimap, first)
import Data.Char (toLower)
import Data.Maybe (fromMaybe, isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayDiagnostics, sayFault, sayObstacles, sayText)
import Dioptre.Command.Trace (Traced (..), sayBlack, sayCut, timed, traced)
import Dioptre.Command.Wording (seconds, statistics)
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Identity (sameFile)
import Dioptre.Files.Number (PictureNumber, numberingObstacle, writeNumbered)
import Dioptre.Files.Whole (writeWhole, writingObstacle)
import Dioptre.Files.Wording (fileFault, numberingFault)
import Dioptre.Load (Loaded (..), loadScene, loadedFiles)
import Dioptre.Render.Row (Plan, plan, planExtent, planWithin, window)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.World (Extent (..))
import Dioptre.Scene (Scene, sceneViewport, withSampling, withViewport)
import Dioptre.Scene.Camera (Viewport, mostPixels, viewport, viewportHeight, viewportImage, viewportWidth)
import Dioptre.Scene.Configuration (configurationFile)
import Dioptre.Source.Diagnostic (needsMending)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (number)
import System.Directory (doesDirectoryExist)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory, takeExtension)

-- | What to render, and how.
data Options = Options
  { optionScene :: FilePath,
    optionOutput :: Output,
    -- | Instead of the scene's own.
    optionWidth :: Maybe Int,
    -- | Instead of the scene's own.
    optionHeight :: Maybe Int,
    -- | Instead of the scene's own.
    optionSampling :: Maybe Int,
    -- | Column, row, width and height of the part to render.
    optionCrop :: Maybe (Int, Int, Int, Int),
    -- | Whether a faulty scene is not drawn.
    optionStrict :: Bool
  }

-- | Where the picture goes.
data Output
  = -- | Exactly there.
    ToFile FilePath
  | -- | To the working directory, under the scene's name and the first free number from this one on.
    Numbered PictureNumber

-- | Renders a scene and prints the path of its picture. Exit codes as in the README.
--
-- Spec: cli.exit, cli.render, cli.render.faults, cli.render.crop.
render :: Journal -> Options -> IO ExitCode
render journal options = do
  (reading, result) <- timed (loadScene l (optionScene options))
  case result of
    Left fault -> ExitFailure 3 <$ sayFault journal fault
    Right loaded
      | optionStrict options && any (any needsMending . snd) (loadedDiagnostics loaded) -> do
        sayObstacles journal (loadedDiagnostics loaded)
        ExitFailure 1 <$ sayFault journal (inLanguage l "nothing is drawn, as --strict asks" "rien n'est dessiné, comme le demande --strict")
      | otherwise -> do
        sayDiagnostics journal (loadedDiagnostics loaded)
        case adjusted options loaded of
          Left complaint -> ExitFailure 2 <$ sayFault journal (complaint l)
          Right (scene, planned) -> do
            obstacle <- outputObstacle options scene (loadedFiles loaded)
            case obstacle of
              Just fault -> ExitFailure (fst fault) <$ sayFault journal (snd fault l)
              Nothing -> drawn reading scene planned
  where
    l = journalLanguage journal
    drawn reading scene planned = do
      (indexing, size) <- timed (evaluate (planExtent planned))
      sayBlack journal scene size
      outcome <- write scene (traced journal planned)
      case outcome of
        Left fault -> ExitFailure 3 <$ sayFault journal fault
        Right (path, Traced tally tracing writing) -> do
          mapM_ (sayText journal . misnomer l) (falseEnding options)
          sayCut journal tally
          sayText journal $
            Text.concat
              [ statistics l (tallyRays tally) (tallyTests tally),
                inLanguage l "; reading " "\xA0; lecture ",
                seconds reading,
                if extentBoxes size > 0 then inLanguage l ", indexing " ", indexation " <> seconds indexing else "",
                inLanguage l ", tracing " ", tracé ",
                seconds tracing,
                inLanguage l ", writing " ", écriture ",
                seconds writing
              ]
          Text.putStrLn (Text.pack path)
          pure ExitSuccess
    write scene image = case optionOutput options of
      ToFile path -> bimap (fileFault l) (path,) <$> writeWhole path image
      Numbered from ->
        bimap (numberingFault l) (first fst)
          <$> writeNumbered "." (viewportImage (sceneViewport scene)) from image

-- | The scene with the options' size and sampling, and its plan; or what is wrong with the options.
--
-- Spec: cli.render.
adjusted :: Options -> Loaded -> Either (Language -> Text) (Scene, Plan)
adjusted options loaded = do
  let scene = loadedScene loaded
      assets = loadedAssets loaded
      library = loadedLibrary loaded
  port <- resized (optionWidth options) (optionHeight options) (sceneViewport scene)
  let scene' = maybe id withSampling (optionSampling options) (withViewport port scene)
  case optionCrop options of
    Nothing -> Right (scene', plan assets library scene')
    Just (x, y, w, h) -> case window port x y w h of
      Just part -> Right (scene', planWithin part assets library scene')
      Nothing -> Left (`outside` port)
  where
    outside l port =
      inLanguage l "--crop does not lie in the picture, which has " "--crop sort de l'image, qui a "
        <> Text.pack (show (viewportWidth port) <> " x " <> show (viewportHeight port))
        <> " pixels"

resized :: Maybe Int -> Maybe Int -> Viewport -> Either (Language -> Text) Viewport
resized w h port = case viewport width height (viewportImage port) of
  Right other -> Right other
  Left _ -> Left tooMany
  where
    width = fromMaybe (viewportWidth port) w
    height = fromMaybe (viewportHeight port) h
    -- No side is less than 1, as the options' values are read.
    tooMany l =
      Text.concat
        [ Text.intercalate (inLanguage l " and " " et ") (["--width" | isJust w] <> ["--height" | isJust h]),
          if isJust w && isJust h then inLanguage l " ask for " " demandent " else inLanguage l " asks for " " demande ",
          number width <> " x " <> number height,
          inLanguage l " pixels, more than the " " pixels, plus que les ",
          number mostPixels,
          inLanguage l " that a picture may have" " qu'une image peut avoir"
        ]

-- | What would prevent the picture of a scene from being written, found before it is drawn; with the exit code that it
-- deserves. Given the files that the scene reads, none of which is replaced, by whatever path.
--
-- Spec: cli.render.safe.
outputObstacle :: Options -> Scene -> [FilePath] -> IO (Maybe (Int, Language -> Text))
outputObstacle options scene files = case optionOutput options of
  Numbered from -> fmap (\fault -> (3, (`numberingFault` fault))) <$> numberingObstacle "." (viewportImage (sceneViewport scene)) from
  ToFile path -> do
    replaced <- sameFile path (itself : configurationFile : files)
    let folder = takeDirectory path
    there <- doesDirectoryExist folder
    case replaced of
      Just file -> pure (Just (2, \l -> inLanguage l "the picture would replace " "l'image remplacerait " <> what l file <> inLanguage l ": " "\xA0: " <> Text.pack file))
      Nothing
        | there -> fmap (\fault -> (3, (`fileFault` fault))) <$> writingObstacle path
        | otherwise -> pure (Just (3, \l -> fileFault l (FileFault folder DoesNotExist)))
  where
    itself = optionScene options
    what l file
      | file == itself = inLanguage l "the scene" "la scène"
      | file == configurationFile = inLanguage l "the configuration" "la configuration"
      | otherwise = inLanguage l "a file that the scene reads" "un fichier que la scène lit"

-- | Where the picture goes, if the name says that it is a picture of another format than the one that is written.
--
-- Spec: cli.render.safe.
falseEnding :: Options -> Maybe FilePath
falseEnding options = case optionOutput options of
  ToFile path | map toLower (takeExtension path) `elem` others -> Just path
  _ -> Nothing
  where
    others = [".avif", ".bmp", ".gif", ".jpeg", ".jpg", ".pdf", ".ppm", ".svg", ".tga", ".tif", ".tiff", ".webp"]

misnomer :: Language -> FilePath -> Text
misnomer l path =
  inLanguage l "remark: " "remarque\xA0: " <> Text.pack path
    <> inLanguage l " is a PNG in spite of its name: no other format is written" " est un PNG malgré son nom\xA0: aucun autre format n'est écrit"
