{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Suite
-- Description : The vectors of the conformance suite
--
-- > conformance/vectors/roots.quadratic.json       the cases of one operation
-- > conformance/pictures/mirror.txt, mirror.png    scenes and pictures that cases name
-- > spec/04-mathematics.md                         a chapter of the specification, whose examples are cases too
--
-- A vector file is an object with @operation@, @profile@ and @cases@. Where a case's @in@ has a member @file@, the text
-- in that file among the pictures is sent as @text@; where its @ok@ has one, the picture in that file is expected.
module Dioptre.Conformance.Suite
  ( -- * Finding
    findSuite,

    -- * Reading
    SuiteFault (..),
    readSuite,
    readSpecification,
    readVectors,

    -- * Selecting
    Selection (..),
    select,
  )
where

import Control.Monad (unless, (>=>))
import Data.Aeson (Value (..), eitherDecodeStrict, withArray, withObject, (.!=), (.:), (.:?), (<?>))
import qualified Data.Aeson.KeyMap as Keys
import Data.Aeson.Types (JSONPathElement (Index, Key), Parser, parseEither)
import Data.Bifunctor (bimap, first)
import Data.ByteString (ByteString)
import Data.Foldable (toList)
import Data.List (elemIndex, find, sort, sortOn)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Conformance.Compare (Comparison (Exact), comparison)
import Dioptre.Conformance.Example (ChapterFault (..), Rule (..), chapter, faultsOf)
import Dioptre.Conformance.Oracle (profiles)
import Dioptre.Conformance.Scenes (ofPicture)
import Dioptre.Conformance.Verdict (Case (..))
import Dioptre.Files.Fault (FileFault, orFault)
import Dioptre.Files.Whole (readWhole)
import Dioptre.Picture.Png (decode)
import Dioptre.Source.Language (Language (English))
import Dioptre.Source.Message (pictureFault)
import System.Directory (doesDirectoryExist, listDirectory, makeAbsolute)
import System.FilePath (takeDirectory, takeExtension, takeFileName, (</>))

-- | The folder @conformance@ of the folder or of the nearest one around it in which there is a @conformance/vectors@.
findSuite :: FilePath -> IO (Maybe FilePath)
findSuite start = makeAbsolute start >>= upwards
  where
    upwards folder = do
      there <- doesDirectoryExist (folder </> "conformance" </> "vectors")
      case takeDirectory folder of
        _ | there -> pure (Just (folder </> "conformance"))
        around
          | around == folder -> pure Nothing
          | otherwise -> upwards around

-- | What can be wrong with a suite.
data SuiteFault
  = -- | A file or folder that cannot be read.
    Unreadable FileFault
  | -- | A file that is not as it should be, and why.
    Malformed FilePath Text
  | -- | A name that two cases bear.
    NotUnique Text
  deriving stock (Eq, Show)

-- | All cases of the suite in a folder, and the examples of the specification in the folder @spec@ beside it, if there
-- is one: by profiles in their order, then by operations in alphabetical order, then first the examples and then the
-- vectors, as they stand in their files.
readSuite :: FilePath -> IO (Either SuiteFault [Case])
readSuite folder = do
  there <- doesDirectoryExist spec
  examples <- if there then readSpecification spec else pure (Right [])
  vectors <- files ".json" (folder </> "vectors") >>= either (pure . Left) (fmap (fmap concat . sequence) . traverse (readFileOf (folder </> "pictures")))
  pure ((\rules cases -> concatMap ruleExamples rules <> cases) <$> examples <*> vectors >>= unique . sortOn placeOf)
  where
    spec = takeDirectory folder </> "spec"
    placeOf c = (elemIndex (caseProfile c) (map fst profiles), caseOperation c)
    unique cases = maybe (Right cases) (Left . NotUnique . fst) (find ((> 1) . snd) (Map.toList (Map.fromListWith (+) [(caseName c, 1 :: Int) | c <- cases])))

-- | The rules of the specification in a folder, in the order of its chapters.
--
-- Spec: rule.examples.
readSpecification :: FilePath -> IO (Either SuiteFault [Rule])
readSpecification folder = files ".md" folder >>= either (pure . Left) (fmap (sequence >=> sound . mconcat) . traverse read')
  where
    read' path =
      readWhole path >>= \whole -> pure $ case whole of
        Left fault -> Left (Unreadable fault)
        Right bytes -> chapter ("spec" </> takeFileName path) <$> first (const (Malformed path "this is not UTF-8")) (Text.decodeUtf8' bytes)
    sound (rules, faults) = case faults <> faultsOf rules of
      [] -> Right rules
      fault : _ -> Left (Malformed (chapterFaultFile fault <> ":" <> show (chapterFaultLine fault)) (chapterFaultText fault))

-- | The files with that ending in a folder, in alphabetical order.
files :: String -> FilePath -> IO (Either SuiteFault [FilePath])
files ending folder = bimap Unreadable (\names -> [folder </> name | name <- sort names, takeExtension name == ending]) <$> orFault folder (listDirectory folder)

readFileOf :: FilePath -> FilePath -> IO (Either SuiteFault [Case])
readFileOf pictures path =
  readWhole path >>= \case
    Left fault -> pure (Left (Unreadable fault))
    Right bytes -> case readVectors bytes of
      Left why -> pure (Left (Malformed path why))
      Right cases -> sequence <$> traverse (withFiles pictures) cases

-- | The cases of a vector file, or what is wrong with it.
readVectors :: ByteString -> Either Text [Case]
readVectors bytes = first Text.pack (eitherDecodeStrict bytes >>= parseEither (withObject "vectors" vectors))
  where
    vectors o = do
      operation <- o .: "operation"
      profile <- o .: "profile"
      unless (any (\(p, operations) -> p == profile && any ((== operation) . fst) operations) profiles) $
        fail ("there is no operation " <> Text.unpack operation <> " in the profile " <> Text.unpack profile)
      cases <- o .: "cases"
      withArray "cases" (\items -> sequence [caseOf profile operation item <?> Index i | (i, item) <- zip [0 ..] (toList items)]) cases <?> Key "cases"

caseOf :: Text -> Text -> Value -> Parser Case
caseOf profile operation = withObject "case" $ \o -> do
  name <- o .: "id"
  rules <- o .: "rules"
  comment <- o .:? "comment" .!= ""
  flags <- o .:? "flags" .!= []
  input <- o .: "in"
  expected <- maybe (fail "there is no 'ok'") pure (Keys.lookup "ok" o)
  how <- o .:? "compare" >>= maybe (pure Exact) (either (fail . Text.unpack) pure . comparison)
  pure (Case name profile operation rules comment flags input expected how)

-- | A case with the contents of the files that it names.
withFiles :: FilePath -> Case -> IO (Either SuiteFault Case)
withFiles pictures c = do
  input <- resolved (caseInput c) (\o path bytes -> Object . (\t -> Keys.insert "text" (String t) (Keys.delete "file" o)) <$> first (const (Malformed path "this is not UTF-8")) (Text.decodeUtf8' bytes))
  expected <- resolved (caseExpected c) (\_ path bytes -> first (Malformed path . pictureFault English) (ofPicture <$> decode bytes))
  pure ((\i e -> c {caseInput = i, caseExpected = e}) <$> input <*> expected)
  where
    resolved value contents = case value of
      Object o | Just (String name) <- Keys.lookup "file" o -> do
        let path = pictures </> takeFileName (Text.unpack name)
        either (Left . Unreadable) (contents o path) <$> readWhole path
      _ -> pure (Right value)

-- | Which cases to run: those that fit everything that is given.
data Selection = Selection
  { -- | Any of these profiles; all where there are none.
    selectedProfiles :: [Text],
    -- | The rule with this label, or the rules whose labels begin with it and a dot.
    selectedRule :: Maybe Text,
    -- | The case with this name.
    selectedCase :: Maybe Text
  }
  deriving stock (Eq, Show)

-- | The cases that are selected, in their order.
--
-- Spec: conformance.profiles, cli.conform.
select :: Selection -> [Case] -> [Case]
select s = filter (\c -> profile c && rule c && name c)
  where
    profile c = null (selectedProfiles s) || caseProfile c `elem` selectedProfiles s
    rule c = maybe True (\r -> any (\label -> label == r || (r <> ".") `Text.isPrefixOf` label) (caseRules c)) (selectedRule s)
    name c = maybe True (== caseName c) (selectedCase s)
