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
  )
where

import Dioptre.Math.Vector (Unit, Vector, dot, vector, (*^))

-- | The direction in which a mirror with unit normal N sends what arrives in direction v. Its length is v's.
--
-- Laws: reflecting twice gives v again; the part along N changes its sign, the part across stays; it does not matter
-- which side N is on.
--
-- Spec: optics.reflect, optics.reflect.along, optics.mirror.
reflected :: Vector -> Unit -> Vector
reflected v n = v - (2 * dot v (vector n)) *^ vector n
{-# INLINE reflected #-}
