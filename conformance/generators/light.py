#!/usr/bin/env python3
"""The bare terms of illumination: ambient and scattered light in the order of their rules, in binary64; highlights in decimals of 60 digits."""

import random
import sys
from decimal import Decimal

sys.dont_write_bytecode = True

import optics  # noqa: E402
import suite  # noqa: E402
from suite import DECIMAL, ORDERED, add, case, decimals, dot, dpow, sub, times  # noqa: E402

Z, DOWN = [0, 0, 1], [0, 0, -1]
WHITE = [1, 1, 1]


def product(light, surface):
    return [float(x) * float(y) for x, y in zip(light[:3], surface[:3])]


def unit_to_the_bit(*vectors):
    for a in vectors:
        if optics.unit(a) != [float(x) for x in a]:
            raise AssertionError(f"{a} is not unit to the bit")


def ambients():
    made = []

    def one(comment, flags, light, surface, rules="light.ambient light.colour.channels"):
        made.append(case(rules, comment, flags, {"light": light, "surface": surface}, product(light, surface), source=ORDERED))

    one("White on white", "sign", WHITE, WHITE)
    one("Black light", "added", [0, 0, 0], WHITE)
    one("A black surface", "added", WHITE, [0, 0, 0])
    one("Red light on a green surface: nothing", "added", [1, 0, 0], [0, 1, 0])
    for i, name in enumerate(("red", "green", "blue")):
        one(f"Only {name}", "channel-swapped", [0.5 if i == j else 0 for j in range(3)], [0.25, 0.5, 0.75])
        one(f"A surface with only {name}", "channel-swapped", [0.25, 0.5, 0.75], [0.5 if i == j else 0 for j in range(3)])
    one("Different in every channel", "channel-swapped", [0.5, 0.25, 0.125], [0.5, 0.75, 1])
    one("Above 1 is kept", "clamped", [4, 8, 16], [0.5, 0.75, 1], "light.ambient light.colour.above-one")
    one("Far above 1 is kept", "clamped", [1e50, 2, 1e-50], [1, 3, 1], "light.ambient light.colour.above-one")
    one("Both above 1", "clamped", [2, 3, 4], [5, 6, 7], "light.ambient light.colour.above-one")
    one("Alpha 0 of the light does not count", "alpha", [1, 0.5, 0.25, 0], [1, 1, 1])
    one("Alpha 0 of the surface does not count", "alpha", [1, 1, 1], [1, 0.5, 0.25, 0])
    one("Alpha of both does not count", "alpha", [1, 1, 1, 0.5], [1, 0.5, 0.25, 0.5])
    one("Alpha above 1 does not count", "alpha", [1, 1, 1, 4], [1, 0.5, 0.25, 2])
    one("0.1 times 0.1", "rounding", [0.1, 0.2, 0.3], [0.1, 0.2, 0.3])
    chance = random.Random(710)
    for _ in range(5):
        one("Numbers of all digits", "channel-swapped", [chance.uniform(0, 2) for _ in range(3)], [chance.uniform(0, 1) for _ in range(3)])
    return made


def lamberts():
    made = []

    def one(rules, comment, flags, light, surface, normal, direction):
        unit_to_the_bit(normal, direction)
        f = -dot([float(x) for x in normal], [float(x) for x in direction])
        made.append(case(["light." + rule for rule in rules.split()], comment, flags, {"light": light, "surface": surface, "normal": normal, "direction": direction},
                         [0.0, 0.0, 0.0] if f < 0 else [f * x + 0.0 for x in product(light, surface)], source=ORDERED))

    c = [0.5, 0.25, 1]
    one("lambert", "Straight on", "sign", WHITE, c, Z, DOWN)
    one("lambert", "3, 4, 5", "cosine", WHITE, c, Z, [0.6, 0, -0.8])
    one("lambert", "4, 3, 5", "cosine", WHITE, c, Z, [0, 0.8, -0.6])
    one("lambert", "Along the surface: nothing", "grazing", WHITE, c, Z, [1, 0, 0])
    one("lambert.behind", "From behind, straight: black", "behind", WHITE, c, Z, Z)
    one("lambert.behind", "From behind, slanted: black", "behind absolute", WHITE, c, Z, [0.6, 0, 0.8])
    one("lambert.behind", "From just behind: black", "behind epsilon", WHITE, c, Z, optics.settled([1, 0, 1e-9]))
    one("lambert.behind lambert", "From just before: not black", "behind epsilon", [1e12, 1e12, 1e12], c, Z, optics.settled([1, 0, -1e-9]))
    one("lambert", "A normal along x", "swapped-coordinate", WHITE, c, [1, 0, 0], [-0.8, 0.6, 0])
    one("lambert", "A normal along y", "swapped-coordinate", WHITE, c, [0, 1, 0], [0, -0.8, 0.6])
    one("lambert", "A normal against z", "sign", WHITE, c, DOWN, [0.6, 0, 0.8])
    one("lambert", "An oblique normal", "cosine", WHITE, c, [-0.6, 0.8, 0], [0, -1, 0])
    one("lambert", "An oblique normal, the other component", "cosine", WHITE, c, [-0.6, 0.8, 0], [1, 0, 0])
    one("lambert.behind", "Another oblique normal, from behind", "behind", WHITE, c, [-0.6, 0.8, 0], [-1, 0, 0])
    one("lambert colour.channels", "Channel by channel", "channel-swapped", [1, 0.5, 0.25], [0.25, 0.5, 0.125], Z, [0.6, 0, -0.8])
    one("lambert colour.above-one", "Above 1 is kept", "clamped", [8, 4, 2], [1, 1, 1], Z, [0.6, 0, -0.8])
    one("lambert colour.channels", "Alpha does not count", "alpha", [1, 1, 1, 0.5], [0.5, 0.25, 1, 0.25], Z, [0.6, 0, -0.8])
    one("lambert", "Black light", "added", [0, 0, 0], c, Z, DOWN)
    one("lambert", "A black surface", "added", WHITE, [0, 0, 0], Z, DOWN)
    chance = random.Random(711)
    while len(made) < 36:
        n, d = optics.settled([chance.uniform(-1, 1) for _ in range(3)]), optics.settled([chance.uniform(-1, 1) for _ in range(3)])
        if n and d and (dot(n, d) < 0 or chance.random() < 0.2):
            one("lambert" if dot(n, d) < 0 else "lambert.behind", "Numbers of all digits: the order of operations shows", "order cosine", [chance.uniform(0, 2) for _ in range(3)], [chance.uniform(0, 1) for _ in range(3)], n, d)
    return made


