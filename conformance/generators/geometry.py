#!/usr/bin/env python3
"""Positions on rays, where lines meet surfaces, and barycentric coordinates.

Where a rule fixes the order of operations, so down to the coefficients of a quadratic, Python's floats compute what it says; the roots of those very coefficients are then
taken in fractions and decimals. The parameters of a torus are the roots of its quartic with exact coefficients.
"""

import math
import random
import sys

sys.dont_write_bytecode = True

import solids  # noqa: E402
import suite  # noqa: E402
from suite import DECIMAL, HAND, ORDERED, add, case, cross, decimal, decimals, dot, exact, nearest, next_up, sub, times  # noqa: E402

COEFFICIENTS = "binary64 coefficients in the order of the rule, their exact roots"


def some(chance, low, high, places=3):
    return round(chance.uniform(low, high), places)


def vector(chance, size, places=3):
    return [some(chance, -size, size, places) for _ in range(3)]


def unit(a):
    """`vector.normalize` in binary64."""
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def floats(a):
    return [float(x) for x in a]


def ray(origin, direction):
    return {"origin": origin, "direction": direction}


# ray.position


def positions():
    made = []

    def one(comment, flags, o, d, t):
        expected = [float(x) + float(t) * float(y) for x, y in zip(o, d)]
        made.append(case("geometry.ray.position" + (" geometry.ray.direction" if "length" in flags else ""), comment, flags, {"ray": ray(o, d), "t": t}, expected, source=ORDERED))

    one("Parameter 0 is the origin", "origin-lost", [1, 2, 3], [4, 5, 6], 0)
    one("Parameter 1 is origin plus direction", "direction-normalized", [1, 2, 3], [4, 5, 6], 1)
    one("The parameter counts in lengths of the direction", "length direction-normalized", [0, 0, 0], [0, 3, 4], 2)
    one("The parameter counts in lengths of a short direction", "length direction-normalized", [1, 1, 1], [0.25, 0, -0.125], 8)
    one("A direction ten times as long", "length direction-normalized", [1, -1, 0.5], [10, 20, 20], 0.1)
    one("A negative parameter lies behind", "negative-clamped", [1, 2, 3], [1, 0, -1], -2)
    one("Only x moves", "swapped-coordinate", [10, 20, 30], [1, 0, 0], 5)
    one("Only y moves", "swapped-coordinate", [10, 20, 30], [0, 1, 0], 5)
    one("Only z moves", "swapped-coordinate", [10, 20, 30], [0, 0, 1], 5)
    one("Each coordinate has its own sign", "sign", [1, -2, 3], [-4, 5, -6], 0.5)
    one("A fused product and sum would leave 2^-54 in x", "fused", [-1, 0, 0], [next_up(1.0), 0, 0], next_up(1.0, -1))
    one("A fused product and sum would leave 2^-60 in y", "fused", [0, -1, 0], [0, 1 + 2.0**-30, 0], 1 - 2.0**-30)
    one("A fused product and sum would not give 0 in z", "fused", [0, 0, -1.0000000018626451], [0, 0, 1 + 2.0**-30], 1 + 2.0**-30)
    one("0.1 times 3 rounds before the sum", "fused", [-0.3, 0.3, 0], [0.1, -0.1, 0], 3)
    one("The smaller summand is lost", "rounding", [1e16, -1e16, 1], [1, 1, 1e-17], 1)
    one("Ties go to even", "rounding", [1e16, 1e16, 0], [1, 3, 0], 1)
    one("Large numbers", "overflow", [1e100, 0, 0], [0, 1e100, -1e100], 1e100)
    one("Small numbers", "underflow", [0, 0, 1e-300], [1e-300, 1e-160, 0], 1e-10)
    one("A subnormal result", "underflow", [0, 0, 0], [1e-310, -1e-310, 0], 0.5)
    one("The sum cancels to nothing", "sign", [1, 2, 3], [-0.5, -1, -1.5], 2)
    chance = random.Random(501)
    for i in range(14):
        one("Numbers of all digits", "fused rounding", [chance.uniform(-9, 9) for _ in range(3)], [chance.uniform(-2, 2) for _ in range(3)], chance.uniform(-20, 20))
    return made


# Planes


def plane_parameters(o, d, p, n):
    o, d, p, n = floats(o), floats(d), floats(p), unit(floats(n))
    a, b = dot(n, d), dot(n, sub(o, p))
    return [(0 - b / a) + 0.0] if a * a > 2.0**-100 * dot(d, d) else []


