-- |
-- Module      : Laws.Roots
-- Description : What is true of every list of roots, and polynomials that put it to the test
--
-- Each law is a sentence and a function. They compare "Dioptre.Math.Roots" with arithmetic on rational numbers, which
-- has no rounding: a double is a rational number, so the discriminant of a polynomial with double coefficients is
-- known exactly, and so is the side of a root on which a given number lies. No square root is taken anywhere in this
-- module.
--
-- Errors are counted in units of 'eps' = 2^-53, the largest relative error of one rounding, and in ulp, the distance
-- between neighbouring doubles. Every bound is derived where it stands.
module Laws.Roots
  ( -- * Polynomials
    Linear (..),
    Quadratic (..),

    -- * What was drawn
    corners,

    -- * Laws of linear polynomials
    linearIsNearest,
    linearScales,
    linearIsClean,

    -- * Laws of quadratic polynomials
    isAscending,
    isClean,
    isExactInNumberAndPlace,
    hasSmallResidual,
    isScaledExactly,
    isReflectedExactly,
    isInvertedNearly,
    hasProduct,
    hasSum,
    fallsToLinear,
    refusesNonFinite,
    clearlyNoneIsNone,
  )
where

import Data.List (partition, sort)
import Data.Ratio (denominator, numerator)
import Dioptre.Math.Roots (clearlyNone, linearRoots, quadraticRoots)
import GHC.Float (castDoubleToWord64, castWord64ToDouble)
import Test.QuickCheck

-- | @a x + b@.
data Linear = Linear Double Double
  deriving (Eq, Show)

-- | @a x^2 + b x + c@.
data Quadratic = Quadratic Double Double Double
  deriving (Eq, Show)

solve :: Quadratic -> [Double]
solve (Quadratic a b c) = quadraticRoots a b c

-------------------------------------------------------------------------------
-- Laws of linear polynomials

-- | The root is the double nearest to @-b \/ a@; there is none where that is too large for a double, or @a@ is zero.
--
-- 'fromRational' rounds correctly, by integer division: it is the second opinion.
linearIsNearest :: Linear -> Property
linearIsNearest (Linear a b) = linearRoots a b === [x | a /= 0, let x = nearest, not (isInfinite x)]
  where
    nearest = fromRational (negate (toRational b) / toRational a)

-- | Multiplying both coefficients by the same power of two, or by -1, changes no bit of the root.
linearScales :: Linear -> Property
linearScales (Linear a b) = forAll (exactPower [a, b]) $ \m ->
  let scaled = linearRoots (scaleFloat m a) (scaleFloat m b)
   in scaled === linearRoots a b .&&. linearRoots (negate a) (negate b) === linearRoots a b

-- | The root is finite, and not @-0@.
linearIsClean :: Linear -> Bool
linearIsClean (Linear a b) = all clean (linearRoots a b)

-------------------------------------------------------------------------------
-- Laws of quadratic polynomials

-- | Roots stand in ascending order.
isAscending :: Quadratic -> Property
isAscending q = solve q === sort (solve q)

-- | Roots are finite, and none is @-0@.
isClean :: Quadratic -> Property
isClean q = counterexample (show (solve q)) $ all clean (solve q)

-- | There are as many roots as the exact polynomial has, and each is within 4 ulp of its own: the first of the lesser,
-- the second of the greater. A root is missing only where the exact one lies beyond the largest double less 4 ulp.
--
-- The bound is derived in "Dioptre.Math.Roots", Note [Four ulp].
isExactInNumberAndPlace :: Quadratic -> Property
isExactInNumberAndPlace q@(Quadratic a b c) = counterexample (show (solve q)) $ case (solve q, exactRoots q) of
  ([x, y], Just (lesser, greater)) -> property (near x lesser && near y greater)
  ([x], Just (lesser, greater)) -> property ((near x lesser && beyond greater) || (beyond lesser && near x greater))
  ([], Just (lesser, greater)) -> property (beyond lesser && beyond greater)
  ([], Nothing) -> property True
  (roots, _) | a == 0 -> roots === linearRoots b c
  (roots, _) -> counterexample (show (length roots) ++ " roots, where none was expected") False
  where
    near x root = root `above` (toRational x - 4 * ulp x) && root `below` (toRational x + 4 * ulp x)
    beyond root = root `above` edge || root `below` negate edge
    edge = toRational largest - 4 * ulp largest

