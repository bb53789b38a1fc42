{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.FormSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Scene.Form
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Syntax.Tree (Value (..))
import Laws.Number (Admitted (..))
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))
import Test.Hspec hiding (Expectation)
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (NonNegative (..), Property, chooseInt, forAll, (===), (==>))

spec :: Spec
spec = do
  describe "what a form wrote" $
    modifyMaxSuccess (const 300) $ do
      prop "reads back: a real number" $ \(Admitted x) -> readsBack realThatIsAny x
      prop "reads back: a length" $ \(Admitted x) -> let l = max 1e-10 (abs x) in readsBack positive l
      prop "reads back: a number with a unit" $ \(Admitted x) -> readsBack (withUnit "nm" realThatIsAny) x
      prop "reads back: an integer" $ forAll (chooseInt (0, 2147483647)) (readsBack (count 0))
      prop "reads back: a vector" $ \(Admitted x) (Admitted y) (Admitted z) -> readsBack vectorForm (V3 x y z)
      prop "reads back: a scale" $ \(Admitted x) (Admitted y) (Admitted z) -> notElem 0 [x, y, z] ==> readsBack scaleForm (V3 x y z)
      prop "reads back: two coordinates" $ \(Admitted x) (Admitted y) -> readsBack textureForm (V2 x y)
      prop "reads back: a colour" $ \(Admitted r) (Admitted g) (Admitted b) (NonNegative a) -> readsBack colourForm (Colour (abs r) (abs g) (abs b) a)
      it "reads back: a choice" $ do
        for_ [False, True] $ \b -> reads' booleanForm (shown booleanForm b) `shouldBe` Right b
        for_ ['a', 'b', 'c'] $ \c -> reads' letters (shown letters c) `shouldBe` Right c

  describe "a form of one number" $ do
    it "reads the first token, and leaves the rest" $
      for_ ["5", "5 degrees", "[5]", "(5, 6)", "\t5\f#", " , 5 6 7", "5 , 6"] $ \t -> (t, reads' realThatIsAny t) `shouldBe` (t, Right 5)
    it "refuses a unit that is not apart" $ reads' realThatIsAny "5nm" `shouldBe` Left (NotANumber "5nm")
    it "holds the ends of its range" $ do
      map (reads' (realWithin 0 1)) ["0", "-0", "1", "1.0000000000000001"] `shouldBe` map Right [0, 0, 1, 1]
      map (reads' (realWithin 0 1)) ["-1e-300", "1.0000000000000003"] `shouldBe` [Left (OutOfRange "-1e-300"), Left (OutOfRange "1.0000000000000003")]
      map (reads' (integerWithin 0 999)) ["0", "999", "1000", "-1"] `shouldBe` [Right 0, Right 999, Left (OutOfRange "1000"), Left (OutOfRange "-1")]
      map (reads' positive) ["1e-10", "0.99999999e-10", "-1"] `shouldBe` [Right 1e-10, Left (OutOfRange "0.99999999e-10"), Left (OutOfRange "-1")]
    it "says what it expects" $ do
      map formExpectation [realWithin 0 1, realFrom 0, realThatIsAny, positive] `shouldBe` [ARealNumber (Between "0.0" "1.0"), ARealNumber (AtLeast "0.0"), ARealNumber AnyNumber, ARealNumber (AtLeast "1.0e-10")]
      map formExpectation [count 1, integerWithin 0 999] `shouldBe` [AnInteger (AtLeast "1"), AnInteger (Between "0" "999")]

  describe "a form of several numbers" $ do
    it "takes any brackets" $
      for_ ["[1, 2, 3]", "(1,2,3)", "<1 2 3>", "1 2 3", "1,2,3", "< 1, (2] 3"] $ \t -> (t, reads' vectorForm t) `shouldBe` (t, Right (V3 1 2 3))
    it "takes that many, and no others" $ do
      map (reads' vectorForm) ["", "1", "1 2", "1 2 3 4"] `shouldBe` map Left [NothingThere, WrongCount 3 1 NoGuess, WrongCount 3 2 NoGuess, WrongCount 3 4 NoGuess]
      map (reads' textureForm) ["1", "1 2", "1 2 3"] `shouldBe` [Left (WrongCount 2 1 NoGuess), Right (V2 1 2), Left (WrongCount 2 3 NoGuess)]
    it "refuses a direction shorter than 1e-10" $ do
      reads' directionForm "0 0 0.99e-10" `shouldBe` Left ZeroVector
      reads' directionForm "0 0 1.01e-10" `shouldBe` Right (V3 0 0 1.01e-10)
    it "refuses a scale with a zero" $ map (reads' scaleForm) ["1 0 1", "1 1 -0.0", "1 1e-300 -1"] `shouldBe` [Left ZeroComponent, Left ZeroComponent, Right (V3 1 1e-300 (-1))]

  describe "a colour" $ do
    it "is a name, in either language and any case" $
      for_ [("black", "noir", Colour 0 0 0 1), ("white", "blanc", Colour 1 1 1 1), ("red", "rouge", Colour 1 0 0 1), ("green", "vert", Colour 0 1 0 1), ("blue", "bleu", Colour 0 0 1 1)] $ \(en, fr, c) ->
        map (reads' colourForm) [en, fr, Text.toUpper en, "[" <> fr <> "]", en <> " 1.0"] `shouldBe` replicate 5 (Right c)
    it "is a name and alpha, three channels, or four" $
      map (reads' colourForm) ["red 0.5", "1 2 3", "1 2 3 4", "<0, 0, 0, 0>"] `shouldBe` map Right [Colour 1 0 0 0.5, Colour 1 2 3 1, Colour 1 2 3 4, Colour 0 0 0 0]
    it "is no name with more than an alpha behind it, of which the reason may be seen" $
      map (reads' colourForm) ["red # rouge", "RED // rouge", "rouge 1 end", "red 0 0", "red = 1", "red # x y z", "1 0 0 # x", "1 0 0 1 fin"]
        `shouldBe` map
          Left
          ( [NameAmongNumbers "red" CommentBehind, NameAmongNumbers "RED" CommentBehind, NameAmongNumbers "rouge" (EndBehind "end"), NameAmongNumbers "red" NoGuess, NameAmongNumbers "red" SignsAround]
              <> [WrongCount 4 5 CommentBehind, WrongCount 4 5 CommentBehind, WrongCount 4 5 (EndBehind "fin")]
          )
    it "is nothing else" $
      map (reads' colourForm) ["", "1 2 3 4 5", "redd", "-1 0 0", "0 0 0 -1", "red -1", "1 2"]
        `shouldBe` map Left [NothingThere, WrongCount 4 5 NoGuess, NoSuchChoice "redd" (Just "red"), OutOfRange "-1", OutOfRange "-1", OutOfRange "-1", NoSuchChoice "1" Nothing]

  describe "a choice" $ do
    it "is a word in any case, or its number from 0" $ map (reads' letters) ["one", "TWO", "2", "0 one", "+1"] `shouldBe` map Right "abcab"
    it "is nothing else" $ map (reads' letters) ["", "3", "-1", "on", "1.0"] `shouldBe` map Left [NothingThere, OutOfRange "3", OutOfRange "-1", NoSuchChoice "on" (Just "one"), NoSuchChoice "1.0" Nothing]
    it "is too large a number, where it is" $ reads' letters "99999999999" `shouldSatisfy` (`elem` map Left [TooLarge "99999999999", OutOfRange "99999999999"])

  describe "text" $ do
    it "is the rest of the line, with its blanks and all" $ map (reads' text) ["a b ", "# x", "[1]", "\233\t"] `shouldBe` map Right ["a b ", "# x", "[1]", "\233\t"]
    it "is not nothing" $ reads' text "" `shouldBe` Left NothingThere
    it "that names a file to read is any, but for the word none" $ do
      map (reads' fileName) ["a/b.png", "none", "None", "none ", ""] `shouldBe` [Right (Just "a/b.png"), Right Nothing, Right (Just "None"), Right (Just "none "), Left NothingThere]
      for_ [Nothing, Just "a b"] $ \name -> reads' fileName (shown fileName name) `shouldBe` Right name
    it "that names a file to write leads nowhere else" $ do
      map (reads' outputName) ["a b.txt", "a:b", ".x"] `shouldBe` map Right ["a b.txt", "a:b", ".x"]
      for_ ["a/b", "/", "a\\b", "a\nb", "\ESC", "a\DEL", "a\128"] $ \t -> (t, reads' outputName t) `shouldBe` (t, Left UnsafeName)
    it "that names a log ends in .txt" $
      map (reads' (outputNameEnding ".txt")) ["a.txt", "a.TXT", "a.txt ", "atxt", "a/b.txt"] `shouldBe` [Right "a.txt", Right "a.TXT", Left WrongEnding, Left WrongEnding, Left UnsafeName]
  where
    letters = choice [("one", 'a'), ("two", 'b'), ("three", 'c')]

reads' :: Form v -> Text -> Either Refusal v
reads' form t = either (Left . snd) Right (formRead form (Value (Span 1 1 (1 + Text.length t)) t))

readsBack :: (Eq v, Show v) => Form v -> v -> Property
readsBack form v = reads' form (shown form v) === Right v

shown :: Form v -> v -> Text
shown form = fromMaybe "" . formShow form
