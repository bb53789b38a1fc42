{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Load.Amount
-- Description : How much there is in a model's file
module Dioptre.Command.Load.Amount
  ( ModelRead (..),
    Amount (..),
    modelRead,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Model.Obj (Counts (..))
import Dioptre.Source.Language (Language, inLanguage)

-- | A model's file that was read, and how much is in it.
data ModelRead = ModelRead
  { -- | As one calls it from the working directory.
    modelReadPath :: !FilePath,
    -- | Without the models in it.
    modelReadAmount :: !Amount
  }
  deriving stock (Eq, Show)

-- | In terms of its format.
data Amount
  = -- | Faces, by their corners.
    Polygons !Counts
  | -- | Primitives with a shape.
    Primitives !Int
  | -- | Pieces of curves.
    Tubes !Int
  deriving stock (Eq, Show)

-- | The same in words.
modelRead :: Language -> ModelRead -> Text
modelRead l (ModelRead path amount) =
  inLanguage l "model '" "modèle '" <> Text.pack path <> inLanguage l "' read: " "' lu\xA0: " <> case amount of
    Polygons counts ->
      Text.intercalate
        ", "
        [ number (countTriangles counts) ("triangle", "triangles") ("triangle", "triangles"),
          number (countQuads counts) ("quad", "quads") ("quadrilatère", "quadrilatères"),
          number (countPolygons counts) ("other polygon", "other polygons") ("autre polygone", "autres polygones")
        ]
    Primitives n -> number n ("primitive", "primitives") ("primitive", "primitives")
    Tubes n -> number n ("tube", "tubes") ("tube", "tubes")
  where
    number :: Int -> (Text, Text) -> (Text, Text) -> Text
    number n en fr = Text.pack (show n) <> " " <> inLanguage l (if n == 1 then fst en else snd en) (if n < 2 then fst fr else snd fr)
