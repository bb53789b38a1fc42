{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Parameter
-- Description : The arguments of operations, and their results, in JSON
--
-- > number   1.5                      vector   [1, 2, 3]
-- > colour   [r, g, b] or [r, g, b, a]
-- > ray      {"origin": [0, 0, 0], "direction": [0, 0, 1]}
-- > shape    {"kind": "disk", "position": [0, 0, 0], "normal": [0, 0, 1], "ray": 2}
--
-- A shape is written with the words of the scene language, and read by the scene language's own tables
-- ("Dioptre.Scene.Shapes"): it is turned into a block of a scene, so that words, ranges, conditions and defaults are
-- the same. A property that may be given several times is an array of its values.
module Dioptre.Conformance.Parameter
  ( -- * Operations
    Operation,
    field,
    fieldOr,

    -- * Arguments
    number,
    whole,
    vector,
    unitVector,
    ray,
    colour,
    shape,

    -- * Results
    real,
    reals,
    ofVector,
    ofRay,
    ofColour,
  )
where

import Control.Monad (unless, (>=>))
import Data.Aeson (Key, Object, Value (..), object, toJSON, withArray, withObject, (.:), (.=), (<?>))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as Keys
import Data.Aeson.Types (JSONPathElement (Key), Parser, explicitParseField, explicitParseFieldMaybe)
import Data.Foldable (toList)
import Data.List (elemIndex, sortOn)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Conformance.Protocol (binary64)
import Dioptre.Geometry.Ray (Ray, direction, origin)
import qualified Dioptre.Geometry.Ray as Ray
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Math.Vector (Unit, Vector, unit)
import Dioptre.Scene.Reporting (runCheck)
import Dioptre.Scene.Shapes (describeShapes, readShape)
import Dioptre.Source.Diagnostic (Diagnostic (..), Expectation (..))
import Dioptre.Source.Language (Language (English))
import Dioptre.Source.Message (message)
import Dioptre.Source.Span (Span (..), wholeFile)
import Dioptre.Syntax.Keyword (Keyword, fromSpelling, isShape)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Tree (Block (..), Closing (ByEnd), Head (..), Node, Property (..))
import qualified Dioptre.Syntax.Tree as Tree
import Dioptre.Syntax.Value (showReal)
import Linear.V3 (V3 (..))

-- | From what stands under @in@ to what stands under @ok@, or a complaint about the former.
type Operation = Object -> Parser Value

-- | An argument that must be there.
field :: (Value -> Parser a) -> Object -> Key -> Parser a
field = explicitParseField

-- | An argument that may be left out, and what it is then.
fieldOr :: a -> (Value -> Parser a) -> Object -> Key -> Parser a
fieldOr absent parser o name = fromMaybe absent <$> explicitParseFieldMaybe parser o name

-- | A number, as a binary64; not one too large for it.
number :: Value -> Parser Double
number value = case binary64 value of
  Just x
    | isInfinite x -> fail "the number is too large"
    | otherwise -> pure x
  Nothing -> fail "this is not a number"

-- | A whole number, not less than another.
--
-- Spec: protocol.sizes.
whole :: Int -> Value -> Parser Int
whole least value = do
  x <- number value
  let n = if abs x < 9007199254740992 then truncate x else 0 :: Int
  unless (fromIntegral n == x) (fail "this is not a whole number")
  unless (n >= least) (fail ("this is less than " <> show least))
  pure n

numbers :: Value -> Parser [Double]
numbers = withArray "numbers" (traverse number . toList)

-- | Three numbers.
--
-- Spec: protocol.forms.
vector :: Value -> Parser Vector
vector =
  numbers >=> \case
    [x, y, z] -> pure (V3 x y z)
    _ -> fail "this is not a vector of three numbers"

-- | A vector, made unit by 'unit'; not the zero vector.
--
-- Spec: protocol.directions, protocol.sizes.
unitVector :: Value -> Parser Unit
unitVector = vector >=> maybe (fail "the zero vector has no direction") pure . unit

-- | A ray, whose direction is kept as it is, of any length but zero.
--
-- Spec: protocol.rays, protocol.sizes.
ray :: Value -> Parser Ray
ray = withObject "ray" $ \o -> do
  from <- field vector o "origin"
  towards <- field vector o "direction"
  if towards == 0 then fail "the direction of a ray is not zero" else pure (Ray.ray from towards)

-- | Three or four numbers from 0 up; opaque if there are three.
--
-- Spec: protocol.forms.
colour :: Value -> Parser Colour
colour =
  numbers >=> \case
    channels | any (< 0) channels -> fail "no channel of a colour is negative"
    [r, g, b] -> pure (Colour r g b 1)
    [r, g, b, a] -> pure (Colour r g b a)
    _ -> fail "this is not a colour of three or four numbers"

-- | A shape. What the scene language would find wrong with it is said in its words; every such fault is one here.
--
-- Spec: protocol.shapes.
shape :: Value -> Parser Shape
shape =
  block >=> \b -> case runCheck (readShape b) of
    (Just s, []) -> pure s
    (_, diagnostics) -> fail (concatMap told (take 1 diagnostics))
  where
    told = Text.unpack . message English . diagnosticProblem

-- | The block of a scene that says the same as an object with a @kind@.
block :: Value -> Parser Block
block = withObject "shape" $ \o -> do
  kind <- o .: "kind"
  word <- case fromSpelling kind of
    Just w | isShape w -> pure w
    _ -> fail ("no shape is called '" <> Text.unpack kind <> "'")
  let properties = [p | (w, described) <- describeShapes, w == word, p <- described]
      inOrder (key, _) = fromSpelling (Key.toText key) >>= (`elemIndex` concat [words' | (words', _, _) <- properties])
  nodes <- traverse (nodesOf properties) (sortOn inOrder (Keys.toList (Keys.delete "kind" o)))
  pure (Block (headOf kind) (Tree.Value wholeFile "") (concat nodes) (ByEnd wholeFile))

