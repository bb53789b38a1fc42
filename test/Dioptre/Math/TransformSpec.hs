-- |
-- Module      : Dioptre.Math.TransformSpec
-- Description : Scale, turn and move: examples by hand, and the laws
module Dioptre.Math.TransformSpec (spec) where

import Data.Maybe (fromMaybe, isNothing)
import Dioptre.Math.Transform
import Dioptre.Math.Vector (Vector, alongX, alongY, alongZ, opposite, unit, vector)
import Laws.Transform
import Linear.V3 (V3 (..))
import Linear.V4 (V4 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  describe "transform" $ do
    it "refuses a factor that is zero" $ map (isNothing . (\s -> transform s 0 0)) [V3 0 1 1, V3 1 0 1, V3 1 1 (-0.0)] `shouldBe` [True, True, True]
    it "takes a mirror" $ transform (V3 (-1) 1 1) 0 0 `shouldNotBe` Nothing

  describe "matrix" $ do
    it "is the unit matrix for the identity" $ matrix identity `shouldBe` V4 (V4 1 0 0 0) (V4 0 1 0 0) (V4 0 0 1 0) (V4 0 0 0 1)
    it "scales, then turns, then moves" $
      matrix (made (V3 2 3 4) (V3 0 0 90) (V3 5 6 7)) `shouldBe` V4 (V4 0 (-3) 0 5) (V4 2 0 0 6) (V4 0 0 4 7) (V4 0 0 0 1)
    it "turns about x first" $ matrix (made 1 (V3 90 90 0) 0) `shouldBe` V4 (V4 0 1 0 0) (V4 0 0 (-1) 0) (V4 (-1) 0 0 0) (V4 0 0 0 1)

  describe "transformPosition" $ do
    it "turns y to z about x" $ transformPosition (about (V3 90 0 0)) (V3 0 1 0) `shouldBe` V3 0 0 1
    it "turns z to x about y" $ transformPosition (about (V3 0 90 0)) (V3 0 0 1) `shouldBe` V3 1 0 0
    it "turns x to y about z" $ transformPosition (about (V3 0 0 90)) (V3 1 0 0) `shouldBe` V3 0 1 0
    it "moves last" $ transformPosition (placement (made 2 (V3 0 0 180) (V3 1 1 1))) (V3 1 2 3) `shouldBe` V3 (-1) (-3) 7

  describe "transformNormal" $ do
    it "is that of the squeezed surface, not the squeezed direction" $
      -- the plane x + y = 0 becomes x + y / 2 = 0
      fmap (* 5) (vector (transformNormal (placement (made (V3 1 2 1) 0 0)) diagonal)) `shouldSatisfy` (\(V3 x y z) -> abs (x - 2 * sqrt 5) < 1e-14 && abs (y - sqrt 5) < 1e-14 && z == 0)
    it "stays outward in a mirror" $ transformNormal (placement (made (V3 (-1) 1 1) 0 0)) alongX `shouldBe` opposite alongX
    it "turns with its surface" $ transformNormal (about (V3 0 0 90)) alongX `shouldBe` alongY
    it "does not move" $ transformNormal (placement (made 1 0 (V3 5 6 7))) alongZ `shouldBe` alongZ

  describe "as laws" $ do
    modifyMaxSuccess (* 10) $ do
      prop "the matrix is the product T Rz Ry Rx S" isTheProduct
      prop "quarter turns are exact" isExactAtQuarterTurns
      prop "whole turns change nothing" isPeriodic
      prop "points come back" pointsComeBack
      prop "directions are differences of points" directionsAreDifferences
      prop "normals stay normal, unit, and on their side" normalsStayNormal
      prop "normals come back" normalsComeBack
  where
    made :: Vector -> Vector -> Vector -> Transform
    made s r t = fromMaybe identity (transform s r t)
    about r = placement (made 1 r 0)
    diagonal = fromMaybe alongX (unit (V3 1 1 0))
