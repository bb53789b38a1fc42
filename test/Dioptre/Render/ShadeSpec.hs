{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Render.ShadeSpec
-- Description : The colours that rays see: scenes whose answer is known, and the laws
--
-- Most scenes here are made of integers, halves and Pythagorean triples, so that their answers are exact.
module Dioptre.Render.ShadeSpec (spec) where

import Data.Foldable (for_)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector.Storable as Storable
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Light.Colour
import Dioptre.Light.Light (Lamp (..), Light (..))
import Dioptre.Light.Wavelength (colourOfWavelength)
import Dioptre.Math.Vector
import Dioptre.Model.Library (noModels)
import Dioptre.Picture (Picture, picture)
import Dioptre.Render (renderWith, rendered)
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row (Plan, colourAt, plan)
import Dioptre.Render.Surroundings (refractiveIndexAt)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.Transmittance
import Dioptre.Render.World (world)
import Laws.Shade
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "lights" lights
  describe "shadows" shadows
  describe "lights, at every pixel" pixels
  describe "mirrors" mirrors
  describe "transparent bodies" bodies
  describe "pictures on surfaces" textures
  describe "the budget of rays" budget
  describe "pictures" pictures
  describe "the laws of shading" laws

-------------------------------------------------------------------------------
-- Scenes

-- | The colour that a ray sees in the scene of these lines.
colourIn :: [Text] -> Ray -> Colour
colourIn text = shownColour . seen (sceneOf text)

-- | A floor at z = 0, of a material of its own.
floorOf :: [Text] -> [Text]
floorOf = thing "floor" ["plane", "end"]

-- | White, and lit by Lambert's term only.
chalk :: [Text]
chalk = ["ka 0", "kd 1", "ks 0"]

-- | A shape with a material that says this.
thing :: Text -> [Text] -> [Text] -> [Text]
thing = thing' "material"

thing' :: Text -> Text -> [Text] -> [Text] -> [Text]
thing' word name shape properties = [word, "name " <> name] ++ properties ++ ["end", "primitive", "material_name " <> name] ++ shape ++ ["end"]

tracer :: [Text] -> [Text]
tracer properties = ["raytracer"] ++ properties ++ ["end"]

-- | From (3, 0, 4), 5 away, to the origin: by way of (3 s, 0, 4 s).
slanting :: Ray
slanting = ray (V3 3 0 4) (V3 (-0.6) 0 (-0.8))

-- | Straight down to the origin.
downwards :: Ray
downwards = ray (V3 0 0 4) (V3 0 0 (-1))

-- | A white lamp above the origin.
lampAt :: Double -> [Text] -> [Text]
lampAt z properties = ["point_light", "position 0 0 " <> shown z] ++ properties ++ ["end"]

shown :: Show a => a -> Text
shown = Text.pack . show

-- | Black, opaque.
nothing :: Colour
nothing = Colour 0 0 0 1

-------------------------------------------------------------------------------
-- Lights

lights :: Spec
lights = do
  it "light a floor from straight above" $ colourIn (floorOf chalk ++ lampAt 4 []) slanting `shouldBe` white
  it "light it with their colour times the floor's, and the amplification" $
    colourIn (floorOf (chalk ++ ["color 0.5 1 0.25"]) ++ lampAt 4 ["color 0.5 0.25 2", "amplification 8"]) slanting `shouldBe` rgb 2 2 4
  -- The light comes from (3, 0, 4): the cosine is 4/5
  it "light it by the cosine" $ do
    let c = colourIn (floorOf chalk ++ ["directional_light", "orientation -3 0 -4", "end"]) downwards
    c `shouldBe` rgb 0.8 0.8 0.8
  it "fall off with the square of the distance, if so told" $
    [colourIn (floorOf chalk ++ lampAt z ["constant_attenuator 0", "quadratic_attenuator 1"]) slanting | z <- [1, 2, 4, 8]]
      `shouldBe` [rgb x x x | x <- [1, 1 / 4, 1 / 16, 1 / 64]]
  it "fall off by all three attenuators: 1 / (2 + 3 D / 2 + D^2 / 8) at D = 4 and 8" $
    [colourIn (floorOf chalk ++ lampAt z ["constant_attenuator 2", "linear_attenuator 1.5", "quadratic_attenuator 0.125", "amplification 55"]) slanting | z <- [4, 8]]
      `shouldBe` [rgb x x x | x <- [55 / 10, 55 / 22]]
  it "do not fall off if nothing is said" $ [colourIn (floorOf chalk ++ lampAt z []) slanting | z <- [1, 1000]] `shouldBe` [white, white]

  it "give nothing where they stand, and take no shadow ray" $ seen (sceneOf (floorOf chalk ++ lampAt 0 [])) slanting `shouldBe` Shown nothing 1 False
  it "give nothing where their attenuation divides by zero" $
    seen (setLights [PointLight (Lamp white (V3 0 0 4) 1 (0, 0, 0))] (sceneOf (floorOf chalk))) slanting `shouldBe` Shown nothing 1 False

  it "take a shadow ray each, where the surface faces them" $ do
    shownRays (seen (sceneOf (floorOf chalk ++ lampAt 4 [] ++ lampAt 5 [] ++ ["directional_light", "end", "ambient_light", "end"])) slanting) `shouldBe` 4
    shownRays (seen (sceneOf (floorOf chalk ++ lampAt (-4) [] ++ lampAt 5 [])) slanting) `shouldBe` 2
  it "give nothing to a surface that is turned away" $
    for_ [lampAt (-4) [], ["directional_light", "orientation 0 0 1", "end"], waves ["position 0 0 -4"]] $ \light ->
      seen (sceneOf (floorOf chalk ++ light)) slanting `shouldBe` Shown nothing 1 False
  it "give nothing along a surface" $
    for_ [["directional_light", "orientation 1 0 0", "end"], ["point_light", "position 7 0 0", "end"], waves ["position 7 0 0"]] $ \light ->
      seen (sceneOf (floorOf chalk ++ light)) slanting `shouldBe` Shown nothing 1 False
  it "light the side that is seen" $
    [colourIn (floorOf chalk ++ lampAt z []) (ray (V3 0 0 z') (V3 0 0 (negate (signum z')))) | (z, z') <- [(4, 3), (-4, -3), (4, -3), (-4, 3)]]
      `shouldBe` [white, white, nothing, nothing]

  it "leave no light, where they have no colour" $ shownColour (seen (sceneOf (floorOf chalk ++ lampAt 4 ["color black"])) slanting) `shouldBe` nothing
  it "leave an opaque picture, whatever alphas there are" $
    colourIn (floorOf (chalk ++ ["color 1 1 1 0.25"]) ++ lampAt 4 ["color 1 1 1 0.5"] ++ ["ambient_light", "color 1 1 1 0", "end"]) slanting `shouldBe` white
  it "show kd times the colour with its alpha, and nothing else, if there is to be no light" $
    seen (sceneOf (tracer ["reflexion_algorithm no_light", "recursive_level 9"] ++ floorOf ["color 1 0.5 0.25 0.75", "kd 0.5", "ka 1", "kr 1"] ++ lampAt 4 [])) slanting
      `shouldBe` Shown (Colour 0.5 0.25 0.125 0.75) 1 False
  it "leave black what is nowhere" $ do
    seen (sceneOf (lampAt 4 [])) slanting `shouldBe` Shown nothing 1 False
    seen (sceneOf (tracer ["reflexion_algorithm no_light"])) slanting `shouldBe` Shown nothing 1 False
  -- The floor is 5 away
  it "show nothing beyond the far clipping plane, nor upon it" $
    [colourIn (["camera", "far_clipping_plane " <> far, "end"] ++ floorOf chalk ++ lampAt 4 []) slanting | far <- ["5.001", "5", "4.999"]] `shouldBe` [white, nothing, nothing]

  describe "under each algorithm" $ do
    -- ka, kd, ks are 1/8, 1/4, 1/2 of white. Lit and seen from straight above, each term is 1; and light and viewer on
    -- one side at the sine of 3/5 leave Blinn's highlight as it is with a shininess of 0, and Phong's cosine of the
    -- double angle, 16/25 - 9/25
    for_ [("ambient", 1 / 8), ("diffuse", 1 / 4), ("phong_specular", 1 / 2), ("blinn_specular", 1 / 2), ("no_specular", 3 / 8), ("phong", 7 / 8), ("blinn", 7 / 8)] $ \(algorithm, sum') ->
      it ("add up the terms of " <> Text.unpack algorithm) $
        colourIn (tracer ["reflexion_algorithm " <> algorithm] ++ floorOf ["ka 0.125", "kd 0.25", "ks 0.5"] ++ lampAt 9 [] ++ ["ambient_light", "end"]) downwards `shouldBe` rgb sum' sum' sum'
    it "tell Phong's highlight from Blinn's" $ do
      let at algorithm = red (colourIn (tracer ["reflexion_algorithm " <> algorithm] ++ floorOf ["ks 1", "shininess 1"] ++ ["point_light", "position 3 0 4", "end"]) slanting)
      map (\a -> round (1e15 * at a)) ["phong_specular", "blinn_specular"] `shouldBe` [280000000000000, 800000000000000 :: Integer]

  describe "of waves" $ do
    -- One source gives a half; 16 from 4 away with the square of the distance is 1
    it "give half their colour, times amplification and attenuation, whatever the material and the algorithm" $
      for_ ["ambient", "diffuse", "phong_specular", "blinn_specular", "no_specular", "phong", "blinn"] $ \algorithm ->
        for_ [["ka 0", "kd 0", "ks 0", "color black"], ["kd 1"]] $ \material ->
          near 8 (colourIn (tracer ["reflexion_algorithm " <> algorithm] ++ floorOf material ++ waves ["position 0 0 4", "amplification 16", "constant_attenuator 0", "quadratic_attenuator 1"]) slanting) (scaled 0.5 green')
    it "give nothing if there is to be no light" $
      colourIn (tracer ["reflexion_algorithm no_light"] ++ floorOf ["kd 0"] ++ waves ["position 0 0 4"]) slanting `shouldBe` nothing
    it "do not ask the angle" $ near 8 (colourIn (floorOf chalk ++ waves ["position 0 400 3"]) slanting) (scaled 0.5 green')
    it "are stopped by what is opaque, and pass unchanged through what is not" $ do
      colourIn (floorOf chalk ++ waves ["position 0 0 4"] ++ pane 2 ["kt 0"]) slanting `shouldBe` nothing
      near 8 (colourIn (floorOf chalk ++ waves ["position 0 0 4"] ++ pane 2 ["kt 0.25"]) slanting) (scaled 0.5 green')
    it "are gone where a pane lets none of their colour through" $
      colourIn (floorOf chalk ++ waves ["position 0 0 4"] ++ pane 2 ["kt 1", "color blue"]) slanting `shouldBe` nothing
    it "are none without sources" $ colourIn (floorOf chalk ++ waves ["position 0 0 4", "nb_oscillator 0"]) slanting `shouldBe` nothing
    -- Two sources 0.5 mm apart, the light straight above one of them 4 m away: the other is farther by 3.125e-8 m, less
    -- than a tenth of a wavelength
    it "interfere" $ do
      let at x = red (colourIn (floorOf chalk ++ ["linear_aperture_light", "wave_length 625", "nb_oscillator 2", "position -0.25 0 4", "position 0.25 0 4", "end"]) (ray (V3 x 0 3) (V3 0 0 (-1))))
          bright = red (colourOfWavelength 625) / 2
          ways x = (sqrt ((x + 0.25) * (x + 0.25) + 16) - sqrt ((x - 0.25) * (x - 0.25) + 16)) / 625e-9
      -- Phases of 4e7 are known to 1e-8
      for_ [0, 1e-6, 2.5e-6, 3e-6, 5e-6, 1e-5] $ \x -> abs (at x - bright * cos (pi * ways x) ^ (2 :: Int)) `shouldSatisfy` (< 1e-7)
  where
    waves properties = ["rectangular_aperture_light", "nb_oscillator 1"] ++ properties ++ ["end"]
    green' = colourOfWavelength 550
    near n (Colour r g b _) (Colour r' g' b' _) = zipWith (\x y -> abs (x - y) <= n * 2 ** (-53) * y) [r, g, b] [r', g', b'] `shouldBe` [True, True, True]

-- | A horizontal disk of radius 1/2 above the origin, white where nothing else is said.
pane :: Double -> [Text] -> [Text]
pane z = thing ("pane" <> shown z) ["disk", "position 0 0 " <> shown z, "ray 0.5", "end"]

-------------------------------------------------------------------------------
-- Shadows

shadows :: Spec
shadows = do
  it "fall behind what is opaque" $ litBehind (pane 2 []) `shouldBe` nothing
  it "fall with one shadow ray" $ shownRays (seen (sceneOf (floorOf chalk ++ lampAt 4 [] ++ pane 2 [])) slanting) `shouldBe` 2
  it "fall behind what is far away, if the light is farther" $
    colourIn (floorOf chalk ++ ["directional_light", "end"] ++ pane 1e9 []) slanting `shouldBe` nothing
  it "do not fall behind what is beside" $ litBehind (thing "beside" ["disk", "position 0 1.5 2", "end"] []) `shouldBe` white
  it "do not fall behind the light, nor at the light's own place" $
    [litBehind (pane z []) | z <- [4.5, 4, 3.999]] `shouldBe` [white, white, nothing]
  it "are the colour of what lets light through: kt times its colour" $
    litBehind (pane 2 ["kt 0.5", "color 1 0.5 0.25"]) `shouldBe` rgb 0.5 0.25 0.125
  it "are that once for a body, though the ray enters it and leaves it" $
    litBehind (ball "ball" 2 ["kt 0.5", "color 1 0.5 0.25"]) `shouldBe` rgb 0.5 0.25 0.125
  it "are the product of all that stands between" $
    litBehind (pane 1 ["kt 0.5"] ++ ball "ball" 2 ["kt 0.25", "color 1 0.5 0.25"] ++ pane 3 ["kt 0.5", "color 0.5 1 1"] ++ pane 5 ["kt 0.5"])
      `shouldBe` rgb 0.03125 0.03125 0.015625
  it "are black, where something opaque is among it, before or behind" $
    map litBehind [pane 1 ["kt 0.5"] ++ pane 2 [], pane 1 [] ++ pane 2 ["kt 0.5"]] `shouldBe` [nothing, nothing]
  it "do not bend: refraction is not asked" $
    [litBehind (ball "ball" 2 ["kt 0.5", "refractive_index " <> n]) | n <- ["1", "1.5", "9"]] `shouldBe` replicate 3 (rgb 0.5 0.5 0.5)
  it "are black, where the colours leave nothing" $ litBehind (pane 1 ["kt 1", "color red"] ++ pane 2 ["kt 1", "color blue"]) `shouldBe` nothing
  it "do not keep out ambient light" $
    colourIn (floorOf ["ka 0.5", "kd 0", "ks 0"] ++ ["ambient_light", "end"] ++ pane 2 [] ++ thing "box" ["cube", "size 20", "end"] ["ka 0"]) slanting `shouldBe` rgb 0.5 0.5 0.5
  it "fall on the inner side of what the light does not reach" $
    -- From within an opaque ball, with the lamp outside; and with the lamp inside too
    [colourIn (ball "ball" 2 chalk ++ lampAt z []) (ray (V3 0 0 2) (V3 0 0 (-1))) | z <- [4, 2.25]] `shouldBe` [nothing, white]

  describe "transmittance" $ do
    it "is clear where nothing is" $ at' 10 [] `shouldBe` (1, 1, 1)
    it "tells the product of the tints" $ at' 10 (pane 1 ["kt 0.5"] ++ pane 2 ["kt 0.25", "color 1 0.5 0"]) `shouldBe` (0.125, 0.0625, 0)
    it "ends before the bound" $ [at' bound (pane 1 ["kt 0.5"] ++ pane 2 []) | bound <- [1, 1.001, 2, 2.001]] `shouldBe` [(1, 1, 1), (0.5, 0.5, 0.5), (0.5, 0.5, 0.5), (0, 0, 0)]
    -- A shape that the ray starts upon is not met there
    it "begins after the start" $ at' 10 (pane 0 []) `shouldBe` (1, 1, 1)
    modifyMaxSuccess (* 5) $ prop "does not depend on the order of the shapes" passageHasNoOrder
  where
    litBehind text = colourIn (floorOf chalk ++ lampAt 4 [] ++ text) slanting
    at' bound text = let Transmittance r g b _ = transmittance (world Map.empty noModels (sceneOf text)) (ray 0 (V3 0 0 1)) bound in (r, g, b)

-- | A ball of radius 1/2 above the origin.
ball :: Text -> Double -> [Text] -> [Text]
ball name z = thing name ["sphere", "position 0 0 " <> shown z, "ray 0.5", "end"]

-------------------------------------------------------------------------------
-- Closed forms

-- | A camera 5 above a floor, looking straight down at a right angle: the pixel in column x and row y of 9 by 7 shows
-- the point 10 / 7 (x - 4), 10 / 7 (3 - y) of the floor.
pixels :: Spec
pixels = do
  it "are kd cos a from far away" $
    everyPixel ["directional_light", "color 1 0.5 0.25", "orientation 2 -3 -6", "end"] "diffuse" ["kd 0.75"] (const [0.75 * 6 / 7, 0.375 * 6 / 7, 0.1875 * 6 / 7])
  it "are ka more with ambient light" $
    everyPixel ["directional_light", "orientation 2 -3 -6", "end", "ambient_light", "color 0.5 1 1", "end"] "no_specular" ["kd 0.5", "ka 0.25"] (const [0.125 + 3 / 7, 0.25 + 3 / 7, 0.25 + 3 / 7])
  -- The cosine is 3 / D
  it "are 2 kd 3 / D^3 under a lamp at a height of 3 that falls off with the square" $
    everyPixel ["point_light", "position 1 2 3", "amplification 2", "constant_attenuator 0", "quadratic_attenuator 1", "end"] "diffuse" ["kd 0.5"] $ \p ->
      let away = distance p (V3 1 2 3) in replicate 3 (3 / away ^ (3 :: Int))
  it "are 3 / (D (1 + D)) under one that falls off otherwise" $
    everyPixel ["point_light", "position 1 2 3", "linear_attenuator 1", "end"] "diffuse" ["kd 1"] $ \p ->
      let away = distance p (V3 1 2 3) in replicate 3 (3 / (away * (1 + away)))
  -- The lamp at the camera: the half way is the way to it
  it "are ks (5 / D)^k in Blinn's highlight of a lamp at the camera" $
    everyPixel ["point_light", "position 0 0 5", "end"] "blinn_specular" ["ks 0.5", "shininess 30"] $ \p -> replicate 3 (0.5 * (5 / distance p eye) ** 30)
  -- The mirrored light is twice the angle away
  it "are ks (2 (5 / D)^2 - 1)^k in Phong's" $
    everyPixel ["point_light", "position 0 0 5", "end"] "phong_specular" ["ks 0.5", "shininess 3"] $ \p ->
      let c = 2 * (5 / distance p eye) ^ (2 :: Int) - 1 in replicate 3 (if c < 0 then 0 else 0.5 * c ^ (3 :: Int))
  -- The lamp at the camera's mirror image in a vertical plane: light from (x0, 0, 5), seen from the eye, and half way
  -- at x0 / 2 it is full
  it "are ks <N, H>^k for a lamp beside the camera" $
    everyPixel ["point_light", "position 4 0 5", "end"] "blinn_specular" ["ks 1", "shininess 8"] $ \p ->
      let l = towards p (V3 4 0 5); e = towards p eye; V3 _ _ hz = towards 0 (l + e) in replicate 3 (hz ^ (8 :: Int))
  it "are the sum in Blinn's model" $
    everyPixel ["point_light", "position 0 0 5", "end", "ambient_light", "color 0.5 0.5 0.5", "end"] "blinn" ["ka 0.5", "kd 0.5", "ks 0.25", "shininess 2", "color 1 0.5 0", "plasticity 0.5"] $ \p ->
      let c = 5 / distance p eye in zipWith (\kd ks -> 0.5 * kd + kd * c + ks * c * c) [0.5, 0.25, 0] [0.25, 0.1875, 0.125]
  -- A ball of radius 1 in the middle between lamp and floor: its shadow has a sharp rim where the tangent from (0, 0,
  -- 4) meets the floor
  it "are in shadow within a radius of 4 / sqrt 3 of a ball of radius 1, 2 below the lamp" $
    everyPixel (["point_light", "position 0 0 4", "end"] ++ thing "ball" ["sphere", "position 0 0 2", "end"] ["kt 0.5", "ka 0", "kd 0", "ks 0", "color 1 0 1"]) "diffuse" ["kd 1"] $ \p ->
      let away = modulus p
          -- The ball itself, from the eye 3 above its centre, hides what is within 5 tan (asin (1/3)), and is black.
          filtered'
            | away < 5 / sqrt 8 = [0, 0, 0]
            | away < 4 / sqrt 3 = [0.5, 0, 0.5]
            | otherwise = [1, 1, 1]
       in map (* (4 / distance p (V3 0 0 4))) filtered'
  where
    eye = V3 0 0 5
    towards a b = let v = b - a in v ^/ modulus v
    -- Some twenty roundings, thirty times in the highlight.
    everyPixel :: [Text] -> Text -> [Text] -> (Point -> [Double]) -> Expectation
    everyPixel light algorithm material expected = do
      let scene = sceneOf (camera ++ tracer ["reflexion_algorithm " <> algorithm, "pixel_coordinate center"] ++ floorOf material ++ light)
          found = [(x, y, c) | y <- [0 .. 6], x <- [0 .. 8], let Seen c _ = colourAt (plan Map.empty noModels scene) x y]
          at x y = V3 (10 / 7 * fromIntegral (x - 4 :: Int)) (10 / 7 * fromIntegral (3 - y :: Int)) 0
      [(x, y, c, expected (at x y)) | (x, y, c) <- found, or (zipWith (\a b -> abs (a - b) > 1e-13) (channels c) (expected (at x y)))] `shouldBe` []
    camera = ["camera", "position 0 0 5", "look_at 0 0 0", "up 0 1 0", "angle 90", "end", "viewport", "width 9", "height 7", "end"]

-------------------------------------------------------------------------------
-- Mirrors

mirrors :: Spec
mirrors = do
  -- Two mirrors face to face, with colours of their own in ambient light: A + 1/2 B + 1/4 A + ...
  it "face to face show each other, one bounce less than the level says" $
    [seen (sceneOf (facing level)) (ray (V3 0 0 0.5) (V3 0 0 (-1))) | level <- [1 .. 8]]
      `shouldBe` [Shown (Colour (sum (every 0 level)) (sum (every 1 level)) 0 1) level False | level <- [1 .. 8]]
  it "send on what comes at an angle" $ do
    -- 3-4-5, reflected at the origin, 5 away again at (-3, 0, 4)
    let seeing x = colourIn (tracer ["recursive_level 2"] ++ ["ambient_light", "end"] ++ floorOf ["ka 0", "kr 0.25"] ++ thing "mark" ["sphere", "position " <> shown (x :: Double) <> " 0 4", "ray 0.001", "end"] ["ka 1", "color 1 0.5 0.25"]) slanting
    map seeing [-3, -2.99, -3.01] `shouldBe` [rgb 0.25 0.125 0.0625, nothing, nothing]
  it "are not tinted by their colour, and what they show adds to their own" $
    colourIn (tracer ["recursive_level 2"] ++ ["ambient_light", "end"] ++ floorOf ["ka 0.5", "color 0 0 1", "kr 0.5"] ++ thing "ceiling" ["plane", "position 0 0 9", "end"] ["ka 1", "color 1 1 0.5"]) slanting
      `shouldBe` rgb 0.5 0.5 0.75
  it "do not bend light off themselves, from either side" $
    [colourIn (tracer ["recursive_level 2"] ++ ["ambient_light", "end"] ++ floorOf ["ka 0", "kr 1"] ++ thing "ceiling" ["plane", "position 0 0 " <> z, "end"] ["ka 1"]) r | (z, r) <- [("9", slanting), ("-9", ray (V3 3 0 (-4)) (V3 (-0.6) 0 0.8))]]
      `shouldBe` [white, white]
  it "show nothing of themselves at the start of the ray" $
    colourIn (tracer ["recursive_level 9"] ++ ["ambient_light", "end"] ++ floorOf ["ka 1", "kr 1"]) slanting `shouldBe` white
  it "show no farther than the far clipping plane, counted from the mirror" $
    [colourIn (["camera", "far_clipping_plane " <> far, "end"] ++ tracer ["recursive_level 2"] ++ ["ambient_light", "end"] ++ floorOf ["ka 0", "kr 1"] ++ thing "ceiling" ["plane", "position 0 0 8", "end"] ["ka 1"]) downwards | far <- ["7.9", "8.1"]]
      `shouldBe` [nothing, white]
  prop "a perfect mirror shows what the reflected ray sees" mirrorShowsWhatItFaces
  prop "a mirror with kr = 1/4 shows a quarter of it" mirrorIsWeighted
  where
    every k level = take (length (filter (\i -> i `mod` 2 == k) [0 .. level - 1])) (iterate (/ 4) (if k == 0 then 1 else 0.5))
    facing :: Int -> [Text]
    facing level = tracer ["recursive_level " <> shown level] ++ ["ambient_light", "end"] ++ floorOf ["ka 1", "kr 0.5", "color red"] ++ thing "ceiling" ["plane", "position 0 0 1", "end"] ["ka 1", "kr 0.5", "color green"]

-------------------------------------------------------------------------------
-- Transparent bodies

bodies :: Spec
bodies = do
  prop "a slab leaves rays parallel, displaced by L sin (a - b) / cos b" slabDisplaces
  -- With sin a = h / R and sin a = n sin b the ray turns by a - b on its way in and on its way out. Far from the origin
  -- a small ball's coordinates are coarser than its surface is thick, so that many a ray leaves from a point that is
  -- inside, by the numbers: the shape that is left does not count all the same
  it "a ball turns a ray by 2 (a - b), also where coordinates are coarse" $
    for_ [(1, 0), (0.001, 10000)] $ \(radius, x) ->
      for_ [0.05, 0.1 .. 0.9] $ \sine -> do
        let a = asin sine
            b = asin (sine / 1.5)
            along turn = V3 (cos turn) (negate (sin turn)) 0
            leaves = V3 x 0 0 + radius *^ (V3 (negate (cos a)) sine 0 + (2 * cos b) *^ along (a - b))
            V3 markX markY _ = leaves + 1000 *^ along (2 * (a - b))
            mark = thing "mark" ["sphere", "position " <> Text.unwords [shown markX, shown markY, "0"], "ray 0.01", "end"] ["ka 1"]
            glass = thing "glass" ["sphere", "position " <> shown x <> " 0 0", "ray " <> shown radius, "end"] (clear ++ ["refractive_index 1.5"])
        (sine, colourIn (["camera", "far_clipping_plane 10000", "end"] ++ tracer ["recursive_level 3"] ++ ["ambient_light", "end"] ++ mark ++ glass) (ray (V3 (x - 10) (radius * sine) 0) (V3 1 0 0))) `shouldBe` (sine, white)
  -- Entering: its own light c; inside: c again, through the colour times kt; outside: what lies behind, through kt once
  -- more
  it "a ball of index 1 is seen by its own light only, and what lies behind shines through" $ do
    let at level = colourIn (behind level (ball "glass" 2 ["ka 1", "kt 0.5", "color 1 0.5 0.25"])) downwards
    at 1 `shouldBe` rgb 1 0.5 0.25
    at 2 `shouldBe` rgb (1 + 0.5) (0.5 + 0.125) (0.25 + 0.03125)
    at 3 `shouldBe` rgb (1 + 0.5 + 0.25) (0.5 + 0.125 + 0.125) (0.25 + 0.03125 + 0.0625)
  it "a clear ball of index 1 cannot be seen" $
    [colourIn (behind 3 (thing "glass" ["sphere", "position 0 0 2", "end"] clear)) (ray (V3 x 0 4) (V3 0 0 (-1))) | x <- [0, 0.5, 0.99, 1.5]] `shouldBe` replicate 4 white
  it "a clear ball of index 1 does not turn a ray" $ do
    let mark = thing "mark" ["sphere", "position 3 0 -4", "ray 1e-6", "end"] ["ka 1"]
        through n = colourIn (tracer ["recursive_level 3"] ++ ["ambient_light", "end"] ++ mark ++ thing "glass" ["sphere", "position 0 0.5 0", "end"] (clear ++ ["refractive_index " <> n])) (ray (V3 (-3) 0 4) (V3 0.6 0 (-0.8)))
    map through ["1", "1.01"] `shouldBe` [white, nothing]
  it "take three levels to be looked through" $
    [shownRays (seen (sceneOf (behind level (ball "glass" 2 clear))) downwards) | level <- [1 .. 5]] `shouldBe` [1, 2, 3, 3, 3]
  it "are not looked through if they are not closed" $
    [seen (sceneOf (behind 3 (pane 2 (["kt 1", "ka 0"] <> more)))) downwards | more <- [[], ["refractive_index 1.5"]]] `shouldBe` replicate 2 (Shown nothing 1 False)

  -- In a cube of index 2, the critical angle is 30 degrees: sines of 3/5 and 4/5 are beyond
  it "add nothing where reflection is total" $ do
    let inside kr = seen (sceneOf (tracer ["recursive_level 2"] ++ ["ambient_light", "end"] ++ thing "glass" ["cube", "size 2", "end"] ["ka 0.5", "kt 1", "kr " <> kr, "refractive_index 2"] ++ sky))
        sky = thing "sky" ["plane", "position 0 0 -50", "end"] ["ka 1"]
    inside "0" (ray 0 (V3 0.6 0 (-0.8))) `shouldBe` Shown (rgb 0.5 0.5 0.5) 1 False
    -- The mirror's ray stays inside and sees the cube once more
    inside "0.5" (ray 0 (V3 0.6 0 (-0.8))) `shouldBe` Shown (rgb 0.75 0.75 0.75) 2 False
    -- Straight on, it sees the sky
    inside "0" (ray 0 (V3 0 0 (-1))) `shouldBe` Shown (rgb 1.5 1.5 1.5) 2 False
    -- Reflected, the cube again and refracted, the sky: 1/2 + 1/2 1/2 + 1
    inside "0.5" (ray 0 (V3 0 0 (-1))) `shouldBe` Shown (rgb 1.75 1.75 1.75) 3 False
  it "bend a ray that starts inside by the index there" $ do
    -- Out of index 4/3 a sine of 3/5 becomes one of 4/5: from the face at (3/4, 0, -1) to 4 away and 3 down
    let mark = thing "mark" ["sphere", "position 4.75 0 -4", "ray 1e-6", "end"] ["ka 1"]
    colourIn (tracer ["recursive_level 2"] ++ ["ambient_light", "end"] ++ mark ++ thing "glass" ["cube", "size 2", "end"] (clear ++ ["refractive_index 1.33333333333333333"])) (ray 0 (V3 0.6 0 (-0.8))) `shouldBe` white

  describe "refractive indices" $ do
    let nested = thing "a" ["sphere", "ray 3", "end"] ["kt 1", "refractive_index 1.5"] ++ thing "b" ["sphere", "ray 2", "end"] ["kt 0.25", "refractive_index 2"] ++ thing "c" ["cube", "size 2", "end"] ["refractive_index 9"] ++ thing "d" ["disk", "end"] ["kt 1", "refractive_index 7"]
        index text = refractiveIndexAt (world Map.empty noModels (sceneOf text))
    it "are 1 outside, the material's inside one, the mean inside several; 1 for what is opaque" $
      [index nested Nothing (V3 x 0 0) | x <- [4, 2.5, 1.5, 0.5]] `shouldBe` [1, 1.5, 1.75, 1.5]
    it "leave out the shape that is left, wherever the point is" $
      [index nested (Just i) 0 | i <- [0, 1, 2, 3]] `shouldBe` [1.5, 1.25, 1.75, 1.5]
    it "do not count a shape whose surface the point is on" $ map (index nested Nothing) [V3 3 0 0, V3 0 2 0, V3 1 0 0] `shouldBe` [1, 1.5, 1.75]
    it "are 1 where nothing is transparent" $ index (thing "c" ["cube", "end"] ["refractive_index 9"]) Nothing 0 `shouldBe` 1
    it "are those of the outer body, where a ray leaves the inner one" $ do
      -- Leaving the inner ball (index 4) at (0, 0, -1), straight, and the outer cube (index 4/3) at a sine of 3/5: as
      -- if from that cube alone
      let mark = thing "mark" ["sphere", "position 4.75 0 -4", "ray 1e-6", "end"] ["ka 1"]
          inner = thing "inner" ["sphere", "ray 0.5", "end"] (clear ++ ["refractive_index 4"])
          outer = thing "outer" ["cube", "size 2", "end"] (clear ++ ["refractive_index 1.33333333333333333"])
      colourIn (tracer ["recursive_level 3"] ++ ["ambient_light", "end"] ++ inner ++ outer ++ mark) (ray 0 (V3 0.6 0 (-0.8))) `shouldBe` white
  where
    clear = ["ka 0", "kd 0", "ks 0", "kt 1"]
    behind level body = tracer ["recursive_level " <> shown (level :: Int)] ++ ["ambient_light", "end"] ++ floorOf ["ka 1"] ++ body

-------------------------------------------------------------------------------
-- Pictures on surfaces

-- | A floor with a picture of three by three pixels, of which one unit square shows all: at (x, -y), in units, is the
-- pixel at trunc (2 x), trunc (2 y). The one in the middle is magenta.
textures :: Spec
textures = do
  it "stand in for the diffuse colour, kd and colour left out, where there is no light" $ do
    at (tracer ["reflexion_algorithm no_light"] ++ carpet ["texture_kd rug.png"]) 0.75 0.75 `shouldBe` magenta
    [at (tracer ["reflexion_algorithm no_light"] ++ carpet ["texture_kd rug.png"]) x y | (x, y) <- [(0.25, 0.75), (0.75, 0.25), (1, 0.75), (1.75, -1.25)]] `shouldBe` [nothing, nothing, nothing, magenta]
  for_ [("ka", "ambient"), ("kd", "diffuse"), ("ks", "blinn_specular"), ("ks", "phong_specular")] $ \(term, algorithm) ->
    it ("stand in for the colour of one term, its coefficient left out: " <> Text.unpack (term <> ", " <> algorithm)) $
      at (tracer ["reflexion_algorithm " <> algorithm] ++ carpet ["texture_" <> term <> " rug.png"] ++ light) 0.75 0.75 `shouldBe` rgb 0.5 0 0.25
  for_ [("ka", "ambient"), ("kd", "diffuse"), ("ks", "blinn_specular"), ("ks", "phong_specular")] $ \(term, algorithm) ->
    it ("leave the other terms alone: " <> Text.unpack (algorithm <> " without texture_" <> term)) $
      at (tracer ["reflexion_algorithm " <> algorithm] ++ carpet ["texture_" <> other <> " rug.png" | other <- ["ka", "kd", "ks"], other /= term] ++ light) 0.75 0.75 `shouldBe` rgb 0 0.125 0.0625
  it "leave the shininess alone" $
    -- Light and viewer 3-4-5 from the normal on one side: Blinn's cosine is 4/5, and its square
    abs (red (seeing (tracer ["reflexion_algorithm blinn_specular"] ++ carpet ["texture_ks rug.png", "shininess 2"] ++ ["point_light", "position 3.75 -0.75 4", "end"]) (ray (V3 3.75 (-0.75) 4) (V3 (-0.6) 0 (-0.8)))) - 0.64) `shouldSatisfy` (< 1e-15)
  it "do not tint what passes through, which the colour does" $
    seeing (floorOf chalk ++ lampAt 4 [] ++ thing' "texture_material" "pane" ["disk", "position 0 0 2", "ray 0.5", "end"] ["color 1 0.5 0.25", "kt 0.5", "texture_kd rug.png", "texture_ka rug.png", "texture_ks rug.png"]) slanting
      `shouldBe` rgb 0.5 0.25 0.125
  it "are not asked for if they are not there" $
    at (tracer ["reflexion_algorithm no_light"] ++ carpet ["texture_kd lost.png"]) 0.75 0.75 `shouldBe` rgb 0 0.25 0.25
  where
    seeing text = shownColour . seenWith (Map.singleton "rug.png" rug) (sceneOf text)
    at text x y = seeing text (ray (V3 x (negate y) 4) (V3 0 0 (-1)))
    carpet more = thing' "texture_material" "carpet" ["plane", "end"] (["color 0 1 1", "ka 0.25", "kd 0.25", "ks 0.25"] ++ more)
    light = ["ambient_light", "color 0.5 0.5 0.25", "end", "directional_light", "color 0.5 0.5 0.25", "orientation 0 0 -1", "end"]
    magenta = rgb 1 0 1
    rug = picture 3 (Storable.fromList (concat [if i == 4 then [255, 0, 255, 9] else [0, 0, 0, 255] | i <- [0 .. 8 :: Int]]))

-------------------------------------------------------------------------------
-- The budget

budget :: Spec
budget = do
  -- Each ray adds 1, so that the colour counts them
  it "ends mirrors that face each other after 65,536 rays, and says so" $
    seen (facing 1000000) (ray (V3 0 0 0.5) (V3 0 0 1)) `shouldBe` Shown (rgb 65536 65536 65536) 65536 True
  it "is enough for 65,536 rays, and not for one more" $ do
    seen (facing 65536) (ray (V3 0 0 0.5) (V3 0 0 1)) `shouldBe` Shown (rgb 65536 65536 65536) 65536 False
    seen (facing 65537) (ray (V3 0 0 0.5) (V3 0 0 1)) `shouldBe` Shown (rgb 65536 65536 65536) 65536 True
  it "does not count shadow rays" $
    seen (setLights [Directional white (V3 0 0 (-1)), Ambient white] (facing 65536)) (ray (V3 0 0 0.5) (V3 0 0 1))
      -- Every other ray meets the floor, which faces the light; a shadow ray each, which the ceiling stops
      `shouldBe` Shown (rgb 65536 65536 65536) (65536 + 32768) False
  it "is spent depth first, on reflection before refraction" $
    for_ [(V3 0.1 0.2 0.3, V3 0.6 0 0.8), (V3 (-0.5) 0.4 0.9, V3 0.48 0.64 (-0.6)), (V3 1.5 1.2 (-1.4), V3 (-2 / 3) (-1 / 3) (2 / 3))] $ \(o, d) -> do
      let r = ray o d
          Shown c rays cut = seen labyrinth r
          Plain expected followed shadows' cut' = plainly labyrinth r
      (rays, cut, cut', followed) `shouldBe` (followed + shadows', True, True, 65536)
      -- A sum of 65,536 terms that are not negative
      zipWith (\x y -> abs (x - y) <= 65536 * 2 ** (-52) * y && y > 0) (channels c) expected `shouldBe` [True, True, True]
  it "is for each sample anew" $ do
    (_, tally) <- renderWith 2 (pure ()) (plan Map.empty noModels (sceneOf (["viewport", "width 3", "height 2", "end", "camera", "near_clipping_plane 0.01", "end"] ++ facingText 1000000)))
    (tallyRays tally, tallyCut tally) `shouldBe` (6 * 65536, 6)
  where
    facing = sceneOf . facingText
    facingText :: Int -> [Text]
    facingText level =
      tracer ["recursive_level " <> shown level] ++ ["ambient_light", "end"]
        ++ thing "floor" ["plane", "position 0 0 -1", "end"] ["ka 1", "kd 0", "ks 0", "kr 1"]
        ++ thing "ceiling" ["plane", "position 0 0 1", "end"] ["ka 1", "kd 0", "ks 0", "kr 1"]
    -- A mirrored box with glass in it: more rays than can be followed.
    labyrinth =
      sceneOf $
        tracer ["recursive_level 60"] ++ ["ambient_light", "color 1 0.5 0.25", "end", "point_light", "position 1 1 1", "end"]
          ++ thing "walls" ["cube", "size 4", "end"] ["ka 0.25", "kr 0.75", "color 0.5 0.75 1"]
          ++ thing "ball" ["sphere", "position 0.25 0 0", "ray 0.75", "end"] ["ka 0.5", "kr 0.5", "kt 0.5", "refractive_index 1.5", "color 1 0.75 0.5"]
          ++ thing "die" ["cube", "position -1 1 0.5", "size 0.9", "end"] ["ka 0.125", "kr 0.25", "kt 0.75", "refractive_index 1.25"]

-------------------------------------------------------------------------------
-- Pictures

pictures :: Spec
pictures = do
  it "are the same by any number of workers, and on every run" $
    for_ ["center", "random"] $ \coordinate -> do
      let lit = planOf ["sampling " <> (if coordinate == "random" then "3" else "1"), "pixel_coordinate " <> coordinate]
      results <- mapM (\workers -> renderWith workers (pure ()) lit) [1, 2, 3, 8, 100]
      map fst results `shouldBe` replicate 5 (rendered lit)
      let counts = [(tallyRays t, tallyTests t, tallyCut t) | (_, t) <- results]
          Tally rays tests cut = foldMap seenTally (allPixels lit)
      counts `shouldBe` replicate 5 (rays, tests, 0)
      -- Four shapes: a shadow ray that meets something opaque leaves out the rest
      (tests, cut) `shouldSatisfy` (\(n, c) -> n <= 4 * rays && n > 3 * rays && c == 0)
      rendered (planOf ["sampling " <> (if coordinate == "random" then "3" else "1"), "pixel_coordinate " <> coordinate]) `shouldBe` rendered lit
  it "differ from seed to seed" $
    (rendered (planOf ["pixel_coordinate random", "seed 1"]) :: Picture) `shouldNotBe` rendered (planOf ["pixel_coordinate random", "seed 2"])
  it "have the mean of all samples in each pixel" $ do
    let many = planOf ["sampling 4", "pixel_coordinate center"]
        one = planOf ["pixel_coordinate center"]
    [colourOf many x y | (x, y) <- allOf] `shouldBe` [colourOf one x y | (x, y) <- allOf]
  it "show as much of an edge in each pixel as it covers" $
    -- A half plane right of x = 3.05 + 0.1 y, in pixels: in row y it covers 0.9 - 0.1 y of column 3. The mean of n
    -- samples is off by sqrt (p (1 - p) / n) in the mean of squares, and by more than 5 times that once in a million
    for_ [16, 256, 4096] $ \n -> do
      let p = edge n
          covered y = 0.9 - 0.1 * fromIntegral (y :: Int)
          off y = abs (red (colourOf p 3 y) - covered y) / sqrt (covered y * (1 - covered y) / fromIntegral n)
      map off [0 .. 7] `shouldSatisfy` all (< 5)
      sum (map ((^ (2 :: Int)) . off) [0 .. 7]) `shouldSatisfy` (> 0.5)
      [red (colourOf p x y) | y <- [0 .. 7], x <- [0, 1, 2, 4, 5, 6, 7]] `shouldBe` concat (replicate 8 [0, 0, 0, 1, 1, 1, 1])
  where
    colourOf p x y = case colourAt p x y of Seen c _ -> c
    allOf = [(x, y) | y <- [0 .. 5], x <- [0 .. 7]]
    allPixels p = [colourAt p x y | (x, y) <- allOf]
    planOf :: [Text] -> Plan
    planOf properties =
      plan Map.empty noModels . sceneOf $
        ["camera", "position -5 1 2", "look_at 0 0 0", "up 0 0 1", "angle 50", "end", "viewport", "width 8", "height 6", "end"]
          ++ tracer ("recursive_level 4" : properties)
          ++ floorOf ["kr 0.25", "color 0.5 0.75 1"]
          ++ ball "glass" 1 ["kt 0.5", "kr 0.25", "refractive_index 1.5"]
          ++ thing "cube" ["cube", "position 1 1 0.5", "end"] ["color 1 0.5 0.25", "kt 0.25", "refractive_index 1.25"]
          ++ thing "sky" ["sphere", "ray 30", "end"] ["kd 0.25"]
          ++ ["ambient_light", "color 0.5 0.5 0.5", "end", "point_light", "position -3 2 4", "end", "directional_light", "orientation 1 -1 -1", "end"]
    -- From 4 above the floor at z = 0, 8 pixels for 8 units: u = 4 + x, v = 4 - y.
    edge :: Int -> Plan
    edge n =
      plan Map.empty noModels . sceneOf $
        ["camera", "position 0 0 4", "look_at 0 0 0", "up 0 1 0", "angle 90", "end", "viewport", "width 8", "height 8", "end"]
          ++ tracer ["sampling " <> shown n, "pixel_coordinate random", "seed 7"]
          ++ thing "half" ["triangle", "point -10.55 100 0", "point 1000 0 0", "point 9.45 -100 0", "end"] ["ka 1", "kd 0", "ks 0"]
          ++ ["ambient_light", "end"]

-------------------------------------------------------------------------------
-- Laws

laws :: Spec
laws = modifyMaxSuccess (* 10) $ do
  prop "the loop sees what the plain recursion sees, with as many rays" loopIsTheRecursion
  prop "several lights give the sum of what each gives alone" lightsAddUp
  prop "the order of the lights does not matter" lightsHaveNoOrder
  prop "each algorithm gives the sum of its terms" termsAddUp
  prop "waves give the same under every algorithm" wavesDisregardTheAlgorithm
  prop "lights twice as bright give a colour twice as bright" twiceTheLightIsTwiceTheColour
  prop "a lit picture is opaque" litIsOpaque
  prop "level 1 has no bounces" levelOneHasNoBounces
  prop "each level adds, and takes nothing away" levelsAdd
  prop "the level does not matter without mirrors and glass" withoutMirrorsLevelsDoNotMatter
  prop "without lights all is black" withoutLightsAllIsBlack
  prop "ambient light asks for no other shape" ambientLightTakesNoShadowRays
  prop "no light shows the diffuse colour" noLightIsDiffuse
  it "is tried in all its corners by these laws" $
    checkCoverage $ \s -> foldr (\(name, holds) -> cover 0.5 holds name) (property True) (smallCorners s)
