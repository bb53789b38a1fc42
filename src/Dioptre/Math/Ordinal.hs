{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Math.Ordinal
-- Description : Doubles, counted
--
-- The bits of a double that is not negative, read as a whole number, count the doubles from zero up: so those between two of them can be halved, and halved again, until none is left.
--
-- >  -2   -1    0    1    2     ...     position (1 / 0)
-- >   |----|----|----|----|--- ... ------|
-- >  two    smallest    two             infinity
module Dioptre.Math.Ordinal
  ( finite,
    position,
    ordinal,
    average,
  )
where

import Data.Bits (unsafeShiftR, xor, (.&.))
import GHC.Float (castDoubleToWord64, castWord64ToDouble)

-- | Whether a number is neither infinite nor NaN. (The largest number is (2 - 2^-52) 2^1023. See Note [Literals] of "Dioptre.Math.Roots".)
finite :: Double -> Bool
finite x = abs x <= 0x1.fffffffffffffp23 * (h * h * h * h * h * h * h * h * h * h)
  where
    h = 0x1p100
{-# INLINE finite #-}

-- | The number of a double, when they are counted from zero upwards and downwards.
position :: Double -> Int
position x
  | x < 0 = negate (fromIntegral (castDoubleToWord64 (negate x)))
  | otherwise = fromIntegral (castDoubleToWord64 (abs x))

-- | The whole number in the middle, without the sum, which might overflow.
average :: Int -> Int -> Int
average i j = (i .&. j) + ((i `xor` j) `unsafeShiftR` 1)

-- | The double of a number.
--
-- Law: the inverse of 'position'.
ordinal :: Int -> Double
ordinal i
  | i < 0 = negate (castWord64ToDouble (fromIntegral (negate i)))
  | otherwise = castWord64ToDouble (fromIntegral i)
