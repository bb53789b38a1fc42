-- | Planes: examples, and the laws.
module Dioptre.Geometry.PlaneSpec (spec) where

import Dioptre.Geometry.Plane
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongZ)
import Laws.Aim
import Laws.Shape
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "plane" $ do
    it "has a normal of some length" $ do
      fmap planeNormal (plane 0 (V3 0 0 1e-10)) `shouldBe` Just (V3 0 0 1e-10)
      plane 0 (V3 0 0 9.9e-11) `shouldBe` Nothing
      plane 0 0 `shouldBe` Nothing

  describe "planeParameters" $ do
    -- z = 5 seen from z = 1, with a step of 2
    it "meets a plane across its way" $ planeParameters (V3 7 7 5) alongZ (ray (V3 0 0 1) (V3 1 0 2)) `shouldBe` [2]
    it "meets a plane behind its origin" $ planeParameters (V3 7 7 5) alongZ (ray (V3 0 0 1) (V3 1 0 (-2))) `shouldBe` [-2]
    it "does not meet a plane that it lies in, or beside" $
      [planeParameters (V3 0 0 z) alongZ (ray (V3 3 4 5) (V3 1 2 0)) | z <- [5, 6]] `shouldBe` [[], []]
    it "meets a plane at an angle above 2^-50 only" $
      [planeParameters 0 alongZ (ray (V3 0 0 1) (V3 0 1 (negate slope))) | slope <- [2 ** (-49), 2 ** (-50), 2 ** (-51)]] `shouldBe` [[2 ** 49], [], []]
    prop "a ray along a plane misses it, and everything in it" raysAlongMiss
    prop "a ray exactly in a slanted plane misses it, and everything in it" (raysInSlantedPlanesMiss PlaneSort)

  modifyMaxSuccess (* 8) $
    describe "as laws" $ do
      mapM_ (\(law, holds) -> prop law (forAllShrink (aimedAt PlaneSort) shrink holds)) lawsOfShapes
      prop "where nothing is rounded, nothing is left to rounding" $ forAll (crispAt PlaneSort) isExactWhereItCanBe
      prop "ray and shape moved together meet at the same parameters" $ forAll (crispAt PlaneSort) movedTogether
