#!/usr/bin/env python3
"""Hits: the first parameter at which a ray meets a shape, with point, normal and texture coordinates.

Most expected values come from `solids`, in decimals of 60 digits; rays are taken whose hit hardly changes when they are moved a little, or corner cases in numbers that are
exact in binary64. Where only the rule decides (an edge, a rim, a threshold, a line in a surface), the value is written here by hand.
"""

import math
import random
import sys

sys.dont_write_bytecode = True

import solids  # noqa: E402
import suite  # noqa: E402
from suite import CLOSED, DECIMAL, HAND, case, decimals, next_up  # noqa: E402

LOOSE = {"t": "abs:1e-11", "point": "abs:1e-11", "normal": "abs:1e-11", "uv": "abs:1e-11"}
CLOSE = {"t": "abs:1e-13", "point": "abs:1e-13", "normal": "abs:1e-13", "uv": "abs:1e-13"}
FLAT = ("plane", "disk", "annulus", "cube", "triangle", "btriangle")

CASES = []


def labels(rules, shape):
    """Labels that begin with a dot are those of the shape."""
    topic = {"spherical_cap": "cap", "btriangle": "smooth-triangle", "geometry": "transformed"}.get(shape["kind"], shape["kind"])
    return ["geometry." + (topic + rule if rule.startswith(".") else rule) for rule in rules.split()]


def few_digits(x):
    return (x * 4096).is_integer() and abs(x) < 2**20


def one(rules, comment, flags, shape, o, d, expected="computed", compare=None, source=None):
    """A case; `expected` is None for no hit, or (t, normal, uv), or is computed."""
    ray = {"origin": o, "direction": d}
    if expected == "computed":
        try:
            made, source = solids.rounded(solids.hit(shape, ray)), source or DECIMAL
        except solids.Unsafe as unsafe:
            raise AssertionError(f"{comment}: {unsafe}")
        if compare is None:
            exact = made is None or shape["kind"] in FLAT and all(few_digits(x) for x in [made["t"], *made["point"], *made["normal"], *made["uv"]])
            compare = "exact" if exact else LOOSE if shape["kind"] in ("torus", "lens", "cone", "spherical_cap", "geometry") else CLOSE
    elif expected is None:
        made, source, compare = None, source or HAND, "exact"
    else:
        t, n, uv = expected
        made, source = {"t": t, "point": [x + t * y for x, y in zip(map(float, o), map(float, d))], "normal": n, "uv": uv}, source or HAND
        compare = compare or "exact"
    sent = {"geometry": shape, "ray": ray}
    for other in CASES:
        if other["in"] == sent:  # the same question, for other rules
            other["rules"] += [rule for rule in labels(rules, shape) if rule not in other["rules"]]
            other["flags"] += [flag for flag in flags.split() if flag not in other["flags"]]
            return
    CASES.append(case(labels(rules, shape), comment, flags, sent, made, compare, source))


# Shapes of every kind, plain


def some(chance, low, high, places=2):
    return round(chance.uniform(low, high), places)


def vector(chance, size, places=2):
    return [some(chance, -size, size, places) for _ in range(3)]


def normal(chance):
    while True:
        n = vector(chance, 2)
        a = sorted(abs(x) for x in n)
        if a[2] > 0.5 and a[1] - a[0] > 0.1:
            return n


def curvature(chance, r, sign):
    return round(sign * (r + chance.uniform(0.3, 3)), 2)


def random_shape(kind, chance):
    p, n, r = vector(chance, 2), normal(chance), some(chance, 0.8, 2.5)
    made = {"kind": kind}
    if kind in ("sphere", "plane", "disk", "annulus", "cube", "spherical_cap", "torus"):
        made["position"] = p
    if kind in ("plane", "disk", "annulus", "spherical_cap", "torus"):
        made["normal"] = n
    if kind in ("disk", "annulus", "sphere", "tube", "cylinder", "cone", "spherical_cap", "lens"):
        made["ray"] = r
    if kind == "annulus":
        made["inner_ray"] = round(r * 0.4, 2)
    if kind == "cube":
        made["size"] = some(chance, 1, 4)
    if kind in ("triangle", "btriangle"):
        made["point"] = [vector(chance, 3) for _ in range(3)]
    if kind == "btriangle":
        made["normal"] = [normal(chance) for _ in range(3)]
        made["uv"] = [[some(chance, -2, 2), some(chance, -2, 2)] for _ in range(3)]
    if kind in ("tube", "cylinder", "cone", "lens"):
        k = chance.uniform(1.0, 2.5) / math.sqrt(sum(x * x for x in n))
        made["point"] = [p, [round(x + k * y, 2) for x, y in zip(p, n)]]
    if kind == "spherical_cap":
        made["curvature"] = curvature(chance, r, chance.choice([1, -1]))
    if kind == "lens":
        signs = chance.choice([(1, 1), (1, -1), (-1, 1), (-1, -1)])
        made["curvature"] = [curvature(chance, r, s) for s in signs]
    if kind == "torus":
        made["major_radius"], made["minor_radius"] = some(chance, 1, 2), some(chance, 0.3, 0.9)
    return made


def possible(shape):
    """Whether the shape can be made, with a margin."""
    g = solids.full(shape)
    if shape["kind"] == "lens":
        p, s, h = solids.axis(g)
        r = g["ray"]
        bulge = lambda c, x: solids.sign(c) * ((c * c - x * x).sqrt() - (c * c - r * r).sqrt())
        return all(h + sum(bulge(c, r * k / 10) for c in g["curvature"]) > 0.2 for k in range(11))
    if shape["kind"] in ("triangle", "btriangle"):
        s = suite.cross(suite.sub(g["point"][1], g["point"][0]), suite.sub(g["point"][2], g["point"][0]))
        return suite.dot(s, s) > 4
    return True


def middle(shape):
    if shape["kind"] in ("triangle", "btriangle"):
        return [sum(p[i] for p in shape["point"]) / 3 for i in range(3)]
    if "point" in shape:
        return [(a + b) / 2 for a, b in zip(*shape["point"])]
    return shape.get("position", [0, 0, 0])


def aimed(shape, chance, wanted, inside=False):
    """A ray whose hit is steady, with a part of the surface that is wanted."""
    target = middle(shape)
    size = 1.0 if inside else 9.0
    for _ in range(4000):
        away = vector(chance, size)
        o = [round(x + y, 2) for x, y in zip(target, away)]
        d = [round(x + y - z, 2) for x, y, z in zip(target, vector(chance, 1.6), o)]
        if not any(d):
            continue
        ray = {"origin": o, "direction": d}
        try:
            made = solids.hit(shape, ray)
            if (made is None) == (wanted is None) and (wanted is None or wanted(made, ray)) and (made is None or 0.05 < made["t"] < 50) and solids.steady(shape, ray):
                return o, d
        except solids.Unsafe:
            continue
    raise AssertionError(f"no ray found: {shape}")


def faces(made, ray):
    return suite.dot(made["normal"], decimals(ray["direction"])) < 0


def backs(made, ray):
    return suite.dot(made["normal"], decimals(ray["direction"])) > 0


def tag_is(shape, tag):
    def asked(made, ray):
        found = solids.first(shape, decimals(ray["origin"]), decimals(ray["direction"]))
        while isinstance(found[1], tuple):
            found = found[1]
        return found[1] == tag

    return asked


PARTS = {"cylinder": ("side", "low", "high"), "cone": ("side", "low"), "lens": ("side", "first", "second"), "cube": ("+z", "-z", "+y", "-y", "+x", "-x")}
MEETS = {"plane": ".parameters .uv .unit-normal", "disk": ".parameters .uv", "annulus": ".parameters disk.uv", "sphere": ".parameters .normal .uv", "cube": ".slabs .normal .uv",
         "triangle": ".parameters .normal .edges", "btriangle": ".parameters .normal .uv", "tube": ".ends .normal .uv", "cylinder": ".interval .normal .uv", "cone": ".interval .normal .uv",
         "spherical_cap": ".surface .normal .parameters disk.uv", "lens": ".body .normal .uv", "torus": ".equation .normal .uv .precision"}


def plain():
    for number, kind in enumerate(MEETS):
        chance = random.Random(600 + number)

        def shape():
            while True:
                made = random_shape(kind, chance)
                if possible(made):
                    return made

        for part in PARTS.get(kind, ()):
            for _ in range(1 if kind == "cube" else 2):
                g = shape()
                one(MEETS[kind] + " hit.normal hit.first uv.every-shape", f"From outside, on the part '{part}'", "wrong-normal wrong-part", g, *aimed(g, chance, tag_is(g, part)))
        for i in range(3):
            g = shape()
            one(MEETS[kind] + " hit.normal hit.first ray.direction", "Oblique, in front of the surface", "wrong-normal sign", g, *aimed(g, chance, faces))
        for i in range(2):
            g = shape()
            one(MEETS[kind] + " hit.normal hit.point", "Against the back of the surface, or from inside: the normal is not turned to the ray", "normal-turned", g, *aimed(g, chance, backs, inside=kind in solids.CLOSED))
        if kind in solids.CLOSED or kind in ("tube", "spherical_cap"):
            g = shape()
            one(MEETS[kind] + " hit.first", "From within: the parameter behind the origin does not count", "negative-kept", g, *aimed(g, chance, lambda made, ray: True, inside=True))
        if kind != "plane":
            g = shape()
            one(MEETS[kind].split()[0] + " hit.none", "Past the shape", "bounded-wrong", g, *aimed(g, chance, None))
        g = shape()
        o, d = aimed(g, chance, faces)
        one(MEETS[kind].split()[0] + " hit.none", "The shape is behind the origin", "negative-kept", g, o, [-x for x in d])
        one(MEETS[kind].split()[0] + " ray.direction hit.point", "A direction eight times as long", "direction-normalized", g, o, [8 * x for x in d])


