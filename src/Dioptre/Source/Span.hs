{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Source.Span
-- Description : Places in a text
--
-- Where something stands in a file, as a person would count it. The scene language puts one statement on a line, so
-- a place never reaches over the end of its line:
--
-- > line 3:  position   0.0  1.O  0.0
-- >                          ^^^        Span 3 17 20
module Dioptre.Source.Span
  ( Span (..),
    width,
    wholeFile,
  )
where

-- | A stretch of one line. Lines and columns count from 1, columns in code points (a tab is one); the end is exclusive.
-- Law: 1 <= column <= end.
--
-- Spec: text.place, check.place.
data Span = Span
  { spanLine :: !Int,
    spanColumn :: !Int,
    spanEndColumn :: !Int
  }
  deriving stock (Eq, Ord, Show)

-- | How many code points the span covers.
--
-- >>> width (Span 3 17 20)
-- 3
--
-- Spec: text.place.
width :: Span -> Int
width s = spanEndColumn s - spanColumn s

-- | The place of what is said of a file as a whole: its very beginning.
wholeFile :: Span
wholeFile = Span 1 1 1
