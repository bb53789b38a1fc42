-- |
-- Module      : Dioptre.View.Watch
-- Description : A file that somebody else may change
--
-- Editors write in many ways: into the file, or beside it with a rename, in one piece or several. So it is the folder
-- that is watched, any event about the name counts as a hint, and after a short while the file is read.
module Dioptre.View.Watch
  ( watching,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM (atomically, check, newTVarIO, readTVar, writeTVar)
import Control.Exception (IOException, try)
import Control.Monad (forever)
import Data.Foldable (traverse_)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Source.Text (Source, decode)
import System.Directory (canonicalizePath)
import System.FSNotify (StopListening, eventPath, watchDir, withManager)
import System.FilePath (takeDirectory, takeFileName)

-- | Does some work, and meanwhile hands over what a file says after it may have changed. One that cannot be read is
-- passed over: it may be about to be written. Where the system cannot watch, nothing is handed over.
watching :: FilePath -> (Source -> IO ()) -> IO a -> IO a
watching path changed act = do
  real <- canonicalizePath path
  hint <- newTVarIO False
  let settled = forever $ do
        atomically (readTVar hint >>= check >> writeTVar hint False)
        threadDelay aWhile
        readWhole path >>= traverse_ (changed . decode path)
  withManager $ \manager -> do
    watched <- try (watchDir manager (takeDirectory real) ((== takeFileName real) . takeFileName . eventPath) (const (atomically (writeTVar hint True))))
    case watched :: Either IOException StopListening of
      Left _ -> act
      Right _ -> withAsync settled (const act)
  where
    -- In microseconds: longer than an editor takes between two pieces, shorter than anybody notices.
    aWhile = 50000
