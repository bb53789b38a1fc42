{-# LANGUAGE DeriveTraversable #-}
{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Light.Finish
-- Description : The colours that light meets
--
-- What shading needs of a material: the colour in ambient light, in diffused light and in highlights, and how much it
-- mirrors and lets through. A scene's 'Material' states these by one colour and several coefficients; the material
-- library of a model states them one by one.
module Dioptre.Light.Finish
  ( Finish (..),
    Colours (..),
    finish,

    -- * Pictures
    Pictures (..),
    pictures,
    Layer (..),
    finishAmbient,
    finishDiffuse,
    finishSpecular,
    withAmbient,
    withDiffuse,
    withSpecular,
    withPictures,
    hasPictures,

    -- * Transparency
    isTransparent,
  )
where

import Data.Text (Text)
import Dioptre.Light.Colour (Colour, scaled)
import Dioptre.Light.Material (Material (..), Textures (..), ambientColour, diffuseColour, specularColour)

-- | The colours of a surface. A picture may stand in for some of them: it is known by its name first, and later the
-- picture itself.
data Finish picture = Finish
  { -- | Its colours, where no picture stands in.
    finishColours :: !Colours,
    finishPictures :: !(Pictures picture),
    -- | How much of a mirror it is, kr, from 0 to 1.
    finishMirror :: {-# UNPACK #-} !Double,
    -- | How much light it lets through, kt, from 0 to 1.
    finishTransparency :: {-# UNPACK #-} !Double,
    -- | What light that passes is multiplied with: the colour times kt.
    finishTint :: {-# UNPACK #-} !Colour,
    -- | The refractive index inside; 1 where nothing passes.
    finishIndex :: {-# UNPACK #-} !Double
  }
  deriving stock (Eq, Show, Functor, Foldable, Traversable)

-- | The colours of a surface.
data Colours = Colours
  { ambientOf :: {-# UNPACK #-} !Colour,
    diffuseOf :: {-# UNPACK #-} !Colour,
    specularOf :: {-# UNPACK #-} !Colour,
    -- | The exponent of highlights, 0 or more.
    shininessOf :: {-# UNPACK #-} !Double
  }
  deriving stock (Eq, Show)

-- | The pictures that stand in for colours where there are texture coordinates. Most surfaces have none, which must be
-- known quickly: 'NoPictures'. 'pictures' makes the others, and sees to it that one of the three is there.
data Pictures picture
  = NoPictures
  | -- | Ambient, diffuse and specular.
    Pictures !(Maybe picture) !(Maybe picture) !(Maybe picture)
  deriving stock (Eq, Show, Functor, Foldable, Traversable)

-- | Pictures for the ambient, the diffuse and the specular colour.
pictures :: Maybe picture -> Maybe picture -> Maybe picture -> Pictures picture
pictures Nothing Nothing Nothing = NoPictures
pictures a d s = Pictures a d s

-- | A colour, and the picture, if any, that stands in for it.
data Layer picture = Layer !Colour !(Maybe picture)
  deriving stock (Eq, Show)

-- | The ambient, the diffuse and the specular colour, each with the picture that stands in for it.
finishAmbient, finishDiffuse, finishSpecular :: Finish picture -> Layer picture
finishAmbient f = Layer (ambientOf (finishColours f)) (let (a, _, _) = each (finishPictures f) in a)
finishDiffuse f = Layer (diffuseOf (finishColours f)) (let (_, d, _) = each (finishPictures f) in d)
finishSpecular f = Layer (specularOf (finishColours f)) (let (_, _, s) = each (finishPictures f) in s)

-- | The same finish with another ambient, diffuse or specular layer, and the other two as they were.
withAmbient, withDiffuse, withSpecular :: Layer picture -> Finish picture -> Finish picture
withAmbient (Layer c p) f = f {finishColours = (finishColours f) {ambientOf = c}, finishPictures = let (_, d, s) = each (finishPictures f) in pictures p d s}
withDiffuse (Layer c p) f = f {finishColours = (finishColours f) {diffuseOf = c}, finishPictures = let (a, _, s) = each (finishPictures f) in pictures a p s}
withSpecular (Layer c p) f = f {finishColours = (finishColours f) {specularOf = c}, finishPictures = let (a, d, _) = each (finishPictures f) in pictures a d p}

-- | All three, where there are no pictures too.
each :: Pictures picture -> (Maybe picture, Maybe picture, Maybe picture)
each NoPictures = (Nothing, Nothing, Nothing)
each (Pictures a d s) = (a, d, s)

-- | The finish of a material; pictures by the names of their files.
--
-- Spec: light.material.tint, light.material.index.
finish :: Material -> Finish Text
finish m =
  Finish
    { finishColours = Colours (ambientColour m) (diffuseColour m) (specularColour m) (materialShininess m),
      finishPictures = pictures (named textureKa) (named textureKd) (named textureKs),
      finishMirror = materialKr m,
      finishTransparency = materialKt m,
      finishTint = scaled (materialKt m) (materialColour m),
      finishIndex = if materialKt m /= 0 then materialRefractiveIndex m else 1
    }
  where
    named which = materialTextures m >>= which

-- | The same finish with its pictures looked up: a colour stands for itself where there is none.
--
-- Spec: light.material.texture.
withPictures :: (a -> Maybe b) -> Finish a -> Finish b
withPictures look f = f {finishPictures = let (a, d, s) = each (finishPictures f) in pictures (a >>= look) (d >>= look) (s >>= look)}

-- | Whether it lets light through.
--
-- Spec: light.material.tint.
isTransparent :: Finish picture -> Bool
isTransparent f = finishTransparency f /= 0
{-# INLINE isTransparent #-}

-- | Whether a picture stands in for any of its colours.
hasPictures :: Finish picture -> Bool
hasPictures = not . null
