-- | Pictures that are known to be right, against those that the program draws now.
--
-- test/golden holds the two pictures of the handout's introduction: equal, every byte. docs/pictures holds the gallery,
-- drawn by docs/make-pictures; sines and powers may round differently from one machine's library to another's, so a
-- channel may differ by one level there. A picture that differs is written to .stack-work/golden, with the one that is
-- wanted and one of the differences; nothing here rewrites what is checked in.
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
import System.Directory (createDirectoryIfMissing, listDirectory, removePathForcibly)
import System.FilePath (dropExtension, (<.>), (</>))
import System.IO.Temp (withSystemTempDirectory)
import Test.Hspec (Spec, describe, expectationFailure, it, runIO, shouldBe, shouldReturn)

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
  it "leaves what was drawn, what is wanted, and where they differ" . withSystemTempDirectory "golden" $ \folder -> do
    let grey = picture 2 (Storable.replicate 24 100)
        darker = picture 2 (Storable.replicate 12 100 <> Storable.fromList [90, 90, 90, 100] <> Storable.replicate 8 100)
        small = picture 1 (Storable.replicate 4 100)
        read' file = Bytes.readFile (folder </> file) >>= either (fail . show) pure . decode
    leave folder "a" darker grey
    traverse read' ["a.got.png", "a.want.png", "a.difference.png"]
      `shouldReturn` [darker, grey, picture 2 (Storable.fromList (cycled 12 [0, 0, 0, 255] <> replicate 4 255 <> cycled 8 [0, 0, 0, 255]))]
    -- Where the sizes differ no picture can show it; and none is left of another time.
    leave folder "a" grey small
    traverse read' ["a.got.png", "a.want.png"] `shouldReturn` [grey, small]
    sort <$> listDirectory folder `shouldReturn` ["a.got.png", "a.want.png"]
  where
    cycled n = take n . cycle

-- | Draws a scene and compares it with a picture, whose channels may differ by so many levels.
matches :: Int -> FilePath -> String -> IO ()
matches slack golden name = do
  wanted <- either (fail . show) pure . decode =<< Bytes.readFile golden
  drawn <- drawnOrLoaded English ("scenes" </> name <.> "txt") >>= either (fail . show) (pure . fst)
  case difference drawn wanted of
    Equal -> pure ()
    PixelsDiffer _ most _ | most <= slack -> pure ()
    apart -> do
      leave folder name drawn wanted
      expectationFailure (golden <> ": " <> show apart <> "; see " <> folder)
  where
    folder = ".stack-work/golden"

-- | Writes what was drawn, what is wanted and, where they have one size, how they differ, to a folder.
leave :: FilePath -> String -> Picture -> Picture -> IO ()
leave folder name drawn wanted = do
  createDirectoryIfMissing True folder
  written "got" drawn
  written "want" wanted
  case difference drawn wanted of
    SizesDiffer _ _ -> removePathForcibly (file "difference")
    _ -> written "difference" (contrast drawn wanted)
  where
    file what = folder </> name <.> what <.> "png"
    written what = Lazy.writeFile (file what) . encode

-- | Where two pictures of one size differ, in white.
contrast :: Picture -> Picture -> Picture
contrast a b = picture (pictureWidth a) (Storable.generate (Storable.length (pictureBytes a)) channel)
  where
    channel i
      | i `mod` 4 == 3 || differs (i - i `mod` 4) = 255
      | otherwise = 0
    differs i = Storable.slice i 4 (pictureBytes a) /= Storable.slice i 4 (pictureBytes b)
