module Dioptre.Files.IdentitySpec (spec) where

import Dioptre.Command.Heard (inFolder)
import Dioptre.Files.Identity
import System.Directory (createDirectory, createDirectoryLink, createFileLink)
import System.Posix.Files (createLink, createNamedPipe, ownerModes)
import Test.Hspec

spec :: Spec
spec =
  describe "sameFile" $ do
    it "knows a file by every path" . inFolder $ do
      createDirectory "a"
      mapM_ (`writeFile` "x") ["a/x", "y"]
      createFileLink "a/x" "soft"
      createLink "a/x" "hard"
      createDirectoryLink "a" "b"
      mapM (`sameFile` ["nothing", "y", "a/x", "soft"]) ["a/x", "./a/../a//x", "soft", "hard", "b/x"] >>= (`shouldBe` replicate 5 (Just "a/x"))
    it "is none for another file, for none, and for a folder" . inFolder $ do
      createDirectory "a"
      mapM_ (`writeFile` "x") ["x", "y"]
      createFileLink "nowhere" "dangling"
      mapM (`sameFile` ["x", "a", "nothing", "dangling"]) ["y", "a", "nothing", "dangling", "x/y"] >>= (`shouldBe` replicate 5 Nothing)
    it "is none for what has no contents of its own: it may be read and written at once" . inFolder $ do
      createNamedPipe "pipe" ownerModes
      mapM (\path -> sameFile path [path]) ["/dev/null", "pipe"] >>= (`shouldBe` [Nothing, Nothing])
