{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Files.Counter
-- Description : The counter of pictures in a configuration
--
-- After a picture the configuration has to say the next number. The file is the user's: it has their comments, their
-- alignment, the encoding and the line ends of their editor. Reading it and printing it again would lose all of that,
-- so the one value is replaced among the bytes, and every other byte stays.
--
-- > # mes images ↵                  # mes images ↵
-- > viewport_image_count   7   ↵    viewport_image_count   8   ↵
--
-- To find the value takes only the lexical rules: lines, first words, comments. The bytes that they are made of mean
-- the same in UTF-8 and in Latin-1, so the encoding need not be known.
--
-- * A line ends with CR LF, LF or CR. Blanks are space, tab and form feed.
-- * The first word, in any case, is the keyword; what stands before the next blank, comma or bracket is its value.
-- * A first word @\/*@ opens a comment, unless @*\/@ follows on its line; only a line whose first word is @*\/@
--   closes it. (Lines that begin with another sign of a comment need no care: their first word is not the keyword.)
-- * A byte-order mark is not part of the first line.
--
-- Of several such lines the last one counts, for it is what the reader is left with.
module Dioptre.Files.Counter
  ( replaceCounter,
  )
where

import Data.Bits (setBit)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import Data.List (foldl')
import Data.Word (Word8)
import Dioptre.Files.Number (PictureNumber, pictureNumberValue)

-- | The configuration with this number as its counter.
--
-- The value of the last @viewport_image_count@ that is not in a comment is replaced, whatever it was; where it has
-- none, the number is put in its place, before a remark that may follow. Where there is no such line, one is added at
-- the end, with the line end that the file uses; where a comment that is never closed would swallow it there, it goes
-- in front of that comment.
--
-- Laws: reading the counter back gives the number; of two replacements the last one stands; nothing but the value
-- changes, byte for byte.
--
-- >>> replaceCounter minBound "viewport_image_count 41 # next\r\n"
-- "viewport_image_count 0 # next\r\n"
--
-- Cost: linear in the size of the file.
--
-- Spec: config.counter.
replaceCounter :: PictureNumber -> ByteString -> ByteString
replaceCounter number source = case lastCounter scanned of
  Just line -> setValue digits line source
  Nothing -> addLine (keyword <> "\t" <> digits) scanned source
  where
    scanned = scan source
    digits = Char8.pack (show (pictureNumberValue number))

keyword :: ByteString
keyword = "viewport_image_count"

-- Lines

-- | A line, where it begins in the file, and the bytes that end it: none on an unfinished last line.
data Line = Line
  { lineStart :: !Int,
    lineText :: !ByteString,
    lineEnd :: !ByteString
  }

-- | The lines of what follows this many bytes of the file. Law: together they are all of it.
linesFrom :: Int -> ByteString -> [Line]
linesFrom start bytes
  | Bytes.null bytes = []
  | otherwise = Line start text end : linesFrom (start + Bytes.length text + Bytes.length end) rest
  where
    (text, following) = Bytes.break isLineEnd bytes
    (end, rest) = Bytes.splitAt (if "\r\n" `Bytes.isPrefixOf` following then 2 else 1) following

-- | What is left of a line from its first word on, and that word.
firstWord :: Line -> (ByteString, ByteString)
firstWord line = (text, Bytes.takeWhile (not . isBlank) text)
  where
    text = Bytes.dropWhile isBlank (lineText line)

isLineEnd, isBlank, isSeparator :: Word8 -> Bool
isLineEnd byte = byte == 0x0A || byte == 0x0D
isBlank byte = byte `Bytes.elem` " \t\r\n\f"
isSeparator byte = byte `Bytes.elem` " \t\r\n\f,()[]<>"

-- Scanning

-- | What one pass over the file finds.
data Scan = Scan
  { -- | The last line that sets the counter.
    lastCounter :: !(Maybe Line),
    -- | Where the comment begins that is open here.
    openComment :: !(Maybe Int),
    -- | How lines end; the last one decides.
    usualEnd :: !ByteString,
    -- | Whether the last line has its end; a file without lines lacks nothing.
    finished :: !Bool
  }

scan :: ByteString -> Scan
scan source = foldl' step (Scan Nothing Nothing "\n" True) (linesFrom mark (Bytes.drop mark source))
  where
    mark = if "\xEF\xBB\xBF" `Bytes.isPrefixOf` source then 3 else 0

step :: Scan -> Line -> Scan
step before line = case openComment before of
  Just _
    | word == "*/" -> here {openComment = Nothing}
    | otherwise -> here
  Nothing
    | word == "/*" && not ("*/" `Bytes.isInfixOf` Bytes.drop 2 text) -> here {openComment = Just (lineStart line)}
    | isKeyword word -> here {lastCounter = Just line}
    | otherwise -> here
  where
    (text, word) = firstWord line
    here =
      before
        { usualEnd = if unfinished then usualEnd before else lineEnd line,
          finished = not unfinished
        }
    unfinished = Bytes.null (lineEnd line)

-- | Whether a word is the keyword, in any case.
isKeyword :: ByteString -> Bool
isKeyword word = Bytes.length word == Bytes.length keyword && Bytes.map lower word == keyword
  where
    lower byte
      | 0x41 <= byte && byte <= 0x5A = setBit byte 5
      | otherwise = byte

-- Editing

-- | Gives the counter on this line of the file these digits.
setValue :: ByteString -> Line -> ByteString -> ByteString
setValue digits line
  | isMissing = replaceAt start 0 (before <> digits <> after)
  | otherwise = replaceAt start (Bytes.length value) digits
  where
    (text, word) = firstWord line
    (gap, rest) = Bytes.span isSeparator (Bytes.drop (Bytes.length word) text)
    value = Bytes.takeWhile (not . isSeparator) rest
    start = lineStart line + Bytes.length (lineText line) - Bytes.length rest
    isMissing = maybe True (startsRemark . fst) (Bytes.uncons value)
    before = if Bytes.null gap then "\t" else ""
    after = if Bytes.null value then "" else " "

-- | Whether what begins so is a remark after the value rather than a wrong value. (@-@ is the sign of a number.)
startsRemark :: Word8 -> Bool
startsRemark byte = byte `Bytes.elem` "#/*!@"

-- | Adds a line at the end, or in front of a comment that never ends.
addLine :: ByteString -> Scan -> ByteString -> ByteString
addLine line scanned source = case openComment scanned of
  Just start -> replaceAt start 0 (line <> end) source
  Nothing -> source <> (if finished scanned then "" else end) <> line <> end
  where
    end = usualEnd scanned

-- | @replaceAt start count new bytes@ has @new@ in the place of the @count@ bytes from @start@ on.
replaceAt :: Int -> Int -> ByteString -> ByteString -> ByteString
replaceAt start count new bytes = Bytes.concat [kept, new, Bytes.drop count replaced]
  where
    (kept, replaced) = Bytes.splitAt start bytes
