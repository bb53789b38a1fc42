{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Explain.Story
-- Description : The story of one pixel, as data
--
-- Why a pixel has its colour: which rays were cast for it, what each was tried on and with what equation, what it met
-- first, which lights reach that point, and how the sum became four bytes.
--
-- >  Story ---- samples ---- RayStory ---- encounters ---- equations ---- roots
-- >                             |
-- >                             +--- Hit ---- lights' shares
-- >                                   |
-- >                                   +--- bounces ---- RayStory ...
--
-- A story is told by "Dioptre.Explain.Tell", in words by "Dioptre.Explain.Wording", and for programs by
-- "Dioptre.Explain.Json". Its numbers are those with which the picture is made. Places, shapes and lights are numbered
-- from 0, as in the program; words count shapes and lights from 1, as one counts in the file.
module Dioptre.Explain.Story
  ( -- * Pixels
    Story (..),
    Sample (..),

    -- * Rays
    RayStory (..),
    Cause (..),

    -- * Shapes
    Thing (..),
    Whereabouts (..),
    Encounter (..),
    Verdict (..),
    Kept (..),
    Miss (..),

    -- * Equations
    Equation (..),
    Condition (..),
    Coefficient (..),
    Patch (..),
    Root (..),
    Fate (..),
    Measure (..),

    -- * Hits
    Hit (..),
    Share (..),
    LightKind (..),
    Arrival (..),
    Approach (..),
    Term (..),

    -- * Bounces
    Bounce (..),
    BounceKind (..),
    Sequel (..),
    Obstacle (..),
  )
where

import Data.Text (Text)
import Dioptre.Geometry.Ray (Ray)
import Dioptre.Light.Colour (Colour)
import Dioptre.Light.Finish (Colours)
import Dioptre.Math.Vector (Point, Unit, Vector)
import Dioptre.Picture.Byte (Pixel)
import Dioptre.Scene.Raytracer (Raytracer)
import Dioptre.Syntax.Keyword (Keyword)
import Linear.V2 (V2)

-- | The story of a pixel.
data Story = Story
  { -- | From 0 at the left.
    storyColumn :: Int,
    -- | From 0 at the top.
    storyRow :: Int,
    -- | Width and height of the picture.
    storySize :: (Int, Int),
    -- | How rays are cast and shaded.
    storyRaytracer :: Raytracer,
    -- | Rays see no farther than this from where they start.
    storyFar :: Double,
    -- | How many shapes there are, those of models counted once for each instance.
    storyShapes :: Int,
    -- | How many lights there are.
    storyLights :: Int,
    -- | One for each ray through the pixel, at least one; of many only the first ('Dioptre.Explain.Tell.mostKept').
    storySamples :: [Sample],
    -- | Whether none of the rays through the pixel meets anything, also of those that are not kept.
    storySeesNothing :: Bool,
    -- | The colour of the one sample, or the mean.
    storyColour :: Colour,
    -- | The same with no channel above 1.
    storyNormalized :: Colour,
    -- | The same in four bytes.
    storyPixel :: Pixel
  }

-- | One ray through a pixel, and all that followed.
data Sample = Sample
  { -- | Where in the pixel: from 0 to 1, to the right and down.
    sampleOffset :: (Double, Double),
    -- | What the ray met.
    sampleRay :: RayStory,
    -- | What it sees, reflected and refracted rays included.
    sampleColour :: Colour,
    -- | How many rays were followed: the ray itself, reflected and refracted ones.
    sampleFollowed :: Int,
    -- | Whether more were wanted than are followed.
    sampleCut :: Bool
  }

-- | A ray that was followed.
data RayStory = RayStory
  { -- | Where it comes from.
    rayCause :: Cause,
    -- | 1 for a ray of the camera, one more for each bounce.
    rayDepth :: Int,
    -- | The ray.
    rayItself :: Ray,
    -- | By how much red, green and blue of what it sees count in the sample.
    rayWeight :: (Double, Double, Double),
    -- | The refractive index of where it travels.
    rayIndex :: Double,
    -- | The shapes that it was tried on, in the order of their numbers. Where there are many shapes, only those that
    -- its line meets.
    rayEncounters :: [Encounter],
    -- | How many shapes that its line does not meet were left out.
    rayPassed :: Int,
    -- | How many shapes were not looked at one by one, as there are too many.
    rayUntold :: Int,
    -- | What it met first, if anything.
    rayHit :: Maybe Hit,
    -- | The light that comes back from there along the ray, without reflected and refracted rays.
    rayOwnColour :: Colour,
    -- | The same times the weight: the part of the sample's colour that is due to this ray.
    rayContribution :: Colour
  }

-- | What a ray is cast for.
data Cause = FromCamera | ByReflection | ByRefraction
  deriving stock (Eq, Show)

-- | A shape somewhere in the world.
data Thing = Thing
  { -- | Its number in the world, from 0.
    thingNumber :: Int,
    -- | What it is the number of.
    thingWhereabouts :: Whereabouts,
    -- | The word of the scene language for it; for a transformed shape, that of the shape itself.
    thingKind :: Keyword,
    -- | Whether it is scaled, turned or moved.
    thingTransformed :: Bool,
    -- | The name of its material; shapes of models have none that is known here.
    thingMaterial :: Maybe Text
  }
  deriving stock (Eq, Show)

-- | Where a shape was written.
data Whereabouts
  = -- | A primitive of the scene, from 0.
    OfScene Int
  | -- | A shape or triangle of a model, from 0 in its file, with the model's number in the library and the file's name, where it is known.
    OfModel Int Int (Maybe Text)
  deriving stock (Eq, Show)

-- | A ray tried on a shape.
data Encounter = Encounter
  { -- | The shape.
    encounterThing :: Thing,
    -- | What the ray's line has to fulfil to meet the shape.
    encounterEquation :: Equation,
    -- | Every root of every condition, ascending.
    encounterRoots :: [Root],
    -- | What came of it.
    encounterVerdict :: Verdict
  }

-- | What comes of trying a ray on a shape.
data Verdict
  = -- | The ray meets it, at this parameter.
    Meets Double Kept
  | -- | It does not.
    Misses Miss
  deriving stock (Eq, Show)

-- | What becomes of a shape that a ray meets.
data Kept
  = -- | Nothing is nearer: it is what the ray sees.
    IsClosest
  | -- | Something nearer is in front of it.
    IsFarther
  | -- | Something with a lower number is met at the same parameter.
    IsAsNear
  deriving stock (Eq, Show)

-- | Why a ray does not meet a shape.
data Miss
  = -- | The ray's line runs along it: the coefficient of t is zero, but for rounding.
    Parallel
  | -- | No real number fulfils its equation.
    NoRoot
  | -- | Its equation has roots, at points that are not on the shape.
    NotOnShape
  | -- | Its line meets it behind the origin only.
    IsBehind
  | -- | It meets it only where it starts, at 'Dioptre.Math.Tolerance.smallestParameter' or nearer.
    IsTooNear
  | -- | It meets it only beyond the far clipping plane.
    IsBeyondFar
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The conditions of a shape, for one ray.
data Equation = Equation
  { -- | The ray in the shape's own frame, where that is not the world's.
    equationRay :: Maybe Ray,
    -- | What t is measured from, where it is moved: the equations are in s, and t = (t0 + s) k, with these t0 and k.
    equationMoved :: Maybe (Double, Double),
    -- | All of them must hold.
    equationConditions :: [Condition]
  }

-- | A condition in t, or in s where that is moved.
data Condition
  = -- | A polynomial is zero: its coefficients, the highest first, what the letters in them mean, and its discriminant, where it is of the second degree and the sign is
    -- beyond doubt. With the further move of s that a face of a lens has (otherwise 0).
    PolynomialIsZero Patch [Coefficient] [Text] (Maybe Double) Double
  | -- | B + A t is from a lower to an upper bound: A, B, and the bounds.
    LiesBetween Patch Coefficient Coefficient Double Double
  | -- | The line's distance from a centre, and the greatest that lets it meet the shape: no polynomial is solved.
    PassesNear Double Double
  deriving stock (Eq, Show)

-- | A coefficient: its letter, its formula, its value.
data Coefficient = Coefficient Text Text Double
  deriving stock (Eq, Show)

-- | What of a shape, or around it, a condition is about.
data Patch
  = ThePlane
  | TheSphere
  | TheTube
  | TheDoubleCone
  | TheTorus
  | -- | Between the planes at its ends.
    TheEnds
  | -- | Between two faces of a cube across an axis: x, y or z.
    TheFaces Text
  | -- | The sphere of a lens's face: at the start of its axis, or at the end.
    TheStartFace
  | TheEndFace
  deriving stock (Eq, Show)

-- | A root of a condition.
data Root = Root
  { -- | Where on the ray.
    rootParameter :: Double,
    -- | The place of its condition among the shape's, from 0.
    rootCondition :: Int,
    -- | What was measured there.
    rootMeasure :: Measure,
    -- | What becomes of it.
    rootFate :: Fate
  }
  deriving stock (Eq, Show)

-- | What becomes of a root.
data Fate
  = -- | It is the shape's hit.
    Taken
  | -- | The ray meets the shape there, too, later.
    Later
  | -- | Negative: behind the origin.
    Behind
  | -- | From 0 to 'Dioptre.Math.Tolerance.smallestParameter': where the ray starts.
    TooNear
  | -- | At the far clipping plane, or beyond it.
    BeyondFar
  | -- | The point is not on the shape.
    Outside
  deriving stock (Eq, Show)

-- | What is measured at a point that fulfils an equation, to know whether it is on the shape.
data Measure
  = -- | Its distance from the centre, and the radius, which is the greatest.
    AwayFromCentre Double Double
  | -- | Its distance from the centre, where it is less than the inner radius; and that.
    InTheHole Double Double
  | -- | Its distance from the centre, where it is on the ring between the inner and the outer radius; and those two.
    OnTheRing Double Double Double
  | -- | Its coordinates t1 and t2 in the triangle; neither is negative on it, and the sum is at most 1.
    Barycentric Double Double
  | -- | Its height along the axis, and the length; from 0 to that it is on the shape.
    AtHeight Double Double
  | -- | On which side of the disk it is.
    SideOfDisk
  | -- | Whether it fulfils the other conditions, if there are any.
    OtherConditions
  deriving stock (Eq, Show)

-- | What a ray meets first.
data Hit = Hit
  { -- | The shape.
    hitThing :: Thing,
    -- | t.
    hitParameter :: Double,
    -- | o + t d.
    hitPoint :: Point,
    -- | The unit normal, outward.
    hitOutward :: Unit,
    -- | The same turned against the ray.
    hitNormal :: Unit,
    -- | The texture coordinates.
    hitUv :: V2 Double,
    -- | The colours of the surface at the point.
    hitColours :: Colours,
    -- | Whether any of them comes from a picture.
    hitHasPicture :: Bool,
    -- | What each light gives, in their order; 'Nothing' under @no_light@, where the diffuse colour is seen as it is.
    hitShares :: Maybe [Share],
    -- | The rays that are thrown back or pass on.
    hitBounces :: [Bounce]
  }

-- | What one light gives.
data Share = Share
  { -- | From 0, in the order of the scene.
    shareLight :: Int,
    -- | What sort of light it is.
    shareKind :: LightKind,
    -- | The light's own colour.
    shareColour :: Colour,
    -- | How it comes to the point, or why it does not.
    shareArrival :: Arrival,
    -- | The terms that the light has under the scene's algorithm, as far as any light arrives.
    shareTerms :: [(Term, Colour)],
    -- | All of them together.
    shareTotal :: Colour
  }

-- | Kinds of lights.
data LightKind = AmbientKind | DirectionalKind | PointKind | WaveKind
  deriving stock (Eq, Show)

-- | How a light comes to a point.
data Arrival
  = -- | From everywhere.
    FromAllSides
  | -- | The algorithm leaves it out.
    LeftOut
  | -- | Not at all: the point is where the light is, or its attenuation divides by zero there.
    Nowhere
  | -- | The surface is turned away from it.
    FacesAway Approach
  | -- | Something is in the way: what, if it can be told, and how far from the point.
    InShadow Approach (Maybe (Thing, Double))
  | -- | Directly, or through transparent shapes: what they leave of it, and which they are.
    Arrives Approach Colour [Thing]
  deriving stock (Eq, Show)

-- | The way from a light to a point.
data Approach = Approach
  { -- | The unit direction in which the light travels.
    approachDirection :: Vector,
    -- | How far away the light is; 'Nothing' for infinitely far.
    approachDistance :: Maybe Double,
    -- | What the light is multiplied with for its distance.
    approachFactor :: Double,
    -- | The cosine of the angle between the normal and the direction to the light.
    approachCosine :: Double
  }
  deriving stock (Eq, Show)

-- | Terms of illumination.
data Term = AmbientTerm | DiffuseTerm | BlinnTerm | PhongTerm | WaveTerm
  deriving stock (Eq, Show)

-- | A ray that is thrown back or passes on.
data Bounce = Bounce
  { -- | Which way it goes.
    bounceKind :: BounceKind,
    -- | kr of a mirror; kt of what lets light pass.
    bounceCoefficient :: Double,
    -- | The angle between the arriving ray and the normal, in radians.
    bounceAngleIn :: Double,
    -- | What becomes of it.
    bounceSequel :: Sequel
  }

-- | Thrown back, or passing from one refractive index into another.
data BounceKind
  = Reflection
  | -- | Index before and behind the surface; whether the ray enters the shape.
    Refraction Double Double Bool
  deriving stock (Eq, Show)

-- | What becomes of a bounce.
data Sequel
  = -- | The ray is followed: its angle with the normal, in radians, and its story.
    Followed Double RayStory
  | NotFollowed Obstacle

-- | Why a ray is not followed.
data Obstacle
  = -- | It would be deeper than @recursive_level@.
    DepthReached
  | -- | Too many rays were followed already ('Dioptre.Scene.Raytracer.mostRays').
    TooManyRays
  | -- | All light is reflected.
    TotalReflection
  | -- | The shape is a surface without an inside, into which nothing passes.
    NoInside
  deriving stock (Eq, Show)
