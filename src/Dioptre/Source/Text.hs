{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Text
-- Description : From bytes to lines of text
--
-- The first stage: the bytes of a file become text. Real scenes were written on many machines over many years, so
-- a file is UTF-8 if it can be, or else Latin-1 (in which every sequence of bytes means something, so that this stage
-- cannot fail); a byte-order mark is skipped; a line ends at CR LF, LF or CR.
module Dioptre.Source.Text
  ( Source,
    sourceName,
    sourceText,
    decode,
    fromText,
    lineAt,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Either (fromRight)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Data.Vector (Vector, (!?))
import qualified Data.Vector as Vector

-- | A file as text: its name as messages give it, and its text with every line end turned into one line feed.
data Source = Source
  { -- | The name that messages show.
    sourceName :: FilePath,
    -- | The text; lines are separated by @\\n@, and there is no @\\r@.
    sourceText :: Text,
    sourceLines :: Vector Text
  }
  deriving stock (Eq, Show)

-- | The text of a file's bytes. Total, linear.
--
-- >>> sourceText (decode "scene.txt" "\xEF\xBB\xBFlumi\xC3\xA8re\r\nend\r")
-- "lumi\232re\nend\n"
-- >>> sourceText (decode "scene.txt" "lumi\xE8re")
-- "lumi\232re"
decode :: FilePath -> ByteString -> Source
decode name bytes = fromText name (fromRight latin1 utf8)
  where
    utf8 = Text.decodeUtf8' (dropMark bytes)
    latin1 = Text.decodeLatin1 (dropMark bytes)
    dropMark b = fromMaybe b (Bytes.stripPrefix "\xEF\xBB\xBF" b)

-- | A source of text that is at hand already.
fromText :: FilePath -> Text -> Source
fromText name raw = Source name text (Vector.fromList (Text.split (== '\n') text))
  where
    text = Text.replace "\r" "\n" (Text.replace "\r\n" "\n" raw)

-- | The line of that number, counted from 1; empty where there is none.
lineAt :: Source -> Int -> Text
lineAt source n = fromMaybe Text.empty (sourceLines source !? (n - 1))
