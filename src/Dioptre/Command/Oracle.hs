{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Oracle
-- Description : dioptre oracle: the conformance protocol
--
-- This program as a port of itself: what the suite asks any port, it can be asked too, so that there is something
-- to compare with while a port is written. It keeps going whatever it is sent: a line that is no request is
-- answered with what is wrong with it. Specification: 0.4.
module Dioptre.Command.Oracle
  ( oracle,
  )
where

import Control.Exception (SomeAsyncException (..), SomeException, evaluate, fromException, tryJust)
import qualified Data.ByteString.Lazy as Lazy
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Conformance.Lines (Line (..), linesOf, nextLine)
import Dioptre.Conformance.Oracle (answer)
import Dioptre.Conformance.Protocol (Answer (..), Outcome (Fault), Request (..), readRequest, writeAnswer)
import System.Exit (ExitCode (..))
import System.IO (BufferMode (BlockBuffering), hFlush, hSetBinaryMode, hSetBuffering, stdin, stdout)

-- | Answers each line of standard input with a line of standard output, in their order, until the input ends. The first
-- argument is this program's version.
--
-- A line longer than 64 MiB is answered with an error. Each answer is out before the next request is read.
--
-- Spec: protocol.lines.
oracle :: Text -> IO ExitCode
oracle version = do
  mapM_ (`hSetBinaryMode` True) [stdin, stdout]
  hSetBuffering stdout (BlockBuffering Nothing)
  linesOf stdin >>= go
  where
    go source =
      nextLine longestLine source >>= \case
        NoMore -> pure ExitSuccess
        TooLong -> reply (writeAnswer (Answer Nothing (Fault "the line is longer than 64 MiB"))) >> go source
        Line bytes -> answered bytes >>= reply >> go source
    answered bytes = do
      let text = writeAnswer (answer version bytes)
      tryJust unforeseen (text <$ evaluate (Lazy.length text)) >>= either (pure . writeAnswer . apology bytes) pure
    apology bytes e = Answer (either answerId (Just . requestId) (readRequest bytes)) (Fault ("this is a bug of ours: " <> Text.pack (show e)))
    reply text = Lazy.hPut stdout (text <> "\n") >> hFlush stdout

-- | The longest line that is read, in bytes.
longestLine :: Int
longestLine = 64 * 1024 * 1024

-- | What a pure answer should never throw; what comes from outside is not caught.
unforeseen :: SomeException -> Maybe SomeException
unforeseen e = case fromException e of
  Just (SomeAsyncException _) -> Nothing
  Nothing -> Just e
