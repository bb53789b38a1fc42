{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Light.Material
-- Description : What a surface does with light
--
-- A material has one colour and a few coefficients, from which the colours that the illumination terms need are
-- derived.
module Dioptre.Light.Material
  ( Material (..),
    Textures (..),
    standard,
    substitute,
    ambientColour,
    diffuseColour,
    specularColour,
  )
where

import Data.Text (Text)
import Dioptre.Light.Colour (Colour, plus, scaled, white)

-- | A material, by the scene language's own names.
data Material = Material
  { materialName :: Text,
    materialColour :: Colour,
    -- | How much ambient light comes back, from 0 to 1.
    materialKa :: Double,
    -- | How much diffused light comes back, from 0 to 1.
    materialKd :: Double,
    -- | How strong highlights are, from 0 to 1.
    materialKs :: Double,
    -- | How much of a mirror it is, from 0 to 1.
    materialKr :: Double,
    -- | How much light it lets through, from 0 to 1.
    materialKt :: Double,
    -- | The exponent of highlights, from 0 to 200.
    materialShininess :: Double,
    -- | 1 for highlights of the light's colour, as on plastic; 0 for the material's, as on metal.
    materialPlasticity :: Double,
    -- | Greater than 0, to 10.
    materialRefractiveIndex :: Double,
    -- | The pictures of a textured material.
    materialTextures :: Maybe Textures
  }
  deriving stock (Eq, Show)

-- | File names of the pictures that stand in for the ambient, diffuse and specular colours.
data Textures = Textures
  { textureKa :: Maybe Text,
    textureKd :: Maybe Text,
    textureKs :: Maybe Text
  }
  deriving stock (Eq, Show)

-- | A material of which nothing is said.
--
-- Spec: block.material.
standard :: Material
standard = Material "none" white 0.2 0.8 0.5 0 0 20 0 1 Nothing

-- | The grey that stands in for a material that the scene names and does not have.
--
-- Spec: scene.material.substitute, light.material.substitute.
substitute :: Text -> Material
substitute name = standard {materialName = name, materialKa = 0.2, materialKd = 0.6, materialKs = 0.7}

-- | The colour in ambient light: ka times the colour.
--
-- Spec: light.material.ambient.
ambientColour :: Material -> Colour
ambientColour m = scaled (materialKa m) (materialColour m)

-- | The colour in diffused light, and the one that @no_light@ shows: kd times the colour.
--
-- Spec: light.material.diffuse.
diffuseColour :: Material -> Colour
diffuseColour m = scaled (materialKd m) (materialColour m)

-- | The colour of highlights: ks times (p white + (1 - p) colour), with p the plasticity.
--
-- Spec: light.material.specular.
specularColour :: Material -> Colour
specularColour m = scaled (materialKs m) (scaled p white `plus` scaled (1 - p) (materialColour m))
  where
    p = materialPlasticity m