def planes():
    made = []

    def one(rules, comment, flags, o, d, p, n, expected=None):
        computed = plane_parameters(o, d, p, n)
        if expected is not None and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case(["geometry.plane." + rule if "." not in rule else rule for rule in rules.split()], comment, flags, {"ray": ray(o, d), "position": p, "normal": n}, computed, source=ORDERED))

    one("parameters", "From above", "sign", [0, 0, 5], [0, 0, -1], [0, 0, 0], [0, 0, 1], [5.0])
    one("parameters", "From below, against the normal", "sign one-sided", [0, 0, -5], [0, 0, 1], [0, 0, 0], [0, 0, 1], [5.0])
    one("parameters geometry.ray.line", "Behind the origin: negative parameters are listed", "negative-dropped", [0, 0, 5], [0, 0, 1], [0, 0, 0], [0, 0, 1], [-5.0])
    one("parameters", "From the plane itself the parameter is 0", "negative-zero", [3, 4, 0], [0, 0, 1], [0, 0, 0], [0, 0, 1], [0.0])
    one("parameters geometry.ray.direction", "A direction of length 2 halves the parameter", "direction-normalized", [0, 0, 5], [0, 0, -2], [0, 0, 1], [0, 0, 1], [2.0])
    one("parameters geometry.ray.direction", "A direction of length 1/4", "direction-normalized", [0, 0, 5], [0, 0, -0.25], [0, 0, 1], [0, 0, 1], [16.0])
    one("parameters", "A plane along x", "swapped-coordinate", [1, 2, 3], [2, 0, 0], [9, 7, 5], [1, 0, 0], [4.0])
    one("parameters", "A plane along y", "swapped-coordinate", [1, 2, 3], [0, 2, 0], [9, 8, 5], [0, 1, 0], [3.0])
    one("parameters", "The position counts only along the normal", "position-ignored", [0, 0, 10], [0, 0, -1], [100, -50, 4], [0, 0, 1], [6.0])
    one("unit-normal", "A long normal gives the same parameter", "normal-not-unit", [0, 0, 7], [0, 0, -1], [0, 0, 1], [0, 0, 1000], [6.0])
    one("unit-normal", "A short normal gives the same parameter", "normal-not-unit", [0, 0, 7], [0, 0, -1], [0, 0, 1], [0, 0, 1e-9], [6.0])
    one("unit-normal", "A normal of length 1e-10 is long enough", "normal-too-short", [0, 0, 7], [0, 0, -1], [0, 0, 1], [0, 0, 1e-10], [6.0])
    one("unit-normal", "A normal of length 1e90", "overflow", [0, 0, 7], [0, 0, -1], [0, 0, 1], [0, 0, 1e90], [6.0])
    one("unit-normal parallel", "A long normal does not make a parallel line meet the plane", "normal-not-unit", [0, 0, -1], [1, 0, 2.0**-50], [0, 0, 0], [0, 0, 1e6], [])
    one("unit-normal parallel", "A short normal does not hide a line that meets the plane", "normal-not-unit", [0, 0, -1], [1, 0, 2.0**-40], [0, 0, 0], [0, 0, 1e-8], [2.0**40])
    one("parallel", "A line in the plane does not meet it", "in-plane", [5, 1, 0], [1, 0, 0], [0, 0, 0], [0, 0, 1], [])
    one("parallel", "A line beside the plane does not meet it", "division-by-zero", [5, 1, 2], [1, 1, 0], [0, 0, 0], [0, 0, 1], [])
    one("parallel", "The sine is 2^-50 exactly: parallel", "strict-comparison epsilon", [0, 0, -1], [1, 0, 2.0**-50], [0, 0, 0], [0, 0, 1], [])
    one("parallel", "The sine is one ulp above 2^-50: met", "epsilon", [0, 0, -1], [1, 0, next_up(2.0**-50)], [0, 0, 0], [0, 0, 1], [1 / next_up(2.0**-50)])
    one("parallel", "The sine is -2^-50 exactly: parallel", "strict-comparison epsilon", [0, 0, 1], [1, 0, -(2.0**-50)], [0, 0, 0], [0, 0, 1], [])
    one("parallel", "A negative sine of 2^-49: met", "sign epsilon", [0, 0, 1], [1, 0, -(2.0**-49)], [0, 0, 0], [0, 0, 1], [2.0**49])
    one("parallel", "With a direction of length 8, 2^-47 is a sine of 2^-50: parallel", "epsilon direction-length", [0, 0, -1], [8, 0, 2.0**-47], [0, 0, 0], [0, 0, 1], [])
    one("parallel", "With a direction of length 8, 2^-46 is met", "epsilon direction-length", [0, 0, -1], [8, 0, 2.0**-46], [0, 0, 0], [0, 0, 1], [2.0**46])
    one("parallel", "With a direction of length 2^-20, 2^-69 is met", "epsilon direction-length", [0, 0, -1], [0, 2.0**-20, 2.0**-69], [0, 0, 0], [0, 0, 1], [2.0**69])
    one("parallel", "With a direction of length 2^-20, 2^-70 is parallel", "epsilon direction-length", [0, 0, -1], [0, 2.0**-20, 2.0**-70], [0, 0, 0], [0, 0, 1], [])
    one("parallel", "1e-12 is not parallel", "epsilon", [0, 0, -1], [1, 0, 1e-12], [0, 0, 0], [0, 0, 1], [1 / 1e-12])
    one("parallel", "1e-8 is not parallel", "epsilon", [0, 0, -1], [1, 0, 1e-8], [0, 0, 0], [0, 0, 1], [1 / 1e-8])
    one("parallel", "Parallel to an oblique plane, exactly", "noise", [1, 1, 1], [0.8, -0.6, 0], [0, 0, 0], [0.6, 0.8, 0], [])
    one("geometry.hit.finite", "A parameter of 1e113 is a parameter", "overflow", [0, 0, 1e100], [1, 0, -1e-13], [0, 0, 0], [0, 0, 1], [-(0 - 1e100 / 1e-13) + 0.0])
    chance = random.Random(502)
    found = 0
    while found < 5:
        n = [chance.randint(-9, 9) for _ in range(3)]
        d = [chance.randint(-9, 9) for _ in range(2)]
        if n[2] == 0 or n[0] == n[1] == 0 or d == [0, 0]:
            continue
        d = [d[0] * n[2], d[1] * n[2], -(n[0] * d[0] + n[1] * d[1])]
        sine = dot(unit(floats(n)), floats(d))
        if sine != 0 and not plane_parameters([1, 2, 3], d, [0, 0, 0], n):
            one("parallel", "Parallel: <n, d> is not 0, but no more than rounding", "noise epsilon", [1, 2, 3], d, [0, 0, 0], n, [])
            found += 1
    for i in range(12):
        one("parameters", "Oblique, whole numbers", "sign order", [chance.randint(-9, 9) for _ in range(3)], [chance.randint(-4, 4) for _ in range(2)] + [5], [chance.randint(-9, 9) for _ in range(3)],
            [chance.randint(-4, 4) for _ in range(2)] + [7])
    for i in range(12):
        one("parameters unit-normal", "Oblique, numbers of all digits: the order of operations shows", "order fused normal-not-unit", [chance.uniform(-9, 9) for _ in range(3)], [chance.uniform(-2, 2) for _ in range(3)],
            [chance.uniform(-9, 9) for _ in range(3)], [chance.uniform(-2, 2) for _ in range(3)])
    return made


