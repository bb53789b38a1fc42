-- |
-- Module      : Dioptre.Geometry.BoundsSpec
-- Description : Boxes around shapes: examples by hand, and the laws
module Dioptre.Geometry.BoundsSpec (spec) where

import Dioptre.Geometry.Bounds
import Dioptre.Geometry.Box
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (annulus)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Math.Transform (transform)
import Dioptre.Math.Vector (Point, alongZ)
import Laws.Bounds
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
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
      (ATransformed <$> transform (V3 2 1 1) (V3 0 0 90) (V3 10 0 0) <*> (ACube <$> cube 0 2)) `shouldSatisfy` maybe False (maybe False (enlargedTo 2 (V3 9 (-2) (-1)) (V3 11 2 1)) . ofShape)
    it "is none for a plane, transformed or not" $ do
      let ground = APlane <$> plane 0 (V3 0 0 1)
      map (fmap ofShape) [ground, ATransformed <$> transform (V3 2 1 1) 0 0 <*> ground] `shouldBe` [Just Nothing, Just Nothing]

  describe "as laws" $ do
    modifyMaxSuccess (* 10) $ do
      prop "the box of a shape holds its points" holdsItsShape
      prop "and ends where the shape does" isTight
      prop "hits, as computed, are in the box" holdsHits
      prop "hits of shapes of all sorts, as computed, are in the box" holdsHitsOfShapes
  where
    boxed low high shape = maybe False (fits low high) (shape >>= ofShape)

-- | Whether a box is this one, but for the slack of 'enlarged', 2^-20 of its longest edge: once, or for a shape that is
-- transformed, twice. (And 2^-48 of its largest coordinate; the same again is for roundings.)
fits :: Point -> Point -> Box -> Bool
fits = enlargedTo 1

enlargedTo :: Double -> Point -> Point -> Box -> Bool
enlargedTo times low high b = and (close <$> boxLow b <*> low) && and (close <$> high <*> boxHigh b)
  where
    close x y = x <= y && y - x <= times * 2 ** (-20) * longest + 2 ** (-47) * farthest
    longest = maximum (boxHigh b - boxLow b)
    farthest = maximum (max <$> fmap abs (boxLow b) <*> fmap abs (boxHigh b))
