{-# LANGUAGE OverloadedStrings #-}

-- | What shading needs of a scene: finishes, lights and terms made ready.
module Dioptre.Render.StageSpec (spec) where

import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Unboxed as Unboxed
import Data.Word (Word8)
import Dioptre.Light.Attenuation
import Dioptre.Light.Colour
import Dioptre.Light.Finish hiding (pictures)
import Dioptre.Light.Light
import Dioptre.Light.Wavelength (colourOfWavelength)
import Dioptre.Math.Vector
import Dioptre.Model.Library (noModels)
import Dioptre.Picture (Picture, picture)
import Dioptre.Render.Stage
import Dioptre.Render.Surface (finishAt)
import Dioptre.Render.Texture (Texture (..), Upward (..))
import Dioptre.Render.World (worldHasMedia, worldHasPictures, worldSize)
import Dioptre.Scene.Raytracer (ReflexionAlgorithm (..))
import Laws.Shade (sceneOf)
import Linear.V3 (V3 (..))
import Test.Hspec

spec :: Spec
spec = do
  describe "termsOf" $
    it "adds up what each algorithm says" $
      map termsOf [minBound ..]
        `shouldBe` [ Nothing,
                     Just (Terms True False NoHighlight),
                     Just (Terms False True NoHighlight),
                     Just (Terms False False PhongHighlight),
                     Just (Terms False False BlinnHighlight),
                     Just (Terms True True NoHighlight),
                     Just (Terms True True PhongHighlight),
                     Just (Terms True True BlinnHighlight)
                   ]

  describe "finishes" $ do
    it "are those of their materials, shape by shape" $ do
      let finishes = finishesOf (ready (glass ++ tin ++ ball "tin" ++ ball "glass" ++ ball "tin"))
      map (plain . finishDiffuse) finishes `shouldBe` [rgb 0.5 0.5 0.5, Colour 0.25 0.125 0 0.5, rgb 0.5 0.5 0.5]
      map (plain . finishAmbient) finishes `shouldBe` [rgb 0.125 0.125 0.125, Colour 0.75 0.375 0 0.5, rgb 0.125 0.125 0.125]
      map (plain . finishSpecular) finishes `shouldBe` [rgb 0.75 0.75 0.75, rgb 0.5 0.375 0.25, rgb 0.75 0.75 0.75]
      map (shininessOf . finishColours) finishes `shouldBe` [7, 150, 7]
      map finishMirror finishes `shouldBe` [0.125, 0, 0.125]
      map finishTransparency finishes `shouldBe` [0, 0.5, 0]
      map finishTint finishes `shouldBe` [rgb 0 0 0, Colour 0.5 0.25 0 0.5, rgb 0 0 0]
      map isTransparent finishes `shouldBe` [False, True, False]
    it "have the index of their material only if something passes" $
      map finishIndex (finishesOf (ready (glass ++ tin ++ ball "tin" ++ ball "glass"))) `shouldBe` [1, 1.5]
    it "tell whether any closed shape lets light pass" $
      map (worldHasMedia . stageWorld . ready) [glass ++ tin ++ ball "tin", glass ++ ball "glass", glass ++ pane "glass", []] `shouldBe` [False, True, False, False]
    it "are of the first of materials of one name" $
      map finishMirror (finishesOf (ready (tin ++ ["material", "name tin", "kr 1", "end"] ++ ball "tin"))) `shouldBe` [0.125]
    it "have those pictures that are there, which begin with their first row" $ do
      let textured which = ["texture_material", "name t"] ++ which ++ ["end"] ++ ball "t"
          picturesOf text = [(pictured (finishAmbient f), pictured (finishDiffuse f), pictured (finishSpecular f)) | f <- finishesOf (ready text)]
          down = Just . Texture FromFirstRow
      picturesOf (textured ["texture_ka white.png", "texture_ks half.png"]) `shouldBe` [(down whitePicture, Nothing, down halfPicture)]
      picturesOf (textured ["texture_kd half.png", "texture_ks lost.png"]) `shouldBe` [(Nothing, down halfPicture, Nothing)]
      picturesOf (textured ["texture_kd lost.png"]) `shouldBe` [(Nothing, Nothing, Nothing)]
      picturesOf (tin ++ ball "tin") `shouldBe` [(Nothing, Nothing, Nothing)]
      map (worldHasPictures . stageWorld . ready) [textured ["texture_ks half.png"], textured ["texture_kd lost.png"], tin ++ ball "tin"] `shouldBe` [True, False, False]

  describe "lights" $ do
    it "stand in their order, with unit directions" $
      map told (lightsOf (["directional_light", "color 1 0.5 0.25", "orientation 0 3 -4", "end"] ++ ["ambient_light", "color red", "end"] ++ lamp "point_light" []))
        `shouldBe` [ Told "far" (rgb 1 0.5 0.25) (V3 0 0.6 (-0.8)) [],
                     Told "everywhere" (rgb 1 0 0) 0 [],
                     Told "point" (rgb 1 1 0) (V3 1 2 3) [2, 3, 4, 5]
                   ]
    it "have the colour of their wavelength, if they are waves" $
      map told (lightsOf (lamp "rectangular_aperture_light" ["wave_length 450 nm", "nb_oscillator 1"]))
        `shouldBe` [Told "waves" (colourOfWavelength 450) (V3 1 2 3) [2, 3, 4, 5]]
    it "stand in the middle of their ends, if they are a row" $ do
      let row = lightsOf ["linear_aperture_light", "position 1 2 3", "position 3 2 -1", "nb_oscillator 3", "end"]
      map told row `shouldBe` [Told "waves" (colourOfWavelength 550) (V3 2 2 1) [1, 1, 0, 0]]
      map sourcesOf row `shouldBe` [[(1, 2, 3), (2, 2, 1), (3, 2, -1)]]

  describe "openings" $ do
    -- Front along z: to the right is -x. Three by three places, 1 apart
    it "are open everywhere, if rectangular" $ sources "rectangular_aperture_light" [] `shouldBe` [(x, y, 0) | x <- [1, 0, -1], y <- [-1, 0, 1]]
    it "leave the corners out, if elliptical, and keep the rim" $
      sources "elliptical_aperture_light" [] `shouldBe` [(1, 0, 0), (0, -1, 0), (0, 0, 0), (0, 1, 0), (-1, 0, 0)]
    it "are open where the mask is white: u to the right, v upwards" $ do
      sources "aperture_mask_light" ["mask half.png"] `shouldBe` [(1, -1, 0), (1, 0, 0), (-1, 1, 0)]
      sources "aperture_mask_light" ["mask white.png"] `shouldBe` sources "rectangular_aperture_light" []
    it "are closed where a mask is almost white" $ sources "aperture_mask_light" ["mask almost.png"] `shouldBe` []
    it "are open everywhere without a mask" $
      map (sources "aperture_mask_light") [[], ["mask none"], ["mask lost.png"]] `shouldBe` replicate 3 (sources "rectangular_aperture_light" [])

  describe "everything else" $ do
    it "is what the scene says" $ do
      let s = ready ["raytracer", "recursive_level 5", "reflexion_algorithm phong", "end"]
      stageDepth s `shouldBe` 5
      stageTerms s `shouldBe` Just (Terms True True PhongHighlight)
    it "is a depth of 1 and Blinn's model in a scene that says nothing" $ do
      stageDepth (ready []) `shouldBe` 1
      stageTerms (ready []) `shouldBe` termsOf Blinn
  where
    glass = ["material", "name glass", "color 1 0.5 0 0.5", "ka 0.75", "kd 0.25", "ks 0.5", "plasticity 0.5", "kt 0.5", "refractive_index 1.5", "shininess 150", "end"]
    tin = ["material", "name tin", "ka 0.125", "kd 0.5", "ks 0.75", "kr 0.125", "refractive_index 3", "shininess 7", "end"]
    ball name = ["primitive", "material_name " <> name, "sphere", "end", "end"]
    lamp word more = [word, "color 1 1 0", "position 1 2 3", "amplification 2", "constant_attenuator 3", "linear_attenuator 4", "quadratic_attenuator 5"] ++ more ++ ["end"]
    pane name = ["primitive", "material_name " <> name, "disk", "end", "end"]
    plain (Layer c _) = c
    pictured (Layer _ p) = p
    finishesOf s = mapMaybe (finishAt (stageWorld s)) [0 .. worldSize (stageWorld s) - 1]
    ready = stage pictures noModels . sceneOf
    lightsOf = Vector.toList . stageSources . ready
    sources :: Text -> [Text] -> [(Double, Double, Double)]
    sources word more = concatMap sourcesOf (lightsOf ([word, "width 2", "height 2", "nb_oscillator 3"] ++ more ++ ["end"]))

-- | What a light is made of: its kind, colour, place or direction, and factors.
data Told = Told String Colour Vector [Double]
  deriving (Eq, Show)

told :: Source -> Told
told s = case s of
  FromEverywhere c -> Told "everywhere" c 0 []
  FromFar c d -> Told "far" c (unpacked d) []
  FromPoint c p weaker -> Told "point" c (unpacked p) (listed weaker)
  FromWaves c p weaker _ _ -> Told "waves" c (unpacked p) (listed weaker)
  where
    listed a = [amplification a, constant a, linear a, quadratic a]

sourcesOf :: Source -> [(Double, Double, Double)]
sourcesOf s = case s of
  FromWaves _ _ _ wave points | waveLength wave > 0 -> Unboxed.toList points
  _ -> []

pictures :: Map.Map Text Picture
pictures = Map.fromList [("white.png", whitePicture), ("half.png", halfPicture), ("almost.png", almostPicture)]

-- | White; three by three with a white column at the left, but for its last row, and a white pixel at the end; and one
-- level less than white.
whitePicture, halfPicture, almostPicture :: Picture
whitePicture = board ["#"]
halfPicture = board ["#..", "#..", "..#"]
almostPicture = picture 1 (Storable.fromList [255, 254, 255, 255])

board :: [Text] -> Picture
board rows = picture (maximum (map Text.length rows)) (Storable.fromList (concat [if c == '#' then replicate 4 255 else [0, 0, 0, 255 :: Word8] | row <- rows, c <- Text.unpack row]))
