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
    Colours (..),
    coloursAt,
    lighting,
    Way (..),
    Passage (..),
    passage,
    mediumAt,
    mostRays,
  )
where

import Data.List (foldl', sortOn)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Closest (Closest (..))
import Dioptre.Geometry.Prepared (isClosed, normalAt, shadingNormal, textureAt)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Light.Colour (Colour (..), black, capped, filtered, plus, scaled)
import Dioptre.Light.Finish (Finish (..), Layer (..), hasPictures, isTransparent)
import Dioptre.Light.Illumination (ambient, blinn, lambert, phong)
import Dioptre.Light.Wave (intensity)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Vector (Packed, Point, Unit, Vector, dot, modulus, packed, packedUnit, unpacked, unpackedUnit, vector, (^/))
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Dioptre.Render.Closest (closest)
import Dioptre.Render.Obstacles (Obstacles (..), obstacles)
import Dioptre.Render.Stage
import Dioptre.Render.Surface (Surface (..), finishAt, surfaceAt)
import Dioptre.Render.Surroundings (surroundings)
import Dioptre.Render.Texture (texel)
import Dioptre.Render.World (World, worldHasMedia)
import Linear.V3 (V3 (..))

-- | What a ray sees.
data Seen = Seen
  { seenColour :: !Colour,
    -- | How many rays were cast for it: primary, reflected, refracted and shadow rays.
    seenRays :: {-# UNPACK #-} !Int,
    -- | How many times one of them was tried on a shape.
    seenTests :: {-# UNPACK #-} !Int,
    -- | Whether more rays were wanted than 'mostRays' allows.
    seenCut :: !Bool
  }
  deriving stock (Eq, Show)

-- | For one primary ray no more rays than this are followed, shadow rays not counted.
mostRays :: Int
mostRays = 65536

-- | Without light: the diffuse colour of the first surface, as opaque as its material, or black.
unlit :: Stage -> Double -> Ray -> Seen
unlit s far r = case closest (stageWorld s) r far of
  Closest t i tests -> Seen (maybe black (colour t i) (finishAt (stageWorld s) i)) 1 tests False
  where
    colour t i f
      | hasPictures f = maybe black (\surface -> diffuseOf (coloursAt surface r t)) (surfaceAt (stageWorld s) i)
      | Layer c _ <- finishDiffuse f = c

-- | With light: what the ray sees, up to the stage's depth, no farther than that from the start of each ray.
look :: Stage -> Terms -> Double -> Ray -> Seen
look s terms far !r
  | stageDepth s == 1 = lookOnce s terms far r
  | otherwise = follow s terms far (Pending r 1 1 1 1 (mediumAt s Nothing (origin r)) `Then` Done)

-- | One ray, no bounce.
lookOnce :: Stage -> Terms -> Double -> Ray -> Seen
lookOnce s terms far !r = case closest (stageWorld s) r far of
  Closest t i tests -> case surfaceAt (stageWorld s) i of
    Nothing -> Seen black 1 tests False
    Just surface@(Surface shape _) -> case lighting s terms (coloursAt surface r t) (packed (position r t)) (packedUnit (shadingNormal r (normalAt shape r t))) (packed (direction r)) of
      Lit red' green' blue' n m -> Seen (Colour red' green' blue' 1) (n + 1) (m + tests) False

-- | A ray to follow: how deep it is, the weight of what it sees in red, green and blue, and the refractive index of where it travels.
data Pending = Pending !Ray {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

data Stack = Done | Then !Pending !Stack

-- | Follows all rays of a stack, the top one first, and adds up what they see by its weight.
follow :: Stage -> Terms -> Double -> Stack -> Seen
follow s terms far = go 0 0 0 black
  where
    go :: Int -> Int -> Int -> Colour -> Stack -> Seen
    go !_ !rays !tests !total Done = Seen total rays tests False
    go !followed !rays !tests !total (Pending r depth wr wg wb index `Then` rest)
      | followed >= mostRays = Seen total rays tests True
      | otherwise = case closest (stageWorld s) r far of
        Closest t i tried -> case surfaceAt (stageWorld s) i of
          Nothing -> go (followed + 1) (rays + 1) (tests + tried) total rest
          Just surface@(Surface shape _) ->
            let !at = packed (position r t)
                !outward = packedUnit (normalAt shape r t)
                !n = packedUnit (shadingNormal r (unpackedUnit outward))
             in case lighting s terms (coloursAt surface r t) at n (packed (direction r)) of
                  Lit red' green' blue' shadows m ->
                    let !total' = total `plus` Colour (wr * red') (wg * green') (wb * blue') 1
                        !bounces = if depth < stageDepth s then branches surface r (unpacked at) (unpackedUnit outward) (unpackedUnit n) i depth wr wg wb index rest else rest
                     in go (followed + 1) (rays + 1 + shadows) (tests + tried + m) total' bounces

    -- The reflected ray goes on top, so that it is followed first.
    branches (Surface shape f) !r p outward n !i !depth !wr !wg !wb !index rest
      | kr == 0 && not (isTransparent f) = rest
      | otherwise = mirrored (through rest)
      where
        !kr = finishMirror f
        v = direction r
        mirrored stack
          | kr == 0 = stack
          | otherwise = Pending (ray p (reflected v n)) (depth + 1) (kr * wr) (kr * wg) (kr * wb) index `Then` stack
        through stack
          | not (isTransparent f) || not (isClosed shape) = stack
          | dot v (vector outward) > 0 =
            let kt = finishTransparency f
             in onwards stack (mediumAt s (Just i) p) (kt * wr) (kt * wg) (kt * wb)
          | otherwise =
            let Colour tr tg tb _ = finishTint f
             in onwards stack (finishIndex f) (capped (tr * wr)) (capped (tg * wg)) (capped (tb * wb))
          where
            onwards below' beyond r' g' b' = case refracted v n index beyond of
              Nothing -> below'
              Just v' -> Pending (ray p v') (depth + 1) r' g' b' beyond `Then` below'

-- | An amount of red, green and blue light, how many shadow rays it took, and how many times one was tried on a shape.
data Lit = Lit {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Int {-# UNPACK #-} !Int

-- | The light that a surface with these colours sends back along a ray: at a point, with a normal turned against the ray, seen in a direction; the sum over all lights, in their order.
lighting :: Stage -> Terms -> Colours -> Packed -> Packed -> Packed -> Lit
lighting s terms !colours !p !n !v = go (0 :: Int) 0 0 0 0 0
  where
    !sources = stageSources s
    go !k !red' !green' !blue' !rays !tests
      -- One light may be infinitely bright by now, but none is NaN: its factors are finite.
      | k >= Vector.length sources = Lit (capped red') (capped green') (capped blue') rays tests
      | otherwise = case illuminated s terms colours p n v (Vector.unsafeIndex sources k) of
        Lit r' g' b' m tried -> go (k + 1) (red' + r') (green' + g') (blue' + b') (rays + m) (tests + tried)

-- | The light of one source at a point with normal n, seen in direction v.
illuminated :: Stage -> Terms -> Colours -> Packed -> Packed -> Packed -> Source -> Lit
illuminated s terms !colours !at !normal !view source = case source of
  FromEverywhere light
    | termAmbient terms -> litBy (ambient light (ambientOf colours)) 0 0
    | otherwise -> Lit 0 0 0 0 0
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
      | negate (dot (vector n) d) <= 0 = Lit 0 0 0 0 0
      | otherwise = case passage (stageWorld s) (ray p (negate d)) distance' of
        Passage light tests -> case light of
          Blocked -> Lit 0 0 0 1 tests
          open -> litBy (shine open) 1 tests
    {-# INLINE arriving #-}
    -- From a place, with attenuation; nothing from the very place itself, or where the attenuation divides by zero.
    from place amplification attenuators shine
      | distance' == 0 || denominator == 0 = Lit 0 0 0 0 0
      | otherwise = arriving d distance' (shine d (capped (amplification / denominator)))
      where
        between = p - unpacked place
        distance' = modulus between
        d = between ^/ distance'
        V3 constant linear quadratic = unpacked attenuators
        denominator = constant + linear * distance' + quadratic * distance' * distance'
    {-# INLINE from #-}

litBy :: Colour -> Int -> Int -> Lit
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
data Way
  = -- | Something that lets nothing through.
    Blocked
  | -- | Nothing.
    Clear
  | -- | Transparent shapes: the product of their tints.
    Tinted {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  deriving stock (Eq, Show)

-- | What stands there, and how many times the ray was tried on a shape to know it.
data Passage = Passage !Way {-# UNPACK #-} !Int
  deriving stock (Eq, Show)

-- | What a shadow ray meets nearer than a bound. Each shape tints the light once, however often the ray crosses it; tints are multiplied in the order of the shapes' numbers.
passage :: World -> Ray -> Double -> Passage
passage w !r !bound = case obstacles w r bound of
  Obstacles opaque through tests
    | opaque -> Passage Blocked tests
    | null through -> Passage Clear tests
    | otherwise -> Passage (foldl' tinted (Tinted 1 1 1) (sortOn fst through)) tests
  where
    tinted (Tinted r' g' b') (_, f) = let Colour x y z _ = finishTint f in Tinted (capped (r' * x)) (capped (g' * y)) (capped (b' * z))
    tinted other _ = other

throughFilter :: Colour -> Way -> Colour
throughFilter light way = case way of
  Blocked -> black
  Clear -> light
  Tinted r g b -> filtered light (Colour r g b 1)

-- | The refractive index at a point, a shape left out: 1 outside all closed shapes, that of the material inside one, the mean inside several.
-- A point on a surface is not inside.
mediumAt :: Stage -> Maybe Int -> Point -> Double
mediumAt s leftOut p
  | not (worldHasMedia (stageWorld s)) = 1
  | otherwise = case map finishIndex (surroundings (stageWorld s) leftOut p) of
    [] -> 1
    indices -> sum indices / fromIntegral (length indices)

-- | The colours of a surface at one of its points.
data Colours = Colours {ambientOf :: !Colour, diffuseOf :: !Colour, specularOf :: !Colour, shininessOf :: {-# UNPACK #-} !Double}

-- | The colours of a surface where a ray meets it, at a parameter.
coloursAt :: Surface -> Ray -> Double -> Colours
coloursAt (Surface shape f) r t = case f of
  Finish {finishAmbient = Layer a Nothing, finishDiffuse = Layer d Nothing, finishSpecular = Layer h Nothing} -> Colours a d h (finishShininess f)
  _ -> Colours (at (finishAmbient f)) (at (finishDiffuse f)) (at (finishSpecular f)) (finishShininess f)
  where
    uv = textureAt shape r t
    at (Layer plain picture) = maybe plain (`texel` uv) picture

-- Note [Rays as a stack]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- Unrolled, the recursion is a sum over all paths of the direct light at the path's end, weighted by the product of the coefficients on the
-- way. The loop keeps the rays that remain on a stack, with their weights, and adds to one total: it takes no Haskell stack however deep the
-- mirrors are, and it can count. Depth first, reflection before refraction, so that it is known which rays are the first mostRays.
-- The sum is the same as the recursive one up to rounding in binary64, which disappears in the byte.
