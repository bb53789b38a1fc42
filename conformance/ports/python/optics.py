"""Reflection and refraction (specification 7.1, 7.2)."""

import math

import vector as V


def against(normal, direction):
    """The normal, turned against a direction (optics.reflect.operation)."""
    return V.negate(normal) if V.dot(direction, normal) > 0 else normal


def reflect(v, n):
    """v - (2 <v, N>) N (optics.reflect)."""
    return V.subtract(v, V.scale(2 * V.dot(v, n), n))


def refract(v, n, n1, n2):
    """The refracted direction of the unit v, N against it, or None on total reflection.

    Keeps optics.refract, optics.refract.straight, optics.refract.equal and optics.refract.total.
    """
    if n1 == n2:
        return v
    c = -V.dot(v, n)
    if c * c + (n2 / n1) * (n2 / n1) < 1:
        return None
    r = n1 / n2
    if 1 - c * c <= 0 and r > 67108864:
        return v
    inner = 1 - r * r * (1 - c * c)
    root = math.sqrt(inner) if inner > 0 else 0.0
    return V.add(V.scale(r, v), V.scale(r * c - root, n))
