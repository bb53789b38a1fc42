{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Run
-- Description : dioptre without arguments: what configuration.cfg says
--
-- The handout's program: it reads configuration.cfg in the working directory, runs the application that it names, and
-- leaves a picture, the whole scene (out.txt), a log, and the next picture's number in the configuration.
module Dioptre.Command.Run
  ( run,
    readConfiguration,
    firstNumber,
  )
where

import Control.Concurrent.STM (readTVarIO)
import Control.Exception (evaluate, onException)
import Control.Monad (forM)
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Compare (verdict)
import Dioptre.Command.Info (info)
import Dioptre.Command.Journal (Journal, journalLanguage, journalWith, sayDiagnostics, sayFault, sayText, written)
import Dioptre.Command.Trace (sayCut, timed, traced)
import Dioptre.Command.View (ViewOptions (..), awaitDeparture, awaitPicture, builtIn, viewing)
import Dioptre.Command.Wording (extent, modelRead, seconds, statistics)
import Dioptre.Files.Counter (replaceCounter)
import Dioptre.Files.Fault (FileFault (..), Reason (DoesNotExist))
import Dioptre.Files.Number (PictureNumber, next, pictureNumber, writeNumbered)
import Dioptre.Files.Search (search)
import Dioptre.Files.Whole (readWhole, writeWhole)
import Dioptre.Files.Wording (fileFault, numberingFault, searchFault)
import Dioptre.Load (Loaded (..), drawnOrLoaded, loadSource, loadedPlan)
import Dioptre.Picture (Difference (Equal), Picture, difference)
import Dioptre.Picture.Png (encode)
import Dioptre.Render (Tally (..))
import Dioptre.Render.Row (planExtent)
import Dioptre.Scene (Scene, scenePrimitives, sceneViewport, writeScene)
import Dioptre.Scene.Camera (viewportImage)
import Dioptre.Scene.Comparisons (checkComparisons, writeComparisons)
import Dioptre.Scene.Configuration
import Dioptre.Scene.Default (defaultScene)
import Dioptre.Source.Diagnostic (Diagnostic)
import Dioptre.Source.Language (inLanguage)
import Dioptre.Source.Text (Source, decode)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.View.Frame (Frame (..), Progress (..), framePicture)
import System.Directory (doesFileExist)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory)
import System.IO (hFlush, stdout)

-- | The configuration in the working directory, with its text and what there is to say of it; or why there is none.
readConfiguration :: IO (Either FileFault (Source, Configuration, [Diagnostic]))
readConfiguration = fmap (understood . decode configurationFile) <$> readWhole configurationFile
  where
    understood source = let (configuration, diagnostics) = checkConfiguration (parse source) in (source, configuration, diagnostics)

-- | Runs what the configuration says. Without one, tells what there is to know and writes one. Exit codes as in the README.
run :: Journal -> Either FileFault (Source, Configuration, [Diagnostic]) -> IO ExitCode
run journal found = case found of
  Left (FileFault _ DoesNotExist) -> do
    Text.putStr (info l)
    saved journal configurationFile startingConfiguration
  Left fault -> ExitFailure 3 <$ sayFault journal (fileFault l fault)
  Right (source, configuration, diagnostics) -> do
    let spoken = journalWith l (configurationLogConsole configuration) journal
    sayDiagnostics spoken [(source, diagnostics)]
    logged spoken configuration (apply spoken configuration)
  where
    l = journalLanguage journal

-- | Runs some work, and writes the log whatever becomes of it.
logged :: Journal -> Configuration -> IO ExitCode -> IO ExitCode
logged journal configuration work
  | not (configurationLogFile configuration) = work
  | otherwise = worse <$> (work `onException` writeLog) <*> writeLog
  where
    writeLog = written journal >>= saved journal (Text.unpack (configurationLogName configuration))

-- | The exit code of two things done one after the other: the first that is not success.
worse :: ExitCode -> ExitCode -> ExitCode
worse ExitSuccess code = code
worse code _ = code

