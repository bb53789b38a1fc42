"""The cases of vector.*: chapters 1 and 4.1. Results are binary64 operations in the order of the rules, or exact fractions."""

import math
import random
import sys

sys.dont_write_bytecode = True

from suite import DECIMAL, HAND, ORDERED, Raw, case, cross, datan2, dot, main, nearest, sub  # noqa: E402

TINY, LEAST, MOST = 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308
EPS = 2.0**-53

# Pairs of vectors that tell mistakes apart: no two components alike, signs mixed, sums that round, sums whose order matters.
PAIRS = [
    ("small whole numbers, all different", "swapped-index", [1, 2, 3], [10, 200, 4000]),
    ("signs mixed", "sign", [1, -2, 3], [-4, 5, -60]),
    ("only x", "swapped-index", [2, 0, 0], [3, 0, 0]),
    ("only y", "swapped-index", [0, 2, 0], [0, 5, 0]),
    ("only z", "swapped-index", [0, 0, 2], [0, 0, 7]),
    ("x and y", "sign", [1, 0, 0], [0, 1, 0]),
    ("y and z", "sign", [0, 1, 0], [0, 0, 1]),
    ("z and x", "sign", [0, 0, 1], [1, 0, 0]),
    ("y and x, the other way round", "sign", [0, 1, 0], [1, 0, 0]),
    ("z and y, the other way round", "sign", [0, 0, 1], [0, 1, 0]),
    ("x and z, the other way round", "sign", [1, 0, 0], [0, 0, 1]),
    ("tenths, whose sums and products round", "rounding", [0.1, 0.2, 0.3], [0.7, 0.1, 0.2]),
    ("thirds", "rounding", [1 / 3, 2 / 3, 4 / 3], [1 / 7, 3 / 7, 6 / 7]),
    ("a large number swallows small ones from the left", "order", [1e16, 1, 1], [1, 1, 1]),
    ("a large number swallows small ones from the right", "order", [1, 1, 1e16], [1, 1, 1]),
    ("large numbers cancel, what was swallowed is gone", "order", [1e16, 1, -1e16], [1, 1, 1]),
    ("large numbers cancel first, what is small stays", "order", [1e16, -1e16, 1], [1, 1, 1]),
    ("products of 27 bits, whose last bit is lost without a fused operation", "fused-multiply-add", [134217729.0, 1, 0], [134217729.0, -18014398777917440.0, 0]),
    ("the same in y and z", "fused-multiply-add", [0, 134217729.0, 1], [0, 134217729.0, -18014398777917440.0]),
    ("a zero vector", "zero", [0, 0, 0], [1.5, -2.5, 3.5]),
    ("the zero vector on the right", "zero", [1.5, -2.5, 3.5], [0, 0, 0]),
    ("equal vectors", "zero", [0.1, -0.7, 1e10], [0.1, -0.7, 1e10]),
    ("opposite vectors", "sign", [0.1, -0.7, 13], [-0.1, 0.7, -13]),
    ("sizes far apart", "rounding", [1e-30, 1e30, 1], [1e30, 1e-30, 1]),
    ("the largest components that a scene may have", "overflow", [1e100, -1e100, 1e100], [1e100, 1e100, 0.5e100]),
]


def some_pairs(seed, count):
    """Pairs with random bits, sizes from 2^-6 to 2^6."""
    source = random.Random(seed)
    one = lambda: source.choice((-1, 1)) * source.random() * 2.0 ** source.randint(-6, 6)
    return [("random digits", "rounding", [one() for _ in range(3)], [one() for _ in range(3)]) for _ in range(count)]


def floats(a):
    return [float(x) for x in a]


