{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Primitive
-- Description : Shapes with materials, and models from files
module Dioptre.Scene.Primitive
  ( -- * Primitives
    Primitive (..),
    primitiveSchema,

    -- * Models
    Model (..),
    UvFormat (..),
    modelSchema,
    uvFormatName,
  )
where

import Data.Text (Text)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Math.Transform (Transform, identity, transform, transformRotation, transformScale, transformTranslation)
import Dioptre.Math.Vector (Vector)
import Dioptre.Scene.Form (choice, fileName, scaleForm, text, vectorForm)
import Dioptre.Scene.Schema (Schema (..), Slot (..), one)
import Dioptre.Source.Diagnostic (Flaw (..))
import qualified Dioptre.Syntax.Keyword as Keyword

-- | A shape and the name of its material.
data Primitive = Primitive
  { primitiveMaterial :: Text,
    primitiveShape :: Shape
  }
  deriving stock (Eq, Show)

-- | How the scene language writes a primitive.
primitiveSchema :: Schema (Text, Maybe Shape) Primitive
primitiveSchema =
  Schema
    Keyword.Primitive
    ("none", Nothing)
    [one Keyword.MaterialName text fst (\n (_, s) -> (n, s))]
    (Just (Slot snd (\s (n, _) -> Right (n, s))))
    (\(name, shape) -> maybe (Left WithoutShape) (Right . Primitive name) shape)
    (\(Primitive name shape) -> (name, Just shape))

-- | A model: the file it is in, and where it goes.
data Model = Model
  { -- | Without one there is nothing to draw.
    modelFile :: Maybe Text,
    modelTransform :: Transform,
    modelUvFormat :: UvFormat
  }
  deriving stock (Eq, Show)

-- | Which row of a picture the texture coordinate v = 0 means.
data UvFormat = UvDefault | UvTopLeft | UvBottomLeft
  deriving stock (Eq, Show, Enum, Bounded)

-- | How the scene language writes a model.
modelSchema :: Schema (Maybe Text, (Vector, Vector, Vector), UvFormat) Model
modelSchema =
  Schema
    Keyword.Model
    (Nothing, opened identity, UvDefault)
    [ one Keyword.File fileName (\(f, _, _) -> f) (\f (_, t, u) -> (f, t, u)),
      one Keyword.Scale scaleForm (\(_, (s, _, _), _) -> s) (\s (f, (_, r, t), u) -> (f, (s, r, t), u)),
      one Keyword.Rotation vectorForm (\(_, (_, r, _), _) -> r) (\r (f, (s, _, t), u) -> (f, (s, r, t), u)),
      one Keyword.Translation vectorForm (\(_, (_, _, t), _) -> t) (\t (f, (s, r, _), u) -> (f, (s, r, t), u)),
      one Keyword.UvFormat (choice formats) (\(_, _, u) -> u) (\u (f, t, _) -> (f, t, u))
    ]
    Nothing
    (\(f, (s, r, t), u) -> maybe (Left ZeroSize) (\m -> Right (Model f m u)) (transform s r t))
    (\m -> (modelFile m, opened (modelTransform m), modelUvFormat m))
  where
    opened t = (transformScale t, transformRotation t, transformTranslation t)
    formats = [(uvFormatName u, u) | u <- [minBound ..]]

-- | The word for a format.
uvFormatName :: UvFormat -> Text
uvFormatName u = case u of
  UvDefault -> "default"
  UvTopLeft -> "origin_uv_top_left"
  UvBottomLeft -> "origin_uv_bottom_left"
