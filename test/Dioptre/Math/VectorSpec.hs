-- | Vectors: examples, and the laws.
module Dioptre.Math.VectorSpec (spec) where

import Dioptre.Math.Vector
import Laws.Draw (ulpsApart)
import Laws.Vector
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "dot and cross" $ do
    it "multiply the axes as a right-handed frame" $ do
      [dot a b | a <- axes, b <- axes] `shouldBe` [1, 0, 0, 0, 1, 0, 0, 0, 1]
      [cross a b | (a, b) <- zip axes (drop 1 axes ++ axes)] `shouldBe` drop 2 axes ++ take 2 axes
    prop "the inner product is near the exact one" dotIsNearExact
    prop "the inner product is bilinear and symmetric, exactly for integers" dotIsBilinear
    prop "the inner product is additive up to rounding" dotIsBilinearNearly
    prop "the outer product is near the exact one" crossIsNearExact
    prop "the outer product is bilinear, exactly for integers" crossIsBilinear
    prop "the outer product is additive up to rounding" crossIsBilinearNearly
    prop "exchanging its factors turns the outer product round" crossTurnsRound
    prop "the outer product is orthogonal to its factors" crossIsOrthogonal
    prop "Lagrange's identity holds exactly for integers" lagrange
    prop "Lagrange's identity holds up to rounding" lagrangeNearly

  describe "modulus and distance" $ do
    it "measure Pythagorean boxes exactly" $
      map modulus [V3 3 4 0, V3 2 3 6, V3 1 4 8, V3 (-4) 13 16, V3 0 0 (-7)] `shouldBe` [5, 7, 9, 21, 7]
    prop "the modulus is near the length" modulusIsNearExact
    prop "a vector 2^k times as long has a modulus 2^k times as large" modulusScales
    prop "the distance from a to b is the modulus of b - a" distanceIsModulus
    prop "the way back is as long as the way there" distanceIsSymmetric

  describe "unit" $ do
    it "divides by the length" $ fmap vector (unit (V3 0 3 (-4))) `shouldBe` Just (V3 0 0.6 (-0.8))
    it "is absent for the zero vector, -0 or not" $ map unit [0, V3 (-0.0) 0 (-0.0)] `shouldBe` [Nothing, Nothing]
    it "knows the axes" $ do
      map vector [alongX, alongY, alongZ] `shouldBe` axes
      map valid [alongX, alongY, alongZ] `shouldBe` [True, True, True]
      map unit axes `shouldBe` map Just [alongX, alongY, alongZ]
    prop "every other vector has one, and that is valid" unitIsValid
    prop "the unit vector has the vector's direction" unitIsParallel
    prop "a power of two does not change it" unitScales
    prop "the opposite vector has the opposite one" unitOfOpposite
    prop "only the zero vector has none" unitIsAbsent
    it "is tried with vectors of all sizes by these laws" $
      checkCoverage $ \v -> foldr (\(name, holds) -> cover 0.5 holds name) (property True) (vectorCorners v)

  describe "angle" $ do
    -- Multiples of pi/4, whose tangents are exact
    it "knows the angles of the axes and diagonals" $
      [angle (V3 1 0 0) v | v <- [V3 2 0 0, V3 3 3 0, V3 0 0 5, V3 (-7) 0 7, V3 (-2) 0 0]] `shouldBe` [0, pi / 4, pi / 2, 3 * pi / 4, pi]
    it "is 0 where a vector is zero" $ [angle 0 (V3 1 2 3), angle (V3 1 2 3) 0, angle 0 0] `shouldBe` [0, 0, 0]
    -- arctan h = h (1 - h^2/3 + ...), which rounds to h; the textbook's arc cosine says 0
    it "keeps the digits of a small angle" $
      [ulpsApart (angle (V3 1 0 0) (V3 1 h 0)) h | h <- [2 ** (-27), 2 ** (-30), 3e-12, 1e-100]] `shouldSatisfy` all (<= 1)
    -- pi - arctan h, rounded to a multiple of 2^-51
    it "keeps the digits of what an angle lacks to a half turn" $
      [pi - angle (V3 1 0 0) (V3 (-1) h 0) | h <- [2 ** (-27), 2 ** (-30), 3 * 2 ** (-45)]] `shouldBe` [2 ** (-27), 2 ** (-30), 3 * 2 ** (-45)]
    prop "it is exact to 4 units of rounding for integer vectors" angleIsNearExact
    prop "it is the same the other way round" angleIsSymmetric
    prop "it does not depend on the lengths" angleScales
    prop "the angles to a vector and to its opposite add up to pi" anglesSupplement

  describe "packed" $ prop "keeps every bit" packsBackAndForth
  where
    axes = [V3 1 0 0, V3 0 1 0, V3 0 0 1]
