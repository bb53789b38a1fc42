{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Original
-- Description : What the original program does otherwise with a scene
--
-- The scene language comes from a teaching program whose scenes are still around. They draw here as they did there,
-- with exceptions that the specification lists (annex C): this module finds in a scene those of them that its text
-- shows, each at its place, as notes for whoever compares the two programs.
--
-- > primitive
-- >   material_name blue
-- >   torus                     the original never shows 'torus'
-- >     major_radius 2.0
-- >   end
-- > end
--
-- A note says that the pictures may differ, not that they do. What no text shows is not told: rays that meet an edge
-- exactly, what stands in files that the scene names, where they are looked for, and in which encoding the scene is
-- read.
module Dioptre.Scene.Original
  ( departures,
  )
where

import Data.Char (isHexDigit)
import Data.Either (isRight)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, listToMaybe, mapMaybe)
import Data.Set (Set)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Geometry.Axis (axisEnd, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Cube (cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (diskPlane)
import Dioptre.Geometry.Plane (planeNormal, planePosition)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Triangle (Corners (..), smoothTriangleFlat, smoothTriangleNormals, triangleNormal, trianglePoints)
import Dioptre.Light.Colour (alpha)
import Dioptre.Light.Light (Light (..), Opening (Ellipse), lampAttenuators)
import Dioptre.Light.Material (Material (..), Textures (..))
import qualified Dioptre.Math.Transform as Transform
import Dioptre.Math.Vector (Point, cross, distance, dot, modulus, unit, vector, (*^))
import Dioptre.Scene.Camera (cameraSchema, cameraSettings, defaultCamera, settingPosition, viewportHeight, viewportSchema, viewportWidth)
import Dioptre.Scene.Form (Form (..), fileName)
import Dioptre.Scene.Lights (readLight)
import Dioptre.Scene.Materials (byName, materialSchema, textureMaterialSchema)
import Dioptre.Scene.Model (Model (..), modelSchema)
import Dioptre.Scene.Primitive (Primitive (..), primitiveSchema)
import Dioptre.Scene.Raytracer (ColourNormalization (..), PixelCoordinate (..), Raytracer (..), ReflexionAlgorithm (..), Space (..), algorithmName, defaultRaytracer, mostRays, raytracerSchema)
import Dioptre.Scene.Reporting (runCheck)
import Dioptre.Scene.Schema (Schema, placeOfValue, readObject)
import Dioptre.Scene.Shapes (readShape)
import Dioptre.Source.Departure (Departure (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, sourceText)
import Dioptre.Source.Words (isBlank)
import Dioptre.Syntax.Keyword (Keyword, fromSpelling, spelling)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Tree (Block (..), Head (..), Node (..), Property (..), Tree, Value (..))
import Dioptre.Syntax.Value (integer, largestReal, real)
import Linear.V3 (V3 (..))

-- | What the original takes otherwise, in the order of the file: in a text, whose tree that is, and of which this has
-- been said.
departures :: Source -> Tree -> [Diagnostic] -> [Diagnostic]
departures source tree faults = sortOn diagnosticSpan (concat [ofComments source, mapMaybe ofFault faults, ofViewing objects, concatMap (ofObject tracer eye textured) objects])
  where
    objects = [(word, block) | Object block <- tree, Just word <- [headKeyword (blockHead block)]]
    tracer = maybe defaultRaytracer snd (counting Keyword.Raytracer raytracerSchema objects)
    eye = settingPosition (cameraSettings (maybe defaultCamera snd (counting Keyword.Camera cameraSchema objects)))
    textured = texturedNames objects

-- | An object of the scene, by its word.
type Object = (Keyword, Block)

note :: Span -> Departure -> Diagnostic
note place = Diagnostic place . Departs

-- | The object that a block describes by itself, if it is possible.
made :: Schema a b -> Block -> Maybe b
made schema = fst . runCheck . readObject schema

-- | Of objects of which a scene has one, the one that counts: the last that is possible.
counting :: Keyword -> Schema a b -> [Object] -> Maybe (Block, b)
counting word schema objects = listToMaybe [(block, b) | (w, block) <- reverse objects, w == word, Just b <- [made schema block]]

-- | Where an object begins.
opening :: Block -> Span
opening = headSpan . blockHead

-- | Where a property's value stands, or else where the object begins.
placeOf :: Keyword -> Block -> Span
placeOf word block = fromMaybe (opening block) (placeOfValue word block)

-------------------------------------------------------------------------------
-- Reading

-- | A comment that opens and closes on one line opens a block there, whose end is looked for among the first words of
-- lines.
ofComments :: Source -> [Diagnostic]
ofComments = outside . zip [1 ..] . Text.split (== '\n') . sourceText
  where
    outside = \case
      [] -> []
      (n, line) : rest
        | firstWord line /= "/*" -> outside rest
        | "*/" `Text.isInfixOf` Text.drop 2 (Text.strip line) -> note (place n line) (HidesLines (listToMaybe [m | (m, l) <- rest, firstWord l == "*/"])) : outside rest
        | otherwise -> outside (drop 1 (dropWhile ((/= "*/") . firstWord . snd) rest))
    firstWord = Text.takeWhile (not . isBlank) . Text.dropWhile isBlank
    place n line = let column = Text.length (Text.takeWhile isBlank line) + 1 in Span n column (column + 2)

-- | Where something is wrong, the original may go on in another way.
ofFault :: Diagnostic -> Maybe Diagnostic
ofFault (Diagnostic place problem) = note place <$> departure
  where
    departure = case problem of
      UnknownWord _ _ _ passed | passed /= TheLine -> Just ReadsAround
      MisplacedWord _ _ _ passed | passed /= TheLine -> Just ReadsAround
      -- What is a slip for it is an unknown word there, which does no more harm than here.
      StrayEnd word | fromSpelling word == Just Keyword.End -> Just EndsScene
      MisspeltEnd _ -> Just ReadsOn
      MissingEnd _ (Just (word, line)) -> Just (KeepsOpen word line)
      RefusedValue word refusal expectation _ -> ofRefusal word refusal expectation
      ImpossibleObject _ flaw _ -> case flaw of
        CurvatureBelowRadius -> Just EndsAtCurvature
        TooManyPixels _ -> Just LacksLimit
        TooManyOscillators _ -> Just LacksLimit
        _ -> Nothing
      _ -> Nothing

-- | What the original does with a value that is refused.
ofRefusal :: Text -> Refusal -> Expectation -> Maybe Departure
ofRefusal word refusal expectation = case refusal of
  UnsafeName -> Just WritesAnywhere
  ZeroComponent -> Just AdmitsZeroScale
  OutOfRange t
    | AColour _ <- expectation -> Just AbandonsObject
    | fromSpelling word == Just Keyword.RefractiveIndex, Right n <- real t, n >= 0, n < 1 -> Just AdmitsZeroIndex
  NotANumber t | admitted expectation t -> Just (ReadsNumber t largestReal)
  TooLarge t | admitted expectation t -> Just (ReadsNumber t largestReal)
  _ -> Nothing

-- | Whether a token is a number for Java, and one that the property would admit.
admitted :: Expectation -> Text -> Bool
admitted expectation token = case expectation of
  ARealNumber range -> isJavaReal (within range) token
  AVector -> isJavaReal (const True) token
  AVectorWithoutZero -> isJavaReal (/= 0) token
  ADirection -> isJavaReal (const True) token
  TwoCoordinates -> isJavaReal (const True) token
  AColour _ -> isJavaReal (>= 0) token
  _ -> False
  where
    within = \case
      AnyNumber -> const True
      AtLeast low -> atLeast low
      Between low high -> \x -> atLeast low x && atMost high x
    atLeast low x = either (const False) (x >=) (real low)
    atMost high x = either (const False) (x <=) (real high)

-- | Whether a token is a number for Java whose value passes a test. Java's numbers may end in a letter for their type,
-- may be written in hexadecimal digits, and need not be finite. One that is not a number (NaN) or hexadecimal is taken
-- to pass.
--
-- Source: the documentation of the Java platform, @Double.valueOf(String)@, which gives their grammar.
isJavaReal :: (Double -> Bool) -> Text -> Bool
isJavaReal passes token
  | digits == "NaN" = True
  | digits == "Infinity" = passes (signed infinity)
  | Just hexadecimal <- Text.stripPrefix "0x" (Text.toLower digits) = isHexadecimal (Text.breakOn "p" hexadecimal)
  | Text.null digits || Text.isPrefixOf "+" digits || Text.isPrefixOf "-" digits = False
  | otherwise = case real (withoutType digits) of
    Right x -> passes (signed x)
    Left (TooLarge _) -> passes (signed infinity)
    Left _ -> False
  where
    (sign, digits) = Text.splitAt (if Text.take 1 token `elem` ["+", "-"] then 1 else 0) token
    signed = if sign == "-" then negate else id
    infinity = 1 / 0
    withoutType t = fromMaybe t (listToMaybe (mapMaybe (`Text.stripSuffix` t) ["d", "D", "f", "F"]))
    -- The digits, a point among them or none; and the exponent of two, which must be there.
    isHexadecimal (mantissa, power) =
      Text.any isHexDigit mantissa
        && Text.all isHexDigit (Text.replace "." "" mantissa)
        && Text.count "." mantissa <= 1
        && isRight (integer (Text.takeEnd 8 (withoutType (Text.drop 1 power))))

-------------------------------------------------------------------------------
-- Cameras, viewports, ray tracers

-- | What is otherwise with the objects of which there is one.
ofViewing :: [Object] -> [Diagnostic]
ofViewing objects =
  concat
    [ ofRepeated Keyword.Camera cameraSchema objects,
      ofRepeated Keyword.Viewport viewportSchema objects,
      ofRepeated Keyword.Raytracer raytracerSchema objects,
      maybe [] (uncurry ofViewport) (counting Keyword.Viewport viewportSchema objects),
      maybe [] (uncurry ofTracer) tracer,
      [note (placeOf Keyword.RecursiveLevel block) (LacksRayLimit mostRays) | Just (block, r) <- [tracer], mayExceed (raytracerRecursiveLevel r)]
    ]
  where
    tracer = counting Keyword.Raytracer raytracerSchema objects
    ofViewport block v =
      [note (placeOf Keyword.Width block) HalfAPixelOff | odd (viewportWidth v)]
        <> [note (placeOf Keyword.Height block) HalfAPixelOff | odd (viewportHeight v)]
        <> [note (placeOf Keyword.Width block) (DrawsPart drawn whole) | drawn < whole]
      where
        whole = toInteger (viewportWidth v) * toInteger (viewportHeight v)
        drawn = drawnOf (toInteger (maybe 1 (raytracerTask . snd) tracer)) (toInteger (viewportHeight v))
    -- One ray for each level where surfaces mirror or let through; two for each ray where one does both.
    mayExceed level
      | any (\m -> materialKr m /= 0 && materialKt m /= 0) materials = level > doublings
      | any (\m -> materialKr m /= 0 || materialKt m /= 0) materials = level > mostRays
      | otherwise = False
    -- So many levels, of one ray and twice as many on each further one, hold fewer rays than are followed.
    doublings = length (takeWhile (<= mostRays) (iterate (* 2) 2))
    materials = [m | (word, block) <- objects, Just m <- [materialOf word block]]

-- | How many pixels the console program of the original draws, of a picture that may be narrower: it takes the picture
-- for a square, and draws 101 packets of a hundredth of it each, rounded down, and then up to a multiple of the
-- threads.
drawnOf :: Integer -> Integer -> Integer
drawnOf task height = 101 * (((height * height `div` 100) + task - 1) `div` task * task)

-- | One that replaces another, and does not say again all that the other one said.
ofRepeated :: Keyword -> Schema a b -> [Object] -> [Diagnostic]
ofRepeated word schema objects = concat (zipWith3 repeated possible (drop 1 possible) (drop 1 (scanl (<>) Set.empty (map said possible))))
  where
    possible = [block | (w, block) <- objects, w == word, isJust (made schema block)]
    said block = Set.fromList [w | Statement p <- blockNodes block, Just w <- [headKeyword (propertyHead p)]]
    repeated before block earlier = [note (opening block) (StartsFromEarlier (spanLine (opening before))) | not (earlier `Set.isSubsetOf` said block)]

ofTracer :: Block -> Raytracer -> [Diagnostic]
ofTracer block r =
  concat
    [ [note (placeOf Keyword.PixelCoordinate block) DrawsByChance | raytracerPixelCoordinate r == Random],
      [note (placeOf Keyword.ReflexionAlgorithm block) (EndsAtPhong (algorithmName (raytracerAlgorithm r))) | raytracerAlgorithm r `elem` [Phong, PhongSpecular]],
      [note (placeOf Keyword.Space block) LosesHits | raytracerSpace r /= LinearSpace],
      [note (placeOf threads block) (StaysWithThreads (raytracerTask r)) | raytracerTask r > 1 || raytracerSampling r > 1],
      [note (headSpan word) (LacksWord (headText word)) | Statement (Property word _) <- blockNodes block, headKeyword word == Just Keyword.Seed]
    ]
  where
    threads = if raytracerTask r > 1 then Keyword.Task else Keyword.Sampling

-------------------------------------------------------------------------------
-- Everything else

-- | What is otherwise with one object: in a scene with that ray tracer, seen from that point, whose materials of these
-- names have textures.
ofObject :: Raytracer -> Point -> Set Text -> Object -> [Diagnostic]
ofObject tracer eye textured (word, block) = case word of
  Keyword.Primitive -> maybe [] ofPrimitive (made primitiveSchema block)
  Keyword.Material -> ofMaterial
  Keyword.TextureMaterial -> ofMaterial <> concatMap (ofFileName True) [Keyword.TextureKa, Keyword.TextureKd, Keyword.TextureKs]
  Keyword.Model -> [note (opening block) LeavesModelInPlace | Just m <- [made modelSchema block], isJust (modelFile m), modelTransform m /= Transform.identity] <> ofFileName False Keyword.File
  _ -> maybe [] ofLight (fst (runCheck (readLight block))) <> ofFileName True Keyword.Mask
  where
    ofPrimitive p = case [b | Object b <- blockNodes block, isJust (fst (runCheck (readShape b)))] of
      [] -> []
      inner : _ ->
        map (note (opening inner)) (ofShape eye (headText (blockHead inner)) (primitiveShape p))
          <> [ note (placeOf Keyword.MaterialName block) (LeavesTexture (headText (blockHead inner)))
               | primitiveMaterial p `Set.member` textured,
                 isPlainlySeen (primitiveShape p)
             ]
    ofMaterial =
      [ note (placeOf Keyword.Color block) EndsAtAlpha
        | Just m <- [materialOf word block],
          alpha (materialColour m) > 1,
          raytracerColourNormalization tracer == DivisionFactor,
          raytracerAlgorithm tracer == NoLight
      ]
    ofLight = \case
      LinearAperture {} -> [note (opening block) EndsAtRow]
      PlanarAperture Ellipse lamp _ _ -> note (opening block) (WritesAs (spelling Keyword.RectangularApertureLight)) : ofLamp lamp
      PlanarAperture _ lamp _ _ -> ofLamp lamp
      PointLight lamp -> ofLamp lamp
      Ambient _ -> []
      Directional _ _ -> []
    ofLamp lamp = [note (placeOf Keyword.ConstantAttenuator block) (EndsAtAttenuation tolerance) | (c, _, _) <- [lampAttenuators lamp], c < tolerance]
    -- Textures and masks are pictures, models are not.
    ofFileName picture property =
      [ note (valueSpan v) departure
        | Statement (Property w v) <- blockNodes block,
          headKeyword w == Just property,
          Right (Just name) <- [formRead fileName v],
          departure <- [KeepsBlanks | Text.stripEnd name /= name] <> [ReadsDds | picture, ".dds" `Text.isSuffixOf` Text.toLower (Text.stripEnd name)]
      ]

-- | The material that an object of that word is.
materialOf :: Keyword -> Block -> Maybe Material
materialOf word = case word of
  Keyword.Material -> made materialSchema
  Keyword.TextureMaterial -> made textureMaterialSchema
  _ -> const Nothing

-- | The names of materials that have a texture.
texturedNames :: [Object] -> Set Text
texturedNames objects = Map.keysSet (Map.filter (maybe False hasOne . materialTextures) named)
  where
    named = byName [(m, m) | (word, block) <- objects, Just m <- [materialOf word block]]
    hasOne ts = any isJust [textureKa ts, textureKd ts, textureKs ts]

-- | What is otherwise with a shape of that word, seen from a point.
ofShape :: Point -> Text -> Shape -> [Departure]
ofShape eye word = \case
  APlane s -> edgeOn [(planePosition s, planeNormal s)]
  ADisk s -> edgeOn [(planePosition (diskPlane s), planeNormal (diskPlane s))]
  AnAnnulus _ -> [LacksWord word]
  ASphere s -> [EndsFarAway word | distance eye (sphereCentre s) > farFromSphere * sphereRadius s]
  ACube s -> edgeOn [(cubeCentre s + (side * cubeSize s / 2) *^ n, n) | n <- [V3 1 0 0, V3 0 1 0, V3 0 0 1], side <- [-1, 1]]
  ATriangle s -> ofTriangle s
  ASmoothTriangle s -> ofTriangle (smoothTriangleFlat s) <> [LeavesNormals | Corners a b c <- [smoothTriangleNormals s], not (alike [a, b, c])]
  ATube s ->
    let (a, b) = (axisStart (roundAxis s), axisEnd (roundAxis s))
     in [RefusesNearPoints | and (nearlyEqual <$> a <*> b)] <> [EndsFarAway word | distance eye a > farFromTube * roundRadius s]
  ACylinder _ -> unseen
  ACone _ -> unseen
  ALens _ -> unseen
  ACap _ -> unseen
  ATorus _ -> unseen
  ATransformed _ _ -> unseen
  where
    unseen = [NeverHits word]
    edgeOn planes = [EndsEdgeOn word | or [abs (dot v (eye - p)) < tolerance | (p, n) <- planes, Just v <- [vector <$> unit n]]]
    ofTriangle s
      | Corners p0 p1 p2 <- trianglePoints s, modulus (cross (p1 - p0) (p2 - p0)) < tolerance = [RefusesSmallTriangle]
      | Corners p0 _ _ <- trianglePoints s = edgeOn [(p0, vector (triangleNormal s))]
    alike normals = case map unit normals of
      [] -> True
      n : others -> all (== n) others

-- | Whether rays meet the shape in the original, which has no texture coordinates for it.
isPlainlySeen :: Shape -> Bool
isPlainlySeen = \case
  APlane _ -> True
  ADisk _ -> True
  ASphere _ -> True
  ACube _ -> True
  ATriangle _ -> True
  ATube _ -> True
  _ -> False

-- * Numbers of the original

-- | Numbers below this are zero for it.
tolerance :: Double
tolerance = 1e-10

-- | Whether two numbers are the same for it.
nearlyEqual :: Double -> Double -> Bool
nearlyEqual a b = abs (a - b) < tolerance * max 1 (max (abs a) (abs b))

-- | It checks that a hit is on the sphere to 1e-10 of the radius, and on the tube to 1e-7. The error grows like 2^-53
-- k^2 at a distance of k radii, and comes to that near these k.
farFromSphere, farFromTube :: Double
farFromSphere = 1e3
farFromTube = 3e4
