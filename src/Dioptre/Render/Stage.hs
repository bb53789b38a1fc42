{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Render.Stage
-- Description : The world and its lights made ready
--
-- What shading needs of a scene: the world of its shapes, the lights with unit directions, and which terms of
-- illumination are added up.
module Dioptre.Render.Stage
  ( -- * Stages
    Stage (..),
    stage,

    -- * Lights
    Source (..),

    -- * Terms
    Terms (..),
    Highlight (..),
    termsOf,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Vector (Vector)
import qualified Data.Vector as Vector
import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Light.Attenuation (Attenuation, attenuation)
import Dioptre.Light.Colour (Colour, white)
import Dioptre.Light.Light (Aperture (..), Lamp (..), Light (..), Opening (..), Wave (..))
import Dioptre.Light.Wave (linearOscillators, planarOscillators)
import Dioptre.Light.Wavelength (colourOfWavelength)
import Dioptre.Math.Tolerance (ellipseRim)
import Dioptre.Math.Vector (Packed, Point, packed, unit, vector, (*^))
import Dioptre.Model.Library (Library)
import Dioptre.Render.Texture (Assets, Texture (..), Upward (..), texel)
import Dioptre.Render.World (World, world)
import Dioptre.Scene (Scene, sceneLights, sceneRaytracer)
import Dioptre.Scene.Raytracer (Raytracer (..), ReflexionAlgorithm (..))
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | Everything that the colour of a ray depends on.
data Stage = Stage
  { stageWorld :: !World,
    stageSources :: {-# UNPACK #-} !(Vector Source),
    -- | 'Nothing' for no light at all.
    stageTerms :: !(Maybe Terms),
    -- | How deep reflected and refracted rays go; 1 for none.
    stageDepth :: {-# UNPACK #-} !Int
  }

-- | The stage of a scene with its pictures and models.
--
-- Spec: light.source.directional.
stage :: Assets -> Library Texture -> Scene -> Stage
stage assets library scene =
  Stage
    { stageWorld = world assets library scene,
      stageSources = Vector.fromList (mapMaybe (source assets) (sceneLights scene)),
      stageTerms = termsOf (raytracerAlgorithm (sceneRaytracer scene)),
      stageDepth = raytracerRecursiveLevel (sceneRaytracer scene)
    }

-- | A light, ready.
data Source
  = -- | Colour.
    FromEverywhere {-# UNPACK #-} !Colour
  | -- | Colour, and the unit direction in which it travels.
    FromFar {-# UNPACK #-} !Colour {-# UNPACK #-} !Packed
  | -- | Colour, position, and how it grows weaker.
    FromPoint {-# UNPACK #-} !Colour {-# UNPACK #-} !Packed {-# UNPACK #-} !Attenuation
  | -- | The same for waves, whose colour is the wavelength's, with the sources.
    FromWaves {-# UNPACK #-} !Colour {-# UNPACK #-} !Packed {-# UNPACK #-} !Attenuation !Wave !(Unboxed.Vector (Double, Double, Double))

-- Spec: light.wave.place.
source :: Assets -> Light -> Maybe Source
source assets light = case light of
  Ambient c -> Just (FromEverywhere c)
  Directional c v -> FromFar c . packed . vector <$> unit v
  PointLight lamp -> Just (FromPoint (lampColour lamp) (packed (lampPosition lamp)) (attenuation lamp))
  LinearAperture lamp wave ends@(a, b) -> Just (waves lamp wave (0.5 *^ (a + b)) (linearOscillators (waveOscillators wave) ends))
  PlanarAperture opening lamp wave aperture ->
    Just (waves lamp wave (lampPosition lamp) (planarOscillators (isOpen assets opening aperture) (lampPosition lamp) (waveOscillators wave) aperture))
  where
    waves :: Lamp -> Wave -> Point -> [Point] -> Source
    waves lamp wave middle points =
      FromWaves
        (colourOfWavelength (waveLength wave))
        (packed middle)
        (attenuation lamp)
        wave
        (Unboxed.fromList [(x, y, z) | V3 x y z <- points])

-- | Whether a place of an aperture, from its corner to the right and up, lets light through.
--
-- Spec: light.wave.ellipse, light.wave.mask, models.texture.mask.
isOpen :: Assets -> Opening -> Aperture -> Double -> Double -> Bool
isOpen assets opening aperture x y = case opening of
  Rectangle -> True
  Ellipse -> let dx = x - w / 2; dy = y - h / 2 in dx * dx / (w * w / 4) + dy * dy / (h * h / 4) <= 1 + ellipseRim
  Mask name -> maybe True (\p -> texel (Texture FromFirstRow p) (V2 (x / w) (y / h)) == white) (name >>= (`Map.lookup` assets))
  where
    w = apertureWidth aperture
    h = apertureHeight aperture

-- | Which terms a reflexion algorithm adds up.
data Terms = Terms
  { termAmbient :: !Bool,
    termDiffuse :: !Bool,
    termHighlight :: !Highlight
  }
  deriving stock (Eq, Show)

-- | Which highlight, if any.
data Highlight = NoHighlight | BlinnHighlight | PhongHighlight
  deriving stock (Eq, Show)

-- | The terms of an algorithm; 'Nothing' for the one without light.
--
-- Spec: light.algorithm.
termsOf :: ReflexionAlgorithm -> Maybe Terms
termsOf algorithm = case algorithm of
  NoLight -> Nothing
  AmbientOnly -> Just (Terms True False NoHighlight)
  DiffuseOnly -> Just (Terms False True NoHighlight)
  PhongSpecular -> Just (Terms False False PhongHighlight)
  BlinnSpecular -> Just (Terms False False BlinnHighlight)
  NoSpecular -> Just (Terms True True NoHighlight)
  Phong -> Just (Terms True True PhongHighlight)
  Blinn -> Just (Terms True True BlinnHighlight)
