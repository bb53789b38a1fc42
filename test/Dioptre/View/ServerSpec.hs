{-# LANGUAGE OverloadedStrings #-}

-- | The viewer from outside: a page's requests and messages, over a real socket. (The page itself, in a real browser,
-- is tried by test/browser.)
module Dioptre.View.ServerSpec (spec) where

import Control.Concurrent (threadDelay)
import Control.Concurrent.STM (atomically, check, readTVar, readTVarIO)
import Control.Exception (SomeException, bracket, try)
import Control.Monad (replicateM_, unless, void)
import Data.Aeson (Value (..), object, (.=))
import qualified Data.Aeson as Json
import Data.Aeson.Types (parseMaybe, withObject, (.:))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import Data.Either (fromRight, isLeft)
import Data.Foldable (for_)
import Data.Maybe (isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Explain.Json (storyJson)
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Whole (writeWhole)
import Dioptre.Load (loadSource, loadedPlan, storyAt)
import qualified Dioptre.Picture.Png as Png
import Dioptre.Render (rendered)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Text (decode, fromText)
import Dioptre.View.Desk (Desk (..))
import Dioptre.View.Frame (Frame (..), Progress (..))
import Dioptre.View.Server
import Network.Socket
import Network.Socket.ByteString (recv, sendAll)
import qualified Network.WebSockets as WebSockets
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Timeout (timeout)
import Test.Hspec

spec :: Spec
spec = do
  describe "as a server of files" . around (viewed small) $ do
    it "gives the page, which takes everything from here" $ \(viewer, _) -> do
      answer <- get viewer [] "/"
      status answer `shouldBe` 200
      header "content-type" answer `shouldBe` Just "text/html; charset=utf-8"
      header "content-security-policy" answer `shouldSatisfy` maybe False ("default-src 'none'; script-src 'self'; " `Bytes.isPrefixOf`)
    it "gives its own files to everybody" $ \(viewer, _) -> do
      answers <- traverse (get viewer []) ["/", "/index.html", "/main.js", "/style.css", "/icon.svg"]
      map status answers `shouldBe` [200, 200, 200, 200, 200]
      answers `shouldSatisfy` not . any (token viewer `Bytes.isInfixOf`)
    it "has another token each time" $ \(viewer, _) -> viewed small $ \(viewer', _) -> token viewer `shouldNotBe` token viewer'
    for_ [("no", const ""), ("an empty", const "token="), ("a valueless", const "token"), ("a shorter", ("token=" <>) . Bytes.init . token), ("a longer", (<> "0") . named), ("another", ("token=" <>) . Char8.reverse . Char8.map (\c -> if c == '0' then '1' else '0') . token), ("a repeated", ("token=0&" <>) . named)] $ \(which, query) -> do
      for_ ["/picture.png?render=1&", "/picture.png?", "/nothing?", "/scene.txt?", "/live?"] $ \path ->
        it ("gives nothing of " <> show path <> " to " <> which <> " token, and says why in both languages") $ \(viewer, _) -> do
          answer <- get viewer [] (path <> query viewer)
          status answer `shouldBe` 403
          Text.decodeUtf8 (body answer) `shouldBe` "the token of this run is missing or wrong: open the whole address that the program printed / le jeton de cette exécution manque ou est faux\xA0: ouvrez l'adresse entière que le programme a affichée\n"
      for_ ["/live?", "/?", "/main.js?", "/picture.png?render=1&"] $ \path ->
        it ("does not converse at " <> show path <> " with " <> which <> " token") $ \(viewer, _) -> do
          answer <- request viewer "GET" (upgrade viewer ("http://" <> host viewer)) (path <> query viewer)
          status answer `shouldBe` 403
          desk <- readTVarIO (viewerTable viewer)
          deskVisits desk `shouldBe` 0
    for_ ["/nothing", "/../setup.sh", "/%2e%2e/setup.sh", "//etc/passwd", "/etc/passwd", "/scene.txt", "/picture.png", "/picture.png?render=99", "/picture.png?render=../1"] $ \path ->
      it ("gives nothing else: " <> show path) $ \(viewer, _) -> get viewer [] (withToken viewer path) >>= (`shouldBe` 404) . status
    it "only gives" $ \(viewer, _) -> request viewer "POST" [("Host", host viewer)] "/" >>= (`shouldBe` 405) . status
    it "answers to no other name" $ \(viewer, _) -> request viewer "GET" [("Host", "evil.example")] "/" >>= (`shouldBe` 403) . status
    for_ ["http://evil.example", "null", "https://127.0.0.1"] $ \origin ->
      it ("does not converse with a page from " <> show origin) $ \(viewer, _) ->
        request viewer "GET" (upgrade viewer origin) (withToken viewer "/live") >>= (`shouldBe` 403) . status
    it "converses nowhere else" $ \(viewer, _) ->
      request viewer "GET" (upgrade viewer ("http://" <> host viewer)) (withToken viewer "/other") >>= (`shouldBe` 400) . status
    it "tells that a port is taken" $ \(viewer, _) -> do
      outcome <- withViewer (Settings (Just (portOf viewer)) English False (fromText "scene.txt" small) False) (const (pure ()))
      outcome `shouldSatisfy` isLeft

  describe "in conversation" . around (viewed small) $ do
    it "shows the picture that render draws" $ \(viewer, path) -> talking viewer $ \c -> do
      done <- await c "done"
      let picture = maybe "" Text.encodeUtf8 (textAt "picture" done)
      answer <- get viewer [] (withToken viewer picture)
      expected <- pictureOf path small
      Lazy.fromStrict (body answer) `shouldBe` expected
      header "content-type" answer `shouldBe` Just "image/png"
    it "sends every row of it" $ \(viewer, _) -> talking viewer $ \c -> do
      rows <- rowsUntilDone c
      length (filter fst rows) `shouldBe` 30
      length (filter (not . fst) rows) `shouldBe` 4
    it "tells the story that explain tells" $ \(viewer, path) -> talking viewer $ \c -> do
      void (await c "done")
      say c ["type" .= ("explain" :: Text), "id" .= (5 :: Int), "column" .= (20 :: Int), "row" .= (15 :: Int)]
      story <- await c "story"
      loaded <- loadSource English (fromText path small)
      let expected = storyJson (Text.pack path) <$> storyAt loaded 20 15
      valueAt "story" story `shouldBe` (expected >>= Json.decode . Json.encode)
      valueAt "id" story `shouldBe` Just (Number 5)
    it "refuses a pixel that is not there" $ \(viewer, _) -> talking viewer $ \c -> do
      void (await c "done")
      say c ["type" .= ("explain" :: Text), "id" .= (6 :: Int), "column" .= (40 :: Int), "row" .= (0 :: Int)]
      refused <- await c "refused"
      (valueAt "id" refused, textAt "message" refused) `shouldBe` (Just (Number 6), Just "this pixel is outside of the picture")
    it "draws what is typed" $ \(viewer, path) -> talking viewer $ \c -> do
      void (await c "done")
      say c (edit other)
      done <- await c "done"
      answer <- get viewer [] (withToken viewer (maybe "" Text.encodeUtf8 (textAt "picture" done)))
      expected <- pictureOf path other
      Lazy.fromStrict (body answer) `shouldBe` expected
    it "keeps the last good picture while there are errors, and tells where they are" $ \(viewer, _) -> talking viewer $ \c -> do
      void (await c "done")
      say c (edit faulty)
      found <- await c "diagnostics"
      (valueAt "faults" found, valueAt "drawn" found) `shouldBe` (Just (Bool True), Just (Bool False))
      (concatMap (\d -> [valueAt "line" d]) (listAt "diagnostics" found), valueAt "own" =<< firstOf (listAt "diagnostics" found)) `shouldBe` ([Just (Number 13)], Just (Bool True))
      frame <- deskFrame <$> readTVarIO (viewerTable viewer)
      fmap frameVersion frame `shouldBe` Just 1
      -- On demand it is drawn all the same
      say c ["type" .= ("draw" :: Text)]
      void (await c "done")
      again <- deskFrame <$> readTVarIO (viewerTable viewer)
      fmap frameVersion again `shouldBe` Just 2
    it "speaks French" $ \(viewer, _) -> talking viewer $ \c -> do
      void (await c "done")
      say c (edit faulty)
      void (await c "diagnostics")
      say c ["type" .= ("language" :: Text), "language" .= ("fr" :: Text)]
      found <- await c "diagnostics"
      map (textAt "severityName") (listAt "diagnostics" found) `shouldBe` [Just "erreur"]
    for_ ["{", "[]", "{}", "{\"type\":\"x\"}", "{\"type\":\"edit\"}", "{\"type\":\"edit\",\"text\":1}", "{\"type\":\"explain\",\"id\":1,\"column\":1.5,\"row\":0}", "{\"type\":\"explain\",\"id\":1,\"column\":1e99,\"row\":0}", "\xFF\xFE"] $ \nonsense ->
      it ("refuses " <> show nonsense <> ", and goes on") $ \(viewer, _) -> talking viewer $ \c -> do
        WebSockets.sendBinaryData c (nonsense :: ByteString)
        void (await c "refused")
        say c (edit other)
        void (await c "done")
    it "refuses a text that is too long" $ \(viewer, _) -> talking viewer $ \c -> do
      say c (edit (Text.replicate (1024 * 1024 + 1) "x"))
      refused <- await c "refused"
      textAt "message" refused `shouldBe` Just "this text is too long for the page; it is not taken over"
    it "ends with who sends too much" $ \(viewer, _) -> do
      outcome <- try (talking viewer (\c -> WebSockets.sendBinaryData c (Bytes.replicate (9 * 1024 * 1024) 32) >> await c "nothing"))
      either (const True :: SomeException -> Bool) (const False) outcome `shouldBe` True
      talking viewer (\c -> void (await c "hello"))

  describe "and the file" . around (viewed small) $ do
    it "draws what an editor writes" $ \(viewer, path) -> talking viewer $ \c -> do
      void (await c "done")
      write path other
      scene <- await c "scene"
      (textAt "text" scene, textAt "by" scene, valueAt "saved" scene) `shouldBe` (Just other, Just "disk", Just (Bool True))
      void (await c "done")
    it "writes only when asked" $ \(viewer, path) -> talking viewer $ \c -> do
      say c (edit other)
      awaitSuch c "scene" ((== Just other) . textAt "text")
      Bytes.readFile path >>= (`shouldBe` Text.encodeUtf8 small)
      say c ["type" .= ("save" :: Text)]
      awaitSuch c "scene" ((== Just (Bool True)) . valueAt "saved")
      Bytes.readFile path >>= (`shouldBe` Text.encodeUtf8 other)
    it "loses neither of two changes" $ \(viewer, path) -> talking viewer $ \c -> do
      say c (edit other)
      awaitSuch c "scene" ((== Just other) . textAt "text")
      write path (small <> "# by another\n")
      awaitSuch c "scene" ((== Just (Bool True)) . valueAt "conflict")
      say c ["type" .= ("save" :: Text)]
      refused <- await c "refused"
      textAt "message" refused `shouldBe` Just "the file has changed meanwhile; nothing was written"
      Bytes.readFile path >>= (`shouldBe` Text.encodeUtf8 (small <> "# by another\n"))
      say c ["type" .= ("save" :: Text), "overwrite" .= True]
      awaitSuch c "scene" ((== Just (Bool True)) . valueAt "saved")
      Bytes.readFile path >>= (`shouldBe` Text.encodeUtf8 other)
    it "keeps the file's line ends" $ \(viewer, path) -> talking viewer $ \c -> do
      void (await c "done")
      Bytes.writeFile path (Text.encodeUtf8 (Text.replace "\n" "\r\n" (small <> "# 2\n")))
      awaitSuch c "scene" ((== Just (small <> "# 2\n")) . textAt "text")
      say c (editOf 2 other)
      say c ["type" .= ("save" :: Text)]
      awaitSuch c "scene" (\m -> valueAt "saved" m == Just (Bool True) && textAt "text" m == Just other)
      Bytes.readFile path >>= (`shouldBe` Text.encodeUtf8 (Text.replace "\n" "\r\n" other))

  describe "and its work" $ do
    it "ends with the page that looked" . viewed slow $ \(viewer, _) -> do
      progress <- talking viewer $ \c -> do
        void (await c "start")
        desk <- readTVarIO (viewerTable viewer)
        maybe (fail "no picture is begun") (pure . frameProgress) (deskFrame desk)
      atomically (readTVar (viewerTable viewer) >>= check . (== 0) . deskPages)
      -- The workers end within a row; from then on nothing is painted any more
      threadDelay 500000
      early <- progressRows <$> readTVarIO progress
      threadDelay 500000
      late <- progressRows <$> readTVarIO progress
      late `shouldBe` early
      readTVarIO (viewerTable viewer) >>= (`shouldBe` Nothing) . fmap frameNumber . deskFrame
    it "ends with the text that it was for, within a second" . viewed slow $ \(viewer, _) -> talking viewer $ \c -> do
      void (await c "start")
      say c (edit small)
      finished <- timeout 1000000 (await c "done")
      fmap (valueAt "render") finished `shouldBe` Just (Just (Number 2))
    it "is not kept up by a page that does not listen" . viewed large $ \(viewer, _) -> talking viewer $ \deaf -> do
      -- 16 MB are waiting for this one, which takes nothing
      talking viewer $ \c -> void (await c "done")
      void (await deaf "done")
    it "goes on without a page where that is wanted" $ do
      outcome <- withViewer (Settings Nothing English True (fromText "scene.txt" small) False) $ \viewer ->
        timeout 5000000 (atomically (readTVar (viewerTable viewer) >>= check . isJust . deskFinished))
      fromRight Nothing outcome `shouldBe` Just ()
    it "survives many pages that come and go" . viewed slow $ \(viewer, _) -> do
      replicateM_ 50 (talking viewer (\c -> void (await c "hello")))
      atomically (readTVar (viewerTable viewer) >>= check . (== 0) . deskPages)
      talking viewer (\c -> void (await c "start"))

-- | A scene that is drawn in no time, another one, one with an error in line 13, one that takes long, and one with many
-- pixels.
small, other, faulty, slow, large :: Text
small = "viewport\nwidth 40\nheight 30\nend\nmaterial\nname red\ncolor 1 0 0\nend\nprimitive\nmaterial_name red\nsphere\nposition 5 0 0\nray 1\nend\nend\n"
other = Text.replace "ray 1\n" "ray 2\n" small
faulty = Text.replace "ray 1\n" "rey 1\n" small
slow = Text.replace "height 30\n" "height 2000\n" (Text.replace "width 40\n" "width 2000\n" small) <> "raytracer\nsampling 64\nend\n"
large = Text.replace "height 30\n" "height 2000\n" (Text.replace "width 40\n" "width 2000\n" small)

-- | Runs a viewer of a file with that text.
viewed :: Text -> ((Viewer, FilePath) -> IO ()) -> IO ()
viewed text act = withSystemTempDirectory "dioptre-view" $ \folder -> do
  let path = folder </> "scene.txt"
  write path text
  outcome <- timeout 60000000 (withViewer (Settings Nothing English False (fromText path text) True) (\viewer -> act (viewer, path)))
  case outcome of
    Just (Right ()) -> pure ()
    Just (Left e) -> fail (show e)
    Nothing -> fail "took a minute"

write :: FilePath -> Text -> IO ()
write path text = writeWhole path (contents (Lazy.fromStrict (Text.encodeUtf8 text))) >>= either (fail . show) pure

-- | The file that render writes for a text.
pictureOf :: FilePath -> Text -> IO Lazy.ByteString
pictureOf path text = do
  loaded <- loadSource English (decode path (Text.encodeUtf8 text))
  pure (Png.encode (rendered (loadedPlan loaded)))

-------------------------------------------------------------------------------
-- Requests

portOf :: Viewer -> Int
portOf = maybe 0 fst . Char8.readInt . snd . Char8.breakEnd (== ':') . host

host :: Viewer -> ByteString
host viewer = Char8.pack (takeWhile (/= '/') (drop 7 (viewerAddress viewer)))

-- | The token of a viewer, alone and as it is named in requests.
token, named :: Viewer -> ByteString
token = snd . Char8.breakEnd (== '=') . Char8.pack . viewerAddress
named viewer = "token=" <> token viewer

withToken :: Viewer -> ByteString -> ByteString
withToken viewer path = path <> (if Char8.elem '?' path then "&" else "?") <> named viewer

-- | The headers that ask for a conversation with a page of that origin.
upgrade :: Viewer -> ByteString -> [(ByteString, ByteString)]
upgrade viewer origin = [("Host", host viewer), ("Origin", origin), ("Connection", "Upgrade"), ("Upgrade", "websocket"), ("Sec-WebSocket-Version", "13"), ("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ==")]

get :: Viewer -> [(ByteString, ByteString)] -> ByteString -> IO ByteString
get viewer more = request viewer "GET" (("Host", host viewer) : more)

-- | The whole answer to a request.
request :: Viewer -> ByteString -> [(ByteString, ByteString)] -> ByteString -> IO ByteString
request viewer method headers path = bracket (socket AF_INET Stream defaultProtocol) close $ \s -> do
  connect s (SockAddrInet (fromIntegral (portOf viewer)) (tupleToHostAddress (127, 0, 0, 1)))
  sendAll s (Bytes.concat ([method, " ", path, " HTTP/1.0\r\n"] <> concat [[name, ": ", value, "\r\n"] | (name, value) <- headers] <> ["\r\n"]))
  let rest = recv s 65536 >>= \bytes -> if Bytes.null bytes then pure [] else (bytes :) <$> rest
  Bytes.concat <$> rest

status :: ByteString -> Int
status answer = maybe 0 fst (Char8.readInt (Bytes.drop 9 answer))

header :: ByteString -> ByteString -> Maybe ByteString
header name answer = lookup name [(Char8.map toLower n, Char8.dropWhile (== ' ') (Bytes.drop 1 v)) | line <- Char8.lines (fst (Bytes.breakSubstring "\r\n\r\n" answer)), (n, v) <- [Char8.break (== ':') (Char8.filter (/= '\r') line)]]

body :: ByteString -> ByteString
body = Bytes.drop 4 . snd . Bytes.breakSubstring "\r\n\r\n"

-------------------------------------------------------------------------------
-- Conversations

talking :: Viewer -> (WebSockets.Connection -> IO a) -> IO a
talking viewer = WebSockets.runClientWith "127.0.0.1" (portOf viewer) (Char8.unpack (withToken viewer "/live")) WebSockets.defaultConnectionOptions [("Origin", "http://" <> host viewer)]

say :: WebSockets.Connection -> [(Json.Key, Value)] -> IO ()
say c = WebSockets.sendTextData c . Json.encode . object

-- | A text typed in that of the first version, which is the file's as it was at the beginning.
edit :: Text -> [(Json.Key, Value)]
edit = editOf 1

editOf :: Int -> Text -> [(Json.Key, Value)]
editOf version text = ["type" .= ("edit" :: Text), "version" .= version, "text" .= text]

-- | The next message of a type; what comes before is passed over.
await :: WebSockets.Connection -> Text -> IO Value
await c kind = do
  message <- WebSockets.receiveDataMessage c
  case message of
    WebSockets.Text bytes _ | Just value <- Json.decode bytes, textAt "type" value == Just kind -> pure value
    _ -> await c kind

-- | The next one that is such.
awaitSuch :: WebSockets.Connection -> Text -> (Value -> Bool) -> IO ()
awaitSuch c kind isIt = await c kind >>= \value -> unless (isIt value) (awaitSuch c kind isIt)

-- | For each row that comes before the picture is done, whether it is one of the picture itself.
rowsUntilDone :: WebSockets.Connection -> IO [(Bool, Int)]
rowsUntilDone c = do
  message <- WebSockets.receiveDataMessage c
  case message of
    WebSockets.Text bytes _ | (Json.decode bytes >>= textAt "type") == Just "done" -> pure []
    WebSockets.Binary bytes -> (rows (Lazy.toStrict bytes) <>) <$> rowsUntilDone c
    WebSockets.Text _ _ -> rowsUntilDone c
  where
    rows bytes = [(word bytes 0 == 1, word (Bytes.drop (16 + i * (word bytes 2 + 4)) bytes) 0) | i <- [0 .. word bytes 3 - 1]]
    word bytes i = sum [fromIntegral (Bytes.index bytes (4 * i + k)) * 256 ^ k | k <- [0 .. 3]] :: Int

valueAt :: Json.Key -> Value -> Maybe Value
valueAt key = parseMaybe (withObject "message" (.: key))

textAt :: Json.Key -> Value -> Maybe Text
textAt key value = case valueAt key value of
  Just (String t) -> Just t
  _ -> Nothing

listAt :: Json.Key -> Value -> [Value]
listAt key value = case valueAt key value of
  Just (Array xs) -> foldr (:) [] xs
  _ -> []

firstOf :: [a] -> Maybe a
firstOf xs = case xs of
  x : _ -> Just x
  [] -> Nothing
