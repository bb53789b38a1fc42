-- |
-- Module      : Laws.Round
-- Description : What is true of the shapes around an axis, and rays that put it to the test
--
-- The second opinion on each shape is its definition, as inequalities between rational numbers: a point of a ray is
-- inside, outside, or so near the surface that rounding may decide. Where the definition is sure, the computed
-- parameters must say the same. What "near" means is derived at 'bodyAt'; nothing else in this module is approximate.
module Laws.Round
  ( -- * Shapes and rays
    Body (..),
    Axle (..),
    Aimed (..),
    Capped (..),
    AimedCap (..),
    bodyParameters,

    -- * Laws of bodies
    isAscendingInPairs,
    isConvex,
    agreesWithDefinition,
    liesOnSurface,
    hitsWhatItIsAimedAt,
    hasUnitNormals,
    hasOutwardNormals,
    hasNormalsOfItsParts,
    containsOnlyItsInside,
    doesNotContainItsSurface,

    -- * Laws of motions
    movesAlong,
    turnsAlong,
    scalesAlong,
    stretchesWithDirection,
    reverses,

    -- * Laws of single shapes
    tubeIsPartOfLine,
    tubeCrossesWhereItChanges,
    cylinderHasTubesParameters,
    conesContainCone,
    conesAreExact,
    capLiesOnSphere,
    capCrossesWhereItChanges,
    capNormalPointsOut,
    capsAreOnLens,
  )
where

import Data.List (sort)
import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Cap (capNormal, capParameters, centreDepth)
import Dioptre.Geometry.Cone (coneContains, coneNormal, coneParameters, conesParameters)
import Dioptre.Geometry.Cylinder (cylinderContains, cylinderNormal, cylinderParameters)
import Dioptre.Geometry.Lens (lensContains, lensNormal, lensParameters)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Geometry.Tube (tubeLineParameters, tubeNormal, tubeParameters)
import Dioptre.Geometry.Uv (frame)
import Dioptre.Math.Vector (Point, Unit, Vector, alongZ, cross, dot, modulus, opposite, unit, valid, vector, (*^))
import Laws.Draw
import Laws.Exact
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (scale, vector)

-------------------------------------------------------------------------------
-- Shapes

-- | A start, the step to the end, and a radius.
data Axle = Axle Point Vector Double
  deriving (Eq, Show)

-- | A closed shape around an axis. A bar is the infinite cylinder, in which the parameters of the infinite tube are an
-- entry and an exit.
data Body
  = Bar Axle
  | Cylinder Axle
  | Cone Axle
  | Lens Axle Double Double
  deriving (Eq, Show)

axleOf :: Body -> Axle
axleOf body = case body of
  Bar a -> a
  Cylinder a -> a
  Cone a -> a
  Lens a _ _ -> a

-- | The unit axis and the length.
axis :: Axle -> (Unit, Double)
axis (Axle _ g _) = (fromMaybe alongZ (unit g), modulus g)

-- | Every entry and exit.
bodyParameters :: Body -> Ray -> [Double]
bodyParameters body = case body of
  Bar _ -> tubeLineParameters p1 s radius
  Cylinder _ -> cylinderParameters p1 s h radius
  Cone _ -> coneParameters p1 s h radius
  Lens _ c1 c2 -> lensParameters p1 s h radius c1 c2
  where
    a@(Axle p1 _ radius) = axleOf body
    (s, h) = axis a

bodyNormal :: Body -> Ray -> Double -> Unit
bodyNormal body r t = case body of
  Bar _ -> tubeNormal p1 s (position r t)
  Cylinder _ -> cylinderNormal p1 s h radius r t
  Cone _ -> coneNormal p1 s h radius r t
  Lens _ c1 c2 -> lensNormal p1 s h radius c1 c2 r t
  where
    a@(Axle p1 _ radius) = axleOf body
    (s, h) = axis a

