{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Model.MsrSpec
  ( spec,
  )
where

import Data.Foldable (toList)
import Data.List (find)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereRadius)
import Dioptre.Light.Colour (rgb)
import Dioptre.Light.Finish
import Dioptre.Light.Material (Material (..))
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Msr
import Dioptre.Scene (sceneMaterials, sceneModels, scenePrimitives, writeScene)
import Dioptre.Scene.Check (Mention (..), modelWords)
import Dioptre.Scene.Model (Model (..))
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.Syntax.Keyword (spelling)
import Laws.Reading (at)
import Laws.Scene (AnyScene (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (conjoin, (===))

spec :: Spec
spec = describe "an MSR file" $ do
  it "is its primitives and models in the order of the file" $
    map outline (parts (ball "a" "1" <> ["model", "file b.obj", "end"] <> ball "a" "2" <> paint "a" [] <> ["model", "fichier c.msr"]))
      `shouldBe` ["ball 1.0", "b.obj", "ball 2.0", "c.msr"]
  it "has its own materials, of one name the first" $ do
    let Content solids finishes = msrContent (read' (ball "b" "1" <> paint "a" ["kd 0.5", "color 1 0 0"] <> paint "b" ["kd 0.25"] <> paint "a" ["kd 1"] <> ball "a" "1"))
        diffuse n = (\f -> let Layer c _ = finishDiffuse f in c) <$> find' n (toList finishes)
    [diffuse n | Solid _ n <- solids] `shouldBe` [Just (rgb 0.25 0.25 0.25), Just (rgb 0.5 0 0)]
  it "has grey for a material that it does not have, once" $ do
    let msr = read' (ball "a" "1" <> ball "a" "2")
    msrDiagnostics msr `shouldBe` [at 2 15 16 (MissingMaterial "a" Nothing)]
    [(n, finishAmbient <$> find' n (toList (contentFinishes (msrContent msr)))) | Solid _ n <- contentParts (msrContent msr)]
      `shouldBe` replicate 2 (0, Just (Layer (rgb 0.2 0.2 0.2) Nothing))
  it "has no camera, picture or light: such objects are passed over whole" $ do
    let msr = read' (["camera", "position 1 O 2", "end"] <> ball "a" "1" <> ["point_light", "color red"] <> paint "a" [] <> ["aperture_mask_light", "mask m.png", "end", "ray 1"])
        words' = map spelling modelWords
    msrDiagnostics msr
      `shouldBe` [ at 1 1 7 (MisplacedWord "camera" Nothing words' (TheObject 3)),
                   at 10 1 12 (MisplacedWord "point_light" Nothing words' (TheObject 11)),
                   at 15 1 20 (MisplacedWord "aperture_mask_light" Nothing words' (TheObject 17)),
                   at 18 1 4 (MisplacedWord "ray" Nothing words' TheLine)
                 ]
    map outline (contentParts (msrContent msr)) `shouldBe` ["ball 1.0"]
    msrPictures msr `shouldBe` []
  it "tells where it names pictures, models and formats" $ do
    let msr = read' ["texture_material", "name a", "texture_kd  bark.png", "texture_ks none", "end", "model", "uv_format 2", "file b.obj", "end", "model", "end"]
    msrPictures msr `shouldBe` [("bark.png", Span 3 13 21)]
    [(mentionFile m, mentionUvFormat m) | Nested m <- contentParts (msrContent msr)] `shouldBe` [(Span 8 6 11, Just (Span 7 11 12)), (Span 10 1 6, Nothing)]
    msrDiagnostics msr `shouldBe` [at 10 1 6 NoModelFile]
  prop "has what a scene has, but for what models do not have" $ \(AnyScene scene) ->
    let Content found finishes = msrContent (readMsr (parse (fromText "a.msr" (writeScene scene))))
        finishOf p = finish <$> find ((== primitiveMaterial p) . materialName) (sceneMaterials scene)
     in conjoin
          [ [(s, find' n (toList finishes)) | Solid s n <- found] === [(primitiveShape p, finishOf p) | p <- scenePrimitives scene],
            [mentionModel m | Nested m <- found] === sceneModels scene
          ]
  where
    read' = readMsr . parse . fromText "a.msr" . Text.unlines
    parts = contentParts . msrContent . read'
    ball material radius = ["primitive", "material_name " <> material, "sphere", "ray " <> radius, "end", "end"]
    paint name properties = ["material", "name " <> name] <> properties <> ["end"]
    find' n = fmap snd . find ((== n) . fst) . zip [0 :: Int ..]

-- | A part in few words.
outline :: Part Mention -> Text
outline part = case part of
  Solid (ASphere s) _ -> "ball " <> Text.pack (show (sphereRadius s))
  Nested m -> fromMaybe "none" (modelFile (mentionModel m))
  _ -> "something else"
