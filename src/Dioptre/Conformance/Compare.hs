{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Compare
-- Description : Whether a result is the expected one
--
-- > exact      numbers are equal as binary64 (-0 equals 0), all else is the same
-- > ulp:N      each number is at most N binary64 steps from the expected one
-- > abs:X      each number x is near the expected e: |x - e| <= X
-- > rel:X      each number x is near the expected e: |x - e| <= X |e|
-- > set        arrays have the same elements, in any order
-- > levels:N   base 64 of as many bytes, each at most N from the expected one
--
-- An object instead of one of these words gives a rule for each member by its name, exact where it gives none. Objects
-- have the same members. Differences of numbers are computed in binary64.
module Dioptre.Conformance.Compare
  ( Comparison (..),
    comparison,
    comparisonNamed,
    describeComparison,
    firstDifference,
  )
where

import Data.Aeson (Value (..))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Base64 as Base64
import Data.Either (rights)
import Data.Foldable (toList)
import Data.List (sort, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isNothing, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Conformance.Protocol (binary64)
import Dioptre.Math.Ordinal (toOrdinal)
import Dioptre.Syntax.Value (integer, real)

-- $setup
-- >>> :set -XOverloadedStrings
-- >>> import Data.Aeson (toJSON)

-- | How much a result may differ from the expected one.
data Comparison
  = Exact
  | Ulp Int
  | Absolute Double
  | Relative Double
  | Unordered
  | Levels Int
  | -- | By the names of members.
    ByMember (Map Text Comparison)
  deriving stock (Eq, Show)

-- | The comparison that a vector file asks for, or what is wrong with it.
comparison :: Value -> Either Text Comparison
comparison value = case value of
  String name -> comparisonNamed name
  Object o -> ByMember <$> traverse comparison (Map.fromList [(Key.toText name, inner) | (name, inner) <- Keys.toList o])
  _ -> Left "a comparison is a word or an object"

-- | The comparison of that name.
--
-- >>> comparisonNamed "ulp:4"
-- Right (Ulp 4)
--
-- Spec: compare.kinds.
comparisonNamed :: Text -> Either Text Comparison
comparisonNamed name = case Text.breakOn ":" name of
  ("exact", "") -> Right Exact
  ("set", "") -> Right Unordered
  ("ulp", n) | Right k <- integer (Text.drop 1 n), k >= 0 -> Right (Ulp k)
  ("levels", n) | Right k <- integer (Text.drop 1 n), k >= 0 -> Right (Levels k)
  ("abs", x) | Right r <- real (Text.drop 1 x), r >= 0 -> Right (Absolute r)
  ("rel", x) | Right r <- real (Text.drop 1 x), r >= 0 -> Right (Relative r)
  _ -> Left ("no comparison is called '" <> name <> "'")

-- | The name of a comparison, for a person to read.
describeComparison :: Comparison -> Text
describeComparison how = case how of
  Exact -> "exact"
  Unordered -> "set"
  Ulp n -> "ulp:" <> shown n
  Levels n -> "levels:" <> shown n
  Absolute x -> "abs:" <> shown x
  Relative x -> "rel:" <> shown x
  ByMember rules -> Text.intercalate ", " [name <> " " <> describeComparison rule | (name, rule) <- Map.toList rules]
  where
    shown :: Show a => a -> Text
    shown = Text.pack . show

-- | The place at which a result first differs from the expected value, which comes first: @$@ for the whole, then names
-- of members and numbers of elements, from 0. 'Nothing' where the result passes.
--
-- >>> firstDifference Exact (toJSON [1, 2 :: Int]) (toJSON [1, 3 :: Int])
-- Just "$[1]"
--
-- Spec: conformance.means, compare.kinds, numbers.negative-zero, numbers.ulp.
firstDifference :: Comparison -> Value -> Value -> Maybe Text
firstDifference = differs "$"

differs :: Text -> Comparison -> Value -> Value -> Maybe Text
differs place how expected got = case (expected, got) of
  (Number _, Number _) | Just e <- binary64 expected, Just x <- binary64 got -> orHere (near how e x)
  (String e, String x) | Levels n <- how -> orHere (sameBytes n e x)
  (Array es, Array xs)
    | length es /= length xs -> Just place
    | Unordered <- how -> orHere (sameElements (toList es) (toList xs))
    | otherwise -> listToMaybe (mapMaybe element (zip3 [0 :: Int ..] (toList es) (toList xs)))
  (Object e, Object x) -> listToMaybe (mapMaybe (member x) (sortOn fst (Keys.toList e)) <> [place <> "." <> Key.toText name | name <- sort (Keys.keys x), not (Keys.member name e)])
  _ -> orHere (expected == got)
  where
    orHere same = if same then Nothing else Just place
    element (i, e, x) = differs (place <> "[" <> Text.pack (show i) <> "]") how e x
    member x (name, e) = case Keys.lookup name x of
      Nothing -> Just (place <> "." <> Key.toText name)
      Just inner -> differs (place <> "." <> Key.toText name) (ofMember (Key.toText name)) e inner
    ofMember name = case how of
      ByMember rules -> Map.findWithDefault Exact name rules
      _ -> how
    sameElements [] [] = True
    sameElements (e : es) xs = case break (isNothing . differs place how e) xs of
      (before, _ : after) -> sameElements es (before <> after)
      _ -> False
    sameElements [] _ = False

-- | Whether a number may stand for the expected one, which comes first.
near :: Comparison -> Double -> Double -> Bool
near how e x = case how of
  Ulp n -> abs (toInteger (toOrdinal e) - toInteger (toOrdinal x)) <= toInteger n
  Absolute tolerance -> abs (x - e) <= tolerance
  Relative tolerance -> abs (x - e) <= tolerance * abs e
  _ -> e == x

sameBytes :: Int -> Text -> Text -> Bool
sameBytes n e x = case rights (map (Base64.decode . Text.encodeUtf8) [e, x]) of
  [a, b] -> Bytes.length a == Bytes.length b && and (Bytes.zipWith close a b)
  _ -> False
  where
    close p q = abs (fromIntegral p - fromIntegral q :: Int) <= n
