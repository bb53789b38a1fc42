-- |
-- Module      : Dioptre.Geometry.Tube
-- Description : The tube: round, and open at both ends
--
-- >      +-----------------+          a point v at height h = <v - P1, S> on the axis,
-- >      |                 |  R       |v - P1 - h S| = R,   0 <= h <= H
-- >     P1----> S ------- P2
-- >      |                 |
-- >      +-----------------+
-- >      0 ------- h ----- H
--
-- What a vector has across the axis is v_perp = S x (v x S) = v - \<v, S> S. Across the axis a ray o + t d looks like
-- the ray w_perp + t d_perp, with w = o - P1, and the tube like a circle of radius R:
--
-- > |w_perp + t d_perp|^2 = R^2
-- > A = <d_perp, d_perp>,  B = 2 <w_perp, d_perp>,  C = <w_perp, w_perp> - R^2
--
-- Its roots are where the ray's line meets the infinite tube, and those between the two end planes, the planes
-- included, are where it meets the tube. Along the axis A = B = 0, and the line has no root: it runs in the tube or
-- beside it, and does not meet it. The radius of a tube seen from afar is as uncertain as a sphere's: see Note [Far
-- spheres] in "Dioptre.Geometry.Sphere".
module Dioptre.Geometry.Tube
  ( -- * Intersecting
    tubeParameters,
    tubeLineParameters,
    tubeNormal,

    -- * Across the axis
    across,
    circle,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Quadratic (Quadratic (..), rootsOf)
import Dioptre.Geometry.Ray (Ray, direction, origin, position)
import Dioptre.Math.Vector (Point, Unit, Vector, cross, dot, unit, vector)

-- $setup
-- >>> import Dioptre.Math.Vector (alongZ)
-- >>> import Linear.V3 (V3 (..))

-- | What a vector has across an axis: S x (v x S), which is orthogonal to S; zero for a vector along the axis, to
-- rounding.
--
-- >>> across alongZ (V3 1 2 3) == V3 1 2 0
-- True
across :: Unit -> Vector -> Vector
across s v = cross (vector s) (cross v (vector s))
{-# INLINE across #-}

-- | The equation of the infinite tube of radius R, for what a line w + t d has across the axis, w_perp and d_perp:
-- there it is a circle's.
circle :: Double -> Vector -> Vector -> Quadratic
circle radius wPerp dPerp = Quadratic (dot dPerp dPerp) (2 * dot wPerp dPerp) (dot wPerp wPerp - radius * radius)
{-# INLINE circle #-}

-- | Where a ray's line meets the tube from P1 along the unit axis S, of length H and radius R: the roots of the
-- infinite tube at which the point is at a height from 0 to H, ascending.
--
-- Law: each point is at the radius from the axis, to the rounding of the squared distance, and between the end planes.
--
-- Spec: geometry.tube.ends.
tubeParameters :: Point -> Unit -> Double -> Double -> Ray -> [Double]
tubeParameters p1 s h radius r =
  [ t
    | t <- tubeLineParameters p1 s radius r,
      let height = dot (position r t - p1) (vector s),
      0 <= height,
      height <= h
  ]
{-# INLINE tubeParameters #-}

-- | Where a ray's line meets the infinite tube around the axis S through a point P, of radius R: where it enters and
-- where it leaves. A ray along the axis does not meet it.
--
-- Law: radius 0 is met by lines through the axis, twice at one parameter.
--
-- Spec: geometry.tube.line-parameters, geometry.tube.along-axis.
tubeLineParameters :: Point -> Unit -> Double -> Ray -> [Double]
tubeLineParameters p s radius r = rootsOf (circle radius (across s (origin r - p)) (across s (direction r)))
{-# INLINE tubeLineParameters #-}

-- | The outward unit normal at a point v of the tube: (v - P1)_perp, made unit. (On the axis, where no point of a tube
-- is, it is the axis.)
--
-- Law: orthogonal to the axis, to rounding.
--
-- Spec: geometry.hit.centre, geometry.tube.normal.
tubeNormal :: Point -> Unit -> Point -> Unit
tubeNormal p1 s v = fromMaybe s (unit (across s (v - p1)))
{-# INLINE tubeNormal #-}
