"""Flat and smooth triangle (specification 5.7, 5.8)."""

import math

import vector as V
from .base import Shape
from .planar import plane_parameters

TURNS = {2: (0, 1, 2), 1: (2, 0, 1), 0: (1, 2, 0)}     # the largest component comes last


def collinear(p0, p1, p2):
    """Whether three corners make no triangle (geometry.triangle.collinear)."""
    u1, u2 = V.unit(V.subtract(p1, p0)), V.unit(V.subtract(p2, p0))
    return u1 is None or u2 is None or V.modulus(V.cross(u1, u2)) <= 2.0 ** -50


def flat_normal(p0, p1, p2):
    """geometry.triangle.normal"""
    s1, s2 = V.subtract(p1, p0), V.subtract(p2, p0)
    n = V.unit(V.cross(s1, s2))
    return n if n is not None else V.unit(V.cross(V.unit(s1), V.unit(s2)))


def barycentric(p0, p1, p2, v):
    """(t1, t2) of a point (geometry.triangle.barycentric, geometry.triangle.needle)."""
    w, s1, s2 = V.subtract(v, p0), V.subtract(p1, p0), V.subtract(p2, p0)
    a, b, c = V.dot(s1, s1), V.dot(s1, s2), V.dot(s2, s2)
    d = a * c - b * b
    ordinary = 1e-140 < a < 1e140 and 1e-140 < c < 1e140 and V.dot(w, w) < 1e140
    if not (ordinary and d > 2.0 ** -20 * (a * c)):
        return _by_cross_products(w, s1, s2)
    x, y = V.dot(w, s1), V.dot(w, s2)
    return ((x * c - y * b) / d, (y * a - x * b) / d)


def _by_cross_products(w, s1, s2):
    """geometry.triangle.needle"""
    (k, w), (k1, s1), (k2, s2) = _near_one(w), _near_one(s1), _near_one(s2)
    n = V.cross(s1, s2)
    nn = V.dot(n, n)
    return (math.ldexp(V.dot(V.cross(w, s2), n) / nn, k - k1),
            math.ldexp(V.dot(V.cross(s1, w), n) / nn, k - k2))


def _near_one(v):
    """k, and the vector times 2^-k, the largest component of which is from 1/2 to 1."""
    _, k = math.frexp(max(map(abs, v)))
    return k, tuple(math.ldexp(c, -k) for c in v)


def passes(ray, corners):
    """Whether a line passes through a triangle (geometry.triangle.edges,
    geometry.triangle.watertight, the last sentence of geometry.triangle.parameters)."""
    o, d = ray
    last = 2
    for k in (1, 0):
        if abs(d[k]) > abs(d[last]):
            last = k
    i, j, k = TURNS[last]
    sx, sy = d[i] / d[k], d[j] / d[k]
    a, b, c = ((p[i] - o[i] - sx * (p[k] - o[k]), p[j] - o[j] - sy * (p[k] - o[k])) for p in corners)
    e = (_edge(c, b), _edge(a, c), _edge(b, a))
    if e[0] == 0 and e[1] == 0 and e[2] == 0:
        return False
    return all(x >= 0 for x in e) or all(x <= 0 for x in e)


def _edge(p, q):
    return p[0] * q[1] - p[1] * q[0]


class Triangle(Shape):
    """geometry.triangle.both-sides, geometry.triangle.edge-on"""

    def __init__(self, p0, p1, p2):
        self.corners = (p0, p1, p2)
        self.n = flat_normal(p0, p1, p2)

    def parameters(self, ray):
        found = plane_parameters(ray, self.corners[0], self.n)
        return [(t, None) for t in found] if found and passes(ray, self.corners) else []

    def normal(self, ray, t, point, part):
        return self.n

    def uv(self, ray, t, point, part):
        return barycentric(*self.corners, point)


class SmoothTriangle(Triangle):
    """geometry.smooth-triangle.parameters; normals are None where a corner has none
    (geometry.smooth-triangle.flat-corner)."""

    def __init__(self, corners, normals, uvs):
        super().__init__(*corners)
        self.normals = [self.n if n is None else V.unit(n) for n in normals]
        self.uvs = uvs

    def normal(self, ray, t, point, part):
        """geometry.smooth-triangle.normal, geometry.smooth-triangle.vanishing"""
        t1, t2 = barycentric(*self.corners, point)
        n0, n1, n2 = self.normals
        mixed = V.add(V.add(V.scale(1 - t1 - t2, n0), V.scale(t1, n1)), V.scale(t2, n2))
        return V.unit(mixed) or self.n

    def uv(self, ray, t, point, part):
        """geometry.smooth-triangle.uv"""
        t1, t2 = barycentric(*self.corners, point)
        a, b, c = self.uvs
        return tuple((1 - t1 - t2) * a[i] + t1 * b[i] + t2 * c[i] for i in range(2))
