-- |
-- Module      : Laws.Quartic
-- Description : What is true of the roots of cubic and quartic polynomials, and polynomials that put it to the test
--
-- As in "Laws.Roots", a double is a rational number, and rational arithmetic has no rounding. How many roots a
-- polynomial has between two numbers is counted by Sturm's theorem, with multiplicities from its square-free factors
-- (D. Yun, "On square-free decomposition algorithms", 1976): neither knows anything of critical points, of Newton's
-- method or of tolerances.
module Laws.Quartic
  ( -- * Polynomials
    Polynomial (..),
    WithIntegerRoots (..),
    Touching (..),
    Gathered (..),
    Wild (..),

    -- * What was drawn
    corners,

    -- * Laws
    solve,
    isAscending,
    isClean,
    isExactInNumber,
    isInPlace,
    hasSmallResidual,
    isScaledExactly,
    isReflected,
    hasSum,
    fallsInDegree,
    refusesNonFinite,
    findsIntegerRoots,
    findsTouchingRoots,
    findsGatheredRoots,
    findsRootsOfAnySize,
    exactCount,
  )
where

import Data.List (group, sort)
import Dioptre.Math.Quartic (cubicRoots, quarticRoots)
import Dioptre.Math.Roots (quadraticRoots)
import Test.QuickCheck

-- | Coefficients, the highest degree first: four or five, of which the first is not zero. Their sizes, and those of the
-- roots, are ordinary, so that nothing overflows or underflows.
newtype Polynomial = Polynomial [Double]
  deriving (Eq, Show)

-- | The roots that the program finds.
solve :: [Double] -> [Double]
solve [a, b, c, d] = cubicRoots a b c d
solve [a, b, c, d, e] = quarticRoots a b c d e
solve _ = []

-------------------------------------------------------------------------------
-- Laws

-- | Roots stand in ascending order.
isAscending :: Polynomial -> Property
isAscending (Polynomial p) = solve p === sort (solve p)

-- | Roots are finite, and none is @-0@.
isClean :: Polynomial -> Property
isClean (Polynomial p) = counterexample (show (solve p)) $ all (\x -> not (isNaN x || isInfinite x || isNegativeZero x)) (solve p)

