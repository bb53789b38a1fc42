-- |
-- Module      : Dioptre.Geometry.Uv
-- Description : Where a point of a surface is on a picture
--
-- >    0 ----- u -----> 1          w = v - centre, n the normal or the axis,
-- >    |                           e1, e2 across it:
-- >    v      e2
-- >    |      ^                          n
-- >    V      |                          |
-- >    1      +---> e1                   +--- e2      e2 = n x e1
-- >                                     /
-- >                                    e1
--
-- Each point of a surface has a pair (u, v). From 0 to 1 it runs over the picture that is laid on the surface, u to the
-- right and v down; what is beyond repeats ('wrapped'). Flat parts lie on the picture as they are, with their diameter
-- as the width of the picture (a plane: its unit of length); round ones are unrolled, u being the angle about the axis.
module Dioptre.Geometry.Uv
  ( -- * Flat parts
    planeUv,
    diskUv,

    -- * Round parts
    sphereUv,
    sideUv,
    torusUv,

    -- * Whole shapes
    cylinderUv,
    coneUv,
    cubeUv,
    triangleUv,

    -- * The picture
    wrapped,

    -- * The frame
    frame,
  )
where

import Dioptre.Geometry.Cone (isFlatCone)
import Dioptre.Geometry.Tube (across)
import Dioptre.Math.Vector (Point, Unit, Vector, alongX, alongY, alongZ, cross, dot, modulus, opposite, unit, vector, (*^))
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | Two unit vectors across n, which together with it are a right-handed frame: e1 is the axis of n's smallest
-- component (by magnitude; the first on ties) less its part along n, made unit, and e2 = n x e1.
--
-- >>> frame alongZ
-- (V3 1.0 0.0 0.0,V3 0.0 1.0 0.0)
--
-- Spec: geometry.uv.frame.
frame :: Unit -> (Vector, Vector)
frame n = (e1, cross v e1)
  where
    v@(V3 x y z) = vector n
    nearestAcross
      | abs x <= abs y && abs x <= abs z = alongX
      | abs y <= abs z = alongY
      | otherwise = alongZ
    along = vector nearestAcross
    -- The smallest component is at most 1/sqrt 3, so what is left is never zero.
    e1 = maybe along vector (unit (along - dot along v *^ v))

-- | On the plane through P with unit normal n: (\<w, e1>, -\<w, e2>).
--
-- Spec: geometry.plane.uv.
planeUv :: Point -> Unit -> Point -> V2 Double
planeUv p n v = V2 (dot w e1) (negate (dot w e2))
  where
    w = v - p
    (e1, e2) = frame n

-- | On what lies over a disk around P with unit normal n and radius R: (1\/2 + \<w, e1>\/2R, 1\/2 - \<w, e2>\/2R). So
-- on the disk itself, the annulus (R being the outer radius), the spherical cap, and the ends of cylinder and cone.
--
-- Spec: geometry.disk.uv, geometry.lens.uv.
diskUv :: Point -> Unit -> Double -> Point -> V2 Double
diskUv p n radius v = V2 (0.5 + a / (2 * radius)) (0.5 + b / (2 * radius))
  where
    V2 a b = planeUv p n v

-- | On the sphere around C: with (x, y, z) the unit normal, u = 1\/2 + atan2(z, x)\/2pi, and v = atan2(sqrt(x^2 + z^2),
-- y)\/pi, from 0 at the top (+y) to 1 at the bottom.
--
-- >>> sphereUv (V3 0 0 0) (V3 0 2 0)
-- V2 0.5 0.0
--
-- Spec: numbers.elementary, geometry.hit.centre, geometry.sphere.uv.
sphereUv :: Point -> Point -> V2 Double
sphereUv c p = V2 (0.5 + atan2 z x / (2 * pi)) (atan2 (sqrt (x * x + z * z)) y / pi)
  where
    V3 x y z = maybe (p - c) vector (unit (p - c))

