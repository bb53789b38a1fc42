{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Triangle
-- Description : Triangles, flat and smooth
--
-- >        P2
-- >       /  \            n = (P1 - P0) x (P2 - P0), made unit
-- >      /    \           r = P0 + t1 (P1 - P0) + t2 (P2 - P0)
-- >    P0------P1
--
-- A ray meets the plane of the triangle at one parameter, by the plane's rule; it is kept where the ray passes on the same side
-- of the three edges, the edges themselves included. A smooth triangle has a normal at each corner, and between them
-- the interpolated one.
--
-- Which side of an edge is decided by numbers that are the same for both triangles that share the edge, so that no ray slips between them.
-- Source: S. Woop, C. Benthin, I. Wald, "Watertight ray\/triangle intersection", JCGT 2(1), 2013. See Note [Watertight].
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
import Dioptre.Math.Tolerance (collinearSine)
import Dioptre.Math.Vector (Point, Unit, Vector, cross, dot, modulus, unit, vector, (*^))
import Linear.V2 (V2)
import Linear.V3 (V3 (..))

-- | Something for each corner, in the order P0, P1, P2.
data Corners a = Corners a a a
  deriving stock (Eq, Show)

-- | A flat triangle.
data Triangle = Triangle
  { -- | The corners, P0, P1, P2.
    trianglePoints :: Corners Point,
    -- | (P1 - P0) x (P2 - P0), made unit: P0, P1, P2 turn counter-clockwise when seen from where it points.
    triangleNormal :: Unit
  }
  deriving stock (Eq, Show)

-- | The triangle with these corners; 'Nothing' if they lie on one line ('collinearSine').
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
smoothTriangle :: Triangle -> Corners (Maybe Vector) -> Corners (V2 Double) -> SmoothTriangle
smoothTriangle flat (Corners n0 n1 n2) = SmoothTriangle flat (Corners (orFlat n0) (orFlat n1) (orFlat n2))
  where
    orFlat n = case n of
      Just v | v /= 0 -> v
      _ -> vector (triangleNormal flat)

-- | Where a ray's line meets the triangle with unit normal n: one parameter or none.
--
-- Law: the point is on the plane, and its barycentric coordinates are at least 0 and add up to at most 1, to rounding.
triangleParameters :: Point -> Point -> Point -> Unit -> Ray -> [Double]
triangleParameters p0 p1 p2 n r = [t | passes p0 p1 p2 r, t <- planeParameters p0 n r]
{-# INLINE triangleParameters #-}

-- | Whether the ray's line passes through the triangle, its edges included; not where the ray sees it edge-on, as a line. See
-- Note [Watertight].
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
edge :: Shadow -> Shadow -> Double
edge (Shadow ax ay) (Shadow bx by) = ax * by - ay * bx
{-# INLINE edge #-}

-- | The coordinates (t1, t2) of a point in the triangle's plane: P0 + t1 (P1 - P0) + t2 (P2 - P0). With w = r - P0, s1 = P1 - P0, s2 = P2 - P0
-- and D = \<s1,s1>\<s2,s2> - \<s1,s2>^2:
--
-- > t1 = (<w,s1><s2,s2> - <w,s2><s1,s2>) / D
-- > t2 = (<w,s2><s1,s1> - <w,s1><s1,s2>) / D
barycentric :: Point -> Point -> Point -> Point -> (Double, Double)
barycentric p0 p1 p2 p = ((ws1 * s22 - ws2 * s12) / d, (ws2 * s11 - ws1 * s12) / d)
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

-- | (1 - t1 - t2) N0 + t1 N1 + t2 N2, made unit; the flat normal where that vanishes.
interpolatedNormal :: Unit -> Corners Unit -> (Double, Double) -> Unit
interpolatedNormal flat (Corners n0 n1 n2) (t1, t2) =
  fromMaybe flat (unit ((1 - t1 - t2) *^ vector n0 + t1 *^ vector n1 + t2 *^ vector n2))

-- Note [Watertight]
-- ~~~~~~~~~~~~~~~~~
-- The corners are moved so that the ray starts at the origin, turned so that its direction's largest component is z, and sheared so
-- that the direction is the z axis itself: x' = x - (dx/dz) z, y' = y - (dy/dz) z. Now the ray passes through the triangle where the origin of the
-- plane (x', y') lies in the triangle's shadow, that is where the three edge functions have one sign.
--
-- Each corner's shadow is computed from the corner and the ray alone: it is rounded, but it is the same rounded point for every
-- triangle around that corner, so that the shadows of a closed mesh are a closed mesh, a few ulps away. The edge function of an edge is
-- a difference of two products, and negates exactly when the edge is walked the other way. So of two triangles that share an edge at least
-- one accepts a ray that passes between their outer corners. (The scalar triple product <d, a x b> is antisymmetric too, and needs
-- no shear; but near a corner its error is that of the distance to the corner, not of its shadow's size, and three signs at
-- one corner need not fit together.)
