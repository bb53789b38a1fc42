{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Syntax.KeywordSpec
  ( spec,
  )
where

import Data.Foldable (for_, toList)
import Data.List (sort)
import Data.Maybe (isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Syntax.Keyword
import Test.Hspec

spec :: Spec
spec = do
  describe "the original's words" $ do
    it "are 142 spellings" $ length (concat originals) `shouldBe` 142
    it "are all known" $ filter (isNothing . fromSpelling) (concat originals) `shouldBe` []
    it "are known as the same word where they were" $
      for_ originals $ \group -> (group, length (uniq (map fromSpelling group))) `shouldBe` (group, 1)
    it "are known as different words where they were" $
      -- Of these the original had two words for one thing.
      [(a, b) | (i, a : _) <- numbered, (j, b : _) <- numbered, i < j, fromSpelling a == fromSpelling b]
        `shouldBe` [("read_scene", "read_data"), ("write_scene", "write_data")]
  describe "our own words" $ do
    it "are few" $
      sort (filter (`notElem` concat originals) allSpellings) `shouldBe` sort (concat ours)
    it "are known as the same word in both languages" $
      for_ ours $ \group -> (group, length (uniq (map fromSpelling group))) `shouldBe` (group, 1)
  describe "a word" $ do
    it "is known in any case" $
      for_ allSpellings $ \s -> (s, fromSpelling (Text.toUpper s), fromSpelling (Text.toTitle s)) `shouldBe` (s, fromSpelling s, fromSpelling s)
    it "is known by each of its spellings, and written as the first" $
      for_ [minBound .. maxBound] $ \k -> do
        map fromSpelling (toList (spellings k)) `shouldBe` map (const (Just k)) (toList (spellings k))
        fromSpelling (spelling k) `shouldBe` Just k
    it "is written without capitals or blanks" $
      for_ allSpellings $ \s -> s `shouldSatisfy` Text.all (`elem` ("abcdefghijklmnopqrstuvwxyz_" :: String))
    it "is nothing else" $ map fromSpelling ["", " camera", "camera ", "cam", "ends", "mat\233riel"] `shouldBe` replicate 6 Nothing
  describe "roles" $ do
    it "are what opens an object of the scene" $
      [s | s <- allSpellings, Just k <- [fromSpelling s], role k == OpensInScene]
        `shouldBe` sort
          ( ["camera", "viewport", "raytracer", "primitive", "material", "materiel", "color_material", "blinn_material", "texture_material", "texture_materiel"]
              <> ["ambient_light", "lumiere_ambiante", "directional_light", "lumiere_directionnelle", "point_light", "lumiere_ponctuelle"]
              <> ["linear_aperture_light", "rectangular_aperture_light", "elliptical_aperture_light", "aperture_mask_light", "model"]
          )
    it "are what opens a shape" $
      [s | s <- allSpellings, Just k <- [fromSpelling s], isShape k]
        `shouldBe` sort
          ( ["sphere", "plane", "plan", "disk", "disque", "triangle", "btriangle", "tube", "cylinder", "cylindre", "cone", "cube"]
              <> ["spherical_cap", "calotte_spherique", "lens", "lentille", "torus", "tore", "geometry", "geometrie", "annulus", "anneau"]
          )
    it "are what closes" $ [s | s <- allSpellings, Just k <- [fromSpelling s], role k == Closes] `shouldBe` ["end", "fin"]
    it "are what opens a shape, as inside another object" $
      [s | s <- allSpellings, Just k <- [fromSpelling s], isShape k, role k /= OpensInside] `shouldBe` []
  where
    numbered = zip [0 :: Int ..] originals
    uniq = foldr (\x xs -> if x `elem` xs then xs else x : xs) []

-- | The table of the original's reader: a line a word, each with all its spellings.
originals :: [[Text]]
originals =
  map
    (Text.splitOn "=")
    ( Text.words
        "end=fin position look_at up=haut width=largeur height=hauteur angle near_clipping_plane far_clipping_plane camera viewport \
        \view_frustum=viewfrustum image_file_name=nom_fichier_image ray=rayon sphere name=nom primitive material_name=nom_materiel \
        \default_material color=couleur ambient_light=lumiere_ambiante blinn_material=color_material=material=materiel \
        \texture_material=texture_materiel constant_attenuator linear_attenuator quadratic_attenuator \
        \directional_light=lumiere_directionnelle orientation normal=normale plane=plan point_light=lumiere_ponctuelle ka kd ks kr kt \
        \plasticity=p refractive_index=n point triangle btriangle shininess=brillance model disk=disque tube cylinder=cylindre task \
        \sampling raytracer recursive_level reflexion_algorithm=algorithme_reflexion pixel_coordinate=coordonnee_pixel scale=homothetie \
        \rotation translation geometry=geometrie file=fichier space=espace cone read_scene write_scene log_file_name log_console log_file \
        \viewport_image_count application color_normalization uv texture_ka texture_kd texture_ks cube size=taille uv_format \
        \spherical_cap=calotte_spherique curvature=courbure lens=lentille scene model_msr texture_comparator=texture_comparateur \
        \read_data write_data console_comparator=comparateur_console wave_length=longueur_onde period_iteration linear_aperture_light \
        \nb_oscillator front=devant rectangular_aperture_light elliptical_aperture_light amplification aperture_mask_light mask=masque \
        \torus=tore major_radius minor_radius particle=particule particles_system=systeme_particules electric_charge=charge_electrique"
    )

-- | What we added.
ours :: [[Text]]
ours = [["annulus", "anneau"], ["inner_ray", "rayon_interieur"], ["seed", "graine"], ["language", "langue"]]
