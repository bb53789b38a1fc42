{-# LANGUAGE OverloadedStrings #-}

-- | The specification and the vectors against this program: every example of spec/ and every case of conformance/
-- passes.
module Dioptre.Conformance.SpecSpec
  ( spec,
  )
where

import Control.Monad (forM_)
import Data.Aeson.Encoding (encodingToLazyByteString)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (nub)
import qualified Data.Text as Text
import Dioptre.Conformance.Example (Rule (..))
import Dioptre.Conformance.Oracle (perform, profiles)
import Dioptre.Conformance.Protocol (Outcome (..), writeValue)
import Dioptre.Conformance.Suite (findSuite, readSpecification, readSuite)
import Dioptre.Conformance.Verdict (Case (..), Reason (..), Verdict (..), judge)
import Test.Hspec (Expectation, Spec, describe, expectationFailure, it, runIO, shouldBe, shouldSatisfy)

spec :: Spec
spec = do
  specification <- runIO (readSpecification "spec")
  describe "the specification" $ case specification of
    Left fault -> it "has the form that it should have" (expectationFailure (show fault))
    Right rules -> do
      it "has labels that are unique, and an example for every rule" $ length rules `shouldSatisfy` (>= 250)
      it "has examples of every operation" $ do
        let examples = concatMap ruleExamples rules
        length examples `shouldSatisfy` (>= 300)
        [operation | (_, operations) <- profiles, (operation, _) <- operations, operation `notElem` map caseOperation examples] `shouldBe` []
      forM_ (nub (map ruleFile rules)) $ \file ->
        it ("is kept: " <> file) $ concat [failures r | r <- rules, ruleFile r == file] `shouldBe` []
  describe "the suite" . it "passes" $ do
    found <- findSuite "."
    suite <- maybe (pure (Right [])) readSuite found
    case suite of
      Left fault -> expectationFailure (show fault)
      Right cases -> keep cases
  where
    failures = concatMap failed . ruleExamples

keep :: [Case] -> Expectation
keep cases = do
  length cases `shouldSatisfy` (>= 1500)
  concatMap failed cases `shouldBe` []

-- | What is wrong with this program's answer, in words.
failed :: Case -> [String]
failed c = case maybe (NotImplemented "") (judge c . either Fault Ok) (perform (caseOperation c) (caseInput c)) of
  Passed -> []
  NotImplemented _ -> [about "is not implemented"]
  Failed (Different got place) -> [about ("expects " <> shown (caseExpected c) <> ", which differs at " <> Text.unpack place <> " from " <> shown got)]
  Failed reason -> [about (show reason)]
  where
    about text = Text.unpack (caseName c <> " (" <> caseComment c <> ") ") <> text
    shown = Lazy.unpack . encodingToLazyByteString . writeValue
