{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Text
-- Description : What is true of reading, whatever the text
--
-- Texts of three kinds: scenes as people write them, such scenes with something wrong, and bytes that mean nothing.
-- What holds of all of them is written for bytes or for any text; what holds of the layout is written for both.
module Laws.Text
  ( -- * Texts
    SceneText (..),
    Noise (..),
    kindsOfTexts,

    -- * Laws of decoding
    decodesUtf8,
    decodesLatin1,
    skipsTheMark,
    readsAnyLineEnd,
    countsCodePoints,

    -- * Laws of reading
    isReadWhole,
    ignoresComments,
    ignoresIndentation,
    ignoresCase,
    endsWhereItEnds,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Char (isAscii, isAsciiLower, ord)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Source.Diagnostic (Diagnostic (..), code)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (decode, lineAt, sourceText)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.Syntax.Tree (Block (..), Closing (..), Head (..), Node (..), Property (..), Value (..))
import Laws.Number (NumberText (..))
import Laws.Reading
import Laws.Scene
import Test.QuickCheck hiding (Property)
import qualified Test.QuickCheck as QuickCheck

-------------------------------------------------------------------------------
-- Laws of decoding

-- | What was encoded in UTF-8 comes back, with line feeds for line ends.
decodesUtf8 :: Text -> QuickCheck.Property
decodesUtf8 t = sourceText (decode "" (Text.encodeUtf8 t)) === withLineFeeds (withoutMark t)

-- | Bytes that are not UTF-8 are Latin-1: each is the code point of its number.
decodesLatin1 :: [Int] -> QuickCheck.Property
decodesLatin1 codes = forAll (elements [0xff, 0xc0, 0xf5, 0x80]) $ \bad ->
  let bytes = 0x61 : bad : map (`mod` 256) codes
   in sourceText (decode "" (Bytes.pack (map fromIntegral bytes))) === withLineFeeds (Text.pack (map toEnum bytes))

-- | A byte-order mark changes nothing, whatever follows it.
skipsTheMark :: ByteString -> QuickCheck.Property
skipsTheMark bytes = not (mark `Bytes.isPrefixOf` bytes) ==> decode "a" (mark <> bytes) === decode "a" bytes
  where
    mark = Bytes.pack [0xef, 0xbb, 0xbf]

withoutMark :: Text -> Text
withoutMark t = if Text.take 1 t == "\65279" then Text.drop 1 t else t

withLineFeeds :: Text -> Text
withLineFeeds = Text.pack . go . Text.unpack
  where
    go text = case text of
      '\r' : '\n' : rest -> '\n' : go rest
      '\r' : rest -> '\n' : go rest
      c : rest -> c : go rest
      [] -> []

-- | Line ends of either kind, or of all kinds together, give the same tree, places included.
readsAnyLineEnd :: Text -> QuickCheck.Property
readsAnyLineEnd t = conjoin [treeOf (Text.intercalate ends lines') === treeOf (Text.intercalate "\n" lines') | ends <- ["\r\n", "\r"]] .&&. mixed
  where
    lines' = Text.split (== '\n') (withLineFeeds (withoutMark t))
    mixed = forAll (vectorOf (length lines') (elements ["\n", "\r\n", "\n"])) $ \ends ->
      treeOf (Text.concat (zipWith (<>) lines' ends)) === treeOf (Text.unlines lines')
    treeOf = parse . decode "a" . Text.encodeUtf8

-- | The place of every word and value, in code points of its line, holds that word or value.
countsCodePoints :: Text -> QuickCheck.Property
countsCodePoints t = conjoin (map (uncurry holds) (concatMap places (parse source)))
  where
    source = decode "a" (Text.encodeUtf8 t)
    holds (Span line from to) piece = counterexample (show (line, from, to)) $ Text.take (to - from) (Text.drop (from - 1) (lineAt source line)) === piece
    places node = case node of
      Object b -> ofHead (blockHead b) : concatMap places (blockNodes b) <> closing (blockClosing b)
      Statement p -> [ofHead (propertyHead p), (valueSpan (propertyValue p), valueText (propertyValue p))]
      LooseEnd h -> [ofHead h]
      OpenComment s -> [(s, "/*")]
    closing c = case c of
      ByEnd _ -> []
      ByMisspeltEnd h -> [ofHead h]
      BySceneWord h -> [ofHead h]
      ByEndOfFile -> []
    ofHead h = (headSpan h, headText h)

-------------------------------------------------------------------------------
-- Laws of reading

-- | Any text has a scene that is sound, and all that is said of it has a place, an order, both languages, a code, a
-- form for programs and one for people.
isReadWhole :: Reading -> QuickCheck.Property
isReadWhole r =
  conjoin
    [ isSound (readingScene r),
      standsInTheText r,
      isInOrder r,
      conjoin [isSaidInBothLanguages p .&&. hasAStableCode p | p <- map diagnosticProblem (readingDiagnostics r)],
      conjoin [isToldToPrograms d .&&. isShownSafely (readingSource r) d | d <- readingDiagnostics r]
    ]

-- | Comments and empty lines put in anywhere change neither the scene nor what is said of it, but for the numbers of
-- lines.
ignoresComments :: Text -> QuickCheck.Property
ignoresComments t = forAll (vectorOf (length lines') (frequency [(3, pure []), (1, (: []) <$> elements ["", "  ", "# end", "\t! sphere", "- 1", "/camera", "@", "*"])])) $ \added ->
  let longer = Text.intercalate "\n" (concat (zipWith (\more line -> more <> [line]) added lines'))
      -- The new number of each line.
      moved n = n + length (concat (take n added))
   in summarised id (readText longer) === summarised moved (readText t)
  where
    lines' = Text.split (== '\n') (withLineFeeds t)

-- | Blanks before the first word of a line change neither the scene nor what is said of it, but for the columns.
ignoresIndentation :: Text -> QuickCheck.Property
ignoresIndentation t = forAll (vectorOf (length lines') (elements ["", " ", "\t\t", " \f "])) $ \blanks ->
  let moved = Text.intercalate "\n" (zipWith (<>) blanks lines')
   in withoutColumns (readText moved) === withoutColumns (readText t)
  where
    lines' = Text.split (== '\n') (withLineFeeds t)
    withoutColumns r = (readingScene r, [(spanLine s, code p) | Diagnostic s p <- readingDiagnostics r])

-- | The first words of lines may be in capitals or not.
ignoresCase :: Text -> QuickCheck.Property
ignoresCase t = summarised id (readText (Text.intercalate "\n" (map capital lines'))) === summarised id (readText t)
  where
    lines' = Text.split (== '\n') (withLineFeeds t)
    capital line = let (word, rest) = Text.break (`elem` (" \t\f" :: String)) (Text.stripStart line) in Text.take (Text.length line - Text.length (Text.stripStart line)) line <> Text.map ascii word <> rest
    ascii c = if isAsciiLower c then toEnum (ord c - 32) else c

-- | A line end at the end of a text makes no difference.
endsWhereItEnds :: Text -> QuickCheck.Property
endsWhereItEnds t = not ("\r" `Text.isSuffixOf` t) ==> summarised id (readText (t <> "\n")) === summarised id (readText t)

summarised :: (Int -> Int) -> Reading -> (String, [(Text, Int, Int, Int)])
summarised f r = (show (readingScene r), [(code p, renumbered s, spanColumn s, spanEndColumn s) | Diagnostic s p <- readingDiagnostics r])
  where
    -- What is said of the file as a whole stands at its beginning.
    renumbered s = if s == Span 1 1 1 then 1 else f (spanLine s)

-------------------------------------------------------------------------------
-- Texts

-- | A scene as people write it, with or without something wrong.
newtype SceneText = SceneText {sceneText :: Text}
  deriving (Eq)

instance Show SceneText where
  show (SceneText t) = show t

instance Arbitrary SceneText where
  arbitrary = SceneText <$> oneof [wellFormed, wellFormed >>= mutated, soup]
  shrink (SceneText t) = map (SceneText . Text.intercalate "\n") (shrinkList (const []) (Text.split (== '\n') t))

wellFormed :: Gen Text
wellFormed = arbitrary >>= disguised . pieces . anyScene

-- | Several things wrong, each in a way that happens: a letter or a line that is missing, twice, elsewhere, or another.
mutated :: Text -> Gen Text
mutated text = chooseInt (1, 8) >>= \n -> times n text
  where
    times :: Int -> Text -> Gen Text
    times n t = if n == 0 then pure t else oneof [aLetter t, aLine t] >>= times (n - 1)
    aLetter t = do
      (a, b) <- (`Text.splitAt` t) <$> chooseInt (0, Text.length t)
      c <- Text.singleton <$> elements "endfi 01.-+eE#/*[,]\t\n\r\233\0x"
      elements [a <> c <> b, a <> Text.drop 1 b, a <> c <> Text.drop 1 b, a <> Text.reverse (Text.take 2 b) <> Text.drop 2 b, if Text.length t > 400 then t else a]
    aLine t = do
      let lines' = Text.split (== '\n') t
      (a, b) <- (`splitAt` lines') <$> chooseInt (0, length lines')
      other <- oneof [someLine, if null lines' then someLine else elements lines']
      Text.intercalate "\n" <$> elements [a <> [other] <> b, a <> drop 1 b, a <> take 1 b <> b, a <> reverse (take 2 b) <> drop 2 b, a <> [other] <> drop 1 b, a <> ["cube", "end"] <> b]

-- | Lines of the language, in no order.
soup :: Gen Text
soup = Text.unlines <$> resize 40 (listOf someLine)

someLine :: Gen Text
someLine =
  frequency
    [ (6, elements words'),
      (6, (\w v -> w <> " " <> v) <$> elements words' <*> value),
      (2, elements ["end", "fin", "edn", "End", "en", "find"]),
      (1, elements ["", " ", "#", "/*", "*/", "/* */", "- x"]),
      (1, (<>) <$> elements ["sphre", "x", "mat\233riel", "unknown_word", "endd"] <*> elements ["", " ", " 1"])
    ]
  where
    value = oneof [numberText <$> arbitrary, elements ["[0, 0, 1]", "1 2 3", "1 2", "red", "rouge 0.5", "1 2 3 4 5", "none", "true", "7", "-1", "", "NaN", "1e101", "0", "0 0 0", "a b", "out/x"]]
    words' =
      ["camera", "viewport", "raytracer", "primitive", "primitive", "material", "texture_material", "point_light", "ambient_light", "directional_light", "linear_aperture_light", "rectangular_aperture_light", "aperture_mask_light", "model"]
        <> ["sphere", "plane", "disk", "annulus", "triangle", "btriangle", "tube", "cylinder", "cone", "cube", "spherical_cap", "lens", "torus", "geometry", "scene", "particle", "view_frustum"]
        <> ["position", "look_at", "up", "width", "height", "angle", "near_clipping_plane", "image_file_name", "ray", "inner_ray", "name", "material_name", "color", "normal", "point", "ka", "n", "p", "scale", "uv", "curvature", "wave_length", "sampling", "reflexion_algorithm", "pixel_coordinate", "file", "orientation", "read_data", "constant_attenuator"]

-- | Bytes that mean nothing.
newtype Noise = Noise {noise :: ByteString}
  deriving (Eq, Show)

instance Arbitrary Noise where
  arbitrary =
    Noise
      <$> oneof
        [ Bytes.pack <$> arbitrary,
          Bytes.pack . map fromIntegral <$> listOf (elements [10, 13, 32, 9, 47, 42, 35, 0xc3, 0xa9, 0xe9, 0, 27, 0x65, 0x6e, 0x64 :: Int]),
          do
            -- A scene whose bytes fell into bad hands.
            text <- Text.encodeUtf8 . sceneText <$> arbitrary
            (a, b) <- (`Bytes.splitAt` text) <$> chooseInt (0, Bytes.length text)
            byte <- arbitrary
            elements [a <> Bytes.cons byte b, a <> Bytes.cons byte (Bytes.drop 1 b), b <> a, Bytes.map (\x -> if x == 10 then byte else x) text, text]
        ]
  shrink (Noise b) = [Noise (Bytes.take i b <> Bytes.drop (i + n) b) | n <- [200, 20, 1], i <- [0, n .. Bytes.length b - 1]]

-- | What was drawn, so that nothing is missed.
kindsOfTexts :: Reading -> [(String, Bool)]
kindsOfTexts r =
  [ ("without an error", null (errorsOf r)),
    ("with one error", length (errorsOf r) == 1),
    ("with more than three errors", length (errorsOf r) > 3),
    ("beyond ASCII", not (Text.all isAscii (sourceText (readingSource r))))
  ]
    <> [ (Text.unpack k, k `elem` map (code . diagnosticProblem) (readingDiagnostics r))
         | k <- ["unknown-word", "misplaced-word", "stray-end", "misspelt-end", "missing-end", "unclosed-comment", "second-shape", "no-shape", "out-of-range", "not-a-number", "wrong-count"]
       ]
