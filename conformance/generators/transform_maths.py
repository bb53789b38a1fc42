"""The cases of transform.*: chapter 4.3.

The matrix is made of sines and cosines in decimals of 60 digits, of angles that are reduced as fractions; turns by quarters and factors that are powers of two give results that
are compared exactly, others to 4 eps times the lengths of the vectors involved (transform.tolerance).
"""

import random
import sys
from decimal import Decimal

sys.dont_write_bytecode = True

from suite import CLOSED, DECIMAL, add, case, dcos_degrees, decimals, dot, dsin_degrees, dunit, main, numbers  # noqa: E402

EPS = 2.0**-53


def product(a, b):
    return [[dot(row, [b[0][j], b[1][j], b[2][j]]) for j in range(3)] for row in a]


def rotation(angles):
    """Rz Ry Rx in decimals."""
    (cx, sx), (cy, sy), (cz, sz) = [(dcos_degrees(a), dsin_degrees(a)) for a in map(float, angles)]
    one, none = Decimal(1), Decimal(0)
    x = [[one, none, none], [none, cx, -sx], [none, sx, cx]]
    y = [[cy, none, sy], [none, one, none], [-sy, none, cy]]
    z = [[cz, -sz, none], [sz, cz, none], [none, none, one]]
    return product(z, product(y, x))


def linear(scale, angles):
    factors = decimals(map(float, scale))
    return [[row[j] * factors[j] for j in range(3)] for row in rotation(angles)]


def applied(matrix, a):
    return [dot(row, a) for row in matrix]


def size(a):
    return sum(abs(float(x)) ** 2 for x in a) ** 0.5


def quarters(angles):
    return all(float(a) % 90 == 0 for a in angles)


def within(lengths):
    return f"abs:{4 * EPS * lengths * 1.06:.1e}"


ONE, NONE = [1, 1, 1], [0, 0, 0]

