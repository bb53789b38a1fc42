{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Obj.Materials
-- Description : The names of materials in an OBJ file
--
-- > mtllib house.mtl        materials of house.mtl may be used
-- > usemtl brick            faces from here on are of the material "brick"
--
-- An OBJ file only names its materials. Those that faces use are numbered from 0, in the order of first use; what they
-- are is for the libraries to say (see "Dioptre.Model.Mtl").
module Dioptre.Model.Obj.Materials
  ( Named (..),
    defaultMaterial,
    mostLibraries,

    -- * Reading
    Materials,
    newMaterials,
    useMaterial,
    materialLibrary,
    materialNumber,

    -- * The end
    materialsInUse,
    librariesNamed,
  )
where

import Control.Monad (unless)
import Control.Monad.ST (ST)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.STRef (STRef, modifySTRef', newSTRef, readSTRef, writeSTRef)
import Data.Set (Set)
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Model.Obj.Faults (Faults, keepLine, located, noted, report)
import Dioptre.Model.Obj.Lines (Line (..))
import Dioptre.Model.Words (blanksFrom, isBlank, wordFrom)
import Dioptre.Source.Diagnostic (Expectation (SomeText), Instead (Kept), Problem (RefusedValue, TooManyLibraries), Refusal (NothingThere))
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (characters)

-- | A name, and where it stands.
data Named = Named
  { -- | From its first character to behind its last.
    namedSpan :: !Span,
    -- | The name.
    namedText :: !Text
  }
  deriving stock (Eq, Show)

-- | The material of faces that stand before any @usemtl@.
defaultMaterial :: Text
defaultMaterial = "default"

-- | No model has more material libraries.
--
-- Spec: limits.files.
mostLibraries :: Int
mostLibraries = 100

-- | What has been read so far.
data Materials s = Materials
  { -- | The material of the next face.
    materialsNext :: !(STRef s Material),
    -- | The numbers of the materials in use, by their names as bytes.
    materialsNumbers :: !(STRef s (Map ByteString Int)),
    -- | The materials in use, the last one first.
    materialsNames :: !(STRef s [Named]),
    -- | The libraries, by their names as bytes.
    materialsLibraries :: !(STRef s (Set ByteString)),
    -- | The libraries, the last one first.
    materialsLibraryNames :: !(STRef s [Named])
  }

-- | The material of a face: its number, or how it is named, with the line that does, where no face has used it so far.
data Material
  = Known !Int
  | Fresh !ByteString !Named !Text
  | -- | The one of faces before any @usemtl@, which the first of those names.
    Unnamed

-- | Nothing has been read.
newMaterials :: ST s (Materials s)
newMaterials = Materials <$> newSTRef Unnamed <*> newSTRef Map.empty <*> newSTRef [] <*> newSTRef Set.empty <*> newSTRef []

-- | The number of the material of a face at this place.
materialNumber :: Faults s -> Materials s -> Line -> Int -> ST s Int
materialNumber faults ms line start = do
  material <- readSTRef (materialsNext ms)
  case material of
    Known k -> pure k
    Fresh name named text -> do
      keepLine faults (namedSpan named) text
      new name named
    Unnamed -> do
      known <- Map.lookup name <$> readSTRef (materialsNumbers ms)
      case known of
        Just k -> k <$ writeSTRef (materialsNext ms) (Known k)
        Nothing -> do
          here <- noted faults line start (start + 1)
          new name (Named here defaultMaterial)
      where
        name = Text.encodeUtf8 defaultMaterial
  where
    new name named = do
      known <- readSTRef (materialsNumbers ms)
      let k = Map.size known
      writeSTRef (materialsNumbers ms) $! Map.insert name k known
      modifySTRef' (materialsNames ms) (named :)
      writeSTRef (materialsNext ms) (Known k)
      pure k

-- | Reads a @usemtl@, whose name begins at the second place.
--
-- Spec: models.obj.materials.
useMaterial :: Faults s -> Materials s -> Line -> Int -> Int -> ST s ()
useMaterial faults ms line@(Line bytes _ _) start from
  | Bytes.null name = do
    writeSTRef (materialsNext ms) Unnamed
    report faults line start (wordFrom bytes start) (RefusedValue "usemtl" NothingThere SomeText (Kept defaultMaterial))
  | otherwise = do
    known <- Map.lookup name <$> readSTRef (materialsNumbers ms)
    writeSTRef (materialsNext ms) $! maybe fresh Known known
  where
    name = restOfLine bytes from
    fresh = let (here, text) = located line from (from + Bytes.length name) in Fresh (Bytes.copy name) (Named here (characters name)) text

-- | Reads an @mtllib@, whose names begin at the second place. One name has blanks, several end in @.mtl@ each.
--
-- Spec: models.obj.materials.
materialLibrary :: Faults s -> Materials s -> Line -> Int -> Int -> ST s ()
materialLibrary faults ms line@(Line bytes _ _) start from
  | Bytes.null rest = report faults line start (wordFrom bytes start) (RefusedValue "mtllib" NothingThere SomeText (Kept "none"))
  | otherwise = names from
  where
    rest = restOfLine bytes from
    end = from + Bytes.length rest
    names i = unless (i >= end) $ do
      let to = endOfName i
      library i to
      names (blanksFrom bytes to)
    -- The first end of a word that ends in .mtl.
    endOfName i
      | word >= end || Text.toLower (characters (Bytes.take 4 (Bytes.drop (word - 4) bytes))) == ".mtl" = min end word
      | otherwise = endOfName (blanksFrom bytes word)
      where
        word = wordFrom bytes i
    library i to = do
      let name = Bytes.take (to - i) (Bytes.drop i bytes)
      known <- readSTRef (materialsLibraries ms)
      unless (name `Set.member` known) $
        if Set.size known >= mostLibraries
          then report faults line i to (TooManyLibraries mostLibraries)
          else do
            writeSTRef (materialsLibraries ms) $! Set.insert (Bytes.copy name) known
            here <- noted faults line i to
            let !named = Named here (characters name)
            modifySTRef' (materialsLibraryNames ms) (named :)

-- | What stands from a place of a line on, without blanks at its end.
restOfLine :: ByteString -> Int -> ByteString
restOfLine bytes from = fst (Bytes.spanEnd isBlank (Bytes.drop from bytes))

-- | The materials that faces use, by their numbers from 0; each with the place that names it first.
materialsInUse :: Materials s -> ST s [Named]
materialsInUse ms = reverse <$> readSTRef (materialsNames ms)

-- | The libraries that are to have them, in the order of the file, each once.
librariesNamed :: Materials s -> ST s [Named]
librariesNamed ms = reverse <$> readSTRef (materialsLibraryNames ms)
