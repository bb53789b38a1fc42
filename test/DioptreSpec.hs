-- | The program in the head of "Dioptre", as it stands there.
module DioptreSpec
  ( spec,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isInfixOf, isPrefixOf, partition, stripPrefix)
import Data.Maybe (mapMaybe)
import qualified Data.Text as Text
import Dioptre
import Dioptre.Command.Heard (heard, inFolder)
import Test.Hspec

main :: IO ()
main = do
  source <- decode "scene.txt" <$> Bytes.readFile "scene.txt"
  mapM_ (print . pretty English source) (complaints source)
  Lazy.writeFile "scene.png" (encode (draw source))

spec :: Spec
spec = describe "the program in the head of the module" $ do
  it "is the one that stands here, line by line" $ do
    head' <- mapMaybe (stripPrefix "-- > ") . lines <$> readFile "src/Dioptre.hs"
    here <- lines <$> readFile "test/DioptreSpec.hs"
    let (imports, body) = partition ("import " `isPrefixOf`) head'
    length imports `shouldBe` 3
    [line | line <- imports, line `notElem` here] `shouldBe` []
    take 2 body `shouldBe` ["main :: IO ()", "main = do"]
    body `shouldSatisfy` (`isInfixOf` here)
  it "tells what is wrong, and writes the picture" . inFolder $ do
    writeFile "scene.txt" "viewport\n  widht 40\n  height 20\nend\n"
    (_, out, _) <- heard main
    take 1 (lines (Text.unpack out)) `shouldBe` ["scene.txt:2:3: error: unknown word 'widht'; did you mean 'width'?  [unknown-word]"]
    bytes <- Bytes.readFile "scene.png"
    -- The signature of PNG, and the width and height of its header: 500 and 20.
    Bytes.unpack (Bytes.take 24 bytes) `shouldBe` [137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0, 1, 244, 0, 0, 0, 20]
