-- |
-- Module      : Laws.Closest
-- Description : What a ray meets first
module Laws.Closest
  ( Among (..),
    worldOf,
    sceneOf,
    allHits,
    metIn,
    isFirstOfAll,
    holdsItsShapes,
    doesNotDependOnOrder,
    goesToTheFirstOfEquals,
    staysBelowTheBound,
    doesNotSeeBehind,
    materialsAreFirstOfName,
    amongCorners,
  )
where

import Data.List (sort, sortOn)
import Data.Maybe (catMaybes, listToMaybe)
import qualified Data.Text as Text
import Dioptre.Geometry.Plane (plane)
import Dioptre.Geometry.Prepared (parameters)
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Light.Finish (finish, withPictures)
import Dioptre.Light.Material (Material (..), standard)
import Dioptre.Model.Library (noModels)
import Dioptre.Render.Closest
import Dioptre.Render.Surface
import Dioptre.Render.World (World, world, worldOwn, worldSize)
import Dioptre.Scene.Camera (defaultCamera, defaultViewport)
import Dioptre.Scene.Primitive (Primitive (..))
import Dioptre.Scene.Raytracer (defaultRaytracer)
import Dioptre.Scene.Unchecked (Scene (..))
import Laws.Aim
import Laws.Draw
import Laws.Index (met)
import Linear.V3 (V3 (..))
import Test.QuickCheck

-- | Several shapes and a ray that is aimed at one of them. Some shapes are there twice, some touch, some are around
-- others.
data Among = Among [Shape] Ray
  deriving (Eq, Show)

instance Arbitrary Among where
  arbitrary = do
    kind <- elements [Few, Few, Full]
    n <- chooseInt (1, 7)
    first <- vectorOf n (elements [minBound ..] >>= \sort' -> if kind == Few then oneof [crispShape sort', shapeOf sort' kind] else shapeOf sort' kind)
    twice <- sublistOf first
    nested <- catMaybes <$> mapM (\s -> (\k -> carried id id (* k) s) <$> elements [0.5, 2, 1 + 2 ** (-52)]) (take 2 first)
    shapes <- shuffle (first ++ twice ++ nested)
    target <- elements shapes
    Among shapes <$> rayAt kind target
  shrink (Among shapes r) = [Among s r | s <- shrinkList (const []) shapes, not (null s)]

-- | The scene of some shapes, whose materials are named after their numbers.
sceneOf :: [Shape] -> Scene
sceneOf shapes =
  Scene
    { sceneCamera = defaultCamera,
      sceneViewport = defaultViewport,
      sceneRaytracer = defaultRaytracer,
      sceneModels = [],
      scenePrimitives = zipWith (Primitive . named) [0 :: Int ..] shapes,
      sceneMaterials = [standard {materialName = named i} | i <- [0 .. length shapes - 1]],
      sceneLights = []
    }
  where
    named = Text.pack . show

-- | The world of some shapes.
worldOf :: [Shape] -> World
worldOf = world mempty noModels . sceneOf

-- | What is met first in a world, below a bound.
metIn :: World -> Ray -> Double -> Maybe (Double, Int)
metIn w r bound = met (closest w r bound)

-- | All hits of all shapes ahead, below a bound, sorted: those at the same parameter in the order of the shapes.
allHits :: [Shape] -> Ray -> Double -> [(Double, Int)]
allHits shapes r bound = sort [(t, i) | (i, shape) <- zip [0 ..] shapes, t <- parameters (preparedOf shape) r, t > 1e-8, t < bound]

-- | The closest hit is the first of all hits of all shapes, sorted.
isFirstOfAll :: Among -> Property
isFirstOfAll (Among shapes r) = conjoin [counterexample (show b) (metIn (worldOf shapes) r b === listToMaybe (allHits shapes r b)) | b <- [1 / 0, 100, 1]]

-- | A world has the scene's shapes, prepared, in their order, and no others.
holdsItsShapes :: Among -> Property
holdsItsShapes (Among shapes _) = [prepared <$> surfaceAt w i | i <- [-1 .. length shapes]] === [Nothing] ++ map (Just . preparedOf) shapes ++ [Nothing] .&&. worldSize w === length shapes
  where
    w = worldOf shapes
    prepared (Surface shape _) = shape

