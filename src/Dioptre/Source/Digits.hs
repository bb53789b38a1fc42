-- |
-- Module      : Dioptre.Source.Digits
-- Description : The fewest digits that read back
--
-- Between the middles to its two neighbours every decimal reads back as a number, and in such a middle if its last bit
-- is 0, for readers round ties to the even one:
--
-- > ----(----x----)----    odd: without the middles
-- > ----[----x----]----    even: with them
--
-- Sources: G. L. Steele and J. L. White, "How to print floating-point numbers accurately", 1990; R. G. Burger and R. K.
-- Dybvig, "Printing floating-point numbers quickly and accurately", 1996, whose section 3.1 takes the middles in.
module Dioptre.Source.Digits
  ( shortestDigits,
  )
where

import Data.Char (digitToInt)
import Data.List (dropWhileEnd)
import Numeric (floatToDigits)

-- | The fewest decimal digits that read back as a number greater than zero, of several such the nearest, and an
-- exponent: x = 0.DIGITS times ten to that. The last digit is not 0.
--
-- >>> map shortestDigits [0.25, 1e23]
-- [([2,5],0),([1],24)]
--
-- See Note [Middles].
--
-- Spec: numbers.writing.
shortestDigits :: Double -> ([Int], Int)
shortestDigits x
  | x >= 2 ^ (53 :: Int) && x < 10 ^ (40 :: Int), digits : _ <- map digitsOf (filter readsBack [below, below + 1]) = digits
  | otherwise = found
  where
    found@(ds, e) = floatToDigits 10 x
    -- Decimals of one digit less stand so far apart; these are around x.
    step = 10 ^ (e - length ds + 1) :: Integer
    below = truncate x `div` step
    readsBack n = fromRational (fromInteger (n * step)) == x
    digitsOf n = let text = show (n * step) in (map digitToInt (dropWhileEnd (== '0') text), length text)

-- Note [Middles]
-- ~~~~~~~~~~~~~~
-- 'floatToDigits' does not take the middles in: 1e23 lies in the middle between 99999999999999991611392 and a number
-- that ends in a 1, reads back as the former, and is written 9.999999999999999e22. With a middle fewer digits do only
-- if it has fewer itself. At most one of the decimals of n - 1 digits around x can be one: a shorter one between the
-- middles would have been found.
--
-- Few middles are so short. One is M 2^k with M odd and of 54 or 55 bits. Of at most 16 digits, it is N 10^j with N
-- below 10^16. Where j is at least 0, 5^j divides M, which makes j at most 23 and the middle less than 10^39. Where k
-- is negative, as it is for all numbers below 2^53, N is at least 5 M, which has more than 16 digits; a subnormal
-- number's M is smaller, and its 5^1075 is not. So the middles need no look outside 2^53 and 10^40.
