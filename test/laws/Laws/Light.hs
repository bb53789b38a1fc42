-- |
-- Module      : Laws.Light
-- Description : What is true of colours, of the terms of illumination, and of waves
--
-- The second opinions are closed forms: of a surface, a light and a viewer in one plane everything is known from two
-- angles; waves are summed up instant by instant, and those of a row of sources by the formula of the grating.
module Laws.Light
  ( -- * Colours
    AnyColour (..),
    alphaIsTheFirsts,
    blackAddsNothing,
    whiteLetsAllThrough,
    orderDoesNotMatter,
    scalingDistributes,

    -- * Illumination
    Lit (..),
    litCorners,
    Term (..),
    terms,
    termAt,
    termIsLinear,
    termIsNeverNegative,
    lambertIsTheCosine,
    blinnIsTheHalfAngle,
    phongIsTheMirroredAngle,
    mirroredLightIsFull,
    blinnIsSymmetric,
    phongIsSymmetric,
    shininessZeroIsFull,

    -- * Wavelengths
    Visible (..),
    matchesTheTables,
    channelsAreFractions,

    -- * Waves
    Sources (..),
    averageOverInstants,
    intensityIsTheAverage,
    stepsDoNotMatter,
    intensityIsBounded,
    oneSourceIsAHalf,
    gratingHasItsFormula,
    slitsHaveFringes,
    rowIsEven,
    gridIsEven,
  )
where

import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Light.Colour
import Dioptre.Light.Illumination
import Dioptre.Light.Light (Aperture (..), Wave (..))
import Dioptre.Light.Wave
import Dioptre.Light.Wavelength (colourOfWavelength)
import Dioptre.Math.Vector
import Laws.Draw
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (scale, vector, within)

-- | The largest relative error of one rounding.
u :: Double
u = 2 ** (-53)

-- | Two numbers within a bound of each other.
within :: Double -> Double -> Double -> Property
within bound x y = counterexample (show x <> " and " <> show y <> " are " <> show (abs (x - y)) <> " apart, with a bound of " <> show bound) (abs (x - y) <= bound)

channels :: Colour -> [Double]
channels (Colour r g b _) = [r, g, b]

-------------------------------------------------------------------------------
-- Colours

-- | A colour: channels of 0, 1, between, or beyond 1; any alpha.
newtype AnyColour = AnyColour Colour
  deriving (Eq, Show)

instance Arbitrary AnyColour where
  arbitrary = AnyColour <$> (Colour <$> channel <*> channel <*> channel <*> fraction)
    where
      channel = frequency [(1, pure 0), (1, pure 1), (3, choose (0, 1)), (1, choose (1, 1000))]

-- | Sums, products and multiples are as opaque as the first colour.
alphaIsTheFirsts :: AnyColour -> AnyColour -> Property
alphaIsTheFirsts (AnyColour a) (AnyColour b) = forAll (choose (0, 10)) $ \k ->
  [alpha (plus a b), alpha (filtered a b), alpha (scaled k a)] === [alpha a, alpha a, alpha a]

-- | Black adds nothing, and lets nothing through.
blackAddsNothing :: AnyColour -> Property
blackAddsNothing (AnyColour a) = plus a black === a .&&. channels (filtered a black) === [0, 0, 0] .&&. channels (scaled 0 a) === [0, 0, 0]

-- | White lets everything through; once is once.
whiteLetsAllThrough :: AnyColour -> Property
whiteLetsAllThrough (AnyColour a) = filtered a white === a .&&. scaled 1 a === a

-- | Sums and products do not depend on the order, but for alpha.
orderDoesNotMatter :: AnyColour -> AnyColour -> Property
orderDoesNotMatter (AnyColour a) (AnyColour b) = channels (plus a b) === channels (plus b a) .&&. channels (filtered a b) === channels (filtered b a)

