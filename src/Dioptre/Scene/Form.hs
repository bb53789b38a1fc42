{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Form
-- Description : The forms of values, read and written
--
-- What a property can be given: real numbers in a range, vectors, colours, words. A form knows how to read a value from
-- its text, why it refuses one, what it wants instead, and how to write one, so that whatever is written can be read.
--
-- Law: reading what a form wrote gives the same value.
module Dioptre.Scene.Form
  ( Form (..),

    -- * Numbers
    realWithin,
    realFrom,
    realThatIsAny,
    positive,
    count,
    integerWithin,

    -- * Vectors and colours
    vectorForm,
    directionForm,
    scaleForm,
    textureForm,
    colourForm,

    -- * Words
    choice,
    booleanForm,
    text,
    fileName,
    outputName,
    outputNameEnding,

    -- * Slips
    decimalsBehindComma,

    -- * Variations
    withUnit,
    optionally,
  )
where

import Data.Char (isControl, isDigit)
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Light.Colour (Colour (..), named, names)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Vector (Vector, modulus)
import Dioptre.Source.Diagnostic (Expectation (..), Guess (..), Range (..), Refusal (..))
import Dioptre.Source.Phrase (number, showReal, vectorText)
import Dioptre.Source.Span (Span)
import Dioptre.Source.Words (beginsRemark)
import Dioptre.Syntax.Keyword (fromSpelling)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Spelling (suggest)
import Dioptre.Syntax.Tree (Value (..))
import Dioptre.Syntax.Value (Token (..), integer, largestInteger, real, tokens)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | How values of a type are read, expected and written. A refusal carries the place that it is about.
data Form v = Form
  { formExpectation :: Expectation,
    formRead :: Value -> Either (Span, Refusal) v,
    -- | 'Nothing' for a value that is none, of which there is nothing to write.
    formShow :: v -> Maybe Text
  }

-- | A form of one token; what follows the token is ignored.
--
-- Spec: check.place, code.missing-value.
scalar :: Expectation -> (Text -> Either Refusal v) -> (v -> Text) -> Form v
scalar expectation reads' shows' = Form expectation (first reads') (Just . shows')

-- | What the first token of a value says.
first :: (Text -> Either Refusal v) -> Value -> Either (Span, Refusal) v
first reads' value = case tokens value of
  [] -> Left (valueSpan value, NothingThere)
  token : _ -> at token reads'

at :: Token -> (Text -> Either Refusal v) -> Either (Span, Refusal) v
at token reads' = either (Left . (,) (tokenSpan token)) Right (reads' (tokenText token))

-- | A real number between two others, ends included.
--
-- Spec: comment.behind, value.single, form.real.
realWithin :: Double -> Double -> Form Double
realWithin low high = realThat (Between (showReal low) (showReal high)) (\x -> low <= x && x <= high)

-- | A real number not less than another.
--
-- Spec: form.real.
realFrom :: Double -> Form Double
realFrom low = realThat (AtLeast (showReal low)) (>= low)

-- | Any real number.
realThatIsAny :: Form Double
realThatIsAny = realThat AnyNumber (const True)

-- | A real number greater than zero, which is to say at least 'smallestLength'.
--
-- Spec: form.real.
positive :: Form Double
positive = realFrom smallestLength

-- Spec: code.out-of-range.
realThat :: Range -> (Double -> Bool) -> Form Double
realThat range fits = scalar (ARealNumber range) (\t -> real t >>= inside t) showReal
  where
    inside t x = if fits x then Right x else Left (OutOfRange t)

-- | An integer from a smallest one up.
--
-- Spec: form.integer.
count :: Int -> Form Int
count low = integerThat (AtLeast (number low)) low (fromInteger largestInteger)

-- | An integer between two others, ends included.
--
-- Spec: form.integer.
integerWithin :: Int -> Int -> Form Int
integerWithin low high = integerThat (Between (number low) (number high)) low high

-- Spec: code.out-of-range.
integerThat :: Range -> Int -> Int -> Form Int
integerThat range low high = scalar (AnInteger range) (\t -> integer t >>= inside t) number
  where
    inside t n = if low <= n && n <= high then Right n else Left (OutOfRange t)

