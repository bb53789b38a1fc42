{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.Render.Parallel
-- Description : Rows, computed by several workers and handed over in their order
--
-- Workers take the next row that nobody has, and compute it with the pure function; rows of uneven cost even out. What
-- is done goes onto a belt, from which it leaves in order:
--
-- >   handed over |  due                          next
-- >   0 1 2 3 4 5 |   6    7    8    9   10   11   12
-- >               |   .   lies lies  .   lies  .        .  somebody computes it
-- >               '---------------- ahead --------------'
--
-- Nobody begins a row that is too far ahead of the one that is due, so that a picture may have any number of rows:
-- memory holds only those on the belt.
--
-- The first worker is the thread that asked for it all. It alone hands over, and before anything else what is due: who
-- writes to a disk or a pipe that takes nothing is stopped there, and a signal reaches that thread only.
module Dioptre.Render.Parallel
  ( foldInOrder,
    workersAmong,
    mostWorkers,
  )
where

import Control.Applicative ((<|>))
import Control.Concurrent.Async (Async, pollSTM, replicateConcurrently_, wait, withAsync)
import Control.Concurrent.STM (STM, atomically, modifyTVar', newTVarIO, readTVar, retry, throwSTM, writeTVar)
import Control.Exception (evaluate)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.Maybe (fromMaybe)

-- | What is done and not yet handed over.
data Belt a = Belt
  { -- | The next number to compute.
    beltNext :: !Int,
    -- | The next number to hand over.
    beltDue :: !Int,
    beltLying :: !(IntMap a)
  }

-- | What there is to do.
data Task a = HandOver !Int a | Compute !Int | Stop

-- | @foldInOrder workers ahead n compute receive start@ computes values for 0, 1, ... n - 1, each once, by that many
-- workers, and hands them over with their numbers, one by one, in their order, as a fold from the left does. At most
-- @ahead@ values (at least 1) are in memory. They are handed over in the thread that calls this. An exception ends all
-- workers, and is thrown.
--
-- Law: it is 'Control.Monad.foldM' over the values, whatever the number of workers.
--
-- Spec: camera.independent.
foldInOrder :: Int -> Int -> Int -> (Int -> IO a) -> (b -> Int -> a -> IO b) -> b -> IO b
foldInOrder workers ahead n compute receive start = do
  belt <- newTVarIO (Belt 0 0 IntMap.empty)
  withAsync (replicateConcurrently_ (min n workers - 1) (help belt)) $ \helpers -> do
    result <- lead belt helpers start
    result <$ wait helpers
  where
    lead belt helpers before =
      atomically (dueOn belt <|> nextOn belt <|> nothingMore belt <|> brokenOff helpers) >>= \case
        HandOver i value -> do
          after <- receive before i value >>= evaluate
          atomically (modifyTVar' belt (\b -> b {beltDue = i + 1}))
          lead belt helpers after
        Compute i -> computed belt i >> lead belt helpers before
        Stop -> pure before
    help belt =
      atomically (nextOn belt <|> noneLeft belt) >>= \case
        Compute i -> computed belt i >> help belt
        _ -> pure ()
    computed belt i = do
      value <- compute i
      atomically (modifyTVar' belt (\b -> b {beltLying = IntMap.insert i value (beltLying b)}))

    -- Each of these waits until it can answer.
    dueOn belt = do
      Belt next due lying <- readTVar belt
      case IntMap.lookup due lying of
        Just value -> HandOver due value <$ writeTVar belt (Belt next due (IntMap.delete due lying))
        Nothing -> retry
    nextOn belt = do
      Belt next due lying <- readTVar belt
      if next < n && next < due + max 1 ahead then Compute next <$ writeTVar belt (Belt (next + 1) due lying) else retry
    noneLeft = finished beltNext
    nothingMore = finished beltDue
    finished number belt = readTVar belt >>= \b -> if number b >= n then pure Stop else retry

-- | Throws what has ended the helpers, if anything did.
brokenOff :: Async () -> STM (Task a)
brokenOff helpers = pollSTM helpers >>= maybe retry (either throwSTM (const retry))

-- | How many workers there are to be among so many processors, where a number may be wished for: no more than
-- processors, since more would only take memory, and no more than 'mostWorkers'.
--
-- >>> map (workersAmong 8) [Nothing, Just 3, Just 100000000]
-- [8,3,8]
--
-- Spec: cli.render.
workersAmong :: Int -> Maybe Int -> Int
workersAmong processors = max 1 . min (min processors mostWorkers) . fromMaybe processors

-- | 64. Each has a few megabytes and a few open files of its own, of which a process may often have only a thousand.
mostWorkers :: Int
mostWorkers = 64
