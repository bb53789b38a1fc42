{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Prepared
-- Description : Shapes made ready for many rays
--
-- What the inner loop reads: of each shape the numbers that its rule names, computed once and stored flat (unit normals, squared radii,
-- half sizes). The rules themselves are those of the shapes' modules, inlined here with the same order of operations, so a prepared
-- shape is hit at the same parameters as a plain one, to the bit (a law).
--
-- There is one dispatcher, 'parameters', and it returns a list. The list costs nothing: one 'build' stands outside the case, every rule
-- is a good producer, and consumers are folds, so that no cell of it is ever made. See Note [Lists that vanish].
module Dioptre.Geometry.Prepared
  ( -- * Preparing
    Prepared,
    prepare,

    -- * Intersecting
    parameters,
    nearest,
    normalAt,
    shadingNormal,
    textureAt,

    -- * Inside and outside
    isClosed,
    contains,
  )
where

import Dioptre.Geometry.Cube (cubeCentre, cubeContains, cubeNormal, cubeParameters, cubeSize)
import Dioptre.Geometry.Disk (annulusInner, annulusOuter, annulusParameters, annulusPlane, diskParameters, diskPlane, diskRadius)
import Dioptre.Geometry.Plane (Plane, planeNormal, planeParameters, planePosition)
import Dioptre.Geometry.Ray (Ray, direction, position)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereContains, sphereNormal, sphereParameters, sphereRadius)
import Dioptre.Geometry.Triangle (Corners (..), Triangle, barycentric, interpolatedNormal, smoothTriangleFlat, smoothTriangleNormals, triangleNormal, triangleParameters, trianglePoints)
import Dioptre.Math.Tolerance (smallestParameter)
import Dioptre.Math.Vector (Packed, Point, Unit, dot, opposite, packed, packedUnit, unit, unpacked, unpackedUnit, vector)
import GHC.Exts (build)
import Linear.V2 (V2)

