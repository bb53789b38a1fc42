{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Number
-- Description : What is true of numbers that are read and written
--
-- The second opinion is a reading of decimals as rational numbers, which are exact, and the definition of "nearest": a
-- double is nearest to a number that lies between the middles to its two neighbours, or in such a middle if its own
-- last bit is 0.
module Laws.Number
  ( -- * A second opinion
    exactly,
    isNearest,
    neighbour,
    decimalOf,

    -- * Laws
    realIsNearest,
    integerIsExact,
    writtenReadsBack,
    isWrittenShort,
    isWrittenNearest,
    isWrittenPlainly,

    -- * Numbers
    NumberText (..),
    IntegerText (..),
    Admitted (..),
    admitted,
    kindsOfNumbers,
  )
where

import Control.Monad (guard)
import Data.Char (intToDigit)
import Data.Maybe (fromMaybe, isJust)
import Data.Ratio (denominator, numerator)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Diagnostic (Refusal (..))
import Dioptre.Syntax.Value (integer, real, showReal)
import GHC.Float (castDoubleToWord64, castWord64ToDouble, floatToDigits)
import Numeric (showEFloat, showFFloat)
import Test.QuickCheck

-------------------------------------------------------------------------------
-- A second opinion

-- | The number that a text is, by the rule: an optional sign; digits, with or without a point that has a digit on one
-- side at least; and an optional exponent of ten.
exactly :: Text -> Maybe Rational
exactly text = do
  let (plusOrMinus, unsigned) = signOf text
      (mantissa, power) = Text.break (`elem` ("eE" :: String)) unsigned
      (whole, dotted) = Text.break (== '.') mantissa
  e <- if Text.null power then Just 0 else (\(s, t) -> (s *) <$> natural t) (signOf (Text.drop 1 power))
  n <- natural (whole <> Text.drop 1 dotted)
  -- No text here is long enough to make up for an exponent beyond that.
  Just (fromInteger (plusOrMinus * n) * 10 ^^ (max (-20000) (min 20000 e) - toInteger (Text.length (Text.drop 1 dotted))))

signOf :: Text -> (Integer, Text)
signOf text = case Text.uncons text of
  Just ('-', t) -> (-1, t)
  Just ('+', t) -> (1, t)
  _ -> (1, text)

natural :: Text -> Maybe Integer
natural t = read (Text.unpack t) <$ guard (not (Text.null t) && Text.all (`elem` ['0' .. '9']) t)

-- | Whether a double is the one nearest to a number, ties to even.
isNearest :: Rational -> Double -> Bool
isNearest r x = case compare size (middle above) of
  GT -> False
  EQ -> even bits && beyondBelow
  LT -> beyondBelow
  where
    size = if x < 0 || isNegativeZero x then negate r else r
    bits = castDoubleToWord64 (abs x)
    above = toRational (neighbour 1 (abs x))
    middle y = (toRational (abs x) + y) / 2
    beyondBelow
      | bits == 0 = size >= negate (middle above)
      | otherwise = let low = middle (toRational (neighbour (-1) (abs x))) in size > low || (size == low && even bits)

-- | The double so many steps up from one that is not negative.
neighbour :: Int -> Double -> Double
neighbour n x = castWord64ToDouble (castDoubleToWord64 x + fromIntegral n)

-- | All the digits of a number whose denominator is a power of two, and the power of ten that they are multiplied by.
decimalOf :: Rational -> (Integer, Int)
decimalOf r = (numerator r * 5 ^ k, negate k)
  where
    k = length (takeWhile (< denominator r) (iterate (* 2) 1))

-------------------------------------------------------------------------------
-- Laws

-- | A text that is a number is read as the nearest double; a number above 1e100 is refused as too large, and anything
-- else as no number.
--
-- Between 10^100 and the middle to the double above 1e100 lies what is rounded to 1e100: either answer is right.
realIsNearest :: Text -> Property
realIsNearest t = counterexample (show (Text.take 100 t)) $ case exactly t of
  Nothing -> real t === Left (NotANumber t)
  Just r
    | abs r > highest -> real t === Left (TooLarge t)
    | abs r <= 10 ^ (100 :: Int) -> nearest r
    | otherwise -> real t === Left (TooLarge t) .||. nearest r
  where
    highest = (toRational (1e100 :: Double) + toRational (neighbour 1 1e100)) / 2
    nearest r = case real t of
      Right x -> counterexample (show x) (isNearest r x)
      Left refusal -> counterexample (take 100 (show refusal)) False

-- | A text of digits with an optional sign is that integer, if it has 32 bits; one with more is too large, and anything
-- else is no integer.
integerIsExact :: Text -> Property
integerIsExact t = case natural (snd (signOf t)) of
  Nothing -> integer t === Left (NotAnInteger t)
  Just n
    | -2147483648 <= i && i <= 2147483647 -> integer t === Right (fromInteger i)
    | otherwise -> integer t === Left (TooLarge t)
    where
      i = fst (signOf t) * n

-- | Reading what was written gives the same number, bit for bit.
writtenReadsBack :: Admitted -> Property
writtenReadsBack (Admitted x) = fmap castDoubleToWord64 (real (showReal x)) === Right (castDoubleToWord64 x)

-- | No decimal of fewer digits is read as the same number: neither of the two around it.
isWrittenShort :: Admitted -> Property
isWrittenShort (Admitted x) =
  cover 2 (any inTheMiddle (decimalsAround count (abs x))) "written as a middle" $
    counterexample (show (count, coarse)) (count <= 1 || not (any (`isNearest` abs x) coarse))
  where
    inTheMiddle q = 2 * q `elem` [toRational (abs x) + toRational (neighbour n (abs x)) | n <- [-1, 1]]
    count = digitCount (showReal x)
    coarse = decimalsAround (count - 1) (abs x)

-- | No decimal of as many digits is nearer to the number.
isWrittenNearest :: Admitted -> Property
isWrittenNearest (Admitted x) = x /= 0 ==> counterexample (show others) (all (\q -> away written <= away q) others)
  where
    others = decimalsAround (digitCount (showReal x)) (abs x)
    written = fromMaybe 0 (exactly (Text.dropWhile (== '-') (showReal x)))
    away q = abs (q - toRational (abs x))

-- | The decimals of so many digits just below a number and just above it, or in its place and just above.
decimalsAround :: Int -> Double -> [Rational]
decimalsAround _ 0 = []
decimalsAround count x = [fromInteger n * 10 ^^ power | let below = floor (r / 10 ^^ power) :: Integer, n <- [below, below + 1]]
  where
    r = toRational x
    power = head [k | k <- [-400 ..], 10 ^^ (k + count) > r]

-- | How many digits a written number has, zeros at its ends left out.
digitCount :: Text -> Int
digitCount = Text.length . significant
  where
    significant t = Text.dropWhileEnd (== '0') (Text.dropWhile (== '0') (Text.filter (`elem` ['0' .. '9']) (Text.takeWhile (/= 'e') t)))

-- | A real number is written with a point; without an exponent from 0.001 up to ten million, and with one outside.
isWrittenPlainly :: Admitted -> Property
isWrittenPlainly (Admitted x) =
  counterexample (show (showReal x)) $
    Text.any (== '.') (showReal x) && Text.any (== 'e') (showReal x) == (x /= 0 && (abs x < 1e-3 || abs x >= 1e7))

-------------------------------------------------------------------------------
-- Numbers

-- | A double that a scene may hold: of a magnitude of at most 1e100.
newtype Admitted = Admitted Double
  deriving (Eq, Show)

instance Arbitrary Admitted where
  arbitrary = Admitted <$> admitted
  shrink (Admitted x) = [Admitted y | y <- takeWhile (/= x) [0, 1, fromInteger (truncate x)], abs y <= 1e100]

-- | Of any size: ordinary, small integers, short decimals, subnormal, beside a middle of few digits, and the ends of
-- the range; of either sign.
admitted :: Gen Double
admitted = (*) <$> elements [1, -1] <*> oneof [ordinary, integral, short, anySize, middling, special]
  where
    ordinary = choose (0, 10)
    integral = fromIntegral <$> chooseInt (0, 1000)
    short = (\n k -> fromIntegral n / 10 ^^ k) <$> chooseInt (0, 99999) <*> chooseInt (0, 12)
    anySize = castWord64ToDouble <$> choose (0, castDoubleToWord64 1e100)
    -- The even one beside a middle of few digits, M 2^k with M = 5^j t odd and of 54 bits.
    middling = do
      j <- chooseInt (1, 23)
      t <- choose (2 ^ (53 :: Int) `div` 5 ^ j, 2 ^ (54 :: Int) `div` 5 ^ j) :: Gen Integer
      k <- chooseInt (0, 3 * j)
      pure (fromRational (fromInteger ((2 * (t `div` 2) + 1) * 10 ^ j * 2 ^ k)))
    special = do
      x <- elements [1e100, 1e7, 1e-3, 2 ^^ (-1022 :: Int), 2 ^ (53 :: Int), 1e22, 1e23, 0.1, 1e-10]
      k <- chooseInt (-2, if x == 1e100 then 0 else 2)
      elements [0, castWord64ToDouble 1, neighbour k x]

-- | A text that is a number, or nearly one.
newtype NumberText = NumberText {numberText :: Text}
  deriving (Eq, Show)

instance Arbitrary NumberText where
  arbitrary =
    NumberText . Text.pack
      <$> frequency
        [ (4, anyShape),
          (4, (<>) <$> sign <*> halfWay),
          (2, (<>) <$> sign <*> notation),
          (1, (<>) <$> sign <*> long),
          (1, (<>) <$> sign <*> atTheEnd),
          (4, anyShape >>= spoilt),
          (1, notation >>= spoilt)
        ]
  shrink (NumberText t) = [NumberText (a <> Text.drop n b) | n <- [500, 100, 10, 1], i <- [0, n .. Text.length t - 1], let (a, b) = Text.splitAt i t]

sign :: Gen String
sign = elements ["", "", "+", "-"]

digits :: (Int, Int) -> Gen String
digits range = chooseInt range >>= (`vectorOf` (intToDigit <$> chooseInt (0, 9)))

-- | Every shape that the rule allows.
anyShape :: Gen String
anyShape = do
  s <- sign
  mantissa <-
    oneof
      [ digits (1, 20),
        (<> ".") <$> digits (1, 20),
        ("." <>) <$> digits (1, 20),
        (\a b -> a <> "." <> b) <$> digits (1, 20) <*> digits (1, 20)
      ]
  e <- oneof [pure "", (\c t n -> c : t <> show n) <$> elements "eE" <*> sign <*> oneof [chooseInt (0, 20), chooseInt (0, 450)]]
  pure (s <> mantissa <> e)

-- | The middle between two neighbouring doubles, written with all its digits; or a little beside it.
halfWay :: Gen String
halfWay = do
  x <- oneof [choose (0, castDoubleToWord64 1e100 - 1), choose (0, 4), (castDoubleToWord64 (2 ^^ (-1022 :: Int)) +) <$> choose (0, 2)]
  let middle = (toRational (castWord64ToDouble x) + toRational (castWord64ToDouble (x + 1))) / 2
      (n, e) = decimalOf middle
  zeros <- elements [0, 1, 20, 900]
  aside <- elements ["", "1", "0"]
  elements
    [ show n <> "e" <> show e,
      show n <> "." <> replicate zeros '0' <> aside <> "e" <> show e,
      show (n - 1) <> ".9" <> replicate zeros '9' <> aside <> "e" <> show e,
      "0." <> replicate zeros '0' <> show n <> "e" <> show (e + zeros + length (show n))
    ]

-- | A double in the notations of this language.
notation :: Gen String
notation = do
  x <- abs <$> admitted
  let (ds, e) = floatToDigits 10 x
  elements [show x, showEFloat Nothing x "", showFFloat Nothing x "", concatMap show ds <> "e" <> show (e - length ds)]

-- | A thousand digits and more.
long :: Gen String
long = do
  ds <- digits (1000, 1500)
  point <- chooseInt (0, 100)
  elements [take point ds <> "." <> drop point ds, "0." <> ds, ds <> "e-" <> show (length ds), "." <> replicate 300 '0' <> ds]

-- | Close to the largest number, or to the smallest.
atTheEnd :: Gen String
atTheEnd = do
  ds <- digits (0, 30)
  elements
    [ "1e100",
      "1." <> ds <> "e100",
      "0.9999999999999999" <> ds <> "e100",
      "1" <> replicate 100 '0',
      "1" <> replicate 100 '0' <> "." <> ds,
      "10000000000000000159028911097599180468360808563945281389781327557747838772170381060813469985856815104",
      "10000000000000000159028911097599180468360808563945281389781327557747838772170381060813469985856815105",
      "2.4703282292062327" <> ds <> "e-324",
      "4.9406564584124654" <> ds <> "e-324",
      "1e-400",
      "1e400",
      "1e" <> replicate 30 '9',
      "1e-" <> replicate 30 '9',
      "0e" <> replicate 30 '9'
    ]

-- | One character more, less, or another.
spoilt :: String -> Gen String
spoilt text = do
  (a, b) <- (`splitAt` text) <$> chooseInt (0, length text)
  c <- elements "eE.+-xXdDfF_ ,aNI\1633\65297"
  elements [a <> [c] <> b, a <> drop 1 b, a <> [c] <> drop 1 b]

-- | What was drawn, so that nothing is missed.
kindsOfNumbers :: Text -> [(String, Bool)]
kindsOfNumbers t =
  [ ("a number", number),
    ("no number", not number),
    ("more than 700 digits", number && Text.length t > 700),
    ("too large", maybe False (> 10 ^ (101 :: Int)) size),
    ("subnormal", maybe False (\r -> r /= 0 && r < 2 ^^ (-1022 :: Int)) size),
    ("half way between two doubles", maybe False halfway size)
  ]
  where
    number = isJust size
    size = abs <$> exactly t
    halfway r = r > 0 && r < 10 ^ (101 :: Int) && (r == middle (fromRational r) 1 || r == middle (fromRational r) (-1))
    middle x n = (toRational x + toRational (neighbour n x)) / 2

-- | A text that is an integer, or nearly one.
newtype IntegerText = IntegerText Text
  deriving (Eq, Show)

instance Arbitrary IntegerText where
  arbitrary =
    IntegerText . Text.pack
      <$> frequency
        [ (3, (<>) <$> sign <*> digits (1, 12)),
          (2, (\s n z -> s <> replicate z '0' <> show (n :: Integer)) <$> sign <*> choose (2147483640, 2147483655) <*> chooseInt (0, 30)),
          (1, (<>) <$> sign <*> digits (1, 3) >>= spoilt),
          (1, anyShape)
        ]
