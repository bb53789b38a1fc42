-- |
-- Module      : Laws.Bounds
-- Description : What is true of boxes along the axes
--
-- Whether a line meets a box is decided a second time with rational numbers, which do not round.
module Laws.Bounds
  ( -- * Drawn things
    Boxed (..),
    Body (..),
    Aimed (..),
    corners,

    -- * Laws of boxes
    isOrdered,
    unionIsASemilattice,
    unionHoldsBoth,
    transformedHolds,

    -- * Laws of the boxes of shapes
    holdsItsShape,
    isTight,
    holdsHits,
    holdsHitsOfShapes,

    -- * Laws of rays
    exactInterval,
    neverMissesWhatItHolds,
    agreesWithTheExactAnswer,
    goesNowhereWithoutLength,
    knowsItsFirstFaces,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Bounds
import Dioptre.Geometry.Box hiding (around)
import Dioptre.Geometry.Cap (faceDepth)
import Dioptre.Geometry.Prepared (parameters)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereParameters)
import Dioptre.Geometry.Torus (torusParameters)
import Dioptre.Geometry.Triangle (Corners (..), smoothTriangleFlat, triangleNormal, trianglePoints)
import Dioptre.Math.Transform (identity, placement, transform, transformPosition)
import Dioptre.Math.Vector
import qualified Laws.Aim as Aim
import Laws.Draw (Kind (..), mix, nudged)
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-- | A box.
newtype Boxed = Boxed Box
  deriving (Eq, Show)

-- | A shape, by the numbers of its box.
data Body
  = OfSphere Point Double
  | OfCube Point Double
  | OfTriangle Point Point Point
  | OfDisk Point Unit Double
  | OfTube Point Point Double
  | OfCone Point Point Double
  | OfTorus Point Unit Double Double
  | OfCap Point Unit Double Double
  | OfLens Point Point Double (Double, Double)
  deriving (Eq, Show)

-- | A box and a ray that is aimed at a point of it, or near it; often along an axis, often at an edge.
data Aimed = Aimed Box Ray
  deriving (Eq, Show)

boxOf :: Body -> Box
boxOf body = case body of
  OfSphere c r -> ofSphere c r
  OfCube c h -> ofCube c h
  OfTriangle a b c -> ofTriangle a b c
  OfDisk p n r -> ofDisk p n r
  OfTube a b r -> ofTube a b r
  OfCone a b r -> ofCone a b r
  OfTorus p n major minor -> ofTorus p n major minor
  OfCap p n r c -> ofCap p n r c
  OfLens a b r c -> ofLens a b r c

-- | Whether a point is in a box, or on its surface.
holds :: Box -> Point -> Bool
holds b p = and ((<=) <$> boxLow b <*> p) && and ((<=) <$> p <*> boxHigh b)

-------------------------------------------------------------------------------
-- Boxes

-- | The low corner is not above the high one.
isOrdered :: Body -> Bool
isOrdered body = let b = boxOf body in and ((<=) <$> boxLow b <*> boxHigh b)

-- | Union is commutative, associative and idempotent.
unionIsASemilattice :: Boxed -> Boxed -> Boxed -> Property
unionIsASemilattice (Boxed a) (Boxed b) (Boxed c) =
  (a `union` b) === (b `union` a) .&&. ((a `union` b) `union` c) === (a `union` (b `union` c)) .&&. (a `union` a) === a

-- | A point of either box is in the union.
unionHoldsBoth :: Boxed -> Boxed -> Property
unionHoldsBoth (Boxed a) (Boxed b) = forAll (pointOf a) $ \p -> forAll (pointOf b) $ \q -> holds (a `union` b) p && holds (a `union` b) q

-- | What becomes of a point of a box is in the transformed box.
transformedHolds :: Boxed -> Property
transformedHolds (Boxed b) = forAll (pointOf b) $ \p -> forAll aTransform $ \t ->
  let m = placement t in counterexample (show (transformed m b)) $ holds (transformed m b) (transformPosition m p)
  where
    aTransform = fromMaybe identity <$> (transform <$> (V3 <$> factor <*> factor <*> factor) <*> (V3 <$> turn <*> turn <*> turn) <*> aPoint)
    factor = elements [1, 2, -1, 0.001, 30]
    turn = oneof [elements [0, 90, 45], choose (-180, 180)]

-------------------------------------------------------------------------------
-- Shapes

-- | Every point of a shape is in its box.
holdsItsShape :: Body -> Property
holdsItsShape body = forAll (onBody body) $ \p -> counterexample (show (boxOf body)) $ holds (boxOf body) p

