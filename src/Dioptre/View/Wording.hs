{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.View.Wording
-- Description : What the viewer says, in English and French
--
-- Why a text is not drawn (a complaint), why something that a page asks for is not done (a refusal), and why whoever
-- asks is not answered at all (a rejection).
module Dioptre.View.Wording
  ( complaintText,
    Refusal (..),
    refusal,
    rejection,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Files.Fault (FileFault)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.View.Desk (Complaint (..))
import Dioptre.View.Guard (Verdict (..))

-- | Why a scene without errors is not drawn here.
complaintText :: Language -> Complaint -> Text
complaintText l (TooLarge pixels) =
  Text.concat
    [ inLanguage l "this picture has " "cette image a ",
      Text.pack (show pixels),
      inLanguage l " pixels, which are too many for the page; `dioptre render` draws it" " pixels, c'est trop pour la page\xA0; `dioptre render` la dessine"
    ]

-- | What a page asked for and does not get.
data Refusal
  = -- | What it said is not understood; with the reason.
    NotUnderstood String
  | -- | The text is longer than a page may send.
    TooMuchText
  | -- | There is no picture to ask about.
    NoPicture
  | -- | No pixel is there.
    OutsideOfPicture
  | -- | The story would be longer than a page gets.
    TooLong
  | -- | The scene has no file.
    NoFile
  | -- | The file has been changed by somebody else.
    ChangedMeanwhile
  | -- | The file cannot be written.
    NotSaved FileFault

-- | The same in words.
refusal :: Language -> Refusal -> Text
refusal l why = case why of
  NotUnderstood reason -> say "not understood: " "pas compris\xA0: " <> Text.pack reason
  TooMuchText -> say "this text is too long for the page; it is not taken over" "ce texte est trop long pour la page\xA0; il n'est pas repris"
  NoPicture -> say "there is no picture yet" "il n'y a pas encore d'image"
  OutsideOfPicture -> say "this pixel is outside of the picture" "ce pixel est hors de l'image"
  TooLong -> say "this story is too long for the page; `dioptre explain` tells it" "cette histoire est trop longue pour la page\xA0; `dioptre explain` la raconte"
  NoFile -> say "this scene is built in and has no file" "cette scène est incorporée et n'a pas de fichier"
  ChangedMeanwhile -> say "the file has changed meanwhile; nothing was written" "le fichier a changé entre-temps\xA0; rien n'a été écrit"
  NotSaved fault -> fileFault l fault
  where
    say = inLanguage l

-- | Why somebody may not speak here: in both languages, as nobody knows theirs.
rejection :: Verdict -> Text
rejection why = case why of
  Admitted -> Text.empty
  WrongHost -> both "this server answers only to the name 127.0.0.1 or localhost" "ce serveur ne répond qu'au nom 127.0.0.1 ou localhost"
  WrongOrigin -> both "this server talks only with its own page" "ce serveur ne parle qu'avec sa propre page"
  WrongToken -> both "the token of this run is missing or wrong: open the whole address that the program printed" "le jeton de cette exécution manque ou est faux\xA0: ouvrez l'adresse entière que le programme a affichée"
  where
    both english french = english <> " / " <> french
