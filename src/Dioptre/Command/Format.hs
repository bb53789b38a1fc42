{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Format
-- Description : Results for persons, and for programs
--
-- What @--format@ says: of @check@, @explain@ and @conform@.
module Dioptre.Command.Format
  ( Format (..),
    formatNames,
  )
where

import Data.Text (Text)

-- | How a result is printed.
data Format
  = -- | In the words of the journal's language.
    AsText
  | -- | As one JSON object, the same in every language but for the texts in it.
    AsJson
  deriving stock (Eq, Show)

-- | What @--format@ may say.
formatNames :: [(Text, Format)]
formatNames = [("text", AsText), ("json", AsJson)]
