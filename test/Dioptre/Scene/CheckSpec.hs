{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.CheckSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.List (nub, sort)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Geometry.Axis (axisEnd, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Lens (lensBody, lensCurvatures)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Triangle (Corners (..), smoothTriangleNormals, smoothTriangleUvs, triangleNormal, trianglePoints)
import Dioptre.Light.Material (Material (..))
import Dioptre.Math.Vector (vector)
import Dioptre.Scene.Camera
import Dioptre.Scene.Check (sceneWords)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Scene.Raytracer (defaultRaytracer)
import Dioptre.Scene.Unchecked (Scene (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Message (message)
import Dioptre.Source.Span (Span (..))
import Dioptre.Syntax.Keyword (allSpellings, fromSpelling, role, spelling)
import qualified Dioptre.Syntax.Keyword as Keyword
import Laws.Reading
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.Hspec hiding (Expectation)

spec :: Spec
spec = do
  recovery
  blocks
  once
  shapes
  materials
  values
  flaws
  notes
  wording
  it "knows every word that opens an object of the scene" $
    sort (map spelling sceneWords)
      `shouldBe` sort ["camera", "viewport", "raytracer", "primitive", "material", "texture_material", "ambient_light", "directional_light", "point_light", "linear_aperture_light", "rectangular_aperture_light", "elliptical_aperture_light", "aperture_mask_light", "model"]

-- | What follows is said of a text, errors and warnings, and nothing else.
saysOf :: [Text] -> [Diagnostic] -> IO ()
saysOf text wanted = filter ((> Note) . severity . diagnosticProblem) (readingDiagnostics (readLines text)) `shouldBe` wanted

sceneOf :: [Text] -> Scene
sceneOf = readingScene . readLines

cameraOf :: [Text] -> CameraSettings
cameraOf = cameraSettings . sceneCamera . sceneOf

shapesOf :: [Text] -> [Shape]
shapesOf = map primitiveShape . scenePrimitives . sceneOf

radii :: [Text] -> [Double]
radii text = [sphereRadius s | ASphere s <- shapesOf text]

-- | A primitive of a named material, with these lines in it, from line 2 on.
primitive :: [Text] -> [Text]
primitive inner = ["primitive"] <> inner <> ["end", "material", "name none", "end"]

recovery :: Spec
recovery = describe "a text that is not closed as it should be" $ do
  it "may have an end too many, which is passed over" $ do
    let text = ["end", "camera", " angle 20", "end", "  fin # too many", "viewport", "width 7", "end"]
    text `saysOf` [at 1 1 4 (StrayEnd "end"), at 5 3 6 (StrayEnd "fin")]
    settingAngle (cameraOf text) `shouldBe` 20
    viewportWidth (sceneViewport (sceneOf text)) `shouldBe` 7
  it "may have a slip in the word end, alone on its line" $
    for_ ["edn", "End.", "ned", "en", "nd", "endd", "EDN", "fn", "fni", "finn", "find"] $ \slip -> do
      let text = ["camera", "angle 20", "  " <> slip, "viewport", "width 7", "end"]
      text `saysOf` [on text 3 slip (MisspeltEnd slip)]
      settingAngle (cameraOf text) `shouldBe` 20
      viewportWidth (sceneViewport (sceneOf text)) `shouldBe` 7
  it "may have such a slip where nothing is open" $
    ["edn"] `saysOf` [at 1 1 4 (StrayEnd "edn")]
  it "has no slip where something follows, or where a word of the language stands" $ do
    let text = ["camera", "edn 20", "angle 30", "end"]
    map (code . diagnosticProblem) (errorsOf (readLines text)) `shouldBe` ["unknown-word"]
    settingAngle (cameraOf text) `shouldBe` 30
    -- One slip away from "en", which is one away from "end"; but a word.
    said ["material", "n", "name a", "end"] `shouldBe` [("missing-value", 2, 1, 2)]
  it "has every open object closed by a word of the scene" $ do
    let text = ["primitive", "material_name none", "geometry", "sphere", "ray 3", "camera", "angle 20", "end", "material", "name none", "end"]
    text
      `saysOf` [ at 1 1 10 (MissingEnd "primitive" (Just ("camera", 6))),
                 at 3 1 9 (MissingEnd "geometry" (Just ("camera", 6))),
                 at 4 1 7 (MissingEnd "sphere" (Just ("camera", 6)))
               ]
    settingAngle (cameraOf text) `shouldBe` 20
    [sphereRadius s | ATransformed _ (ASphere s) <- shapesOf text] `shouldBe` [3]
  it "has every open object closed by the end of the file, and built" $ do
    let text = ["material", "name none", "end", "primitive", "material_name none", "sphere", "ray 3"]
    text `saysOf` [at 4 1 10 (MissingEnd "primitive" Nothing), at 6 1 7 (MissingEnd "sphere" Nothing)]
    radii text `shouldBe` [3]
  it "may have a comment that is never closed, which is told where it opens" $ do
    let text = ["camera", "angle 20", "  /* look_at", "end", "# */", "x */", "/* */"]
    text `saysOf` [at 1 1 7 (MissingEnd "camera" Nothing), at 3 3 5 UnclosedComment]
    settingAngle (cameraOf text) `shouldBe` 20
  it "may be empty" $ do
    [] `saysOf` []
    readingScene (readText "") `shouldBe` Scene defaultCamera defaultViewport defaultRaytracer [] [] [] []

blocks :: Spec
blocks = describe "a word that cannot stand where it stands" $ do
  it "opens an object that is passed over whole, where it is unknown and alone" $ do
    let text = ["primitive", "material_name none", "sphre", "  ray 5", "  deeper", "    material_name x", "  end", "end", "sphere", "ray 2", "end", "end", "material", "name none", "end"]
    text `saysOf` [Diagnostic (Span 3 1 6) (UnknownWord "sphre" primitiveWords (Just "sphere") (TheObject 8))]
    radii text `shouldBe` [2]
    map primitiveMaterial (scenePrimitives (sceneOf text)) `shouldBe` ["none"]
  it "is passed over to the word of the scene that closes it" $ do
    let text = ["thing", "position 1 2 3", "other", "camera", "angle 20", "end"]
    map (\d -> (diagnosticSpan d, passed d)) (errorsOf (readLines text)) `shouldBe` [(Span 1 1 6, Just (TheObject 3))]
    settingAngle (cameraOf text) `shouldBe` 20
  it "is passed over to the end of the file" $
    map (\d -> (diagnosticSpan d, passed d)) (errorsOf (readLines ["thing", "position 1 2 3", "other", "x"])) `shouldBe` [(Span 1 1 6, Just (TheObject 4))]
  it "is passed over to an end with a slip in it" $
    map (\d -> (diagnosticSpan d, passed d)) (errorsOf (readLines ["thing", "position 1", "edn", "camera", "end"])) `shouldBe` [(Span 1 1 6, Just (TheObject 3))]
  it "is passed over alone where nothing is in it" $
    map passed (errorsOf (readLines ["camera", "end", "thing"])) `shouldBe` [Just TheOpening]
  it "is passed over with what is wrong in it" $
    said ["thing", "angle x", "end", "sphre", "ray", "end", "end", "sphere", "end"]
      `shouldBe` [("unknown-word", 1, 1, 6), ("unknown-word", 4, 1, 6), ("stray-end", 7, 1, 4), ("misplaced-word", 8, 1, 7)]
  it "is passed over whole where it is known" $ do
    let text = ["sphere", "ray 5", "cube", "end", "end", "camera", "plane", "normal 0 0 0", "end", "angle 20", "end"]
    text
      `saysOf` [ at 1 1 7 (MisplacedWord "sphere" Nothing (map spelling sceneWords) (TheObject 5)),
                 at 7 1 6 (MisplacedWord "plane" (Just "camera") cameraWords (TheObject 9))
               ]
    settingAngle (cameraOf text) `shouldBe` 20
  it "is passed over whole where nothing reads it" $
    for_ ["view_frustum", "default_material", "scene", "model_msr", "console_comparator", "comparateur_console", "particle", "systeme_particules", "texture_comparator"] $ \word ->
      said [word <> " 3", "position 1 2 3", "end", "camera", "end"] `shouldBe` [("misplaced-word", 1, 1, Text.length word + 1)]
  it "is a line of its own where it is unknown and something follows" $ do
    let text = ["camera", "angel 30", "  positio  1 2 3", "angle 20", "end", "foo bar"]
    text
      `saysOf` [ at 2 1 6 (UnknownWord "angel" cameraWords (Just "angle") TheLine),
                 at 3 3 10 (UnknownWord "positio" cameraWords (Just "position") TheLine),
                 at 6 1 4 (UnknownWord "foo" (map spelling sceneWords) Nothing TheLine)
               ]
    settingAngle (cameraOf text) `shouldBe` 20
  it "is a line of its own where it is a property of something else" $ do
    let text = ["position 1 2 3", "camera", "ray", "ka 0.5", "angle 20", "end"]
    text
      `saysOf` [ at 1 1 9 (MisplacedWord "position" Nothing (map spelling sceneWords) TheLine),
                 at 3 1 4 (MisplacedWord "ray" (Just "camera") cameraWords TheLine),
                 at 4 1 3 (MisplacedWord "ka" (Just "camera") cameraWords TheLine)
               ]
    settingAngle (cameraOf text) `shouldBe` 20
  it "is told with the word that may have been meant, and that fits there" $ do
    [g | Diagnostic _ (UnknownWord _ _ g _) <- errorsOf (readLines ["material", "colr red", "end", "camra", "end", "camera", "lok_at 1 2 3", "zzzzzz 3", "shinines 4", "end"])]
      `shouldBe` [Just "color", Just "camera", Just "look_at", Nothing, Nothing]
  it "leaves the rest alone: no word of the language is lost in the wrong place" $
    for_ [s | s <- allSpellings, Just k <- [fromSpelling s], role k == Keyword.NamesProperty || role k == Keyword.OpensInside] $ \word -> do
      let text = [word <> " 1", "end", "camera", "angle 20", "end"]
      settingAngle (cameraOf text) `shouldBe` 20
      length (errorsOf (readLines text)) `shouldBe` (if (role <$> fromSpelling word) == Just Keyword.OpensInside then 1 else 2)
  where
    passed d = case diagnosticProblem d of
      UnknownWord _ _ _ p -> Just p
      MisplacedWord _ _ _ p -> Just p
      _ -> Nothing
    cameraWords = ["end", "position", "look_at", "up", "angle", "near_clipping_plane", "far_clipping_plane"]
    primitiveWords = ["end", "material_name"] <> ["sphere", "plane", "disk", "annulus", "triangle", "btriangle", "tube", "cylinder", "cone", "cube", "spherical_cap", "lens", "torus", "geometry"]

once :: Spec
once = describe "an object of which there is one" $ do
  it "replaces the one before it, and starts from the defaults" $ do
    let text = ["camera", "angle 20", "position 1 2 3", "end", "camera", "position 4 5 6", "end"]
    settingAngle (cameraOf text) `shouldBe` 60
    settingPosition (cameraOf text) `shouldBe` V3 4 5 6
    readingDiagnostics (readLines text) `shouldBe` [at 5 1 7 (ReplacedObject "camera" 1)]
    let views = ["viewport", "width 7", "end", "viewport", "height 9", "end"]
    (viewportWidth (sceneViewport (sceneOf views)), viewportHeight (sceneViewport (sceneOf views))) `shouldBe` (500, 9)
    let tracers = ["raytracer", "sampling 1", "seed 5", "end", "raytracer", "end"]
    sceneRaytracer (sceneOf tracers) `shouldBe` defaultRaytracer
    readingDiagnostics (readLines tracers) `shouldBe` [at 5 1 10 (ReplacedObject "raytracer" 1)]
  it "leaves the one before it where it is impossible" $ do
    let text = ["camera", "angle 20", "end", "camera", "angle 30", "look_at 0 0 0", "end"]
    settingAngle (cameraOf text) `shouldBe` 20
    readingDiagnostics (readLines text) `shouldBe` [at 4 1 7 (ImpossibleObject "camera" NowhereToLook Superseded)]
  it "leaves the default where all are impossible" $
    sceneCamera (sceneOf ["camera", "angle 20", "up 0 0 1", "end"]) `shouldBe` defaultCamera
  it "is the last possible one of three, each told with the line of the one that it replaces" $ do
    let text = ["camera", "angle 20", "end", "camera", "angle 30", "end", "camera", "angle 40", "far_clipping_plane 0.5", "end", "camera", "angle 50", "end"]
    settingAngle (cameraOf text) `shouldBe` 50
    readingDiagnostics (readLines text)
      `shouldBe` [at 4 1 7 (ReplacedObject "camera" 1), at 7 1 7 (ImpossibleObject "camera" FarBeforeNear Superseded), at 11 1 7 (ReplacedObject "camera" 4)]

shapes :: Spec
shapes = describe "a shape" $ do
  it "is one to a primitive, the first" $ do
    let text = primitive ["material_name none", "sphere", "ray 2", "end", "cube", "size x", "oops", "end", "end", "sphere", "ray 3", "end"]
    text `saysOf` [at 6 1 5 (SecondShape "primitive"), at 11 1 7 (SecondShape "primitive")]
    radii text `shouldBe` [2]
  it "is one to a geometry" $ do
    let text = primitive ["material_name none", "geometry", "scale 2 2 2", "sphere", "end", "cube", "end", "end"]
    text `saysOf` [at 7 1 5 (SecondShape "geometry")]
    length [() | ATransformed _ (ASphere _) <- shapesOf text] `shouldBe` 1
  it "is missed in a primitive and in a geometry, and told once" $ do
    primitive ["material_name none"] `saysOf` [at 1 1 10 (ImpossibleObject "primitive" WithoutShape LeftOut)]
    primitive ["material_name none", "geometry", "end"] `saysOf` [at 3 1 9 (ImpossibleObject "geometry" WithoutShape LeftOut)]
    primitive ["material_name none", "sphere", "ray -1", "end"] `saysOf` [at 4 5 7 (RefusedValue "ray" (OutOfRange "-1") (ARealNumber (AtLeast "1.0e-10")) (Kept "1.0"))]
    primitive ["material_name none", "plane", "normal 0 0 0", "end"] `saysOf` [at 3 1 6 (ImpossibleObject "plane" (ZeroNormal 1e-10) LeftOut)]
  it "keeps the values before those that are refused" $ do
    let text = primitive ["material_name none", "sphere", "ray 2", "ray 0", "position 1 2 3", "position 1 2", "end"]
    text
      `saysOf` [ at 5 5 6 (RefusedValue "ray" (OutOfRange "0") (ARealNumber (AtLeast "1.0e-10")) (Kept "2.0")),
                 at 7 10 13 (RefusedValue "position" (WrongCount 3 2 NoGuess) AVector (Kept "[1.0, 2.0, 3.0]"))
               ]
    [(sphereCentre s, sphereRadius s) | ASphere s <- shapesOf text] `shouldBe` [(V3 1 2 3, 2)]
  it "of three points takes them as they come, and no fourth" $ do
    let text = primitive ["material_name none", "triangle", "point 0 0 5", "point 1 0 5", "POINT 0 1 5", "point 9 9 9", "end"]
    text `saysOf` [at 7 1 6 (RepeatedProperty "point" 3)]
    [trianglePoints t | ATriangle t <- shapesOf text] `shouldBe` [Corners (V3 0 0 5) (V3 1 0 5) (V3 0 1 5)]
  it "counts a point that is refused" $ do
    let text = primitive ["material_name none", "triangle", "point 0 0 5", "point x 0 5", "point 0 1 5", "point 0 0 7", "end"]
    text
      `saysOf` [ at 5 7 8 (RefusedValue "point" (NotANumber "x") AVector (Kept "[0.0, 1.0, 0.0]")),
                 at 7 1 6 (RepeatedProperty "point" 3)
               ]
    [trianglePoints t | ATriangle t <- shapesOf text] `shouldBe` [Corners (V3 0 0 5) (V3 0 1 0) (V3 0 1 5)]
  it "on an axis takes two points under either word, and no third" $
    for_ ["tube", "cylinder", "cone", "lens"] $ \word -> do
      let text = primitive ["material_name none", word, "point 1 0 0", "position 1 0 4", "point 5 5 5", "ray 0.5", "end"]
      text `saysOf` [at 6 1 6 (RepeatedProperty "point" 2)]
      map roundOf (shapesOf text) `shouldBe` [Just (V3 1 0 0, V3 1 0 4, 0.5)]
  it "with two curvatures takes them in order, and no third" $ do
    let text = primitive ["material_name none", "lens", "curvature 2", "curvature -3", "curvature 4", "end"]
    text `saysOf` [at 6 1 10 (RepeatedProperty "curvature" 2)]
    [lensCurvatures l | ALens l <- shapesOf text] `shouldBe` [(2, -3)]
  it "refuses the second end of an axis that is the first again" $ do
    let text = primitive ["material_name none", "tube", "point 1 0 0", "point 1 0 0", "end"]
    text `saysOf` [at 5 7 12 (RefusedValue "point" SamePoint AVector (Kept "[0.0, 0.0, 1.0]"))]
    [ends r | ATube r <- shapesOf text] `shouldBe` [(V3 1 0 0, V3 0 0 1)]
  it "has the flat normal at the corners of a smooth triangle that have none" $ do
    let text = primitive ["material_name none", "btriangle", "point 0 0 5", "point 1 0 5", "point 0 1 5", "normal 1 0 1", "normal 0 0 0", "uv 0.5 0.25", "end"]
    text `saysOf` [at 8 8 13 (RefusedValue "normal" ZeroVector ADirection TheDefault)]
    [smoothTriangleNormals t | ASmoothTriangle t <- shapesOf text] `shouldBe` [Corners (V3 1 0 1) (V3 0 0 1) (V3 0 0 1)]
    [smoothTriangleUvs t | ASmoothTriangle t <- shapesOf text] `shouldBe` [Corners (V2 0.5 0.25) 0 0]
  it "is turned as its points are" $
    [vector (triangleNormal t) | ATriangle t <- shapesOf (primitive ["triangle", "point 0 0 0", "point 0 1 0", "point 1 0 0", "end"])] `shouldBe` [V3 0 0 (-1)]
  where
    ends r = (axisStart (roundAxis r), axisEnd (roundAxis r))
    roundOf thing = case thing of
      ATube r -> Just (measures r)
      ACylinder r -> Just (measures r)
      ACone r -> Just (measures r)
      ALens l -> Just (measures (lensBody l))
      _ -> Nothing
    measures r = (axisStart (roundAxis r), axisEnd (roundAxis r), roundRadius r)

materials :: Spec
materials = describe "a material" $ do
  it "may stand before or after those who name it, and is named exactly" $ do
    let text = ["material", "name a b", "end", "primitive", "material_name a b", "sphere", "end", "end", "primitive", "material_name c", "sphere", "end", "end", "materiel", "nom c", "fin"]
    readingDiagnostics (readLines text) `shouldBe` []
  it "that is not there is replaced by a grey one of that name, told once a name" $ do
    let named n = ["primitive", "material_name " <> n, "sphere", "end", "end"]
        text = named "Red" <> named "red" <> named "Red" <> ["material", "name red", "end"]
    text `saysOf` [at 2 15 18 (MissingMaterial "Red" (Just "red"))]
    map (\m -> (materialName m, materialKa m, materialKd m, materialKs m, materialShininess m)) (sceneMaterials (sceneOf text))
      `shouldBe` [("red", 0.2, 0.8, 0.5, 20), ("Red", 0.2, 0.6, 0.7, 20)]
  it "counts blanks at the end of a name" $
    primitive ["material_name none ", "sphere", "end"] `saysOf` [at 2 15 20 (MissingMaterial "none " (Just "none"))]
  it "that is not named at all is one called none, which is a note" $
    readingDiagnostics (readLines ["primitive", "sphere", "end", "end"]) `shouldBe` [at 1 1 10 NoMaterialName]
  it "whose name is taken is kept, and does not count" $ do
    let text = ["material", "name a", "kd 0.25", "end", "material", "kd 0.5", "name a", "end", "material", "name a", "end"]
    text `saysOf` [at 7 6 7 (RepeatedMaterial "a" 2), at 10 6 7 (RepeatedMaterial "a" 2)]
    map materialKd (sceneMaterials (sceneOf text)) `shouldBe` [0.25, 0.5, 0.8]
  it "without a name is called none" $
    ["material", "end", "material", "end"] `saysOf` [at 3 1 9 (RepeatedMaterial "none" 1)]

-- | What is told of a text, notes left out, in English and in French.
isTold :: [Text] -> [(Text, Text)] -> IO ()
isTold text wanted =
  [(message English p, message French p) | p <- map diagnosticProblem (readingDiagnostics (readLines text)), severity p > Note] `shouldBe` wanted

wording :: Spec
wording = describe "what is told" $ do
  it "proposes nothing for a single sign, and only words of the place" $ do
    ["camera", "} 1", "ÿ 1", "up 0 1 0", "end"] `isTold` [("unknown word '}'", "mot inconnu\xA0: '}'"), ("unknown word 'ÿ'", "mot inconnu\xA0: 'ÿ'")]
    ["material", "name a", ". 1", "x 1", "end"] `isTold` [("unknown word '.'", "mot inconnu\xA0: '.'"), ("unknown word 'x'", "mot inconnu\xA0: 'x'")]
    ["sphre 1"] `isTold` [("unknown word 'sphre'", "mot inconnu\xA0: 'sphre'")]
  it "proposes a word that was written with accents, blanks or other signs, or in another order" $ do
    ["lumière ponctuelle"] `isTold` [("unknown word 'lumière'; did you mean 'lumiere_ponctuelle'?", "mot inconnu\xA0: 'lumière'\xA0; vouliez-vous dire 'lumiere_ponctuelle'\xA0?")]
    let guess text = [g | UnknownWord _ _ g _ <- map diagnosticProblem (readingDiagnostics (readLines text))]
    map (guess . pure) ["lumière directionnelle", "lumiere", "materiel_texture", "camera{", "Matériel"]
      `shouldBe` map (pure . Just) ["lumiere_directionnelle", "lumiere_ponctuelle", "texture_materiel", "camera", "materiel"]
    map (\line -> guess ["camera", line, "end"]) ["look at 0 0 1", "angle=60", "angle:60", "position[0,0,1] x", "angle\xA0\&60"]
      `shouldBe` map (pure . Just) ["look_at", "angle 60", "angle 60", "position [0,0,1]", "angle 60"]
    map (\line -> guess (primitive ["sphere", line, "end"])) ["radius 2", "centre 0 0 1"] `shouldBe` map (pure . Just) ["ray", "position"]
    ["material", "name a", "color \"red\"", "end"] `isTold` [("'\"red\"' means nothing to 'color'; did you mean 'red'?", "'\"red\"' ne dit rien à 'color'\xA0; vouliez-vous dire 'red'\xA0?")]
    map (\line -> guess (primitive ["torus", line, "end"])) ["rayon_majeur 2", "rayon_mineur 2"] `shouldBe` map (pure . Just) ["major_radius", "minor_radius"]
  it "is of a name that is missing that alone" $
    ["primitive", "  material_name", "  sphere", "  end", "end"] `isTold` [("'material_name' has no value", "'material_name' n'a pas de valeur")]
  it "is of a name that is taken the line that has it" $
    ["material", "nom a", "kd 0.5", "name", "end", "material", "nom a", "end"]
      `isTold` [ ("'name' has no value", "'name' n'a pas de valeur"),
                 ("a material is called 'a' already, on line 2", "un matériel s'appelle déjà 'a', à la ligne 2")
               ]
  it "proposes a name that differs by case and by blanks at its end, which are counted" $ do
    let named n = ["material", "name café  ", "end", "primitive", "material_name " <> n, "sphere", "end", "end"]
    named "café"
      `isTold` [("no material is called 'café'; did you mean 'café  ' with 2 blanks at its end?", "aucun matériel ne s'appelle 'café'\xA0; vouliez-vous dire 'café  ' avec 2 blancs à la fin\xA0?")]
    named "CAFÉ "
      `isTold` [("no material is called 'CAFÉ ' with 1 blank at its end; did you mean 'café  ' with 2 blanks at its end?", "aucun matériel ne s'appelle 'CAFÉ ' avec 1 blanc à la fin\xA0; vouliez-vous dire 'café  ' avec 2 blancs à la fin\xA0?")]
  it "says of a name with a remark behind it that it goes to the end of its line" $ do
    let named a b = ["material", "name " <> a, "end", "primitive", "material_name " <> b, "sphere", "end", "end"]
    named "paint # la peinture" "paint"
      `isTold` [("no material is called 'paint'; did you mean 'paint # la peinture'? A name is all that stands up to the end of its line", "aucun matériel ne s'appelle 'paint'\xA0; vouliez-vous dire 'paint # la peinture'\xA0? Un nom est tout ce qui vient jusqu'à la fin de sa ligne")]
    named "paint" "paint  // oak"
      `isTold` [("no material is called 'paint  // oak'; did you mean 'paint'? A name is all that stands up to the end of its line", "aucun matériel ne s'appelle 'paint  // oak'\xA0; vouliez-vous dire 'paint'\xA0? Un nom est tout ce qui vient jusqu'à la fin de sa ligne")]
  it "names characters that are not seen, or are not what they look like" $ do
    primitive ["sphere", "ray\xA0\&2 x", "end"]
      `isTold` [("unknown word 'ray\xA0\&2', which holds a no-break space (U+00A0); did you mean 'ray 2'?", "mot inconnu\xA0: 'ray\xA0\&2', qui contient une espace insécable (U+00A0)\xA0; vouliez-vous dire 'ray 2'\xA0?")]
    ["camera", "position 0 0 \x2212\&5.0", "end"]
      `isTold` [("'\x2212\&5.0' is not a number; it holds a minus sign that is not '-' (U+2212)", "'\x2212\&5.0' n'est pas un nombre\xA0; il contient un signe moins qui n'est pas '-' (U+2212)")]
    ["ÿþc\NULa\NULm\NUL 1"]
      `isTold` [("unknown word 'ÿþc\NULa\NULm\NUL', which holds NUL characters, as UTF-16 has them: save the file as UTF-8", "mot inconnu\xA0: 'ÿþc\NULa\NULm\NUL', qui contient des caractères NUL, comme en UTF-16\xA0: enregistrez le fichier en UTF-8")]
  it "counts in the singular, and knows signs that do not belong to values" $ do
    ["camera", "up 1", "position = [1, 2, 3];", "angle = 60", "end"]
      `isTold` [ ("1 value, where 'up' takes 3", "1 valeur, où 'up' en prend 3"),
                 ("5 values, where 'position' takes 3; values follow their word, without '=', ':' or ';'", "5 valeurs, où 'position' en prend 3\xA0; les valeurs suivent leur mot, sans '=', ':' ni ';'"),
                 ("'=' is not a number; values follow their word, without '=', ':' or ';'", "'=' n'est pas un nombre\xA0; les valeurs suivent leur mot, sans '=', ':' ni ';'")
               ]
    ["camera", "angle 60\xB0", "end", "material", "ka 20%", "kd %", "end"]
      `isTold` [ ("'60\xB0' is not a number; angles are in degrees, without '\xB0'", "'60\xB0' n'est pas un nombre\xA0; les angles sont en degrés, sans '\xB0'"),
                 ("'20%' is not a number; numbers have no '%': 20% is 0.2", "'20%' n'est pas un nombre\xA0; les nombres n'ont pas de '%'\xA0: 20% s'écrit 0.2"),
                 ("'%' is not a number", "'%' n'est pas un nombre")
               ]
    ["material", "color 1 1", "color bleue", "end"]
      `isTold` [ ("'1' is the name of no colour; a colour in numbers takes three of them, or four", "'1' n'est le nom d'aucune couleur\xA0; en nombres, une couleur en prend trois ou quatre"),
                 ("'bleue' means nothing to 'color'; did you mean 'bleu'?", "'bleue' ne dit rien à 'color'\xA0; vouliez-vous dire 'bleu'\xA0?")
               ]
  it "is of a colour, too, that comments and ends have lines of their own" $ do
    let told line = isTold ["material", "name a", line, "end"]
    told "color red # rouge" [("'red' names a colour, behind which stands nothing but an alpha; a comment needs a line of its own", "'red' nomme une couleur, derrière laquelle ne vient rien qu'un alpha\xA0; un commentaire doit avoir sa propre ligne")]
    told "color 1 0 0 # rouge" [("5 values, where 'color' takes 4; a comment needs a line of its own", "5 valeurs, où 'color' en prend 4\xA0; un commentaire doit avoir sa propre ligne")]
    for_ ["color red #rouge", "color 1 0 0 #rouge"] (`told` [("'#rouge' is not a number; a comment needs a line of its own", "'#rouge' n'est pas un nombre\xA0; un commentaire doit avoir sa propre ligne")])
    told "color red end" [("'end' is not a number; 'end' needs a line of its own", "'end' n'est pas un nombre\xA0; 'end' doit avoir sa propre ligne")]
    ["camera", "up 0 1 0 fin", "end"] `isTold` [("4 values, where 'up' takes 3; 'fin' needs a line of its own", "4 valeurs, où 'up' en prend 3\xA0; 'fin' doit avoir sa propre ligne")]
  it "is of an object whether it has a property or a number behind its word, and of nothing else there" $ do
    primitive ["material_name none", "sphere ray 3", "end"] `isTold` [("'ray' is not read behind 'sphere': a property has a line of its own", "'ray' n'est pas lu derrière 'sphere'\xA0: une propriété a sa propre ligne")]
    (filter ((== "behind-opening") . code . diagnosticProblem) . readingDiagnostics . readLines) (primitive ["sphere (3)", "end"]) `shouldBe` [at 2 9 10 (BehindOpening "sphere" "3")]
    ["camera Angle 20", "end"] `saysOf` [at 1 8 13 (BehindOpening "camera" "Angle")]
    for_ [["camera # angle", "end"], ["camera the angle", "end"], ["camera 2", "end"], ["camera ray", "end"]] $ \text -> text `saysOf` []

values :: Spec
values = describe "a value" $ do
  it "that is missing is told at its word" $ do
    ["camera", "  angle", "position  ", "up ,()", "end"]
      `saysOf` [ at 2 3 8 (RefusedValue "angle" NothingThere (ARealNumber (Between "10.0" "170.0")) (Kept "60.0 degrees")),
                 at 3 1 9 (RefusedValue "position" NothingThere AVector (Kept "[0.0, 0.0, 0.0]")),
                 at 4 4 7 (RefusedValue "up" NothingThere AVector (Kept "[0.0, 1.0, 0.0]"))
               ]
    ["material", "name ", "color", "end"]
      `saysOf` [at 2 1 5 (RefusedValue "name" NothingThere SomeText (Kept "none")), at 3 1 6 (RefusedValue "color" NothingThere (AColour colours) (Kept "[ 1.0, 1.0, 1.0, 1.0 ]"))]
  it "that is no number is told where it stands" $
    ["camera", "angle\t 60degrees", "position [1.0,  1.O, 2.0]", "end"]
      `saysOf` [ at 2 8 17 (RefusedValue "angle" (NotANumber "60degrees") (ARealNumber (Between "10.0" "170.0")) (Kept "60.0 degrees")),
                 at 3 17 20 (RefusedValue "position" (NotANumber "1.O") AVector (Kept "[0.0, 0.0, 0.0]"))
               ]
  it "is told in the case in which its word is written" $
    ["camera", "ANGLE x", "end"] `saysOf` [at 2 7 8 (RefusedValue "ANGLE" (NotANumber "x") (ARealNumber (Between "10.0" "170.0")) (Kept "60.0 degrees"))]
  it "that is no integer, or too large a one, is told" $
    ["raytracer", "sampling 2.0", "task 3000000000", "seed -1", "recursive_level 0", "end"]
      `saysOf` [ at 2 10 13 (RefusedValue "sampling" (NotAnInteger "2.0") (AnInteger (AtLeast "1")) (Kept "1")),
                 at 3 6 16 (RefusedValue "task" (TooLarge "3000000000") (AnInteger (AtLeast "1")) (Kept "1")),
                 at 4 6 8 (RefusedValue "seed" (OutOfRange "-1") (AnInteger (AtLeast "0")) (Kept "0")),
                 at 5 17 18 (RefusedValue "recursive_level" (OutOfRange "0") (AnInteger (AtLeast "1")) (Kept "1"))
               ]
  it "above 1e100 is told" $
    ["camera", "position 0 -1e101 0", "end"] `saysOf` [at 2 12 18 (RefusedValue "position" (TooLarge "-1e101") AVector (Kept "[0.0, 0.0, 0.0]"))]
  it "of too many numbers is told at the first too many" $ do
    ["camera", "position 1 2 3 4 5", "look_at 1 2 3 # here", "up 1,5 0 0", "end"]
      `saysOf` [ at 2 16 17 (RefusedValue "position" (WrongCount 3 5 NoGuess) AVector (Kept "[0.0, 0.0, 0.0]")),
                 at 3 15 16 (RefusedValue "look_at" (WrongCount 3 5 CommentBehind) AVector (Kept "[0.0, 0.0, 1.0]")),
                 at 4 10 11 (RefusedValue "up" (WrongCount 3 4 CommaInNumber) AVector (Kept "[0.0, 1.0, 0.0]"))
               ]
    ["material", "color 1 1 1 1 1", "end"] `saysOf` [at 2 15 16 (RefusedValue "color" (WrongCount 4 5 NoGuess) (AColour colours) (Kept "[ 1.0, 1.0, 1.0, 1.0 ]"))]
  it "of one number that stops at a comma is read, with a warning" $
    for_ [("20,5", [at 2 7 11 (DecimalComma "angle" "20")]), ("20, 5", []), ("20 ,5", []), ("20.5, degrees", [])] $ \(value, wanted) -> do
      let text = ["camera", "angle " <> value, "end"]
      (value, readingDiagnostics (readLines text)) `shouldBe` (value, wanted)
      settingAngle (cameraOf text) `shouldSatisfy` (`elem` [20, 20.5])
  it "that is no colour is told" $
    ["material", "color rde", "color 1 -0.5 1", "color blue 2 3", "color red x", "end"]
      `saysOf` [ at 2 7 10 (RefusedValue "color" (NoSuchChoice "rde" (Just "red")) (AColour colours) (Kept "[ 1.0, 1.0, 1.0, 1.0 ]")),
                 at 3 9 13 (RefusedValue "color" (OutOfRange "-0.5") (AColour colours) (Kept "[ 1.0, 1.0, 1.0, 1.0 ]")),
                 at 4 7 11 (RefusedValue "color" (NameAmongNumbers "blue" NoGuess) (AColour colours) (Kept "[ 1.0, 1.0, 1.0, 1.0 ]")),
                 at 5 11 12 (RefusedValue "color" (NotANumber "x") (AColour colours) (Kept "[ 1.0, 1.0, 1.0, 1.0 ]"))
               ]
  it "that is negative leaves the object as it was" $
    map materialKd (sceneMaterials (sceneOf ["material", "name a", "color -1 0 0", "kd 0.25", "end"])) `shouldBe` [0.25]
  it "that is none of the words, or no number of one, is told" $ do
    ["raytracer", "space voxle", "pixel_coordinate 6", "color_normalization -1", "end"]
      `saysOf` [ at 2 7 12 (RefusedValue "space" (NoSuchChoice "voxle" (Just "voxel")) (AChoice ["linear", "voxel", "multi_voxel"]) (Kept "linear")),
                 at 3 18 19 (RefusedValue "pixel_coordinate" (OutOfRange "6") (AChoice ["top_left", "top_right", "bottom_left", "bottom_right", "center", "random"]) (Kept "top_left")),
                 at 4 21 23 (RefusedValue "color_normalization" (OutOfRange "-1") (AChoice ["clamp_channel", "division_factor"]) (Kept "clamp_channel"))
               ]
  it "of a scale has no zero in it" $
    primitive ["material_name none", "geometry", "scale 1 0 1", "sphere", "end", "end"]
      `saysOf` [at 4 7 12 (RefusedValue "scale" ZeroComponent AVectorWithoutZero (Kept "[1.0, 1.0, 1.0]"))]
  it "of a picture's name leads nowhere else" $
    for_ ["../x", "a\\b", "/x", "a\ESCb", "a\0"] $ \name ->
      ["viewport", "image_file_name " <> name, "end"] `saysOf` [at 2 17 (17 + Text.length name) (RefusedValue "image_file_name" UnsafeName AnOutputName (Kept "image"))]
  it "may be at the ends of its range, and no farther" $
    for_
      [ ("camera", "angle", "10", "170", "9.999", "170.001"),
        ("camera", "near_clipping_plane", "1e-10", "100", "0.99e-10", "1e101"),
        ("material", "ka", "0", "1", "-1e-300", "1.0000001"),
        ("material", "kd", "0", "1", "-0.1", "1.1"),
        ("material", "ks", "0", "1", "-0.1", "1.1"),
        ("material", "kr", "0", "1", "-0.1", "1.1"),
        ("material", "kt", "0", "1", "-0.1", "1.1"),
        ("material", "p", "0", "1", "-0.1", "1.1"),
        ("material", "shininess", "0", "200", "-0.1", "200.1"),
        ("material", "n", "1e-10", "10", "0", "10.1"),
        ("point_light", "amplification", "0", "1e100", "-1", "1e101"),
        ("point_light", "linear_attenuator", "0", "1e100", "-1", "1e101"),
        ("rectangular_aperture_light", "width", "1e-8", "1", "0.99e-10", "-1"),
        ("rectangular_aperture_light", "height", "1e-8", "1", "0.99e-10", "-1"),
        ("rectangular_aperture_light", "wave_length", "380", "780", "0", "-1"),
        ("rectangular_aperture_light", "period_iteration", "1", "2147483647", "0", "2147483648"),
        ("rectangular_aperture_light", "nb_oscillator", "0", "100", "-1", "2147483648"),
        ("viewport", "width", "1", "500000", "0", "2147483648"),
        ("viewport", "height", "1", "500000", "0", "2147483648"),
        ("raytracer", "task", "1", "2147483647", "0", "2147483648"),
        ("raytracer", "seed", "0", "2147483647", "-1", "2147483648")
      ]
      $ \(object, word, low, high, below, above) -> do
        for_ [low, high] $ \value -> (word, value, said (one object word value)) `shouldBe` (word, value, [])
        for_ [below, above] $ \value -> (word, value, map place (said (one object word value))) `shouldBe` (word, value, [(2, Text.length word + 2)])
  where
    one object word value = [object, word <> " " <> value, "end"]
    place (_, line, column, _) = (line, column)
    colours = ["black", "noir", "white", "blanc", "red", "rouge", "green", "vert", "blue", "bleu"]

flaws :: Spec
flaws = describe "an object that its values do not make" $ do
  it "is told at its word, with what becomes of it" $ do
    for_ impossible $ \(flaw, fate, object, inner) ->
      (flaw, errorsOf (readLines ([object] <> inner <> ["end"]))) `shouldBe` (flaw, [at 1 1 (Text.length object + 1) (ImpossibleObject object flaw fate)])
    for_ impossibleShapes $ \(flaw, object, inner) ->
      (flaw, errorsOf (readLines (primitive (["material_name none", object] <> inner <> ["end"])))) `shouldBe` (flaw, [at 3 1 (Text.length object + 1) (ImpossibleObject object flaw LeftOut)])
  it "is not in the scene" $ do
    for_ impossible $ \(_, _, object, inner) -> do
      let scene = sceneOf ([object] <> inner <> ["end"])
      (length (sceneLights scene), sceneCamera scene, sceneViewport scene) `shouldBe` (0, defaultCamera, defaultViewport)
    for_ impossibleShapes $ \(_, object, inner) -> shapesOf (primitive ([object] <> inner <> ["end"])) `shouldBe` []
  it "is just possible a little farther" $
    for_ possible $ \(object, inner) -> (object, inner, said (primitive ([object] <> inner <> ["end"]))) `shouldBe` (object, inner, [])
  where
    impossible =
      [ (NowhereToLook, Superseded, "camera", ["look_at 0 0 9e-11"]),
        (UpAlongFront, Superseded, "camera", ["up 0 0 5"]),
        (UpAlongFront, Superseded, "camera", ["up 0 0 0"]),
        (FarBeforeNear, Superseded, "camera", ["near_clipping_plane 5", "far_clipping_plane 4.99"]),
        (TooManyPixels mostPixels, Superseded, "viewport", ["width 2147483647", "height 2147483647"]),
        (ZeroOrientation 1e-10, LeftOut, "directional_light", ["orientation 0 0 0.5e-10"]),
        (NoAttenuation, LeftOut, "point_light", ["constant_attenuator 0"]),
        (NoAttenuation, LeftOut, "lumiere_ponctuelle", ["constant_attenuator 0", "linear_attenuator 1", "linear_attenuator 0"]),
        (InvisibleWavelength 380 780, LeftOut, "linear_aperture_light", ["wave_length 379.99 nm"]),
        (InvisibleWavelength 380 780, LeftOut, "aperture_mask_light", ["wave_length 780.01"]),
        (TooManyOscillators 1000000, LeftOut, "linear_aperture_light", ["nb_oscillator 1000001"]),
        (TooManyOscillators 1000000, LeftOut, "rectangular_aperture_light", ["nb_oscillator 1001"]),
        (UpAlongFront, LeftOut, "elliptical_aperture_light", ["front 0 1 0"]),
        (UpAlongFront, LeftOut, "rectangular_aperture_light", ["up 0 0 0"])
      ]
    impossibleShapes =
      [ (ZeroNormal 1e-10, "plane", ["normal 0 0 0.9e-10"]),
        (ZeroNormal 1e-10, "disque", ["normale 0 0 0"]),
        (ZeroNormal 1e-10, "annulus", ["normal 0 0 0"]),
        (ZeroNormal 1e-10, "tore", ["normal 0 0 0"]),
        (ZeroNormal 1e-10, "spherical_cap", ["normal 0 0 0"]),
        (CollinearPoints, "triangle", ["point 0 0 0", "point 1 1 1", "point 3 3 3"]),
        (CollinearPoints, "btriangle", ["point 0 0 0", "point 0 0 0", "point 3 3 4"]),
        (EqualPoints, "tube", ["point 0 0 1"]),
        (EqualPoints, "cone", ["point 0 0 1"]),
        (InnerBeyondOuter, "anneau", ["rayon_interieur 1.01"]),
        (InnerBeyondOuter, "annulus", ["ray 0.49"]),
        (CurvatureBelowRadius, "spherical_cap", ["ray 2", "curvature -1.99"]),
        (CurvatureBelowRadius, "lens", ["ray 2", "curvature 2", "curvature 1.9"]),
        (LensTooThin, "lens", ["point 0 0 0", "point 0 0 0.5", "curvature -1", "curvature 1.0e9"])
      ]
    possible =
      [ ("plane", ["normal 0 0 1.1e-10"]),
        ("triangle", ["point 0 0 0", "point 1 1 1", "point 3 3 3.0001"]),
        ("tube", ["point 0 0 0", "point 0 0 1e-300"]),
        ("annulus", ["inner_ray 1"]),
        ("annulus", ["inner_ray 0"]),
        ("spherical_cap", ["ray 2", "curvature -2"]),
        ("lens", ["ray 2", "curvature 2", "curvature 2"]),
        ("lens", ["point 0 0 0", "point 0 0 1.5", "curvature -1", "curvature -1e9"]),
        ("torus", ["major_radius 1", "minor_radius 5"])
      ]

notes :: Spec
notes = describe "what is no mistake" $ do
  it "is warned of: several rays through one point" $ do
    ["raytracer", "sampling 4", "end"] `saysOf` [at 2 10 11 (SamplingWithoutRandom 4)]
    ["raytracer", "sampling 4", "pixel_coordinate random", "end"] `saysOf` []
    ["raytracer", "sampling 1", "pixel_coordinate center", "end"] `saysOf` []
  it "is an error, a warning or a note" $ do
    map severity [UnclosedComment, StrayEnd "end", RepeatedProperty "point" 3, SecondShape "primitive"] `shouldBe` replicate 4 Error
    map severity [MissingMaterial "a" Nothing, RepeatedMaterial "a" 1, SamplingWithoutRandom 2] `shouldBe` replicate 3 Warning
    map severity [NoMaterialName, ReplacedObject "camera" 1] `shouldBe` replicate 2 Note
  it "is told in the order of the file, whatever was found first" $ do
    let text = ["primitive", "material_name x", "sphere", "oops 1", "end", "raytracer", "sampling 2", "end", "material", "name a", "ka 7", "end", "material", "name a"]
        lines' = [spanLine (diagnosticSpan d) | d <- readingDiagnostics (readLines text)]
    lines' `shouldBe` sort lines'
    nub lines' `shouldBe` [1, 2, 4, 7, 11, 13, 14]
