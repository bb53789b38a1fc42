{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Closest
-- Description : What a ray meets first
--
-- The answer to the question that a ray tracer asks most, as it grows while shapes are tried: the least parameter so
-- far, and whose it is. Shapes may be tried in any order: of several at one parameter it is the one with the lowest
-- number, so that the answer depends on the shapes alone.
module Dioptre.Geometry.Closest
  ( Closest (..),
    below,
    within,
    slightlyBeyond,
    precedes,
    tried,
  )
where

import Dioptre.Math.Tolerance (boundSlack)

-- | What was met first among the shapes that were tried. The plain three numbers stay in registers while shapes are
-- tried.
data Closest = Closest
  { -- | The parameter; the bound that was set where nothing is met below it.
    closestParameter :: {-# UNPACK #-} !Double,
    -- | The number of the shape; -1 for none.
    closestNumber :: {-# UNPACK #-} !Int,
    -- | How many shapes were tried.
    closestTests :: {-# UNPACK #-} !Int
  }
  deriving stock (Eq, Show)

-- | Nothing tried, and only what is nearer than this counts.
below :: Double -> Closest
below bound = Closest bound (-1) 0
{-# INLINE below #-}

-- | A bound a little above the closest parameter, so that what is met at that very parameter is below it.
--
-- >>> within (below 1) > 1
-- True
within :: Closest -> Double
within c = slightlyBeyond (closestParameter c)
{-# INLINE within #-}

-- | A parameter a little above, by 'boundSlack': two to four doubles on.
slightlyBeyond :: Double -> Double
slightlyBeyond t = t * (1 + boundSlack)
{-# INLINE slightlyBeyond #-}

-- | Whether a shape that is met at a parameter comes before another, given by its parameter and number too: it is
-- nearer, or as near and of a lower number.
--
-- Law: what comes before all others does not depend on the order in which they are tried.
--
-- >>> (precedes 1 7 2 3, precedes 2 7 2 3, precedes 2 1 2 3)
-- (True,False,True)
--
-- Spec: geometry.hit.closest, geometry.hit.tie.
precedes :: Double -> Int -> Double -> Int -> Bool
precedes t number best found = t <= best && (t < best || number < found)
{-# INLINE precedes #-}

-- | So many more shapes were tried.
tried :: Int -> Closest -> Closest
tried n (Closest t number tests) = Closest t number (tests + n)
{-# INLINE tried #-}
