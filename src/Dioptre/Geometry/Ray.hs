{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Ray
-- Description : A half-line that looks
--
-- > o ----------> d        r(t) = o + t d
-- >   t = 0    t = 1
--
-- The ray of the handout's section 1.3. Its parameter t is the distance from the origin when the direction is unit, as
-- it is for every ray that leaves the camera; a ray that was carried into another frame keeps its parameters and gives
-- up the unit length.
module Dioptre.Geometry.Ray
  ( Ray,
    ray,
    origin,
    direction,
    directionQuadrance,
    position,
    nextTo,
  )
where

import Dioptre.Math.Vector (Packed, Point, Vector, dot, packed, quadrance, unpacked, (*^))

-- $setup
-- >>> import Linear.V3 (V3 (..))

-- | An origin and a direction, in world space. The direction is not zero; it need not be of unit length.
--
-- Its third part is the quadrance of the direction, which planes and spheres ask for: computed once for all of them.
data Ray = Ray {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Double
  deriving stock (Eq, Show)

-- | The ray from a point in a direction.
--
-- Spec: geometry.ray.direction.
ray :: Point -> Vector -> Ray
ray o d = Ray (packed o) (packed d) (quadrance d)
{-# INLINE ray #-}

-- | The point at t = 0.
origin :: Ray -> Point
origin (Ray o _ _) = unpacked o
{-# INLINE origin #-}

-- | What one unit of t adds.
direction :: Ray -> Vector
direction (Ray _ d _) = unpacked d
{-# INLINE direction #-}

-- | The squared length of the direction, \<d, d>.
directionQuadrance :: Ray -> Double
directionQuadrance (Ray _ _ q) = q
{-# INLINE directionQuadrance #-}

-- | The point at a parameter, r(t) = o + t d; behind the origin where t is negative.
--
-- Law: it is within a few roundings of its terms of the exact point.
--
-- >>> position (ray (V3 1 2 3) (V3 0 0 2)) 1.5
-- V3 1.0 2.0 6.0
--
-- Spec: numbers.binary64, geometry.ray.position, geometry.hit.point.
position :: Ray -> Double -> Point
position r t = origin r + t *^ direction r
{-# INLINE position #-}

-- | Moves a line w + t d next to where w is measured from: the parameter of its point nearest to there, t0 = -\<w, d>
-- \/ \<d, d>, and that point, w + t0 d.
--
-- >>> nextTo (V3 (-6) 1 0) (V3 2 0 0)
-- (3.0,V3 0.0 1.0 0.0)
nextTo :: Vector -> Vector -> (Double, Vector)
nextTo w d = (t0, w + t0 *^ d)
  where
    t0 = negate (dot w d / dot d d)
{-# INLINE nextTo #-}
