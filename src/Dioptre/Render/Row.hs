{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE RankNTypes #-}
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
    Sampled (..),
    colourAt,
  )
where

import Control.Monad.ST (ST, runST)
import qualified Data.Vector as Vector
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Data.Word (Word8)
import Dioptre.Light.Colour (Colour, black, plus, scaled)
import Dioptre.Picture.Byte (Pixel (..), pixelOf)
import Dioptre.Render.Sampling (offset)
import Dioptre.Render.Shade (Seen (..), look, unlit)
import Dioptre.Render.Stage (Stage (..), Surface (..), stage)
import Dioptre.Render.Texture (Assets)
import Dioptre.Render.View (View, rayThrough, view, viewFar, viewWidth)
import Dioptre.Render.World (Closest (..), closest, worldSize)
import Dioptre.Scene (Scene (..))
import Dioptre.Scene.Camera (Viewport, viewportHeight, viewportWidth)
import Dioptre.Scene.Raytracer (PixelCoordinate (Random), Raytracer (..))

-- | A scene made ready: the view, the stage, and the pixels of surfaces as they are seen without light.
data Plan = Plan
  { planWindow :: !Window,
    planView :: !View,
    planStage :: !Stage,
    planRaytracer :: !Raytracer,
    -- | What a ray sees without light: that meets nothing, and each shape by its number; 'Nothing' where there is light, or a texture.
    planPixels :: !(Maybe Flat)
  }

-- | The pixel of the background, and of each shape.
data Flat = Flat !Pixel !(Vector.Vector Pixel)

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

-- | The plan of a scene's whole picture, given the pictures that the scene uses.
plan :: Assets -> Scene -> Plan
plan assets scene = planWithin (whole (sceneViewport scene)) assets scene

-- | The plan of a part of a scene's picture. Its pixels are those of the whole picture.
planWithin :: Window -> Assets -> Scene -> Plan
planWithin part assets scene =
  Plan
    { planWindow = part,
      planView = view (sceneCamera scene) (sceneViewport scene),
      planStage = st,
      planRaytracer = tracer,
      planPixels = if raytracerSampling tracer == 1 && plain then Just (Flat (toPixel black) (Vector.map (toPixel . surfaceDiffuse) surfaces)) else Nothing
    }
  where
    st = stage assets scene
    surfaces = stageSurfaces st
    plain = null (stageTerms st) && all (null . surfaceTextures) surfaces
    tracer = sceneRaytracer scene
    toPixel = pixelOf (raytracerColourNormalization tracer)

-- | The size in pixels of what is planned.
planWidth, planHeight :: Plan -> Int
planWidth = windowWidth . planWindow
planHeight = windowHeight . planWindow

-- | How many shapes there are to be tested.
planShapes :: Plan -> Int
planShapes = worldSize . stageWorld . planStage

-- | One row of a picture, and what it cost.
data Row = Row
  { -- | Red, green, blue, alpha of each pixel, from the left.
    rowBytes :: !(Storable.Vector Word8),
    -- | How many rays were cast.
    rowRays :: !Int,
    -- | How many times a ray was tested against a shape.
    rowTests :: !Int,
    -- | How many samples wanted more rays than are followed ("Dioptre.Render.Shade" counts them).
    rowCut :: !Int
  }
  deriving stock (Eq, Show)

-- | The row of that number, counted from 0 at the top of the plan's window. Rows depend on nothing else, so that they may be computed in any
-- order, by anyone.
row :: Plan -> Int -> Row
row p !i = case planPixels p of
  Just flat -> runRow $ \target -> flatRow p flat y target
  Nothing -> runRow $ \target -> litRow p y target
  where
    !y = windowRow (planWindow p) + i
    runRow :: (forall s. Mutable.MVector s Word8 -> ST s (Int, Int)) -> Row
    runRow fill = runST $ do
      target <- Mutable.new (4 * planWidth p)
      (rays, cut) <- fill target
      bytes <- Storable.unsafeFreeze target
      pure (Row bytes rays (rays * planShapes p) cut)

-- | A row with one ray a pixel and no light to add up: each pixel is that of the shape that the ray sees, made once.
flatRow :: Plan -> Flat -> Int -> Mutable.MVector s Word8 -> ST s (Int, Int)
flatRow p (Flat background pixels) !y target = go 0
  where
    !width = planWidth p
    !left = windowColumn (planWindow p)
    !v = planView p
    !far = viewFar v
    !w = stageWorld (planStage p)
    !(!dx, !dy) = offset (planRaytracer p) (viewWidth v) left y 0
    !random = raytracerPixelCoordinate (planRaytracer p) == Random
    go !x
      | x >= width = pure (width, 0)
      | otherwise = do
        let !sx = if random then fst (offset (planRaytracer p) (viewWidth v) (left + x) y 0) else dx
            !sy = if random then snd (offset (planRaytracer p) (viewWidth v) (left + x) y 0) else dy
        put target x $ case closest w (rayThrough v (fromIntegral (left + x) + sx) (fromIntegral y + sy)) far of
          Nowhere -> background
          At _ i -> Vector.unsafeIndex pixels i
        go (x + 1)

-- | A row with light, textures or several rays a pixel.
litRow :: Plan -> Int -> Mutable.MVector s Word8 -> ST s (Int, Int)
litRow p !y target = go 0 0 0
  where
    !width = planWidth p
    !left = windowColumn (planWindow p)
    normalization = raytracerColourNormalization (planRaytracer p)
    go !x !rays !cut
      | x >= width = pure (rays, cut)
      | otherwise = case colourAt p (left + x) y of
        Sampled colour n c -> do
          put target x (pixelOf normalization colour)
          go (x + 1) (rays + n) (cut + c)

-- | Puts a pixel into a row; its column must be one of the row's.
put :: Mutable.MVector s Word8 -> Int -> Pixel -> ST s ()
put target !x (Pixel r g b a) = do
  -- Four bytes for each of the width's columns: within the target.
  Mutable.unsafeWrite target (4 * x) r
  Mutable.unsafeWrite target (4 * x + 1) g
  Mutable.unsafeWrite target (4 * x + 2) b
  Mutable.unsafeWrite target (4 * x + 3) a
{-# INLINE put #-}

-- | The colour of a pixel before it becomes one, how many rays it took, and how many of its samples were cut.
data Sampled = Sampled !Colour {-# UNPACK #-} !Int {-# UNPACK #-} !Int
  deriving stock (Eq, Show)

-- | The colour at a column and row: that of its one sample, or else the mean of its samples, added up in their order and opaque.
colourAt :: Plan -> Int -> Int -> Sampled
colourAt p x y
  | samples == 1 = sample p x y 0
  | otherwise = total 0 black 0 0
  where
    samples = raytracerSampling (planRaytracer p)
    total !k !sum' !rays !cut
      | k >= samples = Sampled (scaled (1 / fromIntegral samples) sum') rays cut
      | otherwise = case sample p x y k of
        Sampled c n m -> total (k + 1) (sum' `plus` c) (rays + n) (cut + m)

-- | What one ray through a pixel sees.
sample :: Plan -> Int -> Int -> Int -> Sampled
sample p x y k = case stageTerms st of
  Nothing -> Sampled (unlit st (viewFar v) r) 1 0
  Just terms -> case look st terms (viewFar v) r of
    Seen colour rays cut -> Sampled colour rays (if cut then 1 else 0)
  where
    st = planStage p
    v = planView p
    !(!dx, !dy) = offset (planRaytracer p) (viewWidth v) x y k
    r = rayThrough v (fromIntegral x + dx) (fromIntegral y + dy)
