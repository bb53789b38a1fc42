{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Check
-- Description : From what a file says to what it means
--
-- The stage that turns a syntax tree into a scene. It never fails: every fault becomes a diagnostic with its place, in
-- one pass, and what was wrong is replaced by what stood before it or by the default, so that there is always a
-- picture.
--
-- A model can be written in the same language: primitives, materials and other models, without a camera or lights.
module Dioptre.Scene.Check
  ( -- * Scenes
    checkScene,
    checkSceneFile,
    sceneWords,

    -- * Models in the scene language
    ModelFile (..),
    checkModelFile,
    modelWords,

    -- * Other files that they name
    Mention (..),
    pictureNames,
  )
where

import Control.Monad (foldM, unless, when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.State.Strict (evalStateT, get, modify')
import Data.Foldable (for_, toList, traverse_)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, listToMaybe)
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import qualified Data.Set as Set
import Data.Text (Text)
import Dioptre.Light.Light (Light)
import Dioptre.Light.Material (Material (..), substitute)
import Dioptre.Scene.Camera (Camera, Viewport, cameraSchema, defaultCamera, defaultViewport, viewportSchema)
import Dioptre.Scene.Form (Form (..), fileName)
import Dioptre.Scene.Lights (readLight)
import Dioptre.Scene.Materials (materialSchema, textureMaterialSchema)
import Dioptre.Scene.Model (Model, modelSchema)
import Dioptre.Scene.Primitive (Primitive (..), primitiveSchema)
import Dioptre.Scene.Raytracer (PixelCoordinate (Random), Raytracer (..), defaultRaytracer, raytracerSchema)
import Dioptre.Scene.Reporting (Check, item, passOver, report, runCheck)
import Dioptre.Scene.Schema (Schema, placeOfValue, readObject)
import Dioptre.Scene.Unchecked (Scene (..))
import Dioptre.Source.Diagnostic (Diagnostic, FileUse (..), Problem (..))
import Dioptre.Source.Span (Span (..))
import Dioptre.Syntax.Keyword (Keyword, Role (OpensInScene), role)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Spelling (suggestName)
import Dioptre.Syntax.Tree (Block (..), Head (..), Node (..), Property (..), Tree, Value (..))

-- | The scene that a tree describes, and all that is wrong with the file, in its order.
--
-- Law: checking what was written from a scene gives that scene.
--
-- Spec: grammar.scene, check.total, check.empty, canonical.back.
checkScene :: Tree -> (Scene, [Diagnostic])
checkScene tree = (scene, diagnostics)
  where
    (scene, _, diagnostics) = checkSceneFile tree

-- | The same, with the places where the scene's models are named, in their order.
checkSceneFile :: Tree -> (Scene, [Mention], [Diagnostic])
checkSceneFile tree = (scene, mentions, diagnostics)
  where
    ((scene, mentions), diagnostics) = runCheck (foldM (item sceneWords object) nothingYet tree >>= finish)

-- | The model that a tree describes, and all that is wrong with the file, in its order.
--
-- Spec: models.msr.
checkModelFile :: Tree -> (ModelFile, [Diagnostic])
checkModelFile tree = runCheck $ do
  stock <- foldM (item modelWords into) emptyStock tree
  ModelFile (parts stock) <$> furnished stock
  where
    into stock block = fromMaybe (stock <$ passOver Nothing modelWords block) (stocked block stock)
    parts stock =
      map snd . sortOn fst $
        [(placeOf block, Right p) | (block, p) <- toList (primitives stock)]
          <> [(placeOf block, Left (mention block m)) | (block, m) <- toList (models stock)]
    placeOf = headSpan . blockHead

-- | What a model in the scene language holds.
--
-- Invariant: every primitive's material is one of the materials, by name; of several of one name the first.
data ModelFile = ModelFile
  { -- | Other models and primitives, in the order of the file.
    modelFileParts :: [Either Mention Primitive],
    modelFileMaterials :: [Material]
  }
  deriving stock (Eq, Show)

-- | A model that a file names, and where it does.
data Mention = Mention
  { mentionModel :: Model,
    -- | Where the name of its file stands, or else the word that opens it.
    mentionFile :: Span,
    -- | Where its @uv_format@ stands, if it has one.
    mentionUvFormat :: Maybe Span
  }
  deriving stock (Eq, Show)

mention :: Block -> Model -> Mention
mention block m = Mention m (valueOrHead Keyword.File block) (placeOfValue Keyword.UvFormat block)

-- | What has been read of a scene so far. Things come with the block that they were read from, for what remains to be
-- said of them.
data Draft = Draft
  { camera :: Maybe (Block, Camera),
    viewport :: Maybe (Block, Viewport),
    raytracer :: Maybe (Block, Raytracer),
    things :: Stock,
    lights :: Seq Light
  }

-- | The part of it that models have as well.
data Stock = Stock
  { models :: Seq (Block, Model),
    primitives :: Seq (Block, Primitive),
    materials :: Seq (Block, Material)
  }

nothingYet :: Draft
nothingYet = Draft Nothing Nothing Nothing emptyStock Seq.empty

emptyStock :: Stock
emptyStock = Stock Seq.empty Seq.empty Seq.empty

-- | What a scene has in common with a model, with one more object; 'Nothing' for an object of another kind.
--
-- Spec: code.no-model-file, scene.order.
stocked :: Block -> Stock -> Maybe (Check Stock)
stocked block stock = case headKeyword (blockHead block) of
  Just Keyword.Primitive -> Just (among primitiveSchema (\p -> stock {primitives = primitives stock |> (block, p)}))
  Just Keyword.Material -> Just (among materialSchema (\m -> stock {materials = materials stock |> (block, m)}))
  Just Keyword.TextureMaterial -> Just (among textureMaterialSchema (\m -> stock {materials = materials stock |> (block, m)}))
  Just Keyword.Model -> Just (among modelSchema (\m -> stock {models = models stock |> (block, m)}) <* namesAFile)
  _ -> Nothing
  where
    among :: Schema a b -> (b -> Stock) -> Check Stock
    among schema add = maybe stock add <$> readObject schema block
    -- A name that was begun and is missing has been told.
    namesAFile = case listToMaybe [v | Statement (Property word v) <- reverse (blockNodes block), headKeyword word == Just Keyword.File] of
      Nothing -> report (headSpan (blockHead block)) NoModelFile
      Just v -> when (formRead fileName v == Right Nothing) (report (valueSpan v) NoModelFile)

-- Spec: code.replaced-object, object.several-possible.
object :: Draft -> Block -> Check Draft
object draft block = case headKeyword (blockHead block) of
  Just Keyword.Camera -> alone cameraSchema camera (\c -> draft {camera = Just c})
  Just Keyword.Viewport -> alone viewportSchema viewport (\v -> draft {viewport = Just v})
  Just Keyword.Raytracer -> alone raytracerSchema raytracer (\r -> draft {raytracer = Just r})
  Just word
    | Just more <- stocked block (things draft) -> (\stock -> draft {things = stock}) <$> more
    | role word == OpensInScene -> maybe draft (\l -> draft {lights = lights draft |> l}) <$> readLight block
  _ -> draft <$ passOver Nothing sceneWords block
  where
    -- Of several, the last one that is possible counts.
    alone :: Schema a b -> (Draft -> Maybe (Block, b)) -> ((Block, b) -> Draft) -> Check Draft
    alone schema earlier put =
      readObject schema block >>= \case
        Nothing -> pure draft
        Just made -> do
          for_ (earlier draft) $ \(before, _) ->
            report (headSpan (blockHead block)) (ReplacedObject (headText (blockHead block)) (spanLine (headSpan (blockHead before))))
          pure (put (block, made))

-- | The pictures that a scene names, where it names them, and what for.
--
-- Spec: models.texture.none, files.pictures.
pictureNames :: Tree -> [(Text, FileUse, Span)]
pictureNames tree =
  [ (name, use, valueSpan value)
    | Object block <- tree,
      Just (use, words') <- [headKeyword (blockHead block) >>= (`lookup` users)],
      Statement (Property word value) <- blockNodes block,
      Right (Just name) <- [formRead fileName value],
      Just True <- [(`elem` words') <$> headKeyword word]
  ]
  where
    users =
      [ (Keyword.TextureMaterial, (ForTexture, [Keyword.TextureKa, Keyword.TextureKd, Keyword.TextureKs])),
        (Keyword.ApertureMaskLight, (ForMask, [Keyword.Mask]))
      ]

-- | The words that may open an object of a scene.
--
-- Spec: check.file-level.
sceneWords :: [Keyword]
sceneWords = filter ((== OpensInScene) . role) [minBound ..]

-- | The words that may open an object of a model's file.
modelWords :: [Keyword]
modelWords = [Keyword.Primitive, Keyword.Material, Keyword.TextureMaterial, Keyword.Model]

-- | What can be said when everything has been read.
--
-- Spec: scene.order.
finish :: Draft -> Check (Scene, [Mention])
finish draft = do
  traverse_ (uncurry checkRaytracer) (raytracer draft)
  furniture <- furnished (things draft)
  pure
    ( Scene
        { sceneCamera = maybe defaultCamera snd (camera draft),
          sceneViewport = maybe defaultViewport snd (viewport draft),
          sceneRaytracer = maybe defaultRaytracer snd (raytracer draft),
          sceneModels = map snd (toList (models (things draft))),
          scenePrimitives = map snd (toList (primitives (things draft))),
          sceneMaterials = furniture,
          sceneLights = toList (lights draft)
        },
      map (uncurry mention) (toList (models (things draft)))
    )

-- | The materials that there are, and those that stand in for missing ones.
furnished :: Stock -> Check [Material]
furnished stock = do
  named <- checkMaterials (toList (materials stock))
  added <- checkMaterialNames named (toList (primitives stock))
  pure (map snd (toList (materials stock)) <> added)

-- Spec: code.sampling-without-random, camera.sampling.fixed.
checkRaytracer :: Block -> Raytracer -> Check ()
checkRaytracer block r =
  when (raytracerSampling r > 1 && raytracerPixelCoordinate r /= Random) $
    report (valueOrHead Keyword.Sampling block) (SamplingWithoutRandom (raytracerSampling r))

-- | Where a property's value stands, or else the word that opens the object.
valueOrHead :: Keyword -> Block -> Span
valueOrHead word block = fromMaybe (headSpan (blockHead block)) (placeOfValue word block)

-- | Of materials of one name the first counts. The names that there are.
--
-- Spec: code.repeated-material, scene.material.repeated.
checkMaterials :: [(Block, Material)] -> Check (Set.Set Text)
checkMaterials = fmap Map.keysSet . foldM step Map.empty
  where
    step seen (block, m) = case Map.lookup (materialName m) seen of
      Nothing -> pure (Map.insert (materialName m) place seen)
      Just first -> seen <$ report place (RepeatedMaterial (materialName m) (spanLine first))
      where
        place = valueOrHead Keyword.Name block

-- | A material that is named and not there is replaced by a grey one, which is added to the scene; said once a name.
--
-- Spec: code.missing-material, code.no-material-name, scene.material.name, scene.material.substitute.
checkMaterialNames :: Set.Set Text -> [(Block, Primitive)] -> Check [Material]
checkMaterialNames names ps = concat <$> evalStateT (traverse step ps) names
  where
    step (block, p) = do
      known <- get
      let name = primitiveMaterial p
          given = or [headKeyword word == Just Keyword.MaterialName | Statement (Property word _) <- blockNodes block]
      unless given (lift (report (headSpan (blockHead block)) NoMaterialName))
      if name `Set.member` known
        then pure []
        else do
          -- A name that is missing altogether has been told.
          for_ (placeOfValue Keyword.MaterialName block) $ \place ->
            lift (report place (MissingMaterial name (suggestName (toList names) name)))
          modify' (Set.insert name)
          pure [substitute name]
