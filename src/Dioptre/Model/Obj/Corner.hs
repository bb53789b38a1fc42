{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Model.Obj.Corner
-- Description : A corner of a face, as it is written
--
-- > corner = index ["/" [index] ["/" [index]]]     ; vertex, texture coordinate, normal
-- > index  = ["+" / "-"] 1*digit
--
-- A part without a number is a part that is not there: @1\/@ and @1\/\/@ are @1@.
module Dioptre.Model.Obj.Corner
  ( Corner (..),
    cornerAt,

    -- * Parts
    Parts,
    uvPart,
    normalPart,
    notACorner,

    -- * Indices
    place,
    isThere,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Dioptre.Model.Words (byteAt, digit, isBlank, isDigit, minus, plus, slash)

-- | What a corner says: where it ends; the numbers of its vertex, texture coordinate and normal as written, 0 for what
-- it has not; and which of the last two it has.
data Corner
  = Corner {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Parts

-- | Which parts a corner has besides the vertex: a set of the bits 'uvPart' and 'normalPart', or 'notACorner'.
type Parts = Int

-- | It has a texture coordinate.
uvPart :: Int
uvPart = 0

-- | It has a normal.
normalPart :: Int
normalPart = 1

-- | What has not even a vertex.
notACorner :: Parts
notACorner = -1

-- | The corner at a place of a line that is not blank.
--
-- Spec: models.obj.faces.
cornerAt :: ByteString -> Int -> Corner
cornerAt bytes from
  | end0 > from && (end2 >= n || isBlank (byteAt bytes end2)) = Corner end2 v t k ((if end1 > end0 + 1 then 1 else 0) + (if end2 > end1 + 1 then 2 else 0))
  | otherwise = Corner from 0 0 0 notACorner
  where
    n = Bytes.length bytes
    isSlash i = i < n && byteAt bytes i == slash
    !(Index end0 v) = indexAt bytes from
    !(Index end1 t) = if isSlash end0 then indexAt bytes (end0 + 1) else Index end0 0
    !(Index end2 k) = if end1 > end0 && isSlash end1 then indexAt bytes (end1 + 1) else Index end1 0

-- | Where an integer ends, and its value. It ends where it begins if there is none.
data Index = Index {-# UNPACK #-} !Int {-# UNPACK #-} !Int

-- | The integer, with or without a sign, at a place of a line. From 2^31 - 1 on it may come out as any number from
-- there on: no vector of a mesh is as long.
indexAt :: ByteString -> Int -> Index
indexAt bytes from = digits start 0
  where
    !n = Bytes.length bytes
    byte = byteAt bytes
    !isNegative = from < n && byte from == minus
    !start = if from < n && (byte from == minus || byte from == plus) then from + 1 else from
    digits :: Int -> Int -> Index
    digits !i !m
      | i < n, isDigit (byte i) = digits (i + 1) (if m < 0x7fffffff then 10 * m + digit (byte i) else m)
      | i == start = Index from 0
      | otherwise = Index i (if isNegative then negate m else m)

-- | Where the thing of that number is, counted from 0, where there are so many of them: 1 is the first one, and -1 the
-- last.
--
-- Spec: models.obj.indices.
place :: Int -> Int -> Int
place count i
  | i > 0 = i - 1
  | i < 0 = count + i
  | otherwise = -1
{-# INLINE place #-}

-- | Whether a place is among so many things.
--
-- Spec: models.obj.indices.
isThere :: Int -> Int -> Bool
isThere i count = i >= 0 && i < count
{-# INLINE isThere #-}
