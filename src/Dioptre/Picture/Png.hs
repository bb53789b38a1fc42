{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Picture.Png
-- Description : Pictures as files
--
-- The only module that knows JuicyPixels.
module Dioptre.Picture.Png
  ( encode,
    encodeRows,
    decode,
    decodeTexture,
  )
where

import Codec.Compression.Zlib.Internal (CompressStream (..), compressIO, defaultCompressParams, zlibFormat)
import Codec.Picture (DynamicImage, Image (..), PixelRGBA8, convertRGBA8, decodeBitmap, decodeGif, decodeJpeg, decodePng, encodePng)
import Codec.Picture.Png.Internal.Type (PngIHdr (PngIHdr), PngImageType (..), PngInterlaceMethod (..), PngRawImage (PngRawImage), iDATSignature, iENDSignature, mkRawChunk)
import Codec.Picture.Tga (decodeTga)
import qualified Data.Binary as Binary
import Data.Bits (testBit)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Internal (fromForeignPtr)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.IORef (newIORef, readIORef, writeIORef)
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)
import Dioptre.Picture (Picture, picture, pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Picture.Header (Format (..), formatOf, isTooLarge, mayBeTga, pixelsOf)
import Dioptre.Picture.Vetting (vetted)
import Dioptre.Source.Diagnostic (PictureFault (..))
import System.FilePath (takeExtension)

-- | A picture as a PNG file: 8 bits a channel, with alpha.
--
-- Law: decoding it gives the picture.
--
-- Spec: picture.png.
encode :: Picture -> Lazy.ByteString
encode p = encodePng (Image (pictureWidth p) (pictureHeight p) (pictureBytes p) :: Image PixelRGBA8)

-- | The same file for a picture of that width and height that is never whole in memory: its rows are handed over one by
-- one, from the top, and the file's bytes go on from there, as they come to be. Given the width and the height, what
-- hands over the rows (as many as there are, four bytes for each of its pixels), and what takes the bytes.
--
-- Law: decoding it gives the picture of the rows.
--
-- Cost: 256 kB and a row of memory, and no more bytes at once than zlib gives.
--
-- Spec: picture.png.
encodeRows :: Int -> Int -> ((Storable.Vector Word8 -> IO ()) -> IO a) -> (ByteString -> IO ()) -> IO a
encodeRows w h rows put = do
  put (Lazy.toStrict (Binary.encode (PngRawImage size [])))
  deflating <- newIORef (compressIO zlibFormat defaultCompressParams)
  let feed bytes = readIORef deflating >>= supplied bytes >>= writeIORef deflating
  -- A byte 0 before a row says that it is not filtered.
  result <- rows (\row -> feed (Bytes.singleton 0) >> feed (rowOf row))
  readIORef deflating >>= finished
  put (chunk iENDSignature Bytes.empty)
  pure result
  where
    rowOf row = let (pointer, n) = Storable.unsafeToForeignPtr0 row in fromForeignPtr pointer 0 n
    size = PngIHdr (fromIntegral w) (fromIntegral h) 8 PngTrueColourWithAlpha 0 0 PngNoInterlace
    chunk signature bytes = Lazy.toStrict (Binary.encode (mkRawChunk signature (Lazy.fromStrict bytes)))
    -- zlib asks for bytes, says what it has made of them, and asks again. No bytes mean the end; even then it may ask
    -- more than once.
    supplied bytes stream = case stream of
      CompressInputRequired supply -> supply bytes >>= drained
      _ -> drained stream
    drained stream = case stream of
      CompressOutputAvailable bytes more -> put (chunk iDATSignature bytes) >> more >>= drained
      _ -> pure stream
    finished stream = case stream of
      CompressStreamEnd -> pure ()
      _ -> supplied Bytes.empty stream >>= finished

-- | The picture in a file of any of the formats of "Dioptre.Picture.Header", or why there is none.
--
-- Spec: picture.png.
decode :: ByteString -> Either PictureFault Picture
decode bytes = decodeWith decoder bytes
  where
    decoder = case formatOf bytes of
      Png -> decodePng
      Gif -> decodeGif
      Bmp -> decodeBitmap
      Jpeg -> decodeJpeg
      Tga -> decodeTga

-- | What a decoder makes of a file that is not too large for it.
decodeWith :: (ByteString -> Either String DynamicImage) -> ByteString -> Either PictureFault Picture
decodeWith decoder bytes
  | isTooLarge bytes = Left (unlessForeign (ClaimsPixels (pixelsOf bytes)))
  | otherwise = do
    sound <- vetted bytes
    either (const (Left (unlessForeign Damaged))) fromDynamic (decoder sound)
  where
    -- Whatever has no sign of its own is read as TGA; what cannot be that is no picture at all.
    unlessForeign fault = if formatOf bytes == Tga && not (mayBeTga bytes) then NoPicture else fault

fromDynamic :: DynamicImage -> Either PictureFault Picture
fromDynamic dynamic
  | w < 1 || h < 1 = Left NoImage
  | otherwise = Right (picture w pixels)
  where
    Image w h pixels = convertRGBA8 dynamic

-- | The picture in a file of that name, as textures want it: row 0 is at the top, except in a TGA file, whose rows stay
-- in the order in which it stores them. JuicyPixels turns the rows of a TGA that are stored from the bottom up (bit 5
-- of byte 17 is 0), so they are turned back.
--
-- Spec: models.texture.formats, models.texture.rows.
decodeTexture :: FilePath -> ByteString -> Either PictureFault Picture
decodeTexture path bytes
  | map toLower (takeExtension path) /= ".tga" = decode bytes
  | isCutOff = Left (if mayBeTga bytes then CutOff else NoPicture)
  | otherwise = storedOrder <$> decodeWith decodeTga bytes
  where
    storedOrder p
      | Bytes.length bytes > 17 && not (testBit (Bytes.index bytes 17) 5) = turned p
      | otherwise = p
    -- JuicyPixels fills up what is missing with black. What has no run lengths (kinds 1 to 3) has a known size: header,
    -- name, palette, pixels.
    isCutOff = Bytes.length bytes < 18 || (byte 2 <= 3 && Bytes.length bytes < 18 + byte 0 + word 5 * ((byte 7 + 7) `div` 8) + word 12 * word 14 * ((byte 16 + 7) `div` 8))
    byte i = fromIntegral (Bytes.index bytes i) :: Int
    word i = byte i + 256 * byte (i + 1)
    turned p =
      let row y = Storable.slice (4 * pictureWidth p * y) (4 * pictureWidth p) (pictureBytes p)
       in picture (pictureWidth p) (Storable.concat (map row [pictureHeight p - 1, pictureHeight p - 2 .. 0]))
