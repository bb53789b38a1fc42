{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Message
-- Description : What diagnostics say, in English and French
--
-- The texts of "Dioptre.Source.Diagnostic", and nothing else: what is wrong, what was expected, what is used instead.
-- Each text stands beside its translation.
module Dioptre.Source.Message
  ( message,
    expected,
    used,
    severityName,
    expectation,
    pictureFault,
  )
where

import Data.Char (GeneralCategory (..), generalCategory, isDigit, ord, toUpper)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.DepartureMessage (here, originally)
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (brief, counted, number, quoted, showReal)
import Dioptre.Source.Words (beginsRemark, goesOnWithRemark)
import Numeric (showHex)

-- | The name of a severity.
severityName :: Language -> Severity -> Text
severityName l = \case
  Note -> inLanguage l "note" "remarque"
  Warning -> inLanguage l "warning" "avertissement"
  Error -> inLanguage l "error" "erreur"

-- | What is wrong.
--
-- Spec: check.texts.
message :: Language -> Problem -> Text
message l = \case
  UnknownWord w _ guess _ ->
    say ["unknown word ", quoted w, strange w, meant guess] ["mot inconnu\xA0: ", quoted w, strange w, meant guess]
  MisplacedWord w object _ _ ->
    say
      [quoted w, maybe " cannot stand here" (\o -> " is not a word of " <> quoted o) object]
      [quoted w, maybe " n'a pas sa place ici" (\o -> " ne fait pas partie de " <> quoted o) object]
  StrayEnd w ->
    say [quoted w, " where nothing is open"] [quoted w, " alors que rien n'est ouvert"]
  MisspeltEnd w ->
    say [quoted w, " is taken for 'end'"] [quoted w, " est lu comme 'end'"]
  MissingEnd object by ->
    say
      [quoted object, " is never closed", maybe "" (\(w, n) -> "; " <> quoted w <> " on line " <> number n <> " closes it") by]
      [quoted object, " n'est jamais fermé", maybe "" (\(w, n) -> "\xA0; " <> quoted w <> ", à la ligne " <> number n <> ", le ferme") by]
  UnclosedComment ->
    say
      ["this comment is never closed: a line that begins with '*/' would close it"]
      ["ce commentaire n'est jamais fermé\xA0: une ligne qui commence par '*/' le fermerait"]
  BehindOpening object w ->
    say
      [quoted w, " is not read behind ", quoted object, ": a property has a line of its own"]
      [quoted w, " n'est pas lu derrière ", quoted object, "\xA0: une propriété a sa propre ligne"]
  RefusedValue _ (NoSuchChoice t _) (AColour _) _
    | Text.any isDigit (Text.take 2 t) ->
      say
        [quoted t, " is the name of no colour; a colour in numbers takes three of them, or four"]
        [quoted t, " n'est le nom d'aucune couleur\xA0; en nombres, une couleur en prend trois ou quatre"]
  RefusedValue w refusal _ _ -> refused l w refusal
  RepeatedProperty w n ->
    say [quoted w, " is given more than ", times n] [quoted w, " est donné plus de ", times n]
  SecondShape object ->
    say [quoted object, " has a shape already"] [quoted object, " a déjà une géométrie"]
  ImpossibleObject object flaw _ -> flawed l object flaw
  DecimalComma w t ->
    say
      [quoted w, " is read as ", t, ", up to the comma: decimals follow a point"]
      [quoted w, " est lu comme ", t, ", jusqu'à la virgule\xA0: les décimales suivent un point"]
  NoMaterialName ->
    say ["this primitive names no material"] ["cette primitive ne nomme pas de matériel"]
  MissingMaterial name guess ->
    say
      ["no material is called ", withBlanks l name, maybe "" (\g -> "; did you mean " <> withBlanks l g <> "?" <> wholeLine name g) guess]
      ["aucun matériel ne s'appelle ", withBlanks l name, maybe "" (\g -> "\xA0; vouliez-vous dire " <> withBlanks l g <> "\xA0?" <> wholeLine name g) guess]
  RepeatedMaterial name n ->
    say
      ["a material is called ", quoted name, " already, on line ", number n]
      ["un matériel s'appelle déjà ", quoted name, ", à la ligne ", number n]
  ReplacedObject object n ->
    say
      [quoted object, " replaces the one on line ", number n]
      [quoted object, " prend la place de l'objet de la ligne ", number n]
  NoModelFile ->
    say ["this model names no file"] ["ce modèle ne nomme pas de fichier"]
  UnknownModelFormat name ->
    say
      ["no format of models is known by the ending of ", quoted name]
      ["aucun format de modèle n'est connu sous l'extension de ", quoted name]
  EmptyModel name ->
    say
      ["there is no shape in ", quoted name]
      ["il n'y a aucune géométrie dans ", quoted name]
  ModelCycle files ->
    say
      ["this model would hold itself: ", chain files]
      ["ce modèle se contiendrait lui-même\xA0: ", chain files]
  ModelTooDeep name n ->
    say
      [quoted name, " would make models in models more than ", number n, " deep"]
      [quoted name, " mettrait des modèles dans des modèles sur plus de ", number n, " niveaux"]
  TooManyParts name n ->
    say
      ["with ", quoted name, " there would be more than ", number n, " shapes to draw"]
      ["avec ", quoted name, ", il y aurait plus de ", number n, " géométries à dessiner"]
  DifferingUvFormat name first ->
    say
      [quoted name, " has 'uv_format ", first, "' already: that of the first model that names it"]
      [quoted name, " a déjà 'uv_format ", first, "'\xA0: celui du premier modèle qui le nomme"]
  BrokenCurve flaw -> brokenCurve l flaw
  PiecesWithoutLength n ->
    counted l n ("piece of a curve ends", "pieces of curves end") ("morceau de courbe finit", "morceaux de courbe finissent")
      <> inLanguage l " in the point where it starts; here is the first" " au point de départ\xA0; voici le premier"
  BadCoordinates what refusal -> refused l (lineWord what) refusal
  BadFace flaw -> badFace l flaw
  MissingVertex index count ->
    say
      ["there is no vertex ", index, ": ", before count]
      ["il n'y a pas de sommet ", index, "\xA0: ", before count]
  MissingAttribute a index count ->
    say
      ["there is no ", attribute a, " ", index, ": ", before count]
      ["il n'y a pas de ", attribute a, " ", index, "\xA0: ", before count]
  NoAttributes a n ->
    counted l n ("face names a ", "faces name a ") ("face nomme une ", "faces nomment une ") <> attribute a
      <> inLanguage l " where none stands before; here is the first" " alors qu'aucune ne précède\xA0; voici la première"
  CollinearTriangles n ->
    counted l n ("triangle has its", "triangles have their") ("triangle a ses", "triangles ont leurs")
      <> inLanguage l " corners on one line; here is the first" " sommets sur une même droite\xA0; voici le premier"
  LongLine n ->
    say
      ["this line has more than ", number n, " bytes, or goes on in very many others"]
      ["cette ligne a plus de ", number n, " octets, ou continue sur un très grand nombre d'autres"]
  TooManyLibraries n ->
    say
      ["this model names more than ", number n, " material libraries"]
      ["ce modèle nomme plus de ", number n, " librairies de matériaux"]
  UnknownMaterialOfModel name ->
    say
      ["no material library of this model has ", quoted name]
      ["aucune librairie de matériaux de ce modèle n'a ", quoted name]
  MoreFaults n ->
    counted
      l
      n
      ("more fault is in this file: this one", "more faults are in this file, from here on")
      ("autre faute dans ce fichier\xA0: celle-ci", "autres fautes dans ce fichier, à partir d'ici")
  UnusableFile name _ trouble -> case trouble of
    NoSuchFile folders guess ->
      say
        ["no file is called ", quoted name, " in ", Text.intercalate ", " (map folderName folders), meant guess]
        ["aucun fichier ne s'appelle ", quoted name, foldMap ((", ni dans " <>) . folderName) folders, meant guess]
    SeveralFiles paths ->
      say
        ["several files are called ", quoted name, ": ", folderList paths]
        ["plusieurs fichiers s'appellent ", quoted name, "\xA0: ", folderList paths]
    Unreadable complaint ->
      say [quoted name, " cannot be read: ", complaint] [quoted name, " ne peut pas être lu\xA0: ", complaint]
    Undecodable fault -> quoted name <> inLanguage l ": " "\xA0: " <> pictureFault l fault
  SamplingWithoutRandom n ->
    say
      ["the ", number n, " rays of a pixel all go through the same point of it, as 'pixel_coordinate' is not 'random': this takes time and changes nothing"]
      ["les ", number n, " rayons d'un pixel passent tous par le même point, car 'pixel_coordinate' n'est pas 'random'\xA0: cela prend du temps et ne change rien"]
  Departs departure -> originally l departure
  where
    say en fr = Text.concat (inLanguage l en fr)
    meant = maybe "" (\w -> inLanguage l "; did you mean " "\xA0; vouliez-vous dire " <> quoted w <> inLanguage l "?" "\xA0?")
    strange = maybe "" (inLanguage l ", which holds " ", qui contient " <>) . oddity l
    wholeLine a b
      | a `goesOnWithRemark` b || b `goesOnWithRemark` a = inLanguage l " A name is all that stands up to the end of its line" " Un nom est tout ce qui vient jusqu'à la fin de sa ligne"
      | otherwise = ""
    folderName folder
      | folder == "." = inLanguage l "the working directory" "le répertoire courant"
      | folder == "./..." = inLanguage l "any folder below" "un dossier plus bas"
      | otherwise = Text.pack folder
    folderList = Text.intercalate ", " . map Text.pack
    chain = Text.intercalate " > " . map Text.pack
    before n = counted l n ("stands", "stand") ("précède", "précèdent") <> inLanguage l " before this line" " cette ligne"
    times n = inLanguage l (if n == 1 then "once" else number n <> " times") (number n <> " fois")
    attribute = \case
      TextureCoordinate -> inLanguage l "texture coordinate" "coordonnée de texture"
      Normal -> inLanguage l "normal" "normale"

-- | The word that begins a line of such numbers.
lineWord :: Coordinates -> Text
lineWord = \case
  OfVertex -> "v"
  OfAttribute TextureCoordinate -> "vt"
  OfAttribute Normal -> "vn"

badFace :: Language -> FaceFlaw -> Text
badFace l = \case
  NotACorner t -> say [quoted t, " is not a corner of a face"] [quoted t, " n'est pas un sommet de face"]
  OtherForm t first ->
    say
      [quoted t, " has other parts than the first corner, ", quoted first]
      [quoted t, " n'a pas les mêmes parties que le premier sommet, ", quoted first]
  TooFewCorners n ->
    inLanguage l "a face with " "une face à " <> counted l n ("corner", "corners") ("sommet", "sommets")
  where
    say en fr = Text.concat (inLanguage l en fr)

brokenCurve :: Language -> CurveFlaw -> Text
brokenCurve l = \case
  RowsMissing n ->
    say
      ["a curve has three rows of numbers (x, y, z), of which ", number n, if n == 1 then " is missing" else " are missing"]
      ["une courbe a trois lignes de nombres (x, y, z), dont il manque ", number n]
  RowsDiffer found wanted ->
    counted l found ("number", "numbers") ("nombre", "nombres") <> inLanguage l ", where the row of x has " ", où la ligne de x en a " <> number wanted
  RowRefused refusal -> refused l "" refusal
  where
    say en fr = Text.concat (inLanguage l en fr)

refused :: Language -> Text -> Refusal -> Text
refused l w = \case
  NothingThere -> say [quoted w, " has no value"] [quoted w, " n'a pas de valeur"]
  NotANumber t -> say [quoted t, " is not a number", signs t] [quoted t, " n'est pas un nombre", signs t]
  NotAnInteger t -> say [quoted t, " is not an integer", signs t] [quoted t, " n'est pas un entier", signs t]
  TooLarge t -> say [quoted t, " is too large"] [quoted t, " est trop grand"]
  OutOfRange t -> say [quoted t, " is out of range for ", quoted w] [quoted t, " est hors des limites de ", quoted w]
  WrongCount wanted found guess ->
    say
      [counted l found ("value", "values") ("valeur", "valeurs"), ", where ", quoted w, " takes ", number wanted, guessed guess]
      [counted l found ("value", "values") ("valeur", "valeurs"), ", où ", quoted w, " en prend ", number wanted, guessed guess]
  NameAmongNumbers t guess ->
    say
      [quoted t, " names a colour, behind which stands nothing but an alpha", guessed guess]
      [quoted t, " nomme une couleur, derrière laquelle ne vient rien qu'un alpha", guessed guess]
  NoSuchChoice t guess ->
    say
      [quoted t, " means nothing to ", quoted w, maybe "" (\g -> "; did you mean " <> quoted g <> "?") guess, signs t]
      [quoted t, " ne dit rien à ", quoted w, maybe "" (\g -> "\xA0; vouliez-vous dire " <> quoted g <> "\xA0?") guess, signs t]
  UnsafeName ->
    say
      ["a name here holds no '/', '\\' or control character: the file goes to the working directory"]
      ["ce nom ne peut contenir ni '/', ni '\\', ni caractère de contrôle\xA0: le fichier va dans le répertoire courant"]
  NameTaken ->
    say
      ["this is the name of another file of this run, which would be lost"]
      ["c'est le nom d'un autre fichier de cette exécution, qui serait perdu"]
  WrongEnding -> say ["this name has another ending"] ["ce nom a une autre extension"]
  ZeroVector -> say [quoted w, " needs a direction: this vector is zero"] [quoted w, " doit avoir une direction\xA0: ce vecteur est nul"]
  ZeroComponent -> say ["a scale of zero flattens the shape"] ["une homothétie nulle aplatit la géométrie"]
  SamePoint -> say ["this is the point given before"] ["c'est le point déjà donné"]
  where
    say en fr = Text.concat (inLanguage l en fr)
    guessed = \case
      NoGuess -> ""
      CommentBehind -> ownLine (inLanguage l "a comment" "un commentaire")
      EndBehind t -> ownLine (quoted t)
      CommaInNumber -> inLanguage l "; a comma separates values, decimals follow a point" "\xA0; une virgule sépare des valeurs, les décimales suivent un point"
      SignsAround -> withoutSigns
    -- What may be wrong with what is no number, or no such word.
    signs t = case oddity l t of
      Just o -> inLanguage l "; it holds " "\xA0; il contient " <> o
      Nothing
        | beginsRemark t -> guessed CommentBehind
        | Text.toLower t `elem` ["end", "fin"] -> guessed (EndBehind t)
        | Text.any (`elem` ("=:;" :: String)) t -> withoutSigns
        | beginsNumber t, Text.any (`elem` ("\xB0\xBA" :: String)) t -> inLanguage l "; angles are in degrees, without '\xB0'" "\xA0; les angles sont en degrés, sans '\xB0'"
        | beginsNumber t, Text.any (== '%') t -> inLanguage l "; numbers have no '%': 20% is 0.2" "\xA0; les nombres n'ont pas de '%'\xA0: 20% s'écrit 0.2"
        | otherwise -> ""
    beginsNumber = Text.any (\c -> isDigit c || c `elem` ("+-." :: String)) . Text.take 1
    ownLine what = inLanguage l "; " "\xA0; " <> what <> inLanguage l " needs a line of its own" " doit avoir sa propre ligne"
    withoutSigns = inLanguage l "; values follow their word, without '=', ':' or ';'" "\xA0; les valeurs suivent leur mot, sans '=', ':' ni ';'"

flawed :: Language -> Text -> Flaw -> Text
flawed l object = \case
  WithoutShape -> say "has no shape" "n'a pas de géométrie"
  ZeroSize -> say "has no extent" "n'a pas d'étendue"
  ZeroNormal _ -> say "has a normal of length zero" "a une normale de longueur nulle"
  NowhereToLook -> say "looks at its own position" "regarde sa propre position"
  UpAlongFront -> say "has its up along the direction of view" "a son 'up' dans la direction du regard"
  FarBeforeNear -> say "has its far clipping plane before the near one" "a son plan éloigné devant son plan rapproché"
  CollinearPoints -> say "has its three points on one line" "a ses trois points sur une même droite"
  EqualPoints -> say "has its two points in one place" "a ses deux points au même endroit"
  InnerBeyondOuter -> say "has an inner radius greater than the outer one" "a un rayon intérieur plus grand que le rayon"
  CurvatureBelowRadius -> say "has a radius of curvature smaller than its radius" "a un rayon de courbure plus petit que son rayon"
  LensTooThin -> say "is so thin that its faces cross" "est si mince que ses faces se croisent"
  ZeroOrientation _ -> say "has an orientation of length zero" "a une orientation de longueur nulle"
  NoAttenuation -> say "has all three attenuators zero" "a ses trois atténuateurs nuls"
  InvisibleWavelength low high ->
    say
      ("has a wavelength that is not visible (" <> brief low <> " to " <> brief high <> " nm)")
      ("a une longueur d'onde invisible (hors de " <> brief low <> " à " <> brief high <> " nm)")
  TooManyOscillators n -> say ("has more than " <> number n <> " sources") ("a plus de " <> number n <> " sources")
  TooManyPixels n -> say ("has more than " <> number n <> " pixels") ("a plus de " <> number n <> " pixels")
  where
    say en fr = quoted object <> " " <> inLanguage l en fr

-- | A name in quotation marks; blanks at its end, which are not seen, are counted.
withBlanks :: Language -> Text -> Text
withBlanks l t = quoted t <> if blanks == 0 then "" else inLanguage l " with " " avec " <> counted l blanks ("blank", "blanks") ("blanc", "blancs") <> inLanguage l " at its end" " à la fin"
  where
    blanks = Text.length t - Text.length (Text.stripEnd t)

-- | What in a word is not what it looks like, or is not seen at all: the first such character.
oddity :: Language -> Text -> Maybe Text
oddity l t
  | Text.any (== '\0') t = Just (inLanguage l "NUL characters, as UTF-16 has them: save the file as UTF-8" "des caractères NUL, comme en UTF-16\xA0: enregistrez le fichier en UTF-8")
  | otherwise = case [(c, en, fr) | c <- Text.unpack t, Just (en, fr) <- [named c]] of
    (c, en, fr) : _ -> Just (inLanguage l en fr <> " (U+" <> Text.justifyRight 4 '0' (Text.pack (map toUpper (showHex (ord c) ""))) <> ")")
    [] -> Nothing
  where
    named c
      | c == '-' || c == ' ' = Nothing
      | c == '\x2212' = Just ("a minus sign that is not '-'", "un signe moins qui n'est pas '-'")
      | c `elem` ("\xA0\x2007\x202F" :: String) = Just ("a no-break space", "une espace insécable")
      | otherwise = case generalCategory c of
        DashPunctuation -> Just ("a dash that is not '-'", "un tiret qui n'est pas '-'")
        Space -> Just ("a space that is not the usual one", "une espace qui n'est pas l'espace ordinaire")
        Format -> Just ("an invisible character", "un caractère invisible")
        Control -> Just ("a control character", "un caractère de contrôle")
        _ -> Nothing

-- | Why a file is no picture.
pictureFault :: Language -> PictureFault -> Text
pictureFault l = \case
  NoPicture -> say "this is no png, jpg, gif, bmp or tga picture" "ce n'est pas une image png, jpg, gif, bmp ou tga"
  ClaimsPixels n -> say ("this picture would have " <> number n <> " pixels, too many for its file or for any") ("cette image aurait " <> number n <> " pixels, trop pour son fichier ou pour tout autre")
  FewerPixels -> say "this picture has fewer pixels than it says" "cette image a moins de pixels qu'elle ne le dit"
  NoHeader -> say "this picture does not say what its pixels are" "cette image ne dit pas ce que sont ses pixels"
  CutOff -> say "this picture is cut off" "cette image est tronquée"
  NoImage -> say "there is no image in this file" "il n'y a pas d'image dans ce fichier"
  LongCodes -> say "the codes of this picture have more bits than GIF has" "les codes de cette image ont plus de bits que GIF n'en a"
  TooMuchMemory -> say "decoding this picture takes too much memory" "décoder cette image prend trop de mémoire"
  Damaged -> say "this picture is damaged, or of a kind that is not read" "cette image est abîmée, ou d'une sorte qui n'est pas lue"
  where
    say = inLanguage l

-- | What was expected, where that can be said.
--
-- Spec: check.texts.
expected :: Language -> Problem -> Maybe Text
expected l = \case
  UnknownWord _ admissible _ _ -> Just (oneOf l admissible)
  MisplacedWord _ _ admissible _ -> Just (oneOf l admissible)
  StrayEnd _ -> Nothing
  MisspeltEnd _ -> Just "'end'"
  MissingEnd _ _ -> Just "'end'"
  UnclosedComment -> Just "'*/'"
  BehindOpening object _ -> Just (inLanguage l ("the end of the line, and the properties of " <> quoted object <> " below it") ("la fin de la ligne, et les propriétés de " <> quoted object <> " en dessous"))
  RefusedValue _ _ wanted _ -> Just (expectation l wanted)
  RepeatedProperty {} -> Nothing
  SecondShape _ -> Just (inLanguage l "one shape" "une seule géométrie")
  ImpossibleObject _ flaw _ -> flawExpected l flaw
  DecimalComma {} -> Just (inLanguage l "a decimal point" "un point décimal")
  NoMaterialName -> Just "'material_name'"
  MissingMaterial {} -> Just (inLanguage l "the name of a material of this scene" "le nom d'un matériel de cette scène")
  RepeatedMaterial {} -> Just (inLanguage l "another name" "un autre nom")
  ReplacedObject {} -> Nothing
  NoModelFile -> Just (inLanguage l "'file', and the name of an obj, msr or agp file" "'file', et le nom d'un fichier obj, msr ou agp")
  UnknownModelFormat _ -> Just (inLanguage l "a name that ends in .obj, .msr or .agp" "un nom qui finit par .obj, .msr ou .agp")
  EmptyModel _ -> Just (inLanguage l "a file with shapes, triangles or models, in the format that its ending says" "un fichier avec des géométries, des triangles ou des modèles, dans le format que dit son extension")
  ModelCycle _ -> Just (inLanguage l "a model that does not lead back to its own file" "un modèle qui ne ramène pas à son propre fichier")
  ModelTooDeep {} -> Nothing
  TooManyParts {} -> Nothing
  DifferingUvFormat {} -> Just (inLanguage l "one 'uv_format' for a file" "un seul 'uv_format' pour un fichier")
  BrokenCurve _ -> Just (inLanguage l "three lines of equally many real numbers: x, y and z" "trois lignes d'autant de nombres réels\xA0: x, y et z")
  PiecesWithoutLength _ -> Nothing
  BadCoordinates what _ -> Just $ case what of
    OfVertex -> threeNumbers
    OfAttribute TextureCoordinate -> inLanguage l "one to three real numbers" "de un à trois nombres réels"
    OfAttribute Normal -> threeNumbers
  BadFace flaw -> Just $ case flaw of
    NotACorner _ -> inLanguage l "i, i/t, i//n or i/t/n: integers, counted from 1, or from -1 backwards" "i, i/t, i//n ou i/t/n\xA0: des entiers, à partir de 1, ou de -1 à rebours"
    OtherForm {} -> inLanguage l "corners of one form" "des sommets d'une même forme"
    TooFewCorners _ -> inLanguage l "three corners or more" "trois sommets ou plus"
  MissingVertex _ count -> Just (indices count)
  MissingAttribute _ _ count -> Just (indices count)
  NoAttributes {} -> Nothing
  CollinearTriangles _ -> Nothing
  LongLine _ -> Nothing
  TooManyLibraries _ -> Nothing
  UnknownMaterialOfModel _ -> Just (inLanguage l "the name of a 'newmtl' in a library that 'mtllib' names" "le nom d'un 'newmtl' dans une librairie que 'mtllib' nomme")
  MoreFaults _ -> Nothing
  UnusableFile _ use _ -> Just $ case use of
    ForModel -> inLanguage l "one obj, msr or agp file of that name" "un seul fichier obj, msr ou agp de ce nom"
    ForMaterialLibrary -> inLanguage l "one mtl file of that name" "un seul fichier mtl de ce nom"
    _ -> inLanguage l "one picture (png, jpg, gif, bmp or tga) of that name" "une seule image (png, jpg, gif, bmp ou tga) de ce nom"
  SamplingWithoutRandom _ -> Just (inLanguage l "'pixel_coordinate random', or 'sampling 1'" "'pixel_coordinate random', ou 'sampling 1'")
  Departs _ -> Nothing
  where
    threeNumbers = inLanguage l "three real numbers" "trois nombres réels"
    indices count
      | count == 0 = inLanguage l "its line before the faces that use it" "sa ligne avant les faces qui l'utilisent"
      | otherwise = inLanguage l ("1 to " <> number count <> ", or -1 to -" <> number count) ("1 à " <> number count <> ", ou -1 à -" <> number count)

flawExpected :: Language -> Flaw -> Maybe Text
flawExpected l = \case
  WithoutShape -> say "one shape, such as a sphere" "une géométrie, par exemple une sphère"
  ZeroSize -> say "a size greater than zero" "une taille plus grande que zéro"
  ZeroNormal least -> say ("a normal at least " <> showReal least <> " long") ("une normale de longueur " <> showReal least <> " ou plus")
  NowhereToLook -> say "'look_at' away from 'position'" "un 'look_at' autre que 'position'"
  UpAlongFront -> say "an 'up' across the direction of view" "un 'up' qui n'est pas dans la direction du regard"
  FarBeforeNear -> say "'far_clipping_plane' at least 'near_clipping_plane'" "un 'far_clipping_plane' d'au moins 'near_clipping_plane'"
  CollinearPoints -> say "three points that are not on one line" "trois points qui ne sont pas sur une même droite"
  EqualPoints -> say "two different points" "deux points différents"
  InnerBeyondOuter -> say "'inner_ray' from 0 to 'ray'" "un 'inner_ray' de 0 à 'ray'"
  CurvatureBelowRadius -> say "a curvature of at least 'ray' (its sign aside)" "une courbure d'au moins 'ray' (au signe près)"
  LensTooThin -> say "a thicker lens, or flatter faces" "une lentille plus épaisse, ou des faces plus plates"
  ZeroOrientation least -> say ("an orientation at least " <> showReal least <> " long") ("une orientation de longueur " <> showReal least <> " ou plus")
  NoAttenuation -> say "one attenuator greater than zero" "un atténuateur plus grand que zéro"
  InvisibleWavelength low high ->
    say ("'wave_length' from " <> brief low <> " to " <> brief high) ("un 'wave_length' de " <> brief low <> " à " <> brief high)
  TooManyOscillators _ -> say "a smaller 'nb_oscillator', or a less narrow aperture" "un 'nb_oscillator' plus petit, ou une ouverture moins étroite"
  TooManyPixels _ -> say "a smaller 'width' or 'height'" "un 'width' ou un 'height' plus petit"
  where
    say en fr = Just (inLanguage l en fr)

-- | What is used instead, where something is.
--
-- Spec: check.texts.
used :: Language -> Problem -> Maybe Text
used l = \case
  UnknownWord _ _ _ passed -> Just (passedOver passed)
  MisplacedWord _ _ _ passed -> Just (passedOver passed)
  StrayEnd _ -> say "nothing: it is passed over" "rien\xA0: il est ignoré"
  MisspeltEnd _ -> Just "end"
  MissingEnd _ _ -> say "what was read of it" "ce qui en a été lu"
  BehindOpening {} -> say "nothing: the rest of the line is passed over" "rien\xA0: le reste de la ligne est ignoré"
  UnclosedComment -> say "nothing: the rest of the file is passed over" "rien\xA0: le reste du fichier est ignoré"
  RefusedValue _ _ _ TheDefault -> say "the default" "la valeur par défaut"
  RefusedValue _ _ _ (Kept value) -> Just value
  RepeatedProperty {} -> say "the values before it" "les valeurs précédentes"
  SecondShape _ -> say "the first one" "la première"
  ImpossibleObject _ _ LeftOut -> say "nothing: it is left out" "rien\xA0: cet objet est omis"
  ImpossibleObject _ _ Superseded -> say "the one before it, or the default" "l'objet d'avant, ou celui par défaut"
  DecimalComma _ t -> Just t
  NoMaterialName -> say "'none'" "'none'"
  MissingMaterial {} -> say "a grey material" "un matériel gris"
  RepeatedMaterial {} -> say "the first one" "le premier"
  ReplacedObject {} -> Nothing
  NoModelFile -> say "nothing: there is nothing to draw" "rien\xA0: il n'y a rien à dessiner"
  UnknownModelFormat _ -> modelLeftOut
  EmptyModel _ -> say "nothing: there is nothing to draw" "rien\xA0: il n'y a rien à dessiner"
  ModelCycle _ -> modelLeftOut
  ModelTooDeep {} -> modelLeftOut
  TooManyParts {} -> modelLeftOut
  DifferingUvFormat _ first -> Just first
  BrokenCurve _ -> say "nothing: the curve is left out" "rien\xA0: la courbe est omise"
  PiecesWithoutLength _ -> say "nothing: they are left out" "rien\xA0: ils sont omis"
  BadCoordinates what _ -> case what of
    OfVertex -> say "nothing: the faces that use this vertex are left out" "rien\xA0: les faces qui utilisent ce sommet sont omises"
    OfAttribute TextureCoordinate -> Just "0.0 0.0"
    OfAttribute Normal -> say "the normal of the flat triangle" "la normale du triangle plat"
  BadFace _ -> faceLeftOut
  MissingVertex {} -> faceLeftOut
  MissingAttribute a _ _ -> without a
  NoAttributes a _ -> without a
  CollinearTriangles _ -> say "nothing: they are left out" "rien\xA0: ils sont omis"
  LongLine _ -> say "nothing: the line is passed over" "rien\xA0: la ligne est ignorée"
  TooManyLibraries _ -> say "the ones before" "les précédentes"
  UnknownMaterialOfModel _ -> say "a green material" "un matériel vert"
  MoreFaults _ -> Nothing
  UnusableFile _ ForTexture _ -> say "the plain colour" "la couleur unie"
  UnusableFile _ ForMask _ -> say "an aperture that is open everywhere" "une ouverture entièrement ouverte"
  UnusableFile _ ForModel _ -> modelLeftOut
  UnusableFile _ ForMaterialLibrary _ -> say "materials that stand in for those that are not found" "des matériaux de remplacement pour ceux qui manquent"
  SamplingWithoutRandom _ -> Nothing
  Departs departure -> Just (here l departure)
  where
    say en fr = Just (inLanguage l en fr)
    without = \case
      TextureCoordinate -> say "no texture coordinates for the face" "aucune coordonnée de texture pour la face"
      Normal -> say "the normals of the flat triangles" "les normales des triangles plats"
    faceLeftOut = say "nothing: the face is left out" "rien\xA0: la face est omise"
    modelLeftOut = say "nothing: the model is left out" "rien\xA0: le modèle est omis"
    lineAlone = inLanguage l "nothing: the line is passed over" "rien\xA0: la ligne est ignorée"
    passedOver = \case
      TheLine -> lineAlone
      TheOpening -> lineAlone
      TheObject n -> inLanguage l ("nothing: all is passed over down to line " <> number n) ("rien\xA0: tout est ignoré jusqu'à la ligne " <> number n)

-- | What a property wants, in words.
expectation :: Language -> Expectation -> Text
expectation l = \case
  ARealNumber r -> inLanguage l "a real number" "un nombre réel" <> range r
  AnInteger r -> inLanguage l "an integer" "un entier" <> range r
  AVector -> inLanguage l "three real numbers, such as [0.0, 0.0, 1.0]" "trois nombres réels, par exemple [0.0, 0.0, 1.0]"
  AVectorWithoutZero -> inLanguage l "three real numbers other than zero" "trois nombres réels autres que zéro"
  ADirection -> inLanguage l "three real numbers that are not all zero" "trois nombres réels qui ne sont pas tous nuls"
  TwoCoordinates -> inLanguage l "two real numbers" "deux nombres réels"
  AColour names ->
    inLanguage l "red, green and blue from 0 up (and alpha), or a name: " "rouge, vert et bleu à partir de 0 (et alpha), ou un nom\xA0: "
      <> Text.intercalate ", " names
  ABoolean -> inLanguage l "true or false (yes or no, on or off, 1 or 0)" "vrai ou faux (oui ou non, on ou off, 1 ou 0)"
  AChoice words' -> oneOf l words' <> inLanguage l (" (or 0 to " <> most words' <> ")") (" (ou 0 à " <> most words' <> ")")
  SomeText -> inLanguage l "some text, up to the end of the line" "du texte, jusqu'à la fin de la ligne"
  AnOutputName -> inLanguage l "the name of a file, without a folder" "le nom d'un fichier, sans dossier"
  AmountsOfLight -> inLanguage l "red, green and blue from 0 up, or one number for all three" "rouge, vert et bleu à partir de 0, ou un seul nombre pour les trois"
  AnOutputNameEnding e -> inLanguage l ("the name of a file that ends in " <> e) ("le nom d'un fichier qui finit par " <> e)
  where
    most words' = number (length words' - 1)
    range = \case
      AnyNumber -> ""
      AtLeast a -> inLanguage l (", at least " <> a) (", au moins " <> a)
      Between a b -> inLanguage l (" from " <> a <> " to " <> b) (" de " <> a <> " à " <> b)

oneOf :: Language -> [Text] -> Text
oneOf l words' = inLanguage l "one of " "l'un de " <> Text.intercalate ", " words'
