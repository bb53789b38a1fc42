{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Phrase
-- Description : Small pieces of sentences
--
-- What the program's sentences are put together from, in any stage: words of a file, numbers, and numbers of things.
-- Real numbers are as short as they read back, and look like those of the scene language; what stands in a file is
-- shown so that it cannot command a terminal.
module Dioptre.Source.Phrase
  ( -- * Pieces of a file
    quoted,
    safe,

    -- * Whole numbers
    number,
    counted,

    -- * Real numbers
    showReal,
    brief,
    vectorText,
  )
where

import Data.Char (intToDigit, isControl)
import Data.Foldable (toList)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Digits (shortestDigits)
import Dioptre.Source.Language (Language, inLanguage)
import Numeric (showFFloat)

-- | A piece of a file, in quotation marks; long ones are cut.
quoted :: Text -> Text
quoted t
  | Text.length t > 60 = "'" <> Text.take 57 t <> "...'"
  | otherwise = "'" <> t <> "'"

-- | Text of a file, safe to show: control characters, which could command a terminal, become dots.
--
-- >>> safe "a\ESC[2Jb"
-- "a\183[2Jb"
safe :: Text -> Text
safe = Text.map (\c -> if isControl c then '·' else c)

-- | A whole number.
number :: Integral n => n -> Text
number = Text.pack . show . toInteger

-- | A number of things: singular and plural, in English and in French, where 0 is singular.
--
-- >>> [counted l n ("ray", "rays") ("rayon", "rayons") | l <- [minBound ..], n <- [0, 1, 2]]
-- ["0 rays","1 ray","2 rays","0 rayon","1 rayon","2 rayons"]
counted :: Language -> Int -> (Text, Text) -> (Text, Text) -> Text
counted l n (one, many) (un, plusieurs) =
  number n <> " " <> inLanguage l (if n == 1 then one else many) (if n < 2 then un else plusieurs)

-- | The shortest decimal that reads back as the same number, in plain digits between 0.001 and ten million and with an
-- exponent outside; always with a point, so that it is seen to be real.
--
-- Laws: "Dioptre.Syntax.Value" reads @showReal x@ as x, for every x of magnitude at most 1e100; no decimal of fewer
-- digits does that.
--
-- >>> map showReal [0.1, 60, 1e-10, -2.5e7, 1e23]
-- ["0.1","60.0","1.0e-10","-2.5e7","1.0e23"]
showReal :: Double -> Text
showReal x
  | x == 0 || (size >= 1e-3 && size < 1e7) = Text.pack (showFFloat Nothing x "")
  | isNaN x || isInfinite x = Text.pack (show x)
  | otherwise = Text.pack ((if x < 0 then "-" else "") <> first <> "." <> (if null others then "0" else others) <> "e" <> show (e - 1))
  where
    size = abs x
    (ds, e) = shortestDigits size
    (first, others) = splitAt 1 (map intToDigit ds)

-- | The same as people write it, a whole number without a point.
--
-- >>> map brief [380, 0.5]
-- ["380","0.5"]
brief :: Double -> Text
brief x = fromMaybe (showReal x) (Text.stripSuffix ".0" (showReal x))

-- | A vector, as scenes have it.
--
-- >>> vectorText [0, 0.5, 1]
-- "[0.0, 0.5, 1.0]"
vectorText :: Foldable f => f Double -> Text
vectorText xs = "[" <> Text.intercalate ", " (map showReal (toList xs)) <> "]"
