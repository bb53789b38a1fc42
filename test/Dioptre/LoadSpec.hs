{-# LANGUAGE OverloadedStrings #-}

-- | Scenes with the files that they need, each in a folder of its own.
module Dioptre.LoadSpec
  ( spec,
  )
where

import Control.Monad (forM_, zipWithM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector.Storable as Storable
import Dioptre.Geometry.Mesh (meshSize)
import Dioptre.Geometry.Shape (Shape (ASphere))
import Dioptre.Geometry.Sphere (sphereRadius)
import Dioptre.Light.Colour (rgb)
import Dioptre.Light.Finish
import Dioptre.Load
import Dioptre.Load.Amount (Amount (..), ModelRead (..))
import Dioptre.Math.Transform (transformTranslation)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..))
import Dioptre.Model.Obj (Counts (..))
import Dioptre.Picture (Picture, picture)
import Dioptre.Picture.Png (encode)
import Dioptre.Render.Texture (Texture (..), Upward (..))
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (sourceName)
import Linear.V3 (V3 (..))
import System.Directory (createDirectoryIfMissing, createFileLink, withCurrentDirectory)
import System.FilePath (takeDirectory)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Test.QuickCheck (arbitrary, forAll, ioProperty, vectorOf, (===))

spec :: Spec
spec = do
  describe "a model" $ do
    it "is read once, in however many spellings and places it is named" $ do
      loaded <-
        loading
          [ ("s.txt", model "ball.msr" ["translation 1 0 0"] <> model "old/BALL.msr" ["translation 2 0 0"] <> model "same.msr" [] <> model "ball.msr " []),
            ("ball.msr", ball "1")
          ]
          (createFileLink "ball.msr" "same.msr")
      outlineOf loaded `shouldBe` ([["ball 1.0"]], [0, 0, 0, 0])
      map (transformTranslation . instanceTransform) (libraryInstances (loadedLibrary loaded)) `shouldBe` [V3 1 0 0, V3 2 0 0, 0, 0]
      loadedModels loaded `shouldBe` [ModelRead "ball.msr" (Primitives 1)]
      saidIn loaded `shouldBe` []
    it "stands behind those that it holds, which are looked for beside it" $ do
      loaded <-
        loadingFiles
          [ ("s.txt", model "tower.msr" [] <> model "ball.msr" []),
            ("a/tower.msr", model "ball.msr" ["translation 0 0 1"] <> ball "3" <> model "ball.msr" ["translation 0 0 2"]),
            ("a/ball.msr", ball "1"),
            ("ball.msr", ball "2")
          ]
      outlineOf loaded `shouldBe` ([["ball 1.0"], ["model 0", "ball 3.0", "model 0"], ["ball 2.0"]], [1, 2])
      map modelReadPath (loadedModels loaded) `shouldBe` ["a/ball.msr", "a/tower.msr", "ball.msr"]
    it "of each format is read" $ do
      loaded <-
        loadingFiles
          [ ("s.txt", model "b.OBJ" [] <> model "c.agp" [] <> model "d.msr" []),
            ("b.obj", ["v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0", "v 2 2 2", "f 1 2 3", "f 1 2 3 4", "f 1 2 3 5 4"]),
            ("c.agp", ["0 1 1", "0 0 1", "0 0 0"]),
            ("d.msr", ball "1")
          ]
      outlineOf loaded `shouldBe` ([["6 triangles"], ["something else", "something else"], ["ball 1.0"]], [0, 1, 2])
      loadedModels loaded `shouldBe` [ModelRead "b.obj" (Polygons (Counts 1 1 1 0 0)), ModelRead "c.agp" (Tubes 2), ModelRead "d.msr" (Primitives 1)]
      saidIn loaded `shouldBe` []
    it "is found by a name in Latin-1, and in UTF-8" $ do
      loaded <- inFolder $ do
        Bytes.writeFile "s.txt" "model\nfile th\xE9i\xE8re.msr\nend\n"
        write ("th\233i\232re.msr", ["model", "fichier \201toile.msr", "fin"])
        write ("\233toile.msr", ball "1")
        loaded' "s.txt"
      outlineOf loaded `shouldBe` ([["ball 1.0"], ["model 0"]], [1])
    it "of no known format, or of no name, is told" $ do
      loaded <- loadingFiles [("s.txt", model "a.stl" [] <> model "ball" [] <> model "none" [] <> ["model", "end"]), ("a.stl", []), ("ball", [])]
      outlineOf loaded `shouldBe` ([], [])
      saidIn loaded
        `shouldBe` [ ("s.txt", Span 2 6 11, UnknownModelFormat "a.stl"),
                     ("s.txt", Span 5 6 10, UnknownModelFormat "ball"),
                     ("s.txt", Span 8 6 10, NoModelFile),
                     ("s.txt", Span 10 1 6, NoModelFile)
                   ]
    it "that is not there, or there twice, is told wherever it is named" $ do
      loaded <- loadingFiles [("s.txt", model "no.obj" [] <> model "NO.obj" [] <> model "b.msr" []), ("x/b.msr", ball "1"), ("y/b.msr", ball "1")]
      outlineOf loaded `shouldBe` ([], [])
      saidIn loaded
        `shouldBe` [ ("s.txt", Span 2 6 12, UnusableFile "no.obj" ForModel (NoSuchFile [".", "scenes", "models", "./..."] Nothing)),
                     ("s.txt", Span 5 6 12, UnusableFile "NO.obj" ForModel (NoSuchFile [".", "scenes", "models", "./..."] Nothing)),
                     ("s.txt", Span 8 6 11, UnusableFile "b.msr" ForModel (SeveralFiles ["x/b.msr", "y/b.msr"]))
                   ]
    it "with nothing to draw in it is warned of wherever it is named, and one that names models is not" $ do
      let files = ["a.obj", "b.obj", "c.obj", "d.agp", "e.agp", "f.msr", "f.msr"]
      loaded <-
        loading
          [ ("s.txt", foldMap (`model` []) files <> model "g.msr" []),
            ("a.obj", []),
            ("b.obj", ["v 0 0 0"]),
            ("d.agp", []),
            ("e.agp", ["curve", "once upon a time"]),
            ("f.msr", ["material", "name a", "end"]),
            ("g.msr", model "a.obj" [])
          ]
          (Bytes.writeFile "c.obj" (Bytes.pack [0 .. 255]))
      saidIn loaded
        `shouldBe` [("s.txt", Span line 6 11, EmptyModel file) | (line, file) <- zip [2, 5 ..] files] <> [("g.msr", Span 2 6 11, EmptyModel "a.obj")]
      length (libraryInstances (loadedLibrary loaded)) `shouldBe` 8
    it "has its faults told under its own name, once" $ do
      loaded <- loadingFiles [("s.txt", model "a.msr" [] <> model "b.msr" [] <> ["oops 1"]), ("a.msr", model "b.msr" [] <> ["camera", "end"]), ("b.msr", ["sphere", "ray 1", "end"] <> ball "1")]
      [(file, line) | (file, Span line _ _, MisplacedWord {}) <- saidIn loaded] `shouldBe` [("b.msr", 1), ("a.msr", 4)]
      take 1 (saidIn loaded) `shouldSatisfy` all (\(file, place, _) -> (file, place) == ("s.txt", Span 7 1 5))
      length (saidIn loaded) `shouldBe` 3
    it "may hold any bytes, and so may its materials and pictures" . forAll (vectorOf 4 (map fromInteger <$> arbitrary)) $ \bytes -> ioProperty $ do
      loaded <-
        loading
          [("s.txt", foldMap (`model` []) ["a.obj", "b.obj", "c.agp", "d.msr", "e.msr"]), ("b.obj", ["mtllib b.mtl"]), ("e.msr", ["texture_material", "texture_kd e.png", "end"])]
          (zipWithM_ Bytes.writeFile ["a.obj", "c.agp", "d.msr", "e.png"] (map Bytes.pack bytes) >> Bytes.writeFile "b.mtl" (Bytes.pack (concat bytes)))
      pure (length (libraryInstances (loadedLibrary loaded)) === 5)
  describe "a model in itself" $ do
    it "is left out, and told where it is named" $ do
      loaded <- loadingFiles [("s.txt", model "a.msr" []), ("a.msr", ball "1" <> model "A.msr" [])]
      outlineOf loaded `shouldBe` ([["ball 1.0"]], [0])
      saidIn loaded `shouldBe` [("a.msr", Span 10 6 11, ModelCycle ["a.msr", "a.msr"])]
    it "by way of another one, too" $ do
      loaded <- loadingFiles [("s.txt", model "a.msr" [] <> model "b.msr" []), ("a.msr", model "b.msr" []), ("b.msr", ball "1" <> model "c.msr" []), ("c.msr", model "b.msr" [])]
      outlineOf loaded `shouldBe` ([[], ["ball 1.0", "model 0"], ["model 1"]], [2, 1])
      saidIn loaded `shouldBe` [("c.msr", Span 2 6 11, ModelCycle ["b.msr", "c.msr", "b.msr"])]
    it "is no model that is named in two ways" $ do
      loaded <- loadingFiles [("s.txt", model "a.msr" []), ("a.msr", model "b.msr" [] <> model "c.msr" []), ("b.msr", model "d.msr" []), ("c.msr", model "d.msr" []), ("d.msr", ball "1")]
      (outlineOf loaded, saidIn loaded) `shouldBe` (([["ball 1.0"], ["model 0"], ["model 0"], ["model 1", "model 2"]], [3]), [])
  describe "models in models" $ do
    it "are 64 deep at most" $ do
      let chain n = ("s.txt", model "m1.msr" []) : [(file i, if i == n then ball "1" else model (Text.pack (file (i + 1))) []) | i <- [1 .. n]]
          file i = "m" <> show (i :: Int) <> ".msr"
      just <- loadingFiles (chain 64)
      (length (libraryModels (loadedLibrary just)), saidIn just) `shouldBe` (64, [])
      over <- loadingFiles (chain 65)
      saidIn over `shouldBe` [("m1.msr", Span 2 6 12, ModelTooDeep "m2.msr" 64)]
      map outline (concatMap contentParts (take 1 (reverse (toList (libraryModels (loadedLibrary over)))))) `shouldBe` []
    it "come to 2^48 shapes at most" $ do
      -- m0 is two balls, each other one twice the one before it: 2^48 in m47.
      let file i = "m" <> show (i :: Int) <> ".msr"
          twice i = model (Text.pack (file i)) [] <> model (Text.pack (file i)) []
          files = (file 0, take 6 (ball "1") <> ball "1") : [(file i, twice (i - 1)) | i <- [1 .. 48]]
      most <- loadingFiles (("s.txt", model "m47.msr" []) : files)
      (length (libraryInstances (loadedLibrary most)), saidIn most) `shouldBe` (1, [])
      inModel <- loadingFiles (("s.txt", model "m48.msr" []) : files)
      saidIn inModel `shouldBe` [("m48.msr", Span 5 6 13, TooManyParts "m47.msr" (2 ^ (48 :: Int)))]
      inScene <- loadingFiles (("s.txt", model "m47.msr" [] <> model "m0.msr" []) : files)
      length (libraryInstances (loadedLibrary inScene)) `shouldBe` 1
      saidIn inScene `shouldBe` [("s.txt", Span 5 6 12, TooManyParts "m0.msr" (2 ^ (48 :: Int)))]
  describe "a model's picture" $ do
    it "is looked for beside the model, and told there where it is missing" $ do
      loaded <-
        loading
          [("s.txt", model "a.msr" []), ("m/a.msr", ["texture_material", "name a", "texture_ka no.png", "texture_kd bark.png", "end", "primitive", "material_name a", "sphere", "end", "end"])]
          (savePicture "m/bark.png" green >> savePicture "bark.png" red)
      map layersOf (finishesOf loaded) `shouldBe` [[Nothing, Just (Texture FromFirstRow green), Nothing]]
      saidIn loaded `shouldBe` [("m/a.msr", Span 3 12 18, UnusableFile "no.png" ForTexture (NoSuchFile ["m", "scenes", "models", "./..."] Nothing))]
    it "has its first row where the first model that names the file says" $
      forM_ [([], FromFirstRow), (["uv_format 1"], FromFirstRow), (["uv_format origin_uv_bottom_left"], FromLastRow)] $ \(format, upward) -> do
        loaded <-
          loading
            [("s.txt", model "a.msr" format <> model "a.msr" ["uv_format 2"] <> model "a.msr" [] <> model "a.msr" ["uv_format 1"]), ("a.msr", ["texture_material", "name a", "texture_kd bark.png", "end", "primitive", "material_name a", "sphere", "end", "end"])]
            (savePicture "bark.png" green)
        map layersOf (finishesOf loaded) `shouldBe` [[Nothing, Just (Texture upward green), Nothing]]
        map (\(file, Span line _ _, problem) -> (file, line, code problem)) (saidIn loaded)
          `shouldBe` [("s.txt", (if upward == FromFirstRow then 6 else 13) + length format, "differing-uv-format")]
    it "does not matter where there is none" $ do
      loaded <- loadingFiles [("s.txt", model "a.msr" [] <> model "a.msr" ["uv_format 2"]), ("a.msr", ball "1")]
      saidIn loaded `shouldBe` []
  describe "an OBJ file's material" $ do
    it "comes from the libraries that the file names, beside it" $ do
      loaded <-
        loading
          [ ("s.txt", model "a.obj" []),
            ("m/a.obj", ["mtllib one.mtl", "mtllib two.mtl"] <> corners <> ["usemtl red", "f 1 2 3", "usemtl bark of oak", "f 1 2 3"]),
            ("m/one.mtl", ["newmtl red", "Kd 1 0 0", "Ns 9"]),
            ("m/two.mtl", ["newmtl red", "Kd 0 1 0", "newmtl bark of oak", "Kd 0 0 1", "map_Kd C:\\pictures\\bark.png"]),
            ("one.mtl", ["newmtl red", "Kd 0 0 0"])
          ]
          (savePicture "m/bark.png" green)
      saidIn loaded `shouldBe` []
      [(finishDiffuse f, shininessOf (finishColours f)) | f <- finishesOf loaded]
        `shouldBe` [(Layer (rgb 1 0 0) Nothing, 9), (Layer (rgb 0 0 1) (Just (Texture FromFirstRow green)), 5)]
    it "is told where it is missing, and so are its library and its picture" $ do
      loaded <-
        loadingFiles
          [ ("s.txt", model "a.obj" [] <> model "b.obj" []),
            ("a.obj", ["mtllib no.mtl", "mtllib yes.mtl"] <> corners <> ["usemtl blue", "f 1 2 3"]),
            ("b.obj", ["mtllib yes.mtl"] <> corners <> ["usemtl red", "f 1 2 3"]),
            ("yes.mtl", ["newmtl red", "map_Kd no.png"])
          ]
      saidIn loaded
        `shouldBe` [ ("yes.mtl", Span 2 8 14, UnusableFile "no.png" ForTexture (NoSuchFile [".", "scenes", "models", "./..."] Nothing)),
                     ("a.obj", Span 1 8 14, UnusableFile "no.mtl" ForMaterialLibrary (NoSuchFile [".", "scenes", "models", "./..."] Nothing)),
                     ("a.obj", Span 6 8 12, UnknownMaterialOfModel "blue")
                   ]
      map outline (concatMap contentParts (toList (libraryModels (loadedLibrary loaded)))) `shouldBe` ["1 triangles", "1 triangles"]
    it "has a fault in its library told there" $ do
      loaded <- loadingFiles [("s.txt", model "a.obj" []), ("a.obj", ["mtllib a.mtl"] <> corners <> ["usemtl red", "f 1 2 3"]), ("a.mtl", ["newmtl red", "Kd 1 O 0"])]
      map (\(file, Span line _ _, problem) -> (file, line, code problem)) (saidIn loaded) `shouldBe` [("a.mtl", 2, "not-a-number")]
  it "a scene says nothing of models that it does not have" $ do
    loaded <- loadingFiles [("s.txt", ball "1")]
    (outlineOf loaded, loadedModels loaded, map (sourceName . fst) (loadedDiagnostics loaded)) `shouldBe` (([], []), [], ["s.txt"])
  where
    corners = ["v 0 0 0", "v 1 0 0", "v 0 1 0"]
    red = picture 1 (Storable.fromList [255, 0, 0, 255])
    green = picture 1 (Storable.fromList [0, 255, 0, 255, 0, 0, 0, 255])
    layersOf f = [p | Layer _ p <- [finishAmbient f, finishDiffuse f, finishSpecular f]]
    finishesOf = concatMap (toList . contentFinishes) . toList . libraryModels . loadedLibrary

