{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.View
-- Description : dioptre view: a scene in the browser
--
-- What a terminal sees of the viewer: the page's address, a browser that is opened if there is one, and the end.
-- The viewer itself is "Dioptre.View.Server". The application @frame@ ("Dioptre.Command.Run") views by the same
-- functions, and waits for a picture and for the page to be closed.
module Dioptre.Command.View
  ( ViewOptions (..),
    viewScene,
    builtIn,
    viewing,
    awaitPicture,
    awaitDeparture,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.STM (atomically, check, readTVar, readTVarIO, retry)
import Control.Monad (forever, when)
import Data.Maybe (isJust)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Browser (withBrowser)
import Dioptre.Command.Journal (Journal, journalLanguage, sayFault, sayText)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Load (sceneText)
import Dioptre.Scene.Configuration (defaultSceneFile)
import Dioptre.Scene.Default (defaultScene)
import Dioptre.Source.Language (inLanguage)
import Dioptre.Source.Text (Source, fromText)
import Dioptre.View.Desk (Checked (..), Desk (..))
import Dioptre.View.Frame (Frame)
import Dioptre.View.Server (Settings (..), Viewer (..), withViewer)
import System.Exit (ExitCode (..))
import System.IO (hFlush, stdout)
import System.IO.Error (ioeGetErrorString, isAlreadyInUseError)

-- | Where to view, and whether to open a browser.
data ViewOptions = ViewOptions
  { -- | At which port of this machine; any free one if there is none.
    viewPort :: Maybe Int,
    -- | Whether a browser is opened.
    viewBrowser :: Bool
  }

-- | Shows the scene in the file at a path, or the one that is built in, until Ctrl-C. Exit code 3 for a file that
-- cannot be read, or a port that cannot be had.
viewScene :: Journal -> ViewOptions -> Maybe FilePath -> IO ExitCode
viewScene journal options path =
  source >>= \case
    Left fault -> ExitFailure 3 <$ sayFault journal (fileFault (journalLanguage journal) fault)
    Right text -> viewing journal options False (text, isJust path) (const (forever (threadDelay maxBound)))
  where
    source = case path of
      Nothing -> pure (Right builtIn)
      Just file -> (>>= sceneText file) <$> readWhole file

-- | The text of the scene that is built in.
--
-- Spec: config.built-in.
builtIn :: Source
builtIn = fromText (Text.unpack defaultSceneFile) defaultScene

-- | Shows a scene while some work is done with the viewer. Says whether it is drawn also while nobody looks; and of the
-- scene, whether its name is the path of a file.
viewing :: Journal -> ViewOptions -> Bool -> (Source, Bool) -> (Viewer -> IO ExitCode) -> IO ExitCode
viewing journal options unwatched (source, hasFile) act = do
  outcome <- withViewer (Settings (viewPort options) l unwatched source hasFile) $ \viewer -> do
    Text.putStrLn (Text.pack (viewerAddress viewer))
    hFlush stdout
    (if viewBrowser options then withBrowser (viewerAddress viewer) else ($ False)) $ \opened -> do
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

-- | The first picture of a viewer, when it is finished; 'Nothing' for one that is too large to be shown.
awaitPicture :: Viewer -> IO (Maybe Frame)
awaitPicture viewer = atomically $ do
  desk <- readTVar (viewerTable viewer)
  case deskFinished desk of
    Just frame -> pure (Just frame)
    Nothing | isJust (deskChecked desk >>= checkedComplaint) -> pure Nothing
    Nothing -> retry

-- | Waits until a page was open and none is, and none comes back for a while: a page that is loaded anew is away for a
-- moment.
awaitDeparture :: Viewer -> IO ()
awaitDeparture viewer = do
  deserted
  threadDelay 3000000
  again <- (> 0) . deskPages <$> readTVarIO (viewerTable viewer)
  when again (awaitDeparture viewer)
  where
    deserted = atomically (readTVar (viewerTable viewer) >>= \desk -> check (deskVisits desk > 0 && deskPages desk == 0))
