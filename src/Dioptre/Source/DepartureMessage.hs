{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.DepartureMessage
-- Description : What the original does otherwise, in English and French
--
-- The texts of "Dioptre.Source.Departure": what the original program does in a place, and what this one does there.
module Dioptre.Source.DepartureMessage
  ( originally,
    here,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Departure (Departure (..))
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (counted, number, quoted, showReal)

-- | What the original program does.
originally :: Language -> Departure -> Text
originally l = \case
  HidesLines end ->
    say
      ["the original passes over everything behind this comment, ", maybe "to the end of the file" (\n -> "down to line " <> number n) end]
      ["l'original ignore tout ce qui suit ce commentaire, ", maybe "jusqu'à la fin du fichier" (\n -> "jusqu'à la ligne " <> number n) end]
  EndsScene -> say ["the original reads nothing behind this 'end'"] ["l'original ne lit rien après ce 'end'"]
  ReadsAround ->
    say
      ["the original reads the lines of this object as those of the object around it, which its 'end' then closes"]
      ["l'original lit les lignes de cet objet comme celles de l'objet qui l'entoure, que son 'end' ferme ensuite"]
  ReadsOn -> say ["the original does not take this for 'end', and leaves the object open"] ["l'original ne lit pas cela comme 'end', et laisse l'objet ouvert"]
  KeepsOpen w n ->
    say
      ["the original leaves this object open at ", quoted w, " on line ", number n, ", and reads the lines there as lines of this object"]
      ["l'original laisse cet objet ouvert devant ", quoted w, ", à la ligne ", number n, ", et lit les lignes qui suivent comme celles de cet objet"]
  StartsFromEarlier n ->
    say
      ["the original starts from the values of the one on line ", number n]
      ["l'original part des valeurs de celui de la ligne ", number n]
  LacksWord w -> say ["the original does not know the word ", quoted w] ["l'original ne connaît pas le mot ", quoted w]
  ReadsNumber t _ -> say ["the original reads ", quoted t, " as a number"] ["l'original lit ", quoted t, " comme un nombre"]
  AbandonsObject ->
    say
      ["the original abandons the object here, and reads the rest of its lines as lines of what is around it"]
      ["l'original abandonne l'objet ici, et lit le reste de ses lignes comme celles de ce qui l'entoure"]
  WritesAnywhere -> say ["the original writes its picture there"] ["l'original y écrit son image"]
  AdmitsZeroIndex -> say ["the original admits a refractive index of zero"] ["l'original admet un indice de réfraction nul"]
  AdmitsZeroScale -> say ["the original admits a scale of zero"] ["l'original admet une homothétie nulle"]
  EndsAtCurvature ->
    say
      ["the original ends with an error at a curvature below the radius"]
      ["l'original s'arrête sur une erreur quand la courbure est sous le rayon"]
  LacksLimit -> say ["the original tries, however many there are"] ["l'original essaie, quel qu'en soit le nombre"]
  NeverHits w ->
    say
      ["the original never shows ", quoted w, ": no ray meets it, and it throws no shadow"]
      ["l'original ne montre jamais ", quoted w, "\xA0: aucun rayon ne l'atteint, et il n'a pas d'ombre"]
  EndsEdgeOn w ->
    say
      ["the camera stands in the plane of ", quoted w, " or of one of its faces: the original ends with an error where a ray runs in it"]
      ["la caméra est dans le plan de ", quoted w, " ou d'une de ses faces\xA0: l'original s'arrête sur une erreur dès qu'un rayon y court"]
  EndsFarAway w ->
    say
      ["the camera is so far from ", quoted w, ", for its size, that the original may end with an error"]
      ["la caméra est si loin de ", quoted w, ", pour sa taille, que l'original peut s'arrêter sur une erreur"]
  RefusesNearPoints -> say ["the original takes these two points for one, and keeps its default"] ["l'original prend ces deux points pour un seul, et garde celui par défaut"]
  RefusesSmallTriangle ->
    say
      ["the original takes the three points of so small a triangle to be on one line, and leaves it out"]
      ["l'original voit les trois points d'un si petit triangle sur une même droite, et l'omet"]
  LeavesNormals ->
    say
      ["the original shades with normals between the corners that are shorter than 1"]
      ["l'original éclaire avec des normales plus courtes que 1 entre les sommets"]
  LeavesTexture w ->
    say
      ["the original puts no texture on ", quoted w, ", which has the plain colour there"]
      ["l'original ne met pas de texture sur ", quoted w, ", qui y a la couleur unie"]
  HalfAPixelOff ->
    say
      ["the original takes the middle of an odd size half a pixel off"]
      ["l'original place le milieu d'une taille impaire à un demi-pixel de là"]
  DrawsPart drawn whole ->
    say
      ["the original draws ", number drawn, " of the ", number whole, " pixels as 'console', and leaves the others empty"]
      ["l'original dessine ", number drawn, " des ", number whole, " pixels en mode 'console', et laisse les autres vides"]
  DrawsByChance -> say ["the original draws another picture on each run"] ["l'original dessine une autre image à chaque exécution"]
  StaysWithThreads n ->
    say
      ["the original works with ", threads n, ", and does not end by itself"]
      ["l'original travaille avec ", threads n, ", et ne se termine pas de lui-même"]
  LosesHits ->
    say
      ["with this, the original misses shapes with rays that run along an axis, and ends with an error at a 'geometry'"]
      ["avec cela, l'original manque des formes avec les rayons parallèles à un axe, et s'arrête sur une erreur à un 'geometry'"]
  EndsAtPhong w ->
    say
      ["the original ends with an error where ", quoted w, " shades a surface"]
      ["l'original s'arrête sur une erreur dès que ", quoted w, " éclaire une surface"]
  EndsAtAlpha ->
    say
      ["the original ends with an error at an alpha above 1, under 'division_factor' and 'no_light'"]
      ["l'original s'arrête sur une erreur à un alpha au-dessus de 1, avec 'division_factor' et 'no_light'"]
  LacksRayLimit _ -> say ["the original follows any number of rays for a pixel"] ["l'original suit pour un pixel n'importe quel nombre de rayons"]
  EndsAtRow -> say ["the original ends with an error at this light"] ["l'original s'arrête sur une erreur à cette lumière"]
  EndsAtAttenuation least ->
    say
      ["the original ends with an error at surfaces so near to this light that the attenuation divides by less than ", showReal least]
      ["l'original s'arrête sur une erreur aux surfaces si proches de cette lumière que l'atténuation divise par moins de ", showReal least]
  ReadsDds -> say ["the original reads dds pictures, though with errors"] ["l'original lit les images dds, mais avec des erreurs"]
  KeepsBlanks ->
    say
      ["the original looks for a file whose name ends in a blank, as it does here"]
      ["l'original cherche un fichier dont le nom finit par un blanc, comme ici"]
  WritesAs w -> say ["the original writes this object to out.txt as ", quoted w] ["l'original écrit cet objet dans out.txt comme ", quoted w]
  LeavesModelInPlace ->
    say
      ["the original transforms the flat triangles of this model only: smooth ones stay where its file has them, and other shapes vanish"]
      ["l'original ne transforme que les triangles plats de ce modèle\xA0: les triangles lisses restent où son fichier les met, et les autres formes disparaissent"]
  where
    say en fr = Text.concat (inLanguage l en fr)
    threads n = counted l n ("thread", "threads, which disturb lights of waves") ("fil", "fils, qui dérangent les lumières d'ondes")

-- | What this program does in such a place.
here :: Language -> Departure -> Text
here l = \case
  HidesLines _ -> say "a comment of one line" "un commentaire d'une ligne"
  EndsScene -> say "nothing: it is passed over, and reading goes on" "rien\xA0: il est ignoré, et la lecture continue"
  ReadsAround -> say "nothing: the object is passed over whole" "rien\xA0: l'objet est ignoré en entier"
  ReadsOn -> say "the end of the object" "la fin de l'objet"
  KeepsOpen w _ -> say ("the object as it is before " <> quoted w) ("l'objet tel qu'il est avant " <> quoted w)
  StartsFromEarlier _ -> say "the defaults, for what is not said here" "les valeurs par défaut, pour ce qui n'est pas dit ici"
  LacksWord _ -> say "what it says" "ce qu'il dit"
  ReadsNumber _ largest ->
    say ("the value before it: numbers are decimal, up to " <> showReal largest) ("la valeur précédente\xA0: les nombres sont décimaux, jusqu'à " <> showReal largest)
  AbandonsObject -> say "the object, with the colour before" "l'objet, avec la couleur précédente"
  WritesAnywhere -> say "the name before it: pictures go to the working directory" "le nom précédent\xA0: les images vont dans le répertoire courant"
  AdmitsZeroIndex -> say "the index before it" "l'indice précédent"
  AdmitsZeroScale -> say "the scale before it" "l'homothétie précédente"
  EndsAtCurvature -> say "nothing: the shape is left out" "rien\xA0: la géométrie est omise"
  LacksLimit -> say "the limit that is told here" "la limite qui est dite ici"
  NeverHits _ -> say "the shape, which is seen" "la géométrie, qui se voit"
  EndsEdgeOn _ -> say "no hit for such a ray, or that of a cube's other faces" "aucune intersection pour un tel rayon, ou celle des autres faces d'un cube"
  EndsFarAway _ -> say "the hit, as exact as it can be" "l'intersection, aussi exacte que possible"
  RefusesNearPoints -> say "both points" "les deux points"
  RefusesSmallTriangle -> say "the triangle" "le triangle"
  LeavesNormals -> say "unit normals" "des normales unitaires"
  LeavesTexture _ -> say "the texture: every shape has texture coordinates" "la texture\xA0: chaque géométrie a des coordonnées de texture"
  HalfAPixelOff -> say "the exact middle" "le milieu exact"
  DrawsPart _ _ -> say "every pixel" "chaque pixel"
  DrawsByChance -> say "the same numbers on each run, which 'seed' chooses" "les mêmes nombres à chaque exécution, que 'seed' choisit"
  StaysWithThreads _ -> say "the processors that there are, without effect on the picture" "les processeurs présents, sans effet sur l'image"
  LosesHits -> say "the picture that 'linear' defines" "l'image que définit 'linear'"
  EndsAtPhong _ -> say "Phong's illumination" "l'illumination de Phong"
  EndsAtAlpha -> say "an alpha of 1" "un alpha de 1"
  LacksRayLimit most -> say (number most <> " rays at most, and black beyond them") (number most <> " rayons au plus, et du noir au-delà")
  EndsAtRow -> say "a row of sources" "une rangée de sources"
  EndsAtAttenuation _ -> say "the light as it is, and none where it divides by zero" "la lumière telle quelle, et aucune où elle divise par zéro"
  ReadsDds -> say "nothing: dds pictures are not read" "rien\xA0: les images dds ne sont pas lues"
  KeepsBlanks -> say "the name without it" "le nom sans lui"
  WritesAs _ -> say "its own word" "son propre mot"
  LeavesModelInPlace -> say "the transformation, for everything" "la transformation, pour tout"
  where
    say = inLanguage l
