{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Oracle
-- Description : This program as a port of itself
--
-- The table of all operations, and the answer to any line: what this program says where the suite asks. The suite's
-- expected values do not come from here; that this program agrees with them is one of its tests.
module Dioptre.Conformance.Oracle
  ( answer,
    perform,
    profiles,
  )
where

import Data.Aeson (Value (..), object, withObject, (.=))
import Data.Aeson.Types (parseEither)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Dioptre.Conformance.Geometry as Geometry
import qualified Dioptre.Conformance.Lighting as Lighting
import qualified Dioptre.Conformance.Maths as Maths
import qualified Dioptre.Conformance.Optics as Optics
import Dioptre.Conformance.Parameter (Operation)
import Dioptre.Conformance.Protocol (Answer (..), Outcome (..), Request (..), readRequest)
import Dioptre.Conformance.Scenes (pictureOperations, sceneOperations)

-- | The answer to a line. The first argument is this program's version.
--
-- Law: whatever the line, there is an answer; it carries the request's identifier if the line has one.
--
-- Spec: rule.version, protocol.start, protocol.unknown, protocol.malformed.
answer :: Text -> ByteString -> Answer
answer version line = case readRequest line of
  Left complaint -> complaint
  Right (Request name "start" _) -> Answer (Just name) (Ok (introduction version))
  Right (Request name operation input) -> Answer (Just name) (maybe (Skip "not implemented") (either Fault Ok) (perform operation input))

-- | What an operation makes of its arguments; 'Nothing' for an operation that there is none of.
--
-- Spec: conformance.total, protocol.refused.
perform :: Text -> Value -> Maybe (Either Text Value)
perform operation input = (\o -> first Text.pack (parseEither (withObject "in" o) input)) <$> Map.lookup operation table
  where
    table :: Map Text Operation
    table = Map.fromList (concatMap snd profiles)

-- | The profiles, in the order in which a port comes to them, with their operations.
--
-- Spec: conformance.profiles.
profiles :: [(Text, [(Text, Operation)])]
profiles =
  [ ("maths", Maths.operations),
    ("geometry", Geometry.operations),
    ("optics", Optics.operations),
    ("lighting", Lighting.operations),
    ("scene", sceneOperations),
    ("picture", pictureOperations)
  ]

introduction :: Text -> Value
introduction version =
  object
    [ "implementation" .= ("dioptre" :: Text),
      "language" .= ("Haskell" :: Text),
      "version" .= version,
      "profiles" .= map fst profiles
    ]
