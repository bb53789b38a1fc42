-- |
-- Module      : Dioptre.Load.Decoding
-- Description : Files that make a decoder stumble
--
-- The decoders of pictures are not ours. On some broken files they throw an exception instead of complaining, and on
-- some they never come to an end; what throws is damaged, and they may allocate so much memory and no more.
module Dioptre.Load.Decoding
  ( attempted,
  )
where

import Control.Concurrent.Async (waitCatch, withAsync)
import Control.Exception (AllocationLimitExceeded (..), evaluate, fromException)
import Data.ByteString (ByteString)
import Dioptre.Picture (Picture)
import Dioptre.Picture.Header (mostPixelsRead, pixelsOf)
import Dioptre.Source.Diagnostic (PictureFault (..))
import System.Mem (enableAllocationLimit, setAllocationCounter)

-- | What a decoder makes of the bytes of a file, or why it makes nothing of them. A thread of its own does the work,
-- for which memory is counted: 2000 bytes for each pixel that the file says to have, which is more than twice what
-- noise takes in any format (GIF 840, JPEG 710, the others below 170), and 256 MB for small ones.
attempted :: (ByteString -> Either PictureFault Picture) -> ByteString -> IO (Either PictureFault Picture)
attempted decoder bytes = either (Left . complaint) id <$> withAsync work waitCatch
  where
    work = do
      setAllocationCounter (268435456 + 2000 * fromInteger (min mostPixelsRead (pixelsOf bytes)))
      enableAllocationLimit
      evaluate (decoder bytes) >>= traverse evaluate
    complaint e = case fromException e of
      Just AllocationLimitExceeded -> TooMuchMemory
      Nothing -> Damaged
