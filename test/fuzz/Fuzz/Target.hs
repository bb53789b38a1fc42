{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Fuzz.Target
-- Description : What must hold of every input
--
-- Each kind of input goes the way that it goes in the program, up to a few pixels. On this way:
--
-- * nothing is thrown, and time and memory are bounded by the size of the input;
-- * every diagnostic has a place in the text, in the order of the text, and can be told in both languages;
-- * what is written from what was read is read as the same;
-- * no number is NaN (a value that holds one does not equal itself), and colours are finite.
module Fuzz.Target
  ( Failure (..),
    failureName,
    trial,
  )
where

import Control.Exception (Exception, evaluate, fromException, throwIO, try)
import Control.Monad (unless, when)
import Control.Monad.ST (runST)
import Data.Aeson (Value (..))
import qualified Data.Aeson as Aeson
import qualified Data.Aeson.KeyMap as Keys
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isRight)
import Data.Foldable (for_, toList, traverse_)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector as Vector
import qualified Data.Vector.Storable as Storable
import Dioptre.Conformance.Oracle (answer)
import Dioptre.Conformance.Protocol (Request (..), readAnswer, readRequest, writeAnswer)
import qualified Dioptre.Conformance.Protocol as Protocol
import Dioptre.Files.Counter (replaceCounter)
import Dioptre.Files.Number (pictureNumber)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Light.Finish (Finish)
import Dioptre.Light.Light (Light (..), Wave (..))
import Dioptre.Load.Decoding (attempted)
import Dioptre.Math.Transform (identity)
import Dioptre.Model.Agp (readAgp)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..), noModels)
import Dioptre.Model.Msr (Msr (..), readMsr)
import Dioptre.Model.Mtl (Mtl (..), finishesOf, readMtl)
import Dioptre.Model.Obj (Named (..), Obj (..), feed, finish, newReader, readObj)
import Dioptre.Picture (Picture, picture, pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Picture.Png (decode, decodeTexture)
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row (colourAt, plan, planExtent)
import Dioptre.Render.Texture (Texture (..), Upward (..))
import Dioptre.Scene (writeScene)
import Dioptre.Scene.Camera (viewportHeight, viewportWidth)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Scene.Comparisons (checkComparisons, writeComparisons)
import Dioptre.Scene.Configuration
import Dioptre.Scene.Raytracer (Raytracer (..))
import Dioptre.Scene.Unchecked (Scene (..))
import Dioptre.Source.Diagnostic (Diagnostic (..), PictureFault, code)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Message (pictureFault)
import Dioptre.Source.Report (pretty, summary, toJson)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, excerpts, fromText, lineAt, sourceText)
import qualified Dioptre.Source.Text as Source
import Dioptre.Syntax.Grammar (parse)
import Fuzz.Kind (Kind (..))
import Fuzz.Limits (Budget (..), Outcome (..), limited)

-- | What is wrong with what becomes of an input: a name of a few words for the kind of failure, and more about this
-- one.
data Failure = Failure Text String
  deriving stock (Eq, Show)

instance Exception Failure

-- | The words for the kind of failure. Two inputs that fail alike have the same.
failureName :: Failure -> Text
failureName (Failure name _) = name

-- | Tries an input; 'Nothing' if all is well.
trial :: Kind -> ByteString -> IO (Maybe Failure)
trial kind bytes = either Just (const Nothing) <$> try (tried kind bytes)

failing :: Text -> String -> IO a
failing name = throwIO . Failure name

-- | Work that takes at most some seconds and megabytes for each megabyte of the input, and 10 seconds and 200 megabytes
-- more. Its name is what fails.
bounded :: Text -> Double -> Double -> ByteString -> IO a -> IO a
bounded = boundedFrom 200

-- | The same with so many megabytes more.
boundedFrom :: Double -> Text -> Double -> Double -> ByteString -> IO a -> IO a
boundedFrom most name secondsPerMegabyte megabytesPerMegabyte bytes work =
  limited budget work >>= \case
    Done result _ -> pure result
    Threw e -> maybe (failing (name <> "-throws") (show e)) throwIO (fromException e :: Maybe Failure)
    OutOfTime -> failing (name <> "-takes-too-long") (show (budgetSeconds budget) <> " s")
    OutOfMemory -> failing (name <> "-takes-too-much") (show (budgetBytes budget) <> " bytes allocated")
  where
    size = fromIntegral (Bytes.length bytes) / 1e6
    budget = Budget (10 + secondsPerMegabyte * size) (ceiling (1e6 * (most + megabytesPerMegabyte * size)))

