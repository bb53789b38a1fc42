{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=24 #-}

-- |
-- Module      : Dioptre.Geometry.Handful
-- Description : A few shapes, tried one after the other
--
-- Boxes around only a few shapes would take as long as they save: a ray is tried on all of them. The numbers of spheres
-- stand side by side, apart from the other shapes. See Note [Plain numbers].
module Dioptre.Geometry.Handful
  ( Handful,
    handful,

    -- * Intersecting
    closestInHandful,
    foldMet,
  )
where

import Data.Primitive.PrimArray
import Data.Primitive.SmallArray
import Data.Vector (Vector)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Closest (Closest (..), precedes, slightlyBeyond)
import Dioptre.Geometry.Prepared (Prepared, firstAhead, nearest, preparedSphere)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Geometry.Sphere (sphereClearlyMissed, sphereParametersAhead)
import Dioptre.Math.Vector (Point)
import Linear.V3 (V3 (..))

-- | Shapes, numbered from 0.
data Handful = Handful
  { -- | The centres of the spheres, coordinate by coordinate, and their squared radii.
    centresX, centresY, centresZ, radiiSquared :: {-# UNPACK #-} !(PrimArray Double),
    -- | The shapes that are no spheres.
    others :: {-# UNPACK #-} !(SmallArray Prepared),
    -- | The spheres' numbers, then those of the others.
    numbers :: {-# UNPACK #-} !(PrimArray Int)
  }
  deriving stock (Eq, Show)

-- | These shapes, in the order of their numbers.
handful :: Vector Prepared -> Handful
handful shapes =
  Handful
    { centresX = primArrayFromList [x | (_, (V3 x _ _, _)) <- round'],
      centresY = primArrayFromList [y | (_, (V3 _ y _, _)) <- round'],
      centresZ = primArrayFromList [z | (_, (V3 _ _ z, _)) <- round'],
      radiiSquared = primArrayFromList [q | (_, (_, q)) <- round'],
      others = smallArrayFromList rest,
      numbers = primArrayFromList (map fst round' ++ restNumbers)
    }
  where
    numbered = zip [0 ..] (Vector.toList shapes)
    round' = [(i, ball) | (i, s) <- numbered, Just ball <- [preparedSphere s]]
    (restNumbers, rest) = unzip [(i, s) | (i, s) <- numbered, Nothing <- [preparedSphere s]]

-- | What a ray meets first, nearer than a bound.
--
-- Law: the first of what all shapes are met at. Cost: an equation for each shape.
closestInHandful :: Handful -> Ray -> Double -> Closest
closestInHandful h !r !bound = amongOthers 0 (-1) bound
  where
    !spheres = sizeofPrimArray (radiiSquared h)
    !rest = sizeofSmallArray (others h)
    -- In the order of their numbers the first of several at one parameter is kept. Places are below the number of
    -- shapes.
    amongOthers :: Int -> Int -> Double -> Closest
    amongOthers !i !number !best
      | i >= rest = amongSpheres 0 number best
      | otherwise =
        let !t = nearest (indexSmallArray (others h) i) r best
         in if t < best then amongOthers (i + 1) (indexPrimArray (numbers h) (spheres + i)) t else amongOthers (i + 1) number best
    amongSpheres :: Int -> Int -> Double -> Closest
    amongSpheres !i !number !best
      | i >= spheres = Closest best number (spheres + rest)
      | sphereAt h i sphereClearlyMissed r = amongSpheres (i + 1) number best
      | otherwise =
        let !t = firstAhead (sphereAt h i sphereParametersAhead r) (slightlyBeyond best)
            !mine = indexPrimArray (numbers h) i
         in if precedes t mine best number then amongSpheres (i + 1) mine t else amongSpheres (i + 1) number best
{-# NOINLINE closestInHandful #-}

-- | Goes through the shapes that a ray meets nearer than a bound, in a fixed order: for each, what to do with how many
-- shapes have been tried, this one included, with its number, with the result so far, and with the way to go on; in the
-- end, what to do with how many there were in all and the result.
foldMet :: Handful -> Ray -> Double -> (Int -> Int -> a -> (a -> b) -> b) -> (Int -> a -> b) -> a -> b
foldMet h !r !bound each end = amongSpheres 0
  where
    !spheres = sizeofPrimArray (radiiSquared h)
    !count = sizeofPrimArray (numbers h)
    amongSpheres !i a
      | i >= spheres = amongOthers i a
      | sphereAt h i sphereClearlyMissed r = amongSpheres (i + 1) a
      | firstAhead (sphereAt h i sphereParametersAhead r) bound < bound = each (i + 1) (indexPrimArray (numbers h) i) a (amongSpheres (i + 1))
      | otherwise = amongSpheres (i + 1) a
    amongOthers !i a
      | i >= count = end count a
      -- Places are below the number of shapes.
      | nearest (indexSmallArray (others h) (i - spheres)) r bound < bound = each (i + 1) (indexPrimArray (numbers h) i) a (amongOthers (i + 1))
      | otherwise = amongOthers (i + 1) a
{-# INLINE foldMet #-}

-- | Asks something of the sphere at that place.
sphereAt :: Handful -> Int -> (Point -> Double -> a) -> a
sphereAt h !i ask = ask (V3 (indexPrimArray (centresX h) i) (indexPrimArray (centresY h) i) (indexPrimArray (centresZ h) i)) (indexPrimArray (radiiSquared h) i)
{-# INLINE sphereAt #-}

-- Note [Plain numbers]
-- ~~~~~~~~~~~~~~~~~~~~
-- A shape in a vector is a pointer to a constructor of some kind. Before GHC 9.0 looks at it, it puts everything that
-- the loop knows on the stack, and takes it back afterwards, since the shape might not be computed yet; then it jumps
-- by the kind. All of that takes as long as a sphere's equation. But spheres are what most small scenes are made of,
-- and they are all alike: their numbers are read from where they stand, coordinate by coordinate, so that one index
-- serves all. Most are missed, which is the first thing that is asked, and the last before the next one's turn.
--
-- The loop needs fifteen numbers at once, and a processor has room for sixteen. So the search for what is closest is a
-- function of its own ('closestInHandful'), which has no other numbers to keep; it gets the numbers of the ray and of
-- the shapes one by one (-fmax-worker-args, see Note [Numbers that travel] of "Dioptre.Render.Shade"), and makes
-- nothing.
