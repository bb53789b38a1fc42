-- | Commands at work in a folder of their own, and what they say.
module Dioptre.Command.Heard
  ( heard,
    listeningTo,
    inFolder,
  )
where

import Control.Concurrent.Async (concurrently)
import Control.Exception (bracket, finally)
import qualified Data.ByteString as Bytes
import Data.Text (Text)
import qualified Data.Text.Encoding as Text
import GHC.IO.Handle (hDuplicate, hDuplicateTo)
import System.Directory (withCurrentDirectory)
import System.IO (Handle, hClose, hFlush, hSetEncoding, openTempFile, stderr, stdout, utf8)
import System.IO.Temp (withSystemTempDirectory)
import System.Process (createPipe)

-- | Works in an empty folder of its own.
inFolder :: IO a -> IO a
inFolder work = withSystemTempDirectory "dioptre" (`withCurrentDirectory` work)

-- | What some work returns, and what it says on standard output and standard error.
heard :: IO a -> IO (a, Text, Text)
heard work = withSystemTempDirectory "heard" $ \folder -> do
  (outPath, outHandle) <- openTempFile folder "out"
  (errPath, errHandle) <- openTempFile folder "err"
  mapM_ (`hSetEncoding` utf8) [outHandle, errHandle]
  result <- diverted stdout outHandle (diverted stderr errHandle work)
  (,,) result <$> (Text.decodeUtf8 <$> Bytes.readFile outPath) <*> (Text.decodeUtf8 <$> Bytes.readFile errPath)

-- | What some work returns, and what somebody hears who listens to its standard output meanwhile.
listeningTo :: IO a -> (Handle -> IO b) -> IO (a, b)
listeningTo work listen = withSystemTempDirectory "heard" $ \folder -> do
  (_, errHandle) <- openTempFile folder "err"
  (out, into) <- createPipe
  mapM_ (`hSetEncoding` utf8) [out, into]
  concurrently (diverted stdout into (diverted stderr errHandle work)) (listen out) `finally` hClose out

-- | Sends what is written to one handle to another, which is closed in the end.
diverted :: Handle -> Handle -> IO a -> IO a
diverted from to work =
  bracket (hFlush from >> hDuplicate from) restore (const (hDuplicateTo to from >> (work `finally` hFlush from))) `finally` hClose to
  where
    restore saved = hDuplicateTo saved from >> hSetEncoding from utf8 >> hClose saved
