{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.World
-- Description : What is true of worlds with an index, and with models
--
-- The index must not be seen: the second opinion is a plain list of shapes, every one of which is tried. And a model
-- somewhere is the same as its shapes there, each transformed by itself.
module Laws.World
  ( -- * Many shapes
    Many (..),
    manyCorners,
    closestIsAsOfAList,
    obstaclesAreAsOfAList,
    surroundingsAreAsOfAList,
    surfacesAreAsOfAList,

    -- * Models
    Modelled (..),
    modelledCorners,
    modelsAreTheirShapes,
    closestIsAsOfShapes,
    obstaclesAreAsOfShapes,
    surroundingsAreAsOfShapes,
    picturesAreAsOfShapes,
    coloursAreAsOfTheRecursion,

    -- * Meshes in the world
    worldOfMesh,
    noWayOutOfTheWorld,
    smoothNormalsAreInterpolated,
  )
where

import Data.List (find, foldl', nub, sort)
import Data.Maybe (catMaybes, isJust, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Geometry.Axis (axis, roundRadius, roundShape)
import Dioptre.Geometry.Bounds (ofShape)
import Dioptre.Geometry.Box (boxHigh, boxLow)
import Dioptre.Geometry.Cap (cap)
import Dioptre.Geometry.Disk (disk)
import Dioptre.Geometry.Lens (lens)
import Dioptre.Geometry.Mesh
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Prepared (contains, normalAt, prepare, textureAt)
import Dioptre.Geometry.PreparedMesh (triangleShape)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Torus (torus)
import Dioptre.Geometry.Triangle (Corners (..))
import Dioptre.Light.Finish (Colours (..), Finish (..), finish, withPictures)
import Dioptre.Light.Material (Material (..), standard)
import Dioptre.Math.Transform (Transform, identity, matrix, placement, transform, transformDirection, transformPosition)
import Dioptre.Math.Vector
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..), noModels)
import Dioptre.Render (rendered)
import Dioptre.Render.Obstacles
import Dioptre.Render.Radiance (Seen (..), radiance, unlit)
import Dioptre.Render.Row (colourAt, plan, planHeight, planWidth)
import Dioptre.Render.Stage (Stage (..), stage)
import Dioptre.Render.Surface
import Dioptre.Render.Surroundings
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.Texture (Texture)
import Dioptre.Render.World (Extent (..), World, world, worldExtent, worldHasMedia, worldOwn, worldSize)
import Dioptre.Scene (writeScene)
import Dioptre.Scene.Camera (CameraSettings (..), cameraSettings)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Scene.Raytracer (ReflexionAlgorithm (NoLight))
import Dioptre.Scene.Unchecked (Scene (..))
import Laws.Aim
import Laws.Closest (allHits, metIn)
import Laws.Draw
import Laws.Mesh
import Laws.Shade (Plain (..), aMaterial, channels, plainly, sceneOf)
import qualified Laws.Shade as Shade
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Linear.V4 (V4 (..))
import Test.QuickCheck hiding (vector)

-------------------------------------------------------------------------------
-- Shapes

-- | A shape of any sort, transformed at times.
anyShape :: Kind -> Gen Shape
anyShape kind = frequency [(6, elements [minBound ..] >>= (`shapeOf` kind)), (5, onAxis), (2, overDisk), (2, ATransformed <$> aTransform <*> anyShape kind)]
  where
    onAxis = do
      a <- (axis <$> point kind <*> point kind) `suchThatMap` id
      body <- (roundShape a <$> positive kind) `suchThatMap` id
      k <- elements [1, 1.5, -2, 8]
      l <- elements [1, -1.25, 4]
      elements (ATube body : ACylinder body : ACone body : [ALens x | Just x <- [lens body (k * roundRadius body, l * roundRadius body)]])
    overDisk = do
      p <- (plane <$> point kind <*> step kind) `suchThatMap` id
      r <- positive kind
      s <- positive kind
      k <- elements [1, -1, 2, -8]
      elements (catMaybes [ATorus <$> torus p r s, ATorus <$> torus p (r + s) s, disk p r >>= \d -> ACap <$> cap d (k * r)])

-- | A transformation, mirroring at times, with factors from a quarter to four.
aTransform :: Gen Transform
aTransform = (transform <$> (V3 <$> factor <*> factor <*> factor) <*> (V3 <$> turn <*> turn <*> turn) <*> oneof [pure 0, point Few, point Full]) `suchThatMap` id
  where
    factor = oneof [pure 1, elements [0.5, 2, -1, -0.25, 4], (*) <$> elements [1, -1] <*> choose (0.25, 4)]
    turn = oneof [pure 0, elements [90, -90, 180, 45], choose (-180, 180)]

-- | A ray that is aimed at a shape.
rayTowards :: Kind -> Shape -> Gen Ray
rayTowards kind shape = case (sortOf shape, ofShape shape) of
  (Nothing, Just b) -> do
    target <- sequenceA ((\l h -> (\f -> l + f * (h - l)) <$> fraction) <$> boxLow b <*> boxHigh b)
    o <- oneof [point kind, pure target, (\k d -> target - k *^ d) <$> number kind <*> axisStep Few]
    d <- oneof [pure (target - o), axisStep Few, step kind]
    pure (ray o (if d == 0 then V3 1 0 0 else d))
  _ -> rayAt kind shape

-- | A place that may be inside of shapes: on the ray, in the middle of a shape's box.
placeAmong :: [Shape] -> Ray -> Gen Point
placeAmong shapes r = oneof [pure (origin r), position r <$> number Full, inBox]
  where
    inBox = case mapMaybe ofShape shapes of
      [] -> pure (origin r)
      boxes -> elements boxes >>= \b -> sequenceA ((\l h -> (\f -> l + f * (h - l)) <$> choose (0.2, 0.8)) <$> boxLow b <*> boxHigh b)

-------------------------------------------------------------------------------
-- Many shapes

-- | Shapes, transparent or not, a ray that is aimed at one of them, and a place among them.
data Many = Many [(Shape, Bool)] Ray Point
  deriving (Eq, Show)

instance Arbitrary Many where
  arbitrary = do
    kind <- elements [Few, Full]
    n <- frequency [(1, chooseInt (1, 8)), (3, chooseInt (9, 40))]
    first <- vectorOf n (anyShape kind)
    -- Some are there twice, at the same parameters
    twice <- chooseInt (0, n `div` 2) >>= \k -> take k <$> shuffle first
    shapes <- shuffle (first ++ twice)
    clear <- elements [0, 1, 9] >>= \k -> vectorOf (length shapes) (frequency [(1, pure False), (k, pure True)])
    r <- elements shapes >>= rayTowards kind
    Many (zip shapes clear) r <$> placeAmong shapes r
  shrink (Many shapes r p) = [Many some r p | some <- shrinkList (const []) shapes, not (null some)]

-- | The scene of these shapes; each has a material of its own.
sceneOfMany :: [(Shape, Bool)] -> Scene
sceneOfMany shapes =
  (sceneOf [])
    { scenePrimitives = [Primitive (named i) shape | (i, (shape, _)) <- zip [0 ..] shapes],
      sceneMaterials = [standard {materialName = named i, materialShininess = fromIntegral i, materialKt = if clear then 0.5 else 0} | (i, (_, clear)) <- zip [0 ..] shapes]
    }

named :: Int -> Text
named = Text.pack . show

worldOfMany :: [(Shape, Bool)] -> World
worldOfMany = world mempty noModels . sceneOfMany

-- | The number of a shape, of those of 'sceneOfMany', by its finish.
numberOf :: Finish Texture -> Int
numberOf = round . shininessOf . finishColours

-- | What is closest is the first of all hits of all shapes, to the bit.
closestIsAsOfAList :: Many -> Property
closestIsAsOfAList (Many shapes r _) = closestIsFirst (worldOfMany shapes) (map fst shapes) r

closestIsFirst :: World -> [Shape] -> Ray -> Property
closestIsFirst w shapes r = conjoin [counterexample (show b) (metIn w r b === find ((< b) . fst) hits) | b <- bounds]
  where
    hits = allHits shapes r (1 / 0)
    bounds = [1 / 0, 1, 1e-8] ++ concat [[t, nudged 1 t] | (t, _) <- take 2 hits]

-- | What is met below a bound is opaque, if any shape met there is; if not, it is all the shapes met there, each once.
obstaclesAreAsOfAList :: Many -> Property
obstaclesAreAsOfAList (Many shapes r _) = obstaclesAreAll (worldOfMany shapes) shapes r

obstaclesAreAll :: World -> [(Shape, Bool)] -> Ray -> Property
obstaclesAreAll w shapes r = conjoin [counterexample (show b) (agrees b) | b <- [1 / 0, 2, 1e-8] ++ map fst (take 2 (allHits (map fst shapes) r (1 / 0)))]
  where
    agrees b =
      let struck = [(i, clear) | (i, (shape, clear)) <- zip [0 ..] shapes, not (null (allHits [shape] r b))]
          found = obstacles w r b
       in obstaclesOpaque found === not (all snd struck)
            .&&. (obstaclesOpaque found .||. sort (map fst (obstaclesTransparent found)) === map fst struck)
            .&&. conjoin [Just f === finishAt w i | (i, f) <- obstaclesTransparent found]
            .&&. counterexample "tests" (obstaclesTests found <= length shapes)

-- | A place is inside those shapes of the list that contain it, one left out or not.
surroundingsAreAsOfAList :: Many -> Property
surroundingsAreAsOfAList (Many shapes _ p) = surroundingsAreAll (worldOfMany shapes) (map fst shapes) p

surroundingsAreAll :: World -> [Shape] -> Point -> Property
surroundingsAreAll w shapes p = conjoin [counterexample (show leftOut) (map Just (surroundings w leftOut p) === [finishAt w i | i <- inside, Just i /= leftOut]) | leftOut <- Nothing : map Just (take 2 inside)]
  where
    inside = [i | (i, Just shape) <- zip [0 ..] (map prepare shapes), contains shape p]

-- | Each number has its shape, and its finish.
surfacesAreAsOfAList :: Many -> Property
surfacesAreAsOfAList (Many shapes _ _) =
  [(shape, numberOf f) | Just (Surface shape f) <- map (surfaceAt w) [-1 .. length shapes]] === [(shape, i) | (i, Just shape) <- zip [0 ..] (map (prepare . fst) shapes)]
    .&&. map (fmap numberOf . finishAt w) [-1 .. length shapes] === [Nothing] ++ map Just [0 .. length shapes - 1] ++ [Nothing]
    .&&. worldSize w === length shapes
  where
    w = worldOfMany shapes

-- | What the worlds must reach.
manyCorners :: Many -> [(String, Bool)]
manyCorners (Many shapes r p) =
  [ ("an index", isIndexed),
    ("no index", not isIndexed),
    ("several shapes at the closest parameter", length (filter ((== fmap fst (listToMaybe hits)) . Just . fst) hits) > 1),
    ("nothing is met", null hits),
    ("only transparent shapes are met, and several", length struck > 1 && and struck),
    ("something opaque is met", not (and struck)),
    ("a place inside several shapes", length [() | Just shape <- map (prepare . fst) shapes, contains shape p] > 1)
  ]
  where
    isIndexed = extentBoxes (worldExtent (worldOfMany shapes)) > 0
    hits = allHits (map fst shapes) r (1 / 0)
    struck = [clear | (shape, clear) <- shapes, not (null (allHits [shape] r (1 / 0)))]

-------------------------------------------------------------------------------
-- Models

-- | A scene with models, and a ray and a place among its shapes.
data Modelled = Modelled Scene (Library Texture) Ray Point

instance Show Modelled where
  show (Modelled scene library r p) = show r <> "\n" <> show p <> "\n" <> Text.unpack (writeScene scene) <> "\n" <> show (map contentParts (Vector.toList (libraryModels library))) <> "\n" <> show (libraryInstances library)

instance Arbitrary Modelled where
  arbitrary = do
    kind <- elements [Few, Full]
    opaque <- mapM aMaterial ["m0", "m1"]
    clear <- mapM aMaterial ["m2", "m3"]
    let materials = map (\m -> m {materialKt = 0}) opaque ++ clear
        finishes = Vector.fromList (map finishOf materials)
        solid = Solid <$> anyShape kind <*> chooseInt (0, 3)
        placed n = Instance <$> chooseInt (0, n - 1) <*> oneof [pure identity, aTransform, aTransform]
        part n = frequency ([(3, solid), (1, Faces <$> oneof [aMesh kind 2, roundMesh])] ++ [(1, Nested <$> placed n) | n > 0])
        content n = do
          -- A mesh alone, nothing, a few parts, or many solids
          parts <- frequency [(2, (: []) . Faces <$> aMesh kind 2), (1, pure []), (4, chooseInt (1, 5) >>= (`vectorOf` part n)), (1, chooseInt (9, 14) >>= (`vectorOf` solid))]
          pure (Content parts finishes)
    k <- chooseInt (1, 4)
    models <- mapM content [0 .. k - 1]
    instances <- frequency [(5, chooseInt (1, 4)), (1, chooseInt (9, 12))] >>= (`vectorOf` placed k)
    own <- frequency [(3, chooseInt (0, 4)), (1, chooseInt (9, 12))] >>= (`vectorOf` anyShape kind)
    names <- vectorOf (length own) (elements (map materialName materials))
    let scene = view {scenePrimitives = zipWith Primitive names own, sceneMaterials = materials}
        library = Library (Vector.fromList models) instances
        -- Transformed twice and more, a model of models may be large: the list of its shapes is tried again and again
        shapes = map fst (shapesOf scene library)
    if length shapes > 150 || null shapes
      then arbitrary
      else do
        r <- elements shapes >>= rayTowards kind
        Modelled scene library r <$> placeAmong shapes r
    where
      view =
        sceneOf
          [ "camera\nposition -30 -20 25\nlook_at 0 0 0\nup 0 0 1\nangle 50\nfar_clipping_plane 500\nend",
            "viewport\nwidth 6\nheight 5\nend",
            "raytracer\nrecursive_level 3\nend",
            "ambient_light\nend\npoint_light\nposition 3 -40 60\nend\ndirectional_light\norientation 1 0.5 -0.25\nend"
          ]

finishOf :: Material -> Finish Texture
finishOf = withPictures (const Nothing) . finish

-- | The shapes of a scene with models, each with the number of its material: the scene's own; then those of each model,
-- transformed. Within a model, solids come first, and then the triangles of its meshes and the shapes of its models, in
-- the order of the file.
shapesOf :: Scene -> Library Texture -> [(Shape, Int)]
shapesOf scene library = [(primitiveShape p, material) | p <- scenePrimitives scene, (material, m) <- zip [0 ..] (sceneMaterials scene), materialName m == primitiveMaterial p] ++ concatMap placed (libraryInstances library)
  where
    placed i = [(if instanceTransform i == identity then shape else ATransformed (instanceTransform i) shape, m) | (shape, m) <- concat [ofContent c | Just c <- [libraryModels library Vector.!? instanceModel i]]]
    ofContent c = [(shape, m) | Solid shape m <- contentParts c] ++ concatMap inner (contentParts c)
    inner part = case part of
      Solid _ _ -> []
      Faces mesh -> [(shape, fromIntegral (meshFinishes mesh Unboxed.! i)) | i <- [0 .. meshSize mesh - 1], Just shape <- [triangleShape mesh i]]
      Nested i -> placed i

-- | The scene without models whose primitives are the shapes of a scene with models.
plainScene :: Scene -> Library Texture -> Scene
plainScene scene library = scene {scenePrimitives = [Primitive ("m" <> named m) shape | (shape, m) <- shapesOf scene library]}

-- | The numbers of a world with models are those of its shapes in their order, and there are no others.
modelsAreTheirShapes :: Modelled -> Property
modelsAreTheirShapes (Modelled scene library _ _) =
  [(shape, f) | Just (Surface shape f) <- map (surfaceAt w) numbers] === [(shape, finishOf (sceneMaterials scene !! m)) | (s, m) <- shapes, Just shape <- [prepare s]]
    .&&. map (finishAt w) numbers === [Nothing] ++ [Just (finishOf (sceneMaterials scene !! m)) | (_, m) <- shapes] ++ [Nothing]
    .&&. worldSize w === length shapes
    .&&. extentShapes (worldExtent w) === length shapes
    .&&. worldOwn w === length (scenePrimitives scene)
    .&&. worldHasMedia w === worldHasMedia (world mempty noModels (plainScene scene library))
  where
    w = world mempty library scene
    shapes = shapesOf scene library
    numbers = [-1 .. length shapes]

-- | What is closest is the first of all hits of all its shapes, to the bit.
closestIsAsOfShapes :: Modelled -> Property
closestIsAsOfShapes (Modelled scene library r _) = closestIsFirst (world mempty library scene) (map fst (shapesOf scene library)) r

-- | What is met below a bound is all its shapes there, or something opaque.
obstaclesAreAsOfShapes :: Modelled -> Property
obstaclesAreAsOfShapes (Modelled scene library r _) = obstaclesAreAll (world mempty library scene) [(shape, materialKt (sceneMaterials scene !! m) /= 0) | (shape, m) <- shapesOf scene library] r

-- | A place is inside those of its shapes that contain it.
surroundingsAreAsOfShapes :: Modelled -> Property
surroundingsAreAsOfShapes (Modelled scene library _ p) = surroundingsAreAll (world mempty library scene) (map fst (shapesOf scene library)) p

-- | The picture of a scene with models is that of its shapes, with light and without: the same colour in each pixel, to
-- the bit, and as many rays.
picturesAreAsOfShapes :: Modelled -> Property
picturesAreAsOfShapes (Modelled lit library _ _) = forAll arbitrary $ \isLit ->
  let scene = if isLit then lit else Shade.setAlgorithm NoLight lit
      p = plan mempty library scene
      q = plan mempty noModels (plainScene scene library)
   in conjoin [counterexample (show (x, y)) (told (colourAt p x y) === told (colourAt q x y)) | y <- [0 .. planHeight p - 1], x <- [0 .. planWidth p - 1]] .&&. counterexample "bytes" (rendered p == rendered q)
  where
    told (Seen c (Tally rays _ cut)) = (c, rays, cut)

-- | What a ray sees in a scene with models is what the plain recursion of "Laws.Shade" sees of its shapes, but for the
-- order of sums.
coloursAreAsOfTheRecursion :: Modelled -> Property
coloursAreAsOfTheRecursion (Modelled scene library r0 _) = case maybe (unlit s far r) (\terms -> radiance s terms far r) (stageTerms s) of
  Seen c (Tally rays _ cut) -> Shade.within 1e-12 (channels c) expected .&&. (rays, cut > 0) === (followed + shadows, cut')
  where
    r = maybe r0 (ray (origin r0) . vector) (unit (direction r0))
    s = stage mempty library scene
    far = settingFar (cameraSettings (sceneCamera scene))
    Plain expected followed shadows cut' = plainly (plainScene scene library) r

-- | What the scenes must reach.
modelledCorners :: Modelled -> [(String, Bool)]
modelledCorners (Modelled scene library r p) =
  [ ("a model's shape is met first", maybe False ((>= length (scenePrimitives scene)) . snd) (listToMaybe hits)),
    ("nothing is met", null hits),
    ("several shapes at the closest parameter", length (filter ((== fmap fst (listToMaybe hits)) . Just . fst) hits) > 1),
    ("a model in a model is met", or [isTwice shape | (_, i) <- hits, shape <- take 1 (drop i shapes)]),
    ("one model twice", length models > length (nub models)),
    ("a mesh alone", or [length (contentParts c) == 1 && or [True | Faces _ <- contentParts c] | c <- Vector.toList (libraryModels library)]),
    ("an empty model", any (null . contentParts) (Vector.toList (libraryModels library))),
    ("a place inside a model's shape", or [contains shape p | Just shape <- map prepare (drop (length (scenePrimitives scene)) shapes)]),
    ("many instances", length models > 8)
  ]
  where
    shapes = map fst (shapesOf scene library)
    hits = allHits shapes r (1 / 0)
    models = map instanceModel (libraryInstances library)
    isTwice shape = case shape of
      ATransformed _ (ATransformed _ _) -> True
      _ -> False

-------------------------------------------------------------------------------
-- Meshes in the world

-- | The world of one mesh somewhere.
worldOfMesh :: Mesh -> Transform -> World
worldOfMesh mesh t = world mempty (Library (Vector.singleton (Content [Faces mesh] (Vector.singleton (finishOf standard)))) [Instance 0 t]) (sceneOf [])

-- | A ray from inside a closed mesh that is scaled, turned and moved meets it.
noWayOutOfTheWorld :: Enclosed -> Property
noWayOutOfTheWorld (Enclosed mesh r) = forAll aTransform $ \t ->
  let m = placement t
      carried' = ray (transformPosition m (origin r)) (transformDirection m (direction r))
      w = worldOfMesh mesh t
   in isJust (metIn w carried' (1 / 0)) .&&. obstaclesOpaque (obstacles w carried' (1 / 0)) === True

-- | The normal and the texture coordinates of a smooth mesh that is scaled, turned and moved are interpolated between
-- those of the corners, in the world: the corners are carried by the matrix M, and the normals by its cofactors, which
-- are its inverse transposed, up to a factor; a point's weights are the areas of the triangles across from the corners.
--
-- The weights are off by some thirty roundings of the coordinates, over the altitude of the triangle; here coordinates
-- are at most 2^7 times as large. The cofactors magnify errors by the ratio of the factors' squares, at most 2^8.
-- Altogether less than 2^-53 2^5 2^7 2^8 = 2^-33.
smoothNormalsAreInterpolated :: Property
smoothNormalsAreInterpolated = forAll ((,) <$> roundMesh <*> aTransform) $ \(mesh, t) -> forAll (rayInto mesh t) $ \r ->
  let w = worldOfMesh mesh t
   in case metIn w r (1 / 0) of
        Nothing -> discard
        Just (s, i) -> case surfaceAt w i of
          Nothing -> counterexample "no surface" False
          Just (Surface shape _) ->
            let (n, uv) = interpolated mesh t i (position r s)
                V2 u v = textureAt shape r s - uv
             in counterexample (show (normalAt shape r s, n, textureAt shape r s, uv)) $
                  distance (vector (normalAt shape r s)) n < 2 ** (-33) && abs u < 2 ** (-33) && abs v < 2 ** (-33)
  where
    -- From outside the mesh's corners, at most 2^5 away
    rayInto mesh t = do
      let m = placement t
      Corners a b c <- meshTriangle mesh <$> chooseInt (0, meshSize mesh - 1)
      f <- choose (0, 1)
      g <- choose (0, 1)
      o <- V3 <$> choose (-8, 8) <*> choose (-8, 8) <*> choose (-8, 8)
      let target = transformPosition m (a + f *^ (b - a) + (g * (1 - f)) *^ (c - a))
          start = transformPosition m o
      maybe discard (pure . ray start . vector) (unit (target - start))
    interpolated mesh t i p = (n ^/ modulus n, sumOf (zipWith scaled' weights (map uvOf [0, 1, 2])))
      where
        V4 (V4 a b c d) (V4 e f g h) (V4 j k l o) _ = matrix t
        carry (V3 x y z) = V3 (a * x + b * y + c * z + d) (e * x + f * y + g * z + h) (j * x + k * y + l * z + o)
        -- The cofactors of the three by three part, times the sign of its determinant.
        cofactors (V3 x y z) = signum (dot (V3 a e j) (cross (V3 b f k) (V3 c g l))) *^ (x *^ cross (V3 b f k) (V3 c g l) + y *^ cross (V3 c g l) (V3 a e j) + z *^ cross (V3 a e j) (V3 b f k))
        Corners p0' p1' p2' = meshTriangle mesh i
        (p0, p1, p2) = (carry p0', carry p1', carry p2')
        area q r' s = let whole = cross (p1 - p0) (p2 - p0) in dot whole (cross (r' - q) (s - q)) / dot whole whole
        weights = [area p p1 p2, area p p2 p0, area p p0 p1]
        n = sum (zipWith (*^) weights [cofactors (made (normalOf corner)) | corner <- [0, 1, 2]])
        made v = v ^/ modulus v
        normalOf corner = let m = 3 * fromIntegral (meshCornerNormals mesh Unboxed.! (3 * i + corner)) in V3 (meshNormals mesh Unboxed.! m) (meshNormals mesh Unboxed.! (m + 1)) (meshNormals mesh Unboxed.! (m + 2))
        uvOf corner = let m = 2 * fromIntegral (meshCornerUvs mesh Unboxed.! (3 * i + corner)) in V2 (meshUvs mesh Unboxed.! m) (meshUvs mesh Unboxed.! (m + 1))
    scaled' x (V2 u v) = V2 (x * u) (x * v)
    sumOf = foldl' (+) (V2 0 0)
