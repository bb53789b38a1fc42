{-# LANGUAGE ExistentialQuantification #-}

-- |
-- Module      : Dioptre.Scene.Schema
-- Description : Objects of the scene language, described once
--
-- A 'Schema' says what an object of the language is: its word, its defaults, its properties with their forms and where they
-- go, and when it is possible. The same description reads an object, writes one, and tells what may stand in it; nothing about an
-- object is said twice.
--
-- > sphere                         Schema Keyword.Sphere
-- >   position [0.0, 0.0, 2.0]       one [Keyword.Position] vectorForm ...
-- >   ray 1.5                        one [Keyword.Ray] positive ...
-- > end                              build: sphere
--
-- Reading never fails: what cannot be used is a 'Diagnostic', and the value before it stays.
module Dioptre.Scene.Schema
  ( -- * Describing
    Schema (..),
    Property,
    Slot (..),
    one,
    several,
    oneOrRefuse,
    within,

    -- * Reading
    Check,
    report,
    readObject,
    readWholeFile,
    runCheck,
    passOver,
    misfit,
    placeOfValue,

    -- * Writing
    writeObject,
    writeProperties,

    -- * Telling
    admissible,
    describe,
  )
where

import Control.Applicative ((<|>))
import Control.Monad (foldM)
import Control.Monad.Trans.Writer.CPS (Writer, runWriter, tell)
import Data.Either (fromRight)
import Data.Foldable (for_, toList)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (find, mapAccumL, sortOn)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (isJust, listToMaybe)
import Data.Sequence (Seq)
import qualified Data.Sequence as Seq
import Data.Text (Text)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Scene.Form (Form (..), decimalsBehindComma)
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..), wholeFile, width)
import Dioptre.Syntax.Keyword (Keyword (Camera, End, Raytracer, Viewport), allSpellings, isShape, spelling, spellings)
import Dioptre.Syntax.Print (Outline (..))
import Dioptre.Syntax.Spelling (suggest)
import Dioptre.Syntax.Tree (Block (..), Closing (..), Head (..), Node (..), Value (..))
import qualified Dioptre.Syntax.Tree as Tree

-- | How objects @b@ are read and written, by way of a draft @a@ that holds the values of their properties before it is known whether they fit
-- together.
data Schema a b = Schema
  { -- | The word that opens the object.
    schemaKeyword :: Keyword,
    -- | The defaults.
    schemaDraft :: a,
    -- | The properties, in the order in which they are written.
    schemaProperties :: [Property a],
    -- | Where the shape goes, for an object that holds one.
    schemaShape :: Maybe (Slot a (Maybe Shape)),
    -- | The object that a draft makes, or why it makes none.
    schemaBuild :: a -> Either Flaw b,
    -- | The draft that an object was made from. Law: @schemaBuild . schemaOpen@ gives the object back.
    schemaOpen :: b -> a
  }

-- | A property of drafts: its words (the first is written), the form of its value, and the places that its successive
-- occurrences fill.
data Property a = forall v. Property (NonEmpty Keyword) (Form v) (NonEmpty (Slot a v))

-- | A place in a draft. Filling it can be refused, for reasons that the form alone does not see.
data Slot a v = Slot
  { slotGet :: a -> v,
    slotPut :: v -> a -> Either Refusal a
  }

-- | A property that fills one place; given again, it fills it again.
one :: Keyword -> Form v -> (a -> v) -> (v -> a -> a) -> Property a
one word form get put = Property (word :| []) form (Slot get (\v a -> Right (put v a)) :| [])

-- | The same for a place that can refuse a value.
oneOrRefuse :: Keyword -> Form v -> (a -> v) -> (v -> a -> Either Refusal a) -> Property a
oneOrRefuse word form get put = Property (word :| []) form (Slot get put :| [])

-- | A property that fills one place after the other, under any of its words.
several :: NonEmpty Keyword -> Form v -> NonEmpty (Slot a v) -> Property a
several = Property

