{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Syntax.ValueSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Diagnostic (Refusal (..))
import Dioptre.Source.Span (Span (..))
import Dioptre.Syntax.Tree (Value (..))
import Dioptre.Syntax.Value
import Laws.Number
import System.Timeout (timeout)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, forAll, listOf, property, (===))
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  describe "a real number" $ do
    modifyMaxSuccess (const 3000) $
      prop "is the double nearest to what is written" $ \(NumberText t) -> realIsNearest t
    it "is tried in all its kinds" $
      checkCoverage . forAll QuickCheck.arbitrary $ \(NumberText t) ->
        foldr (\(name, holds) -> cover 1 holds name) (property True) (kindsOfNumbers t)
    it "may have a point at either end, and a sign" $
      map real ["5.", ".5", "+5", "-.5", "+5.e-1", "05", "-0", "1E2", "1e+2"]
        `shouldBe` map Right [5, 0.5, 5, -0.5, 0.5, 5, 0, 100, 100]
    it "is nothing else" $
      for_ ["", ".", "+", "-", "e5", ".e5", "1e", "1e+", "--1", "+-1", "1.2.3", "1 2", "1,5", "1_000", "0x10", "0x1p3", "1d", "1f", "2.0F", "60degrees", "NaN", "nan", "Infinity", "-Infinity", "inf", "\1633", "\65297", "1e5.0", "1\xA0", "\8722\&1"] $ \t ->
        (t, real t) `shouldBe` (t, Left (NotANumber t))
    it "is at most 1e100, of either sign" $ do
      map real ["1e100", "-1e100", "0.1e101", "1" <> Text.replicate 100 "0"] `shouldBe` map Right [1e100, -1e100, 1e100, 1e100]
      for_ ["1.0001e100", "-1.0001e100", "1e101", "1e308", "1e309", "1e400", "-1e99999999999999999999", Text.replicate 102 "9"] $ \t ->
        (t, real t) `shouldBe` (t, Left (TooLarge t))
    it "rounds a tie to the even neighbour, and by what stands beyond 800 digits" $ do
      -- 2^53 + 1 lies half way between 2^53 and 2^53 + 2; 2^53 + 3 half way between 2^53 + 2 and 2^53 + 4.
      let zeros = "." <> Text.replicate 1000 "0"
      map real ["9007199254740993", "9007199254740993" <> zeros, "9007199254740993" <> zeros <> "1", "9007199254740995", "9007199254740994" <> "." <> Text.replicate 1000 "9"]
        `shouldBe` map Right [9007199254740992, 9007199254740992, 9007199254740994, 9007199254740996, 9007199254740994]
    it "may be as small as it likes" $
      -- Half of the smallest double, 2^-1075 = 2.4703282292062327208...e-324, is the limit.
      map real ["4.9e-324", "2.4703282292062328e-324", "2.4703282292062327e-324", "1e-400", "1e-99999999999999999999", "0e99999999999999999999"]
        `shouldBe` map Right [5.0e-324, 5.0e-324, 0, 0, 0, 0]
    it "of a million characters takes no time" $ do
      let million = 1000000
          long =
            [ (Text.replicate million "9", Left ()),
              ("0." <> Text.replicate million "3", Right (1 / 3)),
              ("0." <> Text.replicate million "0" <> "1e1000001", Right 1),
              ("1" <> Text.replicate million "0" <> "e-1000000", Right 1),
              (Text.replicate million "0" <> "7", Right 7),
              ("1e-" <> Text.replicate million "9", Right 0),
              ("1e" <> Text.replicate million "0" <> "2", Right 100)
            ]
      for_ long $ \(t, wanted) ->
        timeout 1000000 (either (const (Left ())) Right (real t) `shouldBe` wanted) `shouldReturn` Just ()
      timeout 1000000 (integer (Text.replicate million "9") `shouldBe` Left (TooLarge (Text.replicate million "9"))) `shouldReturn` Just ()

  describe "an integer" $ do
    modifyMaxSuccess (const 1000) $
      prop "is a sign and digits, of 32 bits" $ \(IntegerText t) -> integerIsExact t
    it "has 32 bits at most" $ do
      map integer ["2147483647", "-2147483647", "+5", "0005", "-0"] `shouldBe` map Right [2147483647, -2147483647, 5, 5, 0]
      for_ ["2147483648", "-2147483649", "99999999999999999999"] $ \t -> integer t `shouldBe` Left (TooLarge t)
    it "may be the least that there is" $ integer "-2147483648" `shouldBe` Right (-2147483648)
    it "is nothing else" $
      for_ ["", "+", "-", "12.5", "1.", "1e2", "--1", "0x1", "1_0", "\1633", "one", "5pixels"] $ \t -> (t, integer t) `shouldBe` (t, Left (NotAnInteger t))

  describe "a number that is written" $
    modifyMaxSuccess (const 1000) $ do
      prop "reads back as the same number" writtenReadsBack
      prop "has no digit too many" isWrittenShort
      prop "has the nearest digits of as many" isWrittenNearest
      prop "has a point, and an exponent only where it is short of digits or has many" isWrittenPlainly
      it "looks as people expect" $
        map showReal [0.1, 60, 1e-10, -2.5e7, 0, -0.0, 1e7, 9999999, 0.001, 0.00099, 1e100, 1 / 3, 1e23, -8e23, 5e-324]
          `shouldBe` ["0.1", "60.0", "1.0e-10", "-2.5e7", "0.0", "-0.0", "1.0e7", "9999999.0", "0.001", "9.9e-4", "1.0e100", "0.3333333333333333", "1.0e23", "-8.0e23", "5.0e-324"]

  describe "tokens" $ do
    it "stand between blanks, commas and brackets" $
      for_ ["[1, 2, 3]", "(1,2,3)", "<1 2 3>", "1 2 3", " ,1,,2\t\f3 ", "]1[2]3[", "((1)(2)(3))"] $ \t ->
        (t, map tokenText (tokens (Value (Span 1 1 1) t))) `shouldBe` (t, ["1", "2", "3"])
    it "are where they are" $
      map tokenSpan (tokens (Value (Span 7 11 30) "[ 1.5,\t\233x> 3")) `shouldBe` [Span 7 13 16, Span 7 18 20, Span 7 22 23]
    it "may be none" $ tokens (Value (Span 1 1 1) " [,] <()>\t") `shouldBe` []
    it "end at no other character" $
      map tokenText (tokens (Value (Span 1 1 1) "1;2 {3} \"4\" 5\xA0\&6 7\v8")) `shouldBe` ["1;2", "{3}", "\"4\"", "5\xA0\&6", "7\v8"]
    prop "are the pieces between separators" $
      forAll (Text.pack <$> listOf (QuickCheck.elements "ab1,()[]<> \t\f;\233")) $ \t ->
        map tokenText (tokens (Value (Span 1 1 1) t)) === pieces t
  where
    pieces :: Text -> [Text]
    pieces = filter (not . Text.null) . Text.split (`elem` (" \t\f,()[]<>" :: String))
