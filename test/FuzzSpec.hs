{-# LANGUAGE LambdaCase #-}

-- | Inputs of every kind, right and wrong: those that failed once, and a short run of the fuzzing harness.
module FuzzSpec
  ( spec,
  )
where

import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Fuzz.Corpus (casesFolder, filesIn, readCorpus)
import Fuzz.Kind (Kind (..), kindName, kindOf)
import Fuzz.Limits (Budget (..), Outcome (..), limited)
import Fuzz.Session
import Fuzz.Shrink (shrunk)
import Fuzz.Target (trial)
import Test.Hspec

spec :: Spec
spec = do
  describe "an input that failed once" $ do
    paths <- runIO (filesIn casesFolder)
    forM_ paths $ \path ->
      it ("does no more: " <> path) $ case kindOf path of
        Nothing -> expectationFailure "a case of no kind"
        Just kind -> Bytes.readFile path >>= trial kind >>= (`shouldBe` Nothing)
  describe "a run of the fuzzing harness" $
    beforeAll readCorpus $
      forM_ shares $ \(kind, count) ->
        it ("finds nothing in " <> show count <> " inputs: " <> kindName kind) $ \corpus ->
          tryMany corpus [Try 1 kind n | n <- [0 .. count - 1]] >>= (`shouldSatisfy` null)
  describe "the harness" $ do
    it "makes the same input of a name every time" $ do
      corpus <- readCorpus
      forM_ [minBound .. maxBound] $ \kind ->
        [inputOf corpus (Try 3 kind n) | n <- [0 .. 20]] `shouldBe` [inputOf corpus (Try 3 kind n) | n <- [0 .. 20]]
    it "has something of each kind to begin with" $ do
      corpus <- readCorpus
      Map.keys corpus `shouldBe` [minBound .. maxBound]
    it "ends what takes too long, and what takes too much" $ do
      ending (Budget 0.2 100000000000) (endless 1) `shouldReturn` "out of time"
      ending (Budget 30 10000000) (endless 2) `shouldReturn` "out of memory"
    it "tells what is thrown, and what is done in time" $ do
      ending (Budget 5 10000000) (ioError (userError "x")) `shouldReturn` "user error (x)"
      ending (Budget 5 10000000) (pure 3) `shouldReturn` "3"
    it "finds the part of an input that matters" $
      shrunk 1000 (pure . isJust . Bytes.elemIndex 120) (Bytes.pack ([0 .. 119] <> [10, 10] <> [120 .. 255])) >>= (`shouldBe` Bytes.pack [120])
  where
    -- About a second each.
    shares =
      [ (SceneFile, 700),
        (ConfigurationFile, 2000),
        (ComparisonList, 2000),
        (MsrFile, 700),
        (AgpFile, 250),
        (ObjFile, 1000),
        (MtlFile, 2000),
        (PictureFile, 2000),
        (TargaFile, 2000),
        (ProtocolLine, 2000)
      ]
    -- Allocates as it counts.
    endless :: Integer -> IO Integer
    endless n = if n < 0 then pure n else endless (n + 1)
    ending :: Budget -> IO Integer -> IO String
    ending budget work =
      (\case Done n _ -> show n; Threw e -> show e; OutOfTime -> "out of time"; OutOfMemory -> "out of memory") <$> limited budget work
