-- | Disks and annuli: examples, and the laws.
module Dioptre.Geometry.DiskSpec (spec) where

import Data.Foldable (for_)
import Dioptre.Geometry.Disk
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (alongX)
import Laws.Aim
import Laws.Shape
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "disk and annulus" $ do
    it "have a size" $ do
      fmap diskRadius (across >>= \p -> disk p 2) `shouldBe` Just 2
      [across >>= \p -> disk p r | r <- [0, -1, 0 / 0]] `shouldBe` [Nothing, Nothing, Nothing]
    it "have a hole that is not larger than the disk" $ do
      fmap (\a -> (annulusInner a, annulusOuter a)) (across >>= \p -> annulus p 1 1) `shouldBe` Just (1, 1)
      [across >>= \p -> annulus p inner outer | (inner, outer) <- [(-1, 1), (2, 1), (0 / 0, 1)]] `shouldBe` [Nothing, Nothing, Nothing]

  describe "diskParameters and annulusParameters" $ do
    -- The point (2, 3, 4) of the plane x = 2, at a distance of 5 from (2, 0, 0)
    it "have the rims" $ do
      diskParameters (V3 2 0 0) alongX 5 (ray (V3 0 3 4) (V3 1 0 0)) `shouldBe` [2]
      annulusParameters (V3 2 0 0) alongX 5 9 (ray (V3 0 3 4) (V3 1 0 0)) `shouldBe` [2]
      annulusParameters (V3 2 0 0) alongX 1 5 (ray (V3 0 3 4) (V3 1 0 0)) `shouldBe` [2]
    it "have nothing beyond" $ do
      diskParameters (V3 2 0 0) alongX 4.999999999999999 (ray (V3 0 3 4) (V3 1 0 0)) `shouldBe` []
      annulusParameters (V3 2 0 0) alongX 5.000000000000001 9 (ray (V3 0 3 4) (V3 1 0 0)) `shouldBe` []
      annulusParameters (V3 2 0 0) alongX 1 9 (ray (V3 0 0 0) (V3 1 0 0)) `shouldBe` []

  for_ [DiskSort, AnnulusSort] $ \sort -> modifyMaxSuccess (* 8) $
    describe ("as laws of " ++ show sort) $ do
      mapM_ (\(law, holds) -> prop law (forAllShrink (aimedAt sort) shrink holds)) lawsOfShapes
      prop "where nothing is rounded, nothing is left to rounding" $ forAll (crispAt sort) isExactWhereItCanBe
      prop "ray and shape moved together meet at the same parameters" $ forAll (crispAt sort) movedTogether
      prop "it is hit exactly where its plane is hit within the radius" $ forAllShrink (aimedAt sort) shrink diskIsPlaneWithin
  prop "an annulus without a hole is a disk" $ forAllShrink (aimedAt DiskSort) shrink annulusWithoutHoleIsDisk
  where
    across = plane (V3 2 0 0) (V3 3 0 0)
