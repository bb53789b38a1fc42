{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Light.Light
-- Description : Sources of light
--
-- The closed sum of the lights that a scene can hold, as they are written. "Dioptre.Render.Stage" makes them ready, and
-- "Dioptre.Render.Shade" adds them up.
--
-- Specification: 6.5 and 6.7.
module Dioptre.Light.Light
  ( Light (..),
    Lamp (..),
    Wave (..),
    Aperture (..),
    Opening (..),
    attenuates,
    isVisible,
    shortestVisible,
    longestVisible,
  )
where

import Data.Text (Text)
import Dioptre.Light.Colour (Colour)
import Dioptre.Math.Vector (Point, Vector)

-- | A light.
data Light
  = -- | From everywhere.
    Ambient Colour
  | -- | From infinitely far away; the vector points the way the light travels, and is at least 1e-10 long.
    Directional Colour Vector
  | PointLight Lamp
  | -- | Waves from a row of sources between two points.
    LinearAperture Lamp Wave (Point, Point)
  | -- | Waves from a grid of sources in a plane opening.
    PlanarAperture Opening Lamp Wave Aperture
  deriving stock (Eq, Show)

-- | What a light at a place has.
data Lamp = Lamp
  { lampColour :: Colour,
    lampPosition :: Point,
    -- | A factor from 0 up.
    lampAmplification :: Double,
    -- | The attenuation at distance D is 1 \/ (constant + linear D + quadratic D^2): these are constant, linear,
    -- quadratic.
    lampAttenuators :: (Double, Double, Double)
  }
  deriving stock (Eq, Show)

-- | What a light made of waves has.
data Wave = Wave
  { -- | In nanometres.
    waveLength :: Double,
    -- | How many instants of a period are summed.
    wavePeriodIteration :: Int,
    -- | How many sources stand along the shorter side.
    waveOscillators :: Int
  }
  deriving stock (Eq, Show)

-- | The shape of an opening.
data Opening
  = Rectangle
  | Ellipse
  | -- | A picture, by the name of its file, whose white places are open; without one it is open everywhere.
    Mask (Maybe Text)
  deriving stock (Eq, Show)

-- | Where an opening lies and how large it is.
data Aperture = Aperture
  { apertureWidth :: Double,
    apertureHeight :: Double,
    apertureFront :: Vector,
    apertureUp :: Vector
  }
  deriving stock (Eq, Show)

-- | Whether a lamp's attenuation is possible: not all three attenuators are zero.
--
-- Spec: code.no-attenuation.
attenuates :: Lamp -> Bool
attenuates l = lampAttenuators l /= (0, 0, 0)

-- | Whether a wavelength has a colour.
--
-- Spec: code.invisible-wavelength, light.wave.visible.
isVisible :: Wave -> Bool
isVisible w = waveLength w >= shortestVisible && waveLength w <= longestVisible

-- | The ends of the visible light, in nanometres.
shortestVisible, longestVisible :: Double
shortestVisible = 380
longestVisible = 780
