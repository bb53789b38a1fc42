{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Fuzz.Kind
-- Description : What an input is
--
-- Everything that the program reads, one kind for each way to read it. The kind of a file is its ending.
module Fuzz.Kind
  ( Kind (..),
    extension,
    kindOf,
    kindName,
    kindNamed,
  )
where

import Data.Char (toLower)
import Data.List (find)
import System.FilePath (takeExtension)

-- | A way to read a file, or a line.
data Kind
  = -- | A scene.
    SceneFile
  | -- | @configuration.cfg@.
    ConfigurationFile
  | -- | A list of pictures to compare.
    ComparisonList
  | -- | A model in the scene language.
    MsrFile
  | -- | Strokes.
    AgpFile
  | -- | Triangles.
    ObjFile
  | -- | Materials of triangles.
    MtlFile
  | -- | A picture in any format but the next.
    PictureFile
  | -- | A picture that is TGA by its name.
    TargaFile
  | -- | A line of the conformance protocol.
    ProtocolLine
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The ending of files of a kind, with its dot.
extension :: Kind -> String
extension kind = case kind of
  SceneFile -> ".txt"
  ConfigurationFile -> ".cfg"
  ComparisonList -> ".list"
  MsrFile -> ".msr"
  AgpFile -> ".agp"
  ObjFile -> ".obj"
  MtlFile -> ".mtl"
  PictureFile -> ".png"
  TargaFile -> ".tga"
  ProtocolLine -> ".json"

-- | The kind of a file, by its ending; pictures have many.
kindOf :: FilePath -> Maybe Kind
kindOf path
  | ending `elem` [".jpg", ".gif", ".bmp"] = Just PictureFile
  | otherwise = find ((== ending) . extension) [minBound ..]
  where
    ending = map toLower (takeExtension path)

-- | What the command line calls a kind: its ending, without the dot.
--
-- >>> map kindName [SceneFile, TargaFile]
-- ["txt","tga"]
kindName :: Kind -> String
kindName = drop 1 . extension

-- | The kind of that name.
kindNamed :: String -> Maybe Kind
kindNamed name = find ((== map toLower name) . kindName) [minBound ..]
