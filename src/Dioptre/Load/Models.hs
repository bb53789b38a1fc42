{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Load.Models
-- Description : From the names of models to a library
--
-- >  scene.txt                                      library
-- >    model file tower.msr                           0  brick.obj      triangles, finishes
-- >    model file brick.obj   scale ...               1  tower.msr      instances of 0, and a roof
-- >    model file Brick.OBJ   rotation ...          scene: instances of 1, 0, 0
-- >  tower.msr
-- >    model file brick.obj   (forty times)
-- >    primitive ...
--
-- A model becomes part of the library when everything that it names has, so that each holds only models with lower
-- numbers. What a model is does not depend on who names it, with one exception, the @uv_format@: a file has that of the
-- first model that names it, in the order in which the files are read.
module Dioptre.Load.Models
  ( Site,
    sceneSite,
    loadModels,

    -- * Limits
    deepestModels,
    mostParts,
  )
where

import Control.Exception (evaluate)
import Control.Monad (unless, when)
import Control.Monad.IO.Class (liftIO)
import Control.Monad.ST (stToIO)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.State.Strict (StateT, get, gets, modify', runStateT)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.Foldable (toList)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, mapMaybe)
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import qualified Data.Set as Set
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Vector (Vector)
import qualified Data.Vector as Vector
import Dioptre.Files.Fault (FileFault)
import Dioptre.Files.Pieces (readPieces)
import Dioptre.Files.Whole (readPlain)
import Dioptre.Files.Wording (fileFault)
import Dioptre.Geometry.Mesh (meshSize)
import Dioptre.Light.Finish (Finish, hasPictures, withPictures)
import Dioptre.Load.Amount (Amount (..), ModelRead (..))
import Dioptre.Load.Shelf
import Dioptre.Model.Agp (readAgp)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..))
import Dioptre.Model.Msr (Msr (..), readMsr)
import Dioptre.Model.Mtl (Mtl (..), finishesOf, readMtl)
import Dioptre.Model.Obj (Named (..), Obj (..))
import qualified Dioptre.Model.Obj as Obj
import Dioptre.Picture (Picture)
import Dioptre.Render.Texture (Texture (..), Upward (..))
import Dioptre.Scene.Check (Mention (..))
import Dioptre.Scene.Model (Model (..), UvFormat (..), uvFormatName)
import Dioptre.Source.Diagnostic (Diagnostic (..), FileTrouble (..), FileUse (..), Problem (..))
import Dioptre.Source.Language (Language)
import Dioptre.Source.Span (Span)
import Dioptre.Source.Text (Source, decode, excerpts)
import Dioptre.Syntax.Grammar (parse)
import System.FilePath (takeDirectory, takeExtension)

-- | Where models are named: in which file, and how deep.
data Site = Site
  { -- | In which messages are.
    siteLanguage :: Language,
    -- | The folder of the file.
    siteFolder :: FilePath,
    -- | How high the models there may be.
    siteRoom :: Int,
    -- | The models that are being read, the file itself first and the one that the scene names last.
    siteOpen :: [Found]
  }

-- | A scene in a folder.
sceneSite :: Language -> FilePath -> Site
sceneSite l folder = Site l folder deepestModels []

-- | Inside a model's file.
inside :: Found -> Site -> Site
inside file site = Site (siteLanguage site) (takeDirectory (foundPath file)) (deepestModels - 1) (file : siteOpen site)

-- | Models stand in models so deep, at most.
--
-- Spec: models.limits, limits.language.
deepestModels :: Int
deepestModels = 64

-- | A scene has so many shapes and triangles of models, at most, however few of them are in memory: 2^48.
--
-- Spec: models.limits, limits.language.
mostParts :: Integer
mostParts = 2 ^ (48 :: Int)

-- | What has been placed in a file so far.
data Account = Account
  { -- | How many shapes and triangles.
    accountSize :: !Integer,
    -- | The height of the highest model.
    accountHeight :: !Int,
    -- | What there is to say of the places that name models.
    accountDiagnostics :: Seq Diagnostic
  }

-- | Work that places models in a file.
type Placing = StateT Account Loading

-- | The models that a scene names, each placed or left out; and what there is to say of the places that name them.
--
-- Spec: code.files, models.order.
loadModels :: Site -> [Mention] -> Loading ([Instance], [Diagnostic])
loadModels site mentions = do
  (placed, account) <- runStateT (traverse (place site) mentions) (Account 0 0 Seq.empty)
  pure (catMaybes placed, toList (accountDiagnostics account))

