{-# LANGUAGE OverloadedStrings #-}

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
-- Where it is more than a dot product or two, the shape's own module makes the equation, for the rule as for the story.
-- So every parameter at which the renderer meets the shape is among the roots told here, to the bit (a law). What
-- stands here is which conditions a shape has, and what its formulas and letters are.
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
import Dioptre.Geometry.Axis (Round, axisEnd, axisLength, axisStart, roundAxis, roundRadius)
import Dioptre.Geometry.Cap (capCurvature, capDisk, centreDepth, sphereOver)
import Dioptre.Geometry.Cone (ConeLine (..), coneLine)
import Dioptre.Geometry.Cube (cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (annulusInner, annulusOuter, annulusPlane, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (Face (..), LensLine (..), faceEquation, lensBody, lensCurvatures, lensLine)
import Dioptre.Geometry.Placement (Placement, carriedBack, placement)
import Dioptre.Geometry.Plane (Plane, planeNormal, planeParameters, planePosition)
import Dioptre.Geometry.Quadratic (Quadratic (..), rootsOf)
import Dioptre.Geometry.Ray (Ray, direction, directionQuadrance, nextTo, origin, position)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (TorusLine (..), torusEquation, torusLine, torusMajor, torusMinor, torusParameters, torusPlane)
import Dioptre.Geometry.Triangle (Corners (..), Triangle, barycentric, smoothTriangleFlat, triangleNormal, trianglePoints)
import Dioptre.Geometry.Tube (across, circle, tubeLineParameters)
import Dioptre.Math.Order (infinity)
import Dioptre.Math.Quartic (quarticRoots)
import Dioptre.Math.Vector (Point, Unit, Vector, alongZ, distance, dot, unit, vector, (*^))
import Linear.V3 (V3 (..))

-- | A parameter that fulfils a condition, the condition's place among the shape's from 0, and what is measured at the
-- point there.
data Candidate = Candidate Double Int Measure

-- | The conditions for a ray to meet a shape inside of some frames, the outermost first; and every root of every
-- condition, in the order of the conditions.
equationOf :: [Placement] -> Shape -> Ray -> (Equation, [Candidate])
equationOf frames shape r = (Equation (if own == r then Nothing else Just own) moved (map fst conditions), candidates)
  where
    (own, plain) = inside (foldl' (flip carriedBack) r frames) shape
    Told moved conditions = told plain own
    candidates = [Candidate t i measure | (i, (_, roots)) <- zip [0 ..] conditions, (t, measure) <- roots]

-- | The ray in the innermost frame of a shape, and what stands there.
inside :: Ray -> Shape -> (Ray, Shape)
inside r shape = case shape of
  ATransformed t inner -> inside (carriedBack (placement t) r) inner
  _ -> (r, shape)

-- | A condition, with its roots in the ray's parameter and what is measured there.
type Solved = (Condition, [(Double, Measure)])

-- | What is told of a shape: what the parameter is counted from, and in what unit, where the equations have another one
-- than the ray; and the conditions.
data Told = Told (Maybe (Double, Double)) [Solved]

told :: Shape -> Ray -> Told
told shape r = case shape of
  APlane p -> Told Nothing [onPlane p (const OtherConditions) r]
  ADisk d -> Told Nothing [onPlane (diskPlane d) (\v -> AwayFromCentre (distance (planePosition (diskPlane d)) v) (diskRadius d)) r]
  AnAnnulus a -> Told Nothing [onPlane (annulusPlane a) (ringMeasure (planePosition (annulusPlane a)) (annulusInner a) (annulusOuter a)) r]
  ATriangle t -> Told Nothing [onTriangle t r]
  ASmoothTriangle s -> Told Nothing [onTriangle (smoothTriangleFlat s) r]
  ASphere s -> Told Nothing [onSphere (sphereCentre s) (sphereRadius s) r]
  ACube c -> Told Nothing (inCube (cubeCentre c) (cubeSize c / 2) r)
  ATube body -> Told Nothing (along body tubeConditions r)
  ACylinder body -> Told Nothing (along body cylinderConditions r)
  ACone body -> along body coneConditions r
  ALens l -> let (c1, c2) = lensCurvatures l in along (lensBody l) lensConditions c1 c2 r
  ACap c -> let d = capDisk c in capConditions (planePosition (diskPlane d)) (normalOf (diskPlane d)) (diskRadius d) (capCurvature c) r
  ATorus t -> torusConditions (planePosition (torusPlane t)) (normalOf (torusPlane t)) (torusMajor t) (torusMinor t) r
  ATransformed _ inner -> told inner r

normalOf :: Plane -> Unit
normalOf p = fromMaybe alongZ (unit (planeNormal p))

-- | Gives the numbers of an axis, as the renderer has them: P1, S, H and R.
along :: Round -> (Point -> Unit -> Double -> Double -> a) -> a
along body rule = rule p1 (fromMaybe alongZ (unit (axisEnd (roundAxis body) - p1))) (axisLength (roundAxis body)) (roundRadius body)
  where
    p1 = axisStart (roundAxis body)

-------------------------------------------------------------------------------
-- In planes

onPlane :: Plane -> (Point -> Measure) -> Ray -> Solved
onPlane p = flat (planePosition p) (normalOf p)

onTriangle :: Triangle -> Ray -> Solved
onTriangle t = flat p0 (triangleNormal t) (uncurry Barycentric . barycentric p0 p1 p2)
  where
    Corners p0 p1 p2 = trianglePoints t

ringMeasure :: Point -> Double -> Double -> Point -> Measure
ringMeasure centre inner outer v
  | away < inner = InTheHole away inner
  | away <= outer = OnTheRing away inner outer
  | otherwise = AwayFromCentre away outer
  where
    away = distance centre v

-- | The plane through P with normal n, and what is measured at its point.
flat :: Point -> Unit -> (Point -> Measure) -> Ray -> Solved
flat p n measure r =
  ( PolynomialIsZero
      ThePlane
      [ Coefficient "A" "<n, d>" (dot (vector n) (direction r)),
        Coefficient "B" "<n, o - P>" (dot (vector n) (origin r - p))
      ]
      [ "n" `is` vec (vector n),
        "P" `is` vec p
      ]
      Nothing
      0,
    [(t, measure (position r t)) | t <- planeParameters p n r]
  )

-------------------------------------------------------------------------------
-- Spheres and cubes

onSphere :: Point -> Double -> Ray -> Solved
onSphere c radius r = (quadratic TheSphere ("<d, d>", "2 <w, d>", "<w, w> - R^2") equation letters 0, unmeasured (rootsOf equation))
  where
    d = direction r
    w = origin r - c
    equation = Quadratic (directionQuadrance r) (2 * dot w d) (dot w w - radius * radius)
    letters =
      [ "w = o - C",
        "C" `is` vec c,
        "R" `is` real radius
      ]

inCube :: Point -> Double -> Ray -> [Solved]
inCube (V3 cx cy cz) h r = [slab "x" cx ox dx, slab "y" cy oy dy, slab "z" cz oz dz]
  where
    V3 ox oy oz = origin r
    V3 dx dy dz = direction r
    slab name c o d = within (TheFaces name) ("d_" <> name) d ("o_" <> name) o (c - h) (c + h)

-------------------------------------------------------------------------------
-- Around an axis

tubeConditions :: Point -> Unit -> Double -> Double -> Ray -> [Solved]
tubeConditions p1 s h radius r = [(tubeFromStart p1 s radius r, [(t, AtHeight (dot (position r t - p1) (vector s)) h) | t <- tubeLineParameters p1 s radius r])]

cylinderConditions :: Point -> Unit -> Double -> Double -> Ray -> [Solved]
cylinderConditions p1 s h radius r =
  [ (tubeFromStart p1 s radius r, unmeasured (tubeLineParameters p1 s radius r)),
    within TheEnds "<d, S>" (dot (direction r) (vector s)) "<o - P1, S>" (dot (origin r - p1) (vector s)) 0 h
  ]

-- | The infinite tube, seen from P1.
tubeFromStart :: Point -> Unit -> Double -> Ray -> Condition
tubeFromStart p1 s radius r = tube "w = o - P1" ("P1" `is` vec p1) s radius (circle radius (across s (origin r - p1)) (across s (direction r)))

-- | The infinite tube, with what w is and where it is measured from.
tube :: Text -> Text -> Unit -> Double -> Quadratic -> Condition
tube w centre s radius equation = quadratic TheTube ("<d', d'>", "2 <w', d'>", "<w', w'> - R^2") equation letters 0
  where
    letters =
      [ w,
        "w' = w - <w, S> S",
        "d' = d - <d, S> S",
        centre,
        "S" `is` vec (vector s),
        "R" `is` real radius
      ]

coneConditions :: Point -> Unit -> Double -> Double -> Ray -> Told
coneConditions p1 s h radius r = case coneLine p1 s h radius r of
  FromNearest t0 equation a da ->
    let side = quadratic TheDoubleCone ("<d', d'> - (k b)^2", "2 (<w', d'> - k^2 a b)", "<w', w'> - (k a)^2") equation letters 0
        letters = ["w = o + t0 d - P2", "a = <w, S>", "b = <d, S>", "w' = w - a S", "d' = d - b S", "k = R / H" `is` real (radius / h)] <> places
     in Told (Just (t0, 1)) [(side, unmeasured (rootsOf equation)) `countedFrom` t0, within TheEnds "<d, S>" da "<w, S>" a (negate h) 0 `countedFrom` t0]
  -- Met in units of q = H / R, and told in the ray's own: the equation is q^2 times as small, and its letters are the
  -- same.
  FromApexPlane t0 q equation@(Quadratic a b c) da ->
    let side = (quadratic TheDoubleCone ("q^2 <d', d'> - b^2", "2 q^2 <w', d'>", "q^2 <w', w'>") (Quadratic a (q * b) (q * q * c)) letters 0, [(q * x, OtherConditions) | x <- rootsOf equation])
        letters = ["w = o + t0 d - P2", "b = <d, S>", "w' = w - <w, S> S", "d' = d - b S", "q = H / R" `is` real q] <> places
        ends = [(q * (end / da), OtherConditions) | end <- [negate radius, 0]]
     in Told (Just (t0, 1)) [side `countedFrom` t0, (fst (within TheEnds "<d, S>" da "<w, S>" 0 (negate h) 0), ends) `countedFrom` t0]
  where
    places = ["S" `is` vec (vector s), "P2" `is` vec (p1 + h *^ vector s)]

lensConditions :: Point -> Unit -> Double -> Double -> Double -> Double -> Ray -> Told
lensConditions p1 s l radius c1 c2 r = Told (Just (t0, 1)) [(side, unmeasured (rootsOf bar)) `countedFrom` t0, face TheStartFace start, face TheEndFace end]
  where
    d = direction r
    LensLine t0 w start end = lensLine p1 s l radius c1 c2 r
    bar = circle radius (across s w) (across s d)
    side = tube "w = o + t0 d - M" ("M" `is` vec (p1 + (l / 2) *^ vector s)) s radius bar
    face patch f = (overDisk patch (faceAxis f) radius (faceCentre f) (facePoint f) equation (faceShift f), unmeasured (rootsOf equation)) `countedFrom` faceShift f `countedFrom` t0
      where
        equation = faceEquation radius f d

-------------------------------------------------------------------------------
-- Over a disk, and around a circle

capConditions :: Point -> Unit -> Double -> Double -> Ray -> Told
capConditions centre n radius c r = Told (Just (t0, 1)) [(overDisk TheSphere (vector n) radius m p equation 0, [(x, SideOfDisk) | abs t0 < infinity, x <- rootsOf equation]) `countedFrom` t0]
  where
    m = centreDepth radius c
    (t0, p) = nextTo (origin r - centre) (direction r)
    equation = sphereOver (vector n) radius m p (direction r)

-- | The sphere over a disk, for a point p measured from the disk's centre; with the further move of the parameter.
overDisk :: Patch -> Vector -> Double -> Double -> Vector -> Quadratic -> Double -> Condition
overDisk patch n radius m p equation = quadratic patch ("<d, d>", "2 (<p, d> + m <d, n>)", "<p, p> + 2 m <p, n> - R^2") equation letters
  where
    letters =
      [ "p" `is` vec p,
        "m" `is` real m,
        "n" `is` vec n,
        "R" `is` real radius
      ]

torusConditions :: Point -> Unit -> Double -> Double -> Ray -> Told
torusConditions p n major minor r
  | c > outer * outer && null (torusParameters p n major minor r) = Told Nothing [(PassesNear (sqrt c * l) (major + minor), [])]
  | otherwise = Told (Just (t0, scale)) [(ring, [((t0 + s) * scale, OtherConditions) | s <- quarticRoots 1 0 c2 c1 c0])]
  where
    TorusLine l t0 scale c height slope = torusLine p n major minor r
    outer = (major + minor) / l
    (c2, c1, c0) = torusEquation (major / l) (minor / l) c height slope
    ring =
      PolynomialIsZero
        TheTorus
        [ Coefficient "A" "1" 1,
          Coefficient "B" "0" 0,
          Coefficient "C" "2 G - 4 R^2 (1 - M^2)" c2,
          Coefficient "D" "8 R^2 M N" c1,
          Coefficient "E" "G^2 - 4 R^2 (<q, q> - N^2)" c0
        ]
        [ "u = d / |d|",
          "q = (o - P) / L + t0 u",
          "N = <n, q>",
          "M = <n, u>",
          "G = <q, q> + R^2 - r^2",
          "L" `is` real l,
          "R" `is` real (major / l),
          "r" `is` real (minor / l),
          "n" `is` vec (vector n),
          "P" `is` vec p
        ]
        Nothing
        0

-------------------------------------------------------------------------------
-- Conditions

-- | A condition of the second degree: the formulas of A, B and C, and what their letters are. Its discriminant is told
-- where its sign is that of the number of roots, which it is but for rounding.
quadratic :: Patch -> (Text, Text, Text) -> Quadratic -> [Text] -> Double -> Condition
quadratic patch (formulaA, formulaB, formulaC) equation@(Quadratic a b c) letters =
  PolynomialIsZero patch [Coefficient "A" formulaA a, Coefficient "B" formulaB b, Coefficient "C" formulaC c] letters (if agrees then Just discriminant else Nothing)
  where
    discriminant = b * b - 4 * a * c
    agrees = case rootsOf equation of
      [x, y] -> if x == y then discriminant == 0 else discriminant > 0
      [] -> discriminant < 0
      _ -> False

-- | A slab: where B + A t is from low to high, and the parameters of its two faces.
within :: Patch -> Text -> Double -> Text -> Double -> Double -> Double -> Solved
within patch formulaA a formulaB b low high =
  (LiesBetween patch (Coefficient "A" formulaA a) (Coefficient "B" formulaB b) low high, unmeasured [x | a /= 0, x <- [(low - b) / a, (high - b) / a]])

-- | The roots where nothing more is measured.
unmeasured :: [Double] -> [(Double, Measure)]
unmeasured ts = [(t, OtherConditions) | t <- ts]

-- | The same roots, when they were counted from a parameter on.
countedFrom :: Solved -> Double -> Solved
countedFrom (condition, roots) t0 = (condition, [(t0 + x, measure) | (x, measure) <- roots])

-- | A letter, and what it is.
is :: Text -> Text -> Text
is letter value = letter <> " = " <> value
