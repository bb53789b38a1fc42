"""From colours to bytes (specification chapters 8.3 and 10)."""

import struct

import light
import vector as V
from camera import Camera
from shading import Shader
from world import World


def single(x):
    """x rounded to binary32."""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def byte(c):
    """picture.byte, picture.byte.range"""
    if not c > 0:
        return 0
    if c >= 1:
        return 255
    return int(single(single(c) * 255) + 0.5)


def pixel(colour, normalization):
    """picture.clamp, picture.division, picture.alpha, picture.pixel"""
    rgb = colour[:3]
    if normalization == "division_factor":
        largest = max(1.0, *rgb)
        rgb = tuple(c / largest for c in rgb)
    return [byte(c) for c in rgb] + [byte(colour[3])]


class Picture:
    def __init__(self, scene):
        self.camera = Camera(scene)
        self.shader = Shader(scene, World(scene))
        self.normalization = scene.raytracer.values["color_normalization"]

    def pixel(self, column, row):
        """camera.sampling.one, camera.sampling.mean, camera.sampling.opaque,
        camera.sampling.fixed"""
        camera = self.camera
        if camera.samples == 1:
            colour = self.shader.colour(camera.ray(column, row, 0))
        else:
            total = light.BLACK
            for sample in range(camera.samples):
                total = V.add(total, self.shader.colour(camera.ray(column, row, sample))[:3])
            colour = V.scale(1 / camera.samples, total) + (1.0,)
        return pixel(colour, self.normalization)

    def bytes(self):
        """picture.rows, camera.every-pixel"""
        found = bytearray()
        for row in range(self.camera.height):
            for column in range(self.camera.width):
                found.extend(self.pixel(column, row))
        return bytes(found)
