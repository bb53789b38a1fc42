#!/usr/bin/env python3
"""Where a port that was written from the specification alone had to guess: cases for the rules and sentences that leave no guess.

Each case stands where two readings of an older wording gave two answers. Expected values are exact fractions, closed forms, or written by hand from the rule.
"""

import sys

sys.dont_write_bytecode = True

from fractions import Fraction  # noqa: E402

import suite  # noqa: E402
from suite import CLOSED, EXACT, HAND, Raw, case, decimal, dot, dunit, exact, nearest, numbers, sub  # noqa: E402

# These cases come after those of the other generators, whose numbers they leave alone.
LAST = True

DOWN = [0, 0, -1]


# Roots that rounding may have torn apart


def cubics():
    """(x + 1)(x - 1)(x - 1 - 2^-k), whose coefficients are binary64 numbers, and its image under x -> -x and x -> 2^m x.

    At the zero c of the derivative next to 1 the polynomial is -2 (2^-k / 2)^2, about, and T c^2 is 2: one root for k >= 25, as 2^(-2k - 1) <= 3/4 2^-49 there, two up to k = 24.
    """
    made = []
    for k in (20, 22, 23, 24, 25, 26, 30, 40):
        gap = Fraction(1, 2**k)
        apart = k < 25
        for sign, m in ((1, 0), (-1, 0), (1, 30)):
            size = sign * Fraction(2) ** m
            roots = [-1, 1, 1 + gap] if apart else [-1, 1 + gap / 2, 1 + gap / 2]
            a, b, c, d = 1, -(1 + gap) * size, -(size**2), (1 + gap) * size**3
            what = "given as they are" if apart else "taken for one"
            made.append(case("roots.multiple roots.cubic.count" if apart else "roots.multiple", f"Two roots 2^-{k} of their size apart are {what}", "merged count" if apart else "split count",
                             dict(zip("abcd", numbers([a, b, c, d]))), sorted(numbers([r * size for r in roots])), "rel:1e-8" if apart else "rel:1e-10", EXACT))
    return made


def quartics():
    """The same times x - 3, exact for k up to 48."""
    made = []
    for k in (20, 22, 26, 30):
        gap = Fraction(1, 2**k)
        apart = k < 25
        p = [1, -(1 + gap), -1, 1 + gap]
        q = [x - 3 * y for x, y in zip([*p, 0], [0, *p])]
        roots = [-1, 1, 1 + gap, 3] if apart else [-1, 1 + gap / 2, 1 + gap / 2, 3]
        what = "given as they are" if apart else "taken for one"
        made.append(case("roots.multiple roots.quartic.count" if apart else "roots.multiple", f"Of four roots two are 2^-{k} of their size apart: {what}", "merged count" if apart else "split count",
                         dict(zip("abcde", numbers(q))), numbers(roots), "rel:1e-7" if apart else "rel:1e-8", EXACT))
    return made


# The sizes of bare numbers, and normals that are not unit


def small_spheres():
    made = []
    for power in (100, 200, 300, 400):
        r = 2.0**-power
        made.append(case("protocol.sizes geometry.sphere.parameters", f"A radius of 2^-{power} is a radius", "epsilon refused", {"ray": {"origin": [-8 * r, 0, 0], "direction": [r, 0, 0]}, "position": [0, 0, 0], "radius": r}, [7, 9], source=EXACT))
    return made


def small_tubes():
    return [case("protocol.sizes geometry.tube.line-parameters", f"An axis of {length} and a radius of 2^-40: the axis is made unit", "axis-not-unit epsilon refused",
                 {"ray": {"origin": [-(2.0**-37), 0, 5], "direction": [2.0**-40, 0, 0]}, "point": [0, 0, 0], "axis": [0, 0, length], "radius": 2.0**-40}, [7, 9], source=EXACT) for length in (1e-30, 1e-12, 7, 1e40)]


def long_normals():
    made = [case("protocol.sizes geometry.plane.parameters", f"A normal of length {length} is made unit", "normal-not-unit", {"ray": {"origin": [0, 0, 5], "direction": DOWN}, "position": [1, 2, 1], "normal": [0, 0, length]}, [4], source=EXACT)
            for length in (1e-10, 0.5, 4, 1e90)]
    # Lengths of directions: from 1e-130 to 1e130.
    for power in (-430, -300, 300, 430):
        k = 2.0**power
        made.append(case("geometry.ray.direction geometry.plane.parallel", f"A direction of length 2^{power} is not parallel to the plane", "underflow overflow", {"ray": {"origin": [0, 0, 8], "direction": [0, 0, -k]}, "position": [0, 0, 0], "normal": [0, 0, 1]}, [8 / k], source=EXACT))
    return made