def carried():
    chance = random.Random(640)
    rules = "transformed.parameters transformed.normal transformed.rotated transformed.uv"
    for kind in MEETS:
        def inner():
            while True:
                made = random_shape(kind, chance)
                if possible(made):
                    return made

        for flag, scale, turned in (("scale-ignored", [2, 0.5, 1.5], [0, 0, 0]), ("rotation-order", [1, 1, 1], [30, -50, 110]), ("mirrored", [-1.5, 0.75, 2], [20, 40, 65])):
            g = {"kind": "geometry", "scale": scale, "rotation": turned, "translation": vector(chance, 2), "geometry": inner()}
            aim = lambda made, ray: True
            more = " transformed.mirrored" if scale[0] < 0 else ""
            one(rules + more, f"A {kind}: {flag.replace('-', ' ')}", flag, g, *aimed_at_carried(g, chance, aim))
        nested = {"kind": "geometry", "rotation": [0, 0, 70], "scale": [1, 2, 1], "geometry": {"kind": "geometry", "translation": [1, 0, 0], "rotation": [40, 0, 0], "scale": [0.5, 1, 1], "geometry": inner()}}
        one("transformed.nested transformed.parameters transformed.normal", f"A {kind} in two transformations, the inner one first", "nested-order", nested, *aimed_at_carried(nested, chance, aim))


def aimed_at_carried(g, chance, wanted):
    """As `aimed`, for a ray that is aimed at the image of the inner shape's middle."""
    chain, shape = [], g
    while shape["kind"] == "geometry":
        chain.append(solids.full(shape))
        shape = shape["geometry"]
    point = decimals(middle(shape))
    for frame in reversed(chain):
        rows = solids.matrix(frame)
        scaled = [x * k for x, k in zip(point, frame["scale"])]
        point = [suite.dot(row, scaled) + move for row, move in zip(rows, frame["translation"])]
    target = [round(float(x), 2) for x in point]
    for _ in range(4000):
        o = [round(x + y, 2) for x, y in zip(target, vector(chance, 9))]
        d = [round(x + y - z, 2) for x, y, z in zip(target, vector(chance, 1.2), o)]
        ray = {"origin": o, "direction": d}
        try:
            made = solids.hit(g, ray)
            if made is not None and 0.05 < made["t"] < 50 and wanted(made, ray) and solids.steady(g, ray):
                return o, d
        except solids.Unsafe:
            continue
    raise AssertionError(f"no ray found: {g}")


# Corner cases


def every_shape():
    """What holds for all: defaults, the smallest parameter, points."""
    z = [0, 0, 1]
    down = [0, 0, -1]
    for kind, o, d in (("sphere", [0.25, 0.5, 3], down), ("plane", [1, 2, 3], down), ("disk", [0.25, 0.5, 3], down), ("annulus", [0.25, 0.625, 3], down), ("cube", [0.25, 0.125, 3], down),
                       ("triangle", [0.25, 0.5, 3], down), ("btriangle", [0.25, 0.5, 3], down), ("tube", [3, 0.25, 0.75], [-1, 0, 0]), ("cylinder", [0.25, 0.5, 3], down), ("cone", [3, 0.25, 0.25], [-1, 0, 0]),
                       ("spherical_cap", [0.25, 0.5, 3], down), ("lens", [0.25, 0.5, 3], down), ("torus", [1.125, 0.125, 3], down)):
        one(MEETS[kind].split()[0] + " uv.every-shape", "Nothing is given: defaults", "wrong-default", {"kind": kind}, o, d)
    for kind, o, d in (("sphere", [0, 0.99, 3], down), ("disk", [0.99, 0, 3], down), ("annulus", [0, 0.51, 3], down), ("cube", [0.49, 0.49, 3], down), ("triangle", [0.01, 0.98, 3], down),
                       ("tube", [3, 0, 0.99], [-1, 0, 0]), ("cylinder", [3, 0, 0.01], [-1, 0, 0]), ("cone", [3, 0, 0.01], [-1, 0, 0]), ("lens", [0.98, 0, 3], down), ("torus", [1.19, 0.01, 3], down)):
        one(MEETS[kind].split()[0], "Just inside the default size", "wrong-default", {"kind": kind}, o, d)
    for kind, o, d in (("sphere", [0, 1.01, 3], down), ("disk", [1.01, 0, 3], down), ("annulus", [0, 0.49, 3], down), ("cube", [0.51, 0.49, 3], down), ("triangle", [-0.01, 0.98, 3], down),
                       ("tube", [3, 0, 1.01], [-1, 0, 0]), ("cylinder", [3, 0, -0.01], [-1, 0, 0]), ("cone", [3, 0, 1.01], [-1, 0, 0]), ("lens", [1.01, 0, 3], down), ("torus", [1.21, 0.01, 3], down)):
        one(MEETS[kind].split()[0] + " hit.none", "Just outside the default size", "wrong-default", {"kind": kind}, o, d, None)
    plane = {"kind": "plane"}
    one("hit.smallest-parameter", "The parameter is 1e-8 exactly: no hit", "strict-comparison epsilon", plane, [1, 2, 1e-8], down, None)
    one("hit.smallest-parameter", "The parameter is one ulp above 1e-8: a hit", "strict-comparison epsilon", plane, [1, 2, next_up(1e-8)], down, (next_up(1e-8), z, [1, -2]), source=CLOSED)
    one("hit.smallest-parameter", "1e-9 is too small", "epsilon", plane, [1, 2, 1e-9], down, None)
    one("hit.smallest-parameter", "1e-7 is not too small", "epsilon", plane, [1, 2, 1e-7], down, (1e-7, z, [1, -2]))
    one("hit.smallest-parameter ray.direction", "The parameter is compared, not the distance: distance 1e-6, parameter 1e-9", "epsilon direction-normalized", plane, [1, 2, 1e-6], [0, 0, -1000], None)
    one("hit.smallest-parameter ray.direction", "The parameter is compared, not the distance: distance 2^-30, parameter 2^-10", "epsilon direction-normalized", plane, [1, 2, 2.0**-30], [0, 0, -(2.0**-20)], (2.0**-10, z, [1, -2]))
    one("hit.smallest-parameter", "On the plane: no hit", "self-hit", plane, [1, 2, 0], down, None)
    shapes = {"disk": {"kind": "disk", "ray": 4}, "annulus": {"kind": "annulus", "ray": 4}, "triangle": {"kind": "triangle", "point": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]]},
              "btriangle": {"kind": "btriangle", "point": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]]}}
    for kind, shape in shapes.items():
        one("hit.smallest-parameter", f"A {kind}: 1e-8 is no hit", "strict-comparison epsilon", shape, [1, 2, 1e-8], down, None)
        one("hit.smallest-parameter", f"A {kind}: 2^-26 is a hit", "epsilon", shape, [1, 2, 2.0**-26], down, compare=CLOSE)
    solid = {"sphere": {"kind": "sphere", "ray": 2}, "cube": {"kind": "cube", "size": 4}, "cylinder": {"kind": "cylinder", "point": [[0, 0, -2], [0, 0, 2]], "ray": 3}, "cone": {"kind": "cone", "point": [[0, 0, 2], [0, 0, -2]], "ray": 3},
             "lens": {"kind": "lens", "point": [[0, 0, -1.75], [0, 0, 1.75]], "ray": 1, "curvature": [2.125, 2.125]}, "torus": {"kind": "torus", "normal": [1, 0, 0], "major_radius": 1.5, "minor_radius": 0.5}}
    for kind, shape in solid.items():
        if kind == "lens":
            continue  # its face is not at a binary64 number
        start = [0, 0, 2]
        one("hit.smallest-parameter hit.first", f"On the surface of a {kind}, inwards: hit where the ray leaves, or comes to the surface again", "self-hit", shape,
            [0, 0, 2] if kind != "cone" else [0.5, 0, 2], down if kind != "torus" else [0.25, 0, -1], compare=LOOSE)
        one("hit.smallest-parameter hit.none", f"On the surface of a {kind}, outwards: no hit", "self-hit", shape, start, z, None)
        one("hit.smallest-parameter hit.first", f"Above the surface of a {kind} by 2^-20, inwards", "epsilon", shape, [0.5 if kind == "cone" else 0, 0, 2 + 2.0**-20], down, compare=LOOSE)
    tube = {"kind": "tube", "point": [[0, 0, -2], [0, 0, 2]], "ray": 3}
    one("hit.smallest-parameter hit.first", "On the wall of a tube, inwards", "self-hit", tube, [0, 3, 0], [0, -1, 0], compare=LOOSE)
    cap = {"kind": "spherical_cap", "ray": 3, "curvature": 5}
    one("hit.smallest-parameter hit.none", "On a cap: no hit", "self-hit", cap, [0, 0, 1], down, None)
    moved = {"kind": "geometry", "scale": [1000, 1000, 1000], "geometry": {"kind": "plane"}}
    one("hit.smallest-parameter .parameters", "In a frame a thousand times as large, a parameter of 1e-7 is a hit: the parameter counts, not the distance in the inner frame", "epsilon inner-distance", moved, [0, 0, 1e-7], down, (1e-7, z, [0, 0]),
        compare={"t": "rel:1e-14", "point": "abs:1e-20", "normal": "exact", "uv": "exact"})
    small = {"kind": "geometry", "scale": [0.001, 0.001, 0.001], "geometry": {"kind": "plane"}}
    one("hit.smallest-parameter .parameters", "In a frame a thousand times as small, a parameter of 5e-9 is none", "epsilon inner-distance", small, [0, 0, 5e-9], down, None)
    one("hit.finite", "A parameter that overflows is none", "overflow", {"kind": "plane"}, [0, 0, 1e100], [0, 0, -1e-300], None)
    one("hit.finite hit.none", "A sphere, seen from 1e100 beside it", "overflow nan", {"kind": "sphere"}, [1e100, 1, 0], [0, 1, 0], None)
    one("hit.finite hit.none", "A torus, from 1e100 beside it", "overflow nan", {"kind": "torus"}, [1e100, 1, 0], [0, 1, 0], None)
    one("hit.finite hit.none", "A cylinder, from 1e100 beside it", "overflow nan", {"kind": "cylinder"}, [1e100, 1, 0], [0, 1, 0.5], None)
    one("hit.finite hit.none", "A cone, from 1e100 beside it", "overflow nan", {"kind": "cone"}, [1e100, 1, 0], [0, 1, 0.5], None)
    one("hit.finite hit.none", "A lens, from 1e100 beside it", "overflow nan", {"kind": "lens"}, [1e100, 1, 0], [0, 1, 0.5], None)
    one("hit.finite hit.none", "A cap, from 1e100 beside it", "overflow nan", {"kind": "spherical_cap"}, [1e100, 1, 0], [0, 1, 0.5], None)
    one("hit.finite hit.none", "A cube, from 1e100 beside it", "overflow nan", {"kind": "cube"}, [1e100, 1, 0], [0, 1, 0.5], None)