# Quadrics: the coefficients in binary64, then the exact roots


def quadratic(a, b, c):
    """The roots of the polynomial with these very binary64 coefficients, each the nearest binary64 number."""
    a, b, c = exact(a), exact(b), exact(c)
    if a == 0:
        return [nearest(-c / b) + 0.0] if b != 0 else []
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return []
    with_root = suite.dsqrt(discriminant)
    root = suite.integer_root(discriminant)
    if root is not None:
        return sorted(nearest(x) + 0.0 for x in ((-b - root) / (2 * a), (-b + root) / (2 * a)))
    big = -(decimal(b) + (with_root if b >= 0 else -with_root)) / 2
    return sorted(nearest(x) for x in (big / decimal(a), decimal(c) / big))


def textbook(a, b, c):
    """How many roots the formula finds whose discriminant is rounded."""
    d = b * b - 4 * a * c
    return 0 if d < 0 else 2


def sphere_coefficients(o, d, c, r):
    w = sub(floats(o), floats(c))
    d = floats(d)
    return dot(d, d), 2 * dot(w, d), dot(w, w) - float(r) * float(r)


def spheres():
    made = []

    def one(rules, comment, flags, o, d, c, r, compare="ulp:4", expected=None):
        computed = quadratic(*sphere_coefficients(o, d, c, r))
        if expected is not None and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case(["geometry.sphere." + rule if "." not in rule else rule for rule in rules.split()], comment, flags, {"ray": ray(o, d), "position": c, "radius": r}, computed, compare, COEFFICIENTS))

    one("parameters geometry.ray.line", "In front: both parameters, ascending", "unsorted", [-5, 0, 0], [1, 0, 0], [0, 0, 0], 2, expected=[3.0, 7.0])
    one("parameters geometry.ray.line", "Behind: both parameters are negative, ascending", "unsorted negative-dropped", [5, 0, 0], [1, 0, 0], [0, 0, 0], 2, expected=[-7.0, -3.0])
    one("parameters geometry.ray.line", "From inside: one of each sign", "negative-dropped", [0, 0, 0.5], [0, 0, 1], [0, 0, 0], 1, expected=[-1.5, 0.5])
    one("parameters", "From the centre", "b-zero", [1, 2, 3], [0, 1, 0], [1, 2, 3], 4, expected=[-4.0, 4.0])
    one("parameters", "From the surface inwards", "zero-root", [0, 0, 1], [0, 0, -1], [0, 0, 0], 1, expected=[0.0, 2.0])
    one("parameters", "From the surface outwards", "zero-root", [0, 0, 1], [0, 0, 1], [0, 0, 0], 1, expected=[-2.0, 0.0])
    one("parameters", "Beside the sphere", "missing", [-5, 3, 0], [1, 0, 0], [0, 0, 0], 2, expected=[])
    one("parameters geometry.ray.direction", "A direction of length 5", "direction-normalized", [0, -15, -20], [0, 3, 4], [0, 0, 0], 5, expected=[4.0, 6.0])
    one("parameters geometry.ray.direction", "A direction of length 1/8", "direction-normalized", [0, 0, -3], [0, 0, 0.125], [0, 0, 0], 1, expected=[16.0, 32.0])
    one("parameters", "The centre along y", "position-ignored swapped-coordinate", [1, 0, 1], [0, 1, 0], [1, 10, 1], 3, expected=[7.0, 13.0])
    one("parameters", "The centre along z", "position-ignored swapped-coordinate", [1, 2, 0], [0, 0, 1], [1, 2, -10], 3, expected=[-13.0, -7.0])
    one("parameters", "The radius is squared", "radius-not-squared", [-10, 0, 0], [1, 0, 0], [0, 0, 0], 4, expected=[6.0, 14.0])
    one("parameters", "A radius below 1 is squared", "radius-not-squared", [-10, 0, 0], [1, 0, 0], [0, 0, 0], 0.25, expected=[9.75, 10.25])
    for o, d in (([-3, 1, 0], [1, 0, 0]), ([0, 2, 1], [0, -1, 0]), ([1, 0, -7], [0, 0, 2]), ([-3, -1, 0], [1, 0, 0])):
        one("tangent geometry.ray.line", "A tangent meets the sphere twice at one parameter", "double-root", o, d, [0, 0, 0], 1)
    one("tangent", "A slanted tangent: 3, 4, 5", "double-root", [7, 1, 0], [-4, 3, 0], [0, 0, 0], 5, expected=[1.0, 1.0])
    one("tangent", "A tangent of a sphere far from the origin", "double-root", [95, 103, 200], [1, 0, 0], [100, 100, 200], 3, expected=[5.0, 5.0])
    one("tangent", "Above the tangent by one ulp: none", "epsilon", [-1, 0, next_up(1.0)], [1, 0, 0], [0, 0, 0], 1, expected=[])
    one("tangent", "Below the tangent by one ulp: two", "epsilon", [-1, 0, next_up(1.0, -1)], [1, 0, 0], [0, 0, 0], 1)
    one("tangent", "Above the tangent by 1e-10: none", "epsilon", [-1, 0, 1.0000000001], [1, 0, 0], [0, 0, 0], 1, expected=[])
    one("tangent", "Below the tangent by 1e-10: two", "epsilon merged", [-1, 0, 0.9999999999], [1, 0, 0], [0, 0, 0], 1)
    one("parameters", "From 2^28 away the radius 1 is lost in <w, w>: one parameter, twice", "order", [-(2.0**28), 0, 0], [1, 0, 0], [0, 0, 0], 1, expected=[2.0**28, 2.0**28])
    one("parameters", "From 2^26 away it is not", "order", [-(2.0**26), 0, 0], [1, 0, 0], [0, 0, 0], 1, expected=[2.0**26 - 1, 2.0**26 + 1])
    one("parameters", "R R is rounded before it leaves <w, w>", "order fused", [-0.3, 0, 0], [1, 0, 0], [0, 0, 0], 0.3)
    one("parameters", "R R is rounded before it leaves <w, w>: (w - R)(w + R) is something else", "order", [-0.7, 0, 0], [0.1, 0, 0], [0, 0, 0], 0.7000000000000001)
    one("parameters", "Large", "overflow", [-3e100, 0, 0], [1, 0, 0], [0, 0, 0], 1e100)
    one("parameters", "Small", "underflow", [-3e-60, 0, 0], [1, 0, 0], [0, 0, 0], 1e-60)
    one("parameters", "A huge direction", "overflow", [-3, 0, 0], [1e100, 0, 0], [0, 0, 0], 1)
    one("parameters", "Just outside: the near parameter is tiny, and keeps its digits", "catastrophic-cancellation", [-1.000000001, 0, 0], [1, 0, 0], [0, 0, 0], 1)
    one("parameters", "Just inside: the negative parameter is tiny", "catastrophic-cancellation", [-0.999999999, 0, 0], [1, 0, 0], [0, 0, 0], 1)
    chance = random.Random(503)
    for i in range(14):
        c, r = vector(chance, 4), some(chance, 0.5, 3)
        o = vector(chance, 12)
        d = [round(x + chance.uniform(-0.6, 0.6) * r - y, 3) for x, y in zip(c, o)]
        one("parameters", "A line through the sphere", "sign order", o, d, c, r)
    found = 0
    while found < 10:  # grazing lines at which rounding the discriminant goes wrong
        r = float(chance.randint(3, 40))
        o = [float(chance.randint(-10**7, 10**7)) for _ in range(3)]
        d = [float(chance.randint(-10**6, 10**6)) for _ in range(3)]
        along = sub(times(-dot(o, d) / dot(d, d), d), times(-1.0, o))
        far = math.sqrt(dot(along, along))
        c = [float(round(x)) for x in times((far - r) / far, along)]
        a, b, k = sphere_coefficients(o, d, c, r)
        if abs(exact(b) ** 2 - 4 * exact(a) * exact(k)) < exact(b) ** 2 / 2**49 and textbook(a, b, k) != len(quadratic(a, b, k)) or chance.random() < 1e-4:
            one("tangent", "A grazing line: the sign of the discriminant is that of the exact one, not of the rounded one", "rounded-discriminant", o, d, c, r)
            found += 1
    return made


