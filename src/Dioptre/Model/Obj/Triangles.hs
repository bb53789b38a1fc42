{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Model.Obj.Triangles
-- Description : From polygons to triangles
--
-- A polygon becomes a fan, corner 0 with each pair of corners behind it. It is taken to be convex, as the format asks.
--
-- >  3 ------ 2
-- >   \     .' \
-- >    \  .'    \          0 1 2, 0 2 3
-- >     0 ------ 1
--
-- Triangles whose corners lie on one line are left out, and counted. See Note [Not on one line].
module Dioptre.Model.Obj.Triangles
  ( Triangles,
    newTriangles,
    fan,
    collinear,
    meshOf,
  )
where

import Control.Monad (unless, when)
import Control.Monad.ST (ST)
import Data.Bits (testBit, (.&.))
import qualified Data.ByteString as Bytes
import Data.Int (Int32)
import Data.Maybe (isJust)
import Dioptre.Geometry.Mesh (Mesh (..), noAttribute)
import Dioptre.Geometry.Triangle (Corners (..), triangle)
import Dioptre.Math.Vector (Packed, cross, quadrance, unpacked)
import Dioptre.Model.Growing
import Dioptre.Model.Obj.Corner (Parts, normalPart, uvPart)
import Dioptre.Model.Obj.Faults (Faults, Tally, newTally, tally)
import Dioptre.Model.Obj.Lines (Line (..))
import Dioptre.Model.Obj.Vertices (Vertices, pointAt, settledNormals, settledPoints, settledUvs)

-- | The triangles so far, in the form of a mesh.
data Triangles s = Triangles
  { -- | Vertex numbers of the corners.
    trianglesCorners :: !(Growing s Int32),
    -- | Normal numbers of the corners; shorter than their vertex numbers where the last triangles have none.
    trianglesCornerNormals :: !(Growing s Int32),
    -- | The same for texture coordinates.
    trianglesCornerUvs :: !(Growing s Int32),
    -- | The number of each triangle's material.
    trianglesFinishes :: !(Growing s Int32),
    -- | Triangles that are left out.
    trianglesCollinear :: !(Tally s)
  }

-- | No triangles.
newTriangles :: ST s (Triangles s)
newTriangles = Triangles <$> newGrowing <*> newGrowing <*> newGrowing <*> newGrowing <*> newTally

-- | Triangles that are left out, as their corners lie on one line.
--
-- Spec: models.obj.polygons.
collinear :: Triangles s -> Tally s
collinear = trianglesCollinear

-- | Adds the triangles of a polygon: of three corners or more, each with the numbers of its vertex, texture coordinate
-- and normal, from 0, of which the last two count if they are among the parts; of that material; in that line from that
-- place on.
--
-- Spec: models.obj.polygons.
fan :: Faults s -> Vertices s -> Triangles s -> Growing s Int32 -> Parts -> Int -> Line -> Int -> ST s ()
fan faults vertices ts polygon parts material line@(Line bytes _ _) start = do
  count <- (`quot` 3) <$> size polygon
  v0 <- at polygon 0
  p0 <- pointAt vertices (fromIntegral v0)
  let -- The corner i, its vertex and that one's point.
      go !i !v1 !p1
        | i + 1 >= count = pure ()
        | otherwise = do
          v2 <- at polygon (3 * (i + 1))
          p2 <- pointAt vertices (fromIntegral v2)
          if isTriangle p0 p1 p2
            then do
              before <- size (trianglesCorners ts)
              push3 (trianglesCorners ts) v0 v1 v2
              push (trianglesFinishes ts) (fromIntegral material)
              when (testBit parts uvPart) $ attributes (trianglesCornerUvs ts) before 1 i
              when (testBit parts normalPart) $ attributes (trianglesCornerNormals ts) before 2 i
            else tally faults (trianglesCollinear ts) line start (Bytes.length bytes)
          go (i + 1) v2 p2
  v1 <- at polygon 3
  p1 <- pointAt vertices (fromIntegral v1)
  go 1 v1 p1
  where
    attributes numbers before which i = do
      a0 <- at polygon which
      a1 <- at polygon (3 * i + which)
      a2 <- at polygon (3 * (i + 1) + which)
      unless (a0 .&. a1 .&. a2 == noAttribute) $ pad numbers before noAttribute >> push3 numbers a0 a1 a2

-- | Whether 'triangle' has a triangle with these corners. See Note [Not on one line].
isTriangle :: Packed -> Packed -> Packed -> Bool
isTriangle packed0 packed1 packed2 = quadrance (cross e1 e2) > clearly * (quadrance e1 * quadrance e2) || isJust (triangle (Corners p0 p1 p2))
  where
    p0 = unpacked packed0
    p1 = unpacked packed1
    p2 = unpacked packed2
    e1 = p1 - p0
    e2 = p2 - p0
    clearly = 2 ** (-80)
{-# INLINE isTriangle #-}

-- | The triangles with their vertices. Neither is here any longer.
--
-- Spec: models.obj.smooth.
meshOf :: Vertices s -> Triangles s -> ST s Mesh
meshOf vertices ts = do
  corners <- size (trianglesCorners ts)
  let settledOrNone numbers = size numbers >>= \n -> when (n > 0) (pad numbers corners noAttribute) >> settled numbers
  Mesh
    <$> settledPoints vertices
    <*> settledNormals vertices
    <*> settledUvs vertices
    <*> settled (trianglesCorners ts)
    <*> settledOrNone (trianglesCornerNormals ts)
    <*> settledOrNone (trianglesCornerUvs ts)
    <*> settled (trianglesFinishes ts)

-- Note [Not on one line]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- 'triangle' takes the edges' directions (two square roots, six divisions) before it compares the sine of their angle
-- with 2^-50. Most triangles are nowhere near that. With the edges e1 and e2, |e1 x e2|^2 > 2^-80 |e1|^2 |e2|^2 says
-- that the sine is above 2^-40; what rounding does to either side (some 2^-51 of the edges' lengths in e1 x e2) is far
-- too small to bring it below 2^-50. Only where that is not so is 'triangle' asked. Coordinates are singles: edges that
-- are not zero have lengths from 2^-149 to 2^130, so that nothing overflows or vanishes on the way.
