{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Picture.Header
-- Description : How large a file says that its picture is
--
-- A file of a hundred bytes may say that it is a picture of four thousand million pixels, and a decoder that believes
-- it takes all memory before it finds out. So it is looked up first what the file says, and a picture is refused that
-- is too large to be kept, or larger than its bytes can describe.
--
-- > format   begins with    says its size
-- > PNG      89 "PNG"       width and height, 4 bytes each, the high one first, from byte 16 on
-- > GIF      "GIF8"         in the descriptor of each image: 2 bytes each, the low one first
-- > BMP      "BM"           from byte 18 on: 4 bytes each (in the oldest kind 2), the low one first; a negative height runs down
-- > JPEG     FF D8          in the header of each frame: height, then width, 2 bytes each, the high one first
-- > TGA      anything else  from byte 12 on: 2 bytes each, the low one first
--
-- Sources: ISO\/IEC 15948 (PNG), 11.2.2; CompuServe's GIF89a specification, 20; ITU-T T.81 (JPEG), B.1 and B.2.2;
-- Truevision's TGA specification 2.0.
module Dioptre.Picture.Header
  ( Format (..),
    formatOf,
    pixelsOf,
    mostPixelsRead,
    isTooLarge,
    mayBeTga,
    isSurelyPicture,

    -- * Numbers in files
    big,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes

-- | The formats that are read.
data Format = Png | Gif | Bmp | Jpeg | Tga
  deriving stock (Eq, Show, Enum, Bounded)

-- | The format of a file by its first bytes. TGA has none of its own.
--
-- >>> map formatOf ["GIF89a", "\xFF\xD8\xFF", "abc"]
-- [Gif,Jpeg,Tga]
formatOf :: ByteString -> Format
formatOf bytes
  | "\x89PNG" `Bytes.isPrefixOf` bytes = Png
  | "GIF8" `Bytes.isPrefixOf` bytes = Gif
  | "BM" `Bytes.isPrefixOf` bytes = Bmp
  | "\xFF\xD8" `Bytes.isPrefixOf` bytes = Jpeg
  | otherwise = Tga

-- | How many pixels the largest picture in a file has, by what the file says; 0 where it does not say. Total, linear.
pixelsOf :: ByteString -> Integer
pixelsOf bytes = case formatOf bytes of
  Png -> big 4 16 bytes * big 4 20 bytes
  Gif -> largest [little 2 4 image * little 2 6 image | image <- gifImages bytes]
  Bmp
    | little 4 14 bytes == 12 -> little 2 18 bytes * little 2 20 bytes
    | otherwise -> abs (signed (little 4 18 bytes)) * abs (signed (little 4 22 bytes))
  Jpeg -> largest [big 2 3 frame * big 2 5 frame | frame <- jpegFrames bytes]
  Tga -> little 2 12 bytes * little 2 14 bytes
  where
    largest = foldr max 0
    signed n = if n >= 2147483648 then n - 4294967296 else n

-- | No picture that is read has more pixels: 2^26, as 8192 x 8192 has.
mostPixelsRead :: Integer
mostPixelsRead = 67108864

-- | Whether a file says that it has more pixels than 'mostPixelsRead', or than 10,000 for each of its bytes: PNG comes
-- to 8256 (1032 bytes out of one, as Deflate does at most, and 8 pixels each), the others to fewer.
isTooLarge :: ByteString -> Bool
isTooLarge bytes = pixelsOf bytes > min mostPixelsRead (10000 * toInteger (Bytes.length bytes))

-- | Whether the head of a file can be that of a TGA: with or without a palette, of one of the kinds that have pixels,
-- of a depth that there is. No text is like that, as its bytes are larger.
--
-- >>> map mayBeTga ["\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\24\0", "a text and no picture"]
-- [True,False]
mayBeTga :: ByteString -> Bool
mayBeTga bytes = Bytes.length bytes >= 18 && big 1 1 bytes <= 1 && big 1 2 bytes `elem` [1, 2, 3, 9, 10, 11] && big 1 16 bytes `elem` [8, 15, 16, 24, 32]

-- | Whether a file is a picture, and no text, by its first bytes. Those of GIF and BMP are letters, with which a text may
-- begin as well; but there are small numbers of two and four bytes behind them, and so NUL, which no text has.
--
-- >>> map isSurelyPicture ["\x89PNG\r\n", "\xFF\xD8\xFF", "GIF89a\1\0\1\0", "BM5 is my camera", "a text"]
-- [True,True,True,False,False]
--
-- Spec: files.picture.
isSurelyPicture :: ByteString -> Bool
isSurelyPicture bytes = case formatOf bytes of
  Png -> True
  Jpeg -> True
  Gif -> numbered
  Bmp -> numbered
  Tga -> False
  where
    numbered = Bytes.elem 0 (Bytes.take 26 bytes)

-- | The whole number of so many bytes at a place, the high byte first; what is not there is 0.
big :: Int -> Int -> ByteString -> Integer
big count at = Bytes.foldl' (\n b -> 256 * n + toInteger b) 0 . Bytes.take count . Bytes.drop at

-- | The same with the low byte first.
little :: Int -> Int -> ByteString -> Integer
little count at = Bytes.foldr' (\b n -> 256 * n + toInteger b) 0 . Bytes.take count . Bytes.drop at

-- | The images of a GIF, each from its descriptor's sign on without it.
gifImages :: ByteString -> [ByteString]
gifImages bytes = blocks (Bytes.drop (13 + colours (byte 10 bytes)) bytes)
  where
    blocks b = case Bytes.uncons b of
      Just (0x2C, image) -> image : blocks (afterParts (Bytes.drop (10 + colours (byte 8 image)) image))
      Just (0x21, extension) -> blocks (afterParts (Bytes.drop 1 extension))
      _ -> []
    -- A table of 2 to 256 colours, of three bytes each, if the highest bit says that there is one.
    colours flags = if flags >= 128 then 3 * 2 ^ (flags `mod` 8 + 1) else 0
    -- Parts of so many bytes as their first byte says, up to an empty one.
    afterParts b = case Bytes.uncons b of
      Just (0, rest) -> rest
      Just (n, rest) -> afterParts (Bytes.drop (fromIntegral n) rest)
      Nothing -> b
    byte i = fromInteger . big 1 i :: ByteString -> Int

-- | The frame headers of a JPEG, each from its length on.
jpegFrames :: ByteString -> [ByteString]
jpegFrames bytes = case Bytes.uncons (Bytes.drop 1 (Bytes.dropWhile (/= 0xFF) bytes)) of
  Nothing -> []
  Just (marker, rest)
    | isFrame marker -> rest : beyond
    -- Filling, a stuffed byte, and what stands alone.
    | marker == 0xFF -> jpegFrames (Bytes.cons 0xFF rest)
    | marker <= 1 || (marker >= 0xD0 && marker <= 0xD9) -> jpegFrames rest
    | otherwise -> beyond
    where
      beyond = jpegFrames (Bytes.drop (fromInteger (big 2 0 rest)) rest)
  where
    isFrame m = m >= 0xC0 && m <= 0xCF && m `notElem` [0xC4, 0xC8, 0xCC]
