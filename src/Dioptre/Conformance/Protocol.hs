{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Protocol
-- Description : What a port and the suite say to each other
--
-- A port is a program that reads one JSON object a line and answers one a line:
--
-- > {"id":7,"op":"roots.quadratic","in":{"a":1,"b":-3,"c":2}}     a request
-- > {"id":7,"ok":[1,2]}                                           its result
-- > {"id":7,"skip":"not implemented"}                             the port does not have this operation
-- > {"id":7,"error":"'ray' is out of range"}                      the request has no result
-- > {"error":"the line is not JSON"}                              nothing could be made of the line
--
-- Answers carry the identifier of their request, and may come in any order. The first request is @start@, without @in@;
-- what the port answers says who it is. A number stands for a binary64; NaN and the infinities cannot be sent, since
-- JSON has no such numbers.
module Dioptre.Conformance.Protocol
  ( -- * Requests
    Request (..),
    readRequest,
    writeRequest,

    -- * Answers
    Answer (..),
    Outcome (..),
    readAnswer,
    writeAnswer,

    -- * Numbers
    binary64,
    writeValue,
  )
where

import Data.Aeson (Object, Result (..), Value (..), eitherDecodeStrict, fromJSON)
import Data.Aeson.Encoding (Encoding, Series, encodingToLazyByteString, pair)
import qualified Data.Aeson.Encoding as Encoding
import qualified Data.Aeson.KeyMap as Keys
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.List (sortOn)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import Data.Text.Encoding (encodeUtf8Builder)
import Dioptre.Syntax.Value (showReal)

-- | An operation with its arguments.
data Request = Request
  { -- | A number that no other request of the run has, from 0 to 2^53 - 1.
    requestId :: Int,
    -- | The operation's name.
    requestOperation :: Text,
    -- | What stands under @in@; an empty object where nothing does.
    requestInput :: Value
  }
  deriving stock (Eq, Show)

-- | What is answered, and to which request.
data Answer = Answer
  { -- | The request's; none where it could not be read.
    answerId :: Maybe Int,
    -- | What became of the request.
    answerOutcome :: Outcome
  }
  deriving stock (Eq, Show)

-- | What becomes of a request.
data Outcome
  = -- | The result.
    Ok Value
  | -- | The operation is not there, in the words of the port.
    Skip Text
  | -- | There is no result, and why.
    Fault Text
  deriving stock (Eq, Show)

-- | The request on a line, or the answer to a line that holds none.
--
-- Spec: protocol.request, protocol.malformed.
readRequest :: ByteString -> Either Answer Request
readRequest line = case eitherDecodeStrict line of
  Right (Object o) -> request o
  Right _ -> Left (Answer Nothing (Fault "the line is not a JSON object"))
  Left _ -> Left (Answer Nothing (Fault "the line is not JSON"))

request :: Object -> Either Answer Request
request o = case (Keys.lookup "id" o >>= identifier, Keys.lookup "op" o) of
  (Nothing, _) -> complaint "there is no 'id' that is a whole number from 0 to 2^53 - 1"
  (Just name, Just (String operation)) -> Right (Request name operation (fromMaybe (Object mempty) (Keys.lookup "in" o)))
  (Just _, _) -> complaint "there is no 'op' that is a string"
  where
    complaint = Left . Answer Nothing . Fault

-- | The identifier that a value is, if it is one.
identifier :: Value -> Maybe Int
identifier value = case binary64 value of
  Just x | x >= 0 && x < 9007199254740992, let n = truncate x, fromIntegral n == x -> Just n
  _ -> Nothing

-- | A request as a line, without its line feed. Law: 'readRequest' reads it back.
writeRequest :: Request -> Lazy.ByteString
writeRequest (Request name operation input) = written (identified (Just name) <> pair "op" (Encoding.text operation) <> given)
  where
    given = if input == Object mempty then mempty else pair "in" (writeValue input)

-- | The answer on a line, or what is wrong with the line. Of @ok@, @skip@ and @error@ the first that is there counts.
--
-- Spec: protocol.answer.
readAnswer :: ByteString -> Either Text Answer
readAnswer line = case eitherDecodeStrict line of
  Right (Object o)
    | Just value <- Keys.lookup "ok" o -> Right (Answer (name o) (Ok value))
    | Just why <- Keys.lookup "skip" o -> Right (Answer (name o) (Skip (inWords why)))
    | Just why <- Keys.lookup "error" o -> Right (Answer (name o) (Fault (inWords why)))
    | otherwise -> Left "an answer without 'ok', 'skip' or 'error'"
  Right _ -> Left "a line that is not a JSON object"
  Left _ -> Left "a line that is not JSON"
  where
    name o = Keys.lookup "id" o >>= identifier
    inWords value = case value of
      String t -> t
      _ -> ""

-- | An answer as a line, without its line feed. Law: 'readAnswer' reads it back.
--
-- Spec: protocol.answer.
writeAnswer :: Answer -> Lazy.ByteString
writeAnswer (Answer name outcome) = written . (identified name <>) $ case outcome of
  Ok value -> pair "ok" (writeValue value)
  Skip why -> pair "skip" (Encoding.text why)
  Fault why -> pair "error" (Encoding.text why)

identified :: Maybe Int -> Series
identified = foldMap (pair "id" . Encoding.int)

written :: Series -> Lazy.ByteString
written = encodingToLazyByteString . Encoding.pairs

-- | The number as a binary64, to the nearest, ties to even; infinite beyond the largest one. 'Nothing' for what is no
-- number.
--
-- Spec: protocol.numbers.
binary64 :: Value -> Maybe Double
binary64 value = case value of
  Number _ | Success x <- fromJSON value -> Just x
  _ -> Nothing

-- | JSON with the members of objects in alphabetical order, and numbers with the shortest digits that read back to the
-- same binary64: without a point where they are whole and less than 2^53.
--
-- Spec: protocol.numbers.
writeValue :: Value -> Encoding
writeValue value = case value of
  Number _ -> maybe Encoding.null_ number (binary64 value)
  Array items -> Encoding.list writeValue (toList items)
  Object o -> Encoding.pairs (mconcat [pair name (writeValue inner) | (name, inner) <- sortOn fst (Keys.toList o)])
  _ -> Encoding.value value
  where
    number x
      | abs x < 9007199254740992 && x == fromIntegral whole = Encoding.integer whole
      | isInfinite x = Encoding.null_
      | otherwise = Encoding.unsafeToEncoding (encodeUtf8Builder (showReal x))
      where
        whole = truncate x :: Integer
