-- | Spheres: examples, and the laws.
module Dioptre.Geometry.SphereSpec (spec) where

import Dioptre.Geometry.Ray (ray)
import Dioptre.Geometry.Sphere
import Dioptre.Math.Vector (alongZ, vector)
import Laws.Aim
import Laws.Shape
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck hiding (vector)

spec :: Spec
spec = do
  describe "sphere" $
    it "has a size" $ do
      fmap sphereRadius (sphere 0 2) `shouldBe` Just 2
      [sphere 0 r | r <- [0, -1, 0 / 0]] `shouldBe` [Nothing, Nothing, Nothing]

  describe "sphereParameters" $ do
    it "enters and leaves" $ sphereParameters (V3 5 0 0) 4 (ray 0 (V3 1 0 0)) `shouldBe` [3, 7]
    it "is also behind" $ sphereParameters (V3 5 0 0) 4 (ray (V3 6 0 0) (V3 2 0 0)) `shouldBe` [-1.5, 0.5]
    it "is touched by a tangent, twice" $ sphereParameters (V3 5 0 0) 4 (ray (V3 0 2 0) (V3 1 0 0)) `shouldBe` [5, 5]
    -- From beside the sphere, where the distance is not rounded away: 2 + 2^-51 is the next number after 2
    it "is missed beside the tangent" $ sphereParameters (V3 5 0 0) 4 (ray (V3 5 2.0000000000000004 0) (V3 1 0 0)) `shouldBe` []

  describe "sphereNormal" $ do
    it "points from the centre" $ vector (sphereNormal (V3 1 1 1) (V3 1 4 (-3))) `shouldBe` V3 0 0.6 (-0.8)
    it "is the z axis at the centre" $ sphereNormal (V3 1 1 1) (V3 1 1 1) `shouldBe` alongZ

  modifyMaxSuccess (* 8) $
    describe "as laws" $ do
      mapM_ (\(law, holds) -> prop law (forAllShrink (aimedAt SphereSort) shrink holds)) lawsOfShapes
      prop "where nothing is rounded, nothing is left to rounding" $ forAll (crispAt SphereSort) isExactWhereItCanBe
      prop "ray and shape moved together meet at the same parameters" $ forAll (crispAt SphereSort) movedTogether
      prop "a line meets it in an interval: inside between, outside beyond" $ forAllShrink (aimedAt SphereSort) shrink meetsInAnInterval
      prop "where it is clearly missed, no parameter is found" $ forAllShrink (aimedAt SphereSort) shrink clearlyMissedIsMissed
      prop "it contains the points that are inside" $ forAllShrink (aimedAt SphereSort) shrink containsItsInside
      prop "it does not contain its surface" $ forAll (crispAt SphereSort) doesNotContainItsSurface
