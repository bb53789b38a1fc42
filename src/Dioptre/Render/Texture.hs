{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Render.Texture
-- Description : Pictures on surfaces
--
-- The pictures that a scene names are its assets, each once. A texture is a picture on a surface, and says how it lies
-- there: v = 0 is in its first row, or for models that ask for it in its last.
module Dioptre.Render.Texture
  ( Assets,
    Texture (..),
    Upward (..),
    texel,
  )
where

import Data.Map.Strict (Map)
import Data.Text (Text)
import qualified Data.Vector.Storable as Storable
import Dioptre.Geometry.Uv (wrapped)
import Dioptre.Light.Colour (Colour, rgb)
import Dioptre.Picture (Picture, pictureBytes, pictureHeight, pictureWidth)
import GHC.Float (float2Double)
import Linear.V2 (V2 (..))

-- | The pictures that a scene uses, by the names that it has for them.
type Assets = Map Text Picture

-- | A picture, and how the texture coordinate v runs over it.
data Texture = Texture
  { textureUpward :: !Upward,
    texturePicture :: !Picture
  }
  deriving stock (Eq, Show)

-- | Where v = 0 is.
data Upward
  = -- | In the first row: v runs down.
    FromFirstRow
  | -- | In the last row: v runs up, and 1 - v is looked up.
    FromLastRow
  deriving stock (Eq, Show)

-- | The colour of a picture at texture coordinates: the picture repeats beyond 0 and 1, v runs as the texture says, and
-- the pixel is the one at trunc (u (width - 1)), trunc (v (height - 1)). Alpha is left out.
--
-- Spec: models.uv-format, models.texture.texel, models.texture.colour, models.texture.mask.
texel :: Texture -> V2 Double -> Colour
texel (Texture upward p) (V2 u v) = rgb (channel 0) (channel 1) (channel 2)
  where
    x = place (wrapped u) (pictureWidth p)
    y = place (down (wrapped v)) (pictureHeight p)
    down w = case upward of
      FromFirstRow -> w
      FromLastRow -> 1 - w
    place c size = min (size - 1) (max 0 (truncate (c * fromIntegral (size - 1))))
    -- The place of the pixel is within the picture, whose bytes are four a pixel.
    channel k = float2Double (fromIntegral (pictureBytes p Storable.! (4 * (y * pictureWidth p + x) + k)) / 255)
