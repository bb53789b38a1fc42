{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Scene.ConfigurationSpec
  ( spec,
  )
where

import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene.Configuration
import Dioptre.Source.Diagnostic
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Laws.Reading (at)
import Test.Hspec hiding (Expectation)

spec :: Spec
spec = do
  describe "a configuration" $ do
    it "of which nothing is said has the defaults" $
      readConfiguration [] `shouldBe` (Configuration RunNothing "read_data_file_name.txt" "write_data_file_name.txt" "log.txt" True True 0 Nothing, [])
    it "is what is said of it" $
      readConfiguration ["# mine", "application console", "read_data a b.txt", "WRITE_data c.txt", "log_file_name L.TXT", "log_console no", "log_file 0", "viewport_image_count 999", "language fr"]
        `shouldBe` (Configuration RunConsole "a b.txt" "c.txt" "L.TXT" False False 999 (Just French), [])
    it "has a word for each application, or its number" $
      for_ (zip [0 :: Int ..] [("none", RunNothing), ("info", RunInfo), ("console", RunConsole), ("frame", RunFrame), ("comparator", RunComparator)]) $ \(n, (name, application)) ->
        for_ [name, Text.toUpper name, Text.pack (show n)] $ \written ->
          (written, configurationApplication (fst (readConfiguration ["application 3", "application " <> written]))) `shouldBe` (written, application)
    it "has two words for what is read, and for what is written" $
      for_ [("read_data", "write_data"), ("read_scene", "write_scene")] $ \(r, w) -> do
        let c = fst (readConfiguration [r <> " a.txt", w <> " b.txt"])
        (configurationRead c, configurationWrite c) `shouldBe` ("a.txt", "b.txt")
    it "has many words for yes and no" $ do
      let told word t = let (c, ds) = readConfiguration [word <> " " <> t] in (if word == "log_console" then configurationLogConsole c else configurationLogFile c, ds)
      for_ ["log_console", "log_file"] $ \word -> do
        for_ ["true", "vrai", "yes", "oui", "on", "1", "7", "TRUE", "Oui", "+1"] $ \t -> (t, told word t) `shouldBe` (t, (True, []))
        for_ ["false", "faux", "no", "non", "off", "0", "OFF", "-0"] $ \t -> (t, told word t) `shouldBe` (t, (False, []))
    it "has a language" $
      map (\t -> configurationLanguage (fst (readConfiguration ["language " <> t]))) ["en", "FR", "french", "anglais", "de"] `shouldBe` [Just English, Just French, Just French, Just English, Nothing]
    it "keeps the value before a fault, and tells it" $
      readConfiguration ["application 4", "application 5", "application consol", "log_file -1", "log_file maybe", "viewport_image_count 1000", "viewport_image_count 1.0", "read_data ", "log_file_name x.log", "write_data a/b", "language de"]
        `shouldBe` ( (fst (readConfiguration [])) {configurationApplication = RunComparator},
                     [ at 2 13 14 (RefusedValue "application" (OutOfRange "5") applications (Kept "comparator")),
                       at 3 13 19 (RefusedValue "application" (NoSuchChoice "consol" (Just "console")) applications (Kept "comparator")),
                       at 4 10 12 (RefusedValue "log_file" (OutOfRange "-1") ABoolean (Kept "true")),
                       at 5 10 15 (RefusedValue "log_file" (NoSuchChoice "maybe" Nothing) ABoolean (Kept "true")),
                       at 6 22 26 (RefusedValue "viewport_image_count" (OutOfRange "1000") (AnInteger (Between "0" "999")) (Kept "0")),
                       at 7 22 25 (RefusedValue "viewport_image_count" (NotAnInteger "1.0") (AnInteger (Between "0" "999")) (Kept "0")),
                       at 8 1 10 (RefusedValue "read_data" NothingThere SomeText (Kept "read_data_file_name.txt")),
                       at 9 15 20 (RefusedValue "log_file_name" WrongEnding (AnOutputNameEnding ".txt") (Kept "log.txt")),
                       at 10 12 15 (RefusedValue "write_data" UnsafeName AnOutputName (Kept "write_data_file_name.txt")),
                       at 11 10 12 (RefusedValue "language" (NoSuchChoice "de" Nothing) (AChoice ["en", "fr", "english", "french", "anglais", "francais", "fran\231ais"]) TheDefault)
                     ]
                   )
    it "tells words that it does not have, and reads on" $ do
      let (c, ds) = readConfiguration ["aplication 2", "angle 3", "end", "log_file no"]
      configurationLogFile c `shouldBe` False
      map (\(Diagnostic s p) -> (code p, spanLine s, spanColumn s, spanEndColumn s)) ds
        `shouldBe` [("unknown-word", 1, 1, 11), ("misplaced-word", 2, 1, 6), ("stray-end", 3, 1, 4)]
      [g | Diagnostic _ (UnknownWord _ _ g _) <- ds] `shouldBe` [Just "application"]
    it "has no objects: words that would open one hide nothing behind them" $ do
      let (c, ds) = readConfiguration ["sphere", "ray 1", "log_file no", "end", "nobody", "viewport_image_count 7", "camera", "log_console no"]
      (configurationLogFile c, configurationImageCount c, configurationLogConsole c) `shouldBe` (False, 7, False)
      map (\(Diagnostic s p) -> (code p, spanLine s, spanColumn s, spanEndColumn s)) ds
        `shouldBe` [("misplaced-word", 1, 1, 7), ("misplaced-word", 2, 1, 4), ("unknown-word", 5, 1, 7), ("misplaced-word", 7, 1, 7)]
    it "never writes over what it reads, nor over itself, nor twice to one file" $ do
      clashing ["read_data a.txt", "write_data A.txt"] `shouldBe` [("write_data", 2, 12, 17)]
      clashing ["write_data configuration.cfg"] `shouldBe` [("write_data", 1, 12, 29)]
      clashing ["read_data log.txt"] `shouldBe` [("log_file_name", 1, 1, 1)]
      clashing ["write_data a.txt", "log_file_name a.TXT"] `shouldBe` [("log_file_name", 2, 15, 20)]
      clashing ["read_data a.txt", "write_data b.txt", "log_file_name c.txt"] `shouldBe` []
    it "never does, whatever the names" $
      for_ [(r, w, l) | r <- names, w <- names, l <- names] $ \(r, w, l) -> apartIn ["read_data " <> r, "write_data " <> w, "log_file_name " <> l]
    it "never does, where names have blanks or folders that the search leaves out" $ do
      apartIn ["read_data ./a.txt", "write_data a.txt"]
      apartIn ["read_data scenes/../a.txt", "write_data a.txt"]
      apartIn ["read_data a.txt ", "write_data a.txt"]
      apartIn ["read_data x.txt", "write_data y.txt", "log_file_name x.txt"]
  describe "the first configuration" $ do
    it "says what there is to say where there was none" $
      checkConfiguration (parse (fromText "c" startingConfiguration)) `shouldBe` (Configuration RunInfo "default_scene.txt" "out.txt" "log.txt" True True 0 Nothing, [])
    it "says it line by line" $
      map (take 1 . Text.words) (Text.lines startingConfiguration) `shouldBe` map pure ["application", "read_data", "write_data", "log_file_name", "log_console", "log_file", "viewport_image_count"]
  where
    readConfiguration = checkConfiguration . parse . fromText "c" . Text.unlines
    applications = AChoice ["none", "info", "console", "frame", "comparator"]
    clashing text = [(w, line, from, to) | Diagnostic (Span line from to) (RefusedValue w NameTaken _ _) <- snd (readConfiguration text)]
    names = ["a.txt", "A.TXT", "log.txt", "dioptre_log.txt", "write_data_file_name.txt", "dioptre_write_data_file_name.txt"] :: [Text]
    apartIn text = do
      let c = fst (readConfiguration text)
          -- As files are found: by name only, without blanks around it, in any case.
          found = Text.toCaseFold . Text.strip . Text.takeWhileEnd (/= '/')
          written = [found (configurationWrite c), found (configurationLogName c)]
      (text, [w | w <- written, w == found (configurationRead c) || w == "configuration.cfg"], length (filter (== head written) written)) `shouldBe` (text, [], 1)