-- | A root makes the polynomial vanish up to rounding: |P(x)| <= 5 eps (|a| x^2 + |c|), for a root that is zero or at
-- least 2^-1022.
--
-- From x = X (1 + 4 eps) at worst, where X is the exact root and Y the other one:
-- |P(x)| = |a| |x - X| |x - Y| <= 4 eps |a X| (|x| + |Y|), and |a X Y| = |c|. The fifth eps is for |x| against |X|.
hasSmallResidual :: Quadratic -> Property
hasSmallResidual q@(Quadratic a b c) = conjoin [counterexample (show x) (small (toRational x)) | precise q, x <- solve q]
  where
    small x = abs ((a' * x + b') * x + c') <= 5 * eps * (abs a' * x * x + abs c')
    (a', b', c') = (toRational a, toRational b, toRational c)

-- | Multiplying all coefficients by the same power of two, or by -1, changes no bit of any root.
isScaledExactly :: Quadratic -> Property
isScaledExactly q@(Quadratic a b c) = forAll (exactPower [a, b, c]) $ \m ->
  let scaled k = Quadratic (k * scaleFloat m a) (k * scaleFloat m b) (k * scaleFloat m c)
   in solve (scaled 1) === solve q .&&. solve (scaled (-1)) === solve q

-- | Where it is clear that @a x^2 + 2 h x + c@ has no root, the exact discriminant is negative, and no root is found.
clearlyNoneIsNone :: Quadratic -> Property
clearlyNoneIsNone (Quadratic a h c) =
  cover 4 clear "clear" $
    if clear then toRational h * toRational h < toRational a * toRational c .&&. quadraticRoots a (2 * h) c === [] else property True
  where
    clear = clearlyNone a h c

-- | @P(-x)@ has the opposite roots, bit for bit, in the opposite order.
isReflectedExactly :: Quadratic -> Property
isReflectedExactly q@(Quadratic a b c) = solve (Quadratic a (negate b) c) === map (0 -) (reverse (solve q))

-- | @c x^2 + b x + a@ has the reciprocal roots: paired, they multiply to 1 within 9 eps, where all are at least
-- 2^-1022.
--
-- Both sides are within 4 eps of the exact root or of its reciprocal, and (1 + 4 eps)^2 < 1 + 9 eps. (They are much
-- closer than that, since one is p\/a and the other a\/p, unless rounding changed the order of two close roots.)
isInvertedNearly :: Quadratic -> Property
isInvertedNearly q@(Quadratic a b c) = case (solve q, solve (Quadratic c b a)) of
  ([x, y], [x', y'])
    | a /= 0 && c /= 0 && precise q && precise (Quadratic c b a) ->
      counterexample (show ([x, y], [x', y'])) $
        if (x < 0) == (y < 0) then reciprocal x y' && reciprocal y x' else reciprocal x x' && reciprocal y y'
  _ -> property True
  where
    reciprocal x y = abs (toRational x * toRational y - 1) <= 9 * eps

-- | Two roots multiply to @c \/ a@: within 3 eps, where both are at least 2^-1022; within 6 eps where @b@ is zero.
--
-- They are p\/a and c\/p, each rounded once, so whatever the error of p, the product is c\/a (1 + eps)^2. Where @b@
-- is zero they are -h and h, with h = sqrt (4 |a c| (1 + eps)) (1 + eps) \/ 2a (1 + eps), and h^2 is |c\/a| (1 + 5
-- eps) up to second order.
hasProduct :: Quadratic -> Property
hasProduct q@(Quadratic a b c) = case solve q of
  [x, y]
    | precise q ->
      let exact = toRational c / toRational a
          bound = if b == 0 then 6 * eps else 3 * eps
       in counterexample (show (x, y)) (abs (toRational x * toRational y - exact) <= bound * abs exact)
  _ -> property True

-- | Two roots add to @-b \/ a@, within 5 eps of |x| + |y|, where both are zero or at least 2^-1022.
--
-- Each is within 4 eps of its exact root. The fifth eps is for the size of the root against that of the exact one.
hasSum :: Quadratic -> Property
hasSum q@(Quadratic a b _) = case solve q of
  [x, y]
    | precise q ->
      let error' = toRational x + toRational y + toRational b / toRational a
       in counterexample (show (x, y)) (abs error' <= 5 * eps * (abs (toRational x) + abs (toRational y)))
  _ -> property True

-- | With @a@ exactly zero, the roots are those of @b x + c@.
fallsToLinear :: Linear -> Property
fallsToLinear (Linear b c) = quadraticRoots 0 b c === linearRoots b c .&&. quadraticRoots (-0.0) b c === linearRoots b c

-- | A coefficient that is NaN or infinite, wherever it stands, leaves no roots.
refusesNonFinite :: Quadratic -> Property
refusesNonFinite (Quadratic a b c) = conjoin $ do
  bad <- [0 / 0, 1 / 0, -1 / 0]
  map
    (=== [])
    [ quadraticRoots bad b c,
      quadraticRoots a bad c,
      quadraticRoots a b bad,
      linearRoots bad b,
      linearRoots a bad
    ]

-------------------------------------------------------------------------------
-- Exact arithmetic

-- | The place of a real number, known by the questions whether it is at least, or at most, a given rational number.
data Place = Place {above :: Rational -> Bool, below :: Rational -> Bool}

-- | The lesser and the greater real root of a polynomial of exact degree 2, if its exact discriminant is not negative.
--
-- With a > 0 and the vertex V = -b\/2a, the lesser root is at or below y where P(y) <= 0, or y is right of V; it is
-- at or above y where P(y) >= 0 and y is not right of V. The greater root mirrors it.
exactRoots :: Quadratic -> Maybe (Place, Place)
exactRoots q@(Quadratic a0 b0 c0)
  | a0 == 0 || exactDiscriminant q < 0 = Nothing
  | otherwise =
    Just
      ( Place {below = \y -> p y <= 0 || y >= vertex, above = \y -> p y >= 0 && y <= vertex},
        Place {below = \y -> p y >= 0 && y >= vertex, above = \y -> p y <= 0 || y <= vertex}
      )
  where
    a = abs (toRational a0)
    b = signum (toRational a0) * toRational b0
    c = signum (toRational a0) * toRational c0
    vertex = negate b / (2 * a)
    p y = (a * y + b) * y + c

exactDiscriminant :: Quadratic -> Rational
exactDiscriminant (Quadratic a b c) = toRational b * toRational b - 4 * toRational a * toRational c

-- | The largest relative error of one rounding.
eps :: Rational
eps = 1 / 2 ^ (53 :: Int)

-- | The distance from a double to the next larger in magnitude.
ulp :: Double -> Rational
ulp x = 2 ^^ max (exponent x - 53) (-1074)

-- | Whether each root of a polynomial has all its 53 digits, or is zero and exactly so. Then errors are small beside
-- the roots; in a subnormal root, and in one that underflowed to zero, they are only small in ulp.
precise :: Quadratic -> Bool
precise q@(Quadratic _ b c) = all normal digits && length zeros == length (takeWhile (== 0) [c, b])
  where
    (zeros, digits) = partition (== 0) (solve q)
    normal x = abs x >= 2 ^^ (-1022 :: Int)

clean :: Double -> Bool
clean x = not (isNaN x || isInfinite x || isNegativeZero x)

largest, least :: Double
largest = castWord64ToDouble 0x7fefffffffffffff
least = castWord64ToDouble 1

-------------------------------------------------------------------------------
-- Generators

-- | Powers of two by which all of the numbers can be multiplied without loss.
exactPower :: [Double] -> Gen Int
exactPower xs = case filter (/= 0) xs of
  [] -> chooseInt (-2000, 2000)
  numbers -> frequency [(3, chooseInt (lowest, highest)), (1, elements [lowest, highest])]
    where
      lowest = maximum [-1074 - lastBit x | x <- numbers]
      highest = minimum [1024 - exponent x | x <- numbers]
  where
    -- exponent of the last digit that is not zero
    lastBit x = let r = toRational x in twos (abs (numerator r)) - twos (denominator r)
    twos n = if odd n then 0 else 1 + twos (n `quot` 2)

-- | A double of about 2^e, of either sign, with random digits.
ofSize :: Int -> Gen Double
ofSize e = do
  digits <- chooseInteger (2 ^ (52 :: Int), 2 ^ (53 :: Int) - 1)
  sign <- elements [1, -1]
  pure (sign * scaleFloat (e - 52) (fromInteger digits))

-- | The numbers at which something changes: zeros, ones, the ends of the ranges of normal and subnormal doubles.
special :: Gen Double
special = do
  sign <- elements [1, -1]
  (sign *) <$> elements [0, 1, 2, 0.5, 1e300, 1e-300, largest, 2 ^ (1023 :: Int), normal, normal - least, 3 * least, least]
  where
    normal = 2 ^^ (-1022 :: Int)

-- | A double of any size: ordinary, anywhere between the ends of the range, special, or a small integer.
anyDouble :: Gen Double
anyDouble =
  frequency
    [ (4, chooseInt (-8, 8) >>= ofSize),
      (3, chooseInt (-1074, 1023) >>= ofSize),
      (2, special),
      (2, fromIntegral <$> chooseInt (-9, 9))
    ]

-- | The double some steps up (or down, where negative) in magnitude; zero has none.
nudged :: Int -> Double -> Double
nudged n x
  | x == 0 || isInfinite y || isNaN y = x
  | otherwise = signum x * y
  where
    y = castWord64ToDouble (castDoubleToWord64 (abs x) + fromIntegral n)

instance Arbitrary Linear where
  arbitrary = frequency [(4, Linear <$> anyDouble <*> anyDouble), (1, edge)]
    where
      -- a root at the very end of the range of doubles
      edge = do
        x <- elements [nudged (-1) largest, largest, least, 2 ^^ (-1022 :: Int)]
        a <- chooseInt (-60, -1) >>= ofSize
        Linear a . (`nudged` (a * x)) <$> chooseInt (-2, 2)
  shrink (Linear a b) = [Linear a' b | a' <- simpler a] ++ [Linear a b' | b' <- simpler b]

instance Arbitrary Quadratic where
  arbitrary =
    frequency
      [ (4, Quadratic <$> anyDouble <*> anyDouble <*> anyDouble),
        (3, Quadratic <$> ordinary <*> ordinary <*> ordinary),
        (4, withIntegerRoots >>= moved),
        (4, nearSquare >>= moved),
        (5, nearTangent >>= moved),
        (2, cassini >>= moved),
        (3, lopsided),
        (2, withHole),
        (2, withHugeRoot)
      ]
  shrink (Quadratic a b c) =
    [Quadratic a' b c | a' <- simpler a] ++ [Quadratic a b' c | b' <- simpler b] ++ [Quadratic a b c' | c' <- simpler c]

ordinary :: Gen Double
ordinary = chooseInt (-4, 4) >>= ofSize

-- | k (x - r) (x - s), exactly; r and s are often equal or neighbours.
withIntegerRoots :: Gen Quadratic
withIntegerRoots = do
  k <- elements [1, -1, 3, -7]
  r <- chooseInteger (-2 ^ (24 :: Int), 2 ^ (24 :: Int))
  s <- oneof [pure r, pure (r + 1), pure (negate r), chooseInteger (-2 ^ (24 :: Int), 2 ^ (24 :: Int))]
  pure (Quadratic (fromInteger k) (fromInteger (negate k * (r + s))) (fromInteger (k * r * s)))

-- | (p x - q)^2, exactly, or with one coefficient moved to a neighbouring double: then the discriminant is as small
-- as it can be.
nearSquare :: Gen Quadratic
nearSquare = do
  p <- chooseInteger (1, 2 ^ (26 :: Int))
  q <- chooseInteger (-2 ^ (26 :: Int), 2 ^ (26 :: Int))
  nearby (Quadratic (fromInteger (p * p)) (fromInteger (-2 * p * q)) (fromInteger (q * q)))

-- | Coefficients with all their digits, the last one b^2 \/ 4a, less a part of it from 1\/2 to nothing. In the end
-- the sign of the discriminant hangs on the last digits; on the way there, its accuracy does.
nearTangent :: Gen Quadratic
nearTangent = do
  a <- ordinary
  b <- ordinary
  let c = b * b / (4 * a)
  part <- oneof [pure 0, chooseInt (-54, -1) >>= ofSize]
  nearby (Quadratic a b (c - abs part * c))

-- | F(n-1) x^2 + 2 F(n) x + F(n+1), with Fibonacci's numbers: the discriminant is 4 or -4 by turns (Cassini's
-- identity), beside squares of up to 2^108. Kahan tests solvers with them.
cassini :: Gen Quadratic
cassini = do
  n <- chooseInt (0, 75)
  sign <- elements [1, -1]
  let fibonacci = 1 : 1 : zipWith (+) fibonacci (drop 1 fibonacci) :: [Integer]
  pure $ case map fromInteger (drop n fibonacci) of
    a : b : c : _ -> Quadratic a (sign * 2 * b) c
    _ -> Quadratic 1 2 2

nearby :: Quadratic -> Gen Quadratic
nearby (Quadratic a b c) =
  oneof
    [ pure (Quadratic a b c),
      (\n -> Quadratic (nudged n a) b c) <$> step,
      (\n -> Quadratic a (nudged n b) c) <$> step,
      (\n -> Quadratic a b (nudged n c)) <$> step
    ]
  where
    step = elements [1, -1, 2, -2]

-- | Sizes for which b^2 outweighs 4ac, or the reverse, by about the amount at which the lesser one stops to matter.
lopsided :: Gen Quadratic
lopsided = do
  i <- chooseInt (-1000, 1000)
  j <- chooseInt (-1000, 1000)
  k <- oneof [chooseInt (-110, -90), chooseInt (-60, 60), chooseInt (90, 110)]
  Quadratic <$> ofSize i <*> ofSize (max (-1074) (min 1023 ((i + j) `div` 2 + k))) <*> ofSize j

-- | At least one coefficient is zero.
withHole :: Gen Quadratic
withHole = do
  x <- anyDouble
  y <- anyDouble
  oneof
    [ elements [Quadratic x 0 y, Quadratic x y 0, Quadratic 0 x y],
      elements [Quadratic x 0 0, Quadratic 0 x 0, Quadratic 0 0 x, Quadratic x (-0.0) (-0.0)]
    ]

-- | One root is about as large as a double can be, or both are.
withHugeRoot :: Gen Quadratic
withHugeRoot = oneof [one, two]
  where
    one = do
      b <- chooseInt (-40, 0) >>= ofSize
      a <- (`nudged` (b / largest)) <$> chooseInt (-2, 2)
      Quadratic a b <$> frequency [(3, anyDouble), (1, ofSize 1022)]
    two = do
      a <- chooseInt (-1026, -1020) >>= ofSize
      b <- oneof [pure 0, ordinary]
      Quadratic a b <$> (chooseInt (1019, 1023) >>= ofSize)

-- | The same polynomial multiplied by a power of two, with roots multiplied by another; it may leave the range of
-- doubles on the way.
moved :: Quadratic -> Gen Quadratic
moved (Quadratic a b c) = do
  k <- frequency [(2, pure 0), (2, chooseInt (-40, 40)), (1, chooseInt (-500, 500))]
  let substituted = Quadratic (scaleFloat (2 * k) a) (scaleFloat k b) c
  if wellFormed substituted then multiplied substituted else multiplied (Quadratic a b c)
  where
    multiplied (Quadratic x y z) = do
      m <- frequency [(3, pure 0), (2, exactPower [x, y, z])]
      pure (Quadratic (scaleFloat m x) (scaleFloat m y) (scaleFloat m z))
    wellFormed (Quadratic x y z) = not (any isInfinite [x, y, z])

-- | Simpler numbers first; none leads back to a number already tried.
simpler :: Double -> [Double]
simpler x = takeWhile (/= x) [0, 1, -1, significand x]

-- | Names for what is special about a polynomial, with whether it holds. A generator must reach all of them.
corners :: Quadratic -> [(String, Bool)]
corners q@(Quadratic a b c) =
  [ ("two distinct roots", degree2 && d > 0),
    ("a double root", degree2 && d == 0),
    ("no root", degree2 && d < 0),
    ("discriminant positive, below 2^-50 b^2", degree2 && d > 0 && d < square / 2 ^ (50 :: Int)),
    ("discriminant positive, below 2^-90 b^2", degree2 && d > 0 && d < square / 2 ^ (90 :: Int)),
    ("discriminant negative, above -2^-50 b^2", degree2 && d < 0 && negate d < square / 2 ^ (50 :: Int)),
    ("discriminant negative, above -2^-90 b^2", degree2 && d < 0 && negate d < square / 2 ^ (90 :: Int)),
    ("a = 0", a == 0),
    ("b = 0", degree2 && b == 0 && c /= 0),
    ("c = 0", degree2 && b /= 0 && c == 0),
    ("a subnormal coefficient", any (\x -> x /= 0 && abs x < 2 ^^ (-1022 :: Int)) [a, b, c]),
    ("the square of a coefficient overflows or vanishes", any (\x -> x /= 0 && x * x `elem` [0, 1 / 0]) [a, b, c]),
    ("a root too large for a double", degree2 && d >= 0 && length (solve q) < 2),
    ("a subnormal root", any (\x -> x /= 0 && abs x < 2 ^^ (-1022 :: Int)) (solve q))
  ]
  where
    degree2 = a /= 0
    d = exactDiscriminant q
    square = toRational b * toRational b
