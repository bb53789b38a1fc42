-- |
-- Module      : Dioptre.Geometry.TorusSpec
-- Description : The torus: rays whose parameters are known, and the laws
module Dioptre.Geometry.TorusSpec (spec) where

import Dioptre.Geometry.Ray (ray)
import Dioptre.Geometry.Torus (torusContains, torusNormal, torusParameters)
import Dioptre.Math.Vector (alongX, alongZ, opposite)
import Laws.Torus
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "torusParameters, with radii 2 and 1" $ do
    it "crosses the tube twice along a diameter" $ ring (V3 (-10) 0 0) (V3 1 0 0) `shouldBe` [7, 9, 11, 13]
    it "counts in units of the direction" $ ring (V3 (-10) 0 0) (V3 4 0 0) `shouldBe` [1.75, 2.25, 2.75, 3.25]
    it "crosses the tube once beside the axis" $ ring (V3 2 0 9) (V3 0 0 (-1)) `shouldBe` [8, 10]
    it "passes through the hole" $ ring (V3 0 0 9) (V3 0 0 (-1)) `shouldBe` []
    it "passes by" $ ring (V3 (-10) 3.5 0) (V3 1 0 0) `shouldBe` []
    it "touches the outermost circle" $ ring (V3 (-5) 3 0) (V3 1 0 0) `shouldBe` [5, 5]
    it "touches the innermost circle on its way" $
      ring (V3 (-5) 1 0) (V3 1 0 0) `shouldAllBeNear` [5 - sqrt 8, 5, 5, 5 + sqrt 8]
    it "touches twice on top of it" $ ring (V3 (-5) 0 1) (V3 1 0 0) `shouldBe` [3, 3, 7, 7]
    it "touches four times at once beside the circle on top" $ ring (V3 (-5) 2 1) (V3 1 0 0) `shouldBe` [5, 5, 5, 5]
    it "gives parameters behind the origin" $ ring 0 (V3 1 0 0) `shouldBe` [-3, -1, 1, 3]
    it "has no root where the direction is zero" $ ring (V3 (-5) 0 0) 0 `shouldBe` []
    it "sees it from a million away as from nearby" $ ring (V3 (-1048576) 0 0) (V3 1 0 0) `shouldBe` [1048573, 1048575, 1048577, 1048579]

  describe "torusParameters of a spindle, with radii 1 and 2" $ do
    it "has every root along a diameter" $ spindle (V3 (-10) 0 0) (V3 1 0 0) `shouldBe` [7, 9, 11, 13]
    it "meets its axis in the two points of the lemon, twice each" $ spindle (V3 0 0 (-10)) (V3 0 0 1) `shouldAllBeNear` [10 - sqrt 3, 10 - sqrt 3, 10 + sqrt 3, 10 + sqrt 3]

  describe "torusNormal" $ do
    it "points outwards on the outermost circle" $ torusNormal 0 alongZ 2 1 (V3 3 0 0) `shouldBe` alongX
    it "points to the axis on the innermost circle" $ torusNormal 0 alongZ 2 1 (V3 1 0 0) `shouldBe` opposite alongX
    it "points along the axis on top" $ torusNormal 0 alongZ 2 1 (V3 2 0 1) `shouldBe` alongZ
    it "points out of the lemon of a spindle" $ torusNormal 0 alongZ 1 2 (V3 1 0 0) `shouldBe` alongX

  describe "torusContains" $ do
    it "holds within the tube" $ torusContains 0 alongZ 2 1 (V3 2 0 0.5) `shouldBe` True
    it "fails in the hole" $ torusContains 0 alongZ 2 1 0 `shouldBe` False
    it "fails on the surface, and a little below it" $ map (torusContains 0 alongZ 2 1 . (\x -> V3 x 0 0)) [3, 2.99999995, 2.9999998] `shouldBe` [False, False, True]

  describe "as laws" $ do
    modifyMaxSuccess (* 20) $ do
      prop "each parameter is on the torus" areOnTheTorus
      prop "there are 0, 2 or 4, ascending" areEvenAndAscending
      prop "moving both changes no bit" moveAlong
      prop "turning both by a quarter, or mirroring them, changes no bit" turnAlong
      prop "doubling every length changes no bit" growAlong
      prop "parameters are inverse to the direction's length" areInverseToTheDirection
      prop "the normal is unit, and along the gradient" areUnitAndAlongTheGradient
    modifyMaxSuccess (* 5) $ prop "they are where the implicit equation changes its sign" areWhereTheSignChanges
    prop "the inside lies between entering and leaving" isBetweenHits
    prop "nothing fails on the axis" isTotalOnTheAxis

  it "is tried in all its corners by these laws" $
    checkCoverage $ \m -> foldr (\(name, holds) -> cover 0.1 holds name) (property True) (corners m)
  where
    ring o d = torusParameters 0 alongZ 2 1 (ray o d)
    spindle o d = torusParameters 0 alongZ 1 2 (ray o d)

-- | Within 2^-50 of each other.
shouldAllBeNear :: [Double] -> [Double] -> Expectation
shouldAllBeNear actual expected =
  actual `shouldSatisfy` \xs -> length xs == length expected && and (zipWith (\x y -> abs (x - y) <= 2 ** (-50) * abs y) xs expected)
