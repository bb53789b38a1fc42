module Dioptre.Files.TemporarySpec (spec) where

import Control.Exception (ErrorCall (..), throwIO)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Dioptre.Files.Temporary
import System.Directory (listDirectory, renameFile)
import System.FilePath (takeDirectory, (</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = describe "withTemporary" $
  around (withSystemTempDirectory "temporary") $ do
    it "offers a whole file of the folder" $ \folder ->
      withTemporary folder Nothing (Lazy.pack "picture") $ \path -> do
        takeDirectory path `shouldBe` folder
        readFile path `shouldReturn` "picture"

    it "leaves nothing behind" $ \folder -> do
      withTemporary folder Nothing (Lazy.pack "picture") (const (pure ()))
      listDirectory folder `shouldReturn` []

    it "leaves nothing behind when its use fails" $ \folder -> do
      withTemporary folder Nothing (Lazy.pack "picture") (const (throwIO (ErrorCall "use")))
        `shouldThrow` errorCall "use"
      listDirectory folder `shouldReturn` []

    it "leaves what was renamed" $ \folder -> do
      withTemporary folder Nothing (Lazy.pack "picture") (`renameFile` (folder </> "picture.png"))
      listDirectory folder `shouldReturn` ["picture.png"]

    it "gives two at once two names" $ \folder ->
      withTemporary folder Nothing (Lazy.pack "a") $ \one ->
        withTemporary folder Nothing (Lazy.pack "b") $ \other -> do
          contents <- traverse readFile [one, other]
          contents `shouldBe` ["a", "b"]
