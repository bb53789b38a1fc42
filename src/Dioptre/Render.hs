{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Render
-- Description : A whole picture from a plan
--
-- The same picture twice: as the pure function that it is, and computed by several workers who tell how far they are.
module Dioptre.Render
  ( rendered,
    renderWith,
    Tally (..),
    tallyOf,
  )
where

import Data.IORef (atomicModifyIORef', newIORef, readIORef)
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Dioptre.Picture (Picture, picture)
import Dioptre.Render.Parallel (inParallel)
import Dioptre.Render.Row (Plan, Row (..), planHeight, planWidth, row)

-- | How many rays were cast, and how many times one was tested against a shape.
data Tally = Tally
  { tallyRays :: !Int,
    tallyTests :: !Int,
    -- | How many samples wanted more rays than are followed.
    tallyCut :: !Int
  }
  deriving stock (Eq, Show)

instance Semigroup Tally where
  Tally a b c <> Tally d e f = Tally (a + d) (b + e) (c + f)

-- | What a row took.
tallyOf :: Row -> Tally
tallyOf r = Tally (rowRays r) (rowTests r) (rowCut r)

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
  target <- Mutable.new (4 * planWidth p * planHeight p)
  tally <- newIORef (Tally 0 0 0)
  inParallel workers (planHeight p) (row p) $ \y r -> do
    Storable.copy (Mutable.slice (4 * planWidth p * y) (4 * planWidth p) target) (rowBytes r)
    atomicModifyIORef' tally (\before -> (before <> tallyOf r, ()))
    done
  -- Nobody writes to the target any more.
  bytes <- Storable.unsafeFreeze target
  (,) (picture (planWidth p) bytes) <$> readIORef tally
