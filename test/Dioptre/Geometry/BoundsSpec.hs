-- |
-- Module      : Dioptre.Geometry.BoundsSpec
-- Description : Boxes along the axes: examples by hand, and the laws
module Dioptre.Geometry.BoundsSpec (spec) where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Bounds
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Math.Vector (Point, alongZ)
import Laws.Bounds
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "box" $ do
    it "refuses corners out of order" $ box 0 (V3 1 (-1) 1) `shouldBe` Nothing
    it "takes a single point" $ fmap boxCentre (box (V3 1 2 3) (V3 1 2 3)) `shouldBe` Just (V3 1 2 3)
    it "knows its area" $ boxArea (ofPoints 0 [V3 1 2 3]) `shouldBe` 22

  describe "of shapes" $ do
    it "is flat, but for its slack, around a disk across an axis" $
      ofDisk 0 alongZ 1 `shouldSatisfy` fits (V3 (-1) (-1) 0) (V3 1 1 0)
    it "spares the hole of no torus, and is flat" $ ofTorus (V3 1 2 3) alongZ 2 0.5 `shouldSatisfy` fits (V3 (-1.5) (-0.5) 2.5) (V3 3.5 4.5 3.5)
    it "holds the top of a cap" $ ofCap 0 alongZ 1 2 `shouldSatisfy` fits (V3 (-1) (-1) 0) (V3 1 1 (2 - sqrt 3))
    it "holds the bottom of a cap" $ ofCap 0 alongZ 1 (-2) `shouldSatisfy` fits (V3 (-1) (-1) (sqrt 3 - 2)) (V3 1 1 0)
    it "holds the bulges of a lens, and not what is hollow" $ ofLens 0 (V3 0 0 1) 1 (1, -2) `shouldSatisfy` fits (V3 (-1) (-1) (-1)) (V3 1 1 1)

  describe "entry" $ do
    it "is where the ray comes in" $ entryOf (ray (V3 (-3) 0 0) (V3 2 0 0)) `shouldSatisfy` (\t -> t <= 1 && t > 1 - 1e-14)
    it "is 0 inside" $ entryOf (ray 0 (V3 1 2 3)) `shouldBe` 0
    it "is infinite beside" $ entryOf (ray (V3 (-3) 1.5 0) (V3 1 0 0)) `shouldBe` 1 / 0
    it "is infinite behind" $ entryOf (ray (V3 3 0 0) (V3 1 0 0)) `shouldBe` 1 / 0
    it "is infinite beyond the bound" $ entry (approach (ray (V3 (-3) 0 0) (V3 1 0 0))) unitBox 1.5 `shouldBe` 1 / 0
    it "takes a ray that runs in a face" $ entryOf (ray (V3 (-3) 1 0) (V3 1 0 0)) `shouldSatisfy` (not . isInfinite)
    it "takes a ray that runs in an edge, whatever the sign of zero" $ entryOf (ray (V3 (-3) 1 (-1)) (V3 1 0 (-0.0))) `shouldSatisfy` (not . isInfinite)

  describe "as laws" $ do
    modifyMaxSuccess (* 10) $ do
      prop "corners are in order" isOrdered
      prop "union is commutative, associative and idempotent" unionIsASemilattice
      prop "union holds both" unionHoldsBoth
      prop "a transformed box holds the transformed points" transformedHolds
      prop "the box of a shape holds its points" holdsItsShape
      prop "and ends where the shape does" isTight
      prop "hits, as computed, are in the box" holdsHits
    modifyMaxSuccess (* 50) $ do
      prop "a ray never misses a box that it meets exactly" neverMissesWhatItHolds
      prop "and meets no other, but for rounding" agreesWithTheExactAnswer

  it "is tried in all its corners by these laws" $
    checkCoverage $ \a -> foldr (\(name, holds) -> cover 0.1 holds name) (property True) (corners a)
  where
    unitBox = fromMaybe (ofPoints 0 []) (box (V3 (-1) (-1) (-1)) (V3 1 1 1))
    entryOf :: Ray -> Double
    entryOf r = entry (approach r) unitBox 1000

-- | Whether a box is this one, but for a slack of a few millionths.
fits :: Point -> Point -> Box -> Bool
fits low high b = and (close <$> boxLow b <*> low) && and (close <$> high <*> boxHigh b)
  where
    close x y = x <= y && y - x < 1e-5
