{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.ExplainSpec
-- Description : dioptre explain, as its users meet it
module Dioptre.Command.ExplainSpec (spec) where

import Data.Aeson (Object, Value (..), decode)
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isControl)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Explain
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Heard (heard, inFolder)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Source.Language (Language (..))
import System.Exit (ExitCode (..))
import Test.Hspec

spec :: Spec
spec = do
  it "tells the story on standard output, in the language that is asked for" . inFolder $ do
    Text.writeFile "s.txt" scene
    (code, out, err) <- heard (told English AsText "s.txt" 1 1)
    (code, err) `shouldBe` (ExitSuccess, "")
    out `shouldHold` "s.txt: column 1, row 1, counted from 0, of 3 x 2 pixels"
    (_, out', _) <- heard (told French AsText "s.txt" 1 1)
    out' `shouldHold` "s.txt\xA0: colonne 1, ligne 1, comptées de 0, sur 3 x 2 pixels"
  it "prints one JSON object" . inFolder $ do
    Text.writeFile "s.txt" scene
    (code, out, _) <- heard (told English AsJson "s.txt" 2 0)
    code `shouldBe` ExitSuccess
    fmap (Keys.lookup "column") (decode (Lazy.fromStrict (Text.encodeUtf8 out)) :: Maybe Object) `shouldBe` Just (Just (Number 2))
  it "names a model's file" . inFolder $ do
    Text.writeFile "s.txt" (scene <> "model\nfile ball.msr\ntranslation 0 0 3\nend\n")
    Text.writeFile "ball.msr" "primitive\nmaterial_name m\nsphere\nend\nend\nmaterial\nname m\nend\n"
    (_, out, _) <- heard (told English AsText "s.txt" 1 1)
    out `shouldHold` "its ray sees shape 1 of ball.msr (sphere)"
  it "exits with 2 outside of the picture, and says how large it is" . inFolder $ do
    Text.writeFile "s.txt" scene
    (code, out, err) <- heard (told English AsText "s.txt" 3 0)
    (code, out) `shouldBe` (ExitFailure 2, "")
    err `shouldHold` "columns go from 0 to 2, rows from 0 to 1"
    (code', _, _) <- heard (told English AsText "s.txt" 0 2)
    code' `shouldBe` ExitFailure 2
  it "exits with 3 where there is no such scene" . inFolder $ do
    (code, out, err) <- heard (told English AsText "s.txt" 0 0)
    (code, out) `shouldBe` (ExitFailure 3, "")
    err `shouldHold` "s.txt"
  it "says what is wrong with the scene on standard error, and tells the story all the same" . inFolder $ do
    Text.writeFile "s.txt" (scene <> "camara\n")
    (code, out, err) <- heard (told English AsText "s.txt" 0 0)
    code `shouldBe` ExitSuccess
    out `shouldHold` "The pixel is"
    err `shouldHold` "unknown word 'camara'"
  it "shows nothing that commands a terminal" . inFolder $ do
    Text.writeFile "s.txt" (scene <> "primitive\nmaterial_name \ESC[2Jm\x9B\nplane\nposition 0 0 3\nnormal 0 0 1\nend\nend\nmaterial\nname \ESC[2Jm\x9B\nend\ncam\ESC[1m\n")
    (_, out, err) <- heard (told English AsText "s.txt" 1 1)
    out `shouldHold` "'·[2Jm·'"
    Text.filter (\c -> isControl c && c /= '\n') (out <> err) `shouldBe` ""
  where
    scene = "viewport\nwidth 3\nheight 2\nend\nraytracer\nreflexion_algorithm no_light\nend\n"
    told l format path column row = newJournal l True >>= \journal -> explain journal format path column row

shouldHold :: Text -> Text -> Expectation
shouldHold text part = Text.unpack text `shouldContain` Text.unpack part
