-- | The colours of wavelengths: known values, and the laws.
module Dioptre.Light.WavelengthSpec (spec) where

import Data.Foldable (for_)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Light.Wavelength (colourOfWavelength)
import Laws.Light
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  -- Of the original program, to as many decimals as are known of each
  for_
    [ (550, [0, 0.9999999999999999, 0], 1e-15),
      (450, [0.45454008687355923, 0, 0.9999999999999999], 1e-14),
      (650, [0.8808157068055602, 0, 0], 1e-14),
      (380, [0, 0.0071625747632, 0.0786729045046], 0.5e-13),
      (780, [0, 2.39e-5, 0], 0.5e-7)
    ]
    $ \(l, channels, tolerance) ->
      it ("gives " <> show (l :: Double) <> " nm the colour that it has always had") $ do
        let Colour r g b a = colourOfWavelength l
        zipWith (\x y -> abs (x - y) <= tolerance) [r, g, b] channels `shouldBe` [True, True, True]
        a `shouldBe` 1
  it "goes from violet through green to red" $
    map (largest . colourOfWavelength) [420, 470, 530, 550, 620, 700] `shouldBe` ['b', 'b', 'g', 'g', 'r', 'r']
  modifyMaxSuccess (* 10) $ prop "is what the tables say" matchesTheTables
  modifyMaxSuccess (* 10) $ prop "has channels from 0 to 1, and is never black" channelsAreFractions
  where
    largest (Colour r g b _)
      | r > g && r > b = 'r'
      | g > r && g > b = 'g'
      | b > r && b > g = 'b'
      | otherwise = '-'
