{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.PreparedMesh
-- Description : Meshes made ready for many rays
--
-- A mesh with a hierarchy of boxes over its triangles. What the inner loop reads stands side by side, leaf by leaf:
-- nine numbers for the corners of each triangle, and apart from them, since few rays come so far, the unit normal.
--
-- Triangles are met by the rule of "Dioptre.Geometry.Triangle", to the bit (a law); what depends on the ray alone is
-- computed once a ray.
module Dioptre.Geometry.PreparedMesh
  ( PreparedMesh,
    prepareMesh,
    preparedMesh,
    preparedMeshHierarchy,
    triangleShape,
    preparedTriangle,

    -- * Intersecting
    closestTriangle,
    anyTriangle,
  )
where

import Control.Monad (forM_)
import Data.Foldable (foldl', toList)
import Data.Int (Int32)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Primitive.PrimArray
import qualified Data.Vector.Unboxed as Vector
import qualified Dioptre.Geometry.Bounds as Bounds
import Dioptre.Geometry.Box (approach)
import Dioptre.Geometry.Closest (Closest (..), precedes, tried, within)
import Dioptre.Geometry.Hierarchy (Hierarchy, Tried (..), descend, hierarchy, hierarchyLeaves, hierarchyOrder)
import Dioptre.Geometry.Mesh
import Dioptre.Geometry.Plane (planeParameters)
import Dioptre.Geometry.Prepared (Prepared, ofSmoothTriangle, ofTriangle)
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Triangle
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Tolerance (smallestParameter)
import Dioptre.Math.Vector (Vector, trustedUnit, unit, vector)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | A mesh that rays can meet.
data PreparedMesh = PreparedMesh
  { -- | The mesh itself.
    preparedMesh :: !Mesh,
    -- | The boxes around its triangles.
    preparedMeshHierarchy :: !Hierarchy,
    -- | Nine numbers for each place of the hierarchy's order.
    cornersAt :: !(PrimArray Double),
    -- | Three numbers for each place.
    normalsAt :: !(PrimArray Double),
    -- | The triangle at each place.
    numberAt :: !(PrimArray Int32),
    -- | The place of each triangle, or of the one before it that has the same corners.
    placeOf :: !(PrimArray Int32),
    -- | Three numbers for each normal of the mesh: the same made unit, or zeros where that cannot be.
    unitsOf :: !(PrimArray Double)
  }
  deriving stock (Eq, Show)

-- | A mesh made ready. Cost: that of its 'hierarchy', and 104 bytes a triangle and 24 a normal.
--
-- Where a leaf is crowded because many triangles are one and the same, only the first of them is kept: it is the one
-- that is met. (A file may name a face a million times.)
prepareMesh :: Mesh -> PreparedMesh
prepareMesh m = PreparedMesh m h corners normals numbers places units
  where
    everything = generatePrimArray (meshSize m) id
    whole = over everything
    again = repeated m (crowded whole)
    (kept, h)
      | IntMap.null again = (everything, whole)
      | otherwise = let fewer = filterPrimArray (`IntMap.notMember` again) everything in (fewer, over fewer)
    over items = hierarchy (sizeofPrimArray items) (\j -> let Corners a b c = meshTriangle m (indexPrimArray items j) in Just (Bounds.ofTriangle a b c))
    count = sizeofPrimArray kept
    numbers = mapPrimArray (fromIntegral . indexPrimArray kept) (hierarchyOrder h)
    number place = fromIntegral (indexPrimArray numbers place)
    corners = runPrimArray $ do
      target <- newPrimArray (9 * count)
      forM_ [0 .. count - 1] $ \place ->
        case meshTriangle m (number place) of
          Corners a b c -> put target (9 * place) a >> put target (9 * place + 3) b >> put target (9 * place + 6) c
      pure target
    normals = runPrimArray $ do
      target <- newPrimArray (3 * count)
      forM_ [0 .. count - 1] $ \place ->
        -- A mesh has no collinear triangles: there is always a normal.
        put target (3 * place) (maybe 0 (vector . triangleNormal) (triangle (meshTriangle m (number place))))
      pure target
    places = runPrimArray $ do
      target <- newPrimArray (meshSize m)
      forM_ [0 .. count - 1] $ \place -> writePrimArray target (number place) (fromIntegral place)
      forM_ (IntMap.toList again) $ \(i, first) -> readPrimArray target first >>= writePrimArray target i
      pure target
    units = runPrimArray $ do
      target <- newPrimArray (Vector.length (meshNormals m))
      forM_ [0 .. Vector.length (meshNormals m) `div` 3 - 1] $ \j -> put target (3 * j) (maybe 0 vector (unit (meshNormal m j)))
      pure target
    put target k (V3 x y z) = do
      writePrimArray target k x
      writePrimArray target (k + 1) y
      writePrimArray target (k + 2) z

-- | The items of leaves that have very many.
crowded :: Hierarchy -> PrimArray Int
crowded h = primArrayFromList [indexPrimArray (hierarchyOrder h) place | (from, end) <- hierarchyLeaves h, end - from > 64, place <- [from .. end - 1]]

-- | Those of some triangles, given in any order, that have the corners of another with a lower number: each with the
-- first that has them.
repeated :: Mesh -> PrimArray Int -> IntMap Int
repeated m = snd . foldl' look (Map.empty, IntMap.empty) . IntSet.toAscList . IntSet.fromList . primArrayToList
  where
    look (seen, again) i = case Map.lookup key seen of
      Just first -> (seen, IntMap.insert i first again)
      Nothing -> (Map.insert key i seen, again)
      where
        key = let Corners a b c = meshTriangle m i in (toList a, toList b, toList c)

-- | The triangle of that number, from 0 to below the mesh's size, as a shape of its own; smooth if it has normals or
-- texture coordinates.
--
-- Spec: models.obj.smooth.
triangleShape :: Mesh -> Int -> Maybe Shape
triangleShape m i = made <$> triangle (meshTriangle m i)
  where
    made flat
      | isSmooth m i = ASmoothTriangle (smoothTriangle flat (cornerNormal m i <$> Corners 0 1 2) (cornerUvs m i))
      | otherwise = ATriangle flat

-- | The same, prepared.
--
-- Law: as preparing the shape. Nothing is computed anew.
--
-- Spec: models.transformed.
preparedTriangle :: PreparedMesh -> Int -> Maybe Prepared
preparedTriangle p !i
  | i < 0 || i >= meshSize m = Nothing
  | isSmooth m i = Just (ofSmoothTriangle (corner 0) (corner 3) (corner 6) n (normalAtCorner 0) (normalAtCorner 1) (normalAtCorner 2) (cornerUvs m i))
  | otherwise = Just (ofTriangle (corner 0) (corner 3) (corner 6) n)
  where
    m = preparedMesh p
    !place = fromIntegral (indexPrimArray (placeOf p) i)
    corner k = V3 (at (9 * place + k)) (at (9 * place + k + 1)) (at (9 * place + k + 2))
    at = indexPrimArray (cornersAt p)
    n = trustedUnit (V3 (along 0) (along 1) (along 2))
    along k = indexPrimArray (normalsAt p) (3 * place + k)
    normalAtCorner k
      | j >= 0, made /= 0 = trustedUnit made
      | otherwise = fromMaybe n (unit (vector n))
      where
        !j = attribute (meshCornerNormals m) i k
        made = V3 (indexPrimArray (unitsOf p) (3 * j)) (indexPrimArray (unitsOf p) (3 * j + 1)) (indexPrimArray (unitsOf p) (3 * j + 2))
    {-# INLINE normalAtCorner #-}

-- | Whether a triangle has a normal or a texture coordinate at any corner.
isSmooth :: Mesh -> Int -> Bool
isSmooth m i = given (meshCornerNormals m) || given (meshCornerUvs m)
  where
    given numbers = not (Vector.null numbers) && (attribute numbers i 0 >= 0 || attribute numbers i 1 >= 0 || attribute numbers i 2 >= 0)

-- | The number of an attribute at a corner of a triangle, below 0 for none.
attribute :: Vector.Vector Int32 -> Int -> Int -> Int
attribute numbers i k = maybe (-1) fromIntegral (numbers Vector.!? (3 * i + k))
{-# INLINE attribute #-}

cornerNormal :: Mesh -> Int -> Int -> Maybe Vector
cornerNormal m i k
  | j < 0 = Nothing
  | otherwise = Just (meshNormal m j)
  where
    j = attribute (meshCornerNormals m) i k

-- | The normal of a number, as the mesh has it: numbers of corners are below those of normals ("Dioptre.Geometry.Mesh").
meshNormal :: Mesh -> Int -> Vector
meshNormal m j = V3 (meshNormals m Vector.! (3 * j)) (meshNormals m Vector.! (3 * j + 1)) (meshNormals m Vector.! (3 * j + 2))

cornerUvs :: Mesh -> Int -> Corners (V2 Double)
cornerUvs m i = uv . attribute (meshCornerUvs m) i <$> Corners 0 1 2
  where
    uv j = if j < 0 then 0 else V2 (meshUvs m Vector.! (2 * j)) (meshUvs m Vector.! (2 * j + 1))

-- | What a ray meets first among the triangles, and what was met before; the triangle of number i is offered as the
-- given number more.
--
-- Spec: geometry.hit.index.
closestTriangle :: PreparedMesh -> Int -> Ray -> Closest -> Closest
closestTriangle m first r c = case descend (preparedMeshHierarchy m) (approach r) within (closestInRange m first seen r) c of
  Tried found n -> tried n found
  where
    !seen = seenAlong r

-- | The same for the triangles at some places. (In line, as a call would make the loop over the boxes keep its numbers
-- in memory.)
closestInRange :: PreparedMesh -> Int -> Seen -> Ray -> Int -> Int -> Closest -> Closest
closestInRange m !first !seen !r !from !end before@(Closest t0 number0 tests) = go from t0 number0
  where
    !order = numberAt m
    go !place !best !number
      | place >= end = if number == number0 && best == t0 then before else Closest best number tests
      | otherwise = foldr keep (go (place + 1)) (parametersAt m seen r place) best number
      where
        keep t next !b !n
          | t > smallestParameter && precedes t mine b n = next t mine
          | otherwise = next b n
        mine = first + fromIntegral (indexPrimArray order place)
{-# INLINE closestInRange #-}

-- | Whether a ray meets any triangle nearer than a bound, and how many were tried.
anyTriangle :: PreparedMesh -> Ray -> Double -> (Bool, Int)
anyTriangle m r !bound = case descend (preparedMeshHierarchy m) (approach r) (\answer -> if answer then negate infinity else bound) (anyInRange m seen r bound) False of
  Tried answer n -> (answer, n)
  where
    !seen = seenAlong r

-- | The same for the triangles at some places, unless one is known already.
anyInRange :: PreparedMesh -> Seen -> Ray -> Double -> Int -> Int -> Bool -> Bool
anyInRange m !seen !r !bound !from !end known = known || go from
  where
    go !place = place < end && foldr (\t next -> (t > smallestParameter && t < bound) || next) (go (place + 1)) (parametersAt m seen r place)
{-# INLINE anyInRange #-}

-- | How a ray sees corners: which coordinates are x, y and z in the frame in which its direction's largest component is
-- z, the origin in that frame, and the shear that makes the direction the z axis. (Note [Watertight] of
-- "Dioptre.Geometry.Triangle".)
data Seen = Seen {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

seenAlong :: Ray -> Seen
seenAlong r = case direction r of
  V3 dx dy dz
    | abs dz >= abs dx && abs dz >= abs dy -> Seen 0 1 2 ox oy oz (dx / dz) (dy / dz)
    | abs dy >= abs dx -> Seen 2 0 1 oz ox oy (dz / dy) (dx / dy)
    | otherwise -> Seen 1 2 0 oy oz ox (dy / dx) (dz / dx)
  where
    V3 ox oy oz = origin r
{-# INLINE seenAlong #-}

-- | 'triangleParameters' of the triangle at a place: the same numbers in the same order of operations.
parametersAt :: PreparedMesh -> Seen -> Ray -> Int -> [Double]
parametersAt m (Seen kx ky kz ox oy oz sx sy) r !place =
  [ t
    | (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0),
      u /= 0 || v /= 0 || w /= 0,
      t <- planeParameters (V3 (corner 0) (corner 1) (corner 2)) (trustedUnit (V3 (normal 0) (normal 1) (normal 2))) r
  ]
  where
    corner k = indexPrimArray (cornersAt m) (9 * place + k)
    normal k = indexPrimArray (normalsAt m) (3 * place + k)
    -- The corners' places across the ray.
    !az = corner kz - oz
    !ax = (corner kx - ox) - sx * az
    !ay = (corner ky - oy) - sy * az
    !bz = corner (3 + kz) - oz
    !bx = (corner (3 + kx) - ox) - sx * bz
    !by = (corner (3 + ky) - oy) - sy * bz
    !cz = corner (6 + kz) - oz
    !cx = (corner (6 + kx) - ox) - sx * cz
    !cy = (corner (6 + ky) - oy) - sy * cz
    -- The edge functions.
    !u = cx * by - cy * bx
    !v = ax * cy - ay * cx
    !w = bx * ay - by * ax
{-# INLINE parametersAt #-}
