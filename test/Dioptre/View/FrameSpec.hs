-- | A picture in the making comes to be the picture.
module Dioptre.View.FrameSpec (spec) where

import Control.Concurrent (threadDelay)
import Control.Concurrent.Async (wait, withAsync)
import Control.Concurrent.STM (atomically, check, newTVarIO, readTVar, readTVarIO, writeTVar)
import Control.Exception (evaluate)
import qualified Data.ByteString as Bytes
import Data.Foldable (for_, toList)
import Data.List (isPrefixOf, sort)
import qualified Data.Vector.Storable as Storable
import Dioptre.Load (Loaded, loadScene)
import Dioptre.Picture (pictureBytes, pictureWidth)
import Dioptre.Render (renderWith, rendered)
import Dioptre.Render.Row (planHeight, planWidth)
import Dioptre.Source.Language (Language (English))
import Dioptre.View.Frame
import Test.Hspec

spec :: Spec
spec = for_ ["scenes/glass.txt", "scenes/antialiasing.txt", "scenes/plane.txt"] $ \path -> describe ("the frame of " <> path) . beforeAll (painted path) $ do
  it "is the picture that is rendered" $ \frame -> do
    image <- framePicture frame
    image `shouldBe` rendered (framePlan frame)
  it "has every strip once, the coarse ones first" $ \frame -> do
    progress <- readTVarIO (frameProgress frame)
    let strips = toList (progressStrips progress)
        coarse = [k | Coarse k <- strips]
        fine = [y | Fine y <- strips]
    strips `shouldSatisfy` (map Coarse coarse `isPrefixOf`)
    sort coarse `shouldBe` [0 .. (planHeight (framePlan frame) + 7) `div` 8 - 1]
    sort fine `shouldBe` [0 .. planHeight (framePlan frame) - 1]
    progressRows progress `shouldBe` planHeight (framePlan frame)
    progressEnd progress `shouldBe` Finished
  it "has counted its rays" $ \frame -> do
    progress <- readTVarIO (frameProgress frame)
    (_, tally) <- renderWith 1 (pure ()) (framePlan frame)
    progressTally progress `shouldBe` tally
  it "is not seen to be finished before what is to be done then is done" $ \frame -> do
    again <- newFrame 2 1 (frameLoaded frame)
    gate <- newTVarIO False
    withAsync (paint 2 (readTVar gate >>= check) again) $ \painting -> do
      atomically (readTVar (frameProgress again) >>= check . (== planHeight (framePlan again)) . progressRows)
      threadDelay 50000
      closed <- readTVarIO (frameProgress again)
      atomically (writeTVar gate True)
      wait painting
      opened <- readTVarIO (frameProgress again)
      (progressEnd closed, progressEnd opened) `shouldBe` (Going, Finished)
  it "shows of each block of 8 x 8 the pixel at (4, 4), or the last there is" $ \frame -> do
    image <- framePicture frame
    let width = planWidth (framePlan frame)
        height = planHeight (framePlan frame)
        pixel x y = Storable.toList (Storable.slice (4 * (y * pictureWidth image + x)) 4 (pictureBytes image))
    for_ [0, 3, (height + 7) `div` 8 - 1] $ \k -> do
      bytes <- stripBytes frame (Coarse k)
      Bytes.unpack bytes `shouldBe` concat [pixel (min (8 * j + 4) (width - 1)) (min (8 * k + 4) (height - 1)) | j <- [0 .. (width + 7) `div` 8 - 1]]
  it "gives each row's bytes" $ \frame -> do
    image <- framePicture frame
    bytes <- stripBytes frame (Fine 5)
    Bytes.unpack bytes `shouldBe` Storable.toList (Storable.slice (4 * 5 * pictureWidth image) (4 * pictureWidth image) (pictureBytes image))

-- | The frame of a scene, painted by two workers.
painted :: FilePath -> IO Frame
painted path = do
  loaded <- loadScene English path >>= either (fail . show) evaluate
  frame <- newFrame 1 1 (loaded :: Loaded)
  frame <$ paint 2 (pure ()) frame
