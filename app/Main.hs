-- |
-- Module      : Main
-- Description : The program
--
-- From options ("CommandLine") to one call.
module Main
  ( main,
  )
where

import CommandLine (Call (..), Settings (..), asked)
import Control.Exception (IOException, SomeAsyncException, SomeException, catch, fromException, handle, throwIO, try)
import Control.Monad (filterM)
import Data.Maybe (fromMaybe)
import Dioptre.Command.Ends (EndedBy (..), dieOf, heedSignals, withAllPrinted)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.Run (firstNumber, readConfiguration, run)
import Dioptre.Render.Parallel (workersAmong)
import Dioptre.Scene.Configuration (Configuration (..))
import Dioptre.Source.Language (fromLocale)
import GHC.Conc (getNumProcessors, setNumCapabilities)
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding)
import GHC.IO.Exception (IOErrorType (ResourceVanished), ioe_type)
import Inherited (isIgnored)
import System.Environment (getArgs, getEnvironment)
import System.Exit (ExitCode (..), exitWith)
import System.IO (hPutStrLn, hSetEncoding, stderr, stdout, utf8)
import System.Posix.Signals (sigHUP, sigINT, sigTERM)

main :: IO ()
main = do
  -- Before anything is read or said: UTF-8, whatever the locale; names of files keep their bytes.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  setLocaleEncoding utf8
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  handle bug $ do
    others <- filterM (fmap not . isIgnored) [sigTERM, sigHUP]
    heedSignals (sigINT : others)
    configuration <- readConfiguration
    environment <- getEnvironment
    let locale = fromLocale (`lookup` environment)
        habitual = fromMaybe locale (either (const Nothing) (\(_, c, _) -> configurationLanguage c) configuration)
        first = either (const minBound) (\(_, c, _) -> firstNumber c) configuration
    call <- try (getArgs >>= asked habitual first (`run` configuration))
    exitWith =<< case call of
      Left code -> withAllPrinted habitual (pure code)
      Right (Call settings work) -> do
        processors <- getNumProcessors
        setNumCapabilities (workersAmong processors (settingThreads settings))
        let l = fromMaybe habitual (settingLanguage settings)
        withAllPrinted l (newJournal l (not (settingQuiet settings)) >>= work)

-- | What was not foreseen is a mistake of ours, and says so; except that whoever stops reading our output, or stops us,
-- means it.
bug :: SomeException -> IO a
bug e
  | Just code <- fromException e = throwIO (code :: ExitCode)
  | Just (EndedBy signal) <- fromException e = dieOf signal
  | Just stop <- fromException e = throwIO (stop :: SomeAsyncException)
  | Just broken <- fromException e, ResourceVanished <- ioe_type broken = exitWith (ExitFailure 141)
  | otherwise = do
    hPutStrLn stderr ("dioptre: this is a bug of ours, please report it / ceci est une erreur de notre part, merci de la signaler\n" <> show e)
      `catch` unheard
    exitWith (ExitFailure 70)
  where
    unheard :: IOException -> IO ()
    unheard _ = pure ()
