{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Dioptre.View.Conversation
-- Description : One page that is open
--
-- Two threads for each: one listens, one tells the news. Whichever ends first, because the page was closed, ends both.
module Dioptre.View.Conversation
  ( Showing (..),
    converse,
    longestMessage,
  )
where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (Async, async, cancel, race_)
import Control.Concurrent.STM
import Control.Exception (IOException, bracket, evaluate, finally, handle)
import Control.Monad (forM_, forever, when)
import Data.Aeson (encode)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef (IORef, newIORef, readIORef, writeIORef)
import Data.Int (Int64)
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Explain.Json (storyJson)
import Dioptre.Explain.Wording (storyText)
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Whole (readWhole, writeWhole)
import Dioptre.Load (storyAt)
import Dioptre.Source.Language (Language)
import Dioptre.Source.Text (decode, sourceText)
import Dioptre.View.Desk
import Dioptre.View.Frame (Frame (..), Strip (..), stripBytes)
import Dioptre.View.Message
import Dioptre.View.News (News (..), news, nothing)
import Dioptre.View.Painter (Table)
import Dioptre.View.Wording (Refusal (..))
import Network.WebSockets (Connection, ConnectionException, receiveData, sendBinaryData, sendTextData)
import System.FilePath (takeFileName)

-- | The scene that is viewed.
data Showing = Showing
  { -- | Its name in messages; files that it names are looked for beside it.
    showingPath :: FilePath,
    -- | Whether there is such a file, to be saved to.
    showingHasFile :: Bool,
    -- | The desk on which it lies.
    showingTable :: Table
  }

-- | Talks with a page until it is closed.
converse :: Showing -> Connection -> IO ()
converse scene connection =
  handle gone . handle broken . bracket arrive (const leave) $ \page -> do
    replies <- newTVarIO Seq.empty
    question <- newIORef Nothing
    race_ (listen scene page replies question connection) (tellNews scene page replies connection) `finally` (readIORef question >>= mapM_ cancel)
  where
    arrive = atomically (stateTVar (showingTable scene) (\desk -> let desk' = entered desk in (deskVisits desk', desk')))
    leave = atomically (modifyTVar' (showingTable scene) left)
    gone :: ConnectionException -> IO ()
    gone _ = pure ()
    broken :: IOException -> IO ()
    broken _ = pure ()

-- | Answers that wait to be sent.
type Replies = TVar (Seq Lazy.ByteString)

-- | Tells the page all news, a batch at a time.
tellNews :: Showing -> Int -> Replies -> Connection -> IO ()
tellNews scene page replies connection = do
  l <- deskLanguage <$> readTVarIO (showingTable scene)
  say (Hello page l (Text.pack (takeFileName (showingPath scene))) (showingHasFile scene))
  go (nothing l)
  where
    go told = do
      (batch, answers, told') <- atomically $ do
        desk <- readTVar (showingTable scene)
        picture <- traverse (\frame -> (,) frame <$> readTVar (frameProgress frame)) (deskFrame desk)
        answers <- swapTVar replies Seq.empty
        let (batch, told') = news told desk picture
        when (null batch && Seq.null answers) retry
        pure (batch, answers, told')
      forM_ batch $ \case
        Say message -> say message
        Show frame fine strips -> shownRows frame fine strips >>= sendBinaryData connection
      mapM_ (sendTextData connection) answers
      threadDelay betweenBatches
      go told'
    say = sendTextData connection . encode . messageJson
    -- In microseconds: as often as the eye can follow.
    betweenBatches = 30000

-- | The message with some strips' bytes.
shownRows :: Frame -> Bool -> [Int] -> IO Lazy.ByteString
shownRows frame fine numbers = do
  rows <- traverse (\k -> (,) k <$> stripBytes frame (if fine then Fine k else Coarse k)) numbers
  let size = maximum (0 : map (Bytes.length . snd) rows)
  pure (Builder.toLazyByteString (rowsHeader fine (frameNumber frame) size (length rows) <> foldMap (\(k, bytes) -> rowHeader k <> Builder.byteString bytes) rows))

-- | Does what the page asks for.
listen :: Showing -> Int -> Replies -> IORef (Maybe (Async ())) -> Connection -> IO ()
listen scene page replies question connection = forever $ do
  bytes <- receiveData connection
  l <- deskLanguage <$> readTVarIO (showingTable scene)
  let refuse number = reply . encode . messageJson . Refused l number
      change = atomically . modifyTVar' (showingTable scene)
  case ask bytes of
    Left reason -> refuse Nothing (NotUnderstood reason)
    Right asked -> case asked of
      Edit version text
        | Bytes.length (Text.encodeUtf8 text) > longestText -> refuse Nothing TooMuchText
        | otherwise -> change (typed page version text)
      Explain number column row -> do
        -- A newer question ends an older one.
        readIORef question >>= mapM_ cancel
        frame <- deskFrame <$> readTVarIO (showingTable scene)
        running <- async $ case frame of
          Nothing -> refuse (Just number) NoPicture
          Just shown -> storyOf l scene shown number column row >>= either (refuse (Just number)) reply
        writeIORef question (Just running)
      Speak other -> change (spoken other)
      Save overwriting -> save scene overwriting >>= either (refuse Nothing) (change . savedToDisk)
      Reload -> change takenFromDisk
      Draw -> change drawnAnyway
  where
    -- Of answers that are not fetched, the last ones stay.
    reply answer = atomically (modifyTVar' replies (\waiting -> Seq.drop (Seq.length waiting - mostReplies) (waiting |> answer)))
    mostReplies = 8

-- | The message with the story of a pixel of a frame, or why there is none.
storyOf :: Language -> Showing -> Frame -> Int -> Int -> Int -> IO (Either Refusal Lazy.ByteString)
storyOf l scene frame number column row =
  case storyAt (frameLoaded frame) column row of
    Nothing -> pure (Left OutsideOfPicture)
    Just story -> do
      let name = Text.pack (showingPath scene)
          bytes = Lazy.take (longestStory + 1) (encode (messageJson (Story number (frameNumber frame) (storyJson name story) (storyText l name story))))
      size <- evaluate (Lazy.length bytes)
      pure (if size > longestStory then Left TooLong else Right bytes)

-- | Writes the text to the scene's file, whose line ends stay as they are; returns the text.
save :: Showing -> Bool -> IO (Either Refusal Text)
save scene overwriting
  | not (showingHasFile scene) = pure (Left NoFile)
  | otherwise = do
    desk <- readTVarIO (showingTable scene)
    before <- readWhole path
    let changed = either (const False) ((/= deskDisk desk) . Just . sourceText . decode path) before
        ends = either (const id) (\bytes -> if Char8.pack "\r\n" `Bytes.isInfixOf` bytes then Text.replace (Text.pack "\n") (Text.pack "\r\n") else id) before
    if (changed || deskConflict desk) && not overwriting
      then pure (Left ChangedMeanwhile)
      else either (Left . NotSaved) (const (Right (deskText desk))) <$> writeWhole path (contents (Lazy.fromStrict (Text.encodeUtf8 (ends (deskText desk)))))
  where
    path = showingPath scene

-- | A page's message has so many bytes at most: room for a text in which every character is written in six, and for
-- what goes around it.
longestMessage :: Int
longestMessage = 8 * longestText

-- | A story has so many bytes at most.
longestStory :: Int64
longestStory = 8 * 1024 * 1024
