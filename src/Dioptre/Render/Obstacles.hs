{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=40 #-}

-- |
-- Module      : Dioptre.Render.Obstacles
-- Description : What stands between a point and a light
--
-- A shadow ray does not ask what comes first: the first thing found that lets nothing through is the answer. What lets
-- light through is gathered.
module Dioptre.Render.Obstacles
  ( Obstacles (..),
    obstacles,
  )
where

import Data.List (foldl')
import Data.Primitive.PrimArray (indexPrimArray)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Box (approach)
import Dioptre.Geometry.Handful (Handful, foldMet)
import Dioptre.Geometry.Hierarchy (Tried (..), descend, hierarchyOrder)
import Dioptre.Geometry.Placement (carriedBack)
import Dioptre.Geometry.Prepared (nearest)
import Dioptre.Geometry.PreparedMesh (anyTriangle)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Light.Finish (Finish, isTransparent)
import Dioptre.Math.Order (infinity)
import Dioptre.Render.Texture (Texture)
import Dioptre.Render.World (Arranged (..), Body (..), Group (..), Placed (..), Surface (..), World (..))

-- | What a ray meets nearer than a bound, in any order.
data Obstacles = Obstacles
  { -- | Whether anything lets nothing through. If so, the rest may have been passed over.
    obstaclesOpaque :: !Bool,
    -- | The numbers and finishes of the transparent shapes that are met, each once.
    obstaclesTransparent :: [(Int, Finish Texture)],
    -- | How many shapes were tried.
    obstaclesTests :: !Int
  }

-- | What a ray meets nearer than a bound; no farther than the first thing that lets nothing through.
--
-- Spec: light.shadow.ray, light.shadow.opaque.
obstacles :: World -> Ray -> Double -> Obstacles
obstacles w !r !bound = case w of
  Few shapes g _ -> obstaclesOfFew shapes g r bound
  Many g _ -> obstaclesOfMany g r bound
{-# INLINE obstacles #-}

obstaclesOfFew :: Handful -> Group -> Ray -> Double -> Obstacles
obstaclesOfFew h g !r !bound = foldMet h r bound each (flip (Obstacles False)) []
  where
    each tests number through next
      | isTransparent f = next ((number, f) : through)
      | otherwise = Obstacles True [] tests
      where
        -- Numbers are below the number of shapes.
        f = surfaceFinish (Vector.unsafeIndex (groupSurfaces g) number)
{-# INLINE obstaclesOfFew #-}

obstaclesOfMany :: Group -> Ray -> Double -> Obstacles
obstaclesOfMany g !r !bound = obstaclesInInstances g 0 r bound (obstaclesInShapes g 0 r bound (Obstacles False [] 0))
{-# NOINLINE obstaclesOfMany #-}

-- | How far a ray still matters: not at all once something opaque is met.
stillTo :: Double -> Obstacles -> Double
stillTo bound found = if obstaclesOpaque found then negate infinity else bound
{-# INLINE stillTo #-}

obstaclesInShapes :: Group -> Int -> Ray -> Double -> Obstacles -> Obstacles
obstaclesInShapes g first r !bound before = case descend (boxes (groupShapes g)) (approach r) (stillTo bound) (obstaclesInRange g first r bound) before of
  Tried found n -> found {obstaclesTests = obstaclesTests found + n}

-- | The same for the shapes at some places.
obstaclesInRange :: Group -> Int -> Ray -> Double -> Int -> Int -> Obstacles -> Obstacles
obstaclesInRange g first !r !bound !from !end = go from
  where
    !order = hierarchyOrder (boxes (groupShapes g))
    !shapes = things (groupShapes g)
    -- Places are below the number of things, and numbers too.
    go !place found
      | place >= end || obstaclesOpaque found = found
      | nearest (Vector.unsafeIndex shapes place) r bound < bound =
        let number = indexPrimArray order place
            f = surfaceFinish (Vector.unsafeIndex (groupSurfaces g) number)
         in go (place + 1) (if isTransparent f then found {obstaclesTransparent = (first + number, f) : obstaclesTransparent found} else found {obstaclesOpaque = True})
      | otherwise = go (place + 1) found
{-# NOINLINE obstaclesInRange #-}

obstaclesInInstances :: Group -> Int -> Ray -> Double -> Obstacles -> Obstacles
obstaclesInInstances g first r !bound before = case descend (boxes a) (approach r) (stillTo bound) range before of
  Tried found _ -> found
  where
    a = groupInstances g
    -- Places are below the number of things.
    range from end found = foldl' each found [from .. end - 1]
    each found place
      | obstaclesOpaque found = found
      | otherwise = case Vector.unsafeIndex (things a) place of
        Placed inner where' body -> obstaclesInBody body (first + inner) (maybe r (`carriedBack` r) where') bound found

obstaclesInBody :: Body -> Int -> Ray -> Double -> Obstacles -> Obstacles
obstaclesInBody body !first !r !bound found = case body of
  -- The material libraries of meshes know no transparency.
  Triangles m _ -> case anyTriangle m r bound of
    (struck, tests) -> found {obstaclesOpaque = struck, obstaclesTests = obstaclesTests found + tests}
  Assembly g -> obstaclesInInstances g first r bound (obstaclesInShapes g first r bound found)
