-- |
-- Module      : Dioptre.Geometry.BoxSpec
-- Description : Boxes along the axes: examples by hand, and the laws
module Dioptre.Geometry.BoxSpec (spec) where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Box
import Dioptre.Geometry.Ray (Ray, ray)
import Laws.Bounds
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "box" $ do
    it "refuses corners out of order" $ box 0 (V3 1 (-1) 1) `shouldBe` Nothing
    it "takes a single point" $ fmap (\b -> (boxLow b, boxHigh b)) (box (V3 1 2 3) (V3 1 2 3)) `shouldBe` Just (V3 1 2 3, V3 1 2 3)

  describe "meets" $ do
    it "is so where the ray comes in before the bound" $ map (meetsUnit (ray (V3 (-3) 0 0) (V3 2 0 0))) [1 / 0, 1, 0.999] `shouldBe` [True, True, False]
    it "is so inside" $ map (meetsUnit (ray 0 (V3 1 2 3))) [1 / 0, 0] `shouldBe` [True, True]
    it "is not beside" $ meetsUnit (ray (V3 (-3) 1.5 0) (V3 1 0 0)) (1 / 0) `shouldBe` False
    it "is not past a corner, where each two intervals but one overlap" $ meetsUnit (ray (V3 (-3) 0 0) (V3 2 3 1)) (1 / 0) `shouldBe` False
    it "is not behind" $ meetsUnit (ray (V3 3 0 0) (V3 1 0 0)) (1 / 0) `shouldBe` False
    it "takes a ray that runs in a face" $ meetsUnit (ray (V3 (-3) 1 0) (V3 1 0 0)) 1000 `shouldBe` True
    it "takes a ray that runs in an edge, whatever the sign of zero" $
      [meetsUnit (ray (V3 (-3) y z) (V3 1 j k)) 1000 | y <- [1, -1], z <- [1, -1], j <- [0, -0.0], k <- [0, -0.0]] `shouldSatisfy` and

  describe "as laws" $ do
    modifyMaxSuccess (* 10) $ do
      prop "corners are in order" isOrdered
      prop "union is commutative, associative and idempotent" unionIsASemilattice
      prop "union holds both" unionHoldsBoth
      prop "a transformed box holds the transformed points" transformedHolds
    modifyMaxSuccess (* 50) $ do
      prop "a ray never misses a box that it meets exactly" neverMissesWhatItHolds
      prop "and meets no other, but for rounding" agreesWithTheExactAnswer
      prop "a ray without length meets the boxes that hold its origin" goesNowhereWithoutLength
      prop "a ray runs down where its direction is negative" knowsItsFirstFaces

  it "is tried in all its corners by these laws" $
    checkCoverage $ \a -> foldr (\(name, holds) -> cover 0.1 holds name) (property True) (corners a)
  where
    unitBox = fromMaybe (ofPoints 0 []) (box (V3 (-1) (-1) (-1)) (V3 1 1 1))
    meetsUnit :: Ray -> Double -> Bool
    meetsUnit r = meets (approach r) (boxFace unitBox)
