"""The cases of camera.ray: chapter 8, in decimals of 60 digits, with SplitMix64 in whole numbers."""

import random
import sys
from decimal import Decimal
from fractions import Fraction

sys.dont_write_bytecode = True

from suite import DECIMAL, PI, add, case, cross, decimal, decimals, dtan, dunit, main, numbers, sub, times  # noqa: E402

MASK = 2**64 - 1
CORNERS = {"top_left": (0, 0), "top_right": (1, 0), "bottom_left": (0, 1), "bottom_right": (1, 1), "center": (Fraction(1, 2), Fraction(1, 2))}


def mix(z):
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def uniform(seed, i):
    """The number i of a seed, as a fraction."""
    return Fraction(mix((mix(seed) + (i + 1) * 0x9E3779B97F4A7C15) & MASK) >> 11, 2**53)


def place(column, row, sample, width, coordinate, sampling, seed):
    """The point of the picture that a sample goes through, in pixels."""
    if coordinate == "random":
        i = 2 * ((row * width + column) * sampling + sample)
        return column + uniform(seed, i), row + uniform(seed, i + 1)
    a, b = CORNERS[coordinate]
    return column + a, row + b


def ray(x, y, position=(0, 0, 0), look_at=(0, 0, 1), up=(0, 1, 0), angle=60, near=1, width=500, height=500):
    """Origin and direction, in decimals."""
    position = decimals(map(float, position))
    front = dunit(sub(decimals(map(float, look_at)), position))
    across = cross(front, decimals(map(float, up)))
    top = dunit(cross(across, front))
    right = dunit(cross(front, top))
    down = dunit(cross(front, right))
    near, tall = decimal(float(near)), 2 * decimal(float(near)) * dtan(decimal(float(angle)) * PI / 360)
    step = tall / height
    middle = add(position, times(near, front))
    point = add(middle, add(times(step * (decimal(x) - Decimal(width) / 2), right), times(step * (decimal(y) - Decimal(height) / 2), down)))
    return point, dunit(sub(point, position))


def vector(a):
    return " ".join(repr(x) for x in a)


def one(rules, comment, flags, column, row, sample=None, coordinate=None, sampling=None, seed=None, extra="", **values):
    """A case; what is the default is not written."""
    words = {"near": "near_clipping_plane"}
    lines = ["camera"] + [f"  {words.get(name, name)} {vector(v) if isinstance(v, (list, tuple)) else repr(v)}" for name, v in values.items() if name not in ("width", "height")] + ["end"]
    lines += ["viewport"] + [f"  {name} {values[name]}" for name in ("width", "height") if name in values] + ["end"]
    lines += ["raytracer"] + [f"  {name} {v}" for name, v in (("pixel_coordinate", coordinate), ("sampling", sampling), ("seed", seed)) if v is not None] + ["end"]
    x, y = place(column, row, sample or 0, values.get("width", 500), coordinate or "top_left", sampling or 1, seed or 0)
    point, way = ray(x, y, **values)
    middle = x == Fraction(values.get("width", 500), 2) and y == Fraction(values.get("height", 500), 2)
    sent = {"text": "\n".join(lines) + "\n" + extra, "column": column, "row": row}
    if sample is not None:
        sent["sample"] = sample
    size = max(1, *[abs(c) for c in point], *[abs(decimal(float(c))) for c in values.get("position", (0, 0, 0))])
    near = min(1, values.get("near", 1))
    wide = float(size) * 1e-14
    compare = {"origin": f"abs:{wide:.1e}", "direction": f"abs:{max(1e-14, wide / near):.1e}"}
    if middle and all(float(c) == int(c) for c in numbers(point)) and sorted(map(abs, numbers(way))) == [0, 0, 1]:
        compare = "exact"
    return case(rules, comment, flags, sent, {"origin": numbers(point), "direction": numbers(way)}, compare, DECIMAL)


