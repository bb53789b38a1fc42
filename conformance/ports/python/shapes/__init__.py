"""The shapes (specification chapter 5). `build` makes one from its property values."""

from .cap import Cap
from .cone import Cone, double_cone
from .cube import Cube
from .lens import Lens
from .planar import Annulus, Disk, Plane
from .sphere import Sphere
from .torus import Torus
from .transformed import Transformed
from .triangle import SmoothTriangle, Triangle
from .tube import Cylinder, Tube


def build(kind, v):
    """A shape from its kind and a dictionary of property values, which are possible."""
    if kind == "sphere":
        return Sphere(v["position"], v["ray"])
    if kind == "plane":
        return Plane(v["position"], v["normal"])
    if kind == "disk":
        return Disk(v["position"], v["normal"], v["ray"])
    if kind == "annulus":
        return Annulus(v["position"], v["normal"], v["ray"], v["inner_ray"])
    if kind == "triangle":
        return Triangle(*v["point"])
    if kind == "btriangle":
        return SmoothTriangle(v["point"], v["normal"], v["uv"])
    if kind == "tube":
        return Tube(v["point"][0], v["point"][1], v["ray"])
    if kind == "cylinder":
        return Cylinder(v["point"][0], v["point"][1], v["ray"])
    if kind == "cone":
        return Cone(v["point"][0], v["point"][1], v["ray"])
    if kind == "cube":
        return Cube(v["position"], v["size"])
    if kind == "spherical_cap":
        return Cap(v["position"], v["normal"], v["ray"], v["curvature"])
    if kind == "lens":
        return Lens(v["point"][0], v["point"][1], v["ray"], v["curvature"])
    if kind == "torus":
        return Torus(v["position"], v["normal"], v["major_radius"], v["minor_radius"])
    if kind == "geometry":
        return Transformed(v["scale"], v["rotation"], v["translation"], v["geometry"])
    raise KeyError(kind)
