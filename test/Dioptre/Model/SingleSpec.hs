{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Model.SingleSpec
  ( spec,
  )
where

import qualified Data.ByteString.Char8 as Char8
import Data.Foldable (for_)
import qualified Data.Text.Encoding as Text
import Dioptre.Model.Single
import Dioptre.Source.Diagnostic (Refusal (..))
import Laws.Single
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = modifyMaxSuccess (const 2000) $ do
  describe "a decimal" $ do
    prop "is the nearest single" isTheNearest
    prop "is the nearest single next to the middle of two" $ forAll middles isTheNearest
    it "is rounded once, not twice" $
      single "1.000000059604644775390626" `shouldBe` Right (1 + 2 ** (-23))
    it "is even in the middle" $ do
      single "16777217" `shouldBe` Right 16777216
      single "16777219" `shouldBe` Right 16777220
    it "may lie below the normal range, or vanish" $ do
      single "1e-45" `shouldBe` Right (2 ** (-149))
      single "1.17549435e-38" `shouldBe` Right (2 ** (-126))
      single "7e-46" `shouldBe` Right 0
      single "1e-999999999999999999999" `shouldBe` Right 0
    it "may be as large as singles are, and no larger" $ do
      single "3.4028235677973366e38" `shouldBe` Right (2 ** 128 - 2 ** 104)
      single "3.4028235677973367e38" `shouldBe` Left (TooLarge "3.4028235677973367e38")
      single "-1e1000000000000000000000" `shouldBe` Left (TooLarge "-1e1000000000000000000000")
    it "has its forms" $
      for_ ["5", "5.", "05.0", "+5", "5e0", "50e-1", ".5e1", "0.05E+2", "5.000000000000000000000000"] $ \t -> (t, single t) `shouldBe` (t, Right 5)
    it "may have very many digits" $ do
      single (Char8.replicate 300000 '0' <> "1." <> Char8.replicate 300000 '0') `shouldBe` Right 1
      single ("0." <> Char8.replicate 300000 '0' <> "1e300001") `shouldBe` Right 1
      single (Char8.replicate 300000 '9' <> "e-300000") `shouldBe` Right 1
  it "is nothing else" $
    for_ ["", "-", ".", "+.", "1e", "1e+", "e1", "1,5", "1.5f", "0x1p0", "NaN", "nan", "Infinity", "inf", "1-1", "--1", "1.2.3", "1/2", " 1", "1 ", "1 2"] $ \t ->
      (t, single t) `shouldBe` (t, Left (NotANumber (Text.decodeUtf8 t)))
  it "is found in the middle of a line" $ do
    let Scanned end x = scan "v -1.5\t2" 2
    (end, x) `shouldBe` (6, -1.5)
    let Scanned end' y = scan "v 1.5x 2" 2
    (end', isNaN y) `shouldBe` (6, True)
