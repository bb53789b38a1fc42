{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Story
-- Description : What is true of the stories of pixels
--
-- A story must tell what the renderer does, to the bit; and what it tells must hold by itself: roots solve the
-- equations beside them, terms follow from the distances, angles and filters beside them, parts make the sum.
module Laws.Story
  ( -- * What the laws are tried with
    Pictured (..),
    picturedCorners,

    -- * The renderer's numbers
    colourIsTheRenderers,
    coloursOfModelsAreTheRenderers,
    coloursOfSketchesAreTheRenderers,
    asManyRaysAsCast,

    -- * Shapes
    shapesAreTheWorlds,
    parametersAreRoots,
    parametersOfShortAxesAreRoots,
    rootsSolve,
    verdictsAccountForTheHit,

    -- * Light
    sharesAreTheSum,
    sharesFollowFromTheirWays,
    bouncesObeyTheLaws,

    -- * Parts of stories
    raysOf,
  )
where

import Data.Bifunctor (bimap)
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, maybeToList)
import qualified Data.Vector.Storable as Storable
import Dioptre.Explain.Origin (Found (..), directory, find)
import Dioptre.Explain.Polynomial (Candidate (..), equationOf)
import Dioptre.Explain.Story
import Dioptre.Explain.Tell (tell)
import Dioptre.Geometry.Axis (axis, roundShape)
import Dioptre.Geometry.Lens (lens)
import Dioptre.Geometry.Placement (carriedBack)
import Dioptre.Geometry.Prepared (parameters, placedIn, prepare)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Triangle (Corners (..), Triangle, barycentric, smoothTriangleFlat, trianglePoints)
import Dioptre.Light.Colour (Colour (..), black, plus)
import Dioptre.Light.Finish (Colours (..))
import Dioptre.Light.Material (Material (..), Textures (..))
import Dioptre.Math.Transform (placement)
import Dioptre.Math.Vector (cross, dot, modulus, quadrance, vector, (*^))
import Dioptre.Model.Library (Library, noModels)
import Dioptre.Picture (picture)
import Dioptre.Picture.Byte (Pixel (..))
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row (Row (..), colourAt, plan, row)
import Dioptre.Render.Surface (Surface (..), surfaceAt)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.Texture (Assets, Texture)
import Dioptre.Render.World (world, worldSize)
import Dioptre.Scene (writeScene)
import Dioptre.Scene.Camera (CameraSettings (..), camera, cameraSettings, viewport, viewportHeight, viewportWidth)
import Dioptre.Scene.Raytracer (Raytracer (..), ReflexionAlgorithm (..))
import Dioptre.Scene.Unchecked (Scene (..))
import Laws.Draw (Kind (..), axisStep, point)
import Laws.Shade (Small (..), roundings, setAlgorithm, within)
import Laws.Sketch (Sketch (..), sketchScene)
import Laws.World (Modelled (..))
import Linear.V3 (V3 (..))
import Numeric (expm1)
import Test.QuickCheck hiding (Small, vector, within)

-- | A scene with pictures, and a pixel of it.
data Pictured = Pictured Scene Assets Int Int

instance Show Pictured where
  show (Pictured scene _ x y) = show (x, y) <> "\n" <> show (writeScene scene)

