{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Math.ExactRoots
-- Description : Real roots by whole numbers
--
-- A double is a whole number times a power of two, and so is the value of a polynomial with such coefficients at such
-- a place. Its sign is certain, whatever the sizes. "Dioptre.Math.Quartic" turns to this where binary64 cannot tell,
-- or does not reach.
--
-- The way is the same as there, written down plainly: between two neighbouring zeros of its derivative a polynomial
-- only rises or only falls, so that the signs at the two tell whether it has a root between them. A cubic, worked
-- through:
--
-- > p = x^3 - 3 x + 2,  p' = 3 x^2 - 3,  p'' = 6 x
-- >
-- >         marks          signs there      zeros
-- > p''     ends           - +              one change of sign: 0, found by halving
-- > p'      ends, 0        + - +            two changes: -1 and 1
-- > p       ends, -1, 1    - + 0 +          one change: -2; and 1, where p touches zero, twice
-- >
-- > The roots: -2, 1, 1
--
-- The ends are the numbers beyond all doubles, the other marks are the zeros of the line above.
module Dioptre.Math.ExactRoots
  ( exactRoots,
  )
where

import Data.Bits (shiftL)
import Dioptre.Math.Order (finite, infinity)
import Dioptre.Math.Ordinal (fromOrdinal, midpoint, toOrdinal)
import Dioptre.Math.Touching (mergingBits, residualBits)

-- | The real roots of a polynomial with these coefficients, the leading one first, ascending, as often as their
-- multiplicity: with exact signs, and by the rule of "Dioptre.Math.Touching" where they nearly touch. Each simple
-- root is the double nearest to it. Coefficients are finite, the first is not zero.
--
-- >>> exactRoots [1, 0, -3, 2]
-- [-2.0,1.0,1.0]
--
-- Cost: a millisecond or so, for degree 4.
exactRoots :: [Double] -> [Double]
exactRoots coefficients = filter finite (concat [replicate m x | Zero x m <- zeros (madeWhole coefficients)])
{-# NOINLINE exactRoots #-}

-------------------------------------------------------------------------------
-- Roots between marks

-- | A zero of a polynomial: the double there, or nearest to it, and its multiplicity.
data Zero = Zero !Double !Int

-- | A place on the line, by the number of its double; the sign of the polynomial there, and the zero that it has
-- there, if it does. Then the sign is 0.
data Mark = Mark !Int !Integer ![Zero]

-- | The zeros of a polynomial, ascending, from those of its derivative.
zeros :: Polynomial -> [Zero]
zeros p
  | degree p == 0 = []
  | otherwise = concat (zipWith upTo marks (drop 1 marks))
  where
    marks = [end (negate farthest)] ++ marked p (zeros (derivative p)) ++ [end farthest]
    end place = Mark place (signAt p place) []
    -- The place after the largest double: infinity, which decodeFloat takes for 2^1024.
    farthest = toOrdinal infinity
    upTo before here@(Mark _ _ found) = between p before here ++ found

-- | The one zero between two neighbouring marks, if the signs differ there.
between :: Polynomial -> Mark -> Mark -> [Zero]
between p (Mark low s _) (Mark high s' _) = [Zero (halved p s low high) 1 | s * s' < 0]

-- | The double nearest to the only zero between two places, given the sign at the lower one. The doubles between are
-- halved until none is left; then the sign half way between the two tells which is nearer.
halved :: Polynomial -> Integer -> Int -> Int -> Double
halved p s = go
  where
    go low high
      | high <= low + 1 = fromOrdinal (if s * signum (valueAt p (middle low high)) > 0 then high else low)
      | s' == 0 = fromOrdinal half
      | s' == s = go half high
      | otherwise = go low half
      where
        half = midpoint low high
        s' = signAt p half
    middle low high = halfway (dyadic (fromOrdinal low)) (dyadic (fromOrdinal high))

-- | What the zeros of the derivative, ascending, are for a polynomial: its zeros too, or places where it has a sign.
marked :: Polynomial -> [Zero] -> [Mark]
marked p criticals = zipWith3 mark criticals touching (zipWith (||) (False : touching) (drop 1 touching ++ [False]))
  where
    touching = map (touches p) criticals
    -- Between two that touch the polynomial rises or falls, so that not both can be zeros: neither counts. One where
    -- it is zero exactly counts always, so that the signs that are left are not zero.
    mark (Zero c m) touch nextToOne
      | s == 0 || (touch && not nextToOne) = Mark place 0 [Zero c (m + 1)]
      | otherwise = Mark place s []
      where
        place = toOrdinal c
        s = signAt p place

-- | Whether a polynomial counts as zero at a zero c of its derivative, of multiplicity m, as far as that zero alone
-- can tell: Note [Roots that touch] of "Dioptre.Math.Touching". All numbers are multiplied by the same power of two
-- here.
touches :: Polynomial -> Zero -> Bool
touches p (Zero c m) = closeInPlace && smallInValue
  where
    -- where |p(c)| <= 3/4 2^(-25 (m + 1)) |T c^(m + 1)|
    closeInPlace = 4 * value `shiftL` (mergingBits * (m + 1)) <= 3 * term
    -- where |p(c)| <= 8 eps s
    smallInValue = value `shiftL` residualBits <= sizes
    at@(Dyadic n k) = dyadic c
    value = abs (valueAt p at)
    -- T c^k, of k = m + 1, is the sum of the (i over k) a_i c^i.
    term = abs (valueAt (zipWith (*) p (map (`choose` (m + 1)) (powers p))) at)
    sizes = valueAt (map abs p) (Dyadic (abs n) k)
    choose i j = product (map toInteger [i - j + 1 .. i]) `div` product (map toInteger [1 .. j])

-- | The sign of a polynomial at the double with a number: -1, 0 or 1.
signAt :: Polynomial -> Int -> Integer
signAt p = signum . valueAt p . dyadic . fromOrdinal

-------------------------------------------------------------------------------
-- Whole numbers

-- | Whole coefficients, the leading one first.
type Polynomial = [Integer]

-- | The same polynomial times a power of two, so that all coefficients are whole.
madeWhole :: [Double] -> Polynomial
madeWhole coefficients = [if n == 0 then 0 else n `shiftL` (k - lowest) | (n, k) <- parts]
  where
    parts = map decodeFloat coefficients
    lowest = minimum [k | (n, k) <- parts, n /= 0]

degree :: Polynomial -> Int
degree p = length p - 1

-- | The powers of x that the coefficients belong to.
powers :: Polynomial -> [Int]
powers p = [degree p, degree p - 1 .. 0]

derivative :: Polynomial -> Polynomial
derivative p = zipWith (*) p (map toInteger (takeWhile (> 0) (powers p)))

-- | The number n \/ 2^k, k not negative.
data Dyadic = Dyadic !Integer !Int

-- | A double, exactly.
dyadic :: Double -> Dyadic
dyadic x
  | k >= 0 = Dyadic (n `shiftL` k) 0
  | otherwise = Dyadic n (negate k)
  where
    (n, k) = decodeFloat x

-- | Half the sum of two.
halfway :: Dyadic -> Dyadic -> Dyadic
halfway (Dyadic n k) (Dyadic m l) = Dyadic ((n `shiftL` (h - k)) + (m `shiftL` (h - l))) (h + 1)
  where
    h = max k l

-- | p(n \/ 2^k) times 2^(k degree), by Horner's rule.
valueAt :: Polynomial -> Dyadic -> Integer
valueAt p (Dyadic n k) = go 0 0 p
  where
    go !value !shift coefficients = case coefficients of
      [] -> value
      a : rest -> go (value * n + (a `shiftL` shift)) (shift + k) rest
