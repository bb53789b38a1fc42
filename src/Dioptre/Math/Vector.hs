{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Math.Vector
-- Description : Vectors of space, on linear's V3
--
-- The vectors of the ray tracer: positions and displacements in world space, in the scene's unit of length,
-- in a right-handed frame. They are "Linear"'s 'V3' over 'Double', so the whole vocabulary of that library works
-- on them; this module names the part the tracer speaks, and adds what it says differently:
--
-- * 'unit' is there for every finite vector but zero (the library's @normalize@ leaves vectors shorter than 1e-6 as
--   they are);
-- * 'angle' keeps its accuracy for nearly parallel vectors.
--
-- The order of operations is part of each rule: with it every program that computes in binary64 gets the same bits.
module Dioptre.Math.Vector
  ( -- * Vectors
    Vector,
    Point,
    dot,
    cross,
    quadrance,
    modulus,
    distance,
    angle,
    nearOne,
    (*^),
    (^/),

    -- * Unit vectors
    Unit,
    unit,
    vector,
    opposite,
    valid,
    alongX,
    alongY,
    alongZ,

    -- * Vectors at rest
    Packed,
    packed,
    unpacked,
    PackedUnit,
    packedUnit,
    unpackedUnit,
    trustedUnit,
  )
where

import qualified Linear.Metric as Linear
import Linear.V3 (V3 (..))
import qualified Linear.V3 as Linear
import qualified Linear.Vector as Linear

-- | A displacement, or a direction of any length, in world space.
--
-- Spec: vector.add, vector.subtract.
type Vector = V3 Double

-- | A position in world space.
type Point = V3 Double

-- | The dot product, (a_x b_x + a_y b_y) + a_z b_z.
--
-- Law: where nothing is rounded, bilinear, and zero for orthogonal vectors.
--
-- Spec: numbers.binary64, numbers.order, vector.dot.
dot :: Vector -> Vector -> Double
dot = Linear.dot
{-# INLINE dot #-}

-- | The cross product, (a_y b_z - a_z b_y, a_z b_x - a_x b_z, a_x b_y - a_y b_x): orthogonal to both, right-handed.
--
-- Law: bilinear; a x b = -(b x a), to the bit.
--
-- Spec: vector.cross.
cross :: Vector -> Vector -> Vector
cross = Linear.cross
{-# INLINE cross #-}

-- | The square of the length, (x x + y y) + z z.
--
-- Spec: vector.modulus.
quadrance :: Vector -> Double
quadrance = Linear.quadrance
{-# INLINE quadrance #-}

infixl 7 *^, ^/

-- | A number times a vector.
--
-- Spec: numbers.subnormal, vector.scale.
(*^) :: Double -> Vector -> Vector
(*^) = (Linear.*^)
{-# INLINE (*^) #-}

-- | A vector divided by a number, component by component.
(^/) :: Vector -> Double -> Vector
(^/) = (Linear.^/)
{-# INLINE (^/) #-}

-- | The length of a vector, sqrt ((x x + y y) + z z). It overflows beyond 1e154 and loses digits below 1.5e-154:
-- the scene language admits no component above 1e100 ("Dioptre.Syntax.Value").
--
-- >>> modulus (V3 2 3 6)
-- 7.0
--
-- Spec: vector.modulus.
modulus :: Vector -> Double
modulus v = sqrt (quadrance v)
{-# INLINE modulus #-}

-- | The length of the segment between two points: @distance a b = modulus (b - a)@.
--
-- >>> distance (V3 1 1 1) (V3 3 4 7)
-- 7.0
--
-- Spec: vector.distance.
distance :: Point -> Point -> Double
distance a b = modulus (b - a)
{-# INLINE distance #-}

-- | The angle between two vectors, in radians, from 0 to pi; 0 where one of them is zero.
--
-- It is atan2 (|a x b|, a . b). The textbook's acos (a . b \/ |a| |b|) has an error of sqrt epsilon near 0 and pi,
-- because the cosine is flat there; the tangent is not. Source: W. Kahan, "How futile are mindless assessments of
-- roundoff", section 12.
--
-- Both vectors are first brought near the length 1 by a power of two, which changes neither digits nor the angle, so
-- that no product leaves the range. The zero vector is looked for, since its dot product may be -0, and atan2 (0, -0)
-- is pi.
--
-- >>> angle (V3 1 0 0) (V3 0 2 0) == pi / 2
-- True
--
-- Spec: numbers.elementary, numbers.negative-zero, vector.angle, vector.angle.zero.
angle :: Vector -> Vector -> Double
angle a b
  | a == 0 || b == 0 = 0
  | otherwise = atan2 (modulus (cross a' b')) (dot a' b')
  where
    (_, a') = nearOne a
    (_, b') = nearOne b

-- | The number e, and the vector times 2^-e, whose largest component is between 1\/2 and 1 in magnitude; a zero vector
-- stays as it is. No digit is lost, and products of such vectors stay in the range.
--
-- >>> nearOne (V3 6 0 (-1))
-- (3,V3 0.75 0.0 (-0.125))
nearOne :: Vector -> (Int, Vector)
nearOne v = (e, scaleFloat (negate e) <$> v)
  where
    e = exponent (maximum (abs <$> v))

-- | A vector of length 1, to rounding. The ways in are 'unit' and the three axes; what comes from these by
-- 'opposite', and by 'packedUnit' and back; and 'trustedUnit', which believes its caller.
--
-- Law: 'valid'.
newtype Unit = Unit Vector
  deriving stock (Eq, Show)

-- | The vector divided by its length, component by component; 'Nothing' for the zero vector, and for one with an
-- infinite component or NaN, which has no direction; for no other.
--
-- A vector so short or so long that its quadrance would leave the normal range is first scaled by a power of two,
-- which changes no digit. Law: the result's length differs from 1 by less than 4 units of rounding.
--
-- >>> unit (V3 0 3 4)
-- Just (Unit (V3 0.0 0.6 0.8))
-- >>> unit (V3 0 0 0)
-- Nothing
-- >>> unit (V3 1 0 (1 / 0))
-- Nothing
--
-- Spec: numbers.order, vector.normalize, vector.normalize.zero, vector.normalize.extremes, geometry.plane.unit-normal.
unit :: Vector -> Maybe Unit
unit v
  -- 1e-280 and 1e280. See Note [Literals] of "Dioptre.Math.Roots".
  | q > 1e-100 * 1e-100 * 1e-80 && q < 1e100 * 1e100 * 1e80 = Just (Unit (v ^/ sqrt q))
  | otherwise = unitScaled v
  where
    q = quadrance v
{-# INLINE unit #-}

-- | 'unit' where the quadrance cannot be trusted; out of the way of the common case.
--
-- Spec: vector.normalize.extremes.
unitScaled :: Vector -> Maybe Unit
unitScaled v
  | v == 0 || isInfinite largest || isNaN largest = Nothing
  | otherwise = let (_, scaled) = nearOne v in Just (Unit (scaled ^/ modulus scaled))
  where
    largest = maximum (fmap abs v)
{-# NOINLINE unitScaled #-}

-- | The unit vector as a vector.
vector :: Unit -> Vector
vector (Unit v) = v
{-# INLINE vector #-}

-- | The same line, the other way.
opposite :: Unit -> Unit
opposite (Unit v) = Unit (negate v)
{-# INLINE opposite #-}

-- | What holds of every 'Unit': its quadrance, as computed, is within 10 units of rounding (2^-53) of 1. The first
-- quadrance errs by at most 3 units of itself, which the square root halves, and adds 1 of its own; the division adds
-- 1: each component errs by 3.5. The square doubles that to 7, and computing it adds 3.
valid :: Unit -> Bool
valid (Unit v) = abs (quadrance v - 1) <= 10 * 2 ** (-53)

-- | The axes' directions.
alongX, alongY, alongZ :: Unit
alongX = Unit (V3 1 0 0)
alongY = Unit (V3 0 1 0)
alongZ = Unit (V3 0 0 1)

-- | A vector as it is stored in what the inner loop reads: three plain numbers. 'V3' is polymorphic, so that a stored
-- @V3 Double@ holds three pointers to boxed numbers; this costs half the speed of a sphere.
data Packed = Packed !Double !Double !Double
  deriving stock (Eq, Show)

-- | To rest, and back. Both vanish in optimised code.
packed :: Vector -> Packed
packed (V3 x y z) = Packed x y z
{-# INLINE packed #-}

-- | The vector that was packed.
unpacked :: Packed -> Vector
unpacked (Packed x y z) = V3 x y z
{-# INLINE unpacked #-}

-- | A unit vector at rest. 'packedUnit' alone makes it.
newtype PackedUnit = PackedUnit Packed
  deriving stock (Eq, Show)

-- | To rest, and back.
packedUnit :: Unit -> PackedUnit
packedUnit (Unit v) = PackedUnit (packed v)
{-# INLINE packedUnit #-}

-- | The unit vector that was packed.
unpackedUnit :: PackedUnit -> Unit
unpackedUnit (PackedUnit p) = Unit (unpacked p)
{-# INLINE unpackedUnit #-}

-- | The unit vector with these three numbers, which nobody checks: for those of a 'Unit' that was stored as numbers,
-- among many of its kind in one array.
trustedUnit :: Vector -> Unit
trustedUnit = Unit
{-# INLINE trustedUnit #-}
