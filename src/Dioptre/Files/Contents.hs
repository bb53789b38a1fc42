-- |
-- Module      : Dioptre.Files.Contents
-- Description : What a file is to have in it
--
-- A text is there before it is written. A picture comes to be row by row, and may be larger than the memory: what is to
-- be written is then not the bytes, but an action that puts them into the file as they come.
module Dioptre.Files.Contents
  ( Contents,
    contents,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (traverse_)

-- | An action that puts the bytes of a file there, piece by piece, and has a result of its own.
type Contents a = (ByteString -> IO ()) -> IO a

-- | Bytes that are there, or come as they are asked for, as the contents of a file.
contents :: Lazy.ByteString -> Contents ()
contents bytes put = traverse_ put (Lazy.toChunks bytes)
