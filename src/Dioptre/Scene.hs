{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene
-- Description : A checked scene
--
-- Everything that a picture is made from. A scene has no faults left: every value is within its range, every object is
-- possible, every primitive's material exists. "Dioptre.Scene.Check" makes one from any text, fills in defaults and says so.
module Dioptre.Scene
  ( Scene (..),
    writeScene,
  )
where

import Data.Text (Text)
import Dioptre.Light.Light (Light)
import Dioptre.Light.Material (Material)
import Dioptre.Scene.Camera (Camera, Viewport, cameraSchema, viewportSchema)
import Dioptre.Scene.Lights (writeLight)
import Dioptre.Scene.Materials (writeMaterial)
import Dioptre.Scene.Primitive (Model, Primitive, modelSchema, primitiveSchema)
import Dioptre.Scene.Raytracer (Raytracer, raytracerSchema)
import Dioptre.Scene.Schema (Schema, writeObject)
import Dioptre.Scene.Shapes (writeShape)
import Dioptre.Syntax.Print (Outline (..), printOutline)

-- | A scene. Lists are in the order of the file: where two primitives are hit at the same distance the first one is seen.
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

-- | The whole scene in the scene language, with every parameter (the handout's out.txt).
--
-- Law: reading it back gives the same scene.
writeScene :: Scene -> Text
writeScene scene =
  printOutline $
    [Remark "Rendering"]
      <> [ write cameraSchema (sceneCamera scene),
           write viewportSchema (sceneViewport scene),
           write raytracerSchema (sceneRaytracer scene)
         ]
      <> [Remark "Models"]
      <> map (write modelSchema) (sceneModels scene)
      <> [Remark "Primitives"]
      <> map (write primitiveSchema) (scenePrimitives scene)
      <> [Remark "Materials"]
      <> map writeMaterial (sceneMaterials scene)
      <> [Remark "Lights"]
      <> map writeLight (sceneLights scene)
  where
    write :: Schema a b -> b -> Outline
    write = writeObject writeShape
