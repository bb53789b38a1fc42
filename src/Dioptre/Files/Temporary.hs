-- |
-- Module      : Dioptre.Files.Temporary
-- Description : A file that exists while it is needed
--
-- A picture takes a while to write. Written straight to its own name it would be seen in part by whoever looks, and
-- stay in part if the disk fills up or the user presses Ctrl-C. So it is written here first, under a name that nobody
-- asks for, in the folder of its destination (a rename or a link cannot cross file systems), and only a whole file is
-- given its name.
--
-- > folder/.dioptre4711-0.tmp  --- written, closed --->  folder/picture.png
-- >          |
-- >          '--- any exception ---> gone
module Dioptre.Files.Temporary
  ( withTemporary,
  )
where

import Control.Exception (bracket, finally)
import Control.Monad (when)
import qualified Data.ByteString as Bytes
import Data.Foldable (for_)
import Dioptre.Files.Contents (Contents)
import Dioptre.Files.Fault (quietly)
import System.IO (hClose, openBinaryTempFileWithDefaultPermissions)
import System.Posix.Files
  ( accessModes,
    fileMode,
    getFileStatus,
    intersectFileModes,
    removeLink,
    setFileMode,
  )
import System.Posix.Types (FileMode)

-- | @withTemporary folder mode write use@ makes a new file of @folder@ with these contents, and hands its path, closed,
-- to @use@, which may rename it; the results are those of the two. Whatever happens, asynchronous exceptions included, no
-- temporary is left afterwards.
--
-- The file has the permissions of any new file (@0666@ less the process's mask), or those of @mode@, from before its
-- first byte is written: nobody can read in the temporary what they could not read in the file that it replaces.
withTemporary :: FilePath -> Maybe FileMode -> Contents a -> (FilePath -> IO b) -> IO (a, b)
withTemporary folder mode write use =
  bracket create discard $ \(path, open) -> do
    for_ mode (permit path . intersectFileModes accessModes)
    written <- write (Bytes.hPut open)
    hClose open
    (,) written <$> use path
  where
    create = openBinaryTempFileWithDefaultPermissions here ".dioptre.tmp"
    here = if null folder then "." else folder
    discard (path, open) = quietly (hClose open) `finally` quietly (removeLink path)

-- | Gives the file these permissions, if it has others: file systems without permissions refuse to be asked.
permit :: FilePath -> FileMode -> IO ()
permit path wanted = do
  status <- getFileStatus path
  when (intersectFileModes accessModes (fileMode status) /= wanted) (setFileMode path wanted)
