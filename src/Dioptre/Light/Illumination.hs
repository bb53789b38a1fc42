{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Light.Illumination
-- Description : The four terms of illumination
--
-- How much light a surface sends to the viewer, as sums of simple terms. At a point of the surface:
--
-- >        N                 d   the way the light arrives
-- >   d \  ^  / R, E         N   the normal, towards the viewer
-- >      \ | /               E   towards the viewer: -v, where v is the way the looking ray arrives
-- >       v|/                R   the light mirrored ("Dioptre.Optics.Reflection")
-- >   -----+------           H   half way between the light and the viewer: -v - d, made unit
--
-- All directions are unit. The terms are bare: shadows, attenuation and the sum over lights are
-- "Dioptre.Render.Shade"'s affair. Sources: J. H. Lambert, Photometria, 1760; B. T. Phong, "Illumination for computer
-- generated pictures", CACM 18(6), 1975; J. F. Blinn, "Models of light reflection for computer synthesized pictures",
-- SIGGRAPH 1977.
module Dioptre.Light.Illumination
  ( ambient,
    lambert,
    blinn,
    phong,
    power,
  )
where

import Data.Bits (testBit, unsafeShiftR)
import Dioptre.Light.Colour (Colour, black, filtered, scaled)
import Dioptre.Math.Vector (Unit, Vector, dot, modulus, vector, (^/))
import Dioptre.Optics.Reflection (reflected)

-- | Light from everywhere: light . surface.
--
-- Spec: light.ambient.
ambient :: Colour -> Colour -> Colour
ambient = filtered
{-# INLINE ambient #-}

-- | Light that the surface scatters: light . surface . \<N, -d>; black where the light comes from behind.
--
-- Law: a surface that faces the light sends all of it back, and one at 60 degrees half.
--
-- Spec: light.lambert, light.lambert.behind.
lambert :: Colour -> Colour -> Unit -> Vector -> Colour
lambert light surface n d
  | facing < 0 = black
  | otherwise = scaled facing (filtered light surface)
  where
    facing = negate (dot (vector n) d)
{-# INLINE lambert #-}

-- | A highlight, as Blinn has it: light . surface . \<N, H>^shininess; black where \<N, H> is negative, and where light
-- and viewer are exactly opposite, so that there is no H. The exponent 0 gives the factor 1.
--
-- Spec: light.blinn, light.blinn.behind, light.blinn.opposite.
blinn :: Colour -> Colour -> Unit -> Vector -> Vector -> Double -> Colour
blinn light surface n d v shininess
  | width <= 0 || facing < 0 = black
  | otherwise = scaled (power facing shininess) (filtered light surface)
  where
    between = negate v - d
    width = modulus between
    facing = dot (vector n) (between ^/ width)
{-# INLINE blinn #-}

-- | A highlight, as Phong has it: light . surface . \<R, E>^shininess; black where \<R, E> is negative. The exponent 0
-- gives the factor 1.
--
-- Spec: light.phong, light.phong.behind.
phong :: Colour -> Colour -> Unit -> Vector -> Vector -> Double -> Colour
phong light surface n d v shininess
  | facing < 0 = black
  | otherwise = scaled (power facing shininess) (filtered light surface)
  where
    facing = negate (dot (reflected d n) v)
{-# INLINE phong #-}

-- | x^n for x and n from 0 up; 1 where n is 0.
--
-- Most shininesses are whole numbers, and those to 256 are taken by squaring, in at most 16 products: a third of the
-- time of the library's power. The relative error of x^(2k) is twice that of x^k and 2^-53 more, which makes at most n
-- 2^-53 in all: below 3e-14.
--
-- Spec: numbers.elementary, light.power.
power :: Double -> Double -> Double
power x n
  | k >= 0 && k <= 256 && fromIntegral k == n = squaring k x 1
  | otherwise = x ** n
  where
    k = truncate n :: Int
    -- Invariant: x^n = acc * square^m.
    squaring :: Int -> Double -> Double -> Double
    squaring !m !square !acc
      | m == 0 = acc
      | testBit m 0 = squaring (m `unsafeShiftR` 1) (square * square) (acc * square)
      | otherwise = squaring (m `unsafeShiftR` 1) (square * square) acc
{-# INLINE power #-}