instance Arbitrary Pictured where
  arbitrary = do
    Small scene0 r <- arbitrary
    noLight <- frequency [(5, pure False), (1, pure True)]
    papered <- arbitrary
    names <- vectorOf (length (sceneMaterials scene0)) (Textures <$> elements [Just "p", Nothing] <*> elements [Just "p", Just "q"] <*> elements [Just "q", Nothing])
    n <- elements [1, 1, 2, 3]
    coordinate <- elements [minBound .. maxBound]
    normalization <- elements [minBound .. maxBound]
    size <- (,) <$> chooseInt (1, 4) <*> chooseInt (1, 4)
    bytes <- vectorOf 16 arbitrary
    away <- elements [0.5, 1, 3]
    let scene1 = (if noLight then setAlgorithm NoLight else id) scene0
        tracer = (sceneRaytracer scene1) {raytracerSampling = n, raytracerPixelCoordinate = coordinate, raytracerColourNormalization = normalization}
        settings up = (cameraSettings (sceneCamera scene1)) {settingPosition = origin r - away *^ direction r, settingLookAt = origin r + direction r, settingUp = up, settingAngle = 10}
        cameras = [c | up <- [V3 0 0 1, V3 0 1 0, V3 1 0 0], Right c <- [camera (settings up)]]
        assets = Map.fromList [("p", picture 2 (Storable.fromList bytes)), ("q", picture 4 (Storable.fromList (reverse bytes)))]
    case (cameras, uncurry viewport size "image") of
      (c : _, Right port) ->
        Pictured
          scene1
            { sceneRaytracer = tracer,
              sceneCamera = c,
              sceneViewport = port,
              sceneMaterials = if papered then zipWith (\t m -> m {materialTextures = Just t}) names (sceneMaterials scene1) else sceneMaterials scene1
            }
          assets
          <$> chooseInt (0, fst size - 1)
          <*> chooseInt (0, snd size - 1)
      _ -> arbitrary

-- | What the examples hold.
picturedCorners :: Pictured -> [(String, Bool)]
picturedCorners p =
  [ ("a ray is thrown back", or [True | r <- rays, rayCause r == ByReflection]),
    ("a ray passes", or [True | r <- rays, rayCause r == ByRefraction]),
    ("total reflection", or [True | h <- hits, Bounce {bounceSequel = NotFollowed TotalReflection} <- hitBounces h]),
    ("a shadow", or [True | s <- shares, InShadow _ (Just _) <- [shareArrival s]]),
    ("a tinted light", or [True | s <- shares, Arrives _ _ (_ : _) <- [shareArrival s]]),
    ("a picture", any hitHasPicture hits),
    ("several samples", length (storySamples story) > 1),
    ("no light", or [True | h <- hits, Nothing <- [hitShares h]]),
    ("nothing is met", or [True | r <- rays, Nothing <- [rayHit r]])
  ]
  where
    story = storyOf p
    rays = concatMap (raysOf . sampleRay) (storySamples story)
    hits = [h | r <- rays, Just h <- [rayHit r]]
    shares = concat [s | h <- hits, Just s <- [hitShares h]]

storyOf :: Pictured -> Story
storyOf (Pictured scene assets x y) = told assets noModels scene x y

told :: Assets -> Library Texture -> Scene -> Int -> Int -> Story
told assets library scene x y = case tell assets [] library scene x y of
  Just story -> story
  Nothing -> error "no such pixel"

-- | A ray and all that come from it, in the order in which they are followed.
raysOf :: RayStory -> [RayStory]
raysOf story = from story []
  where
    from r rest = r : foldr from rest [next | Just h <- [rayHit r], Bounce {bounceSequel = Followed _ next} <- hitBounces h]

-------------------------------------------------------------------------------
-- The renderer's numbers

sameColour :: Assets -> Library Texture -> Scene -> Int -> Int -> Property
sameColour assets library scene x y =
  storyColour story === colour
    .&&. Storable.toList (Storable.slice (4 * x) 4 (rowBytes (row p y))) === (let Pixel r g b a = storyPixel story in [r, g, b, a])
  where
    story = told assets library scene x y
    p = plan assets library scene
    Seen colour _ = colourAt p x y

-- | The colour of a story is that of the renderer, bit for bit, and so are its bytes: through mirrors and glass, with
-- pictures, with several rays a pixel.
colourIsTheRenderers :: Pictured -> Property
colourIsTheRenderers (Pictured scene assets x y) = sameColour assets noModels scene x y

-- | The same in scenes with models.
coloursOfModelsAreTheRenderers :: Modelled -> Property
coloursOfModelsAreTheRenderers (Modelled scene library _ _) =
  forAll ((,) <$> chooseInt (0, viewportWidth (sceneViewport scene) - 1) <*> chooseInt (0, viewportHeight (sceneViewport scene) - 1)) (uncurry (sameColour mempty library scene))