-- | A model in a scene, or in another model.
model :: Text -> [Text] -> [Text]
model file properties = ["model", "file " <> file] <> properties <> ["end"]

-- | A ball of grey, in eight lines.
ball :: Text -> [Text]
ball radius = ["primitive", "material_name none", "sphere", "ray " <> radius, "end", "end", "material", "end"]

-- | Each model's parts in few words, and the numbers of those that the scene has.
outlineOf :: Loaded -> ([[Text]], [Int])
outlineOf loaded = (map (map outline . contentParts) (toList (libraryModels library)), map instanceModel (libraryInstances library))
  where
    library = loadedLibrary loaded

outline :: Part Instance -> Text
outline part = case part of
  Solid (ASphere s) _ -> "ball " <> Text.pack (show (sphereRadius s))
  Solid _ _ -> "something else"
  Faces mesh -> Text.pack (show (meshSize mesh)) <> " triangles"
  Nested i -> "model " <> Text.pack (show (instanceModel i))

-- | What is said that is no note: in which file, where, and what.
saidIn :: Loaded -> [(FilePath, Span, Problem)]
saidIn loaded = [(sourceName source, place, problem) | (source, ds) <- loadedDiagnostics loaded, Diagnostic place problem <- ds, severity problem > Note]

-- | The scene in s.txt, in a folder with these files.
loadingFiles :: [(FilePath, [Text])] -> IO Loaded
loadingFiles files = loading files (pure ())

-- | The same, when some work was done there.
loading :: [(FilePath, [Text])] -> IO () -> IO Loaded
loading files work = inFolder (mapM_ write files >> work >> loaded' "s.txt")

loaded' :: FilePath -> IO Loaded
loaded' path = loadScene English path >>= either (fail . Text.unpack) pure

write :: (FilePath, [Text]) -> IO ()
write (path, lines') = do
  createDirectoryIfMissing True (takeDirectory path)
  Bytes.writeFile path (Text.encodeUtf8 (Text.unlines lines'))

savePicture :: FilePath -> Picture -> IO ()
savePicture path = Lazy.writeFile path . encode

-- | Works in an empty folder of its own.
inFolder :: IO a -> IO a
inFolder work = withSystemTempDirectory "dioptre" (`withCurrentDirectory` work)