def pairwise(rule, extra, function, seed, more=(), count=6, compare="exact", others=""):
    made = []
    for text, flag, a, b in PAIRS + list(more) + some_pairs(seed, count):
        rules = rule
        if flag in ("order",):
            rules += " numbers.order"
        if flag == "fused-multiply-add":
            rules += " numbers.binary64"
        made.append(case(rules + others, text[0].upper() + text[1:] + ".", [flag] + extra, {"a": a, "b": b}, function(floats(a), floats(b)), compare, ORDERED))
    return made


def modulus(a):
    return math.sqrt(dot(a, a))


def vector_add():
    more = [("underflow is gradual", "flush-to-zero", [LEAST, -LEAST, TINY], [TINY, TINY, TINY]), ("half way: the even one", "ties", [1, 1 + 2 * EPS, 2.0**53], [EPS, EPS, 1])]
    made = pairwise("vector.add", [], lambda a, b: [a[i] + b[i] for i in range(3)], 11, more)
    made += [
        case("numbers.reading vector.add", "A number of 53 digits half way between two binary64 numbers, and one a little above.", "reading short-digits",
             {"a": [Raw("1.00000000000000011102230246251565404236316680908203125"), Raw("1.000000000000000111022302462515654042363166809082031250000000000000000000000001"), Raw("1.000000000000000111022302462515654042363166809082031249999999")], "b": [0, 0, 0]},
             [1, 1.0000000000000002, 1], source=HAND),
        case("numbers.reading numbers.subnormal", "Numbers at and below half of the smallest number: 2.4703282292062327e-324 is just below half, 2.4703282292062328e-324 just above.", "reading flush-to-zero",
             {"a": [Raw("2.4703282292062327e-324"), Raw("2.4703282292062328e-324"), Raw("1e-400")], "b": [0, 0, 0]}, [0, TINY, 0], source=HAND),
        case("numbers.reading protocol.numbers", "The same numbers in other spellings.", "reading", {"a": [Raw("1.0"), Raw("100E-2"), Raw("0.001e+3")], "b": [Raw("1e0"), Raw("-0.0"), Raw("10e-1")]}, [2, 1, 2]),
        case("protocol.request protocol.numbers", "Members in another order, and more of them.", "strict", {"z": None, "b": [Raw("1e1"), Raw("0.2E+1"), 3.0], "a": [1, 2, 3], "c": {"a": 1}}, [11, 4, 6]),
        case("protocol.request", "An empty name and a long one are ignored, too.", "strict", {"": 1, "a" * 300: [2], "a": [1, 2, 3], "b": [1, 1, 1]}, [2, 3, 4]),
        case("numbers.reading", "The famous 2.2250738585072012e-308, the smallest normal number less half a step and a bit.", "reading loop", {"a": [Raw("2.2250738585072012e-308"), Raw("2.2250738585072011e-308"), 0], "b": [0, 0, 0]},
             [2.2250738585072014e-308, 2.225073858507201e-308, 0], source=HAND),
        case("protocol.numbers numbers.negative-zero", "-0 is 0.", "negative-zero", {"a": [Raw("-0.0"), Raw("-0"), 0], "b": [Raw("-0.0"), 0, Raw("-0.0")]}, [0, 0, 0]),
        case("vector.add protocol.forms", "Integers with many digits are numbers, too.", "reading", {"a": [9007199254740993, 18446744073709551617, -9007199254740995], "b": [0, 0, 0]},
             [9007199254740992, 18446744073709551616, -9007199254740996]),
        case("vector.add protocol.request", "A field that the operation does not have is ignored.", "strict", {"a": [1, 2, 3], "b": [3, 2, 1], "note": "ignored", "k": [1]}, [4, 4, 4]),
    ]
    return made


def vector_subtract():
    more = [("underflow is gradual: x - y is 0 only if they are equal", "flush-to-zero", [2.2250738585072019e-308, LEAST, TINY], [LEAST, 2.225073858507201e-308, 1e-323]),
            ("neighbours", "rounding", [1.0000000000000002, 1, 0.9999999999999999], [1, 1.0000000000000002, 1])]
    return pairwise("vector.subtract", [], lambda a, b: [a[i] - b[i] for i in range(3)], 12, more)


