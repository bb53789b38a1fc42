{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.LightsSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.List (sort)
import Data.Text (Text)
import Dioptre.Light.Light (Light)
import Dioptre.Scene (sceneLights)
import Dioptre.Scene.Lights (describeLights)
import Dioptre.Syntax.Keyword (spelling)
import Laws.Reading
import Test.Hspec

spec :: Spec
spec = do
  describe "a light of which nothing is said" $ do
    it "has the defaults of its kind" $
      for_ defaults $ \(word, lines') -> do
        (word, length (lights word [])) `shouldBe` (word, 1)
        (word, lights word []) `shouldBe` (word, lights word lines')
        said ([word] <> lines' <> ["end"]) `shouldBe` []
    it "is described in every kind" $ sort (map (spelling . fst) describeLights) `shouldBe` sort (map fst defaults)
  describe "lights" $
    it "are kept in the order of the file" $
      sceneLights (readingScene (readLines ["point_light", "end", "ambient_light", "end", "camera", "end", "point_light", "position 1 2 3", "end"]))
        `shouldBe` (lights "point_light" [] <> lights "ambient_light" [] <> lights "point_light" ["position 1 2 3"])

defaults :: [(Text, [Text])]
defaults =
  [ ("ambient_light", ["color white"]),
    ("directional_light", ["color 1 1 1 1", "orientation 0 0 -1"]),
    ("point_light", "position 0 0 0" : lamp),
    ("linear_aperture_light", ["position 0 0 0", "position 0 0.0001 0"] <> lamp <> wave),
    ("rectangular_aperture_light", "position 0 0 0" : lamp <> wave <> aperture),
    ("elliptical_aperture_light", "position 0 0 0" : lamp <> wave <> aperture),
    ("aperture_mask_light", ["position 0 0 0", "mask none"] <> lamp <> wave <> aperture)
  ]
  where
    lamp = ["color white", "amplification 1", "constant_attenuator 1", "linear_attenuator 0", "quadratic_attenuator 0"]
    wave = ["wave_length 550 nm", "period_iteration 10", "nb_oscillator 2"]
    aperture = ["width 0.001", "height 0.001", "front 0 0 1", "up 0 1 0"]

lights :: Text -> [Text] -> [Light]
lights word lines' = sceneLights (readingScene (readLines ([word] <> lines' <> ["end"])))
