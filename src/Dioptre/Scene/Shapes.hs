{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Shapes
-- Description : The shapes of the scene language
--
-- One schema for each shape: its words, their forms, and when there is such a shape.
--
-- > plane          position normal
-- > disk           position normal ray
-- > annulus        position normal ray inner_ray
-- > spherical_cap  position normal ray curvature
-- > torus          position normal major_radius minor_radius
-- > sphere         position ray
-- > cube           position size
-- > tube, cylinder, cone
-- >                position position ray
-- > lens           position position ray curvature curvature
-- > triangle       point point point
-- > btriangle      point point point, normal normal normal, uv uv uv
-- > geometry       scale rotation translation, and a shape
--
-- All of them fill one kind of draft, which has a place and a default for whatever a shape can be given; each shape
-- reads and writes its own part. Specification: chapter 3.
module Dioptre.Scene.Shapes
  ( readShape,
    describeShapes,

    -- * In other objects
    holding,
  )
where

import Data.List.NonEmpty (NonEmpty (..))
import Data.Text (Text)
import Dioptre.Geometry.Axis (Round, axis, axisEnd, axisStart, roundAxis, roundRadius, roundShape)
import Dioptre.Geometry.Cap (cap, capCurvature, capDisk)
import Dioptre.Geometry.Cube (cube, cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (Disk, annulus, annulusInner, annulusOuter, annulusPlane, disk, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (lens, lensBody, lensCurvatures)
import Dioptre.Geometry.Plane (Plane, plane, planeNormal, planePosition)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (sphere, sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (torus, torusMajor, torusMinor, torusPlane)
import Dioptre.Geometry.Triangle (Corners (..), smoothTriangle, smoothTriangleFlat, smoothTriangleNormals, smoothTriangleUvs, triangle, trianglePoints)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Transform (transform, transformRotation, transformScale, transformTranslation)
import Dioptre.Math.Vector (Point, Vector)
import Dioptre.Scene.Form (Form, directionForm, optionally, positive, realFrom, realThatIsAny, scaleForm, textureForm, vectorForm)
import Dioptre.Scene.Reporting (Check)
import Dioptre.Scene.Schema
import Dioptre.Source.Diagnostic (Expectation, Flaw (..), Refusal (SamePoint))
import Dioptre.Syntax.Keyword (Keyword)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print (Outline)
import Dioptre.Syntax.Tree (Block (..), Head (..))
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | Every shape.
schemas :: [Schema Draft Shape]
schemas =
  [ planeSchema,
    diskSchema,
    annulusSchema,
    sphereSchema,
    cubeSchema,
    triangleSchema,
    smoothTriangleSchema,
    tubeSchema,
    cylinderSchema,
    coneSchema,
    lensSchema,
    capSchema,
    torusSchema,
    transformedSchema
  ]

-- | The schema of a shape that there is.
schemaOf :: Shape -> Schema Draft Shape
schemaOf = \case
  APlane _ -> planeSchema
  ADisk _ -> diskSchema
  AnAnnulus _ -> annulusSchema
  ASphere _ -> sphereSchema
  ACube _ -> cubeSchema
  ATriangle _ -> triangleSchema
  ASmoothTriangle _ -> smoothTriangleSchema
  ATube _ -> tubeSchema
  ACylinder _ -> cylinderSchema
  ACone _ -> coneSchema
  ALens _ -> lensSchema
  ACap _ -> capSchema
  ATorus _ -> torusSchema
  ATransformed _ _ -> transformedSchema

-- | The shape that a block describes; 'Nothing' if its values make none, which has been reported, or if its word is no
-- shape's.
--
-- Spec: tree.depth, shape.defaults, shape.words.
readShape :: Block -> Check (Maybe Shape)
readShape block = case [schema | schema <- schemas, Just (schemaKeyword schema) == headKeyword (blockHead block)] of
  schema : _ -> readObject schema block
  [] -> pure Nothing

-- | The shape in the scene language.
writeShape :: Shape -> Outline
writeShape s = writeObject (schemaOf s) s

-- | Every shape's word with its properties: their words, what they expect, their defaults.
--
-- Spec: shape.defaults.
describeShapes :: [(Keyword, [([Keyword], Expectation, [Text])])]
describeShapes = [(schemaKeyword schema, describe schema) | schema <- schemas]

-- | A place for the one shape that an object holds.
holding :: (a -> Maybe Shape) -> (Maybe Shape -> a -> a) -> ShapePlace a
holding get put = ShapePlace get put readShape writeShape

-------------------------------------------------------------------------------
-- Drafts

-- | What any shape can be given.
data Draft = Draft
  { draftPosition :: Point,
    draftNormal :: Vector,
    -- | The length by which the shape is first of all known: a radius, the major one, or the side of a cube.
    draftSize :: Double,
    draftInner :: Double,
    draftMinor :: Double,
    -- | The end of an axis that begins at the position.
    draftEnd :: Point,
    draftCurvature :: Double,
    -- | That of the face at the axis' end.
    draftOtherCurvature :: Double,
    draftPoints :: Corners Point,
    draftNormals :: Corners (Maybe Vector),
    draftUvs :: Corners (V2 Double),
    draftScale :: Vector,
    draftRotation :: Vector,
    draftTranslation :: Vector,
    -- | The shape inside.
    draftShape :: Maybe Shape
  }

-- | A shape of which nothing is said.
unsaid :: Draft
unsaid =
  Draft
    { draftPosition = 0,
      draftNormal = V3 0 0 1,
      draftSize = 1,
      draftInner = 0.5,
      draftMinor = 0.2,
      draftEnd = V3 0 0 1,
      draftCurvature = 1,
      draftOtherCurvature = 1,
      draftPoints = Corners 0 (V3 0 1 0) (V3 1 1 0),
      draftNormals = Corners Nothing Nothing Nothing,
      draftUvs = Corners 0 0 0,
      draftScale = 1,
      draftRotation = 0,
      draftTranslation = 0,
      draftShape = Nothing
    }

-- | The draft that a shape was made from.
open :: Shape -> Draft
open = \case
  APlane s -> openPlane s
  ADisk s -> openDisk s
  AnAnnulus s -> (openPlane (annulusPlane s)) {draftSize = annulusOuter s, draftInner = annulusInner s}
  ASphere s -> unsaid {draftPosition = sphereCentre s, draftSize = sphereRadius s}
  ACube s -> unsaid {draftPosition = cubeCentre s, draftSize = cubeSize s}
  ATriangle s -> unsaid {draftPoints = trianglePoints s}
  ASmoothTriangle s ->
    unsaid
      { draftPoints = trianglePoints (smoothTriangleFlat s),
        draftNormals = let Corners a b c = smoothTriangleNormals s in Corners (Just a) (Just b) (Just c),
        draftUvs = smoothTriangleUvs s
      }
  ATube s -> openRound s
  ACylinder s -> openRound s
  ACone s -> openRound s
  ALens s -> let (c1, c2) = lensCurvatures s in (openRound (lensBody s)) {draftCurvature = c1, draftOtherCurvature = c2}
  ACap s -> (openDisk (capDisk s)) {draftCurvature = capCurvature s}
  ATorus s -> (openPlane (torusPlane s)) {draftSize = torusMajor s, draftMinor = torusMinor s}
  ATransformed t s ->
    unsaid {draftScale = transformScale t, draftRotation = transformRotation t, draftTranslation = transformTranslation t, draftShape = Just s}
  where
    openPlane p = unsaid {draftPosition = planePosition p, draftNormal = planeNormal p}
    openDisk d = (openPlane (diskPlane d)) {draftSize = diskRadius d}
    openRound s = unsaid {draftPosition = axisStart (roundAxis s), draftEnd = axisEnd (roundAxis s), draftSize = roundRadius s}

-- | A schema of a shape without another in it.
shape :: Keyword -> [Property Draft] -> (Draft -> Either Flaw Shape) -> Schema Draft Shape
shape word properties build = Schema word unsaid properties Nothing build open

-- | What is made, or else the one reason why it cannot be.
orElse :: Maybe b -> Flaw -> Either Flaw b
orElse made flaw = maybe (Left flaw) Right made

-------------------------------------------------------------------------------
-- Properties

position, normal, innerRadius, minorRadius, curvature :: Property Draft
position = one Keyword.Position vectorForm draftPosition (\v d -> d {draftPosition = v})
normal = one Keyword.Normal vectorForm draftNormal (\v d -> d {draftNormal = v})
innerRadius = one Keyword.InnerRay (realFrom 0) draftInner (\v d -> d {draftInner = v})
minorRadius = one Keyword.MinorRadius positive draftMinor (\v d -> d {draftMinor = v})
curvature = one Keyword.Curvature realThatIsAny draftCurvature (\v d -> d {draftCurvature = v})

-- | The size, under the shape's word for it.
size :: Keyword -> Property Draft
size word = one word positive draftSize (\v d -> d {draftSize = v})

-- | The two ends of an axis, under either word; the second is refused when it is the first again.
--
-- Spec: code.same-point.
axisEnds :: Property Draft
axisEnds =
  several (Keyword.Position :| [Keyword.Point]) vectorForm $
    Slot draftPosition (\v d -> Right d {draftPosition = v})
      :| [Slot draftEnd (\v d -> if v == draftPosition d then Left SamePoint else Right d {draftEnd = v})]

-- | The curvatures of the face at the axis' start and of that at its end.
curvatures :: Property Draft
curvatures =
  several (Keyword.Curvature :| []) realThatIsAny $
    Slot draftCurvature (\v d -> Right d {draftCurvature = v})
      :| [Slot draftOtherCurvature (\v d -> Right d {draftOtherCurvature = v})]

points, normals, uvs :: Property Draft
points = within draftPoints (\v d -> d {draftPoints = v}) (eachCorner Keyword.Point vectorForm)
normals = within draftNormals (\v d -> d {draftNormals = v}) (eachCorner Keyword.Normal (optionally directionForm))
uvs = within draftUvs (\v d -> d {draftUvs = v}) (eachCorner Keyword.Uv textureForm)

-- | Something that each corner has, given once for each.
eachCorner :: Keyword -> Form v -> Property (Corners v)
eachCorner word form =
  several (word :| []) form $
    Slot (\(Corners a _ _) -> a) (\a (Corners _ b c) -> Right (Corners a b c))
      :| [ Slot (\(Corners _ b _) -> b) (\b (Corners a _ c) -> Right (Corners a b c)),
           Slot (\(Corners _ _ c) -> c) (\c (Corners a b _) -> Right (Corners a b c))
         ]

-------------------------------------------------------------------------------
-- Flat shapes

-- Spec: code.zero-normal.
buildPlane :: Draft -> Either Flaw Plane
buildPlane d = plane (draftPosition d) (draftNormal d) `orElse` ZeroNormal smallestLength

buildDisk :: Draft -> Either Flaw Disk
buildDisk d = buildPlane d >>= \p -> disk p (draftSize d) `orElse` ZeroSize

-- Spec: shape.btriangle.normals.
planeSchema, diskSchema, annulusSchema, triangleSchema, smoothTriangleSchema :: Schema Draft Shape
planeSchema = shape Keyword.Plane [position, normal] (fmap APlane . buildPlane)
diskSchema = shape Keyword.Disk [position, normal, size Keyword.Ray] (fmap ADisk . buildDisk)
annulusSchema = shape Keyword.Annulus [position, normal, size Keyword.Ray, innerRadius] $ \d -> do
  p <- buildPlane d
  AnAnnulus <$> annulus p (draftInner d) (draftSize d) `orElse` InnerBeyondOuter
triangleSchema = shape Keyword.Triangle [points] $ \d ->
  ATriangle <$> triangle (draftPoints d) `orElse` CollinearPoints
smoothTriangleSchema = shape Keyword.SmoothTriangle [points, normals, uvs] $ \d -> do
  flat <- triangle (draftPoints d) `orElse` CollinearPoints
  Right (ASmoothTriangle (smoothTriangle flat (draftNormals d) (draftUvs d)))

-------------------------------------------------------------------------------
-- Closed and round shapes

buildRound :: Draft -> Either Flaw Round
buildRound d = (axis (draftPosition d) (draftEnd d) >>= \x -> roundShape x (draftSize d)) `orElse` EqualPoints

-- Spec: code.curvature-below-radius.
sphereSchema, cubeSchema, tubeSchema, cylinderSchema, coneSchema, lensSchema, capSchema, torusSchema :: Schema Draft Shape
sphereSchema = shape Keyword.Sphere [position, size Keyword.Ray] $ \d ->
  ASphere <$> sphere (draftPosition d) (draftSize d) `orElse` ZeroSize
cubeSchema = shape Keyword.Cube [position, size Keyword.Size] $ \d ->
  ACube <$> cube (draftPosition d) (draftSize d) `orElse` ZeroSize
tubeSchema = shape Keyword.Tube [axisEnds, size Keyword.Ray] (fmap ATube . buildRound)
cylinderSchema = shape Keyword.Cylinder [axisEnds, size Keyword.Ray] (fmap ACylinder . buildRound)
coneSchema = shape Keyword.Cone [axisEnds, size Keyword.Ray] (fmap ACone . buildRound)
lensSchema = shape Keyword.Lens [axisEnds, size Keyword.Ray, curvatures] $ \d -> do
  body <- buildRound d
  let (c1, c2) = (draftCurvature d, draftOtherCurvature d)
  if abs c1 < roundRadius body || abs c2 < roundRadius body
    then Left CurvatureBelowRadius
    else ALens <$> lens body (c1, c2) `orElse` LensTooThin
capSchema = shape Keyword.SphericalCap [position, normal, size Keyword.Ray, curvature] $ \d -> do
  base <- buildDisk d
  ACap <$> cap base (draftCurvature d) `orElse` CurvatureBelowRadius
torusSchema = shape Keyword.Torus [position, normal, size Keyword.MajorRadius, minorRadius] $ \d -> do
  p <- buildPlane d
  ATorus <$> torus p (draftSize d) (draftMinor d) `orElse` ZeroSize

-------------------------------------------------------------------------------
-- Transformed shapes

-- Spec: shape.geometry.nested, geometry.transformed.nested.
transformedSchema :: Schema Draft Shape
transformedSchema =
  Schema
    Keyword.Geometry
    unsaid
    [ one Keyword.Scale scaleForm draftScale (\v d -> d {draftScale = v}),
      one Keyword.Rotation vectorForm draftRotation (\v d -> d {draftRotation = v}),
      one Keyword.Translation vectorForm draftTranslation (\v d -> d {draftTranslation = v})
    ]
    (Just (holding draftShape (\inner d -> d {draftShape = inner})))
    ( \d -> do
        t <- transform (draftScale d) (draftRotation d) (draftTranslation d) `orElse` ZeroSize
        ATransformed t <$> draftShape d `orElse` WithoutShape
    )
    open
