{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_GHC -O2 #-}

-- | Rows: the laws, and the cost.
module Dioptre.Render.RowSpec (spec) where

import Control.Exception (evaluate)
import Data.Int (Int64)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Data.Version (Version (..))
import Dioptre.Load (loadSource, loadedPlan)
import Dioptre.Render.Row (Plan, Row (..), planHeight, planWidth, row)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Source.Language (Language (English))
import Dioptre.Source.Text (fromText)
import Laws.Rendering
import System.Info (compilerVersion)
import System.Mem (getAllocationCounter, setAllocationCounter)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage)

spec :: Spec
spec = do
  describe "window" $ do
    prop "has pixels and lies in the picture" windowsLieInThePicture
    prop "shows its part of the whole picture, pixel for pixel" windowsAreParts
  describe "row" $ do
    prop "has the pixels of the colours, with light and without" rowsAreColours
    -- Its bytes, four for each pixel, and what a row has once. Measured with GHC 9.0.2: 4.2 bytes.
    it "without light, allocates its bytes and nothing else" $
      bytesPerPixel (Text.replace "blinn" "no_light") >>= (`shouldSatisfy` (\bytes -> bytes >= 4 && bytes < 6 + wholeRays 1))
    -- Its bytes, and a number here and there. Measured with GHC 9.0.2: 17 bytes. A single ray would be 64 bytes.
    it "with light and shadows, allocates little for each pixel" $
      bytesPerPixel id >>= (`shouldSatisfy` (< 24 + wholeRays 5))
  describe "colourAt" $ modifyMaxSuccess (* 2) $ prop "is what a second ray tracer sees" (checkCoverage . coloursAreBruteForce)
  describe "plan" $ prop "has all the shapes of the scene" scenesAreUnderstood
  where
    -- GHC from 9.4 on made a ray where one of the shapes may want it whole; measured with GHC 9.6.6: 68 and 331 bytes.
    wholeRays n = if compilerVersion < Version [9, 4] [] then 0 else 64 * n

-- | Bytes allocated for each pixel of a plane with six spheres under two lights, in twenty rows of its picture, after a
-- change to the scene's text.
bytesPerPixel :: (Text -> Text) -> IO Double
bytesPerPixel change = do
  text <- Text.readFile "bench/six-spheres/scene.txt"
  loaded <- loadSource English (fromText "scene.txt" (change text))
  let p = loadedPlan loaded
      ys = [0, planHeight p `div` 20 .. planHeight p - 1]
  -- The first time the world is made
  _ <- evaluate (raysOf p ys)
  setAllocationCounter maxBound
  _ <- evaluate (raysOf p (map (+ 1) ys))
  used <- (maxBound -) <$> getAllocationCounter
  pure (fromIntegral (used :: Int64) / fromIntegral (length ys * planWidth p))

-- | How many rays some rows took.
raysOf :: Plan -> [Int] -> Int
raysOf p = sum . map (tallyRays . rowTally . row p)
{-# NOINLINE raysOf #-}
