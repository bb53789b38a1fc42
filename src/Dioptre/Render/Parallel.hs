-- |
-- Module      : Dioptre.Render.Parallel
-- Description : Rows, computed by several workers and handed over in their order
--
-- Workers take the next row that nobody has, and compute it with the pure function; rows of uneven cost even out. What
-- is done goes onto a belt, from which it leaves in order, by the hands of whichever worker comes by when the next one
-- lies there:
--
-- >   handed over |  due                          next
-- >   0 1 2 3 4 5 |   6    7    8    9   10   11   12
-- >               |   .   lies lies  .   lies  .        .  somebody computes it
-- >               '---------------- ahead --------------'
--
-- Nobody begins a row that is too far ahead of the one that is due, so that a picture may have any number of rows:
-- memory holds only those on the belt.
module Dioptre.Render.Parallel
  ( foldInOrder,
    workersAmong,
    mostWorkers,
  )
where

import Control.Concurrent.Async (replicateConcurrently_)
import Control.Concurrent.STM (STM, TVar, atomically, check, modifyTVar', newTVarIO, readTVar, readTVarIO, writeTVar)
import Control.Exception (evaluate)
import Control.Monad (forM_, when)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.Maybe (fromMaybe, isJust)

-- | What is done and not yet handed over.
data Belt a b = Belt
  { -- | The next number to compute.
    beltNext :: !Int,
    -- | The next number to hand over.
    beltDue :: !Int,
    beltLying :: !(IntMap a),
    -- | What came of the values before; 'Nothing' while somebody is handing one over.
    beltResult :: !(Maybe b)
  }

-- | @foldInOrder workers ahead n compute receive start@ computes the values of a function at 0, 1, ... n - 1, each once,
-- by that many workers, and hands them over with their numbers, one by one, in their order, as a fold from the left
-- does. At most @ahead@ values (at least 1) are in memory. An exception ends all workers, and is thrown.
--
-- Law: it is 'Control.Monad.foldM' over the values, whatever the number of workers.
--
-- Spec: camera.independent.
foldInOrder :: Int -> Int -> Int -> (Int -> a) -> (b -> Int -> a -> IO b) -> b -> IO b
foldInOrder workers ahead n compute receive start = do
  belt <- newTVarIO (Belt 0 0 IntMap.empty (Just start))
  replicateConcurrently_ (max 1 (min n workers)) (work belt)
  fromMaybe start . beltResult <$> readTVarIO belt
  where
    work belt = do
      number <- atomically (taken (max 1 ahead) n belt)
      forM_ number $ \i -> do
        value <- evaluate (compute i)
        atomically (modifyTVar' belt (\b -> b {beltLying = IntMap.insert i value (beltLying b)}))
        handOver belt
        work belt
    handOver belt = do
      ready <- atomically (picked belt)
      forM_ ready $ \(before, i, value) -> do
        after <- receive before i value >>= evaluate
        atomically (modifyTVar' belt (\b -> b {beltDue = i + 1, beltResult = Just after}))
        handOver belt

-- | The next number to compute, once it is near enough to what is due; 'Nothing' if there is none any more.
taken :: Int -> Int -> TVar (Belt a b) -> STM (Maybe Int)
taken ahead n belt = do
  b <- readTVar belt
  let i = beltNext b
  if i >= n
    then pure Nothing
    else do
      check (i < beltDue b + ahead)
      writeTVar belt b {beltNext = i + 1}
      pure (Just i)

-- | What came before, and the value that is due with its number, if it lies there and nobody else is handing over. Who is will look
-- again afterwards, and so finds what was laid down meanwhile.
picked :: TVar (Belt a b) -> STM (Maybe (b, Int, a))
picked belt = do
  b <- readTVar belt
  let due = beltDue b
      found = (\before value -> (before, due, value)) <$> beltResult b <*> IntMap.lookup due (beltLying b)
  when (isJust found) $ writeTVar belt b {beltLying = IntMap.delete due (beltLying b), beltResult = Nothing}
  pure found

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