def vector_cross():
    more = [("nearly parallel vectors: what cancels is not hidden", "cancellation", [1, 1, 1], [1, 1.0000000000000002, 1]),
            ("products of 27 bits that cancel to 0 after rounding", "fused-multiply-add", [0, 134217729.0, 18014398777917440.0], [0, 1, 134217729.0]),
            ("parallel vectors", "cancellation", [0.1, 0.2, 0.3], [0.2, 0.4, 0.6])]
    return pairwise("vector.cross", [], cross, 13, more)


def vector_dot():
    more = [("parallel vectors", "sign", [0.1, 0.2, 0.3], [0.2, 0.4, 0.6]), ("orthogonal vectors", "sign", [3, -4, 0], [4, 3, 9]),
            ("underflow is gradual", "flush-to-zero", [1e-160, 1e-160, 0], [1e-160, 3e-160, 1])]
    return pairwise("vector.dot", [], dot, 14, more)


def vector_distance():
    more = [("an offset that cancels", "cancellation", [1e8 + 2, 1e8 + 3, 1e8 + 6], [1e8, 1e8, 1e8]), ("a distance of 7", "sign", [1, 1, 1], [3, 4, 7]),
            ("the same, back", "sign", [3, 4, 7], [1, 1, 1])]
    usable = [p for p in PAIRS + more]
    made = []
    for text, flag, a, b in usable + some_pairs(15, 6):
        a, b = floats(a), floats(b)
        made.append(case("vector.distance", text[0].upper() + text[1:] + ".", [flag], {"a": a, "b": b}, modulus(sub(b, a)), "exact", ORDERED))
    return made


def vector_scale():
    made = []
    source = random.Random(16)
    table = [("by 3", "rounding", [0.1, -2, 0.7], 3), ("by 0", "zero", [0.1, -2, 7], 0), ("by -1", "sign", [0.1, -2, 7], -1), ("by 1", "identity", [0.1, -2, 7], 1), ("by a half, exactly", "rounding", [0.1, -2, 7], 0.5),
             ("only x", "swapped-index", [5, 0, 0], 2.5), ("only y", "swapped-index", [0, 5, 0], 2.5), ("only z", "swapped-index", [0, 0, 5], 2.5), ("the zero vector", "zero", [0, 0, 0], 17),
             ("by -0", "negative-zero", [1, -2, 3], -0.0), ("by 1/3, which is not a division by 3", "reciprocal", [3, 5, 10], 1 / 3), ("by 1/49 and a multiple of 49", "reciprocal", [49, 98, 7], 1 / 49),
             ("by 1e100", "overflow", [1e100, -1e100, 1e-100], 1e100), ("by 1e-100", "flush-to-zero", [1e100, -1e-100, 1], 1e-100), ("to subnormal numbers", "flush-to-zero", [LEAST, 3 * TINY, TINY], 0.5),
             ("from subnormal numbers", "flush-to-zero", [TINY, -7 * TINY, 1e-310], 2.0**60), ("to the largest number", "overflow", [1, -1, 0.5], MOST), ("with a factor of 27 bits", "rounding", [134217729.0, 134217727.0, 1], 134217729.0)]
    for text, flag, a, k in table + [("random digits", "rounding", [source.uniform(-9, 9) for _ in range(3)], source.uniform(-9, 9)) for _ in range(8)]:
        rules = "vector.scale" + (" numbers.subnormal" if flag == "flush-to-zero" else "") + (" numbers.negative-zero" if flag == "negative-zero" else "")
        made.append(case(rules, f"{text[0].upper() + text[1:]}.", [flag], {"a": a, "k": k}, [float(k) * float(x) for x in a], "exact", ORDERED))
    return made


