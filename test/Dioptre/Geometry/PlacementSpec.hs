-- |
-- Module      : Dioptre.Geometry.PlacementSpec
-- Description : Rays carried into the frame of a shape: examples by hand, and the laws
module Dioptre.Geometry.PlacementSpec (spec) where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Placement (carriedBack, carriedForth, placement)
import Dioptre.Geometry.Ray (ray)
import Dioptre.Geometry.Sphere (sphereParameters)
import Dioptre.Math.Transform (identity, transform)
import Laws.Transform
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  it "leaves a ray as it is where nothing is transformed" $
    carriedBack (placement identity) (ray (V3 1 2 3) (V3 4 5 6)) `shouldBe` ray (V3 1 2 3) (V3 4 5 6)
  it "carries origins with the translation, and directions without" $
    carriedBack (made 1 0 (V3 1 1 1)) (ray (V3 1 2 3) (V3 0 0 1)) `shouldBe` ray (V3 0 1 2) (V3 0 0 1)
  it "does not make directions unit" $ carriedBack (made 2 0 0) (ray (V3 4 0 0) (V3 0 0 1)) `shouldBe` ray (V3 2 0 0) (V3 0 0 0.5)
  it "undoes the rotation" $ carriedBack (made 1 (V3 0 0 90) 0) (ray (V3 0 1 0) (V3 (-1) 0 0)) `shouldBe` ray (V3 1 0 0) (V3 0 1 0)
  it "carries forth what it carries back" $
    carriedForth (made (V3 2 4 8) (V3 90 180 (-90)) (V3 1 2 3)) (carriedBack (made (V3 2 4 8) (V3 90 180 (-90)) (V3 1 2 3)) (ray (V3 5 6 7) (V3 1 0 0)))
      `shouldBe` ray (V3 5 6 7) (V3 1 0 0)
  it "finds an ellipsoid where its sphere is, at the same parameters" $
    -- half axes 3, 1, 1, turned so that the long one is along y, around (0, 0, 5)
    let m = made (V3 3 1 1) (V3 0 0 90) (V3 0 0 5)
     in map (sphereParameters 0 1 . carriedBack m) [ray (V3 0 (-10) 5) (V3 0 1 0), ray (V3 (-10) 0 5) (V3 1 0 0), ray (V3 0 0 0) (V3 0 0 1)]
          `shouldSatisfy` (\found -> and (zipWith near found [[7, 13], [9, 11], [4, 6]]))
  modifyMaxSuccess (* 10) $ do
    prop "parameters stay" keepsParameters
    prop "rays come back" raysComeBack
  where
    made s r t = placement (fromMaybe identity (transform s r t))
    near xs ys = length xs == length ys && and (zipWith (\x y -> abs (x - y) <= 2 ** (-49) * y) xs (ys :: [Double]))
