{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.Files.Identity
-- Description : Whether two paths lead to one file
--
-- One file has many paths: @x@ and @.\/x@, links to it, names that share it. What tells is the file itself: a device,
-- and a number there.
--
-- Sources: POSIX.1-2017, @stat()@
-- (<https://pubs.opengroup.org/onlinepubs/9699919799/functions/stat.html>).
module Dioptre.Files.Identity
  ( Identity,
    identity,
    identityOf,
    statusOf,
    sameFile,
  )
where

import Control.Exception (IOException, try)
import Data.Either (fromRight)
import System.Posix.Files (FileStatus, deviceID, fileID, getFileStatus, isRegularFile)
import System.Posix.Types (DeviceID, FileID)

-- | A file, by whatever path.
type Identity = (DeviceID, FileID)

-- | The file that a path leads to, links followed; 'Nothing' where there is none, or none that one may ask about.
identity :: FilePath -> IO (Maybe Identity)
identity path = fmap identityOf <$> statusOf path

-- | Of these paths, the first that leads to the same file as a path does. What is no file with contents of its own, as
-- a terminal, is the same as none.
--
-- Law: where it finds none, writing to the path leaves what is read at the others as it is.
--
-- Spec: cli.render.safe.
sameFile :: FilePath -> [FilePath] -> IO (Maybe FilePath)
sameFile path others =
  statusOf path >>= \case
    Just this | isRegularFile this -> first (Just (identityOf this)) others
    _ -> pure Nothing
  where
    first _ [] = pure Nothing
    first this (other : rest) = do
      that <- identity other
      if that == this then pure (Just other) else first this rest

-- | The file of which this is the status.
identityOf :: FileStatus -> Identity
identityOf this = (deviceID this, fileID this)

-- | The status of what a path leads to, links followed; 'Nothing' where there is nothing, or nothing that one may ask
-- about.
statusOf :: FilePath -> IO (Maybe FileStatus)
statusOf path = fromRight Nothing <$> (try (Just <$> getFileStatus path) :: IO (Either IOException (Maybe FileStatus)))
