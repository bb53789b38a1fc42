{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Source.TextSpec
  ( spec,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Source.Text
import Laws.Text
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (UnicodeString (..))

spec :: Spec
spec = modifyMaxSuccess (const 300) $ do
  describe "bytes" $ do
    prop "are UTF-8 where they can be" $ \(SceneText t) -> decodesUtf8 t
    prop "are UTF-8, whatever the characters" $ \(UnicodeString t) -> decodesUtf8 (Text.pack t)
    prop "are Latin-1 where they are not" decodesLatin1
    prop "may begin with a mark, which says nothing" $ \(Noise b) -> skipsTheMark b
    it "have a mark skipped in Latin-1 too, and only once" $ do
      sourceText (decode "a" (Bytes.pack [0xef, 0xbb, 0xbf, 0xe9])) `shouldBe` "\233"
      sourceText (decode "a" (Bytes.pack [0xef, 0xbb, 0xbf, 0xef, 0xbb, 0xbf])) `shouldBe` "\65279"
    it "that are cut inside a character are Latin-1, all of them" $
      sourceText (decode "a" (Bytes.pack [0xc3, 0xa9, 0xc3])) `shouldBe` "\195\169\195"
    it "that encode a surrogate, or too long, are Latin-1" $ do
      sourceText (decode "a" (Bytes.pack [0xed, 0xa0, 0x80])) `shouldBe` "\237\160\128"
      sourceText (decode "a" (Bytes.pack [0xc0, 0xaf])) `shouldBe` "\192\175"
    it "may be none" $ sourceText (decode "a" "") `shouldBe` ""

  describe "lines" $ do
    prop "end at CR LF, at LF or at CR, with the same tree" $ \(SceneText t) -> readsAnyLineEnd t
    it "end once at CR LF, twice at LF CR" $
      sourceText (decode "a" "a\r\nb\n\rc\r\rd") `shouldBe` "a\nb\n\nc\n\nd"
    it "do not end at other characters" $
      sourceText (decode "a" (Text.encodeUtf8 "a\f\v\133\8232b")) `shouldBe` "a\f\v\133\8232b"
    it "are counted from 1, and empty where there are none" $ do
      let source = fromText "a" "one\n\nthree\r\nfour"
      map (lineAt source) [-1 .. 6] `shouldBe` ["", "", "one", "", "three", "four", "", ""]
    it "may be known in part" $ do
      let source = excerpts "a" [(7, "seven"), (2, "two")]
      map (lineAt source) [1, 2, 7, 8] `shouldBe` ["", "two", "seven", ""]

  describe "columns" $ do
    prop "count code points" $ \(SceneText t) -> countsCodePoints t
    it "know the name of the file" $ sourceName (decode "a/b.txt" "x") `shouldBe` "a/b.txt"
