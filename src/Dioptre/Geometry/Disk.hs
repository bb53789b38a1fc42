{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Disk
-- Description : The disk, and the annulus of question 1.8
--
-- > disk:     P-----|  R          the points of the plane with |r - P| <= R
-- > annulus:  P  |--|  Ri, R      the points of the plane with Ri <= |r - P| <= R
--
-- A disk is the part of its plane within a distance of its centre; the doughnut in a plane that question 1.8 asks for
-- is the part between two distances. Their rims belong to them.
module Dioptre.Geometry.Disk
  ( -- * Constructing
    Disk,
    disk,
    diskPlane,
    diskRadius,
    Annulus,
    annulus,
    annulusPlane,
    annulusInner,
    annulusOuter,

    -- * Intersecting
    diskParameters,
    annulusParameters,
  )
where

import Dioptre.Geometry.Plane (Plane, planeParameters)
import Dioptre.Geometry.Ray (Ray, position)
import Dioptre.Math.Vector (Point, Unit, distance)

-- | A disk: its plane, whose position is the centre, and its radius.
data Disk = Disk
  { -- | The plane that it lies in; its position is the centre.
    diskPlane :: Plane,
    -- | The radius, R; greater than zero.
    diskRadius :: Double
  }
  deriving stock (Eq, Show)

-- | The disk in a plane, around the plane's position; 'Nothing' unless the radius is greater than zero.
disk :: Plane -> Double -> Maybe Disk
disk p r
  | r > 0 = Just (Disk p r)
  | otherwise = Nothing

-- | A flat ring: its plane, whose position is the centre, and its two radii.
data Annulus = Annulus
  { -- | The plane that it lies in; its position is the centre.
    annulusPlane :: Plane,
    -- | The radius of the hole, from 0 to the outer one.
    annulusInner :: Double,
    -- | The radius of the rim.
    annulusOuter :: Double
  }
  deriving stock (Eq, Show)

-- | The ring between an inner and an outer radius; 'Nothing' unless 0 <= inner <= outer.
--
-- Spec: code.inner-beyond-outer, geometry.annulus.rims.
annulus :: Plane -> Double -> Double -> Maybe Annulus
annulus p inner outer
  | 0 <= inner && inner <= outer = Just (Annulus p inner outer)
  | otherwise = Nothing

-- | Where a ray's line meets the disk: the plane's parameter, kept where the point is within the radius.
--
-- Law: a disk is hit exactly where its plane is hit no farther than R from the centre.
--
-- Spec: geometry.disk.parameters, geometry.disk.rim, geometry.disk.edge-on.
diskParameters :: Point -> Unit -> Double -> Ray -> [Double]
diskParameters p n radius r = [t | t <- planeParameters p n r, distance p (position r t) <= radius]
{-# INLINE diskParameters #-}

-- | Where a ray's line meets the annulus: kept where inner <= distance <= outer.
--
-- Law: an annulus with inner radius 0 is a disk.
--
-- Spec: geometry.annulus.parameters, geometry.annulus.rims.
annulusParameters :: Point -> Unit -> Double -> Double -> Ray -> [Double]
annulusParameters p n inner outer r =
  [t | t <- planeParameters p n r, let away = distance p (position r t), inner <= away, away <= outer]
{-# INLINE annulusParameters #-}
