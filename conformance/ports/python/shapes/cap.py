"""Spherical cap (specification 5.12)."""

import math

import roots
import vector as V
from .base import Shape, disk_uv, nearest_parameter


def sagitta(c, radius):
    """m = sgn(c) sqrt((|c| - R) (|c| + R)): from the disk to the sphere's centre."""
    m = math.sqrt((abs(c) - radius) * (abs(c) + radius))
    return m if c > 0 else -m


class Cap(Shape):
    """geometry.cap.surface, geometry.cap.open, geometry.cap.half"""

    def __init__(self, position, normal, radius, curvature):
        self.position, self.radius, self.c = position, radius, curvature
        self.n = V.unit(normal)
        self.m = sagitta(curvature, radius)
        self.centre = V.subtract(position, V.scale(self.m, self.n))

    def parameters(self, ray):
        """geometry.cap.parameters, by its informative algorithm."""
        o, d = ray
        w = V.subtract(o, self.position)
        t0 = nearest_parameter(w, d)
        p = V.add(w, V.scale(t0, d))
        pn, dn = V.dot(p, self.n), V.dot(d, self.n)
        found = roots.quadratic(V.dot(d, d), 2 * (V.dot(p, d) + self.m * dn),
                                V.dot(p, p) + 2 * self.m * pn - self.radius * self.radius)
        return [(t0 + s, None) for s in found
                if self._is_over(pn + s * dn, V.add(p, V.scale(s, d)))]

    def _is_over(self, height, v):
        """Whether a point of the sphere is on the cap."""
        if self.c < 0:
            height = -height
        if abs(self.c) <= 16 * self.radius:
            return height >= 0
        return height > -abs(self.m) and V.modulus(V.across(self.n, v)) <= self.radius

    def normal(self, ray, t, point, part):
        """geometry.cap.normal, geometry.hit.centre"""
        n = V.unit(V.subtract(point, self.centre))
        if n is None:
            return self.n
        return n if self.c > 0 else V.negate(n)

    def uv(self, ray, t, point, part):
        return disk_uv(V.subtract(point, self.position), self.n, self.radius)