-- | Whether a value of one real number goes on after it with a comma and a digit.
--
-- Spec: code.decimal-comma.
decimalsBehindComma :: Expectation -> Value -> Maybe Text
decimalsBehindComma expectation value = case (expectation, tokens value) of
  (ARealNumber _, token : _)
    | Just behind <- Text.stripPrefix (tokenText token) (Text.stripStart (valueText value)),
      commaInNumber ("0" <> Text.take 2 behind) ->
      Just (tokenText token)
  _ -> Nothing

-- | Three real numbers.
--
-- Spec: comment.behind, form.vector, canonical.values.
vectorForm :: Form Vector
vectorForm = Form AVector vector3 (Just . vectorText)

-- | Three real numbers that make a vector of at least 'smallestLength'.
--
-- Spec: code.zero-vector, form.direction.
directionForm :: Form Vector
directionForm = Form ADirection reads' (Just . vectorText)
  where
    reads' value = vector3 value >>= \v -> if modulus v < smallestLength then Left (valueSpan value, ZeroVector) else Right v

-- | Three real numbers, none of them zero.
--
-- Spec: code.zero-component, form.direction.
scaleForm :: Form Vector
scaleForm = Form AVectorWithoutZero reads' (Just . vectorText)
  where
    reads' value = vector3 value >>= \v -> if 0 `elem` v then Left (valueSpan value, ZeroComponent) else Right v

-- Spec: code.wrong-count.
vector3 :: Value -> Either (Span, Refusal) Vector
vector3 value = case tokens value of
  [x, y, z] -> V3 <$> at x real <*> at y real <*> at z real
  others -> Left (wrongCount value 3 others)

-- | Two real numbers.
--
-- Spec: form.coordinates.
textureForm :: Form (V2 Double)
textureForm = Form TwoCoordinates reads' (Just . vectorText)
  where
    reads' value = case tokens value of
      [u, v] -> V2 <$> at u real <*> at v real
      others -> Left (wrongCount value 2 others)

-- | A name, a name and an alpha, three channels, or three channels and an alpha.
--
-- Spec: code.out-of-range, code.unknown-choice, form.colour, canonical.values.
colourForm :: Form Colour
colourForm = Form (AColour (map fst names)) reads' (\(Colour r g b a) -> Just ("[ " <> Text.intercalate ", " (map showReal [r, g, b, a]) <> " ]"))
  where
    reads' value = case tokens value of
      name : _ : _ : others
        | Just _ <- named (tokenText name), length others <= 1 -> Left (tokenSpan name, NameAmongNumbers (tokenText name) (guess value))
      [name] -> at name byName
      [name, a] -> (\(Colour r g b _) -> Colour r g b) <$> at name byName <*> at a channel
      [r, g, b] -> Colour <$> at r channel <*> at g channel <*> at b channel <*> pure 1
      [r, g, b, a] -> Colour <$> at r channel <*> at g channel <*> at b channel <*> at a channel
      others -> Left (wrongCount value 4 others)
    byName t = maybe (Left (NoSuchChoice t (suggest (map fst names) t))) Right (named t)
    channel t = real t >>= \x -> if x >= 0 then Right x else Left (OutOfRange t)

-- | Too few tokens are a fault of the whole value; too many, of those that are too many.
--
-- Spec: code.wrong-count.
wrongCount :: Value -> Int -> [Token] -> (Span, Refusal)
wrongCount value wanted found = case drop wanted found of
  [] | null found -> (valueSpan value, NothingThere)
  [] -> (valueSpan value, WrongCount wanted (length found) NoGuess)
  extra : _ -> (tokenSpan extra, WrongCount wanted (length found) (guess value))

-- | Why a value may have more tokens than it can.
guess :: Value -> Guess
guess value = case words' of
  _ | any beginsRemark words' -> CommentBehind
  _ | end : _ <- filter ((== Just Keyword.End) . fromSpelling) words' -> EndBehind end
  _ | any (Text.all (`elem` ("=:;" :: String))) words' -> SignsAround
  _ | commaInNumber (valueText value) -> CommaInNumber
  _ -> NoGuess
  where
    words' = map tokenText (tokens value)

