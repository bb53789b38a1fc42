-- |
-- Module      : Laws.Picture
-- Description : What is true of bytes, pictures and their files
module Laws.Picture
  ( -- * Bytes
    Channel (..),
    levelIsExact,
    levelsAscend,
    pixelIsLevels,
    clampKeepsTheRest,
    divisionKeepsRatios,

    -- * Pictures
    Drawn (..),
    decodesToItself,
    isWrittenAsRgba,
    rowsAreWrittenAsThePicture,
    picturesKeepWholeRows,
    noDifferenceFromItself,
    differenceIsCounted,
    differenceIsSymmetric,
    sizesDifferFirst,
  )
where

import Control.Monad (forM)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.IORef (modifyIORef, newIORef, readIORef)
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)
import Dioptre.Light.Colour (Colour (..))
import Dioptre.Picture
import Dioptre.Picture.Byte
import Dioptre.Picture.Png (decode, encode, encodeRows)
import Dioptre.Scene.Raytracer (ColourNormalization (..))
import GHC.Float (castFloatToWord32, castWord32ToFloat, float2Double)
import Laws.Draw
import Laws.Exact
import Test.QuickCheck
import Test.QuickCheck.Monadic (monadicIO, run)

-------------------------------------------------------------------------------
-- Bytes

-- | An amount of light: anything, and above all what lies next to where one level becomes another, in binary32 and in
-- binary64.
newtype Channel = Channel Double
  deriving (Eq, Show)

instance Arbitrary Channel where
  arbitrary =
    Channel
      <$> frequency
        [ (6, edge),
          (3, fraction),
          (1, number Wide),
          (1, elements [-0.0, 0, 1, 1 + 2 ** (-52), 1 - 2 ** (-53), 1 - 2 ** (-25), 1 - 2 ** (-26), 5e-324, 1e-46, -1e-9, 1e300, 1 / 0, -1 / 0])
        ]
    where
      edge = do
        k <- chooseInt (0, 255)
        steps <- chooseInt (-40, 40)
        ulps <- oneof [chooseInt (-3, 3), chooseInt (-3, 3) >>= \n -> pure (n + 2 ^ (28 :: Int)), chooseInt (-3, 3) >>= \n -> pure (n - 2 ^ (28 :: Int))]
        let float = fromRational ((fromIntegral k + 1 / 2) / 255) :: Float
        -- 2^28 doubles are half the distance between two binary32 numbers.
        pure (nudged ulps (float2Double (castWord32ToFloat (castFloatToWord32 float + fromIntegral steps))))

-- | The level of a channel from 0 to 1 is its nearest binary32, times 255, to the nearest binary32 again, plus 1\/2,
-- rounded down; a channel below 0 gives 0, and one above 1 gives 255.
--
-- The second opinion rounds rational numbers, to even where two are as near.
levelIsExact :: Channel -> Property
levelIsExact (Channel c) = level c === expected
  where
    expected
      | c <= 0 = 0
      | c > 1 = 255
      | otherwise = fromInteger (floor (single (255 * single (toRational c)) + 1 / 2))

-- | The nearest binary32 of a number that is at least 0 and far from the largest; of two that are as near, the even
-- one ('round' does that).
single :: Rational -> Rational
single x
  | x == 0 = 0
  | otherwise = fromInteger (round (x / unit)) * unit
  where
    unit = 2 ^^ max (-149) (exponent' - 23)
    -- 2^exponent' <= x < 2^(exponent' + 1)
    exponent' = head' [e | e <- [150, 149 ..], 2 ^^ e <= x || e <= -160] :: Int
    head' xs = case xs of
      e : _ -> e
      [] -> 0

-- | More light never makes a darker byte.
levelsAscend :: Channel -> Channel -> Property
levelsAscend (Channel a) (Channel b) = level (min a b) <= level (max a b) .&&. conjoin [level a <= level (nudged n a) | a > 0, a < 2, n <- [1, 2]]

