-- |
-- Module      : Laws.Uv
-- Description : What is true of texture coordinates
--
-- The second opinion on a round part is to put a point at known angles and ask for them back.
module Laws.Uv
  ( -- * What was drawn
    Framed (..),

    -- * Laws
    frameIsRightHanded,
    frameStartsAtSmallest,
    diskFillsPicture,
    planeRepeats,
    sphereKeepsAngles,
    sideKeepsAngles,
    torusKeepsAngles,
    endsAreDisks,
    wrapsIntoPicture,
    wrapsByWholeNumbers,
    leavesWhatIsInPlace,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Uv
import Dioptre.Math.Vector (Point, Unit, alongX, alongY, alongZ, cross, dot, modulus, opposite, unit, vector, (*^))
import Laws.Draw
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector, within)

-- | A point, a unit normal there, and a size.
data Framed = Framed Point Unit Double
  deriving (Show)

instance Arbitrary Framed where
  arbitrary = do
    kind <- elements [Few, Full]
    Framed <$> point kind <*> oneof [elements [alongX, alongY, alongZ, opposite alongX, opposite alongZ], fromMaybe alongZ . unit <$> step kind] <*> positive kind

-- | One rounding.
eps :: Double
eps = 2 ** (-53)

-- | Within a number of roundings of numbers up to a size.
within :: Double -> Double -> Double -> Property
within bound x y = counterexample (show (x, y)) (abs (x - y) <= bound)

-- | e1, e2 and n are orthogonal unit vectors, with e1 x e2 = n, each to 16 roundings.
frameIsRightHanded :: Framed -> Property
frameIsRightHanded (Framed _ n _) =
  conjoin [within (16 * eps) (dot a b) x | (a, b, x) <- [(e1, e1, 1), (e2, e2, 1), (e1, e2, 0), (e1, v, 0), (e2, v, 0), (cross e1 e2, v, 1)]]
  where
    v = vector n
    (e1, e2) = frame n

-- | No axis is farther from n than the one that e1 leans on.
frameStartsAtSmallest :: Framed -> Property
frameStartsAtSmallest (Framed _ n _) = counterexample (show (n, e1)) (leaning >= maximum (fmap abs e1))
  where
    (e1, _) = frame n
    V3 x y z = vector n
    smallest = minimum [abs x, abs y, abs z]
    V3 a b c = e1
    leaning = case [part | (component, part) <- [(x, a), (y, b), (z, c)], abs component == smallest] of
      part : _ -> part
      [] -> 0

-- | The centre of a disk is the middle of the picture, e1 runs to the right and e2 up, and no point of the disk is
-- outside.
diskFillsPicture :: Framed -> Property
diskFillsPicture (Framed p n radius) = forAll ((,) <$> fraction <*> choose (0, 2 * pi)) $ \(part, angle) ->
  let (e1, e2) = frame n
      V2 u v = diskUv p n radius (p + ((part * radius) *^ (cos angle *^ e1 + sin angle *^ e2)))
      bound = 32 * eps * (1 + modulus p / radius)
   in within bound u (0.5 + part * cos angle / 2) .&&. within bound v (0.5 - part * sin angle / 2)

-- | On a plane, e1 is one picture to the right, and e2 one up.
planeRepeats :: Framed -> Property
planeRepeats (Framed p n _) = forAll ((,) <$> number Few <*> number Few) $ \(a, b) ->
  let (e1, e2) = frame n
      V2 u v = planeUv p n (p + a *^ e1 + b *^ e2)
      bound = 32 * eps * (abs a + abs b + modulus p)
   in within bound u a .&&. within bound v (negate b)

-- | A point of a sphere at a longitude and a latitude.
sphereKeepsAngles :: Framed -> Property
sphereKeepsAngles (Framed p _ radius) = forAll ((,) <$> choose (-3, 3) <*> choose (0.1, 3)) $ \(longitude, polar) ->
  let V2 u v = sphereUv p (p + radius *^ V3 (sin polar * cos longitude) (cos polar) (sin polar * sin longitude))
      bound = 64 * eps * (1 + modulus p / radius) / sin polar
   in within bound u (0.5 + longitude / (2 * pi)) .&&. within bound v (polar / pi)

-- | A point of a side at an angle and a height; at any distance from the axis.
sideKeepsAngles :: Framed -> Property
sideKeepsAngles (Framed p s h) = forAll ((,,) <$> choose (-3, 3) <*> fraction <*> choose (0.5, 2)) $ \(angle, part, away) ->
  let (e1, e2) = frame s
      V2 u v = sideUv p s h (p + (part * h) *^ vector s + away *^ (cos angle *^ e1 + sin angle *^ e2))
      bound = 64 * eps * (1 + (modulus p + h + 2) * (1 / away + 1 / h))
   in within bound u (0.5 + angle / (2 * pi)) .&&. within bound v (1 - part)

-- | A point of a torus at two angles, the tube no thicker than half the circle.
torusKeepsAngles :: Framed -> Property
torusKeepsAngles (Framed p n major) = forAll ((,,) <$> choose (-3, 3) <*> choose (-3, 3) <*> choose (0.1, 0.5)) $ \(angle, around, part) ->
  let (e1, e2) = frame n
      minor = part * major
      across' = cos angle *^ e1 + sin angle *^ e2
      V2 u v = torusUv p n major (p + (major + minor * cos around) *^ across' + (minor * sin around) *^ vector n)
      bound = 256 * eps * (1 + (modulus p + major) / minor)
   in within bound u (0.5 + angle / (2 * pi)) .&&. within bound v (0.5 - around / (2 * pi))

-- | The ends of cylinder and cone are disks with the end's own normal, and so are a cube's faces.
endsAreDisks :: Framed -> Property
endsAreDisks (Framed p s size) = forAll (point Few) $ \v ->
  conjoin
    [ cylinderUv p s 2 size s v === diskUv (p + 2 *^ vector s) s size v,
      cylinderUv p s 2 size (opposite s) v === diskUv p (opposite s) size v,
      coneUv p s 2 size (opposite s) v === diskUv p (opposite s) size v,
      coneUv p s 2 size s v === sideUv p s 2 v,
      cubeUv p size s (p + size *^ vector s) === V2 0.5 0.5
    ]

-- | A wrapped coordinate is above 0 and at most 1, or from 0 to 1 where it was not above 0.
wrapsIntoPicture :: Property
wrapsIntoPicture = forAll coordinate $ \u ->
  counterexample (show (wrapped u)) (if u > 0 then wrapped u > 0 && wrapped u <= 1 else wrapped u >= 0 && wrapped u <= 1)

-- | Wrapping takes away a whole number, to the rounding of the result: half a unit in the last place of 1.
wrapsByWholeNumbers :: Property
wrapsByWholeNumbers = forAll coordinate $ \u ->
  let taken = toRational u - toRational (wrapped u)
   in counterexample (show (u, wrapped u)) (abs (taken - fromInteger (round taken)) <= toRational eps)

-- | What is above 0 and at most 1 stays, and so does 0.
leavesWhatIsInPlace :: Property
leavesWhatIsInPlace = forAll fraction $ \u -> wrapped u === u

-- | Whole numbers, numbers next to them, and numbers of all sizes.
coordinate :: Gen Double
coordinate = oneof [whole, (\k -> nudged k <$> whole) =<< chooseInt (-2, 2), number Full, number Wide, chooseInt (40, 60) >>= ofSize, chooseInt (-80, -40) >>= ofSize]
  where
    whole = fromIntegral <$> chooseInt (-4, 4)
