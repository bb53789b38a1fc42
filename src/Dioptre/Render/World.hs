{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE TupleSections #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.World
-- Description : A scene made ready for many rays
--
-- The prepared shapes of a scene with the materials that they are made of, and the question that a ray tracer asks most: what does this
-- ray meet first?
module Dioptre.Render.World
  ( World,
    world,
    worldSize,
    worldShapes,
    worldMaterials,

    -- * The closest hit
    Closest (..),
    closest,
    shapeAt,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Vector (Vector)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Prepared (Prepared, nearest, prepare)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Light.Material (Material (..), substitute)
import Dioptre.Scene (Scene (..))
import Dioptre.Scene.Primitive (Primitive (..))

-- | Shapes and, under the same numbers, their materials. In the order of the scene.
data World = World
  { -- | The shapes, made ready.
    worldShapes :: !(Vector Prepared),
    -- | The material of each shape.
    worldMaterials :: !(Vector Material)
  }

-- | The world of a scene: all its primitives whose shapes can be drawn.
world :: Scene -> World
world scene = World (Vector.map fst things) (Vector.map snd things)
  where
    things = Vector.fromList (mapMaybe thing (scenePrimitives scene))
    thing p = (,material (primitiveMaterial p)) <$> prepare (primitiveShape p)
    material name = Map.findWithDefault (substitute name) name materials
    -- Of materials of one name the first counts.
    materials = Map.fromListWith (\_ first -> first) [(materialName m, m) | m <- sceneMaterials scene]

-- | How many shapes a ray is tested against.
worldSize :: World -> Int
worldSize = Vector.length . worldShapes

-- | The shape of that number.
shapeAt :: World -> Int -> Maybe Prepared
shapeAt w i = worldShapes w Vector.!? i

-- | What a ray meets first: at which parameter, and the number of the shape; or nothing.
data Closest
  = Nowhere
  | At {-# UNPACK #-} !Double {-# UNPACK #-} !Int
  deriving stock (Eq, Show)

-- | What a ray meets first, nearer than a bound. Of several shapes at the same parameter it is the first of the scene.
--
-- Law: as sorting all the hits of all shapes and taking the first. Cost: one test for each shape.
closest :: World -> Ray -> Double -> Closest
closest w !r = search 0 (-1)
  where
    !shapes = worldShapes w
    !size = Vector.length shapes
    -- The index stays below the size, which is all that unsafeIndex asks.
    search !i !found !best
      | i >= size = if found < 0 then Nowhere else At best found
      | otherwise =
        let !t = nearest (Vector.unsafeIndex shapes i) r best
         in if t < best then search (i + 1) i t else search (i + 1) found best
{-# INLINE closest #-}
