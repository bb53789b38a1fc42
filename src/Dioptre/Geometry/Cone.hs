{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Dioptre.Geometry.Cone
-- Description : The cone: a disk and the point above it
--
-- >         |\_
-- >         |  \_             w = v - P2 = w_perp + a S,   k = R / H
-- >     R   |    \_
-- >        P1-> S--P2         |w_perp| <= -k a,   -H <= a <= 0
-- >         |    _/
-- >         |  _/
-- >         |_/
-- >       a = -H   0
--
-- Measured from the apex P2, with a the height on the axis (negative towards the base), the cone's curved surface is
-- part of the double cone |w_perp|^2 = k^2 a^2, on whose points the ray w + t d has
--
-- > A = <d_perp, d_perp> - (k da)^2,  B = 2 (<w_perp, d_perp> - (k da) (k a)),  C = <w_perp, w_perp> - (k a)^2
--
-- The line is in the double cone where A t^2 + B t + C <= 0:
--
-- >     A > 0            A = 0              A < 0
-- >
-- >    \     /           \    /            \  |  /         a line that crosses the axis steeply (A > 0) is in one of the two
-- >     \   /             \  / .            \ x /          cones, between its roots; one parallel to the surface (A = 0) from its
-- >   ---x-x---            \/.               \|/           only root on; and one that runs along the axis (A < 0) is in both, up to
-- >       V               . \/\              /x\           the first root and from the second one on, and only one of these
-- >      / \                /  \            / | \          halves is before the apex: the first where da > 0.
--
-- What the line shares with the slab -H <= a <= 0 is then the one interval in which it is in the cone. Note [Near the
-- apex] says why the ray is first moved next to the apex, and Note [Flat cones] why a cone that is much wider than high
-- has equations of its own.
module Dioptre.Geometry.Cone
  ( -- * Intersecting
    coneParameters,
    coneNormal,
    coneContains,
    isFlatCone,

    -- * Along a ray
    ConeLine (..),
    coneLine,

    -- * The unbounded double cone
    conesParameters,
  )
where

import Data.Maybe (fromMaybe)
import Dioptre.Geometry.Interval (Interval (..), everywhere, intersection, nowhere, slab)
import Dioptre.Geometry.Quadratic (Quadratic (..), rootsOf)
import Dioptre.Geometry.Ray (Ray, direction, nextTo, origin, position)
import Dioptre.Geometry.Tube (across)
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Roots (quadraticRoots)
import Dioptre.Math.Tolerance (endThickness, roundThickness)
import Dioptre.Math.Vector (Point, Unit, cross, dot, modulus, opposite, unit, vector, (*^))
import GHC.Exts (build)

-- $setup
-- >>> import Dioptre.Geometry.Ray (ray)
-- >>> import Linear.V3 (V3 (..))

-- | Where a ray's line meets the cone with a base of radius R around P1 and its apex at P1 + H S: where it enters and
-- where it leaves, or nothing.
--
-- Laws: a point strictly between the two is inside, and a point outside them is not; the cone beyond the apex is not
-- there; a ray through the apex that is less inclined to the axis than the surface is meets it.
--
-- Spec: geometry.cone.interval, geometry.cone.beyond-apex, geometry.cone.apex.
coneParameters :: Point -> Unit -> Double -> Double -> Ray -> [Double]
coneParameters p1 s h radius r = build $ \cons nil ->
  let !(Crossing t0 u curved ends) = crossing p1 s h radius r
      !(Interval first final) = intersection curved ends
      !enter = t0 + u * first
      !leave = t0 + u * final
      !inside = leave - enter
   in if first <= final && inside < infinity then cons enter (cons leave nil) else nil
{-# INLINE coneParameters #-}

-- | The parameter t0 of a point of the line next to the apex and a unit u; and, for s in the parameter t0 + u s, where
-- the line is in the cone before the apex and where it is between the base and the apex.
data Crossing = Crossing !Double !Double !Interval !Interval

crossing :: Point -> Unit -> Double -> Double -> Ray -> Crossing
crossing p1 s h radius r = case coneLine p1 s h radius r of
  FromNearest t0 equation a da -> Crossing t0 1 (half equation da) (slab (negate h) 0 a da)
  FromApexPlane t0 q equation da -> Crossing t0 q (half equation da) (slab (negate radius) 0 0 da)
{-# NOINLINE crossing #-}

-- | A ray's line, with the equation of the double cone along it.
data ConeLine
  = -- | From its point nearest to the apex on: that point's parameter, t0; the equation; and the line's height above the
    -- apex, a, and what it gains with t, da.
    FromNearest Double Quadratic Double Double
  | -- | Of a flat cone, and a line steep for it, from the plane of the apex on: the parameter there, t0; the unit q = H \/ R
    -- that is counted in; the equation in it; and da. See Note [Flat cones].
    FromApexPlane Double Double Quadratic Double

-- | The ray's line and the cone's equation.
coneLine :: Point -> Unit -> Double -> Double -> Ray -> ConeLine
coneLine p1 s h radius r
  | isFlatCone h radius && isSteep h radius (dot d d) da =
    let q = h / radius
        t1 = negate (dot far (vector s) / da)
        vPerp = across s (far + t1 *^ d)
        qd = q *^ dPerp
     in FromApexPlane t1 q (Quadratic (dot qd qd - da * da) (2 * dot vPerp qd) (dot vPerp vPerp)) da
  | otherwise = FromNearest t0 (Quadratic (dot dPerp dPerp - kda * kda) (2 * (dot wPerp dPerp - kda * ka)) (dot wPerp wPerp - ka * ka)) a da
  where
    d = direction r
    far = (origin r - p1) - h *^ vector s
    (t0, w) = nextTo far d
    -- Split it along and across the axis.
    a = dot w (vector s)
    da = dot d (vector s)
    wPerp = across s w
    dPerp = across s d
    ka = radius / h * a
    kda = radius / h * da
{-# INLINE coneLine #-}

-- | Whether a cone of that height and radius is flat: R > 32 H.
isFlatCone :: Double -> Double -> Bool
isFlatCone h radius = radius > 32 * h
{-# INLINE isFlatCone #-}

-- | Whether a line is steep for such a cone: |k da| > 2 |d|, so that it goes through the cone from its base to the
-- other side. Given \<d, d> and da.
isSteep :: Double -> Double -> Double -> Double -> Bool
isSteep h radius dd da = abs da * radius > 2 * h * sqrt dd
{-# INLINE isSteep #-}

-- | Where A t^2 + B t + C <= 0, in that half of it which is before the apex if A < 0. See Note [Halves].
--
-- Spec: geometry.cone.beyond-apex.
half :: Quadratic -> Double -> Interval
half equation@(Quadratic a b c) da = case rootsOf equation of
  [x, y]
    | a > 0 -> Interval x y
    | da > 0 -> Interval (negate infinity) x
    | otherwise -> Interval y infinity
  [x]
    | b < 0 -> Interval x infinity
    | otherwise -> Interval (negate infinity) x
  _
    | a < 0 || (a == 0 && b == 0 && c <= 0) -> everywhere
    | otherwise -> nowhere
{-# INLINE half #-}

-- | The outward unit normal where a ray meets the cone, at a parameter that 'coneParameters' gave: -S on the base; on
-- the curved part e + k S made unit, with e the unit vector away from the axis; S at the apex. On the rim it is the
-- curved part's.
--
-- The gradient of |w_perp|^2 - k^2 a^2 is 2 (w_perp - k^2 a S), and w_perp = -k a e on the cone.
--
-- Spec: geometry.cone.apex, geometry.cone.normal.
coneNormal :: Point -> Unit -> Double -> Double -> Ray -> Double -> Unit
coneNormal p1 s h radius r t
  | t == at base && t /= at x && t /= at y = opposite s
  | otherwise = coneSideNormal p1 s h radius (position r t)
  where
    Crossing t0 u (Interval x y) (Interval near away) = crossing p1 s h radius r
    at along = t0 + u * along
    base = if dot (direction r) (vector s) > 0 then near else away

coneSideNormal :: Point -> Unit -> Double -> Double -> Point -> Unit
coneSideNormal p1 s h radius v = maybe s slanted (unit (across s (v - p1)))
  where
    slanted e = fromMaybe s (unit (vector e + (radius / h) *^ vector s))

-- | Whether a point is inside the cone: farther than 'endThickness' from the planes of the base and of the apex, and
-- nearer to the axis than (1 - 'roundThickness') (1 - h\/H) R at its height h. A point on the surface is not.
--
-- Spec: geometry.cone.contains.
coneContains :: Point -> Unit -> Double -> Double -> Point -> Bool
coneContains p1 s h radius v =
  height > endThickness
    && h - height > endThickness
    && modulus (across s w) < (1 - roundThickness) * abs ((1 - height / h) * radius)
  where
    w = v - p1
    height = dot w (vector s)

-- | Where a ray's line meets the unbounded double cone that has its apex at a point and passes at a radius around
-- another, on both sides of the apex: every real parameter, ascending. None if the two points are equal.
--
-- > A t^2 + B t + C = 0,  with g = apex - point, w = o - apex:
-- > A = <g,g> <d x g, d x g> - (R <d,g>) (R <d,g>)
-- > B = 2 (<g,g> <w x g, d x g> - (R <w,g>) (R <d,g>))
-- > C = <g,g> <w x g, w x g> - (R <w,g>) (R <w,g>)
--
-- It is the equation above times \<g,g>^2, and R is multiplied in first, as written. Nothing is divided and no root is
-- taken, so that the coefficients, and with them the number of roots, are exact for coordinates of few digits: a ray
-- through the apex meets it twice at one parameter. The vector g and R are first divided by a power of two that brings
-- g near 1, which changes no root.
--
-- >>> conesParameters (V3 0 0 0) (V3 0 0 1) 1 (ray (V3 (-2) 0 0) (V3 1 0 0))
-- [1.0,3.0]
--
-- Spec: geometry.cones.parameters, geometry.cones.parallel.
conesParameters :: Point -> Point -> Double -> Ray -> [Double]
conesParameters point apex radius r =
  quadraticRoots
    (gg * dot dg dg - (radial * d) * (radial * d))
    (2 * (gg * dot wg dg - (radial * w) * (radial * d)))
    (gg * dot wg wg - (radial * w) * (radial * w))
  where
    away = apex - point
    scale = negate (exponent (modulus away))
    g = fmap (scaleFloat scale) away
    radial = scaleFloat scale radius
    gg = dot g g
    fromApex = origin r - apex
    w = dot fromApex g
    d = dot (direction r) g
    wg = cross fromApex g
    dg = cross (direction r) g

-- Note [Near the apex]
-- ~~~~~~~~~~~~~~~~~~~~
-- C is a difference of squares of the size of |w|^2, so it carries an error of some 2^-52 |w|^2. Where the apex is
-- crossed, the two roots are nearly equal, and an error of 2^-52 |w|^2 under the square root moves them by 2^-26 |w|:
-- from a distance of a thousand units an apex would be frayed by a hundred thousandth of a unit, and a ray aimed at it
-- might not find it. With the ray moved by t0 = -<w, d> / <d, d> to its point nearest to the apex, w carries the
-- rounding of a position, 2^-52 of the distance, and |w| is no more than the line's distance from the apex: all errors
-- that follow are relative to that. The parameters are t0 plus the roots, in the order of the roots, since rounding a
-- sum does not reverse an order.

-- Note [Flat cones]
-- ~~~~~~~~~~~~~~~~~
-- Let rho be the distance from the axis at which a line passes the plane of the apex, and k = R / H large. The line
-- goes through the thin body at about rho from the axis, whatever its inclination, unless that is below 1 / k or so.
-- Its two roots are 2 rho / k |da| apart, and their difference is the root of
--
-- > (B^2 - 4 A C) / 4 = |k (a d_perp - da w_perp)|^2 - |w_perp x d_perp|^2
--
-- whose first part is (k da rho)^2. But B^2 / 4 and A C are as large as (k da)^2 (k a)^2, with a the height of the
-- point nearest to the apex, which for an inclined line is no less than a part of rho. Their rounding, 2^-53 of that,
-- is the part 2^-53 k^2 of their difference: the line is taken for one at rho (1 +- 2^-54 k^2). For k = 2^20 that is
-- the rim off by 2^-14, more than a box is larger than its shape; from k = 2^26 on the sign of the discriminant is
-- noise, and a line is met wherever the slab is, or nowhere.
--
-- So where the cone is flat, R > 32 H, and the line steep, |k da| > 2 |d|, it is moved to the plane of the apex
-- instead:
--
-- > a = 0,  t0 = -<far, S> / da,  w = far + t0 d = w_perp
--
-- With q = H / R, t = t0 + q u and D = q d_perp, it is at the height a = q u da, where k a = u da, so that
--
-- > |w_perp + u D|^2 <= (u da)^2      A = <D, D> - da^2,  B = 2 <w_perp, D>,  C = <w_perp, w_perp>
-- > -H <= a <= 0                      -R <= u da <= 0
--
-- Since |D| <= q |d| < |da| / 2, A is between -da^2 and -3/4 da^2, and C is not negative: the discriminant is a sum,
-- B^2 + 4 |A| C, and nothing cancels. One root is at most 0 and the other at least 0; the one with u da <= 0 is before
-- the apex, and is what 'half' takes: the first for da > 0, where the line is in the cone up to it, and the second
-- otherwise. As H vanishes, D does, the roots become +-rho / |da|, and the line is met where rho <= R: a disk.
--
-- At both limits the two ways agree to their rounding: for k = 32, 2^-54 k^2 is 2^-44; and for |k da| = 2 |d|,
-- q |d| / |da| = 1/2, the numbers of both are of one size. The point moved to is as far from the apex as the
-- line's height there is known, 2^-52 of the distance |far|, times |d| / |da|, which is less than k / 2. The
-- parameters of a cone that is not flat, or of a line that is not steep, are as they always were, bit for bit.

-- Note [Halves]
-- ~~~~~~~~~~~~~
-- A < 0: B^2 - 4 A C is never negative (a line with that direction must come out of one cone and go into the other, or
-- pass through the apex), but rounding may make it so next to the apex. There are no roots then, the line passes
-- through the apex to rounding, and the slab alone decides: everywhere.
--
-- A = 0: the line is in the cone from its root on where B < 0, and up to it otherwise. The cone that it is in is before
-- the apex where B and da are of one sign, and where it is not, it shares no more than a rounding with the slab. With B
-- = 0, too, the line is the apex's tangent: in the surface, or outside.
--
-- A root that is missing because it is too large for a double leaves [x], and the sign of B tells on which side of x it
-- is missing, the same as for A = 0.
