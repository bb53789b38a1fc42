-- | Pictures and their differences: an example, and the laws.
module Dioptre.PictureSpec (spec) where

import qualified Data.Vector.Storable as Storable
import Dioptre.Picture
import Laws.Picture
import Test.Hspec
import Test.Hspec.QuickCheck (prop)

spec :: Spec
spec = do
  describe "picture" $ prop "has the rows that its bytes fill" picturesKeepWholeRows

  describe "difference" $ do
    it "counts pixels, not channels, and alpha too" $
      difference (picture 2 (Storable.fromList (replicate 24 9))) (picture 2 (Storable.fromList (replicate 12 9 ++ [9, 9, 9, 8] ++ [1, 2, 30, 9] ++ replicate 4 9)))
        `shouldBe` PixelsDiffer 2 21 (1, 1)
    prop "of a picture and itself is none" noDifferenceFromItself
    prop "counts what was changed, the largest change and the first place" differenceIsCounted
    prop "is the same the other way round" differenceIsSymmetric
    prop "is that of the sizes where they differ" sizesDifferFirst
