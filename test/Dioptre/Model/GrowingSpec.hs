{-# LANGUAGE RankNTypes #-}

module Dioptre.Model.GrowingSpec
  ( spec,
  )
where

import Control.Monad.ST (ST, runST)
import qualified Data.Vector.Unboxed as Vector
import Dioptre.Model.Growing
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = describe "a growing vector" $ do
  prop "has what was added, in order" $ \(Additions parts) -> grown (`addAll` parts) === concat parts
  prop "has nothing after it is cleared" $ \(Additions parts) (Additions more) ->
    grown (\g -> addAll g parts >> clear g >> addAll g more) === concat more
  prop "is padded up to a size, and never cut" $ \(NonNegative n) xs ->
    grown (\g -> addAll g [xs] >> pad g n 7) === xs <> replicate (n - length xs) 7
  it "grows far" $ grown (`addAll` replicate 5000 [1, 2, 3]) `shouldBe` concat (replicate 5000 [1, 2, 3])
  it "tells what is where" $ runST (newGrowing >>= \g -> addAll g [[1, 2, 3], [4]] >> ((,) <$> at g 3 <*> size g)) `shouldBe` (4, 4)

-- | What is in a vector that has been filled.
grown :: (forall s. Growing s Int -> ST s ()) -> [Int]
grown fill = runST (newGrowing >>= \g -> fill g >> Vector.toList <$> settled g)

-- | Adds numbers, by the function for as many.
addAll :: Growing s Int -> [[Int]] -> ST s ()
addAll g = mapM_ add
  where
    add part = case part of
      [x, y, z] -> push3 g x y z
      [x, y] -> push2 g x y
      _ -> mapM_ (push g) part

-- | Numbers that are added one, two or three at a time.
newtype Additions = Additions [[Int]]
  deriving (Show)

instance Arbitrary Additions where
  arbitrary = Additions <$> resize 1500 (listOf (choose (1, 3) >>= vector))
