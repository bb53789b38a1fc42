-- | Lights: which are possible.
module Dioptre.Light.LightSpec (spec) where

import Dioptre.Light.Colour (white)
import Dioptre.Light.Light
import Test.Hspec

spec :: Spec
spec = do
  describe "attenuates" $
    it "wants one attenuator at least" $
      [attenuates (Lamp white 0 1 (c, l, q)) | c <- [0, 1], l <- [0, 1], q <- [0, 1e-10]] `shouldBe` (False : replicate 7 True)

  describe "isVisible" $
    it "is true from 380 to 780 nm, ends included" $
      map (\l -> isVisible (Wave l 10 2)) [379.99999, 380, 550, 780, 780.00001] `shouldBe` [False, True, True, True, False]
