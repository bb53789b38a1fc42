-- | Light that interferes: grids worked out by hand, and the laws.
module Dioptre.Light.WaveSpec (spec) where

import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Light.Light (Aperture (..), Wave (..))
import Dioptre.Light.Wave
import Laws.Light
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (property)

spec :: Spec
spec = do
  describe "linearOscillators" $ do
    it "stand from the first point to the second" $
      linearOscillators 5 (V3 1 0 0, V3 1 2 (-4)) `shouldBe` [V3 1 0 0, V3 1 0.5 (-1), V3 1 1 (-2), V3 1 1.5 (-3), V3 1 2 (-4)]
    it "are the two points, if two" $ linearOscillators 2 (V3 1 0 0, V3 1 2 (-4)) `shouldBe` [V3 1 0 0, V3 1 2 (-4)]
    it "is the middle, if one" $ linearOscillators 1 (V3 1 0 0, V3 1 2 (-4)) `shouldBe` [V3 1 1 (-2)]
    it "are none, if none" $ linearOscillators 0 (V3 1 0 0, V3 1 2 (-4)) `shouldBe` []
    it "go in equal steps" $ property rowIsEven

  describe "oscillatorGrid" $ do
    -- The step along the shorter side is side / (n - 1); along the longer one there are ceil (side / step) + 1
    it "is n by n for a square" $ map (\n -> oscillatorGrid n (opening 1 1)) [2, 3, 10] `shouldBe` [(2, 2), (3, 3), (10, 10)]
    it "has n along the width of a high opening: 1 x 2.2, in steps of 0.5" $ oscillatorGrid 3 (opening 1 2.2) `shouldBe` (3, 6)
    it "has n along the height of a wide one: 2 x 1, in steps of 0.5" $ oscillatorGrid 3 (opening 2 1) `shouldBe` (5, 3)
    it "counts a last step that is not whole: 2.25 x 1, in steps of 1" $ oscillatorGrid 2 (opening 2.25 1) `shouldBe` (4, 2)
    it "is one for one, whatever the sides" $ oscillatorGrid 1 (opening 5 1) `shouldBe` (1, 1)
    it "is none for none" $ map (\n -> oscillatorGrid n (opening 5 1)) [0, -1] `shouldBe` [(0, 0), (0, 0)]
    it "counts as far as it takes" $ oscillatorGrid 2 (opening 1e-10 1e10) `shouldBe` (2, 100000000000000000001)

  describe "planarOscillators" $ do
    -- Front along z and up along y have right = z x y = -x: from the corner at the right and below, as seen from before
    it "stand column by column, upwards, from the lower left as seen along the front" $
      planarOscillators everywhere (V3 10 20 30) 2 (opening 4 2)
        `shouldBe` [V3 12 19 30, V3 12 21 30, V3 10 19 30, V3 10 21 30, V3 8 19 30, V3 8 21 30]
    it "are told where they stand, from that corner" $
      planarOscillators (\x y -> (x, y) `elem` [(0, 2), (4, 0)]) (V3 10 20 30) 2 (opening 4 2) `shouldBe` [V3 12 21 30, V3 8 19 30]
    it "make up straight, whatever up is" $
      planarOscillators everywhere 0 2 (Aperture 2 2 (V3 0 0 3) (V3 0 5 7)) `shouldBe` planarOscillators everywhere 0 2 (opening 2 2)
    it "is at the position, if one, and the centre is asked" $ do
      planarOscillators (\x y -> (x, y) == (2, 1)) (V3 10 20 30) 1 (opening 4 2) `shouldBe` [V3 10 20 30]
      planarOscillators (\x y -> (x, y) /= (2, 1)) (V3 10 20 30) 1 (opening 4 2) `shouldBe` []
    it "are none, if none, or if it is closed" $
      [planarOscillators everywhere 0 0 (opening 1 1), planarOscillators (\_ _ -> False) 0 9 (opening 1 1)] `shouldBe` [[], []]
    it "make an even grid" $ property gridIsEven

  describe "intensity" $ do
    it "is 0 without sources" $ map (\s -> intensity (Wave 550 s 0) Unboxed.empty (V3 1 2 3)) [1, 2, 3] `shouldBe` [0, 0, 0]
    -- A quarter of a wavelength away the wave stands at 1 at the first instant, and at -1 at the second of two
    it "is the square of the wave itself, for one step and two" $
      [round (1e9 * intensity (Wave 400 s 1) (Unboxed.singleton (0, 0, 0)) (V3 (ways * 400e-9) 0 0)) :: Int | s <- [1, 2, 3], ways <- [0.25, 0.5, 1.125]]
        `shouldBe` [1000000000, 0, 500000000, 1000000000, 0, 500000000, 500000000, 500000000, 500000000]
    prop "one source gives 1/2 everywhere" oneSourceIsAHalf
    modifyMaxSuccess (* 5) $ prop "it is the sum over the instants of a period" intensityIsTheAverage
    prop "it does not depend on the number of instants, from three on" stepsDoNotMatter
    prop "it is from 0 to 1/2, or to 1 for one and two instants" intensityIsBounded
    prop "two slits have bright and dark fringes" slitsHaveFringes
    prop "a row of sources is a grating" gratingHasItsFormula
  where
    opening w h = Aperture w h (V3 0 0 1) (V3 0 1 0)
    everywhere _ _ = True
