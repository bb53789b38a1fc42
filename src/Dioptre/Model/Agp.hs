{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Agp
-- Description : Strokes drawn as tubes
--
-- An AGP file holds curves, each as a list of points: a line of all their x, then one of all their y, then one of all
-- their z.
--
-- > curve 1                   a line that begins with no number says nothing
-- > 0,0  1,0  1,5             x
-- > 0,0  0,0  0,5             y         (0, 0, 0) === (1, 0, 0) === (1.5, 0.5, 1)
-- > 0,0  0,0  1,0             z
--
-- Numbers may have a decimal comma, and are separated by blanks. From each point to the next leads a tube; all have one
-- radius and one colour.
--
-- > file  = *(other / curve)
-- > curve = row row row            ; of equally many numbers; the first one begins with a number
-- > row   = real *(1*blank real)   ; a comma may stand for the point
--
-- A line that begins like a number is taken for a row that is meant as one, so that what follows a curve with a slip in
-- it keeps its place.
module Dioptre.Model.Agp
  ( readAgp,
    tubeRadius,
  )
where

import Data.Bifunctor (first)
import Data.Char (isDigit)
import Data.Either (partitionEithers)
import Data.Foldable (toList)
import Data.List (sortOn)
import Data.List.NonEmpty (NonEmpty (..), nonEmpty)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Maybe (listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Dioptre.Geometry.Axis (axis, roundShape)
import Dioptre.Geometry.Shape (Shape (ATube))
import Dioptre.Light.Colour (rgb)
import Dioptre.Light.Finish (finish)
import Dioptre.Light.Material (Material (..), standard)
import Dioptre.Math.Vector (Point)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Source.Diagnostic (CurveFlaw (..), Diagnostic (..), Problem (..), Refusal (..))
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, sourceText)
import Dioptre.Source.Words (Token (..), isBlank, wordsOf)
import Dioptre.Syntax.Value (real)
import Linear.V3 (V3 (..))

-- | The radius of the tubes.
--
-- Spec: models.agp.
tubeRadius :: Double
tubeRadius = 0.1

-- | The tubes that a file describes, all of one finish, and what is wrong with it, in its order. Total, linear.
--
-- Spec: models.agp, models.agp.faults.
readAgp :: Source -> (Content nested Text, [Diagnostic])
readAgp source = (Content (mapMaybe solid pieces) (Vector.singleton (finish paint)), sortOn diagnosticSpan (broken <> pointless))
  where
    (broken, curves) = partitionEithers (curvesOf (rowsOf source))
    pieces = concatMap (\points -> zip points (drop 1 points)) curves
    solid ((_, p), (_, q)) = (`Solid` 0) . ATube <$> (axis p q >>= (`roundShape` tubeRadius))
    idle = [place | ((_, p), (place, q)) <- pieces, p == q]
    pointless = [Diagnostic place (PiecesWithoutLength (length idle)) | Just place <- [listToMaybe idle]]
    paint = standard {materialColour = rgb 0.8 0.8 0.2}

-- | The words of a line.
type Row = NonEmpty Token

-- | A point of a curve, and where its x stands.
type Located = (Span, Point)

-- | The lines of a file that have words.
rowsOf :: Source -> [Row]
rowsOf source = mapMaybe nonEmpty (zipWith (wordsOf isBlank) [1 ..] (Text.split (== '\n') (sourceText source)))

-- | file = *(other \/ curve)
curvesOf :: [Row] -> [Either Diagnostic [Located]]
curvesOf rows = case dropWhile (not . beginsCurve) rows of
  [] -> []
  x : rest -> case takeWhile isMeantAsRow (take 2 rest) of
    [y, z] -> curve x y z : curvesOf (drop 2 rest)
    some -> Left (about x (RowsMissing (2 - length some))) : curvesOf (drop (length some) rest)
  where
    beginsCurve (Token _ word :| _) = case number word of
      Right _ -> True
      Left (TooLarge _) -> True
      Left _ -> False
    isMeantAsRow (Token _ word :| _) = Text.any (\c -> isDigit c || c `elem` ("+-.," :: String)) (Text.take 1 word)

-- | curve = row row row
--
-- Spec: models.agp.faults.
curve :: Row -> Row -> Row -> Either Diagnostic [Located]
curve xs ys zs = zip (map tokenSpan (toList xs)) <$> (zipWith3 V3 <$> numbers xs <*> (numbers ys <* alike ys) <*> (numbers zs <* alike zs))
  where
    numbers = fmap toList . traverse (\token -> first (Diagnostic (tokenSpan token) . BrokenCurve . RowRefused) (number (tokenText token)))
    alike row = if length row == length xs then Right () else Left (about row (RowsDiffer (length row) (length xs)))

-- | A real number, with a decimal point or a decimal comma.
number :: Text -> Either Refusal Double
number word = first asWritten (real (Text.replace "," "." word))
  where
    asWritten = \case
      NotANumber _ -> NotANumber word
      TooLarge _ -> TooLarge word
      other -> other

-- | What is wrong with a row as a whole.
about :: Row -> CurveFlaw -> Diagnostic
about row = Diagnostic (Span line start end) . BrokenCurve
  where
    Span line start _ = tokenSpan (NonEmpty.head row)
    Span _ _ end = tokenSpan (NonEmpty.last row)
