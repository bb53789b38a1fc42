{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Math.QuarticSpec
-- Description : Cubic and quartic roots: examples worked out by other means, and the laws
module Dioptre.Math.QuarticSpec (spec) where

import Dioptre.Math.ExactRoots (exactRoots)
import Dioptre.Math.Quartic (cubicRoots, quarticRoots)
import Dioptre.Math.Touching (mergingBits, mergingPart, residualBits, residualPart)
import Laws.Quartic
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "cubicRoots" $ do
    it "solves (x - 1)(x - 2)(x - 3)" $ cubicRoots 1 (-6) 11 (-6) `shouldBe` [1, 2, 3]
    it "gives a double root twice" $ cubicRoots 1 (-3) 0 4 `shouldBe` [-1, 2, 2]
    it "gives the triple root of x^3 three times" $ map show (cubicRoots (-1) 0 0 0) `shouldBe` ["0.0", "0.0", "0.0"]
    it "gives a triple root that is no double" $ cubicRoots 27 (-27) 9 (-1) `shouldBe` [1 / 3, 1 / 3, 1 / 3]
    describe "of (x - 1)^3 - e (x - 1), with roots 1, 1 +- sqrt e" $ do
      let near e = cubicRoots 1 (-3) (3 - e) (e - 1)
      it "gives one root three times where rounding may have torn it" $ map near [0x1p-51, 0x1p-49, -0x1p-49] `shouldBe` replicate 3 [1, 1, 1]
      it "gives each once where that cannot be, and never four" $ map (length . near) [0x5p-51, 0x3p-50, 0x1p-48] `shouldBe` [3, 3, 3]
      it "gives the only one where the others are complex" $ near (-0x1p-48) `shouldBe` [1]
    it "finds the one root of x^3 - 8" $ cubicRoots 1 0 0 (-8) `shouldBe` [2]
    it "sorts a zero among the others" $ cubicRoots 1 0 (-1) 0 `shouldBe` [-1, 0, 1]
    -- Wallis's equation; 2.09455148154232659148238654057930 (OEIS A007493)
    it "solves x^3 - 2 x - 5" $ cubicRoots 1 0 (-2) (-5) `shouldBe` [2.0945514815423265915]
    -- 2 cos (2 pi / 9), 2 cos (4 pi / 9), 2 cos (8 pi / 9), to 20 digits
    it "solves x^3 - 3 x + 1, irreducible with three roots" $
      cubicRoots 1 0 (-3) 1 `shouldBe` [-1.8793852415718167681, 0.34729635533386069770, 1.5320888862379560704]

  describe "the rule for roots that nearly touch" $
    it "has the same numbers in doubles and in whole numbers" $ do
      [toRational (mergingPart m) | m <- [1, 2, 3]] `shouldBe` [3 / 4 / 2 ^ (mergingBits * (m + 1)) | m <- [1, 2, 3]]
      toRational residualPart `shouldBe` 1 / 2 ^ residualBits

  describe "exactRoots" $ do
    it "solves (x - 1)^2 (x + 2)" $ exactRoots [1, 0, -3, 2] `shouldBe` [-2, 1, 1]
    it "gives the double nearest to a root, of any size" $ exactRoots [0x1p-1000, 0, -0x3p-1000] `shouldBe` [negate (sqrt 3), sqrt 3]
    it "drops a root beyond all doubles" $ exactRoots [0x1p-1000, -0x1p1000 - 0x1p-1000, 0x1p1000] `shouldBe` [1]

  describe "quarticRoots" $ do
    describe "of polynomials with roots known beforehand" $ do
      it "solves (x - 1)(x - 2)(x - 3)(x - 4)" $ quarticRoots 1 (-10) 35 (-50) 24 `shouldBe` [1, 2, 3, 4]
      it "gives two double roots twice each" $ quarticRoots 1 0 (-2) 0 1 `shouldBe` [-1, -1, 1, 1]
      it "gives irrational double roots" $ quarticRoots 1 0 (-4) 0 4 `shouldBe` [negate (sqrt 2), negate (sqrt 2), sqrt 2, sqrt 2]
      it "gives the quadruple root of x^4" $ map show (quarticRoots (-1) 0 0 0 0) `shouldBe` replicate 4 "0.0"
      it "gives a quadruple root elsewhere" $ quarticRoots 1 (-8) 24 (-32) 16 `shouldBe` [2, 2, 2, 2]
      it "gives a quadruple root that is no double" $ quarticRoots 81 (-108) 54 (-12) 1 `shouldBe` replicate 4 (1 / 3)
      it "gives a triple root and another" $ quarticRoots 1 (-5) 6 4 (-8) `shouldBe` [-1, 2, 2, 2]
      it "finds none for x^4 + 1" $ quarticRoots 1 0 0 0 1 `shouldBe` []
      it "falls to the cubic" $ quarticRoots 0 1 (-6) 11 (-6) `shouldBe` [1, 2, 3]
      -- sqrt (5 -+ 2 sqrt 6) = sqrt 3 -+ sqrt 2, to 20 digits
      it "solves x^4 - 10 x^2 + 1" $
        quarticRoots 1 0 (-10) 0 1 `shouldBe` [-3.1462643699419723423, -0.31783724519578224473, 0.31783724519578224473, 3.1462643699419723423]
      -- The least real root of Wilkinson's quartic sibling: x^4 - 4 x^3 + 3 = (x - 1)(x^3 - 3 x^2 - 3 x - 3)
      it "solves x^4 - 4 x^3 + 3" $ take 1 (quarticRoots 1 (-4) 0 0 3) `shouldBe` [1]

    describe "where all four roots, or three, are so near each other that twice the digits do not tell their places" $ do
      -- By Sturm's theorem and bisection in fractions. The second is farther than 2^-20 of its size from the others.
      it "finds each, beside 1" $
        quarticRoots 1 (-4.000121854421538) 6.000365563958283 (-4.000365564651953) 1.000121855115208
          `shouldBe` [1, 1.000001913517245, 1.0000040035423046, 1.0001159373619886]
      it "finds 1, of h (h^3 - 2^-12 h^2 + 2^-30 h - 2^-49), h = x - 1" $
        quarticRoots 1 (-4.000244140625) 6.000732422806323 (-4.000732423737647) 1.0002441415563244 `shouldBe` [1, 1.0002402956524212]
      it "finds 1, of h (h^2 + 2^-24 h + 2^-48)" $
        cubicRoots 1 (-2.9999999403953552) 2.999999880790714 (-0.9999999403953588) `shouldBe` [1]

    describe "of any magnitude" $ do
      it "solves x^4 = 2^2000" $ quarticRoots 0x1p-1000 0 0 0 (-0x1p1000) `shouldBe` [-0x1p500, 0x1p500]
      it "solves 2^1000 x^4 - 1 - 2^-1000 / x by halving" $ length (quarticRoots 0x1p1000 0 0 (-1) (-0x1p-1000)) `shouldBe` 2
      it "drops a root that is too large for a double" $ quarticRoots 0x1p-1074 1 0 0 (-1) `shouldBe` [1]

    it "finds a root that is as far as Cauchy's bound, but for rounding" $
      -- All roots add to -b/a = 24982494165749701.62, the other two to -0.70: it is ...702.33, and doubles here are 4
      -- apart.
      drop 2 (cubicRoots 2.6636193460108317e-8 (-6.654385477149364e8) (-4.677984698546547e8) 1) `shouldBe` [2.4982494165749704e16]

    describe "as laws" $ do
      prop "roots stand in ascending order" isAscending
      prop "roots are finite, and never -0" isClean
      modifyMaxSuccess (* 20) $ do
        prop "there are as many roots as the exact polynomial has (Sturm), but for what passes for a multiple root" isExactInNumber
        prop "a root alone is within 1 ulp of the exact one" isInPlace
        prop "the polynomial vanishes at its roots, up to rounding" hasSmallResidual
        prop "multiplying the coefficients by +-2^m changes no bit" isScaledExactly
        prop "integer roots are found exactly, with their multiplicities" findsIntegerRoots
        prop "double roots are found although the coefficients were rounded" findsTouchingRoots
        prop "roots are found in their places although others are near" findsGatheredRoots
      prop "p(-x) has the opposite roots" isReflected
      prop "as many roots as the degree add to -b/a" hasSum
      prop "a leading coefficient of zero leaves the lower degree" fallsInDegree
      prop "a coefficient that is not finite leaves no roots" refusesNonFinite
      prop "coefficients may be of any size" findsRootsOfAnySize

    it "is tried in all its corners by these laws" $
      checkCoverage $ \p -> foldr (\(name, holds) -> cover 0.1 holds name) (property True) (corners p)