-- | A shape that rays can meet, as plain numbers.
data Prepared
  = -- | Position, unit normal.
    Plane {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed
  | -- | Centre, unit normal, radius.
    Disk {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Double
  | -- | Centre, unit normal, inner and outer radius.
    Annulus {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | Centre, squared radius.
    Sphere {-# UNPACK #-} !Packed {-# UNPACK #-} !Double
  | -- | Centre, half size.
    Cube {-# UNPACK #-} !Packed {-# UNPACK #-} !Double
  | -- | Three corners, unit normal.
    Triangle {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed
  | -- | Three corners, unit normal, the corners' unit normals.
    SmoothTriangle {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed !(Corners Unit)
  deriving stock (Eq, Show)

-- | A shape made ready; 'Nothing' for the shapes that this version does not draw yet.
prepare :: Shape -> Maybe Prepared
prepare shape = case shape of
  APlane p -> onPlane p Plane
  ADisk d -> onPlane (diskPlane d) (\p n -> Disk p n (diskRadius d))
  AnAnnulus a -> onPlane (annulusPlane a) (\p n -> Annulus p n (annulusInner a) (annulusOuter a))
  ASphere s -> Just (Sphere (packed (sphereCentre s)) (sphereRadius s * sphereRadius s))
  ACube c -> Just (Cube (packed (cubeCentre c)) (cubeSize c / 2))
  ATriangle t -> Just (ofCorners t Triangle)
  ASmoothTriangle s ->
    let flat = triangleNormal (smoothTriangleFlat s)
        Corners n0 n1 n2 = smoothTriangleNormals s
        normalOr = maybe flat id . unit
     in Just (ofCorners (smoothTriangleFlat s) (\a b c n -> SmoothTriangle a b c n (Corners (normalOr n0) (normalOr n1) (normalOr n2))))
  ATube _ -> Nothing
  ACylinder _ -> Nothing
  ACone _ -> Nothing
  ALens _ -> Nothing
  ACap _ -> Nothing
  ATorus _ -> Nothing
  ATransformed _ _ -> Nothing

onPlane :: Plane -> (Packed -> Packed -> Prepared) -> Maybe Prepared
onPlane p make = make (packed (planePosition p)) . packedUnit <$> unit (planeNormal p)

ofCorners :: Triangle -> (Packed -> Packed -> Packed -> Packed -> a) -> a
ofCorners t make =
  let Corners a b c = trianglePoints t
   in make (packed a) (packed b) (packed c) (packedUnit (triangleNormal t))

-- | Every parameter at which a ray's line meets the shape, ascending, those behind the origin too. A line meets a closed shape where
-- it enters and where it leaves.
--
-- Law: sorted; each point lies on the shape, to rounding.
parameters :: Prepared -> Ray -> [Double]
parameters shape r = build $ \cons nil -> case shape of
  Plane p n -> foldr cons nil (planeParameters (unpacked p) (unpackedUnit n) r)
  Disk p n radius -> foldr cons nil (diskParameters (unpacked p) (unpackedUnit n) radius r)
  Annulus p n inner outer -> foldr cons nil (annulusParameters (unpacked p) (unpackedUnit n) inner outer r)
  Sphere c radiusSquared -> foldr cons nil (sphereParameters (unpacked c) radiusSquared r)
  Cube c h -> foldr cons nil (cubeParameters (unpacked c) h r)
  Triangle a b c n -> foldr cons nil (triangleParameters (unpacked a) (unpacked b) (unpacked c) (unpackedUnit n) r)
  SmoothTriangle a b c n _ -> foldr cons nil (triangleParameters (unpacked a) (unpacked b) (unpacked c) (unpackedUnit n) r)
{-# INLINE parameters #-}

-- | The first parameter at which a ray meets the shape: greater than 'smallestParameter' and less than the given bound; the bound
-- itself if there is none.
nearest :: Prepared -> Ray -> Double -> Double
nearest shape r = foldr keep id (parameters shape r)
  where
    keep t next !best = if t > smallestParameter && t < best then next t else next best
{-# INLINE nearest #-}

-- | The outward unit normal where a ray meets the shape, at a parameter that 'parameters' gave; not turned towards the ray.
normalAt :: Prepared -> Ray -> Double -> Unit
normalAt shape r t = case shape of
  Plane _ n -> unpackedUnit n
  Disk _ n _ -> unpackedUnit n
  Annulus _ n _ _ -> unpackedUnit n
  Sphere c _ -> sphereNormal (unpacked c) (position r t)
  Cube c h -> cubeNormal (unpacked c) h r t
  Triangle _ _ _ n -> unpackedUnit n
  SmoothTriangle a b c n normals ->
    interpolatedNormal (unpackedUnit n) normals (barycentric (unpacked a) (unpacked b) (unpacked c) (position r t))

-- | A normal turned against the direction in which a ray arrives: n where \<d, n> < 0, otherwise -n.
shadingNormal :: Ray -> Unit -> Unit
shadingNormal r n
  | dot (direction r) (vector n) < 0 = n
  | otherwise = opposite n

-- | The texture coordinates where a ray meets the shape, where it has any.
textureAt :: Prepared -> Ray -> Double -> Maybe (V2 Double)
textureAt _ _ _ = Nothing

-- | Whether the shape has an inside.
isClosed :: Prepared -> Bool
isClosed shape = case shape of
  Sphere _ _ -> True
  Cube _ _ -> True
  _ -> False

-- | Whether a point is inside a closed shape. A point on the surface is not.
contains :: Prepared -> Point -> Bool
contains shape p = case shape of
  Sphere c radiusSquared -> sphereContains (unpacked c) radiusSquared p
  Cube c h -> cubeContains (unpacked c) h p
  _ -> False

-- Note [Lists that vanish]
-- ~~~~~~~~~~~~~~~~~~~~~~~~
-- GHC's rule foldr k z (build g) = g k z removes a list between its producer and its consumer, if it can see both at once. Hence:
-- 'parameters' is one build, with the case inside it (a case of lists would hide the build from its consumer); each branch hands
-- its rule's list on with foldr, which meets the build of linearRoots, quadraticRoots or cubeParameters in its turn; all are
-- INLINE; and 'nearest' is a strict foldr, whose "rest of the list" is a function of the best parameter so far. What remains
-- is a chain of comparisons on unboxed numbers. A test measures that no list is allocated.