def long_directions():
    made = []
    for power in (-430, -300, 300, 430):
        k = 2.0**power
        made.append(case("geometry.ray.direction geometry.sphere.parameters", f"A direction of length 2^{power}", "underflow overflow", {"ray": {"origin": [-4, 0, 0], "direction": [k, 0, 0]}, "position": [0, 0, 0], "radius": 1}, [3 / k, 5 / k], "ulp:4", EXACT))
    return made


def reflections():
    made = []
    for length in (0.001, 2, 1e10):
        made.append(case("protocol.directions protocol.sizes optics.reflect", f"A normal of length {length} is made unit", "normal-not-unit", {"direction": [0.6, 0, -0.8], "normal": [0, 0, length]}, [0.6, 0, 0.8], "abs:1e-15", CLOSED))
    made.append(case("protocol.directions protocol.sizes optics.reflect", "A direction and a normal that are not unit", "normal-not-unit", {"direction": [3, 0, -4], "normal": [0, 0, -7]}, [0.6, 0, 0.8], "abs:1e-15", CLOSED))
    return made


def refractions():
    made = [case("protocol.sizes optics.refract", "Indices above 10, which a material cannot have", "refused", {"direction": [0, 0, -1], "normal": [0, 0, 1], "n1": n1, "n2": n2}, [0, 0, -1], "abs:1e-15", CLOSED) for n1, n2 in ((20, 40), (1e-12, 1e-11), (1, 1e6))]
    # sin = 0.6 20 / 16 = 0.75, along x; cos = sqrt(7) / 4.
    made.append(case("protocol.sizes optics.refract", "An index above 10 and a normal that is not unit", "refused normal-not-unit", {"direction": [0.6, 0, -0.8], "normal": [0, 0, 3], "n1": 20, "n2": 16}, numbers([decimal(0.75), 0, -decimal(7).sqrt() / 4]), "abs:1e-15", CLOSED))
    return made


def lambertian():
    made = []
    for length in (0.25, 4, 1e20):
        made.append(case("protocol.directions protocol.sizes light.lambert", f"A normal of length {length} is made unit", "normal-not-unit", {"light": [1, 1, 1], "surface": [0.5, 0.25, 1], "normal": [0, 0, length], "direction": DOWN}, [0.5, 0.25, 1], source=EXACT))
    return made


# Needles, and triangles of extreme size


def shares(p0, p1, p2, v):
    """The exact barycentric coordinates, by Gram's determinant in fractions."""
    p0, p1, p2, v = ([exact(float(x)) for x in p] for p in (p0, p1, p2, v))
    w, s1, s2 = sub(v, p0), sub(p1, p0), sub(p2, p0)
    d = dot(s1, s1) * dot(s2, s2) - dot(s1, s2) ** 2
    return [nearest((dot(w, s1) * dot(s2, s2) - dot(w, s2) * dot(s1, s2)) / d), nearest((dot(w, s2) * dot(s1, s1) - dot(w, s1) * dot(s1, s2)) / d)]


def needles():
    made = []

    def one(comment, flags, points, v, compare="abs:1e-13"):
        made.append(case("geometry.triangle.needle geometry.triangle.barycentric", comment, flags, {"points": points, "point": v}, shares(*points, v), compare, EXACT))

    for k in (9, 11, 20, 26, 27, 30, 40, 49):
        one(f"A needle with an angle of 2^-{k}", "catastrophic-cancellation nan", [[0, 0, 0], [1, 0, 0], [1, 2.0**-k, 0]], [0.75, 2.0 ** -(k + 2), 0])
    one("A needle in space, with edges of different lengths", "catastrophic-cancellation nan", [[1, 2, 3], [3, 6, 7], [1.5, 3 + 2.0**-30, 4]], [2, 4, 5], "abs:1e-6")
    one("The first corner of a needle", "nan", [[1, 1, 1], [2, 1, 1], [2, 1 + 2.0**-45, 1]], [1, 1, 1], "exact")
    one("The third corner of a needle", "nan", [[1, 1, 1], [2, 1, 1], [2, 1 + 2.0**-45, 1]], [2, 1 + 2.0**-45, 1])
    for size in (2.0**-600, 2.0**-300, 2.0**300, 1e90, 1e100):
        one(f"A triangle of size {size}", "overflow underflow nan", [[0, 0, 0], [size, 0, 0], [0, size, 0]], [size / 2, size / 4, 0])
    one("One edge very short, the other very long", "overflow underflow nan", [[0, 0, 0], [2.0**-300, 0, 0], [0, 2.0**300, 0]], [2.0**-301, 2.0**298, 0])
    one("A point far away from a small triangle", "overflow", [[0, 0, 0], [2.0**-200, 0, 0], [0, 2.0**-200, 0]], [2.0**300, -(2.0**299), 0], "rel:1e-14")
    one("An obtuse needle", "catastrophic-cancellation sign", [[0, 0, 0], [4, 0, 0], [-2, 2.0**-20, 0]], [0, 2.0**-21, 0])
    return made


