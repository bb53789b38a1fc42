"""The rays of a pixel (specification 8.1, 8.3)."""

import math

import rays
import vector as V

MASK = 0xFFFFFFFFFFFFFFFF
CORNERS = {"top_left": (0.0, 0.0), "top_right": (1.0, 0.0), "bottom_left": (0.0, 1.0),
           "bottom_right": (1.0, 1.0), "center": (0.5, 0.5)}


def mix(z):
    """camera.generator"""
    z ^= z >> 30
    z = z * 0xBF58476D1CE4E5B9 & MASK
    z ^= z >> 27
    z = z * 0x94D049BB133111EB & MASK
    return z ^ (z >> 31)


def random_number(seed, i):
    """The number i of a seed (camera.generator, camera.seed, camera.seed.largest)."""
    return (mix((mix(seed) + (i + 1) * 0x9E3779B97F4A7C15) & MASK) >> 11) * 2.0 ** -53


def frame(front, up):
    """front, up and right, orthonormal (camera.front, camera.up, light.wave.frame)."""
    front = V.unit(front)
    up = V.unit(V.cross(V.cross(front, up), front))
    return front, up, V.cross(front, up)


class Camera:
    def __init__(self, scene):
        camera, view, tracer = scene.camera.values, scene.viewport.values, scene.raytracer.values
        self.width, self.height = view["width"], view["height"]
        self.samples, self.seed = tracer["sampling"], tracer["seed"]
        self.coordinate = tracer["pixel_coordinate"]
        self.eye = camera["position"]
        near = camera["near_clipping_plane"]
        front, up, right = frame(V.subtract(camera["look_at"], self.eye), camera["up"])
        right = V.unit(right)
        down = V.unit(V.cross(front, right))
        # camera.size, camera.axes
        high = 2 * near * math.tan(camera["angle"] / 180 * math.pi / 2)
        wide = high * self.width / self.height
        self.u1 = tuple(c * wide / self.width for c in right)
        self.u2 = tuple(c * high / self.height for c in down)
        # camera.point
        c = V.add(self.eye, V.scale(near, front))
        r0 = V.add(V.scale(-self.width / 2, self.u1), V.scale(-self.height / 2, self.u2))
        self.corner = V.add(c, r0)

    def ray(self, column, row, sample):
        """camera.point, camera.ray, camera.pixel-coordinate, camera.random"""
        if self.coordinate == "random":
            i = 2 * ((row * self.width + column) * self.samples + sample)
            a, b = random_number(self.seed, i), random_number(self.seed, i + 1)
        else:
            a, b = CORNERS[self.coordinate]
        p = rays.position((rays.position((self.corner, self.u1), column + a), self.u2), row + b)
        return p, V.unit(V.subtract(p, self.eye))
