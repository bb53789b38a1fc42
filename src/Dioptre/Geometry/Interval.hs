-- |
-- Module      : Dioptre.Geometry.Interval
-- Description : Parts of a line
--
-- >     a        [===============]
-- >     b              [==============]
-- >     both           [=========]            from the last entry to the first exit
-- >   ---------------------------------------> t
--
-- A convex body is what simpler ones share: a cube three slabs, a cylinder a round bar and a slab, a cone a double cone
-- and a slab. A line is in each of them in one interval of its parameter, and in the body in what these intervals
-- share. So every line meets the body in one interval or not at all, whichever way it comes: nothing slips through an
-- edge.
--
-- Source: T. Kay and J. Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986.
module Dioptre.Geometry.Interval
  ( Interval (..),
    everywhere,
    nowhere,
    intersection,
    slab,
  )
where

import Dioptre.Math.Order (infinity, larger, smaller)

-- | The parameters from a first to a last, both included; none if the first is the greater. Either may be infinite.
data Interval = Interval !Double !Double

-- | The whole line, and no part of it.
everywhere, nowhere :: Interval
everywhere = Interval (negate infinity) infinity
nowhere = Interval infinity (negate infinity)
{-# INLINE everywhere #-}
{-# INLINE nowhere #-}

-- | What two intervals share. Where an end of either is NaN, that of the second is kept.
intersection :: Interval -> Interval -> Interval
intersection (Interval a b) (Interval c d) = Interval (larger a c) (smaller b d)
{-# INLINE intersection #-}

-- | Where the height h0 + t dh above a plane is from low to high, in the order of these names.
--
-- >   high  ----------/--     A line along the slab (dh = 0) is in it everywhere or nowhere,
-- >                  /        and in it when it lies in one of its planes.
-- >   low   --------/----
-- >                /
--
-- Spec: geometry.cube.slabs, geometry.cube.along-slab, geometry.cylinder.interval, geometry.cylinder.along-axis.
slab :: Double -> Double -> Double -> Double -> Interval
slab low high h0 dh
  | dh > 0 = Interval ((low - h0) / dh) ((high - h0) / dh)
  | dh < 0 = Interval ((high - h0) / dh) ((low - h0) / dh)
  | low <= h0 && h0 <= high = everywhere
  | otherwise = nowhere
{-# INLINE slab #-}
