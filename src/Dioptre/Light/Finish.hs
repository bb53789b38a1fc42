{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Light.Finish
-- Description : The colours that light meets
--
-- What shading needs of a material: the colour in ambient light, in diffused light and in highlights, and how much it mirrors and lets through. A
-- scene's 'Material' states these by one colour and several coefficients; the material library of a model states them one by one.
module Dioptre.Light.Finish
  ( Finish (..),
    Layer (..),
    finish,
    withPictures,
    isTransparent,
    hasPictures,
  )
where

import Data.Text (Text)
import Dioptre.Light.Colour (Colour, scaled)
import Dioptre.Light.Material (Material (..), Textures (..), ambientColour, diffuseColour, specularColour)

-- | The colours of a surface. A picture may stand in for some of them: it is known by its name first, and later the picture itself.
data Finish picture = Finish
  { finishAmbient :: !(Layer picture),
    finishDiffuse :: !(Layer picture),
    finishSpecular :: !(Layer picture),
    -- | The exponent of highlights, 0 or more.
    finishShininess :: {-# UNPACK #-} !Double,
    -- | How much of a mirror it is, kr, from 0 to 1.
    finishMirror :: {-# UNPACK #-} !Double,
    -- | How much light it lets through, kt, from 0 to 1.
    finishTransparency :: {-# UNPACK #-} !Double,
    -- | What light that passes is multiplied with: the colour times kt.
    finishTint :: !Colour,
    -- | The refractive index inside; 1 where nothing passes.
    finishIndex :: {-# UNPACK #-} !Double
  }
  deriving stock (Eq, Show, Functor, Foldable, Traversable)

-- | A colour, and the picture, if any, that stands in for it where there are texture coordinates.
data Layer picture = Layer !Colour !(Maybe picture)
  deriving stock (Eq, Show, Functor, Foldable, Traversable)

-- | The finish of a material; pictures by their names (the name @none@ stands for none).
finish :: Material -> Finish Text
finish m =
  Finish
    { finishAmbient = Layer (ambientColour m) (named textureKa),
      finishDiffuse = Layer (diffuseColour m) (named textureKd),
      finishSpecular = Layer (specularColour m) (named textureKs),
      finishShininess = materialShininess m,
      finishMirror = materialKr m,
      finishTransparency = materialKt m,
      finishTint = scaled (materialKt m) (materialColour m),
      finishIndex = if materialKt m /= 0 then materialRefractiveIndex m else 1
    }
  where
    named which = materialTextures m >>= given . which
    given name = if name `elem` ["", "none"] then Nothing else Just name

-- | The same finish with its pictures looked up: a colour stands for itself where there is none.
withPictures :: (a -> Maybe b) -> Finish a -> Finish b
withPictures look f =
  f {finishAmbient = layer (finishAmbient f), finishDiffuse = layer (finishDiffuse f), finishSpecular = layer (finishSpecular f)}
  where
    layer (Layer c p) = Layer c (p >>= look)

-- | Whether it lets light through.
isTransparent :: Finish picture -> Bool
isTransparent f = finishTransparency f /= 0
{-# INLINE isTransparent #-}

-- | Whether a picture stands in for any of its colours.
hasPictures :: Finish picture -> Bool
hasPictures = not . null
