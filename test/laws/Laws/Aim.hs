-- |
-- Module      : Laws.Aim
-- Description : Shapes, and rays that are aimed at them
--
-- A ray that is drawn at random misses most shapes, and never meets an edge. These rays are aimed: at points inside,
-- at corners, edges, rims and centres; along axes, along faces, in tangents; from before, behind, within and upon the
-- shape.
module Laws.Aim
  ( Aimed (..),
    Crisp (..),
    aimedAt,
    crispAt,
    crisp,

    -- * Shapes
    Sort (..),
    sortOf,
    shapeOf,
    crispShape,
    rayAt,
    carried,
    preparedOf,

    -- * What was drawn
    aimCorners,
  )
where

import Data.Maybe (fromMaybe, isJust)
import Dioptre.Geometry.Cube (cube, cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (annulus, annulusInner, annulusOuter, annulusPlane, disk, diskPlane, diskRadius)
import Dioptre.Geometry.Plane (Plane, plane, planeNormal, planePosition)
import Dioptre.Geometry.Prepared (Prepared, parameters, prepare)
import Dioptre.Geometry.Ray (Ray, direction, origin, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere, sphereCentre, sphereRadius)
import Dioptre.Geometry.Triangle
import Dioptre.Math.Vector (Point, Vector, alongX, cross, unit, vector, (*^))
import Laws.Draw
import Laws.Exact (components)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-- | The shapes that are drawn.
data Sort = PlaneSort | DiskSort | AnnulusSort | SphereSort | CubeSort | TriangleSort | SmoothTriangleSort
  deriving (Eq, Show, Enum, Bounded)

-- | Which of them a shape is; of those that are drawn.
sortOf :: Shape -> Maybe Sort
sortOf shape = case shape of
  APlane _ -> Just PlaneSort
  ADisk _ -> Just DiskSort
  AnAnnulus _ -> Just AnnulusSort
  ASphere _ -> Just SphereSort
  ACube _ -> Just CubeSort
  ATriangle _ -> Just TriangleSort
  ASmoothTriangle _ -> Just SmoothTriangleSort
  _ -> Nothing

-- | A shape and a ray that is aimed at it.
data Aimed = Aimed Shape Ray
  deriving (Eq, Show)

instance Arbitrary Aimed where
  arbitrary = elements [minBound ..] >>= aimedAt
  shrink (Aimed shape r) = [Aimed shape (ray o d) | (o, d) <- simpler (origin r) (direction r)]
    where
      simpler o d = [(0, d) | o /= 0] ++ [(o, d') | d' <- rounded d, d' /= d, d' /= 0] ++ [(o', d) | o' <- rounded o, o' /= o]
      rounded (V3 x y z) = [V3 (whole x) y z, V3 x (whole y) z, V3 x y (whole z)]
      whole x = fromInteger (truncate x)

-- | A shape and a ray made of such small integers, halves and powers of two that all that matters is computed without
-- rounding. Flat shapes other than triangles are parallel to two axes.
data Crisp = Crisp Shape Ray
  deriving (Eq, Show)

instance Arbitrary Crisp where
  arbitrary = elements [minBound ..] >>= crispAt

-- | A ray aimed at a shape of that sort.
aimedAt :: Sort -> Gen Aimed
aimedAt sort = do
  kind <- anyKind
  shape <- shapeOf sort kind
  Aimed shape <$> rayAt kind shape

-- | A crisp ray aimed at a shape of that sort.
crispAt :: Sort -> Gen Crisp
crispAt sort = crispShape sort >>= crisp

-- | The shape that was made; for what the generators know to be possible.
made :: Maybe a -> Gen a
made = maybe discard pure

-- | A shape of that sort.
shapeOf :: Sort -> Kind -> Gen Shape
shapeOf sort kind = case sort of
  PlaneSort -> APlane <$> anyPlane
  DiskSort -> ADisk <$> (disk <$> anyPlane <*> positive kind >>= made)
  AnnulusSort -> AnAnnulus <$> (anyPlane >>= ringIn)
  SphereSort -> ASphere <$> (sphere <$> point kind <*> positive kind >>= made)
  CubeSort -> ACube <$> (cube <$> point kind <*> positive kind >>= made)
  TriangleSort -> ATriangle <$> anyTriangle
  SmoothTriangleSort -> ASmoothTriangle <$> (anyTriangle >>= smoothed)
  where
    anyPlane = plane <$> point kind <*> step kind >>= made
    ringIn p = do
      outer <- positive kind
      inner <- oneof [pure 0, pure outer, (* outer) <$> fraction]
      made (annulus p (min inner outer) outer)
    anyTriangle = (triangle <$> anyCorners) `suchThat` isJust >>= made
    anyCorners = oneof [Corners <$> point kind <*> point kind <*> point kind, sliver]
    -- The third corner next to the opposite edge.
    sliver = do
      a <- point kind
      b <- point kind
      f <- fraction
      e <- chooseInt (-30, -5)
      v <- step kind
      pure (Corners a b (between a b f + scaleFloat e 1 *^ v))
    smoothed t = do
      normals <- Corners <$> bump <*> bump <*> bump
      pure (smoothTriangle t normals (Corners (V2 0 0) (V2 1 0) (V2 0 1)))
    bump = oneof [pure Nothing, pure (Just 0), Just <$> step kind]

-- | A shape of that sort, of small integers. Radii are multiples of 5, so that points of the rim are integers too.
crispShape :: Sort -> Gen Shape
crispShape sort = case sort of
  PlaneSort -> APlane <$> flat
  DiskSort -> ADisk <$> (disk <$> flat <*> radius >>= made)
  AnnulusSort -> AnAnnulus <$> (annulus <$> flat <*> elements [0, 5, 10] <*> elements [10, 25] >>= made)
  SphereSort -> ASphere <$> (sphere <$> point Few <*> radius >>= made)
  CubeSort -> shapeOf CubeSort Few
  TriangleSort -> shapeOf TriangleSort Few `suchThat` whole
  SmoothTriangleSort -> shapeOf SmoothTriangleSort Few `suchThat` whole
  where
    flat = plane <$> point Few <*> axisStep Few >>= made
    radius = elements [5, 10, 25]
    whole shape = all (\x -> x * 2 == fromInteger (round (x * 2))) (concatMap components (cornersOf shape))
    cornersOf shape = case shape of
      ATriangle t -> listed (trianglePoints t)
      ASmoothTriangle t -> listed (trianglePoints (smoothTriangleFlat t))
      _ -> []

-- | A crisp ray aimed at a crisp shape.
crisp :: Shape -> Gen Crisp
crisp shape = do
  target <- oneof [places shape, point Few]
  d <- frequency [(1, axisStep Few >>= \v -> pure (signum v)), (4, dyadicStep)]
  k <- elements [-8, -2, -1, -0.5, 0, 0.5, 1, 2, 3, 4, 16]
  pure (Crisp shape (ray (target - k *^ d) d))
  where
    places s = case s of
      APlane p -> (planePosition p +) <$> point Few
      ADisk x -> inPlane (diskPlane x) [0, diskRadius x]
      AnAnnulus x -> inPlane (annulusPlane x) [annulusInner x, annulusOuter x]
      ASphere x -> (sphereCentre x +) . (sphereRadius x *^) . fmap fifth <$> elements directions
      ACube x -> (\v -> cubeCentre x + (cubeSize x / 2) *^ v) <$> (V3 <$> side <*> side <*> side)
      ATriangle t -> midway (trianglePoints t)
      ASmoothTriangle t -> midway (trianglePoints (smoothTriangleFlat t))
      _ -> pure 0
    -- Of a radius that is a multiple of 5, four and three fifths.
    fifth x = x / 5
    directions = [V3 5 0 0, V3 0 (-5) 0, V3 0 0 5, V3 3 4 0, V3 (-4) 0 3, V3 0 4 (-3)]
    inPlane p radii = do
      r <- elements radii
      V3 x y z <- elements directions
      let V3 nx ny nz = planeNormal p
          keep n c = if n /= 0 then 0 else c / 5 * r
      pure (planePosition p + V3 (keep nx x) (keep ny y) (keep nz z))
    side = elements [-1, -0.5, 0, 1]
    midway (Corners a b c) = elements [a, b, c, mid a b, mid b c, mid c a, mid a (mid b c)]
    mid a b = 0.5 *^ (a + b)

-- | A ray aimed at a shape.
rayAt :: Kind -> Shape -> Gen Ray
rayAt kind shape = do
  (target, n) <- oneof [placed shape, (,) <$> point kind <*> step kind]
  d <- direct n
  o <- oneof [(\k -> target - k *^ d) <$> oneof [elements [0, 1, -1, 2], number kind], pure target]
  oneof [pure (ray o d), through target]
  where
    -- in any direction, along an axis, across the axis of the place, straight at it
    direct n = oneof [step kind, dyadicStep, axisStep kind, (cross n <$> step kind) `suchThat` (/= 0), pure n]
    through target = do
      o <- point kind `suchThat` (/= target)
      k <- oneof [pure 1, powerOfTwo (-3) 3, number kind `suchThat` (/= 0)]
      let d = target - o
      -- as rays from the camera are: of unit length
      oneof [pure (ray o (k *^ d)), pure (ray o (maybe d vector (unit d)))]
    placed s = case s of
      APlane p -> onPlane p [1, 2]
      ADisk x -> onPlane (diskPlane x) [diskRadius x]
      AnAnnulus x -> onPlane (annulusPlane x) [annulusInner x, annulusOuter x]
      ASphere x -> do
        n <- vector . unitOf <$> step Full
        pure (sphereCentre x + sphereRadius x *^ n, n)
      ACube x -> do
        v <- V3 <$> side <*> side <*> side
        pure (cubeCentre x + (cubeSize x / 2) *^ v, if all ((< 1) . abs) v then V3 1 1 1 else fmap edgeOnly v)
      ATriangle t -> onTriangle t
      ASmoothTriangle t -> onTriangle (smoothTriangleFlat t)
      _ -> pure (0, V3 1 0 0)
    edgeOnly x = if abs x == 1 then x else 0
    side = oneof [elements [-1, 1], pure 0, (\f -> 2 * f - 1) <$> fraction]
    unitOf v = fromMaybe alongX (unit v)
    onPlane :: Plane -> [Double] -> Gen (Point, Vector)
    onPlane p radii = do
      v <- (cross (planeNormal p) <$> step Full) `suchThat` (/= 0)
      r <- elements radii
      f <- oneof [pure 1, pure 0, fraction]
      pure (planePosition p + (r * f) *^ vector (unitOf v), planeNormal p)
    onTriangle t = do
      let Corners a b c = trianglePoints t
      f <- fraction
      g <- fraction
      q <- elements [a, b, c, between a b f, between b c f, between c a f, between a (between b c f) g]
      pure (q, vector (triangleNormal t))

between :: Point -> Point -> Double -> Point
between a b f = a + f *^ (b - a)

listed :: Corners a -> [a]
listed (Corners a b c) = [a, b, c]

-- | A shape whose points, directions and lengths are carried elsewhere; 'Nothing' if there is no such shape.
carried :: (Point -> Point) -> (Vector -> Vector) -> (Double -> Double) -> Shape -> Maybe Shape
carried onPoint onVector onLength shape = case shape of
  APlane p -> APlane <$> flat p
  ADisk x -> ADisk <$> (flat (diskPlane x) >>= \p -> disk p (onLength (diskRadius x)))
  AnAnnulus x -> AnAnnulus <$> (flat (annulusPlane x) >>= \p -> annulus p (onLength (annulusInner x)) (onLength (annulusOuter x)))
  ASphere x -> ASphere <$> sphere (onPoint (sphereCentre x)) (onLength (sphereRadius x))
  ACube x -> ACube <$> cube (onPoint (cubeCentre x)) (onLength (cubeSize x))
  ATriangle t -> ATriangle <$> corners t
  ASmoothTriangle t ->
    let Corners a b c = smoothTriangleNormals t
     in (\flat' -> ASmoothTriangle (smoothTriangle flat' (Corners (bump a) (bump b) (bump c)) (smoothTriangleUvs t))) <$> corners (smoothTriangleFlat t)
  _ -> Nothing
  where
    flat p = plane (onPoint (planePosition p)) (onVector (planeNormal p))
    corners t = let Corners a b c = trianglePoints t in triangle (Corners (onPoint a) (onPoint b) (onPoint c))
    bump = Just . onVector

-- | The shape as the inner loop sees it. All sorts of 'Sort' can be prepared.
preparedOf :: Shape -> Prepared
preparedOf shape = fromMaybe (error ("not prepared: " ++ show shape)) (prepare shape)

-- | What the rays must do.
aimCorners :: Aimed -> [(String, Bool)]
aimCorners (Aimed shape r) =
  [ ("it hits", not (null ts)),
    ("it misses", null ts),
    ("it hits before and behind its origin", any (> 0) ts && any (< 0) ts),
    ("it starts on the surface", 0 `elem` ts),
    ("it is along an axis", length (filter (/= 0) (components (direction r))) == 1),
    ("it is parallel to a plane of axes", length (filter (/= 0) (components (direction r))) == 2),
    ("it touches", or (zipWith (==) ts (drop 1 ts)))
  ]
  where
    ts = parameters (preparedOf shape) r
