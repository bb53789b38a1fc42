{-# LANGUAGE OverloadedStrings #-}

-- | The guides for students: what they say that the program tells, it tells.
--
-- A block of code in docs/guide.md or docs/guide.fr.md whose first line is @$ dioptre explain SCENE COLUMN ROW@ (in the
-- French one with @--language fr@ after it) is an excerpt of that pixel's story. Its other lines are the story's, all
-- of them in order, where a line @[...]@ stands for any number of lines.
module GuideSpec
  ( spec,
  )
where

import Control.Monad (forM_, zipWithM_)
import qualified Data.ByteString as Bytes
import Data.Char (isDigit)
import Data.List (isPrefixOf, isSuffixOf, sort, tails)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Explain.Wording (storyText)
import Dioptre.Load (Loaded (..), loadScene, storyAt)
import Dioptre.Source.Language (Language (..))
import System.Directory (listDirectory)
import Test.Hspec (Expectation, Spec, describe, expectationFailure, it, runIO, shouldBe, shouldSatisfy)
import Text.Read (readMaybe)

spec :: Spec
spec = do
  english <- runIO (guide "docs/guide.md")
  french <- runIO (guide "docs/guide.fr.md")
  made <- runIO (sort . filter (\name -> "guide-" `isPrefixOf` name && ".txt" `isSuffixOf` name) <$> listDirectory "scenes")
  describe "docs/guide.md" (answers English english)
  describe "docs/guide.fr.md" (answers French french)
  it "ask for the same pixels, in the same order" $
    map (snd . question . fst) (excerpts french) `shouldBe` map (snd . question . fst) (excerpts english)
  it "show the same pictures and name the same files, in the same order" $
    links french `shouldBe` links english
  forM_ made $ \name -> it ("show " <> name <> " and a pixel of it") $ do
    let scene = "scenes/" <> Text.pack name
    links english `shouldSatisfy` elem ("../" <> scene)
    map (take 1 . snd . question . fst) (excerpts english) `shouldSatisfy` elem [scene]
  describe "an excerpt" $ do
    it "holds the story's lines, all of them where nothing says otherwise" $ do
      unlike ["a", "b", "c"] ["a", "b", "c"] `shouldBe` []
      unlike ["a", "[...]", "c"] ["a", "b", "b", "c"] `shouldBe` []
      unlike ["[...]", "b", "[...]"] ["a", "b", "a"] `shouldBe` []
      unlike ["a", "c"] ["a", "b", "c"] `shouldBe` ["c", end]
      unlike ["a", "[...]", "b"] ["a", "b", "c"] `shouldBe` [end]
      unlike ["b", "[...]"] ["a", "b"] `shouldBe` ["b", "[...]", end]
    it "holds them in their order" $ unlike ["[...]", "b", "[...]", "a", "[...]"] ["a", "b"] `shouldBe` ["a", "[...]", end]
    it "tells the same numbers, but for the last digits" $ do
      unlike ["t = -1350.7015956814776  kept"] ["t = -1350.7015956814779  kept"] `shouldBe` []
      unlike ["t = 4.5  kept"] ["t = 4.50001  kept"] `shouldBe` ["t = 4.5  kept", end]
      unlike ["t = 4.5  kept"] ["t = 4.5  later"] `shouldBe` ["t = 4.5  kept", end]
      unlike ["of 4 shapes"] ["of 5 shapes"] `shouldBe` ["of 4 shapes", end]

-- | What holds for a guide in a language.
answers :: Language -> [Text] -> Spec
answers l text = do
  it "answers the handout's questions, 1.1 to 1.8" $
    [number | "##" : number : _ <- map Text.words text, "1." `Text.isPrefixOf` number] `shouldBe` ["1." <> Text.pack (show k) | k <- [1 .. 8 :: Int]]
  it "has excerpts" $ length (excerpts text) `shouldSatisfy` (>= 8)
  zipWithM_ (\k (command, excerpt) -> it (show k <> ". " <> Text.unpack command) (isTold l command excerpt)) [1 :: Int ..] (excerpts text)

-- | The lines of a guide.
guide :: FilePath -> IO [Text]
guide path = Text.lines . Text.decodeUtf8 <$> Bytes.readFile path

-- | The commands that ask for stories, each with the excerpt below it.
excerpts :: [Text] -> [(Text, [Text])]
excerpts text = case dropWhile (not . isFence) text of
  [] -> []
  _ : rest ->
    let (block, after) = break isFence rest
     in [(command, excerpt) | command : excerpt <- [block], "$ dioptre explain" `Text.isPrefixOf` command] <> excerpts (drop 1 after)
  where
    isFence = Text.isPrefixOf "```"

-- | A command's language, and what it asks for: the scene, the column and the row.
question :: Text -> (Language, [Text])
question command = case drop 3 (Text.words command) of
  [scene, column, row, "--language", "fr"] -> (French, [scene, column, row])
  asked -> (English, asked)

-- | Where a guide's links and pictures lead, but for the other guide.
links :: [Text] -> [Text]
links text = [target | line <- text, after <- drop 1 (Text.splitOn "](" line), let target = Text.takeWhile (/= ')') after, target `notElem` ["guide.md", "guide.fr.md"]]

-- | The program tells this in answer to a command.
isTold :: Language -> Text -> [Text] -> Expectation
isTold l command excerpt = case question command of
  (asked, [scene, column, row])
    | asked == l,
      Just x <- readMaybe (Text.unpack column),
      Just y <- readMaybe (Text.unpack row) -> do
      loaded <- loadScene l (Text.unpack scene) >>= either (fail . Text.unpack) pure
      sum (map (length . snd) (loadedDiagnostics loaded)) `shouldBe` 0
      case storyAt loaded x y of
        Nothing -> expectationFailure "the pixel is outside of the picture"
        Just story -> do
          let told = Text.lines (storyText l scene story)
          case unlike excerpt told of
            [] -> pure ()
            line : _ -> expectationFailure (Text.unpack (Text.unlines (["not told, or not there: " <> line, "What is told:"] <> told)))
  _ -> expectationFailure "not a scene, a column and a row in the guide's language"

-- | What is left of an excerpt at the first line that is not the story's; empty where all of it is told.
unlike :: [Text] -> [Text] -> [Text]
unlike excerpt story = left (excerpt <> [end]) (story <> [end])
  where
    left ("[...]" : rest) told = shortest [left rest later | later <- tails told]
    left (line : rest) (told : later) | line `isLike` told = left rest later
    left rest _ = rest
    shortest = foldr1 (\a b -> if length a <= length b then a else b)

-- | What follows the last line of an excerpt or of a story.
end :: Text
end = "(the end)"

-- | Lines of the same text whose numbers are the same but for rounding. The tangent in a camera and the arc tangent of
-- an angle may differ by an ulp from one machine's library to another's, 1e-16; dividing by the smallest coefficient in
-- the guide, 7e-5, makes 2e-12 of it in a root.
isLike :: Text -> Text -> Bool
isLike a b = length (pieces a) == length (pieces b) && and (zipWith agree (pieces a) (pieces b))
  where
    pieces = Text.groupBy (\c d -> isNumeric c == isNumeric d)
    isNumeric c = isDigit c || c `elem` (".-e" :: String)
    agree p q = case (readMaybe (Text.unpack p), readMaybe (Text.unpack q)) of
      (Just x, Just y) -> abs (x - y) <= 1e-11 * max 1 (abs y :: Double)
      _ -> p == q
