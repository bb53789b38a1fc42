{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Math.ErrorFree
-- Description : What rounding took, exactly
--
-- The product of two doubles has up to 106 binary digits, of which rounding keeps the first 53. What it takes is a
-- double too, and can be had by plain arithmetic; so it is with sums. These are known as error-free transformations.
--
-- >   x y    |<------------------- exactly -------------------->|
-- >   z      |<--- x * y, rounded --->|
-- >   e                               |<------ x y - z -------->|        x y = z + e,  to the last digit
--
-- Thus a sum of products can be told from zero, or computed with twice the digits: "Dioptre.Math.Roots" does it with a
-- discriminant, "Dioptre.Math.Quartic" with a polynomial.
--
-- All of this holds as long as nothing leaves the range: factors below 2^995, and products above 2^-968 or equal to
-- zero. (The last digits of a smaller product lie below the smallest double.) Those who use it see to that.
--
-- Sources:
--
-- * T. J. Dekker, /A Floating-Point Technique for Extending the Available Precision/ (1971),
--   <https://doi.org/10.1007/BF01397083>: products, and the halves, which are G. W. Veltkamp's.
-- * D. E. Knuth, /The Art of Computer Programming/, volume 2, section 4.2.2, theorem B: sums.
module Dioptre.Math.ErrorFree
  ( -- * Products
    Halves,
    halves,
    productError,

    -- * Sums
    sumError,
  )
where

-- $setup
-- >>> :set -XHexFloatLiterals

-- | A number as the sum of two with at most 26 bits each, so that products of such halves are exact.
data Halves = Halves !Double !Double

-- | The halves of x: @g = (2^27 + 1) * x@, @x1 = g - (g - x)@, @x2 = x - x1@.
halves :: Double -> Halves
halves x = Halves x1 (x - x1)
  where
    !g = 0x8000001 * x
    !x1 = g - (g - x)
{-# INLINE halves #-}

-- | What rounding took from a product: @productError x (halves y) (x * y)@ is the exact product less the rounded one.
-- The second factor is given by its halves, since one number is often multiplied by many.
--
-- The products of the halves, which are exact, are subtracted from @z = x * y@, the largest first:
-- @x2 * y2 - (((z - x1 * y1) - x1 * y2) - x2 * y1)@.
--
-- >>> let x = 1 + 0x1p-30
-- >>> productError x (halves x) (x * x) == 0x1p-60
-- True
--
-- Spec: numbers.binary64.
productError :: Double -> Halves -> Double -> Double
productError x (Halves y1 y2) z = x2 * y2 - (((z - x1 * y1) - x1 * y2) - x2 * y1)
  where
    !(Halves x1 x2) = halves x
{-# INLINE productError #-}

-- | What rounding took from a sum: @sumError x y (x + y)@ is the exact sum less the rounded one, whichever of the two
-- is the larger.
--
-- >>> sumError 1 0x1p-60 (1 + 0x1p-60) == 0x1p-60
-- True
sumError :: Double -> Double -> Double -> Double
sumError x y s = (x - (s - t)) + (y - t)
  where
    !t = s - x
{-# INLINE sumError #-}
