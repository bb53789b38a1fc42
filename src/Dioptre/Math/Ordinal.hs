-- |
-- Module      : Dioptre.Math.Ordinal
-- Description : Doubles, counted
--
-- The bits of a double that is not negative, read as a whole number, count the doubles from zero up: so those between
-- two of them can be halved, and halved again, until none is left; and how far two of them are from each other can be
-- said in doubles.
--
-- >   -2   -5e-324   0   5e-324   1    2     ...     1 / 0          the double
-- >   --|------|-----|------|-----|----|---- ... ------|------
-- >           -1     0      1                       2047 2^52       its number
--
-- 'toOrdinal' goes down, 'fromOrdinal' up.
module Dioptre.Math.Ordinal
  ( toOrdinal,
    fromOrdinal,
    midpoint,
  )
where

import Data.Bits (unsafeShiftR, xor, (.&.))
import GHC.Float (castDoubleToWord64, castWord64ToDouble)

-- | The number of a double, when they are counted from zero upwards and downwards; 0 for @-0@ too. (NaN has a number
-- beyond that of infinity, which means nothing.)
--
-- Law: it keeps the order.
--
-- Spec: numbers.ulp.
toOrdinal :: Double -> Int
toOrdinal x
  | x < 0 = negate (fromIntegral (castDoubleToWord64 (negate x)))
  | otherwise = fromIntegral (castDoubleToWord64 (abs x))

-- | The double with a number.
--
-- Law: it undoes 'toOrdinal'.
fromOrdinal :: Int -> Double
fromOrdinal i
  | i < 0 = negate (castWord64ToDouble (fromIntegral (negate i)))
  | otherwise = castWord64ToDouble (fromIntegral i)

-- | The whole number in the middle of two, the lower one of two such: without their sum, which might overflow.
--
-- >>> (midpoint 3 8, midpoint (-8) (-3), midpoint maxBound (maxBound - 2) == maxBound - 1)
-- (5,-6,True)
midpoint :: Int -> Int -> Int
midpoint i j = (i .&. j) + ((i `xor` j) `unsafeShiftR` 1)
