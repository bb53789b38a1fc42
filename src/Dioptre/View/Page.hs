{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE TemplateHaskell #-}

-- |
-- Module      : Dioptre.View.Page
-- Description : The files of the page
--
-- They stand in the folder page and are in the program, so that it needs nothing beside it.
module Dioptre.View.Page
  ( pageFile,
  )
where

import Data.ByteString (ByteString)
import Data.FileEmbed (embedDir)
import qualified Data.Map.Strict as Map
import System.FilePath (takeExtension)

-- | The kind and the contents of the file of that name; the page itself is the one without a name.
pageFile :: FilePath -> Maybe (ByteString, ByteString)
pageFile name = (,) <$> kind name' <*> Map.lookup name' pageFiles
  where
    name' = if null name then "index.html" else name

-- | The kind that a file's ending tells.
kind :: FilePath -> Maybe ByteString
kind name = case takeExtension name of
  ".html" -> Just "text/html; charset=utf-8"
  ".css" -> Just "text/css; charset=utf-8"
  ".js" -> Just "text/javascript; charset=utf-8"
  ".svg" -> Just "image/svg+xml"
  _ -> Nothing

-- | All of them, by their names.
pageFiles :: Map.Map FilePath ByteString
pageFiles = Map.fromList $(embedDir "page")
