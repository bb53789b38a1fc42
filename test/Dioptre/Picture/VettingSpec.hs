{-# LANGUAGE OverloadedStrings #-}

-- | What decoders are spared. The pictures are written by hand here, their checks with a CRC that the standard names.
module Dioptre.Picture.VettingSpec (spec) where

import qualified Data.ByteString as Bytes
import Data.Either (isLeft, isRight)
import qualified Data.Vector.Storable as Storable
import Dioptre.Picture (pictureBytes)
import Dioptre.Picture.Png (decode)
import Dioptre.Picture.Vetting
import Test.Hspec

spec :: Spec
spec = do
  describe "a PNG" $ do
    it "stays as it is where nothing is missing" $ vetted (png 8 2 1) `shouldBe` Right (png 8 2 1)
    it "is refused where it has fewer pixels than it says" $ vetted (png 8 2 2) `shouldSatisfy` isLeft
    it "is refused where its depth is none that its colours have" $ map (isRight . vetted) [png 16 2 1, png 4 2 1, png 8 5 1, png 8 7 1] `shouldBe` replicate 4 False
    it "is refused where it says nothing" $ vetted "\x89PNG\r\n\x1A\n" `shouldSatisfy` isLeft
  describe "a GIF" $ do
    it "is read, with black for the colours that its palette does not have" $
      -- Codes of 3 bits: clear (4), colours 1 and 3, end (5); 1 is in the palette of two.
      (Storable.toList . pictureBytes <$> decode (gif 2)) `shouldBe` Right [10, 20, 30, 255, 0, 0, 0, 255]
    it "is refused where its codes have more bits than GIF has, or none" $ map (isLeft . vetted . gif) [0, 9, 20] `shouldBe` [True, True, True]
    it "is refused where it has no image, or breaks off" $ map (isLeft . vetted) ["GIF89a", Bytes.take 20 (gif 2), "GIF89a" <> Bytes.pack [1, 0, 1, 0, 0, 0, 0, 0x3B]] `shouldBe` [True, True, True]
  it "leaves other files alone" $ map vetted ["BM", "\xFF\xD8", "abc", ""] `shouldBe` map Right ["BM", "\xFF\xD8", "abc", ""]
  where
    -- Two pixels of colour type 2 in one row, which are seven bytes with the one before the row; what the header says
    -- of depth, colours and height.
    png depth kind height =
      "\x89PNG\r\n\x1A\n" <> chunk "IHDR" (Bytes.pack ([0, 0, 0, 2, 0, 0, 0, height] <> [depth, kind, 0, 0, 0])) (check depth kind height)
        <> chunk "IDAT" (Bytes.pack [120, 156, 99, 96, 100, 98, 254, 245, 251, 15, 0, 6, 3, 2, 248]) [78, 150, 173, 182]
        <> chunk "IEND" "" [174, 66, 96, 130]
    chunk name contents crc = Bytes.pack [0, 0, 0, fromIntegral (Bytes.length contents)] <> name <> contents <> Bytes.pack crc
    -- The check of the one header whose file stays as it is.
    check depth kind height = if (depth, kind, height) == (8, 2, 1) then [123, 64, 232, 221] else [0, 0, 0, 0]
    gif bits = "GIF89a" <> Bytes.pack ([2, 0, 1, 0, 0x80, 0, 0] <> [9, 9, 9, 10, 20, 30] <> [0x2C, 0, 0, 0, 0, 2, 0, 1, 0, 0] <> [bits, 2, 0xCC, 0x0A, 0] <> [0x3B])