def planar():
    down, z = [0, 0, -1], [0, 0, 1]
    for n, flag in (([1, 0, 0], "x"), ([-1, 0, 0], "x"), ([0, 1, 0], "y"), ([0, -1, 0], "y"), ([0, 0, 1], "z"), ([0, 0, -1], "z")):
        one("uv.frame plane.uv", f"The frame of the normal {n}", "frame-axis frame-sign", {"kind": "plane", "normal": n, "position": [1, 2, 3]}, [4, 7, 11], [-x for x in n] if flag == "z" and n[2] > 0 else [a - 2 * b for a, b in zip([1 if x == 0 else 0 for x in n], [x if x > 0 else -x for x in n])])
    for n in ([1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 2, 2], [2, 1, 2], [2, 2, 1], [3, -2, 1], [-1, 3, 2], [2, 3, -1], [1, 1, 1], [-1, 1, -1], [0, -3, 4]):
        one("uv.frame plane.uv plane.unit-normal", f"The frame of the normal {n}: the axis of the smallest component, of equal ones the first", "frame-axis frame-tie normal-not-unit", {"kind": "plane", "normal": n}, [n[0] * 3 + 1, n[1] * 3 + 2, n[2] * 3 - 1], [-x for x in n], compare=CLOSE)
    one("plane.parallel", "In the plane: no hit", "in-plane", {"kind": "plane"}, [0, 0, 0], [1, 1, 0], None)
    one("plane.parallel", "Beside the plane: no hit", "division-by-zero", {"kind": "plane"}, [0, 0, 1], [1, 1, 0], None)
    one("plane.parallel", "A sine of 2^-50: no hit", "epsilon", {"kind": "plane"}, [0, 0, 1], [0, 1, -(2.0**-50)], None)
    one("plane.parallel", "A sine of 2^-49: a hit", "epsilon", {"kind": "plane"}, [0, 0, 1], [0, 1, -(2.0**-49)], (2.0**49, z, [0, -(2.0**49)]))
    one("plane.uv", "Texture coordinates below 0 and above 1 are not brought to the picture", "wrapped", {"kind": "plane"}, [-7.25, 3.5, 1], down, (1, z, [-7.25, -3.5]))
    disk = {"kind": "disk", "ray": 5, "position": [10, 20, 30]}
    one("disk.rim disk.parameters", "On the rim: 3, 4, 5", "strict-comparison", disk, [13, 24, 31], down, (1, z, [0.8, 0.09999999999999998]), compare="abs:1e-15")
    one("disk.rim", "On the rim along x", "strict-comparison", {"kind": "disk"}, [1, 0, 1], down, (1, z, [1, 0.5]))
    one("disk.rim", "Beyond the rim by one ulp: no hit", "epsilon", {"kind": "disk"}, [next_up(1.0), 0, 1], down, None)
    one("disk.rim", "Within the rim by one ulp", "epsilon", {"kind": "disk"}, [0, next_up(1.0, -1), 1], down, compare=CLOSE)
    one("disk.parameters", "In the square around the disk, outside of the disk", "square-for-disk", {"kind": "disk"}, [0.8, 0.8, 1], down, None)
    one("disk.parameters", "The distance is compared with the radius, not its square: radius 3", "radius-squared", {"kind": "disk", "ray": 3}, [2.5, 0, 1], down)
    one("disk.parameters", "The distance is compared with the radius, not its square: radius 3, at 4", "radius-squared", {"kind": "disk", "ray": 3}, [4, 0, 1], down, None)
    one("disk.parameters", "A radius below 1, at 0.4", "radius-squared", {"kind": "disk", "ray": 0.5}, [0.4375, 0, 1], down)
    one("disk.edge-on", "Edge on: no hit", "in-plane", {"kind": "disk"}, [-3, 0, 0], [1, 0, 0], None)
    one("disk.edge-on", "Edge on, from within: no hit", "in-plane", {"kind": "disk"}, [0, 0, 0], [0, 1, 0], None)
    one("disk.edge-on", "Edge on, an oblique disk: no hit", "in-plane", {"kind": "disk", "normal": [0, 0, -5], "position": [1, 1, 1]}, [-3, 1, 1], [1, 0, 0], None)
    for at, uv in (([2, 0], [1, 0.5]), ([-2, 0], [0, 0.5]), ([0, 2], [0.5, 0]), ([0, -2], [0.5, 1]), ([0, 0], [0.5, 0.5])):
        one("disk.uv disk.rim", "The rim touches the picture's borders", "uv-sign uv-scale", {"kind": "disk", "ray": 2}, [*at, 1], down, (1, z, uv))
    ring = {"kind": "annulus", "ray": 10, "inner_ray": 5}
    one("annulus.rims annulus.parameters", "On the outer rim: 6, 8, 10", "strict-comparison", ring, [6, -8, 1], down, (1, z, [0.8, 0.9]), compare="abs:1e-15")
    one("annulus.rims annulus.parameters", "On the inner rim: 3, 4, 5", "strict-comparison", ring, [3, 4, 1], down, (1, z, [0.65, 0.3]), compare="abs:1e-15")
    one("annulus.rims", "One ulp within the inner rim: no hit", "epsilon", ring, [next_up(5.0, -1), 0, 1], down, None)
    one("annulus.rims", "One ulp beyond the outer rim: no hit", "epsilon", ring, [0, next_up(10.0), 1], down, None)
    one("annulus.rims", "With equal radii a circle: on it", "empty-circle", {"kind": "annulus", "ray": 5, "inner_ray": 5}, [3, 4, 1], down, (1, z, [0.8, 0.1]), compare="abs:1e-15")
    one("annulus.rims", "With equal radii a circle: beside it", "empty-circle", {"kind": "annulus", "ray": 5, "inner_ray": 5}, [3, 3, 1], down, None)
    one("annulus.rims", "An inner radius of 0: the centre belongs to it", "strict-comparison", {"kind": "annulus", "ray": 5, "inner_ray": 0}, [0, 0, 1], down, (1, z, [0.5, 0.5]))
    one("annulus.parameters hit.none", "Through the hole", "hole", ring, [1, 1, 1], down, None)
    one("annulus.parameters disk.uv", "Texture coordinates are measured by the outer radius", "uv-scale", ring, [0, 7.5, 1], down, (1, z, [0.5, 0.125]))
    one("annulus.parameters", "In the square around the inner circle", "square-for-disk", {"kind": "annulus", "ray": 2, "inner_ray": 1}, [0.9, 0.9, 1], down, compare=CLOSE)


def spheres():
    ball = {"kind": "sphere"}
    for d, uv in (([1, 0, 0], [0.5, 0.5]), ([0, 0, 1], [0.75, 0.5]), ([0, 0, -1], [0.25, 0.5]), ([0, 1, 0], [0.5, 0]), ([0, -1, 0], [0.5, 1])):
        one("sphere.uv sphere.normal", f"From the centre in the direction {d}", "uv-axis", {"kind": "sphere", "ray": 4}, [0, 0, 0], d, (4, d, uv), compare="ulp:4")
    for d in ([1, 0, 1], [-1, 0, 1], [-1, 0, -1], [1, 0, -1], [1, 1, 0], [1, -1, 1], [3, 4, 12], [-2, 2, -1]):
        one("sphere.uv sphere.normal", f"From the centre in the direction {d}", "uv-axis uv-sign", {"kind": "sphere", "ray": 3, "position": [1, 2, 3]}, [1, 2, 3], d, compare=CLOSE)
    one("sphere.tangent", "A tangent is a hit", "double-root", ball, [-3, 0, 1], [1, 0, 0], (3, [0, 0, 1], [0.75, 0.5]), compare="ulp:4")
    one("sphere.tangent", "A tangent of 3, 4, 5", "double-root", {"kind": "sphere", "ray": 5}, [7, 1, 0], [-4, 3, 0], (1, [0.6, 0.8, 0], [0.5, math.atan2(0.6, 0.8) / math.pi]), compare="ulp:4")
    one("sphere.tangent hit.none", "One ulp beside a tangent", "epsilon", ball, [-1, next_up(1.0), 0], [1, 0, 0], None)
    one("sphere.tangent", "One ulp within a tangent", "epsilon", ball, [-1, 0, next_up(1.0, -1)], [1, 0, 0], compare={"t": "abs:1e-7", "point": "abs:1e-7", "normal": "abs:1e-7", "uv": "abs:1e-7"})
    one("sphere.normal hit.normal", "A small sphere: the normal is unit", "normal-not-unit", {"kind": "sphere", "ray": 0.001}, [0.0003, 0.0004, 1], [0, 0, -1], compare={"t": "rel:1e-12", "point": "abs:1e-13", "normal": "abs:1e-9", "uv": "abs:1e-9"})
    one("sphere.normal hit.normal", "A large sphere: the normal is unit", "normal-not-unit", {"kind": "sphere", "ray": 1000}, [300, 400, 5000], [0, 0, -1], compare={"t": "abs:1e-11", "point": "abs:1e-11", "normal": "abs:1e-13", "uv": "abs:1e-13"})


