-- |
-- Module      : Laws.Shape
-- Description : What is true of every shape that a ray meets
--
-- Each law is a sentence and a function of a ray aimed at a shape. Bounds come from "Laws.Verdict", where they are
-- derived.
module Laws.Shape
  ( -- * All of them
    lawsOfShapes,

    -- * Where a ray meets a shape
    parametersAscend,
    hitsLieOnTheShape,
    agreesWithExact,
    isExactWhereItCanBe,
    isAsPlain,
    nearestIsLeast,
    positionIsNearExact,

    -- * Normals
    normalIsUnit,
    normalIsOrthogonal,
    shadingNormalFacesTheRay,

    -- * Moving, scaling, turning
    reversedRayReverses,
    longerRayDivides,
    scaledTogether,
    movedTogether,
    turnedByHalf,
    turnedByQuarters,

    -- * Flat shapes
    raysAlongMiss,
    raysInSlantedPlanesMiss,
    diskIsPlaneWithin,
    annulusWithoutHoleIsDisk,

    -- * Solids
    meetsInAnInterval,
    clearlyMissedIsMissed,
    entersAgainstTheNormal,
    containsItsInside,
    doesNotContainItsSurface,
  )
where

import Data.Maybe (isNothing)
import Dioptre.Geometry.Cube (cubeCentre, cubeParameters, cubeSize)
import Dioptre.Geometry.Disk
import Dioptre.Geometry.Plane (Plane, plane, planeNormal, planeParameters, planePosition)
import Dioptre.Geometry.Prepared (contains, nearest, normalAt, parameters, shadingNormal)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereClearlyMissed, sphereParameters, sphereRadius)
import Dioptre.Geometry.Triangle
import Dioptre.Math.Vector (Unit, Vector, distance, dot, opposite, unit, valid, vector, (*^))
import Laws.Aim
import Laws.Draw
import Laws.Exact
import Laws.Verdict
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-- | The laws of a ray and a shape that hold of every sort.
lawsOfShapes :: [(String, Aimed -> Property)]
lawsOfShapes =
  [ ("parameters ascend, and are numbers", parametersAscend),
    ("hits lie on the shape", hitsLieOnTheShape),
    ("it is hit where the exact ray meets the exact shape", agreesWithExact),
    ("normals are unit", normalIsUnit),
    ("normals are orthogonal to the surface, and point outwards", normalIsOrthogonal),
    ("the ray the other way meets it at the opposite parameters", reversedRayReverses),
    ("a ray 2^k times as long meets it at 2^-k of the parameters", longerRayDivides),
    ("ray and shape 2^k times as large meet at the same parameters", scaledTogether),
    ("half a turn about an axis changes no parameter", turnedByHalf),
    ("quarters of a turn change no decision", turnedByQuarters)
  ]

parametersOf :: Shape -> Ray -> [Double]
parametersOf = parameters . preparedOf

-------------------------------------------------------------------------------
-- Where a ray meets a shape

-- | Parameters ascend, and are numbers.
parametersAscend :: Aimed -> Property
parametersAscend (Aimed shape r) = counterexample (show ts) $ and (zipWith (<=) ts (drop 1 ts)) && all finite ts
  where
    ts = parametersOf shape r
    finite t = not (isNaN t || isInfinite t)

