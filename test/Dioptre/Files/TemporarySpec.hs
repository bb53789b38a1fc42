module Dioptre.Files.TemporarySpec (spec) where

import Control.Exception (ErrorCall (..), throwIO)
import Control.Monad (void)
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Temporary
import System.Directory (listDirectory, renameFile)
import System.FilePath (takeDirectory, (</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = describe "withTemporary" $
  around (withSystemTempDirectory "temporary") $ do
    it "offers a whole file of the folder" $ \folder -> void . withTemporary folder Nothing (contents (Lazy.pack "picture")) $ \path -> do
      takeDirectory path `shouldBe` folder
      readFile path `shouldReturn` "picture"

    it "leaves nothing behind" $ \folder -> do
      void (withTemporary folder Nothing (contents (Lazy.pack "picture")) (const (pure ())))
      listDirectory folder `shouldReturn` []

    it "leaves nothing behind when its use fails" $ \folder -> do
      withTemporary folder Nothing (contents (Lazy.pack "picture")) (const (throwIO (ErrorCall "use")))
        `shouldThrow` errorCall "use"
      listDirectory folder `shouldReturn` []

    it "leaves what was renamed" $ \folder -> do
      void (withTemporary folder Nothing (contents (Lazy.pack "picture")) (`renameFile` (folder </> "picture.png")))
      listDirectory folder `shouldReturn` ["picture.png"]

    it "gives two at once two names" $ \folder -> void . withTemporary folder Nothing (contents (Lazy.pack "a")) $ \one ->
      void . withTemporary folder Nothing (contents (Lazy.pack "b")) $ \other ->
        traverse readFile [one, other] `shouldReturn` ["a", "b"]

    it "tells what came of the contents and of the use" $ \folder ->
      withTemporary folder Nothing (\put -> 1 <$ put (Char8.pack "picture")) readFile `shouldReturn` (1 :: Int, "picture")
