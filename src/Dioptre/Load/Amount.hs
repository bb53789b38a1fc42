{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Load.Amount
-- Description : How much there is in a model's file
--
-- What the log says of a model that was read: so many triangles, primitives or tubes, each format counting what it is
-- made of. It is kept beside the library, in which nothing of it can be seen any more: polygons have become triangles
-- there.
module Dioptre.Load.Amount
  ( ModelRead (..),
    Amount (..),
  )
where

import Dioptre.Model.Obj (Counts (..))

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
