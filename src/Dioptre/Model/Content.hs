{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Model.Content
-- Description : What a model's file holds
--
-- The four formats of models come to one thing: shapes with finishes, meshes of triangles, and other models that they
-- name. It is in the frame of the file; where a scene puts it, and how often, is the scene's affair.
module Dioptre.Model.Content
  ( Content (..),
    Part (..),
  )
where

import Data.Vector (Vector)
import Dioptre.Geometry.Mesh (Mesh)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Light.Finish (Finish)

-- | The parts of a model, in the order of its file, and their finishes. As a file has them, other models and pictures
-- are known by name, @Content Model Text@; in a "Dioptre.Model.Library" they have been found.
--
-- Invariants: every number of a finish is below the number of finishes; the finishes of meshes let no light through
-- (the formats that have meshes do not know transparency).
data Content nested picture = Content
  { contentParts :: [Part nested],
    contentFinishes :: Vector (Finish picture)
  }
  deriving stock (Eq, Show)

-- | A part of a model.
data Part nested
  = -- | A shape, and the number of its finish.
    Solid Shape Int
  | -- | Many triangles, each with the number of its finish.
    Faces Mesh
  | -- | Another model.
    Nested nested
  deriving stock (Eq, Show, Functor, Foldable, Traversable)
