{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Handful
-- Description : A few shapes, tried one after the other
--
-- Boxes around only a few shapes would take as long as they save: a ray is tried on all of them. The numbers of spheres stand side by side, apart from the other shapes. See Note [Plain numbers].
module Dioptre.Geometry.Handful
  ( Handful,
    handful,
    isHandful,

    -- * Intersecting
    closestInHandful,
    foldMet,
  )
where

import Data.Primitive.PrimArray
import Data.Vector (Vector)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Closest (Closest (..), slightlyBeyond)
import Dioptre.Geometry.Prepared (Prepared, firstAhead, nearest, preparedSphere)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Geometry.Sphere (sphereClearlyMissed, sphereParametersAhead)
import Dioptre.Math.Vector (Point)
import Linear.V3 (V3 (..))

-- | Shapes, numbered from 0.
data Handful = Handful
  { -- | The centre and the squared radius of each sphere.
    spheres :: {-# UNPACK #-} !(PrimArray Double),
    -- | The spheres' numbers.
    sphereNumbers :: {-# UNPACK #-} !(PrimArray Int),
    -- | The shapes that are no spheres.
    others :: {-# UNPACK #-} !(Vector Prepared),
    -- | Their numbers.
    otherNumbers :: {-# UNPACK #-} !(PrimArray Int)
  }
  deriving stock (Eq, Show)

-- | These shapes, in the order of their numbers.
handful :: Vector Prepared -> Handful
handful shapes =
  Handful
    { spheres = primArrayFromList (concat [[x, y, z, radiusSquared] | (_, (V3 x y z, radiusSquared)) <- round']),
      sphereNumbers = primArrayFromList (map fst round'),
      others = Vector.fromList (map snd rest),
      otherNumbers = primArrayFromList (map fst rest)
    }
  where
    numbered = zip [0 ..] (Vector.toList shapes)
    round' = [(i, ball) | (i, s) <- numbered, Just ball <- [preparedSphere s]]
    rest = [(i, s) | (i, s) <- numbered, Nothing <- [preparedSphere s]]

-- | Whether there are any.
isHandful :: Handful -> Bool
isHandful h = sizeofPrimArray (spheres h) > 0 || Vector.length (others h) > 0
{-# INLINE isHandful #-}

-- | What a ray meets first, nearer than a bound.
--
-- Law: as offering every shape. Cost: an equation for each shape.
closestInHandful :: Handful -> Ray -> Double -> Closest
closestInHandful h !r = amongOthers 0 (-1)
  where
    !ends = sizeofPrimArray (spheres h)
    !count = Vector.length (others h)
    -- In the order of their numbers the first of several at one parameter is kept. Places are below the number of shapes.
    amongOthers :: Int -> Int -> Double -> Closest
    amongOthers !i !number !best
      | i >= count = amongSpheres 0 number best
      | otherwise =
        let !t = nearest (Vector.unsafeIndex (others h) i) r best
         in if t < best then amongOthers (i + 1) (indexPrimArray (otherNumbers h) i) t else amongOthers (i + 1) number best
    amongSpheres :: Int -> Int -> Double -> Closest
    amongSpheres !at !number !best
      | at >= ends = Closest best number (ends `quot` 4 + count)
      | sphereAt h at sphereClearlyMissed r = amongSpheres (at + 4) number best
      | otherwise =
        let !t = firstAhead (sphereAt h at sphereParametersAhead r) (slightlyBeyond best)
            !mine = indexPrimArray (sphereNumbers h) (at `quot` 4)
         in if t < best || (t == best && mine < number) then amongSpheres (at + 4) mine t else amongSpheres (at + 4) number best
{-# INLINE closestInHandful #-}

-- | Goes through the shapes that a ray meets nearer than a bound, in a fixed order: for each, what to do with its number and the result so far, given how many shapes have been tried
-- and how to go on.
foldMet :: Handful -> Ray -> Double -> (Int -> Int -> a -> (a -> b) -> b) -> (Int -> a -> b) -> a -> b
foldMet h !r !bound each end = amongSpheres 0
  where
    !ends = sizeofPrimArray (spheres h)
    !count = Vector.length (others h)
    amongSpheres !at a
      | at >= ends = amongOthers 0 a
      | sphereAt h at sphereClearlyMissed r = amongSpheres (at + 4) a
      | firstAhead (sphereAt h at sphereParametersAhead r) bound < bound = each (at `quot` 4 + 1) (indexPrimArray (sphereNumbers h) (at `quot` 4)) a (amongSpheres (at + 4))
      | otherwise = amongSpheres (at + 4) a
    amongOthers !i a
      | i >= count = end (ends `quot` 4 + count) a
      -- Places are below the number of shapes.
      | nearest (Vector.unsafeIndex (others h) i) r bound < bound = each (ends `quot` 4 + i + 1) (indexPrimArray (otherNumbers h) i) a (amongOthers (i + 1))
      | otherwise = amongOthers (i + 1) a
{-# INLINE foldMet #-}

-- | Asks something of the sphere whose four numbers begin there.
sphereAt :: Handful -> Int -> (Point -> Double -> a) -> a
sphereAt h !at ask = ask (V3 (number 0) (number 1) (number 2)) (number 3)
  where
    number k = indexPrimArray (spheres h) (at + k)
{-# INLINE sphereAt #-}

-- Note [Plain numbers]
-- ~~~~~~~~~~~~~~~~~~~~
-- A shape in a vector is a pointer to a constructor of some kind. Before GHC 9.0 looks at it, it puts everything that the loop knows on the stack, and takes it back afterwards, since the
-- shape might not be computed yet; then it jumps by the kind. All of that takes as long as a sphere's equation. But spheres are what most small scenes are made of, and they are all alike: their
-- numbers are read from where they stand, and the loop stays in the registers. Most are missed, which is the first thing that is asked, and the last before the next one's turn.
