"""Cone (specification 5.11)."""

import math

import roots
import vector as V
from .base import END, ROUND, disk_uv, nearest_parameter, side_uv
from .tube import EVERYWHERE, Axial, slab_interval


def double_cone(ray, point, apex, radius):
    """The unbounded double cone (geometry.cones.parameters, geometry.cones.parallel)."""
    g = V.subtract(apex, point)
    if V.is_zero(g):
        return []
    _, exponent = math.frexp(max(abs(g[0]), abs(g[1]), abs(g[2]), abs(radius)))
    g = tuple(math.ldexp(x, -exponent) for x in g)
    radius = math.ldexp(radius, -exponent)
    o, d = ray
    w = V.subtract(o, apex)
    gg, dg, wg = V.dot(g, g), V.cross(d, g), V.cross(w, g)
    rd, rw = radius * V.dot(d, g), radius * V.dot(w, g)
    return roots.quadratic(gg * V.dot(dg, dg) - rd * rd,
                           2 * (gg * V.dot(wg, dg) - rw * rd),
                           gg * V.dot(wg, wg) - rw * rw)


class Cone(Axial):
    closed = True

    def __init__(self, base, apex, radius):
        super().__init__(base, apex, radius)
        self.k = radius / self.height
        self.flat = radius > 32 * self.height

    def parameters(self, ray):
        """geometry.cone.interval by its informative algorithm, geometry.cone.beyond-apex,
        geometry.cone.apex; parts are "side" and "base"."""
        o, d = ray
        w = V.subtract(o, self.p2)
        if self.flat and abs(V.dot(d, self.axis)) * self.radius > 2 * self.height * V.modulus(d):
            return self._steep(w, d)
        t0 = nearest_parameter(w, d)
        p = V.add(w, V.scale(t0, d))
        a, da = V.dot(p, self.axis), V.dot(d, self.axis)
        dp, wp = V.across(self.axis, d), V.across(self.axis, p)
        ka, kda = self.k * a, self.k * da
        qa = V.dot(dp, dp) - kda * kda
        qb = 2 * (V.dot(wp, dp) - kda * ka)
        qc = V.dot(wp, wp) - ka * ka
        within, sides = self._nappe(qa, qb, qc, da)
        slab = slab_interval(a, da, -self.height, 0)
        if within is None or slab is None:
            return []
        entry, leave = max(within[0], slab[0]), min(within[1], slab[1])
        if not entry <= leave:
            return []
        base = (-self.height - a) / da if da else None
        found = []
        for s in (entry, leave):
            found.append((t0 + s, "base" if s == base and s not in sides else "side"))
        return found

    def _steep(self, w, d):
        """Through a flat cone: counted from the plane of the apex, in units of H / R."""
        unit = self.height / self.radius
        da = V.dot(d, self.axis)
        t0 = -V.dot(w, self.axis) / da
        wp = V.across(self.axis, V.add(w, V.scale(t0, d)))
        dp = V.scale(unit, V.across(self.axis, d))
        within, sides = self._nappe(V.dot(dp, dp) - da * da, 2 * V.dot(wp, dp), V.dot(wp, wp), da)
        slab = slab_interval(0.0, da, -self.radius, 0)
        entry, leave = max(within[0], slab[0]), min(within[1], slab[1])
        if not entry <= leave:
            return []
        base = -self.radius / da
        return [(t0 + unit * s, "base" if s == base and s not in sides else "side")
                for s in (entry, leave)]

    @staticmethod
    def _nappe(a, b, c, da):
        """Where the line is in the double cone, on the side of the base; and the roots."""
        found = roots.quadratic(a, b, c)
        if a > 0:
            return ((found[0], found[1]) if len(found) == 2 else None), found
        if a < 0:
            if len(found) < 2:         # rounding at the apex
                found = [-b / (2 * a)] * 2
            return ((-math.inf, found[0]) if da > 0 else (found[1], math.inf)), found
        if found:
            return ((-math.inf, found[0]) if b > 0 else (found[0], math.inf)), found
        return (EVERYWHERE if c <= 0 else None), found

    def normal(self, ray, t, point, part):
        """geometry.cone.normal, geometry.cone.apex"""
        if part == "base":
            return V.negate(self.axis)
        e = V.unit(V.across(self.axis, V.subtract(point, self.p1)))
        if e is None:
            return self.axis
        return V.unit(V.add(e, V.scale(self.k, self.axis)))

    def uv(self, ray, t, point, part):
        """geometry.cone.uv"""
        w = V.subtract(point, self.p1)
        if part == "base":
            return disk_uv(w, V.negate(self.axis), self.radius)
        u, v = side_uv(w, self.axis, self.height)
        if self.flat:
            v = min(1.0, V.modulus(V.across(self.axis, w)) / self.radius)
        return u, v

    def contains(self, point):
        """geometry.cone.contains"""
        w = V.subtract(point, self.p1)
        h = V.dot(w, self.axis)
        return (h > END and self.height - h > END and V.modulus(V.across(self.axis, w))
                < (1 - ROUND) * abs((1 - h / self.height) * self.radius))
