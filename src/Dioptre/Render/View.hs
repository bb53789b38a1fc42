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
-- The point (x, y) of the picture, in pixels from its top left corner, is P = c + r0 + u1 x + u2 y. Its ray starts
-- there, not at the eye, so that nothing in front of the near plane is seen, and goes on in the direction from the eye.
module Dioptre.Render.View
  ( View,
    view,
    viewWidth,
    viewFar,
    pointAt,
    rayThrough,
    projection,
  )
where

import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Math.Vector (Packed, Point, cross, dot, modulus, packed, unit, unpacked, vector, (*^), (^/))
import Dioptre.Scene.Camera (Camera, CameraSettings (..), Viewport, cameraFront, cameraSettings, cameraUp, viewportHeight, viewportWidth)
import Linear.V3 (V3 (..))
import Linear.V4 (V4 (..))

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
--
-- Spec: numbers.elementary, camera.size, camera.axes.
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
--
-- Spec: camera.point.
pointAt :: View -> Double -> Double -> Point
pointAt v !x !y = unpacked (viewCorner v) + x *^ unpacked (viewRight v) + y *^ unpacked (viewDown v)
{-# INLINE pointAt #-}

-- | The ray through a point of the picture. Its direction is unit.
--
-- Spec: camera.ray, camera.near.
rayThrough :: View -> Double -> Double -> Ray
rayThrough v !x !y = ray p (maybe (unpacked (viewFront v)) vector (unit (p - unpacked (viewEye v))))
  where
    !p = pointAt v x y
{-# INLINE rayThrough #-}

-- | Where a point of space is seen, as a matrix M: with (X, Y, W) = M (x, y, z, 1) it is at column X / W and row Y / W
-- of the picture, in pixels from the top left corner, and in front of the eye where W > 0.
--
-- A point is seen along the line from the eye e to it, which crosses the picture's plane at c + r0 + u1 X\/W + u2 Y\/W.
-- So p - e = X u1 + Y u2 + W k with k = c + r0 - e, and Cramer's rule gives the coordinates:
--
-- > X = (u2 x k) . (p - e) / D     Y = (k x u1) . (p - e) / D     W = (u1 x u2) . (p - e) / D     D = u1 . (u2 x k)
--
-- The three are measured in lengths of k, lest D is too small for a number where the near plane is very near.
--
-- Law: points of the ray through (x, y) are seen at (x, y).
projection :: View -> V3 (V4 Double)
projection v = rowOf <$> V3 (cross u2 k) (cross k u1) (cross u1 u2)
  where
    eye = unpacked (viewEye v)
    away = unpacked (viewCorner v) - eye
    measure = modulus away
    k = away ^/ measure
    u1 = unpacked (viewRight v) ^/ measure
    u2 = unpacked (viewDown v) ^/ measure
    determinant = dot u1 (cross u2 k)
    rowOf direction' = let V3 x y z = direction' ^/ determinant in V4 x y z (negate (dot (V3 x y z) eye))
