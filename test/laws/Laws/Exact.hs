-- |
-- Module      : Laws.Exact
-- Description : Vectors of rational numbers, which have no rounding
--
-- A double is a rational number. What a shape's equation makes of doubles is therefore known exactly, and so is how
-- far a computed number is from it. Every bound of the laws is counted in 'eps', the largest relative error of one
-- rounding, by the usual rule: n roundings in a row change a number by a factor of at most 1 +- 'gamma' n (N. Higham,
-- "Accuracy and Stability of Numerical Algorithms", lemma 3.1). It holds as long as nothing overflows or underflows;
-- the generators keep far away from there.
module Laws.Exact
  ( -- * Rounding
    eps,
    gamma,

    -- * Vectors
    Exact,
    exact,
    along,
    inner,
    outer,
    squared,
    magnitudes,
    magnitude,
    outerMagnitudes,
    components,

    -- * Square roots
    rootBelow,
    rootAbove,
  )
where

import Data.Bits (shiftR)
import Data.Ratio (denominator, numerator)
import Dioptre.Math.Vector (Vector)
import Linear.V3 (V3 (..))

-- | The largest relative error of one rounding: 2^-53.
eps :: Rational
eps = 1 / 2 ^ (53 :: Int)

-- | The largest relative error of n roundings in a row, n eps \/ (1 - n eps).
gamma :: Int -> Rational
gamma n = k / (1 - k)
  where
    k = fromIntegral n * eps

-- | A vector of rational numbers.
type Exact = V3 Rational

-- | The same vector.
exact :: Vector -> Exact
exact = fmap toRational

-- | o + t d.
along :: Exact -> Exact -> Rational -> Exact
along o d t = (+) <$> o <*> fmap (t *) d

-- | The inner product, written out once more.
inner :: Exact -> Exact -> Rational
inner (V3 a b c) (V3 x y z) = a * x + b * y + c * z

-- | The outer product, written out once more.
outer :: Exact -> Exact -> Exact
outer (V3 a b c) (V3 x y z) = V3 (b * z - c * y) (c * x - a * z) (a * y - b * x)

-- | The square of the length.
squared :: Exact -> Rational
squared v = inner v v

-- | The components' magnitudes. @inner (magnitudes a) (magnitudes b)@ is what the rounding errors of a product count
-- by.
magnitudes :: Exact -> Exact
magnitudes = fmap abs

-- | The sum of the components' magnitudes: at least the length.
magnitude :: Exact -> Rational
magnitude = sum . magnitudes

-- | What the rounding errors of an outer product count by: the sum of the magnitudes of each component's two terms.
outerMagnitudes :: Exact -> Exact -> Exact
outerMagnitudes a b = V3 (ay * bz + az * by) (az * bx + ax * bz) (ax * by + ay * bx)
  where
    V3 ax ay az = magnitudes a
    V3 bx by bz = magnitudes b

-- | The three components.
components :: V3 a -> [a]
components (V3 x y z) = [x, y, z]

-- | A number not above the square root, and one not below it, 2^-150 of it apart: enough for errors to be measured in
-- 2^-53.
rootBelow, rootAbove :: Rational -> Rational
rootBelow = fst . rootBetween
rootAbove = snd . rootBetween

rootBetween :: Rational -> (Rational, Rational)
rootBetween x
  | x <= 0 = (0, 0)
  | otherwise = (r / scale, (r + 1) / scale)
  where
    -- 4^k x has more than 300 bits before its point.
    k = 151 + max 0 ((bits (denominator x) - bits (numerator x)) `div` 2 + 1)
    scale = 2 ^ k
    r = fromInteger (integerRoot (4 ^ k * numerator x `div` denominator x)) :: Rational
    bits n = length (takeWhile (> 0) (iterate (`shiftR` 64) n)) * 64

-- | The largest integer whose square is not above the number, by Newton's method from above.
integerRoot :: Integer -> Integer
integerRoot n = go (2 ^ (length (takeWhile (> 0) (iterate (`shiftR` 2) n)) :: Int))
  where
    go x
      | y >= x = x
      | otherwise = go y
      where
        y = (x + n `div` x) `div` 2
