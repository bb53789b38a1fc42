{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.View.Frame
-- Description : A picture in the making
--
-- Workers paint it strip by strip, and whoever likes looks at the strips that are there. Nobody waits for anybody: a
-- strip is put on a list once its bytes are in place, and each onlooker remembers how much of the list it has seen.
--
-- First comes every eighth pixel of every eighth row, which is a sixty-fourth of the work and already a picture; then
-- the rows themselves.
--
-- >  coarse row 0   . . . . . . . .      each pixel stands for the 8 x 8 around it
-- >  coarse row 1   . . . . . . . .
-- >       ...
-- >  row 0          ................
-- >  row 1          ................
module Dioptre.View.Frame
  ( -- * Frames
    Frame (..),
    newFrame,
    coarseness,

    -- * Painting
    paint,

    -- * Looking
    Strip (..),
    Progress (..),
    End (..),
    stripBytes,
    framePicture,
  )
where

import Control.Concurrent.STM (STM, TVar, atomically, modifyTVar', newTVarIO)
import Control.Exception (evaluate)
import Control.Monad (void)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Data.Word (Word8)
import Dioptre.Load (Loaded (..), loadedPlan)
import Dioptre.Picture (Picture, picture)
import Dioptre.Picture.Byte (Pixel (..), pixelOf)
import Dioptre.Render (renderRows, rowsAhead)
import Dioptre.Render.Parallel (foldInOrder)
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row (Plan, Row (..), colourAt, planHeight, planWidth)
import Dioptre.Render.Tally (Tally)
import Dioptre.Scene (sceneRaytracer)
import Dioptre.Scene.Raytracer (Raytracer (..))
import Foreign.ForeignPtr (castForeignPtr, withForeignPtr)
import GHC.Clock (getMonotonicTime)

-- | A picture in the making.
data Frame = Frame
  { -- | Frames are counted from 1.
    frameNumber :: !Int,
    -- | The version of the text that it shows.
    frameVersion :: !Int,
    -- | What that text says.
    frameLoaded :: !Loaded,
    -- | The same, made ready.
    framePlan :: !Plan,
    -- | When it was begun, in seconds of a clock that only goes forward.
    frameBegan :: !Double,
    -- | The picture's bytes.
    frameFine :: !(Mutable.IOVector Word8),
    -- | The bytes of the coarse picture.
    frameCoarse :: !(Mutable.IOVector Word8),
    -- | How far it is.
    frameProgress :: !(TVar Progress)
  }

-- | A piece that is there: a row of the coarse picture, or one of the picture.
data Strip = Coarse !Int | Fine !Int
  deriving stock (Eq, Show)

-- | How far a frame is.
data Progress = Progress
  { -- | What is there, in the order in which it came.
    progressStrips :: !(Seq Strip),
    -- | How many rows of the picture are there.
    progressRows :: !Int,
    -- | What these rows took.
    progressTally :: !Tally,
    -- | How long it has been painted, in seconds, as of the last strip.
    progressSeconds :: !Double,
    -- | Whether it is painted on.
    progressEnd :: !End
  }

-- | Whether a frame is being painted, is finished, or will never be.
data End = Going | Finished | Cancelled
  deriving stock (Eq, Show)

-- | One pixel of the coarse picture stands for so many, each way.
coarseness :: Int
coarseness = 8

-- | The frame of that number, for that version of the text, in which nothing is painted.
newFrame :: Int -> Int -> Loaded -> IO Frame
newFrame number version loaded =
  Frame number version loaded planned
    <$> getMonotonicTime
    <*> Mutable.new (4 * planWidth planned * planHeight planned)
    <*> Mutable.new (4 * coarse (planWidth planned) * coarse (planHeight planned))
    <*> newTVarIO (Progress Seq.empty 0 mempty 0 Going)
  where
    planned = loadedPlan loaded

-- | How many pixels of the coarse picture there are for so many of the picture.
coarse :: Int -> Int
coarse n = (n + coarseness - 1) `div` coarseness

-- | The column or row, of so many, that a column or row of the coarse picture shows.
shownBy :: Int -> Int -> Int
shownBy n k = min (n - 1) (coarseness * k + coarseness `div` 2)

-- | Paints a frame by that many workers, and ends it; whoever sees that it is finished also sees what is given to be
-- done then. Exceptions end the painting and leave the frame as it is.
--
-- Law: its picture is the one that "Dioptre.Render" makes of its plan.
paint :: Int -> STM () -> Frame -> IO ()
paint workers finish frame = do
  foldInOrder workers (rowsAhead workers (coarse (planWidth planned))) (coarse (planHeight planned)) (evaluate . coarseRow frame) (const coarseDone) ()
  void (renderRows workers planned fineDone)
  report finish (\p -> p {progressEnd = Finished})
  where
    planned = framePlan frame
    coarseDone k bytes = do
      place (frameCoarse frame) k bytes
      report (pure ()) (\p -> p {progressStrips = progressStrips p |> Coarse k})
    fineDone y r = do
      place (frameFine frame) y (rowBytes r)
      report (pure ()) (\p -> p {progressStrips = progressStrips p |> Fine y, progressRows = y + 1, progressTally = progressTally p <> rowTally r})
    place target k bytes = Storable.copy (Mutable.slice (k * Storable.length bytes) (Storable.length bytes) target) bytes
    report also change = do
      now <- getMonotonicTime
      atomically (modifyTVar' (frameProgress frame) (\p -> (change p) {progressSeconds = max (progressSeconds p) (now - frameBegan frame)}) >> also)

-- | A row of the coarse picture. Its pixels are pixels of the picture.
coarseRow :: Frame -> Int -> Storable.Vector Word8
coarseRow frame k = Storable.concat [pixel (shownBy (planWidth planned) j) | j <- [0 .. coarse (planWidth planned) - 1]]
  where
    planned = framePlan frame
    y = shownBy (planHeight planned) k
    normalization = raytracerColourNormalization (sceneRaytracer (loadedScene (frameLoaded frame)))
    pixel x = let Seen c _ = colourAt planned x y; Pixel r g b a = pixelOf normalization c in Storable.fromList [r, g, b, a]

-- | The bytes of a strip that is there.
stripBytes :: Frame -> Strip -> IO ByteString
stripBytes frame strip = case strip of
  Coarse k -> slice (frameCoarse frame) k (4 * coarse (planWidth (framePlan frame)))
  Fine y -> slice (frameFine frame) y (4 * planWidth (framePlan frame))
  where
    slice source k n = let (pointer, _) = Mutable.unsafeToForeignPtr0 (Mutable.slice (k * n) n source) in withForeignPtr (castForeignPtr pointer) (\p -> Bytes.packCStringLen (p, n))

-- | The picture of a frame that is finished.
framePicture :: Frame -> IO Picture
framePicture frame = picture (planWidth (framePlan frame)) <$> Storable.freeze (frameFine frame)
