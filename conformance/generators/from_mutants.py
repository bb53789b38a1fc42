"""Cases that mutants asked for: small changes of the reference that no other case noticed (conformance/mutants, mutants.md).

Each adds to the cases of its operation, behind those of the other generators. Expected values come from the same sources as theirs: whole numbers and fractions for roots,
the shapes of `solids` and the pixels of `light_pixels` in decimals.
"""

import math
import random
import sys

sys.dont_write_bytecode = True

from fractions import Fraction  # noqa: E402

import language  # noqa: E402
import light_pixels  # noqa: E402
import roots_maths  # noqa: E402
import solids  # noqa: E402
from camera_rays import uniform  # noqa: E402
from light_pixels import AMBIENT, NOON, PLANE, SUN, scene  # noqa: E402
from suite import CLOSED, DECIMAL, EXACT, HAND, ORDERED, case, main, nearest, next_up  # noqa: E402

LAST = True  # behind the other generators


# Roots


def close(rules, comment, flags, coefficients, compare):
    """Roots that are closer than the other generators take them, and still farther than 2^-24 of their size."""
    roots = roots_maths.real_roots(coefficients)
    different = sorted(set(roots))
    if any(b - a <= Fraction(1, 2**24) * max(abs(a), abs(b)) for a, b in zip(different, different[1:])):
        raise ValueError(f"{comment}: too close")
    return case(rules, comment, flags, roots_maths.sent(*map(float, coefficients)), [nearest(x) for x in roots], compare, EXACT)


def product(p, q):
    made = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            made[i + j] += Fraction(a) * Fraction(b)
    if any(Fraction(float(c)) != c for c in made):
        raise ValueError(f"{made} are not binary64 numbers")
    return made


def stretched(p, k):
    """The polynomial whose roots are 2^k times as large."""
    return [c * Fraction(2) ** (k * i) for i, c in enumerate(p)]


def quartics():
    made = []
    # (x - 3)^2 = +-e: the roots, real or complex, are 2 sqrt e apart.
    e = Fraction(1, 2**45)
    for k, sizes in ((0, "sizes around 1"), (100, "sizes around 2^100"), (-100, "sizes around 2^-100")):
        two, none = (stretched(product([1, -6, 9 - s * e], [1, 0, 1]), k) for s in (1, -1))
        mirrored = [c * (-1) ** i for i, c in enumerate(two)]
        made += [
            close("roots.quartic.count roots.multiple", f"Two roots that are 2^-23.1 of their size apart are two; {sizes}.", "epsilon merged", two, "rel:1e-9"),
            close("roots.quartic.count roots.multiple", f"The same with the other sign; {sizes}.", "epsilon merged sign", mirrored, "rel:1e-9"),
            close("roots.quartic.count roots.multiple", f"Complex roots that are 2^-23.1 of their size apart are no real ones; {sizes}.", "epsilon merged", none, "exact"),
        ]
    # (x^2 - 2 s^2)^2: the double roots are no binary64 numbers, and the sizes of the coefficients are far apart.
    for k in (60, -60):
        for square in (2, 3):
            p = stretched([1, 0, -2 * square, 0, square * square], k)
            made.append(close("roots.multiple roots.scale", f"Irrational double roots, of the size of 2^{k}: the square roots of {square}, twice each.", "double-root overflow", p, "rel:1e-10"))
    return made


def tripled(e):
    """(x - 1)^3 - e (x - 1), whose derivative is 3 (x - 1)^2 - e. That has a double zero at 1 if |e| <= 3/4 2^-50 3, the bound of roots.multiple at the zero 1 of its own derivative, and then
    1 is a triple root. Else it has two zeros if e > 0, and none if not. At two, 1 +- h with 3 h^2 = e, the value is 2 h^3 in size and the bound 3/4 2^-50 3 h at
    both: the roots are given as they are, whether h^2 > 9/8 2^-50 or neighbours are in each other's way."""
    e = Fraction(e)
    return [Fraction(1), Fraction(-3), 3 - e, e - 1], abs(e) <= Fraction(9, 4) / 2**50


