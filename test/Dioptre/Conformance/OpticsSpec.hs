-- | The operations on directions: what they do before the rules of optics are asked.
module Dioptre.Conformance.OpticsSpec (spec) where

import Dioptre.Conformance.Optics (against)
import Dioptre.Math.Vector (alongX, alongZ, opposite)
import Laws.Optics (normalIsTurned)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = describe "against" $ do
  it "turns a normal against a direction" $ map (against alongZ) [alongZ, opposite alongZ] `shouldBe` replicate 2 (opposite alongZ)
  it "leaves it alone where the direction runs along the surface" $ map (against alongX) [alongZ, opposite alongZ] `shouldBe` [alongZ, opposite alongZ]
  prop "is the same whichever side the normal points to" normalIsTurned
