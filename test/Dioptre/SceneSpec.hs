{-# LANGUAGE OverloadedStrings #-}

module Dioptre.SceneSpec
  ( spec,
  )
where

import Control.Exception (evaluate)
import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene (writeScene)
import Dioptre.Scene.Default (defaultScene)
import Dioptre.Source.Diagnostic (code, diagnosticProblem)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Message (message)
import Laws.Reading
import Laws.Scene
import Laws.Text
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (arbitrary, checkCoverage, conjoin, counterexample, cover, forAll, property, resize, vectorOf)

spec :: Spec
spec = do
  describe "a scene that is written" $
    modifyMaxSuccess (const 400) $ do
      prop "reads back as the same scene" $ \(AnyScene s) -> printedReadsBack s
      prop "is written again as the same text" $ \(AnyScene s) -> printingSettles s
      prop "reads back however people write it" $ \(AnyScene s) -> disguisedReadsBack s
      prop "was sound before" $ \(AnyScene s) -> isSound s
      it "has shapes of every kind" $
        checkCoverage . forAll arbitrary $ \(AnyScene s) ->
          foldr (\word -> cover 3 (word `elem` shapesNames s) (Text.unpack word)) (property True) (Text.words "sphere plane disk annulus triangle btriangle tube cylinder cone cube spherical_cap lens torus geometry")
      it "reads back, however deep its shapes are nested" $
        for_ [1 .. 40] $ \depth -> do
          let text = nested depth
          said (Text.lines text) `shouldBe` []
          said (Text.lines (writeScene (readingScene (readText text)))) `shouldBe` []
          readingScene (readText (writeScene (readingScene (readText text)))) `shouldBe` readingScene (readText text)

  describe "any text" $ do
    modifyMaxSuccess (const 300) $ do
      prop "has a sound scene, and all is told as it should be" $ \(SceneText t) -> isReadWhole (readText t)
      prop "of any bytes has one, too" $ \(Noise b) -> isReadWhole (readBytes b)
      prop "is read, written and read to the same scene as read once" $ \(SceneText t) -> readsTheSameTwice (readText t)
      prop "of any bytes is, too" $ \(Noise b) -> readsTheSameTwice (readBytes b)
    modifyMaxSuccess (const 1) $
      prop "is tried with all that can be wrong" . forAll (vectorOf 1000 (resize 30 arbitrary)) $ \texts ->
        let drawn = [name | SceneText t <- texts, (name, True) <- kindsOfTexts (readText t)]
         in conjoin [counterexample name (name `elem` drawn) | (name, _) <- kindsOfTexts (readText "")]

  describe "the scene that is built in" $ do
    it "has nothing to say" $ readingDiagnostics (readText defaultScene) `shouldBe` []
    it "is a sphere above a plane, in grey, under one light" $
      readingScene (readText defaultScene)
        `shouldBe` readingScene
          ( readText . Text.unlines $
              ["camera", "position -2 0 2", "look_at 0 0 0", "up 0 0 1", "angle 60", "near_clipping_plane 1", "far_clipping_plane 100", "end"]
                <> ["primitive", "plane", "position 0 0 0", "normal 0 0 1", "end", "end"]
                <> ["primitive", "sphere", "position 0 0 1", "ray 0.5", "end", "end"]
                <> ["directional_light", "end"]
          )

  describe "a large text" $
    for_ large $ \(name, text, codes) ->
      it (name <> " is read, written and told in seconds") $ do
        let r = readText text
        _ <- evaluate (Text.length text)
        done <- timeout 15000000 $ do
          _ <- evaluate (length (show (readingScene r)))
          _ <- evaluate (Text.length (writeScene (readingScene r)))
          _ <- evaluate (sum (map (Text.length . message English . diagnosticProblem) (readingDiagnostics r)))
          pure (map (code . diagnosticProblem) (take 1 (readingDiagnostics r)))
        done `shouldBe` Just codes

-- | A sphere in so many transformations.
nested :: Int -> Text
nested depth =
  Text.unlines $
    ["material", "end", "primitive"] <> replicate depth "geometry" <> ["sphere", "end"] <> replicate depth "end" <> ["end"]

-- | Texts that are hard for those who read them more than once, with the first thing that is said of each.
large :: [(String, Text, [Text])]
large =
  [ ("of one word", Text.replicate million "a", ["unknown-word"]),
    ("of one line", "camera\nposition " <> Text.replicate (million `div` 2) "1 " <> "\nend", ["wrong-count"]),
    ("of one number", "camera\nangle 0." <> Text.replicate million "0" <> "1e1000001\nend", ["out-of-range"]),
    ("of blanks", Text.replicate million "\t", []),
    ("of empty lines", Text.replicate million "\n", []),
    ("of unknown words", Text.unlines [Text.pack ("word" <> show i <> " 1") | i <- [1 .. 40000 :: Int]], ["unknown-word"]),
    ("of unknown objects, one in the other", Text.replicate (million `div` 10) "x\n", ["unknown-word"]),
    ("of unknown objects, closed", Text.replicate (million `div` 10) "x\n" <> Text.replicate (million `div` 10) "end\n", ["unknown-word"]),
    ("of unknown objects that a long line closes", Text.replicate (million `div` 10) "x\n" <> "camera " <> Text.replicate (million `div` 2) "y", ["unknown-word"]),
    ("of unknown objects with a comment at the end", Text.replicate (million `div` 10) "x\n" <> "/*\n" <> Text.replicate (million `div` 10) "hello\n", ["unknown-word"]),
    ("of transformed shapes, one in the other", nested 2000, ["no-material-name"]),
    ("of comments that are not closed", Text.replicate (million `div` 4) "/*\n", ["unclosed-comment"]),
    ("of ends", Text.replicate (million `div` 10) "end\n", ["stray-end"]),
    ("of cameras", Text.replicate (million `div` 20) "camera\n", ["missing-end"]),
    ("of materials of one name", Text.replicate (million `div` 40) "material\nname a\nend\n", ["repeated-material"]),
    ("of materials that are not there", Text.unlines ["primitive\nmaterial_name m" <> Text.pack (show i) <> "\nsphere\nend\nend" | i <- [1 .. 20000 :: Int]], ["missing-material"]),
    ( "of long names, none of which is meant",
      Text.unlines (["material\nname " <> Text.replicate 1000 "q" <> Text.pack (show i) <> "\nend" | i <- [1 .. 300 :: Int]] <> ["primitive\nmaterial_name m" <> Text.pack (show i) <> "\nsphere\nend\nend" | i <- [1 .. 2000 :: Int]]),
      ["missing-material"]
    )
  ]
  where
    million = 1000000