-- | Runs the application.
apply :: Journal -> Configuration -> IO ExitCode
apply journal configuration = case configurationApplication configuration of
  RunNothing -> ExitSuccess <$ sayText journal (inLanguage l "configuration.cfg runs no application" "configuration.cfg ne lance aucune application")
  RunInfo -> Text.putStr (info l) >> writeDefaultScene journal
  RunConsole -> draw journal configuration
  RunFrame -> frame journal configuration
  RunComparator -> compareAll journal configuration
  where
    l = journalLanguage journal

-- | Writes the built-in scene to a file that can be changed and read under another name; never over one that is there.
writeDefaultScene :: Journal -> IO ExitCode
writeDefaultScene journal = do
  there <- doesFileExist (Text.unpack defaultSceneFile)
  if there then pure ExitSuccess else saved journal (Text.unpack defaultSceneFile) defaultScene

-- | Writes a text, whole. A failure is told, and is exit code 3.
saved :: Journal -> FilePath -> Text -> IO ExitCode
saved journal path text = writeWhole path (Lazy.fromStrict (Text.encodeUtf8 text)) >>= either (failed journal . fileFault (journalLanguage journal)) (const (pure ExitSuccess))

failed :: Journal -> Text -> IO ExitCode
failed journal fault = ExitFailure 3 <$ sayFault journal fault

-- | Draws the scene: reads it, traces it, writes the picture, counts it, and writes the scene back.
draw :: Journal -> Configuration -> IO ExitCode
draw journal configuration = withSource journal configuration $ \(source, _) -> do
  (reading, loaded) <- timed (loadSource l source)
  sayScene journal loaded (inLanguage l "; read in " "\xA0; lue en " <> seconds reading)
  let planned = loadedPlan loaded
  (indexing, size) <- timed (evaluate (planExtent planned))
  sayText journal (extent l size <> inLanguage l "; built in " "\xA0; construit en " <> seconds indexing)
  (tracing, (image, tally)) <- timed (traced journal planned)
  leave journal configuration (loadedScene loaded) image tracing tally
  where
    l = journalLanguage journal

-- | Shows the scene in the browser while it is drawn, and leaves the same as soon as it is; ends when its page is closed. What it leaves is the first
-- picture that is finished: of the scene as it was changed, if somebody changed it before. A picture that is too large for the page is drawn without it.
frame :: Journal -> Configuration -> IO ExitCode
frame journal configuration = withSource journal configuration $ \scene ->
  viewing journal (ViewOptions Nothing True) True scene $ \viewer ->
    awaitPicture viewer >>= \case
      Nothing -> draw journal configuration
      Just shown -> do
        let loaded = frameLoaded shown
        sayScene journal loaded ""
        sayText journal (extent l (planExtent (framePlan shown)))
        progress <- readTVarIO (frameProgress shown)
        image <- framePicture shown
        code <- leave journal configuration (loadedScene loaded) image (progressSeconds progress) (progressTally progress)
        code <$ awaitDeparture viewer
  where
    l = journalLanguage journal

-- | What there is to say of a scene that was read, with an end to its last line.
sayScene :: Journal -> Loaded -> Text -> IO ()
sayScene journal loaded end = do
  mapM_ (sayText journal . modelRead l) (loadedModels loaded)
  sayDiagnostics journal (loadedDiagnostics loaded)
  sayText journal $
    inLanguage l "the scene has " "la scène comprend " <> Text.pack (show primitives) <> (if primitives == 1 then " primitive" else " primitives") <> end
  where
    l = journalLanguage journal
    primitives = length (scenePrimitives (loadedScene loaded))

