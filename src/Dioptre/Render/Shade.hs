{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness #-}

-- |
-- Module      : Dioptre.Render.Shade
-- Description : The colour that a ray sees
--
-- What a ray meets first is lit by every light that reaches it, directly or through transparent shapes; a mirror adds what the
-- reflected ray sees, and a transparent body what the refracted ray sees:
--
-- > colour = sum over lights (ambient + lambert + highlight)
-- >        + kr . colour of the reflected ray
-- >        + kt . colour of the refracted ray       (tinted where it enters)
--
-- The equation is recursive; the program is a loop. See Note [Rays as a stack].
module Dioptre.Render.Shade
  ( -- * Shading
    Seen (..),
    look,
    unlit,

    -- * Parts
    Lit (..),
    lighting,
    Passage (..),
    passage,
    mediumAt,
    mostRays,
  )
where

import qualified Data.Vector as Vector
import Dioptre.Geometry.Prepared (Prepared, contains, isClosed, nearest, normalAt, shadingNormal, textureAt)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Light.Colour (Colour (..), black, filtered, plus, scaled)
import Dioptre.Light.Illumination (ambient, blinn, lambert, phong)
import Dioptre.Light.Wave (intensity)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Vector (Packed, Point, Unit, Vector, dot, modulus, packed, packedUnit, unpacked, unpackedUnit, vector, (^/))
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Dioptre.Render.Stage
import Dioptre.Render.Texture (texel)
import Dioptre.Render.World (Closest (..), closest, shapeAt, worldShapes)
import Linear.V3 (V3 (..))

-- | What a ray sees.
data Seen = Seen
  { seenColour :: !Colour,
    -- | How many rays were cast for it: primary, reflected, refracted and shadow rays.
    seenRays :: {-# UNPACK #-} !Int,
    -- | Whether more rays were wanted than 'mostRays' allows.
    seenCut :: !Bool
  }
  deriving stock (Eq, Show)

-- | For one primary ray no more rays than this are followed, shadow rays not counted.
mostRays :: Int
mostRays = 65536

-- | Without light: the diffuse colour of the first surface, as opaque as its material, or black.
unlit :: Stage -> Double -> Ray -> Colour
unlit s far r = case closest (stageWorld s) r far of
  Nowhere -> black
  At t i -> case shapeAt (stageWorld s) i of
    Just shape -> diffuseOf (coloursAt (surfaceOf s i) shape r t)
    Nothing -> black

-- | With light: what the ray sees, up to the stage's depth, no farther than that from the start of each ray.
look :: Stage -> Terms -> Double -> Ray -> Seen
look s terms far !r
  | stageDepth s == 1 = lookOnce s terms far r
  | otherwise = follow s terms far (Pending r 1 1 1 1 (mediumAt s Nothing (origin r)) `Then` Done)

-- | One ray, no bounce.
lookOnce :: Stage -> Terms -> Double -> Ray -> Seen
lookOnce s terms far !r = case closest (stageWorld s) r far of
  Nowhere -> Seen black 1 False
  At t i -> case lighting s terms r t i of
    Lit red' green' blue' n -> Seen (Colour red' green' blue' 1) (n + 1) False

-- | A ray to follow: how deep it is, the weight of what it sees in red, green and blue, and the refractive index of where it travels.
data Pending = Pending !Ray {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

data Stack = Done | Then !Pending !Stack

-- | Follows all rays of a stack, the top one first, and adds up what they see by its weight.
follow :: Stage -> Terms -> Double -> Stack -> Seen
follow s terms far = go 0 0 black
  where
    go :: Int -> Int -> Colour -> Stack -> Seen
    go !_ !rays !total Done = Seen total rays False
    go !followed !rays !total (Pending r depth wr wg wb index `Then` rest)
      | followed >= mostRays = Seen total rays True
      | otherwise = case closest (stageWorld s) r far of
        Nowhere -> go (followed + 1) (rays + 1) total rest
        At t i -> case lighting s terms r t i of
          Lit red' green' blue' n ->
            -- The number of the closest shape is that of a shape.
            let !total' = total `plus` Colour (wr * red') (wg * green') (wb * blue') 1
                !bounces = if depth < stageDepth s then branches (Vector.unsafeIndex (worldShapes (stageWorld s)) i) r t i depth wr wg wb index rest else rest
             in go (followed + 1) (rays + 1 + n) total' bounces

    -- The reflected ray goes on top, so that it is followed first.
    branches !shape !r !t !i !depth !wr !wg !wb !index rest
      | kr == 0 && not (isTransparent surf) = rest
      | otherwise = mirrored (through rest)
      where
        !surf = surfaceOf s i
        !kr = surfaceMirror surf
        outward = unpackedUnit outwardAtRest
        n = unpackedUnit nAtRest
        !outwardAtRest = packedUnit (normalAt shape r t)
        !nAtRest = packedUnit (shadingNormal r outward)
        v = direction r
        p = position r t
        mirrored stack
          | kr == 0 = stack
          | otherwise = Pending (ray p (reflected v n)) (depth + 1) (kr * wr) (kr * wg) (kr * wb) index `Then` stack
        through stack
          | not (isTransparent surf) || not (isClosed shape) = stack
          | dot v (vector outward) > 0 =
            let kt = surfaceTransparency surf
             in onwards stack (mediumAt s (Just i) p) (kt * wr) (kt * wg) (kt * wb)
          | otherwise =
            let Colour tr tg tb _ = surfaceTint surf
             in onwards stack (surfaceIndex surf) (tr * wr) (tg * wg) (tb * wb)
          where
            onwards below beyond r' g' b' = case refracted v n index beyond of
              Nothing -> below
              Just v' -> Pending (ray p v') (depth + 1) r' g' b' beyond `Then` below

