{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Scene.Unchecked
-- Description : What a scene is made of
--
-- The record behind a scene, with its constructor: whoever has that can make a scene with faults. Only
-- "Dioptre.Scene.Check", which makes scenes, and "Dioptre.Scene", which gives the rest of the program what may be asked
-- of one, import this module; a test says so.
module Dioptre.Scene.Unchecked
  ( Scene (..),
  )
where

import Dioptre.Light.Light (Light)
import Dioptre.Light.Material (Material)
import Dioptre.Scene.Camera (Camera, Viewport)
import Dioptre.Scene.Model (Model)
import Dioptre.Scene.Primitive (Primitive)
import Dioptre.Scene.Raytracer (Raytracer)

-- | A scene. Lists are in the order of the file: where two primitives are hit at the same distance the first one is
-- seen.
--
-- Invariant: every primitive's material is one of the materials, by name; of several of one name the first.
data Scene = Scene
  { sceneCamera :: Camera,
    sceneViewport :: Viewport,
    sceneRaytracer :: Raytracer,
    sceneModels :: [Model],
    scenePrimitives :: [Primitive],
    sceneMaterials :: [Material],
    sceneLights :: [Light]
  }
  deriving stock (Eq, Show)
