{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Math.Tolerance
-- Description : The tolerances of the program
--
-- The few numbers that say "near enough", in one place, each with what it is for. Nothing else in the program compares
-- with a tolerance, except the finders of roots, which derive theirs in their notes ("Dioptre.Math.Touching",
-- "Dioptre.Math.Quartic"), and "Dioptre.Scene.Original", which imitates those of another program.
--
-- The first group decides what is seen. The second decides nothing: it widens what only sorts out, so that
-- rounding there never loses what an exact test would find. Specification: 1.2 (the first group).
module Dioptre.Math.Tolerance
  ( -- * Near enough
    smallestParameter,
    smallestLength,
    smallestLight,
    collinearSine,
    parallelSine,
    surfaceThickness,
    roundThickness,
    endThickness,
    rimOverlap,
    ellipseRim,

    -- * Slack of what sorts out
    boxGrowth,
    cornerSlack,
    slabSlack,
    boundSlack,
    torusSlack,
    needleSine,
  )
where

-- | A ray meets a shape only at a parameter above this: a ray that starts on a surface does not meet it there again. In
-- the scene's unit of length for rays of unit direction. (The handout's EPSILON of the class SRay, section 1.7.)
--
-- Spec: numbers.tolerances, geometry.hit.smallest-parameter.
smallestParameter :: Double
smallestParameter = 1e-8

-- | Lengths that must be greater than zero are at least this, and so is the length of whatever must have a direction:
-- normals, the camera's front and up, a light's orientation.
--
-- Spec: numbers.tolerances.
smallestLength :: Double
smallestLength = 1e-10

-- | Light whose red, green and blue are all below this, after the shadows, is none.
--
-- Spec: numbers.tolerances, light.shadow.dark, light.wave.shadow.
smallestLight :: Double
smallestLight = 1e-10

-- | Two edges whose angle has a sine of at most this are parallel: 2^-50. The cross product of two vectors is computed
-- with an error of less than 2^-51 of the product of their lengths (each component is a difference of two rounded
-- products), so that below twice that its direction is noise.
--
-- Spec: numbers.tolerances, geometry.triangle.collinear.
collinearSine :: Double
collinearSine = 0x1p-50

-- | A ray whose angle with a plane has a sine of at most this is parallel to it: 2^-50. The components of a unit normal
-- carry an error of 3.5 2^-53 of themselves ('Dioptre.Math.Vector.valid'), and \<n, d> one of 3 2^-53 of its terms,
-- whose sum is at most |d|: together less than 2^-50 |d|, so that below it the sign of \<n, d> is noise.
--
-- Spec: numbers.tolerances, geometry.plane.parallel.
parallelSine :: Double
parallelSine = 0x1p-50

-- | The part of its size within which a point is on the surface of a sphere, a cube or a face of a lens, neither inside
-- nor outside. A hit point of a cube is off by a few roundings of the numbers that it was computed from, which this
-- exceeds for scenes up to some 10^5 times as large as the shape; of a sphere, by a rounding of their squares, for
-- scenes up to some 10^3 times as large.
--
-- Spec: numbers.tolerances, geometry.sphere.contains, geometry.cube.contains, geometry.contains.surface.
surfaceThickness :: Double
surfaceThickness = 1e-10

-- | The part of its radius within which a point is on the curved surface around an axis, neither inside nor outside.
-- The radius squared is known to some 2^-51 of the squared distance from which the ray came, so a hit point is within
-- this as long as the ray starts no farther away than some 10^4 radii.
--
-- Spec: numbers.tolerances, geometry.cylinder.contains, geometry.torus.contains, geometry.contains.surface.
roundThickness :: Double
roundThickness = 1e-7

-- | The distance within which a point is on the end plane of a shape around an axis, in the scene's unit of length. It
-- exceeds a few roundings of coordinates up to some 10^5.
--
-- Spec: numbers.tolerances, geometry.cylinder.contains, geometry.contains.surface.
endThickness :: Double
endThickness = 1e-10

-- | The faces and the side of a lens overlap at the rim by this part of the parameters that meet there: 2^-49. Each is
-- a sum of two numbers, the larger of which carries the rounding of a position (2 units of 2^-53), of a product (1) and
-- of the sum itself (1); two of them thus differ by less than 8 units, and the overlap is 16.
--
-- Spec: numbers.tolerances, geometry.lens.rim.
rimOverlap :: Double
rimOverlap = 0x1p-49

-- | A place of an elliptical opening may be outside of the ellipse by this part: the places at the ends of its axes
-- belong to it, and are computed with a few roundings.
--
-- Spec: numbers.tolerances, light.wave.ellipse.
ellipseRim :: Double
ellipseRim = 1e-10

-- | A box is larger than its shape by this part of its longest edge, on every side: 2^-20. (Note [How much larger] of
-- "Dioptre.Geometry.Bounds".)
boxGrowth :: Double
boxGrowth = 0x1p-20

-- | And by this part of its largest coordinate: 2^-48, some roundings of the corners.
cornerSlack :: Double
cornerSlack = 0x1p-48

-- | The parameters at which a ray leaves a box, and the one up to which it is asked for, are larger by this part:
-- 2^-50, which is 8 roundings. (Note [Slack of the slabs] of "Dioptre.Geometry.Box".)
slabSlack :: Double
slabSlack = 0x1p-50

-- | What is met at the very parameter of what is closest so far is asked for by a bound that is larger by this part:
-- 2^-51, two to four doubles on. Which of the two it is, is decided exactly ("Dioptre.Geometry.Closest").
boundSlack :: Double
boundSlack = 0x1p-51

-- | A line may pass beside the sphere around a torus by this part of the squared radius, 2^-40, before its quartic is
-- left unasked.
torusSlack :: Double
torusSlack = 0x1p-40

-- | A triangle whose edges enclose an angle with a smaller sine than this, 2^-10, is a needle, whose coordinates come
-- from another formula. (Note [Needles] of "Dioptre.Geometry.Triangle".)
needleSine :: Double
needleSine = 0x1p-10
