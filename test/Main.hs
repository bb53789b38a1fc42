-- | All tests. Every module of this folder whose name ends in Spec is listed here ("StructureSpec" sees to it).
module Main
  ( main,
  )
where

import qualified Dioptre.Files.CounterSpec
import qualified Dioptre.Files.DescriptorSpec
import qualified Dioptre.Files.FaultSpec
import qualified Dioptre.Files.NumberSpec
import qualified Dioptre.Files.SearchSpec
import qualified Dioptre.Files.TemporarySpec
import qualified Dioptre.Files.WholeSpec
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding, utf8)
import qualified StructureSpec
import System.IO (hSetEncoding, stderr, stdout)
import Test.Hspec (Spec, describe, hspec)

main :: IO ()
main = do
  -- As the program does, first thing.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  setLocaleEncoding utf8
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  hspec specs

specs :: Spec
specs = do
  describe "The house" StructureSpec.spec
  describe "Dioptre.Files.Counter" Dioptre.Files.CounterSpec.spec
  describe "Dioptre.Files.Descriptor" Dioptre.Files.DescriptorSpec.spec
  describe "Dioptre.Files.Fault" Dioptre.Files.FaultSpec.spec
  describe "Dioptre.Files.Number" Dioptre.Files.NumberSpec.spec
  describe "Dioptre.Files.Search" Dioptre.Files.SearchSpec.spec
  describe "Dioptre.Files.Temporary" Dioptre.Files.TemporarySpec.spec
  describe "Dioptre.Files.Whole" Dioptre.Files.WholeSpec.spec
