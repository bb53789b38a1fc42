-- |
-- Module      : Fuzz.Shrink
-- Description : The part of an input that matters
--
-- Of an input that fails, as much is left out as can be while it still fails: first half of its lines, then a quarter,
-- down to single ones; then the same with bytes. (A. Zeller, R. Hildebrandt, "Simplifying and isolating
-- failure-inducing input", IEEE TSE 28(2), 2002, without the second half of their algorithm.)
module Fuzz.Shrink
  ( shrunk,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars

-- | The input with as much left out as some trials can find, as long as the test says that it is still of interest.
shrunk :: Int -> (ByteString -> IO Bool) -> ByteString -> IO ByteString
shrunk trials stillFails input = do
  (left, byLines) <- without trials (stillFails . Chars.unlines) (Chars.lines input)
  same <- stillFails (Chars.unlines byLines)
  Bytes.pack . snd <$> without left (stillFails . Bytes.pack) (Bytes.unpack (if same then Chars.unlines byLines else input))
  where
    without :: Int -> ([a] -> IO Bool) -> [a] -> IO (Int, [a])
    without budget fails whole = go budget (max 1 (length whole `div` 2)) whole
      where
        go n size list
          | n <= 0 = pure (n, list)
          | otherwise = do
            (n', list') <- sweep n size 0 list
            if size > 1 then go n' (size `div` 2) list' else if length list' < length list then go n' 1 list' else pure (n', list')
        -- Leaves out one stretch after the other, from a place on.
        sweep n size at list
          | n <= 0 || at >= length list = pure (n, list)
          | otherwise = do
            let smaller = take at list <> drop (at + size) list
            failed <- fails smaller
            if failed then sweep (n - 1) size at smaller else sweep (n - 1) size (at + size) list
