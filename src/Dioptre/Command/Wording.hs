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
import Dioptre.Source.Phrase (counted, number)
import Numeric (showFFloat)

-- | A duration, to the millisecond.
seconds :: Double -> Text
seconds s = Text.pack (showFFloat (Just 3) s " s")

-- | How many rays were cast, how many times one was tested against a shape, and how often that is for each.
--
-- Spec: run.log.
statistics :: Language -> Int -> Int -> Text
statistics l rays tests =
  Text.concat
    [ counted l rays ("ray", "rays") ("rayon", "rayons"),
      ", ",
      counted l tests ("intersection test", "intersection tests") ("test d'intersection", "tests d'intersection"),
      " (",
      Text.pack (showFFloat (Just 2) (fromIntegral tests / fromIntegral (max 1 rays) :: Double) ""),
      inLanguage l " a ray)" " par rayon)"
    ]

-- | How large a world is, and its index.
extent :: Language -> Extent -> Text
extent l e =
  Text.concat
    [ counted l (extentShapes e) ("shape", "shapes") ("forme", "formes"),
      inLanguage l "; " "\xA0; ",
      counted l (extentTriangles e) ("triangle", "triangles") ("triangle", "triangles"),
      inLanguage l " of models in memory; index of " " de modèles en mémoire\xA0; index de ",
      counted l (extentBoxes e) ("box", "boxes") ("boîte", "boîtes"),
      inLanguage l ", " ", profond de ",
      number (extentDepth e),
      inLanguage l " deep" ""
    ]

-- | A model's file that was read, and how much is in it.
modelRead :: Language -> ModelRead -> Text
modelRead l (ModelRead path amount) =
  inLanguage l "model '" "modèle '" <> Text.pack path <> inLanguage l "' read: " "' lu\xA0: " <> case amount of
    Polygons counts ->
      Text.intercalate
        ", "
        [ counted l (countTriangles counts) ("triangle", "triangles") ("triangle", "triangles"),
          counted l (countQuads counts) ("quad", "quads") ("quadrilatère", "quadrilatères"),
          counted l (countPolygons counts) ("other polygon", "other polygons") ("autre polygone", "autres polygones")
        ]
    Primitives n -> counted l n ("primitive", "primitives") ("primitive", "primitives")
    Tubes n -> counted l n ("tube", "tubes") ("tube", "tubes")
