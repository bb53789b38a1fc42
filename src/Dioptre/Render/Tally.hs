{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Render.Tally
-- Description : What a picture, or a part of it, has taken
module Dioptre.Render.Tally
  ( Tally (..),
  )
where

-- | How many rays were cast, and how many times one was tried on a shape.
data Tally = Tally
  { -- | Primary, reflected, refracted and shadow rays.
    tallyRays :: {-# UNPACK #-} !Int,
    tallyTests :: {-# UNPACK #-} !Int,
    -- | How many samples wanted more rays than are followed ('Dioptre.Scene.Raytracer.mostRays').
    tallyCut :: {-# UNPACK #-} !Int
  }
  deriving stock (Eq, Show)

-- | Two parts together.
instance Semigroup Tally where
  Tally a b c <> Tally d e f = Tally (a + d) (b + e) (c + f)

-- | Nothing yet.
instance Monoid Tally where
  mempty = Tally 0 0 0
