{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Conformance.Optics
-- Description : The operations of the profile optics
--
-- "Dioptre.Optics.Reflection" and "Dioptre.Optics.Refraction". The direction is made unit, and the normal made unit and turned against it.
module Dioptre.Conformance.Optics
  ( operations,
  )
where

import Data.Aeson (Value (Null))
import Data.Text (Text)
import Dioptre.Conformance.Parameter (Operation, field, number, ofVector, unitVector)
import Dioptre.Math.Vector (vector)
import Dioptre.Optics.Reflection (reflect)
import Dioptre.Optics.Refraction (refract)

-- | By their names. The result of @optics.refract@ is null where all is reflected.
operations :: [(Text, Operation)]
operations =
  [ ("optics.reflect", \o -> do v <- travelling o; n <- field unitVector o "normal"; maybe (fail "there is no direction") ofVector (reflect v n)),
    ("optics.refract", \o -> do v <- travelling o; n <- field unitVector o "normal"; n1 <- index o "n1"; n2 <- index o "n2"; maybe (pure Null) ofVector (refract v n n1 n2))
  ]
  where
    travelling o = vector <$> field unitVector o "direction"
    index o name = do
      n <- field number o name
      if n > 0 then pure n else fail "a refractive index is greater than zero"
