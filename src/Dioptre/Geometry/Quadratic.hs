-- |
-- Module      : Dioptre.Geometry.Quadratic
-- Description : The equation of the second degree that a line and a round surface make
--
-- > A t^2 + B t + C = 0
--
-- A shape's module makes the equation, its rule takes the roots, and the story of a pixel tells the coefficients
-- ("Dioptre.Explain.Polynomial"): what is told is what is solved.
module Dioptre.Geometry.Quadratic
  ( Quadratic (..),
    rootsOf,
  )
where

import Dioptre.Math.Roots (quadraticRoots)

-- | A, B and C.
data Quadratic = Quadratic Double Double Double

-- | Its real roots, ascending.
rootsOf :: Quadratic -> [Double]
rootsOf (Quadratic a b c) = quadraticRoots a b c
{-# INLINE rootsOf #-}
