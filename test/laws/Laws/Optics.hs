-- |
-- Module      : Laws.Optics
-- Description : What is true of mirrors and of surfaces between two media
--
-- Directions, normals and indices are doubles, and so rational numbers: what the laws of optics ask of the computed
-- directions is evaluated without rounding ("Laws.Exact"), and every bound counts the roundings of the rule. In the
-- comments, \<v, v> = 1 + a and \<N, N> = 1 + b with |a|, |b| <= 8 eps, which is what 'Dioptre.Math.Vector.valid' says
-- of unit vectors; M is the sum of the |v_i N_i|, so that the computed \<v, N> is off by at most gamma 3 M.
module Laws.Optics
  ( -- * What they are tried with
    Incidence (..),
    Oblique (..),
    incidenceCorners,

    -- * Mirrors
    mirrorTurnsTheNormalPart,
    mirrorKeepsThePartAcross,
    mirrorKeepsLength,
    mirrorKeepsTheAngle,
    mirrorTwiceIsNothing,
    mirrorStaysInThePlane,
    mirrorHasTwoSides,

    -- * Two media
    refractionObeysSnell,
    refractionStaysInThePlane,
    refractionGoesThrough,
    refractionIsUnit,
    refractionReturns,
    reflectionIsTotal,
    equalIndicesChangeNothing,

    -- * Either side
    normalIsTurned,
  )
where

import Data.Maybe (fromMaybe, isJust, isNothing)
import Dioptre.Conformance.Optics (against)
import Dioptre.Math.Vector
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Laws.Draw
import Laws.Exact
import Test.QuickCheck hiding (vector)

-- | Light in a unit direction, a unit normal turned against it (or orthogonal to it), and the refractive indices on
-- this side and beyond: from 0.1 to 10.
data Incidence = Incidence Unit Unit Double Double
  deriving (Eq, Show)

instance Arbitrary Incidence where
  arbitrary = do
    (n1, n2) <- indices
    (v, n) <- frequency [(1, alongAxes), (6, turned n1 n2)]
    pure (Incidence v n n1 n2)

-- | Any direction of any length but zero, and any unit normal.
data Oblique = Oblique Vector Unit
  deriving (Eq, Show)

instance Arbitrary Oblique where
  arbitrary = oneof [Oblique <$> (anyKind >>= step) <*> (made <$> (anyKind >>= step)), (\(v, n) -> Oblique (vector v) n) <$> alongAxes]

-- | What the generator of 'Incidence' must reach.
incidenceCorners :: Incidence -> [(String, Bool)]
incidenceCorners (Incidence v n n1 n2) =
  [ ("perpendicular", c >= 1 - 4 * 2 ** (-53)),
    ("exactly grazing", c == 0),
    ("nearly grazing", c > 0 && c < 1e-6),
    ("within rounding of the critical angle", n1 > n2 && abs (c * c + q * q - 1) < 1e-14),
    ("close to the critical angle", n1 > n2 && abs (c * c + q * q - 1) > 1e-14 && abs (c * c + q * q - 1) < 1e-4),
    ("total reflection", c * c + q * q < 1 - 1e-14),
    ("into a denser medium", n2 > n1),
    ("equal indices", n1 == n2),
    ("indices next to each other", n1 /= n2 && abs (n1 - n2) < 1e-14)
  ]
  where
    c = negate (dot (vector v) (vector n))
    q = n2 / n1

indices :: Gen (Double, Double)
indices = do
  n1 <- index
  n2 <- frequency [(6, index), (1, pure n1), (1, (`nudged` n1) <$> elements [-1, 1, 2])]
  pure (n1, n2)
  where
    index = oneof [elements [1, 1, 1.33, 1.5, 2.42, 0.1, 10], choose (1, 3), choose (0.1, 10)]

