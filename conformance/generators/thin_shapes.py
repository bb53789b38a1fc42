#!/usr/bin/env python3
"""Shapes so thin that binary64 hardly knows their height, or does not: flat cones and caps, a cylinder shorter than there are numbers for; and light that falls straight from an index far above the other.

Expected hits come from `solids`, in decimals of 60 digits; each ray passes the rim, or the change from one way of computing to the other, at a distance that rounding does not bridge.
"""

import math
import random
import sys

sys.dont_write_bytecode = True

import solids  # noqa: E402
import suite  # noqa: E402
from suite import DECIMAL, HAND, case  # noqa: E402

# These cases come after those of the other generators, whose numbers they leave alone.
LAST = True

# The parameter of a thin cone is good to the rounding of positions; its texture coordinate on the side is the distance from the axis, and as good.
NEAR = {"t": "abs:1e-11", "point": "abs:1e-11", "normal": "abs:1e-11", "uv": "abs:1e-11"}


def axis_and_across(chance, upright):
    """A unit vector, and two that are orthogonal to it, as they are in binary64."""
    if upright:
        return [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]
    s = [0.48, 0.6, 0.64]
    e = [0.8, 0.0, -0.6]
    f = [s[1] * e[2] - s[2] * e[1], s[2] * e[0] - s[0] * e[2], s[0] * e[1] - s[1] * e[0]]
    return s, e, f


def through(chance, centre, s, e, f, radius, part, above):
    """A ray from some units away to a place at that part of the radius, whose angle with the axis is below 60 degrees."""
    turn = chance.uniform(0.3, 2.8)
    target = [c + part * radius * (math.cos(turn) * x + math.sin(turn) * y) for c, x, y in zip(centre, e, f)]
    tilt, way = chance.uniform(0.3, 1.0), chance.uniform(0, 6.2)
    side = 1 if above else -1
    u = [side * math.cos(tilt) * x + math.sin(tilt) * (math.cos(way) * y + math.sin(way) * z) for x, y, z in zip(s, e, f)]
    d = [round(-x, 3) for x in u]
    away = chance.choice([2.5, 4.0, 7.0])
    return [round(x - away * y, 4) for x, y in zip(target, d)], d


def steady(rules, comment, flags, shape, ray, compare):
    """The case, if it does not hang on digits: the same part is hit, or none, when the ray is moved by the 10^-6th part of a unit."""
    hits = []
    for i in range(-1, 3):
        moved = {"origin": [x + (1e-6 if i == j else 0) for j, x in enumerate(ray["origin"])], "direction": ray["direction"]}
        hits.append(solids.hit(shape, moved))
    if any((one is None) != (hits[0] is None) for one in hits):
        return None
    if hits[0] is None:
        return case(rules + " geometry.hit.none", comment, flags, {"geometry": shape, "ray": ray}, None, "exact", DECIMAL)
    return case(rules, comment, flags, {"geometry": shape, "ray": ray}, solids.rounded(hits[0]), compare, DECIMAL)


def thin(rules, kind, flags, shapes):
    """Rays at each shape, within its rim and beside it. Shapes come with the centre of their disk, and what they are called."""
    made = []
    for number, (what, shape, centre, frame, radius, sides) in enumerate(shapes):
        for place, part in enumerate((0.3, 0.9, 1.1, 2.5)):
            chance = random.Random(9000 + 10 * number + place)
            for above in sides:
                one = None
                while one is None:
                    o, d = through(chance, centre, *frame, radius, part, above)
                    where = "within the rim" if part < 1 else "beside it"
                    try:
                        one = steady(rules, f"{what}: {where}, from {'above' if above else 'below'}", flags, shape, {"origin": o, "direction": d}, NEAR)
                    except solids.Unsafe:
                        one = None
                made.append(one)
    return made


def cones():
    """Of heights on both sides of R = 32 H, and down to where a height is less than the rounding of a position. From below, only where base and side are told apart by it."""
    shapes = []
    for upright in (True, False):
        for h in (0.0625, 0.03, 1e-3, 1e-5, 2.0**-20, 1e-7, 1e-9, 1e-12):
            frame = axis_and_across(None, upright)
            base = [0.0, 0.0, 0.0] if upright else [0.5, -1.25, 2.0]
            apex = [b + h * x for b, x in zip(base, frame[0])]
            between = suite.decimals([a - b for a, b in zip(apex, base)])
            # An end is rounded where the base is not in the origin: the axis is that of the rounded points, and a short one would be turned.
            if not upright and h < 1e-7:
                base, apex = [0.0, 0.0, 0.0], [h * x for x in frame[0]]
            elif not upright:
                s = [float(x) for x in suite.dunit(between)]
                frame = (s, frame[1], frame[2])
            shapes.append((f"A cone of height {h:g}" + ("" if upright else ", oblique"), {"kind": "cone", "point": [base, apex], "ray": 1}, base, frame, 1.0, (True, False) if h >= 1e-9 else (True,)))
    return thin("geometry.cone.interval geometry.cone.uv", "cone", "cancellation flat", shapes)


def caps():
    """Of curvatures on both sides of 16 R, and up to where the height is less than the rounding of a position."""
    shapes = []
    for upright in (True, False):
        for c in (15.0, -15.0, 17.0, -17.0, 1e4, 1e8, -1e8, 1e12, 1e15, -1e17, 1e20):
            frame = axis_and_across(None, upright)
            centre = [0.0, 0.0, 0.0] if upright else [0.5, -1.25, 2.0]
            shapes.append((f"A cap of curvature {c:g}" + ("" if upright else ", oblique"), {"kind": "spherical_cap", "position": centre, "normal": frame[0], "ray": 1, "curvature": c}, centre, frame, 1.0, (True, False)))
    return thin("geometry.cap.parameters", "spherical_cap", "cancellation flat", shapes)


def short():
    """The slab is one parameter, 3, which is that of the side, too; the height there is a rest of rounding, 10^293 times the cylinder's."""
    made = []
    for h in (1e-310, 5e-324, 1e-200):
        shape = {"kind": "cylinder", "point": [[0, 0, 0], [0, h, 0]], "ray": 1}
        ray = {"origin": [4, 0.3828000000000001, 0], "direction": [-1, -0.12760000000000002, 0]}
        hit = {"t": 3.0, "point": [1.0, 0.3828000000000001 + 3 * -0.12760000000000002, 0.0], "normal": [1, 0, 0], "uv": [0.5, 0]}
        made.append(case("geometry.tube.uv geometry.hit.finite", f"The rim of a cylinder of length {h:g}", "infinity clamp", {"geometry": shape, "ray": ray}, hit, "exact", HAND))
    return made


def refractions():
    made = []
    for n1, n2 in ((1e200, 1), (1, 1e-200), (1e9, 1), (1e30, 1e-30), (67108865.0, 1)):
        for v, n in (([0, 0, -1], [0, 0, 1]), ([0, 0.6, -0.8], [0, -0.6, 0.8]), ([0.48, -0.6, 0.64], [-0.48, 0.6, -0.64])):
            made.append(case("optics.refract.straight", f"Straight on, from {n1:g} to {n2:g}", "nan zero cancellation", {"direction": v, "normal": n, "n1": n1, "n2": n2}, v, "abs:1e-15", HAND))
    return made


def operations():
    return {"geometry.hit": cones() + caps() + short(), "optics.refract": refractions()}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
