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
    characters,
    byteOrderMark,
    fromText,
    excerpts,
    lineAt,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Either (fromRight)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
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
    sourceLines :: Lines
  }
  deriving stock (Eq, Show)

-- | All lines, or some by their numbers.
data Lines = Whole (Vector Text) | Some (IntMap Text)
  deriving stock (Eq, Show)

-- | The text of a file's bytes. Total, linear.
--
-- >>> sourceText (decode "scene.txt" "\xEF\xBB\xBFlumi\xC3\xA8re\r\nend\r")
-- "lumi\232re\nend\n"
-- >>> sourceText (decode "scene.txt" "lumi\xE8re")
-- "lumi\232re"
--
-- Spec: text.encoding, text.mark, text.line-end.
decode :: FilePath -> ByteString -> Source
decode name bytes = fromText name (characters (dropMark bytes))
  where
    dropMark b = fromMaybe b (Bytes.stripPrefix byteOrderMark b)

-- | What some programs put before the text of a file, to say that it is UTF-8.
byteOrderMark :: ByteString
byteOrderMark = "\xEF\xBB\xBF"

-- | The characters of some bytes: UTF-8 if they can be, or else Latin-1.
characters :: ByteString -> Text
characters bytes = fromRight (Text.decodeLatin1 bytes) (Text.decodeUtf8' bytes)

-- | A source of text that is at hand already.
--
-- Spec: protocol.text, text.line-end.
fromText :: FilePath -> Text -> Source
fromText name raw = Source name text (Whole (Vector.fromList (Text.split (== '\n') text)))
  where
    text = Text.replace "\r" "\n" (Text.replace "\r\n" "\n" raw)

-- | A source that knows some of its lines, by their numbers: of a file that is too large to keep, those that messages
-- show. Its text is those lines.
excerpts :: FilePath -> [(Int, Text)] -> Source
excerpts name lines' = Source name (Text.intercalate "\n" (IntMap.elems known)) (Some known)
  where
    known = IntMap.fromList lines'

-- | The line of that number, counted from 1; empty where there is none.
--
-- Spec: text.line-end.
lineAt :: Source -> Int -> Text
lineAt source n = fromMaybe Text.empty $ case sourceLines source of
  Whole all' -> all' !? (n - 1)
  Some known -> IntMap.lookup n known
