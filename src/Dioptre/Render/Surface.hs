{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.Surface
-- Description : What is there
--
-- From the number of what was met to the shape, where it is in the world, and its finish.
module Dioptre.Render.Surface
  ( Surface (..),
    surfaceAt,
    finishAt,
  )
where

import Data.Vector ((!?))
import qualified Data.Vector as Vector
import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Geometry.Mesh (meshFinishes)
import Dioptre.Geometry.Prepared (placedIn)
import Dioptre.Geometry.PreparedMesh (preparedMesh, preparedTriangle)
import Dioptre.Light.Finish (Finish)
import Dioptre.Render.Texture (Texture)
import Dioptre.Render.World (Arranged (..), Body (..), Group (..), Placed (..), Surface (..), World, root)

-- | The shape of a number from 0 to below 'Dioptre.Render.World.worldSize'; 'Nothing' elsewhere.
--
-- Cost: constant for the scene's own primitives; for shapes of models, like the logarithm of the number of instances,
-- and a prepared triangle is made.
surfaceAt :: World -> Int -> Maybe Surface
surfaceAt w !number = surfaceIn (root w) number
{-# NOINLINE surfaceAt #-}

surfaceIn :: Group -> Int -> Maybe Surface
surfaceIn !g !number
  | number < 0 = Nothing
  | number < Vector.length (groupSurfaces g) = let !surface = Vector.unsafeIndex (groupSurfaces g) number in Just surface
  | otherwise = surfaceInInstance g number
{-# INLINE surfaceIn #-}

surfaceInInstance :: Group -> Int -> Maybe Surface
surfaceInInstance g !number = do
  Placed first place body <- instanceOf g number
  Surface shape f <- surfaceInBody body (number - first)
  pure (Surface (maybe id placedIn place shape) f)
{-# NOINLINE surfaceInInstance #-}

-- | The instance of a group that a number is in.
instanceOf :: Group -> Int -> Maybe Placed
instanceOf g number = lastUpTo 0 (Vector.length instances)
  where
    instances = numbered (groupInstances g)
    -- The last instance whose first number is not greater is among those from lo to below hi.
    lastUpTo lo hi
      | hi - lo <= 0 = Nothing
      | hi - lo == 1 = instances !? lo
      | firstOf middle <= number = lastUpTo middle hi
      | otherwise = lastUpTo lo middle
      where
        middle = (lo + hi) `div` 2
    firstOf i = case instances !? i of
      Just (Placed first _ _) -> first
      Nothing -> maxBound

surfaceInBody :: Body -> Int -> Maybe Surface
surfaceInBody (Assembly g) number = surfaceIn g number
surfaceInBody (Triangles m finishes) number =
  Surface <$> preparedTriangle m number <*> (meshFinishes mesh Unboxed.!? number >>= (finishes !?) . fromIntegral)
  where
    mesh = preparedMesh m

-- | The finish of the shape of a number, which takes less than the shape itself.
finishAt :: World -> Int -> Maybe (Finish Texture)
finishAt w = finishIn (root w)
{-# INLINE finishAt #-}

finishIn :: Group -> Int -> Maybe (Finish Texture)
finishIn g number
  | number < 0 = Nothing
  | number < Vector.length (groupSurfaces g) = Just (surfaceFinish (Vector.unsafeIndex (groupSurfaces g) number))
  | otherwise = do
    Placed first _ body <- instanceOf g number
    case body of
      Assembly g' -> finishIn g' (number - first)
      Triangles m finishes -> meshFinishes (preparedMesh m) Unboxed.!? (number - first) >>= (finishes !?) . fromIntegral
