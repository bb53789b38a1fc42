"""Plane, disk and annulus (specification 5.3, 5.4)."""

import rays
import roots
import vector as V
from .base import Shape, disk_uv, frame

PARALLEL = 2.0 ** -100


def plane_parameters(ray, position, n):
    """The parameter at which a line meets a plane with the unit normal n
    (geometry.plane.parameters, geometry.plane.parallel)."""
    o, d = ray
    a = V.dot(n, d)
    if not a * a > PARALLEL * V.dot(d, d):
        return []
    return roots.linear(a, V.dot(n, V.subtract(o, position)))


class Plane(Shape):
    """geometry.plane.unit-normal, geometry.plane.uv"""

    def __init__(self, position, normal):
        self.position = position
        self.n = V.unit(normal)

    def parameters(self, ray):
        return [(t, None) for t in plane_parameters(ray, self.position, self.n)
                if self.covers(V.modulus(V.subtract(rays.position(ray, t), self.position)))]

    def covers(self, distance):
        return True

    def normal(self, ray, t, point, part):
        return self.n

    def uv(self, ray, t, point, part):
        e1, e2 = frame(self.n)
        w = V.subtract(point, self.position)
        return (V.dot(w, e1), -V.dot(w, e2))


class Annulus(Plane):
    """geometry.annulus.parameters, geometry.annulus.rims"""

    def __init__(self, position, normal, radius, inner):
        super().__init__(position, normal)
        self.radius, self.inner = radius, inner

    def covers(self, distance):
        return self.inner <= distance <= self.radius

    def uv(self, ray, t, point, part):
        return disk_uv(V.subtract(point, self.position), self.n, self.radius)


class Disk(Annulus):
    """geometry.disk.parameters, geometry.disk.rim, geometry.disk.edge-on"""

    def __init__(self, position, normal, radius):
        super().__init__(position, normal, radius, 0.0)
