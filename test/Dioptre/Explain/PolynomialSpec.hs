{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Dioptre.Explain.PolynomialSpec
-- Description : The equations told are those that are solved
module Dioptre.Explain.PolynomialSpec (spec) where

import Dioptre.Explain.Polynomial
import Dioptre.Explain.Story
import Dioptre.Geometry.Axis (axis, roundShape)
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (annulus, disk)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Ray (Ray, direction, origin, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Geometry.Torus (torus)
import Dioptre.Geometry.Triangle (Corners (..), triangle)
import Dioptre.Math.Transform (transform)
import Laws.Story
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage)

spec :: Spec
spec = do
  -- The values are worked out by hand.
  describe "known equations" $ do
    it "tells the handout's A and B of a plane" $
      told (APlane <$> plane 0 (V3 0 0 5)) (ray (V3 0 0 2) (V3 0.5 0 (-1))) `shouldBe` Just ([[-1, 2]], [(2, OtherConditions)])
    it "tells a plane along the ray as no equation's root" $
      told (APlane <$> plane 0 (V3 0 0 5)) (ray (V3 0 0 2) (V3 1 0 0)) `shouldBe` Just ([[0, 2]], [])
    it "tells how far outside of a disk the plane is met" $
      told (plane 0 (V3 0 0 1) >>= \p -> ADisk <$> disk p 1) (ray (V3 3 4 2) (V3 0 0 (-1))) `shouldBe` Just ([[-1, 2]], [(2, AwayFromCentre 5 1)])
    it "tells the hole of an annulus" $
      told (plane 0 (V3 0 0 1) >>= \p -> AnAnnulus <$> annulus p 6 7) (ray (V3 3 4 2) (V3 0 0 (-1))) `shouldBe` Just ([[-1, 2]], [(2, InTheHole 5 6)])
    it "tells both radii of an annulus between them" $
      told (plane 0 (V3 0 0 1) >>= \p -> AnAnnulus <$> annulus p 4 7) (ray (V3 3 4 2) (V3 0 0 (-1))) `shouldBe` Just ([[-1, 2]], [(2, OnTheRing 5 4 7)])
    it "tells A, B, C and both roots of a sphere" $
      told (ASphere <$> sphere (V3 5 0 0) 1) (ray 0 (V3 1 0 0)) `shouldBe` Just ([[1, -10, 24]], [(4, OtherConditions), (6, OtherConditions)])
    it "tells the discriminant of a sphere" $
      [d | Just (e, _) <- [equation (ASphere <$> sphere (V3 5 0 0) 1) (ray 0 (V3 1 0 0))], PolynomialIsZero _ _ _ d _ <- equationConditions e] `shouldBe` [Just 4]
    it "tells the coordinates in a triangle" $
      told (ATriangle <$> triangle (Corners 0 (V3 2 0 0) (V3 0 2 0))) (ray (V3 4 1 3) (V3 0 0 (-1))) `shouldBe` Just ([[-1, 3]], [(3, Barycentric 2 0.5)])
    it "tells the three slabs of a cube" $
      told (ACube <$> cube 0 2) (ray (V3 (-3) 0.5 0) (V3 1 0 2)) `shouldBe` Just ([[1, -3, -1, 1], [0, 0.5, -1, 1], [2, 0, -1, 1]], map (,OtherConditions) [2, 4, -0.5, 0.5])
    it "tells the tube and its ends" $
      told (axis 0 (V3 0 0 4) >>= \a -> ATube <$> roundShape a 1) (ray (V3 (-3) 0 9) (V3 1 0 0)) `shouldBe` Just ([[1, -6, 8]], [(2, AtHeight 9 4), (4, AtHeight 9 4)])
    it "tells the length of an axis however short it is" $
      told (axis 0 (V3 0 0 1e-165) >>= \a -> ACylinder <$> roundShape a 1) (ray 0 (V3 0 0 2)) `shouldBe` Just ([[0, 0, -1], [2, 0, 0, 1e-165]], [(0, OtherConditions), (5e-166, OtherConditions)])
    it "tells the four roots of a torus" $
      fmap snd (told (plane 0 (V3 0 0 1) >>= \p -> ATorus <$> torus p 2 1) (ray (V3 (-10) 0 0) (V3 1 0 0))) `shouldBe` Just (map (,OtherConditions) [7, 9, 11, 13])
    it "tells by how much a line misses a torus" $
      fmap (equationConditions . fst) (equation (plane 0 (V3 0 0 1) >>= \p -> ATorus <$> torus p 2 1) (ray (V3 (-10) 0 5) (V3 1 0 0))) `shouldBe` Just [PassesNear 5 3]
    it "tells the ray in the frame of a transformed shape" $
      fmap (\(e, _) -> [(origin r, direction r) | Just r <- [equationRay e]]) (equation (ATransformed <$> transform 2 0 (V3 1 0 0) <*> (ASphere <$> sphere 0 1)) (ray (V3 (-3) 0 0) (V3 1 0 0)))
        `shouldBe` Just [(V3 (-2) 0 0, V3 0.5 0 0)]
  describe "the laws of equations" . modifyMaxSuccess (const 60) $ do
    prop "every parameter of the renderer is a root that is told" parametersAreRoots
    prop "so it is where the ends of an axis are very near" (checkCoverage parametersOfShortAxesAreRoots)
    prop "every root that is told solves its equation" rootsSolve

equation :: Maybe Shape -> Ray -> Maybe (Equation, [Candidate])
equation shape r = (\s -> equationOf [] s r) <$> shape

-- | The coefficients of the conditions (of a slab: rate, start, low, high), and the roots, with what is told of those
-- that are not on the shape.
told :: Maybe Shape -> Ray -> Maybe ([[Double]], [(Double, Measure)])
told shape r = (\(e, candidates) -> (map numbers (equationConditions e), [(t, c) | Candidate t _ c <- candidates])) <$> equation shape r
  where
    numbers condition = case condition of
      PolynomialIsZero _ cs _ _ _ -> [x | Coefficient _ _ x <- cs]
      LiesBetween _ (Coefficient _ _ a) (Coefficient _ _ b) low high -> [a, b, low, high]
      PassesNear away reach -> [away, reach]