-- | Tries an input of a kind.
tried :: Kind -> ByteString -> IO ()
tried kind bytes = case kind of
  SceneFile -> sceneHolds bytes
  ConfigurationFile -> configurationHolds bytes
  ComparisonList -> comparisonsHold bytes
  MsrFile -> msrHolds bytes
  AgpFile -> agpHolds bytes
  ObjFile -> objHolds bytes
  MtlFile -> mtlHolds bytes
  PictureFile -> pictureHolds decode bytes
  TargaFile -> pictureHolds (decodeTexture "a.tga") bytes
  ProtocolLine -> answerHolds bytes

-------------------------------------------------------------------------------
-- Texts

source :: FilePath -> ByteString -> IO Source
source name bytes = evaluate (Source.decode name bytes)

-- | Every diagnostic has a place in the text, in order, and can be told.
told :: Source -> [Diagnostic] -> IO ()
told text = toldOf text (lineCount text) (Text.length . lineAt text)

-- | The same for a text of so many lines with these lengths, of which the source has only some.
toldOf :: Source -> Int -> (Int -> Int) -> [Diagnostic] -> IO ()
toldOf text lines' lengthOf diagnostics = do
  for_ diagnostics $ \d@(Diagnostic (Span line start end) _) -> do
    unless (line >= 1 && line <= lines' && start >= 1 && start <= end && end <= lengthOf line + 1) $
      failing "diagnostic-outside-the-text" (show d)
    when (any Text.null [code (diagnosticProblem d)]) $ failing "diagnostic-without-code" (show d)
  unless (map diagnosticSpan diagnostics == map diagnosticSpan (sortOn diagnosticSpan diagnostics)) $ failing "diagnostics-out-of-order" (show (map diagnosticSpan diagnostics))
  for_ [English, French] $ \l -> do
    total (sum [length (show (pretty l text d)) | d <- take 300 diagnostics])
    total (sum [Lazy.length (Aeson.encode (toJson l "x" d)) | d <- diagnostics])
    total (maybe 0 Text.length (summary l diagnostics))

-- | A number that is computed to its end.
total :: Integral a => a -> IO ()
total n = when (n < 0) $ failing "negative-length" ""

lineCount :: Source -> Int
lineCount text = Text.count "\n" (sourceText text) + 1

-- | A value that equals itself is there to its end, without NaN.
sound :: Eq a => Text -> a -> IO ()
sound name a = unless (a == a) $ failing (name <> "-holds-nan") ""

sceneHolds :: ByteString -> IO ()
sceneHolds bytes = do
  scene <- bounded "scene" 30 100000 bytes $ do
    text <- source "s.txt" bytes
    let (scene, diagnostics) = checkScene (parse text)
    told text diagnostics
    sound "scene" scene
    let written = writeScene scene
        (again, complaints) = checkScene (parse (fromText "out.txt" written))
    unless (again == scene) $ failing "scene-reads-back-differently" (Text.unpack (Text.take 2000 written))
    for_ complaints $ \d ->
      unless (code (diagnosticProblem d) `Set.member` ofScenes) $ failing "scene-reads-back-with-faults" (show d)
    pure scene
  colouredWell bytes noModels scene
  where
    -- What can be wrong with a scene whose every value is right.
    ofScenes = Set.fromList ["repeated-material", "sampling-without-random", "no-model-file"]

-- | A few pixels of a scene: its corners and its middle.
colouredWell :: ByteString -> Library Texture -> Scene -> IO ()
colouredWell bytes library scene = do
  p <- bounded "plan" 60 100000 bytes $ do
    let p = plan Map.empty library modest
    sound "extent" (planExtent p)
    pure p
  -- For each sample there may be 65536 rays, whatever the size of the input.
  boundedFrom 20000 "pixel" 120 200000 bytes . for_ places $ \(x, y) -> do
    let Seen (Colour r g b a) _ = colourAt p x y
    for_ [r, g, b, a] $ \c -> do
      when (isNaN c) $ failing "colour-is-nan" (show ((x, y), [r, g, b, a]))
      when (isInfinite c) $ failing "colour-is-infinite" (show ((x, y), [r, g, b, a]))
  where
    places = Set.fromList [(0, 0), (w - 1, 0), (w `div` 2, h `div` 2), (w - 1, h - 1)]
    w = viewportWidth (sceneViewport modest)
    h = viewportHeight (sceneViewport modest)
    -- The time that a pixel may take by right is the product of samples, rays, lights and their sources: less of each
    -- is asked for.
    modest = scene {sceneRaytracer = tracer {raytracerSampling = min 2 (raytracerSampling tracer), raytracerRecursiveLevel = level}, sceneLights = map fewer (sceneLights scene)}
    tracer = sceneRaytracer scene
    level = (if length (sceneLights scene) + length (scenePrimitives scene) > 60 then min 3 else id) (raytracerRecursiveLevel tracer)
    fewer = \case
      LinearAperture lamp wave ends -> LinearAperture lamp wave {waveOscillators = min 3 (waveOscillators wave)} ends
      PlanarAperture opening lamp wave aperture -> PlanarAperture opening lamp wave {waveOscillators = min 1 (waveOscillators wave)} aperture
      l -> l

configurationHolds :: ByteString -> IO ()
configurationHolds bytes = bounded "configuration" 30 100000 bytes $ do
  text <- source "configuration.cfg" bytes
  let (configuration, diagnostics) = checkConfiguration (parse text)
      written = [configurationWrite configuration, configurationLogName configuration]
  told text diagnostics
  sound "configuration" configuration
  when (any (Text.any (`elem` ("/\\\n\0" :: String))) written) $ failing "output-leaves-the-folder" (show written)
  when (Set.size (Set.fromList (map bare (configurationRead configuration : "configuration.cfg" : written))) < 4 && bare (configurationRead configuration) /= "configuration.cfg") $
    failing "output-replaces-an-input" (show configuration)
  for_ (pictureNumber (123 :: Int)) $ \n -> do
    let counted = replaceCounter n bytes
        after = fst (checkConfiguration (parse (Source.decode "configuration.cfg" counted)))
    unless (configurationImageCount after == 123) $ failing "counter-is-not-read-back" (show counted)
    -- A value that is not UTF-8 makes the whole file Latin-1, until it is replaced.
    unless (isUtf8 bytes /= isUtf8 counted || after == configuration {configurationImageCount = 123}) $ failing "counter-changes-more" (show counted)
    unless (replaceCounter n counted == counted) $ failing "counter-does-not-settle" (show counted)
  where
    bare = Text.toCaseFold . Text.strip
    isUtf8 = isRight . Text.decodeUtf8'

comparisonsHold :: ByteString -> IO ()
comparisonsHold bytes = bounded "comparisons" 30 100000 bytes $ do
  text <- source "list.txt" bytes
  let (pairs, diagnostics) = checkComparisons (parse text)
  told text diagnostics
  unless (checkComparisons (parse (fromText "" (writeComparisons pairs))) == (pairs, [])) $ failing "comparisons-read-back-differently" (show pairs)

-------------------------------------------------------------------------------
-- Models

msrHolds :: ByteString -> IO ()
msrHolds bytes = do
  content <- bounded "msr" 30 100000 bytes $ do
    text <- source "a.msr" bytes
    let msr = readMsr (parse text)
    told text (msrDiagnostics msr)
    sound "msr" msr
    pure (msrContent msr)
  -- Other models are not there.
  colouredWell bytes (libraryOf content {contentParts = [part | part <- contentParts content, not (isNested part)]}) showroom
  where
    isNested = \case
      Nested _ -> True
      _ -> False

agpHolds :: ByteString -> IO ()
agpHolds bytes = do
  content <- bounded "agp" 30 100000 bytes $ do
    text <- source "a.agp" bytes
    let (content, diagnostics) = readAgp text :: (Content () Text, [Diagnostic])
    told text diagnostics
    sound "agp" content
    pure content
  colouredWell bytes (libraryOf content) showroom

objHolds :: ByteString -> IO ()
objHolds bytes = do
  obj <- bounded "obj" 30 100000 bytes $ do
    let obj = readObj (Lazy.fromStrict bytes)
        text = excerpts "a.obj" (objLines obj)
        -- A byte-order mark is not a part of the first line.
        lengths = Vector.fromList (map (Text.length . Source.characters) (linesOf (fromMaybe bytes (Bytes.stripPrefix "\xEF\xBB\xBF" bytes))))
    toldOf text (Vector.length lengths) (\n -> lengths Vector.! (n - 1)) (objDiagnostics obj)
    sound "obj" obj
    for_ [1, 7, 1000] $ \size -> unless (inPieces size == obj) $ failing "obj-depends-on-pieces" (show size)
    pure obj
  let (finishes, _) = finishesOf [] (map namedText (objMaterials obj)) :: ([Finish Text], [Text])
  colouredWell bytes (libraryOf (Content [Faces (objMesh obj) :: Part ()] (Vector.fromList finishes))) showroom
  where
    inPieces size
      | Bytes.length bytes > 3000 * size = readObj (Lazy.fromStrict bytes)
      | otherwise = runST $ do
        reader <- newReader
        traverse_ (feed reader) (pieces size bytes)
        finish reader
    linesOf b = case Bytes.break (`elem` [10, 13]) b of
      (l, rest)
        | Bytes.null rest -> [l]
        | otherwise -> l : linesOf (Bytes.drop (if "\r\n" `Bytes.isPrefixOf` rest then 2 else 1) rest)
    pieces size b = if Bytes.null b then [] else let (piece, rest) = Bytes.splitAt size b in piece : pieces size rest

mtlHolds :: ByteString -> IO ()
mtlHolds bytes = bounded "mtl" 30 100000 bytes $ do
  text <- source "a.mtl" bytes
  let (mtl, diagnostics) = readMtl text
  told text diagnostics
  sound "mtl" mtl
  for_ (concatMap toList (toList (mtlMaterials mtl))) $ \(Named (Span line start end) _) ->
    unless (line >= 1 && line <= lineCount text && start <= end && end <= Text.length (lineAt text line) + 1) $ failing "name-outside-the-text" (show (line, start, end))

-- | A library of one model, without pictures.
libraryOf :: Content nested Text -> Library Texture
libraryOf (Content parts finishes) = Library (Vector.singleton (Content (concatMap plain parts) (Vector.map plainly finishes))) [Instance 0 identity]
  where
    plain = \case
      Solid s n -> [Solid s n]
      Faces m -> [Faces m]
      Nested _ -> []
    plainly = fmap (const (Texture FromFirstRow (picture 1 (Storable.replicate 4 255))))

-- | A scene around a model: a camera before it, and two lights.
showroom :: Scene
showroom =
  fst . checkScene . parse . fromText "" . Text.unlines $
    ["camera", "position 0 0 -8", "look_at 0 0 0", "up 0 1 0", "far_clipping_plane 1e100", "end"]
      <> ["viewport", "width 5", "height 3", "end", "raytracer", "recursive_level 4", "end"]
      <> ["ambient_light", "end", "point_light", "position 1 2 -9", "end"]

-------------------------------------------------------------------------------
-- Pictures

pictureHolds :: (ByteString -> Either PictureFault Picture) -> ByteString -> IO ()
pictureHolds decoder bytes =
  bounded "picture" 60 400000 bytes $
    attempted decoder bytes >>= \case
      Left fault -> total (Text.length (pictureFault English fault))
      Right p -> unless (pictureWidth p > 0 && pictureHeight p > 0 && Storable.length (pictureBytes p) == 4 * pictureWidth p * pictureHeight p) $ failing "picture-lacks-bytes" (show (pictureWidth p, pictureHeight p))

-------------------------------------------------------------------------------
-- The protocol

answerHolds :: ByteString -> IO ()
answerHolds bytes = bounded "answer" 60 100000 asked $ do
  let given = answer "0" asked
      written = Lazy.toStrict (writeAnswer given)
  when (Bytes.elem 10 written) $ failing "answer-of-several-lines" (show written)
  case readAnswer written of
    Right _ -> pure ()
    Left complaint -> failing "answer-cannot-be-read" (show (complaint, written))
  case Protocol.answerOutcome given of
    Protocol.Ok value -> when (holdsNull value) $ failing "answer-holds-null" (show written)
    _ -> pure ()
  where
    -- Pictures as large as they like are drawn by right.
    asked = case readRequest bytes of
      Right r@(Request _ operation (Object o))
        | operation `elem` ["scene.picture", "scene.pixel"], Just (String text) <- Keys.lookup "text" o, tooMuch (fst (checkScene (parse (fromText "" text)))) -> Lazy.toStrict (Protocol.writeRequest r {requestOperation = "scene.check"})
      _ -> bytes
    tooMuch scene =
      viewportWidth (sceneViewport scene) * viewportHeight (sceneViewport scene) > 400
        || raytracerSampling (sceneRaytracer scene) > 4
        || raytracerRecursiveLevel (sceneRaytracer scene) > 8
        || length (scenePrimitives scene) + length (sceneLights scene) > 30
        || any isWave (sceneLights scene)
    isWave = \case
      LinearAperture {} -> True
      PlanarAperture {} -> True
      _ -> False
    -- As a number in a list, or as the value of a member but "uv".
    holdsNull = \case
      Array items -> any (\v -> v == Null || holdsNull v) items
      Object o -> or [v == Null && name /= "uv" || holdsNull v | (name, v) <- Keys.toList o]
      _ -> False