def tube_coefficients(o, d, p, s, r):
    s, d, w = unit(floats(s)), floats(d), sub(floats(o), floats(p))
    perp = lambda a: cross(s, cross(a, s))
    wp, dp = perp(w), perp(d)
    return dot(dp, dp), 2 * dot(wp, dp), dot(wp, wp) - float(r) * float(r)


def tubes():
    made = []

    def one(rules, comment, flags, o, d, p, s, r, expected=None):
        computed = quadratic(*tube_coefficients(o, d, p, s, r))
        if expected is not None and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case(["geometry.tube." + rule if "." not in rule else rule for rule in rules.split()], comment, flags, {"ray": ray(o, d), "point": p, "axis": s, "radius": r}, computed, "ulp:4", COEFFICIENTS))

    z = [0, 0, 1]
    one("line-parameters geometry.ray.line", "Across the axis: both, ascending", "unsorted", [-3, 0, 7], [1, 0, 0], [0, 0, 0], z, 1, [2.0, 4.0])
    one("line-parameters geometry.ray.line", "Behind: both negative", "negative-dropped", [3, 0, 7], [1, 0, 0], [0, 0, 0], z, 1, [-4.0, -2.0])
    one("line-parameters", "The tube has no ends", "bounded", [-3, 0, 1e6], [1, 0, 0], [0, 0, 0], z, 1, [2.0, 4.0])
    one("line-parameters", "What the direction has along the axis does not count", "along-axis-kept", [-3, 0, 0], [1, 0, 5], [0, 0, 0], z, 1, [2.0, 4.0])
    one("line-parameters", "What the origin has along the axis does not count", "along-axis-kept", [-3, 0, -50], [1, 0, 0], [0, 0, 9], z, 2, [1.0, 5.0])
    one("line-parameters geometry.ray.direction", "A direction of length 4", "direction-normalized", [-8, 0, 0], [4, 0, 0], [0, 0, 0], z, 4, [1.0, 3.0])
    one("line-parameters", "A tube along x", "swapped-coordinate", [9, -5, 1], [0, 1, 0], [0, 0, 1], [1, 0, 0], 2, [3.0, 7.0])
    one("line-parameters", "A tube along y", "swapped-coordinate", [1, 9, -5], [0, 0, 1], [1, 0, 0], [0, 1, 0], 2, [3.0, 7.0])
    one("line-parameters", "A long axis is made unit", "axis-not-unit", [-3, 0, 7], [1, 0, 0], [0, 0, 0], [0, 0, 100], 1, [2.0, 4.0])
    one("line-parameters", "A short axis is made unit", "axis-not-unit", [-3, 0, 7], [1, 0, 0], [0, 0, 0], [0, 0, 0.01], 1, [2.0, 4.0])
    one("line-parameters", "The axis the other way round", "sign", [-3, 0, 7], [1, 0, 0], [0, 0, 0], [0, 0, -1], 1, [2.0, 4.0])
    one("line-parameters", "From the axis", "b-zero", [0, 0, 3], [0, 2, 0], [0, 0, 0], z, 3, [-1.5, 1.5])
    one("line-parameters", "From the surface", "zero-root", [1, 0, 0], [-1, 0, 0], [0, 0, 0], z, 1, [0.0, 2.0])
    one("line-parameters", "Beside the tube", "missing", [-3, 2, 0], [1, 0, 0], [0, 0, 0], z, 1, [])
    one("line-parameters geometry.ray.line", "A tangent, twice", "double-root", [-3, 1, 0], [1, 0, 0], [0, 0, 0], z, 1, [3.0, 3.0])
    one("line-parameters", "A slanted tangent", "double-root", [-3, -1, 0], [1, 0, 7], [0, 0, 0], z, 1, [3.0, 3.0])
    one("line-parameters", "A tangent from 3, 4, 5", "double-root", [7, 1, 5], [-4, 3, 1], [0, 0, 0], z, 5, [1.0, 1.0])
    one("line-parameters", "One ulp beside a tangent: none", "epsilon", [-1, next_up(1.0), 0], [1, 0, 0], [0, 0, 0], z, 1, [])
    one("line-parameters", "One ulp inside a tangent: two", "epsilon", [-1, next_up(1.0, -1), 0], [1, 0, 0], [0, 0, 0], z, 1)
    one("along-axis", "Along the axis, in the surface: none", "degenerate", [1, 0, 0], z, [0, 0, 0], z, 1, [])
    one("along-axis", "Along the axis, inside: none", "degenerate division-by-zero", [0.5, 0, 0], z, [0, 0, 0], z, 1, [])
    one("along-axis", "Along the axis, outside: none", "degenerate division-by-zero", [3, 0, 0], z, [0, 0, 0], z, 1, [])
    one("along-axis", "Against the axis, on it: none", "degenerate", [0, 0, 0], [0, 0, -2], [0, 0, 0], z, 1, [])
    one("along-axis", "Along an axis of x: none", "degenerate", [0, 1, 0], [3, 0, 0], [0, 0, 0], [1, 0, 0], 1, [])
    one("along-axis", "Nearly along the axis: two, far away", "epsilon", [0, 0, 0], [2.0**-30, 0, 1], [0, 0, 0], z, 1, [-(2.0**30), 2.0**30])
    one("line-parameters", "From afar", "order", [-1e7, 0.25, 3], [1, 0, 0.5], [0, 0, 0], z, 1)
    one("line-parameters", "A tiny tube", "underflow", [-3e-50, 0, 0], [1, 0, 0], [0, 0, 0], z, 1e-50)
    one("line-parameters", "A huge tube", "overflow", [-3e90, 0, 0], [1, 0, 0], [0, 0, 0], z, 1e90)
    chance = random.Random(504)
    for i in range(18):
        p, s, r = vector(chance, 3), vector(chance, 3), some(chance, 0.5, 3)
        o = vector(chance, 9)
        d = [round(x + k * 1.5 + chance.uniform(-0.5, 0.5) * r - y, 3) for x, k, y in zip(p, s, o)]
        one("line-parameters", "An oblique tube", "order sign axis-not-unit", o, d, p, s, r)
    return made


