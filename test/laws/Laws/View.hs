-- |
-- Module      : Laws.View
-- Description : What is true of the rays that leave a camera, and of the points of pixels that they go through
module Laws.View
  ( Seen (..),
    seenView,
    raysComeFromTheEye,
    raysStartOnTheNearPlane,
    centreIsAhead,
    middleIsTheCentre,
    pixelsAreSquare,
    rightIsRightAndDownIsDown,
    anglesAreTheCameras,
    projectionIsTheWayBack,
    offsetIsItsCorner,
    uniformIsExact,
    uniformIsBelowOne,
    randomOffsetsAreNumbered,
  )
where

import Data.Bits (shiftR, xor)
import qualified Data.Text as Text
import Data.Word (Word64)
import Dioptre.Geometry.Ray (direction, origin)
import Dioptre.Math.Vector
import Dioptre.Render.Sampling (offset, uniform)
import Dioptre.Render.View
import Dioptre.Scene.Camera
import Dioptre.Scene.Raytracer (PixelCoordinate (..), Raytracer (..), defaultRaytracer)
import Laws.Draw
import Laws.Exact
import Linear.V3 (V3 (..))
import Linear.V4 (V4 (..))
import Test.QuickCheck hiding (vector)

-- | A camera, a viewport, and a point of the picture in pixels.
data Seen = Seen Camera Viewport (Double, Double)
  deriving (Eq, Show)

