-- |
-- Module      : Dioptre.Geometry.TubeSpec
-- Description : The tube: examples and laws
module Dioptre.Geometry.TubeSpec (spec) where

import Dioptre.Geometry.Ray (ray)
import Dioptre.Geometry.Tube
import Dioptre.Math.Vector (alongX, alongY, alongZ, opposite)
import Laws.Round
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "tubeParameters" $ do
    it "enters and leaves a tube across its axis" $ upright 2 1 (V3 (-3) 0 1) (V3 1 0 0) `shouldBe` [2, 4]
    it "counts parameters in lengths of the direction" $ upright 2 1 (V3 (-3) 0 1) (V3 2 0 0) `shouldBe` [1, 2]
    it "gives what lies behind the origin" $ upright 2 1 (V3 0 0 1) (V3 0 1 0) `shouldBe` [-1, 1]
    it "is open at its ends" $ upright 2 1 (V3 (-3) 0 0.5) (V3 2 0 1) `shouldBe` [1]
    it "has its ends" $ map (\z -> upright 2 1 (V3 (-3) 0 z) (V3 1 0 0)) [0, 2] `shouldBe` [[2, 4], [2, 4]]
    it "ends there" $ map (\z -> upright 2 1 (V3 (-3) 0 z) (V3 1 0 0)) [-0.001, 2.001] `shouldBe` [[], []]
    it "is met once, twice over, by a tangent" $ upright 2 1 (V3 (-3) 1 1) (V3 1 0 0) `shouldBe` [3, 3]
    it "is not met along its axis, inside, outside or in the surface" $
      map (\x -> upright 2 1 (V3 x 0 (-3)) (V3 0 0 1)) [0, 1, 2] `shouldBe` [[], [], []]
    prop "has those parameters of the infinite tube that are between the ends" tubeIsPartOfLine
    prop "is met between a point inside and one outside" tubeCrossesWhereItChanges

  describe "tubeLineParameters" $ do
    it "has no ends" $ tubeLineParameters 0 alongZ 1 (ray (V3 (-3) 0 100) (V3 1 0 0)) `shouldBe` [2, 4]
    it "is a line for radius 0" $ tubeLineParameters 0 alongZ 0 (ray (V3 (-3) 0 1) (V3 1 0 0)) `shouldBe` [3, 3]

  describe "tubeNormal" $ do
    it "points away from the axis" $ tubeNormal 0 alongZ (V3 2 0 7) `shouldBe` alongX
    it "is the same on the other side" $ tubeNormal 0 alongZ (V3 0 (-2) 7) `shouldBe` opposite alongY
  where
    upright h radius o d = tubeParameters 0 alongZ h radius (ray o d)
