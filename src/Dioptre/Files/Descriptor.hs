{-# LANGUAGE CPP #-}

-- |
-- Module      : Dioptre.Files.Descriptor
-- Description : Opening files by descriptor
--
-- The three things that need a file descriptor rather than a handle.
--
-- Handles of the base library cannot create a file only if there is none, they lock what they open against the rest
-- of the program, and they cannot tell that @\/dev\/stdout@ is a stream that somebody else is in the middle of.
-- Descriptors can. The package @unix@ changed the type of 'openFd' in its version 2.8; this is the only module that
-- has to know.
--
-- Sources: POSIX.1-2017, @open()@, flags @O_CREAT@ and @O_EXCL@
-- (<https://pubs.opengroup.org/onlinepubs/9699919799/functions/open.html>); Linux @proc(5)@ for @\/proc\/self\/fd@.
module Dioptre.Files.Descriptor
  ( -- * Opening
    createExclusively,
    checkWritable,

    -- * Descriptors that have a path
    namedDescriptor,
  )
where

import Control.Exception (bracket)
import Data.Char (isDigit)
import System.FilePath (normalise, splitFileName)
import System.Posix.IO
  ( OpenFileFlags (..),
    OpenMode (WriteOnly),
    closeFd,
    defaultFileFlags,
    openFd,
  )
import System.Posix.Types (Fd (..))
import Text.Read (readMaybe)

-- | Makes an empty file, with the permissions that a new file has under the process's mask. Throws
-- 'System.IO.Error.isAlreadyExistsError' where anything at all has that name, a dangling link included. Of several
-- processes that try one name, exactly one succeeds.
--
-- Spec: files.number.atomic.
createExclusively :: FilePath -> IO ()
createExclusively path = bracket open closeFd (const (pure ()))
  where
#if MIN_VERSION_unix(2,8,0)
    open = openFd path WriteOnly defaultFileFlags {exclusive = True, creat = Just 0o666}
#else
    open = openFd path WriteOnly (Just 0o666) defaultFileFlags {exclusive = True}
#endif

-- | Throws the exception that writing to this existing file would throw; the file stays as it is.
checkWritable :: FilePath -> IO ()
checkWritable path = bracket open closeFd (const (pure ()))
  where
#if MIN_VERSION_unix(2,8,0)
    open = openFd path WriteOnly defaultFileFlags
#else
    open = openFd path WriteOnly Nothing defaultFileFlags
#endif

-- | The descriptor of this process that a path stands for, if it stands for one to write to.
--
-- >>> namedDescriptor "/dev/stdout"
-- Just 1
-- >>> namedDescriptor "/dev/fd/63"
-- Just 63
-- >>> namedDescriptor "/dev/null"
-- Nothing
namedDescriptor :: FilePath -> Maybe Fd
namedDescriptor path = case splitFileName (normalise path) of
  ("/dev/", "stdout") -> Just 1
  ("/dev/", "stderr") -> Just 2
  ("/dev/fd/", name) -> number name
  ("/proc/self/fd/", name) -> number name
  _ -> Nothing
  where
    number name
      | all isDigit name && length name < 10 = Fd <$> readMaybe name
      | otherwise = Nothing
