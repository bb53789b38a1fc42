{-# LANGUAGE OverloadedStrings #-}

-- | The commands as their users meet them: what is printed where, what is written, and the exit code.
module Dioptre.Command.CommandSpec
  ( spec,
  )
where

import Control.Exception (bracket)
import Control.Monad (forM_)
import Data.Aeson (Value (..), decode)
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (sort)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Check (check)
import Dioptre.Command.Compare (compare)
import Dioptre.Command.Explain (explain)
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Heard (heard, inFolder, listeningTo)
import Dioptre.Command.Info (info)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.Render (Options (..), Output (..), render)
import Dioptre.Command.Run (readConfiguration, run)
import Dioptre.Command.View (ViewOptions (..), viewScene)
import Dioptre.Source.Language (Language (..))
import Dioptre.Syntax.Keyword (allSpellings)
import qualified Network.WebSockets as WebSockets
import System.Directory (createDirectory, createFileLink, doesFileExist, getCurrentDirectory, listDirectory, removeFile)
import System.Environment (lookupEnv, setEnv, unsetEnv)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Posix.Files (createLink, setFileMode)
import System.Timeout (timeout)
import Test.Hspec (Spec, describe, it, shouldBe, shouldContain, shouldNotBe, shouldReturn)
import Prelude hiding (compare)

spec :: Spec
spec = do
  describe "render" $ do
    it "writes the first free number and prints its path, one line, on standard output" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      (code, out, _) <- heard (render' plainOptions)
      (code', out', _) <- heard (render' plainOptions)
      (code, out, code', out') `shouldBe` (ExitSuccess, "ball_000.png\n", ExitSuccess, "ball_001.png\n")
      files <- listDirectory "."
      sort files `shouldBe` ["ball_000.png", "ball_001.png", "s.txt"]
    it "writes exactly where -o says, and replaces what is there" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "p.png" "old"
      (code, out, _) <- heard (render' plainOptions {optionOutput = ToFile "p.png"})
      (code, out) `shouldBe` (ExitSuccess, "p.png\n")
      Bytes.readFile "p.png" >>= (`shouldBe` "\x89PNG") . Bytes.take 4
    it "says that a picture is a PNG where its name says otherwise" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      (code, out, err) <- heard (render' plainOptions {optionOutput = ToFile "p.jpg"})
      (code, out) `shouldBe` (ExitSuccess, "p.jpg\n")
      err `shouldContainText` "remark: p.jpg is a PNG in spite of its name"
      (_, _, err') <- heard (render' plainOptions {optionOutput = ToFile "p.PNG"})
      ("PNG" `Text.isInfixOf` err') `shouldBe` False
    it "refuses to replace the scene by its picture" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      (code, _, _) <- heard (render' plainOptions {optionOutput = ToFile "./s.txt"})
      code `shouldBe` ExitFailure 2
      Text.readFile "s.txt" >>= (`shouldBe` sphereScene)
    it "refuses to replace a file that the scene reads, by whatever path, and the configuration" . inFolder $ do
      writeScenery
      Text.writeFile "configuration.cfg" "application none\n"
      createFileLink "models/b.obj" "link.png"
      createLink "a.png" "hard.png"
      createFileLink "s.txt" "scene.png"
      before <- traverse Bytes.readFile scenery
      forM_ (map ("./" <>) scenery <> ["models/../a.png", "link.png", "hard.png", "scene.png", "configuration.cfg"]) $ \path -> do
        (code, out, err) <- heard (render' plainOptions {optionOutput = ToFile path})
        (path, code, out) `shouldBe` (path, ExitFailure 2, "")
        err `shouldContainText` "the picture would replace"
      traverse Bytes.readFile scenery >>= (`shouldBe` before)
      Text.readFile "configuration.cfg" >>= (`shouldBe` "application none\n")
      -- A picture beside them that nobody reads gives way.
      Text.writeFile "p.png" "old"
      (code, out, _) <- heard (render' plainOptions {optionOutput = ToFile "p.png"})
      (code, out) `shouldBe` (ExitSuccess, "p.png\n")
    it "says in both languages which file it would replace" . inFolder $ do
      writeScenery
      (_, _, err) <- heard (render' plainOptions {optionOutput = ToFile "./a.png"})
      err `shouldContainText` "the picture would replace a file that the scene reads: a.png"
      (_, _, err') <- heard (newJournal French True >>= (`render` plainOptions {optionOutput = ToFile "./a.png"}))
      err' `shouldContainText` "l'image remplacerait un fichier que la sc\xE8ne lit\xA0: a.png"
    it "draws a faulty scene all the same, and says what is wrong on standard error" . inFolder $ do
      Text.writeFile "s.txt" (Text.replace "ray 1.0" "ray 1.O" sphereScene)
      (code, out, err) <- heard (render' plainOptions)
      (code, out) `shouldBe` (ExitSuccess, "ball_000.png\n")
      err `shouldContainText` "s.txt:13:5: error: '1.O' is not a number  [not-a-number]"
    it "draws nothing under --strict" . inFolder $ do
      Text.writeFile "s.txt" (Text.replace "ray 1.0" "ray 1.O" sphereScene)
      (code, out, _) <- heard (render' plainOptions {optionStrict = True})
      (code, out) `shouldBe` (ExitFailure 1, "")
      listDirectory "." >>= (`shouldBe` ["s.txt"])
    it "says under --strict --quiet what is to be mended, and no notes" . inFolder $ do
      -- A second camera in the place of the first is a note.
      Text.writeFile "s.txt" (Text.replace "ray 1.0" "ray 1.O" sphereScene <> "camera\nend\ncamera\nend\n")
      (_, _, all') <- heard (render' plainOptions)
      all' `shouldContainText` "note: "
      (code, out, err) <- heard (newJournal English False >>= (`render` plainOptions {optionStrict = True}))
      (code, out) `shouldBe` (ExitFailure 1, "")
      forM_ ["s.txt:13:5: error: '1.O' is not a number  [not-a-number]", "1 error", "nothing is drawn, as --strict asks"] (err `shouldContainText`)
      ("note" `Text.isInfixOf` err) `shouldBe` False
      (code', _, err') <- heard (newJournal English False >>= (`render` plainOptions))
      (code', err') `shouldBe` (ExitSuccess, "")
    it "draws nothing under --strict where a model has faults, and all the same without" . inFolder $ do
      Text.writeFile "s.txt" (sphereScene <> "model\nfile a.msr\nend\n")
      Text.writeFile "a.msr" "camera\nend\n"
      (code, out, err) <- heard (render' plainOptions {optionStrict = True})
      (code, out) `shouldBe` (ExitFailure 1, "")
      err `shouldContainText` "a.msr:1:1: error: 'camera' cannot stand here"
      (code', out', _) <- heard (render' plainOptions)
      (code', out') `shouldBe` (ExitSuccess, "ball_000.png\n")
    it "exits with 3 where the scene or the folder of the picture is not there" . inFolder $ do
      (code, out, err) <- heard (render' plainOptions)
      (code, out) `shouldBe` (ExitFailure 3, "")
      err `shouldContainText` "s.txt"
      Text.writeFile "s.txt" sphereScene
      (code', _, err') <- heard (render' plainOptions {optionOutput = ToFile "nowhere/p.png"})
      code' `shouldBe` ExitFailure 3
      err' `shouldContainText` "nowhere"
    it "says before it draws that a picture will be black, of a scene without shapes or without light" . inFolder $ do
      let remarkOf l text = do
            Text.writeFile "b.txt" (text <> "viewport\nwidth 2\nheight 2\nend\n")
            (code, _, err) <- heard (newJournal l True >>= (`render` plainOptions {optionScene = "b.txt", optionOutput = ToFile "b.png"}))
            code `shouldBe` ExitSuccess
            pure [line | line <- Text.lines err, any (`Text.isPrefixOf` line) ["remark", "remarque"]]
          dark = "primitive\nmaterial_name m\nsphere\nend\nend\nmaterial\nname m\nend\n"
      remarkOf English "" `shouldReturn` ["remark: the picture is black: the scene has no shape"]
      remarkOf French "" `shouldReturn` ["remarque\xA0: l'image est noire\xA0: la scène n'a aucune forme"]
      remarkOf English dark `shouldReturn` ["remark: the picture is black: the scene has no light (reflexion_algorithm no_light would show its colours without one)"]
      remarkOf English (dark <> "raytracer\nreflexion_algorithm no_light\nend\n") `shouldReturn` []
      remarkOf English (dark <> "point_light\nend\n") `shouldReturn` []
    it "crops to the pixels of the whole picture" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      _ <- heard (render' plainOptions {optionOutput = ToFile "whole.png"})
      _ <- heard (render' plainOptions {optionOutput = ToFile "part.png", optionCrop = Just (0, 0, 20, 16)})
      (code, out, _) <- heard (journal' (\j -> compare j "whole.png" "part.png"))
      (code, out) `shouldBe` (ExitSuccess, "20 x 16 pixels, equal\n")
      (code', _, _) <- heard (render' plainOptions {optionCrop = Just (10, 0, 11, 16)})
      code' `shouldBe` ExitFailure 2
    it "says in both languages that a size has too many pixels, of one option and of two" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      let asking l w h = heard (newJournal l True >>= (`render` plainOptions {optionWidth = w, optionHeight = h}))
          many' = Just 20000
      asking English many' many'
        >>= (`shouldBe` (ExitFailure 2, "", "--width and --height ask for 20000 x 20000 pixels, more than the 268435456 that a picture may have\n"))
      asking English (Just 200000000) Nothing
        >>= (`shouldBe` (ExitFailure 2, "", "--width asks for 200000000 x 16 pixels, more than the 268435456 that a picture may have\n"))
      asking French many' many'
        >>= (`shouldBe` (ExitFailure 2, "", "--width et --height demandent 20000 x 20000 pixels, plus que les 268435456 qu'une image peut avoir\n"))
      asking French Nothing (Just 200000000)
        >>= (`shouldBe` (ExitFailure 2, "", "--height demande 20 x 200000000 pixels, plus que les 268435456 qu'une image peut avoir\n"))
  describe "check" $ do
    it "says nothing is wrong, and exits with 0" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      heard (journal' (\j -> check j AsText ["s.txt"])) >>= (`shouldBe` (ExitSuccess, "s.txt: no faults\n", ""))
    it "exits with 1 for faults, with 3 for a file that is not there, and 3 beats 1" . inFolder $ do
      Text.writeFile "s.txt" "camara\n"
      (code, _, _) <- heard (journal' (\j -> check j AsText ["s.txt"]))
      (code', _, _) <- heard (journal' (\j -> check j AsText ["s.txt", "t.txt"]))
      (code, code') `shouldBe` (ExitFailure 1, ExitFailure 3)
    it "prints one JSON object with the agreed fields" . inFolder $ do
      Text.writeFile "s.txt" "viewport\n\twidht 3\nend\n"
      (code, out, _) <- heard (journal' (\j -> check j AsJson ["s.txt"]))
      code `shouldBe` ExitFailure 1
      case decode (Lazy.fromStrict (Text.encodeUtf8 out)) of
        Just (Object o)
          | Just (Array ds) <- Keys.lookup "diagnostics" o,
            [Object d] <- toList ds -> do
            sort (Keys.keys d) `shouldBe` ["code", "column", "endColumn", "expected", "file", "line", "message", "severity", "used"]
            [Keys.lookup k d | k <- ["file", "code", "severity", "line", "column", "endColumn"]]
              `shouldBe` map Just [String "s.txt", String "unknown-word", String "error", Number 2, Number 2, Number 7]
        other -> fail (show other)
    it "reports pictures that are missing" . inFolder $ do
      Text.writeFile "s.txt" "texture_material\nname a\ntexture_kd no.png\nend\n"
      (code, out, _) <- heard (journal' (\j -> check j AsText ["s.txt"]))
      code `shouldBe` ExitFailure 1
      out `shouldContainText` "s.txt:3:12: error: no file is called 'no.png'"
    it "tells what is wrong with models under the names of their files" . inFolder $ do
      Text.writeFile "s.txt" "model\nfile a.obj\nend\n"
      Text.writeFile "a.obj" "v 0 0 0\nv 1 O 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\n"
      (code, out, _) <- heard (journal' (\j -> check j AsText ["s.txt"]))
      code `shouldBe` ExitFailure 1
      out `shouldContainText` "s.txt: no faults\na.obj:2:5: error: 'O' is not a number"
      (code', out', _) <- heard (journal' (\j -> check j AsJson ["s.txt"]))
      code' `shouldBe` ExitFailure 1
      case decode (Lazy.fromStrict (Text.encodeUtf8 out')) of
        Just (Object o)
          | Just (Array ds) <- Keys.lookup "diagnostics" o,
            [Object d] <- toList ds ->
            [Keys.lookup k d | k <- ["file", "line", "column"]] `shouldBe` map Just [String "a.obj", Number 2, Number 5]
        other -> fail (show other)
  describe "compare" $
    it "tells size, number, largest difference and first place" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "t.txt" (Text.replace "color 1.0 0.0 0.0" "color 0.5 0.0 0.0" sphereScene)
      (code, out, _) <- heard (journal' (\j -> compare j "s.txt" "t.txt"))
      code `shouldBe` ExitFailure 1
      -- The ball is red with kd 1: 255 against level 128, a difference of 127.
      out `shouldContainText` "20 x 16 pixels, different: "
      out `shouldContainText` "by at most 127"
  describe "info" $ do
    it "tells of each application what the runs below see it do" $
      forM_
        [ (English, ["nothing", "this page", "draws the scene", "in the browser", "compares"]),
          (French, ["rien", "cette page", "dessine la scène", "dans le navigateur", "compare"])
        ]
        $ \(l, deeds) -> do
          -- Their lines stand between the second heading and an empty line.
          let told = takeWhile (not . Text.null) (drop 3 (Text.lines (info l)))
          map (take 1 . Text.words) told `shouldBe` map pure ["none", "info", "console", "frame", "comparator"]
          [(line, deed) | (line, deed) <- zip told deeds, not (deed `Text.isInfixOf` line)] `shouldBe` []
    it "knows every word of the language that objects use" $ do
      let words' = Text.words (Text.replace "," " " (info English))
      [s | s <- allSpellings, s `notElem` words', s `notElem` unused] `shouldBe` []
  describe "the run without arguments" $ do
    it "writes a configuration where there is none" . inFolder $ do
      (code, out, err) <- heard runHere
      code `shouldBe` ExitSuccess
      out `shouldContainText` "configuration.cfg"
      doesFileExist "configuration.cfg" >>= (`shouldBe` True)
      here <- Text.pack <$> getCurrentDirectory
      Text.lines err
        `shouldBe` ["configuration.cfg was written to " <> here <> ": it says what dioptre does without a command; with 'application console' it draws the scene that read_data names"]
      (code', _, err') <- heard runHere
      (code', err') `shouldBe` (ExitSuccess, "default_scene.txt was written: the built-in scene, to be changed under another name\n")
      heard runHere >>= \(code'', _, err'') -> (code'', err'') `shouldBe` (ExitSuccess, "")
    it "says in French, too, what it writes, and nothing where it is to be quiet" . inFolder $ do
      let runIn l loud = heard (newJournal l loud >>= \j -> readConfiguration >>= run j) >>= \(_, _, err) -> pure err
      runIn French True >>= (`shouldContainText` "\xA0: il dit ce que fait dioptre sans commande\xA0; avec 'application console', il dessine la sc\xE8ne que nomme read_data\n")
      runIn French True >>= (`shouldBe` "default_scene.txt a \xE9t\xE9 \xE9\&crit\xA0: la sc\xE8ne int\xE9gr\xE9\&e, \xE0 modifier sous un autre nom\n")
      mapM_ removeFile ["configuration.cfg", "default_scene.txt"]
      runIn English False >>= (`shouldBe` "")
      runIn English False >>= (`shouldBe` "")
    it "draws, counts, logs, and writes the scene back" . inFolder $ do
      createDirectory "scenes"
      Text.writeFile "scenes/s.txt" sphereScene
      Bytes.writeFile "configuration.cfg" "# l\xE9gende\r\napplication console\r\nread_data s.txt\r\nwrite_data out.txt\r\nviewport_image_count 41 next\r\n"
      (code, out, err) <- heard runHere
      (code, out) `shouldBe` (ExitSuccess, "ball_041.png\n")
      -- 20 x 16 rays against one shape.
      err `shouldContainText` "320 rays, 320 intersection tests"
      Bytes.readFile "configuration.cfg"
        >>= (`shouldBe` "# l\xE9gende\r\napplication console\r\nread_data s.txt\r\nwrite_data out.txt\r\nviewport_image_count 42 next\r\n")
      log' <- Text.readFile "log.txt"
      forM_ ["reading scene 's.txt'", "1 primitive", "320 rays", "ball_041.png"] (log' `shouldContainText`)
      (code', out', _) <- heard (journal' (\j -> compare j "out.txt" "scenes/s.txt"))
      (code', out') `shouldBe` (ExitSuccess, "20 x 16 pixels, equal\n")
    it "logs the models that it reads" . inFolder $ do
      Text.writeFile "s.txt" (sphereScene <> "model\nfile a.msr\nend\nmodel\nfile b.obj\nend\nmodel\nfile c.agp\nend\n")
      Text.writeFile "a.msr" "material\nname a\nend\nprimitive\nmaterial_name a\nsphere\nend\nend\n"
      Text.writeFile "b.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
      Text.writeFile "c.agp" "0 1 2\n0 0 0\n0 0 0\n"
      Text.writeFile "configuration.cfg" "application console\nread_data s.txt\nwrite_data out.txt\n"
      (code, _, _) <- heard runHere
      code `shouldBe` ExitSuccess
      log' <- Text.readFile "log.txt"
      forM_ ["model 'a.msr' read: 1 primitive", "model 'b.obj' read: 1 triangle, 0 quads, 0 other polygons", "model 'c.agp' read: 2 tubes"] (log' `shouldContainText`)
    it "writes neither the scene nor the log over a file that was read, and the rest all the same" . inFolder $ do
      writeScenery
      createFileLink "s.txt" "l.txt"
      before <- traverse Bytes.readFile scenery
      Text.writeFile "configuration.cfg" "application console\nread_data s.txt\nwrite_data a.png\nlog_file_name l.txt\n"
      (code, out, err) <- heard runHere
      (code, out) `shouldBe` (ExitFailure 3, "ball_000.png\n")
      forM_ ["a.png: this is a file that was read; it stays as it is", "l.txt: this is a file that was read (s.txt); it stays as it is"] (err `shouldContainText`)
      traverse Bytes.readFile scenery >>= (`shouldBe` before)
    it "writes no list over a picture that it compares, nor over what such a scene reads" . inFolder $ do
      writeScenery
      before <- traverse Bytes.readFile scenery
      Text.writeFile "list.txt" "texture_comparator\nfile s.txt\nfile a.png\nend\n"
      forM_ ["a.png", "c.msr"] $ \path -> do
        Text.writeFile "configuration.cfg" ("application comparator\nread_data list.txt\nwrite_data " <> path <> "\n")
        (code, _, err) <- heard runHere
        code `shouldBe` ExitFailure 3
        err `shouldContainText` (path <> ": this is a file that was read")
      traverse Bytes.readFile scenery >>= (`shouldBe` before)
    it "says where it looked for a scene that is not there" . inFolder $ do
      Text.writeFile "configuration.cfg" "application console\nread_data s.txt\n"
      (code, _, err) <- heard runHere
      code `shouldBe` ExitFailure 3
      forM_ ["'s.txt'", "scenes", "models"] (err `shouldContainText`)
    it "does nothing for the application none" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "configuration.cfg" "application none\nread_data s.txt\n"
      heard runHere >>= \(code, out, _) -> (code, out) `shouldBe` (ExitSuccess, "")
    it "draws for frame as for console, and ends, where no browser can be opened" . inFolder . withScreen False $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "configuration.cfg" "application frame\nread_data s.txt\nwrite_data out.txt\n"
      (ended, out, err) <- heard (timeout 60000000 runHere)
      (ended, out) `shouldBe` (Just ExitSuccess, "ball_000.png\n")
      err `shouldContainText` "no browser can be opened here"
      Text.readFile "configuration.cfg" >>= (`shouldContainText` "viewport_image_count\t1\n")
    it "draws for frame as for console, and ends when its page is closed" . inFolder . withScreen True $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "configuration.cfg" "application frame\nread_data s.txt\nwrite_data out.txt\n"
      (code, rest) <- listeningTo runHere $ \out -> do
        address <- Text.hGetLine out
        let (page, token) = Chars.breakEnd (== '#') (Text.encodeUtf8 address)
            port = maybe 0 fst (Chars.readInt (snd (Chars.breakEnd (== ':') page)))
            host = "127.0.0.1:" <> Chars.pack (show port)
        -- The page is open until the picture is there
        WebSockets.runClientWith "127.0.0.1" port ("/live?" <> Chars.unpack token) WebSockets.defaultConnectionOptions [("Origin", "http://" <> host)] (const (Text.hGetLine out))
      (code, rest) `shouldBe` (ExitSuccess, "ball_000.png")
      traverse Bytes.readFile ["ball_000.png", "out.txt"] >>= (`shouldBe` [False, False]) . map Bytes.null
      Text.readFile "configuration.cfg" >>= (`shouldContainText` "viewport_image_count\t1\n")
    it "writes no log and stays silent where it is asked to" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "configuration.cfg" "application console\nread_data s.txt\nwrite_data out.txt\nlog_console no\nlog_file 0\n"
      heard runHere >>= (`shouldBe` (ExitSuccess, "ball_000.png\n", ""))
      doesFileExist "log.txt" >>= (`shouldBe` False)
    it "stays silent under --quiet whatever the configuration says, and logs all the same" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "configuration.cfg" "application console\nread_data s.txt\nwrite_data out.txt\nlog_console yes\n"
      heard (newJournal English False >>= \j -> readConfiguration >>= run j) >>= (`shouldBe` (ExitSuccess, "ball_000.png\n", ""))
      Text.readFile "log.txt" >>= (`shouldContainText` "reading scene 's.txt'")
    it "compares what a list names" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "list.txt" "texture_comparator\nfile s.txt\nfile s.txt\nend\n"
      Text.writeFile "configuration.cfg" "application comparator\nread_data list.txt\nwrite_data again.txt\n"
      (code, out, _) <- heard runHere
      (code, out) `shouldBe` (ExitSuccess, "comparison #1: s.txt, s.txt: equal\n")
      Text.readFile "again.txt" >>= (`shouldContainText` "s.txt")
    it "speaks French where the configuration says so" . inFolder $ do
      Text.writeFile "s.txt" sphereScene
      Text.writeFile "configuration.cfg" "application console\nread_data s.txt\nwrite_data out.txt\n"
      (_, _, err) <- heard (newJournal French True >>= \j -> readConfiguration >>= run j)
      err `shouldContainText` "lecture de la sc\xE8ne"
  it "refuses a picture as a scene, in both languages" . inFolder $
    forM_ pictureHeads $ \bytes -> do
      Bytes.writeFile "s.txt" bytes
      forM_
        [ (`render` plainOptions),
          \j -> check j AsText ["s.txt"],
          \j -> explain j AsText "s.txt" 0 0,
          \j -> compare j "s.txt" "s.txt",
          \j -> fromMaybe ExitSuccess <$> timeout 20000000 (viewScene j (ViewOptions Nothing False) (Just "s.txt"))
        ]
        $ \command -> do
          (code, out, err) <- heard (journal' command)
          (code, out, take 1 (Text.lines err)) `shouldBe` (ExitFailure 3, "", ["s.txt: this is a picture, and no scene: a scene is a text"])
          (code', out', err') <- heard (newJournal French True >>= command)
          (code', out', take 1 (Text.lines err')) `shouldBe` (ExitFailure 3, "", ["s.txt\xA0: c'est une image, et non une sc\xE8ne\xA0: une sc\xE8ne est un texte"])
      listDirectory "." >>= (`shouldBe` ["s.txt"])
  it "refuses a picture that the configuration names as a scene" . inFolder $ do
    Bytes.writeFile "s.png" (head pictureHeads)
    Text.writeFile "configuration.cfg" "application console\nread_data s.png\nwrite_data out.txt\nlog_file no\n"
    (code, out, err) <- heard runHere
    (code, out) `shouldBe` (ExitFailure 3, "")
    err `shouldContainText` "s.png: this is a picture, and no scene"
  it "takes a text for one that begins with the letters of a picture" . inFolder $
    forM_ ["BM5 is my camera\n", "GIF89a is a format\n"] $ \text -> do
      Text.writeFile "s.txt" text
      (code, out, _) <- heard (journal' (\j -> check j AsText ["s.txt"]))
      code `shouldBe` ExitFailure 1
      out `shouldContainText` "s.txt:1:1: error: unknown word"
  it "survives a scene of any bytes" . inFolder $ do
    Bytes.writeFile "s.txt" (Chars.pack ['\0' .. '\255'])
    (code, _, _) <- heard (render' plainOptions)
    code `shouldNotBe` ExitFailure 70
  where
    render' options = journal' (`render` options)
    journal' command = newJournal English True >>= command
    runHere = newJournal English True >>= \j -> readConfiguration >>= run j
    plainOptions = Options "s.txt" (Numbered minBound) Nothing Nothing Nothing Nothing False
    -- Words of the original that open objects which scenes do not have, and what closes objects.
    unused =
      ["end", "fin", "view_frustum", "viewfrustum", "default_material", "scene", "model_msr", "console_comparator", "comparateur_console"]
        <> ["particle", "particule", "particles_system", "systeme_particules", "electric_charge", "charge_electrique"]
        <> ["texture_comparator", "texture_comparateur"]

-- | The first bytes of pictures: PNG, JPEG, GIF, BMP.
pictureHeads :: [Bytes.ByteString]
pictureHeads =
  [ "\x89PNG\r\n\x1A\n\0\0\0\rIHDR",
    "\xFF\xD8\xFF\xE0\0\x10JFIF\0",
    "GIF89a\x14\0\x10\0\x80\0\0",
    "BM\x36\x10\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0"
  ]

-- | Works with a screen, and with a browser that shows nothing; or without a screen.
withScreen :: Bool -> IO a -> IO a
withScreen there work = withSystemTempDirectory "screen" $ \folder -> do
  let browser = folder </> "xdg-open"
  writeFile browser "#!/bin/sh\n"
  setFileMode browser 0o755
  path <- fromMaybe "" <$> lookupEnv "PATH"
  given ([("DISPLAY", if there then Just ":0" else Nothing), ("WAYLAND_DISPLAY", Nothing)] <> [("PATH", Just (folder <> ":" <> path)) | there]) work
  where
    given variables inner = foldr (\(name, value) -> bracket (lookupEnv name <* set name value) (set name) . const) inner variables
    set name = maybe (unsetEnv name) (setEnv name)

-- | The scene s.txt and the files that it reads.
scenery :: [FilePath]
scenery = ["s.txt", "a.png", "m.png", "c.msr", "d.agp", "models/b.obj", "models/b.mtl"]

-- | Writes them.
writeScenery :: IO ()
writeScenery = do
  createDirectory "models"
  Text.writeFile "s.txt" (sphereScene <> "texture_material\nname t\ntexture_kd a.png\nend\n" <> Text.concat ["model\nfile " <> name <> "\nend\n" | name <- ["b.obj", "c.msr", "d.agp"]])
  Text.writeFile "models/b.obj" "mtllib b.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
  Text.writeFile "models/b.mtl" "newmtl m\nmap_Kd m.png\n"
  Text.writeFile "c.msr" "primitive\nsphere\nend\nend\n"
  Text.writeFile "d.agp" "0 1 2\n0 0 0\n0 0 0\n"
  -- Whether they are pictures does not matter: they are read.
  mapM_ (`Text.writeFile` "none") ["a.png", "m.png"]

-- | A red ball in 20 x 16 pixels. Its radius is on line 12.
sphereScene :: Text
sphereScene =
  Text.unlines
    [ "viewport",
      "width 20",
      "height 16",
      "image_file_name ball",
      "end",
      "raytracer",
      "reflexion_algorithm no_light",
      "end",
      "primitive",
      "material_name red",
      "sphere",
      "position 0 0 0",
      "ray 1.0",
      "position 0 0 4",
      "end",
      "end",
      "material",
      "name red",
      "color 1.0 0.0 0.0",
      "kd 1.0",
      "end"
    ]

shouldContainText :: Text -> Text -> IO ()
shouldContainText text part = Text.unpack text `shouldContain` Text.unpack part
