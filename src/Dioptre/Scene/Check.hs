{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Check
-- Description : From what a file says to what it means
--
-- The stage that turns a syntax tree into a scene. It never fails: every fault becomes a diagnostic with its place, in one
-- pass, and what was wrong is replaced by what stood before it or by the default, so that there is always a picture.
module Dioptre.Scene.Check
  ( checkScene,
    pictureNames,
    sceneWords,
  )
where

import Control.Monad (foldM, unless, when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.State.Strict (evalStateT, get, modify')
import Data.Foldable (for_, toList, traverse_)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust)
import Data.Sequence (Seq, (|>))
import qualified Data.Sequence as Seq
import qualified Data.Set as Set
import Data.Text (Text)
import Dioptre.Light.Light (Light)
import Dioptre.Light.Material (Material (..), substitute)
import Dioptre.Scene (Scene (..))
import Dioptre.Scene.Camera (Camera, Viewport, cameraSchema, defaultCamera, defaultViewport, viewportSchema)
import Dioptre.Scene.Lights (readLight)
import Dioptre.Scene.Materials (materialSchema, textureMaterialSchema)
import Dioptre.Scene.Primitive (Model, Primitive (..), modelSchema, primitiveSchema)
import Dioptre.Scene.Raytracer (PixelCoordinate (Random), Raytracer (..), defaultRaytracer, raytracerSchema)
import Dioptre.Scene.Schema (Check, Schema, misfit, passOver, placeOfValue, readObject, report, runCheck)
import Dioptre.Scene.Shapes (readShape)
import Dioptre.Source.Diagnostic (Diagnostic, FileUse (..), PassedOver (TheLine), Problem (..))
import Dioptre.Source.Span (Span (..))
import Dioptre.Syntax.Keyword (Keyword, Role (OpensInScene), role)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Spelling (suggest)
import Dioptre.Syntax.Tree (Block (..), Head (..), Node (..), Property (..), Tree, Value (..))

-- | The scene that a tree describes, and all that is wrong with the file, in its order.
--
-- Law: checking what was written from a scene gives that scene.
checkScene :: Tree -> (Scene, [Diagnostic])
checkScene tree = runCheck (foldM item nothingYet tree >>= finish)

-- | What has been read of a scene so far. Things come with the block that they were read from, for what remains to be said of them.
data Draft = Draft
  { camera :: Maybe (Block, Camera),
    viewport :: Maybe (Block, Viewport),
    raytracer :: Maybe (Block, Raytracer),
    models :: Seq Model,
    primitives :: Seq (Block, Primitive),
    materials :: Seq (Block, Material),
    lights :: Seq Light
  }

nothingYet :: Draft
nothingYet = Draft Nothing Nothing Nothing Seq.empty Seq.empty Seq.empty Seq.empty

-- | One thing at the level of the file.
item :: Draft -> Node -> Check Draft
item draft = \case
  Object block -> object draft block
  Statement p -> draft <$ report (headSpan (propertyHead p)) (misfit Nothing sceneWords (propertyHead p) TheLine)
  LooseEnd word -> draft <$ report (headSpan word) (StrayEnd (headText word))
  OpenComment place -> draft <$ report place UnclosedComment

object :: Draft -> Block -> Check Draft
object draft block = case headKeyword (blockHead block) of
  Just Keyword.Camera -> alone cameraSchema camera (\c -> draft {camera = Just c})
  Just Keyword.Viewport -> alone viewportSchema viewport (\v -> draft {viewport = Just v})
  Just Keyword.Raytracer -> alone raytracerSchema raytracer (\r -> draft {raytracer = Just r})
  Just Keyword.Primitive -> among primitiveSchema (\p -> draft {primitives = primitives draft |> (block, p)})
  Just Keyword.Material -> among materialSchema (\m -> draft {materials = materials draft |> (block, m)})
  Just Keyword.TextureMaterial -> among textureMaterialSchema (\m -> draft {materials = materials draft |> (block, m)})
  Just Keyword.Model -> notDrawn >> among modelSchema (\m -> draft {models = models draft |> m})
  Just word | role word == OpensInScene -> maybe draft (\l -> draft {lights = lights draft |> l}) <$> readLight block
  _ -> draft <$ passOver Nothing sceneWords block
  where
    among :: Schema a b -> (b -> Draft) -> Check Draft
    among schema add = maybe draft add <$> readObject readShape schema block
    -- Of several, the last one that is possible counts.
    alone :: Schema a b -> (Draft -> Maybe (Block, b)) -> ((Block, b) -> Draft) -> Check Draft
    alone schema earlier put =
      readObject readShape schema block >>= \case
        Nothing -> pure draft
        Just made -> do
          for_ (earlier draft) $ \(before, _) ->
            report (headSpan (blockHead block)) (ReplacedObject (headText (blockHead block)) (spanLine (headSpan (blockHead before))))
          pure (put (block, made))
    notDrawn = report (headSpan (blockHead block)) (NotDrawnYet (headText (blockHead block)))

-- | The pictures that a scene names, where it names them, and what for. The name @none@ stands for none.
pictureNames :: Tree -> [(Text, FileUse, Span)]
pictureNames tree =
  [ (valueText value, use, valueSpan value)
    | Object block <- tree,
      Just (use, words') <- [headKeyword (blockHead block) >>= (`lookup` users)],
      Statement (Property word value) <- blockNodes block,
      valueText value `notElem` ["", "none"],
      Just True <- [(`elem` words') <$> headKeyword word]
  ]
  where
    users =
      [ (Keyword.TextureMaterial, (ForTexture, [Keyword.TextureKa, Keyword.TextureKd, Keyword.TextureKs])),
        (Keyword.ApertureMaskLight, (ForMask, [Keyword.Mask]))
      ]

-- | The words that may open an object of a scene.
sceneWords :: [Keyword]
sceneWords = filter ((== OpensInScene) . role) [minBound ..]

-- | What can be said when everything has been read.
finish :: Draft -> Check Scene
finish draft = do
  traverse_ (uncurry checkRaytracer) (raytracer draft)
  named <- checkMaterials (toList (materials draft))
  added <- checkMaterialNames named (toList (primitives draft))
  pure
    Scene
      { sceneCamera = maybe defaultCamera snd (camera draft),
        sceneViewport = maybe defaultViewport snd (viewport draft),
        sceneRaytracer = maybe defaultRaytracer snd (raytracer draft),
        sceneModels = toList (models draft),
        scenePrimitives = map snd (toList (primitives draft)),
        sceneMaterials = map snd (toList (materials draft)) <> added,
        sceneLights = toList (lights draft)
      }

checkRaytracer :: Block -> Raytracer -> Check ()
checkRaytracer block r =
  when (raytracerSampling r > 1 && raytracerPixelCoordinate r /= Random) $
    report (valueOrHead Keyword.Sampling block) (SamplingWithoutRandom (raytracerSampling r))

-- | Where a property's value stands, or else the word that opens the object.
valueOrHead :: Keyword -> Block -> Span
valueOrHead word block = fromMaybe (headSpan (blockHead block)) (placeOfValue word block)

-- | Of materials of one name the first counts. The names that there are.
checkMaterials :: [(Block, Material)] -> Check (Set.Set Text)
checkMaterials = fmap Map.keysSet . foldM step Map.empty
  where
    step seen (block, m) = case Map.lookup (materialName m) seen of
      Nothing -> pure (Map.insert (materialName m) place seen)
      Just first -> seen <$ report place (RepeatedMaterial (materialName m) (spanLine first))
      where
        place = valueOrHead Keyword.Name block

-- | A material that is named and not there is replaced by a grey one, which is added to the scene; said once a name.
checkMaterialNames :: Set.Set Text -> [(Block, Primitive)] -> Check [Material]
checkMaterialNames names ps = concat <$> evalStateT (traverse step ps) names
  where
    step (block, p) = do
      known <- get
      let name = primitiveMaterial p
          given = isJust (placeOfValue Keyword.MaterialName block)
      unless given (lift (report (headSpan (blockHead block)) NoMaterialName))
      if name `Set.member` known
        then pure []
        else do
          when given . lift $
            report (valueOrHead Keyword.MaterialName block) (MissingMaterial name (suggest (toList names) name))
          modify' (Set.insert name)
          pure [substitute name]
