{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Default
-- Description : The scene that is built in
--
-- The scene that a new configuration names, so that there is something to draw before anyone has written a file; and a
-- first example of the language. It is read like any other. Specification: rule @config.built-in@.
module Dioptre.Scene.Default
  ( defaultScene,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text

-- | A sphere above a plane, in the scene language: what a configuration that names @default_scene.txt@ draws.
--
-- Spec: config.built-in.
defaultScene :: Text
defaultScene =
  Text.unlines
    [ "# The scene that is built in: a sphere above a plane, both of the grey",
      "# material that stands in for one that is not there.",
      "",
      "camera",
      "  position            [-2.0, 0.0, 2.0]",
      "  look_at             [0.0, 0.0, 0.0]",
      "  up                  [0.0, 0.0, 1.0]",
      "  angle               60.0 degrees",
      "  near_clipping_plane 1.0",
      "  far_clipping_plane  100.0",
      "end",
      "",
      "primitive",
      "  material_name none",
      "  plane",
      "    position [0.0, 0.0, 0.0]",
      "    normal   [0.0, 0.0, 1.0]",
      "  end",
      "end",
      "",
      "primitive",
      "  material_name none",
      "  sphere",
      "    position [0.0, 0.0, 1.0]",
      "    ray      0.5",
      "  end",
      "end",
      "",
      "material",
      "  name none",
      "  ka   0.2",
      "  kd   0.6",
      "  ks   0.7",
      "end",
      "",
      "directional_light",
      "  orientation [0.0, 0.0, -1.0]",
      "end"
    ]
