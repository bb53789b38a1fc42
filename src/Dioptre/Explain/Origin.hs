-- |
-- Module      : Dioptre.Explain.Origin
-- Description : From numbers to what was written
--
-- The world numbers all shapes, the scene's primitives first and those of its models behind them
-- ("Dioptre.Render.World"). This is the way back: which primitive, or which shape of which model, a number means, and
-- through which frames a ray comes to it.
module Dioptre.Explain.Origin
  ( Directory,
    directory,
    Found (..),
    find,
  )
where

import Data.Maybe (fromMaybe, isJust)
import Data.Text (Text)
import Data.Vector (Vector, (!?))
import qualified Data.Vector as Vector
import Dioptre.Explain.Story (Thing (..), Whereabouts (..))
import Dioptre.Geometry.Mesh (meshSize)
import Dioptre.Geometry.Placement (Placement, placement)
import Dioptre.Geometry.Prepared (prepare)
import Dioptre.Geometry.PreparedMesh (triangleShape)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Math.Transform (identity)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..))
import Dioptre.Scene (Scene, scenePrimitives)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Syntax.Keyword (Keyword)
import qualified Dioptre.Syntax.Keyword as Keyword

-- | What is needed to find a shape by its number.
data Directory picture = Directory
  { primitives :: Vector (Int, Primitive),
    library :: Library picture,
    -- | How many numbers each model takes.
    sizes :: Vector Int,
    files :: Vector Text
  }

-- | A shape as it was written, and the frames around it, the outermost first.
data Found = Found
  { -- | What it is called.
    foundThing :: Thing,
    -- | From the world's frame inwards.
    foundFrames :: [Placement],
    -- | As it was written.
    foundShape :: Shape
  }

-- | The directory of a scene and its models, with the names of the models' files by the models' numbers.
directory :: [Text] -> Library picture -> Scene -> Directory picture
directory names models scene =
  Directory
    { primitives = Vector.fromList [(i, p) | (i, p) <- zip [0 ..] (scenePrimitives scene), isJust (prepare (primitiveShape p))],
      library = models,
      sizes = known,
      files = Vector.fromList names
    }
  where
    -- A model is made of models with lower numbers.
    known = Vector.map (sum . map partSize . parts) (libraryModels models)
    partSize part = case part of
      Solid _ _ -> 1
      Faces mesh -> meshSize mesh
      Nested i -> sizeOf known i

sizeOf :: Vector Int -> Instance -> Int
sizeOf known i = fromMaybe 0 (known !? instanceModel i)

-- | A model's parts in the order of their numbers: its own shapes before what is nested in it.
parts :: Content Instance picture -> [Part Instance]
parts content = [p | p@(Solid shape k) <- contentParts content, isJust (contentFinishes content !? k), isJust (prepare shape)] <> [p | p <- contentParts content, not (isSolid p)]
  where
    isSolid (Solid _ _) = True
    isSolid _ = False

-- | The shape of a number from 0 to below the world's size; 'Nothing' elsewhere.
--
-- Law: it is the one that the world has under that number.
find :: Directory picture -> Int -> Maybe Found
find d number = case primitives d !? number of
  Just (i, p) -> Just (found number (OfScene i) (Just (primitiveMaterial p)) [] (primitiveShape p))
  Nothing -> inInstances d number [] (number - Vector.length (primitives d)) (libraryInstances (library d))

found :: Int -> Whereabouts -> Maybe Text -> [Placement] -> Shape -> Found
found number at material frames shape =
  Found
    { foundThing = Thing number at (kindOf shape) (not (null frames) || isTransformed shape) material,
      foundFrames = frames,
      foundShape = shape
    }

-- | Among instances, after so many numbers.
inInstances :: Directory picture -> Int -> [Placement] -> Int -> [Instance] -> Maybe Found
inInstances d number frames rest instances = case instances of
  i : others
    | rest < 0 -> Nothing
    | rest < sizeOf (sizes d) i -> inInstance d number frames rest i
    | otherwise -> inInstances d number frames (rest - sizeOf (sizes d) i) others
  [] -> Nothing

inInstance :: Directory picture -> Int -> [Placement] -> Int -> Instance -> Maybe Found
inInstance d number frames inner i = libraryModels (library d) !? instanceModel i >>= among 0 inner . parts
  where
    frames' = frames <> [placement (instanceTransform i) | instanceTransform i /= identity]
    here k = OfModel (instanceModel i) k (files d !? instanceModel i)
    -- The shapes and triangles of the file itself are counted as they come.
    among _ _ [] = Nothing
    among before k (part : others) = case part of
      Solid shape _
        | k == 0 -> Just (found number (here before) Nothing frames' shape)
        | otherwise -> among (before + 1) (k - 1) others
      Faces mesh
        | k < meshSize mesh -> found number (here (before + k)) Nothing frames' <$> triangleShape mesh k
        | otherwise -> among (before + meshSize mesh) (k - meshSize mesh) others
      Nested nested
        | k < sizeOf (sizes d) nested -> inInstance d number frames' k nested
        | otherwise -> among before (k - sizeOf (sizes d) nested) others

-- | The word for a shape; for a transformed one, for what is transformed.
kindOf :: Shape -> Keyword
kindOf shape = case shape of
  APlane _ -> Keyword.Plane
  ADisk _ -> Keyword.Disk
  AnAnnulus _ -> Keyword.Annulus
  ASphere _ -> Keyword.Sphere
  ACube _ -> Keyword.Cube
  ATriangle _ -> Keyword.Triangle
  ASmoothTriangle _ -> Keyword.SmoothTriangle
  ATube _ -> Keyword.Tube
  ACylinder _ -> Keyword.Cylinder
  ACone _ -> Keyword.Cone
  ALens _ -> Keyword.Lens
  ACap _ -> Keyword.SphericalCap
  ATorus _ -> Keyword.Torus
  ATransformed _ inner -> kindOf inner

isTransformed :: Shape -> Bool
isTransformed shape = case shape of
  ATransformed _ _ -> True
  _ -> False