instance Arbitrary Seen where
  arbitrary = do
    kind <- anyKind
    eye <- point kind
    forward <- step kind
    up <- step kind
    angle' <- oneof [elements [10, 45, 60, 90, 170], (\f -> 10 + 160 * f) <$> fraction]
    near <- elements [1, 0.1, 3]
    w <- oneof [chooseInt (1, 9), chooseInt (1, 2000)]
    h <- oneof [chooseInt (1, 9), chooseInt (1, 2000)]
    at <- (,) <$> place w <*> place h
    let made = camera (CameraSettings eye (eye + forward) up angle' near (near + 100))
    case (made, viewport w h Text.empty) of
      (Right c, Right v) | parted forward up -> pure (Seen c v at)
      _ -> discard
    where
      place n = oneof [fromIntegral <$> chooseInt (0, n), (* fromIntegral n) <$> fraction, (+ 0.5) . fromIntegral <$> chooseInt (0, n - 1)]
      -- An angle of 2^-10 at least between front and up: what is up must be certain.
      parted a b = squared (outer (exact a) (exact b)) * 2 ^ (20 :: Int) > squared (exact a) * squared (exact b)

-- | The view through the viewport.
seenView :: Seen -> View
seenView (Seen c v _) = view c v

-- | How far a computed point of the picture may be from the exact one, in each component: 32 eps of the numbers that
-- it is made of.
--
-- A point is the sum of five vectors: the eye, near front, and shares of the picture's width and height to the left,
-- up, right and down, none of which is longer than the whole width and height. Factors have at most 8 roundings (the
-- tangent and its angle, the width, the unit direction, the share) and the sums 5. Directions are outer products of
-- unit vectors that are orthogonal up to their own roundings, 2 of each term: 8 eps, and twice that for the second
-- one. Together 8 + 5 + 16 eps, and the second order.
slack :: Seen -> Rational
slack (Seen c v _) = 32 * eps * (magnitude (exact (settingPosition s)) + extent)
  where
    s = cameraSettings c
    height = 2 * settingNear s * tan (settingAngle s / 360 * pi)
    extent = 2 * toRational (settingNear s + height + height * fromIntegral (viewportWidth v) / fromIntegral (viewportHeight v))

-- | The direction of a ray is unit, and leads from the eye to where the ray starts: w = o - eye is rounded once in
-- each component and divided by its length, so that d x w is at most gamma 4 of its terms.
raysComeFromTheEye :: Seen -> Property
raysComeFromTheEye seen@(Seen c _ (x, y)) =
  counterexample (show r) $
    fmap valid (unit (direction r)) === Just True
      .&&. abs (squared d - 1) <= 10 * eps
      .&&. and [abs e <= gamma 4 * b | (e, b) <- zip (components (outer d w)) (components (outerMagnitudes d w))]
      .&&. inner d w > 0
  where
    r = rayThrough (seenView seen) x y
    d = exact (direction r)
    w = exact (origin r) - exact (settingPosition (cameraSettings c))

-- | Rays start on the near clipping plane: the eye, and near along the front.
raysStartOnTheNearPlane :: Seen -> Property
raysStartOnTheNearPlane seen@(Seen c _ (x, y)) =
  counterexample (show (fromRational ahead :: Double)) $ abs (ahead - toRational (settingNear s)) <= 3 * slack seen
  where
    s = cameraSettings c
    ahead = inner (exact (vector (cameraFront c))) (exact (origin (rayThrough (seenView seen) x y)) - exact (settingPosition s))

-- | The middle of the picture is straight ahead, whether the picture's size is even or odd.
centreIsAhead :: Seen -> Property
centreIsAhead seen@(Seen c v _) = counterexample (show p) $ and [abs e <= slack seen | e <- components (exact p - ahead)]
  where
    s = cameraSettings c
    p = pointAt (seenView seen) (fromIntegral (viewportWidth v) / 2) (fromIntegral (viewportHeight v) / 2)
    ahead = along (exact (settingPosition s)) (exact (vector (cameraFront c))) (toRational (settingNear s))

-- | The middle of the picture is c: to the bit in each coordinate in which at most one of c, u1 and u2 is not zero; in
-- the others within 2^-49 of the greatest of c, a = w\/2 u1 and b = h\/2 u2.
--
-- With e = 2^-53, r0 is wrong by e |a + b| at most, c + r0 by e |c + r0|, the sum with a by e |c - b|, and the one with
-- b by e |c|: together 8 e of the greatest, and the second order.
middleIsTheCentre :: Seen -> Property
middleIsTheCentre seen@(Seen cam port _) = counterexample (show (p, c, a, b)) (and (sameWhere <$> p <*> c <*> a <*> b))
  where
    s = cameraSettings cam
    front = vector (cameraFront cam)
    w = fromIntegral (viewportWidth port)
    h = fromIntegral (viewportHeight port)
    p = pointAt (seenView seen) (w / 2) (h / 2)
    c = settingPosition s + settingNear s *^ front
    height = 2 * settingNear s * tan (settingAngle s / 180 * pi / 2)
    right = cross front (vector (cameraUp cam))
    a = (height * w / h / 2) *^ toUnit right
    b = (height / 2) *^ toUnit (cross front (toUnit right))
    toUnit v = maybe v vector (unit v)
    sameWhere p' c' a' b'
      | length (filter (/= 0) [c', a', b']) <= 1 = p' == c'
      | otherwise = abs (toRational p' - toRational c') <= maximum (map (abs . toRational) [c', a', b']) / 2 ^ (49 :: Int)

-- | Pixels are square: a step of a pixel to the right is as long as one down, 2 near tan (angle \/ 2) \/ height, and
-- at a right angle to it.
pixelsAreSquare :: Seen -> Property
pixelsAreSquare seen@(Seen c v (x, y)) =
  counterexample (show (fromRational side :: Double, right, down)) $
    near right .&&. near down .&&. abs (inner (exact right) (exact down)) <= side * 6 * slack seen + 12 * slack seen ^ (2 :: Int)
  where
    s = cameraSettings c
    side = toRational (2 * settingNear s * tan (settingAngle s / 360 * pi) / fromIntegral (viewportHeight v))
    (right, down) = steps seen x y
    near w = counterexample (show w) $ rootAbove (squared (exact w)) <= side + 4 * slack seen && rootBelow (squared (exact w)) >= side - 4 * slack seen

-- | One pixel to the right goes where front x up points, and one pixel down goes against up.
rightIsRightAndDownIsDown :: Seen -> Property
rightIsRightAndDownIsDown seen@(Seen c v _) = toTheRight .&&. downwards
  where
    w = fromIntegral (viewportWidth v)
    h = fromIntegral (viewportHeight v)
    across = exact (pointAt (seenView seen) w 0) - exact (pointAt (seenView seen) 0 0)
    below = exact (pointAt (seenView seen) 0 h) - exact (pointAt (seenView seen) 0 0)
    front = exact (vector (cameraFront c))
    up = exact (settingUp (cameraSettings c))
    toTheRight = counterexample "right" (inner across (outer front up) > 0)
    downwards = counterexample "down" (inner below up < 0)

steps :: Seen -> Double -> Double -> (Vector, Vector)
steps seen x y = (pointAt v (x + 1) y - pointAt v x y, pointAt v x (y + 1) - pointAt v x y)
  where
    v = seenView seen

-- | From the eye, the middle of the upper edge is the camera's angle away from that of the lower one.
anglesAreTheCameras :: Seen -> Property
anglesAreTheCameras seen@(Seen c v _) =
  counterexample (show (seenAngle, wanted)) $ abs (toRational seenAngle - toRational wanted) <= 8 * slack seen / toRational (settingNear s) + 16 * eps
  where
    s = cameraSettings c
    w = fromIntegral (viewportWidth v) / 2
    from y = pointAt (seenView seen) w y - settingPosition s
    seenAngle = angle (from 0) (from (fromIntegral (viewportHeight v)))
    wanted = settingAngle s / 180 * pi

-------------------------------------------------------------------------------
-- Points of a pixel

-- | A point that is some way along a pixel's ray is seen at the pixel's place, and in front of the eye; the one as far
-- behind the eye is behind it.
--
-- A row of the matrix is a vector product of two of u1, u2, k, by the determinant, which is the same number in all
-- three and goes out of the quotients. A product's error is a few eps of its factors' lengths, which are at most kappa
-- times the product's own: kappa = |k| / near is how much longer the way to the picture's corner is than the way to its
-- plane, and so 1 by the least sine between u1 or u2 and k. The pixel's place in space is the corner and shares of u1
-- and u2, each no longer than kappa near, so its error is a few eps of kappa times its own length and the eye's; a
-- point that is so many times as far away has as many times that error. All in all less than 32 roundings in a row, of
-- |row| times all these lengths; the other row's count as often as the place says.
projectionIsTheWayBack :: Seen -> Property
projectionIsTheWayBack seen@(Seen c _ (x, y)) = forAll ((2 **) <$> choose (0, 10)) $ \far ->
  let v = seenView seen
      eye = settingPosition (cameraSettings c)
      there = pointAt v x y
      away = there - eye
      at side = eye + (side * far) *^ away
      V3 across down ahead = projection v
      seenAt p = let w = times ahead p in (times across p / w, times down p / w, w)
      times (V4 a b d e) (V3 px py pz) = a * px + b * py + d * pz + e
      kappa = modulus (pointAt v 0 0 - eye) / settingNear (cameraSettings c)
      size (V4 a b d _) p = modulus (V3 a b d) * (modulus p + modulus eye + far * (modulus there + modulus eye))
      room row' place p w = 2 ^^ (-47 :: Int) * kappa * (size row' p + abs place * size ahead p) / abs w
      close p =
        let (x', y', w) = seenAt p
         in counterexample (show (p, (x', y', w))) (abs (x' - x) <= room across x p w .&&. abs (y' - y) <= room down y p w)
      (_, _, before) = seenAt (at 1)
      (_, _, behind) = seenAt (at (-1))
   in conjoin [close (at 1), close (at (-1)), property (before > 0), property (behind < 0)]

-- | Every sample of every pixel goes through the same point, unless it is random.
offsetIsItsCorner :: Property
offsetIsItsCorner = forAll ((,,,) <$> column <*> column <*> column <*> chooseInt (1, 9)) $ \(x, y, k, n) ->
  [offset defaultRaytracer {raytracerPixelCoordinate = c, raytracerSampling = n} 1000 x y k | c <- [TopLeft, TopRight, BottomLeft, BottomRight, Center]]
    === [(0, 0), (1, 0), (0, 1), (1, 1), (0.5, 0.5)]
  where
    column = chooseInt (0, 999)

-- | The numbers are SplitMix64's, computed once more with integers of any size.
uniformIsExact :: Word64 -> Word64 -> Property
uniformIsExact seed i = forAll (elements [0, 1, 2 ^ (63 :: Int), maxBound]) $ \base ->
  toRational (uniform (seed + base) (i * 1099511628211)) === fromInteger (number' (seed + base) (i * 1099511628211)) / 2 ^ (53 :: Int)
  where
    number' s k = mixed ((mixed (toInteger s) + (toInteger k + 1) * 0x9E3779B97F4A7C15) `mod` 2 ^ (64 :: Int)) `shiftR` 11
    mixed z0 =
      let z1 = ((z0 `xor` (z0 `shiftR` 30)) * 0xBF58476D1CE4E5B9) `mod` 2 ^ (64 :: Int)
          z2 = ((z1 `xor` (z1 `shiftR` 27)) * 0x94D049BB133111EB) `mod` 2 ^ (64 :: Int)
       in z2 `xor` (z2 `shiftR` 31)

-- | They are at least 0 and less than 1.
uniformIsBelowOne :: Word64 -> Word64 -> Property
uniformIsBelowOne seed i = counterexample (show u) (u >= 0 && u < 1)
  where
    u = uniform seed i

-- | The numbers of a seed are dealt out one by one: row by row, in a row pixel by pixel, in a pixel sample by sample,
-- first across and then down.
randomOffsetsAreNumbered :: Property
randomOffsetsAreNumbered = forAll ((,,,) <$> chooseInt (1, 5) <*> chooseInt (1, 5) <*> chooseInt (1, 4) <*> chooseInt (0, maxBound)) $ \(w, h, n, seed) ->
  let tracer = defaultRaytracer {raytracerPixelCoordinate = Random, raytracerSampling = n, raytracerSeed = seed}
      dealt = concat [[dx, dy] | y <- [0 .. h - 1], x <- [0 .. w - 1], k <- [0 .. n - 1], let (dx, dy) = offset tracer w x y k]
   in dealt === map (uniform (fromIntegral seed)) [0 .. fromIntegral (length dealt) - 1]
