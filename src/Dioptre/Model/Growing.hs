-- |
-- Module      : Dioptre.Model.Growing
-- Description : Vectors that grow at their end
--
-- How many vertices a model has is known only when its file has been read. A growing vector takes numbers at its end;
-- when its room is used up, it moves to twice the room, so that n numbers are moved fewer than n times in all, and
-- never have room for more than 2n (or some first few).
--
-- > |1 2 3 4|        then 5:        |1 2 3 4 5 . . .|
module Dioptre.Model.Growing
  ( Growing,
    newGrowing,
    size,
    at,
    push,
    push2,
    push3,
    pad,
    clear,
    settled,
    settledAs,

    -- * Counting
    Counter,
    newCounter,
    current,
    put,
    increase,
  )
where

import Control.Monad (when)
import Control.Monad.ST (ST)
import Data.STRef (STRef, newSTRef, readSTRef, writeSTRef)
import Data.Vector.Unboxed (Unbox, Vector)
import qualified Data.Vector.Unboxed as Vector
import Data.Vector.Unboxed.Mutable (MVector)
import qualified Data.Vector.Unboxed.Mutable as MVector

-- | How many numbers there are, and the room that they are in. The first is never more than the room is long.
data Growing s a = Growing !(Counter s) !(STRef s (MVector s a))

-- | One without numbers.
newGrowing :: Unbox a => ST s (Growing s a)
newGrowing = Growing <$> newCounter 0 <*> (MVector.new 0 >>= newSTRef)

-- | How many numbers there are.
size :: Growing s a -> ST s Int
size (Growing count _) = current count
{-# INLINE size #-}

-- | The number at a place, from 0. It is not looked whether the place is below the size: the caller has done so.
at :: Unbox a => Growing s a -> Int -> ST s a
at (Growing _ room) i = readSTRef room >>= \v -> MVector.unsafeRead v i
{-# INLINE at #-}

-- | Room for so many more numbers, and where the first of them goes.
claim :: Unbox a => Growing s a -> Int -> ST s (MVector s a, Int)
claim g@(Growing count room) k = do
  n <- current count
  v <- readSTRef room
  put count (n + k)
  if n + k <= MVector.length v then pure (v, n) else widened g >>= \wider -> pure (wider, n)
{-# INLINE claim #-}

-- | Twice the room. It is rare, and out of the way of the rest.
widened :: Unbox a => Growing s a -> ST s (MVector s a)
widened (Growing _ room) = do
  v <- readSTRef room
  wider <- MVector.grow v (max 1024 (MVector.length v))
  writeSTRef room wider
  pure wider
{-# NOINLINE widened #-}

-- | Adds a number. (Each claim is for at most 3 numbers, and a growth makes room for 1024: the place is in the room.)
push :: Unbox a => Growing s a -> a -> ST s ()
push g x = do
  (v, n) <- claim g 1
  MVector.unsafeWrite v n x
{-# INLINE push #-}

-- | Adds two numbers.
push2 :: Unbox a => Growing s a -> a -> a -> ST s ()
push2 g x y = do
  (v, n) <- claim g 2
  MVector.unsafeWrite v n x
  MVector.unsafeWrite v (n + 1) y
{-# INLINE push2 #-}

-- | Adds three numbers.
push3 :: Unbox a => Growing s a -> a -> a -> a -> ST s ()
push3 g x y z = do
  (v, n) <- claim g 3
  MVector.unsafeWrite v n x
  MVector.unsafeWrite v (n + 1) y
  MVector.unsafeWrite v (n + 2) z
{-# INLINE push3 #-}

-- | Adds a number as often as it takes to have that many numbers.
pad :: Unbox a => Growing s a -> Int -> a -> ST s ()
pad g n x = do
  m <- size g
  when (m < n) $ push g x >> pad g n x
{-# INLINEABLE pad #-}

-- | Takes all numbers away; the room stays.
clear :: Growing s a -> ST s ()
clear (Growing count _) = put count 0

-- | The numbers, in no more room than they need. The growing vector is empty thereafter, and its room free to be used
-- for something else.
settled :: Unbox a => Growing s a -> ST s (Vector a)
settled = settledAs id
{-# INLINE settled #-}

-- | The same, with each number changed on the way.
settledAs :: (Unbox a, Unbox b) => (a -> b) -> Growing s a -> ST s (Vector b)
settledAs f (Growing count room) = do
  n <- current count
  v <- readSTRef room
  put count 0
  MVector.new 0 >>= writeSTRef room
  -- Nobody has the room any more, so nobody writes to it.
  frozen <- Vector.unsafeFreeze v
  pure $! Vector.map f (Vector.take n frozen)
{-# INLINE settledAs #-}

-- | An integer that changes.
newtype Counter s = Counter (MVector s Int)

-- | One with this value.
newCounter :: Int -> ST s (Counter s)
newCounter n = Counter <$> MVector.replicate 1 n

-- | Its value.
current :: Counter s -> ST s Int
current (Counter c) = MVector.unsafeRead c 0
{-# INLINE current #-}

-- | Gives it a value.
put :: Counter s -> Int -> ST s ()
put (Counter c) = MVector.unsafeWrite c 0
{-# INLINE put #-}

-- | Adds to its value.
increase :: Counter s -> Int -> ST s ()
increase c k = current c >>= \n -> put c $! n + k
{-# INLINE increase #-}