bodyContains :: Body -> Point -> Bool
bodyContains body = case body of
  Bar _ -> const False
  Cylinder _ -> cylinderContains p1 s h radius
  Cone _ -> coneContains p1 s h radius
  Lens _ c1 c2 -> lensContains p1 s h radius c1 c2
  where
    a@(Axle p1 _ radius) = axleOf body
    (s, h) = axis a

intervalsOf :: [Double] -> [(Double, Double)]
intervalsOf (enter : leave : rest) = (enter, leave) : intervalsOf rest
intervalsOf _ = []

-------------------------------------------------------------------------------
-- The definition

-- | What the definition says of a point.
data Place = Inside | Near | Outside
  deriving (Eq, Show)

-- | Inside both.
both :: Place -> Place -> Place
both Outside _ = Outside
both _ Outside = Outside
both Inside Inside = Inside
both _ _ = Near

-- | Inside one of the two.
either' :: Place -> Place -> Place
either' a b = inverse (both (inverse a) (inverse b))

inverse :: Place -> Place
inverse Inside = Outside
inverse Near = Near
inverse Outside = Inside

-- | Where a number must be at most zero, and is known to a bound.
atMostZero :: Rational -> Rational -> Place
atMostZero bound x
  | x < negate bound = Inside
  | x > bound = Outside
  | otherwise = Near

-- | One condition of a definition: whether it is met, and the gradient of what must be at most zero.
data Part = Part {met :: Place, gradient :: Exact}

