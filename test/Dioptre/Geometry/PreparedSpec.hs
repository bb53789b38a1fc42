-- | Prepared shapes: what they are made of, what is nearest, and that all of the laws' rays do what they are drawn for.
module Dioptre.Geometry.PreparedSpec (spec) where

import Data.Foldable (for_)
import Dioptre.Geometry.Prepared
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongX, opposite)
import Laws.Aim
import Laws.Shape
import Laws.Verdict (isSure, verdict)
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  for_ [minBound .. maxBound] $ \sort -> modifyMaxSuccess (* 5) $
    describe ("of " ++ show sort) $ do
      prop "it is hit at the parameters of its rule, bit for bit" $ forAllShrink (aimedAt sort) shrink isAsPlain
      prop "the nearest hit is the first above 1e-8 and below the bound" $ forAllShrink (aimedAt sort) shrink nearestIsLeast
      prop "the shading normal does not point along the ray" $ forAllShrink (aimedAt sort) shrink shadingNormalFacesTheRay
      it "is decided by the second opinion for most rays" $
        checkCoverage $ forAll (aimedAt sort) $ \(Aimed shape r) -> cover 50 (isSure (verdict shape r)) "sure" True

  describe "shadingNormal" $ do
    it "turns a normal against the ray" $ do
      shadingNormal (ray 0 (V3 1 2 3)) alongX `shouldBe` opposite alongX
      shadingNormal (ray 0 (V3 (-1) 2 3)) alongX `shouldBe` alongX
    it "turns a normal that is orthogonal to the ray" $ shadingNormal (ray 0 (V3 0 2 3)) alongX `shouldBe` opposite alongX

  describe "position" $ modifyMaxSuccess (* 3) $ prop "is o + t d, each component rounded twice" positionIsNearExact

  it "is tried by rays that hit, miss, touch, and run along axes" $
    checkCoverage $ \aimed -> foldr (\(name, holds) -> cover 0.5 holds name) (property True) (aimCorners aimed)
