{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Shape
-- Description : All shapes
--
-- The closed sum of the shapes that a scene can hold, each as it was written and known to be possible. What the inner
-- loop sees of them is in "Dioptre.Geometry.Prepared".
module Dioptre.Geometry.Shape
  ( Shape (..),
  )
where

import Dioptre.Geometry.Axis (Round)
import Dioptre.Geometry.Cap (Cap)
import Dioptre.Geometry.Cube (Cube)
import Dioptre.Geometry.Disk (Annulus, Disk)
import Dioptre.Geometry.Lens (Lens)
import Dioptre.Geometry.Plane (Plane)
import Dioptre.Geometry.Sphere (Sphere)
import Dioptre.Geometry.Torus (Torus)
import Dioptre.Geometry.Triangle (SmoothTriangle, Triangle)
import Dioptre.Math.Transform (Transform)

-- | A shape in world space, or in the frame of the transformation around it.
data Shape
  = APlane Plane
  | ADisk Disk
  | AnAnnulus Annulus
  | ASphere Sphere
  | ACube Cube
  | ATriangle Triangle
  | ASmoothTriangle SmoothTriangle
  | ATube Round
  | ACylinder Round
  | ACone Round
  | ALens Lens
  | ACap Cap
  | ATorus Torus
  | ATransformed Transform Shape
  deriving stock (Eq, Show)
