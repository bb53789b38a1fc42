{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Explain.TellSpec
-- Description : Stories tell what the renderer does
module Dioptre.Explain.TellSpec (spec) where

import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Dioptre.Explain.Story
import Dioptre.Explain.Tell (mostKept, tell)
import Dioptre.Explain.Wording (storyText)
import Dioptre.Geometry.Cube (cube)
import Dioptre.Geometry.Shape (Shape (ACube))
import Dioptre.Light.Finish (finish, withPictures)
import Dioptre.Light.Material (standard)
import Dioptre.Math.Transform (identity)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..), noModels)
import Dioptre.Render.Radiance (Seen (..))
import Dioptre.Render.Row (colourAt, plan)
import Dioptre.Render.Tally (Tally (..))
import Dioptre.Scene.Raytracer (mostRays)
import Dioptre.Source.Language (Language (English))
import Laws.Shade (sceneOf)
import Laws.Story
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (checkCoverage, cover, property)

spec :: Spec
spec = do
  describe "the laws of stories" $ do
    prop "the colour explained is the colour rendered" colourIsTheRenderers
    modifyMaxSuccess (const 60) $ prop "in scenes with models as well" coloursOfModelsAreTheRenderers
    modifyMaxSuccess (const 60) $ prop "in sketches as well, and nothing is told outside of the picture" coloursOfSketchesAreTheRenderers
    prop "as many rays are told as are cast" asManyRaysAsCast
    prop "the verdicts account for the closest hit" verdictsAccountForTheHit
    prop "the shares are the sum" sharesAreTheSum
    prop "the shares follow from their ways" sharesFollowFromTheirWays
    prop "bounces obey the laws of optics" bouncesObeyTheLaws
  it "has seen mirrors, glass, pictures and shadows" . property . checkCoverage $ \p ->
    foldr (\(name, there) -> cover 2 there name) (property True) (picturedCorners p)
  it "counts what it does not look at in a world of a million shapes" $ do
    story <- storyOf crowd crowdScene
    let r = sampleRay (firstOf story)
        Seen colour _ = colourAt (plan mempty crowd crowdScene) 0 0
    storyShapes story `shouldBe` 1000001
    ([thingNumber (encounterThing e) | e <- rayEncounters r], rayPassed r, rayUntold r) `shouldBe` ([0, 1], 0, 999999)
    [thingWhereabouts (hitThing h) | Just h <- [rayHit r]] `shouldBe` [OfModel 0 0 Nothing]
    storyColour story `shouldBe` colour
  it "follows as many rays as the renderer between two mirrors, and no more" $ do
    story <- storyOf noModels mirrors
    let Seen colour (Tally _ _ cut) = colourAt (plan mempty noModels mirrors) 0 0
    (sampleFollowed (firstOf story), sampleCut (firstOf story), cut) `shouldBe` (mostRays, True, 1)
    storyColour story `shouldBe` colour
  it "keeps the first of many samples, and counts all of them in" $ do
    let many = sceneOf (view <> ["raytracer", "sampling 5000", "pixel_coordinate random", "end"] <> ball)
        Seen colour _ = colourAt (plan mempty noModels many) 0 0
    story <- storyOf noModels many
    length (storySamples story) `shouldBe` mostKept
    (storyColour story, storySeesNothing story) `shouldBe` (colour, False)
    let text = storyText English "s" story
    text `shouldSatisfy` Text.isInfixOf "5000 rays are cast through the pixel"
    text `shouldSatisfy` Text.isInfixOf "Of the other 4998 rays of the pixel the first 3998 are told with --format json."
  where
    ball = ["primitive", "material_name m", "sphere", "position 0 0 0", "ray 1", "end", "end", "material", "name m", "end"]
    storyOf library scene = maybe (fail "no story") pure (tell mempty [] library scene 0 0)
    firstOf story = case storySamples story of
      s : _ -> s
      [] -> error "a story without samples"
    view = ["camera", "position -5 0 0", "look_at 0 0 0", "up 0 0 1", "end", "viewport", "width 1", "height 1", "end", "raytracer", "recursive_level 1000000", "pixel_coordinate center", "end", "ambient_light", "end"]
    -- A cube, a hundred of them, a hundred of those, and again.
    crowd = Library (Vector.fromList [Content [Solid s 0 | Just s <- [ACube <$> cube 0 1]] finishes, hundred 0, hundred 1, hundred 2]) [Instance 3 identity]
    hundred n = Content (replicate 100 (Nested (Instance n identity))) finishes
    finishes = Vector.singleton (withPictures (const Nothing) (finish standard))
    crowdScene = sceneOf (view <> ["primitive", "material_name m", "plane", "position 9 0 0", "normal 1 0 0", "end", "end", "material", "name m", "end"])
    mirrors = sceneOf (view <> ["material", "name m", "kr 1", "end"] <> concat [["primitive", "material_name m", "plane", "position " <> x <> " 0 0", "normal 1 0 0", "end", "end"] | x <- ["-9", "9"]])
