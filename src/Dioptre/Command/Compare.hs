{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Command.Compare
-- Description : dioptre compare: two scenes or pictures, pixel by pixel
--
-- Either side may be a scene, which is drawn for it, or the file of a picture: a port's picture can be held
-- against the scene, and two scenes against each other, without a file between. Specification: 10.2 and 11.6.
module Dioptre.Command.Compare
  ( compare,
    verdict,
  )
where

import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Dioptre.Command.Journal (Journal, journalLanguage, sayDiagnostics, sayFault)
import Dioptre.Load (Loaded (..), drawnOrLoaded)
import Dioptre.Picture (Difference (..), difference, pictureHeight, pictureWidth)
import Dioptre.Source.Language (Language, inLanguage)
import System.Exit (ExitCode (..))
import Prelude hiding (compare)

-- | Compares what two paths show, and prints how they differ. Exit codes: 0 equal, 1 different, 3 one cannot be read.
--
-- Spec: cli.compare.
compare :: Journal -> FilePath -> FilePath -> IO ExitCode
compare journal a b = do
  left <- drawnOrLoaded l a
  right <- drawnOrLoaded l b
  case (,) <$> left <*> right of
    Left _ -> ExitFailure 3 <$ mapM_ (either (sayFault journal) (const (pure ()))) [left, right]
    Right ((p, scene), (q, scene')) -> do
      mapM_ (sayDiagnostics journal . loadedDiagnostics) (foldMap pure scene <> foldMap pure scene' :: [Loaded])
      Text.putStrLn (Text.pack (show (pictureWidth p) <> " x " <> show (pictureHeight p)) <> " pixels, " <> verdict l (difference p q))
      pure (if difference p q == Equal then ExitSuccess else ExitFailure 1)
  where
    l = journalLanguage journal

-- | How two pictures differ, in words.
--
-- Spec: picture.compare, cli.compare.
verdict :: Language -> Difference -> Text
verdict l d = case d of
  Equal -> inLanguage l "equal" "égales"
  SizesDiffer a b -> inLanguage l "different: sizes " "différentes\xA0: tailles " <> size a <> inLanguage l " and " " et " <> size b
  PixelsDiffer n most (column, row) ->
    inLanguage l "different: " "différentes\xA0: " <> number n
      <> inLanguage l " pixels differ, by at most " " pixels diffèrent, d'au plus "
      <> number most
      <> inLanguage l "; the first in column " "\xA0; le premier à la colonne "
      <> number column
      <> inLanguage l ", row " ", ligne "
      <> number row
  where
    size (w, h) = number w <> " x " <> number h
    number = Text.pack . show