-- | The same for sketches, every pixel, and there is no story outside of the picture.
coloursOfSketchesAreTheRenderers :: Sketch -> Property
coloursOfSketchesAreTheRenderers unlit = forAll arbitrary $ \lit ->
  let scene = sketchScene unlit {sketchIsLit = lit}
      (w, h) = sketchSize unlit
      exists x y = isJust (tell mempty [] noModels scene x y)
   in conjoin [sameColour mempty noModels scene x y | x <- [0, w - 1], y <- [0 .. h - 1]]
        .&&. [(x, y) | (x, y) <- [(-1, 0), (0, -1), (w, 0), (0, h), (0, 0), (w - 1, h - 1)], exists x y] === [(0, 0), (w - 1, h - 1)]

-- | As many rays are told, shadow rays among them, as the renderer casts, and it is told whether more were wanted.
asManyRaysAsCast :: Pictured -> Property
asManyRaysAsCast p@(Pictured scene assets x y) =
  (sum (map sampleFollowed samples) + length shadowRays, length (filter sampleCut samples)) === (rays, cut)
    .&&. map (length . raysOf . sampleRay) samples === map sampleFollowed samples
  where
    samples = storySamples (storyOf p)
    shadowRays = [() | s <- samples, r <- raysOf (sampleRay s), Just h <- [rayHit r], Just shares <- [hitShares h], share <- shares, casts (shareArrival share)]
    casts arrival = case arrival of
      InShadow _ _ -> True
      Arrives {} -> True
      _ -> False
    Seen _ (Tally rays _ cut) = colourAt (plan assets noModels scene) x y

-------------------------------------------------------------------------------
-- Shapes

