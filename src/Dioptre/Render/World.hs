{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE TupleSections #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.World
-- Description : A scene made ready for many rays
--
-- The prepared shapes of a scene with the finishes that they have, and an index over them. What a ray tracer asks of a
-- world has a module each: what a ray meets first ("Dioptre.Render.Closest"), what there is ("Dioptre.Render.Surface"),
-- what stands between a point and a light ("Dioptre.Render.Obstacles"), and what a point is inside of
-- ("Dioptre.Render.Surroundings").
--
-- >  root ----- shapes:     plane                      without an end: always tried
-- >   |          |
-- >   |         boxes ----- sphere, cube, ...
-- >   |
-- >   +------- instances:   boxes ----- teapot at (0,0,5) ---+
-- >                           |                              +--> the teapot's triangles and their boxes, once
-- >                           +-------- teapot, upside down -+
--
-- Everything has a number: the primitives of the scene from 0, in its order, and behind them the shapes of each model
-- instance, in the order of the models. The answers do not depend on the index: of several shapes at one parameter the
-- one with the lowest number is met, and whatever is counted up or multiplied is so in the order of the numbers. (Law:
-- as without any index.)
module Dioptre.Render.World
  ( -- * Worlds
    World (..),
    world,
    root,
    worldExtent,
    worldSize,
    worldOwn,
    worldHasMedia,
    worldHasPictures,

    -- * What they are made of
    Group (..),
    Arranged (..),
    Surface (..),
    Placed (..),
    Body (..),

    -- * How large they are
    Extent (..),
  )
where

import Data.List (foldl', mapAccumL)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe, maybeToList)
import Data.Primitive.PrimArray
import Data.Vector (Vector, (!?))
import qualified Data.Vector as Vector
import Dioptre.Geometry.Bounds (ofShape)
import Dioptre.Geometry.Box (Box, transformed, union)
import Dioptre.Geometry.Handful (Handful, handful)
import Dioptre.Geometry.Hierarchy (Hierarchy, hierarchy, hierarchyBox, hierarchyDepth, hierarchyNodes, hierarchyOrder)
import Dioptre.Geometry.Mesh (meshSize)
import Dioptre.Geometry.Placement (Placement, placement)
import Dioptre.Geometry.Prepared (Prepared, isClosed, prepare)
import Dioptre.Geometry.PreparedMesh (PreparedMesh, prepareMesh, preparedMesh, preparedMeshHierarchy)
import Dioptre.Geometry.Shape (Shape)
import Dioptre.Light.Finish (Finish, finish, hasPictures, isTransparent, withPictures)
import Dioptre.Math.Transform (identity)
import Dioptre.Model.Content (Content (..), Part (..))
import Dioptre.Model.Library (Instance (..), Library (..))
import Dioptre.Render.Texture (Assets, Texture (..), Upward (..))
import Dioptre.Scene (Scene, sceneSolids)

-- | All that rays can meet; 'world' makes it, and 'root' and 'worldExtent' read both kinds.
data World
  = -- | A few shapes, or such as have no end: all are tried, one after the other. The shapes for that; everything; and how large it is, which is computed when it is asked.
    Few {-# UNPACK #-} !Handful !Group Extent
  | -- | More, or instances of models: there is an index. Everything, and how large it is.
    Many !Group Extent

-- | Everything: the scene's own shapes, and its instances of models.
root :: World -> Group
root (Few _ g _) = g
root (Many g _) = g
{-# INLINE root #-}

-- | How large it is.
worldExtent :: World -> Extent
worldExtent (Few _ _ e) = e
worldExtent (Many _ e) = e

-- | How many shapes there are, those of models counted once for each instance.
worldSize :: World -> Int
worldSize = groupSize . root

-- | How many of them are the scene's own primitives, which have the first numbers.
worldOwn :: World -> Int
worldOwn = Vector.length . groupSurfaces . root

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
  { -- | The shapes that stand in it by themselves.
    groupShapes :: {-# UNPACK #-} !(Arranged Prepared),
    -- | The same shapes with their finishes, by number.
    groupSurfaces :: {-# UNPACK #-} !(Vector Surface),
    -- | The models in it; numbers count them, not their shapes.
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

-- | A shape, where it is in its group or in the world, and its finish.
data Surface = Surface {surfaceShape :: !Prepared, surfaceFinish :: !(Finish Texture)}

-- | Things with boxes around them.
data Arranged a = Arranged
  { -- | By number.
    numbered :: {-# UNPACK #-} !(Vector a),
    -- | By place in the hierarchy's order.
    things :: !(Vector a),
    -- | The boxes in boxes, and the order of the places.
    boxes :: !Hierarchy,
    -- | Around all of them; 'Nothing' if one has no end, or there are none.
    around :: !(Maybe Box)
  }

-- | A model somewhere in a group: its first number there, where it is (nothing: where its file has it), and the model.
data Placed = Placed !Int !(Maybe Placement) !Body

-- | A model, or a part of one.
data Body
  = -- | A mesh, and the finishes that its triangles name.
    Triangles !PreparedMesh !(Vector (Finish Texture))
  | -- | Shapes and other models.
    Assembly !Group

-------------------------------------------------------------------------------
-- Building

-- | The world of a scene with its pictures and models.
--
-- Spec: scene.material.name, scene.material.repeated, light.material.substitute, light.material.first, models.block,
--   models.transformed, models.order.
world :: Assets -> Library Texture -> Scene -> World
world assets library scene
  | hierarchyNodes (boxes (groupShapes top)) == 0 && Vector.null (things (groupInstances top)) = Few (handful (numbered (groupShapes top))) top extent
  | otherwise = Many top extent
  where
    top = group (mapMaybe (\(shape, f) -> shapeWith f shape) (sceneSolids pictured scene)) (mapMaybe instanced (libraryInstances library))
    extent = extentOf top (Vector.toList bodies)
    -- Every model once: an instance refers to it. A model is made of models with lower numbers.
    bodies = Vector.map (modelBody instanced) (libraryModels library)
    instanced i = (if instanceTransform i == identity then Nothing else Just (placement (instanceTransform i)),) <$> bodies !? instanceModel i
    pictured m = withPictures (\name -> Texture FromFirstRow <$> Map.lookup name assets) (finish m)

-- | A shape, prepared, with its box and its finish; 'Nothing' if it cannot be prepared.
shapeWith :: Finish Texture -> Shape -> Maybe (Maybe Box, Prepared, Finish Texture)
shapeWith f shape = (ofShape shape,,f) <$> prepare shape

-- | A model of a library, given its instances of other models.
modelBody :: (Instance -> Maybe (Maybe Placement, Body)) -> Content Instance Texture -> Body
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
      Nested i -> maybeToList (instanced i)

-- | A group of shapes with their boxes and finishes, and of instances.
group :: [(Maybe Box, Prepared, Finish Texture)] -> [(Maybe Placement, Body)] -> Group
group shapes instances =
  Group
    { groupShapes = arrangedShapes,
      groupSurfaces = Vector.fromList [Surface s f | (_, s, f) <- shapes],
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
  | otherwise = union <$> around (groupShapes g) <*> around (groupInstances g)

-- | So few things are tried one after the other: boxes around them would take as long as they save.
few :: Int
few = 8

-- | Things with their boxes, in their order, arranged. (A hierarchy asks for the boxes of as many as it is told of, and
-- its order has the number of each once.)
arranged :: [(Maybe Box, a)] -> Arranged a
arranged list = Arranged (Vector.map snd pairs) (Vector.map (snd . (pairs Vector.!)) order) h outer
  where
    pairs = Vector.fromList list
    h = hierarchy (Vector.length pairs) (if Vector.length pairs > few then fst . (pairs Vector.!) else const Nothing)
    order = Vector.fromList (primArrayToList (hierarchyOrder h))
    outer = case traverse fst list of
      Just (b : bs) -> Just (foldl' union b bs)
      _ -> Nothing
