{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- | What happens on the desk, as laws over any sequence of changes.
module Dioptre.View.DeskSpec (spec) where

import Data.Function ((&))
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Source.Diagnostic (Diagnostic)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Text (Source, fromText)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.View.Desk
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "a new desk" $ do
    it "has nothing to do while nobody looks" $ jobOf desk `shouldBe` Nothing
    it "draws its text as soon as a page is open" $ jobOf (entered desk) `shouldBe` Just (Job 1 False 0)
    it "draws at once where that is wanted" $ jobOf (newDesk English True True "a") `shouldBe` Just (Job 1 False 0)
    it "is saved where there is a file" $ map isSaved [desk, newDesk English False False "a"] `shouldBe` [True, False]

  describe "a text with errors" $ do
    it "is drawn where there is no picture yet" $ drawnFlag (entered desk & checked (Job 1 False 0) faulty Map.empty Nothing) `shouldBe` Just True
    it "is what is left to draw while it is drawn" $ jobOf (entered desk & checked (Job 1 False 0) faulty Map.empty Nothing) `shouldBe` Just (Job 1 False 0)
    it "cannot be drawn where it is too large" $ drawnFlag (entered desk & checked (Job 1 False 0) [] Map.empty (Just (TooLarge 1))) `shouldBe` Just False
    it "is left alone then" $ jobOf (entered desk & checked (Job 1 False 0) [] Map.empty (Just (TooLarge 1))) `shouldBe` Nothing
    it "is asked for again where it is to be drawn anyway" $
      jobOf (entered desk & checked (Job 1 False 0) [] Map.empty (Just (TooLarge 1)) & drawnAnyway) `shouldBe` Just (Job 1 True 0)
    it "is what is wrong with it" $ map hasErrors [[], faulty] `shouldBe` [False, True]

  describe "the file" $ do
    it "is taken over where nothing was typed" $ deskText (foundOnDisk "b" desk) `shouldBe` "b"
    it "does not replace what was typed" $ (typed 1 1 "c" desk & foundOnDisk "b" & \d -> (deskText d, deskConflict d)) `shouldBe` ("c", True)
    it "is taken over on demand" $ (typed 1 1 "c" desk & foundOnDisk "b" & takenFromDisk & \d -> (deskText d, deskConflict d, isSaved d)) `shouldBe` ("b", False, True)
    it "is what was saved" $ (typed 1 1 "c" desk & savedToDisk "c" & \d -> (isSaved d, deskConflict d)) `shouldBe` (True, False)
    it "is in conflict with what was typed before it was seen" $ (foundOnDisk "b" desk & typed 1 1 "c" & \d -> (deskText d, deskConflict d)) `shouldBe` ("c", True)
    it "is not with what was typed in it" $ (foundOnDisk "b" desk & typed 1 2 "c" & \d -> (deskText d, deskConflict d)) `shouldBe` ("c", False)
    it "is not where the same was typed" $ (foundOnDisk "b" desk & typed 1 1 "b" & deskConflict) `shouldBe` False
    it "is no news after it was saved" $ (typed 1 1 "c" desk & savedToDisk "c" & foundOnDisk "c" & deskVersion) `shouldBe` 2

  describe "after any changes" $ do
    prop "versions count the texts" . forAll changes $ \cs ->
      let desks = scanl (&) (entered desk) (map change cs)
       in conjoin [(deskVersion b - deskVersion a) === (if deskText a == deskText b then 0 else 1) | (a, b) <- zip desks (drop 1 desks)]
    prop "another text is another job" . forAll changes $ \cs ->
      let desks = scanl (&) (entered desk) (map change cs)
       in conjoin [counterexample (show (jobOf a, jobOf b)) (jobOf a /= jobOf b) | (a, b) <- zip desks (drop 1 desks), deskText a /= deskText b, deskPages b > 0]
    prop "another file is another job, whatever was done" . forAll changes $ \cs ->
      let d = foldl (&) (entered desk) (map change cs) in jobOf (filesChanged d) === Just (Job (deskVersion d) (deskAnyway d == Just (deskVersion d)) (deskChanges d + 1))
    prop "nobody's typing is lost to the file" . forAll changes $ \cs ->
      let desks = zip (scanl (&) (entered desk) (map change cs)) cs
       in conjoin [deskText (change c d) === deskText d | (d, c@(OnDisk _)) <- desks, not (isSaved d)]
    prop "no text of the file is passed over in silence by who has not seen it" . forAll changes $ \cs ->
      let desks = scanl (&) (entered desk) (map change cs)
          versions = [deskVersion a | (a, b) <- zip desks (drop 1 desks), deskVersion b == deskVersion a + 1, deskBy b == Disk]
       in conjoin [counterexample (show v) (deskConflict (typed 1 v "d" (last desks))) | v <- versions]
    prop "what is in conflict is not saved" . forAll changes $ \cs ->
      let d = foldl (&) (entered desk) (map change cs) in counterexample (show (deskDisk d, deskText d)) (not (deskConflict d && isSaved d))
  where
    desk = newDesk English True False "a"
    drawnFlag d = checkedDrawn <$> deskChecked d

-- | What is wrong with a text that has an error.
faulty :: [(Source, [Diagnostic])]
faulty = let source = fromText "scene.txt" "sphre" in [(source, snd (checkScene (parse source)))]

-- | Something that happens.
data Change = Typed Int Text | OnDisk Text | OtherFile | Taken | Saved | Anyway | Looked Bool
  deriving stock (Show)

change :: Change -> Desk -> Desk
change c d = case c of
  Typed ago t -> typed 1 (deskVersion d - ago) t d
  OnDisk t -> foundOnDisk t d
  OtherFile -> filesChanged d
  Taken -> takenFromDisk d
  Saved -> savedToDisk (deskText d) d
  Anyway -> drawnAnyway d
  Looked bad -> maybe d (\job -> checked job (if bad then faulty else []) Map.empty (if bad then Just (TooLarge 1) else Nothing) d) (jobOf d)

changes :: Gen [Change]
changes = listOf (oneof [Typed <$> chooseInt (0, 3) <*> text, OnDisk <$> text, pure OtherFile, pure Taken, pure Saved, pure Anyway, Looked <$> arbitrary])
  where
    text = elements ["a", "b", "c"]
