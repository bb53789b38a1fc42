{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.Trials
-- Description : The shapes that a ray was tried on, in words
--
-- Each with its equation, its coefficients and roots, and what became of them; many of them shortened to the nearest
-- few and to how many the others are.
module Dioptre.Explain.Trials
  ( trialsText,
    missesText,
  )
where

import Data.List (nub, sortOn)
import Data.Maybe (isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Explain.Phrase
import Dioptre.Explain.Story
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (counted, number)

-- | How many shapes are told one by one where there are many.
shapesTold :: Int
shapesTold = 6

-- | Why shapes are not met, in numbers.
missesText :: Language -> RayStory -> Text
missesText l r
  | null parts = "."
  | otherwise = inLanguage l ": of " "\xA0: sur " <> counted l total ("shape", "shapes") ("forme", "formes") <> ", " <> Text.intercalate ", " parts <> "."
  where
    total = length (rayEncounters r) + rayPassed r + rayUntold r
    verdicts = [m | Encounter {encounterVerdict = Misses m} <- rayEncounters r]
    beside = length [() | m <- verdicts, m `elem` [NoRoot, NotOnShape]] + rayPassed r
    parts =
      [counted' beside (inLanguage l "beside its line" "à côté de sa droite") | beside > 0]
        <> [counted' k (missShort l m) | m <- [Parallel, IsBehind, IsTooNear, IsBeyondFar], let k = length (filter (== m) verdicts), k > 0]
        <> [counted' (rayUntold r) (inLanguage l "not told one by one" "non racontées une à une") | rayUntold r > 0]
    counted' k what = number k <> " " <> what

missShort :: Language -> Miss -> Text
missShort l miss = case miss of
  Parallel -> say "along which it runs" "que sa droite longe"
  NoRoot -> say "beside its line" "à côté de sa droite"
  NotOnShape -> say "beside its line" "à côté de sa droite"
  IsBehind -> say "behind its origin" "derrière son origine"
  IsTooNear -> say "met only where it starts" "rencontrée seulement à son départ"
  IsBeyondFar -> say "beyond the far clipping plane" "au-delà du plan de coupure éloigné"
  where
    say = inLanguage l

-- | The shapes that a ray was tried on; for a ray of the camera each with its equation if they are few.
trialsText :: Language -> Bool -> RayStory -> [Text]
trialsText l inFull r
  | null (rayEncounters r) && rayPassed r + rayUntold r == 0 = [say "There is no shape." "Il n'y a pas de forme.", ""]
  | otherwise = title : concatMap (\e -> encounterText l e <> [""]) told <> rest
  where
    say = inLanguage l
    title = if inFull then say "Which shapes it meets" "Quelles formes il rencontre" else say "What it meets first" "Ce qu'il rencontre d'abord"
    met = sortOn fst [(t, e) | e@Encounter {encounterVerdict = Meets t _} <- rayEncounters r]
    nearFirst = [e | (_, e) <- met, isClosest e] <> [e | (_, e) <- met, not (isClosest e)]
    isClosest e = case encounterVerdict e of
      Meets _ IsClosest -> True
      _ -> False
    told
      | not inFull = filter isClosest (rayEncounters r)
      | length (rayEncounters r) <= shapesTold && rayPassed r == 0 = rayEncounters r
      | null nearFirst = take 2 (filter (not . beside) (rayEncounters r) <> rayEncounters r)
      | otherwise = take (shapesTold `div` 2) nearFirst
    beside e = encounterVerdict e `elem` map Misses [NoRoot, NotOnShape, Parallel]
    others = [e | e <- rayEncounters r, thingNumber (encounterThing e) `notElem` map (thingNumber . encounterThing) told]
    farther = length [() | Encounter {encounterVerdict = Meets _ _} <- others]
    counts =
      [counted l farther ("met farther away", "met farther away") ("rencontrée plus loin", "rencontrées plus loin") | farther > 0]
        <> [number k <> " " <> missShort l m | (m, k) <- [(NoRoot, countOf [NoRoot, NotOnShape] + rayPassed r)] <> [(m, countOf [m]) | m <- [Parallel, IsBehind, IsTooNear, IsBeyondFar]], k > 0]
        <> [number (rayUntold r) <> say " not told one by one" " non racontées une à une" | rayUntold r > 0]
    countOf ms = length [() | Encounter {encounterVerdict = Misses m} <- others, m `elem` ms]
    rest
      | null counts = []
      | otherwise = [say "  The others: " "  Les autres\xA0: " <> Text.intercalate ", " counts <> ".", ""]

-- | One shape with its equation and roots.
encounterText :: Language -> Encounter -> [Text]
encounterText l e =
  ["  " <> thingText l (encounterThing e) <> say ": " "\xA0: " <> verdictText l (encounterVerdict e)]
    <> maybe [] (\r -> say "    in its own frame" "    dans son repère" : rayIn "      " r) (equationRay equation)
    <> maybe [] (\(t0, k) -> ["    t = " <> (if k == 1 then "t0 + s" else "(t0 + s) k, k = " <> real k) <> ", t0 = " <> real t0]) (equationMoved equation)
    <> concat [conditionText l letter [rootParameter root | root <- encounterRoots e, rootCondition root == i] condition | (i, condition) <- zip [0 ..] (equationConditions equation)]
    <> nub (map rootText (filter isTold (encounterRoots e)))
    <> sharedText
  where
    say = inLanguage l
    equation = encounterEquation e
    letter = if isNothing (equationMoved equation) then "t" else "s"
    -- What a slab says of its roots stands with it.
    isTold root = (rootFate root, rootMeasure root) /= (Outside, OtherConditions) || rootCondition root `elem` [i | (i, PolynomialIsZero {}) <- zip [0 ..] (equationConditions equation)]
    slabsOnly = not (null ranges) && length ranges == length (equationConditions equation)
    ranges = [(low, high) | (i, LiesBetween {}) <- zip [0 ..] (equationConditions equation), [low, high] <- [[rootParameter root | root <- encounterRoots e, rootCondition root == i]]]
    sharedText
      | slabsOnly && lastEntry > firstExit = [say "    so nowhere in all of them: the last entry, t = " "    donc nulle part entre toutes\xA0: la dernière entrée, t = " <> real lastEntry <> say ", comes after the first exit, t = " ", vient après la première sortie, t = " <> real firstExit]
      | otherwise = []
      where
        lastEntry = maximum (map fst ranges)
        firstExit = minimum (map snd ranges)
    rootText root = "    t = " <> real (rootParameter root) <> "  " <> fateText l (rootFate root) <> (if rootFate root `elem` [Taken, Outside] then measureText l root else "")

verdictText :: Language -> Verdict -> Text
verdictText l verdict = case verdict of
  Meets t kept ->
    say "met at t = " "rencontre à t = " <> real t <> case kept of
      IsClosest -> say "; nothing is nearer" "\xA0; rien n'est plus proche"
      IsFarther -> say "; something is nearer" "\xA0; quelque chose est plus proche"
      IsAsNear -> say "; another one as near stands before it in the file" "\xA0; une autre, aussi proche, la précède dans le fichier"
  Misses miss ->
    say "not met: " "pas de rencontre\xA0: " <> case miss of
      Parallel -> say "the ray runs along it (A is zero, but for rounding)" "le rayon lui est parallèle (A est nul, à l'arrondi près)"
      NoRoot -> say "there is no real root, the line passes beside it" "il n'y a pas de racine réelle, la droite passe à côté"
      NotOnShape -> say "the line passes beside it" "la droite passe à côté"
      IsBehind -> say "it is behind the origin of the ray (t < 0)" "derrière l'origine du rayon (t < 0)"
      IsTooNear -> say "only where the ray starts (t <= " "seulement là où le rayon part (t <= " <> smallestText <> ")"
      IsBeyondFar -> say "it is beyond the far clipping plane" "au-delà du plan de coupure éloigné"
  where
    say = inLanguage l

fateText :: Language -> Fate -> Text
fateText l fate = case fate of
  Taken -> say "kept" "gardée"
  Later -> say "later" "plus tard"
  Behind -> say "negative: behind the origin" "négative\xA0: derrière l'origine"
  TooNear -> say "too near: at most " "trop proche\xA0: au plus " <> smallestText
  BeyondFar -> say "too far: not before the far clipping plane" "trop loin\xA0: pas avant le plan de coupure éloigné"
  Outside -> say "outside" "à l'extérieur"
  where
    say = inLanguage l

-- | What was measured at a root, where it says more than the equations.
measureText :: Language -> Root -> Text
measureText l root = case rootMeasure root of
  AwayFromCentre away radius -> say ": the point is " "\xA0: le point est à " <> real away <> say " from the centre, " " du centre, " <> (if outside then say "more than R = " "plus de R = " else say "at most R = " "au plus R = ") <> real radius
  InTheHole away radius -> say ": the point is " "\xA0: le point est à " <> real away <> say " from the centre, less than r = " " du centre, moins de r = " <> real radius
  OnTheRing away hole radius -> say ": the point is " "\xA0: le point est à " <> real away <> say " from the centre, at least r = " " du centre, au moins r = " <> real hole <> say " and at most R = " " et au plus R = " <> real radius
  Barycentric t1 t2 -> say ": t1 = " "\xA0: t1 = " <> real t1 <> ", t2 = " <> real t2 <> ", 1 - t1 - t2 = " <> real (1 - t1 - t2) <> (if outside then say "; on the triangle none is negative" "\xA0; sur le triangle, aucun n'est négatif" else "")
  AtHeight height len -> say ": at the height " "\xA0: à la hauteur " <> real height <> (if outside then say ", not from 0 to " ", pas de 0 à " else say ", from 0 to " ", de 0 à ") <> real len
  SideOfDisk -> if outside then say ": on the other side of the disk" "\xA0: de l'autre côté du disque" else ""
  OtherConditions -> if outside then say ": the other conditions do not hold there" "\xA0: les autres conditions n'y tiennent pas" else ""
  where
    say = inLanguage l
    outside = rootFate root == Outside

-- | A condition, with the parameters of its roots, ascending.
conditionText :: Language -> Text -> [Double] -> Condition -> [Text]
conditionText l letter roots condition = case condition of
  PolynomialIsZero patch coefficients letters discriminant shift ->
    ["    " <> patchText l patch <> say ": " "\xA0: " <> polynomial (if shift == 0 then letter else "s'") (length coefficients - 1) <> (if shift == 0 then "" else ", s = s' + " <> real shift)]
      <> ["      " <> Text.justifyLeft 2 ' ' name <> "= " <> Text.justifyLeft widest ' ' formula <> " = " <> real x | Coefficient name formula x <- coefficients]
      <> map ("      " <>) (filled 100 letters)
      <> ["      B^2 - 4 A C = " <> real d | Just d <- [discriminant]]
    where
      widest = maximum (0 : [Text.length formula | Coefficient _ formula _ <- coefficients])
  LiesBetween patch (Coefficient _ fa a) (Coefficient _ fb b) low high ->
    [ "    " <> patchText l patch <> say ": " "\xA0: " <> case roots of
        [enter, leave] -> say "from t = " "de t = " <> real enter <> say " to t = " " à t = " <> real leave
        _
          | low <= b && b <= high -> say "everywhere" "partout"
          | otherwise -> say "nowhere" "nulle part",
      "      " <> real low <> " <= " <> fb <> " + " <> fa <> " " <> letter <> " <= " <> real high <> values
    ]
    where
      -- Those of a cube are the ray's own.
      values = case patch of
        TheFaces _ -> ""
        _ -> "    " <> fb <> " = " <> real b <> ", " <> fa <> " = " <> real a
  PassesNear away reach ->
    ["    " <> say "the line passes " "la droite passe à " <> real away <> say " from the centre, and the shape reaches as far as " " du centre, et la forme s'étend jusqu'à " <> real reach]
  where
    say = inLanguage l

-- | Definitions side by side, in lines of about that many letters.
filled :: Int -> [Text] -> [Text]
filled width = reverse . foldl onto []
  where
    onto (line : before) one | Text.length line + Text.length one < width = (line <> ", " <> one) : before
    onto before one = one : before

-- | A polynomial of that degree in a letter.
polynomial :: Text -> Int -> Text
polynomial x degree = Text.intercalate " + " (zipWith term ["A", "B", "C", "D", "E"] [degree, degree - 1 .. 0]) <> " = 0"
  where
    term c k = c <> (if k == 0 then "" else " " <> x <> (if k == 1 then "" else "^" <> number k))

patchText :: Language -> Patch -> Text
patchText l patch = case patch of
  ThePlane -> say "plane" "plan"
  TheSphere -> say "sphere" "sphère"
  TheTube -> say "tube without end" "tube sans fin"
  TheDoubleCone -> say "double cone without end" "double cône sans fin"
  TheTorus -> say "torus" "tore"
  TheEnds -> say "between the ends" "entre les extrémités"
  TheFaces axis -> say "between the faces across " "entre les faces perpendiculaires à " <> axis
  TheStartFace -> say "sphere of the face at P1" "sphère de la face en P1"
  TheEndFace -> say "sphere of the face at P2" "sphère de la face en P2"
  where
    say = inLanguage l