-- | The property of a part as a property of the whole.
within :: (b -> a) -> (a -> b -> b) -> Property a -> Property b
within get put (Property words' form slots) = Property words' form (fmap inside slots)
  where
    inside (Slot g p) = Slot (g . get) (\v b -> (`put` b) <$> p v (get b))

-- | Checking collects diagnostics on its way.
type Check = Writer (Seq Diagnostic)

-- | Something to say about a place.
report :: Span -> Problem -> Check ()
report place problem = tell (Seq.singleton (Diagnostic place problem))

-- | What was found, and everything there was to say, in the order of the file.
runCheck :: Check a -> (a, [Diagnostic])
runCheck check = snd . mapAccumL sparingly 0 . sortOn diagnosticSpan . toList <$> runWriter check

-- | Leaves the guesses out from the thousandth on: finding what was meant by a word takes longer than all the rest, and
-- in a file with so many unknown words it is not the spelling that is wrong.
sparingly :: Int -> Diagnostic -> (Int, Diagnostic)
sparingly n (Diagnostic place problem) = case problem of
  UnknownWord w words' _ passed -> (n + 1, Diagnostic place (if n < 1000 then problem else UnknownWord w words' Nothing passed))
  MissingMaterial name _ -> (n + 1, Diagnostic place (if n < 1000 then problem else MissingMaterial name Nothing))
  _ -> (n, Diagnostic place problem)

-- | How far the reading of an object has come.
data Progress a = Progress
  { draft :: a,
    -- | How often each property, by its number, has been given.
    given :: IntMap Int,
    -- | Whether it has a shape.
    shaped :: Bool
  }

-- | The object that a block of the tree describes; 'Nothing' if its values make none, which has been reported. The first argument
-- reads a shape in it.
readObject :: (Block -> Check (Maybe Shape)) -> Schema a b -> Block -> Check (Maybe b)
readObject readShape schema block = do
  progress <- foldM (readNode readShape schema object) (Progress (schemaDraft schema) IntMap.empty False) (blockNodes block)
  reportClosing block
  case schemaBuild schema (draft progress) of
    Right b -> pure (Just b)
    -- What is wrong with the shape that it tried to have has been told.
    Left WithoutShape | any isObject (blockNodes block) -> pure Nothing
    Left flaw -> Nothing <$ report (headSpan (blockHead block)) (ImpossibleObject object flaw fate)
  where
    object = headText (blockHead block)
    fate = if schemaKeyword schema `elem` [Camera, Viewport, Raytracer] then Superseded else LeftOut
    isObject node = case node of
      Object _ -> True
      _ -> False

-- | The object that a whole file describes, without a word that opens it or an @end@.
readWholeFile :: Schema a b -> Text -> [Node] -> Check (Maybe b)
readWholeFile schema name nodes =
  readObject (const (pure Nothing)) schema (Block (Head wholeFile name Nothing) nodes (ByEnd wholeFile))

readNode :: (Block -> Check (Maybe Shape)) -> Schema a b -> Text -> Progress a -> Node -> Check (Progress a)
readNode readShape schema object progress node = case node of
  Statement p -> case headKeyword (Tree.propertyHead p) >>= propertyOf schema of
    Nothing -> progress <$ report (headSpan (Tree.propertyHead p)) (misfit (Just object) (admissible schema) (Tree.propertyHead p) TheLine)
    Just (index, property) -> do
      let k = IntMap.findWithDefault 0 index (given progress)
      filled <- fill property k (draft progress) p
      pure progress {draft = filled, given = IntMap.insert index (k + 1) (given progress)}
  Object inner -> case schemaShape schema of
    Just slot
      | Just True <- isShape <$> headKeyword (blockHead inner) ->
        if shaped progress
          then progress <$ report (headSpan (blockHead inner)) (SecondShape object)
          else do
            shape <- readShape inner
            pure progress {draft = fromRight (draft progress) (slotPut slot shape (draft progress)), shaped = isJust shape}
    _ -> progress <$ passOver (Just object) (admissible schema) inner
  OpenComment place -> progress <$ report place UnclosedComment
  LooseEnd word -> progress <$ report (headSpan word) (StrayEnd (headText word))

