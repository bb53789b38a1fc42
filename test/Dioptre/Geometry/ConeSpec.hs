-- |
-- Module      : Dioptre.Geometry.ConeSpec
-- Description : The cone: examples, and its double
--
-- The laws of all closed shapes around an axis are in "Dioptre.Geometry.CylinderSpec".
module Dioptre.Geometry.ConeSpec (spec) where

import Dioptre.Geometry.Cone
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongZ, dot, opposite, vector)
import Laws.Round
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "coneParameters" $ do
    it "goes through the curved part" $ upright (V3 (-2) 0 0.5) (V3 1 0 0) `shouldBe` [1.5, 2.5]
    it "goes through apex and base" $ upright (V3 0 0 5) (V3 0 0 (-1)) `shouldBe` [4, 5]
    it "goes through apex and base the other way" $ upright (V3 0 0 (-5)) (V3 0 0 1) `shouldBe` [5, 6]
    it "goes through the apex, inclined" $ upright (V3 0.5 0 2) (V3 (-0.5) 0 (-1)) `shouldBe` [1, 2]
    it "has a ray that only touches its apex" $ upright (V3 (-2) 0 1) (V3 1 0 0) `shouldBe` [2, 2]
    it "has a ray along its surface" $ upright (V3 2 0 (-1)) (V3 (-1) 0 1) `shouldBe` [1, 2]
    it "has a ray parallel to its surface, inside" $ upright (V3 1 0 (-0.5)) (V3 (-1) 0 1) `shouldBe` [0.5, 1.25]
    it "has a ray in its base" $ upright (V3 (-2) 0 0) (V3 1 0 0) `shouldBe` [1, 3]
    it "is not there beyond its apex" $ upright (V3 (-2) 0 1.5) (V3 1 0 0) `shouldBe` []
    it "is not there beyond its base" $ upright (V3 (-2) 0 (-0.001)) (V3 1 0 0) `shouldBe` []
    it "finds its apex from afar" $ length (upright (V3 1000 2000 12346) (V3 (-1000) (-2000) (-12345))) `shouldBe` 2

  describe "coneNormal" $ do
    it "is the axis' opposite on the base" $ normal (V3 0 0 5) (V3 0 0 (-1)) 5 `shouldBe` opposite alongZ
    it "is the axis at the apex" $ normal (V3 0 0 5) (V3 0 0 (-1)) 4 `shouldBe` alongZ
    it "is inclined as the surface is" $ dot (vector (normal (V3 (-2) 0 0.5) (V3 1 0 0) 1.5)) (V3 (-1) 0 1) `shouldSatisfy` (\x -> abs (x - sqrt 2) < 1e-15)
    it "is the curved part's on the rim" $ vector (normal (V3 (-2) 0 0) (V3 1 0 0) 1) `shouldSatisfy` (\(V3 x _ z) -> x < -0.7 && z > 0.7)

  describe "coneContains" $ do
    it "has what is nearer to the axis than its surface" $
      map (coneContains 0 alongZ 1 1) [V3 0 0 0.5, V3 (0.5 - 1e-7) 0 0.5, V3 (0.5 - 2e-8) 0 0.5, V3 0.5 0 0.5] `shouldBe` [True, True, False, False]
    it "has neither apex nor base" $ map (coneContains 0 alongZ 1 1) [V3 0 0 1, V3 0 0 0, V3 0 0 1.5] `shouldBe` [False, False, False]

  describe "conesParameters" $ do
    it "crosses one cone" $ double (V3 (-2) 0 0) (V3 1 0 0) `shouldBe` [1, 3]
    it "crosses both" $ double (V3 0.5 0 0) (V3 0 0 1) `shouldBe` [0.5, 1.5]
    it "crosses the apex, twice at once" $ double (V3 0 0 5) (V3 0 0 (-1)) `shouldBe` [4, 4]
    it "crosses once, along the surface's direction" $ double (V3 1 0 (-0.5)) (V3 (-1) 0 1) `shouldBe` [1.25]
    it "has no isolated parameter in the surface" $ double (V3 2 0 (-1)) (V3 (-1) 0 1) `shouldBe` []
    it "is nothing without an axis" $ conesParameters 1 1 1 (ray 0 (V3 1 0 0)) `shouldBe` []
    prop "has the parameters of the cone, to the rounding of nearly double roots" conesContainCone
    it "has the exact number of parameters, for coordinates of few digits" conesAreExact
  where
    upright o d = coneParameters 0 alongZ 1 1 (ray o d)
    normal o d = coneNormal 0 alongZ 1 1 (ray o d)
    double o d = conesParameters 0 (V3 0 0 1) 1 (ray o d)
