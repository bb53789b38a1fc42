{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE HexFloatLiterals #-}
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
-- A bounding-volume hierarchy: items, each in its box along the axes, are split in two, and again, until few are left; each part has the box of its
-- items. A ray that misses a box misses everything in it, and so the cost of a ray grows like the logarithm of the number of items.
--
-- The hierarchy knows nothing of what the items are. It gives them an order, in which those of a leaf stand side by side, and 'descend' leads a ray
-- to them, those near its origin first.
--
-- Items that have no box, such as planes, are held apart: every ray tries them.
--
-- It is stored flat, without pointers.
--
-- Sources:
--
-- * J. Goldsmith, J. Salmon, /Automatic Creation of Object Hierarchies for Ray Tracing/, IEEE CG&A 7(5) (1987): the chance that a ray that meets a box meets another one inside
--   it is the ratio of their areas.
-- * I. Wald, /On fast Construction of SAH-based Bounding Volume Hierarchies/, RT 2007: choosing among a few planes by counting into bins.
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
import Control.Monad.ST (ST, runST)
import Data.Bits (shiftL, shiftR, (.&.), (.|.))
import Data.Primitive.ByteArray
import Data.Primitive.PrimArray
import Data.Word (Word64)
import Dioptre.Geometry.Bounds (Approach, Box, box, boxHigh, boxLow, meets, runsDown)
import GHC.Conc (par, pseq)
import Linear.V3 (V3 (..))

-- | Boxes in boxes over items that are known by their numbers, from 0 up.
data Hierarchy = Hierarchy
  { -- | The numbers of the items, by their places: those without a box first, then leaf by leaf.
    hierarchyOrder :: !(PrimArray Int),
    -- | How many items have no box.
    boxless :: {-# UNPACK #-} !Int,
    -- | Eight words a node, which is a line of a processor's cache: six numbers, low x, y, z, high x, y, z; its link, which says where its parts or its items are; and the fork that it is a part of (of the first node, itself).
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
hierarchyLeaves h = [placesOf link | node <- [0 .. hierarchyNodes h - 1], let link = linkOf h node, isLeaf link]

-- | One of the six numbers of a node.
faceOf :: Hierarchy -> Int -> Int -> Double
faceOf h node k = indexByteArray (nodes h) (8 * node + k)
{-# INLINE faceOf #-}

-- | The link of a node.
linkOf :: Hierarchy -> Int -> Int
linkOf h node = indexByteArray (nodes h) (8 * node + 6)
{-# INLINE linkOf #-}

-- | The fork that a node is a part of.
forkOver :: Hierarchy -> Int -> Int
forkOver h node = indexByteArray (nodes h) (8 * node + 7)
{-# INLINE forkOver #-}

-------------------------------------------------------------------------------
-- Links

-- The lowest bit tells leaves from forks. A leaf holds its first place above bit 32 and how many items it has below; a fork the coordinate along which its parts lie in two bits, and above
-- them how many nodes ahead the second part is.

-- | The link of a leaf: from that place on, so many items.
leafLink :: Int -> Int -> Int
leafLink place n = (place `shiftL` 32) .|. (n `shiftL` 1) .|. 1

-- | The link of a fork: the second part is so many nodes ahead, and along that coordinate its items have the greater centres.
forkLink :: Int -> Int -> Int
forkLink ahead coordinate = (ahead `shiftL` 3) .|. (coordinate `shiftL` 1)

-- | The places of a leaf.
placesOf :: Int -> (Int, Int)
placesOf link = let place = link `shiftR` 32 in (place, place + ((link `shiftR` 1) .&. 0x7fffffff))
{-# INLINE placesOf #-}

isLeaf :: Int -> Bool
isLeaf link = link .&. 1 == 1
{-# INLINE isLeaf #-}

-------------------------------------------------------------------------------
-- Following a ray

-- | What a descent found, and how many items were in the ranges that it gave (all of them count, also where the first one was enough).
data Tried found = Tried found !Int

-- | Leads a ray to the items that it may meet, near ones first where that is known; to those without a box first of all. What has been found so far says how far the ray still matters. Items are given in ranges: the first
-- place in 'hierarchyOrder', and the place behind the last.
--
-- Law: every item is in one of the ranges that has no box, or whose box the ray meets no farther than what has been found when its turn comes.
--
-- Cost: a test of a box for each part that is not passed over whole. See Note [A trail instead of a stack].
descend :: Hierarchy -> Approach -> (found -> Double) -> (Int -> Int -> found -> found) -> found -> Tried found
descend h a far range found0
  | hierarchyNodes h == 0 = Tried first (boxless h)
  | otherwise = visit 0 (0 :: Word64) (far first) first (boxless h)
  where
    !first = if boxless h > 0 then range 0 (boxless h) found0 else found0
    -- Node numbers are below the number of nodes: 0 is, as there are any; the next node follows each fork; links and parents are nodes.
    --
    -- How far the ray matters is kept beside what was found: looking into a value that may be unevaluated, at each box, would make the loop save all its registers each time.
    visit !node !trail !reach found !tried
      | not (meets a (faceOf h node) reach) = onward node trail reach found tried
      | isLeaf link =
        let !(!place, !end) = placesOf link
            !found' = range place end found
         in onward node trail (far found') found' (tried + end - place)
      | otherwise = visit (node + (if runsDown a ((link `shiftR` 1) .&. 3) then link `shiftR` 3 else 1)) ((trail `shiftL` 1) .|. 1) reach found tried
      where
        !link = linkOf h node
    onward !node !trail !reach found !tried
      | trail == 0 = done found tried
      | trail .&. 1 == 0 = onward (forkOver h node) (trail `shiftR` 1) reach found tried
      | otherwise =
        let !fork = forkOver h node
            !other = if node == fork + 1 then fork + linkOf h fork `shiftR` 3 else fork + 1
         in visit other (trail - 1) reach found tried
    -- Out of line, since GHC makes sure of room for what is made at the end of a loop at each of its turns.
    done found !tried = Tried found tried
    {-# NOINLINE done #-}
{-# INLINE descend #-}

-------------------------------------------------------------------------------
-- Building

-- | The hierarchy of so many items, given the box of each, if it has one.
--
-- Cost: O(n log n), some 150 bytes an item while it is built. Large parts are built in parallel. Items whose boxes have one centre stay together in a leaf, however many they are.
hierarchy :: Int -> (Int -> Maybe Box) -> Hierarchy
hierarchy n boxOf
  | sizeofPrimArray bounded == 0 = Hierarchy unbounded (sizeofPrimArray unbounded) (toNodes mempty mempty) 0 0
  | otherwise = case grow boxes 0 bounded of
    Part f l o depth ->
      let moved link = if isLeaf link then link + (sizeofPrimArray unbounded `shiftL` 32) else link
       in Hierarchy (unbounded <> o) (sizeofPrimArray unbounded) (toNodes f (mapPrimArray moved l)) (sizeofPrimArray l) depth
  where
    bounded = filterPrimArray hasBox everything
    unbounded = filterPrimArray (not . hasBox) everything
    everything = generatePrimArray n id
    -- Where there is no box, the six numbers are zero but for the first, which is infinite.
    hasBox i = indexPrimArray boxes (6 * i) < 1 / 0
    boxes = runPrimArray $ do
      target <- newPrimArray (6 * n)
      let fill !i = when (i < n) $ do
            case boxOf i of
              Nothing -> writePrimArray target (6 * i) (1 / 0) >> setPrimArray target (6 * i + 1) 5 0
              Just b -> case (boxLow b, boxHigh b) of
                (V3 lx ly lz, V3 hx hy hz) -> do
                  writePrimArray target (6 * i) lx
                  writePrimArray target (6 * i + 1) ly
                  writePrimArray target (6 * i + 2) lz
                  writePrimArray target (6 * i + 3) hx
                  writePrimArray target (6 * i + 4) hy
                  writePrimArray target (6 * i + 5) hz
            fill (i + 1)
      fill 0
      pure target

-- | Nodes as they are stored, from their faces and links; the forks above them are found.
toNodes :: PrimArray Double -> PrimArray Int -> ByteArray
toNodes f l = runByteArray $ do
  target <- newByteArray (64 * count)
  forM_ [0 .. count - 1] $ \node -> do
    forM_ [0 .. 5] $ \k -> writeByteArray target (8 * node + k) (indexPrimArray f (6 * node + k))
    writeByteArray target (8 * node + 6) (indexPrimArray l node)
    when (node == 0) $ writeByteArray target 7 (0 :: Int)
    unless (isLeaf (indexPrimArray l node)) $ do
      writeByteArray target (8 * (node + 1) + 7) node
      writeByteArray target (8 * (node + indexPrimArray l node `shiftR` 3) + 7) node
  pure target
  where
    count = sizeofPrimArray l

-- | A part of a hierarchy: its nodes' faces and links, its items in their order, and its depth. Places count from its own first item.
data Part = Part !(PrimArray Double) !(PrimArray Int) !(PrimArray Int) !Int

-- | Parts of more items than this are built side by side with their neighbours.
worthwhile :: Int
worthwhile = 8192

-- | The part that has these items, given the boxes of all, below so many forks.
grow :: PrimArray Double -> Int -> PrimArray Int -> Part
grow boxes !level items
  | sizeofPrimArray items <= worthwhile || level >= chosen = growAlone boxes level items
  | otherwise = case splitting boxes items of
    Nothing -> growAlone boxes level items
    Just (coordinate, left, right) ->
      let first = grow boxes (level + 1) left
          second = grow boxes (level + 1) right
       in second `par` (first `pseq` joined coordinate first second)

-- | Two parts under a common box.
joined :: Int -> Part -> Part -> Part
joined coordinate (Part f1 l1 o1 d1) (Part f2 l2 o2 d2) =
  Part (outer <> f1 <> f2) (primArrayFromList [forkLink (1 + sizeofPrimArray l1) coordinate] <> l1 <> mapPrimArray moved l2) (o1 <> o2) (1 + max d1 d2)
  where
    outer = generatePrimArray 6 (\k -> (if k < 3 then lower else upper) (indexPrimArray f1 k) (indexPrimArray f2 k))
    moved link = if isLeaf link then link + (sizeofPrimArray o1 `shiftL` 32) else link

-- | How one part of the items is best split in two: the coordinate, and the items of either side; 'Nothing' if they had better stay together.
splitting :: PrimArray Double -> PrimArray Int -> Maybe (Int, PrimArray Int, PrimArray Int)
splitting boxes items = runST $ do
  order <- thawPrimArray items 0 n
  bins <- newBins
  found <- split boxes order bins 0 n
  case found of
    Together -> pure Nothing
    Apart coordinate middle -> do
      left <- freezePrimArray order 0 middle
      right <- freezePrimArray order middle (n - middle)
      pure (Just (coordinate, left, right))
  where
    n = sizeofPrimArray items

-- | The same, built by one worker.
growAlone :: PrimArray Double -> Int -> PrimArray Int -> Part
growAlone boxes above items = runST $ do
  order <- thawPrimArray items 0 n
  bins <- newBins
  nodeFaces <- newPrimArray (6 * (2 * n - 1))
  nodeLinks <- newPrimArray (2 * n - 1)
  let face node k = readPrimArray nodeFaces (6 * node + k)
      go !node !level !lo !hi = do
        found <- if level < chosen then split boxes order bins lo hi else pure (if level < deepest then Apart 0 ((lo + hi) `div` 2) else Together)
        case found of
          Apart coordinate middle | hi - lo > 1 -> do
            Grown second d1 <- go (node + 1) (level + 1) lo middle
            Grown end d2 <- go second (level + 1) middle hi
            forM_ [0 .. 5] $ \k -> do
              a <- face (node + 1) k
              b <- face second k
              writePrimArray nodeFaces (6 * node + k) ((if k < 3 then lower else upper) a b)
            writePrimArray nodeLinks node (forkLink (second - node) coordinate)
            pure (Grown end (1 + max d1 d2))
          _ -> do
            forM_ [0 .. 5] $ \k -> do
              first <- readPrimArray order lo
              writePrimArray nodeFaces (6 * node + k) (indexPrimArray boxes (6 * first + k))
              forM_ [lo + 1 .. hi - 1] $ \place -> do
                item <- readPrimArray order place
                before <- face node k
                writePrimArray nodeFaces (6 * node + k) ((if k < 3 then lower else upper) before (indexPrimArray boxes (6 * item + k)))
            writePrimArray nodeLinks node (leafLink lo (hi - lo))
            pure (Grown (node + 1) 1)
  Grown count depth <- go 0 above 0 n
  shrinkMutablePrimArray nodeFaces (6 * count)
  shrinkMutablePrimArray nodeLinks count
  Part <$> unsafeFreezePrimArray nodeFaces <*> unsafeFreezePrimArray nodeLinks <*> unsafeFreezePrimArray order <*> pure depth
  where
    n = sizeofPrimArray items

-- | The next free node, and the depth of what was built.
data Grown = Grown !Int !Int

-- | Below so many forks, items are halved as they come. Choosing well seldom goes so deep; where it does, each choice takes few items away, and would make the building slow.
chosen :: Int
chosen = 40

-- | Below so many forks, items stay together, as a trail ends. It takes 2^22 items below the 40th fork to come so far.
deepest :: Int
deepest = 62

-- | Whether items are better in one leaf or in two parts: along which coordinate, and before which place the second one begins.
data Split = Together | Apart !Int !Int

-- | Items are counted by the places of their centres, in at most so many bins along each coordinate.
binCount :: Int
binCount = 16

-- | In how many bins so many items are counted: clearing and comparing more of them than there are items would take longer than all the rest.
binsFor :: Int -> Int
binsFor n
  | n <= 8 = 4
  | n <= 32 = 8
  | otherwise = binCount

-- | A leaf has at most so many items, if their centres differ.
largestLeaf :: Int
largestLeaf = 8

-- | What going through a fork costs, in tests of an item.
forkCost :: Double
forkCost = 1

-- | For each coordinate and bin, how many items there are and the box around them; and room for the areas of what is to the right.
data Bins s = Bins !(MutablePrimArray s Int) !(MutablePrimArray s Double) !(MutablePrimArray s Double)

newBins :: ST s (Bins s)
newBins = Bins <$> newPrimArray (3 * binCount) <*> newPrimArray (3 * binCount * 6) <*> newPrimArray binCount

-- | Splits the items at some places, moving those of the first part to the front.
--
-- The expected cost of a ray that comes into the box of n items is n for a leaf, and @forkCost@ + (A1 n1 + A2 n2) \/ A for a fork, the A being the areas of the boxes. The planes between
-- the bins are compared, of all three coordinates.
split :: PrimArray Double -> MutablePrimArray s Int -> Bins s -> Int -> Int -> ST s Split
split boxes order (Bins counts bounds areas) !lo !hi
  | hi - lo <= 1 = pure Together
  | otherwise = do
    Centres x0 y0 z0 x1 y1 z1 <- centres
    let scaleOf from to = let s = fromIntegral bins * 0x0.fffffffffffp0 / (to - from) in if to > from && s < 1 / 0 then s else 0
        !sx = scaleOf x0 x1
        !sy = scaleOf y0 y1
        !sz = scaleOf z0 z1
    if sx == 0 && sy == 0 && sz == 0
      then pure Together
      else do
        empty
        forPlaces $ \item -> do
          count item 0 (binOf item 0 x0 sx)
          count item 1 (binOf item 1 y0 sy)
          count item 2 (binOf item 2 z0 sz)
        area <- total
        b0 <- if sx == 0 then pure worst else sweep 0 worst
        b1 <- if sy == 0 then pure b0 else sweep 1 b0
        Choice cost coordinate bin <- if sz == 0 then pure b1 else sweep 2 b1
        if coordinate < 0 || (n <= largestLeaf && fromIntegral n * area <= forkCost * area + cost)
          then pure Together
          else do
            let (from, scale) = case coordinate of
                  0 -> (x0, sx)
                  1 -> (y0, sy)
                  _ -> (z0, sz)
            middle <- partition (\item -> binOf item coordinate from scale <= bin)
            pure (Apart coordinate middle)
  where
    !n = hi - lo
    !bins = binsFor n
    worst = Choice (1 / 0) (-1) 0
    -- Twice the centre, in one coordinate. Items are below the number of boxes, and bins below theirs.
    centre item k = indexPrimArray boxes (6 * item + k) + indexPrimArray boxes (6 * item + k + 3)
    binOf item k from scale = truncate ((centre item k - from) * scale) :: Int
    forPlaces act = let go !i = when (i < hi) (readPrimArray order i >>= act >> go (i + 1)) in go lo
    {-# INLINE forPlaces #-}
    centres = go lo (1 / 0) (1 / 0) (1 / 0) (-1 / 0) (-1 / 0) (-1 / 0)
      where
        go !i !x0 !y0 !z0 !x1 !y1 !z1
          | i >= hi = pure (Centres x0 y0 z0 x1 y1 z1)
          | otherwise = do
            item <- readPrimArray order i
            let !x = centre item 0
                !y = centre item 1
                !z = centre item 2
            go (i + 1) (lower x0 x) (lower y0 y) (lower z0 z) (upper x1 x) (upper y1 y) (upper z1 z)
    empty = do
      let go !b = when (b < 3 * bins) $ do
            writePrimArray counts b 0
            let side !k = when (k < 3) $ do
                  writePrimArray bounds (6 * b + k) (1 / 0)
                  writePrimArray bounds (6 * b + k + 3) (-1 / 0)
                  side (k + 1)
            side (0 :: Int)
            go (b + 1)
      go 0
    count item k bin = do
      let !b = k * bins + bin
      m <- readPrimArray counts b
      writePrimArray counts b (m + 1)
      let widen !j = when (j < 6) $ do
            before <- readPrimArray bounds (6 * b + j)
            let !face = indexPrimArray boxes (6 * item + j)
            when (if j < 3 then face < before else face > before) (writePrimArray bounds (6 * b + j) face)
            widen (j + 1)
      widen 0
    -- The box of one more bin, joined to a box.
    with (Centres x0 y0 z0 x1 y1 z1) b = do
      let at j = readPrimArray bounds (6 * b + j)
      Centres <$> (lower x0 <$> at 0) <*> (lower y0 <$> at 1) <*> (lower z0 <$> at 2) <*> (upper x1 <$> at 3) <*> (upper y1 <$> at 4) <*> (upper z1 <$> at 5)
    nothing = Centres (1 / 0) (1 / 0) (1 / 0) (-1 / 0) (-1 / 0) (-1 / 0)
    -- Half the area: of nothing, 0.
    areaOf (Centres x0 y0 z0 x1 y1 z1)
      | x1 < x0 = 0
      | otherwise = let dx = x1 - x0; dy = y1 - y0; dz = z1 - z0 in dx * dy + dy * dz + dz * dx
    total = areaOf <$> go 0 nothing
      where
        -- Every coordinate's bins hold all items, also where all are in the first.
        go !b box' = if b >= bins then pure box' else with box' b >>= go (b + 1)
    -- The cheapest plane of one coordinate, if it is cheaper than what is known.
    sweep k known = do
      let fromRight !b box'
            | b <= 0 = pure ()
            | otherwise = do
              more <- with box' (k * bins + b)
              writePrimArray areas b (areaOf more)
              fromRight (b - 1) more
          fromLeft !b !m box' best@(Choice c _ _)
            | b >= bins - 1 = pure best
            | otherwise = do
              more <- with box' (k * bins + b)
              here <- readPrimArray counts (k * bins + b)
              right <- readPrimArray areas (b + 1)
              let !left = m + here
                  !cost = areaOf more * fromIntegral left + right * fromIntegral (n - left)
              fromLeft (b + 1) left more (if left > 0 && left < n && cost < c then Choice cost k b else best)
      fromRight (bins - 1) nothing
      fromLeft 0 0 nothing known
    partition isLeft = go lo (hi - 1)
      where
        go !i !j
          | i > j = pure i
          | otherwise = do
            item <- readPrimArray order i
            if isLeft item
              then go (i + 1) j
              else do
                other <- readPrimArray order j
                writePrimArray order i other
                writePrimArray order j item
                go i (j - 1)

-- | The bounds of points, low and high.
data Centres = Centres !Double !Double !Double !Double !Double !Double

-- | A plane: its cost times the area of all, its coordinate (-1 for none), and the last bin before it.
data Choice = Choice !Double !Int !Int

lower, upper :: Double -> Double -> Double
lower x y = if y < x then y else x
upper x y = if y > x then y else x
{-# INLINE lower #-}
{-# INLINE upper #-}

-- Note [A trail instead of a stack]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
-- A ray that comes to a fork visits the near part now and the far part later. The usual program recurses, or keeps the far parts on a stack. In Haskell the recursion is not free: a local function that calls itself
-- other than last becomes a closure, which holds all that it uses, thirty numbers here, and is built anew for every ray. What calls itself last only is a loop in registers.
--
-- So what is still to be done is kept in one word: for each fork above the node, from the nearest on, a bit that says whether its other part is still to be visited. Entering a fork
-- shifts a 1 in; when a part is done, the way leads up over the zeros to the first 1, and to the other part there. The order of visits is that of the recursion, and the same boxes are tested; what it costs is a link from each node to
-- the fork above.
--
-- Source: M. Hapala, T. Davidovic, I. Wald, V. Havran, P. Slusallek, /Efficient Stack-less BVH Traversal for Ray Tracing/, SCCG 2011 (the links up); S. Laine, /Restart Trail for Stackless BVH Traversal/, HPG 2010 (the bits).
