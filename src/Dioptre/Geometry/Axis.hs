{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Axis
-- Description : Axes, and what is round about them
--
-- >     P1 ----> S ------ P2        H = |P2 - P1|,  S = (P2 - P1) / H
-- >     |                 |
-- >     0 ------ h ------ H         a point v is at the height h = <v - P1, S>
--
-- Tube, cylinder, cone and lens have an axis and a radius; what else they are, and where rays meet them, stands in a
-- module for each.
module Dioptre.Geometry.Axis
  ( -- * Axes
    Axis,
    axis,
    axisLength,
    axisStart,
    axisEnd,

    -- * With a radius
    Round,
    roundShape,
    roundAxis,
    roundRadius,
  )
where

import Dioptre.Math.Vector (Point, distance, modulus, nearOne)

-- | A segment between two different points.
data Axis = Axis
  { -- | P1.
    axisStart :: Point,
    -- | P2; not P1.
    axisEnd :: Point
  }
  deriving stock (Eq, Show)

-- | The axis from one point to another; 'Nothing' if they are equal.
--
-- Spec: code.equal-points.
axis :: Point -> Point -> Maybe Axis
axis a b
  | a == b = Nothing
  | otherwise = Just (Axis a b)

-- | The length of an axis, H, which is not zero: where the points are so near that the squares of their differences
-- may lose digits or vanish (below 1e-154; below 1e-140 it makes no difference), those are scaled by a power of two
-- first.
--
-- Spec: geometry.axis.length.
axisLength :: Axis -> Double
axisLength (Axis a b)
  -- 1e-140. See Note [Literals] of "Dioptre.Math.Roots".
  | maximum (abs <$> between) > 1e-70 * 1e-70 = distance a b
  | otherwise = scaleFloat e (modulus nearby)
  where
    between = b - a
    (e, nearby) = nearOne between

-- | An axis and a radius: a tube, a cylinder, a cone, or the rim of a lens.
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