-- | A pixel is the levels of the normalized colour's channels, in the order red, green, blue, alpha.
pixelIsLevels :: Property
pixelIsLevels = forAll ((,) <$> arbitraryBoundedEnum' <*> anyColour) $ \(how, c) ->
  let Colour r g b a = normalized how c
   in pixelOf how c === Pixel (level r) (level g) (level b) (level a)
  where
    arbitraryBoundedEnum' = elements [ClampChannel, DivisionFactor]

-- | Cutting channels to 1 leaves the others as they are, alpha included.
clampKeepsTheRest :: Property
clampKeepsTheRest = forAll anyColour $ \c@(Colour r g b a) ->
  counterexample (show c) $ normalized ClampChannel c === Colour (min 1 r) (min 1 g) (min 1 b) (min 1 a)

-- | Dividing by the largest channel makes that one 1 and keeps the ratios, each channel rounded once; it changes
-- nothing if no channel is above 1. Alpha is cut.
divisionKeepsRatios :: Property
divisionKeepsRatios = forAll anyColour $ \(Colour r g b a) ->
  let Colour r' g' b' a' = normalized DivisionFactor (Colour r g b a)
      m = maximum [1, r, g, b]
      near x x' = counterexample (show (x, x')) (abs (toRational x' * toRational m - toRational x) <= eps * toRational x)
   in conjoin (zipWith near [r, g, b] [r', g', b']) .&&. (m == 1 || 1 `elem` [r', g', b']) .&&. a' === min 1 a

-- | A colour, often brighter than 1.
anyColour :: Gen Colour
anyColour = Colour <$> channel <*> channel <*> channel <*> oneof [fraction, pure 1, channel]
  where
    channel = oneof [fraction, abs <$> number Full, abs <$> number Wide]

-------------------------------------------------------------------------------
-- Pictures

-- | A picture of random bytes: of one colour, or of few, or of all.
newtype Drawn = Drawn Picture
  deriving (Eq, Show)

instance Arbitrary Drawn where
  arbitrary = do
    w <- chooseInt (1, 20)
    h <- chooseInt (1, 20)
    palette <- oneof [pure [0], pure [0, 255], pure [minBound .. maxBound]]
    Drawn . picture w . Storable.fromList <$> vectorOf (4 * w * h) (elements palette)

-- | A picture that is written as PNG and read again is the picture.
decodesToItself :: Drawn -> Property
decodesToItself (Drawn p) = decode (Lazy.toStrict (encode p)) === Right p

-- | A PNG begins with its signature and a header (IHDR, 13 bytes): width and height, 8 bits a channel, colour type 6
-- (red, green, blue, alpha), compression, filter and interlace methods 0. Its last chunk is an empty IEND. Source:
-- the PNG specification, sections 5.2 and 11.2.
isWrittenAsRgba :: Drawn -> Property
isWrittenAsRgba (Drawn p) = Bytes.take 29 file === expected .&&. Bytes.take 8 (Bytes.drop (Bytes.length file - 12) file) === Bytes.pack ([0, 0, 0, 0] ++ ascii "IEND")
  where
    file = Lazy.toStrict (encode p)
    expected = Bytes.pack ([137, 80, 78, 71, 13, 10, 26, 10] ++ [0, 0, 0, 13] ++ ascii "IHDR" ++ word (pictureWidth p) ++ word (pictureHeight p) ++ [8, 6, 0, 0, 0])
    ascii = map (fromIntegral . fromEnum)
    word n = [0, 0, 0, fromIntegral n]

-- | A file made of rows has the header of one made of their picture, and is read as that picture: with the smallest
-- files, and with those of more bytes than zlib gives at once, which noise takes.
rowsAreWrittenAsThePicture :: Property
rowsAreWrittenAsThePicture = forAllBlind (oneof [arbitrary, Drawn <$> noise]) $ \(Drawn p) -> monadicIO $ do
  pieces <- run (newIORef [])
  rows <- run $ encodeRows (pictureWidth p) (pictureHeight p) (forM (rowsOf p)) (\bytes -> modifyIORef pieces (bytes :))
  file <- run (Bytes.concat . reverse <$> readIORef pieces)
  pure . counterexample (show (pictureWidth p, pictureHeight p)) $ (decode file == Right p) .&&. Bytes.take 33 file === Bytes.take 33 (Lazy.toStrict (encode p)) .&&. length rows === pictureHeight p
  where
    rowsOf p = [Storable.slice (4 * pictureWidth p * y) (4 * pictureWidth p) (pictureBytes p) | y <- [0 .. pictureHeight p - 1]]
    noise = do
      w <- chooseInt (50, 150)
      h <- chooseInt (50, 150)
      picture w . Storable.fromList <$> vectorOf (4 * w * h) arbitrary

-- | A picture has as many rows as its bytes fill, and keeps no others; a width below 1 is 1.
picturesKeepWholeRows :: Property
picturesKeepWholeRows = forAll ((,) <$> chooseInt (-2, 9) <*> (chooseInt (0, 300) >>= \n -> vectorOf n arbitrary)) $ \(w, bytes) ->
  let p = picture w (Storable.fromList bytes)
      width = max 1 w
      rows = length bytes `div` (4 * width)
   in (pictureWidth p, pictureHeight p, Storable.toList (pictureBytes p)) === (width, rows, take (rows * width * 4) bytes)

-- | A picture does not differ from itself.
noDifferenceFromItself :: Drawn -> Property
noDifferenceFromItself (Drawn p) = difference p (picture (pictureWidth p) (Storable.fromList (Storable.toList (pictureBytes p)))) === Equal

-- | The pixels that were changed are counted, the largest change is found, and the first changed pixel, row by row.
differenceIsCounted :: Drawn -> Property
differenceIsCounted (Drawn p) = forAll (listOf1 ((,) <$> chooseInt (0, bytes - 1) <*> arbitrary)) $ \changes ->
  let changed = Storable.toList (pictureBytes p Storable.// changes)
      pixels xs = if null xs then [] else take 4 xs : pixels (drop 4 xs)
      apart = [maximum (zipWith away x y) | (x, y) <- zip (pixels (Storable.toList (pictureBytes p))) (pixels changed)]
      expected = case [i | (i, k) <- zip [0 ..] apart, k > 0] of
        [] -> Equal
        i : rest -> PixelsDiffer (1 + length rest) (maximum apart) (i `mod` pictureWidth p, i `div` pictureWidth p)
   in difference p (picture (pictureWidth p) (Storable.fromList changed)) === expected
  where
    bytes = 4 * pictureWidth p * pictureHeight p
    away :: Word8 -> Word8 -> Int
    away x y = fromIntegral (max x y - min x y)

-- | The difference is the same the other way round.
differenceIsSymmetric :: Drawn -> Drawn -> Property
differenceIsSymmetric (Drawn p) (Drawn q) = flipped (difference p q) === difference q p
  where
    flipped d = case d of
      SizesDiffer a b -> SizesDiffer b a
      other -> other

-- | Pictures of different sizes differ in their sizes, even if they have the same bytes.
sizesDifferFirst :: Drawn -> Property
sizesDifferFirst (Drawn p) = w /= h ==> difference p (picture h (pictureBytes p)) === SizesDiffer (w, h) (h, w)
  where
    w = pictureWidth p
    h = pictureHeight p
