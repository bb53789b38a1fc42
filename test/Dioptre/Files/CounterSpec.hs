{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Files.CounterSpec (spec) where

import Control.Exception (evaluate)
import Control.Monad (forM_)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isDigit, toLower)
import Data.List (isInfixOf, stripPrefix)
import Data.Maybe (fromMaybe, isJust, listToMaybe, mapMaybe)
import Dioptre.Files.Counter
import Dioptre.Files.Number (PictureNumber, next, pictureNumber, pictureNumberValue)
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = describe "replaceCounter" $ do
  modifyMaxSuccess (const 2000) $ do
    prop "is read back" . forAllFiles $ \file ->
      forAll numbers $ \number -> do
        let found = readCounter (replaceCounter number file)
        cover 20 (isJust (readCounter file)) "has a counter"
          . cover 5 (unclosed file) "has an open comment"
          $ found === Just (pictureNumberValue number)

    prop "leaves the last number of two" . forAllFiles $ \file ->
      forAll ((,) <$> numbers <*> numbers) $ \(one, other) ->
        replaceCounter other (replaceCounter one file) === replaceCounter other file

    prop "changes nothing but the value" . forAllFiles $ \file ->
      forAll numbers $ \number -> do
        let changed = replaceCounter number file
        counterexample (show changed) (any (isValueEdit number) (edits file changed))

  describe "replaces the value" $
    forM_
      [ ("viewport_image_count\t41\n", "viewport_image_count\t7\n"),
        ("viewport_image_count 0", "viewport_image_count 7"),
        ("Viewport_IMAGE_Count 041 images\r\n", "Viewport_IMAGE_Count 7 images\r\n"),
        (" \t\fviewport_image_count\f+999\t\r# fin", " \t\fviewport_image_count\f7\t\r# fin"),
        ("viewport_image_count [ 3, 4 ]\n", "viewport_image_count [ 7, 4 ]\n"),
        ("viewport_image_count <3>", "viewport_image_count <7>"),
        ("viewport_image_count many of them\n", "viewport_image_count 7 of them\n"),
        ("viewport_image_count -1\n", "viewport_image_count 7\n"),
        ("viewport_image_count 12.5\n", "viewport_image_count 7\n"),
        ("\xEF\xBB\xBFviewport_image_count 3\n", "\xEF\xBB\xBFviewport_image_count 7\n"),
        ("read_data sc\xE8ne.txt\nviewport_image_count 3\xE8\n", "read_data sc\xE8ne.txt\nviewport_image_count 7\n"),
        ("viewport_image_count 1\nviewport_image_count 2\nend\n", "viewport_image_count 1\nviewport_image_count 7\nend\n")
      ]
      becomes

  describe "puts a value where there is none" $
    forM_
      [ ("viewport_image_count", "viewport_image_count\t7"),
        ("viewport_image_count\r\nend", "viewport_image_count\t7\r\nend"),
        ("viewport_image_count \t\n", "viewport_image_count \t7\n"),
        ("viewport_image_count # next\n", "viewport_image_count 7 # next\n"),
        ("viewport_image_count\t//3\n", "viewport_image_count\t7 //3\n"),
        ("viewport_image_count ()\n", "viewport_image_count ()7\n")
      ]
      becomes

  describe "passes over comments" $
    forM_
      [ ("#viewport_image_count 1\n", "#viewport_image_count 1\nviewport_image_count\t7\n"),
        ("# viewport_image_count 1\n", "# viewport_image_count 1\nviewport_image_count\t7\n"),
        ("viewport_image_count 1\n/*\nviewport_image_count 2\n*/\n", "viewport_image_count 7\n/*\nviewport_image_count 2\n*/\n"),
        ("/* a */\nviewport_image_count 2\n", "/* a */\nviewport_image_count 7\n"),
        ("/* a */ viewport_image_count 2\n", "/* a */ viewport_image_count 2\nviewport_image_count\t7\n"),
        ("/**\nviewport_image_count 2\n", "/**\nviewport_image_count 7\n"),
        ("/*/\nviewport_image_count 2\n", "/*/\nviewport_image_count 7\n"),
        ("/*\na */\n*/ b\nviewport_image_count 2\n", "/*\na */\n*/ b\nviewport_image_count 7\n"),
        ("viewport_image_count 1\n/*\na */\nviewport_image_count 2\n", "viewport_image_count 7\n/*\na */\nviewport_image_count 2\n")
      ]
      becomes

  describe "adds a line that is missing" $
    forM_
      [ ("", "viewport_image_count\t7\n"),
        ("\xEF\xBB\xBF", "\xEF\xBB\xBFviewport_image_count\t7\n"),
        ("log_file on\n", "log_file on\nviewport_image_count\t7\n"),
        ("log_file on\r\n", "log_file on\r\nviewport_image_count\t7\r\n"),
        ("log_file on\r", "log_file on\rviewport_image_count\t7\r"),
        ("log_file on", "log_file on\nviewport_image_count\t7\n"),
        ("a\r\nlog_file on", "a\r\nlog_file on\r\nviewport_image_count\t7\r\n"),
        ("viewport_image_counts 3\n", "viewport_image_counts 3\nviewport_image_count\t7\n"),
        ("viewport_image_count,3\n", "viewport_image_count,3\nviewport_image_count\t7\n"),
        ("a\r\n /*\r\nb", "a\r\nviewport_image_count\t7\r\n /*\r\nb"),
        ("\xEF\xBB\xBF/*", "\xEF\xBB\xBFviewport_image_count\t7\n/*")
      ]
      becomes

  describe "takes linear time" $
    forM_
      [ ("lines", Char8.replicate size '\n'),
        ("carriage returns", Char8.replicate size '\r'),
        ("one long line", Char8.replicate size 'v'),
        ("blanks", Char8.replicate size ' '),
        ("counters", repeated "viewport_image_count 1\n"),
        ("values", "viewport_image_count " <> Char8.replicate size '1'),
        ("separators", "viewport_image_count " <> Char8.replicate size '('),
        ("comments", repeated "/* a */\r\n"),
        ("openings", repeated "/*\n"),
        ("stars", "/* " <> Char8.replicate size '*')
      ]
      $ \(what, file) ->
        it ("on a million bytes of " <> what) $
          -- A tenth of a second is ample; a quadratic pass would take minutes.
          timeout 5000000 (evaluate (Bytes.length (replaceCounter seven file)))
            >>= (`shouldSatisfy` maybe False (> 0))
  where
    size = 1000000
    repeated piece = Bytes.concat (replicate (size `div` Bytes.length piece) piece)
    becomes (file, changed) =
      it (show file) (replaceCounter seven file `shouldBe` changed)

