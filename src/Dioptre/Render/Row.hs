{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.Row
-- Description : The pure function from a scene to the rows of its picture
--
-- A picture is a function of its scene, row by row: a 'Plan' is everything that the rows have in common, and 'row' is
-- one of them, computed from nothing but the plan and its number.
--
-- >  Plan --- Window      which part of the picture
-- >   |------ View        where the camera's rays go
-- >   |------ Stage ----- World      the shapes, their finishes, and boxes around them
-- >   |        |--------- sources    the lights, ready
-- >   |        +--------- Terms      which terms of illumination count
-- >   |------ Raytracer   samples, normalisation, depth
-- >   +------ Flat        without light: each shape's pixel, made once
--
-- Specification: 8.3 and 10.2.
module Dioptre.Render.Row
  ( -- * Planning
    Plan,
    plan,
    planWithin,
    Window,
    window,
    planWidth,
    planHeight,
    planExtent,

    -- * Computing
    Row (..),
    row,
    colourAt,
  )
where

import Control.Monad.ST (ST, runST)
import qualified Data.Vector as Vector
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Storable.Mutable as Mutable
import Data.Word (Word8)
import Dioptre.Geometry.Closest (Closest (..))
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Light.Colour (black, plus, scaled)
import Dioptre.Light.Finish (Colours (..), Finish (..))
import Dioptre.Model.Library (Library)
import Dioptre.Picture.Byte (Pixel (..), pixelOf)
import Dioptre.Render.Closest (closest)
import Dioptre.Render.Radiance (Seen (..), radiance, unlit)
import Dioptre.Render.Sampling (offset)
import Dioptre.Render.Stage (Stage (..), stage)
import Dioptre.Render.Surface (finishAt)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.Texture (Assets, Texture)
import Dioptre.Render.View (View, rayThrough, view, viewFar, viewWidth)
import Dioptre.Render.World (Extent, worldExtent, worldHasPictures, worldOwn)
import Dioptre.Scene (Scene, sceneCamera, sceneRaytracer, sceneViewport)
import Dioptre.Scene.Camera (Viewport, viewportHeight, viewportWidth)
import Dioptre.Scene.Raytracer (PixelCoordinate (Random), Raytracer (..))

-- | A scene made ready: the view, the stage, and the pixels of surfaces as they are seen without light.
data Plan = Plan
  { planWindow :: !Window,
    planView :: !View,
    planStage :: !Stage,
    planRaytracer :: !Raytracer,
    -- | What a ray sees without light; 'Nothing' where there is light, or a texture, or more than one ray a pixel. See
    -- Note [Pixels made once].
    planPixels :: !(Maybe Flat)
  }

-- | Pixels made once: that of the background, those of the scene's own shapes by their numbers, and how to find those
-- of models.
data Flat = Flat !Pixel !(Vector.Vector Pixel) !(Int -> Pixel)

-- | A part of a picture: its first column and row, its width and height, in pixels. Only 'window' makes one.
data Window = Window {windowColumn :: !Int, windowRow :: !Int, windowWidth :: !Int, windowHeight :: !Int}
  deriving stock (Eq, Show)

-- | The part of a viewport's picture from a column and row on, so wide and so high; 'Nothing' unless it has pixels and
-- lies in the picture.
--
-- Spec: cli.render.crop.
window :: Viewport -> Int -> Int -> Int -> Int -> Maybe Window
window port x y w h
  | x >= 0 && y >= 0 && w > 0 && h > 0 && x <= viewportWidth port - w && y <= viewportHeight port - h = Just (Window x y w h)
  | otherwise = Nothing

-- | The whole of a viewport's picture.
whole :: Viewport -> Window
whole port = Window 0 0 (viewportWidth port) (viewportHeight port)

-- | The plan of a scene's whole picture, given the pictures and the models that the scene uses.
plan :: Assets -> Library Texture -> Scene -> Plan
plan assets library scene = planWithin (whole (sceneViewport scene)) assets library scene

-- | The plan of a part of a scene's picture. Its pixels are those of the whole picture.
--
-- Spec: camera.independent.
planWithin :: Window -> Assets -> Library Texture -> Scene -> Plan
planWithin part assets library scene =
  Plan
    { planWindow = part,
      planView = view (sceneCamera scene) (sceneViewport scene),
      planStage = st,
      planRaytracer = tracer,
      planPixels = if raytracerSampling tracer == 1 && null (stageTerms st) && not (worldHasPictures w) then Just (Flat (toPixel black) (Vector.generate (worldOwn w) pixelAt) pixelAt) else Nothing
    }
  where
    st = stage assets library scene
    w = stageWorld st
    pixelAt = maybe (toPixel black) (toPixel . diffuseOf . finishColours) . finishAt w
    tracer = sceneRaytracer scene
    toPixel = pixelOf (raytracerColourNormalization tracer)

-- | The size in pixels of what is planned.
planWidth, planHeight :: Plan -> Int
planWidth = windowWidth . planWindow
planHeight = windowHeight . planWindow

-- | How large the world is.
planExtent :: Plan -> Extent
planExtent = worldExtent . stageWorld . planStage

-- | One row of a picture, and what it cost.
data Row = Row
  { -- | Red, green, blue, alpha of each pixel, from the left.
    rowBytes :: !(Storable.Vector Word8),
    rowTally :: !Tally
  }
  deriving stock (Eq, Show)

-- | The row of that number, counted from 0 at the top of the plan's window. Rows depend on nothing else, so that they
-- may be computed in any order, by anyone.
--
-- Spec: camera.every-pixel.
row :: Plan -> Int -> Row
row p !i = case planPixels p of
  Just flat -> runRow $ \target -> flatRow p flat y target
  Nothing -> runRow $ \target -> litRow p y target
  where
    !y = windowRow (planWindow p) + i
    runRow :: (forall s. Mutable.MVector s Word8 -> ST s Tally) -> Row
    runRow fill = runST $ do
      target <- Mutable.new (4 * planWidth p)
      tally <- fill target
      bytes <- Storable.unsafeFreeze target
      pure (Row bytes tally)

-- | A row with one ray a pixel and no light to add up: each pixel is that of the shape that the ray sees.
--
-- Law: its pixels are those of 'colourAt'.
flatRow :: Plan -> Flat -> Int -> Mutable.MVector s Word8 -> ST s Tally
flatRow p (Flat background pixels pixelAt) !y target = go 0 0
  where
    !width = planWidth p
    !left = windowColumn (planWindow p)
    !v = planView p
    !far = viewFar v
    !w = stageWorld (planStage p)
    !(!dx, !dy) = offset (planRaytracer p) (viewWidth v) left y 0
    !random = raytracerPixelCoordinate (planRaytracer p) == Random
    go !x !tests
      | x >= width = pure (Tally width tests 0)
      | otherwise = do
        let !(!sx, !sy) = if random then offset (planRaytracer p) (viewWidth v) (left + x) y 0 else (dx, dy)
        case closest w (rayThrough v (fromIntegral (left + x) + sx) (fromIntegral y + sy)) far of
          Closest _ i tried -> do
            put target x (if i < 0 then background else if i < Vector.length pixels then Vector.unsafeIndex pixels i else pixelAt i)
            go (x + 1) (tests + tried)

-- | A row with light, textures or several rays a pixel.
litRow :: Plan -> Int -> Mutable.MVector s Word8 -> ST s Tally
litRow p !y target = case stageTerms st of
  Nothing -> across (unlit st (viewFar v))
  Just terms -> across (radiance st terms (viewFar v))
  where
    !width = planWidth p
    !left = windowColumn (planWindow p)
    !v = planView p
    !st = planStage p
    !tracer = planRaytracer p
    !normalization = raytracerColourNormalization tracer
    across see = go 0 0 0 0
      where
        go !x !rays !tests !cut
          | x >= width = pure (Tally rays tests cut)
          | otherwise = case sampled tracer v see (left + x) y of
            Seen colour (Tally n m c) -> do
              put target x (pixelOf normalization colour)
              go (x + 1) (rays + n) (tests + m) (cut + c)
    {-# INLINE across #-}

-- | Puts a pixel into a row; its column must be one of the row's.
put :: Mutable.MVector s Word8 -> Int -> Pixel -> ST s ()
put target !x (Pixel r g b a) = do
  -- Four bytes for each of the width's columns: within the target.
  Mutable.unsafeWrite target (4 * x) r
  Mutable.unsafeWrite target (4 * x + 1) g
  Mutable.unsafeWrite target (4 * x + 2) b
  Mutable.unsafeWrite target (4 * x + 3) a
{-# INLINE put #-}

-- | The colour at a column and row, before it becomes a pixel: that of its one sample, or else the mean of its samples, added up in their order
-- and opaque.
--
-- Spec: camera.sampling.one, camera.sampling.mean, camera.sampling.opaque, camera.sampling.fixed.
colourAt :: Plan -> Int -> Int -> Seen
colourAt p = sampled (planRaytracer p) v (maybe (unlit st) (radiance st) (stageTerms st) (viewFar v))
  where
    st = planStage p
    v = planView p

-- | The same, given what a ray sees.
sampled :: Raytracer -> View -> (Ray -> Seen) -> Int -> Int -> Seen
sampled tracer v see x y
  | samples == 1 = sample 0
  | otherwise = total 0 black 0 0 0
  where
    samples = raytracerSampling tracer
    total !k !sum' !rays !tests !cut
      | k >= samples = Seen (scaled (1 / fromIntegral samples) sum') (Tally rays tests cut)
      | otherwise = case sample k of
        Seen c (Tally n m l) -> total (k + 1) (sum' `plus` c) (rays + n) (tests + m) (cut + l)
    -- What one ray through the pixel sees.
    sample k = see (rayThrough v (fromIntegral x + dx) (fromIntegral y + dy))
      where
        !(!dx, !dy) = offset tracer (viewWidth v) x y k
{-# INLINE sampled #-}

-- Note [Pixels made once]
-- ~~~~~~~~~~~~~~~~~~~~~~~
-- Without light a ray sees one colour on the whole of a shape, the diffuse one, unless a picture stands in for it. So
-- all pixels there can be are known beforehand, one for each shape and one for the background; a row only asks what is
-- met first, and copies four bytes. By colours, each would be capped and rounded to bytes again for every pixel.
