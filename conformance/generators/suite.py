"""What the generators of the conformance suite share: cases, files, and arithmetic that does not round.

A generator is a module beside this one with a function `operations()`, which gives a dictionary from the name of an operation to the list of its cases, and perhaps a
function `pictures()`, a dictionary from the name of a file of conformance/pictures to its bytes. `generate.py` runs them all, those last that say `LAST = True`. Nothing here, and nothing in the generators,
calls a ray tracer of the outside: an expected value comes from whole numbers, fractions, decimals of many digits, or binary64 operations in an order that a rule fixes
(Python's floats are binary64, and + - * / and math.sqrt round once).

Standard library of Python 3.11.
"""

import argparse
import os
import struct
import sys
import zlib
from decimal import Decimal, getcontext
from fractions import Fraction

FOLDER = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
VECTORS, PICTURES = os.path.join(FOLDER, "vectors"), os.path.join(FOLDER, "pictures")

PROFILES = {"vector": "maths", "roots": "maths", "transform": "maths", "ray": "geometry", "intersect": "geometry", "geometry": "geometry", "triangle": "geometry",
            "optics": "optics", "light": "lighting", "scene": "scene", "camera": "scene"}

# Where expected values come from: what stands in the field `source`.
EXACT = "exact rational arithmetic, rounded once"
ORDERED = "binary64 operations in the order of the rule"
DECIMAL = "decimal arithmetic with 60 digits"
CLOSED = "closed form"
HAND = "by hand, from the rule"

getcontext().prec = 60


# Cases and files


class Raw(str):
    """A number of the input that is written with these very characters, as -0.0 or 1e-400."""


def profile_of(operation):
    return "picture" if operation in ("scene.pixel", "scene.picture") else PROFILES[operation.split(".")[0]]


def case(rules, comment, flags, sent, ok, compare="exact", source=HAND):
    """A case without its name. Rules and flags are words separated by blanks, or lists."""
    split = lambda words: words.split() if isinstance(words, str) else list(words)
    made = {"rules": split(rules), "comment": comment, "flags": split(flags), "in": sent, "ok": ok}
    if compare != "exact":
        made["compare"] = compare
    made["source"] = source
    return made


def json_text(value):
    """JSON on one line: members in the order in which they were put in, numbers as `repr` writes them."""
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, str):
        return '"' + "".join(escaped(c) for c in value) + '"'
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if value != value or value in (float("inf"), float("-inf")):
            raise ValueError("NaN and infinities cannot be sent")
        return repr(value)
    if isinstance(value, (Fraction, Decimal)):
        return repr(float(value))
    if isinstance(value, dict):
        return "{" + ",".join(json_text(str(name)) + ":" + json_text(inner) for name, inner in value.items()) + "}"
    return "[" + ",".join(json_text(inner) for inner in value) + "]"


def escaped(c):
    short = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t", "\f": "\\f", "\b": "\\b"}
    if c in short:
        return short[c]
    if ord(c) < 32 or 126 < ord(c) < 65536:
        return f"\\u{ord(c):04x}"
    if ord(c) >= 65536:
        high = ord(c) - 65536
        return f"\\u{0xD800 + (high >> 10):04x}\\u{0xDC00 + (high & 1023):04x}"
    return c


def vectors_text(operation, cases):
    """The text of a vector file: one case a line, numbered from 1 on."""
    seen, lines = {}, []
    for number, one in enumerate(cases, 1):
        same = json_text(one["in"])
        if same in seen:
            raise ValueError(f"{operation}: case {number} ({one['comment']}) asks the same as case {seen[same]}")
        seen[same] = number
        lines.append(json_text({"id": f"{operation}/{number:04d}", **one}))
    head = f'{{"operation":{json_text(operation)},"profile":{json_text(profile_of(operation))},"cases":[\n'
    return head + ",\n".join(lines) + "\n]}\n"


def files_of(*modules):
    """The files that generators make: a dictionary from paths to bytes. The cases of one operation may come from several generators, one after the other."""
    cases, made = {}, {}
    for module in modules:
        for operation, found in module.operations().items():
            cases.setdefault(operation, []).extend(found)
        if hasattr(module, "pictures"):
            made.update({os.path.join(PICTURES, name): data for name, data in module.pictures().items()})
    made.update({os.path.join(VECTORS, operation + ".json"): vectors_text(operation, found).encode("utf-8") for operation, found in cases.items()})
    return made


def write(files, check):
    """Writes files, or with `check` only says which of them would change. True if all was well."""
    well = True
    for path, data in sorted(files.items()):
        old = None
        if os.path.exists(path):
            with open(path, "rb") as file:
                old = file.read()
        if old == data:
            continue
        if check:
            well = False
            print(f"{path}: the generators make something else")
        else:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(data)
            print(path)
    return well


def main(*modules):
    parser = argparse.ArgumentParser(description="Writes vector files of the conformance suite.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit code 1 if a file would change")
    options = parser.parse_args()
    sys.exit(0 if write(files_of(*modules), options.check) else 1)


