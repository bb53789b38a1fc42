-- | Rows: the laws.
module Dioptre.Render.RowSpec (spec) where

import Laws.Rendering
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage)

spec :: Spec
spec = do
  describe "window" $ do
    prop "has pixels and lies in the picture" windowsLieInThePicture
    prop "shows its part of the whole picture, pixel for pixel" windowsAreParts
  describe "row" $ prop "has the pixels of the colours, with light and without" rowsAreColours
  describe "colourAt" $ modifyMaxSuccess (* 2) $ prop "is what a second ray tracer sees" (checkCoverage . coloursAreBruteForce)
  describe "plan" $ prop "has all the shapes of the scene" scenesAreUnderstood
