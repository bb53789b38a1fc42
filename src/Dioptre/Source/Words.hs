{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Words
-- Description : The words of a line, and what separates them
--
-- A line is words with blanks between them. Which characters are blank differs: the scene language has three of them,
-- and AGP files follow it; OBJ and MTL files follow the C library, in which the vertical tab and the line ends are
-- blank as well.
--
-- > character           space  tab  line feed  vertical tab  form feed  carriage return
-- > code                 32     9      10           11          12           13
-- > in a scene            x     x                               x
-- > in an OBJ file        x     x       x            x          x            x
--
-- (Line ends of any kind are in no line any more where words are cut from it.)
module Dioptre.Source.Words
  ( Token (..),
    wordsOf,

    -- * Blanks
    isBlank,
    isBlankInObj,

    -- * Comments
    beginsRemark,
    goesOnWithRemark,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Span (Span (..))

-- | One word, with its place.
data Token = Token
  { tokenSpan :: Span,
    tokenText :: Text
  }
  deriving stock (Eq, Show)

-- | The words of the line of that number, between such characters. Linear.
--
-- >>> [(text, from, to) | Token (Span _ from to) text <- wordsOf isBlank 7 " 0,5  x"]
-- [("0,5",2,5),("x",7,8)]
wordsOf :: (Char -> Bool) -> Int -> Text -> [Token]
wordsOf separates line = go 1
  where
    go column t
      | Text.null word = []
      | otherwise = Token (Span line start end) word : go end after
      where
        (blanks, rest) = Text.span separates t
        (word, after) = Text.break separates rest
        start = column + Text.length blanks
        end = start + Text.length word

-- | Whether a character separates words in a scene: blank = space \/ tab \/ form feed.
--
-- Spec: text.blank.
isBlank :: Char -> Bool
isBlank c = c == ' ' || c == '\t' || c == '\f'

-- | Whether a character separates words in an OBJ or MTL file. ("Dioptre.Model.Words" has the same for bytes.)
isBlankInObj :: Char -> Bool
isBlankInObj c = c == ' ' || (c >= '\t' && c <= '\r')

-- | Whether a word looks as if a comment were to begin with it, where none can: behind a value.
--
-- >>> map beginsRemark ["#", "//", "/*", "--", "-1", "red"]
-- [True,True,True,True,False,False]
beginsRemark :: Text -> Bool
beginsRemark word = Text.take 1 word `elem` ["#", "/", "*", "!", "@"] || "--" `Text.isPrefixOf` word

-- | Whether a text is another one with a blank and what looks like a comment behind it.
--
-- >>> map (`goesOnWithRemark` "paint") ["paint # of oak", "paint", "paint #", "paint#", "painted # oak"]
-- [True,False,True,False,False]
goesOnWithRemark :: Text -> Text -> Bool
goesOnWithRemark whole begun = case Text.stripPrefix begun whole of
  Just behind -> Text.any isBlank (Text.take 1 behind) && beginsRemark (Text.dropWhile isBlank behind)
  Nothing -> False
