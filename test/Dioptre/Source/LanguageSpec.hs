{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Source.LanguageSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Dioptre.Source.Language
import Test.Hspec

spec :: Spec
spec = do
  describe "the locale" $ do
    it "is French where it begins with fr" $
      for_ ["fr", "fr_FR", "fr_CA.UTF-8", "fr_BE@euro", "FR_fr", "fr-CH", "french"] $ \l ->
        (l, fromLocale (`lookup` [("LANG", l)])) `shouldBe` (l, French)
    it "is English everywhere else" $
      for_ ["C", "POSIX", "C.UTF-8", "en_US.UTF-8", "de_DE", "fy_NL", "af_ZA"] $ \l ->
        (l, fromLocale (`lookup` [("LANG", l)])) `shouldBe` (l, English)
    it "is English where nothing is said" $ fromLocale (const Nothing) `shouldBe` English
    it "is that of LC_ALL, then LC_MESSAGES, then LANG" $ do
      fromLocale (`lookup` [("LANG", "en_US"), ("LC_MESSAGES", "en_US"), ("LC_ALL", "fr_FR")]) `shouldBe` French
      fromLocale (`lookup` [("LANG", "fr_FR"), ("LC_MESSAGES", "fr_FR"), ("LC_ALL", "C")]) `shouldBe` English
      fromLocale (`lookup` [("LANG", "en_US"), ("LC_MESSAGES", "fr_FR")]) `shouldBe` French
      fromLocale (`lookup` [("LANG", "fr_FR"), ("LC_MESSAGES", "en_US")]) `shouldBe` English
    it "passes over what is set and empty" $
      fromLocale (`lookup` [("LANG", "fr_FR"), ("LC_MESSAGES", ""), ("LC_ALL", "")]) `shouldBe` French
    it "does not look at other variables" $
      fromLocale (`lookup` [("LC_CTYPE", "fr_FR"), ("LANGUAGE", "fr")]) `shouldBe` English

  describe "the names" $
    it "are en and fr, and the languages' own" $
      for_ [("en", English), ("fr", French), ("english", English), ("french", French), ("francais", French), ("anglais", English)] $ \(name, l) ->
        (name, lookup name languageNames) `shouldBe` (name, Just l)

  it "chooses between two texts" $ map (\l -> inLanguage l 'e' 'f') [English, French] `shouldBe` "ef"
