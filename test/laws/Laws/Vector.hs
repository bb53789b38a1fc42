-- |
-- Module      : Laws.Vector
-- Description : What is true of vectors
module Laws.Vector
  ( -- * What they are tried with
    Whole (..),
    Any (..),
    Sized (..),
    vectorCorners,

    -- * Products
    dotIsNearExact,
    dotIsBilinear,
    dotIsBilinearNearly,
    crossIsNearExact,
    crossIsBilinear,
    crossIsBilinearNearly,
    crossTurnsRound,
    crossIsOrthogonal,
    lagrange,
    lagrangeNearly,

    -- * Lengths
    modulusIsNearExact,
    modulusScales,
    distanceIsModulus,
    distanceIsSymmetric,

    -- * Unit vectors
    unitIsValid,
    unitIsParallel,
    unitScales,
    unitOfOpposite,
    unitIsAbsent,

    -- * Angles
    angleIsNearExact,
    angleIsSymmetric,
    angleScales,
    anglesSupplement,

    -- * Packing
    packsBackAndForth,
  )
where

import Data.Maybe (isJust)
import Dioptre.Math.Vector
import GHC.Float (castDoubleToWord64)
import Laws.Draw
import Laws.Exact
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-- | A vector of integers up to 4096: sums, products and sums of products are exact.
newtype Whole = Whole Vector
  deriving (Eq, Show)

instance Arbitrary Whole where
  arbitrary = Whole <$> oneof [V3 <$> large <*> large <*> large, V3 <$> small <*> small <*> small]
    where
      large = fromIntegral <$> chooseInt (-4096, 4096)
      small = fromIntegral <$> chooseInt (-3, 3)
  shrink (Whole (V3 x y z)) = [Whole v | v <- [V3 0 y z, V3 x 0 z, V3 x y 0, V3 1 y z, V3 x 1 z, V3 x y 1], v /= V3 x y z, simpler v]
    where
      simpler v = sum (abs <$> v) < sum (abs <$> V3 x y z)

-- | A vector of ordinary size, zero at times; two of them are nearly parallel at times.
newtype Any = Any Vector
  deriving (Eq, Show)

instance Arbitrary Any where
  arbitrary = Any <$> oneof [anyVector, anyVector, bent]
    where
      bent = V3 <$> near 1 <*> near 2 <*> near 3
      near x = (`nudged` x) <$> chooseInt (0, 3)
  shrink (Any (V3 x y z)) = [Any v | v <- [V3 0 y z, V3 x 0 z, V3 x y 0], v /= V3 x y z]

-- | A vector of any size that a double can have, with components of very different sizes, except the zero vector.
newtype Sized = Sized Vector
  deriving (Eq, Show)

instance Arbitrary Sized where
  arbitrary = Sized <$> (oneof [apart, together] `suchThat` (/= 0))
    where
      apart = V3 <$> part <*> part <*> part
      part = oneof [pure 0, chooseInt (-1074, 1023) >>= ofSize, extreme]
      together = do
        e <- oneof [chooseInt (-1074, 1023), chooseInt (-535, -515), elements [-1074, -1022, -500, -466, -465, -464, 464, 465, 466, 500, 1023]]
        let near = frequency [(1, pure 0), (5, chooseInt (-3, 0) >>= \k -> ofSize (max (-1074) (e + k)))]
        V3 <$> near <*> near <*> near
      extreme = (*) <$> elements [1, -1] <*> elements [5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 1e-140, 1e140]

-- | What the generator of 'Sized' must reach.
vectorCorners :: Sized -> [(String, Bool)]
vectorCorners (Sized v) =
  [ ("the quadrance overflows", isInfinite (quadrance v)),
    ("the quadrance vanishes", quadrance v == 0),
    ("the quadrance is subnormal", quadrance v > 0 && quadrance v < 2.2250738585072014e-308),
    ("a component is subnormal", any (\x -> x /= 0 && abs x < 2.2250738585072014e-308) v),
    ("the modulus itself overflows", isInfinite (sqrt (sum (fmap (\x -> (x / 2) ^ (2 :: Int)) v))) && maximum (abs <$> v) >= 2 ** 1023),
    ("one component only", length (filter (/= 0) (components v)) == 1)
  ]

