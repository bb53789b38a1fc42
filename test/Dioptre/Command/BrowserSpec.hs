-- | A browser is opened without telling the page's secret to everybody.
module Dioptre.Command.BrowserSpec
  ( spec,
  )
where

import Control.Concurrent (threadDelay)
import Control.Exception (bracket)
import Data.List (isInfixOf, isPrefixOf)
import Dioptre.Command.Browser (withBrowser)
import Dioptre.Command.Heard (inFolder)
import System.Directory (createDirectory, doesFileExist, getCurrentDirectory, getPermissions, listDirectory, setOwnerExecutable, setPermissions)
import System.Environment (lookupEnv, setEnv, unsetEnv)
import System.FilePath (takeDirectory, (</>))
import System.Posix.Files (fileMode, getFileStatus, intersectFileModes)
import System.Timeout (timeout)
import Test.Hspec

spec :: Spec
spec = do
  it "starts the browser with a file that leads to the page, and that nobody else may read" . withScreen $ \folder -> do
    (opened, file, text, mode) <- withBrowser page $ \opened -> do
      file <- awaited (folder </> "started")
      (,,,) opened file <$> readFile file <*> (fileMode <$> getFileStatus (takeDirectory file))
    opened `shouldBe` True
    file `shouldSatisfy` not . isInfixOf "token"
    text `shouldSatisfy` isInfixOf ("url=" <> page <> "\"")
    intersectFileModes mode 0o77 `shouldBe` 0
    file `shouldSatisfy` isPrefixOf (folder </> "tmp")
    -- Nothing stays
    listDirectory (folder </> "tmp") >>= (`shouldBe` [])
  it "opens none where there is no screen" . withScreen $ \folder -> do
    mapM_ unsetEnv ["DISPLAY", "WAYLAND_DISPLAY"]
    withBrowser page pure >>= (`shouldBe` False)
    doesFileExist (folder </> "started") >>= (`shouldBe` False)
  it "opens none where the file cannot be written" . withScreen $ \folder -> do
    setEnv "TMPDIR" (folder </> "nowhere")
    withBrowser page pure >>= (`shouldBe` False)
  where
    page = "http://127.0.0.1:8000/#token=0123456789abcdef0123456789abcdef"

-- | In an empty folder, with a screen and a program that opens files: it notes what it was started with.
withScreen :: (FilePath -> IO ()) -> IO ()
withScreen act = inFolder $ do
  folder <- getCurrentDirectory
  path <- maybe "" (':' :) <$> lookupEnv "PATH"
  writeFile "xdg-open" ("#!/bin/sh\nprintf '%s\\n' \"$*\" >" <> folder </> "new" <> " && mv " <> folder </> "new" <> " " <> folder </> "started" <> "\n")
  getPermissions "xdg-open" >>= setPermissions "xdg-open" . setOwnerExecutable True
  createDirectory "tmp"
  withVariables [("PATH", folder <> path), ("DISPLAY", ":99"), ("WAYLAND_DISPLAY", ""), ("TMPDIR", folder </> "tmp")] (act folder)

-- | Does some work with other variables of the environment.
withVariables :: [(String, String)] -> IO a -> IO a
withVariables pairs act = bracket (traverse (\(name, value) -> (,) name <$> lookupEnv name <* setEnv name value) pairs) (mapM_ back) (const act)
  where
    back (name, old) = maybe (unsetEnv name) (setEnv name) old

-- | The line in a file, when it is there.
awaited :: FilePath -> IO String
awaited file = timeout 10000000 go >>= maybe (fail "nothing was started") pure
  where
    go = doesFileExist file >>= \there -> if there then takeWhile (/= '\n') <$> readFile file else threadDelay 5000 >> go