# PNG: 8 bits a channel, colour type 6, stored blocks, so that no version of a compressor changes a byte


def png(width, height, rgba):
    chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    raw = b"".join(b"\0" + bytes(rgba[row * width * 4 : (row + 1) * width * 4]) for row in range(height))
    parts = [raw[at : at + 65535] for at in range(0, len(raw), 65535)]
    stored = b"".join(struct.pack("<BHH", 1 if i == len(parts) - 1 else 0, len(part), 65535 - len(part)) + part for i, part in enumerate(parts))
    packed = b"\x78\x01" + stored + struct.pack(">I", zlib.adler32(raw))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


# Numbers


def exact(x):
    """A binary64 number, a whole number or a decimal as the fraction that it is."""
    return Fraction(x)


def decimal(x):
    """A fraction, float or whole number as a decimal of 60 digits."""
    if isinstance(x, Decimal):
        return x
    x = Fraction(x)
    return Decimal(x.numerator) / Decimal(x.denominator)


def nearest(x):
    """The binary64 number nearest to a fraction or a decimal, ties to even."""
    return float(Fraction(x)) if not isinstance(x, float) else x


def next_up(x, steps=1):
    """The binary64 number so many steps above x (below, if negative)."""
    rank = struct.unpack("<q", struct.pack("<d", x))[0]
    rank = rank if rank >= 0 else -(2**63) - rank
    rank += steps
    return struct.unpack("<d", struct.pack("<q", rank if rank >= 0 else -(2**63) - rank))[0]


def ulps(a, b):
    """How many steps lead from one binary64 number to another."""
    rank = lambda x: (lambda bits: bits if bits >= 0 else -(2**63) - bits)(struct.unpack("<q", struct.pack("<d", x))[0])
    return abs(rank(a) - rank(b))


def integer_root(n):
    """The square root of a fraction if it is a fraction, else None."""
    from math import isqrt

    n = Fraction(n)
    if n < 0:
        return None
    p, q = isqrt(n.numerator), isqrt(n.denominator)
    return Fraction(p, q) if p * p == n.numerator and q * q == n.denominator else None


def dsqrt(x):
    """The square root of a decimal or fraction, to 60 digits."""
    return decimal(x).sqrt()


def _pi():
    # Machin: pi = 16 atan(1/5) - 4 atan(1/239)
    def arctan_of_inverse(n):
        one, total, k, sign = 10**75, 0, 1, 1
        power = one // n
        while power:
            total += sign * (power // k)
            power //= n * n
            k, sign = k + 2, -sign
        return total

    return Decimal(16 * arctan_of_inverse(5) - 4 * arctan_of_inverse(239)) / Decimal(10**75)


PI = _pi()


def dsin(x):
    x = decimal(x) % (2 * PI)
    term, total, k = x, x, 1
    while abs(term) > Decimal("1e-70"):
        term = -term * x * x / ((k + 1) * (k + 2))
        total += term
        k += 2
    return total


def dcos(x):
    return dsin(decimal(x) + PI / 2)


def dtan(x):
    return dsin(x) / dcos(x)


def datan(x):
    """The arc tangent: halved until it is small, then by its series."""
    x, doubled = decimal(x), 0
    while abs(x) > Decimal("0.01"):
        x, doubled = x / (1 + (1 + x * x).sqrt()), doubled + 1
    term, total, k = x, x, 1
    while abs(term) > Decimal("1e-75"):
        term = -term * x * x
        k += 2
        total += term / k
    return total * 2**doubled


def datan2(y, x):
    y, x = decimal(y), decimal(x)
    if x > 0:
        return datan(y / x)
    if y == 0:
        return PI if x < 0 else Decimal(0)
    if x == 0:
        return PI / 2 if y > 0 else -PI / 2
    return datan(y / x) + (PI if y > 0 else -PI)


def dpow(x, y):
    """x to the power y, with 0^0 = 1."""
    x, y = decimal(x), decimal(y)
    if y == 0:
        return Decimal(1)
    return Decimal(0) if x == 0 else x**y


def dexp(x):
    return decimal(x).exp()


def dsin_degrees(degrees):
    """The sine of an angle in degrees, exact where it is -1, -1/2, 0, 1/2 or 1."""
    known = {0: 0, 30: "0.5", 90: 1, 150: "0.5", 180: 0, 210: "-0.5", 270: -1, 330: "-0.5"}
    rest = Fraction(degrees) % 360
    return Decimal(known[int(rest)]) if rest in known else dsin(decimal(rest) * PI / 180)


def dcos_degrees(degrees):
    return dsin_degrees(Fraction(degrees) + 90)


# Vectors of any kind of number


def dot(a, b):
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def times(k, a):
    return [k * x for x in a]


def decimals(a):
    return [decimal(x) for x in a]


def dunit(a):
    """A vector made unit, in decimals."""
    a = decimals(a)
    length = dot(a, a).sqrt()
    return [x / length for x in a]


def numbers(a):
    """A vector rounded to binary64."""
    return [nearest(x) for x in a]
