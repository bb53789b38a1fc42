{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Conformance.ProtocolSpec
  ( spec,
  )
where

import Data.Aeson (Value (..), decode, object, toJSON, (.=))
import Data.Aeson.Encoding (encodingToLazyByteString)
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Dioptre.Conformance.Protocol
import GHC.Float (castWord64ToDouble)
import Test.Hspec (Spec, describe, it, shouldBe)
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (Gen, arbitrary, choose, elements, forAll, listOf, oneof, resize, sized, suchThat, (===))

spec :: Spec
spec = do
  describe "requests" $ do
    it "are an identifier, an operation and its arguments" $
      readRequest "{\"id\":7,\"op\":\"roots.linear\",\"in\":{\"a\":2}}" `shouldBe` Right (Request 7 "roots.linear" (object ["a" .= (2 :: Int)]))
    it "may lack arguments" $ readRequest "{\"id\":0,\"op\":\"start\"}" `shouldBe` Right (Request 0 "start" (Object mempty))
    it "that are malformed are answered without an identifier" $
      [answerId a | Left a <- map readRequest malformed] `shouldBe` map (const Nothing) malformed
    prop "are read as they were written" . forAll json $ \value ->
      forAll (choose (0, 9007199254740991)) $ \name ->
        let r = Request name "scene.check" (Object (Keys.fromList [("x", value)]))
         in readRequest (Lazy.toStrict (writeRequest r)) === Right r
  describe "answers" $ do
    it "are ok, skip or error" $
      map readAnswer ["{\"id\":1,\"ok\":null}", "{\"id\":2,\"skip\":\"no\"}", "{\"error\":\"why\"}"]
        `shouldBe` [Right (Answer (Just 1) (Ok Null)), Right (Answer (Just 2) (Skip "no")), Right (Answer Nothing (Fault "why"))]
    it "are nothing else" $
      [a | Right a <- map readAnswer ["", "[]", "{}", "{\"id\":1}", "{\"id\":1,\"ok\":NaN}", "{\"id\":1,\"ok\":1}}"]] `shouldBe` []
    it "with an identifier that no request can have have none" $
      [answerId a | Right a <- map readAnswer ["{\"id\":1.5,\"ok\":1}", "{\"id\":-1,\"ok\":1}", "{\"id\":\"1\",\"ok\":1}", "{\"id\":1e400,\"ok\":1}", "{\"ok\":1}"]] `shouldBe` replicate 5 Nothing
    prop "are read as they were written" . forAll json $ \value ->
      let a = Answer (Just 3) (Ok value) in readAnswer (Lazy.toStrict (writeAnswer a)) === Right a
  describe "numbers" $ do
    it "are written with few digits" $
      map (encodingToLazyByteString . writeValue . numbered) [1, -0.1, 1e300, 5e-324, 9007199254740991] `shouldBe` ["1", "-0.1", "1.0e300", "5.0e-324", "9007199254740991"]
    it "are rounded to the nearest binary64" $
      -- 2^53 + 1 lies half way between two of them, and the even one is 2^53.
      map (fmap binary64 . decode) ["9007199254740993", "1e400", "-1e400", "true"] `shouldBe` [Just (Just 9007199254740992), Just (Just (1 / 0)), Just (Just (-1 / 0)), Just Nothing]
    modifyMaxSuccess (const 2000) . prop "read back to the same number" . forAll anyFinite $ \x ->
      (decode (encodingToLazyByteString (writeValue (numbered x))) >>= binary64) === Just x
  where
    malformed = ["", "x", "[]", "7", "{\"op\":\"start\"}", "{\"id\":1}", "{\"id\":1,\"op\":2}", "{\"id\":-1,\"op\":\"start\"}", "{\"id\":0.5,\"op\":\"start\"}", "{\"id\":9007199254740992,\"op\":\"start\"}", "{\"id\":\"1\",\"op\":\"start\"}", "{\"id\":1,\"op\":\"start\"", "\xff\xfe"]

numbered :: Double -> Value
numbered = toJSON

anyFinite :: Gen Double
anyFinite = anyNumber `suchThat` (\x -> not (isNaN x || isInfinite x))

-- | Any bits.
anyNumber :: Gen Double
anyNumber = castWord64ToDouble <$> oneof [arbitrary, choose (0, 0x7ff0000000000000), choose (0, 1000)]

json :: Gen Value
json = resize 12 . sized $ \n -> oneof ([pure Null, Bool <$> arbitrary, numbered <$> anyFinite, String . Text.pack <$> listOf (elements "a\"\\\n\1234\x1F600/")] <> [nested n | n > 0])
  where
    nested n = oneof [Array . Vector.fromList <$> resize (n `div` 3) (listOf json), Object . Keys.fromList <$> resize (n `div` 3) (listOf ((,) <$> elements ["a", "b", "ok"] <*> json))]
