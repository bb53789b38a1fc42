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
-- A cube is what three slabs share. A line crosses each slab in an interval, between the parameters of its two faces, and the
-- cube in the intersection of the three: from the last entry to the first exit, both included. Thus no ray slips through
-- an edge, and a ray that lies in a face hits the cube where it comes in. Source: T. Kay and J. Kajiya, "Ray tracing
-- complex scenes", SIGGRAPH 1986. Each face's parameter is the plane's, -\<n, o - P> \/ \<n, d> with P = C + h n, which for an axis
-- comes down to (P - o) \/ d in one coordinate, to the bit.
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

import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Math.Ordinal (finite)
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
cubeParameters :: Point -> Double -> Ray -> [Double]
cubeParameters (V3 cx cy cz) !h r = build $ \cons nil ->
  let !(V3 ox oy oz) = origin r
      !(V3 dx dy dz) = direction r
      !(Slab nearZ farZ) = slab (cz - h) (cz + h) oz dz
      !(Slab nearY farY) = slab (cy - h) (cy + h) oy dy
      !enterYZ = larger nearZ nearY
      !leaveYZ = smaller farY farZ
   in -- Most lines miss in two of the three slabs already. A ray whose numbers left the range on the way here has slabs from NaN to NaN: of two such ends the second one is kept, so that one of the
      -- comparisons below is false.
      if enterYZ <= leaveYZ
        then
          let !(Slab nearX farX) = slab (cx - h) (cx + h) ox dx
              !enter = larger enterYZ nearX
              !leave = smaller leaveYZ farX
              !inside = leave - enter
           in -- Parameters so large that they are infinite are no parameters: their difference is NaN or infinite.
              if inside >= 0 && finite inside then cons enter (cons leave nil) else nil
        else nil
{-# INLINE cubeParameters #-}

-- | The interval in which a line is inside a slab.
data Slab = Slab !Double !Double

-- | The interval of the line o + t d between two parallel faces. A line along the slab is in it everywhere or nowhere, and in
-- it when it lies in a face.
slab :: Double -> Double -> Double -> Double -> Slab
slab low high o d
  | d > 0 = Slab ((low - o) / d) ((high - o) / d)
  | d < 0 = Slab ((high - o) / d) ((low - o) / d)
  | low <= o && o <= high = Slab (negate infinity) infinity
  | otherwise = Slab infinity (negate infinity)
{-# INLINE slab #-}

larger, smaller :: Double -> Double -> Double
larger a b = if a > b then a else b
smaller a b = if a < b then a else b
{-# INLINE larger #-}
{-# INLINE smaller #-}

infinity :: Double
infinity = 1 / 0
{-# INLINE infinity #-}

-- | The outward normal of the face that a ray crosses at a parameter that 'cubeParameters' gave. On an edge, where it crosses
-- several at once, it is the first one's in the order +z -z +y -y +x -x.
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

-- | Whether a point is inside the cube around C with half size h: in each coordinate nearer than (1 - 'surfaceThickness') h. A point
-- on a face is not.
cubeContains :: Point -> Double -> Point -> Bool
cubeContains c h p = all (\x -> abs x < (1 - surfaceThickness) * h) (p - c)
