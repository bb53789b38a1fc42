{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Syntax.Grammar
-- Description : The grammar of scene and configuration files
--
-- A line holds one statement, and its first word says what it is. One function per rule, in the order of the rules:
--
-- > file         = *item
-- > item         = comment / block / property / stray-end
-- > block        = opening *item closing
-- > closing      = end-line / scene word ahead / end of file
-- > opening      = line whose word opens an object, or an unknown word alone on its line
-- > property     = word 1*blank value          ; any other line
-- > comment      = line-comment / block-comment
-- > line-comment = a line whose first word begins with # / * - ! or @
-- > block-comment= line whose first word is exactly "/*" ... line whose first word is exactly "*/"
-- > blank        = space / tab / form feed
--
-- Every text has a tree: the grammar has no way to fail. See "Dioptre.Syntax.Value" for what stands in a value.
module Dioptre.Syntax.Grammar
  ( parse,
  )
where

import Control.Monad (void)
import Data.Either (fromRight)
import Data.Maybe (catMaybes)
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Void (Void)
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, sourceName, sourceText)
import Dioptre.Syntax.Keyword (Role (..), fromSpelling, role)
import Dioptre.Syntax.Spelling (isSlipOf)
import Dioptre.Syntax.Tree
import Text.Megaparsec hiding (parse, sourceName)
import Text.Megaparsec.Char (char)

type Parser = Parsec Void Text

-- | The tree of a text. Total; linear in its length.
parse :: Source -> Tree
parse source = fromRight [] (snd (runParser' file start))
  where
    -- A tab is one column wide, like every other character.
    start =
      State
        { stateInput = sourceText source,
          stateOffset = 0,
          statePosState =
            PosState
              { pstateInput = sourceText source,
                pstateOffset = 0,
                pstateSourcePos = initialPos (sourceName source),
                pstateTabWidth = pos1,
                pstateLinePrefix = ""
              },
          stateParseErrors = []
        }

-- | file = *item
file :: Parser Tree
file = items (LooseEnd <$> endLine <|> Object <$> block <|> Statement <$> property)

-- | The items of a file or of an object, comments and empty lines left out.
items :: Parser Node -> Parser [Node]
items item = catMaybes <$> many (Nothing <$ emptyLine <|> comment <|> Just <$> item)

-- | block = opening *item closing
block :: Parser Block
block = do
  opened <- opening
  nodes <- items (notFollowedBy (void sceneWord <|> void endLine) *> (Object <$> block <|> Statement <$> property))
  Block opened nodes <$> closing

-- | closing = end-line \/ a scene word ahead \/ end of file
closing :: Parser Closing
closing = byEnd <$> endLine <|> BySceneWord <$> lookAhead sceneWord <|> ByEndOfFile <$ eof
  where
    byEnd word = case headKeyword word of
      Just _ -> ByEnd (headSpan word)
      Nothing -> ByMisspeltEnd word

-- | opening = a line whose word opens an object (what follows the word is ignored), or an unknown word alone on its line
opening :: Parser Head
opening = line $ \word value -> case role <$> headKeyword word of
  Just OpensInScene -> True
  Just OpensInside -> True
  Just _ -> False
  Nothing -> Text.null (valueText value)

-- | sceneWord = a line whose word opens an object of the scene
sceneWord :: Parser Head
sceneWord = line $ \word _ -> (role <$> headKeyword word) == Just OpensInScene

-- | endLine = a line whose word is @end@ or, alone on its line, one slip away from it
endLine :: Parser Head
endLine = line $ \word value -> case role <$> headKeyword word of
  Just Closes -> True
  Just _ -> False
  Nothing -> Text.null (valueText value) && any (isSlipOf (Text.toLower (headText word))) ["end", "fin"]

-- | property = any other line
property :: Parser Property
property = uncurry Property <$> wordAndValue

-- | A whole line of which the word and the value pass the test; its word.
line :: (Head -> Value -> Bool) -> Parser Head
line test = try $ do
  (word, value) <- wordAndValue
  if test word value then pure word else empty

-- | A line's first word, and its value: the rest, from the first character that is not blank.
wordAndValue :: Parser (Head, Value)
wordAndValue = do
  blanks
  (wordSpan, word) <- spanned (takeWhile1P Nothing (\c -> not (isBlank c) && c /= '\n'))
  blanks
  (valueSpan', value) <- spanned restOfLine
  endOfLine
  pure (Head wordSpan word (fromSpelling word), Value valueSpan' value)

-- | comment = line-comment \/ block-comment. A block that is never closed stays in the tree.
comment :: Parser (Maybe Node)
comment = blockComment <|> Nothing <$ lineComment

-- | A block opens where the first word is exactly @\/*@, and closes at a line whose first word is exactly @*\/@; a @*\/@ on the
-- opening line makes it a comment of that line only.
blockComment :: Parser (Maybe Node)
blockComment = do
  place <- mark "/*"
  rest <- restOfLine <* endOfLine
  if "*/" `Text.isInfixOf` rest then pure Nothing else unfinished place
  where
    unfinished place =
      Nothing <$ (mark "*/" *> restOfLine *> endOfLine)
        <|> Just (OpenComment place) <$ eof
        <|> restOfLine *> endOfLine *> unfinished place
    mark word = try $ do
      blanks
      (place, _) <- spanned (chunk word)
      lookAhead (void (satisfy isBlank) <|> endOfLine)
      pure place

-- | line-comment = a line whose first word begins with one of @# \/ * - ! \@@
lineComment :: Parser ()
lineComment = try (blanks *> oneOf ("#/*-!@" :: String)) *> restOfLine *> endOfLine

-- | A line of blanks only.
emptyLine :: Parser ()
emptyLine = void (char '\n') <|> try (takeWhile1P Nothing isBlank *> endOfLine)

blanks :: Parser ()
blanks = void (takeWhileP Nothing isBlank)

restOfLine :: Parser Text
restOfLine = takeWhileP Nothing (/= '\n')

endOfLine :: Parser ()
endOfLine = void (char '\n') <|> eof

-- | blank = space \/ tab \/ form feed. (Line ends are line feeds by now.)
isBlank :: Char -> Bool
isBlank c = c == ' ' || c == '\t' || c == '\f'

-- | What a parser of a part of one line reads, with its place.
spanned :: Parser Text -> Parser (Span, Text)
spanned p = do
  place <- getSourcePos
  text <- p
  let column = unPos (sourceColumn place)
  pure (Span (unPos (sourceLine place)) column (column + Text.length text), text)
