-- | The larger and the smaller of two: what NaN and equal numbers do, and the laws.
module Dioptre.Math.OrderSpec (spec) where

import Dioptre.Math.Order
import Laws.Order
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "larger and smaller" $ do
    it "are the second where either is NaN" $
      map show [larger nan 2, larger 2 nan, smaller nan 2, smaller 2 nan] `shouldBe` ["2.0", "NaN", "2.0", "NaN"]
    it "are the second where both are equal" $
      map show [larger 0 (-0.0), larger (-0.0) 0, smaller 0 (-0.0), smaller (-0.0) 0] `shouldBe` ["-0.0", "0.0", "-0.0", "0.0"]
    prop "the larger one is one of the two, and neither is larger" largerIsTheLarger
    prop "the smaller one is one of the two, and neither is smaller" smallerIsTheSmaller
    prop "the second stays where the first is not larger, or not smaller" theSecondStays
    prop "they are each other, turned round" isMirrored
    it "are tried with numbers of all kinds by these laws" $
      checkCoverage $ \x y -> foldr (\(name, holds) -> cover 0.5 holds name) (property True) (specialCorners x y)
  describe "finite" $ prop "is all that is neither infinite nor NaN" isFiniteOrNot
  where
    nan = 0 / 0
