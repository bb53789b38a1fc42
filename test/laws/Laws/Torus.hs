-- |
-- Module      : Laws.Torus
-- Description : What is true where rays meet tori
--
-- The second opinion is the torus's other equation, F = ((rho - R)^2 + h^2 - r^2) ((rho + R)^2 + h^2 - r^2), whose sign
-- is read off at many places of the line: no polynomial is expanded, and no root is solved for.
module Laws.Torus
  ( -- * Tori and rays
    Meeting (..),
    meetings,
    corners,

    -- * Laws of parameters
    areOnTheTorus,
    areEvenAndAscending,
    areWhereTheSignChanges,
    moveAlong,
    turnAlong,
    growAlong,
    areInverseToTheDirection,

    -- * Laws of normals
    areUnitAndAlongTheGradient,

    -- * Laws of the inside
    isBetweenHits,
    isTotalOnTheAxis,
  )
where

import Data.List (sort)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Torus (torusContains, torusNormal, torusParameters)
import Dioptre.Math.Tolerance (roundThickness)
import Dioptre.Math.Vector
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-- | Centre, axis, radii, and a ray that passes nearby.
data Meeting = Meeting Point Unit Double Double Ray
  deriving (Eq, Show)

-- | Where they meet.
meetings :: Meeting -> [Double]
meetings (Meeting p n major minor r) = torusParameters p n major minor r

-- | Height and distance from the axis.
cylindrical :: Point -> Unit -> Point -> (Double, Double)
cylindrical p n v = (h, modulus (w - h *^ vector n))
  where
    w = v - p
    h = dot (vector n) w

-- | The two factors of F.
sheets :: Meeting -> Point -> (Double, Double)
sheets (Meeting p n major minor _) v = (factor (rho - major), factor (rho + major))
  where
    (h, rho) = cylindrical p n v
    factor x = (x * x + h * h) - minor * minor

equation :: Meeting -> Point -> Double
equation m v = let (a, b) = sheets m v in a * b

-- | What rounding may do to a point at a parameter: the coordinates and the terms that make them, in units of 2^-52.
blur :: Meeting -> Double -> Double
blur (Meeting p _ _ _ r) t = 2 ** (-52) * (modulus p + 2 * modulus (origin r - p) + abs t * modulus (direction r))

extent :: Meeting -> Double
extent (Meeting _ _ major minor _) = major + minor

-- | At each parameter |F| is at most 2^-44 (R + r)^4, and 32 (R + r)^3 times the blur of the point. (The gradient of F
-- is 4 (|v|^2 + k) v - 8 R^2 (v - h n) or less than 12 (R + r)^3.) For a ring torus, the distance from the circle is r,
-- within 2^-44 (R + r)^4 \/ (8 r R (R - r)) and some blurs.
areOnTheTorus :: Meeting -> Property
areOnTheTorus m@(Meeting p n major minor r) = conjoin [counterexample (show (t, equation m (position r t))) (small t .&&. distant t) | t <- meetings m]
  where
    l = extent m
    small t = property (abs (equation m (position r t)) <= 2 ** (-44) * l ** 4 + 32 * l ** 3 * blur m t)
    distant t
      | minor > 0.9 * major = property True
      | otherwise =
        let (h, rho) = cylindrical p n (position r t)
            off = abs (sqrt ((rho - major) * (rho - major) + h * h) - minor)
         in counterexample (show off) (off <= offTheRing m t)

-- | How far from a ring torus a hit may be.
offTheRing :: Meeting -> Double -> Double
offTheRing m@(Meeting _ _ major minor _) t = 2 ** (-44) * extent m ** 4 / (8 * minor * major * (major - minor)) + 4 * blur m t

-- | There are 0, 2 or 4, ascending.
areEvenAndAscending :: Meeting -> Property
areEvenAndAscending m = counterexample (show ts) $ ts === sort ts .&&. even (length ts) .&&. length ts <= 4
  where
    ts = meetings m

-- | Between two places of the line, the number of parameters is odd if F has another sign there, and even if it has the
-- same, provided that |F| is above what rounding does to it.
areWhereTheSignChanges :: Meeting -> Property
areWhereTheSignChanges m@(Meeting p _ _ _ r) = conjoin (zipWith agree clear (drop 1 clear))
  where
    l = extent m
    d = direction r
    middle = dot (p - origin r) d / quadrance d
    places = [middle + 1.01 * l / modulus d * (i / 150) | i <- [-150 .. 150]]
    clear = [(t, f) | t <- places, let f = equation m (position r t), abs f > 2 ** (-40) * l ** 4 + 64 * l ** 3 * blur m t]
    agree (s, f) (t, g) =
      let found = length [x | x <- meetings m, x > s, x < t]
       in counterexample (show (s, f, t, g, meetings m)) (odd found === (f * g < 0))

