{-# LANGUAGE HexFloatLiterals #-}

-- | Triangles: examples, the laws, and meshes through which no ray slips.
module Dioptre.Geometry.TriangleSpec (spec) where

import Data.Foldable (for_)
import Dioptre.Geometry.Ray (ray)
import Dioptre.Geometry.Triangle
import Dioptre.Math.Vector (vector)
import Laws.Aim
import Laws.Shape
import Laws.Triangle
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck hiding (vector)

spec :: Spec
spec = do
  describe "triangle" $ do
    it "has the normal from which its corners turn counter-clockwise" $
      fmap (vector . triangleNormal) (triangle (Corners 0 (V3 2 0 0) (V3 0 3 0))) `shouldBe` Just (V3 0 0 1)
    it "may be very flat" $ fmap (vector . triangleNormal) (triangle (Corners 0 (V3 1 0 0) (V3 1 1e-15 0))) `shouldBe` Just (V3 0 0 1)
    it "may be very small, or very large" $
      [fmap (vector . triangleNormal) (triangle (Corners 0 (V3 a 0 0) (V3 0 a 0))) | a <- [1e-200, 1e-90, 1e90, 1e100]] `shouldBe` replicate 4 (Just (V3 0 0 1))
    prop "corners on one line make none" collinearCornersAreRefused

  describe "smoothTriangle" $
    it "has the flat normal where none is given, or zero" $ case triangle (Corners 0 (V3 2 0 0) (V3 0 3 0)) of
      Nothing -> expectationFailure "no triangle"
      Just t -> smoothTriangleNormals (smoothTriangle t (Corners Nothing (Just 0) (Just (V3 1 2 3))) (Corners 0 0 (V2 1 1))) `shouldBe` Corners (V3 0 0 1) (V3 0 0 1) (V3 1 2 3)

  describe "triangleParameters" $
    it "has the edges and corners, and nothing beyond" $ case triangle (Corners 0 (V3 4 0 0) (V3 0 4 0)) of
      Nothing -> expectationFailure "no triangle"
      Just t ->
        [(x, y) | x <- [-1 .. 5], y <- [-1 .. 5], triangleParameters 0 (V3 4 0 0) (V3 0 4 0) (triangleNormal t) (ray (V3 x y 3) (V3 0 0 (-1))) == [3]]
          `shouldBe` [(x, y) | x <- [0 .. 4], y <- [0 .. 4 - x]]

  describe "barycentric" $ do
    it "knows where a point of a needle is" $
      [barycentric 0 (V3 1 0 0) (V3 1 e 0) (V3 0.75 (e / 4) 0) | e <- [0x1p-9, 0x1p-20, 0x1p-27, 0x1p-40, 0x1p-49]] `shouldBe` replicate 5 (0.5, 0.25)
    it "knows it of the smallest and the largest triangles, and of those with one short edge" $
      [barycentric 0 (V3 a 0 0) (V3 0 b 0) (V3 (a / 2) (b / 4) 0) | (a, b) <- [(0x1p-600, 0x1p-600), (0x1p-300, 0x1p-300), (0x1p300, 0x1p300), (0x1p-300, 0x1p300), (1, 0x1p-500)]]
        `shouldBe` replicate 5 (0.5, 0.25)
    it "is 0 at the first corner, however thin the triangle" $
      barycentric (V3 1 1 1) (V3 2 1 1) (V3 2 (1 + 0x1p-45) 1) (V3 1 1 1) `shouldBe` (0, 0)
    prop "coordinates are near the exact ones in needles too" needlesAreNearExact
    it "counts along the two edges from the first corner" $
      [barycentric (V3 1 1 1) (V3 3 1 1) (V3 1 5 1) p | p <- [V3 1 1 1, V3 3 1 1, V3 1 5 1, V3 2 2 1]] `shouldBe` [(0, 0), (1, 0), (0, 1), (0.5, 0.25)]

  for_ [TriangleSort, SmoothTriangleSort] $ \sort -> modifyMaxSuccess (* 8) $
    describe ("as laws of " ++ show sort) $ do
      mapM_ (\(law, holds) -> prop law (forAllShrink (aimedAt sort) shrink holds)) lawsOfShapes
      prop "where nothing is rounded, nothing is left to rounding" $ forAll (crispAt sort) isExactWhereItCanBe
      prop "ray and shape moved together meet at the same parameters" $ forAll (crispAt sort) movedTogether
  describe "as laws of triangles" $ do
    modifyMaxSuccess (* 8) $ prop "the order of the corners does not matter" $ forAllShrink (aimedAt TriangleSort) shrink orderOfCornersDoesNotMatter
    prop "barycentric coordinates are near the exact ones" $ forAllShrink (aimedAt TriangleSort) shrink barycentricIsNearExact
    prop "a ray exactly in its plane misses it" (raysInSlantedPlanesMiss TriangleSort)

  describe "interpolatedNormal" $ do
    prop "is parallel to the exact mixture" interpolatedIsNearExact
    prop "is each corner's own there, and the flat one where normals cancel" interpolatesCorners

  modifyMaxSuccess (* 10) $
    describe "a closed mesh" $ do
      prop "lets no ray out: at corners, at edges, anywhere" meshIsWatertight
      prop "is crossed by every line on both sides of a point inside" meshIsCrossedOnBothSides