def hit(t, point, normal, uv):
    return {"t": t, "point": point, "normal": normal, "uv": uv}


def hits():
    made = []

    def one(rules, comment, flags, shape, origin, direction, expected, compare="abs:1e-14", source=CLOSED):
        made.append(case(rules, comment, flags, {"geometry": shape, "ray": {"origin": origin, "direction": direction}}, expected, compare, source))

    for k in (11, 30, 48):
        point = [0.75, 2.0 ** -(k + 2), 0]
        one("geometry.triangle.needle geometry.hit.finite", f"The texture coordinates on a needle with an angle of 2^-{k}", "catastrophic-cancellation nan", {"kind": "triangle", "point": [[0, 0, 0], [1, 0, 0], [1, 2.0**-k, 0]]},
            [*point[:2], 1], DOWN, hit(1, point, [0, 0, 1], [0.5, 0.25]), "abs:1e-13")
    one("geometry.triangle.needle geometry.smooth-triangle.normal geometry.smooth-triangle.uv", "Normal and coordinates on a smooth needle", "catastrophic-cancellation nan",
        {"kind": "btriangle", "point": [[0, 0, 0], [1, 0, 0], [1, 2.0**-40, 0]], "normal": [[0, 0, 1], [0, 1, 0], [0, 0, 1]], "uv": [[0, 0], [4, 0], [0, 8]]},
        [0.75, 2.0**-42, 1], DOWN, hit(1, [0.75, 2.0**-42, 0], numbers(dunit([0, 1, 1])), [2, 2]), "abs:1e-13")
    one("geometry.triangle.needle geometry.hit.finite", "The texture coordinates on a triangle of size 1e90", "overflow nan", {"kind": "triangle", "point": [[0, 0, 0], [1e90, 0, 0], [0, 1e90, 0]]}, [5e89, 2.5e89, 1], DOWN, hit(1, [5e89, 2.5e89, 0], [0, 0, 1], [0.5, 0.25]))
    # The point is on the centre: w w - R R is rounded to w w at this distance, and the line meets the sphere twice in its middle.
    far = 2.0**27
    for centre, direction in (([0, 0, 0], [1, 0, 0]), ([0, 3, 4], [1, 0, 0]), ([1, 0, 2], [0, 1, 0]), ([0, 5, 0], [0, 0, -1])):
        one("geometry.hit.centre geometry.hit.finite", "Rounding puts the point on the centre of the sphere: the normal is the z axis", "nan null", {"kind": "sphere", "position": centre}, [c - far * d for c, d in zip(centre, direction)], direction,
            hit(far, centre, [0, 0, 1], [0.5, 0]), "exact", HAND)
    for end, direction in (([0, 0, 2], [1, 0, 0]), ([0, 2, 0], [0, 0, 1]), ([2, 0, 0], [0, 1, 0])):
        normal = [x / 2 for x in end]
        one("geometry.hit.centre geometry.hit.finite", "Rounding puts the point on the axis of the tube: the normal is along the axis", "nan null", {"kind": "tube", "point": [[-x for x in end], end]}, [-far * d for d in direction], direction,
            hit(far, [0, 0, 0], normal, [0.5, 0.5]), {"uv": "abs:1"}, HAND)
    # A smaller and a larger scale than any product can take.
    for power in (100, 90):
        scale = [Raw(f"1e-{power}")] * 3
        one("geometry.ray.direction geometry.hit.finite", f"Scaled down twice by 1e-{power}: all coefficients are infinite, and there is no hit", "nan overflow", {"kind": "geometry", "scale": scale, "geometry": {"kind": "geometry", "scale": scale, "geometry": {"kind": "sphere"}}},
            [-1, 0, 0], [1, 0, 0], None, "exact", HAND)
    # Arrays with fewer values than places.
    one("protocol.shapes", "A tube of which one end is given: the other has its default", "defaults", {"kind": "tube", "point": [[0, 0, -3]]}, [5, 0, 0], [-1, 0, 0], hit(4, [1, 0, 0], [1, 0, 0], [0.5, 0.25]))
    one("protocol.shapes", "A cylinder of which one end is given", "defaults", {"kind": "cylinder", "point": [[0, 0, -1]]}, [0, 0, -3], [0, 0, 1], hit(2, [0, 0, -1], [0, 0, -1], [0.5, 0.5]))
    one("protocol.shapes", "A triangle of which two corners are given: the third has its default", "defaults", {"kind": "triangle", "point": [[0, 0, 0], [1, 0, 0]]}, [0.5, 0.25, 1], DOWN, hit(1, [0.5, 0.25, 0], [0, 0, 1], [0.25, 0.25]))
    depth = 4 - decimal(15).sqrt()
    one("protocol.shapes", "A lens of which one curvature is given: the other face keeps its own", "defaults", {"kind": "lens", "curvature": [4]}, [0, 0, -9], [0, 0, 1], hit(nearest(9 - depth), [0, 0, nearest(-depth)], [0, 0, -1], [0.5, 0.5]))
    one("protocol.shapes", "A smooth triangle with one corner's coordinates", "defaults", {"kind": "btriangle", "point": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "uv": [[8, 4]]}, [0.25, 0.25, 1], DOWN, hit(1, [0.25, 0.25, 0], [0, 0, 1], [4, 2]))
    # Along an axis that is oblique.
    for end in ([1, 2, 3], [1, 1, 1], [-3, 1, 2]):
        away = numbers([-x for x in dunit(end)])
        one("geometry.tube.along-axis geometry.cylinder.along-axis", f"Along the oblique axis to {end}", "oblique leak", {"kind": "cylinder", "point": [[0, 0, 0], end]}, [-x for x in end], end, hit(1, [0, 0, 0], away, [0.5, 0.5]))
        one("geometry.cone.apex geometry.cone.interval", f"Along the oblique axis to the apex at {end}", "oblique leak", {"kind": "cone", "point": [[0, 0, 0], end]}, [2 * x for x in end], [-x for x in end], hit(1, end, [-x for x in away], [0.5, 0]),
            {"t": "abs:1e-14", "point": "abs:1e-14", "normal": "abs:1", "uv": "abs:1"})
    return made


