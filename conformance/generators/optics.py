#!/usr/bin/env python3
"""Reflected and refracted directions: reflection in the order of its rule, in binary64; refraction in decimals of 60 digits."""

import math
import random
import sys
from decimal import Decimal

sys.dont_write_bytecode = True

import suite  # noqa: E402
from suite import DECIMAL, HAND, ORDERED, case, decimals, dot, next_up, sub, times  # noqa: E402


def unit(a):
    a = [float(x) for x in a]
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def settled(a):
    """A unit vector that stays what it is when it is made unit once more."""
    a = unit(a)
    for _ in range(8):
        if unit(a) == a:
            return a
        a = unit(a)
    return None


def against(v, n):
    return [-x for x in n] if dot(v, n) > 0 else n


def reflections():
    made = []

    def one(rules, comment, flags, v, n, expected=None):
        if unit(n) != [float(x) for x in n]:
            raise AssertionError(f"{comment}: the normal is not unit to the bit")
        w = unit(v)
        turned = against(w, [float(x) for x in n])
        twice = 2 * dot(w, turned)
        computed = [x - twice * y + 0.0 for x, y in zip(w, turned)]
        if expected is not None and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case(["optics." + rule for rule in rules.split()], comment, flags, {"direction": v, "normal": n}, computed, source=ORDERED))

    z = [0, 0, 1]
    one("reflect", "Straight on: back", "sign", [0, 0, -1], z, [0.0, 0.0, 1.0])
    one("reflect", "3, 4, 5: what is across goes on, what is along turns round", "sign factor-two", [0.6, 0, -0.8], z)
    one("reflect", "5, 12, 13", "sign factor-two", [5, 0, -12], z)
    one("reflect", "A normal along x", "swapped-coordinate", [-0.8, 0.6, 0], [1, 0, 0])
    one("reflect", "A normal along y", "swapped-coordinate", [0, -0.8, 0.6], [0, 1, 0])
    one("reflect", "A normal against z", "sign", [0.6, 0, 0.8], [0, 0, -1])
    one("reflect", "An oblique normal", "factor-two", [1, 0, 0], [-0.6, 0.8, 0])
    one("reflect", "An oblique normal, another direction", "factor-two", [0, -1, 0], [-0.6, 0.8, 0])
    one("reflect.operation", "A direction of length 5 is made unit first", "direction-not-unit", [3, 0, -4], z)
    one("reflect.operation", "A direction of length 1/100", "direction-not-unit", [0, 0, -0.01], z, [0.0, 0.0, 1.0])
    one("reflect.operation", "A direction of length 1e90", "overflow", [0, 0, -1e90], z, [0.0, 0.0, 1.0])
    one("reflect.operation", "A normal along the direction is turned round: the same", "normal-turned", [3, 0, -4], [0, 0, -1])
    one("reflect.operation", "From behind", "normal-turned", [0.6, 0, 0.8], z)
    one("reflect.operation", "From behind, straight", "normal-turned", [0, 0, 1], z, [0.0, 0.0, -1.0])
    for v in ([0, 1, 0], [1, 0, 0], [-1, 0, 0], [3, 4, 0]):
        one("reflect.along", "Along the surface: goes on", "grazing", v, z, unit(v))
    one("reflect.along", "Along a slanted surface: goes on, to rounding", "grazing", [0.8, 0.6, 0], [-0.6, 0.8, 0])
    one("reflect.along reflect", "Nearly along the surface", "grazing", [1, 0, -(2.0**-30)], z)
    one("reflect.along reflect", "Nearly along the surface, from behind", "grazing", [1, 0, 2.0**-30], z)
    chance = random.Random(701)
    while len(made) < 36:
        v, n = [chance.uniform(-3, 3) for _ in range(3)], settled([chance.uniform(-1, 1) for _ in range(3)])
        if n and settled(unit(v)) == unit(v):
            one("reflect" + (" reflect.operation" if dot(v, n) > 0 else ""), "Numbers of all digits: the order of operations shows", "order fused factor-two", v, n)
    return made


