#!/usr/bin/env python3
"""Which points are inside of a shape: by `solids`, in decimals of 60 digits, never for a point at which rounding might decide."""

import random
import sys

sys.dont_write_bytecode = True

import hits  # noqa: E402
import solids  # noqa: E402
import suite  # noqa: E402
from suite import DECIMAL, case  # noqa: E402

CASES = []


def one(rules, comment, flags, shape, point, expected=None):
    computed = solids.contains(shape, point)
    if expected is not None and computed != expected:
        raise AssertionError(f"{comment}: {computed}")
    sent = {"geometry": shape, "point": point}
    if all(other["in"] != sent for other in CASES):
        CASES.append(case(["geometry." + rule for rule in rules.split()], comment, flags, sent, computed, source=DECIMAL))


def open_shapes():
    for kind, point in (("plane", [0, 0, -1]), ("disk", [0, 0, 0]), ("annulus", [0.75, 0, 0]), ("triangle", [0.25, 0.5, 0]), ("btriangle", [0.25, 0.5, 0]), ("tube", [0, 0, 0.5]), ("spherical_cap", [0, 0, 0.5])):
        one("contains.closed", f"A {kind} is open and contains nothing", "open-shape", {"kind": kind}, point, False)
        one("contains.closed transformed.contains", f"A {kind} in a frame of its own is open", "open-shape", {"kind": "geometry", "scale": [2, 2, 2], "geometry": {"kind": kind}}, [2 * x for x in point], False)
    for kind, point in (("sphere", [0.5, 0, 0]), ("cube", [0.25, 0.25, 0.25]), ("cylinder", [0.5, 0, 0.5]), ("cone", [0.25, 0, 0.5]), ("lens", [0.5, 0, 0.5]), ("torus", [1.1, 0, 0])):
        one("contains.closed", f"A {kind} is closed", "closed-shape", {"kind": kind}, point, True)
        one("contains.closed transformed.contains", f"A {kind} in a frame of its own is closed", "closed-shape", {"kind": "geometry", "translation": [1, 2, 3], "geometry": {"kind": kind}}, [x + y for x, y in zip(point, (1, 2, 3))], True)


def thin(rules, what, shape, point, direction, size, part):
    """Points at half and at twice the thickness of a surface within it, just on it, and a little beyond."""
    place = lambda k: [x + k * size * y for x, y in zip(point, direction)]
    one(rules, f"{what}: on the surface", "surface-inside", shape, point, False)
    one(rules, f"{what}: within by half of the tolerance", "epsilon", shape, place(-part / 2), False)
    one(rules, f"{what}: within by twice the tolerance", "epsilon", shape, place(-2 * part), True)
    one(rules, f"{what}: within by ten times the tolerance", "epsilon", shape, place(-10 * part), True)
    one(rules, f"{what}: beyond by ten times the tolerance", "epsilon sign", shape, place(10 * part), False)