-- | There are as many roots as the exact polynomial has. Where a root is given k times, k > 1, there are k, or fewer by
-- an even number, within 2^-23 of its size, and the polynomial there is below 2^-(25 k) of its Taylor term of degree k,
-- and below 8 eps of its terms' sizes: what can pass for a multiple root. (With that value, k roots are within 2^-25 of
-- their size from it, if the other roots are farther.)
isExactInNumber :: Polynomial -> Property
isExactInNumber (Polynomial p) =
  counterexample (show (solve p, exactCount exact)) $
    conjoin (map justified multiple) .&&. length single === exactCount exact - sum (map (nearCount . head') multiple)
  where
    exact = map toRational p
    groups = group (solve p)
    multiple = [g | g <- groups, length g > 1]
    single = concat [g | g <- groups, length g == 1]
    head' = foldr const 0
    nearCount 0 = length (takeWhile (== 0) (reverse exact))
    nearCount c = countBetween exact (near (-1) c) (near 1 c)
    near s c = let x = toRational c in x + s * abs x / 2 ^ (23 :: Int)
    justified g =
      let c = toRational (head' g)
          k = length g
          v = abs (evaluate exact c)
          term = abs (taylor k exact c * c ^ k)
          found = nearCount (head' g)
       in counterexample (show g) $
            (c == 0 || found <= k && even (k - found))
              .&&. counterexample "no multiple root" (v <= term / 2 ^ (25 * k) && v <= 8 * eps * sizes exact c)

-- | A root that is given once is within 1 ulp of an exact one: the polynomial changes its sign there. (Within 4 ulp, if
-- the polynomial is a quadratic one times a power of x: the roots are "Dioptre.Math.Roots"'s.)
isInPlace :: Polynomial -> Property
isInPlace (Polynomial p) = conjoin [counterexample (show x) (changes x) | [x] <- group (solve p)]
  where
    exact = map toRational p
    changes x = signum (evaluate exact (toRational x - far * ulp x)) * signum (evaluate exact (toRational x + far * ulp x)) <= 0
    far = if length (dropWhile (== 0) (reverse exact)) <= 3 then 4 else 1

-- | The polynomial vanishes at its roots, up to rounding: |p(x)| <= 8 eps (|a x^n| + ... + |e|).
--
-- Where x = X (1 + 2 eps) at worst, with X the exact root, |p(x)| <= 2 eps |X p'(x)|, and |x p'(x)| is at most n times
-- that sum. For multiple roots it is the rule.
hasSmallResidual :: Polynomial -> Property
hasSmallResidual (Polynomial p) = conjoin [counterexample (show x) (small (toRational x)) | x <- solve p]
  where
    exact = map toRational p
    small x = abs (evaluate exact x) <= 8 * eps * sizes exact x

-- | Multiplying all coefficients by the same power of two, or by -1, changes no bit of any root.
isScaledExactly :: Polynomial -> Property
isScaledExactly (Polynomial p) = forAll power $ \m ->
  solve (map (scaleFloat m) p) === solve p .&&. solve (map (negate . scaleFloat m) p) === solve p
  where
    power = chooseInt (-1074 - minimum (map lastBit numbers), 1023 - maximum (map exponent numbers))
    numbers = filter (/= 0) p
    lastBit x = exponent x - 53

-- | @p(-x)@ has the opposite roots, in the opposite order, within 2 ulp.
isReflected :: Polynomial -> Property
isReflected (Polynomial p) = counterexample (show (there, back)) $ length there === length back .&&. and (zipWith near there back)
  where
    there = solve p
    back = map negate (reverse (solve (zipWith (*) p signs)))
    signs = if even (length p) then cycle [-1, 1] else cycle [1, -1]
    near x y = abs (toRational x - toRational y) <= 2 * ulp x

-- | If there are as many different roots as the degree, they add to @-b \/ a@: each with an error of 1 ulp at most, or
-- 4 where one is zero.
hasSum :: Polynomial -> Property
hasSum (Polynomial p) = case p of
  a : b : rest
    | length roots == length rest + 1 && length (group roots) == length roots ->
      counterexample (show roots) (abs (sum (map toRational roots) + toRational b / toRational a) <= (if 0 `elem` roots then 4 else 1) * sum (map ulp roots))
  _ -> property True
  where
    roots = solve p

-- | With a leading coefficient of exactly zero, of either sign, the lower degree decides.
fallsInDegree :: Polynomial -> Property
fallsInDegree (Polynomial p) = case p of
  [a, b, c, d] -> quarticRoots 0 a b c d === solve p .&&. quarticRoots (-0.0) a b c d === solve p
  [_, b, c, d, e] -> cubicRoots 0 c d e === quadraticRoots c d e .&&. cubicRoots (-0.0) b c d === quadraticRoots b c d
  _ -> property True

-- | A coefficient that is NaN or infinite, wherever it stands, leaves no roots.
refusesNonFinite :: Polynomial -> Property
refusesNonFinite (Polynomial p) = conjoin [solve (take i p ++ bad : drop (i + 1) p) === [] | bad <- [0 / 0, 1 / 0, -1 / 0], i <- [0 .. length p - 1]]

-- | Integers that are roots, as often as they are, and a factor.
data WithIntegerRoots = WithIntegerRoots Integer [Integer]
  deriving (Eq, Show)

-- | Integer roots of polynomials whose coefficients are doubles, multiple or not, are found exactly.
findsIntegerRoots :: WithIntegerRoots -> Property
findsIntegerRoots (WithIntegerRoots k roots) = solve (map fromInteger (expanded k roots)) === map fromInteger (sort roots)

expanded :: Num a => a -> [a] -> [a]
expanded k = foldr (\r p -> zipWith (-) (p ++ [0]) (0 : map (r *) p)) [k]

-- | A double root, and others well apart from it (seen from zero, at least ten times as far, or a tenth, or on the
-- other side): as real numbers, before the coefficients are rounded.
data Touching = Touching Rational [Rational]
  deriving (Eq, Show)

-- | A double root is found twice although the coefficients were rounded, within 1e-10 of its size, and the others too.
--
-- Rounding moves the value at the root r by up to 2^-53 of the sum of sizes, 4 r^2 (r + |s|)^2 or less: below 3\/4
-- 2^-50 of the Taylor term r^2 (r - s)^2 if 2 (r + |s|)^2 <= 3 (r - s)^2, which |s| >= 10 r or r >= 10 |s| ensures,
-- twice.
findsTouchingRoots :: Touching -> Property
findsTouchingRoots (Touching r others) = counterexample (show (roots, map fromRational expected :: [Double])) $ length roots === length expected .&&. and (zipWith near roots expected)
  where
    roots = solve (map fromRational (expanded 1 (r : r : others)))
    expected = sort (r : r : others)
    near x y = abs (toRational x - y) <= abs y / 10 ^ (10 :: Int)

-- | Coefficients, the highest degree first, of a polynomial most of whose roots, real or complex, are near one place,
-- though not in it.
newtype Gathered = Gathered [Double]
  deriving (Eq, Show)

-- | However near the other roots are, one that is given once is in its place, and at each the polynomial vanishes, up
-- to rounding.
--
-- Where |x p'(x)| is less than 2^-46 of the sizes of the terms, twice the digits do not tell the place.
findsGatheredRoots :: Gathered -> Property
findsGatheredRoots (Gathered p) = isInPlace (Polynomial p) .&&. hasSmallResidual (Polynomial p)

-- | Coefficients of any size, zeros too. The first is not zero.
newtype Wild = Wild [Double]
  deriving (Eq, Show)

-- | Coefficients may be of any size: of the roots between 2^-1000 and 2^1000 in size, those alone among the doubles are
-- all found, and each is in its place.
findsRootsOfAnySize :: Wild -> Property
findsRootsOfAnySize (Wild p) =
  counterexample (show (solve p)) $
    conjoin [counterexample (show x) (changes x) | [x] <- group inside]
      .&&. (length (group inside) /= length inside .||. length inside === inRange)
  where
    exact = map toRational p
    inside = [x | x <- solve p, abs x > fromRational least, abs x < fromRational most]
    changes x = signum (evaluate exact (toRational x - far * ulp x)) * signum (evaluate exact (toRational x + far * ulp x)) <= 0
    far = if length (dropWhile (== 0) (reverse exact)) <= 3 then 4 else 1
    inRange = countBetween exact least most + countBetween exact (negate most) (negate least)
    most = 2 ^ (1000 :: Int)
    least = 1 / most

-------------------------------------------------------------------------------
-- Exact arithmetic

-- | The largest relative error of one rounding.
eps :: Rational
eps = 1 / 2 ^ (53 :: Int)

-- | The distance from a double to the next larger in magnitude.
ulp :: Double -> Rational
ulp x = 2 ^^ max (exponent x - 53) (-1074)

evaluate :: [Rational] -> Rational -> Rational
evaluate p x = foldl (\v a -> v * x + a) 0 p

-- | The sum of the absolute values of the terms.
sizes :: [Rational] -> Rational -> Rational
sizes p x = evaluate (map abs p) (abs x)

derivative :: [Rational] -> [Rational]
derivative p = zipWith (*) p (map toRational [length p - 1, length p - 2 .. 1])

-- | The coefficient of h^k in p(x + h).
taylor :: Int -> [Rational] -> Rational -> Rational
taylor k p x = evaluate (iterate derivative p !! k) x / toRational (product [1 .. k])

-- | How many real roots there are, multiplicity counted.
exactCount :: [Rational] -> Int
exactCount p = sum [m * (changesAt (-1) s - changesAt 1 s) | (m, f) <- squareFree p, let s = sturm f]
  where
    -- far out, the leading terms decide
    changesAt :: Rational -> [[Rational]] -> Int
    changesAt side s = variations [foldr const 0 f * side ^ (length f - 1) | f <- s]

-- | How many real roots there are in (l, h], multiplicity counted.
countBetween :: [Rational] -> Rational -> Rational -> Int
countBetween p l h = sum [m * (at l s - at h s) | (m, f) <- squareFree p, let s = sturm f]
  where
    at x s = variations (map (`evaluate` x) s)

variations :: [Rational] -> Int
variations values = length (filter (< 0) (zipWith (*) signs (drop 1 signs)))
  where
    signs = filter (/= 0) (map signum values)

-- | Sturm's chain of a square-free polynomial.
sturm :: [Rational] -> [[Rational]]
sturm p = p : go p (derivative p)
  where
    go _ [] = []
    go a b = b : go b (map negate (remainder a b))

remainder :: [Rational] -> [Rational] -> [Rational]
remainder a b = case (a, b) of
  (x : xs, y : ys)
    | length a >= length b -> remainder (zipWith (-) xs (map (x / y *) ys ++ repeat 0)) b
  _ -> dropWhile (== 0) a

quotient :: [Rational] -> [Rational] -> [Rational]
quotient a b = case (a, b) of
  (x : xs, y : ys) | length a >= length b -> x / y : quotient (zipWith (-) xs (map (x / y *) ys ++ repeat 0)) b
  _ -> []

-- | The monic greatest common divisor.
divisor :: [Rational] -> [Rational] -> [Rational]
divisor a b = case b of
  [] -> map (/ foldr const 1 a) a
  _ -> divisor b (remainder a b)

-- | Factors without multiple roots, with the multiplicities of their roots.
squareFree :: [Rational] -> [(Int, [Rational])]
squareFree p = go 1 (quotient p common) (quotient (derivative p) common)
  where
    common = divisor p (derivative p)
    go :: Int -> [Rational] -> [Rational] -> [(Int, [Rational])]
    go m b c
      | length b <= 1 = []
      | otherwise =
        let d = dropWhile (== 0) (minus c (derivative b))
            a = if null d then divisor b [] else divisor b d
         in [(m, a) | length a > 1] ++ (if null d then [] else go (m + 1) (quotient b a) (quotient d a))
    minus c b = let n = max (length c) (length b); pad x = replicate (n - length x) 0 ++ x in zipWith (-) (pad c) (pad b)

-------------------------------------------------------------------------------
-- Generators

ofSize :: Int -> Gen Double
ofSize e = do
  digits <- chooseInteger (2 ^ (52 :: Int), 2 ^ (53 :: Int) - 1)
  sign <- elements [1, -1]
  pure (sign * scaleFloat (e - 52) (fromInteger digits))

ordinary :: Gen Double
ordinary = chooseInt (-4, 4) >>= ofSize

instance Arbitrary Polynomial where
  arbitrary =
    Polynomial
      <$> ( frequency
              [ (4, elements [4, 5] >>= (`vectorOf` ordinary)),
                (2, elements [4, 5] >>= (`vectorOf` (chooseInt (-40, 40) >>= ofSize))),
                (2, elements [4, 5] >>= (`vectorOf` (fromInteger <$> chooseInteger (-9, 9)))),
                (2, fmap fromInteger . (\(WithIntegerRoots k r) -> expanded k r) <$> arbitrary),
                (3, closeRoots),
                (3, closePair),
                (2, cluster),
                (2, powerOfQuadratic),
                (4, torusLike)
              ]
              `suchThat` startsWell
          )
    where
      startsWell p = foldr const 0 p /= 0
  shrink (Polynomial p) = [Polynomial q | i <- [0 .. length p - 1], (before, x : after) <- [splitAt i p], y <- takeWhile (/= x) [0, 1, significand x], let q = before ++ y : after, foldr const 0 q /= 0]

-- | Roots at random, of which two or more are close: as the doubles nearest to the coefficients have them.
closeRoots :: Gen [Double]
closeRoots = do
  r <- toRational <$> ordinary
  gap <- (\e x -> toRational (x :: Double) * 2 ^^ e) <$> chooseInt (-30, -2) <*> choose (0.5, 1)
  others <- map toRational <$> (elements [1, 2] >>= (`vectorOf` ordinary))
  third <- elements [[], [r * (1 - gap)]]
  pure (map fromRational (expanded 1 (take 4 ([r, r * (1 + gap)] ++ third ++ others))))

-- | (x - m)^2 -+ g^2, times x^2 -+ 2^k or x -+ 2^k, exactly, with integers m and g, and m up to 2^25: real or complex
-- roots as close as 2^-25.
closePair :: Gen [Double]
closePair = do
  bits <- chooseInt (8, 25)
  m <- chooseInteger (2 ^ bits, 2 ^ (bits + 1) - 1)
  sign <- elements [1, -1]
  g <- oneof [pure 0, pure 1, chooseInteger (1, 2 ^ (bits `div` 2))]
  k <- chooseInt (0, 48)
  other <- elements [1, -1]
  let b = -2 * sign * m
      c = m * m + other * g * g
      e = other * 2 ^ k
  map fromInteger <$> elements [[1, b, c + e, b * e, c * e], [1, b + e, c + b * e, c * e]]

-- | All roots, or three of them, in one place: a fraction that is no double. Exactly, or with the last coefficient
-- moved by 1. In every second one the coefficients have 50 bits and more, so that those of the derivatives are no
-- doubles.
cluster :: Gen [Double]
cluster = do
  large <- arbitrary
  p <- if large then chooseInteger (60000, 100000) else elements [1, 3, 9, 27]
  q <- (if large then (*) <$> elements [1, -1] <*> chooseInteger (60000, 100000) else chooseInteger (-60, 60)) `suchThat` (/= 0)
  n <- if large then pure 3 else elements [3, 4]
  s <- chooseInteger (-3, 3)
  let power = iterate (\f -> zipWith (+) (map (p *) f ++ [0]) (0 : map (q *) f)) [1] !! n :: [Integer]
      times = if n == 3 && s /= 0 then zipWith (+) (power ++ [0]) (0 : map (s *) power) else power
  nudge <- elements [0, 0, 0, 1, -1]
  pure (map fromInteger (zipWith (+) times (replicate (length times - 1) 0 ++ [nudge])))

-- | (a x^2 + b x + c)^2: two double roots, mostly irrational.
powerOfQuadratic :: Gen [Double]
powerOfQuadratic = squared <$> small <*> small <*> small
  where
    small = chooseInteger (-1000, 1000)
    squared a b c = map fromInteger [a * a, 2 * a * b, b * b + 2 * a * c, 2 * b * c, c * c]

-- | s^4 + (2 G - 4 R^2 (1 - M^2)) s^2 + 8 R^2 M N s + G^2 - 4 R^2 (C - N^2), as "Dioptre.Geometry.Torus" has it; in
-- every second one, the line touches the torus, by sliding on it as far as it can be told with doubles.
torusLike :: Gen [Double]
torusLike = do
  major <- choose (0.5, 1)
  minor <- oneof [choose (0.001, 0.5), choose (0.5, 2)]
  m <- oneof [elements [0, 1, 0.5], choose (-1, 1)]
  n <- oneof [elements [0, minor, negate minor], choose (negate minor, minor)]
  c <- oneof [pure (n * n), pure ((major + minor) * (major + minor)), pure ((major - minor) * (major - minor)), choose (n * n, 4)]
  let four = 4 * major * major
      g = c + major * major - minor * minor
  pure [1, 0, 2 * g - four * (1 - m * m), 2 * four * m * n, g * g - four * (c - n * n)]

instance Arbitrary WithIntegerRoots where
  arbitrary = do
    n <- elements [3, 4]
    bound <- elements [2, 9, 100, 2000]
    roots <- vectorOf n (chooseInteger (negate bound, bound))
    same <- chooseInt (1, n)
    k <- elements [1, -1, 3, -7, 16]
    pure (WithIntegerRoots k (take n (replicate same (foldr const 0 roots) ++ roots)))

instance Arbitrary Touching where
  arbitrary = do
    r <- nonZero
    n <- elements [1, 2]
    far <- elements [10, 1 / 10]
    others <- case n :: Int of
      1 -> (: []) <$> apart r far
      _ -> (\x double y -> if double then [x, x] else [x, y]) <$> apart r far <*> arbitrary <*> apart r (far * 100)
    pure (Touching r others)
    where
      nonZero = toRational <$> oneof [ordinary, (/ 10) . fromInteger <$> chooseInteger (1, 99)]
      apart r far = do
        stretch <- toRational <$> choose (1, 2 :: Double)
        sign <- elements [1, -1]
        pure (sign * r * (if far > 1 then far * stretch else far / stretch))

-- | a h^n + ... + c h, exactly, with h = x - m, a small integer m, and integers a to c that fall by some 13 bits from
-- one to the next, or by more and less, down to 1 or so: so the slope at m, which is a root, may be 2^-50 of the sizes
-- of the terms, and it is as small at the roots next to it.
instance Arbitrary Gathered where
  arbitrary = (Gathered . map fromInteger <$> polynomial) `suchThat` (\(Gathered p) -> all ((< 2 ^ (53 :: Int)) . abs) p)
    where
      polynomial = do
        n <- elements [3, 4]
        m <- elements [1, -1, 1, -1, 3, -5]
        even' <- arbitrary
        let top = if abs m > 1 then 48 - 2 * n else 48
        a <- ofBits top
        between <- mapM (\k -> (if even' then chooseInt (13 * k, 13 * k + 3) else chooseInt (10, top)) >>= ofBits) [n - 2, n - 3 .. 1]
        c <- chooseInt (0, 4) >>= ofBits
        pure (foldl (\p k -> zipWith (-) (p ++ [k]) (0 : map (m *) p)) [a] (between ++ [c, 0]))
      ofBits :: Int -> Gen Integer
      ofBits k = (*) <$> elements [1, -1] <*> chooseInteger (2 ^ k, 2 ^ (k + 1))

instance Arbitrary Wild where
  arbitrary = Wild <$> (elements [4, 5] >>= (`vectorOf` size')) `suchThat` (\p -> foldr const 0 p /= 0)
    where
      size' = frequency [(4, chooseInt (-1000, 1000) >>= ofSize), (2, chooseInt (-100, 100) >>= ofSize), (1, pure 0), (1, elements [1, -1, 5e-324, 1.7976931348623157e308])]
  shrink (Wild p) = [Wild q | Polynomial q <- shrink (Polynomial p)]

-- | Names for what is special about a polynomial, with whether it holds. A generator must reach all of them.
corners :: Polynomial -> [(String, Bool)]
corners (Polynomial p) =
  [ ("degree 3", length p == 4),
    ("degree 4", length p == 5),
    ("no root", null roots),
    ("four different roots", length (group roots) == 4),
    ("a double root", 2 `elem` multiplicities),
    ("a triple root", 3 `elem` multiplicities),
    ("a quadruple root", 4 `elem` multiplicities),
    ("two double roots", multiplicities == [2, 2]),
    ("a double root that the exact polynomial has not", 2 `elem` multiplicities && exactCount (map toRational p) /= length roots),
    ("two roots closer than 2^-20", closer 20),
    ("two roots closer than 2^-23", closer 23),
    ("a root that is zero", 0 `elem` roots)
  ]
  where
    roots = solve p
    multiplicities = map length (group roots)
    closer :: Int -> Bool
    closer e = or [x /= y && abs (x - y) < abs x / 2 ^ e | (x, y) <- zip roots (drop 1 roots)]