def beside(low, high, chance):
    """x^3 - 3 c x^2 + ..., which is (x - c)^3 - e (x - c) + v, with e near 3/2 2^-50 and |v| between low 2^-75 and high 2^-75: c, e and v. The coefficients are multiples of 2^-51 and 2^-52."""
    while True:
        c = 1 + Fraction(chance.getrandbits(38), 2**51)
        linear = Fraction(math.floor((3 * c * c - Fraction(3, 2**51)) * 2**51), 2**51)
        e = 3 * c * c - linear
        rest = e * c - c**3
        v = Fraction(round(rest * 2**52), 2**52) - rest
        if low < abs(v) * 2**75 < high:
            return c, e, v


def cubics():
    made, chance = [], random.Random(75)
    for times, k in ((1, 51), (1, 50), (1, 49), (1, 48), (1, 47), (-1, 51), (-1, 50), (-1, 48), (5, 51), (3, 50)):
        p, triple = tripled(Fraction(times, 2**k))
        if any(Fraction(float(c)) != c for c in p):
            raise ValueError(f"{p} are not binary64 numbers")
        for turned in (False, True):
            q = [c * (-1) ** i for i, c in enumerate(p)] if turned else p
            roots = [-1, -1, -1] if turned else [1, 1, 1]
            if not triple:
                roots = [nearest(x) for x in roots_maths.real_roots(q)]
            far, middle = f"2^-{(k - math.log2(abs(times))) / 2:.3g} of {'its' if times < 0 else 'their'} size", -1 if turned else 1
            which = f"{middle}, and two complex roots {far} beside it" if times < 0 else f"Three roots around {middle}, {far} apart"
            comment = f"{which}: {'one, three times' if triple else 'as they are'}"
            # roots.residual binds little where all three are that near.
            made.append(case("roots.multiple", comment, "triple-root count" if triple else "merged count", roots_maths.sent(*map(float, q)), roots, "rel:1e-10" if triple else "rel:2e-5", EXACT))
    # Two roots that would count as one, were the zero of the derivative between them not beyond the largest number: it is 2^1024 (1 + 2^-26 - 2^-28).
    huge = Fraction(2) ** 1024
    below, above = huge * (1 - Fraction(1, 2**27)), huge * (1 + Fraction(1, 2**25))
    for sign in (1, -1):
        a = Fraction(1, 2**1074)
        p = [a, -sign * (below + above) * a, below * above * a, -sign * below * above * a]
        # Nearly (x - below) (x - above) (x - 1), with x^2 left out, which moves the roots by a part in 2^1022 or less.
        if any(Fraction(float(c)) != c for c in p):
            raise ValueError(f"{p} are not binary64 numbers")
        roots = [x for x in roots_maths.real_roots(p) if abs(x) < huge - Fraction(2) ** 970]
        made.append(case("roots.finite roots.multiple", f"A root next to the largest number{' with a minus' if sign < 0 else ''}, another just beyond, and so is the zero of the derivative between them: the first is given as it is", "overflow merged", roots_maths.sent(*map(float, p)), [nearest(x) for x in roots], "rel:1e-7", EXACT))
    # The derivative is 3 (x - c)^2 - e, with a double zero at c: a triple root of p if |v| <= 3/4 2^-75 c^3. With two zeros there, one of which counts, there would be a double root and another.
    for low, high in ((0.2, 0.6), (1.2, 1.6)):
        for _ in range(2):
            c, e, v = beside(low, high, chance)
            p = [Fraction(1), -3 * c, 3 * c * c - e, v + e * c - c**3]
            if any(Fraction(float(x)) != x for x in p):
                raise ValueError(f"{p} are not binary64 numbers")
            if e > Fraction(9, 4) / 2**50 * c * c:
                raise ValueError("no double zero")
            for turned in (False, True):
                q = [x * (-1) ** i for i, x in enumerate(p)] if turned else p
                triple, only = abs(v) <= Fraction(3, 4) / 2**75 * c**3, roots_maths.real_roots(q)
                if not triple and len(only) != 1:
                    raise ValueError("more than one root")
                size, sign = f"{float(abs(v) * 2**75):.2f} 2^-75", "-" if turned else ""
                made.append(case("roots.multiple", f"{sign}(1 + {float(c - 1):.1e}), where the value is {size}: {'a triple root' if triple else 'none, and one root beside it'}", "triple-root count" if triple else "merged count",
                                 roots_maths.sent(*map(float, q)), [nearest(-c if turned else c)] * 3 if triple else [nearest(x) for x in only], "rel:1e-10" if triple else "rel:2e-5", EXACT))
    return made