-- | What is found under a number is what the world has there: whatever has no number there is not found, and a ray
-- meets both at the same parameters, to the bit. (Corners' normals may be made unit once or twice.)
shapesAreTheWorlds :: Modelled -> Property
shapesAreTheWorlds (Modelled scene library r _) =
  [parameters (foldr placedIn shape (foundFrames f)) r | Just f <- founds, Just shape <- [prepare (foundShape f)]] === [parameters shape r | Just (Surface shape _) <- map (surfaceAt w) [0 .. worldSize w - 1]]
    .&&. [thingNumber (foundThing f) | Just f <- founds] === [0 .. worldSize w - 1]
    .&&. map (fmap foundThing . find shapes) [-1, worldSize w] === [Nothing, Nothing]
  where
    w = world mempty library scene
    shapes = directory [] library scene
    founds = map (find shapes) [0 .. worldSize w - 1]

-- | Every parameter at which the renderer meets a shape is a root of one of its conditions, to the bit.
parametersAreRoots :: Modelled -> Property
parametersAreRoots (Modelled scene library r _) =
  conjoin
    [ counterexample (show (thingKind (foundThing f), ts)) (all (`elem` [t | Candidate t _ _ <- snd (equationOf (foundFrames f) (foundShape f) r)]) ts)
      | n <- [0 .. worldSize w - 1],
        Just f <- [find shapes n],
        Just (Surface shape _) <- [surfaceAt w n],
        let ts = parameters shape r
    ]
  where
    w = world mempty library scene
    shapes = directory [] library scene

-- | The same for shapes on an axis so short that the square of its length is rounded, or vanishes: a ray that starts in
-- the plane of its start meets its ends at parameters as small as it is.
parametersOfShortAxesAreRoots :: Property
parametersOfShortAxesAreRoots =
  forAll (axisStep Few) $ \end -> forAll (choose (-320, -140)) $ \size -> forAll ((10 **) <$> choose (-10, 1)) $ \radius -> forAll ((,) <$> start end <*> point Few) $ \(o, d) ->
    d /= 0
      ==> let bodies = [body | Just a <- [axis 0 ((10 ** size) *^ end)], Just body <- [roundShape a radius]]
              shapes = concat [[ATube body, ACylinder body, ACone body] ++ map ALens (maybeToList (lens body (2 * radius, 3 * radius))) | body <- bodies]
              r = ray (radius *^ o) d
              ends s = maybe [] (`parameters` r) (prepare s)
           in cover 20 (any (any (\t -> t /= 0 && abs t < 1e-130) . ends) shapes) "meets both ends" $
                conjoin [counterexample (show (s, ends s)) (all (`elem` [t | Candidate t _ _ <- snd (equationOf [] s r)]) (ends s)) | s <- shapes]
  where
    -- Across the axis, and so near to it that the ray starts within most radii.
    start end = (\v -> (1 / 16) *^ (v * fmap (\x -> if x == 0 then 1 else 0) end)) <$> point Few

-- | Every root that is told solves the condition that it is told with, to rounding.
--
-- A root of the second degree is within 4 units of the exact one, so that the residual is within 8 2^-53 of the sum of
-- the absolute terms, each times its degree; the product with the shift and scale, and the sum with t0, add three
-- roundings of the numbers there, which the slope multiplies. Roots of the fourth degree have residuals of some 2^-48.
rootsSolve :: Modelled -> Property
rootsSolve (Modelled scene library r _) =
  conjoin
    [ counterexample (show (thingKind (foundThing f), t, equationConditions equation !! i)) (solves equation (equationConditions equation !! i) t)
      | n <- [0 .. worldSize w - 1],
        Just f <- [find shapes n],
        let (equation, candidates) = equationOf (foundFrames f) (foundShape f) r,
        Candidate t i _ <- candidates
    ]
  where
    w = world mempty library scene
    shapes = directory [] library scene

solves :: Equation -> Condition -> Double -> Bool
solves equation condition t = case condition of
  PolynomialIsZero _ coefficients _ _ shift ->
    let s = toRational t / k - t0 - toRational shift
        slack = u * 4 * (abs (toRational t / k) + abs t0 + abs (toRational shift))
        terms = zip [length coefficients - 1, length coefficients - 2 ..] [toRational c | Coefficient _ _ c <- coefficients]
        residual = abs (sum [c * s ^ i | (i, c) <- terms])
        size = sum [fromIntegral (i + 1) * abs c * abs s ^ i | (i, c) <- terms]
        slope = sum [fromIntegral i * abs c * (abs s + slack) ^ (i - 1) | (i, c) <- terms, i > 0]
     in residual <= (if length coefficients > 3 then 64 else 8) * u * size + slope * slack
  LiesBetween _ (Coefficient _ _ a) (Coefficient _ _ b) low high ->
    let s = toRational t / k - t0
        slack = u * 4 * (abs (toRational t / k) + abs t0)
        at = toRational b + toRational a * s
     in or [abs (at - toRational bound) <= 8 * u * (abs (toRational b) + abs (toRational bound)) + abs (toRational a) * slack | bound <- [low, high]]
  PassesNear _ _ -> False
  where
    (t0, k) = maybe (0, 1) (bimap toRational toRational) (equationMoved equation)
    u = 1 / 2 ^ (53 :: Int)

-- | The shape that is hit is the one told as the closest, at its kept root; no other kept root is nearer; every fate
-- and verdict is what its numbers say; and every shape is accounted for.
verdictsAccountForTheHit :: Pictured -> Property
verdictsAccountForTheHit p@(Pictured scene _ _ _) = conjoin (map ofRay (concatMap (raysOf . sampleRay) (storySamples story)))
  where
    story = storyOf p
    far = storyFar story
    ofRay r =
      [(encounterThing e, t) | e <- rayEncounters r, Meets t IsClosest <- [encounterVerdict e]] === [(hitThing h, hitParameter h) | Just h <- [rayHit r]]
        .&&. counterexample "nearest" (and [(hitParameter h, thingNumber (hitThing h)) <= (t, thingNumber (encounterThing e)) | Just h <- [rayHit r], e <- rayEncounters r, Meets t _ <- [encounterVerdict e]])
        .&&. conjoin [counterexample (show (encounterThing e, encounterVerdict e, encounterRoots e)) (consistent r e) | e <- rayEncounters r]
        .&&. length (rayEncounters r) + rayPassed r + rayUntold r === storyShapes story
    shapes = directory [] noModels scene
    consistent r e = all (\x -> fateHolds (maybe (const 0) (cornerSlack (rayItself r) . foundShape) found) x && isOfPoint found r x) (encounterRoots e) && verdictHolds (encounterVerdict e) [(rootParameter x, rootFate x) | x <- encounterRoots e]
      where
        found = find shapes (thingNumber (encounterThing e))
    -- Coordinates in a triangle are those of the point, to the bit ("Laws.Triangle" has them near the exact ones).
    isOfPoint found r (Root t _ measure _) = case measure of
      Barycentric t1 t2 -> or [(t1, t2) == barycentric p0 p1 p2 (position own t) | Just f <- [found], (own, shape) <- [inFrames (foldl' (flip carriedBack) (rayItself r) (foundFrames f)) (foundShape f)], Just (Corners p0 p1 p2) <- [trianglePoints <$> triangleOf shape]]
      _ -> True
    inFrames r shape = case shape of
      ATransformed m inner -> inFrames (carriedBack (placement m) r) inner
      _ -> (r, shape)
    fateHolds slack (Root t _ measure fate) =
      measureHolds slack (fate /= Outside) measure && case fate of
        Taken -> t > 1e-8 && t < far
        Later -> t > 1e-8
        Behind -> t < 0
        TooNear -> 0 <= t && t <= 1e-8
        BeyondFar -> t >= far
        Outside -> True
    -- The coordinates in a triangle are computed apart from its edges.
    measureHolds slack isOnShape measure = case measure of
      AwayFromCentre away radius -> isOnShape == (away <= radius)
      Barycentric t1 t2
        | isOnShape -> minimum [t1, t2, 1 - t1 - t2] >= negate (slack (abs t1 + abs t2))
        | otherwise -> minimum [t1, t2, 1 - t1 - t2] <= slack (abs t1 + abs t2)
      AtHeight height len -> isOnShape == (0 <= height && height <= len)
      InTheHole away radius -> not isOnShape && away < radius
      OnTheRing away hole radius -> isOnShape && hole <= away && away <= radius
      SideOfDisk -> True
      OtherConditions -> True
    verdictHolds verdict roots = case verdict of
      Meets t _ -> all ((== t) . fst) (filter ((== Taken) . snd) roots) && (t, Taken) `elem` roots && and [x > t | (x, Later) <- roots]
      Misses miss ->
        Taken `notElem` map snd roots && case miss of
          Parallel -> null roots
          NoRoot -> null roots
          NotOnShape -> not (null roots) && and [False | (_, fate) <- roots, isOn fate]
          IsBehind -> Behind `elem` map snd roots && all (`elem` [Behind]) (filter isOn (map snd roots))
          IsTooNear -> TooNear `elem` map snd roots && BeyondFar `notElem` map snd roots
          IsBeyondFar -> BeyondFar `elem` map snd roots
    isOn fate = case fate of
      Outside -> False
      _ -> True

triangleOf :: Shape -> Maybe Triangle
triangleOf shape = case shape of
  ATriangle t -> Just t
  ASmoothTriangle t -> Just (smoothTriangleFlat t)
  _ -> Nothing

-- | How far beyond an edge of a triangle, as barycentric coordinates go, a ray's point may be told that passes within
-- the triangle, or within it one that passes beside; given the sum of the coordinates. There is nothing of the kind for
-- other shapes.
--
-- With m the distances of the ray's start and of the farthest corner from the origin, L the longest edge, N = s1 x s2,
-- and a = |\<N, d>| what the ray sees of it:
--
-- * A corner's shadow has 6 m roundings, and is at most 2 m away; an edge's two products make 64 m^2 of that, of a.
-- * The unit normal leans by 5 L^2 \/ |N| + 4, so that the plane is met that much of the distance w from the first
--   corner too early or too late; the parameter and the place have 16 m and 8 w more. All that is divided by the
--   cosine, a \/ |N|. A coordinate changes by L \/ |N| for each unit of length.
-- * The inner products of the coordinates have 32 L^4 \/ |N|^2 of themselves.
cornerSlack :: Ray -> Shape -> Double -> Double
cornerSlack r shape coordinates = maybe 0 (ofCorners . trianglePoints) (triangleOf shape)
  where
    ofCorners (Corners p0 p1 p2) =
      let m = modulus (origin r) + maximum (map modulus [p0, p1, p2])
          l = maximum (map modulus [p1 - p0, p2 - p0, p2 - p1])
          n = cross (p1 - p0) (p2 - p0)
          a = abs (dot n (direction r))
          w = coordinates * l
          place = (16 * m + (5 * l * l / modulus n + 12) * w) * modulus n / a
       in roundings 1 * (64 * m * m / a + place * l / modulus n + 32 * l * l * l * l / dot n n * (1 + coordinates))

-------------------------------------------------------------------------------
-- Light

-- | The lights' shares, in their order, add up to what comes back from the hit, exactly; and the rays' contributions,
-- in their order, to the sample.
sharesAreTheSum :: Pictured -> Property
sharesAreTheSum p = conjoin (map ofSample (storySamples (storyOf p)))
  where
    ofSample s =
      let rays = raysOf (sampleRay s)
       in conjoin [rayOwnColour r === foldl' plus black (map shareTotal shares) | r <- rays, Just h <- [rayHit r], Just shares <- [hitShares h]]
            .&&. ( case rayHit (sampleRay s) >>= hitShares of
                     Nothing -> sampleColour s === rayOwnColour (sampleRay s)
                     Just _ -> sampleColour s === foldl' plus black (map rayContribution rays)
                 )
            .&&. conjoin [three (rayContribution r) === zipWith (*) (weights r) (three (rayOwnColour r)) | r <- rays]
    weights r = let (x, y, z) = rayWeight r in [x, y, z]

-- | The terms of a share follow from what is told of its way by the formulas of the textbook, and add up to the share,
-- to rounding; what does not arrive gives nothing.
--
-- The renderer adds two terms and attenuates the sum; told apart, each is attenuated, and then they are added: 2
-- roundings on either side. Cosine and attenuation are multiplied with the light one after the other, or with each
-- other first: 2 on either side.
--
-- A highlight is a power of a cosine x. For Blinn's, \<N, b> \/ |b|, the two orders of the division have 4 roundings
-- each, of at most 1. For Phong's, -\<d, v> + 2 \<d, N> \<N, v>, the renderer's way by the mirrored direction has 12
-- and the sum 18. Together they are below 32, which the power makes k \/ x times as much; its squarings have k
-- themselves, and the library's power and the products 6. Where x is below 2^-40 its sign may be a rounding, and
-- nothing is asked.
sharesFollowFromTheirWays :: Pictured -> Property
sharesFollowFromTheirWays p =
  conjoin
    [ counterexample (show (shareArrival s, shareTerms s, shareTotal s)) (ofShare (rayItself r) h s)
      | looked <- storySamples (storyOf p),
        r <- raysOf (sampleRay looked),
        Just h <- [rayHit r],
        Just shares <- [hitShares h],
        s <- shares
    ]
  where
    ofShare r h s = case shareArrival s of
      FromAllSides -> three (shareTotal s) === zipWith (*) (three (shareColour s)) (three (ambientOf (hitColours h))) .&&. addUp s
      Arrives way open _ -> addUp s .&&. conjoin [ofTerm r h s way open term c | (term, c) <- shareTerms s] .&&. cosineIs h way
      FacesAway way -> nothing s .&&. cosineIs h way .&&. property (approachCosine way <= 0)
      InShadow way by -> nothing s .&&. cosineIs h way .&&. property (maybe True (\(_, t) -> t > 1e-8 && maybe True (t <) (approachDistance way)) by)
      LeftOut -> nothing s
      Nowhere -> nothing s
    nothing s = (shareTerms s, three (shareTotal s)) === ([], [0, 0, 0])
    cosineIs h way = approachCosine way === negate (dot (vector (hitNormal h)) (approachDirection way))
    addUp s = within (roundings 4) (three (shareTotal s)) (foldr (zipWith (+) . three . snd) [0, 0, 0] (shareTerms s))
    ofTerm r h s way open term c = case term of
      DiffuseTerm -> within (roundings 4) (three c) (map (* (approachFactor way * approachCosine way)) (zipWith (*) light (three (diffuseOf (hitColours h)))))
      -- Half way between light and viewer, or mirrored light and viewer.
      BlinnTerm -> highlight (let b = negate (direction r) - approachDirection way in dot n b / sqrt (dot b b))
      PhongTerm -> highlight (negate (dot (approachDirection way) (direction r)) + 2 * dot (approachDirection way) n * dot n (direction r))
      _ -> property True
      where
        n = vector (hitNormal h)
        light = if all (< 1e-10) filtered then [0, 0, 0] else filtered
        filtered = zipWith (*) (three (shareColour s)) (three open)
        shine = shininessOf (hitColours h)
        highlight x
          -- Light and viewer are exactly opposite.
          | isNaN x = three c === [0, 0, 0]
          | abs x < 2 ** (-40) = property True
          | otherwise = within (expm1 (shine * roundings 32 / abs x) + shine * roundings 1 + roundings 6) (three c) (map (* (approachFactor way * (if x < 0 then 0 else x ** shine))) (zipWith (*) light (three (specularOf (hitColours h)))))

-- | What is thrown back leaves at the angle at which it came, and what passes obeys Snell's law, n1 sin a1 = n2 sin a2;
-- nothing passes where n1 sin a1 > n2. Directions stay unit.
--
-- An angle is told to 10 roundings: the cross product has 3 and its length 4, the inner product 3, the arc tangent 3. A
-- normal's square is 1 to 10 roundings, so that a mirrored direction leans by 20, and by 9 of its own.
--
-- Of a refracted direction, with r = n1 \/ n2, the part along the surface has 3 r + 2 roundings, and the cosine c 8, of
-- which r^2 (1 - c^2) makes 18 r^2 + 6. Together its squared length is 1 to 18 r^2 + 38 r + 26 roundings, and its
-- angle's sine has half of that, 3 r + 2, and those of the two angles, 12 (1 + r): all are below 48 (1 + r^2). Where
-- the squared length of what arrives is off by a part, that part comes back r^2 times as much.
bouncesObeyTheLaws :: Pictured -> Property
bouncesObeyTheLaws p =
  conjoin
    [ counterexample (show (bounceKind b, bounceAngleIn b)) (ofBounce (excess r) b)
      | s <- storySamples (storyOf p),
        r <- raysOf (sampleRay s),
        Just h <- [rayHit r],
        b <- hitBounces h
    ]
    .&&. conjoin [counterexample "unit" (excess (sampleRay s) <= roundings 10) | s <- storySamples (storyOf p)]
  where
    excess r = abs (quadrance (direction (rayItself r)) - 1)
    ofBounce e b = case (bounceKind b, bounceSequel b) of
      (Reflection, Followed out next) ->
        counterexample (show out) (abs (out - bounceAngleIn b) <= roundings 64) .&&. staysUnit 1 e next .&&. rayCause next === ByReflection
      (Refraction n1 n2 _, Followed out next) ->
        counterexample (show out) (abs (n1 * sin (bounceAngleIn b) - n2 * sin out) <= n2 * lean (n1 / n2) e)
          .&&. staysUnit (n1 / n2) e next
          .&&. rayCause next === ByRefraction
          .&&. rayIndex next === n2
      (Refraction n1 n2 _, NotFollowed TotalReflection) -> property (n1 * sin (bounceAngleIn b) >= n2 * (1 - lean (n1 / n2) e))
      (Reflection, NotFollowed o) -> property (o `elem` [DepthReached, TooManyRays])
      (Refraction {}, NotFollowed _) -> property True
    staysUnit r e next = counterexample (show (excess next)) (excess next <= r * r * e + (1 + r * r) * roundings 48)
    lean r e = (1 + r * r) * (roundings 48 + e / 2)

three :: Colour -> [Double]
three (Colour r g b _) = [r, g, b]