def operations():
    c, made = one, []
    small = {"width": 4, "height": 4, "angle": 90}
    made += [
        c("camera.front camera.ray", "The middle of the picture: along the front.", "front", 2, 2, position=[1, 2, 3], look_at=[1, 2, 8], width=4, height=4),
        c("camera.front", "look_at is a point, not a direction.", "sign", 2, 2, position=[1, 2, 3], look_at=[1, 2, -8], width=4, height=4),
        c("camera.front", "Along -x.", "front sign", 2, 2, position=[5, 0, 0], look_at=[0, 0, 0], width=4, height=4),
        c("camera.front", "Along y, with up along z.", "front", 2, 2, position=[0, 5, 0], look_at=[0, 9, 0], up=[0, 0, 1], width=4, height=4),
        c("camera.front", "The front is made unit: a far look_at changes nothing.", "not-normalized", 0, 1, look_at=[0, 0, 1000], **small),
        c("camera.front", "A very near one, too.", "epsilon not-normalized", 0, 1, look_at=[0, 0, 1e-9], **small),
        c("camera.front", "A slanting front.", "front", 0, 0, position=[1, -2, 3], look_at=[4, 2, 3], **small),
        c("camera.up", "Only the part of up across the front counts.", "up", 0, 0, up=[0, 2, 7], **small),
        c("camera.up", "Upside down.", "sign", 0, 0, up=[0, -1, 0], **small),
        c("camera.up", "up along x.", "up swapped-index", 1, 0, up=[1, 0, 0], **small),
        c("camera.up", "up a little off: a picture that is turned.", "up", 3, 0, up=[1, 2, 0], **small),
        c("camera.up", "Long and short ups.", "not-normalized", 0, 0, up=[0, 1e-9, 0], **small),
        c("camera.up", "A long one.", "not-normalized", 0, 1, up=[0, 1e50, 0], **small),
        c("camera.up", "Nearly along the front.", "epsilon", 0, 0, up=[0, 1e-5, 1], **small),
        c("camera.size", "The angle is the vertical one: a wide picture.", "aspect", 0, 0, angle=90, near=2, width=4, height=2),
        c("camera.size", "A tall picture.", "aspect", 0, 0, angle=90, near=2, width=2, height=4),
        c("camera.size", "60 degrees by default.", "default degrees", 0, 0, width=4, height=4),
        c("camera.size", "The narrowest angle.", "degrees", 0, 0, angle=10, width=4, height=4),
        c("camera.size", "The widest angle.", "degrees", 0, 0, angle=170, width=4, height=4),
        c("camera.size", "The near plane's distance scales the picture, not the directions.", "near", 1, 3, near=50, angle=40, width=5, height=7),
        c("camera.size", "A very near one.", "near epsilon", 1, 3, near=1e-6, angle=40, width=5, height=7),
        c("camera.axes", "Right is -x.", "mirrored", 3, 1, **small),
        c("camera.axes", "Down is -y.", "mirrored", 1, 3, **small),
        c("camera.axes", "The first column and the last.", "mirrored", 3, 2, **small),
        c("camera.axes", "Columns and rows are not one another.", "swapped-index", 5, 1, width=6, height=3, angle=50),
        c("camera.axes", "The same in the other corner.", "swapped-index", 1, 2, width=6, height=3, angle=50),
        c("camera.axes", "Axes of a slanting camera.", "axes", 3, 1, position=[1, 2, 3], look_at=[3, 5, 9], up=[1, 1, -1], angle=70, width=5, height=4),
        c("camera.axes", "Another one.", "axes", 0, 3, position=[-4, 0.5, 2], look_at=[1, -1, -1], up=[0, 0, 1], angle=35, near=3, width=8, height=4),
        c("camera.point", "The middle of an odd size: exact.", "half-pixel", 2, 1, width=5, height=3, coordinate="center"),
        c("camera.point", "The middle of an even size is a corner.", "half-pixel", 250, 250),
        c("camera.point", "An odd size, its corner.", "half-pixel", 0, 0, width=5, height=3),
        c("camera.point", "One pixel.", "half-pixel", 0, 0, width=1, height=1, coordinate="center"),
        c("camera.point", "One pixel, its corner.", "half-pixel", 0, 0, width=1, height=1),
        c("camera.point", "A large picture, its last pixel.", "half-pixel", 16383, 16383, width=16384, height=16384),
        c("camera.point", "The middle, exactly, of a camera elsewhere.", "half-pixel", 3, 3, position=[10, 20, 30], look_at=[10, 20, 35], near=4, width=7, height=7, coordinate="center"),
        c("camera.ray", "It starts on the near plane, not at the eye.", "origin", 0, 0, position=[10, 0, 0], look_at=[11, 0, 0], angle=90, near=3, width=2, height=2),
        c("camera.ray", "Its direction is unit.", "not-normalized", 0, 0, angle=120, near=0.25, width=2, height=2),
        c("camera.ray", "A picture far away from the origin.", "cancellation", 0, 2, position=[1000, -2000, 500], look_at=[1003, -2001, 502], angle=45, width=3, height=4),
    ]
    for name in CORNERS:
        made.append(c("camera.pixel-coordinate", f"{name}, in the middle of a picture that is not square.", "half-pixel swapped-index", 1, 2, coordinate=name, width=5, height=4, angle=80))
        made.append(c("camera.pixel-coordinate", f"{name}, in the last pixel.", "half-pixel", 3, 1, coordinate=name, width=4, height=2, angle=90))
    tiny = {"angle": 90, "near": 0.5}
    for seed, note in [(None, "Seed 0, by default"), (0, "Seed 0, written"), (1, "Seed 1"), (2, "Seed 2"), (2024, "Seed 2024"), (2147483647, "The largest seed"), (2147483646, "The one before")]:
        rule = "camera.seed.largest camera.seed" if seed and seed > 10**6 else "camera.seed"
        made.append(c(f"camera.generator {rule}", f"{note}: the first number of it, in a picture of one pixel.", "generator", 0, 0, coordinate="random", seed=seed, width=1, height=1, **tiny))
    made.append(c("camera.seed.largest", "The largest seed in the last sample of a picture.", "generator overflow", 2, 1, sample=8, coordinate="random", sampling=9, seed=2147483647, width=3, height=2, **tiny))
    for column, row, sample, sampling, width, height, seed in [(2, 1, 3, 4, 3, 2, 2024), (1, 0, 0, 1, 2, 1, 0), (0, 1, 0, 1, 3, 2, 0), (0, 0, 1, 2, 1, 1, 7), (2, 0, 1, 3, 4, 5, 7), (0, 4, 2, 3, 4, 5, 7), (3, 4, 0, 16, 4, 5, 7), (499, 499, 99, 100, 500, 500, 3), (16383, 16383, 2147483646, 2147483647, 16384, 16384, 5)]:
        made.append(c("camera.random camera.generator", f"Sample {sample} of {sampling} in column {column} and row {row} of {width} x {height}.", "generator swapped-index", column, row, sample=sample, coordinate="random", sampling=sampling, seed=seed, width=width, height=height, **tiny))
    made.append(c("camera.ray.operation camera.random", "Without a sample: sample 0.", "default", 1, 1, coordinate="random", sampling=5, seed=9, width=3, height=3, **tiny))
    made.append(c("camera.ray.operation", "Sample 0, asked for.", "default", 1, 1, sample=0, coordinate="random", sampling=5, seed=9, width=3, height=3, **tiny))
    made.append(c("camera.ray.operation camera.sampling.fixed", "Every sample of a place that is not random has the same ray: the last one.", "sampling", 2, 1, sample=4, coordinate="center", sampling=5, width=4, height=4, angle=90))
    made.append(c("camera.ray.operation camera.sampling.fixed", "The first one.", "sampling", 2, 1, sample=0, coordinate="center", sampling=5, width=4, height=4, angle=90))
    made.append(c("camera.independent camera.ray.operation", "space and task do not matter.", "generator", 2, 1, sample=1, coordinate="random", sampling=2, seed=4, extra="", width=3, height=2, **tiny))
    source = random.Random(61)
    for _ in range(10):
        width, height = source.randint(1, 40), source.randint(1, 40)
        position, look, up = ([round(source.uniform(-9, 9), 3) for _ in range(3)] for _ in range(3))
        made.append(c("camera.axes camera.point camera.size", "Random digits.", "axes", source.randrange(width), source.randrange(height), position=position, look_at=look, up=up, angle=round(source.uniform(10, 170), 2), near=round(source.uniform(0.5, 5), 2), width=width, height=height, coordinate=source.choice(list(CORNERS))))
    return {"camera.ray": made}


if __name__ == "__main__":
    main(sys.modules[__name__])
