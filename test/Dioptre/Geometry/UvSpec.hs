-- |
-- Module      : Dioptre.Geometry.UvSpec
-- Description : Texture coordinates: examples and laws
module Dioptre.Geometry.UvSpec (spec) where

import Dioptre.Geometry.Uv
import Dioptre.Math.Vector (alongX, alongY, alongZ, opposite)
import Laws.Uv
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "frame" $ do
    it "is x, y for z" $ frame alongZ `shouldBe` (V3 1 0 0, V3 0 1 0)
    it "is y, z for x" $ frame alongX `shouldBe` (V3 0 1 0, V3 0 0 1)
    it "is x, -z for y" $ frame alongY `shouldBe` (V3 1 0 0, V3 0 0 (-1))
    it "is x, -y for -z" $ frame (opposite alongZ) `shouldBe` (V3 1 0 0, V3 0 (-1) 0)
    prop "is right-handed, orthogonal and unit" frameIsRightHanded
    prop "starts at the axis of the smallest component" frameStartsAtSmallest

  describe "Flat parts" $ do
    it "have v down" $ planeUv 0 alongZ (V3 2 3 0) `shouldBe` V2 2 (-3)
    it "have the disk's centre in the middle" $ diskUv 1 alongZ 3 1 `shouldBe` V2 0.5 0.5
    it "have the disk's rim at the picture's" $ map (diskUv 0 alongZ 2) [V3 2 0 0, V3 0 2 0, V3 (-2) 0 0, V3 0 (-2) 0] `shouldBe` [V2 1 0.5, V2 0.5 0, V2 0 0.5, V2 0.5 1]
    it "fill the picture with a cube's face" $ map (cubeUv 0 1 alongZ) [V3 (-1) 1 1, V3 1 (-1) 1] `shouldBe` [V2 0 0, V2 1 1]
    it "are the barycentric coordinates on a triangle" $ triangleUv (0.25, 0.5) `shouldBe` V2 0.25 0.5
    prop "lay the disk on the picture" diskFillsPicture
    prop "repeat the picture on a plane" planeRepeats
    prop "are disks at the ends of cylinder and cone" endsAreDisks

  describe "Round parts" $ do
    it "have the sphere's top, bottom and sides" $
      map (sphereUv 0) [V3 0 2 0, V3 0 (-2) 0, V3 2 0 0, V3 0 0 2, V3 0 0 (-2)] `shouldBe` [V2 0.5 0, V2 0.5 1, V2 0.5 0.5, V2 0.75 0.5, V2 0.25 0.5]
    it "have a side's angles and heights" $
      map (sideUv 0 alongZ 4) [V3 1 0 0, V3 0 1 4, V3 0 (-1) 1] `shouldBe` [V2 0.5 1, V2 0.75 0, V2 0.25 0.75]
    it "have a torus' angles" $
      map (torusUv 0 alongZ 2) [V3 3 0 0, V3 0 2 1, V3 0 (-2) (-1)] `shouldBe` [V2 0.5 0.5, V2 0.75 0.25, V2 0.25 0.75]
    it "end where a side does, however short it is" $ map (sideUv 0 alongZ 1e-310) [V3 1 0 1e-16, V3 1 0 (-1e-16), V3 1 0 0] `shouldBe` [V2 0.5 0, V2 0.5 1, V2 0.5 1]
    it "have a flat cone's distances from its axis" $ map (coneUv 0 alongZ 1e-20 2 alongZ) [V3 1 0 0, V3 2.5 0 0, V3 0 2 1e-16] `shouldBe` [V2 0.5 0.5, V2 0.5 1, V2 0.75 1]
    prop "keep longitude and latitude on a sphere" sphereKeepsAngles
    prop "keep angle and height on a side" sideKeepsAngles
    prop "keep both angles on a torus" torusKeepsAngles

  describe "wrapped" $ do
    it "leaves 1 where it is, and brings other whole numbers there or to 0" $ map wrapped [1, 2, 7, 0, -1, -7] `shouldBe` [1, 1, 1, 0, 0, 0]
    it "goes on to the left of 0" $ map wrapped [-0.25, 1.25, 0.1, -1e-20] `shouldBe` [0.75, 0.25, 0.1, 1]
    it "is total" $ map wrapped [1e100, -1e100, 1 / 0, 0 / 0] `shouldBe` [1, 0, 1, 0]
    prop "gives a place on the picture" wrapsIntoPicture
    prop "takes away whole numbers" wrapsByWholeNumbers
    prop "leaves what is on the picture already" leavesWhatIsInPlace
