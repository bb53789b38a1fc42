{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=40 #-}

-- |
-- Module      : Dioptre.Render.Radiance
-- Description : The colour that a ray sees
--
-- What a ray meets first is lit ("Dioptre.Render.Shade"); a mirror adds what the reflected ray sees, and a transparent
-- body what the refracted ray sees:
--
-- > colour = lit by all lights
-- >        + kr . colour of the reflected ray
-- >        + kt . colour of the refracted ray       (tinted where it enters)
--
-- The equation is recursive (J. T. Kajiya, "The rendering equation", SIGGRAPH 1986, with mirrors and bodies alone; T.
-- Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980); the program is a loop. See Note
-- [Rays as a stack].
--
-- Specification: 7.3, 7.4 and 7.6.
module Dioptre.Render.Radiance
  ( Seen (..),
    radiance,
    unlit,
  )
where

import Dioptre.Geometry.Closest (Closest (..))
import Dioptre.Geometry.Prepared (isClosed, normalAt, shadingNormal)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Light.Colour (Colour (..), black, capped, rgb)
import Dioptre.Light.Finish (Colours (..), Finish (..), hasPictures, isTransparent)
import Dioptre.Math.Vector (Packed, PackedUnit, dot, packed, packedUnit, unpacked, unpackedUnit, vector)
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Dioptre.Render.Closest (closest)
import Dioptre.Render.Shade (Lit (..), coloursAt, lighting)
import Dioptre.Render.Stage
import Dioptre.Render.Surface (Surface (..), finishAt, surfaceAt)
import Dioptre.Render.Surroundings (refractiveIndexAt)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.Texture (Texture)
import Dioptre.Render.World (World)
import Dioptre.Scene.Raytracer (mostRays)

-- | What a ray sees, or the rays of a pixel in the mean.
data Seen = Seen
  { seenColour :: {-# UNPACK #-} !Colour,
    -- | What it took.
    seenTally :: {-# UNPACK #-} !Tally
  }
  deriving stock (Eq, Show)

-- | Without light: the diffuse colour of the first surface, as opaque as its material, or black.
--
-- Spec: light.algorithm.no-light, camera.background.
unlit :: Stage -> Double -> Ray -> Seen
unlit s far r = case closest (stageWorld s) r far of
  Closest t i tests -> Seen (maybe black (colour t i) (finishAt (stageWorld s) i)) (Tally 1 tests 0)
  where
    colour t i f
      | hasPictures f = maybe black (\surface -> diffuseOf (coloursAt surface r t)) (surfaceAt (stageWorld s) i)
      | otherwise = diffuseOf (finishColours f)

-- | With light: what the ray sees, up to the stage's depth, no farther than that from the start of each ray.
--
-- See Note [Rays as a stack], and Note [Numbers that travel] of "Dioptre.Render.Shade".
--
-- Spec: light.opaque, optics.colour, optics.background, optics.depth, optics.secondary.origin, optics.mirror,
--   optics.body.order, optics.medium.start, optics.budget, optics.budget.stack, optics.sum, camera.background.
radiance :: Stage -> Terms -> Double -> Ray -> Seen
radiance s terms !far !primary = follow (SoFar 0 0 0 0 0 0) (Pending primary 1 1 1 1 medium) Done
  where
    -- Where nothing goes on, nobody asks where it travels.
    medium
      | stageDepth s > 1 = refractiveIndexAt (stageWorld s) Nothing (origin primary)
      | otherwise = 1
    follow soFar@(SoFar followed shadows tests red' green' blue') pending@(Pending r depth wr wg wb index) rest
      | followed >= mostRays = told 1 soFar
      | otherwise = case closest (stageWorld s) r far of
        Closest t i tried -> case surfaceAt (stageWorld s) i of
          Nothing -> next (SoFar (followed + 1) shadows (tests + tried) red' green' blue') rest
          Just surface@(Surface shape f) ->
            let !at = position r t
                !outward = normalAt shape r t
                !n = shadingNormal r outward
             in case lighting s terms (coloursAt surface r t) (packed at) (packedUnit n) (packed (direction r)) of
                  Lit r' g' b' m tried' ->
                    let !soFar' = SoFar (followed + 1) (shadows + m) (tests + tried + tried') (red' + wr * r') (green' + wg * g') (blue' + wb * b')
                        !deeper = depth < stageDepth s
                        !kr = finishMirror f
                        !below
                          | deeper && isTransparent f && isClosed shape = through (stageWorld s) f i pending (packed at) (packedUnit outward) (packedUnit n) rest
                          | otherwise = rest
                     in -- The reflected ray is followed first.
                        if deeper && kr /= 0
                          then follow soFar' (Pending (ray at (reflected (direction r) n)) (depth + 1) (kr * wr) (kr * wg) (kr * wb) index) below
                          else next soFar' below
    next !soFar Done = told 0 soFar
    next !soFar (pending `Then` rest) = follow soFar pending rest
    told cut (SoFar followed shadows tests red' green' blue') = Seen (rgb red' green' blue') (Tally (followed + shadows) tests cut)

-- | What is known so far: how many rays were followed, how many shadow rays and how many tests there were, and the red,
-- green and blue that was seen.
data SoFar = SoFar {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | A ray to follow: how deep it is, the weight of what it sees in red, green and blue, and the refractive index of
-- where it travels.
data Pending = Pending {-# UNPACK #-} !Ray {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The rays that remain, the next one first.
data Remaining = Done | Then {-# UNPACK #-} !Pending !Remaining

-- | The refracted ray, if there is one, before those that remain: where a ray meets a surface with this finish, of the
-- shape with this number. The normals there are the outward one and the one that is turned against the ray.
--
-- Spec: optics.secondary.origin, optics.body.closed, optics.body.entering, optics.body.leaving, optics.body.total.
through :: World -> Finish Texture -> Int -> Pending -> Packed -> PackedUnit -> PackedUnit -> Remaining -> Remaining
through w f !i (Pending r depth wr wg wb index) !at !outward !normal !rest
  | dot v (vector (unpackedUnit outward)) > 0 =
    let kt = finishTransparency f
     in onwards (refractiveIndexAt w (Just i) p) (kt * wr) (kt * wg) (kt * wb)
  | otherwise =
    let Colour tr tg tb _ = finishTint f
     in onwards (finishIndex f) (capped (tr * wr)) (capped (tg * wg)) (capped (tb * wb))
  where
    v = direction r
    p = unpacked at
    onwards beyond r' g' b' = case refracted v (unpackedUnit normal) index beyond of
      Nothing -> rest
      Just v' -> Pending (ray p v') (depth + 1) r' g' b' beyond `Then` rest
{-# NOINLINE through #-}

-- Note [Rays as a stack]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- Unrolled, the recursion is a sum over all paths of the direct light at the path's end, weighted by the product of the
-- coefficients on the way. The loop keeps the rays that remain on a stack, with their weights, and adds to one total:
-- it takes no Haskell stack however deep the mirrors are, and it can count. Depth first, reflection before refraction,
-- so that it is known which rays are the first mostRays. The sum is the same as the recursive one up to rounding in
-- binary64, which disappears in the byte.
