"""What shapes have in common: hits (specification 5.2) and frames for pictures (5.17)."""

import math
from typing import NamedTuple, Optional, Tuple

import rays
import vector as V

SMALLEST = 1e-8                        # geometry.hit.smallest-parameter
SURFACE = 1e-10                        # numbers.tolerances: surface thickness
ROUND = 1e-7                           # round thickness
END = 1e-10                            # end thickness
TWO_PI = 2 * math.pi


class Hit(NamedTuple):
    t: float
    point: Tuple[float, float, float]
    normal: Tuple[float, float, float]
    uv: Optional[Tuple[float, float]]


class Shape:
    """A shape answers the ascending parameters of a line, each with a mark that says which
    part of it is met there, and normal and texture coordinates at a parameter."""

    closed = False

    def parameters(self, ray):
        """Pairs (t, part), ascending, negative ones too (geometry.ray.line)."""
        raise NotImplementedError

    def normal(self, ray, t, point, part):
        raise NotImplementedError

    def uv(self, ray, t, point, part):
        raise NotImplementedError

    def contains(self, point):
        """Whether a point is inside; never, for open shapes (geometry.contains.closed)."""
        return False

    def first(self, ray):
        """The first parameter above 1e-8 with its part, or None.

        Keeps geometry.hit.first, geometry.hit.none, geometry.hit.smallest-parameter and
        geometry.hit.finite.
        """
        for t, part in self.parameters(ray):
            if t > SMALLEST and math.isfinite(t):
                return t, part
        return None

    def hit_at(self, ray, t, part):
        """The hit at one of the parameters (geometry.hit.point, geometry.hit.normal)."""
        point = rays.position(ray, t)
        return Hit(t, point, self.normal(ray, t, point, part), self.uv(ray, t, point, part))

    def hit(self, ray):
        """The hit of a ray, or None."""
        found = self.first(ray)
        return None if found is None else self.hit_at(ray, *found)


def frame(n):
    """e1, e2 of a unit vector (geometry.uv.frame)."""
    sizes = [abs(c) for c in n]
    k = sizes.index(min(sizes))
    e1 = V.unit(V.subtract(V.AXES[k], V.scale(n[k], n)))
    return e1, V.cross(n, e1)


def disk_uv(w, n, radius):
    """The picture on a disk (geometry.disk.uv)."""
    e1, e2 = frame(n)
    return (0.5 + V.dot(w, e1) / (2 * radius), 0.5 - V.dot(w, e2) / (2 * radius))


def side_uv(w, axis, height):
    """The picture on a side (geometry.tube.uv)."""
    e1, e2 = frame(axis)
    h = max(0.0, min(height, V.dot(w, axis)))
    return (0.5 + math.atan2(V.dot(w, e2), V.dot(w, e1)) / TWO_PI, 1 - h / height)


def nearest_parameter(w, d):
    """The parameter of a line's point nearest to the place from which w leads to its origin."""
    return -V.dot(w, d) / V.dot(d, d)
