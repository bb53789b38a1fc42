{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Primitive
-- Description : Shapes with materials
--
-- A primitive is a thing to be seen: a shape, and the name of the material that it is of. The name is looked up when
-- the whole file has been read ("Dioptre.Scene.Check"), so that materials may stand behind the primitives that use
-- them. Specification: rule @block.primitive@.
module Dioptre.Scene.Primitive
  ( Primitive (..),
    primitiveSchema,
  )
where

import Data.Text (Text)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Scene.Form (text)
import Dioptre.Scene.Schema (Schema (..), one)
import Dioptre.Scene.Shapes (holding)
import Dioptre.Source.Diagnostic (Flaw (..))
import qualified Dioptre.Syntax.Keyword as Keyword

-- | A shape and the name of its material.
data Primitive = Primitive
  { primitiveMaterial :: Text,
    primitiveShape :: Shape
  }
  deriving stock (Eq, Show)

-- | How the scene language writes a primitive.
--
-- Spec: code.no-shape, block.primitive.
primitiveSchema :: Schema (Text, Maybe Shape) Primitive
primitiveSchema =
  Schema
    Keyword.Primitive
    ("none", Nothing)
    [one Keyword.MaterialName text fst (\n (_, s) -> (n, s))]
    (Just (holding snd (\s (n, _) -> (n, s))))
    (\(name, shape) -> maybe (Left WithoutShape) (Right . Primitive name) shape)
    (\(Primitive name shape) -> (name, Just shape))
