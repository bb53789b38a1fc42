{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.ComparisonsSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import qualified Data.Text as Text
import Dioptre.Scene.Comparisons
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Test.Hspec

spec :: Spec
spec =
  describe "a list to compare" $ do
    it "is pairs of files" $
      compared ["texture_comparator", "file a.txt", "fichier b c.png", "end", "Texture_Comparateur", "file d", "file e", "fin"] `shouldBe` ([("a.txt", "b c.png"), ("d", "e")], [])
    it "tells a third file, and what has no place" $ do
      let (pairs, ds) = compared ["texture_comparator", "file a", "file b", "file c", "ray 1", "end", "camera", "end", "file x", "end", "texture_comparator", "file d", "file e"]
      pairs `shouldBe` [("a", "b"), ("d", "e")]
      map (\(Diagnostic s p) -> (code p, spanLine s, spanColumn s)) ds
        `shouldBe` [("repeated-property", 4, 1), ("misplaced-word", 5, 1), ("misplaced-word", 7, 1), ("misplaced-word", 9, 1), ("stray-end", 10, 1), ("missing-end", 11, 1)]
    it "reads back as it was written" $
      for_ [[], [("a", "b")], [("a b", "c.txt"), ("# x", "end"), ("none", "none")]] $ \pairs ->
        checkComparisons (parse (fromText "c" (writeComparisons pairs))) `shouldBe` (pairs, [])
  where
    compared = checkComparisons . parse . fromText "c" . Text.unlines
