-- |
-- Module      : Laws.Thin
-- Description : Flat cones and caps: they are nearly the disk that they stand on
--
-- A cone over a disk of radius R, and a cap whose sphere is much larger, are within a small height of their disk. A
-- line that crosses the disk's plane steeply meets them next to where it crosses, or not at all, and which of both is
-- known from the distance of that place from the axis: from rational numbers here, without the shapes' equations.
module Laws.Thin
  ( Thin (..),
    thinShape,
    thinCrowd,

    -- * Laws
    isMetWithin,
    isNotMetBeside,
    isMetNextToItsDisk,
    isOnItsPicture,

    -- * Where the rules change
    Turning (..),
    changesContinuously,
  )
where

import Data.Maybe (mapMaybe)
import Dioptre.Geometry.Axis (axis, roundShape)
import Dioptre.Geometry.Cap (cap, capParameters)
import Dioptre.Geometry.Cone (coneParameters)
import Dioptre.Geometry.Disk (disk)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Prepared (Prepared, parameters, prepare, textureAt)
import Dioptre.Geometry.Ray (Ray, direction, origin, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Math.Vector (Point, Unit, Vector, alongX, alongY, alongZ, cross, modulus, quadrance, unit, vector, (*^))
import Dioptre.Model.Library (noModels)
import Dioptre.Render.World (world)
import Laws.Closest (sceneOf)
import Laws.Exact
import Laws.Exactness (Crowd (..), Scenery (..))
import Laws.Obvious (obvious)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-- | A flat cone or cap: the centre of its disk, the unit normal, the radius, and H (of a cone) or c (of a cap); and a
-- ray.
data Thin
  = ThinCone Point Unit Double Double Ray
  | ThinCap Point Unit Double Double Ray
  deriving (Eq, Show)

instance Arbitrary Thin where
  arbitrary = oneof [someCone, someCap]
    where
      someCone = do
        s <- oneof [elements [alongX, alongY, alongZ], someUnit]
        radius <- someRadius
        h <- (\k -> radius * 2 ** negate k) <$> oneof [choose (5.01, 24), choose (5.01, 200)]
        -- An apex is rounded where it does not lie at the origin or across the axis: then the axis would be another
        -- one.
        p <- if s `elem` [alongX, alongY, alongZ] then (\v -> 4 * radius *^ (v - fmap (* sum (v * vector s)) (vector s))) <$> someVector else pure 0
        ThinCone p s radius h <$> rayAt p s radius
      someCap = do
        n <- someUnit
        radius <- someRadius
        p <- (\v -> 4 * radius *^ v) <$> someVector
        c <- (\k side -> side * radius * 2 ** k) <$> oneof [choose (4.01, 60), choose (4.01, 200)] <*> elements [1, -1]
        ThinCap p n radius c <$> rayAt p n radius
      someRadius = (2 **) <$> choose (-6, 6)

-- | A ray that is aimed at a place of a disk's plane, up to three radii from the axis and often next to the rim, from
-- up to a hundred radii away, no more than 80 degrees from the axis.
rayAt :: Point -> Unit -> Double -> Gen Ray
rayAt p n radius = do
  e <- someAcross n
  f <- frequency [(2, choose (0, 3)), (1, elements [0, 0.5, 1.5]), (3, (\k side -> 1 + side * 2 ** negate k) <$> choose (1, 44) <*> elements [1, -1 :: Double])]
  u <- (vector <$> someUnit) `suchThat` (\u -> abs (sum (u * vector n)) > 0.18)
  away <- (10 **) <$> choose (0, 2)
  size <- elements [1, 1, 1, 0.125, 7]
  let o = p + f * radius *^ e - away * radius *^ u
  pure (ray o (size *^ u))

someVector :: Gen Vector
someVector = V3 <$> choose (-1, 1) <*> choose (-1, 1) <*> choose (-1, 1)

someUnit :: Gen Unit
someUnit = (someVector `suchThat` (\v -> quadrance v <= 1 && quadrance v > 0.01)) >>= maybe someUnit pure . unit

someAcross :: Unit -> Gen Vector
someAcross n = do
  v <- someVector
  if modulus (cross (vector n) v) > 0.1 then maybe (someAcross n) (pure . vector) (unit (cross (vector n) v)) else someAcross n

thinRay :: Thin -> Ray
thinRay (ThinCone _ _ _ _ r) = r
thinRay (ThinCap _ _ _ _ r) = r

-- | As scenes have it.
thinShape :: Thin -> Maybe Shape
thinShape thin = case thin of
  ThinCone p s radius h _ -> ACone <$> (axis p (p + h *^ vector s) >>= (`roundShape` radius))
  ThinCap p n radius c _ -> ACap <$> (plane p (vector n) >>= (`disk` radius) >>= (`cap` c))

prepared :: Thin -> Maybe Prepared
prepared thin = thinShape thin >>= prepare

-- | Many of them in a scene, and their rays.
thinCrowd :: Gen Crowd
thinCrowd = do
  drawn <- vectorOf 24 arbitrary
  let shapes = mapMaybe thinShape drawn
  pure (Crowd (Scenery shapes 0 (world mempty noModels (sceneOf shapes)) (mapMaybe prepare shapes) (map obvious shapes)) (map thinRay drawn))

-- | Where the line crosses the plane of the disk: the parameter, the distance from the axis as a bound from below and
-- from above, and how far a shape of that height may be met from there: along the line, in parameters; and in the
-- plane.
--
-- The height is at most H, or R^2 \/ |c|; the line goes through it in no more than the height over the cosine with the
-- axis. The rounding of a position is that of the coordinates, fewer than 64 roundings of numbers no larger than |o -
-- P| + |P| + R, over the cosine too. (An axis that is made unit from rounded points is off by 2^-52, which moves the
-- plane under the line by no more.)
data Crossing = Crossing Rational Rational Rational Rational Rational

crossing :: Thin -> Crossing
crossing thin = Crossing t (rootBelow (squared flat)) (rootAbove (squared flat)) (slack / rootBelow (squared d)) slack
  where
    (p, n, radius, height) = case thin of
      ThinCone p' s radius' h _ -> (exact p', exact (vector s), toRational radius', toRational h)
      ThinCap p' n' radius' c _ -> (exact p', exact (vector n'), toRational radius', toRational radius' * toRational radius' / abs (toRational c))
    r = thinRay thin
    (o, d) = (exact (origin r), exact (direction r))
    t = inner (p - o) n / inner d n
    v = along o d t - p
    flat = v - fmap (inner v n / squared n *) n
    steepness = rootAbove (squared d) * rootAbove (squared n) / abs (inner d n)
    slack = steepness * (2 * height + 64 * eps * (magnitude (o - p) + magnitude p + radius))

radiusOf :: Thin -> Rational
radiusOf (ThinCone _ _ radius _ _) = toRational radius
radiusOf (ThinCap _ _ radius _ _) = toRational radius

-- | The parameters, or those of the sphere's near half.
thinParameters :: Thin -> [Double]
thinParameters thin = maybe [] (`parameters` thinRay thin) (prepared thin)

-- | A line that crosses the disk within the rim meets the shape: there are no holes.
isMetWithin :: Thin -> Property
isMetWithin thin = sure ==> counterexample (show (thinParameters thin)) (not (null (thinParameters thin)))
  where
    Crossing _ _ away _ slack = crossing thin
    sure = away + slack < radiusOf thin

-- | A line that passes the rim does not: the shape ends there.
isNotMetBeside :: Thin -> Property
isNotMetBeside thin = sure ==> thinParameters thin === []
  where
    Crossing _ away _ _ slack = crossing thin
    sure = away - slack > radiusOf thin

-- | Wherever it is met, that is next to where the line crosses the disk, and within the rim.
isMetNextToItsDisk :: Thin -> Property
isMetNextToItsDisk thin = conjoin [counterexample (show x) (abs (toRational x - t) <= near && away - slack <= radiusOf thin) | x <- thinParameters thin]
  where
    Crossing t away _ near slack = crossing thin

-- | Its texture coordinates are on the picture, to rounding.
isOnItsPicture :: Thin -> Property
isOnItsPicture thin = conjoin [counterexample (show (t, uv)) (onPicture uv) | Just shape <- [prepared thin], t <- thinParameters thin, let uv = textureAt shape (thinRay thin) t]
  where
    onPicture (V2 u v) = all (\x -> x >= -1e-9 && x <= 1 + 1e-9) [u, v]

-------------------------------------------------------------------------------
-- Where the rules change

-- | A disk, and a ray that crosses its plane.
data Turning = Turning Point Unit Double Ray
  deriving (Eq, Show)

instance Arbitrary Turning where
  arbitrary = do
    n <- someUnit
    radius <- (2 **) <$> choose (-6, 6)
    p <- (\v -> 4 * radius *^ v) <$> someVector
    Turning p n radius <$> rayAt p n radius

-- | On both sides of the height, or the curvature, at which a rule changes, a line has the same parameters, to the
-- rounding of positions, unless it passes the rim within that.
--
-- The height changes by 2^-50 of itself, or the curvature by as much, which moves a parameter by less. A cone of R = 32
-- H that is not flat knows the rim to 2^-44 of itself, as derived in the note there, and the other way and the caps
-- know it better; the bound is 64 times the one, in lengths of positions.
changesContinuously :: Turning -> Property
changesContinuously (Turning p n radius r) = same (cone' (radius / 32)) (cone' (radius / 32 * (1 - 2 ** (-50)))) .&&. conjoin [same (cap' (side * 16 * radius)) (cap' (side * 16 * radius * (1 + 2 ** (-50)))) | side <- [1, -1]]
  where
    cone' h = coneParameters p n h radius r
    cap' c = capParameters p n radius c r
    bound = 2 ** (-38) * (modulus (origin r - p) + modulus p + radius) / modulus (direction r)
    same xs ys = counterexample (show (xs, ys)) (sameNumber xs ys && and (zipWith (\x y -> abs (x - y) <= bound) xs ys))
    -- Where one of them has none, or one less, the line is at the rim.
    sameNumber xs ys = length xs == length ys || atRim
    atRim = any (\f -> null (coneParameters p n (radius / 32) (f * radius) r) /= null (coneParameters p n (radius / 32) radius r) || length (capParameters p n (f * radius) (16 * f * radius) r) /= length (capParameters p n radius (16 * radius) r)) [1 - 1e-9, 1 + 1e-9]
