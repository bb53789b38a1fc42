{-# LANGUAGE ExistentialQuantification #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Schema
-- Description : Objects of the scene language, described once
--
-- A 'Schema' says what an object of the language is: its word, its defaults, its properties with their forms and where
-- they go, and when it is possible. The same description reads an object, writes one, and tells what may stand in it;
-- nothing about an object is said twice.
--
-- > sphere                         Schema Keyword.Sphere
-- >   position [0.0, 0.0, 2.0]       one Keyword.Position vectorForm ...
-- >   ray 1.5                        one Keyword.Ray positive ...
-- > end                              build: sphere
--
-- Reading never fails: what cannot be used is told ("Dioptre.Scene.Reporting"), and the value before it stays.
module Dioptre.Scene.Schema
  ( -- * Describing
    Schema (..),
    Property,
    Slot (..),
    ShapePlace (..),
    one,
    several,
    within,

    -- * Reading
    readObject,
    readWholeFile,
    placeOfValue,

    -- * Writing
    writeObject,
    writeProperties,

    -- * Telling
    describe,
  )
where

import Control.Monad (foldM)
import Data.Either (isRight)
import Data.Foldable (for_, toList)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.List (find)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (isJust, listToMaybe)
import Data.Text (Text)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Scene.Form (Form (..), decimalsBehindComma)
import Dioptre.Scene.Reporting (Check, misfit, passOver, report)
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..), wholeFile, width)
import Dioptre.Syntax.Keyword (Keyword (Camera, End, Raytracer, Viewport), fromSpelling, isShape)
import Dioptre.Syntax.Print (Outline (..))
import Dioptre.Syntax.Tree (Block (..), Closing (..), Head (..), Node (..), Value (..))
import qualified Dioptre.Syntax.Tree as Tree
import Dioptre.Syntax.Value (Token (..), real, tokens)

