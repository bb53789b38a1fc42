-- | Mirrors: examples, and the laws.
module Dioptre.Optics.ReflectionSpec (spec) where

import Dioptre.Math.Vector
import Dioptre.Optics.Reflection (reflected)
import Laws.Optics
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = modifyMaxSuccess (* 10) $ do
  describe "reflected" $ do
    it "sends light back that comes straight" $ reflected (V3 0 0 (-1)) alongZ `shouldBe` V3 0 0 1
    it "leaves light alone that runs along the mirror" $ reflected (V3 0.6 0.8 0) alongZ `shouldBe` V3 0.6 0.8 0
    it "turns the part along the normal" $ reflected (V3 3 (-4) 12) alongY `shouldBe` V3 3 4 12
    it "is the same from behind" $ reflected (V3 3 (-4) 12) (opposite alongY) `shouldBe` V3 3 4 12
    prop "it does not matter which side of the mirror the normal points to" mirrorHasTwoSides
    prop "the part along the normal changes its sign" mirrorTurnsTheNormalPart
    prop "the part across the normal stays" mirrorKeepsThePartAcross
    prop "the length stays" mirrorKeepsLength
    prop "the angle out is the angle in" mirrorKeepsTheAngle
    prop "reflecting twice gives the direction again" mirrorTwiceIsNothing
    prop "incident direction, normal and reflected direction lie in one plane" mirrorStaysInThePlane
    it "is tried in all its corners by these laws" $
      checkCoverage $ \i -> foldr (\(name, holds) -> cover 0.5 holds name) (property True) (incidenceCorners i)
