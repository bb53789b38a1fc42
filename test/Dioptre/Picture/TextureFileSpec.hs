{-# LANGUAGE OverloadedStrings #-}

-- | Pictures as textures read them: the rows of TGA files stay in the order in which they are stored.
--
-- The files are written by hand here, from Truevision's TGA specification 2.0: a header of 18 bytes (kind of picture in
-- byte 2, width and height in bytes 12 to 15, bits a pixel in byte 16, descriptor in byte 17), then pixels as blue,
-- green, red (and alpha).
module Dioptre.Picture.TextureFileSpec
  ( spec,
  )
where

import Control.Monad (forM_)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Either (isLeft)
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)
import Dioptre.Picture (pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Picture.Png (decodeTexture)
import Dioptre.Source.Diagnostic (PictureFault (NoPicture))
import Test.Hspec (Spec, describe, it, shouldBe, shouldSatisfy)

spec :: Spec
spec = describe "decodeTexture" $ do
  forM_ [("bottom up", 0x00), ("top down", 0x20)] $ \(name, descriptor) -> do
    it ("keeps the stored order of rows, 24 bits, " <> name) $
      decoded (tga 2 24 descriptor [[10, 20, 30], [40, 50, 60]]) `shouldBe` Right (1, 2, [30, 20, 10, 255, 60, 50, 40, 255])
    it ("keeps the stored order of rows, 32 bits, " <> name) $
      decoded (tga 2 32 descriptor [[10, 20, 30, 7], [40, 50, 60, 8]]) `shouldBe` Right (1, 2, [30, 20, 10, 7, 60, 50, 40, 8])
    it ("keeps the stored order of rows, run lengths, " <> name) $
      -- One packet of one raw pixel, one of a run of one.
      decoded (tga 10 24 descriptor [[0x00, 10, 20, 30], [0x80, 40, 50, 60]]) `shouldBe` Right (1, 2, [30, 20, 10, 255, 60, 50, 40, 255])
  it "refuses what is no picture" $
    forM_ ["a.tga", "a.png", "a.gif", "a.jpg"] $ \path -> decodeTexture path "no picture at all" `shouldSatisfy` isLeft
  it "knows a text from a picture, also one that would have very many pixels" $
    forM_ ["a.tga", "a.png", "a.txt"] $ \path -> either Just (const Nothing) (decodeTexture path "camera\n  position 0 0 0\n  angle 20\nend\n") `shouldBe` Just NoPicture
  it "refuses a picture that is cut off" $
    decodeTexture "a.tga" (Bytes.take 20 (tga 2 24 0 [[1, 2, 3], [4, 5, 6]])) `shouldSatisfy` isLeft
  where
    decoded bytes = (\p -> (pictureWidth p, pictureHeight p, Storable.toList (pictureBytes p))) <$> decodeTexture "a.TGA" bytes

-- | A picture one pixel wide, two high.
tga :: Word8 -> Word8 -> Word8 -> [[Word8]] -> ByteString
tga kind bits descriptor pixels =
  Bytes.pack ([0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, bits, descriptor] <> concat pixels)
