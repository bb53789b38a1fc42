"""Sphere (specification 5.5)."""

import math

import roots
import vector as V
from .base import SURFACE, TWO_PI, Shape


def sphere_parameters(ray, centre, square):
    """geometry.sphere.parameters, geometry.sphere.tangent; square is R R, rounded."""
    o, d = ray
    w = V.subtract(o, centre)
    return roots.quadratic(V.dot(d, d), 2 * V.dot(w, d), V.dot(w, w) - square)


class Sphere(Shape):
    closed = True

    def __init__(self, centre, radius):
        self.centre = centre
        self.square = radius * radius

    def parameters(self, ray):
        return [(t, None) for t in sphere_parameters(ray, self.centre, self.square)]

    def normal(self, ray, t, point, part):
        """geometry.sphere.normal, geometry.hit.centre"""
        return V.unit(V.subtract(point, self.centre)) or (0.0, 0.0, 1.0)

    def uv(self, ray, t, point, part):
        """geometry.sphere.uv"""
        n = V.unit(V.subtract(point, self.centre)) or (0.0, 0.0, 0.0)
        x, y, z = n
        return (0.5 + math.atan2(z, x) / TWO_PI, math.atan2(math.sqrt(x * x + z * z), y) / math.pi)

    def contains(self, point):
        """geometry.sphere.contains"""
        return V.modulus(V.subtract(point, self.centre)) < (1 - SURFACE) * math.sqrt(self.square)