-- | k (a + b) = k a + k b, channel by channel: two roundings on either side.
scalingDistributes :: AnyColour -> AnyColour -> Property
scalingDistributes (AnyColour a) (AnyColour b) = forAll (choose (0, 10)) $ \k ->
  conjoin (zipWith (\x y -> within (5 * u * abs y) x y) (channels (scaled k (plus a b))) (channels (plus (scaled k a) (scaled k b))))

-------------------------------------------------------------------------------
-- Illumination

-- | A light and a surface colour; a normal, the way the light travels, and the way the look goes, all unit; a
-- shininess.
data Lit = Lit Colour Colour Unit Unit Unit Double
  deriving (Eq, Show)

instance Arbitrary Lit where
  arbitrary = do
    AnyColour light <- arbitrary
    AnyColour surface <- arbitrary
    n <- direction
    d <- oneof [direction, direction, elements [n, opposite n], across n]
    v <- oneof [direction, direction, elements [n, opposite n, d, opposite d], across n]
    Lit light surface n d v <$> shininess
    where
      direction = oneof [elements [alongX, alongY, alongZ, opposite alongX, opposite alongY, opposite alongZ], (anyKind >>= step) `suchThatMap` unit]
      across n = (cross (vector n) . vector <$> direction) `suchThatMap` unit

-- | Exponents from 0 to 200.
shininess :: Gen Double
shininess = oneof [elements [0, 1, 20, 200], choose (0, 1), choose (1, 200)]

-- | What the generator of 'Lit' must reach.
litCorners :: Lit -> [(String, Bool)]
litCorners (Lit _ _ n d v k) =
  [ ("the light from before", dot (vector n) (vector d) < 0),
    ("the light from behind", dot (vector n) (vector d) > 0),
    ("the light along the surface", abs (dot (vector n) (vector d)) < 1e-15),
    ("light and viewer exactly opposite", vector v == negate (vector d)),
    ("the viewer at the light", v == d),
    ("shininess 0", k == 0),
    ("shininess 200", k == 200)
  ]

-- | The terms that depend on directions.
data Term = Lambert | BlinnTerm | PhongTerm
  deriving (Eq, Show, Enum, Bounded)

terms :: [Term]
terms = [minBound ..]

-- | A term with that light.
termAt :: Term -> Colour -> Lit -> Colour
termAt term light (Lit _ surface n d v k) = case term of
  Lambert -> lambert light surface n (vector d)
  BlinnTerm -> blinn light surface n (vector d) (vector v) k
  PhongTerm -> phong light surface n (vector d) (vector v) k

-- | Twice the light gives twice the colour, and two lights give the sum of what each one gives: exactly so for twice,
-- and for the sum with three roundings on either side. (The power of 200 may be so small that digits are lost, of
-- numbers below 1e-300.)
termIsLinear :: Term -> Lit -> AnyColour -> Property
termIsLinear term lit@(Lit light _ _ _ _ _) (AnyColour other) =
  alike 0 (scaled 2 light) [light, light] .&&. alike (8 * u) (plus light other) [light, other]
  where
    alike bound together parts =
      conjoin (zipWith (\x y -> within (bound * y + 1e-300) x y) (channels (termAt term together lit)) (foldr (zipWith (+) . channels . (\l -> termAt term l lit)) [0, 0, 0] parts))

-- | No term is below zero in any channel, or not a number; where nothing arrives it is black, with black's alpha, and
-- otherwise as opaque as the light.
termIsNeverNegative :: Term -> Lit -> Property
termIsNeverNegative term lit@(Lit light _ _ _ _ _) =
  counterexample (show c) (all (>= 0) (channels c) && (c == black || alpha c == alpha light))
  where
    c = termAt term light lit

-- | A light at an angle a from the normal: light . surface . cos a, and black beyond a right angle.
--
-- The sine and the cosine have an ulp each, and the inner product with the axis adds nothing: a few roundings.
lambertIsTheCosine :: AnyColour -> AnyColour -> Property
lambertIsTheCosine (AnyColour light) (AnyColour surface) = forAll angleFromNormal $ \a ->
  let factor = if abs a < pi / 2 then cos a else 0
   in conjoin (zipWith3 (\x l s -> within (4 * u * l * s) x (l * s * factor)) (channels (lambert light surface alongZ (arriving a))) (channels light) (channels surface))

