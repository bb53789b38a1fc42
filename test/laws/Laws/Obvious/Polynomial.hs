-- |
-- Module      : Laws.Obvious.Polynomial
-- Description : Polynomials with rational coefficients, and the exact places of their roots
--
-- What a line makes of an algebraic surface is a polynomial in the line's parameter. Nothing is rounded here. Roots of
-- polynomials of degree 1 and 2 are numbers u + v sqrt D with rational u, v and D, at which the sign of any other
-- polynomial can be told exactly. Roots of higher degree are told apart by Sturm's theorem, which counts the roots in
-- an interval, and shut in by halving intervals.
module Laws.Obvious.Polynomial
  ( -- * Polynomials
    Polynomial,
    constant,
    linear,
    plus,
    minus,
    times,
    scaledBy,
    valueAt,
    taylorAt,

    -- * Roots
    Place,
    placeOf,
    realRoots,
    approximately,
    signAt,
    squareRoot,
  )
where

import Data.Bits (shiftL, shiftR)
import Data.List (foldl', sortOn)
import Data.Ratio (denominator, numerator, (%))

-- | Coefficients, the constant one first; the last one is not zero.
newtype Polynomial = Polynomial [Rational]
  deriving (Eq, Show)

polynomial :: [Rational] -> Polynomial
polynomial = Polynomial . foldr (\c rest -> if c == 0 && null rest then [] else c : rest) []

-- | A number.
constant :: Rational -> Polynomial
constant c = polynomial [c]

-- | c + d t.
linear :: Rational -> Rational -> Polynomial
linear c d = polynomial [c, d]

-- | The sum, the difference, the product.
plus, minus, times :: Polynomial -> Polynomial -> Polynomial
plus (Polynomial a) (Polynomial b) = polynomial (longest a b)
  where
    longest (x : xs) (y : ys) = (x + y) : longest xs ys
    longest xs [] = xs
    longest [] ys = ys
minus a b = plus a (scaledBy (-1) b)
times (Polynomial a) (Polynomial b) = foldr (\x rest -> plus (scaledBy x (Polynomial b)) (shifted rest)) (Polynomial []) a
  where
    shifted (Polynomial cs) = polynomial (0 : cs)

-- | A multiple.
scaledBy :: Rational -> Polynomial -> Polynomial
scaledBy k (Polynomial cs) = polynomial (map (k *) cs)

-- | The value at a parameter.
valueAt :: Polynomial -> Rational -> Rational
valueAt (Polynomial cs) t = foldr (\c rest -> c + t * rest) 0 cs

-- | The coefficients of p (t + h) as a polynomial in h: value, slope, half of the second derivative, and so on.
taylorAt :: Polynomial -> Rational -> [Rational]
taylorAt (Polynomial cs) t = foldr shifted [] cs
  where
    -- c + (t + h) rest
    shifted c rest = case rest of
      [] -> [c]
      _ -> zipWith (+) (c : rest) (map (t *) rest ++ [0])

derivative :: Polynomial -> Polynomial
derivative (Polynomial cs) = polynomial (drop 1 (zipWith (*) (map fromInteger [0 ..]) cs))

-- | A real number u + v sqrt D.
data Place = Place Rational Rational Rational
  deriving (Show)

-- | A rational number.
placeOf :: Rational -> Place
placeOf u = Place u 0 0

-- | The real roots, ascending, as often as they are; none of the polynomial that is zero. Those of degree three and
-- more are rational numbers within 2^-110 of the exact ones, relatively.
realRoots :: Polynomial -> [Place]
realRoots p@(Polynomial cs) = case cs of
  [c, b] -> [placeOf (negate c / b)]
  [c, b, a] -> case compare discriminant 0 of
    LT -> []
    EQ -> [placeOf middle, placeOf middle]
    GT -> [Place middle (negate step) discriminant, Place middle step discriminant]
    where
      discriminant = b * b - 4 * a * c
      middle = negate b / (2 * a)
      step = abs (1 / (2 * a))
  _ : _ : _ : _ : _ -> sortOn approximately (concatMap (\(q, m) -> concatMap (replicate m . placeOf) (simpleRoots q)) (squareFree p))
  _ -> []

-- | The number, to 2^-250 of itself; exactly, if it is rational.
approximately :: Place -> Rational
approximately (Place u v d)
  | v == 0 || d == 0 = u
  | u * v >= 0 = u + v * root
  -- Nothing cancels: (u + v sqrt D) (u - v sqrt D) = u^2 - v^2 D.
  | otherwise = (u * u - v * v * d) / (u - v * root)
  where
    root = squareRoot d

-- | The sign of a polynomial at a place.
signAt :: Polynomial -> Place -> Int
signAt (Polynomial cs) (Place u v d) = sign (foldr next (0, 0) cs)
  where
    next c (x, y) = (c + u * x + v * y * d, u * y + v * x)
    sign (x, y)
      | y == 0 || d == 0 = signumOf x
      | x * y >= 0 = signumOf (x + y)
      | x * x > y * y * d = signumOf x
      | x * x < y * y * d = signumOf y
      | otherwise = 0

signumOf :: Rational -> Int
signumOf x = case compare x 0 of
  LT -> -1
  EQ -> 0
  GT -> 1

-- | The square root of a number that is not negative: exactly, if it is rational, or else to 2^-250 of itself.
squareRoot :: Rational -> Rational
squareRoot x
  | x <= 0 = 0
  | n * n == numerator x && m * m == denominator x = n % m
  | otherwise = integerRoot ((numerator x `shiftL` (2 * k)) `div` denominator x) % (1 `shiftL` k)
  where
    n = integerRoot (numerator x)
    m = integerRoot (denominator x)
    -- 4^k x has 500 bits before its point, and 64 more to be sure.
    k = max 0 (282 - (bits (numerator x) - bits (denominator x)) `div` 2)

bits :: Integer -> Int
bits n = 64 * length (takeWhile (> 0) (iterate (`shiftR` 64) n))

-- | The largest integer whose square is not above the number, by Newton's method from above.
integerRoot :: Integer -> Integer
integerRoot n
  | n < 2 ^ (50 :: Int) = settle (truncate (sqrt (fromInteger n :: Double)) + 1)
  | otherwise = settle ((integerRoot (n `shiftR` (2 * quarter)) + 1) `shiftL` quarter)
  where
    quarter = max 1 (bitLength n `div` 4)
    settle x = let y = (x + n `div` x) `div` 2 in if y >= x then x else settle y
    bitLength m = if m == 0 then 0 else bits m - 64 + length (takeWhile (> 0) (iterate (`shiftR` 1) (m `shiftR` (bits m - 64))))

-------------------------------------------------------------------------------
-- Sturm

-- | The factors without multiple roots, each with the multiplicity that its roots have (Yun's algorithm).
squareFree :: Polynomial -> [(Polynomial, Int)]
squareFree p = go 1 (over p g) (over (derivative p) g)
  where
    g = commonFactor p (derivative p)
    go m b c
      | degree b < 1 = []
      | otherwise = [(a, m) | degree a >= 1] ++ go (m + 1 :: Int) (over b a) (over d a)
      where
        d = minus c (derivative b)
        a = commonFactor b d

degree :: Polynomial -> Int
degree (Polynomial cs) = length cs - 1

-- | The last coefficient, which is not zero.
leading :: Polynomial -> Rational
leading (Polynomial cs) = foldl' (const id) 0 cs

-- | The greatest common divisor, with the last coefficient 1.
commonFactor :: Polynomial -> Polynomial -> Polynomial
commonFactor a b
  | degree b < 0 = scaledBy (1 / leading a) a
  | otherwise = commonFactor b (primitive (snd (divided a b)))

-- | The polynomial divided by the size of its largest coefficient, so that numbers stay small.
primitive :: Polynomial -> Polynomial
primitive p@(Polynomial cs)
  | null cs = p
  | otherwise = scaledBy (fromInteger (foldl' lcm 1 (map denominator cs)) / fromInteger (max 1 (foldl' gcd 0 (map (numerator . (* fromInteger (foldl' lcm 1 (map denominator cs)))) cs)))) p

over :: Polynomial -> Polynomial -> Polynomial
over a b = fst (divided a b)

-- | Quotient and remainder.
divided :: Polynomial -> Polynomial -> (Polynomial, Polynomial)
divided a b
  | degree a < degree b || degree b < 0 = (Polynomial [], a)
  | otherwise = let (q, r) = divided (minus a (times term b)) b in (plus term q, r)
  where
    term = polynomial (replicate (degree a - degree b) 0 ++ [leading a / leading b])

-- | The roots of a polynomial without multiple ones, each to 2^-110 of itself. (The first interval is halved at 0, so
-- that none has 0 inside.)
simpleRoots :: Polynomial -> [Rational]
simpleRoots p = concat (isolated (negate bound) bound (variations (negate bound)) (variations bound))
  where
    chain = map integral (sturm p)
    integral q = let Polynomial cs = primitive q in map numerator cs
    coefficients = concat (take 1 chain)
    -- A power of two from which on the last term exceeds all others together (Cauchy): all roots are nearer to zero.
    bound = until exceeds (* 2) (1 :: Rational)
    exceeds x = let sizes = map (fromInteger . abs) coefficients in 2 * (x ^ (length sizes - 1)) * fromInteger (abs (foldl' (const id) 0 coefficients)) > foldr (\c rest -> c + x * rest) 0 sizes
    variations t = changes (filter (/= 0) (map (\q -> signum (scaledValue q t)) chain))
    changes xs = length (filter id (zipWith (/=) xs (drop 1 xs)))
    -- Roots in (low, high].
    isolated low high atLow atHigh
      | atLow == atHigh = []
      | atLow == atHigh + 1 = [[halved low high (signum (scaledValue coefficients high))]]
      | otherwise = isolated low middle atLow atMiddle ++ isolated middle high atMiddle atHigh
      where
        middle = (low + high) / 2
        atMiddle = variations middle
    halved low high signHigh
      | signHigh == 0 = high
      | high - low <= max (abs low) (abs high) / 2 ^ (110 :: Int) = middle
      | s == signHigh = halved low middle s
      | s == 0 = middle
      | otherwise = halved middle high signHigh
      where
        middle = (low + high) / 2
        s = signum (scaledValue coefficients middle)

-- | p(n / m) times m^degree, in whole numbers.
scaledValue :: [Integer] -> Rational -> Integer
scaledValue cs t = fst (foldr next (0, 1) cs)
  where
    -- From the last coefficient down, each of the others times the power of m that it lacks.
    next c (value, power) = (value * numerator t + c * power, power * denominator t)

-- | Sturm's chain: p, p', and remainders with the opposite sign.
sturm :: Polynomial -> [Polynomial]
sturm p = takeWhile ((>= 0) . degree) (p : go p (derivative p))
  where
    go a b
      | degree b < 0 = []
      | otherwise = b : go b (primitive (scaledBy (-1) (snd (divided a b))))