# comment, rules, flags, scale, rotation, translation
TURNS = [
    ("The identity.", "transform.matrix", "identity", ONE, NONE, NONE),
    ("A scale, every factor its own.", "transform.matrix", "swapped-index", [2, 3, 4], NONE, NONE),
    ("A translation, every part its own.", "transform.matrix", "sign swapped-index", ONE, NONE, [5, -6, 7]),
    ("A quarter turn about x.", "transform.matrix transform.quarters", "sign transposed", ONE, [90, 0, 0], NONE),
    ("A quarter turn about y.", "transform.matrix transform.quarters", "sign transposed", ONE, [0, 90, 0], NONE),
    ("A quarter turn about z.", "transform.matrix transform.quarters", "sign transposed", ONE, [0, 0, 90], NONE),
    ("A half turn about x.", "transform.quarters", "quarter", ONE, [180, 0, 0], NONE),
    ("Three quarters about y.", "transform.quarters", "quarter", ONE, [0, 270, 0], NONE),
    ("A negative quarter about z.", "transform.quarters", "sign quarter", ONE, [0, 0, -90], NONE),
    ("A whole turn about all.", "transform.quarters", "quarter", ONE, [360, -360, 720], NONE),
    ("Many turns and a quarter, about x.", "transform.quarters", "quarter reduction", ONE, [3600000000090, 0, 0], NONE),
    ("Many turns backwards and a quarter back, about y.", "transform.quarters", "quarter reduction", ONE, [0, -3600000000090, 0], NONE),
    ("1e100 degrees are a multiple of 360, and some.", "transform.quarters", "reduction", ONE, [0, 0, 1e100], NONE),
    ("1e22 degrees, which no float divides by 360.", "transform.quarters transform.tolerance", "reduction", ONE, [0, 0, 1e22], NONE),
    ("About x, then y: the order.", "transform.order transform.quarters", "order", ONE, [90, 90, 0], NONE),
    ("About y, then z: the order.", "transform.order transform.quarters", "order", ONE, [0, 90, 90], NONE),
    ("About x, then z: the order.", "transform.order transform.quarters", "order", ONE, [90, 0, 90], NONE),
    ("About x, y and z, by quarters.", "transform.order transform.quarters", "order sign", ONE, [90, -90, 90], NONE),
    ("Scale first, then turn.", "transform.order", "order", [2, 3, 4], [0, 0, 90], NONE),
    ("Scale first, then turn about x.", "transform.order", "order", [2, 8, 0.5], [90, 0, 0], NONE),
    ("Scale, turn, then translate.", "transform.order", "order", [2, 1, 1], [0, 0, 90], [1, 0, 0]),
    ("All three, about y.", "transform.order transform.matrix", "order", [0.5, 4, 2], [0, -90, 0], [10, 20, 30]),
    ("Negative factors.", "transform.matrix", "sign", [-2, 1, -0.5], NONE, [1, 1, 1]),
    ("30 degrees about x.", "transform.tolerance transform.matrix", "degrees sign", ONE, [30, 0, 0], NONE),
    ("30 degrees about y.", "transform.tolerance transform.matrix", "degrees sign", ONE, [0, 30, 0], NONE),
    ("30 degrees about z.", "transform.tolerance transform.matrix", "degrees sign", ONE, [0, 0, 30], NONE),
    ("45 degrees: the end of a quarter's rest.", "transform.quarters transform.tolerance", "quarter boundary", ONE, [0, 0, 45], NONE),
    ("-45 degrees.", "transform.quarters transform.tolerance", "quarter boundary", ONE, [-45, 0, 0], NONE),
    ("45.00000000000001 degrees.", "transform.quarters transform.tolerance", "quarter boundary", ONE, [0, 45.00000000000001, 0], NONE),
    ("135 degrees.", "transform.quarters transform.tolerance", "quarter boundary", ONE, [0, 0, 135], NONE),
    ("100 degrees: cos and sin change places and a sign.", "transform.quarters transform.tolerance", "quarter sign", ONE, [0, 0, 100], NONE),
    ("200 degrees.", "transform.quarters transform.tolerance", "quarter sign", ONE, [0, 200, 0], NONE),
    ("290 degrees.", "transform.quarters transform.tolerance", "quarter sign", ONE, [290, 0, 0], NONE),
    ("-405 degrees.", "transform.quarters transform.tolerance", "quarter sign", ONE, [0, 0, -405], NONE),
    ("1e-7 degrees.", "transform.tolerance", "rounding", ONE, [0, 1e-7, 0], NONE),
    ("89.9999999 degrees, where the cosine is small.", "transform.quarters transform.tolerance", "reduction", ONE, [89.9999999, 0, 0], NONE),
    ("100000 turns and 30 degrees.", "transform.quarters transform.tolerance", "reduction", ONE, [0, 0, 36000030], NONE),
    ("Three angles at once.", "transform.order transform.tolerance", "order sign", ONE, [10, 20, 30], NONE),
    ("Three other angles, some negative.", "transform.order transform.tolerance", "order sign", ONE, [-70, 110, 200], NONE),
    ("All together.", "transform.order transform.tolerance", "order", [2, 0.5, 3], [25, -50, 140], [1, -2, 3]),
    ("All together, mirrored.", "transform.order transform.tolerance", "order sign", [-1, 2, 4], [-15, 75, 300], [-4, 5, 6]),
]


def sent(scale, angles, translation, **more):
    """The input; what is the default is sometimes left out, so that defaults are tried."""
    made = {}
    if scale != ONE:
        made["scale"] = scale
    if angles != NONE:
        made["rotation"] = angles
    if translation != NONE:
        made["translation"] = translation
    return {**made, **more}


