{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.View.Message
-- Description : What the viewer and its page say to each other
--
-- Messages are JSON objects with a @type@; rows of pictures are messages of bytes. The page's side is
-- page/connection.js.
--
-- Bytes, all numbers being 32 bits, the lowest byte first:
--
-- > kind (0 coarse, 1 fine) | render | bytes per row | count | count times: row, its bytes
module Dioptre.View.Message
  ( -- * To the page
    Message (..),
    messageJson,
    rowsHeader,
    rowHeader,

    -- * From the page
    Ask (..),
    ask,
    longestText,
  )
where

import Data.Aeson (Value (..), eitherDecodeStrict', object, withObject, (.:), (.:?), (.=))
import Data.Aeson.Types (Parser, parseEither)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Builder as Builder
import Data.Foldable (toList)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Load (Loaded (..))
import Dioptre.Render.Row (planHeight, planWidth)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Render.View (projection, view)
import Dioptre.Scene (sceneCamera, sceneViewport)
import Dioptre.Scene.Camera (viewportImage)
import Dioptre.Source.Diagnostic (Diagnostic (..), severity)
import Dioptre.Source.Language (Language (..), languageNames)
import Dioptre.Source.Message (severityName)
import Dioptre.Source.Report (toJson)
import Dioptre.Source.Text (sourceName)
import Dioptre.View.Desk (By (..), Checked (..), hasErrors)
import Dioptre.View.Frame (Frame (..), Progress (..), coarseness)
import Dioptre.View.Painter (mostPixels)
import Dioptre.View.Wording (Refusal, complaintText, refusal)

-- | What the page is told.
data Message
  = -- | The first thing: the page's number, the language, the scene's name, and whether it has a file to be saved to.
    Hello Int Language Text Bool
  | -- | The text at hand: version, whose it is, whether the file has it, whether the file has another one that is not that of before.
    SceneIs Int By Bool Bool Text
  | -- | What is wrong with a version.
    Found Language Checked
  | -- | A picture begins.
    Start Frame
  | -- | How far it is.
    Painting Frame Progress
  | -- | It is finished.
    Done Frame Progress
  | -- | It will not be.
    Abandoned Int
  | -- | Messages are in this language from here on.
    Speaks Language
  | -- | The story of a pixel: the number of the question and of the picture; as data and as a text.
    Story Int Int Value Text
  | -- | What was asked, with the number of the question if it has one, and is not done.
    Refused Language (Maybe Int) Refusal

-- | The object for a message.
messageJson :: Message -> Value
messageJson m = object $ case m of
  Hello page l file canSave ->
    ["type" .= ("hello" :: Text), "program" .= ("Dioptre" :: Text), "page" .= page, "language" .= languageCode l, "file" .= file, "canSave" .= canSave, "limits" .= object ["text" .= longestText, "pixels" .= mostPixels]]
  SceneIs version by saved conflict text ->
    ["type" .= ("scene" :: Text), "version" .= version, "text" .= text, "saved" .= saved, "conflict" .= conflict]
      <> case by of
        Disk -> ["by" .= ("disk" :: Text)]
        Page n -> ["by" .= ("page" :: Text), "page" .= n]
  Found l found ->
    [ "type" .= ("diagnostics" :: Text),
      "version" .= checkedVersion found,
      "faults" .= hasErrors (checkedDiagnostics found),
      "drawn" .= checkedDrawn found,
      "diagnostics" .= concat (zipWith (\i (source, ds) -> map (diagnostic l (i == (0 :: Int)) (sourceName source)) ds) [0 ..] (checkedDiagnostics found))
    ]
      <> ["complaint" .= complaintText l c | Just c <- [checkedComplaint found]]
  Start frame ->
    [ "type" .= ("start" :: Text),
      "render" .= frameNumber frame,
      "version" .= frameVersion frame,
      "width" .= planWidth (framePlan frame),
      "height" .= planHeight (framePlan frame),
      "coarse" .= coarseness,
      "projection" .= map toList (toList (projection (view (sceneCamera (scene frame)) (sceneViewport (scene frame)))))
    ]
  Painting frame p ->
    ["type" .= ("progress" :: Text), "render" .= frameNumber frame, "rows" .= progressRows p, "height" .= planHeight (framePlan frame)] <> cost p
  Done frame p ->
    [ "type" .= ("done" :: Text),
      "render" .= frameNumber frame,
      "cut" .= tallyCut (progressTally p),
      "picture" .= ("/picture.png?render=" <> Text.pack (show (frameNumber frame))),
      "name" .= (viewportImage (sceneViewport (scene frame)) <> ".png")
    ]
      <> cost p
  Abandoned render -> ["type" .= ("cancelled" :: Text), "render" .= render]
  Speaks l -> ["type" .= ("language" :: Text), "language" .= languageCode l]
  Story number render story text -> ["type" .= ("story" :: Text), "id" .= number, "render" .= render, "story" .= story, "text" .= text]
  Refused l number why -> ["type" .= ("refused" :: Text), "message" .= refusal l why] <> ["id" .= n | Just n <- [number]]
  where
    scene = loadedScene . frameLoaded
    cost p = ["seconds" .= progressSeconds p, "rays" .= tallyRays (progressTally p), "tests" .= tallyTests (progressTally p)]

-- | As @check --format json@ tells it, with the severity in words, and whether it is about the scene's own text.
diagnostic :: Language -> Bool -> FilePath -> Diagnostic -> Value
diagnostic l own file d = case (toJson l file d, object ["own" .= own, "severityName" .= severityName l (severity (diagnosticProblem d))]) of
  (Object known, Object more) -> Object (known <> more)
  (other, _) -> other

languageCode :: Language -> Text
languageCode English = "en"
languageCode French = "fr"

-- | The beginning of a message of rows: kind, render, how many bytes a row has, and how many rows follow.
rowsHeader :: Bool -> Int -> Int -> Int -> Builder.Builder
rowsHeader fine render size count = foldMap (Builder.word32LE . fromIntegral) [if fine then 1 else 0, render, size, count]

-- | The number of a row, before its bytes.
rowHeader :: Int -> Builder.Builder
rowHeader = Builder.word32LE . fromIntegral

-- | What a page asks for.
data Ask
  = -- | This is the text now, typed in that of a version.
    Edit Int Text
  | -- | The story of the pixel at a column and row, for the question of that number.
    Explain Int Int Int
  | -- | Another language.
    Speak Language
  | -- | Write the text to the scene's file; also where that has been changed by somebody else.
    Save Bool
  | -- | Take the file's text.
    Reload
  | -- | Draw what is there, whatever is wrong with it.
    Draw

-- | The most bytes that a page's text may have.
longestText :: Int
longestText = 1024 * 1024

-- | What a message of a page asks for, or why it is not understood.
ask :: ByteString -> Either String Ask
ask bytes = eitherDecodeStrict' bytes >>= parseEither (withObject "message" parser)
  where
    parser o = do
      kind <- o .: "type"
      case kind :: Text of
        "edit" -> Edit <$> o .: "version" <*> o .: "text"
        "explain" -> Explain <$> o .: "id" <*> o .: "column" <*> o .: "row"
        "language" -> o .: "language" >>= named
        "save" -> Save . fromMaybe False <$> o .:? "overwrite"
        "reload" -> pure Reload
        "draw" -> pure Draw
        _ -> fail "unknown type"
    named :: Text -> Parser Ask
    named name = maybe (fail "unknown language") (pure . Speak) (lookup name languageNames)
