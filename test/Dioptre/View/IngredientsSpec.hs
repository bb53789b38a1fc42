{-# LANGUAGE OverloadedStrings #-}

-- | The picture follows the files that the scene names, over real files in a real folder.
module Dioptre.View.IngredientsSpec (spec) where

import Control.Concurrent (threadDelay)
import Control.Concurrent.STM (atomically, modifyTVar', readTVarIO)
import Control.Monad (foldM_, forM_, unless, void)
import Data.ByteString (ByteString)
import qualified Data.ByteString.Lazy as Lazy
import Data.Maybe (fromMaybe, isNothing)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector.Storable as Storable
import Data.Word (Word8)
import Dioptre.Command.Heard (inFolder)
import Dioptre.Files.Contents (contents)
import Dioptre.Files.Whole (writeWhole)
import Dioptre.Load (Loaded (..), loadSource, loadedPlan)
import Dioptre.Picture (Picture, picture)
import qualified Dioptre.Picture.Png as Png
import Dioptre.Render (rendered)
import Dioptre.Source.Language (Language (English))
import Dioptre.Source.Text (fromText)
import Dioptre.View.Desk (Checked (..), Desk (..), hasErrors, typed)
import Dioptre.View.Frame (framePicture)
import Dioptre.View.Server (Settings (..), Viewer (..), withViewer)
import System.Directory (createDirectory, createDirectoryLink, createFileLink, removeDirectoryLink, removeFile, renameDirectory, renameFile)
import System.Timeout (timeout)
import Test.Hspec

spec :: Spec
spec = do
  describe "the picture is drawn anew when somebody" $ do
    it "saves a texture, in place or by a rename" . following textured [("t.png", red)] $
      [put "t.png" green, put "new.png" blue >> renameFile "new.png" "t.png", whole "t.png" red]
    it "removes a texture, and brings one again" . following textured [("t.png", red)] $
      [removeFile "t.png", put "t.png" green, renameFile "t.png" "away.png", put "new.png" blue >> renameFile "new.png" "t.png"]
    it "makes a file that was missing" . following (textured <> model "m.obj") [] $
      [put "t.png" red, put "m.obj" (triangle "1"), put "m.mtl" (paint "1 1 0" "")]
    it "saves a model, its materials, or their texture" . following (looking <> model "m.obj") [("m.obj", triangle "2"), ("m.mtl", paint "1 0 0" ""), ("u.png", red)] $
      [put "m.obj" (triangle "1"), put "m.mtl" (paint "0 1 0" ""), put "m.mtl" (paint "1 1 1" "map_Ka u.png\n"), put "u.png" blue, removeFile "m.mtl"]
    it "makes faults in a file, and mends them" . following (looking <> model "m.obj") [("m.obj", triangle "1"), ("m.mtl", paint "1 0 0" "")] $
      [put "m.mtl" (paint "1 0" ""), put "m.mtl" (paint "0 1 1" "map_Ka u.png\n"), put "u.png" green, put "m.obj" "f 1 2 3\n", put "m.obj" (triangle "2")]
    it "saves a model of primitives, or one inside of it" . following (looking <> model "a.msr") [("a.msr", Text.encodeUtf8 (model "b.msr")), ("b.msr", ball "1")] $
      [put "b.msr" (ball "0.5"), put "a.msr" (ball "2"), put "a.msr" (Text.encodeUtf8 (model "c.msr")), put "c.msr" (ball "1.5")]
    it "saves strokes" . following (looking <> model "k.agp") [("k.agp", "5 5 5\n-2 0 2\n0 1 0\n")] $
      [put "k.agp" "5 5 5\n-2 0 2\n1 0 1\n"]
    it "saves a file that is named in other letters, or by a path of another computer" . following (Text.replace "t.png" "C:\\pictures\\T.PNG" textured) [("t.png", red)] $
      [put "t.png" green]
    it "saves the file that a link leads to, or turns the link" $ do
      let linked = createDirectory "far" >> put "far/one.png" red >> put "far/two.png" green >> createFileLink "far/one.png" "t.png"
      followingAfter linked textured [] [put "far/one.png" blue, removeFile "t.png" >> createFileLink "far/two.png" "t.png", put "far/two.png" red]
    it "makes the folder models with a file in it" . following textured [] $
      [createDirectory "models" >> threadDelay 200000 >> put "models/t.png" green, put "t.png" red, removeFile "t.png"]
    it "changes folders" . following textured [("models/t.png", red), ("others/t.png", green)] $
      [renameDirectory "models" "old" >> renameDirectory "others" "models", put "models/t.png" blue]
    it "takes another of two files of one name away" . following textured [("models/t.png", red), ("scenes/T.png", green)] $
      [removeFile "models/t.png", put "scenes/T.png" blue]
    it "changes a folder that is a link" $ do
      let linked = createDirectory "one" >> createDirectory "two" >> put "one/t.png" red >> put "two/t.png" green >> createDirectoryLink "one" "models"
      followingAfter linked textured [] [put "one/t.png" blue, removeDirectoryLink "models" >> createDirectoryLink "two" "models"]
    it "types another name, and saves that file" $ do
      let other = Text.replace "t.png" "u.png" textured
      inFolder $ do
        put "t.png" red
        put "u.png" green
        viewing textured $ \viewer -> do
          first <- follows viewer textured Nothing
          atomically (modifyTVar' (viewerTable viewer) (typed 1 1 other))
          second <- follows viewer other (Just first)
          put "u.png" blue
          third <- follows viewer other (Just second)
          atomically (modifyTVar' (viewerTable viewer) (typed 1 1 textured))
          void (follows viewer textured (Just third))

  it "a file that is written in many pieces is not drawn for each, and one that nobody names is not drawn for" . inFolder $ do
    put "t.png" red
    viewing textured $ \viewer -> do
      _ <- follows viewer textured Nothing
      threadDelay 200000
      first <- deskFrames <$> desk viewer
      forM_ [1 .. 50 :: Int] $ \_ -> put "other.png" green >> threadDelay 2000
      threadDelay 300000
      others <- deskFrames <$> desk viewer
      others `shouldBe` first
      forM_ [1 .. 200 :: Int] $ \_ -> put "t.png" green >> threadDelay 2000
      _ <- follows viewer textured Nothing
      threadDelay 300000
      pieces <- deskFrames <$> desk viewer
      pieces - first `shouldSatisfy` (\n -> n > 0 && n <= 8)

-- | A scene whose picture is to follow its files while these things are done, one after the other.
following :: Text -> [(FilePath, ByteString)] -> [IO ()] -> Expectation
following = followingAfter (pure ())

-- | The same, when something was done before.
followingAfter :: IO () -> Text -> [(FilePath, ByteString)] -> [IO ()] -> Expectation
followingAfter prepare text files steps = inFolder $ do
  prepare
  forM_ files $ \(path, bytes) -> do
    let folder = takeWhile (/= '/') path
    unless (folder == path) (createDirectory folder)
    put path bytes
  viewing text $ \viewer -> do
    first <- follows viewer text Nothing
    foldM_ (\old step -> step >> follows viewer text (Just old)) first steps

-- | Runs a viewer of a scene in s.txt, which draws also while nobody looks.
viewing :: Text -> (Viewer -> IO a) -> IO a
viewing text act = do
  put "s.txt" (Text.encodeUtf8 text)
  withViewer (Settings Nothing English True (fromText "s.txt" text) True) act >>= either (fail . show) pure

-- | Waits until a viewer tells as many faults as there are in a text and the files now, and, if none is an error, shows
-- the picture that render draws, which is to be another one than before. Returns what is shown.
follows :: Viewer -> Text -> Maybe Picture -> IO Picture
follows viewer text old = do
  loaded <- loadSource English (fromText "s.txt" text)
  let faults = map (fmap length) (loadedDiagnostics loaded)
      expected = rendered (loadedPlan loaded)
      stays = if hasErrors (loadedDiagnostics loaded) then old else Nothing
  (isNothing stays && Just expected == old) `shouldBe` False
  eventually $ do
    now <- desk viewer
    there <- traverse framePicture (deskFinished now)
    pure (fmap (map (fmap length) . checkedDiagnostics) (deskChecked now) == Just faults && there == Just (fromMaybe expected stays))
  pure (fromMaybe expected stays)

-- | Waits until something holds, ten seconds at most.
eventually :: IO Bool -> IO ()
eventually holds = timeout 10000000 go >>= maybe (expectationFailure "the viewer does not follow") pure
  where
    go = holds >>= \yes -> unless yes (threadDelay 5000 >> go)

desk :: Viewer -> IO Desk
desk = readTVarIO . viewerTable

-- | Writes into a file.
put :: FilePath -> ByteString -> IO ()
put path = Lazy.writeFile path . Lazy.fromStrict

-- | Writes a file as a good editor does.
whole :: FilePath -> ByteString -> IO ()
whole path bytes = writeWhole path (contents (Lazy.fromStrict bytes)) >>= either (fail . show) pure

-- | A ball in a texture.
textured :: Text
textured = looking <> "texture_material\nname t\nka 1\ntexture_ka t.png\ntexture_kd t.png\nend\nprimitive\nmaterial_name t\nsphere\nposition 5 0 0\nray 1\nend\nend\n"

-- | A small picture.
looking :: Text
looking = "viewport\nwidth 12\nheight 9\nend\ncamera\nposition 0 0 0\nlook_at 5 0 0\nup 0 0 1\nend\nambient_light\ncolor 1 1 1\nend\n"

-- | A model in a scene, or in another model.
model :: Text -> Text
model name = "model\nfile " <> name <> "\nend\n"

-- | A model, and the materials that it has.
triangle :: ByteString -> ByteString
triangle y = "mtllib m.mtl\nusemtl a\nvt 0 0\nvt 1 0\nvt 0 1\nv 5 -3 -3\nv 5 " <> y <> " -3\nv 5 -1 2\nf 1/1 2/2 3/3\n"

paint :: ByteString -> ByteString -> ByteString
paint ambient more = "newmtl a\nKa " <> ambient <> "\n" <> more

-- | Another one.
ball :: ByteString -> ByteString
ball radius = "material\nname r\ncolor 1 0 0\nend\nprimitive\nmaterial_name r\nsphere\nposition 5 0 0\nray " <> radius <> "\nend\nend\n"

-- | Pictures of a pixel.
red, green, blue :: ByteString
red = pixel [255, 0, 0, 255]
green = pixel [0, 255, 0, 255]
blue = pixel [0, 0, 255, 255]

pixel :: [Word8] -> ByteString
pixel = Lazy.toStrict . Png.encode . picture 1 . Storable.fromList
