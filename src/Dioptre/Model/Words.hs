{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Model.Words
-- Description : The words of a line as places, and the bytes that separate them
--
-- A line of a model is words with blanks between them. To go through a hundred megabytes of them, nothing is cut out: a
-- word is where it begins and where it ends.
--
-- > v -1.5 2      wordFrom 2 = 6, blanksFrom 6 = 7
-- > 01234567
module Dioptre.Model.Words
  ( -- * Places
    blanksFrom,
    wordFrom,

    -- * Bytes
    byteAt,
    isBlank,
    isDigit,
    digit,
    plus,
    minus,
    point,
    slash,
    hash,
    backslash,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Internal (accursedUnutterablePerformIO, toForeignPtr)
import Data.Word (Word8)
import Foreign.Storable (peekByteOff)
import GHC.ForeignPtr (unsafeWithForeignPtr)

-- | The next place of a line, from this one on, that is not blank; its length where there is none.
blanksFrom :: ByteString -> Int -> Int
blanksFrom line = go
  where
    go !i
      | i < Bytes.length line, isBlank (byteAt line i) = go (i + 1)
      | otherwise = i
{-# INLINE blanksFrom #-}

-- | The next place of a line, from this one on, that is blank; its length where there is none.
wordFrom :: ByteString -> Int -> Int
wordFrom line = go
  where
    go !i
      | i < Bytes.length line, not (isBlank (byteAt line i)) = go (i + 1)
      | otherwise = i

-- | The byte at a place of a line. It is not looked whether the place is in the line, from 0 to below its length: the
-- caller has done so. See Note [Bytes without boxes].
byteAt :: ByteString -> Int -> Word8
byteAt line i = case toForeignPtr line of
  (bytes, offset, _) -> accursedUnutterablePerformIO (unsafeWithForeignPtr bytes (\p -> peekByteOff p (offset + i)))
{-# INLINE byteAt #-}

-- | Whether a byte separates words: space, tab, vertical tab, form feed, and the line ends, as @isBlankInObj@ of
-- "Dioptre.Source.Words" has it for characters.
isBlank :: Word8 -> Bool
isBlank c = c == 32 || c - 9 < 5
{-# INLINE isBlank #-}

-- | Whether a byte is a decimal digit.
isDigit :: Word8 -> Bool
isDigit c = c - 48 <= 9
{-# INLINE isDigit #-}

-- | What a decimal digit is worth.
digit :: Word8 -> Int
digit c = fromIntegral (c - 48)
{-# INLINE digit #-}

-- | What stands before a number.
plus, minus :: Word8
plus = 43
minus = 45

-- | What stands between a number's digits.
point :: Word8
point = 46

-- | What stands between the parts of a corner.
slash :: Word8
slash = 47

-- | What begins a comment.
hash :: Word8
hash = 35

-- | What ends a line that goes on in the next one.
backslash :: Word8
backslash = 92

-- Note [Bytes without boxes]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~
-- 'Data.ByteString.Unsafe.unsafeIndex' as compiled by GHC 9.0 keeps the string alive around the reading of a byte with
-- a primitive that the optimiser does not see through: each byte costs a closure and a box, 40 bytes, and half the time
-- of reading a model. Here the string is touched after the byte has been read, which is enough where reading cannot
-- fail to return. Reading a byte of a string, which never changes, has no effect that anyone could see, so that it may
-- be called a function.