-- | The model that is named there, if it can be read and there is room for it.
--
-- Spec: models.empty, models.uv-format, models.limits.
place :: Site -> Mention -> Placing (Maybe Instance)
place site mention = case modelFile model of
  -- That it names no file has been told.
  Nothing -> pure Nothing
  Just name ->
    lift (modelNamed site name (modelUvFormat model)) >>= \case
      Left problem -> Nothing <$ complain (mentionFile mention) problem
      Right shelved -> do
        account <- get
        case obstacle name account shelved of
          Just problem -> Nothing <$ complain (mentionFile mention) problem
          Nothing -> do
            modify' (\a -> a {accountSize = accountSize a + shelvedSize shelved, accountHeight = max (accountHeight a) (shelvedHeight shelved)})
            when (shelvedIsEmpty shelved) $ complain (mentionFile mention) (EmptyModel name)
            when (shelvedHasPictures shelved && upward (modelUvFormat model) /= upward (shelvedUvFormat shelved)) $
              mapM_ (`complain` DifferingUvFormat name (uvFormatName (shelvedUvFormat shelved))) (mentionUvFormat mention)
            pure (Just (Instance (shelvedNumber shelved) (modelTransform model)))
  where
    model = mentionModel mention
    obstacle name account shelved
      | shelvedHeight shelved > siteRoom site = Just (ModelTooDeep name deepestModels)
      | accountSize account + shelvedSize shelved > mostParts = Just (TooManyParts name mostParts)
      | otherwise = Nothing

