{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Lighting
-- Description : The operations of the profile lighting
--
-- The bare terms of "Dioptre.Light.Illumination", with no shadow and no attenuation. Normals are made unit;
-- @direction@, the way the light arrives, and
-- @view@, the way the looking ray arrives, are taken as they are.
module Dioptre.Conformance.Lighting
  ( operations,
  )
where

import Data.Aeson (Object)
import Data.Aeson.Types (Parser)
import Data.Text (Text)
import Dioptre.Conformance.Parameter (Operation, colour, field, number, ofColour, unitVector, vector)
import Dioptre.Light.Colour (Colour)
import Dioptre.Light.Illumination (ambient, blinn, lambert, phong)
import Dioptre.Math.Vector (Unit, Vector)

-- | By their names.
--
-- Spec: protocol.operations.
operations :: [(Text, Operation)]
operations =
  [ ("light.ambient", \o -> ambient <$> field colour o "light" <*> field colour o "surface" >>= ofColour),
    ("light.lambert", \o -> lambert <$> field colour o "light" <*> field colour o "surface" <*> field unitVector o "normal" <*> field vector o "direction" >>= ofColour),
    ("light.blinn", highlight blinn),
    ("light.phong", highlight phong)
  ]

highlight :: (Colour -> Colour -> Unit -> Vector -> Vector -> Double -> Colour) -> Operation
highlight term o =
  term
    <$> field colour o "light"
    <*> field colour o "surface"
    <*> field unitVector o "normal"
    <*> field vector o "direction"
    <*> field vector o "view"
    <*> shininess o
    >>= ofColour

-- | The exponent; not negative.
--
-- Spec: protocol.sizes.
shininess :: Object -> Parser Double
shininess o = do
  x <- field number o "shininess"
  if x >= 0 then pure x else fail "the exponent is not negative"
