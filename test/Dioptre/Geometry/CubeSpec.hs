-- | Cubes: examples, and the laws.
module Dioptre.Geometry.CubeSpec (spec) where

import Dioptre.Geometry.Cube
import Dioptre.Geometry.Ray (ray)
import Dioptre.Math.Vector (vector, (*^))
import Laws.Aim
import Laws.Shape
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck hiding (vector)

spec :: Spec
spec = do
  describe "cube" $
    it "has a size" $ do
      fmap cubeSize (cube 0 2) `shouldBe` Just 2
      [cube 0 s | s <- [0, -1, 0 / 0]] `shouldBe` [Nothing, Nothing, Nothing]

  describe "cubeParameters" $ do
    it "enters and leaves" $ cubeParameters (V3 5 0 0) 1 (ray 0 (V3 1 0 0)) `shouldBe` [4, 6]
    it "is hit by a ray in a face, where it comes in and goes out" $ cubeParameters (V3 5 0 0) 1 (ray (V3 0 1 0) (V3 2 0 0)) `shouldBe` [2, 3]
    it "is hit by a ray along an edge" $ cubeParameters (V3 5 0 0) 1 (ray (V3 0 1 (-1)) (V3 1 0 0)) `shouldBe` [4, 6]
    it "is touched at an edge" $ cubeParameters (V3 5 0 0) 1 (ray (V3 2 (-1) 0) (V3 1 1 0)) `shouldBe` [2, 2]
    it "is touched at a corner" $ cubeParameters (V3 5 0 0) 1 (ray (V3 2 (-1) 3) (V3 1 1 (-1))) `shouldBe` [2, 2]
    it "is missed beside a face" $ cubeParameters (V3 5 0 0) 1 (ray (V3 0 1.0000000000000002 0) (V3 1 0 0)) `shouldBe` []
    it "is missed beside an edge" $ cubeParameters (V3 5 0 0) 1 (ray (V3 2 (-0.9999999999999998) 0) (V3 1 1 0)) `shouldBe` []

  describe "cubeNormal" $ do
    it "is that of the face that the ray crosses" $
      [ [vector (cubeNormal 0 1 r t) | t <- cubeParameters 0 1 r]
        | d <- [V3 1 0 0, V3 0 1 0, V3 0 0 1],
          let r = ray (-4 *^ d) d
      ]
        `shouldBe` [[V3 (-1) 0 0, V3 1 0 0], [V3 0 (-1) 0, V3 0 1 0], [V3 0 0 (-1), V3 0 0 1]]
    -- A ray through the middle of each edge, towards the centre and on
    it "is on an edge that of the first face in the order +z -z +y -y +x -x" $
      [ (edge, vector (cubeNormal 0 1 r t))
        | edge <- edges,
          let r = ray (3 *^ edge) (negate edge),
          t <- take 1 (cubeParameters 0 1 r)
      ]
        `shouldBe` [(edge, firstOf edge) | edge <- edges]

  modifyMaxSuccess (* 8) $
    describe "as laws" $ do
      mapM_ (\(law, holds) -> prop law (forAllShrink (aimedAt CubeSort) shrink holds)) lawsOfShapes
      prop "where nothing is rounded, nothing is left to rounding" $ forAll (crispAt CubeSort) isExactWhereItCanBe
      prop "ray and shape moved together meet at the same parameters" $ forAll (crispAt CubeSort) movedTogether
      prop "a line meets it in an interval: inside between, outside beyond" $ forAllShrink (aimedAt CubeSort) shrink meetsInAnInterval
      prop "it contains the points that are inside" $ forAllShrink (aimedAt CubeSort) shrink containsItsInside
      prop "it does not contain its surface" $ forAll (crispAt CubeSort) doesNotContainItsSurface
      prop "a ray enters against the normal and leaves along it" $ forAllShrink (aimedAt CubeSort) shrink entersAgainstTheNormal
  where
    -- Edges and corners, by the faces that meet there
    edges = [V3 x y z | x <- [-1, 0, 1], y <- [-1, 0, 1], z <- [-1, 0, 1], abs x + abs y + abs z > 1]
    firstOf (V3 x y z)
      | z /= 0 = V3 0 0 z
      | y /= 0 = V3 0 y 0
      | otherwise = V3 x 0 0
