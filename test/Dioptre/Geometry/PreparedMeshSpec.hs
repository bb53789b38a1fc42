-- | Meshes made ready for rays: the laws, and meshes that are closed.
module Dioptre.Geometry.PreparedMeshSpec (spec) where

import Laws.Mesh
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "triangles of a mesh" $
    modifyMaxSuccess (* 5) $ do
      prop "are met as shapes of their own are, to the bit" closestIsAsPlain
      prop "stand in the way if there is a closest one" anyIsWhetherThereIsAClosest
      prop "are flat shapes, or smooth where there are normals or texture coordinates" trianglesAreShapes
      prop "are, prepared, their shapes, prepared, to the bit" preparedTrianglesAreShapes
      modifyMaxSuccess (`div` 5) $ prop "cost nothing where they are there many times" repeatedOnesCostNothing
      it "are tried in all their corners" $
        checkCoverage $ \m -> foldr (\(name, holds) -> cover 2 holds name) (property True) (meshedCorners m)

  describe "a closed mesh" $ do
    prop "has two triangles at every edge (or else the next law says nothing)" everyEdgeIsShared
    modifyMaxSuccess (* 20) $ prop "lets no ray out" noWayOut
    it "is tried in all its corners" $
      checkCoverage $ \e -> foldr (\(name, holds) -> cover 5 holds name) (property True) (enclosedCorners e)
