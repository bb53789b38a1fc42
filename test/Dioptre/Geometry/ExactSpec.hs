{-# LANGUAGE TupleSections #-}

-- | Every shape against its obvious implementation, and that against shapes of which everything is known.
module Dioptre.Geometry.ExactSpec (spec) where

import Data.Foldable (for_)
import Data.Maybe (mapMaybe)
import Dioptre.Geometry.Axis (axis, roundShape)
import Dioptre.Geometry.Cap (cap)
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Disk (annulus, disk)
import Dioptre.Geometry.Lens (lens)
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Ray (ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Geometry.Torus (torus)
import Dioptre.Geometry.Triangle (Corners (..), triangle)
import Dioptre.Math.Transform (transform)
import Dioptre.Math.Vector (Vector)
import Laws.Exactness
import Laws.Obvious (Meeting (..), exactParameters, meetings, obvious)
import Laws.Obvious.Motion (lineOf)
import Laws.Obvious.Polynomial
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyArgs, modifyMaxSuccess, prop)
import Test.QuickCheck (Args (..), checkCoverage, cover, elements, forAllBlind, property)
import Test.QuickCheck.Random (mkQCGen)

spec :: Spec
spec = do
  describe "the obvious implementation's polynomials" $ do
    it "have their roots, as often as they are" $
      for_ [[1, 2, 3, 4], [-7, -7, 1 / 3, 1 / 3], [2, 2, 2, 2], [-3, 0, 0, 5 / 7], [1 / 2 ^ (90 :: Int), 1, 1, 2 ^ (40 :: Int)], [-1, 1], [5]] $ \roots ->
        and (zipWith (\x y -> abs (x - y) <= abs y / 2 ^ (100 :: Int)) (map approximately (realRoots (withRoots roots))) roots) `shouldBe` True
    it "have no other ones" $ do
      [length (realRoots (plus (withRoots roots) (constant 1))) | roots <- [[0, 0], [0, 0, 0, 0], [1, 1], [3, 5, 5]]] `shouldBe` [0, 0, 0, 1]
      length (realRoots (constant 0)) `shouldBe` 0
    it "have exact signs at irrational roots" $ do
      -- At 1 + sqrt 2: zero; and off by 2^-300 to either side.
      let tiny = 1 / 2 ^ (300 :: Int)
          p = linear (-1) 1 `times` linear (-1) 1 `minus` constant 2
      [map (`signAt` t) [p, plus p (constant tiny), minus p (constant tiny)] | t <- drop 1 (realRoots p)] `shouldBe` [[0, 1, -1]]
    it "have rational square roots exactly, and others to 2^-250" $ do
      map squareRoot [0, 4 / 9, 2 ^ (200 :: Int), 25 / 4 ^ (100 :: Int)] `shouldBe` [0, 2 / 3, 2 ^ (100 :: Int), 5 / 2 ^ (100 :: Int)]
      abs (squareRoot 2 * squareRoot 2 - 2) < 1 / 2 ^ (248 :: Int) `shouldBe` True

  describe "the obvious implementation" $
    it "meets shapes where they are met by inspection" $
      for_ known $ \(o, d, shape, ts) -> (shape, exactParameters (obvious shape (lineOf (ray o d)))) `shouldBe` (shape, ts)

  modifyArgs (\args -> args {replay = Just (mkQCGen 20, 0)}) $ do
    for_ [(sort, manner) | sort <- [minBound ..], manner <- [Ordinary, Adverse]] $ \(sort, manner) ->
      -- Exactly, these take five milliseconds a ray, and others less than one.
      modifyMaxSuccess (if sort `elem` [LensSort, TorusSort, TransformedSort] then id else (* 3)) $ prop (show sort <> ", " <> show manner <> ", is met where the obvious one is") $ forAllBlind (aimedAt manner sort) agreesWithObvious
    for_ [(sort, manner) | sort <- [ConeSort, LensSort, CapSort, TorusSort], manner <- [Ordinary, Adverse]] $ \(sort, manner) ->
      prop (show sort <> ", " <> show manner <> ", is as near to its surface as promised") $ forAllBlind (aimedAt manner sort) isAsNearAsPromised
    describe "what is drawn" $
      it "comes to all corners" $
        checkCoverage $ forAllBlind (elements [minBound ..] >>= aimedAt Adverse) $ \aimed -> foldr (\(name, holds) -> cover 2 holds name) (property True) (aimedCorners aimed)

  describe "a parameter that is off" $
    it "is seen" $ do
      -- A sphere at the distance 4, met at 3 and 5: the allowance is 64 roundings of (4 + 4)^2 + 1 or less, through the
      -- slope 2.
      let expected = maybe [] (\s -> meetings (obvious (ASphere s) (lineOf (ray 0 (V3 1 0 0))))) (sphere (V3 4 0 0) 1)
      map isCertain expected `shouldBe` [True, True]
      [abs (meetingFrom m - t) < 1e-12 && abs (meetingTo m - t) < 1e-12 | (m, t) <- zip expected [3, 5]] `shouldBe` [True, True]

withRoots :: [Rational] -> Polynomial
withRoots = foldr (\x -> times (linear (negate x) 1)) (constant 1)

-- | Origin, direction, shape, parameters.
known :: [(Vector, Vector, Shape, [Rational])]
known =
  mapMaybe
    (\(o, d, shape, ts) -> (o,d,,ts) <$> shape)
    [ (V3 0 0 8, V3 0 0 (-2), APlane <$> plane 0 (V3 0 0 7), [4]),
      (V3 5 1 0, V3 1 0 0, APlane <$> plane 0 (V3 0 0 1), []),
      (V3 3 4 1, V3 0 0 (-1), flat >>= \p -> ADisk <$> disk p 5, [1]),
      (V3 3 4 1, V3 0 0 (-1), flat >>= \p -> ADisk <$> disk p 4.999999999999999, []),
      (V3 3 4 1, V3 0 0 (-1), flat >>= \p -> AnAnnulus <$> annulus p 5 6, [1]),
      (V3 3 4 1, V3 0 0 (-1), flat >>= \p -> AnAnnulus <$> annulus p 5.000000000000001 6, []),
      (V3 (-3) 1 0, V3 1 0 0, ASphere <$> sphere 0 1, [3, 3]),
      (V3 (-5) 0 0, V3 1 0 0, ASphere <$> sphere (V3 1 0 0) 2, [4, 8]),
      (V3 (-3) 0 (-1), V3 1 0 1, ACube <$> cube 0 2, [2, 2]),
      (V3 (-3) 0 1, V3 1 0 0, ACube <$> cube 0 2, [2, 4]),
      (V3 0.5 0.5 2, V3 0 0 (-1), ATriangle <$> triangle (Corners 0 (V3 1 0 0) (V3 0 1 0)), [2]),
      (V3 0.75 0.5 2, V3 0 0 (-1), ATriangle <$> triangle (Corners 0 (V3 1 0 0) (V3 0 1 0)), []),
      (V3 3 0 2, V3 (-1) 0 0, ATube <$> (axis 0 (V3 0 0 2) >>= (`roundShape` 1)), [2, 4]),
      (V3 (-1) 0 3, V3 1 0 (-1), ATube <$> (axis 0 (V3 0 0 2) >>= (`roundShape` 1)), [2]),
      (V3 3 0 4, V3 (-1) 0 (-1), ACylinder <$> (axis 0 (V3 0 0 2) >>= (`roundShape` 1)), [2, 4]),
      (V3 1 0 (-3), V3 0 0 1, ACylinder <$> (axis 0 (V3 0 0 2) >>= (`roundShape` 1)), [3, 5]),
      (V3 2 0 0.5, V3 (-1) 0 0, ACone <$> (axis 0 (V3 0 0 1) >>= (`roundShape` 1)), [1.5, 2.5]),
      (V3 3 0 1.5, V3 (-1) 0 0, ACone <$> (axis 0 (V3 0 0 1) >>= (`roundShape` 1)), []),
      (V3 0 0 4, V3 0 0 (-1), ACone <$> (axis 0 (V3 0 0 1) >>= (`roundShape` 1)), [3, 4]),
      (V3 (-2) 0 1, V3 1 0 0, ACone <$> (axis 0 (V3 0 0 1) >>= (`roundShape` 1)), [2, 2]),
      (V3 3 0 9, V3 0 0 (-1), ALens <$> (axis 0 (V3 0 0 2) >>= (`roundShape` 4) >>= \b -> lens b (5, 5)), [6, 10]),
      (V3 0 0 (-5), V3 0 0 1, ALens <$> (axis 0 (V3 0 0 4) >>= (`roundShape` 3) >>= \b -> lens b (-5, -5)), [6, 8]),
      (V3 4 0 (-1), V3 (-1) 0 1, ALens <$> (axis 0 (V3 0 0 2) >>= (`roundShape` 3) >>= \b -> lens b (5, 5)), [1, 4]),
      (V3 0 0 6, V3 0 0 (-1), flat >>= \p -> disk p 3 >>= \d -> ACap <$> cap d 5, [5]),
      (V3 0 0 6, V3 0 0 (-1), flat >>= \p -> disk p 3 >>= \d -> ACap <$> cap d (-5), [7]),
      (V3 (-10) 0 0, V3 1 0 0, flat >>= \p -> ATorus <$> torus p 2 1, [7, 9, 11, 13]),
      (V3 (-10) 0 1, V3 1 0 0, flat >>= \p -> ATorus <$> torus p 2 1, [8, 8, 12, 12]),
      (V3 9 0 0, V3 (-1) 0 0, ATransformed <$> transform 2 0 (V3 1 0 0) <*> (ASphere <$> sphere 0 1), [6, 10]),
      (V3 5 0 0, V3 (-1) 0 0, ATransformed <$> transform 1 (V3 90 0 90) 0 <*> (APlane <$> flat), [5])
    ]
  where
    flat = plane 0 (V3 0 0 1)
