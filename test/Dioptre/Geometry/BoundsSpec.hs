-- |
-- Module      : Dioptre.Geometry.BoundsSpec
-- Description : Boxes along the axes: examples by hand, and the laws
module Dioptre.Geometry.BoundsSpec (spec) where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Bounds
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (annulus)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Math.Transform (transform)
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

  describe "ofShape" $ do
    it "is that of the sphere, where it stands" $ fmap ofShape (ASphere <$> sphere (V3 1 2 3) 2) `shouldBe` Just (Just (ofSphere (V3 1 2 3) 2))
    it "is half the size to each side of a cube's centre" $ (ACube <$> cube (V3 1 2 3) 4) `shouldSatisfy` boxed (V3 (-1) 0 1) (V3 3 4 5)
    it "reaches to the outer rim of an annulus" $ (plane 0 (V3 0 0 5) >>= \p -> AnAnnulus <$> annulus p 1 2) `shouldSatisfy` boxed (V3 (-2) (-2) 0) (V3 2 2 0)
    it "turns with a transformed shape" $
      -- A cube of size 2, twice as long, a quarter turn about z, and 10 along x
      (ATransformed <$> transform (V3 2 1 1) (V3 0 0 90) (V3 10 0 0) <*> (ACube <$> cube 0 2)) `shouldSatisfy` boxed (V3 9 (-2) (-1)) (V3 11 2 1)
    it "is none for a plane, transformed or not" $ do
      let ground = APlane <$> plane 0 (V3 0 0 1)
      map (fmap ofShape) [ground, ATransformed <$> transform (V3 2 1 1) 0 0 <*> ground] `shouldBe` [Just Nothing, Just Nothing]

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
      prop "the box of a shape holds its points" holdsItsShape
      prop "and ends where the shape does" isTight
      prop "hits, as computed, are in the box" holdsHits
      prop "hits of shapes of all sorts, as computed, are in the box" holdsHitsOfShapes
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
    boxed low high shape = maybe False (fits low high) (shape >>= ofShape)

-- | Whether a box is this one, but for a slack of a few millionths.
fits :: Point -> Point -> Box -> Bool
fits low high b = and (close <$> boxLow b <*> low) && and (close <$> high <*> boxHigh b)
  where
    close x y = x <= y && y - x < 1e-5
