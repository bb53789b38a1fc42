{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Reading
-- Description : Reading a scene in one step, and what is true of everything that is said on the way
--
-- The way from bytes to a scene, as the program goes it, and the laws of its diagnostics.
module Laws.Reading
  ( -- * Reading
    Reading (..),
    readSource,
    readText,
    readBytes,
    readLines,
    linesOf,
    errorsOf,

    -- * Places
    Said,
    said,
    at,
    on,

    -- * Laws of diagnostics
    standsInTheText,
    isInOrder,
    isSaidInBothLanguages,
    hasAStableCode,
    isToldToPrograms,
    isShownSafely,
  )
where

import Data.Aeson (Value (..), decode, encode)
import qualified Data.Aeson as Aeson
import Data.ByteString (ByteString)
import Data.Char (isAsciiLower, isControl)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Message (expected, message, used)
import Dioptre.Source.Report (pretty, toJson)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, fromText, sourceText)
import qualified Dioptre.Source.Text as Source
import Dioptre.Syntax.Grammar (parse)
import Test.QuickCheck

-- | A text, the scene that it describes, and all that there is to say of it.
data Reading = Reading
  { readingSource :: Source,
    readingScene :: Scene,
    readingDiagnostics :: [Diagnostic]
  }

readSource :: Source -> Reading
readSource source = uncurry (Reading source) (checkScene (parse source))

readText :: Text -> Reading
readText = readSource . fromText "scene.txt"

readBytes :: ByteString -> Reading
readBytes = readSource . Source.decode "scene.txt"

-- | Lines, each ended by a line feed.
readLines :: [Text] -> Reading
readLines = readText . Text.unlines

-- | The lines of a text, without their ends; a text that ends in a line end has an empty last line.
linesOf :: Source -> [Text]
linesOf = Text.split (== '\n') . sourceText

-- | What is said of a reading that is an error.
errorsOf :: Reading -> [Diagnostic]
errorsOf = filter ((== Error) . severity . diagnosticProblem) . readingDiagnostics

-- | A code, a line, a column, and the column after the end.
type Said = (Text, Int, Int, Int)

-- | What is said of a reading, errors only, by code and place.
said :: [Text] -> [Said]
said text = [(code p, line, from, to) | Diagnostic (Span line from to) p <- errorsOf (readLines text)]

-- | A problem at a line, from a column to before another one.
at :: Int -> Int -> Int -> Problem -> Diagnostic
at line from to = Diagnostic (Span line from to)

-- | A problem at the place of a piece of text that stands once in that line.
on :: [Text] -> Int -> Text -> Problem -> Diagnostic
on text line piece = at line column (column + Text.length piece)
  where
    column = case Text.breakOnAll piece (text !! (line - 1)) of
      [(before, _)] -> Text.length before + 1
      places -> error (show piece <> " stands " <> show (length places) <> " times in line " <> show line)

-------------------------------------------------------------------------------
-- Laws of diagnostics

-- | Every place is inside the text: the line is there, and the columns are on it or right behind it.
standsInTheText :: Reading -> Property
standsInTheText r = conjoin [counterexample (show d) (inside (diagnosticSpan d)) | d <- readingDiagnostics r]
  where
    lengths = Map.fromList (zip [1 ..] (map Text.length (linesOf (readingSource r))))
    inside (Span line from to) = case Map.lookup line lengths of
      Just columns -> 1 <= from && from <= to && to <= columns + 1
      Nothing -> False

-- | Diagnostics come in the order of their places.
isInOrder :: Reading -> Property
isInOrder r = places === sort places
  where
    places = [(spanLine s, spanColumn s) | Diagnostic s _ <- readingDiagnostics r]

-- | Everything that is said is said in English and in French, which are not the same; what was expected and what is
-- used are said in both or in neither.
isSaidInBothLanguages :: Problem -> Property
isSaidInBothLanguages p =
  conjoin
    [ counterexample "message" (sentence (message English p) && sentence (message French p) && message English p /= message French p),
      both expected,
      both used
    ]
  where
    sentence t = not (Text.null (Text.strip t))
    both say = case (say English p, say French p) of
      (Nothing, Nothing) -> property True
      (Just en, Just fr) -> counterexample (show (en, fr)) (not (Text.null en) && not (Text.null fr))
      other -> counterexample (show other) False

-- | A code is made of lower-case words with hyphens between them.
hasAStableCode :: Problem -> Property
hasAStableCode p = counterexample (show (code p)) $ all word (Text.splitOn "-" (code p))
  where
    word w = not (Text.null w) && Text.all isAsciiLower w

-- | A program is told the file, the code, the severity, the place and the message; and what was expected and used where
-- it is known.
isToldToPrograms :: Diagnostic -> Property
isToldToPrograms d@(Diagnostic (Span line from to) p) = conjoin $ do
  l <- [English, French]
  let wanted =
        [ ("file", String "a/b.txt"),
          ("code", String (code p)),
          ("severity", String (Text.toLower (Text.pack (show (severity p))))),
          ("line", Number (fromIntegral line)),
          ("column", Number (fromIntegral from)),
          ("endColumn", Number (fromIntegral to)),
          ("message", String (message l p))
        ]
          <> [("expected", String t) | Just t <- [expected l p]]
          <> [("used", String t) | Just t <- [used l p]]
  pure (fields (toJson l "a/b.txt" d) === Just (Map.fromList wanted))

-- | The fields of an object, as they are when they have been written and read.
fields :: Aeson.Value -> Maybe (Map.Map Text Aeson.Value)
fields = decode . encode

-- | What a person is shown holds no control character but line ends and tabs.
isShownSafely :: Source -> Diagnostic -> Property
isShownSafely source d = conjoin $ do
  l <- [English, French]
  let shown = show (pretty l source d)
  pure (counterexample (show shown) (not (any (\c -> isControl c && c `notElem` ("\n\t" :: String)) shown)))
