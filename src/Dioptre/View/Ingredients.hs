-- |
-- Module      : Dioptre.View.Ingredients
-- Description : The other files that a scene is made of, which somebody may change
--
-- A scene names models and textures, models name others and their materials, and materials name textures. When one of
-- them is saved, comes or goes, the picture is drawn anew.
--
-- What is watched are folders, as in "Dioptre.View.Watch": those where files were found, and those where a better one
-- could come, which are the folder of whoever names it, the working directory, and scenes and models there. (A name is
-- also looked for deeper in the working directory. A file that comes there is seen when the text is changed next.) In
-- them every event about one of the names is a hint. Each look at the text says anew which these are.
module Dioptre.View.Ingredients
  ( watchingIngredients,
    mostFolders,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (withAsync)
import Control.Concurrent.STM
import Control.Exception (IOException, try)
import Control.Monad (filterM, forever, when)
import Data.Either (rights)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Files.Search (knownName, wantedName)
import Dioptre.Load.Shelf (Found (..), seek)
import Dioptre.Source.Diagnostic (FileTrouble (..))
import Dioptre.View.Desk (Checked (..), Desk (..), Sought, filesChanged)
import Dioptre.View.Painter (Table)
import System.Directory (canonicalizePath, doesDirectoryExist)
import System.FSNotify (StopListening, WatchManager, eventPath, watchDir, withManager)
import System.FilePath (takeDirectory, takeFileName)

-- | Does some work, and meanwhile notes on the desk when a file may have changed that the scene on it is made of. Where
-- the system cannot watch, nothing is noted.
watchingIngredients :: Table -> IO a -> IO a
watchingIngredients table act = withAsync (forever (session table)) (const act)

-- | Watches the folders that matter for the text at hand, until others do, or until a hint has been noted.
session :: Table -> IO ()
session table = do
  (look, sought) <- atomically (readTVar table >>= maybe retry pure . currentLook)
  folders <- foldersOf sought
  names <- namesOf sought >>= newTVarIO
  hint <- newTVarIO False
  let -- What happened before all this was watched gave no hint, and is found out by looking again.
      unchanged known = (&&) <$> ((== folders) <$> foldersOf known) <*> (and <$> traverse (\((folder, name), found) -> (== found) <$> seek folder name) (Map.toList known))
      awaitHint looked known = do
        isSame <- unchanged known
        next <- if isSame then atomically ((Left <$> (readTVar hint >>= check)) `orElse` (Right <$> (readTVar table >>= maybe retry pure . otherLook looked))) else pure (Left ())
        case next of
          Left () -> True <$ settle hint mostPieces
          Right (looked', known') -> do
            stays <- (== folders) <$> foldersOf known'
            namesOf known' >>= atomically . writeTVar names
            if stays then awaitHint looked' known' else pure False
  changed <- withManager $ \manager -> do
    mapM_ (watched manager hint names) folders
    awaitHint look sought
  when changed (atomically (modifyTVar' table filesChanged))
  where
    currentLook desk = case lookOf <$> deskChecked desk of
      Just found | fst found == (deskVersion desk, deskChanges desk) -> Just found
      _ -> Nothing
    otherLook looked desk = case lookOf <$> deskChecked desk of
      Just found | fst found /= looked -> Just found
      _ -> Nothing
    lookOf c = ((checkedVersion c, checkedChanges c), checkedSought c)

-- | Watches a folder: an event about one of the names is a hint.
watched :: WatchManager -> TVar Bool -> TVar (Set Text) -> FilePath -> IO (Either IOException StopListening)
watched manager hint names folder = try (watchDir manager folder (const True) noting)
  where
    noting event = do
      name <- knownName (takeFileName (eventPath event))
      atomically (readTVar names >>= \known -> when (name `Set.member` known) (writeTVar hint True))

-- | Waits until there have been no hints for a while: a file may be written in pieces. But not for ever.
settle :: TVar Bool -> Int -> IO ()
settle hint most = do
  atomically (writeTVar hint False)
  threadDelay aWhile
  again <- readTVarIO hint
  when (again && most > 0) (settle hint (most - 1))
  where
    -- In microseconds, as in "Dioptre.View.Watch".
    aWhile = 50000

-- | So many pieces of a file are waited for, each a while long: a second.
mostPieces :: Int
mostPieces = 20

-- | So many folders are watched.
mostFolders :: Int
mostFolders = 64

-- | The folders in which something may happen to these files; none if there are none. Where they are more than
-- 'mostFolders', those of the files that name others come first, then the ones that are always searched.
foldersOf :: Sought -> IO (Set FilePath)
foldersOf sought
  | Map.null sought = pure Set.empty
  | otherwise = do
    there <- filterM doesDirectoryExist (concat [map fst (Map.keys sought), [".", "scenes", "models"], concatMap places (Map.elems sought)])
    limited Set.empty <$> traverse canonicalizePath there
  where
    places = either candidates (\found -> [takeDirectory (foundPath found), takeDirectory (foundFile found)])
    candidates trouble = case trouble of
      SeveralFiles paths -> map takeDirectory paths
      _ -> []
    limited known folders = case folders of
      folder : rest | Set.size known < mostFolders -> limited (Set.insert folder known) rest
      _ -> known

-- | The names that matter in them: those of the files, and of the folders that may come.
namesOf :: Sought -> IO (Set Text)
namesOf sought = do
  real <- traverse (knownName . takeFileName . foundFile) (rights (Map.elems sought))
  pure (Set.fromList (real <> mapMaybe (wantedName . snd) (Map.keys sought) <> map Text.pack ["scenes", "models"]))
