{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Files.Wording
-- Description : What is wrong with files, in English and French
--
-- The sentences for the faults that the other modules of this folder find, which are data until they come here. A
-- sentence about one file begins with its path, as compilers do it, so that terminals and editors find the file.
module Dioptre.Files.Wording
  ( fileFault,
    searchFault,
    numberingFault,
    undecodable,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Number (NumberingFault (..))
import Dioptre.Files.Search (Place (..), SearchFault (..))
import Dioptre.Source.Diagnostic (PictureFault)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Message (pictureFault)

-- | A file that cannot be read or written.
fileFault :: Language -> FileFault -> Text
fileFault l (FileFault path reason) = Text.pack path <> inLanguage l ": " "\xA0: " <> why reason
  where
    why = \case
      DoesNotExist -> say "there is no such file or folder" "ce fichier ou ce dossier n'existe pas"
      PermissionDenied -> say "permission denied" "permission refusée"
      IsAFolder -> say "this is a folder" "c'est un dossier"
      NotAFolder -> say "a part of this path is a file, not a folder" "une partie de ce chemin est un fichier, pas un dossier"
      DiskFull -> say "no space is left" "il ne reste plus de place"
      TooManyOpen -> say "too many files are open" "trop de fichiers sont ouverts"
      LinksInACircle -> say "this is a link that leads back to itself, or through too many others" "c'est un lien qui ramène à lui-même, ou qui passe par trop d'autres"
      NotAPlainFile -> say "this is a device or a pipe, and only a file can be read here" "c'est un périphérique ou un tube, et seul un fichier peut être lu ici"
      IsAPicture -> say "this is a picture, and no scene: a scene is a text" "c'est une image, et non une scène\xA0: une scène est un texte"
      LongerThan n -> say "this is longer than the " "c'est plus long que les " <> Text.pack (show n) <> say " bytes that are read at most" " octets qui sont lus au plus"
      OtherReason t -> t
    say = inLanguage l

-- | A file named in another one that cannot be found.
searchFault :: Language -> SearchFault -> Text
searchFault l = \case
  NoName name -> inLanguage l "no file can be called '" "aucun fichier ne peut s'appeler '" <> name <> "'"
  NotFound name places near ->
    inLanguage l "no file is called '" "aucun fichier ne s'appelle '" <> name <> "'"
      <> foldMap (\n -> inLanguage l "; did you mean '" "\xA0; vouliez-vous dire '" <> n <> inLanguage l "'?" "'\xA0?") near
      <> inLanguage l "; looked for:" "\xA0; cherché\xA0:"
      <> foldMap (("\n    " <>) . place) places
  SeveralFound name paths ->
    inLanguage l "several files are called '" "plusieurs fichiers s'appellent '" <> name
      <> inLanguage l "'; keep one of:" "'\xA0; n'en gardez qu'un\xA0:"
      <> foldMap (("\n    " <>) . Text.pack) paths
  where
    place = \case
      Within folder -> inLanguage l "in " "dans " <> Text.pack folder
      Below folder -> inLanguage l "anywhere below " "n'importe où sous " <> Text.pack folder

-- | A numbered picture that cannot be written.
numberingFault :: Language -> NumberingFault -> Text
numberingFault l = \case
  UnusableName name -> "'" <> name <> inLanguage l "' cannot name a file here" "' ne peut pas nommer un fichier ici"
  AllNumbersTaken folder name ->
    Text.pack folder <> inLanguage l ": all thousand numbers of '" "\xA0: les mille numéros de '" <> name
      <> inLanguage l "' are taken; move some of its pictures away" "' sont pris\xA0; déplacez quelques-unes de ses images"
  NotWritten fault -> fileFault l fault

-- | A file that is no picture.
undecodable :: Language -> FilePath -> PictureFault -> Text
undecodable l path fault =
  Text.pack path <> inLanguage l ": " "\xA0: " <> pictureFault l fault
