{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Obj.Vertices
-- Description : Vertices, normals and texture coordinates of an OBJ file
--
-- > v  x y z        vt u [v]        vn x y z
--
-- Three lists, in which faces look things up by their places from 0. A line that cannot be read takes its place all the
-- same, so that the numbers of the others stay theirs: a vertex is then a bad one, which no face can use, a normal is
-- zero, which is as good as none, and a texture coordinate is (0, 0), which is also what a corner without one has.
module Dioptre.Model.Obj.Vertices
  ( Vertices,
    newVertices,

    -- * Reading
    vertex,
    normal,
    textureCoordinate,

    -- * Looking up
    pointCount,
    normalCount,
    uvCount,
    pointAt,
    isBadPoint,
    isZeroNormal,

    -- * The end
    settledPoints,
    settledNormals,
    settledUvs,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Vector.Unboxed (Vector)
import Dioptre.Math.Order (finite)
import Dioptre.Math.Vector (Packed, packed)
import Dioptre.Model.Growing
import Dioptre.Model.Obj.Faults (Faults, excerptOf, report)
import Dioptre.Model.Obj.Lines (Line (..))
import Dioptre.Model.Single (Scanned (..), scan)
import Dioptre.Model.Words (blanksFrom, byteAt, hash, wordFrom)
import Dioptre.Source.Diagnostic (Attribute (..), Coordinates (..), Guess (NoGuess), Problem (BadCoordinates), Refusal (NotANumber, NothingThere, TooLarge, WrongCount))
import GHC.Float (double2Float, float2Double)
import Linear.V3 (V3 (..))

-- | What has been read so far. Numbers are kept as singles, which they are, to take half the room.
data Vertices s = Vertices
  { -- | Three numbers for each vertex.
    verticesPoints :: !(Growing s Float),
    -- | Three for each normal.
    verticesNormals :: !(Growing s Float),
    -- | Two for each texture coordinate.
    verticesUvs :: !(Growing s Float),
    -- | How many vertices could not be read. They are NaN until the end.
    verticesBadPoints :: !(Counter s),
    -- | How many normals are zero or could not be read. They are zero.
    verticesZeroNormals :: !(Counter s)
  }

-- | Nothing has been read.
newVertices :: ST s (Vertices s)
newVertices = Vertices <$> newGrowing <*> newGrowing <*> newGrowing <*> newCounter 0 <*> newCounter 0

-- | Reads a @v@ at this place.
--
-- Spec: models.obj.vertices, models.obj.bad-vertex.
vertex :: Faults s -> Vertices s -> Line -> Int -> ST s ()
vertex faults vs line@(Line bytes _ _) start
  -- Singles as doubles add up without overflow, so the sum of some of them is finite only if all are.
  | finite (x + y + z) = push3 (verticesPoints vs) (double2Float x) (double2Float y) (double2Float z)
  | otherwise = do
    push3 (verticesPoints vs) (0 / 0) 0 0
    increase (verticesBadPoints vs) 1
    refusedNumbers faults line start OfVertex
  where
    Triple x y z = triple bytes (start + 1)

-- | Reads a @vn@ at this place.
--
-- Spec: models.obj.vertices.
normal :: Faults s -> Vertices s -> Line -> Int -> ST s ()
normal faults vs line@(Line bytes _ _) start
  | finite (x + y + z) = do
    push3 (verticesNormals vs) (double2Float x) (double2Float y) (double2Float z)
    when (x == 0 && y == 0 && z == 0) $ increase (verticesZeroNormals vs) 1
  | otherwise = do
    push3 (verticesNormals vs) 0 0 0
    increase (verticesZeroNormals vs) 1
    refusedNumbers faults line start (OfAttribute Normal)
  where
    Triple x y z = triple bytes (start + 2)

-- | Reads a @vt@ at this place.
--
-- Spec: models.obj.vertices.
textureCoordinate :: Faults s -> Vertices s -> Line -> Int -> ST s ()
textureCoordinate faults vs line@(Line bytes _ _) start
  | finite (u + v) = push2 (verticesUvs vs) (double2Float u) (double2Float v)
  | otherwise = do
    push2 (verticesUvs vs) 0 0
    refusedNumbers faults line start (OfAttribute TextureCoordinate)
  where
    Scanned end u = scan bytes (blanksFrom bytes (start + 2))
    second = blanksFrom bytes end
    v
      | second >= Bytes.length bytes || byteAt bytes second == hash = 0
      | otherwise = let Scanned _ x = scan bytes second in x

-- | Three numbers; NaN for what is none or not there.
data Triple = Triple {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The three numbers from a place of a line on.
triple :: ByteString -> Int -> Triple
triple bytes start = Triple x y z
  where
    Scanned end0 x = scan bytes (blanksFrom bytes start)
    Scanned end1 y = scan bytes (blanksFrom bytes end0)
    Scanned _ z = scan bytes (blanksFrom bytes end1)

-- | Tells why the numbers of the line whose word begins there, three of them or at least one, cannot be read.
refusedNumbers :: Faults s -> Line -> Int -> Coordinates -> ST s ()
refusedNumbers faults line@(Line bytes _ _) start what = go (0 :: Int) wordEnd
  where
    n = Bytes.length bytes
    wordEnd = wordFrom bytes start
    wanted = 3
    go count from
      | i >= n && count == 0 = refused start wordEnd NothingThere
      | i >= n || count == wanted = refused start from (WrongCount wanted count NoGuess)
      | isNaN x = refused i end (NotANumber (excerptOf bytes i end))
      | isInfinite x = refused i end (TooLarge (excerptOf bytes i end))
      | otherwise = go (count + 1) end
      where
        i = blanksFrom bytes from
        Scanned end x = scan bytes i
    refused from to why = report faults line from to (BadCoordinates what why)

-------------------------------------------------------------------------------
-- Looking up

-- | How many vertices there are.
pointCount :: Vertices s -> ST s Int
pointCount vs = (`quot` 3) <$> size (verticesPoints vs)
{-# INLINE pointCount #-}

-- | How many normals there are.
normalCount :: Vertices s -> ST s Int
normalCount vs = (`quot` 3) <$> size (verticesNormals vs)
{-# INLINE normalCount #-}

-- | How many texture coordinates there are.
uvCount :: Vertices s -> ST s Int
uvCount vs = (`quot` 2) <$> size (verticesUvs vs)
{-# INLINE uvCount #-}

-- | The point of a vertex. Here and below, the place is from 0 to below the count: the caller has looked.
pointAt :: Vertices s -> Int -> ST s Packed
pointAt vs i = do
  x <- at (verticesPoints vs) (3 * i)
  y <- at (verticesPoints vs) (3 * i + 1)
  z <- at (verticesPoints vs) (3 * i + 2)
  pure $! packed (V3 (float2Double x) (float2Double y) (float2Double z))
{-# INLINE pointAt #-}

-- | Whether a vertex could not be read.
--
-- Spec: models.obj.bad-vertex.
isBadPoint :: Vertices s -> Int -> ST s Bool
isBadPoint vs i = do
  count <- current (verticesBadPoints vs)
  if count == 0 then pure False else isNaN <$> at (verticesPoints vs) (3 * i)
{-# INLINE isBadPoint #-}

-- | Whether a normal is zero.
--
-- Spec: models.obj.bad-vertex.
isZeroNormal :: Vertices s -> Int -> ST s Bool
isZeroNormal vs i = do
  count <- current (verticesZeroNormals vs)
  if count == 0
    then pure False
    else do
      x <- at (verticesNormals vs) (3 * i)
      y <- at (verticesNormals vs) (3 * i + 1)
      z <- at (verticesNormals vs) (3 * i + 2)
      pure (x == 0 && y == 0 && z == 0)
{-# INLINE isZeroNormal #-}

-------------------------------------------------------------------------------
-- The end

-- | The numbers of all vertices, which are no longer here; 0 for NaN.
settledPoints :: Vertices s -> ST s (Vector Double)
settledPoints vs = do
  bad <- current (verticesBadPoints vs)
  settledAs (if bad == 0 then float2Double else \x -> if isNaN x then 0 else float2Double x) (verticesPoints vs)

-- | The numbers of all normals, which are no longer here.
settledNormals :: Vertices s -> ST s (Vector Double)
settledNormals = settledAs float2Double . verticesNormals

-- | The numbers of all texture coordinates, which are no longer here.
settledUvs :: Vertices s -> ST s (Vector Double)
settledUvs = settledAs float2Double . verticesUvs
