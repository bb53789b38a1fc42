{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Geometry.Cylinder
-- Description : The cylinder: a tube and its two disks
--
-- >      +-----------------+
-- >     (|                 |)  R      |v_perp| <= R,   0 <= h <= H
-- >     (P1 ----> S ----- P2)
-- >     (|                 |)         with v - P1 = v_perp + h S
-- >      +-----------------+
--
-- A cylinder is what an infinite round bar and the slab between two planes share. A line crosses the bar in an
-- interval, between the two roots of the tube, and the slab in another, and the cylinder in what they share
-- ("Dioptre.Geometry.Interval"). That holds whichever way the line comes: along the axis, where it is in the bar
-- everywhere or nowhere; in an end plane, where it is in the slab everywhere; through a rim, where it leaves the one as
-- it enters the other.
module Dioptre.Geometry.Cylinder
  ( -- * Intersecting
    cylinderParameters,
    cylinderNormal,
    cylinderContains,

    -- * The infinite bar
    bar,
  )
where

import Dioptre.Geometry.Interval (Interval (..), everywhere, intersection, nowhere, slab)
import Dioptre.Geometry.Quadratic (Quadratic (..), rootsOf)
import Dioptre.Geometry.Ray (Ray, direction, origin, position)
import Dioptre.Geometry.Tube (across, circle, tubeNormal)
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Tolerance (endThickness, roundThickness)
import Dioptre.Math.Vector (Point, Unit, Vector, dot, modulus, opposite, vector)
import GHC.Exts (build)

-- | Where w_perp + t d_perp is no longer than R: between the roots of the tube. A line along the axis is in the bar
-- everywhere or nowhere, and in it when it lies in its surface.
--
-- Spec: geometry.cylinder.interval, geometry.cylinder.along-axis.
bar :: Double -> Vector -> Vector -> Interval
bar radius wPerp dPerp = case rootsOf equation of
  [enter, leave] -> Interval enter leave
  _
    | c <= 0 -> everywhere
    | otherwise -> nowhere
  where
    equation@(Quadratic _ _ c) = circle radius wPerp dPerp
{-# INLINE bar #-}

-- | Where a ray's line meets the cylinder from P1 along the unit axis S, of length H and radius R: where it enters and
-- where it leaves, or nothing.
--
-- Laws: a point strictly between the two is inside, and a point outside them is not; a parameter on the curved part is
-- one that the tube has, bit for bit.
--
-- Spec: geometry.cylinder.interval.
cylinderParameters :: Point -> Unit -> Double -> Double -> Ray -> [Double]
cylinderParameters p1 s h radius r = build $ \cons nil ->
  let !(Interval enter leave) = intersection (curvedPart p1 s radius r) (between p1 s h r)
      !inside = leave - enter
   in -- Parameters so large that they are infinite are no parameters: their difference is NaN or infinite.
      if inside >= 0 && inside < infinity then cons enter (cons leave nil) else nil
{-# INLINE cylinderParameters #-}

-- | Where the line is in the infinite bar.
curvedPart :: Point -> Unit -> Double -> Ray -> Interval
curvedPart p1 s radius r = bar radius (across s (origin r - p1)) (across s (direction r))
{-# INLINE curvedPart #-}

-- | Where the line is between the end planes.
between :: Point -> Unit -> Double -> Ray -> Interval
between p1 s h r = slab 0 h (dot (origin r - p1) (vector s)) (dot (direction r) (vector s))
{-# INLINE between #-}

-- | The outward unit normal where a ray meets the cylinder, at a parameter that 'cylinderParameters' gave: the tube's,
-- or S or -S on an end. On a rim, where the line crosses both parts at once, it is the tube's.
--
-- Spec: geometry.cylinder.normal.
cylinderNormal :: Point -> Unit -> Double -> Double -> Ray -> Double -> Unit
cylinderNormal p1 s h radius r t
  | t == enter || t == leave = tubeNormal p1 s (position r t)
  | (t == near) == (dot (direction r) (vector s) > 0) = opposite s
  | otherwise = s
  where
    Interval enter leave = curvedPart p1 s radius r
    Interval near _ = between p1 s h r

-- | Whether a point is inside the cylinder: nearer to the axis than (1 - 'roundThickness') R, and farther than
-- 'endThickness' from both end planes. A point on the surface is not.
--
-- Spec: geometry.cylinder.contains.
cylinderContains :: Point -> Unit -> Double -> Double -> Point -> Bool
cylinderContains p1 s h radius v =
  modulus (across s w) < (1 - roundThickness) * radius && height > endThickness && h - height > endThickness
  where
    w = v - p1
    height = dot w (vector s)
