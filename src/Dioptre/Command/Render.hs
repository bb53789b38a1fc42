{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Render
-- Description : dioptre render: one scene, one picture
module Dioptre.Command.Render
  ( Options (..),
    Output (..),
    render,

    -- * For other commands
    failing,
    sayDiagnostics,
    sayCut,
    traced,
    timed,
  )
where

import Control.Exception (evaluate)
import Control.Monad (forM_, when)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Journal (Journal, journalLanguage, say, sayFault, sayText, withProgress)
import Dioptre.Command.Wording (seconds, statistics)
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Identity (sameFile)
import Dioptre.Files.Number (PictureNumber, writeNumbered)
import Dioptre.Files.Whole (writeWhole)
import Dioptre.Files.Wording (fileFault, numberingFault)
import Dioptre.Load (Loaded (..), loadScene)
import Dioptre.Picture (Picture)
import Dioptre.Picture.Png (encode)
import Dioptre.Render (Tally (..), renderWith)
import Dioptre.Render.Row (Plan, plan, planExtent, planHeight, planWithin, window)
import Dioptre.Render.Shade (mostRays)
import Dioptre.Render.World (Extent (..))
import Dioptre.Scene (Scene (..))
import Dioptre.Scene.Camera (Viewport, viewport, viewportHeight, viewportImage, viewportWidth)
import Dioptre.Scene.Configuration (configurationFile)
import Dioptre.Scene.Raytracer (Raytracer (..))
import Dioptre.Source.Diagnostic (Diagnostic (..), Fate (LeftOut), Problem (ImpossibleObject), Severity (..), severity)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Message (message)
import Dioptre.Source.Report (pretty, summary)
import Dioptre.Source.Text (Source)
import GHC.Clock (getMonotonicTime)
import GHC.Conc (getNumCapabilities)
import System.Directory (doesDirectoryExist)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory)

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
render :: Journal -> Options -> IO ExitCode
render journal options = do
  (reading, result) <- timed (loadScene l (optionScene options))
  case result of
    Left fault -> ExitFailure 3 <$ sayFault journal fault
    Right loaded -> do
      sayDiagnostics journal (loadedDiagnostics loaded)
      if optionStrict options && any (any failing . snd) (loadedDiagnostics loaded)
        then ExitFailure 1 <$ sayFault journal (inLanguage l "nothing is drawn, as --strict asks" "rien n'est dessiné, comme le demande --strict")
        else case adjusted options loaded of
          Left complaint -> ExitFailure 2 <$ sayFault journal (complaint l)
          Right (scene, planned) -> do
            obstacle <- outputObstacle options (loadedFiles loaded)
            case obstacle of
              Just fault -> ExitFailure (fst fault) <$ sayFault journal (snd fault l)
              Nothing -> drawn reading scene planned
  where
    l = journalLanguage journal
    drawn reading scene planned = do
      (indexing, size) <- timed (evaluate (planExtent planned))
      (tracing, (image, tally)) <- timed (traced journal planned)
      (writing, outcome) <- timed (write scene image)
      case outcome of
        Left fault -> ExitFailure 3 <$ sayFault journal fault
        Right path -> do
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
      ToFile path -> either (Left . fileFault l) (const (Right path)) <$> writeWhole path (encode image)
      Numbered from ->
        either (Left . numberingFault l) (Right . fst)
          <$> writeNumbered "." (viewportImage (sceneViewport scene)) from (encode image)

-- | The scene with the options' size and sampling, and its plan; or what is wrong with the options.
adjusted :: Options -> Loaded -> Either (Language -> Text) (Scene, Plan)
adjusted options loaded = do
  let scene = loadedScene loaded
      assets = loadedAssets loaded
      library = loadedLibrary loaded
  port <- resized (optionWidth options) (optionHeight options) (sceneViewport scene)
  let tracer = sceneRaytracer scene
      scene' = scene {sceneViewport = port, sceneRaytracer = maybe tracer (\n -> tracer {raytracerSampling = n}) (optionSampling options)}
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
resized w h port = either (Left . tooMany) Right (viewport (fromMaybe (viewportWidth port) w) (fromMaybe (viewportHeight port) h) (viewportImage port))
  where
    tooMany flaw l = message l (ImpossibleObject "--width, --height" flaw LeftOut)

-- | What would prevent the picture from being written, found before it is drawn; with the exit code that it deserves. Given the files that the scene reads, none of which is replaced,
-- by whatever path.
outputObstacle :: Options -> [FilePath] -> IO (Maybe (Int, Language -> Text))
outputObstacle options files = case optionOutput options of
  Numbered _ -> pure Nothing
  ToFile path -> do
    replaced <- sameFile path (scene : configurationFile : files)
    let folder = takeDirectory path
    there <- doesDirectoryExist folder
    pure $ case replaced of
      Just file -> Just (2, \l -> inLanguage l "the picture would replace " "l'image remplacerait " <> what l file <> inLanguage l ": " "\xA0: " <> Text.pack file)
      Nothing | there -> Nothing
      Nothing -> Just (3, \l -> fileFault l (FileFault folder DoesNotExist))
  where
    scene = optionScene options
    what l file
      | file == scene = inLanguage l "the scene" "la scène"
      | file == configurationFile = inLanguage l "the configuration" "la configuration"
      | otherwise = inLanguage l "a file that the scene reads" "un fichier que la scène lit"

-- | The picture of a plan by all processors, with a bar that shows how far it is.
traced :: Journal -> Plan -> IO (Picture, Tally)
traced journal planned = do
  workers <- getNumCapabilities
  withProgress journal (inLanguage (journalLanguage journal) "tracing" "tracé") (planHeight planned) $ \done -> renderWith workers done planned

-- | Says that some pixels wanted more rays than are followed, if any did.
sayCut :: Journal -> Tally -> IO ()
sayCut journal tally =
  when (tallyCut tally > 0) . sayText journal $
    inLanguage l "warning: " "avertissement\xA0: "
      <> Text.pack (show (tallyCut tally))
      <> inLanguage l " rays of the camera branched into more than " " rayons de la caméra se sont ramifiés en plus de "
      <> Text.pack (show mostRays)
      <> inLanguage l "; what lies beyond those is black" "\xA0; ce qui est au-delà est noir"
  where
    l = journalLanguage journal

-- | How long some work took, in seconds.
timed :: IO a -> IO (Double, a)
timed work = do
  start <- getMonotonicTime
  result <- work
  end <- getMonotonicTime
  pure (end - start, result)

-- | Whether a diagnostic makes @check@ and @--strict@ fail.
failing :: Diagnostic -> Bool
failing d = severity (diagnosticProblem d) >= Warning

-- | Every diagnostic in full, file by file, and how many there were in all.
sayDiagnostics :: Journal -> [(Source, [Diagnostic])] -> IO ()
sayDiagnostics journal files = do
  forM_ files $ \(source, diagnostics) -> forM_ diagnostics (say journal . pretty l source)
  forM_ (summary l (concatMap snd files)) (sayText journal)
  where
    l = journalLanguage journal
