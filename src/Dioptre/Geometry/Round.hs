{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Round
-- Description : Shapes around an axis: tube, cylinder, cone, lens, cap, torus
--
-- > tube, cylinder   P1 =========== P2      radius R around the axis
-- > cone             P1 >=========- P2      base of radius R at P1, apex at P2
-- > lens             P1 (=========) P2      rim of radius R, two spherical faces
-- > spherical cap    P, n, R, c             a part of the sphere with radius |c|, over a disk
-- > torus            P, n, R, r             a tube of radius r around a circle of radius R
--
-- What these shapes are, and which numbers make one. Where rays meet them stands in a module for each: "Dioptre.Geometry.Tube" and its neighbours.
module Dioptre.Geometry.Round
  ( -- * Axes
    Axis,
    axis,
    axisLength,
    axisStart,
    axisEnd,

    -- * Shapes on an axis
    Round,
    roundShape,
    roundAxis,
    roundRadius,
    Lens,
    lens,
    lensBody,
    lensCurvatures,
    faceDepth,

    -- * Shapes over a disk
    Cap,
    cap,
    capDisk,
    capCurvature,
    Torus,
    torus,
    torusPlane,
    torusMajor,
    torusMinor,
  )
where

import Dioptre.Geometry.Disk (Disk, diskRadius)
import Dioptre.Geometry.Plane (Plane)
import Dioptre.Math.Vector (Point, distance, modulus)

-- | A segment between two different points.
data Axis = Axis
  { -- | P1.
    axisStart :: Point,
    -- | P2; not P1.
    axisEnd :: Point
  }
  deriving stock (Eq, Show)

-- | The axis from one point to another; 'Nothing' if they are equal.
axis :: Point -> Point -> Maybe Axis
axis a b
  | a == b = Nothing
  | otherwise = Just (Axis a b)

-- | The length of an axis, H, which is not zero: where the points are so near that the squares of their differences vanish (below 1e-154), those are scaled by a power of two first.
axisLength :: Axis -> Double
axisLength (Axis a b)
  -- 1e-140. See Note [Literals] of "Dioptre.Math.Roots".
  | size > 1e-70 * 1e-70 = distance a b
  | otherwise = scaleFloat e (modulus (scaleFloat (negate e) <$> between))
  where
    between = b - a
    size = maximum (abs <$> between)
    e = exponent size

-- | An axis and a radius: a tube, a cylinder or a cone.
data Round = Round
  { -- | Its axis; a cone's leads from the base to the apex.
    roundAxis :: Axis,
    -- | The radius, R (a cone's at its base); greater than zero.
    roundRadius :: Double
  }
  deriving stock (Eq, Show)

-- | 'Nothing' unless the radius is greater than zero.
roundShape :: Axis -> Double -> Maybe Round
roundShape a r
  | r > 0 = Just (Round a r)
  | otherwise = Nothing

-- | A lens: its rim, and the signed radii of curvature of its faces at P1 and at P2, positive where the face bulges outwards.
data Lens = Lens
  { -- | The axis and the rim.
    lensBody :: Round,
    -- | The radii of curvature at P1 and P2.
    lensCurvatures :: (Double, Double)
  }
  deriving stock (Eq, Show)

-- | 'Nothing' unless both spheres reach the rim and the lens has a thickness on its axis: |c1| >= R, |c2| >= R and
-- L + s1(0) + s2(0) > 0, with s the 'faceDepth'.
lens :: Round -> (Double, Double) -> Maybe Lens
lens body@(Round a r) curvatures@(c1, c2)
  | abs c1 < r || abs c2 < r = Nothing
  | axisLength a + faceDepth r c1 + faceDepth r c2 > 0 = Just (Lens body curvatures)
  | otherwise = Nothing

-- | How far a spherical face stands out from the rim's plane on the axis: s(0) = sgn(c) (|c| - sqrt (c^2 - R^2)), written as
-- sgn(c) R^2 \/ (|c| + sqrt (c^2 - R^2)), which does not cancel for flat faces.
faceDepth :: Double -> Double -> Double
faceDepth r c = signum c * (r * r) / (abs c + sqrt ((abs c - r) * (abs c + r)))

-- | The curved cap of a sphere over a disk, without the disk.
data Cap = Cap
  { -- | The disk that it stands over.
    capDisk :: Disk,
    -- | The signed radius of curvature, c: positive bulges along the disk's normal.
    capCurvature :: Double
  }
  deriving stock (Eq, Show)

-- | The cap with that signed radius of curvature; 'Nothing' if the sphere does not reach the rim: |c| < R.
cap :: Disk -> Double -> Maybe Cap
cap d c
  | abs c < diskRadius d = Nothing
  | otherwise = Just (Cap d c)

-- | A torus: the plane of its circle, the radius of the circle, and that of the tube.
data Torus = Torus
  { -- | The plane of the circle; its position is the centre.
    torusPlane :: Plane,
    -- | The radius of the circle; greater than zero.
    torusMajor :: Double,
    -- | The radius of the tube; greater than zero.
    torusMinor :: Double
  }
  deriving stock (Eq, Show)

-- | 'Nothing' unless both radii are greater than zero. The tube may be thicker than the circle (a spindle).
torus :: Plane -> Double -> Double -> Maybe Torus
torus p major minor
  | major > 0 && minor > 0 = Just (Torus p major minor)
  | otherwise = Nothing
