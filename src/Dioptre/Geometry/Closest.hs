{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Closest
-- Description : What a ray meets first
--
-- The answer to the question that a ray tracer asks most, as it grows while shapes are tried: the least parameter so far, and whose it is. Shapes may be tried in
-- any order: of several at one parameter it is the one with the lowest number, so that the answer depends on the shapes alone.
module Dioptre.Geometry.Closest
  ( Closest (..),
    below,
    within,
    slightlyBeyond,
    offer,
    tried,
    met,
  )
where

import Dioptre.Math.Tolerance (boundSlack)

-- | What was met first among the shapes that were tried. The plain three numbers stay in registers while shapes are tried.
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

-- | Offers a shape's number and the parameter at which it is met. It is taken if that is nearer, or if it is as near and the number is lower.
--
-- Law: what is taken in the end does not depend on the order of the offers.
offer :: Int -> Double -> Closest -> Closest
offer number t c@(Closest best found tests)
  | t < best || (t == best && number < found) = Closest t number tests
  | otherwise = c
{-# INLINE offer #-}

-- | So many more shapes were tried.
tried :: Int -> Closest -> Closest
tried n (Closest t number tests) = Closest t number (tests + n)
{-# INLINE tried #-}

-- | The parameter and the shape's number, if anything is met.
met :: Closest -> Maybe (Double, Int)
met (Closest t number _)
  | number < 0 = Nothing
  | otherwise = Just (t, number)
{-# INLINE met #-}