# Surfaces


def far_cones():
    """A cone of the size of 2^k, met at right angles to its axis, where it is as wide as its distance from the apex."""
    made = []
    for k in (300, -300):
        size = 2.0**k
        ray = {"origin": [-2 * size, 0, 0], "direction": [size, 0, 0]}
        made.append(case("geometry.cones.parameters", f"A cone of the size of 2^{k}", "overflow missing-normalisation", {"ray": ray, "point": [0, 0, 0], "apex": [0, 0, size], "radius": size}, [1, 3], "ulp:4", CLOSED))
    return made


def hit(rules, comment, flags, shape, o, d, compare):
    made = solids.rounded(solids.hit(shape, {"origin": o, "direction": d}))
    return case(rules, comment, flags, {"geometry": shape, "ray": {"origin": o, "direction": d}}, made, "exact" if made is None else compare, DECIMAL)


def ordered_barycentric(p0, p1, p2, v):
    """The coordinates by geometry.triangle.barycentric or geometry.triangle.needle, each operation in binary64 and in the order of the rule; and whether it is the latter."""
    minus = lambda a, b: [x - y for x, y in zip(a, b)]
    dot = lambda a, b: (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    w, s1, s2 = minus(v, p0), minus(p1, p0), minus(p2, p0)
    whole = dot(s1, s1) * dot(s2, s2) - dot(s1, s2) * dot(s1, s2)
    if whole > 2.0**-20 * (dot(s1, s1) * dot(s2, s2)) and all(1e-140 < dot(a, a) < 1e140 for a in (s1, s2)) and dot(w, w) < 1e140:
        return [(dot(w, s1) * dot(s2, s2) - dot(w, s2) * dot(s1, s2)) / whole, (dot(w, s2) * dot(s1, s1) - dot(w, s1) * dot(s1, s2)) / whole], False
    powers = [math.frexp(max(map(abs, a)))[1] for a in (w, s1, s2)]
    w, s1, s2 = ([math.ldexp(x, -k) for x in a] for a, k in zip((w, s1, s2), powers))
    n = cross(s1, s2)
    return [math.ldexp(dot(cross(a, b), n) / dot(n, n), powers[0] - k) for a, b, k in ((w, s2, powers[1]), (s1, w, powers[2]))], True


def needles():
    """Triangles on both sides of the bound of geometry.triangle.needle, with digits enough to tell one way of computing from the other."""
    chance, made = random.Random(51), []
    for size in (1.0, 2.0**15, 2.0**-15, 1e72, 1e-72, 1e69, 1e-69):
        for angle in (2.0**-2, 2.0**-7.5, 2.0**-10, 2.0**-15) if 1e-9 < size < 1e9 else (2.0**-1, 2.0**-2):
            p0, along, off = ([chance.uniform(-1, 1) for _ in range(3)] for _ in range(3))
            p1, p2 = ([(x + (1 + k) * y + k * angle * z) * size for x, y, z in zip(p0, along, off)] for k in (0, 1))
            p0 = [x * size for x in p0]
            t1, t2 = chance.uniform(0, 0.5), chance.uniform(0, 0.5)
            v = [a + t1 * (b - a) + t2 * (c - a) for a, b, c in zip(p0, p1, p2)]
            ok, needle = ordered_barycentric(p0, p1, p2, v)
            made.append(case("geometry.triangle.barycentric geometry.triangle.needle", f"{'By cross products' if needle else 'By D'}: an angle of some {angle:.1g}, edges of some {size:.1g}", "threshold order", {"points": [p0, p1, p2], "point": v}, ok, source=ORDERED))
    # Edges whose numbers are <s1,s1> = <s2,s2> = 1 and, each operation rounded, D = 2^-20: not greater than 2^-20 (<s1,s1> <s2,s2>), so that cross products are taken.
    x, y = math.sqrt(1 - 2.0**-20), 2.0**-10
    points = [[0, 0, 0], [1, 0, 0], [x, y, 0]]
    if x * x + y * y != 1 or 1 - x * x != 2.0**-20:
        raise ValueError("this is not at the bound")
    for _ in range(3):
        while True:
            t1, t2 = chance.uniform(0, 0.5), chance.uniform(0, 0.5)
            v = [t1 + t2 * x, t2 * y, 0]
            ok, needle = ordered_barycentric(*points, v)
            s12, ws1, ws2 = x, v[0], v[0] * x + v[1] * y
            if not needle:
                raise ValueError("this is no needle")
            if ok != [(ws1 - ws2 * s12) / 2.0**-20, (ws2 - ws1 * s12) / 2.0**-20]:
                break
        made.append(case("geometry.triangle.needle", "D is 2^-20 times the product of the squared edges, and no more: by cross products", "threshold strict-comparison", {"points": points, "point": v}, ok, source=ORDERED))
    return made


def edges():
    """Lines that touch an edge of a cube, of each direction, and have no other point in common with it."""
    cube, made = {"kind": "cube", "position": [1, 2, 3], "size": 2}, []
    for along, name in enumerate("xyz"):
        first, second = ((along + 1) % 3, (along + 2) % 3)
        for side in (1, -1):
            o, d = [1.25, 2.25, 3.25], [0, 0, 0]
            o[first], o[second] = cube["position"][first] + 2 * side, cube["position"][second]
            d[first], d[second] = -side, 1
            made.append(hit("geometry.cube.edges geometry.cube.normal", f"An edge along {name} is touched, {'above' if side > 0 else 'below'} in the next coordinate", "strict-comparison edge-order", cube, o, d, "abs:1e-14"))
    return made


def short_axes():
    """Axes whose length cannot be had from squares, along each coordinate: met half way."""
    made = []
    for kind in ("tube", "cylinder"):
        for along in range(3):
            end, o, d, across = [0, 0, 0], [0, 0, 0], [0, 0, 0], 0 if along else 1
            end[along], o[along], o[across], d[across] = 1e-160, 5e-161, 9, -1
            n = [1.0 if i == across else 0.0 for i in range(3)]
            expected = {"t": 8, "point": [5e-161 if i == along else n[i] for i in range(3)], "normal": n, "uv": [0.5, 0.5]}
            sent = {"geometry": {"kind": kind, "point": [[0, 0, 0], end], "ray": 1}, "ray": {"origin": o, "direction": d}}
            made.append(case(f"geometry.axis.length geometry.{kind}.uv geometry.{kind}.normal".replace("cylinder.uv", "tube.uv"), f"A {kind} that is 1e-160 long, along {'xyz'[along]}", "underflow", sent, expected, "abs:1e-14", HAND))
    return made


def tall_lenses():
    """Bulging lenses so tall that the spheres of their faces end within the body: lines that cross the side only, beside such a sphere and through the part of it that is no face."""
    made = []
    for radius, curvature, long in ((3, 5, 40), (3, 3, 20)):
        shape = {"kind": "lens", "point": [[0, 0, 0], [0, 0, long]], "ray": radius, "curvature": [curvature, curvature]}
        depth = math.isqrt(curvature**2 - radius**2)
        for end, centre, inwards in (("first", depth, 1), ("second", long - depth, -1)):
            for away, where in ((curvature + 2.5, "beside the sphere"), (curvature - 1.5, "through the half of the sphere within")):
                for slope in (0.25, -0.25):
                    o = [-5.5, 0.5, centre + inwards * away - 5.5 * slope]
                    comment = f"A tall lens, {where} of the {end} face, {'upwards' if slope > 0 else 'downwards'}, curvature {curvature}"
                    made.append(hit("geometry.lens.body geometry.lens.normal", comment, "long-lens nan", shape, o, [1, 0, slope], "abs:1e-12"))
    return made


def long_triangles():
    """Triangles with one corner near and two far away: the plane is the one through P0, and rounds as the numbers of P0 do."""
    made, near, o = [], [0.25, -0.5, 0.125], [0.7, 0.9, 5]
    for size in (1e7, 1e8):
        for one, two in (([1, 0.3, 0.1], [-0.2, 1, 0.4]), ([-0.7, 0.6, 0.2], [-0.1, -0.9, 0.3])):
            far = [[a + size * b for a, b in zip(near, edge)] for edge in (one, two)]
            d = [round(a + 0.5 * b + 0.25 * c - x, 3) for a, b, c, x in zip(near, one, two, o)]
            for corners in ([near, *far], [near, *far[::-1]]):
                made.append(hit("geometry.triangle.parameters", f"Two corners are {size:.0e} away, the first is near", "cancellation swapped-index", {"kind": "triangle", "point": corners}, o, d, "abs:1e-13"))
    return made


def hits():
    loose = {"t": "abs:1e-8", "point": "abs:1e-8", "normal": "abs:1e-8", "uv": "abs:1e-8"}
    cap = {"kind": "spherical_cap", "ray": 3, "curvature": 5}
    cup = {"kind": "spherical_cap", "ray": 3, "curvature": -5}
    made = []
    for shape, what in ((cap, "a bulging cap"), (cup, "a hollow cap")):
        for o in ([480000.5, -620000.25, 620000.75], [700000.3, 300000.7, -648000.1]):
            toward = [0.5, -1, 0.25 if shape is cap else -0.25]
            d = [float(f"{(b - a) / 1e6:.9f}") for a, b in zip(o, toward)]
            made.append(hit("geometry.cap.parameters geometry.hit.first", f"From 1e6 away, slanting, onto {what}", "far-origin cancellation", shape, o, d, loose))
    lens = {"kind": "lens", "point": [[0, 0, 0], [0, 0, 2]], "ray": 3, "curvature": [5, 5]}
    # The rim is at x = 3, z = 2. Outside of the body by 2^-40, the line keeps its distance from the rim; the overlap is some 2^-47.
    gap = 2.0**-40
    for o, d, where in (([2, 0, 3 + gap], [1, 0, -1], "upper"), ([2, 0, -1 - gap], [1, 0, 1], "lower")):
        made.append(case("geometry.lens.rim geometry.hit.none", f"Past the {where} rim, 2^-40 away from it", "epsilon rim", {"geometry": lens, "ray": {"origin": o, "direction": d}}, None, "exact", HAND))
    # Lines that touch the first rim at (R, 0, 0), by no more than the rounding of the numbers: they meet it, whatever part of it is told.
    for radius, long, curvature, o, slope, t in (
        (2.1, 3.91, [6.12, 4.33], [-1.2999999999999998, 0, -3.4], 1, 3.4),
        (2.14, 0.32, [6.32, 2.34], [1.77, 0, -0.9731], 2.63, 0.37),
        (2.53, 0.61, [6.27, 7.34], [1.8399999999999999, 0, -1.7181], 2.49, 0.69),
    ):
        inside = Fraction(o[2]) + (Fraction(radius) - Fraction(o[0])) * Fraction(slope)
        if not 0 <= inside < Fraction(1, 2**50):
            raise ValueError("the line does not touch the rim")
        expected = {"t": t, "point": [radius, 0, 0], "normal": [1, 0, 0], "uv": [0.5, 1]}
        sent = {"geometry": {"kind": "lens", "point": [[0, 0, 0], [0, 0, long]], "ray": radius, "curvature": curvature}, "ray": {"origin": o, "direction": [1, 0, slope]}}
        made.append(case("geometry.lens.rim", "A line that touches the rim does not slip between face and side", "epsilon rim", sent, expected, {"t": "abs:1e-13", "point": "abs:1e-13", "normal": "abs:2", "uv": "abs:1"}, HAND))
    return made


def at_the_bound():
    """Points whose distance is (1 - k) R, exactly, and none that is less: R is 1 / k, so that (1 - k) R is a whole number. (In binary64, too, the product rounds to it.)"""
    made = []

    def one(rule, shape, point, k):
        size = round(1 / k)
        if Fraction(str(k)) * size != 1 or (1 - k) * size != size - 1:
            raise ValueError("the bound is no whole number")
        made.append(case(f"geometry.{rule} geometry.contains.surface", f"A {shape['kind']}, a point at the very bound is not inside", "strict-comparison epsilon", {"geometry": shape, "point": point}, False, source=EXACT))

    wide, near = 10**7, 10**7 - 1
    one("lens.contains", {"kind": "lens", "point": [[0, 0, 0], [0, 0, wide]], "ray": wide, "curvature": [2 * wide, 2 * wide]}, [near, 0, wide // 2], 1e-7)
    one("cylinder.contains", {"kind": "cylinder", "point": [[0, 0, 0], [0, 0, wide]], "ray": wide}, [0, near, wide // 2], 1e-7)
    one("cone.contains", {"kind": "cone", "point": [[0, 0, 0], [0, 0, wide]], "ray": 2 * wide}, [0, -near, wide // 2], 1e-7)
    one("torus.contains", {"kind": "torus", "major_radius": 3 * wide, "minor_radius": wide}, [3 * wide + near, 0, 0], 1e-7)
    far = 10**10
    one("sphere.contains", {"kind": "sphere", "ray": far}, [0, 0, far - 1], 1e-10)
    one("cube.contains", {"kind": "cube", "size": 2 * far}, [0.5, 1 - far, 0.25], 1e-10)
    return made


# Texts


def checks():
    def triangle(height):
        return f"triangle\npoint 0 0 0\npoint 1 0 0\npoint 1 {language.real(height)} 0\nend\n"

    text = "primitive\nmaterial_name none\n«collinear-points»" + triangle(2.0**-50) + triangle(next_up(2.0**-50)) + "end\nmaterial\nend\n"
    made = [language.check("code.collinear-points numbers.tolerances", "A sine of 2^-50 is on one line, the next number is not.", "epsilon strict-comparison", text)]
    # The cross product of the edges underflows.
    small = 1e-200
    for points, up in (([[0, 0, 0], [small, 0, 0], [0, small, 0]], 1.0), ([[0, 0, 0], [0, small, 0], [small, 0, 0]], -1.0)):
        corners = "".join(f"    point {' '.join(map(language.real, point))}\n" for point in points)
        text = f"primitive\n  material_name none\n  btriangle\n{corners}  end\nend\nmaterial\nend\n"
        written = language.canonical(primitives=[("none", ("btriangle", {"point": points, "normal": [[0, 0, up]] * 3}))], materials=[{}])
        made.append(language.check("shape.btriangle.normals", f"The flat normal of a triangle of the size of 1e-200, {'upwards' if up > 0 else 'downwards'}.", "underflow sign", text, written))
    return made


# Pixels


def pixel(rules, comment, flags, given, expected=None):
    light_pixels.one(rules, comment, flags, given, expected)
    return light_pixels.CASES.pop()


def among_many(given):
    """The same scene with twelve small spheres that no ray of it comes near: more than are worth trying one after the other."""
    far = [("m", {"kind": "sphere", "position": [20 + i, 15, 40], "ray": 0.25}) for i in range(12)]
    return {**given, "shapes": far[:6] + given["shapes"] + far[6:]}


def many():
    def one(rules, comment, flags, given, expected=None):
        return pixel("geometry.hit.index " + rules, comment + ", among many shapes", flags + " index", among_many(given), expected)

    paint = {"color": [0.5, 0.25, 1], "ka": 0, "kd": 1, "ks": 0}
    wall = ("m", PLANE)
    ball = {"kind": "sphere", "position": [-1.5, 0, 1], "ray": 0.5}
    second = {"kind": "sphere", "position": [-3, 0, -1], "ray": 0.5}
    glass, other = {"color": [1, 0.5, 0.25], "kt": 0.75, "ks": 0}, {"color": [0.5, 1, 0.5], "kt": 0.5, "ks": 0}
    dark, inert = [0, 0, 0], {"ka": 0, "kd": 0, "ks": 0}
    made = [
        one("light.source.directional", "Lit", "shadow", scene([wall], {"m": paint}, [SUN])),
        one("light.shadow.opaque", "In the shadow of a sphere", "shadow", scene([wall, ("m", ball)], {"m": paint}, [SUN]), dark),
        one("light.shadow.opaque", "In the shadow of a sphere that stands first", "shadow", scene([("m", ball), wall], {"m": paint}, [SUN]), dark),
        one("light.shadow.beyond", "The sphere is beyond the lamp", "shadow bound", scene([wall, ("m", second)], {"m": paint}, [("point_light", {"position": [-1.5, 0, 1]})])),
        one("light.shadow.opaque", "The sphere is between the lamp and the wall", "shadow bound", scene([wall, ("m", ball)], {"m": paint}, [("point_light", {"position": [-3, 0, -1]})]), dark),
        one("light.shadow.transparent", "Through a coloured glass", "shadow tint", scene([wall, ("g", ball)], {"m": paint, "g": glass}, [SUN])),
        one("light.shadow.product", "Through two coloured glasses", "shadow tint", scene([wall, ("g", ball), ("h", second)], {"m": paint, "g": glass, "h": other}, [SUN])),
        one("light.shadow.opaque-among", "Through a coloured glass, and something opaque", "shadow tint", scene([("g", ball), ("m", second), wall], {"m": paint, "g": glass}, [SUN]), dark),
        one("light.shadow.opaque-among", "The same, the opaque one first", "shadow tint", scene([("m", second), ("g", ball), wall], {"m": paint, "g": glass}, [SUN]), dark),
        one("optics.mirror", "A mirror shows a sphere behind the camera", "mirror", scene([wall, ("p", {"kind": "sphere", "position": [0, 0, -4], "ray": 1})], {"m": {**inert, "kr": 0.5}, "p": {**paint, "ka": 1}}, [AMBIENT], raytracer={"recursive_level": 2})),
    ]
    # Two disks in one place: the first one is seen.
    disk = {"kind": "disk", "position": [0, 0, 3], "ray": 2}
    for names in (["m", "n"], ["n", "m"]):
        made.append(one("geometry.hit.tie", f"Two disks in one place, {'the other' if names[0] == 'n' else 'one'} of them first", "tie", scene([(name, disk) for name in names], {"m": paint, "n": {**paint, "color": [1, 0.5, 0.25]}}, [NOON])))
    # Twelve disks side by side in one plane, all of them over the middle.
    for way in (1, -1):
        row = [("n" if i else "m", {"kind": "disk", "position": [round(way * (0.2 * i - 1.1), 2), 0, 3], "ray": 3}) for i in range(12)]
        given = scene(row, {"m": paint, "n": {**paint, "color": [1, 0.5, 0.25]}}, [NOON])
        made.append(pixel("geometry.hit.index geometry.hit.tie", f"Twelve disks in one plane, from one side to the other, the first at {-1.1 * way:g}", "tie index", given))
    # From inside a glass cube, 45 degrees from the normal of its face.
    cube = {"kind": "cube", "position": [0, 0, 0], "size": 6}
    inside = {"position": [1, 0, 0], "look_at": [2, 0, 1], "near_clipping_plane": 0.5}
    for index, seen in ((1.5, "all is reflected"), (1.25, "the light passes")):
        body = {**inert, "color": [1, 1, 1], "kt": 1, "refractive_index": index}
        given = scene([("g", cube), ("p", {"kind": "plane", "position": [9, 0, 0], "normal": [1, 0, 0]})], {"g": body, "p": {**paint, "ka": 1}, "m": inert}, [AMBIENT], camera=inside, raytracer={"recursive_level": 2})
        made.append(one("optics.medium.start optics.medium.at", f"From inside a body of index {index}: {seen}", "medium", given))
    return made


def within_many():
    """Where rays are inside of bodies, among many shapes, far from the origin and from the places of `many`: a glass cube, and a glass sphere in it."""
    inert = {"ka": 0, "kd": 0, "ks": 0}
    made = []
    for x, y, z in ((-9, -7, -12), (30, -20, 11)):
        glass = lambda index: {**inert, "color": [1, 1, 1], "kt": 1, "refractive_index": index}
        cube = {"kind": "cube", "position": [x, y, z], "size": 6}
        wall = {"kind": "plane", "position": [x + 9, y, z], "normal": [1, 0, 0]}
        light = {**inert, "color": [0.5, 0.25, 1], "ka": 1}
        # 45 degrees from the normal of the face at x + 3.
        camera = {"position": [x + 1, y, z], "look_at": [x + 2, y, z + 1], "near_clipping_plane": 0.5}
        for index, seen in ((1.5, "all is reflected"), (1.25, "the light passes")):
            given = scene([("g", cube), ("p", wall)], {"g": glass(index), "p": light}, [AMBIENT], camera=camera, raytracer={"recursive_level": 2})
            made.append(pixel("geometry.hit.index optics.medium.start", f"From inside a body of index {index} around {(x, y, z)}: {seen}, among many shapes", "medium index", among_many(given)))
        # Out of a sphere of index 1 into the cube around it: the ray goes on as the cube's index bends it, and the narrow disk behind the cube is met or missed.
        ball = {"kind": "sphere", "position": [x, y, z], "ray": 1}
        camera = {"position": [x - 1, y + 0.5, z], "look_at": [x, y + 0.5, z], "near_clipping_plane": 0.5}
        for index in (1.25, 2):
            for high in (0.25, 0.5, 0.75):
                spot = {"kind": "disk", "position": [x + 2.5, y + high, z], "normal": [1, 0, 0], "ray": 0.125}
                given = scene([("g", cube), ("b", ball), ("p", spot)], {"g": glass(index), "b": glass(1.0625), "p": light}, [AMBIENT], camera=camera, raytracer={"recursive_level": 2})
                made.append(pixel("geometry.hit.index optics.medium.at", f"Out of a sphere into the glass of index {index} around it, around {(x, y, z)}, to a height of {high}, among many shapes", "medium index", among_many(given)))
    return made


def open_glass():
    """Transparent shapes that are not closed: no ray goes on behind them."""
    glass, wall = {"color": [1, 1, 1], "ka": 0, "kd": 0, "ks": 0, "kt": 1}, {"kind": "plane", "position": [0, 0, 20]}
    corners = [[-2, -2, 3], [2, -2, 3], [0.25, 3, 3]]
    made = []
    for shape in (
        {"kind": "plane", "position": [0, 0, 3]},
        {"kind": "disk", "position": [0, 0, 3], "ray": 1},
        {"kind": "annulus", "position": [0, 0.75, 3], "ray": 1, "inner_ray": 0.25},
        {"kind": "triangle", "point": corners},
        {"kind": "btriangle", "point": corners},
        {"kind": "tube", "point": [[-2, 0, 4], [2, 0, 4]], "ray": 1},
        {"kind": "spherical_cap", "position": [0, 0, 3], "ray": 1, "curvature": 2},
        {"kind": "geometry", "scale": [2, 2, 2], "geometry": {"kind": "btriangle", "point": [[x / 2 for x in corner] for corner in corners]}},
    ):
        given = scene([("g", shape), ("m", wall)], {"g": glass, "m": {"color": [0.5, 0.25, 1], "ka": 1, "kd": 0, "ks": 0}}, [AMBIENT], raytracer={"recursive_level": 3})
        made.append(pixel("optics.body.closed", f"A transparent {shape['kind']} is not a body", "closed", given, [0, 0, 0]))
    return made


def flat_random():
    """Without light, a random point of each pixel: column and row of it are two numbers, not one. A cube fills the half of the picture above the middle."""
    made = []
    for above in (True, False):
        seed = next(s for s in range(1000) if (uniform(s, 0) > 0.75 and uniform(s, 1) < 0.25 if above else uniform(s, 0) < 0.25 and uniform(s, 1) > 0.75))
        text = (f"viewport\n  width 1\n  height 1\nend\nraytracer\n  reflexion_algorithm no_light\n  pixel_coordinate random\n  seed {seed}\nend\n"
                "primitive\n  material_name m\n  cube\n    position 0 20 30\n    size 40\n  end\nend\nmaterial\n  name m\n  color 0.5 0.25 1\n  kd 1\nend\n")
        ok = [128, 64, 255, 255] if above else [0, 0, 0, 255]
        made.append(case("camera.random light.algorithm.no-light", f"Without light, the random point of a pixel is {'above' if above else 'below'} the middle.", "random swapped-index", {"text": text, "column": 0, "row": 0}, ok, source=HAND))
    return made


def operations():
    return {"roots.cubic": cubics(), "roots.quartic": quartics(), "intersect.cones": far_cones(), "geometry.hit": hits() + edges() + short_axes() + tall_lenses() + long_triangles(), "geometry.contains": at_the_bound(), "scene.check": checks(), "triangle.barycentric": needles(), "scene.pixel": many() + open_glass() + flat_random() + within_many()}


if __name__ == "__main__":
    main(sys.modules[__name__])
