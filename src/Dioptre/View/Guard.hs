{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.View.Guard
-- Description : Who may speak with the viewer
--
-- The server listens on 127.0.0.1 only, so that nobody else on the network can reach it. What can is any program on
-- this machine, whoever runs it, and any page that the user's own browser has open. None of them may read the scene or
-- write its file:
--
-- * Each run has a token, a secret that stands in the address that is printed. Whoever does not name it is refused
--   everything but the files of the page, which are the same for everybody.
-- * A page of another place carries its own address in @Origin@. It is refused a conversation.
-- * A page whose server has renamed itself to 127.0.0.1 (DNS rebinding) still asks for its own name in @Host@. It is
--   refused everything.
--
-- In the address the token stands behind a @#@: what stands there a browser keeps to itself. The page takes it from
-- there (page/token.js), and names it in each request.
--
-- Sources: RFC 6455, section 10.2 (Origin); RFC 9110, section 7.2 (Host); RFC 3986, section 3.5 (what stands behind
-- @#@).
module Dioptre.View.Guard
  ( -- * Tokens
    Token,
    newToken,
    tokenBytes,

    -- * Who may speak
    Request (..),
    Wish (..),
    Verdict (..),
    verdict,
    address,
  )
where

import Data.Bits (xor, (.|.))
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (toLower)
import System.Entropy (getEntropy)

-- | A secret of one run.
newtype Token = Token ByteString

-- | A token that nobody guesses: 128 bits from the operating system's source of secrets, in 32 hexadecimal digits.
newToken :: IO Token
newToken = Token . Lazy.toStrict . Builder.toLazyByteString . Builder.byteStringHex <$> getEntropy 16

-- | How it is written.
tokenBytes :: Token -> ByteString
tokenBytes (Token bytes) = bytes

-- | Whether this is how it is written. How long that takes tells nothing about where they differ.
isToken :: Token -> ByteString -> Bool
isToken (Token own) named = Bytes.length own == Bytes.length named && Bytes.foldl' (.|.) 0 (Bytes.pack (Bytes.zipWith xor own named)) == 0

-- | What of a request matters here.
data Request = Request
  { -- | The header @Host@, if there is one.
    requestHost :: Maybe ByteString,
    -- | The header @Origin@, if there is one.
    requestOrigin :: Maybe ByteString,
    -- | The token that it names, if it names one.
    requestToken :: Maybe ByteString,
    -- | What it asks for.
    requestWish :: Wish
  }
  deriving stock (Eq, Show)

-- | What somebody may ask for.
data Wish
  = -- | A file of the page itself.
    PageFile
  | -- | Anything else that is read, as the picture.
    Data
  | -- | A conversation (a WebSocket).
    Conversation
  deriving stock (Eq, Show)

-- | What becomes of a request.
data Verdict = Admitted | WrongHost | WrongOrigin | WrongToken
  deriving stock (Eq, Show)

-- | What becomes of a request to the server at a port, whose token is this one. What is read is given to any origin, as
-- the answer says that no other page may use it.
--
-- >>> :set -XOverloadedStrings
-- >>> token <- newToken
-- >>> verdict token 8000 (Request (Just "127.0.0.1:8000") (Just "http://elsewhere.example") (Just (tokenBytes token)) Conversation)
-- WrongOrigin
-- >>> verdict token 8000 (Request (Just "127.0.0.1:8000") (Just "http://127.0.0.1:8000") Nothing Conversation)
-- WrongToken
verdict :: Token -> Int -> Request -> Verdict
verdict token port request
  | not (maybe False (`elem` names) (lower <$> requestHost request)) = WrongHost
  | requestWish request == Conversation && not (maybe False (`elem` map ("http://" <>) names) (lower <$> requestOrigin request)) = WrongOrigin
  | requestWish request /= PageFile && not (maybe False (isToken token) (requestToken request)) = WrongToken
  | otherwise = Admitted
  where
    names = [host <> shownPort | host <- ["127.0.0.1", "localhost"], shownPort <- (":" <> Char8.pack (show port)) : ["" | port == 80]]
    lower = Char8.map toLower

-- | The address of the page of the server at a port, with its token.
--
-- > http://127.0.0.1:8000/#token=5f2b...
address :: Token -> Int -> String
address token port = "http://127.0.0.1:" <> show port <> "/#token=" <> Char8.unpack (tokenBytes token)
