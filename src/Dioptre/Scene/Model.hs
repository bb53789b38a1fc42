{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Model
-- Description : Models from files
--
-- What a scene says of a model: which file it is in, where it goes, and which way up its pictures are. What is in the
-- file is the affair of later stages ("Dioptre.Load.Models"). Specification: rule @block.model@.
module Dioptre.Scene.Model
  ( Model (..),
    UvFormat (..),
    modelSchema,
    Draft,
    uvFormatName,
  )
where

import Data.Text (Text)
import Dioptre.Math.Transform (Transform, transform, transformRotation, transformScale, transformTranslation)
import Dioptre.Math.Vector (Vector)
import Dioptre.Scene.Form (choice, fileName, scaleForm, vectorForm)
import Dioptre.Scene.Schema (Schema (..), one)
import Dioptre.Source.Diagnostic (Flaw (..))
import qualified Dioptre.Syntax.Keyword as Keyword

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

-- | What a model can be given.
data Draft = Draft
  { draftFile :: Maybe Text,
    draftScale :: Vector,
    draftRotation :: Vector,
    draftTranslation :: Vector,
    draftUvFormat :: UvFormat
  }

-- | How the scene language writes a model.
--
-- Spec: block.model, models.block.
modelSchema :: Schema Draft Model
modelSchema =
  Schema
    Keyword.Model
    (Draft Nothing 1 0 0 UvDefault)
    [ one Keyword.File fileName draftFile (\v d -> d {draftFile = v}),
      one Keyword.Scale scaleForm draftScale (\v d -> d {draftScale = v}),
      one Keyword.Rotation vectorForm draftRotation (\v d -> d {draftRotation = v}),
      one Keyword.Translation vectorForm draftTranslation (\v d -> d {draftTranslation = v}),
      one Keyword.UvFormat (choice formats) draftUvFormat (\v d -> d {draftUvFormat = v})
    ]
    Nothing
    build
    open
  where
    build d = case transform (draftScale d) (draftRotation d) (draftTranslation d) of
      Nothing -> Left ZeroSize
      Just t -> Right (Model (draftFile d) t (draftUvFormat d))
    open (Model file t format) = Draft file (transformScale t) (transformRotation t) (transformTranslation t) format
    formats = [(uvFormatName u, u) | u <- [minBound ..]]

-- | The word for a format.
uvFormatName :: UvFormat -> Text
uvFormatName = \case
  UvDefault -> "default"
  UvTopLeft -> "origin_uv_top_left"
  UvBottomLeft -> "origin_uv_bottom_left"
