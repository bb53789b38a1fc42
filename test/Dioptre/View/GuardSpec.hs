{-# LANGUAGE OverloadedStrings #-}

-- | Who may speak with the viewer.
module Dioptre.View.GuardSpec (spec) where

import Data.Foldable (for_)
import Dioptre.View.Guard
import Test.Hspec

spec :: Spec
spec = do
  describe "a request for a file" $ do
    for_ ["127.0.0.1:8000", "localhost:8000", "LocalHost:8000"] $ \host ->
      it ("is answered under the name " <> show host) $ verdict 8000 (Request (Just host) Nothing False) `shouldBe` Admitted
    for_ [Nothing, Just "", Just "127.0.0.1", Just "127.0.0.1:8001", Just "evil.example:8000", Just "127.0.0.1:8000.evil.example", Just "127.0.0.1.evil.example:8000", Just "[::1]:8000"] $ \host ->
      it ("is refused under the name " <> show host) $ verdict 8000 (Request host Nothing False) `shouldBe` WrongHost
    it "needs no port in the name where that is the usual one" $ verdict 80 (Request (Just "localhost") Nothing False) `shouldBe` Admitted
  describe "a request for a conversation" $ do
    for_ ["http://127.0.0.1:8000", "http://localhost:8000"] $ \origin ->
      it ("is answered for a page from " <> show origin) $ verdict 8000 (Request (Just "127.0.0.1:8000") (Just origin) True) `shouldBe` Admitted
    for_ [Nothing, Just "null", Just "https://127.0.0.1:8000", Just "http://127.0.0.1:8001", Just "http://127.0.0.1", Just "http://evil.example", Just "http://127.0.0.1:8000.evil.example"] $ \origin ->
      it ("is refused for a page from " <> show origin) $ verdict 8000 (Request (Just "127.0.0.1:8000") origin True) `shouldBe` WrongOrigin
    it "is refused under another name, whatever the page" $ verdict 8000 (Request (Just "evil.example:8000") (Just "http://127.0.0.1:8000") True) `shouldBe` WrongHost
