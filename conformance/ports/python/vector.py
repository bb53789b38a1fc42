"""Vectors: tuples of three floats (specification 4.1).

Python does not fuse products with sums and does not reassociate, so that an expression
written in the order of a rule has the bits that the rule asks for (numbers.binary64,
numbers.order).
"""

import math

ZERO = (0.0, 0.0, 0.0)
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def add(a, b):
    """a + b (vector.add)."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    """a - b (vector.subtract)."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(k, a):
    """k a (vector.scale)."""
    return (k * a[0], k * a[1], k * a[2])


def negate(a):
    """-a."""
    return (-a[0], -a[1], -a[2])


def dot(a, b):
    """The dot product, from left to right (vector.dot)."""
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]


def cross(a, b):
    """The cross product, right-handed (vector.cross)."""
    return (a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def modulus(a):
    """The length, the usual way, without scaling (vector.modulus)."""
    return math.sqrt((a[0] * a[0] + a[1] * a[1]) + a[2] * a[2])


def distance(a, b):
    """|b - a| (vector.distance)."""
    return modulus(subtract(b, a))


def is_zero(a):
    """Whether all components are zero, of either sign."""
    return a[0] == 0 and a[1] == 0 and a[2] == 0


def ordinary(a):
    """a times the power of two that brings its largest component to at least 1/2 and below 1."""
    _, exponent = math.frexp(max(abs(a[0]), abs(a[1]), abs(a[2])))
    return tuple(math.ldexp(c, -exponent) for c in a)


def unit(a):
    """The unit vector of a, or None for the zero vector.

    Keeps vector.normalize (divisions), vector.normalize.zero and
    vector.normalize.extremes (a power of two first, where the quadrance is out of range).
    """
    quadrance = (a[0] * a[0] + a[1] * a[1]) + a[2] * a[2]
    if not 1e-280 < quadrance < 1e280:
        if is_zero(a):
            return None
        a = ordinary(a)
        quadrance = (a[0] * a[0] + a[1] * a[1]) + a[2] * a[2]
    length = math.sqrt(quadrance)
    return (a[0] / length, a[1] / length, a[2] / length)


def angle(a, b):
    """atan2(|a x b|, <a, b>) of the vectors brought to ordinary size, and 0 with a zero vector
    (vector.angle, vector.angle.zero)."""
    if is_zero(a) or is_zero(b):
        return 0.0
    a, b = ordinary(a), ordinary(b)
    return math.atan2(modulus(cross(a, b)), dot(a, b))


def across(axis, a):
    """What a has across the unit vector axis: axis x (a x axis) (specification 5.9)."""
    return cross(axis, cross(a, axis))


def finite(a):
    """Whether no component is NaN or infinite."""
    return math.isfinite(a[0]) and math.isfinite(a[1]) and math.isfinite(a[2])
