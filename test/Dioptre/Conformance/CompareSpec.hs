{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Conformance.CompareSpec
  ( spec,
  )
where

import Data.Aeson (Value (..), decode, object, toJSON, (.=))
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isLeft)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isNothing)
import Dioptre.Conformance.Compare
import GHC.Float (castDoubleToWord64, castWord64ToDouble)
import Test.Hspec (Spec, describe, it, shouldBe)
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (NonNegative (..), (===))

spec :: Spec
spec = do
  describe "the names of comparisons" $ do
    it "say how much is allowed" $
      map comparisonNamed ["exact", "set", "ulp:4", "levels:1", "abs:1e-9", "rel:0.5"]
        `shouldBe` map Right [Exact, Unordered, Ulp 4, Levels 1, Absolute 1e-9, Relative 0.5]
    it "are all that there are" $
      filter (not . isLeft . comparisonNamed) ["", "Exact", "exact:", "ulp", "ulp:", "ulp:-1", "ulp:1.5", "abs:", "abs:-1", "abs:NaN", "rel:x", "abs 1"] `shouldBe` []
    it "may stand in an object" $
      (decode "{\"t\":\"ulp:1\",\"p\":{\"x\":\"exact\"}}" >>= either (const Nothing) Just . comparison)
        `shouldBe` Just (ByMember (Map.fromList [("t", Ulp 1), ("p", ByMember (oneMember "x" Exact))]))
  describe "exact" $ do
    it "compares numbers as numbers" $ firstDifference Exact (json "[0,1,100]") (json "[-0.0,1.0,1e2]") `shouldBe` Nothing
    it "tells where" $
      map (firstDifference Exact (json "{\"a\":[1,{\"b\":2}]}") . json) ["{\"a\":[1,{\"b\":3}]}", "{\"a\":[1]}", "{\"a\":[1,{}]}", "{\"a\":[1,{\"b\":2,\"c\":3}]}", "{}", "null"]
        `shouldBe` map Just ["$.a[1].b", "$.a", "$.a[1].b", "$.a[1].c", "$.a", "$"]
    it "tells kinds apart" $
      [(a, b) | a <- kinds, b <- kinds, isNothing (firstDifference Exact (json a) (json b))] `shouldBe` [(a, a) | a <- kinds]
  describe "tolerances" $ do
    prop "ulp:N admits N steps and no more" $ \x (NonNegative n) ->
      let moved k = castWord64ToDouble (castDoubleToWord64 (abs x) + fromIntegral k)
          agrees k = firstDifference (Ulp n) (toJSON (abs x :: Double)) (toJSON (moved (k :: Int)))
       in (agrees n, agrees (n + 1)) === (Nothing, Just "$")
    it "ulp:N counts across zero" $
      -- The smallest numbers on both sides of zero are two steps apart.
      map (\n -> firstDifference (Ulp n) (json "5e-324") (json "-5e-324")) [1, 2] `shouldBe` [Just "$", Nothing]
    it "abs:X is closed" $ map (firstDifference (Absolute 0.5) (json "1") . json) ["1.5", "0.5", "1.5000000000000002"] `shouldBe` [Nothing, Nothing, Just "$"]
    it "rel:X is of the expected number" $
      map (firstDifference (Relative 0.5) (json "-8") . json) ["-4", "-12", "-13", "8"] `shouldBe` [Nothing, Nothing, Just "$", Just "$"]
    it "reach every number inside" $ firstDifference (Absolute 1) (json "{\"a\":[1,[2]],\"b\":\"x\"}") (json "{\"a\":[2,[3]],\"b\":\"x\"}") `shouldBe` Nothing
    it "admit no infinity" $ map (\how -> firstDifference how (json "1e308") (json "1e309")) [Exact, Ulp 1000, Absolute 1e100, Relative 0.9] `shouldBe` replicate 4 (Just "$")
    it "can differ from member to member" $ do
      let how = ByMember (oneMember "t" (Absolute 1))
      firstDifference how (json "{\"t\":1,\"n\":1}") (json "{\"t\":2,\"n\":1}") `shouldBe` Nothing
      firstDifference how (json "{\"t\":1,\"n\":1}") (json "{\"t\":2,\"n\":2}") `shouldBe` Just "$.n"
      firstDifference how (json "[{\"t\":1}]") (json "[{\"t\":2}]") `shouldBe` Nothing
      firstDifference how Null Null `shouldBe` Nothing
  describe "set" $ do
    it "admits any order, and counts" $
      map (firstDifference Unordered (json "[1,2,2]") . json) ["[2,1,2]", "[1,1,2]", "[1,2]", "[2,2,1,1]"] `shouldBe` [Nothing, Just "$", Just "$", Just "$"]
    it "reaches lists inside" $ firstDifference Unordered (json "{\"d\":[{\"a\":1},{\"a\":2}]}") (json "{\"d\":[{\"a\":2},{\"a\":1}]}") `shouldBe` Nothing
  describe "levels" . it "admits bytes that are near" $ do
    -- AAEC is 0 1 2, AQID is 1 2 3, AAED is 0 1 3, AAE= is 0 1.
    map (firstDifference (Levels 1) (String "AAEC") . String) ["AAEC", "AQID", "AAED", "AAE=", "?"] `shouldBe` [Nothing, Nothing, Nothing, Just "$", Just "$"]
    firstDifference (Levels 0) (String "AAEC") (String "AAED") `shouldBe` Just "$"
    firstDifference (Levels 9) (object ["width" .= (1 :: Int)]) (object ["width" .= (2 :: Int)]) `shouldBe` Just "$.width"
  where
    kinds = ["null", "true", "false", "1", "\"1\"", "[1]", "{\"a\":1}", "[]", "{}", "\"\""]
    oneMember = Map.singleton

json :: Lazy.ByteString -> Value
json = fromMaybe (String "the test itself is not JSON") . decode
