{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Obj
-- Description : OBJ files, piece by piece
--
-- Wavefront's OBJ, which nearly every program that models writes. A line says one thing, its first word what:
--
-- > v  x y z                  a vertex                     usemtl NAME      the material of the faces below
-- > vt u [v]                  a texture coordinate         mtllib NAME      a file of materials (see "Dioptre.Model.Mtl")
-- > vn x y z                  a normal                     # ...            a comment
-- > f  1 2 3                  a polygon of three corners or more, by the numbers of their vertices; each corner is
-- >                           i, i/t, i//n or i/t/n: vertex, texture coordinate, normal
--
-- Numbers count from 1 in the order of the file; negative ones count back from the line (-1 is the last vertex before
-- it). Further numbers of a v, vt or vn (w, a colour) are passed over, and so are lines with other words (o, g, s, l
-- ...). Source: Paul Bourke's copy of the format's description, <http://paulbourke.net/dataformats/obj/>.
--
-- The file is read in one go, in pieces of any size, into flat vectors: what is kept of it is its triangles, and never
-- its text. A fault costs a line or a face, never the model. See Note [Before its face].
--
-- > pieces --> lines --> vertices --+--> triangles --> mesh
-- >              |                  |
-- >              +-----> faces -----+
-- >              |                  |
-- >              +---> materials ---+
--
-- Each of these is a module below this one; faults may turn up in all of them, and come together in
-- "Dioptre.Model.Obj.Faults".
module Dioptre.Model.Obj
  ( -- * What is read
    Obj (..),
    Named (..),
    Counts (..),

    -- * Reading
    readObj,
    Reader,
    newReader,
    feed,
    finish,

    -- * Limits
    longestLine,
    mostLines,
    mostLibraries,
  )
where

import Control.Monad.ST (ST, runST)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Text (Text)
import Dioptre.Geometry.Mesh (Mesh)
import Dioptre.Model.Obj.Faces (Counts (..), Faces, countsOf, face, facesTriangles, newFaces, toldOfFaces)
import Dioptre.Model.Obj.Faults (Faults, newFaults, report, shownLines, told)
import Dioptre.Model.Obj.Lines (Line (..), Lines, endLines, feedLines, longestLine, mostLines, newLines)
import Dioptre.Model.Obj.Materials (Materials, Named (..), librariesNamed, materialLibrary, materialsInUse, mostLibraries, newMaterials, useMaterial)
import Dioptre.Model.Obj.Triangles (meshOf)
import Dioptre.Model.Obj.Vertices (Vertices, newVertices, normal, textureCoordinate, vertex)
import Dioptre.Model.Words (blanksFrom, byteAt, isBlank)
import Dioptre.Source.Diagnostic (Diagnostic, Problem (LongLine))

-- | What an OBJ file holds.
data Obj = Obj
  { -- | The triangles, in the order of their faces. Their finishes are places in 'objMaterials'.
    objMesh :: Mesh,
    -- | The materials that faces use, in the order of first use; each with the place that names it first.
    objMaterials :: [Named],
    -- | The libraries that are to have those, in the order of the file, each once.
    objLibraries :: [Named],
    -- | How much there is.
    objCounts :: Counts,
    -- | What is wrong, in the order of the file: 'Dioptre.Source.Diagnostic.keptInFull' faults and the number of the
    -- others, and what is told of all faces at once.
    objDiagnostics :: [Diagnostic],
    -- | The lines that places in here point to, by their numbers, for messages ('Dioptre.Source.Text.excerpts'). Of
    -- long ones, the beginning.
    objLines :: [(Int, Text)]
  }
  deriving stock (Eq, Show)

-- | The file with these bytes. Its pieces are not kept.
readObj :: Lazy.ByteString -> Obj
readObj bytes = runST $ do
  r <- newReader
  mapM_ (feed r) (Lazy.toChunks bytes)
  finish r

-- | A file of which a part has been read.
data Reader s = Reader
  { -- | Where in the file that is.
    readerLines :: !(Lines s),
    -- | What is wrong with it.
    readerFaults :: !(Faults s),
    -- | Its vertices, normals and texture coordinates.
    readerVertices :: !(Vertices s),
    -- | Its faces.
    readerFaces :: !(Faces s),
    -- | Its materials.
    readerMaterials :: !(Materials s)
  }

-- | A reading that has not begun.
newReader :: ST s (Reader s)
newReader = Reader <$> newLines <*> newFaults <*> newVertices <*> newFaces <*> newMaterials

-- | Reads on. Law: how a file is cut into pieces changes nothing.
feed :: Reader s -> ByteString -> ST s ()
feed r = feedLines (statement r) (tooLong r) (readerLines r)

-- | What the file holds, when all of it has been fed.
finish :: Reader s -> ST s Obj
finish r = do
  endLines (statement r) (tooLong r) (readerLines r)
  !mesh <- meshOf (readerVertices r) (facesTriangles (readerFaces r))
  materials <- materialsInUse (readerMaterials r)
  libraries <- librariesNamed (readerMaterials r)
  !counts <- countsOf (readerFaces r)
  diagnostics <- toldOfFaces (readerFaces r) >>= told (readerFaults r)
  Obj mesh materials libraries counts diagnostics <$> shownLines (readerFaults r)

-- | Tells of a line that is too long, by its number.
tooLong :: Reader s -> Int -> ST s ()
tooLong r number = report (readerFaults r) (Line Bytes.empty number []) 0 0 (LongLine longestLine)

-- | Reads a line by its first word.
statement :: Reader s -> Line -> ST s ()
statement r line@(Line bytes _ _)
  | start >= n = pure ()
  | otherwise = case byte start of
    118 -- v
      | endsAt (start + 1) -> vertex faults (readerVertices r) line start
      | endsAt (start + 2), byte (start + 1) == 116 -> textureCoordinate faults (readerVertices r) line start -- vt
      | endsAt (start + 2), byte (start + 1) == 110 -> normal faults (readerVertices r) line start -- vn
    102 | endsAt (start + 1) -> face faults (readerVertices r) (readerMaterials r) (readerFaces r) line start -- f
    117 | Just at <- begins "usemtl" -> useMaterial faults (readerMaterials r) line start at
    109 | Just at <- begins "mtllib" -> materialLibrary faults (readerMaterials r) line start at
    _ -> pure ()
  where
    faults = readerFaults r
    n = Bytes.length bytes
    start = blanksFrom bytes 0
    -- Only asked below n: a place that is not at an end is.
    byte = byteAt bytes
    endsAt i = i >= n || isBlank (byte i)
    begins word
      | word `Bytes.isPrefixOf` Bytes.drop start bytes && endsAt (start + Bytes.length word) = Just (blanksFrom bytes (start + Bytes.length word))
      | otherwise = Nothing

-- Note [Before its face]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- A face may use what stands before it in the file, and nothing behind: with that, a triangle is looked at once, and a
-- fault is told with its line. Files with the faces first would need their text to be kept, or their faces to be gone
-- through again.
