-- | Light that grows weaker on its way: examples, and the laws.
module Dioptre.Light.AttenuationSpec (spec) where

import Dioptre.Light.Attenuation
import Dioptre.Light.Colour (brightest, white)
import Dioptre.Light.Light (Lamp (..))
import Laws.Attenuation
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "attenuation" $
    it "has what the lamp has" $ attenuation (Lamp white 0 5 (1, 2, 3)) `shouldBe` Attenuation 5 1 2 3

  describe "attenuated" $ do
    it "is the amplification by constant + linear D + quadratic D D" $
      [attenuated (Attenuation 3 2 1.5 0.125) d | d <- [4, 8]] `shouldBe` [Just 0.3, Just (3 / 22)]
    it "does not fall off by the constant alone" $ [attenuated (Attenuation 1 1 0 0) d | d <- [1e-100, 1, 1e100]] `shouldBe` replicate 3 (Just 1)
    it "is nothing at the very place of the light, whatever the attenuators" $
      [attenuated (Attenuation 1 c l q) 0 | c <- [0, 1], l <- [0, 1], q <- [0, 1]] `shouldBe` replicate 8 Nothing
    it "is nothing where the attenuation divides by zero, as underflow lets it" $ attenuated (Attenuation 1 0 0 1e-100) 1e-120 `shouldBe` Nothing
    it "is at most as bright as anything" $ [attenuated (Attenuation 1e100 0 0 1) d | d <- [1e-50, 0.5, 1]] `shouldBe` map Just [brightest, brightest, brightest]
    prop "is that quotient, to five roundings" strengthIsTheQuotient
    prop "is nowhere more than nearer to the light" strengthFalls
