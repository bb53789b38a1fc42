{-# LANGUAGE LambdaCase #-}

-- |
-- Module      : Main
-- Description : A long run of the fuzzing harness
--
-- > fuzz [--seed N] [--seconds S | --inputs N] [--target KIND]... [--replay FILE]...
--
-- Makes inputs of every kind in turn (of some kinds, by their file endings: @--target txt --target obj@), tries each,
-- and keeps those that fail, shrunk, in test/fuzz/cases. Runs in the project's folder. Ends with exit code 1 if any
-- failed. With @--replay@, tries the inputs in these files instead.
--
-- An input that neither ends nor can be interrupted is written to test/fuzz/cases too, and ends the run with exit code
-- 2.
module Main
  ( main,
  )
where

import Control.Concurrent (forkOn, threadDelay)
import Control.Monad (forever, unless, when)
import qualified Data.ByteString as Bytes
import Data.IORef (IORef, atomicModifyIORef', newIORef, readIORef, writeIORef)
import Data.List (sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Text (Text)
import qualified Data.Text as Text
import Fuzz.Corpus (Corpus, casesFolder, readCorpus)
import Fuzz.Kind (Kind, extension, kindName, kindNamed, kindOf)
import Fuzz.Session
import Fuzz.Target (failureName, trial)
import GHC.Clock (getMonotonicTime)
import GHC.Conc (setNumCapabilities)
import System.Directory (createDirectoryIfMissing)
import System.Environment (getArgs)
import System.Exit (ExitCode (..), exitWith)
import System.FilePath ((</>))
import System.IO (BufferMode (LineBuffering), hPutStrLn, hSetBuffering, stderr, stdout)
import System.Posix.Process (exitImmediately)
import Text.Read (readMaybe)

-- | What to do.
data Wish = Wish
  { wishSeed :: Int,
    wishSeconds :: Double,
    -- | Of all kinds together.
    wishInputs :: Int,
    wishKinds :: [Kind],
    wishReplays :: [FilePath]
  }

main :: IO ()
main = do
  hSetBuffering stdout LineBuffering
  arguments <- getArgs
  case wishes (Wish 1 (1 / 0) maxBound [] []) arguments of
    Nothing -> hPutStrLn stderr "usage: fuzz [--seed N] [--seconds S | --inputs N] [--target KIND]... [--replay FILE]..." >> exitWith (ExitFailure 2)
    Just wish
      | null (wishReplays wish) -> session wish {wishKinds = if null (wishKinds wish) then [minBound ..] else wishKinds wish}
      | otherwise -> replays (wishReplays wish)

wishes :: Wish -> [String] -> Maybe Wish
wishes wish arguments = case arguments of
  [] -> Just wish
  "--seed" : n : rest | Just seed <- readMaybe n -> wishes wish {wishSeed = seed} rest
  "--seconds" : n : rest | Just s <- readMaybe n -> wishes wish {wishSeconds = s} rest
  "--inputs" : n : rest | Just k <- readMaybe n -> wishes wish {wishInputs = k} rest
  "--target" : name : rest | Just kind <- kindNamed name -> wishes wish {wishKinds = wishKinds wish <> [kind]} rest
  "--replay" : path : rest -> wishes wish {wishReplays = wishReplays wish <> [path]} rest
  _ -> Nothing

-- | Tries files.
replays :: [FilePath] -> IO ()
replays paths = do
  results <- traverse replay paths
  when (or results) $ exitWith (ExitFailure 1)
  where
    replay path = case kindOf path of
      Nothing -> True <$ putStrLn (path <> ": of no kind")
      Just kind -> do
        failure <- Bytes.readFile path >>= trial kind
        True <$ putStrLn (path <> ": " <> maybe "holds" show failure)

-- | What the watch knows: what is being tried, and since when.
type Watch = IORef (Maybe (Double, Try))

session :: Wish -> IO ()
session wish = do
  corpus <- readCorpus
  watch <- newIORef Nothing
  found <- newIORef Map.empty
  -- The watch needs a processor of its own: some work never gives its one back.
  setNumCapabilities 2
  _ <- forkOn 1 (watched corpus watch)
  start <- getMonotonicTime
  spent <- newIORef (Map.empty :: Map Kind (Int, Double, Int))
  let go number
        | number >= wishInputs wish = pure number
        | otherwise = do
          now <- getMonotonicTime
          if now - start >= wishSeconds wish
            then pure number
            else do
              let kind = wishKinds wish !! (number `mod` length (wishKinds wish))
                  t = Try (wishSeed wish) kind (number `div` length (wishKinds wish))
              writeIORef watch (Just (now, t))
              finding <- tryInput corpus t
              writeIORef watch Nothing
              end <- getMonotonicTime
              atomicModifyIORef' spent (\m -> (Map.insertWith (\(a, b, c) (a', b', c') -> let s = b + b' in s `seq` (a + a', s, c + c')) kind (1, end - now, length finding) m, ()))
              when (end - now > 5) . putStrLn $ "slow: " <> show t <> ", " <> show (end - now) <> " s"
              mapM_ (report found) finding
              go (number + 1)
  number <- go 0
  end <- getMonotonicTime
  putStrLn (show number <> " inputs in " <> show (round (end - start) :: Int) <> " s, seed " <> show (wishSeed wish))
  totals <- readIORef spent
  mapM_ putStrLn [extension kind <> ": " <> show n <> " inputs, " <> show (round s :: Int) <> " s, " <> show k <> " failed" | (kind, (n, s, k)) <- Map.toList totals]
  failures <- readIORef found
  mapM_ putStrLn [Text.unpack name <> ": " <> show n | (name, n) <- sortOn snd (Map.toList failures)]
  unless (Map.null failures) $ exitWith (ExitFailure 1)

-- | Tells of a finding, and keeps it if not many of its kind are kept.
report :: IORef (Map Text Int) -> Finding -> IO ()
report found finding@(Finding t failure _) = do
  let name = Text.pack (kindName (tryKind t)) <> Text.pack "-" <> failureName failure
  n <- atomicModifyIORef' found (\m -> let k = Map.findWithDefault 0 name m + 1 in (Map.insert name k m, k))
  when (n <= 3) $ do
    putStrLn (show t <> ": " <> take 600 (show failure))
    (path, small) <- keepFinding n finding
    putStrLn ("  " <> path <> " (" <> show (Bytes.length small) <> " bytes)")

-- | Looks whether the work goes on, once a second.
watched :: Corpus -> Watch -> IO ()
watched corpus watch = forever $ do
  threadDelay 1000000
  readIORef watch >>= \case
    Nothing -> pure ()
    Just (since, t) -> do
      now <- getMonotonicTime
      when (now - since > 300) $ do
        createDirectoryIfMissing True casesFolder
        let path = casesFolder </> kindName (tryKind t) <> "-cannot-be-stopped" <> extension (tryKind t)
        Bytes.writeFile path (inputOf corpus t)
        hPutStrLn stderr (show t <> " does not end: " <> path)
        exitImmediately (ExitFailure 2)
