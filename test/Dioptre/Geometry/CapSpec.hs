-- |
-- Module      : Dioptre.Geometry.CapSpec
-- Description : The spherical cap: examples and laws
module Dioptre.Geometry.CapSpec (spec) where

import Dioptre.Geometry.Cap
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongZ)
import Laws.Draw (ulpsApart)
import Laws.Round
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "capParameters" $ do
    -- 2 - sqrt 3, as the original computes it; one ulp from the nearest double.
    it "has the height 2 - sqrt 3 for c = 2, R = 1" $ upright 2 0 (V3 0 0 1) `shouldSatisfy` all ((<= 2) . ulpsApart 0.2679491924311228)
    it "is as deep for c = -2" $ upright (-2) 0 (V3 0 0 1) `shouldBe` map negate (upright 2 0 (V3 0 0 1))
    it "is met once by a ray through its middle" $ length (upright 2 0 (V3 0 0 1)) `shouldBe` 1
    it "is half a sphere for c = R" $ upright 1 (V3 (-2) 0 0.5) (V3 1 0 0) `shouldSatisfy` ((== 2) . length)
    it "has the rim" $ upright 1 (V3 (-2) 0 0) (V3 1 0 0) `shouldBe` [1, 3]
    it "has nothing behind its disk" $ upright 1 (V3 (-2) 0 (-0.5)) (V3 1 0 0) `shouldBe` []
    it "is almost its disk for a huge c" $ upright 1e9 (V3 0.5 0 3) (V3 0 0 (-1)) `shouldSatisfy` all (\t -> abs (t - (3 - 0.75 / 2e9)) < 1e-15)
    prop "is on its sphere, and not behind its disk" capLiesOnSphere
    prop "is met between a point inside the sphere and one outside" capCrossesWhereItChanges

  describe "capNormal" $ do
    it "is the disk's at the top" $ capNormal 0 alongZ 1 2 (V3 0 0 0.25) `shouldBe` alongZ
    it "is the disk's at the bottom of a hollow one" $ capNormal 0 alongZ 1 (-2) (V3 0 0 (-0.25)) `shouldBe` alongZ
    prop "is unit, and points away from the centre, or to it if hollow" capNormalPointsOut

  describe "centreDepth" $ do
    it "is the third side of a triangle" $ centreDepth 3 5 `shouldBe` 4
    it "has the sign of c" $ centreDepth 3 (-5) `shouldBe` -4
  where
    upright c o d = capParameters 0 alongZ 1 c (ray o d)
