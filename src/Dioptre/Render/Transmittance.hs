{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=40 #-}

-- |
-- Module      : Dioptre.Render.Transmittance
-- Description : What comes past the shapes on the way from a light
--
-- Between a point and a light anything opaque leaves nothing, and each transparent shape tints what comes through:
--
-- >   light  *  - - - -( a pane )- - - -( a ball )- - - ->  point
-- >        1 1 1        its tint     times its tint
--
-- A shadow ray goes the other way, from the point, and straight: it is not refracted.
--
-- Specification: 6.6.
module Dioptre.Render.Transmittance
  ( Transmittance (..),
    transmittance,
    past,
    farthest,
  )
where

import Data.List (foldl', sortOn)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Light.Colour (Colour (..), capped)
import Dioptre.Light.Finish (Finish (..))
import Dioptre.Render.Obstacles (Obstacles (..), obstacles)
import Dioptre.Render.World (World)

-- | How much of red, green and blue light comes past what stands in its way, and how many times the ray was tried on a
-- shape to know it: 0 0 0 if anything lets nothing through, 1 1 1 if nothing is there, and else the product of the
-- tints (which may be 0 0 0 as well: whether anything lets nothing through is told by 'obstacles').
data Transmittance = Transmittance {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Int
  deriving stock (Eq, Show)

-- | What comes past all that a shadow ray meets nearer than a bound. Each shape tints the light once, however often the
-- ray crosses it; tints are multiplied in the order of the shapes' numbers.
--
-- Spec: light.shadow.ray, light.shadow.opaque, light.shadow.beyond, light.shadow.transparent, light.shadow.product,
--   light.shadow.opaque-among, light.shadow.itself.
transmittance :: World -> Ray -> Double -> Transmittance
transmittance w !r !bound = past (obstacles w r bound)

-- | What comes past these obstacles.
past :: Obstacles -> Transmittance
past (Obstacles opaque transparent tests)
  | opaque = Transmittance 0 0 0 tests
  | null transparent = Transmittance 1 1 1 tests
  | otherwise = foldl' tinted (Transmittance 1 1 1 tests) (map snd (sortOn fst transparent))
  where
    tinted (Transmittance r' g' b' n) f = let Colour x y z _ = finishTint f in Transmittance (capped (r' * x)) (capped (g' * y)) (capped (b' * z)) n
{-# INLINE past #-}

-- | The bound of a shadow ray to a light that is infinitely far. A scene has no number beyond 1e100: only frames that
-- enlarge one another lead farther away than this, and what is there throws no shadow. (Infinity has no literal, and 1 \/ 0 would be a value to be looked up; see also Note [Literals] of
-- "Dioptre.Math.Roots".)
farthest :: Double
farthest = 1e100 * 1e100 * 1e100
{-# INLINE farthest #-}