def cones_coefficients(o, d, point, apex, r):
    g, w, d, r = sub(floats(apex), floats(point)), sub(floats(o), floats(apex)), floats(d), float(r)
    gg, dg, wg = dot(g, g), cross(d, g), cross(w, g)
    d1, w1 = r * dot(d, g), r * dot(w, g)
    return gg * dot(dg, dg) - d1 * d1, 2 * (gg * dot(wg, dg) - w1 * d1), gg * dot(wg, wg) - w1 * w1


def cones():
    made = []

    def one(rules, comment, flags, o, d, point, apex, r, expected=None):
        computed = quadratic(*cones_coefficients(o, d, point, apex, r))
        if expected is not None and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case(["geometry.cones." + rule if "." not in rule else rule for rule in rules.split()], comment, flags, {"ray": ray(o, d), "point": point, "apex": apex, "radius": r}, computed, "ulp:4", COEFFICIENTS))

    p, a = [0, 0, 0], [0, 0, 1]
    one("parameters geometry.ray.line", "Through the base, ascending", "unsorted", [-2, 0, 0], [1, 0, 0], p, a, 1, [1.0, 3.0])
    one("parameters", "Beyond the apex: the other half", "half-missing", [-2, 0, 2], [1, 0, 0], p, a, 1, [1.0, 3.0])
    one("parameters", "Below the base: unbounded", "bounded", [-9, 0, -3], [1, 0, 0], p, a, 1, [5.0, 13.0])
    one("parameters", "Through the apex, twice", "double-root", [-2, 0, 1], [1, 0, 0], p, a, 1, [2.0, 2.0])
    one("parameters", "Through the apex along the axis, twice", "double-root", [0, 0, 5], [0, 0, -1], p, a, 1, [4.0, 4.0])
    one("parameters", "Through the apex, slanted, twice", "double-root", [0, 1, 3], [0, -0.5, -1], p, a, 1, [2.0, 2.0])
    one("parameters", "Steeper than the surface: from one half into the other", "sign-of-a", [0.5, 0, 3], [0, 0, -1], p, a, 1, [1.5, 2.5])
    one("parameters geometry.ray.direction", "A direction of length 2", "direction-normalized", [-2, 0, 0], [2, 0, 0], p, a, 1, [0.5, 1.5])
    one("parameters", "A wide cone: the radius counts at the point", "radius-ignored", [-9, 0, 0], [1, 0, 0], p, [0, 0, 1], 4, [5.0, 13.0])
    one("parameters", "A tall cone: the height counts", "height-ignored", [-9, 0, 2], [1, 0, 0], p, [0, 0, 4], 4, [7.0, 11.0])
    one("parameters", "Along x", "swapped-coordinate", [0, -9, 0], [0, 1, 0], [0, 0, 0], [2, 0, 0], 4, [5.0, 13.0])
    one("parameters", "Along y, the apex below", "swapped-coordinate sign", [-9, 1, 0], [1, 0, 0], [0, 2, 0], [0, 0, 0], 4, [7.0, 11.0])
    one("parameters", "From afar the point and the apex are not mixed up", "swapped", [-9, 0, 1], [1, 0, 0], [0, 0, 3], [0, 0, 2], 1, [8.0, 10.0])
    one("parameters", "Beside one half: none, as the line is across the axis beyond the radius", "missing", [-9, 2, 0], [1, 0, 0], p, a, 1, [])
    one("parameters", "A tangent, twice", "double-root", [-9, 1, 0], [1, 0, 0], p, a, 1, [9.0, 9.0])
    one("parameters", "One ulp beside a tangent: none", "epsilon", [-1, next_up(1.0), 0], [1, 0, 0], p, a, 1, [])
    one("parameters", "One ulp inside: two", "epsilon", [-1, next_up(1.0, -1), 0], [1, 0, 0], p, a, 1)
    one("parallel", "Parallel to the surface: one", "parallel", [-2, 0, 0], [1, 0, 1], p, a, 1, [1.5])
    one("parallel", "Parallel to the surface, the other way", "parallel", [2, 0, 0], [1, 0, -1], p, a, 1)
    one("parallel", "Parallel, from above", "parallel sign", [0, 2, 4], [0, 1, -1], p, a, 1)
    one("parallel", "Parallel to a cone of 3, 4, 5", "parallel", [-9, 0, 0], [3, 0, 4], p, [0, 0, 4], 3)
    one("parallel", "A line in the surface: none", "in-surface", [-1, 0, 0], [1, 0, 1], p, a, 1, [])
    one("parallel", "Another line in the surface: none", "in-surface", [0, 2, -1], [0, -2, 2], p, a, 1, [])
    one("parallel", "A line in the surface of a cone of 3, 4, 5: none", "in-surface", [3, 0, 0], [-3, 0, 4], p, [0, 0, 4], 3, [])
    one("parallel", "Nearly parallel: two, one far away", "epsilon", [-2, 0, 0], [1, 0, 1 + 2.0**-20], p, a, 1)
    one("parameters", "The two points are equal: none", "degenerate division-by-zero", [-2, 0, 0], [1, 0, 0], [1, 2, 3], [1, 2, 3], 1, [])
    one("parameters", "From the apex along the axis: 0 twice", "zero-root", [0, 0, 1], [0, 0, 1], p, a, 1, [0.0, 0.0])
    one("parameters", "From the surface", "zero-root", [1, 0, 0], [-1, 0, 0], p, a, 1, [0.0, 2.0])
    one("parameters", "Moved away from the origin", "position-ignored", [8, 20, 30], [1, 0, 0], [10, 20, 30], [10, 20, 31], 1, [1.0, 3.0])
    one("parameters", "A large cone", "overflow", [-2e20, 0, 0], [1, 0, 0], p, [0, 0, 1e20], 1e20)
    one("parameters", "A small cone", "underflow", [-2e-20, 0, 0], [1, 0, 0], p, [0, 0, 1e-20], 1e-20)
    chance = random.Random(505)
    while len(made) < 50:
        point, apex, r = [chance.randint(-4, 4) for _ in range(3)], [chance.randint(-4, 4) for _ in range(3)], some(chance, 0.5, 4, 2)
        o, d = vector(chance, 9, 2), vector(chance, 2, 2)
        if len(quadratic(*cones_coefficients(o, d, point, apex, r))) == 2 or chance.random() < 0.1:
            one("parameters", "An oblique cone", "order sign", o, d, point, apex, r)
    return made


