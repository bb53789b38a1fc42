"""The bare terms of illumination (specification 6.3). Colours are (red, green, blue)."""

import vector as V

BLACK = (0.0, 0.0, 0.0)


def product(a, b):
    """Channel by channel (light.colour.channels)."""
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])


def ambient(light, surface):
    """light.ambient"""
    return product(light, surface)


def lambert(light, surface, normal, direction):
    """-<N, d> (light . surface), black from behind (light.lambert, light.lambert.behind)."""
    f = -V.dot(normal, direction)
    if f < 0:
        return BLACK
    return V.scale(f, product(light, surface))


def _power(f, n):
    """f^n with 0^0 = 1 (light.power)."""
    return 1.0 if n == 0 else f ** n


def blinn(light, surface, normal, direction, view, shininess):
    """light.blinn, light.blinn.behind, light.blinn.opposite, light.power."""
    half = V.subtract(V.negate(view), direction)
    if V.is_zero(half):
        return BLACK
    length = V.modulus(half)
    if length == 0:
        half = V.unit(half)
    else:
        half = (half[0] / length, half[1] / length, half[2] / length)
    f = V.dot(normal, half)
    if f < 0:
        return BLACK
    return V.scale(_power(f, shininess), product(light, surface))


def phong(light, surface, normal, direction, view, shininess):
    """light.phong, light.phong.behind, light.power."""
    mirrored = V.subtract(direction, V.scale(2 * V.dot(direction, normal), normal))
    f = V.dot(mirrored, V.negate(view))
    if f < 0:
        return BLACK
    return V.scale(_power(f, shininess), product(light, surface))
