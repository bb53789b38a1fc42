{-# LANGUAGE OverloadedStrings #-}

-- | What becomes of files, and of the program, when the world fails: no file is half-written, no picture is lost or
-- written over, and there is a message and exit code 3. And scenes whose values lie at the edges of what can be said:
-- each has a picture, in bounded time. (Files that fail by themselves have their own specs, in test/Dioptre/Files.)
module RobustnessSpec
  ( spec,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (concurrently)
import Control.Exception (bracket, bracket_, evaluate, try)
import Control.Monad (forM_, replicateM, void, (>=>))
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Data.Either (isRight)
import Data.List (isPrefixOf, isSuffixOf, sort)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre (checkScene, complaints, draw, fromText, parse, pictureHeight, pictureWidth)
import Dioptre.Command.Check (check)
import Dioptre.Command.Compare (compare)
import Dioptre.Command.Ends (EndedBy (..), dieOf, heedSignals, withAllPrinted)
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Heard (heard, inFolder)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.Render (Options (..), Output (..), render)
import Dioptre.Command.Run (readConfiguration, run)
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Whole (readWhole, writeWhole)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Model.Library (noModels)
import Dioptre.Picture.Png (decode)
import Dioptre.Render.Parallel (workersAmong)
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row (colourAt, plan)
import Dioptre.Source.Diagnostic (code, diagnosticProblem)
import Dioptre.Source.Language (Language (..))
import GHC.IO.Handle (hDuplicate)
import GHC.IO.Handle.FD (openFileBlocking)
import System.Directory (listDirectory, removeFile)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO (IOMode (..), hClose, hFlush, stderr, stdout, withFile)
import System.IO.Temp (withSystemTempDirectory)
import System.IO.Unsafe (unsafeInterleaveIO)
import System.Posix.Files (createNamedPipe, createSymbolicLink, setFileMode)
import System.Posix.IO (dupTo, handleToFd, stdError, stdOutput)
import System.Posix.Process (ProcessStatus (..), exitImmediately, forkProcess, getProcessStatus)
import System.Posix.Resource (Resource (ResourceFileSize, ResourceOpenFiles), ResourceLimit (..), ResourceLimits (..), setResourceLimit)
import System.Posix.Signals (Handler (..), fileSizeLimitExceeded, installHandler, sigHUP, sigINT, sigKILL, sigTERM, signalProcess)
import System.Posix.Types (ProcessID)
import System.Posix.User (getEffectiveUserID, setEffectiveUserID)
import System.Timeout (timeout)
import Test.Hspec
import Prelude hiding (compare)

spec :: Spec
spec = do
  describe "where files cannot be written" $ do
    it "a file that finds no more room on the way stays as it was" . inFolder $ do
      writeFile "p.png" "old"
      code' <- inProcess . withoutRoom 5000 $ do
        result <- writeWhole "p.png" (contents (Lazy8.replicate 100000 'x'))
        pure (if result == Right () then ExitFailure 1 else ExitSuccess)
      code' `shouldBe` Just ExitSuccess
      readFile "p.png" `shouldReturn` "old"
      listDirectory "." `shouldReturn` ["p.png"]
    it "a picture that finds no more room leaves nothing behind, and exit code 3" . inFolder $ do
      Text.writeFile "s.txt" (noisy 300)
      code' <- inProcess (withoutRoom 2000 (quietly (render' (ToFile "p.png"))))
      code' `shouldBe` Just (ExitFailure 3)
      code'' <- inProcess (withoutRoom 2000 (quietly (render' (Numbered minBound))))
      code'' `shouldBe` Just (ExitFailure 3)
      listDirectory "." `shouldReturn` ["s.txt"]
    it "a picture that no folder takes is refused before it is drawn" . inFolder $ do
      Text.writeFile "s.txt" (noisy 4000)
      Text.writeFile "configuration.cfg" (configured <> "log_file no\n")
      bracket_ (setFileMode "." 0o555) (setFileMode "." 0o755) . unprivileged $
        forM_ [render' (ToFile "p.png"), render' (Numbered minBound), runHere] $ \command -> do
          outcome <- timeout 10000000 (heard command)
          ((\(code', out, err) -> (code', out, "permission" `Text.isInfixOf` err)) <$> outcome) `shouldBe` Just (ExitFailure 3, "", True)
    it "too many open files are told as such" . inFolder $ do
      writeFile "s.txt" ""
      code' <- inProcess $ do
        setResourceLimit ResourceOpenFiles (ResourceLimits (ResourceLimit 3) (ResourceLimit 3))
        result <- readWhole "s.txt"
        pure (if result == Left (FileFault "s.txt" TooManyOpen) then ExitSuccess else ExitFailure 1)
      code' `shouldBe` Just ExitSuccess
      map (`fileFault` FileFault "s.txt" TooManyOpen) [English, French] `shouldBe` ["s.txt: too many files are open", "s.txt\xA0: trop de fichiers sont ouverts"]
    it "a full device is told as such" $
      writeWhole "/dev/full" (contents "x") `shouldReturn` Left (FileFault "/dev/full" DiskFull)
    it "a read-only folder is told, and exit code 3" . inFolder $ do
      Text.writeFile "s.txt" (noisy 4)
      setFileMode "s.txt" 0o644
      bracket_ (setFileMode "." 0o555) (setFileMode "." 0o755) . unprivileged $
        forM_ [ToFile "p.png", Numbered minBound] $ \output -> do
          (code', out, err) <- heard (render' output)
          (code', out) `shouldBe` (ExitFailure 3, "")
          err `shouldSatisfy` ("permission" `Text.isInfixOf`)
      listDirectory "." `shouldReturn` ["s.txt"]

  describe "a process that is killed" $ do
    it "while it writes leaves the file that was there, and none half-written" . inFolder $ do
      writeFile "p.png" "old"
      child <- forked $ do
        rest <- unsafeInterleaveIO (Lazy.empty <$ (writeFile "begun" "" >> threadDelay 60000000))
        void (writeWhole "p.png" (contents (Lazy8.replicate 300000 'x' <> rest)))
      within10 (waitFor "begun")
      signalProcess sigKILL child
      void (within10 (getProcessStatus True False child))
      readFile "p.png" `shouldReturn` "old"
      left <- listDirectory "."
      -- What it was writing stands beside, under a name that says so.
      filter (not . isTemporary) (sort left) `shouldBe` ["begun", "p.png"]
    it "while it counts leaves a whole configuration, whenever that is" . inFolder $ do
      Text.writeFile "s.txt" (noisy 2)
      forM_ [0, 5000 .. 60000] $ \delay -> do
        Text.writeFile "configuration.cfg" configured
        child <- forked (void (quietly runHere))
        threadDelay delay
        signalProcess sigKILL child
        void (within10 (getProcessStatus True False child))
        now <- Text.readFile "configuration.cfg"
        Text.replace "viewport_image_count" "" (Text.filter (`notElem` ("0123456789" :: String)) now) `shouldBe` Text.replace "viewport_image_count" "" (Text.filter (`notElem` ("0123456789" :: String)) configured)
        wholePictures
    forM_ [("SIGTERM", sigTERM), ("SIGHUP", sigHUP)] $ \(name, signal) ->
      it ("by " <> name <> " while it writes leaves no temporary, and is seen to have ended by it") . inFolder $ do
        writeFile "p.png" "old"
        child <- forked $ do
          heedSignals [sigTERM, sigHUP]
          rest <- unsafeInterleaveIO (Lazy.empty <$ (writeFile "begun" "" >> threadDelay 60000000))
          outcome <- try (writeWhole "p.png" (contents (Lazy8.replicate 300000 'x' <> rest)))
          either (\(EndedBy s) -> dieOf s) (const (exitImmediately ExitSuccess)) outcome
        within10 (waitFor "begun")
        signalProcess signal child
        within10 (getProcessStatus True False child) `shouldReturn` Just (Terminated signal False)
        readFile "p.png" `shouldReturn` "old"
        sort <$> listDirectory "." `shouldReturn` ["begun", "p.png"]
    it "by Ctrl-C ends within two seconds, and leaves nothing" . inFolder $ do
      Text.writeFile "s.txt" (noisy 4000)
      child <- forked $ do
        heedSignals [sigINT]
        outcome <- try (writeFile "begun" "" >> quietly (render' (ToFile "p.png")))
        either (\(EndedBy s) -> dieOf s) exitImmediately outcome
      within10 (waitFor "begun")
      threadDelay 300000
      -- And again, as people press it when they think that nothing happens.
      signalProcess sigINT child
      signalProcess sigINT child
      status <- timeout 2000000 (getProcessStatus True False child)
      status `shouldBe` Just (Just (Terminated sigINT False))
      sort <$> listDirectory "." `shouldReturn` ["begun", "s.txt"]

  describe "what is printed" $ do
    it "and finds no room is told with exit code 3, in one line" $
      forM_ [(English, "standard output: no space is left\n"), (French, "sortie standard\xA0: il ne reste plus de place\n")] $ \(l, wanted) ->
        withSystemTempDirectory "printed" $ \folder -> do
          code' <- inProcess $ do
            into "/dev/full" stdOutput
            into (folder </> "err") stdError
            withAllPrinted l (ExitSuccess <$ putStrLn "result") <* hFlush stderr
          code' `shouldBe` Just (ExitFailure 3)
          Text.readFile (folder </> "err") `shouldReturn` wanted
    it "and finds room leaves the exit code as it is" $ do
      (code', out, err) <- heard (withAllPrinted English (ExitFailure 1 <$ putStrLn "result"))
      (code', out, err) `shouldBe` (ExitFailure 1, "result\n", "")
    it "on standard error, and finds no room there, does not keep a command from its work" . inFolder $ do
      Text.writeFile "s.txt" (noisy 4)
      code' <- inProcess (into "/dev/full" stdError >> into "out" stdOutput >> withAllPrinted English (render' (ToFile "p.png")))
      code' `shouldBe` Just ExitSuccess
      Text.readFile "out" `shouldReturn` "p.png\n"

  describe "processors" $
    it "are never more than there are, and never more than 64" $
      [workersAmong present wanted | present <- [1, 8, 1000], wanted <- [Nothing, Just 1, Just 3, Just 100000000]] `shouldBe` [1, 1, 1, 1, 8, 1, 3, 8, 64, 1, 3, 64]

  describe "what never ends, or never begins" $ do
    it "is refused as a picture to compare" . inFolder $ do
      Text.writeFile "s.txt" (noisy 2)
      createNamedPipe "p.png" 0o644
      forM_ ["/dev/zero", "p.png"] $ \path -> do
        outcome <- timeout 10000000 (heard (newJournal English True >>= \j -> compare j "s.txt" path))
        ((\(code', out, err) -> (code', out, "a device or a pipe" `Text.isInfixOf` err)) <$> outcome) `shouldBe` Just (ExitFailure 3, "", True)
    it "is no picture and no model of a scene" . inFolder $ do
      createNamedPipe "p.png" 0o644
      createNamedPipe "m.obj" 0o644
      createSymbolicLink "/dev/zero" "q.png"
      Text.writeFile "s.txt" "texture_material\nname a\ntexture_kd p.png\ntexture_ka q.png\nend\nmodel\nfile m.obj\nend\n"
      outcome <- timeout 10000000 (heard (newJournal English True >>= \j -> check j AsText ["s.txt"]))
      ((\(code', out, _) -> (code', length (Text.breakOnAll "[missing-file]" out))) <$> outcome) `shouldBe` Just (ExitFailure 1, 3)
    it "is no configuration" . inFolder $ do
      createNamedPipe "configuration.cfg" 0o644
      outcome <- timeout 10000000 (heard runHere)
      ((\(code', out, err) -> (code', out, "a device or a pipe" `Text.isInfixOf` err)) <$> outcome) `shouldBe` Just (ExitFailure 3, "", True)
    it "is told as a scene to check; but a pipe that ends is a scene like any other" . inFolder $ do
      (code', _, err) <- heard (newJournal English True >>= \j -> check j AsText ["/dev/zero"])
      (code', "268435456 bytes" `Text.isInfixOf` err) `shouldBe` (ExitFailure 3, True)
      createNamedPipe "s.txt" 0o644
      ((code'', out, _), ()) <- concurrently (heard (newJournal English True >>= \j -> check j AsText ["s.txt"])) (bracket (openFileBlocking "s.txt" WriteMode) hClose (`Text.hPutStr` noisy 2))
      (code'', out) `shouldBe` (ExitSuccess, "s.txt: no faults\n")

  describe "a configuration" $ do
    it "that vanishes during the run is told with exit code 3, and the picture is kept" . inFolder $ do
      Text.writeFile "s.txt" (noisy 2)
      Text.writeFile "configuration.cfg" configured
      (code', out, err) <- heard $ do
        found <- readConfiguration
        removeFile "configuration.cfg"
        journal <- newJournal English True
        run journal found
      (code', out) `shouldBe` (ExitFailure 3, "noise_000.png\n")
      err `shouldSatisfy` ("configuration.cfg" `Text.isInfixOf`)
      wholePictures
      listDirectory "." >>= (`shouldSatisfy` notElem "configuration.cfg")
    it "that is locked is told with exit code 3, and stays as it is" . inFolder $ do
      Text.writeFile "configuration.cfg" configured
      (code', out, err) <- withFile "configuration.cfg" AppendMode (const (heard runHere))
      (code', out) `shouldBe` (ExitFailure 3, "")
      err `shouldSatisfy` ("configuration.cfg" `Text.isInfixOf`)
      Text.readFile "configuration.cfg" `shouldReturn` configured
    it "that may not be changed is told with exit code 3, and the picture is kept" . inFolder $ do
      Text.writeFile "s.txt" (noisy 2)
      Text.writeFile "configuration.cfg" configured
      setFileMode "configuration.cfg" 0o444
      setFileMode "." 0o777
      (code', out, err) <- unprivileged (heard runHere)
      (code', out) `shouldBe` (ExitFailure 3, "noise_000.png\n")
      err `shouldSatisfy` ("configuration.cfg" `Text.isInfixOf`)
      Text.readFile "configuration.cfg" `shouldReturn` configured
      wholePictures

  describe "several runs at once in one folder" $
    it "have a picture each, whole, and leave a whole configuration" . inFolder $ do
      Text.writeFile "s.txt" (noisy 3)
      Text.writeFile "configuration.cfg" configured
      children <- replicateM 6 (forked (quietly runHere >>= exitImmediately))
      statuses <- mapM (within10 . getProcessStatus True False) children
      statuses `shouldBe` replicate 6 (Just (Exited ExitSuccess))
      files <- listDirectory "."
      sort (filter (".png" `isSuffixOf`) files) `shouldBe` ["noise_00" <> show n <> ".png" | n <- [0 .. 5 :: Int]]
      filter isTemporary files `shouldBe` []
      wholePictures
      counted <- Text.readFile "configuration.cfg"
      -- The next number is free, or one that is taken and passed over; the rest is as it was.
      Text.unlines (filter (not . Text.isPrefixOf "viewport_image_count") (Text.lines counted)) `shouldBe` Text.unlines (filter (not . Text.isPrefixOf "viewport_image_count") (Text.lines configured))

  describe "values at the edges" $
    forM_ edges $ \(name, told, lines') ->
      it (name <> ": a picture, in bounded time") $ do
        let source = fromText "s.txt" (Text.unlines lines')
        map (code . diagnosticProblem) (complaints source) `shouldBe` told
        drawn <- timeout 20000000 (evaluate (draw source))
        ((\p -> (pictureWidth p, pictureHeight p)) <$> drawn) `shouldSatisfy` (`elem` [Just (1, 1), Just (3, 2)])
        -- Colours before they become bytes.
        let p = plan Map.empty noModels (fst (checkScene (parse source)))
            Seen (Colour r g b a) _ = colourAt p 0 0
        [x | x <- [r, g, b, a], isNaN x || isInfinite x || x < 0] `shouldBe` []

  describe "pictures at the edges" $ do
    it "of no size have the default's, and it is told" $
      forM_ ["width 0", "height 0", "width -1"] $ \line ->
        map (code . diagnosticProblem) (complaints (fromText "s" (Text.unlines ["viewport", line, "end"]))) `shouldBe` ["out-of-range"]
    it "beyond 16384 x 16384 are refused before any work" . inFolder $ do
      Text.writeFile "s.txt" "viewport\nwidth 16385\nheight 16384\nend\n"
      map (code . diagnosticProblem) (complaints (fromText "s" "viewport\nwidth 16385\nheight 16384\nend\n")) `shouldBe` ["too-many-pixels"]
      (code', _, err) <- heard (newJournal English True >>= (`render` (options (ToFile "p.png")) {optionWidth = Just 16385, optionHeight = Just 16384}))
      code' `shouldBe` ExitFailure 2
      err `shouldSatisfy` ("268435456" `Text.isInfixOf`)
      listDirectory "." `shouldReturn` ["s.txt"]
  where
    render' output = newJournal English True >>= (`render` options output)
    options output = Options "s.txt" output Nothing Nothing Nothing Nothing False
    runHere = newJournal English True >>= \j -> readConfiguration >>= run j
    quietly work = (\(result, _, _) -> result) <$> heard work
    -- A standard stream goes there from now on, as after a redirection by a shell.
    into path descriptor = withFile path AppendMode (\h -> hDuplicate h >>= handleToFd >>= void . (`dupTo` descriptor))

-- | Scenes that are hard in one way each: what it is, the codes of what is told of it, and its lines.
edges :: [(String, [Text], [Text])]
edges =
  [ ("numbers of 1e100", [], small <> ["camera", "position 0 0 -1e100", "look_at 0 0 0", "far_clipping_plane 1e100", "end"] <> ball ["position 0 0 0", "ray 1e99"] <> lamp ["position 0 1e100 -1e100"]),
    ("numbers of 1e-100 and denormals", [], small <> ball ["position 1e-100 4.9e-324 4", "ray 1"] <> lamp ["position 1e-320 1e-100 -1e-100"]),
    ("colours and factors that multiply beyond all numbers", [], bare <> ball ["position 0 0 4", "ray 3"] <> ["material", "name a", "color 1e100 0 1e100", "kt 1", "kd 1", "end"] <> lamp ["color 1e100 1e100 0", "amplification 1e100", "constant_attenuator 1e-10"]),
    ("identical points", ["same-point", "collinear-points"], small <> shape "tube" ["point 1 2 3", "point 1 2 3"] <> shape "triangle" ["point 1 1 1", "point 1 1 1", "point 1 1 1"]),
    ("sizes of zero", ["out-of-range", "out-of-range", "zero-component"], small <> ball ["ray 0"] <> shape "cube" ["size 0"] <> ["primitive", "material_name a", "geometry", "scale 0 1 1", "sphere", "end", "end", "end"]),
    ("a camera inside everything", [], small <> concat [ball ["position 0 0 0", "ray " <> Text.pack (show n)] | n <- [1 .. 50 :: Int]] <> lamp []),
    ("100,000 lights", [], one <> ball ["position 0 0 4", "ray 3"] <> concat (replicate 100000 ["point_light", "end"])),
    ("mirrors around the camera, a million bounces deep", [], bare <> ["raytracer", "recursive_level 1000000", "end"] <> ball ["position 0 0 0", "ray 5"] <> ["material", "name a", "kr 1", "kt 1", "refractive_index 1.5", "end"] <> lamp []),
    ("10,000 objects in one another", [], one <> ["primitive", "material_name a"] <> concat (replicate 10000 ["geometry", "rotation 1 2 3"]) <> ["sphere", "position 0 0 4", "ray 3", "end"] <> replicate 10000 "end" <> ["end"] <> lamp []),
    ("10,000 objects that nobody knows in one another", ["unknown-word"], one <> replicate 10000 "nobody" <> replicate 10000 "end"),
    ("a picture of one pixel", [], one <> ball ["position 0 0 4"]),
    ("a million samples", [], one <> ["raytracer", "sampling 1000000", "pixel_coordinate random", "end"] <> ball ["position 0 0 4"])
  ]
  where
    one = ["viewport", "width 1", "height 1", "end"] <> paint
    small = bare <> paint
    bare = ["viewport", "width 3", "height 2", "end"]
    paint = ["material", "name a", "end"]
    shape :: Text -> [Text] -> [Text]
    shape word properties = ["primitive", "material_name a", word] <> properties <> ["end", "end"]
    ball = shape "sphere"
    lamp properties = ["point_light"] <> properties <> ["end"]

-- | A scene of so many pixels squared whose picture cannot be compressed much, and takes a while when it is large.
noisy :: Int -> Text
noisy size =
  Text.unlines
    ["viewport", "width " <> number, "height " <> number, "image_file_name noise", "end", "raytracer", "pixel_coordinate random", "sampling 4", "end"]
    <> Text.unlines (concat [["primitive", "material_name a", "sphere", "position " <> Text.unwords (map (Text.pack . show) [x, y, 3 :: Double]), "ray 0.02", "end", "end"] | x <- [-1, -0.9 .. 1], y <- [-1, -0.9 .. 1]])
    <> Text.unlines ["material", "name a", "color 1 0.5 0.2", "end", "point_light", "position 1 1 0", "end"]
  where
    number = Text.pack (show size)

configured :: Text
configured = "application console\nread_data s.txt\nwrite_data out.txt\nviewport_image_count 0\n"

-- | Every picture in the working directory can be read.
wholePictures :: IO ()
wholePictures = do
  files <- filter (".png" `isSuffixOf`) <$> listDirectory "."
  forM_ files (Bytes.readFile >=> (`shouldSatisfy` (isRight . decode)))

isTemporary :: FilePath -> Bool
isTemporary = (".dioptre" `isPrefixOf`)

-- | Works in a process of its own; the exit code, or nothing if it takes more than ten seconds.
inProcess :: IO ExitCode -> IO (Maybe ExitCode)
inProcess work = do
  child <- forked (work >>= exitImmediately)
  status <- within10 (getProcessStatus True False child)
  pure $ case status of
    Just (Exited c) -> Just c
    _ -> Nothing

-- | A process of its own. What is still to be printed is printed before, so that it is not printed by both.
forked :: IO () -> IO ProcessID
forked work = hFlush stdout >> hFlush stderr >> forkProcess work

-- | Works where no file can be longer than so many bytes, as on a disk that fills up.
withoutRoom :: Integer -> IO a -> IO a
withoutRoom bytes work = do
  void (installHandler fileSizeLimitExceeded Ignore Nothing)
  setResourceLimit ResourceFileSize (ResourceLimits (ResourceLimit bytes) (ResourceLimit bytes))
  work

within10 :: IO a -> IO a
within10 work = timeout 10000000 work >>= maybe (ioError (userError "this took more than ten seconds")) pure

-- | Waits until there is a file of that name.
waitFor :: FilePath -> IO ()
waitFor name = do
  files <- listDirectory "."
  if name `elem` files then pure () else threadDelay 10000 >> waitFor name

-- | Does without the rights of the superuser, to whom nothing is forbidden.
unprivileged :: IO a -> IO a
unprivileged action = do
  user <- getEffectiveUserID
  if user == 0 then bracket_ (setEffectiveUserID 65534) (setEffectiveUserID 0) action else action
