{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Syntax.SpellingSpec
  ( spec,
  )
where

import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Syntax.Keyword (fromSpelling)
import Dioptre.Syntax.Spelling
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "a slip" $
    modifyMaxSuccess (const 500) $ do
      it "is one letter put in, left out, replaced or swapped" $
        map (`isSlipOf` "end") ["edn", "nde", "nd", "ed", "en", "eend", "endd", "xend", "and", "enf", "e", "", "end", "dne", "ends!", "eedn"]
          `shouldBe` [True, False, True, True, True, True, True, True, True, True, False, False, False, False, False, False]
      prop "leads from one word to any that differs so" $ \(Word' w) -> forAll (slipped w) $ \v -> v /= w ==> v `isSlipOf` w .&&. w `isSlipOf` v
      prop "is what makes all the words at one slip, and no others" $ \(Word' a) (Word' b) -> (a `isSlipOf` b) === (b /= a && b `elem` slips a)

  describe "a suggestion" $ do
    it "is the nearest of the candidates, in any case" $ do
      suggest ["sphere", "plane", "cube"] "Sphre" `shouldBe` Just "sphere"
      suggest ["point", "position"] "posiiton" `shouldBe` Just "position"
      suggest ["Rouge"] "ruoge" `shouldBe` Just "Rouge"
    it "is the first of two that are equally near" $ suggest ["kd", "ks", "ka"] "kx" `shouldBe` Just "kd"
    it "is at most one slip in three letters away" $ do
      -- Two slips in five letters, and in six.
      suggest ["abcde"] "abxxe" `shouldBe` Nothing
      suggest ["abcdef"] "abxxef" `shouldBe` Just "abcdef"
      suggest ["sphere", "plane"] "cube" `shouldBe` Nothing
      suggest [] "cube" `shouldBe` Nothing
    it "is what stands in quotation marks" $ map (suggest ["red", "rouge"]) ["\"red\"", "'RED'", "\171rouge\187", "\"\"", "\"rod\""] `shouldBe` [Just "red", Just "red", Just "rouge", Nothing, Nothing]
    prop "is one of the candidates" $ \(Word' w) ws -> maybe True (`elem` [c | Word' c <- ws]) (suggest [c | Word' c <- ws] w)
    prop "finds a word that was written with one slip" $ \(Word' w) -> Text.length w > 2 ==> forAll (slipped w) $ \v -> Text.length v > 2 ==> suggest [w] v === Just w

  describe "a word that the language has not" $ do
    it "is taken for the one that means the same, where that has its place" $ do
      map (\w -> suggestWord ["position", "ray", "rayon"] w "") ["radius", "Centre", "box", "light", "direction"] `shouldBe` [Just "ray", Just "position", Nothing, Nothing, Nothing]
      map (\w -> suggestWord ["sphere", "cube", "calotte_spherique"] w "") ["box", "bo\238te", "calotte", "boule"] `shouldBe` [Just "cube", Just "cube", Just "calotte_spherique", Just "sphere"]
      map (\w -> suggestWord ["kr", "kt", "refractive_index"] w "0.5") ["r\233flexion", "transparence", "indice"] `shouldBe` map Just ["kr", "kt", "refractive_index"]
      suggestWord ["reflexion_algorithm"] "reflection" "" `shouldBe` Just "reflexion_algorithm"
      suggestWord ["ray"] "radius=2" "" `shouldBe` Just "ray 2"
    it "means words that there are, and is none itself" $ do
      filter (isNothing . fromSpelling) (concat (Map.elems synonyms)) `shouldBe` []
      filter (isJust . fromSpelling) (Map.keys synonyms) `shouldBe` []

newtype Word' = Word' Text
  deriving (Eq, Show)

instance Arbitrary Word' where
  arbitrary = Word' . Text.pack <$> (chooseInt (1, 4) >>= (`vectorOf` elements letters))
  shrink (Word' w) = [Word' (Text.take i w <> Text.drop (i + 1) w) | Text.length w > 1, i <- [0 .. Text.length w - 1]]

letters :: String
letters = "abc"

slipped :: Text -> Gen Text
slipped = elements . slips

-- | Every word of these letters at one slip.
slips :: Text -> [Text]
slips w = concat [at (Text.splitAt i w) | i <- [0 .. Text.length w]]
  where
    at (a, b) =
      [a <> Text.singleton c <> b | c <- letters]
        <> [a <> Text.drop 1 b | not (Text.null b)]
        <> [a <> Text.singleton c <> Text.drop 1 b | not (Text.null b), c <- letters]
        <> [a <> Text.reverse (Text.take 2 b) <> Text.drop 2 b | Text.length b > 1]