-------------------------------------------------------------------------------
-- Products

-- | The inner product is within gamma 3 of the exact one, counted by the sum of the terms' magnitudes: a product and
-- two sums.
dotIsNearExact :: Any -> Any -> Property
dotIsNearExact (Any a) (Any b) = isWithin (gamma 3 * inner (magnitudes x) (magnitudes y)) (toRational (dot a b)) (inner x y)
  where
    x = exact a
    y = exact b

-- | The inner product is linear in each vector and symmetric: exactly so, for integers.
dotIsBilinear :: Whole -> Whole -> Whole -> Property
dotIsBilinear (Whole a) (Whole b) (Whole c) = forAll (fromIntegral <$> chooseInt (-64, 64)) $ \k ->
  dot (k *^ a + b) c === k * dot a c + dot b c .&&. dot c (k *^ a + b) === k * dot c a + dot c b .&&. dot a b === dot b a

-- | The inner product is additive, up to rounding: gamma 4 of the sum's terms (one rounding for the sum of the vectors,
-- three for the product) and gamma 3 of the two other products' terms.
dotIsBilinearNearly :: Any -> Any -> Any -> Property
dotIsBilinearNearly (Any a) (Any b) (Any c) =
  isWithin (gamma 4 * inner (magnitudes (x + y)) z + gamma 3 * inner (magnitudes x + magnitudes y) z) (toRational (dot (a + b) c)) (toRational (dot a c) + toRational (dot b c))
  where
    x = exact a
    y = exact b
    z = magnitudes (exact c)

-- | Each component of the outer product is within gamma 2 of the exact one, counted by its two terms.
crossIsNearExact :: Any -> Any -> Property
crossIsNearExact (Any a) (Any b) = componentwise (\m -> gamma 2 * m) (outerMagnitudes x y) (exact (cross a b)) (outer x y)
  where
    x = exact a
    y = exact b

-- | The outer product is linear in each vector: exactly so, for integers.
crossIsBilinear :: Whole -> Whole -> Whole -> Property
crossIsBilinear (Whole a) (Whole b) (Whole c) = forAll (fromIntegral <$> chooseInt (-64, 64)) $ \k ->
  cross (k *^ a + b) c === k *^ cross a c + cross b c .&&. cross c (k *^ a + b) === k *^ cross c a + cross c b

-- | The outer product is additive, up to rounding, component by component: gamma 3 of the sum's terms and gamma 2 of
-- the others'.
crossIsBilinearNearly :: Any -> Any -> Any -> Property
crossIsBilinearNearly (Any a) (Any b) (Any c) =
  componentwise id bound (exact (cross (a + b) c)) (exact (cross a c) + exact (cross b c))
  where
    x = exact a
    y = exact b
    z = exact c
    bound = fmap (gamma 3 *) (outerMagnitudes (x + y) z) + fmap (gamma 2 *) (outerMagnitudes x z + outerMagnitudes y z)

-- | Exchanging its factors turns the outer product round, whatever they are; and that of a vector with itself is zero.
crossTurnsRound :: Any -> Any -> Property
crossTurnsRound (Any a) (Any b) = cross b a === negate (cross a b) .&&. cross a a === 0

-- | The outer product is orthogonal to both factors, up to gamma 2 of its own terms.
crossIsOrthogonal :: Any -> Any -> Property
crossIsOrthogonal (Any a) (Any b) = orthogonal x .&&. orthogonal y
  where
    x = exact a
    y = exact b
    n = exact (cross a b)
    orthogonal v = isWithin (gamma 2 * inner (magnitudes v) (outerMagnitudes x y)) (inner n v) 0

-- | Lagrange's identity, |a x b|^2 + (a . b)^2 = |a|^2 |b|^2: exactly, for integers up to 63 (the squares stay below
-- 2^53).
lagrange :: Whole -> Whole -> Property
lagrange (Whole a0) (Whole b0) = quadrance (cross a b) + dot a b * dot a b === quadrance a * quadrance b
  where
    a = fmap small a0
    b = fmap small b0
    small :: Double -> Double
    small x = fromIntegral (truncate x `rem` 64 :: Int)

