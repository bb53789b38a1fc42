module Dioptre.Files.SearchSpec (spec) where

import Control.Exception (bracket, bracket_)
import Control.Monad (forM_, unless)
import qualified Data.ByteString.Char8 as Char8
import Data.Char (toLower, toUpper)
import Data.Either (isLeft)
import Data.List (intercalate, sort)
import qualified Data.List.NonEmpty as NonEmpty
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Files.Search
import GHC.IO.Encoding (getFileSystemEncoding, mkTextEncoding, setFileSystemEncoding)
import System.Directory
  ( canonicalizePath,
    createDirectoryIfMissing,
    createDirectoryLink,
    createFileLink,
    doesFileExist,
    withCurrentDirectory,
  )
import System.FilePath (isRelative, takeDirectory, takeFileName, (</>))
import System.IO.Temp (withSystemTempDirectory)
import System.Posix.Files (createLink, createNamedPipe, createSymbolicLink, setFileMode)
import qualified System.Posix.Files.ByteString as Raw
import System.Posix.User (getEffectiveUserID, setEffectiveUserID)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "wantedName" $ do
    it "drops folders, blanks and case" $
      forM_ ["boule.obj", " BOULE.Obj\t", "models/boule.obj", "C:\\a b\\Boule.OBJ", "/a\\b/boule.obj", "a/ boule.obj "] $
        \written -> wantedName (Text.pack written) `shouldBe` Just (Text.pack "boule.obj")

    it "folds case beyond ASCII" $
      wantedName (Text.pack "TH\201I\200RE STRASSE.obj") `shouldBe` wantedName (Text.pack "th\233i\232re stra\223e.OBJ")

    it "is absent where no name is left" $
      forM_ ["", "  ", ".", "..", "a/", "a\\", "a/..", " . ", "/"] $ \written ->
        wantedName (Text.pack written) `shouldBe` Nothing

    prop "does not depend on the folders in front and the blanks around" $ \front written ->
      forAll (elements ["", " ", "\t "]) $ \blank -> do
        let name = filter (`notElem` ("/\\" :: String)) written
            disguise separator = intercalate blank ["", front <> separator, name, ""]
        [wantedName (Text.pack (disguise separator)) | separator <- ["/", "\\"]]
          === replicate 2 (wantedName (Text.pack name))

  describe "search" . around_ (underEncoding "UTF-8//ROUNDTRIP") . around (withSystemTempDirectory "search") $ do
    describe "steps" $ do
      it "looks beside the naming file first" $ \working -> do
        make working ["a/boule.obj", "models/boule.obj", "boule.obj"]
        find working "a" "boule.obj" `shouldReturn` Right "a/boule.obj"
        find working "." "boule.obj" `shouldReturn` Right "boule.obj"

      it "looks in scenes and models next" $ \working -> do
        make working ["models/boule.obj", "boule.obj", "b/boule.obj", "scenes/lune.txt", "lune.txt", "a/x"]
        find working "a" "boule.obj" `shouldReturn` Right "models/boule.obj"
        find working "a" "lune.txt" `shouldReturn` Right "scenes/lune.txt"

      it "looks everywhere below the working directory last" $ \working -> do
        make working ["models/far/boule.obj", "a/x"]
        find working "a" "boule.obj" `shouldReturn` Right "models/far/boule.obj"

      it "goes seven folders deep and no deeper" $ \working -> do
        make working ["1/2/3/4/5/6/7/boule.obj", "1/2/3/4/5/6/7/8/lune.obj"]
        find working "." "boule.obj" `shouldReturn` Right "1/2/3/4/5/6/7/boule.obj"
        find working "." "lune.obj" `shouldReturn` nowhere "lune.obj"

      it "stays out of hidden and build folders" $ \working -> do
        make working [folder </> "a/boule.obj" | folder <- [".stack-work", "dist", "dist-newstyle", "node_modules", ".git", "..."]]
        find working "." "boule.obj" `shouldReturn` nowhere "boule.obj"
        make working ["distance/boule.obj"]
        find working "." "boule.obj" `shouldReturn` Right "distance/boule.obj"

      it "looks even there beside the naming file" $ \working -> do
        make working ["dist/boule.obj"]
        find working "dist" "boule.obj" `shouldReturn` Right "dist/boule.obj"

      it "does not follow links to folders" $ \working ->
        withSystemTempDirectory "elsewhere" $ \elsewhere -> do
          make elsewhere ["boule.obj"]
          createDirectoryLink elsewhere (working </> "link")
          createDirectoryLink "." (working </> "circle")
          find working "." "boule.obj" `shouldReturn` nowhere "boule.obj"

      it "follows models where it is a link" $ \working ->
        withSystemTempDirectory "elsewhere" $ \elsewhere -> do
          make elsewhere ["boule.obj"]
          createDirectoryLink elsewhere (working </> "models")
          find working "." "boule.obj" `shouldReturn` Right "models/boule.obj"

      it "passes over folders that may not be read" $ \working -> do
        make working ["closed/boule.obj", "open/boule.obj"]
        setFileMode working 0o755
        setFileMode (working </> "closed") 0o000
        found <- unprivileged (find working "." "boule.obj")
        setFileMode (working </> "closed") 0o755
        found `shouldBe` Right "open/boule.obj"

      it "finds files, and links to files, but no folders and no dangling links" $ \working -> do
        make working ["a/boule.obj/x", "b/lune.obj"]
        createFileLink "nothing" (working </> "soleil.obj")
        createFileLink "b/lune.obj" (working </> "satellite.obj")
        find working "." "boule.obj" `shouldReturn` nowhere "boule.obj"
        find working "." "soleil.obj" `shouldReturn` nowhere "soleil.obj"
        find working "." "satellite.obj" `shouldReturn` Right "satellite.obj"

    it "passes over pipes and devices, which never end or never begin" $ \working -> do
      createNamedPipe (working </> "boule.obj") 0o644
      createSymbolicLink "/dev/zero" (working </> "lune.obj")
      forM_ ["boule.obj", "lune.obj"] $ \name -> find working "." name `shouldReturn` nowhere name

    describe "several files" $ do
      it "is a fault that lists them" $ \working -> do
        make working ["models/boule.obj", "scenes/boule.obj", "a/x"]
        find working "a" "boule.obj" `shouldReturn` several "boule.obj" ["models/boule.obj", "scenes/boule.obj"]
        make working ["b/lune.obj", "c/d/lune.obj", "lune.obj"]
        find working "a" "lune.obj" `shouldReturn` several "lune.obj" ["b/lune.obj", "c/d/lune.obj", "lune.obj"]

      it "is a fault even where one is spelt exactly so" $ \working -> do
        make working ["boule.obj", "Boule.OBJ"]
        find working "." "boule.obj" `shouldReturn` several "boule.obj" ["Boule.OBJ", "boule.obj"]

      it "counts a file once that has several names" $ \working -> do
        make working ["models/boule.obj"]
        createDirectoryLink "models" (working </> "scenes")
        find working "." "boule.obj" `shouldReturn` Right "models/boule.obj"
        make working ["b/lune.obj"]
        createFileLink "b/lune.obj" (working </> "LUNE.obj")
        createLink (working </> "b/lune.obj") (working </> "b/Lune.obj")
        find working "b" "lune.obj" `shouldReturn` Right "b/Lune.obj"
        find working "models" "lune.obj" `shouldReturn` Right "LUNE.obj"

    describe "none" $ do
      it "is a fault that lists the places" $ \working -> do
        make working ["a/x"]
        find working "a" "b/Boule.obj"
          `shouldReturn` Left
            ( NotFound
                (Text.pack "b/Boule.obj")
                (NonEmpty.fromList [Within "a", Within "scenes", Within "models", Below "."])
                Nothing
            )

      it "is told with a name that is nearly the same, nearest first, of a file of that ending beside or in scenes or models" $ \working -> do
        let near folder = fmap (either (\fault -> [n | NotFound _ _ n <- [fault]]) (const [])) . find working folder
        make working ["a/x", "models/Teapot.obj", "models/teapo.png", "models/tea_pot.obj/x", "below/teapo.msr", "scenes/cup.obj"]
        mapM (near "a") ["teapo.obj", "TAEPOT.OBJ", "teapa.msr", "kettle.obj", "x.obj", "obj"]
          `shouldReturn` map pure [Just (Text.pack "Teapot.obj"), Just (Text.pack "Teapot.obj"), Nothing, Nothing, Nothing, Nothing]
        make working ["a/teapos.obj"]
        near "a" "teapo.obj" `shouldReturn` [Just (Text.pack "teapos.obj")]

      it "is a fault where no name is left" $ \working -> do
        make working ["a/x"]
        forM_ ["", ".", "..", "a/", " \\ "] $ \written ->
          find working "a" written `shouldReturn` Left (NoName (Text.pack written))

      it "does not mind folders that are not there" $ \working -> do
        find working "none" "boule.obj" >>= (`shouldSatisfy` isLeft)
        find (working </> "none") "none" "boule.obj" >>= (`shouldSatisfy` isLeft)

    describe "names" $ do
      it "are found in any case, behind any folders, between blanks" $ \working ->
        forAll fileName $ \stored ->
          forAll (disguised stored) $ \written ->
            withSystemTempDirectory "search" $ \inner -> do
              make inner ["a" </> stored, "a/other"]
              find inner "." written `shouldReturn` Right ("a" </> stored)
              find working "." written >>= (`shouldSatisfy` isLeft)

      it "may be anything at all" $ \working ->
        forAll ((<>) <$> arbitrary <*> elements ["", "\0", "\1114111", "\56507", "*", "~", "/x", " X "]) $ \written -> do
          make working ["a/x"]
          found <- find working "." written
          either (const False) (== "a/x") found `shouldBe` (wantedName (Text.pack written) == Just (Text.pack "x"))

      it "are read from Latin-1 bytes where they are not UTF-8" $ \working -> do
        touchRaw working (Char8.pack "th\233i\232re.obj")
        found <- find working "." "TH\201I\200RE.OBJ"
        either (const (pure False)) (doesFileExist . (working </>)) found `shouldReturn` True

      it "differ where their bytes differ, though neither is UTF-8" $ \working -> do
        touchRaw working (Char8.pack "a\233")
        touchRaw working (Char8.pack "a\232")
        found <- find working "." "a\233"
        found `shouldSatisfy` (not . isLeft)
        find working "." "a\65533" `shouldReturn` nowhere "a\65533"

      it "do not depend on the locale" $ \working -> do
        touchRaw working (Char8.pack "th\195\169i\195\168re.obj")
        found <- underEncoding "ASCII//ROUNDTRIP" $ do
          found <- find working "." "TH\201I\200RE.OBJ"
          exists <- either (const (pure False)) (doesFileExist . (working </>)) found
          pure (either (const False) (const exists) found)
        found `shouldBe` True

    describe "paths" $ do
      it "are relative to the working directory where they are below it" $ \working -> do
        make working ["a/b/boule.obj"]
        absolute <- canonicalizePath working
        forM_ ["a/b", "./a//b/", "a/b/../b", absolute </> "a/b"] $ \folder ->
          find working folder "boule.obj" `shouldReturn` Right "a/b/boule.obj"
        forM_ [working, absolute, absolute </> "a/.."] $ \elsewhere ->
          find elsewhere (absolute </> "a/b") "boule.obj" `shouldReturn` Right "a/b/boule.obj"

      it "are as the folder is given where they are not" $ \working ->
        withSystemTempDirectory "elsewhere" $ \elsewhere -> do
          make elsewhere ["boule.obj"]
          find working elsewhere "boule.obj" `shouldReturn` Right (elsewhere </> "boule.obj")
          let folder = "../" <> takeFileName elsewhere
          find working folder "boule.obj" `shouldReturn` Right (folder </> "boule.obj")

      it "work from the directory that one is in" $ \working -> do
        make working ["a/boule.obj", "lune.obj", "b/c/soleil.obj"]
        withCurrentDirectory working . forM_ [".", ""] $ \here -> do
          find here here "lune.obj" `shouldReturn` Right "lune.obj"
          find here "a" "boule.obj" `shouldReturn` Right "a/boule.obj"
          find here (working </> "a") "boule.obj" `shouldReturn` Right "a/boule.obj"
          find here here "soleil.obj" `shouldReturn` Right "b/c/soleil.obj"

      modifyMaxSuccess (const 50) $
        it "lead to the file, whatever the tree" $ \_ ->
          forAll tree $ \paths ->
            withSystemTempDirectory "search" $ \inner -> do
              make inner paths
              result <- find inner "a" "B.obj"
              case result of
                Right path -> do
                  isRelative path `shouldBe` True
                  paths `shouldContain` [path]
                Left (SeveralFound _ found) -> do
                  length found `shouldSatisfy` (> 1)
                  NonEmpty.toList found `shouldBe` sort (NonEmpty.toList found)
                  filter (`notElem` paths) (NonEmpty.toList found) `shouldBe` []
                Left _ -> filter ((== "b.obj") . map toLower . takeFileName) paths `shouldBe` []