-- | Around a point across an axis: cos a e1 + sin a e2.
around :: Unit -> Double -> Vector
around n a = cos a *^ e1 + sin a *^ e2
  where
    V3 x y z = abs <$> vector n
    least
      | x <= y && x <= z = V3 1 0 0
      | y <= z = V3 0 1 0
      | otherwise = V3 0 0 1
    e1 = maybe 0 vector (unit (cross (vector n) least))
    e2 = cross (vector n) e1

-- | A point of the shape.
onBody :: Body -> Gen Point
onBody body = case body of
  OfSphere c r -> (\n -> c + r *^ vector n) <$> aUnit
  OfCube c h -> (\v -> c + h *^ v) <$> (V3 <$> side <*> side <*> side)
  OfTriangle a b c -> do
    s <- part
    t <- part
    pure (mix a (mix b c t) s)
  OfDisk p n r -> (\a s -> p + (s * r) *^ around n a) <$> angle' <*> part
  OfTube a b r -> onAxis a b (const r)
  OfCone a b r -> onAxis a b (\s -> (1 - s) * r)
  OfTorus p n major minor -> do
    a <- angle'
    e <- angle'
    pure (p + (major + minor * cos e) *^ around n a + (minor * sin e) *^ vector n)
  OfCap p n r c -> cap p n r c
  OfLens a b r (c1, c2) -> case unit (b - a) of
    Just s -> oneof [cap a (opposite s) r c1, cap b s r c2, onAxis a b (const r)]
    Nothing -> pure a
  where
    angle' = choose (0, 2 * pi)
    part = oneof [elements [0, 1], choose (0, 1)]
    side = oneof [elements [-1, 1], choose (-1, 1)]
    onAxis a b radius = do
      s <- part
      e <- angle'
      pure (mix a b s + radius s *^ around (fromMaybe alongZ (unit (b - a))) e)
    -- C = P - sgn(c) sqrt (c^2 - R^2) n, and a distance rho from the axis
    cap p n r c = do
      rho <- (* r) <$> part
      a <- angle'
      let s = signum c
      pure (p + rho *^ around n a + (s * (sqrt (c * c - rho * rho) - sqrt (c * c - r * r))) *^ vector n)

-- | Where the farthest points of a shape are known, the box ends within 2^-19 of its size beside them: sphere, cube,
-- triangle, disk, tube, torus.
isTight :: Body -> Property
isTight body = case extremes of
  [] -> property True
  _ -> counterexample (show (b, lowest, highest)) $ and (near <$> boxLow b <*> lowest) && and (near <$> highest <*> boxHigh b)
  where
    b = boxOf body
    size' = maximum (boxHigh b - boxLow b) + 2 ** (-26) * maximum (abs <$> boxLow b)
    near x y = abs (x - y) <= 2 ** (-19) * size'
    lowest = foldr1' (\x y -> min <$> x <*> y) extremes
    highest = foldr1' (\x y -> max <$> x <*> y) extremes
    foldr1' f points = case points of
      p : ps -> foldr f p ps
      [] -> 0
    axes = [s *^ vector a | a <- [alongX, alongY, alongZ], s <- [1, -1]]
    -- the point of the rim that is farthest along an axis
    rim n r a = maybe 0 ((r *^) . vector) (unit (a - dot a (vector n) *^ vector n))
    extremes = case body of
      OfSphere c r -> [c + r *^ a | a <- axes]
      OfCube c h -> [c + h *^ V3 1 1 1, c - h *^ V3 1 1 1]
      OfTriangle p q r -> [p, q, r]
      OfDisk p n r -> [p + rim n r a | a <- axes]
      OfTube p q r -> [e + rim (fromMaybe alongZ (unit (q - p))) r a | e <- [p, q], a <- axes]
      OfTorus p n major minor -> [p + rim n major a + minor *^ a | a <- axes]
      _ -> []

-- | Points at which spheres and tori are hit, as they are computed, are in their boxes, seen from up to 2^14 sizes
-- away.
holdsHits :: Property
holdsHits = forAll aPoint $ \p -> forAll aUnit $ \n -> forAll ((10 **) <$> choose (-2, 2)) $ \r -> forAll (choose (0.05, 2)) $ \ratio ->
  forAll (rayAt p r) $ \sight ->
    let hits = map (position sight)
     in counterexample "sphere" (all (holds (ofSphere p r)) (hits (sphereParameters p (r * r) sight)))
          .&&. counterexample "torus" (all (holds (ofTorus p n r (ratio * r))) (hits (torusParameters p n r (ratio * r) sight)))
  where
    rayAt p r = do
      u <- aUnit
      away <- (2 **) <$> choose (0, 14)
      v <- aUnit
      pure (ray (p - (away * r) *^ vector u + r *^ vector v) (vector u))

