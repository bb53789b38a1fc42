{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Fuzz.Limits
-- Description : Work that may take so much and no more
--
-- A limit on time, by a timer, and one on memory: the run-time system counts what a thread allocates, and interrupts it
-- where that passes a limit. What is allocated is more than what is ever in memory at once, so that the second limit
-- bounds memory, and time too: but it is the same number on every machine, and on a busy one.
module Fuzz.Limits
  ( Budget (..),
    Outcome (..),
    limited,
  )
where

import Control.Exception (AllocationLimitExceeded (..), SomeAsyncException, SomeException, finally, fromException, throwIO, try)
import Data.Int (Int64)
import System.Mem (disableAllocationLimit, enableAllocationLimit, getAllocationCounter, setAllocationCounter)
import System.Timeout (timeout)

-- | How much some work may take.
data Budget = Budget
  { -- | In seconds.
    budgetSeconds :: Double,
    -- | In bytes allocated.
    budgetBytes :: Int64
  }

-- | What becomes of some work.
data Outcome a
  = -- | Its result, and how many bytes it took.
    Done a Int64
  | -- | An exception of its own.
    Threw SomeException
  | OutOfTime
  | OutOfMemory

-- | Does some work within a budget. What comes from outside, as Ctrl-C does, passes through.
limited :: Budget -> IO a -> IO (Outcome a)
limited budget work = do
  setAllocationCounter (budgetBytes budget)
  outcome <- try (timeout (ceiling (1e6 * budgetSeconds budget)) ((enableAllocationLimit >> work) `finally` disableAllocationLimit))
  left <- getAllocationCounter
  case outcome of
    Right (Just a) -> pure (Done a (budgetBytes budget - left))
    Right Nothing -> pure OutOfTime
    Left e
      | Just AllocationLimitExceeded <- fromException e -> pure OutOfMemory
      | Just outside <- fromException e -> throwIO (outside :: SomeAsyncException)
      | otherwise -> pure (Threw e)