# Texts


def told(*diagnostics):
    severities = {"decimal-comma": "warning", "missing-material": "warning", "repeated-material": "warning", "sampling-without-random": "warning", "no-model-file": "warning", "behind-opening": "warning", "no-material-name": "note", "replaced-object": "note"}
    return {"diagnostics": [{"code": code, "severity": severities.get(code, "error"), "line": line, "column": column} for code, line, column in diagnostics]}


def texts():
    made = []

    def one(rules, comment, flags, lines, *diagnostics):
        made.append(case(rules, comment, flags, {"text": "".join(line + "\n" for line in lines)}, told(*diagnostics)))

    one("protocol.text", "U+FEFF is the first character of the first word", "mark", ["\ufeffcamera", "  angle 20", "end"], ("unknown-word", 1, 1))
    one("protocol.text", "U+FEFF before a word of a property", "mark", ["camera", "  \ufeffangle 20", "end"], ("unknown-word", 2, 3))
    one("protocol.text", "U+FEFF before a comment makes it none", "mark", ["\ufeff# a comment", "camera", "end"], ("unknown-word", 1, 1))
    tracer = ["raytracer", "  sampling 4", "  pixel_coordinate center", "end"]
    one("code.sampling-without-random object.several-possible", "An earlier ray tracer that does not count is not told of", "superseded", [*tracer, "raytracer", "end"], ("replaced-object", 5, 1))
    one("code.sampling-without-random object.several-possible", "The last one is told of", "superseded", ["raytracer", "end", *tracer], ("replaced-object", 3, 1), ("sampling-without-random", 4, 12))
    one("code.sampling-without-random object.several-possible", "Of two such the last one alone", "superseded", [*tracer, *tracer], ("replaced-object", 5, 1), ("sampling-without-random", 6, 12))
    one("code.sampling-without-random check.place", "Told at the last value of sampling, though it was refused", "place", ["raytracer", "  sampling 4", "  sampling x", "end"], ("not-an-integer", 3, 12), ("sampling-without-random", 3, 12))
    ball = ["  sphere", "  end", "end"]
    named = lambda name: ["primitive", f"  material_name{name}", *ball]
    bare = ["primitive", *ball]
    one("code.missing-material code.no-material-name", "A name that an unnamed primitive took first is not told of any more", "twice", [*bare, *named(" none")], ("no-material-name", 1, 1))
    one("code.missing-material code.no-material-name", "The other way round it is", "twice", [*named(" none"), *bare], ("missing-material", 2, 17), ("no-material-name", 6, 1))
    one("code.missing-material check.place", "A material_name without a value is told as that alone", "missing", named(""), ("missing-value", 2, 3))
    one("code.missing-material check.place", "A material_name without a value keeps the name before", "missing", ["primitive", "  material_name a", "  material_name", *ball], ("missing-material", 2, 17), ("missing-value", 3, 3))
    one("code.missing-material", "A material_name without a value, where none is there", "missing", [*named(""), "material", "end"], ("missing-value", 2, 3))
    one("code.missing-material object.impossible", "A primitive that is left out names no material", "impossible", ["primitive", "  material_name a", "  plane", "    normal 0 0 1e-11", "  end", "end", *named(" a")], ("zero-normal", 3, 3), ("missing-material", 8, 17))
    one("code.no-material-name object.impossible", "A primitive that is left out gets no note", "impossible", ["primitive", "  plane", "    normal 0 0 1e-11", "  end", "end"], ("zero-normal", 2, 3))
    one("code.repeated-material", "A third material of a name is told too", "twice", ["material", "  name a", "end"] * 3, ("repeated-material", 5, 8), ("repeated-material", 8, 8))
    one("code.repeated-material check.place", "Told at the last name that has a value", "place", ["material", "  name a", "end", "material", "  name a", "  name", "end"], ("repeated-material", 5, 8), ("missing-value", 6, 3))
    one("code.repeated-material", "Two materials without a name have the same name", "defaults", ["material", "end", "material", "end"], ("repeated-material", 3, 1))
    one("code.decimal-comma", "A number that is out of range is told as that alone", "twice", ["camera", "  angle 500,5", "end"], ("out-of-range", 2, 9))
    one("code.decimal-comma", "A number that is too large is told as that alone", "twice", ["camera", "  angle 1e200,5", "end"], ("number-too-large", 2, 9))
    one("code.decimal-comma object.several", "A curvature is one real number; one that has no place is not looked at", "twice", ["primitive", "  material_name none", "  lens", "    curvature 5,5", "    curvature 5", "    curvature 1,5", "  end", "end", "material", "end"],
        ("decimal-comma", 4, 15), ("repeated-property", 6, 5))
    one("code.no-model-file", "The last file has no value: that alone is told", "place", ["model", "  file none", "  file", "end"], ("missing-value", 3, 3))
    one("code.no-model-file", "The last file is none, after one without a value", "place", ["model", "  file", "  file none", "end"], ("missing-value", 2, 3), ("no-model-file", 3, 8))
    one("code.no-model-file", "The last file is no longer none", "place", ["model", "  file none", "  file a.obj", "end"])
    one("check.passed-over code.unclosed-comment", "A comment in an object that is passed over is not told of, though it takes the rest of the text", "comment", ["camera", "  sphre", "    /*", "  end", "end"], ("missing-end", 1, 1), ("unknown-word", 2, 3))
    one("check.passed-over code.unclosed-comment", "Behind such an object it is", "comment", ["camera", "  thing", "    a 1", "  end", "/*"], ("missing-end", 1, 1), ("unknown-word", 2, 3), ("unclosed-comment", 5, 1))
    one("check.passed-over code.misspelt-end", "A misspelt end in an object that is passed over closes it, and is not told of", "misspelt", ["camera", "  thing", "  edn", "  angle x", "end"], ("unknown-word", 2, 3), ("not-a-number", 4, 9))
    for word in ("scene", "view_frustum", "texture_comparator", "default_material", "console_comparator", "particle"):
        one("tree.opening tree.scene-word check.passed-over", f"{word} opens an object inside another, and closes none", "scene-word", ["camera", f"  {word} of a kind", "    angle y", "  end", "  angle x", "end"], ("misplaced-word", 2, 3), ("not-a-number", 5, 9))
    tube = lambda *points: ["primitive", "  material_name none", "  tube", *("    point " + p for p in points), "  end", "end", "material", "end"]
    one("code.same-point object.several", "The first end was refused: its default counts", "defaults", tube("x 0 0", "0 0 0"), ("not-a-number", 4, 11), ("same-point", 5, 11))
    one("code.same-point", "-0 equals 0", "negative-zero", tube("2 -0 1", "2 0 1"), ("same-point", 5, 11))
    one("code.up-along-front", "The front of an aperture is made unit first: long", "made-unit", ["rectangular_aperture_light", "  front 0 0 2", "  up    0 6e-11 1", "end"], ("up-along-front", 1, 1))
    one("code.up-along-front", "Front and up of an aperture are made unit first: short", "made-unit", ["rectangular_aperture_light", "  front 0 0 1e-3", "  up    0 1e-8 0", "end"])
    one("code.up-along-front", "The front of a camera is made unit first", "made-unit", ["camera", "  look_at 0 0 2", "  up      0 6e-11 1", "end"], ("up-along-front", 1, 1))
    one("code.up-along-front", "The up of a camera is made unit before it is measured: along the front, and long", "made-unit rounding", ["camera", "  look_at 0.1 0.2 0.3", "  up      1e30 2e30 3e30", "end"], ("up-along-front", 1, 1))
    one("code.up-along-front", "The up of a camera is made unit before it is measured: nearly along the front, and long", "made-unit", ["camera", "  look_at 0 0 2", "  up      0 1 2e10", "end"], ("up-along-front", 1, 1))
    one("code.up-along-front", "The up of an aperture is made unit before it is measured: along the front, and long", "made-unit rounding", ["elliptical_aperture_light", "  front 0.1 0.2 0.3", "  up    1e30 2e30 3e30", "end"], ("up-along-front", 1, 1))
    one("code.up-along-front camera.up", "An up shorter than 1e-10 is none", "epsilon", ["camera", "  up 0 0.9e-10 0", "end"], ("up-along-front", 1, 1))
    one("form.colour", "Two tokens are a name and alpha", "count", ["material", "  color 0.5 0.5", "end"], ("unknown-choice", 2, 9))
    one("form.choice", "-0 is 0", "negative-zero", ["raytracer", "  reflexion_algorithm -0", "  reflexion_algorithm 0.0", "end"], ("unknown-choice", 3, 23))
    return made


