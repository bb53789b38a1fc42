-- | Many triangles in few numbers: which corners are whose.
module Dioptre.Geometry.MeshSpec (spec) where

import qualified Data.Vector.Unboxed as Vector
import Dioptre.Geometry.Mesh
import Dioptre.Geometry.Triangle (Corners (..))
import Laws.Mesh (meshOf)
import Linear.V3 (V3 (..))
import Test.Hspec

spec :: Spec
spec = do
  -- Two triangles that share the edge from the first vertex to the third
  it "has as many triangles as there are corners by three" $ map (meshSize . meshOf square) [[], [(0, 1, 2)], [(0, 1, 2), (0, 2, 3)]] `shouldBe` [0, 1, 2]
  it "has each triangle's corners in their order" $
    map (meshTriangle (meshOf square [(0, 1, 2), (3, 0, 2)])) [0, 1]
      `shouldBe` [Corners (V3 0 0 7) (V3 1 0 7) (V3 1 2 7), Corners (V3 0 2 7) (V3 0 0 7) (V3 1 2 7)]
  it "stores a vertex once" $ Vector.length (meshPoints (meshOf square [(0, 1, 2), (0, 2, 3)])) `shouldBe` 12
  where
    square = [V3 0 0 7, V3 1 0 7, V3 1 2 7, V3 0 2 7]
