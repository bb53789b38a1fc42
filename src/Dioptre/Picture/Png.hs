{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Picture.Png
-- Description : Pictures as files
--
-- The only module that knows JuicyPixels.
module Dioptre.Picture.Png
  ( encode,
    decode,
  )
where

import Codec.Picture (Image (..), PixelRGBA8, convertRGBA8, decodeImage, encodePng)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Picture (Picture, picture, pictureBytes, pictureHeight, pictureWidth)

-- | A picture as a PNG file: 8 bits a channel, with alpha.
--
-- Law: decoding it gives the picture.
encode :: Picture -> Lazy.ByteString
encode p = encodePng (Image (pictureWidth p) (pictureHeight p) (pictureBytes p) :: Image PixelRGBA8)

-- | The picture in a file of any format that JuicyPixels knows, or its complaint.
decode :: ByteString -> Either Text Picture
decode bytes = case decodeImage bytes of
  Left complaint -> Left (Text.pack complaint)
  Right dynamic ->
    let Image w h pixels = convertRGBA8 dynamic
     in if w < 1 || h < 1 then Left (Text.pack "no pixels") else Right (picture w pixels)
