{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Language
-- Description : The language that the program speaks
--
-- Everything that the program says it says in English or in French, each text beside its translation ('inLanguage').
-- Which of them is decided once, in the rim: an option comes before the configuration, and that before the locale.
-- What programs go by, such as the codes of diagnostics, is the same in both.
module Dioptre.Source.Language
  ( Language (..),
    languageNames,
    fromLocale,
    inLanguage,
  )
where

import Data.List (find)
import Data.Maybe (mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text

-- | The languages of messages.
data Language = English | French
  deriving stock (Eq, Show, Enum, Bounded)

-- | What a configuration or an option may call them.
languageNames :: [(Text, Language)]
languageNames = [("en", English), ("fr", French), ("english", English), ("french", French), ("anglais", English), ("francais", French), ("fran\231ais", French)]

-- | The language of a locale, given a way to look variables up: of LC_ALL, LC_MESSAGES and LANG the first that is set
-- and not empty decides; French where it begins with @fr@.
--
-- >>> fromLocale (`lookup` [("LANG", "fr_CA.UTF-8")])
-- French
--
-- Spec: cli.language.
fromLocale :: (String -> Maybe String) -> Language
fromLocale look = case find (not . null) (mapMaybe look ["LC_ALL", "LC_MESSAGES", "LANG"]) of
  Just locale | isFrench (Text.toLower (Text.pack locale)) -> French
  _ -> English
  where
    isFrench locale = Text.takeWhile (`notElem` ("_.@-" :: String)) locale `elem` ["fr", "french"]

-- | The first text in English, the second in French.
inLanguage :: Language -> a -> a -> a
inLanguage English en _ = en
inLanguage French _ fr = fr
