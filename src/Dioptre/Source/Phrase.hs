{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Quotation
-- Description : Words of a file and numbers, in messages
module Dioptre.Source.Quotation
  ( quoted,
    number,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text

-- | A piece of a file, in quotation marks; long ones are cut.
quoted :: Text -> Text
quoted t
  | Text.length t > 60 = "'" <> Text.take 57 t <> "...'"
  | otherwise = "'" <> t <> "'"

-- | A whole number.
number :: Int -> Text
number = Text.pack . show