def borders():
    flat, curved = 1e-10, 1e-7
    surface = " contains.surface"
    thin("sphere.contains" + surface, "A sphere", {"kind": "sphere"}, [0, 0, 1], [0, 0, 1], 1, flat)
    thin("sphere.contains" + surface, "A sphere of radius 1000: the tolerance is relative", {"kind": "sphere", "ray": 1000}, [1000, 0, 0], [1, 0, 0], 1000, flat)
    thin("sphere.contains" + surface, "A sphere of radius 0.001: the tolerance is relative", {"kind": "sphere", "ray": 0.001}, [0, 0.001, 0], [0, 1, 0], 0.001, flat)
    for i, side in ((0, 1), (0, -1), (1, 1), (1, -1), (2, 1), (2, -1)):
        face = [0.5, 0.25, -0.25]
        face[i] = side
        thin("cube.contains" + surface, f"A cube, the face {'+' if side > 0 else '-'}{'xyz'[i]}", {"kind": "cube", "size": 2}, face, [side if j == i else 0 for j in range(3)], 1, flat)
    thin("cube.contains" + surface, "A cube of size 200: the tolerance is relative", {"kind": "cube", "size": 200}, [0, 100, 0], [0, 1, 0], 100, flat)
    bar = {"kind": "cylinder", "point": [[0, 0, 0], [0, 0, 2]], "ray": 1}
    thin("cylinder.contains" + surface, "A cylinder, its wall", bar, [1, 0, 1], [1, 0, 0], 1, curved)
    thin("cylinder.contains" + surface, "A cylinder of radius 100, its wall: relative", {**bar, "ray": 100}, [0, 100, 1], [0, 1, 0], 100, curved)
    thin("cylinder.contains" + surface, "A cylinder, its lower end", bar, [0.5, 0, 0], [0, 0, -1], 1, flat)
    thin("cylinder.contains" + surface, "A cylinder, its upper end", bar, [0.5, 0, 2], [0, 0, 1], 1, flat)
    thin("cylinder.contains" + surface, "A cylinder of length 100, its upper end: a distance, not relative", {**bar, "point": [[0, 0, 0], [0, 0, 100]]}, [0.5, 0, 100], [0, 0, 1], 1, flat)
    hat = {"kind": "cone", "point": [[0, 0, 0], [0, 0, 2]], "ray": 1}
    thin("cone.contains" + surface, "A cone, its side", hat, [0.5, 0, 1], [1, 0, 0], 0.5, curved)
    thin("cone.contains" + surface, "A cone, its side near the base", hat, [0, 0.75, 0.5], [0, 1, 0], 0.75, curved)
    thin("cone.contains" + surface, "A cone, its base", hat, [0.25, 0, 0], [0, 0, -1], 1, flat)
    one("cone.contains", "A cone: the apex is not inside", "apex", hat, [0, 0, 2], False)
    one("cone.contains", "A cone: below the apex on the axis by 2e-10", "epsilon apex", hat, [0, 0, 2 - 2e-10], True)
    one("cone.contains", "A cone: below the apex on the axis by 5e-11", "epsilon apex", hat, [0, 0, 2 - 5e-11], False)
    one("cone.contains", "A cone: beyond the apex, where the double cone would go on", "double-cone", hat, [0, 0, 3], False)
    one("cone.contains", "A cone: beyond the apex, within the other half", "double-cone", hat, [0.25, 0, 4], False)
    one("cone.contains", "A cone: below the base", "base", hat, [0, 0, -0.5], False)
    one("cone.contains", "A cone: beside it, within the radius of the base", "cylinder-for-cone", hat, [0.75, 0, 1.5], False)
    ring = {"kind": "torus", "major_radius": 2, "minor_radius": 1}
    thin("torus.contains" + surface, "A torus, its outermost circle", ring, [3, 0, 0], [1, 0, 0], 1, curved)
    thin("torus.contains" + surface, "A torus, its innermost circle", ring, [0, 1, 0], [0, -1, 0], 1, curved)
    thin("torus.contains" + surface, "A torus, its top", ring, [0, -2, 1], [0, 0, 1], 1, curved)
    thin("torus.contains" + surface, "A torus with a tube of 0.01: relative", {**ring, "minor_radius": 0.01}, [2, 0, 0.01], [0, 0, 1], 0.01, curved)
    one("torus.contains", "A torus: its middle is not inside", "hole", ring, [0, 0, 0], False)
    one("torus.contains", "A torus: in the tube", "hole", ring, [0, -2, 0], True)
    spindle = {"kind": "torus", "major_radius": 1, "minor_radius": 2}
    one("torus.contains", "A spindle: its middle is inside of the tube", "inner-sheet", spindle, [0, 0, 0], True)
    one("torus.contains", "A spindle: between the inner sheet and the outer one", "inner-sheet", spindle, [2, 0, 0], True)
    one("torus.contains", "A spindle: on the axis, above", "inner-sheet", spindle, [0, 0, 1.75], False)
    thick, hollow = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 2]], "ray": 3, "curvature": [5, 5]}, {"kind": "lens", "point": [[0, 0, 0], [0, 0, 4]], "ray": 3, "curvature": [-5, -5]}
    thin("lens.contains" + surface, "A lens that bulges, the first face", thick, [0, 0, -1], [0, 0, -1], 5, flat)
    thin("lens.contains" + surface, "A lens that bulges, the second face", thick, [0, 0, 3], [0, 0, 1], 5, flat)
    thin("lens.contains" + surface, "A hollow lens, the first face", hollow, [0, 0, 1], [0, 0, -1], 5, flat)
    thin("lens.contains" + surface, "A hollow lens, the second face", hollow, [0, 0, 3], [0, 0, 1], 5, flat)
    thin("lens.contains" + surface, "A lens, its side", thick, [0, 3, 1], [0, 1, 0], 3, curved)
    for c1, c2 in ((5, -5), (-5, 5)):
        mixed = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 4]], "ray": 3, "curvature": [c1, c2]}
        for z in (-0.5, 0.5, 3.5, 4.5):
            one("lens.contains", f"A lens with the curvatures {c1} and {c2}, at the height {z}", "curvature-sign curvature-swapped", mixed, [0, 0, z])
            one("lens.contains", f"A lens with the curvatures {c1} and {c2}, near the rim at the height {z}", "curvature-sign curvature-swapped", mixed, [2.75, 0, z])
    long = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 40]], "ray": 3, "curvature": [5, 5]}
    one("lens.contains", "A long lens: beyond the first sphere, on the body's side of its centre's plane", "long-lens", long, [0, 0, 20], True)
    one("lens.contains", "A long lens: near the side in the middle", "long-lens", long, [2.9, 0, 20], True)
    one("lens.contains", "A long hollow lens: far from the faces", "long-lens", {**long, "curvature": [-5, -5]}, [0, 0, 20], True)
    one("lens.contains", "Beyond a hollow face's sphere on the other side", "centre-plane", hollow, [0, 0, -20], False)
    one("lens.contains", "Beyond the other hollow face's sphere on the other side", "centre-plane", hollow, [0, 0, 24], False)
    half = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 2]], "ray": 2, "curvature": [2, 2]}
    one("lens.contains", "A lens of half spheres, in the first one", "nan", half, [0, 0, -1.5], True)
    one("lens.contains", "A lens of half spheres, beyond it", "nan", half, [1.5, 0, -1.5], False)


