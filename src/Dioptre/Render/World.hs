{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE TupleSections #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.World
-- Description : A scene made ready for many rays
--
-- The prepared shapes of a scene with the finishes that they have, an index over them, and the questions that a ray tracer asks: what does this ray meet first, what
-- stands between this point and that light, what is this point inside of?
--
-- >  root ----- shapes:     plane                      without an end: always tried
-- >   |          |
-- >   |         boxes ----- sphere, cube, ...
-- >   |
-- >   +------- instances:   boxes ----- teapot at (0,0,5) ---+
-- >                           |                              +--> the teapot's triangles and their boxes, once
-- >                           +-------- teapot, upside down -+
--
-- Everything has a number: the primitives of the scene from 0, in its order, and behind them the shapes of each model instance, in the order of the models. The
-- answers do not depend on the index: of several shapes at one parameter the one with the lowest number is met, and whatever is counted up or multiplied is so in the
-- order of the numbers. (Law: as without any index.)
module Dioptre.Render.World
  ( World,
    world,
    worldSize,
    worldOwn,
    worldHasPictures,
    worldHasMedia,
    Extent (..),
    worldExtent,

    -- * The closest hit
    closest,

    -- * What is there
    Surface (..),
    surfaceAt,
    finishAt,

    -- * What stands between
    Obstacles (..),
    obstacles,

    -- * What is around
    surroundings,
  )
where

import Data.List (foldl', mapAccumL, sortOn)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, mapMaybe)
import Data.Primitive.PrimArray
import Data.Vector (Vector, (!?))
import qualified Data.Vector as Vector
import qualified Data.Vector.Unboxed as Unboxed
import Dioptre.Geometry.Bounds (Box, approach, ofShape, transformed)
import qualified Dioptre.Geometry.Bounds as Bounds
import Dioptre.Geometry.Closest (Closest (..), below, slightlyBeyond, tried, within)
import Dioptre.Geometry.Hierarchy (Hierarchy, Tried (..), descend, hierarchy, hierarchyBox, hierarchyDepth, hierarchyNodes, hierarchyOrder)
import Dioptre.Geometry.Mesh (meshFinishes, meshSize)
import Dioptre.Geometry.Placement (Placement, carriedBack, placement)
import Dioptre.Geometry.Prepared (Prepared, contains, isClosed, nearest, placedIn, prepare)
import Dioptre.Geometry.PreparedMesh (PreparedMesh, anyTriangle, closestTriangle, prepareMesh, preparedMesh, preparedMeshHierarchy, preparedTriangle)
import Dioptre.Geometry.Ray (Ray, ray)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Light.Finish (Finish, finish, hasPictures, isTransparent, withPictures)
import Dioptre.Light.Material (Material (..), substitute)
import Dioptre.Math.Transform (identity, inversePosition)
import Dioptre.Math.Vector (Point)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..))
import Dioptre.Render.Texture (Assets, Texture (..), Upward (..))
import Dioptre.Scene (Scene (..))
import Dioptre.Scene.Primitive (Primitive (..))
import Linear.V3 (V3 (..))

-- | All that rays can meet.
data World = World
  { root :: !Group,
    -- | How large it is.
    worldExtent :: Extent
  }

-- | How many shapes there are, those of models counted once for each instance.
worldSize :: World -> Int
worldSize = groupSize . root

-- | How many of them are the scene's own primitives, which have the first numbers.
worldOwn :: World -> Int
worldOwn = Vector.length . groupFinishes . root

-- | Whether any closed shape lets light through, so that refractive indices matter.
worldHasMedia :: World -> Bool
worldHasMedia = groupHasMedia . root

-- | Whether pictures stand in for any colours.
worldHasPictures :: World -> Bool
worldHasPictures = groupHasPictures . root