-- | The property of that word, and its number.
propertyOf :: Schema a b -> Keyword -> Maybe (Int, Property a)
propertyOf schema word = find (\(_, Property words' _ _) -> word `elem` words') (zip [0 ..] (schemaProperties schema))

-- | Fills the place that the k-th occurrence of a property goes to.
fill :: Property a -> Int -> a -> Tree.Property -> Check a
fill (Property _ form slots) k before p = case slotFor of
  Nothing -> before <$ report (headSpan word) (RepeatedProperty (headText word) (NonEmpty.length slots))
  Just slot -> case formRead form value >>= \v -> either (Left . (,) (valueSpan value)) Right (slotPut slot v before) of
    Right after -> do
      for_ (decimalsBehindComma (formExpectation form) value) $ \number -> report (valueSpan value) (DecimalComma (headText word) number)
      pure after
    Left (place, refusal) ->
      before <$ report (orWord place) (RefusedValue (headText word) refusal (formExpectation form) (maybe TheDefault Kept (formShow form (slotGet slot before))))
  where
    word = Tree.propertyHead p
    value = Tree.propertyValue p
    slotFor = case slots of
      only :| [] -> Just only
      _ -> listToMaybe (NonEmpty.drop k slots)
    -- A value that is not there is missed at its word.
    orWord place = if width place == 0 then headSpan word else place

-- | Says that a block has no place in an object (none: at the level of the file), where those words may stand. It is passed over,
-- with all that is in it.
passOver :: Maybe Text -> [Keyword] -> Block -> Check ()
passOver object words' block =
  report (headSpan (blockHead block)) (misfit object words' (blockHead block) (TheObject (lastLine block)))

-- | The last line that belongs to a block.
lastLine :: Block -> Int
lastLine block = case blockClosing block of
  ByEnd place -> spanLine place
  ByMisspeltEnd word -> spanLine (headSpan word)
  BySceneWord word -> spanLine (headSpan word) - 1
  ByEndOfFile -> maximum (spanLine (headSpan (blockHead block)) : map nodeLine (blockNodes block))
  where
    nodeLine node = case node of
      Object inner -> lastLine inner
      Statement p -> spanLine (headSpan (Tree.propertyHead p))
      LooseEnd word -> spanLine (headSpan word)
      OpenComment place -> spanLine place

-- | What is wrong with a word that is none of those that may stand there.
misfit :: Maybe Text -> [Keyword] -> Head -> PassedOver -> Problem
misfit object words' word passed = case headKeyword word of
  Just _ -> MisplacedWord (headText word) object (map spelling words') passed
  Nothing -> UnknownWord (headText word) (map spelling words') guess passed
  where
    guess = suggest (concatMap (toList . spellings) words') (headText word) <|> suggest allSpellings (headText word)

-- | Reports what is odd about the end of a block.
reportClosing :: Block -> Check ()
reportClosing block = case blockClosing block of
  ByEnd _ -> pure ()
  ByMisspeltEnd word -> report (headSpan word) (MisspeltEnd (headText word))
  BySceneWord word -> missing (Just (headText word, spanLine (headSpan word)))
  ByEndOfFile -> missing Nothing
  where
    missing by = report (headSpan (blockHead block)) (MissingEnd (headText (blockHead block)) by)

-- | Where the value of a property stands in a block: of its last occurrence, as that is the one that counts.
placeOfValue :: Keyword -> Block -> Maybe Span
placeOfValue word block =
  listToMaybe
    [ valueSpan (Tree.propertyValue p)
      | Statement p <- reverse (blockNodes block),
        headKeyword (Tree.propertyHead p) == Just word
    ]

-- | The object in the scene language, every property written out. The first argument writes the shape in it.
writeObject :: (Shape -> Outline) -> Schema a b -> b -> Outline
writeObject writeShape schema object = Group (schemaKeyword schema) (writeProperties schema object <> shape)
  where
    shape = [writeShape s | Just slot <- [schemaShape schema], Just s <- [slotGet slot (schemaOpen schema object)]]

-- | The properties alone. What has no value is left out.
writeProperties :: Schema a b -> b -> [Outline]
writeProperties schema object = concatMap property (schemaProperties schema)
  where
    opened = schemaOpen schema object
    property (Property (word :| _) form slots) =
      [Line word value | slot <- toList slots, Just value <- [formShow form (slotGet slot opened)]]

-- | The words that may stand in an object, its @end@ included.
admissible :: Schema a b -> [Keyword]
admissible schema =
  End : concat [toList words' | Property words' _ _ <- schemaProperties schema] <> [w | Just _ <- [schemaShape schema], w <- [minBound ..], isShape w]

-- | For each property of an object: its words, what it expects, and those of its defaults that can be written.
describe :: Schema a b -> [([Keyword], Expectation, [Text])]
describe schema =
  [ (toList words', formExpectation form, [value | slot <- toList slots, Just value <- [formShow form (slotGet slot (schemaDraft schema))]])
    | Property words' form slots <- schemaProperties schema
  ]
