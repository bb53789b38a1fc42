-- |
-- Module      : Dioptre.Geometry.LensSpec
-- Description : The lens: examples
--
-- The laws of all closed shapes around an axis are in "Dioptre.Geometry.CylinderSpec".
module Dioptre.Geometry.LensSpec (spec) where

import Dioptre.Geometry.Lens
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongX, alongZ, opposite)
import Laws.Round
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "lensParameters" $ do
    it "goes through two bulging faces" $ through 1 1 2 2 (V3 0 0 (-3)) (V3 0 0 1) `shouldBeNear` [3 - bulge, 4 + bulge]
    it "goes through two hollow faces" $ through 1 1 (-2) (-2) (V3 0 0 (-3)) (V3 0 0 1) `shouldBeNear` [3 + bulge, 4 - bulge]
    it "goes through a meniscus" $ through 1 1 (-2) 2 (V3 0 0 (-3)) (V3 0 0 1) `shouldBeNear` [3 + bulge, 4 + bulge]
    it "goes through the side" $ through 1 1 2 2 (V3 (-3) 0 0.5) (V3 1 0 0) `shouldBe` [2, 4]
    it "is half balls around a cylinder for |c| = R" $ through 1 1 1 1 (V3 0 0 (-3)) (V3 0 0 1) `shouldBe` [2, 5]
    it "goes twice through a lens with two hollow faces, in and out of a hollow" $
      through 2 4 (-5) (-5) (V3 (-10) 0 0.5) (V3 1 0 0) `shouldSatisfy` ((== 4) . length)
    -- On the meridian the hollows are z < sqrt (64 - x^2) - sqrt 48 and its mirror image in z = 1.5. At x = -4, -3, 3,
    -- 4 the line has z = 0.06, 0.42, 2.58, 2.94, and the hollows begin at 0, 0.49, 2.51, 3.
    it "goes three times through one, if it crosses both hollows" $
      through 3 4 (-8) (-8) (V3 0 0 1.5) (V3 1 0 0.36) `shouldSatisfy` ((== 6) . length)
    it "has its rim" $ through 1 1 2 2 (V3 (-3) 0 0) (V3 1 0 0) `shouldBe` [2, 4]
    prop "meets its caps on its surface, or outside of it" capsAreOnLens

  describe "lensNormal" $ do
    it "points outwards on a bulging face" $ atMiddle 2 2 `shouldBe` [opposite alongZ, alongZ]
    it "points outwards on a hollow face" $ atMiddle (-2) (-2) `shouldBe` [opposite alongZ, alongZ]
    it "is the tube's on the side" $ lensNormal 0 alongZ 1 1 2 2 (ray (V3 (-3) 0 0.5) (V3 1 0 0)) 4 `shouldBe` alongX
    it "is the tube's on the rim" $ lensNormal 0 alongZ 1 1 2 2 (ray (V3 (-3) 0 0) (V3 1 0 0)) 4 `shouldBe` alongX

  describe "lensContains" $ do
    it "has its middle" $ map (\c -> lensContains 0 alongZ 1 1 c c (V3 0 0 0.5)) [1, 2, -2] `shouldBe` [True, True, True]
    it "has what a bulge adds" $ map (\c -> lensContains 0 alongZ 1 1 c c (V3 0 0 1.2)) [1, 2, -2] `shouldBe` [True, True, False]
    it "has not what a hollow takes" $ map (\c -> lensContains 0 alongZ 1 1 c c (V3 0 0 0.9)) [1, 2, -2] `shouldBe` [True, True, False]
    it "has no point of its side" $ lensContains 0 alongZ 1 1 2 2 (V3 1 0 0.5) `shouldBe` False
  where
    bulge = 0.2679491924311227
    through l radius c1 c2 o d = lensParameters 0 alongZ l radius c1 c2 (ray o d)
    atMiddle c1 c2 = let r = ray (V3 0 0 (-3)) (V3 0 0 1) in map (lensNormal 0 alongZ 1 1 c1 c2 r) (lensParameters 0 alongZ 1 1 c1 c2 r)

-- | As many numbers, each within 4 ulp of 4.
shouldBeNear :: [Double] -> [Double] -> Expectation
shouldBeNear got wanted = got `shouldSatisfy` \ts -> length ts == length wanted && and (zipWith (\x y -> abs (x - y) <= 2 ** (-48)) ts wanted)
