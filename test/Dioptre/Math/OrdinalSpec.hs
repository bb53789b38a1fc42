-- | Doubles and their numbers: examples, and the laws.
module Dioptre.Math.OrdinalSpec (spec) where

import Dioptre.Math.Ordinal
import Laws.Order
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  it "counts from zero, up and down" $ map toOrdinal [0, -0.0, 5e-324, -5e-324, 1] `shouldBe` [0, 0, 1, -1, 1023 * 2 ^ (52 :: Int)]
  prop "keeps the order" ordinalsKeepTheOrder
  prop "is undone" ordinalsAreUndone
  prop "undoes" ordinalsAreUndoneBack
  prop "leaves out no double" neighboursAreNext
  prop "halves without overflow" midpointIsBetween
