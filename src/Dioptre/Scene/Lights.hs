{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Lights
-- Description : The lights of the scene language
--
-- One schema for each light: its words, their forms, and when there is such a light. Lights have much in common (all
-- that shine from a place have a colour, an amplification and attenuators; all that are waves have a wavelength
-- besides), so that they share one kind of draft, of which each reads and writes its part.
--
-- > ambient_light                color
-- > directional_light            color  orientation
-- > point_light                  color  position  amplification, attenuators
-- > linear_aperture_light        color  two positions  ..., wave
-- > rectangular_aperture_light   color  position  ..., wave, aperture
-- > elliptical_aperture_light    the same
-- > aperture_mask_light          the same, and a mask
--
-- Specification: chapter 3.
module Dioptre.Scene.Lights
  ( readLight,
    writeLight,
    describeLights,
  )
where

import Data.List.NonEmpty (NonEmpty (..))
import Data.Maybe (isNothing)
import Data.Text (Text)
import Dioptre.Light.Colour (Colour, white)
import Dioptre.Light.Light
import Dioptre.Light.Wave (mostOscillators, oscillatorGrid)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Vector (Point, Vector, cross, modulus, unit, vector)
import Dioptre.Scene.Form (colourForm, count, fileName, positive, realFrom, vectorForm, withUnit)
import Dioptre.Scene.Reporting (Check)
import Dioptre.Scene.Schema
import Dioptre.Source.Diagnostic (Expectation, Flaw (..))
import Dioptre.Syntax.Keyword (Keyword)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print (Outline)
import Dioptre.Syntax.Tree (Block (..), Head (..))
import Linear.V3 (V3 (..))

-- | The light that a block describes; 'Nothing' if its values make none, which has been reported, or if its word is no
-- light's.
--
-- Spec: block.lights.
readLight :: Block -> Check (Maybe Light)
readLight block = case headKeyword (blockHead block) of
  Just Keyword.AmbientLight -> through ambientSchema
  Just Keyword.DirectionalLight -> through directionalSchema
  Just Keyword.PointLight -> through pointSchema
  Just Keyword.LinearApertureLight -> through linearSchema
  Just Keyword.RectangularApertureLight -> through (planarSchema Keyword.RectangularApertureLight Rectangle)
  Just Keyword.EllipticalApertureLight -> through (planarSchema Keyword.EllipticalApertureLight Ellipse)
  Just Keyword.ApertureMaskLight -> through maskSchema
  _ -> pure Nothing
  where
    through :: Schema a Light -> Check (Maybe Light)
    through schema = readObject schema block

-- | A light in the scene language.
writeLight :: Light -> Outline
writeLight source = case source of
  Ambient _ -> write ambientSchema
  Directional _ _ -> write directionalSchema
  PointLight _ -> write pointSchema
  LinearAperture {} -> write linearSchema
  PlanarAperture Rectangle _ _ _ -> write (planarSchema Keyword.RectangularApertureLight Rectangle)
  PlanarAperture Ellipse _ _ _ -> write (planarSchema Keyword.EllipticalApertureLight Ellipse)
  PlanarAperture (Mask _) _ _ _ -> write maskSchema
  where
    write :: Schema a Light -> Outline
    write schema = writeObject schema source

-- | Every light's word with its properties: their words, what they expect, their defaults.
--
-- Spec: block.lights.
describeLights :: [(Keyword, [([Keyword], Expectation, [Text])])]
describeLights =
  [ of' ambientSchema,
    of' directionalSchema,
    of' pointSchema,
    of' linearSchema,
    of' (planarSchema Keyword.RectangularApertureLight Rectangle),
    of' (planarSchema Keyword.EllipticalApertureLight Ellipse),
    of' maskSchema
  ]
  where
    of' :: Schema a b -> (Keyword, [([Keyword], Expectation, [Text])])
    of' schema = (schemaKeyword schema, describe schema)

-- | What any light's draft can hold. Each kind of light reads and keeps its own part.
data Draft = Draft
  { draftColour :: Colour,
    draftOrientation :: Vector,
    draftLamp :: Lamp,
    draftWave :: Wave,
    draftEnds :: (Point, Point),
    draftAperture :: Aperture,
    draftMask :: Maybe Text
  }

defaultDraft :: Draft
defaultDraft =
  Draft
    { draftColour = white,
      draftOrientation = V3 0 0 (-1),
      draftLamp = Lamp white 0 1 (1, 0, 0),
      draftWave = Wave 550 10 2,
      draftEnds = (0, V3 0 0.0001 0),
      draftAperture = Aperture 0.001 0.001 (V3 0 0 1) (V3 0 1 0),
      draftMask = Nothing
    }

light :: Keyword -> [Property Draft] -> (Draft -> Either Flaw Light) -> Schema Draft Light
light word properties build = Schema word defaultDraft properties Nothing build open

open :: Light -> Draft
open l = case l of
  Ambient c -> defaultDraft {draftColour = c}
  Directional c v -> defaultDraft {draftColour = c, draftOrientation = v}
  PointLight lamp -> defaultDraft {draftLamp = lamp}
  LinearAperture lamp wave ends -> defaultDraft {draftLamp = lamp, draftWave = wave, draftEnds = ends}
  PlanarAperture opening lamp wave aperture ->
    defaultDraft {draftLamp = lamp, draftWave = wave, draftAperture = aperture, draftMask = case opening of Mask m -> m; _ -> Nothing}

-- Spec: code.zero-orientation, code.too-many-oscillators, block.ambient-light, block.directional-light,
--   block.point-light, block.linear-aperture-light, block.aperture-mask-light.
ambientSchema, directionalSchema, pointSchema, linearSchema, maskSchema :: Schema Draft Light
ambientSchema = light Keyword.AmbientLight [colour] (Right . Ambient . draftColour)
directionalSchema =
  light
    Keyword.DirectionalLight
    [colour, one Keyword.Orientation vectorForm draftOrientation (\v d -> d {draftOrientation = v})]
    ( \d ->
        if modulus (draftOrientation d) < smallestLength
          then Left (ZeroOrientation smallestLength)
          else Right (Directional (draftColour d) (draftOrientation d))
    )
pointSchema = light Keyword.PointLight (lampColourProperty : lampPositionProperty : lampProperties) (fmap PointLight . buildLamp)
linearSchema =
  light Keyword.LinearApertureLight (lampColourProperty : ends : lampProperties <> waveProperties) $ \d ->
    if toInteger (waveOscillators (draftWave d)) > mostOscillators
      then Left (TooManyOscillators (fromInteger mostOscillators))
      else LinearAperture <$> buildLamp d <*> buildWave d <*> pure (draftEnds d)
  where
    ends =
      within draftEnds (\e d -> d {draftEnds = e}) . several (Keyword.Position :| [Keyword.Point]) vectorForm $
        Slot fst (\a (_, b) -> Right (a, b)) :| [Slot snd (\b (a, _) -> Right (a, b))]
maskSchema =
  light Keyword.ApertureMaskLight (apertureProperties <> [one Keyword.Mask fileName draftMask (\m d -> d {draftMask = m})]) $ \d ->
    buildPlanar (Mask (draftMask d)) d

-- Spec: block.planar-aperture-light.
planarSchema :: Keyword -> Opening -> Schema Draft Light
planarSchema word opening = light word apertureProperties (buildPlanar opening)

-- Spec: code.no-attenuation.
buildLamp :: Draft -> Either Flaw Lamp
buildLamp d
  | attenuates (draftLamp d) = Right (draftLamp d)
  | otherwise = Left NoAttenuation

-- Spec: code.invisible-wavelength.
buildWave :: Draft -> Either Flaw Wave
buildWave d
  | isVisible (draftWave d) = Right (draftWave d)
  | otherwise = Left (InvisibleWavelength shortestVisible longestVisible)

-- Spec: code.up-along-front, code.too-many-oscillators.
buildPlanar :: Opening -> Draft -> Either Flaw Light
buildPlanar opening d = do
  lamp <- buildLamp d
  wave <- buildWave d
  let aperture = draftAperture d
      directions = do
        front <- longEnough (apertureFront aperture)
        up <- longEnough (apertureUp aperture)
        longEnough (cross (vector front) (vector up))
      longEnough v = if modulus v < smallestLength then Nothing else unit v
      (across, upwards) = oscillatorGrid (waveOscillators wave) aperture
  if across * upwards > mostOscillators then Left (TooManyOscillators (fromInteger mostOscillators)) else Right ()
  if isNothing directions then Left UpAlongFront else Right (PlanarAperture opening lamp wave aperture)

colour :: Property Draft
colour = one Keyword.Color colourForm draftColour (\v d -> d {draftColour = v})

lampColourProperty, lampPositionProperty :: Property Draft
lampColourProperty = onLamp (one Keyword.Color colourForm lampColour (\v l -> l {lampColour = v}))
lampPositionProperty = onLamp (one Keyword.Position vectorForm lampPosition (\v l -> l {lampPosition = v}))

onLamp :: Property Lamp -> Property Draft
onLamp = within draftLamp (\l d -> d {draftLamp = l})

-- Spec: block.point-light.
lampProperties :: [Property Draft]
lampProperties =
  map
    onLamp
    [ one Keyword.Amplification (realFrom 0) lampAmplification (\v l -> l {lampAmplification = v}),
      attenuator Keyword.ConstantAttenuator (\(c, _, _) -> c) (\c (_, l, q) -> (c, l, q)),
      attenuator Keyword.LinearAttenuator (\(_, l, _) -> l) (\l (c, _, q) -> (c, l, q)),
      attenuator Keyword.QuadraticAttenuator (\(_, _, q) -> q) (\q (c, l, _) -> (c, l, q))
    ]
  where
    attenuator word get put =
      one word (realFrom 0) (get . lampAttenuators) (\v l -> l {lampAttenuators = put v (lampAttenuators l)})

-- Spec: block.linear-aperture-light.
waveProperties :: [Property Draft]
waveProperties =
  map
    (within draftWave (\w d -> d {draftWave = w}))
    [ one Keyword.WaveLength (withUnit "nm" positive) waveLength (\v w -> w {waveLength = v}),
      one Keyword.PeriodIteration (count 1) wavePeriodIteration (\v w -> w {wavePeriodIteration = v}),
      one Keyword.NbOscillator (count 0) waveOscillators (\v w -> w {waveOscillators = v})
    ]

-- Spec: block.planar-aperture-light.
apertureProperties :: [Property Draft]
apertureProperties =
  (lampColourProperty : lampPositionProperty : lampProperties)
    <> waveProperties
    <> map
      (within draftAperture (\a d -> d {draftAperture = a}))
      [ one Keyword.Width positive apertureWidth (\v a -> a {apertureWidth = v}),
        one Keyword.Height positive apertureHeight (\v a -> a {apertureHeight = v}),
        one Keyword.Front vectorForm apertureFront (\v a -> a {apertureFront = v}),
        one Keyword.Up vectorForm apertureUp (\v a -> a {apertureUp = v})
      ]
