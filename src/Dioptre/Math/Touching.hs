{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Math.Touching
-- Description : When roots that nearly touch are one
--
-- >    \       /      \       /      \       /        a polynomial p near a zero c of its derivative: two roots,
-- >     \     /        \     /        \  .  /         one root twice, none. With coefficients that were rounded,
-- >   ---\-.-/---    ---`-.-'---    -------------     which of the three is computed is chance where p(c) is
-- >       `-'             c                           small enough.
--
-- The rule that says what "small enough" is, for "Dioptre.Math.Quartic" in doubles and for "Dioptre.Math.ExactRoots"
-- in whole numbers. See Note [Roots that touch].
module Dioptre.Math.Touching
  ( mergingBits,
    mergingPart,
    residualBits,
    residualPart,
  )
where

-- | Roots are one where they are closer to each other than about two to the power of minus this, of their size: 25.
mergingBits :: Int
mergingBits = 25

-- | The same, as said of p(c) beside a zero of the derivative with multiplicity m, 1 to 3: the part of its Taylor
-- term of degree m + 1 within which it counts as zero, 3\/4 2^(-25 (m + 1)).
mergingPart :: Int -> Double
mergingPart m = case m of
  1 -> 0x0.cp-50
  2 -> 0x0.cp-75
  _ -> 0x0.cp-100
{-# INLINE mergingPart #-}

-- | And p(c) is at most two to the power of minus this, of the sum of the sizes of the terms: 50.
residualBits :: Int
residualBits = 50

-- | The same as a part: 2^-50, which is 8 roundings.
residualPart :: Double
residualPart = 0x1p-50

{- Note [Roots that touch]
   ~~~~~~~~~~~~~~~~~~~~~~~
A double root is where p(c) = 0 at a critical point. With irrational c, or coefficients that were rounded, p(c) is
small and not zero. It counts as zero if

  |p(c)| <= 3/4 2^(-25 (m + 1)) |T c^(m + 1)|   and   |p(c)| <= 8 eps s

where T is the Taylor coefficient of degree m + 1 at c, and s the sum of the sizes of the terms. The first inequality
is about the place of roots: near c the polynomial is p(c) + T h^(m + 1), whose zeros, real or complex, are all at the
distance |p(c) / T|^(1 / (m + 1)) < 2^-25 |c| from c. Two of them are closer than 2^-24 of their size. So where no two
roots are that close, nothing is merged and the number of roots is exact. The second is about the coefficients: moved
by 8 eps of themselves, they make c a root indeed. It keeps residuals at rounding level.

The other way round: let a polynomial with a double root r, and others well apart, have its coefficients rounded. Then
p(r) is at most eps s; T r^2 is about s unless other roots are near; and 3/4 2^-50 is 6 eps. So it is merged, and r is
found as the zero of p', a simple one, to full accuracy, not as two roots that are 10^-8 apart, or as none. That is
what makes a ray tangent to a torus hit it, and twice.

Two neighbours c may both pass: where three roots nearly coincide, and c1, c2 are a little too far apart to be one.
They cannot both be roots, since p rises or falls between them; if each were a double root, a cubic polynomial would
have four. Then neither counts (unless p(c) is zero exactly), and the roots are what the signs say:
"Dioptre.Math.ExactRoots" sees to it. With no two neighbours that count there are never more roots than the degree: k
critical points leave k + 1 intervals, and each that counts takes the two beside it, which are its own, and gives m +
1.

Roots near zero are no exception, since everything is relative to their size: p(0) = 0 is decided exactly, beforehand.

Where three roots or four nearly coincide, the first bound (2^-75 or 2^-100) may be below what the compensated scheme
can tell. Then, if the value cannot be told from zero, whole numbers decide. In pictures this is very rare.
-}
