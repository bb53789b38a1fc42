{-# LANGUAGE OverloadedStrings #-}

-- | Materials: what follows from their coefficients.
module Dioptre.Light.MaterialSpec (spec) where

import Dioptre.Light.Colour
import Dioptre.Light.Material
import Test.Hspec

spec :: Spec
spec = do
  -- With coefficients and channels that are multiples of powers of two, everything is exact
  describe "the colours of a surface" $ do
    it "are ka and kd times the colour" $ do
      ambientColour gold `shouldBe` Colour 0.25 0.125 0.0625 0.75
      diffuseColour gold `shouldBe` Colour 0.5 0.25 0.125 0.75
    it "are ks times the colour where there is no plasticity" $ channels (specularColour gold) `shouldBe` [0.25, 0.125, 0.0625]
    it "are ks times white where plasticity is all" $ channels (specularColour gold {materialPlasticity = 1}) `shouldBe` [0.25, 0.25, 0.25]
    -- 1/4 (3/4 + 1/4 colour)
    it "are a mixture between" $ channels (specularColour gold {materialPlasticity = 0.75}) `shouldBe` [0.25, 0.21875, 0.203125]
    it "are as opaque as the colour, and white's share of a highlight comes first" $
      map (\p -> alpha (specularColour gold {materialPlasticity = p})) [0, 0.5, 1] `shouldBe` [1, 1, 1]

  describe "standard" $
    it "is white, with the scene language's defaults" $
      standard `shouldBe` Material "none" (rgb 1 1 1) 0.2 0.8 0.5 0 0 20 0 1 Nothing

  describe "substitute" $
    it "is a grey that neither reflects nor lets light through" $
      substitute "lost" `shouldBe` Material "lost" (rgb 1 1 1) 0.2 0.6 0.7 0 0 20 0 1 Nothing
  where
    gold = standard {materialColour = Colour 1 0.5 0.25 0.75, materialKa = 0.25, materialKd = 0.5, materialKs = 0.25, materialPlasticity = 0}
    channels (Colour r g b _) = [r, g, b]
