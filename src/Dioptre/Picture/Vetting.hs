{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Picture.Vetting
-- Description : What a decoder can be given
--
-- JuicyPixels reads and writes some memory without looking whether it is its own: where a PNG has fewer pixels than its
-- header says, where a pixel names a colour beyond its palette, where the codes of a GIF have more bits than GIF knows.
-- A file of that kind ends the program at once, or spoils its memory. So the few things that the decoder relies on are
-- looked up before it is asked:
--
-- * a PNG has a depth that its kind of colours may have, and as many bytes, once they are inflated, as its rows take;
-- * a palette has a colour for every number that a pixel can hold: what is missing is black;
-- * the codes of a GIF begin with 1 to 8 bits.
--
-- > PNG   signature  IHDR  [PLTE]  IDAT ... IDAT  IEND       each: length, name, contents, CRC
-- > GIF   header  colours  { image: descriptor  colours  bits  codes }  trailer
--
-- Sources: ISO\/IEC 15948 (PNG), 5.3, 8.1, 11.2; CompuServe's GIF89a specification, 18 to 22 and appendix F.
module Dioptre.Picture.Vetting
  ( vetted,
  )
where

import qualified Codec.Compression.Zlib.Internal as Zlib
import Data.Bits (shiftR, testBit, xor, (.&.), (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Word (Word32, Word8)
import Dioptre.Picture.Header (Format (..), big, formatOf)
import Dioptre.Source.Diagnostic (PictureFault (..))

-- | The file as its decoder can be given it, or why it cannot. Files of the other formats stay as they are. Linear in
-- the size of the file and in that of its picture.
vetted :: ByteString -> Either PictureFault ByteString
vetted bytes = case formatOf bytes of
  Png -> png bytes
  Gif -> gif bytes
  _ -> Right bytes

-------------------------------------------------------------------------------
-- PNG

-- | A chunk: its name and contents.
data Chunk = Chunk ByteString ByteString

-- | The chunks of a PNG, those that are whole.
chunks :: ByteString -> [Chunk]
chunks bytes
  | Bytes.length contents < size || Bytes.length bytes < 12 = []
  | otherwise = Chunk (Bytes.take 4 (Bytes.drop 4 bytes)) contents : chunks (Bytes.drop (12 + size) bytes)
  where
    size = fromInteger (big 4 0 bytes)
    contents = Bytes.take size (Bytes.drop 8 bytes)

png :: ByteString -> Either PictureFault ByteString
png bytes = case chunks (Bytes.drop 8 bytes) of
  Chunk "IHDR" header : rest
    | [depth, kind, 0, 0, interlaced] <- map toInteger (Bytes.unpack (Bytes.drop 8 header)),
      Just samples <- lookup kind samplesOf,
      depth `elem` depthsOf kind ->
      let wanted = rawSize (interlaced /= 0) (samples * depth) (big 4 0 header) (big 4 4 header)
          whole = Lazy.fromChunks [c | Chunk "IDAT" c <- rest]
       in if reaches wanted (inflatedPieces whole)
            then Right (Bytes.take 8 bytes <> Bytes.concat (map (written . padded kind depth) (Chunk "IHDR" header : rest)))
            else Left FewerPixels
  _ -> Left NoHeader
  where
    -- By the kind of colours: the numbers that each pixel has, and the bits that each of them may have.
    samplesOf = [(0, 1), (2, 3), (3, 1), (4, 2), (6, 4)] :: [(Integer, Integer)]
    depthsOf kind = case kind of
      0 -> [1, 2, 4, 8, 16]
      3 -> [1, 2, 4, 8]
      _ -> [8, 16]
    padded kind depth chunk = case chunk of
      Chunk "PLTE" colours | kind == 3 -> Chunk "PLTE" (blackFrom (2 ^ depth) colours)
      _ -> chunk
    reaches wanted pieces =
      wanted <= 0 || case pieces of
        [] -> False
        n : more -> reaches (wanted - n) more

-- | How many bytes the rows of so many bits a pixel take, with the byte that each row begins with; in the seven passes
-- of Adam7, or in one.
rawSize :: Bool -> Integer -> Integer -> Integer -> Integer
rawSize interlaced bits w h
  | interlaced = sum [pass ((w + dx - x - 1) `div` dx) ((h + dy - y - 1) `div` dy) | (x, y, dx, dy) <- adam7]
  | otherwise = pass w h
  where
    pass pw ph = if pw <= 0 || ph <= 0 then 0 else ph * (1 + (pw * bits + 7) `div` 8)
    adam7 = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]

-- | The sizes of the pieces that come out of compressed bytes, up to where they break off.
inflatedPieces :: Lazy.ByteString -> [Integer]
inflatedPieces =
  Zlib.foldDecompressStreamWithInput (\piece more -> toInteger (Bytes.length piece) : more) (const []) (const []) (Zlib.decompressST Zlib.zlibFormat Zlib.defaultDecompressParams)

-- | A palette of so many colours, of three bytes each.
blackFrom :: Int -> ByteString -> ByteString
blackFrom count colours = Bytes.take (3 * count) (colours <> Bytes.replicate (max 0 (3 * count - Bytes.length colours)) 0)

-- | A chunk with its length and its CRC.
written :: Chunk -> ByteString
written (Chunk name contents) = Bytes.concat [word (fromIntegral (Bytes.length contents)), name, contents, word (crc (name <> contents))]
  where
    word :: Word32 -> ByteString
    word n = Bytes.pack [fromIntegral (n `shiftR` k) | k <- [24, 16, 8, 0]]

-- | The check of a chunk (ISO\/IEC 15948, annex D), bit by bit.
crc :: ByteString -> Word32
crc = xor 0xFFFFFFFF . Bytes.foldl' (\c b -> step 8 (c `xor` fromIntegral b)) 0xFFFFFFFF
  where
    step :: Int -> Word32 -> Word32
    step 0 c = c
    step n c = step (n - 1) (if testBit c 0 then (c `shiftR` 1) `xor` 0xEDB88320 else c `shiftR` 1)

-------------------------------------------------------------------------------
-- GIF

-- | The header and the first image, with full palettes.
gif :: ByteString -> Either PictureFault ByteString
gif bytes
  | Bytes.length bytes < 13 = Left CutOff
  | otherwise = (\image -> Bytes.concat [withTable 10 (Bytes.take 13 bytes), global, image]) <$> blocks afterTable
  where
    (global, afterTable) = table (byteAt 10 bytes) (Bytes.drop 13 bytes)
    blocks b = case Bytes.uncons b of
      Just (0x21, extension) -> let size = partsSize (Bytes.drop 1 extension) in (Bytes.take (2 + size) b <>) <$> blocks (Bytes.drop (2 + size) b)
      Just (0x2C, _)
        | Bytes.length codes < 2 -> Left CutOff
        | byteAt 0 codes < 1 || byteAt 0 codes > 8 -> Left LongCodes
        | otherwise -> Right (Bytes.concat [withTable 9 (Bytes.take 10 b), local, Bytes.take (1 + partsSize (Bytes.drop 1 codes)) codes, Bytes.singleton 0x3B])
        where
          (local, codes) = table (byteAt 9 b) (Bytes.drop 10 b)
      _ -> Left NoImage
    -- The colours that the flags speak of, made 256, and what follows them.
    table flags b
      | testBit flags 7 = let (colours, rest) = Bytes.splitAt (3 * 2 ^ (flags .&. 7 + 1)) b in (blackFrom 256 colours, rest)
      | otherwise = ("", b)
    -- The flags at that place speak of 256 colours, if of any.
    withTable i b = Bytes.take i b <> Bytes.map (\flags -> if testBit flags 7 then flags .|. 7 else flags) (Bytes.take 1 (Bytes.drop i b)) <> Bytes.drop (i + 1) b
    partsSize = go 0
      where
        go n b = case Bytes.uncons b of
          Nothing -> n
          Just (0, _) -> n + 1
          Just (size, rest) -> go (n + 1 + fromIntegral size) (Bytes.drop (fromIntegral size) rest)

-- | The byte at a place, 0 beyond the end.
byteAt :: Int -> ByteString -> Word8
byteAt i = Bytes.foldr const 0 . Bytes.take 1 . Bytes.drop i
