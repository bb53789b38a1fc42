-- |
-- Module      : Dioptre.Scene.Materials
-- Description : The materials of the scene language
--
-- A material is plain, or has pictures that stand in for its colours; the second has all properties of the first and
-- three file names. Materials are known by their names, of which a scene may have two alike: the first one counts.
--
-- Specification: chapter 3.
module Dioptre.Scene.Materials
  ( materialSchema,
    textureMaterialSchema,
    writeMaterial,
    byName,
  )
where

import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import Dioptre.Light.Material (Material (..), Textures (..), standard)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Scene.Form (colourForm, fileName, realWithin, text)
import Dioptre.Scene.Schema (Property, Schema (..), one, within, writeObject)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print (Outline)

-- | How the scene language writes a plain material.
--
-- Spec: block.material.
materialSchema :: Schema Material Material
materialSchema = Schema Keyword.Material standard properties Nothing Right id

-- | How it writes one with pictures.
--
-- Spec: block.texture-material.
textureMaterialSchema :: Schema Material Material
textureMaterialSchema = Schema Keyword.TextureMaterial standard {materialTextures = Just noTextures} (properties <> textures) Nothing Right id
  where
    textures =
      map
        (within (fromMaybe noTextures . materialTextures) (\ts m -> m {materialTextures = Just ts}))
        [ one Keyword.TextureKa fileName textureKa (\v ts -> ts {textureKa = v}),
          one Keyword.TextureKd fileName textureKd (\v ts -> ts {textureKd = v}),
          one Keyword.TextureKs fileName textureKs (\v ts -> ts {textureKs = v})
        ]
    noTextures = Textures Nothing Nothing Nothing

-- | A material in the scene language.
writeMaterial :: Material -> Outline
writeMaterial m = case materialTextures m of
  Nothing -> writeObject materialSchema m
  Just _ -> writeObject textureMaterialSchema m

-- | What a name means among some materials: of several of one name the first counts.
byName :: [(Material, a)] -> Map Text a
byName materials = Map.fromListWith (\_ first -> first) [(materialName m, a) | (m, a) <- materials]

-- Spec: optics.refract.index.
properties :: [Property Material]
properties =
  [ one Keyword.Name text materialName (\v m -> m {materialName = v}),
    one Keyword.Color colourForm materialColour (\v m -> m {materialColour = v}),
    one Keyword.Ka fraction materialKa (\v m -> m {materialKa = v}),
    one Keyword.Kd fraction materialKd (\v m -> m {materialKd = v}),
    one Keyword.Ks fraction materialKs (\v m -> m {materialKs = v}),
    one Keyword.Kr fraction materialKr (\v m -> m {materialKr = v}),
    one Keyword.Kt fraction materialKt (\v m -> m {materialKt = v}),
    one Keyword.Shininess (realWithin 0 200) materialShininess (\v m -> m {materialShininess = v}),
    one Keyword.Plasticity fraction materialPlasticity (\v m -> m {materialPlasticity = v}),
    one Keyword.RefractiveIndex (realWithin smallestLength 10) materialRefractiveIndex (\v m -> m {materialRefractiveIndex = v})
  ]
  where
    fraction = realWithin 0 1
