{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.MaterialsSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.Text (Text)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Light.Material (Material (..), Textures (..))
import Dioptre.Scene (sceneMaterials)
import Laws.Reading
import Test.Hspec

spec :: Spec
spec = do
  describe "a material of which nothing is said" $ do
    it "has the defaults" $
      for_ ["material", "materiel", "color_material", "blinn_material"] $ \word -> materials word [] `shouldBe` [standard Nothing]
    it "has no textures, where it can have some" $
      for_ ["texture_material", "texture_materiel"] $ \word -> materials word [] `shouldBe` [standard (Just (Textures Nothing Nothing Nothing))]
  describe "a material" $ do
    it "is what is said of it" $
      materials "material" ["p 0.25", "n 1.5", "kt 0.75", "kr 0.5", "ks 0.125", "kd 0.0625", "ka 1", "brillance 200", "nom m n", "couleur rouge 0.5"]
        `shouldBe` [Material "m n" (Colour 1 0 0 0.5) 1 0.0625 0.125 0.5 0.75 200 0.25 1.5 Nothing]
    it "may have colours brighter than white" $
      map materialColour (materials "material" ["color 2 0 1e100 7"]) `shouldBe` [Colour 2 0 1e100 7]
    it "has textures only where it may" $ do
      map materialTextures (materials "texture_material" ["texture_ka a.png", "texture_kd b c.png", "texture_ks none"]) `shouldBe` [Just (Textures (Just "a.png") (Just "b c.png") Nothing)]
      said ["material", "texture_ka a.png", "end"] `shouldBe` [("misplaced-word", 2, 1, 11)]
    it "keeps 1.0 where its index is refused" $
      map materialRefractiveIndex (materials "material" ["n 0"]) `shouldBe` [1]
  where
    standard = Material "none" (Colour 1 1 1 1) 0.2 0.8 0.5 0 0 20 0 1

materials :: Text -> [Text] -> [Material]
materials word lines' = sceneMaterials (readingScene (readLines ([word] <> lines' <> ["end"])))
