{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TupleSections #-}

-- |
-- Module      : Dioptre.Explain.Polynomial
-- Description : The equation that a ray and a shape make
--
-- >  plane, disk, annulus, triangle    A t + B = 0                   then: within the radius? within the edges?
-- >  sphere, tube, spherical cap       A t^2 + B t + C = 0           then: between the ends? on the right side of the disk?
-- >  torus                             A s^4 + B s^3 + ... = 0
-- >  cube                              three slabs,  low <= B + A t <= high
-- >  cylinder, cone                    one of the second degree, and the slab between the ends
-- >  lens                              three of the second degree: the rim's tube and the two faces' spheres
--
-- Each with the coefficients that the shape's module computes, by the same formulas in the same order of operations, so that every parameter at which the renderer meets the shape
-- is among the roots told here, to the bit (a law).
module Dioptre.Explain.Polynomial
  ( equationOf,
    Candidate (..),
  )
where

import Data.List (foldl')
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import Dioptre.Explain.Phrase (real, vec)
import Dioptre.Explain.Story
import Dioptre.Geometry.Cap (beyondSphere, centreDepth, sphereOver)
import Dioptre.Geometry.Cube (cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (annulusInner, annulusOuter, annulusPlane, diskPlane, diskRadius)
import Dioptre.Geometry.Placement (Placement, carriedBack, placement)
import Dioptre.Geometry.Plane (planeNormal, planeParameters, planePosition)
import Dioptre.Geometry.Ray (Ray, direction, directionQuadrance, origin, position)
import Dioptre.Geometry.Round
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (torusParameters)
import Dioptre.Geometry.Triangle (Corners (..), barycentric, smoothTriangleFlat, triangleNormal, trianglePoints)
import Dioptre.Geometry.Tube (across, tubeLineParameters)
import Dioptre.Math.Quartic (quarticRoots)
import Dioptre.Math.Roots (quadraticRoots)
import Dioptre.Math.Vector (Point, Unit, Vector, alongZ, distance, dot, modulus, quadrance, unit, vector, (*^), (^/))
import Linear.V3 (V3 (..))

-- | A parameter that fulfils a condition, the condition's place among the shape's from 0, and what is measured at the point there.
data Candidate = Candidate Double Int Measure

-- | The conditions for a ray to meet a shape inside of some frames, the outermost first; and every root of every condition, in the order of the conditions.
equationOf :: [Placement] -> Shape -> Ray -> (Equation, [Candidate])
equationOf frames shape r = case inner (foldl' (flip carriedBack) r frames) shape of
  (r', plain) -> let (moved, conditions, candidates) = conditionsOf plain r' in (Equation (if r' == r then Nothing else Just r') moved conditions, candidates)
  where
    inner r' (ATransformed t s) = inner (carriedBack (placement t) r') s
    inner r' s = (r', s)

type Conditions = (Maybe (Double, Double), [Condition], [Candidate])

conditionsOf :: Shape -> Ray -> Conditions
conditionsOf shape r = case shape of
  APlane p -> flat (planePosition p) (normalOf p) (const OtherConditions)
  ADisk flatDisk ->
    let centre = planePosition (diskPlane flatDisk)
     in flat centre (normalOf (diskPlane flatDisk)) (\v -> AwayFromCentre (distance centre v) (diskRadius flatDisk))
  AnAnnulus a ->
    let centre = planePosition (annulusPlane a)
        ring v
          | away < annulusInner a = InTheHole away (annulusInner a)
          | away <= annulusOuter a = OnTheRing away (annulusInner a) (annulusOuter a)
          | otherwise = AwayFromCentre away (annulusOuter a)
          where
            away = distance centre v
     in flat centre (normalOf (annulusPlane a)) ring
  ATriangle t -> ofTriangle t
  ASmoothTriangle s -> ofTriangle (smoothTriangleFlat s)
  ASphere s -> still (round' (sphereCentre s) (sphereRadius s))
  ACube c -> still (slabs (cubeCentre c) (cubeSize c / 2))
  ATube body -> onAxis body $ \p1 s h radius -> still [(tubeCondition 0 p1 s radius, [(t, AtHeight (dot (position r t - p1) (vector s)) h) | t <- tubeLineParameters p1 s radius r])]
  ACylinder body -> onAxis body $ \p1 s h radius ->
    still
      [ (tubeCondition 0 p1 s radius, offBody (tubeLineParameters p1 s radius r)),
        within TheEnds "<d, S>" (dot d (vector s)) "<o - P1, S>" (dot (origin r - p1) (vector s)) 0 h
      ]
  ACone body -> onAxis body coneConditions
  ALens l -> let (c1, c2) = lensCurvatures l in onAxis (lensBody l) (lensConditions c1 c2)
  ACap c -> capConditions (planePosition (diskPlane (capDisk c))) (normalOf (diskPlane (capDisk c))) (diskRadius (capDisk c)) (capCurvature c)
  ATorus t -> torusConditions (planePosition (torusPlane t)) (normalOf (torusPlane t)) (torusMajor t) (torusMinor t)
  ATransformed _ s -> conditionsOf s r
  where
    d = direction r
    normalOf p = fromMaybe alongZ (unit (planeNormal p))
    ofTriangle t =
      let Corners p0 p1 p2 = trianglePoints t
       in flat p0 (triangleNormal t) (uncurry Barycentric . barycentric p0 p1 p2)
    offBody = map (,OtherConditions)

    -- Conditions in t itself, each with its roots.
    still conditions = (Nothing, map fst conditions, numbered (map snd conditions))
    numbered lists = [Candidate t i c | (i, list) <- zip [0 ..] lists, (t, c) <- list]

    flat :: Point -> Unit -> (Point -> Measure) -> Conditions
    flat p n measure =
      still
        [ ( PolynomialIsZero
              ThePlane
              [Coefficient "A" "<n, d>" (dot (vector n) d), Coefficient "B" "<n, o - P>" (dot (vector n) (origin r - p))]
              ["n = " <> vec (vector n), "P = " <> vec p]
              Nothing
              0,
            [(t, measure (position r t)) | t <- planeParameters p n r]
          )
        ]

    round' c radius =
      let w = origin r - c
          (qa, qb, qc) = (directionQuadrance r, 2 * dot w d, dot w w - radius * radius)
          roots = quadraticRoots qa qb qc
       in [(quadratic TheSphere ("<d, d>", qa) ("2 <w, d>", qb) ("<w, w> - R^2", qc) ["w = o - C", "C = " <> vec c, "R = " <> real radius] roots 0, offBody roots)]

    slabs (V3 cx cy cz) h =
      let V3 ox oy oz = origin r
          V3 dx dy dz = d
          slab name c o v = within (TheFaces name) ("d_" <> name) v ("o_" <> name) o (c - h) (c + h)
       in [slab "x" cx ox dx, slab "y" cy oy dy, slab "z" cz oz dz]

    onAxis :: Round -> (Point -> Unit -> Double -> Double -> a) -> a
    onAxis body rule = rule p1 (fromMaybe alongZ (unit (p2 - p1))) (distance p1 p2) (roundRadius body)
      where
        p1 = axisStart (roundAxis body)
        p2 = axisEnd (roundAxis body)

    -- The tube around an axis through a point, for the ray moved by so much.
    tubeCondition :: Double -> Point -> Unit -> Double -> Condition
    tubeCondition t0 p1 s radius = tubeOf (if t0 == 0 then "w = o - P1" else "w = o + t0 d - M") (if t0 == 0 then "P1" else "M") p1 s radius (across s (origin r - p1)) (across s d)

    coneConditions p1 s h radius =
      (Just (t0, 1), [side, fst ends], numbered [offBody [t0 + x | x <- roots], [(t0 + x, c) | (x, c) <- snd ends]])
      where
        far = (origin r - p1) - h *^ vector s
        t0 = negate (dot far d / dot d d)
        w = far + t0 *^ d
        a = dot w (vector s)
        da = dot d (vector s)
        wPerp = across s w
        dPerp = across s d
        k = radius / h
        ka = radius / h * a
        kda = radius / h * da
        (qa, qb, qc) = (dot dPerp dPerp - kda * kda, 2 * (dot wPerp dPerp - kda * ka), dot wPerp wPerp - ka * ka)
        roots = quadraticRoots qa qb qc
        side =
          quadratic
            TheDoubleCone
            ("<d', d'> - (k b)^2", qa)
            ("2 (<w', d'> - k^2 a b)", qb)
            ("<w', w'> - (k a)^2", qc)
            ["w = o + t0 d - P2", "a = <w, S>", "b = <d, S>", "w' = w - a S", "d' = d - b S", "k = R / H = " <> real k, "S = " <> vec (vector s), "P2 = " <> vec (p1 + h *^ vector s)]
            roots
            0
        ends = within TheEnds "<d, S>" da "<w, S>" a (negate h) 0

    lensConditions c1 c2 p1 s l radius = (Just (t0, 1), [side, startFace, endFace], numbered [offBody [t0 + x | x <- sideRoots], offBody [t0 + (t1 + x) | x <- startRoots], offBody [t0 + (t2 + x) | x <- endRoots]])
      where
        halfAxis = (l / 2) *^ vector s
        far = (origin r - p1) - halfAxis
        t0 = negate (dot far d / dot d d)
        w = far + t0 *^ d
        (wPerp, dPerp) = (across s w, across s d)
        sideRoots = quadraticRoots (dot dPerp dPerp) (2 * dot wPerp dPerp) (dot wPerp wPerp - radius * radius)
        side = tubeOf "w = o + t0 d - M" "M" (p1 + halfAxis) s radius wPerp dPerp
        (startFace, t1, startRoots) = face TheStartFace c1 (negate (vector s)) (w + 1 *^ halfAxis)
        (endFace, t2, endRoots) = face TheEndFace c2 (vector s) (w + (-1) *^ halfAxis)
        face patch c outward p = (overDisk patch q radius m (p + shift *^ d) roots shift, shift, roots)
          where
            q = signum c *^ outward
            m = abs (centreDepth radius c)
            shift = negate (dot p d / dot d d)
            roots = sphereOver q radius m (p + shift *^ d) d

    capConditions centre n radius c = (Just (t0, 1), [overDisk TheSphere (vector n) radius m p roots 0], [Candidate (t0 + x) 0 SideOfDisk | abs t0 < 1 / 0, x <- roots])
      where
        m = centreDepth radius c
        far = origin r - centre
        t0 = negate (dot far d / dot d d)
        p = far + t0 *^ d
        roots = sphereOver (vector n) radius m p d

    -- The sphere over a disk, for a point p measured from the disk's centre.
    overDisk :: Patch -> Vector -> Double -> Double -> Vector -> [Double] -> Double -> Condition
    overDisk patch n radius m p =
      quadratic
        patch
        ("<d, d>", dot d d)
        ("2 (<p, d> + m <d, n>)", 2 * (dot p d + m * dot d n))
        ("<p, p> + 2 m <p, n> - R^2", beyondSphere n radius m p)
        ["p = " <> vec p, "m = " <> real m, "n = " <> vec n, "R = " <> real radius]

    torusConditions p n major minor
      | c > outer * outer && null (torusParameters p n major minor r) = (Nothing, [PassesNear (sqrt c * l) (major + minor)], [])
      | otherwise = (Just (t0, scale), [ring], [Candidate ((t0 + s) * scale) 0 OtherConditions | s <- roots])
      where
        l = scaleFloat (exponent (major + minor) - 1) 1
        u = d ^/ modulus d
        w = (origin r - p) ^/ l
        outer = (major + minor) / l
        t0 = negate (dot w u)
        q = w + t0 *^ u
        c = quadrance q
        scale = l / modulus d
        (bigR, smallR) = (major / l, minor / l)
        (nq, nu) = (dot (vector n) q, dot (vector n) u)
        g = c + (bigR - smallR) * (bigR + smallR)
        four = 4 * (bigR * bigR)
        (q2, q1, q0) = (2 * g - four * ((1 - nu) * (1 + nu)), 2 * four * nu * nq, g * g - four * (c - nq * nq))
        roots = quarticRoots 1 0 q2 q1 q0
        ring =
          PolynomialIsZero
            TheTorus
            [ Coefficient "A" "1" 1,
              Coefficient "B" "0" 0,
              Coefficient "C" "2 G - 4 R^2 (1 - M^2)" q2,
              Coefficient "D" "8 R^2 M N" q1,
              Coefficient "E" "G^2 - 4 R^2 (<q, q> - N^2)" q0
            ]
            [ "u = d / |d|",
              "q = (o - P) / L + t0 u",
              "N = <n, q>",
              "M = <n, u>",
              "G = <q, q> + R^2 - r^2",
              "L = " <> real l,
              "R = " <> real bigR,
              "r = " <> real smallR,
              "n = " <> vec (vector n),
              "P = " <> vec p
            ]
            Nothing
            0

-- | The infinite tube around an axis, for what the ray's origin and direction have across it.
tubeOf :: Text -> Text -> Point -> Unit -> Double -> Vector -> Vector -> Condition
tubeOf letter name p s radius wPerp dPerp =
  quadratic
    TheTube
    ("<d', d'>", qa)
    ("2 <w', d'>", qb)
    ("<w', w'> - R^2", qc)
    [letter, "w' = w - <w, S> S", "d' = d - <d, S> S", name <> " = " <> vec p, "S = " <> vec (vector s), "R = " <> real radius]
    (quadraticRoots qa qb qc)
    0
  where
    (qa, qb, qc) = (dot dPerp dPerp, 2 * dot wPerp dPerp, dot wPerp wPerp - radius * radius)

-- | A condition of the second degree. Its discriminant is told where its sign is that of the number of roots, which it is but for rounding.
quadratic :: Patch -> (Text, Double) -> (Text, Double) -> (Text, Double) -> [Text] -> [Double] -> Double -> Condition
quadratic patch (fa, a) (fb, b) (fc, c) letters roots = PolynomialIsZero patch [Coefficient "A" fa a, Coefficient "B" fb b, Coefficient "C" fc c] letters certain
  where
    discriminant = b * b - 4 * a * c
    agrees = case roots of
      [x, y] -> if x == y then discriminant == 0 else discriminant > 0
      [] -> discriminant < 0
      _ -> False
    certain = if agrees then Just discriminant else Nothing

-- | A slab: where B + A t is from low to high, and the parameters of its two faces.
within :: Patch -> Text -> Double -> Text -> Double -> Double -> Double -> (Condition, [(Double, Measure)])
within patch fa a fb b low high = (LiesBetween patch (Coefficient "A" fa a) (Coefficient "B" fb b) low high, [(x, OtherConditions) | a /= 0, x <- [(low - b) / a, (high - b) / a]])
