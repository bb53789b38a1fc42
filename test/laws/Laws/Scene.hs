{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Scene
-- Description : What is true of every scene, and scenes that put it to the test
--
-- Scenes are built by the constructors of the program, from values that are spread over all that the language admits.
-- They are written in two ways: by the program, and by this module, which knows the language from its description only
-- and writes it as people do, in any spelling, case, order and layout.
module Laws.Scene
  ( -- * Scenes
    AnyScene (..),

    -- * Laws
    printedReadsBack,
    printingSettles,
    disguisedReadsBack,
    isSound,
    readsTheSameTwice,

    -- * Writing as people do
    Piece (..),
    Writing (..),
    pieces,
    disguised,

    -- * Parts of scenes
    someShape,
    shapesNames,
  )
where

import Control.Monad (join)
import Data.Char (isControl, toUpper)
import Data.Functor ((<&>))
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Geometry.Axis (axis, axisEnd, axisStart, roundAxis, roundRadius, roundShape)
import Dioptre.Geometry.Cap (cap, capCurvature, capDisk)
import Dioptre.Geometry.Cube
import Dioptre.Geometry.Disk
import Dioptre.Geometry.Lens (lens, lensBody, lensCurvatures)
import Dioptre.Geometry.Plane
import Dioptre.Geometry.Shape
import Dioptre.Geometry.Sphere
import Dioptre.Geometry.Torus (torus, torusMajor, torusMinor, torusPlane)
import Dioptre.Geometry.Triangle
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Light.Light
import Dioptre.Light.Material
import Dioptre.Math.Transform
import Dioptre.Math.Vector (Vector, modulus, vector)
import qualified Dioptre.Math.Vector as Vector
import Dioptre.Scene (sceneSolids, writeScene)
import Dioptre.Scene.Camera
import Dioptre.Scene.Model
import Dioptre.Scene.Primitive
import Dioptre.Scene.Raytracer
import Dioptre.Scene.Unchecked (Scene (..))
import Laws.Number (admitted)
import Laws.Reading (Reading (..), errorsOf, readBytes, readText)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Numeric (showEFloat, showFFloat)
import Test.QuickCheck hiding (vector, within)

-------------------------------------------------------------------------------
-- Laws

-- | Reading what was written of a scene gives that scene, to the last bit, without an error.
printedReadsBack :: Scene -> Property
printedReadsBack scene = givesExactly (readBytes (Text.encodeUtf8 (writeScene scene))) scene

-- | Writing, reading and writing again gives the same text.
printingSettles :: Scene -> Property
printingSettles scene = writeScene (readingScene (readText written)) === written
  where
    written = writeScene scene

-- | A scene is read as it was meant, in any spelling, case, order and layout, without an error.
disguisedReadsBack :: Scene -> Property
disguisedReadsBack scene = forAll (disguised (pieces scene)) $ \text -> givesExactly (readText text) scene

-- | Reading a text, writing the scene and reading that gives the same scene, without an error.
readsTheSameTwice :: Reading -> Property
readsTheSameTwice r = gives (readText (writeScene (readingScene r))) (readingScene r)

gives :: Reading -> Scene -> Property
gives r scene = errorsOf r === [] .&&. readingScene r === scene

-- | The same, to the sign of zeros, which only a scene that is shown tells.
givesExactly :: Reading -> Scene -> Property
givesExactly r scene = gives r scene .&&. show (readingScene r) === show scene

-- | Every value of a scene is within its range, every object is possible, and every primitive's material is there.
isSound :: Scene -> Property
isSound s =
  conjoin
    [ check "camera" $
        10 <= settingAngle c && settingAngle c <= 170 && settingNear c >= 1e-10 && settingFar c >= settingNear c
          && Vector.valid (cameraFront (sceneCamera s))
          && Vector.valid (cameraUp (sceneCamera s))
          && abs (Vector.dot (vector (cameraFront (sceneCamera s))) (vector (cameraUp (sceneCamera s)))) < 1e-15 * 8,
      check "viewport" $
        let v = sceneViewport s in viewportWidth v >= 1 && viewportHeight v >= 1 && safe (viewportImage v),
      check "raytracer" $
        let r = sceneRaytracer s in all (>= 1) [raytracerTask r, raytracerSampling r, raytracerRecursiveLevel r] && raytracerSeed r >= 0,
      check "materials of primitives" (all ((`elem` map materialName (sceneMaterials s)) . primitiveMaterial) (scenePrimitives s)),
      check "solids" (sceneSolids materialName s == [(primitiveShape p, primitiveMaterial p) | p <- scenePrimitives s]),
      conjoin [check (show m) (material m) | m <- sceneMaterials s],
      conjoin [check (show l) (light l) | l <- sceneLights s],
      conjoin [check (show p) (shape (primitiveShape p)) | p <- scenePrimitives s],
      conjoin [check (show m) (notElem 0 (transformScale (modelTransform m)) && all said (modelFile m)) | m <- sceneModels s],
      check "numbers" (all (all numbers) (pieces s))
    ]
  where
    check name = counterexample ("unsound: " <> name)
    c = cameraSettings (sceneCamera s)
    safe t = said t && not (Text.any (\x -> x `elem` ("/\\" :: String) || isControl x) t)
    said t = not (Text.null t) && not (Text.any (`elem` ("\r\n" :: String)) t)
    fraction x = 0 <= x && x <= 1
    colour (Colour r g b a) = all (>= 0) [r, g, b, a]
    material m =
      said (materialName m) && colour (materialColour m)
        && all fraction [materialKa m, materialKd m, materialKs m, materialKr m, materialKt m, materialPlasticity m]
        && (0 <= materialShininess m && materialShininess m <= 200)
        && (0 < materialRefractiveIndex m && materialRefractiveIndex m <= 10)
        && maybe True (\t -> all (all said) [textureKa t, textureKd t, textureKs t]) (materialTextures m)
    lamp l = colour (lampColour l) && lampAmplification l >= 0 && let (k, k', k'') = lampAttenuators l in all (>= 0) [k, k', k''] && any (> 0) [k, k', k'']
    wave w = 380 <= waveLength w && waveLength w <= 780 && wavePeriodIteration w >= 1 && waveOscillators w >= 0
    light source = case source of
      Ambient k -> colour k
      Directional k v -> colour k && modulus v >= 1e-10
      PointLight l -> lamp l
      LinearAperture l w _ -> lamp l && wave w
      PlanarAperture opening l w a ->
        lamp l && wave w && apertureWidth a >= 1e-10 && apertureHeight a >= 1e-10
          && modulus (apertureFront a) >= 1e-10
          && (case opening of Mask m -> all said m; _ -> True)
    shape thing = case thing of
      APlane p -> onPlane p
      ADisk d -> onPlane (diskPlane d) && diskRadius d >= 1e-10
      AnAnnulus a -> onPlane (annulusPlane a) && 0 <= annulusInner a && annulusInner a <= annulusOuter a && annulusOuter a >= 1e-10
      ASphere b -> sphereRadius b >= 1e-10
      ACube b -> cubeSize b >= 1e-10
      ATriangle t -> Vector.valid (triangleNormal t)
      ASmoothTriangle t -> let Corners a b d = smoothTriangleNormals t in all ((>= 1e-10) . modulus) [a, b, d]
      ATube r -> around r
      ACylinder r -> around r
      ACone r -> around r
      ALens l -> around (lensBody l) && let (a, b) = lensCurvatures l in all ((>= roundRadius (lensBody l)) . abs) [a, b]
      ACap k -> onPlane (diskPlane (capDisk k)) && abs (capCurvature k) >= diskRadius (capDisk k)
      ATorus t -> onPlane (torusPlane t) && torusMajor t >= 1e-10 && torusMinor t >= 1e-10
      ATransformed t inner -> notElem 0 (transformScale t) && shape inner
    onPlane p = modulus (planeNormal p) >= 1e-10
    around r = axisStart (roundAxis r) /= axisEnd (roundAxis r) && roundRadius r >= 1e-10
    numbers piece = case piece of
      Sub _ inner -> all (all numbers) inner
      Is _ (Real x) -> finite x
      Is _ (Vec v) -> all finite v
      Is _ (Pair u) -> all finite u
      Is _ (Col (Colour r g b a)) -> all finite [r, g, b, a]
      Is _ _ -> True
    finite x = abs x <= 1e100

-------------------------------------------------------------------------------
-- Writing as people do

-- | A part of a scene as the language's description has it: any of the spellings of its word, and what it says.
data Piece
  = Is [Text] Writing
  | -- | An object. Things in one of the lists stand in that order; otherwise in any.
    Sub [Text] [[Piece]]
  deriving (Eq, Show)

-- | What a property says.
data Writing
  = Real Double
  | Whole Int
  | Vec Vector
  | Pair (V2 Double)
  | Col Colour
  | -- | The number of a word, and the word.
    Word' Int Text
  | Verbatim Text
  deriving (Eq, Show)

-- | All that there is to say of a scene.
pieces :: Scene -> [[Piece]]
pieces s =
  [ [ Sub
        ["camera"]
        [ [Is ["position"] (Vec (settingPosition c))],
          [Is ["look_at"] (Vec (settingLookAt c))],
          [Is ["up", "haut"] (Vec (settingUp c))],
          [Is ["angle"] (Real (settingAngle c))],
          [Is ["near_clipping_plane"] (Real (settingNear c))],
          [Is ["far_clipping_plane"] (Real (settingFar c))]
        ]
    ],
    [ Sub
        ["viewport"]
        [ [Is ["width", "largeur"] (Whole (viewportWidth v))],
          [Is ["height", "hauteur"] (Whole (viewportHeight v))],
          [Is ["image_file_name", "nom_fichier_image"] (Verbatim (viewportImage v))]
        ]
    ],
    [ Sub
        ["raytracer"]
        [ [Is ["task"] (Whole (raytracerTask r))],
          [Is ["sampling"] (Whole (raytracerSampling r))],
          [Is ["recursive_level"] (Whole (raytracerRecursiveLevel r))],
          [Is ["seed", "graine"] (Whole (raytracerSeed r))],
          [Is ["reflexion_algorithm", "algorithme_reflexion"] (algorithm (raytracerAlgorithm r))],
          [Is ["pixel_coordinate", "coordonnee_pixel"] (coordinate (raytracerPixelCoordinate r))],
          [Is ["space", "espace"] (space (raytracerSpace r))],
          [Is ["color_normalization"] (normalization (raytracerColourNormalization r))]
        ]
    ],
    [ Sub ["model"] ([[Is ["file", "fichier"] (fileNamed (modelFile m))], [Is ["uv_format"] (uvFormat (modelUvFormat m))]] <> moved (modelTransform m))
      | m <- sceneModels s
    ],
    [ Sub ["primitive"] [[Is ["material_name", "nom_materiel"] (Verbatim (primitiveMaterial p))], [shapePiece (primitiveShape p)]]
      | p <- scenePrimitives s
    ],
    map materialPiece (sceneMaterials s),
    map lightPiece (sceneLights s)
  ]
  where
    c = cameraSettings (sceneCamera s)
    v = sceneViewport s
    r = sceneRaytracer s
    algorithm a = case a of
      NoLight -> Word' 0 "no_light"
      AmbientOnly -> Word' 1 "ambient"
      DiffuseOnly -> Word' 2 "diffuse"
      PhongSpecular -> Word' 3 "phong_specular"
      BlinnSpecular -> Word' 4 "blinn_specular"
      NoSpecular -> Word' 5 "no_specular"
      Phong -> Word' 6 "phong"
      Blinn -> Word' 7 "blinn"
    coordinate a = case a of
      TopLeft -> Word' 0 "top_left"
      TopRight -> Word' 1 "top_right"
      BottomLeft -> Word' 2 "bottom_left"
      BottomRight -> Word' 3 "bottom_right"
      Center -> Word' 4 "center"
      Random -> Word' 5 "random"
    space a = case a of
      LinearSpace -> Word' 0 "linear"
      VoxelSpace -> Word' 1 "voxel"
      MultiVoxelSpace -> Word' 2 "multi_voxel"
    normalization a = case a of
      ClampChannel -> Word' 0 "clamp_channel"
      DivisionFactor -> Word' 1 "division_factor"
    uvFormat a = case a of
      UvDefault -> Word' 0 "default"
      UvTopLeft -> Word' 1 "origin_uv_top_left"
      UvBottomLeft -> Word' 2 "origin_uv_bottom_left"

moved :: Transform -> [[Piece]]
moved t =
  [ [Is ["scale", "homothetie"] (Vec (transformScale t))],
    [Is ["rotation"] (Vec (transformRotation t))],
    [Is ["translation"] (Vec (transformTranslation t))]
  ]

-- | The name of a file, or the word for none.
fileNamed :: Maybe Text -> Writing
fileNamed = Verbatim . fromMaybe "none"

materialPiece :: Material -> Piece
materialPiece m = case materialTextures m of
  Nothing -> Sub ["material", "materiel", "color_material", "blinn_material"] properties
  Just t ->
    Sub ["texture_material", "texture_materiel"] $
      properties
        <> [ [Is ["texture_ka"] (fileNamed (textureKa t))],
             [Is ["texture_kd"] (fileNamed (textureKd t))],
             [Is ["texture_ks"] (fileNamed (textureKs t))]
           ]
  where
    properties =
      [ [Is ["name", "nom"] (Verbatim (materialName m))],
        [Is ["color", "couleur"] (Col (materialColour m))],
        [Is ["ka"] (Real (materialKa m))],
        [Is ["kd"] (Real (materialKd m))],
        [Is ["ks"] (Real (materialKs m))],
        [Is ["kr"] (Real (materialKr m))],
        [Is ["kt"] (Real (materialKt m))],
        [Is ["shininess", "brillance"] (Real (materialShininess m))],
        [Is ["plasticity", "p"] (Real (materialPlasticity m))],
        [Is ["refractive_index", "n"] (Real (materialRefractiveIndex m))]
      ]

lightPiece :: Light -> Piece
lightPiece source = case source of
  Ambient k -> Sub ["ambient_light", "lumiere_ambiante"] [colour k]
  Directional k v -> Sub ["directional_light", "lumiere_directionnelle"] [colour k, [Is ["orientation"] (Vec v)]]
  PointLight l -> Sub ["point_light", "lumiere_ponctuelle"] (place l : lamp l)
  LinearAperture l w (a, b) -> Sub ["linear_aperture_light"] ([Is ["position", "point"] (Vec a), Is ["position", "point"] (Vec b)] : lamp l <> wave w)
  PlanarAperture Rectangle l w a -> Sub ["rectangular_aperture_light"] (place l : lamp l <> wave w <> aperture a)
  PlanarAperture Ellipse l w a -> Sub ["elliptical_aperture_light"] (place l : lamp l <> wave w <> aperture a)
  PlanarAperture (Mask m) l w a -> Sub ["aperture_mask_light"] ([Is ["mask", "masque"] (fileNamed m)] : place l : lamp l <> wave w <> aperture a)
  where
    colour k = [Is ["color", "couleur"] (Col k)]
    place l = [Is ["position"] (Vec (lampPosition l))]
    lamp l =
      let (k, k', k'') = lampAttenuators l
       in [ colour (lampColour l),
            [Is ["amplification"] (Real (lampAmplification l))],
            [Is ["constant_attenuator"] (Real k)],
            [Is ["linear_attenuator"] (Real k')],
            [Is ["quadratic_attenuator"] (Real k'')]
          ]
    wave w =
      [ [Is ["wave_length", "longueur_onde"] (Real (waveLength w))],
        [Is ["period_iteration"] (Whole (wavePeriodIteration w))],
        [Is ["nb_oscillator"] (Whole (waveOscillators w))]
      ]
    aperture a =
      [ [Is ["width", "largeur"] (Real (apertureWidth a))],
        [Is ["height", "hauteur"] (Real (apertureHeight a))],
        [Is ["front", "devant"] (Vec (apertureFront a))],
        [Is ["up", "haut"] (Vec (apertureUp a))]
      ]

shapePiece :: Shape -> Piece
shapePiece thing = case thing of
  APlane p -> Sub ["plane", "plan"] (onPlane p)
  ADisk d -> Sub ["disk", "disque"] (overDisk d)
  AnAnnulus a -> Sub ["annulus", "anneau"] (onPlane (annulusPlane a) <> [radius (annulusOuter a), [Is ["inner_ray", "rayon_interieur"] (Real (annulusInner a))]])
  ASphere b -> Sub ["sphere"] [[Is ["position"] (Vec (sphereCentre b))], radius (sphereRadius b)]
  ACube b -> Sub ["cube"] [[Is ["position"] (Vec (cubeCentre b))], [Is ["size", "taille"] (Real (cubeSize b))]]
  ATriangle t -> Sub ["triangle"] [points (trianglePoints t)]
  ASmoothTriangle t ->
    let Corners n0 n1 n2 = smoothTriangleNormals t
        Corners u0 u1 u2 = smoothTriangleUvs t
     in Sub
          ["btriangle"]
          [ points (trianglePoints (smoothTriangleFlat t)),
            map (Is ["normal", "normale"] . Vec) [n0, n1, n2],
            map (Is ["uv"] . Pair) [u0, u1, u2]
          ]
  ATube r -> Sub ["tube"] (around r)
  ACylinder r -> Sub ["cylinder", "cylindre"] (around r)
  ACone r -> Sub ["cone"] (around r)
  ALens l -> let (a, b) = lensCurvatures l in Sub ["lens", "lentille"] (around (lensBody l) <> [map (Is ["curvature", "courbure"] . Real) [a, b]])
  ACap k -> Sub ["spherical_cap", "calotte_spherique"] ([Is ["curvature", "courbure"] (Real (capCurvature k))] : overDisk (capDisk k))
  ATorus t -> Sub ["torus", "tore"] (onPlane (torusPlane t) <> [[Is ["major_radius"] (Real (torusMajor t))], [Is ["minor_radius"] (Real (torusMinor t))]])
  ATransformed t inner -> Sub ["geometry", "geometrie"] ([shapePiece inner] : moved t)
  where
    onPlane p = [[Is ["position"] (Vec (planePosition p))], [Is ["normal", "normale"] (Vec (planeNormal p))]]
    overDisk d = onPlane (diskPlane d) <> [radius (diskRadius d)]
    radius x = [Is ["ray", "rayon"] (Real x)]
    points (Corners a b c) = map (Is ["point"] . Vec) [a, b, c]
    around r = [map (Is ["position", "point"] . Vec) [axisStart (roundAxis r), axisEnd (roundAxis r)], radius (roundRadius r)]

-- | A text that says so, in any order that keeps what has an order, any spelling, any case and any layout, with
-- comments between.
disguised :: [[Piece]] -> Gen Text
disguised groups = do
  body <- inAnyOrder groups >>= traverse (disguisedPiece 0) >>= commented . concat
  ends <- frequency [(3, pure "\n"), (1, pure "\r\n"), (1, pure "\r")]
  final <- elements [ends, ""]
  pure (Text.intercalate ends body <> final)

-- | Lists merged at random, each kept in its order.
inAnyOrder :: [[a]] -> Gen [a]
inAnyOrder groups = case filter (not . null) groups of
  [] -> pure []
  rest -> do
    i <- chooseInt (0, length rest - 1)
    let (before, after) = splitAt i rest
    case after of
      (x : xs) : others -> (x :) <$> inAnyOrder (before <> (xs : others))
      _ -> pure []

disguisedPiece :: Int -> Piece -> Gen [Text]
disguisedPiece depth piece = case piece of
  Is words' writing -> do
    word <- elements words' >>= inAnyCase
    value <- disguisedValue writing
    blank <- gap
    pure . (<> (blank <> value)) <$> indented word
  Sub words' inner -> do
    opening <- elements words' >>= inAnyCase >>= remarked >>= indented
    body <- inAnyOrder inner >>= traverse (disguisedPiece (depth + 1))
    closing <- elements ["end", "fin"] >>= inAnyCase >>= remarked >>= indented
    pure (opening : concat body <> [closing])
  where
    indented t = (<> t) <$> elements [Text.replicate depth "  ", "", "\t", " \t\f "]
    -- What follows these words is ignored.
    remarked t = (t <>) <$> elements ["", "", " ", " # sphere", "\t3.0 end"]

gap :: Gen Text
gap = elements [" ", "  ", "\t", "\f", " \t "]

inAnyCase :: Text -> Gen Text
inAnyCase t =
  frequency
    [ (4, pure t),
      (1, pure (Text.toUpper t)),
      (1, Text.pack <$> traverse (\c -> elements [c, toUpper c]) (Text.unpack t))
    ]

disguisedValue :: Writing -> Gen Text
disguisedValue writing = case writing of
  Real x -> realText x >>= bracketed >>= rest
  Whole n -> elements ["", if n < 0 then "" else "+"] >>= \sign -> bracketed (sign <> Text.pack (show n)) >>= rest
  Vec v -> tuple (foldr (:) [] v)
  Pair u -> tuple (foldr (:) [] u)
  Col (Colour r g b a) -> do
    let named = [name | (k, names) <- colours, k == (r, g, b), not (any isNegativeZero [r, g, b]), name <- names]
    channels <- traverse realText [r, g, b]
    opacity <- realText a
    name <- if null named then pure Nothing else elements (Nothing : map Just named) >>= traverse inAnyCase
    short <- elements [True, False]
    separated (maybe channels pure name <> [opacity | not short || a /= 1])
  Word' n t -> oneof [pure (Text.pack (show n)), inAnyCase t] >>= bracketed >>= rest
  Verbatim t -> pure t
  where
    tuple xs = traverse realText xs >>= separated
    rest t = (t <>) <$> elements ["", " ", " degrees", "\tpixels # 3", " 7 8 9", ", 4"]
    bracketed t = elements [t, t, "[" <> t <> "]", "( " <> t]
    colours =
      [ ((0, 0, 0), ["black", "noir"]),
        ((1, 1, 1), ["white", "blanc"]),
        ((1, 0, 0), ["red", "rouge"]),
        ((0, 1, 0), ["green", "vert"]),
        ((0, 0, 1), ["blue", "bleu"])
      ]

-- | Tokens with any of the separators between and around them.
separated :: [Text] -> Gen Text
separated ts = do
  (open, close) <- elements [("[", "]"), ("(", ")"), ("<", ">"), ("", ""), ("[ ", " ] "), ("((", "")]
  between <- elements [", ", ",", " ", "\t", " , ,", "\f"]
  pure (open <> Text.intercalate between ts <> close)

-- | A number in some notation. What the notations mean is the business of "Laws.Number".
realText :: Double -> Gen Text
realText x =
  Text.pack
    <$> elements
      ( [show x, map toUpper (show x), showEFloat Nothing x ""]
          <> (if positive then ['+' : show x, "00" <> show x] else [])
          <> [showFFloat Nothing x "" | abs x < 1e9]
      )
  where
    positive = x >= 0 && not (isNegativeZero x)

-- | Lines with comments and empty lines between them.
commented :: [Text] -> Gen [Text]
commented lines' = concat <$> traverse (\t -> (<> [t]) <$> frequency [(8, pure []), (1, oneof remarks)]) lines'
  where
    remarks =
      [ pure [""],
        pure [" \t"],
        (\c t -> [c <> t]) <$> elements ["#", "/", "*", "-", "!", "@", "//", "  # ", "/**", "*/"] <*> elements ["", " end", "sphere", " */ camera"],
        pure ["/* sphere */"],
        (\inner -> ["/*"] <> inner <> ["*/"]) <$> sublistOf ["camera", "end", "/*", "# */", "x */", "", "primitive"],
        pure ["\t/* */ end"],
        (\inner -> ["  /* camera"] <> inner <> ["  */ end"]) <$> sublistOf ["fin", "*/x", "**/"]
      ]

-------------------------------------------------------------------------------
-- Generators

-- | Any scene that the language can say.
newtype AnyScene = AnyScene {anyScene :: Scene}
  deriving (Eq, Show)

instance Arbitrary AnyScene where
  arbitrary = AnyScene <$> someScene
  shrink (AnyScene s) = map AnyScene (fewer s)

someScene :: Gen Scene
someScene = do
  materials <- listOfUpTo 4 someMaterial
  primitives <- if null materials then pure [] else listOfUpTo 5 (Primitive <$> elements (map materialName materials) <*> someShape 3)
  models <- listOfUpTo 2 (Model <$> fileLine <*> someTransform <*> arbitraryBoundedEnum)
  lights <- listOfUpTo 4 someLight
  c <- someCamera
  v <- someViewport
  r <- someRaytracer
  pure (Scene c v r models primitives materials lights)

-- | The same scene with less in it.
fewer :: Scene -> [Scene]
fewer s =
  [s {scenePrimitives = ps} | ps <- shrinkList (const []) (scenePrimitives s)]
    <> [s {sceneLights = ls} | ls <- shrinkList (const []) (sceneLights s)]
    <> [s {sceneModels = ms} | ms <- shrinkList (const []) (sceneModels s)]
    <> [s {sceneMaterials = ms} | ms <- shrinkList (const []) (sceneMaterials s), all ((`elem` map materialName ms) . primitiveMaterial) (scenePrimitives s)]

listOfUpTo :: Int -> Gen a -> Gen [a]
listOfUpTo n g = chooseInt (0, n) >>= (`vectorOf` g)

-- | Text that may stand at the end of a line: not empty, no line end in it, no blank before it.
line :: Gen Text
line = Text.pack <$> oneof [pure "none", elements ["a", "red", "end", "# 1", "/*", "x ", "b\t", "[1, 2]", "m\233tal", "\1046 \128512", "\160x", "y\133z", "\1234\8232"], word]
  where
    word = (:) <$> visible <*> resize 8 (listOf (oneof [visible, elements " \t\f"]))
    visible = arbitraryUnicodeChar `suchThat` (`notElem` (" \t\f\r\n" :: String))

-- | The same for the name of a file to read, if there is one.
fileLine :: Gen (Maybe Text)
fileLine = (\t -> if t == "none" then Nothing else Just t) <$> line

-- | The same for the name of a file to write.
outputLine :: Gen Text
outputLine = line `suchThat` (not . Text.any (\c -> c == '/' || c == '\\' || isControl c))

vector3 :: Gen Vector
vector3 = V3 <$> admitted <*> admitted <*> admitted

-- | A length that the language takes for greater than zero.
lengthOf :: Gen Double
lengthOf = frequency [(6, max 1e-10 . abs <$> admitted), (1, pure 1e-10), (2, choose (0.1, 3))]

direction :: Gen Vector
direction = oneof [vector3, elements [V3 1 0 0, V3 0 0 (-1), V3 1e-10 0 0]] `suchThat` ((>= 1e-10) . modulus)

within :: Double -> Double -> Gen Double
within low high = frequency [(1, pure low), (1, pure high), (4, choose (low, high))]

someColour :: Gen Colour
someColour =
  oneof
    [ Colour <$> channel <*> channel <*> channel <*> within 0 1,
      (\(r, g, b) -> Colour r g b) <$> elements [(0, 0, 0), (1, 1, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1)] <*> elements [1, 0.5]
    ]
  where
    channel = oneof [within 0 1, abs <$> admitted]

someCamera :: Gen Camera
someCamera = (camera <$> settings) `suchThatMap` either (const Nothing) Just
  where
    settings = do
      (near, far) <- (\a b -> (min a b, max a b)) <$> lengthOf <*> lengthOf
      CameraSettings <$> vector3 <*> vector3 <*> vector3 <*> within 10 170 <*> pure near <*> pure far

someViewport :: Gen Viewport
someViewport = (viewport <$> side <*> side <*> outputLine) `suchThatMap` either (const Nothing) Just
  where
    side = oneof [chooseInt (1, 2000), pure 1, chooseInt (1, 268435456)]

someRaytracer :: Gen Raytracer
someRaytracer =
  Raytracer <$> count <*> count <*> count <*> arbitraryBoundedEnum <*> arbitraryBoundedEnum <*> arbitraryBoundedEnum <*> arbitraryBoundedEnum
    <*> oneof [pure 0, count]

count :: Gen Int
count = oneof [pure 1, chooseInt (1, 100), chooseInt (1, 2147483647), pure 2147483647]

someTransform :: Gen Transform
someTransform = (transform <$> vector3 <*> vector3 <*> vector3) `suchThatMap` id

someMaterial :: Gen Material
someMaterial =
  Material <$> line <*> someColour <*> fraction <*> fraction <*> fraction <*> fraction <*> fraction <*> within 0 200 <*> fraction <*> within 1e-10 10
    <*> oneof [pure Nothing, Just <$> (Textures <$> fileLine <*> fileLine <*> fileLine)]
  where
    fraction = within 0 1

someLight :: Gen Light
someLight =
  oneof
    [ Ambient <$> someColour,
      Directional <$> someColour <*> direction,
      PointLight <$> lamp vector3,
      -- The position of a linear light is between its ends.
      LinearAperture <$> lamp (pure 0) <*> wave <*> ((,) <$> vector3 <*> vector3),
      do
        a <- aperture
        w <- wave
        let (longer, shorter) = (max (apertureWidth a) (apertureHeight a), min (apertureWidth a) (apertureHeight a))
            fits = if longer / shorter < 100 then min 90 (waveOscillators w) else min 1 (waveOscillators w)
        PlanarAperture <$> oneof [pure Rectangle, pure Ellipse, Mask <$> fileLine] <*> lamp vector3 <*> pure w {waveOscillators = fits} <*> pure a
    ]
  where
    lamp place = (Lamp <$> someColour <*> place <*> part <*> ((,,) <$> part <*> part <*> part)) `suchThat` attenuates
    part = oneof [pure 0, pure 1, abs <$> admitted]
    -- The number of sources is limited, and so is that of a narrow aperture, which has many along its longer side.
    wave = Wave <$> within 380 780 <*> count <*> chooseInt (0, 1000)
    aperture = (Aperture <$> lengthOf <*> lengthOf <*> direction <*> direction) `suchThat` (\a -> maybe False ((>= 1e-10) . modulus) (Vector.cross <$> madeUnit (apertureFront a) <*> madeUnit (apertureUp a)))
    madeUnit v = Vector.vector <$> Vector.unit v

-- | A shape of any kind, transformed shapes at most so many deep.
someShape :: Int -> Gen Shape
someShape depth = do
  kind <- elements [0 .. if depth > 0 then 13 else 12 :: Int]
  (kindOfShape kind >>= maybe (pure Nothing) (pure . Just)) `suchThatMap` id
  where
    kindOfShape kind = case kind of
      0 -> fmap APlane <$> somePlane
      1 -> fmap ADisk <$> someDisk
      2 -> onPlane $ \p -> (\a b -> AnAnnulus <$> annulus p (min a b) (max 1e-10 (max a b))) <$> (abs <$> admitted) <*> lengthOf
      3 -> (\c r -> ASphere <$> sphere c r) <$> vector3 <*> lengthOf
      4 -> (\c r -> ACube <$> cube c r) <$> vector3 <*> lengthOf
      5 -> fmap ATriangle . triangle <$> corners vector3
      6 -> do
        flat <- triangle <$> corners vector3
        normals <- corners (oneof [pure Nothing, Just <$> direction])
        uvs <- corners (V2 <$> admitted <*> admitted)
        pure ((\t -> ASmoothTriangle (smoothTriangle t normals uvs)) <$> flat)
      7 -> fmap ATube <$> someRound
      8 -> fmap ACylinder <$> someRound
      9 -> fmap ACone <$> someRound
      10 -> someRound >>= traverse (\r -> (\c c' -> ALens <$> lens r (c, c')) <$> curvature (roundRadius r) <*> curvature (roundRadius r)) <&> join
      11 -> someDisk >>= traverse (\d -> fmap ACap . cap d <$> curvature (diskRadius d)) <&> join
      12 -> onPlane $ \p -> (\a b -> ATorus <$> torus p a b) <$> lengthOf <*> lengthOf
      _ -> (\t -> Just . ATransformed t) <$> someTransform <*> someShape (depth - 1)
    somePlane = plane <$> vector3 <*> direction
    onPlane make = somePlane >>= maybe (pure Nothing) make
    someDisk = onPlane (\p -> disk p <$> lengthOf)
    someRound = (\a b r -> axis a b >>= (`roundShape` r)) <$> vector3 <*> vector3 <*> lengthOf
    corners g = Corners <$> g <*> g <*> g
    curvature r = (\s k -> s * min 1e100 (r * k)) <$> elements [1, -1] <*> oneof [pure 1, choose (1, 3), choose (1, 1e6)]

-- | The words of the shapes in a scene, to see that all are drawn.
shapesNames :: Scene -> [Text]
shapesNames s = concatMap (names . shapePiece . primitiveShape) (scenePrimitives s)
  where
    names piece = case piece of
      Sub (word : _) inner -> word : concatMap names (concat inner)
      _ -> []
