"""Torus (specification 5.14)."""

import math

import roots
import vector as V
from .base import ROUND, TWO_PI, Shape, frame, nearest_parameter


class Torus(Shape):
    """geometry.torus.equation, geometry.torus.spindle"""

    closed = True

    def __init__(self, position, normal, major, minor):
        self.position, self.major, self.minor = position, major, minor
        self.n = V.unit(normal)

    def parameters(self, ray):
        return [(t, None) for t in self.all_parameters(ray)]

    def all_parameters(self, ray):
        """geometry.torus.precision, by its informative algorithm."""
        o, d = ray
        w = V.subtract(o, self.position)
        t0 = nearest_parameter(w, d)
        q = V.add(w, V.scale(t0, d))
        u = V.unit(d)
        _, exponent = math.frexp(self.major + self.minor)
        exponent -= 1                                      # 2^exponent <= R + r
        q = tuple(math.ldexp(x, -exponent) for x in q)
        big, small = math.ldexp(self.major, -exponent), math.ldexp(self.minor, -exponent)
        c = V.dot(q, q)
        if c > 16:                                         # farther from the middle than R + r
            return []
        n, m = V.dot(self.n, q), V.dot(self.n, u)
        g = c + (big - small) * (big + small)
        rr = big * big
        found = roots.quartic(1.0, 0.0,
                              2 * g - 4 * rr * (1 - m) * (1 + m),
                              8 * rr * m * n,
                              g * g - 4 * rr * (c - n * n))
        length = V.modulus(d)
        return [t0 + math.ldexp(s, exponent) / length for s in found]

    def _place(self, point):
        """v, h, v - h n of a point."""
        v = V.subtract(point, self.position)
        h = V.dot(self.n, v)
        return v, h, V.subtract(v, V.scale(h, self.n))

    def normal(self, ray, t, point, part):
        """geometry.torus.normal"""
        v, h, out = self._place(point)
        e = V.unit(out)
        if e is None:
            return self.n if h >= 0 else V.negate(self.n)
        inner = V.dot(v, v) + self.major * self.major - self.minor * self.minor < 0
        return V.unit(V.subtract(v, V.scale(-self.major if inner else self.major, e)))

    def uv(self, ray, t, point, part):
        """geometry.torus.uv"""
        w, h, out = self._place(point)
        e1, e2 = frame(self.n)
        return (0.5 + math.atan2(V.dot(w, e2), V.dot(w, e1)) / TWO_PI,
                0.5 - math.atan2(h, V.modulus(out) - self.major) / TWO_PI)

    def contains(self, point):
        """geometry.torus.contains"""
        _, h, out = self._place(point)
        off = V.modulus(out) - self.major
        return math.sqrt(off * off + h * h) < (1 - ROUND) * self.minor
