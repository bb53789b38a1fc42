{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.Command.Browser
-- Description : Opens the viewer's page in the user's browser
--
-- The page's address holds a secret ("Dioptre.View.Guard"), and whatever a program is started with can be read by every
-- user of the machine, in the list of processes. So the browser is not started with the address, but with a file that
-- leads there and that only the user may read. (Jupyter does the same.)
--
-- >  browser ---opens---> view.html, in a folder of mine ---leads to---> http://127.0.0.1:8000/#token=...
module Dioptre.Command.Browser
  ( withBrowser,
    opener,
  )
where

import Control.Concurrent (forkIO)
import Control.Exception (IOException, bracket, try)
import Control.Monad (void)
import qualified Data.ByteString.Char8 as Char8
import Data.Maybe (catMaybes)
import Dioptre.Files.Fault (quietly)
import System.Directory (findExecutable, getTemporaryDirectory, removeDirectoryRecursive)
import System.Environment (lookupEnv)
import System.FilePath ((</>))
import System.Info (os)
import System.Posix.Temp (mkdtemp)
import System.Process (CreateProcess (..), ProcessHandle, StdStream (NoStream), createProcess, proc, waitForProcess)

-- | Opens an address in the user's browser, if there is a screen and a way to do so, and does some work, which is told
-- whether there was.
withBrowser :: String -> (Bool -> IO a) -> IO a
withBrowser address act =
  opener >>= \case
    Nothing -> act False
    -- Nobody else may look into a folder that mkdtemp has made.
    Just program -> bracket (refused (mkdtemp . (</> "dioptre-") =<< getTemporaryDirectory)) (either (const (pure ())) remove) $ \case
      Left _ -> act False
      Right folder -> do
        let file = folder </> "view.html"
        started <- refused (Char8.writeFile file (Char8.pack (leadingTo address)) >> start program file)
        either (const (act False)) (\process -> forkIO (void (waitForProcess process)) >> act True) started
  where
    refused :: IO b -> IO (Either IOException b)
    refused = try
    remove = quietly . removeDirectoryRecursive

-- | The program that opens files in the user's browser.
opener :: IO (Maybe FilePath)
opener = do
  screens <- traverse lookupEnv ["DISPLAY", "WAYLAND_DISPLAY"]
  found <- traverse findExecutable (["xdg-open" | any (maybe False (not . null)) screens] <> ["open" | os == "darwin"])
  pure (case catMaybes found of program : _ -> Just program; [] -> Nothing)

start :: FilePath -> FilePath -> IO ProcessHandle
start program file = do
  (_, _, _, process) <- createProcess (proc program [file]) {std_in = NoStream, std_out = NoStream, std_err = NoStream, new_session = True}
  pure process

-- | A page that leads to an address at once.
leadingTo :: String -> String
leadingTo address = "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<title>Dioptre</title>\n<meta http-equiv=\"refresh\" content=\"0; url=" <> address <> "\">\n<p><a href=\"" <> address <> "\">Dioptre</a></p>\n"
