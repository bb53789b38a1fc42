{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
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
-- Lines are found first, among characters; then objects, among lines, each of which is read once. Every text has a
-- tree: the grammar has no way to fail. See "Dioptre.Syntax.Value" for what stands in a value.
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
import Dioptre.Source.Text (Source, sourceText)
import Dioptre.Source.Words (isBlank)
import Dioptre.Syntax.Keyword (Role (..), fromSpelling, role)
import Dioptre.Syntax.Spelling (isSlipOf)
import Dioptre.Syntax.Tree
import Text.Megaparsec hiding (parse)
import Text.Megaparsec.Char (char)

-- | Parsers of characters, which find lines; and of lines, which find objects.
type Parser = Parsec Void Text

type Lines = Parsec Void [Line]

-- | The tree of a text. Total; linear in its length.
--
-- Spec: tree.file, grammar.scene, grammar.text, limits.must-work.
parse :: Source -> Tree
parse source = fromRight [] (runParser file "" (fromRight [] (snd (runParser' speakingLines start))))
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
                pstateSourcePos = initialPos "",
                pstateTabWidth = pos1,
                pstateLinePrefix = ""
              },
          stateParseErrors = []
        }

-- * Objects

-- | A line that says something: its first word and the rest; or a comment that is never closed.
data Line
  = Says Head Value
  | NeverClosed Span
  deriving stock (Eq, Ord)

-- | file = *item
--
-- Spec: tree.file.
file :: Lines [Node]
file = many (openComment <|> LooseEnd <$> endLine <|> Object <$> block <|> Statement <$> property)

-- | block = opening *item closing
--
-- Spec: tree.depth.
block :: Lines Block
block = uncurry Block <$> opening <*> many item <*> closing
  where
    item = openComment <|> notFollowedBy (sceneWord <|> endLine) *> (Object <$> block <|> Statement <$> property)

-- | closing = end-line \/ a scene word ahead \/ end of file
--
-- Spec: tree.end, tree.scene-word, tree.end-of-file.
closing :: Lines Closing
closing = byEnd <$> endLine <|> BySceneWord <$> lookAhead sceneWord <|> pure ByEndOfFile
  where
    byEnd word = maybe (ByMisspeltEnd word) (const (ByEnd (headSpan word))) (headKeyword word)

-- | opening = a line whose word opens an object (what follows the word says nothing), or an unknown word alone on its
-- line
--
-- Spec: tree.opening.
opening :: Lines (Head, Value)
opening = says $ \word value -> case role <$> headKeyword word of
  Just OpensInScene -> True
  Just OpensInside -> True
  Just _ -> False
  Nothing -> Text.null (valueText value)

-- | sceneWord = a line whose word opens an object of the scene
--
-- Spec: tree.scene-word.
sceneWord :: Lines Head
sceneWord = line $ \word _ -> (role <$> headKeyword word) == Just OpensInScene

-- | endLine = a line whose word is @end@ or, alone on its line, one slip away from it
--
-- Spec: tree.end, tree.slip.words.
endLine :: Lines Head
endLine = line $ \word value -> case role <$> headKeyword word of
  Just Closes -> True
  Just _ -> False
  Nothing -> Text.null (valueText value) && any (isSlipOf (Text.toLower (headText word))) ["end", "fin"]

-- | property = any other line
--
-- Spec: tree.property.
property :: Lines Property
property = uncurry Property <$> says (const (const True))

-- | A comment that is never closed stays in the tree.
--
-- Spec: comment.unclosed.
openComment :: Lines Node
openComment = token (\case NeverClosed place -> Just (OpenComment place); Says _ _ -> Nothing) mempty

-- | A line whose word and value pass the test; its word.
line :: (Head -> Value -> Bool) -> Lines Head
line = fmap fst . says

says :: (Head -> Value -> Bool) -> Lines (Head, Value)
says test = token accept mempty
  where
    accept (Says word value) | test word value = Just (word, value)
    accept _ = Nothing

-- * Lines

-- | The lines that say something; comments and empty lines are left out.
speakingLines :: Parser [Line]
speakingLines = catMaybes <$> many (Nothing <$ emptyLine <|> comment <|> Just <$> wordAndValue)

-- | A line's first word, and its value: the rest, from the first character that is not blank.
--
-- Spec: line.word, comment.behind.
wordAndValue :: Parser Line
wordAndValue = do
  blanks
  (wordSpan, word) <- spanned (takeWhile1P Nothing (\c -> not (isBlank c) && c /= '\n'))
  blanks
  (restSpan, value) <- spanned restOfLine
  endOfLine
  pure (Says (Head wordSpan word (fromSpelling word)) (Value restSpan value))

-- | comment = line-comment \/ block-comment
comment :: Parser (Maybe Line)
comment = blockComment <|> Nothing <$ lineComment

-- | A block opens where the first word is exactly @\/*@, and closes at a line whose first word is exactly @*\/@; a
-- @*\/@ on the opening line makes it a comment of that line only.
--
-- Spec: comment.block, comment.one-line, comment.unclosed.
blockComment :: Parser (Maybe Line)
blockComment = do
  place <- mark "/*"
  rest <- restOfLine <* endOfLine
  if "*/" `Text.isInfixOf` rest then pure Nothing else unfinished place
  where
    unfinished place =
      Nothing <$ (mark "*/" *> restOfLine *> endOfLine)
        <|> Just (NeverClosed place) <$ eof
        <|> restOfLine *> endOfLine *> unfinished place
    mark word = try $ do
      blanks
      (place, _) <- spanned (chunk word)
      lookAhead (void (satisfy isBlank) <|> endOfLine)
      pure place

-- | line-comment = a line whose first word begins with one of @# \/ * - ! \@@
--
-- Spec: comment.line.
lineComment :: Parser ()
lineComment = try (blanks *> oneOf ("#/*-!@" :: String)) *> restOfLine *> endOfLine

-- | A line of blanks only.
--
-- Spec: line.empty.
emptyLine :: Parser ()
emptyLine = void (char '\n') <|> try (takeWhile1P Nothing isBlank *> endOfLine)

blanks :: Parser ()
blanks = void (takeWhileP Nothing isBlank)

restOfLine :: Parser Text
restOfLine = takeWhileP Nothing (/= '\n')

endOfLine :: Parser ()
endOfLine = void (char '\n') <|> eof

-- | What a parser of a part of one line reads, with its place.
spanned :: Parser Text -> Parser (Span, Text)
spanned p = do
  place <- getSourcePos
  text <- p
  let column = unPos (sourceColumn place)
  pure (Span (unPos (sourceLine place)) column (column + Text.length text), text)
