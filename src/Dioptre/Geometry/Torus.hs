{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Torus
-- Description : The torus
--
-- >                 n                      half of a section along the axis n:
-- >                 ^
-- >     .--.        |        .--.            h |      . - .
-- >    (    )-------P-------( C--) r           |     /     \
-- >     `--'        |        `--'            --P----|---C---|---- rho
-- >                 |<--- R --->|              |     \     /
-- >                                            |      ` - '
--
-- A tube of radius r around the circle of radius R about P, in the plane with unit normal n. With v measured from P, h
-- = \<n, v> its height and rho = |v - h n| its distance from the axis, the torus is where (rho - R)^2 + h^2 = r^2.
-- Expanded,
--
-- > |v|^2 + R^2 - r^2 = 2 R rho
--
-- and squared, to be rid of the square root in rho (rho^2 = |v|^2 - h^2):
--
-- > (|v|^2 + k)^2 = 4 R^2 (|v|^2 - h^2)        k = R^2 - r^2
--
-- Squaring adds the points with (rho + R)^2 + h^2 = r^2: those of the tube where, thicker than the circle (r > R, a
-- spindle), it reaches across the axis. They belong to the torus too, as the inner sheet.
--
-- A ray is put in as v = q + s u, with u its unit direction and q the point of its line nearest to P, so that \<q, u> =
-- 0. Then |v|^2 = s^2 + C and h = N + M s, with C = |q|^2, N = \<n, q>, M = \<n, u>, and with G = C + k:
--
-- > s^4  +  (2 G - 4 R^2 (1 - M^2)) s^2  +  8 R^2 M N s  +  G^2 - 4 R^2 (C - N^2)  =  0
--
-- Measured from the ray's origin instead, at a distance D, the coefficients would be as large as D^4 and all the torus
-- is would be in their last digits. See Note [From where to measure].
--
-- Source: P. Hanrahan, "A Survey of Ray-Surface Intersection Algorithms", section 3.2, in A. Glassner (ed.), /An
-- Introduction to Ray Tracing/ (1989).
module Dioptre.Geometry.Torus
  ( -- * Constructing
    Torus,
    torus,
    torusPlane,
    torusMajor,
    torusMinor,

    -- * Intersecting
    torusParameters,
    torusNormal,

    -- * Along a ray
    TorusLine (..),
    torusLine,
    torusEquation,

    -- * Inside
    torusContains,
  )
where

import Data.Bits ((.&.))
import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Plane (Plane)
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Math.Quartic (quarticRoots)
import Dioptre.Math.Tolerance (roundThickness, torusSlack)
import Dioptre.Math.Vector (Point, Unit, dot, modulus, opposite, quadrance, unit, vector, (*^), (^/))
import GHC.Exts (build)
import GHC.Float (castDoubleToWord64, castWord64ToDouble)

-- $setup
-- >>> import Dioptre.Geometry.Ray (ray)
-- >>> import Dioptre.Math.Vector (alongZ)
-- >>> import Linear.V3 (V3 (..))

-- | A torus: the plane of its circle, the radius of the circle, and that of the tube.
data Torus = Torus
  { -- | The plane of the circle; its position is the centre.
    torusPlane :: Plane,
    -- | The radius of the circle; greater than zero.
    torusMajor :: Double,
    -- | The radius of the tube; greater than zero.
    torusMinor :: Double
  }
  deriving stock (Eq, Show)

-- | 'Nothing' unless both radii are greater than zero. The tube may be thicker than the circle (a spindle).
torus :: Plane -> Double -> Double -> Maybe Torus
torus p major minor
  | major > 0 && minor > 0 = Just (Torus p major minor)
  | otherwise = Nothing

-- | Every parameter at which a ray's line meets the torus around P, with axis n, of radii R and r, ascending, those
-- behind the origin too. A ray that touches the torus does so twice; the number is even, 0, 2 or 4. The direction may
-- have any length but zero.
--
-- Laws: each point is at distance r from the circle, with an error as of coordinates rounded to 2^-52 of the distance
-- of the ray's origin, and 2^-48 (R + r)^4 \/ (4 r R rho) more, rho being its distance from the axis; moving, turning
-- and mirroring ray and torus together changes nothing else.
--
-- >>> torusParameters 0 alongZ 2 1 (ray (V3 (-10) 0 0) (V3 1 0 0))
-- [7.0,9.0,11.0,13.0]
-- >>> torusParameters 0 alongZ 2 1 (ray (V3 2 0 9) (V3 0 0 (-2)))
-- [4.0,5.0]
--
-- Cost: a line that misses the sphere of radius R + r around P, three dot products; any other, a quartic.
--
-- Spec: geometry.torus.equation, geometry.torus.spindle, geometry.torus.precision.
torusParameters :: Point -> Unit -> Double -> Double -> Ray -> [Double]
torusParameters p n major minor r = build $ \cons nil ->
  let !(TorusLine l t0 scale c height slope) = torusLine p n major minor r
      !outer = (major + minor) / l
   in if c <= (1 + torusSlack) * (outer * outer)
        then foldr (\s -> cons ((t0 + s) * scale)) nil (meetings (major / l) (minor / l) c height slope)
        else nil
{-# INLINE torusParameters #-}

-- | A ray's line from q on, its point nearest to the centre, in units L: the ray's parameter is (t0 + s) k.
data TorusLine = TorusLine
  { -- | The unit of length, L: a power of two.
    lineUnit :: !Double,
    -- | t0.
    lineStart :: !Double,
    -- | k.
    lineScale :: !Double,
    -- | C = |q|^2.
    lineDistance :: !Double,
    -- | N = \<n, q>.
    lineHeight :: Double,
    -- | M = \<n, u>.
    lineSlope :: Double
  }

-- | The ray's line, seen from the torus.
torusLine :: Point -> Unit -> Double -> Double -> Ray -> TorusLine
torusLine p n major minor r = TorusLine l t0 (l / m) (quadrance q) (dot (vector n) q) (dot (vector n) u)
  where
    !l = powerBelow (major + minor)
    !m = modulus (direction r)
    u = direction r ^/ m
    w = (origin r - p) ^/ l
    !t0 = negate (dot w u)
    q = w + t0 *^ u
{-# INLINE torusLine #-}

-- | The power of two with the same exponent: the unit of length, in which R + r is between 1 and 2, and to which
-- everything is brought without rounding; for normal numbers.
powerBelow :: Double -> Double
powerBelow x = castWord64ToDouble (castDoubleToWord64 x .&. 0x7ff0000000000000)
{-# INLINE powerBelow #-}

-- | The roots s, from R, r, C, N and M, in that unit.
meetings :: Double -> Double -> Double -> Double -> Double -> [Double]
meetings !major !minor !c !n !m = let (c2, c1, c0) = torusEquation major minor c n m in quarticRoots 1 0 c2 c1 c0
{-# NOINLINE meetings #-}

-- | The coefficients of s^2, of s, and the constant, from R, r, C, N and M. (That of s^4 is 1, and that of s^3 is 0.)
torusEquation :: Double -> Double -> Double -> Double -> Double -> (Double, Double, Double)
torusEquation major minor c n m = (2 * g - four * ((1 - m) * (1 + m)), 2 * four * m * n, g * g - four * (c - n * n))
  where
    !g = c + (major - minor) * (major + minor)
    !four = 4 * (major * major)
{-# INLINE torusEquation #-}

-- | The outward unit normal at a point of the torus: (v - C) \/ |v - C|, where C is the point of the circle in whose
-- tube's skin v lies, which is the nearest one, P + R (v - h n) \/ rho, except on the inner sheet of a spindle, where
-- it is the one across the axis. At a point of the axis there is no one such point, and at C no direction; there it is
-- n, on the side of n, or its opposite on the other side.
--
-- Spec: geometry.torus.normal.
torusNormal :: Point -> Unit -> Double -> Double -> Point -> Unit
torusNormal p n major minor v = fromMaybe upright $ do
  outwards <- unit (w - h *^ vector n)
  unit (w - centre *^ vector outwards)
  where
    w = v - p
    h = dot (vector n) w
    upright = if h < 0 then opposite n else n
    centre = if quadrance w + (major - minor) * (major + minor) < 0 then negate major else major

-- | Whether a point is inside: nearer to the circle than (1 - 1e-7) r ('roundThickness').
--
-- >>> torusContains 0 alongZ 2 1 (V3 2 0 0.5)
-- True
-- >>> torusContains 0 alongZ 2 1 (V3 0 0 0)
-- False
--
-- Spec: geometry.torus.contains.
torusContains :: Point -> Unit -> Double -> Double -> Point -> Bool
torusContains p n major minor v = sqrt (across * across + h * h) < (1 - roundThickness) * minor
  where
    w = v - p
    h = dot (vector n) w
    across = modulus (w - h *^ vector n) - major

-- Note [From where to measure]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- The roots move by the rounding of the coefficients, divided by the slope of the polynomial. With s measured from the
-- ray's origin at a distance D, in units of about R + r, the constant coefficient is about D^4, its rounding 2^-53 D^4,
-- and the slope at a root, where the other three roots are, is about 1: at D = 1000 an error of 10^-4, which shows, and
-- at 10^4 nothing is left. Measured from the point q nearest to the centre, all coefficients are at most 100 or so,
-- wherever the ray comes from: a line that passes through the sphere around the torus has |q| <= R + r. Only q itself
-- carries the rounding of the origin, 2^-53 D in each coordinate, as does every point that is computed as o + t d. The
-- cubic term vanishes, too.
--
-- Orthogonality is not exact: <q, u> is what rounding leaves, 2^-53 D or less. To leave out the terms with <q, u> is to
-- shift the point along the ray by that much, no more than the rounding of q itself. So is |u|^2 - 1.
--
-- Near a root the polynomial is F = ((rho - R)^2 + h^2 - r^2) ((rho + R)^2 + h^2 - r^2). Its second factor is 4 R^2 or
-- so, for thin tubes, and the gradient of its first factor is 2 r: an error of 2^-53 times a few in F is an error of
-- that over 8 R^2 r in the distance. A tube a thousand times thinner than its circle is seen to 10^-10 of its own
-- radius.
