{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Conformance.LinesSpec
  ( spec,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Chars
import Dioptre.Conformance.Lines
import System.IO (SeekMode (AbsoluteSeek), hSeek, hSetBinaryMode)
import System.IO.Temp (withSystemTempFile)
import Test.Hspec (Spec, it, shouldBe)
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (elements, forAll, frequency, ioProperty, listOf, (===))

spec :: Spec
spec = do
  it "gives lines, empty ones too, and the last one without an end" $ linesIn 10 "a\n\nbc" >>= (`shouldBe` [Line "a", Line "", Line "bc"])
  it "passes over a line that is too long, and goes on after it" $ linesIn 3 "abc\nabcd\nabc\nabcde" >>= (`shouldBe` [Line "abc", TooLong, Line "abc", TooLong])
  it "reads lines that are longer than what is read at once" $ do
    let long = Bytes.replicate 200000 120
    linesIn 200000 (long <> "\n" <> long <> "y\nz\n") >>= (`shouldBe` [Line long, TooLong, Line "z"])
  modifyMaxSuccess (const 100) . prop "gives what splitting gives" . forAll pieces $ \bytes ->
    ioProperty ((=== map limited (Chars.lines bytes)) <$> linesIn 70000 bytes)
  where
    pieces = Bytes.concat <$> listOf (frequency [(3, elements ["a", "bc\r", "\n"]), (1, pure (Bytes.replicate 40000 120))])
    limited l = if Bytes.length l > 70000 then TooLong else Line l

-- | All lines of a file.
linesIn :: Int -> Bytes.ByteString -> IO [Line]
linesIn longest bytes = withSystemTempFile "lines" $ \_ handle -> do
  hSetBinaryMode handle True
  Bytes.hPut handle bytes
  hSeek handle AbsoluteSeek 0
  source <- linesOf handle
  let go = nextLine longest source >>= \l -> if l == NoMore then pure [] else (l :) <$> go
  go
