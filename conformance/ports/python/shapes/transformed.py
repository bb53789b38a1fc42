"""Shapes in a frame of their own (specification 5.15)."""

import math

import vector as V
from transform import Transformation
from .base import Hit, Shape
import rays


class Transformed(Shape):
    """A shape under one or more transformations, the outermost first
    (geometry.transformed.nested); nested ones are kept as a list, to any depth."""

    def __init__(self, scale, rotation, translation, inner):
        self.steps = [Transformation(scale, rotation, translation)]
        if isinstance(inner, Transformed):
            self.steps.extend(inner.steps)
            inner = inner.inner
        self.inner = inner
        self.closed = inner.closed

    def back(self, ray):
        """The ray carried back (geometry.transformed.parameters)."""
        o, d = ray
        for step in self.steps:
            o, d = step.position_back(o), step.direction_back(d)
        return o, d

    def parameters(self, ray):
        """geometry.transformed.parameters; none for a direction whose square leaves the range of
        binary64 (geometry.ray.direction, geometry.hit.finite)."""
        inner = self.back(ray)
        return self.inner.parameters(inner) if 0 < V.dot(inner[1], inner[1]) < math.inf else []

    def hit_at(self, ray, t, part):
        """geometry.transformed.normal, geometry.transformed.mirrored, geometry.transformed.uv"""
        hit = self.inner.hit_at(self.back(ray), t, part)
        normal = hit.normal
        for step in reversed(self.steps):
            normal = step.normal(normal)
        return Hit(t, rays.position(ray, t), normal, hit.uv)

    def contains(self, point):
        """geometry.transformed.contains"""
        for step in self.steps:
            point = step.position_back(point)
        return self.inner.contains(point)
