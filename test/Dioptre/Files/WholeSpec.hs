module Dioptre.Files.WholeSpec (spec) where

import Control.Concurrent (forkIO, killThread, newEmptyMVar, putMVar, takeMVar)
import Control.Exception (bracket, bracket_, finally)
import Control.Monad (forM_, replicateM, replicateM_, void)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.ByteString.Lazy.Char8 as Lazy8
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Fault (FileFault (..), Reason (..))
import Dioptre.Files.Whole
import Numeric (showOct)
import System.Directory
  ( createDirectory,
    createFileLink,
    doesPathExist,
    listDirectory,
    pathIsSymbolicLink,
  )
import System.FilePath ((</>))
import System.IO (IOMode (WriteMode), openFile)
import System.IO.Temp (withSystemTempDirectory)
import System.IO.Unsafe (unsafeInterleaveIO)
import System.Posix.Files
  ( createNamedPipe,
    fileMode,
    getFileStatus,
    intersectFileModes,
    setFileCreationMask,
    setFileMode,
    setFileSize,
  )
import System.Posix.IO (closeFd, fdWrite, handleToFd)
import System.Posix.Types (FileMode)
import System.Posix.User (getEffectiveUserID, setEffectiveUserID)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck (Gen, arbitrary, chooseInt, forAll, frequency, vectorOf)

