{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Maths
-- Description : The operations of the profile maths
--
-- Vectors, roots and transformations: "Dioptre.Math.Vector", "Dioptre.Math.Roots", "Dioptre.Math.Quartic",
-- "Dioptre.Math.Transform".
module Dioptre.Conformance.Maths
  ( operations,
  )
where

import Control.Monad ((>=>))
import Data.Aeson (Object, Value (..), toJSON)
import Data.Aeson.Types (Parser)
import Data.Foldable (toList)
import Data.Text (Text)
import Dioptre.Conformance.Parameter (Operation, field, fieldOr, number, ofRay, ofVector, ray, real, reals, unitVector, vector)
import Dioptre.Geometry.Placement (Placement, carriedForth, placement)
import Dioptre.Math.Quartic (cubicRoots, quarticRoots)
import Dioptre.Math.Roots (linearRoots, quadraticRoots)
import Dioptre.Math.Transform (Transform, identity, matrix, transform, transformDirection, transformNormal, transformPosition, transformRotation, transformScale, transformTranslation)
import Dioptre.Math.Vector (Vector, angle, cross, distance, dot, modulus, unit, (*^))
import qualified Dioptre.Math.Vector as Vector

-- | By their names. The results of @roots.*@ are ascending, as often as their multiplicity. The parts of a
-- transformation that are left out change nothing.
--
-- Spec: protocol.operations.
operations :: [(Text, Operation)]
operations =
  [ ("vector.add", ofTwo (\a b -> ofVector (a + b))),
    ("vector.subtract", ofTwo (\a b -> ofVector (a - b))),
    ("vector.dot", ofTwo (\a b -> real (dot a b))),
    ("vector.cross", ofTwo (\a b -> ofVector (cross a b))),
    ("vector.distance", ofTwo (\a b -> real (distance a b))),
    ("vector.angle", ofTwo (\a b -> real (angle a b))),
    ("vector.scale", \o -> do k <- field number o "k"; a <- field vector o "a"; ofVector (k *^ a)),
    ("vector.modulus", \o -> field vector o "a" >>= real . modulus),
    ("vector.normalize", \o -> field vector o "a" >>= maybe (pure Null) (ofVector . Vector.vector) . unit),
    ("roots.linear", \o -> linearRoots <$> at o "a" <*> at o "b" >>= reals),
    ("roots.quadratic", \o -> quadraticRoots <$> at o "a" <*> at o "b" <*> at o "c" >>= reals),
    ("roots.cubic", \o -> cubicRoots <$> at o "a" <*> at o "b" <*> at o "c" <*> at o "d" >>= reals),
    ("roots.quartic", \o -> quarticRoots <$> at o "a" <*> at o "b" <*> at o "c" <*> at o "d" <*> at o "e" >>= reals),
    ("transform.matrix", transformOf >=> fmap toJSON . traverse (reals . toList) . toList . matrix),
    ("transform.position", carrying vector (\m -> ofVector . transformPosition m)),
    ("transform.direction", carrying vector (\m -> ofVector . transformDirection m)),
    ("transform.normal", carrying unitVector (\m -> ofVector . Vector.vector . transformNormal m)),
    ("transform.ray", \o -> do m <- transformOf o; r <- field ray o "ray"; ofRay (carriedForth (placement m) r))
  ]
  where
    at = field number

-- | An operation on two vectors.
ofTwo :: (Vector -> Vector -> Parser Value) -> Operation
ofTwo f o = do
  a <- field vector o "a"
  b <- field vector o "b"
  f a b

-- | An operation on a vector under a transformation.
carrying :: (Value -> Parser a) -> (Placement -> a -> Parser Value) -> Operation
carrying argument f o = do
  t <- transformOf o
  v <- field argument o "vector"
  f (placement t) v

-- | Scale, rotation and translation; no factor of the scale is zero.
transformOf :: Object -> Parser Transform
transformOf o = do
  s <- fieldOr (transformScale identity) vector o "scale"
  r <- fieldOr (transformRotation identity) vector o "rotation"
  t <- fieldOr (transformTranslation identity) vector o "translation"
  maybe (fail "a factor of the scale is zero") pure (transform s r t)
