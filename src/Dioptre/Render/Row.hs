{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.Row
-- Description : The pure function from a scene to the rows of its picture
--
-- A picture is a function of its scene, row by row: a 'Plan' is everything that the rows have in common, and 'row' is one of them, computed
-- from nothing but the plan and its number.
module Dioptre.Render.Row
  ( -- * Planning
    Plan,
    plan,
    planWithin,
    Window,
    window,
    planWidth,
    planHeight,
    planShapes,

    -- * Computing
    Row (..),
    row,
    colourAt,
  )
where

import qualified Data.Vector as Vector
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Data.Word (Word8)
import Dioptre.Light.Colour (Colour (..), black, plus, scaled)
import Dioptre.Light.Material (diffuseColour)
import Dioptre.Picture.Byte (Pixel (..), pixelOf)
import Dioptre.Render.Sampling (offset)
import Dioptre.Render.View (View, rayThrough, view, viewFar, viewWidth)
import Dioptre.Render.World (Closest (..), World, closest, world, worldMaterials, worldSize)
import Dioptre.Scene (Scene (..))
import Dioptre.Scene.Camera (Viewport, viewportHeight, viewportWidth)
import Dioptre.Scene.Raytracer (Raytracer (..))

-- | A scene made ready: the view, the world, and the colours of surfaces as they are seen without light.
data Plan = Plan
  { planWindow :: !Window,
    planView :: !View,
    planWorld :: !World,
    planRaytracer :: !Raytracer,
    -- | The colour of each shape, by its number.
    planColours :: !(Vector.Vector Colour),
    -- | What a ray sees that meets nothing, and each shape, as pixels.
    planBackground :: !Pixel,
    planPixels :: !(Vector.Vector Pixel)
  }

-- | A part of a picture: its first column and row, its width and height, in pixels. Only 'window' makes one.
data Window = Window {windowColumn :: !Int, windowRow :: !Int, windowWidth :: !Int, windowHeight :: !Int}
  deriving stock (Eq, Show)

-- | The part of a viewport's picture from a column and row on, so wide and so high; 'Nothing' unless it has pixels and lies in the picture.
window :: Viewport -> Int -> Int -> Int -> Int -> Maybe Window
window port x y w h
  | x >= 0 && y >= 0 && w > 0 && h > 0 && x <= viewportWidth port - w && y <= viewportHeight port - h = Just (Window x y w h)
  | otherwise = Nothing

-- | The whole of a viewport's picture.
whole :: Viewport -> Window
whole port = Window 0 0 (viewportWidth port) (viewportHeight port)

-- | The plan of a scene's whole picture.
plan :: Scene -> Plan
plan scene = planWithin (whole (sceneViewport scene)) scene

-- | The plan of a part of a scene's picture. Its pixels are those of the whole picture.
planWithin :: Window -> Scene -> Plan
planWithin part scene =
  Plan
    { planWindow = part,
      planView = view (sceneCamera scene) (sceneViewport scene),
      planWorld = w,
      planRaytracer = tracer,
      planColours = colours,
      planBackground = pixelOf normalization black,
      planPixels = Vector.map (pixelOf normalization) colours
    }
  where
    w = world scene
    tracer = sceneRaytracer scene
    normalization = raytracerColourNormalization tracer
    colours = Vector.map diffuseColour (worldMaterials w)

-- | The size in pixels of what is planned.
planWidth, planHeight :: Plan -> Int
planWidth = windowWidth . planWindow
planHeight = windowHeight . planWindow

-- | How many shapes there are to be tested.
planShapes :: Plan -> Int
planShapes = worldSize . planWorld

-- | One row of a picture, and what it cost.
data Row = Row
  { -- | Red, green, blue, alpha of each pixel, from the left.
    rowBytes :: !(Storable.Vector Word8),
    -- | How many rays were cast.
    rowRays :: !Int,
    -- | How many times a ray was tested against a shape.
    rowTests :: !Int
  }
  deriving stock (Eq, Show)

-- | The row of that number, counted from 0 at the top of the plan's window. Rows depend on nothing else, so that they may be computed in any order, by anyone.
row :: Plan -> Int -> Row
row p !i = Row bytes rays (rays * planShapes p)
  where
    !width = planWidth p
    !left = windowColumn (planWindow p)
    !y = windowRow (planWindow p) + i
    rays = width * raytracerSampling (planRaytracer p)
    bytes = Storable.create $ do
      target <- Mutable.new (4 * width)
      let go !x
            | x >= width = pure target
            | otherwise = case pixelAt p (left + x) y of
              Pixel r g b a -> do
                -- Four bytes for each of the width's columns: within the target.
                Mutable.unsafeWrite target (4 * x) r
                Mutable.unsafeWrite target (4 * x + 1) g
                Mutable.unsafeWrite target (4 * x + 2) b
                Mutable.unsafeWrite target (4 * x + 3) a
                go (x + 1)
      go 0

-- | The pixel at a column and row. With one ray a pixel, and no light to add, it is the pixel of the shape that the ray sees; those were
-- made from the same colours, once.
pixelAt :: Plan -> Int -> Int -> Pixel
pixelAt p x y
  | raytracerSampling tracer == 1 = case seen p x y 0 of
    Nowhere -> planBackground p
    At _ i -> Vector.unsafeIndex (planPixels p) i
  | otherwise = pixelOf (raytracerColourNormalization tracer) (colourAt p x y)
  where
    tracer = planRaytracer p
{-# INLINE pixelAt #-}

-- | The colour at a column and row, before it becomes a pixel: that of its one sample, or else the mean of its samples, added up in their
-- order and opaque.
colourAt :: Plan -> Int -> Int -> Colour
colourAt p x y
  | samples == 1 = sampleColour p x y 0
  | otherwise = scaled (1 / fromIntegral samples) (total 0 black)
  where
    samples = raytracerSampling (planRaytracer p)
    total !k !sum'
      | k >= samples = sum'
      | otherwise = total (k + 1) (sum' `plus` sampleColour p x y k)

-- | What one sample's ray sees, without light: the diffuse colour of the first surface on its way, or black.
sampleColour :: Plan -> Int -> Int -> Int -> Colour
sampleColour p x y k = case seen p x y k of
  Nowhere -> black
  At _ i -> Vector.unsafeIndex (planColours p) i

seen :: Plan -> Int -> Int -> Int -> Closest
seen p x y k = closest (planWorld p) (rayThrough v (fromIntegral x + dx) (fromIntegral y + dy)) (viewFar v)
  where
    v = planView p
    !(!dx, !dy) = offset (planRaytracer p) (viewWidth v) x y k
{-# INLINE seen #-}
