{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Prepared
-- Description : Shapes made ready for many rays
--
-- What the inner loop reads: of each shape the numbers that its rule names, computed once and stored flat (unit
-- normals, squared radii, half sizes). The rules themselves are those of the shapes' modules, inlined here with the
-- same order of operations, so a prepared shape is hit at the same parameters as a plain one, to the bit (a law).
--
-- There is one dispatcher, 'parameters', and it returns a list. The list costs nothing: one 'build' stands outside the
-- case, every rule is a good producer, and consumers are folds, so that no cell of it is ever made. See Note [One build
-- for all shapes].
module Dioptre.Geometry.Prepared
  ( -- * Preparing
    Prepared,
    prepare,
    placedIn,
    ofTriangle,
    ofSmoothTriangle,
    preparedSphere,

    -- * Intersecting
    parameters,
    nearest,
    firstAhead,
    normalAt,
    shadingNormal,
    textureAt,

    -- * Inside and outside
    isClosed,
    contains,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Axis (Round, axisEnd, axisLength, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Cap (capCurvature, capDisk, capNormal, capParameters)
import Dioptre.Geometry.Cone (coneContains, coneNormal, coneParameters)
import Dioptre.Geometry.Cube (cubeCentre, cubeContains, cubeNormal, cubeParameters, cubeSize)
import Dioptre.Geometry.Cylinder (cylinderContains, cylinderNormal, cylinderParameters)
import Dioptre.Geometry.Disk (annulusInner, annulusOuter, annulusParameters, annulusPlane, diskParameters, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (LensPart (..), lensBody, lensContains, lensCurvatures, lensNormal, lensParameters, lensPart)
import Dioptre.Geometry.Placement (Placement, carriedBack, placement)
import Dioptre.Geometry.Plane (Plane, planeNormal, planeParameters, planePosition)
import Dioptre.Geometry.Ray (Ray, direction, position)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereContains, sphereNormal, sphereParameters, sphereParametersAhead, sphereRadius)
import Dioptre.Geometry.Torus (torusContains, torusMajor, torusMinor, torusNormal, torusParameters, torusPlane)
import Dioptre.Geometry.Triangle (Corners (..), Triangle, barycentric, interpolatedNormal, smoothTriangleFlat, smoothTriangleNormals, smoothTriangleUvs, triangleNormal, triangleParameters, trianglePoints)
import Dioptre.Geometry.Tube (tubeNormal, tubeParameters)
import Dioptre.Geometry.Uv (coneUv, cubeUv, cylinderUv, diskUv, planeUv, sideUv, sphereUv, torusUv, triangleUv)
import Dioptre.Math.Tolerance (smallestParameter)
import Dioptre.Math.Transform (inversePosition, transformNormal)
import Dioptre.Math.Vector (Packed, PackedUnit, Point, Unit, dot, opposite, packed, packedUnit, unit, unpacked, unpackedUnit, vector)
import GHC.Exts (build)
import Linear.V2 (V2)
import qualified Linear.Vector as Linear

-- | A shape that rays can meet, as plain numbers.
data Prepared
  = -- | Position, unit normal.
    Plane {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit
  | -- | Centre, unit normal, radius.
    Disk {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !Double
  | -- | Centre, unit normal, inner and outer radius.
    Annulus {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | Centre, squared radius.
    Sphere {-# UNPACK #-} !Packed {-# UNPACK #-} !Double
  | -- | Centre, half size.
    Cube {-# UNPACK #-} !Packed {-# UNPACK #-} !Double
  | -- | Three corners, unit normal.
    Triangle {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit
  | -- | Three corners, unit normal, the corners' unit normals and texture coordinates.
    SmoothTriangle {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !PackedUnit !(Corners (V2 Double))
  | Rare !Rare
  deriving stock (Eq, Show)

-- | The shapes whose rules are long: once in the program, not wherever a ray meets a shape.
data Rare
  = Tube {-# UNPACK #-} !Axial
  | Cylinder {-# UNPACK #-} !Axial
  | Cone {-# UNPACK #-} !Axial
  | -- | The rim, and the curvatures of the faces at its start and its end.
    Lens {-# UNPACK #-} !Axial {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | Centre of the disk, unit normal, radius, curvature.
    Cap {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | Centre, unit normal, major and minor radius.
    Torus {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | A shape in a frame of its own.
    Placed !Placement !Prepared
  deriving stock (Eq, Show)

-- | What shapes on an axis have: its start P1, its unit direction S, its length H, and the radius R.
data Axial = Axial {-# UNPACK #-} !Packed {-# UNPACK #-} !PackedUnit {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  deriving stock (Eq, Show)

-- | Gives a rule the numbers of an axis.
along :: Axial -> (Point -> Unit -> Double -> Double -> a) -> a
along (Axial p s h r) rule = rule (unpacked p) (unpackedUnit s) h r
{-# INLINE along #-}

-- | A shape made ready. ('Nothing' for a direction that cannot be made unit, which checked shapes do not have.)
--
-- Spec: geometry.plane.unit-normal, geometry.transformed.nested.
prepare :: Shape -> Maybe Prepared
prepare shape = case shape of
  APlane p -> onPlane p Plane
  ADisk d -> onPlane (diskPlane d) (\p n -> Disk p n (diskRadius d))
  AnAnnulus a -> onPlane (annulusPlane a) (\p n -> Annulus p n (annulusInner a) (annulusOuter a))
  ASphere s -> Just (Sphere (packed (sphereCentre s)) (sphereRadius s * sphereRadius s))
  ACube c -> Just (Cube (packed (cubeCentre c)) (cubeSize c / 2))
  ATriangle t -> Just (ofCorners t Triangle)
  ASmoothTriangle s ->
    let Corners a b c = trianglePoints (smoothTriangleFlat s)
        flat = triangleNormal (smoothTriangleFlat s)
        Corners n0 n1 n2 = fromMaybe flat . unit <$> smoothTriangleNormals s
     in Just (ofSmoothTriangle a b c flat n0 n1 n2 (smoothTriangleUvs s))
  ATube r -> Rare . Tube <$> onAxis r
  ACylinder r -> Rare . Cylinder <$> onAxis r
  ACone r -> Rare . Cone <$> onAxis r
  ALens l -> let (c1, c2) = lensCurvatures l in (\a -> Rare (Lens a c1 c2)) <$> onAxis (lensBody l)
  ACap c -> onPlane (diskPlane (capDisk c)) (\p n -> Rare (Cap p n (diskRadius (capDisk c)) (capCurvature c)))
  ATorus t -> onPlane (torusPlane t) (\p n -> Rare (Torus p n (torusMajor t) (torusMinor t)))
  ATransformed t inner -> placedIn (placement t) <$> prepare inner

-- | A prepared shape, transformed.
placedIn :: Placement -> Prepared -> Prepared
placedIn place = Rare . Placed place

-- | The flat triangle with these corners and this unit normal, which must be theirs.
ofTriangle :: Point -> Point -> Point -> Unit -> Prepared
ofTriangle a b c n = Triangle (packed a) (packed b) (packed c) (packedUnit n)
{-# INLINE ofTriangle #-}

-- | The same with unit normals at the corners, and texture coordinates.
--
-- Spec: geometry.smooth-triangle.flat-corner.
ofSmoothTriangle :: Point -> Point -> Point -> Unit -> Unit -> Unit -> Unit -> Corners (V2 Double) -> Prepared
ofSmoothTriangle a b c n n0 n1 n2 = SmoothTriangle (packed a) (packed b) (packed c) (packedUnit n) (packedUnit n0) (packedUnit n1) (packedUnit n2)
{-# INLINE ofSmoothTriangle #-}

-- | The centre and the squared radius, if it is a sphere.
preparedSphere :: Prepared -> Maybe (Point, Double)
preparedSphere shape = case shape of
  Sphere c radiusSquared -> Just (unpacked c, radiusSquared)
  _ -> Nothing

onPlane :: Plane -> (Packed -> PackedUnit -> Prepared) -> Maybe Prepared
onPlane p make = make (packed (planePosition p)) . packedUnit <$> unit (planeNormal p)

onAxis :: Round -> Maybe Axial
onAxis r = (\s -> Axial (packed start) (packedUnit s) (axisLength (roundAxis r)) (roundRadius r)) <$> unit (end - start)
  where
    start = axisStart (roundAxis r)
    end = axisEnd (roundAxis r)

ofCorners :: Triangle -> (Packed -> Packed -> Packed -> PackedUnit -> a) -> a
ofCorners t make =
  let Corners a b c = trianglePoints t
   in make (packed a) (packed b) (packed c) (packedUnit (triangleNormal t))

-- | Every parameter at which a ray's line meets the shape, ascending, those behind the origin too. A line meets a
-- closed shape where it enters and where it leaves.
--
-- Law: sorted; each point lies on the shape, to rounding.
--
-- Spec: geometry.ray.direction, geometry.ray.line, geometry.hit.finite, geometry.smooth-triangle.parameters.
parameters :: Prepared -> Ray -> [Double]
parameters shape r = build $ \cons nil -> case shape of
  Plane p n -> foldr cons nil (planeParameters (unpacked p) (unpackedUnit n) r)
  Disk p n radius -> foldr cons nil (diskParameters (unpacked p) (unpackedUnit n) radius r)
  Annulus p n inner outer -> foldr cons nil (annulusParameters (unpacked p) (unpackedUnit n) inner outer r)
  Sphere c radiusSquared -> foldr cons nil (sphereParameters (unpacked c) radiusSquared r)
  Cube c h -> foldr cons nil (cubeParameters (unpacked c) h r)
  Triangle a b c n -> foldr cons nil (triangleParameters (unpacked a) (unpacked b) (unpacked c) (unpackedUnit n) r)
  SmoothTriangle a b c n _ _ _ _ -> foldr cons nil (triangleParameters (unpacked a) (unpacked b) (unpacked c) (unpackedUnit n) r)
  Rare rare -> foldr cons nil (rareParameters rare r)
{-# INLINE parameters #-}

-- | The parameters of the rare shapes. Their lists are made; beside the arithmetic that is little.
--
-- Spec: geometry.transformed.parameters, geometry.transformed.nested.
rareParameters :: Rare -> Ray -> [Double]
rareParameters rare r = case rare of
  Tube a -> along a tubeParameters r
  Cylinder a -> along a cylinderParameters r
  Cone a -> along a coneParameters r
  Lens a c1 c2 -> along a lensParameters c1 c2 r
  Cap p n radius c -> capParameters (unpacked p) (unpackedUnit n) radius c r
  Torus p n major minor -> torusParameters (unpacked p) (unpackedUnit n) major minor r
  Placed place inner -> parameters inner (carriedBack place r)
{-# NOINLINE rareParameters #-}

-- | The first parameter at which a ray meets the shape: greater than 'smallestParameter' and less than the given bound;
-- the bound itself if there is none.
--
-- Spec: geometry.hit.smallest-parameter, geometry.hit.first, geometry.hit.none, light.shadow.itself.
nearest :: Prepared -> Ray -> Double -> Double
nearest shape r = firstAhead $ case shape of
  Sphere c radiusSquared -> sphereParametersAhead (unpacked c) radiusSquared r
  _ -> parameters shape r
{-# INLINE nearest #-}

-- | The first of some ascending parameters that is greater than 'smallestParameter' and less than a bound, or else the
-- bound.
firstAhead :: [Double] -> Double -> Double
firstAhead = foldr keep id
  where
    keep t next !best = if t > smallestParameter && t < best then next t else next best
{-# INLINE firstAhead #-}

-- | The outward unit normal where a ray meets the shape, at a parameter that 'parameters' gave; not turned towards the
-- ray.
--
-- Spec: geometry.hit.normal, geometry.triangle.both-sides.
normalAt :: Prepared -> Ray -> Double -> Unit
normalAt shape r t = case shape of
  Plane _ n -> unpackedUnit n
  Disk _ n _ -> unpackedUnit n
  Annulus _ n _ _ -> unpackedUnit n
  Sphere c _ -> sphereNormal (unpacked c) (position r t)
  Cube c h -> cubeNormal (unpacked c) h r t
  Triangle _ _ _ n -> unpackedUnit n
  SmoothTriangle a b c n n0 n1 n2 _ ->
    interpolatedNormal (unpackedUnit n) (Corners (unpackedUnit n0) (unpackedUnit n1) (unpackedUnit n2)) (barycentric (unpacked a) (unpacked b) (unpacked c) (position r t))
  Rare rare -> rareNormal rare r t
{-# INLINE normalAt #-}

-- Spec: geometry.transformed.normal.
rareNormal :: Rare -> Ray -> Double -> Unit
rareNormal rare !r !t = case rare of
  Tube a -> along a (\p1 s _ _ -> tubeNormal p1 s (position r t))
  Cylinder a -> along a cylinderNormal r t
  Cone a -> along a coneNormal r t
  Lens a c1 c2 -> along a lensNormal c1 c2 r t
  Cap p n radius c -> capNormal (unpacked p) (unpackedUnit n) radius c (position r t)
  Torus p n major minor -> torusNormal (unpacked p) (unpackedUnit n) major minor (position r t)
  Placed place inner -> transformNormal place (normalAt inner (carriedBack place r) t)
{-# NOINLINE rareNormal #-}

-- | A normal turned against the direction in which a ray arrives: n where \<d, n> < 0, otherwise -n.
--
-- Spec: geometry.hit.shading-normal.
shadingNormal :: Ray -> Unit -> Unit
{-# INLINE shadingNormal #-}
shadingNormal r n
  | dot (direction r) (vector n) < 0 = n
  | otherwise = opposite n

-- | The texture coordinates where a ray meets the shape, at a parameter that 'parameters' gave; those of a transformed
-- shape are taken in its own frame.
--
-- Spec: geometry.smooth-triangle.uv, geometry.lens.uv, geometry.transformed.uv, geometry.uv.every-shape.
textureAt :: Prepared -> Ray -> Double -> V2 Double
textureAt shape !r !t = case shape of
  Plane p n -> planeUv (unpacked p) (unpackedUnit n) v
  Disk p n radius -> diskUv (unpacked p) (unpackedUnit n) radius v
  Annulus p n _ outer -> diskUv (unpacked p) (unpackedUnit n) outer v
  Sphere c _ -> sphereUv (unpacked c) v
  Cube c h -> cubeUv (unpacked c) h outward v
  Triangle a b c _ -> triangleUv (barycentric (unpacked a) (unpacked b) (unpacked c) v)
  SmoothTriangle a b c _ _ _ _ (Corners uv0 uv1 uv2) ->
    let (t1, t2) = barycentric (unpacked a) (unpacked b) (unpacked c) v
     in (1 - t1 - t2) Linear.*^ uv0 + t1 Linear.*^ uv1 + t2 Linear.*^ uv2
  Rare (Tube a) -> along a (\p1 s h _ -> sideUv p1 s h v)
  Rare (Cylinder a) -> along a cylinderUv outward v
  Rare (Cone a) -> along a coneUv outward v
  Rare (Lens a c1 c2) -> along a $ \p1 s h radius -> case lensPart p1 s h radius c1 c2 r t of
    LensSide -> sideUv p1 s h v
    _ -> diskUv p1 s radius v
  Rare (Cap p n radius _) -> diskUv (unpacked p) (unpackedUnit n) radius v
  Rare (Torus p n major _) -> torusUv (unpacked p) (unpackedUnit n) major v
  Rare (Placed place inner) -> textureAt inner (carriedBack place r) t
  where
    v = position r t
    outward = normalAt shape r t

-- | Whether the shape has an inside.
--
-- Spec: geometry.contains.closed, optics.body.closed.
isClosed :: Prepared -> Bool
isClosed shape = case shape of
  Sphere _ _ -> True
  Cube _ _ -> True
  Rare (Cylinder _) -> True
  Rare (Cone _) -> True
  Rare (Lens {}) -> True
  Rare (Torus {}) -> True
  Rare (Placed _ inner) -> isClosed inner
  Plane _ _ -> False
  Disk {} -> False
  Annulus {} -> False
  Triangle {} -> False
  SmoothTriangle {} -> False
  Rare (Tube _) -> False
  Rare (Cap {}) -> False

-- | Whether a point is inside a closed shape. A point on the surface is not.
--
-- Spec: geometry.transformed.contains, geometry.contains.closed, geometry.contains.surface, optics.medium.model.
contains :: Prepared -> Point -> Bool
contains shape p = case shape of
  Sphere c radiusSquared -> sphereContains (unpacked c) radiusSquared p
  Cube c h -> cubeContains (unpacked c) h p
  Rare (Cylinder a) -> along a cylinderContains p
  Rare (Cone a) -> along a coneContains p
  Rare (Lens a c1 c2) -> along a lensContains c1 c2 p
  Rare (Torus c n major minor) -> torusContains (unpacked c) (unpackedUnit n) major minor p
  Rare (Placed place inner) -> contains inner (inversePosition place p)
  Plane _ _ -> False
  Disk {} -> False
  Annulus {} -> False
  Triangle {} -> False
  SmoothTriangle {} -> False
  Rare (Tube _) -> False
  Rare (Cap {}) -> False

-- Note [One build for all shapes]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- (Note [Lists that vanish] of "Dioptre.Math.Roots" tells the same of one equation.)
--
-- GHC's rule foldr k z (build g) = g k z removes a list between its producer and its consumer, if it can see both at
-- once. Hence: 'parameters' is one build, with the case inside it (a case of lists would hide the build from its
-- consumer); each branch hands its rule's list on with foldr, which meets the build of linearRoots, quadraticRoots or
-- cubeParameters in its turn; all are INLINE; and 'nearest' is a strict foldr, whose "rest of the list" is a function
-- of the best parameter so far. What remains is a chain of comparisons on unboxed numbers. A test measures that no list
-- is allocated.
