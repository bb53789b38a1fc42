-- |
-- Module      : Dioptre.Syntax.Spelling
-- Description : Words that were mistyped
--
-- What a person who wrote an unknown word may have meant. The measure is the restricted Damerau-Levenshtein distance: the
-- number of letters put in, left out, replaced, or swapped with their neighbour.
module Dioptre.Syntax.Spelling
  ( isSlipOf,
    suggest,
  )
where

import Data.List (sortOn)
import Data.Maybe (listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Text.EditDistance (defaultEditCosts, restrictedDamerauLevenshteinDistance)

-- | Whether two words differ by one slip of the finger: exactly one letter put in, left out, replaced or swapped.
--
-- >>> "edn" `isSlipOf` "end"
-- True
-- >>> "mend" `isSlipOf` "send"
-- True
-- >>> "ned" `isSlipOf` "den"
-- False
isSlipOf :: Text -> Text -> Bool
isSlipOf a b = abs (Text.length a - Text.length b) <= 1 && apart a b == 1

-- | The candidate nearest to a word, if one is near: at most one slip in three letters. The first of several. Case does not matter.
-- Words of more than 60 letters are nobody's slip, and of many candidates only the first 300 are looked at.
--
-- >>> suggest ["sphere", "plane"] "Sphre"
-- Just "sphere"
-- >>> suggest ["sphere", "plane"] "cube"
-- Nothing
suggest :: [Text] -> Text -> Maybe Text
suggest candidates word
  | Text.length word > 60 = Nothing
  | otherwise = listToMaybe [c | (d, c) <- sortOn fst near, d <= slips]
  where
    slips = max 1 (Text.length word `div` 3)
    -- Words whose lengths differ by more are farther apart.
    alike c = Text.compareLength c (Text.length word + slips) /= GT && Text.compareLength c (Text.length word - slips) /= LT
    near = [(apart (Text.toLower word) (Text.toLower c), c) | c <- filter alike (take 300 candidates)]

apart :: Text -> Text -> Int
apart a b = restrictedDamerauLevenshteinDistance defaultEditCosts (Text.unpack a) (Text.unpack b)
