{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Trace
-- Description : Tracing a picture while a person waits
--
-- What @render@ and the run without arguments share: all processors at work, a bar that shows how far they are, how
-- long it took, and what there is to say of it: that it will be black, that rays were left out. A picture goes to its
-- file row by row, so that any that may be asked for fits into memory.
module Dioptre.Command.Trace
  ( Traced (..),
    traced,
    timed,
    sayCut,
    sayBlack,
  )
where

import Control.Monad (when)
import qualified Data.Text as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayText, withProgress)
import Dioptre.Files.Contents (Contents)
import Dioptre.Picture.Png (encodeRows)
import Dioptre.Render (renderRows)
import Dioptre.Render.Row (Plan, Row (..), planHeight, planWidth)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.World (Extent (..))
import Dioptre.Scene (Scene, sceneLights, sceneRaytracer)
import Dioptre.Scene.Raytracer (Raytracer (..), ReflexionAlgorithm (NoLight), mostRays)
import Dioptre.Source.Language (inLanguage)
import GHC.Clock (getMonotonicTime)
import GHC.Conc (getNumCapabilities)

-- | What tracing a picture took, for how many seconds, and for how many more its file was made and written.
data Traced = Traced {tracedTally :: !Tally, tracedSeconds :: !Double, writtenSeconds :: !Double}

-- | The file of a plan's picture, traced by all processors, with a bar that shows how far it is.
--
-- It is written while it is traced (see "Dioptre.Render.Parallel"). What counts as tracing is how long each processor
-- computed rows, in the mean, and as writing what is left of the time.
traced :: Journal -> Plan -> Contents Traced
traced journal planned put = do
  workers <- getNumCapabilities
  let rows receive = withProgress journal (inLanguage (journalLanguage journal) "tracing" "tracé") (planHeight planned) $ \done ->
        renderRows workers planned (\_ r -> receive (rowBytes r) >> done)
  (both, (tally, tracing)) <- timed (encodeRows (planWidth planned) (planHeight planned) rows put)
  pure (Traced tally tracing (max 0 (both - tracing)))

-- | How long some work took, in seconds.
timed :: IO a -> IO (Double, a)
timed work = do
  start <- getMonotonicTime
  result <- work
  end <- getMonotonicTime
  pure (end - start, result)

-- | Says that a picture will be black, and why, where that is seen in its scene as it stands; for a world of that size.
--
-- Spec: cli.render.black.
sayBlack :: Journal -> Scene -> Extent -> IO ()
sayBlack journal scene size
  | extentShapes size == 0 = remark "the scene has no shape" "la scène n'a aucune forme"
  | null (sceneLights scene) && raytracerAlgorithm (sceneRaytracer scene) /= NoLight =
    remark "the scene has no light (reflexion_algorithm no_light would show its colours without one)" "la scène n'a aucune lumière (reflexion_algorithm no_light montrerait ses couleurs sans elle)"
  | otherwise = pure ()
  where
    l = journalLanguage journal
    remark en fr = sayText journal (inLanguage l ("remark: the picture is black: " <> en) ("remarque\xA0: l'image est noire\xA0: " <> fr))

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
