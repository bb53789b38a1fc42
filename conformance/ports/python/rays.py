"""Rays: pairs of an origin and a direction (specification 5.1)."""


def position(ray, t):
    """o + t d, one product and one sum in each coordinate (geometry.ray.position)."""
    o, d = ray
    return (o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2])
