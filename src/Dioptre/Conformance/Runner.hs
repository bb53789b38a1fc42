{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Runner
-- Description : Running the suite against a program that may do anything
--
-- Requests are sent ahead of the port's answers, a window of them, so that neither side waits for the other at each
-- case:
--
-- >   cases  ----->  [ outstanding ]  ----->  port
-- >   verdicts  <-----------------------------  answers, in any order
--
-- Nothing that a port does stops the run, and no trouble is laid at the door of a case that did not make it: see Note
-- [Whose fault].
module Dioptre.Conformance.Runner
  ( Settings (..),
    standardSettings,
    runCases,
    Ran (..),
    Complaint (..),
  )
where

import Data.Aeson (Value (..))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Foldable (toList, traverse_)
import Data.IntMap.Strict (IntMap)
import qualified Data.IntMap.Strict as IntMap
import Data.IntSet (IntSet)
import qualified Data.IntSet as IntSet
import Data.Maybe (isNothing)
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Data.Text.Encoding.Error (lenientDecode)
import Dioptre.Conformance.Lines (Line (..))
import Dioptre.Conformance.Port (Port, close, ending, hear, say, withPort)
import Dioptre.Conformance.Protocol (Answer (..), Outcome (..), Request (..), readAnswer, writeRequest)
import Dioptre.Conformance.Verdict (Case (..), Reason (..), Trouble (..), Verdict (..), judge)
import Dioptre.Files.Fault (FileFault)
import GHC.Clock (getMonotonicTime)

-- | How patient the runner is.
data Settings = Settings
  { -- | How many seconds a port may be silent while it owes answers.
    settingTimeout :: Double,
    -- | How many requests are sent ahead.
    settingWindow :: Int,
    -- | How many cases may end or silence the port before it is given up.
    settingStrikes :: Int
  }
  deriving stock (Eq, Show)

-- | Ten seconds, 64 requests, 20 strikes.
standardSettings :: Settings
standardSettings = Settings 10 64 20

-- | What a run found.
data Ran = Ran
  { -- | What the port said of itself.
    ranIntroduction :: Maybe Value,
    -- | A verdict for each case, in the order of the cases.
    ranVerdicts :: [(Case, Verdict)],
    -- | What was odd about the port beside the cases: how often, and the first few that are not the same.
    ranComplaints :: (Int, [Complaint])
  }
  deriving stock (Eq, Show)

-- | What a port should not do, and what harms no case.
data Complaint
  = -- | It said a line that is no answer: why it is none, and the line.
    NoAnswer Text Text
  | -- | It answered a request that there was none of, or twice: the line.
    UnknownRequest Text
  | -- | It did not say who it is.
    NoIntroduction
  | -- | It went on when its input had ended.
    DidNotEnd
  deriving stock (Eq, Show)

-- | Runs cases against a program with its arguments; each verdict is reported as it comes. A fault, if the program
-- cannot be started.
--
-- Spec: compare.verdicts.
runCases :: Settings -> IO () -> FilePath -> [String] -> [Case] -> IO (Either FileFault Ran)
runCases settings verdictGiven command arguments cases = go (Run IntMap.empty [] (IntMap.keys numbered) 0 Nothing False Nothing True 0 Seq.empty)
  where
    -- The number of a case is the identifier of its request; 0 is that of the first request, start.
    numbered = IntMap.fromDistinctAscList (zip [1 ..] cases)
    longest = if any mayBeLong cases then 64 * longestLine else longestLine
    go run
      | null (suspects run) && null (others run) = pure (Right (finished run))
      | strikes run >= (if everAnswered run then settingStrikes settings else min 3 (settingStrikes settings)) = do
        mapM_ (const verdictGiven) (suspects run <> others run)
        pure (Right (finished run))
      | otherwise = withPort longest command arguments (session settings numbered verdictGiven run) >>= either (pure . Left) go
    finished run =
      Ran
        { ranIntroduction = introduction run,
          ranVerdicts = [(c, IntMap.findWithDefault (Failed (Unanswered (GivenUp (lastTrouble run)))) n (verdicts run)) | (n, c) <- IntMap.toAscList numbered],
          ranComplaints = (complaintCount run, toList (complaints run))
        }

-- | The longest line of an answer, in bytes; a picture's may be 64 times as long.
longestLine :: Int
longestLine = 1024 * 1024

-- | Whether the answer is a whole picture.
mayBeLong :: Case -> Bool
mayBeLong c = caseOperation c == "scene.picture"

-- | What is known when a port is started.
data Run = Run
  { verdicts :: !(IntMap Verdict),
    -- | The cases that were outstanding when a port failed. Each is asked alone.
    suspects :: [Int],
    -- | The other cases that have no verdict yet.
    others :: [Int],
    -- | How many cases have ended or silenced a port by themselves.
    strikes :: !Int,
    -- | What was the matter with the last one.
    lastTrouble :: Maybe Trouble,
    everAnswered :: !Bool,
    introduction :: Maybe Value,
    -- | Whether ports are asked who they are.
    asksWho :: !Bool,
    complaintCount :: !Int,
    complaints :: !(Seq Complaint)
  }

-- | What happens between a port's start and its end.
data Exchange = Exchange
  { -- | The numbers of the requests without an answer.
    outstanding :: !IntSet,
    -- | When the port last gave an answer, or was last idle.
    since :: !Double,
    -- | How many lines since then were no answers.
    astray :: !Int,
    -- | How many answers had no identifier, since the port was started or was idle.
    unnamed :: !Int,
    -- | What the last of all these would mean for the request that it belongs to.
    meaning :: Reason
  }

-- | Asks a port until no case is left, or it fails.
session :: Settings -> IntMap Case -> IO () -> Run -> Port -> IO Run
session settings numbered verdictGiven start port = do
  now <- getMonotonicTime
  if asksWho start
    then do
      say port (writeRequest (Request 0 "start" (Object mempty)))
      listen start (Exchange (IntSet.singleton 0) now 0 0 nothing)
    else proceed start (Exchange IntSet.empty now 0 0 nothing)
  where
    nothing = Unanswered (GivenUp Nothing)

    -- Send what may be sent, and listen.
    proceed run e = case suspects run of
      n : rest
        | IntSet.null (outstanding e) -> ask n >> listen run {suspects = rest} e {outstanding = IntSet.singleton n}
        | otherwise -> listen run e
      [] -> do
        let (now, later) = splitAt (settingWindow settings - IntSet.size (outstanding e)) (others run)
            owed = outstanding e <> IntSet.fromList now
        mapM_ ask now
        if IntSet.null owed then farewell run else listen run {others = later} e {outstanding = owed}

    ask n = traverse_ (\c -> say port (writeRequest (Request n (caseOperation c) (caseInput c)))) (IntMap.lookup n numbered)

    listen run e = do
      now <- getMonotonicTime
      hear port (since e + patience e - now) >>= maybe (expired run e) (heard run e)

    -- Where every request may have been answered by a line that went astray, there is not much to wait for.
    patience e
      | allAstray e = min 1 (settingTimeout settings)
      | otherwise = settingTimeout settings
    allAstray e = let n = astray e + unnamed e in n > 0 && n >= IntSet.size (outstanding e)

    heard run e line = case line of
      NoMore -> do
        (code, words') <- ending port
        failed run e (Ended code words')
      TooLong -> failed run e (LongLine longestLine)
      Line bytes | Bytes.length bytes > longestLine && not (any isPicture (IntSet.toAscList (outstanding e))) -> failed run e (LongLine longestLine)
      Line bytes -> case readAnswer bytes of
        Left why -> wentAstray run e {astray = astray e + 1} (NoAnswer why (excerpt bytes)) (Unanswered (Babbled (excerpt bytes)))
        Right (Answer Nothing outcome) -> wentAstray run e {unnamed = unnamed e + 1} (NoAnswer "an answer without 'id'" (excerpt bytes)) (meaningOf bytes outcome)
        Right (Answer (Just n) outcome)
          | n `IntSet.member` outstanding e -> answered run e n bytes outcome
          | otherwise -> listen (complain (UnknownRequest (excerpt bytes)) run) e

    isPicture n = maybe False mayBeLong (IntMap.lookup n numbered)

    meaningOf bytes outcome = case outcome of
      Fault why -> Refused why
      _ -> Unanswered (Babbled (excerpt bytes))

    wentAstray run e complaint reason
      | astray e + unnamed e > mostAstray = failed run e (Babbled (told reason))
      | otherwise = listen (complain complaint run) e {meaning = reason}
      where
        told r = case r of
          Unanswered (Babbled line) -> line
          Refused why -> why
          _ -> ""

    answered run e n bytes outcome = do
      now <- getMonotonicTime
      let rest = e {outstanding = IntSet.delete n (outstanding e), since = now, astray = 0}
      case IntMap.lookup n numbered of
        Nothing -> proceed (introduced outcome run) rest
        Just c -> do
          let verdict
                | Bytes.length bytes > longestLine && not (mayBeLong c) = Failed (Unanswered (LongLine longestLine))
                | otherwise = judge c outcome
          run' <- give n verdict run {everAnswered = True}
          proceed run' rest

    introduced outcome run = case outcome of
      Ok who | isNothing (introduction run) -> run {introduction = Just who, everAnswered = True}
      Ok _ -> run
      _ -> complain NoIntroduction run {asksWho = False, everAnswered = True}

    expired run e
      | allAstray e = do
        run' <- blame (meaning e) (IntSet.toAscList (outstanding e)) run
        resume run'
      | outstanding e == IntSet.singleton 0 = resume (complain NoIntroduction run {asksWho = False})
      | otherwise = failed run e (Silent (settingTimeout settings))
      where
        resume run' = do
          now <- getMonotonicTime
          proceed run' (Exchange IntSet.empty now 0 0 nothing)

    -- The port is of no use any more. See Note [Whose fault].
    failed run e trouble = case IntSet.toAscList (outstanding e) of
      [n] -> blame (Unanswered trouble) [n] run {strikes = strikes run + 1, lastTrouble = Just trouble}
      several -> pure run {suspects = several <> suspects run}

    blame reason ns run = case ns of
      0 : rest -> blame reason rest (complain NoIntroduction run)
      n : rest -> give n (Failed reason) run >>= blame reason rest
      [] -> pure run

    give n verdict run = verdict `seq` verdictGiven >> pure run {verdicts = IntMap.insert n verdict (verdicts run)}

    farewell run = do
      close port
      now <- getMonotonicTime
      untilEnd (now + min 2 (settingTimeout settings)) run

    untilEnd deadline run = do
      now <- getMonotonicTime
      hear port (deadline - now) >>= \case
        Just NoMore -> pure run
        Just (Line bytes) -> untilEnd deadline (complain (UnknownRequest (excerpt bytes)) run)
        Just TooLong -> untilEnd deadline run
        Nothing -> pure (complain DidNotEnd run)

-- | Keeps the first few complaints that are not the same, and counts all of them.
complain :: Complaint -> Run -> Run
complain complaint run =
  run
    { complaintCount = complaintCount run + 1,
      complaints = if Seq.length (complaints run) < 5 && complaint `notElem` complaints run then complaints run |> complaint else complaints run
    }

-- | The beginning of a line, for a message.
excerpt :: ByteString -> Text
excerpt bytes = Text.take 200 (Text.decodeUtf8With lenientDecode (Bytes.take 800 bytes))

-- | So many lines in a row that belong to no request are a flood.
mostAstray :: Int
mostAstray = 1000

-- Note [Whose fault]
-- ~~~~~~~~~~~~~~~~~~
-- When a port ends, or says nothing for too long, with several requests outstanding, any of them may be why: ports may
-- answer in any order, and answers may have been lost in a buffer. None of them is blamed then. The port is started
-- again and asked these, one at a time; a case that is alone when the port fails fails, and counts as a strike. The
-- others go on, and the window opens again.
--
-- An answer without an identifier belongs to a request that cannot be told; when there are as many of them as there are
-- requests outstanding, and nothing more comes for a second, they were the answers to these, which fail. A line that is
-- no answer at all may be an answer gone wrong, or chatter. It counts in the same way, but only until the next answer,
-- so that a port that merely chatters between its answers loses nothing.
