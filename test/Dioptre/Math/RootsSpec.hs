{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}
{-# OPTIONS_GHC -O2 #-}

-- |
-- Module      : Dioptre.Math.RootsSpec
-- Description : Roots: examples worked out by other means, the laws, and the cost
--
-- Optimised, whatever the rest of the tests is, since one of the examples measures what the optimiser leaves to
-- allocate.
module Dioptre.Math.RootsSpec (spec) where

import Control.Exception (evaluate)
import Data.Int (Int64)
import Dioptre.Math.Roots (linearRoots, quadraticRoots)
import GHC.Float (castDoubleToWord64)
import Laws.Roots
import System.Mem (getAllocationCounter, setAllocationCounter)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "linearRoots" $ do
    it "solves 2 x - 3 = 0" $ linearRoots 2 (-3) `shouldBe` [1.5]
    it "has no isolated root where every number is one" $ linearRoots 0 0 `shouldBe` []
    it "has no root where no number is one" $ linearRoots 0 5 `shouldBe` []
    it "gives 0, never -0" $ map show (linearRoots 5 0 ++ linearRoots (-5) 0) `shouldBe` ["0.0", "0.0"]
    it "drops a root that is too large for a double" $ linearRoots 1e-300 1e300 `shouldBe` []

    prop "gives the double nearest to the exact root" linearIsNearest
    prop "gives the same bits when both coefficients are multiplied by +-2^m" linearScales
    prop "gives finite roots, and never -0" linearIsClean

  describe "quadraticRoots" $ do
    describe "of polynomials with roots known beforehand" $ do
      it "solves (x - 1)(x - 2)" $ quadraticRoots 1 (-3) 2 `shouldBe` [1, 2]
      it "gives a double root twice" $ quadraticRoots 1 (-4) 4 `shouldBe` [2, 2]
      it "gives the double root of x^2 twice" $ map show (quadraticRoots (-1) 0 0) `shouldBe` ["0.0", "0.0"]
      it "finds none for x^2 + 1" $ quadraticRoots 1 0 1 `shouldBe` []
      it "gives ascending roots, whatever the sign of the leading coefficient" $
        quadraticRoots (-1) 3 (-2) `shouldBe` [1, 2]
      it "gives 0, never -0" $
        map show (quadraticRoots 1 3 0 ++ quadraticRoots 1 (-3) 0) `shouldBe` ["-3.0", "0.0", "0.0", "3.0"]

      -- (1 + sqrt 5) / 2 = 1.61803398874989484820458683436563811772 (OEIS A001622), to the nearest double
      it "finds the golden ratio" $
        quadraticRoots 1 (-1) (-1) `shouldAllBeNear` [-0.6180339887498948482, 1.6180339887498948482]

      -- 1.00000000000000010000000000000002e-8, computed with 60 decimals, to the nearest double
      it "keeps the digits of a root that the textbook's formula cancels" $
        take 1 (quadraticRoots 1 (-1e8) 1) `shouldBe` [1e-8]

    describe "next to tangency" $ do
      -- Both squares are doubles, and so is twice the product
      it "touches: the square of (2^26 + 1) x - 2^26" $
        quadraticRoots (n * n) (-2 * n * m) (m * m) `shouldBe` [m / n, m / n]
      it "misses when the last coefficient is one ulp more" $ quadraticRoots (n * n) (-2 * n * m) (m * m + 1) `shouldBe` []

      -- The discriminant is 2 n^2, and the roots are (m -+ sqrt (1/2)) / n; computed with 60 decimals
      it "meets twice when the last coefficient is one ulp less" $
        quadraticRoots (n * n) (-2 * n * m) (m * m - 0.5) `shouldAllBeNear` [0.9999999745621271, 0.999999995635551]

      -- Both roots are doubles: -(1 + 2^-51) / 2 and -1/2 have the sum -(1 + 2^-52) and the product 1/4 + 2^-53.
      -- The discriminant is 2^-104, and 0 when computed plainly.
      it "tells two neighbouring doubles apart" $
        quadraticRoots 1 0x1.0000000000001 (0.25 + 0x1p-53) `shouldBe` [-0.5 - 0x1p-52, -0.5]

      -- Kahan, Qdrtcs.pdf: a + b + c = 0, so one root is 1 and the other c/a = 1 + 2.75 / 94906265.625, to 17 digits
      it "solves Kahan's example" $
        quadraticRoots 94906265.625 (-189812534) 94906268.375 `shouldBe` [1, 1.0000000289759583]

      -- Cassini: F(n)^2 - F(n-1) F(n+1) is 1 for odd n and -1 for even n, so the discriminant is 4 or -4. F(78) is
      -- below 2^53.
      it "counts the roots of F(n-1) x^2 + 2 F(n) x + F(n+1), with Fibonacci's numbers" $
        map (length . fibonacci) [74 .. 77] `shouldBe` [0, 2, 0, 2]

    describe "of any magnitude" $ do
      it "solves x^2 - 1, multiplied by the least double" $ quadraticRoots 0x1p-1074 0 (-0x1p-1074) `shouldBe` [-1, 1]
      it "solves 2^-1000 x^2 = 2^1000" $ quadraticRoots 0x1p-1000 0 (-0x1p1000) `shouldBe` [-0x1p1000, 0x1p1000]
      -- Roots of the sum 2^1000 and the product 1, to the nearest double
      it "solves x^2 - 2^1000 x + 1, multiplied by 2^-30" $
        quadraticRoots 0x1p-30 (-0x1p970) 0x1p-30 `shouldBe` [0x1p-1000, 0x1p1000]
      it "solves (x - 1)(x - 2) 2^1020, whose discriminant overflows" $
        quadraticRoots 0x1p1020 (-0x3p1020) 0x1p1021 `shouldBe` [1, 2]

      -- sqrt 3 = 238051250352.6 / 2^37
      it "rounds a subnormal root once" $
        quadraticRoots 0x1p1000 0 (-0x3p-1074) `shouldBe` [-238051250353 * 0x1p-1074, 238051250353 * 0x1p-1074]
      it "keeps the root that a double can hold" $ quadraticRoots 0x1p-1074 1 (-1) `shouldBe` [1]
      it "drops both where neither fits" $ quadraticRoots 0x1p-1074 0 (-0x1p1023) `shouldBe` []

    describe "as laws" $ do
      prop "roots stand in ascending order" isAscending
      prop "roots are finite, and never -0" isClean
      modifyMaxSuccess (* 20) $
        prop "there are as many roots as the exact polynomial has, each within 4 ulp of its own" isExactInNumberAndPlace
      prop "the polynomial vanishes at its roots, up to rounding" hasSmallResidual
      modifyMaxSuccess (* 20) $
        prop "multiplying the coefficients by +-2^m changes no bit" isScaledExactly
      prop "P(-x) has the opposite roots, bit for bit" isReflectedExactly
      prop "reversed coefficients have the reciprocal roots" isInvertedNearly
      prop "two roots multiply to c/a" hasProduct
      prop "two roots add to -b/a" hasSum
      prop "a leading coefficient of zero leaves the linear polynomial" fallsToLinear
      prop "a coefficient that is not finite leaves no roots" refusesNonFinite
      modifyMaxSuccess (* 10) $
        prop "where it is clear at once that there are none, there are none" clearlyNoneIsNone

    it "is tried in all its corners by these laws" $
      checkCoverage $ \q -> foldr (\(name, holds) -> cover 0.1 holds name) (property True) (corners q)

    it "allocates nothing when its list is folded" $ do
      allocatedBy foldedLists >>= (`shouldSatisfy` (< 16 * calls))
      -- and this is how a list that is built shows
      allocatedBy builtLists >>= (`shouldSatisfy` (> 48 * calls))
  where
    n = 2 ^ (26 :: Int) + 1
    m = 2 ^ (26 :: Int)
    fibonacci k = case drop (k - 2) fibonaccis of
      a : b : c : _ -> quadraticRoots a (2 * b) c
      _ -> []
    fibonaccis = 1 : 1 : zipWith (+) fibonaccis (drop 1 fibonaccis)

-- | Within 4 doubles of each other, which is what is promised; for numbers of equal sign.
shouldAllBeNear :: [Double] -> [Double] -> Expectation
shouldAllBeNear actual expected =
  actual `shouldSatisfy` \xs -> length xs == length expected && and (zipWith near xs expected)
  where
    near x y = signum x == signum y && abs (steps x - steps y) <= 4
    steps = toInteger . castDoubleToWord64

calls :: Num a => a
calls = 100000

-- | Bytes allocated by evaluating a function.
allocatedBy :: (Double -> Double) -> IO Int64
allocatedBy f = do
  setAllocationCounter maxBound
  _ <- evaluate (f 1)
  (maxBound -) <$> getAllocationCounter

-- | A sum of nearest roots over polynomials some of which have two roots, some none, as an intersection would find
-- them.
foldedLists :: Double -> Double
foldedLists a = go calls 0
  where
    go :: Int -> Double -> Double
    go 0 !total = total
    go i !total = go (i - 1) (total + nearest (quadraticRoots a (-20) (98 + 4e-5 * fromIntegral i)))
{-# NOINLINE foldedLists #-}

-- | The same, of lists that are made first and consumed afterwards.
builtLists :: Double -> Double
builtLists a = go calls 0
  where
    go :: Int -> Double -> Double
    go 0 !total = total
    go i !total = go (i - 1) (total + nearest (built a (-20) (98 + 4e-5 * fromIntegral i)))
{-# NOINLINE builtLists #-}

built :: Double -> Double -> Double -> [Double]
built = quadraticRoots
{-# NOINLINE built #-}

-- | The least root that lies ahead.
nearest :: [Double] -> Double
nearest roots = foldr (\t continue !best -> if t > 1e-8 && t < best then continue t else continue best) id roots 1000
{-# INLINE nearest #-}
