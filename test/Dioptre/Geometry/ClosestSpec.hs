-- | What a ray meets first, as it grows: examples by hand, and the laws.
module Dioptre.Geometry.ClosestSpec (spec) where

import Dioptre.Geometry.Closest
import Laws.Index
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  describe "offer" $ do
    it "takes what is nearer" $ offer 7 1 (Closest 2 3 0) `shouldBe` Closest 1 7 0
    it "leaves what is farther" $ offer 1 3 (Closest 2 3 0) `shouldBe` Closest 2 3 0
    it "takes the lower number of two at one parameter" $ map (\n -> offer n 2 (Closest 2 3 0)) [2, 4] `shouldBe` [Closest 2 2 0, Closest 2 3 0]
    it "takes nothing at the bound, nor beyond" $ map (\t -> met (offer 0 t (below 2))) [1.5, 2, 3] `shouldBe` [Just (1.5, 0), Nothing, Nothing]

  describe "as laws" $
    modifyMaxSuccess (* 5) $ do
      prop "what is taken does not depend on the order of the offers" offersHaveNoOrder
      prop "it is the nearest below the bound, and of several the one with the lowest number" theNearestOfferIsTaken
