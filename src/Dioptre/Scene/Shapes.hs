{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Scene.Shapes
-- Description : The shapes of the scene language
--
-- One schema for each shape: its words, defaults and conditions.
module Dioptre.Scene.Shapes
  ( readShape,
    writeShape,
    describeShapes,
  )
where

import Data.List.NonEmpty (NonEmpty (..))
import Data.Text (Text)
import Dioptre.Geometry.Axis (Round, axis, axisEnd, axisStart, roundAxis, roundRadius, roundShape)
import Dioptre.Geometry.Cap (Cap, cap, capCurvature, capDisk)
import Dioptre.Geometry.Cube (Cube, cube, cubeCentre, cubeSize)
import Dioptre.Geometry.Disk (Annulus, Disk, annulus, annulusInner, annulusOuter, annulusPlane, disk, diskPlane, diskRadius)
import Dioptre.Geometry.Lens (Lens, lens, lensBody, lensCurvatures)
import Dioptre.Geometry.Plane (Plane, plane, planeNormal, planePosition)
import Dioptre.Geometry.Shape (Shape (..))
import Dioptre.Geometry.Sphere (Sphere, sphere, sphereCentre, sphereRadius)
import Dioptre.Geometry.Torus (Torus, torus, torusMajor, torusMinor, torusPlane)
import Dioptre.Geometry.Triangle (Corners (..), SmoothTriangle, Triangle, smoothTriangle, smoothTriangleFlat, smoothTriangleNormals, smoothTriangleUvs, triangle, trianglePoints)
import Dioptre.Math.Transform (Transform, transform, transformRotation, transformScale, transformTranslation)
import Dioptre.Math.Vector (Point, Vector)
import Dioptre.Scene.Form (directionForm, optionally, positive, realFrom, realThatIsAny, scaleForm, textureForm, vectorForm)
import Dioptre.Scene.Schema
import Dioptre.Source.Diagnostic (Expectation, Flaw (..), Refusal (SamePoint))
import Dioptre.Syntax.Keyword (Keyword)
import qualified Dioptre.Syntax.Keyword as Keyword
import Dioptre.Syntax.Print (Outline)
import Dioptre.Syntax.Tree (Block (..), Head (..))
import Linear.V2 (V2 (..))
import Linear.V3 (V3 (..))

-- | The shape that a block describes; 'Nothing' if its values make none, which has been reported, or if its word is no shape's.
readShape :: Block -> Check (Maybe Shape)
readShape block = case headKeyword (blockHead block) of
  Just Keyword.Plane -> through APlane planeSchema
  Just Keyword.Disk -> through ADisk diskSchema
  Just Keyword.Annulus -> through AnAnnulus annulusSchema
  Just Keyword.Sphere -> through ASphere sphereSchema
  Just Keyword.Cube -> through ACube cubeSchema
  Just Keyword.Triangle -> through ATriangle triangleSchema
  Just Keyword.SmoothTriangle -> through ASmoothTriangle smoothTriangleSchema
  Just Keyword.Tube -> through ATube (roundSchema Keyword.Tube)
  Just Keyword.Cylinder -> through ACylinder (roundSchema Keyword.Cylinder)
  Just Keyword.Cone -> through ACone (roundSchema Keyword.Cone)
  Just Keyword.Lens -> through ALens lensSchema
  Just Keyword.SphericalCap -> through ACap capSchema
  Just Keyword.Torus -> through ATorus torusSchema
  Just Keyword.Geometry -> through (uncurry ATransformed) transformedSchema
  _ -> pure Nothing
  where
    through :: (b -> Shape) -> Schema a b -> Check (Maybe Shape)
    through wrap schema = fmap wrap <$> readObject readShape schema block

-- | The shape in the scene language.
writeShape :: Shape -> Outline
writeShape shape = case shape of
  APlane s -> write planeSchema s
  ADisk s -> write diskSchema s
  AnAnnulus s -> write annulusSchema s
  ASphere s -> write sphereSchema s
  ACube s -> write cubeSchema s
  ATriangle s -> write triangleSchema s
  ASmoothTriangle s -> write smoothTriangleSchema s
  ATube s -> write (roundSchema Keyword.Tube) s
  ACylinder s -> write (roundSchema Keyword.Cylinder) s
  ACone s -> write (roundSchema Keyword.Cone) s
  ALens s -> write lensSchema s
  ACap s -> write capSchema s
  ATorus s -> write torusSchema s
  ATransformed t s -> write transformedSchema (t, s)
  where
    write :: Schema a b -> b -> Outline
    write = writeObject writeShape

-- | Every shape's word with its properties: their words, what they expect, their defaults.
describeShapes :: [(Keyword, [([Keyword], Expectation, [Text])])]
describeShapes =
  [ of' planeSchema,
    of' diskSchema,
    of' annulusSchema,
    of' sphereSchema,
    of' cubeSchema,
    of' triangleSchema,
    of' smoothTriangleSchema,
    of' (roundSchema Keyword.Tube),
    of' (roundSchema Keyword.Cylinder),
    of' (roundSchema Keyword.Cone),
    of' lensSchema,
    of' capSchema,
    of' torusSchema,
    of' transformedSchema
  ]
  where
    of' :: Schema a b -> (Keyword, [([Keyword], Expectation, [Text])])
    of' schema = (schemaKeyword schema, describe schema)

-- | A draft that becomes an object, or does not for one reason.
orElse :: Maybe b -> Flaw -> Either Flaw b
orElse made flaw = maybe (Left flaw) Right made

-- * Flat shapes

type PlaneDraft = (Point, Vector)

planeProperties :: [Property PlaneDraft]
planeProperties =
  [ one Keyword.Position vectorForm fst (\v (_, n) -> (v, n)),
    one Keyword.Normal vectorForm snd (\v (p, _) -> (p, v))
  ]

buildPlane :: PlaneDraft -> Either Flaw Plane
buildPlane (p, n) = plane p n `orElse` ZeroNormal

openPlane :: Plane -> PlaneDraft
openPlane p = (planePosition p, planeNormal p)

defaultPlane :: PlaneDraft
defaultPlane = (0, V3 0 0 1)

planeSchema :: Schema PlaneDraft Plane
planeSchema = Schema Keyword.Plane defaultPlane planeProperties Nothing buildPlane openPlane

-- | The properties of a plane that is the first part of a pair.
onPlane :: [Property (PlaneDraft, b)]
onPlane = map (within fst (\p (_, b) -> (p, b))) planeProperties

-- | A length that is the second part of a pair.
radiusOf :: Keyword -> Property (a, Double)
radiusOf word = one word positive snd (\r (a, _) -> (a, r))

diskSchema :: Schema (PlaneDraft, Double) Disk
diskSchema =
  Schema Keyword.Disk (defaultPlane, 1) (onPlane <> [radiusOf Keyword.Ray]) Nothing buildDisk openDisk

buildDisk :: (PlaneDraft, Double) -> Either Flaw Disk
buildDisk (p, r) = buildPlane p >>= \pl -> disk pl r `orElse` ZeroSize

openDisk :: Disk -> (PlaneDraft, Double)
openDisk d = (openPlane (diskPlane d), diskRadius d)

annulusSchema :: Schema (PlaneDraft, (Double, Double)) Annulus
annulusSchema =
  Schema
    Keyword.Annulus
    (defaultPlane, (1, 0.5))
    ( onPlane
        <> [ one Keyword.Ray positive (fst . snd) (\r (p, (_, i)) -> (p, (r, i))),
             one Keyword.InnerRay (realFrom 0) (snd . snd) (\i (p, (r, _)) -> (p, (r, i)))
           ]
    )
    Nothing
    (\(p, (outer, inner)) -> buildPlane p >>= \pl -> annulus pl inner outer `orElse` InnerBeyondOuter)
    (\a -> (openPlane (annulusPlane a), (annulusOuter a, annulusInner a)))

triangleSchema :: Schema (Corners Point) Triangle
triangleSchema =
  Schema
    Keyword.Triangle
    defaultCorners
    [several (Keyword.Point :| []) vectorForm corners]
    Nothing
    (\points -> triangle points `orElse` CollinearPoints)
    trianglePoints

defaultCorners :: Corners Point
defaultCorners = Corners 0 (V3 0 1 0) (V3 1 1 0)

-- | The three places of something that each corner has.
corners :: NonEmpty (Slot (Corners v) v)
corners =
  Slot (\(Corners a _ _) -> a) (\a (Corners _ b c) -> Right (Corners a b c))
    :| [ Slot (\(Corners _ b _) -> b) (\b (Corners a _ c) -> Right (Corners a b c)),
         Slot (\(Corners _ _ c) -> c) (\c (Corners a b _) -> Right (Corners a b c))
       ]

smoothTriangleSchema :: Schema (Corners Point, (Corners (Maybe Vector), Corners (V2 Double))) SmoothTriangle
smoothTriangleSchema =
  Schema
    Keyword.SmoothTriangle
    (defaultCorners, (Corners Nothing Nothing Nothing, Corners 0 0 0))
    [ within fst (\p (_, r) -> (p, r)) (several (Keyword.Point :| []) vectorForm corners),
      within (fst . snd) (\n (p, (_, u)) -> (p, (n, u))) (several (Keyword.Normal :| []) (optionally directionForm) corners),
      within (snd . snd) (\u (p, (n, _)) -> (p, (n, u))) (several (Keyword.Uv :| []) textureForm corners)
    ]
    Nothing
    (\(points, (normals, uvs)) -> (\t -> smoothTriangle t normals uvs) <$> triangle points `orElse` CollinearPoints)
    (\s -> (trianglePoints (smoothTriangleFlat s), (some (smoothTriangleNormals s), smoothTriangleUvs s)))
  where
    some (Corners a b c) = Corners (Just a) (Just b) (Just c)

-- * Closed and round shapes

sphereSchema :: Schema (Point, Double) Sphere
sphereSchema =
  Schema
    Keyword.Sphere
    (0, 1)
    [one Keyword.Position vectorForm fst (\p (_, r) -> (p, r)), radiusOf Keyword.Ray]
    Nothing
    (\(p, r) -> sphere p r `orElse` ZeroSize)
    (\s -> (sphereCentre s, sphereRadius s))

cubeSchema :: Schema (Point, Double) Cube
cubeSchema =
  Schema
    Keyword.Cube
    (0, 1)
    [one Keyword.Position vectorForm fst (\p (_, s) -> (p, s)), radiusOf Keyword.Size]
    Nothing
    (\(p, s) -> cube p s `orElse` ZeroSize)
    (\c -> (cubeCentre c, cubeSize c))

type AxisDraft = (Point, Point)

defaultAxis :: AxisDraft
defaultAxis = (0, V3 0 0 1)

-- | The two ends of an axis, under either word; the second is refused when it is the first again.
axisEnds :: Property AxisDraft
axisEnds =
  several (Keyword.Position :| [Keyword.Point]) vectorForm $
    Slot fst (\a (_, b) -> Right (a, b))
      :| [Slot snd (\b (a, _) -> if a == b then Left SamePoint else Right (a, b))]

buildRound :: (AxisDraft, Double) -> Either Flaw Round
buildRound ((a, b), r) = (axis a b >>= \x -> roundShape x r) `orElse` EqualPoints

openRound :: Round -> (AxisDraft, Double)
openRound s = ((axisStart (roundAxis s), axisEnd (roundAxis s)), roundRadius s)

roundProperties :: [Property (AxisDraft, Double)]
roundProperties = [within fst (\x (_, r) -> (x, r)) axisEnds, radiusOf Keyword.Ray]

roundSchema :: Keyword -> Schema (AxisDraft, Double) Round
roundSchema word = Schema word (defaultAxis, 1) roundProperties Nothing buildRound openRound

lensSchema :: Schema ((AxisDraft, Double), (Double, Double)) Lens
lensSchema =
  Schema
    Keyword.Lens
    ((defaultAxis, 1), (1, 1))
    ( map (within fst (\b (_, c) -> (b, c))) roundProperties
        <> [ several (Keyword.Curvature :| []) realThatIsAny $
               Slot (fst . snd) (\c (b, (_, d)) -> Right (b, (c, d)))
                 :| [Slot (snd . snd) (\d (b, (c, _)) -> Right (b, (c, d)))]
           ]
    )
    Nothing
    build
    (\l -> (openRound (lensBody l), lensCurvatures l))
  where
    build (b, curvatures@(c1, c2)) = do
      body <- buildRound b
      if abs c1 < roundRadius body || abs c2 < roundRadius body
        then Left CurvatureBelowRadius
        else lens body curvatures `orElse` LensTooThin

capSchema :: Schema ((PlaneDraft, Double), Double) Cap
capSchema =
  Schema
    Keyword.SphericalCap
    ((defaultPlane, 1), 1)
    ( map (within fst (\d (_, c) -> (d, c))) (onPlane <> [radiusOf Keyword.Ray])
        <> [one Keyword.Curvature realThatIsAny snd (\c (d, _) -> (d, c))]
    )
    Nothing
    (\(d, c) -> buildDisk d >>= \base -> cap base c `orElse` CurvatureBelowRadius)
    (\c -> (openDisk (capDisk c), capCurvature c))

torusSchema :: Schema (PlaneDraft, (Double, Double)) Torus
torusSchema =
  Schema
    Keyword.Torus
    (defaultPlane, (1, 0.2))
    ( onPlane
        <> [ one Keyword.MajorRadius positive (fst . snd) (\r (p, (_, m)) -> (p, (r, m))),
             one Keyword.MinorRadius positive (snd . snd) (\m (p, (r, _)) -> (p, (r, m)))
           ]
    )
    Nothing
    (\(p, (major, minor)) -> buildPlane p >>= \pl -> torus pl major minor `orElse` ZeroSize)
    (\t -> (openPlane (torusPlane t), (torusMajor t, torusMinor t)))

-- * Transformed shapes

transformedSchema :: Schema ((Vector, (Vector, Vector)), Maybe Shape) (Transform, Shape)
transformedSchema =
  Schema
    Keyword.Geometry
    ((1, (0, 0)), Nothing)
    [ one Keyword.Scale scaleForm (fst . fst) (\s ((_, rt), i) -> ((s, rt), i)),
      one Keyword.Rotation vectorForm (fst . snd . fst) (\r ((s, (_, t)), i) -> ((s, (r, t)), i)),
      one Keyword.Translation vectorForm (snd . snd . fst) (\t ((s, (r, _)), i) -> ((s, (r, t)), i))
    ]
    (Just (Slot snd (\i (t, _) -> Right (t, i))))
    (\((s, (r, t)), inner) -> (,) <$> transform s r t `orElse` ZeroSize <*> inner `orElse` WithoutShape)
    (\(t, inner) -> ((transformScale t, (transformRotation t, transformTranslation t)), Just inner))
