-- |
-- Module      : Laws.Obvious
-- Description : A slow and obvious ray tracer's geometry
--
-- The second implementation of every shape: what the scene says, written as polynomial equations and inequalities, into
-- which the line o + t d is put coordinate by coordinate. Everything is a rational number; there is no index, no unit
-- vector, no move, no shortcut, and nothing of the program's but the types of its shapes.
--
-- >   a skin          equation = 0, where inequalities hold       a disk, a tube, a torus
-- >   a solid         where inequalities hold                     a cube, a cone, a lens
--
-- A skin is met at the roots of its equation. A solid is met where the line enters it or leaves it: between
-- neighbouring roots of all its inequalities nothing changes, so one point of each gap tells. Equations are multiplied
-- by whatever makes them polynomials: with the axis g from P1 to P2, of any length, and w = v - P1, the tube |w_perp| =
-- R is |w|^2 |g|^2 - \<w, g>^2 = R^2 |g|^2. The only numbers that are not exact are the square roots in caps and
-- lenses, where those are not rational (2^-250 of themselves), sines and cosines (2^-190), and the roots of tori
-- (2^-110).
--
-- With each inequality comes its /doubt/: the size of the numbers that a program that computes in binary64 has to round
-- on the way, as the specification's rules lead it. Where p is below some roundings of its doubt, such a program may
-- take its sign for the other one; 'meetings' says where it must meet the shape all the same.
module Laws.Obvious
  ( -- * Shapes
    Obvious,
    Figure,
    obvious,

    -- * Exactly
    exactParameters,
    firstOf,

    -- * With doubts
    Meeting (..),
    meetings,
    allowance,
  )
where

