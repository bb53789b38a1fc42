-- |
-- Module      : Dioptre.Render.Parallel
-- Description : Rows, computed by several workers
--
-- Workers take the next row that nobody has, compute it with the pure function, and hand it over. Rows of uneven cost
-- even out; the order in which rows come is nobody's business, as each knows its place.
module Dioptre.Render.Parallel
  ( inParallel,
    workersAmong,
    mostWorkers,
  )
where

import Control.Concurrent.Async (replicateConcurrently_)
import Control.Monad (when)
import Data.IORef (atomicModifyIORef', newIORef)
import Data.Maybe (fromMaybe)

-- | Computes the values of a function at 0, 1, ... n - 1, each once, by that many workers, and hands each over as soon
-- as it is there. What receives them may be called by several workers at once. An exception ends all of them.
--
-- Law: what is handed over does not depend on the number of workers.
--
-- Spec: camera.independent.
inParallel :: Int -> Int -> (Int -> a) -> (Int -> a -> IO ()) -> IO ()
inParallel workers n compute receive = do
  next <- newIORef 0
  let work = do
        i <- atomicModifyIORef' next (\i -> (i + 1, i))
        when (i < n) $ do
          let value = compute i
          value `seq` receive i value
          work
  replicateConcurrently_ (max 1 (min n workers)) work

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
