{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Print
-- Description : Writing in the scene language
--
-- The way back from things to text: an outline of objects, properties and comments, laid out as a person would write it.
-- Law: parsing what was printed gives the outline's words and values again.
module Dioptre.Syntax.Print
  ( Outline (..),
    printOutline,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Syntax.Keyword (Keyword (End), spelling)

-- | What to write.
data Outline
  = -- | A block comment of its own, on one line.
    Remark Text
  | -- | A property and its value, which holds no line end and does not begin with a blank.
    Line Keyword Text
  | -- | An object and what stands in it.
    Group Keyword [Outline]
  deriving stock (Eq, Show)

-- | The text, ending in a line feed.
printOutline :: [Outline] -> Text
printOutline = Text.unlines . concatMap (outline 0)

outline :: Int -> Outline -> [Text]
outline depth item = case item of
  Remark words' -> ["/*", "   " <> words', "*/", ""]
  Line word value -> [indent <> Text.justifyLeft (30 - 2 * depth) ' ' (spelling word <> " ") <> value]
  Group word inner ->
    [indent <> spelling word]
      <> concatMap (outline (depth + 1)) inner
      <> [indent <> spelling End <> " #end " <> spelling word | depth > 0]
      <> concat [[spelling End <> " #end " <> spelling word, ""] | depth == 0]
  where
    -- Beyond twenty levels nobody counts, and deep nesting stays linear.
    indent = Text.replicate (min 20 depth) "  "
