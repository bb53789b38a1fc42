{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.View.Server
-- Description : The viewer: a page in the browser, and what it talks to
--
-- > the file ---watch---> desk <---typing--- page, page ...
-- > other files --watch--|  \----news--->
-- >                     painter
--
-- It listens on 127.0.0.1 only, and only to whoever names the run's token ("Dioptre.View.Guard" says who may speak
-- there). Nothing that a page says reaches the disk, except that the text is written to the scene's file where a page
-- asks for that.
module Dioptre.View.Server
  ( Settings (..),
    Viewer (..),
    withViewer,
  )
where

import Control.Concurrent.Async (link, withAsync)
import Control.Concurrent.STM (atomically, modifyTVar', newTVarIO, readTVarIO)
import Control.Exception (IOException, bracket, bracketOnError, try)
import Control.Monad (join)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isAlphaNum, isAscii)
import Data.Maybe (isJust)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Load (Loaded (..))
import Dioptre.Picture.Png (encode)
import qualified Dioptre.Scene as Scene
import Dioptre.Scene.Camera (viewportImage)
import Dioptre.Source.Language (Language)
import Dioptre.Source.Text (Source, sourceName, sourceText)
import Dioptre.View.Conversation (Showing (..), converse, longestMessage)
import Dioptre.View.Desk
import Dioptre.View.Frame
import Dioptre.View.Guard (Token, Verdict (..), Wish (..), address, newToken, verdict)
import qualified Dioptre.View.Guard as Guard
import Dioptre.View.Ingredients (watchingIngredients)
import Dioptre.View.Page (pageFile)
import Dioptre.View.Painter (Table, paintDesk)
import Dioptre.View.Watch (watching)
import Dioptre.View.Wording (rejection)
import qualified Network.HTTP.Types as Http
import Network.Socket
import Network.Wai (Application, Middleware, Request, Response, pathInfo, queryString, rawPathInfo, requestHeaderHost, requestHeaders, requestMethod, responseLBS)
import qualified Network.Wai.Handler.Warp as Warp
import Network.Wai.Handler.WebSockets (isWebSocketsReq, websocketsOr)
import qualified Network.WebSockets as WebSockets
import Text.Read (readMaybe)

-- | How to view a scene.
data Settings = Settings
  { -- | At which port; any free one if there is none.
    settingPort :: Maybe Int,
    -- | In which messages are at first.
    settingLanguage :: Language,
    -- | Whether the scene is drawn also while no page is open.
    settingUnwatched :: Bool,
    -- | The scene's text.
    settingSource :: Source,
    -- | Whether its name is the path of a file, which is watched and may be saved to.
    settingHasFile :: Bool
  }

-- | A viewer that runs.
data Viewer = Viewer
  { -- | Where its page is, with the token.
    viewerAddress :: String,
    -- | What it shows.
    viewerTable :: Table
  }

