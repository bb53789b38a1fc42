-- |
-- Module      : Dioptre.Math.Tolerance
-- Description : Every tolerance of the program
--
-- The few numbers that say "near enough", in one place, each with what it is for. Nothing else in the program compares
-- with a tolerance.
module Dioptre.Math.Tolerance
  ( smallestParameter,
    smallestLength,
    collinearSine,
    surfaceThickness,
  )
where

-- | A ray meets a shape only at a parameter above this: a ray that starts on a surface does not meet it there again. In
-- the scene's unit of length for rays of unit direction. (The handout's EPSILON of the class SRay, section 1.7.)
smallestParameter :: Double
smallestParameter = 1e-8

-- | Lengths that must be greater than zero are at least this, and so is the length of whatever must have a direction: normals,
-- the camera's front and up, a light's orientation.
smallestLength :: Double
smallestLength = 1e-10

-- | Two edges whose angle has a sine of at most this are parallel: 2^-50. The cross product of two vectors is computed with an error of less than
-- 2^-51 of the product of their lengths (each component is a difference of two rounded products), so that below twice that its
-- direction is noise.
collinearSine :: Double
collinearSine = 2 ** (-50)

-- | The part of its size within which a point is on the surface of a sphere or cube, neither inside nor outside: a hit point is off by a few
-- roundings of the numbers that it was computed from, which this exceeds for scenes up to some 10^5 times as large as the shape.
surfaceThickness :: Double
surfaceThickness = 1e-10