-- | The point of the line at a computed parameter satisfies the shape's equation, up to the rounding of the
-- equation's terms; a point of a cube lies on one of its faces, and between the others.
hitsLieOnTheShape :: Aimed -> Property
hitsLieOnTheShape (Aimed shape r) = conjoin [counterexample (show t) (property (on (toRational t))) | t <- parametersOf shape r]
  where
    o = exact (origin r)
    d = exact (direction r)
    on t = case shape of
      APlane p -> onPlane (flatFrame p) (exact (planePosition p)) t
      ADisk x -> onPlane (flatFrame (diskPlane x)) (exact (planePosition (diskPlane x))) t && away x <= toRational (diskRadius x) ^ (2 :: Int)
        where
          away y = squaredDistance (planePosition (diskPlane y)) t * (1 - gamma 9)
      AnAnnulus x ->
        onPlane (flatFrame (annulusPlane x)) (exact (planePosition (annulusPlane x))) t
          && q * (1 - gamma 9) <= toRational (annulusOuter x) ^ (2 :: Int)
          && q * (1 + gamma 9) >= toRational (annulusInner x) ^ (2 :: Int)
        where
          q = squaredDistance (planePosition (annulusPlane x)) t
      ASphere x -> abs (squared (along o d t - exact (sphereCentre x)) - radius * radius) <= sphereResidual (exact (sphereCentre x)) radius r t
        where
          radius = toRational (sphereRadius x)
      ACube x -> onSome && all between sides
        where
          sides = facesOf (exact (cubeCentre x)) (toRational (cubeSize x) / 2) o (along o d t)
          onSome = or [abs (q - f) <= e | (q, faces, _) <- sides, (f, e) <- faces]
          between (q, [(low, e), (high, e')], _) = low - e <= q && q <= high + e'
          between _ = False
      ATriangle x -> onPlane (triangleFrame x) (firstCorner x) t
      ASmoothTriangle x -> onPlane (triangleFrame (smoothTriangleFlat x)) (firstCorner (smoothTriangleFlat x)) t
      _ -> False
    onPlane frame@(n, _, _) p t = abs (inner n (along o d t - p)) <= planeResidual frame p r t
    firstCorner x = let Corners p _ _ = trianglePoints x in exact p
    -- Of the computed point; distances are computed with four roundings, their squares with eight, and the second
    -- order.
    squaredDistance c t = squared (exact (position r (fromRational t)) - exact c)

-- | For each axis: the coordinate, the two faces with the errors of their parameters, and the origin's coordinate.
facesOf :: Exact -> Rational -> Exact -> Exact -> [(Rational, [(Rational, Rational)], Rational)]
facesOf c h o q =
  [(x, [(f, faceError f from + eps * abs f) | f <- [m - h, m + h]], from) | (x, m, from) <- zip3 (components q) (components c) (components o)]

-- | The ray meets the shape where the exact ray meets the exact shape, as often, and within the bound of each
-- parameter; where rounding may decide, nothing is said.
agreesWithExact :: Aimed -> Property
agreesWithExact (Aimed shape r) = counterexample (show (ts, v)) $ case v of
  Unsure -> True
  Sure hits -> length hits == length ts && and [abs (toRational t - x) <= e | (t, Hit x e) <- zip ts hits]
  where
    ts = parametersOf shape r
    v = verdict shape r

-- | Where nothing is rounded on the way, nothing is left to rounding: rims, edges and corners belong to the shape,
-- and a ray along a flat shape misses it.
--
-- Parameters are the doubles nearest to the exact ones for planes, disks, annuli and cubes. A line that misses a cube
-- by less than the rounding of its parameters may touch it. A triangle's unit normal is rounded, so its parameters
-- are too. Of spheres the number of points is exact, and a tangent touches at the double nearest to the exact
-- parameter, twice.
isExactWhereItCanBe :: Crisp -> Property
isExactWhereItCanBe (Crisp shape r) = counterexample (show ts) $ case shape of
  APlane p -> ts === flat p (const True)
  ADisk x -> ts === flat (diskPlane x) (<= sq (diskRadius x))
  AnAnnulus x -> ts === flat (annulusPlane x) (\q -> sq (annulusInner x) <= q && q <= sq (annulusOuter x))
  ASphere x -> case signum (quarter (sphereCentre x) (sphereRadius x)) of
    1 -> property (length ts == 2 && ordered ts)
    0 -> let t = fromRational (negate (inner (o - exact (sphereCentre x)) d) / squared d) in ts === [t, t]
    _ -> ts === []
  ACube x -> case exactSlabs (exact (cubeCentre x)) (toRational (cubeSize x) / 2) r of
    Just (enter, leave) -> ts === [fromRational enter, fromRational leave]
    Nothing -> property (null ts || and (zipWith (==) ts (drop 1 ts)))
  ATriangle x -> null ts === not (passed x)
  ASmoothTriangle x -> null ts === not (passed (smoothTriangleFlat x))
  _ -> property False
  where
    ts = parametersOf shape r
    o = exact (origin r)
    d = exact (direction r)
    sq x = toRational x * toRational x
    ordered xs = and (zipWith (<) xs (drop 1 xs))
    flat p kept = [fromRational t | a /= 0, let t = negate (inner n (o - c)) / a, kept (squared (along o d t - c))]
      where
        n = exact (planeNormal p)
        c = exact (planePosition p)
        a = inner n d
    quarter c radius = sq radius * squared d - squared (outer (o - exact c) d)
    passed x = maybe False (\(_, coordinates, _) -> all (>= 0) coordinates) (exactTriangle x r)

-- | A prepared shape is hit at the parameters of its rule, bit for bit.
isAsPlain :: Aimed -> Property
isAsPlain (Aimed shape r) = Just (parametersOf shape r) === plainly
  where
    plainly = case shape of
      APlane p -> onPlane p planeParameters
      ADisk x -> onPlane (diskPlane x) (\p n -> diskParameters p n (diskRadius x))
      AnAnnulus x -> onPlane (annulusPlane x) (\p n -> annulusParameters p n (annulusInner x) (annulusOuter x))
      ASphere x -> Just (sphereParameters (sphereCentre x) (sphereRadius x * sphereRadius x) r)
      ACube x -> Just (cubeParameters (cubeCentre x) (cubeSize x / 2) r)
      ATriangle x -> Just (onCorners x)
      ASmoothTriangle x -> Just (onCorners (smoothTriangleFlat x))
      _ -> Nothing
    onPlane p rule = (\n -> rule (planePosition p) n r) <$> unit (planeNormal p)
    onCorners x = let Corners a b c = trianglePoints x in triangleParameters a b c (triangleNormal x) r

-- | The nearest hit is the first parameter above 1e-8 and below the bound, whatever the bound: the bound itself if
-- there is none, even if a parameter equals it.
nearestIsLeast :: Aimed -> Property
nearestIsLeast (Aimed shape r) = conjoin [counterexample (show b) (nearest (preparedOf shape) r b === first b) | b <- bounds]
  where
    ts = parametersOf shape r
    bounds = [1 / 0, 1e-8, 1, 100] ++ [b | t <- ts, t > 0, b <- [t, nudged 1 t, nudged (-1) t]]
    first b = case [t | t <- ts, t > 1e-8, t < b] of
      t : _ -> t
      [] -> b

-- | The position at a parameter is o + t d, with a rounding of the product and one of the sum in each component.
positionIsNearExact :: Aimed -> Property
positionIsNearExact (Aimed _ r) = forAll (anyKind >>= number) $ \t ->
  let p = along (exact (origin r)) (exact (direction r)) (toRational t)
      q = exact (position r t)
      bounds = [eps * abs (toRational t * x) + eps * abs y | (x, y) <- zip (components (exact (direction r))) (components q)]
   in counterexample (show (position r t)) $ and [abs x <= e | (x, e) <- zip (components (p - q)) bounds]

-------------------------------------------------------------------------------
-- Normals

-- | The normal of a hit is unit.
normalIsUnit :: Aimed -> Property
normalIsUnit (Aimed shape r) = conjoin [counterexample (show n) (valid n) | (_, n) <- normalsOf shape r]

normalsOf :: Shape -> Ray -> [(Double, Unit)]
normalsOf shape r = [(t, normalAt (preparedOf shape) r t) | t <- parametersOf shape r]

-- | The normal of a hit is orthogonal to the surface there and points outwards: its outer product with the gradient
-- of the shape's equation vanishes, up to the rounding of the gradient. (A smooth triangle's normal is another
-- matter: "Laws.Triangle".)
--
-- With N the gradient, the computed normal is c (N + e), where |c| is 1 \/ |N| up to 4 eps and |e_i| at most gamma k
-- s_i, so that its product with N is at most (1 + gamma 5) gamma k (s_j |N_k| + s_k |N_j|) \/ |N|. Planes have k = 1
-- (the division), triangles k = 5, and spheres k = 2, N being the point less the centre.
normalIsOrthogonal :: Aimed -> Property
normalIsOrthogonal (Aimed shape r) = conjoin [counterexample (show (t, n)) (property (orthogonal t (exact (vector n)))) | (t, n) <- normalsOf shape r]
  where
    orthogonal t n = case shape of
      APlane p -> ofPlane p
      ADisk x -> ofPlane (diskPlane x)
      AnAnnulus x -> ofPlane (annulusPlane x)
      ASphere x -> let w = exact (position r t) - exact (sphereCentre x) in parallel 2 (magnitudes w) w
      ACube x -> let sides = facesOf (exact (cubeCentre x)) (toRational (cubeSize x) / 2) o (along o d (toRational t)) in squared n == 1 && or (zipWith facing (components n) sides)
      ATriangle x -> let (m, s, _) = triangleFrame x in parallel 5 s m
      ASmoothTriangle _ -> True
      _ -> False
      where
        ofPlane p = let m = exact (planeNormal p) in parallel 1 (magnitudes m) m
        parallel k s m =
          and [abs e * rootBelow (squared m) <= (1 + gamma 5) * gamma k * b | (e, b) <- zip (components (outer n m)) (components (outerMagnitudes s m))]
            && inner n m > 0
        facing side (q, [(low, e), (high, e')], _)
          | side == 1 = abs (q - high) <= e'
          | side == -1 = abs (q - low) <= e
        facing _ _ = False
    o = exact (origin r)
    d = exact (direction r)

-- | The shading normal is the normal or its opposite, and does not point along the ray.
shadingNormalFacesTheRay :: Aimed -> Property
shadingNormalFacesTheRay (Aimed shape r) =
  conjoin [(m === n .||. m === opposite n) .&&. counterexample (show m) (dot (direction r) (vector m) <= 0) | (_, n) <- normalsOf shape r, let m = shadingNormal r n]

-------------------------------------------------------------------------------
-- Moving, scaling, turning

-- | The ray the other way meets the shape at the opposite parameters, to the bit.
reversedRayReverses :: Aimed -> Property
reversedRayReverses (Aimed shape r) = parametersOf shape (ray (origin r) (negate (direction r))) === reverse (map negate (parametersOf shape r))

-- | A ray whose direction is 2^k times as long meets the shape at 2^-k of the parameters, to the bit.
longerRayDivides :: Aimed -> Property
longerRayDivides (Aimed shape r) = forAll (chooseInt (-60, 60)) $ \k ->
  parametersOf shape (ray (origin r) (scaleFloat k <$> direction r)) === map (scaleFloat (negate k)) (parametersOf shape r)

-- | A ray and a shape that are both 2^k times as large meet at the same parameters, to the bit.
scaledTogether :: Aimed -> Property
scaledTogether (Aimed shape r) = forAll (chooseInt (-12, 60)) $ \k ->
  let grow = fmap (scaleFloat k)
   in carries grow id (scaleFloat k) shape $ \larger -> parametersOf larger (ray (grow (origin r)) (grow (direction r))) === parametersOf shape r

-- | A ray and a shape that are moved together, without rounding, meet at the same parameters, to the bit. Where a
-- disk's or an annulus' rim hangs on rounding, it may be the rounding of another place.
movedTogether :: Crisp -> Property
movedTogether (Crisp shape crispRay) = forAll ((,) <$> shift <*> oneof [pure (direction crispRay), step Few]) $ \(v, d) ->
  carries (+ v) id id shape $ \there ->
    if hangs && not (isSure (verdict shape (at d)) && isSure (verdict there (moved v d)))
      then property True
      else parametersOf there (moved v d) === parametersOf shape (at d)
  where
    shift = V3 <$> far <*> far <*> far
    far = oneof [number Few, fromIntegral <$> chooseInt (-1000000, 1000000)]
    at = ray (origin crispRay)
    moved v = ray (origin crispRay + v)
    hangs = sortOf shape `elem` [Just DiskSort, Just AnnulusSort]

-- | Turning ray and shape by half a turn about an axis changes no parameter, not by a bit: only signs change.
turnedByHalf :: Aimed -> Property
turnedByHalf (Aimed shape r) =
  conjoin [carries turn turn id shape $ \there -> parametersOf there (ray (turn (origin r)) (turn (direction r))) === parametersOf shape r | turn <- halfTurns]
  where
    halfTurns = [\(V3 x y z) -> V3 x (-y) (-z), \(V3 x y z) -> V3 (-x) y (-z), \(V3 x y z) -> V3 (-x) (-y) z]

-- | Turning ray and shape by quarters of a turn changes no parameter of a cube, not by a bit, and of nothing that is
-- made of small integers but by the rounding of a unit normal; and it changes no triangle's decision, as long as the
-- ray's largest component is larger than the others (of equal ones the rule takes the last).
turnedByQuarters :: Aimed -> Property
turnedByQuarters (Aimed shape r) =
  conjoin [carries turn turn id shape $ \there -> same there (parametersOf there (ray (turn (origin r)) (turn (direction r)))) | turn <- turns]
  where
    ts = parametersOf shape r
    same there us = case shape of
      ACube _ -> us === ts
      ASphere x | all small (components (sphereCentre x) ++ components (origin r) ++ components (direction r) ++ [sphereRadius x]) -> us === ts
      ATriangle x | steep x && alone -> length us === length ts
      ASmoothTriangle x | steep (smoothTriangleFlat x) && alone -> length us === length ts
      _ -> counterexample (show (there, us)) (not (isSure (verdict shape r)) || length us == length ts)
    small x = abs x <= 4096 && x * 2 == fromInteger (round (x * 2))
    steep x = crosses (triangleFrame x) r == Just True
    alone = let parts = abs <$> components (direction r) in length (filter (== maximum parts) parts) == 1
    turns = [\(V3 x y z) -> V3 x (-z) y, \(V3 x y z) -> V3 z y (-x), \(V3 x y z) -> V3 (-y) x z, \(V3 x y z) -> V3 y z x, \(V3 x y z) -> V3 z x y]

-- | A law of the shape that it becomes elsewhere. Shapes that cannot be carried there are left out (a triangle that
-- is nearly a line may become one).
carries :: (Vector -> Vector) -> (Vector -> Vector) -> (Double -> Double) -> Shape -> (Shape -> Property) -> Property
carries onPoint onVector onLength shape law = maybe discard law (carried onPoint onVector onLength shape)

-------------------------------------------------------------------------------
-- Flat shapes

-- | A ray that runs along a plane, in it or beside it, does not meet the plane nor any shape in it: for planes
-- orthogonal to an axis, or to a diagonal of two axes. (Both components of such a normal are equal, so that \<n, d>
-- is zero when it is computed, too.)
raysAlongMiss :: Property
raysAlongMiss = forAll setting $ \(p, d, k) ->
  conjoin [counterexample (show shape) (parametersOf shape (ray (planePosition p + k) d) === []) | shape <- shapesIn p 3]
  where
    setting = do
      n <- elements [V3 0 0 1, V3 0 (-2) 0, V3 4 0 0, V3 1 1 0, V3 0 (-3) 3, V3 5 0 5]
      d <- (crossed n <$> point Few) `suchThat` (/= 0)
      at <- anyVector
      p <- maybe discard pure (plane at n)
      k <- oneof [pure 0, (*^ d) <$> number Few, point Few]
      pure (p, d, k)
    crossed (V3 a b c) (V3 x y z) = V3 (b * z - c * y) (c * x - a * z) (a * y - b * x)

shapesIn :: Plane -> Double -> [Shape]
shapesIn p radius = APlane p : maybe [] (pure . ADisk) (disk p radius) ++ maybe [] (pure . AnAnnulus) (annulus p 0 radius)

-- | A ray that lies exactly in the plane of a shape, whatever the plane's inclination, does not meet the shape: for
-- planes and triangles of integers, along which an integer ray can run exactly.
raysInSlantedPlanesMiss :: Sort -> Property
raysInSlantedPlanesMiss sort = forAll (crispTriangle >>= setting) $ \(t, r) ->
  isNothing (exactTriangle t r) ==> conjoin [counterexample (show shape) (parametersOf shape r === []) | shape <- shapes t]
  where
    crispTriangle = do
      shape <- crispShape TriangleSort
      case shape of
        ATriangle t -> pure t
        _ -> discard
    setting t = do
      let Corners a b c = trianglePoints t
      (i, j, k, l) <- (,,,) <$> whole <*> whole <*> whole <*> whole
      let d = k *^ (b - a) + l *^ (c - a)
      if d == 0 then discard else pure (t, ray (a + i *^ (b - a) + j *^ (c - a)) d)
    whole = fromIntegral <$> chooseInt (-3, 3) :: Gen Double
    shapes t = case sort of
      TriangleSort -> [ATriangle t]
      _ ->
        let Corners a b c = trianglePoints t
            V3 x1 y1 z1 = b - a
            V3 x2 y2 z2 = c - a
            -- exact: the corners are halves of small integers
            n = V3 (y1 * z2 - z1 * y2) (z1 * x2 - x1 * z2) (x1 * y2 - y1 * x2)
         in maybe [] (`shapesIn` 50) (plane a n)

-- | A disk is hit exactly where its plane is hit, not farther from the centre than the radius; an annulus likewise,
-- not nearer than the inner one.
diskIsPlaneWithin :: Aimed -> Property
diskIsPlaneWithin (Aimed shape r) = case shape of
  ADisk x -> parametersOf shape r === kept (diskPlane x) 0 (diskRadius x)
  AnAnnulus x -> parametersOf shape r === kept (annulusPlane x) (annulusInner x) (annulusOuter x)
  _ -> property True
  where
    kept p low high = [t | t <- parametersOf (APlane p) r, let away = distance (planePosition p) (position r t), low <= away, away <= high]

-- | An annulus whose inner radius is 0 is a disk.
annulusWithoutHoleIsDisk :: Aimed -> Property
annulusWithoutHoleIsDisk (Aimed shape r) = case shape of
  ADisk x -> (flip parametersOf r . AnAnnulus <$> annulus (diskPlane x) 0 (diskRadius x)) === Just (parametersOf shape r)
  _ -> property True

-------------------------------------------------------------------------------
-- Solids

-- | A sphere that is clearly missed is met at no parameter.
clearlyMissedIsMissed :: Aimed -> Property
clearlyMissedIsMissed (Aimed (ASphere s) r) = cover 5 clearly "clearly" $ not clearly || null (sphereParameters c radiusSquared r)
  where
    c = sphereCentre s
    radiusSquared = sphereRadius s * sphereRadius s
    clearly = sphereClearlyMissed c radiusSquared r
clearlyMissedIsMissed _ = property False

-- | A line meets a sphere or a cube at two parameters or not at all; the points between the two are inside, and the
-- points outside them are not, up to the bounds by which the two parameters themselves may be off.
--
-- The excess |r(t) - C|^2 - R^2 is convex in t, so between the two it is at most the greater of theirs. Outside, the
-- rounded polynomial is positive up to the residual of its root. For a cube each coordinate is monotonous in t.
meetsInAnInterval :: Aimed -> Property
meetsInAnInterval (Aimed shape r) = counterexample (show ts) $ case ts of
  [] -> property True
  [enter, leave] -> forAll ((,) <$> fraction <*> (abs <$> oneof [number Full, chooseInt (-40, 20) >>= ofSize])) $ \(f, s) ->
    let a = toRational enter
        b = toRational leave
        within' = a + toRational f * (b - a)
     in conjoin
          [ counterexample "between" (notOutside a b within'),
            counterexample "before" (notInside a b (a - toRational s)),
            counterexample "after" (notInside a b (b + toRational s))
          ]
  _ -> property False
  where
    ts = parametersOf shape r
    o = exact (origin r)
    d = exact (direction r)
    notOutside a b t = case shape of
      ASphere x -> excess x t <= max (residual x a) (residual x b)
      ACube x -> and [low - e <= q && q <= high + e' | (q, [(low, e), (high, e')], _) <- sides x t]
      _ -> False
    notInside a b t = case shape of
      ASphere x -> excess x t >= negate (max (residual x a) (residual x b) + residual x t)
      ACube x -> or [q <= low + e || high - e' <= q | (q, [(low, e), (high, e')], _) <- sides x t]
      _ -> False
    sides x t = facesOf (exact (cubeCentre x)) (toRational (cubeSize x) / 2) o (along o d t)
    excess x t = squared (along o d t - exact (sphereCentre x)) - toRational (sphereRadius x) ^ (2 :: Int)
    residual x = sphereResidual (exact (sphereCentre x)) (toRational (sphereRadius x)) r

