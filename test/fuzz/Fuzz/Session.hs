{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Fuzz.Session
-- Description : Many inputs, one after the other
--
-- The input of a number under a seed is always the same, whatever was tried before: what fails can be asked for again.
module Fuzz.Session
  ( -- * Trying
    Try (..),
    inputOf,
    tryInput,
    tryMany,

    -- * Findings
    Finding (..),
    keepFinding,
  )
where

import Data.Bits (shiftR, xor)
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Word (Word64)
import Fuzz.Corpus (Corpus, casesFolder)
import Fuzz.Generate (generate)
import Fuzz.Kind (Kind, extension, kindName)
import Fuzz.Shrink (shrunk)
import Fuzz.Target (Failure (..), failureName, trial)
import System.Directory (createDirectoryIfMissing)
import System.FilePath ((</>))
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | An input by its name.
data Try = Try
  { trySeed :: Int,
    tryKind :: Kind,
    -- | Counted from 0.
    tryNumber :: Int
  }
  deriving stock (Eq, Show)

-- | The input of that name.
inputOf :: Corpus -> Try -> ByteString
inputOf corpus (Try seed kind number) = unGen (generate corpus kind) (mkQCGen (mixed seed (100 * number + fromEnum kind))) 30

-- | Two numbers as one, so that near ones are far apart (SplitMix64's finaliser).
mixed :: Int -> Int -> Int
mixed a b = fromIntegral (z3 `xor` (z3 `shiftR` 31))
  where
    z1 = 0x9E3779B97F4A7C15 * (fromIntegral a + 1) + fromIntegral b :: Word64
    z2 = (z1 `xor` (z1 `shiftR` 30)) * 0xBF58476D1CE4E5B9
    z3 = (z2 `xor` (z2 `shiftR` 27)) * 0x94D049BB133111EB

-- | What is wrong with an input.
data Finding = Finding Try Failure ByteString
  deriving stock (Show)

-- | Tries the input of that name.
tryInput :: Corpus -> Try -> IO (Maybe Finding)
tryInput corpus t = fmap (\failure -> Finding t failure bytes) <$> trial (tryKind t) bytes
  where
    bytes = inputOf corpus t

-- | Tries the inputs of these names, and gives all that fail.
tryMany :: Corpus -> [Try] -> IO [Finding]
tryMany corpus = fmap concat . traverse (fmap (maybe [] pure) . tryInput corpus)

-- | Shrinks what fails and writes it to the folder of cases, under a name that says how it fails, with that number. The
-- path, and the shrunk input.
keepFinding :: Int -> Finding -> IO (FilePath, ByteString)
keepFinding number (Finding (Try _ kind _) failure bytes) = do
  small <- shrunk (if Bytes.length bytes > 20000 then 300 else 3000) fails bytes
  createDirectoryIfMissing True casesFolder
  Bytes.writeFile path small
  pure (path, small)
  where
    path = casesFolder </> Text.unpack (name (failureName failure)) <> "-" <> show number <> extension kind
    name :: Text -> Text
    name words' = if Text.pack (kindName kind) `Text.isPrefixOf` words' then words' else Text.pack (kindName kind) <> Text.pack "-" <> words'
    fails smaller =
      trial kind smaller >>= \case
        Just other -> pure (failureName other == failureName failure)
        Nothing -> pure False