-- | How objects @b@ are read and written, by way of a draft @a@ that holds the values of their properties before it is
-- known whether they fit together.
data Schema a b = Schema
  { -- | The word that opens the object.
    schemaKeyword :: Keyword,
    -- | The defaults.
    schemaDraft :: a,
    -- | The properties, in the order in which they are written.
    schemaProperties :: [Property a],
    -- | Where the shape goes, for an object that holds one.
    schemaShape :: Maybe (ShapePlace a),
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

-- | Where a draft has its shape, and how shapes are read and written. ("Dioptre.Scene.Shapes", which knows how, is
-- built on schemas itself.)
data ShapePlace a = ShapePlace
  { shapeGet :: a -> Maybe Shape,
    shapePut :: Maybe Shape -> a -> a,
    shapeRead :: Block -> Check (Maybe Shape),
    shapeWrite :: Shape -> Outline
  }

-- | A property that fills one place; given again, it fills it again.
one :: Keyword -> Form v -> (a -> v) -> (v -> a -> a) -> Property a
one word form get put = Property (word :| []) form (Slot get (\v a -> Right (put v a)) :| [])

-- | A property that fills one place after the other, under any of its words.
--
-- Spec: object.several.
several :: NonEmpty Keyword -> Form v -> NonEmpty (Slot a v) -> Property a
several = Property

-- | The property of a part as a property of the whole.
within :: (b -> a) -> (a -> b -> b) -> Property a -> Property b
within get put (Property words' form slots) = Property words' form (fmap inside slots)
  where
    inside (Slot g p) = Slot (g . get) (\v b -> (`put` b) <$> p v (get b))

-- | How far the reading of an object has come.
data Progress a = Progress
  { draft :: a,
    -- | How often each property, by its number, has been given.
    given :: IntMap Int,
    -- | Whether it has a shape.
    shaped :: Bool
  }

-- | The object that a block of the tree describes; 'Nothing' if its values make none, which has been reported.
--
-- Spec: code.no-shape, code.behind-opening, object.defaults, object.impossible.
readObject :: Schema a b -> Block -> Check (Maybe b)
readObject schema block = do
  reportRest schema block
  progress <- foldM (readNode schema object) (Progress (schemaDraft schema) IntMap.empty False) (blockNodes block)
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
  readObject schema (Block (Head wholeFile name Nothing) (Value wholeFile "") nodes (ByEnd wholeFile))

-- Spec: code.unclosed-comment, code.second-shape, object.shape.
readNode :: Schema a b -> Text -> Progress a -> Node -> Check (Progress a)
readNode schema object progress node = case node of
  Statement p -> case headKeyword (Tree.propertyHead p) >>= propertyOf schema of
    Nothing -> progress <$ report (headSpan (Tree.propertyHead p)) (misfit (Just object) (admissible schema) (Tree.propertyHead p) (valueText (Tree.propertyValue p)) TheLine)
    Just (index, property) -> do
      let k = IntMap.findWithDefault 0 index (given progress)
      filled <- fill property k (draft progress) p
      pure progress {draft = filled, given = IntMap.insert index (k + 1) (given progress)}
  Object inner -> case schemaShape schema of
    Just place
      | Just True <- isShape <$> headKeyword (blockHead inner) ->
        if shaped progress
          then progress <$ report (headSpan (blockHead inner)) (SecondShape object)
          else do
            shape <- shapeRead place inner
            pure progress {draft = shapePut place shape (draft progress), shaped = isJust shape}
    _ -> progress <$ passOver (Just object) (admissible schema) inner
  OpenComment place -> progress <$ report place UnclosedComment
  LooseEnd word -> progress <$ report (headSpan word) (StrayEnd (headText word))

-- | The property of that word, and its number.
propertyOf :: Schema a b -> Keyword -> Maybe (Int, Property a)
propertyOf schema word = find (\(_, Property words' _ _) -> word `elem` words') (zip [0 ..] (schemaProperties schema))

-- | Fills the place that the k-th occurrence of a property goes to.
--
-- Spec: check.place, code.missing-value, code.repeated-property, object.defaults, object.several.
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

-- | Reports what stands behind the word that opens a block and looks as if it were to be read: a property of the
-- object, or the number that a shape is to have.
reportRest :: Schema a b -> Block -> Check ()
reportRest schema block = case tokens (blockRest block) of
  token : _
    | isProperty (tokenText token) || isShape (schemaKeyword schema) && isRight (real (tokenText token)) ->
      report (tokenSpan token) (BehindOpening object (tokenText token))
  _ -> pure ()
  where
    object = headText (blockHead block)
    isProperty t = isJust (fromSpelling t >>= propertyOf schema)

-- | Reports what is odd about the end of a block.
--
-- Spec: code.misspelt-end, code.missing-end.
reportClosing :: Block -> Check ()
reportClosing block = case blockClosing block of
  ByEnd _ -> pure ()
  ByMisspeltEnd word -> report (headSpan word) (MisspeltEnd (headText word))
  BySceneWord word -> missing (Just (headText word, spanLine (headSpan word)))
  ByEndOfFile -> missing Nothing
  where
    missing by = report (headSpan (blockHead block)) (MissingEnd (headText (blockHead block)) by)

-- | Where the value of a property stands in a block: of its last occurrence that has one.
placeOfValue :: Keyword -> Block -> Maybe Span
placeOfValue word block =
  listToMaybe
    [ valueSpan (Tree.propertyValue p)
      | Statement p <- reverse (blockNodes block),
        headKeyword (Tree.propertyHead p) == Just word,
        width (valueSpan (Tree.propertyValue p)) > 0
    ]

-- | The object in the scene language, every property written out.
--
-- Spec: canonical.layout.
writeObject :: Schema a b -> b -> Outline
writeObject schema object = Group (schemaKeyword schema) (writeProperties schema object <> shape)
  where
    shape = [shapeWrite place s | Just place <- [schemaShape schema], Just s <- [shapeGet place (schemaOpen schema object)]]

-- | The properties alone. What has no value is left out.
--
-- Spec: canonical.words.
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