find :: FilePath -> FilePath -> String -> IO (Either SearchFault FilePath)
find working folder = search working folder . Text.pack

nowhere :: String -> Either SearchFault FilePath
nowhere written = Left (NotFound (Text.pack written) (NonEmpty.fromList places) Nothing)
  where
    places = [Within ".", Within "scenes", Within "models", Below "."]

several :: String -> [FilePath] -> Either SearchFault FilePath
several written = Left . SeveralFound (Text.pack written :: Text) . NonEmpty.fromList

-- | Makes files with the folders that they need.
make :: FilePath -> [FilePath] -> IO ()
make working paths = forM_ paths $ \path -> do
  createDirectoryIfMissing True (takeDirectory (working </> path))
  exists <- doesFileExist (working </> path)
  unless exists (writeFile (working </> path) "")

-- | Makes an empty file whose name is these very bytes.
touchRaw :: FilePath -> Char8.ByteString -> IO ()
touchRaw working bytes = do
  writeFile (working </> ".source") ""
  Raw.rename (Char8.pack (working </> ".source")) (Char8.pack working <> Char8.pack "/" <> bytes)

underEncoding :: String -> IO a -> IO a
underEncoding encoding action =
  bracket (getFileSystemEncoding <* (mkTextEncoding encoding >>= setFileSystemEncoding)) setFileSystemEncoding (const action)

