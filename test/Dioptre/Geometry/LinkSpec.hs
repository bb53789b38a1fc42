-- |
-- Module      : Dioptre.Geometry.LinkSpec
-- Description : Links tell what they were made of
module Dioptre.Geometry.LinkSpec (spec) where

import Dioptre.Geometry.Link
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (Gen, chooseInt, elements, forAll, oneof, (===))

spec :: Spec
spec = do
  prop "a leaf tells its places" . forAll ((,) <$> size <*> size) $ \(place, n) ->
    (isLeaf (leafLink place n), placesOf (leafLink place n)) === (True, (place, place + n))
  prop "a fork tells its coordinate, and how many words ahead its second part is" . forAll ((,) <$> size <*> elements [0, 1, 2]) $ \(ahead, coordinate) ->
    (isLeaf (forkLink ahead coordinate), coordinateOf (forkLink ahead coordinate), wordsAhead (forkLink ahead coordinate)) === (False, coordinate, nodeWords * ahead)
  prop "a leaf moves on with its places, and a fork stays" . forAll ((,) <$> few <*> few) $ \(n, place) ->
    (leafAfter n (leafLink place 5), leafAfter n (forkLink place 1)) === (leafLink (place + n) 5, forkLink place 1)
  where
    few = oneof [chooseInt (0, 20), chooseInt (0, 2 ^ (30 :: Int) - 1)]

-- | Up to the greatest.
size :: Gen Int
size = oneof [chooseInt (0, 20), chooseInt (0, 2 ^ (31 :: Int) - 1), pure (2 ^ (31 :: Int) - 1)]
