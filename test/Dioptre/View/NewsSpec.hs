{-# LANGUAGE OverloadedStrings #-}

-- | What a page is told, however slowly it listens.
module Dioptre.View.NewsSpec (spec) where

import Control.Concurrent.STM (readTVarIO)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import qualified Data.Sequence as Seq
import Dioptre.Load (loadSource)
import Dioptre.Render.Row (planHeight)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Text (fromText)
import Dioptre.View.Desk
import Dioptre.View.Frame
import Dioptre.View.Message (Message (..))
import Dioptre.View.News
import Test.Hspec
import Test.QuickCheck

spec :: Spec
spec = beforeAll finished $ do
  it "says the text first, then what is wrong, then shows the picture, then that it is done" $ \(desk, frame, progress) ->
    map name (fst (news (nothing English) desk (Just (frame, progress)))) `shouldBe` ["scene", "diagnostics", "start", "coarse", "fine", "progress", "done"]
  it "says nothing twice" $ \(desk, frame, progress) ->
    let (_, told) = news (nothing English) desk (Just (frame, progress)) in map name (fst (news told desk (Just (frame, progress)))) `shouldBe` []
  it "says the same again in another language" $ \(desk, frame, progress) ->
    let (_, told) = news (nothing English) desk (Just (frame, progress)) in map name (fst (news told (spoken French desk) (Just (frame, progress)))) `shouldBe` ["language", "diagnostics"]
  it "says what is wrong again when another file has changed, and nothing else" $ \(desk, frame, progress) ->
    let (_, told) = news (nothing English) desk (Just (frame, progress)) in map name (fst (news told (checked (Job 1 False 1) [] Map.empty Nothing desk) (Just (frame, progress)))) `shouldBe` ["diagnostics"]
  it "says that a picture will not be finished, and shows the last one again" $ \(desk, frame, progress) -> do
    let (_, told) = news (nothing English) desk (Just (frame, progress {progressEnd = Going, progressStrips = Seq.take 10 (progressStrips progress)}))
        other = frame {frameNumber = 7}
    map name (fst (news told desk (Just (other, progress)))) `shouldBe` ["cancelled", "start", "coarse", "fine", "progress", "done"]
    map name (fst (news told desk Nothing)) `shouldBe` ["cancelled"]
  it "shows every strip once, whenever one asks" $ \(desk, frame, progress) -> property . forAll (sort <$> listOf (chooseInt (0, Seq.length (progressStrips progress)))) $ \moments ->
    let at n = if n == Seq.length (progressStrips progress) then progress else progress {progressEnd = Going, progressStrips = Seq.take n (progressStrips progress)}
        ask (said, told) n = let (more, told') = news told desk (Just (frame, at n)) in (said <> more, told')
        (all', _) = foldl ask ([], nothing English) (moments <> [Seq.length (progressStrips progress)])
     in conjoin
          [ sort [y | Show _ True ys <- all', y <- ys] === [0 .. planHeight (framePlan frame) - 1],
            sort [k | Show _ False ks <- all', k <- ks] === [0 .. (planHeight (framePlan frame) + 7) `div` 8 - 1],
            length (filter ((== "done") . name) all') === 1,
            length (filter ((== "start") . name) all') === 1
          ]

-- | A desk with a picture that is finished.
finished :: IO (Desk, Frame, Progress)
finished = do
  loaded <- loadSource English (fromText "scene.txt" text)
  frame <- newFrame 1 1 loaded
  paint 1 (pure ()) frame
  progress <- readTVarIO (frameProgress frame)
  let desk = entered (newDesk English True False text)
      job = Job 1 False 0
  pure (ended job frame (checked job [] Map.empty Nothing desk), frame, progress)
  where
    text = "viewport\nwidth 30\nheight 20\nend\n"

name :: News -> String
name n = case n of
  Show _ fine _ -> if fine then "fine" else "coarse"
  Say m -> case m of
    Hello {} -> "hello"
    SceneIs {} -> "scene"
    Found _ _ -> "diagnostics"
    Start _ -> "start"
    Painting _ _ -> "progress"
    Done _ _ -> "done"
    Abandoned _ -> "cancelled"
    Speaks _ -> "language"
    Story {} -> "story"
    Refused {} -> "refused"
