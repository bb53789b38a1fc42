{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Command.NewSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.List (nub)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import qualified Data.Vector.Storable as Storable
import Dioptre (draw)
import Dioptre.Command.Check (check)
import Dioptre.Command.Format (Format (AsText))
import Dioptre.Command.Heard (heard, inFolder)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.New
import Dioptre.Picture (pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Scene.Check (sceneWords)
import Dioptre.Source.Diagnostic (code, diagnosticProblem)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Keyword (Keyword (Geometry, Sphere), spelling)
import Laws.Reading
import System.Directory (createDirectory, createFileLink, listDirectory)
import System.Exit (ExitCode (..))
import Test.Hspec

spec :: Spec
spec = do
  describe "the scene to start from" $ do
    for_ [English, French] $ \l -> describe (show l) $ do
      it "is free of faults" $ readingDiagnostics (readText (starter l)) `shouldBe` []
      it "shows or names every object that a scene can have, and every shape" $ do
        let words' = nub (Text.words (Text.filter (`notElem` (",.:" :: String)) (starter l)))
        [w | w <- map spelling (sceneWords <> [Sphere .. Geometry]), w `notElem` words'] `shouldBe` []
      it "has examples behind # that are free of faults, but for a file that is not there" $
        readingDiagnostics (readText (Text.unlines (map shown (Text.lines (starter l))))) `shouldBe` []
      it "shows commands that are no worse laid out with another name" $
        [line | line <- Text.lines (starter l), "my_scene" `Text.isInfixOf` line, "  " `Text.isInfixOf` Text.strip (Text.dropWhile (== '#') line), "#" `Text.isPrefixOf` line] `shouldBe` []
      it "fits into 92 columns" $ [line | line <- Text.lines (starter l), Text.length line > 92] `shouldBe` []
    it "is the same scene in both languages" $
      readingScene (readText (starter English)) `shouldBe` readingScene (readText (starter French))
    it "has comments in two languages" $ do
      let comments l = [line | line <- Text.lines (starter l), Text.length line > 60, "#" `Text.isPrefixOf` line]
      [line | line <- comments English, line `elem` comments French] `shouldBe` []
    it "draws the same picture in both languages" $
      draw (fromText "s.txt" (quick (starter English))) `shouldBe` draw (fromText "s.txt" (quick (starter French)))
    it "draws a sky above many colours" $ do
      let picture = draw (fromText "s.txt" (quick (starter English)))
          pixels = [Storable.toList (Storable.slice (4 * i) 4 (pictureBytes picture)) | i <- [0 .. 320 * 240 - 1]]
      (pictureWidth picture, pictureHeight picture) `shouldBe` (320, 240)
      -- Ambient light alone: 0.9 (0.9 0.6, 0.9 0.75, 1.0 0.95) = (0.486, 0.6075, 0.855), times 255 and rounded.
      pixels !! (2 * 320 + 160) `shouldBe` [124, 155, 218, 255]
      Set.size (Set.fromList pixels) `shouldSatisfy` (> 2000)
  describe "under a name" $ do
    it "has that name in its commands and its pictures" $ do
      let text = starterNamed "a/pendulum.txt" (starter English)
      text `shouldSatisfy` Text.isInfixOf "dioptre check a/pendulum.txt\n"
      text `shouldSatisfy` Text.isInfixOf "image_file_name pendulum\n"
      text `shouldNotSatisfy` Text.isInfixOf "my_scene"
    it "stays free of faults, and whole" $
      for_ ["a b.txt", "it's.txt", " .txt", "back\\slash.txt", "end.txt", "my_scene_2.txt", "\233t\233.txt", "*/.txt"] $ \name -> do
        map (code . diagnosticProblem) (readingDiagnostics (readText (starterNamed name (starter French)))) `shouldBe` []
        Text.length (starterNamed name (starter French)) `shouldSatisfy` (> 5000)
    it "is one word for a shell" $
      starterNamed "it's.txt" "dioptre my_scene.txt" `shouldBe` "dioptre 'it'\\''s.txt'"
  describe "new" $ do
    it "writes a scene, and prints its path" . inFolder $ do
      heard (newIn English "pendulum") >>= (`shouldBe` (ExitSuccess, "pendulum.txt\n", ""))
      Text.readFile "pendulum.txt" >>= (`shouldBe` starterNamed "pendulum.txt" (starter English))
      heard (newJournal English True >>= \j -> check j AsText ["pendulum.txt"]) >>= (`shouldBe` (ExitSuccess, "pendulum.txt: no faults\n", ""))
    it "takes the name as it is where it ends in .txt" . inFolder $ do
      heard (newIn French "A.TXT") >>= (`shouldBe` (ExitSuccess, "A.TXT\n", ""))
      Text.readFile "A.TXT" >>= (`shouldSatisfy` Text.isInfixOf "Une scène pour commencer")
    it "writes into a folder that is there, and into no other" . inFolder $ do
      createDirectory "a"
      heard (newIn English "a/b") >>= (`shouldBe` (ExitSuccess, "a/b.txt\n", ""))
      (code', out, err) <- heard (newIn English "c/b")
      (code', out) `shouldBe` (ExitFailure 3, "")
      err `shouldBe` "c/b.txt: there is no such file or folder\n"
      listDirectory "." >>= (`shouldBe` ["a"])
    it "never writes over anything" . inFolder $ do
      Text.writeFile "a.txt" "mine"
      createFileLink "nowhere" "b.txt"
      createDirectory "c.txt"
      for_ ["a", "b", "c"] $ \name -> do
        (code', out, err) <- heard (newIn English name)
        (code', out) `shouldBe` (ExitFailure 3, "")
        err `shouldBe` Text.pack name <> ".txt: there is a file of this name; it stays as it is\n"
      Text.readFile "a.txt" >>= (`shouldBe` "mine")
      listDirectory "." >>= (`shouldBe` 3) . length
    it "refuses what is no name" . inFolder $ do
      for_ ["", ".", "..", "a/", ".txt", "a\nb"] $ \name -> do
        (code', out, _) <- heard (newIn English name)
        (name, code', out) `shouldBe` (name, ExitFailure 2, "")
      listDirectory "." >>= (`shouldBe` [])
  where
    newIn l name = newJournal l True >>= (`new` name)

-- | A line of an example without its #: those that begin with two blanks or one word of the language behind one blank.
shown :: Text -> Text
shown line = case Text.stripPrefix "# " line of
  Just rest
    | first : _ <- Text.words rest, first `elem` ["model", "rectangular_aperture_light", "end"] && length (Text.words rest) == 1 -> rest
    | "  " `Text.isPrefixOf` rest, not ("dioptre" `Text.isInfixOf` rest) -> rest
  _ -> line

-- | One ray for each pixel.
quick :: Text -> Text
quick = Text.replace "random" "center" . Text.replace "sampling            9" "sampling            1"
