{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Configuration
-- Description : configuration.cfg
--
-- What the program does when it is run without arguments. The file has the scene language's lines, but no objects: each
-- line is a property.
module Dioptre.Scene.Configuration
  ( Configuration (..),
    Application (..),
    applicationNames,
    checkConfiguration,
    startingConfiguration,
    configurationFile,
    defaultSceneFile,
    describeConfiguration,
  )
where

import Data.List (find)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene.Form (Form (..), booleanForm, choice, integerWithin, optionally, outputName, outputNameEnding, text)
import Dioptre.Scene.Reporting (report, runCheck)
import Dioptre.Scene.Schema
import Dioptre.Source.Diagnostic (Diagnostic, Expectation, Instead (Kept), Problem (..), Refusal (NameTaken))
import Dioptre.Source.Language (Language, languageNames)
import Dioptre.Source.Span (Span (..), wholeFile)
import Dioptre.Syntax.Keyword (Keyword)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print (printOutline)
import Dioptre.Syntax.Tree (Block (..), Closing (..), Head (..), Node (..), Property (..), Tree, Value (..))

-- | What a configuration says.
data Configuration = Configuration
  { configurationApplication :: Application,
    -- | The scene, or the list of pictures to compare.
    configurationRead :: Text,
    -- | Where the scene is written back, whole.
    configurationWrite :: Text,
    configurationLogName :: Text,
    -- | Whether messages go to the console.
    configurationLogConsole :: Bool,
    -- | Whether messages go to the log.
    configurationLogFile :: Bool,
    -- | The number that the next picture tries first, from 0 to 999.
    configurationImageCount :: Int,
    -- | The language of messages; 'Nothing' for the locale's.
    configurationLanguage :: Maybe Language
  }
  deriving stock (Eq, Show)

-- | What to run.
data Application
  = RunNothing
  | RunInfo
  | RunConsole
  | RunFrame
  | RunComparator
  deriving stock (Eq, Show, Enum, Bounded)

-- | The applications' names; the position of each is its number.
applicationNames :: [(Text, Application)]
applicationNames = zip ["none", "info", "console", "frame", "comparator"] [minBound ..]

-- | The name of the configuration's file.
--
-- Spec: config.file.
configurationFile :: FilePath
configurationFile = "configuration.cfg"

-- | The name of the scene that is built in; no file of this name is read.
defaultSceneFile :: Text
defaultSceneFile = "default_scene.txt"

-- | The configuration that a tree describes, and all that is wrong with it. What is written never bears the name of
-- what is read, or of the other thing that is written. There are no objects in it: a word that would open one is a line
-- like the others, and so is what would stand in it.
--
-- Spec: code.name-taken, config.file, config.apart.
checkConfiguration :: Tree -> (Configuration, [Diagnostic])
checkConfiguration withObjects = runCheck $ do
  read' <- fromMaybe unsaid <$> readWholeFile schema "configuration" tree
  written <- apart Keyword.WriteData outputName [configurationRead read'] (configurationWrite read') (configurationWrite unsaid)
  logged <- apart Keyword.LogFileName logName [configurationRead read', written] (configurationLogName read') (configurationLogName unsaid)
  pure read' {configurationWrite = written, configurationLogName = logged}
  where
    tree = foldr asLines [] withObjects
    -- In front of what follows: the depth of objects in objects costs nothing.
    asLines node following = case node of
      Object (Block word _ nodes closing) -> asLine word : foldr asLines (ends closing following) nodes
      _ -> node : following
    ends closing following = case closing of
      ByMisspeltEnd word -> asLine word : following
      _ -> following
    asLine word = Statement (Property word (Value (behind (headSpan word)) ""))
    behind (Span line _ end) = Span line end end
    apart word form others name instead
      | not (clashes name) = pure name
      | otherwise = do
        -- There are fewer other names than these, so that one of them is free.
        let free = fromMaybe instead (find (not . clashes) (instead : [prefix <> instead | prefix <- ["dioptre_", "dioptre_2_", "dioptre_3_", "dioptre_4_"]]))
        report place (RefusedValue (Keyword.spelling word) NameTaken (formExpectation form) (Kept free))
        pure free
      where
        place = fromMaybe wholeFile (placeOfValue word (Block (Head wholeFile "" Nothing) (Value wholeFile "") tree (ByEnd wholeFile)))
        clashes t = bare t `elem` map bare (Text.pack configurationFile : others)
    -- The name that a file has on the disk: reading leaves out folders, blanks around the name, and case.
    bare = Text.toCaseFold . Text.strip . Text.takeWhileEnd (`notElem` ['/', '\\']) . Text.strip

-- | A configuration of which nothing is said.
unsaid :: Configuration
unsaid = Configuration RunNothing "read_data_file_name.txt" "write_data_file_name.txt" "log.txt" True True 0 Nothing

-- | The configuration that is written where there is none.
--
-- Spec: config.missing.
startingConfiguration :: Text
startingConfiguration =
  printOutline . writeProperties schema $
    unsaid {configurationApplication = RunInfo, configurationRead = defaultSceneFile, configurationWrite = "out.txt"}

-- | The properties of a configuration: their words, what they expect, their defaults.
describeConfiguration :: [([Keyword], Expectation, [Text])]
describeConfiguration = describe schema

-- Spec: config.properties.
schema :: Schema Configuration Configuration
schema =
  Schema
    Keyword.Application
    unsaid
    [ one Keyword.Application (choice applicationNames) configurationApplication (\v c -> c {configurationApplication = v}),
      one Keyword.ReadData text configurationRead (\v c -> c {configurationRead = v}),
      one Keyword.WriteData outputName configurationWrite (\v c -> c {configurationWrite = v}),
      one Keyword.LogFileName logName configurationLogName (\v c -> c {configurationLogName = v}),
      one Keyword.LogConsole booleanForm configurationLogConsole (\v c -> c {configurationLogConsole = v}),
      one Keyword.LogFile booleanForm configurationLogFile (\v c -> c {configurationLogFile = v}),
      one Keyword.ViewportImageCount (integerWithin 0 999) configurationImageCount (\v c -> c {configurationImageCount = v}),
      one Keyword.Language languageForm configurationLanguage (\v c -> c {configurationLanguage = v})
    ]
    Nothing
    Right
    id
  where
    languageForm = optionally (choice languageNames)

logName :: Form Text
logName = outputNameEnding ".txt"
