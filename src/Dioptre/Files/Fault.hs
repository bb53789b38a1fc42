{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Files.Fault
-- Description : What can go wrong with a file, as data
--
-- The operating system answers a refused request with a number (@errno@), and the run-time system wraps that in an
-- 'IOException', whose text is English and whose kinds are coarse: a full disk and a process with too many open files
-- are one kind to it. Whoever writes a message needs a short closed list instead, each entry of which has a sentence
-- in every language. That list is 'Reason'; 'reasonOf' reads the number where there is one, and the kind where there
-- is none. No text for people is made here.
--
-- Only 'IOException' becomes a fault. What is thrown to a thread, and what a lazily made picture throws itself, is
-- nobody's file and passes through.
--
-- Sources: POSIX.1-2017, System Interfaces 2.3 "Error Numbers"
-- (<https://pubs.opengroup.org/onlinepubs/9699919799/functions/V2_chap02.html#tag_15_03>).
module Dioptre.Files.Fault
  ( -- * Faults
    FileFault (..),
    Reason (..),

    -- * From exceptions
    orFault,
    quietly,
    reasonOf,
  )
where

import Control.Exception (handle, try)
import Data.Bifunctor (first)
import Data.Text (Text)
import qualified Data.Text as Text
import Foreign.C.Error (Errno (..), eDQUOT, eFBIG, eISDIR, eLOOP, eMFILE, eNFILE, eNOSPC, eNOTDIR)
import GHC.IO.Exception (IOErrorType (InappropriateType), IOException (..))
import System.IO.Error (isDoesNotExistError, isPermissionError)

-- | A file that could not be read or written, and why.
data FileFault = FileFault
  { -- | The file, as the caller named it: never the temporary that stood in for it.
    faultPath :: FilePath,
    faultReason :: Reason
  }
  deriving stock (Eq, Show)

-- | Why a file could not be read or written.
data Reason
  = -- | No such file; when writing, no such folder.
    DoesNotExist
  | -- | Not allowed: the file, its folder, or the whole file system is protected.
    PermissionDenied
  | -- | A folder stands where a file was wanted.
    IsAFolder
  | -- | A file stands where the path needs a folder, as in @scene.txt\/picture.png@.
    NotAFolder
  | -- | No space is left on the device, the user's share of it is used up, or no file may be that long.
    DiskFull
  | -- | The process has as many files open as it may have, or the whole system has.
    TooManyOpen
  | -- | Symbolic links that lead to one another.
    LinksInACircle
  | -- | A device or a pipe where only a file will do.
    NotAPlainFile
  | -- | A picture where a scene was wanted.
    IsAPicture
  | -- | More than this many bytes, the most that are read of it.
    LongerThan Int
  | -- | Anything else, in the operating system's words (English).
    OtherReason Text
  deriving stock (Eq, Show)

-- | The result of an action on the file so named, or the fault that an 'IOException' tells of. Other exceptions,
-- asynchronous ones among them, are not caught.
orFault :: FilePath -> IO a -> IO (Either FileFault a)
orFault path action = first (FileFault path . reasonOf) <$> try action

-- | Work that is wanted, and of which it does not matter whether it can be done: closing a file that has failed already,
-- removing one that was renamed, writing to somebody who may have gone.
quietly :: IO () -> IO ()
quietly = handle ignore
  where
    ignore :: IOException -> IO ()
    ignore _ = pure ()

-- | The reason that an exception gives. Total: what is not on the list is 'OtherReason'.
--
-- The number is asked before the kind, because the run-time system files a used-up share of the disk under
-- \"permission denied\", and a full disk together with every other shortage. A folder opened as a file is refused by
-- the run-time system itself, without a number.
reasonOf :: IOException -> Reason
reasonOf problem
  | any numbered [eNOSPC, eDQUOT, eFBIG] = DiskFull
  | any numbered [eMFILE, eNFILE] = TooManyOpen
  | numbered eLOOP = LinksInACircle
  | numbered eNOTDIR = NotAFolder
  | numbered eISDIR = IsAFolder
  | InappropriateType <- ioe_type problem = IsAFolder
  | isDoesNotExistError problem = DoesNotExist
  | isPermissionError problem = PermissionDenied
  | null (ioe_description problem) = OtherReason (Text.pack (show (ioe_type problem)))
  | otherwise = OtherReason (Text.pack (ioe_description problem))
  where
    numbered number = (Errno <$> ioe_errno problem) == Just number
