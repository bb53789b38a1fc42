-- |
-- Module      : Dioptre.Optics.Refraction
-- Description : Light that passes from one medium into another
--
-- >  v \  ^ N           n1 sin a1 = n2 sin a2
-- >   a1\ |    n1
-- >      v|             T = r v + (r c - sqrt (1 - r^2 (1 - c^2))) N,
-- >  -----+-------      r = n1 / n2, c = -<v, N> = cos a1
-- >       |\   n2
-- >       | \ T         nothing passes where c^2 + (n2 / n1)^2 < 1
--
-- Snell's law as a rule for vectors: the part of T across N is r times that of v, which is the law of sines, and the
-- part along N is what makes T unit. Source: A. S. Glassner (ed.), An Introduction to Ray Tracing, 1989, chapter 4,
-- section 5.
module Dioptre.Optics.Refraction
  ( refracted,
  )
where

import Dioptre.Math.Order (larger)
import Dioptre.Math.Vector (Unit, Vector, dot, vector, (*^))

-- | The direction in which unit v goes on through a surface with unit normal N turned against it, from a medium of
-- index n1 into one of index n2; 'Nothing' where all of it is reflected. Equal indices change nothing, at any angle.
--
-- Laws: n1 sin a1 = n2 sin a2; v, N and T lie in one plane; going back along T returns along v.
--
-- Spec: optics.refract, optics.refract.straight, optics.refract.equal, optics.refract.total, optics.body.total.
refracted :: Vector -> Unit -> Double -> Double -> Maybe Vector
refracted v n n1 n2
  | n1 == n2 = Just v
  | c * c + (n2 / n1) * (n2 / n1) < 1 = Nothing
  -- Straight on: beyond 2^26, r c - 1 keeps less than half of its digits, and in the end r^2 is infinite.
  | sine2 <= 0 && r > 67108864 = Just v
  | otherwise = Just (r *^ v + (r * c - sqrt across) *^ vector n)
  where
    r = n1 / n2
    c = negate (dot v (vector n))
    sine2 = 1 - c * c
    -- Not total reflection, so this is negative by rounding only, at the critical angle.
    across = larger (1 - r * r * sine2) 0
{-# INLINE refracted #-}
