"""Cube (specification 5.6)."""

import math

import vector as V
from .base import SURFACE, Shape, disk_uv

FACES = ((2, 1.0), (2, -1.0), (1, 1.0), (1, -1.0), (0, 1.0), (0, -1.0))   # +z -z +y -y +x -x


class Cube(Shape):
    closed = True

    def __init__(self, centre, size):
        self.centre = centre
        self.h = size / 2

    def face_parameter(self, ray, axis, sign):
        """Where the line meets the plane of a face, or None for a line along it."""
        d = ray[1][axis]
        if d == 0:
            return None
        place = self.centre[axis] + self.h if sign > 0 else self.centre[axis] - self.h
        return (place - ray[0][axis]) / d

    def parameters(self, ray):
        """geometry.cube.slabs, geometry.cube.along-slab, geometry.cube.edges"""
        entry, leave = -math.inf, math.inf
        for axis in range(3):
            d = ray[1][axis]
            if d == 0:
                low, high = self.centre[axis] - self.h, self.centre[axis] + self.h
                if not low <= ray[0][axis] <= high:
                    return []
                continue
            a, b = self.face_parameter(ray, axis, -1.0), self.face_parameter(ray, axis, 1.0)
            if d < 0:
                a, b = b, a
            entry, leave = max(entry, a), min(leave, b)
        return [(entry, None), (leave, None)] if entry <= leave else []

    def face(self, ray, t):
        """The first face whose own parameter is t (geometry.cube.normal)."""
        for axis, sign in FACES:
            if self.face_parameter(ray, axis, sign) == t:
                return axis, sign
        raise ValueError("a cube without a face")

    def normal(self, ray, t, point, part):
        axis, sign = self.face(ray, t)
        return tuple(sign if i == axis else 0.0 for i in range(3))

    def uv(self, ray, t, point, part):
        """geometry.cube.uv"""
        n = self.normal(ray, t, point, part)
        centre = V.add(self.centre, V.scale(self.h, n))
        return disk_uv(V.subtract(point, centre), n, self.h)

    def contains(self, point):
        """geometry.cube.contains"""
        limit = (1 - SURFACE) * self.h
        return all(abs(point[i] - self.centre[i]) < limit for i in range(3))