-- | Seven, counted from zero.
seven :: PictureNumber
seven = iterate next minBound !! 7

-- | Whether an edit, from the first to the second, is one that the law allows.
isValueEdit :: PictureNumber -> (ByteString, ByteString) -> Bool
isValueEdit number (old, new)
  | Bytes.null old = new `elem` inserted || new `elem` added
  | otherwise = new == digits && Char8.all (`notElem` (" \t\f\r\n,()[]<>" :: String)) old
  where
    digits = Char8.pack (show (pictureNumberValue number))
    inserted = [gap <> digits <> space | gap <- ["", "\t"], space <- ["", " "]]
    added = [start <> "viewport_image_count\t" <> digits <> end | end <- ["\n", "\r", "\r\n"], start <- ["", end]]

-- | Every way to say that one file became another by replacing one piece.
edits :: ByteString -> ByteString -> [(ByteString, ByteString)]
edits old new =
  [ (piece old, piece new)
    | start <- [0 .. common old new],
      end <- [0 .. common (Bytes.reverse old) (Bytes.reverse new)],
      start + end <= min (Bytes.length old) (Bytes.length new),
      let piece file = Bytes.take (Bytes.length file - start - end) (Bytes.drop start file)
  ]
  where
    common a b = length (takeWhile id (Bytes.zipWith (==) a b))