def cubes():
    box = {"kind": "cube", "size": 2}
    for o, d in (([0, 0, 5], [0, 0, -1]), ([0, 0, -5], [0, 0, 1]), ([0, 5, 0], [0, -1, 0]), ([0, -5, 0], [0, 1, 0]), ([5, 0, 0], [-1, 0, 0]), ([-5, 0, 0], [1, 0, 0])):
        one("cube.slabs cube.normal cube.uv", f"From {o} on the middle of a face", "wrong-face", box, o, d)
        one("cube.slabs cube.normal hit.first", f"From the middle in the direction {d}, leaving", "wrong-face", box, [0, 0, 0], [2 * x for x in d])
    for at, d in (([0.5, 0.25, 5], [0, 0, -1]), ([0.5, 0.25, -5], [0, 0, 1]), ([0.5, 5, 0.25], [0, -1, 0]), ([0.5, -5, 0.25], [0, 1, 0]), ([5, 0.5, 0.25], [-1, 0, 0]), ([-5, 0.5, 0.25], [1, 0, 0])):
        one("cube.uv cube.normal", "Texture coordinates of each face", "uv-axis uv-sign uv-scale", {"kind": "cube", "size": 4, "position": [0, 0, 0]}, at, d)
    n = {"+z": [0, 0, 1], "-z": [0, 0, -1], "+y": [0, 1, 0], "-y": [0, -1, 0], "+x": [1, 0, 0], "-x": [-1, 0, 0]}
    # On each of the twelve edges a ray that comes in, and the face that is first in the order.
    for sx, sy, sz in ((1, 1, 0), (1, -1, 0), (-1, 1, 0), (-1, -1, 0), (1, 0, 1), (1, 0, -1), (-1, 0, 1), (-1, 0, -1), (0, 1, 1), (0, 1, -1), (0, -1, 1), (0, -1, -1)):
        face = ("+z" if sz > 0 else "-z") if sz else ("+y" if sy > 0 else "-y")
        o = [3 * sx or 0.25, 3 * sy or 0.25, 3 * sz or 0.25]
        d = [-sx, -sy, -sz]
        point = [x + 2 * y for x, y in zip(o, d)]
        if n[face][2]:
            uv = [0.5 + point[0] / 2, 0.5 - n[face][2] * point[1] / 2]
        else:
            uv = [0.5 + point[0] / 2, 0.5 + n[face][1] * point[2] / 2]
        one("cube.edges cube.normal", f"On an edge, from outside: the face {face} is first in the order", "edge-order", box, o, d, (2.0, n[face], uv))
    for s in ((1, 1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, 1)):
        face = "+z" if s[2] > 0 else "-z"
        one("cube.edges cube.normal", "On a corner: the z face is first", "edge-order", box, [3 * x for x in s], [-x for x in s], (2.0, n[face], [0.5 + s[0] / 2, 0.5 - n[face][2] * s[1] / 2]))
    one("cube.edges cube.normal", "Out at an edge, from inside", "edge-order", box, [0, 0.5, 0], [0.5, 0.25, 0], (2.0, n["+y"], [1, 0.5]))
    for o, d, face in (([-3, 0.5, -1], [1, 0, 1], "+z"), ([-3, 1, -0.5], [1, 0, 0], "-x"), ([0.5, 3, 1], [0, -1, 0], "+y")):
        one("cube.edges cube.along-slab", "Touches an edge, or lies in a face, and is hit", "strict-comparison", box, o, d)
    one("cube.edges hit.none", "Past an edge by one ulp", "epsilon", box, [next_up(-3.0), 0, next_up(-1.0, -1) + 2.0**-51 + 2.0**-50 + 2.0**-49], [1, 0, 1], None)
    for i, name in enumerate("xyz"):
        for side in (1, -1):
            o, d = [0.5, 0.25, 0.125], [0, 0, 0]
            o[i], o[(i + 1) % 3], d[(i + 1) % 3] = side, -3, 1
            one("cube.along-slab", f"In the face {'+' if side > 0 else '-'}{name}: hit where the ray comes in", "in-plane nan", box, o, d)
            o = list(o)
            o[i] = side * next_up(1.0)
            one("cube.along-slab hit.none", f"Beside the face {'+' if side > 0 else '-'}{name} by one ulp", "epsilon", box, o, d, None)
    one("cube.along-slab", "Along an edge, in two faces", "in-plane nan", box, [-3, 1, 1], [1, 0, 0], (2.0, n["-x"], [1, 1]), compare=None)
    one("cube.slabs hit.none", "Each slab is crossed, never all at once", "interval", box, [-4, 0, 0], [1, 1, 0], None)
    one("cube.slabs", "A size of 1 by default: half of it is 1/2", "half-size", {"kind": "cube", "position": [1, 1, 1]}, [1.25, 1.125, 4], [0, 0, -1])
    one("cube.slabs", "A direction with all components negative", "swapped-slab", box, [4, 3, 5], [-2, -1.5, -2.25], compare=CLOSE)
    one("cube.slabs", "From inside, with all components negative", "swapped-slab", box, [0.5, 0.5, 0.5], [-1, -0.5, -0.25])


def triangles():
    flat = [[0, 0, 0], [4, 0, 0], [0, 4, 0]]
    t, z, down = {"kind": "triangle", "point": flat}, [0, 0, 1], [0, 0, -1]
    for at, uv, what in (([2, 0], [0.5, 0], "first edge"), ([2, 2], [0.5, 0.5], "second edge"), ([0, 2], [0, 0.5], "third edge"), ([0, 0], [0, 0], "first corner"), ([4, 0], [1, 0], "second corner"), ([0, 4], [0, 1], "third corner")):
        one("triangle.edges triangle.parameters", f"On the {what}", "strict-comparison", t, [*at, 3], down, (3.0, z, uv))
        one("triangle.edges triangle.both-sides", f"On the {what}, from behind", "strict-comparison one-sided", t, [*at, -3], [0, 0, 1], (3.0, z, uv))
    for at, what in (([2, -(2.0**-50)], "first edge"), ([2, 2 + 2.0**-50], "second edge"), ([-(2.0**-50), 2], "third edge")):
        one("triangle.edges hit.none", f"Beside the {what} by very little", "epsilon", t, [*at, 3], down, None)
    for corners, o, d in (([[0, 0, 0], [0, 4, 0], [0, 0, 4]], [3, 1, 2], [-1, 0, 0]), ([[0, 0, 0], [0, 0, 4], [4, 0, 0]], [1, 3, 2], [0, -1, 0]), ([[0, 0, 0], [0, 4, 0], [4, 0, 0]], [1, 2, 3], down)):
        one("triangle.normal triangle.edges", "Another plane, another axis along the ray", "swapped-coordinate orientation", {"kind": "triangle", "point": corners}, o, d)
        one("triangle.both-sides triangle.normal", "The same from behind: the same normal", "normal-turned one-sided", {"kind": "triangle", "point": corners}, [x + 6 * y for x, y in zip(o, d)], [-x for x in d])
    one("triangle.normal triangle.both-sides", "Corners the other way round: the opposite normal", "orientation", {"kind": "triangle", "point": [flat[0], flat[2], flat[1]]}, [1, 2, 3], down, (3.0, [0, 0, -1], [0.5, 0.25]))
    one("triangle.edge-on", "In the plane: no hit", "in-plane", t, [-1, 1, 0], [1, 0, 0], None)
    one("triangle.edge-on", "Along an edge: no hit", "in-plane", t, [-1, 0, 0], [1, 0, 0], None)
    one("triangle.edge-on", "In the plane of an oblique triangle: no hit", "in-plane", {"kind": "triangle", "point": [[0, 0, 4], [4, 0, 0], [0, 4, 0]]}, [-4, 4, 4], [1, 0, -1], None)
    one("triangle.edge-on plane.parallel", "A sine of 2^-50: no hit", "epsilon", {"kind": "triangle", "point": [[-1e20, -1e20, 0], [1e20, -1e20, 0], [0, 1e20, 0]]}, [0, 0, 1], [1, 0, -(2.0**-50)], None)
    one("triangle.collinear triangle.parameters", "A tiny triangle is hit", "epsilon", {"kind": "triangle", "point": [[0, 0, 0], [1e-12, 0, 0], [0, 1e-12, 0]]}, [2.5e-13, 5e-13, 1], down, compare=CLOSE)
    one("triangle.collinear triangle.parameters", "A triangle of 1e-100 is hit", "epsilon underflow", {"kind": "triangle", "point": [[0, 0, 0], [1e-60, 0, 0], [0, 1e-60, 0]]}, [0, 0, 1], down, (1.0, z, [0, 0]))
    one("triangle.collinear triangle.parameters", "A needle with an angle of 2^-20 is hit", "epsilon", {"kind": "triangle", "point": [[0, 0, 0], [1, 0, 0], [1, 2.0**-20, 0]]}, [0.75, 2.0**-22, 1], down, compare=CLOSE)
    # The denominator of the barycentric coordinates, in the order that is usual, is 0 in binary64 here.
    needle = {"t": "abs:1e-14", "point": "abs:1e-14", "normal": "abs:1e-14", "uv": "abs:1e-13"}
    for power in (40, 49):
        one("triangle.collinear hit.finite", f"A needle with an angle of 2^-{power} is hit, and has its texture coordinates", "epsilon nan",
            {"kind": "triangle", "point": [[0, 0, 0], [1, 0, 0], [1, 2.0**-power, 0]]}, [0.75, 2.0 ** -(power + 2), 1], down, compare=needle)
    one("triangle.edges", "Of equal components the last is the largest: z", "axis-choice", t, [-2, -2, 3], [1, 1, -1], compare=CLOSE)
    one("triangle.edges", "Of equal components the last is the largest: y", "axis-choice", {"kind": "triangle", "point": [[0, 0, 0], [0, 0, 4], [4, 0, 0]]}, [-2, 3, 1], [1, -1, 0], compare=CLOSE)
    one("triangle.watertight triangle.edges", "The left of two neighbours, on their common edge", "leak", {"kind": "triangle", "point": [[0, 0, 0], [1, 3, 0], [-3, 1, 0]]}, [0.25, 0.75, 1], down, compare=CLOSE)
    one("triangle.watertight triangle.edges", "The right of two neighbours, on their common edge", "leak", {"kind": "triangle", "point": [[0, 0, 0], [3, 1, 0], [1, 3, 0]]}, [0.25, 0.75, 1], down, compare=CLOSE)
    b = {"kind": "btriangle", "point": flat}
    one("smooth-triangle.flat-corner", "Without normals the normal is the flat one", "flat-default", b, [1, 2, 3], down, (3.0, z, [0, 0]))
    one("smooth-triangle.flat-corner", "Without normals, from behind: the flat one", "normal-turned", b, [1, 2, -3], z, (3.0, z, [0, 0]))
    one("smooth-triangle.flat-corner smooth-triangle.normal", "Two corners without normals, at the first", "flat-default", {**b, "normal": [[1, 0, 0]]}, [0, 0, 3], down, (3.0, [1, 0, 0], [0, 0]))
    one("smooth-triangle.flat-corner smooth-triangle.normal", "Two corners without normals, at the second", "flat-default", {**b, "normal": [[1, 0, 0]]}, [4, 0, 3], down, (3.0, z, [0, 0]))
    one("smooth-triangle.flat-corner smooth-triangle.normal", "One corner without a normal, at the third", "flat-default", {**b, "normal": [[1, 0, 0], [0, 1, 0]]}, [0, 4, 3], down, (3.0, z, [0, 0]))
    corners = {**b, "normal": [[2, 0, 0], [0, 0.5, 0], [0, 0, 30]]}
    for at, n in (([0, 0], [1, 0, 0]), ([4, 0], [0, 1, 0]), ([0, 4], [0, 0, 1])):
        one("smooth-triangle.normal", "At a corner its own normal, unit", "swapped normal-not-unit", corners, [*at, 3], down, (3.0, n, [0, 0]))
    one("smooth-triangle.normal", "In the middle all three count alike, each made unit first", "normal-not-unit weights", {**corners, "point": [[0, 0, 0], [3, 0, 0], [0, 3, 0]]}, [1, 1, 3], down, compare=CLOSE)
    one("smooth-triangle.normal", "Weights 1/4, 1/4, 1/2", "weights swapped", corners, [1, 2, 3], down, compare=CLOSE)
    one("smooth-triangle.normal", "The normal may be on the other side of the triangle", "normal-turned", {**b, "normal": [[0, 0, -1], [0, 0, -1], [0, 0, -1]]}, [1, 2, 3], down, (3.0, [0, 0, -1], [0, 0]))
    one("smooth-triangle.vanishing", "The mixed normal vanishes on an edge: the flat one", "nan normal-not-unit", {**b, "normal": [[1, 0, 0], [-1, 0, 0], [0, 0, 1]]}, [2, 0, 3], down, (3.0, z, [0, 0]))
    one("smooth-triangle.vanishing", "Vanishing on another edge", "nan", {**b, "normal": [[1, 0, 0], [0, 3, 0], [0, -2, 0]]}, [2, 2, 3], down, (3.0, z, [0, 0]))
    one("smooth-triangle.vanishing", "Vanishing, from behind: the flat one is not turned either", "nan normal-turned", {**b, "normal": [[1, 0, 0], [0, 3, 0], [-1, 0, 0]]}, [0, 2, -3], z, (3.0, z, [0, 0]))
    coordinates = {**b, "uv": [[1, 2], [5, -2], [-3, 10]]}
    for at, uv in (([0, 0], [1, 2]), ([4, 0], [5, -2]), ([0, 4], [-3, 10]), ([1, 2], [0, 5]), ([2, 1], [2, 2])):
        one("smooth-triangle.uv", "Texture coordinates are interpolated", "swapped weights", coordinates, [*at, 3], down, (3.0, z, uv))
    one("smooth-triangle.uv", "A corner without coordinates has (0, 0)", "uv-default", {**b, "uv": [[8, 4]]}, [1, 2, 3], down, (3.0, z, [2, 1]))
    one("smooth-triangle.parameters", "On an edge, met like the flat triangle", "strict-comparison", b, [2, 2, 3], down, (3.0, z, [0, 0]))
    one("smooth-triangle.parameters hit.none", "Beside an edge", "epsilon", b, [2, 2 + 2.0**-50, 3], down, None)
    one("smooth-triangle.parameters hit.none", "In the plane: no hit", "in-plane", b, [-1, 1, 0], [1, 0, 0], None)