angleFromNormal :: Gen Double
angleFromNormal = oneof [elements [0, pi / 3, negate pi / 3, pi / 4, pi / 2 - 1e-9, pi / 2 + 1e-9, pi], choose (negate pi, pi)]

-- | Light that comes from an angle to the z axis, and the look of a viewer who stands there.
arriving :: Double -> Vector
arriving a = V3 (negate (sin a)) 0 (negate (cos a))

-- | With the light at an angle a to the normal and the viewer at b in the same plane, the half way is at (a + b) \/ 2,
-- and Blinn's factor the power of its cosine.
--
-- Sines and cosines have an ulp each, their sum is at least 0.34 long (a and b are at most 80 degrees), and its
-- quotient with the length has 2 (6 \/ 0.34 + 4) roundings; the angle has three. A power of k makes that k times as
-- much.
blinnIsTheHalfAngle :: AnyColour -> AnyColour -> Property
blinnIsTheHalfAngle (AnyColour light) (AnyColour surface) = forAll ((,,) <$> slant <*> slant <*> whole) $ \(a, b, k) ->
  conjoin (zipWith3 (\x l s -> within (l * s * (k + 1) * 64 * u) x (l * s * cos ((a + b) / 2) ** k)) (channels (blinn light surface alongZ (arriving a) (arriving b) k)) (channels light) (channels surface))

-- | An angle between -80 and 80 degrees; and an exponent that is 0 or at least 1, whose power has no infinite slope.
slant, whole :: Gen Double
slant = oneof [elements [0, 0.5, -0.5, 1.3, -1.3], choose (-1.39, 1.39)]
whole = oneof [elements [0, 1, 20, 200], choose (1, 200)]

-- | The light at a on one side is mirrored to a on the other side; the viewer at b sees the power of cos (a + b), and
-- nothing where that is negative.
phongIsTheMirroredAngle :: AnyColour -> AnyColour -> Property
phongIsTheMirroredAngle (AnyColour light) (AnyColour surface) = forAll (((,,) <$> slant <*> slant <*> whole) `suchThat` \(a, b, _) -> abs (cos (a + b)) > 1e-9) $ \(a, b, k) ->
  let factor = if cos (a + b) < 0 then 0 else cos (a + b) ** k
   in conjoin (zipWith3 (\x l s -> within (l * s * (k + 1) * 16 * u) x (l * s * factor)) (channels (phong light surface alongZ (arriving a) (arriving b) k)) (channels light) (channels surface))

-- | A viewer in the mirror direction sees the full light, whatever the shininess; with either highlight.
--
-- R is unit to 32 + 22 roundings (see "Laws.Optics"), and so is the half way's product with N; the power of k makes
-- that k times as much. Blinn's half way is as long as twice the cosine, by which its roundings are divided.
mirroredLightIsFull :: Lit -> Property
mirroredLightIsFull (Lit light surface n d _ k) = abs c > 1e-3 ==> full (64 * u) PhongTerm .&&. full (64 * u / abs c) BlinnTerm
  where
    c = dot (vector d) (vector n)
    -- Turned against the light.
    n' = if c > 0 then opposite n else n
    v = negate (vector d - (2 * dot (vector d) (vector n)) *^ vector n)
    full bound term =
      counterexample (show term) $
        conjoin (zipWith3 (\x l s -> within (l * s * (k + 1) * bound) x (l * s)) (channels (at term)) (channels light) (channels surface))
    at term = case term of
      PhongTerm -> phong light surface n' (vector d) v k
      _ -> blinn light surface n' (vector d) v k

