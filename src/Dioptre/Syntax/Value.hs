{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Value
-- Description : The grammar of values
--
-- What may follow a property's word. A value is cut into tokens; brackets, commas and blanks only separate them, so
-- that
-- @[1, 2, 3]@, @(1,2,3)@, @\<1 2 3\>@ and @1 2 3@ are the same vector. A property of one token ignores the rest of its line, which is
-- where units stand (@60.0 degrees@).
--
-- > tokens    = *separator *(token 1*separator)
-- > separator = blank / "," / "(" / ")" / "[" / "]" / "<" / ">"
-- > real      = [sign] (1*digit ["." *digit] / "." 1*digit) [("e" / "E") [sign] 1*digit]
-- > integer   = [sign] 1*digit
-- > sign      = "+" / "-"
module Dioptre.Syntax.Value
  ( -- * Tokens
    Token (..),
    tokens,

    -- * Numbers
    real,
    integer,
    largestReal,
    largestInteger,

    -- * Writing numbers
    showReal,
  )
where

import Data.Char (digitToInt, isDigit)
import Data.Ratio ((%))
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Void (Void)
import Dioptre.Source.Diagnostic (Refusal (..))
import Dioptre.Source.Phrase (showReal)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Words (Token (..), isBlank)
import Dioptre.Syntax.Tree (Value (..))
import Text.Megaparsec (Parsec, eof, many, option, optional, runParser, satisfy, takeWhile1P, takeWhileP, (<|>))
import Text.Megaparsec.Char (char)

type Parser = Parsec Void Text

-- | tokens = *separator *(token 1*separator). Total, linear.
--
-- Spec: text.blank, value.tokens.
tokens :: Value -> [Token]
tokens (Value (Span line column _) text) =
  either (const []) (\(before, pieces) -> located (column + Text.length before) pieces) (runParser (tokensRule <* eof) "" text)
  where
    located _ [] = []
    located start ((token, after) : rest) =
      let end = start + Text.length token
       in Token (Span line start end) token : located (end + Text.length after) rest

-- | The separators before the first token, and every token with the separators after it.
tokensRule :: Parser (Text, [(Text, Text)])
tokensRule = (,) <$> separators <*> many ((,) <$> takeWhile1P Nothing (not . isSeparator) <*> separators)
  where
    separators = takeWhileP Nothing isSeparator

isSeparator :: Char -> Bool
isSeparator c = isBlank c || c `elem` (",()[]<>" :: String)

-- | No number of a scene is larger than this.
--
-- Spec: value.real.largest, limits.language.
largestReal :: Double
largestReal = 1e100

-- | Integers have 32 bits, as in the original: from -2147483648 to this.
--
-- Spec: numbers.integers, value.integer, limits.language.
largestInteger :: Integer
largestInteger = 2147483647

-- | The number that a token says, correctly rounded to binary64 (ties to even).
--
-- >>> real "+.5e1"
-- Right 5.0
-- >>> real "1e400"
-- Left (TooLarge "1e400")
-- >>> real "NaN"
-- Left (NotANumber "NaN")
--
-- Spec: numbers.reading, value.real, value.real.largest, code.not-a-number, code.number-too-large.
real :: Text -> Either Refusal Double
real token = case runParser (realRule <* eof) "" token of
  Left _ -> Left (NotANumber token)
  Right x
    | abs x > largestReal -> Left (TooLarge token)
    | otherwise -> Right x

-- | real = [sign] (1*digit ["." *digit] \/ "." 1*digit) [("e" \/ "E") [sign] 1*digit]
realRule :: Parser Double
realRule = do
  negative <- sign
  (whole, fraction) <- withWhole <|> withoutWhole
  e <- option 0 (satisfy (`elem` ("eE" :: String)) *> exponentRule)
  let magnitude = decimal whole fraction e
  pure (if negative then negate magnitude else magnitude)
  where
    withWhole = (,) <$> digits <*> option "" (char '.' *> takeWhileP Nothing isDigit)
    withoutWhole = (,) "" <$> (char '.' *> digits)
    exponentRule = do
      negative <- sign
      e <- natural . Text.take 8 . Text.dropWhile (== '0') <$> digits
      pure (if negative then negate e else e)

-- | integer = [sign] 1*digit
--
-- Spec: numbers.integers, value.integer, code.not-an-integer, code.number-too-large.
integer :: Text -> Either Refusal Int
integer token = case runParser ((,) <$> sign <*> digits <* eof) "" token of
  Left _ -> Left (NotAnInteger token)
  Right (negative, ds)
    | Text.length significant > 10 || value > largestInteger || value < negate largestInteger - 1 -> Left (TooLarge token)
    | otherwise -> Right (fromInteger value)
    where
      significant = Text.dropWhile (== '0') ds
      value = if negative then negate (natural significant) else natural significant

sign :: Parser Bool
sign = (== Just '-') <$> optional (char '+' <|> char '-')

digits :: Parser Text
digits = takeWhile1P Nothing isDigit

natural :: Text -> Integer
natural = Text.foldl' (\n d -> 10 * n + toInteger (digitToInt d)) 0

-- | The double nearest to @whole.fraction@ times ten to the @e@, as digits. See Note [Bounded digits].
decimal :: Text -> Text -> Integer -> Double
decimal whole fraction e
  | Text.null significant = 0
  | magnitude > 400 = 1 / 0
  | magnitude < -400 = 0
  | otherwise = fromRational (natural kept * 10 ^ max 0 power % 10 ^ max 0 (negate power))
  where
    significant = Text.dropWhile (== '0') (whole <> fraction)
    (first, rest) = Text.splitAt 800 significant
    kept = if Text.any (/= '0') rest then first <> "1" else first
    -- The value is 0.significant times ten to the magnitude, and kept times ten to the power.
    magnitude = toInteger (Text.length significant - Text.length fraction) + e
    power = magnitude - toInteger (Text.length kept)

-- Note [Bounded digits]
-- ~~~~~~~~~~~~~~~~~~~~~
-- A token may be a million digits long, and reading those exactly would take a million squared steps. A double's
-- decision boundary (half way between two neighbours) has at most 767 significant digits, so the first 800 digits, with
-- one digit 1 after them if anything that is not zero follows, lie on the same side of every boundary as the whole
-- number does. The rest is rational arithmetic on at most 801 digits, which rounds once. An exponent is cut to eight
-- digits, beyond which the number is zero or too large whatever its digits (a token has fewer than 10^8 of them).