-- | What a member of an object says, given what its shape's properties expect: a property for each value, or an object.
nodesOf :: [([Keyword], Expectation, [Text])] -> (Key, Value) -> Parser [Node]
nodesOf properties (key, value) = case fromSpelling name of
  Just Keyword.Geometry -> (\b -> [Tree.Object b]) <$> block value <?> Key key
  Just word | expectation : _ <- [e | (words', e, _) <- properties, word `elem` words'] -> map property <$> values (isScalar expectation) <?> Key key
  _ -> pure [property ""]
  where
    name = Key.toText key
    property text = Tree.Statement (Property (headOf name) (Tree.Value (Span 1 1 (1 + Text.length text)) text))
    values scalar = case value of
      Array items
        | null items -> fail "an empty array says nothing"
        | scalar -> traverse (fmap showReal . number) (toList items)
        | all isArray items -> traverse (fmap listed . numbers) (toList items)
        | otherwise -> pure . listed <$> numbers value
      _
        | scalar -> pure . showReal <$> number value
        | otherwise -> fail "this is not an array"
    listed = Text.unwords . map showReal
    isArray item = case item of
      Array _ -> True
      _ -> False

-- | Whether a property is one number.
isScalar :: Expectation -> Bool
isScalar expectation = case expectation of
  ARealNumber _ -> True
  _ -> False

headOf :: Text -> Head
headOf word = Head (Span 1 1 (1 + Text.length word)) word (fromSpelling word)

-- | A number as a result, and 0 for -0, by a sum with 0; a complaint if it is NaN or infinite, which cannot be sent.
--
-- Spec: protocol.refused, numbers.not-finite.
real :: Double -> Parser Value
real x
  | isNaN x || isInfinite x = fail "the result is not finite"
  | otherwise = pure (toJSON (x + 0))

-- | Numbers.
--
-- Spec: protocol.forms.
reals :: [Double] -> Parser Value
reals xs = toJSON <$> traverse real xs

-- | A vector.
ofVector :: Vector -> Parser Value
ofVector = reals . toList

-- | A ray.
--
-- Spec: protocol.rays.
ofRay :: Ray -> Parser Value
ofRay r = (\o d -> object ["origin" .= o, "direction" .= d]) <$> ofVector (origin r) <*> ofVector (direction r)

-- | A colour without its alpha.
ofColour :: Colour -> Parser Value
ofColour c = reals [red c, green c, blue c]