-- | Notes what is wrong with a place that names a model.
complain :: Span -> Problem -> Placing ()
complain where' problem = modify' (\a -> a {accountDiagnostics = accountDiagnostics a |> Diagnostic where' problem})

-- | How v runs over the pictures of a model.
--
-- Spec: models.uv-format.
upward :: UvFormat -> Upward
upward = \case
  UvDefault -> FromFirstRow
  UvTopLeft -> FromFirstRow
  UvBottomLeft -> FromLastRow

-- | The format of a model, by the ending of its file's name.
data Format = ObjFormat | MsrFormat | AgpFormat

-- | The format that a name has, if it is one of those.
--
-- Spec: models.format.
formatOf :: Text -> Maybe Format
formatOf name = case takeExtension (Text.unpack (Text.toLower (Text.strip name))) of
  ".obj" -> Just ObjFormat
  ".msr" -> Just MsrFormat
  ".agp" -> Just AgpFormat
  _ -> Nothing

-- | The model that a name and a @uv_format@ mean, from the shelf or from its file; or what is the matter with it.
--
-- Spec: models.format, models.nested.
modelNamed :: Site -> Text -> UvFormat -> Loading (Either Problem Shelved)
modelNamed site name uvFormat = case formatOf name of
  Nothing -> pure (Left (UnknownModelFormat name))
  Just format ->
    findFile (siteFolder site) name >>= \case
      Left trouble -> pure (Left (unusable trouble))
      Right file -> case break ((== foundFile file) . foundFile) (siteOpen site) of
        (between, again : _) -> pure (Left (ModelCycle (map foundPath (again : reverse between <> [file]))))
        (_, []) ->
          either (Left . unusable) Right
            <$> once shelfModels (\m shelf -> shelf {shelfModels = m}) (foundFile file) (loadModel site file uvFormat format)
  where
    unusable = UnusableFile name ForModel

-- | Reads a model, and what it names.
loadModel :: Site -> Found -> UvFormat -> Format -> Loading (Either FileTrouble Shelved)
loadModel site file uvFormat = \case
  MsrFormat -> whole l path >>= traverse (loadMsr (inside file site) file uvFormat . decode path)
  AgpFormat -> whole l path >>= traverse (loadAgp file uvFormat . decode path)
  ObjFormat -> streamed l path >>= traverse (loadObj (inside file site) file uvFormat)
  where
    l = siteLanguage site
    path = foundPath file

-- | A model in the scene language becomes part of the library, after those that it names.
--
-- Spec: models.nested.
loadMsr :: Site -> Found -> UvFormat -> Source -> Loading Shelved
loadMsr site file uvFormat source = do
  let msr = readMsr (parse source)
      content = msrContent msr
      own = length [() | Solid _ _ <- contentParts content]
  (pictures, missing) <- loadPictures (siteLanguage site) (siteFolder site) [(name, ForTexture, span') | (name, span') <- msrPictures msr]
  (parts, account) <- runStateT (traverse (traverse (place site)) (contentParts content)) (Account (toInteger own) 0 Seq.empty)
  amountIn file (Primitives own)
  faultsOf source (msrDiagnostics msr <> missing <> toList (accountDiagnostics account))
  shelve uvFormat (null (contentParts content)) account (mapMaybe sequenceA parts) (Vector.map (withPictures (`Map.lookup` pictures)) (contentFinishes content))

-- | Strokes become part of the library.
loadAgp :: Found -> UvFormat -> Source -> Loading Shelved
loadAgp file uvFormat source = do
  let (Content parts finishes, diagnostics) = readAgp source
      tubes = length parts
  amountIn file (Tubes tubes)
  faultsOf source diagnostics
  shelve uvFormat (tubes == 0) (Account (toInteger tubes) 0 Seq.empty) parts (Vector.map (withPictures (const Nothing)) finishes)

-- | A mesh becomes part of the library, with the materials that its libraries have for it.
--
-- Spec: models.obj.unknown-material.
loadObj :: Site -> Found -> UvFormat -> Obj -> Loading Shelved
loadObj site file uvFormat obj = do
  libraries <- traverse (\named -> (,) named <$> loadMaterials site (namedText named)) (objLibraries obj)
  let missing = [Diagnostic (namedSpan named) (UnusableFile (namedText named) ForMaterialLibrary trouble) | (named, Left trouble) <- libraries]
      triangles = meshSize (objMesh obj)
      (finishes, unknown) = Set.fromList <$> finishesOf [mtl | (_, Right mtl) <- libraries] (map namedText (objMaterials obj))
      unnamed = [Diagnostic (namedSpan named) (UnknownMaterialOfModel (namedText named)) | named <- objMaterials obj, namedText named `Set.member` unknown]
  amountIn file (Polygons (objCounts obj))
  faultsOf (excerpts (foundPath file) (objLines obj)) (objDiagnostics obj <> missing <> unnamed)
  shelve uvFormat (triangles == 0) (Account (toInteger triangles) 0 Seq.empty) [Faces (objMesh obj)] (Vector.fromList finishes)

-- | The materials of the library of that name, with their pictures, by their names.
loadMaterials :: Site -> Text -> Loading (Either FileTrouble (Mtl Picture))
loadMaterials site name =
  findFile (siteFolder site) name >>= \case
    Left trouble -> pure (Left trouble)
    Right file -> once shelfMaterials (\m shelf -> shelf {shelfMaterials = m}) (foundFile file) $ do
      bytes <- whole (siteLanguage site) (foundPath file)
      traverse (library file . decode (foundPath file)) bytes
  where
    library file source = do
      let (Mtl named nameless, diagnostics) = readMtl source
          wanted = [(namedText n, ForTexture, namedSpan n) | f <- toList named <> toList nameless, n <- toList f]
      (pictures, missing) <- loadPictures (siteLanguage site) (takeDirectory (foundPath file)) wanted
      faultsOf source (diagnostics <> missing)
      let look = withPictures ((`Map.lookup` pictures) . namedText)
      pure (Mtl (look <$> named) (look <$> nameless))

-- | Puts a model into the library, of which is known whether its file is empty.
--
-- Spec: models.empty, models.materials.
shelve :: UvFormat -> Bool -> Account -> [Part Instance] -> Vector (Finish Picture) -> Loading Shelved
shelve uvFormat isEmpty account parts finishes = do
  number <- gets (Seq.length . shelfLibrary)
  modify' (\shelf -> shelf {shelfLibrary = shelfLibrary shelf |> Content parts (Vector.map (fmap (Texture (upward uvFormat))) finishes)})
  pure (Shelved number isEmpty (accountSize account) (accountHeight account + 1) uvFormat (any hasPictures finishes))

-- | Keeps what is wrong with a file, in its order. The text of one without faults is not kept.
faultsOf :: Source -> [Diagnostic] -> Loading ()
faultsOf source faults = unless (null faults) $ modify' (\shelf -> shelf {shelfFaults = shelfFaults shelf |> (source, sortOn diagnosticSpan faults)})

-- | Keeps how much is in a model's file.
amountIn :: Found -> Amount -> Loading ()
amountIn file amount = do
  noted <- liftIO (evaluate (ModelRead (foundPath file) amount))
  modify' (\shelf -> shelf {shelfRead = shelfRead shelf |> noted})

-- | A file's bytes, all of them.
whole :: Language -> FilePath -> Loading (Either FileTrouble ByteString)
whole l path = liftIO (readable l <$> readPlain path)

-- | What is in an OBJ file, of which a piece at a time is in memory.
streamed :: Language -> FilePath -> Loading (Either FileTrouble Obj)
streamed l path = liftIO $ do
  reader <- stToIO Obj.newReader
  outcome <- readPieces path (stToIO . Obj.feed reader)
  readable l <$> traverse (const (stToIO (Obj.finish reader))) outcome

-- | Why a file cannot be read, in words.
readable :: Language -> Either FileFault a -> Either FileTrouble a
readable l = first (Unreadable . fileFault l)
