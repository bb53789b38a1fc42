{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Camera
-- Description : The camera, and the viewport it looks through
--
-- >                 up ^   ________
-- >                    |  |        |      the viewport: width x height pixels, at the near
-- >      position  O---+--|---> front     clipping plane, seen under the vertical angle
-- >                       |________|
-- >                      near            far
module Dioptre.Scene.Camera
  ( -- * The camera
    CameraSettings (..),
    Camera,
    camera,
    cameraSettings,
    cameraFront,
    cameraUp,
    cameraSchema,
    defaultCamera,

    -- * The viewport
    Viewport,
    viewport,
    viewportWidth,
    viewportHeight,
    viewportImage,
    viewportSchema,
    defaultViewport,
    mostPixels,
  )
where

import Data.Text (Text)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Vector (Point, Unit, Vector, alongY, alongZ, cross, modulus, unit, vector)
import Dioptre.Scene.Form (count, outputName, positive, realWithin, vectorForm, withUnit)
import Dioptre.Scene.Schema (Schema (..), one)
import Dioptre.Source.Diagnostic (Flaw (..))
import qualified Dioptre.Syntax.Keyword as Keyword
import Linear.V3 (V3 (..))

-- | What a scene says of its camera.
data CameraSettings = CameraSettings
  { settingPosition :: Point,
    settingLookAt :: Point,
    -- | Need not be orthogonal to the direction of view, nor unit.
    settingUp :: Vector,
    -- | The vertical field of view, in degrees, from 10 to 170.
    settingAngle :: Double,
    -- | The distance of the near clipping plane.
    settingNear :: Double,
    -- | Rays see as far as this from where they start.
    settingFar :: Double
  }
  deriving stock (Eq, Show)

-- | A camera that has a direction: its settings and the frame that follows from them.
data Camera = Camera
  { -- | What the scene says of it.
    cameraSettings :: CameraSettings,
    -- | From the position to what it looks at.
    cameraFront :: Unit,
    -- | Orthogonal to the front.
    cameraUp :: Unit
  }
  deriving stock (Eq, Show)

-- | The camera of some settings: front = look_at - position, up = (front x up) x front, both made unit.
--
-- Whether there is a part of up across the front is asked of up made unit, too: what is left of a long one by rounding
-- may be long.
--
-- Spec: code.nowhere-to-look, code.up-along-front, code.far-before-near, camera.front, camera.up.
camera :: CameraSettings -> Either Flaw Camera
camera s = do
  front <- directed NowhereToLook (settingLookAt s - settingPosition s)
  let f = vector front
  u <- directed UpAlongFront (settingUp s)
  _ <- directed UpAlongFront (cross (cross f (vector u)) f)
  up <- maybe (Left UpAlongFront) Right (unit (cross (cross f (settingUp s)) f))
  if settingFar s < settingNear s then Left FarBeforeNear else Right (Camera s front up)
  where
    directed flaw v
      | modulus v < smallestLength = Left flaw
      | otherwise = maybe (Left flaw) Right (unit v)

-- | The camera of a scene that has none: at the origin, looking along z, with y up.
--
-- Spec: check.empty, block.camera.
defaultCamera :: Camera
defaultCamera = Camera (CameraSettings 0 (V3 0 0 1) (V3 0 1 0) 60 1 100) alongZ alongY

-- | How the scene language writes a camera.
--
-- Spec: block.camera.
cameraSchema :: Schema CameraSettings Camera
cameraSchema =
  Schema
    Keyword.Camera
    (cameraSettings defaultCamera)
    [ one Keyword.Position vectorForm settingPosition (\v s -> s {settingPosition = v}),
      one Keyword.LookAt vectorForm settingLookAt (\v s -> s {settingLookAt = v}),
      one Keyword.Up vectorForm settingUp (\v s -> s {settingUp = v}),
      one Keyword.Angle (withUnit "degrees" (realWithin 10 170)) settingAngle (\v s -> s {settingAngle = v}),
      one Keyword.NearClippingPlane positive settingNear (\v s -> s {settingNear = v}),
      one Keyword.FarClippingPlane positive settingFar (\v s -> s {settingFar = v})
    ]
    Nothing
    camera
    cameraSettings

-- | The picture's size in pixels, and the name of its file (a number and @.png@ are added).
data Viewport = Viewport
  { -- | In pixels; at least 1.
    viewportWidth :: Int,
    -- | In pixels; at least 1.
    viewportHeight :: Int,
    -- | The name of the picture's file, without number and ending.
    viewportImage :: Text
  }
  deriving stock (Eq, Show)

-- | No picture has more pixels than this: 16384 x 16384, a gigabyte of bytes.
--
-- Spec: code.too-many-pixels, limits.language.
mostPixels :: Int
mostPixels = 16384 * 16384

-- | The viewport of that width and height, each from 1 to 2^31 - 1.
--
-- Spec: code.too-many-pixels.
viewport :: Int -> Int -> Text -> Either Flaw Viewport
viewport w h image
  | w < 1 || h < 1 = Left ZeroSize
  | toInteger w * toInteger h > toInteger mostPixels = Left (TooManyPixels mostPixels)
  | otherwise = Right (Viewport w h image)

-- | The viewport of a scene that has none.
--
-- Spec: check.empty, block.viewport.
defaultViewport :: Viewport
defaultViewport = Viewport 500 500 "image"

-- | How the scene language writes a viewport.
--
-- Spec: block.viewport.
viewportSchema :: Schema (Int, Int, Text) Viewport
viewportSchema =
  Schema
    Keyword.Viewport
    (openViewport defaultViewport)
    [ one Keyword.Width (withUnit "pixels" (count 1)) (\(w, _, _) -> w) (\w (_, h, i) -> (w, h, i)),
      one Keyword.Height (withUnit "pixels" (count 1)) (\(_, h, _) -> h) (\h (w, _, i) -> (w, h, i)),
      one Keyword.ImageFileName outputName (\(_, _, i) -> i) (\i (w, h, _) -> (w, h, i))
    ]
    Nothing
    (\(w, h, i) -> viewport w h i)
    openViewport

openViewport :: Viewport -> (Int, Int, Text)
openViewport v = (viewportWidth v, viewportHeight v, viewportImage v)
