{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE GeneralizedNewtypeDeriving #-}
{-# LANGUAGE UnboxedTuples #-}

-- |
-- Module      : Dioptre.Geometry.Link
-- Description : What a node of a hierarchy leads to, in one word
--
-- >             bits 63 to 32        31 to 1            0
-- >   leaf     |  place             |  count          | 1 |     so many items, from that place on
-- >
-- >             bits 63 to 3            2 and 1         0
-- >   fork     |  ahead               | coordinate    | 0 |     the second part begins so many nodes ahead (the first is the next node);
-- >                                                             along the coordinate, its items have the greater centres
--
-- A ray that comes into a box reads one word to know what is in it. A node takes eight words, so that a fork's link
-- with its lowest three bits cleared is how many words ahead the second part is: nothing is multiplied.
module Dioptre.Geometry.Link
  ( Link,

    -- * Leaves
    leafLink,
    isLeaf,
    placesOf,
    leafAfter,

    -- * Forks
    forkLink,
    coordinateOf,
    wordsAhead,
    nodeWords,
  )
where

import Data.Bits (complement, shiftL, shiftR, (.&.), (.|.))
import Data.Primitive.Types (Prim)

-- | The link of a leaf or of a fork.
newtype Link = Link Int
  deriving newtype (Eq, Show, Prim)

-- | A leaf: from that place on, so many items; of either less than 2^31.
--
-- >>> import Dioptre.Geometry.Link
-- >>> placesOf (leafLink 3 4)
-- (3,7)
leafLink :: Int -> Int -> Link
leafLink place n = Link ((place `shiftL` 32) .|. (n `shiftL` 1) .|. 1)

-- | Whether it is a leaf.
isLeaf :: Link -> Bool
isLeaf (Link l) = l .&. 1 == 1
{-# INLINE isLeaf #-}

-- | The places of a leaf: the first, and the one behind the last.
placesOf :: Link -> (Int, Int)
placesOf (Link l) = let place = l `shiftR` 32 in (place, place + ((l `shiftR` 1) .&. 0x7fffffff))
{-# INLINE placesOf #-}

-- | The same link where the items stand so many places farther on.
leafAfter :: Int -> Link -> Link
leafAfter n (Link l) = if isLeaf (Link l) then Link (l + (n `shiftL` 32)) else Link l
{-# INLINE leafAfter #-}

-- | A fork: its second part is so many nodes ahead, and its parts lie along that coordinate, 0, 1 or 2 for x, y or z.
--
-- >>> import Dioptre.Geometry.Link
-- >>> (coordinateOf (forkLink 5 2), wordsAhead (forkLink 5 2))
-- (2,40)
forkLink :: Int -> Int -> Link
forkLink ahead coordinate = Link ((ahead `shiftL` 3) .|. (coordinate `shiftL` 1))

-- | The coordinate along which the parts of a fork lie.
coordinateOf :: Link -> Int
coordinateOf (Link l) = (l `shiftR` 1) .&. 3
{-# INLINE coordinateOf #-}

-- | How many words ahead the second part of a fork is: so many nodes of 'nodeWords' each.
wordsAhead :: Link -> Int
wordsAhead (Link l) = l .&. complement 7
{-# INLINE wordsAhead #-}

-- | How many words a node takes.
nodeWords :: Int
nodeWords = 8
