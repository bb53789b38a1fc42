-- |
-- Module      : Dioptre.Geometry.CylinderSpec
-- Description : The cylinder: examples, and the laws of all closed shapes around an axis
module Dioptre.Geometry.CylinderSpec (spec) where

import Dioptre.Geometry.Axis (axis, axisLength)
import Dioptre.Geometry.Cylinder
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongX, alongZ, opposite)
import Laws.Round
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  describe "axisLength" $
    -- The square of 1e-170 is zero, as it is computed.
    it "is the distance, however near the points are" $
      map (\x -> axisLength <$> axis 0 (V3 0 0 x)) [0, 1e-300, 1e-170, 1e-120, 1, 1e100] `shouldBe` [Nothing, Just 1e-300, Just 1e-170, Just 1e-120, Just 1, Just 1e100]

  describe "cylinderParameters" $ do
    it "goes through the side" $ upright (V3 (-3) 0 1) (V3 1 0 0) `shouldBe` [2, 4]
    it "goes through both ends" $ upright (V3 0.5 0 5) (V3 0 0 (-1)) `shouldBe` [3, 5]
    it "goes through an end and the side" $ upright (V3 (-3) 0 0.5) (V3 2 0 1) `shouldBe` [1, 1.5]
    it "has a ray along its surface" $ upright (V3 1 0 5) (V3 0 0 (-1)) `shouldBe` [3, 5]
    it "has a ray in an end plane" $ upright (V3 (-3) 0 2) (V3 1 0 0) `shouldBe` [2, 4]
    it "has a ray from rim to rim" $ upright (V3 (-2) 0 (-1)) (V3 1 0 1) `shouldBe` [1, 3]
    it "has a ray that touches a rim" $ upright (V3 (-1) 0 3) (V3 1 0 (-1)) `shouldBe` [1, 2]
    it "has a tangent" $ upright (V3 (-3) 1 2) (V3 1 0 0) `shouldBe` [3, 3]
    it "ends at its ends" $ map (\z -> upright (V3 (-3) 0 z) (V3 1 0 0)) [-0.001, 2.001] `shouldBe` [[], []]

  describe "cylinderNormal" $ do
    it "is the tube's on the side" $ normal (V3 3 0 1) (V3 (-1) 0 0) 2 `shouldBe` alongX
    it "is the axis at the far end" $ normal (V3 0.5 0 5) (V3 0 0 (-1)) 3 `shouldBe` alongZ
    it "is the axis' opposite at the near end" $ normal (V3 0.5 0 5) (V3 0 0 (-1)) 5 `shouldBe` opposite alongZ
    it "is the tube's on a rim" $ normal (V3 3 0 2) (V3 (-1) 0 0) 2 `shouldBe` alongX

  describe "cylinderContains" $ do
    it "has the middle of its axis" $ cylinderContains 0 alongZ 2 1 (V3 0 0 1) `shouldBe` True
    it "has no point of its surface" $
      map (cylinderContains 0 alongZ 2 1) [V3 1 0 1, V3 0 0 0, V3 0 0 2, V3 0.6 0.8 1] `shouldBe` [False, False, False, False]
    it "tells by one part in ten million, and by 1e-10 at the ends" $
      map (cylinderContains 0 alongZ 2 1) [V3 (1 - 2e-7) 0 1, V3 (1 - 5e-8) 0 1, V3 0 0 2e-10, V3 0 0 5e-11] `shouldBe` [True, False, True, False]
    prop "has the tube's parameters on its side" cylinderHasTubesParameters

  describe "Bars, cylinders, cones and lenses" . modifyMaxSuccess (const 1000) $ do
    prop "are entered and left by turns" isAscendingInPairs
    prop "are met in one interval, if they are convex" isConvex
    prop "are where their definition says" agreesWithDefinition
    prop "are entered and left on their surface" liesOnSurface
    prop "let no ray slip into them" hitsWhatItIsAimedAt
    prop "have unit normals" hasUnitNormals
    prop "have normals that point outwards" hasOutwardNormals
    prop "have normals along their gradients" hasNormalsOfItsParts
    prop "contain their inside and nothing else" containsOnlyItsInside
    prop "do not contain their surface" doesNotContainItsSurface
    prop "move with their ray, bit for bit" movesAlong
    prop "turn with their ray, bit for bit" turnsAlong
    prop "grow with their ray, bit for bit" scalesAlong
    prop "have parameters that count lengths of the direction" stretchesWithDirection
    prop "are the same from the other side, bit for bit" reverses
  where
    upright o d = cylinderParameters 0 alongZ 2 1 (ray o d)
    normal o d = cylinderNormal 0 alongZ 2 1 (ray o d)