-- | The parameter of the closest hit does not depend on the order of the shapes, nor does the shape, if only one is
-- met there.
doesNotDependOnOrder :: Among -> Property
doesNotDependOnOrder (Among shapes r) = forAll (shuffle (zip [0 ..] shapes)) $ \shuffled ->
  case (metIn (worldOf shapes) r (1 / 0), metIn (worldOf (map snd shuffled)) r (1 / 0)) of
    (Nothing, Nothing) -> property True
    (Just (t, i), Just (t', j)) -> t === t' .&&. (length (filter ((== t) . fst) (allHits shapes r (1 / 0))) > 1 .||. fmap fst (at j shuffled) === Just i)
    other -> counterexample (show other) False
  where
    at j xs = if j < length xs then Just (xs !! j) else Nothing

-- | Of several shapes at the same parameter the first of the scene is met: of copies of one shape the first.
goesToTheFirstOfEquals :: Aimed -> Property
goesToTheFirstOfEquals (Aimed shape r) = forAll (elements [2, 3, 5, 9, 40]) $ \n ->
  metIn (worldOf (replicate n shape)) r (1 / 0) === metIn (worldOf [shape]) r (1 / 0)

-- | Nothing is met at the bound or beyond; a hit is met as soon as the bound is the next larger number.
staysBelowTheBound :: Among -> Property
staysBelowTheBound (Among shapes r) = case metIn w r (1 / 0) of
  Nothing -> property (not (any ahead (concatMap (\s -> parameters (preparedOf s) r) shapes)))
  Just (t, i) -> metIn w r t === Nothing .&&. metIn w r (nudged 1 t) === Just (t, i) .&&. metIn w r 1e-8 === Nothing .&&. metIn w r 0 === Nothing
  where
    w = worldOf shapes
    ahead t = t > 1e-8

-- | Nothing is met at 1e-8 or before, and so nothing behind the origin and not the surface on which the ray starts: a
-- plane across the x axis at x = t is met at t by the ray along the axis, if t is greater than 1e-8.
doesNotSeeBehind :: Among -> Property
doesNotSeeBehind (Among shapes r) =
  conjoin
    [ counterexample (show here) (maybe True ((> 1e-8) . fst) here),
      map (fmap (\w -> metIn w alongTheAxis 1) . planeAt) [0, 1e-9, nudged (-1) 1e-8, 1e-8, -1, -1e-8] === replicate 6 (Just Nothing),
      map (fmap (\w -> metIn w alongTheAxis 1) . planeAt) [nudged 1 1e-8, 1.5e-8, 0.5] === map (\t -> Just (Just (t, 0))) [nudged 1 1e-8, 1.5e-8, 0.5]
    ]
  where
    here = metIn (worldOf shapes) r (1 / 0)
    alongTheAxis = ray 0 (V3 1 0 0)
    planeAt t = (\p -> worldOf [APlane p]) <$> plane (V3 t 0 0) (V3 1 0 0)

-- | A shape takes the first of the materials of its name. (A scene has one for each: the checker puts a grey one where
-- there is none.)
materialsAreFirstOfName :: Among -> Property
materialsAreFirstOfName (Among shapes _) = forAll (vectorOf 6 (elements "abc")) $ \names -> forAll (vectorOf (length shapes) (elements names)) $ \asked ->
  let materials = [standard {materialName = Text.singleton c, materialShininess = k} | (c, k) <- zip names [1 ..]]
      w = world mempty noModels scene
      scene = (sceneOf shapes) {sceneMaterials = materials, scenePrimitives = zipWith (Primitive . Text.singleton) asked shapes}
      expected c = take 1 (sortOn materialShininess (filter ((== Text.singleton c) . materialName) materials))
      -- These materials have no pictures.
      plain = map (withPictures (const Nothing) . finish) . expected
   in [finishAt w i | i <- [-1 .. length shapes]] === [Nothing] ++ map Just (concatMap plain asked) ++ [Nothing] .&&. worldOwn w === length shapes

-- | What the generator of 'Among' must reach.
amongCorners :: Among -> [(String, Bool)]
amongCorners (Among shapes r) =
  [ ("nothing ahead", null hits),
    ("something ahead and something behind", not (null hits) && any (< 0) everything),
    ("several shapes at the closest parameter", length (filter ((== fmap fst (first hits)) . Just . fst) hits) > 1),
    ("the first hit is not the first shape's", maybe False ((> 0) . snd) (first hits))
  ]
  where
    hits = allHits shapes r (1 / 0)
    everything = concatMap (\s -> parameters (preparedOf s) r) shapes
    first xs = case xs of
      x : _ -> Just x
      [] -> Nothing
