{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Trace
-- Description : Tracing a picture while a person waits
--
-- What @render@ and the run without arguments share: all processors at work, a bar that shows how far they are, how
-- long it took, and a warning where rays were left out.
module Dioptre.Command.Trace
  ( traced,
    timed,
    sayCut,
  )
where

import Control.Monad (when)
import qualified Data.Text as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayText, withProgress)
import Dioptre.Picture (Picture)
import Dioptre.Render (Tally (..), renderWith)
import Dioptre.Render.Row (Plan, planHeight)
import Dioptre.Scene.Raytracer (mostRays)
import Dioptre.Source.Language (inLanguage)
import GHC.Clock (getMonotonicTime)
import GHC.Conc (getNumCapabilities)

-- | The picture of a plan by all processors, with a bar that shows how far it is.
traced :: Journal -> Plan -> IO (Picture, Tally)
traced journal planned = do
  workers <- getNumCapabilities
  withProgress journal (inLanguage (journalLanguage journal) "tracing" "tracé") (planHeight planned) $ \done -> renderWith workers done planned

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