def exact_refraction(v, n, n1, n2):
    """In decimals: the direction, or None on total reflection, and by how much the critical angle is missed."""
    v, n, n1, n2 = suite.dunit(v), suite.dunit(n), suite.decimal(n1), suite.decimal(n2)
    c = -dot(v, n)
    if c < 0:
        c, n = -c, times(-1, n)
    if n1 == n2:
        return v, Decimal(1)
    room = c * c + (n2 / n1) ** 2 - 1
    if room < 0:
        return None, -room
    r = n1 / n2
    return [r * x + (r * c - (1 - r * r * (1 - c * c)).sqrt()) * y for x, y in zip(v, n)], room


def ordered_refraction(v, n, n1, n2):
    v = unit(v)
    n = against(v, n)
    c, r = -dot(v, n), n1 / n2
    k = r * c - math.sqrt(max(0.0, 1 - r * r * (1 - c * c)))
    return [r * x + k * y for x, y in zip(v, n)]


def refractions():
    made = []

    def one(rules, comment, flags, v, n, n1, n2, expected="computed", compare="abs:1e-15"):
        computed, room = exact_refraction(v, n, n1, n2)
        if room < Decimal("1e-12"):
            raise AssertionError(f"{comment}: too near to the critical angle")
        if computed is not None:
            computed = [0.0 if abs(x) < Decimal("1e-45") else suite.nearest(x) for x in computed]
            if n1 != n2 and compare == "abs:1e-15" and any(abs(x - y) > 9e-16 for x, y in zip(computed, ordered_refraction(v, n, n1, n2))):
                return False
        if expected != "computed" and computed != expected:
            raise AssertionError(f"{comment}: {computed}")
        made.append(case(["optics." + rule for rule in rules.split()], comment, flags, {"direction": v, "normal": n, "n1": n1, "n2": n2}, computed, "exact" if computed is None else compare, DECIMAL))
        return True

    def by_hand(rules, comment, flags, v, n, n1, n2, expected, compare="exact"):
        made.append(case(["optics." + rule for rule in rules.split()], comment, flags, {"direction": v, "normal": n, "n1": n1, "n2": n2}, expected, compare, HAND))

    z = [0, 0, 1]
    for n1, n2 in ((1, 1.5), (1.5, 1), (1, 2.5), (1.33, 1.5), (0.5, 4), (1, 10)):
        one("refract" + (" refract.index" if n2 == 10 else ""), f"3, 4, 5 from {n1} into {n2}", "index-swapped sign", [0.6, 0, -0.8], z, n1, n2)
        one("refract.straight refract", f"Straight from {n1} into {n2}", "sign", [0, 0, -1], z, n1, n2, [0.0, 0.0, -1.0])
    for n, v in (([1, 0, 0], [-0.8, 0.6, 0]), ([0, 1, 0], [0.6, -0.8, 0]), ([0, 0, -1], [0, 0.6, 0.8]), ([-0.6, 0.8, 0], [0, -1, 0]), ([-0.6, 0.8, 0], [1, 0, 0])):
        one("refract", f"The normal {n}", "swapped-coordinate", v, n, 1, 1.5)
        one("refract", f"The normal {n}, out of glass", "swapped-coordinate index-swapped", v, n, 1.125, 1)
    one("refract", "In the plane of y and z", "swapped-coordinate", [0, -0.6, -0.8], z, 1, 1.5)
    one("refract", "The plane of incidence is kept", "swapped-coordinate", [2, -3, -6], z, 1, 1.5)
    one("refract.operation", "A direction of length 5 is made unit", "direction-not-unit", [3, 0, -4], z, 1, 1.5)
    one("refract.operation", "A direction of length 1/50", "direction-not-unit", [0.012, 0, -0.016], z, 1.5, 1)
    one("refract.operation", "A normal along the direction is turned round", "normal-turned", [0.6, 0, -0.8], [0, 0, -1], 1, 1.5)
    one("refract.operation", "A normal along the direction, straight", "normal-turned", [0, 0, 5], z, 1, 1.5, [0.0, 0.0, 1.0])
    one("refract.operation refract.total", "A normal along the direction, total reflection", "normal-turned", [0.8, 0, 0.6], z, 1.5, 1, None)
    for v in ([0, 1, 0], [0.6, 0, -0.8], [0, 0, -1], [0.28, 0, -0.96]):
        by_hand("refract.equal", "Equal indices: the direction is kept, exactly", "equal-indices", v, z, 1.7, 1.7, v)
    by_hand("refract.equal", "Equal indices, at any angle: along a slanted surface", "equal-indices grazing", [0.8, 0.6, 0], [-0.6, 0.8, 0], 1.5, 1.5, unit([0.8, 0.6, 0]))
    by_hand("refract.equal refract.operation", "Equal indices: the direction is made unit", "direction-not-unit", [0, 0, -7], z, 1.1, 1.1, [0, 0, -1])
    by_hand("refract.equal refract.index", "The smallest index, twice", "equal-indices", [0.6, 0, -0.8], z, 1e-10, 1e-10, [0.6, 0, -0.8])
    one("refract.total", "Beyond the critical angle: nothing", "total-reflection", [0.8, 0, -0.6], z, 1.5, 1, None)
    one("refract.total", "Within the critical angle: something", "total-reflection", [0, 0.6, -0.8], z, 1.5, 1)
    one("refract.total", "Never into the denser one", "total-reflection index-swapped", [0.96, 0, -0.28], z, 1, 1.5)
    one("refract.total", "Along the surface into the denser one", "grazing", [1, 0, 0], z, 1, 1.5)
    one("refract.total", "Along the surface into the thinner one: nothing", "grazing", [1, 0, 0], z, 1.5, 1, None)
    one("refract.total", "Just within the critical angle of 2 and 1 (30 degrees)", "total-reflection", [0.4999, 0, -math.sqrt(1 - 0.4999**2)], z, 2, 1, compare="abs:1e-13")
    one("refract.total", "Just beyond it", "total-reflection", [0.5001, 0, -math.sqrt(1 - 0.5001**2)], z, 2, 1, None)
    by_hand("refract.total", "At the critical angle, to the bit: c = 0.8 and n2/n1 = 0.6 give 1, which is not less than 1: along the surface", "strict-comparison", [0.6, 0, -0.8], z, 5, 3, [1, 0, 0], "abs:1e-7")
    by_hand("refract.total", "One ulp more of the first index, along the surface: nothing", "epsilon equal-indices", [1, 0, 0], z, next_up(1.0), 1, None)
    by_hand("refract.total", "One ulp less of the second index, along the surface: nothing", "epsilon equal-indices", [0, 1, 0], z, 1, next_up(1.0, -1), None)
    one("refract.total", "Indices of 10 and 1, at a small angle beyond the critical one", "total-reflection", [0.12, 0, -1], z, 10, 1, None)
    one("refract refract.index", "Indices of 10 and 1, within it", "total-reflection", [0.05, 0, -1], z, 10, 1, compare="abs:2e-14")
    chance = random.Random(702)
    while len(made) < 72:
        v, n = [round(chance.uniform(-3, 3), 3) for _ in range(3)], settled([chance.uniform(-1, 1) for _ in range(3)])
        if n is None:
            continue
        n1, n2 = round(chance.uniform(1, 2.5), 2), round(chance.uniform(1, 2.5), 2)
        computed, room = exact_refraction(v, n, n1, n2)
        if room > Decimal("0.05") and (computed is not None or chance.random() < 0.4):
            one("refract" + (" refract.total" if computed is None else "") + (" refract.operation" if dot(v, n) > 0 else ""), "Oblique", "sign order index-swapped", v, n, n1, n2)
    return made


def operations():
    return {"optics.reflect": reflections(), "optics.refract": refractions()}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
