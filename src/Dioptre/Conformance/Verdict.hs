{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Verdict
-- Description : How a port did
--
-- A case is passed, failed, or not implemented; these are counted apart, and what is not implemented counts for neither
-- side.
module Dioptre.Conformance.Verdict
  ( -- * Cases
    Case (..),

    -- * Verdicts
    Verdict (..),
    Reason (..),
    Trouble (..),
    judge,
    abbreviated,

    -- * Counting
    Score (..),
    scoreOf,
    isFailure,
  )
where

import Data.Aeson (Value (..))
import qualified Data.Aeson.KeyMap as Keys
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Dioptre.Conformance.Compare (Comparison, firstDifference)
import Dioptre.Conformance.Protocol (Outcome (..))

-- | A question with its answer.
data Case = Case
  { -- | Unique in the suite, as @roots.quadratic/0001@.
    caseName :: Text,
    -- | The profile of the operation.
    caseProfile :: Text,
    -- | The operation's name.
    caseOperation :: Text,
    -- | The labels of the rules of the specification that it shows.
    caseRules :: [Text],
    -- | What it is about.
    caseComment :: Text,
    -- | The mistakes that it finds.
    caseFlags :: [Text],
    -- | What is sent.
    caseInput :: Value,
    -- | The result that is expected.
    caseExpected :: Value,
    -- | How much a result may differ from it.
    caseComparison :: Comparison
  }
  deriving stock (Eq, Show)

-- | What became of a case.
data Verdict
  = Passed
  | -- | In the words of the port.
    NotImplemented Text
  | Failed Reason
  deriving stock (Eq, Show)

-- | Why a case failed.
data Reason
  = -- | The result, and where it first differs.
    Different Value Text
  | -- | The port says that there is no result, and why.
    Refused Text
  | -- | There was no answer.
    Unanswered Trouble
  deriving stock (Eq, Show)

-- | What kept a port from answering.
data Trouble
  = -- | It ended, with that exit code (or the negative number of a signal), having said that on standard error.
    Ended Int Text
  | -- | It did not answer within so many seconds.
    Silent Double
  | -- | It answered lines that are no answers; the last of them.
    Babbled Text
  | -- | It answered more than so many bytes on one line.
    LongLine Int
  | -- | It was given up before it came to this case, for what it had done last.
    GivenUp (Maybe Trouble)
  deriving stock (Eq, Show)

-- | The verdict on an answer.
--
-- A result of @scene.check@ is compared in the members that are expected. What is kept of the answer is bounded,
-- however large it is.
--
-- Spec: compare.verdicts.
judge :: Case -> Outcome -> Verdict
judge c outcome = case outcome of
  Skip why -> NotImplemented (shortened why)
  Fault why -> Failed (Refused (shortened why))
  Ok got -> maybe Passed (Failed . Different (abbreviated got)) (firstDifference (caseComparison c) (caseExpected c) (ofInterest got))
  where
    ofInterest got = case (got, caseExpected c) of
      (Object o, Object e) | caseOperation c == "scene.check" -> Object (Keys.intersectionWith const o e)
      _ -> got

-- | A value of which a person can read the whole: long texts, long lists and deep nests are cut.
abbreviated :: Value -> Value
abbreviated = upTo (6 :: Int)
  where
    upTo depth value = case value of
      String t -> String (shortened t)
      Array items
        | depth == 0 -> String "..."
        | otherwise -> Array (fmap (upTo (depth - 1)) (Vector.force (Vector.take 50 items)) <> Vector.fromList [String "..." | Vector.length items > 50])
      Object o
        | depth == 0 -> String "..."
        | otherwise -> Object (Keys.fromList (take 50 [(name, upTo (depth - 1) inner) | (name, inner) <- Keys.toList o]))
      _ -> value

shortened :: Text -> Text
shortened t
  | Text.compareLength t 2000 == GT = Text.copy (Text.take 2000 t) <> "..."
  | otherwise = t

-- | How many cases of each kind.
data Score = Score
  { scorePassed :: !Int,
    scoreFailed :: !Int,
    scoreNotImplemented :: !Int
  }
  deriving stock (Eq, Show)

instance Semigroup Score where
  Score a b c <> Score a' b' c' = Score (a + a') (b + b') (c + c')

instance Monoid Score where
  mempty = Score 0 0 0

-- | One case's score.
--
-- Spec: compare.verdicts.
scoreOf :: Verdict -> Score
scoreOf verdict = case verdict of
  Passed -> Score 1 0 0
  Failed _ -> Score 0 1 0
  NotImplemented _ -> Score 0 0 1

-- | Whether a case failed.
isFailure :: Verdict -> Bool
isFailure verdict = case verdict of
  Failed _ -> True
  _ -> False
