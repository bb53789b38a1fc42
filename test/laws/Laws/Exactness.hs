-- |
-- Module      : Laws.Exactness
-- Description : The program against the plain list, and against the obvious implementation
--
-- Two opinions on what a ray meets. The plain list tries every shape by the program's own rules, one after the other:
-- the index must give the same number, to the bit. "Laws.Obvious" knows none of these rules and does not round: there
-- the program must meet the same shape, at a parameter within the allowance, or be so near to an edge, a tangent or
-- another shape that rounding may decide.
module Laws.Exactness
  ( -- * What is drawn
    Sort (..),
    sortOf,
    Manner (..),
    Aimed (..),
    aimedAt,
    Scenery (..),
    scenery,
    rayIn,
    Crowd (..),
    crowd,

    -- * The plain list
    found,
    closestOfAll,
    closestIsTheListsOwn,

    -- * The obvious implementation
    agreesWithObvious,
    isAsNearAsPromised,
    closestIsObvious,
    Comparison (..),
    Measured (..),
    compared,

    -- * What was drawn
    aimedCorners,
    crowdCorners,
  )
where

import Data.List (find, foldl', intercalate)
import Data.Maybe (isJust, isNothing, mapMaybe)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Axis (axis, axisEnd, axisStart, roundAxis, roundRadius, roundShape)
import Dioptre.Geometry.Bounds (ofShape)
import Dioptre.Geometry.Box (boxHigh, boxLow)
import Dioptre.Geometry.Cap (cap, capCurvature, capDisk)
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (annulus, annulusInner, annulusOuter, annulusPlane, disk, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (lens, lensBody, lensCurvatures)
import Dioptre.Geometry.Mesh (meshSize)
import Dioptre.Geometry.Plane (Plane, plane, planeNormal, planePosition)
import Dioptre.Geometry.Prepared (Prepared, parameters, prepare)
import Dioptre.Geometry.PreparedMesh (triangleShape)
import Dioptre.Geometry.Ray (Ray, direction, origin, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere, sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (torus, torusMajor, torusMinor, torusPlane)
import Dioptre.Geometry.Triangle
import Dioptre.Light.Finish (finish, withPictures)
import Dioptre.Light.Material (standard)
import Dioptre.Math.Transform (Transform, identity, placement, transform, transformDirection, transformPosition)
import Dioptre.Math.Vector
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..))
import Dioptre.Render.Closest (closest)
import Dioptre.Render.World (World, world)
import qualified Laws.Aim as Aim
import Laws.Closest (sceneOf)
import Laws.Draw
import Laws.Exact
import Laws.Index (met)
import Laws.Mesh (aMesh, roundMesh)
import Laws.Obvious
import Laws.Obvious.Motion (lineOf)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-------------------------------------------------------------------------------
-- Shapes

-- | All shapes of the scene language.
data Sort = PlaneSort | DiskSort | AnnulusSort | SphereSort | CubeSort | TriangleSort | SmoothTriangleSort | TubeSort | CylinderSort | ConeSort | LensSort | CapSort | TorusSort | TransformedSort
  deriving (Eq, Ord, Show, Enum, Bounded)

sortOf :: Shape -> Sort
sortOf shape = case shape of
  APlane _ -> PlaneSort
  ADisk _ -> DiskSort
  AnAnnulus _ -> AnnulusSort
  ASphere _ -> SphereSort
  ACube _ -> CubeSort
  ATriangle _ -> TriangleSort
  ASmoothTriangle _ -> SmoothTriangleSort
  ATube _ -> TubeSort
  ACylinder _ -> CylinderSort
  ACone _ -> ConeSort
  ALens _ -> LensSort
  ACap _ -> CapSort
  ATorus _ -> TorusSort
  ATransformed _ _ -> TransformedSort

-- | How shapes and rays are drawn.
data Manner
  = -- | As scenes are: sizes from 1\/8 to 8, within 16 of the origin; rays of unit direction from 1 to 100 sizes away, to any place of the shape.
    Ordinary
  | -- | Sizes from 2^-20 to 2^20, or small integers; needles and flat caps; rays from up to 2^20 sizes away, of any length, at rims, edges, corners, centres and axes, in tangents, along surfaces, within and upon the shape.
    Adverse
  deriving (Eq, Ord, Show, Enum, Bounded)

-- | A shape and a ray that is aimed at it.
data Aimed = Aimed Shape Ray
  deriving (Eq, Show)

-- | A shape of that sort, and a ray.
aimedAt :: Manner -> Sort -> Gen Aimed
aimedAt manner sort = do
  kind <- kindOf manner
  shape <- shapeOf manner kind sort
  Aimed shape <$> rayAt manner kind shape

kindOf :: Manner -> Gen Kind
kindOf manner = case manner of
  Ordinary -> pure Full
  Adverse -> anyKind

-- | A number from 1 to 2^k, or 1 over that, all sizes alike.
upTo :: Double -> Gen Double
upTo k = (2 **) <$> choose (negate k, k)

length' :: Manner -> Kind -> Gen Double
length' manner kind = case manner of
  Ordinary -> upTo 3
  Adverse -> positive kind

somewhere :: Manner -> Kind -> Gen Point
somewhere manner kind = case manner of
  Ordinary -> V3 <$> choose (-16, 16) <*> choose (-16, 16) <*> choose (-16, 16)
  Adverse -> oneof [pure 0, point kind]

-- | A vector of some length in any direction.
someStep :: Manner -> Kind -> Gen Vector
someStep manner kind = case manner of
  Ordinary -> (*^) <$> upTo 3 <*> direction'
  Adverse -> step kind

-- | A unit vector, no direction more likely than another.
direction' :: Gen Vector
direction' = do
  v <- (V3 <$> choose (-1, 1) <*> choose (-1, 1) <*> choose (-1, 1)) `suchThat` (\v -> quadrance v <= 1 && quadrance v > 0.01)
  maybe direction' (pure . vector) (unit v)

shapeOf :: Manner -> Kind -> Sort -> Gen Shape
shapeOf manner kind sort = case sort of
  PlaneSort -> APlane <$> aPlane
  DiskSort -> ADisk <$> aDisk
  AnnulusSort -> AnAnnulus <$> made ((\p size' part -> annulus p (part * size') size') <$> aPlane <*> size <*> choose (0, 1))
  SphereSort -> ASphere <$> made (sphere <$> centre <*> size)
  CubeSort -> ACube <$> made (cube <$> centre <*> size)
  TriangleSort -> ATriangle <$> aTriangle
  SmoothTriangleSort -> (\t -> ASmoothTriangle (smoothTriangle t (Corners Nothing Nothing Nothing) (Corners (V2 0 0) (V2 1 0) (V2 0 1)))) <$> aTriangle
  TubeSort -> ATube <$> aRound
  CylinderSort -> ACylinder <$> aRound
  ConeSort -> ACone <$> aRound
  LensSort -> ALens <$> made ((\body k l -> lens body (k * roundRadius body, l * roundRadius body)) <$> aRound <*> curvature <*> curvature)
  CapSort -> ACap <$> made ((\d k -> cap d (k * diskRadius d)) <$> aDisk <*> curvature)
  TorusSort -> ATorus <$> made ((\p major part -> torus p major (part * major)) <$> aPlane <*> size <*> thickness)
  TransformedSort -> ATransformed <$> aTransform manner <*> (elements [PlaneSort .. TransformedSort] >>= shapeOf manner kind)
  where
    size = length' manner kind
    centre = somewhere manner kind
    aPlane = made (plane <$> centre <*> someStep manner kind)
    aDisk = made (disk <$> aPlane <*> size)
    aTriangle = case manner of
      Ordinary -> made ((\p a b -> triangle (Corners p (p + a) (p + b))) <$> centre <*> someStep manner kind <*> someStep manner kind)
      Adverse -> Aim.shapeOf Aim.TriangleSort kind `suchThatMap` flatOne
    flatOne shape = case shape of
      ATriangle t -> Just t
      _ -> Nothing
    aRound = made ((\p g r -> axis p (p + g) >>= (`roundShape` r)) <$> centre <*> someStep manner kind <*> size)
    thickness = case manner of
      Ordinary -> choose (0.05, 0.95)
      Adverse -> oneof [choose (0.05, 0.95), upTo 8, elements [1, 0.5, 0.25, 2]]
    -- In units of the radius, at least 1 in magnitude.
    curvature =
      (*) <$> elements [1, -1] <*> case manner of
        Ordinary -> choose (1, 4)
        Adverse -> oneof [elements [1, 1.25, 2], (1 +) . abs <$> upTo 20]

-- | What is drawn until it can be made.
made :: Gen (Maybe a) -> Gen a
made = (`suchThatMap` id)

-- | A transformation; its factors are from 1\/4 to 4, and mirror at times.
aTransform :: Manner -> Gen Transform
aTransform manner = made (transform <$> (V3 <$> factor <*> factor <*> factor) <*> (V3 <$> turn <*> turn <*> turn) <*> somewhere manner Full)
  where
    factor = (*) <$> elements [1, 1, -1] <*> oneof [pure 1, upTo 2]
    turn = oneof [elements [0, 90, -90, 180, 45], choose (-180, 180)]

-------------------------------------------------------------------------------
-- Rays

-- | A ray that is aimed at a shape.
rayAt :: Manner -> Kind -> Shape -> Gen Ray
rayAt manner kind shape = case (manner, shape) of
  (_, ATransformed t x) -> rayAt manner kind x >>= \r -> carried (placement t) r
  (Adverse, ACube _) -> Aim.rayAt kind shape
  (Adverse, ATriangle _) -> Aim.rayAt kind shape
  (Adverse, ASmoothTriangle _) -> Aim.rayAt kind shape
  _ -> targetOn shape >>= towards manner kind
  where
    carried m r = pure (ray (transformPosition m (origin r)) (transformDirection m (direction r)))

-- | A place of a shape or next to it, how large the shape is, and directions that are special there.
data Target = Target Point Double [Vector]

towards :: Manner -> Kind -> Target -> Gen Ray
towards manner kind (Target target size special) = case manner of
  Ordinary -> do
    u <- direction'
    away <- (10 **) <$> choose (0, 2)
    let o = target - (away * size) *^ u
    pure (ray o (unitAlong (target - o)))
  Adverse -> do
    d <- direct `suchThat` (/= 0)
    k <- oneof [elements [0, 1, -1, 2], number kind, (size *) <$> upTo (if kind == Wide then 20 else 6), pure size]
    o <- oneof [pure (target - (k / modulus d) *^ d), pure (target - k *^ d), point kind]
    oneof [pure (ray o d), through o, ray o . ($ d) . (*^) <$> (abs <$> powerOfTwo (-10) 10)]
  where
    direct = oneof [elements special, nearly =<< elements special, step kind, axisStep kind, dyadicStep]
    -- Off by a little, next to what is special.
    nearly v = (\e u -> v + (modulus v * scaleFloat e 1) *^ u) <$> chooseInt (-54, -4) <*> direction'
    through o
      | o == target = ray o <$> step kind
      | otherwise = elements [ray o (target - o), ray o (unitAlong (target - o))]

targetOn :: Shape -> Gen Target
targetOn shape = case shape of
  APlane p -> inPlane p [1, 2]
  ADisk x -> inPlane (diskPlane x) [diskRadius x]
  AnAnnulus x -> inPlane (annulusPlane x) [annulusInner x, annulusOuter x]
  ASphere x -> do
    u <- direction'
    e <- acrossTo u
    f <- oneof [pure 1, aboutOne, choose (0, 1)]
    pure (Target (sphereCentre x + (f * sphereRadius x) *^ u) (sphereRadius x) [u, e])
  ATriangle t -> onTriangle t
  ASmoothTriangle t -> onTriangle (smoothTriangleFlat t)
  ATube x -> onAxis x (const 1)
  ACylinder x -> onAxis x (const 1)
  ACone x -> onAxis x (1 -)
  ALens x -> onAxis (lensBody x) (const 1)
  ACap x -> do
    let d = capDisk x
        c = capCurvature x
        n = unitAlong (planeNormal (diskPlane d))
        depth r = signum c * (sqrt (max 0 (c * c - r * r)) - sqrt (max 0 (c * c - diskRadius d * diskRadius d)))
    e <- acrossTo n
    f <- oneof [elements [0, 1], aboutOne, choose (0, 1)]
    let r = f * diskRadius d
    pure (Target (planePosition (diskPlane d) + r *^ e + depth r *^ n) (diskRadius d) [n, e, cross n e, (c - signum c * depth 0 + depth r) *^ e - r *^ n])
  ATorus x -> do
    let n = unitAlong (planeNormal (torusPlane x))
    e <- acrossTo n
    u <- oneof [direction', elements [n, e, negate n, negate e]]
    f <- oneof [pure 1, aboutOne, choose (0, 1)]
    pure (Target (planePosition (torusPlane x) + torusMajor x *^ e + (f * torusMinor x) *^ u) (torusMajor x + torusMinor x) [n, e, cross n e, cross u e, u])
  ACube _ -> inBox
  ATransformed _ _ -> inBox
  where
    inBox = case ofShape shape of
      Nothing -> pure (Target 0 1 [V3 1 0 0])
      Just b -> do
        target <- sequenceA ((\l h -> (\f -> l + f * (h - l)) <$> choose (0, 1)) <$> boxLow b <*> boxHigh b)
        pure (Target target (modulus (boxHigh b - boxLow b)) [V3 1 0 0, V3 0 1 0, V3 0 0 1])
    aboutOne = (\e s -> 1 + s * scaleFloat e 1) <$> chooseInt (-54, -4) <*> elements [1, -1]
    inPlane :: Plane -> [Double] -> Gen Target
    inPlane p radii = do
      let n = unitAlong (planeNormal p)
      e <- acrossTo n
      r <- elements radii
      f <- oneof [elements [0, 1], aboutOne, choose (0, 1)]
      pure (Target (planePosition p + (r * f) *^ e) (maximum radii) [n, e, cross n e])
    onTriangle t = do
      let Corners a b c = trianglePoints t
      f <- choose (0, 1)
      g <- choose (0, 1)
      pure (Target (mix a (mix b c f) (sqrt g)) (distance a b + distance a c) [vector (triangleNormal t), b - a])
    -- At a fraction of the axis, and of the radius there.
    onAxis x wide = do
      let p1 = axisStart (roundAxis x)
          g = axisEnd (roundAxis x) - p1
          radius = roundRadius x
      e <- acrossTo (unitAlong g)
      f <- oneof [elements [0, 1], aboutOne, choose (0, 1), choose (-0.5, 1.5)]
      k <- oneof [elements [0, 1], aboutOne, choose (0, 1)]
      let r = k * radius * wide f
      pure (Target (p1 + f *^ g + r *^ e) (modulus g + radius) [g, e, cross (unitAlong g) e, g - radius *^ e, (radius / modulus g) *^ g + modulus g *^ e])

-- | A vector made unit.
unitAlong :: Vector -> Vector
unitAlong v = maybe v vector (unit v)

-- | A unit vector across another.
acrossTo :: Vector -> Gen Vector
acrossTo n = do
  v <- oneof [direction', elements [V3 1 0 0, V3 0 1 0, V3 0 0 1]]
  case unit (cross n v) of
    Just e | modulus (cross n v) > 0.1 * modulus n -> pure (vector e)
    _ -> acrossTo n

-------------------------------------------------------------------------------
-- Scenes

-- | Shapes as a scene has them, prepared for both.
data Scenery = Scenery {sceneryShapes :: [Shape], sceneryTriangles :: Int, sceneryWorld :: World, sceneryPlain :: [Prepared], sceneryObvious :: [Obvious]}

-- | Shapes of all sorts, more than are tried one after the other, some of them twice; and meshes that are scaled,
-- turned and moved. A mesh is its triangles in the plain list.
scenery :: Manner -> Int -> Gen Scenery
scenery manner n = do
  kind <- kindInScenes manner
  first <- vectorOf n ((elements [minBound ..] >>= shapeOf manner kind) `suchThat` (not . isNeedle))
  twice <- chooseInt (0, n `div` 4) >>= \k -> take k <$> shuffle first
  own <- shuffle (first ++ twice)
  meshes <- chooseInt (0, 2) >>= (`vectorOf` ((,) <$> oneof [aMesh kind 1, roundMesh] <*> oneof [pure identity, aTransform manner]))
  let placed (mesh, t) = [if t == identity then shape else ATransformed t shape | Just shape <- map (triangleShape mesh) [0 .. meshSize mesh - 1]]
      library = Library (Vector.fromList [Content [Faces mesh] finishes | (mesh, _) <- meshes]) [Instance i t | (i, (_, t)) <- zip [0 ..] meshes]
      shapes = own ++ concatMap placed meshes
  pure (Scenery shapes (length shapes - length own) (world mempty library (sceneOf own)) (mapMaybe prepare shapes) (map obvious shapes))
  where
    finishes = Vector.singleton (withPictures (const Nothing) (finish standard))

-- | A triangle with an angle below 2^-10 or so. Its normal is known to 2^-52 over that angle, so that the parameter of
-- a ray that sees it from the edge may be any: even one whose point is outside of the triangle's box, which the plain
-- list takes and an index does not.
isNeedle :: Shape -> Bool
isNeedle shape = case shape of
  ATriangle t -> thin (trianglePoints t)
  ASmoothTriangle t -> thin (trianglePoints (smoothTriangleFlat t))
  ATransformed _ x -> isNeedle x
  _ -> False
  where
    thin (Corners a b c) = or [modulus (cross (q - p) (s - p)) < 2 ** (-10) * distance p q * distance p s | (p, q, s) <- [(a, b, c), (b, c, a), (c, a, b)]]

-- | Not all sizes: the boxes of an index hold what the shapes' rules meet for rays from no farther away than 2^14 times
-- the size of a shape ("Dioptre.Geometry.Bounds", Note [How much larger]).
kindInScenes :: Manner -> Gen Kind
kindInScenes manner = case manner of
  Ordinary -> pure Full
  Adverse -> elements [Few, Full]

-- | A ray that is aimed at one of the shapes.
rayIn :: Manner -> Scenery -> Gen Ray
rayIn manner s = do
  kind <- kindInScenes manner
  (elements (sceneryShapes s) >>= rayAt manner kind) `suchThat` ((< 1024) . modulus . origin)

-- | A scene and some rays in it.
data Crowd = Crowd Scenery [Ray]

instance Show Crowd where
  show (Crowd s rays) = show (sceneryShapes s) <> "\n" <> show rays

-- | So many shapes at least, and so many rays.
crowd :: Manner -> Int -> Int -> Gen Crowd
crowd manner n count = scenery manner n >>= \s -> Crowd s <$> vectorOf count (rayIn manner s)

-------------------------------------------------------------------------------
-- The plain list

-- | What is met first of all shapes, each of which is tried in turn.
closestOfAll :: [Prepared] -> Ray -> Maybe (Double, Int)
closestOfAll shapes r = foldl' nearer Nothing (zip [0 ..] shapes)
  where
    nearer best (i, shape) = foldl' (\b t -> if t > 1e-8 && maybe (t < 1 / 0) ((t <) . fst) b then Just (t, i) else b) best (parameters shape r)

-- | What the index finds is what the plain list finds: the same parameter, to the bit, and the same shape.
closestIsTheListsOwn :: Crowd -> Property
closestIsTheListsOwn (Crowd s rays) = conjoin [counterexample (show r) (found s r === closestOfAll (sceneryPlain s) r) | r <- rays]

-- | What is met first, by the index.
found :: Scenery -> Ray -> Maybe (Double, Int)
found s r = met (closest (sceneryWorld s) r (1 / 0))

-------------------------------------------------------------------------------
-- The obvious implementation

-- | A ray meets a shape where the line may meet it, and wherever it must.
agreesWithObvious :: Aimed -> Property
agreesWithObvious aimed = maybe (property True) (`counterexample` False) (disagreement (compared aimed))

-- | A ray and a shape as both see them.
data Comparison = Comparison
  { -- | What is wrong, if anything is.
    disagreement :: Maybe String,
    -- | Every parameter at which the shape is met for certain.
    measured :: [Measured],
    -- | How many parameters there are besides: near rims and tangents.
    undecided :: Int
  }

-- | A parameter, and how far it is from the exact one.
data Measured = Measured
  { -- | The parameter.
    measuredParameter :: Double,
    -- | |t - t*| \/ |t*|, in units of eps.
    relativeError :: Double,
    -- | How many units of eps the parameter is off if each of the numbers that it is made of is off by one of its own.
    -- It is large where the line crosses the surface at a flat angle, or comes from far away.
    condition :: Double
  }
  deriving (Eq, Show)

-- | A shape and a ray compared. (A meeting is as wide as the allowance lets the parameter be off, to either side.)
compared :: Aimed -> Comparison
compared (Aimed shape r) = Comparison wrong clear (length ts - length clear)
  where
    figure = obvious shape (lineOf r)
    expected = meetings figure
    exactly = exactParameters figure
    ts = maybe [] (`parameters` r) (prepare shape)
    wrong
      | Just t <- find (\t -> not (any (holdsIn t) expected)) ts = Just ("met at " <> show t <> ", of " <> told)
      | Just m <- find (\m -> isCertain m && not (any (`holdsIn` m) ts)) expected = Just ("not met in " <> shown m <> ", of " <> told)
      | otherwise = Nothing
    told = show ts <> "; expected " <> intercalate ", " (map shown expected) <> "; exactly " <> show (map fromRational exactly :: [Double])
    shown m = show (fromRational (meetingFrom m) :: Double, fromRational (meetingTo m) :: Double, isCertain m)
    clear =
      [ Measured t (fromRational (abs (toRational t - x) / abs x / eps)) (fromRational ((meetingTo m - meetingFrom m) / (2.5 * allowance * abs x)))
        | m <- expected,
          isCertain m,
          [x] <- [filter (\x -> meetingFrom m <= x && x <= meetingTo m) exactly],
          x /= 0,
          [t] <- [filter (`holdsIn` m) ts]
      ]

holdsIn :: Double -> Meeting -> Bool
holdsIn t m = meetingFrom m <= toRational t && toRational t <= meetingTo m

-- | How near the specification promises the points of a shape to its surface (@geometry.cone.interval@,
-- @geometry.cap.parameters@, @geometry.lens.body@, @geometry.torus.precision@): each parameter with the distance of its
-- point from the surface, and the bound. None of shapes for which it promises something else.
--
-- The point is taken without rounding. N is the way that the ray comes, by its point nearest to the shape's middle, and
-- the size of the shape.
promised :: Aimed -> [(Double, Rational, Rational)]
promised (Aimed shape r) = case shape of
  ACone x ->
    let (p1, g, radius) = spindleOf x
        h = rootBelow (squared g)
        k = radius / h
     in bounds (p1 + g) (h + radius) $ \v ->
          let (z, out) = split (p1 + g) g v
           in (min (abs (out - k * abs z) / rootBelow (1 + k * k)) (abs (z + h)), if k > 32 && abs (inner d g) / h * k > 2 * dSize then dSize * h / abs (inner d g) / 2 ^ (48 :: Int) else (k + 1 / k) / 2 ^ (49 :: Int))
  ACap x ->
    let over = capDisk x
        n = exact (planeNormal (diskPlane over))
        p = exact (planePosition (diskPlane over))
        radius = toRational (diskRadius over)
     in bounds p radius $ \v -> (offSphere p n radius (toRational (capCurvature x)) v, 1 / 2 ^ (48 :: Int))
  ALens x ->
    let (p1, g, radius) = spindleOf (lensBody x)
        l = rootBelow (squared g)
        (c1, c2) = lensCurvatures x
        faces v = [offSphere p1 (negate g) radius (toRational c1) v, offSphere (p1 + g) g radius (toRational c2) v]
     in bounds (p1 + fmap (/ 2) g) (l + radius) $ \v -> (minimum (abs (snd (split p1 g v) - radius) : faces v), (1 + l / radius) / 2 ^ (48 :: Int))
  ATorus x ->
    let n = exact (planeNormal (torusPlane x))
        p = exact (planePosition (torusPlane x))
        major = toRational (torusMajor x)
        minor = toRational (torusMinor x)
     in [ (t, off, bound + n' / 2 ^ (52 :: Int))
          | (t, v, n') <- points p (major + minor),
            let (z, out) = split p n v
                off = minimum [abs (rootBelow ((out + side * major) ^ (2 :: Int) + z * z) - minor) | side <- [1, -1]],
            out > 0,
            let bound = (major + minor) ^ (4 :: Int) / (4 * minor * major * out) / 2 ^ (48 :: Int)
        ]
  _ -> []
  where
    o = exact (origin r)
    d = exact (direction r)
    dSize = rootAbove (squared d)
    ts = maybe [] (`parameters` r) (prepare shape)
    points middle size = [(t, along o d x, (abs t0 + abs (x - t0)) * dSize + size) | t <- ts, let x = toRational t]
      where
        t0 = inner (middle - o) d / squared d
    bounds middle size measure = [(t, off, factor * n) | (t, v, n) <- points middle size, let (off, factor) = measure v]
    spindleOf x = let p1 = exact (axisStart (roundAxis x)) in (p1, exact (axisEnd (roundAxis x)) - p1, toRational (roundRadius x))
    -- Along an axis and across it.
    split p g v = let w = v - p; l = rootBelow (squared g) in (inner w g / l, rootBelow (squared (outer w g)) / l)
    offSphere p n radius c v = abs (rootBelow (squared (v - centre)) - abs c)
      where
        centre = p - fmap (* (signum c * rootBelow ((c * c - radius * radius) / squared n))) n

-- | Points are as near to the surface as the specification promises.
isAsNearAsPromised :: Aimed -> Property
isAsNearAsPromised aimed = conjoin [counterexample (show (t, fromRational off :: Double, fromRational bound :: Double)) (off <= bound) | (t, off, bound) <- promised aimed]

-- | What is closest is a shape where the ray may meet it, and before there is no place where a ray must meet a shape.
--
-- So where the exact closest hit is certain, and no other shape may be met before or within its bounds, it is the same
-- shape, at a parameter within them.
closestIsObvious :: Crowd -> Property
closestIsObvious (Crowd s rays) = conjoin [maybe (property True) (\why -> counterexample (show r <> ": " <> why) False) (closestDisagreement s r) | r <- rays]

closestDisagreement :: Scenery -> Ray -> Maybe String
closestDisagreement s r
  | Just (t, i) <- hit, not (any (\(j, m) -> j == i && holdsIn t m) expected) = Just ("met " <> show (t, i) <> ", where it is not")
  | (j, m) : _ <- missed = Just ("met " <> show hit <> ", not shape " <> show j <> " in " <> show (fromRational (meetingFrom m) :: Double, fromRational (meetingTo m) :: Double))
  | otherwise = Nothing
  where
    hit = found s r
    expected = [(i, m) | (i, o) <- zip [0 :: Int ..] (sceneryObvious s), m <- meetings (o (lineOf r))]
    missed = [(j, m) | (j, m) <- expected, isCertain m, meetingFrom m > toRational (1e-8 :: Double), maybe True ((meetingTo m <) . toRational . fst) hit]

-------------------------------------------------------------------------------
-- What was drawn

-- | What the rays must do.
aimedCorners :: Aimed -> [(String, Bool)]
aimedCorners (Aimed shape r) =
  [ ("it hits", not (null ts)),
    ("it misses", null ts),
    ("it must be met", any isCertain expected),
    ("it may be met, or not", not (all isCertain expected)),
    ("it is transformed", sortOf shape == TransformedSort)
  ]
  where
    ts = maybe [] (`parameters` r) (prepare shape)
    expected = meetings (obvious shape (lineOf r))

-- | What the scenes must reach, of one ray.
crowdCorners :: Crowd -> [(String, Bool)]
crowdCorners (Crowd s rays) =
  [ ("something is met", any (isJust . found s) rays),
    ("nothing is met", any (isNothing . found s) rays),
    ("several shapes at the closest parameter", any several rays),
    ("a triangle of a mesh is met", any (maybe False ((>= length (sceneryShapes s) - sceneryTriangles s) . snd) . found s) rays)
  ]
  where
    several r = maybe False (\(t, _) -> length [() | p <- sceneryPlain s, t `elem` parameters p r] > 1) (found s r)
