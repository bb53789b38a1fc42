{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Model.Single
-- Description : Decimal numbers of single precision, quickly
--
-- Models are written in decimals, a hundred megabytes of them, and mean numbers of single precision (IEEE 754
-- binary32): the nearest one to the decimal, of two that are equally near the one whose last bit is 0. They are kept as
-- doubles, which hold every single exactly.
--
-- > number = [sign] (1*digit ["." *digit] / "." 1*digit) [("e" / "E") [sign] 1*digit]
-- > sign   = "+" / "-"
--
-- Nearly all are found with one multiplication or division of doubles; the few where that cannot decide go through
-- exact arithmetic. See Note [Two roundings].
module Dioptre.Model.Single
  ( single,

    -- * In the middle of a line
    Scanned (..),
    scan,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Ratio ((%))
import Data.Vector.Unboxed (Vector)
import qualified Data.Vector.Unboxed as Vector
import Data.Word (Word8)
import Dioptre.Math.Order (infinity)
import Dioptre.Model.Words (byteAt, digit, isBlank, isDigit, minus, plus, point, wordFrom)
import Dioptre.Source.Diagnostic (Refusal (..))
import Dioptre.Source.Text (characters)
import GHC.Float (double2Float, float2Double)

-- | The number that a word says.
--
-- >>> single "0.1"
-- Right 0.10000000149011612
-- >>> single "1e39"
-- Left (TooLarge "1e39")
-- >>> single "nan"
-- Left (NotANumber "nan")
--
-- Spec: models.obj.numbers.
single :: ByteString -> Either Refusal Double
single word
  | end < Bytes.length word || isNaN x = Left (NotANumber (characters word))
  | isInfinite x = Left (TooLarge (characters word))
  | otherwise = Right x
  where
    Scanned end x = scan word 0

-- | What stands at a place of a line: where it ends, and its value. The value is NaN where it is not a number, and
-- infinite where it is one beyond single precision (from 2^128 - 2^103, some 3.4e38, on).
data Scanned = Scanned {-# UNPACK #-} !Int {-# UNPACK #-} !Double
  deriving stock (Show)

-- | The number at a place of a line, up to the next blank or the end. The place is not below 0.
--
-- >>> scan "v -1.5 2" 2
-- Scanned 6 (-1.5)
--
-- Spec: models.obj.numbers.
scan :: ByteString -> Int -> Scanned
scan line from = whole start 0
  where
    !n = Bytes.length line
    -- Only asked below n.
    at = byteAt line
    !negative = from < n && at from == minus
    !start = if from < n && (at from == minus || at from == plus) then from + 1 else from
    whole :: Int -> Int -> Scanned
    whole !i !m
      | i < n, isDigit (at i) = whole (i + 1) (10 * m + digit (at i))
      | i < n, at i == point = fraction (i + 1) (i + 1) m
      | i == start = noNumber
      | otherwise = mantissa i 0 (i - start) m
    fraction :: Int -> Int -> Int -> Scanned
    fraction !i !first !m
      | i < n, isDigit (at i) = fraction (i + 1) first (10 * m + digit (at i))
      | i - 1 == start = noNumber
      | otherwise = mantissa i (first - i) (i - start - 1) m
    -- The digits before this place, without the point, are so many, and make m; it is to be multiplied with ten to the
    -- e.
    mantissa :: Int -> Int -> Int -> Int -> Scanned
    mantissa !i !e !count !m
      | i == n || isBlank (at i) = value i i e count m
      | at i == smallE || at i == largeE = signed
      | otherwise = noNumber
      where
        signed
          | i + 1 < n, at (i + 1) == minus = power (i + 2) (i + 2) (-1) 0
          | i + 1 < n, at (i + 1) == plus = power (i + 2) (i + 2) 1 0
          | otherwise = power (i + 1) (i + 1) 1 0
        power :: Int -> Int -> Int -> Int -> Scanned
        power !j !first !sign !k
          -- Beyond 10^9 no digits before it bring the number back into the range of singles: a line has fewer.
          | j < n, isDigit (at j) = power (j + 1) first sign (if k < 1000000000 then 10 * k + digit (at j) else k)
          | j == first || (j < n && not (isBlank (at j))) = noNumber
          | otherwise = value j i (e + sign * k) count m
    value :: Int -> Int -> Int -> Int -> Int -> Scanned
    value !end !digitsEnd !e !count !m = Scanned end (if negative then negate magnitude else magnitude)
      where
        magnitude
          -- m is exact: 10^18 < 2^63.
          | count <= 18, m == 0 = 0
          | count <= 18, abs e <= largestPower, near == far = float2Double near
          | otherwise = exactly (Bytes.take (digitsEnd - start) (Bytes.drop start line)) e
        about = if e < 0 then fromIntegral m / tenTo (negate e) else fromIntegral m * tenTo e
        near = double2Float (about * (1 - margin))
        far = double2Float (about * (1 + margin))
    noNumber = Scanned (wordFrom line from) (0 / 0)

-- | How far, in parts of itself, a product or quotient of doubles may be from the decimal that it stands for, and more:
-- 2^-50. See Note [Two roundings].
margin :: Double
margin = 1 / 1125899906842624

-- | Powers of ten, each the nearest double.
powers :: Vector Double
powers = Vector.fromList [fromInteger (10 ^ k) | k <- [0 .. largestPower]]
{-# NOINLINE powers #-}

-- | The largest exponent of those powers.
largestPower :: Int
largestPower = 60

-- | A power of ten; only for exponents from 0 to the largest of those.
tenTo :: Int -> Double
tenTo = Vector.unsafeIndex powers

-- | The single nearest to these digits, passing over a point among them, times ten to that exponent; by arithmetic
-- without rounding. See Note [Enough digits].
exactly :: ByteString -> Int -> Double
exactly text e
  | Bytes.null significant = 0
  | magnitude > 40 = infinity
  | magnitude < -50 = 0
  | otherwise = float2Double (fromRational (integer * 10 ^ max 0 power % 10 ^ max 0 (negate power)))
  where
    significant = Bytes.dropWhile (== zero) (Bytes.filter (/= point) text)
    (first, rest) = Bytes.splitAt 200 significant
    kept = if Bytes.any (/= zero) rest then Bytes.snoc first (zero + 1) else first
    -- The value is 0.significant times ten to the magnitude, and kept times ten to the power.
    magnitude = Bytes.length significant + e
    power = magnitude - Bytes.length kept
    integer = Bytes.foldl' (\m c -> 10 * m + toInteger (digit c)) 0 kept
{-# NOINLINE exactly #-}

zero, smallE, largeE :: Word8
zero = 48
smallE = 101
largeE = 69

-- Note [Two roundings]
-- ~~~~~~~~~~~~~~~~~~~~
-- The decimal is x = m 10^e with m an integer of at most 18 digits. Rounded to a double, m is off by at most u = 2^-53
-- of itself, so is the power of ten, and so is their product or quotient y: altogether y = x (1 + d) with |d| < 3.1 u.
-- Rounding y to a single would round a second time, and could end one unit away from the right one:
-- 1.000000059604644775390626 is above the middle between 1 and its next single, but its nearest double is the middle,
-- which goes to 1.
--
-- Rounding is monotone, so it is enough to round both ends of an interval around x: where they agree, so does x. With
-- the margin 2^-50 = 8 u, the ends y (1 - 8 u) and y (1 + 8 u), each computed with one more rounding u, still have x
-- between them, as 8 u - u > 3.1 u. Where they do not agree, x is within 12 u of the middle between two singles, which
-- happens to about one number in thirty million, and to those that are such a middle.
--
-- Nothing overflows on the way (m 10^60 < 10^78), and nothing underflows (10^-60); singles below 2^-126, which have
-- fewer bits, and those that are too large are rounded by the processor as by the standard, and the argument holds for
-- them too.

-- Note [Enough digits]
-- ~~~~~~~~~~~~~~~~~~~~
-- A word may be a million digits long. The middle between two singles is M 2^-150 with M < 2^25, or an integer; that is
-- M 5^150 / 10^150, which has at most 113 significant digits (and an integer below 2^129 has 39). So the first 200
-- digits, with a digit 1 after them if anything but zeros follows, lie on the same side of every middle as the whole
-- number does. Of a number 0.ddd times ten to the k the singles end at k = 39 (10^38 < 2^128 < 10^39), and halves of
-- the smallest one, 2^-150 > 10^-46, at k = -45.
