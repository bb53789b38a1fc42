-- | Sampling: the fixed points of a pixel, and random numbers that others have published.
module Dioptre.Render.SamplingSpec (spec) where

import Data.Bits (shiftR)
import Data.Word (Word64)
import Dioptre.Render.Sampling
import Laws.View
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "uniform" $ do
    -- The first outputs of SplitMix64 from the state 0, as in the reference implementation (S. Vigna, splitmix64.c)
    -- and in Java's SplittableRandom (0). The state that belongs to the seed 0 is mix 0 = 0.
    it "has SplitMix64's numbers from the state 0" $
      map (uniform 0) [0 .. 4] `shouldBe` map upper [0xE220A8397B1DCDAF, 0x6E789E6AA1B965F4, 0x06C45D188009454F, 0xF88BB8A8724C81EC, 0x1B39896A51A8749B]
    -- Rosetta Code, "Pseudo-random numbers/Splitmix64": the first outputs from the state 1234567. The seed was found
    -- by going through the finaliser backwards (its multipliers have inverses modulo 2^64), outside of this program.
    it "has SplitMix64's numbers from the state 1234567" $
      map (uniform 4860507420001330595) [0 .. 4]
        `shouldBe` map upper [6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431, 16408922859458223821]
    prop "is SplitMix64, computed with integers of any size" uniformIsExact
    prop "is at least 0 and less than 1" uniformIsBelowOne

  describe "offset" $ do
    prop "is the corner that is asked for, or the centre" offsetIsItsCorner
    prop "deals the numbers of the seed out one by one" randomOffsetsAreNumbered
  where
    upper :: Word64 -> Double
    upper z = fromIntegral (z `shiftR` 11) / 9007199254740992
