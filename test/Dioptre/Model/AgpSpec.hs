{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Model.AgpSpec
  ( spec,
  )
where

import qualified Data.ByteString as Bytes
import Data.Foldable (for_, toList)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Geometry.Axis (axisEnd, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Light.Colour (Colour (..), rgb)
import Dioptre.Light.Finish
import Dioptre.Math.Vector (Point)
import Dioptre.Model.Agp
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, decode, fromText, sourceText)
import Dioptre.Syntax.Value (showReal)
import Laws.Reading (at)
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = describe "an AGP file" $ do
  it "draws tubes from point to point" $ do
    tubesOf ["curve 1", "0 1 1,5", "0 0 0,5", "0 0 1", "", "the end"]
      `shouldBe` [(V3 0 0 0, V3 1 0 0, 0.1), (V3 1 0 0, V3 1.5 0.5 1, 0.1)]
    tubesOf ["1", "2", "3"] `shouldBe` []
    tubesOf [] `shouldBe` []
  it "has one finish for all of them" $ do
    let Content parts finishes = fst (readAgp (textOf (curveLines id [V3 0 0 0, V3 1 2 3, V3 0 0 0])))
    [n | Solid _ n <- parts] `shouldBe` [0, 0]
    case toList finishes of
      [f] -> do
        -- ka 0.2, kd 0.8 and ks 0.5 times (0.8, 0.8, 0.2).
        let close (Layer c p) wanted = (map (subtract' wanted) [c], p) `shouldSatisfy` \(ds, none) -> all (< 1e-15) ds && null none
            subtract' (Colour r g b _) (Colour r' g' b' _) = maximum (map abs [r - r', g - g', b - b'])
        close (finishAmbient f) (rgb 0.16 0.16 0.04)
        close (finishDiffuse f) (rgb 0.64 0.64 0.16)
        close (finishSpecular f) (rgb 0.4 0.4 0.1)
        (shininessOf (finishColours f), finishMirror f, finishTransparency f, finishIndex f) `shouldBe` (20, 0, 0, 1)
      other -> length other `shouldBe` 1
  prop "gives back the points that were written to it" $
    forAll (listOf (listOf1 somePoint)) $ \curves ->
      forAll (elements ["\n", "\r\n", "\r"]) $ \lineEnd ->
        forAll (vectorOf (length curves) (sublistOf ["", "curve", "\tx 1 2 3", "# 1 2"])) $ \remarks -> do
          let written = Text.intercalate lineEnd (concat (zipWith (\r c -> r <> curveLines (Text.replace "." ",") c) remarks curves) <> [""])
              wanted = [(p, q, 0.1) | c <- curves, (p, q) <- zip c (drop 1 c), p /= q]
          cover 20 (length wanted > 3) "several tubes" $ tubesIn (fromText "a.agp" written) === wanted
  it "leaves pieces out that lead nowhere, and counts them" $ do
    let text = ["0 0 1 1 2", "0 0 0 0 0", "5 5 5 5 5"]
    tubesOf text `shouldBe` [(V3 0 0 5, V3 1 0 5, 0.1), (V3 1 0 5, V3 2 0 5, 0.1)]
    saidOf text `shouldBe` [at 1 3 4 (PiecesWithoutLength 2)]
  describe "with a slip" $ do
    it "tells it, and reads on" $
      for_
        [ (["0 1", "0 O", "0 1"], [at 4 3 4 (BrokenCurve (RowRefused (NotANumber "O")))]),
          (["0 1", "0 1", "0 1e101"], [at 5 3 8 (BrokenCurve (RowRefused (TooLarge "1e101")))]),
          (["0 1", "0 1", "-O 1"], [at 5 1 3 (BrokenCurve (RowRefused (NotANumber "-O")))]),
          (["0 1,2,3", "0 1", "0 1"], [at 3 3 8 (BrokenCurve (RowRefused (NotANumber "1,2,3")))]),
          (["0 1", " 0 1 2", "0 1"], [at 4 2 7 (BrokenCurve (RowsDiffer 3 2))]),
          (["0 1", "0 1", "0"], [at 5 1 2 (BrokenCurve (RowsDiffer 1 2))]),
          (["0 1", "0 1"], [at 3 1 4 (BrokenCurve (RowsMissing 1))]),
          (["0 1"], [at 3 1 4 (BrokenCurve (RowsMissing 2))])
        ]
        $ \(slip, wanted) -> do
          let text = ["", "first"] <> slip <> ["second"] <> curveLines id [V3 0 0 0, V3 1 2 3]
          (slip, saidOf text, tubesOf text) `shouldBe` (slip, wanted, [(V3 0 0 0, V3 1 2 3, 0.1)])
    it "tells rows that the end of the file cuts off" $ do
      saidOf ["0 1", "0 1"] `shouldBe` [at 1 1 4 (BrokenCurve (RowsMissing 1))]
      saidOf ["0 1"] `shouldBe` [at 1 1 4 (BrokenCurve (RowsMissing 2))]
  prop "may hold anything, and tells only of places that are there" . forAll (oneof [Bytes.pack <$> arbitrary, almost]) $ \bytes -> do
    let source = decode "a.agp" bytes
        (Content parts _, said) = readAgp source
        lengths = map Text.length (Text.split (== '\n') (sourceText source))
        isThere (Span line from to) = 1 <= line && 1 <= from && from < to && or [to <= n + 1 | n <- take 1 (drop (line - 1) lengths)]
    cover 10 (not (null parts)) "tubes" . cover 10 (not (null said)) "slips" $ all (isThere . diagnosticSpan) said
  where
    textOf = fromText "a.agp" . Text.unlines
    tubesOf = tubesIn . textOf
    saidOf = snd . readAgp . textOf

-- | The tubes of a file: from where to where, and how thick.
tubesIn :: Source -> [(Point, Point, Double)]
tubesIn source = [(axisStart (roundAxis t), axisEnd (roundAxis t), roundRadius t) | Solid (ATube t) _ <- contentParts (fst (readAgp source))]

-- | A curve as its three lines, each number written by a rule.
curveLines :: (Text -> Text) -> [Point] -> [Text]
curveLines rule points = [Text.unwords (map (rule . showReal . get) points) | get <- [\(V3 x _ _) -> x, \(V3 _ y _) -> y, \(V3 _ _ z) -> z]]

-- | What is nearly a file.
almost :: Gen Bytes.ByteString
almost = Text.encodeUtf8 . Text.unlines <$> listOf (Text.unwords <$> oneof [vectorOf 2 (elements ["0", "1,5", "-2"]), listOf (elements ["0", "1,5", "x", "-", "\233", "1e999"])])

somePoint :: Gen Point
somePoint = oneof [V3 <$> near <*> near <*> near, V3 <$> arbitrary <*> arbitrary <*> arbitrary]
  where
    near = elements [0, 1, -0.5]