def tubes():
    x, z = [1, 0, 0], [0, 0, 1]
    t = {"kind": "tube", "point": [[0, 0, 0], [0, 0, 4]], "ray": 1}
    c = {"kind": "cylinder", "point": [[0, 0, 0], [0, 0, 4]], "ray": 1}
    left = [-1, 0, 0]
    for shape, name in ((t, "tube.ends"), (c, "cylinder.interval")):
        one(name, "At the height 0: hit", "strict-comparison", shape, [3, 0, 0], left, (2.0, x, [0.5, 1]), compare="abs:1e-14")
        one(name, "At the height H: hit", "strict-comparison", shape, [3, 0, 4], left, (2.0, x, [0.5, 0]), compare="abs:1e-14")
        one(name + " hit.none", "One ulp below the height 0", "epsilon", shape, [3, 0, -5e-324], left, None)
        one(name + " hit.none", "One ulp above the height H", "epsilon", shape, [3, 0, next_up(4.0)], left, None)
        one(name, "A tangent is a hit", "double-root", shape, [3, 1, 2], left, (3.0, [0, 1, 0], [0.75, 0.5]), compare="abs:1e-14")
        one(name + " hit.none", "One ulp beside a tangent", "epsilon", shape, [1, next_up(1.0), 2], left, None)
        for at, u in (([0, 1], 0.75), ([0, -1], 0.25), ([1, 0], 0.5)):
            one("tube.uv" + (" cylinder.uv" if shape is c else " tube.normal"), "Around the axis", "uv-axis uv-sign", shape, [0, 0, 1], [*at, 0], (1.0, [*at, 0], [u, 0.75]), compare="abs:1e-14")
    one("tube.ends", "Through the open end on the wall from inside: the normal is outward", "normal-turned end-closed", t, [0.5, 0, 5.5], [0.25, 0, -1], (2.0, x, [0.5, 0.125]), compare="abs:1e-14")
    one("tube.ends hit.none", "Through both open ends", "end-closed", t, [0.5, 0, 9], [0, 0, -1], None)
    one("tube.ends", "The near wall is missed, above the end; the far wall is hit", "first-only", t, [2, 0, 5.5], [-1, 0, -1], (3.0, left, [0, 0.375]), compare={"t": "abs:1e-14", "point": "abs:1e-14", "normal": "abs:1e-14", "uv": "abs:1"})
    one("tube.along-axis hit.none", "Along the axis in the wall: no hit", "degenerate", t, [1, 0, -3], z, None)
    one("tube.along-axis hit.none", "Along the axis within: no hit", "degenerate", t, [0.5, 0, -3], z, None)
    one("tube.normal", "The origin of the normal is on the axis, not the first point", "normal-not-across", {"kind": "tube", "point": [[1, 2, 3], [1, 2, 13]], "ray": 5}, [4, 6, 9], [3, 4, 0], None)
    one("tube.normal", "3, 4, 5 around an axis that is not at the origin", "normal-not-across", {"kind": "tube", "point": [[1, 2, 3], [1, 2, 13]], "ray": 5}, [1, 2, 9], [0.75, 1, 0], (4.0, [0.6, 0.8, 0], [0.5 + math.atan2(0.8, 0.6) / math.tau, 0.4]), compare="abs:1e-14")
    one("tube.uv tube.normal", "The axis along x", "uv-axis", {"kind": "tube", "point": [[0, 0, 0], [4, 0, 0]], "ray": 1}, [1, 0, 0], [0, 1, 0], (1.0, [0, 1, 0], [0.5, 0.75]), compare="abs:1e-14")
    one("tube.uv tube.normal", "The axis along x, towards z", "uv-axis", {"kind": "tube", "point": [[0, 0, 0], [4, 0, 0]], "ray": 1}, [1, 0, 0], [0, 0, 1], (1.0, [0, 0, 1], [0.75, 0.75]), compare="abs:1e-14")
    one("tube.uv tube.normal", "The axis against z: e2 turns round", "uv-sign", {"kind": "tube", "point": [[0, 0, 4], [0, 0, 0]], "ray": 1}, [0, 0, 1], [0, 1, 0], (1.0, [0, 1, 0], [0.25, 0.25]), compare="abs:1e-14")
    down = [0, 0, -1]
    one("cylinder.interval cylinder.normal", "On the upper end", "end-missing", c, [0.5, 0, 6], down, (2.0, z, [0.75, 0.5]))
    one("cylinder.interval cylinder.normal", "On the lower end", "end-missing end-normal", c, [0.5, 0, -2], z, (2.0, down, [0.75, 0.5]))
    one("cylinder.interval cylinder.normal", "From inside on the upper end", "end-normal", c, [0, 0.25, 1], z, (3.0, z, [0.5, 0.375]))
    one("cylinder.interval cylinder.normal", "From inside on the lower end", "end-normal", c, [0, 0.25, 1], down, (1.0, down, [0.5, 0.625]))
    one("cylinder.interval cylinder.normal", "In through the upper end, slanted", "interval", c, [-1, 0, 6], [0.25, 0, -1], (2.0, z, [0.25, 0.5]), compare="abs:1e-14")
    one("cylinder.interval hit.none", "The bar and the slab are crossed one after the other", "interval", c, [-3, 0, 6], [1, 0, 0.5], None)
    one("cylinder.interval hit.none", "Beside the end, along the axis", "end-too-large", c, [1.25, 0, 6], down, None)
    one("cylinder.along-axis", "Along the axis in the wall: the ends are hit", "degenerate strict-comparison", c, [1, 0, 6], down, (2.0, z, [1, 0.5]))
    one("cylinder.along-axis", "Along the axis in the wall, from below", "degenerate strict-comparison", c, [0, -1, -2], z, (2.0, down, [0.5, 0]))
    one("cylinder.along-axis hit.none", "Along the axis, one ulp outside of the wall", "epsilon", c, [next_up(1.0), 0, 6], down, None)
    one("cylinder.along-axis", "In the plane of the upper end: the wall is hit", "degenerate strict-comparison", c, [0, 3, 4], [0, -1, 0], (2.0, [0, 1, 0], [0.75, 0]), compare="abs:1e-14")
    one("cylinder.along-axis", "In the plane of the lower end: the wall is hit", "degenerate strict-comparison", c, [0, 3, 0], [0, -1, 0], (2.0, [0, 1, 0], [0.75, 1]), compare="abs:1e-14")
    one("cylinder.along-axis hit.none", "Across the axis, one ulp above the upper end", "epsilon", c, [0, 3, next_up(4.0)], [0, -1, 0], None)
    one("cylinder.normal", "On the upper rim: the wall's normal", "edge-order", c, [3, 0, 6], [-1, 0, -1], (2.0, x, [0.5, 0]), compare="abs:1e-14")
    one("cylinder.normal", "On the lower rim: the wall's normal", "edge-order", c, [0, 3, -2], [0, -1, 1], (2.0, [0, 1, 0], [0.75, 1]), compare="abs:1e-14")
    one("cylinder.uv disk.uv", "Texture coordinates of the upper end", "uv-axis uv-sign", c, [0.25, 0.5, 6], down, (2.0, z, [0.625, 0.25]))
    one("cylinder.uv disk.uv", "Texture coordinates of the lower end: its own normal", "uv-axis uv-sign", c, [0.25, 0.5, -2], z, (2.0, down, [0.625, 0.75]))
    one("cylinder.uv disk.uv", "The ends of a cylinder of radius 4", "uv-scale", {**c, "ray": 4}, [2, 1, 6], down, (2.0, z, [0.75, 0.375]))


