{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Fuzz.Generate
-- Description : Inputs from the grammars
--
-- Inputs that are nearly right by themselves. Scenes come from the program's own tables: each object with the words
-- that its description knows, each word with a value that its description asks for, or with one at the edge of that. So
-- a new word, shape or light is tried without a change here.
module Fuzz.Generate
  ( generate,
    dictionary,
  )
where

import Data.Aeson (Value (..), decodeStrict, encode)
import qualified Data.Aeson.KeyMap as Keys
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.List.NonEmpty as NonEmpty
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector as Vector
import Dioptre.Scene.Camera (cameraSchema, viewportSchema)
import Dioptre.Scene.Configuration (describeConfiguration)
import Dioptre.Scene.Lights (describeLights)
import Dioptre.Scene.Materials (materialSchema, textureMaterialSchema)
import Dioptre.Scene.Model (modelSchema)
import Dioptre.Scene.Raytracer (raytracerSchema)
import Dioptre.Scene.Schema (Schema (..), describe)
import Dioptre.Scene.Shapes (describeShapes)
import Dioptre.Source.Diagnostic (Expectation (..), Range (..))
import Dioptre.Syntax.Keyword (Keyword, allSpellings, spelling, spellings)
import qualified Dioptre.Syntax.Keyword as Keyword
import Fuzz.Corpus (Corpus)
import Fuzz.Kind (Kind (..))
import Fuzz.Mutate
import Test.QuickCheck hiding (generate)

-- | An input of a kind: from its grammar, or from the files that there are of it, whole and spoilt.
generate :: Corpus -> Kind -> Gen ByteString
generate corpus kind = do
  made <-
    frequency
      [ (6, fresh),
        (2, fresh >>= exaggerated),
        (1, known >>= exaggerated),
        (5, known >>= \a -> known >>= \b -> spoiltLines word b a),
        (2, fresh >>= \a -> known >>= \b -> spoiltLines word b a),
        (2, fresh >>= \a -> fresh >>= \b -> spoiltBytes b a),
        (3, known >>= \a -> known >>= \b -> spoiltBytes b a),
        (1, anyBytes)
      ]
  -- Large ones are rare, as they take as long as a thousand others.
  frequency [(600, pure made), (1, large made)]
  where
    known = maybe fresh elements (NonEmpty.toList <$> Map.lookup kind corpus)
    word = dictionary kind
    fresh = case kind of
      SceneFile -> sceneText
      ConfigurationFile -> configurationText
      ComparisonList -> comparisonText
      MsrFile -> modelText
      AgpFile -> strokes
      ObjFile -> polygons
      MtlFile -> library
      PictureFile -> knownPicture
      TargaFile -> knownPicture
      ProtocolLine -> request (maybe [] NonEmpty.toList (Map.lookup kind corpus))
    knownPicture = maybe anyBytes (elements . NonEmpty.toList) (Map.lookup kind corpus) >>= spoiltBytes ""
    large made = oneof [manyTimes (Bytes.take 3000 made), manyTimes . Bytes.take 200 =<< word, nested, logarithmic 1000000 >>= \n -> Bytes.replicate n <$> arbitrary]
    nested = do
      depth <- logarithmic 20000
      w <- word
      closed <- arbitrary
      inner <- fresh
      pure (Bytes.concat (replicate depth (w <> "\n") <> [inner] <> (if closed then replicate depth "end\n" else [])))

-- | The text with about a third of its numbers replaced by a few that lie at edges, so that very large and very small
-- ones come together.
exaggerated :: ByteString -> Gen ByteString
exaggerated text = Chars.unlines <$> traverse line (Chars.lines text)
  where
    line l = Chars.unwords <$> traverse word (Chars.words l)
    word w
      | Chars.any (`elem` ("0123456789" :: String)) (Bytes.take 2 w) && not (Chars.elem '/' w) = frequency [(2, pure w), (1, elements ["1e100", "-1e100", "1e99", "1e50", "1e10", "0", "1e-10", "1e-50", "1e-100", "1e38", "1e-38", "1", "65536"])]
      | otherwise = pure w

anyBytes :: Gen ByteString
anyBytes = logarithmic 400 >>= fmap Bytes.pack . vector

-- | A word that a file of a kind may have at the beginning of a line, or that another one may.
dictionary :: Kind -> Gen ByteString
dictionary = \case
  AgpFile -> Chars.pack <$> decimalComma
  ObjFile -> elements ["v 0 0 0", "v 1 2 3", "vt 0 1", "vn 0 0 1", "f 1 2 3", "f -1 -2 -3", "f 1/1/1 2/2/2 3/3/3", "f 1//1 2//2 3//3", "f 1/1 2/2 3/3", "usemtl a", "mtllib a.mtl", "o", "g x", "s 1", "#", "\\", "l 1 2"]
  MtlFile -> elements ["newmtl a", "newmtl", "Ka 1 1 1", "Kd 0.5", "Ks 1 1", "Ns 10", "map_Kd a.png", "map_Ka -s 1 1 1 b.png", "map_Ks -mm 0 1", "illum 2", "#", "\\", "d 1"]
  ConfigurationFile -> oneof [sceneWord, elements ["application console", "read_data s.txt", "write_data s.txt", "log_file_name log.txt", "viewport_image_count 12", "language fr"]]
  ComparisonList -> oneof [sceneWord, elements ["texture_comparator", "file a.png", "file b.png", "end"]]
  ProtocolLine -> elements ["{", "}", "[", "]", "\"id\":1", "\"op\":\"start\"", "\"in\":{}", "null", "1e400", "\"\\ud800\""]
  _ -> oneof [sceneWord, elements ["end", "fin", "primitive", "material", "geometry", "sphere", "xyz", "/*", "*/", "# x", "{", "camera"]]
  where
    sceneWord = Text.encodeUtf8 <$> elements allSpellings

-------------------------------------------------------------------------------
-- The scene language

-- | The words of an object with what they expect.
type Description = [([Keyword], Expectation, [Text])]

encoded :: [Text] -> ByteString
encoded = Text.encodeUtf8 . Text.unlines

sceneText :: Gen ByteString
sceneText = do
  settings <- concat <$> sequence [often 2 (object (spelling Keyword.Camera) cameraLines), pure <$> object "viewport" smallViewport, often 3 (object (spelling Keyword.Raytracer) (properties (described raytracerSchema)))]
  n <- frequency [(8, chooseInt (0, 4)), (1, chooseInt (5, 20))]
  things <- vectorOf n thing
  m <- chooseInt (0, 3)
  lamps <- vectorOf m light
  blocks <- frequency [(5, pure id), (1, shuffle (settings <> things <> lamps) >>= \s -> pure (const s))]
  pure (encoded (concat (blocks (settings <> things <> lamps))))
  where
    often k gen = frequency [(k, pure <$> gen), (1, pure [])]
    cameraLines = frequency [(2, pure ["position 0 0 -6", "look_at 0 0 0", "up 0 1 0", "far_clipping_plane 1e100"]), (2, properties (described cameraSchema))]
    -- Small, so that the rays through it are looked at closely.
    smallViewport = frequency [(4, (\w h -> ["width " <> w, "height " <> h]) <$> elements ["1", "2", "5", "16"] <*> elements ["1", "2", "7"]), (1, properties (described viewportSchema))]

modelText :: Gen ByteString
modelText = chooseInt (0, 5) >>= fmap (encoded . concat) . (`vectorOf` frequency [(4, thing), (1, object "model" (properties (described modelSchema)))])

-- | A primitive, or a material.
thing :: Gen [Text]
thing =
  frequency
    [ (4, object "primitive" ((\name s -> ("material_name " <> name) : s) <$> materialNames <*> shapes 3)),
      (2, object "material" (named (properties (described materialSchema)))),
      (1, object "texture_material" (named (properties (described textureMaterialSchema)))),
      (1, object "model" (properties (described modelSchema)))
    ]
  where
    named lines' = (\name rest -> rest <> ["name " <> name]) <$> materialNames <*> lines'
    materialNames = elements ["a", "b", "none"]

-- | A shape, so many levels deep in others at most.
shapes :: Int -> Gen [Text]
shapes depth = do
  (word, description) <- elements describeShapes
  lines' <- properties description
  if word == Keyword.Geometry && depth > 0 then (\inner -> object' word (lines' <> inner)) <$> shapes (depth - 1) else pure (object' word lines')
  where
    object' word lines' = [spelling word] <> lines' <> ["end"]

