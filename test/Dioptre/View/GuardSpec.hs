{-# LANGUAGE OverloadedStrings #-}

-- | Who may speak with the viewer.
module Dioptre.View.GuardSpec (spec) where

import Control.Monad (replicateM)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Char8
import Data.Char (isDigit)
import Data.Foldable (for_)
import Data.List (nub)
import Dioptre.View.Guard
import Test.Hspec

spec :: Spec
spec = beforeAll newToken $ do
  describe "a token" $ do
    it "has 32 hexadecimal digits" $ \token -> do
      Char8.length (tokenBytes token) `shouldBe` 32
      Char8.unpack (tokenBytes token) `shouldSatisfy` all (\c -> isDigit c || c `elem` ("abcdef" :: String))
    it "is another one each time" $ \token -> do
      others <- replicateM 1000 newToken
      let all' = map tokenBytes (token : others)
      length (nub all') `shouldBe` length all'
    it "stands behind the # of the address" $ \token -> address token 8000 `shouldBe` "http://127.0.0.1:8000/#token=" <> Char8.unpack (tokenBytes token)
    for_ [("no", const Nothing), ("an empty", const (Just "")), ("a shorter", Just . Char8.init), ("a longer", Just . (<> "0")), ("another", Just . Char8.map (\c -> if c == '0' then '1' else '0')), ("one that differs in its last digit from the", Just . (\t -> Char8.snoc (Char8.init t) (if Char8.last t == '0' then '1' else '0')))] $ \(which, wrong) ->
      for_ [(Data, Nothing), (Conversation, Just "http://127.0.0.1:8000")] $ \(wish, origin) ->
        it ("is wanted for " <> show wish <> ", and not " <> which <> " token") $ \token -> verdict token 8000 (Request (Just "127.0.0.1:8000") origin (wrong (tokenBytes token)) wish) `shouldBe` WrongToken
    it "is not wanted for the page's own files" $ \token -> verdict token 8000 (Request (Just "127.0.0.1:8000") Nothing Nothing PageFile) `shouldBe` Admitted
    it "does not help a page from elsewhere" $ \token -> verdict token 8000 (asking token (Just "127.0.0.1:8000") (Just "http://evil.example") Conversation) `shouldBe` WrongOrigin
  describe "a request for a file" $ do
    for_ ["127.0.0.1:8000", "localhost:8000", "LocalHost:8000"] $ \host ->
      it ("is answered under the name " <> show host) $ \token -> verdict token 8000 (asking token (Just host) Nothing Data) `shouldBe` Admitted
    for_ [Nothing, Just "", Just "127.0.0.1", Just "127.0.0.1:8001", Just "evil.example:8000", Just "127.0.0.1:8000.evil.example", Just "127.0.0.1.evil.example:8000", Just "[::1]:8000"] $ \host ->
      it ("is refused under the name " <> show host) $ \token -> map (verdict token 8000 . asking token host Nothing) [PageFile, Data] `shouldBe` [WrongHost, WrongHost]
    it "needs no port in the name where that is the usual one" $ \token -> verdict token 80 (asking token (Just "localhost") Nothing Data) `shouldBe` Admitted
  describe "a request for a conversation" $ do
    for_ ["http://127.0.0.1:8000", "http://localhost:8000"] $ \origin ->
      it ("is answered for a page from " <> show origin) $ \token -> verdict token 8000 (asking token (Just "127.0.0.1:8000") (Just origin) Conversation) `shouldBe` Admitted
    for_ [Nothing, Just "null", Just "https://127.0.0.1:8000", Just "http://127.0.0.1:8001", Just "http://127.0.0.1", Just "http://evil.example", Just "http://127.0.0.1:8000.evil.example"] $ \origin ->
      it ("is refused for a page from " <> show origin) $ \token -> verdict token 8000 (asking token (Just "127.0.0.1:8000") origin Conversation) `shouldBe` WrongOrigin
    it "is refused under another name, whatever the page" $ \token -> verdict token 8000 (asking token (Just "evil.example:8000") (Just "http://127.0.0.1:8000") Conversation) `shouldBe` WrongHost
  where
    asking :: Token -> Maybe ByteString -> Maybe ByteString -> Wish -> Request
    asking token host origin = Request host origin (Just (tokenBytes token))
