#!/usr/bin/env python3
"""Roots so near each other that twice the digits of binary64 do not tell their places.

Each polynomial is A h^n + ... + E, exactly, with h = x - 1. How near an answer is comes from roots.residual: it is as far as from the one end to the other of where |p(x)| is at most
8 eps times the sum of the sizes of the terms, all of which lies around 1. (roots.simple says more, and no case asks for it, since a port need not keep it.)
"""

import sys

sys.dont_write_bytecode = True

from fractions import Fraction  # noqa: E402

import roots_maths  # noqa: E402
import suite  # noqa: E402
from roots_maths import EPS, real_roots, sent, value  # noqa: E402
from suite import EXACT, case, nearest  # noqa: E402

# These cases come after those of the other generators, whose numbers they leave alone.
LAST = True


def moved(p):
    """The polynomial of x = h + 1, from that of h."""
    made = []
    for c in p:
        made = [a - b for a, b in zip([*made, c], [0, *made])] if made else [c]
    return made


def reach(p):
    """The distance between the ends of where |p(x)| <= 8 eps (|a x^n| + ... + |e|), relative to the number nearer to zero, and a little more."""
    small = lambda x: abs(value(p, x)) <= 8 * EPS * value([abs(c) for c in p], abs(x))
    roots, ends = real_roots(p), []
    for root, side in ((roots[0], -1), (roots[-1], 1)):
        near, far = Fraction(0), side * abs(root) / 8
        for _ in range(40):
            middle = (near + far) / 2
            near, far = (middle, far) if small(root + middle) else (near, middle)
        ends.append(root + far)
    return f"rel:{float((ends[1] - ends[0]) / min(map(abs, ends))) * 1.06:.1e}"


def gathered(comment, rules, h):
    """As it is, turned to -1, and around 2^30."""
    made = []
    for turn, size in ((1, 1), (-1, 1), (1, 2**30)):
        p = [c * (turn * size) ** i for i, c in enumerate(moved([Fraction(c) for c in h]))]
        if any(Fraction(float(c)) != c for c in p):
            raise ValueError(f"{p} are not binary64 numbers")
        roots = real_roots(p)
        around = "-1" if turn < 0 else "1" if size == 1 else "2^30"
        made.append(case(rules, f"{comment}, around {around}", "newton count", sent(*map(float, p)), [nearest(x) for x in roots], reach(p), EXACT))
    return made


def two(k):
    return Fraction(1, 2**k)


def cubics():
    rules = "roots.cubic.count roots.residual"
    return gathered("One root, and two complex ones 2^-22 of its size from it", rules, [1, two(22), two(44), 0])


def quartics():
    rules = "roots.quartic.count roots.residual"
    return (
        gathered("Four roots, three of them within 2^-17 of their size, two of these within 2^-19.7", rules, [1, -two(12), two(29), -two(49), 0])
        + gathered("Two roots, the one next to two complex ones, 2^-18.5 of its size from it", rules, [1, -two(12), two(30), -two(49), 0])
        + gathered("Four roots: 1 is the second, and 2^-21 of its size from the first", rules, [1, -two(12), two(28), two(49), 0])
    )


def operations():
    return {"roots.cubic": cubics(), "roots.quartic": quartics()}


if __name__ == "__main__":
    suite.main(sys.modules[__name__])
