-- |
-- Module      : Dioptre.Optics.Reflection
-- Description : Mirrors
--
-- >  v \  ^ N  / R
-- >     \ |   /        R = v - 2 <v, N> N
-- >      v|  /
-- >  -----+-------     the angle out is the angle in
module Dioptre.Optics.Reflection
  ( reflected,
    reflect,
  )
where

import Dioptre.Math.Vector (Unit, Vector, dot, opposite, unit, vector, (*^))

-- | The direction in which a mirror with unit normal N sends what arrives in direction v. Its length is v's.
--
-- Laws: reflecting twice gives v again; the part along N changes its sign, the part across stays.
reflected :: Vector -> Unit -> Vector
reflected v n = v - (2 * dot v (vector n)) *^ vector n
{-# INLINE reflected #-}

-- | The same for any direction: v is made unit and the normal turned against it first; 'Nothing' for the zero vector.
reflect :: Vector -> Unit -> Maybe Vector
reflect v n = (\u -> reflected (vector u) (against u n)) <$> unit v
  where
    against u m = if dot (vector u) (vector m) > 0 then opposite m else m
