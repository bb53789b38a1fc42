-- |
-- Module      : Laws.Rendering
-- Description : What is true of rows and pictures
module Laws.Rendering
  ( workersDoNotMatter,
    everythingIsTallied,
    windowsAreParts,
    windowsLieInThePicture,
    rowsAreColours,
    coloursAreBruteForce,
    scenesAreUnderstood,
  )
where

import Data.IORef (atomicModifyIORef', newIORef, readIORef)
import Data.Maybe (isJust)
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Model.Library (noModels)
import Dioptre.Picture
import Dioptre.Picture.Byte (Pixel (..), pixelOf)
import Dioptre.Render
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row
import Dioptre.Render.Sampling (offset)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.World (Extent (..))
import Dioptre.Scene (sceneLights, scenePrimitives, sceneRaytracer, sceneViewport)
import Dioptre.Scene.Camera (viewportHeight, viewportWidth)
import Dioptre.Scene.Raytracer (Raytracer (..))
import Laws.Exact
import Laws.Sketch
import Test.QuickCheck
import Test.QuickCheck.Monadic (monadicIO, run)

-- | The picture does not depend on how many workers share it.
workersDoNotMatter :: Sketch -> Property
workersDoNotMatter unlit = forAll ((,) <$> lit unlit <*> chooseInt (1, 8)) $ \(s, n) -> monadicIO $ do
  let p = plan mempty noModels (sketchScene s)
  (shared, _) <- run (renderWith n (pure ()) p)
  pure (shared === rendered p)

-- | As many rays are counted as there are samples, as many tests as shapes to each, and every row is reported once.
everythingIsTallied :: Sketch -> Property
everythingIsTallied s = forAll (chooseInt (1, 8)) $ \n -> monadicIO $ do
  let p = plan mempty noModels (sketchScene s)
      (w, h) = sketchSize s
      rays = w * h * sketchSamples s
  count <- run (newIORef (0 :: Int))
  (_, tally) <- run (renderWith n (atomicModifyIORef' count (\k -> (k + 1, ()))) p)
  reported <- run (readIORef count)
  pure ((tallyRays tally, tallyTests tally, reported) === (rays, rays * length (sketchThings s), h))

-- | The picture of a window is that part of the whole picture, pixel for pixel, random ones included.
windowsAreParts :: Sketch -> Property
windowsAreParts unlit = forAll (lit unlit) $ \s -> forAll (part s) $ \(x, y, w, h) ->
  let scene = sketchScene s; everything = rendered (plan mempty noModels scene); width = fst (sketchSize s)
   in case window (sceneViewport scene) x y w h of
        Nothing -> counterexample "no window" False
        Just it ->
          let p = planWithin it mempty noModels scene
              some = rendered p
           in (planWidth p, planHeight p) === (w, h)
                .&&. (pictureWidth some, pictureHeight some) === (w, h)
                .&&. pictureBytes some === Storable.concat [Storable.slice (4 * (width * (y + i) + x)) (4 * w) (pictureBytes everything) | i <- [0 .. h - 1]]
  where
    part s = do
      let (width, height) = sketchSize s
      x <- chooseInt (0, width - 1)
      y <- chooseInt (0, height - 1)
      (,,,) x y <$> chooseInt (1, width - x) <*> chooseInt (1, height - y)

-- | A window has pixels and lies in the picture, or there is none.
windowsLieInThePicture :: Sketch -> Property
windowsLieInThePicture s = forAll ((,,,) <$> some <*> some <*> some <*> some) $ \(x, y, w, h) ->
  isJust (window port x y w h) === and [x >= 0, y >= 0, w >= 1, h >= 1, toInteger x + toInteger w <= width, toInteger y + toInteger h <= height]
  where
    port = sceneViewport (sketchScene s)
    width = toInteger (viewportWidth port)
    height = toInteger (viewportHeight port)
    some = frequency [(12, chooseInt (-1, 9)), (1, elements [minBound, maxBound])]

-- | Each pixel of a row is the pixel of the colour there, whether it was made from it or kept ready.
rowsAreColours :: Sketch -> Property
rowsAreColours unlit = forAll (lit unlit) $ \s ->
  let scene = sketchScene s
      p = plan mempty noModels scene
      how = raytracerColourNormalization (sceneRaytracer scene)
   in conjoin
        [ counterexample (show y) (Storable.toList (rowBytes (row p y)) === concat [bytes (pixelOf how colour) | x <- [0 .. planWidth p - 1], let Seen colour _ = colourAt p x y])
          | y <- [0 .. planHeight p - 1]
        ]

-- | The sketch with lights and mirrors, or without.
lit :: Sketch -> Gen Sketch
lit s = (\b -> s {sketchIsLit = b}) <$> arbitrary

bytes :: Pixel -> [Word8]
bytes (Pixel r g b a) = [r, g, b, a]

-- | The colour of a pixel is the mean of what the second ray tracer sees through the points of its samples, wherever
-- that is certain; and opaque.
--
-- A sample's colour is a product of two numbers, and a mean of n of them is a sum and a product with 1 \/ n: n + 2
-- roundings.
coloursAreBruteForce :: Sketch -> Property
coloursAreBruteForce s =
  cover 50 (certain >= 9 * length pixels `div` 10) "nearly all pixels certain" $
    cover 40 (or [a /= Background | (_, _, as) <- pixels, a <- as]) "something is seen" $
      conjoin [counterexample (show (x, y, as)) (agrees (let Seen c _ = colourAt p x y in c) colours) | (x, y, as) <- pixels, Just colours <- [mapM (sketchColour s) as]]
  where
    scene = sketchScene s
    p = plan mempty noModels scene
    (w, h) = sketchSize s
    n = sketchSamples s
    pixels = [(x, y, [answer s (fromIntegral x + dx) (fromIntegral y + dy) | k <- [0 .. n - 1], let (dx, dy) = offset (sceneRaytracer scene) w x y k]) | y <- [0 .. h - 1], x <- [0 .. w - 1]]
    certain = length [() | (_, _, as) <- pixels, Uncertain `notElem` as]
    agrees c@(Colour r g b a) colours =
      counterexample (show c) $ near r [x | (x, _, _) <- colours] && near g [x | (_, x, _) <- colours] && near b [x | (_, _, x) <- colours] && a == 1
    near computed xs = let mean = sum xs / fromIntegral n in abs (toRational computed - mean) <= gamma (n + 2) * mean

-- | The text of a sketch becomes a scene with all its things and lights.
scenesAreUnderstood :: Sketch -> Property
scenesAreUnderstood unlit = forAll (lit unlit) $ \s -> let scene = sketchScene s in length (scenePrimitives scene) === length (sketchThings s) .&&. extentShapes (planExtent (plan mempty noModels scene)) === length (sketchThings s) .&&. length (sceneLights scene) === (if sketchIsLit s then 2 else 0)
