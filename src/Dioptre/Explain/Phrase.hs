{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.Phrase
-- Description : Shapes, numbers and colours in words
--
-- The small pieces of which stories are made in words. Numbers are as short as they read back, and -0 is 0: whoever
-- reads a story learns nothing from its sign.
module Dioptre.Explain.Phrase
  ( -- * Shapes
    thingText,
    theThing,

    -- * Numbers
    real,
    vec,
    triple,
    pair,
    rayIn,
    degrees,
    smallestText,

    -- * Colours
    colour,
    pixelText,
  )
where

import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Explain.Story
import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Math.Tolerance (smallestParameter)
import Dioptre.Math.Vector (Vector)
import Dioptre.Picture.Byte (Pixel (..))
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Phrase (number)
import Dioptre.Syntax.Keyword (Keyword)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Value (showReal)
import Linear.V3 (V3 (..))

-- | A shape by its place in the file, from 1, its kind and its material.
thingText :: Language -> Thing -> Text
thingText l thing = case thingWhereabouts thing of
  OfScene i -> say "primitive " "primitive " <> number (i + 1) <> " (" <> kind <> (if thingTransformed thing then say ", transformed," ", transformé" <> agreement <> say "" "," else "") <> foldMap (\m -> " '" <> m <> "'") (thingMaterial thing) <> ")"
  OfModel model k file -> say "shape " "forme " <> number (k + 1) <> say " of " " de " <> fromMaybe (say "model " "modèle " <> number (model + 1)) file <> " (" <> kind <> ")"
  where
    say = inLanguage l
    kind = kindText l (thingKind thing)
    agreement = if thingKind thing `elem` [Keyword.Sphere, Keyword.Lens, Keyword.SphericalCap] then say "" "e" else ""

-- | The same within a sentence.
theThing :: Language -> Thing -> Text
theThing l thing = inLanguage l "" "la " <> thingText l thing

kindText :: Language -> Keyword -> Text
kindText l kind = case kind of
  Keyword.Plane -> say "plane" "plan"
  Keyword.Disk -> say "disk" "disque"
  Keyword.Annulus -> say "annulus" "anneau"
  Keyword.Sphere -> say "sphere" "sphère"
  Keyword.Cube -> "cube"
  Keyword.Triangle -> "triangle"
  Keyword.SmoothTriangle -> "triangle"
  Keyword.Tube -> "tube"
  Keyword.Cylinder -> say "cylinder" "cylindre"
  Keyword.Cone -> say "cone" "cône"
  Keyword.Lens -> say "lens" "lentille"
  Keyword.SphericalCap -> say "spherical cap" "calotte sphérique"
  Keyword.Torus -> say "torus" "tore"
  other -> Keyword.spelling other
  where
    say = inLanguage l

-- | A real number: all of them are written here.
real :: Double -> Text
real x = showReal (if x == 0 then 0 else x)

list :: [Double] -> Text
list xs = "[" <> Text.intercalate ", " (map real xs) <> "]"

-- | A vector, as scenes have it.
vec :: Vector -> Text
vec (V3 x y z) = list [x, y, z]

-- | Three numbers, in the same way.
triple :: (Double, Double, Double) -> Text
triple (x, y, z) = list [x, y, z]

-- | A place in a pixel.
pair :: (Double, Double) -> Text
pair (x, y) = "(" <> real x <> ", " <> real y <> ")"

-- | Red, green and blue.
colour :: Colour -> Text
colour (Colour r g b _) = list [r, g, b]

-- | Four bytes.
pixelText :: Pixel -> Text
pixelText (Pixel r g b a) = "(" <> Text.intercalate ", " (map (Text.pack . show) [r, g, b, a]) <> ")"

-- | An angle in degrees.
degrees :: Double -> Text
degrees a = real (a * 180 / pi) <> "°"

-- | The parameter that a ray must exceed to meet anything.
--
-- >>> smallestText
-- "1e-8"
smallestText :: Text
smallestText = Text.replace ".0e" "e" (showReal smallestParameter)

-- | Origin and direction of a ray, in two lines that begin with this.
rayIn :: Text -> Ray -> [Text]
rayIn indent r = [indent <> "o = " <> vec (origin r), indent <> "d = " <> vec (direction r)]