import Data.List (foldl', minimumBy, sortOn)
import Data.Ord (comparing)
import Dioptre.Geometry.Axis (Round, axisEnd, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Cap (capCurvature, capDisk)
import Dioptre.Geometry.Cube (cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (annulusInner, annulusOuter, annulusPlane, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (lensBody, lensCurvatures)
import Dioptre.Geometry.Plane (planeNormal, planePosition)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (torusMajor, torusMinor, torusPlane)
import Dioptre.Geometry.Triangle (Corners (..), Triangle, smoothTriangleFlat, trianglePoints)
import Dioptre.Math.Vector (Point)
import Laws.Exact hiding (along)
import Laws.Obvious.Motion
import Laws.Obvious.Polynomial
import Linear.V3 (V3 (..))

-- | A polynomial, and how large the numbers are that are rounded on the way to it, at a parameter.
data Leaf = Leaf Polynomial (Double -> Double)

-- | Where inequalities hold.
data Region
  = -- | The polynomial is not negative.
    From Leaf
  | Both Region Region
  | Either Region Region

-- | What there is of a shape on a line.
data Figure
  = -- | A surface where the polynomial is zero, within a region.
    Skin Leaf Region
  | -- | A region whose boundary is met.
    Solid Region

-- | A shape: what there is of it on any line.
type Obvious = Line -> Figure

-------------------------------------------------------------------------------
-- A line

-- | The coordinates of the line's points, measured from a point.
from :: Line -> Exact -> V3 Polynomial
from l p = linear <$> (lineOrigin l - p) <*> lineDirection l

-- | Products and sums of coordinates.
product2 :: V3 Polynomial -> V3 Polynomial -> Polynomial
product2 (V3 a b c) (V3 x y z) = times a x `plus` times b y `plus` times c z

along :: Exact -> V3 Polynomial -> Polynomial
along (V3 a b c) (V3 x y z) = scaledBy a x `plus` scaledBy b y `plus` scaledBy c z

-- | How far the line's point is from a point, at most.
near :: Line -> Exact -> Double -> Double
near l p = \t -> abs (x + t * dx) + abs (y + t * dy) + abs (z + t * dz)
  where
    V3 x y z = fromRational <$> (lineOrigin l - p)
    V3 dx dy dz = fromRational <$> lineDirection l

-- | The sizes of the numbers of which that is made: how far the origin is, and how long the way from there.
reach :: Line -> Exact -> Double -> Double
reach l p = \t -> o + abs t * d
  where
    o = fromRational (magnitude (lineOrigin l - p) + originBlur l)
    d = fromRational (magnitude (lineDirection l) + directionBlur l)

-- | The same in the coordinates of the world, or of the frame.
place :: Line -> Double -> Double
place l = reach l 0

sizeOf :: Exact -> Double
sizeOf = fromRational . magnitude

-------------------------------------------------------------------------------
-- Shapes

-- | A shape as it is written in the scene.
obvious :: Shape -> Obvious
obvious shape = case shape of
  APlane p -> flat (planeFrame p) (exact (planePosition p)) (const everywhere)
  ADisk x -> flat (planeFrame (diskPlane x)) (centre (diskPlane x)) (within (centre (diskPlane x)) (toRational (diskRadius x)))
  AnAnnulus x -> flat (planeFrame (annulusPlane x)) (centre (annulusPlane x)) $ \l ->
    Both (within (centre (annulusPlane x)) (toRational (annulusOuter x)) l) (beyond (centre (annulusPlane x)) (toRational (annulusInner x)) l)
  ASphere x -> ball (exact (sphereCentre x)) (toRational (sphereRadius x))
  ACube x -> box (exact (cubeCentre x)) (toRational (cubeSize x) / 2)
  ATriangle t -> threeCorners t
  ASmoothTriangle t -> threeCorners (smoothTriangleFlat t)
  ATube r -> let a = spindle r in \l -> Skin (bar a l) (Both (afterStart a l) (beforeEnd a l))
  ACylinder r -> let a = spindle r in \l -> Solid (Both (From (bar a l)) (Both (afterStart a l) (beforeEnd a l)))
  ACone r -> cone (spindle r)
  ALens x -> lensBetween (spindle (lensBody x)) (lensCurvatures x)
  ACap x -> capOver (planeFrame (diskPlane (capDisk x))) (centre (diskPlane (capDisk x))) (toRational (diskRadius (capDisk x))) (toRational (capCurvature x))
  ATorus x -> ring (exact (planeNormal (torusPlane x))) (centre (torusPlane x)) (toRational (torusMajor x)) (toRational (torusMinor x))
  ATransformed m x -> obvious x . carriedBack m
  where
    centre = exact . planePosition
    planeFrame p = (exact (planeNormal p), sizeOf (exact (planeNormal p)))

-- | No inequality: 1 is not negative.
everywhere :: Region
everywhere = From (Leaf (constant 1) (const 0))

-- | A part of a plane: \<n, v - P> = 0. The doubt of a normal counts by a size that may exceed its own (a triangle's).
--
-- A line whose angle with the plane has a sine of at most 2^-50 is parallel (@geometry.plane.parallel@), and does not
-- meet it.
flat :: (Exact, Double) -> Exact -> (Line -> Region) -> Obvious
flat (n, size) p region l = Skin (Leaf (along n (from l p)) (\t -> size * reach l p t)) (Both steep (region l))
  where
    a = inner n (lineDirection l)
    dSize = fromRational (magnitude (lineDirection l) + directionBlur l)
    steep = From (Leaf (constant (a * a - squared n * squared (lineDirection l) / 2 ^ (100 :: Int))) (\_ -> (2 * abs (fromRational a) + 2 ** (-46) * size * dSize) * size * dSize))

-- | R^2 - |v - P|^2 for a point of the plane; a program knows its coordinates with the roundings of a position.
inDisk :: Exact -> Rational -> Line -> Leaf
inDisk p radius l = Leaf (constant (radius * radius) `minus` product2 v v) (\t -> let w = near l p t in w * w + r * r + (2 * w + 2 ** (-46) * place l t) * place l t)
  where
    v = from l p
    r = fromRational radius

within, beyond :: Exact -> Rational -> Line -> Region
within p radius l = From (inDisk p radius l)
beyond p radius l = From (opposite (inDisk p radius l))

opposite :: Leaf -> Leaf
opposite (Leaf p doubt) = Leaf (scaledBy (-1) p) doubt

-- | R^2 - |v - C|^2. The rule takes the ray as it comes, and the square of its whole distance is rounded.
ball :: Exact -> Rational -> Obvious
ball c radius l = Solid (From (Leaf (constant (radius * radius) `minus` product2 v v) (\t -> reach l c t ^ (2 :: Int) + r * r)))
  where
    v = from l c
    r = fromRational radius

-- | Six half spaces.
box :: Exact -> Rational -> Obvious
box c h l = Solid (foldr1 Both (concat (zipWith3 faces (components c) (components (from l c)) (zip (components (lineOrigin l)) (components (lineDirection l))))))
  where
    faces m x (o, d) = [From (Leaf (constant h `minus` x) doubt), From (Leaf (constant h `plus` x) doubt)]
      where
        doubt t = fromRational (abs (o - m) + h + abs m + originBlur l) + abs t * fromRational (abs d + directionBlur l)

-- | A part of a plane on one side of three edges. An edge function is the triple product of the direction and two
-- corners, seen from the origin; its shadows round numbers as large as the corners' distances (S. Woop, C. Benthin, I.
-- Wald, 2013). Of the point in the plane, the product (Pj - Pi) x (v - Pi) is that times \<n, n> \/ \<d, n>.
threeCorners :: Triangle -> Obvious
threeCorners x l = flat (n, sizeOf (outerMagnitudes e1 e2)) p0 (const (foldr1 Both (zipWith side corners (drop 1 (cycle corners))))) l
  where
    Corners p0 p1 p2 = let Corners a b c = trianglePoints x in Corners (exact (a :: Point)) (exact b) (exact c)
    corners = [p0, p1, p2]
    e1 = p1 - p0
    e2 = p2 - p0
    n = outer e1 e2
    d = lineDirection l
    shadow p = fromRational (magnitude (p - lineOrigin l) + originBlur l) :: Double
    shallow = fromRational (maximum (magnitudes d) + directionBlur l) * fromRational (squared n) / abs (fromRational (inner d n)) :: Double
    side a b = From (Leaf (along (outer n (b - a)) (from l a)) (\_ -> if inner d n == 0 then 1 / 0 else 2 * shadow a * shadow b * shallow))

-- | P1, the vector from P1 to P2, its square, the radius; and the last three as numbers to count doubts by.
data Spindle = Spindle Exact Exact Rational Rational Double Double Double

spindle :: Round -> Spindle
spindle r = Spindle p1 g (squared g) radius (sizeOf g) (fromRational (squared g)) (fromRational radius)
  where
    p1 = exact (axisStart (roundAxis r))
    g = exact (axisEnd (roundAxis r)) - p1
    radius = toRational (roundRadius r)

-- | R^2 |g|^2 - (|w|^2 |g|^2 - \<w, g>^2).
aroundAxis :: Spindle -> Line -> Polynomial
aroundAxis (Spindle p1 g gg radius _ _ _) l = constant (radius * radius * gg) `minus` (scaledBy gg (product2 w w) `minus` times a a)
  where
    w = from l p1
    a = along g w

-- | Tube and cylinder take the ray as it comes.
bar :: Spindle -> Line -> Leaf
bar s@(Spindle p1 _ _ _ _ gg r) l = Leaf (aroundAxis s l) (\t -> gg * (reach l p1 t ^ (2 :: Int) + r * r))

-- | 0 <= \<w, g> and \<w, g> <= |g|^2.
afterStart, beforeEnd :: Spindle -> Line -> Region
afterStart (Spindle p1 g _ _ size _ _) l = From (Leaf (along g (from l p1)) (\t -> size * (reach l p1 t + place l t + size)))
beforeEnd (Spindle p1 g gg _ size _ _) l = From (Leaf (constant gg `minus` along g (from l p1)) (\t -> size * (reach l p1 t + place l t + size)))

-- | Measured from the apex P2: R^2 a^2 >= |g|^2 (|w|^2 |g|^2 - a^2) with a = \<w, g>, and -|g|^2 <= a <= 0. Rounded are
-- the square of the point's distance from the apex, and, to reach the apex, its position.
cone :: Spindle -> Obvious
cone (Spindle p1 g gg radius size ggSize r) l = Solid (Both (From curved) (Both base end))
  where
    apex = p1 + g
    w = from l apex
    a = along g w
    a2 = times a a
    doubt t = let x = near l apex t; y = reach l apex t + size in ggSize * (ggSize + r * r) * (x * x + 2 * x * y + 2 ** (-46) * y * y)
    curved = Leaf (scaledBy (radius * radius) a2 `minus` scaledBy gg (scaledBy gg (product2 w w) `minus` a2)) doubt
    flatDoubt t = size * (reach l apex t + size)
    base = From (Leaf (constant gg `plus` a) flatDoubt)
    end = From (Leaf (scaledBy (-1) a) flatDoubt)

-- | The side of the bar, and before each face: under its sphere, or for a hollow one above it. Measured from the ray's
-- point nearest to the middle.
lensBetween :: Spindle -> (Double, Double) -> Obvious
lensBetween s@(Spindle p1 g gg radius size ggSize r) (c1, c2) = \l -> Solid (Both (From (side l)) (Both (start l) (end l)))
  where
    side l = Leaf (aroundAxis s l) (\t -> let x = near l p1 t + size + r in ggSize * (x * x + 2 * x * (reach l p1 t + size)))
    start = face c1 p1 (negate g)
    end = face c2 (p1 + g) g
    face c p outward
      | c > 0 = \l -> let (sphere, under) = dome (toRational c) p outward l in Either (From under) (From sphere)
      | otherwise = \l -> let (sphere, under) = dome (toRational c) p (negate outward) l in Both (From (opposite under)) (From (opposite sphere))
    -- R^2 - |v|^2 - 2 m <v, q> and -m |g| - <v, g>, with m = sqrt (c^2 - R^2) and the unit vector q along g.
    dome c p q = \l ->
      let v = from l p
          h = along q v
       in ( Leaf (constant (radius * radius) `minus` product2 v v `minus` scaledBy (2 * depth) h) (sphereDoubt l p radius (abs c) size),
            Leaf (constant (negate depthTimesSquare) `minus` h) (\t -> size * (reach l p t + size + fromRational (abs c)))
          )
      where
        depth = squareRoot ((c * c - radius * radius) / gg)
        depthTimesSquare = depth * gg

-- | How large the numbers are that make the equation of a sphere with the radius c over a disk of radius R: the point's
-- distance from the disk's centre, and the ray's way to it, next to a body of some size.
sphereDoubt :: Line -> Exact -> Rational -> Rational -> Double -> Double -> Double
sphereDoubt l p radius c size = \t ->
  let x = near l p t + r
      y = reach l p t + size
   in x * x + 2 * m * x + 2 * (x + m) * y + 2 ** (-46) * y * y
  where
    r = fromRational radius
    m = fromRational (squareRoot (c * c - radius * radius))

-- | R^2 - |v|^2 - 2 m \<v, n> = 0 where c \<v, n> is not negative, v measured from the disk's centre.
capOver :: (Exact, Double) -> Exact -> Rational -> Rational -> Obvious
capOver (n, size) p radius c = \l ->
  let v = from l p
      h = along n v
   in Skin
        (Leaf (constant (radius * radius) `minus` product2 v v `minus` scaledBy (2 * signum c * depth) h) (sphereDoubt l p radius (abs c) 0))
        (From (Leaf (scaledBy (signum c) h) (\t -> size * reach l p t)))
  where
    depth = squareRoot ((c * c - radius * radius) / squared n)

-- | (|v|^2 + R^2 - r^2)^2 = 4 R^2 (|v|^2 - h^2), times |n|^2.
ring :: Exact -> Exact -> Rational -> Rational -> Obvious
ring n p major minor l = Skin (Leaf equation doubt) everywhere
  where
    nn = squared n
    v = from l p
    v2 = product2 v v
    h = along n v
    k = v2 `plus` constant (major * major - minor * minor)
    equation = scaledBy nn (times k k) `minus` scaledBy (4 * major * major) (scaledBy nn v2 `minus` times h h)
    extent = fromRational (major + minor)
    doubt t = let x = near l p t + extent in fromRational nn * x * x * x * (x + reach l p t)

-------------------------------------------------------------------------------
-- Exactly

-- | Every parameter at which the line meets the shape, ascending; one at which it touches a solid, twice.
exactParameters :: Figure -> [Rational]
exactParameters figure = case figure of
  Skin (Leaf p _) region -> [approximately t | t <- realRoots p, holds region t]
  Solid region -> boundary region

-- | Whether a place of the line is in a region.
holds :: Region -> Place -> Bool
holds region t = case region of
  From (Leaf p _) -> signAt p t >= 0
  Both a b -> holds a t && holds b t
  Either a b -> holds a t || holds b t

leaves :: Region -> [Leaf]
leaves region = case region of
  From leaf -> [leaf]
  Both a b -> leaves a ++ leaves b
  Either a b -> leaves a ++ leaves b

-- | Where a line enters a region or leaves it. Roots that agree to 2^-150 are one.
boundary :: Region -> [Rational]
boundary region = concat (zipWith3 met places (gaps values) (drop 1 (gaps values)))
  where
    places = grouped (sortOn fst [(approximately t, t) | Leaf p _ <- leaves region, t <- realRoots p])
    values = map fst places
    gaps [] = []
    gaps ts = map (holds region . placeOf) (minimum ts - 1 : zipWith (\a b -> (a + b) / 2) ts (drop 1 ts) ++ [maximum ts + 1])
    met (t, same) before after
      | before /= after = [t]
      | not before && any (holds region) same = [t, t]
      | otherwise = []
    grouped ((t, p) : rest) =
      let (equal, others) = span (\(x, _) -> x - t <= abs t / 2 ^ (150 :: Int)) rest
       in (t, p : map snd equal) : grouped others
    grouped [] = []

-- | What a ray meets first of a list of shapes: the least parameter above 1e-8, and the number of the shape; of several
-- there, the first.
firstOf :: [Figure] -> Maybe (Rational, Int)
firstOf figures = case [(t, i) | (i, f) <- zip [0 ..] figures, t <- take 1 (filter (> toRational (1e-8 :: Double)) (exactParameters f))] of
  [] -> Nothing
  hits -> Just (minimumBy (comparing fst) hits)

-------------------------------------------------------------------------------
-- With doubts

-- | An interval of the line in which a program may meet the shape. Where that is certain, it must.
data Meeting = Meeting {meetingFrom :: Rational, meetingTo :: Rational, isCertain :: Bool}
  deriving (Eq, Show)

-- | How many roundings of its doubt a polynomial may be off: times eps, 64.
--
-- A position o + t d, its difference from a point of the shape, and what of that is along or across an axis take fewer
-- than 16 roundings, of numbers no larger than those that the doubt adds up; a polynomial of degree two of such numbers
-- takes three times as many, its coefficients and its roots (5 eps of its terms, "Laws.Roots") included. Carrying a ray
-- back takes 8 more.
allowance :: Rational
allowance = 64 * eps

-- | Where a program may meet the shape, and where it must, ascending; it may meet it nowhere else.
--
-- In a /zone/ a polynomial is within the allowance of zero; outside of all zones every sign is certain. A solid must be
-- met in a zone if the gaps beside are on different sides of its boundary; a skin, if its equation has different signs
-- there, and if its region holds in all of the zone.
meetings :: Figure -> [Meeting]
meetings figure = case figure of
  Skin leaf@(Leaf p _) region ->
    [ Meeting a b (crosses p a b && answer == Yes)
      | (a, b) <- zones leaf,
        let answer = certainly region a b,
        answer /= No
    ]
  Solid region ->
    let merged = merge (sortOn fst (concatMap zones (leaves region)))
        inside = map (holds region . placeOf) (betweens merged)
     in [Meeting a b (before /= after) | ((a, b), before, after) <- zip3 merged inside (drop 1 inside), before /= after || possibly region a b]
  where
    crosses p a b = signAt p (placeOf a) * signAt p (placeOf b) < 0
    possibly region a b = certainly region a b /= No
    betweens [] = []
    betweens zs@((a, _) : _) = a - 1 : zipWith (\(_, b) (c, _) -> (b + c) / 2) zs (drop 1 zs) ++ [maximum (map snd zs) + 1]
    merge ((a, b) : (c, d) : rest)
      | c <= b = merge ((a, max b d) : rest)
      | otherwise = (a, b) : merge ((c, d) : rest)
    merge zs = zs

-- | Beyond all parameters.
endless :: Rational
endless = 2 ^ (1100 :: Int)

-- | The intervals in which a polynomial is within the allowance of zero, ascending, together.
--
-- They are sought from the roots, and from the vertex of a parabola that has none, with the doubt that there is, a
-- quarter larger. Where the doubt at the ends of what is found is larger than that (as it is for a line that nearly
-- lies in the surface), they are sought again with that one; and where this comes to no end, nothing is known anywhere.
-- The zones of polynomials of higher degree have the largest doubt of all their roots and turns.
zones :: Leaf -> [(Rational, Rational)]
zones (Leaf p doubt) = case taylorAt p 0 of
  [] -> [(negate endless, endless)]
  [c] -> [(negate endless, endless) | abs c <= bound 0]
  [_, _] -> concatMap around roots
  [_, b, a] -> concatMap around (if null roots then [negate b / (2 * a)] else roots)
  _ -> intervals (5 / 4 * maximum (map bound (roots ++ map approximately (realRoots (derivativeOf p)))))
  where
    roots = map approximately (realRoots p)
    bound t = let q = doubt (fromRational t) in if isInfinite q || isNaN q then endless else allowance * toRational q
    around t = sought (8 :: Int) (5 / 4 * bound t)
      where
        sought n q
          | needed <= q = here
          | n == 0 = [(negate endless, endless)]
          | otherwise = sought (n - 1) (5 / 4 * needed)
          where
            here = [z | z@(a, b) <- intervals q, a <= t, t <= b]
            needed = maximum (0 : concat [[bound a, bound b] | (a, b) <- here])
    -- Between neighbouring roots of p - q and p + q.
    intervals q =
      let ends = sortOn id (map approximately (realRoots (minus p (constant q)) ++ realRoots (plus p (constant q))))
          low = case ends of [] -> negate endless; t : _ -> t
          high = foldl' (const id) endless ends
          stretches = [(negate endless, low) | not (null ends)] ++ zip ends (drop 1 ends) ++ [(high, endless) | not (null ends)] ++ [(negate endless, endless) | null ends]
       in joined [(a, b) | (a, b) <- stretches, abs (valueAt p (inside a b)) <= q]
    inside a b
      | a == negate endless = if b == endless then 0 else b - 1
      | b == endless = a + 1
      | otherwise = (a + b) / 2
    joined ((a, b) : (c, d) : rest)
      | c == b = joined ((a, d) : rest)
      | otherwise = (a, b) : joined ((c, d) : rest)
    joined zs = zs

derivativeOf :: Polynomial -> Polynomial
derivativeOf p = foldr1 plus (zipWith3 (\k c power -> scaledBy (k * c) power) (map fromInteger [1 ..]) (drop 1 (taylorAt p 0)) (iterate (times (linear 0 1)) (constant 1)))

-- | What is certain for all of an interval.
data Answer = No | Unknown | Yes
  deriving (Eq, Ord, Show)

certainly :: Region -> Rational -> Rational -> Answer
certainly region a b = case region of
  Both x y -> min (certainly x a b) (certainly y a b)
  Either x y -> max (certainly x a b) (certainly y a b)
  From (Leaf p doubt)
    | least > bound -> Yes
    | greatest < negate bound -> No
    | otherwise -> Unknown
    where
      middle = (a + b) / 2
      half = (b - a) / 2
      parts = taylorAt p middle
      spread = sum (zipWith (*) (map abs (drop 1 parts)) (drop 1 (iterate (half *) 1)))
      least = sum (take 1 parts) - spread
      greatest = sum (take 1 parts) + spread
      q = maximum (map (doubt . fromRational) [a, middle, b])
      bound = if isInfinite q || isNaN q then endless * endless else allowance * toRational q
