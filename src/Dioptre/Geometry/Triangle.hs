{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Geometry.Triangle
-- Description : Triangles, flat and smooth
--
-- >        P2
-- >       /  \            n = (P1 - P0) x (P2 - P0), made unit
-- >      /    \           r = P0 + t1 (P1 - P0) + t2 (P2 - P0)
-- >    P0------P1
--
-- A ray meets the plane of the triangle at one parameter, by the plane's rule; it is kept where the ray passes on the
-- same side of the three edges, the edges themselves included. A smooth triangle has a normal at each corner, and
-- between them the interpolated one.
--
-- Which side of an edge is decided by numbers that are the same for both triangles that share the edge, so that no ray
-- slips between them. Source: S. Woop, C. Benthin, I. Wald, "Watertight ray\/triangle intersection", JCGT 2(1), 2013.
-- See Note [Watertight].
module Dioptre.Geometry.Triangle
  ( -- * Constructing
    Triangle,
    triangle,
    trianglePoints,
    triangleNormal,
    SmoothTriangle,
    smoothTriangle,
    smoothTriangleFlat,
    smoothTriangleNormals,
    smoothTriangleUvs,
    Corners (..),

    -- * Intersecting
    triangleParameters,
    barycentric,
    interpolatedNormal,
  )
where

import Control.Applicative ((<|>))
import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Plane (planeParameters)
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Math.Tolerance (collinearSine, needleSine)
import Dioptre.Math.Vector (Point, Unit, Vector, cross, dot, modulus, nearOne, unit, vector, (*^))
import Linear.V2 (V2)
import Linear.V3 (V3 (..))

-- $setup
-- >>> :set -XHexFloatLiterals

-- | Something for each corner, in the order P0, P1, P2.
data Corners a = Corners a a a
  deriving stock (Eq, Show, Functor, Foldable)

-- | A flat triangle.
data Triangle = Triangle
  { -- | The corners, P0, P1, P2.
    trianglePoints :: Corners Point,
    -- | (P1 - P0) x (P2 - P0), made unit: P0, P1, P2 turn counter-clockwise when seen from where it points.
    triangleNormal :: Unit
  }
  deriving stock (Eq, Show)

-- | The triangle with these corners; 'Nothing' if they lie on one line ('collinearSine').
--
-- Spec: code.collinear-points, geometry.triangle.normal, geometry.triangle.collinear.
triangle :: Corners Point -> Maybe Triangle
triangle points@(Corners p0 p1 p2) = do
  u1 <- vector <$> unit e1
  u2 <- vector <$> unit e2
  -- The sine of the angle between the edges, which no size of the triangle takes out of range.
  if modulus (cross u1 u2) <= collinearSine
    then Nothing
    else Triangle points <$> (unit (cross e1 e2) <|> unit (cross u1 u2))
  where
    e1 = p1 - p0
    e2 = p2 - p0

-- | A triangle with a normal and a texture coordinate at each corner.
data SmoothTriangle = SmoothTriangle
  { -- | The flat triangle with the same corners.
    smoothTriangleFlat :: Triangle,
    -- | The corners' normals, of any length but zero.
    smoothTriangleNormals :: Corners Vector,
    -- | The corners' texture coordinates.
    smoothTriangleUvs :: Corners (V2 Double)
  }
  deriving stock (Eq, Show)

-- | A flat triangle made smooth. The normal of a corner that has none, or a zero one, is the flat triangle's.
--
-- Spec: shape.btriangle.normals, geometry.smooth-triangle.flat-corner.
smoothTriangle :: Triangle -> Corners (Maybe Vector) -> Corners (V2 Double) -> SmoothTriangle
smoothTriangle flat (Corners n0 n1 n2) = SmoothTriangle flat (Corners (orFlat n0) (orFlat n1) (orFlat n2))
  where
    orFlat n = case n of
      Just v | v /= 0 -> v
      _ -> vector (triangleNormal flat)

-- | Where a ray's line meets the triangle with unit normal n: one parameter or none.
--
-- Law: the point is on the plane, and its barycentric coordinates are at least 0 and add up to at most 1, to rounding.
--
-- Spec: geometry.triangle.both-sides, geometry.triangle.parameters, geometry.triangle.edge-on,
--   geometry.smooth-triangle.parameters.
triangleParameters :: Point -> Point -> Point -> Unit -> Ray -> [Double]
triangleParameters p0 p1 p2 n r = [t | passes p0 p1 p2 r, t <- planeParameters p0 n r]
{-# INLINE triangleParameters #-}

-- | Whether the ray's line passes through the triangle, its edges included; not where the ray sees it edge-on, as a
-- line. See Note [Watertight].
--
-- Spec: geometry.triangle.edges, geometry.triangle.watertight.
passes :: Point -> Point -> Point -> Ray -> Bool
passes p0 p1 p2 r = case direction r of
  V3 dx dy dz
    | abs dz >= abs dx && abs dz >= abs dy -> sheared id
    | abs dy >= abs dx -> sheared (\(V3 x y z) -> V3 z x y)
    | otherwise -> sheared (\(V3 x y z) -> V3 y z x)
  where
    -- The frame is turned so that the direction's largest component is z.
    sheared turn =
      let !(V3 dx dy dz) = turn (direction r)
          !sx = dx / dz
          !sy = dy / dz
          along p = let V3 x y z = turn (p - origin r) in Shadow (x - sx * z) (y - sy * z)
          !a = along p0
          !b = along p1
          !c = along p2
          !u = edge c b
          !v = edge a c
          !w = edge b a
       in ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) && (u /= 0 || v /= 0 || w /= 0)
    {-# INLINE sheared #-}
{-# INLINE passes #-}

-- | A corner as the ray sees it: its place in the plane across the ray.
data Shadow = Shadow !Double !Double

-- | Twice the signed area between an edge and the ray. Exactly the negative for the edge the other way round.
--
-- Spec: geometry.triangle.edges, geometry.triangle.watertight.
edge :: Shadow -> Shadow -> Double
edge (Shadow ax ay) (Shadow bx by) = ax * by - ay * bx
{-# INLINE edge #-}

-- | The coordinates (t1, t2) of a point in the triangle's plane: P0 + t1 (P1 - P0) + t2 (P2 - P0). With w = r - P0, s1
-- = P1 - P0, s2 = P2 - P0 and D = \<s1,s1>\<s2,s2> - \<s1,s2>^2:
--
-- > t1 = (<w,s1><s2,s2> - <w,s2><s1,s2>) / D
-- > t2 = (<w,s2><s1,s1> - <w,s1><s1,s2>) / D
--
-- For needles, and for triangles so small or large that a product leaves the range, they come from cross products
-- instead: see Note [Needles].
--
-- >>> barycentric (V3 0 0 0) (V3 1 0 0) (V3 1 0x1p-40 0) (V3 0.75 0x1p-42 0)
-- (0.5,0.25)
--
-- Spec: geometry.triangle.barycentric, geometry.triangle.needle.
barycentric :: Point -> Point -> Point -> Point -> (Double, Double)
barycentric p0 p1 p2 p
  | d > needleSine * needleSine * (s11 * s22) && ordinary s11 && ordinary s22 && dot w w < vast = ((ws1 * s22 - ws2 * s12) / d, (ws2 * s11 - ws1 * s12) / d)
  | otherwise = byCrossProducts w s1 s2
  where
    w = p - p0
    s1 = p1 - p0
    s2 = p2 - p0
    s11 = dot s1 s1
    s22 = dot s2 s2
    s12 = dot s1 s2
    ws1 = dot w s1
    ws2 = dot w s2
    d = s11 * s22 - s12 * s12
    ordinary x = x > 1e-70 * 1e-70 && x < vast
    -- 1e140. See Note [Literals] of "Dioptre.Math.Roots".
    vast = 1e70 * 1e70
{-# INLINE barycentric #-}

-- | The same for any triangle: with n = s1 x s2,
--
-- > t1 = <w x s2, n> / <n, n>
-- > t2 = <s1 x w, n> / <n, n>
--
-- of vectors each of which was first brought near the length 1 by a power of two.
byCrossProducts :: Vector -> Vector -> Vector -> (Double, Double)
byCrossProducts w s1 s2 = (share (cross w' s2') k1, share (cross s1' w') k2)
  where
    (k, w') = nearOne w
    (k1, s1') = nearOne s1
    (k2, s2') = nearOne s2
    n = cross s1' s2'
    share part k' = scaleFloat (k - k') (dot part n / dot n n)
{-# NOINLINE byCrossProducts #-}

-- | (1 - t1 - t2) N0 + t1 N1 + t2 N2, made unit; the flat normal where that vanishes.
--
-- Spec: geometry.smooth-triangle.normal, geometry.smooth-triangle.vanishing.
interpolatedNormal :: Unit -> Corners Unit -> (Double, Double) -> Unit
interpolatedNormal flat (Corners n0 n1 n2) (t1, t2) =
  fromMaybe flat (unit ((1 - t1 - t2) *^ vector n0 + t1 *^ vector n1 + t2 *^ vector n2))
{-# INLINE interpolatedNormal #-}

-- Note [Watertight]
-- ~~~~~~~~~~~~~~~~~
-- The corners are moved so that the ray starts at the origin, turned so that its direction's largest component is z,
-- and sheared so that the direction is the z axis itself: x' = x - (dx/dz) z, y' = y - (dy/dz) z. Now the ray passes
-- through the triangle where the origin of the plane (x', y') lies in the triangle's shadow, that is where the three
-- edge functions have one sign.
--
-- Each corner's shadow is computed from the corner and the ray alone: it is rounded, but it is the same rounded point
-- for every triangle around that corner, so that the shadows of a closed mesh are a closed mesh, a few ulps away. The
-- edge function of an edge is a difference of two products, and negates exactly when the edge is walked the other way.
-- So of two triangles that share an edge at least one accepts a ray that passes between their outer corners. (The
-- scalar triple product <d, a x b> is antisymmetric too, and needs no shear; but near a corner its error is that of the
-- distance to the corner, not of its shadow's size, and three signs at one corner need not fit together.)

-- Note [Needles]
-- ~~~~~~~~~~~~~~
-- D is |s1|^2 |s2|^2 times the squared sine of the angle between the edges, and is computed as a difference of numbers
-- of the size of |s1|^2 |s2|^2, so that it carries an error of some 2^-52 of that. At a sine of 2^-10 the coordinates
-- still have 2^-30 of themselves; at 2^-26 the difference is noise, or 0, while 'triangle' takes sines down to
-- 'collinearSine'. The components of n = s1 x s2 are differences too, but of the sine itself, not its square: their
-- error is 2^-52 in a sine. By <s1,s1><s2,s2> - <s1,s2>^2 = <n, n> and (a x b) . (c x d) = <a,c><b,d> - <a,d><b,c> the
-- two ways are the same in exact arithmetic, and whatever w has along n counts in neither.
--
-- D is of the fourth degree in the size of the triangle, and leaves the range of binary64 for edges above 10^77, which
-- a scene may have. The powers of two that bring the three vectors near 1 change no digit, and come back by one
-- multiplication at the end. The ordinary case is left as the handout has it, bit for bit.
