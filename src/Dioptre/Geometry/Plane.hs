{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Plane
-- Description : The infinite plane
--
-- >            n ^
-- >              |
-- >  ------------P------------    <n, r - P> = 0
--
-- A ray r(t) = o + t d lies on the plane where A t + B = 0, with A = \<n, d> and B = \<n, o - P> (the handout's section
-- 1.6). A ray in the plane, or beside it, has A = 0 and does not meet it; or rather an A that is zero but for the
-- rounding of n.
module Dioptre.Geometry.Plane
  ( -- * Constructing
    Plane,
    plane,
    planePosition,
    planeNormal,

    -- * Intersecting
    planeParameters,
  )
where

import Dioptre.Geometry.Ray (Ray, direction, directionQuadrance, origin)
import Dioptre.Math.Roots (linearRoots)
import Dioptre.Math.Tolerance (parallelSine, smallestLength)
import Dioptre.Math.Vector (Point, Unit, Vector, dot, modulus, vector)

-- | A plane, as it was written: its normal has any length but a negligible one.
data Plane = Plane
  { -- | A point of the plane.
    planePosition :: Point,
    -- | Orthogonal to the plane; at least 'smallestLength' long.
    planeNormal :: Vector
  }
  deriving stock (Eq, Show)

-- | The plane through a point, orthogonal to a vector; 'Nothing' if the vector is shorter than 'smallestLength'.
--
-- Spec: code.zero-normal, geometry.plane.unit-normal.
plane :: Point -> Vector -> Maybe Plane
plane p n
  | modulus n < smallestLength = Nothing
  | otherwise = Just (Plane p n)

-- | Where a ray's line meets the plane through P with unit normal n: one parameter or none.
--
-- A ray whose angle with the plane has a sine of at most 'parallelSine' is in the plane or beside it, and does not meet
-- it.
--
-- Law: \<n, r(t) - P> is zero at that parameter, to rounding.
--
-- Spec: numbers.order, geometry.plane.parameters, geometry.plane.parallel, geometry.disk.edge-on,
--   geometry.triangle.edge-on.
planeParameters :: Point -> Unit -> Ray -> [Double]
planeParameters p n r =
  [t | a * a > parallelSine * parallelSine * directionQuadrance r, t <- linearRoots a (dot (vector n) (origin r - p))]
  where
    !a = dot (vector n) (direction r)
{-# INLINE planeParameters #-}
