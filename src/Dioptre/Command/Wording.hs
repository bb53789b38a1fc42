{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Wording
-- Description : What the commands say, in English and French
--
-- The sentences with numbers in them that more than one command says, or that say much: durations, counts of rays
-- and tests, the size of a world, of a model. The others stand where they are said.
module Dioptre.Command.Wording
  ( seconds,
    statistics,
    extent,
    modelRead,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Load.Amount (Amount (..), ModelRead (..))
import Dioptre.Model.Obj (Counts (..))
import Dioptre.Render.World (Extent (..))
import Dioptre.Source.Language (Language, inLanguage)
import Numeric (showFFloat)

-- | A duration, to the millisecond.
seconds :: Double -> Text
seconds s = Text.pack (showFFloat (Just 3) s " s")

-- | How many rays were cast, how many times one was tested against a shape, and how often that is for each.
statistics :: Language -> Int -> Int -> Text
statistics l rays tests =
  Text.concat
    [ Text.pack (show rays),
      inLanguage l " rays, " " rayons, ",
      Text.pack (show tests),
      inLanguage l " intersection tests (" " tests d'intersection (",
      Text.pack (showFFloat (Just 2) (fromIntegral tests / fromIntegral (max 1 rays) :: Double) ""),
      inLanguage l " a ray)" " par rayon)"
    ]

-- | How large a world is, and its index.
extent :: Language -> Extent -> Text
extent l e =
  Text.concat
    [ number (extentShapes e),
      inLanguage l " shapes; " " formes\xA0; ",
      number (extentTriangles e),
      inLanguage l " triangles of models in memory; index of " " triangles de modèles en mémoire\xA0; index de ",
      number (extentBoxes e),
      inLanguage l " boxes, " " boîtes, profond de ",
      number (extentDepth e),
      inLanguage l " deep" ""
    ]
  where
    number = Text.pack . show

-- | A model's file that was read, and how much is in it.
modelRead :: Language -> ModelRead -> Text
modelRead l (ModelRead path amount) =
  inLanguage l "model '" "modèle '" <> Text.pack path <> inLanguage l "' read: " "' lu\xA0: " <> case amount of
    Polygons counts ->
      Text.intercalate
        ", "
        [ number (countTriangles counts) ("triangle", "triangles") ("triangle", "triangles"),
          number (countQuads counts) ("quad", "quads") ("quadrilatère", "quadrilatères"),
          number (countPolygons counts) ("other polygon", "other polygons") ("autre polygone", "autres polygones")
        ]
    Primitives n -> number n ("primitive", "primitives") ("primitive", "primitives")
    Tubes n -> number n ("tube", "tubes") ("tube", "tubes")
  where
    number :: Int -> (Text, Text) -> (Text, Text) -> Text
    number n en fr = Text.pack (show n) <> " " <> inLanguage l (if n == 1 then fst en else snd en) (if n < 2 then fst fr else snd fr)