-- | Directions whose products are exact.
alongAxes :: Gen (Unit, Unit)
alongAxes = do
  n <- axis
  v <- frequency [(1, pure (opposite n)), (2, axis `suchThat` (\v -> dot (vector v) (vector n) == 0))]
  pure (v, n)
  where
    axis = ($) <$> elements [id, opposite] <*> elements [alongX, alongY, alongZ]

-- | A normal in any direction, and light at an angle of incidence from 0 to 90 degrees.
turned :: Double -> Double -> Gen (Unit, Unit)
turned n1 n2 = (anyKind >>= \kind -> attempt <$> step kind <*> step kind <*> incidenceAngle) `suchThat` isJust >>= maybe discard pure
  where
    attempt a b (s, c) = do
      n <- unit a
      across <- unit (cross a b)
      v <- unit (s *^ vector across - c *^ vector n)
      if dot (vector v) (vector n) <= 0 then Just (v, n) else Nothing
    incidenceAngle = frequency ([(3, sineAndCosine <$> choose (0, pi / 2)), (1, pure (0, 1)), (1, pure (1, 0)), (2, grazing), (1, almostUpright)] ++ [(2, critical) | n1 > n2])
    sineAndCosine x = (sin x, cos x)
    grazing = (\e -> (1, 2 ** e)) <$> choose (-60, -8)
    almostUpright = (\e -> (2 ** e, 1)) <$> choose (-60, -8)
    critical = (\k -> let s = k (n2 / n1) in (s, sqrt (max 0 ((1 - s) * (1 + s))))) <$> oneof [nudged <$> chooseInt (-3, 3), (\sign e s -> s * (1 + sign * 2 ** e)) <$> elements [1, -1] <*> choose (-50, -8)]

made :: Vector -> Unit
made = fromMaybe alongX . unit

-- | |x - y| within a bound, all of them exact.
near :: Rational -> Rational -> Rational -> Property
near bound x y = counterexample (show (approximately x, approximately y, "apart", approximately (x - y), "bound", approximately bound)) (abs (x - y) <= bound)
  where
    approximately = fromRational :: Rational -> Double

-- | The vector's length within a bound.
short :: Rational -> Exact -> Property
short bound v = counterexample (show (sqrt (fromRational (squared v)) :: Double, "bound", fromRational bound :: Double)) (squared v <= bound * bound)

-------------------------------------------------------------------------------
-- Mirrors

-- | How far each component of the computed v - 2 \<v, N> N is from the exact one: 6 roundings' worth of M |N_i| from
-- the product, 2 for twice it times N_i, and those of the difference.
mirrorSlack :: Vector -> Unit -> Exact
mirrorSlack v n = (\vi ni -> gamma 11 * (m * ni + vi)) <$> magnitudes (exact v) <*> magnitudes (exact (vector n))
  where
    m = inner (magnitudes (exact v)) (magnitudes (exact (vector n)))

