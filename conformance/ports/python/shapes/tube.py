"""Tube and cylinder (specification 5.9, 5.10)."""

import math

import rays
import roots
import vector as V
from .base import END, ROUND, Shape, disk_uv, side_uv

EVERYWHERE = (-math.inf, math.inf)


def tube_coefficients(ray, point, axis, radius):
    """geometry.tube.line-parameters"""
    o, d = ray
    dp, wp = V.across(axis, d), V.across(axis, V.subtract(o, point))
    return V.dot(dp, dp), 2 * V.dot(wp, dp), V.dot(wp, wp) - radius * radius


def tube_parameters(ray, point, axis, radius):
    """The infinite tube (geometry.tube.line-parameters, geometry.tube.along-axis)."""
    return roots.quadratic(*tube_coefficients(ray, point, axis, radius))


def bar_interval(a, b, c):
    """Where A t^2 + B t + C <= 0 with A >= 0, or None; and the roots that bound it
    (geometry.cylinder.along-axis)."""
    found = roots.quadratic(a, b, c)
    if len(found) == 2:
        return (found[0], found[1]), found
    if len(found) == 1:                # a root beyond the largest number is left out
        return ((-math.inf, found[0]) if 2 * a * found[0] + b > 0 else (found[0], math.inf)), found
    return (EVERYWHERE if c <= 0 else None), found


def slab_interval(h0, dh, low, high):
    """Where low <= h0 + t dh <= high, or None (geometry.cylinder.interval)."""
    if dh == 0:
        return EVERYWHERE if low <= h0 <= high else None
    a, b = (low - h0) / dh, (high - h0) / dh
    return (a, b) if dh > 0 else (b, a)


def axis_length(between):
    """The length of an axis, which is not 0 however near its ends are (geometry.axis.length)."""
    exponent = math.frexp(max(abs(x) for x in between))[1]
    if exponent > -465:
        return V.modulus(between)
    return math.ldexp(V.modulus([math.ldexp(x, -exponent) for x in between]), exponent)


class Axial(Shape):
    """A shape with two points on an axis."""

    def __init__(self, p1, p2, radius):
        self.p1, self.p2, self.radius = p1, p2, radius
        self.axis = V.unit(V.subtract(p2, p1))
        self.height = axis_length(V.subtract(p2, p1))

    def side_normal(self, point):
        """geometry.tube.normal, geometry.hit.centre"""
        return V.unit(V.across(self.axis, V.subtract(point, self.p1))) or self.axis


class Tube(Axial):
    def parameters(self, ray):
        """geometry.tube.ends"""
        found = []
        for t in tube_parameters(ray, self.p1, self.axis, self.radius):
            height = V.dot(V.subtract(rays.position(ray, t), self.p1), self.axis)
            if 0 <= height <= self.height:
                found.append((t, "side"))
        return found

    def normal(self, ray, t, point, part):
        return self.side_normal(point)

    def uv(self, ray, t, point, part):
        return side_uv(V.subtract(point, self.p1), self.axis, self.height)


class Cylinder(Axial):
    closed = True

    def parameters(self, ray):
        """geometry.cylinder.interval; on a rim the part is the side (geometry.cylinder.normal)."""
        bar, sides = bar_interval(*tube_coefficients(ray, self.p1, self.axis, self.radius))
        h0 = V.dot(V.subtract(ray[0], self.p1), self.axis)
        dh = V.dot(ray[1], self.axis)
        slab = slab_interval(h0, dh, 0, self.height)
        if bar is None or slab is None:
            return []
        entry, leave = max(bar[0], slab[0]), min(bar[1], slab[1])
        if not entry <= leave:
            return []
        found = []
        for t in (entry, leave):
            if t in sides:
                found.append((t, "side"))
            else:
                found.append((t, "start" if t == (0 - h0) / dh else "end") if dh else (t, "side"))
        return found

    def normal(self, ray, t, point, part):
        if part == "side":
            return self.side_normal(point)
        return self.axis if part == "end" else V.negate(self.axis)

    def uv(self, ray, t, point, part):
        """geometry.cylinder.uv"""
        if part == "side":
            return side_uv(V.subtract(point, self.p1), self.axis, self.height)
        centre = self.p2 if part == "end" else self.p1
        return disk_uv(V.subtract(point, centre), self.normal(ray, t, point, part), self.radius)

    def contains(self, point):
        """geometry.cylinder.contains"""
        w = V.subtract(point, self.p1)
        h = V.dot(w, self.axis)
        return (V.modulus(V.across(self.axis, w)) < (1 - ROUND) * self.radius
                and h > END and self.height - h > END)