SINGLES = [
    ("3, 4, 0", "order", [3, 4, 0]), ("2, 3, 6", "order", [2, 3, 6]), ("signs do not matter to the length", "sign", [-2, 3, -6]), ("only x, negative", "sign", [-5, 0, 0]), ("only y", "swapped-index", [0, 0.1, 0]),
    ("only z, negative", "swapped-index", [0, 0, -0.7]), ("1, 1, 1", "rounding", [1, 1, 1]), ("1, 1, 0", "rounding", [1, 1, 0]), ("a sum in which the order matters", "order", [1e8, 1, 1]), ("the same the other way round", "order", [1, 1, 1e8]),
    ("squares that round", "rounding", [0.1, 0.2, 0.3]), ("unit already, nearly", "rounding", [0.6, 0.8, 0]), ("a little longer than 1", "shortcut", [1.0000000000000002, 0, 0]), ("a little shorter than 1", "shortcut", [0, 0.9999999999999999, 0]),
    ("unit up to rounding, and divided once more", "shortcut", [0.5773502691896258, 0.5773502691896258, 0.5773502691896258]), ("shorter than 1e-8", "epsilon", [1e-9, 2e-9, -2e-9]), ("shorter than 1e-10", "epsilon", [3e-11, 0, 4e-11]),
    ("shorter than 1e-16", "epsilon", [0, 3e-17, 4e-17]), ("shorter than 1e-100", "epsilon", [1e-101, 2e-101, 2e-101]), ("long", "overflow", [1e100, 2e100, 2e100]), ("very flat", "rounding", [1, 1e-9, 1e-20]),
    ("divisions, not products with the inverse", "reciprocal", [0, 5, 12]), ("3, 4, 12", "reciprocal", [3, 4, 12]), ("sevenths", "reciprocal", [1 / 7, 3 / 7, 5 / 7]),
]


def singles(seed, count):
    source = random.Random(seed)
    return SINGLES + [("random digits", "rounding", [source.uniform(-9, 9) for _ in range(3)]) for _ in range(count)]


def vector_modulus():
    more = [("zero", "zero", [0, 0, 0]), ("-0", "negative-zero", [-0.0, 0.0, -0.0]), ("squares that underflow: no scaling", "scaled", [1e-170, 0, 0]), ("squares that underflow in part", "scaled", [1e-160, 2e-160, 2e-160]),
            ("the least whose square is not 0", "scaled", [0, 1.6e-162, 0]), ("squares near the largest number", "overflow", [0, 1.3e154, 0])]
    return [case("vector.modulus" + (" numbers.binary64" if flag == "rounding" else " numbers.order" if flag == "order" else ""), text[0].upper() + text[1:] + ".", [flag], {"a": a}, modulus(floats(a)), "exact", ORDERED) for text, flag, a in singles(17, 10) + more]


def unit(a):
    """vector.normalize with vector.normalize.extremes."""
    a = floats(a)
    if a == [0, 0, 0]:
        return None
    q = dot(a, a)
    if not 1e-280 < q < 1e280:
        exponent = math.frexp(max(abs(x) for x in a))[1]
        a = [math.ldexp(x, -exponent) for x in a]
        q = dot(a, a)
    length = math.sqrt(q)
    return [x / length for x in a]


