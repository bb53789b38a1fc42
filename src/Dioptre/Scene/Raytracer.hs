{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Raytracer
-- Description : How rays are cast and shaded
--
-- What is to be drawn of a scene rather than what is in it: through which points of a pixel rays go, how far they
-- branch, which terms of light are added up, and what becomes of colours that are too bright. Two properties, @task@
-- and @space@, told the original how to work; they are read and written, and change no picture.
--
-- Specification: chapter 3.
module Dioptre.Scene.Raytracer
  ( Raytracer (..),
    ReflexionAlgorithm (..),
    PixelCoordinate (..),
    Space (..),
    ColourNormalization (..),
    raytracerSchema,
    defaultRaytracer,
    algorithmName,
    mostRays,
  )
where

import Data.Text (Text)
import Dioptre.Scene.Form (choice, count)
import Dioptre.Scene.Schema (Schema (..), one)
import qualified Dioptre.Syntax.Keyword as Keyword

-- | What a scene says of its ray tracer.
data Raytracer = Raytracer
  { -- | The number of workers; kept, and without effect, as the picture does not depend on it.
    raytracerTask :: Int,
    -- | Rays through each pixel.
    raytracerSampling :: Int,
    -- | 1 for no reflected or refracted rays, 2 for one bounce, and so on.
    raytracerRecursiveLevel :: Int,
    raytracerAlgorithm :: ReflexionAlgorithm,
    raytracerPixelCoordinate :: PixelCoordinate,
    -- | How shapes are looked up; kept, and without effect on the picture.
    raytracerSpace :: Space,
    raytracerColourNormalization :: ColourNormalization,
    -- | Where random pixel coordinates start from.
    raytracerSeed :: Int
  }
  deriving stock (Eq, Show)

-- | Which terms of light are added up.
data ReflexionAlgorithm
  = NoLight
  | AmbientOnly
  | DiffuseOnly
  | PhongSpecular
  | BlinnSpecular
  | NoSpecular
  | Phong
  | Blinn
  deriving stock (Eq, Show, Enum, Bounded)

-- | Which point of a pixel its ray goes through.
data PixelCoordinate
  = TopLeft
  | TopRight
  | BottomLeft
  | BottomRight
  | Center
  | Random
  deriving stock (Eq, Show, Enum, Bounded)

-- | How the original looked shapes up.
data Space = LinearSpace | VoxelSpace | MultiVoxelSpace
  deriving stock (Eq, Show, Enum, Bounded)

-- | What becomes of channels brighter than 1.
data ColourNormalization
  = -- | Each is cut to 1.
    ClampChannel
  | -- | All three are divided by the largest.
    DivisionFactor
  deriving stock (Eq, Show, Enum, Bounded)

-- | The ray tracer of a scene that has none.
--
-- Spec: check.empty, block.raytracer.
defaultRaytracer :: Raytracer
defaultRaytracer = Raytracer 1 1 1 Blinn TopLeft LinearSpace ClampChannel 0

-- | For one primary ray no more rays than this are followed, shadow rays not counted.
--
-- Spec: optics.budget, limits.language.
mostRays :: Int
mostRays = 65536

-- | How the scene language writes a ray tracer.
--
-- Spec: block.raytracer.
raytracerSchema :: Schema Raytracer Raytracer
raytracerSchema =
  Schema
    Keyword.Raytracer
    defaultRaytracer
    [ one Keyword.Task (count 1) raytracerTask (\v r -> r {raytracerTask = v}),
      one Keyword.Sampling (count 1) raytracerSampling (\v r -> r {raytracerSampling = v}),
      one Keyword.RecursiveLevel (count 1) raytracerRecursiveLevel (\v r -> r {raytracerRecursiveLevel = v}),
      one Keyword.ReflexionAlgorithm (choice algorithms) raytracerAlgorithm (\v r -> r {raytracerAlgorithm = v}),
      one Keyword.PixelCoordinate (choice coordinates) raytracerPixelCoordinate (\v r -> r {raytracerPixelCoordinate = v}),
      one Keyword.Space (choice spaces) raytracerSpace (\v r -> r {raytracerSpace = v}),
      one Keyword.ColorNormalization (choice normalizations) raytracerColourNormalization (\v r -> r {raytracerColourNormalization = v}),
      one Keyword.Seed (count 0) raytracerSeed (\v r -> r {raytracerSeed = v})
    ]
    Nothing
    Right
    id

-- | The scene language's word for an algorithm.
algorithmName :: ReflexionAlgorithm -> Text
algorithmName = \case
  NoLight -> "no_light"
  AmbientOnly -> "ambient"
  DiffuseOnly -> "diffuse"
  PhongSpecular -> "phong_specular"
  BlinnSpecular -> "blinn_specular"
  NoSpecular -> "no_specular"
  Phong -> "phong"
  Blinn -> "blinn"

-- The position of each word is the number that the scene language accepts for it.
algorithms :: [(Text, ReflexionAlgorithm)]
algorithms = [(algorithmName a, a) | a <- [minBound ..]]

coordinates :: [(Text, PixelCoordinate)]
coordinates = zip ["top_left", "top_right", "bottom_left", "bottom_right", "center", "random"] [minBound ..]

spaces :: [(Text, Space)]
spaces = zip ["linear", "voxel", "multi_voxel"] [minBound ..]

normalizations :: [(Text, ColourNormalization)]
normalizations = zip ["clamp_channel", "division_factor"] [minBound ..]
