-- |
-- Module      : Dioptre.View.Painter
-- Description : Draws what lies on the desk
--
-- One job at a time: whatever changes what there is to do ends the job at hand at once, and the next one begins.
module Dioptre.View.Painter
  ( Table,
    paintDesk,
    mostPixels,
  )
where

import Control.Concurrent.Async (waitSTM, withAsync)
import Control.Concurrent.STM (STM, TVar, atomically, check, modifyTVar', orElse, readTVar, readTVarIO, retry)
import Control.Exception (evaluate, onException)
import Control.Monad (forever, when)
import Dioptre.Load (Loaded (..), loadSource)
import Dioptre.Scene (sceneViewport)
import Dioptre.Scene.Camera (viewportHeight, viewportWidth)
import Dioptre.Source.Text (fromText)
import Dioptre.View.Desk
import Dioptre.View.Frame
import GHC.Conc (getNumCapabilities)

-- | The desk, where several may look at it and change it.
type Table = TVar Desk

-- | A page gets no picture with more pixels than this: 4096 x 4096, of which it and the program hold several copies.
-- @render@ draws larger ones.
mostPixels :: Int
mostPixels = 4096 * 4096

-- | Draws what lies on the desk, for ever. The path is the scene's: files that it names are looked for beside it.
paintDesk :: FilePath -> Table -> IO a
paintDesk path table = forever $ do
  job <- atomically (readTVar table >>= maybe retry pure . jobOf)
  -- Leaving this scope ends the work, and waits until it has ended.
  withAsync (work path table job) $ \running -> atomically (waitSTM running `orElse` overtaken job)
  where
    overtaken :: Job -> STM ()
    overtaken job = readTVar table >>= check . (/= Just job) . jobOf

-- | Reads the text, says what is wrong with it, and draws it if it is to be drawn.
work :: FilePath -> Table -> Job -> IO ()
work path table job = do
  desk <- readTVarIO table
  -- A text that has changed since then has another job, which is about to replace this one.
  when (jobOf desk == Just job) $ do
    loaded <- loadSource (deskLanguage desk) (fromText path (deskText desk))
    let port = sceneViewport (loadedScene loaded)
        complaint = if viewportWidth port * viewportHeight port > mostPixels then Just (TooLarge (viewportWidth port * viewportHeight port)) else Nothing
    isDrawn <- atomically $ do
      modifyTVar' table (checked job (loadedDiagnostics loaded) (loadedSought loaded) complaint)
      maybe False checkedDrawn . deskChecked <$> readTVar table
    when isDrawn $ do
      frame <- newFrame (deskFrames desk + 1) (jobVersion job) loaded
      _ <- evaluate (framePlan frame)
      atomically (modifyTVar' table (begun frame))
      workers <- getNumCapabilities
      paint workers (modifyTVar' table (ended job frame)) frame `onException` atomically (modifyTVar' (frameProgress frame) cancelled >> modifyTVar' table abandoned)
  where
    -- The end may come as the last row is reported.
    cancelled p = if progressEnd p == Finished then p else p {progressEnd = Cancelled}
