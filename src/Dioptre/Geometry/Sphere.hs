{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Sphere
-- Description : The sphere
--
-- >      .--.
-- >     (  C-) R       |r - C| = R
-- >      `--'
--
-- With w = o - C, a ray lies on the sphere where A t^2 + B t + C0 = 0: A = \<d, d>, B = 2 \<w, d>, C0 = \<w, w> - R^2.
-- A line meets the sphere in an interval, whose ends are the two roots, or not at all; a tangent meets it at one
-- parameter, twice. See Note [Far spheres].
module Dioptre.Geometry.Sphere
  ( -- * Constructing
    Sphere,
    sphere,
    sphereCentre,
    sphereRadius,

    -- * Intersecting
    sphereParameters,
    sphereClearlyMissed,
    sphereParametersAhead,
    sphereNormal,
    sphereContains,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Ray (Ray, direction, directionQuadrance, origin)
import Dioptre.Math.Roots (clearlyNone, quadraticRoots)
import Dioptre.Math.Tolerance (surfaceThickness)
import Dioptre.Math.Vector (Point, Unit, alongZ, distance, dot, unit)

-- | A sphere.
data Sphere = Sphere
  { -- | The centre, C.
    sphereCentre :: Point,
    -- | The radius, R; greater than zero.
    sphereRadius :: Double
  }
  deriving stock (Eq, Show)

-- | The sphere around a point; 'Nothing' unless the radius is greater than zero.
sphere :: Point -> Double -> Maybe Sphere
sphere c r
  | r > 0 = Just (Sphere c r)
  | otherwise = Nothing

-- | Where a ray's line meets the sphere around C with that squared radius: where it enters and where it leaves.
--
-- Law: both points are at the radius from the centre, to the rounding of w (see Note [Far spheres]).
--
-- Spec: numbers.order, roots.quadratic.same, geometry.sphere.parameters, geometry.sphere.tangent, limits.accuracy.
sphereParameters :: Point -> Double -> Ray -> [Double]
sphereParameters c radiusSquared r = quadraticRoots (directionQuadrance r) (2 * dot w d) (dot w w - radiusSquared)
  where
    d = direction r
    w = origin r - c
{-# INLINE sphereParameters #-}

-- | Whether it is clear at once that a ray's line does not meet the sphere, as it is for most.
sphereClearlyMissed :: Point -> Double -> Ray -> Bool
sphereClearlyMissed c radiusSquared r = clearlyNone (directionQuadrance r) (dot w d) (dot w w - radiusSquared)
  where
    d = direction r
    w = origin r - c
{-# INLINE sphereClearlyMissed #-}

-- | The same as 'sphereParameters', without the parameters behind the origin where that costs nothing: a ray that
-- starts outside (C0 > 0) and does not come nearer (B >= 0) meets the sphere at no positive parameter, since the two
-- roots have the product C0 \/ A > 0 and the sum -B \/ A <= 0.
--
-- Whether its line meets the sphere at all is asked first: it seldom does, while half of the spheres are behind, and a
-- processor guesses the first question's answer right.
--
-- Spec: geometry.hit.first.
sphereParametersAhead :: Point -> Double -> Ray -> [Double]
sphereParametersAhead c radiusSquared r
  | sphereClearlyMissed c radiusSquared r = []
  | b >= 0 && c0 > 0 = []
  | otherwise = quadraticRoots (directionQuadrance r) b c0
  where
    d = direction r
    w = origin r - c
    !b = 2 * dot w d
    !c0 = dot w w - radiusSquared
{-# INLINE sphereParametersAhead #-}

-- | The outward unit normal at a point of the sphere: (r - C) \/ |r - C|. (At the centre, which is no point of the
-- sphere, it is the z axis.)
--
-- Spec: geometry.hit.centre, geometry.sphere.normal.
sphereNormal :: Point -> Point -> Unit
sphereNormal c p = fromMaybe alongZ (unit (p - c))
{-# INLINE sphereNormal #-}

-- | Whether a point is inside the sphere with that squared radius: nearer to the centre than the radius less one part
-- in ten thousand million ('surfaceThickness'). A point on the sphere is not.
--
-- Spec: geometry.sphere.contains.
sphereContains :: Point -> Double -> Point -> Bool
sphereContains c radiusSquared p = distance c p < (1 - surfaceThickness) * sqrt radiusSquared

-- Note [Far spheres]
-- ~~~~~~~~~~~~~~~~~~
-- C0 = |w|^2 - R^2 cancels when the origin is near the surface, and B^2 - 4 A C0 when the line is near a tangent.
-- The second is computed exactly enough by quadraticRoots, for the coefficients that it is given. The first is
-- the rounding of |w|^2 itself, an absolute error of 2^-52 |w|^2 or so: seen from a distance |w|, the sphere's
-- radius is known to 2^-53 |w|^2 / R. At a distance of a thousand radii that is 10^-10 R, far below a pixel; it
-- is the rule of the original, kept as it is so that pictures stay the same.