-- | A second reader, by the rules alone: the value of the last counter that can be read as a number.
readCounter :: ByteString -> Maybe Int
readCounter = listToMaybe . reverse . mapMaybe counter . fst . statements

-- | Whether the file ends in a comment.
unclosed :: ByteString -> Bool
unclosed = snd . statements

-- | The lines outside of comments, and whether the last comment is open.
statements :: ByteString -> ([String], Bool)
statements bytes = outside (rows (fromMaybe text (stripPrefix "\xEF\xBB\xBF" text)))
  where
    text = Char8.unpack bytes
    rows rest = case break (`elem` ("\r\n" :: String)) rest of
      (row, '\r' : '\n' : more) -> row : rows more
      (row, _ : more) -> row : rows more
      (row, "") -> [row]
    outside [] = ([], False)
    outside (row : more) = case parts " \t\f" row of
      "/*" : _ | not ("*/" `isInfixOf` drop 2 (dropWhile (/= '/') row)) -> inside more
      _ -> let (found, open) = outside more in (row : found, open)
    inside [] = ([], True)
    inside (row : more) = case parts " \t\f" row of
      "*/" : _ -> outside more
      _ -> inside more

-- | The number that a line gives to the counter.
counter :: String -> Maybe Int
counter row = case parts " \t\f" row of
  word : _
    | map toLower word == "viewport_image_count" ->
      case parts " \t\f,()[]<>" (drop (length word) (dropWhile (`elem` (" \t\f" :: String)) row)) of
        value : _ | all isDigit value -> Just (read value)
        _ -> Nothing
  _ -> Nothing

parts :: String -> String -> [String]
parts separators text = case dropWhile (`elem` separators) text of
  "" -> []
  rest -> let (part, more) = break (`elem` separators) rest in part : parts separators more

forAllFiles :: Testable property => (ByteString -> property) -> Property
forAllFiles = forAll files

-- | Small configurations with everything that could mislead, in any encoding, with any line ends.
files :: Gen ByteString
files = do
  mark <- frequency [(4, pure ""), (1, pure "\xEF\xBB\xBF")]
  lineEnds <- oneof [pure <$> elements ends, pure ends]
  rows <- resize 8 . listOf $ (<>) <$> row <*> elements lineEnds
  rest <- frequency [(2, pure ""), (1, row)]
  pure (Bytes.concat ([mark] <> rows <> [rest]))
  where
    ends = ["\n", "\r\n", "\r"]
    row = (<>) <$> elements ["", "", "", " ", "\t\f"] <*> frequency [(3, setting), (1, other), (2, comment), (1, noise)]
    setting = do
      word <- elements ["viewport_image_count", "VIEWPORT_image_COUNT"]
      gap <- elements ["", " ", "\t\t", " (", "\f"]
      value <- elements ["", "0", "41", "007", "+5", "-5", "x", "12.5", "#", "# 3", "/*", "*/", "[1, 2]", "\xE8", "999)"]
      rest <- elements ["", " ", " # next", " images", ",3", "\t4"]
      pure (word <> gap <> value <> rest)
    other = elements ["", "application console", "read_data sc\xC3\xA8ne.txt", "read_data sc\xE8ne.txt", "end", "viewport_image_count2 3"]
    comment = elements ["/*", "/*", "*/", "*/", "/* viewport_image_count 3", "/* a */", "/**", "# viewport_image_count 3", "*/ viewport_image_count 3", "a */"]
    noise = Bytes.filter (`notElem` [10, 13]) . Bytes.pack <$> resize 6 arbitrary

numbers :: Gen PictureNumber
numbers = chooseInt (0, 999) `suchThatMap` pictureNumber
