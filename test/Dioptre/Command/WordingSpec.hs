{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Command.WordingSpec
  ( spec,
  )
where

import Dioptre.Command.Wording (extent, statistics)
import Dioptre.Render.World (Extent (..))
import Dioptre.Source.Language (Language (..))
import Test.Hspec

spec :: Spec
spec = describe "numbers of things" $ do
  it "are singular and plural in each language" $
    [extent l (Extent n n n n) | l <- [English, French], n <- [0, 1, 2]]
      `shouldBe` [ "0 shapes; 0 triangles of models in memory; index of 0 boxes, 0 deep",
                   "1 shape; 1 triangle of models in memory; index of 1 box, 1 deep",
                   "2 shapes; 2 triangles of models in memory; index of 2 boxes, 2 deep",
                   "0 forme\xA0; 0 triangle de modèles en mémoire\xA0; index de 0 boîte, profond de 0",
                   "1 forme\xA0; 1 triangle de modèles en mémoire\xA0; index de 1 boîte, profond de 1",
                   "2 formes\xA0; 2 triangles de modèles en mémoire\xA0; index de 2 boîtes, profond de 2"
                 ]
  it "are so for rays and tests" $
    [statistics l 1 0 | l <- [English, French]]
      `shouldBe` ["1 ray, 0 intersection tests (0.00 a ray)", "1 rayon, 0 test d'intersection (0.00 par rayon)"]
