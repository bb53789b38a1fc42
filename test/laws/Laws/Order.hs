-- |
-- Module      : Laws.Order
-- Description : What is true of the order of doubles, and of their numbers
--
-- The second opinion is the order of rational numbers, which every finite double is, and the bits.
module Laws.Order
  ( Special (..),
    specialCorners,

    -- * The larger and the smaller
    largerIsTheLarger,
    smallerIsTheSmaller,
    theSecondStays,
    isMirrored,
    isFiniteOrNot,

    -- * Numbers
    ordinalsKeepTheOrder,
    ordinalsAreUndone,
    ordinalsAreUndoneBack,
    neighboursAreNext,
    midpointIsBetween,
  )
where

import Dioptre.Math.Order (finite, infinity, larger, smaller)
import Dioptre.Math.Ordinal (fromOrdinal, midpoint, toOrdinal)
import GHC.Float (castDoubleToWord64)
import Laws.Draw
import Test.QuickCheck

-- | A double of any kind: NaN, infinities, both zeros, subnormal ones, neighbours.
newtype Special = Special Double
  deriving (Show)

instance Arbitrary Special where
  arbitrary = Special <$> oneof [elements [0 / 0, 0, -0.0], elements corners, (`nudged` 1) <$> chooseInt (-2, 2), chooseInt (-1074, 1023) >>= ofSize, number Few]
    where
      corners = [0 / 0, infinity, negate infinity, 0, -0.0, 1, -1, 5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, -1.7976931348623157e308]

-- | What pairs of them must be.
specialCorners :: Special -> Special -> [(String, Bool)]
specialCorners (Special x) (Special y) =
  [ ("the first is NaN, the second is not", isNaN x && not (isNaN y)),
    ("the second is NaN, the first is not", isNaN y && not (isNaN x)),
    ("they are equal, with other bits", x == y && bits x /= bits y),
    ("they are the same", bits x == bits y),
    ("one is infinite", isInfinite x || isInfinite y),
    ("the first is larger", x > y),
    ("the second is larger", y > x)
  ]

bits :: Double -> Integer
bits = toInteger . castDoubleToWord64

-- | Of two numbers it is one, and neither is larger.
largerIsTheLarger :: Special -> Special -> Property
largerIsTheLarger (Special x) (Special y) = not (isNaN x || isNaN y) ==> let z = larger x y in z `elem` [x, y] .&&. z >= x .&&. z >= y

-- | Of two numbers it is one, and neither is smaller.
smallerIsTheSmaller :: Special -> Special -> Property
smallerIsTheSmaller (Special x) (Special y) = not (isNaN x || isNaN y) ==> let z = smaller x y in z `elem` [x, y] .&&. z <= x .&&. z <= y

-- | Where the first is no larger (or no smaller), be it equal or NaN, or the second be NaN, it is the second, to the
-- bit.
theSecondStays :: Special -> Special -> Property
theSecondStays (Special x) (Special y) = conjoin ([bits (larger x y) === bits y | not (x > y)] ++ [bits (smaller x y) === bits y | not (x < y)])

{- HLINT ignore theSecondStays "Use <=" -}
{- HLINT ignore theSecondStays "Use >=" -}

-- | The larger of two is the smaller of their opposites, turned round.
isMirrored :: Special -> Special -> Property
isMirrored (Special x) (Special y) = bits (larger x y) === bits (negate (smaller (negate x) (negate y)))

-- | A number is finite unless it is infinite or NaN.
isFiniteOrNot :: Special -> Property
isFiniteOrNot (Special x) = finite x === not (isInfinite x || isNaN x)

-- | The numbers of two doubles are in their order, and equal if they are.
ordinalsKeepTheOrder :: Special -> Special -> Property
ordinalsKeepTheOrder (Special x) (Special y) = not (isNaN x || isNaN y) ==> compare (toOrdinal x) (toOrdinal y) === compare x y

-- | A double's number leads back to it; that of @-0@ to @0@.
ordinalsAreUndone :: Special -> Property
ordinalsAreUndone (Special x) = not (isNaN x) ==> bits (fromOrdinal (toOrdinal x)) === bits (if x == 0 then 0 else x)

-- | A number's double leads back to it.
ordinalsAreUndoneBack :: Property
ordinalsAreUndoneBack = forAll numbers $ \i -> toOrdinal (fromOrdinal i) === i

-- | The numbers of doubles, from minus infinity to infinity.
numbers :: Gen Int
numbers = oneof [choose (negate most, most), choose (-3, 3), (most -) <$> choose (0, 3)]
  where
    most = toOrdinal infinity

-- | There is no double between those of two neighbouring numbers: half way between them, exactly, is rounded to one
-- of them.
neighboursAreNext :: Property
neighboursAreNext = forAll (numbers `suchThat` (\i -> all (finite . fromOrdinal) [i, i + 1])) $ \i ->
  let x = fromOrdinal i
      y = fromOrdinal (i + 1)
   in x < y .&&. fromRational ((toRational x + toRational y) / 2) `elem` [x, y]

-- | The midpoint of two numbers is half their sum, rounded down, however large they are.
midpointIsBetween :: Property
midpointIsBetween = forAll ((,) <$> any' <*> any') $ \(i, j) -> toInteger (midpoint i j) === (toInteger i + toInteger j) `div` 2
  where
    any' = oneof [choose (minBound, maxBound), choose (-3, 3), (maxBound -) <$> choose (0, 3), (minBound +) <$> choose (0, 3)]