-- | On the side of a tube, a cylinder or a cone from P1 along the unit axis S, of length H: u = 1\/2 + atan2(\<w, e2>,
-- \<w, e1>)\/2pi, v = 1 - h\/H, with h the height from P1. A point that rounding put beyond an end is on it: the length
-- may be less than the rounding of a position, and v would be any number.
--
-- Spec: geometry.tube.uv, geometry.lens.uv.
sideUv :: Point -> Unit -> Double -> Point -> V2 Double
sideUv p1 s h v = V2 (turn s w) (1 - height / h)
  where
    w = v - p1
    height = max 0 (min h (dot w (vector s)))

-- | On the torus around P in the plane with unit normal n, its circle of radius R: u as on a side, v = 1\/2 -
-- atan2(\<w, n>, |w_perp| - R)\/2pi.
--
-- Spec: geometry.torus.uv.
torusUv :: Point -> Unit -> Double -> Point -> V2 Double
torusUv p n major v = V2 (turn n w) (0.5 - atan2 (dot w (vector n)) (modulus (across n w) - major) / (2 * pi))
  where
    w = v - p

-- | The angle about an axis, from e1 to e2, as a part of a turn: from 0 to 1, with 1\/2 at e1.
turn :: Unit -> Vector -> Double
turn n w = 0.5 + atan2 (dot w e2) (dot w e1) / (2 * pi)
  where
    (e1, e2) = frame n

-- | On a cylinder from P1 along S, of length H and radius R, at a point with a given outward normal: an end, if the
-- normal is that end's, is a disk with that normal; the rest is the side.
--
-- Spec: geometry.cylinder.uv.
cylinderUv :: Point -> Unit -> Double -> Double -> Unit -> Point -> V2 Double
cylinderUv p1 s h radius n v
  | n == s = diskUv (p1 + h *^ vector s) s radius v
  | n == opposite s = diskUv p1 n radius v
  | otherwise = sideUv p1 s h v

-- | On a cone, at a point with a given outward normal: the base, if the normal is the base's, is a disk with that
-- normal; the rest, with the apex, is the side. The height on a flat cone ('isFlatCone') may be less than the rounding
-- of a position; there v is the same as the distance from the axis, in units of R.
--
-- Spec: geometry.cone.uv.
coneUv :: Point -> Unit -> Double -> Double -> Unit -> Point -> V2 Double
coneUv p1 s h radius n v
  | n == opposite s = diskUv p1 n radius v
  | isFlatCone h radius = V2 (turn s w) (min 1 (modulus (across s w) / radius))
  | otherwise = sideUv p1 s h v
  where
    w = v - p1

-- | On the face with a given outward normal of the cube around C with half size h: as on a disk of radius h around the
-- middle of the face.
--
-- Spec: geometry.cube.uv.
cubeUv :: Point -> Double -> Unit -> Point -> V2 Double
cubeUv c h n = diskUv (c + h *^ vector n) n h

-- | On a triangle: its barycentric coordinates (t1, t2).
triangleUv :: (Double, Double) -> V2 Double
triangleUv (t1, t2) = V2 t1 t2

-- | A coordinate brought to where the picture is: u - (ceil u - 1) for u > 0, so from above 0 to 1; u - floor u for the
-- others, so from 0 to below 1. Whole numbers above 0 become 1, the others 0, and so little below 0 that the difference
-- rounds to 1 becomes 1. Subtracting 1 from the ceiling first keeps what is in place already bit for bit.
--
-- >>> map wrapped [0.1, 1, 2, 2.25, 0, -0.25, -1, -1e-20]
-- [0.1,1.0,1.0,0.25,0.0,0.75,0.0,1.0]
--
-- Spec: geometry.uv.wrap, models.texture.texel.
wrapped :: Double -> Double
wrapped u
  | u > 0 = if u < whole then u - fromIntegral (ceiling u - 1 :: Int) else 1
  | u > negate whole = u - fromIntegral (floor u :: Int)
  | otherwise = 0
  where
    -- From 2^52 on every double is a whole number.
    whole = 2 ^ (52 :: Int)
