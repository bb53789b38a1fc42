{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Scenes
-- Description : The operations of the profiles scene and picture
--
-- What becomes of a scene's text. Nothing is read from a disk: models and pictures that the text names are not there,
-- and are not spoken of, since that is no matter of the text.
module Dioptre.Conformance.Scenes
  ( sceneOperations,
    pictureOperations,
    ofPicture,
  )
where

import Control.Monad (unless)
import Data.Aeson (Object, Value (..), object, toJSON, (.=))
import Data.Aeson.Types (Parser)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Base64 as Base64
import Data.Text (Text)
import qualified Data.Text.Encoding as Text
import qualified Data.Vector.Storable as Storable
import Dioptre.Conformance.Parameter (Operation, field, fieldOr, ofRay, whole)
import Dioptre.Model.Library (noModels)
import Dioptre.Picture (Picture, pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Render (rendered)
import Dioptre.Render.Row (plan, planWithin, window)
import Dioptre.Render.Sampling (offset)
import Dioptre.Render.View (rayThrough, view, viewWidth)
import Dioptre.Scene (Scene, sceneCamera, sceneRaytracer, sceneViewport, writeScene)
import Dioptre.Scene.Camera (viewportHeight, viewportWidth)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Scene.Raytracer (raytracerSampling)
import Dioptre.Source.Diagnostic (Diagnostic (..), code, severity)
import Dioptre.Source.Language (Language (English))
import Dioptre.Source.Message (severityName)
import Dioptre.Source.Span (spanColumn, spanLine)
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)

-- | What is wrong with a scene and what it is when written back; and the ray through a sample of a pixel.
--
-- Spec: protocol.text, protocol.operations.
sceneOperations :: [(Text, Operation)]
sceneOperations =
  [ ("scene.check", check),
    ("camera.ray", \o -> sceneOf o >>= \(scene, _) -> cameraRay scene o)
  ]

-- | One pixel, and the whole picture.
--
-- Spec: protocol.operations.
pictureOperations :: [(Text, Operation)]
pictureOperations =
  [ ("scene.pixel", \o -> sceneOf o >>= \(scene, _) -> pixel scene o),
    ("scene.picture", fmap (ofPicture . rendered . plan mempty noModels . fst) . sceneOf)
  ]

-- | A picture as a result: its size, and its bytes in base 64.
--
-- Spec: picture.rows.
ofPicture :: Picture -> Value
ofPicture p = object ["width" .= pictureWidth p, "height" .= pictureHeight p, "rgba" .= rgba]
  where
    rgba = Text.decodeLatin1 (Base64.encode (Bytes.pack (Storable.toList (pictureBytes p))))

-- | The scene of a text, and what is wrong with the text.
sceneOf :: Object -> Parser (Scene, [Diagnostic])
sceneOf o = checkScene . parse . fromText "" <$> field text o "text"
  where
    text value = case value of
      String t -> pure t
      _ -> fail "this is not a string"

check :: Operation
check o = do
  (scene, diagnostics) <- sceneOf o
  pure (object ["diagnostics" .= map told diagnostics, "canonical" .= writeScene scene])
  where
    told (Diagnostic place problem) =
      object
        [ "code" .= code problem,
          "severity" .= severityName English (severity problem),
          "line" .= spanLine place,
          "column" .= spanColumn place
        ]

-- | The column and row of a pixel of the picture, from 0 at the top left.
--
-- Spec: camera.ray.operation.
pixelOf :: Scene -> Object -> Parser (Int, Int)
pixelOf scene o = do
  column <- field (whole 0) o "column"
  row <- field (whole 0) o "row"
  unless (column < viewportWidth port && row < viewportHeight port) (fail "the pixel is outside the picture")
  pure (column, row)
  where
    port = sceneViewport scene

-- | The ray through a sample of a pixel, counted from 0.
--
-- Spec: camera.ray.operation.
cameraRay :: Scene -> Operation
cameraRay scene o = do
  (column, row) <- pixelOf scene o
  sample <- fieldOr 0 (whole 0) o "sample"
  unless (sample < raytracerSampling (sceneRaytracer scene)) (fail "the pixel has no such sample")
  let v = view (sceneCamera scene) (sceneViewport scene)
      (dx, dy) = offset (sceneRaytracer scene) (viewWidth v) column row sample
  ofRay (rayThrough v (fromIntegral column + dx) (fromIntegral row + dy))

pixel :: Scene -> Operation
pixel scene o = do
  (column, row) <- pixelOf scene o
  part <- maybe (fail "the pixel is outside the picture") pure (window (sceneViewport scene) column row 1 1)
  pure (toJSON (Storable.toList (pictureBytes (rendered (planWithin part mempty noModels scene)))))
