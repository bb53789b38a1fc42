"""Where a line meets each shape, worked out from what the shape is, in decimals of 60 digits.

A shape is the JSON object of the protocol. It is treated as a set of points: every surface that bounds it (planes, quadrics, the quartic of a torus) is met on its own, and of
those parameters the ones are kept at which the point is on the shape. That is not how a ray tracer in binary64 does it; what both agree in is the specification.

`Unsafe` is raised where rounding in binary64 might decide: such a case is chosen by hand or not at all.
"""

from decimal import Decimal

import suite
from suite import PI, add, cross, datan2, dcos_degrees, decimal, decimals, dot, dsin_degrees, dunit, sub, times

TINY = Decimal("1e-40")
SMALLEST_PARAMETER = Decimal("1e-8")
SURFACE, ROUND, END = Decimal("1e-10"), Decimal("1e-7"), Decimal("1e-10")

DEFAULTS = {
    "sphere": {"position": [0, 0, 0], "ray": 1},
    "plane": {"position": [0, 0, 0], "normal": [0, 0, 1]},
    "disk": {"position": [0, 0, 0], "normal": [0, 0, 1], "ray": 1},
    "annulus": {"position": [0, 0, 0], "normal": [0, 0, 1], "ray": 1, "inner_ray": 0.5},
    "triangle": {"point": [[0, 0, 0], [0, 1, 0], [1, 1, 0]]},
    "btriangle": {"point": [[0, 0, 0], [0, 1, 0], [1, 1, 0]], "normal": [], "uv": []},
    "tube": {"point": [[0, 0, 0], [0, 0, 1]], "ray": 1},
    "cylinder": {"point": [[0, 0, 0], [0, 0, 1]], "ray": 1},
    "cone": {"point": [[0, 0, 0], [0, 0, 1]], "ray": 1},
    "cube": {"position": [0, 0, 0], "size": 1},
    "spherical_cap": {"position": [0, 0, 0], "normal": [0, 0, 1], "ray": 1, "curvature": 1},
    "lens": {"point": [[0, 0, 0], [0, 0, 1]], "ray": 1, "curvature": [1, 1]},
    "torus": {"position": [0, 0, 0], "normal": [0, 0, 1], "major_radius": 1, "minor_radius": 0.2},
    "geometry": {"scale": [1, 1, 1], "rotation": [0, 0, 0], "translation": [0, 0, 0]},
}
CLOSED = ("sphere", "cube", "cylinder", "cone", "lens", "torus")


class Unsafe(Exception):
    """Rounding might decide this case."""


def full(shape):
    """A shape with its defaults, numbers and vectors in decimals."""
    made = dict(DEFAULTS[shape["kind"]])
    made.update(shape)

    def precise(value):
        if isinstance(value, list):
            return [precise(inner) for inner in value]
        return value if isinstance(value, (str, dict)) else decimal(value)

    return {name: precise(value) for name, value in made.items()}


# Polynomials


def value(c, x):
    total = Decimal(0)
    for one in c:
        total = total * x + one
    return total


