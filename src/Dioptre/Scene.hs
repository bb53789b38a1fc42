{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene
-- Description : A checked scene
--
-- Everything that a picture is made from. A scene has no faults left: every value is within its range, every object is
-- possible, every primitive's material exists. "Dioptre.Scene.Check" makes one from any text, fills in defaults and
-- says so; there is no other way to one. What may be asked of a scene are functions, so that nothing can be put into
-- one here that was not checked.
module Dioptre.Scene
  ( Scene,

    -- * Its parts
    sceneCamera,
    sceneViewport,
    sceneRaytracer,
    sceneModels,
    scenePrimitives,
    sceneMaterials,
    sceneLights,
    sceneSolids,

    -- * Another size, another sampling
    withViewport,
    withSampling,

    -- * Writing
    writeScene,
  )
where

import qualified Data.Map.Strict as Map
import Data.Text (Text)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Light.Light (Light)
import Dioptre.Light.Material (Material)
import Dioptre.Scene.Camera (Camera, Viewport, cameraSchema, viewportSchema)
import Dioptre.Scene.Lights (writeLight)
import Dioptre.Scene.Materials (byName, writeMaterial)
import Dioptre.Scene.Model (Model, modelSchema)
import Dioptre.Scene.Primitive (Primitive (..), primitiveSchema)
import Dioptre.Scene.Raytracer (Raytracer (..), raytracerSchema)
import Dioptre.Scene.Schema (Schema, writeObject)
import Dioptre.Scene.Unchecked (Scene)
import qualified Dioptre.Scene.Unchecked as Unchecked
import Dioptre.Syntax.Print (Outline (..), printOutline)

-- | Where it is seen from.
sceneCamera :: Scene -> Camera
sceneCamera = Unchecked.sceneCamera

-- | The size and the name of its picture.
sceneViewport :: Scene -> Viewport
sceneViewport = Unchecked.sceneViewport

-- | How it is drawn.
sceneRaytracer :: Scene -> Raytracer
sceneRaytracer = Unchecked.sceneRaytracer

-- | The models that it names, in the order of the file.
sceneModels :: Scene -> [Model]
sceneModels = Unchecked.sceneModels

-- | Its own shapes, in the order of the file: where two are hit at the same distance the first one is seen.
scenePrimitives :: Scene -> [Primitive]
scenePrimitives = Unchecked.scenePrimitives

-- | Its materials, in the order of the file, and behind them those that stand in for missing ones.
sceneMaterials :: Scene -> [Material]
sceneMaterials = Unchecked.sceneMaterials

-- | Its lights, in the order of the file.
sceneLights :: Scene -> [Light]
sceneLights = Unchecked.sceneLights

-- | Its own shapes, in the order of the file, each with what its material comes to, which is worked out once for each
-- material.
--
-- Law: there are as many as primitives, as every primitive's material is there.
sceneSolids :: (Material -> a) -> Scene -> [(Shape, a)]
sceneSolids f scene = [(primitiveShape p, a) | p <- scenePrimitives scene, Just a <- [Map.lookup (primitiveMaterial p) finished]]
  where
    finished = byName [(m, f m) | m <- sceneMaterials scene]

-- | The scene in a picture of another size.
withViewport :: Viewport -> Scene -> Scene
withViewport port scene = scene {Unchecked.sceneViewport = port}

-- | The scene with so many rays through each pixel, at least 1.
withSampling :: Int -> Scene -> Scene
withSampling n scene = scene {Unchecked.sceneRaytracer = (sceneRaytracer scene) {raytracerSampling = max 1 n}}

-- | The whole scene in the scene language, with every parameter (the handout's out.txt).
--
-- Law: reading it back gives the same scene.
--
-- Spec: canonical.order, canonical.back.
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
    write = writeObject