def frames():
    ball = {"kind": "sphere"}
    g = lambda inner, **how: {"kind": "geometry", **how, "geometry": inner}
    for i in range(3):
        scale, inner, outer = [1, 1, 1], [0, 0, 0], [0, 0, 0]
        scale[i], inner[i], outer[i] = 3, 2.5, 3.5
        one("transformed.contains", f"Three times as long along {'xyz'[i]}", "scale-inverted", g(ball, scale=scale), inner, True)
        one("transformed.contains", f"Three times as long along {'xyz'[i]}: beyond", "scale-inverted", g(ball, scale=scale), outer, False)
        inner = [2.5 if j == (i + 1) % 3 else 0 for j in range(3)]
        one("transformed.contains", f"Not as long along {'yzx'[i]}", "scale-swapped", g(ball, scale=scale), inner, False)
    one("transformed.contains", "Moved", "translation-sign", g(ball, translation=[5, 0, 0]), [5.5, 0, 0], True)
    one("transformed.contains", "Moved the other way", "translation-sign", g(ball, translation=[5, 0, 0]), [-5.5, 0, 0], False)
    one("transformed.contains", "Scaled and moved: the move is not scaled", "order", g(ball, scale=[2, 2, 2], translation=[5, 0, 0]), [6.5, 0, 0], True)
    one("transformed.contains", "Scaled and moved: not at twice the move", "order", g(ball, scale=[2, 2, 2], translation=[5, 0, 0]), [10, 0, 0], False)
    bar = {"kind": "cylinder", "point": [[0, 0, 0], [0, 0, 4]], "ray": 0.5}
    for turn, point in (([90, 0, 0], [0, -3, 0]), ([-90, 0, 0], [0, 3, 0]), ([0, 90, 0], [3, 0, 0]), ([0, -90, 0], [-3, 0, 0]), ([0, 90, 90], [0, 3, 0]), ([90, 90, 0], [0, -3, 0]), ([90, 0, 90], [3, 0, 0])):
        one("transformed.contains", f"A bar along z, turned by {turn}", "rotation-sign rotation-order", g(bar, rotation=turn), point, True)
        one("transformed.contains", f"A bar along z, turned by {turn}: on the other side", "rotation-sign rotation-order", g(bar, rotation=turn), [-x for x in point], False)
    one("transformed.contains", "Turned by 30 degrees, not by 30 radians", "degrees", g(bar, rotation=[0, 30, 0]), [1.5, 0, 2.6], True)
    one("transformed.contains", "The tolerance applies in the inner frame: 5e-10 from the surface of a sphere of radius 10", "epsilon", g(ball, scale=[10, 10, 10]), [0, 0, 10 - 5e-10], False)
    one("transformed.contains", "The tolerance applies in the inner frame: 2e-9 from it", "epsilon", g(ball, scale=[10, 10, 10]), [0, 0, 10 - 2e-9], True)
    one("transformed.contains", "Mirrored", "mirrored", g({"kind": "cube", "position": [3, 0, 0]}, scale=[-1, 1, 1]), [-3.25, 0, 0], True)
    one("transformed.contains", "Mirrored: not where it was", "mirrored", g({"kind": "cube", "position": [3, 0, 0]}, scale=[-1, 1, 1]), [3.25, 0, 0], False)
    inner = g(ball, translation=[2, 0, 0])
    one("transformed.contains", "Moved, then scaled", "nested-order", g(inner, scale=[2, 1, 1]), [5.5, 0, 0], True)
    one("transformed.contains", "Scaled, then moved", "nested-order", g(g(ball, scale=[2, 1, 1]), translation=[2, 0, 0]), [5.5, 0, 0], False)
    one("transformed.contains", "Moved, then turned", "nested-order", g(inner, rotation=[0, 0, 90]), [0, 2.5, 0], True)


def anywhere():
    chance = random.Random(660)
    for kind in solids.CLOSED:
        answers = {True: 0, False: 0}
        while min(answers.values()) < 3:
            shape = hits.random_shape(kind, chance)
            if not hits.possible(shape):
                continue
            point = [round(x + chance.uniform(-1.8, 1.8), 2) for x in hits.middle(shape)]
            if chance.random() < 0.4:
                shape, point = {"kind": "geometry", "scale": [1.5, 0.8, -1.2], "rotation": [20, 50, -30], "translation": [0.5, 0, 0], "geometry": shape}, point
            try:
                steady = {solids.contains(shape, [x + (e if i == j else 0) for j, x in enumerate(point)]) for i in range(3) for e in (-0.01, 0.01)}
                answer = solids.contains(shape, point)
            except solids.Unsafe:
                continue
            if steady == {answer} and answers[answer] < 3:
                answers[answer] += 1
                one(f"{kind}.contains" + (" transformed.contains" if shape["kind"] == "geometry" else ""), f"A {kind}, {'inside' if answer else 'outside'}", "sign swapped", shape, point)


def operations():
    CASES.clear()
    for part in (open_shapes, borders, frames, anywhere):
        part()
    return {"geometry.contains": CASES}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