def product(a, b):
    made = [Decimal(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            made[i + j] += x * y
    return made


def roots(c):
    """The real roots of a polynomial, the leading coefficient first, ascending, with multiplicity: between the zeros of its derivative there is one or none."""
    c = list(c)
    size = max([abs(x) for x in c] + [Decimal(0)])
    while c and abs(c[0]) <= TINY * size:
        c = c[1:]
    degree = len(c) - 1
    if degree < 1:
        return []
    if degree == 1:
        return [-c[1] / c[0]]
    if degree == 2:
        a, b, e = c
        discriminant = b * b - 4 * a * e
        if abs(discriminant) <= TINY * (b * b + abs(4 * a * e)):
            return [-b / (2 * a)] * 2
        if discriminant < 0:
            return []
        s = discriminant.sqrt()
        return sorted([(-b - s) / (2 * a), (-b + s) / (2 * a)])
    bound = 1 + max(abs(x / c[0]) for x in c[1:])
    slopes = roots([x * (degree - i) for i, x in enumerate(c[:-1])])
    found, known = [], []
    for x in slopes:
        if known and abs(x - known[-1]) <= Decimal("1e-20") * bound:
            continue
        known.append(x)
    zero = lambda x: abs(value(c, x)) <= Decimal("1e-33") * sum(abs(k) * max(abs(x), bound / 1000000) ** (degree - i) for i, k in enumerate(c))
    for x in known:
        if zero(x):
            found += [x] * (1 + sum(1 for y in slopes if abs(x - y) <= Decimal("1e-20") * bound))
    ends = [-bound] + known + [bound]
    for low, high in zip(ends, ends[1:]):
        if zero(low) or zero(high) or (value(c, low) > 0) == (value(c, high) > 0):
            continue
        rising = value(c, high) > 0
        for _ in range(210):
            middle = (low + high) / 2
            if (value(c, middle) > 0) == rising:
                high = middle
            else:
                low = middle
        found.append((low + high) / 2)
    return sorted(found)


# Parts that shapes have in common


def across(s, a):
    return sub(a, times(dot(a, s), s))


def length(a):
    return dot(a, a).sqrt()


def at(o, d, t):
    return add(o, times(t, d))


def axis(g):
    s = sub(g["point"][1], g["point"][0])
    return g["point"][0], dunit(s), length(s)


def line_plane(o, d, p, n):
    a = dot(n, d)
    return [] if a == 0 or abs(a) < TINY * length(d) else [dot(n, sub(p, o)) / a]


def line_sphere(o, d, c, r):
    w = sub(o, c)
    return roots([dot(d, d), 2 * dot(w, d), dot(w, w) - r * r])


def line_bar(o, d, p, s, r):
    w, e = across(s, sub(o, p)), across(s, d)
    if dot(e, e) <= TINY * dot(d, d):
        return []
    return roots([dot(e, e), 2 * dot(w, e), dot(w, w) - r * r])


def frame(n):
    sizes = [abs(x) for x in n]
    least = min(sizes)
    if any(0 < x - least < Decimal("1e-6") for x in sizes):
        raise Unsafe("the frame hangs on rounding")
    i = sizes.index(least)
    along = [Decimal(1 if i == j else 0) for j in range(3)]
    e1 = dunit(sub(along, times(dot(along, n), n)))
    return e1, cross(n, e1)


def turn(y, x):
    """An angle as a part of a turn, 0 for the direction of x; not on the seam, nor where it has no meaning to rounding."""
    if x < 0 and abs(y) < Decimal("1e-9") * abs(x):
        raise Unsafe("on the seam")
    if 0 < abs(x) + abs(y) < Decimal("1e-9"):
        raise Unsafe("next to a pole")
    return datan2(y, x) / (2 * PI)


def disk_uv(v, p, n, r):
    e1, e2 = frame(n)
    w = sub(v, p)
    return [Decimal("0.5") + dot(w, e1) / (2 * r), Decimal("0.5") - dot(w, e2) / (2 * r)]


def side_uv(v, p, s, h):
    e1, e2 = frame(s)
    w = sub(v, p)
    return [Decimal("0.5") + turn(dot(w, e2), dot(w, e1)), 1 - dot(w, s) / h]


def sign(x):
    return 1 if x > 0 else -1 if x < 0 else 0


def depth(c, r):
    """How far the centre of a cap's sphere is behind the cap's disk."""
    return sign(c) * (c * c - r * r).sqrt()


# The parameters of each shape: pairs of a parameter and the part of the surface, the parts in the order that decides on an edge


def meets_plane(g, o, d):
    return [(t, "") for t in line_plane(o, d, g["position"], dunit(g["normal"]))]


def meets_disk(g, o, d):
    inner = g.get("inner_ray", Decimal(-1))
    return [(t, "") for t, _ in meets_plane(g, o, d) if inner - TINY <= length(sub(at(o, d, t), g["position"])) <= g["ray"] + TINY]


def meets_sphere(g, o, d):
    return [(t, "") for t in line_sphere(o, d, g["position"], g["ray"])]


FACES = [(2, 1, "+z"), (2, -1, "-z"), (1, 1, "+y"), (1, -1, "-y"), (0, 1, "+x"), (0, -1, "-x")]


def meets_cube(g, o, d):
    h, w, found = g["size"] / 2, sub(o, g["position"]), []
    for i, side, name in FACES:
        if d[i] != 0:
            t = (side * h - w[i]) / d[i]
            if all(abs(w[j] + t * d[j]) <= h + TINY for j in range(3) if j != i):
                found.append((t, name))
    return found


def flat_normal(g):
    p0, p1, p2 = g["point"]
    return dunit(cross(sub(p1, p0), sub(p2, p0)))


def barycentric(p0, p1, p2, v):
    w, s1, s2 = sub(v, p0), sub(p1, p0), sub(p2, p0)
    whole = dot(cross(s1, s2), cross(s1, s2))
    return dot(cross(w, s2), cross(s1, s2)) / whole, dot(cross(s1, w), cross(s1, s2)) / whole


def meets_triangle(g, o, d):
    n = cross(sub(g["point"][1], g["point"][0]), sub(g["point"][2], g["point"][0]))
    found = []
    for t in line_plane(o, d, g["point"][0], dunit(n)):
        t1, t2 = barycentric(*g["point"], at(o, d, t))
        if t1 >= -TINY and t2 >= -TINY and t1 + t2 <= 1 + TINY:
            found.append((t, ""))
    return found


def meets_tube(g, o, d):
    p, s, h = axis(g)
    return [(t, "side") for t in line_bar(o, d, p, s, g["ray"]) if -TINY <= dot(sub(at(o, d, t), p), s) <= h + TINY]


def ends(o, d, p, s, h, r, names):
    found = []
    for place, name in zip((p, at(p, s, h)), names):
        if name:
            found += [(t, name) for t in line_plane(o, d, place, s) if length(across(s, sub(at(o, d, t), place))) <= r + TINY]
    return found


def meets_cylinder(g, o, d):
    p, s, h = axis(g)
    return meets_tube(g, o, d) + ends(o, d, p, s, h, g["ray"], ("low", "high"))


def meets_cone(g, o, d):
    p, s, h = axis(g)
    k, apex = g["ray"] / h, at(p, s, h)
    w = sub(o, apex)
    wp, dp, a, da = across(s, w), across(s, d), dot(w, s), dot(d, s)
    found = []
    for t in roots([dot(dp, dp) - k * k * da * da, 2 * (dot(wp, dp) - k * k * da * a), dot(wp, wp) - k * k * a * a]):
        if -h - TINY <= a + t * da <= TINY:
            found.append((t, "side"))
    return found + ends(o, d, p, s, h, g["ray"], ("low", None))


def meets_cap(g, o, d):
    n, c = dunit(g["normal"]), g["curvature"]
    centre = sub(g["position"], times(depth(c, g["ray"]), n))
    return [(t, "") for t in line_sphere(o, d, centre, abs(c)) if sign(c) * dot(sub(at(o, d, t), g["position"]), n) >= -TINY]


def meets_lens(g, o, d):
    p, s, h = axis(g)
    r, (c1, c2) = g["ray"], g["curvature"]
    found = list(meets_tube(g, o, d))
    for name, c, disk, outward in (("first", c1, p, times(-1, s)), ("second", c2, at(p, s, h), s)):
        centre = sub(disk, times(depth(c, r), outward))
        for t in line_sphere(o, d, centre, abs(c)):
            v = at(o, d, t)
            if length(across(s, sub(v, p))) <= r + TINY and sign(c) * dot(sub(v, centre), outward) >= -TINY and not_behind(g, v, name):
                found.append((t, name))
    return found


def not_behind(g, v, name):
    """The other face is not crossed before: a lens that is possible at its middle may be none next to it."""
    p, s, h = axis(g)
    z, off = dot(sub(v, p), s), dot(across(s, sub(v, p)), across(s, sub(v, p)))
    bulge = lambda c: sign(c) * (max(c * c - off, Decimal(0)).sqrt() - (c * c - g["ray"] ** 2).sqrt())
    return z <= h + bulge(g["curvature"][1]) + TINY if name == "first" else z >= -bulge(g["curvature"][0]) - TINY


def meets_torus(g, o, d):
    n, big, small = dunit(g["normal"]), g["major_radius"], g["minor_radius"]
    w = sub(o, g["position"])
    start = -dot(w, d) / dot(d, d)
    w = at(w, d, start)
    squared = [dot(d, d), 2 * dot(w, d), dot(w, w)]
    height = [dot(n, d), dot(n, w)]
    left = squared[:2] + [squared[2] + big * big - small * small]
    right = [x - y for x, y in zip(squared, product(height, height))]
    quartic = product(left, left)
    for i, x in enumerate(right):
        quartic[i + 2] -= 4 * big * big * x
    return [(start + t, "") for t in roots(quartic)]


def matrix(g):
    """The rows of Rz Ry Rx."""
    (cx, cy, cz), (sx, sy, sz) = ([f(suite.exact(x)) for x in g["rotation"]] for f in (dcos_degrees, dsin_degrees))
    x = [[1, 0, 0], [0, cx, -sx], [0, sx, cx]]
    y = [[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]]
    z = [[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]]
    times_matrix = lambda a, b: [[sum((decimal(a[i][k]) * decimal(b[k][j]) for k in range(3)), Decimal(0)) for j in range(3)] for i in range(3)]
    return times_matrix(z, times_matrix(y, x))


def carried_back(g, a):
    """A direction carried back: with the transpose of the rotation, then divided by the factors."""
    rows = matrix(g)
    turned = [sum((rows[i][j] * a[i] for i in range(3)), Decimal(0)) for j in range(3)]
    return [x / k for x, k in zip(turned, g["scale"])]


def meets_geometry(g, o, d):
    return [(t, (t, tag)) for t, tag in meets(g["geometry"], carried_back(g, sub(o, g["translation"])), carried_back(g, d))]


MEETS = {"plane": meets_plane, "disk": meets_disk, "annulus": meets_disk, "sphere": meets_sphere, "cube": meets_cube, "triangle": meets_triangle, "btriangle": meets_triangle,
         "tube": meets_tube, "cylinder": meets_cylinder, "cone": meets_cone, "spherical_cap": meets_cap, "lens": meets_lens, "torus": meets_torus, "geometry": meets_geometry}


def meets(shape, o, d):
    """All parameters at which a line meets a shape, ascending, with the part of the surface; of several parts at one parameter the one that decides comes first."""
    found = sorted(MEETS[shape["kind"]](full(shape), o, d), key=lambda one: one[0])
    order = {name: i for i, (_, _, name) in enumerate(FACES)}
    grouped = []
    for one in found:
        if grouped and abs(one[0] - grouped[-1][0][0]) <= TINY * (1 + abs(one[0])):
            grouped[-1].append(one)
        else:
            grouped.append([one])
    return [one for group in grouped for one in (sorted(group, key=lambda x: order.get(x[1], 9)) if shape["kind"] == "cube" else group)]


def normal(shape, v, tag):
    g = full(shape)
    kind = g["kind"]
    if kind in ("plane", "disk", "annulus"):
        return dunit(g["normal"])
    if kind == "sphere":
        return dunit(sub(v, g["position"]))
    if kind == "cube":
        i, side, _ = next(face for face in FACES if face[2] == tag)
        return [Decimal(side if j == i else 0) for j in range(3)]
    if kind == "triangle":
        return flat_normal(g)
    if kind == "btriangle":
        t1, t2 = barycentric(*g["point"], v)
        flat = flat_normal(g)
        corners = [dunit(g["normal"][i]) if i < len(g["normal"]) else flat for i in range(3)]
        mixed = add(add(times(1 - t1 - t2, corners[0]), times(t1, corners[1])), times(t2, corners[2]))
        return flat if length(mixed) < TINY else dunit(mixed)
    if kind == "spherical_cap":
        n = dunit(g["normal"])
        return dunit(times(1 / g["curvature"], sub(v, sub(g["position"], times(depth(g["curvature"], g["ray"]), n)))))
    if kind == "torus":
        n, w = dunit(g["normal"]), sub(v, g["position"])
        flat = across(n, w)
        if length(flat) < TINY:
            return n if dot(n, w) >= 0 else times(-1, n)
        inner = dot(w, w) + g["major_radius"] ** 2 - g["minor_radius"] ** 2 < 0
        return dunit(sub(w, times(-g["major_radius"] if inner else g["major_radius"], dunit(flat))))
    if kind == "geometry":
        n = normal(g["geometry"], carried_back(g, sub(v, g["translation"])), tag[1])
        rows = matrix(g)
        return dunit([sum((rows[i][j] * n[j] / g["scale"][j] for j in range(3)), Decimal(0)) for i in range(3)])
    p, s, h = axis(g)
    if tag == "low":
        return times(-1, s)
    if tag == "high":
        return s
    if kind == "lens" and tag != "side":
        disk, outward, c = (p, times(-1, s), g["curvature"][0]) if tag == "first" else (at(p, s, h), s, g["curvature"][1])
        return dunit(times(sign(c), sub(v, sub(disk, times(depth(c, g["ray"]), outward)))))
    e = across(s, sub(v, p))
    if kind == "cone":
        return s if length(e) < TINY else dunit(add(dunit(e), times(g["ray"] / h, s)))
    return dunit(e)


def uv(shape, v, tag):
    g = full(shape)
    kind = g["kind"]
    half = Decimal("0.5")
    if kind == "plane":
        e1, e2 = frame(dunit(g["normal"]))
        w = sub(v, g["position"])
        return [dot(w, e1), -dot(w, e2)]
    if kind in ("disk", "annulus", "spherical_cap"):
        return disk_uv(v, g["position"], dunit(g["normal"]), g["ray"])
    if kind == "sphere":
        x, y, z = normal(shape, v, tag)
        return [half + turn(z, x), datan2((x * x + z * z).sqrt(), y) / PI]
    if kind == "cube":
        n = normal(shape, v, tag)
        return disk_uv(v, add(g["position"], times(g["size"] / 2, n)), n, g["size"] / 2)
    if kind == "triangle":
        return list(barycentric(*g["point"], v))
    if kind == "btriangle":
        t1, t2 = barycentric(*g["point"], v)
        corners = [g["uv"][i] if i < len(g["uv"]) else [Decimal(0), Decimal(0)] for i in range(3)]
        return [(1 - t1 - t2) * corners[0][i] + t1 * corners[1][i] + t2 * corners[2][i] for i in range(2)]
    if kind == "torus":
        n, w = dunit(g["normal"]), sub(v, g["position"])
        e1, e2 = frame(n)
        return [half + turn(dot(w, e2), dot(w, e1)), half - turn(dot(w, n), length(across(n, w)) - g["major_radius"])]
    if kind == "geometry":
        return uv(g["geometry"], carried_back(g, sub(v, g["translation"])), tag[1])
    p, s, h = axis(g)
    if tag == "low":
        return disk_uv(v, p, times(-1, s), g["ray"])
    if tag == "high":
        return disk_uv(v, at(p, s, h), s, g["ray"])
    if tag in ("first", "second"):
        return disk_uv(v, p, s, g["ray"])
    return side_uv(v, p, s, h)


def first(shape, o, d, above=SMALLEST_PARAMETER):
    """The first parameter above the smallest one, with the part of the surface."""
    for t, tag in meets(shape, o, d):
        if abs(t - above) < TINY:
            raise Unsafe("at the smallest parameter")
        if t > above:
            return t, tag
    return None


def hit(shape, ray):
    """The hit of a ray in decimals: parameter, point, normal, texture coordinates; or nothing."""
    o, d = decimals(ray["origin"]), decimals(ray["direction"])
    found = first(shape, o, d)
    if found is None:
        return None
    v = at(o, d, found[0])
    return {"t": found[0], "point": v, "normal": normal(shape, v, found[1]), "uv": uv(shape, v, found[1])}


def near(x):
    """The binary64 number nearest to a decimal; what is left of a zero after 60 digits is 0."""
    return 0.0 if abs(x) < Decimal("1e-45") else suite.nearest(x)


def rounded(made):
    return None if made is None else {name: near(x) if name == "t" else [near(y) for y in x] for name, x in made.items()}


def steady(shape, ray, by=Decimal("1e-6")):
    """Whether a hit, or that there is none, hardly changes when the ray is moved by very little."""
    o, d = decimals(ray["origin"]), decimals(ray["direction"])
    here = first(shape, o, d)
    for i in range(3):
        for move in (by, -by):
            there = first(shape, [x + (move if i == j else 0) for j, x in enumerate(o)], d)
            if (here is None) != (there is None):
                return False
            if here is not None:
                a, b = at(o, d, here[0]), at(o, d, there[0])
                if abs(here[0] - there[0]) > 1000 * by or length(sub(normal(shape, a, here[1]), normal(shape, b, there[1]))) > 1000 * by:
                    return False
    return True


def contains(shape, point):
    """Whether a point is inside, with the tolerances of the rules; not where rounding might decide."""
    g = full(shape)
    return g["kind"] in CLOSED + ("geometry",) and inside(g, decimals(point))


def less(a, b, scale):
    if abs(a - b) < Decimal("1e-13") * scale:
        raise Unsafe("at the border of the tolerance")
    return a < b


def inside(g, v):
    kind = g["kind"]
    if kind == "geometry":
        return contains(g["geometry"], carried_back(g, sub(v, g["translation"])))
    if kind == "sphere":
        return less(length(sub(v, g["position"])), (1 - SURFACE) * g["ray"], g["ray"])
    if kind == "cube":
        h = g["size"] / 2
        return all([less(abs(x), (1 - SURFACE) * h, h) for x in sub(v, g["position"])])
    if kind == "torus":
        n, w = dunit(g["normal"]), sub(v, g["position"])
        h, rho = dot(n, w), length(across(n, w))
        return less(((rho - g["major_radius"]) ** 2 + h * h).sqrt(), (1 - ROUND) * g["minor_radius"], g["minor_radius"])
    p, s, h = axis(g)
    w = sub(v, p)
    z, off = dot(w, s), length(across(s, w))
    if kind == "cylinder":
        return all([less(off, (1 - ROUND) * g["ray"], g["ray"]), less(END, z, 1), less(END, h - z, 1)])
    if kind == "cone":
        return less(END, z, 1) and less(END, h - z, 1) and less(off, (1 - ROUND) * abs((1 - z / h) * g["ray"]), g["ray"])
    sides = [less(off, (1 - ROUND) * g["ray"], g["ray"])]
    for c, disk, outward in ((g["curvature"][0], p, times(-1, s)), (g["curvature"][1], at(p, s, h), s)):
        w = add(sub(v, disk), times(depth(c, g["ray"]), outward))
        far = length(w)
        if c > 0:
            sides.append(dot(w, outward) <= 0 or less(far, (1 - SURFACE) * c, c))
        else:
            sides.append(less((1 + SURFACE) * -c, far, -c) and dot(w, outward) <= 0)
    return all(sides)
