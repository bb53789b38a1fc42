{-# LANGUAGE OverloadedStrings #-}

-- | Finishes: what shading needs of a material, and its pictures looked up.
module Dioptre.Light.FinishSpec (spec) where

import Data.Foldable (toList)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Light.Colour
import Dioptre.Light.Finish
import Dioptre.Light.Material
import Test.Hspec

spec :: Spec
spec = do
  -- With coefficients and channels that are multiples of powers of two, everything is exact
  describe "the finish of a material" $ do
    it "has the colours of its coefficients, one by one" $
      finish gold
        `shouldBe` Finish
          { finishColours =
              Colours
                { ambientOf = Colour 0.25 0.125 0.0625 0.75,
                  diffuseOf = Colour 0.5 0.25 0.125 0.75,
                  -- 1/4 (3/4 + 1/4 colour), as opaque as the sum
                  specularOf = Colour 0.25 0.21875 0.203125 1,
                  shininessOf = 7
                },
            finishPictures = NoPictures,
            finishMirror = 0.125,
            finishTransparency = 0.5,
            finishTint = Colour 0.5 0.25 0.125 0.75,
            finishIndex = 1.5
          }
    it "has an index of 1, and a black tint, where nothing passes" $ do
      let opaque = finish gold {materialKt = 0}
      (finishIndex opaque, finishTransparency opaque, channels (finishTint opaque)) `shouldBe` (1, 0, [0, 0, 0])
    it "names the pictures, each at its colour" $
      picturesOf (finish (painted (Just "a.png") (Just "b.png") (Just "c.png"))) `shouldBe` [Just "a.png", Just "b.png", Just "c.png"]
    it "knows none where there is none" $
      picturesOf (finish (painted Nothing Nothing (Just "c.png"))) `shouldBe` [Nothing, Nothing, Just "c.png"]
    it "has the colours beside the pictures" $
      (colours (finish (painted (Just "a.png") (Just "b.png") (Just "c.png"))), finishTint (finish (painted (Just "a.png") (Just "b.png") (Just "c.png")))) `shouldBe` (colours (finish gold), finishTint (finish gold))

  describe "withPictures" $ do
    let f = finish (painted (Just "a.png") (Just "lost.png") (Just "ccc.png"))
        look name = if name == "lost.png" then Nothing else Just (Text.length name)
    it "puts in what is found, and leaves the colour where nothing is" $ picturesOf (withPictures look f) `shouldBe` [Just 5, Nothing, Just 7]
    it "leaves everything else alone" $ do
      colours (withPictures look f) `shouldBe` colours f
      (shininessOf (finishColours (withPictures look f)), finishMirror (withPictures look f), finishTransparency (withPictures look f), finishTint (withPictures look f), finishIndex (withPictures look f))
        `shouldBe` (7, 0.125, 0.5, Colour 0.5 0.25 0.125 0.75, 1.5)
    it "changes nothing if every picture stays what it is" $ withPictures Just f `shouldBe` f

  describe "layers" $ do
    let f = finish (painted (Just "a.png") Nothing (Just "c.png")) :: Finish Text
    it "are a colour and its picture" $
      [finishAmbient f, finishDiffuse f, finishSpecular f]
        `shouldBe` [Layer (Colour 0.25 0.125 0.0625 0.75) (Just "a.png"), Layer (Colour 0.5 0.25 0.125 0.75) Nothing, Layer (Colour 0.25 0.21875 0.203125 1) (Just "c.png")]
    it "are changed one at a time" $ do
      let new = Layer white (Just "new.png")
      layers (withAmbient new f) `shouldBe` [new, finishDiffuse f, finishSpecular f]
      layers (withDiffuse new f) `shouldBe` [finishAmbient f, new, finishSpecular f]
      layers (withSpecular new f) `shouldBe` [finishAmbient f, finishDiffuse f, new]
    it "leave no pictures where the last one is taken away" $
      finishPictures (withSpecular (Layer white Nothing) (withAmbient (Layer white Nothing) f)) `shouldBe` NoPictures

  describe "isTransparent" $
    it "is so where kt is not zero, however small" $ map (\kt -> isTransparent (finish gold {materialKt = kt})) [0, 1e-300, 0.5, 1] `shouldBe` [False, True, True, True]

  describe "hasPictures" $
    it "is so where a picture stands in for any of the three colours" $
      map (hasPictures . finish) [gold, painted Nothing Nothing Nothing, painted (Just "a") Nothing Nothing, painted Nothing (Just "b") Nothing, painted Nothing Nothing (Just "c")] `shouldBe` [False, False, True, True, True]

  describe "the pictures of a finish, as those of a container" $
    it "come in the order ambient, diffuse, specular" $ toList (finish (painted (Just "a") Nothing (Just "c"))) `shouldBe` ["a", "c"]
  where
    gold =
      standard
        { materialColour = Colour 1 0.5 0.25 0.75,
          materialKa = 0.25,
          materialKd = 0.5,
          materialKs = 0.25,
          materialKr = 0.125,
          materialKt = 0.5,
          materialShininess = 7,
          materialPlasticity = 0.75,
          materialRefractiveIndex = 1.5
        }
    painted :: Maybe Text -> Maybe Text -> Maybe Text -> Material
    painted a b c = gold {materialTextures = Just (Textures a b c)}
    layers f = [finishAmbient f, finishDiffuse f, finishSpecular f]
    channels (Colour r g b _) = [r, g, b]
    picturesOf f = [p | Layer _ p <- [finishAmbient f, finishDiffuse f, finishSpecular f]]
    colours f = [c | Layer c _ <- [finishAmbient f, finishDiffuse f, finishSpecular f]]
