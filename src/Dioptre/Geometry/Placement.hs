-- |
-- Module      : Dioptre.Geometry.Placement
-- Description : Rays for shapes that were scaled, turned and moved
--
-- >   world                      the shape's own frame
-- >
-- >        .-""-.                    .---.
-- >   o-->( .-'  )    M^-1     o--> (     )        o + t d is on the ellipsoid where
-- >        `-..-'     ---->          `---'         M^-1 o + t L^-1 d is on the sphere: at the same t
-- >
-- A transformed shape is met by a ray where the shape itself is met by the ray carried back. The transformation of the
-- line is linear in its parameter, so the parameters found there are the ray's, if the direction is carried as it is
-- and not made unit. The normal found there is carried forth by 'Dioptre.Math.Transform.transformNormal'.
module Dioptre.Geometry.Placement
  ( Placement,
    placement,
    carriedBack,
    carriedForth,
  )
where

import Dioptre.Geometry.Ray (Ray, direction, origin, ray)
import Dioptre.Math.Transform (Placement, inverseDirection, inversePosition, placement, transformDirection, transformPosition)

-- | A ray of the world in the frame of the shape: the same parameters, a direction of another length.
--
-- Law: the position at a parameter, carried forth, is the position of the ray at that parameter, to rounding.
--
-- Spec: geometry.transformed.parameters, geometry.transformed.uv, models.transformed.
carriedBack :: Placement -> Ray -> Ray
carriedBack m r = ray (inversePosition m (origin r)) (inverseDirection m (direction r))
{-# INLINE carriedBack #-}

-- | A ray of the shape's frame in the world.
--
-- Spec: transform.ray.
carriedForth :: Placement -> Ray -> Ray
carriedForth m r = ray (transformPosition m (origin r)) (transformDirection m (direction r))
{-# INLINE carriedForth #-}
