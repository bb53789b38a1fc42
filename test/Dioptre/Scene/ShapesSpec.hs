{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.ShapesSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.List (sort)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Scene (scenePrimitives)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Scene.Shapes (describeShapes)
import Dioptre.Syntax.Keyword (spelling)
import Laws.Reading
import Test.Hspec

spec :: Spec
spec = describe "a shape of which nothing is said" $ do
  it "has the defaults of its kind" $
    for_ defaults $ \(word, lines') -> do
      let bare = shapes word []
      (word, length bare) `shouldBe` (word, 1)
      (word, bare) `shouldBe` (word, shapes word lines')
      said (primitive word lines') `shouldBe` []
  it "is described in every kind" $ sort (map (spelling . fst) describeShapes) `shouldBe` sort ("geometry" : map fst defaults)
  it "transforms nothing, where it transforms" $
    shapes "geometry" ["cube", "end"] `shouldBe` shapes "geometry" ["scale 1 1 1", "rotation 0 0 0", "translation 0 0 0", "cube", "end"]

defaults :: [(Text, [Text])]
defaults =
  [ ("plane", ["position 0 0 0", "normal 0 0 1"]),
    ("disk", ["position 0 0 0", "normal 0 0 1", "ray 1"]),
    ("annulus", ["position 0 0 0", "normal 0 0 1", "ray 1", "inner_ray 0.5"]),
    ("sphere", ["position 0 0 0", "ray 1"]),
    ("triangle", ["point 0 0 0", "point 0 1 0", "point 1 1 0"]),
    -- (0, 1, 0) x (1, 1, 0) = (0, 0, -1)
    ("btriangle", ["point 0 0 0", "point 0 1 0", "point 1 1 0", "normal 0 0 -1", "normal 0 0 -1", "normal 0 0 -1", "uv 0 0", "uv 0 0", "uv 0 0"]),
    ("tube", ["position 0 0 0", "position 0 0 1", "ray 1"]),
    ("cylinder", ["position 0 0 0", "position 0 0 1", "ray 1"]),
    ("cone", ["position 0 0 0", "position 0 0 1", "ray 1"]),
    ("cube", ["position 0 0 0", "size 1"]),
    ("spherical_cap", ["position 0 0 0", "normal 0 0 1", "ray 1", "curvature 1"]),
    ("lens", ["position 0 0 0", "position 0 0 1", "ray 1", "curvature 1", "curvature 1"]),
    ("torus", ["position 0 0 0", "normal 0 0 1", "major_radius 1", "minor_radius 0.2"])
  ]

primitive :: Text -> [Text] -> [Text]
primitive word lines' = ["material", "name none", "end", "primitive", "material_name none", word] <> lines' <> ["end", "end"]

shapes :: Text -> [Text] -> [Shape]
shapes word lines' = map primitiveShape (scenePrimitives (readingScene (readText (Text.unlines (primitive word lines')))))
