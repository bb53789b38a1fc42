-- | Rows by several workers: all of them, once, in their order, and never too many.
module Dioptre.Render.ParallelSpec (spec) where

import Control.Concurrent (forkIO, killThread, myThreadId, newEmptyMVar, putMVar, takeMVar)
import Control.Exception (ErrorCall (..), evaluate, finally, throwIO)
import Control.Monad (foldM, forM_, void, when)
import Data.IORef (atomicModifyIORef', newIORef, readIORef)
import Dioptre.Render.Parallel
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck
import Test.QuickCheck.Monadic (monadicIO, run)

spec :: Spec
spec = describe "foldInOrder" $ do
  prop "is a fold from the left, whatever the number of workers" . forAll sizes $ \(workers, ahead, n) -> monadicIO $ do
    let note seen i value = pure ((i, value) : seen)
    together <- run (foldInOrder workers ahead n (evaluate . uneven) note [])
    alone <- run (foldM (\seen i -> note seen i (uneven i)) [] [0 .. n - 1])
    pure (together === alone)

  prop "computes each value once, and none too far ahead" . forAll sizes $ \(workers, ahead, n) -> monadicIO $ do
    begun <- run (newIORef [])
    handed <- run (newIORef 0)
    let compute i = do
          due <- readIORef handed
          atomicModifyIORef' begun (\these -> ((i, due) : these, ()))
          evaluate (uneven i)
    run (foldInOrder workers ahead n compute (\() i _ -> atomicModifyIORef' handed (const (i + 1, ()))) ())
    these <- run (readIORef begun)
    pure (length these === n .&&. conjoin [counterexample (show (i, due)) (i < due + max 1 ahead) | (i, due) <- these])

  prop "hands over in the thread that asked" . forAll sizes $ \(workers, ahead, n) -> monadicIO $ do
    me <- run myThreadId
    threads <- run (foldInOrder workers ahead n (evaluate . uneven) (\threads _ _ -> (: threads) <$> myThreadId) [])
    pure (threads === replicate n me)

  it "throws what a value throws" $
    forM_ [1, 2, 3] $ \workers ->
      foldInOrder workers 4 50 (\i -> if i == 17 then throwIO (ErrorCall "value") else pure i) (\sum' _ i -> pure (sum' + i)) 0 `shouldThrow` errorCall "value"

  it "throws what the taking throws, and takes nothing more" $
    forM_ [1, 2, 3] $ \workers -> do
      handed <- newIORef []
      foldInOrder workers 4 50 pure (\() i _ -> if i == 17 then throwIO (ErrorCall "taking") else atomicModifyIORef' handed (\these -> (i : these, ()))) () `shouldThrow` errorCall "taking"
      readIORef handed `shouldReturn` [16, 15 .. 0]

  it "ends when it is interrupted" $
    forM_ [1, 2, 3] $ \workers -> do
      reached <- newEmptyMVar
      ended <- newEmptyMVar
      thread <- forkIO (void (foldInOrder workers 4 1000000000 pure (\() i _ -> when (i == 17) (putMVar reached ())) ()) `finally` putMVar ended ())
      takeMVar reached
      killThread thread
      timeout 5000000 (takeMVar ended) `shouldReturn` Just ()

-- | Workers, how many values at once, and how many in all.
sizes :: Gen (Int, Int, Int)
sizes = (,,) <$> chooseInt (-1, 8) <*> chooseInt (-1, 9) <*> chooseInt (0, 60)

-- | A value that takes long for some numbers.
uneven :: Int -> Integer
uneven i = product [1 .. fromIntegral ((i * 37) `mod` 11) * 50] + fromIntegral i
