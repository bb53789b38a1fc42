{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE HexFloatLiterals #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Bounds
-- Description : Boxes around shapes
--
-- >        +---------+ high
-- >       /  .---.  /|                     low <= p <= high, in each coordinate, for every point p of the shape
-- >      +--/-----\+ |
-- >      | |       | |         enter       leave
-- >      | |       | +   o------->|--------->|---->      a ray is between a pair of faces in an interval of its parameter
-- >      |  \     /|/
-- >  low +---`---'-+
--
-- A box along the axes is the cheapest thing that can be asked whether a ray comes near a shape: what the ray's index is made of. A box may say yes
-- where its shape says no, and never the other way round. Hence two kinds of slack:
--
-- * The boxes of shapes are a little larger than the shapes: by 2^-20 of their size, to which a point on the shape, as it is computed, keeps from rays that start up to
--   some thousand sizes away. See Note [How much larger].
-- * The test of a ray is exact up to rounding, and rounding is allowed for: 'entry', Note [Slack of the slabs].
--
-- Sources:
--
-- * Th. Ize, /Robust BVH Ray Traversal/, JCGT 2(2) (2013), <https://jcgt.org/published/0002/02/02/>: the slack, and what becomes of NaN.
-- * J. Arvo, /Transforming Axis-Aligned Bounding Boxes/, Graphics Gems (1990).
-- * I. Quilez, /Bounding box for disks, cylinders and cones/, <https://iquilezles.org/articles/diskbbox/>: the disk's extents.
module Dioptre.Geometry.Bounds
  ( -- * Boxes
    Box,
    box,
    boxLow,
    boxHigh,
    boxHolds,
    boxCentre,
    boxArea,

    -- * Together
    union,
    ofPoints,
    transformed,
    enlarged,

    -- * Boxes of shapes
    ofSphere,
    ofCube,
    ofTriangle,
    ofDisk,
    ofTube,
    ofCone,
    ofTorus,
    ofCap,
    ofLens,

    -- * Rays
    Approach,
    approach,
    entry,
  )
where

import Data.List (foldl')
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Geometry.Round (faceDepth)
import Dioptre.Math.Transform (Placement, transformPosition)
import Dioptre.Math.Vector (Packed, Point, Unit, packed, unit, unpacked, vector, (*^))
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

-- | Whether a point is in a box, or on its surface.
boxHolds :: Box -> Point -> Bool
boxHolds b p = and ((<=) <$> boxLow b <*> p) && and ((<=) <$> p <*> boxHigh b)

-- | The point in the middle.
boxCentre :: Box -> Point
boxCentre b = (\low high -> 0.5 * low + 0.5 * high) <$> boxLow b <*> boxHigh b
{-# INLINE boxCentre #-}

-- | The area of its six faces. (Of the lines that pass through a convex body, the share that also passes through another inside it is the ratio of their areas.)
boxArea :: Box -> Double
boxArea b = 2 * ((x * y + y * z) + z * x)
  where
    V3 x y z = boxHigh b - boxLow b
{-# INLINE boxArea #-}

-- | The least box that holds two.
--
-- Laws: commutative, associative, idempotent; it holds what either holds.
union :: Box -> Box -> Box
union a b = spanned (lower <$> boxLow a <*> boxLow b) (upper <$> boxHigh a <*> boxHigh b)
{-# INLINE union #-}

-- | The least box that holds a point and others.
ofPoints :: Point -> [Point] -> Box
ofPoints p = foldl' (\b q -> b `union` spanned q q) (spanned p p)

-- | A box from corners that are known to be in order.
spanned :: Point -> Point -> Box
spanned low high = Box (packed low) (packed high)
{-# INLINE spanned #-}

lower, upper :: Double -> Double -> Double
lower x y = if y < x then y else x
upper x y = if y > x then y else x
{-# INLINE lower #-}
{-# INLINE upper #-}

-- | A box that holds what becomes of a box: around its eight corners, and a little larger.
transformed :: Placement -> Box -> Box
transformed m b = enlarged (ofPoints (corner V3 boxLow boxLow boxLow) [corner V3 i j k | i <- ends, j <- ends, k <- ends])
  where
    ends = [boxLow, boxHigh]
    corner make i j k = transformPosition m (make (x (i b)) (y (j b)) (z (k b)))
    x (V3 c _ _) = c
    y (V3 _ c _) = c
    z (V3 _ _ c) = c

-- | A box that is larger by 2^-20 of its longest edge, and by 2^-48 of its largest coordinate, in every direction. Boxes of flat shapes get a thickness.
enlarged :: Box -> Box
enlarged b = spanned (subtract slack <$> boxLow b) ((+ slack) <$> boxHigh b)
  where
    slack = 0x1p-20 * foldr upper 0 (boxHigh b - boxLow b) + 0x1p-48 * foldr (upper . abs) (foldr (upper . abs) 0 (boxLow b)) (boxHigh b)

-------------------------------------------------------------------------------
-- Boxes of shapes

-- | The box of points that stay within an extent of a point, in each coordinate.
around :: Point -> V3 Double -> Box
around p extent = spanned (p - extent) (p + extent)

-- | How far a disk reaches from its centre along each axis: R sqrt (1 - n_i^2). (The axis less its part along n has that length, and points to the farthest point.)
reach :: Unit -> Double -> V3 Double
reach n radius = (\c -> radius * sqrt (upper 0 ((1 - c) * (1 + c)))) <$> vector n

-- | Of the sphere around C with radius R.
ofSphere :: Point -> Double -> Box
ofSphere c radius = enlarged (around c (pure radius))

-- | Of the cube around C with half size h.
ofCube :: Point -> Double -> Box
ofCube c h = enlarged (around c (pure h))

-- | Of the triangle with these corners, smooth or flat.
ofTriangle :: Point -> Point -> Point -> Box
ofTriangle a b c = enlarged (ofPoints a [b, c])

-- | Of the disk around P with normal n and radius R, or the annulus with that outer radius.
ofDisk :: Point -> Unit -> Double -> Box
ofDisk p n radius = enlarged (around p (reach n radius))

-- | Of the tube from P1 to P2 with radius R, or the cylinder: its two disks'.
ofTube :: Point -> Point -> Double -> Box
ofTube p1 p2 radius = enlarged (around p1 extent `union` around p2 extent)
  where
    extent = maybe (pure radius) (`reach` radius) (unit (p2 - p1))

-- | Of the cone with a base of radius R around P1 and the apex P2.
ofCone :: Point -> Point -> Double -> Box
ofCone p1 p2 radius = enlarged (around p1 extent `union` spanned p2 p2)
  where
    extent = maybe (pure radius) (`reach` radius) (unit (p2 - p1))

-- | Of the torus around P with axis n and radii R and r: its circle's, and r more on every side.
ofTorus :: Point -> Unit -> Double -> Double -> Box
ofTorus p n major minor = enlarged (around p ((+ minor) <$> reach n major))

-- | Of the cap over the disk around P with normal n and radius R, with signed radius of curvature c: the disk's, and that of the disk moved to the cap's top.
ofCap :: Point -> Unit -> Double -> Double -> Box
ofCap p n radius curvature = enlarged (around p extent `union` around (p + faceDepth radius curvature *^ vector n) extent)
  where
    extent = reach n radius

-- | Of the lens from P1 to P2 with radius R and signed radii of curvature c1 and c2: the cylinder's between the tops of the faces that bulge outwards.
ofLens :: Point -> Point -> Double -> (Double, Double) -> Box
ofLens p1 p2 radius (c1, c2) = case unit (p2 - p1) of
  Just s -> ofTube (p1 - bulge c1 *^ vector s) (p2 + bulge c2 *^ vector s) radius
  Nothing -> ofTube p1 p2 radius
  where
    bulge c = upper 0 (faceDepth radius c)

-------------------------------------------------------------------------------
-- Rays

-- | A ray made ready to be tested against many boxes: its origin, and one over each component of its direction.
data Approach = Approach {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed
  deriving stock (Eq, Show)

-- | A ray made ready. Where a component of the direction is zero, its reciprocal is infinite: 'entry' knows.
approach :: Ray -> Approach
approach r = Approach (packed (origin r)) (packed (recip <$> direction r))
{-# INLINE approach #-}

-- | Where a ray enters a box, or 0 if it starts inside; infinity if it misses the box, or enters it beyond the given parameter.
--
-- Law: if o + t d is in the box for some t from 0 to the given parameter, exactly, then the answer is at most t. It is at most 2^-49 of itself less than the exact parameter.
--
-- Cost: six products, and comparisons.
entry :: Approach -> Box -> Double -> Double
entry (Approach o i) b !far
  | enter <= leave * 0x1.0000000000004p0 = enter * 0x0.ffffffffffffcp0
  | otherwise = 1 / 0
  where
    !(V3 ox oy oz) = unpacked o
    !(V3 ix iy iz) = unpacked i
    !(V3 lx ly lz) = boxLow b
    !(V3 hx hy hz) = boxHigh b
    !enter = near lx hx ox ix (near ly hy oy iy (near lz hz oz iz 0))
    !leave = distant lx hx ox ix (distant ly hy oy iy (distant lz hz oz iz far))
    -- Written so that a NaN, 0 times infinity, changes nothing: a ray along a face is between the pair.
    near l h p q !before = let !t = (if q >= 0 then l - p else h - p) * q in if t > before then t else before
    distant l h p q !before = let !t = (if q >= 0 then h - p else l - p) * q in if t < before then t else before
    {-# INLINE near #-}
    {-# INLINE distant #-}
{-# INLINE entry #-}

-- Note [How much larger]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- A point of a sphere, as it is computed, is on a sphere whose squared radius is off by the rounding of |w|^2, w being the way from the centre to the ray's origin (Dioptre.Geometry.Sphere,
-- Note [Far spheres]): the radius by 2^-53 (|w| / R)^2 of itself, and the point by 2^-52 |w| more when it is computed from its parameter. For |w| = 2^14 R that is
-- 2^-25 R and 2^-38 R. All other shapes do better. A box that is larger by 2^-20 of its longest edge thus holds every point as it is computed, from up to 2^14 sizes away, and meets a
-- millionth more rays, which costs nothing.
--
-- The second term is for shapes far from the origin of the world: the corners themselves are sums, rounded by 2^-53 of the coordinates.

-- Note [Slack of the slabs]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~
-- The parameter at which a ray crosses a face, (l - o) / d, is computed as (l - o) * (1 / d): three roundings, a relative error of at most 3.01 eps, eps = 2^-53. The greatest entry and the least exit
-- are values so computed, each not below or above the exact one by more than that part. If the ray is in the box somewhere ahead, then 0 <= enter <= leave exactly, and as computed
--
--   enter (1 - 3.01 eps) <= leave (1 + 3.01 eps), hence enter <= leave (1 + 6.1 eps).
--
-- The factor is 1 + 8 eps, whose product may be rounded down by one: 7 are left. Entries are given 3.01 eps less than they are computed, and that is rounded, too: 1 - 8 eps
-- leaves room. (Ize uses the single factor 1 + 2 gamma(3) for the same reason.)
--
-- If d = 0, the reciprocal is infinite, of either sign. The products are then infinite and say, correctly, that the ray is between the faces always or never; or NaN, for a ray along a
-- face, which no comparison takes. Where 1 / d overflows, |d| < 2^-1024, the ray counts as one with d = 0; no scene reaches the parameters where it would tell.
