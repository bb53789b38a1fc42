-- |
-- Module      : Dioptre.Explain.Tell
-- Description : From a scene and a pixel to its story
--
-- The renderer's own functions, asked one by one: the closest hit, the normal, the light of each source alone, what
-- stands in the way, the reflected and the refracted direction. What "Dioptre.Render.Radiance" adds up in a loop is
-- kept here as a tree, whose rays are followed in the same order and whose parts are added up in that order, so that
-- the colour told is the colour rendered, bit for bit (a law).
module Dioptre.Explain.Tell
  ( tell,

    -- * Limits
    mostListed,
    mostTried,
    mostKept,
  )
where

import Data.List (foldl', sortOn)
import Data.Maybe (fromMaybe, isNothing, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Vector as Vector
import Dioptre.Explain.Origin (Directory, Found (..), directory, find)
import Dioptre.Explain.Polynomial (Candidate (..), equationOf)
import Dioptre.Explain.Story
import Dioptre.Geometry.Closest (Closest (..))
import Dioptre.Geometry.Prepared (isClosed, nearest, normalAt, parameters, shadingNormal, textureAt)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Light.Attenuation (attenuated)
import Dioptre.Light.Colour (Colour (..), black, capped, plus, rgb, scaled)
import Dioptre.Light.Finish (Colours (..), Finish (..), hasPictures, isTransparent)
import Dioptre.Math.Tolerance (smallestParameter)
import Dioptre.Math.Vector (Point, Unit, Vector, angle, dot, modulus, opposite, packed, packedUnit, unpacked, vector, (^/))
import Dioptre.Model.Library (Library)
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Dioptre.Picture.Byte (normalized, pixelOf)
import Dioptre.Render.Closest (closest)
import Dioptre.Render.Obstacles (Obstacles (..), obstacles)
import Dioptre.Render.Sampling (offset)
import Dioptre.Render.Shade (Lit (..), coloursAt, lighting)
import Dioptre.Render.Stage
import Dioptre.Render.Surface (Surface (..), surfaceAt)
import Dioptre.Render.Surroundings (refractiveIndexAt)
import Dioptre.Render.Texture (Assets, Texture)
import Dioptre.Render.Transmittance (Transmittance (..), farthest, past)
import Dioptre.Render.View (rayThrough, view, viewFar, viewWidth)
import Dioptre.Render.World (worldOwn, worldSize)
import Dioptre.Scene (Scene, sceneCamera, sceneRaytracer, sceneViewport)
import Dioptre.Scene.Camera (viewportHeight, viewportWidth)
import Dioptre.Scene.Raytracer (Raytracer (..), mostRays)

-- | What all rays of a story have in common.
data Setting = Setting
  { stageOf :: Stage,
    far :: Double,
    shapes :: Directory Texture
  }

-- | Where there are more shapes than this, those that a ray's line does not meet are counted, and not told one by one.
mostListed :: Int
mostListed = 40

-- | Only the first rays of a sample are tried on every shape: as many as make this many trials. The others tell what
-- they hit, and the first one also of the scene's first primitives.
mostTried :: Int
mostTried = 200000

-- | Of a pixel of many samples the first are kept, until they have this many rays together. The others are only counted
-- in: a scene may ask for 2^31 samples, and nobody reads as many.
mostKept :: Int
mostKept = 4000

-- | The story of the pixel at a column and a row of a scene's picture, counted from 0 at the top left; 'Nothing'
-- outside of the picture. Given the pictures and models that the scene uses, and the names of the models' files by
-- their numbers in the library.
--
-- Law: its colour is the one that 'Dioptre.Render.Row.colourAt' has, to the bit.
--
-- Cost: that of rendering the pixel, and for each ray whose encounters are looked at, an equation for every shape, up
-- to 'mostTried' of them.
--
-- Spec: cli.explain.
tell :: Assets -> [Text] -> Library Texture -> Scene -> Int -> Int -> Maybe Story
tell assets files library scene column row
  | column < 0 || row < 0 || column >= width || row >= height = Nothing
  | otherwise =
    Just
      Story
        { storyColumn = column,
          storyRow = row,
          storySize = (width, height),
          storyRaytracer = tracer,
          storyFar = far setting,
          storyShapes = worldSize (stageWorld (stageOf setting)),
          storyLights = Vector.length (stageSources (stageOf setting)),
          storySamples = kept,
          storySeesNothing = seesNothing,
          storyColour = colour,
          storyNormalized = normalized (raytracerColourNormalization tracer) colour,
          storyPixel = pixelOf (raytracerColourNormalization tracer) colour
        }
  where
    width = viewportWidth (sceneViewport scene)
    height = viewportHeight (sceneViewport scene)
    tracer = sceneRaytracer scene
    v = view (sceneCamera scene) (sceneViewport scene)
    setting = Setting (stage assets library scene) (viewFar v) (directory files library scene)
    cast = raytracerSampling tracer
    sample k = sampleOf setting (at k) (through (at k))
    kept = keptFrom 0 0
    keptFrom k rays
      | k < cast && rays < mostKept = let s = sample k in s : keptFrom (k + 1) (rays + sampleFollowed s)
      | otherwise = []
    at = offset tracer (viewWidth v) column row
    through (dx, dy) = rayThrough v (fromIntegral column + dx) (fromIntegral row + dy)
    colour = case kept of
      [only] | cast == 1 -> sampleColour only
      _ -> scaled (1 / fromIntegral cast) total
    -- What is not kept is let go as soon as it is added.
    Totals total seesNothing = foldl' with (foldl' with (Totals black True) kept) (map sample [length kept .. cast - 1])
    with (Totals c dark) s = Totals (plus c (sampleColour s)) (dark && isNothing (rayHit (sampleRay s)))

-- | The sum of some samples' colours, and whether none of their rays meets anything.
data Totals = Totals !Colour !Bool

-- | The story of one ray through a pixel.
sampleOf :: Setting -> (Double, Double) -> Ray -> Sample
sampleOf setting at r =
  Sample
    { sampleOffset = at,
      sampleRay = story,
      sampleColour = case stageTerms (stageOf setting) of
        Nothing -> rayOwnColour story
        Just _ -> foldl' plus black (map rayContribution (allRays story)),
      sampleFollowed = followed,
      sampleCut = cut
    }
  where
    (Count followed cut, story) = follow setting FromCamera 1 (1, 1, 1) (refractiveIndexAt (stageWorld (stageOf setting)) Nothing (origin r)) r (Count 0 False)

-- | A ray and all that come from it, in the order in which they are followed.
allRays :: RayStory -> [RayStory]
allRays story = from story []
  where
    from r rest = r : foldr from rest [next | Just hit <- [rayHit r], Bounce {bounceSequel = Followed _ next} <- hitBounces hit]

-- | How many rays have been followed, and whether more were wanted.
data Count = Count !Int !Bool

-- | Follows a ray, and what comes of it.
follow :: Setting -> Cause -> Int -> (Double, Double, Double) -> Double -> Ray -> Count -> (Count, RayStory)
follow setting cause depth weight@(wr, wg, wb) index r (Count before cut) =
  ( after,
    RayStory
      { rayCause = cause,
        rayDepth = depth,
        rayItself = r,
        rayWeight = weight,
        rayIndex = index,
        rayEncounters = told,
        rayPassed = passed,
        rayUntold = untold,
        rayHit = hit,
        rayOwnColour = own,
        rayContribution = Colour (wr * red own) (wg * green own) (wb * blue own) 1
      }
  )
  where
    st = stageOf setting
    Closest t number _ = closest (stageWorld st) r (far setting)
    (told, passed, untold) = encounters setting before r t number
    struck = (,) <$> surfaceAt (stageWorld st) number <*> find (shapes setting) number
    (after, hit, own) = case struck of
      Nothing -> (Count (before + 1) cut, Nothing, black)
      Just (surface@(Surface shape f), found) ->
        let p = position r t
            outward = normalAt shape r t
            n = shadingNormal r outward
            colours = coloursAt surface r t
            (count, bounces) = case stageTerms st of
              Nothing -> (Count (before + 1) cut, [])
              Just _ -> bouncesOf setting depth weight index surface r p outward n number (Count (before + 1) cut)
            colour = case stageTerms st of
              Nothing -> diffuseOf colours
              Just terms -> litColour (lighting st terms colours (packed p) (packedUnit n) (packed (direction r)))
         in ( count,
              Just
                Hit
                  { hitThing = foundThing found,
                    hitParameter = t,
                    hitPoint = p,
                    hitOutward = outward,
                    hitNormal = n,
                    hitUv = textureAt shape r t,
                    hitColours = colours,
                    hitHasPicture = hasPictures f,
                    hitShares = (\terms -> sharesOf setting terms colours p n (direction r)) <$> stageTerms st,
                    hitBounces = bounces
                  },
              colour
            )

litColour :: Lit -> Colour
litColour (Lit r g b _ _) = Colour r g b 1

-------------------------------------------------------------------------------
-- Encounters

-- | What a ray was tried on, given what it meets first and how many rays were followed before it: the encounters told,
-- how many shapes were left out as the ray's line does not meet them, and how many were not looked at.
encounters :: Setting -> Int -> Ray -> Double -> Int -> ([Encounter], Int, Int)
encounters setting before r t number
  | toInteger (before + 1) * toInteger size > toInteger mostTried =
    let some = [i | before == 0, i <- [0 .. min mostListed (worldOwn w) - 1]] <> [number | number >= (if before == 0 then min mostListed (worldOwn w) else 0)]
     in (mapMaybe (encounter setting r t number) some, 0, size - length some)
  | size > mostListed = let listed = filter isMet everything in (listed, size - length listed, 0)
  | otherwise = (everything, 0, 0)
  where
    w = stageWorld (stageOf setting)
    size = worldSize w
    everything = mapMaybe (encounter setting r t number) [0 .. size - 1]
    isMet e = case encounterVerdict e of
      Misses NotOnShape -> False
      Misses NoRoot -> False
      Misses Parallel -> False
      _ -> True

-- | A ray tried on the shape of a number, given the parameter and the number of what it meets first.
encounter :: Setting -> Ray -> Double -> Int -> Int -> Maybe Encounter
encounter setting r bestT best number = do
  Surface shape _ <- surfaceAt (stageWorld (stageOf setting)) number
  found <- find (shapes setting) number
  let (equation, candidates) = equationOf (foundFrames found) (foundShape found) r
      meetings = parameters shape r
      first = nearest shape r (far setting)
      met = first < far setting
      fate (Candidate t place measure) = Root t place measure $ case () of
        _
          | t `notElem` meetings -> Outside
          | met && t == first -> Taken
          | t < 0 -> Behind
          | t <= smallestParameter -> TooNear
          | t >= far setting -> BeyondFar
          | otherwise -> Later
      verdict
        | met = Meets first (if number == best then IsClosest else if first > bestT then IsFarther else IsAsNear)
        | null meetings = Misses (missOf candidates equation)
        | any (>= far setting) meetings = Misses IsBeyondFar
        | any (>= 0) meetings = Misses IsTooNear
        | otherwise = Misses IsBehind
  pure (Encounter (foundThing found) equation (sortOn rootParameter (map fate candidates)) verdict)
  where
    missOf candidates equation
      | not (null candidates) = NotOnShape
      | [PolynomialIsZero ThePlane _ _ _ _] <- equationConditions equation = Parallel
      | otherwise = NoRoot

-------------------------------------------------------------------------------
-- Light

-- | What each light gives at a point, with the normal turned against the ray, seen in a direction.
sharesOf :: Setting -> Terms -> Colours -> Point -> Unit -> Vector -> [Share]
sharesOf setting terms colours p n v = zipWith share [0 ..] (Vector.toList (stageSources st))
  where
    st = stageOf setting
    -- The light of one source alone, with these terms.
    alone source these = litColour (lighting st {stageSources = Vector.singleton source} these colours (packed p) (packedUnit n) (packed v))
    share i source = Share i kind colour arrival (if arrives then termsFrom else []) (alone source terms)
      where
        (kind, colour, arrival) = case source of
          FromEverywhere c -> (AmbientKind, c, if termAmbient terms then FromAllSides else LeftOut)
          FromFar c d -> (DirectionalKind, c, arrivalOf setting p (Approach (unpacked d) Nothing 1 (cosine (unpacked d))))
          FromPoint c place weaker -> (PointKind, c, fromPlace (unpacked place) weaker)
          FromWaves c place weaker _ _ -> (WaveKind, c, fromPlace (unpacked place) weaker)
        arrives = case arrival of
          FromAllSides -> True
          Arrives {} -> True
          _ -> False
        termsFrom = case kind of
          AmbientKind -> [(AmbientTerm, alone source terms)]
          WaveKind -> [(WaveTerm, alone source terms)]
          _ ->
            [(DiffuseTerm, alone source (Terms False True NoHighlight)) | termDiffuse terms]
              <> case termHighlight terms of
                NoHighlight -> []
                BlinnHighlight -> [(BlinnTerm, alone source (Terms False False BlinnHighlight))]
                PhongHighlight -> [(PhongTerm, alone source (Terms False False PhongHighlight))]
    cosine d = negate (dot (vector n) d)
    fromPlace place weaker = case attenuated weaker away of
      Nothing -> Nowhere
      Just factor -> let d = between ^/ away in arrivalOf setting p (Approach d (Just away) factor (cosine d))
      where
        between = p - place
        away = modulus between

-- | How light comes to a point along a way.
arrivalOf :: Setting -> Point -> Approach -> Arrival
arrivalOf setting p way
  | approachCosine way <= 0 = FacesAway way
  | obstaclesOpaque between = InShadow way (blocker setting shadow distance')
  | Transmittance r g b _ <- past between = Arrives way (rgb r g b) [foundThing found | (i, _) <- sortOn fst (obstaclesTransparent between), Just found <- [find (shapes setting) i]]
  where
    shadow = ray p (negate (approachDirection way))
    between = obstacles (stageWorld (stageOf setting)) shadow distance'
    distance' = fromMaybe farthest (approachDistance way)

-- | What lets nothing through on the way of a shadow ray, and where: the nearest such shape, or, behind transparent
-- ones, the first in number.
blocker :: Setting -> Ray -> Double -> Maybe (Thing, Double)
blocker setting shadow bound = case closest w shadow bound of
  Closest t i _
    | isOpaque i -> named i t
    | otherwise -> listToMaybe [(j, t') | j <- [0 .. min mostTried (worldSize w) - 1], isOpaque j, Just (Surface shape _) <- [surfaceAt w j], let { t' = nearest shape shadow bound }, t' < bound] >>= uncurry named
  where
    w = stageWorld (stageOf setting)
    isOpaque i = case surfaceAt w i of
      Just (Surface _ f) -> not (isTransparent f)
      Nothing -> False
    named i t = (\found -> (foundThing found, t)) <$> find (shapes setting) i

-------------------------------------------------------------------------------
-- Bounces

-- | The rays that a surface throws back and lets pass, the reflected one first.
bouncesOf :: Setting -> Int -> (Double, Double, Double) -> Double -> Surface -> Ray -> Point -> Unit -> Unit -> Int -> Count -> (Count, [Bounce])
bouncesOf setting depth (wr, wg, wb) index (Surface shape f) r p outward n number count = (atLast, mirrored <> through)
  where
    st = stageOf setting
    v = direction r
    angleIn = angle (negate v) (vector n)
    kr = finishMirror f
    kt = finishTransparency f
    leaving = dot v (vector outward) > 0
    beyond = if leaving then refractiveIndexAt (stageWorld st) (Just number) p else finishIndex f
    passes
      | leaving = (kt * wr, kt * wg, kt * wb)
      | otherwise = let Colour tr tg tb _ = finishTint f in (capped (tr * wr), capped (tg * wg), capped (tb * wb))
    (between, mirrored)
      | kr == 0 = (count, [])
      | otherwise = Bounce Reflection kr angleIn `first` going ByReflection (kr * wr, kr * wg, kr * wb) index (vector n) (reflected v n) count
    (atLast, through)
      | not (isTransparent f) = (between, [])
      | not (isClosed shape) = (between, [bounce (NotFollowed NoInside)])
      | otherwise = case refracted v n index beyond of
        Nothing -> (between, [bounce (NotFollowed TotalReflection)])
        Just v' -> bounce `first` going ByRefraction passes beyond (vector (opposite n)) v' between
    bounce = Bounce (Refraction index beyond (not leaving)) kt angleIn
    deeper = depth < stageDepth st
    first make (c, sequel) = (c, [make sequel])
    -- A ray that goes on from here, with the normal on its side of the surface.
    going cause weight index' side v' c@(Count before _)
      | not deeper = (c, NotFollowed DepthReached)
      | before >= mostRays = (Count before True, NotFollowed TooManyRays)
      | otherwise = let (c', next) = follow setting cause (depth + 1) weight index' (ray p v') c in (c', Followed (angle v' side) next)