-- | Moving torus and ray by the same vector, where that is exact, leaves the parameters alone bit for bit.
moveAlong :: Meeting -> Property
moveAlong (Meeting p n major minor r) = forAll (V3 <$> whole <*> whole <*> whole) $ \by ->
  let p' = coarse <$> p
      o' = coarse <$> origin r
   in torusParameters (p' + by) n major minor (ray (o' + by) (direction r)) === torusParameters p' n major minor (ray o' (direction r))
  where
    whole = fromInteger <$> chooseInteger (-1000, 1000)
    coarse x = fromInteger (round (x * 1024)) / 1024

-- | A quarter turn about the z axis of the world, or a mirror across a plane of the axes, leaves the parameters alone
-- bit for bit.
turnAlong :: Meeting -> Property
turnAlong (Meeting p n major minor r) = conjoin $ do
  turn <- [\(V3 x y z) -> V3 (negate y) x z, \(V3 x y z) -> V3 (negate x) y z, \(V3 x y z) -> V3 x y (negate z)]
  case unit (turn (vector n)) of
    Just n' | vector n' == turn (vector n) -> [torusParameters (turn p) n' major minor (ray (turn (origin r)) (turn (direction r))) === torusParameters p n major minor r]
    _ -> []

-- | Multiplying every length by a power of two leaves the parameters alone bit for bit.
growAlong :: Meeting -> Property
growAlong m@(Meeting p n major minor r) = forAll (chooseInt (-60, 60)) $ \k ->
  let by = scaleFloat k
   in torusParameters (by <$> p) n (by major) (by minor) (ray (by <$> origin r) (by <$> direction r)) === meetings m

-- | A direction 2^k as long gives parameters 2^-k as large, bit for bit: the direction may have any length.
areInverseToTheDirection :: Meeting -> Property
areInverseToTheDirection m@(Meeting p n major minor r) = forAll (chooseInt (-60, 60)) $ \k ->
  torusParameters p n major minor (ray (origin r) (scaleFloat k <$> direction r)) === map (scaleFloat (negate k)) (meetings m)

-- | The normal is unit, and along the gradient of F, which is 2 d times the other factor, with d the distance from the
-- circle: outwards where that is positive, as on a ring and on the outer sheet of a spindle, and inwards on the inner
-- sheet.
--
-- With f the factor of the sheet, which is nearly 0, and g the other, the gradient is g grad f + f grad g. The first
-- term is along the normal and 2 d g long. The second is at most 4 l |f| long, as |grad g| is twice the distance from
-- the circle's far side, which is at most 2 l; of it, 4 R |f| is across the normal at most. Roundings, in units of
-- 2^-53 l^3: 76 in the gradient, 32 in the normal (4 R \/ r + 4 of its direction, times the gradient, 8 R r rho), 100
-- in 2 d g, 64 in f, 84 in the products: less than 512 together.
areUnitAndAlongTheGradient :: Meeting -> Property
areUnitAndAlongTheGradient m@(Meeting p n major minor r) = conjoin [along (position r t) | t <- meetings m]
  where
    l = extent m
    roundings = 512 * 2 ** (-53) * l ** 3
    along v =
      let w = v - p
          h = dot (vector n) w
          (_, rho) = cylindrical p n v
          g = quadrance w + (major - minor) * (major + minor)
          gradient = 4 * g *^ w - 8 * major * major *^ (w - h *^ vector n)
          normal = torusNormal p n major minor v
          (outer, inner) = sheets m v
          (mine, other, away) = if g < 0 then (inner, outer, rho + major) else (outer, inner, rho - major)
          fromCircle = sqrt (away * away + h * h)
       in counterexample (show (v, normal, gradient, mine)) $
            valid normal
              .&&. modulus (cross (vector normal) gradient) <= 4 * major * abs mine + roundings
              .&&. abs (dot (vector normal) gradient - 2 * fromCircle * other) <= 4 * l * abs mine + roundings

-- | Half way between where a line enters a ring torus and where it leaves it, it is inside, and between leaving and
-- entering it is not; unless it is on the surface, 'roundThickness' of r deep, or no farther from it than the hits
-- themselves may be (see 'areOnTheTorus').
isBetweenHits :: Meeting -> Property
isBetweenHits m@(Meeting p n major minor r) = minor < major && length ts `elem` [2, 4] ==> conjoin (zipWith3 check (cycle [True, False]) ts (drop 1 ts))
  where
    ts = meetings m
    check expected s t =
      let middle = s + (t - s) / 2
          v = position r middle
          (h, rho) = cylindrical p n v
          off = abs (sqrt ((rho - major) * (rho - major) + h * h) - minor)
       in counterexample (show (s, t, off)) (off <= roundThickness * minor + offTheRing m middle || torusContains p n major minor v == expected)

-- | On the axis everything has an answer: the normal is unit, and inside is what is nearer to the circle than r less
-- its 'roundThickness'.
--
-- The point is rounded to 2^-53 of |P| + 2 |h| in each coordinate, its height and its distance from the axis by 12
-- roundings of h, and its distance from the circle by 4 of R + |h|: less than 32 together, of |P| + |h| + R.
isTotalOnTheAxis :: Meeting -> Property
isTotalOnTheAxis (Meeting p n major minor _) = conjoin $ do
  h <- [0, 1, -1, minor, negate minor]
  let v = p + h *^ vector n
      away = sqrt (major * major + h * h) - (1 - roundThickness) * minor
  pure $
    counterexample (show h) $
      valid (torusNormal p n major minor v)
        .&&. (torusContains p n major minor v === (away < 0) .||. abs away <= 32 * 2 ** (-53) * (modulus p + abs h + major))

-------------------------------------------------------------------------------
-- Generators

instance Arbitrary Meeting where
  arbitrary = do
    p <- oneof [pure 0, V3 <$> choose (-10, 10) <*> choose (-10, 10) <*> choose (-10, 10)]
    n <- oneof [elements [alongX, alongY, alongZ, opposite alongZ], direction']
    major <- oneof [pure 1, pure 2, choose (0.1, 10)]
    minor <- (major *) <$> oneof [choose (0.01, 0.1), choose (0.1, 0.9), pure 0.5, pure 1, choose (1, 3)]
    target <- (p +) <$> oneof [near n major minor, grazing n major minor]
    away <- (10 **) <$> choose (-2, 3.5)
    toward <- oneof [direction', elements [alongX, alongY, alongZ, n]]
    stretch <- oneof [pure 1, (2 **) <$> choose (-20, 20)]
    pure (Meeting p n major minor (ray (target - away *^ vector toward) (stretch *^ vector toward)))

-- | A unit vector in any direction.
direction' :: Gen Unit
direction' = do
  v <- V3 <$> choose (-1, 1) <*> choose (-1, 1) <*> choose (-1, 1)
  maybe direction' pure (unit v)

-- | A vector across another.
across :: Unit -> Gen Unit
across n = do
  v <- direction'
  maybe (across n) pure (unit (vector v - dot (vector v) (vector n) *^ vector n))

-- | A point somewhere near the tube.
near :: Unit -> Double -> Double -> Gen Vector
near n major minor = do
  e <- across n
  v <- direction'
  out <- choose (0, 1.2)
  pure (major *^ vector e + out * minor *^ vector v)

-- | A point of the outermost, innermost, uppermost or lowest circle.
grazing :: Unit -> Double -> Double -> Gen Vector
grazing n major minor = do
  e <- across n
  elements [(major + minor) *^ vector e, (major - minor) *^ vector e, major *^ vector e + minor *^ vector n, major *^ vector e - minor *^ vector n]

-- | Names for what is special, with whether it holds. A generator must reach all of them.
corners :: Meeting -> [(String, Bool)]
corners m@(Meeting p n major minor r) =
  [ ("no hit", null ts),
    ("two hits", length ts == 2),
    ("four hits", length ts == 4),
    ("touches", or (zipWith (==) ts (drop 1 ts))),
    ("a spindle", minor > major),
    ("a horn", minor == major),
    ("a hit on the inner sheet", or [snd (sheets m v) < 1e-9 && rho > 1e-6 | t <- ts, let v = position r t; (_, rho) = cylindrical p n v, abs (snd (sheets m v)) < 1e-9]),
    ("seen from a hundred times its size", modulus (origin r - p) > 100 * extent m),
    ("hits behind the origin", any (< 0) ts),
    ("a direction that is not unit", abs (modulus (direction r) - 1) > 0.1)
  ]
  where
    ts = meetings m
