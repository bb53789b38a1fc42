{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Math.Quartic
-- Description : Real roots of cubic and quartic polynomials
--
-- Where a ray meets a torus, a polynomial of degree 4 in the ray's parameter is zero. This module finds its real zeros,
-- and those of degree 3, with the promises of "Dioptre.Math.Roots": total, ascending, with multiplicity, finite, no
-- @-0@, and the same bits when all coefficients are multiplied by @+-2^m@.
--
-- Between two neighbouring zeros of the derivative a polynomial only rises or only falls, so that it has one root there
-- or none, and the signs at the two ends tell which:
--
-- >          c1                         p' = 0 at c1, c2, c3
-- >   \     .-.            /            p(c1) > 0 > p(c2): one root between them
-- >    \   /   \    c3    /             p(c3) = 0: a double root, there
-- > ----x-x-----x---.x.--------- x
-- >      c0      \_/   (the same for the derivative, one degree lower, down to the square root)
-- >               c2
--
-- No formula for degree 4 does better: Ferrari's loses half of the digits exactly where a ray grazes a torus, and must
-- be repaired by iteration anyway. See Note [Roots between critical points].
--
-- What holds beyond the common promises:
--
-- * __Number.__ There are as many roots as the polynomial with these very coefficients has, multiplicity counted,
--   unless two of its roots, real or complex, lie closer to each other than 2^-24 of their size. Roots closer than that
--   whose difference is within the rounding of the coefficients are given as one multiple root, so that a tangent ray
--   is tangent although its coefficients were rounded; unless two neighbouring zeros of the derivative would both be
--   such roots, which cannot be: then roots are given as they are. See Note [Roots that touch] of
--   "Dioptre.Math.Touching".
-- * __Place.__ A root that is given once is one of the two doubles beside an exact root, or that root, however near
--   others are; a multiple one is the zero of the derivative that it is. (Where a power of x leaves degree two, the
--   roots are those of "Dioptre.Math.Roots".)
-- * __Residual.__ |p(x)| <= 8 eps (|a x^n| + ... + |e|), eps = 2^-53, at every root.
-- * __The same bits everywhere.__ Only @+ - * \/@ and @sqrt@ of binary64 are used, and whole numbers where those cannot
--   tell.
--
-- Sources:
--
-- * S. Graillat, Ph. Langlois, N. Louvet, /Algorithms for accurate, validated and fast polynomial evaluation/ (2009),
--   <https://doi.org/10.1007/BF03186531>: the value of a polynomial as if computed with twice the digits.
-- * C. Yuksel, /High-Performance Polynomial Root Finding for Graphics/ (2022), <https://doi.org/10.1145/3543865>: roots
--   between critical points, with Newton's method kept in its interval.
module Dioptre.Math.Quartic
  ( cubicRoots,
    quarticRoots,
  )
where

import Data.Bits (shiftL, unsafeShiftR)
import Dioptre.Math.ErrorFree (halves, productError, sumError)
import Dioptre.Math.ExactRoots (exactRoots)
import Dioptre.Math.Order (finite, larger, smaller)
import Dioptre.Math.Ordinal (fromOrdinal, midpoint, toOrdinal)
import Dioptre.Math.Roots (quadraticRoots)
import Dioptre.Math.Touching (mergingPart, residualPart)
import GHC.Float (castDoubleToWord64, castWord64ToDouble)

-- | The real roots of @a x^3 + b x^2 + c x + d@, ascending, as often as their multiplicity; 'quadraticRoots' @b c d@
-- when @a@ is zero.
--
-- >>> cubicRoots 1 (-6) 11 (-6)
-- [1.0,2.0,3.0]
-- >>> cubicRoots 1 (-3) 0 4
-- [-1.0,2.0,2.0]
-- >>> cubicRoots 1 0 0 0
-- [0.0,0.0,0.0]
--
-- Cost: less than a microsecond; see 'quarticRoots'.
--
-- Spec: roots.total, roots.ascending, roots.degree, roots.no-negative-zero, roots.scale, roots.cubic.count,
--   roots.multiple, roots.residual, roots.simple.
cubicRoots :: Double -> Double -> Double -> Double -> [Double]
cubicRoots a b c d
  | not (finite a && finite b && finite c && finite d) = []
  | a == 0 = quadraticRoots b c d
  | d == 0 = withZero (quadraticRoots a b c)
  | otherwise = scaled cubic 0 a b c d

-- | The real roots of @a x^4 + b x^3 + c x^2 + d x + e@, ascending, as often as their multiplicity; 'cubicRoots' @b c d
-- e@ when @a@ is zero.
--
-- >>> quarticRoots 1 (-10) 35 (-50) 24
-- [1.0,2.0,3.0,4.0]
-- >>> quarticRoots 1 0 (-2) 0 1
-- [-1.0,-1.0,1.0,1.0]
-- >>> quarticRoots 1 0 0 0 1
-- []
--
-- Cost: about a microsecond, and some hundred bytes. Whole numbers do the work, in milliseconds, where three
-- roots or more nearly coincide; and where of the largest coefficient the leading one is less than 2^-60, the last one
-- less than 2^-200, or another, other than zero, less than 2^-400.
--
-- Spec: numbers.not-finite, numbers.tolerances.only, roots.total, roots.ascending, roots.degree, roots.finite,
--   roots.no-negative-zero, roots.scale, roots.quartic.count, roots.multiple, roots.residual, roots.simple,
--   geometry.torus.precision.
quarticRoots :: Double -> Double -> Double -> Double -> Double -> [Double]
quarticRoots a b c d e
  | not (finite a && finite b && finite c && finite d && finite e) = []
  | a == 0 = cubicRoots b c d e
  | e == 0 = withZero (cubicRoots a b c d)
  | otherwise = scaled quartic a b c d e

-- | Ascending roots, and one more that is zero.
--
-- Spec: roots.zero-root.
withZero :: [Double] -> [Double]
withZero roots = let (below, above) = span (< 0) roots in below ++ 0 : above

-------------------------------------------------------------------------------
-- Preparing

-- | Coefficients multiplied by the power of two that brings the largest between 1 and 2, and by the sign that makes the
-- leading one positive; then solved in binary64 if their sizes allow it, and if that leaves no doubt. See Note [Sizes].
scaled :: (Double -> Double -> Double -> Double -> Double -> Chain) -> Double -> Double -> Double -> Double -> Double -> [Double]
scaled solve a b c d e
  | abs lead >= 0x1p-60 && abs e' >= 0x1p-100 * 0x1p-100 && harmless b' && harmless c' && harmless d' =
    case solve a' b' c' d' e' of
      Unsure -> exactRoots coefficients
      chain -> listed chain
  | otherwise = exactRoots coefficients
  where
    coefficients = if a == 0 then [b, c, d, e] else [a, b, c, d, e]
    leading = if a == 0 then b else a
    largest = abs a `larger` abs b `larger` abs c `larger` abs d `larger` abs e
    -- First to the middle of the range of exponents, then to 1: both factors are normal numbers. (2^-500 and 2^500,
    -- 2^600 and 2^-600. See Note [Literals] of "Dioptre.Math.Roots".)
    !j
      | largest < small * small * small * small * small = large * large * large * large * large * large
      | largest > large * large * large * large * large = small * small * small * small * small * small
      | otherwise = 1
    small = 0x1p-100
    large = 0x1p100
    !k = castWord64ToDouble ((2046 - (castDoubleToWord64 (j * largest) `unsafeShiftR` 52)) `shiftL` 52)
    !k' = if leading < 0 then negate k else k
    !a' = k' * (j * a)
    !b' = k' * (j * b)
    !c' = k' * (j * c)
    !d' = k' * (j * d)
    !e' = k' * (j * e)
    !lead = if a == 0 then b' else a'
    harmless x = x == 0 || abs x >= small * small * small * small
{-# INLINE scaled #-}

-------------------------------------------------------------------------------
-- Polynomials

-- | Places on the line in ascending order, each with its multiplicity.
data Chain
  = End
  | Link !Double !Int !Chain
  | -- | The digits at hand do not tell, or two neighbours are in each other's way: whole numbers decide.
    Unsure

-- | A place before others; in doubt where it is @nowhere@, or where they are in doubt.
link :: Double -> Int -> Chain -> Chain
link _ _ Unsure = Unsure
link x m rest
  | finite x = Link x m rest
  | otherwise = Unsure
{-# INLINE link #-}

-- | What @root@ gives where the digits at hand do not tell the last ones of a root.
nowhere :: Double
nowhere = 0 / 0

listed :: Chain -> [Double]
listed (Link x m rest) = replicate m x ++ listed rest
listed _ = []

-- | a x^4 + b x^3 + (c + c') x^2 + d x + e, of degree 4 or 3, with a positive leading coefficient; c' is what rounding
-- took from c.
data Poly = Poly !Double !Double !Double !Double !Double !Double

-- | A polynomial at a place.
data Value = Value
  { -- | Its value: to 2^-6 of itself where it was computed once, to 2^-40 or better with twice the digits, or to @doubt@.
    value :: !Double,
    -- | The sum of the absolute values of its terms.
    size :: !Double,
    -- | Whether the value was computed with twice the digits.
    refined :: !Bool
  }

-- | The value by Horner's rule; where that says little, since the terms cancel, by the compensated rule.
at :: Poly -> Double -> Value
at p@(Poly a b c _ d e) !x
  | abs v > 0x1p-44 * s = Value v s False
  | otherwise = Value (compensated p x) s True
  where
    !v = (((a * x + b) * x + c) * x + d) * x + e
    !y = abs x
    !s = (((a * y + abs b) * y + abs c) * y + abs d) * y + abs e
{-# INLINE at #-}

-- | What the compensated value of a polynomial with this sum of sizes may err by, beyond its own rounding: 2^-99 of it.
doubt :: Double -> Double
doubt s = 0x1p-99 * s
{-# INLINE doubt #-}

-- | The compensated Horner scheme: each product and sum with what rounding took from it, carried along.
compensated :: Poly -> Double -> Double
compensated (Poly a b c c' d e) !x
  | a == 0 = afterCubic b 0
  | otherwise = let !p = a * x; !s = p + b in afterCubic s (productError a xs p + sumError p b s)
  where
    !xs = halves x
    afterCubic !h !l =
      let !p1 = h * x
          !s1 = p1 + c
          !l1 = l * x + ((productError h xs p1 + sumError p1 c s1) + c')
          !p2 = s1 * x
          !s2 = p2 + d
          !l2 = l1 * x + (productError s1 xs p2 + sumError p2 d s2)
          !p3 = s2 * x
          !s3 = p3 + e
          !l3 = l2 * x + (productError s2 xs p3 + sumError p3 e s3)
       in s3 + l3
    {-# INLINE afterCubic #-}

-- | The derivative at a place.
slope :: Poly -> Double -> Double
slope (Poly a b c _ d _) x = ((4 * a * x + 3 * b) * x + 2 * c) * x + d
{-# INLINE slope #-}

-- | The coefficient of h^k in p(x + h), for k from 2.
taylor :: Int -> Poly -> Double -> Double
taylor k (Poly a b c _ _ _) x = case k of
  2 -> (6 * a * x + 3 * b) * x + c
  3 -> 4 * a * x + b
  _ -> a

-------------------------------------------------------------------------------
-- Roots from critical points

quartic :: Double -> Double -> Double -> Double -> Double -> Chain
quartic a b c d e = between p (between p' inflections)
  where
    !p = Poly a b c 0 d e
    !p' = Poly 0 (4 * a) b3 b3' (2 * c) d
    !b3 = 2 * b + b
    !b3' = sumError (2 * b) b b3
    !a6 = 4 * a + 2 * a
    -- p'' / 2 = 6 a x^2 + 3 b x + c
    inflections = square a6 (sumError (4 * a) (2 * a) a6) b3 b3' c

-- | The first argument, the leading coefficient of a quartic, is zero.
cubic :: Double -> Double -> Double -> Double -> Double -> Chain
cubic _ a b c d = between (Poly 0 a b 0 c d) (square a3 (sumError (2 * a) a a3) (2 * b) 0 c)
  where
    !a3 = 2 * a + a

-- | The roots of (a + a') x^2 + (b + b') x + c, to a few ulp; those closer than 2^-24 of their size are one, by the
-- rule of "Dioptre.Math.Touching".
square :: Double -> Double -> Double -> Double -> Double -> Chain
square a a' b b' c
  | d > 0.125 * w = two d
  | d < -0.125 * w = End
  | abs delta <= mergingPart 1 * u = Link (negate b / (2 * a)) 2 End
  | delta > 0 = two delta
  | otherwise = End
  where
    !u = b * b
    !v = (4 * a) * c
    !d = u - v
    !w = u + abs v
    delta = d + ((productError b (halves b) u + 2 * b * b') - (productError (4 * a) (halves c) v + 4 * a' * c))
    two discriminant =
      let !q = if b < 0 then 0.5 * (sqrt discriminant - b) else -0.5 * (b + sqrt discriminant)
          !x = q / a
          !y = c / q
       in if x < y then Link x 1 (Link y 1 End) else Link y 1 (Link x 1 End)

-- | The roots of a polynomial from those of its derivative.
between :: Poly -> Chain -> Chain
between p@(Poly a b c _ d e) criticals = case criticals of
  End -> link (root p (-1) (negate bound) bound (negate b3 / 3)) 1 End
  Link x m rest -> settled x m $ \v ->
    -- The signs at the far left: of x^4 and of x^3.
    let left = if a /= 0 then 1 else -1
     in if left * v < 0
          then link (root p left (negate bound) x (x - reach x v)) 1 (from x v m rest)
          else from x v m rest
  Unsure -> Unsure
  where
    -- What remains when the value at the critical point x, of multiplicity m, is v.
    from :: Double -> Double -> Int -> Chain -> Chain
    from !x !v !m rest
      | v == 0 = link x (m + 1) (onward x v rest)
      | otherwise = onward x v rest
    onward :: Double -> Double -> Chain -> Chain
    onward !x !v rest = case rest of
      End
        | v < 0 -> link (root p (-1) x bound (x + reach x v)) 1 End
        | otherwise -> End
      Link y m rest' -> settled y m $ \v' ->
        if v * v' < 0
          then link (root p (signum v) x y (inner x v y v')) 1 (from y v' m rest')
          else if v == 0 && v' == 0 then Unsure else from y v' m rest'
      Unsure -> Unsure
    -- The value at a critical point, zero if it counts as zero (Note [Roots that touch] of "Dioptre.Math.Touching").
    settled :: Double -> Int -> (Double -> Chain) -> Chain
    settled !x !m continue
      | not (refined there) = continue v
      | abs v > allowed && abs v > doubt s = continue v
      | doubt s <= allowed = continue 0
      | otherwise = Unsure
      where
        !there = p `at` x
        !v = value there
        !s = size there
        power = case m of
          1 -> x * x
          2 -> x * x * x
          _ -> (x * x) * (x * x)
        !allowed = smaller (residualPart * s) (mergingPart m * abs (taylor (m + 1) p x * power))
    -- No root is farther from zero (Cauchy); a little more, since a root may be that far but for the rounding of the
    -- bound.
    !bound = 0x1.0000000000004p0 * (1 + largest / lead)
    !largest = abs b `larger` abs c `larger` abs d `larger` abs e
    !lead = if a /= 0 then a else b
    !b3 = if a /= 0 then b / a else c / b
    -- How far from the outermost critical point p rises to zero, by its Taylor terms.
    reach :: Double -> Double -> Double
    reach !x !v = if a /= 0 && fourth < second || isNaN second then fourth else second
      where
        !second = sqrt (abs v / abs (taylor 2 p x))
        !fourth = sqrt (sqrt (abs v / lead))
    -- Where p, flat at both ends, crosses zero: s^2 (3 - 2 s) is near 2 s^2 below 1/2.
    inner :: Double -> Double -> Double -> Double -> Double
    inner !x !v !y !v'
      | abs v < abs v' = x + sqrt (0.5 * abs v / (abs v + abs v')) * (y - x)
      | otherwise = y - sqrt (0.5 * abs v' / (abs v + abs v')) * (y - x)

-- | The root between two places, at whose lower one the polynomial has the given sign, and the other sign at the upper
-- one, by Newton's method from a guess, kept between them; or @nowhere@. See Note [Polishing].
root :: Poly -> Double -> Double -> Double -> Double -> Double
root p@(Poly _ _ _ _ _ e) !sign !low !high !guess
  | low < 0 && high > 0 = if e == 0 then 0 else if e * sign > 0 then start 0 high else start low 0
  | otherwise = start low high
  where
    start !l !h = polish 0 l h (if guess > l && guess < h then guess else 0.5 * (l + h))
    polish :: Int -> Double -> Double -> Double -> Double
    polish !n !l !h !x
      | refined there && abs step <= enough * abs x = if x' >= l' && x' <= h' then x' else x
      | refined there && flat && (abs v <= doubt s || x' == x) = nowhere
      | x' > l' && x' < h' && (n < 20 || even n) = polish (n + 1) l' h' x'
      | middle > l' && middle < h' = polish (n + 1) l' h' middle
      | otherwise = x
      where
        !there = p `at` x
        !v = value there
        !s = size there
        !v' = slope p x
        !step = v / v'
        -- Newton's method squares the error, in units of the distance to where the slope vanishes. Where that is near,
        -- no step is the last one.
        !rise = abs (v' * x)
        !enough
          | rise > 0x1p-20 * s = 0x1p-40
          | rise > 0x1p-44 * s = 0x1p-53
          | otherwise = -1
        flat = enough < 0
        !x' = x - step
        !below = v * sign > 0
        !l' = if below then x else l
        !h' = if below then h else x
        middle = if n < 20 then 0.5 * (l' + h') else fromOrdinal (midpoint (toOrdinal l') (toOrdinal h'))
{-# NOINLINE root #-}

{- Note [Roots between critical points]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
Let c1 < c2 < ... be the real zeros of p', with multiplicities. Between neighbours p is strictly monotone, and so it is outside of them all.
Hence, reading from left to right ('between'):

  * Where p has opposite signs at both ends of such an interval, it has exactly one root inside, a simple one. Else it has none inside.
  * Where p(c) = 0 and c is a zero of p' of multiplicity m, c is a root of p of multiplicity m + 1. The intervals beside it have
    none: p is monotone from zero on.
  * At the far left p has the sign of its leading term, and at the far right. The leading coefficient is made positive.

No root is counted twice and none is left out. The zeros of p' are found in the same way from those of p'', and those of the quadratic
p'' by the usual formula. All that is asked are signs of p at given doubles.

These are certain. Horner's rule in binary64 has an error of at most 8 eps times the sum s of the sizes of the terms (eps = 2^-53, degree 4; Higham,
Accuracy and Stability of Numerical Algorithms, section 5.1): a value above 2^-44 s has its sign right, and six bits more. Others are computed again by the compensated scheme,
which carries the error of each operation along, itself computed exactly, and adds it in the end. Its error is eps of the value and
(8 eps)^2 s = 2^-100 s (Graillat, Langlois and Louvet, theorem 3), which @doubt@ doubles. The coefficient 3 b of p' is no double, so it is carried as a sum of two.

What is not certain is where the critical points are: they are doubles near the exact ones. At a simple zero c of p', p differs from its value
at the double nearest to it by p''/2 (2^-53 c)^2, which is nothing beside the tolerance of the next note.
-}

{- Note [Polishing]
   ~~~~~~~~~~~~~~~~
'root' keeps an interval at whose ends p has opposite signs, both certain, and a place x within. Newton's step x - p(x) / p'(x) is taken where it stays in the interval; else the
interval is halved. After 20 steps every second one halves the number of doubles that the interval holds, of which there are fewer than 2^63: so it ends. A few
steps are usual, from a guess that solves the polynomial as it looks from the critical points beside: a parabola outside of them, s^2 (3 - 2 s)
between two.

The last step is made with the compensated value, and needs no test afterwards. Let s be the sum of the sizes of the terms. A step of the relative length u leaves an
error that is, relative to x, at most

  * 6 u^2 s / |x p'(x)|, since p is curved: |x^2 p''(x)| <= 12 s;
  * 2^-48 u s / |x p'(x)|, since p' is rounded: to 29 eps s / |x|;
  * 2^-100 s / |x p'(x)|, since p is: the compensated value (Note [Roots between critical points]).

If |x p'(x)| > 2^-20 s, these are below 2^-57 together for u = 2^-40. If it is above 2^-44 s, they are below 2^-55 for u = 2^-53, also if |x p'(x)| is smaller than computed, by 2^-48 s. The
result is rounded once, by half an ulp at most; an ulp is at least 2^-53 |x|; so it is less than an ulp from the exact root.

If |x p'(x)| <= 2^-44 s, three roots or more are near each other, and the value may not tell one double from the next: beside 1, roots at the distances 2^-19, 2^-18 and 2^-13 suffice. Then
steps are made while they lead on and the value's sign is certain. Should this leave two neighbouring doubles, it is one of them. Else whole numbers decide ('nowhere', 'Unsure').
-}

{- Note [Sizes]
   ~~~~~~~~~~~~
The coefficients are brought to a largest one between 1 and 2. Multiplying by a power of two is exact, so that the same polynomial times
+-2^m gives the same numbers here, and the same roots. (A coefficient that underflows was 2^-1022 times smaller than the largest.)

Let the leading coefficient be at least 2^-60, and the last one at least 2^-200. Then all roots are between 2^-201 and 2^61 in size (Cauchy's bound, for p and for its
reverse), those of the derivatives are below 2^64, and products in the schemes above are below 2^300; halves need 2^27 more. Nothing overflows. What underflows is below
2^-1074 beside a term of 2^-200 or, in the derivatives, beside coefficients of 2^-400: nothing.

Everything else is left to 'exactRoots', which knows no such limits. It follows the same rule, with p(x) computed in whole numbers. It takes a millisecond or so.
-}
