{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=40 #-}

-- |
-- Module      : Dioptre.Render.Shade
-- Description : The light that a surface sends back
--
-- A surface is lit by every light that reaches it, directly or through transparent shapes:
--
-- > sum over lights (ambient + lambert + highlight)
--
-- The terms are those of "Dioptre.Light.Illumination", and what comes past the shapes in between is told by
-- "Dioptre.Render.Transmittance".
--
-- Specification: 6.4 to 6.7.
module Dioptre.Render.Shade
  ( Lit (..),
    lighting,
    coloursAt,
  )
where

import qualified Data.Vector as Vector
import Dioptre.Geometry.Prepared (textureAt)
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Light.Attenuation (attenuated)
import Dioptre.Light.Colour (Colour (..), black, capped, filtered, plus, rgb, scaled)
import Dioptre.Light.Finish (Colours (..), Finish (..), Pictures (..))
import Dioptre.Light.Illumination (ambient, blinn, lambert, phong)
import Dioptre.Light.Wave (intensity)
import Dioptre.Math.Tolerance (smallestLight)
import Dioptre.Math.Vector (Packed, PackedUnit, Vector, dot, modulus, unpacked, unpackedUnit, vector, (^/))
import Dioptre.Render.Stage
import Dioptre.Render.Surface (Surface (..))
import Dioptre.Render.Texture (Texture, texel)
import Dioptre.Render.Transmittance (Transmittance (..), farthest, transmittance)
import Dioptre.Render.World (World)
import Linear.V2 (V2)

-- | An amount of red, green and blue light, how many shadow rays it took, and how many times one was tried on a shape.
data Lit = Lit {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Int {-# UNPACK #-} !Int

-- | The light that a surface with these colours sends back along a ray: at a point, with a normal turned against the
-- ray, seen in a direction; the sum over all lights, in their order.
--
-- What the algorithm leaves out is black. Which highlight it has is asked once, and not for each light.
--
-- Spec: light.sum.
lighting :: Stage -> Terms -> Colours -> Packed -> PackedUnit -> Packed -> Lit
lighting s terms !colours !p !n !v = case termHighlight terms of
  NoHighlight -> summed (\_ _ -> black)
  BlinnHighlight -> summed (\light d -> blinn light (specularOf colours) (unpackedUnit n) d (unpacked v) (shininessOf colours))
  PhongHighlight -> summed (\light d -> phong light (specularOf colours) (unpackedUnit n) d (unpacked v) (shininessOf colours))
  where
    !sources = stageSources s
    !ambient' = if termAmbient terms then ambientOf colours else black
    !diffuse' = if termDiffuse terms then diffuseOf colours else black
    summed highlight = go (0 :: Int) 0 0 0 0 0
      where
        go !k !red' !green' !blue' !rays !tests
          -- One light may be infinitely bright by now, but none is NaN: its factors are finite.
          | k >= Vector.length sources = Lit (capped red') (capped green') (capped blue') rays tests
          | otherwise = illuminated (stageWorld s) ambient' diffuse' highlight p n (Vector.unsafeIndex sources k) $ \(Colour r' g' b' _) m tried ->
            go (k + 1) (red' + r') (green' + g') (blue' + b') (rays + m) (tests + tried)
    {-# INLINE summed #-}

-- | The light of one source at a point with normal n of a surface with this ambient and this diffuse colour, and this
-- highlight of a light that travels along a direction. It is handed on with how many rays and tests it took: whatever
-- is done with it is done last, so that GHC makes jumps of all that happens here.
--
-- Spec: light.source.ambient, light.source.directional, light.source.point, light.source.at-zero,
--   light.source.zero-denominator, light.shadow.turned-away, light.wave.gives, light.wave.shadow.
illuminated :: World -> Colour -> Colour -> (Colour -> Vector -> Colour) -> Packed -> PackedUnit -> Source -> (Colour -> Int -> Int -> a) -> a
illuminated w !ambient' !diffuse' highlight !at !normal source give = case source of
  FromEverywhere light -> give (ambient light ambient') 0 0
  FromFar light d -> shining light 1 (unpacked d) farthest
  FromPoint light place weaker -> from place weaker (shining light)
  FromWaves light place weaker wave sources ->
    from place weaker $ \factor d distance' ->
      arriving d distance' $ \filter' -> if dark (filtered light filter') then black else scaled (factor * intensity wave sources p) light
  where
    p = unpacked at
    n = unpackedUnit normal
    -- A light's colour, so many times as strong, along d from a distance: Lambert's term and the highlight.
    shining light !factor d distance' = arriving d distance' $ \filter' ->
      let light' = filtered light filter'
       in if dark light' then black else scaled factor (lambert light' diffuse' n d `plus` highlight light' d)
    -- What arrives along d from a distance, unless the surface is turned away or something stands between.
    arriving d distance' shine
      | negate (dot (vector n) d) <= 0 = give black 0 0
      | otherwise = case transmittance w (ray p (negate d)) distance' of
        Transmittance red' green' blue' tests -> give (shine (rgb red' green' blue')) 1 tests
    {-# INLINE arriving #-}
    -- From a place, with attenuation.
    from place weaker shine = case attenuated weaker distance' of
      Nothing -> give black 0 0
      Just factor -> shine factor (between ^/ distance') distance'
      where
        between = p - unpacked place
        distance' = modulus between
    {-# INLINE from #-}
{-# INLINE illuminated #-}

-- | Whether a light has been filtered away.
--
-- Spec: light.shadow.dark, light.wave.shadow.
dark :: Colour -> Bool
dark (Colour r g b _) = r < smallestLight && g < smallestLight && b < smallestLight

-- | The colours of a surface where a ray meets it, at a parameter.
--
-- Spec: light.material.texture, models.mtl.pictures.
coloursAt :: Surface -> Ray -> Double -> Colours
coloursAt (Surface shape f) r t = case finishPictures f of
  NoPictures -> finishColours f
  Pictures a d s -> pictured (finishColours f) a d s (textureAt shape r t)
{-# INLINE coloursAt #-}

-- | Colours with those of pictures at some texture coordinates.
pictured :: Colours -> Maybe Texture -> Maybe Texture -> Maybe Texture -> V2 Double -> Colours
pictured (Colours ambient' diffuse' specular' shininess) a d s uv = Colours (at ambient' a) (at diffuse' d) (at specular' s) shininess
  where
    at plain = maybe plain (`texel` uv)
{-# NOINLINE pictured #-}

-- Note [Numbers that travel]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~
-- A ray, a point, a normal and the colours of a surface are some thirty numbers, which go from one function to the next
-- a hundred million times for a picture. GHC hands a record over as its numbers, without making it, if the function
-- surely looks into it, and if that makes no more arguments than -fmax-worker-args says. It says 10, which is less than
-- the colours of a surface (13), or a few shapes, a ray and a bound (14); here it says 40. In the same way what a
-- function makes is handed back as numbers: Seen ("Dioptre.Render.Radiance"), Lit and Transmittance are never in
-- memory.
--
-- Three things follow for what is here. Records are unpacked into each other down to the numbers. What is not to be
-- taken apart is no record: a 'World' has two constructors, and stays one pointer. And whatever is looked into is
-- looked into early, or once: before GHC 9.0 looks at a value behind a pointer, it saves all numbers that it has at
-- hand, in case the value must be computed first.
