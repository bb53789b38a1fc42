-- |
-- Module      : Dioptre.Files.Whole
-- Description : Reading and writing files whole
--
-- A file written here appears whole or not at all: it is written to a temporary beside it, which is then renamed over
-- it, and a rename happens at once. Whoever reads meanwhile sees the old file or the new one; after a full disk or
-- Ctrl-C the old one is untouched. (Nothing is promised about power failures: there is no @fsync@.)
--
-- Four things can stand at the path, and each has its way:
--
-- > a file, or nothing   write beside, rename          -o picture.png
-- > a link               follow it, then as above      -o latest.png   (latest.png -> 2024/a.png)
-- > a device or a pipe   write into it                 -o /dev/null
-- > a descriptor         write on from where it is     -o /dev/stdout
--
-- The last one matters even where the descriptor leads to a file: in @(echo a; dioptre ...; echo b) > file@ neither
-- replacing the file nor opening it anew would leave @a@ and @b@ where they belong.
--
-- Sources: POSIX.1-2017, @rename()@
-- (<https://pubs.opengroup.org/onlinepubs/9699919799/functions/rename.html>).
module Dioptre.Files.Whole
  ( -- * Writing
    writeWhole,
    writingObstacle,

    -- * Reading
    readWhole,
    readPlain,
    mostOfFile,
    mostOfStream,
  )
where

import Control.Concurrent (forkIO)
import Control.Concurrent.MVar (newEmptyMVar, putMVar, takeMVar)
import Control.Exception (IOException, bracket, throwIO, try, tryJust)
import Control.Monad (guard, join, void)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (traverse_)
import Dioptre.Files.Contents (Contents, contents)
import Dioptre.Files.Descriptor (checkWritable, namedDescriptor)
import Dioptre.Files.Fault (FileFault (..), Reason (LongerThan, NotAPlainFile), orFault)
import Dioptre.Files.Temporary (withTemporary)
import Foreign.C.Error (Errno, eISDIR, eLOOP, errnoToIOError)
import GHC.IO.Handle.FD (openFileBlocking)
import System.FilePath (takeDirectory, (</>))
import System.IO (BufferMode (NoBuffering), Handle, IOMode (ReadMode, WriteMode), hClose, hFlush, hSetBuffering, stdout)
import System.IO.Error (isDoesNotExistError)
import System.Posix.Files
  ( FileStatus,
    fileMode,
    getFileStatus,
    getSymbolicLinkStatus,
    isDirectory,
    isRegularFile,
    isSymbolicLink,
    readSymbolicLink,
    rename,
  )
import System.Posix.IO (dup, fdToHandle)
import System.Posix.Types (Fd, FileMode)

-- | Writes a file: whole, or not at all. The result is that of its contents.
--
-- A file that was there is replaced and its permissions are kept; its owner becomes who writes, and other hard links
-- to it keep the old contents. One that may not be written is not replaced, even where its folder would allow that. A
-- new file has the permissions of any new file. On failure everything is as before, and no temporary stays. Devices
-- and pipes get the bytes as they come.
--
-- Law: what is written is what 'readWhole' reads.
--
-- Spec: files.whole.
writeWhole :: FilePath -> Contents a -> IO (Either FileFault a)
writeWhole path write =
  orFault path $ do
    there <- destination path
    case there of
      Descriptor descriptor -> do
        hFlush stdout
        writeTo (dup descriptor >>= fdToHandle)
      Device device -> writeTo (opened device WriteMode)
      Folder -> refuse eISDIR path
      File target mode -> do
        traverse_ (const (checkWritable target)) mode
        fst <$> withTemporary (takeDirectory target) mode write (`rename` target)
  where
    -- Nothing is kept back: where a pipe takes no more, closing would wait for it again.
    writeTo open = bracket open hClose $ \handle -> do
      hSetBuffering handle NoBuffering
      write (Bytes.hPut handle)

-- | What would prevent 'writeWhole' from writing a file, as far as can be known before there is anything to write: the
-- folder is not there or takes no new file, or the file may not be written. Everything stays as it is.
writingObstacle :: FilePath -> IO (Maybe FileFault)
writingObstacle path =
  fmap (either Just (const Nothing)) . orFault path $ do
    there <- destination path
    case there of
      Descriptor _ -> pure ()
      Device _ -> pure ()
      Folder -> refuse eISDIR path
      File target mode -> do
        traverse_ (const (checkWritable target)) mode
        void (withTemporary (takeDirectory target) mode (contents Lazy.empty) (const (pure ())))

-- | Reads a file to its end, at once: the file is closed when this returns. A folder is
-- 'Dioptre.Files.Fault.IsAFolder'. A named pipe is waited for, and what comes from a pipe or a device, whose end nobody
-- knows before, is read up to 'mostOfStream'; a file, up to 'mostOfFile'. What is longer is
-- 'Dioptre.Files.Fault.LongerThan' that.
readWhole :: FilePath -> IO (Either FileFault ByteString)
readWhole path = readThat path $ \status -> Right (if isRegularFile status then mostOfFile else mostOfStream)

-- | The same for a file that is named in another, where pipes and devices are refused: nobody can mean them there, and
-- they might never end, or never begin.
readPlain :: FilePath -> IO (Either FileFault ByteString)
readPlain path = readThat path $ \status ->
  if isRegularFile status || isDirectory status then Right mostOfFile else Left (FileFault path NotAPlainFile)

-- | Reads what is at a path up to the number of bytes that its status allows.
readThat :: FilePath -> (FileStatus -> Either FileFault Int) -> IO (Either FileFault ByteString)
readThat path allowed =
  fmap join . orFault path $
    getFileStatus path >>= either (pure . Left) upTo . allowed
  where
    upTo most = bracket (opened path ReadMode) hClose (pieces most 0 [])
    pieces most size before handle = do
      piece <- Bytes.hGetSome handle 262144
      let size' = size + Bytes.length piece
      case () of
        _
          | Bytes.null piece -> pure (Right (Bytes.concat (reverse before)))
          | size' > most -> pure (Left (FileFault path (LongerThan most)))
          | otherwise -> pieces most size' (piece : before) handle

-- | Opens a file. A named pipe makes wait until somebody opens its other end. No exception reaches a thread while the
-- operating system keeps it waiting there, so that it is another one that waits: a signal ends the waiting.
opened :: FilePath -> IOMode -> IO Handle
opened path mode = do
  answer <- newEmptyMVar
  void (forkIO (try (openFileBlocking path mode) >>= putMVar answer))
  takeMVar answer >>= either (throwIO :: IOException -> IO a) pure

-- | The most bytes that are read of a file, 2^30: more than any picture, model or scene that can be used.
--
-- Spec: limits.files.
mostOfFile :: Int
mostOfFile = 1073741824

-- | The most bytes that are read from a pipe or a device, 2^28.
--
-- Spec: limits.files.
mostOfStream :: Int
mostOfStream = 268435456

-- | What stands at a path, symbolic links followed.
data Destination
  = -- | One of this process's own open descriptors.
    Descriptor Fd
  | -- | Anything that is neither file nor folder: there is nothing to replace.
    Device FilePath
  | Folder
  | -- | A file to replace, with its permissions, or the place for a new one.
    File FilePath (Maybe FileMode)

-- | Follows the links that a path ends in, a dangling one too: writing through it makes the file that it points to.
-- Folders on the way are the operating system's business.
destination :: FilePath -> IO Destination
destination = follow (40 :: Int)
  where
    follow hops path
      | Just descriptor <- namedDescriptor path = pure (Descriptor descriptor)
      | otherwise = do
        found <- tryJust (guard . isDoesNotExistError) (getSymbolicLinkStatus path)
        case found of
          Left () -> pure (File path Nothing)
          Right status
            | isSymbolicLink status ->
              if hops <= 0
                then refuse eLOOP path
                else do
                  target <- readSymbolicLink path
                  follow (hops - 1) (takeDirectory path </> target)
            | isDirectory status -> pure Folder
            | isRegularFile status -> pure (File path (Just (fileMode status)))
            | otherwise -> pure (Device path)

-- | Fails the way the operating system does.
refuse :: Errno -> FilePath -> IO a
refuse number path = ioError (errnoToIOError "write" number Nothing (Just path))