-- | Exchanging light and viewer changes nothing in Blinn's highlight, not a bit.
blinnIsSymmetric :: Lit -> Property
blinnIsSymmetric (Lit light surface n d v k) = blinn light surface n (vector d) (vector v) k === blinn light surface n (vector v) (vector d) k

-- | Exchanging light and viewer changes nothing in Phong's highlight but roundings: \<R, E> is -\<d, v> + 2 \<d, N>
-- \<N, v> either way, each of the two products with up to 12 roundings. (Near 0 the sign is one of them, and with
-- exponents below 1 the slope is infinite there.)
phongIsSymmetric :: Lit -> Property
phongIsSymmetric (Lit light surface n d v k) = abs facing > 1e-3 ==> conjoin (zipWith3 (\x y m -> within (m * (k + 1) * 32 * u / abs facing) x y) (at d v) (at v d) (zipWith (*) (channels light) (channels surface)))
  where
    facing = 2 * dot (vector d) (vector n) * dot (vector n) (vector v) - dot (vector d) (vector v)
    at a b = channels (phong light surface n (vector a) (vector b) k)

-- | Shininess 0 is the factor 1: the full light or black.
shininessZeroIsFull :: Lit -> Property
shininessZeroIsFull (Lit light surface n d v _) = conjoin [termAt term light (Lit light surface n d v 0) `elem'` [black, filtered light surface] | term <- [BlinnTerm, PhongTerm]]
  where
    elem' x xs = counterexample (show x) (x `elem` xs)

-------------------------------------------------------------------------------
-- Wavelengths

-- | A wavelength that can be seen, in nanometres; the centres of the lobes are frequent.
newtype Visible = Visible Double
  deriving (Eq, Show)

instance Arbitrary Visible where
  arbitrary = Visible <$> oneof [elements [380, 780, 442, 599.8, 501.1, 568.8, 530.9, 437, 459], choose (380, 780)]

-- | The same colour from tables, one row a lobe and one row a channel.
--
-- Rounding: each lobe's exponent is below 700 and known to 6 roundings; where it is above 37 the lobe is below u. So
-- the sums are known to 40 \* 6 roundings, of at most 5; the transfer's slope is at most 12.92.
matchesTheTables :: Visible -> Property
matchesTheTables (Visible l) = conjoin (zipWith (within (40 * 6 * 5 * 12.92 * u)) (channels (colourOfWavelength l)) (map screen primaries))
  where
    lobes =
      [ [(0.362, 442, 0.0624, 0.0374), (1.056, 599.8, 0.0264, 0.0323), (-0.065, 501.1, 0.0490, 0.0382)],
        [(0.821, 568.8, 0.0213, 0.0247), (0.286, 530.9, 0.0613, 0.0322)],
        [(1.217, 437, 0.0845, 0.0278), (0.681, 459, 0.0385, 0.0725)]
      ]
    primaries = [[3.2406255, -1.537208, -0.4986286], [-0.9689307, 1.8757561, 0.0415175], [0.0557101, -0.2040211, 1.0569959]]
    xyz = [sum [height * exp (negate (((l - centre) * (if l < centre then left else right)) ^ (2 :: Int)) / 2) | (height, centre, left, right) <- row] | row <- lobes]
    screen row = let c = max 0 (min 1 (sum (zipWith (*) row xyz))) in if c <= 0.0031308 then 12.92 * c else 1.055 * c ** (1 / 2.4) - 0.055

-- | Every channel is from 0 to 1, and the colour is opaque and not black.
channelsAreFractions :: Visible -> Property
channelsAreFractions (Visible l) = counterexample (show c) (all (\x -> 0 <= x && x <= 1) (channels c) && alpha c == 1 && any (> 0) (channels c))
  where
    c = colourOfWavelength l

-------------------------------------------------------------------------------
-- Waves

-- | A wavelength, sources, and a place: all within some hundred wavelengths, so that phases keep their digits.
data Sources = Sources Double [Point] Point
  deriving (Eq, Show)

