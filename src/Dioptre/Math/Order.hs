{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Math.Order
-- Description : The larger, the smaller, the infinite
--
-- Of two numbers the larger and the smaller one, and what they are where that is not plain: NaN is neither larger nor
-- smaller than any number, nor is a number than its equal. 'larger' and 'smaller' say so in the simplest way: the
-- first one if it is, else the second.
--
-- >    larger   |  1    2   NaN   0       smaller  |  1    2   NaN   0
-- >    ---------+--------------------     ---------+--------------------
-- >      1      |  1    2   NaN   1         1      |  1    1   NaN   0
-- >      2      |  2    2   NaN   2         2      |  1    2   NaN   0
-- >     NaN     |  1    2   NaN   0        NaN     |  1    2   NaN   0
-- >     -0      |  1    2   NaN   0        -0      | -0   -0   NaN   0         the first one on the left, the second above
--
-- So the order of the two tells where NaN goes: what must not be lost stands second. (The library's 'max' and 'min'
-- choose otherwise.)
module Dioptre.Math.Order
  ( larger,
    smaller,
    infinity,
    finite,
  )
where

-- $setup
-- >>> let nan = 0 / 0 :: Double

-- | The first number if it is larger than the second; the second if not: if it is larger, or equal, or if either is
-- NaN.
--
-- >>> larger 1 2
-- 2.0
-- >>> (larger nan 2, larger 2 nan)
-- (2.0,NaN)
-- >>> (larger 0 (-0), larger (-0) 0)
-- (-0.0,0.0)
larger :: Double -> Double -> Double
larger x y = if x > y then x else y
{-# INLINE larger #-}

-- | The first number if it is smaller than the second; the second if not: if it is smaller, or equal, or if either is
-- NaN.
--
-- >>> smaller 1 2
-- 1.0
-- >>> (smaller nan 2, smaller 2 nan)
-- (2.0,NaN)
smaller :: Double -> Double -> Double
smaller x y = if x < y then x else y
{-# INLINE smaller #-}

-- | Larger than every other number.
infinity :: Double
infinity = 1 / 0
{-# INLINE infinity #-}

-- | Whether a number is neither infinite nor NaN. (The largest number is (2 - 2^-52) 2^1023. See Note [Literals] of
-- "Dioptre.Math.Roots".)
finite :: Double -> Bool
finite x = abs x <= 0x1.fffffffffffffp23 * (h * h * h * h * h * h * h * h * h * h)
  where
    h = 0x1p100
{-# INLINE finite #-}
