{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Obj.Lines
-- Description : From the pieces of a file to its lines
--
-- A file comes in pieces, which may end anywhere; what counts is its lines, each with the number of the line that it
-- begins in.
--
-- > "v 1 2 3\r"  "\nf 1 2 \\\n3 4\nus"  "emtl gold"         the pieces
-- >
-- > 1  "v 1 2 3"                                             the lines
-- > 2  "f 1 2  3 4"        the second part begins at byte 7
-- > 4  "usemtl gold"
--
-- A line ends at LF, CR or CR LF. One whose last character is a backslash goes on in the next line, as one with a blank
-- in the place of the backslash: words do not go on. Comments do not either, as they may well end with the name of a
-- folder. A byte order mark before the first line is passed over.
--
-- A line that a piece has whole is a part of that piece, and no byte of it is copied. What is kept of the others is
-- bounded, by 'longestLine' and 'mostLines'.
module Dioptre.Model.Obj.Lines
  ( Line (..),

    -- * Cutting
    Lines,
    newLines,
    feedLines,
    endLines,

    -- * Limits
    longestLine,
    mostLines,
  )
where

import Control.Monad (unless, when)
import Control.Monad.ST (ST)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.ByteString.Unsafe (unsafeDrop, unsafeTake)
import Data.Maybe (fromMaybe)
import Data.STRef (STRef, modifySTRef', newSTRef, readSTRef, writeSTRef)
import Data.Word (Word8)
import Dioptre.Model.Growing (Counter, current, newCounter, put)
import Dioptre.Model.Words (backslash, byteAt, hash, isBlank)
import Dioptre.Source.Text (byteOrderMark)

-- | A line: its bytes without the end, the number of its first line, and where in it the further lines begin, if it has
-- any.
data Line = Line !ByteString !Int [Int]

-- | A file of which a part has been cut.
data Lines s = Lines
  { -- | What is kept of the line that is not at its end.
    linesPending :: !(STRef s Pending),
    -- | The number of the line that the next byte is in.
    linesNumber :: !(Counter s),
    -- | 1 where the byte before was a CR: then LF is the same line's end.
    linesAfterReturn :: !(Counter s)
  }

-- | What is kept of a line whose end is not there yet: its parts, the last one first, and how many bytes they have; how
-- many bytes went before each line that it goes on in (by a backslash), the last one first; the number of its first
-- line.
data Pending
  = NoLine
  | Pending [ByteString] !Int [Int] !Int
  | -- | It is longer than 'longestLine', and not kept; the number of its first line.
    Overlong !Int

-- | No line has more bytes: 2^25, which is a face of some two million corners. Longer ones are passed over, so that a
-- file that is one endless line is not kept.
--
-- Spec: limits.files.
longestLine :: Int
longestLine = 33554432

-- | No line goes on in more others: 2^20.
mostLines :: Int
mostLines = 1048576

-- | A file that has not begun.
newLines :: ST s (Lines s)
newLines = Lines <$> newSTRef NoLine <*> newCounter 1 <*> newCounter 0

-- | Goes through a piece, with what is to be done with each line that ends in it, and with the number of each that is
-- too long. Law: how a file is cut into pieces changes nothing.
--
-- Spec: models.obj.lines.
feedLines :: (Line -> ST s ()) -> (Int -> ST s ()) -> Lines s -> ByteString -> ST s ()
feedLines each overlong ls piece
  | Bytes.null piece = pure ()
  | otherwise = do
    afterReturn <- current (linesAfterReturn ls)
    number <- current (linesNumber ls)
    put (linesAfterReturn ls) 0
    let bytes = if afterReturn == 1 && byteAt piece 0 == newline then Bytes.drop 1 piece else piece
        n = Bytes.length bytes
        -- The next LF and the next CR, from this place on; the length where there is none. Each byte is looked at once
        -- for either.
        next c from = maybe n (from +) (Bytes.elemIndex c (unsafeDrop from bytes))
        -- 0 <= from <= n, and neither of the two is before it.
        go !from !lf !cr !line
          | end == n = do
            put (linesNumber ls) line
            unless (from == n) $ keep ls (Bytes.copy (unsafeDrop from bytes)) line
          | otherwise = do
            ended each overlong ls (unsafeTake (end - from) (unsafeDrop from bytes)) line
            if end == lf
              then go (lf + 1) (next newline (lf + 1)) cr (line + 1)
              else do
                when (cr + 1 == n) $ put (linesAfterReturn ls) 1
                if cr + 1 == lf && lf < n
                  then go (lf + 1) (next newline (lf + 1)) (next carriageReturn (lf + 1)) (line + 1)
                  else go (cr + 1) lf (next carriageReturn (cr + 1)) (line + 1)
          where
            end = min lf cr
    go 0 (next newline 0) (next carriageReturn 0) number

-- | Does the same with the line that the end of the file ends.
endLines :: (Line -> ST s ()) -> (Int -> ST s ()) -> Lines s -> ST s ()
endLines each overlong ls = do
  number <- current (linesNumber ls)
  ended each overlong ls Bytes.empty number
  -- For a backslash at the very end, after which there is one more line, without anything.
  ended each overlong ls Bytes.empty (number + 1)

-- | Keeps the last part of what is there of a line, with the number of the line.
keep :: Lines s -> ByteString -> Int -> ST s ()
keep ls part number = modifySTRef' (linesPending ls) $ \case
  NoLine -> kept [part] (Bytes.length part) [] number
  Pending parts total breaks first -> kept (part : parts) (total + Bytes.length part) breaks first
  Overlong first -> Overlong first
  where
    kept parts total breaks first
      | total > longestLine = Overlong first
      | otherwise = Pending (gathered parts) total breaks first

-- | The same parts in fewer: each is at most half as long as the one before it, so that they are few, and a byte is
-- copied as often as there are parts.
gathered :: [ByteString] -> [ByteString]
gathered (b : a : rest) | 2 * Bytes.length b > Bytes.length a = gathered (a <> b : rest)
gathered parts = parts

-- | The last part of a line whose end has come, with the number of the line.
ended :: (Line -> ST s ()) -> (Int -> ST s ()) -> Lines s -> ByteString -> Int -> ST s ()
ended each overlong ls part number = do
  pending <- readSTRef (linesPending ls)
  case pending of
    NoLine
      | goesOn part && not (isComment [part]) -> goOn [Bytes.copy part] (Bytes.length part) [] number
      | otherwise -> whole part number []
    Pending parts total breaks first
      -- Whether it is a comment is looked up on its first line only.
      | goesOn (latest parts') && not (null breaks && isComment (reverse parts')) -> goOn parts' total' breaks first
      | otherwise -> writeSTRef (linesPending ls) NoLine >> whole (Bytes.concat (reverse parts')) first (reverse breaks)
      where
        parts' = if Bytes.null part then parts else Bytes.copy part : parts
        total' = total + Bytes.length part
    Overlong first -> writeSTRef (linesPending ls) NoLine >> overlong first
  where
    latest = mconcat . take 1
    goesOn b = (snd <$> Bytes.unsnoc b) == Just backslash
    isComment = (== Just hash) . fmap fst . Bytes.uncons . Bytes.dropWhile isBlank . withoutMark . Bytes.concat
    withoutMark b = fromMaybe b (Bytes.stripPrefix byteOrderMark b)
    goOn parts total breaks first
      | total > longestLine || number - first >= mostLines = writeSTRef (linesPending ls) NoLine >> overlong first
      | otherwise = writeSTRef (linesPending ls) (Pending (gathered (Bytes.snoc (Bytes.take (Bytes.length (latest parts) - 1) (latest parts)) blank : drop 1 parts)) total (total : breaks) first)
    whole bytes first breaks
      | Bytes.length bytes > longestLine = overlong first
      | first == 1, Just rest <- Bytes.stripPrefix byteOrderMark bytes = each (Line rest first (map (subtract (Bytes.length byteOrderMark)) breaks))
      | otherwise = each (Line bytes first breaks)

newline, carriageReturn, blank :: Word8
newline = 10
carriageReturn = 13
blank = 32
