{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Model.Obj.Faults
-- Description : What is wrong with an OBJ file, while it is read
--
-- Faults are found line by line, and told when the file has been read: 'keptInFull' of them each with its place, the
-- others as a number. Faults that a file has in each of its faces are told of at once, as a 'Tally'. The lines that all
-- these places point to are kept for messages. See Note [Places that stay].
module Dioptre.Model.Obj.Faults
  ( Faults,
    newFaults,
    report,
    told,
    shownLines,

    -- * Told of at once
    Tally,
    newTally,
    tally,
    tallied,
    toldOnce,

    -- * Places
    noted,
    located,
    keepLine,
    excerptOf,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Bits ((.&.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Either (isRight)
import Data.List (sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (maybeToList)
import Data.STRef (STRef, modifySTRef', newSTRef, readSTRef, writeSTRef)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Model.Growing (Counter, current, newCounter, put)
import Dioptre.Model.Obj.Lines (Line (..))
import Dioptre.Model.Words (backslash)
import Dioptre.Source.Diagnostic (Diagnostic (..), Problem (MoreFaults), keptInFull)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (characters)

-- | What has been found so far.
data Faults s = Faults
  { -- | How many faults there are, those included that are not told.
    faultsCount :: !(Counter s),
    -- | Those that are told, the last one first.
    faultsTold :: !(STRef s [Diagnostic]),
    -- | The place of the first fault that is not told.
    faultsFirstMore :: !(STRef s (Maybe Span)),
    -- | The lines that places point to, by their numbers.
    faultsLines :: !(STRef s (Map Int Text))
  }

-- | Nothing has been found.
newFaults :: ST s (Faults s)
newFaults = Faults <$> newCounter 0 <*> newSTRef [] <*> newSTRef Nothing <*> newSTRef Map.empty

-- | Tells of a fault between two places of a line.
--
-- Spec: models.obj.faults.
report :: Faults s -> Line -> Int -> Int -> Problem -> ST s ()
report faults line from to problem = do
  earlier <- current (faultsCount faults)
  put (faultsCount faults) (earlier + 1)
  when (earlier < keptInFull) $ do
    here <- noted faults line from to
    -- What it quotes of the line is copied now, so that the line need not stay for it.
    foldr seq (modifySTRef' (faultsTold faults) (Diagnostic here problem :)) (show problem)
  when (earlier == keptInFull) $ noted faults line from to >>= writeSTRef (faultsFirstMore faults) . Just
{-# NOINLINE report #-}

-- | All that is to be told, with what is told at once, in the order of the file.
told :: Faults s -> [Diagnostic] -> ST s [Diagnostic]
told faults atOnce = do
  count <- current (faultsCount faults)
  single <- readSTRef (faultsTold faults)
  firstMore <- readSTRef (faultsFirstMore faults)
  pure (sortOn diagnosticSpan (reverse single <> atOnce <> [Diagnostic here (MoreFaults (count - keptInFull)) | here <- maybeToList firstMore]))

-- | The lines that places point to, by their numbers. Of long ones, the beginning.
--
-- Spec: models.obj.faults, limits.files.
shownLines :: Faults s -> ST s [(Int, Text)]
shownLines faults = Map.toAscList <$> readSTRef (faultsLines faults)

-------------------------------------------------------------------------------
-- Told of at once

-- | How often something is the case, and where it is first.
data Tally s = Tally !(Counter s) !(STRef s (Maybe Span))

-- | It has not been the case.
newTally :: ST s (Tally s)
newTally = Tally <$> newCounter 0 <*> newSTRef Nothing

-- | It is the case between two places of a line.
tally :: Faults s -> Tally s -> Line -> Int -> Int -> ST s ()
tally faults (Tally count first) line from to = do
  earlier <- current count
  put count (earlier + 1)
  when (earlier == 0) $ noted faults line from to >>= writeSTRef first . Just

-- | How often it is the case.
tallied :: Tally s -> ST s Int
tallied (Tally count _) = current count

-- | What there is to say of it, once and where it is first: this, of their number. Nothing if it is never the case.
toldOnce :: (Int -> Problem) -> Tally s -> ST s [Diagnostic]
toldOnce problem (Tally count first) = do
  number <- current count
  place <- readSTRef first
  pure [Diagnostic here (problem number) | here <- maybeToList place]

-------------------------------------------------------------------------------
-- Places

-- | What lies between two places of a line, as a place in the file; its line will be there for messages.
noted :: Faults s -> Line -> Int -> Int -> ST s Span
noted faults line from to = here <$ keepLine faults here text
  where
    (!here, !text) = located line from to

-- | The same, with the line as it is shown, which may be kept later. See Note [Places that stay].
located :: Line -> Int -> Int -> (Span, Text)
located (Line bytes number breaks) from to = (Span (number + length before) (column from) (max (column from) (column (min to stop))), Text.copy (Text.take longestExcerpt (characters shown)))
  where
    (before, after) = span (<= from) breaks
    start = foldl (\_ b -> b) 0 before
    stop = foldr const (Bytes.length bytes) after
    part = Bytes.take (stop - start) (Bytes.drop start bytes)
    shown = if null after then part else Bytes.snoc (Bytes.take (stop - start - 1) part) backslash
    isUtf8 = isRight (Text.decodeUtf8' part)
    column i
      | isUtf8 = 1 + Bytes.foldl' (\k b -> if b .&. 0xc0 == 0x80 then k else k + 1) 0 (Bytes.take (i - start) part)
      | otherwise = 1 + max 0 (i - start)

-- | Keeps the line of a place, as it is shown.
keepLine :: Faults s -> Span -> Text -> ST s ()
keepLine faults here text = modifySTRef' (faultsLines faults) (Map.insert (spanLine here) text)

-- | Lines longer than this are cut before they are shown.
longestExcerpt :: Int
longestExcerpt = 4096

-- | What lies between two places of a line, for a message; of long ones the beginning.
excerptOf :: ByteString -> Int -> Int -> Text
excerptOf bytes from to = characters (Bytes.take (min 200 (to - from)) (Bytes.drop from bytes))

-- Note [Places that stay]
-- ~~~~~~~~~~~~~~~~~~~~~~~
-- A message shows the line that it is about, but the file is not kept: it may have a hundred megabytes, and a piece of
-- it that anything refers to stays in memory whole. So a fault copies its line when it is found, and a name its name.
-- There are at most 'keptInFull' faults, one more place for the rest of them, and one for each tally.
--
-- A place in a line is a number of bytes. It becomes a line and a column only here: the line that goes on in others is
-- one line for the reader, and for people several. Columns count characters, which are UTF-8 if the bytes of the line
-- can be, or else Latin-1.
