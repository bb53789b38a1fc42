{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Example
-- Description : The examples of the specification
--
-- A chapter of the specification is CommonMark. A rule is a paragraph that begins with its label; the examples that
-- follow it are cases:
--
-- > **`roots.quadratic.order`** The roots are in ascending order.
-- >
-- > ```example roots.quadratic.order-1 roots.quadratic ulp:4
-- > {"a":1,"b":-3,"c":2}
-- > ---
-- > [1,2]
-- > ```
--
-- The first line of a block names the example, the operation, and perhaps a comparison; the body is what is sent and
-- what is expected. For an operation on a text the first line of the body is what is sent without the text, and the
-- lines after it are the text. A block @shown@ in place of @example@ is for what no operation shows.
module Dioptre.Conformance.Example
  ( -- * Rules
    Rule (..),
    chapter,

    -- * Faults
    ChapterFault (..),
    faultsOf,
  )
where

import Data.Aeson (Object, Value (..), eitherDecodeStrict)
import qualified Data.Aeson.KeyMap as Keys
import Data.Bifunctor (first)
import Data.Char (isAsciiLower, isDigit)
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Conformance.Compare (Comparison (Exact), comparisonNamed)
import Dioptre.Conformance.Oracle (profiles)
import Dioptre.Conformance.Verdict (Case (..))

-- | A rule of the specification.
data Rule = Rule
  { -- | Its label.
    ruleLabel :: Text,
    -- | The chapter's file.
    ruleFile :: FilePath,
    -- | The line on which it begins.
    ruleLine :: Int,
    -- | Its examples.
    ruleExamples :: [Case],
    -- | How many blocks say how else it is shown.
    ruleShown :: Int
  }
  deriving stock (Eq, Show)

-- | What is wrong with a chapter, and where.
data ChapterFault = ChapterFault
  { -- | The chapter's file.
    chapterFaultFile :: FilePath,
    -- | The line, from 1.
    chapterFaultLine :: Int,
    -- | What is wrong there.
    chapterFaultText :: Text
  }
  deriving stock (Eq, Show)

-- | The rules of a chapter, given the name of its file, and what is wrong with its form.
--
-- Spec: rule.form, rule.examples.
chapter :: FilePath -> Text -> ([Rule], [ChapterFault])
chapter file text = (reverse rules, reverse faults)
  where
    (rules, faults) = foldl' step ([], []) (pieces (zip [1 ..] (Text.lines text)))
    step (rs, fs) piece = case piece of
      Label n label
        | isLabel label -> (Rule label file n [] 0 : rs, fs)
        | otherwise -> (rs, ChapterFault file n ("'" <> label <> "' is not a label") : fs)
      Fence n info body
        | Just kind <- listToMaybe (Text.words info),
          kind `elem` ["example", "shown"] -> case rs of
          [] -> (rs, ChapterFault file n "no rule stands before this block" : fs)
          r : others -> either (\why -> (rs, ChapterFault file n why : fs)) (\r' -> (r' : others, fs)) (block file n (Text.words info) body r)
        | otherwise -> (rs, fs)
      Unclosed n -> (rs, ChapterFault file n "this block is never closed" : fs)

-- | What matters of a chapter, with the lines where it begins.
data Piece
  = -- | The label of a rule.
    Label Int Text
  | -- | A fenced block: its first line, without the fence, and the lines in it.
    Fence Int Text [Text]
  | Unclosed Int

pieces :: [(Int, Text)] -> [Piece]
pieces numbered = case numbered of
  [] -> []
  (n, line) : rest
    | Text.length fence >= 3 -> case break (closes fence . snd) rest of
      (_, []) -> [Unclosed n]
      (body, _ : after) -> Fence n (Text.drop (Text.length fence) line) (map snd body) : pieces after
    | Just (label, _) <- Text.breakOn "`**" <$> Text.stripPrefix "**`" line -> Label n label : pieces rest
    | otherwise -> pieces rest
    where
      fence = Text.takeWhile (== '`') line
  where
    closes fence line = Text.length (Text.takeWhile (== '`') line) >= Text.length fence && Text.all (`elem` ("` " :: String)) line