def cones():
    z, down, left = [0, 0, 1], [0, 0, -1], [-1, 0, 0]
    c = {"kind": "cone", "point": [[0, 0, 0], [0, 0, 4]], "ray": 3}
    one("cone.apex cone.uv", "On the apex along the axis: the normal is the axis", "apex nan", c, [0, 0, 9], down, (5.0, z, [0.5, 0]), compare="abs:1e-12")
    one("cone.apex", "On the apex, across the axis", "apex nan", c, [3, 0, 4], left, (3.0, z, [0.5, 0]), compare={"t": "abs:1e-12", "point": "abs:1e-12", "normal": "abs:1e-12", "uv": "abs:1e-12"})
    one("cone.apex", "On the apex of another cone, slanted", "apex nan", {"kind": "cone", "point": [[0, 0, 0], [0, 0, 1]], "ray": 1}, [0, 2, 3], [0, -1, -1], (2.0, z, [0.5, 0]), compare="abs:1e-12")
    one("cone.beyond-apex hit.none", "The cone beyond the apex is not there", "double-cone", c, [9, 0, 5], left, None)
    one("cone.beyond-apex hit.none", "Through the cone beyond the apex, along its surface", "double-cone", c, [0, 0.5, 9], [0, 1, -0.25], None)
    one("cone.beyond-apex", "From within the cone beyond the apex onto the real one", "double-cone", c, [0.25, 0, 8], [0, 0, -1], compare=LOOSE)
    one("cone.interval", "On the base, from below", "base-missing", c, [1, 0.5, -2], z, (2.0, down, [0.5 + 1 / 6, 0.5 + 0.5 / 6]), compare="abs:1e-14")
    one("cone.interval cone.normal", "From inside on the base: the normal is outward", "normal-turned", c, [0, 0, 1], down, (1.0, down, [0.5, 0.5]), compare="abs:1e-14")
    one("cone.interval cone.normal", "From inside on the side", "normal-turned", c, [0, 0, 2], [0, -1, 0], (1.5, [0, -0.8, 0.6], [0.25, 0.5]), compare="abs:1e-13")
    one("cone.interval cone.normal", "The side, from outside", "normal-slope", c, [9, 0, 2], left, (7.5, [0.8, 0, 0.6], [0.5, 0.5]), compare="abs:1e-13")
    one("cone.interval", "In through the side, steeper than it", "sign-of-a", c, [1.5, 0, 9], down, (7.0, [0.8, 0, 0.6], [0.5, 0.5]), compare="abs:1e-13")
    one("cone.interval", "Up through the base and out at the side, from inside", "sign-of-a", c, [1.5, 0, 1], z, (1.0, [0.8, 0, 0.6], [0.5, 0.5]), compare="abs:1e-13")
    one("cone.interval hit.none", "Below the base", "unbounded", c, [9, 0, -0.25], left, None)
    one("cone.interval hit.none", "Beside the base, along the axis", "base-too-large", c, [3.25, 0, -2], z, None)
    one("cone.interval", "Parallel to the side, through the base", "parallel", c, [-8, 0, -8], [3, 0, 4], compare=LOOSE)
    one("cone.interval", "Parallel to the side, from above: in through the side, opposite", "parallel", c, [7, 0, 12], [-3, 0, -4], compare=LOOSE)
    one("cone.interval", "Parallel to the side, from inside: out through the side", "parallel", c, [-1.25, 0, 1], [3, 0, 4], compare=LOOSE)
    one("cone.interval hit.none", "Parallel to the side, beside it", "parallel", c, [-10, 0, -8], [3, 0, 4], None)
    tall = {"kind": "cone", "point": [[0, 0, 0], [0, 0, 2]], "ray": 1}
    slope = [0, 2 / math.sqrt(5), 1 / math.sqrt(5)]
    one("cone.normal", "On the rim of the base, slanted: the side's normal", "edge-order", tall, [0, 3, -2], [0, -1, 1], (2.0, slope, [0.75, 1]), compare="abs:1e-13")
    one("cone.normal", "On the rim of the base, from inside: the side's normal", "edge-order", tall, [0, 0, 1], [0, 1, -1], (1.0, slope, [0.75, 1]), compare="abs:1e-13")
    one("cone.normal", "On the rim of the base: the side's normal", "edge-order", c, [0, 9, 0], [0, -1, 0], (6.0, [0, 0.8, 0.6], [0.75, 1]), compare="abs:1e-13")
    one("cone.normal", "A flat cone: radius 4, height 3", "normal-slope", {"kind": "cone", "point": [[0, 0, 0], [0, 0, 3]], "ray": 4}, [2, 0, 9], down, (7.5, [0.6, 0, 0.8], [0.5, 0.5]), compare="abs:1e-13")
    one("cone.normal", "The apex below", "normal-slope sign", {"kind": "cone", "point": [[0, 0, 4], [0, 0, 0]], "ray": 3}, [9, 0, 2], left, (7.5, [0.8, 0, -0.6], [0.5, 0.5]), compare="abs:1e-13")
    for o, d, u in (([0, 9, 2], [0, -1, 0], 0.75), ([0, -9, 2], [0, 1, 0], 0.25), ([9, 0, 2], left, 0.5)):
        one("cone.uv", "Texture coordinates around the side", "uv-axis uv-sign", c, o, d, (7.5, [0.8 * -d[0], 0.8 * -d[1], 0.6], [u, 0.5]), compare="abs:1e-13")
    one("cone.uv disk.uv", "Texture coordinates of the base", "uv-axis uv-sign", {"kind": "cone", "point": [[0, 0, 0], [0, 0, 4]], "ray": 4}, [1, 2, -2], z, (2.0, down, [0.625, 0.75]), compare="abs:1e-14")
    one("cone.uv", "Near the base v is near 1", "uv-v", c, [0, 9, 1], [0, -1, 0], (6.75, [0, 0.8, 0.6], [0.75, 0.75]), compare="abs:1e-13")
    one("cone.interval", "From 1e6 away, aimed at the apex", "far-origin", c, [0, 0, 1000000], down, (999996.0, z, [0.5, 0]), compare={"t": "abs:1e-8", "point": "abs:1e-8", "normal": "abs:1e-8", "uv": "abs:1e-8"})
    one("cone.interval", "From 1e6 away, on the side", "far-origin", c, [1000000, 0, 2], left, (999998.5, [0.8, 0, 0.6], [0.5, 0.5]), compare="abs:1e-8")


