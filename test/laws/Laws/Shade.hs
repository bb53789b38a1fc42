{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Shade
-- Description : What is true of the colours that rays see
--
-- The second opinion is 'plainly': the recursion as it is specified, with the sums written out, straight from the
-- scene. It shares with the program the shapes ("Dioptre.Geometry.Prepared"), the two laws of optics and the intensity
-- of waves, which have laws of their own, so that both follow the same rays to the bit.
module Laws.Shade
  ( -- * Scenes
    sceneOf,
    Shown (..),
    seen,
    seenWith,
    channels,
    within,
    roundings,
    setLights,
    setLevel,
    setAlgorithm,
    setMaterials,

    -- * A second opinion
    Plain (..),
    plainly,

    -- * What the laws are tried with
    Small (..),
    smallCorners,
    aMaterial,

    -- * Laws
    loopIsTheRecursion,
    lightsAddUp,
    lightsHaveNoOrder,
    termsAddUp,
    wavesDisregardTheAlgorithm,
    twiceTheLightIsTwiceTheColour,
    levelOneHasNoBounces,
    levelsAdd,
    withoutMirrorsLevelsDoNotMatter,
    withoutLightsAllIsBlack,
    ambientLightTakesNoShadowRays,
    noLightIsDiffuse,
    mirrorShowsWhatItFaces,
    mirrorIsWeighted,
    slabDisplaces,
    passageHasNoOrder,
    litIsOpaque,
  )
where

import Data.List (find, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (disk)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Prepared (Prepared, contains, isClosed, normalAt, parameters, prepare)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Geometry.Triangle (Corners (..), triangle)
import Dioptre.Light.Colour (Colour (..), rgb)
import Dioptre.Light.Light
import Dioptre.Light.Material (Material (..), standard)
import Dioptre.Light.Wave (intensity, linearOscillators, planarOscillators)
import Dioptre.Light.Wavelength (colourOfWavelength)
import Dioptre.Math.Vector
import Dioptre.Model.Library (noModels)
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Dioptre.Render.Radiance (Seen (..), radiance, unlit)
import Dioptre.Render.Stage (Stage (..), stage)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.Texture (Assets)
import Dioptre.Render.Transmittance (Transmittance (..), transmittance)
import Dioptre.Render.World (world)
import Dioptre.Scene (writeScene)
import Dioptre.Scene.Camera (CameraSettings (..), cameraSettings)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Scene.Raytracer (Raytracer (..), ReflexionAlgorithm (..), mostRays)
import Dioptre.Scene.Unchecked (Scene (..))
import Dioptre.Source.Diagnostic (Diagnostic (..), Severity (..), severity)
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (Small, vector, within)

-------------------------------------------------------------------------------
-- Scenes

-- | The scene of a text without mistakes.
sceneOf :: [Text] -> Scene
sceneOf text = case filter ((== Error) . severity . diagnosticProblem) said of
  [] -> scene
  mistakes -> error (show mistakes)
  where
    (scene, said) = checkScene (parse (fromText "scene.txt" (Text.unlines text)))

-- | What a ray sees, but for how many times it was tried on a shape, which depends on the index: the colour, how many
-- rays were cast, and whether more were wanted than 'mostRays'.
data Shown = Shown {shownColour :: Colour, shownRays :: Int, shownCut :: Bool}
  deriving (Eq, Show)

-- | What a ray sees in a scene without pictures.
seen :: Scene -> Ray -> Shown
seen = seenWith Map.empty

-- | What a ray sees in a scene with these pictures.
seenWith :: Assets -> Scene -> Ray -> Shown
seenWith assets scene r = case maybe (unlit s far r) (\terms -> radiance s terms far r) (stageTerms s) of
  Seen c (Tally rays _ cut) -> Shown c rays (cut > 0)
  where
    s = stage assets noModels scene
    far = farOf scene

farOf :: Scene -> Double
farOf = settingFar . cameraSettings . sceneCamera

channels :: Colour -> [Double]
channels (Colour r g b _) = [r, g, b]

-- | Each number within a bound, relative to the second one's, of another. No number is negative, so that sums lose
-- nothing; but the power of 200 in a highlight may be so small that digits are lost, of numbers below 1e-300.
within :: Double -> [Double] -> [Double] -> Property
within bound xs ys = counterexample (show xs <> " is not " <> show ys) (length xs == length ys && and (zipWith (\x y -> abs (x - y) <= bound * y + 1e-300) xs ys))

-- | What so many roundings make at most, one after the other in sums and products of what is not negative. (What they
-- make of each other is so little that a count that is not reached by one makes up for it.)
roundings :: Int -> Double
roundings n = fromIntegral n * 2 ** (-53)

setLights :: [Light] -> Scene -> Scene
setLights ls scene = scene {sceneLights = ls}

setLevel :: Int -> Scene -> Scene
setLevel n scene = scene {sceneRaytracer = (sceneRaytracer scene) {raytracerRecursiveLevel = n}}

setAlgorithm :: ReflexionAlgorithm -> Scene -> Scene
setAlgorithm a scene = scene {sceneRaytracer = (sceneRaytracer scene) {raytracerAlgorithm = a}}

setMaterials :: (Material -> Material) -> Scene -> Scene
setMaterials f scene = scene {sceneMaterials = map f (sceneMaterials scene)}

-------------------------------------------------------------------------------
-- A second opinion

-- | A colour; how many rays were followed, and how many shadow rays cast; and whether more were wanted than 'mostRays'.
data Plain = Plain [Double] Int Int Bool
  deriving (Eq, Show)

-- | A shape of the scene, by its number, with its material.
data Thing = Thing Int Prepared Material

-- | What is left of the rays that may be followed, how many shadow rays were cast, and whether any ray was wanted in
-- vain.
data Budget = Budget !Int !Int !Bool

-- | The recursion of the specification.
plainly :: Scene -> Ray -> Plain
plainly scene r0 = case shade 1 (indexAt Nothing (origin r0)) r0 (Budget mostRays 0 False) of
  (V3 r g b, Budget left shadows cut) -> Plain [r, g, b] (mostRays - left) shadows cut
  where
    things = mapMaybe thing (zip [0 ..] (scenePrimitives scene))
    thing (i, p) = (\shape -> Thing i shape (materialOf (primitiveMaterial p))) <$> prepare (primitiveShape p)
    materialOf name = fromMaybe (error "no such material") (find ((== name) . materialName) (sceneMaterials scene))
    settings = sceneRaytracer scene
    algorithm = raytracerAlgorithm settings

    -- The hits of all things that are nearer than a bound, each thing's first, in order.
    hits r bound = sortOn fst [(t, x) | x@(Thing _ shape _) <- things, t <- take 1 (filter (> 1e-8) (parameters shape r)), t < bound]

    indexAt leftOut p = case [if materialKt m /= 0 then materialRefractiveIndex m else 1 | Thing i shape m <- things, Just i /= leftOut, isClosed shape, contains shape p] of
      [] -> 1
      inside -> sum inside / fromIntegral (length inside)

    -- What one ray sees.
    shade :: Int -> Double -> Ray -> Budget -> (V3 Double, Budget)
    shade _ _ _ (Budget 0 shadows _) = (0, Budget 0 shadows True)
    shade depth index r (Budget left shadows cut) = case hits r (farOf scene) of
      [] -> (0, Budget (left - 1) shadows cut)
      (t, Thing i shape m) : _ ->
        let p = position r t
            v = direction r
            outward = normalAt shape r t
            n = if dot v (vector outward) < 0 then outward else opposite outward
            direct = map (lit m p n v) (sceneLights scene)
            now = Budget (left - 1) (shadows + sum (map snd direct)) cut
            leaving = dot v (vector outward) > 0
            beyond = if leaving then indexAt (Just i) p else materialRefractiveIndex m
            passes = if leaving then pure (materialKt m) else materialKt m *^ three (materialColour m)
            (mirrored, afterwards)
              | materialKr m /= 0 && depth < raytracerRecursiveLevel settings = shade (depth + 1) index (ray p (reflected v n)) now
              | otherwise = (0, now)
            (through, atLast)
              | materialKt m /= 0 && isClosed shape && depth < raytracerRecursiveLevel settings,
                Just v' <- refracted v n index beyond =
                shade (depth + 1) beyond (ray p v') afterwards
              | otherwise = (0, afterwards)
         in (sum (map fst direct) + materialKr m *^ mirrored + passes * through, atLast)

    -- What one light gives, and how many shadow rays it takes.
    lit :: Material -> Point -> Unit -> Vector -> Light -> (V3 Double, Int)
    lit m p n v light = case light of
      Ambient c -> (if withAmbient then three c * (materialKa m *^ three (materialColour m)) else 0, 0)
      Directional c o -> let d = maybe 0 vector (unit o) in lightFrom d (1 / 0) (\f -> terms (three c * f) d)
      PointLight lamp -> fromLamp lamp (lampPosition lamp) (\d f -> terms (three (lampColour lamp) * f) d)
      LinearAperture lamp wave ends@(a, b) -> fromLamp lamp (0.5 *^ (a + b)) (\_ f -> waves wave f (linearOscillators (waveOscillators wave) ends))
      PlanarAperture _ lamp wave aperture -> fromLamp lamp (lampPosition lamp) (\_ f -> waves wave f (planarOscillators (\_ _ -> True) (lampPosition lamp) (waveOscillators wave) aperture))
      where
        three' = three . colourOfWavelength . waveLength
        waves wave f sources
          | isBlack (three' wave * f) = 0
          | otherwise = intensity wave (Unboxed.fromList [(x, y, z) | V3 x y z <- sources]) p *^ three' wave
        fromLamp lamp at shine
          | away == 0 || below == 0 = (0, 0)
          | otherwise = lightFrom d away (\f -> (lampAmplification lamp / below) *^ shine d f)
          where
            away = distance at p
            d = (p - at) ^/ away
            (c, l, q) = lampAttenuators lamp
            below = c + l * away + q * away * away
        -- From a direction and a distance, with the filter of what stands between.
        lightFrom d away shine
          | dot (vector n) (negate d) <= 0 = (0, 0)
          | any (\(_, Thing _ _ k) -> materialKt k == 0) between = (0, 1)
          | otherwise = (shine (product [materialKt k *^ three (materialColour k) | (_, Thing _ _ k) <- between]), 1)
          where
            between = hits (ray p (negate d)) away
        terms light' d
          | isBlack light' = 0
          | otherwise = diffuse + highlight
          where
            diffuse = if withDiffuse then (materialKd m * max 0 (dot (vector n) (negate d))) *^ (light' * three (materialColour m)) else 0
            shine = materialKs m *^ (materialPlasticity m *^ 1 + (1 - materialPlasticity m) *^ three (materialColour m))
            highlight
              | withBlinn && between /= 0 = power (dot (vector n) (between ^/ modulus between)) *^ (light' * shine)
              | withPhong = power (dot (reflected d n) (negate v)) *^ (light' * shine)
              | otherwise = 0
            between = negate v - d
            power x = if x < 0 then 0 else x ** materialShininess m

    withAmbient = algorithm `elem` [AmbientOnly, NoSpecular, Phong, Blinn]
    withDiffuse = algorithm `elem` [DiffuseOnly, NoSpecular, Phong, Blinn]
    withBlinn = algorithm `elem` [BlinnSpecular, Blinn]
    withPhong = algorithm `elem` [PhongSpecular, Phong]
    isBlack (V3 r g b) = r < 1e-10 && g < 1e-10 && b < 1e-10
    three (Colour r g b _) = V3 r g b

-------------------------------------------------------------------------------
-- What the laws are tried with

-- | A scene of a few shapes, materials and lights, and a ray through it.
data Small = Small Scene Ray

instance Show Small where
  show (Small scene r) = show r <> "\n" <> Text.unpack (writeScene scene)

instance Arbitrary Small where
  arbitrary = do
    crisp <- elements [True, False, False]
    let coordinate low high
          | crisp = fromIntegral <$> chooseInt (ceiling low, floor high)
          | otherwise = choose (low, high)
        place = V3 <$> coordinate (-3) 3 <*> coordinate (-3) 3 <*> coordinate (-3) 3
        size = if crisp then elements [1, 2, 3] else choose (0.3, 2.5)
        towards = place `suchThat` (\v -> modulus v > 0.1)
        -- Round a place.
        shape at =
          frequency
            [ (4, ASphere <$$> (sphere at <$> size)),
              (2, ACube <$$> (cube at <$> size)),
              (1, APlane <$$> (plane at <$> towards)),
              (1, ADisk <$$> ((\p r -> p >>= (`disk` r)) . plane at <$> towards <*> size)),
              (1, ATriangle <$$> (triangle <$> (Corners <$> ((at +) <$> place) <*> ((at -) <$> place) <*> place)))
            ]
        make <$$> shapes = make <$> (shapes `suchThatMap` id)
        lamp = Lamp <$> colour <*> place <*> elements [1, 0, 3] <*> elements [(1, 0, 0), (0, 0, 1), (0.5, 0.25, 0.125), (0, 0, 0)]
        wave = Wave <$> choose (380, 780) <*> elements [1, 2, 10] <*> chooseInt (0, 3)
        light =
          frequency
            [ (3, Ambient <$> colour),
              (3, Directional <$> colour <*> towards),
              (4, PointLight <$> lamp),
              (1, LinearAperture <$> lamp <*> wave <*> ((,) <$> place <*> place)),
              (1, PlanarAperture Rectangle <$> lamp <*> wave <*> pure (Aperture 0.001 0.002 (V3 1 2 3) (V3 0 1 0)))
            ]
    materials <- chooseInt (1, 4) >>= \n -> mapM aMaterial (take n ["a", "b", "c", "d"])
    -- Some are more than are tried one after the other.
    centres <- frequency [(5, chooseInt (1, 6)), (1, chooseInt (9, 20))] >>= (`vectorOf` place)
    shapes <- mapM shape centres
    primitives <- mapM (\s -> (`Primitive` s) . materialName <$> elements materials) shapes
    lights <- frequency [(1, pure 0), (14, chooseInt (1, 4))] >>= (`vectorOf` light)
    algorithm <- frequency [(1, elements (filter (/= NoLight) [minBound ..])), (2, elements [Phong, Blinn, NoSpecular])]
    level <- elements [1, 2, 3, 4, 6, 6]
    far <- elements ["100", "100", "100", "100", "4"]
    o <- frequency [(2, (2 *^) <$> place), (1, place), (1, elements centres)]
    target <- oneof [elements centres, (\a b -> a + (1 / 8) *^ b) <$> elements centres <*> place] `suchThat` (/= o)
    let scene = sceneOf ["camera", "near_clipping_plane 0.5", "far_clipping_plane " <> far, "end"]
    pure $
      Small
        (setLevel level (setAlgorithm algorithm scene {scenePrimitives = primitives, sceneMaterials = materials, sceneLights = lights}))
        (ray o (maybe (V3 0 0 1) vector (unit (target - o))))
  shrink (Small scene r) =
    [Small scene {sceneLights = ls} r | ls <- shrinkList (const []) (sceneLights scene)]
      ++ [Small scene {scenePrimitives = ps} r | ps <- shrinkList (const []) (scenePrimitives scene)]
      ++ [Small (setLevel n scene) r | n <- [1 .. raytracerRecursiveLevel (sceneRaytracer scene) - 1]]

-- | A colour that is seldom black, nor very bright.
colour :: Gen Colour
colour = frequency [(1, pure (rgb 0 0 0)), (3, pure (rgb 1 1 1)), (10, Colour <$> channel <*> channel <*> channel <*> elements [1, 1, 0.5])]
  where
    channel = frequency [(1, pure 0), (1, pure 1), (4, choose (0.01, 2))]

-- | A material of that name; opaque or not, a mirror or not.
aMaterial :: Text -> Gen Material
aMaterial name = made <$> colour <*> coefficient <*> coefficient <*> coefficient <*> coefficient <*> coefficient <*> coefficient <*> shininess <*> index
  where
    made c ka kd ks kr kt p shine n =
      standard
        { materialName = name,
          materialColour = c,
          materialKa = ka,
          materialKd = kd,
          materialKs = ks,
          materialKr = kr,
          materialKt = kt,
          materialPlasticity = p,
          materialShininess = shine,
          materialRefractiveIndex = n
        }
    coefficient = frequency [(1, pure 0), (1, pure 1), (3, choose (0.05, 1))]
    shininess = oneof [elements [0, 1, 20, 200], choose (1, 200)]
    index = oneof [elements [1, 1.5, 0.7, 2.42], choose (1, 3)]

-- | What the generator of 'Small' must reach.
smallCorners :: Small -> [(String, Bool)]
smallCorners (Small scene r) =
  [ ("nothing is seen", all (== 0) colour'),
    ("many rays are followed", followed >= 8),
    ("many shadow rays are cast", shadows >= 8),
    ("something stands in the light", or [stopped l | l <- sceneLights scene]),
    ("the ray starts inside", any (maybe False (`contains` origin r) . prepare . primitiveShape) (scenePrimitives scene)),
    ("something is reflected or passes", or (zipWith (<) level1 colour')),
    ("waves are seen", or [any (> 0) c | l <- sceneLights scene, interferes l, let Plain c _ _ _ = plainly (single l) r])
  ]
  where
    Plain colour' followed shadows _ = plainly scene r
    Plain level1 _ _ _ = plainly (setLevel 1 scene) r
    single l = setLights [l] (setLevel 1 scene)
    -- A shadow ray is cast, and nothing comes back where a white surface would send something.
    stopped l = case plainly (setAlgorithm DiffuseOnly (setMaterials (\m -> m {materialColour = rgb 1 1 1, materialKd = 1}) (single l))) r of
      Plain c 1 1 _ -> all (== 0) c
      _ -> False

-------------------------------------------------------------------------------
-- Laws

-- | The loop sees what the recursion sees, to rounding, with as many rays.
--
-- Both follow the same rays to the bit, and a colour is a sum of products without cancellation; only the order of
-- roundings differs. What a light sends back past k shapes has at most 2 k + 6 of them on either side: the tints and
-- their product 2 k, the light times the filter 1, one of its terms 3, the sum of its terms 1, the attenuation 1. The
-- sum over n lights has n - 1 on either side. On each level the loop multiplies a weight twice; the recursion
-- multiplies twice, and adds twice. At the end the loop multiplies once, and adds up all rays. That is below 6 for each
-- level, 1 for each ray, 2 for each light, 4 for each shape, and 4. A highlight with a whole exponent is a power by
-- squaring here, which has as many as the exponent, and the library's power there, which has 2.
loopIsTheRecursion :: Small -> Property
loopIsTheRecursion (Small scene r) = within (roundings count) (channels c) plain .&&. (rays, cut) === (followed + shadows, cut')
  where
    Shown c rays cut = seen scene r
    Plain plain followed shadows cut' = plainly scene r
    count =
      6 * raytracerRecursiveLevel (sceneRaytracer scene)
        + followed
        + 2 * length (sceneLights scene)
        + 4 * length (scenePrimitives scene)
        + 4
        + maximum (0 : [exponent' + 2 | hasHighlights, m <- sceneMaterials scene, let exponent' = truncate (materialShininess m), fromIntegral exponent' == materialShininess m])
    hasHighlights = raytracerAlgorithm (sceneRaytracer scene) `elem` [Phong, Blinn, PhongSpecular, BlinnSpecular]

-- | How many roundings two sums over the lights and the rays differ by, where only the order of sums differs: for each
-- ray and each light one on either side, in the sums over them and, instead of their first terms, in the products with
-- the weights.
sumsOver :: Scene -> Ray -> Int
sumsOver scene r = 2 * (length (sceneLights scene) + followed)
  where
    Plain _ followed _ _ = plainly scene r

-- | What several lights give is the sum of what each gives alone: to the roundings of the sums.
lightsAddUp :: Small -> Property
lightsAddUp (Small scene r) =
  within (roundings (sumsOver scene r)) (colourOf scene r) (map sum (transposed [colourOf (setLights [l] scene) r | l <- sceneLights scene]))
  where
    transposed [] = [[], [], []]
    transposed rows = [map (!! k) rows | k <- [0 .. 2]]

-- | The order of the lights does not matter: to the roundings of the sums.
lightsHaveNoOrder :: Small -> Property
lightsHaveNoOrder (Small scene r) = forAll (shuffle (sceneLights scene)) $ \ls ->
  within (roundings (sumsOver scene r)) (colourOf (setLights ls scene) r) (colourOf scene r)

-- | Each reflexion algorithm gives the sum of its terms: to the roundings of the sums, and 5 more. Together two terms
-- of a light are added and then attenuated, apart each is attenuated; and three colours are added at the end. (Waves
-- count under every algorithm, and are left out here.)
termsAddUp :: Small -> Property
termsAddUp (Small scene' r) =
  conjoin [counterexample (show algorithm) (within (roundings (sumsOver scene r + 5)) (by algorithm) (foldr (zipWith (+) . by) [0, 0, 0] parts)) | (algorithm, parts) <- sums]
  where
    scene = setLights (filter (not . interferes) (sceneLights scene')) scene'
    by algorithm = colourOf (setAlgorithm algorithm scene) r
    sums =
      [ (NoSpecular, [AmbientOnly, DiffuseOnly]),
        (Blinn, [AmbientOnly, DiffuseOnly, BlinnSpecular]),
        (Phong, [AmbientOnly, DiffuseOnly, PhongSpecular])
      ]

-- | Waves give the same under all algorithms, but for the one without light.
wavesDisregardTheAlgorithm :: Small -> Property
wavesDisregardTheAlgorithm (Small scene' r) = conjoin [by algorithm === by Blinn | algorithm <- [minBound ..], algorithm /= NoLight]
  where
    scene = setLights (filter interferes (sceneLights scene')) scene'
    by algorithm = colourOf (setAlgorithm algorithm scene) r

interferes :: Light -> Bool
interferes l = case l of
  LinearAperture {} -> True
  PlanarAperture {} -> True
  _ -> False

-- | Lights twice as bright give a colour twice as bright, exactly. (No light of these is so weak that it counts as none
-- only once.)
twiceTheLightIsTwiceTheColour :: Small -> Property
twiceTheLightIsTwiceTheColour (Small scene r) = within 0 (colourOf (setLights (map twice (sceneLights scene)) scene) r) (map (* 2) (colourOf scene r))
  where
    twice l = case l of
      Ambient c -> Ambient (bright c)
      Directional c d -> Directional (bright c) d
      PointLight lamp -> PointLight lamp {lampColour = bright (lampColour lamp)}
      LinearAperture lamp w e -> LinearAperture lamp {lampAmplification = 2 * lampAmplification lamp} w e
      PlanarAperture o lamp w a -> PlanarAperture o lamp {lampAmplification = 2 * lampAmplification lamp} w a
    bright (Colour r' g b a) = Colour (2 * r') (2 * g) (2 * b) a

-- | At level 1 it does not matter whether anything is a mirror, and one ray is followed, with at most one shadow ray a
-- light.
levelOneHasNoBounces :: Small -> Property
levelOneHasNoBounces (Small scene r) = seen one r === seen (setMaterials (\m -> m {materialKr = 0}) one) r .&&. counterexample "rays" (shownRays (seen one r) <= 1 + length (sceneLights scene))
  where
    one = setLevel 1 scene

-- | Each level adds, and takes nothing away. That holds exactly: what a level adds comes in between, in one sum, and a
-- rounded sum never becomes less where its terms do not, nor by a term that is not negative.
levelsAdd :: Small -> Property
levelsAdd (Small scene r) = conjoin [counterexample (show n) (and (zipWith (<=) (at n) (at (n + 1)))) | n <- [1 .. 4]]
  where
    at n = colourOf (setLevel n scene) r

-- | Where nothing is a mirror, and what is transparent is not closed, the level does not matter, not a bit.
withoutMirrorsLevelsDoNotMatter :: Small -> Property
withoutMirrorsLevelsDoNotMatter (Small scene' r) = seen (setLevel 7 scene) r === seen (setLevel 1 scene) r
  where
    scene = setMaterials (\m -> m {materialKr = 0}) scene' {scenePrimitives = filter (maybe False (not . isClosed) . prepare . primitiveShape) (scenePrimitives scene')}

-- | Without lights everything is black, and all rays are followed all the same.
withoutLightsAllIsBlack :: Small -> Property
withoutLightsAllIsBlack (Small scene r) = channels (shownColour dark) === [0, 0, 0] .&&. shownRays dark === followed
  where
    dark = seen (setLights [] scene) r
    Plain _ followed _ _ = plainly scene r

-- | Ambient light takes no shadow rays, and is the same whatever stands around the surface: as if the first shape that
-- is met were alone.
ambientLightTakesNoShadowRays :: Small -> Property
ambientLightTakesNoShadowRays (Small scene' r) = shownRays here === 1 .&&. shownColour here `elem'` (Colour 0 0 0 1 : [shownColour (seen scene {scenePrimitives = [p]} r) | p <- scenePrimitives scene])
  where
    scene = setLevel 1 (setLights [l | l@(Ambient _) <- sceneLights scene'] scene')
    here = seen scene r
    elem' x xs = counterexample (show x) (x `elem` xs)

-- | Without light a ray sees kd times the colour of what it meets first, as opaque as that colour, or black; and no
-- other ray is cast.
noLightIsDiffuse :: Small -> Property
noLightIsDiffuse (Small scene' r) = seen scene r === Shown expected 1 False
  where
    scene = setAlgorithm NoLight scene'
    met = sortOn fst [(t, p) | p <- scenePrimitives scene, Just shape <- [prepare (primitiveShape p)], t <- take 1 (filter (> 1e-8) (parameters shape r)), t < farOf scene]
    expected = case met of
      [] -> Colour 0 0 0 1
      (_, p) : _ -> maybe (Colour 0 0 0 0) diffuse (find ((== primitiveMaterial p) . materialName) (sceneMaterials scene))
    diffuse m = let Colour r' g b a = materialColour m in Colour (materialKd m * r') (materialKd m * g) (materialKd m * b) a

-- | A lit picture is opaque, whatever the alphas of its colours.
litIsOpaque :: Small -> Property
litIsOpaque (Small scene r) = alpha (shownColour (seen scene r)) === 1

-- | A perfect mirror that sends nothing of its own shows what the reflected ray sees with one level less, exactly.
mirrorShowsWhatItFaces :: Small -> Property
mirrorShowsWhatItFaces = throughAMirror 1 $ \shown faced -> shown === faced

-- | A mirror with kr = 1\/4 shows a quarter of it, exactly.
mirrorIsWeighted :: Small -> Property
mirrorIsWeighted = throughAMirror 0.25 $ \shown faced -> within 0 shown (map (/ 4) faced)

-- | Puts a black mirror below the scene, and looks into it so that the reflected ray goes where the ray came from.
-- (Waves are seen on black surfaces too, and left out.)
throughAMirror :: Double -> ([Double] -> [Double] -> Property) -> Small -> Property
throughAMirror kr compared (Small scene' r) = case unit (origin r - foot) of
  Just up | met -> compared (colourOf (setLevel 5 scene) (incoming up)) (colourOf (setLevel 4 scene) (onwards up))
    where
      met = take 1 (sortOn fst [(t, i) | (i, p) <- zip [0 :: Int ..] (scenePrimitives scene), Just shape <- [prepare (primitiveShape p)], t <- take 1 (filter (> 1e-8) (parameters shape (incoming up)))]) `isOf` 0
  _ -> discard
  where
    foot = V3 0 0 (-10)
    mirror = standard {materialName = "mirror", materialKa = 0, materialKd = 0, materialKs = 0, materialKr = kr}
    scene = scene' {scenePrimitives = [Primitive "mirror" (APlane p) | Just p <- [plane foot (V3 0 0 1)]] ++ scenePrimitives scene', sceneMaterials = mirror : sceneMaterials scene', sceneLights = filter (not . interferes) (sceneLights scene')}
    -- From above the mirror, below all closed shapes, along the mirror image of the way to the ray's origin.
    incoming up = let V3 x y z = vector up in ray (foot - 2 *^ V3 x y (negate z)) (V3 x y (negate z))
    -- The mirror's ray, from where the incoming one meets it.
    onwards up = ray (position (incoming up) (parameterOf up)) (reflected (direction (incoming up)) alongZ)
    parameterOf up = case [t | p <- take 1 (scenePrimitives scene), Just shape <- [prepare (primitiveShape p)], t <- parameters shape (incoming up)] of
      t : _ -> t
      [] -> 0
    isOf [(_, i)] j = i == j
    isOf _ _ = False

-- | A slab of glass leaves a ray parallel to itself and displaces it by L sin (a - b) \/ cos b, as the textbook says: L
-- is the slab's thickness, a the angle of incidence, and sin a = n sin b.
--
-- What is seen behind it is a plane under three lamps in three colours, each of which falls off with the square of the
-- distance, so that a colour tells the place: with d the distance of a lamp, which is at least 4, by at most 3 \/ d and
-- 1 \/ 4 of itself for a step along the floor and off it.
--
-- The slab's normals are axes, so that the cosines of incidence are exact. Inside, the direction leans by 6 roundings,
-- and its length is wrong by as many. On the way out 1 - n^2 (1 - c^2) is wrong by 16 n^2 + 8 of them, and its root,
-- cos a, by 1 \/ (2 cos a) of that; the direction leans by this times sin a, and the floor is 2 below, so that the
-- place moves by 2 \/ cos^2 a times as much. The parameters and places of the four surfaces, up to 14 away, have some
-- 200, and the displacement by the textbook 25. The light of a lamp has 25 on either side.
slabDisplaces :: Property
slabDisplaces = forAll ((,,) <$> choose (0, 1.2) <*> choose (0, 2 * pi) <*> oneof [elements [1, 1.5, 2.42], choose (1.5, 3)]) $ \(a, turn, n) ->
  let b = asin (sin a / n)
      -- Across the slab, in the plane of incidence; and the way in, with the middle of the slab half way.
      h = V3 (cos turn) (sin turn) 0
      v = sin a *^ h - cos a *^ V3 0 0 1
      entry = V3 0 0 1 - tan b *^ h
      o = entry - 3 *^ v
      displaced = o + (2 * sin (a - b) / cos b) *^ (negate (cos a) *^ h - sin a *^ V3 0 0 1)
      slab = ["material", "name glass", "ka 0", "kd 0", "ks 0", "kt 1", "refractive_index " <> Text.pack (show n), "end", "primitive", "material_name glass", "cube", "size 2", "end", "end"]
      c = colourOf (sceneOf (slab ++ floor')) (ray o v)
      slack = roundings 320 + roundings 1 * (16 * n * n + 8) * tan a / (cos a * cos a)
   in (n > 1 || a < 0.7) ==> counterexample (show c) (all (> 0) c) .&&. within slack c (colourOf (sceneOf floor') (ray displaced v))
  where
    floor' =
      ["camera", "far_clipping_plane 1000", "end", "raytracer", "recursive_level 3", "reflexion_algorithm diffuse", "end"]
        ++ ["material", "name floor", "kd 1", "end", "primitive", "material_name floor", "plane", "position 0 0 -3", "end", "end"]
        ++ concat [["point_light", "color " <> c, "position " <> p, "constant_attenuator 0", "quadratic_attenuator 1", "end"] | (c, p) <- [("red", "9 0 1"), ("green", "-5 8 2"), ("blue", "-4 -9 3")]]

-- | What a shadow ray passes does not depend on the order of the shapes, up to roundings: each side multiplies at most
-- once for each shape.
passageHasNoOrder :: Small -> Property
passageHasNoOrder (Small scene r) = forAll ((,) <$> shuffle (scenePrimitives scene) <*> elements [1, 3, 1 / 0]) $ \(shapes, bound) ->
  let at these = transmittance (world Map.empty noModels scene {scenePrimitives = these}) r bound
   in counterexample (show (length shapes)) $
        case (at (scenePrimitives scene), at shapes) of
          (Transmittance a b c _, Transmittance a' b' c' _) -> within (roundings (2 * length shapes)) [a, b, c] [a', b', c']

colourOf :: Scene -> Ray -> [Double]
colourOf scene = channels . shownColour . seen scene
