-- |
-- Module      : Laws.Triangle
-- Description : What is true of triangles, smooth ones, and meshes of them
module Laws.Triangle
  ( -- * One triangle
    orderOfCornersDoesNotMatter,
    barycentricIsNearExact,
    needlesAreNearExact,
    interpolatedIsNearExact,
    interpolatesCorners,
    collinearCornersAreRefused,

    -- * Closed meshes
    Mesh (..),
    meshTriangles,
    meshIsWatertight,
    meshIsCrossedOnBothSides,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, mapMaybe)
import Dioptre.Geometry.Prepared (parameters)
import Dioptre.Geometry.Ray (Ray, direction, origin, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Triangle
import Dioptre.Math.Vector (Point, Unit, Vector, opposite, unit, vector, (*^))
import Laws.Aim
import Laws.Draw
import Laws.Exact
import Laws.Verdict
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (vector)

-------------------------------------------------------------------------------
-- One triangle

-- | Whether a ray hits a triangle does not depend on the order in which its corners are written, whichever way they
-- turn: the edge functions are the same numbers up to their signs. (As long as the ray is not so nearly in the plane
-- that \<n, d> may come out as zero.)
orderOfCornersDoesNotMatter :: Aimed -> Property
orderOfCornersDoesNotMatter (Aimed shape r) = case shape of
  ATriangle t
    | steep t ->
      let Corners a b c = trianglePoints t
          missed = null (hit t)
       in conjoin [counterexample (show (Corners p q s)) (null (hit u) === missed) | (p, q, s) <- [(b, c, a), (c, a, b), (b, a, c), (a, c, b), (c, b, a)], Just u <- [triangle (Corners p q s)], steep u]
  _ -> property True
  where
    hit t = parameters (preparedOf (ATriangle t)) r
    steep t = crosses (triangleFrame t) r == Just True

-- | The barycentric coordinates of any point are near those that the same formula gives without rounding.
--
-- The three products of edges, and the two with w, have 2 + 3 roundings each; the numerators and D are differences of
-- products of two of them, with 2 more: gamma 12 of the sum of the terms. A quotient q of numbers that err by x and y
-- errs by (x + |q| y) \/ (D - y), and is rounded.
barycentricIsNearExact :: Aimed -> Property
barycentricIsNearExact (Aimed shape r) = case shape of
  ATriangle t -> forAll (oneof [pure (origin r), number Few >>= \k -> pure (origin r + k *^ direction r)]) $ \p ->
    let Corners p0 p1 p2 = trianglePoints t
        w = exact p - exact p0
        s1 = exact p1 - exact p0
        s2 = exact p2 - exact p0
        terms a b = inner (magnitudes a) (magnitudes b)
        d = squared s1 * squared s2 - inner s1 s2 ^ (2 :: Int)
        dError = gamma 12 * (squared s1 * squared s2 + terms s1 s2 ^ (2 :: Int))
        near computed numerator error' =
          let q = numerator / d
              bound = (error' + abs q * dError) / (d - dError)
           in counterexample (show (computed, fromRational q :: Double, fromRational bound :: Double)) $
                abs (toRational computed - q) <= bound + eps * (abs q + bound)
        (t1, t2) = barycentric p0 p1 p2 p
     in d > 2 * dError
          ==> near t1 (inner w s1 * squared s2 - inner w s2 * inner s1 s2) (gamma 12 * (terms w s1 * squared s2 + terms w s2 * terms s1 s2))
          .&&. near t2 (inner w s2 * squared s1 - inner w s1 * inner s1 s2) (gamma 12 * (terms w s2 * squared s1 + terms w s1 * terms s1 s2))
  _ -> property True

-- | In a needle, and in one that is scaled by any power of two, barycentric coordinates are near the exact ones.
--
-- Each component of a cross product has two products and a difference, gamma 2 of its terms, which are at most |a| |b|
-- in sum by their squares: |e| <= 2 gamma 2 |a| |b|. So with s = |n| \/ |s1| |s2| and q = |w| \/ |n|, the product of a
-- cross product and n errs by gamma 3 of both lengths and by their errors, and \<n, n> as well: with x = gamma 9 \/ s,
-- each by at most (2 x + x^2) of |a| |b| |n|, and the quotient by these relative to |w| |s2| |n| and by |t| times those
-- of \<n, n>. Edges and w are exact here, as the needle has few digits.
needlesAreNearExact :: Property
needlesAreNearExact = forAll setting $ \(k, Corners p0 p1 p2, p) ->
  let s1 = exact p1 - exact p0
      s2 = exact p2 - exact p0
      w = exact p - exact p0
      n = outer s1 s2
      nn = squared n
      far a b = rootAbove (squared a * squared b)
      x = gamma 9 * far s1 s2 / rootBelow nn
      near computed numerator edges =
        let t = inner numerator n / nn
            bound = (2 * x + x * x) * (edges / rootBelow nn + abs t) / (1 - 2 * x - x * x)
         in counterexample (show (computed, fromRational t :: Double, fromRational bound :: Double)) $
              abs (toRational computed - t) <= bound + eps * (abs t + bound)
      scaled = fmap (scaleFloat k)
      (t1, t2) = barycentric (scaled p0) (scaled p1) (scaled p2) (scaled p)
   in nn > 0 && 2 * x + x * x < 1 ==> near t1 (outer w s2) (far w s2) .&&. near t2 (outer s1 w) (far s1 w)
  where
    -- Two edges of small whole numbers that differ by a little, and a point in them.
    setting = do
      k <- elements [-400, -250, 0, 0, 0, 250, 320]
      along' <- point Few `suchThat` (/= 0)
      beside <- point Few
      thin <- chooseInt (8, 30)
      let p1 = along'
          p2 = fmap (* 0.5) along' + fmap (scaleFloat (negate thin)) beside
      (i, j) <- (,) <$> chooseInt (0, 8) <*> chooseInt (0, 8)
      pure (k, Corners 0 p1 p2, fmap (* (fromIntegral i / 8)) p1 + fmap (* (fromIntegral j / 8)) p2)

-- | The interpolated normal is parallel to (1 - t1 - t2) N0 + t1 N1 + t2 N2, and points the same way.
--
-- The first factor has two roundings, of 1 + |t1| + |t2| at most; each product one more, and the sums two: e, gamma 5
-- of the terms, in each component. The unit vector adds 1. So with m exact, |n x m| <= |e| + gamma 2 |m|.
interpolatedIsNearExact :: Property
interpolatedIsNearExact = forAll setting $ \(flat, Corners a b c, (t1, t2)) ->
  let x = exact (vector a)
      y = exact (vector b)
      z = exact (vector c)
      s = toRational t1
      t = toRational t2
      m = along (along (fmap ((1 - s - t) *) x) y s) z t
      e = gamma 5 * ((1 + abs s + abs t) * magnitude x + abs s * magnitude y + abs t * magnitude z)
      n = exact (vector (interpolatedNormal flat (Corners a b c) (t1, t2)))
   in counterexample (show (fmap fromRational n :: Vector)) $
        squared (outer n m) <= (1 + gamma 9) * (e + gamma 2 * rootAbove (squared m)) ^ (2 :: Int) && (inner n m > 0 || rootBelow (squared m) <= 2 * e)
  where
    setting = do
      flat <- anyUnit
      normals <- Corners <$> anyUnit <*> anyUnit <*> anyUnit
      t1 <- fraction
      t2 <- (* (1 - t1)) <$> fraction
      pure (flat, normals, (t1, t2))

-- | At its corners a smooth triangle has their normals, and the flat one where they cancel.
interpolatesCorners :: Property
interpolatesCorners = forAll ((,) <$> anyUnit <*> (Corners <$> anyUnit <*> anyUnit <*> anyUnit)) $ \(flat, Corners a b c) ->
  let at = interpolatedNormal flat (Corners a b c)
      -- A unit vector's quadrance is off by 8 eps at most, so made unit again its components move by 4 eps, and two
      -- roundings.
      same n m = counterexample (show (n, m)) (magnitude (exact (vector n) - exact (vector m)) <= 3 * 6 * eps)
   in same (at (0, 0)) a .&&. same (at (1, 0)) b .&&. same (at (0, 1)) c
        .&&. interpolatedNormal flat (Corners a (opposite a) c) (0.5, 0) === flat

-- | A direction, made unit.
anyUnit :: Gen Unit
anyUnit = (unit <$> oneof [step Few, step Full]) `suchThat` isJust >>= maybe discard pure

-- | Corners on one line make no triangle: in integers, for which all is computed exactly.
collinearCornersAreRefused :: Property
collinearCornersAreRefused = forAll setting $ \(Corners a b c) -> triangle (Corners a b c) === Nothing
  where
    setting = do
      a <- point Few
      v <- point Few
      (i, j, k) <- (,,) <$> whole <*> whole <*> whole
      pure (Corners (a + i *^ v) (a + j *^ v) (a + k *^ v))
    whole = fromIntegral <$> chooseInt (-9, 9) :: Gen Double

-------------------------------------------------------------------------------
-- Closed meshes

-- | A closed mesh, a point inside it from where every face is seen from behind, and points that rays from there
-- go to.
data Mesh = Mesh {meshFaces :: [(Point, Point, Point)], meshInside :: Point, meshTargets :: [Point]}
  deriving (Eq, Show)

-- | Its triangles, as shapes.
meshTriangles :: Mesh -> [Shape]
meshTriangles = mapMaybe (\(a, b, c) -> ATriangle <$> triangle (Corners a b c)) . meshFaces

instance Arbitrary Mesh where
  arbitrary = mesh `suchThatMap` id
    where
      mesh = do
        solid <- oneof [pure tetrahedron, pure octahedron, icosahedron, pure box]
        times <- chooseInt (0, 2)
        kind <- elements [Few, Full, Wide]
        centre <- point kind
        size <- elements [1, 1, 16, 1 / 64]
        roughness <- elements [0, 1 / 16, 1 / 4]
        let (corners, faces) = iterate subdivided solid !! times
        moved <- mapM (\v -> (\k -> centre + (size * (1 + roughness * k)) *^ v) . subtract 1 . (* 2) <$> fraction) corners
        let table = Map.fromList (zip [0 :: Int ..] moved)
            faces' = [(table Map.! i, table Map.! j, table Map.! k) | (i, j, k) <- faces]
        inside <- oneof [pure centre, (\v -> centre + (size / 16) *^ v) <$> point Few, (\v -> centre + (size / 4) *^ fmap (/ 16) v) <$> point Full]
        targets <- vectorOf 20 (oneof [elements moved, elements faces' >>= onEdge, elements faces' >>= onEdge, elements faces' >>= onFace, point Full])
        let result = Mesh faces' inside targets
        pure (if inside `notElem` targets && sound result then Just result else Nothing)
      onEdge (a, b, _) = (\f -> a + f *^ (b - a)) <$> fraction
      onFace (a, b, c) = (\f g -> let e = b + f *^ (c - b) in a + g *^ (e - a)) <$> fraction <*> fraction

-- | All faces are triangles, and the inner point is behind every face's plane, by more than rounding: the angle at
-- which a face's corner is seen from there, above the face, has a sine of 2^-20 at least.
sound :: Mesh -> Bool
sound m@(Mesh faces inside _) = length (meshTriangles m) == length faces && all behind faces
  where
    behind (a, b, c) =
      let n = outer (exact b - exact a) (exact c - exact a)
          w = exact inside - exact a
       in inner n w < negate (magnitude n * magnitude w / 2 ^ (20 :: Int))

-- | A ray from inside a closed mesh meets it: whether it goes to a corner, to an edge, or anywhere.
meshIsWatertight :: Mesh -> Property
meshIsWatertight m = conjoin [counterexample (show (r, ts)) (any (> 0) ts) | (r, ts) <- met m]

-- | The line meets the mesh before and behind the point inside.
meshIsCrossedOnBothSides :: Mesh -> Property
meshIsCrossedOnBothSides m = conjoin [counterexample (show (r, ts)) (any (> 0) ts && any (< 0) ts) | (r, ts) <- met m]

-- | The rays from inside, and where they meet the mesh.
met :: Mesh -> [(Ray, [Double])]
met m = [(r, concatMap (`parameters` r) prepared) | target <- meshTargets m, let r = ray (meshInside m) (target - meshInside m)]
  where
    prepared = map preparedOf (meshTriangles m)

type Solid = ([Vector], [(Int, Int, Int)])

tetrahedron, octahedron, box :: Solid
tetrahedron = ([V3 1 1 1, V3 1 (-1) (-1), V3 (-1) 1 (-1), V3 (-1) (-1) 1], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])
octahedron =
  ( [V3 1 0 0, V3 (-1) 0 0, V3 0 1 0, V3 0 (-1) 0, V3 0 0 1, V3 0 0 (-1)],
    [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
  )
box =
  ( [V3 x y z | z <- [-1, 1], y <- [-1, 1], x <- [-1, 1]],
    concat [[(a, b, c), (a, c, d)] | (a, b, c, d) <- [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]]
  )

-- | The icosahedron, whose corners are the cyclic permutations of (0, +-1, +-k), with k the golden section or near it.
icosahedron :: Gen Solid
icosahedron = do
  k <- elements [0.618033988749895, 0.625, 0.6]
  let corners = concat [[V3 0 a (b * k), V3 a (b * k) 0, V3 (b * k) 0 a] | a <- [1, -1], b <- [1, -1]]
      close v w = let q = squared (exact v - exact w) in q > 0 && q < 2
      indexed = zip [0 ..] corners
      faces = [if turnsOut a b c then (i, j, l) else (i, l, j) | (i, a) <- indexed, (j, b) <- indexed, i < j, close a b, (l, c) <- indexed, j < l, close b c, close c a]
      turnsOut a b c = inner (outer (exact b - exact a) (exact c - exact a)) (exact a) > 0
  pure (corners, faces)

-- | Each face cut in four, new corners in the middle of edges, pushed out to where the solid would be round.
subdivided :: Solid -> Solid
subdivided (corners, faces) = (corners ++ [blown (corners !! i) (corners !! j) | (i, j) <- Map.keys middles], concatMap cut faces)
  where
    edges (a, b, c) = [(min i j, max i j) | (i, j) <- [(a, b), (b, c), (c, a)]]
    middles = Map.fromList (zip (Map.keys (Map.fromList [(e, ()) | f <- faces, e <- edges f])) [length corners ..])
    middle i j = middles Map.! (min i j, max i j)
    cut (a, b, c) = let (d, e, f) = (middle a b, middle b c, middle c a) in [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
    blown a b = 0.53125 *^ (a + b)
