{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Obj.Faces
-- Description : Faces of an OBJ file
--
-- > f 1 2 3     f 1/4 2/5 3/6     f 1//7 2//8 3//9     f 1/4/7 2/5/8 3/6/9
--
-- A face is a polygon of three corners or more, all written with the same parts (see "Dioptre.Model.Obj.Corner"). One
-- with a corner that cannot be read, or whose vertex is not there, is left out; one that names a texture coordinate or
-- a normal that is not there goes without, at all its corners.
module Dioptre.Model.Obj.Faces
  ( Counts (..),

    -- * Reading
    Faces,
    newFaces,
    face,

    -- * The end
    facesTriangles,
    countsOf,
    toldOfFaces,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.Bits (clearBit, testBit)
import qualified Data.ByteString as Bytes
import Data.Int (Int32)
import Dioptre.Geometry.Mesh (noAttribute)
import Dioptre.Model.Growing
import Dioptre.Model.Obj.Corner
import Dioptre.Model.Obj.Faults (Faults, Tally, excerptOf, newTally, report, tallied, tally, toldOnce)
import Dioptre.Model.Obj.Lines (Line (..))
import Dioptre.Model.Obj.Materials (Materials, materialNumber)
import Dioptre.Model.Obj.Triangles (Triangles, collinear, fan, newTriangles)
import Dioptre.Model.Obj.Vertices
import Dioptre.Model.Words (blanksFrom, byteAt, hash, isBlank, slash, wordFrom)
import Dioptre.Source.Diagnostic (Attribute (..), Diagnostic, FaceFlaw (..), Problem (BadFace, CollinearTriangles, MissingAttribute, MissingVertex, NoAttributes))

-- | How much there is in a file.
data Counts = Counts
  { -- | Faces with three corners.
    countTriangles :: !Int,
    -- | Faces with four.
    countQuads :: !Int,
    -- | Faces with more.
    countPolygons :: !Int,
    -- | Faces that are left out, or that are without something that they name.
    countErrors :: !Int,
    -- | Triangles that are left out, as their corners lie on one line.
    countCollinear :: !Int
  }
  deriving stock (Eq, Show)

-- | What has been read so far.
data Faces s = Faces
  { -- | The triangles of the faces, in their order.
    facesTriangles :: !(Triangles s),
    -- | The face that is being read: vertex, texture coordinate and normal of each corner.
    facesCurrent :: !(Growing s Int32),
    -- | How many faces have three corners,
    facesOfThree :: !(Counter s),
    -- | four,
    facesOfFour :: !(Counter s),
    -- | more.
    facesOfMore :: !(Counter s),
    -- | See 'countErrors'.
    facesErrors :: !(Counter s),
    -- | Faces that name a texture coordinate where none is in the file so far.
    facesWithoutUvs :: !(Tally s),
    -- | The same for normals.
    facesWithoutNormals :: !(Tally s)
  }

-- | Nothing has been read.
newFaces :: ST s (Faces s)
newFaces = Faces <$> newTriangles <*> newGrowing <*> newCounter 0 <*> newCounter 0 <*> newCounter 0 <*> newCounter 0 <*> newTally <*> newTally

-- | Reads an @f@ at this place.
--
-- Spec: models.obj.faces.
face :: Faults s -> Vertices s -> Materials s -> Faces s -> Line -> Int -> ST s ()
face faults vertices materials fs line@(Line bytes _ _) start = do
  clear (facesCurrent fs)
  !points <- pointCount vertices
  !normals <- normalCount vertices
  !uvs <- uvCount vertices
  let -- So many corners have been read. The first one begins at that place and has those parts; of these, some are there so far.
      corners !from !count !first !form !there
        | i < n && byteAt bytes i /= hash = case cornerAt bytes i of
          Corner end v t k parts
            | parts == notACorner -> faulty i (BadFace (NotACorner (wordAt i)))
            | count > 0 && parts /= form -> faulty i (BadFace (OtherForm (wordAt i) (wordAt first)))
            | not (isThere vertexAt points) -> faulty i (MissingVertex (digitsFrom i) points)
            | otherwise -> do
              bad <- isBadPoint vertices vertexAt
              if bad
                then wrong
                else do
                  when (testBit earlier uvPart && not uvThere) $ missing i (facesWithoutUvs fs) TextureCoordinate (digitsFrom (behindSlash i)) uvs
                  when (testBit earlier normalPart && not normalThere) $ missing i (facesWithoutNormals fs) Normal (digitsFrom (behindSlash (behindSlash i))) normals
                  useful <- if normalThere then not <$> isZeroNormal vertices normalAt else pure False
                  push3
                    (facesCurrent fs)
                    (fromIntegral vertexAt)
                    (if uvThere then fromIntegral uvAt else noAttribute)
                    (if useful then fromIntegral normalAt else noAttribute)
                  corners end (count + 1) (if count == 0 then i else first) parts (without normalPart normalThere (without uvPart uvThere earlier))
            where
              -- A face tells once of a part that is not there.
              earlier = if count == 0 then parts else there
              vertexAt = place points v
              uvAt = place uvs t
              normalAt = place normals k
              uvThere = isThere uvAt uvs
              normalThere = isThere normalAt normals
        | count < 3 = report faults line start (min n from) (BadFace (TooFewCorners count)) >> wrong
        | otherwise = do
          when (there /= form) wrong
          increase (if count == 3 then facesOfThree fs else if count == 4 then facesOfFour fs else facesOfMore fs) 1
          material <- materialNumber faults materials line start
          fan faults vertices (facesTriangles fs) (facesCurrent fs) there material line start
        where
          i = blanksFrom bytes from
  corners (start + 1) (0 :: Int) start 0 0
  where
    n = Bytes.length bytes
    wrong = increase (facesErrors fs) 1
    faulty i problem = report faults line i (wordFrom bytes i) problem >> wrong
    -- Where the file has none of them so far, all faces with that fault are told of at once: leaving out its normals is
    -- a way to draw a model flat.
    missing i counter attribute number count
      | count == 0 = tally faults counter line i (wordFrom bytes i)
      | otherwise = report faults line i (wordFrom bytes i) (MissingAttribute attribute number count)
    without part isIt parts = if isIt then parts else clearBit parts part
    wordAt i = excerptOf bytes i (wordFrom bytes i)
    digitsFrom i = excerptOf bytes i (i + Bytes.length (Bytes.takeWhile (\b -> b /= slash && not (isBlank b)) (Bytes.drop i bytes)))
    behindSlash i = i + 1 + Bytes.length (Bytes.takeWhile (/= slash) (Bytes.drop i bytes))

-- | How much there is.
countsOf :: Faces s -> ST s Counts
countsOf fs =
  Counts
    <$> current (facesOfThree fs)
    <*> current (facesOfFour fs)
    <*> current (facesOfMore fs)
    <*> current (facesErrors fs)
    <*> tallied (collinear (facesTriangles fs))

-- | What is told of all faces at once.
toldOfFaces :: Faces s -> ST s [Diagnostic]
toldOfFaces fs =
  concat
    <$> sequence
      [ toldOnce CollinearTriangles (collinear (facesTriangles fs)),
        toldOnce (NoAttributes TextureCoordinate) (facesWithoutUvs fs),
        toldOnce (NoAttributes Normal) (facesWithoutNormals fs)
      ]
