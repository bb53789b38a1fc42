{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.OriginSpec
-- Description : From numbers to what was written
module Dioptre.Explain.OriginSpec (spec) where

import Control.Monad (void)
import Data.Maybe (fromMaybe)
import qualified Data.Vector as Vector
import Dioptre.Explain.Origin
import Dioptre.Explain.Story (Thing (..), Whereabouts (..))
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere)
import Dioptre.Light.Finish (finish)
import Dioptre.Light.Material (standard)
import Dioptre.Math.Transform (identity, transform)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..))
import qualified Dioptre.Syntax.Keyword as Keyword
import Laws.Shade (sceneOf)
import Laws.Story (shapesAreTheWorlds)
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  it "names primitives, shapes of models, and shapes of models in models, with their files" $
    [(thingWhereabouts t, thingKind t, thingTransformed t, thingMaterial t) | Just f <- map (find shapes) [0 .. 6], let t = foundThing f]
      `shouldBe` [ (OfScene 0, Keyword.Plane, False, Just "floor"),
                   (OfModel 0 0 (Just "ball.msr"), Keyword.Sphere, True, Nothing),
                   (OfModel 1 0 (Just "tower.msr"), Keyword.Cube, False, Nothing),
                   (OfModel 0 0 (Just "ball.msr"), Keyword.Sphere, True, Nothing),
                   (OfModel 0 0 (Just "ball.msr"), Keyword.Sphere, False, Nothing)
                 ]
  modifyMaxSuccess (const 60) $ prop "what is found under a number is what the world has there" shapesAreTheWorlds
  where
    shapes = directory ["ball.msr", "tower.msr"] (Library (Vector.fromList [ball, tower]) [Instance 0 moved, Instance 1 identity]) (sceneOf ["primitive", "material_name floor", "plane", "end", "end", "material", "name floor", "end"])
    moved = fromMaybe identity (transform 1 0 (V3 1 2 3))
    content parts = Content parts (Vector.singleton (void (finish standard)))
    ball = content [Solid s 0 | Just s <- [ASphere <$> sphere 0 1]] :: Content Instance ()
    tower = content (Nested (Instance 0 moved) : Nested (Instance 0 identity) : [Solid s 0 | Just s <- [ACube <$> cube 0 1]])
