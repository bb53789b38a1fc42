{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE DerivingStrategies #-}
{-# OPTIONS_GHC -O2 -fno-full-laziness -fmax-worker-args=40 #-}

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
    coloursAt,
    lighting,
    Passage (..),
    passage,
    past,
    farthest,
    mediumAt,
    mostRays,
  )
where

import Data.List (foldl', sortOn)
import qualified Data.Vector as Vector
import Dioptre.Geometry.Closest (Closest (..))
import Dioptre.Geometry.Prepared (isClosed, normalAt, shadingNormal, textureAt)
import Dioptre.Geometry.Ray (Ray, direction, origin, position, ray)
import Dioptre.Light.Colour (Colour (..), black, capped, filtered, plus, rgb, scaled)
import Dioptre.Light.Finish (Colours (..), Finish (..), Pictures (..), hasPictures, isTransparent)
import Dioptre.Light.Illumination (ambient, blinn, lambert, phong)
import Dioptre.Light.Wave (intensity)
import Dioptre.Math.Tolerance (smallestLength)
import Dioptre.Math.Vector (Packed, Point, Vector, dot, modulus, packed, packedUnit, unpacked, unpackedUnit, vector, (^/))
import Dioptre.Optics.Reflection (reflected)
import Dioptre.Optics.Refraction (refracted)
import Dioptre.Render.Closest (closest)
import Dioptre.Render.Obstacles (Obstacles (..), obstacles)
import Dioptre.Render.Stage
import Dioptre.Render.Surface (Surface (..), finishAt, surfaceAt)
import Dioptre.Render.Surroundings (surroundings)
import Dioptre.Render.Texture (Texture, texel)
import Dioptre.Render.World (World, worldHasMedia)
import Linear.V2 (V2)
import Linear.V3 (V3 (..))

-- | What a ray sees.
data Seen = Seen
  { seenColour :: {-# UNPACK #-} !Colour,
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
      | otherwise = diffuseOf (finishColours f)

-- | With light: what the ray sees, up to the stage's depth, no farther than that from the start of each ray.
--
-- See Note [Rays as a stack] and Note [Numbers that travel].
look :: Stage -> Terms -> Double -> Ray -> Seen
look s terms !far !primary = follow (Tally 0 0 0 0 0 0) (Pending primary 1 1 1 1 medium) Done
  where
    -- Where nothing goes on, nobody asks where it travels.
    medium
      | stageDepth s > 1 = mediumAt (stageWorld s) Nothing (origin primary)
      | otherwise = 1
    follow tally@(Tally followed shadows tests red' green' blue') pending@(Pending r depth wr wg wb index) rest
      | followed >= mostRays = told True tally
      | otherwise = case closest (stageWorld s) r far of
        Closest t i tried -> case surfaceAt (stageWorld s) i of
          Nothing -> next (Tally (followed + 1) shadows (tests + tried) red' green' blue') rest
          Just surface@(Surface shape f) ->
            let !at = position r t
                !outward = normalAt shape r t
                !n = shadingNormal r outward
             in case lighting s terms (coloursAt surface r t) (packed at) (packedUnit n) (packed (direction r)) of
                  Lit r' g' b' m tried' ->
                    let !tally' = Tally (followed + 1) (shadows + m) (tests + tried + tried') (red' + wr * r') (green' + wg * g') (blue' + wb * b')
                        !deeper = depth < stageDepth s
                        !kr = finishMirror f
                        !below
                          | deeper && isTransparent f && isClosed shape = through (stageWorld s) f i pending (packed at) (packedUnit outward) (packedUnit n) rest
                          | otherwise = rest
                     in -- The reflected ray is followed first.
                        if deeper && kr /= 0
                          then follow tally' (Pending (ray at (reflected (direction r) n)) (depth + 1) (kr * wr) (kr * wg) (kr * wb) index) below
                          else next tally' below
    next !tally Done = told False tally
    next !tally (pending `Then` rest) = follow tally pending rest
    told cut (Tally followed shadows tests red' green' blue') = Seen (rgb red' green' blue') (followed + shadows) tests cut

-- | What is known so far: how many rays were followed, how many shadow rays and how many tests there were, and the red, green and blue that was seen.
data Tally = Tally {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | A ray to follow: how deep it is, the weight of what it sees in red, green and blue, and the refractive index of where it travels.
data Pending = Pending {-# UNPACK #-} !Ray {-# UNPACK #-} !Int {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double

-- | The rays that remain, the next one first.
data Remaining = Done | Then {-# UNPACK #-} !Pending !Remaining

-- | The refracted ray, if there is one, before those that remain: where a ray meets a surface with this finish, of the shape with this number. The normals there are the outward one and the one that is turned against the ray.
through :: World -> Finish Texture -> Int -> Pending -> Packed -> Packed -> Packed -> Remaining -> Remaining
through w f !i (Pending r depth wr wg wb index) !at !outward !normal !rest
  | dot v (unpacked outward) > 0 =
    let kt = finishTransparency f
     in onwards (mediumAt w (Just i) p) (kt * wr) (kt * wg) (kt * wb)
  | otherwise =
    let Colour tr tg tb _ = finishTint f
     in onwards (finishIndex f) (capped (tr * wr)) (capped (tg * wg)) (capped (tb * wb))
  where
    v = direction r
    p = unpacked at
    onwards beyond r' g' b' = case refracted v (unpackedUnit normal) index beyond of
      Nothing -> rest
      Just v' -> Pending (ray p v') (depth + 1) r' g' b' beyond `Then` rest
{-# NOINLINE through #-}

-- | An amount of red, green and blue light, how many shadow rays it took, and how many times one was tried on a shape.
data Lit = Lit {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Int {-# UNPACK #-} !Int

-- | The light that a surface with these colours sends back along a ray: at a point, with a normal turned against the ray, seen in a direction; the sum over all lights, in their order.
--
-- What the algorithm leaves out is black. Which highlight it has is asked once, and not for each light.
lighting :: Stage -> Terms -> Colours -> Packed -> Packed -> Packed -> Lit
lighting s terms !colours !p !n !v = case termHighlight terms of
  NoHighlight -> summed (\_ _ -> black)
  BlinnHighlight -> summed (\light d -> blinn light (specularOf colours) (unpackedUnit n) d (unpacked v) (shininessOf colours))
  PhongHighlight -> summed (\light d -> phong light (specularOf colours) (unpackedUnit n) d (unpacked v) (shininessOf colours))
  where
    !sources = stageSources s
    !ambient' = if termAmbient terms then ambientOf colours else black
    !diffuse' = if termDiffuse terms then diffuseOf colours else black
    summed highlight = go (0 :: Int) 0 0 0 0 0
      where
        go !k !red' !green' !blue' !rays !tests
          -- One light may be infinitely bright by now, but none is NaN: its factors are finite.
          | k >= Vector.length sources = Lit (capped red') (capped green') (capped blue') rays tests
          | otherwise = illuminated (stageWorld s) ambient' diffuse' highlight p n (Vector.unsafeIndex sources k) $ \(Colour r' g' b' _) m tried ->
            go (k + 1) (red' + r') (green' + g') (blue' + b') (rays + m) (tests + tried)
    {-# INLINE summed #-}

-- | The light of one source at a point with normal n of a surface with this ambient and this diffuse colour, and this highlight of a light that travels along a direction. It is handed on with how many rays and tests it took:
-- whatever is done with it is done last, so that GHC makes jumps of all that happens here.
illuminated :: World -> Colour -> Colour -> (Colour -> Vector -> Colour) -> Packed -> Packed -> Source -> (Colour -> Int -> Int -> a) -> a
illuminated w !ambient' !diffuse' highlight !at !normal source give = case source of
  FromEverywhere light -> give (ambient light ambient') 0 0
  FromFar light d -> shining light 1 (unpacked d) farthest
  FromPoint light place amplification attenuators -> from place amplification attenuators (shining light)
  FromWaves light place amplification attenuators wave sources ->
    from place amplification attenuators $ \factor d distance' ->
      arriving d distance' $ \filter' -> if dark (filtered light filter') then black else scaled (factor * intensity wave sources p) light
  where
    p = unpacked at
    n = unpackedUnit normal
    -- A light's colour, so many times as strong, along d from a distance: Lambert's term and the highlight.
    shining light !factor d distance' = arriving d distance' $ \filter' ->
      let light' = filtered light filter'
       in if dark light' then black else scaled factor (lambert light' diffuse' n d `plus` highlight light' d)
    -- What arrives along d from a distance, unless the surface is turned away or something stands between.
    arriving d distance' shine
      | negate (dot (vector n) d) <= 0 = give black 0 0
      | otherwise = case passage w (ray p (negate d)) distance' of
        Passage red' green' blue' tests -> give (shine (rgb red' green' blue')) 1 tests
    {-# INLINE arriving #-}
    -- From a place, with attenuation; nothing from the very place itself, or where the attenuation divides by zero.
    from place amplification attenuators shine
      | distance' == 0 || denominator == 0 = give black 0 0
      | otherwise = shine (capped (amplification / denominator)) d distance'
      where
        between = p - unpacked place
        distance' = modulus between
        d = between ^/ distance'
        V3 constant linear quadratic = unpacked attenuators
        denominator = constant + linear * distance' + quadratic * distance' * distance'
    {-# INLINE from #-}
{-# INLINE illuminated #-}

-- | The bound of a shadow ray to a light that is infinitely far. A scene has no number beyond 1e100, and no parameter comes near 1e300. (Infinity has no literal, and 1 \/ 0 would be a value to be looked up; see also Note [Literals] of
-- "Dioptre.Math.Roots".)
farthest :: Double
farthest = 1e100 * 1e100 * 1e100
{-# INLINE farthest #-}

-- | Whether a light has been filtered away.
dark :: Colour -> Bool
dark (Colour r g b _) = r < smallestLength && g < smallestLength && b < smallestLength

-- | How much of red, green and blue light comes past what stands in its way, and how many times the ray was tried on a shape to know it: 0 0 0 if anything lets nothing through, 1 1 1 if nothing is there, and else the product of the
-- tints (which may be 0 0 0 as well: whether anything lets nothing through is told by 'obstacles').
data Passage = Passage {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Double {-# UNPACK #-} !Int
  deriving stock (Eq, Show)

-- | What comes past all that a shadow ray meets nearer than a bound. Each shape tints the light once, however often the ray crosses it; tints are multiplied in the order of the shapes' numbers.
passage :: World -> Ray -> Double -> Passage
passage w !r !bound = past (obstacles w r bound)

-- | The same, given what it meets.
past :: Obstacles -> Passage
past (Obstacles opaque transparent tests)
  | opaque = Passage 0 0 0 tests
  | null transparent = Passage 1 1 1 tests
  | otherwise = foldl' tinted (Passage 1 1 1 tests) (map snd (sortOn fst transparent))
  where
    tinted (Passage r' g' b' n) f = let Colour x y z _ = finishTint f in Passage (capped (r' * x)) (capped (g' * y)) (capped (b' * z)) n
{-# INLINE past #-}

-- | The refractive index at a point, a shape left out: 1 outside all closed shapes, that of the material inside one, the mean inside several.
-- A point on a surface is not inside.
--
-- Cost: constant where nothing closed lets light through; else that of 'surroundings'.
mediumAt :: World -> Maybe Int -> Point -> Double
mediumAt w leftOut p
  | worldHasMedia w = mediumAmong w leftOut p
  | otherwise = 1
{-# INLINE mediumAt #-}

mediumAmong :: World -> Maybe Int -> Point -> Double
mediumAmong w leftOut p = case map finishIndex (surroundings w leftOut p) of
  [] -> 1
  indices -> sum indices / fromIntegral (length indices)
{-# NOINLINE mediumAmong #-}

-- | The colours of a surface where a ray meets it, at a parameter.
coloursAt :: Surface -> Ray -> Double -> Colours
coloursAt (Surface shape f) r t = case finishPictures f of
  NoPictures -> finishColours f
  Pictures a d s -> pictured (finishColours f) a d s (textureAt shape r t)
{-# INLINE coloursAt #-}

-- | Colours with those of pictures at some texture coordinates.
pictured :: Colours -> Maybe Texture -> Maybe Texture -> Maybe Texture -> V2 Double -> Colours
pictured (Colours ambient' diffuse' specular' shininess) a d s uv = Colours (at ambient' a) (at diffuse' d) (at specular' s) shininess
  where
    at plain = maybe plain (`texel` uv)
{-# NOINLINE pictured #-}

-- Note [Rays as a stack]
-- ~~~~~~~~~~~~~~~~~~~~~~
-- Unrolled, the recursion is a sum over all paths of the direct light at the path's end, weighted by the product of the coefficients on the
-- way. The loop keeps the rays that remain on a stack, with their weights, and adds to one total: it takes no Haskell stack however deep the
-- mirrors are, and it can count. Depth first, reflection before refraction, so that it is known which rays are the first mostRays.
-- The sum is the same as the recursive one up to rounding in binary64, which disappears in the byte.

-- Note [Numbers that travel]
-- ~~~~~~~~~~~~~~~~~~~~~~~~~~
-- A ray, a point, a normal and the colours of a surface are some thirty numbers, which go from one function to the next a hundred million times for a picture. GHC hands a record over as its numbers, without making it, if the function
-- surely looks into it, and if that makes no more arguments than -fmax-worker-args says. It says 10, which is less than the colours of a surface (13), or a few shapes, a ray and a bound (14); here it says 40. In the same way what a function makes is handed back as numbers: Seen, Lit and
-- Passage are never in memory.
--
-- Three things follow for what is here. Records are unpacked into each other down to the numbers. What is not to be taken apart is no record: a 'World' has two constructors, and stays one pointer. And whatever is looked into is looked
-- into early, or once: before GHC 9.0 looks at a value behind a pointer, it saves all numbers that it has at hand, in case the value must be computed first.
