{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Cap
-- Description : The spherical cap: what a plane cuts from a sphere
--
-- >            n
-- >         ___^___             C = P - m n,   m = sgn(c) sqrt (c^2 - R^2)
-- >      .-'   |   `-.
-- >     /      |      \         |v - C| = |c|,   sgn(c) <v - P, n> >= 0
-- >    +-------P-------+  R
-- >     `      |      '
-- >            C                and for c < 0 the same upside down
--
-- The curved part only, without its disk. With p = o - P, and because c^2 - m^2 = R^2, a ray meets the sphere where
--
-- > |p + m n + t d|^2 = c^2
-- > A = <d, d>,  B = 2 (<p, d> + m <d, n>),  C = <p, p> + 2 m <p, n> - R^2
--
-- which neither squares c nor subtracts such squares: a nearly flat cap, of a sphere a million times its size, keeps
-- its digits. See Note [Near the rim].
module Dioptre.Geometry.Cap
  ( -- * Constructing
    Cap,
    cap,
    capDisk,
    capCurvature,

    -- * Intersecting
    capParameters,
    capNormal,

    -- * Spheres over disks
    centreDepth,
    faceDepth,
    sphereOver,
    beyondSphere,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Disk (Disk, diskRadius)
import Dioptre.Geometry.Quadratic (Quadratic (..), rootsOf)
import Dioptre.Geometry.Ray (Ray, direction, nextTo, origin)
import Dioptre.Geometry.Tube (across)
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Vector (Point, Unit, Vector, dot, quadrance, unit, vector, (*^))

-- | The curved cap of a sphere over a disk, without the disk.
data Cap = Cap
  { -- | The disk that it stands over.
    capDisk :: Disk,
    -- | The signed radius of curvature, c: positive bulges along the disk's normal.
    capCurvature :: Double
  }
  deriving stock (Eq, Show)

-- | The cap with that signed radius of curvature; 'Nothing' if the sphere does not reach the rim: |c| < R.
--
-- Spec: code.curvature-below-radius.
cap :: Disk -> Double -> Maybe Cap
cap d c
  | abs c < diskRadius d = Nothing
  | otherwise = Just (Cap d c)

-- | How far the centre of the sphere is behind its disk: m = sgn(c) sqrt (c^2 - R^2), for |c| >= R. (0 where |c| < R.)
--
-- The square root is taken of (|c| - R) (|c| + R), which does not cancel.
--
-- >>> centreDepth 3 (-5)
-- -4.0
--
-- Spec: geometry.cap.half.
centreDepth :: Double -> Double -> Double
centreDepth radius c
  | abs c > radius = signum c * sqrt ((abs c - radius) * (abs c + radius))
  | otherwise = 0

-- | How far the sphere stands out from its disk in the middle: s(0) = sgn(c) (|c| - sqrt (c^2 - R^2)), written as
-- sgn(c) R^2 \/ (|c| + sqrt (c^2 - R^2)), which does not cancel for flat faces.
--
-- Spec: code.lens-too-thin, geometry.lens.possible.
faceDepth :: Double -> Double -> Double
faceDepth r c = signum c * (r * r) / (abs c + sqrt ((abs c - r) * (abs c + r)))

-- | The equation of the sphere over a disk of radius R and unit normal n, with the centre m behind it, along p + t d; p
-- is measured from the centre of the disk.
--
-- Spec: geometry.cap.surface.
sphereOver :: Vector -> Double -> Double -> Vector -> Vector -> Quadratic
sphereOver n radius m p d = Quadratic (dot d d) (2 * (dot p d + m * dot d n)) (beyondSphere n radius m p)
{-# INLINE sphereOver #-}

-- | By how much the squared distance of a point from that sphere's centre exceeds the sphere's squared radius: \<p, p>
-- + 2 m \<p, n> - R^2.
beyondSphere :: Vector -> Double -> Double -> Vector -> Double
beyondSphere n radius m p = (dot p p + 2 * (m * dot p n)) - radius * radius
{-# INLINE beyondSphere #-}

-- | Where a ray's line meets the cap over the disk around P with unit normal n and radius R, with the signed radius of
-- curvature c: the parameters at which it meets the sphere on the cap's side of the disk's plane, the rim included; at
-- most two, ascending.
--
-- Law: each point is at the distance |c| from the centre of the sphere, and not behind the disk, to rounding.
--
-- Spec: geometry.cap.surface, geometry.cap.open, geometry.cap.half, geometry.cap.parameters.
capParameters :: Point -> Unit -> Double -> Double -> Ray -> [Double]
capParameters centre normal radius c r =
  [t0 + t | abs t0 < infinity, t <- rootsOf (sphereOver n radius m p d), isOver (p + t *^ d)]
  where
    n = vector normal
    m = centreDepth radius c
    -- On the cap's side of the disk. See Note [Flat caps].
    isOver v
      | abs c > 16 * radius = signum c * dot v n > negate (abs m) && quadrance (across normal v) <= radius * radius
      | otherwise = signum c * dot v n >= 0
    d = direction r
    (t0, p) = nextTo (origin r - centre) d
{-# INLINE capParameters #-}

-- | The unit normal at a point v of the cap: (v - C) \/ c, made unit. It points out of the sphere where c > 0, and to
-- its centre where c < 0, so that it is on the side of n.
--
-- Spec: geometry.hit.centre, geometry.cap.normal.
capNormal :: Point -> Unit -> Double -> Double -> Point -> Unit
capNormal centre normal radius c v =
  fromMaybe normal (unit (signum c *^ ((v - centre) + centreDepth radius c *^ vector normal)))
{-# INLINE capNormal #-}

-- Note [Flat caps]
-- ~~~~~~~~~~~~~~~~
-- Which points of the sphere are on the cap is told by their height h over the disk, h >= 0, or by their distance rho
-- from its axis, rho <= R, but there only before the plane of the centre, h > -m. (Let c > 0; c < 0 is the same upside
-- down.) On the sphere (h + m)^2 + rho^2 = c^2 = m^2 + R^2, that is
--
-- > R^2 - rho^2 = h (h + 2 m)
--
-- and for h > -m the second factor is positive: both say the same. A position that is off by e moves the rim by e m / R
-- if it is told by the height, since the cap is that flat there, and by e if it is told by the distance, but then, seen
-- from the side, by e R / m in height. So a cap that is half a sphere, m = 0, is told by its height, and a flat one by
-- the distance: told by the height, a cap of |c| = 10^16 R, whose height R^2 / 2|c| is below the rounding of a
-- position, would be met anywhere in its plane, or nowhere. The rule changes at |c| = 16 R, where both are good to a
-- few digits of the last place.

-- Note [Near the rim]
-- ~~~~~~~~~~~~~~~~~~~
-- The ray is first moved to its point nearest to the centre of the disk: then p is no longer than the line's distance
-- from there, and what C loses to rounding is 2^-52 of R^2 and of m <p, n>, no longer of the squared distance from
-- which the ray came. Divided by the gradient, 2 |c|, that is less than 2^-52 R where the line meets the cap. (The
-- sphere of the original's rule has no rim to stay close to; it is left alone so that its pictures stay the same.)