-- | How large a world is.
data Extent = Extent
  { -- | Shapes, triangles of models counted once for each instance.
    extentShapes :: !Int,
    -- | Triangles in memory.
    extentTriangles :: !Int,
    -- | Boxes of the index.
    extentBoxes :: !Int,
    -- | How many boxes are around one shape at most.
    extentDepth :: !Int
  }
  deriving stock (Eq, Show)

-- | Shapes and instances in one frame.
data Group = Group
  { groupShapes :: !(Arranged Prepared),
    -- | The finish of each shape, by its number.
    groupFinishes :: !(Vector (Finish Texture)),
    groupInstances :: !(Arranged Placed),
    -- | How many numbers the group takes: its shapes', and those in its instances.
    groupSize :: !Int,
    -- | Whether a closed shape in it lets light through.
    groupHasMedia :: !Bool,
    -- | Whether a picture stands in for a colour of anything in it.
    groupHasPictures :: !Bool,
    -- | How many boxes are around one of its shapes at most.
    groupDepth :: !Int
  }

-- | Things with boxes around them.
data Arranged a = Arranged
  { -- | By number.
    numbered :: !(Vector a),
    -- | By place in the hierarchy's order.
    things :: !(Vector a),
    boxes :: !Hierarchy,
    -- | Around all of them; 'Nothing' if one has no end, or there are none.
    around :: !(Maybe Box)
  }

-- | A model somewhere in a group: its first number there, where it is (nothing: where its file has it), and the model.
data Placed = Placed !Int !(Maybe Placement) !Body

-- | A model, or a part of one.
data Body
  = Triangles !PreparedMesh !(Vector (Finish Texture))
  | Assembly !Group

-------------------------------------------------------------------------------
-- Building

-- | The world of a scene with its pictures and models.
world :: Assets -> Library Texture -> Scene -> World
world assets library scene = World top (extentOf top (Vector.toList bodies))
  where
    top = group (mapMaybe thing (scenePrimitives scene)) (map instanced (libraryInstances library))
    thing p = shapeWith (finishOf (primitiveMaterial p)) (primitiveShape p)
    -- Every model once: an instance refers to it. A model is made of models with lower numbers.
    bodies = Vector.map (modelBody instanced) (libraryModels library)
    instanced i =
      ( if instanceTransform i == identity then Nothing else Just (placement (instanceTransform i)),
        fromMaybe (Assembly (group [] [])) (bodies !? instanceModel i)
      )
    finishOf name = fromMaybe (pictured (substitute name)) (Map.lookup name finishes)
    -- Of materials of one name the first counts.
    finishes = Map.fromListWith (\_ first -> first) [(materialName m, pictured m) | m <- sceneMaterials scene]
    pictured m = withPictures (\name -> Texture FromFirstRow <$> Map.lookup name assets) (finish m)

-- | A shape, prepared, with its box and its finish; 'Nothing' if it cannot be prepared.
shapeWith :: Finish Texture -> Shape -> Maybe (Maybe Box, Prepared, Finish Texture)
shapeWith f shape = (ofShape shape,,f) <$> prepare shape

-- | A model of a library, given its instances of other models.
modelBody :: (Instance -> (Maybe Placement, Body)) -> Content Instance Texture -> Body
modelBody instanced content = case contentParts content of
  [Faces mesh] -> Triangles (prepareMesh mesh) finishes
  parts ->
    Assembly $
      group
        [thing | Solid shape k <- parts, Just f <- [finishes !? k], Just thing <- [shapeWith f shape]]
        (concatMap inner parts)
  where
    finishes = contentFinishes content
    inner part = case part of
      Solid _ _ -> []
      Faces mesh -> [(Nothing, Triangles (prepareMesh mesh) finishes)]
      Nested i -> [instanced i]

