{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.View.Desk
-- Description : What lies on the desk: a scene's text, what is wrong with it, and its picture
--
-- Everything that the viewer knows at a moment, and how it changes. There is one desk; all pages that are open look at
-- it, and may type on it.
--
-- >   typing, or the file     Desk      text, version 7
-- >   ----------------------> text
-- >                             |  jobOf: what there is to draw
-- >                             v
-- >                           frame     a picture in the making
-- >                             |
-- >                             v
-- >                           finished  the last good picture
--
-- A version is drawn unless its text has errors: then the last good picture stays, if there is one. The changes are
-- pure functions; "Dioptre.View.Painter" draws, and "Dioptre.View.Server" talks.
module Dioptre.View.Desk
  ( -- * The desk
    Desk (..),
    By (..),
    Checked (..),
    Complaint (..),
    Sought,
    newDesk,
    isSaved,
    hasErrors,

    -- * Changes from outside
    typed,
    foundOnDisk,
    filesChanged,
    takenFromDisk,
    savedToDisk,
    drawnAnyway,
    spoken,
    entered,
    left,

    -- * Drawing
    Job (..),
    jobOf,
    checked,
    begun,
    ended,
    abandoned,
  )
where

import Data.Map.Strict (Map)
import Data.Maybe (isNothing)
import Data.Text (Text)
import Dioptre.Load.Shelf (Found)
import Dioptre.Source.Diagnostic (Diagnostic (..), FileTrouble, Severity (Error), severity)
import Dioptre.Source.Language (Language)
import Dioptre.Source.Text (Source)
import Dioptre.View.Frame (Frame (..))

-- | The desk at a moment.
data Desk = Desk
  { -- | The scene's text. Its lines end with a line feed alone.
    deskText :: !Text,
    -- | How many texts there have been.
    deskVersion :: !Int,
    -- | Whose this one is.
    deskBy :: !By,
    -- | The text that the file has, as far as is known.
    deskDisk :: !(Maybe Text),
    -- | With which version the file's text was last taken over.
    deskTaken :: !Int,
    -- | Whether the file changed while there was unsaved typing.
    deskConflict :: !Bool,
    -- | How often one of the other files may have changed that the scene is made of.
    deskChanges :: !Int,
    -- | What messages are in.
    deskLanguage :: !Language,
    -- | What was found wrong, with the last version that was looked at.
    deskChecked :: !(Maybe Checked),
    -- | The picture to look at: the one that is being painted, or else the last one that was finished.
    deskFrame :: !(Maybe Frame),
    -- | The last one that was finished.
    deskFinished :: !(Maybe Frame),
    -- | How many frames there have been.
    deskFrames :: !Int,
    -- | The last job of which nothing is left to do.
    deskDone :: !(Maybe Job),
    -- | The version that is to be drawn whatever is wrong with it.
    deskAnyway :: !(Maybe Int),
    -- | Whether it is drawn while nobody looks.
    deskUnwatched :: !Bool,
    -- | How many pages are open.
    deskPages :: !Int,
    -- | How many there have been.
    deskVisits :: !Int
  }

-- | Who wrote a text.
data By = Disk | Page !Int
  deriving stock (Eq, Show)

-- | What was found in a version of the text.
data Checked = Checked
  { -- | Which.
    checkedVersion :: !Int,
    -- | After how many changes of the other files.
    checkedChanges :: !Int,
    -- | What is wrong, file by file: first the scene itself.
    checkedDiagnostics :: ![(Source, [Diagnostic])],
    -- | Whether it is drawn.
    checkedDrawn :: !Bool,
    -- | Why it cannot be.
    checkedComplaint :: !(Maybe Complaint),
    -- | Which other files it is made of, as they were found.
    checkedSought :: !Sought
  }

-- | What was found for a name of a file, looked for from a folder on.
type Sought = Map (FilePath, Text) (Either FileTrouble Found)

-- | Why a scene without errors is not drawn here.
newtype Complaint
  = -- | Its picture has more pixels than a page gets: so many.
    TooLarge Int
  deriving stock (Eq, Show)

-- | A desk with a text, which the file has if there is one, on which nothing is drawn yet. Says whether it is drawn
-- while nobody looks.
newDesk :: Language -> Bool -> Bool -> Text -> Desk
newDesk l hasFile unwatched text =
  Desk
    { deskText = text,
      deskVersion = 1,
      deskBy = Disk,
      deskDisk = if hasFile then Just text else Nothing,
      deskTaken = 1,
      deskConflict = False,
      deskChanges = 0,
      deskLanguage = l,
      deskChecked = Nothing,
      deskFrame = Nothing,
      deskFinished = Nothing,
      deskFrames = 0,
      deskDone = Nothing,
      deskAnyway = Nothing,
      deskUnwatched = unwatched,
      deskPages = 0,
      deskVisits = 0
    }

-- | Whether the file has the text.
isSaved :: Desk -> Bool
isSaved desk = deskDisk desk == Just (deskText desk)

-- | Whether there is an error among what was found.
hasErrors :: [(source, [Diagnostic])] -> Bool
hasErrors = any (any ((== Error) . severity . diagnosticProblem) . snd)

-- | Another text, if it is another.
withText :: By -> Text -> Desk -> Desk
withText by text desk
  | text == deskText desk = desk
  | otherwise = desk {deskText = text, deskVersion = deskVersion desk + 1, deskBy = by, deskConflict = deskConflict desk && deskDisk desk /= Just text}

-- | Somebody typed on a page, in the text of a version. If the file's text was taken over since, as that happened to cross
-- the typing, the two are in conflict.
typed :: Int -> Int -> Text -> Desk -> Desk
typed page version text desk = edited {deskConflict = deskConflict edited || (version < deskTaken desk && not (isSaved edited))}
  where
    edited = withText (Page page) text desk

-- | The file has this text now. Unsaved typing stays, and is in conflict with it.
foundOnDisk :: Text -> Desk -> Desk
foundOnDisk text desk
  | deskDisk desk == Just text = desk
  | isSaved desk || text == deskText desk = taken text desk
  | otherwise = desk {deskDisk = Just text, deskConflict = True}

-- | Another file that the scene is made of may have changed.
filesChanged :: Desk -> Desk
filesChanged desk = desk {deskChanges = deskChanges desk + 1}

-- | The file's text instead of what was typed.
takenFromDisk :: Desk -> Desk
takenFromDisk desk = case deskDisk desk of
  Nothing -> desk
  Just text -> taken text desk

-- | The text is that of the file, which is this one.
taken :: Text -> Desk -> Desk
taken text desk
  | text == deskText desk = desk {deskDisk = Just text, deskConflict = False}
  | otherwise = let desk' = withText Disk text desk in desk' {deskDisk = Just text, deskTaken = deskVersion desk', deskConflict = False}

-- | This text was written to the file.
savedToDisk :: Text -> Desk -> Desk
savedToDisk text desk = desk {deskDisk = Just text, deskConflict = False}

-- | What lies there is to be drawn, whatever is wrong with it.
drawnAnyway :: Desk -> Desk
drawnAnyway desk = desk {deskAnyway = Just (deskVersion desk)}

-- | Another language.
spoken :: Language -> Desk -> Desk
spoken l desk = desk {deskLanguage = l}

-- | Another page is open; the desk's number of visits is its number.
entered :: Desk -> Desk
entered desk = desk {deskPages = deskPages desk + 1, deskVisits = deskVisits desk + 1}

-- | A page was closed.
left :: Desk -> Desk
left desk = desk {deskPages = deskPages desk - 1}

-- | A text to look at, and to draw.
data Job = Job
  { -- | Its version.
    jobVersion :: !Int,
    -- | Whether it is to be drawn whatever is wrong with it.
    jobAnyway :: !Bool,
    -- | After how many changes of the other files that the scene is made of.
    jobChanges :: !Int
  }
  deriving stock (Eq, Show)

-- | What there is to do: nothing where the version at hand was dealt with, or where nobody looks.
--
-- Law: it changes as soon as the text does, or a file that it names, so that nobody goes on drawing an old one.
jobOf :: Desk -> Maybe Job
jobOf desk
  | deskDone desk == Just job || not (deskUnwatched desk || deskPages desk > 0) = Nothing
  | otherwise = Just job
  where
    job = Job (deskVersion desk) (deskAnyway desk == Just (deskVersion desk)) (deskChanges desk)

-- | The job's text was looked at. Where it has errors and there is a picture already, or where it cannot be drawn, that
-- is all there is to do.
checked :: Job -> [(Source, [Diagnostic])] -> Sought -> Maybe Complaint -> Desk -> Desk
checked job diagnostics sought complaint desk =
  desk
    { deskChecked = Just (Checked (jobVersion job) (jobChanges job) diagnostics drawn complaint sought),
      deskDone = if drawn then deskDone desk else Just job
    }
  where
    drawn = isNothing complaint && (not (hasErrors diagnostics) || jobAnyway job || isNothing (deskFinished desk))

-- | A frame is being painted.
begun :: Frame -> Desk -> Desk
begun frame desk = desk {deskFrame = Just frame, deskFrames = frameNumber frame}

-- | A frame is finished, and the job with it.
ended :: Job -> Frame -> Desk -> Desk
ended job frame desk = desk {deskFrame = Just frame, deskFinished = Just frame, deskDone = Just job}

-- | A frame will never be finished: the last good picture is there again.
abandoned :: Desk -> Desk
abandoned desk = desk {deskFrame = deskFinished desk}