-- | Lagrange's identity, up to rounding. With S the sum of the squares of the outer product's terms, and T the sum of
-- the inner product's: the outer product errs by gamma 2 of its terms, its quadrance by twice that and gamma 3 more,
-- and the inner product by gamma 3. That is (1 + gamma 2)^2 (1 + gamma 3) - 1 of S, below gamma 8, and (1 + gamma
-- 3)^2 - 1 of T^2, below gamma 7.
lagrangeNearly :: Any -> Any -> Property
lagrangeNearly (Any a) (Any b) = isWithin (gamma 8 * squared (outerMagnitudes x y) + gamma 7 * t * t) (toRational (quadrance (cross a b)) + d * d) (squared x * squared y)
  where
    x = exact a
    y = exact b
    d = toRational (dot a b)
    t = inner (magnitudes x) (magnitudes y)

-------------------------------------------------------------------------------
-- Lengths

-- | The modulus is within 5\/2 eps of the length: its square has at most three roundings, the square root halves them
-- and adds one. Compared as squares, that is 5 eps and a little of the second order: gamma 6.
modulusIsNearExact :: Any -> Property
modulusIsNearExact (Any v) = isWithin (gamma 6 * squared (exact v)) (toRational (modulus v) ^ (2 :: Int)) (squared (exact v))

-- | A vector 2^k times as long has a modulus 2^k times as large, exactly.
modulusScales :: Any -> Property
modulusScales (Any v) = forAll (chooseInt (-200, 200)) $ \k -> modulus (scaleFloat k <$> v) === scaleFloat k (modulus v)

-- | The distance from a to b is the modulus of b - a.
distanceIsModulus :: Any -> Any -> Property
distanceIsModulus (Any a) (Any b) = distance a b === modulus (b - a)

-- | The way back is as long as the way there, and the way to where one is has no length.
distanceIsSymmetric :: Any -> Any -> Property
distanceIsSymmetric (Any a) (Any b) = distance a b === distance b a .&&. distance a a === 0

-------------------------------------------------------------------------------
-- Unit vectors

-- | Every vector but zero has a unit vector, however long or short it is, and that is 'valid'; so is its opposite.
unitIsValid :: Sized -> Property
unitIsValid (Sized v) = counterexample (show (unit v)) $ case unit v of
  Just n -> valid n .&&. valid (opposite n)
  Nothing -> property False

-- | The unit vector has the vector's direction: component by component it is v_i \/ |v|, within 4 eps (5\/2 for the
-- length, one for the quotient, and the second order), or 2^-480 where a component's square underflows beside the
-- others'.
unitIsParallel :: Sized -> Property
unitIsParallel (Sized v) = case unit v of
  Nothing -> property False
  Just n -> conjoin (zipWith same (components (exact (vector n))) (components (exact v)))
  where
    q = squared (exact v)
    low = rootBelow q
    high = rootAbove q
    same n x =
      counterexample (show (fromRational n :: Double, fromRational x :: Double)) $
        abs n * high >= abs x * (1 - 4 * eps) - negligible && abs n * low <= abs x * (1 + 4 * eps) + negligible && n * x >= 0
    negligible = high / 2 ^ (480 :: Int)

-- | Multiplying a vector by a power of two does not change its unit vector, not by a bit, as long as no digit is lost.
unitScales :: Any -> Property
unitScales (Any v) = v /= 0 ==> forAll (chooseInt (-900, 900)) $ \k -> unit (scaleFloat k <$> v) === unit v

-- | The opposite vector has the opposite unit vector.
unitOfOpposite :: Sized -> Property
unitOfOpposite (Sized v) = unit (negate v) === (opposite <$> unit v)

-- | Only the zero vector has no unit vector.
unitIsAbsent :: Sized -> Property
unitIsAbsent (Sized v) = isJust (unit v) .&&. unit (0 *^ fmap signum v) === Nothing

