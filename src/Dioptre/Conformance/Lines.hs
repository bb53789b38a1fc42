{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Conformance.Lines
-- Description : Lines of bounded length from a handle
--
-- What @hGetLine@ does for trusted neighbours. Here the other side may send a line without an end: no more of it is
-- kept than is allowed, and the rest is passed over.
module Dioptre.Conformance.Lines
  ( Lines,
    linesOf,
    Line (..),
    nextLine,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Data.IORef (IORef, newIORef, readIORef, writeIORef)
import System.IO (Handle)

-- | A handle, and what has been read from it and not been given yet.
data Lines = Lines Handle (IORef ByteString)

-- | The lines that come from a handle, which nobody else reads.
linesOf :: Handle -> IO Lines
linesOf handle = Lines handle <$> newIORef Bytes.empty

-- | What comes next.
data Line
  = -- | A line, without its line feed. The last one may have had none.
    Line ByteString
  | -- | A line that was longer than allowed.
    TooLong
  | -- | No more lines.
    NoMore
  deriving stock (Eq, Show)

-- | The next line, if it is no longer than that. Waits for it. At most twice that many bytes are kept.
--
-- Spec: protocol.lines.
nextLine :: Int -> Lines -> IO Line
nextLine longest (Lines handle rest) = readIORef rest >>= go 0 []
  where
    go size pieces chunk = case Chars.elemIndex '\n' chunk of
      Just i -> do
        writeIORef rest (Bytes.drop (i + 1) chunk)
        pure (line (size + i) (Bytes.take i chunk : pieces))
      Nothing -> do
        let size' = size + Bytes.length chunk
            kept = if size' > longest then [] else chunk : pieces
        more <- Bytes.hGetSome handle 65536
        if Bytes.null more
          then do
            writeIORef rest Bytes.empty
            pure (if size' == 0 then NoMore else line size' kept)
          else go size' kept more
    line size pieces
      | size > longest = TooLong
      | otherwise = Line (Bytes.concat (reverse pieces))
