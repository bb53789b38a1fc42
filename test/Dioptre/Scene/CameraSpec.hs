{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.CameraSpec
  ( spec,
  )
where

import Dioptre.Math.Vector (vector)
import Dioptre.Scene (sceneCamera, sceneViewport)
import Dioptre.Scene.Camera
import Dioptre.Source.Diagnostic (Flaw (..))
import Laws.Reading
import Linear.V3 (V3 (..))
import Test.Hspec

spec :: Spec
spec = do
  describe "a camera" $ do
    it "of which nothing is said has the defaults" $ do
      let scenes = map (readingScene . readLines) [[], ["camera", "end"], ["camera", "position 0 0 0", "look_at 0 0 1", "up 0 1 0", "angle 60 degrees", "near_clipping_plane 1", "far_clipping_plane 100", "end"]]
      map (cameraSettings . sceneCamera) scenes `shouldBe` replicate 3 (CameraSettings 0 (V3 0 0 1) (V3 0 1 0) 60 1 100)
      map sceneCamera scenes `shouldBe` replicate 3 defaultCamera
    it "looks from its position to what it looks at, with its up made square" $ do
      let scene = readingScene (readLines ["camera", "position 1 2 3", "look_at 1 2 8", "haut 0 3 7", "end"])
      vector (cameraFront (sceneCamera scene)) `shouldBe` V3 0 0 1
      vector (cameraUp (sceneCamera scene)) `shouldBe` V3 0 1 0
    it "may be just possible, or just not" $ do
      fmap cameraSettings (camera (settings 1e-10 5 5)) `shouldBe` Right (settings 1e-10 5 5)
      camera (settings 0.9e-10 5 5) `shouldBe` Left NowhereToLook
      camera (settings 1 5 4.9) `shouldBe` Left FarBeforeNear
    it "has no up along its front, however long it is, and none that is too short" $ do
      let flaw look v = either Just (const Nothing) (camera (CameraSettings 0 look v 60 1 100))
      [flaw (V3 0.1 0.2 0.3) (k * V3 0.1 0.2 0.3) | k <- [1e-9, 1, 1e10, 1e30, 1e90]] `shouldBe` replicate 5 (Just UpAlongFront)
      [flaw (V3 0 0 2) v | v <- [V3 0 1 1e9, V3 0 1 2e10, V3 0 1e-10 0, V3 0 0.9e-10 0]] `shouldBe` [Nothing, Just UpAlongFront, Nothing, Just UpAlongFront]
  describe "a viewport" $ do
    it "of which nothing is said is 500 by 500, and called image" $
      map (view . sceneViewport . readingScene . readLines) [[], ["viewport", "end"]] `shouldBe` replicate 2 (500, 500, "image")
    it "is what is said of it" $
      view (sceneViewport (readingScene (readLines ["viewport", "largeur 7 pixels", "hauteur 9", "nom_fichier_image a b", "end"]))) `shouldBe` (7, 9, "a b")
    it "has at least one pixel, and not too many" $ do
      viewport 0 5 "a" `shouldBe` Left ZeroSize
      viewport 5 0 "a" `shouldBe` Left ZeroSize
      viewport (mostPixels + 1) 1 "a" `shouldBe` Left (TooManyPixels mostPixels)
      fmap view (viewport mostPixels 1 "a") `shouldBe` Right (mostPixels, 1, "a")
      viewport 2147483647 2147483647 "a" `shouldBe` Left (TooManyPixels mostPixels)
  where
    view v = (viewportWidth v, viewportHeight v, viewportImage v)
    settings away = CameraSettings 0 (V3 0 0 away) (V3 0 1 0) 60
