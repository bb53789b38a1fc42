{-# LANGUAGE BangPatterns #-}

-- |
-- Module      : Main
-- Description : The differential test at length, and the worst errors of each shape
--
-- > errors [--rays N] [--scene-rays N] [--seed S]
--
-- What the tests do with some thousand rays this program does with as many as one likes, and it says how far the
-- parameters were off. --rays (100000) are aimed at shapes of all sorts, in the two manners of "Laws.Exactness", and
-- compared with the obvious implementation; --scene-rays (1000000) are sent through scenes with an index and compared
-- with the plain list. The same seed (1) gives the same rays. Ends with exit code 1 if anything disagreed.
--
-- For each shape it prints how many parameters there were, those among them that are near a rim or a tangent and not
-- measured, the median of the relative errors, and the worst; then, for each of the worst, the shape and the ray.
module Main
  ( main,
  )
where

import Control.Exception (evaluate)
import Control.Monad (foldM, forM, forM_, unless)
import qualified Data.IntMap.Strict as IntMap
import Data.List (foldl', intercalate)
import Data.Maybe (fromMaybe, isJust)
import Laws.Exactness
import System.Environment (getArgs)
import System.Exit (exitFailure)
import System.IO (BufferMode (..), hSetBuffering, stdout)
import Test.QuickCheck.Gen (Gen (..), infiniteListOf, vectorOf)
import Test.QuickCheck.Random (mkQCGen)
import Text.Printf (printf)
import Text.Read (readMaybe)

main :: IO ()
main = do
  hSetBuffering stdout LineBuffering
  arguments <- options <$> getArgs
  let number name standard = fromMaybe standard (lookup name arguments >>= readMaybe) :: Int
      seed = number "--seed" 1
  shapes <- shapesCompared (number "--rays" 100000) seed
  scenes <- scenesCompared (number "--scene-rays" 1000000) seed
  unless (shapes && scenes) exitFailure

options :: [String] -> [(String, String)]
options (name : value : rest) = (name, value) : options rest
options _ = []

-- | The examples of a generator, one after the other: always the same ones for two numbers.
examples :: Int -> Int -> Gen a -> [a]
examples seed part g = unGen (infiniteListOf g) (mkQCGen (1000003 * seed + part)) 30

-------------------------------------------------------------------------------
-- Shapes

-- | What was found so far.
data Tally = Tally
  { rays, hits, others :: !Int,
    -- | How many errors there were of each size, in tenths of a power of two.
    sizes :: !(IntMap.IntMap Int),
    -- | The worst: of all, of those of an ordinary condition, and in units of the condition.
    worst, worstOrdinary, worstShare :: !(Maybe (Double, (Measured, Aimed)))
  }

-- | Parameters that are at most this sensitive count as ordinary.
ordinaryCondition :: Double
ordinaryCondition = 256

empty :: Tally
empty = Tally 0 0 0 IntMap.empty Nothing Nothing Nothing

count :: Comparison -> Aimed -> Tally -> Tally
count c aimed tally = foldl' add tally {rays = rays tally + 1, others = others tally + undecided c} (measured c)
  where
    add t m =
      t
        { hits = hits t + 1,
          sizes = IntMap.insertWith (+) (sizeOf (relativeError m)) 1 (sizes t),
          worst = larger (relativeError m) m (worst t),
          worstOrdinary = if condition m <= ordinaryCondition then larger (relativeError m) m (worstOrdinary t) else worstOrdinary t,
          worstShare = larger (relativeError m / condition m) m (worstShare t)
        }
    larger e m before = case before of
      Just (e', _) | e' >= e -> before
      _ -> Just (e, (m, aimed))
    sizeOf e = if e <= 0 then minBound else floor (10 * logBase 2 e)

-- | The error that so large a part of the errors does not exceed, to a fifteenth.
quantile :: Double -> Tally -> Double
quantile part t = go (part * fromIntegral (hits t)) (IntMap.toAscList (sizes t))
  where
    go _ [] = 0
    go left ((k, n) : more)
      | left <= fromIntegral n = if k == minBound then 0 else 2 ** (fromIntegral (k + 1) / 10)
      | otherwise = go (left - fromIntegral n) more

shapesCompared :: Int -> Int -> IO Bool
shapesCompared n seed = do
  putStrLn "Errors of parameters against exact ones, in units of 2^-53 of the parameter."
  putStrLn ("  worst (c <= " <> show (round ordinaryCondition :: Int) <> "): of those parameters whose condition c is at most that; per c: in units of the condition")
  printf "%-20s %-9s %9s %9s %9s %9s %9s %9s %11s %9s\n" "shape" "manner" "rays" "hits" "undecided" "median" "99 %" "worst" "(any c)" "per c"
  results <- forM (zip [(sort, manner) | sort <- [minBound ..], manner <- [Ordinary, Adverse]] [1 ..]) $ \((sort, manner), part) -> do
    (tally, wrong) <- foldM step (empty, 0 :: Int) (take (n `div` 28) (examples seed part (aimedAt manner sort)))
    printf "%-20s %-9s %9d %9d %9d %9.2f %9.1f %9.1f %11.3g %9.2f\n" (show sort) (show manner) (rays tally) (hits tally) (others tally) (quantile 0.5 tally) (quantile 0.99 tally) (size worstOrdinary tally) (size worst tally) (size worstShare tally)
    pure (tally, (sort, manner), wrong)
  forM_ results $ \(tally, name, _) -> do
    putStrLn ("\n" <> show name)
    forM_ [("worst, ordinary condition", worstOrdinary), ("worst", worst), ("worst per condition", worstShare)] $ \(title, what) -> case what tally of
      Nothing -> pure ()
      Just (_, (m, Aimed shape r)) -> putStrLn (intercalate "\n    " ["  " <> title <> ": " <> show m, show shape, show r])
  pure (sum [wrong | (_, _, wrong) <- results] == 0)
  where
    size what t = maybe 0 fst (what t)
    step (tally, wrong) aimed = do
      let c = compared aimed
          why = disagreement c
      forM_ why $ \text -> putStrLn ("DISAGREEMENT " <> text <> "\n    " <> show aimed)
      tally' <- evaluate (count c aimed tally)
      pure (tally', wrong + length why)

-------------------------------------------------------------------------------
-- Scenes

scenesCompared :: Int -> Int -> IO Bool
scenesCompared n seed = do
  results <- forM (zip [1 .. max 1 (n `div` each)] (cycle [Ordinary, Adverse])) $ \(i, manner) ->
    case take 1 (examples seed (100 + i) (scenery manner 40 >>= \s -> Crowd s <$> vectorOf each (rayIn manner s))) of
      [Crowd s through] -> do
        let answers = [(r, found s r, closestOfAll (sceneryPlain s) r) | r <- through]
            differing = [answer | answer@(_, index, plain) <- answers, index /= plain]
        forM_ (take 1 differing) $ \answer -> putStrLn ("DIFFERENCE " <> show answer <> "\n    " <> show (sceneryShapes s))
        -- At once, so that the scene can be forgotten.
        let !meeting = length (filter (\(_, index, _) -> isJust index) answers)
            !wrong = length differing
        pure (each, meeting, wrong)
      _ -> pure (0, 0, 0)
  let total part = sum (map part results)
  putStrLn ("\n" <> show (total (\(a, _, _) -> a)) <> " rays through " <> show (length results) <> " scenes of 40 shapes and more: " <> show (total (\(_, b, _) -> b)) <> " meet something; differing from the plain list: " <> show (total (\(_, _, c) -> c)))
  pure (total (\(_, _, c) -> c) == 0)
  where
    each = 2000
