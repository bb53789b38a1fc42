{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Source.ReportSpec
  ( spec,
  )
where

import Data.Aeson (Value, decode, encode)
import Data.Char (isControl)
import Data.Foldable (for_)
import Data.List (isInfixOf)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Report
import Dioptre.Source.Span (Span (..), wholeFile)
import Dioptre.Source.Text (Source, fromText, lineAt)
import Laws.Reading
import Laws.Text
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (Gen, Property, choose, conjoin, counterexample, elements, forAll, listOf, vectorOf, (===))

spec :: Spec
spec = do
  describe "for people" $ do
    it "is the place, what is wrong, the line with carets, what was expected and what is used" $
      shown "a\n  sphre" (Span 2 3 8) (UnknownWord "sphre" ["sphere", "plane"] (Just "sphere") (TheObject 5))
        `shouldBe` [ "scene.txt:2:3: error: unknown word 'sphre'; did you mean 'sphere'?  [unknown-word]",
                     "    2 |   sphre",
                     "      |   ^^^^^",
                     "      expected: one of sphere, plane",
                     "      used: nothing: all is passed over down to line 5"
                   ]
    it "has no line where it is about the whole file" $
      shown "abc" wholeFile (RepeatedProperty "a" 1) `shouldBe` ["scene.txt:1:1: error: 'a' is given more than once  [repeated-property]", "      used: the values before it"]
    it "is in French, too" $
      take 1 (lines (show (pretty French (fromText "a" "end") (Diagnostic (Span 1 1 4) (StrayEnd "end"))))) `shouldBe` ["a:1:1: erreur\xA0: 'end' alors que rien n'est ouvert  [stray-end]"]
    modifyMaxSuccess (const 1000) $ do
      prop "has a caret under the first character of what is wrong, whatever the tabs" $
        forAll aPlace $ \(source, place) -> conjoin [isUnder stop source place | stop <- [4, 8]]
      prop "shows what is wrong, in long lines too, and not much more than a hundred characters" $
        forAll aPlace $ uncurry showsThePlace
    prop "holds no control character of the file" $ \(SceneText t) -> let r = readText t in conjoin [isShownSafely (readingSource r) d | d <- readingDiagnostics r]
    it "holds no control character of the file, each of them" $
      for_ (filter isControl [minBound .. '\255']) $ \c ->
        let r = readText ("camera\nangle a" <> Text.singleton c <> "b\nend\nx" <> Text.singleton c <> "\nend\n")
         in for_ (readingDiagnostics r) $ \d -> show (pretty English (readingSource r) d) `shouldSatisfy` not . any (\x -> isControl x && x `notElem` ("\n\t" :: String))
    it "holds no control character of the file's name" $
      show (pretty English (fromText "a\ESC[31m\n.txt" "end") (Diagnostic (Span 1 1 4) (StrayEnd "end"))) `shouldSatisfy` not . (\t -> '\ESC' `elem` t || "\n.txt" `isInfixOf` t)

  describe "for programs" $ do
    prop "has the fields of its kind" $ \(SceneText t) -> conjoin (map isToldToPrograms (readingDiagnostics (readText t)))
    it "leaves out what is not there" $ do
      keys (ReplacedObject "camera" 3) `shouldBe` Just ["code", "column", "endColumn", "file", "line", "message", "severity"]
      keys (StrayEnd "end") `shouldBe` Just ["code", "column", "endColumn", "file", "line", "message", "severity", "used"]
      keys (RefusedValue "a" NothingThere AVector TheDefault) `shouldBe` Just ["code", "column", "endColumn", "expected", "file", "line", "message", "severity", "used"]

  describe "a summary" $ do
    it "counts errors, warnings and notes" $ do
      summary English (map (at 1 1 1) [UnclosedComment, MissingMaterial "a" Nothing, UnclosedComment, NoMaterialName]) `shouldBe` Just "2 errors, 1 warning, 1 note"
      summary French (map (at 1 1 1) [NoMaterialName, NoMaterialName, UnclosedComment]) `shouldBe` Just "1 erreur, 2 remarques"
    it "is nothing of nothing" $ map (`summary` []) [English, French] `shouldBe` [Nothing, Nothing]
  where
    shown text place problem = lines (show (pretty English (fromText "scene.txt" text) (Diagnostic place problem)))
    keys p = Map.keys <$> (decode (encode (toJson English "a" (at 1 1 4 p))) :: Maybe (Map.Map Text Value))

-- | The excerpt: the line, and the carets below it.
excerptOf :: Source -> Span -> (String, String)
excerptOf source place = case lines (show (pretty English source (Diagnostic place (StrayEnd "end")))) of
  _ : line : carets : _ -> (line, carets)
  other -> (concat other, "")

-- | On a screen with tab stops, the first caret stands in the column of the first character.
isUnder :: Int -> Source -> Span -> Property
isUnder stop source place = counterexample (line <> "\n" <> carets) $ (column carets caret, take 1 (drop caret carets)) === (column line caret, "^")
  where
    (line, carets) = excerptOf source place
    caret = length (takeWhile (/= '^') carets)
    -- The screen column of the n-th character.
    column text n = foldl (\k c -> if c == '\t' then (k `div` stop + 1) * stop else k + 1) 0 (take n text)

-- | Over the carets stands the text itself, or the beginning of a long one.
showsThePlace :: Source -> Span -> Property
showsThePlace source place@(Span n from to) =
  counterexample (line <> "\n" <> carets) $
    conjoin [take count (drop caret line) === Text.unpack (Text.take count wrong), counterexample "carets" (count == Text.length wrong || count >= 20), counterexample "width" (length line <= 8 + 160)]
  where
    (line, carets) = excerptOf source place
    caret = length (takeWhile (/= '^') carets)
    count = length (filter (== '^') carets)
    wrong = Text.take (to - from) (Text.drop (from - 1) (lineAt source n))

-- | A line and a stretch of it.
aPlace :: Gen (Source, Span)
aPlace = do
  text <- Text.pack <$> (elements [0, 5, 60, 200, 400] >>= \n -> (<>) <$> vectorOf n letters <*> listOf letters)
  let line = text <> "x"
  from <- choose (1, Text.length line)
  to <- choose (from + 1, Text.length line + 1)
  pure (fromText "a" ("first\n" <> line <> "\nlast"), Span 2 from to)
  where
    letters = elements "abcde 123\t\233\1046"