-- | Runs a viewer while some work is done, and ends it with all that belongs to it. Or says why the port cannot be had.
withViewer :: Settings -> (Viewer -> IO a) -> IO (Either IOException a)
withViewer settings act = do
  opened <- try (listening (maybe 0 fromIntegral (settingPort settings)))
  case opened of
    Left e -> pure (Left e)
    Right own -> fmap Right . bracket (pure own) close $ \socket' -> do
      port <- fromIntegral <$> socketPort socket'
      token <- newToken
      table <- newTVarIO (newDesk (settingLanguage settings) (settingHasFile settings) (settingUnwatched settings) (sourceText (settingSource settings)))
      let scene = Showing path (settingHasFile settings) table
          serve = Warp.runSettingsSocket (Warp.setServerName "" (Warp.setPort port Warp.defaultSettings)) socket' (application token port scene)
          watched
            | settingHasFile settings = watching path (atomically . modifyTVar' table . foundOnDisk . sourceText)
            | otherwise = id
      withAsync serve $ \server -> withAsync (paintDesk path table) $ \painter -> do
        link server
        link painter
        watched (watchingIngredients table (act (Viewer (address token port) table)))
  where
    path = sourceName (settingSource settings)

-- | A socket that listens at a port of this machine that only this machine reaches; 0 is any free one.
listening :: PortNumber -> IO Socket
listening port = bracketOnError (socket AF_INET Stream defaultProtocol) close $ \own -> do
  setSocketOption own ReuseAddr 1
  bind own (SockAddrInet port (tupleToHostAddress (127, 0, 0, 1)))
  listen own 64
  pure own

-- | What answers requests at a port.
application :: Token -> Int -> Showing -> Application
application token port scene = guarded token port (websocketsOr options conversation (files port scene))
  where
    options = WebSockets.defaultConnectionOptions {WebSockets.connectionFramePayloadSizeLimit = limit, WebSockets.connectionMessageDataSizeLimit = limit}
    limit = WebSockets.SizeLimit (fromIntegral longestMessage)
    conversation pending
      | Char8.takeWhile (/= '?') (WebSockets.requestPath (WebSockets.pendingRequest pending)) /= "/live" = WebSockets.rejectRequest pending "there is nothing here"
      | otherwise = do
        pages <- deskPages <$> readTVarIO (showingTable scene)
        if pages >= mostPages
          then WebSockets.rejectRequest pending "too many pages are open"
          else WebSockets.acceptRequest pending >>= converse scene

-- | So many pages may be open.
mostPages :: Int
mostPages = 64

-- | Refuses whoever may not speak here.
guarded :: Token -> Int -> Middleware
guarded token port inner request respond = case verdict token port asked of
  Admitted -> inner request respond
  refused -> respond (plain port Http.status403 (Lazy.fromStrict (Text.encodeUtf8 (rejection refused))))
  where
    asked = Guard.Request (requestHeaderHost request) (lookup "Origin" (requestHeaders request)) (join (lookup "token" (queryString request))) wish
    wish
      | isWebSocketsReq request = Conversation
      | isJust (asPageFile request) = PageFile
      | otherwise = Data

-- | The kind and the contents of the file of the page that a request is about, if it is about one.
asPageFile :: Request -> Maybe (ByteString, ByteString)
asPageFile = pageFile . drop 1 . Char8.unpack . rawPathInfo

-- | The files of the page, and the picture.
files :: Int -> Showing -> Application
files port scene request respond
  | requestMethod request `notElem` [Http.methodGet, Http.methodHead] = respond (plain port Http.status405 "only GET and HEAD")
  | otherwise = case pathInfo request of
    ["picture.png"] -> do
      desk <- readTVarIO (showingTable scene)
      case (deskFinished desk, lookup "render" (queryString request)) of
        (Just frame, Just (Just number)) | readMaybe (Char8.unpack number) == Just (frameNumber frame) -> do
          bytes <- encode <$> framePicture frame
          respond (found port "image/png" [("Content-Disposition", "inline; filename=\"" <> pictureName frame <> "\"")] bytes)
        _ -> respond (plain port Http.status404 "there is no such picture")
    _ -> case asPageFile request of
      Just (kind, bytes) -> respond (found port kind [] (Lazy.fromStrict bytes))
      Nothing -> respond (plain port Http.status404 "there is nothing here")

-- | The name of a picture's file, of characters that are safe everywhere.
pictureName :: Frame -> ByteString
pictureName frame = Char8.pack (map safe (Text.unpack (viewportImage (Scene.sceneViewport (loadedScene (frameLoaded frame))))) <> ".png")
  where
    safe c = if isAscii c && (isAlphaNum c || c `elem` ("-_." :: String)) then c else '_'

-- | An answer with contents of a kind.
found :: Int -> ByteString -> [Http.Header] -> Lazy.ByteString -> Response
found port kind more = responseLBS Http.status200 (("Content-Type", kind) : more <> precautions port)

-- | An answer in words.
plain :: Int -> Http.Status -> Lazy.ByteString -> Response
plain port status words' = responseLBS status (("Content-Type", "text/plain; charset=utf-8") : precautions port) (words' <> "\n")

-- | What a browser is told with every answer: the page takes everything from here and nothing from elsewhere, and no
-- other page may use it.
precautions :: Int -> [Http.Header]
precautions port =
  [ ( "Content-Security-Policy",
      Char8.intercalate
        "; "
        [ "default-src 'none'",
          "script-src 'self'",
          "style-src 'self'",
          "img-src 'self' blob: data:",
          "connect-src 'self' ws://127.0.0.1:" <> shown <> " ws://localhost:" <> shown,
          "base-uri 'none'",
          "form-action 'none'",
          "frame-ancestors 'none'"
        ]
    ),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("X-Content-Type-Options", "nosniff"),
    ("Referrer-Policy", "no-referrer"),
    ("Cache-Control", "no-store")
  ]
  where
    shown = Char8.pack (show port)
