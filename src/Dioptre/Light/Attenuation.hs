{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Light.Attenuation
-- Description : How light grows weaker on its way
--
-- Light that spreads out from a place reaches a distance D with the strength
--
-- >        amplification
-- > -----------------------------------
-- >  constant + linear D + quadratic D D
--
-- The square alone is what physics has: the same light on a sphere of the area 4 pi D^2. The other two are there so
-- that a scene need not grow dark.
--
-- Specification: 6.5.
module Dioptre.Light.Attenuation
  ( Attenuation (..),
    attenuation,
    attenuated,
  )
where

import Dioptre.Light.Colour (capped)
import Dioptre.Light.Light (Lamp (..))

-- | The amplification and the three attenuators, each from 0 up. Distances are those of the scene.
data Attenuation = Attenuation
  { amplification :: {-# UNPACK #-} !Double,
    constant :: {-# UNPACK #-} !Double,
    linear :: {-# UNPACK #-} !Double,
    quadratic :: {-# UNPACK #-} !Double
  }
  deriving stock (Eq, Show)

-- | That of a lamp.
attenuation :: Lamp -> Attenuation
attenuation lamp = Attenuation (lampAmplification lamp) c l q
  where
    (c, l, q) = lampAttenuators lamp

-- | How many times as strong a light is at a distance of 0 or more, at most 'Dioptre.Light.Colour.brightest'; 'Nothing'
-- at the very place of the light, and where the attenuation divides by zero.
--
-- >>> attenuated (Attenuation 1 0 0 1) 2
-- Just 0.25
--
-- Spec: light.source.point, light.source.at-zero, light.source.zero-denominator.
attenuated :: Attenuation -> Double -> Maybe Double
attenuated a d
  | d == 0 || denominator == 0 = Nothing
  | otherwise = Just (capped (amplification a / denominator))
  where
    denominator = constant a + linear a * d + quadratic a * d * d
{-# INLINE attenuated #-}
