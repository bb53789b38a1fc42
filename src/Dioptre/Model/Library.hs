{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Model.Library
-- Description : The models that a scene needs
--
-- Each model once, however often the scene or other models name it: what repeats is an 'Instance', a number and a
-- transformation.
module Dioptre.Model.Library
  ( Library (..),
    Instance (..),
    noModels,
  )
where

import Data.Vector (Vector)
import qualified Data.Vector as Vector
import Dioptre.Math.Transform (Transform)
import Dioptre.Model.Content (Content)

-- | Models whose pictures and parts have been found.
--
-- Invariant: a model's parts are instances of models with lower numbers, so that nothing contains itself.
data Library picture = Library
  { -- | The models, by their numbers from 0.
    libraryModels :: Vector (Content Instance picture),
    -- | What the scene has of them, in its order. Models that could not be read are left out.
    libraryInstances :: [Instance]
  }
  deriving stock (Eq, Show)

-- | A model somewhere.
data Instance = Instance
  { -- | The model's number in the library.
    instanceModel :: Int,
    -- | From the model's own frame to that of what it is in.
    instanceTransform :: Transform
  }
  deriving stock (Eq, Show)

-- | What a scene without models has.
noModels :: Library picture
noModels = Library Vector.empty []