def blinn_factor(n, d, v):
    h = sub(times(-1, v), d)
    size = dot(h, h).sqrt()
    return None if size == 0 else dot(n, h) / size


def phong_factor(n, d, v):
    return -dot(sub(d, times(2 * dot(d, n), n)), v)


def highlights(kind):
    made, factor = [], {"blinn": blinn_factor, "phong": phong_factor}[kind]

    def one(rules, comment, flags, light, surface, normal, direction, view, shininess, hand=None):
        unit_to_the_bit(normal, direction, view)
        f = factor(decimals(normal), decimals(direction), decimals(view))
        if hand is None and f is not None and abs(f) < Decimal("1e-9"):
            raise AssertionError(f"{comment}: rounding might decide on which side of 0 the factor is")
        if hand is not None:
            power = Decimal(hand)
        else:
            power = Decimal(0) if f is None or f < 0 else dpow(f, shininess)
        computed = [suite.nearest(power * suite.decimal(x) * suite.decimal(y)) for x, y in zip(light[:3], surface[:3])]
        exact = not any(computed) or shininess == 0
        made.append(case(["light." + (kind + rule if rule[0] == "." else rule) for rule in rules.replace("TERM", kind).split()], comment, flags,
                         {"light": light, "surface": surface, "normal": normal, "direction": direction, "view": view, "shininess": shininess}, computed, "exact" if exact else "rel:1e-12", DECIMAL))

    c = [0.5, 0.25, 1]
    one("TERM", "Straight on, seen straight on", "sign", WHITE, c, Z, DOWN, DOWN, 20)
    one("TERM", "The mirrored direction", "sign", WHITE, c, Z, [0.6, 0, -0.8], [-0.6, 0, -0.8], 20)
    one("TERM", "The mirrored direction in the plane of y and z", "swapped-coordinate", WHITE, c, Z, [0, 0.8, -0.6], [0, -0.8, -0.6], 5)
    for n in (1, 2, 5, 20, 50.5, 200):
        one("TERM power", f"A shininess of {n}", "exponent", WHITE, c, Z, [0.6, 0, -0.8], DOWN, n)
        one("TERM power", f"A shininess of {n}, nearly mirrored", "exponent", WHITE, c, Z, [0.6, 0, -0.8], [-0.28, 0, -0.96], n)
    one("TERM power", "A shininess of 1/2", "exponent", WHITE, c, Z, [0.6, 0, -0.8], DOWN, 0.5)
    one("power", "A shininess of 0", "zero-exponent", WHITE, c, Z, [0.6, 0, -0.8], DOWN, 0)
    one("power", "A shininess of 0, nearly along the surface", "zero-exponent", WHITE, c, Z, [0.96, 0, -0.28], [-0.28, 0, -0.96], 0)
    one("power", "0 to the power 0 is 1", "zero-exponent", *{"blinn": (WHITE, c, Z, [1, 0, 0], [1, 0, 0], 0, 1), "phong": (WHITE, c, Z, DOWN, [1, 0, 0], 0, 1)}[kind])
    one("power", "0 to the power 2 is 0", "zero-exponent", *{"blinn": (WHITE, c, Z, [0, 1, 0], [0, 1, 0], 2, 0), "phong": (WHITE, c, Z, DOWN, [0, 1, 0], 2, 0)}[kind])
    one("power", "0 to the power 1/8 is 0", "zero-exponent", *{"blinn": (WHITE, c, Z, [-1, 0, 0], [-1, 0, 0], 0.125, 0), "phong": (WHITE, c, Z, DOWN, [-1, 0, 0], 0.125, 0)}[kind])
    one("TERM colour.channels", "Channel by channel", "channel-swapped", [1, 0.5, 0.25], [0.25, 0.5, 0.125], Z, [0.6, 0, -0.8], DOWN, 3)
    one("TERM colour.above-one", "Above 1 is kept", "clamped", [8, 4, 2], WHITE, Z, [0.6, 0, -0.8], [-0.6, 0, -0.8], 3)
    one("TERM colour.channels", "Alpha does not count", "alpha", [1, 1, 1, 0.5], [0.5, 0.25, 1, 0.25], Z, [0.6, 0, -0.8], DOWN, 3)
    one("TERM", "Black light", "added", [0, 0, 0], c, Z, DOWN, DOWN, 4)
    one("TERM", "An oblique normal", "swapped-coordinate", WHITE, c, [-0.6, 0.8, 0], [0, -1, 0], [0.6, -0.8, 0], 4)
    one("TERM", "A normal along x", "swapped-coordinate", WHITE, c, [1, 0, 0], [-0.8, 0.6, 0], [-0.8, 0, 0.6], 4)
    one("TERM", "A normal along y", "swapped-coordinate", WHITE, c, [0, 1, 0], [0, -0.8, 0.6], [0.6, -0.8, 0], 4)
    one("TERM", "Light and view are not the same: swapped in the plane", "swapped", WHITE, c, [0, 0.6, 0.8], [0.6, 0, -0.8], [0, 0, -1], 4)
    if kind == "blinn":
        one(".behind", "The light is behind, the half vector before the surface: not black", "behind", WHITE, c, Z, [0.8, 0, 0.6], [-0.28, 0, -0.96], 2)
        one(".behind", "The half vector is behind: black", "behind absolute", WHITE, c, Z, [0, 0.6, 0.8], Z, 2)
        one(".behind", "The half vector is behind, shininess 0: black all the same", "behind zero-exponent", WHITE, c, Z, [0, 0.6, 0.8], Z, 0)
        one(".behind", "The half vector is behind, an even exponent", "behind absolute", WHITE, c, Z, [0.6, 0, 0.8], [0, 0.6, 0.8], 4)
        one(".behind", "The view is behind, the half vector before the surface: not black", "behind", WHITE, c, Z, [-0.28, 0, -0.96], [0.8, 0, 0.6], 2)
        for a in ([1, 0, 0], [0, 0, 1], [0.6, 0, 0.8], [0, -0.6, -0.8]):
            for n in (0, 4):
                one(".opposite", f"Exactly against the view, shininess {n}: black", "nan zero-vector", WHITE, c, Z, a, [-x for x in a], n)
        one("blinn", "The half vector is made unit", "not-unit", WHITE, c, [0, 0.6, 0.8], [0, 0, -1], [0, -0.96, -0.28], 3)
    else:
        one(".behind", "The view is on the other side of the mirrored direction: black", "behind absolute", WHITE, c, Z, [0.6, 0, -0.8], [0.96, 0, -0.28], 2)
        one(".behind", "Behind, shininess 0: black all the same", "behind zero-exponent", WHITE, c, Z, [0.6, 0, -0.8], [1, 0, 0], 0)
        one(".behind", "Seen from where the light goes: black", "behind sign", WHITE, c, Z, DOWN, Z, 2)
        one(".behind", "An even exponent", "behind absolute", WHITE, c, Z, DOWN, [0.6, 0, 0.8], 4)
        one(".behind phong", "From just before: not black", "behind", WHITE, c, Z, DOWN, optics.settled([1, 0, -0.001]), 1)
        one(".behind", "From just behind: black", "behind epsilon", WHITE, c, Z, DOWN, optics.settled([1, 0, 0.001]), 1)
        one("phong", "The light from behind is mirrored like any other", "behind", WHITE, c, Z, [0.6, 0, 0.8], [-0.6, 0, 0.8], 3)
        one("phong", "The mirrored direction, an oblique normal: twice the part along the normal", "factor-two", WHITE, c, [0, 0.6, 0.8], [0, 0, -1], [0, -0.96, -0.28], 7)
    chance = random.Random(712 if kind == "blinn" else 713)
    few = len(made)
    while len(made) < few + 14:
        n, d, v = (optics.settled([chance.uniform(-1, 1) for _ in range(3)]) for _ in range(3))
        if n and d and v and dot(n, d) < 0 and dot(n, v) < 0:
            f = factor(decimals(n), decimals(d), decimals(v))
            if f > Decimal("0.3"):
                one("TERM", "Oblique", "sign not-unit", [round(chance.uniform(0, 2), 2) for _ in range(3)], [round(chance.uniform(0, 1), 2) for _ in range(3)], n, d, v, round(chance.uniform(0.5, 40), 1))
    return made


def operations():
    return {"light.ambient": ambients(), "light.lambert": lamberts(), "light.blinn": highlights("blinn"), "light.phong": highlights("phong")}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
