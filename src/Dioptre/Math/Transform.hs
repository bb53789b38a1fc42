{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Math.Transform
-- Description : Scale, turn and move
--
-- The transformation that the scene language writes: a scale along the axes, then rotations about the x, y and z axes in this order,
-- in degrees, then a translation. This version reads, checks and writes it.
module Dioptre.Math.Transform
  ( Transform,
    transform,
    transformScale,
    transformRotation,
    transformTranslation,
    identity,
  )
where

import Dioptre.Math.Vector (V3 (..), Vector)

-- | A transformation that can be undone.
data Transform = Transform
  { -- | Factors along x, y, z; none is zero.
    transformScale :: Vector,
    -- | Degrees about x, then y, then z, right-handed.
    transformRotation :: Vector,
    transformTranslation :: Vector
  }
  deriving stock (Eq, Show)

-- | From scale, rotation and translation; 'Nothing' if a factor is zero.
transform :: Vector -> Vector -> Vector -> Maybe Transform
transform s r t
  | any (== 0) s = Nothing
  | otherwise = Just (Transform s r t)

-- | The transformation that changes nothing.
identity :: Transform
identity = Transform (V3 1 1 1) 0 0
