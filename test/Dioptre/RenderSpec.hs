{-# LANGUAGE OverloadedStrings #-}

-- | Whole pictures: some that geometry knows beforehand, and the laws.
module Dioptre.RenderSpec (spec) where

import Data.Text (Text)
import qualified Data.Vector.Storable as Storable
import Dioptre.Model.Library (noModels)
import Dioptre.Picture (pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Render (rendered)
import Dioptre.Render.Row (plan)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Laws.Rendering
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  -- The camera is at the origin and looks along x, 45 degrees to each side: the near plane's edge at z = 1 is 24
  -- pixels from the middle.
  describe "a picture of 64 x 48 pixels, through their centres" $ do
    -- A radius of 2.5 at a distance of 5 is 1/2, 12 pixels. (No point of half integers is at a distance of 12 exactly.)
    it "shows a disk as a disk" $
      seen ["disk", "position 5 0 0", "normal 1 0 0", "ray 2.5", "end"] `shouldBe` [x * x + y * y < 144 | (x, y) <- centres]
    it "shows an annulus as an annulus" $
      seen ["annulus", "position 5 0 0", "normal 1 0 0", "ray 2.5", "inner_ray 1.25", "end"] `shouldBe` [x * x + y * y < 144 && x * x + y * y > 36 | (x, y) <- centres]
    -- The cone that touches a sphere of radius 3 at a distance of 5 has the tangent 3/4, 18 pixels
    it "shows a sphere by the cone that touches it" $
      seen ["sphere", "position 5 0 0", "ray 3", "end"] `shouldBe` [x * x + y * y < 324 | (x, y) <- centres]
    -- The front face is at x = 4, and its edge at 1: 6 pixels. It hides the rest.
    it "shows a cube by its front face" $
      seen ["cube", "position 5 0 0", "size 2", "end"] `shouldBe` [abs x < 6 && abs y < 6 | (x, y) <- centres]
    -- The ground 1 below: z = -1 is seen below the horizon, no farther than 10.5 from where the ray leaves the near
    -- plane. There x = 1, the direction is (1, -X, -Y) / 24 pixels, made unit, and the ray goes on by (24 / Y - 1)
    -- times the length of (1, X/24, Y/24)
    it "shows a plane up to the far clipping plane" $
      seen ["plane", "position 0 0 -1", "normal 0 0 1", "end"]
        `shouldBe` [y > 0 && (24 / y - 1) * sqrt (1 + (x * x + y * y) / 576) < 10.5 | (x, y) <- centres]
    -- Corners at 12 pixels to the left and right below, and 12 above the middle
    it "shows a triangle as a triangle" $
      seen ["triangle", "point 2 1 -1", "point 2 -1 -1", "point 2 0 1", "end"] `shouldBe` [y < 12 && abs x * 2 < y + 12 | (x, y) <- centres]
    it "shows nothing of what is before the near plane" $ or (seen ["sphere", "position 0 0 0", "ray 0.9", "end"]) `shouldBe` False

  describe "renderWith" $ do
    prop "makes the same picture with 1 to 8 workers" workersDoNotMatter
    prop "counts rays, tests and rows" everythingIsTallied
  where
    centres = [(x + 0.5 - 32, y + 0.5 - 24) | y <- [0 .. 47], x <- [0 .. 63]] :: [(Double, Double)]

-- | Whether each pixel shows the shape, from the top left.
seen :: [Text] -> [Bool]
seen shape
  | (pictureWidth p, pictureHeight p) == (64, 48) = [Storable.toList (Storable.slice (4 * i) 4 (pictureBytes p)) == [255, 0, 0, 255] | i <- [0 .. 64 * 48 - 1]]
  | otherwise = []
  where
    p = rendered (plan mempty noModels (fst (checkScene (parse (fromText "scene" text)))))
    text =
      foldMap (<> "\n") $
        ["camera", "position 0 0 0", "look_at 1 0 0", "up 0 0 1", "angle 90", "near_clipping_plane 1", "far_clipping_plane 10.5", "end"]
          <> ["viewport", "width 64", "height 48", "end", "raytracer", "pixel_coordinate center", "reflexion_algorithm no_light", "end"]
          <> ["material", "name red", "color red", "kd 1", "end", "primitive", "material_name red"]
          <> shape
          <> ["end"]
