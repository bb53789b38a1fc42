{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Fuzz.Corpus
-- Description : Good inputs to begin with
--
-- The scenes, models and small pictures of the project, the requests of the conformance suite, and the inputs that once
-- failed.
module Fuzz.Corpus
  ( Corpus,
    readCorpus,
    casesFolder,
    filesIn,
  )
where

import Data.Aeson (Value (..), decodeStrict, encode, object, (.=))
import qualified Data.Aeson.KeyMap as Keys
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (sort)
import Data.List.NonEmpty (NonEmpty (..))
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Fuzz.Kind (Kind (..), kindOf)
import System.Directory (doesDirectoryExist, listDirectory)
import System.FilePath (takeExtension, (</>))

-- | Inputs of each kind.
type Corpus = Map Kind (NonEmpty ByteString)

-- | Where inputs stand that once failed, from the project's folder.
casesFolder :: FilePath
casesFolder = "test/fuzz/cases"

-- | The corpus of the project in whose folder the program runs. Files are taken in alphabetical order, so that it is
-- the same everywhere.
readCorpus :: IO Corpus
readCorpus = do
  paths <- concat <$> traverse filesIn ["scenes", "models", "test/fuzz/seeds", casesFolder]
  files <- concat <$> traverse file ("configuration.cfg" : paths)
  vectors <- filesIn "conformance/vectors" >>= traverse Bytes.readFile . filter ((== ".json") . takeExtension)
  let requests = [(ProtocolLine, line) | v <- vectors, line <- requestsOf v]
  pure (Map.fromListWith (<>) [(kind, bytes :| []) | (kind, bytes) <- reverse (files <> requests), Bytes.length bytes < 30000])
  where
    file path = case kindOf path of
      Just kind -> (\bytes -> [(kind, bytes)]) <$> Bytes.readFile path
      Nothing -> pure []

-- | The files in a folder, in alphabetical order; none where there is no such folder.
filesIn :: FilePath -> IO [FilePath]
filesIn folder =
  doesDirectoryExist folder >>= \case
    True -> map (folder </>) . sort <$> listDirectory folder
    False -> pure []

-- | The requests of a file of the suite.
requestsOf :: ByteString -> [ByteString]
requestsOf bytes =
  [ Lazy.toStrict (encode (object ["id" .= (1 :: Int), "op" .= operation, "in" .= input]))
    | Just (Object o) <- [decodeStrict bytes],
      Just operation <- [Keys.lookup "operation" o],
      Just (Array cases) <- [Keys.lookup "cases" o],
      Object c <- toList cases,
      Just input <- [Keys.lookup "in" c]
  ]
