-- |
-- Module      : Laws.Attenuation
-- Description : What is true of light that grows weaker on its way
--
-- The second opinion is the quotient in rational numbers, which are exact.
module Laws.Attenuation
  ( strengthIsTheQuotient,
    strengthFalls,
    Lamplight (..),
  )
where

import Dioptre.Light.Attenuation
import Test.QuickCheck

-- | What a lamp has, and two distances from it. At least one attenuator is not zero.
data Lamplight = Lamplight Attenuation Double Double
  deriving (Show)

instance Arbitrary Lamplight where
  arbitrary = Lamplight <$> some' <*> distance <*> distance
    where
      some' = (Attenuation <$> factor <*> factor <*> factor <*> factor) `suchThat` \a -> any ((/= 0) . ($ a)) [constant, linear, quadratic]
      factor = frequency [(1, pure 0), (1, pure 1), (4, magnitude)]
      distance = magnitude
      -- From 2^-60 to 2^60: no product comes near the ends of the range.
      magnitude = encodeFloat <$> choose (2 ^ (52 :: Int), 2 ^ (53 :: Int) - 1) <*> choose (-112, 8)

-- | The strength is the quotient as it stands, to five roundings: two products and two sums for the term with the most
-- of them, and the division. Nothing is subtracted, so that relative errors only add up: (1 + u)^5 - 1 is less than
-- 5.01 u, with u = 2^-53.
strengthIsTheQuotient :: Lamplight -> Property
strengthIsTheQuotient (Lamplight a d _) = case attenuated a d of
  Nothing -> counterexample "no strength" (property False)
  Just s -> counterexample (show s) (abs (toRational s - exact) <= exact * 501 / 100 / 2 ^ (53 :: Int))
  where
    exact = r amplification / (r constant + r linear * toRational d + r quadratic * toRational d * toRational d)
    r part = toRational (part a)

-- | Nowhere is light stronger than nearer to its source.
strengthFalls :: Lamplight -> Property
strengthFalls (Lamplight a d d') = counterexample (show (attenuated a near, attenuated a far)) (attenuated a far <= attenuated a near)
  where
    near = min d d'
    far = max d d'
