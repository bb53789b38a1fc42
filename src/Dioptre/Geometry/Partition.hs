{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Geometry.Partition
-- Description : How boxes are best put into boxes
--
-- Items, each in its box, are split in two where a ray's expected work is least, each part again, and so on until few
-- are left. Of the rays that come into a box, the share that also comes into one inside it is the ratio of their areas.
-- So, counted in tests of an item, a ray in the box of n items, of area A, costs
--
-- > as a leaf:   n
-- > as a fork:   c + (A1 n1 + A2 n2) / A       c: what going through the fork costs; n1 and n2 items in the parts, of areas A1 and A2
--
-- The planes to choose from are those between equal bins along each coordinate. An item is counted in the bin of its
-- centre, once for each coordinate; then the bins are swept from both sides, and each plane's A1 n1 + A2 n2 is known.
-- Four unit cubes, at x = 0, 1, 7 and 8 (A is half of the area throughout, which changes nothing):
--
-- >   | 0 : 1 |       |       | 7 : 8 |      four bins of 2 between the first centre and the last
-- >           1       2       3
-- >
-- >   plane            A1    n1   A2    n2   A1 n1 + A2 n2
-- >     1               5     2    5     2       20          taken: the first of equals
-- >     2, 3            the same                 20
-- >
-- >   a leaf:  A n = 19 4 = 76         a fork:  c A + 20 = 19 + 20 = 39, which is less
--
-- Each of the two parts, of two cubes side by side, then stays a leaf: 5 2 = 10 against 5 + 3 1 + 3 1 = 11.
--
-- Sources:
--
-- * J. Goldsmith, J. Salmon, /Automatic Creation of Object Hierarchies for Ray Tracing/, IEEE CG&A 7(5) (1987): the
--   ratio of the areas.
-- * I. Wald, /On fast Construction of SAH-based Bounding Volume Hierarchies/, RT 2007: choosing among a few planes by
--   counting into bins.
module Dioptre.Geometry.Partition
  ( partition,
    Part (..),
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST, runST)
import Data.Primitive.PrimArray
import Dioptre.Geometry.Link
import Dioptre.Math.Order (infinity, larger, smaller)
import GHC.Conc (par, pseq)

-- | Some items put into boxes. Places count from the part's own first item.
data Part = Part
  { -- | Six numbers a node, depth first: low x, y, z, high x, y, z.
    partFaces :: !(PrimArray Double),
    -- | A link a node.
    partLinks :: !(PrimArray Link),
    -- | The items, leaf by leaf.
    partOrder :: !(PrimArray Int),
    -- | How many boxes are around one item at most.
    partDepth :: !Int
  }

-------------------------------------------------------------------------------
-- Limits

-- | What going through a fork costs, in tests of an item: c.
forkCost :: Double
forkCost = 1

-- | A leaf has at most so many items, if their centres differ.
largestLeaf :: Int
largestLeaf = 8

-- | Items are counted in at most so many bins along each coordinate.
mostBins :: Int
mostBins = 16

-- | In how many bins so many items are counted: clearing and comparing more of them than there are items would take
-- longer than all the rest.
binsFor :: Int -> Int
binsFor n
  | n <= 8 = 4
  | n <= 32 = 8
  | otherwise = mostBins

-- | Parts of more items than this are built side by side with their neighbours.
parallelAbove :: Int
parallelAbove = 8192

-- | Below so many forks, items are halved as they come. Choosing well seldom goes so deep; where it does, each choice
-- takes few items away, and would make the building slow.
deepestChoice :: Int
deepestChoice = 40

-- | Below so many forks, items stay together, as a ray's trail ends ("Dioptre.Geometry.Hierarchy"). It takes 2^22 items
-- below the 40th fork to come so far.
deepestFork :: Int
deepestFork = 62

-------------------------------------------------------------------------------
-- Splitting again and again

-- | The part that has these items, at least one, given the boxes of all (six numbers each).
--
-- Cost: O(n log n), some 150 bytes an item while it works. Large parts are built in parallel. Items whose boxes have
-- one centre stay together in a leaf, however many they are.
partition :: PrimArray Double -> PrimArray Int -> Part
partition boxes = together boxes 0

-- | The part below so many forks, built by as many workers as it is worth.
together :: PrimArray Double -> Int -> PrimArray Int -> Part
together boxes !level items
  | n <= parallelAbove || level >= deepestChoice = alone boxes level items
  | otherwise = case halves of
    Nothing -> alone boxes level items
    Just (coordinate, left, right) ->
      let first = together boxes (level + 1) left
          second = together boxes (level + 1) right
       in second `par` (first `pseq` fork coordinate first second)
  where
    n = sizeofPrimArray items
    halves = runST $ do
      order <- thawPrimArray items 0 n
      bins <- newBins
      choice <- bestSplit boxes order bins 0 n
      case choice of
        Together -> pure Nothing
        Apart coordinate middle -> do
          left <- freezePrimArray order 0 middle
          right <- freezePrimArray order middle (n - middle)
          pure (Just (coordinate, left, right))

-- | Two parts under a common box.
fork :: Int -> Part -> Part -> Part
fork coordinate (Part f1 l1 o1 d1) (Part f2 l2 o2 d2) =
  Part
    { partFaces = primArrayFromList (facesOf (extentOf f1 0 `both` extentOf f2 0)) <> f1 <> f2,
      partLinks = primArrayFromList [forkLink (1 + sizeofPrimArray l1) coordinate] <> l1 <> mapPrimArray (leafAfter (sizeofPrimArray o1)) l2,
      partOrder = o1 <> o2,
      partDepth = 1 + max d1 d2
    }

-- | The part below so many forks, built by one worker: in place, node after node.
alone :: PrimArray Double -> Int -> PrimArray Int -> Part
alone boxes above items = runST $ do
  order <- thawPrimArray items 0 n
  bins <- newBins
  faces <- newPrimArray (6 * (2 * n - 1))
  links <- newPrimArray (2 * n - 1)
  -- The items at some places, from a node on, below so many forks.
  let build !node !level !lo !hi = do
        choice <- choose level lo hi
        case choice of
          Apart coordinate middle | hi - lo > 1 -> do
            Built second d1 <- build (node + 1) (level + 1) lo middle
            Built next d2 <- build second (level + 1) middle hi
            first <- readExtent faces (node + 1)
            other <- readExtent faces second
            writeExtent faces node (first `both` other)
            writePrimArray links node (forkLink (second - node) coordinate)
            pure (Built next (1 + max d1 d2))
          _ -> do
            first <- readPrimArray order lo
            around <- overPlaces order (lo + 1) hi (extentOf boxes first) (\e item -> pure (e `both` extentOf boxes item))
            writeExtent faces node around
            writePrimArray links node (leafLink lo (hi - lo))
            pure (Built (node + 1) 1)
      choose !level !lo !hi
        | level < deepestChoice = bestSplit boxes order bins lo hi
        | level < deepestFork = pure (Apart 0 ((lo + hi) `div` 2))
        | otherwise = pure Together
  Built nodes depth <- build 0 above 0 n
  shrinkMutablePrimArray faces (6 * nodes)
  shrinkMutablePrimArray links nodes
  Part <$> unsafeFreezePrimArray faces <*> unsafeFreezePrimArray links <*> unsafeFreezePrimArray order <*> pure depth
  where
    n = sizeofPrimArray items

-- | The next free node, and the depth of what was built.
data Built = Built !Int !Int

-------------------------------------------------------------------------------
-- The best split

-- | Whether items are better in one leaf or in two parts: along which coordinate, and before which place the second one
-- begins.
data Split = Together | Apart !Int !Int

-- | Splits the items at some places as is expected to be cheapest, moving those of the first part to the front.
bestSplit :: PrimArray Double -> MutablePrimArray s Int -> Bins s -> Int -> Int -> ST s Split
bestSplit boxes order bins !lo !hi
  | n <= 1 = pure Together
  | otherwise = do
    -- See how far the centres reach, and lay the bins out along that.
    Extent x0 y0 z0 x1 y1 z1 <- overPlaces order lo hi nothing (\e item -> pure (e `both` centreOf boxes item))
    let !alongX = ruler used x0 x1
        !alongY = ruler used y0 y1
        !alongZ = ruler used z0 z1
    if isFlat alongX && isFlat alongY && isFlat alongZ
      then pure Together
      else do
        -- Count the items into the bins of each coordinate.
        clear bins (3 * used)
        overPlaces order lo hi () $ \() item -> do
          let !(Extent x y z _ _ _) = centreOf boxes item
              !around = extentOf boxes item
          count bins (slot used 0 (binAt alongX x)) around
          count bins (slot used 1 (binAt alongY y)) around
          count bins (slot used 2 (binAt alongZ z)) around
        -- Sweep the planes between the bins. (Any coordinate's bins hold all items, also where all are in the first.)
        area <- halfArea <$> overBins bins used
        planeX <- sweep bins used n 0 alongX (Plane infinity (-1) 0)
        planeXY <- sweep bins used n 1 alongY planeX
        Plane cost coordinate bin <- sweep bins used n 2 alongZ planeXY
        -- Compare the best of them with a leaf.
        if coordinate < 0 || (n <= largestLeaf && fromIntegral n * area <= forkCost * area + cost)
          then pure Together
          else do
            let isFirst item = case (coordinate, centreOf boxes item) of
                  (0, Extent x _ _ _ _ _) -> binAt alongX x <= bin
                  (1, Extent _ y _ _ _ _) -> binAt alongY y <= bin
                  (_, Extent _ _ z _ _ _) -> binAt alongZ z <= bin
            Apart coordinate <$> moveToFront order lo hi isFirst
  where
    !n = hi - lo
    !used = binsFor n

-- | A plane: its A1 n1 + A2 n2, its coordinate (-1 for none), and the last bin before it.
data Plane = Plane !Double !Int !Int

-- | The cheapest plane of one coordinate, for so many items in so many bins, if it is cheaper than the one known.
sweep :: Bins s -> Int -> Int -> Int -> Ruler -> Plane -> ST s Plane
sweep bins !used !n !coordinate along known
  | isFlat along = pure known
  | otherwise = fromRight (used - 1) nothing >> fromLeft 0 0 nothing known
  where
    -- Keep each plane's A2.
    fromRight !b !right
      | b <= 0 = pure ()
      | otherwise = do
        right' <- (right `both`) <$> readExtent (binBoxes bins) (slot used coordinate b)
        writePrimArray (areasBehind bins) b (halfArea right')
        fromRight (b - 1) right'
    fromLeft !b !n1 !left best@(Plane least _ _)
      | b >= used - 1 = pure best
      | otherwise = do
        left' <- (left `both`) <$> readExtent (binBoxes bins) (slot used coordinate b)
        here <- readPrimArray (binCounts bins) (slot used coordinate b)
        a2 <- readPrimArray (areasBehind bins) (b + 1)
        let !n1' = n1 + here
            !cost = halfArea left' * fromIntegral n1' + a2 * fromIntegral (n - n1')
        fromLeft (b + 1) n1' left' (if n1' > 0 && n1' < n && cost < least then Plane cost coordinate b else best)

-------------------------------------------------------------------------------
-- Bins

-- | How the bins of a coordinate lie: where the first begins, and how many there are in a unit of length, 0 where all
-- centres are (nearly) one.
data Ruler = Ruler !Double !Double

-- | So many bins from the least number to the greatest, which is in the last one.
ruler :: Int -> Double -> Double -> Ruler
ruler used from to
  | to > from && scale < infinity = Ruler from scale
  | otherwise = Ruler from 0
  where
    !scale = fromIntegral used * 0x0.fffffffffffp0 / (to - from)
{-# INLINE ruler #-}

isFlat :: Ruler -> Bool
isFlat (Ruler _ scale) = scale == 0
{-# INLINE isFlat #-}

-- | The bin of a number.
binAt :: Ruler -> Double -> Int
binAt (Ruler from scale) x = truncate ((x - from) * scale)
{-# INLINE binAt #-}

-- | What is counted. The bins of the coordinates stand one behind the other: see @slot@.
data Bins s = Bins
  { -- | How many items there are in each bin.
    binCounts :: !(MutablePrimArray s Int),
    -- | The box around them, six numbers.
    binBoxes :: !(MutablePrimArray s Double),
    -- | Room for a sweep: half the area of the box around each bin and all that follow.
    areasBehind :: !(MutablePrimArray s Double)
  }

newBins :: ST s (Bins s)
newBins = Bins <$> newPrimArray (3 * mostBins) <*> newPrimArray (3 * mostBins * 6) <*> newPrimArray mostBins

-- | The place of a bin, where so many are used: its coordinate's, and its number there.
slot :: Int -> Int -> Int -> Int
slot used coordinate b = coordinate * used + b
{-# INLINE slot #-}

-- | Empties so many bins.
clear :: Bins s -> Int -> ST s ()
clear bins !slots = go 0
  where
    go !b = when (b < slots) $ do
      writePrimArray (binCounts bins) b 0
      writeExtent (binBoxes bins) b nothing
      go (b + 1)

-- | One more item, in that box.
count :: Bins s -> Int -> Extent -> ST s ()
count bins !b !around = do
  m <- readPrimArray (binCounts bins) b
  writePrimArray (binCounts bins) b (m + 1)
  before <- readExtent (binBoxes bins) b
  writeExtent (binBoxes bins) b (before `both` around)

-- | The box around all items in the first bins.
overBins :: Bins s -> Int -> ST s Extent
overBins bins !used = go 0 nothing
  where
    go !b !e
      | b >= used = pure e
      | otherwise = readExtent (binBoxes bins) b >>= go (b + 1) . both e

-------------------------------------------------------------------------------
-- Places

-- | Goes through the items at some places, in their order.
overPlaces :: MutablePrimArray s Int -> Int -> Int -> a -> (a -> Int -> ST s a) -> ST s a
overPlaces order lo hi start act = go lo start
  where
    go !i !a
      | i >= hi = pure a
      | otherwise = readPrimArray order i >>= act a >>= go (i + 1)
{-# INLINE overPlaces #-}

-- | Moves some of the items at some places before the others; the place of the first other.
moveToFront :: MutablePrimArray s Int -> Int -> Int -> (Int -> Bool) -> ST s Int
moveToFront order lo hi isFirst = go lo (hi - 1)
  where
    go !i !j
      | i > j = pure i
      | otherwise = do
        item <- readPrimArray order i
        if isFirst item
          then go (i + 1) j
          else do
            other <- readPrimArray order j
            writePrimArray order i other
            writePrimArray order j item
            go i (j - 1)
{-# INLINE moveToFront #-}

-------------------------------------------------------------------------------
-- Extents

-- | Low x, y, z, high x, y, z. Unlike a box it may be that of nothing, whose low numbers are above its high ones.
data Extent = Extent !Double !Double !Double !Double !Double !Double

nothing :: Extent
nothing = Extent infinity infinity infinity (negate infinity) (negate infinity) (negate infinity)
{-# INLINE nothing #-}

-- | The least that holds two.
both :: Extent -> Extent -> Extent
both (Extent x0 y0 z0 x1 y1 z1) (Extent x0' y0' z0' x1' y1' z1') =
  Extent (lower x0 x0') (lower y0 y0') (lower z0 z0') (upper x1 x1') (upper y1 y1') (upper z1 z1')
{-# INLINE both #-}

-- | Half the area of the six faces; of nothing, 0.
halfArea :: Extent -> Double
halfArea (Extent x0 y0 z0 x1 y1 z1)
  | x1 < x0 = 0
  | otherwise = let dx = x1 - x0; dy = y1 - y0; dz = z1 - z0 in dx * dy + dy * dz + dz * dx
{-# INLINE halfArea #-}

-- | The box of an item, or of a node, among six numbers each. (Items and nodes are below the number of boxes.)
extentOf :: PrimArray Double -> Int -> Extent
extentOf boxes i = Extent (at 0) (at 1) (at 2) (at 3) (at 4) (at 5)
  where
    at k = indexPrimArray boxes (6 * i + k)
{-# INLINE extentOf #-}

-- | Twice the centre of an item's box, a point.
centreOf :: PrimArray Double -> Int -> Extent
centreOf boxes item = Extent x y z x y z
  where
    !(Extent x0 y0 z0 x1 y1 z1) = extentOf boxes item
    !x = x0 + x1
    !y = y0 + y1
    !z = z0 + z1
{-# INLINE centreOf #-}

facesOf :: Extent -> [Double]
facesOf (Extent x0 y0 z0 x1 y1 z1) = [x0, y0, z0, x1, y1, z1]

readExtent :: MutablePrimArray s Double -> Int -> ST s Extent
readExtent faces i = Extent <$> at 0 <*> at 1 <*> at 2 <*> at 3 <*> at 4 <*> at 5
  where
    at k = readPrimArray faces (6 * i + k)
{-# INLINE readExtent #-}

writeExtent :: MutablePrimArray s Double -> Int -> Extent -> ST s ()
writeExtent faces i (Extent x0 y0 z0 x1 y1 z1) = put 0 x0 >> put 1 y0 >> put 2 z0 >> put 3 x1 >> put 4 y1 >> put 5 z1
  where
    put k = writePrimArray faces (6 * i + k)
{-# INLINE writeExtent #-}

-- | Of two faces the one that is farther out; the first, if neither is.
lower, upper :: Double -> Double -> Double
lower x y = smaller y x
upper x y = larger y x
{-# INLINE lower #-}
{-# INLINE upper #-}
