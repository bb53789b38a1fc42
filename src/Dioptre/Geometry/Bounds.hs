-- |
-- Module      : Dioptre.Geometry.Bounds
-- Description : Boxes around shapes
--
-- >        +---------+ high
-- >       /  .---.  /|        low <= p <= high, in each coordinate, for every point p of the shape
-- >      +--/-----\+ |
-- >      | |       | |
-- >      | |       | +
-- >      |  \     /|/
-- >  low +---`---'-+
--
-- A ray that misses the box misses the shape. The boxes are a little larger than their shapes ('enlarged'), so that
-- this holds of what is computed, too: see Note [How much larger].
--
-- Source: I. Quilez, /Bounding box for disks, cylinders and cones/, <https://iquilezles.org/articles/diskbbox/>: the
-- disk's extents.
module Dioptre.Geometry.Bounds
  ( ofShape,

    -- * Shape by shape
    ofSphere,
    ofCube,
    ofTriangle,
    ofDisk,
    ofTube,
    ofCone,
    ofTorus,
    ofCap,
    ofLens,
  )
where

import Dioptre.Geometry.Axis (axisEnd, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Box (Box, around, enlarged, ofPoints, transformed, union)
import Dioptre.Geometry.Cap (capCurvature, capDisk, faceDepth)
import Dioptre.Geometry.Cube (cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (annulusOuter, annulusPlane, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (lensBody, lensCurvatures)
import Dioptre.Geometry.Plane (planeNormal, planePosition)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (torusMajor, torusMinor, torusPlane)
import Dioptre.Geometry.Triangle (Corners (..), smoothTriangleFlat, trianglePoints)
import Dioptre.Math.Order (larger)
import Dioptre.Math.Transform (placement)
import Dioptre.Math.Vector (Point, Unit, unit, vector, (*^))
import Linear.V3 (V3 (..))

-- | The box of a shape; 'Nothing' for a plane, which has no end.
ofShape :: Shape -> Maybe Box
ofShape shape = case shape of
  APlane _ -> Nothing
  ADisk d -> onDisk d
  AnAnnulus a -> (\n -> ofDisk (planePosition (annulusPlane a)) n (annulusOuter a)) <$> unit (planeNormal (annulusPlane a))
  ASphere s -> Just (ofSphere (sphereCentre s) (sphereRadius s))
  ACube c -> Just (ofCube (cubeCentre c) (cubeSize c / 2))
  ATriangle t -> Just (onCorners t)
  ASmoothTriangle s -> Just (onCorners (smoothTriangleFlat s))
  ATube r -> Just (onAxis r ofTube)
  ACylinder r -> Just (onAxis r ofTube)
  ACone r -> Just (onAxis r ofCone)
  ALens l -> Just (onAxis (lensBody l) (\p1 p2 radius -> ofLens p1 p2 radius (lensCurvatures l)))
  ACap c -> (\n -> ofCap (planePosition (diskPlane (capDisk c))) n (diskRadius (capDisk c)) (capCurvature c)) <$> unit (planeNormal (diskPlane (capDisk c)))
  ATorus t -> (\n -> ofTorus (planePosition (torusPlane t)) n (torusMajor t) (torusMinor t)) <$> unit (planeNormal (torusPlane t))
  ATransformed t inner -> transformed (placement t) <$> ofShape inner
  where
    onDisk d = (\n -> ofDisk (planePosition (diskPlane d)) n (diskRadius d)) <$> unit (planeNormal (diskPlane d))
    onCorners t = let Corners a b c = trianglePoints t in ofTriangle a b c
    onAxis r make = make (axisStart (roundAxis r)) (axisEnd (roundAxis r)) (roundRadius r)

-- | How far a disk reaches from its centre along each axis: R sqrt (1 - n_i^2). (The axis less its part along n has
-- that length, and points to the farthest point.)
reach :: Unit -> Double -> V3 Double
reach n radius = (\c -> radius * sqrt (larger ((1 - c) * (1 + c)) 0)) <$> vector n

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
ofCone p1 p2 radius = enlarged (around p1 extent `union` ofPoints p2 [])
  where
    extent = maybe (pure radius) (`reach` radius) (unit (p2 - p1))

-- | Of the torus around P with axis n and radii R and r: its circle's, and r more on every side.
ofTorus :: Point -> Unit -> Double -> Double -> Box
ofTorus p n major minor = enlarged (around p ((+ minor) <$> reach n major))

-- | Of the cap over the disk around P with normal n and radius R, with signed radius of curvature c: the disk's, and
-- that of the disk moved to the cap's top.
ofCap :: Point -> Unit -> Double -> Double -> Box
ofCap p n radius curvature = enlarged (around p extent `union` around (p + faceDepth radius curvature *^ vector n) extent)
  where
    extent = reach n radius

-- | Of the lens from P1 to P2 with radius R and signed radii of curvature c1 and c2: the cylinder's between the tops of
-- the faces that bulge outwards.
ofLens :: Point -> Point -> Double -> (Double, Double) -> Box
ofLens p1 p2 radius (c1, c2) = case unit (p2 - p1) of
  Just s -> ofTube (p1 - bulge c1 *^ vector s) (p2 + bulge c2 *^ vector s) radius
  Nothing -> ofTube p1 p2 radius
  where
    bulge c = larger (faceDepth radius c) 0

-- Note [How much larger]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- A point of a sphere, as it is computed, is on a sphere whose squared radius is off by the rounding of |w|^2, w being
-- the way from the centre to the ray's origin (Dioptre.Geometry.Sphere, Note [Far spheres]): the radius by 2^-53 (|w| /
-- R)^2 of itself, and the point by 2^-52 |w| more when it is computed from its parameter. For |w| = 2^14 R that is
-- 2^-25 R and 2^-38 R. All other shapes do better. A box that is larger by 2^-20 of its longest edge thus holds every
-- point as it is computed, from up to 2^14 sizes away, and meets a millionth more rays, which costs nothing.
--
-- The second term is for shapes far from the origin of the world: the corners themselves are sums, rounded by 2^-53 of
-- the coordinates.