-- | Words of lower-case letters, digits and hyphens, two or more, joined by dots.
isLabel :: Text -> Bool
isLabel label = length parts > 1 && all word parts
  where
    parts = Text.splitOn "." label
    word w = not (Text.null w) && Text.all (\c -> isAsciiLower c || isDigit c || c == '-') w

-- | A rule with one more block.
block :: FilePath -> Int -> [Text] -> [Text] -> Rule -> Either Text Rule
block file n info body rule = case info of
  ["shown", name] -> do
    named name
    if all (Text.null . Text.strip) body then Left "this block is empty" else Right rule {ruleShown = ruleShown rule + 1}
  "example" : name : operation : how | length how <= 1 -> do
    named name
    profile <- maybe (Left ("there is no operation " <> operation)) Right (Map.lookup operation profileOf)
    compared <- traverse comparisonNamed how
    (input, expected) <- parts operation
    let example =
          Case
            { caseName = name,
              caseProfile = profile,
              caseOperation = operation,
              caseRules = [ruleLabel rule],
              caseComment = Text.pack file <> ":" <> Text.pack (show n),
              caseFlags = [],
              caseInput = Object input,
              caseExpected = expected,
              caseComparison = fromMaybe Exact (listToMaybe compared)
            }
    Right rule {ruleExamples = ruleExamples rule <> [example]}
  _ -> Left "a block begins with 'example ID OPERATION', perhaps a comparison, or with 'shown ID'"
  where
    number = length (ruleExamples rule) + ruleShown rule + 1
    named name
      | name == ruleLabel rule <> "-" <> Text.pack (show number) = Right ()
      | otherwise = Left ("this block should be called " <> ruleLabel rule <> "-" <> Text.pack (show number) <> ", not " <> name)
    -- The last line of three hyphens divides, since there may be others in a text, where they are comments.
    parts operation = case break (== "---") (reverse body) of
      (after, _ : before) -> (,) <$> inputOf operation (reverse before) <*> json (Text.unlines (reverse after))
      _ -> Left "there is no line --- in this block"
    inputOf operation before
      | operation `elem` takesText = case before of
        firstLine : text -> Keys.insert "text" (String (Text.unlines text)) <$> jsonObject firstLine
        [] -> Left "there is nothing to send"
      | otherwise = jsonObject (Text.unlines before)
    json = first (\why -> "this is not JSON: " <> Text.pack why) . eitherDecodeStrict . Text.encodeUtf8
    jsonObject :: Text -> Either Text Object
    jsonObject = first (\why -> "this is not a JSON object: " <> Text.pack why) . eitherDecodeStrict . Text.encodeUtf8

-- | The profile of each operation.
profileOf :: Map.Map Text Text
profileOf = Map.fromList [(operation, profile) | (profile, operations) <- profiles, (operation, _) <- operations]

-- | The operations whose input has a text.
--
-- Spec: rule.examples.
takesText :: [Text]
takesText = ["scene.check", "camera.ray", "scene.pixel", "scene.picture"]

-- | What is wrong with rules taken together: a rule without any example, a label that is used twice.
--
-- Spec: rule.form.
faultsOf :: [Rule] -> [ChapterFault]
faultsOf rules =
  [ChapterFault (ruleFile r) (ruleLine r) (ruleLabel r <> " has no example") | r <- rules, null (ruleExamples r), ruleShown r == 0]
    <> [ChapterFault (ruleFile r) (ruleLine r) ("there is another rule called " <> ruleLabel r) | r <- rules, Map.lookup (ruleLabel r) uses /= Just (1 :: Int)]
  where
    uses = Map.fromListWith (+) [(ruleLabel r, 1) | r <- rules]
