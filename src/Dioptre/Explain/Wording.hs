{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.Wording
-- Description : The story of a pixel in words, English and French
--
-- For a person to read, on a screen: the answer first, then how it comes about. What is long is shortened, and says so:
-- of many shapes the nearest few are told and the others counted, and so it is with rays and samples.
-- "Dioptre.Explain.Json" has every ray and sample.
module Dioptre.Explain.Wording
  ( storyText,
  )
where

import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Explain.Phrase
import Dioptre.Explain.Story
import Dioptre.Explain.Trials (missesText, trialsText)
import Dioptre.Light.Colour (Colour (..), black)
import Dioptre.Light.Finish (Colours (..))
import Dioptre.Math.Vector (vector)
import Dioptre.Picture.Byte (Pixel (..))
import Dioptre.Scene.Raytracer (ColourNormalization (..), Raytracer (..), algorithmName, mostRays)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (counted, number)
import Linear.V2 (V2 (..))

-- | The story, in lines, with the name of the scene.
storyText :: Language -> Text -> Story -> Text
storyText l name story =
  Text.unlines $
    heading
      <> [""]
      <> concatMap (uncurry (sampleText l story several)) (zip [1 ..] (take samplesTold samples))
      <> [ say "The other " "Les " <> number (cast - told) <> say " rays of the pixel are told with --format json." " autres rayons du pixel sont racontés avec --format json."
           | cast > told && length samples == cast
         ]
      <> [ say "Of the other " "Des " <> number (cast - told) <> say " rays of the pixel the first " " autres rayons du pixel, les " <> number (length samples - told)
             <> say " are told with --format json." " premiers sont racontés avec --format json."
           | cast > length samples
         ]
      <> ["" | cast > told]
      <> colourText l story
  where
    say = inLanguage l
    samples = storySamples story
    told = length (take samplesTold samples)
    cast = raysCast story
    several = cast > 1
    (width, height) = storySize story
    tracer = storyRaytracer story
    heading =
      [ name <> say ": column " "\xA0: colonne " <> number (storyColumn story) <> say ", row " ", ligne " <> number (storyRow story)
          <> say ", counted from 0, of " ", comptées de 0, sur "
          <> number width
          <> " x "
          <> number height
          <> " pixels"
      ]
        <> [answer l story]
        <> [ number cast <> say " rays are cast through the pixel, whose colour is their mean." " rayons sont lancés à travers le pixel, dont la couleur est leur moyenne."
             | several
           ]
        <> [ say "Light: " "Lumière\xA0: " <> algorithmName (raytracerAlgorithm tracer) <> ", recursive_level "
               <> number (raytracerRecursiveLevel tracer)
               <> (if isLit then ", " <> counted l (storyLights story) ("light", "lights") ("source", "sources") else "")
               <> "."
           ]
    isLit = or [isJust (hitShares hit) | s <- take 1 samples, Just hit <- [rayHit (sampleRay s)]]

-- | How many rays are cast through the pixel; not all need be kept.
raysCast :: Story -> Int
raysCast = raytracerSampling . storyRaytracer

-- | How many samples are told in full.
samplesTold :: Int
samplesTold = 2

-- | How many rays of a sample are told in full, how many more in a line each, and how many at the end, where their
-- contributions are added.
raysTold, raysListed, raysAdded :: Int
raysTold = 4
raysListed = 12
raysAdded = 8

-------------------------------------------------------------------------------
-- The answer

-- | What the pixel shows, and if it is black, why.
answer :: Language -> Story -> Text
answer l story = case storySamples story of
  [only] | raysCast story == 1 -> pixel <> say "; " "\xA0; " <> seenText only
  _
    | storySeesNothing story -> pixel <> say "; none of its rays meets a shape." "; aucun de ses rayons ne rencontre de forme."
    | otherwise -> pixel <> "."
  where
    say = inLanguage l
    isBlack = case storyPixel story of
      Pixel 0 0 0 _ -> True
      _ -> False
    pixel = say "The pixel is " "Le pixel vaut " <> pixelText (storyPixel story) <> (if isBlack then say ", black" ", noir" else "")
    seenText sample = case rayHit ray' of
      Nothing -> say "its ray meets no shape" "son rayon ne rencontre aucune forme" <> missesText l ray'
      Just hit -> say "its ray sees " "son rayon voit " <> theThing l (hitThing hit) <> (if isBlack then whyBlack hit else "") <> "."
      where
        ray' = sampleRay sample
    whyBlack hit = case hitShares hit of
      Nothing -> say ", whose own colour is black" ", dont la couleur propre est noire"
      Just [] -> say ", and the scene has no light" ", et la scène n'a pas de lumière"
      Just shares
        | not (any arrives shares) -> say ", which no light reaches" ", qu'aucune lumière n'atteint"
        | otherwise -> say ", which sends back too little light for one level of 255" ", qui renvoie trop peu de lumière pour un niveau sur 255"
    arrives s = case shareArrival s of
      FromAllSides -> True
      Arrives {} -> True
      _ -> False

-------------------------------------------------------------------------------
-- Rays

-- | One ray through the pixel and what comes of it.
sampleText :: Language -> Story -> Bool -> Int -> Sample -> [Text]
sampleText l story several k sample =
  [ say "THROUGH THE PIXEL AT " "À TRAVERS LE PIXEL EN " <> pair (sampleOffset sample) <> say ": RAY " "\xA0: RAYON " <> number k <> say " OF " " SUR " <> number (raysCast story)
    | several
  ]
    <> concatMap (uncurry (rayText l story)) (take raysTold rays)
    <> [say "Further rays" "Autres rayons" | length rays > raysTold]
    <> map (uncurry (rayLine l)) (take raysListed further)
    <> ["  " <> say "and " "et " <> number (length further - raysListed) <> say " more" " de plus" | length further > raysListed]
    <> ["" | length rays > raysTold]
    <> [ say "More rays were wanted than the " "Plus de rayons étaient demandés que les " <> number mostRays
           <> say " that are followed; what lies beyond is black." " qui sont suivis\xA0; ce qui est au-delà est noir."
         | sampleCut sample
       ]
    <> [say "Seen through this point: " "Vu à travers ce point\xA0: " <> colour (sampleColour sample) | several]
    <> ["" | several]
  where
    say = inLanguage l
    rays = numberedRays "1" (sampleRay sample)
    further = drop raysTold rays

-- | A ray and all that come from it, each with its name: that of the ray it comes from, and its place there.
numberedRays :: Text -> RayStory -> [(Text, RayStory)]
numberedRays name0 r0 = from (name0, r0) []
  where
    from (name, r) rest = (name, r) : foldr from rest [(name <> "." <> number k, next) | (k, next) <- zip [1 :: Int ..] (nextRays r)]

nextRays :: RayStory -> [RayStory]
nextRays r = [next | Just hit <- [rayHit r], Bounce {bounceSequel = Followed _ next} <- hitBounces hit]

-- | A ray in one line.
rayLine :: Language -> Text -> RayStory -> Text
rayLine l name r = "  " <> name <> "  " <> causeText l (rayCause r) <> ", " <> maybe (inLanguage l "meets nothing" "ne rencontre rien") (thingText l . hitThing) (rayHit r) <> "  +" <> colour (rayContribution r)

causeText :: Language -> Cause -> Text
causeText l cause = case cause of
  FromCamera -> inLanguage l "from the camera" "de la caméra"
  ByReflection -> inLanguage l "reflected" "réfléchi"
  ByRefraction -> inLanguage l "refracted" "réfracté"

-- | A ray in full.
rayText :: Language -> Story -> Text -> RayStory -> [Text]
rayText l story name r =
  [say "Ray " "Rayon " <> name <> ", " <> causeText l (rayCause r) <> "        r(t) = o + t d"]
    <> rayIn "  " (rayItself r)
    <> [say "  for t from " "  pour t de " <> smallestText <> say " to " " à " <> real (storyFar story) <> reach | isFirst]
    <> [say "  weight " "  poids " <> triple (rayWeight r) <> say "; refractive index around it " "\xA0; indice de réfraction autour de lui " <> real (rayIndex r) | not isFirst]
    <> [""]
    <> trialsText l isFirst r
    <> maybe [say "It meets nothing: black." "Il ne rencontre rien\xA0: noir.", ""] (hitText l r name) (rayHit r)
  where
    say = inLanguage l
    isFirst = rayCause r == FromCamera
    reach = say ", from the near clipping plane on" ", à partir du plan de coupure rapproché"

-------------------------------------------------------------------------------
-- Hits

-- | What is met, how it is lit, and what becomes of the ray.
hitText :: Language -> RayStory -> Text -> Hit -> [Text]
hitText l r name hit =
  [ say "Where it sees " "Là où il voit " <> theThing l (hitThing hit),
    say "  point    " "  point    " <> "r(t) = " <> vec (hitPoint hit),
    say "  normal   " "  normale  " <> vec (vector (hitNormal hit)) <> (if hitNormal hit == hitOutward hit then "" else say "  (turned towards the ray)" "  (tournée vers le rayon)"),
    "  uv       [" <> real u <> ", " <> real v <> "]",
    ""
  ]
    <> lightText l r hit
    <> concatMap (bounceText l name) (zipBounces (hitBounces hit))
    <> ["" | not (null (hitBounces hit))]
  where
    say = inLanguage l
    V2 u v = hitUv hit

lightText :: Language -> RayStory -> Hit -> [Text]
lightText l r hit = case hitShares hit of
  Nothing ->
    [ say "Without light (no_light) its diffuse colour is seen as it is: " "Sans lumière (no_light), sa couleur diffuse est vue telle quelle\xA0: " <> colour (rayOwnColour r) <> pictured,
      ""
    ]
  Just shares ->
    [say "The light there" "La lumière à cet endroit"]
      <> [ say "  the surface: ambient " "  la surface\xA0: ambiant " <> colour (ambientOf colours) <> say ", diffuse " ", diffus " <> colour (diffuseOf colours) <> ",",
           say "    specular " "    spéculaire " <> colour (specularOf colours) <> say ", shininess " ", brillance " <> real (shininessOf colours) <> pictured
         ]
      <> [say "  there is no light in the scene" "  il n'y a pas de lumière dans la scène" | null shares]
      <> concatMap (shareText l) shares
      <> [say "  together " "  ensemble " <> colour (rayOwnColour r), ""]
  where
    say = inLanguage l
    colours = hitColours hit
    pictured = if hitHasPicture hit then say "  (from its picture at uv)" "  (de son image en uv)" else ""

-- | What a light gives.
shareText :: Language -> Share -> [Text]
shareText l share = ("  " <> number (shareLight share + 1) <> " " <> kind <> " " <> colour (shareColour share) <> say ": " "\xA0: " <> arrivalText) : terms
  where
    say = inLanguage l
    kind = case shareKind share of
      AmbientKind -> say "ambient light" "lumière ambiante"
      DirectionalKind -> say "directional light" "lumière directionnelle"
      PointKind -> say "point light" "lumière ponctuelle"
      WaveKind -> say "light of waves" "lumière d'ondes"
    arrivalText = case shareArrival share of
      FromAllSides -> say "from everywhere" "de partout"
      LeftOut -> say "left out by this algorithm" "laissée de côté par cet algorithme"
      Nowhere -> say "nothing: the point is where the light is, or the attenuation is not defined there" "rien\xA0: le point est là où est la lumière, ou l'atténuation n'y est pas définie"
      FacesAway way -> say "nothing: the surface is turned away (cosine " "rien\xA0: la surface lui tourne le dos (cosinus " <> real (approachCosine way) <> ")"
      InShadow way by -> say "nothing: in the shadow" "rien\xA0: dans l'ombre" <> maybe "" (\(thing, t) -> say " of " " de " <> theThing l thing <> say ", " ", à " <> real t <> say " away" "") by <> wayText way
      Arrives way open through ->
        say "arrives" "arrive" <> (if null through then "" else say " through " " à travers " <> Text.intercalate ", " (map (theThing l) through) <> tint open) <> wayText way
    tint (Colour r g b _) = say ", times " ", fois " <> triple (r, g, b)
    wayText way =
      maybe "" (\far -> say "; distance " "\xA0; distance " <> real far <> (if approachFactor way == 1 then "" else say ", attenuation " ", atténuation " <> real (approachFactor way))) (approachDistance way)
        <> say "; cosine " "\xA0; cosinus "
        <> real (approachCosine way)
    terms = ["      " <> Text.justifyLeft 11 ' ' (termText l term) <> colour c | (term, c) <- shareTerms share]

termText :: Language -> Term -> Text
termText l term = case term of
  AmbientTerm -> say "ambient" "ambiant"
  DiffuseTerm -> say "diffuse" "diffus"
  BlinnTerm -> say "highlight" "reflet"
  PhongTerm -> say "highlight" "reflet"
  WaveTerm -> say "waves" "ondes"
  where
    say = inLanguage l

-- | Bounces, with the places of those that are followed, from 1.
zipBounces :: [Bounce] -> [(Int, Bounce)]
zipBounces = go 1
  where
    go _ [] = []
    go k (b : rest) = case bounceSequel b of
      Followed _ _ -> (k, b) : go (k + 1) rest
      NotFollowed _ -> (k, b) : go k rest

bounceText :: Language -> Text -> (Int, Bounce) -> [Text]
bounceText l name (k, bounce) = case bounceKind bounce of
  Reflection -> [say "A mirror, kr = " "Un miroir, kr = " <> real (bounceCoefficient bounce) <> say ": angle of incidence " "\xA0: angle d'incidence " <> degrees (bounceAngleIn bounce) <> outcome]
  Refraction n1 n2 enters ->
    [ say "Transparent, kt = " "Transparent, kt = " <> real (bounceCoefficient bounce) <> (if enters then say ", entering: " ", en entrant\xA0: " else say ", leaving: " ", en sortant\xA0: ")
        <> "n1 = "
        <> real n1
        <> ", n2 = "
        <> real n2
        <> say ", angle of incidence " ", angle d'incidence "
        <> degrees (bounceAngleIn bounce)
        <> outcome
    ]
  where
    say = inLanguage l
    outcome = case bounceSequel bounce of
      Followed angleOut _ -> say ", and out at " ", et de sortie " <> degrees angleOut <> say ": ray " "\xA0: rayon " <> name <> "." <> number k
      NotFollowed obstacle ->
        say "; " "\xA0; " <> case obstacle of
          DepthReached -> say "recursive_level ends here" "recursive_level s'arrête ici"
          TooManyRays -> say "too many rays already" "déjà trop de rayons"
          TotalReflection -> say "nothing passes: total reflection" "rien ne passe\xA0: réflexion totale"
          NoInside -> say "the shape has no inside, so nothing is seen through it" "la forme n'a pas d'intérieur, on ne voit rien à travers elle"

-------------------------------------------------------------------------------
-- Colours

-- | From the sum to the bytes.
colourText :: Language -> Story -> [Text]
colourText l story =
  [say "The colour" "La couleur"]
    <> sums
    <> ["  " <> normalization]
    <> [say "  times 255, rounded: " "  fois 255, arrondi\xA0: " <> pixelText (storyPixel story)]
  where
    say = inLanguage l
    sums = case storySamples story of
      _
        | raysCast story > 1 -> [say "  mean of the rays  " "  moyenne des rayons  " <> colour (storyColour story)]
      [only]
        | rays <- numberedRays "1" (sampleRay only),
          length (take 2 rays) > 1,
          bright <- filter ((/= black) . rayContribution . snd) rays ->
          ["  " <> say "ray " "rayon " <> name <> ": " <> colour (rayOwnColour r) <> " x " <> triple (rayWeight r) <> " = " <> colour (rayContribution r) | (name, r) <- take raysAdded bright]
            <> [say "  and " "  et " <> number (length bright - raysAdded) <> say " more" " de plus" | length bright > raysAdded]
            <> [say "  sum  " "  somme  " <> colour (storyColour story)]
      _ -> ["  " <> colour (storyColour story)]
    unchanged = channels (storyColour story) == channels (storyNormalized story)
    normalization = case raytracerColourNormalization (storyRaytracer story) of
      ClampChannel
        | unchanged -> say "no channel is above 1" "aucun canal ne dépasse 1"
        | otherwise -> say "each channel cut to 1 (clamp_channel): " "chaque canal coupé à 1 (clamp_channel)\xA0: " <> colour (storyNormalized story)
      DivisionFactor
        | unchanged -> say "no channel is above 1" "aucun canal ne dépasse 1"
        | otherwise -> say "divided by the largest channel (division_factor): " "divisé par le plus grand canal (division_factor)\xA0: " <> colour (storyNormalized story)
    channels (Colour r g b _) = [r, g, b]
