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
import Control.Monad (forM, when)
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef (IORef, modifyIORef', newIORef, readIORef)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Browser (opener)
import Dioptre.Command.Compare (verdict)
import Dioptre.Command.Info (info)
import Dioptre.Command.Journal (Journal, journalLanguage, sayDiagnostics, sayFault, sayText, speakingIf, written)
import Dioptre.Command.Trace (Traced (..), sayBlack, sayCut, timed, traced)
import Dioptre.Command.View (ViewOptions (..), awaitDeparture, awaitPicture, builtIn, viewing)
import Dioptre.Command.Wording (extent, modelRead, seconds, statistics)
import Dioptre.Files.Contents (Contents, contents)
import Dioptre.Files.Counter (replaceCounter)
import Dioptre.Files.Fault (FileFault (..), Reason (DoesNotExist))
import Dioptre.Files.Identity (sameFile)
import Dioptre.Files.Number (PictureNumber, next, numberingObstacle, pictureNumber, writeNumbered)
import Dioptre.Files.Search (search)
import Dioptre.Files.Whole (readPlain, writeWhole)
import Dioptre.Files.Wording (fileFault, numberingFault, searchFault)
import Dioptre.Load (Loaded (..), drawnOrLoaded, loadSource, loadedFiles, loadedPlan, sceneText)
import Dioptre.Picture (Difference (Equal), difference)
import Dioptre.Picture.Png (encode)
import Dioptre.Render.Row (planExtent)
import Dioptre.Render.Tally (Tally (..))
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
import System.Directory (doesFileExist, getCurrentDirectory)
import System.Exit (ExitCode (..))
import System.FilePath (takeDirectory)
import System.IO (hFlush, stdout)

-- | The configuration in the working directory, with its text and what there is to say of it; or why there is none.
readConfiguration :: IO (Either FileFault (Source, Configuration, [Diagnostic]))
readConfiguration = fmap (understood . decode configurationFile) <$> readPlain configurationFile
  where
    understood source = let (configuration, diagnostics) = checkConfiguration (parse source) in (source, configuration, diagnostics)

-- | Runs what the configuration says. Without one, tells what there is to know and writes one. Exit codes as in the
-- README.
--
-- Spec: config.missing.
run :: Journal -> Either FileFault (Source, Configuration, [Diagnostic]) -> IO ExitCode
run journal found = case found of
  Left (FileFault _ DoesNotExist) -> do
    Text.putStr (info l)
    code <- whole journal configurationFile startingConfiguration
    told journal code $ do
      here <- getCurrentDirectory
      pure $
        inLanguage l "configuration.cfg was written to " "configuration.cfg a été écrit dans " <> Text.pack here
          <> inLanguage
            l
            ": it says what dioptre does without a command; with 'application console' it draws the scene that read_data names"
            "\xA0: il dit ce que fait dioptre sans commande\xA0; avec 'application console', il dessine la scène que nomme read_data"
  Left fault -> ExitFailure 3 <$ sayFault journal (fileFault l fault)
  Right (source, configuration, diagnostics) -> do
    let spoken = speakingIf (configurationLogConsole configuration) journal
    sayDiagnostics spoken [(source, diagnostics)]
    inputs <- newIORef [configurationFile]
    logged spoken inputs configuration (apply spoken inputs configuration)
  where
    l = journalLanguage journal

-- | The files that were read so far, over which nothing is written.
type Inputs = IORef [FilePath]

-- | Notes that files are read.
noteRead :: Inputs -> [FilePath] -> IO ()
noteRead inputs files = modifyIORef' inputs (files <>)

-- | Runs some work, and writes the log whatever becomes of it.
logged :: Journal -> Inputs -> Configuration -> IO ExitCode -> IO ExitCode
logged journal inputs configuration work
  | not (configurationLogFile configuration) = work
  | otherwise = worse <$> (work `onException` writeLog) <*> writeLog
  where
    writeLog = written journal >>= saved journal inputs (Text.unpack (configurationLogName configuration))

-- | The exit code of two things done one after the other: the first that is not success.
--
-- Spec: cli.exit.
worse :: ExitCode -> ExitCode -> ExitCode
worse ExitSuccess code = code
worse code _ = code

-- | Runs the application.
--
-- Spec: config.application.
apply :: Journal -> Inputs -> Configuration -> IO ExitCode
apply journal inputs configuration = case configurationApplication configuration of
  RunNothing -> ExitSuccess <$ sayText journal (inLanguage l "configuration.cfg runs no application" "configuration.cfg ne lance aucune application")
  RunInfo -> Text.putStr (info l) >> writeDefaultScene journal
  RunConsole -> draw journal inputs configuration
  RunFrame -> frame journal inputs configuration
  RunComparator -> compareAll journal inputs configuration
  where
    l = journalLanguage journal

-- | Writes the built-in scene to a file that can be changed and read under another name; never over one that is there.
writeDefaultScene :: Journal -> IO ExitCode
writeDefaultScene journal = do
  there <- doesFileExist (Text.unpack defaultSceneFile)
  if there
    then pure ExitSuccess
    else do
      outcome <- whole journal (Text.unpack defaultSceneFile) defaultScene
      told journal outcome . pure $
        inLanguage
          l
          (defaultSceneFile <> " was written: the built-in scene, to be changed under another name")
          (defaultSceneFile <> " a été écrit\xA0: la scène intégrée, à modifier sous un autre nom")
  where
    l = journalLanguage journal

-- | Tells something, if it was done.
told :: Journal -> ExitCode -> IO Text -> IO ExitCode
told journal code text = code <$ when (code == ExitSuccess) (text >>= sayText journal)

-- | Writes a text, whole. A failure is told, and is exit code 3.
whole :: Journal -> FilePath -> Text -> IO ExitCode
whole journal path text = writeWhole path (contents (Lazy.fromStrict (Text.encodeUtf8 text))) >>= either (failed journal . fileFault (journalLanguage journal)) (const (pure ExitSuccess))

-- | The same, but not over a file that was read, by whatever path.
--
-- Spec: run.outputs.
saved :: Journal -> Inputs -> FilePath -> Text -> IO ExitCode
saved journal inputs path text =
  readIORef inputs >>= sameFile path >>= \case
    Just file -> failed journal (isInput file)
    Nothing -> whole journal path text
  where
    l = journalLanguage journal
    isInput file =
      Text.concat
        [ Text.pack path,
          inLanguage l ": this is a file that was read" "\xA0: c'est un fichier qui a été lu",
          if file == path then "" else " (" <> Text.pack file <> ")",
          inLanguage l "; it stays as it is" "\xA0; il reste comme il est"
        ]

failed :: Journal -> Text -> IO ExitCode
failed journal fault = ExitFailure 3 <$ sayFault journal fault

-- | Draws the scene: reads it, traces it, writes the picture, counts it, and writes the scene back.
--
-- Spec: run.outputs.
draw :: Journal -> Inputs -> Configuration -> IO ExitCode
draw journal inputs configuration = withSource journal inputs configuration $ \(source, _) -> do
  (reading, loaded) <- timed (loadSource l source)
  noteRead inputs (loadedFiles loaded)
  sayScene journal loaded (inLanguage l "; read in " "\xA0; lue en " <> seconds reading)
  -- What would keep the picture from being written is found before it is drawn.
  obstacle <- numberingObstacle "." (viewportImage (sceneViewport (loadedScene loaded))) (firstNumber configuration)
  maybe (drawn loaded) (failed journal . numberingFault l) obstacle
  where
    l = journalLanguage journal
    drawn loaded = do
      let planned = loadedPlan loaded
      (indexing, size) <- timed (evaluate (planExtent planned))
      sayText journal (extent l size <> inLanguage l "; built in " "\xA0; construit en " <> seconds indexing)
      sayBlack journal (loadedScene loaded) size
      leave journal inputs configuration (loadedScene loaded) (traced journal planned)

-- | Shows the scene in the browser while it is drawn, and leaves the same as soon as it is; ends when its page is
-- closed. What it leaves is the first picture that is finished: of the scene as it was changed, if somebody changed it
-- before. A picture that is too large for the page is drawn without it. Where no browser can be opened, as without a
-- screen, nobody would close the page: the scene is drawn as by console.
frame :: Journal -> Inputs -> Configuration -> IO ExitCode
frame journal inputs configuration =
  opener >>= \case
    Just _ -> framed journal inputs configuration
    Nothing -> do
      sayText journal $
        inLanguage
          l
          "no browser can be opened here: the picture is drawn without its page, as by the application console; 'dioptre view' shows a scene at an address, for a browser elsewhere too"
          "aucun navigateur ne peut s'ouvrir ici\xA0: l'image est dessinée sans sa page, comme par l'application console\xA0; 'dioptre view' montre une scène à une adresse, à un navigateur ouvert ailleurs aussi"
      draw journal inputs configuration
  where
    l = journalLanguage journal

framed :: Journal -> Inputs -> Configuration -> IO ExitCode
framed journal inputs configuration = withSource journal inputs configuration $ \scene ->
  viewing journal (ViewOptions Nothing True) True scene $ \viewer ->
    awaitPicture viewer >>= \case
      Nothing -> draw journal inputs configuration
      Just shown -> do
        let loaded = frameLoaded shown
        noteRead inputs (loadedFiles loaded)
        sayScene journal loaded ""
        sayText journal (extent l (planExtent (framePlan shown)))
        progress <- readTVarIO (frameProgress shown)
        image <- framePicture shown
        code <- leave journal inputs configuration (loadedScene loaded) $ \put ->
          Traced (progressTally progress) (progressSeconds progress) . fst <$> timed (contents (encode image) put)
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

-- | Leaves what an application leaves of a scene and its picture: the picture, its number, and the scene.
leave :: Journal -> Inputs -> Configuration -> Scene -> Contents Traced -> IO ExitCode
leave journal inputs configuration scene image = do
  outcome <- writeNumbered "." (viewportImage (sceneViewport scene)) (firstNumber configuration) image
  case outcome of
    Left fault -> failed journal (numberingFault l fault)
    Right ((path, used), Traced tally tracing writing) -> do
      sayText journal (inLanguage l "traced in " "tracée en " <> seconds tracing <> inLanguage l ": " "\xA0: " <> statistics l (tallyRays tally) (tallyTests tally))
      sayCut journal tally
      sayText journal (inLanguage l "picture '" "image '" <> Text.pack path <> inLanguage l "' written in " "' écrite en " <> seconds writing)
      Text.putStrLn (Text.pack path)
      hFlush stdout
      worse <$> count journal (next used) <*> saved journal inputs (Text.unpack (configurationWrite configuration)) (writeScene scene)
  where
    l = journalLanguage journal

-- | Does some work with the text of the scene that the configuration names, and whether its name is the path of a file:
-- the built-in one, or one that is looked for.
--
-- Spec: run.search.
withSource :: Journal -> Inputs -> Configuration -> ((Source, Bool) -> IO ExitCode) -> IO ExitCode
withSource journal inputs configuration act = do
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
          Right path -> noteRead inputs [path] >> either (Left . fileFault l) (\text -> Right (text, True)) . (>>= sceneText path) <$> readPlain path

-- | The number that the configuration wants the next picture to have.
--
-- Spec: files.number.start.
firstNumber :: Configuration -> PictureNumber
firstNumber = fromMaybe minBound . pictureNumber . configurationImageCount

-- | Puts the next picture's number into the configuration, as it is now on the disk, and changes nothing else in it.
--
-- Spec: config.counter.
count :: Journal -> PictureNumber -> IO ExitCode
count journal following =
  readPlain configurationFile
    >>= either (pure . Left) (writeWhole configurationFile . contents . Lazy.fromStrict . replaceCounter following)
    >>= either (failed journal . fileFault (journalLanguage journal)) (const (pure ExitSuccess))

-- | Compares the pairs of a list, prints how each differs, and writes the list back. Exit code 1 if any does.
--
-- Spec: compare.run.
compareAll :: Journal -> Inputs -> Configuration -> IO ExitCode
compareAll journal inputs configuration = do
  found <- search "." "." (configurationRead configuration)
  case found of
    Left fault -> failed journal (searchFault l fault)
    Right path -> do
      noteRead inputs [path]
      readPlain path >>= \bytes -> case decode path <$> bytes of
        Left fault -> failed journal (fileFault l fault)
        Right source -> do
          let (pairs, diagnostics) = checkComparisons (parse source)
          sayDiagnostics journal [(source, diagnostics)]
          codes <- forM (zip [1 :: Int ..] pairs) $ uncurry (comparePair journal inputs path)
          code <- saved journal inputs (Text.unpack (configurationWrite configuration)) (writeComparisons pairs)
          pure (maximum (code : codes))
  where
    l = journalLanguage journal

-- Spec: compare.run.
comparePair :: Journal -> Inputs -> FilePath -> Int -> (Text, Text) -> IO ExitCode
comparePair journal inputs list i (a, b) = do
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
    shown name = search "." (takeDirectory list) name >>= either (pure . Left . searchFault l) had
    had path = do
      outcome <- drawnOrLoaded l path
      outcome <$ noteRead inputs (path : [file | Right (_, Just scene) <- [outcome], file <- loadedFiles scene])
    result outcome =
      Text.putStrLn $
        inLanguage l "comparison #" "comparaison nº " <> Text.pack (show i) <> inLanguage l ": " "\xA0: " <> a <> ", " <> b <> ": " <> outcome
