"""Lens (specification 5.13)."""

import math

import roots
import vector as V
from .base import ROUND, SURFACE, disk_uv, nearest_parameter, side_uv
from .cap import sagitta
from .tube import Axial, bar_interval

OVERLAP = 2.0 ** -49                   # numbers.tolerances: rim overlap


class Lens(Axial):
    """The body r <= R, -s_1(r) <= z <= L + s_2(r) as the part of a line that a bar and two
    faces share. An end of an interval is a pair (parameter, part)."""

    closed = True

    def __init__(self, p1, p2, radius, curvature):
        super().__init__(p1, p2, radius)
        self.c = curvature
        # q: how far the centre of a face's sphere is behind the face's end, into the lens
        self.q = tuple(sagitta(c, radius) for c in curvature)
        self.centres = (V.add(p1, V.scale(self.q[0], self.axis)),
                        V.subtract(p2, V.scale(self.q[1], self.axis)))

    def parameters(self, ray):
        """geometry.lens.body, geometry.lens.rim"""
        o, d = ray
        middle = V.scale(0.5, V.add(self.p1, self.p2))
        w = V.subtract(o, middle)
        t0 = nearest_parameter(w, d)
        p = V.add(w, V.scale(t0, d))
        half = self.height / 2
        z, dz = V.dot(p, self.axis), V.dot(d, self.axis)
        dp, wp = V.across(self.axis, d), V.across(self.axis, p)
        bar, sides = bar_interval(V.dot(dp, dp), 2 * V.dot(wp, dp),
                                  V.dot(wp, wp) - self.radius * self.radius)
        if bar is None:
            return []
        parts = [((bar[0], "side"), (bar[1], "side"))]
        for face, inward in ((0, 1), (1, -1)):
            # x leads from the face's end to the ray; heights go into the lens
            x = V.add(p, V.scale(inward * half, self.axis))
            parts = self._meet(parts, self._face(face, x, d, inward * z + half, inward * dz), t0)
        found = []
        for start, end in parts:
            found.extend(((t0 + start[0], start[1]), (t0 + end[0], end[1])))
        return found

    def _face(self, face, x, d, h, dh):
        """The intervals in which a line is on the body's side of a face."""
        q = self.q[face]
        found = roots.quadratic(V.dot(d, d), 2 * (V.dot(x, d) - q * dh),
                                V.dot(x, x) - 2 * q * h - self.radius * self.radius)
        beyond = None                  # where the height is at least q
        if dh > 0:
            beyond = ((q - h) / dh, math.inf)
        elif dh < 0:
            beyond = (-math.inf, (q - h) / dh)
        elif h >= q:
            beyond = (-math.inf, math.inf)
        sets = []
        if self.c[face] > 0:           # in the ball, or behind its middle
            if len(found) == 2:
                sets.append((found[0], found[1]))
            if beyond is not None:
                sets.append(beyond)
        elif beyond is not None:       # behind the middle, and not in the open ball
            if len(found) == 2:
                sets.append((beyond[0], min(beyond[1], found[0])))
                sets.append((max(beyond[0], found[1]), beyond[1]))
            else:
                sets.append(beyond)
        sets = sorted(s for s in sets if s[0] <= s[1])
        merged = []
        for low, high in sets:
            if merged and self.c[face] > 0 and low <= merged[-1][1]:
                merged[-1] = (merged[-1][0], max(merged[-1][1], high))
            else:
                merged.append((low, high))
        return [((low, face), (high, face)) for low, high in merged]

    @staticmethod
    def _meet(first, second, t0):
        """What two lists of intervals share, rims included (geometry.lens.rim)."""
        found = []
        for a in first:
            for b in second:
                start = _later(a[0], b[0], t0)
                end = _earlier(a[1], b[1], t0)
                if start[0] > end[0]:
                    if not (math.isfinite(start[0]) and math.isfinite(end[0])
                            and start[0] - end[0] <= _slack(start[0], end[0], t0)):
                        continue
                    side = start if start[1] == "side" else end
                    start = end = side
                found.append((start, end))
        return sorted(found, key=lambda pair: pair[0][0])

    def normal(self, ray, t, point, part):
        """geometry.lens.normal"""
        if part == "side":
            return self.side_normal(point)
        n = V.unit(V.subtract(point, self.centres[part]))
        if n is None:                                      # geometry.hit.centre
            return self.axis if part else V.negate(self.axis)
        return n if self.c[part] > 0 else V.negate(n)

    def uv(self, ray, t, point, part):
        """geometry.lens.uv"""
        if part == "side":
            return side_uv(V.subtract(point, self.p1), self.axis, self.height)
        end = self.p2 if part == 1 else self.p1
        return disk_uv(V.subtract(point, end), self.axis, self.radius)

    def contains(self, point):
        """geometry.lens.contains"""
        w = V.subtract(point, self.p1)
        if not V.modulus(V.across(self.axis, w)) < (1 - ROUND) * self.radius:
            return False
        z = V.dot(w, self.axis)
        for face, h in ((0, z), (1, self.height - z)):
            c, q = self.c[face], self.q[face]
            away = V.modulus(V.subtract(point, self.centres[face]))
            if c > 0:
                if not (away < (1 - SURFACE) * c or h >= q):
                    return False
            elif not (away > (1 + SURFACE) * -c and h >= q):
                return False
        return True


def _slack(a, b, t0):
    return OVERLAP * (abs(t0) + abs(a) + abs(b))


def _later(a, b, t0):
    """The later of two starts; of two that are the same to rounding, the side."""
    return _choose(a, b, t0, a if a[0] >= b[0] else b)


def _earlier(a, b, t0):
    return _choose(a, b, t0, a if a[0] <= b[0] else b)


def _choose(a, b, t0, chosen):
    if math.isfinite(a[0]) and math.isfinite(b[0]) and abs(a[0] - b[0]) <= _slack(a[0], b[0], t0):
        if a[1] == "side":
            return a
        if b[1] == "side":
            return b
    return chosen
