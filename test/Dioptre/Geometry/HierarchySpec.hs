-- |
-- Module      : Dioptre.Geometry.HierarchySpec
-- Description : Boxes in boxes: the laws, and crowds of a hundred thousand
module Dioptre.Geometry.HierarchySpec (spec) where

import Control.Exception (bracket_, evaluate)
import Data.Foldable (for_)
import Data.IORef (newIORef, readIORef)
import Data.List (sort)
import Data.Primitive.PrimArray (indexPrimArray, primArrayToList)
import Dioptre.Geometry.Box (approach, box, ofPoints)
import Dioptre.Geometry.Hierarchy
import Dioptre.Geometry.Ray (Ray, ray)
import GHC.Conc (getNumCapabilities, setNumCapabilities)
import Laws.Index
import Linear.V3 (V3 (..))
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "as laws" $
    modifyMaxSuccess (* 3) $ do
      prop "every item stands exactly once in the order" holdsEveryItemOnce
      prop "items without a box come first" boxlessComeFirst
      prop "it is no deeper than a trail is long" isAsDeepAsItsTrail
      prop "its box is the union of the boxes" isInItsBox
      prop "every item that a ray may meet is offered" offersWhatIsMet
      prop "no item is offered twice" offersNothingTwice
      prop "the nearest is found, and of several the first" findsTheNearest

  it "is tried in all its corners by these laws" $
    checkCoverage $ \c -> foldr (\(name, holds) -> cover 1 holds name) (property True) (crowdCorners c)

  -- The example of "Dioptre.Geometry.Partition".
  it "puts four cubes, of which two and two are side by side, into two leaves" $
    [sort (take (end - from) (drop from (primArrayToList (hierarchyOrder fourCubes)))) | (from, end) <- hierarchyLeaves fourCubes] `shouldBe` [[0, 2], [1, 3]]

  -- Areas of boxes are compared, which from 1e154 on are infinite.
  it "keeps what is larger than areas can be apart from the rest" $ do
    let cube size = box (V3 (-size) (-size) (-size)) (V3 size size size)
        h = hierarchy 40 (\i -> if i < 3 then cube (10 ^^ (149 + 70 * i)) else box (V3 (fromIntegral i) 0 0) (V3 (fromIntegral i + 0.5) 1 1))
    take 3 (primArrayToList (hierarchyOrder h)) `shouldBe` [0, 1, 2]
    offeredOf h (ray (V3 7.25 0.5 (-7)) (V3 0 0 2)) `shouldSatisfy` (\items -> all (`elem` items) [0, 1, 2, 7] && length items < 20)

  -- Each takes a fraction of a second; what is quadratic in the number of items takes hours.
  describe "of a hundred thousand boxes, in less than 20 seconds" $ do
    let many = 100000
    it "holds one box so many times, and offers all or none" $ do
      h <- inTime (coincident many)
      sort (primArrayToList (hierarchyOrder h)) `shouldBe` [0 .. many - 1]
      (countOffered h (ray (V3 1 2 0) (V3 0 0 1)), countOffered h (ray (V3 3 2 0) (V3 0 0 1))) `shouldBe` (many, 0)
    it "holds a line of boxes, and finds one of them" $ do
      h <- inTime (inALine many)
      sort (primArrayToList (hierarchyOrder h)) `shouldBe` [0 .. many - 1]
      for_ [0, 1, 4711, 65535, many - 1] $ \i -> do
        let found = offeredOf h (ray (V3 (fromIntegral i + 0.5) 0.5 (-7)) (V3 0 0 2))
        (found, length found) `shouldSatisfy` (\(items, n) -> i `elem` items && n <= 16)
      hierarchyDepth h `shouldSatisfy` (\d -> d >= 14 && d <= 30)
    it "offers all of a line to a ray along it" $ do
      h <- inTime (inALine many)
      countOffered h (ray (V3 (-1) 0.5 0.5) (V3 1 0 0)) `shouldBe` many
    it "holds boxes that shrink towards a point" $
      for_ [everFiner 1.001 many, everFiner 2 1000, everFiner 8 300] $ \h' -> do
        h <- inTime h'
        hierarchyDepth h `shouldSatisfy` (<= 63)
        -- The largest, from (1, 1, 1) on, is item 0
        offeredOf h (ray (V3 1.0005 1.0005 5) (V3 0 0 (-1))) `shouldSatisfy` elem 0

  describe "of boxes of which some are infinite" $
    it "has these as it has items without a box" $ do
      let endless i = case i of
            3 -> [V3 1 1 (1 / 0)]
            50 -> [V3 (-1 / 0) 1 1, V3 1 (1 / 0) 1]
            _ -> []
          h = hierarchy 99 (\i -> Just (ofPoints (V3 (fromIntegral i) 0 0) (V3 (fromIntegral i + 1) 1 1 : endless i)))
      take 2 (primArrayToList (hierarchyOrder h)) `shouldBe` [3, 50]
      sort (primArrayToList (hierarchyOrder h)) `shouldBe` [0 .. 98]
      hierarchyDepth h `shouldSatisfy` (<= 10)

  describe "of a crowd within boxes that are ever farther apart" $
    it "is no deeper than a trail is long, and loses none" $ do
      h <- inTime (aroundACrowd 9000)
      hierarchyDepth h `shouldSatisfy` (<= 63)
      sort (primArrayToList (hierarchyOrder h)) `shouldBe` [0 .. 9179]
      -- Along z at x = 32^k, y = 0 the box of that place is met, whose number is 3 (k - 1)
      for_ [1 .. 60 :: Int] $ \k -> offeredOf h (ray (V3 (32 ^ k) 0 (-1e99)) (V3 0 0 1)) `shouldSatisfy` elem (3 * (k - 1))

  describe "of many boxes" $ do
    it "is the same whether one or two processors build it" $ do
      usual <- getNumCapabilities
      -- Read anew, or else one hierarchy would be shared
      items <- newIORef 40000
      alone <- withProcessors usual 1 (readIORef items >>= evaluate . scattered)
      together <- withProcessors usual 2 (readIORef items >>= evaluate . scattered)
      (alone == together) `shouldBe` True
    it "tells a ray about few of them" $ do
      let n = 40000
          h = scattered n
      -- The boxes are 1/500 wide: a ray through them meets one in some 10^5 or so, and tests what is in a leaf with
      -- each
      countOffered h (ray (V3 0.5 0.5 (-1)) (V3 0.01 0.02 1)) `shouldSatisfy` (< n `div` 50)
  where
    withProcessors usual n = bracket_ (setNumCapabilities n) (setNumCapabilities usual)

-- | Unit cubes at x = 0, 7, 1 and 8.
fourCubes :: Hierarchy
fourCubes = hierarchy 4 (\i -> let x = [0, 7, 1, 8] !! i in box (V3 x 0 0) (V3 (x + 1) 1 1))

-- | Builds within 20 seconds.
inTime :: Hierarchy -> IO Hierarchy
inTime h = timeout 20000000 (evaluate h) >>= maybe (fail "it takes more than 20 seconds") pure

offeredOf :: Hierarchy -> Ray -> [Int]
offeredOf h r = case descend h (approach r) (const (1 / 0)) (\from end found -> [indexPrimArray (hierarchyOrder h) place | place <- [from .. end - 1]] ++ found) [] of
  Tried found _ -> found

countOffered :: Hierarchy -> Ray -> Int
countOffered h r = case descend h (approach r) (const (1 / 0)) (\from end n -> n + (end - from)) 0 of
  Tried n _ -> n
