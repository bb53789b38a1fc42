{-# LANGUAGE OverloadedStrings #-}

-- | What files say of their size. They are written by hand here, from the specifications of their formats.
module Dioptre.Picture.HeaderSpec (spec) where

import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import Data.Word (Word8)
import Dioptre.Picture.Header
import Test.Hspec

spec :: Spec
spec = do
  describe "pixelsOf" $ do
    it "is what a PNG says in its header" $ pixelsOf png `shouldBe` 3 * 65538
    it "is what a BMP says, old and new, up or down" $
      map pixelsOf [bmp [40, 0, 0, 0] [3, 0, 0, 0] [2, 1, 0, 0], bmp [40, 0, 0, 0] [3, 0, 0, 0] [0xFE, 0xFE, 0xFF, 0xFF], bmp [12, 0, 0, 0] [3, 0] [2, 1]] `shouldBe` replicate 3 (3 * 258)
    it "is what a TGA says" $ pixelsOf (Bytes.pack ([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0] <> [3, 0, 2, 1] <> [24, 0])) `shouldBe` 3 * 258
    it "is that of the largest image in a GIF, behind palettes and extensions" $
      pixelsOf ("GIF89a" <> Bytes.pack ([9, 0, 9, 0, 0x80, 0, 0] <> replicate 6 7 <> extension <> image 2 1 <> image 3 2 <> [0x3B])) `shouldBe` 6
    it "is that of the largest frame of a JPEG, behind other segments, and not what stands in one" $
      pixelsOf (Bytes.pack ([0xFF, 0xD8, 0xFF, 0xE0, 0, 11] <> frame 0xC0 9 9 <> frame 0xC2 2 259 <> [0xFF, 0xDA, 0, 2, 1, 0xFF, 0, 0xC0, 0xFF, 0xD9])) `shouldBe` 2 * 259
    it "is nothing where a file breaks off" $
      forM_ ["", "\x89PNG", "GIF89a", "BM", "\xFF\xD8", "\xFF\xD8\xFF\xC0"] $ \bytes -> pixelsOf bytes `shouldBe` 0
  describe "isTooLarge" $ do
    it "is what has more pixels than its bytes can hold" $ map (isTooLarge . tga 500 400) [0, 2] `shouldBe` [True, False]
    it "is what has more than 2^26 pixels" $ map (\w -> isTooLarge (tga w 8192 8000)) [8192, 8193] `shouldBe` [False, True]
  where
    png = "\x89PNG\r\n\x1A\n" <> Bytes.pack [0, 0, 0, 13] <> "IHDR" <> Bytes.pack [0, 0, 0, 3, 0, 1, 0, 2, 8, 2, 0, 0, 0]
    bmp kind width height = "BM" <> Bytes.pack (replicate 12 0 <> kind <> width <> height)
    extension = [0x21, 0xF9, 4, 0x2C, 0, 0, 0, 0]
    image w h = [0x2C, 0, 0, 0, 0, w, 0, h, 0, 0x80] <> replicate 6 7 <> [2, 2, 0x2C, 0x21, 0]
    -- A segment is as long as it says: here 11 bytes.
    frame :: Word8 -> Int -> Int -> [Word8]
    frame marker height width = [0xFF, marker, 0, 11, 8] <> concatMap (\n -> [fromIntegral (n `div` 256), fromIntegral (n `mod` 256)]) [height, width] <> [1, 1, 0x11, 0]
    -- With so many bytes behind a header of 18.
    tga :: Int -> Int -> Int -> Bytes.ByteString
    tga w h n = Bytes.pack ([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0] <> map fromIntegral [w `mod` 256, w `div` 256, h `mod` 256, h `div` 256] <> [24, 0]) <> Bytes.replicate n 0