-- | The exact numbers of a point w on a line: its parts across and along an axis, and how far a computed point may be
-- from it.
--
-- A position o + t d, its vector from a point of the shape and what that is across the axis take fewer than 64
-- roundings, each of a number no larger than 'reach' = |w| + |t d| + H + R, with |.| the sum of the components'
-- magnitudes, which is at least the length. So 'slack' = 64 eps reach.
--
-- A quadratic polynomial is computed with an error of less than 64 eps times the sum of its terms' magnitudes, and its
-- roots are off by at most as much again in terms of the polynomial ("Laws.Roots", hasSmallResidual): 128 eps. For the
-- bar and the cylinder, which take the ray as it comes, the terms add up to less than reach^2. Cone and lens take it
-- from its point next to the apex, or to the middle of the axis: there d is orthogonal to w, so that the terms add up
-- to less than twice the square of the distance of the point from there, and a point that is off by the slack adds the
-- gradient's length times the slack, and the slack squared times the curvature.
bodyParts :: Rational -> Body -> Ray -> Rational -> [[Part]]
bodyParts shrunk body r t = case body of
  Bar _ -> [[round' (128 * eps * reach * reach)]]
  Cylinder _ -> [[round' (128 * eps * reach * reach)], [start], [end]]
  Cone _ -> [[sloped], [start], [apexEnd]]
  Lens _ c1 c2 ->
    [ [round' (128 * eps * (size + h) * (size + h) + 2 * slack * size + slack * slack)],
      face c1 (fmap negate s) w,
      face c2 s (minus w g)
    ]
  where
    Axle p1 axisStep' radiusDouble = axleOf body
    radius = toRational radiusDouble
    g = exact axisStep'
    h = rootAbove (squared g)
    s = fmap (/ h) g
    from = minus (exact (origin r)) (exact p1)
    d = exact (direction r)
    w = along from d t
    a = inner w s
    wPerp = minus w (fmap (a *) s)
    reach = magnitude from + abs t * magnitude d + h + radius
    slack = 64 * eps * reach
    size = magnitude w + h + radius
    round' bound = Part (atMostZero bound (squared wPerp - ((1 - shrunk) * radius) ^ (2 :: Int))) wPerp
    start = Part (atMostZero slack (shrunk * h - a)) (fmap negate s)
    end = Part (atMostZero slack (a - (1 - shrunk) * h)) s
    -- The cone, measured from its apex.
    k = (1 - shrunk) * radius / h
    above = a - (1 - shrunk) * h
    apexEnd = Part (atMostZero slack above) s
    fromApex = minus w g
    away = magnitude fromApex
    sloped =
      Part
        ( atMostZero
            ((1 + k * k) * (128 * eps * away * away + 2 * slack * away + slack * slack))
            (squared wPerp - k * k * above * above)
        )
        (minus (fmap (/ rootAbove (squared wPerp + tiny)) wPerp) (fmap (negate k *) s))
    -- A face bulges along q. A hollow one is what its dome leaves.
    face c outward p
      | c > 0 = [dome p' outward, Part (height p' outward) outward]
      | otherwise = [Part (inverse (met (dome p' inward))) (fmap negate (gradient (dome p' inward))), Part (inverse (height p' inward)) outward]
      where
        inward = fmap negate outward
        p' = along p outward (shrunk * abs (toRational c))
        m = abs (toRational (centreDepth radiusDouble c))
        height point' q = atMostZero (slack + 8 * eps * m) (inner point' q + m)
        dome point' q =
          Part
            ( atMostZero
                (let close = magnitude point' + radius in 128 * eps * (close * close + 2 * m * close) + 2 * slack * (close + m) + slack * slack)
                (squared point' + 2 * m * inner point' q - radius * radius)
            )
            (along point' q m)
    tiny = 1 / 2 ^ (400 :: Int)

-- | Where a point of a line is; of a body smaller by some part, if that is not zero.
bodyAt :: Rational -> Body -> Ray -> Rational -> Place
bodyAt shrunk body r t = case (body, bodyParts shrunk body r t) of
  (Lens _ c1 c2, [bar, face1, face2]) -> foldr1 both (map met bar ++ [joined c1 face1, joined c2 face2])
  (_, parts) -> foldr1 both (map met (concat parts))
  where
    -- In the dome: under the sphere's middle, or in the sphere. Out of it: neither.
    joined c = foldr1 (if c > 0 then either' else both) . map met

minus :: Exact -> Exact -> Exact
minus a b = (-) <$> a <*> b

-------------------------------------------------------------------------------
-- Laws of bodies

-- | Parameters are finite, ascend, and come in pairs of an entry and an exit.
isAscendingInPairs :: Aimed -> Property
isAscendingInPairs (Aimed body r _) = ts === sort ts .&&. even (length ts) .&&. all (\t -> abs t < 1 / 0) ts
  where
    ts = bodyParameters body r

-- | A line meets a convex body in one interval or not at all.
isConvex :: Aimed -> Property
isConvex (Aimed body r _) = counterexample (show ts) (null ts || length ts == 2 || hollow)
  where
    ts = bodyParameters body r
    hollow = case body of
      Lens _ c1 c2 -> c1 < 0 || c2 < 0
      _ -> False

-- | Points between an entry and its exit are inside by the definition, and all others outside, unless they are near the
-- surface.
agreesWithDefinition :: Aimed -> Property
agreesWithDefinition (Aimed body r samples) = conjoin (map agrees (samples ++ concatMap around ts))
  where
    ts = bodyParameters body r
    pairs = intervalsOf ts
    scale = extent body / modulus (direction r)
    around t = [t + side * scale * 2 ** negate k | side <- [-1, 1], k <- [4, 12, 20, 30, 40]] ++ [nudged 16 t, nudged (-16) t]
    agrees t = case bodyAt 0 body r (toRational t) of
      Near -> property True
      place -> counterexample (show (t, place, pairs)) ((place == Inside) == any (\(enter, leave) -> enter <= t && t <= leave) pairs || parallel)
    -- The line of the infinite tube is special: along the axis it has no parameters, wherever it is.
    parallel = case body of
      Bar _ -> null ts && squared (outer (exact (direction r)) (exact g)) <= 2 ^^ (-90 :: Int) * squared (exact (direction r)) * squared (exact g)
      _ -> False
    Axle _ g _ = axleOf body

-- | Where a line enters or leaves, the point is near the surface by the definition.
liesOnSurface :: Aimed -> Property
liesOnSurface (Aimed body r _) = conjoin [counterexample (show t) (bodyAt 0 body r (toRational t) === Near) | t <- bodyParameters body r]

-- | A point that is inside is between an entry and an exit of any ray through it: nothing slips in through a rim, or
-- past an apex.
hitsWhatItIsAimedAt :: Aimed -> Property
hitsWhatItIsAimedAt (Aimed body r samples) =
  conjoin
    [ counterexample (show t) (not (null (bodyParameters body r)))
      | not (isBar body),
        t <- samples,
        bodyAt 0 body r (toRational t) == Inside
    ]

-- | Normals are unit vectors.
hasUnitNormals :: Aimed -> Bool
hasUnitNormals (Aimed body r _) = all (valid . bodyNormal body r) (bodyParameters body r)

-- | Where a line enters, the normal is against it, and where it leaves, along it, to rounding.
--
-- The derivative of a quadratic polynomial has the right sign at its computed root but for the error of its
-- coefficients: fewer than 256 roundings of numbers of the size of the reach, divided by the distance from the axis, or
-- from the sphere's centre, to which the normal is made unit. (At an interval of one point the line does both.)
hasOutwardNormals :: Aimed -> Property
hasOutwardNormals (Aimed body r _) = conjoin (concatMap check (intervalsOf (bodyParameters body r)))
  where
    check (enter, leave)
      | enter < leave = [counterexample (show enter) (slope enter <= bound enter), counterexample (show leave) (slope leave >= negate (bound leave))]
      | otherwise = []
    slope t = dot (direction r) (vector (bodyNormal body r t)) / modulus (direction r)
    bound t = 256 * 2 ** (-53) * (1 + steep) * reachAt body r t / acrossAt body r t
    steep = case body of
      Cone (Axle _ g radius) -> radius / modulus g + modulus g / radius
      _ -> 0

-- | The largest number involved at a parameter, and the distance of the point from the axis, with no more than the
-- radius.
reachAt, acrossAt :: Body -> Ray -> Double -> Double
reachAt body r t = modulus p1 + modulus (origin r - p1) + abs t * modulus (direction r) + modulus g + radius
  where
    Axle p1 g radius = axleOf body
acrossAt body r t = case body of
  Cone _ -> min radius (modulus (cross (position r t - p1) g) / modulus g)
  _ -> radius
  where
    Axle p1 g radius = axleOf body

-- | Each normal is the gradient, made unit, of a part of the body that the point is near; to rounding.
hasNormalsOfItsParts :: Aimed -> Property
hasNormalsOfItsParts (Aimed body r _) = conjoin (map check (bodyParameters body r))
  where
    check t = counterexample (show (t, n)) (unknown t || any (fits t) (concat (bodyParts 0 body r (toRational t))))
      where
        n = bodyNormal body r t
        fits _ (Part place v) =
          place == Near && inner v (exact (vector n)) >= 0
            && squared (outer v (exact (vector n))) <= (512 * eps * toRational (reachAt body r t / acrossAt body r t)) ^ (2 :: Int) * squared v
    -- So close to an apex, or so far away, every direction is a normal's.
    unknown t = reachAt body r t * 2 ** (-40) > acrossAt body r t

-- | What is contained is inside by the definition; what is inside of a body smaller by 2^-15 is contained.
containsOnlyItsInside :: Aimed -> Property
containsOnlyItsInside (Aimed body r samples) = conjoin (map check (filter close samples))
  where
    check t
      | isBar body = property True
      | bodyContains body p = counterexample (show ("contained", t, p)) (place 0 === Inside)
      | otherwise = counterexample (show ("not contained", t, p)) (place (2 ^^ (-15 :: Int)) =/= Inside)
      where
        p = position r t
        -- The point itself, as the origin of a ray.
        place shrunk = bodyAt shrunk body (ray p (direction r)) 0
    close t = reachAt body r t < 2 ** 10 * extentLeast body

-- | Where a line enters or leaves, the point is not inside, if it did not come from too far.
doesNotContainItsSurface :: Aimed -> Property
doesNotContainItsSurface (Aimed body r _) =
  conjoin [counterexample (show t) (not (bodyContains body (position r t))) | t <- bodyParameters body r, reachAt body r t < 2 ** 10 * extentLeast body]

isBar :: Body -> Bool
isBar body = case body of
  Bar _ -> True
  _ -> False

-- | The size of a body, and its lesser size.
extent, extentLeast :: Body -> Double
extent body = let Axle _ g radius = axleOf body in modulus g + radius
extentLeast body = let Axle _ g radius = axleOf body in min 1 (min (modulus g) radius)

-------------------------------------------------------------------------------
-- Laws of motions

-- | Moving body and ray by the same vector changes no bit of any parameter or normal, if nothing is rounded by the
-- move.
movesAlong :: Aimed -> Property
movesAlong (Aimed body r _) = forAll (point Few) $ \v ->
  let exactly' x = all (== 0) (((x + v) - v) - x)
      Axle p1 _ _ = axleOf body
      r' = ray (origin r + v) (direction r)
      body' = mapAxle (\(Axle p g radius) -> Axle (p + v) g radius) body
   in (exactly' p1 && exactly' (origin r) && (origin r - p1) == (origin r + v) - (p1 + v)) ==> bodyParameters body' r' === bodyParameters body r

-- | A quarter turn about the z axis of body and ray changes no bit of any parameter, and turns each normal.
turnsAlong :: Aimed -> Property
turnsAlong (Aimed body r _) =
  bodyParameters body' r' === ts .&&. map (vector . bodyNormal body' r') ts === map (turned . vector . bodyNormal body r) ts
  where
    ts = bodyParameters body r
    turned (V3 x y z) = V3 (negate y) x z
    r' = ray (turned (origin r)) (turned (direction r))
    body' = mapAxle (\(Axle p g radius) -> Axle (turned p) (turned g) radius) body

-- | Multiplying all lengths by a power of two changes no bit of any parameter or normal.
scalesAlong :: Aimed -> Property
scalesAlong (Aimed body r _) = forAll (chooseInt (-20, 20)) $ \k ->
  let by = scaleFloat k
      r' = ray (fmap by (origin r)) (fmap by (direction r))
      body' = case mapAxle (\(Axle p g radius) -> Axle (fmap by p) (fmap by g) (by radius)) body of
        Lens a c1 c2 -> Lens a (by c1) (by c2)
        other -> other
   in bodyParameters body' r' === bodyParameters body r
        .&&. map (bodyNormal body' r') (bodyParameters body r) === map (bodyNormal body r) (bodyParameters body r)

-- | A direction twice as long has parameters half as large, bit for bit.
stretchesWithDirection :: Aimed -> Property
stretchesWithDirection (Aimed body r _) = forAll (chooseInt (-20, 20)) $ \k ->
  bodyParameters body (ray (origin r) (fmap (scaleFloat k) (direction r))) === map (scaleFloat (negate k)) (bodyParameters body r)

-- | The ray the other way has the opposite parameters, bit for bit, and the same normals.
reverses :: Aimed -> Property
reverses (Aimed body r _) =
  bodyParameters body back === map negate (reverse ts) .&&. map (bodyNormal body back . negate) ts === map (bodyNormal body r) ts
  where
    ts = bodyParameters body r
    back = ray (origin r) (negate (direction r))

mapAxle :: (Axle -> Axle) -> Body -> Body
mapAxle f body = case body of
  Bar a -> Bar (f a)
  Cylinder a -> Cylinder (f a)
  Cone a -> Cone (f a)
  Lens a c1 c2 -> Lens (f a) c1 c2

-------------------------------------------------------------------------------
-- Laws of single shapes

-- | The open tube has those parameters of the infinite one whose points are between its ends.
tubeIsPartOfLine :: Aimed -> Property
tubeIsPartOfLine (Aimed body r _) =
  tubeParameters p1 s h radius r === filter kept (tubeLineParameters p1 s radius r)
    .&&. conjoin [counterexample (show t) (Outside `notElem` ends t) | t <- tubeParameters p1 s h radius r]
    .&&. conjoin [counterexample (show t) (t `elem` tubeParameters p1 s h radius r) | t <- tubeLineParameters p1 s radius r, all (== Inside) (ends t)]
  where
    a@(Axle p1 _ radius) = axleOf body
    (s, h) = axis a
    kept t = let height = dot (position r t - p1) (vector s) in 0 <= height && height <= h
    ends = endsAt a r

-- | Whether a point is between the end planes of the open tube, which are asked about a position in space, so that its
-- rounding counts as well.
endsAt :: Axle -> Ray -> Double -> [Place]
endsAt a@(Axle p1 g _) r t = map check [height, squared (exact g) - height]
  where
    height = inner (along (minus (exact (origin r)) (exact p1)) (exact (direction r)) (toRational t)) (exact g)
    check x = atMostZero (64 * eps * toRational (modulus g * reachAt (Cylinder a) r t)) (negate x)

-- | Between a point inside the infinite tube and one outside it, both between the end planes, a line meets the tube.
tubeCrossesWhereItChanges :: Aimed -> Property
tubeCrossesWhereItChanges (Aimed body r samples) =
  conjoin
    [ counterexample (show (t1, t2)) (any (\t -> t1 <= t && t <= t2) (tubeParameters p1 s h radius r))
      | (t1, t2) <- zip sorted (drop 1 sorted),
        all (== Inside) (concatMap (endsAt a r) [t1, t2]),
        [side1, side2] <- [map (bodyAt 0 (Bar a) r . toRational) [t1, t2]],
        Near `notElem` [side1, side2],
        side1 /= side2
    ]
  where
    sorted = sort samples
    a@(Axle p1 _ radius) = axleOf body
    (s, h) = axis a

-- | A parameter on the curved part of a cylinder is one of the tube's, bit for bit: all others have an end's normal.
cylinderHasTubesParameters :: Aimed -> Property
cylinderHasTubesParameters (Aimed body r _) = conjoin (map check (cylinderParameters p1 s h radius r))
  where
    check t = counterexample (show t) (t `elem` tubeLineParameters p1 s radius r || cylinderNormal p1 s h radius r t `elem` [s, opposite s])
    a@(Axle p1 _ radius) = axleOf body
    (s, h) = axis a

-- | Where a line crosses the curved surface of a cone, it crosses the double cone: near by, if not at the same double.
--
-- The double cone is computed without the move to the apex, so that a root may be off by the square root of the
-- rounding, 2^-25 of the numbers involved, where it is nearly a double one.
conesContainCone :: Aimed -> Property
conesContainCone (Aimed body r _) =
  conjoin
    [ counterexample (show (t, cones)) (any (\x -> abs (x - t) <= 2 ** (-22) * (1 + steep) * reachAt body r t / modulus (direction r)) cones || null cones)
      | t <- coneParameters p1 s h radius r,
        coneNormal p1 s h radius r t `notElem` [s, opposite s],
        not alongSurface
    ]
  where
    -- In the surface, or nearly so, the polynomial is nothing but rounding.
    alongSurface = abs (modulus (cross (direction r) g) * h - radius * abs (dot (direction r) g)) <= 2 ** (-20) * modulus (direction r) * h * (h + radius)
    cones = conesParameters p1 (p1 + g) radius r
    a@(Axle p1 g radius) = axleOf body
    (s, h) = axis a
    steep = radius / h + h / radius

-- | With coordinates of few digits the number of parameters of the double cone is exact.
conesAreExact :: Property
conesAreExact = forAll ((,,,) <$> small <*> small <*> small <*> small) $ \(from, apex, o, d) ->
  forAll (fromIntegral <$> chooseInt (0, 6)) $ \radius ->
    let g = exact (apex - from)
        gg = squared g
        w = exact (o - apex)
        form u v = gg * inner (outer u g) (outer v g) - toRational (radius * radius :: Double) * inner u g * inner v g
        qa = form (exact d) (exact d)
        qb = 2 * form w (exact d)
        qc = form w w
        count
          | qa == 0 = if qb == 0 then 0 else 1
          | qb * qb < 4 * qa * qc = 0
          | otherwise = 2 :: Int
     in length (conesParameters from apex radius (ray o d)) === count
  where
    small = fmap fromIntegral <$> (V3 <$> chooseInt (-4, 4) <*> chooseInt (-4, 4) <*> chooseInt (-4, 4))

-- | Each point of a cap is on its sphere, and not behind its disk, to rounding.
capLiesOnSphere :: AimedCap -> Property
capLiesOnSphere (AimedCap cap r _) =
  conjoin [counterexample (show (t, capAt cap r t)) (fst (capAt cap r t) == Near && snd (capAt cap r t) /= Outside) | t <- capOf cap r]

-- | Between a point in the sphere and one outside it, both before the disk, a line meets the cap.
capCrossesWhereItChanges :: AimedCap -> Property
capCrossesWhereItChanges (AimedCap cap r samples) =
  conjoin
    [ counterexample (show (t1, t2)) (any (\t -> t1 <= t && t <= t2) (capOf cap r))
      | (t1, t2) <- zip sorted (drop 1 sorted),
        [(side1, Inside), (side2, Inside)] <- [map (capAt cap r) [t1, t2]],
        Near `notElem` [side1, side2],
        side1 /= side2
    ]
  where
    sorted = sort samples

-- | The normal of a cap is unit, and is the gradient of its sphere with the sign of c.
--
-- Its error is that of a position, fewer than 64 roundings, by the radius of the sphere.
capNormalPointsOut :: AimedCap -> Property
capNormalPointsOut (AimedCap (Capped p n radius c) r _) = conjoin (map check (capParameters p n radius c r))
  where
    check t = counterexample (show (t, slope)) (valid normal && slope >= 1 - 128 * 2 ** (-53) * (1 + reach / abs c))
      where
        normal = capNormal p n radius c (position r t)
        fromCentre = (position r t - p) + centreDepth radius c *^ vector n
        slope = dot (vector normal) (signum c *^ fromCentre) / abs c
        reach = modulus p + modulus (origin r - p) + abs t * modulus (direction r) + radius

-- | Where a line meets a bulging cap on the lens's own face within the rim, it enters or leaves the lens there.
capsAreOnLens :: Aimed -> Property
capsAreOnLens (Aimed body r _) = case body of
  Lens _ c1 _ ->
    conjoin
      [ counterexample (show (t, bodyAt 0 body r (toRational t))) (bodyAt 0 body r (toRational t) /= Inside)
        | t <- capParameters p1 (opposite s) radius c1 r
      ]
  _ -> property True
  where
    a@(Axle p1 _ radius) = axleOf body
    (s, _) = axis a

-- | Where a point is: in the sphere, and before the disk. The bounds are those of the lens ('bodyParts').
capAt :: Capped -> Ray -> Double -> (Place, Place)
capAt (Capped p n radiusDouble c) r t = (atMostZero bound (squared w + 2 * m * inner w axis' - radius * radius), atMostZero slack (negate (signum (toRational c) * inner w axis')))
  where
    axis' = exact (vector n)
    radius = toRational radiusDouble
    m = toRational (centreDepth radiusDouble c)
    from = minus (exact (origin r)) (exact p)
    w = along from (exact (direction r)) (toRational t)
    slack = 64 * eps * (magnitude from + abs (toRational t) * magnitude (exact (direction r)) + radius)
    size = magnitude w + radius
    bound = 128 * eps * (size * size + 2 * abs m * size) + 2 * slack * (size + abs m) + slack * slack

capOf :: Capped -> Ray -> [Double]
capOf (Capped p n radius c) = capParameters p n radius c

-------------------------------------------------------------------------------
-- Generators

-- | A body, a ray that passes close to it, and parameters of points around it.
data Aimed = Aimed Body Ray [Double]
  deriving (Show)

-- | A cap: the centre and the normal of its disk, the radius, and the curvature.
data Capped = Capped Point Unit Double Double
  deriving (Show)

-- | A cap, a ray, and parameters of points around it.
data AimedCap = AimedCap Capped Ray [Double]
  deriving (Show)

instance Arbitrary Aimed where
  arbitrary = do
    body <- anyBody
    r <- rayAt (axleOf body)
    Aimed body r <$> samplesOf (axleOf body) r

instance Arbitrary AimedCap where
  arbitrary = do
    a@(Axle p _ radius) <- axle
    let (s, _) = axis a
    c <- curvature radius
    r <- rayAt a
    AimedCap (Capped p s radius c) r <$> samplesOf a r

axle :: Gen Axle
axle = do
  kind <- elements [Few, Few, Full, Full, Full, Wide]
  Axle <$> point kind <*> oneof [axisStep kind, step kind] <*> positive kind

anyBody :: Gen Body
anyBody = do
  a <- axle
  oneof [pure (Bar a), pure (Cylinder a), pure (Cone a), anyLens a, anyLens a]

-- | A lens that has a thickness on its axis.
anyLens :: Axle -> Gen Body
anyLens a@(Axle _ g radius) = do
  (c1, c2) <- ((,) <$> curvature radius <*> curvature radius) `suchThat` possible
  pure (Lens a c1 c2)
  where
    possible (c1, c2) = modulus g + depth c1 + depth c2 > 2 ** (-30) * (modulus g + radius)
    depth c = signum c * (radius * radius) / (abs c + abs (centreDepth radius c))

-- | A signed radius of curvature: the rim's radius itself (a half ball), a little more, or much more (nearly flat).
curvature :: Double -> Gen Double
curvature radius = do
  sign <- elements [1, -1]
  more <- oneof [pure 0, elements [1, 1.25, 2, 3], choose (1, 4), (1 +) . abs <$> (chooseInt (-50, -1) >>= ofSize), abs <$> (chooseInt (1, 25) >>= ofSize)]
  pure (sign * radius * max 1 more)

-- | A ray aimed at a point on a rim, at the apex, on the axis, in an end plane or around, along the axis or across it,
-- along the surface of the cone, or anyhow; from near or from afar.
rayAt :: Axle -> Gen Ray
rayAt a@(Axle p1 g radius) = do
  target <- pointNear
  d <- frequency [(3, step Full), (2, pure g), (2, pure (radius *^ e1)), (2, slanted), (3, subtract target <$> pointNear)] `suchThat` (/= 0)
  length' <- elements [1, -1, 0.5, 3]
  distance' <- oneof [elements [0, 1, 2, 4], choose (-2, 2), abs <$> (chooseInt (-3, 8) >>= ofSize)]
  pure (ray (target - distance' *^ d) (length' *^ d))
  where
    (s, _) = axis a
    (e1, e2) = frame s
    around = oneof [elements [e1, e2, negate e1, negate e2], (\x -> cos x *^ e1 + sin x *^ e2) <$> choose (0, 2 * pi)]
    pointNear = do
      height <- oneof [elements [0, 1, 0.5], choose (-0.5, 1.5)]
      away <- oneof [elements [0, 0.5, 1, 1 - height], choose (0, 1.5), (1 +) <$> (chooseInt (-50, -10) >>= ofSize)]
      e <- around
      pure (p1 + height *^ g + (away * radius) *^ e)
    slanted = (\e -> g + radius *^ e) <$> around

-- | Parameters around a body: as many as 16, spread over twice its size around the point of the line next to its
-- middle, and a few far away.
samplesOf :: Axle -> Ray -> Gen [Double]
samplesOf (Axle p1 g radius) r = do
  near <- vectorOf 12 (choose (-1, 1))
  far <- vectorOf 4 ((*) <$> choose (-1, 1) <*> elements [8, 64, 1024])
  pure [middle + x * size | x <- 0 : near ++ far]
  where
    d = direction r
    middle = dot (p1 + 0.5 *^ g - origin r) d / dot d d
    size = (modulus g + radius) / modulus d
