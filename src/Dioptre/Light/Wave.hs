-- |
-- Module      : Dioptre.Light.Wave
-- Description : Light that interferes
--
-- An aperture lets light through as if each of its points were a source of its own (Huygens). The sources oscillate
-- together; what arrives at a point is the square of the sum of their waves, averaged over a period.
--
-- >   | * -----.___
-- >   | * ---------`--- p      the waves arrive with phases k r, k = 2 pi / lambda,
-- >   | * -----'''             r the distance from each source
--
-- With s instants in a period the average is (1\/s) sum_i (sum_w sin (k r_w - 2 pi i \/ s))^2. For s >= 3 that is 1\/2
-- |sum_w e^(i k r_w)|^2 whatever s is, because the terms in twice the phase cancel; for s = 1 and 2 it is (sum_w sin (k
-- r_w))^2. Divided by the square of the number of sources it is at most 1\/2 (or 1).
module Dioptre.Light.Wave
  ( -- * Sources
    linearOscillators,
    planarOscillators,
    oscillatorGrid,
    mostOscillators,

    -- * Intensity
    intensity,
  )
where

import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Light.Light (Aperture (..), Wave (..))
import Dioptre.Math.Vector (Point, cross, distance, unit, vector, (*^))
import Linear.V3 (V3 (..))

-- | No light has more sources than this.
--
-- Spec: code.too-many-oscillators, limits.language.
mostOscillators :: Integer
mostOscillators = 1000000

-- | The sources of a light between two points: P1 + (P2 - P1) i \/ (n - 1); one alone stands in the middle.
--
-- Spec: light.wave.row.
linearOscillators :: Int -> (Point, Point) -> [Point]
linearOscillators n (a, b)
  | n <= 0 = []
  | n == 1 = [0.5 *^ (a + b)]
  | otherwise = [a + (fromIntegral i / fromIntegral (n - 1)) *^ (b - a) | i <- [0 .. n - 1]]

-- | How many sources stand along the width and the height of an aperture that has n along its shorter side.
--
-- Spec: code.too-many-oscillators, light.wave.grid.
oscillatorGrid :: Int -> Aperture -> (Integer, Integer)
oscillatorGrid n aperture
  | n <= 0 = (0, 0)
  | n == 1 = (1, 1)
  | w < h = (toInteger n, along h (w / fromIntegral (n - 1)))
  | otherwise = (along w (h / fromIntegral (n - 1)), toInteger n)
  where
    w = apertureWidth aperture
    h = apertureHeight aperture
    along len step = ceiling (len / step) + 1

-- | The sources of a plane aperture around a point: a grid over its width and height, those places left out that are
-- not open. What is open is asked in coordinates from one corner, to the right and up.
--
-- Spec: light.wave.grid, light.wave.frame.
planarOscillators :: (Double -> Double -> Bool) -> Point -> Int -> Aperture -> [Point]
planarOscillators open position n aperture
  | nx <= 0 || ny <= 0 = []
  | nx == 1 && ny == 1 = [position | open (w / 2) (h / 2)]
  | otherwise =
    [ position - (w / 2) *^ right - (h / 2) *^ up + x *^ right + y *^ up
      | i <- [0 .. nx - 1],
        let x = along i nx w,
        j <- [0 .. ny - 1],
        let y = along j ny h,
        open x y
    ]
  where
    (nx, ny) = oscillatorGrid n aperture
    -- The last one stands on the far edge exactly, where a product of rounded steps may overshoot.
    along i count side
      | i == count - 1 = side
      | otherwise = fromInteger i * (side / fromInteger (count - 1))
    w = apertureWidth aperture
    h = apertureHeight aperture
    front = made (apertureFront aperture)
    up = made (cross (cross front (apertureUp aperture)) front)
    right = cross front up
    made v = maybe v vector (unit v)

-- | How much arrives at a point from some sources: from 0 to 1\/2 (to 1, where the period has one or two instants); 0
-- without sources.
--
-- Spec: numbers.elementary, light.wave.gives, light.wave.intensity, light.wave.few-instants, light.wave.none.
intensity :: Wave -> Unboxed.Vector (Double, Double, Double) -> Point -> Double
intensity wave sources p
  | Unboxed.null sources = 0
  | wavePeriodIteration wave >= 3 = 0.5 * (c * c + s * s) / (n * n)
  | otherwise = s * s / (n * n)
  where
    n = fromIntegral (Unboxed.length sources)
    -- The wavelength is in nanometres, the scene in metres. With k near 1e7 the phase of a source r away has an error of
    -- k r 2^-52: a millionth of a turn at 1 km, and some of a whole one from 10^8 m on, where the pattern is noise.
    k = 2 * pi / (waveLength wave * 1e-9)
    (c, s) = Unboxed.foldl' (\(cs, ss) (x, y, z) -> let phase = k * distance (V3 x y z) p in add cs ss (cos phase) (sin phase)) (0, 0) sources
    add cs ss dc ds = let a = cs + dc; b = ss + ds in a `seq` b `seq` (a, b)
