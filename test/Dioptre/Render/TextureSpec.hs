-- | Pictures on surfaces: which pixel it is, and what is made of its bytes.
module Dioptre.Render.TextureSpec (spec) where

import Data.Foldable (for_)
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Picture (Picture, picture)
import Dioptre.Render.Texture (Texture (..), Upward (..), texel)
import Linear.V2 (V2 (..))
import Test.Hspec

spec :: Spec
spec = do
  describe "the pixel at texture coordinates" $ do
    -- trunc (4 u), after the wrap
    for_ [(0, 0), (0.24, 0), (0.25, 1), (0.49, 1), (0.5, 2), (0.74, 2), (0.75, 3), (0.999999, 3), (1, 4)] $ \(u, column) ->
      it ("is column " <> show column <> " of 5 at u = " <> show u) $ place (texel board (V2 u 0)) `shouldBe` (column, 0)
    for_ [(1.25, 1), (1.999, 3), (2, 4), (5, 4), (7.5, 2), (-0.25, 3), (-0.01, 3), (-0.75, 1), (-1, 0), (-3, 0), (-2.5, 2)] $ \(u, column) ->
      it ("is column " <> show column <> " of 5 at u = " <> show u <> ", the picture repeating") $ place (texel board (V2 u 0)) `shouldBe` (column, 0)
    -- trunc (2 v), down from the first row
    for_ [(0, 0), (0.49, 0), (0.5, 1), (0.99, 1), (1, 2), (1.5, 1), (-0.25, 1), (-0.75, 0)] $ \(v, row) ->
      it ("is row " <> show row <> " of 3 at v = " <> show v) $ place (texel board (V2 0 v)) `shouldBe` (0, row)
    -- Upwards from the last row, 1 - v is looked up: trunc (2 (1 - v))
    for_ [(0, 2), (0.01, 1), (0.49, 1), (0.5, 1), (0.51, 0), (1, 0), (1.25, 1), (-0.25, 0), (-0.75, 1)] $ \(v, row) ->
      it ("is row " <> show row <> " of 3 at v = " <> show v <> ", where v runs up") $ place (texel upwards (V2 0 v)) `shouldBe` (0, row)
    it "is in the same column, where v runs up" $ [place (texel upwards (V2 u 0)) | u <- [0, 0.3, 1, -0.25]] `shouldBe` [(0, 2), (1, 2), (4, 2), (3, 2)]
    it "is in column and row at once" $ place (texel board (V2 0.75 0.5)) `shouldBe` (3, 1)
    it "is the only one of a picture of one pixel" $
      [texel (dot' 9 9 9 9) (V2 u v) | u <- [0, 0.3, 1, -7.5], v <- [0, 1, 2.5]] `shouldSatisfy` all (== texel (dot' 9 9 9 9) (V2 0 0))
    it "is in the picture, however large the coordinates are" $
      [place (texel way (V2 u v)) | way <- [board, upwards], u <- huge, v <- huge] `shouldSatisfy` all (\(x, y) -> 0 <= x && x <= 4 && 0 <= y && y <= 2)

  describe "the colour of a pixel" $ do
    -- The nearest binary32 numbers, from the digits of k / 255
    for_ [(0, 0), (1, 0.003921568859368563), (51, 0.20000000298023224), (127, 0.49803921580314636), (128, 0.501960813999176), (254, 0.9960784316062927), (255, 1)] $ \(byte, channel) ->
      it ("has a channel of " <> show channel <> " for the byte " <> show byte) $
        texel (dot' byte 0 0 255) (V2 0 0) `shouldBe` Colour channel 0 0 1
    it "has the channels in their order" $ texel (dot' 255 0 51 255) (V2 0 0) `shouldBe` Colour 1 0 0.20000000298023224 1
    it "leaves alpha out" $ [texel (dot' 255 0 255 a) (V2 0 0) | a <- [0, 128, 255]] `shouldBe` replicate 3 (Colour 1 0 1 1)
  where
    huge = [1e17, -1e17, 1e100, -1e100, 1e-300, -1e-300]
    dot' r g b a = Texture FromFirstRow (picture 1 (Storable.fromList [r, g, b, a]))

-- | Five columns and three rows; red is 51 times the column, green 51 times the row.
board, upwards :: Texture
board = Texture FromFirstRow numbers
upwards = Texture FromLastRow numbers

numbers :: Picture
numbers = picture 5 (Storable.fromList (concat [[51 * x, 51 * y, 7, 255 - x] | y <- [0 .. 2], x <- [0 .. 4 :: Word8]]))

-- | Which column and row a colour of the board is from.
place :: Colour -> (Int, Int)
place (Colour r g _ _) = (round (5 * r), round (5 * g))
