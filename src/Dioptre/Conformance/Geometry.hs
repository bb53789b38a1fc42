{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Geometry
-- Description : The operations of the profile geometry
--
-- Where rays meet surfaces. An operation @intersect.*@ gives every real parameter at which the ray's whole line, behind
-- its origin too, meets an unbounded surface (a torus is bounded by itself), ascending, and a parameter twice where the
-- line touches the surface:
--
-- * a plane, once or never (a line in the plane: never);
-- * a sphere, twice or never;
-- * a tube without ends, twice or never (a line along the axis: never);
-- * both halves of a double cone, twice or never, once for a line parallel to one of its lines;
-- * a torus, four times, twice or never; of a spindle the sheet inside as well.
--
-- The radius of a sphere, tube or cone may be zero, or negative, which is as good as its opposite, since only its
-- square counts.
module Dioptre.Conformance.Geometry
  ( operations,
  )
where

import Data.Aeson (Value (..), object, (.=))
import Data.Aeson.Types (Object, Parser)
import Data.Foldable (toList)
import Data.Text (Text)
import Dioptre.Conformance.Parameter (Operation, field, number, ofVector, ray, real, reals, shape, unitVector, vector)
import Dioptre.Geometry.Cone (conesParameters)
import Dioptre.Geometry.Plane (Plane, plane, planeNormal, planeParameters)
import Dioptre.Geometry.Prepared (Prepared, contains, nearest, normalAt, prepare, textureAt)
import Dioptre.Geometry.Ray (Ray, position)
import Dioptre.Geometry.Sphere (sphereParameters)
import Dioptre.Geometry.Torus (torus, torusParameters)
import Dioptre.Geometry.Triangle (Corners (..), barycentric, triangle)
import Dioptre.Geometry.Tube (tubeLineParameters)
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Vector (Point, Unit, unit)
import qualified Dioptre.Math.Vector as Vector

-- | By their names.
--
-- Spec: protocol.operations.
operations :: [(Text, Operation)]
operations =
  [ ("ray.position", \o -> do r <- rayOf o; t <- field number o "t"; ofVector (position r t)),
    ("intersect.plane", \o -> do r <- rayOf o; p <- placeOf o; (_, n) <- planeOf o; reals (planeParameters p n r)),
    ("intersect.sphere", \o -> do r <- rayOf o; c <- placeOf o; radius <- radiusOf o; reals (sphereParameters c (radius * radius) r)),
    ("intersect.tube", \o -> do r <- rayOf o; p <- field vector o "point"; s <- field unitVector o "axis"; radius <- radiusOf o; reals (tubeLineParameters p s radius r)),
    ("intersect.cones", \o -> do r <- rayOf o; p <- field vector o "point"; apex <- field vector o "apex"; radius <- radiusOf o; reals (conesParameters p apex radius r)),
    ("intersect.torus", intersectTorus),
    ("geometry.hit", \o -> do s <- shapeOf o; r <- rayOf o; hit s r),
    ("geometry.contains", \o -> do s <- shapeOf o; p <- field vector o "point"; pure (Bool (contains s p))),
    ("triangle.barycentric", barycentricOf)
  ]
  where
    rayOf o = field ray o "ray"
    placeOf o = field vector o "position"
    radiusOf o = field number o "radius"

-- | The plane of an operation, and its unit normal.
--
-- Spec: protocol.sizes.
planeOf :: Object -> Parser (Plane, Unit)
planeOf o = do
  p <- field vector o "position"
  n <- field vector o "normal"
  maybe (fail "the normal is shorter than 1e-10") pure $ do
    made <- plane p n
    (,) made <$> unit (planeNormal made)

intersectTorus :: Operation
intersectTorus o = do
  r <- field ray o "ray"
  p <- field vector o "position"
  (pl, n) <- planeOf o
  major <- field number o "major_radius"
  minor <- field number o "minor_radius"
  case torus pl major minor of
    Nothing -> fail "a radius of a torus is greater than zero"
    Just _ -> reals (torusParameters p n major minor r)

shapeOf :: Object -> Parser Prepared
shapeOf o = field shape o "geometry" >>= maybe (fail "a direction of the shape cannot be made unit") pure . prepare

-- | What a ray meets first, at a parameter above 1e-8: the parameter, the point, the unit outward normal, and the
-- texture coordinates before they are wrapped; or null.
hit :: Prepared -> Ray -> Parser Value
hit s r
  | isInfinite t = pure Null
  | otherwise = do
    t' <- real t
    point <- ofVector (position r t)
    normal <- ofVector (Vector.vector (normalAt s r t))
    uv <- reals (toList (textureAt s r t))
    pure (object ["t" .= t', "point" .= point, "normal" .= normal, "uv" .= uv])
  where
    t = nearest s r infinity

-- | The coordinates (t1, t2) of a point in a triangle's plane; a point beside the plane has those of its projection.
barycentricOf :: Operation
barycentricOf o = do
  points <- field corners o "points"
  p <- field vector o "point"
  let Corners p0 p1 p2 = points
      (t1, t2) = barycentric p0 p1 p2 p
  maybe (fail "the points of the triangle are on one line") (const (reals [t1, t2])) (triangle points)

corners :: Value -> Parser (Corners Point)
corners value = case value of
  Array items | [a, b, c] <- toList items -> Corners <$> vector a <*> vector b <*> vector c
  _ -> fail "these are not three points"