-- | A ray enters a cube against the normal, and leaves it along the normal, unless it only touches an edge.
entersAgainstTheNormal :: Aimed -> Property
entersAgainstTheNormal (Aimed shape r) = case (shape, normalsOf shape r) of
  (ACube _, [(enter, n), (leave, m)]) | enter < leave -> counterexample (show (n, m)) (dot (direction r) (vector n) < 0 && dot (direction r) (vector m) > 0)
  _ -> property True

-- | A point is inside a solid if it is nearer to the centre than a part in 10^10 less than the solid's size, and in
-- no other case; where the computed distance hangs on rounding nothing is said. (For a sphere the distance has four
-- roundings and the limit four; for a cube each difference has one and the limit two.)
containsItsInside :: Aimed -> Property
containsItsInside (Aimed shape r) = forAll place $ \p -> counterexample (show p) $ case shape of
  ASphere x -> decided (squared (exact p - exact (sphereCentre x))) (toRational (sphereRadius x) ^ (2 :: Int)) 18 (^ (2 :: Int)) (contains (preparedOf shape) p)
  ACube x -> decided (maximum (magnitudes (exact p - exact (cubeCentre x)))) (toRational (cubeSize x) / 2) 4 id (contains (preparedOf shape) p)
  _ -> contains (preparedOf shape) p === False
  where
    decided size limit roundings power answer
      | size < inner' * (1 - gamma roundings) = answer === True
      | size > inner' * (1 + gamma roundings) = answer === False
      | otherwise = property True
      where
        inner' = limit * power (1 - toRational (1e-10 :: Double))
    place = oneof [pure (origin r), position r <$> number Full, near]
    near = case (shape, parametersOf shape r) of
      (ASphere x, t : _) -> (\k -> sphereCentre x + k *^ (position r t - sphereCentre x)) <$> shrinkage
      (ACube x, t : _) -> (\k -> cubeCentre x + k *^ (position r t - cubeCentre x)) <$> shrinkage
      _ -> pure (origin r)
    shrinkage = oneof [fraction, elements [1 - 2e-10, 1 - 1.01e-10, 1 - 0.99e-10, 1 - 1e-11, 1, 1 + 1e-10]]

-- | A point of the surface is not inside: of solids and rays of small integers, whose points are known to some 10^-13.
doesNotContainItsSurface :: Crisp -> Property
doesNotContainItsSurface (Crisp shape r) = conjoin [counterexample (show t) (contains (preparedOf shape) (position r t) === False) | t <- parametersOf shape r]
