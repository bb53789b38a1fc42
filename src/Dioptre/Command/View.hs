{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.View
-- Description : dioptre view: a scene in the browser
module Dioptre.Command.View
  ( ViewOptions (..),
    viewScene,
    builtIn,
    viewing,
    opener,
    awaitPicture,
    awaitDeparture,
  )
where

import Control.Concurrent (forkIO, threadDelay)
import Control.Concurrent.STM (atomically, check, readTVar, readTVarIO, retry)
import Control.Exception (IOException, try)
import Control.Monad (forever, void, when)
import Data.Maybe (catMaybes, isJust, listToMaybe)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayFault, sayText)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Scene.Configuration (defaultSceneFile)
import Dioptre.Scene.Default (defaultScene)
import Dioptre.Source.Language (inLanguage)
import Dioptre.Source.Text (Source, decode, fromText)
import Dioptre.View.Desk (Checked (..), Desk (..))
import Dioptre.View.Frame (Frame)
import Dioptre.View.Server (Settings (..), Viewer (..), withViewer)
import System.Directory (findExecutable)
import System.Environment (lookupEnv)
import System.Exit (ExitCode (..))
import System.IO (Handle, hFlush, stdout)
import System.IO.Error (ioeGetErrorString, isAlreadyInUseError)
import System.Info (os)
import System.Process (CreateProcess (..), ProcessHandle, StdStream (NoStream), createProcess, proc, waitForProcess)

-- | Where to view, and whether to open a browser.
data ViewOptions = ViewOptions
  { -- | At which port of this machine; any free one if there is none.
    viewPort :: Maybe Int,
    -- | Whether a browser is opened.
    viewBrowser :: Bool
  }

-- | Shows the scene in the file at a path, or the one that is built in, until Ctrl-C. Exit code 3 for a file that cannot be read, or a port that cannot be had.
viewScene :: Journal -> ViewOptions -> Maybe FilePath -> IO ExitCode
viewScene journal options path =
  source >>= \case
    Left fault -> ExitFailure 3 <$ sayFault journal (fileFault (journalLanguage journal) fault)
    Right text -> viewing journal options False (text, isJust path) (const (forever (threadDelay maxBound)))
  where
    source = case path of
      Nothing -> pure (Right builtIn)
      Just file -> fmap (decode file) <$> readWhole file

-- | The text of the scene that is built in.
builtIn :: Source
builtIn = fromText (Text.unpack defaultSceneFile) defaultScene

-- | Shows a scene while some work is done with the viewer. Says whether it is drawn also while nobody looks; and of the scene, whether its name is the path of a file.
viewing :: Journal -> ViewOptions -> Bool -> (Source, Bool) -> (Viewer -> IO ExitCode) -> IO ExitCode
viewing journal options unwatched (source, hasFile) act = do
  outcome <- withViewer (Settings (viewPort options) l unwatched source hasFile) $ \viewer -> do
    Text.putStrLn (Text.pack (viewerAddress viewer))
    hFlush stdout
    opened <- if viewBrowser options then openBrowser (viewerAddress viewer) else pure False
    sayText journal $
      if opened
        then inLanguage l "the page opens in your browser; Ctrl-C here ends it" "la page s'ouvre dans votre navigateur\xA0; Ctrl-C ici y met fin"
        else inLanguage l "open this address in a browser; Ctrl-C here ends it" "ouvrez cette adresse dans un navigateur\xA0; Ctrl-C ici y met fin"
    act viewer
  either (\e -> ExitFailure 3 <$ sayFault journal (portFault e)) pure outcome
  where
    l = journalLanguage journal
    portFault e =
      Text.concat
        [ "port " <> maybe "" (Text.pack . show) (viewPort options) <> inLanguage l ": " "\xA0: ",
          if isAlreadyInUseError e
            then inLanguage l "another program uses it; choose another with --port, or leave the choice to this one" "un autre programme l'utilise\xA0; choisissez-en un autre avec --port, ou laissez celui-ci choisir"
            else Text.pack (ioeGetErrorString e)
        ]

-- | Opens a page in the user's browser, if there is a screen and a way to do so; says whether.
openBrowser :: String -> IO Bool
openBrowser page =
  opener >>= \case
    Nothing -> pure False
    Just program ->
      (try (createProcess (proc program [page]) {std_in = NoStream, std_out = NoStream, std_err = NoStream, new_session = True}) :: IO (Either IOException (Maybe Handle, Maybe Handle, Maybe Handle, ProcessHandle))) >>= \case
        Left _ -> pure False
        Right (_, _, _, process) -> True <$ forkIO (void (waitForProcess process))

-- | The program that opens pages in the user's browser, if there is a screen and such a program.
opener :: IO (Maybe FilePath)
opener = do
  screens <- traverse lookupEnv ["DISPLAY", "WAYLAND_DISPLAY"]
  found <- traverse findExecutable (["xdg-open" | any (maybe False (not . null)) screens] <> ["open" | os == "darwin"])
  pure (listToMaybe (catMaybes found))

-- | The first picture of a viewer, when it is finished; 'Nothing' for one that is too large to be shown.
awaitPicture :: Viewer -> IO (Maybe Frame)
awaitPicture viewer = atomically $ do
  desk <- readTVar (viewerTable viewer)
  case deskFinished desk of
    Just frame -> pure (Just frame)
    Nothing | isJust (deskChecked desk >>= checkedComplaint) -> pure Nothing
    Nothing -> retry

-- | Waits until a page was open and none is, and none comes back for a while: a page that is loaded anew is away for a moment.
awaitDeparture :: Viewer -> IO ()
awaitDeparture viewer = do
  deserted
  threadDelay 3000000
  again <- (> 0) . deskPages <$> readTVarIO (viewerTable viewer)
  when again (awaitDeparture viewer)
  where
    deserted = atomically (readTVar (viewerTable viewer) >>= \desk -> check (deskVisits desk > 0 && deskPages desk == 0))
