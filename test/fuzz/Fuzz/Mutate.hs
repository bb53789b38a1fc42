{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Fuzz.Mutate
-- Description : Inputs from other inputs
--
-- Two ways to spoil what was good. One knows nothing but bytes: bits are flipped, pieces are put in, left out, doubled
-- and exchanged with those of another file. The other one knows of lines and words: it keeps most of an input
-- meaningful, so that what is wrong is found in the deeper stages.
module Fuzz.Mutate
  ( -- * Mutating
    spoiltBytes,
    spoiltLines,

    -- * Words
    extremeNumber,
    oddText,

    -- * Sizes
    manyTimes,
    logarithmic,
  )
where

import Data.Bits (complementBit)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Test.QuickCheck

-------------------------------------------------------------------------------
-- Sizes

-- | From 1 to a number, each magnitude as likely as the others.
logarithmic :: Int -> Gen Int
logarithmic most = max 1 . min most . round . exp <$> choose (0, log (fromIntegral most :: Double))

-- | A piece many times over, up to a megabyte.
manyTimes :: ByteString -> Gen ByteString
manyTimes piece = do
  size <- logarithmic 1000000
  pure (Bytes.concat (replicate (max 1 (size `div` max 1 (Bytes.length piece))) piece))

-- | A place in a list or string of that length, its end included.
place :: Int -> Gen Int
place n = chooseInt (0, max 0 n)

-- | Where a piece begins, and how long it is.
stretch :: Int -> Gen (Int, Int)
stretch n = do
  at <- place n
  len <- logarithmic (max 1 (n - at))
  pure (at, min len (n - at))

-------------------------------------------------------------------------------
-- Bytes

-- | The bytes with one to some ten changes, of which the other input may be a part.
spoiltBytes :: ByteString -> ByteString -> Gen ByteString
spoiltBytes other bytes = do
  changes <- frequency [(6, pure 1), (3, chooseInt (2, 4)), (1, chooseInt (5, 12))]
  repeatedly changes (change other) bytes

repeatedly :: Int -> (a -> Gen a) -> a -> Gen a
repeatedly n f a = if n <= 0 then pure a else f a >>= repeatedly (n - 1) f

change :: ByteString -> ByteString -> Gen ByteString
change other bytes = do
  (at, len) <- stretch n
  let (before, from) = Bytes.splitAt at bytes
      (piece, after) = Bytes.splitAt len from
      put new = before <> new <> after
  (otherAt, otherLen) <- stretch (Bytes.length other)
  let theirs = Bytes.take otherLen (Bytes.drop otherAt other)
  frequency
    [ (6, flipped before from <$> chooseInt (0, 7)),
      (4, (\b -> before <> Bytes.cons b (Bytes.drop 1 from)) <$> elements [0, 1, 9, 10, 13, 32, 0x7f, 0x80, 0xc0, 0xff]),
      (3, (\new -> before <> new <> Bytes.drop (Bytes.length new) from) <$> wholeNumber),
      (2, (\new -> before <> Bytes.pack new <> from) <$> (logarithmic 32 >>= vector)),
      (2, pure (before <> after)),
      (2, pure before),
      (2, pure (put theirs)),
      (2, pure (put (piece <> piece))),
      (1, put <$> oddBytes),
      (1, put . Bytes.concat . (`replicate` Bytes.take 64 piece) <$> logarithmic 64)
    ]
  where
    n = Bytes.length bytes
    flipped before from bit = case Bytes.uncons from of
      Just (b, rest) -> before <> Bytes.cons (complementBit b bit) rest
      Nothing -> before

-- | A number as files of pictures have it, of two or four bytes, at some edge.
wholeNumber :: Gen ByteString
wholeNumber =
  Bytes.pack
    <$> elements
      [[0, 0], [0xff, 0xff], [0, 1], [1, 0], [0x7f, 0xff], [0xff, 0x7f], [0, 0, 0, 0], [0xff, 0xff, 0xff, 0xff], [0x7f, 0xff, 0xff, 0xff], [0, 0, 0xff, 0xff], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0x10, 0, 0], [0x80, 0, 0, 0]]

-------------------------------------------------------------------------------
-- Lines and words

-- | The lines with one to some ten changes; words may come from a dictionary, lines from the other input.
spoiltLines :: Gen ByteString -> ByteString -> ByteString -> Gen ByteString
spoiltLines dictionary other bytes = do
  changes <- frequency [(5, pure 1), (3, chooseInt (2, 4)), (1, chooseInt (5, 12))]
  changed <- repeatedly changes (changeLines dictionary (Chars.lines other)) (Chars.lines bytes)
  frequency [(20, pure (Chars.unlines changed)), (1, pure (Bytes.intercalate "\r\n" changed)), (1, pure (Bytes.intercalate "\r" changed)), (1, pure (Bytes.intercalate "\n" changed)), (1, pure ("\xEF\xBB\xBF" <> Chars.unlines changed))]