light :: Gen [Text]
light = elements describeLights >>= \(word, description) -> object (spelling word) (properties description)

-- | An object, which now and then is not closed.
object :: Text -> Gen [Text] -> Gen [Text]
object word inside = (\lines' end -> [word] <> lines' <> end) <$> inside <*> frequency [(40, pure ["end"]), (1, pure []), (1, pure ["edn"]), (1, pure ["end", "end"])]

described :: Schema a b -> Description
described = describe

-- | Some of the properties, some of them twice.
properties :: Description -> Gen [Text]
properties description = concat <$> traverse given description
  where
    given (words', wanted, _) = do
      count <- frequency [(5, pure 1), (4, pure 0), (1, chooseInt (2, 4))]
      vectorOf count ((\word v -> Text.intercalate " " [word, v]) <$> elements (concatMap (NonEmpty.toList . spellings) words') <*> value wanted)

-- | A value of the kind that is expected, most of the time.
value :: Expectation -> Gen Text
value wanted = frequency [(30, expected), (1, Text.pack <$> oddText), (1, Text.pack <$> extremeNumber)]
  where
    expected = case wanted of
      ARealNumber range -> ranged range
      AnInteger range -> frequency [(4, elements ["0", "1", "2", "3", "5", "20"]), (1, ranged range), (1, elements ["65536", "1000000", "2147483647"])]
      AVector -> coordinates 3
      AVectorWithoutZero -> coordinates 3
      ADirection -> coordinates 3
      TwoCoordinates -> coordinates 2
      AColour names -> oneof [elements names, (\n -> Text.unwords <$> vectorOf n channel) =<< chooseInt (3, 4)]
      AmountsOfLight -> Text.unwords <$> vectorOf 3 channel
      ABoolean -> elements ["true", "false", "yes", "0", "1"]
      AChoice names -> oneof [elements names, elements ["0", "1", "5", "99"]]
      SomeText -> elements ["a", "b", "none", "x.png", "a.obj", "é è", "../a"]
      AnOutputName -> elements ["a", "out.txt", "con", ".", "..", "é"]
      AnOutputNameEnding e -> elements ["a" <> e, e, "log" <> e]
    ranged range = frequency [(2, ordinary), (2, bounds range), (1, Text.pack <$> extremeNumber)]
    bounds = \case
      AnyNumber -> ordinary
      AtLeast low -> elements [low, "1"]
      Between low high -> elements [low, high]
    ordinary = oneof [elements ["0", "1", "0.5", "2", "-1", "1.5", "3", "1e-10", "100"], Text.pack . show <$> (choose (-5, 5) :: Gen Double)]
    channel = frequency [(5, elements ["0", "1", "0.5", "2"]), (1, elements ["1e100", "1e-100", "1e50"])]
    coordinates n = (\style xs -> style (Text.intercalate ", " xs)) <$> elements [id, \t -> "[" <> t <> "]"] <*> vectorOf n (frequency [(6, ordinary), (1, Text.pack <$> extremeNumber)])

configurationText :: Gen ByteString
configurationText = encoded <$> (properties describeConfiguration >>= shuffle)

comparisonText :: Gen ByteString
comparisonText = do
  n <- chooseInt (0, 5)
  encoded . concat <$> vectorOf n (object "texture_comparator" ((\k -> vectorOf k (elements ["file a.png", "file s.txt", "file é", "file", "fichier b.png"])) =<< chooseInt (0, 3)))

-------------------------------------------------------------------------------
-- Models

decimalComma :: Gen String
decimalComma = oneof [show <$> (choose (-3, 3) :: Gen Double), elements ["0,0", "1,5", "-2", "3,25", "1e2"], extremeNumber]

strokes :: Gen ByteString
strokes = do
  curves <- chooseInt (0, 4)
  Chars.unlines . concat <$> vectorOf curves curve
  where
    curve = do
      n <- logarithmic 8
      title <- elements [[], ["curve"], [""]]
      rows <- vectorOf 3 (frequency [(20, row n), (1, row (n + 1)), (1, pure "")])
      pure (title <> rows)
    row n = Chars.pack . unwords <$> vectorOf n (frequency [(8, show <$> (choose (-3, 3) :: Gen Double)), (1, decimalComma)])

polygons :: Gen ByteString
polygons = do
  n <- chooseInt (0, 30)
  Chars.unlines <$> vectorOf n line
  where
    line =
      frequency
        [ (8, (\xs -> Chars.pack (unwords ("v" : xs))) <$> vectorOf 3 number),
          (2, (\xs -> Chars.pack (unwords ("vt" : xs))) <$> (chooseInt (1, 3) >>= (`vectorOf` number))),
          (2, (\xs -> Chars.pack (unwords ("vn" : xs))) <$> vectorOf 3 number),
          (6, face),
          (2, dictionary ObjFile),
          (1, (\b -> Chars.pack "f 1 2 \\\n" <> b) <$> elements ["3", "", "f 1 2 3"])
        ]
    number = frequency [(8, show <$> (choose (-3, 3) :: Gen Double)), (3, elements ["0", "1", "-1"]), (1, extremeNumber)]
    face = do
      k <- frequency [(6, pure 3), (3, chooseInt (1, 6)), (1, logarithmic 60)]
      form <- elements [\i _ _ -> i, \i t _ -> i <> "/" <> t, \i _ m -> i <> "//" <> m, \i t m -> i <> "/" <> t <> "/" <> m]
      corners <- vectorOf k (form <$> index <*> index <*> index)
      pure (Chars.pack (unwords ("f" : corners)))
    index = frequency [(12, show <$> chooseInt (1, 8)), (4, show <$> chooseInt (-4, -1)), (1, elements ["0", "", "99", "2147483648", "-9223372036854775809", "1.5"])]

library :: Gen ByteString
library = do
  n <- chooseInt (0, 20)
  Chars.unlines <$> vectorOf n line
  where
    line =
      frequency
        [ (3, dictionary MtlFile),
          (4, (\w xs -> Chars.pack (unwords (w : xs))) <$> elements ["Ka", "Kd", "Ks", "Ns"] <*> (chooseInt (0, 4) >>= (`vectorOf` decimalComma))),
          (1, (\w o -> Chars.pack (unwords [w, o, "é x.png"])) <$> elements ["map_Ka", "map_Kd", "map_Ks"] <*> elements ["", "-s 1 2", "-o", "-mm 1 2", "-clamp on"])
        ]

-------------------------------------------------------------------------------
-- The protocol

-- | A request of the suite, with some of its values replaced.
request :: [ByteString] -> Gen ByteString
request known = do
  asked <- if null known then pure Nothing else decodeStrict <$> elements known
  Lazy.toStrict . encode <$> maybe (pure Null) spoilt asked
  where
    -- About one value in six is changed.
    spoilt v = frequency [(5, inside v), (1, other)]
    inside = \case
      Object o -> Object . Keys.fromList . concat <$> traverse member (Keys.toList o)
      Array items -> Array . Vector.fromList . concat <$> traverse entry (Vector.toList items)
      Number _ -> frequency [(3, number), (1, other)]
      String t -> frequency [(4, pure (String t)), (3, String . decoded <$> spoiltLines (dictionary SceneFile) "" (Text.encodeUtf8 t)), (1, String . decoded <$> sceneText)]
      v -> pure v
    member (k, v)
      | k `elem` ["id", "op"] = frequency [(30, pure [(k, v)]), (1, pure []), (1, (\w -> [(k, w)]) <$> other)]
      | otherwise = frequency [(20, (\w -> [(k, w)]) <$> spoiltOr v), (1, pure [])]
    spoiltOr v = frequency [(3, pure v), (2, spoilt v)]
    entry v = frequency [(20, pure <$> spoiltOr v), (1, pure []), (1, pure [v, v])]
    number =
      Number
        <$> oneof
          [ elements [0, 1, -1, 2, 0.5, 3],
            -- Scientific numbers are read, as a power of ten so high could not be computed.
            (\m e -> read (show (m :: Integer) <> "e" <> show (e :: Int))) <$> elements [1, -1, 9, 17976931348623157] <*> elements [-400, -324, -308, -160, -100, -20, -10, -1, 1, 10, 20, 100, 154, 292, 307, 308, 400, 1000000000],
            realToFrac <$> (choose (-10, 10) :: Gen Double)
          ]
    other = elements [Null, Bool True, String "", String "sphere", Array mempty, Array (Vector.fromList [Number 0, Number 0, Number 0]), Object mempty, Number 1]
    decoded = Text.decodeUtf8With (\_ _ -> Just '?')
