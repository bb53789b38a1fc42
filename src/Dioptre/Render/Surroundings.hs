{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.Surroundings
-- Description : What a point is inside of
--
-- The closed shapes around a point: from them follows the refractive index there. The same boxes that lead rays lead to
-- them.
--
-- Specification: 5.16 and 7.5.
module Dioptre.Render.Surroundings
  ( surroundings,
    refractiveIndexAt,
  )
where

import Data.List (foldl', sortOn)
import Data.Primitive.PrimArray (indexPrimArray)
import Data.Vector ((!?))
import qualified Data.Vector as Vector
import Dioptre.Geometry.Box (approach)
import Dioptre.Geometry.Hierarchy (Tried (..), descend, hierarchyOrder)
import Dioptre.Geometry.Prepared (contains)
import Dioptre.Geometry.Ray (ray)
import Dioptre.Light.Finish (Finish (..))
import Dioptre.Math.Transform (inversePosition)
import Dioptre.Math.Vector (Point)
import Dioptre.Render.Texture (Texture)
import Dioptre.Render.World (Arranged (..), Body (..), Group (..), Placed (..), Surface (..), World, root, worldHasMedia)
import Linear.V3 (V3 (..))

-- | The finishes of the closed shapes that a point is inside of, in the order of their numbers; a shape left out, by
-- its number.
--
-- Spec: optics.medium.at, optics.medium.left-out, optics.medium.model.
surroundings :: World -> Maybe Int -> Point -> [Finish Texture]
surroundings w leftOut p = map snd (sortOn fst (filter ((/= leftOut) . Just . fst) (surroundingIn (root w) 0 p [])))

-- | The refractive index at a point, a shape left out: 1 outside all closed shapes, that of the material inside one,
-- the mean inside several. A point on a surface is not inside.
--
-- Cost: constant where nothing closed lets light through; else that of 'surroundings'.
--
-- Spec: optics.body.leaving, optics.medium.at, optics.medium.opaque, optics.medium.start, optics.medium.left-out.
refractiveIndexAt :: World -> Maybe Int -> Point -> Double
refractiveIndexAt w leftOut p
  | worldHasMedia w = indexAmong w leftOut p
  | otherwise = 1
{-# INLINE refractiveIndexAt #-}

indexAmong :: World -> Maybe Int -> Point -> Double
indexAmong w leftOut p = case map finishIndex (surroundings w leftOut p) of
  [] -> 1
  indices -> sum indices / fromIntegral (length indices)
{-# NOINLINE indexAmong #-}

-- | Shapes of a group that are around a point, and those of its instances; their numbers begin with that one.
surroundingIn :: Group -> Int -> Point -> [(Int, Finish Texture)] -> [(Int, Finish Texture)]
surroundingIn g first p = within' (groupInstances g) inInstance . within' (groupShapes g) inShape
  where
    -- A ray that goes nowhere comes into the boxes that hold its origin. (Places are below the number of things.)
    within' a try found = case descend (boxes a) (approach (ray p (V3 1 0 0))) (const 0) range found of
      Tried all' _ -> all'
      where
        range from end l = foldl' (\l' place -> try (indexPrimArray (hierarchyOrder (boxes a)) place) (things a Vector.! place) l') l [from .. end - 1]
    inShape number shape found = case groupSurfaces g !? number of
      Just surface | contains shape p -> (first + number, surfaceFinish surface) : found
      _ -> found
    inInstance _ (Placed inner place body) found = case body of
      Assembly g' -> surroundingIn g' (first + inner) (maybe p (`inversePosition` p) place) found
      -- A mesh is a surface, closed or not.
      Triangles _ _ -> found