instance Arbitrary Sources where
  arbitrary = do
    Visible l <- arbitrary
    n <- frequency [(1, pure 1), (2, pure 2), (4, chooseInt (1, 12))]
    Sources l <$> vectorOf n place <*> place
    where
      place = V3 <$> coordinate <*> coordinate <*> coordinate
      coordinate = oneof [pure 0, (* 1e-7) . fromIntegral <$> chooseInt (-100, 100), choose (-1e-5, 1e-5)]
  shrink (Sources l points p) = [Sources l points' p | points' <- shrinkList (const []) points, not (null points')]

packedPoints :: [Point] -> Unboxed.Vector (Double, Double, Double)
packedPoints points = Unboxed.fromList [(x, y, z) | V3 x y z <- points]

-- | The sum of the rule: at each of the instants of a period the waves are added and squared; then their mean, divided
-- by the square of the number of sources.
averageOverInstants :: Int -> Double -> [Point] -> Point -> Double
averageOverInstants steps l points p = sum [square (sum [wave r (fromIntegral i / fromIntegral steps) | r <- map (distance p) points]) | i <- [0 .. steps - 1]] / fromIntegral steps / square (fromIntegral (length points))
  where
    -- At a distance, at a fraction of the period.
    wave r part = sin (2 * pi * (r / (l * 1e-9) - part))
    square x = x * x

-- | The intensity is that sum, for any number of steps, also for one and two.
--
-- Each phase has some 8 roundings on either side; the mean's slope in a phase is at most 2 \/ n, and the sum over the
-- sources has n more roundings.
intensityIsTheAverage :: Sources -> Property
intensityIsTheAverage (Sources l points p) = forAll (oneof [chooseInt (1, 4), chooseInt (1, 40)]) $ \steps ->
  within (phaseSlack l points p) (intensity (Wave l steps 0) (packedPoints points) p) (averageOverInstants steps l points p)

phaseSlack :: Double -> [Point] -> Point -> Double
phaseSlack l points p = u * (32 * (2 * pi) * (1 + maximum (map (distance p) points) / (l * 1e-9)) + 8 * fromIntegral (length points))

-- | For three steps and more their number does not matter, not a bit.
stepsDoNotMatter :: Sources -> Property
stepsDoNotMatter (Sources l points p) = forAll (chooseInt (4, 1000)) $ \steps -> at steps === at 3
  where
    at steps = intensity (Wave l steps 0) (packedPoints points) p

-- | The intensity is from 0 to 1\/2, or to 1 for one and two steps; with the roundings of the sum.
intensityIsBounded :: Sources -> Property
intensityIsBounded (Sources l points p) = conjoin [counterexample (show (steps, i)) (0 <= i && i <= most * (1 + u * (8 + 4 * fromIntegral (length points)))) | (steps, most) <- [(1, 1), (2, 1), (3, 0.5), (10, 0.5)], let i = at steps]
  where
    at steps = intensity (Wave l steps 0) (packedPoints points) p

-- | One source gives 1\/2 everywhere: sin^2 + cos^2, with an ulp each and three roundings.
oneSourceIsAHalf :: Sources -> Property
oneSourceIsAHalf (Sources l points p) = conjoin [within (6 * u) (intensity (Wave l 3 0) (packedPoints [q]) p) 0.5 | q <- points]

-- | On the line of a row of n sources, d apart, phases advance by delta = k d from one to the next, and the intensity
-- is that of the grating: 1\/2 (sin (n delta \/ 2) \/ (n sin (delta \/ 2)))^2.
gratingHasItsFormula :: Visible -> Property
gratingHasItsFormula (Visible l) = forAll ((,) <$> chooseInt (2, 9) <*> choose (0.05, 0.95)) $ \(n, part) ->
  let d = part * l * 1e-9
      sources = linearOscillators n (0, V3 (fromIntegral (n - 1) * d) 0 0)
      p = V3 (20 * l * 1e-9) 0 0
      half = pi * part
      expected = 0.5 * (sin (fromIntegral n * half) / (fromIntegral n * sin half)) ^ (2 :: Int)
   in within (phaseSlack l sources p + 64 * u) (intensity (Wave l 10 n) (packedPoints sources) p) expected

-- | Two slits, 3 L apart, and a screen 4 L behind one of them: the ways there are 4 L and 5 L. Where their difference L
-- is a whole number of wavelengths it is bright, 1\/2, and where it is a half more it is dark, 0. Near either the
-- intensity is flat: the error is the square of the phases'.
slitsHaveFringes :: Visible -> Property
slitsHaveFringes (Visible l) = forAll (chooseInt (1, 40)) $ \m ->
  let at ways =
        let len = ways * l * 1e-9
         in intensity (Wave l 3 2) (packedPoints [0, V3 0 (3 * len) 0]) (V3 (4 * len) 0 0)
      slack ways = u * 16 * 2 * pi * 5 * ways
      square x = x * x
      whole' = fromIntegral m
   in within (square (slack whole') + 8 * u) (at whole') 0.5 .&&. within (square (slack (whole' + 0.5))) (at (whole' + 0.5)) 0

-- | A row of sources starts and ends at the two points exactly, and goes from one to the other in equal steps, each
-- known to a few roundings.
rowIsEven :: Property
rowIsEven = forAll ((,,) <$> chooseInt (2, 30) <*> point Full <*> point Full) $ \(n, a, b) ->
  let row = linearOscillators n (a, b)
      size = maximum (abs <$> [x | V3 p q r <- [a, b], x <- [p, q, r]])
      steps = [modulus (q - p - (1 / fromIntegral (n - 1)) *^ (b - a)) | (p, q) <- zip row (drop 1 row)]
   in length row === n .&&. take 1 row === [a] .&&. counterexample (show (last row, steps)) (modulus (last row - b) <= 8 * u * size && all (<= 32 * u * size) steps)

-- | A grid has its shorter side's number of sources along the shorter side, steps along the longer side that are not
-- longer, and one step fewer would be too few; a source in each corner; and all of them in the plane of the opening.
--
-- A cross product of unit vectors leaves the plane across either of them by 3 roundings, whatever the angle between
-- them: so far does @right@ lean against the normal, and @up@, which is made unit, 4 more. Of places no farther than
-- the corners that makes 8 roundings of their distance; the four products of a place make 5, its three sums 3, and the
-- product with the normal 4.
gridIsEven :: Property
gridIsEven = forAll ((,,,) <$> chooseInt (2, 7) <*> side <*> side <*> ((,) <$> step Full <*> step Full)) $ \(n, w, h, (front, up)) ->
  let aperture = Aperture w h front up
      (nx, ny) = oscillatorGrid n aperture
      points = planarOscillators (\_ _ -> True) 0 n aperture
      (short, long) = (min w h, max w h)
      pace = short / fromIntegral (n - 1)
      along = fromIntegral (max nx ny - 1)
      -- From the centre: the corners are the farthest.
      far = modulus (V3 (w / 2) (h / 2) 0)
      normal = maybe 0 vector (unit front)
   in modulus (cross front up) > 1e-6 * modulus front * modulus up && ratio w h ==> counterexample (show (nx, ny)) $
        min nx ny === toInteger n
          .&&. (if w < h then nx else ny) === toInteger n
          .&&. counterexample "paces" (long / along <= pace * (1 + 4 * u) && (along <= 1 || long / (along - 1) > pace * (1 - 4 * u)))
          .&&. toInteger (length points) === nx * ny
          .&&. counterexample "corners" (length [() | p <- points, abs (modulus p - far) <= 32 * u * far] === 4)
          .&&. counterexample "plane" (all (\p -> abs (dot p normal) <= 32 * u * far) points)
          .&&. counterexample "centre" (modulus (sum points) <= 64 * u * far * fromIntegral (length points))
  where
    side = oneof [elements [1, 2, 0.5, 3], choose (0.1, 4)]
    ratio w h = max w h / min w h < 12
