-- |
-- Module      : Laws.ErrorFree
-- Description : What is true of what rounding takes
--
-- The second opinion is rational arithmetic, in which nothing is rounded.
module Laws.ErrorFree
  ( Pair (..),
    pairCorners,
    productsAreWhole,
    sumsAreWhole,
    shortSquaresAreExact,
  )
where

import Dioptre.Math.ErrorFree (halves, productError, sumError)
import Laws.Draw
import Test.QuickCheck

-- | Two numbers of many sizes, whose product and sum are in the range of the laws; zeros, powers of two, and numbers
-- that nearly cancel are frequent.
data Pair = Pair Double Double
  deriving (Eq, Show)

instance Arbitrary Pair where
  arbitrary = oneof [apart, near, Pair <$> few <*> few]
    where
      apart = Pair <$> upTo 484 <*> upTo 484
      near = do
        x <- upTo 300
        k <- chooseInt (-3, 3)
        sign <- elements [1, -1]
        Pair x . (sign *) . nudged k <$> elements [x, 2 * x]
      few = number Few
      upTo most = frequency [(1, pure 0), (2, powerOfTwo (negate most) most), (6, chooseInt (negate most, most) >>= ofSize)]

-- | What the generator must reach.
pairCorners :: Pair -> [(String, Bool)]
pairCorners (Pair x y) =
  [ ("the product is rounded", toRational (x * y) /= toRational x * toRational y),
    ("the product is exact, and not zero", x * y /= 0 && toRational (x * y) == toRational x * toRational y),
    ("the sum is rounded", toRational (x + y) /= toRational x + toRational y),
    ("the sum cancels", x /= 0 && abs (x + y) < abs x / 1024),
    ("the first is the larger by far", abs x > 2 ** 60 * abs y),
    ("the second is", abs y > 2 ** 60 * abs x)
  ]

-- | A product is what it is as computed, and what rounding took: exactly.
productsAreWhole :: Pair -> Property
productsAreWhole (Pair x y) = toRational x * toRational y === toRational z + toRational (productError x (halves y) z)
  where
    z = x * y

-- | A sum is what it is as computed, and what rounding took: exactly.
sumsAreWhole :: Pair -> Property
sumsAreWhole (Pair x y) = toRational x + toRational y === toRational s + toRational (sumError x y s)
  where
    s = x + y

-- | A number of at most 26 digits has a square that loses nothing.
shortSquaresAreExact :: Property
shortSquaresAreExact = forAll (chooseInteger (1, 2 ^ (26 :: Int) - 1)) $ \n -> forAll (chooseInt (-300, 300)) $ \k ->
  let x = scaleFloat k (fromInteger n) in productError x (halves x) (x * x) === 0
