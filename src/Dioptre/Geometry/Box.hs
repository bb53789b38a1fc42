{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Box
-- Description : Boxes along the axes
--
-- >        +---------+ high
-- >       /         /|                     low <= p <= high, in each coordinate, for every point p of the box
-- >      +---------+ |
-- >      |         | |         enter       leave
-- >      |         | +   o------->|--------->|---->      a ray is between a pair of faces in an interval of its parameter
-- >      |         |/
-- >  low +---------+
--
-- A box along the axes is the cheapest thing that can be asked whether a ray comes near: what the ray's index is made
-- of ("Dioptre.Geometry.Hierarchy"). Its answer may be yes where it should be no, and never the other way round: the
-- test is exact up to rounding, and rounding is allowed for ('meets', Note [Slack of the slabs]).
--
-- Sources:
--
-- * Th. Ize, /Robust BVH Ray Traversal/, JCGT 2(2) (2013), <https://jcgt.org/published/0002/02/02/>: the slack, and
--   what becomes of NaN.
-- * J. Arvo, /Transforming Axis-Aligned Bounding Boxes/, Graphics Gems (1990).
module Dioptre.Geometry.Box
  ( -- * Boxes
    Box,
    box,
    boxLow,
    boxHigh,
    boxFace,

    -- * Around something
    around,
    ofPoints,
    union,
    enlarged,
    transformed,

    -- * Rays
    Approach,
    approach,
    runsDown,
    meets,
  )
where

import Data.List (foldl')
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Math.Order (larger, smaller)
import Dioptre.Math.Tolerance (boxGrowth, cornerSlack, slabSlack)
import Dioptre.Math.Transform (Placement, transformPosition)
import Dioptre.Math.Vector (Packed, Point, packed, unpacked)
import Linear.V3 (V3 (..))

-- | The points between two corners, in each coordinate; faces, edges and corners belong to it.
data Box = Box {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed
  deriving stock (Eq, Show)

-- | The box from its low corner to its high one; 'Nothing' unless low <= high in each coordinate.
box :: Point -> Point -> Maybe Box
box low high
  | and ((<=) <$> low <*> high) = Just (Box (packed low) (packed high))
  | otherwise = Nothing

-- | The corner with the least coordinates.
boxLow :: Box -> Point
boxLow (Box low _) = unpacked low
{-# INLINE boxLow #-}

-- | The corner with the greatest coordinates.
boxHigh :: Box -> Point
boxHigh (Box _ high) = unpacked high
{-# INLINE boxHigh #-}

-- | The six numbers of a box: low x, y, z, high x, y, z, by their places from 0 to 5.
boxFace :: Box -> Int -> Double
boxFace b k = case k of
  0 -> lx
  1 -> ly
  2 -> lz
  3 -> hx
  4 -> hy
  _ -> hz
  where
    V3 lx ly lz = boxLow b
    V3 hx hy hz = boxHigh b

-------------------------------------------------------------------------------
-- Around something

-- | The box of points that stay within an extent of a point, in each coordinate.
around :: Point -> V3 Double -> Box
around p extent = spanned (p - extent) (p + extent)

-- | The least box that holds two.
--
-- Laws: commutative, associative, idempotent; it holds what either holds.
union :: Box -> Box -> Box
union a b = spanned (smaller <$> boxLow b <*> boxLow a) (larger <$> boxHigh b <*> boxHigh a)
{-# INLINE union #-}

-- | The least box that holds a point and others.
ofPoints :: Point -> [Point] -> Box
ofPoints p = foldl' (\b q -> b `union` spanned q q) (spanned p p)

-- | A box from corners that are known to be in order.
spanned :: Point -> Point -> Box
spanned low high = Box (packed low) (packed high)
{-# INLINE spanned #-}

-- | A box that is larger by 2^-20 of its longest edge, and by 2^-48 of its largest coordinate, in every direction. Flat
-- boxes get a thickness. See Note [How much larger] of "Dioptre.Geometry.Bounds".
enlarged :: Box -> Box
enlarged b = spanned (subtract slack <$> boxLow b) ((+ slack) <$> boxHigh b)
  where
    slack = boxGrowth * foldr largest 0 (boxHigh b - boxLow b) + cornerSlack * foldr largest (foldr largest 0 (boxLow b)) (boxHigh b)
    largest = flip larger . abs

-- | A box that holds what becomes of a box: around its eight corners, and a little larger.
transformed :: Placement -> Box -> Box
transformed m b = enlarged (ofPoints (corner V3 boxLow boxLow boxLow) [corner V3 i j k | i <- ends, j <- ends, k <- ends])
  where
    ends = [boxLow, boxHigh]
    corner make i j k = transformPosition m (make (x (i b)) (y (j b)) (z (k b)))
    x (V3 c _ _) = c
    y (V3 _ c _) = c
    z (V3 _ _ c) = c

-------------------------------------------------------------------------------
-- Rays

-- | A ray made ready to be tested against many boxes: its origin; one over each component of its direction, and the
-- same a little larger; and the place, in the six numbers of a box, of the face that it meets first in each coordinate.
data Approach = Approach {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Int
  deriving stock (Eq, Show)

-- | A ray made ready. Where a component of the direction is zero, its reciprocal is infinite: 'meets' knows.
approach :: Ray -> Approach
approach r = Approach (packed (origin r)) (packed i) (packed (wider <$> i)) (face 0 ix) (face 1 iy) (face 2 iz)
  where
    i@(V3 ix iy iz) = recip <$> direction r
    wider :: Double -> Double
    wider c = c * (1 + slabSlack)
    face :: Int -> Double -> Int
    face k c = if c >= 0 then k else k + 3
{-# INLINE approach #-}

-- | Whether the ray runs towards lower values of a coordinate (0, 1, 2 for x, y, z).
runsDown :: Approach -> Int -> Bool
runsDown (Approach _ _ _ fx fy fz) coordinate = case coordinate of
  0 -> fx >= 3
  1 -> fy >= 3
  _ -> fz >= 3
{-# INLINE runsDown #-}

-- | Whether a ray comes into a box, not beyond the given parameter. The box is given as six numbers, by their places:
-- low x, y, z, high x, y, z.
--
-- Laws: if o + t d is in the box for some t from 0 to the given parameter, exactly, then it says so. If it says so, the
-- ray meets the box when that is enlarged by some 2^-48 of its distance.
--
-- Cost: six products, and comparisons of which a box that is met takes all, and one that is missed hardly ever more
-- than half. See Note [Comparing in pairs].
meets :: Approach -> (Int -> Double) -> Double -> Bool
meets (Approach o i j fx fy fz) face !far
  | enterX > leaveY || enterY > leaveX = False
  | enterX > leaveZ || enterZ > leaveX = False
  | enterY > leaveZ || enterZ > leaveY = False
  | enterX > bound || enterY > bound || enterZ > bound = False
  | otherwise = not (leaveX < 0 || leaveY < 0 || leaveZ < 0)
  where
    !(V3 ox oy oz) = unpacked o
    !(V3 ix iy iz) = unpacked i
    !(V3 jx jy jz) = unpacked j
    !enterX = (face fx - ox) * ix
    !leaveX = (face (3 - fx) - ox) * jx
    !enterY = (face fy - oy) * iy
    !leaveY = (face (5 - fy) - oy) * jy
    !enterZ = (face fz - oz) * iz
    !leaveZ = (face (7 - fz) - oz) * jz
    !bound = far * (1 + slabSlack)
{-# INLINE meets #-}

-- Note [Comparing in pairs]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~
-- Between the two faces of one coordinate a ray is in an interval of its parameter; it is in the box where all three
-- intervals and [0, far] overlap. The usual program takes the greatest of the entries and the least of the exits, and
-- compares these two: each of the four choices is a branch that goes either way as often as not, and a processor that
-- guesses wrong loses the time of the whole test. Intervals of a line overlap all together if they overlap two by two
-- (Helly's theorem in one dimension), and so the test asks of each entry whether it is beyond each other exit. All of
-- these branches go one way until one of them ends the test.
--
-- The entry and the exit of one and the same coordinate need no comparison: the box's corners are in order.
--
-- Note [Slack of the slabs]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~
-- The parameter at which a ray crosses a face, (l - o) / d, is computed as (l - o) * (1 / d): three roundings, a
-- relative error of at most 3.01 eps, eps = 2^-53. If the ray is in the box at some t with 0 <= t <= far, then exactly
-- entry_i <= t <= exit_j for all i and j, and t >= 0; and as computed
--
--   entry_i <= max 0 (t (1 + 3.01 eps)),  t (1 - 3.01 eps) <= exit_j.
--
-- Exits are computed with reciprocals that are larger by the factor 1 + 8 eps, which takes one more rounding:
--
--   exit_j >= t (1 - 4.01 eps) (1 + 8 eps) > t (1 + 3.9 eps) > t (1 + 3.01 eps) >= entry_i,
--
-- and far gets the same factor. (Ize uses the single factor 1 + 2 gamma(3) for the same reason.) An exit's sign is
-- exact, and so is the answer to whether the box is behind.
--
-- If d = 0, the reciprocal is infinite, of either sign. The products are then infinite and say, correctly, that the ray
-- is between the faces always or never; or NaN, for a ray along a face, for which every comparison is false, so that it
-- takes nothing away: a ray along a face is between the pair. Where 1 / d overflows, |d| < 2^-1024, the ray counts as
-- one with d = 0; no scene reaches the parameters where it would tell.
