{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Partition
-- Description : How boxes are best put into boxes
--
-- >   . . .|. . . . .|. .      bins along a coordinate; between them are the planes to choose from
-- >    a  a|    b    | cc
-- >   A1 n1 + A2 n2 is least   A: the area of the box around the items of a side, n: how many there are
--
-- Items, each in its box, are split in two where a ray's expected work is least, each part again, and so on until few are left.
--
-- Sources:
--
-- * J. Goldsmith, J. Salmon, /Automatic Creation of Object Hierarchies for Ray Tracing/, IEEE CG&A 7(5) (1987): the chance that a ray that meets a box meets another one inside
--   it is the ratio of their areas.
-- * I. Wald, /On fast Construction of SAH-based Bounding Volume Hierarchies/, RT 2007: choosing among a few planes by counting into bins.
module Dioptre.Geometry.Partition
  ( -- * Parts
    Part (..),
    partition,

    -- * Links
    nodeWords,
    isLeaf,
    leafAfter,
    placesOf,
    coordinateOf,
    wordsAhead,
  )
where

import Control.Monad (forM_, when)
import Control.Monad.ST (ST, runST)
import Data.Bits (complement, shiftL, shiftR, (.&.), (.|.))
import Data.Primitive.PrimArray
import Dioptre.Math.Order (larger, smaller)
import GHC.Conc (par, pseq)

-------------------------------------------------------------------------------
-- Links

-- The lowest bit tells leaves from forks. A leaf holds its first place above bit 32 and how many items it has below; a fork the coordinate along which its parts lie in two bits, and above
-- them, from bit 3 on, how many nodes ahead the second part is. With the three bits cleared that is how many words ahead it is, since a node has eight.

-- | How many words a node takes. (The links of forks count on it.)
nodeWords :: Int
nodeWords = 8

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

-- | Whether a link is a leaf's.
isLeaf :: Int -> Bool
isLeaf link = link .&. 1 == 1
{-# INLINE isLeaf #-}

-- | The coordinate along which the parts of a fork lie: 0, 1, 2 for x, y, z.
coordinateOf :: Int -> Int
coordinateOf link = (link `shiftR` 1) .&. 3
{-# INLINE coordinateOf #-}

-- | How many words ahead the second part of a fork is: so many nodes of 'nodeWords' each.
wordsAhead :: Int -> Int
wordsAhead link = link .&. complement 7
{-# INLINE wordsAhead #-}

-- | The same link where the items stand so many places farther on.
leafAfter :: Int -> Int -> Int
leafAfter n link = if isLeaf link then link + (n `shiftL` 32) else link
{-# INLINE leafAfter #-}

-------------------------------------------------------------------------------
-- Parts

-- | Some items put into boxes: the nodes' faces (six numbers each: low x, y, z, high x, y, z) and links, depth first; the items in their order; and how many boxes are around one item at most. Places count from its own first item.
data Part = Part !(PrimArray Double) !(PrimArray Int) !(PrimArray Int) !Int

-- | Parts of more items than this are built side by side with their neighbours.
worthwhile :: Int
worthwhile = 8192

-- | The part that has these items, at least one, given the boxes of all (six numbers each).
--
-- Cost: O(n log n), some 150 bytes an item while it works. Large parts are built in parallel. Items whose boxes have one centre stay together in a leaf, however many they are.
partition :: PrimArray Double -> PrimArray Int -> Part
partition boxes = grow boxes 0

-- | The same below so many forks.
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
    moved = leafAfter (sizeofPrimArray o1)

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
            middle <- divided (\item -> binOf item coordinate from scale <= bin)
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
    divided isLeft = go lo (hi - 1)
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

-- | Of two faces the one that is farther out; the first, if neither is.
lower, upper :: Double -> Double -> Double
lower x y = smaller y x
upper x y = larger y x
{-# INLINE lower #-}
{-# INLINE upper #-}
