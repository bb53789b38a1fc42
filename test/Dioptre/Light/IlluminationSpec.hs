-- | The terms of illumination: examples, and the laws.
module Dioptre.Light.IlluminationSpec (spec) where

import Data.Foldable (for_)
import Dioptre.Light.Colour
import Dioptre.Light.Illumination
import Dioptre.Math.Vector
import Laws.Light
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "ambient" $
    it "is the light times the surface" $ ambient (Colour 1 0.5 2 0.25) (Colour 0.5 0.5 0.5 0.75) `shouldBe` Colour 0.5 0.25 1 0.25

  describe "lambert" $ do
    it "is all of it where the light comes straight" $ lambert light surface alongZ (V3 0 0 (-1)) `shouldBe` lit 1
    -- At 60 degrees, whose cosine is 1/2: no sine is needed
    it "is half of it at 60 degrees" $ lambert light surface alongZ (V3 (sqrt 0.75) 0 (-0.5)) `shouldBe` lit 0.5
    it "is 0.6 of it where the cosine is" $ lambert light surface alongZ (V3 0 0.8 (-0.6)) `shouldBe` lit 0.6
    it "is nothing where the light runs along the surface" $ lambert light surface alongZ (V3 0 1 0) `shouldBe` lit 0
    it "is black where it comes from behind" $ lambert light surface alongZ (V3 0 0.8 0.6) `shouldBe` black
    prop "it is the cosine of the angle from the normal" lambertIsTheCosine

  describe "blinn" $ do
    it "is all of it for a viewer at a light straight above" $ map (blinn light surface alongZ down down) [0, 1, 200] `shouldBe` replicate 3 (lit 1)
    -- Light from x, viewer at z: half way at 45 degrees, 1/sqrt 2 from either
    it "is 2^(-k/2) between the x axis and the z axis" $
      for_ [2, 4, 20] $ \k -> near (8 * k) (blinn light surface alongZ (V3 (-1) 0 0) down k) (lit (2 ** (-k / 2)))
    it "is the full light for shininess 0, at any angle" $ blinn light surface alongZ (V3 (-1) 0 0) down 0 `shouldBe` lit 1
    it "is black where the half way is behind" $ blinn light surface alongZ (V3 0 0 1) (V3 0 0.6 0.8) 20 `shouldBe` black
    it "is 0 where light and viewer are exactly opposite, for shininess 0 too" $
      [blinn light surface n d (negate d) k | n <- [alongX, alongY, opposite alongZ], d <- [V3 1 0 0, V3 0 0.6 0.8, V3 0 0 1], k <- [0, 1, 200]] `shouldSatisfy` all (== black)
    prop "it is the power of the cosine of half the sum of the angles" blinnIsTheHalfAngle
    prop "exchanging light and viewer changes nothing" blinnIsSymmetric

  describe "phong" $ do
    -- Down along x at 3-4-5, mirrored up along x; the viewer looks back down that way
    it "is all of it in the mirror direction" $
      for_ [0, 1, 200] $ \k -> near (8 * (k + 1)) (phong light surface alongZ (V3 0.8 0 (-0.6)) (V3 (-0.8) 0 (-0.6)) k) (lit 1)
    it "is all of it for a viewer at a light straight above" $ map (phong light surface alongZ down down) [0, 1, 200] `shouldBe` replicate 3 (lit 1)
    -- Light along x and down, mirrored along x and up; the viewer straight above sees it at 60 degrees
    it "is 2^-k at 60 degrees from the mirror direction" $
      for_ [1, 2, 10] $ \k -> near 1 (phong light surface alongZ (V3 (sqrt 0.75) 0 (-0.5)) down k) (lit (2 ** (-k)))
    it "is black beyond a right angle from the mirror direction" $ phong light surface alongZ (V3 0.8 0 (-0.6)) (V3 0.8 0 (-0.6)) 1 `shouldBe` black
    prop "it is the power of the cosine of the sum of the angles" phongIsTheMirroredAngle
    prop "exchanging light and viewer changes nothing but roundings" phongIsSymmetric

  describe "every term" $ do
    prop "a viewer in the mirror direction sees the full highlight" mirroredLightIsFull
    prop "shininess 0 is the factor 1" shininessZeroIsFull
    for_ terms $ \term -> do
      prop ("is linear in the light: " <> show term) (termIsLinear term)
      modifyMaxSuccess (* 10) $ prop ("is never negative, nor not a number: " <> show term) (termIsNeverNegative term)
    it "is tried in all its corners by these laws" $
      checkCoverage $ \l -> foldr (\(name, holds) -> cover 1 holds name) (property True) (litCorners l)
  where
    light = Colour 1 0.5 2 0.25
    surface = Colour 0.5 0.5 0.25 0.75
    lit k = Colour (k * 0.5) (k * 0.25) (k * 0.5) 0.25
    down = V3 0 0 (-1)
    -- Within so many roundings
    near n (Colour r g b a) (Colour r' g' b' a') = (a, and (zipWith (\x y -> abs (x - y) <= n * 2 ** (-53) * y) [r, g, b] [r', g', b'])) `shouldBe` (a' :: Double, True)
