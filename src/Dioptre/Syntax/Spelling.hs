{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Spelling
-- Description : Words that were mistyped
--
-- What a person who wrote an unknown word may have meant. The measure is the restricted Damerau-Levenshtein distance:
-- the number of letters put in, left out, replaced, or swapped with their neighbour.
module Dioptre.Syntax.Spelling
  ( isSlipOf,
    suggest,
    suggestWord,
    suggestName,
    synonyms,
  )
where

import Control.Applicative ((<|>))
import Data.Char (GeneralCategory (Format), generalCategory, isAlphaNum, isSpace)
import Data.List (find, sort, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Words (goesOnWithRemark)
import Text.EditDistance (defaultEditCosts, restrictedDamerauLevenshteinDistance)

-- | Whether two words differ by one slip of the finger: exactly one letter put in, left out, replaced or swapped.
--
-- >>> "edn" `isSlipOf` "end"
-- True
-- >>> "mend" `isSlipOf` "send"
-- True
-- >>> "ned" `isSlipOf` "den"
-- False
--
-- Spec: tree.slip.
isSlipOf :: Text -> Text -> Bool
isSlipOf a b = abs (Text.length a - Text.length b) <= 1 && apart a b == 1

-- | The candidate that stands in a word's quotation marks, or else the nearest, if one is near: at most one slip in
-- three letters, and not as many as it has letters. Of several the one that begins most like it, and the first of
-- those. Case does not matter. Words of more than 60 letters are nobody's slip, and of many candidates only the first
-- 300 are looked at.
--
-- >>> suggest ["sphere", "plane"] "Sphre"
-- Just "sphere"
-- >>> suggest ["blue", "bleu"] "bleue"
-- Just "bleu"
-- >>> suggest ["sphere", "plane"] "cube"
-- Nothing
-- >>> suggest ["red"] "\"Red\""
-- Just "red"
-- >>> suggest ["n", "p"] "}"
-- Nothing
--
-- Spec: check.texts.
suggest :: [Text] -> Text -> Maybe Text
suggest candidates word
  | Text.length word > 60 = Nothing
  | otherwise = quotedOne <|> listToMaybe [c | ((d, _), c) <- sortOn fst near, d <= slips]
  where
    quotedOne = if bare == word then Nothing else find ((== Text.toLower bare) . Text.toLower) (take 300 candidates)
    bare = Text.dropAround (`elem` ("\"'`\171\187\8216\8217\8220\8221" :: String)) word
    -- No letter is left of a word in which every one is a slip.
    slips = min (Text.length word - 1) (max 1 (Text.length word `div` 3))
    -- Words whose lengths differ by more are farther apart.
    alike c = Text.compareLength c (Text.length word + slips) /= GT && Text.compareLength c (Text.length word - slips) /= LT
    near = [((apart (Text.toLower word) (Text.toLower c), negate (common c)), c) | c <- filter alike (take 300 candidates)]
    common c = maybe 0 (\(same, _, _) -> Text.length same) (Text.commonPrefixes (Text.toLower word) (Text.toLower c))

-- | What may have been meant by a word that is none of these, and what follows it on its line: one of them with an
-- accent, with its parts in another order, with a blank between its parts, or with something else than a blank behind
-- it; one that means the same; or else 'suggest'.
--
-- >>> suggestWord ["point_light", "lumiere_ponctuelle"] "lumi\232re" "ponctuelle"
-- Just "lumiere_ponctuelle"
-- >>> suggestWord ["angle"] "angle=60" ""
-- Just "angle 60"
-- >>> suggestWord ["ray", "rayon"] "Radius" "2.0"
-- Just "ray"
suggestWord :: [Text] -> Text -> Text -> Maybe Text
suggestWord candidates word following
  | Text.length word > 60 = Nothing
  | otherwise = exactly plain <|> joined <|> turned <|> meant plain <|> cut <|> suggest candidates word <|> suggest candidates plain
  where
    plain = unaccented (Text.toLower word)
    exactly w = find (== w) candidates
    joined = case Text.words (Text.take 60 following) of
      next : _ -> exactly (plain <> "_" <> unaccented (Text.toLower next))
      [] -> Nothing
    parts = sort . Text.splitOn "_"
    turned = find ((== parts plain) . parts) candidates
    meant w = Map.lookup w synonyms >>= find (`elem` candidates)
    cut = case Text.span (\c -> isAlphaNum c || c == '_') word of
      (before, rest)
        | let key = unaccented (Text.toLower before), Just w <- exactly key <|> meant key, not (Text.null rest) -> Just (Text.stripEnd (w <> " " <> Text.dropWhile between rest))
      _ -> Nothing
    between c = c `elem` ("=:;,{}" :: String) || isSpace c || generalCategory c == Format

-- | What one might call the words of the language: each with those that it may stand for, the first of which that has
-- its place there is meant.
synonyms :: Map Text [Text]
synonyms =
  Map.fromList
    [ (other, words')
      | (words', others) <-
          [ -- Objects
            (["camera"], "viewer observer observateur"),
            (["position", "camera"], "eye oeil"),
            (["viewport"], "screen ecran window fenetre canvas"),
            (["image_file_name", "viewport", "texture_kd"], "image picture"),
            (["image_file_name"], "output sortie image_name nom_image"),
            (["raytracer"], "tracer renderer rendering rendu settings options parametres"),
            (["primitive"], "object objet shape forme"),
            (["material"], "mat matter"),
            (["materiel"], "matiere materiau materiaux"),
            (["point_light"], "light lamp bulb spot"),
            (["lumiere_ponctuelle"], "lumiere lampe ampoule"),
            (["directional_light"], "sun"),
            (["lumiere_directionnelle"], "soleil"),
            (["lumiere_ambiante"], "ambiante ambiance"),
            (["ambient_light", "ka"], "ambient"),
            (["model"], "mesh maillage"),
            -- Shapes
            (["sphere"], "ball globe boule balle bille"),
            (["cube"], "box cuboid boite pave"),
            (["plane"], "floor ground wall"),
            (["plan"], "sol mur"),
            (["disk"], "circle"),
            (["disque"], "cercle rond"),
            (["annulus"], "ring"),
            (["anneau"], "bague couronne"),
            (["tube"], "pipe tuyau"),
            (["torus"], "donut doughnut"),
            (["tore"], "beignet"),
            (["spherical_cap"], "cap dome"),
            (["calotte_spherique"], "calotte coupole"),
            (["geometry"], "transform transformation group groupe"),
            -- Properties
            (["position"], "center centre origin origine location place pos"),
            (["look_at"], "target look cible regarde vise"),
            (["look_at", "orientation", "front", "normal"], "direction"),
            (["up"], "sky"),
            (["angle"], "fov field_of_view zoom champ"),
            (["near_clipping_plane"], "near proche"),
            (["far_clipping_plane"], "far loin"),
            (["ray"], "radius"),
            (["inner_ray"], "inner_radius"),
            (["rayon_interieur"], "rayon_interne"),
            (["major_radius"], "rayon_majeur grand_rayon"),
            (["minor_radius"], "rayon_mineur petit_rayon"),
            (["size"], "side edge"),
            (["taille"], "cote arete"),
            (["point"], "vertex corner coin sommet"),
            (["rotation"], "rotate turn tourne tourner"),
            (["translation"], "translate move deplacement"),
            (["scale"], "scaling resize"),
            (["homothetie"], "echelle"),
            (["file"], "path filename"),
            (["texture_kd"], "texture"),
            (["color"], "rgb rgba"),
            (["couleur"], "rvb teinte"),
            (["kd"], "diffuse diffus diffusion"),
            (["ks"], "specular speculaire"),
            (["kr", "reflexion_algorithm"], "reflection reflexion reflectivity reflectance mirror miroir"),
            (["kt"], "transparency transparent transparence transmission"),
            (["refractive_index"], "index ior indice refraction indice_refraction"),
            (["plasticity"], "plastic plastique plasticite"),
            (["shininess"], "shiny gloss specular_exponent"),
            (["brillance"], "brillant"),
            (["amplification"], "intensity intensite brightness luminosite power puissance"),
            (["wave_length"], "lambda"),
            (["sampling"], "samples antialiasing echantillonnage echantillons"),
            (["recursive_level"], "depth recursion profondeur"),
            (["reflexion_algorithm"], "algorithm algorithme shading ombrage"),
            (["graine"], "germe"),
            (["task"], "tasks threads taches")
          ],
        other <- Text.words others
    ]

-- | A word in lower case without the accents of French.
unaccented :: Text -> Text
unaccented = Text.map (\c -> fromMaybe c (lookup c accents))
  where
    accents = zip "\224\226\228\231\232\233\234\235\238\239\244\246\249\251\252" "aaaceeeeiioouuu"

-- | The name that may have been meant by a name: one that is the same but for case and blanks at the end; or one that
-- goes on, or stops, where a remark begins; or else 'suggest', with its bounds.
--
-- >>> suggestName ["th\233", "caf\233  "] "CAF\201"
-- Just "caf\233  "
-- >>> suggestName ["paint # the wall's"] "paint"
-- Just "paint # the wall's"
suggestName :: [Text] -> Text -> Maybe Text
suggestName candidates name
  | Text.compareLength name 60 == GT = remark
  | otherwise = find ((== bare name) . bare) (filter short (take 300 candidates)) <|> remark <|> suggest candidates name
  where
    remark = find (\c -> c `goesOnWithRemark` name || name `goesOnWithRemark` c) (take 300 candidates)
    bare = Text.toCaseFold . Text.stripEnd
    short c = Text.compareLength c 100 /= GT

apart :: Text -> Text -> Int
apart a b = restrictedDamerauLevenshteinDistance defaultEditCosts (Text.unpack a) (Text.unpack b)
