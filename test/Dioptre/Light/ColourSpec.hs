{-# LANGUAGE OverloadedStrings #-}

-- | Colours: examples, and the laws.
module Dioptre.Light.ColourSpec (spec) where

import Dioptre.Light.Colour
import Laws.Light
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "plus, filtered and scaled" $ do
    it "add, multiply, and multiply by a number, channel by channel" $ do
      plus (Colour 0.25 0.5 0 1) (Colour 0.5 1 2 1) `shouldBe` Colour 0.75 1.5 2 1
      filtered (Colour 0.25 0.5 8 1) (Colour 0.5 1 2 1) `shouldBe` Colour 0.125 0.5 16 1
      scaled 4 (Colour 0.25 0.5 8 1) `shouldBe` Colour 1 2 32 1
    it "keep the first colour's alpha" $ do
      plus (Colour 0 0 0 0.25) (Colour 1 1 1 0.5) `shouldBe` Colour 1 1 1 0.25
      filtered (Colour 1 1 1 0.25) (Colour 1 1 1 0.5) `shouldBe` Colour 1 1 1 0.25
      scaled 0.5 (Colour 1 1 1 0.25) `shouldBe` Colour 0.5 0.5 0.5 0.25
    prop "the result is as opaque as the first colour" alphaIsTheFirsts
    prop "black adds nothing and lets nothing through" blackAddsNothing
    prop "white lets everything through" whiteLetsAllThrough
    prop "the order does not matter, but for alpha" orderDoesNotMatter
    prop "k (a + b) = k a + k b" scalingDistributes

  describe "named" $ do
    it "knows five colours in two languages, in any case" $ do
      map named ["black", "Noir", "WHITE", "blanc"] `shouldBe` map Just [rgb 0 0 0, rgb 0 0 0, rgb 1 1 1, rgb 1 1 1]
      map named ["red", "Rouge", "green", "VERT", "blue", "bleu"] `shouldBe` map Just [rgb 1 0 0, rgb 1 0 0, rgb 0 1 0, rgb 0 1 0, rgb 0 0 1, rgb 0 0 1]
      length names `shouldBe` 10
    it "knows no others" $ map named ["yellow", "", " red"] `shouldBe` [Nothing, Nothing, Nothing]
    it "gives opaque ones" $ map (alpha . snd) names `shouldBe` replicate 10 1
