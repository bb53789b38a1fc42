module Dioptre.Files.NumberSpec (spec) where

import Control.Concurrent (forkIO, newEmptyMVar, putMVar, readMVar, takeMVar)
import Control.Exception (ErrorCall (..), throwIO)
import Control.Monad (forM, forM_, void)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (nub, sort)
import qualified Data.Text as Text
import Dioptre.Files.Contents (Contents, contents)
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Number
import Foreign.C.Error (Errno (..), eEXIST, eMLINK, eNOSYS, eNOTSUP, ePERM, errnoToIOError)
import System.Directory (createDirectory, createFileLink, doesPathExist, listDirectory)
import System.FilePath ((</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Posix.Files (createLink)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "PictureNumber" $ do
    prop "exists for 0 to 999 and no other value" $ \value ->
      (pictureNumberValue <$> pictureNumber (value :: Integer))
        === (if value >= 0 && value <= 999 then Just (fromInteger value) else Nothing)

    it "has its bounds at 0 and 999" $ do
      map pictureNumber [-1, 0, 999, 1000 :: Int] `shouldBe` [Nothing, Just minBound, Just maxBound, Nothing]
      map pictureNumber [2 ^ (64 :: Int), -(2 ^ (64 :: Int)) :: Integer] `shouldBe` [Nothing, Nothing]

    it "is followed by the next, and 999 by 0" $ do
      map (pictureNumberValue . next) (numbersFrom minBound) `shouldBe` [1 .. 999] <> [0]

    prop "goes round through every number once" . forAll numbers $ \first -> do
      let values = map pictureNumberValue (numbersFrom first)
      take 1 values === [pictureNumberValue first] .&&. sort values === [0 .. 999]

    it "has three digits in a file name" $
      map (pictureFileName (Text.pack "sc\232ne")) (concatMap (take 1 . numbersFrom) [minBound, next minBound, maxBound])
        `shouldBe` ["sc\232ne_000.png", "sc\232ne_001.png", "sc\232ne_999.png"]

  describe "writeNumbered" $ writing (bytesBy writeNumbered)

  forM_ [ePERM, eNOTSUP, eMLINK, eNOSYS] $ \number@(Errno value) ->
    describe ("writeNumbered where links are refused with error " <> show value) $
      writing (bytesBy (writeNumberedBy (refusing number)))

  describe "writeNumberedBy" $
    around (withSystemTempDirectory "number") $ do
      it "does not fall back where the name is taken" $ \folder -> do
        let always = refusing eEXIST
        bytesBy (writeNumberedBy always) folder name minBound (Lazy.pack "new")
          `shouldReturn` Left (AllNumbersTaken folder name)
        listDirectory folder `shouldReturn` []

      it "falls back for one number only" $ \folder -> do
        let refusingOne from to
              | to == folder </> "p_000.png" = refusing ePERM from to
              | otherwise = createLink from to
        results <- forM "ab" $ \c -> bytesBy (writeNumberedBy refusingOne) folder name minBound (Lazy.pack [c])
        map (fmap snd) results `shouldBe` [Right minBound, Right (next minBound)]
        mapM readFile [folder </> "p_000.png", folder </> "p_001.png"] `shouldReturn` ["a", "b"]

      it "removes the temporary when linking is interrupted" $ \folder -> do
        bytesBy (writeNumberedBy (\_ _ -> throwIO (ErrorCall "stop"))) folder name minBound Lazy.empty
          `shouldThrow` errorCall "stop"
        listDirectory folder `shouldReturn` []

-- | A way to write a picture, for bytes that are there.
bytesBy ::
  (FilePath -> Text.Text -> PictureNumber -> Contents () -> IO (Either NumberingFault ((FilePath, PictureNumber), ()))) ->
  (FilePath -> Text.Text -> PictureNumber -> Lazy.ByteString -> IO (Either NumberingFault (FilePath, PictureNumber)))
bytesBy write folder called from bytes = fmap fst <$> write folder called from (contents bytes)

-- | What holds however the number is claimed.
writing ::
  (FilePath -> Text.Text -> PictureNumber -> Lazy.ByteString -> IO (Either NumberingFault (FilePath, PictureNumber))) ->
  Spec
writing write = around (withSystemTempDirectory "number") $ do
  it "takes the first number where it is free" $ \folder -> do
    Just number <- pure (pictureNumber (7 :: Int))
    write folder name number (Lazy.pack "new") `shouldReturn` Right (folder </> "p_007.png", number)
    readFile (folder </> "p_007.png") `shouldReturn` "new"
    listDirectory folder `shouldReturn` ["p_007.png"]

  modifyMaxSuccess (const 30) $
    it "takes the first free number from the given one on, round past 999, and changes no file" $ \folder ->
      forAll ((,) <$> crowded <*> numbers) $ \(taken, first) ->
        withSystemTempDirectory "number" $ \inner -> do
          let path number = inner </> pictureFileName name number
              free = filter (`notElem` taken) (numbersFrom first)
          forM_ taken $ \number -> writeFile (path number) "old"
          result <- write inner name first (Lazy.pack "new")
          result `shouldBe` Right (path (head' free), head' free)
          readFile (path (head' free)) `shouldReturn` "new"
          forM_ taken $ \number -> readFile (path number) `shouldReturn` "old"
          length <$> listDirectory inner `shouldReturn` length (nub taken) + 1
          listDirectory folder `shouldReturn` []

  it "passes over a folder and a dangling link of that name" $ \folder -> do
    createDirectory (folder </> "p_000.png")
    createFileLink (folder </> "target") (folder </> "p_001.png")
    fmap snd <$> write folder name minBound (Lazy.pack "new") `shouldReturn` Right (next (next minBound))
    doesPathExist (folder </> "target") `shouldReturn` False

  it "gives pictures written at once numbers of their own" $ \folder -> do
    start <- newEmptyMVar
    results <- forM [1 .. 40 :: Int] $ \picture -> do
      result <- newEmptyMVar
      void . forkIO $ do
        readMVar start
        write folder name maxBound (Lazy.pack (replicate 5000 'x' <> show picture)) >>= putMVar result
      pure result
    putMVar start ()
    written <- mapM takeMVar results
    forM_ (zip [1 .. 40 :: Int] written) $ \(picture, result) -> case result of
      Right (path, _) -> readFile path `shouldReturn` (replicate 5000 'x' <> show picture)
      Left fault -> expectationFailure (show fault)
    let used = sort [pictureNumberValue number | Right (_, number) <- written]
    used `shouldBe` [0 .. 38] <> [999]
    length <$> listDirectory folder `shouldReturn` 40

  it "says so when all thousand are taken" $ \folder -> do
    forM_ (numbersFrom minBound) $ \number -> writeFile (folder </> pictureFileName name number) "old"
    write folder name maxBound (Lazy.pack "new") `shouldReturn` Left (AllNumbersTaken folder name)
    length <$> listDirectory folder `shouldReturn` 1000
    numberingObstacle folder name maxBound `shouldReturn` Just (AllNumbersTaken folder name)

  it "says so when the folder is missing" $ \folder -> do
    let none = folder </> "none"
    write none name minBound Lazy.empty
      `shouldReturn` Left (NotWritten (FileFault (none </> "p_000.png") DoesNotExist))
    numberingObstacle none name minBound `shouldReturn` Just (NotWritten (FileFault (none </> "p_000.png") DoesNotExist))

  it "says so when the name is too long, and leaves nothing" $ \folder -> do
    result <- write folder (Text.replicate 250 (Text.pack "p")) minBound Lazy.empty
    case result of
      Left (NotWritten (FileFault _ (OtherReason _))) -> listDirectory folder `shouldReturn` []
      _ -> expectationFailure (show result)

  it "refuses names that would leave the folder" $ \folder ->
    forM_ ["a/b", "../a", "/a", "a\\b", "a\nb", "a\0b"] $ \bad -> do
      let badName = Text.pack bad
      write folder badName minBound Lazy.empty `shouldReturn` Left (UnusableName badName)
      numberingObstacle folder badName minBound `shouldReturn` Just (UnusableName badName)
      listDirectory folder `shouldReturn` []
  where
    head' numbersLeft = case numbersLeft of
      number : _ -> number
      [] -> error "the generator leaves a number free"

name :: Text.Text
name = Text.pack "p"

refusing :: Errno -> FilePath -> FilePath -> IO ()
refusing number _ path = ioError (errnoToIOError "link" number Nothing (Just path))

numbers :: Gen PictureNumber
numbers = frequency [(4, chooseInt (0, 999)), (2, chooseInt (995, 999)), (1, elements [0, 999])] `suchThatMap` pictureNumber

-- | Some taken numbers, often in a row and often across the end.
crowded :: Gen [PictureNumber]
crowded = do
  runs <- chooseInt (0, 3)
  concat <$> vectorOf runs (take <$> chooseInt (0, 30) <*> (numbersFrom <$> numbers))
