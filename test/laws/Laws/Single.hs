-- |
-- Module      : Laws.Single
-- Description : Decimals of single precision against exact arithmetic
--
-- The nearest single of a decimal, found with integers: the decimal is a rational number, which is cut into units of
-- the single's last bit and rounded by 'round', to even where two are as near.
module Laws.Single
  ( -- * Decimals
    Decimal (..),
    middles,

    -- * Laws
    isTheNearest,
    nearestSingle,
  )
where

import qualified Data.ByteString.Char8 as Char8
import Data.Maybe (fromMaybe)
import Data.Ratio (denominator, numerator)
import Dioptre.Model.Single (single)
import Dioptre.Source.Diagnostic (Refusal (..))
import Test.QuickCheck

-- | A decimal as it is written, and its value.
data Decimal = Decimal String Rational
  deriving (Show)

-- | The single nearest to a number, of two that are equally near the even one; none where that would be 2^128 or more.
nearestSingle :: Rational -> Maybe Rational
nearestSingle x
  | x < 0 = negate <$> nearestSingle (negate x)
  | rounded >= 2 ^ (128 :: Int) = Nothing
  | otherwise = Just rounded
  where
    rounded = fromInteger (round (x / unit')) * unit'
    -- 24 bits, of which the last is worth 2^-149 at least.
    unit' = until (\u -> x < 2 ^ (24 :: Int) * u) (* 2) (2 ^^ (-149 :: Int))

-- | A decimal is read as the single nearest to it; one that is too large for singles is refused.
isTheNearest :: Decimal -> Property
isTheNearest (Decimal text value) = case nearestSingle value of
  Just x -> fmap toRational (single (Char8.pack text)) === Right x
  Nothing -> counterexample text (either isTooLarge (const False) (single (Char8.pack text)))
  where
    isTooLarge why = case why of
      TooLarge _ -> True
      _ -> False

-- | Decimals as programs write them, and as none would.
instance Arbitrary Decimal where
  arbitrary = do
    before <- digitsOf =<< frequency [(6, choose (0, 4)), (1, choose (5, 45))]
    behind <- digitsOf =<< frequency [(6, choose (0, 10)), (3, choose (11, 20)), (1, choose (21, 300))]
    power <- frequency [(4, pure Nothing), (2, Just <$> choose (-12, 12)), (1, Just <$> choose (-70, 50))]
    sign <- elements ["", "-", "+"]
    bare <- arbitrary
    let digits = if null (before <> behind) then ("0", "") else (before, behind)
        text = fst digits <> (if null behind && bare then "" else '.' : behind)
        magnitude = fromInteger (read ('0' : uncurry (<>) digits)) * 10 ^^ (fromMaybe 0 power - length behind)
    pure (Decimal (sign <> text <> maybe "" (\e -> 'e' : show (e :: Int)) power) (if sign == "-" then negate magnitude else magnitude))
    where
      digitsOf n = vectorOf n (elements "0123456789")

-- | The middle between two neighbouring singles, and numbers a very little to either side, with all their digits.
middles :: Gen Decimal
middles = do
  m <- choose (1, 2 ^ (24 :: Int) - 1)
  k <- frequency [(1, pure (-149)), (1, pure 104), (4, choose (-149, 104))]
  nudge <- elements [-1, 0, 1]
  -- (m + 1/2) 2^k = (2m + 1) 2^(k-1), which has as many decimals as it is halved.
  let x = fromInteger (2 * m + 1) * 2 ^^ (k - 1 :: Int) :: Rational
      places = length (takeWhile (/= 1) (iterate (`div` 2) (denominator x))) + 3
      scaled = x * 10 ^ places
      digits = show (numerator scaled + nudge)
      padded = replicate (places + 1 - length digits) '0' <> digits
      (before, behind) = splitAt (length padded - places) padded
  pure (Decimal (before <> "." <> behind) (fromInteger (numerator scaled + nudge) / 10 ^ places))
