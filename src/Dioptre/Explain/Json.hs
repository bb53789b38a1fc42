{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.Json
-- Description : The story of a pixel for programs
--
-- One object with everything that is told. Numbers are JSON numbers that read back to the same binary64; vectors are
-- arrays of three, colours
-- @[r, g, b]@; shapes, primitives, lights, triangles and samples count from 0. What is not there is absent, or @null@ where that is said.
--
-- > {"scene":"scene.txt", "column":0, "row":0, "width":500, "height":500,
-- >  "algorithm":"blinn", "level":1, "sampling":1, "far":100,
-- >  "samples":[{"offset":[0,0], "colour":[r,g,b], "rays":1, "cut":false, "ray":RAY}],      the first of many
-- >  "colour":[r,g,b], "normalized":[r,g,b], "pixel":[r,g,b,a]}             bytes
-- >
-- > RAY        {"cause":"camera"|"reflection"|"refraction", "depth":1, "origin", "direction", "weight":[r,g,b], "index",
-- >             "encounters":[ENCOUNTER], "notMet":n, "untold":n,          shapes that are only counted
-- >             "hit":HIT|null, "own":[r,g,b], "contribution":[r,g,b]}     own times weight
-- > SHAPE      {"number":n, "kind":"sphere", "transformed":false, "primitive":n, "material":"..."}
-- >            {"number":n, "kind":"triangle", "transformed":true, "model":n, "part":n, "file":"..."}
-- > ENCOUNTER  {"shape":SHAPE, "verdict":"closest"|"farther"|"asNear"|"parallel"|"noRoot"|"notOnShape"|"behind"|"tooNear"|"beyondFar", "t",
-- >             "frame":{"origin","direction"},                            in the shape's own frame
-- >             "moved":{"t0","k"},                                        t = (t0 + s) k
-- >             "conditions":[CONDITION],
-- >             "roots":[{"t", "condition":n, "fate":"kept"|"later"|"behind"|"tooNear"|"beyondFar"|"outside",
-- >                       "measured":{"distance","radius"} or {"distance","hole","radius"} or {"distance","innerRadius"} or {"t1","t2"} or {"height","length"}}]}
-- > CONDITION  {"of":"sphere", "degree":2, "coefficients":[{"name":"A","formula":"<d, d>","value"}], "letters":["w = o - C", ...], "discriminant", "shift"}
-- >            {"of":"faces x", "rate":{...}, "start":{...}, "low", "high"}      low <= start + rate t <= high
-- >            {"of":"reach", "distance", "reach"}
-- > HIT        {"shape":SHAPE, "t", "point", "outward", "normal", "uv":[u,v],
-- >             "surface":{"ambient","diffuse","specular","shininess","picture":false},
-- >             "lights":[LIGHT]|null,                                     null under no_light
-- >             "bounces":[BOUNCE]}
-- > LIGHT      {"light":n, "kind":"ambient"|"directional"|"point"|"waves", "colour",
-- >             "arrival":"everywhere"|"leftOut"|"nowhere"|"facesAway"|"shadow"|"arrives",
-- >             "direction", "distance", "attenuation", "cosine", "by":SHAPE, "byDistance", "through":[SHAPE], "filter":[r,g,b],
-- >             "terms":[{"term":"ambient"|"diffuse"|"blinn"|"phong"|"waves","colour"}], "total":[r,g,b]}
-- > BOUNCE     {"kind":"reflection"|"refraction", "coefficient", "angleIn",                        angles in radians
-- >             "n1", "n2", "entering",
-- >             "angleOut", "ray":RAY   or   "notFollowed":"depth"|"tooManyRays"|"totalReflection"|"noInside"}
module Dioptre.Explain.Json
  ( storyJson,
  )
where

import Data.Aeson (Value, object, toJSON, (.=))
import Data.Aeson.Types (Pair)
import Data.Text (Text)
import Dioptre.Explain.Story
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Light.Finish (Colours (..))
import Dioptre.Math.Vector (Vector, vector)
import Dioptre.Picture.Byte (Pixel (..))
import Dioptre.Scene.Raytracer (Raytracer (..), algorithmName)
import Dioptre.Syntax.Keyword (spelling)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | The story, with the name of the scene.
storyJson :: Text -> Story -> Value
storyJson name story =
  object
    [ "scene" .= name,
      "column" .= storyColumn story,
      "row" .= storyRow story,
      "width" .= fst (storySize story),
      "height" .= snd (storySize story),
      "algorithm" .= algorithmName (raytracerAlgorithm tracer),
      "level" .= raytracerRecursiveLevel tracer,
      "sampling" .= raytracerSampling tracer,
      "far" .= storyFar story,
      "samples" .= map sample (storySamples story),
      "colour" .= colour (storyColour story),
      "normalized" .= colour (storyNormalized story),
      "pixel" .= (let Pixel r g b a = storyPixel story in [r, g, b, a])
    ]
  where
    tracer = storyRaytracer story
    sample s =
      object
        [ "offset" .= (let (x, y) = sampleOffset s in [x, y]),
          "colour" .= colour (sampleColour s),
          "rays" .= sampleFollowed s,
          "cut" .= sampleCut s,
          "ray" .= ray (sampleRay s)
        ]

ray :: RayStory -> Value
ray r =
  object $
    [ "cause" .= case rayCause r of
        FromCamera -> "camera" :: Text
        ByReflection -> "reflection"
        ByRefraction -> "refraction",
      "depth" .= rayDepth r
    ]
      <> line (rayItself r)
      <> [ "weight" .= (let (x, y, z) = rayWeight r in [x, y, z]),
           "index" .= rayIndex r,
           "encounters" .= map encounter (rayEncounters r),
           "notMet" .= rayPassed r,
           "untold" .= rayUntold r,
           "hit" .= fmap hit (rayHit r),
           "own" .= colour (rayOwnColour r),
           "contribution" .= colour (rayContribution r)
         ]

line :: Ray -> [Pair]
line r = ["origin" .= vec (origin r), "direction" .= vec (direction r)]

shape :: Thing -> Value
shape thing =
  object $
    ["number" .= thingNumber thing, "kind" .= spelling (thingKind thing), "transformed" .= thingTransformed thing]
      <> case thingWhereabouts thing of
        OfScene i -> ["primitive" .= i]
        OfModel model part file -> ["model" .= model, "part" .= part] <> ["file" .= f | Just f <- [file]]
      <> ["material" .= m | Just m <- [thingMaterial thing]]

encounter :: Encounter -> Value
encounter e =
  object $
    ["shape" .= shape (encounterThing e), "verdict" .= verdict]
      <> ["t" .= t | Meets t _ <- [encounterVerdict e]]
      <> ["frame" .= object (line r) | Just r <- [equationRay equation]]
      <> ["moved" .= object ["t0" .= t0, "k" .= k] | Just (t0, k) <- [equationMoved equation]]
      <> ["conditions" .= map condition (equationConditions equation), "roots" .= map root (encounterRoots e)]
  where
    equation = encounterEquation e
    verdict = case encounterVerdict e of
      Meets _ IsClosest -> "closest" :: Text
      Meets _ IsFarther -> "farther"
      Meets _ IsAsNear -> "asNear"
      Misses Parallel -> "parallel"
      Misses NoRoot -> "noRoot"
      Misses NotOnShape -> "notOnShape"
      Misses IsBehind -> "behind"
      Misses IsTooNear -> "tooNear"
      Misses IsBeyondFar -> "beyondFar"

condition :: Condition -> Value
condition c = case c of
  PolynomialIsZero patch coefficients letters discriminant shift ->
    object $
      ["of" .= patchName patch, "degree" .= (length coefficients - 1), "coefficients" .= map coefficient coefficients, "letters" .= letters]
        <> ["discriminant" .= d | Just d <- [discriminant]]
        <> ["shift" .= shift | shift /= 0]
  LiesBetween patch a b low high -> object ["of" .= patchName patch, "rate" .= coefficient a, "start" .= coefficient b, "low" .= low, "high" .= high]
  PassesNear away reach -> object ["of" .= ("reach" :: Text), "distance" .= away, "reach" .= reach]
  where
    coefficient (Coefficient name formula x) = object ["name" .= name, "formula" .= formula, "value" .= x]

patchName :: Patch -> Text
patchName patch = case patch of
  ThePlane -> "plane"
  TheSphere -> "sphere"
  TheTube -> "tube"
  TheDoubleCone -> "cones"
  TheTorus -> "torus"
  TheEnds -> "ends"
  TheFaces axis -> "faces " <> axis
  TheStartFace -> "face at start"
  TheEndFace -> "face at end"

root :: Root -> Value
root r = object (["t" .= rootParameter r, "condition" .= rootCondition r, "fate" .= fate] <> ["measured" .= object m | m@(_ : _) <- [measured]])
  where
    fate = case rootFate r of
      Taken -> "kept" :: Text
      Later -> "later"
      Behind -> "behind"
      TooNear -> "tooNear"
      BeyondFar -> "beyondFar"
      Outside -> "outside"
    measured = case rootMeasure r of
      AwayFromCentre away radius -> ["distance" .= away, "radius" .= radius]
      InTheHole away radius -> ["distance" .= away, "innerRadius" .= radius]
      OnTheRing away hole radius -> ["distance" .= away, "hole" .= hole, "radius" .= radius]
      Barycentric t1 t2 -> ["t1" .= t1, "t2" .= t2]
      AtHeight height len -> ["height" .= height, "length" .= len]
      SideOfDisk -> []
      OtherConditions -> []

hit :: Hit -> Value
hit h =
  object
    [ "shape" .= shape (hitThing h),
      "t" .= hitParameter h,
      "point" .= vec (hitPoint h),
      "outward" .= vec (vector (hitOutward h)),
      "normal" .= vec (vector (hitNormal h)),
      "uv" .= (let V2 u v = hitUv h in [u, v]),
      "surface"
        .= object
          [ "ambient" .= colour (ambientOf colours),
            "diffuse" .= colour (diffuseOf colours),
            "specular" .= colour (specularOf colours),
            "shininess" .= shininessOf colours,
            "picture" .= hitHasPicture h
          ],
      "lights" .= fmap (map share) (hitShares h),
      "bounces" .= map bounce (hitBounces h)
    ]
  where
    colours = hitColours h

share :: Share -> Value
share s =
  object $
    ["light" .= shareLight s, "kind" .= kind, "colour" .= colour (shareColour s), "arrival" .= arrival]
      <> details
      <> ["terms" .= [object ["term" .= term t, "colour" .= colour c] | (t, c) <- shareTerms s], "total" .= colour (shareTotal s)]
  where
    kind = case shareKind s of
      AmbientKind -> "ambient" :: Text
      DirectionalKind -> "directional"
      PointKind -> "point"
      WaveKind -> "waves"
    (arrival, details) = case shareArrival s of
      FromAllSides -> ("everywhere" :: Text, [])
      LeftOut -> ("leftOut", [])
      Nowhere -> ("nowhere", [])
      FacesAway way -> ("facesAway", approach way)
      InShadow way by -> ("shadow", approach way <> concat [["by" .= shape thing, "byDistance" .= t] | Just (thing, t) <- [by]])
      Arrives way open through -> ("arrives", approach way <> ["through" .= map shape through | not (null through)] <> ["filter" .= [red open, green open, blue open] | not (null through)])
    approach way =
      ["direction" .= vec (approachDirection way)]
        <> ["distance" .= far | Just far <- [approachDistance way]]
        <> ["attenuation" .= approachFactor way, "cosine" .= approachCosine way]
    term t = case t of
      AmbientTerm -> "ambient" :: Text
      DiffuseTerm -> "diffuse"
      BlinnTerm -> "blinn"
      PhongTerm -> "phong"
      WaveTerm -> "waves"

bounce :: Bounce -> Value
bounce b =
  object $
    kind
      <> ["coefficient" .= bounceCoefficient b, "angleIn" .= bounceAngleIn b]
      <> case bounceSequel b of
        Followed angleOut next -> ["angleOut" .= angleOut, "ray" .= ray next]
        NotFollowed obstacle ->
          [ "notFollowed" .= case obstacle of
              DepthReached -> "depth" :: Text
              TooManyRays -> "tooManyRays"
              TotalReflection -> "totalReflection"
              NoInside -> "noInside"
          ]
  where
    kind = case bounceKind b of
      Reflection -> ["kind" .= ("reflection" :: Text)]
      Refraction n1 n2 enters -> ["kind" .= ("refraction" :: Text), "n1" .= n1, "n2" .= n2, "entering" .= enters]

vec :: Vector -> Value
vec (V3 x y z) = toJSON [x, y, z]

colour :: Colour -> Value
colour (Colour r g b _) = toJSON [r, g, b]
