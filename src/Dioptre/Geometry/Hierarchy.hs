{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Hierarchy
-- Description : Boxes in boxes
--
-- >   +-----------------------+            1                 numbered depth first:
-- >   | +--------+  +-------+ |          /   \               what is first is next,
-- >   | | a    b |  |   +-+ | |        2       3             what is second is linked
-- >   | |        |  | c |d| | |      a b     /   \
-- >   | +--------+  +---+-+-+ |             4     5
-- >   +-----------------------+             c     d
--
-- A bounding-volume hierarchy: items, each in its box along the axes, are split in two, and again, until few are left;
-- each part has the box of its items. A ray that misses a box misses everything in it, and so the cost of a ray grows
-- like the logarithm of the number of items.
--
-- The hierarchy knows nothing of what the items are. It gives them an order, in which those of a leaf stand side by
-- side, and 'descend' leads a ray to them, those near its origin first.
--
-- Items that have no box, such as planes, are held apart: every ray tries them.
--
-- It is stored flat, without pointers.
--
-- How the items are split is told in "Dioptre.Geometry.Partition".
module Dioptre.Geometry.Hierarchy
  ( -- * Building
    Hierarchy,
    hierarchy,
    hierarchyOrder,
    hierarchyNodes,
    hierarchyDepth,
    hierarchyBox,
    hierarchyLeaves,

    -- * Following a ray
    descend,
    Tried (..),
  )
where

import Control.Monad (forM_, unless, when)
import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.Primitive.ByteArray
import Data.Primitive.PrimArray
import Data.Word (Word64)
import Dioptre.Geometry.Box (Approach, Box, box, boxFace, meets, runsDown)
import Dioptre.Geometry.Link
import Dioptre.Geometry.Partition (Part (..), partition)
import Dioptre.Math.Order (infinity)
import Linear.V3 (V3 (..))

-- | Boxes in boxes over items that are known by their numbers, from 0 up.
data Hierarchy = Hierarchy
  { -- | The numbers of the items, by their places: those without a box first, then leaf by leaf.
    hierarchyOrder :: !(PrimArray Int),
    -- | How many items have no box.
    boxless :: {-# UNPACK #-} !Int,
    -- | Eight words a node, which is a line of a processor's cache: six numbers, low x, y, z, high x, y, z; its link,
    -- which says where its parts or its items are; and the place of the first word of the fork that it is a part of (of
    -- the first node, its own).
    nodes :: {-# UNPACK #-} !ByteArray,
    -- | How many nodes there are.
    hierarchyNodes :: {-# UNPACK #-} !Int,
    -- | How many boxes are around one item at most.
    hierarchyDepth :: {-# UNPACK #-} !Int
  }
  deriving stock (Eq, Show)

-- | The box around everything; 'Nothing' if something has none, or there is nothing.
hierarchyBox :: Hierarchy -> Maybe Box
hierarchyBox h
  | hierarchyNodes h == 0 || boxless h > 0 = Nothing
  | otherwise = box (V3 (face 0) (face 1) (face 2)) (V3 (face 3) (face 4) (face 5))
  where
    face = faceOf h 0

-- | The places of each leaf: the first, and the one behind the last.
hierarchyLeaves :: Hierarchy -> [(Int, Int)]
hierarchyLeaves h = [placesOf link | node <- [0 .. hierarchyNodes h - 1], let link = linkOf h (nodeWords * node), isLeaf link]

-- In what follows a node is known by the place of its first word.

-- | One of the six numbers of a node.
faceOf :: Hierarchy -> Int -> Int -> Double
faceOf h node k = indexByteArray (nodes h) (node + k)
{-# INLINE faceOf #-}

-- | The link of a node.
linkOf :: Hierarchy -> Int -> Link
linkOf h node = indexByteArray (nodes h) (node + 6)
{-# INLINE linkOf #-}

-- | The fork that a node is a part of.
forkOver :: Hierarchy -> Int -> Int
forkOver h node = indexByteArray (nodes h) (node + 7)
{-# INLINE forkOver #-}

-------------------------------------------------------------------------------
-- Following a ray

-- | What a descent found, and how many items were in the ranges that it gave (all of them count, also where the first
-- one was enough).
data Tried found = Tried found !Int

-- | Leads a ray to the items that it may meet, near ones first where that is known; to those without a box first of
-- all. What has been found so far says how far the ray still matters. Items are given in ranges: the first place in
-- 'hierarchyOrder', and the place behind the last.
--
-- Law: every item is in one of the ranges that has no box, or whose box the ray meets no farther than what has been
-- found when its turn comes.
--
-- Cost: a test of a box for each part that is not passed over whole. See Note [A trail instead of a stack].
--
-- Spec: geometry.hit.index.
descend :: Hierarchy -> Approach -> (found -> Double) -> (Int -> Int -> found -> found) -> found -> Tried found
descend h a far range found0
  | hierarchyNodes h == 0 = Tried first (boxless h)
  | otherwise = visit 0 (0 :: Word64) (far first) first (boxless h)
  where
    !first = if boxless h > 0 then range 0 (boxless h) found0 else found0
    -- Places of nodes are within the array: 0 is, as there are any; the next node follows each fork; links and parents
    -- are nodes.
    --
    -- How far the ray matters is kept beside what was found: looking into a value that may be unevaluated, at each box,
    -- would make the loop save all its registers each time.
    visit !node !trail !reach found !tried
      | not (meets a (faceOf h node) reach) = onward node trail reach found tried
      | isLeaf link =
        let !(!place, !end) = placesOf link
            !found' = range place end found
         in onward node trail (far found') found' (tried + end - place)
      | otherwise = visit (node + (if runsDown a (coordinateOf link) then wordsAhead link else nodeWords)) ((trail `shiftL` 1) .|. 1) reach found tried
      where
        !link = linkOf h node
    onward !node !trail !reach found !tried
      | trail == 0 = done found tried
      | trail .&. 1 == 0 = onward (forkOver h node) (trail `shiftR` 1) reach found tried
      | otherwise =
        let !fork = forkOver h node
            !other = if node == fork + nodeWords then fork + wordsAhead (linkOf h fork) else fork + nodeWords
         in visit other (trail - 1) reach found tried
    -- Out of line, since GHC makes sure of room for what is made at the end of a loop at each of its turns.
    done found !tried = Tried found tried
    {-# NOINLINE done #-}
{-# INLINE descend #-}

-------------------------------------------------------------------------------
-- Building

-- | The hierarchy of so many items, given the box of each, if it has one.
--
-- Cost: that of 'partition'.
--
-- Spec: limits.must-work.
hierarchy :: Int -> (Int -> Maybe Box) -> Hierarchy
hierarchy n boxOf
  | sizeofPrimArray bounded == 0 = Hierarchy unbounded (sizeofPrimArray unbounded) (toNodes mempty mempty) 0 0
  | otherwise = case partition boxes bounded of
    Part faces links order depth ->
      Hierarchy (unbounded <> order) (sizeofPrimArray unbounded) (toNodes faces (mapPrimArray (leafAfter (sizeofPrimArray unbounded)) links)) (sizeofPrimArray links) depth
  where
    bounded = filterPrimArray hasBox everything
    unbounded = filterPrimArray (not . hasBox) everything
    everything = generatePrimArray n id
    -- Where there is no box, the six numbers are zero but for the first, which is infinite. So may be the box of a shape
    -- whose size left the range on its way through nested frames. Beyond some 1e150 the areas of boxes are infinite, by
    -- which they are arranged: what reaches 1e140 counts as without a box.
    hasBox i = all (\k -> abs (indexPrimArray boxes (6 * i + k)) < vast) [0 .. 5]
    vast = 1e70 * 1e70
    boxes = runPrimArray $ do
      target <- newPrimArray (6 * n)
      let fill !i = when (i < n) $ do
            case boxOf i of
              Nothing -> writePrimArray target (6 * i) infinity >> setPrimArray target (6 * i + 1) 5 0
              Just b -> forM_ [0 .. 5] $ \k -> writePrimArray target (6 * i + k) (boxFace b k)
            fill (i + 1)
      fill 0
      pure target

-- | Nodes as they are stored, from their faces and links; the forks above them are found.
toNodes :: PrimArray Double -> PrimArray Link -> ByteArray
toNodes faces links = runByteArray $ do
  target <- newByteArray (8 * nodeWords * count)
  forM_ [0 .. count - 1] $ \node -> do
    let at = nodeWords * node
    forM_ [0 .. 5] $ \k -> writeByteArray target (at + k) (indexPrimArray faces (6 * node + k))
    writeByteArray target (at + 6) (indexPrimArray links node)
    when (node == 0) $ writeByteArray target 7 (0 :: Int)
    unless (isLeaf (indexPrimArray links node)) $ do
      writeByteArray target (at + nodeWords + 7) at
      writeByteArray target (at + wordsAhead (indexPrimArray links node) + 7) at
  pure target
  where
    count = sizeofPrimArray links

-- Note [A trail instead of a stack]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- A ray that comes to a fork visits the near part now and the far part later. The usual program recurses, or keeps the
-- far parts on a stack. In Haskell the recursion is not free: a local function that calls itself other than last
-- becomes a closure, which holds all that it uses, thirty numbers here, and is built anew for every ray. What calls
-- itself last only is a loop in registers.
--
-- So what is still to be done is kept in one word: for each fork above the node, from the nearest on, a bit that says
-- whether its other part is still to be visited. Entering a fork shifts a 1 in; when a part is done, the way leads up
-- over the zeros to the first 1, and to the other part there. The order of visits is that of the recursion, and the
-- same boxes are tested; what it costs is a link from each node to the fork above.
--
-- Source: M. Hapala, T. Davidovic, I. Wald, V. Havran, P. Slusallek, /Efficient Stack-less BVH Traversal for Ray
-- Tracing/, SCCG 2011 (the links up); S. Laine, /Restart Trail for Stackless BVH Traversal/, HPG 2010 (the bits).
