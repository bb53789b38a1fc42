{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Trace
-- Description : Tracing a picture while a person waits
--
-- What @render@ and the run without arguments share: all processors at work, a bar that shows how far they are, how
-- long it took, and a warning where rays were left out. A picture goes to its file row by row, so that any that may be
-- asked for fits into memory.
module Dioptre.Command.Trace
  ( Traced (..),
    traced,
    timed,
    sayCut,
  )
where

import Control.Monad (when)
import Data.IORef (modifyIORef', newIORef, readIORef)
import qualified Data.Text as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayText, withProgress)
import Dioptre.Files.Contents (Contents)
import Dioptre.Picture.Png (encodeRows)
import Dioptre.Render (renderRows)
import Dioptre.Render.Row (Plan, Row (..), planHeight, planWidth)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Scene.Raytracer (mostRays)
import Dioptre.Source.Language (inLanguage)
import GHC.Clock (getMonotonicTime)
import GHC.Conc (getNumCapabilities)

-- | What tracing a picture took, and for how many seconds.
data Traced = Traced {tracedTally :: !Tally, tracedSeconds :: !Double}

-- | The file of a plan's picture, traced by all processors, with a bar that shows how far it is.
--
-- Workers write as they trace (see "Dioptre.Render.Parallel"). What the writing takes them is told apart: of so many
-- workers, each spent one part of that, and the rest of the time tracing.
traced :: Journal -> Plan -> Contents Traced
traced journal planned put = do
  workers <- min (planHeight planned) <$> getNumCapabilities
  written <- newIORef 0
  let row receive done _ r = do
        (spent, ()) <- timed (receive (rowBytes r))
        modifyIORef' written (+ spent)
        done
      rows receive = withProgress journal (inLanguage (journalLanguage journal) "tracing" "tracé") (planHeight planned) (renderRows workers planned . row receive)
  (seconds, tally) <- timed (encodeRows (planWidth planned) (planHeight planned) rows put)
  spent <- readIORef written
  pure (Traced tally (seconds - spent / fromIntegral workers))

-- | How long some work took, in seconds.
timed :: IO a -> IO (Double, a)
timed work = do
  start <- getMonotonicTime
  result <- work
  end <- getMonotonicTime
  pure (end - start, result)

-- | Says that some pixels wanted more rays than are followed, if any did.
sayCut :: Journal -> Tally -> IO ()
sayCut journal tally =
  when (tallyCut tally > 0) . sayText journal $
    inLanguage l "warning: " "avertissement\xA0: "
      <> Text.pack (show (tallyCut tally))
      <> inLanguage l " rays of the camera branched into more than " " rayons de la caméra se sont ramifiés en plus de "
      <> Text.pack (show mostRays)
      <> inLanguage l "; what lies beyond those is black" "\xA0; ce qui est au-delà est noir"
  where
    l = journalLanguage journal
