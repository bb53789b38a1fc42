-- | Files of pictures: files made by other means, and the laws.
module Dioptre.Picture.PngSpec (spec) where

import Control.Monad (forM_)
import Data.Bits (shiftR)
import qualified Data.ByteString as Bytes
import Data.Either (isLeft)
import Data.IORef (modifyIORef, newIORef, readIORef)
import qualified Data.Vector.Storable as Storable
import Data.Word (Word64, Word8)
import Dioptre.Picture (picture)
import Dioptre.Picture.Png
import Laws.Picture
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "encode" $ do
    prop "is undone by decode" decodesToItself
    prop "writes 8 bits a channel, red, green, blue and alpha" isWrittenAsRgba

  describe "encodeRows" $ do
    prop "is read as the picture of the rows" rowsAreWrittenAsThePicture
    -- Noise takes as many bytes in the file as it has; of the 2 MB here, zlib keeps a window of 32 kB and what it has
    -- made of less than one block (2^14 bytes)
    it "hands on the bytes as the rows come, and keeps few of them" $ do
      put <- newIORef 0
      behind <- newIORef []
      let rows :: (Storable.Vector Word8 -> IO ()) -> IO ()
          rows receive = forM_ [0 .. 499] $ \y -> do
            receive (noise y)
            already <- readIORef put
            modifyIORef behind (4000 * (y + 1) - already :)
      encodeRows 1000 500 rows (\bytes -> modifyIORef put (+ Bytes.length bytes))
      most <- maximum <$> readIORef behind
      most `shouldSatisfy` (< 131072)

  describe "decode" $ do
    -- Two pixels, (1, 2, 3) and (250, 251, 252), of colour type 2, written with Python's struct and zlib from the PNG
    -- specification
    it "reads a file without alpha as opaque" $
      decode (Bytes.pack (signature ++ header ++ body ++ end)) `shouldBe` Right (picture 2 (Storable.fromList [1, 2, 3, 255, 250, 251, 252, 255]))
    it "complains about what is no picture" $ map (isLeft . decode) [Bytes.empty, Bytes.pack [1 .. 100], Bytes.pack (signature ++ header)] `shouldBe` [True, True, True]

  describe "decodeTexture" $ do
    it "reads what is no TGA like any picture" $ decodeTexture "a.PNG" (Bytes.pack (signature ++ header ++ body ++ end)) `shouldBe` decode (Bytes.pack (signature ++ header ++ body ++ end))
    -- One column of two pixels, stored as blue, green, red: first (1, 2, 3), then (4, 5, 6)
    it "keeps the rows of a TGA in the order in which they are stored, whatever its descriptor says" $
      [decodeTexture name (Bytes.pack (tga descriptor)) | name <- ["a.tga", "b.TGA"], descriptor <- [0, 0x20]]
        `shouldBe` replicate 4 (Right (picture 1 (Storable.fromList [1, 2, 3, 255, 4, 5, 6, 255])))
    it "complains about a TGA that is none" $ isLeft (decodeTexture "a.tga" (Bytes.pack [1, 2, 3])) `shouldBe` True
  where
    -- The middle of the numbers of Knuth's generator (MMIX) is noise enough.
    noise y = Storable.unfoldrN 4000 (\s -> Just (fromIntegral (s `shiftR` 32), 6364136223846793005 * s + 1442695040888963407)) (fromIntegral y :: Word64)
    signature = [137, 80, 78, 71, 13, 10, 26, 10]
    header = [0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 0, 2, 0, 0, 0, 1, 8, 2, 0, 0, 0, 123, 64, 232, 221]
    body = [0, 0, 0, 15, 73, 68, 65, 84, 120, 156, 99, 96, 100, 98, 254, 245, 251, 15, 0, 6, 3, 2, 248, 78, 150, 173, 182]
    end = [0, 0, 0, 0, 73, 69, 78, 68, 174, 66, 96, 130]
    tga descriptor = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2, 0, 24, descriptor, 3, 2, 1, 6, 5, 4]
