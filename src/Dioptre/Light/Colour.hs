{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Light.Colour
-- Description : Colours, as amounts of light
--
-- A colour is how much there is of red, green and blue, from 0 up without limit, and how opaque it is (alpha, from 0 to
-- 1). It is linear: colours of lights add. What becomes of it in a picture's bytes is "Dioptre.Picture.Byte"'s affair.
module Dioptre.Light.Colour
  ( Colour (..),
    rgb,
    black,
    white,
    scaled,
    filtered,
    plus,
    brightest,
    capped,
    named,
    names,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text

-- | Red, green, blue, alpha. No channel is negative.
data Colour = Colour
  { red :: !Double,
    green :: !Double,
    blue :: !Double,
    alpha :: !Double
  }
  deriving stock (Eq, Show)

-- | An opaque colour.
rgb :: Double -> Double -> Double -> Colour
rgb r g b = Colour r g b 1

-- | No light, all light.
black, white :: Colour
black = rgb 0 0 0
white = rgb 1 1 1

-- | A colour k times as strong, as opaque as before.
--
-- Spec: light.colour.channels.
scaled :: Double -> Colour -> Colour
scaled k (Colour r g b a) = Colour (k * r) (k * g) (k * b) a

-- | What is left of the first colour's light after the second let it through, channel by channel; as opaque as the
-- first.
--
-- Spec: light.colour.channels.
filtered :: Colour -> Colour -> Colour
filtered (Colour r g b a) (Colour r' g' b' _) = Colour (r * r') (g * g') (b * b') a

-- | Two lights together; as opaque as the first.
--
-- Spec: light.colour.channels, light.colour.above-one.
plus :: Colour -> Colour -> Colour
plus (Colour r g b a) (Colour r' g' b' _) = Colour (r + r') (g + g') (b + b') a

-- | No light is brighter than this: 1e100, which is also the largest number of a scene. Colours, factors and tints
-- multiply, and beyond some 1e308 there would be infinity, which times 0 is no number at all.
brightest :: Double
brightest = 1e100

-- | A number that is not negative, or 'brightest' if it is larger.
capped :: Double -> Double
capped x = if x > brightest then brightest else x
{-# INLINE capped #-}

-- | The colour of that name, English or French, in any case.
--
-- Spec: form.colour.
named :: Text -> Maybe Colour
named name = lookup (Text.toLower name) names

-- | The names of colours.
names :: [(Text, Colour)]
names =
  [ (Text.pack name, colour)
    | (english, french, colour) <-
        [ ("black", "noir", black),
          ("white", "blanc", white),
          ("red", "rouge", rgb 1 0 0),
          ("green", "vert", rgb 0 1 0),
          ("blue", "bleu", rgb 0 0 1)
        ],
      name <- [english, french]
  ]
