{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Geometry.Lens
-- Description : The lens: a round rim between two spherical faces
--
-- >      biconvex         biconcave         meniscus
-- >
-- >     .-+-----+-.       +-------+        +-----+-.
-- >    (  |     |  )      |)     (|         \     \ `.
-- >    (  P1-S->P2 )      P1) S (P2         P1 -S->P2 )
-- >    (  |     |  )      |)     (|         /     / .'
-- >     `-+-----+-'       +-------+        +-----+-'
-- >
-- >     c1, c2 > 0        c1, c2 < 0       c1 < 0 < c2
--
-- With z along the axis from P1 and r the distance from it, the lens is the body
--
-- > r <= R,  -s1(r) <= z <= L + s2(r),  s_i(r) = sgn(c_i) (sqrt (c_i^2 - r^2) - sqrt (c_i^2 - R^2))
--
-- Seen from a face, along the axis q that points to the side on which the sphere bulges, both kinds of face are the
-- same thing: a dome, the points below its sphere,
--
-- >         q                   dome: <p, q> <= -m, or within the sphere;
-- >      .--^--.                      p measured from P1 or P2, m = sqrt (c^2 - R^2)
-- >     /   |   \
-- >    |----P----|  R           a bulging face keeps its dome (q outwards), a hollow one takes its dome away (q inwards).
-- >    |    |m   |
-- >    |    C    |
--
-- Within the bar r <= R a dome is convex, since R <= |c|. So a line is in it in one interval, and in the lens in what
-- the bar and the kept domes share, less the insides of those taken away: in as many as three intervals, where both
-- faces are hollow. All of them are intervals between the same few numbers, so that there is nothing to slip through at
-- a rim.
module Dioptre.Geometry.Lens
  ( -- * Constructing
    Lens,
    lens,
    lensBody,
    lensCurvatures,

    -- * Along a ray
    LensLine (..),
    Face (..),
    lensLine,
    faceEquation,

    -- * Intersecting
    lensParameters,
    LensPart (..),
    lensPart,
    lensNormal,
    lensContains,
  )
where

import Dioptre.Geometry.Axis (Round, axisLength, roundAxis, roundRadius)
import Dioptre.Geometry.Cap (beyondSphere, capNormal, centreDepth, faceDepth, sphereOver)
import Dioptre.Geometry.Cylinder (bar)
import Dioptre.Geometry.Interval (Interval (..), everywhere, intersection, nowhere)
import Dioptre.Geometry.Quadratic (Quadratic, rootsOf)
import Dioptre.Geometry.Ray (Ray, direction, nextTo, origin, position)
import Dioptre.Geometry.Tube (across, tubeNormal)
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Tolerance (rimOverlap, roundThickness, surfaceThickness)
import Dioptre.Math.Vector (Point, Unit, Vector, dot, modulus, opposite, vector, (*^))
import GHC.Exts (build)

-- | A lens: its rim, and the signed radii of curvature of its faces at P1 and at P2, positive where the face bulges
-- outwards.
data Lens = Lens
  { -- | The axis and the rim.
    lensBody :: Round,
    -- | The radii of curvature at P1 and P2.
    lensCurvatures :: (Double, Double)
  }
  deriving stock (Eq, Show)

-- | 'Nothing' unless both spheres reach the rim and the lens has a thickness on its axis: |c1| >= R, |c2| >= R and
-- L + s1(0) + s2(0) > 0, with s the 'faceDepth'.
--
-- Spec: code.curvature-below-radius, code.lens-too-thin, geometry.lens.possible.
lens :: Round -> (Double, Double) -> Maybe Lens
lens body curvatures@(c1, c2)
  | abs c1 < r || abs c2 < r = Nothing
  | axisLength (roundAxis body) + faceDepth r c1 + faceDepth r c2 > 0 = Just (Lens body curvatures)
  | otherwise = Nothing
  where
    r = roundRadius body

-- | Where a ray's line enters and leaves the lens whose axis starts at P1 in the unit direction S and has the length L,
-- whose rim has the radius R, and whose faces have the signed radii of curvature c1 (at P1) and c2: every entry and
-- exit, ascending; up to three of each.
--
-- Laws: entries and exits take turns; a point strictly between an entry and its exit is inside, and a point outside
-- them all is not.
--
-- Spec: geometry.lens.body, geometry.lens.rim.
lensParameters :: Point -> Unit -> Double -> Double -> Double -> Double -> Ray -> [Double]
lensParameters p1 s l radius c1 c2 r = build $ \cons nil ->
  foldr (\(Interval enter leave) rest -> cons enter (cons leave rest)) nil (intervals (parts p1 s l radius c1 c2 r))
{-# INLINE lensParameters #-}

-- | The parameter t0 of the line's point nearest to the middle of the axis and, counted from there, where the line is
-- in the bar and in the domes of the two faces. A face bulges where the flag is true.
data Parts = Parts !Double !Interval !Bool !Interval !Bool !Interval

parts :: Point -> Unit -> Double -> Double -> Double -> Double -> Ray -> Parts
parts p1 s l radius c1 c2 r = Parts t0 inBar (c1 > 0) (dome radius start d inBar) (c2 > 0) (dome radius end d inBar)
  where
    d = direction r
    LensLine t0 w start end = lensLine p1 s l radius c1 c2 r
    inBar = bar radius (across s w) (across s d)
{-# NOINLINE parts #-}

-- | A ray's line, from its point nearest to the middle of the axis on: that point's parameter, t0; the point itself, w,
-- measured from the middle; and the line as the faces at P1 and at P2 see it.
data LensLine = LensLine Double Vector Face Face

-- | A face, and the line w + t d as it sees it. (What uses it for the rule is in line, so that none is made.)
data Face = Face
  { -- | The axis q, to the side on which the sphere bulges.
    faceAxis :: Vector,
    -- | How far the sphere's centre is behind the rim's plane: m, not negative.
    faceCentre :: Double,
    -- | The point w, measured from the middle of the face's rim: p.
    faceStart :: Vector,
    -- | The parameter of the line's point nearest to that middle, t1, for a lens much longer than wide.
    faceShift :: Double,
    -- | That point, p + t1 d.
    facePoint :: Vector
  }

-- | The ray's line, seen from the lens.
lensLine :: Point -> Unit -> Double -> Double -> Double -> Double -> Ray -> LensLine
lensLine p1 s l radius c1 c2 r = LensLine t0 w (face c1 (opposite s) 1) (face c2 s (-1))
  where
    d = direction r
    halfAxis = (l / 2) *^ vector s
    (t0, w) = nextTo ((origin r - p1) - halfAxis) d
    face c outward side = Face (signum c *^ vector outward) (abs (centreDepth radius c)) p t1 near
      where
        p = w + (side :: Double) *^ halfAxis
        (t1, near) = nextTo p d
    {-# INLINE face #-}
{-# INLINE lensLine #-}

-- | The equation of a face's sphere, for a lens of that radius and the line's direction, counted from t1 on.
faceEquation :: Double -> Face -> Vector -> Quadratic
faceEquation radius face = sphereOver (faceAxis face) radius (faceCentre face) (facePoint face)
{-# INLINE faceEquation #-}

-- | Where a line that is in the bar in a given interval is in the dome as well; an end of the interval that is in the
-- dome, and is thus no end that the dome makes, becomes infinite. See Note [Domes].
dome :: Double -> Face -> Vector -> Interval -> Interval
dome radius face d (Interval enter leave) = case rootsOf (faceEquation radius face d) of
  [x, y] -> Interval (if below enter then negate infinity else faceShift face + x) (if below leave then infinity else faceShift face + y)
  _ -> Interval low high
  where
    below t = low <= t && t <= high
    !(Interval low high) = under (negate (faceCentre face)) (dot (faceStart face) (faceAxis face)) (dot d (faceAxis face))
{-# INLINE dome #-}

-- | Where the height h0 + t dh is at most that high.
under :: Double -> Double -> Double -> Interval
under high h0 dh
  | dh > 0 = Interval (negate infinity) ((high - h0) / dh)
  | dh < 0 = Interval ((high - h0) / dh) infinity
  | h0 <= high = everywhere
  | otherwise = nowhere

-- | The intervals in which a line is in the lens, ascending, in the parameters of the ray.
intervals :: Parts -> [Interval]
intervals (Parts t0 inBar bulges1 dome1 bulges2 dome2) =
  [ Interval (t0 + enter) (t0 + leave)
    | Interval enter leave <- foldr lessInside (touching t0 kept) hollows,
      abs (t0 + enter) < infinity,
      abs (t0 + leave) < infinity
  ]
  where
    kept = intersection inBar (intersection (if bulges1 then dome1 else everywhere) (if bulges2 then dome2 else everywhere))
    hollows = [dome1 | not bulges1] ++ [dome2 | not bulges2]

-- | An interval as a list of none or one. One whose ends passed each other by no more than the 'rimOverlap' of the
-- numbers involved touches a rim, and counts, as one point.
touching :: Double -> Interval -> [Interval]
touching t0 (Interval enter leave)
  | enter <= leave = [Interval enter leave]
  | enter - leave <= rimOverlap * (abs t0 + abs enter + abs leave) && enter < infinity && leave > negate infinity = [Interval rim rim]
  | otherwise = []
  where
    -- The same one for the ray the other way.
    rim = if abs enter <= abs leave then enter else leave

-- | What is left of intervals when the inside of one is taken away: its ends stay.
lessInside :: Interval -> [Interval] -> [Interval]
lessInside (Interval low high) = concatMap left
  where
    left (Interval enter leave)
      | low < high && low < leave && enter < high = [Interval enter low | enter <= low] ++ [Interval high leave | high <= leave]
      | otherwise = [Interval enter leave]

-- | The parts of a lens's surface.
data LensPart
  = -- | The side, a tube.
    LensSide
  | -- | The face at the start of the axis.
    LensStart
  | -- | The face at its end.
    LensEnd
  deriving stock (Eq, Show)

-- | The part that a ray meets at a parameter that 'lensParameters' gave. A rim is the side's.
--
-- Spec: geometry.lens.rim.
lensPart :: Point -> Unit -> Double -> Double -> Double -> Double -> Ray -> Double -> LensPart
lensPart p1 s l radius c1 c2 r t
  | isEndOf inBar = LensSide
  | isEndOf dome1 = LensStart
  | otherwise = LensEnd
  where
    Parts t0 inBar _ dome1 _ _ = parts p1 s l radius c1 c2 r
    isEndOf (Interval enter leave) = t == t0 + enter || t == t0 + leave

-- | The outward unit normal where a ray meets the lens, at a parameter that 'lensParameters' gave: the tube's on the
-- side, and on a face away from the sphere's centre if it bulges, towards it if it is hollow.
--
-- Spec: geometry.hit.centre, geometry.lens.normal.
lensNormal :: Point -> Unit -> Double -> Double -> Double -> Double -> Ray -> Double -> Unit
lensNormal p1 s l radius c1 c2 r t = case lensPart p1 s l radius c1 c2 r t of
  LensSide -> tubeNormal p1 s v
  LensStart -> capNormal p1 (opposite s) radius c1 v
  LensEnd -> capNormal (p1 + l *^ vector s) s radius c2 v
  where
    v = position r t

-- | Whether a point is inside the lens: nearer to the axis than (1 - 'roundThickness') R and, at each face, on the
-- body's side of the sphere by more than 'surfaceThickness' of its radius. A point on the surface is not.
--
-- Spec: geometry.lens.contains.
lensContains :: Point -> Unit -> Double -> Double -> Double -> Double -> Point -> Bool
lensContains p1 s l radius c1 c2 v =
  modulus (across s w) < (1 - roundThickness) * radius && behind c1 (negate (vector s)) w && behind c2 (vector s) (w - l *^ vector s)
  where
    w = v - p1
    -- With k the thickness, |v - C| < (1 - k) |c| where |v - C|^2 - c^2 < -k (2 - k) c^2.
    behind c outward p
      | c > 0 = deep <= 0 || beyond < negate (k * (2 - k) * (c * c))
      | otherwise = deep <= 0 && beyond > k * (2 + k) * (c * c)
      where
        m = centreDepth radius c
        beyond = beyondSphere outward radius m p
        deep = dot p outward + m
        k = surfaceThickness

-- Note [Domes]
-- ~~~~~~~~~~~~
-- On a line, the dome is a half-line, <p + t d, q> <= -m, together with the interval between the roots of the sphere.
-- In the bar it is convex. So where both ends of the bar's interval are on the half-line, all of it is in the dome.
-- Where only one is, the plane <p, q> = -m is crossed within the bar, at a distance from the centre C of at most
-- R <= |c|, which is in the sphere: the dome lasts from that end to the far root. Where neither is, it is the interval
-- between the roots. If there are no roots, the line is in no sphere, and is on the half-line or not.
--
-- What the roots are on the other half of the sphere, below C, is therefore never asked: they may lie in the bar, as at
-- the narrow end of a ball between two flat faces, and are no part of the surface.
--
-- The side is known to be hit where the bar's interval ends, and a face where its dome's interval does: an end that is
-- not the dome's own is infinite. 'lensPart' finds the part that has the parameter by comparing for equality, and the
-- numbers are the same.
