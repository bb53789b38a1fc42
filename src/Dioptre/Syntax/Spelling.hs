{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Spelling
-- Description : Words that were mistyped
--
-- What a person who wrote an unknown word may have meant. The measure is the restricted Damerau-Levenshtein distance:
-- the number of letters put in, left out, replaced, or swapped with their neighbour.
module Dioptre.Syntax.Spelling
  ( isSlipOf,
    suggest,
    suggestWord,
    suggestName,
  )
where

import Control.Applicative ((<|>))
import Data.Char (GeneralCategory (Format), generalCategory, isAlphaNum, isSpace)
import Data.List (find, sort, sortOn)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Words (goesOnWithRemark)
import Text.EditDistance (defaultEditCosts, restrictedDamerauLevenshteinDistance)

-- | Whether two words differ by one slip of the finger: exactly one letter put in, left out, replaced or swapped.
--
-- >>> "edn" `isSlipOf` "end"
-- True
-- >>> "mend" `isSlipOf` "send"
-- True
-- >>> "ned" `isSlipOf` "den"
-- False
--
-- Spec: tree.slip.
isSlipOf :: Text -> Text -> Bool
isSlipOf a b = abs (Text.length a - Text.length b) <= 1 && apart a b == 1

-- | The candidate nearest to a word, if one is near: at most one slip in three letters, and not as many as it has
-- letters. Of several the one that begins most like it, and the first of those. Case does not matter. Words of more
-- than 60 letters are nobody's slip, and of many candidates only the first 300 are looked at.
--
-- >>> suggest ["sphere", "plane"] "Sphre"
-- Just "sphere"
-- >>> suggest ["blue", "bleu"] "bleue"
-- Just "bleu"
-- >>> suggest ["sphere", "plane"] "cube"
-- Nothing
-- >>> suggest ["n", "p"] "}"
-- Nothing
--
-- Spec: check.texts.
suggest :: [Text] -> Text -> Maybe Text
suggest candidates word
  | Text.length word > 60 = Nothing
  | otherwise = listToMaybe [c | ((d, _), c) <- sortOn fst near, d <= slips]
  where
    -- No letter is left of a word in which every one is a slip.
    slips = min (Text.length word - 1) (max 1 (Text.length word `div` 3))
    -- Words whose lengths differ by more are farther apart.
    alike c = Text.compareLength c (Text.length word + slips) /= GT && Text.compareLength c (Text.length word - slips) /= LT
    near = [((apart (Text.toLower word) (Text.toLower c), negate (common c)), c) | c <- filter alike (take 300 candidates)]
    common c = maybe 0 (\(same, _, _) -> Text.length same) (Text.commonPrefixes (Text.toLower word) (Text.toLower c))

-- | What may have been meant by a word that is none of these, and what follows it on its line: one of them with an
-- accent, with its parts in another order, with a blank between its parts, or with something else than a blank behind
-- it; or else 'suggest'.
--
-- >>> suggestWord ["point_light", "lumiere_ponctuelle"] "lumi\232re" "ponctuelle"
-- Just "lumiere_ponctuelle"
-- >>> suggestWord ["angle"] "angle=60" ""
-- Just "angle 60"
suggestWord :: [Text] -> Text -> Text -> Maybe Text
suggestWord candidates word following
  | Text.length word > 60 = Nothing
  | otherwise = exactly plain <|> joined <|> turned <|> translated <|> cut <|> suggest candidates word <|> suggest candidates plain
  where
    plain = unaccented (Text.toLower word)
    exactly w = find (== w) candidates
    joined = case Text.words (Text.take 60 following) of
      next : _ -> exactly (plain <> "_" <> unaccented (Text.toLower next))
      [] -> Nothing
    parts = sort . Text.splitOn "_"
    turned = find ((== parts plain) . parts) candidates
    translated = lookup plain translations >>= exactly
    cut = case Text.span (\c -> isAlphaNum c || c == '_') word of
      (before, rest)
        | Just w <- exactly (unaccented (Text.toLower before)), not (Text.null rest) -> Just (Text.stripEnd (w <> " " <> Text.dropWhile between rest))
      _ -> Nothing
    between c = c `elem` ("=:;,{}" :: String) || isSpace c || generalCategory c == Format

-- | Words that have no French spelling, as one might translate them.
translations :: [(Text, Text)]
translations =
  [ ("rayon_majeur", "major_radius"),
    ("rayon_mineur", "minor_radius"),
    ("regarde", "look_at"),
    ("lumiere", "lumiere_ponctuelle")
  ]

-- | A word in lower case without the accents of French.
unaccented :: Text -> Text
unaccented = Text.map (\c -> fromMaybe c (lookup c accents))
  where
    accents = zip "\224\226\228\231\232\233\234\235\238\239\244\246\249\251\252" "aaaceeeeiioouuu"

-- | The name that may have been meant by a name: one that is the same but for case and blanks at the end; or one that
-- goes on, or stops, where a remark begins; or else 'suggest', with its bounds.
--
-- >>> suggestName ["th\233", "caf\233  "] "CAF\201"
-- Just "caf\233  "
-- >>> suggestName ["paint # the wall's"] "paint"
-- Just "paint # the wall's"
suggestName :: [Text] -> Text -> Maybe Text
suggestName candidates name
  | Text.compareLength name 60 == GT = remark
  | otherwise = find ((== bare name) . bare) (filter short (take 300 candidates)) <|> remark <|> suggest candidates name
  where
    remark = find (\c -> c `goesOnWithRemark` name || name `goesOnWithRemark` c) (take 300 candidates)
    bare = Text.toCaseFold . Text.stripEnd
    short c = Text.compareLength c 100 /= GT

apart :: Text -> Text -> Int
apart a b = restrictedDamerauLevenshteinDistance defaultEditCosts (Text.unpack a) (Text.unpack b)