-- | A group of shapes with their boxes and finishes, and of instances.
group :: [(Maybe Box, Prepared, Finish Texture)] -> [(Maybe Placement, Body)] -> Group
group shapes instances =
  Group
    { groupShapes = arrangedShapes,
      groupFinishes = Vector.fromList [f | (_, _, f) <- shapes],
      groupInstances = arrangedInstances,
      groupSize = size,
      groupHasMedia = or [isClosed s && isTransparent f | (_, s, f) <- shapes] || any (bodyHasMedia . snd) instances,
      groupHasPictures = or [hasPictures f | (_, _, f) <- shapes] || any (bodyHasPictures . snd) instances,
      groupDepth = max (hierarchyDepth (boxes arrangedShapes)) (hierarchyDepth (boxes arrangedInstances) + maximum (0 : map (bodyDepth . snd) instances))
    }
  where
    arrangedShapes = arranged [(b, s) | (b, s, _) <- shapes]
    arrangedInstances = arranged [(boxOf i, i) | i <- placed]
    (size, placed) = mapAccumL number (length shapes) (filter ((> 0) . bodySize . snd) instances)
    number next (place, body) = (next + bodySize body, Placed next place body)
    boxOf (Placed _ place body) = maybe id transformed place <$> bodyBox body

-- | How many shapes are in a body.
bodySize :: Body -> Int
bodySize (Triangles m _) = meshSize (preparedMesh m)
bodySize (Assembly g) = groupSize g

bodyDepth :: Body -> Int
bodyDepth (Triangles m _) = hierarchyDepth (preparedMeshHierarchy m)
bodyDepth (Assembly g) = groupDepth g

bodyHasMedia :: Body -> Bool
bodyHasMedia (Triangles _ _) = False
bodyHasMedia (Assembly g) = groupHasMedia g

bodyHasPictures :: Body -> Bool
bodyHasPictures (Triangles _ finishes) = any hasPictures finishes
bodyHasPictures (Assembly g) = groupHasPictures g

bodyBoxes :: Body -> Int
bodyBoxes (Triangles m _) = hierarchyNodes (preparedMeshHierarchy m)
bodyBoxes (Assembly g) = hierarchyNodes (boxes (groupShapes g)) + hierarchyNodes (boxes (groupInstances g))

extentOf :: Group -> [Body] -> Extent
extentOf top bodies =
  Extent
    { extentShapes = groupSize top,
      extentTriangles = sum [meshSize (preparedMesh m) | Triangles m _ <- bodies],
      extentBoxes = sum (map bodyBoxes (Assembly top : bodies)),
      extentDepth = groupDepth top
    }

-- | The box around a body; 'Nothing' if it has no end, or nothing in it.
bodyBox :: Body -> Maybe Box
bodyBox (Triangles m _) = hierarchyBox (preparedMeshHierarchy m)
bodyBox (Assembly g)
  | Vector.null (things (groupInstances g)) = around (groupShapes g)
  | Vector.null (things (groupShapes g)) = around (groupInstances g)
  | otherwise = Bounds.union <$> around (groupShapes g) <*> around (groupInstances g)

-- | So few things are tried one after the other: boxes around them would take as long as they save.
few :: Int
few = 8

