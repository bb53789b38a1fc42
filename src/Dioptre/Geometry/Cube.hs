{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -fmax-worker-args=24 #-}

-- |
-- Module      : Dioptre.Geometry.Cube
-- Description : The cube along the axes
--
-- >     +------+
-- >    /  +z  /|
-- >   +------+ |        |x - Cx| <= h,  |y - Cy| <= h,  |z - Cz| <= h,   h = size / 2
-- >   |  -x  | +
-- >   |      |/
-- >   +------+
--
-- A cube is what three slabs share. A line crosses each slab in an interval, between the parameters of its two faces,
-- and the cube in what the three share ("Dioptre.Geometry.Interval"). Thus no ray slips through an edge, and a ray that
-- lies in a face hits the cube where it comes in. Each face's parameter is the plane's, -\<n, o - P> \/ \<n, d> with
-- P = C + h n, which for an axis comes down to (P - o) \/ d in one coordinate, to the bit.
module Dioptre.Geometry.Cube
  ( -- * Constructing
    Cube,
    cube,
    cubeCentre,
    cubeSize,

    -- * Intersecting
    cubeParameters,
    cubeNormal,
    cubeContains,
  )
where

import Dioptre.Geometry.Interval (Interval (..), intersection, slab)
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Math.Order (finite)
import Dioptre.Math.Tolerance (surfaceThickness)
import Dioptre.Math.Vector (Point, Unit, alongX, alongY, alongZ, opposite)
import GHC.Exts (build)
import Linear.V3 (V3 (..))

-- | A cube whose edges are parallel to the axes.
data Cube = Cube
  { -- | The centre, C.
    cubeCentre :: Point,
    -- | The length of an edge, 2 h; greater than zero.
    cubeSize :: Double
  }
  deriving stock (Eq, Show)

-- | The cube around a point; 'Nothing' unless its size is greater than zero.
cube :: Point -> Double -> Maybe Cube
cube c size
  | size > 0 = Just (Cube c size)
  | otherwise = Nothing

-- | Where a ray's line meets the cube around C with half size h: where it enters and where it leaves, or nothing.
--
-- Law: a point strictly between the two parameters is inside, and a point outside them is not.
--
-- Spec: geometry.cube.slabs, geometry.cube.edges.
cubeParameters :: Point -> Double -> Ray -> [Double]
cubeParameters (V3 cx cy cz) !h r = build $ \cons nil ->
  let !(V3 ox oy oz) = origin r
      !(V3 dx dy dz) = direction r
      !inYZ@(Interval enterYZ leaveYZ) = intersection (slab (cz - h) (cz + h) oz dz) (slab (cy - h) (cy + h) oy dy)
   in -- Most lines miss in two of the three slabs already. A ray whose numbers left the range on the way here has slabs from NaN to NaN: of two such ends the second one is kept, so that
      -- one of the comparisons below is false.
      if enterYZ <= leaveYZ
        then
          let !(Interval enter leave) = intersection inYZ (slab (cx - h) (cx + h) ox dx)
              !inside = leave - enter
           in -- Parameters so large that they are infinite are no parameters: their difference is NaN or infinite.
              if inside >= 0 && finite inside then cons enter (cons leave nil) else nil
        else nil
{-# INLINE cubeParameters #-}

-- | The outward normal of the face that a ray crosses at a parameter that 'cubeParameters' gave. On an edge, where it
-- crosses several at once, it is the first one's in the order +z -z +y -y +x -x.
--
-- Spec: geometry.cube.normal.
cubeNormal :: Point -> Double -> Ray -> Double -> Unit
cubeNormal (V3 cx cy cz) !h !r !t
  | crosses (cz + h) oz dz = alongZ
  | crosses (cz - h) oz dz = opposite alongZ
  | crosses (cy + h) oy dy = alongY
  | crosses (cy - h) oy dy = opposite alongY
  | crosses (cx + h) ox dx = alongX
  | otherwise = opposite alongX
  where
    V3 ox oy oz = origin r
    V3 dx dy dz = direction r
    crosses face o d = d /= 0 && (face - o) / d == t

-- | Whether a point is inside the cube around C with half size h: in each coordinate nearer than (1 -
-- 'surfaceThickness') h. A point on a face is not.
--
-- Spec: geometry.cube.contains.
cubeContains :: Point -> Double -> Point -> Bool
cubeContains c h p = all (\x -> abs x < (1 - surfaceThickness) * h) (p - c)
