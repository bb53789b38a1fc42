-- |
-- Module      : Laws.Index
-- Description : What is true of boxes in boxes
--
-- A hierarchy must offer a ray whatever it may meet, and give each item once. What a ray may meet is decided a second
-- time, box by box, with rational numbers.
module Laws.Index
  ( -- * Drawn things
    Crowd (..),
    crowdHierarchy,
    crowdCorners,
    Offers (..),

    -- * Laws of hierarchies
    holdsEveryItemOnce,
    boxlessComeFirst,
    isAsDeepAsItsTrail,
    isInItsBox,
    offersWhatIsMet,
    offersNothingTwice,
    findsTheNearest,

    -- * Many items
    coincident,
    inALine,
    everFiner,
    aroundACrowd,
    scattered,

    -- * Laws of offers
    offer,
    met,
    offersHaveNoOrder,
    theNearestOfferIsTaken,
  )
where

import Data.List (foldl', nub, sort)
import Data.Maybe (catMaybes, isNothing, listToMaybe)
import Data.Primitive.PrimArray (indexPrimArray, primArrayToList)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Box hiding (around)
import Dioptre.Geometry.Closest
import Dioptre.Geometry.Hierarchy
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Math.Vector (Point)
import Laws.Bounds (exactInterval)
import Laws.Draw
import Linear.V3 (V3 (..))
import Test.QuickCheck hiding (within)

-- | Boxes, some items having none, and a ray that is aimed at one of them.
data Crowd = Crowd [Maybe Box] Ray
  deriving (Eq, Show)

instance Arbitrary Crowd where
  arbitrary = do
    n <- frequency [(1, elements [0, 1, 2, 8, 9]), (8, chooseInt (3, 60)), (1, elements [300, 1000])]
    boxes <- frequency [(4, somewhere n), (1, identical n), (2, nested n), (2, clustered n), (1, inOnePoint n), (2, mixed n)]
    some <- frequency [(2, pure boxes), (1, mapM (\b -> frequency [(1, pure Nothing), (4, pure b)]) boxes)]
    Crowd some <$> rayAmong (catMaybes some)
    where
      somewhere n = anyKind >>= \kind -> vectorOf n (Just <$> boxOf kind)
      identical n = replicate n . Just <$> (anyKind >>= boxOf)
      -- One in the other, each half as large.
      nested n = do
        c <- point Full
        h <- vectorOf3 (positive Few)
        shuffle (take n [Just (around c (scaleFloat (negate i) <$> h)) | i <- cycle [0 .. 200]])
      -- Closer and closer to a point.
      clustered n = do
        c <- oneof [pure 0, point Few]
        sides <- vectorOf n (vectorOf3 (elements [-1, 0, 1]))
        shuffle [Just (around (c + (scaleFloat (negate i) <$> s)) (pure (scaleFloat (-60) 1))) | (i, s) <- zip (cycle [0 .. 50]) sides]
      inOnePoint n = (\c -> replicate n (Just (around c 0))) <$> point Full
      mixed n = do
        k <- chooseInt (0, n)
        parts <- sequence [somewhere k, identical (n - k)]
        shuffle (concat parts)
  shrink (Crowd boxes r) = [Crowd some r | some <- shrinkList (const []) boxes]

vectorOf3 :: Gen a -> Gen (V3 a)
vectorOf3 g = V3 <$> g <*> g <*> g

-- | A box; flat, or a point, at times.
boxOf :: Kind -> Gen Box
boxOf kind = around <$> point kind <*> vectorOf3 (frequency [(1, pure 0), (4, positive kind)])

-- | The box with that middle, reaching so far to each side.
around :: Point -> V3 Double -> Box
around c h = ofPoints (c - h) [c + h]

-- | A ray aimed at a point of one of the boxes, or beside them.
rayAmong :: [Box] -> Gen Ray
rayAmong boxes = do
  kind <- anyKind
  target <- if null boxes then point kind else oneof [elements boxes >>= pointOf, elements boxes >>= pointOf, point kind]
  o <- oneof [point kind, (target +) <$> point kind, pure target, if null boxes then point kind else elements boxes >>= pointOf]
  d <- oneof [pure (target - o), step kind, axisStep kind]
  if d == 0 then rayAmong boxes else pure (ray o d)
  where
    pointOf b = sequenceA (between <$> boxLow b <*> boxHigh b)
    between l h = (\f -> max l (min h (l + f * (h - l)))) <$> fraction

-- | The hierarchy of a crowd.
crowdHierarchy :: Crowd -> Hierarchy
crowdHierarchy (Crowd boxes _) = hierarchyOf boxes

hierarchyOf :: [Maybe Box] -> Hierarchy
hierarchyOf boxes = hierarchy (Vector.length items) (items Vector.!)
  where
    items = Vector.fromList boxes

-- | What was offered by a descent, range by range, from the last; and how many items it says.
data Offers = Offers [[Int]] Int
  deriving (Eq, Show)

-- | What a ray is offered up to a bound.
offered :: Hierarchy -> Ray -> Double -> Offers
offered h r bound = case descend h (approach r) (const bound) (\from end found -> [indexPrimArray (hierarchyOrder h) place | place <- [from .. end - 1]] : found) [] of
  Tried found n -> Offers found n

-- | A crowd's exact answers: the items that have no box, or whose box the ray meets at a parameter from 0 to the bound.
metExactly :: Crowd -> Double -> [Int]
metExactly (Crowd boxes r) bound = [i | (i, b) <- zip [0 ..] boxes, maybe True isMet b]
  where
    isMet b = case exactInterval b r of
      Just (enter, leave) -> leave >= 0 && (isInfinite bound || enter <= toRational bound)
      Nothing -> False

-------------------------------------------------------------------------------
-- Hierarchies

-- | Every item stands exactly once in the order.
holdsEveryItemOnce :: Crowd -> Property
holdsEveryItemOnce c@(Crowd boxes _) = sort (primArrayToList (hierarchyOrder (crowdHierarchy c))) === [0 .. length boxes - 1]

-- | Items without a box stand first, in their order.
boxlessComeFirst :: Crowd -> Property
boxlessComeFirst c@(Crowd boxes _) = take (length boxless) (primArrayToList (hierarchyOrder (crowdHierarchy c))) === boxless
  where
    boxless = [i | (i, b) <- zip [0 ..] boxes, isNothing b]

-- | No item is in more boxes than a trail has bits; there are fewer nodes than twice as many as items with a box, and
-- none if there is none.
isAsDeepAsItsTrail :: Crowd -> Property
isAsDeepAsItsTrail c@(Crowd boxes _) =
  counterexample (show (nodes, depth)) $
    if bounded == 0 then nodes == 0 && depth == 0 else odd nodes && nodes < 2 * bounded && depth >= 1 && depth <= 63 && depth <= (nodes + 1) `div` 2
  where
    h = crowdHierarchy c
    nodes = hierarchyNodes h
    depth = hierarchyDepth h
    bounded = length (catMaybes boxes)

-- | The box of all is the union of the boxes; there is none if an item has none, or there is no item.
isInItsBox :: Crowd -> Property
isInItsBox c@(Crowd boxes _) = hierarchyBox (crowdHierarchy c) === (sequence boxes >>= together)
  where
    together bs = case bs of
      b : rest -> Just (foldl' union b rest)
      [] -> Nothing

-- | Every item that has no box, or whose box the ray meets exactly, not beyond the bound, is offered.
offersWhatIsMet :: Crowd -> Property
offersWhatIsMet c@(Crowd _ r) = forAll (elements [1 / 0, 0, 1, 16]) $ \bound ->
  let Offers found _ = offered (crowdHierarchy c) r bound
   in counterexample (show found) ([i | i <- metExactly c bound, i `notElem` concat found] === [])

-- | No item is offered twice, and as many are counted as are offered; items without a box are offered first.
offersNothingTwice :: Crowd -> Property
offersNothingTwice c@(Crowd boxes r) = forAll (elements [1 / 0, 1]) $ \bound ->
  let Offers found n = offered (crowdHierarchy c) r bound
      all' = concat found
      boxless = [i | (i, b) <- zip [0 ..] boxes, isNothing b]
   in length (nub all') === length all' .&&. n === length all' .&&. take 1 (reverse (map sort found)) === (if null boxless then take 1 (reverse (map sort found)) else [boxless])

-- | If each item is met where the ray comes into its box, and items without a box at 3, then what is found is the
-- nearest of all, and of several at one parameter the first.
findsTheNearest :: Crowd -> Property
findsTheNearest c@(Crowd boxes r) = conjoin [counterexample (show bound) (met (found bound) === listToMaybe (sort [(t, i) | (i, Just t) <- zip [0 ..] ts, t < bound])) | bound <- [1 / 0, 3, 1]]
  where
    h = crowdHierarchy c
    ts = map (maybe (Just 3) enters) boxes
    enters b = case exactInterval b r of
      Just (enter, leave) | leave >= 0 -> Just (fromRational (max 0 enter))
      _ -> Nothing
    parametersOf = Vector.fromList ts
    found bound = case descend h (approach r) within range (below bound) of
      Tried best _ -> best
    range from end best = foldl' (\b i -> maybe b (\t -> offer i t b) (parametersOf Vector.! i)) best [indexPrimArray (hierarchyOrder h) place | place <- [from .. end - 1]]

-- | What the crowds must reach.
crowdCorners :: Crowd -> [(String, Bool)]
crowdCorners c@(Crowd boxes r) =
  [ ("no box at all", null bounded),
    ("some items without a box", any isNothing boxes && not (null bounded)),
    ("all boxes are the same", length bounded > 8 && length (nub (take 20 bounded)) == 1),
    ("a box is a point", or [boxLow b == boxHigh b | b <- bounded]),
    ("a box is flat", or [or ((==) <$> boxLow b <*> boxHigh b) | b <- bounded]),
    ("several boxes are met, and not all", hits > 1 && hits < length boxes),
    ("none is met", hits == 0 && length boxes > 2),
    ("many items", length boxes >= 300),
    ("a deep hierarchy", hierarchyDepth (crowdHierarchy c) > 12),
    ("boxes are passed over", let Offers _ n = offered (crowdHierarchy c) r (1 / 0) in n < length boxes)
  ]
  where
    bounded = catMaybes boxes
    hits = length (metExactly c (1 / 0))

-------------------------------------------------------------------------------
-- Many items

-- | So many times the same box.
coincident :: Int -> Hierarchy
coincident n = hierarchy n (const (Just (around (V3 1 2 3) 1)))

-- | Boxes of size 1 side by side along x, from 0 on.
inALine :: Int -> Hierarchy
inALine n = hierarchy n (\i -> Just (ofPoints (V3 (fromIntegral i) 0 0) [V3 (fromIntegral i + 1) 1 1]))

-- | Boxes that shrink towards the origin, each by a factor.
everFiner :: Double -> Int -> Hierarchy
everFiner factor n = hierarchy n (\i -> let x = factor ^^ negate i in Just (ofPoints (pure x) [pure (x * factor)]))

-- | Sixty boxes along each axis, each 32 times as far from the origin as the one before (so that of the bins between
-- them one takes all others in), around a crowd in the unit cube that has the higher numbers: no choice takes more than
-- a few items away.
aroundACrowd :: Int -> Hierarchy
aroundACrowd n = hierarchy (180 + n) (Just . item)
  where
    item i
      | i < 180 = let (k, a) = i `divMod` 3; x = 32 ^ (k + 1) in around ((axes !! a) x) (pure (x / 100))
      | otherwise = let at k = fractional (fromIntegral i * sqrt k) in around (V3 (at 2) (at 3) (at 5)) 0.01
    axes = [\x -> V3 x 0 0, \x -> V3 0 x 0, V3 0 0]
    fractional x = x - fromIntegral (floor x :: Int) :: Double

-- | Boxes here and there: the multiples of an irrational number, modulo 1.
scattered :: Int -> Hierarchy
scattered n = hierarchy n (\i -> let at k = fractional (fromIntegral i * sqrt k) in Just (around (V3 (at 2) (at 3) (at 5)) 0.001))
  where
    fractional x = x - fromIntegral (floor x :: Int) :: Double

-------------------------------------------------------------------------------
-- Offers

-- | Numbers and parameters that are offered, some at the same parameter.
offers :: Gen [(Int, Double)]
offers = do
  numbers <- sublistOf [0 .. 20] >>= shuffle
  mapM (\n -> (,) n <$> oneof [elements [1, 2, nudged 1 1, 4], positive Wide]) numbers

-- | Offers a shape's number and the parameter at which it is met: it is taken if it precedes what was.
offer :: Int -> Double -> Closest -> Closest
offer i t c
  | precedes t i (closestParameter c) (closestNumber c) = c {closestParameter = t, closestNumber = i}
  | otherwise = c

-- | The parameter and the shape's number, if anything is met.
met :: Closest -> Maybe (Double, Int)
met c
  | closestNumber c < 0 = Nothing
  | otherwise = Just (closestParameter c, closestNumber c)

-- | What is taken does not depend on the order of the offers.
offersHaveNoOrder :: Property
offersHaveNoOrder = forAll offers $ \list -> forAll (shuffle list) $ \other -> forAll (elements [1 / 0, 2]) $ \bound ->
  taken bound list === taken bound other

taken :: Double -> [(Int, Double)] -> Closest
taken bound = foldl' (\c (n, t) -> offer n t c) (below bound)

-- | What is taken is the least parameter below the bound, and of several offers of it the lowest number. 'within' is a
-- bound that lets it in again: two to four doubles above.
theNearestOfferIsTaken :: Property
theNearestOfferIsTaken = forAll offers $ \list -> forAll (elements [1 / 0, 2, 1]) $ \bound ->
  let c = taken bound list
      expected = listToMaybe (sort [(t, n) | (n, t) <- list, t < bound])
   in met c === expected .&&. closestParameter c === maybe bound fst expected .&&. counterexample "within" (closestNumber c < 0 || closestParameter c < within c && within c <= nudged 4 (closestParameter c)) .&&. closestTests (tried 3 (tried 4 c)) === 7
