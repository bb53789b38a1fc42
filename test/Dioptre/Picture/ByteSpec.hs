-- | Bytes: the original's own examples, and the laws.
module Dioptre.Picture.ByteSpec (spec) where

import Dioptre.Light.Colour (Colour (..))
import Dioptre.Picture.Byte
import Dioptre.Scene.Raytracer (ColourNormalization (..))
import GHC.Float (castFloatToWord32, castWord32ToFloat, float2Double)
import Laws.Picture
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  describe "level" $ do
    it "is the original's" $ map level [0, 0.25, 0.5, 0.75, 1] `shouldBe` [0, 64, 128, 191, 255]
    it "has every level at its own share of 255" $ map (level . (/ 255) . fromIntegral) [0 .. 255 :: Int] `shouldBe` [0 .. 255]
    it "is 0 below the range, and for what is no number; 255 above it" $
      map level [-0.0, -1e-300, -5, -1 / 0, 0 / 0, 1.0000000000000002, 7, 1 / 0] `shouldBe` [0, 0, 0, 0, 0, 255, 255, 255]
    -- 1 - 2^-26 is nearer to 1 than to the binary32 below, 1 - 2^-24
    it "rounds to binary32 first" $ map level [1 - 2 ** (-26), 1 - 2 ** (-24)] `shouldBe` [255, 255]
    it "changes once at each of 255 places, next to (k + 1/2) / 255" $
      [length (filter id (zipWith (/=) ls (drop 1 ls))) | k <- [0 .. 254 :: Int], let { ls = map (level . float2Double) (closeTo k) }] `shouldBe` replicate 255 1
    modifyMaxSuccess (* 50) $ prop "is the rule, computed with rational numbers" levelIsExact
    prop "does not fall" levelsAscend

  describe "normalized" $ do
    it "cuts channels to 1, or divides them by the largest" $ do
      normalized ClampChannel (Colour 0.5 2 0.25 1) `shouldBe` Colour 0.5 1 0.25 1
      normalized DivisionFactor (Colour 0.5 2 0.25 1) `shouldBe` Colour 0.25 1 0.125 1
    it "cuts alpha to 1, either way" $ map (\how -> alpha (normalized how (Colour 0 0 4 2))) [ClampChannel, DivisionFactor] `shouldBe` [1, 1]
    it "does not divide by alpha" $ normalized DivisionFactor (Colour 0.5 0.25 0 8) `shouldBe` Colour 0.5 0.25 0 1
    prop "leaves channels below 1 alone when it cuts" clampKeepsTheRest
    prop "keeps ratios when it divides" divisionKeepsRatios

  describe "pixelOf" $ prop "has the levels of the normalized channels, in their order" pixelIsLevels
  where
    closeTo k =
      let middle = castFloatToWord32 (fromRational ((fromIntegral k + 1 / 2) / 255))
       in map castWord32ToFloat [middle - 200 .. middle + 200]
