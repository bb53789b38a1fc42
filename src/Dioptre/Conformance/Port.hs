{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.Conformance.Port
-- Description : A program under test, as a child process
--
-- >   say   ----->  standard input            written by one thread
-- >   hear  <-----  standard output           read by another
-- >   ending  <---  standard error            read by a third
--
-- The port is the head of a process group of its own, which is killed whole, so that nothing that it started stays
-- behind.
module Dioptre.Conformance.Port
  ( Port,
    withPort,
    say,
    close,
    hear,
    ending,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (Async, waitCatch, withAsync)
import Control.Concurrent.Chan (Chan, newChan, readChan, writeChan)
import Control.Concurrent.MVar (MVar, newEmptyMVar, putMVar, takeMVar)
import Control.Exception (IOException, bracket, handle)
import Control.Monad (unless, void)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (traverse_)
import Data.IORef (IORef, modifyIORef', newIORef, readIORef)
import Data.Text (Text)
import qualified Data.Text.Encoding as Text
import Data.Text.Encoding.Error (lenientDecode)
import Dioptre.Conformance.Lines (Line (..), Lines, linesOf, nextLine)
import Dioptre.Files.Fault (FileFault, orFault, quietly)
import System.Exit (ExitCode (..))
import System.IO (BufferMode (NoBuffering), Handle, hClose, hSetBinaryMode, hSetBuffering)
import System.Posix.Signals (sigKILL, signalProcessGroup)
import System.Process (CreateProcess (..), Pid, ProcessHandle, StdStream (UseHandle), createPipe, createProcess, getPid, getProcessExitCode, proc, waitForProcess)
import System.Timeout (timeout)

-- | A running port.
data Port = Port
  { child :: ProcessHandle,
    group :: Maybe Pid,
    -- | What is still to be written to it; 'Nothing' for the end of its input.
    requests :: Chan (Maybe Lazy.ByteString),
    -- | The line that it said last. It waits there until it is heard.
    answers :: MVar Line,
    -- | The end of what it said on standard error.
    lastWords :: IORef ByteString,
    listener :: Async ()
  }

-- | Does something with a program that was started with these arguments, and of whose lines none is kept that is longer
-- than so many bytes. In the end the program is killed, with all that it started. A fault, if it cannot be started.
withPort :: Int -> FilePath -> [String] -> (Port -> IO a) -> IO (Either FileFault a)
withPort longest command arguments work =
  bracket (orFault command start) (traverse_ stop) $ \case
    Left fault -> pure (Left fault)
    Right (input, output, errors, process, pid) -> do
      requests' <- newChan
      answers' <- newEmptyMVar
      said <- newIORef Bytes.empty
      source <- linesOf output
      withAsync (quietly (write input requests')) $ \_ ->
        withAsync (readAll longest source answers') $ \_ ->
          withAsync (quietly (listen errors said)) $ \listening ->
            Right <$> work (Port process pid requests' answers' said listening)
  where
    start = do
      (theirInput, input) <- createPipe
      (output, theirOutput) <- createPipe
      (errors, theirErrors) <- createPipe
      (_, _, _, process) <-
        createProcess
          (proc command arguments)
            { std_in = UseHandle theirInput,
              std_out = UseHandle theirOutput,
              std_err = UseHandle theirErrors,
              create_group = True,
              close_fds = True
            }
      mapM_ (`hSetBinaryMode` True) [input, output, errors]
      hSetBuffering input NoBuffering
      pid <- getPid process
      pure (input, output, errors, process, pid)
    stop (input, output, errors, process, pid) = do
      kill pid
      void (waitForProcess process)
      mapM_ (quietly . hClose) [input, output, errors]

-- | Kills a process group, if it is still there.
kill :: Maybe Pid -> IO ()
kill = traverse_ (quietly . signalProcessGroup sigKILL)

write :: Handle -> Chan (Maybe Lazy.ByteString) -> IO ()
write input queue =
  readChan queue >>= \case
    Just bytes -> Bytes.hPut input (Lazy.toStrict bytes) >> write input queue
    Nothing -> hClose input

readAll :: Int -> Lines -> MVar Line -> IO ()
readAll longest source heard = do
  line <- handle broken (nextLine longest source)
  putMVar heard line
  unless (line == NoMore) (readAll longest source heard)
  where
    broken :: IOException -> IO Line
    broken _ = pure NoMore

listen :: Handle -> IORef ByteString -> IO ()
listen errors said = do
  bytes <- Bytes.hGetSome errors 65536
  unless (Bytes.null bytes) $ do
    modifyIORef' said (\before -> let whole = before <> bytes in Bytes.copy (Bytes.drop (Bytes.length whole - 1000) whole))
    listen errors said

-- | Sends a line, without waiting until it has been read.
say :: Port -> Lazy.ByteString -> IO ()
say port line = writeChan (requests port) (Just (line <> Lazy.singleton 10))

-- | Ends the port's input.
close :: Port -> IO ()
close port = writeChan (requests port) Nothing

-- | The next line that the port says within so many seconds.
hear :: Port -> Double -> IO (Maybe Line)
hear port seconds = timeout (ceiling (max 0 seconds * 1e6)) (takeMVar (answers port))

-- | How a port ended that has closed its output: the exit code, or the negative number of the signal, and the last
-- thousand bytes that it said on standard error. It is given a second, and then killed.
ending :: Port -> IO (Int, Text)
ending port = do
  code <- waitUpTo (100 :: Int)
  void (timeout 200000 (waitCatch (listener port)))
  words' <- readIORef (lastWords port)
  pure (number code, Text.decodeUtf8With lenientDecode words')
  where
    waitUpTo n =
      getProcessExitCode (child port) >>= \case
        Just code -> pure code
        Nothing
          | n > 0 -> threadDelay 10000 >> waitUpTo (n - 1)
          | otherwise -> kill (group port) >> waitForProcess (child port)
    number code = case code of
      ExitSuccess -> 0
      ExitFailure n -> n
