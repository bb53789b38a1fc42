{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Print
-- Description : Writing in the scene language
--
-- The way back from things to text: an outline of objects, properties and comments, laid out as a person would write
-- it. Law: parsing what was printed gives the outline's words and values again.
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

-- | The text, ending in a line feed. Linear in its length.
--
-- Spec: canonical.layout.
printOutline :: [Outline] -> Text
printOutline items = Text.unlines (foldr (outline 0) [] items)

-- | The lines of one item, before those that follow.
outline :: Int -> Outline -> [Text] -> [Text]
outline depth item following = case item of
  Remark words' -> "/*" : ("   " <> words') : "*/" : "" : following
  Line word value -> (indent <> Text.justifyLeft (max 0 (30 - 2 * depth)) ' ' (spelling word <> " ") <> value) : following
  Group word inner ->
    (indent <> spelling word) :
    foldr (outline (depth + 1)) ((indent <> spelling End <> " #end " <> spelling word) : ["" | depth == 0] <> following) inner
  where
    -- Beyond ten levels nobody counts, and deep nesting stays linear.
    indent = Text.replicate (min 10 depth) "  "
