{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Optics
-- Description : The operations of the profile optics
--
-- "Dioptre.Optics.Reflection" and "Dioptre.Optics.Refraction". The direction is made unit, and the normal made unit and
-- turned against it.
module Dioptre.Conformance.Optics
  ( operations,
    against,
  )
where

import Data.Aeson (Value (Null))
import Data.Text (Text)
import Dioptre.Conformance.Parameter (Operation, field, number, ofVector, unitVector)
import Dioptre.Math.Vector (Unit, dot, opposite, vector)
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)

-- | By their names. The result of @optics.refract@ is null where all is reflected.
--
-- Spec: protocol.operations, optics.reflect.operation, optics.refract.operation.
operations :: [(Text, Operation)]
operations =
  [ ("optics.reflect", \o -> do (v, n) <- meeting o; ofVector (reflected (vector v) n)),
    ("optics.refract", \o -> do (v, n) <- meeting o; n1 <- index o "n1"; n2 <- index o "n2"; maybe (pure Null) ofVector (refracted (vector v) n n1 n2))
  ]
  where
    meeting o = do
      v <- field unitVector o "direction"
      n <- field unitVector o "normal"
      pure (v, against v n)
    index o name = do
      n <- field number o name
      if n > 0 then pure n else fail "a refractive index is greater than zero"

-- | The normal turned against a direction: -N where \<v, N> > 0, otherwise N. (A ray that runs along a surface has
-- the other of the two for a picture: 'Dioptre.Geometry.Prepared.shadingNormal'.)
--
-- Spec: protocol.directions, optics.reflect.operation, optics.refract.operation.
against :: Unit -> Unit -> Unit
against v n
  | dot (vector v) (vector n) > 0 = opposite n
  | otherwise = n
