-- |
-- Module      : Laws.Mesh
-- Description : What is true of meshes
--
-- A mesh is its triangles, each of which is met by the rule of "Dioptre.Geometry.Triangle"; and out of a closed mesh
-- there is no way.
module Laws.Mesh
  ( -- * Meshes
    Meshed (..),
    meshedCorners,
    aMesh,
    meshOf,
    rayAtMesh,

    -- * Laws of meshes
    closestIsAsPlain,
    anyIsWhetherThereIsAClosest,
    trianglesAreShapes,
    preparedTrianglesAreShapes,
    repeatedOnesCostNothing,

    -- * Closed meshes
    Enclosed (..),
    enclosedCorners,
    roundMesh,
    noWayOut,
    everyEdgeIsShared,
  )
where

import Data.Int (Int32)
import Data.List (foldl', nub, sort)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import qualified Data.Vector.Unboxed as Vector
import Dioptre.Geometry.Closest
import Dioptre.Geometry.Hierarchy (hierarchyNodes)
import Dioptre.Geometry.Mesh
import Dioptre.Geometry.Prepared (parameters, prepare)
import Dioptre.Geometry.PreparedMesh
import Dioptre.Geometry.Ray (Ray, direction, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Triangle
import Dioptre.Math.Vector
import Laws.Draw
import Laws.Index (met, offer)
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector, within)

-- | A mesh, and a ray that is aimed at it.
data Meshed = Meshed Mesh Ray
  deriving (Eq, Show)

instance Arbitrary Meshed where
  arbitrary = do
    kind <- elements [Few, Full]
    mesh <- frequency [(3, aMesh kind 4), (1, roundMesh)]
    Meshed mesh <$> rayAtMesh kind mesh

-- | A mesh of triangles, flat or not, over vertices by their numbers.
meshOf :: [Point] -> [(Int, Int, Int)] -> Mesh
meshOf points corners =
  Mesh
    { meshPoints = Vector.fromList (concatMap listed points),
      meshNormals = Vector.empty,
      meshUvs = Vector.empty,
      meshCorners = Vector.fromList (concat [map fromIntegral [a, b, c] | (a, b, c) <- corners]),
      meshCornerNormals = Vector.empty,
      meshCornerUvs = Vector.empty,
      meshFinishes = Vector.replicate (length corners) 0
    }
  where
    listed (V3 x y z) = [x, y, z]

-- | A mesh of any triangles over a few vertices, so that many of them share edges, with normals and texture coordinates
-- or without; its finishes have numbers below the given one.
aMesh :: Kind -> Int -> Gen Mesh
aMesh kind finishes = do
  points <- chooseInt (3, 12) >>= (`vectorOf` point kind)
  corners <- chooseInt (1, 40) >>= (`vectorOf` three (length points))
  let plain = meshOf points (filter (isProper points) corners)
      n = meshSize plain
  if n == 0
    then aMesh kind finishes
    else do
      numbers <- vectorOf n (fromIntegral <$> chooseInt (0, finishes - 1))
      normals <- chooseInt (1, 5) >>= (`vectorOf` frequency [(1, pure 0), (9, step kind)])
      uvs <- chooseInt (1, 5) >>= (`vectorOf` (V2 <$> number kind <*> number kind))
      cornerNormals <- oneof [pure [], vectorOf (3 * n) (attribute (length normals))]
      cornerUvs <- oneof [pure [], vectorOf (3 * n) (attribute (length uvs))]
      pure
        plain
          { meshNormals = Vector.fromList (concat [[x, y, z] | V3 x y z <- normals]),
            meshUvs = Vector.fromList (concat [[u, v] | V2 u v <- uvs]),
            meshCornerNormals = Vector.fromList cornerNormals,
            meshCornerUvs = Vector.fromList cornerUvs,
            meshFinishes = Vector.fromList numbers
          }
  where
    three n = (,,) <$> chooseInt (0, n - 1) <*> chooseInt (0, n - 1) <*> chooseInt (0, n - 1)
    attribute :: Int -> Gen Int32
    attribute n = frequency [(1, pure noAttribute), (4, fromIntegral <$> chooseInt (0, n - 1))]

-- | Whether three of these vertices are a triangle's.
isProper :: [Point] -> (Int, Int, Int) -> Bool
isProper points (a, b, c) = isJust (triangle (Corners (points !! a) (points !! b) (points !! c)))

-- | A ray aimed at a vertex, a point of an edge or a point of a triangle; some along axes, some along edges, some from
-- a point of the mesh.
rayAtMesh :: Kind -> Mesh -> Gen Ray
rayAtMesh kind mesh = do
  Corners a b c <- meshTriangle mesh <$> chooseInt (0, meshSize mesh - 1)
  f <- fraction
  g <- fraction
  target <- elements [a, a + f *^ (b - a), a + f *^ (b - a) + (g * (1 - f)) *^ (c - a)]
  o <- oneof [point kind, (\k d -> target - k *^ d) <$> number kind <*> axisStep Few, pure b, pure target]
  d <- frequency [(4, pure (target - o)), (2, axisStep Few), (1, step kind), (1, pure (b - a)), (1, pure (c + b - 2 *^ a))]
  if d == 0 then rayAtMesh kind mesh else pure (ray o d)

-- | What the meshes and rays must reach.
meshedCorners :: Meshed -> [(String, Bool)]
meshedCorners (Meshed m r) =
  [ ("it hits", not (null hits)),
    ("it misses", null hits),
    ("several triangles at the closest parameter", length (filter ((== fmap fst (first hits)) . Just . fst) hits) > 1),
    ("along an axis", length (filter (/= 0) (foldr (:) [] (direction r))) == 1),
    ("more than a leaf", hierarchyNodes (preparedMeshHierarchy (prepareMesh m)) > 1),
    ("smooth triangles", not (Vector.null (meshCornerNormals m))),
    ("triangles with texture coordinates", not (Vector.null (meshCornerUvs m)))
  ]
  where
    hits = sort [(t, i) | (i, t) <- hitsOf m r]
    first xs = case xs of
      x : _ -> Just x
      [] -> Nothing

-- | All that a ray meets ahead, triangle by triangle, as shapes of their own.
hitsOf :: Mesh -> Ray -> [(Int, Double)]
hitsOf m r = [(i, t) | i <- [0 .. meshSize m - 1], Just shape <- [triangle (meshTriangle m i) >>= prepare . ATriangle], t <- parameters shape r, t > 1e-8]

-------------------------------------------------------------------------------
-- Laws

-- | What is closest is what is closest of all triangles as shapes of their own, to the bit, after whatever was met
-- before; of several at one parameter the one with the lowest number.
closestIsAsPlain :: Meshed -> Property
closestIsAsPlain (Meshed m r) = forAll ((,) <$> elements [0, 7] <*> earlier) $ \(from, before) ->
  let found = closestTriangle (prepareMesh m) from r before
      expected = foldl' (\c (i, t) -> offer (from + i) t c) before hits
   in counterexample (show found) $
        (closestParameter found, closestNumber found) === (closestParameter expected, closestNumber expected)
          .&&. counterexample "tests" (closestTests found <= closestTests before + meshSize m)
  where
    hits = hitsOf m r
    -- A bound; or something at a parameter where a triangle is met too, with a number below, among and above the
    -- triangles'
    earlier = oneof ((below <$> elements ([1 / 0, 4, 1] ++ map snd hits)) : [(\t n -> Closest t n 5) <$> elements (map snd hits) <*> elements [0, 8, 1000] | not (null hits)])

-- | A mesh whose triangles are all there many times over answers as the mesh itself, and tries no more of them.
repeatedOnesCostNothing :: Meshed -> Property
repeatedOnesCostNothing (Meshed m r) = forAll (chooseInt (65, 200)) $ \times ->
  let often :: Vector.Unbox a => Vector.Vector a -> Vector.Vector a
      often v = Vector.concat (replicate times v)
      crowd = prepareMesh m {meshCorners = often (meshCorners m), meshCornerNormals = often (meshCornerNormals m), meshCornerUvs = often (meshCornerUvs m), meshFinishes = often (meshFinishes m)}
      found = closestTriangle crowd 0 r (below (1 / 0))
      alone = closestTriangle (prepareMesh m) 0 r (below (1 / 0))
   in met found === met alone
        .&&. counterexample (show found) (closestTests found <= meshSize m)
        .&&. [preparedTriangle crowd i | i <- [0 .. times * meshSize m - 1]] === concat (replicate times [preparedTriangle (prepareMesh m) i | i <- [0 .. meshSize m - 1]])

-- | Any triangle is met below a bound if there is a closest one.
anyIsWhetherThereIsAClosest :: Meshed -> Property
anyIsWhetherThereIsAClosest (Meshed m r) = conjoin [counterexample (show b) (fst (anyTriangle p r b) === isJust (met (closestTriangle p 0 r (below b)))) | b <- [1 / 0, 1, 1e-8, 0] ++ concat [[t, nudged 1 t] | t <- take 3 (map snd (hitsOf m r))]]
  where
    p = prepareMesh m

-- | Each triangle is the shape with its corners; smooth if any of them has a normal or a texture coordinate. A corner
-- without a normal, or with a zero one, has the flat triangle's; one without texture coordinates has (0, 0).
trianglesAreShapes :: Meshed -> Property
trianglesAreShapes (Meshed m _) = conjoin [counterexample (show i) (triangleShape m i === expected i) | i <- [0 .. meshSize m - 1]]
  where
    expected i = do
      flat <- triangle (Corners (corner i 0) (corner i 1) (corner i 2))
      let ns = [attribute meshCornerNormals i k | k <- [0, 1, 2]]
          ts = [attribute meshCornerUvs i k | k <- [0, 1, 2]]
          normals = [maybe (vector (triangleNormal flat)) (orFlat flat . vertexNormal) n | n <- ns]
          uvs = [maybe (V2 0 0) vertexUv t | t <- ts]
      pure $
        if all null ns && all null ts
          then ATriangle flat
          else ASmoothTriangle (smoothTriangle flat (three (map Just normals)) (three uvs))
    orFlat flat n = if n == 0 then vector (triangleNormal flat) else n
    three list = case list of
      [a, b, c] -> Corners a b c
      _ -> error "not three"
    at list k = Vector.toList list !! k
    corner i k = let v = fromIntegral (at (meshCorners m) (3 * i + k)) in V3 (at (meshPoints m) (3 * v)) (at (meshPoints m) (3 * v + 1)) (at (meshPoints m) (3 * v + 2))
    attribute of' i k
      | Vector.null (of' m) || at (of' m) (3 * i + k) == -1 = Nothing
      | otherwise = Just (fromIntegral (at (of' m) (3 * i + k)))
    vertexNormal n = V3 (at (meshNormals m) (3 * n)) (at (meshNormals m) (3 * n + 1)) (at (meshNormals m) (3 * n + 2))
    vertexUv n = V2 (at (meshUvs m) (2 * n)) (at (meshUvs m) (2 * n + 1))

-- | Each triangle, prepared from the prepared mesh, is its shape, prepared, to the bit; there are no others.
preparedTrianglesAreShapes :: Meshed -> Property
preparedTrianglesAreShapes (Meshed m _) = map (preparedTriangle (prepareMesh m)) [-1 .. meshSize m] === [Nothing] ++ [triangleShape m i >>= prepare | i <- [0 .. meshSize m - 1]] ++ [Nothing]

-------------------------------------------------------------------------------
-- Closed meshes

-- | A closed mesh and a ray that starts inside, aimed at a vertex, at a point of an edge, along an axis, or anywhere.
data Enclosed = Enclosed Mesh Ray
  deriving (Eq, Show)

instance Arbitrary Enclosed where
  arbitrary = do
    (points, corners, inside) <- oneof [star, terrain]
    if all (isProper points) corners
      then do
        o <- inside
        d <- aim points corners o
        if d == 0 then discard else pure (Enclosed (meshOf points corners) (ray o d))
      else discard
    where
      aim points corners o = do
        (a, b, _) <- elements corners
        let p = points !! a
            q = points !! b
        f <- fraction
        d <- frequency [(3, pure (p - o)), (3, pure (p + f *^ (q - p) - o)), (1, axisStep Few), (1, step Full)]
        k <- oneof [pure 1, powerOfTwo (-3) 3]
        pure (k *^ d)

-- | A mesh that every ray from its centre meets once: a cube or an icosahedron, divided and bent or not; its vertices,
-- triangles, and points inside.
star :: Gen ([Point], [(Int, Int, Int)], Gen Point)
star = do
  times <- chooseInt (0, 2)
  (points, corners) <- (\solid -> iterate divided solid !! times) <$> elements [cube, icosahedron]
  bent <- oneof [pure points, mapM bend points, pure (map (\p -> (1 / modulus p) *^ p) points)]
  c <- oneof [pure 0, point Few, point Full]
  s <- oneof [pure 1, V3 <$> positive Few <*> positive Few <*> positive Few]
  let moved = map (\p -> c + s * p) bent
      inside = do
        (i, j, k) <- elements corners
        q <- middle (moved !! i) (moved !! j) (moved !! k)
        f <- oneof [pure 0, choose (0, 0.9)]
        pure (c + f *^ (q - c))
  pure (moved, corners, inside)
  where
    bend p = (\f -> (f / modulus p) *^ p) <$> choose (0.7, 1.3)

-- | A point of a triangle that is not near its edges.
middle :: Point -> Point -> Point -> Gen Point
middle a b c = do
  u <- choose (0.1, 0.4)
  v <- choose (0.1, 0.4)
  pure (a + u *^ (b - a) + v *^ (c - a))

-- | A field of heights over a floor, with walls around it.
terrain :: Gen ([Point], [(Int, Int, Int)], Gen Point)
terrain = do
  n <- chooseInt (1, 4)
  m <- chooseInt (1, 4)
  heights <- vectorOf ((n + 1) * (m + 1)) (oneof [choose (0.5, 2), elements [1, 2]])
  let above i j = i * (m + 1) + j
      below' i j = (n + 1) * (m + 1) + above i j
      points = [V3 (fromIntegral i) (fromIntegral j) (heights !! above i j) | i <- [0 .. n], j <- [0 .. m]] ++ [V3 (fromIntegral i) (fromIntegral j) 0 | i <- [0 .. n], j <- [0 .. m]]
      quad a b c d = [(a, b, c), (a, c, d)]
      tops = concat [quad (above i j) (above (i + 1) j) (above (i + 1) (j + 1)) (above i (j + 1)) | i <- [0 .. n - 1], j <- [0 .. m - 1]]
      floors = concat [quad (below' i j) (below' i (j + 1)) (below' (i + 1) (j + 1)) (below' (i + 1) j) | i <- [0 .. n - 1], j <- [0 .. m - 1]]
      wall (i, j) (i', j') = quad (below' i j) (below' i' j') (above i' j') (above i j)
      walls =
        concat
          ( [wall (i, 0) (i + 1, 0) | i <- [0 .. n - 1]]
              ++ [wall (n, j) (n, j + 1) | j <- [0 .. m - 1]]
              ++ [wall (i + 1, m) (i, m) | i <- [0 .. n - 1]]
              ++ [wall (0, j + 1) (0, j) | j <- [0 .. m - 1]]
          )
      inside = do
        (a, b, c) <- elements tops
        V3 x y z <- middle (points !! a) (points !! b) (points !! c)
        f <- choose (0.1, 0.9)
        pure (V3 x y (f * z))
  pure (points, tops ++ floors ++ walls, inside)

cube, icosahedron :: ([Point], [(Int, Int, Int)])
cube = ([V3 x y z | x <- [-1, 1], y <- [-1, 1], z <- [-1, 1]], concat [[(a, b, c), (a, c, d)] | (a, b, c, d) <- [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]])
icosahedron = (concat [[V3 (-1) g 0, V3 1 g 0, V3 (-1) (-g) 0, V3 1 (-g) 0], [V3 0 (-1) g, V3 0 1 g, V3 0 (-1) (-g), V3 0 1 (-g)], [V3 g 0 (-1), V3 g 0 1, V3 (-g) 0 (-1), V3 (-g) 0 1]], faces)
  where
    g = (1 + sqrt 5) / 2
    faces =
      concat
        [ [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11)],
          [(1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8)],
          [(3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9)],
          [(4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
        ]

-- | Each triangle as four, with shared vertices in the middles of the edges.
divided :: ([Point], [(Int, Int, Int)]) -> ([Point], [(Int, Int, Int)])
divided (points, corners) = (points ++ [0.5 *^ (points !! a + points !! b) | (a, b) <- edges], concatMap four corners)
  where
    edges = nub [(min p q, max p q) | (a, b, c) <- corners, (p, q) <- [(a, b), (b, c), (c, a)]]
    numbers = Map.fromList (zip edges [length points ..])
    half p q = numbers Map.! (min p q, max p q)
    four (a, b, c) = [(a, half a b, half c a), (b, half b c, half a b), (c, half c a, half b c), (half a b, half b c, half c a)]

-- | A closed mesh around the origin, with normals that point away from it and texture coordinates.
roundMesh :: Gen Mesh
roundMesh = do
  solid <- elements [cube, icosahedron]
  times <- chooseInt (0, 2)
  let (points, corners) = iterate divided solid !! times
      plain = meshOf points corners
  uvs <- vectorOf (length points) (V2 <$> choose (0, 1) <*> choose (0, 1))
  pure
    plain
      { meshNormals = meshPoints plain,
        meshUvs = Vector.fromList (concat [[u, v] | V2 u v <- uvs]),
        meshCornerNormals = meshCorners plain,
        meshCornerUvs = meshCorners plain
      }

-- | A ray from inside meets a closed mesh, and something stands in its way.
noWayOut :: Enclosed -> Property
noWayOut (Enclosed m r) = counterexample (show found) (isJust (met found)) .&&. fst (anyTriangle p r (1 / 0)) === True
  where
    p = prepareMesh m
    found = closestTriangle p 0 r (below (1 / 0))

-- | What is drawn is closed: every edge is one of two triangles, which walk it in opposite directions.
everyEdgeIsShared :: Enclosed -> Property
everyEdgeIsShared (Enclosed m _) = sort edges === sort [(b, a) | (a, b) <- edges] .&&. length (nub edges) === length edges
  where
    edges = concat [[(a, b), (b, c), (c, a)] | i <- [0 .. meshSize m - 1], let (a, b, c) = (corner i 0, corner i 1, corner i 2)]
    corner i k = meshCorners m Vector.! (3 * i + k)

-- | What the closed meshes must reach.
enclosedCorners :: Enclosed -> [(String, Bool)]
enclosedCorners (Enclosed m r) =
  [ ("a box of twelve triangles", meshSize m == 12),
    ("many triangles", meshSize m > 100),
    ("two triangles are met at once", length (nub (map fst (filter ((== fmap snd (first hits)) . Just . snd) hits))) > 1),
    ("along an axis", length (filter (/= 0) (foldr (:) [] (direction r))) == 1)
  ]
  where
    hits = [(i, t) | (t, i) <- sort [(t, i) | (i, t) <- hitsOf m r]]
    first xs = case xs of
      x : _ -> Just x
      [] -> Nothing
