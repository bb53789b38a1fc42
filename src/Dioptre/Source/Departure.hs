{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Source.Departure
-- Description : Where the original program does something else, as data
--
-- Not what is wrong with a scene, but what the program that these scenes were once written for makes of it, where
-- Dioptre does otherwise. "Dioptre.Scene.Original" finds the places; the texts stand in
-- "Dioptre.Source.DepartureMessage". Annex C of the specification lists them.
module Dioptre.Source.Departure
  ( Departure (..),
    departureCode,
  )
where

import Data.Text (Text)

-- | What the original program does with a scene, where Dioptre does something else.
data Departure
  = -- | It passes over everything behind a comment of one line, down to that line (none: the end of the file).
    HidesLines (Maybe Int)
  | -- | It stops reading the scene.
    EndsScene
  | -- | It reads what stands in an object that cannot stand here as if it stood in the object around it, which its end then closes.
    ReadsAround
  | -- | It does not take the word for @end@: the object stays open.
    ReadsOn
  | -- | It does not let that word, on that line, close the object, which stays open.
    KeepsOpen Text Int
  | -- | A camera, viewport or raytracer starts from the earlier one, on that line.
    StartsFromEarlier Int
  | -- | It does not know the word.
    LacksWord Text
  | -- | It reads that as a number, of which here none is larger than that.
    ReadsNumber Text Double
  | -- | It abandons the object at a negative colour.
    AbandonsObject
  | -- | It writes a picture into any folder.
    WritesAnywhere
  | -- | It admits a refractive index of zero.
    AdmitsZeroIndex
  | -- | It admits a scale of zero.
    AdmitsZeroScale
  | -- | It ends with an error at a curvature below the radius.
    EndsAtCurvature
  | -- | It knows no limit of pixels and sources.
    LacksLimit
  | -- | No ray ever meets a shape of that word.
    NeverHits Text
  | -- | It ends with an error where a ray runs in the plane of a flat shape or a face, in which the camera stands.
    EndsEdgeOn Text
  | -- | It may end with an error where a shape is so small, as seen from the camera, that its hits are not on it.
    EndsFarAway Text
  | -- | It refuses points as near to each other as these.
    RefusesNearPoints
  | -- | It refuses triangles as small as this.
    RefusesSmallTriangle
  | -- | It does not make the interpolated normals of a smooth triangle unit.
    LeavesNormals
  | -- | It puts no texture on a shape of that word.
    LeavesTexture Text
  | -- | It takes the middle of an odd size half a pixel off.
    HalfAPixelOff
  | -- | Its console program draws only so many pixels, of so many.
    DrawsPart Integer Integer
  | -- | Its random pixel coordinates are others on each run.
    DrawsByChance
  | -- | It works with so many threads, and does not end by itself.
    StaysWithThreads Int
  | -- | Its voxels lose hits.
    LosesHits
  | -- | It ends with an error where it shades with that algorithm.
    EndsAtPhong Text
  | -- | It ends with an error at an alpha above 1.
    EndsAtAlpha
  | -- | It knows no limit of rays for a pixel, as this one is.
    LacksRayLimit Int
  | -- | It ends with an error at a light from a row of sources.
    EndsAtRow
  | -- | It ends with an error where the attenuation divides by less than that.
    EndsAtAttenuation Double
  | -- | It reads dds pictures, though wrongly.
    ReadsDds
  | -- | It looks for a file whose name ends in blanks.
    KeepsBlanks
  | -- | It writes the object to out.txt under that word.
    WritesAs Text
  | -- | It transforms nothing of a model but flat triangles.
    LeavesModelInPlace
  deriving stock (Eq, Show)

-- | The code of a departure, which never changes.
departureCode :: Departure -> Text
departureCode = \case
  HidesLines {} -> "original-hides-lines"
  EndsScene -> "original-ends-scene"
  ReadsAround -> "original-reads-around"
  ReadsOn -> "original-reads-on"
  KeepsOpen {} -> "original-keeps-open"
  StartsFromEarlier {} -> "original-starts-from-earlier"
  LacksWord {} -> "original-lacks-word"
  ReadsNumber {} -> "original-reads-number"
  AbandonsObject -> "original-abandons-object"
  WritesAnywhere -> "original-writes-anywhere"
  AdmitsZeroIndex -> "original-admits-zero-index"
  AdmitsZeroScale -> "original-admits-zero-scale"
  EndsAtCurvature -> "original-ends-at-curvature"
  LacksLimit -> "original-lacks-limit"
  NeverHits {} -> "original-never-hits"
  EndsEdgeOn {} -> "original-ends-edge-on"
  EndsFarAway {} -> "original-ends-far-away"
  RefusesNearPoints -> "original-refuses-near-points"
  RefusesSmallTriangle -> "original-refuses-small-triangle"
  LeavesNormals -> "original-leaves-normals"
  LeavesTexture {} -> "original-leaves-texture"
  HalfAPixelOff -> "original-half-a-pixel-off"
  DrawsPart {} -> "original-draws-part"
  DrawsByChance -> "original-draws-by-chance"
  StaysWithThreads {} -> "original-stays-with-threads"
  LosesHits -> "original-loses-hits"
  EndsAtPhong {} -> "original-ends-at-phong"
  EndsAtAlpha -> "original-ends-at-alpha"
  LacksRayLimit {} -> "original-lacks-ray-limit"
  EndsAtRow -> "original-ends-at-row"
  EndsAtAttenuation {} -> "original-ends-at-attenuation"
  ReadsDds -> "original-reads-dds"
  KeepsBlanks -> "original-keeps-blanks"
  WritesAs {} -> "original-writes-as"
  LeavesModelInPlace -> "original-leaves-model-in-place"
