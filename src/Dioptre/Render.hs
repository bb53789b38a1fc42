-- |
-- Module      : Dioptre.Render
-- Description : A whole picture from a plan
--
-- The same picture three times: as the pure function that it is, computed by several workers who tell how far they are,
-- and row by row, for who needs no picture in memory.
module Dioptre.Render
  ( rendered,
    renderWith,
    renderRows,
    rowsAhead,
    rowsAtOnce,
  )
where

import Control.Exception (evaluate)
import Control.Monad (zipWithM_)
import Data.List (foldl')
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Dioptre.Picture (Picture, picture)
import Dioptre.Render.Parallel (foldInOrder)
import Dioptre.Render.Row (Plan, Row (..), planHeight, planWidth, row)
import Dioptre.Render.Tally (Tally)
import GHC.Clock (getMonotonicTime)

-- | The picture of a plan: all its rows, from the top.
--
-- Spec: camera.every-pixel, picture.deterministic.
rendered :: Plan -> Picture
rendered p = picture (planWidth p) (Storable.concat [rowBytes (row p y) | y <- [0 .. planHeight p - 1]])

-- | The same picture by that many workers; each row that is done is reported.
--
-- Law: the picture is 'rendered', whatever the number of workers.
renderWith :: Int -> IO () -> Plan -> IO (Picture, Tally)
renderWith workers done p = do
  target <- Mutable.new (stride * planHeight p)
  (tally, _) <- renderRows workers p $ \y r -> do
    Storable.copy (Mutable.slice (stride * y) stride target) (rowBytes r)
    done
  -- Nobody writes to the target any more.
  bytes <- Storable.unsafeFreeze target
  pure (picture (planWidth p) bytes, tally)
  where
    stride = 4 * planWidth p

-- | The rows of the same picture by that many workers, handed over one by one from the top, with their numbers, in
-- the thread that calls this. Tells what they took, and for how many seconds each worker computed them in the mean.
--
-- Cost: some 'rowsAhead' rows in memory, however many the picture has.
renderRows :: Int -> Plan -> (Int -> Row -> IO ()) -> IO (Tally, Double)
renderRows workers p receive = do
  (tally, spent) <- foldInOrder workers (max (2 * workers) (rowsAhead workers (planWidth p) `div` atOnce)) pieces piece hand (mempty, 0)
  pure (tally, spent / fromIntegral (max 1 (min workers pieces)))
  where
    atOnce = rowsAtOnce workers (planWidth p) (planHeight p)
    pieces = (planHeight p + atOnce - 1) `div` atOnce
    piece k = do
      began <- getMonotonicTime
      rows <- traverse (evaluate . row p) [k * atOnce .. min (planHeight p) ((k + 1) * atOnce) - 1]
      ended <- getMonotonicTime
      pure (rows, ended - began)
    hand (before, spent) k (rows, seconds) = do
      zipWithM_ receive [k * atOnce ..] rows
      let tally = foldl' (\sum' r -> sum' <> rowTally r) before rows
          total = spent + seconds
      tally `seq` total `seq` pure (tally, total)

-- | How many rows a worker computes before it hands them over, in a picture of that width and height. Handing over takes
-- a microsecond, so that of rows of a few pixels there are as many as have 4096; but never so many that fewer than 32
-- pieces are left for each worker: pixels may take long, and pieces may be uneven.
--
-- >>> [rowsAtOnce 2 w h | (w, h) <- [(1, 2000000), (60, 40), (300, 300), (2000, 2000), (10000, 10000)]]
-- [4096,1,4,2,1]
rowsAtOnce :: Int -> Int -> Int -> Int
rowsAtOnce workers width height = max 1 (min (4096 `div` max 1 width) (height `div` (32 * workers)))

-- | How many rows of that width may be in memory for so many workers: enough that nobody waits for a row that takes
-- long, and no more than 4 MB of them if that is two for each worker.
--
-- >>> [rowsAhead 2 w | w <- [100, 2000, 16384, 16777216]]
-- [64,64,64,4]
rowsAhead :: Int -> Int -> Int
rowsAhead workers width = max (2 * workers) (min (32 * workers) (1048576 `div` max 1 width))