-- | Things with their boxes, in their order, arranged.
arranged :: [(Maybe Box, a)] -> Arranged a
arranged list = Arranged (Vector.map snd pairs) (Vector.map (snd . (pairs Vector.!)) order) h outer
  where
    pairs = Vector.fromList list
    h = hierarchy (Vector.length pairs) (if Vector.length pairs > few then fst . (pairs Vector.!) else const Nothing)
    order = Vector.fromList (primArrayToList (hierarchyOrder h))
    outer = case traverse fst list of
      Just (b : bs) -> Just (foldl' Bounds.union b bs)
      _ -> Nothing

-------------------------------------------------------------------------------
-- The closest hit

-- | What a ray meets first, nearer than a bound.
--
-- Law: as sorting all the hits of all shapes and taking the first. Cost: like the logarithm of the number of shapes that have an end, where they are spread out.
closest :: World -> Ray -> Double -> Closest
closest w !r !bound
  | isSmall w = closestOfFew (numbered (groupShapes (root w))) r bound
  | otherwise = closestOfMany (root w) r bound
{-# INLINE closest #-}

-- | Whether a world is so small that everything in it is tried one after the other. The loop that does is copied to where it is used, so that nothing of it is ever in memory; with an index there is more to do than to
-- pass a ray on.
isSmall :: World -> Bool
isSmall w = hierarchyNodes (boxes (groupShapes (root w))) == 0 && Vector.null (things (groupInstances (root w)))
{-# INLINE isSmall #-}

closestOfFew :: Vector Prepared -> Ray -> Double -> Closest
closestOfFew shapes !r = go 0 (-1)
  where
    !count = Vector.length shapes
    -- In the order of their numbers the first of several at one parameter is kept. Numbers are below the number of shapes.
    go !i !number !best
      | i >= count = Closest best number count
      | otherwise = let !t = nearest (Vector.unsafeIndex shapes i) r best in if t < best then go (i + 1) i t else go (i + 1) number best
{-# INLINE closestOfFew #-}

closestOfMany :: Group -> Ray -> Double -> Closest
closestOfMany g r bound = closestInstance g r (closestShape g r (below bound))
{-# NOINLINE closestOfMany #-}

closestShape :: Group -> Ray -> Closest -> Closest
closestShape g r c = case descend (boxes (groupShapes g)) (approach r) within (closestInRange (groupShapes g) r) c of
  Tried found n -> tried n found

-- | The same for the shapes at some places.
closestInRange :: Arranged Prepared -> Ray -> Int -> Int -> Closest -> Closest
closestInRange a !r !from !end before@(Closest t0 number0 tests) = go from t0 number0
  where
    !order = hierarchyOrder (boxes a)
    !shapes = things a
    -- Places are below the number of things.
    go !place !best !number
      | place >= end = if number == number0 && best == t0 then before else Closest best number tests
      | otherwise =
        let !t = nearest (Vector.unsafeIndex shapes place) r (slightlyBeyond best)
            !mine = indexPrimArray order place
         in if t < best || (t == best && mine < number) then go (place + 1) t mine else go (place + 1) best number
{-# NOINLINE closestInRange #-}

-- | The same for the shapes of a group's instances, after what was found before. (What was tried is counted in each body.)
closestInstance :: Group -> Ray -> Closest -> Closest
closestInstance g r c = case descend (boxes a) (approach r) within range c of
  Tried found _ -> found
  where
    a = groupInstances g
    range from end found = foldl' (\f place -> closestPlaced (Vector.unsafeIndex (things a) place) r f) found [from .. end - 1]

closestPlaced :: Placed -> Ray -> Closest -> Closest
closestPlaced (Placed first place body) r = closestInBody body first (maybe r (`carriedBack` r) place)

-- | The same for a body's shapes, whose numbers begin with that one.
closestInBody :: Body -> Int -> Ray -> Closest -> Closest
closestInBody body !first !r !found = case body of
  Triangles m _ -> closestTriangle m first r found
  -- What was found before has another numbering: it is as if it came later, or before, all that is in the group.
  Assembly g -> renumbered (closestInstance g r (closestShape g r (Closest (closestParameter found) (closestNumber found - first) (closestTests found))))
  where
    renumbered (Closest t number tests) = Closest t (number + first) tests

-------------------------------------------------------------------------------
-- What is there

-- | A shape, where it is in the world, and its finish.
data Surface = Surface !Prepared !(Finish Texture)

-- | The shape of a number from 0 to below 'worldSize'; 'Nothing' elsewhere.
--
-- Cost: constant for the scene's own primitives; for shapes of models, like the logarithm of the number of instances, and a prepared triangle is made.
surfaceAt :: World -> Int -> Maybe Surface
surfaceAt w = surfaceIn (root w)
{-# INLINE surfaceAt #-}

surfaceIn :: Group -> Int -> Maybe Surface
surfaceIn g !number
  | number < 0 = Nothing
  | number < Vector.length shapes = Just (Surface (Vector.unsafeIndex shapes number) (Vector.unsafeIndex (groupFinishes g) number))
  | otherwise = surfaceInInstance g number
  where
    -- There are as many finishes as shapes.
    shapes = numbered (groupShapes g)
{-# INLINE surfaceIn #-}

surfaceInInstance :: Group -> Int -> Maybe Surface
surfaceInInstance g number = do
  Placed first place body <- instanceOf g number
  Surface shape f <- surfaceInBody body (number - first)
  pure (Surface (maybe id placedIn place shape) f)

-- | The instance of a group that a number is in.
instanceOf :: Group -> Int -> Maybe Placed
instanceOf g number = lastUpTo 0 (Vector.length instances)
  where
    instances = numbered (groupInstances g)
    -- The last instance whose first number is not greater is among those from lo to below hi.
    lastUpTo lo hi
      | hi - lo <= 0 = Nothing
      | hi - lo == 1 = instances !? lo
      | firstOf middle <= number = lastUpTo middle hi
      | otherwise = lastUpTo lo middle
      where
        middle = (lo + hi) `div` 2
    firstOf i = case instances !? i of
      Just (Placed first _ _) -> first
      Nothing -> maxBound

surfaceInBody :: Body -> Int -> Maybe Surface
surfaceInBody (Assembly g) number = surfaceIn g number
surfaceInBody (Triangles m finishes) number =
  Surface <$> preparedTriangle m number <*> (meshFinishes mesh Unboxed.!? number >>= (finishes !?) . fromIntegral)
  where
    mesh = preparedMesh m

-- | The finish of the shape of a number, which takes less than the shape itself.
finishAt :: World -> Int -> Maybe (Finish Texture)
finishAt w = finishIn (root w)
{-# INLINE finishAt #-}

finishIn :: Group -> Int -> Maybe (Finish Texture)
finishIn g number
  | number < 0 = Nothing
  | number < Vector.length (groupFinishes g) = groupFinishes g !? number
  | otherwise = do
    Placed first _ body <- instanceOf g number
    case body of
      Assembly g' -> finishIn g' (number - first)
      Triangles m finishes -> meshFinishes (preparedMesh m) Unboxed.!? (number - first) >>= (finishes !?) . fromIntegral

-------------------------------------------------------------------------------
-- What stands between

-- | What a ray meets nearer than a bound, in any order.
data Obstacles = Obstacles
  { -- | Whether anything lets nothing through. If so, the rest may have been passed over.
    obstaclesOpaque :: !Bool,
    -- | The numbers and finishes of the transparent shapes that are met, each once.
    obstaclesTransparent :: [(Int, Finish Texture)],
    -- | How many shapes were tried.
    obstaclesTests :: !Int
  }

-- | What a ray meets nearer than a bound; no farther than the first thing that lets nothing through.
obstacles :: World -> Ray -> Double -> Obstacles
obstacles w !r !bound
  | isSmall w = obstaclesOfFew (root w) r bound
  | otherwise = obstaclesOfMany (root w) r bound
{-# INLINE obstacles #-}

obstaclesOfFew :: Group -> Ray -> Double -> Obstacles
obstaclesOfFew g !r !bound = go 0 []
  where
    !shapes = numbered (groupShapes g)
    !count = Vector.length shapes
    -- Numbers are below the number of shapes, and there are as many finishes.
    go !i through
      | i >= count = Obstacles False through count
      | nearest (Vector.unsafeIndex shapes i) r bound < bound =
        let f = Vector.unsafeIndex (groupFinishes g) i
         in if isTransparent f then go (i + 1) ((i, f) : through) else Obstacles True [] (i + 1)
      | otherwise = go (i + 1) through
{-# INLINE obstaclesOfFew #-}

obstaclesOfMany :: Group -> Ray -> Double -> Obstacles
obstaclesOfMany g r bound = obstaclesInInstances g 0 r bound (obstaclesInShapes g 0 r bound (Obstacles False [] 0))
{-# NOINLINE obstaclesOfMany #-}

-- | How far a ray still matters: not at all once something opaque is met.
stillTo :: Double -> Obstacles -> Double
stillTo bound found = if obstaclesOpaque found then -1 / 0 else bound
{-# INLINE stillTo #-}

obstaclesInShapes :: Group -> Int -> Ray -> Double -> Obstacles -> Obstacles
obstaclesInShapes g first r !bound before = case descend (boxes (groupShapes g)) (approach r) (stillTo bound) (obstaclesInRange g first r bound) before of
  Tried found n -> found {obstaclesTests = obstaclesTests found + n}

-- | The same for the shapes at some places.
obstaclesInRange :: Group -> Int -> Ray -> Double -> Int -> Int -> Obstacles -> Obstacles
obstaclesInRange g first !r !bound !from !end = go from
  where
    !order = hierarchyOrder (boxes (groupShapes g))
    !shapes = things (groupShapes g)
    -- Places are below the number of things, and numbers below that of finishes.
    go !place found
      | place >= end || obstaclesOpaque found = found
      | nearest (Vector.unsafeIndex shapes place) r bound < bound =
        let number = indexPrimArray order place
            f = Vector.unsafeIndex (groupFinishes g) number
         in go (place + 1) (if isTransparent f then found {obstaclesTransparent = (first + number, f) : obstaclesTransparent found} else found {obstaclesOpaque = True})
      | otherwise = go (place + 1) found
{-# NOINLINE obstaclesInRange #-}

obstaclesInInstances :: Group -> Int -> Ray -> Double -> Obstacles -> Obstacles
obstaclesInInstances g first r !bound before = case descend (boxes a) (approach r) (stillTo bound) range before of
  Tried found _ -> found
  where
    a = groupInstances g
    range from end found = foldl' each found [from .. end - 1]
    each found place
      | obstaclesOpaque found = found
      | otherwise = case Vector.unsafeIndex (things a) place of
        Placed inner where' body -> obstaclesInBody body (first + inner) (maybe r (`carriedBack` r) where') bound found

obstaclesInBody :: Body -> Int -> Ray -> Double -> Obstacles -> Obstacles
obstaclesInBody body !first !r !bound found = case body of
  -- The material libraries of meshes know no transparency.
  Triangles m _ -> case anyTriangle m r bound of
    (struck, tests) -> found {obstaclesOpaque = struck, obstaclesTests = obstaclesTests found + tests}
  Assembly g -> obstaclesInInstances g first r bound (obstaclesInShapes g first r bound found)

-------------------------------------------------------------------------------
-- What is around

-- | The finishes of the closed shapes that a point is inside of, in the order of their numbers; a shape left out, by its number.
surroundings :: World -> Maybe Int -> Point -> [Finish Texture]
surroundings w leftOut p = map snd (sortOn fst (filter ((/= leftOut) . Just . fst) (surroundingIn (root w) 0 p [])))

-- | Shapes of a group that are around a point, and those of its instances; their numbers begin with that one.
surroundingIn :: Group -> Int -> Point -> [(Int, Finish Texture)] -> [(Int, Finish Texture)]
surroundingIn g first p = within' (groupInstances g) inInstance . within' (groupShapes g) inShape
  where
    -- A ray that goes nowhere comes into the boxes that hold its origin.
    within' a try found = case descend (boxes a) (approach (ray p (V3 1 0 0))) (const 0) range found of
      Tried all' _ -> all'
      where
        range from end l = foldl' (\l' place -> try (indexPrimArray (hierarchyOrder (boxes a)) place) (things a Vector.! place) l') l [from .. end - 1]
    inShape number shape found = case groupFinishes g !? number of
      Just f | contains shape p -> (first + number, f) : found
      _ -> found
    inInstance _ (Placed inner place body) found = case body of
      Assembly g' -> surroundingIn g' (first + inner) (maybe p (`inversePosition` p) place) found
      -- A mesh is a surface, closed or not.
      Triangles _ _ -> found