-------------------------------------------------------------------------------
-- Angles

-- | The angle of two integer vectors is exact to 4 eps of itself, or of what it lacks to a half turn, whichever is
-- less; and to 4 eps more when it is above a quarter turn.
--
-- Both products of 'Whole' vectors up to 2048 are exact, so |a x b| has the rounding of its square root and the
-- tangent one more; the arc tangent of the library is within 1 ulp, at most 2 eps: 4 eps together. Beyond a quarter
-- turn the angle is pi less that: pi is known to 1.2 eps, and the difference is rounded to half an ulp, 2 eps.
--
-- The second opinion: the sine of the angle between the direction (cos, sin) of the computed angle and the exact
-- direction (a . b, |a x b|). Sine and cosine are summed as series.
angleIsNearExact :: Whole -> Whole -> Property
angleIsNearExact (Whole a0) (Whole b0) =
  a /= 0 && b /= 0
    ==> counterexample (show (angle a b, fromRational miss :: Double))
    $ abs miss <= 4 * eps * min theta (piAbove - theta) + (if d < 0 then 4 * eps else 0) + 1 / 2 ^ (100 :: Int)
  where
    a = fmap half a0
    b = fmap half b0
    half x = fromIntegral (truncate x `rem` 2048 :: Int)
    c = rootBelow (squared (outer (exact a) (exact b)))
    d = inner (exact a) (exact b)
    theta = toRational (angle a b)
    miss = (sine theta * d - cosine theta * c) / rootBelow (c * c + d * d)
    piAbove = 3.14159265358979323846264338328

-- | The angle is the same the other way round.
angleIsSymmetric :: Any -> Any -> Property
angleIsSymmetric (Any a) (Any b) = angle a b === angle b a

-- | Angles do not depend on lengths: exactly so for powers of two.
angleScales :: Any -> Any -> Property
angleScales (Any a) (Any b) = forAll ((,) <$> chooseInt (-100, 100) <*> chooseInt (-100, 100)) $ \(i, j) ->
  angle (scaleFloat i <$> a) (scaleFloat j <$> b) === angle a b

-- | The angles to a vector and to its opposite add up to pi, up to the half ulp by which the greater one is rounded:
-- 2 eps. They have the same tangent, up to its sign.
anglesSupplement :: Any -> Any -> Property
anglesSupplement (Any a) (Any b) =
  a /= 0 && b /= 0 ==> isWithin (2 * eps) (toRational (angle a b) + toRational (angle a (negate b))) (toRational (pi :: Double))

-- | The first 40 terms of the series, in multiples of 2^-160: exact to 1e-30 for angles up to 4.
sine, cosine :: Rational -> Rational
sine x = series x 1 x
cosine x = series x 0 1

series :: Rational -> Integer -> Rational -> Rational
series x n0 first = sum (take 40 (map fst (iterate next (first, n0))))
  where
    next (term, n) = (coarse (negate term * x * x / fromInteger ((n + 1) * (n + 2))), n + 2)
    coarse y = fromInteger (round (y * 2 ^ (160 :: Int))) / 2 ^ (160 :: Int)

-------------------------------------------------------------------------------
-- Packing

-- | A vector that was packed is the same vector, to the bit, -0 included; so is a unit vector.
packsBackAndForth :: Sized -> Property
packsBackAndForth (Sized v) =
  conjoin [bits (unpacked (packed w)) === bits w | w <- [v, negate v, 0 *^ v]]
    .&&. fmap (unpackedUnit . packedUnit) (unit v) === unit v
  where
    bits = fmap castDoubleToWord64

-------------------------------------------------------------------------------

-- | Within a bound of each other.
isWithin :: Rational -> Rational -> Rational -> Property
isWithin bound x y = counterexample (show (map fromRational [x, y, x - y, bound] :: [Double])) (abs (x - y) <= bound)

componentwise :: (a -> Rational) -> V3 a -> Exact -> Exact -> Property
componentwise bound ms xs ys = conjoin (zipWith3 isWithin (map bound (components ms)) (components xs) (components ys))
