{-# LANGUAGE OverloadedStrings #-}

-- | The two commands of conformance: the oracle on standard input and output, and the suite against a port.
module Dioptre.Command.ConformSpec
  ( spec,
  )
where

import Control.Exception (bracket, finally)
import Data.Aeson (Value (..), decode, object, toJSON, (.=))
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import qualified Data.ByteString.Lazy as Lazy
import Dioptre.Command.Conform (Trial (..), conform)
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.Oracle (oracle)
import Dioptre.Conformance.Suite (Selection (..))
import Dioptre.Source.Language (Language (..))
import GHC.IO.Handle (hDuplicate, hDuplicateTo)
import System.Directory (createDirectoryIfMissing)
import System.Exit (ExitCode (..))
import System.FilePath ((</>))
import System.IO (Handle, IOMode (..), hClose, hFlush, hSetEncoding, openBinaryFile, stderr, stdin, stdout, utf8)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec (Spec, describe, it, shouldBe, shouldReturn, shouldSatisfy)

spec :: Spec
spec = do
  describe "oracle" $ do
    it "answers line by line, in order, and ends with its input" $
      asked "{\"id\":0,\"op\":\"roots.linear\",\"in\":{\"a\":2,\"b\":-3}}\nx\n{\"id\":2,\"op\":\"nothing\"}\n{\"id\":1,\"op\":\"vector.modulus\",\"in\":{\"a\":[2,3,6]}}"
        `shouldReturn` (ExitSuccess, ["{\"id\":0,\"ok\":[1.5]}", "{\"error\":\"the line is not JSON\"}", "{\"id\":2,\"skip\":\"not implemented\"}", "{\"id\":1,\"ok\":7}"])
    it "answers nothing to nothing" $ asked "" `shouldReturn` (ExitSuccess, [])
    it "passes over a line that is too long" $ do
      (code, answers) <- asked ("[\"" <> Bytes.replicate (64 * 1024 * 1024) 120 <> "\"]\n{\"id\":1,\"op\":\"vector.modulus\",\"in\":{\"a\":[2,3,6]}}\n")
      (code, answers) `shouldBe` (ExitSuccess, ["{\"error\":\"the line is longer than 64 MiB\"}", "{\"id\":1,\"ok\":7}"])
  describe "conform" $ do
    it "exits with 0 where all passes or is skipped" . inSuite $ \folder -> do
      (code, out) <- heard (tried folder id "ok 7")
      code `shouldBe` ExitSuccess
      drop (length (Chars.lines out) - 2) (Chars.lines out) `shouldBe` ["maths               2        0                0", "all                 2        0                0"]
      (code', out') <- heard (tried folder id "echo '{\"id\":'$id',\"skip\":\"no\"}'")
      code' `shouldBe` ExitSuccess
      out' `shouldSatisfy` Bytes.isInfixOf "all                 0        0                2"
    it "exits with 1 where something fails, and tells the rule, the comment and both values" . inSuite $ \folder -> do
      (code, out) <- heard (tried folder id "ok $(($id + 6))")
      code `shouldBe` ExitFailure 1
      mapM_ (\part -> out `shouldSatisfy` Bytes.isInfixOf part) ["vector.modulus/2", "vector.modulus.value", "the second", "too-long", "7  (exact)", "8, which differs at $"]
      out `shouldSatisfy` (not . Bytes.isInfixOf "vector.modulus/1")
      out `shouldSatisfy` Bytes.isInfixOf "all                 1        1                0"
    it "says the same for programs" . inSuite $ \folder -> do
      (_, out) <- heard (tried folder (\t -> t {trialFormat = AsJson}) "ok $(($id + 6))")
      case decode (Lazy.fromStrict out) of
        Just (Object o) -> do
          Keys.lookup "total" o `shouldBe` Just (object ["passed" .= one, "failed" .= one, "notImplemented" .= (0 :: Int)])
          Keys.lookup "profiles" o `shouldBe` Just (listOf [object ["profile" .= String "maths", "passed" .= one, "failed" .= one, "notImplemented" .= (0 :: Int)]])
          Keys.lookup "failures" o
            `shouldBe` Just
              ( listOf
                  [ object
                      [ "case" .= String "vector.modulus/2",
                        "profile" .= String "maths",
                        "operation" .= String "vector.modulus",
                        "rules" .= [String "vector.modulus.value"],
                        "comment" .= String "the second",
                        "flags" .= [String "too-long"],
                        "in" .= object ["a" .= [2, 3, 6 :: Int]],
                        "expected" .= (7 :: Int),
                        "compare" .= String "exact",
                        "got" .= (8 :: Int),
                        "differsAt" .= String "$"
                      ]
                  ]
              )
        other -> fail (show other)
    it "runs one case alone" . inSuite $ \folder -> do
      (code, out) <- heard (tried folder (\t -> t {trialSelection = Selection [] Nothing (Just "vector.modulus/1")}) "ok 7")
      code `shouldBe` ExitSuccess
      out `shouldSatisfy` Bytes.isInfixOf "all                 1        0                0"
    it "exits with 2 where there is no such case, with 3 where there is no suite or no port" . inSuite $ \folder -> do
      fst <$> heard (tried folder (\t -> t {trialSelection = Selection ["optics"] Nothing Nothing}) "ok 7") `shouldReturn` ExitFailure 2
      fst <$> heard (tried (folder </> "nowhere") id "ok 7") `shouldReturn` ExitFailure 3
      fst <$> heard (tried folder (\t -> t {trialCommand = "./there-is-no-such-program"}) "ok 7") `shouldReturn` ExitFailure 3
    it "speaks French" . inSuite $ \folder -> do
      journal <- newJournal French False
      (_, out) <- heard (conform journal (trial folder "ok 8"))
      out `shouldSatisfy` Bytes.isInfixOf "attendu   7"
  where
    one = 1 :: Int
    listOf = toJSON :: [Value] -> Value
    tried folder change each = newJournal English False >>= \journal -> conform journal (change (trial folder each))
    trial folder each = Trial (Selection [] Nothing Nothing) 2 AsText (Just folder) "sh" ["-c", script each]
    script each = "ok() { echo '{\"id\":'$id',\"ok\":'$1'}'; }; while read -r l; do id=${l#*:}; id=${id%%,*}; " <> each <> "; done"

-- | Works with a suite of two cases.
inSuite :: (FilePath -> IO a) -> IO a
inSuite use = withSystemTempDirectory "suite" $ \folder -> do
  createDirectoryIfMissing True (folder </> "vectors")
  Bytes.writeFile (folder </> "vectors" </> "vector.modulus.json") $
    "{\"operation\":\"vector.modulus\",\"profile\":\"maths\",\"cases\":["
      <> "{\"id\":\"vector.modulus/1\",\"rules\":[\"vector.modulus.value\"],\"comment\":\"the first\",\"flags\":[],\"in\":{\"a\":[2,3,6]},\"ok\":7,\"source\":\"by hand\"},"
      <> "{\"id\":\"vector.modulus/2\",\"rules\":[\"vector.modulus.value\"],\"comment\":\"the second\",\"flags\":[\"too-long\"],\"in\":{\"a\":[2,3,6]},\"ok\":7,\"source\":\"by hand\"}]}"
  use folder

-- | The oracle's exit code and answers, given its input.
asked :: Bytes.ByteString -> IO (ExitCode, [Bytes.ByteString])
asked input = withSystemTempDirectory "asked" $ \folder -> do
  Bytes.writeFile (folder </> "in") input
  source <- openBinaryFile (folder </> "in") ReadMode
  (code, out) <- heard (diverted stdin source (oracle "0"))
  pure (code, Chars.lines out)

-- | What some work returns, and what it says on standard output.
heard :: IO a -> IO (a, Bytes.ByteString)
heard work = withSystemTempDirectory "heard" $ \folder -> do
  out <- openBinaryFile (folder </> "out") WriteMode
  errors <- openBinaryFile (folder </> "err") WriteMode
  mapM_ (`hSetEncoding` utf8) [out, errors]
  result <- diverted stdout out (diverted stderr errors work)
  (,) result <$> Bytes.readFile (folder </> "out")

-- | Puts one handle in the place of another, and closes it in the end.
diverted :: Handle -> Handle -> IO a -> IO a
diverted from to work =
  bracket (hFlush' from >> hDuplicate from) restore (const (hDuplicateTo to from >> (work `finally` hFlush' from))) `finally` hClose to
  where
    restore saved = hDuplicateTo saved from >> hSetEncoding from utf8 >> hClose saved
    hFlush' h = if h == stdin then pure () else hFlush h
