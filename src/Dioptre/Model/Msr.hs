{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Model.Msr
-- Description : Models in the scene language
--
-- An MSR file is a scene without camera, picture and lights: primitives, their materials, and other models.
--
-- > primitive                         model
-- >   material_name paint               file  ball.msr
-- >   sphere                            scale [0.5, 0.5, 0.5]
-- >   end                             end
-- > end
-- >
-- > material
-- >   name paint
-- > end
--
-- Its materials are its own: a scene's material of the same name is another one.
module Dioptre.Model.Msr
  ( Msr (..),
    readMsr,
  )
where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Vector as Vector
import Dioptre.Light.Finish (finish)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Scene.Check (Mention, ModelFile (..), checkModelFile, pictureNames)
import Dioptre.Scene.Materials (byName)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Source.Diagnostic (Diagnostic, FileUse (ForTexture))
import Dioptre.Source.Span (Span)
import Dioptre.Syntax.Tree (Tree)

-- | What an MSR file says.
data Msr = Msr
  { -- | Models are known by where they are named, pictures by their names.
    msrContent :: Content Mention Text,
    -- | The pictures that its materials name, and where.
    msrPictures :: [(Text, Span)],
    -- | What is wrong with it, in its order.
    msrDiagnostics :: [Diagnostic]
  }
  deriving stock (Eq, Show)

-- | The model that a tree describes. Total, as 'Dioptre.Scene.Check.checkScene' is: what cannot be used is told and
-- left out.
--
-- Spec: models.materials, models.msr.
readMsr :: Tree -> Msr
readMsr tree =
  Msr
    { msrContent = Content (concatMap part (modelFileParts file)) (Vector.fromList (map finish materials)),
      msrPictures = [(name, place) | (name, ForTexture, place) <- pictureNames tree],
      msrDiagnostics = diagnostics
    }
  where
    (file, diagnostics) = checkModelFile tree
    materials = modelFileMaterials file
    numbers = byName (zip materials [0 ..])
    part (Left mention) = [Nested mention]
    part (Right p) = [Solid (primitiveShape p) n | Just n <- [Map.lookup (primitiveMaterial p) numbers]]