def vector_normalize():
    made = [case("vector.normalize" + (" numbers.order" if flag == "reciprocal" else ""), text[0].upper() + text[1:] + ".", [flag], {"a": a}, unit(a), "exact", ORDERED) for text, flag, a in singles(18, 24)]
    zero = [[0, 0, 0], [-0.0, 0, 0], [0, -0.0, 0], [0, 0, -0.0], [-0.0, -0.0, -0.0]]
    made += [case("vector.normalize.zero numbers.negative-zero protocol.forms", "The zero vector has no unit vector, whatever the signs of its zeros.", "zero negative-zero", {"a": a}, None) for a in zero]
    extremes = [("the smallest number, along x", [TINY, 0, 0]), ("the smallest number, along y, negative", [0, -TINY, 0]), ("the smallest number, along z", [0, 0, TINY]), ("three smallest numbers", [TINY, -TINY, TINY]),
                ("subnormal numbers", [3e-320, 4e-320, 0]), ("the largest number", [MOST, 0, 0]), ("three largest numbers", [MOST, -MOST, MOST]), ("a square that overflows", [0, 3e160, -4e160]), ("a square that underflows", [2e-170, 3e-170, 6e-170]),
                ("squares that lose digits by underflow", [3e-160, 4e-160, 12e-160]), ("quadrance above 1e280: 3, 4 times 2^470", [3 * 2.0**470, 4 * 2.0**470, 0]), ("quadrance below 1e-280", [0, 3 * 2.0**-470, 4 * 2.0**-470]),
                ("quadrance 0.99e-280", [0.995e-140, 0, 0]), ("quadrance 1.01e280", [0, 1.005e140, 0]), ("just in the plain range, at its lower end", [6e-141, 6e-141, 7e-141]), ("just in the plain range, at its upper end", [5e139, 5e139, 6e139]),
                ("sizes that are farther apart than the range", [1e300, 1e-300, 0]), ("a small component that stays", [1e200, 1e190, -1e-100]), ("random digits, long", [7.34251e180, -1.25113e180, 3.3331e179]), ("random digits, short", [7.34251e-250, -1.25113e-250, 3.3331e-251]),
                ("random digits, subnormal", [1.2345e-310, -3.21e-311, 2.2e-312]), ("largest component a power of two", [0.5 * 2.0**600, 0.25 * 2.0**600, 0.3 * 2.0**600])]
    made += [case("vector.normalize.extremes vector.normalize.zero", text[0].upper() + text[1:] + ".", "overflow underflow epsilon", {"a": a}, unit(a), "exact", ORDERED) for text, a in extremes]
    return made


def angle(a, b):
    a, b = floats(a), floats(b)
    if a == [0, 0, 0] or b == [0, 0, 0]:
        return 0
    a, b = near_one(a), near_one(b)
    return nearest(datan2(modulus(cross(a, b)), dot(a, b)))


def near_one(a):
    """The vector times the power of two that brings its largest component to between 1/2 and 1."""
    exponent = math.frexp(max(abs(x) for x in a))[1]
    return [math.ldexp(x, -exponent) for x in a]


