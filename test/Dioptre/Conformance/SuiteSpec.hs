{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Conformance.SuiteSpec
  ( spec,
  )
where

import Data.Aeson (Value (..), object, (.=))
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isLeft)
import Data.Text (Text)
import qualified Data.Vector.Storable as Storable
import Dioptre.Conformance.Compare (Comparison (..))
import Dioptre.Conformance.Suite
import Dioptre.Conformance.Verdict (Case (..))
import Dioptre.Picture (picture)
import Dioptre.Picture.Png (encode)
import System.Directory (createDirectoryIfMissing, makeAbsolute)
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec (Spec, describe, expectationFailure, it, shouldBe, shouldReturn, shouldSatisfy)

spec :: Spec
spec = do
  describe "a vector file" $ do
    it "has cases" $
      readVectors (linear "{\"id\":\"roots.linear/1\",\"rules\":[\"a.b\"],\"comment\":\"c\",\"flags\":[\"f\"],\"in\":{\"a\":1},\"ok\":null,\"compare\":\"ulp:2\",\"source\":\"by hand\"}")
        `shouldBe` Right [Case "roots.linear/1" "maths" "roots.linear" ["a.b"] "c" ["f"] (object ["a" .= (1 :: Int)]) Null (Ulp 2)]
    it "compares exactly where it says nothing" $
      fmap (map caseComparison) (readVectors (linear "{\"id\":\"x\",\"rules\":[],\"in\":{},\"ok\":1}")) `shouldBe` Right [Exact]
    it "is refused where something is missing or wrong" $
      filter
        (not . isLeft . readVectors)
        [ "",
          "[]",
          linear "{\"rules\":[],\"in\":{},\"ok\":1}",
          linear "{\"id\":\"x\",\"rules\":[],\"ok\":1}",
          linear "{\"id\":\"x\",\"rules\":[],\"in\":{}}",
          linear "{\"id\":\"x\",\"rules\":[],\"in\":{},\"ok\":1,\"compare\":\"near\"}",
          "{\"operation\":\"roots.linear\",\"profile\":\"optics\",\"cases\":[]}",
          "{\"operation\":\"roots.root\",\"profile\":\"maths\",\"cases\":[]}"
        ]
        `shouldBe` []
  describe "a suite" $ do
    it "is found from a folder inside" . withSystemTempDirectory "suite" $ \folder -> do
      createDirectoryIfMissing True (folder </> "conformance" </> "vectors")
      createDirectoryIfMissing True (folder </> "a" </> "b")
      here <- makeAbsolute folder
      findSuite (folder </> "a" </> "b") `shouldReturn` Just (here </> "conformance")
      findSuite folder `shouldReturn` Just (here </> "conformance")
    it "is read by profiles, then operations, with the files that cases name" . inSuite [("roots.linear", oneCase), ("roots.cubic", cubic), ("scene.picture", drawn), ("optics.reflect", mirror)] $ \folder -> do
      createDirectoryIfMissing True (folder </> "pictures")
      writeFile (folder </> "pictures" </> "dot.txt") "camera\n"
      Lazy.writeFile (folder </> "pictures" </> "dot.png") (encode (picture 1 (Storable.fromList [1, 2, 3, 255])))
      cases <- readSuite folder >>= either (\fault -> [] <$ expectationFailure (show fault)) pure
      map caseName cases `shouldBe` ["roots.cubic/1", "x", "optics.reflect/1", "scene.picture/1"]
      -- The bytes 1, 2, 3, 255 in base 64.
      [(caseInput c, caseExpected c) | c <- cases, caseOperation c == "scene.picture"]
        `shouldBe` [(object ["text" .= ("camera\n" :: Text)], object ["width" .= (1 :: Int), "height" .= (1 :: Int), "rgba" .= ("AQID/w==" :: Text)])]
    it "includes the examples of the specification beside it" . withSystemTempDirectory "suite" $ \folder -> do
      createDirectoryIfMissing True (folder </> "conformance" </> "vectors")
      createDirectoryIfMissing True (folder </> "spec")
      writeFile (folder </> "spec" </> "1.md") "**`a.b`** Rule.\n```example a.b-1 roots.linear\n{}\n---\n[]\n```\n"
      fmap (map (\c -> (caseName c, caseComment c))) <$> readSuite (folder </> "conformance") `shouldReturn` Right [("a.b-1", "spec/1.md:2")]
      writeFile (folder </> "spec" </> "1.md") "**`a.b`** Rule.\n"
      readSuite (folder </> "conformance") `shouldReturn` Left (Malformed "spec/1.md:1" "a.b has no example")
    it "has no two cases of one name" . inSuite [("roots.linear", oneCase), ("roots.cubic", "{\"operation\":\"roots.cubic\",\"profile\":\"maths\",\"cases\":[{\"id\":\"x\",\"rules\":[],\"in\":{},\"ok\":1}]}")] $ \folder ->
      readSuite folder `shouldReturn` Left (NotUnique "x")
    it "is not there where its files are not" . withSystemTempDirectory "suite" $ \folder ->
      readSuite (folder </> "nowhere") >>= (`shouldSatisfy` isLeft)
  describe "a selection" $ do
    it "is all where nothing is said" $ names (Selection [] Nothing Nothing) `shouldBe` ["1", "2", "3"]
    it "is of profiles" $ names (Selection ["maths", "scene"] Nothing Nothing) `shouldBe` ["1", "3"]
    it "is of a rule, or of the rules that begin so" $
      [names (Selection [] (Just r) Nothing) | r <- ["a.b", "a", "a.b.c", "a.", "b"]] `shouldBe` [["1", "2"], ["1", "2", "3"], ["2"], [], []]
    it "is of a case" $ names (Selection [] Nothing (Just "2")) `shouldBe` ["2"]
    it "is of what fits all" $ names (Selection ["maths"] (Just "a.b.c") Nothing) `shouldBe` []
  where
    linear item = "{\"operation\":\"roots.linear\",\"profile\":\"maths\",\"cases\":[" <> item <> "]}"
    oneCase = linear "{\"id\":\"x\",\"rules\":[],\"in\":{},\"ok\":1}"
    cubic = "{\"operation\":\"roots.cubic\",\"profile\":\"maths\",\"cases\":[{\"id\":\"roots.cubic/1\",\"rules\":[],\"in\":{},\"ok\":1}]}"
    mirror = "{\"operation\":\"optics.reflect\",\"profile\":\"optics\",\"cases\":[{\"id\":\"optics.reflect/1\",\"rules\":[],\"in\":{},\"ok\":1}]}"
    drawn = "{\"operation\":\"scene.picture\",\"profile\":\"picture\",\"cases\":[{\"id\":\"scene.picture/1\",\"rules\":[],\"in\":{\"file\":\"dot.txt\"},\"ok\":{\"file\":\"dot.png\"}}]}"
    names s = map caseName (select s [one "1" "maths" ["a.b"], one "2" "optics" ["a.b.c", "x.y"], one "3" "scene" ["a.bc"]])
    one name profile rules = Case name profile "op" rules "" [] Null Null Exact
    inSuite files use = withSystemTempDirectory "suite" $ \folder -> do
      createDirectoryIfMissing True (folder </> "vectors")
      mapM_ (\(name, text) -> Lazy.writeFile (folder </> "vectors" </> (name <> ".json")) (Lazy.fromStrict text)) files
      use folder
