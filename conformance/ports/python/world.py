"""What stands in a scene, ready for rays: primitives, materials, media, shadows
(specification 5.2, 6.2, 6.6, 7.5)."""

import math

import light
import vector as V
from shapes import build

WHITE = (1.0, 1.0, 1.0)


class Material:
    """light.material.ambient, .diffuse, .specular, .tint, .index. Pictures are never there
    (protocol.text), so that plain colours are used."""

    def __init__(self, v):
        colour = v["color"][:3]
        self.alpha = v["color"][3]
        self.ambient = V.scale(v["ka"], colour)
        self.diffuse = V.scale(v["kd"], colour)
        p = v["plasticity"]
        self.specular = V.scale(v["ks"], V.add(V.scale(p, WHITE), V.scale(1 - p, colour)))
        self.tint = V.scale(v["kt"], colour)
        self.kr, self.kt, self.shininess = v["kr"], v["kt"], v["shininess"]
        self.index = v["refractive_index"] if v["kt"] != 0 else 1.0


class Primitive:
    def __init__(self, shape, material):
        self.shape, self.material = shape, material


def shape_of(item):
    """The shape of an Item of checking.py, however deep it is nested."""
    chain = [item]
    while chain[-1].shape is not None:
        chain.append(chain[-1].shape)
    shape = None
    for item in reversed(chain):
        shape = build(item.block.name, dict(item.values, geometry=shape))
    return shape


class World:
    def __init__(self, scene):
        materials = {}
        for item in scene.materials:                       # light.material.first
            materials.setdefault(item.values["name"], Material(item.values))
        self.primitives = [Primitive(shape_of(item.shape), materials[item.values["material_name"]])
                           for item in scene.primitives]
        self.closed = [p for p in self.primitives if p.shape.closed]

    def closest(self, ray, far):
        """The first hit of all before far, with its primitive, or None
        (geometry.hit.closest, geometry.hit.tie, camera.far)."""
        best = None
        for primitive in self.primitives:
            found = primitive.shape.first(ray)
            if found is not None and found[0] < far and (best is None or found[0] < best[1][0]):
                best = (primitive, found)
        if best is None:
            return None
        primitive, (t, part) = best
        return primitive, primitive.shape.hit_at(ray, t, part)

    def medium(self, point, left_out=None):
        """optics.medium.at, optics.medium.opaque, optics.medium.left-out"""
        indices = [p.material.index for p in self.closed
                   if p is not left_out and p.shape.contains(point)]
        if not indices:
            return 1.0
        return sum(indices) / len(indices)

    def shadowed(self, colour, point, direction, distance=math.inf):
        """A light's colour after the shadows, or None where nothing arrives
        (light.shadow.ray, .opaque, .beyond, .transparent, .product, .dark)."""
        ray = (point, V.negate(direction))
        for primitive in self.primitives:
            found = primitive.shape.first(ray)
            if found is not None and found[0] < distance:
                if primitive.material.kt == 0:
                    return None
                colour = light.product(colour, primitive.material.tint)
        return None if max(colour) < 1e-10 else colour
