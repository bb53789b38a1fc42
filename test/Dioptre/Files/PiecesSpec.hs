module Dioptre.Files.PiecesSpec
  ( spec,
  )
where

import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Data.IORef (modifyIORef, newIORef, readIORef)
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Pieces
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec

spec :: Spec
spec = around (withSystemTempDirectory "pieces") . describe "readPieces" $ do
  it "hands over all the bytes, in their order, in pieces that are neither empty nor too large" $ \folder ->
    for_ [0, 1, pieceSize - 1, pieceSize, pieceSize + 1, 3 * pieceSize + 7] $ \size -> do
      let bytes = Bytes.pack (take size (cycle [0 .. 250]))
          path = folder </> "file"
      Bytes.writeFile path bytes
      pieces <- newIORef []
      readPieces path (\piece -> modifyIORef pieces (piece :)) `shouldReturn` Right ()
      found <- reverse <$> readIORef pieces
      (size, Bytes.concat found == bytes) `shouldBe` (size, True)
      filter (\n -> n < 1 || n > pieceSize) (map Bytes.length found) `shouldBe` []
  it "tells what is the matter with a file" $ \folder -> do
    readPieces (folder </> "none") (const (pure ())) `shouldReturn` Left (FileFault (folder </> "none") DoesNotExist)
    readPieces folder (const (pure ())) `shouldReturn` Left (FileFault folder IsAFolder)
    readPieces "/dev/zero" (const (pure ())) `shouldReturn` Left (FileFault "/dev/zero" NotAPlainFile)