spec :: Spec
spec = around (withSystemTempDirectory "whole") $ do
  describe "writeWhole" $ do
    modifyMaxSuccess (const 50) $
      it "writes what readWhole reads" $ \folder ->
        forAll someBytes $ \bytes -> do
          writeWhole (folder </> "file") (contents bytes) `shouldReturn` Right ()
          readWhole (folder </> "file") `shouldReturn` Right (Lazy.toStrict bytes)
          listDirectory folder `shouldReturn` ["file"]

    it "is never seen in part" $ \folder -> do
      let path = folder </> "file"
          versions = [Lazy8.replicate 300000 c | c <- "ab"]
          wholes = map (Right . Lazy.toStrict) versions
      done <- newEmptyMVar
      void (writeWhole path (contents (Lazy8.replicate 300000 'a')))
      void (forkIO (replicateM_ 50 (mapM_ (writeWhole path . contents) versions) `finally` putMVar done ()))
      seen <- replicateM 200 (readWhole path)
      takeMVar done
      filter (`notElem` wholes) seen `shouldBe` []

    it "keeps the old file, and leaves no other, when the contents fail on the way" $ \folder -> do
      writeFile (folder </> "file") "old"
      writeWhole (folder </> "file") (contents (Lazy8.replicate 100000 'x' <> error "picture"))
        `shouldThrow` errorCall "picture"
      readWhole (folder </> "file") `shouldReturn` Right (Char8.pack "old")
      listDirectory folder `shouldReturn` ["file"]

    it "keeps the old file, and leaves no other, when it is interrupted" $ \folder -> do
      writeFile (folder </> "file") "old"
      (started, never, done) <- (,,) <$> newEmptyMVar <*> newEmptyMVar <*> newEmptyMVar
      rest <- unsafeInterleaveIO (putMVar started () >> takeMVar never)
      writer <-
        forkIO $
          void (writeWhole (folder </> "file") (contents (Lazy8.replicate 100000 'x' <> rest))) `finally` putMVar done ()
      takeMVar started
      length <$> listDirectory folder `shouldReturn` 2
      killThread writer
      takeMVar done
      readWhole (folder </> "file") `shouldReturn` Right (Char8.pack "old")
      listDirectory folder `shouldReturn` ["file"]
      putMVar never Lazy.empty

    describe "permissions" $ do
      forM_ [0o022, 0o077, 0o002] $ \mask ->
        it ("gives a new file those of any new file, under mask " <> showOct mask "") $ \folder ->
          bracket (setFileCreationMask mask) setFileCreationMask $ \_ -> do
            writeFile (folder </> "plain") ""
            writeWhole (folder </> "whole") (contents Lazy.empty) `shouldReturn` Right ()
            wanted <- modeOf (folder </> "plain")
            modeOf (folder </> "whole") `shouldReturn` wanted

      forM_ [0o600, 0o644, 0o664, 0o755] $ \mode ->
        it ("keeps those of the file replaced: " <> showOct mode "") $ \folder -> do
          writeFile (folder </> "file") "old"
          setFileMode (folder </> "file") mode
          writeWhole (folder </> "file") (contents (Lazy8.pack "new")) `shouldReturn` Right ()
          modeOf (folder </> "file") `shouldReturn` mode

    describe "links" $ do
      it "writes through them, over several hops" $ \folder -> do
        createDirectory (folder </> "inner")
        writeFile (folder </> "inner" </> "file") "old"
        createFileLink "file" (folder </> "inner" </> "link")
        createFileLink ("inner" </> "link") (folder </> "link")
        writeWhole (folder </> "link") (contents (Lazy8.pack "new")) `shouldReturn` Right ()
        readFile (folder </> "inner" </> "file") `shouldReturn` "new"
        pathIsSymbolicLink (folder </> "link") `shouldReturn` True
        pathIsSymbolicLink (folder </> "inner" </> "link") `shouldReturn` True

      it "keeps the old file behind them when the contents fail on the way" $ \folder -> do
        writeFile (folder </> "file") "old"
        createFileLink "file" (folder </> "link")
        writeWhole (folder </> "link") (contents (Lazy8.replicate 100000 'x' <> error "picture"))
          `shouldThrow` errorCall "picture"
        readFile (folder </> "file") `shouldReturn` "old"

      it "makes the file that a dangling one points to" $ \folder -> do
        createFileLink (folder </> "file") (folder </> "link")
        writeWhole (folder </> "link") (contents (Lazy8.pack "new")) `shouldReturn` Right ()
        readFile (folder </> "file") `shouldReturn` "new"
        pathIsSymbolicLink (folder </> "link") `shouldReturn` True

      it "refuses those that go in a circle" $ \folder -> do
        createFileLink "b" (folder </> "a")
        createFileLink "a" (folder </> "b")
        writeWhole (folder </> "a") (contents Lazy.empty) `shouldReturn` Left (FileFault (folder </> "a") LinksInACircle)

    describe "devices" $ do
      it "writes into them" $ \_ -> do
        writeWhole "/dev/null" (contents (Lazy8.pack "new")) `shouldReturn` Right ()
        doesPathExist "/dev/null" `shouldReturn` True

      it "tells of a full disk" $ \folder -> do
        let full = FileFault "/dev/full" DiskFull
        writeWhole "/dev/full" (contents (Lazy8.pack "new")) `shouldReturn` Left full
        createFileLink "/dev/full" (folder </> "link")
        writeWhole (folder </> "link") (contents (Lazy8.pack "new"))
          `shouldReturn` Left full {faultPath = folder </> "link"}

      it "writes into a pipe, which reads whole" $ \folder -> do
        let pipe = folder </> "pipe"
        createNamedPipe pipe 0o600
        received <- newEmptyMVar
        void (forkIO (readWhole pipe >>= putMVar received))
        writeWhole pipe (contents (Lazy8.replicate 200000 'x')) `shouldReturn` Right ()
        takeMVar received `shouldReturn` Right (Char8.replicate 200000 'x')

      it "writes on from where a descriptor is" $ \folder -> do
        let path = folder </> "file"
        bracket (openFile path WriteMode >>= handleToFd) closeFd $ \descriptor -> do
          void (fdWrite descriptor "before ")
          writeWhole ("/dev/fd/" <> show descriptor) (contents (Lazy8.pack "whole")) `shouldReturn` Right ()
          void (fdWrite descriptor " after")
        readFile path `shouldReturn` "before whole after"

    describe "faults" $ do
      it "names a folder that is in the way" $ \folder ->
        writeWhole folder (contents Lazy.empty) `shouldReturn` Left (FileFault folder IsAFolder)

      it "names a folder that is missing" $ \folder ->
        forM_ [folder </> "none" </> "file", folder </> "none/", ""] $ \path ->
          writeWhole path (contents Lazy.empty) `shouldReturn` Left (FileFault path DoesNotExist)

      it "names a file that should be a folder" $ \folder -> do
        writeFile (folder </> "file") "old"
        let path = folder </> "file" </> "file"
        writeWhole path (contents Lazy.empty) `shouldReturn` Left (FileFault path NotAFolder)

      it "does not replace a protected file, and makes none in a protected folder" $ \folder -> do
        writeFile (folder </> "file") "old"
        setFileMode (folder </> "file") 0o444
        setFileMode folder 0o777
        unprivileged $
          writeWhole (folder </> "file") (contents Lazy.empty)
            `shouldReturn` Left (FileFault (folder </> "file") PermissionDenied)
        setFileMode folder 0o555
        unprivileged $
          writeWhole (folder </> "new") (contents Lazy.empty)
            `shouldReturn` Left (FileFault (folder </> "new") PermissionDenied)
        setFileMode folder 0o755
        readFile (folder </> "file") `shouldReturn` "old"
        listDirectory folder `shouldReturn` ["file"]

  describe "readWhole" $ do
    it "gives every byte, line ends and all" $ \folder -> do
      let bytes = Bytes.pack ([0 .. 255] <> [13, 10, 13, 26])
      Bytes.writeFile (folder </> "file") bytes
      readWhole (folder </> "file") `shouldReturn` Right bytes

    it "reads devices" $ \_ ->
      readWhole "/dev/null" `shouldReturn` Right Bytes.empty

    it "reads no more than there is room for from what never ends" $ \_ ->
      readWhole "/dev/zero" `shouldReturn` Left (FileFault "/dev/zero" (LongerThan mostOfStream))

    it "reads no more than there is room for of a file" $ \folder -> do
      -- A file that takes no room on the disk.
      writeFile (folder </> "file") ""
      setFileSize (folder </> "file") (fromIntegral mostOfFile + 1)
      readWhole (folder </> "file") `shouldReturn` Left (FileFault (folder </> "file") (LongerThan mostOfFile))

    it "names a file that is missing, and a folder" $ \folder -> do
      readWhole (folder </> "none") `shouldReturn` Left (FileFault (folder </> "none") DoesNotExist)
      readWhole folder `shouldReturn` Left (FileFault folder IsAFolder)

    it "names a file that may not be read" $ \folder -> do
      writeFile (folder </> "file") "old"
      setFileMode (folder </> "file") 0o000
      setFileMode folder 0o755
      unprivileged $
        readWhole (folder </> "file") `shouldReturn` Left (FileFault (folder </> "file") PermissionDenied)

  describe "readPlain" $ do
    it "reads files as readWhole does" $ \folder -> do
      Bytes.writeFile (folder </> "file") (Char8.pack "old")
      readPlain (folder </> "file") `shouldReturn` Right (Char8.pack "old")
      readPlain (folder </> "none") `shouldReturn` Left (FileFault (folder </> "none") DoesNotExist)
      readPlain folder `shouldReturn` Left (FileFault folder IsAFolder)

    it "refuses pipes and devices, and does not wait for them" $ \folder -> do
      createNamedPipe (folder </> "pipe") 0o644
      readPlain (folder </> "pipe") `shouldReturn` Left (FileFault (folder </> "pipe") NotAPlainFile)
      readPlain "/dev/zero" `shouldReturn` Left (FileFault "/dev/zero" NotAPlainFile)

  describe "writingObstacle" $ do
    it "finds nothing where a file can be written, and leaves all as it is" $ \folder -> do
      writeFile (folder </> "file") "old"
      forM_ ["file", "new"] $ \name -> writingObstacle (folder </> name) `shouldReturn` Nothing
      writingObstacle "/dev/null" `shouldReturn` Nothing
      readFile (folder </> "file") `shouldReturn` "old"
      listDirectory folder `shouldReturn` ["file"]

    it "finds what writeWhole would fail of" $ \folder -> do
      writeFile (folder </> "file") "old"
      setFileMode (folder </> "file") 0o444
      createDirectory (folder </> "closed")
      setFileMode (folder </> "closed") 0o555
      setFileMode folder 0o777
      unprivileged . forM_ ["file", "closed/new", "none/new", "closed", "file/new"] $ \name -> do
        obstacle <- writingObstacle (folder </> name)
        outcome <- writeWhole (folder </> name) (contents Lazy.empty)
        outcome `shouldNotBe` Right ()
        Just outcome `shouldBe` (Left <$> obstacle)

-- | Bytes in pieces, from none to more than any buffer holds.
someBytes :: Gen Lazy.ByteString
someBytes = do
  pieces <- chooseInt (0, 5)
  Lazy.fromChunks <$> vectorOf pieces (frequency [(4, small), (1, large)])
  where
    small = Bytes.pack <$> arbitrary
    large = Bytes.replicate <$> chooseInt (30000, 100000) <*> arbitrary

modeOf :: FilePath -> IO FileMode
modeOf path = intersectFileModes 0o7777 . fileMode <$> getFileStatus path

-- | Does without the rights of the superuser, to whom nothing is forbidden.
unprivileged :: IO a -> IO a
unprivileged action = do
  user <- getEffectiveUserID
  if user == 0 then bracket_ (setEffectiveUserID 65534) (setEffectiveUserID 0) action else action
