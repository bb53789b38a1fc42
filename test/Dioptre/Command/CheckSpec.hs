{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Command.CheckSpec
  ( spec,
  )
where

import Data.Aeson (Value (..), decode)
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString.Lazy as Lazy
import Data.Foldable (toList)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Check
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Heard (heard, inFolder)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Source.Language (Language (..))
import System.Exit (ExitCode (..))
import Test.Hspec

spec :: Spec
spec = describe "check --original" $ do
  it "adds notes, which do not fail" . inFolder $ do
    Text.writeFile "s.txt" torus
    heard (checking AsText English checkWithOriginal)
      >>= ( `shouldBe`
              ( ExitSuccess,
                Text.unlines
                  [ "s.txt:3:3: note: the original never shows 'torus': no ray meets it, and it throws no shadow  [original-never-hits]",
                    "    3 |   torus",
                    "      |   ^^^^^",
                    "      used: the shape, which is seen",
                    "s.txt: 1 note"
                  ],
                ""
              )
          )
  it "is not there without the option" . inFolder $ do
    Text.writeFile "s.txt" torus
    heard (checking AsText English check) >>= (`shouldBe` (ExitSuccess, "s.txt: no faults\n", ""))
  it "tells faults as before, in their places" . inFolder $ do
    Text.writeFile "s.txt" ("end\n" <> torus <> "camara\n")
    (code, out, _) <- heard (checking AsText French checkWithOriginal)
    code `shouldBe` ExitFailure 1
    last ("" : Text.lines out) `shouldSatisfy` Text.isPrefixOf "s.txt\xA0: "
    map lastWord (filter ("s.txt" `Text.isPrefixOf`) (Text.lines out))
      `shouldBe` ["[stray-end]", "[original-ends-scene]", "[original-never-hits]", "[unknown-word]", "[original-reads-around]", "remarques"]
  it "is told to programs, too" . inFolder $ do
    Text.writeFile "s.txt" torus
    (code, out, _) <- heard (checking AsJson English checkWithOriginal)
    code `shouldBe` ExitSuccess
    case decode (Lazy.fromStrict (Text.encodeUtf8 out)) of
      Just (Object o)
        | Just (Array ds) <- Keys.lookup "diagnostics" o,
          [Object d] <- toList ds ->
          [Keys.lookup k d | k <- ["file", "code", "severity", "line", "column", "endColumn", "expected", "used"]]
            `shouldBe` [Just (String "s.txt"), Just (String "original-never-hits"), Just (String "note"), Just (Number 3), Just (Number 3), Just (Number 8), Nothing, Just (String "the shape, which is seen")]
      other -> expectationFailure (show other)
  it "has nothing to say of a configuration" . inFolder $ do
    Text.writeFile "c.cfg" "application none\n"
    heard (newJournal English True >>= \j -> checkWithOriginal j AsText ["c.cfg"]) >>= (`shouldBe` (ExitSuccess, "c.cfg: no faults\n", ""))
  where
    checking format l command = newJournal l True >>= \j -> command j format ["s.txt"]
    lastWord = last . ("" :) . Text.words

torus :: Text
torus = "primitive\n  material_name gold\n  torus\n  end\nend\nmaterial\n  name gold\nend\n"
