{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Render.View
-- Description : From pixels to rays
--
-- Where the pixels of the viewport lie in space. The viewport stands on the near clipping plane:
--
-- >  r0 +--u1-->-----------+      H = 2 near tan (angle / 2)     its height
-- >     |                  |      L = H width / height           its width
-- >    u2        c         |      c = position + near front      its centre
-- >     v                  |      u1, u2: one pixel to the right, one pixel down
-- >     +------------------+      r0 = - u1 width / 2 - u2 height / 2
--
-- The point (x, y) of the picture, in pixels from its top left corner, is P = c + r0 + u1 x + u2 y. Its ray starts there, not at the
-- eye, so that nothing in front of the near plane is seen, and goes on in the direction from the eye.
module Dioptre.Render.View
  ( View,
    view,
    viewWidth,
    viewFar,
    pointAt,
    rayThrough,
  )
where

import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Math.Vector (Packed, Point, cross, packed, unit, unpacked, vector, (*^), (^/))
import Dioptre.Scene.Camera (Camera, CameraSettings (..), Viewport, cameraFront, cameraSettings, cameraUp, viewportHeight, viewportWidth)
import Linear.V3 (V3)

-- | A camera and a viewport, prepared.
data View = View
  { viewEye :: {-# UNPACK #-} !Packed,
    viewFront :: {-# UNPACK #-} !Packed,
    -- | c + r0.
    viewCorner :: {-# UNPACK #-} !Packed,
    -- | u1.
    viewRight :: {-# UNPACK #-} !Packed,
    -- | u2.
    viewDown :: {-# UNPACK #-} !Packed,
    -- | The width of the picture in pixels.
    viewWidth :: {-# UNPACK #-} !Int,
    -- | Rays see no farther than this from where they start.
    viewFar :: {-# UNPACK #-} !Double
  }
  deriving stock (Eq, Show)

-- | The view of a camera through a viewport.
view :: Camera -> Viewport -> View
view cam port =
  View
    { viewEye = packed eye,
      viewFront = packed front,
      viewCorner = packed (centre + (negate (w / 2) *^ u1 + negate (h / 2) *^ u2)),
      viewRight = packed u1,
      viewDown = packed u2,
      viewWidth = viewportWidth port,
      viewFar = settingFar settings
    }
  where
    settings = cameraSettings cam
    eye = settingPosition settings
    front = vector (cameraFront cam)
    near = settingNear settings
    w = fromIntegral (viewportWidth port)
    h = fromIntegral (viewportHeight port)
    height = 2 * near * tan (radians (settingAngle settings) / 2)
    width = height * w / h
    right = madeUnit (cross front (vector (cameraUp cam)))
    centre = eye + near *^ front
    u1 = (right * pure width) ^/ w
    down = madeUnit (cross front right)
    u2 = (down * pure height) ^/ h

-- | An angle in radians.
radians :: Double -> Double
radians degrees = degrees / 180 * pi

-- | A vector made unit; the vector itself where that cannot be, which a checked camera excludes.
madeUnit :: V3 Double -> V3 Double
madeUnit v = maybe v vector (unit v)

-- | The point of space at a point of the picture, in pixels from the top left corner: x to the right, y down.
pointAt :: View -> Double -> Double -> Point
pointAt v !x !y = unpacked (viewCorner v) + x *^ unpacked (viewRight v) + y *^ unpacked (viewDown v)
{-# INLINE pointAt #-}

-- | The ray through a point of the picture. Its direction is unit.
rayThrough :: View -> Double -> Double -> Ray
rayThrough v !x !y = ray p (maybe (unpacked (viewFront v)) vector (unit (p - unpacked (viewEye v))))
  where
    !p = pointAt v x y
{-# INLINE rayThrough #-}