-- | Whether a comma stands between two digits, as people write decimals who do not write points.
commaInNumber :: Text -> Bool
commaInNumber t = or (zipWith both (Text.splitOn "," t) (drop 1 (Text.splitOn "," t)))
  where
    both before after = Text.any isDigit (Text.takeEnd 1 before) && Text.any isDigit (Text.take 1 after)

-- | One of some words, in any case, or its number counted from 0; written as the word.
--
-- Spec: value.single, code.out-of-range, code.unknown-choice, form.choice.
choice :: Eq v => [(Text, v)] -> Form v
choice options = Form (AChoice (map fst options)) (first reads') wordFor
  where
    wordFor v = listToMaybe [word | (word, w) <- options, w == v]
    reads' t = case lookup (Text.toLower t) options of
      Just v -> Right v
      Nothing -> case integer t of
        Right n | n >= 0, (_, v) : _ <- drop n options -> Right v
        Right _ -> Left (OutOfRange t)
        Left (TooLarge _) -> Left (OutOfRange t)
        Left _ -> Left (NoSuchChoice t (suggest (map fst options) t))

-- | Yes or no, in words or as a number (0 is no).
--
-- Spec: form.boolean.
booleanForm :: Form Bool
booleanForm = scalar ABoolean reads' (\b -> if b then "true" else "false")
  where
    reads' t
      | lower `elem` yes = Right True
      | lower `elem` no = Right False
      | otherwise = case integer t of
        Right n | n >= 0 -> Right (n > 0)
        Right _ -> Left (OutOfRange t)
        Left (TooLarge _) -> Left (TooLarge t)
        Left _ -> Left (NoSuchChoice t (suggest (yes <> no) t))
      where
        lower = Text.toLower t
    yes = ["true", "vrai", "yes", "oui", "on"]
    no = ["false", "faux", "no", "non", "off"]

-- | The rest of the line, as it is.
--
-- Spec: value.text, form.text.
text :: Form Text
text = textThat SomeText (const Nothing)

-- | The name of a file that the program reads. The word @none@, so spelt, stands for no file: what is read, checked and
-- written knows it here only.
--
-- Spec: models.texture.none.
fileName :: Form (Maybe Text)
fileName = Form SomeText (fmap meant . formRead text) (Just . fromMaybe none)
  where
    meant t = if t == none then Nothing else Just t
    none = "none"

-- | The name of a file that the program writes: no folder, no control character.
--
-- Spec: code.unsafe-name, form.text.
outputName :: Form Text
outputName = textThat AnOutputName unsafe

-- | The same, with an ending that is to be there, in any case.
--
-- Spec: code.wrong-ending.
outputNameEnding :: Text -> Form Text
outputNameEnding ending = textThat (AnOutputNameEnding ending) $ \t ->
  case unsafe t of
    Nothing | not (ending `Text.isSuffixOf` Text.toLower t) -> Just WrongEnding
    refusal -> refusal

unsafe :: Text -> Maybe Refusal
unsafe t
  | Text.any (\c -> c == '/' || c == '\\' || isControl c) t = Just UnsafeName
  | otherwise = Nothing

-- Spec: code.missing-value.
textThat :: Expectation -> (Text -> Maybe Refusal) -> Form Text
textThat expectation refuses = Form expectation reads' Just
  where
    reads' (Value place t)
      | Text.null t = Left (place, NothingThere)
      | otherwise = maybe (Right t) (Left . (,) place) (refuses t)

-- | The same form, written with a unit after it (which reading ignores).
--
-- Spec: canonical.values.
withUnit :: Text -> Form v -> Form v
withUnit unitName form = form {formShow = fmap (<> " " <> unitName) . formShow form}

-- | The same form for a value that need not be there. There is nothing to write where it is not.
optionally :: Form v -> Form (Maybe v)
optionally form = Form (formExpectation form) (fmap Just . formRead form) (>>= formShow form)
