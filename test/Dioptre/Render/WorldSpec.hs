{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -O2 #-}

-- | The closest hit: the laws, and the cost.
--
-- Optimised, whatever the rest of the tests is, since one of the examples measures what the optimiser leaves to
-- allocate.
module Dioptre.Render.WorldSpec (spec) where

import Control.Exception (evaluate)
import Data.Foldable (for_)
import Data.Int (Int64)
import Data.Maybe (fromMaybe, mapMaybe)
import Dioptre.Geometry.Closest (Closest (..))
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (annulus, disk)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Prepared (Prepared, parameters)
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Geometry.Triangle (Corners (..), triangle)
import Dioptre.Math.Transform (identity, transform)
import Dioptre.Render.Closest (closest)
import Dioptre.Render.Surface (surfaceAt)
import Dioptre.Render.World
import Laws.Closest
import Laws.Mesh (meshOf)
import Laws.World
import Linear.V3 (V3 (..))
import System.Mem (getAllocationCounter, setAllocationCounter)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "world" $ do
    prop "has the scene's shapes, in their order" holdsItsShapes
    prop "gives each the first material of its name" materialsAreFirstOfName

  modifyMaxSuccess (* 5) $
    describe "closest" $ do
      prop "is the first of all hits of all shapes, sorted" isFirstOfAll
      prop "does not depend on the order of the shapes" doesNotDependOnOrder
      prop "is the first shape's, of several at the same parameter" goesToTheFirstOfEquals
      prop "stays below the bound" staysBelowTheBound
      prop "does not see what is behind, nor where the ray starts" doesNotSeeBehind
      it "is tried with ties and misses" $
        checkCoverage $ \among -> foldr (\(name, holds) -> cover 5 holds name) (property True) (amongCorners among)

  modifyMaxSuccess (* 5) $
    describe "many shapes, with an index" $ do
      prop "have their numbers and finishes" surfacesAreAsOfAList
      prop "are met as a list of them is, to the bit" closestIsAsOfAList
      prop "stand in the way as a list of them does" obstaclesAreAsOfAList
      prop "are around a place as a list of them is" surroundingsAreAsOfAList
      it "are tried in all their corners" $
        checkCoverage $ \shapes -> foldr (\(name, holds) -> cover 1 holds name) (property True) (manyCorners shapes)

  describe "models" $ do
    modifyMaxSuccess (* 3) $ do
      prop "have the numbers and finishes of their shapes, transformed one by one" modelsAreTheirShapes
      prop "are met as their shapes are, to the bit" closestIsAsOfShapes
      prop "stand in the way as their shapes do" obstaclesAreAsOfShapes
      prop "are around a place as their shapes are" surroundingsAreAsOfShapes
    prop "have the picture of their shapes" picturesAreAsOfShapes
    prop "have the colours that the plain recursion gives their shapes" coloursAreAsOfTheRecursion
    it "are tried in all their corners" $
      checkCoverage $ \modelled -> foldr (\(name, holds) -> cover 1 holds name) (property True) (modelledCorners modelled)
    modifyMaxSuccess (* 10) $ prop "let no ray out of a closed mesh, scaled, turned and moved" noWayOutOfTheWorld
    modifyMaxSuccess (* 5) $ prop "have smooth normals and texture coordinates, interpolated in the world" smoothNormalsAreInterpolated

  -- What a ray and its answer cost is measured in a world of nothing. A list of one parameter takes 40 bytes (three
  -- words for the cell, two for the number).
  describe "closest, among eight shapes, which are tried one after the other" $ do
    it "makes no lists: it allocates nothing" $ do
      for_ [spheres, planes, disks, triangles, annuli] $ \make -> bytesPerRay (worldOf (take 8 (ofMakers make))) >>= (`shouldSatisfy` (< 8))
    it "makes no lists of cubes: one number each, at most" $ bytesPerRay (worldOf (take 8 (ofMakers cubes))) >>= (`shouldSatisfy` (<= 8 * 16))
    it "would be seen to make them" $ do
      built <- allocatedBy (overLists (worldOf (take 8 (ofMakers planes))))
      built `shouldSatisfy` (> 40 * 8 * rays)

  -- What is left is the ray made ready, and what was found so far, leaf by leaf; nothing of what is tried, nor of the
  -- way down. Measured with GHC 9.0.2: 180 bytes a ray among spheres, 190 among a hundred times as many; 456 for a mesh
  -- somewhere, where the ray is carried back and seen from, whatever the number of triangles.
  describe "closest, with an index" $ do
    it "allocates little for each ray, and no more among many shapes" $ do
      [few, most] <- mapM (bytesPerRay . worldOf . scattered) [100, 10000]
      (few, most) `shouldSatisfy` (\(x, y) -> x < 400 && y < 400 && y - x < 100)
    it "allocates little for each ray, and no more for many triangles" $ do
      [few, most] <- mapM (bytesPerRay . wall) [10, 100]
      (few, most) `shouldSatisfy` (\(x, y) -> x < 800 && y < 800 && y - x < 100)
  where
    -- Balls in a beam around the rays: the multiples of irrational numbers, modulo 1.
    scattered n = mapMaybe (ball . fromIntegral) [1 .. n :: Int]
    ball i = ASphere <$> sphere (V3 (3 + 40 * part (i * sqrt 2)) (2 * part (i * sqrt 3) - 1) (2 * part (i * sqrt 5) - 1)) 0.01
    part x = x - fromIntegral (floor x :: Int) :: Double
    -- Two by two, of n by n squares, across the rays.
    wall n =
      let at i j = i * (n + 1) + j
          square i j = [(at i j, at (i + 1) j, at i (j + 1)), (at (i + 1) (j + 1), at i (j + 1), at (i + 1) j)]
          corners = [V3 0 (fromIntegral i) (fromIntegral j) | i <- [0 .. n], j <- [0 .. n]]
       in worldOfMesh (meshOf corners (concat (square <$> [0 .. n - 1] <*> [0 .. n - 1]))) (fromMaybe identity (transform (pure (2 / fromIntegral n)) 0 (V3 5 (-1) (-1))))
    bytesPerRay w = do
      nothing <- allocatedBy (overRays (worldOf []))
      -- The first time the world is made
      _ <- allocatedBy (overRays w)
      something <- allocatedBy (overRays w)
      pure ((something - nothing) `div` rays)
    ofMakers make = mapMaybe (make . fromIntegral) [1 .. 20 :: Int]
    spheres i = ASphere <$> sphere (V3 (3 * i) (i / 20) 0) 1
    cubes i = ACube <$> cube (V3 (2 * i) 0 (i / 30)) 0.75
    planes i = APlane <$> plane (V3 (30 - i) 0 0) (V3 1 0.5 0.25)
    disks i = ADisk <$> (plane (V3 (40 - i) 0 0) (V3 1 0.25 0.5) >>= \p -> disk p 2)
    triangles i = ATriangle <$> triangle (Corners (V3 (20 - i) (-1) (-1)) (V3 (20 - i) 2 (-1)) (V3 (21 - i) 0 2))
    annuli i = AnAnnulus <$> (plane (V3 (50 - i) 0 0) (V3 1 0 0) >>= \p -> annulus p 1 2)

rays :: Num a => a
rays = 10000

-- | Bytes allocated by evaluating a function.
allocatedBy :: (Double -> Double) -> IO Int64
allocatedBy f = do
  setAllocationCounter maxBound
  _ <- evaluate (f 1)
  (maxBound -) <$> getAllocationCounter
{-# NOINLINE allocatedBy #-}

-- | A sum of the parameters of closest hits, over rays some of which miss.
overRays :: World -> Double -> Double
overRays w x = go rays 0
  where
    go :: Int -> Double -> Double
    go 0 !total = total
    go i !total = case closest w (towards x i) 1000 of
      Closest t number _ -> go (i - 1) (if number < 0 then total else total + t)
{-# NOINLINE overRays #-}

-- | The same, by lists that are made.
overLists :: World -> Double -> Double
overLists w x = go rays 0
  where
    go :: Int -> Double -> Double
    go 0 !total = total
    go i !total = go (i - 1) (total + minimum (1000 : concatMap (`listed` towards x i) [shape | Just (Surface shape _) <- map (surfaceAt w) [0 .. worldSize w - 1]]))
{-# NOINLINE overLists #-}

listed :: Prepared -> Ray -> [Double]
listed = parameters
{-# NOINLINE listed #-}

towards :: Double -> Int -> Ray
towards x i = ray (V3 (negate x) 0 0) (V3 1 (0.0001 * fromIntegral (i `rem` 1000)) (0.05 - 0.00001 * fromIntegral i))