changeLines :: Gen ByteString -> [ByteString] -> [ByteString] -> Gen [ByteString]
changeLines dictionary other ls = do
  (at, len) <- stretch (length ls)
  let (before, from) = splitAt at ls
      (piece, after) = splitAt (min 40 len) from
  (otherAt, otherLen) <- stretch (length other)
  let theirs = take (min 40 otherLen) (drop otherAt other)
  frequency
    [ (12, (\l -> before <> [l] <> drop 1 from) <$> changeLine dictionary (Bytes.concat (take 1 from))),
      (3, pure (before <> drop 1 from)),
      (2, pure (before <> after)),
      (2, pure (before <> piece <> piece <> after)),
      (2, pure (before <> theirs <> from)),
      (1, pure (before <> theirs <> after)),
      (2, pure (swapped before from)),
      (2, (\word -> before <> [word] <> from) <$> dictionary),
      (1, pure before),
      (1, pure (before <> filter (`notElem` ["end", "  end", "    end", "fin"]) from)),
      (1, (\words' -> before <> words' <> from) <$> (logarithmic 300 >>= \k -> replicate k <$> dictionary)),
      (1, (\k -> before <> concat (replicate k (take 3 piece)) <> after) <$> logarithmic 100)
    ]
  where
    swapped before (a : b : rest) = before <> (b : a : rest)
    swapped before rest = before <> rest

changeLine :: Gen ByteString -> ByteString -> Gen ByteString
changeLine dictionary l = do
  at <- place (length words' - 1)
  let (before, from) = splitAt at words'
      word = Bytes.concat (take 1 from)
      put new = Chars.unwords (before <> new <> drop 1 from)
  frequency
    [ (8, put . pure . Chars.pack <$> extremeNumber),
      (3, put . pure <$> dictionary),
      (2, put . pure <$> slip word),
      (2, pure (put [])),
      (2, pure (put [word, word])),
      (1, put . pure <$> oddBytes),
      (1, (\k -> put (replicate k word)) <$> logarithmic 200),
      (1, pure (Chars.map (\c -> if c == ' ' then '\t' else c) l)),
      (1, pure (Bytes.reverse l))
    ]
  where
    words' = Chars.words l

-- | A word with a slip of the finger.
slip :: ByteString -> Gen ByteString
slip word = do
  at <- place (Bytes.length word)
  let (before, from) = Bytes.splitAt at word
  letter <- elements "aeilnrst.,0519-+eE#/*"
  elements [before <> Bytes.drop 1 from, before <> Chars.cons letter from, before <> Chars.cons letter (Bytes.drop 1 from), before <> Bytes.reverse (Bytes.take 2 from) <> Bytes.drop 2 from]

oddBytes :: Gen ByteString
oddBytes = Text.encodeUtf8 . Text.pack <$> oddText

-- | Text that programs stumble over.
oddText :: Gen String
oddText =
  frequency
    [ (6, elements ["", " ", "\t", "\0", "\f", "\v", "é", "\x2028", "\xFEFF", "\x1F600", "e\x301", "\x202E", "\xA0", "/*", "*/", "#", "\\", "\"", "..", "../x", "/dev/null", "%s%n", "\x1b[2J", "\xDF", "\x130", "none", "[[", ")", ",,,"]),
      (1, (`replicate` 'x') <$> logarithmic 5000),
      (1, (`replicate` '[') <$> logarithmic 5000),
      (1, arbitrary)
    ]

-- | Numbers at edges, and what is nearly a number.
extremeNumber :: Gen String
extremeNumber =
  frequency
    [ (10, elements ["0", "-0", "0.0", "1", "-1", "2", "0.5", "1e100", "-1e100", "1.1e100", "1e99", "1e-100", "-1e-100", "1e-10", "9e-11", "1e50", "-1e50", "1e-50", "1e25", "1e-25", "1e154", "1e-160"]),
      (4, elements ["4.9e-324", "2.2e-308", "1e-320", "-1e-320", "1e308", "1.8e308", "1e400", "1e-400", "3.4028235e38", "3.4028236e38", "1e-45", "1e38", "-1e38"]),
      (3, elements ["2147483647", "2147483648", "-2147483648", "-2147483649", "4294967296", "9223372036854775808", "16384", "65536", "1000000", "999", "1000", "200", "780", "379.999"]),
      (3, elements ["NaN", "nan", "inf", "Infinity", "-inf", "0x10", "1,5", "1.5.2", "5.", ".5", ".", "+.5", "e5", "1e", "1e+", "--1", "1d", "1f", "1_000", "٣", "1e999999999999999999999", "1e-999999999999999999999"]),
      (1, replicate <$> logarithmic 3000 <*> elements "0159"),
      (1, (\k -> "0." <> replicate k '0' <> "1") <$> logarithmic 3000),
      (3, show <$> (choose (-10, 10) :: Gen Double)),
      (2, (\m e -> show (m :: Int) <> "e" <> show (e :: Int)) <$> choose (-9, 9) <*> choose (-110, 110))
    ]
