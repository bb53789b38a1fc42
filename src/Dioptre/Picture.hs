{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Picture
-- Description : Pictures, and how they differ
--
-- >            column 0     column 1
-- > row 0      r g b a      r g b a      ...     4 width bytes
-- > row 1      r g b a      r g b a      ...
--
-- What is drawn and what is read from files has one form: bytes in one storable vector, as PNG has them and as
-- JuicyPixels takes them without a copy. Two pictures are the same if every byte is, and if not it is told how
-- many pixels differ, by how much, and where first: enough to tell a rounding from a fault. Specification: 10.2.
module Dioptre.Picture
  ( -- * Pictures
    Picture,
    picture,
    pictureWidth,
    pictureHeight,
    pictureBytes,

    -- * Comparing
    Difference (..),
    difference,
  )
where

import Control.Applicative ((<|>))
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)

-- | A picture of 8-bit pixels: red, green, blue, alpha, row by row from the top left.
--
-- Invariant: 4 width height bytes.
data Picture = Picture
  { -- | In pixels.
    pictureWidth :: !Int,
    -- | In pixels.
    pictureHeight :: !Int,
    -- | Four bytes a pixel, row by row from the top left.
    pictureBytes :: !(Storable.Vector Word8)
  }
  deriving stock (Eq, Show)

-- | The picture of that width (at least 1) with these bytes; as high as they make whole rows.
--
-- Spec: picture.rows.
picture :: Int -> Storable.Vector Word8 -> Picture
picture w bytes = Picture width height (Storable.take (4 * width * height) bytes)
  where
    width = max 1 w
    height = Storable.length bytes `div` (4 * width)

-- | How two pictures differ.
data Difference
  = -- | Their sizes: width and height of each.
    SizesDiffer (Int, Int) (Int, Int)
  | -- | Not at all.
    Equal
  | -- | So many pixels, the largest difference of a channel, and column and row of the first pixel.
    PixelsDiffer Int Int (Int, Int)
  deriving stock (Eq, Show)

-- | How a picture differs from another, pixel by pixel, alpha included.
--
-- Spec: picture.compare, compare.pictures.
difference :: Picture -> Picture -> Difference
difference a b
  | size a /= size b = SizesDiffer (size a) (size b)
  | pictureBytes a == pictureBytes b = Equal
  | otherwise = summary (foldl pixel (0, 0, Nothing) [0 .. pictureWidth a * pictureHeight a - 1])
  where
    size p = (pictureWidth p, pictureHeight p)
    pixel (n, most, first) i
      | apart == 0 = (n, most, first)
      | otherwise = n `seq` most `seq` (n + 1, max most apart, first <|> Just i)
      where
        apart = maximum [abs (channel a - channel b) | c <- [0 .. 3], let channel p = fromIntegral (pictureBytes p Storable.! (4 * i + c)) :: Int]
    summary (n, most, first) = case first of
      Nothing -> Equal
      Just i -> let (row, column) = i `divMod` pictureWidth a in PixelsDiffer n most (column, row)
