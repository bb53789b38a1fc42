{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=40 #-}

-- |
-- Module      : Dioptre.Render.Closest
-- Description : The search for what a ray meets first
--
-- The question that a ray tracer asks most. In a small world everything is tried, one shape after the other; in others
-- the ray is led through boxes, into the frames of models and to their triangles ("Dioptre.Geometry.Hierarchy").
module Dioptre.Render.Closest
  ( closest,
  )
where

import Data.List (foldl')
import Data.Primitive.PrimArray (indexPrimArray)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Box (approach)
import Dioptre.Geometry.Closest (Closest (..), below, precedes, slightlyBeyond, tried, within)
import Dioptre.Geometry.Handful (closestInHandful)
import Dioptre.Geometry.Hierarchy (Tried (..), descend, hierarchyOrder)
import Dioptre.Geometry.Placement (carriedBack)
import Dioptre.Geometry.Prepared (Prepared, nearest)
import Dioptre.Geometry.PreparedMesh (closestTriangle)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Render.World (Arranged (..), Body (..), Group (..), Placed (..), World (..))

-- | What a ray meets first, nearer than a bound.
--
-- Law: as sorting all the hits of all shapes and taking the first. Cost: like the logarithm of the number of shapes
-- that have an end, where they are spread out.
--
-- Spec: geometry.hit.closest, geometry.hit.tie, geometry.hit.index, camera.far.
closest :: World -> Ray -> Double -> Closest
closest w !r !bound = case w of
  Few shapes _ _ -> closestInHandful shapes r bound
  Many g _ -> closestOfMany g r bound
{-# INLINE closest #-}

closestOfMany :: Group -> Ray -> Double -> Closest
closestOfMany g !r !bound = closestInstance g r (closestShape g r (below bound))
{-# NOINLINE closestOfMany #-}

closestShape :: Group -> Ray -> Closest -> Closest
closestShape g r c = case descend (boxes (groupShapes g)) (approach r) within (closestInRange (groupShapes g) r) c of
  Tried found n -> tried n found

-- | The same for the shapes at some places.
closestInRange :: Arranged Prepared -> Ray -> Int -> Int -> Closest -> Closest
closestInRange a !r !from !end before@(Closest t0 number0 tests) = go from t0 number0
  where
    !order = hierarchyOrder (boxes a)
    !shapes = things a
    -- Places are below the number of things.
    go !place !best !number
      | place >= end = if number == number0 && best == t0 then before else Closest best number tests
      | otherwise =
        let !t = nearest (Vector.unsafeIndex shapes place) r (slightlyBeyond best)
            !mine = indexPrimArray order place
         in if precedes t mine best number then go (place + 1) t mine else go (place + 1) best number
{-# NOINLINE closestInRange #-}

-- | The same for the shapes of a group's instances, after what was found before. (What was tried is counted in each
-- body.)
closestInstance :: Group -> Ray -> Closest -> Closest
closestInstance g r c = case descend (boxes a) (approach r) within range c of
  Tried found _ -> found
  where
    a = groupInstances g
    -- Places are below the number of things.
    range from end found = foldl' (\f place -> closestPlaced (Vector.unsafeIndex (things a) place) r f) found [from .. end - 1]

closestPlaced :: Placed -> Ray -> Closest -> Closest
closestPlaced (Placed first place body) r = closestInBody body first (maybe r (`carriedBack` r) place)

-- | The same for a body's shapes, whose numbers begin with that one.
closestInBody :: Body -> Int -> Ray -> Closest -> Closest
closestInBody body !first !r !found = case body of
  Triangles m _ -> closestTriangle m first r found
  -- What was found before has another numbering: it is as if it came later, or before, all that is in the group.
  Assembly g -> renumbered (closestInstance g r (closestShape g r (Closest (closestParameter found) (closestNumber found - first) (closestTests found))))
  where
    renumbered (Closest t number tests) = Closest t (number + first) tests
