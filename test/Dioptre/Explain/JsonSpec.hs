{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.JsonSpec
-- Description : Stories for programs
module Dioptre.Explain.JsonSpec (spec) where

import Data.Aeson (Value (..), decode, encode, object, toJSON, (.=))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as Keys
import Data.Foldable (toList)
import Data.List (sort)
import Dioptre.Explain.Json
import Dioptre.Explain.Story
import Dioptre.Explain.Tell (tell)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Model.Library (noModels)
import Dioptre.Picture.Byte (Pixel (..))
import Laws.Shade (sceneOf)
import Laws.Story
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (discard, (.&&.), (===))

spec :: Spec
spec = do
  it "has the fields that are documented" $ do
    fields [] `shouldBe` ["algorithm", "colour", "column", "far", "height", "level", "normalized", "pixel", "row", "samples", "sampling", "scene", "width"]
    fields ["samples", "ray"] `shouldBe` ["cause", "contribution", "depth", "direction", "encounters", "hit", "index", "notMet", "origin", "own", "untold", "weight"]
    fields ["samples", "ray", "hit"] `shouldBe` ["bounces", "lights", "normal", "outward", "point", "shape", "surface", "t", "uv"]
  -- The ray starts at (1, 0, 0) and goes along x; the sphere of radius 1 stands around (4, 0, 0).
  it "tells an encounter as it is documented" $
    at ["samples", "ray", "encounters"] sphere
      `shouldBe` Just
        ( object
            [ "shape" .= object ["number" .= (0 :: Int), "kind" .= ("sphere" :: String), "transformed" .= False, "primitive" .= (0 :: Int), "material" .= ("m" :: String)],
              "verdict" .= ("closest" :: String),
              "t" .= (2 :: Double),
              "conditions"
                .= [ object
                       [ "of" .= ("sphere" :: String),
                         "degree" .= (2 :: Int),
                         "coefficients" .= [coefficient "A" "<d, d>" 1, coefficient "B" "2 <w, d>" (-6), coefficient "C" "<w, w> - R^2" 8],
                         "letters" .= ["w = o - C" :: String, "C = [4.0, 0.0, 0.0]", "R = 1.0"],
                         "discriminant" .= (4 :: Double)
                       ]
                   ],
              "roots" .= [object ["t" .= (2 :: Double), "condition" .= (0 :: Int), "fate" .= ("kept" :: String)], object ["t" .= (4 :: Double), "condition" .= (0 :: Int), "fate" .= ("later" :: String)]]
            ]
        )
  prop "colours and bytes read back as they are" $ \(Pictured scene assets x y) -> case tell assets [] noModels scene x y of
    Nothing -> discard
    Just story ->
      let Colour r g b _ = storyColour story
          Pixel r' g' b' a' = storyPixel story
          back = decode (encode (storyJson "s" story))
       in (back >>= at ["colour"]) === Just (toJSON [r, g, b])
            .&&. (back >>= at ["pixel"]) === Just (toJSON [r', g', b', a'])
            .&&. fmap (length . elements') (back >>= field "samples") === Just (length (storySamples story))
            .&&. fmap countRays back === Just (sum (map sampleFollowed (storySamples story)))
  where
    sphere = maybe Null (storyJson "s") (tell mempty [] noModels ball 0 0)
    ball =
      sceneOf $
        ["camera", "position 0 0 0", "look_at 1 0 0", "up 0 0 1", "near_clipping_plane 1", "end", "viewport", "width 1", "height 1", "end", "raytracer", "pixel_coordinate center", "end"]
          <> ["primitive", "material_name m", "sphere", "position 4 0 0", "end", "end", "material", "name m", "end", "ambient_light", "end"]
    fields path = case at path sphere of
      Just (Object o) -> sort (map Key.toString (Keys.keys o))
      _ -> []
    coefficient name formula x = object ["name" .= (name :: String), "formula" .= (formula :: String), "value" .= (x :: Double)]
    field k v = case v of
      Object o -> Keys.lookup k o
      _ -> Nothing
    -- Down fields; of an array of objects the first.
    at path v = case path of
      [] -> case v of
        Array a | (Object o : _) <- toList a -> Just (Object o)
        _ -> Just v
      k : rest -> case v of
        Array a | first : _ <- toList a -> at path first
        _ -> field k v >>= at rest
    elements' v = case v of
      Array a -> toList a
      _ -> []
    -- Every object with a cause is a ray.
    countRays :: Value -> Int
    countRays v = case v of
      Object o -> (if Keys.member "cause" o then 1 else 0) + sum (map countRays (toList o))
      Array a -> sum (map countRays (toList a))
      _ -> 0