-- | Does without the rights of the superuser, to whom nothing is forbidden.
unprivileged :: IO a -> IO a
unprivileged action = do
  user <- getEffectiveUserID
  if user == 0 then bracket_ (setEffectiveUserID 65534) (setEffectiveUserID 0) action else action

-- | File names that a scene may hold: letters of several alphabets, and blanks inside.
fileName :: Gen String
fileName = do
  stem <- resize 12 (listOf1 (elements "abXYZ09_-\233\200\223\322\1046"))
  inner <- elements ["", " ", ".", " 2."]
  ending <- elements ["obj", "TXT", "Png"]
  pure (stem <> inner <> stem <> "." <> ending)

-- | The name as somebody else may have written it.
disguised :: String -> Gen String
disguised stored = do
  cased <- elements [id, map toLower, Text.unpack . Text.toUpper . Text.pack, map swapped]
  folders <- listOf (elements ["a", "C:", "..", "mes mod\232les", ""])
  separator <- elements ["/", "\\"]
  blanks <- vectorOf 2 (elements ["", " ", "\t", "  "])
  pure (intercalate (concatMap (<> separator) folders <> cased stored) blanks)
  where
    swapped c = if c == toLower c then toUpper c else toLower c

-- | A few files of which some have the name, here and there.
tree :: Gen [FilePath]
tree = sublistOf [folder <> file | folder <- ["", "a/", "models/", "scenes/", "c/d/"], file <- ["b.obj", "B.OBJ", "other"]]
