-- |
-- Module      : Dioptre.Files.Pieces
-- Description : Reading a file piece by piece
--
-- A model may have many times the bytes that its triangles need, and reading it whole would keep all of them. Here a
-- file goes by in pieces, of which one at a time is in memory.
module Dioptre.Files.Pieces
  ( readPieces,
    pieceSize,
  )
where

import Control.Exception (bracket)
import Control.Monad (join, unless)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Dioptre.Files.Fault (FileFault (..), Reason (NotAPlainFile), orFault)
import GHC.IO.Handle.FD (openFileBlocking)
import System.IO (IOMode (ReadMode), hClose)
import System.Posix.Files (getFileStatus, isDirectory, isRegularFile)

-- | Hands the bytes of a file to an action, piece by piece, in their order; none is empty, and none has more than
-- 'pieceSize' bytes. A fault half way is a fault: what the action did by then is done. Pipes and devices are refused:
-- they might never end.
--
-- Law: the pieces together are what 'Dioptre.Files.Whole.readPlain' reads.
readPieces :: FilePath -> (ByteString -> IO ()) -> IO (Either FileFault ())
readPieces path use = fmap join . orFault path $ do
  status <- getFileStatus path
  if isRegularFile status || isDirectory status
    then Right <$> bracket (openFileBlocking path ReadMode) hClose pieces
    else pure (Left (FileFault path NotAPlainFile))
  where
    pieces handle = do
      piece <- Bytes.hGetSome handle pieceSize
      unless (Bytes.null piece) (use piece >> pieces handle)

-- | 2^18 bytes: many lines, and little memory.
pieceSize :: Int
pieceSize = 262144
