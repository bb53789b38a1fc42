{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.View.Guard
-- Description : Who may speak with the viewer
--
-- The server listens on 127.0.0.1 only, so that nobody else on the network can reach it. What can is any page that the user's own browser has open, and such a page must neither read the scene nor write its file:
--
-- * A page of another place carries its own address in @Origin@. It is refused a conversation.
-- * A page whose server has renamed itself to 127.0.0.1 (DNS rebinding) still asks for its own name in @Host@. It is refused everything.
--
-- Sources: RFC 6455, section 10.2 (Origin); RFC 9110, section 7.2 (Host).
module Dioptre.View.Guard
  ( Request (..),
    Verdict (..),
    verdict,
    address,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString.Char8 as Bytes
import Data.Char (toLower)

-- | What of a request matters here.
data Request = Request
  { -- | The header @Host@, if there is one.
    requestHost :: Maybe ByteString,
    -- | The header @Origin@, if there is one.
    requestOrigin :: Maybe ByteString,
    -- | Whether it asks for a conversation (a WebSocket), or else for a file.
    requestConverses :: Bool
  }
  deriving stock (Eq, Show)

-- | What becomes of a request.
data Verdict = Admitted | WrongHost | WrongOrigin
  deriving stock (Eq, Show)

-- | What becomes of a request to the server at a port. A file is given to any origin, as the answer says that no other page may use it.
--
-- >>> :set -XOverloadedStrings
-- >>> verdict 8000 (Request (Just "127.0.0.1:8000") (Just "http://elsewhere.example") True)
-- WrongOrigin
verdict :: Int -> Request -> Verdict
verdict port request
  | not (maybe False (`elem` names) (lower <$> requestHost request)) = WrongHost
  | requestConverses request && not (maybe False (`elem` map ("http://" <>) names) (lower <$> requestOrigin request)) = WrongOrigin
  | otherwise = Admitted
  where
    names = [host <> shownPort | host <- ["127.0.0.1", "localhost"], shownPort <- (":" <> Bytes.pack (show port)) : ["" | port == 80]]
    lower = Bytes.map toLower

-- | The address of the server at a port.
--
-- >>> address 8000
-- "http://127.0.0.1:8000/"
address :: Int -> String
address port = "http://127.0.0.1:" <> show port <> "/"
