-- | Pictures that are known to be right, against those that the program draws now.
--
-- test/golden holds the two pictures of the handout's introduction: equal, every byte. docs/pictures holds the gallery, drawn by
-- docs/make-pictures; sines and powers may round differently from one machine's library to another's, so a channel may differ by one level
-- there. A picture that differs is written to .stack-work/golden, with one of the differences; nothing here rewrites what is checked in.
module GoldenSpec
  ( spec,
  )
where

import Control.Monad (forM_)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.List (isPrefixOf, isSuffixOf, sort)
import qualified Data.Vector.Storable as Storable
import Dioptre.Load (drawnOrLoaded)
import Dioptre.Picture (Difference (..), Picture, difference, picture, pictureBytes, pictureWidth)
import Dioptre.Picture.Png (decode, encode)
import Dioptre.Source.Language (Language (English))
import System.Directory (createDirectoryIfMissing, listDirectory)
import System.FilePath (dropExtension, (<.>), (</>))
import Test.Hspec (Spec, describe, expectationFailure, it, runIO, shouldBe)

spec :: Spec
spec = do
  describe "The handout's pictures, every byte" $
    forM_ ["intro_plan", "intro_disque"] $ \name -> it name $ matches 0 ("test/golden" </> name <.> "png") name
  scenes <- runIO (map dropExtension . sort . filter (".txt" `isSuffixOf`) <$> listDirectory "scenes")
  describe "The gallery, to one level" $
    forM_ scenes $ \name -> it name $ matches 1 ("docs/pictures" </> name <.> "png") name
  it "has no picture without a scene" $ do
    -- Pictures of the viewer are of a page, and have other tests.
    pictures <- filter (not . ("view-" `isPrefixOf`)) . map dropExtension . sort <$> listDirectory "docs/pictures"
    pictures `shouldBe` scenes

-- | Draws a scene and compares it with a picture, whose channels may differ by so many levels.
matches :: Int -> FilePath -> String -> IO ()
matches slack golden name = do
  wanted <- either (fail . show) pure . decode =<< Bytes.readFile golden
  drawn <- drawnOrLoaded English ("scenes" </> name <.> "txt") >>= either (fail . show) (pure . fst)
  case difference drawn wanted of
    Equal -> pure ()
    PixelsDiffer _ most _ | most <= slack -> pure ()
    apart -> do
      let folder = ".stack-work/golden"
      createDirectoryIfMissing True folder
      Lazy.writeFile (folder </> name <.> "got.png") (encode drawn)
      Lazy.writeFile (folder </> name <.> "difference.png") (encode (contrast drawn wanted))
      expectationFailure (golden <> ": " <> show apart <> "; see " <> folder)

-- | Where two pictures of one size differ, in white.
contrast :: Picture -> Picture -> Picture
contrast a b = picture (pictureWidth a) (Storable.generate (Storable.length (pictureBytes a)) channel)
  where
    channel i
      | i `mod` 4 == 3 || differs (i - i `mod` 4) = 255
      | otherwise = 0
    differs i = Storable.slice i 4 (pictureBytes a) /= Storable.take 4 (Storable.drop i (pictureBytes b))
