{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Reporting
-- Description : What there is to say while a file is read
--
-- Reading never fails: what cannot be used is told at its place, and passed over. This module collects what is told,
-- and knows what has no place where it stands; what an object wants is the affair of "Dioptre.Scene.Schema".
-- Specification: chapter 3.
module Dioptre.Scene.Reporting
  ( -- * Collecting
    Check,
    report,
    runCheck,

    -- * What has no place
    misfit,
    passOver,
    item,
  )
where

import Control.Monad.Trans.Writer.CPS (Writer, runWriter, tell)
import Data.Foldable (toList)
import Data.List (mapAccumL, sortOn)
import Data.Sequence (Seq)
import qualified Data.Sequence as Seq
import Data.Text (Text)
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Syntax.Keyword (Keyword, spelling, spellings)
import Dioptre.Syntax.Spelling (suggestWord)
import Dioptre.Syntax.Tree (Block (..), Closing (..), Head (..), Node (..), Value (..))
import qualified Dioptre.Syntax.Tree as Tree

-- | Checking collects diagnostics on its way.
type Check = Writer (Seq Diagnostic)

-- | Something to say about a place.
report :: Span -> Problem -> Check ()
report place problem = tell (Seq.singleton (Diagnostic place problem))

-- | What was found, and everything there was to say, in the order of the file.
--
-- Spec: check.order.
runCheck :: Check a -> (a, [Diagnostic])
runCheck check = snd . mapAccumL sparingly 0 . sortOn diagnosticSpan . toList <$> runWriter check

-- | Leaves the guesses out from the thousandth on: finding what was meant by a word takes longer than all the rest, and
-- in a file with so many unknown words it is not the spelling that is wrong.
sparingly :: Int -> Diagnostic -> (Int, Diagnostic)
sparingly n (Diagnostic place problem) = case problem of
  UnknownWord w words' _ passed -> (n + 1, Diagnostic place (if n < 1000 then problem else UnknownWord w words' Nothing passed))
  MissingMaterial name _ -> (n + 1, Diagnostic place (if n < 1000 then problem else MissingMaterial name Nothing))
  _ -> (n, Diagnostic place problem)

-- | Says that a block has no place in an object (none: at the level of the file), where those words may stand. It is
-- passed over, with all that is in it.
--
-- Spec: code.unknown-word, code.misplaced-word, check.passed-over.
passOver :: Maybe Text -> [Keyword] -> Block -> Check ()
passOver object words' block =
  report place (misfit object words' (blockHead block) "" passed)
  where
    place = headSpan (blockHead block)
    passed = if lastLine block == spanLine place then TheOpening else TheObject (lastLine block)

-- | The last line that belongs to a block.
--
-- Spec: check.passed-over.
lastLine :: Block -> Int
lastLine block = case blockClosing block of
  ByEnd place -> spanLine place
  ByMisspeltEnd word -> spanLine (headSpan word)
  BySceneWord word -> spanLine (headSpan word) - 1
  ByEndOfFile -> maximum (spanLine (headSpan (blockHead block)) : map nodeLine (blockNodes block))
  where
    nodeLine node = case node of
      Object inner -> lastLine inner
      Statement p -> spanLine (headSpan (Tree.propertyHead p))
      LooseEnd word -> spanLine (headSpan word)
      OpenComment place -> spanLine place

-- | What is wrong with a word that is none of those that may stand there, and has this behind it.
--
-- Spec: code.unknown-word, code.misplaced-word.
misfit :: Maybe Text -> [Keyword] -> Head -> Text -> PassedOver -> Problem
misfit object words' word following passed = case headKeyword word of
  Just _ -> MisplacedWord (headText word) object (map spelling words') passed
  Nothing -> UnknownWord (headText word) (map spelling words') guess passed
  where
    guess = suggestWord (concatMap (toList . spellings) words') (headText word) following

-- | One thing at the level of the file, where these words may stand.
--
-- Spec: code.stray-end, code.unclosed-comment, check.file-level.
item :: [Keyword] -> (a -> Block -> Check a) -> a -> Node -> Check a
item words' into draft = \case
  Object block -> into draft block
  Statement p -> draft <$ report (headSpan (Tree.propertyHead p)) (misfit Nothing words' (Tree.propertyHead p) (valueText (Tree.propertyValue p)) TheLine)
  LooseEnd word -> draft <$ report (headSpan word) (StrayEnd (headText word))
  OpenComment place -> draft <$ report place UnclosedComment
