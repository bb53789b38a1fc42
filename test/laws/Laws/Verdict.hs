-- |
-- Module      : Laws.Verdict
-- Description : Where a ray meets a shape, by another way and without rounding
--
-- The second opinion on every shape: the intersection over rational numbers, from the shape as it was written, by
-- another formula where there is one (triangles: Moeller and Trumbore's; spheres: the distance of the line from the
-- centre). With each exact parameter comes how far the computed one may be from it, and where rounding may turn hit
-- into miss there is no verdict.
module Laws.Verdict
  ( Verdict (..),
    Hit (..),
    verdict,
    isSure,

    -- * Bounds of errors
    planeResidual,
    sphereResidual,
    faceError,
    triangleFrame,
    flatFrame,
    crosses,

    -- * Exact intersections
    exactSlabs,
    exactTriangle,
  )
where

import Data.Maybe (catMaybes)
import Dioptre.Geometry.Cube (cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (annulusInner, annulusOuter, annulusPlane, diskPlane, diskRadius)
import Dioptre.Geometry.Plane (Plane, planeNormal, planePosition)
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Triangle (Corners (..), Triangle, smoothTriangleFlat, trianglePoints)
import Laws.Exact

-- | What must be found.
data Verdict
  = -- | Exactly these.
    Sure [Hit]
  | -- | Rounding may decide.
    Unsure
  deriving (Eq, Show)

-- | An exact parameter (to 2^-150 where it is irrational), and how far from it the computed one may be.
data Hit = Hit {hitParameter :: Rational, hitUncertainty :: Rational}
  deriving (Eq, Show)

isSure :: Verdict -> Bool
isSure v = v /= Unsure

-- | The verdict on a ray and a shape.
verdict :: Shape -> Ray -> Verdict
verdict shape r = case shape of
  APlane p -> flatVerdict (flatFrame p) (exact (planePosition p)) r
  ADisk x -> ringVerdict (diskPlane x) Nothing (diskRadius x) r
  AnAnnulus x -> ringVerdict (annulusPlane x) (Just (annulusInner x)) (annulusOuter x) r
  ASphere x -> sphereVerdict (exact (sphereCentre x)) (toRational (sphereRadius x)) r
  ACube x -> cubeVerdict (exact (cubeCentre x)) (toRational (cubeSize x) / 2) r
  ATriangle t -> triangleVerdict t r
  ASmoothTriangle t -> triangleVerdict (smoothTriangleFlat t) r
  _ -> Unsure

-- * Flat shapes

-- | A vector orthogonal to a plane; what the errors of the computed unit normal's direction count by, component by
-- component; and how many roundings a parameter suffers in all. The unit normal is c n_i (1 + eps), with a factor c
-- that does not matter. The products with it make \<n, d> have 1 + 3 roundings and \<n, o - P> 1 + 1 + 3, and the
-- quotient adds one: at most 6.
flatFrame :: Plane -> (Exact, Exact, Int)
flatFrame p = (n, magnitudes n, 6)
  where
    n = exact (planeNormal p)

-- | The same for a triangle: its normal's components are differences of two products of rounded edges, four roundings
-- more, and count by the sum of the products' magnitudes.
triangleFrame :: Triangle -> (Exact, Exact, Int)
triangleFrame t = (outer e1 e2, outerMagnitudes e1 e2, 10)
  where
    Corners p0 p1 p2 = exact <$$> trianglePoints t
    e1 = p1 - p0
    e2 = p2 - p0
    f <$$> Corners a b c = Corners (f a) (f b) (f c)

-- | How far \<n, r(t) - P> may be from zero at a computed parameter: with A = \<n, d> and B = \<n, w> computed, A t =
-- -B (1 + eps), and what A and B lack are k roundings of their terms.
planeResidual :: (Exact, Exact, Int) -> Exact -> Ray -> Rational -> Rational
planeResidual (_, s, k) p r t = gamma k * (inner s (magnitudes (exact (origin r) - p)) + abs t * inner s (magnitudes (exact (direction r))))

-- | Whether the ray crosses the plane: its angle with it has a sine, |<n, d>| \/ |n| |d|, above 2^-50. It is
-- uncertain where the sine is as near to that as the rounding of \<n, d>, or 8 roundings of the sine itself: of the
-- two squares, of |d|^2 and of |n|.
crosses :: (Exact, Exact, Int) -> Ray -> Maybe Bool
crosses (n, s, k) r
  | size < (1 - gamma 8) * limit rootBelow - slack = Just False
  | size > (1 + gamma 8) * limit rootAbove + slack = Just True
  | otherwise = Nothing
  where
    d = exact (direction r)
    size = abs (inner n d)
    slack = gamma k * inner s (magnitudes d)
    limit root = root (squared n * squared d) / 2 ^ (50 :: Int)

-- | From the residual at t = t* + x: |A x| <= gamma k (terms of B + (|t*| + |x|) terms of A).
flatVerdict :: (Exact, Exact, Int) -> Exact -> Ray -> Verdict
flatVerdict frame@(n, s, k) p r = case crosses frame r of
  Nothing -> Unsure
  Just False -> Sure []
  Just True -> Sure [Hit t (planeResidual frame p r t / (abs a - gamma k * inner s (magnitudes d)))]
  where
    d = exact (direction r)
    a = inner n d
    t = negate (inner n (exact (origin r) - p)) / a

-- | The distance from the centre is computed with four roundings of its own, of a point that has two, at a parameter
-- that has its uncertainty.
ringVerdict :: Plane -> Maybe Double -> Double -> Ray -> Verdict
ringVerdict p hole radius r = case flatVerdict (flatFrame p) c r of
  Sure [Hit t e]
    | away e >= 0 && beyond e -> Sure [Hit t e]
    | high + slack e < inmost || low - slack e > outmost -> Sure []
    | otherwise -> Unsure
    where
      q = along o d t
      low = rootBelow (squared (q - c))
      high = rootAbove (squared (q - c))
      slack x = (x * magnitude d + gamma 2 * (magnitude o + (abs t + x) * magnitude d)) * (1 + gamma 4) + gamma 4 * high
      away x = outmost - (high + slack x)
      beyond x = maybe True (const (low - slack x >= inmost)) hole
  other -> other
  where
    c = exact (planePosition p)
    o = exact (origin r)
    d = exact (direction r)
    outmost = toRational radius
    inmost = maybe (-1) toRational hole

-- * Spheres

-- | How far |r(t) - C|^2 - R^2 may be from zero at a computed parameter.
--
-- The root of the rounded polynomial leaves 5 eps (A t^2 + |C0|) of it (Laws.Roots, hasSmallResidual). A has 3
-- roundings, B has 4, and C0 = |w|^2 - R^2 has 5 in |w|^2, 1 in R^2 and 1 in their difference: 8 |d|^2 t^2, 4 |2 w d
-- t|, 5 + 5 + 1 of |w|^2 and 5 + 1 + 1 of R^2, and one more for the second order.
sphereResidual :: Exact -> Rational -> Ray -> Rational -> Rational
sphereResidual c radius r t =
  gamma 9 * squared d * t * t + gamma 5 * 2 * inner (magnitudes w) (magnitudes d) * abs t + gamma 12 * squared w + gamma 8 * radius * radius
  where
    d = exact (direction r)
    w = exact (origin r) - c

-- | The line meets the sphere where its distance from the centre is at most R: where R^2 |d|^2 - |w x d|^2, a quarter
-- of the discriminant, is at least zero.
--
-- Rounding moves that by at most 2 gamma 4 (sum |w_i d_i|)^2 for B^2, and for A C0 by |d|^2 times gamma 3 + 6 of
-- |w|^2 and gamma 3 + 2 of R^2. A root t at a distance x from the exact one it belongs to, which is the nearer one,
-- has |d|^2 x g \/ 2 <= residual, g being the gap between the two.
sphereVerdict :: Exact -> Rational -> Ray -> Verdict
sphereVerdict c radius r
  | quarter > slack && x1 <= gap / 4 && x2 <= gap / 4 = Sure [Hit t1 x1, Hit t2 x2]
  | quarter < negate slack = Sure []
  | otherwise = Unsure
  where
    d = exact (direction r)
    w = exact (origin r) - c
    a = squared d
    b = inner w d
    quarter = radius * radius * a - squared (outer w d)
    slack = 2 * gamma 5 * inner (magnitudes w) (magnitudes d) ^ (2 :: Int) + a * (gamma 10 * squared w + gamma 6 * radius * radius)
    root = rootBelow quarter
    gap = 2 * root / a
    t1 = (negate b - root) / a
    t2 = (negate b + root) / a
    x1 = uncertainty t1
    x2 = uncertainty t2
    uncertainty t = 2 * sphereResidual c radius r (abs t + gap) / (a * gap)

-- * Cubes

-- | How far from a face's coordinate F the line is at the face's computed parameter, (fl F - o) \/ d: F has one
-- rounding, difference and quotient one each.
faceError :: Rational -> Rational -> Rational
faceError face o = gamma 2 * abs (face - o) + (1 + gamma 2) * eps * abs face

-- | For each axis the two faces and the numbers of the ray.
slabs :: Exact -> Rational -> Ray -> [((Rational, Rational), (Rational, Rational))]
slabs c h r = [((x - h, x + h), (o, d)) | (x, o, d) <- zip3 (components c) (components (exact (origin r))) (components (exact (direction r)))]

-- | The interval of the line that all slabs share, each of whose ends is uncertain by its own face's error.
cubeVerdict :: Exact -> Rational -> Ray -> Verdict
cubeVerdict c h r
  | any outside standing = Sure []
  | enterLow > leaveHigh = Sure []
  | all inside standing && enterHigh <= leaveLow = Sure [interval enterLow enterHigh, interval leaveLow leaveHigh]
  | otherwise = Unsure
  where
    all' = slabs c h r
    standing = [(faces, o) | (faces, (o, d)) <- all', d == 0]
    outside ((low, high), o) = o < low - eps * abs low || o > high + eps * abs high
    inside ((low, high), o) = low + eps * abs low <= o && o <= high - eps * abs high
    crossings = [if d > 0 then (at low, at high) else (at high, at low) | ((low, high), (o, d)) <- all', d /= 0, let at f = ((f - o) / d, faceError f o / abs d)]
    enterLow = maximum [t - e | ((t, e), _) <- crossings]
    enterHigh = maximum [t + e | ((t, e), _) <- crossings]
    leaveLow = minimum [t - e | (_, (t, e)) <- crossings]
    leaveHigh = minimum [t + e | (_, (t, e)) <- crossings]
    interval low high = Hit ((low + high) / 2) ((high - low) / 2)

-- | Where a line enters and leaves a cube, its faces, edges and corners included.
exactSlabs :: Exact -> Rational -> Ray -> Maybe (Rational, Rational)
exactSlabs c h r
  | and [low <= o && o <= high | ((low, high), (o, d)) <- all', d == 0] && enter <= leave = Just (enter, leave)
  | otherwise = Nothing
  where
    all' = slabs c h r
    enter = maximum [((if d > 0 then low else high) - o) / d | ((low, high), (o, d)) <- all', d /= 0]
    leave = minimum [((if d > 0 then high else low) - o) / d | ((low, high), (o, d)) <- all', d /= 0]

-- * Triangles

-- | Parameter and barycentric coordinates of P0, P1, P2, where the line meets the triangle's plane (T. Moeller and B.
-- Trumbore, "Fast, minimum storage ray\/triangle intersection", 1997); and the determinant. 'Nothing' where it does
-- not meet it.
exactTriangle :: Triangle -> Ray -> Maybe (Rational, [Rational], Rational)
exactTriangle triangle r
  | determinant == 0 = Nothing
  | otherwise = Just (t, [1 - u - v, u, v], determinant)
  where
    Corners p0 p1 p2 = trianglePoints triangle
    e1 = exact p1 - exact p0
    e2 = exact p2 - exact p0
    d = exact (direction r)
    s = exact (origin r) - exact p0
    h = outer d e2
    determinant = inner e1 h
    u = inner s h / determinant
    q = outer s e1
    v = inner d q / determinant
    t = inner e2 q / determinant

-- | Which side of an edge the ray passes is certain where the coordinate that vanishes on the edge is not too small.
-- That coordinate, times the determinant, is the triple product of d and the edge's corners a and b, seen from the
-- origin; the edge function is the triple product divided by the largest |d_i|.
--
-- The shadow x - (dx\/dz) z of a corner is computed with at most 4 roundings of |x| + |z|, which is at most m, the
-- sum of the magnitudes of the corner's components; an edge function is the difference of two products of them, with
-- 2 m_a m_b gamma (4 + 4 + 2).
triangleVerdict :: Triangle -> Ray -> Verdict
triangleVerdict triangle r = case exactTriangle triangle r of
  Nothing -> if crosses (triangleFrame triangle) r == Just False then Sure [] else Unsure
  Just (_, coordinates, determinant) -> case catMaybes signs of
    known
      | or known && not (and known) || crosses (triangleFrame triangle) r == Just False -> Sure []
      | length known == 3 && and known -> flatVerdict (triangleFrame triangle) (exact p0) r
      | otherwise -> Unsure
    where
      signs = zipWith sign coordinates [m p1 * m p2, m p2 * m p0, m p0 * m p1]
      sign x mm
        | x > slack mm = Just True
        | x < negate (slack mm) = Just False
        | otherwise = Nothing
      slack mm = gamma 10 * 2 * mm * maximum (magnitudes (exact (direction r))) / abs determinant
  where
    Corners p0 p1 p2 = trianglePoints triangle
    m p = magnitude (exact p - exact (origin r))
