{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Usage
-- Description : What is wrong with some arguments, in words
--
-- The option parser knows that arguments are wrong, and often says so of the wrong one, in English, without a proposal:
-- of @chek a.txt@ that @a.txt@ is invalid, and of an option that is given twice the same. Its first line tells which
-- argument it stopped at; here that is read together with the arguments, and said anew. What is not known here stays as
-- it is. Options before a command are put behind it beforehand, where the option parser takes them.
module Usage
  ( Known (..),
    Spelling (..),
    optionsOf,
    commandFirst,
    inWords,
  )
where

import Control.Applicative ((<|>))
import Data.List (isPrefixOf, stripPrefix)
import Data.Maybe (fromMaybe, listToMaybe, mapMaybe)
import qualified Data.Text as Text
import Dioptre.Source.Language (Language (..), inLanguage)
import Dioptre.Syntax.Spelling (suggest)
import Dioptre.Syntax.Value (real)
import Options.Applicative.Common (mapParser)
import Options.Applicative.Types (OptName (..), OptReader (..), Option (..), Parser)

-- | What can be written: the commands, each with its options, and the options without a command.
data Known = Known
  { knownCommands :: [(String, [Spelling])],
    knownOptions :: [Spelling]
  }

-- | How an option is written: all its names, and whether a value follows.
data Spelling = Spelling
  { spellingNames :: [String],
    spellingTakesValue :: Bool
  }

-- | The options of a parser.
optionsOf :: Parser a -> [Spelling]
optionsOf parser = concat (mapParser (const (spellings . optMain)) parser)

spellings :: OptReader a -> [Spelling]
spellings reader = case reader of
  OptReader these _ _ -> [Spelling (map spelt these) True]
  FlagReader these _ -> [Spelling (map spelt these) False]
  _ -> []
  where
    spelt (OptShort c) = ['-', c]
    spelt (OptLong word) = "--" <> word

-- | The arguments with the command first, where options stand before it: of @--language fr check a.txt@,
-- @check --language fr a.txt@. The option parser takes a command's options behind it alone. Other arguments stay as
-- they are.
commandFirst :: Known -> [String] -> [String]
commandFirst known arguments = case leading arguments of
  (those, word : others) | word `elem` map fst (knownCommands known) -> word : those <> others
  _ -> arguments
  where
    leading given = case listToMaybe (foldMap (\option -> mapMaybe (width option) options) (take 1 given)) of
      Just n -> let (more, rest) = leading (drop n given) in (take n given <> more, rest)
      Nothing -> ([], given)
    options = knownOptions known <> foldMap snd (knownCommands known)
    -- How many arguments an option takes up, if it is this one: --width 5, --width=5, -o p.png, -op.png.
    width option (Spelling these takesValue)
      | option `elem` these = Just (if takesValue then 2 else 1)
      | takesValue && any ((`isPrefixOf` option) . before) these = Just 1
      | otherwise = Nothing
    before name = if "--" `isPrefixOf` name then name <> "=" else name

-- | What the option parser prints, in a language; given the arguments, of which it is the help or what is wrong with
-- them.
inWords :: Language -> Known -> [String] -> String -> String
inWords l known arguments text = case lines text of
  first : rest | Just ours <- complaint l known arguments first -> unlines (ours : "" : titled l (dropWhile (not . isPrefixOf "Usage:") rest))
  all' -> unlines (titled l all')

-- | The option parser's own titles; the second line of how it is used stands as far to the right as the first.
titled :: Language -> [String] -> [String]
titled English = id
titled French = \case
  line : more
    | Just used <- stripPrefix "Usage:" line, (further, others) <- span ("    " `isPrefixOf`) more -> ("Usage\xA0:" <> used) : map (' ' :) further <> titled French others
    | otherwise -> fromMaybe line (lookup line [("Available options:", "Options\xA0:"), ("Available commands:", "Commandes\xA0:")]) : titled French more
  [] -> []

-- | What is wrong, said anew, given the option parser's own line.
complaint :: Language -> Known -> [String] -> String -> Maybe String
complaint l known arguments line =
  (badOption <$> quoted "Invalid option `")
    <|> (badArgument <$> quoted "Invalid argument `")
    <|> ((<> say " needs a value" " demande une valeur") <$> quoted "The option `")
    <|> ((say "missing: " "il manque\xA0: " <>) <$> stripPrefix "Missing: " line)
    <|> (badValue . break (== ':') <$> stripPrefix "option " line)
  where
    say = inLanguage l
    quoted start = takeWhile (`notElem` "'`") <$> stripPrefix start line
    word = case arguments of
      first : _ | not ("-" `isPrefixOf` first) -> Just first
      _ -> Nothing
    command = (\w -> (,) w <$> lookup w (knownCommands known)) =<< word
    options = map spellingNames (maybe (knownOptions known) snd command)

    badValue (name, wanted) = name <> say "" "\xA0" <> wanted

    badOption whole
      | Just all' <- named, length (filter (\a -> isOption a && takeWhile (/= '=') a `elem` all') arguments) > 1 = unwordsOr all' <> say " is given twice" " est donnée deux fois"
      | Just all' <- named, length name < length whole = unwordsOr all' <> say " takes no value" " ne prend pas de valeur"
      | Right _ <- real (Text.pack whole) = whole <> say ": no number can be less than 0 here" "\xA0: aucun nombre ne peut être inférieur à 0 ici"
      | otherwise = maybe (say "there is no option " "il n'y a pas d'option ") ((<> say " has no option " " n'a pas d'option ") . fst) command <> name <> proposal "--" long (dropWhile (== '-') name)
      where
        name = takeWhile (/= '=') whole
        long = [rest | n <- "--help" : concat options, Just rest <- [stripPrefix "--" n]]
        named = lookup name [(n, all') | all' <- options, n <- all']
        isOption a = "-" `isPrefixOf` a
        -- The longest name comes last: --output (-o).
        unwordsOr all' = unwords (take 1 long' <> map (\other -> "(" <> other <> ")") (drop 1 long'))
          where
            long' = reverse all'

    badArgument argument = case (word, command) of
      (Just w, Nothing)
        | w /= argument && all (`notElem` w) "./" -> say "there is no command " "il n'y a pas de commande " <> w <> proposal "" (map fst (knownCommands known)) w
      _ -> say "one argument too many: " "un argument de trop\xA0: " <> argument

    proposal dashes candidates wrong = case suggest (map Text.pack candidates) (Text.pack wrong) of
      Just near -> say "; did you mean " "\xA0; vouliez-vous dire " <> dashes <> Text.unpack near <> say "?" "\xA0?"
      Nothing -> ""
