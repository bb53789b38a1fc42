-- | What rounding took: examples, and the laws.
module Dioptre.Math.ErrorFreeSpec (spec) where

import Dioptre.Math.ErrorFree
import Laws.ErrorFree
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "productError" $ do
    -- (1 + h)^2 = 1 + 2 h + h^2, of which h^2 is lost
    it "is what a square lost" $ [let x = 1 + d in productError x (halves x) (x * x) | d <- [2 ** (-30), 2 ** (-40)]] `shouldBe` [2 ** (-60), 2 ** (-80)]
    prop "makes the product whole" productsAreWhole
    prop "is zero where the digits suffice" shortSquaresAreExact
  describe "sumError" $ do
    it "is what a sum lost, whichever is the larger" $ [sumError 1 h (1 + h), sumError h 1 (h + 1)] `shouldBe` [h, h]
    prop "makes the sum whole" sumsAreWhole
  it "is tried with numbers of all kinds by these laws" $
    checkCoverage $ \p -> foldr (\(name, holds) -> cover 1 holds name) (property True) (pairCorners p)
  where
    h = 2 ** (-60)
