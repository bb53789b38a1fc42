{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Picture.Byte
-- Description : From amounts of light to bytes
--
-- The last thing that happens to a colour: channels brighter than 1 are brought back into range, and each becomes one
-- of 256 levels. There is no gamma: levels are linear, as in the original.
module Dioptre.Picture.Byte
  ( Pixel (..),
    pixelOf,
    normalized,
    level,
  )
where

import Data.Word (Word8)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Math.Order (larger, smaller)
import Dioptre.Scene.Raytracer (ColourNormalization (..))
import GHC.Float (double2Float, float2Double)

-- | Red, green, blue, alpha.
data Pixel = Pixel !Word8 !Word8 !Word8 !Word8
  deriving stock (Eq, Show)

-- | The pixel of a colour.
--
-- >>> pixelOf ClampChannel (Colour 0.5 2 0.25 1)
-- Pixel 128 255 64 255
--
-- Spec: picture.pixel.
pixelOf :: ColourNormalization -> Colour -> Pixel
pixelOf how colour = Pixel (level r) (level g) (level b) (level a)
  where
    Colour r g b a = normalized how colour

-- | A colour with no channel above 1. Alpha is cut to 1 either way.
--
-- >>> normalized DivisionFactor (Colour 0.5 2 0 1)
-- Colour {red = 0.25, green = 1.0, blue = 0.0, alpha = 1.0}
--
-- Spec: light.colour.above-one, picture.clamp, picture.division, picture.alpha.
normalized :: ColourNormalization -> Colour -> Colour
normalized how (Colour r g b a) = case how of
  ClampChannel -> Colour (toOne r) (toOne g) (toOne b) (toOne a)
  DivisionFactor ->
    let m = larger 1 (larger r (larger g b))
     in Colour (r / m) (g / m) (b / m) (toOne a)
  where
    toOne = smaller 1

-- | The level of a channel between 0 and 1, rounded half up: trunc (double (float c * 255) + 0.5), with the product in
-- binary32, as in the original. Below 0 (or NaN) it is 0, above 1 it is 255.
--
-- >>> map level [0, 0.25, 0.5, 0.75, 1]
-- [0,64,128,191,255]
--
-- Spec: picture.byte, picture.byte.range.
level :: Double -> Word8
level c
  | c >= 1 = 255
  | c > 0 = fromIntegral (truncate (float2Double (double2Float c * 255) + 0.5) :: Int)
  | otherwise = 0
