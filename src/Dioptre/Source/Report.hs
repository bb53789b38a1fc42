{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Report
-- Description : How diagnostics look
--
-- The same diagnostics for a person (the line, and a caret under what it is about), for a program (JSON), and as a
-- count.
--
-- > scene.txt:12:3: error: unknown word 'sphre'; did you mean 'sphere'?  [unknown-word]
-- >    12 |   sphre
-- >       |   ^^^^^
-- >       expected: one of end, material_name, sphere, plane ...
-- >       used: nothing: all is passed over down to line 15
module Dioptre.Source.Report
  ( Style,
    pretty,
    toJson,
    summary,
  )
where

import Data.Aeson (Value, object, (.=))
import Data.Char (isControl)
import Data.Maybe (catMaybes)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Diagnostic (Diagnostic (..), Severity (..), code, severity)
import Dioptre.Source.Language (Language (..), inLanguage)
import Dioptre.Source.Message (expected, message, severityName, used)
import Dioptre.Source.Phrase (counted, number, safe)
import Dioptre.Source.Span (Span (..), width)
import Dioptre.Source.Text (Source, lineAt, sourceName)
import Prettyprinter (Doc, annotate, fillSep, hang, hardline, indent)
import qualified Prettyprinter as Doc
import Prettyprinter.Render.Terminal (AnsiStyle, Color (..), bold, color)

-- $setup
-- >>> import Dioptre.Source.Language (Language (..))

-- | How a terminal shows it; a log leaves the colours out.
type Style = AnsiStyle

-- | A diagnostic for a person to read, in full.
--
-- Spec: cli.streams.
pretty :: Language -> Source -> Diagnostic -> Doc Style
pretty l source (Diagnostic place problem) =
  Doc.vsep $
    (annotate bold (Doc.pretty (safe (Text.pack (sourceName source))) <> at) <> " " <> hang 4 (annotate shade (Doc.pretty (severityName l level <> inLanguage l ":" "\xA0:")) <> " " <> annotate bold (Doc.pretty (safe (message l problem)))) <> "  " <> Doc.pretty ("[" <> code problem <> "]")) :
    [excerpt source place shade | width place > 0]
      <> catMaybes
        [ labelled (inLanguage l "expected:" "attendu\xA0:") <$> expected l problem,
          labelled (inLanguage l "used:" "utilisé\xA0:") <$> used l problem
        ]
  where
    level = severity problem
    at = foldMap (\n -> ":" <> Doc.pretty n) [spanLine place, spanColumn place] <> ":"
    shade = color $ case level of
      Error -> Red
      Warning -> Yellow
      Note -> Cyan
    labelled label t = indent 6 (hang 4 (Doc.pretty (label :: Text) <> " " <> fillSep (map Doc.pretty (Text.splitOn " " (safe t)))))

-- | The line, and a caret under each character that the diagnostic is about. Of a long line only the part around it is
-- shown.
excerpt :: Source -> Span -> Style -> Doc Style
excerpt source place shade =
  numbered (number (spanLine place)) shown <> hardline <> numbered "" (Doc.pretty gap <> annotate shade (Doc.pretty carets))
  where
    numbered label text = Doc.pretty (Text.justifyRight 5 ' ' label) <> " | " <> text
    line = lineAt source (spanLine place)
    from = if spanColumn place > 90 then spanColumn place - 40 else 1
    before = Text.take (spanColumn place - from) (Text.drop (from - 1) line)
    rest = Text.take (max 20 (100 - Text.length before)) (Text.drop (spanColumn place - 1) line)
    shown = Doc.pretty (Text.map printable (before <> rest))
    -- A tab above is a tab below, so that the caret stands right whatever a tab is wide.
    gap = Text.map (\c -> if c == '\t' then '\t' else ' ') before
    carets = Text.replicate (max 1 (min (width place) (Text.length rest))) "^"
    printable c = if isControl c && c /= '\t' then '·' else c

-- | A diagnostic for a program to read. Lines and columns count from 1, columns in code points; the end is exclusive.
-- What is not there is left out.
--
-- Spec: cli.check.json.
toJson :: Language -> FilePath -> Diagnostic -> Value
toJson l file (Diagnostic place problem) =
  object $
    [ "file" .= file,
      "code" .= code problem,
      "severity" .= severityName English (severity problem),
      "line" .= spanLine place,
      "column" .= spanColumn place,
      "endColumn" .= spanEndColumn place,
      "message" .= message l problem
    ]
      <> ["expected" .= t | Just t <- [expected l problem]]
      <> ["used" .= t | Just t <- [used l problem]]

-- | How many of each there are, in words; nothing where there are none.
--
-- >>> summary English []
-- Nothing
summary :: Language -> [Diagnostic] -> Maybe Text
summary l diagnostics = case [counted l n (forms English) (forms French) | level <- [Error, Warning, Note], let n = count level; forms = named level, n > 0] of
  [] -> Nothing
  parts -> Just (Text.intercalate ", " parts)
  where
    count level = length (filter ((== level) . severity . diagnosticProblem) diagnostics)
    named level language = let name = severityName language level in (name, name <> "s")