-- | An amount of red, green and blue light, and how many shadow rays it took.
data Lit = Lit {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Int

-- | The light that the shape of number i sends along a ray that meets it at parameter t: the sum over all lights, in their order.
lighting :: Stage -> Terms -> Ray -> Double -> Int -> Lit
lighting s terms !r !t i = case shapeAt (stageWorld s) i of
  Nothing -> Lit 0 0 0 0
  Just shape ->
    let !colours = coloursAt (surfaceOf s i) shape r t
        !n = packedUnit (shadingNormal r (normalAt shape r t))
        !p = packed (position r t)
        !v = packed (direction r)
        !sources = stageSources s
        go !k !red' !green' !blue' !rays
          | k >= Vector.length sources = Lit red' green' blue' rays
          | otherwise = case illuminated s terms colours p n v (Vector.unsafeIndex sources k) of
            Lit r' g' b' m -> go (k + 1) (red' + r') (green' + g') (blue' + b') (rays + m)
     in go (0 :: Int) 0 0 0 0

-- | The light of one source at a point with normal n, seen in direction v.
illuminated :: Stage -> Terms -> Colours -> Packed -> Packed -> Packed -> Source -> Lit
illuminated s terms !colours !at !normal !view source = case source of
  FromEverywhere light
    | termAmbient terms -> litBy (ambient light (ambientOf colours)) 0
    | otherwise -> Lit 0 0 0 0
  FromFar light d ->
    arriving (unpacked d) infinity $ \filter' -> surfaceTerms terms colours n v (unpacked d) (throughFilter light filter')
  FromPoint light place amplification attenuators ->
    from place amplification attenuators $ \d factor filter' -> scaled factor (surfaceTerms terms colours n v d (throughFilter light filter'))
  FromWaves light place amplification attenuators wave sources ->
    from place amplification attenuators $ \_ factor filter' ->
      if dark (throughFilter light filter') then black else scaled (factor * intensity wave sources p) light
  where
    p = unpacked at
    n = unpackedUnit normal
    v = unpacked view
    -- What arrives along d from a distance, unless the surface is turned away or something stands between.
    arriving d distance' shine
      | negate (dot (vector n) d) <= 0 = Lit 0 0 0 0
      | otherwise = case passage s (ray p (negate d)) distance' of
        Blocked -> Lit 0 0 0 1
        open -> litBy (shine open) 1
    {-# INLINE arriving #-}
    -- From a place, with attenuation; nothing from the very place itself, or where the attenuation divides by zero.
    from place amplification attenuators shine
      | distance' == 0 || denominator == 0 = Lit 0 0 0 0
      | otherwise = arriving d distance' (shine d (amplification / denominator))
      where
        between = p - unpacked place
        distance' = modulus between
        d = between ^/ distance'
        V3 constant linear quadratic = unpacked attenuators
        denominator = constant + linear * distance' + quadratic * distance' * distance'
    {-# INLINE from #-}

litBy :: Colour -> Int -> Lit
litBy (Colour r g b _) = Lit r g b
{-# INLINE litBy #-}

infinity :: Double
infinity = 1 / 0

-- | Lambert's term and the highlight.
{-# INLINE surfaceTerms #-}
surfaceTerms :: Terms -> Colours -> Unit -> Vector -> Vector -> Colour -> Colour
surfaceTerms terms colours n v d light
  | dark light = black
  | otherwise = diffuse' `plus` highlight
  where
    diffuse'
      | termDiffuse terms = lambert light (diffuseOf colours) n d
      | otherwise = black
    highlight = case termHighlight terms of
      NoHighlight -> black
      BlinnHighlight -> blinn light (specularOf colours) n d v (shininessOf colours)
      PhongHighlight -> phong light (specularOf colours) n d v (shininessOf colours)

-- | Whether a light has been filtered away.
dark :: Colour -> Bool
dark (Colour r g b _) = r < smallestLength && g < smallestLength && b < smallestLength

-- | What stands between a point and a light.
data Passage
  = -- | Something that lets nothing through.
    Blocked
  | -- | Nothing.
    Clear
  | -- | Transparent shapes: the product of their tints.
    Tinted {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  deriving stock (Eq, Show)

-- | What a shadow ray meets nearer than a bound. Each shape tints the light once, however often the ray crosses it.
--
-- Law: it does not depend on the order of the shapes, up to the rounding of the product.
passage :: Stage -> Ray -> Double -> Passage
passage s !r !distance' = go 0 False 1 1 1
  where
    !shapes = worldShapes (stageWorld s)
    !size = Vector.length shapes
    go !k !tinted !tr !tg !tb
      | k >= size = if tinted then Tinted tr tg tb else Clear
      | nearest (Vector.unsafeIndex shapes k) r distance' < distance' =
        let surf = Vector.unsafeIndex (stageSurfaces s) k
            Colour r' g' b' _ = surfaceTint surf
         in if isTransparent surf then go (k + 1) True (tr * r') (tg * g') (tb * b') else Blocked
      | otherwise = go (k + 1) tinted tr tg tb

throughFilter :: Colour -> Passage -> Colour
throughFilter light filter' = case filter' of
  Blocked -> black
  Clear -> light
  Tinted r g b -> filtered light (Colour r g b 1)

-- | The refractive index at a point, a shape left out: 1 outside all closed shapes, that of the material inside one, the mean inside several.
-- A point on a surface is not inside.
mediumAt :: Stage -> Maybe Int -> Point -> Double
mediumAt s leftOut p
  | not (stageHasMedia s) = 1
  | otherwise = case [surfaceIndex (surfaceOf s i) | (i, shape) <- zip [0 ..] (Vector.toList (worldShapes (stageWorld s))), Just i /= leftOut, contains shape p] of
    [] -> 1
    indices -> sum indices / fromIntegral (length indices)

-- | The colours of a surface at one of its points.
data Colours = Colours {ambientOf :: !Colour, diffuseOf :: !Colour, specularOf :: !Colour, shininessOf :: {-# UNPACK #-} !Double}

coloursAt :: Surface -> Prepared -> Ray -> Double -> Colours
coloursAt surf shape r t = case surfaceTextures surf of
  Nothing -> Colours (surfaceAmbient surf) (surfaceDiffuse surf) (surfaceSpecular surf) (surfaceShininess surf)
  Just (TexturedColours a d h) ->
    let uv = textureAt shape r t
        or' plain = maybe plain (`texel` uv)
     in Colours (or' (surfaceAmbient surf) a) (or' (surfaceDiffuse surf) d) (or' (surfaceSpecular surf) h) (surfaceShininess surf)

-- | The surface of a shape that is there.
surfaceOf :: Stage -> Int -> Surface
surfaceOf s = Vector.unsafeIndex (stageSurfaces s)
{-# INLINE surfaceOf #-}

-- Note [Rays as a stack]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- Unrolled, the recursion is a sum over all paths of the direct light at the path's end, weighted by the product of the coefficients on the
-- way. The loop keeps the rays that remain on a stack, with their weights, and adds to one total: it takes no Haskell stack however deep the
-- mirrors are, and it can count. Depth first, reflection before refraction, so that it is known which rays are the first mostRays.
-- The sum is the same as the recursive one up to rounding in binary64, which disappears in the byte.
