{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.WordingSpec
-- Description : Stories in words
module Dioptre.Explain.WordingSpec (spec) where

import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Explain.Tell (tell)
import Dioptre.Explain.Wording
import Dioptre.Model.Library (noModels)
import Dioptre.Source.Language (Language (..))
import Laws.Shade (sceneOf)
import Laws.Story (Pictured (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (counterexample, (.&&.), (===))

spec :: Spec
spec = do
  describe "a black pixel above a plane, as in the handout's question 1.7" $ do
    it "says that the plane is behind the ray" $
      explained English dark 4 0
        `shouldHold` [ "The pixel is (0, 0, 0, 255), black; its ray meets no shape: of 1 shape, 1 behind its origin.",
                       "primitive 1 (plane 'grey'): not met: it is behind the origin of the ray (t < 0)",
                       "A t + B = 0",
                       "negative: behind the origin",
                       "It meets nothing: black."
                     ]
    it "says so in French" $
      explained French dark 4 0
        `shouldHold` [ "Le pixel vaut (0, 0, 0, 255), noir\xA0; son rayon ne rencontre aucune forme\xA0: sur 1 forme, 1 derrière son origine.",
                       "primitive 1 (plan 'grey')\xA0: pas de rencontre\xA0: derrière l'origine du rayon (t < 0)",
                       "Il ne rencontre rien\xA0: noir."
                     ]
    it "says where the plane is beyond the far clipping plane" $
      explained English dark 4 5 `shouldHold` ["black", "of 1 shape, 1 beyond the far clipping plane", "too far: not before the far clipping plane"]
    it "tells the colour of the plane below" $
      explained English dark 4 8 `shouldHold` ["its ray sees primitive 1 (plane 'grey')", "Without light (no_light) its diffuse colour is seen as it is: [0.5, 0.5, 0.5]", "times 255, rounded: (128, 128, 128, 255)"]
  describe "black pixels with a shape" $ do
    it "says that there is no light" $
      explained English (lit []) 4 8 `shouldHold` [", and the scene has no light."]
    it "says that no light reaches it, and why" $
      explained English (lit ["directional_light", "orientation 0 0 1", "end"]) 4 8 `shouldHold` [", which no light reaches.", "nothing: the surface is turned away"]
    it "names what casts the shadow" $
      explained English (lit ["directional_light", "orientation 0 0 -1", "end", "primitive", "material_name grey", "plane", "position 0 0 50", "end", "end"]) 4 8
        `shouldHold` [", which no light reaches.", "nothing: in the shadow of primitive 2 (plane 'grey'), 50"]
    it "says that its own colour is black" $
      explained English (map (Text.replace "color white" "color black") dark) 4 8 `shouldHold` [", whose own colour is black."]
  it "says of many rays that it tells the first two" $
    explained English (["raytracer", "sampling 5", "pixel_coordinate random", "reflexion_algorithm no_light", "end"] <> plain) 4 8
      `shouldHold` ["5 rays are cast through the pixel, whose colour is their mean.", "RAY 1 OF 5", "RAY 2 OF 5", "The other 3 rays of the pixel are told with --format json."]
  it "counts shapes where they are many" $
    explained English (dark <> concat (replicate 50 ["primitive", "material_name grey", "sphere", "position 0 0 -9", "end", "end"])) 4 8 `shouldHold` ["The others: 50 beside its line."]
  it "names both radii of an annulus where the point lies between them, and the inner one in the hole" $ do
    let ring inner = ["viewport", "width 9", "height 9", "end", "raytracer", "reflexion_algorithm no_light", "pixel_coordinate center", "end", "primitive", "material_name m", "annulus", "position 0.75 0 4", "ray 1", "inner_ray " <> inner, "end", "end", "material", "name m", "end"]
    explained English (ring "0.5") 4 4 `shouldHold` ["kept: the point is 0.75 from the centre, at least r = 0.5 and at most R = 1.0"]
    explained French (ring "0.5") 4 4 `shouldHold` ["gard\233e\xA0: le point est \224 0.75 du centre, au moins r = 0.5 et au plus R = 1.0"]
    explained English (ring "0.8") 4 4 `shouldHold` ["outside: the point is 0.75 from the centre, less than r = 0.8"]
  it "writes -0 as 0" $
    explained English ["viewport", "width 9", "height 9", "end", "raytracer", "reflexion_algorithm no_light", "pixel_coordinate center", "end", "primitive", "material_name m", "cube", "position 0 0 4", "end", "end", "material", "name m", "end"] 4 4
      `shouldHold` ["normal   [0.0, 0.0, -1.0]"]
  prop "every story has words, in lines of text that can be shown, in both languages" $ \(Pictured scene assets x y) ->
    let told l = maybe "" (storyText l "scene.txt") (tell assets [] noModels scene x y)
     in counterexample (Text.unpack (told English)) (Text.all (\c -> c == '\n' || c >= ' ') (told English <> told French))
          .&&. length (filter ("Ray 1" `Text.isPrefixOf`) (Text.lines (told English))) === length (filter ("Rayon 1" `Text.isPrefixOf`) (Text.lines (told French)))
          .&&. (Text.length (told English) > 200) === True
          .&&. counterexample "-0.0" ("-0.0" `notElem` Text.split (`notElem` ("0123456789.-e" :: String)) (told English))

-- | The story of a pixel of the scene of these lines.
explained :: Language -> [Text] -> Int -> Int -> Text
explained l text x y = maybe "" (storyText l "scene.txt") (tell mempty [] noModels (sceneOf text) x y)

-- | A grey plane, seen along it from a height of 1, without light, and as it is.
dark, plain :: [Text]
dark = ["raytracer", "reflexion_algorithm no_light", "end"] <> plain
plain =
  ["camera", "position 0 0 1", "look_at 1 0 1", "up 0 0 1", "near_clipping_plane 0.1", "far_clipping_plane 5", "end"]
    <> ["viewport", "width 9", "height 9", "end"]
    <> ["primitive", "material_name grey", "plane", "end", "end"]
    <> ["material", "name grey", "color white", "kd 0.5", "ka 0", "ks 0", "end"]

-- | The same with these lights.
lit :: [Text] -> [Text]
lit lights = ["raytracer", "reflexion_algorithm blinn", "end"] <> plain <> lights

shouldHold :: Text -> [Text] -> Expectation
shouldHold text parts = for_ parts $ \part -> Text.unpack text `shouldContain` Text.unpack part