def pixels():
    """The colour of an aperture light changes nothing, and mirrors are seen with every algorithm but no_light."""
    made = []
    plane = lambda material, z: f"primitive\n  material_name {material}\n  plane\n    position 0 0 {z}\n  end\nend\n"
    # One source: I = 1/2, times 1.2. The colour of 550 nm is (0, 1, 0), brought to what a screen can show.
    for name in ("red", "black", "3 2 1"):
        light = f"rectangular_aperture_light\n  color {name}\n  position -3 0 -1\n  nb_oscillator 1\n  amplification 1.2\nend\n"
        made.append(case("light.wave.gives", f"The colour of an aperture light, {name}, changes nothing", "wrong-colour", {"text": plane("m", 3) + "material\n  name m\nend\n" + light, "column": 250, "row": 250}, [0, 153, 0, 255]))
    # A white wall behind the eye, seen in a mirror with kr = 1 and nothing of its own: ka + kd + ks as the algorithm has them, since all falls and returns along one line.
    lights = "ambient_light\nend\npoint_light\n  position 0 0 1\nend\n"
    materials = "material\n  name mirror\n  ka 0\n  kd 0\n  ks 0\n  kr 1\nend\nmaterial\n  name wall\n  ka 0.2\n  kd 0.4\n  ks 0.2\nend\n"
    for algorithm, byte in (("ambient", 51), ("diffuse", 102), ("phong_specular", 51), ("blinn_specular", 51), ("no_specular", 153), ("phong", 204), ("blinn", 204), ("no_light", 0)):
        text = f"raytracer\n  reflexion_algorithm {algorithm}\n  recursive_level 2\nend\n" + plane("mirror", 3) + plane("wall", -1) + materials + lights
        made.append(case("light.algorithm optics.colour" if byte else "light.algorithm.no-light light.algorithm", f"A mirror with the algorithm {algorithm}", "wrong-terms mirror", {"text": text, "column": 250, "row": 250}, [byte, byte, byte, 255]))
    return made


def operations():
    return {"roots.cubic": cubics(), "roots.quartic": quartics(), "intersect.sphere": small_spheres() + long_directions(), "intersect.tube": small_tubes(), "intersect.plane": long_normals(), "optics.reflect": reflections(),
            "optics.refract": refractions(), "light.lambert": lambertian(), "triangle.barycentric": needles(), "geometry.hit": hits(), "scene.check": texts(), "scene.pixel": pixels()}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