# Tori


def tori():
    made = []

    def one(rules, comment, flags, o, d, p, n, big, small, compare="abs:1e-11", expected=None, gap=0.03):
        shape = {"kind": "torus", "position": p, "normal": n, "major_radius": big, "minor_radius": small}
        computed = [t for t, _ in solids.meets(shape, decimals(o), decimals(d))]
        if expected is not None and [solids.near(t) for t in computed] != expected:
            raise AssertionError(f"{comment}: {computed}")
        if gap and any(b - a < gap for a, b in zip(computed, computed[1:])):
            return False
        made.append(case(["geometry.torus." + rule if "." not in rule else rule for rule in rules.split()], comment, flags,
                         {"ray": ray(o, d), "position": p, "normal": n, "major_radius": big, "minor_radius": small}, [solids.near(t) for t in computed], compare, DECIMAL))
        return True

    c, z = [0, 0, 0], [0, 0, 1]
    one("equation geometry.ray.line", "Through the hole: four, ascending", "unsorted", [-10, 0, 0], [1, 0, 0], c, z, 2, 1, expected=[7.0, 9.0, 11.0, 13.0])
    one("equation geometry.ray.line", "Behind: four negative ones", "negative-dropped", [10, 0, 0], [1, 0, 0], c, z, 2, 1, expected=[-13.0, -11.0, -9.0, -7.0])
    one("equation", "Through the tube: two", "missing", [2, 0, 9], [0, 0, -1], c, z, 2, 1, expected=[8.0, 10.0])
    one("equation", "Down the axis of the hole: none", "hole", [0, 0, 9], [0, 0, -1], c, z, 2, 1, expected=[])
    one("equation", "Through the hole, slanted: none", "hole", [0.25, 0, 9], [0, 0.01, -1], c, z, 2, 1, expected=[])
    one("equation", "Beside it: none", "missing", [-10, 3.5, 0], [1, 0, 0], c, z, 2, 1, expected=[])
    one("equation", "Above it: none", "missing", [-10, 0, 1.25], [1, 0, 0], c, z, 2, 1, expected=[])
    one("equation", "At the outside only: two", "two-of-four", [-10, 2, 0], [1, 0, 0], c, z, 2, 1)
    one("equation", "Beside the axis: four", "four", [-10, 0.5, 0], [1, 0, 0], c, z, 2, 1)
    one("equation", "Above the plane of the circle", "height", [-10, 0, 0.6], [1, 0, 0], c, z, 2, 1)
    one("equation", "Below the plane of the circle", "height sign", [-10, 0, -0.6], [1, 0, 0], c, z, 2, 1)
    one("equation", "Slanted: both ends of the line", "sign", [-10, 0, 5], [2, 0, -1], c, z, 2, 1)
    one("equation geometry.ray.direction", "A direction of length 2", "direction-normalized", [-10, 0, 0], [2, 0, 0], c, z, 2, 1, expected=[3.5, 4.5, 5.5, 6.5])
    one("equation geometry.ray.direction", "A direction of length 1/10", "direction-normalized", [-10, 0, 0], [0.1, 0, 0], c, z, 2, 1, compare="abs:1e-10")
    one("equation", "The axis along x", "swapped-coordinate normal-ignored", [0, -10, 0], [0, 1, 0], c, [1, 0, 0], 2, 1, expected=[7.0, 9.0, 11.0, 13.0])
    one("equation", "The axis along y", "swapped-coordinate normal-ignored", [0, 9, 2], [0, -1, 0], c, [0, 1, 0], 2, 1, expected=[8.0, 10.0])
    one("equation", "A long normal is made unit", "normal-not-unit", [-10, 0, 0.6], [1, 0, 0], c, [0, 0, 50], 2, 1)
    one("equation", "A short normal is made unit", "normal-not-unit", [-10, 0, 0.6], [1, 0, 0], c, [0, 0, 0.02], 2, 1)
    one("equation", "The normal the other way round", "sign", [-10, 0, 0.6], [1, 0, 0.125], c, [0, 0, -1], 2, 1)
    one("equation", "Moved", "position-ignored", [-7, 5, -2], [1, 0, 0], [3, 5, -2], z, 2, 1, expected=[7.0, 9.0, 11.0, 13.0])
    one("equation", "From the circle", "inside", [2, 0, 0], [1, 0, 0], c, z, 2, 1, expected=[-5.0, -3.0, -1.0, 1.0])
    one("equation", "From the surface", "zero-root", [3, 0, 0], [-1, 0, 0], c, z, 2, 1, expected=[0.0, 2.0, 4.0, 6.0])
    one("equation", "From the centre", "b-zero", [0, 0, 0], [0, 1, 0], c, z, 2, 1, expected=[-3.0, -1.0, 1.0, 3.0])
    one("equation", "A thin torus", "thin", [-10, 0, 0], [1, 0, 0], c, z, 3, 0.25, expected=[6.75, 7.25, 12.75, 13.25])
    one("equation", "Radii of 300 and 100", "scale", [-1000, 0, 0], [1, 0, 0], c, z, 300, 100, compare="abs:1e-9", expected=[600.0, 800.0, 1200.0, 1400.0])
    one("equation", "Radii of 0.02 and 0.01", "scale", [-0.1, 0, 0], [1, 0, 0], c, z, 0.02, 0.01, compare="abs:1e-13", gap=0.01)
    one("spindle", "A spindle: both sheets, four", "inner-sheet-dropped", [-10, 0, 0], [1, 0, 0], c, z, 1, 2, expected=[7.0, 9.0, 11.0, 13.0])
    one("spindle", "A spindle along its axis: the points of the spindle, twice each, are far apart from nothing else", "inner-sheet-dropped", [0.25, 0, 9], [0, 0, -1], c, z, 1, 2)
    one("spindle", "Across a spindle above its points: two", "two-of-four", [-10, 0, 1.875], [1, 0, 0], c, z, 1, 2)
    one("spindle", "A spindle from inside its inner sheet", "inner-sheet-dropped", [0, 0, 0.5], [1, 0, 0], c, z, 1, 2)
    one("spindle", "A spindle, oblique", "inner-sheet-dropped", [-10, 0.5, 1], [1, 0, -0.125], c, z, 1, 2)
    one("spindle", "A spindle that is nearly a sphere", "inner-sheet-dropped", [-10, 0, 0], [1, 0, 0], c, z, 0.25, 4, expected=[5.75, 6.25, 13.75, 14.25])
    one("equation precision", "A horn torus touches itself in its middle: this line is a tangent there", "double-root", [-10, 0, 0], [1, 0, 0], c, z, 1, 1, compare="abs:1e-9", expected=[8.0, 10.0, 10.0, 12.0], gap=0)
    one("precision geometry.ray.line", "A tangent above the circle, twice and twice", "double-root", [-10, 0, 1], [1, 0, 0], c, z, 2, 1, compare="abs:1e-9", expected=[8.0, 8.0, 12.0, 12.0], gap=0)
    one("precision", "A tangent at the outermost circle, twice", "double-root", [-10, 3, 0], [1, 0, 0], c, z, 2, 1, compare="abs:1e-9", expected=[10.0, 10.0], gap=0)
    one("precision", "A tangent at the innermost circle, twice, between two others", "double-root", [-10, 1, 0], [1, 0, 0], c, z, 2, 1, compare="abs:1e-9", gap=0)
    one("precision", "A tangent at the outermost circle along the axis, twice", "double-root", [3, 0, 9], [0, 0, -1], c, z, 2, 1, compare="abs:1e-9", expected=[9.0, 9.0], gap=0)
    one("precision", "A tangent at the innermost circle along the axis, twice", "double-root", [1, 0, 9], [0, 0, -1], c, z, 2, 1, compare="abs:1e-9", expected=[9.0, 9.0], gap=0)
    one("precision", "Beside the tangent at the outermost circle by 1e-6: none", "epsilon", [-10, 3.000001, 0], [1, 0, 0], c, z, 2, 1, expected=[])
    one("precision", "Inside the tangent by 1e-6: two", "epsilon merged", [-10, 2.999999, 0], [1, 0, 0], c, z, 2, 1, compare="abs:1e-9", gap=0)
    one("precision", "From 2^20 away", "far-origin", [2.0**20, 0, 0], [-1, 0, 0], c, z, 2, 1, compare="abs:1e-8", expected=[2.0**20 - 3, 2.0**20 - 1, 2.0**20 + 1, 2.0**20 + 3])
    one("precision", "From 1e6 away, oblique", "far-origin", [800000.5, 600000.25, 0.125], [-0.8, -0.6, 0], c, z, 2, 1, compare="abs:1e-8")
    chance = random.Random(506)
    while len(made) < 62:
        p, n, big, small = vector(chance, 3, 2), vector(chance, 2, 2), some(chance, 1, 3, 2), some(chance, 0.3, 2.5, 2)
        o = vector(chance, 9, 2)
        d = [round(x + chance.uniform(-2, 2) - y, 2) for x, y in zip(p, o)]
        shape = {"kind": "torus", "position": p, "normal": n, "major_radius": big, "minor_radius": small}
        counts = {len(solids.meets(shape, decimals([x + e for x in o]), decimals(d))) for e in (-0.02, 0, 0.02)}
        if len(counts) == 1 and counts != {0}:
            one("equation precision" + (" spindle" if small > big else ""), "An oblique torus", "order sign", o, d, p, n, big, small)
    return made


