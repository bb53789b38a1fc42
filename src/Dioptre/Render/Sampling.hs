-- |
-- Module      : Dioptre.Render.Sampling
-- Description : Which points of a pixel are looked through
--
-- The fixed points of @pixel_coordinate@ and the random ones, which are random as a list of numbers in a book is: each
-- sample of each pixel has its own number, computed from the seed and from where it stands, so that the picture is the
-- same on every run, however many workers share it.
module Dioptre.Render.Sampling
  ( offset,
    uniform,
  )
where

import Data.Bits (shiftR, xor)
import Data.Word (Word64)
import Dioptre.Scene.Raytracer (PixelCoordinate (..), Raytracer (..))

-- | Where in the pixel the ray of a sample goes through, from 0 to 1 to the right and down. Arguments: the ray tracer,
-- the width of the picture, then column, row and sample, each from 0.
--
-- Spec: camera.pixel-coordinate, camera.random, camera.seed.
offset :: Raytracer -> Int -> Int -> Int -> Int -> (Double, Double)
offset tracer width column row sample = case raytracerPixelCoordinate tracer of
  TopLeft -> (0, 0)
  TopRight -> (1, 0)
  BottomLeft -> (0, 1)
  BottomRight -> (1, 1)
  Center -> (0.5, 0.5)
  Random -> (uniform seed i, uniform seed (i + 1))
  where
    seed = fromIntegral (raytracerSeed tracer)
    n = fromIntegral (raytracerSampling tracer)
    i = 2 * ((fromIntegral row * fromIntegral width + fromIntegral column) * n + fromIntegral sample)
{-# INLINE offset #-}

-- | The i-th number of the sequence that starts from a seed, at least 0 and less than 1: the upper 53 bits of mix (mix
-- seed + (i + 1) 0x9E3779B97F4A7C15), times 2^-53, modulo 2^64. Source: G. Steele, D. Lea, C. Flood, "Fast splittable
-- pseudorandom number generators", OOPSLA 2014.
--
-- Spec: camera.generator, camera.seed.largest.
uniform :: Word64 -> Word64 -> Double
uniform seed i = fromIntegral (mix (mix seed + (i + 1) * 0x9E3779B97F4A7C15) `shiftR` 11) * (1 / 9007199254740992)

-- | SplitMix64's finaliser.
--
-- Spec: camera.generator.
mix :: Word64 -> Word64
mix z0 = z2 `xor` (z2 `shiftR` 31)
  where
    z1 = (z0 `xor` (z0 `shiftR` 30)) * 0xBF58476D1CE4E5B9
    z2 = (z1 `xor` (z1 `shiftR` 27)) * 0x94D049BB133111EB
