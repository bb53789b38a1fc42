{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Math.Transform
-- Description : Scale, turn and move
--
-- The transformation that the scene language writes: a scale along the axes, then rotations about the x, y and z axes
-- in this order, in degrees, then a translation. On column vectors:
--
-- > M = T Rz Ry Rx S
-- >
-- >      y                     y                        y    .
-- >      |_                    |____                    |  ./ `\
-- >      |_|___ x       S      |____|__ x     R, T      | `\   /'       p' = L p + T,   L = Rz Ry Rx S
-- >     /                     /                        /    `./___ x
-- >    z                     z                        z
--
-- Seen from the tip of its axis towards the origin, each rotation turns counter-clockwise (the right-hand rule):
--
-- > Rx = | 1  0   0 |    Ry = |  c  0  s |    Rz = | c  -s  0 |    c = cos, s = sin of the angle
-- >      | 0  c  -s |         |  0  1  0 |         | s   c  0 |
-- >      | 0  s   c |         | -s  0  c |         | 0   0  1 |
--
-- The parts are never zero and the rotations undo themselves when transposed, so the inverse needs no elimination:
--
-- > L^-1 = S^-1 Rx^T Ry^T Rz^T        p = L^-1 (p' - T)
--
-- A turn by a multiple of 90 degrees is exact: the angle is reduced, without rounding, to between -45 and 45 degrees
-- and a number of quarter turns, before sine and cosine see it. They are the only functions here that another system
-- may round otherwise.
--
-- Normals do not move as directions do: a plane \<n, p> = 0 is carried to \<n', p'> = 0 with n' = (L^-1)^T n. Source:
-- G. Turk, "Transformation of surface normal vectors" (1990), or M. Pharr, W. Jakob, G. Humphreys, /Physically Based
-- Rendering/, section 3.10.3, <https://pbr-book.org/4ed/Geometry_and_Transformations/Applying_Transformations>.
module Dioptre.Math.Transform
  ( -- * As it is written
    Transform,
    transform,
    transformScale,
    transformRotation,
    transformTranslation,
    identity,
    matrix,

    -- * Made ready
    Placement,
    placement,

    -- * There
    transformPosition,
    transformDirection,
    transformNormal,

    -- * And back
    inversePosition,
    inverseDirection,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Math.Vector (Packed, Point, Unit, Vector, dot, packed, unit, unpacked, vector, (*^))
import Linear.V3 (V3 (..))
import Linear.V4 (V4 (..))

-- | A transformation that can be undone.
data Transform = Transform
  { -- | Factors along x, y, z; none is zero.
    transformScale :: Vector,
    -- | Degrees about x, then y, then z, right-handed.
    transformRotation :: Vector,
    -- | What is added last.
    transformTranslation :: Vector
  }
  deriving stock (Eq, Show)

-- | From scale, rotation and translation; 'Nothing' if a factor is zero.
--
-- Spec: transform.order, transform.inverse.
transform :: Vector -> Vector -> Vector -> Maybe Transform
transform s r t
  | 0 `elem` s = Nothing
  | otherwise = Just (Transform s r t)

-- | The transformation that changes nothing.
identity :: Transform
identity = Transform (V3 1 1 1) 0 0

-- | The matrix M = T Rz Ry Rx S, by rows; it stands to the left of the columns (x, y, z, 1).
--
-- >>> matrix identity
-- V4 (V4 1.0 0.0 0.0 0.0) (V4 0.0 1.0 0.0 0.0) (V4 0.0 0.0 1.0 0.0) (V4 0.0 0.0 0.0 1.0)
--
-- Spec: numbers.elementary, transform.matrix, transform.order, geometry.transformed.rotated.
matrix :: Transform -> V4 (V4 Double)
matrix t = V4 (row lx tx) (row ly ty) (row lz tz) (V4 0 0 0 1)
  where
    V3 lx ly lz = linearPart t
    V3 tx ty tz = transformTranslation t
    row (V3 x y z) = V4 x y z

-- | The rows of Rz Ry Rx.
--
-- Spec: transform.tolerance.
rotation :: Vector -> V3 Vector
rotation (V3 x y z) =
  V3
    (V3 (cz * cy) (cz * sy * sx - sz * cx) (cz * sy * cx + sz * sx))
    (V3 (sz * cy) (sz * sy * sx + cz * cx) (sz * sy * cx - cz * sx))
    (V3 (negate sy) (cy * sx) (cy * cx))
  where
    (cx, sx) = cosineAndSine x
    (cy, sy) = cosineAndSine y
    (cz, sz) = cosineAndSine z

-- | The rows of L = Rz Ry Rx S: each column of the rotation, times its factor; and 0 for -0, by a sum with 0.
--
-- Spec: transform.tolerance.
linearPart :: Transform -> V3 Vector
linearPart t = fmap (+ 0) . (* transformScale t) <$> rotation (transformRotation t)

-- | Cosine and sine of an angle in degrees; exactly 0, 1 or -1 at multiples of 90.
--
-- Spec: transform.quarters, geometry.transformed.rotated.
cosineAndSine :: Double -> (Double, Double)
cosineAndSine degrees = case quarters `mod` 4 of
  0 -> (c, s)
  1 -> (0 - s, c)
  2 -> (0 - c, 0 - s)
  _ -> (s, 0 - c)
  where
    quarters = round (toRational degrees / 90) :: Integer
    -- At most 45 in magnitude, and without rounding: it is a multiple of the last digit of the angle, and no larger.
    rest = fromRational (toRational degrees - 90 * fromInteger quarters) :: Double
    c = cos (rest * (pi / 180))
    s = sin (rest * (pi / 180))

{- HLINT ignore cosineAndSine "Use negate" -}

-- | A transformation and its inverse as plain numbers: the rows of L, those of L^-1, and T.
data Placement
  = Placement
      {-# UNPACK #-} !Packed
      {-# UNPACK #-} !Packed
      {-# UNPACK #-} !Packed
      {-# UNPACK #-} !Packed
      {-# UNPACK #-} !Packed
      {-# UNPACK #-} !Packed
      {-# UNPACK #-} !Packed
  deriving stock (Eq, Show)

-- | A transformation made ready for many points and rays.
placement :: Transform -> Placement
placement t = Placement (packed lx) (packed ly) (packed lz) (packed (column ex sx)) (packed (column ey sy)) (packed (column ez sz)) (packed (transformTranslation t))
  where
    V3 lx ly lz = linearPart t
    V3 sx sy sz = transformScale t
    V3 rx ry rz = rotation (transformRotation t)
    -- A column of the rotation, as a row of its transpose, over the factor.
    column e s = (/ s) <$> V3 (e rx) (e ry) (e rz)
    ex (V3 x _ _) = x
    ey (V3 _ y _) = y
    ez (V3 _ _ z) = z

-- | Where a point comes to lie: L p + T.
--
-- Law: 'inversePosition' undoes it, to rounding.
--
-- Spec: transform.position.
transformPosition :: Placement -> Point -> Point
transformPosition m@(Placement _ _ _ _ _ _ t) p = transformDirection m p + unpacked t
{-# INLINE transformPosition #-}

-- | What becomes of the way from one point to another: L d. The length changes with it.
--
-- Spec: transform.direction.
transformDirection :: Placement -> Vector -> Vector
transformDirection (Placement lx ly lz _ _ _ _) = rows lx ly lz
{-# INLINE transformDirection #-}

-- | What becomes of the normal of a surface: (L^-1)^T n, made unit. A mirroring transformation (a negative factor)
-- keeps it on its side of the surface: outward normals stay outward. (The matrix can be undone, so that the product
-- is not zero, unless it underflows: then nothing is turned.)
--
-- Law: it is orthogonal to the image of every direction that n is orthogonal to.
--
-- Spec: transform.normal, transform.normal.mirror, geometry.transformed.normal, geometry.transformed.mirrored.
transformNormal :: Placement -> Unit -> Unit
transformNormal (Placement _ _ _ ix iy iz _) n = fromMaybe n (unit (x *^ unpacked ix + y *^ unpacked iy + z *^ unpacked iz))
  where
    V3 x y z = vector n
{-# INLINE transformNormal #-}

-- | Where a point came from: L^-1 (p - T).
--
-- Spec: transform.inverse, geometry.transformed.contains.
inversePosition :: Placement -> Point -> Point
inversePosition m@(Placement _ _ _ _ _ _ t) p = inverseDirection m (p - unpacked t)
{-# INLINE inversePosition #-}

-- | What a direction was: L^-1 d.
--
-- Spec: transform.inverse.
inverseDirection :: Placement -> Vector -> Vector
inverseDirection (Placement _ _ _ ix iy iz _) = rows ix iy iz
{-# INLINE inverseDirection #-}

-- | A matrix, given by its rows, times a vector.
rows :: Packed -> Packed -> Packed -> Vector -> Vector
rows a b c v = V3 (dot (unpacked a) v) (dot (unpacked b) v) (dot (unpacked c) v)
{-# INLINE rows #-}
