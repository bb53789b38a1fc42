{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Mesh
-- Description : Many triangles in few numbers
--
-- >     4-----3          points     x0 y0 z0  x1 y1 z1 ...      three numbers a vertex
-- >    / \   / \         corners    0 1 2     0 2 3    ...      three vertex numbers a triangle
-- >   /   \ /   \
-- >  0-----2-----...     A vertex is stored once, however many triangles meet in it.
--
-- Models come with a million triangles, of which a list of 'Dioptre.Geometry.Shape.Shape' would take a gigabyte. A mesh
-- is the same thing as flat vectors without a pointer in them. Its triangles are those of "Dioptre.Geometry.Triangle",
-- and 'meshTriangle' gives any of them.
module Dioptre.Geometry.Mesh
  ( Mesh (..),
    meshSize,
    meshTriangle,
    noAttribute,
  )
where

import Data.Int (Int32)
import Data.Vector.Unboxed (Vector)
import qualified Data.Vector.Unboxed as Vector
import Dioptre.Geometry.Triangle (Corners (..))
import Dioptre.Math.Vector (Point)
import Linear.V3 (V3 (..))

-- | Triangles over shared vertices.
--
-- Invariants: every number of a vertex, normal or texture coordinate is one that is there (or 'noAttribute' where that
-- may stand); no triangle is collinear by 'Dioptre.Geometry.Triangle.triangle''s measure; the vectors of a triangle
-- have the lengths that are said.
data Mesh = Mesh
  { -- | Three coordinates a vertex.
    meshPoints :: !(Vector Double),
    -- | Three components a normal; of any length.
    meshNormals :: !(Vector Double),
    -- | Two coordinates each, u and v.
    meshUvs :: !(Vector Double),
    -- | Three vertex numbers a triangle, counted from 0.
    meshCorners :: !(Vector Int32),
    -- | Three normal numbers a triangle; empty where no triangle is smooth. 'noAttribute' for a corner without one,
    -- which has the flat triangle's.
    meshCornerNormals :: !(Vector Int32),
    -- | Three texture coordinate numbers a triangle; empty where no triangle has any. 'noAttribute' for a corner
    -- without one, which has (0, 0).
    meshCornerUvs :: !(Vector Int32),
    -- | Each triangle's finish, by its number in the model that the mesh is of.
    meshFinishes :: !(Vector Int32)
  }
  deriving stock (Eq, Show)

-- | What stands for the number of a normal or texture coordinate that is not given.
noAttribute :: Int32
noAttribute = -1

-- | How many triangles there are.
meshSize :: Mesh -> Int
meshSize m = Vector.length (meshCorners m) `div` 3

-- | The corners of the triangle of that number, from 0 to below the size.
meshTriangle :: Mesh -> Int -> Corners Point
meshTriangle m i = Corners (corner 0) (corner 1) (corner 2)
  where
    corner k = let v = 3 * fromIntegral (meshCorners m Vector.! (3 * i + k)) in V3 (coordinate v) (coordinate (v + 1)) (coordinate (v + 2))
    coordinate = (meshPoints m Vector.!)
