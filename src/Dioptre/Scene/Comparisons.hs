{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Comparisons
-- Description : Lists of pictures to compare
--
-- What the comparator reads: pairs of files, each a picture or a scene, in the scene language's own layout.
--
-- > texture_comparator
-- >   file before.png
-- >   file after.png
-- > end
--
-- Specification: rule @compare.list@.
module Dioptre.Scene.Comparisons
  ( checkComparisons,
    writeComparisons,
  )
where

import Control.Monad (foldM)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Text (Text)
import Dioptre.Scene.Form (text)
import Dioptre.Scene.Reporting (item, passOver, runCheck)
import Dioptre.Scene.Schema (Schema (..), Slot (..), readObject, several, writeObject)
import Dioptre.Source.Diagnostic (Diagnostic)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print (printOutline)
import Dioptre.Syntax.Tree (Block (..), Head (..), Tree)

-- | Pairs of files to compare: blocks @texture_comparator@ of two lines @file@ each.
--
-- Spec: compare.list.
checkComparisons :: Tree -> ([(Text, Text)], [Diagnostic])
checkComparisons tree = runCheck (reverse <$> foldM (item words' pair) [] tree)
  where
    pair pairs block
      | headKeyword (blockHead block) == Just Keyword.TextureComparator = maybe pairs (: pairs) <$> readObject comparison block
      | otherwise = pairs <$ passOver Nothing words' block
    words' = [Keyword.TextureComparator]

-- | The list as a file.
--
-- Spec: compare.list.
writeComparisons :: [(Text, Text)] -> Text
writeComparisons = printOutline . map (writeObject comparison)

comparison :: Schema (Text, Text) (Text, Text)
comparison =
  Schema
    Keyword.TextureComparator
    ("none", "none")
    [several (Keyword.File :| []) text (Slot fst (\a (_, b) -> Right (a, b)) :| [Slot snd (\b (a, _) -> Right (a, b))])]
    Nothing
    Right
    id