# Barycentric coordinates


def barycentric(p0, p1, p2, v):
    p0, p1, p2, v = floats(p0), floats(p1), floats(p2), floats(v)
    w, s1, s2 = sub(v, p0), sub(p1, p0), sub(p2, p0)
    d = dot(s1, s1) * dot(s2, s2) - dot(s1, s2) * dot(s1, s2)
    return [(dot(w, s1) * dot(s2, s2) - dot(w, s2) * dot(s1, s2)) / d, (dot(w, s2) * dot(s1, s1) - dot(w, s1) * dot(s1, s2)) / d]


def barycentrics():
    made = []

    def one(comment, flags, points, v, expected=None):
        computed = [x + 0.0 for x in barycentric(*points, v)]
        if expected is not None and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case("geometry.triangle.barycentric", comment, flags, {"points": points, "point": v}, computed, source=ORDERED))

    right = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    skew = [[1, 1, 0], [5, 1, 0], [3, 4, 0]]
    one("The first corner", "swapped", right, [0, 0, 0], [0.0, 0.0])
    one("The second corner", "swapped", right, [1, 0, 0], [1.0, 0.0])
    one("The third corner", "swapped", right, [0, 1, 0], [0.0, 1.0])
    one("The middle of the first edge", "swapped", right, [0.5, 0, 0], [0.5, 0.0])
    one("The middle of the second edge", "swapped", right, [0.5, 0.5, 0], [0.5, 0.5])
    one("The middle of the third edge", "swapped", right, [0, 0.5, 0], [0.0, 0.5])
    one("Inside, the two differ", "swapped", right, [0.25, 0.5, 0], [0.25, 0.5])
    one("Outside, beyond the first corner: negative", "clamped sign", right, [-1, -2, 0], [-1.0, -2.0])
    one("Outside, beyond the second edge: a sum above 1", "clamped", right, [3, 2, 0], [3.0, 2.0])
    one("Edges that are not orthogonal: the second corner", "mixed-term", skew, [5, 1, 0], [1.0, 0.0])
    one("Edges that are not orthogonal: the third corner", "mixed-term", skew, [3, 4, 0], [0.0, 1.0])
    one("Edges that are not orthogonal: inside", "mixed-term", skew, [3, 2.5, 0], [0.25, 0.5])
    one("Edges that are not orthogonal: an obtuse angle", "mixed-term sign", [[0, 0, 0], [4, 0, 0], [-2, 2, 0]], [0, 1, 0], [0.25, 0.5])
    one("Edges of different lengths", "not-divided", [[0, 0, 0], [8, 0, 0], [0, 2, 0]], [2, 1, 0], [0.25, 0.5])
    one("In the plane of x and z", "swapped-coordinate", [[0, 7, 0], [0, 7, 4], [2, 7, 0]], [1, 7, 1], [0.25, 0.5])
    one("In the plane of y and z", "swapped-coordinate", [[7, 0, 0], [7, 4, 0], [7, 0, 2]], [7, 1, 1], [0.25, 0.5])
    one("A slanted plane", "swapped-coordinate", [[0, 0, 4], [4, 0, 0], [0, 4, 0]], [1, 2, 1])
    one("Off the plane: what is orthogonal to it does not count", "projection", right, [0.25, 0.5, 9], [0.25, 0.5])
    one("The first corner is not the origin", "origin-ignored", [[10, 20, 30], [14, 20, 30], [10, 24, 30]], [11, 22, 30], [0.25, 0.5])
    one("The same triangle, corners turned", "orientation", [[0, 0, 0], [0, 1, 0], [1, 0, 0]], [0.25, 0.5, 0], [0.5, 0.25])
    one("A tiny triangle", "epsilon underflow", [[0, 0, 0], [1e-20, 0, 0], [0, 1e-20, 0]], [2.5e-21, 5e-21, 0])
    one("A huge triangle", "overflow", [[0, 0, 0], [1e30, 0, 0], [0, 1e30, 0]], [2.5e29, 5e29, 0])
    chance = random.Random(507)
    for i in range(14):
        points = [[chance.uniform(-5, 5) for _ in range(3)] for _ in range(3)]
        a, b = chance.uniform(0, 1), chance.uniform(0, 1)
        v = add(points[0], add(times(a, sub(points[1], points[0])), times(b, sub(points[2], points[0]))))
        one("Numbers of all digits: the order of operations shows", "order fused", points, v)
    return made


def operations():
    return {"ray.position": positions(), "intersect.plane": planes(), "intersect.sphere": spheres(), "intersect.tube": tubes(), "intersect.cones": cones(), "intersect.torus": tori(),
            "triangle.barycentric": barycentrics()}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
