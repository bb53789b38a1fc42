"""Lights of waves (specification 6.7)."""

import math

import language as L
import vector as V
from camera import frame


def _bell(l, c, a, b):
    w = (l - c) * a if l < c else (l - c) * b
    return math.exp(-w * w / 2)


def colour(l):
    """The colour of a wavelength in nanometres (light.wave.colour)."""
    x = (0.362 * _bell(l, 442, 0.0624, 0.0374) + 1.056 * _bell(l, 599.8, 0.0264, 0.0323)
         - 0.065 * _bell(l, 501.1, 0.0490, 0.0382))
    y = 0.821 * _bell(l, 568.8, 0.0213, 0.0247) + 0.286 * _bell(l, 530.9, 0.0613, 0.0322)
    z = 1.217 * _bell(l, 437, 0.0845, 0.0278) + 0.681 * _bell(l, 459, 0.0385, 0.0725)
    rgb = (3.2406255 * x - 1.537208 * y - 0.4986286 * z,
           -0.9689307 * x + 1.8757561 * y + 0.0415175 * z,
           0.0557101 * x - 0.2040211 * y + 1.0569959 * z)
    cut = [min(1.0, max(0.0, c)) for c in rgb]
    return tuple(12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in cut)


def sources(item):
    """The places of the sources (light.wave.row, light.wave.grid, light.wave.ellipse,
    light.wave.mask, light.wave.none)."""
    v, n = item.values, item.values["nb_oscillator"]
    if item.block is L.LINEAR:
        p1, p2 = v["point"]
        if n == 1:
            return [V.scale(0.5, V.add(p1, p2))]
        return [V.add(p1, V.scale(i / (n - 1), V.subtract(p2, p1))) for i in range(n)]
    if n < 2:
        return [v["position"]] * n
    width, height = v["width"], v["height"]
    _, up, right = frame(v["front"], v["up"])
    nx, ny = L.grid(width, height, n)
    corner = V.subtract(V.subtract(v["position"], V.scale(width / 2, right)),
                        V.scale(height / 2, up))
    found = []
    for i in range(nx):
        x = width if i == nx - 1 else i * (width / (nx - 1))
        column = V.add(corner, V.scale(x, right))
        for j in range(ny):
            y = height if j == ny - 1 else j * (height / (ny - 1))
            if item.block is L.ELLIPTICAL:
                dx, dy = x - width / 2, y - height / 2
                if not (dx * dx / (width * width / 4) + dy * dy / (height * height / 4)
                        <= 1 + 1e-10):
                    continue
            found.append(V.add(column, V.scale(y, up)))
    return found


class Waves:
    def __init__(self, item):
        v = item.values
        self.sources = sources(item)
        self.colour = colour(v["wave_length"])
        self.k = 2 * math.pi / (v["wave_length"] * 1e-9)
        self.instants = v["period_iteration"]
        # light.wave.place
        self.position = (V.scale(0.5, V.add(*v["point"])) if item.block is L.LINEAR
                         else v["position"])

    def intensity(self, point):
        """light.wave.intensity, light.wave.few-instants"""
        n = len(self.sources)
        if n == 0:
            return 0.0
        c = s = 0.0
        for source in self.sources:
            phase = self.k * V.distance(source, point)
            c += math.cos(phase)
            s += math.sin(phase)
        if self.instants < 3:
            return s * s / (n * n)
        return (c * c + s * s) / (2 * n * n)
