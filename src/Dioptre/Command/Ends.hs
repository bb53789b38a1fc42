{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Ends
-- Description : How the program ends
--
-- A command has done its work when what it printed is on its way, and not before: a result that a full disk swallows is
-- a file that cannot be written. And it is not the only one to say when the program ends: Ctrl-C, SIGTERM and
-- SIGHUP end it by an exception, on whose way every temporary is removed. (For Ctrl-C the run-time system would do that
-- once; a second one, which @timeout@ sends and impatient people do, would end it in the middle.)
module Dioptre.Command.Ends
  ( -- * All that is printed
    withAllPrinted,

    -- * Signals
    heedSignals,
    EndedBy (..),
    dieOf,
  )
where

import Control.Concurrent (myThreadId, throwTo)
import Control.Exception (Exception (..), asyncExceptionFromException, asyncExceptionToException, catch, throwIO, try)
import Control.Monad (forM_, void)
import Dioptre.Command.Journal (newJournal, sayFault)
import Dioptre.Files.Fault (FileFault (..), reasonOf)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Source.Language (Language, inLanguage)
import GHC.IO.Exception (IOErrorType (ResourceVanished), IOException (..))
import System.Exit (ExitCode (..), exitWith)
import System.IO (hFlush, stdout)
import System.Posix.Signals (Handler (..), Signal, fileSizeLimitExceeded, installHandler, raiseSignal)

-- | Does some work and sees what it printed on its way. Where standard output takes no more, that is told in a
-- language, and is exit code 3 whatever the work returned. That nobody reads any more is an exception still: there is
-- nobody to tell.
--
-- Spec: cli.streams.
withAllPrinted :: Language -> IO ExitCode -> IO ExitCode
withAllPrinted l work =
  try ((work `catch` pure) <* hFlush stdout) >>= \case
    Right code -> pure code
    Left e
      | ioe_handle e == Just stdout,
        not (vanished e) -> do
        journal <- newJournal l False
        ExitFailure 3 <$ sayFault journal (fileFault l (FileFault (inLanguage l "standard output" "sortie standard") (reasonOf e)))
      | otherwise -> throwIO e
  where
    vanished e = case ioe_type e of
      ResourceVanished -> True
      _ -> False

-- | What is thrown where a signal asks the program to end. It comes from outside, as what ends a thread does.
newtype EndedBy = EndedBy Signal
  deriving stock (Eq, Show)

instance Exception EndedBy where
  toException = asyncExceptionToException
  fromException = asyncExceptionFromException

-- | From now on these signals are thrown to this thread, as 'EndedBy'; and a file that may not grow any more is a
-- failure to write, and no longer the end of the program.
--
-- Spec: files.whole.
heedSignals :: [Signal] -> IO ()
heedSignals signals = do
  thread <- myThreadId
  forM_ signals $ \signal -> void (installHandler signal (Catch (throwTo thread (EndedBy signal))) Nothing)
  void (installHandler fileSizeLimitExceeded Ignore Nothing)

-- | Ends the program as the signal would have, so that whoever waits for it sees by what it ended: a shell has exit
-- code 143 for SIGTERM, 129 for SIGHUP.
--
-- Spec: cli.exit.
dieOf :: Signal -> IO a
dieOf signal = do
  void (installHandler signal Default Nothing)
  raiseSignal signal
  exitWith (ExitFailure (128 + fromIntegral signal))