-- | Leaves what an application leaves of a picture that took some seconds: the picture, its number, and the scene.
leave :: Journal -> Configuration -> Scene -> Picture -> Double -> Tally -> IO ExitCode
leave journal configuration scene image tracing tally = do
  sayText journal (inLanguage l "traced in " "tracée en " <> seconds tracing <> ": " <> statistics l (tallyRays tally) (tallyTests tally))
  sayCut journal tally
  (writing, outcome) <- timed (writeNumbered "." (viewportImage (sceneViewport scene)) (firstNumber configuration) (encode image))
  case outcome of
    Left fault -> failed journal (numberingFault l fault)
    Right (path, used) -> do
      sayText journal (inLanguage l "picture '" "image '" <> Text.pack path <> inLanguage l "' written in " "' écrite en " <> seconds writing)
      Text.putStrLn (Text.pack path)
      hFlush stdout
      worse <$> count journal (next used) <*> saved journal (Text.unpack (configurationWrite configuration)) (writeScene scene)
  where
    l = journalLanguage journal

-- | Does some work with the text of the scene that the configuration names, and whether its name is the path of a file: the built-in one, or one that is looked for.
withSource :: Journal -> Configuration -> ((Source, Bool) -> IO ExitCode) -> IO ExitCode
withSource journal configuration act = do
  sayText journal (inLanguage l "reading scene '" "lecture de la scène '" <> name <> "'")
  source >>= either (failed journal) act
  where
    l = journalLanguage journal
    name = configurationRead configuration
    source
      | Text.toCaseFold (Text.strip name) == defaultSceneFile = pure (Right (builtIn, False))
      | otherwise =
        search "." "." name >>= \case
          Left fault -> pure (Left (searchFault l fault))
          Right path -> either (Left . fileFault l) (\bytes -> Right (decode path bytes, True)) <$> readWhole path

-- | The number that the configuration wants the next picture to have.
firstNumber :: Configuration -> PictureNumber
firstNumber = fromMaybe minBound . pictureNumber . configurationImageCount

-- | Puts the next picture's number into the configuration, as it is now on the disk, and changes nothing else in it.
count :: Journal -> PictureNumber -> IO ExitCode
count journal following =
  readWhole configurationFile
    >>= either (pure . Left) (writeWhole configurationFile . Lazy.fromStrict . replaceCounter following)
    >>= either (failed journal . fileFault (journalLanguage journal)) (const (pure ExitSuccess))

-- | Compares the pairs of a list, prints how each differs, and writes the list back. Exit code 1 if any does.
compareAll :: Journal -> Configuration -> IO ExitCode
compareAll journal configuration = do
  found <- search "." "." (configurationRead configuration)
  case found of
    Left fault -> failed journal (searchFault l fault)
    Right path ->
      readWhole path >>= \bytes -> case decode path <$> bytes of
        Left fault -> failed journal (fileFault l fault)
        Right source -> do
          let (pairs, diagnostics) = checkComparisons (parse source)
          sayDiagnostics journal [(source, diagnostics)]
          codes <- forM (zip [1 :: Int ..] pairs) $ uncurry (comparePair journal path)
          code <- saved journal (Text.unpack (configurationWrite configuration)) (writeComparisons pairs)
          pure (maximum (code : codes))
  where
    l = journalLanguage journal

comparePair :: Journal -> FilePath -> Int -> (Text, Text) -> IO ExitCode
comparePair journal list i (a, b) = do
  left <- shown a
  right <- shown b
  case (,) <$> left <*> right of
    Left fault -> do
      result (inLanguage l "undecided" "indéterminé")
      failed journal fault
    Right ((p, _), (q, _)) -> do
      result (verdict l (difference p q))
      pure (if difference p q == Equal then ExitSuccess else ExitFailure 1)
  where
    l = journalLanguage journal
    shown name = search "." (takeDirectory list) name >>= either (pure . Left . searchFault l) (drawnOrLoaded l)
    result outcome =
      Text.putStrLn $
        inLanguage l "comparison #" "comparaison nº " <> Text.pack (show i) <> ": " <> a <> ", " <> b <> ": " <> outcome