def caps():
    z, down = [0, 0, 1], [0, 0, -1]
    cap = {"kind": "spherical_cap", "ray": 3, "curvature": 5}
    cup = {"kind": "spherical_cap", "ray": 3, "curvature": -5}
    for shape, top in ((cap, 1), (cup, -1)):
        what = "A bulging cap" if top > 0 else "A hollow cap"
        one("cap.surface cap.normal", f"{what}, from above on its middle", "curvature-sign", shape, [0, 0, 6], down, (6.0 - top, z, [0.5, 0.5]), compare="abs:1e-14")
        one("cap.surface cap.normal", f"{what}, from below on its middle: the same normal", "curvature-sign normal-turned", shape, [0, 0, -6], z, (6.0 + top, z, [0.5, 0.5]), compare="abs:1e-14")
        one("cap.open hit.none", f"{what}: beside the rim", "whole-sphere", shape, [3.25, 0, 6], down, None)
        one("cap.open hit.none", f"{what}: the rest of the sphere is not there", "whole-sphere", shape, [9, 0, -3 * top], [-1, 0, 0], None)
        one("cap.surface", f"{what}: across, both sides of the bulge", "first-only", shape, [9, 0, top / 2], [-1, 0, 0], compare=LOOSE)
        one("cap.surface", f"{what}: across, from within", "first-only", shape, [0, 0, top / 2], [0, 1, 0], compare=LOOSE)
        one("cap.surface cap.normal disk.uv", f"{what}: off its middle", "normal-slope uv-sign", shape, [1, 2, 6], down, compare=LOOSE)
    one("cap.open", "Through the open disk onto the inside of the bulge", "disk-closed", cap, [1, 0, -6], z, compare=LOOSE)
    half = {"kind": "spherical_cap", "ray": 2, "curvature": 2}
    one("cap.half", "Half a sphere, on its rim", "strict-comparison nan", half, [5, 0, 0], [-1, 0, 0], (3.0, [1, 0, 0], [1, 0.5]), compare="abs:1e-14")
    one("cap.half", "Half a sphere, on its rim along y", "strict-comparison nan", half, [0, -5, 0], [0, 1, 0], (3.0, [0, -1, 0], [0.5, 1]), compare="abs:1e-14")
    one("cap.half cap.surface", "Half a sphere, on its top", "nan", half, [0, 0, 5], down, (3.0, z, [0.5, 0.5]), compare="abs:1e-14")
    one("cap.half hit.none", "Half a sphere: the other half is not there", "whole-sphere", half, [5, 0, -0.5], [-1, 0, 0], None)
    one("cap.half", "Half a sphere, hollow", "curvature-sign", {"kind": "spherical_cap", "ray": 2, "curvature": -2}, [0, 0, 5], down, (7.0, z, [0.5, 0.5]), compare="abs:1e-14")
    one("cap.half", "Half a sphere with a normal along x", "normal-ignored", {"kind": "spherical_cap", "ray": 2, "curvature": 2, "normal": [3, 0, 0], "position": [1, 1, 1]}, [9, 1, 1], [-1, 0, 0], (6.0, [1, 0, 0], [0.5, 0.5]), compare="abs:1e-14")
    for c in (1e3, 1e6, -1e6, 1e9):
        m = math.copysign(1, c)
        top = m / (abs(c) + math.sqrt((abs(c) - 1) * (abs(c) + 1)))
        one("cap.parameters", f"A curvature of {c:g}: nearly flat", "cancellation", {"kind": "spherical_cap", "ray": 1, "curvature": c}, [0, 0, 1], down, (1.0 - top, z, [0.5, 0.5]), compare="abs:1e-14", source=CLOSED)
        one("cap.parameters hit.none", f"A curvature of {c:g}: beyond the rim", "cancellation", {"kind": "spherical_cap", "ray": 1, "curvature": c}, [1.01, 0, 1], down, None)
    one("cap.parameters", "From 1e6 away", "far-origin", cap, [0, 0, 1000000], down, (999999.0, z, [0.5, 0.5]), compare="abs:1e-8")
    one("cap.normal", "The normal of a long normal's cap is unit", "normal-not-unit", {**cap, "normal": [0, 0, 100], "ray": 4}, [3, 0, 6], down, (5.0, [0.6, 0, 0.8], [0.875, 0.5]), compare="abs:1e-14")


def lenses():
    z, down, left = [0, 0, 1], [0, 0, -1], [-1, 0, 0]
    thick, thin = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 2]], "ray": 3, "curvature": [5, 5]}, {"kind": "lens", "point": [[0, 0, 0], [0, 0, 4]], "ray": 3, "curvature": [-5, -5]}
    mixed, other = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 4]], "ray": 3, "curvature": [5, -5]}, {"kind": "lens", "point": [[0, 0, 0], [0, 0, 4]], "ray": 3, "curvature": [-5, 5]}
    for shape, low, high, what in ((thick, -1, 3, "both faces bulge"), (thin, 1, 3, "both faces are hollow"), (mixed, -1, 3, "the second is hollow"), (other, 1, 5, "the first is hollow")):
        one("lens.body lens.normal", f"On the first face, {what}", "curvature-sign curvature-swapped", shape, [0, 0, -9], z, (9.0 + low, down, [0.5, 0.5]), compare="abs:1e-13")
        one("lens.body lens.normal", f"On the second face, {what}", "curvature-sign curvature-swapped", shape, [0, 0, 9], down, (9.0 - high, z, [0.5, 0.5]), compare="abs:1e-13")
        one("lens.body lens.normal", f"From inside on the first face, {what}", "normal-turned", shape, [0, 0, 1.5], down, (1.5 - low, down, [0.5, 0.5]), compare="abs:1e-13")
        one("lens.body lens.normal", f"From inside on the second face, {what}", "normal-turned", shape, [0, 0, 1.5], z, (high - 1.5, z, [0.5, 0.5]), compare="abs:1e-13")
        one("lens.body lens.normal lens.uv", f"On the side, {what}", "side-missing", shape, [9, 0, 1], left, (6.0, [1, 0, 0], [0.5, 1 - 1 / (2 if shape is thick else 4)]), compare="abs:1e-13")
        one("lens.body lens.normal lens.uv", f"Off the middle, {what}", "normal-slope uv-sign", shape, [1, -2, 9], down, compare=LOOSE)
        one("lens.body lens.normal lens.uv", f"Off the middle, from below, {what}", "normal-slope uv-sign", shape, [-2, 1, -9], z, compare=LOOSE)
        one("lens.body hit.none", f"Beside the rim, along the axis, {what}", "rim", shape, [3.25, 0, 9], down, None)
    one("lens.body", "Across a bulge, above the rim", "bulge-missing", thick, [9, 0, 2.5], left, compare=LOOSE)
    one("lens.body hit.none", "Across, above the bulge", "whole-sphere", thick, [9, 0, 3.25], left, None)
    one("lens.body", "Across a hollow: the wall is hit first", "hollow-filled", thin, [9, 0, 3.5], left, (6.0, [1, 0, 0], [0.5, 0.125]), compare="abs:1e-13")
    one("lens.body", "From within a hollow, across: the hollow face is hit", "hollow-filled", thin, [0, 0, 3.5], [1, 0, 0], compare=LOOSE)
    one("lens.body", "From within a hollow, upwards and out: no hit", "hollow-filled", thin, [0, 0, 3.5], z, None)
    one("lens.body", "From the hollow of the first face", "intervals", thin, [0, 0, 0.5], [1, 0, 0], compare=LOOSE)
    one("lens.body", "From the wall's ring inwards, out into the hollow", "intervals", thin, [2.9375, 0, 3.5], left, compare=LOOSE)
    one("lens.rim", "On the rim: the side's normal", "edge-order", thick, [5, 0, 4], [-1, 0, -1], (2.0, [1, 0, 0], [0.5, 0]), compare="abs:1e-13")
    one("lens.rim", "On the rim of the first face: the side's normal", "edge-order", thick, [0, 4, -1], [0, -1, 1], (1.0, [0, 1, 0], [0.75, 1]), compare="abs:1e-13")
    one("lens.rim", "Along the axis in the side's surface: the faces are hit", "degenerate", thick, [0, 3, 9], down, (7.0, [0, 0.6, 0.8], [0.5, 0]), compare="abs:1e-13")
    one("lens.rim hit.none", "Along the axis, beside the side's surface by 1e-9", "epsilon", thick, [3.000000001, 0, 9], down, None)
    ball = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 2]], "ray": 2, "curvature": [2, 2]}
    one("lens.body lens.possible", "Curvatures equal to the radius: half spheres", "nan", ball, [0, 0, 9], down, (5.0, z, [0.5, 0.5]), compare="abs:1e-13")
    one("lens.body lens.possible", "Curvatures equal to the radius: the side between", "nan", ball, [9, 0, 1], left, (7.0, [1, 0, 0], [0.5, 0.5]), compare="abs:1e-13")
    one("lens.uv", "Texture coordinates of the first face: the normal is S there, too", "uv-sign", thick, [0, 2, -9], z, compare=LOOSE)
    one("lens.uv", "The side: v is 1 at the first point", "uv-v", thin, [9, 0, 0.5], left, (6.0, [1, 0, 0], [0.5, 0.875]), compare="abs:1e-13")
    one("lens.body", "The axis from above to below swaps the faces", "curvature-swapped", {**mixed, "point": [[0, 0, 4], [0, 0, 0]]}, [0, 0, 9], down, (4.0, z, [0.5, 0.5]), compare="abs:1e-13")
    one("lens.body", "From 1e6 away", "far-origin", thick, [0, 0, 1000000], down, (999997.0, z, [0.5, 0.5]), compare="abs:1e-8")
    one("lens.possible lens.body", "Hollow faces that leave 2^-10 between them", "epsilon", {"kind": "lens", "point": [[0, 0, 0], [0, 0, 2 + 2.0**-10]], "ray": 3, "curvature": [-5, -5]}, [0, 0, 9], down, (8 - 2.0**-10, z, [0.5, 0.5]), compare="abs:1e-13")


