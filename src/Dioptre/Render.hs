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
  )
where

import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Dioptre.Picture (Picture, picture)
import Dioptre.Render.Parallel (foldInOrder)
import Dioptre.Render.Row (Plan, Row (..), planHeight, planWidth, row)
import Dioptre.Render.Tally (Tally)

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
  tally <- renderRows workers p $ \y r -> do
    Storable.copy (Mutable.slice (stride * y) stride target) (rowBytes r)
    done
  -- Nobody writes to the target any more.
  bytes <- Storable.unsafeFreeze target
  pure (picture (planWidth p) bytes, tally)
  where
    stride = 4 * planWidth p

-- | The rows of the same picture by that many workers, handed over one by one from the top, with their numbers.
--
-- Cost: 'rowsAhead' rows in memory, however many the picture has.
renderRows :: Int -> Plan -> (Int -> Row -> IO ()) -> IO Tally
renderRows workers p receive = foldInOrder workers (rowsAhead workers (planWidth p)) (planHeight p) (row p) hand mempty
  where
    hand tally y r = (tally <> rowTally r) <$ receive y r

-- | How many rows of that width may be in memory for so many workers: enough that nobody waits for a row that takes
-- long, and no more than 4 MB of them if that is two for each worker.
--
-- >>> [rowsAhead 2 w | w <- [100, 2000, 16384, 16777216]]
-- [64,64,64,4]
rowsAhead :: Int -> Int -> Int
rowsAhead workers width = max (2 * workers) (min (32 * workers) (1048576 `div` max 1 width))
