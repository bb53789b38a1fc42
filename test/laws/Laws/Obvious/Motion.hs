-- |
-- Module      : Laws.Obvious.Motion
-- Description : Lines carried back by transformations, in rational numbers
--
-- The second implementation of scale, rotation and translation: one turn after the other, undone in the opposite order,
-- with sine and cosine by their power series.
module Laws.Obvious.Motion
  ( Line (..),
    lineOf,
    carriedBack,
    cosineAndSine,
  )
where

import Dioptre.Geometry.Ray (Ray, direction, origin)
import Dioptre.Math.Transform (Transform, transformRotation, transformScale, transformTranslation)
import Laws.Exact
import Linear.V3 (V3 (..))

-- | A ray's line in some frame. The blurs are the sizes of the numbers that were rounded on the way into the frame, by
-- which the program's own line may be off there: times a few 'eps'.
data Line = Line
  { lineOrigin :: Exact,
    lineDirection :: Exact,
    originBlur :: Rational,
    directionBlur :: Rational
  }
  deriving (Eq, Show)

-- | A ray as it is given.
lineOf :: Ray -> Line
lineOf r = Line (exact (origin r)) (exact (direction r)) 0 0

-- | The line in the frame in which a transformed shape is as it was.
carriedBack :: Transform -> Line -> Line
carriedBack t = \(Line o d bo bd) ->
  Line (back (o - shift)) (back d) ((magnitude (o - shift) + bo) * shrunk) ((magnitude d + bd) * shrunk)
  where
    shift = exact (transformTranslation t)
    V3 fx fy fz = exact (transformScale t)
    V3 (cx, sx) (cy, sy) (cz, sz) = cosineAndSine . toRational <$> transformRotation t
    shrunk = abs (1 / fx) + abs (1 / fy) + abs (1 / fz)
    back = unscaled . aboutX . aboutY . aboutZ
    aboutZ (V3 x y z) = V3 (cz * x + sz * y) (cz * y - sz * x) z
    aboutY (V3 x y z) = V3 (cy * x - sy * z) y (cy * z + sy * x)
    aboutX (V3 x y z) = V3 x (cx * y + sx * z) (cx * z - sx * y)
    unscaled (V3 x y z) = V3 (x / fx) (y / fy) (z / fz)

-- | Cosine and sine of an angle in degrees, to 2^-190; exact for multiples of 90.
cosineAndSine :: Rational -> (Rational, Rational)
cosineAndSine degrees = case quarters `mod` 4 of
  0 -> (c, s)
  1 -> (negate s, c)
  2 -> (negate c, negate s)
  _ -> (s, negate c)
  where
    quarters = round (degrees / 90) :: Integer
    x = cut ((degrees - 90 * fromInteger quarters) * circle / 180)
    c = series 1 1
    s = series 2 x
    -- From the term of the power k - 1 on.
    series k term
      | term == 0 = 0
      | otherwise = term + series (k + 2) (cut (negate term * x * x / (k * (k + 1))))

-- | Pi, by Machin's formula.
circle :: Rational
circle = 16 * arctangent 5 - 4 * arctangent 239
  where
    arctangent n = sum (takeWhile ((> 1 / 2 ^ (220 :: Int)) . abs) [(-1) ^ k / (fromInteger (2 * k + 1) * n ^ (2 * k + 1)) | k <- [0 :: Integer ..]])

-- | Without the digits behind 2^-200.
cut :: Rational -> Rational
cut y = fromInteger (round (y * 2 ^ (200 :: Int))) / 2 ^ (200 :: Int)