def tori():
    z, down, left = [0, 0, 1], [0, 0, -1], [-1, 0, 0]
    t = {"kind": "torus", "major_radius": 2, "minor_radius": 1}
    one("torus.equation torus.normal torus.uv", "On the outermost circle: v is 1/2", "uv-v", t, [9, 0, 0], left, (6.0, [1, 0, 0], [0.5, 0.5]), compare="abs:1e-11")
    one("torus.normal torus.uv", "On the top: v is 1/4", "uv-v uv-sign", t, [0, 2, 9], down, (8.0, z, [0.75, 0.25]), compare="abs:1e-11")
    one("torus.normal torus.uv", "On the bottom: v is 3/4", "uv-v uv-sign", t, [0, -2, -9], z, (8.0, down, [0.25, 0.75]), compare="abs:1e-11")
    one("torus.normal", "On the innermost circle from the middle: the normal is inward to the axis, out of the tube", "normal-sign", t, [0, 0, 0], [0, 1, 0], compare={"t": "abs:1e-11", "point": "abs:1e-11", "normal": "abs:1e-11", "uv": "abs:1"}, expected=(1.0, [0, -1, 0], [0.75, 0]))
    one("torus.normal", "From the circle, outwards", "normal-turned", t, [2, 0, 0], [1, 0, 0], (1.0, [1, 0, 0], [0.5, 0.5]), compare="abs:1e-11")
    one("torus.normal", "From the circle, upwards", "normal-turned", t, [0, 2, 0], z, (1.0, z, [0.75, 0.25]), compare="abs:1e-11")
    one("torus.equation", "Of four parameters the first above 0: from between the second and the third", "first", t, [0.5, 0.25, 0.125], left, compare=LOOSE)
    one("torus.equation hit.none", "Through the hole", "hole", t, [0, 0.5, 9], down, None)
    one("torus.precision", "A tangent above is a hit", "double-root", t, [9, 0, 1], left, (7.0, z, [0.5, 0.25]), compare="abs:1e-8")
    one("torus.precision", "A tangent beside is a hit", "double-root", t, [9, 3, 0], left, (9.0, [0, 1, 0], [0.75, 0.5]), compare="abs:1e-8")
    one("torus.precision hit.none", "Past the tangent by 1e-6", "epsilon", t, [9, 3.000001, 0], left, None)
    spindle = {"kind": "torus", "major_radius": 1, "minor_radius": 2}
    for o, d in (([0, 0, 5], down), ([0, 0, -5], z)):
        top = math.sqrt(3)
        one("torus.spindle torus.normal torus.precision", "A spindle along its axis, on its point: the normal is the axis, outward", "axis-normal nan", spindle, o, d,
            (5 - top, [-x for x in d], [0.5, 0.5 - math.atan2(-d[2] * top, -1) / math.tau]), compare="abs:1e-8", source=CLOSED)
    one("torus.spindle torus.normal", "A spindle, from outside", "inner-sheet", spindle, [9, 0, 0.5], left, compare=LOOSE)
    one("torus.spindle torus.normal", "The inner sheet of a spindle, from inside", "inner-sheet normal-sign", spindle, [0, 0.125, 0.5], [0, 1, 0.25], compare=LOOSE)
    one("torus.spindle torus.normal", "The inner sheet of a spindle, from between the sheets", "inner-sheet normal-sign", spindle, [2, 0, 0.25], left, compare=LOOSE)
    one("torus.spindle torus.normal", "The inner sheet of a spindle, downwards", "inner-sheet normal-sign", spindle, [0.5, 0.125, 0], down, compare=LOOSE)
    for n in ([1, 0, 0], [0, 1, 0], [0, 0, -1], [0, 0, 5]):
        one("torus.uv torus.normal", f"The axis {n}", "uv-axis normal-not-unit", {**t, "normal": n}, [5, 6, 7], [-2, -2.5, -2.25], compare=LOOSE)


def transformed():
    z, down, left = [0, 0, 1], [0, 0, -1], [-1, 0, 0]
    ball = {"kind": "sphere"}
    g = lambda inner, **how: {"kind": "geometry", **how, "geometry": inner}
    one(".parameters", "Without a change the shape is as it is", "wrong-default", g(ball), [5, 0, 0], left, (4.0, [1, 0, 0], [0.5, 0.5]), compare="ulp:4")
    for i in range(3):
        scale, o, d, n = [1, 1, 1], [0, 0, 0], [0, 0, 0], [0, 0, 0]
        scale[i], o[i], d[i], n[i] = 3, 9, -1, 1
        one(".parameters", f"Three times as long along {'xyz'[i]}", "scale-swapped direction-normalized", g(ball, scale=scale), o, d, (6.0, n, [[0.5, 0.5], [0.5, 0], [0.75, 0.5]][i]), compare="ulp:4")
        move, o = [0, 0, 0], [0, 0, 0]
        move[i], o[i] = 4, 9
        one(".parameters", f"Moved along {'xyz'[i]}", "translation-sign", g(ball, translation=move), o, d, (4.0, n, [[0.5, 0.5], [0.5, 0], [0.75, 0.5]][i]), compare="ulp:4")
    arrow = {"kind": "plane", "normal": [1, 0, 0]}
    for turn, n, at in (([90, 0, 0], [1, 0, 0], [5, 1, 2]), ([0, 90, 0], [0, 0, -1], [1, 2, -5]), ([0, 0, 90], [0, 1, 0], [1, 5, 2]), ([0, -90, 0], [0, 0, 1], [1, 2, 5]), ([0, 0, -90], [0, -1, 0], [1, -5, 2]), ([0, 180, 0], [-1, 0, 0], [-5, 1, 2]),
                        ([0, 90, 90], [0, 0, -1], [1, 2, -5]), ([90, 0, 90], [0, 1, 0], [1, 5, 2]), ([0, 450, 0], [0, 0, -1], [1, 2, -5])):
        one(".rotated .normal", f"The x axis, turned by {turn}", "rotation-sign rotation-order", g(arrow, rotation=turn), at, [-x for x in n])
    up = {"kind": "plane", "normal": [0, 0, 1]}
    for turn, n, at in (([90, 0, 0], [0, -1, 0], [1, -5, 2]), ([0, 90, 0], [1, 0, 0], [5, 1, 2]), ([90, 90, 0], [0, -1, 0], [1, -5, 2]), ([90, 0, 90], [1, 0, 0], [5, 1, 2]), ([0, 90, 90], [0, 1, 0], [1, 5, 2])):
        one(".rotated .normal", f"The z axis, turned by {turn}", "rotation-sign rotation-order", g(up, rotation=turn), at, [-x for x in n])
    for turn in ([30, 0, 0], [0, 45, 0], [0, 0, -60], [10, 20, 30], [-120, 75, 200]):
        one(".rotated .normal .uv", f"A plane, turned by {turn}", "rotation-sign degrees", g(up, rotation=turn, translation=[0.5, 0.25, -0.125]), [5, 7, 9], [-1, -1.5, -2], compare=LOOSE)
    one(".parameters .rotated", "First scaled, then turned: long along x becomes long along y", "order", g(ball, scale=[3, 1, 1], rotation=[0, 0, 90]), [0, 9, 0], [0, -1, 0], (6.0, [0, 1, 0], [0.5, 0.5]), compare="abs:1e-14")
    one(".parameters .rotated", "First turned, then moved", "order", g(ball, rotation=[0, 0, 90], translation=[4, 0, 0]), [9, 0, 0], left, (4.0, [1, 0, 0], [0.5, 1]), compare={"t": "ulp:4", "point": "ulp:4", "normal": "ulp:4", "uv": "abs:1e-9"})
    one(".parameters", "First scaled, then moved: the move is not scaled", "order", g(ball, scale=[2, 2, 2], translation=[4, 0, 0]), [9, 0, 0], left, (3.0, [1, 0, 0], [0.5, 0.5]), compare="ulp:4")
    slope = {"kind": "plane", "normal": [1, 1, 0]}
    one(".normal", "A plane of slope 1, four times as long along x: the normal is carried by the inverse transpose", "normal-by-matrix", g(slope, scale=[4, 1, 1]), [0, 5, 0], [0, -1, 0], compare=LOOSE)
    one(".normal", "An ellipsoid off its axes", "normal-by-matrix normal-not-unit", g(ball, scale=[1, 2, 3]), [0.5, 0.75, 9], down, compare=LOOSE)
    one(".normal", "A large scale: the normal is unit", "normal-not-unit", g(ball, scale=[100, 100, 100]), [30, 40, 500], down, compare=LOOSE)
    for scale in ([-1, 1, 1], [1, -1, 1], [1, 1, -1], [-1, -1, -1], [-2, -1, 1]):
        one(".mirrored .normal", f"A cone under the factors {scale}: outward stays outward", "normal-sign", g({"kind": "cone", "point": [[1, 1, 1], [3, 2, 4]], "ray": 1}, scale=scale), *aimed_at_carried(g({"kind": "cone", "point": [[1, 1, 1], [3, 2, 4]], "ray": 1}, scale=scale), random.Random(650), faces), compare=LOOSE)
    one(".mirrored", "A mirrored triangle keeps the normal of its corners", "normal-sign orientation", g({"kind": "triangle", "point": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]}, scale=[-1, 1, 1]), [-1, 2, 3], down, (3.0, z, [0.25, 0.5]))
    inner = g(ball, translation=[2, 0, 0])
    one(".nested", "Moved, then scaled", "nested-order", g(inner, scale=[2, 1, 1]), [9, 0, 0], left, (3.0, [1, 0, 0], [0.5, 0.5]), compare="ulp:4")
    one(".nested", "Scaled, then moved", "nested-order", g(g(ball, scale=[2, 1, 1]), translation=[2, 0, 0]), [9, 0, 0], left, (5.0, [1, 0, 0], [0.5, 0.5]), compare="ulp:4")
    one(".nested .rotated", "Moved, then turned", "nested-order", g(inner, rotation=[0, 0, 90]), [0, 9, 0], [0, -1, 0], (6.0, [0, 1, 0], [0.5, 0.5]), compare="abs:1e-14")
    one(".nested", "Three deep", "nested-order", g(g(inner, scale=[1, 1, 2]), rotation=[0, 90, 0], translation=[0, 1, 0]), [0, 1, -9], z, (6.0, down, [0.5, 0.5]), compare="abs:1e-14")
    one(".uv", "Texture coordinates of the inner disk", "uv-scale", g({"kind": "disk", "ray": 2}, scale=[4, 2, 1]), [4, 2, 3], down, (3.0, z, [0.75, 0.25]))
    one(".uv", "Texture coordinates of a moved plane start at its own position", "uv-origin", g({"kind": "plane"}, translation=[10, 20, 30]), [11, 22, 31], down, (1.0, z, [1, -2]))
    one(".uv", "Texture coordinates of a turned plane turn with it", "uv-axis", g({"kind": "plane"}, rotation=[0, 0, 90]), [1, 2, 3], down, (3.0, z, [2, 1]))
    one(".parameters", "A direction of length 4 in a frame of scale 2", "direction-normalized", g(ball, scale=[2, 2, 2]), [10, 0, 0], [-4, 0, 0], (2.0, [1, 0, 0], [0.5, 0.5]), compare="ulp:4")


def operations():
    CASES.clear()
    for part in (every_shape, planar, spheres, cubes, triangles, tubes, cones, caps, lenses, tori, transformed, plain, carried):
        part()
    return {"geometry.hit": CASES}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