def matrices():
    made = []
    for comment, rules, flags, scale, angles, translation in TURNS:
        m = linear(scale, angles)
        rows = [numbers(row) + [float(t)] for row, t in zip(m, translation)] + [[0, 0, 0, 1]]
        exactly = quarters(angles)
        absent = " protocol.operations" if ONE == scale or NONE in (angles, translation) else ""
        made.append(case(rules + absent, comment, flags, sent(scale, angles, translation), rows, "exact" if exactly else within(max(abs(float(s)) for s in scale)), CLOSED if exactly else DECIMAL))
    made.append(case("transform.matrix protocol.operations", "The defaults, written out.", "default", {"scale": [1, 1, 1], "rotation": [0, 0, 0], "translation": [0, 0, 0]}, [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))
    made.append(case("transform.matrix", "Factors that are not whole, without a turn, are not rounded.", "rounding", {"scale": [0.1, 1e-300, -1e100], "translation": [1e100, 0.3, -1e-100]}, [[0.1, 0, 0, 1e100], [0, 1e-300, 0, 0.3], [0, 0, -1e100, -1e-100], [0, 0, 0, 1]]))
    return made


POINTS = [[1, 2, 3], [-4, 0.5, 8], [1, 10, 100], [0, 0, 0], [3, -2, 7]]


def positions(operation):
    made, source = [], random.Random(51)
    here = operation == "transform.position"
    for i, (comment, rules, flags, scale, angles, translation) in enumerate(TURNS):
        # A direction is not moved: so that forgetting it shows, every transformation has a translation.
        moved = translation if translation != NONE or i % 2 == 0 else [10, -20, 40]
        moved = moved if here or moved != NONE else [5, 6, -7]
        point = POINTS[i % len(POINTS)] if any(POINTS[i % len(POINTS)]) or here else [7, 8, 9]
        image = applied(linear(scale, angles), decimals(map(float, point)))
        if here:
            image = add(image, decimals(map(float, moved)))
        lengths = max(abs(float(s)) for s in scale) * size(point) + (size(moved) if here else 0)
        exactly = quarters(angles)
        made.append(case(f"{operation} {rules}" + (" transform.tolerance" if not exactly and "transform.tolerance" not in rules else ""), comment, flags, sent(scale, angles, moved, vector=point), numbers(image), "exact" if exactly else within(lengths), CLOSED if exactly else DECIMAL))
    if here:
        made.append(case("transform.position", "The translation is added last, and what is small is lost.", "order", {"scale": [2, 2, 2], "translation": [1e16, -1e16, 0.1], "vector": [0.5, 0.5, 0.1]}, [1e16, -1e16, 0.2 + 0.1], source="binary64 operations in the order of the rule"))
        made.append(case("transform.position", "The sum is rounded once: 0.7 + 0.1.", "order", {"translation": [0.1, 0.2, 0.3], "vector": [0.7, 0.1, 0.6]}, [0.7 + 0.1, 0.1 + 0.2, 0.6 + 0.3], source="binary64 operations in the order of the rule"))
    else:
        made.append(case("transform.direction", "Its length changes with it: it is not made unit.", "normalized", {"scale": [3, 3, 3], "vector": [0, 0, 1]}, [0, 0, 3]))
        made.append(case("transform.direction", "The zero vector stays.", "zero", {"scale": [3, 2, 1], "rotation": [1, 2, 3], "translation": [9, 9, 9], "vector": [0, 0, 0]}, [0, 0, 0]))
    for _ in range(4):
        scale, angles, moved, point = ([source.uniform(-3, 3) for _ in range(3)] for _ in range(4))
        angles = [a * 90 for a in angles]
        image = applied(linear(scale, angles), decimals(point))
        if here:
            image = add(image, decimals(moved))
        lengths = max(map(abs, scale)) * size(point) + (size(moved) if here else 0)
        made.append(case(f"{operation} transform.order transform.tolerance", "Random digits.", "order sign", {"scale": scale, "rotation": angles, "translation": moved, "vector": point}, numbers(image), within(lengths), DECIMAL))
    return made


def normals():
    made, source = [], random.Random(52)
    table = [(comment, rules, flags, scale, angles, moved or NONE, POINTS[i % len(POINTS)] if any(POINTS[i % len(POINTS)]) else [1, -1, 2]) for i, (comment, rules, flags, scale, angles, moved) in enumerate(TURNS)]
    table += [
        ("A mirrored x: the normal follows its side.", "transform.normal.mirror", "sign", [-2, 1, 1], NONE, NONE, [1, 0, 0]),
        ("A mirrored y.", "transform.normal.mirror", "sign", [1, -1, 1], NONE, NONE, [1, 1, 0]),
        ("A mirrored z, with a turn.", "transform.normal.mirror", "sign", [1, 1, -4], [90, 0, 0], NONE, [0, 0, 1]),
        ("Three negative factors.", "transform.normal.mirror", "sign", [-1, -2, -4], NONE, NONE, [1, 1, 1]),
        ("Two negative factors, which turn.", "transform.normal.mirror", "sign", [-1, -1, 1], NONE, NONE, [1, 2, 2]),
        ("The inverse's transpose, not the matrix.", "transform.normal", "inverse-transpose", [2, 1, 1], NONE, NONE, [0.7071067811865476, 0.7071067811865476, 0]),
        ("The same for y and z.", "transform.normal", "inverse-transpose", [1, 4, 0.5], NONE, NONE, [0, 0.6, 0.8]),
        ("The transpose, and not the inverse alone.", "transform.normal", "inverse-transpose transposed", [1, 1, 1], [0, 0, 30], NONE, [1, 0, 0]),
        ("A scale of all: the normal stays, unit.", "transform.normal", "not-normalized", [1000, 1000, 1000], NONE, NONE, [0.6, 0, 0.8]),
        ("A small scale of all.", "transform.normal", "not-normalized", [0.001, 0.001, 0.001], NONE, NONE, [0, 0.6, -0.8]),
        ("A normal that is not unit comes out unit.", "transform.normal", "not-normalized", ONE, NONE, NONE, [0, 3, 4]),
        ("A very small one, too.", "transform.normal", "epsilon", ONE, NONE, NONE, [0, 0, -1e-30]),
        ("A translation does not matter.", "transform.normal", "sign", ONE, NONE, [100, 200, 300], [0, 0, 1]),
        ("A very flat shape.", "transform.normal", "inverse-transpose", [1, 1, 1e-6], NONE, NONE, [0.6, 0, 0.8]),
    ]
    for comment, rules, flags, scale, angles, moved, normal in table:
        inverse = [decimals(map(float, normal))[j] / decimals(map(float, scale))[j] for j in range(3)]
        image = dunit(applied(rotation(angles), inverse))
        made.append(case(f"transform.normal {rules}" if "transform.normal" not in rules.split() else rules, comment, flags, sent(scale, angles, moved, vector=normal), numbers(image), "abs:1e-15", DECIMAL))
    for _ in range(5):
        scale, angles, normal = [source.uniform(0.3, 3) * source.choice((-1, 1)) for _ in range(3)], [source.uniform(-200, 200) for _ in range(3)], [source.uniform(-1, 1) for _ in range(3)]
        image = dunit(applied(rotation(angles), [n / s for n, s in zip(decimals(normal), decimals(scale))]))
        made.append(case("transform.normal transform.tolerance", "Random digits.", "inverse-transpose sign", {"scale": scale, "rotation": angles, "vector": normal}, numbers(image), "abs:1e-15", DECIMAL))
    return made


def rays():
    made = []
    for i, (comment, rules, flags, scale, angles, translation) in enumerate(TURNS):
        origin, direction = POINTS[(i + 1) % len(POINTS)], [[0, 0, 2], [0.5, -1, 0.25], [-1, 2, 4]][i % 3]
        moved = translation if translation != NONE or i % 2 == 0 else [10, -20, 40]
        m = linear(scale, angles)
        start, way = add(applied(m, decimals(map(float, origin))), decimals(map(float, moved))), applied(m, decimals(map(float, direction)))
        factor, exactly = max(abs(float(s)) for s in scale), quarters(angles)
        compare = "exact" if exactly else {"origin": within(factor * size(origin) + size(moved)), "direction": within(factor * size(direction))}
        made.append(case(f"transform.ray {rules}", comment, flags, sent(scale, angles, moved, ray={"origin": origin, "direction": direction}), {"origin": numbers(start), "direction": numbers(way)}, compare, CLOSED if exactly else DECIMAL))
    made.append(case("transform.ray", "The direction is not made unit: points keep their parameter.", "normalized", {"scale": [2, 2, 2], "ray": {"origin": [1, 0, 0], "direction": [0, 0.6, 0.8]}}, {"origin": [2, 0, 0], "direction": [0, 1.2, 1.6]}))
    made.append(case("transform.ray", "The direction is not moved.", "translated-direction", {"translation": [0, 0, 1], "ray": {"origin": [1, 0, 0], "direction": [0, 0, 1]}}, {"origin": [1, 0, 1], "direction": [0, 0, 1]}))
    return made


def operations():
    return {"transform.matrix": matrices(), "transform.position": positions("transform.position"), "transform.direction": positions("transform.direction"), "transform.normal": normals(), "transform.ray": rays()}


if __name__ == "__main__":
    main(sys.modules[__name__])
