{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.Files.Number
-- Description : Numbered pictures that never overwrite
--
-- Pictures are called @NAME_000.png@ to @NAME_999.png@. The number comes from a counter that all pictures share,
-- so the file that it leads to may be there already, and another process may be about to make it. \"Look whether
-- it is free, then write\" loses that race. Giving a name to a finished file does not:
--
-- > .dioptre4711-0.tmp    written whole, then linked to
-- > intro_007.png         taken  -> next
-- > intro_008.png         free   -> the link is made; the temporary's name is removed
--
-- A hard link is made only where nothing has the name, at once, and for one process only. Where the file system
-- has no links (FAT, some network shares), an empty file is created exclusively, which is as safe, and the
-- temporary is renamed over it: the picture still appears whole, after an instant of being empty.
--
-- Sources: POSIX.1-2017, @link()@ (<https://pubs.opengroup.org/onlinepubs/9699919799/functions/link.html>).
module Dioptre.Files.Number
  ( -- * Picture numbers
    PictureNumber,
    pictureNumber,
    pictureNumberValue,
    next,
    numbersFrom,

    -- * File names
    pictureFileName,

    -- * Writing
    writeNumbered,
    numberingObstacle,
    NumberingFault (..),

    -- * For tests
    writeNumberedBy,
  )
where

import Control.Exception (bracketOnError, try, tryJust)
import Control.Monad (guard)
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isControl)
import Data.Either (isRight)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Files.Contents (Contents, contents)
import Dioptre.Files.Descriptor (createExclusively)
import Dioptre.Files.Fault (FileFault, orFault)
import Dioptre.Files.Temporary (withTemporary)
import System.Directory (doesPathExist)
import System.FilePath (normalise, (</>))
import System.IO.Error (isAlreadyExistsError)
import System.Posix.Files (createLink, removeLink, rename)

-- | A number that a picture can have: 0 to 999. 'minBound' is the first.
newtype PictureNumber = PictureNumber Int
  deriving stock (Eq, Ord)

-- | Shows the bare number.
instance Show PictureNumber where
  showsPrec precedence (PictureNumber value) = showsPrec precedence value

instance Bounded PictureNumber where
  minBound = PictureNumber 0
  maxBound = PictureNumber 999

-- | The picture number of this value, if it is one.
--
-- >>> map pictureNumber [-1, 0, 999, 1000 :: Int]
-- [Nothing,Just 0,Just 999,Nothing]
--
-- Spec: limits.files.
pictureNumber :: Integral a => a -> Maybe PictureNumber
pictureNumber value
  | 0 <= number && number <= 999 = Just (PictureNumber (fromInteger number))
  | otherwise = Nothing
  where
    number = toInteger value

-- | Between 0 and 999. Law: @pictureNumber (pictureNumberValue n) == Just n@.
pictureNumberValue :: PictureNumber -> Int
pictureNumberValue (PictureNumber value) = value

-- | The number after this one; after 999 comes 0.
next :: PictureNumber -> PictureNumber
next number@(PictureNumber value)
  | number == maxBound = minBound
  | otherwise = PictureNumber (value + 1)

-- | Every number once, beginning with this one and going round. Law: a thousand of them, all different.
--
-- Spec: files.number.
numbersFrom :: PictureNumber -> [PictureNumber]
numbersFrom first = first : takeWhile (/= first) (iterate next (next first))

-- | The file name of a picture: its number has three digits.
--
-- >>> pictureFileName (Text.pack "intro") minBound
-- "intro_000.png"
--
-- Spec: files.number.
pictureFileName :: Text -> PictureNumber -> FilePath
pictureFileName name (PictureNumber value) =
  Text.unpack name <> "_" <> replicate (3 - length digits) '0' <> digits <> ".png"
  where
    digits = show value

-- | Why a picture has no number.
data NumberingFault
  = -- | The name holds a separator of folders or a control character: it would leave its folder, or its line.
    UnusableName Text
  | -- | All thousand numbers of this name are taken in this folder.
    AllNumbersTaken FilePath Text
  | -- | Writing failed, for a reason that no other number would help.
    NotWritten FileFault
  deriving stock (Eq, Show)

-- | @writeNumbered folder name first write@ writes a picture to @folder@ under the first free number from @first@ on,
-- round past 999, and tells its path, that number, and what came of its contents.
--
-- Laws: no file that was there is changed; the file appears whole; of several at once, each gets a number of its own;
-- no temporary stays.
--
-- Spec: files.number.
writeNumbered ::
  FilePath -> Text -> PictureNumber -> Contents a -> IO (Either NumberingFault ((FilePath, PictureNumber), a))
writeNumbered = writeNumberedBy createLink

-- | What would prevent 'writeNumbered' from writing a picture, as far as can be known before there is one. Everything
-- stays as it is.
numberingObstacle :: FilePath -> Text -> PictureNumber -> IO (Maybe NumberingFault)
numberingObstacle folder name first
  | not (canName name) = pure (Just (UnusableName name))
  | otherwise =
    orFault (path first) (withTemporary folder Nothing (contents Lazy.empty) (const (pure ()))) >>= \case
      Left fault -> pure (Just (NotWritten fault))
      Right _ -> maybe (Just (AllNumbersTaken folder name)) (const Nothing) <$> firstThat (fmap not . doesPathExist . path) (numbersFrom first)
  where
    path = numberedPath folder name

-- | 'writeNumbered' with another way to make the second path a link to the file at the first. It must fail with
-- 'isAlreadyExistsError' where the second is taken. After any other failure the number is claimed by exclusive
-- creation instead: which numbers file systems answer with for \"no links here\" is a long list, and whatever is
-- wrong apart from that goes wrong there again, and is reported.
writeNumberedBy ::
  (FilePath -> FilePath -> IO ()) ->
  FilePath ->
  Text ->
  PictureNumber ->
  Contents a ->
  IO (Either NumberingFault ((FilePath, PictureNumber), a))
writeNumberedBy link folder name first write
  | not (canName name) = pure (Left (UnusableName name))
  | otherwise = settled <$> orFault (path first) (withTemporary folder Nothing write settle)
  where
    path = numberedPath folder name
    settle temporary = firstThat (claim link temporary . path) (numbersFrom first)
    settled (Left fault) = Left (NotWritten fault)
    settled (Right (_, Nothing)) = Left (AllNumbersTaken folder name)
    settled (Right (written, Just number)) = Right ((path number, number), written)

-- | Whether a picture can have this name, which then leaves neither its folder nor its line.
canName :: Text -> Bool
canName = not . Text.any (\c -> c == '/' || c == '\\' || isControl c)

-- | The path of a picture in a folder.
numberedPath :: FilePath -> Text -> PictureNumber -> FilePath
numberedPath folder name number = normalise (folder </> pictureFileName name number)

-- | Gives the temporary's contents this path, unless something has it; says whether it did.
--
-- Spec: files.number.atomic.
claim :: (FilePath -> FilePath -> IO ()) -> FilePath -> FilePath -> IO Bool
claim link temporary path = do
  linked <- try (link temporary path)
  case linked of
    Right () -> pure True
    Left problem
      | isAlreadyExistsError problem -> pure False
      | otherwise -> isRight <$> tryJust (guard . isAlreadyExistsError) exclusively
  where
    exclusively =
      bracketOnError (createExclusively path) (const (removeLink path)) (const (rename temporary path))

-- | The first element for which the action answers yes; the later ones are not asked.
firstThat :: Monad m => (a -> m Bool) -> [a] -> m (Maybe a)
firstThat _ [] = pure Nothing
firstThat accepts (x : xs) = do
  accepted <- accepts x
  if accepted then pure (Just x) else firstThat accepts xs
