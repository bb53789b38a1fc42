-- |
-- Module      : Laws.Transform
-- Description : What is true of scaling, turning and moving
--
-- The second opinion is the product of the five matrices of the definition, multiplied by "Linear.Matrix" with sines
-- and cosines of angles that were not reduced.
module Laws.Transform
  ( -- * Transformations
    Drawn (..),
    Quarters (..),

    -- * Laws of the matrix
    isTheProduct,
    isExactAtQuarterTurns,
    isPeriodic,

    -- * Laws of points, directions, normals
    pointsComeBack,
    directionsAreDifferences,
    normalsStayNormal,
    normalsComeBack,

    -- * Laws of rays
    keepsParameters,
    raysComeBack,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Placement (carriedBack, carriedForth)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Math.Transform
import Dioptre.Math.Vector
import Linear.Matrix ((!*!))
import Linear.V3 (V3 (..))
import Linear.V4 (V4 (..))
import Test.QuickCheck hiding (vector)

-- | A transformation.
newtype Drawn = Drawn Transform
  deriving (Eq, Show)

-- | Quarter turns about x, y and z.
data Quarters = Quarters Integer Integer Integer
  deriving (Eq, Show)

-- | The relative error of everything below, before it is multiplied by what a transformation stretches: 2^-48.
rounding :: Double
rounding = 2 ** (-48)

-------------------------------------------------------------------------------
-- Laws

-- | The matrix is T Rz Ry Rx S, entry by entry within 2^-48 of the largest scale factor. (Angles stay below 1000
-- degrees, of which 2^-49 is how far the second opinion's are off.)
isTheProduct :: Drawn -> Property
isTheProduct (Drawn t) = counterexample (show (matrix t, expected)) $ and (zipWith near (entries (matrix t)) (entries expected))
  where
    -- (false where one is NaN)
    near x y = abs (x - y) <= rounding * maximum (abs <$> transformScale t)
    entries m = concatMap (foldr (:) []) (foldr (:) [] m)
    V3 ax ay az = (* (pi / 180)) <$> transformRotation t
    V3 sx sy sz = transformScale t
    V3 tx ty tz = transformTranslation t
    expected =
      V4 (V4 1 0 0 tx) (V4 0 1 0 ty) (V4 0 0 1 tz) (V4 0 0 0 1)
        !*! V4 (V4 (cos az) (negate (sin az)) 0 0) (V4 (sin az) (cos az) 0 0) (V4 0 0 1 0) (V4 0 0 0 1)
        !*! V4 (V4 (cos ay) 0 (sin ay) 0) (V4 0 1 0 0) (V4 (negate (sin ay)) 0 (cos ay) 0) (V4 0 0 0 1)
        !*! V4 (V4 1 0 0 0) (V4 0 (cos ax) (negate (sin ax)) 0) (V4 0 (sin ax) (cos ax) 0) (V4 0 0 0 1)
        !*! V4 (V4 sx 0 0 0) (V4 0 sy 0 0) (V4 0 0 sz 0) (V4 0 0 0 1)

-- | Turns by multiples of 90 degrees carry whole numbers to whole numbers, exactly: x y z to x -z y about x, to z y -x
-- about y, to -y x z about z.
isExactAtQuarterTurns :: Quarters -> Property
isExactAtQuarterTurns (Quarters i j k) = forAll (V3 <$> whole <*> whole <*> whole) $ \v ->
  transformDirection m v === (times k aboutZ . times j aboutY . times i aboutX) v
    .&&. inverseDirection m (transformDirection m v) === v
  where
    m = placement (made 1 ((90 *) . fromInteger <$> V3 i j k) 0)
    whole = fromInteger <$> chooseInteger (-1000, 1000)
    times n f = foldr (.) id (replicate (fromInteger (n `mod` 4)) f)
    aboutX (V3 x y z) = V3 x (negate z) y
    aboutY (V3 x y z) = V3 z y (negate x)
    aboutZ (V3 x y z) = V3 (negate y) x z

-- | Whole turns change no bit, where the sum of the angles is exact.
isPeriodic :: Drawn -> Property
isPeriodic (Drawn t) = forAll (V3 <$> turns <*> turns <*> turns) $ \by ->
  let angles = (\x -> fromInteger (round (x * 1024)) / 1024) <$> transformRotation t
      turned r = matrix (made (transformScale t) r (transformTranslation t))
   in turned (angles + by) === turned angles
  where
    turns = (360 *) . fromInteger <$> chooseInteger (-1000000, 1000000)

-- | A point that is transformed and carried back is the point, and the other way round, but for rounding stretched by
-- the ratio of the scale factors.
pointsComeBack :: Drawn -> Property
pointsComeBack (Drawn t) = forAll aPoint $ \p ->
  let m = placement t
   in counterexample (show (inversePosition m (transformPosition m p), transformPosition m (inversePosition m p))) $
        modulus (inversePosition m (transformPosition m p) - p) <= rounding * (stretch t * modulus p + modulus (transformTranslation t) / least t)
          && modulus (transformPosition m (inversePosition m p) - p) <= rounding * stretch t * (modulus p + 2 * modulus (transformTranslation t))

-- | A direction is the way between two points, there and back.
directionsAreDifferences :: Drawn -> Property
directionsAreDifferences (Drawn t) = forAll aPoint $ \p -> forAll aPoint $ \d ->
  let m = placement t
      there = transformPosition m (p + d) - transformPosition m p
      back = inversePosition m (p + d) - inversePosition m p
      sizes = modulus p + modulus d + modulus (transformTranslation t)
   in modulus (there - transformDirection m d) <= rounding * (1 + maximum (abs <$> transformScale t)) * sizes
        && modulus (back - inverseDirection m d) <= rounding * sizes / least t

-- | A transformed normal is unit, orthogonal to what becomes of the directions in its plane, and on the same side of
-- the surface as what becomes of itself.
normalsStayNormal :: Drawn -> Property
normalsStayNormal (Drawn t) = forAll aUnit $ \n -> forAll aUnit $ \e ->
  let m = placement t
      n' = transformNormal m n
      along = cross (vector n) (vector e)
   in counterexample (show n') $
        valid n'
          && abs (dot (vector n') (transformDirection m along)) <= rounding * maximum (abs <$> transformScale t)
          && dot (vector n') (transformDirection m (vector n)) > 0

-- | A transformed normal carried back, by L^T, is the normal, but for rounding stretched by the ratio of the scale
-- factors.
normalsComeBack :: Drawn -> Property
normalsComeBack (Drawn t) = forAll aUnit $ \n ->
  let m = placement t
      n' = vector (transformNormal m n)
      -- A row of L^T is a column of L: what becomes of an axis.
      back = dot n' . transformDirection m . vector <$> V3 alongX alongY alongZ
   in maybe False (\n0 -> modulus (vector n0 - vector n) <= rounding * stretch t) (unit back)

-- | The position of a ray at a parameter, carried back, is the position of the ray carried back at that parameter.
keepsParameters :: Drawn -> Property
keepsParameters (Drawn t) = forAll aRay $ \r -> forAll (choose (-100, 100)) $ \s ->
  let m = placement t
      sizes = modulus (origin r) + abs s * modulus (direction r) + modulus (transformTranslation t)
   in modulus (position (carriedBack m r) s - inversePosition m (position r s)) <= rounding * sizes / least t

-- | A ray carried back and forth is the ray.
raysComeBack :: Drawn -> Property
raysComeBack (Drawn t) = forAll aRay $ \r ->
  let m = placement t
      r' = carriedForth m (carriedBack m r)
      bound = rounding * stretch t * (modulus (origin r) + modulus (direction r) + 2 * modulus (transformTranslation t))
   in modulus (origin r' - origin r) <= bound && modulus (direction r' - direction r) <= bound

-- | The greatest scale factor over the least.
stretch :: Transform -> Double
stretch t = maximum (abs <$> transformScale t) / least t

least :: Transform -> Double
least t = minimum (abs <$> transformScale t)

made :: Vector -> Vector -> Vector -> Transform
made s r t = fromMaybe identity (transform s r t)

-------------------------------------------------------------------------------
-- Generators

instance Arbitrary Drawn where
  arbitrary = Drawn <$> (made <$> scales <*> angles <*> oneof [pure 0, aPoint])
    where
      scales = oneof [pure 1, (\x -> V3 x x x) <$> factor, V3 <$> factor <*> factor <*> factor]
      factor = (*) <$> elements [1, 1, -1] <*> oneof [pure 1, (2 **) <$> choose (-10, 10)]
      angles = V3 <$> angleInDegrees <*> angleInDegrees <*> angleInDegrees
      angleInDegrees = oneof [pure 0, elements [90, -90, 180, 270, 45, 30, -45], choose (-180, 180), choose (-1000, 1000)]

instance Arbitrary Quarters where
  arbitrary = Quarters <$> turns <*> turns <*> turns
    where
      turns = oneof [chooseInteger (-4, 4), chooseInteger (-1000000000, 1000000000)]

aPoint :: Gen Point
aPoint = do
  size' <- (10 **) <$> choose (-2, 3)
  fmap (* size') <$> (V3 <$> choose (-1, 1) <*> choose (-1, 1) <*> choose (-1, 1))

aUnit :: Gen Unit
aUnit = do
  v <- oneof [aPoint, elements [V3 1 0 0, V3 0 (-1) 0, V3 0 0 1]]
  maybe aUnit pure (unit v)

aRay :: Gen Ray
aRay = ray <$> aPoint <*> (vector <$> aUnit)
