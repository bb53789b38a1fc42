-- |
-- Module      : Laws.Draw
-- Description : Numbers and vectors that put geometry to the test
--
-- Three kinds of numbers: small integers and their halves, with which almost everything is computed exactly and rays
-- meet edges, rims and corners for certain; numbers with all their digits; and numbers of many sizes. Zeros are
-- frequent in all of them.
module Laws.Draw
  ( -- * Numbers
    Kind (..),
    anyKind,
    number,
    positive,
    ofSize,
    powerOfTwo,
    fraction,

    -- * Vectors
    point,
    step,
    axisStep,
    dyadicStep,
    anyVector,
    mix,

    -- * Doubles next to each other
    nudged,
    ulpsApart,
  )
where

import Dioptre.Math.Vector (Vector, (*^))
import GHC.Float (castDoubleToWord64, castWord64ToDouble)
import Linear.V3 (V3 (..))
import Test.QuickCheck

-- | How many digits numbers have, and how large they are.
data Kind
  = -- | Integers from -12 to 12, and halves.
    Few
  | -- | 53 random bits, from 2^-3 to 2^4.
    Full
  | -- | 53 random bits, from 2^-20 to 2^20.
    Wide
  deriving (Eq, Show, Enum, Bounded)

anyKind :: Gen Kind
anyKind = elements [minBound ..]

-- | A number, zero at times.
number :: Kind -> Gen Double
number kind = frequency [(1, pure 0), (6, other)]
  where
    other = case kind of
      Few -> oneof [fromIntegral <$> chooseInt (-12, 12), (/ 2) . fromIntegral <$> chooseInt (-24, 24)]
      Full -> chooseInt (-3, 4) >>= ofSize
      Wide -> chooseInt (-20, 20) >>= ofSize

-- | A number greater than zero.
positive :: Kind -> Gen Double
positive kind = case kind of
  Few -> fromIntegral <$> chooseInt (1, 8)
  _ -> abs <$> (number kind `suchThat` (/= 0))

-- | A double of about 2^e, of either sign, with random digits.
ofSize :: Int -> Gen Double
ofSize e = do
  digits <- chooseInteger (2 ^ (52 :: Int), 2 ^ (53 :: Int) - 1)
  sign <- elements [1, -1]
  pure (sign * scaleFloat (e - 52) (fromInteger digits))

-- | 2^e, with e between the bounds, of either sign.
powerOfTwo :: Int -> Int -> Gen Double
powerOfTwo low high = (*) <$> elements [1, -1] <*> (flip scaleFloat 1 <$> chooseInt (low, high))

-- | A number from 0 to 1; both ends, and numbers close to them, are frequent.
fraction :: Gen Double
fraction = oneof [elements [0, 1, 0.5], inside, abs <$> (chooseInt (-60, -2) >>= ofSize), (1 -) . abs <$> (chooseInt (-52, -2) >>= ofSize)]
  where
    inside = (* 2 ** (-53)) . fromInteger <$> chooseInteger (0, 2 ^ (53 :: Int))

-- | A vector, zero at times.
point :: Kind -> Gen Vector
point kind = V3 <$> number kind <*> number kind <*> number kind

-- | A vector that is not zero; along an axis or in a plane of two axes at times.
step :: Kind -> Gen Vector
step kind = frequency [(1, axisStep kind), (5, point kind `suchThat` (/= 0))]

-- | A vector along an axis.
axisStep :: Kind -> Gen Vector
axisStep kind = do
  x <- (*) <$> elements [1, -1] <*> positive kind
  elements [V3 x 0 0, V3 0 x 0, V3 0 0 x]

-- | A vector of zeros and powers of two, by which one can divide without rounding.
dyadicStep :: Gen Vector
dyadicStep = (V3 <$> part <*> part <*> part) `suchThat` (/= 0)
  where
    part = frequency [(1, pure 0), (3, powerOfTwo (-1) 2)]

-- | The point at the fraction t of the way from a to b, (1 - t) a + t b.
mix :: Vector -> Vector -> Double -> Vector
mix a b t = (1 - t) *^ a + t *^ b

-- | A vector of any kind, zero at times.
anyVector :: Gen Vector
anyVector = anyKind >>= point

-- | The double some steps up or down in magnitude; zero has none.
nudged :: Int -> Double -> Double
nudged n x
  | x == 0 = x
  | otherwise = signum x * castWord64ToDouble (castDoubleToWord64 (abs x) + fromIntegral n)

-- | How many steps lie between two doubles.
ulpsApart :: Double -> Double -> Integer
ulpsApart x y = abs (place x - place y)
  where
    place z = (if z < 0 then negate else id) (toInteger (castDoubleToWord64 (abs z)))
