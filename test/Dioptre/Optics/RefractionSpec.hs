-- | Surfaces between two media: examples, and the laws.
module Dioptre.Optics.RefractionSpec (spec) where

import Data.Maybe (isJust)
import Dioptre.Math.Vector
import Dioptre.Optics.Refraction (refracted)
import Laws.Draw (ulpsApart)
import Laws.Optics
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = modifyMaxSuccess (* 10) $ do
  describe "refracted" $ do
    it "lets light pass that comes straight" $ refracted (V3 0 0 (-1)) alongZ 1 1.5 `shouldBe` Just (V3 0 0 (-1))
    it "lets light pass that comes straight, whatever the indices are" $
      [refracted v n n1 n2 | (v, n) <- [(V3 0 0 (-1), alongZ), (V3 0 0 1, opposite alongZ)], (n1, n2) <- [(1e200, 1), (1, 1e-200), (1e9, 1), (1, 1e200)]] `shouldBe` concatMap (replicate 4 . Just) [V3 0 0 (-1), V3 0 0 1]

    -- sin a1 = 4/5 and n2/n1 = 4/3 give sin a2 = 3/5; both are 0.8 and 0.6 of the nearest doubles
    it "bends light into water: sines of 4/5 and 3/5" $
      refracted (V3 0.8 0 (-0.6)) alongZ 3 4 `shouldSatisfy` maybe False (near (V3 0.6 0 (-0.8)))
    it "and out of it" $
      refracted (V3 0.6 0 (-0.8)) alongZ 4 3 `shouldSatisfy` maybe False (near (V3 0.8 0 (-0.6)))

    -- Into a medium with twice the index: sin a2 = 1/2
    it "lets light in that grazes the surface" $
      refracted (V3 1 0 0) alongZ 1 2 `shouldSatisfy` maybe False (near (V3 0.5 0 (negate (sqrt 0.75))))

    -- c^2 = 1/4, (n2/n1)^2 = 1/4 and 1
    it "lets nothing out beyond the critical angle" $
      [refracted (V3 (sqrt 0.75) 0 (-0.5)) alongZ 2 n | n <- [0.5, 1, 1.7]] `shouldBe` [Nothing, Nothing, Nothing]
    -- sqrt 3 = 1.7320508: one has c^2 + (n2/n1)^2 = 1 - 3e-8, the other 1 + 4e-8
    it "knows the critical angle on either side" $
      [isJust (refracted (V3 (sqrt 0.75) 0 (-0.5)) alongZ 2 n) | n <- [1.73205077, 1.73205085]] `shouldBe` [False, True]

    -- 0.6^2 + 0.8^2 rounds to 1: not below it, and so not total; T runs along the surface
    it "lets light pass along the surface at the critical angle" $
      refracted (V3 0.8 0 (-0.6)) alongZ 1 0.8 `shouldSatisfy` maybe False (\(V3 x y z) -> abs (x - 1) < 1e-15 && y == 0 && abs z < 1e-7)
    prop "n1 sin a1 = n2 sin a2" refractionObeysSnell
    prop "incident direction, normal and transmitted direction lie in one plane" refractionStaysInThePlane
    prop "what passes goes on to the other side" refractionGoesThrough
    prop "the transmitted direction is unit" refractionIsUnit
    prop "light that goes back along its path returns" refractionReturns
    prop "nothing passes exactly where c^2 + (n2/n1)^2 < 1" reflectionIsTotal
    prop "equal indices change nothing, at any angle" equalIndicesChangeNothing
  where
    -- r, its product, the cosine and the root: some 8 roundings, of numbers between 1/2 and 1
    near (V3 x y z) (V3 x' y' z') = and (zipWith (\a b -> a == b || ulpsApart a b <= 8) [x, y, z] [x', y', z'])
