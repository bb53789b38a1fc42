{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Journal
-- Description : What the program tells while it works
--
-- Messages go to standard error, where they have colours if it is a terminal, and are kept for the log, where they have
-- none.
module Dioptre.Command.Journal
  ( Journal,
    newJournal,
    journalLanguage,
    speakingIf,
    sayText,
    sayFault,
    sayDiagnostics,
    sayObstacles,
    written,
    withProgress,
    toConsole,
  )
where

import Control.Exception (IOException, catch, throwIO, try)
import Control.Monad (forM_, when)
import Data.Foldable (fold, toList)
import Data.IORef (IORef, modifyIORef', newIORef, readIORef)
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Lazy as Lazy
import Dioptre.Files.Fault (quietly)
import Dioptre.Source.Diagnostic (Diagnostic, needsMending)
import Dioptre.Source.Language (Language)
import Dioptre.Source.Phrase (safe)
import qualified Dioptre.Source.Report as Report
import Dioptre.Source.Text (Source)
import GHC.IO.Exception (IOErrorType (ResourceVanished), ioe_type)
import Prettyprinter (Doc, LayoutOptions (..), PageWidth (..), hardline, layoutPretty, pretty, unAnnotate)
import qualified Prettyprinter.Render.Terminal as Terminal
import qualified Prettyprinter.Render.Text as Plain
import System.Console.ANSI (hSupportsANSI)
import System.Environment (lookupEnv)
import System.IO (Handle, hIsTerminalDevice, stderr)
import System.ProgressBar (Progress (..), ProgressBarWidth (..), Style (..), defStyle, incProgress, msg, newProgressBar)

-- | Where messages go.
data Journal = Journal
  { -- | The language that they are in.
    journalLanguage :: Language,
    speaks :: Bool,
    kept :: IORef (Seq Text)
  }

-- | A journal in a language, that speaks on standard error or only writes.
newJournal :: Language -> Bool -> IO Journal
newJournal l loud = Journal l loud <$> newIORef Seq.empty

-- | The same journal, which speaks if it does already and if it may.
speakingIf :: Bool -> Journal -> Journal
speakingIf may journal = journal {speaks = speaks journal && may}

-- | A message. Where standard error takes none, it is kept all the same, and the work goes on; but not where nobody
-- reads any more.
--
-- Spec: run.log.
say :: Journal -> Doc Report.Style -> IO ()
say journal doc = do
  modifyIORef' (kept journal) (|> Plain.renderStrict (layoutPretty layout (unAnnotate doc)))
  when (speaks journal) (toConsole stderr doc `catch` unheard)
  where
    unheard e = case ioe_type e of
      ResourceVanished -> throwIO e
      _ -> pure ()

-- | A message without any style.
sayText :: Journal -> Text -> IO ()
sayText journal = say journal . paragraphs

-- | A message that is heard even where the journal is silent, as the program ends because of it.
sayFault :: Journal -> Text -> IO ()
sayFault journal = say journal {speaks = True} . paragraphs

-- | Every diagnostic in full, file by file, and how many there were in all.
sayDiagnostics :: Journal -> [(Source, [Diagnostic])] -> IO ()
sayDiagnostics journal files = do
  forM_ files $ \(source, diagnostics) -> forM_ diagnostics (say journal . Report.pretty l source)
  forM_ (Report.summary l (concatMap snd files)) (sayText journal)
  where
    l = journalLanguage journal

-- | The same where some of them keep the program from its task: those are heard even where the journal is silent.
--
-- Spec: cli.render.
sayObstacles :: Journal -> [(Source, [Diagnostic])] -> IO ()
sayObstacles journal files
  | speaks journal = sayDiagnostics journal files
  | otherwise = sayDiagnostics journal {speaks = True} (map (fmap (filter needsMending)) files)

-- | Lines, in which nothing commands the terminal.
paragraphs :: Text -> Doc Report.Style
paragraphs = fold . zipWith (<>) ("" : repeat hardline) . map (pretty . safe) . Text.splitOn "\n"

-- | Everything that was said, line by line.
--
-- Spec: run.log.
written :: Journal -> IO Text
written journal = Text.unlines . toList <$> readIORef (kept journal)

layout :: LayoutOptions
layout = LayoutOptions (AvailablePerLine 100 1)

-- | A document on a terminal or in a file, in colours where they are understood and not declined (see no-color.org).
--
-- Spec: cli.streams.
toConsole :: Handle -> Doc Report.Style -> IO ()
toConsole handle doc = do
  colourful <- (&&) <$> hSupportsANSI handle <*> (maybe True null <$> lookupEnv "NO_COLOR")
  Terminal.renderIO handle (layoutPretty layout ((if colourful then doc else unAnnotate doc) <> hardline))

-- | Runs some work of n steps, which reports each; shows how far it has come where the journal speaks and standard
-- error is a terminal.
withProgress :: Journal -> Text -> Int -> (IO () -> IO a) -> IO a
withProgress journal label n work = do
  terminal <- hIsTerminalDevice stderr
  if terminal && speaks journal
    then do
      -- A picture is not lost with the terminal that its bar was on.
      bar <- try (newProgressBar defStyle {stylePrefix = msg (Lazy.fromStrict label), styleWidth = TerminalWidth 80} 10 (Progress 0 n ()))
      work (either unseen (\b -> quietly (incProgress b 1)) bar)
    else work (pure ())
  where
    unseen :: IOException -> IO ()
    unseen _ = pure ()
