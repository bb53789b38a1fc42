{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Conformance.ExampleSpec
  ( spec,
  )
where

import Data.Aeson (object, toJSON, (.=))
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Conformance.Compare (Comparison (..))
import Dioptre.Conformance.Example
import Dioptre.Conformance.Verdict (Case (..))
import Test.Hspec (Spec, describe, it, shouldBe)

spec :: Spec
spec = do
  describe "a chapter" $ do
    it "has rules with their examples" $ do
      let (rules, faults) = chapter "c.md" (Text.unlines good)
      faults `shouldBe` []
      [(ruleLabel r, ruleLine r, map caseName (ruleExamples r), ruleShown r) | r <- rules]
        `shouldBe` [("roots.order", 3, ["roots.order-1"], 1), ("check.words", 17, ["check.words-1"], 0)]
      map (\c -> (caseInput c, caseExpected c, caseComparison c, caseProfile c)) (concatMap ruleExamples rules)
        `shouldBe` [ (object ["a" .= (2 :: Int), "b" .= (-3 :: Int)], toJSON [1.5 :: Double], Ulp 1, "maths"),
                     (object ["text" .= ("---\n\nend\n" :: Text)], object ["diagnostics" .= ([] :: [Int])], Exact, "scene")
                   ]
    it "has faults with their lines" $ do
      let faultsIn ls = [(chapterFaultLine f, chapterFaultFile f) | f <- snd (chapter "c.md" (Text.unlines ls))]
          rule = "**`a.b`** Text."
          body = ["{\"a\":1,\"b\":2}", "---", "[-2]", "```"]
      faultsIn (rule : "```example a.b-1 roots.linear" : body) `shouldBe` []
      map
        faultsIn
        [ "```example a.b-1 roots.linear" : body,
          rule : "```example a.b-2 roots.linear" : body,
          rule : "```example a.c-1 roots.linear" : body,
          rule : "```example a.b-1 roots.root" : body,
          rule : "```example a.b-1 roots.linear about" : body,
          rule : "```example a.b-1" : body,
          rule : "```example a.b-1 roots.linear exact more" : body,
          [rule, "```example a.b-1 roots.linear", "{}", "[]", "```"],
          [rule, "```example a.b-1 roots.linear", "[]", "---", "[]", "```"],
          [rule, "```example a.b-1 roots.linear", "{}", "---", "```"],
          [rule, "```example a.b-1 roots.linear", "{}", "---", "[] []", "```"],
          [rule, "```example a.b-1 scene.check", "---", "{}", "```"],
          [rule, "```shown a.b-1", "", "```"],
          [rule, "```text", "never closed"],
          ["**`a`** Text."],
          ["**`A.b`** Text."]
        ]
        `shouldBe` map (\n -> [(n, "c.md")]) [1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 1, 1]
  it "has an example for each rule, and each label once" $ do
    let rules = fst (chapter "c.md" "**`a.b`** One.\n\n**`a.c`** Two.\n```shown a.c-1\nSo.\n```\n**`a.c`** Three.\n```shown a.c-1\nSo.\n```\n")
    map chapterFaultLine (faultsOf rules) `shouldBe` [1, 3, 7]
  where
    good =
      [ "# Chapter",
        "",
        "**`roots.order`** A rule, whose text goes on",
        "over lines.",
        "",
        "```example roots.order-1 roots.linear ulp:1",
        "{\"a\":2,",
        "\"b\":-3}",
        "---",
        "[1.5]",
        "```",
        "```shown roots.order-2",
        "$ dioptre",
        "```",
        "The words **`of.no rule`** and `a.b` are not at the beginning of a line.",
        "",
        "**`check.words`** Another.",
        "",
        "````text",
        "```example x",
        "**`not.seen`**",
        "````",
        "```example check.words-1 scene.check",
        "{}",
        "---",
        "",
        "end",
        "---",
        "{\"diagnostics\":[]}",
        "```"
      ]