-- | Points at which a shape of any sort is hit, as they are computed, are in its box; a plane has none.
--
-- The rounded normal of a needle is noise, and so is the parameter at which a ray along a triangle meets it: such
-- triangles and rays, by more than 2^-10, are left out.
holdsHitsOfShapes :: Property
holdsHitsOfShapes = forAll ((,) <$> elements [minBound ..] <*> elements [Few, Full]) $ \(sort', kind) -> forAll (Aim.shapeOf sort' kind) $ \shape -> forAll (Aim.rayAt kind shape) $ \r ->
  case ofShape shape of
    Nothing -> counterexample "no box" (sort' == Aim.PlaneSort)
    Just b -> counterexample (show b) (sort' /= Aim.PlaneSort && (isSlight shape r || all (holds b . position r) (parameters (Aim.preparedOf shape) r)))
  where
    isSlight shape r = case shape of
      ATriangle t -> slight t r
      ASmoothTriangle t -> slight (smoothTriangleFlat t) r
      _ -> False
    slight t r =
      let Corners p0 p1 p2 = trianglePoints t
          longest = maximum (map modulus [p1 - p0, p2 - p1, p0 - p2])
       in modulus (cross (p1 - p0) (p2 - p0)) < 2 ** (-10) * longest * longest || abs (dot (direction r) (vector (triangleNormal t))) < 2 ** (-10) * modulus (direction r)

-------------------------------------------------------------------------------
-- Rays

-- | A ray is never said to miss a box in which it is, exactly, at a parameter from 0 to the bound.
--
-- The bounds are the exact entry, where it is a double, the next double above it, and some beyond.
neverMissesWhatItHolds :: Aimed -> Property
neverMissesWhatItHolds (Aimed b r) = case exactInterval b r of
  Just (enter, leave) | leave >= 0 -> conjoin [counterexample (show (far, fromRational enter :: Double)) (meetsBox r b far) | far <- boundsFrom (max 0 enter)]
  _ -> property True
  where
    boundsFrom enter = atLeast enter : [far | far <- [fromRational enter * 1.5, 1, 1000], toRational far >= enter] ++ [1 / 0]

-- | The least double that is not below a number.
atLeast :: Rational -> Double
atLeast x = if toRational y >= x then y else nudged 1 y
  where
    y = fromRational x

-- | A ray that is said to meet a box does, up to the bound, if the box is larger by 2^-48 of the distances: what the
-- slack of the test comes to.
--
-- A computed entry or exit is off by less than 2^-49 of itself, and to move a face by 2^-48 of its distance moves the
-- exact one by more than that.
agreesWithTheExactAnswer :: Aimed -> Property
agreesWithTheExactAnswer (Aimed b r) = forAll (elements ([1 / 0, 1000, 1, 0] ++ beside)) $ \far ->
  meetsBox r b far ==> case exactInterval (looser b) r of
    Just (enter, leave) -> counterexample (show (fromRational enter :: Double, fromRational leave :: Double)) (leave >= 0 && (isInfinite far || max 0 enter <= toRational far))
    Nothing -> counterexample "missed" False
  where
    -- just before the entry, where the answer is no, or nearly so
    beside = [x | Just (enter, _) <- [exactInterval b r], enter > 0, x <- [fromRational enter * 0.5, fromRational (enter * (1 - 1 / 2 ^ (47 :: Int))), nudged (-1) (fromRational enter)]]
    looser x =
      let by = 2 ** (-48) * (maximum (abs <$> origin r) + maximum (abs <$> boxLow x) + maximum (abs <$> boxHigh x))
       in fromMaybe x (box (subtract by <$> boxLow x) ((+ by) <$> boxHigh x))

-- | With a bound of 0 a ray meets the boxes that hold its origin, and no others; with one of minus infinity, none.
goesNowhereWithoutLength :: Aimed -> Property
goesNowhereWithoutLength (Aimed b r) = meetsBox r b 0 === holds b (origin r) .&&. meetsBox r b (-1 / 0) === False

-- | A ray runs down along the coordinates in which its direction is negative.
knowsItsFirstFaces :: Aimed -> Property
knowsItsFirstFaces (Aimed b r) =
  [runsDown (approach r) k | (k, d) <- zip [0 ..] (foldr (:) [] (direction r)), d /= 0] === [d < 0 | d <- foldr (:) [] (direction r), d /= 0]
    .&&. map (boxFace b) [0 .. 5] === foldr (:) (foldr (:) [] (boxHigh b)) (boxLow b)

meetsBox :: Ray -> Box -> Double -> Bool
meetsBox r b = meets (approach r) (boxFace b)

-- | Between which parameters a line is in a box; Nothing if it never is.
exactInterval :: Box -> Ray -> Maybe (Rational, Rational)
exactInterval b r = meet (concat [slab l h o d | (l, h, o, d) <- zip4' (list (boxLow b)) (list (boxHigh b)) (list (origin r)) (list (direction r))])
  where
    list = foldr ((:) . toRational) []
    zip4' (x : xs) (y : ys) (z : zs) (w : ws) = (x, y, z, w) : zip4' xs ys zs ws
    zip4' _ _ _ _ = []
    slab l h o d
      | d > 0 = [((l - o) / d, (h - o) / d)]
      | d < 0 = [((h - o) / d, (l - o) / d)]
      | l <= o && o <= h = []
      | otherwise = [(1, 0)]
    meet intervals
      | null intervals || enter > leave = Nothing
      | otherwise = Just (enter, leave)
      where
        enter = maximum (map fst intervals)
        leave = minimum (map snd intervals)

-------------------------------------------------------------------------------
-- Generators

aPoint :: Gen Point
aPoint = do
  s <- oneof [pure 1, (10 **) <$> choose (-3, 3)]
  fmap (* s) <$> (V3 <$> choose (-1, 1) <*> choose (-1, 1) <*> choose (-1, 1))

aUnit :: Gen Unit
aUnit = do
  v <- oneof [aPoint, elements [V3 1 0 0, V3 0 (-1) 0, V3 0 0 1], V3 1 1e-9 <$> choose (-1e-9, 1e-9)]
  maybe aUnit pure (unit v)

-- | Inside, on a face, an edge or a corner.
pointOf :: Box -> Gen Point
pointOf b = sequenceA (between <$> boxLow b <*> boxHigh b)
  where
    between l h = oneof [elements [l, h], (\s -> max l (min h (l + s * (h - l)))) <$> choose (0, 1)]

instance Arbitrary Boxed where
  arbitrary = do
    p <- oneof [aPoint, fmap (fromInteger . round) <$> aPoint]
    q <- oneof [aPoint, fmap (fromInteger . round) <$> aPoint, pure p]
    pure (Boxed (ofPoints p [q]))

instance Arbitrary Aimed where
  arbitrary = do
    Boxed b <- arbitrary
    target <- oneof [pointOf b, pointOf b, aPoint]
    o <- oneof [pointOf b, aPoint, (\u s -> target + s *^ vector u) <$> aUnit <*> ((10 **) <$> choose (-3, 4)), fmap (fromInteger . round) <$> aPoint]
    d <- oneof [pure (target - o), vector <$> aUnit]
    let V3 x y z = d
    d' <- elements [d, V3 0 y z, V3 x 0 z, V3 x (-0.0) 0]
    if d' == 0 then arbitrary else pure (Aimed b (ray o d'))

instance Arbitrary Body where
  arbitrary =
    oneof
      [ OfSphere <$> aPoint <*> length',
        OfCube <$> aPoint <*> length',
        OfTriangle <$> aPoint <*> aPoint <*> aPoint,
        OfDisk <$> aPoint <*> aUnit <*> length',
        OfTube <$> aPoint <*> aPoint <*> length',
        OfCone <$> aPoint <*> aPoint <*> length',
        OfTorus <$> aPoint <*> aUnit <*> length' <*> length',
        (\p n r k s -> OfCap p n r (s * k * r)) <$> aPoint <*> aUnit <*> length' <*> bend <*> elements [1, -1],
        ((\p q r k l -> OfLens p q r (k * r, l * r)) <$> aPoint <*> aPoint <*> length' <*> signedBend <*> signedBend) `suchThat` possible
      ]
    where
      length' = oneof [pure 1, (10 **) <$> choose (-3, 3)]
      bend = oneof [pure 1, choose (1, 2), choose (2, 1000)]
      signedBend = (*) <$> elements [1, -1] <*> bend
      possible body = case body of
        OfLens p q r (c1, c2) -> distance p q + faceDepth r c1 + faceDepth r c2 > 0
        _ -> True

-- | Names for what is special about a ray and a box, with whether it holds. A generator must reach all of them.
corners :: Aimed -> [(String, Bool)]
corners (Aimed b r) =
  [ ("hits", hit),
    ("misses", not hit),
    ("starts inside", holds b (origin r)),
    ("touches in one point only, or runs in a face", maybe False (uncurry (==)) (exactInterval b r)),
    ("a flat box", or ((==) <$> boxLow b <*> boxHigh b)),
    ("a component of the direction is zero", 0 `elem` direction r),
    ("along a face", or ((\l h o d -> d == 0 && (o == l || o == h)) <$> boxLow b <*> boxHigh b <*> origin r <*> direction r)),
    ("the box is behind", maybe False ((< 0) . snd) (exactInterval b r))
  ]
  where
    hit = meetsBox r b (1 / 0)
