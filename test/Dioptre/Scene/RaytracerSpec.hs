{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.RaytracerSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene (sceneModels, sceneRaytracer)
import Dioptre.Scene.Model (Model (..), UvFormat (..))
import Dioptre.Scene.Raytracer
import Laws.Reading
import Test.Hspec

spec :: Spec
spec = do
  describe "a raytracer" $ do
    it "of which nothing is said has the defaults" $
      for_ [[], ["raytracer", "end"]] $ \text ->
        sceneRaytracer (readingScene (readLines text)) `shouldBe` Raytracer 1 1 1 Blinn TopLeft LinearSpace ClampChannel 0
    it "is what is said of it" $
      tracer ["task 2", "sampling 3", "recursive_level 4", "graine 5"] `shouldBe` Raytracer 2 3 4 Blinn TopLeft LinearSpace ClampChannel 5
    it "takes each word, in any case, or its number" $ do
      choices "reflexion_algorithm" raytracerAlgorithm [("no_light", NoLight), ("ambient", AmbientOnly), ("diffuse", DiffuseOnly), ("phong_specular", PhongSpecular), ("blinn_specular", BlinnSpecular), ("no_specular", NoSpecular), ("phong", Phong), ("blinn", Blinn)]
      choices "algorithme_reflexion" raytracerAlgorithm [("no_light", NoLight)]
      choices "pixel_coordinate" raytracerPixelCoordinate [("top_left", TopLeft), ("top_right", TopRight), ("bottom_left", BottomLeft), ("bottom_right", BottomRight), ("center", Center), ("random", Random)]
      choices "coordonnee_pixel" raytracerPixelCoordinate [("top_left", TopLeft)]
      choices "space" raytracerSpace [("linear", LinearSpace), ("voxel", VoxelSpace), ("multi_voxel", MultiVoxelSpace)]
      choices "color_normalization" raytracerColourNormalization [("clamp_channel", ClampChannel), ("division_factor", DivisionFactor)]
    it "writes an algorithm as the language does" $
      map algorithmName [NoLight, Blinn] `shouldBe` ["no_light", "blinn"]
  describe "a model" $
    it "takes each format, or its number; nothing, the first" $ do
      let formats lines' = map modelUvFormat (sceneModels (readingScene (readLines (["model"] <> lines' <> ["end"]))))
      map formats [[], ["uv_format default"], ["uv_format 0"], ["uv_format origin_uv_top_left"], ["uv_format 1"], ["uv_format ORIGIN_UV_BOTTOM_LEFT"], ["uv_format 2"], ["uv_format 3"]]
        `shouldBe` map pure [UvDefault, UvDefault, UvDefault, UvTopLeft, UvTopLeft, UvBottomLeft, UvBottomLeft, UvDefault]
      readingScene (readLines ["model", "end"]) `shouldBe` readingScene (readLines ["model", "file none", "scale 1 1 1", "rotation 0 0 0", "translation 0 0 0", "end"])

tracer :: [Text] -> Raytracer
tracer lines' = sceneRaytracer (readingScene (readLines (["raytracer"] <> lines' <> ["end"])))

-- | Each word and its number, with others given before, so that the default proves nothing.
choices :: (Eq a, Show a) => Text -> (Raytracer -> a) -> [(Text, a)] -> IO ()
choices word get options =
  for_ (zip [0 :: Int ..] options) $ \(n, (name, value)) ->
    for_ [name, Text.toUpper name, Text.pack (show n), "[" <> name <> "] #"] $ \written -> do
      let other = if n == 0 then "1" else "0"
      (name, get (tracer [word <> " " <> other, word <> " " <> written])) `shouldBe` (name, value)
      said ["raytracer", word <> " " <> written, "end"] `shouldBe` []
