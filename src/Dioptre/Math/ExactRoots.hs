{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Math.ExactRoots
-- Description : Real roots by whole numbers
--
-- A double is a whole number times a power of two, and so is the value of a polynomial with such coefficients at such a place. Its sign is certain, whatever the sizes. "Dioptre.Math.Quartic", whose
-- notes tell the rule, turns to this where binary64 cannot tell, or does not reach.
module Dioptre.Math.ExactRoots
  ( exactRoots,
  )
where

import Data.Bits (shiftL)
import Dioptre.Math.Order (finite, infinity)
import Dioptre.Math.Ordinal (fromOrdinal, midpoint, toOrdinal)

-- | The real roots of a polynomial with these coefficients, the leading one first, ascending, as often as their multiplicity: by the rule of "Dioptre.Math.Quartic", with exact signs, and with halving of the doubles that remain instead of Newton's
-- method. Each simple root is the double nearest to it. Coefficients are finite, the first is not zero.
--
-- Cost: a millisecond or so, for degree 4.
exactRoots :: [Double] -> [Double]
exactRoots coefficients = filter finite (concatMap (\(x, m) -> replicate m x) (exactChain (length numbers - 1) numbers))
  where
    parts = map decodeFloat coefficients
    lowest = minimum [k | (n, k) <- parts, n /= 0]
    numbers = [if n == 0 then 0 else n `shiftL` (k - lowest) | (n, k) <- parts]
{-# NOINLINE exactRoots #-}

-- | Roots with multiplicities of a polynomial of a degree, from those of its derivative.
exactChain :: Int -> [Integer] -> [(Double, Int)]
exactChain 0 _ = []
exactChain n p = go (negate top) (signAt (negate top)) (zip3 criticals touching (zipWith3 counts (False : touching) criticals (drop 1 touching ++ [False])))
  where
    -- The place after the largest double: decodeFloat takes infinity for 2^1024.
    top = toOrdinal infinity
    signAt = signum . evaluated p . dyadic . fromOrdinal
    criticals = exactChain (n - 1) (zipWith (*) p (map toInteger [n, n - 1 .. 1]))
    touching = map (uncurry touches) criticals
    -- Given whether the neighbours touch. Between two that do, the polynomial rises or falls, so that not both can be roots: neither counts. One where it is zero exactly counts always, so that the signs that are left are not zero.
    counts before (c, _) after = signAt (toOrdinal c) == 0 || not (before || after)
    go i s [] = crossing i s top (signAt top)
    go i s (((c, m), touch, alone) : rest)
      | touch && alone = crossing i s j 0 ++ (c, m + 1) : go j 0 rest
      | otherwise = crossing i s j s' ++ go j s' rest
      where
        j = toOrdinal c
        s' = signAt j
    crossing i s j s'
      | s * s' < 0 = [(halved i s j, 1)]
      | otherwise = []
    halved i s j
      | j <= i + 1 = if s * signum (evaluated p (halfway i j)) > 0 then fromOrdinal j else fromOrdinal i
      | s' == 0 = fromOrdinal k
      | s' == s = halved k s j
      | otherwise = halved i s k
      where
        k = midpoint i j
        s' = signAt k
    halfway i j = let (x, k) = dyadic (fromOrdinal i); (y, l) = dyadic (fromOrdinal j); h = max k l in ((x `shiftL` (h - k)) + (y `shiftL` (h - l)), h + 1)
    touches c m = v == 0 || (4 * v `shiftL` (25 * (m + 1)) <= 3 * term && v `shiftL` 50 <= sizes)
      where
        x = dyadic c
        v = abs (evaluated p x)
        term = abs (evaluated (zipWith (*) p (map (`choose` (m + 1)) [n, n - 1 .. 0])) x)
        sizes = evaluated (map abs p) (let (y, k) = x in (abs y, k))
    choose i k = product (map toInteger [i - k + 1 .. i]) `div` product (map toInteger [1 .. k])

-- | A double as n \/ 2^k, k not negative.
dyadic :: Double -> (Integer, Int)
dyadic x
  | k >= 0 = (n `shiftL` k, 0)
  | otherwise = (n, negate k)
  where
    (n, k) = decodeFloat x

-- | p(n \/ 2^k) times 2^(k degree).
evaluated :: [Integer] -> (Integer, Int) -> Integer
evaluated p (n, k) = fst (foldl next (0, 0) p)
  where
    next (!v, !shift) a = (v * n + (a `shiftL` shift), shift + k)