-- | The part along the normal changes its sign. (The normal's own length adds 2 b \<v, N>.)
mirrorTurnsTheNormalPart :: Incidence -> Property
mirrorTurnsTheNormalPart (Incidence u n' _ _) = near (inner (mirrorSlack v n') (magnitudes n) + 16 * eps * m) (inner r n) (negate (inner (exact v) n))
  where
    v = vector u
    n = exact (vector n')
    r = exact (reflected v n')
    m = inner (magnitudes (exact v)) (magnitudes n)

-- | The part across the normal stays as it is.
mirrorKeepsThePartAcross :: Incidence -> Property
mirrorKeepsThePartAcross (Incidence u n' _ _) = conjoin (near <$> components bounds <*> pure 0 <*> components (outer (r - exact v) n))
  where
    v = vector u
    n = exact (vector n')
    r = exact (reflected v n')
    bounds = pure (maximum (components (outerMagnitudes (mirrorSlack v n') n)))

-- | The reflected direction is as long as the one before: \<R, R> - \<v, v> is 4 b \<v, N>^2 and what the slack makes
-- of it.
mirrorKeepsLength :: Incidence -> Property
mirrorKeepsLength (Incidence u n' _ _) = near (32 * eps * m * m + 2 * inner (magnitudes r) slack + squared slack) (squared r) (squared (exact v))
  where
    v = vector u
    r = exact (reflected v n')
    slack = mirrorSlack v n'
    m = inner (magnitudes (exact v)) (magnitudes (exact (vector n')))

-- | The angle out is the angle in. Products and normals are off by at most 24 eps on either side, and the angle by as
-- much.
mirrorKeepsTheAngle :: Incidence -> Property
mirrorKeepsTheAngle (Incidence v n _ _) = near (64 * eps) (toRational (angle (reflected (vector v) n) (vector n))) (toRational (angle (negate (vector v)) (vector n)))

-- | Reflecting twice gives the direction again: 4 b \<v, N> N, and the slack of either reflection, the first one
-- reflected.
mirrorTwiceIsNothing :: Incidence -> Property
mirrorTwiceIsNothing (Incidence u n _ _) = conjoin (near <$> components bounds <*> pure 0 <*> components (exact (reflected r n) - exact v))
  where
    v = vector u
    r = reflected v n
    first = mirrorSlack v n
    normal = magnitudes (exact (vector n))
    m = inner (magnitudes (exact v)) normal
    -- The same bound for all three components: where one of the normal's is tiny, those of the others reach it.
    bounds = pure (maximum (components (fmap (\ni -> 32 * eps * m * ni + 2 * inner first normal * ni) normal + first + mirrorSlack r n)))

-- | Incident direction, normal and reflected direction lie in one plane.
mirrorStaysInThePlane :: Incidence -> Property
mirrorStaysInThePlane (Incidence u n _ _) = near (inner (mirrorSlack v n) (magnitudes plane)) (inner (exact (reflected v n)) plane) 0
  where
    v = vector u
    plane = outer (exact v) (exact (vector n))

-- | It does not matter which side of the mirror the normal points to.
mirrorHasTwoSides :: Oblique -> Property
mirrorHasTwoSides (Oblique v n) = reflected v n === reflected v (opposite n)

-------------------------------------------------------------------------------
-- Two media

-- | The length of what is missing of T = r v + k N in the computed T, r being the rounded n1 \/ n2: two roundings of
-- each term, with |k| <= r + 1.
throughSlack :: Rational -> Rational
throughSlack r = gamma 4 * (2 * r + 1)

-- | n1 sin a1 = n2 sin a2, and to the same side: T x N is n1 \/ n2 times v x N. (With another rounding for the
-- quotient.)
refractionObeysSnell :: Incidence -> Property
refractionObeysSnell (Incidence v n' n1 n2) =
  n1 /= n2 ==> case refracted (vector v) n' n1 n2 of
    Nothing -> discard
    Just t -> short ((throughSlack r + eps * r) * (1 + 8 * eps)) (outer (exact t) n - fmap (r *) (outer (exact (vector v)) n))
  where
    n = exact (vector n')
    r = toRational n1 / toRational n2

-- | Incident direction, normal and transmitted direction lie in one plane: \<T, v x N> = 0.
refractionStaysInThePlane :: Incidence -> Property
refractionStaysInThePlane (Incidence v n n1 n2) = case refracted (vector v) n n1 n2 of
  Nothing -> discard
  Just t -> near (throughSlack r * rootAbove (squared plane)) (inner (exact t) plane) 0
  where
    r = toRational n1 / toRational n2
    plane = outer (exact (vector v)) (exact (vector n))

-- | What passes goes on to the other side of the surface.
--
-- \<T, N> is -sqrt (1 - r^2 sin^2 a1), and computed it is off by 3 r for \<v, N>, 8 |k| for b, the slack, and two
-- roundings for k.
refractionGoesThrough :: Incidence -> Property
refractionGoesThrough (Incidence v n n1 n2) = case refracted (vector v) n n1 n2 of
  Nothing -> discard
  Just t -> let along' = inner (exact t) (exact (vector n)) in counterexample (show (fromRational along' :: Double)) (along' <= eps * (20 * r + 16))
  where
    r = toRational n1 / toRational n2

-- | The transmitted direction is unit, at the critical angle too.
--
-- With c' = c + e the computed cosine and s the computed root, \<T, T> is s^2 + r^2 (1 - c'^2), which is 1 but for the
-- roundings of s^2, and besides 2 r^2 c e + r^2 a + 2 r s e + b k^2, and the slack. With |e| <= 3 eps, s <= 1, |k| <= r
-- + 1 that is at most (25 r^2 + 34 r + 16) eps.
refractionIsUnit :: Incidence -> Property
refractionIsUnit (Incidence v n n1 n2) = case refracted (vector v) n n1 n2 of
  Nothing -> discard
  Just t -> near (unitSlack (toRational n1 / toRational n2)) (squared (exact t)) 1

unitSlack :: Rational -> Rational
unitSlack r = 32 * (1 + r) * (1 + r) * eps

-- | Light that is sent back along T returns along v.
--
-- The part across the normal comes back by the law of sines, applied twice. The part along it is known by its square
-- only, since T is unit (to unitSlack, which on the way back counts \<T, T> - 1 once more). All of it may be reflected
-- only where (r c)^2 is within rounding of zero: there T is at the critical angle.
refractionReturns :: Incidence -> Property
refractionReturns (Incidence v n' n1 n2) =
  n1 /= n2 ==> case refracted (vector v) n' n1 n2 of
    Nothing -> discard
    Just t -> case refracted (negate t) (opposite n') n2 n1 of
      Nothing -> counterexample "all of it is reflected" ((r * c) * (r * c) <= 64 * (1 + r) * (1 + r) * eps)
      Just back ->
        let b = exact back
            apart = (throughSlack (1 / r) + throughSlack r / r + 3 * eps) * (1 + unitSlack r)
            c' = inner b n
         in short apart (outer (b + exact (vector v)) n)
              .&&. near (2 * unitSlack (1 / r) + 16 * eps + 2 * apart + apart * apart) (c' * c') (c * c)
              .&&. counterexample "to the side that it came from" (c' >= negate (eps * (20 / r + 16)))
  where
    n = exact (vector n')
    r = toRational n1 / toRational n2
    c = negate (inner (exact (vector v)) n)

-- | Nothing passes exactly where c^2 + (n2 \/ n1)^2 < 1; within rounding of 1 either answer is right.
--
-- The computed c^2 is off by 2 gamma 3 M and a rounding, the square of the quotient by three roundings, and their sum
-- has one more.
reflectionIsTotal :: Incidence -> Property
reflectionIsTotal (Incidence v n n1 n2)
  | n1 == n2 = property (isJust passes)
  | c * c + q * q > 1 + slack = counterexample "passes" (isJust passes)
  | c * c + q * q < 1 - slack = counterexample "is reflected" (isNothing passes)
  | otherwise = discard
  where
    passes = refracted (vector v) n n1 n2
    c = negate (inner (exact (vector v)) (exact (vector n)))
    m = inner (magnitudes (exact (vector v))) (magnitudes (exact (vector n)))
    q = toRational n2 / toRational n1
    slack = gamma 4 * q * q + gamma 9 * m * m

-- | Equal indices change nothing, not a bit, at any angle.
equalIndicesChangeNothing :: Incidence -> Property
equalIndicesChangeNothing (Incidence v n index _) = refracted (vector v) n index index === Just (vector v)

-------------------------------------------------------------------------------
-- Either side

-- | A normal that is turned against a direction is so, is one of the two of its line, and is the same whichever of
-- them was turned; unless the direction runs along the surface, where it is left as it is.
normalIsTurned :: Oblique -> Property
normalIsTurned (Oblique v n)
  | along' n == 0 = against u n === n
  | otherwise = along' (against u n) < 0 .&&. against u n === against u (opposite n) .&&. against u n `elem` [n, opposite n]
  where
    u = made v
    along' m = dot (vector u) (vector m)
