{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Info
-- Description : dioptre info: applications, words and defaults
--
-- A page that cannot go out of date: each object's words, what they expect and their defaults are read from the
-- schemas with which scenes are checked ("Dioptre.Scene.Schema").
module Dioptre.Command.Info
  ( info,
  )
where

import Data.List.NonEmpty (toList)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene.Camera (cameraSchema, viewportSchema)
import Dioptre.Scene.Configuration (Application (..), applicationNames, describeConfiguration)
import Dioptre.Scene.Lights (describeLights)
import Dioptre.Scene.Materials (materialSchema, textureMaterialSchema)
import Dioptre.Scene.Model (modelSchema)
import Dioptre.Scene.Primitive (primitiveSchema)
import Dioptre.Scene.Raytracer (raytracerSchema)
import Dioptre.Scene.Schema (Schema (..), describe)
import Dioptre.Scene.Shapes (describeShapes)
import Dioptre.Source.Diagnostic (Expectation)
import Dioptre.Source.Language (Language, inLanguage)
import Dioptre.Source.Message (expectation)
import Dioptre.Syntax.Keyword (Keyword, spellings)

-- | Everything that can be written in a scene and a configuration, with what is expected and what the defaults are.
info :: Language -> Text
info l =
  Text.unlines $
    [ inLanguage l "Dioptre draws the picture that the rays of a scene see." "Dioptre dessine l'image que voient les rayons d'une scène.",
      "",
      inLanguage l "APPLICATIONS (the word 'application' in configuration.cfg)" "APPLICATIONS (le mot 'application' de configuration.cfg)"
    ]
      <> ["  " <> Text.justifyLeft 12 ' ' name <> describeApplication l application | (name, application) <- applicationNames]
      <> section (inLanguage l "CONFIGURATION" "CONFIGURATION") [("configuration.cfg", describeConfiguration)]
      <> section
        (inLanguage l "SCENE" "SCÈNE")
        [ object cameraSchema,
          object viewportSchema,
          object raytracerSchema,
          object primitiveSchema,
          object materialSchema,
          object textureMaterialSchema,
          object modelSchema
        ]
      <> section (inLanguage l "SHAPES (inside primitive or geometry)" "GÉOMÉTRIES (dans primitive ou geometry)") (map named describeShapes)
      <> section (inLanguage l "LIGHTS" "LUMIÈRES") (map named describeLights)
  where
    object :: Schema a b -> (Text, [([Keyword], Expectation, [Text])])
    object schema = named (schemaKeyword schema, describe schema)
    named (word, properties) = (names [word], properties)
    names = Text.intercalate ", " . concatMap (toList . spellings)
    section title objects = "" : title : concatMap described objects
    described (name, properties) = ("  " <> name) : concatMap property properties
    property (words', wanted, defaults) =
      ["    " <> Text.justifyLeft 40 ' ' (names words') <> " " <> expectation l wanted]
        <> ["    " <> Text.replicate 41 " " <> inLanguage l "default: " "par défaut\xA0: " <> Text.intercalate inBetween given | given@(_ : _) <- [filter (not . Text.null) defaults]]
    inBetween = inLanguage l ", then " ", puis "

-- | What an application does.
describeApplication :: Language -> Application -> Text
describeApplication l application = case application of
  RunNothing -> say "does nothing" "ne fait rien"
  RunInfo -> say "prints this page" "affiche cette page"
  RunConsole -> say "draws the scene that 'read_data' names" "dessine la scène que nomme 'read_data'"
  RunFrame ->
    say
      "shows the scene in the browser while it is drawn, then does as console"
      "montre la scène dans le navigateur pendant qu'elle est dessinée, puis fait comme console"
  RunComparator ->
    say "compares the pictures that the list in 'read_data' names" "compare les images de la liste que nomme 'read_data'"
  where
    say = inLanguage l