def vector_angle():
    table = [("a right angle", "cosine", [1, 0, 0], [0, 2, 0]), ("45 degrees", "cosine", [1, 0, 0], [1, 1, 0]), ("135 degrees", "sign", [1, 0, 0], [-1, 1, 0]), ("45 degrees, clockwise: an angle is not negative", "sign", [1, 0, 0], [1, -1, 0]),
             ("135 degrees, clockwise", "sign", [0, 1, 0], [0, -1, -1]), ("60 degrees", "cosine", [1, 1, 0], [1, 0, 1]), ("parallel", "cosine", [1, 2, 3], [2, 4, 6]), ("opposite", "sign", [1, 2, 3], [-2, -4, -6]),
             ("lengths do not matter", "not-normalized", [1e50, 0, 0], [1e-40, 1e-40, 0]), ("nearly parallel: 1e-9", "arc-cosine", [1, 0, 0], [1, 1e-9, 0]), ("nearly parallel: 1e-12", "arc-cosine", [1, 0, 0], [1, 0, 1e-12]),
             ("nearly parallel: 1e-30", "arc-cosine", [0, 1, 0], [0, 1, 1e-30]), ("nearly opposite", "arc-cosine", [1, 0, 0], [-1, 1e-9, 0]), ("nearly a right angle", "cosine", [1, 0, 0], [1e-9, 1, 0]), ("a little more than a right angle", "sign", [1, 0, 0], [-1e-9, 1, 0]),
             ("the same vector", "not-a-number", [0.1, 0.2, 0.3], [0.1, 0.2, 0.3]), ("the same vector, unit", "not-a-number", [0.5773502691896258, 0.5773502691896258, 0.5773502691896258], [0.5773502691896258, 0.5773502691896258, 0.5773502691896258]),
             ("-0 in a parallel vector", "negative-zero", [1, 0, 0], [1, Raw("-0.0"), Raw("-0.0")]), ("-0 in an opposite vector", "negative-zero", [1, 0, 0], [-1, Raw("-0.0"), 0]), ("0 in an opposite vector", "negative-zero", [1, 0, 0], [-1, 0, 0]),
             ("as long as a scene allows", "overflow", [1e100, 0, 0], [1e100, 1e100, 0]), ("far beyond", "overflow", [1e300, 1e300, 0], [0, 1e300, -1e300]), ("the largest number", "overflow", [MOST, 0, 0], [-MOST, MOST, 0]), ("very short", "underflow epsilon", [1e-200, 0, 0], [1e-200, 0, 1e-200]),
             ("the smallest number", "underflow epsilon", [TINY, 0, 0], [TINY, 0, -TINY]), ("a short and a long one", "underflow overflow", [1e-250, 2e-250, 0], [3e250, 0, 4e250]), ("short and nearly parallel", "underflow arc-cosine", [1e-90, 0, 0], [1e-90, 1e-98, 0]), ("only y is large", "swapped-index overflow", [0, 1e200, 0], [1e190, 1e200, 0]), ("only z is large", "swapped-index overflow", [0, 0, -1e200], [1e199, 0, 1e200]),
             ("short vectors", "epsilon", [1e-60, 1e-60, 0], [0, 1e-60, 1e-60]), ("long vectors", "overflow", [1e70, 1e70, 0], [0, 1e70, 1e70]), ("in the plane x = 0", "swapped-index", [0, 3, 4], [0, 4, 3]), ("in the plane y = 0", "swapped-index", [3, 0, 4], [4, 0, 3]),
             ("in the plane z = 0", "swapped-index", [3, 4, 0], [4, 3, 0])]
    made = [case("vector.angle" + (" numbers.negative-zero" if flag == "negative-zero" else " numbers.elementary" if "degrees" in text else ""), text[0].upper() + text[1:] + ".", flag, {"a": a, "b": b}, angle(a, b), "ulp:4", DECIMAL) for text, flag, a, b in table]
    zeros = [("The zero vector first.", [0, 0, 0], [1, 2, 3]), ("The zero vector second.", [1, 2, 3], [0, 0, 0]), ("With a negative one, whose product with 0 is -0.", [0, 0, 0], [-1, -2, -3]), ("The same the other way round.", [-1, -2, -3], [0, 0, 0]),
             ("Both zero.", [0, 0, 0], [0, 0, 0]), ("Zeros of both signs.", [Raw("-0.0"), 0, 0], [1, -1, 1]), ("Negative zeros.", [-1, 0, 0], [Raw("-0.0"), Raw("-0.0"), Raw("-0.0")])]
    made += [case("vector.angle.zero numbers.negative-zero", text, "zero negative-zero", {"a": a, "b": b}, 0, "exact", HAND) for text, a, b in zeros]
    made += [case("vector.angle numbers.elementary", "Random digits.", "rounding", {"a": a, "b": b}, angle(a, b), "ulp:4", DECIMAL) for _, _, a, b in some_pairs(19, 12)]
    return made


def operations():
    return {"vector.add": vector_add(), "vector.subtract": vector_subtract(), "vector.cross": vector_cross(), "vector.dot": vector_dot(), "vector.distance": vector_distance(), "vector.scale": vector_scale(),
            "vector.modulus": vector_modulus(), "vector.normalize": vector_normalize(), "vector.angle": vector_angle()}


if __name__ == "__main__":
    main(sys.modules[__name__])
