{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.OriginalSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.List (isSuffixOf, nub, sort)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Scene.Original (departures)
import Dioptre.Source.Departure (Departure (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Message (message, used)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (decode, fromText)
import Dioptre.Syntax.Grammar (parse)
import Laws.Reading
import Laws.Text (Noise (..), SceneText (..))
import System.Directory (listDirectory)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (conjoin, counterexample)

spec :: Spec
spec = do
  describe "what the original does otherwise" $ do
    for_ samples $ \sample ->
      it (Text.unpack (code (Departs (departure sample))) <> ": " <> about sample) $ do
        notesOf (withIt sample) `shouldBe` [uncurry3 at (place sample) (Departs (departure sample))]
        notesOf (withoutIt sample) `shouldBe` []
    it "is told once for each property, each object, each place" $ do
      let text = [["viewport", "width 33", "height 35", "end"], torus, torus, ["model", "file a.obj ", "scale 2 2 2", "end"]]
      [(code p, spanLine s) | Diagnostic s p <- notesOf (concat text)]
        `shouldBe` [ ("original-half-a-pixel-off", 2),
                     ("original-half-a-pixel-off", 3),
                     ("original-never-hits", 6),
                     ("original-never-hits", 11),
                     ("original-leaves-model-in-place", 15),
                     ("original-keeps-blanks", 16)
                   ]
    it "counts packets of pixels for each thread" $
      -- Two pixels a packet, rounded up to four for as many threads, in 101 packets.
      [p | Diagnostic _ (Departs p@(DrawsPart _ _)) <- notesOf ["raytracer", "task 4", "end", "viewport", "width 40", "height 16", "end"]] `shouldBe` [DrawsPart 404 640]
  describe "each of them" $ do
    prop "is said in both languages" . conjoin $ [counterexample (show d) (isSaidInBothLanguages (Departs d)) | d <- all']
    prop "has a code for programs" . conjoin $ map (hasAStableCode . Departs) all'
    it "is a note" $ nub (map (severity . Departs) all') `shouldBe` [Note]
    it "says what the original does, and what is used here" $
      for_ all' $ \d -> do
        message English (Departs d) `shouldSatisfy` Text.isInfixOf "the original"
        message French (Departs d) `shouldSatisfy` Text.isInfixOf "l'original"
        map (\l -> used l (Departs d)) [English, French] `shouldNotContain` [Nothing]
    it "has a code of its own, which the specification lists" $ do
      annex <- Text.readFile "spec/C-differences.md"
      let listed = [c | line <- Text.lines annex, Just rest <- [Text.stripPrefix "| `original-" line], let c = "original-" <> Text.takeWhile (/= '`') rest]
      sort listed `shouldBe` sort (nub (map (code . Departs . departure) samples))
  describe "scenes" $ do
    it "of ours have notes in their text, in order" $ do
      paths <- filter (".txt" `isSuffixOf`) <$> listDirectory "scenes"
      length paths `shouldSatisfy` (> 30)
      for_ paths $ \path -> do
        text <- Text.readFile ("scenes/" <> path)
        let notes = notesIn (readText text)
        [n | n@(Diagnostic (Span line from to) _) <- notes, Text.take 1 (Text.drop (from - 1) (Text.lines text !! (line - 1))) == "" || from >= to] `shouldBe` []
        map diagnosticSpan notes `shouldBe` sort (map diagnosticSpan notes)
    it "whose pictures are the original's have none" $
      -- The pictures of these two were made by the original (test/golden).
      for_ ["intro_plan.txt", "intro_disque.txt"] $ \path -> do
        text <- Text.readFile ("scenes/" <> path)
        notesIn (readText text) `shouldBe` []
    modifyMaxSuccess (`div` 2) . prop "of any text have notes that stand in it" $ \(SceneText text) ->
      let r = readText text in standsInTheText r {readingDiagnostics = notesIn r}
    modifyMaxSuccess (`div` 2) . prop "of any bytes have notes that stand in them" $ \(Noise bytes) ->
      let r = readSource (decode "scene.txt" bytes) in standsInTheText r {readingDiagnostics = notesIn r}
  where
    all' = map departure samples <> more
    -- The same with other words and numbers.
    more = [HidesLines Nothing, StaysWithThreads 1, DrawsPart 0 200]
    uncurry3 f (a, b, c) = f a b c

-- | What is noted of a reading.
notesIn :: Reading -> [Diagnostic]
notesIn r = departures (readingSource r) (parse (readingSource r)) (readingDiagnostics r)

notesOf :: [Text] -> [Diagnostic]
notesOf = notesIn . readSource . fromText "scene.txt" . Text.unlines

-- | One thing that the original does otherwise, a scene that shows it, where, and one that is nearly the same and does
-- not.
data Sample = Sample
  { about :: String,
    departure :: Departure,
    place :: (Int, Int, Int),
    withIt :: [Text],
    withoutIt :: [Text]
  }

samples :: [Sample]
samples =
  [ -- Reading
    Sample "down to the line that closes the block" (HidesLines (Just 5)) (2, 3, 5) ["camera", "  /* here */", "  angle 20", "end", " */ and"] ["camera", "/*", "angle 20 */", "*/", "angle 30", "/** stars */", "end"],
    Sample "at the level of the file" EndsScene (3, 1, 4) ["camera", "end", "end"] ["camera", "end", "edn"],
    Sample "an unknown word alone on its line" ReadsAround (2, 3, 8) ["primitive", "  sphre", "  ray 2", "  end", "sphere", "end", "end"] ["primitive", "sphre 2", "sphere", "end", "end"],
    Sample "a word that cannot stand there" ReadsAround (1, 1, 17) ["default_material", "ka 0.5", "end"] ["camera", "ka 0.5", "end"],
    Sample "one slip away" ReadsOn (3, 1, 4) ["camera", "angle 20", "edn"] ["camera", "angle 20", "fin"],
    Sample "an object left open" (KeepsOpen "viewport" 3) (1, 1, 7) ["camera", "angle 20", "viewport", "end"] ["camera", "angle 20", "end", "viewport", "end"],
    Sample "a second camera that says less" (StartsFromEarlier 1) (5, 1, 7) ["camera", "angle 20", "up 0 1 0", "end", "camera", "angle 30", "end"] ["camera", "angle 20", "end", "camera", "angle 30", "up 0 1 0", "end"],
    Sample "a third one, which lacks what the first says" (StartsFromEarlier 4) (8, 1, 9) ["viewport", "height 32", "end", "viewport", "width 30", "height 34", "end", "viewport", "width 30", "end"] ["viewport", "width 30", "end", "viewport", "width 30", "end", "viewport", "height 34", "width 32", "end"],
    Sample "annulus" (LacksWord "anneau") (2, 1, 7) ["primitive", "anneau", "inner_ray 0.2", "end", "end"] ["primitive", "sphere", "end", "end"],
    Sample "seed" (LacksWord "graine") (2, 1, 7) ["raytracer", "graine 7", "end"] ["raytracer", "task 1", "end"],
    Sample "a letter behind" (ReadsNumber "20d" 1e100) (2, 7, 10) ["camera", "angle 20d", "end"] ["camera", "angle 5d", "end"],
    Sample "not a number" (ReadsNumber "NaN" 1e100) (2, 14, 17) ["camera", "position 1 2 NaN", "end"] ["camera", "position 1 2 nan", "end"],
    Sample "infinite" (ReadsNumber "-Infinity" 1e100) (2, 10, 19) ["camera", "position -Infinity 2 3", "end"] ["material", "color -Infinite 2 3", "end"],
    Sample "infinite, where that is out of range" (ReadsNumber "Infinity" 1e100) (2, 21, 29) ["camera", "far_clipping_plane  Infinity", "end"] ["camera", "angle Infinity", "far_clipping_plane -Infinity", "end"],
    Sample "hexadecimal" (ReadsNumber "0X1.8p-1f" 1e100) (2, 10, 19) ["camera", "position 0X1.8p-1f 2 3", "end"] ["camera", "position 0X1.8 2 3", "end", "camera", "position 0x 0 0", "end"],
    Sample "large" (ReadsNumber "1e101" 1e100) (2, 10, 15) ["camera", "position 1e101 2 3", "end"] ["raytracer", "task 3000000000", "end"],
    Sample "a negative channel" AbandonsObject (3, 7, 11) ["material", "name a", "color -0.5 1 1", "end"] ["material", "name a", "color 0.5 1", "end"],
    Sample "a folder in the name" WritesAnywhere (2, 17, 20) ["viewport", "image_file_name a/b", "end"] ["viewport", "image_file_name ab", "end"],
    Sample "zero" AdmitsZeroIndex (2, 3, 6) ["material", "n 0.0", "end"] ["material", "n -1", "n 11", "end"],
    Sample "of a model" AdmitsZeroScale (3, 7, 12) ["model", "file a.obj", "scale 1 1 0", "end"] ["model", "file a.obj", "scale 1 1 1", "end"],
    Sample "of a cap" EndsAtCurvature (2, 1, 14) ["primitive", "spherical_cap", "ray 2", "end", "end"] ["primitive", "sphere", "end", "end"],
    Sample "pixels" LacksLimit (1, 1, 9) ["viewport", "width 20000", "height 20000", "end"] ["viewport", "width 100", "height 100", "end"],
    -- Shapes
    Sample "a torus" (NeverHits "torus") (2, 1, 6) torus ["primitive", "cube", "position 9 9 9", "end", "end"],
    Sample "the outermost of nested shapes" (NeverHits "geometrie") (2, 1, 10) ["primitive", "geometrie", "cone", "end", "end", "end"] ["primitive", "tube", "end", "end"],
    Sample "a plane" (EndsEdgeOn "plan") (2, 1, 5) ["primitive", "plan", "position 5 5 0", "end", "end"] ["primitive", "plane", "position 0 0 1", "end", "end"],
    Sample "a disk, for another camera" (EndsEdgeOn "disk") (6, 1, 5) ["camera", "position 1 1 1", "look_at 9 9 9", "end", "primitive", "disk", "position 5 5 5", "normal 0 3 -3", "end", "end"] ["camera", "position 1 1 1.5", "look_at 9 9 9", "end", "primitive", "disk", "position 5 5 5", "normal 0 3 -3", "end", "end"],
    Sample "a face of a cube" (EndsEdgeOn "cube") (2, 1, 5) ["primitive", "cube", "position 9 -1 9", "size 2", "end", "end"] ["primitive", "cube", "position 9 0 9", "size 2", "end", "end"],
    Sample "a triangle" (EndsEdgeOn "triangle") (2, 1, 9) ["primitive", "triangle", "point 0 0 5", "point 1 0 5", "point 0 0 6", "end", "end"] ["primitive", "triangle", "point 0 1 5", "point 1 1 5", "point 0 1 6", "end", "end"],
    Sample "a sphere" (EndsFarAway "sphere") (2, 1, 7) ["primitive", "sphere", "position 0 0 1001", "end", "end"] ["primitive", "sphere", "position 0 0 999", "end", "end"],
    Sample "a tube" (EndsFarAway "tube") (2, 1, 5) ["primitive", "tube", "ray 0.001", "point 0 0 31", "point 0 0 32", "end", "end"] ["primitive", "tube", "ray 0.001", "point 0 0 29", "point 0 0 30", "end", "end"],
    Sample "of a tube" RefusesNearPoints (2, 1, 5) ["primitive", "tube", "point 0 0 8", "point 0 0 8.0000000001", "end", "end"] ["primitive", "tube", "point 0 0 8", "point 0 0 8.00000001", "end", "end"],
    Sample "a side of 1e-6" RefusesSmallTriangle (2, 1, 9) ["primitive", "triangle", "point 0 0 9", "point 1e-6 0 9", "point 0 1e-6 9", "end", "end"] ["primitive", "triangle", "point 0 0 9", "point 1e-4 0 9", "point 0 1e-4 9", "end", "end"],
    Sample "different normals" LeavesNormals (2, 1, 10) (smooth ["normal 0 0 1", "normal 0 1 1"]) (smooth ["normal 0 0 2", "normal 0 0 1", "normal 0 0 3"]),
    Sample "a sphere" (LeavesTexture "sphere") (2, 15, 16) (textured "sphere") (textured "btriangle"),
    Sample "of several materials of one name the first" (LeavesTexture "cube") (2, 15, 16) (textured "cube" <> ["material", "name a", "end"]) (["material", "name a", "end"] <> textured "cube"),
    -- Pictures
    Sample "a width" HalfAPixelOff (2, 7, 10) ["viewport", "width 301", "height 302", "end"] ["viewport", "width 300", "height 302", "end"],
    -- 20 x 10 pixels, of which 101 are drawn: observed.
    Sample "wider than high" (DrawsPart 101 200) (2, 7, 9) ["viewport", "width 20", "height 10", "end"] ["viewport", "width 300", "height 300", "end"],
    Sample "packets of a hundredth, rounded down" (DrawsPart 202 640) (2, 7, 9) ["viewport", "width 40", "height 16", "end"] ["viewport", "width 10", "height 10", "end"],
    Sample "random" DrawsByChance (2, 18, 24) ["raytracer", "pixel_coordinate random", "end"] ["raytracer", "pixel_coordinate center", "end"],
    Sample "several" (StaysWithThreads 4) (2, 6, 7) ["raytracer", "task 4", "end"] ["raytracer", "task 1", "end"],
    Sample "one, for many rays" (StaysWithThreads 1) (2, 10, 11) ["raytracer", "sampling 4", "end"] ["raytracer", "sampling 1", "end"],
    Sample "voxels" LosesHits (2, 7, 18) ["raytracer", "space multi_voxel", "end"] ["raytracer", "space linear", "end"],
    -- Light and optics
    Sample "phong" (EndsAtPhong "phong_specular") (2, 21, 35) ["raytracer", "reflexion_algorithm phong_specular", "end"] ["raytracer", "reflexion_algorithm blinn_specular", "end"],
    Sample "of a material" EndsAtAlpha (6, 7, 14) (brightest "division_factor") (brightest "clamp_channel"),
    Sample "two for each ray" (LacksRayLimit 65536) (2, 17, 19) (mirrors 17 "kt 0.5") (mirrors 16 "kt 0.5"),
    Sample "one for each ray" (LacksRayLimit 65536) (2, 17, 22) (mirrors 70000 "kt 0") (mirrors 65536 "kt 0"),
    Sample "linear_aperture_light" EndsAtRow (1, 1, 22) ["linear_aperture_light", "end"] ["rectangular_aperture_light", "end"],
    Sample "the square of the distance alone" (EndsAtAttenuation 1e-10) (2, 21, 22) ["point_light", "constant_attenuator 0", "quadratic_attenuator 1", "end"] ["point_light", "constant_attenuator 0.1", "quadratic_attenuator 1", "end"],
    -- Files
    Sample "a texture" ReadsDds (2, 12, 17) ["texture_material", "texture_kd a.DDS", "end"] ["texture_material", "texture_kd a.tga", "end"],
    Sample "a mask" KeepsBlanks (2, 6, 12) ["aperture_mask_light", "mask a.png ", "end"] ["aperture_mask_light", "mask a.png", "end"],
    Sample "elliptical_aperture_light" (WritesAs "rectangular_aperture_light") (1, 1, 26) ["elliptical_aperture_light", "end"] ["ambient_light", "end"],
    Sample "a turned model" LeavesModelInPlace (1, 1, 6) ["model", "file a.obj", "rotation 0 0 45", "end"] ["model", "file a.obj", "rotation 0 0 0", "end"]
  ]
  where
    smooth normals = ["primitive", "btriangle", "point 0 0 9", "point 1 0 9", "point 0 1 9"] <> normals <> ["end", "end"]
    textured shape = ["primitive", "material_name a", shape, "position 9 9 9", "point 0 0 9", "point 1 0 9", "point 0 1 9", "end", "end", "texture_material", "name a", "texture_ka b.png", "end"]
    brightest normalization = ["raytracer", "reflexion_algorithm no_light", "color_normalization " <> normalization, "end", "material", "color 1 1 1 2", "end"]
    mirrors :: Int -> Text -> [Text]
    mirrors level transparency = ["raytracer", "recursive_level " <> Text.pack (show level), "end", "material", "kr 0.5", transparency, "end"]

torus :: [Text]
torus = ["primitive", "torus", "position 0 0 9", "end", "end"]
