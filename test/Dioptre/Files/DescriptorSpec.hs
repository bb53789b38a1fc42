module Dioptre.Files.DescriptorSpec (spec) where

import Control.Monad (forM_)
import Dioptre.Files.Descriptor
import System.Directory (createFileLink, doesFileExist)
import System.FilePath ((</>))
import System.IO.Error (isAlreadyExistsError, isDoesNotExistError)
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (NonNegative (..))

spec :: Spec
spec = do
  describe "createExclusively" $
    around (withSystemTempDirectory "descriptor") $ do
      it "makes an empty file" $ \folder -> do
        createExclusively (folder </> "new")
        readFile (folder </> "new") `shouldReturn` ""

      it "leaves a file alone that is there" $ \folder -> do
        writeFile (folder </> "old") "old"
        createExclusively (folder </> "old") `shouldThrow` isAlreadyExistsError
        readFile (folder </> "old") `shouldReturn` "old"

      it "does not write through a dangling link" $ \folder -> do
        createFileLink (folder </> "target") (folder </> "link")
        createExclusively (folder </> "link") `shouldThrow` isAlreadyExistsError
        doesFileExist (folder </> "target") `shouldReturn` False

  describe "checkWritable" $
    around (withSystemTempDirectory "descriptor") $ do
      it "leaves the file as it is" $ \folder -> do
        writeFile (folder </> "old") "old"
        checkWritable (folder </> "old")
        readFile (folder </> "old") `shouldReturn` "old"

      it "makes no file" $ \folder -> do
        checkWritable (folder </> "none") `shouldThrow` isDoesNotExistError
        doesFileExist (folder </> "none") `shouldReturn` False

  describe "namedDescriptor" $ do
    prop "reads the number of a descriptor's path" $ \(NonNegative number) ->
      forM_ ["/dev/fd/", "/proc/self/fd/", "/dev//fd/"] $ \folder ->
        namedDescriptor (folder <> show (number :: Int)) `shouldBe` Just (fromIntegral number)

    it "knows the standard streams" $
      map namedDescriptor ["/dev/stdout", "/dev/stderr"] `shouldBe` [Just 1, Just 2]

    it "takes nothing else for a descriptor" $
      forM_ ["", "1", "stdout", "dev/stdout", "/dev/null", "/dev/fd/", "/dev/fd/1x", "/dev/fd/-1", "/dev/fd/9999999999"] $
        \path -> namedDescriptor path `shouldBe` Nothing
