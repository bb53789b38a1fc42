{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Files.Stamp
-- Description : Whether a file is still what it was
--
-- Reading a file again tells, but a stamp is cheaper: which file it is, how long, and written when. Who writes to it
-- changes that, except within one tick of the file system's clock and to the same length.
module Dioptre.Files.Stamp
  ( Stamp,
    stampOf,
  )
where

import Dioptre.Files.Identity (Identity, identityOf, statusOf)
import System.Posix.Files (fileSize, modificationTimeHiRes)
import System.Posix.Types (FileOffset)

-- | What a file was at a moment.
data Stamp = Stamp !Identity !FileOffset !Rational
  deriving stock (Eq, Show)

-- | What the file at a path is, if there is one. Links are followed.
stampOf :: FilePath -> IO (Maybe Stamp)
stampOf path = fmap stamp <$> statusOf path
  where
    stamp s = Stamp (identityOf s) (fileSize s) (toRational (modificationTimeHiRes s))
