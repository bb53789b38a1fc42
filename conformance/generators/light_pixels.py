"""Pixels that show light, shadows, mirrors, glass and media: cases of scene.pixel.

A scene is a dictionary; its text and the colour of the pixel are both made from it. The colour is worked out in decimals of 60 digits, from the equations of chapters 6 and 7
and the surfaces of `solids`; no channel is nearer than 1/50 to a number at which its byte changes.
"""

import random
import struct
import sys
from decimal import Decimal

sys.dont_write_bytecode = True

import solids  # noqa: E402
import suite  # noqa: E402
from suite import DECIMAL, HAND, PI, add, case, decimal, decimals, dcos, dexp, dot, dpow, dsin, dunit, sub, times  # noqa: E402

MATERIAL = {"color": [1, 1, 1], "ka": 0.2, "kd": 0.8, "ks": 0.5, "kr": 0, "kt": 0, "shininess": 20, "plasticity": 0, "refractive_index": 1}
SUBSTITUTE = {**MATERIAL, "ka": 0.2, "kd": 0.6, "ks": 0.7}
ALGORITHMS = {"ambient": (1, 0, ""), "diffuse": (0, 1, ""), "phong_specular": (0, 0, "phong"), "blinn_specular": (0, 0, "blinn"), "no_specular": (1, 1, ""), "phong": (1, 1, "phong"), "blinn": (1, 1, "blinn")}
WAVES = ("linear_aperture_light", "rectangular_aperture_light", "elliptical_aperture_light", "aperture_mask_light")
DARK = Decimal("1e-10")
BLACK = [Decimal(0)] * 3


# Texts


def words(value):
    return " ".join(repr(x) if isinstance(x, float) else str(x) for x in (value if isinstance(value, list) else [value]))


def block(word, properties, indent=""):
    lines = [indent + word]
    for name, value in properties.items():
        if name == "geometry":
            lines += block(value["kind"], {n: v for n, v in value.items() if n != "kind"}, indent + "  ")
        elif name in ("point", "curvature") and isinstance(value, list):
            lines += [f"{indent}  {name} {words(one)}" for one in value]
        else:
            lines.append(f"{indent}  {name} {words(value)}")
    return lines + [indent + "end"]


def text(scene):
    lines = []
    for name in ("camera", "raytracer"):
        if name in scene:
            lines += block(name, scene[name])
    for material, shape in scene["shapes"]:
        lines += ["primitive", f"  material_name {material}"] + block(shape["kind"], {n: v for n, v in shape.items() if n != "kind"}, "  ") + ["end"]
    for name, properties in scene["materials"]:
        lines += block("material", {"name": name, **properties})
    for kind, properties in scene.get("lights", []):
        lines += block(kind, properties)
    return "\n".join(lines) + "\n"


# Colours


class Tracer:
    """What the ray through the middle of the picture sees, by the equations of chapters 6 and 7."""

    def __init__(self, scene):
        camera = {"position": [0, 0, 0], "look_at": [0, 0, 1], "near_clipping_plane": 1, "far_clipping_plane": 100, **scene.get("camera", {})}
        raytracer = {"recursive_level": 1, "reflexion_algorithm": "blinn", **scene.get("raytracer", {})}
        self.front = dunit(sub(decimals(camera["look_at"]), decimals(camera["position"])))
        self.origin = add(decimals(camera["position"]), times(decimal(camera["near_clipping_plane"]), self.front))
        self.far, self.levels, self.algorithm = decimal(camera["far_clipping_plane"]), raytracer["recursive_level"], raytracer["reflexion_algorithm"]
        named = {}
        for name, properties in scene["materials"]:
            named.setdefault(name, {**MATERIAL, **properties})
        self.shapes = [(shape, named.get(name, SUBSTITUTE)) for name, shape in scene["shapes"]]
        self.lights = scene.get("lights", [])

    def colour(self, material):
        return decimals(material["color"][:3])

    def closed(self, shape):
        return self.closed(shape["geometry"]) if shape["kind"] == "geometry" else shape["kind"] in solids.CLOSED

    def closest(self, o, d):
        best = None
        for i, (shape, _) in enumerate(self.shapes):
            found = solids.first(shape, o, d)
            if found and found[0] < self.far and (best is None or found[0] < best[0]):
                best = (*found, i)
        return best

    def medium(self, v, without=None):
        indices = [decimal(m["refractive_index"]) if m["kt"] else Decimal(1) for i, (shape, m) in enumerate(self.shapes) if i != without and solids.contains(shape, v)]
        return sum(indices) / len(indices) if indices else Decimal(1)

    def ray(self, o, d, level, medium):
        found = self.closest(o, d)
        if found is None:
            return BLACK
        t, tag, i = found
        shape, m = self.shapes[i]
        v = solids.at(o, d, t)
        n = solids.normal(shape, v, tag)
        cosine = dot(d, n)
        facing = n if cosine < 0 else times(-1, n)
        seen = self.direct(v, facing, d, m)
        if level < self.levels:
            if m["kr"]:
                mirrored = sub(d, times(2 * dot(d, facing), facing))
                seen = add(seen, times(decimal(m["kr"]), self.ray(v, mirrored, level + 1, medium)))
            if m["kt"] and self.closed(shape):
                entering = not cosine > 0
                inner = decimal(m["refractive_index"]) if entering else self.medium(v, i)
                weight = times(decimal(m["kt"]), self.colour(m) if entering else [Decimal(1)] * 3)
                bent = self.refracted(d, facing, medium, inner)
                if bent is not None:
                    seen = add(seen, [x * y for x, y in zip(weight, self.ray(v, bent, level + 1, inner))])
        return seen

    def refracted(self, d, n, n1, n2):
        if n1 == n2:
            return d
        c = -dot(d, n)
        if c * c + (n2 / n1) ** 2 < 1:
            return None
        r = n1 / n2
        return dunit(add(times(r, d), times(r * c - (1 - r * r * (1 - c * c)).sqrt(), n)))

    def shadows(self, v, towards, limit):
        """The tints of what is between a point and a light, or nothing where it is opaque."""
        tints = [Decimal(1)] * 3
        for shape, m in self.shapes:
            found = solids.first(shape, v, towards)
            if found and (limit is None or found[0] < limit):
                if not m["kt"]:
                    return None
                tints = [x * y * decimal(m["kt"]) for x, y in zip(tints, self.colour(m))]
        return tints

    def direct(self, v, n, view, m):
        total = BLACK
        asks_ambient, asks_lambert, highlight = ALGORITHMS[self.algorithm]
        colour = self.colour(m)
        for kind, given in self.lights:
            light = {"color": [1, 1, 1], "orientation": [0, 0, -1], "position": [0, 0, 0], "amplification": 1, "constant_attenuator": 1, "linear_attenuator": 0, "quadratic_attenuator": 0, **given}
            amount = decimals(light["color"][:3])
            if kind == "ambient_light":
                if asks_ambient:
                    total = add(total, [x * y * decimal(m["ka"]) for x, y in zip(amount, colour)])
                continue
            factor, limit = Decimal(1), None
            if kind == "directional_light":
                d = dunit(light["orientation"])
            else:
                place = decimals(light["position"])
                if kind == "linear_aperture_light":
                    place = times(Decimal("0.5"), add(decimals(light["point"][0]), decimals(light["point"][1])))
                away = sub(v, place)
                limit = dot(away, away).sqrt()
                if limit == 0:
                    continue
                d = times(1 / limit, away)
                factor = decimal(light["amplification"]) / (decimal(light["constant_attenuator"]) + decimal(light["linear_attenuator"]) * limit + decimal(light["quadratic_attenuator"]) * limit * limit)
            if -dot(n, d) <= 0:
                continue
            tints = self.shadows(v, times(-1, d), limit)
            if tints is None:
                continue
            wave = kind in WAVES
            if wave:
                amount = wavelength(light.get("wave_length", 550))
            arriving = [x * y for x, y in zip(amount, tints)]
            if all(x < DARK for x in arriving):
                continue
            if wave:
                total = add(total, times(factor * intensity(kind, light, v), amount))
                continue
            terms = BLACK
            if asks_lambert:
                terms = add(terms, [-dot(n, d) * x * decimal(m["kd"]) * y for x, y in zip(arriving, colour)])
            if highlight:
                p = decimal(m["plasticity"])
                surface = [decimal(m["ks"]) * (p + (1 - p) * x) for x in colour]
                terms = add(terms, [self.highlight(highlight, n, d, view, m["shininess"]) * x * y for x, y in zip(arriving, surface)])
            total = add(total, times(factor, terms))
        return total

    def highlight(self, kind, n, d, view, shininess):
        if kind == "phong":
            f = -dot(sub(d, times(2 * dot(d, n), n)), view)
        else:
            h = sub(times(-1, view), d)
            if not any(h):
                return Decimal(0)
            f = dot(n, dunit(h))
        return Decimal(0) if f < 0 else dpow(f, shininess)

    def pixel(self):
        if self.algorithm == "no_light":
            found = self.closest(self.origin, self.front)
            if found is None:
                return BLACK, Decimal(1)
            m = self.shapes[found[2]][1]
            return times(decimal(m["kd"]), self.colour(m)), decimal(m["color"][3]) if len(m["color"]) > 3 else Decimal(1)
        return self.ray(self.origin, self.front, 1, self.medium(self.origin)), Decimal(1)


# Waves


def wavelength(given):
    l = decimal(given)
    g = lambda c, a, b: dexp(-(((l - Decimal(c)) * Decimal(a if l < Decimal(c) else b)) ** 2) / 2)
    x = Decimal("0.362") * g("442", "0.0624", "0.0374") + Decimal("1.056") * g("599.8", "0.0264", "0.0323") - Decimal("0.065") * g("501.1", "0.0490", "0.0382")
    y = Decimal("0.821") * g("568.8", "0.0213", "0.0247") + Decimal("0.286") * g("530.9", "0.0613", "0.0322")
    z = Decimal("1.217") * g("437", "0.0845", "0.0278") + Decimal("0.681") * g("459", "0.0385", "0.0725")
    rows = (("3.2406255", "-1.537208", "-0.4986286"), ("-0.9689307", "1.8757561", "0.0415175"), ("0.0557101", "-0.2040211", "1.0569959"))
    linear = [min(max(sum(Decimal(k) * v for k, v in zip(row, (x, y, z))), Decimal(0)), Decimal(1)) for row in rows]
    return [Decimal("12.92") * c if c <= Decimal("0.0031308") else Decimal("1.055") * c ** (1 / Decimal("2.4")) - Decimal("0.055") for c in linear]


def sources(kind, light):
    count = light.get("nb_oscillator", 2)
    if kind == "linear_aperture_light":
        a, b = (decimals(p) for p in light["point"])
        if count == 1:
            return [times(Decimal("0.5"), add(a, b))]
        return [add(a, times(Decimal(i) / (count - 1), sub(b, a))) for i in range(count)]
    place = decimals(light["position"])
    if count < 2:
        return [place] * count
    w, h = decimal(light.get("width", 0.001)), decimal(light.get("height", 0.001))
    up_to = lambda long, short: int((long / (short / (count - 1))).to_integral_value("ROUND_CEILING")) + 1
    nx, ny = (count, up_to(h, w)) if w < h else (up_to(w, h), count)
    front = dunit(light.get("front", [0, 0, 1]))
    up = dunit(suite.cross(suite.cross(front, decimals(light.get("up", [0, 1, 0]))), front))
    right = suite.cross(front, up)
    made = []
    for i in range(nx):
        for j in range(ny):
            x, y = w * i / (nx - 1) - w / 2, h * j / (ny - 1) - h / 2
            if kind != "elliptical_aperture_light" or x * x / (w * w / 4) + y * y / (h * h / 4) <= 1 + DARK:
                made.append(add(place, add(times(x, right), times(y, up))))
    return made


def intensity(kind, light, v):
    places = sources(kind, light)
    if not places:
        return Decimal(0)
    k = 2 * PI / (decimal(light.get("wave_length", 550)) * Decimal("1e-9"))
    phases = [k * dot(sub(v, p), sub(v, p)).sqrt() for p in places]
    c, s, n = sum(map(dcos, phases)), sum(map(dsin, phases)), len(places)
    return s * s / (n * n) if light.get("period_iteration", 10) < 3 else (c * c + s * s) / (2 * n * n)


# Bytes


def single(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


class Step(Exception):
    """A channel is next to a number at which its byte changes."""


def dimmed(scene, k):
    """The scene with a little less light, or with less of the diffuse colour, where no light is asked for."""
    less = lambda x: float(f"{x * (1 - 0.013 * k):.4g}")
    if scene.get("raytracer", {}).get("reflexion_algorithm") == "no_light":
        return {**scene, "materials": [(name, {**m, "kd": less(m.get("kd", 0.8)), "color": [*map(less, m["color"][:3]), *map(less, m["color"][3:])]}) for name, m in scene["materials"]]}
    lights = [(kind, {**one, "amplification": less(one.get("amplification", 1))} if kind in WAVES else {**one, "color": [less(x) for x in one.get("color", [1, 1, 1])[:3]] + one.get("color", [])[3:]}) for kind, one in scene["lights"]]
    return {**scene, "lights": lights}


def byte(c, comment):
    c = min(max(c, Decimal(0)), Decimal(1))
    exact = c * 255 + Decimal("0.5")
    if c not in (0, 1) and abs(exact - exact.to_integral_value()) < Decimal("0.02"):
        raise Step(f"{comment}: a channel of {float(c)} is next to a step")
    return int(single(single(float(c)) * 255.0) + 0.5)


CASES = []


def bytes_of(scene, comment):
    rgb, alpha = Tracer(scene).pixel()
    if scene.get("raytracer", {}).get("color_normalization") == "division_factor":
        rgb = [x / max(*rgb, Decimal(1)) for x in rgb]
    return [byte(x, comment) for x in (*rgb, alpha)]


def one(rules, comment, flags, given, expected=None):
    for k in range(9):
        scene = dimmed(given, k) if k else given
        try:
            made = bytes_of(scene, comment)
            break
        except Step:
            if k == 8:
                raise
    if expected is not None and made[:3] != expected:
        raise AssertionError(f"{comment}: {made}")
    CASES.append(case(rules, comment, flags, {"text": text(scene), "column": 250, "row": 250}, made, source=DECIMAL))


# Scenes


PLANE = {"kind": "plane", "position": [0, 0, 3]}
BARE = {"ka": 0, "kd": 0, "ks": 0}
SUN = ("directional_light", {"orientation": [3, 0, 4]})
NOON = ("directional_light", {"orientation": [0, 0, 1]})
AMBIENT = ("ambient_light", {})
LAMP = {"position": [-3, 0, -1]}


def scene(shapes, materials, lights, **more):
    return {"shapes": shapes, "materials": list(materials.items()), "lights": lights, **{name: value for name, value in more.items() if value}}


def surface(material, lights, algorithm=None, shapes=(), **others):
    return scene([("m", PLANE), *shapes], {"m": material, **others}, lights, raytracer={"reflexion_algorithm": algorithm} if algorithm else None)


def materials_and_terms():
    coloured = {"color": [0.9, 0.6, 0.3], "ka": 0.5, "kd": 0.4, "ks": 0.3, "plasticity": 0.25, "shininess": 3}
    lights = [("ambient_light", {"color": [0.5, 0.7, 0.9]}), ("directional_light", {"orientation": [3, 0, 4], "color": [0.8, 0.6, 0.7]}), ("point_light", {"position": [0, 2, 0.5], "color": [0.3, 0.4, 0.2]})]
    for name in ALGORITHMS:
        one("light.algorithm light.sum light.material.ambient light.material.diffuse light.material.specular", f"The terms of {name}, all lights", "wrong-terms", surface(coloured, lights, name))
        one("light.algorithm", f"The terms of {name}, an ambient light only", "wrong-terms", surface(coloured, lights[:1], name))
    one("light.algorithm light.sum", "Nothing is said: blinn", "wrong-default", surface(coloured, lights))
    one("light.algorithm.no-light light.material.diffuse", "no_light: the diffuse colour, without lights", "wrong-terms", surface(coloured, lights, "no_light"))
    one("light.algorithm.no-light", "no_light: without any light", "lights-asked", surface({"color": [1, 0.5, 0.2], "kd": 0.6}, [], "no_light"))
    one("light.algorithm.no-light", "no_light: alpha is the colour's", "alpha", surface({"color": [1, 0.5, 0.2, 0.3], "kd": 0.6}, [], "no_light"))
    one("light.algorithm.no-light", "no_light: kd does not count for alpha, nor ambient light for the colour", "alpha", surface({"color": [1, 0.5, 0.2, 0.7], "kd": 0.3, "ka": 1}, [AMBIENT], "no_light"))
    for algorithm in (None, "ambient", "phong", "diffuse"):
        one("light.opaque", f"Opaque, whatever alphas the colours have ({algorithm or 'default'})", "alpha", surface({"color": [1, 0.5, 0.25, 0.5], "ka": 0.6, "ks": 0}, [("ambient_light", {"color": [1, 1, 1, 0.25]}), NOON], algorithm))
    one("light.algorithm", "No lights: black", "wrong-default", surface(coloured, []), [0, 0, 0])
    for name, value in (("ka", 0.3), ("kd", 0.3), ("ks", 0.3), ("color", [0.3, 0.6, 0.9]), ("shininess", 2), ("plasticity", 0.5)):
        one("light.material.ambient light.material.diffuse light.material.specular", f"Defaults of a material but for {name}", "wrong-default", surface({name: value} if name != "plasticity" else {"plasticity": 0.5, "color": [0.2, 0.4, 0.6]}, [("ambient_light", {"color": [0.3, 0.3, 0.3]}), ("directional_light", {"orientation": [3, 0, 4], "color": [0.5, 0.5, 0.5]})]))
    for p in (0, 0.25, 1):
        one("light.material.specular", f"A plasticity of {p}", "plasticity-inverted", surface({"color": [0.8, 0.4, 0.1], "ks": 0.6, "plasticity": p, "shininess": 4}, [("directional_light", {"orientation": [3, 0, 4], "color": [1, 0.9, 0.5]})], "blinn_specular"))
    for algorithm in ("phong_specular", "blinn_specular"):
        for n in (0, 1, 7, 40):
            one("light.material.specular light.power", f"{algorithm}, a shininess of {n}", "exponent", surface({"ks": 0.7, "shininess": n}, [("directional_light", {"orientation": [1, 0.5, 4]})], algorithm))
    grey = scene([("nowhere", PLANE)], {}, [("ambient_light", {"color": [0.3, 0.6, 0.9]}), ("directional_light", {"orientation": [3, 0, 4], "color": [0.4, 0.4, 0.2]})])
    one("light.material.substitute", "A material that is not there: ambient, diffuse, specular", "wrong-default", grey)
    for algorithm in ("ambient", "diffuse", "phong_specular", "blinn_specular"):
        one("light.material.substitute", f"A material that is not there: {algorithm}", "wrong-default", {**grey, "raytracer": {"reflexion_algorithm": algorithm}})
    for first, second in (([0.2, 0.4, 0.6], [0.9, 0.1, 0.5]), ([0.9, 0.1, 0.5], [0.2, 0.4, 0.6])):
        twice = surface({"color": first, "ka": 1}, [AMBIENT])
        twice["materials"] = [("other", {}), ("m", {"color": first, "ka": 1}), ("m", {"color": second, "ka": 1})]
        one("light.material.first", "Of two materials of one name the first counts", "last-wins", twice)
    twice = surface({"color": [0.2, 0.4, 0.6], "ka": 1}, [AMBIENT])
    twice["materials"] = [("m", {"ka": 1, "color": [0.2, 0.4, 0.6]}), ("m", {"ka": 0.5, "kt": 1}), ("m", {})]
    one("light.material.first", "Of three materials of one name the first counts, whole", "last-wins merged", twice)
    for n in (1, -1):
        for d in ([0, 0, 1], [3, 0, 4]):
            one("geometry.hit.shading-normal light.shadow.turned-away", f"A plane whose normal has z = {n} is lit on the side that is seen", "normal-turned",
                scene([("m", {**PLANE, "normal": [0.0, 0.2, 1.0 * n]})], {"m": {"ks": 0.3, "shininess": 5, "kd": 0.6}}, [("directional_light", {"orientation": d})]))
    one("geometry.hit.shading-normal", "From inside of a sphere: lit from inside", "normal-turned", scene([("m", {"kind": "sphere", "position": [0, 0, 1], "ray": 4})], {"m": {"kd": 0.6, "ks": 0}}, [("point_light", {"position": [0, 1, 2]})]))
    for a, b, flag in (("r", "b", "first"), ("b", "r", "first")):
        tie = scene([(a, PLANE), (b, PLANE), (a, {"kind": "plane", "position": [0, 0, 4]})], {"r": {"color": [0.8, 0, 0], "ka": 1}, "b": {"color": [0, 0, 0.6], "ka": 1}}, [AMBIENT], raytracer={"reflexion_algorithm": "ambient"})
        one("geometry.hit.tie geometry.hit.closest", "Two planes at one parameter: the first in the file", "tie", tie)
    tie = scene([("b", {"kind": "disk", "position": [0, 0, 3], "ray": 2}), ("r", {"kind": "cube", "position": [0, 0, 4], "size": 2}), ("r", PLANE)], {"r": {"color": [0.8, 0, 0], "ka": 1}, "b": {"color": [0, 0, 0.6], "ka": 1}}, [AMBIENT], raytracer={"reflexion_algorithm": "ambient"})
    one("geometry.hit.tie", "A disk, a cube and a plane at one parameter: the disk is first in the file", "tie kind-order", tie)
    tie["shapes"] = list(reversed(tie["shapes"]))
    one("geometry.hit.tie", "The plane is first in the file", "tie kind-order", tie)
    several = [("b", {"kind": "sphere", "position": [0, 0, 9]}), ("r", {"kind": "sphere", "position": [0.2, 0, 5]}), ("b", {"kind": "sphere", "position": [0, 0, 7]}), ("b", {"kind": "plane", "position": [0, 0, 20]})]
    one("geometry.hit.closest geometry.hit.index", "Four shapes, the second is the nearest", "first-in-file", scene(several, {"r": {"color": [0.8, 0, 0], "ka": 1}, "b": {"color": [0, 0, 0.6], "ka": 1}}, [AMBIENT], raytracer={"reflexion_algorithm": "ambient"}))
    many = [("b", {"kind": "sphere", "position": [x / 2, y / 2, 8 + (x * y) / 4], "ray": 0.4}) for x in range(-3, 4) for y in range(-3, 4)] + [("r", {"kind": "sphere", "position": [0, 0, 7.25], "ray": 0.4})]
    for space in ("linear", "voxel", "multi_voxel"):
        one("geometry.hit.index geometry.hit.closest", f"Fifty spheres, the last is the nearest; space {space}", "tree", scene(many, {"r": {"color": [0.8, 0, 0], "ka": 1}, "b": {"color": [0, 0, 0.6], "ka": 1}}, [AMBIENT], raytracer={"reflexion_algorithm": "ambient", "space": space}))
    bright = surface({"color": [0.9, 0.5, 0.1], "ka": 1, "kd": 1, "ks": 0}, [("ambient_light", {"color": [2, 2, 2]})])
    one("light.colour.above-one", "Above 1: cut at the end", "clamped", bright)
    one("light.colour.above-one", "Above 1: divided at the end", "clamped", {**bright, "raytracer": {"color_normalization": "division_factor"}})
    dim = scene([("m", PLANE), ("w", {"kind": "plane", "position": [0, 0, -1]})], {"m": {**BARE, "kr": 0.1}, "w": {"color": [1, 0.5, 0.25], "ka": 1}}, [("ambient_light", {"color": [5, 5, 5]})], raytracer={"recursive_level": 2})
    one("light.colour.above-one optics.colour", "What a mirror shows is above 1 before it is weighted", "clamped", dim)


def lights():
    plain = {"kd": 0.7, "ks": 0}
    for comment, light in (("3, 4, 5", {"orientation": [3, 0, 4]}), ("A long orientation is made unit", {"orientation": [0, 300, 400]}), ("A short orientation is made unit", {"orientation": [0.004, 0, 0.003]}), ("An orientation along the surface's normal", {"orientation": [0, 0, 2]}), ("A coloured one", {"orientation": [1, 2, 2], "color": [0.9, 0.5, 0.1]})):
        one("light.source.directional", f"A directional light: {comment}", "not-unit cosine", surface(plain, [("directional_light", light)]))
    one("light.source.directional", "The default orientation is along -z: from behind this surface", "wrong-default", surface(plain, [("directional_light", {})]), [0, 0, 0])
    one("light.source.directional", "The default orientation lights what looks up", "wrong-default", scene([("m", {"kind": "plane", "position": [0, 0, -3]})], {"m": plain}, [("directional_light", {})], camera={"look_at": [0, 0, -1]}))
    base = {"position": [-2, 0, 0], "amplification": 2}
    for comment, light in (("No attenuation", {}), ("Constant", {"constant_attenuator": 4}), ("Linear", {"constant_attenuator": 0, "linear_attenuator": 1}), ("Quadratic", {"constant_attenuator": 0, "quadratic_attenuator": 0.25}),
                           ("All three", {"constant_attenuator": 0.5, "linear_attenuator": 0.25, "quadratic_attenuator": 0.125}), ("An amplification of 0", {"amplification": 0}), ("An amplification of 1/2", {"amplification": 0.5}), ("A default amplification", {"amplification": 1, "linear_attenuator": 0.25})):
        one("light.source.point", f"A point light: {comment}", "attenuation", surface({"kd": 0.35, "ks": 0}, [("point_light", {**base, **light})]))
        one("light.source.point", f"A point light and a highlight: {comment}", "attenuation", surface({"ks": 0.35, "shininess": 3}, [("point_light", {**base, **light})], "phong_specular"))
    one("light.source.point", "A coloured one, slanted", "swapped-coordinate", surface(plain, [("point_light", {"position": [1, -2, 0.5], "color": [0.9, 0.5, 0.2]})]))
    one("light.source.point", "The default position is the origin", "wrong-default", surface({"kd": 0.6, "ks": 0}, [("point_light", {})]))
    one("light.source.point", "It does not fall off by itself", "falls-off", scene([("m", {"kind": "plane", "position": [0, 0, 50]})], {"m": plain}, [("point_light", {})]))
    one("light.source.point", "Behind the surface: nothing", "behind", surface(plain, [("point_light", {"position": [0, 0, 5]})]), [0, 0, 0])
    for place in (0, 2):
        at = [0, 0, 3]
        one("light.source.at-zero", "At the point itself: nothing, and the others still count", "nan division-by-zero", surface({"kd": 0.4, "ks": 0.2, "ka": 0.3}, [("point_light", {"position": at, "linear_attenuator": place}), AMBIENT]))
    one("light.source.at-zero", "At the point itself, a highlight of exponent 0: nothing", "nan division-by-zero", surface({"ks": 1, "shininess": 0}, [("point_light", {"position": [0, 0, 3]})], "blinn_specular"), [0, 0, 0])
    near = {"kind": "plane", "position": [0, 0, 0]}
    look = {"position": [0, 0, -3], "look_at": [0, 0, 0]}
    for name, value in (("quadratic_attenuator", 1e-99), ("quadratic_attenuator", 1e-60)):
        gone = scene([("m", near)], {"m": {"ka": 0.4}}, [("point_light", {"position": [0, 0, -1e-150], "constant_attenuator": 0, name: value}), AMBIENT], camera=look)
        lit = {**gone, "lights": [AMBIENT]}
        rgb = [byte(x, "") for x in Tracer(lit).pixel()[0]]
        CASES.append(case("light.source.zero-denominator", f"The denominator underflows ({name} {value}): nothing, and the others still count", "nan division-by-zero", {"text": text(gone), "column": 250, "row": 250}, [*rgb, 255], source=DECIMAL))
    one("light.source.zero-denominator", "A denominator that is small but not 0 counts", "epsilon", surface({"kd": 0.4, "ks": 0}, [("point_light", {"constant_attenuator": 1e-30, "amplification": 1e-30})]))
    one("light.source.ambient light.sum", "Two ambient lights add", "last-wins", surface({"ka": 0.5}, [("ambient_light", {"color": [0.5, 0.2, 0.1]}), ("ambient_light", {"color": [0.3, 0.4, 0.9]})]))
    one("light.source.ambient", "Nothing shadows ambient light", "shadowed", surface({"ka": 0.5}, [AMBIENT], shapes=[("m", {"kind": "sphere", "position": [0, 0, 0], "ray": 0.5}), ("m", {"kind": "cube", "position": [2, 0, 3], "size": 3.5})]))
    one("light.source.ambient", "An ambient light on a surface that is seen from behind", "normal-turned", scene([("m", {**PLANE, "normal": [0, 0, 5]})], {"m": {"ka": 0.3}}, [AMBIENT]))
    one("light.sum", "Three lights add", "last-wins", surface({"ka": 0.3, "kd": 0.3, "ks": 0}, [("directional_light", {"orientation": [3, 0, 4], "color": [0.5, 0, 0]}), ("directional_light", {"orientation": [0, 0, 1], "color": [0.5, 0.5, 0]}), ("point_light", {"color": [0, 0.25, 1]})]))


def shadows():
    floor = {"kd": 0.7, "ks": 0.2, "shininess": 2}
    between = lambda k: [-3 * k, 0, 3 - 4 * k]
    ball = lambda k, r=0.5: {"kind": "sphere", "position": between(k), "ray": r}
    screen = lambda k, r=0.5: {"kind": "disk", "position": between(k), "normal": [3, 0, 4], "ray": r}
    lamp = ("point_light", LAMP)
    glass = {"color": [0.9, 0.6, 0.3], "kt": 0.8}
    for algorithm in (None, "phong"):
        one("light.shadow.turned-away", f"Light from behind: nothing, highlights too ({algorithm or 'blinn'})", "behind", surface({"ks": 1, "shininess": 0}, [("directional_light", {"orientation": [0.5, 0, -1]})], algorithm), [0, 0, 0])
        one("light.shadow.turned-away", f"Light along the surface: nothing ({algorithm or 'blinn'})", "grazing strict-comparison", surface({"ks": 1, "shininess": 0}, [("directional_light", {"orientation": [0, 1, 0]})], algorithm), [0, 0, 0])
        one("light.shadow.turned-away", f"Light nearly along the surface counts ({algorithm or 'blinn'})", "epsilon", surface({"ks": 0.6, "shininess": 0, "kd": 0}, [("directional_light", {"orientation": [0, 1, 1e-6]})], algorithm))
    for k, what in ((0.1, "near the point"), (0.5, "half way"), (0.9, "near the light")):
        one("light.shadow.opaque light.shadow.ray", f"An opaque disk {what}: black", "shadow-missing", surface(floor, [lamp], shapes=[("m", screen(k, 0.2))]), [0, 0, 0])
        one("light.shadow.transparent", f"A transparent disk {what}: its tint", "tint", surface(floor, [lamp], shapes=[("glass", screen(k, 0.2))], glass=glass))
    for k in (1.05, 1.5, 3):
        one("light.shadow.beyond", f"An opaque disk beyond the light, at {k} of the way: lit", "shadow-beyond", surface(floor, [lamp], shapes=[("m", screen(k, 0.2))]))
        one("light.shadow.ray", f"The same disk before a directional light: black", "shadow-bounded", surface(floor, [SUN], shapes=[("m", screen(k, 0.2))]), [0, 0, 0])
    one("light.shadow.beyond", "A disk exactly at the light: lit", "strict-comparison", surface(floor, [lamp], shapes=[("m", {"kind": "disk", "position": [-3, 0, -1], "normal": [1, 0, 0]})]))
    one("light.shadow.ray", "Behind the surface: lit", "shadow-behind", surface(floor, [lamp, SUN], shapes=[("m", ball(-0.5))]))
    one("light.shadow.ray", "Beside the way: lit", "shadow-everywhere", surface(floor, [lamp, SUN], shapes=[("m", {"kind": "sphere", "position": [-1.5, 2, 1], "ray": 0.5})]))
    one("light.shadow.ray", "Beyond the far clipping plane of the camera: black all the same", "shadow-clipped", {**surface(floor, [SUN], shapes=[("m", ball(5, 1))]), "camera": {"far_clipping_plane": 3}}, [0, 0, 0])
    one("light.shadow.ray", "Before the near clipping plane of the camera: black all the same", "shadow-clipped", surface(floor, [("directional_light", {"orientation": [1, 0, 8]})], shapes=[("m", {"kind": "sphere", "position": [-0.375, 0, 0], "ray": 0.25})]), [0, 0, 0])
    one("light.shadow.ray geometry.hit.smallest-parameter", "A disk 1e-9 above the point: no shadow", "epsilon", surface(floor, [NOON], shapes=[("m", {"kind": "disk", "position": [0, 0, 3.000000001], "ray": 5})]))
    one("light.shadow.opaque", "Only the light that is shadowed is missing", "all-lights", surface({**floor, "ka": 0.3}, [lamp, ("point_light", {"position": [2, 0, 0], "color": [0.3, 0.5, 0.2]}), ("ambient_light", {"color": [0.5, 0.5, 0.5]})], shapes=[("m", ball(0.5))]))
    one("light.shadow.transparent", "A transparent sphere is crossed twice and tints once", "tint-twice", surface(floor, [lamp], shapes=[("glass", ball(0.5))], glass=glass))
    one("light.shadow.transparent", "A transparent torus is crossed four times and tints once", "tint-twice", surface(floor, [SUN], shapes=[("glass", {"kind": "torus", "position": between(0.8), "major_radius": 1, "minor_radius": 0.25, "normal": [4, 0, -3]})], glass=glass))
    one("light.shadow.transparent", "Light is not bent in a shadow ray", "bent", surface(floor, [lamp], shapes=[("glass", {"kind": "cube", "position": between(0.5), "size": 1})], glass={**glass, "refractive_index": 2.4}))
    one("light.shadow.transparent", "Highlights are tinted, too", "tint", surface({"ks": 0.8, "shininess": 1}, [lamp], "blinn_specular", shapes=[("glass", ball(0.5))], glass=glass))
    one("light.shadow.transparent", "A small kt is transparent", "epsilon", surface({"kd": 1, "ks": 0}, [("directional_light", {"orientation": [3, 0, 4], "color": [500, 400, 300]})], shapes=[("glass", ball(0.5))], glass={"kt": 0.001}))
    one("light.shadow.product", "Two different glasses", "tint", surface(floor, [lamp], shapes=[("glass", screen(0.3)), ("other", screen(0.6))], glass=glass, other={"color": [0.5, 1, 0.7], "kt": 0.9}))
    one("light.shadow.product", "Three times the same glass", "tint", surface(floor, [lamp], shapes=[("glass", screen(0.2)), ("glass", screen(0.4)), ("glass", ball(0.7))], glass=glass))
    one("light.shadow.product", "Two glasses before a directional light", "tint", surface(floor, [SUN], shapes=[("glass", screen(0.3)), ("glass", screen(4))], glass=glass))
    for order in ([0.3, 0.6], [0.6, 0.3]):
        one("light.shadow.opaque-among", "One opaque among transparent ones: black", "first-only", surface(floor, [lamp], shapes=[("glass", screen(order[0])), ("m", screen(order[1])), ("glass", screen(0.8))], glass=glass), [0, 0, 0])
        one("light.shadow.opaque-among", "The opaque one is first in the file: black", "last-only", surface(floor, [SUN], shapes=[("m", screen(order[1])), ("glass", screen(order[0]))], glass=glass), [0, 0, 0])
    one("light.shadow.opaque-among light.shadow.beyond", "The opaque one is beyond the light: the glass's tint", "shadow-beyond", surface(floor, [lamp], shapes=[("glass", screen(0.4)), ("m", screen(1.2))], glass=glass))
    for value, a in ((0.9e-10, 1e10), (1.2e-10, 5e9), (1e-12, 5e11), (1e-8, 5e7)):
        one("light.shadow.dark", f"A light of {value}, amplified by {a:g}", "epsilon", surface({"kd": 1, "ks": 0}, [("point_light", {"color": [value, value, value], "amplification": a})]))
    one("light.shadow.dark", "Only one channel is not dark: all count", "epsilon any-channel", surface({"kd": 1, "ks": 0}, [("point_light", {"color": [9e-11, 5e-11, 2e-10], "amplification": 4e9})]))
    one("light.shadow.dark", "Dark only behind glass", "epsilon", surface({"kd": 1, "ks": 0}, [("point_light", {**LAMP, "color": [2e-10, 2e-10, 2e-10], "amplification": 4e9})], shapes=[("glass", ball(0.5))], glass={"kt": 0.25}), [0, 0, 0])
    one("light.shadow.itself", "A cube shadows its own far side", "self-shadow", scene([("m", {"kind": "cube", "position": [0, 0, 1], "size": 4})], {"m": {"kd": 0.5, "ks": 0}}, [("point_light", {"position": [0.5, 0, -9]})]), [0, 0, 0])
    one("light.shadow.itself geometry.hit.smallest-parameter", "A sphere does not shadow its near side", "self-hit", scene([("m", {"kind": "sphere", "position": [0, 0, 5], "ray": 2})], {"m": {"kd": 0.5, "ks": 0}}, [SUN]))
    one("light.shadow.itself", "From inside of a sphere the light outside is shadowed by it", "self-shadow", scene([("m", {"kind": "sphere", "position": [0, 0, 1], "ray": 2})], {"m": {"kd": 0.5, "ks": 0}}, [SUN]), [0, 0, 0])
    one("light.shadow.itself light.shadow.transparent", "From inside of a glass sphere the light outside is tinted by it", "self-shadow", scene([("m", {"kind": "sphere", "position": [0, 0, 1], "ray": 2})], {"m": {"kd": 0.6, "ks": 0, "kt": 0.7, "color": [0.9, 0.7, 0.5]}}, [SUN]))
    for kind, shape in (("cube", {"kind": "cube", "position": between(0.5), "size": 0.5}), ("cylinder", {"kind": "cylinder", "point": [between(0.4), between(0.6)], "ray": 0.3}), ("cone", {"kind": "cone", "point": [between(0.4), [-1.9, 0.1, 0.6]], "ray": 0.5}),
                        ("tube", {"kind": "tube", "point": [[-1.5, -1, 1], [-1.5, 1, 1]], "ray": 0.3}), ("triangle", {"kind": "triangle", "point": [[-2, -1, 1], [-2, 1, 1], [0, 0, 1.125]]}), ("annulus", {"kind": "annulus", "position": between(0.5), "normal": [3, 0, 4], "ray": 2, "inner_ray": 0.5}),
                        ("torus", {"kind": "torus", "position": [-1.5, 0, 1], "normal": [3, 0, 4], "major_radius": 1, "minor_radius": 0.5}), ("spherical_cap", {"kind": "spherical_cap", "position": between(0.5), "normal": [3, 0, 4], "ray": 0.5, "curvature": 1}),
                        ("lens", {"kind": "lens", "point": [between(0.4), between(0.6)], "ray": 0.3, "curvature": [1, 1]}), ("geometry", {"kind": "geometry", "scale": [0.5, 0.5, 0.5], "translation": between(0.5), "geometry": {"kind": "sphere"}})):
        one("light.shadow.opaque light.shadow.ray", f"The shadow of a {kind}, or its hole", "shadow-kind", surface(floor, [lamp], shapes=[("m", shape)]))


def waves():
    def light(kind="rectangular_aperture_light", **how):
        return (kind, {"nb_oscillator": 1, "amplification": 1.2, **how})

    wall = {"color": [0.2, 0.2, 0.2], "ka": 0.5}
    one("light.wave.gives", "The material is not asked", "material-asked", surface({"color": [0, 0, 0]}, [light()]))
    one("light.wave.gives", "Another material gives the same", "material-asked", surface({"color": [1, 0.5, 0.2], "kd": 0.3}, [light()]))
    for algorithm in ("ambient", "diffuse", "phong", "blinn_specular"):
        one("light.wave.gives", f"The algorithm {algorithm} is not asked", "algorithm-asked", surface(wall, [light()], algorithm))
    one("light.wave.gives light.sum", "It adds to the other lights", "last-wins", surface({"ka": 0.3, "color": [0.9, 0.2, 0.6]}, [AMBIENT, light(amplification=0.7)]))
    one("light.wave.gives", "The angle is not asked", "cosine", surface(wall, [light(position=[-6, 0, -5])]))
    one("light.wave.gives light.source.point", "Constant and quadratic attenuation", "attenuation", surface(wall, [light(amplification=6, constant_attenuator=0.5, quadratic_attenuator=0.5)]))
    one("light.wave.gives light.source.point", "Linear attenuation", "attenuation", surface(wall, [light(amplification=3, constant_attenuator=0, linear_attenuator=1)]))
    one("light.wave.gives light.algorithm.no-light", "no_light: not shown", "wrong-terms", surface({"color": [0.5, 0.2, 0.9], "kd": 0.6}, [light()], "no_light"))
    two = {"nb_oscillator": 2, "point": [[-3, -1e-7, -1], [-3, 1e-7, -1]]}
    one("light.wave.place", "A row of sources: the shadow is that of its middle", "wrong-place", surface(wall, [light("linear_aperture_light", **two)], shapes=[("m", {"kind": "sphere", "position": [-1.5, 0, 1], "ray": 0.3})]), [0, 0, 0])
    wide = {"nb_oscillator": 1, "point": [[-3, -2, -1], [-3, 2, -1]]}
    one("light.wave.place", "A row of sources: what shadows an end only does not count", "wrong-place", surface(wall, [light("linear_aperture_light", **wide)], shapes=[("m", {"kind": "sphere", "position": [-1.5, 1, 1], "ray": 0.3}), ("m", {"kind": "sphere", "position": [-1.5, -1, 1], "ray": 0.3})]))
    one("light.wave.place", "A row of sources: the distance is that of its middle", "wrong-place", surface(wall, [light("linear_aperture_light", **wide, amplification=4, linear_attenuator=1, constant_attenuator=0)]))
    one("light.wave.place light.wave.row", "A row of one source: in the middle", "wrong-place", surface(wall, [light("linear_aperture_light", point=[[0, 0, -1], [0, 0, 1]], amplification=3, constant_attenuator=0, linear_attenuator=1)]))
    one("light.wave.shadow", "An opaque shape takes all", "shadow-missing", surface(wall, [light(position=[-3, 0, -1])], shapes=[("m", {"kind": "sphere", "position": [-1.5, 0, 1], "ray": 0.3})]), [0, 0, 0])
    one("light.wave.shadow", "From behind: nothing", "behind", surface(wall, [light(position=[0, 0, 6])]), [0, 0, 0])
    one("light.wave.shadow", "A transparent shape lets it pass unchanged", "tint", surface(wall, [light(position=[-3, 0, -1])], shapes=[("glass", {"kind": "sphere", "position": [-1.5, 0, 1], "ray": 0.3})], glass={"color": [0.2, 0.4, 0.6], "kt": 0.5}))
    one("light.wave.shadow light.shadow.dark", "Red glass takes the green light of 550 nm", "dark", surface(wall, [light(position=[-3, 0, -1])], shapes=[("glass", {"kind": "sphere", "position": [-1.5, 0, 1], "ray": 0.3})], glass={"color": [1, 0, 0], "kt": 1}), [0, 0, 0])
    one("light.wave.shadow", "Beyond the light: lit", "shadow-beyond", surface(wall, [light(position=[-3, 0, -1])], shapes=[("m", {"kind": "sphere", "position": [-4.5, 0, -3], "ray": 0.3})]))
    for shift in (0.5e-7, 1e-7, 2e-7, 2.75e-7, 4.125e-7, 5.5e-7):
        one("light.wave.intensity light.wave.row", f"Two sources, {shift} apart in the line of sight", "phase", surface(wall, [light("linear_aperture_light", nb_oscillator=2, point=[[0, 0, 0], [0, 0, shift]])]))
    for n in (3, 4, 7):
        one("light.wave.intensity light.wave.few-instants", f"A period of {n} instants: the same as of any number from 3 on", "instants", surface(wall, [light("linear_aperture_light", nb_oscillator=2, point=[[0, 0, 0], [0, 0, 1.2e-7]], period_iteration=n)]))
    for n in (1, 2):
        for shift in (0.4e-7, 1.1e-7, 2e-7):
            one("light.wave.few-instants", f"A period of {n} instants, the source at {shift}", "instants", surface(wall, [light(position=[0, 0, shift], wave_length=600, period_iteration=n)]))
        one("light.wave.few-instants", f"A period of {n} instants, two sources", "instants", surface(wall, [light("linear_aperture_light", nb_oscillator=2, point=[[0, 0, 0.5e-7], [0, 0, 1.5e-7]], wave_length=600, period_iteration=n)]))
    for kind in WAVES:
        more = {"point": [[0, 0, 0], [0, 0.0001, 0]]} if kind == "linear_aperture_light" else {}
        one("light.wave.none", f"{kind} without sources: nothing, and the others still count", "nan division-by-zero", surface({"ka": 0.4}, [light(kind, nb_oscillator=0, **more), AMBIENT]))
    for n in (2, 3, 5):
        one("light.wave.row light.wave.intensity", f"A row of {n} across the line of sight", "sources", surface(wall, [light("linear_aperture_light", nb_oscillator=n, point=[[0, -0.0009, 0], [0, 0.0017, 0]], amplification=1.9)]))
    for w, h, n in ((0.002, 0.002, 2), (0.0025, 0.001, 2), (0.0011, 0.0023, 2), (0.0023, 0.0019, 3), (0.0014, 0.0027, 3), (0.0026, 0.0012, 4), (0.003, 0.001, 1), (0.0028, 0.0014, 2)):
        for kind in ("rectangular_aperture_light", "aperture_mask_light", "elliptical_aperture_light"):
            if kind == "elliptical_aperture_light" and n == 2:
                continue
            rule = {"rectangular_aperture_light": "", "aperture_mask_light": " light.wave.mask", "elliptical_aperture_light": " light.wave.ellipse"}[kind]
            one("light.wave.grid light.wave.intensity" + rule, f"{kind}, {w} by {h}, {n} sources on its shorter side", "sources grid-swapped", surface(wall, [light(kind, width=w, height=h, nb_oscillator=n, amplification=1.9)]))
    one("light.wave.ellipse light.wave.none", "An ellipse of two by two: the corners are outside, nothing is left", "nan", surface({"ka": 0.4}, [light("elliptical_aperture_light", nb_oscillator=2), AMBIENT]))
    for front, up in (([0, 0, 3], [0, 2, 0]), ([0, 0, 1], [3, 0, 1]), ([0, 0, 1], [1, 1, 0]), ([1, 0, 2], [0, 1, 0]), ([0, 1, 3], [1, 2, 0])):
        one("light.wave.frame light.wave.grid", f"front {front}, up {up}", "frame", surface(wall, [light(width=0.0025, height=0.001, nb_oscillator=2, front=front, up=up, amplification=1.9)]))
    for l in (380, 400, 430, 442, 460, 480, 501, 520, 531, 550, 569, 580, 600, 620, 650, 700, 780):
        one("light.wave.colour" + (" light.wave.visible" if l in (380, 780, 550) else ""), f"The colour of {l} nm", "wavelength", surface(wall, [light(wave_length=l, amplification=1.6)]))


def mirrors():
    wall = {"color": [0.9, 0.6, 0.3], "ka": 1, "kd": 0, "ks": 0}
    back = {"kind": "plane", "position": [0, 0, -1]}
    for level in (1, 2, 3, 5):
        one("optics.depth optics.colour", f"Two facing mirrors, a depth of {level}", "depth", scene([("m", PLANE), ("n", back)], {"m": {**BARE, "ka": 0.2, "kr": 0.5}, "n": {**BARE, "ka": 0.1, "kr": 0.8, "color": [0.5, 1, 0.8]}}, [AMBIENT], raytracer={"recursive_level": level}))
    for kr in (0.1, 0.4, 1):
        one("optics.mirror optics.colour", f"kr {kr}", "weight", scene([("m", PLANE), ("w", back)], {"m": {"color": [0.1, 0.8, 0.2], "ka": 0.3, "kd": 0, "ks": 0, "kr": kr}, "w": wall}, [("ambient_light", {"color": [0.5, 0.5, 0.5]})], raytracer={"recursive_level": 2}))
    one("optics.depth", "The default depth is 1: no reflection", "wrong-default", scene([("m", PLANE), ("w", back)], {"m": {**BARE, "ka": 0.3, "kr": 1}, "w": wall}, [AMBIENT]))
    one("optics.background", "A mirror that sees nothing", "background", surface({**BARE, "ka": 0.3, "kr": 1}, [AMBIENT]) | {"raytracer": {"recursive_level": 4}})
    one("optics.background", "Nothing at all", "background", scene([], {}, [AMBIENT]), [0, 0, 0])
    one("optics.background", "Nothing with no_light", "background alpha", scene([], {}, [], raytracer={"reflexion_algorithm": "no_light"}), [0, 0, 0])
    one("optics.mirror", "No mirror where kr is 0", "weight", scene([("m", PLANE), ("w", back)], {"m": {**BARE, "ka": 0.3, "kr": 0}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    # What a slanted mirror shows: walls of different colours all around.
    around = [("x", {"kind": "plane", "position": [6, 0, 0], "normal": [1, 0, 0]}), ("X", {"kind": "plane", "position": [-6, 0, 0], "normal": [1, 0, 0]}), ("y", {"kind": "plane", "position": [0, 6, 0], "normal": [0, 1, 0]}), ("Y", {"kind": "plane", "position": [0, -6, 0], "normal": [0, 1, 0]})]
    colours = {"x": [0.8, 0.1, 0.1], "X": [0.1, 0.8, 0.1], "y": [0.1, 0.1, 0.8], "Y": [0.8, 0.8, 0.1]}
    for n in ([1, 0, -1], [-1, 0, -1], [0, 1, -1], [0, -1, -1], [1, 0, 1], [1, 0.25, -1.5]):
        for kind in ("plane", "disk"):
            one("optics.mirror optics.reflect", f"A {kind} with the normal {n} as a mirror", "direction normal-turned", scene([("m", {"kind": kind, "position": [0, 0, 3], "normal": n}), *around], {"m": {**BARE, "kr": 0.9}, **{k: {"color": c, "ka": 1, "kd": 0, "ks": 0} for k, c in colours.items()}}, [AMBIENT], raytracer={"recursive_level": 2}))
    one("optics.mirror", "A sphere as a mirror, off its middle", "direction", scene([("m", {"kind": "sphere", "position": [0.9, 0, 5], "ray": 1.5}), *around], {"m": {**BARE, "kr": 0.9}, **{k: {"color": c, "ka": 1, "kd": 0, "ks": 0} for k, c in colours.items()}}, [AMBIENT], raytracer={"recursive_level": 2}))
    for far, what in ((4.5, "within"), (3.9, "beyond"), (4, "at")):
        one("optics.secondary.origin", f"The far clipping plane is counted from the mirror: the wall is {what} it", "far strict-comparison", scene([("m", PLANE), ("w", back)], {"m": {**BARE, "kr": 1}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 2}, camera={"far_clipping_plane": far}))
    one("optics.secondary.origin", "The near clipping plane does not concern a reflected ray", "near", scene([("m", PLANE), ("w", {"kind": "plane", "position": [0, 0, 2.75]})], {"m": {**BARE, "kr": 1}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 2}, camera={"near_clipping_plane": 2.9}))
    one("optics.mirror optics.colour", "A mirror shows what is lit, and shadows", "shadow", scene([("m", PLANE), ("w", back), ("w", {"kind": "sphere", "position": [0, 1.5, 0.5], "ray": 0.25})], {"m": {**BARE, "kd": 0.2, "kr": 0.6}, "w": {"color": [0.9, 0.6, 0.3], "kd": 0.8, "ks": 0}}, [("point_light", {"position": [0, 3, 2]}), ("point_light", {"position": [2, 0, 2], "color": [0.5, 0.5, 0.9]})], raytracer={"recursive_level": 3}))
    one("optics.mirror light.material.specular", "A highlight in a mirror is seen from the mirror", "view", scene([("m", {"kind": "plane", "position": [0, 0, 3], "normal": [1, 0, -2]}), ("w", {"kind": "plane", "position": [8, 0, 0], "normal": [1, 0, 0.5]})], {"m": {**BARE, "kr": 0.8}, "w": {"kd": 0.2, "ks": 0.8, "shininess": 3}}, [("point_light", {"position": [0, 1, -2]})], raytracer={"recursive_level": 2}))
    one("optics.sum", "Three levels, each with its own light", "order", scene([("m", PLANE), ("n", back)], {"m": {"color": [0.7, 0.2, 0.5], "ka": 0.3, "kd": 0.2, "ks": 0, "kr": 0.6}, "n": {"color": [0.1, 0.5, 0.9], "ka": 0.25, "kd": 0.5, "ks": 0, "kr": 0.7}}, [("ambient_light", {"color": [0.6, 0.6, 0.6]}), ("point_light", {"position": [1, 0, 1], "color": [0.5, 0.4, 0.3]})], raytracer={"recursive_level": 6}))


def bodies():
    wall = {"color": [0.9, 0.6, 0.3], "ka": 1, "kd": 0, "ks": 0}
    behind = {"kind": "plane", "position": [0, 0, 12]}
    glass = {**BARE, "color": [0.9, 0.8, 0.5], "kt": 0.8}
    shapes = {"sphere": {"kind": "sphere", "position": [0, 0, 5]}, "cube": {"kind": "cube", "position": [0, 0, 5], "size": 2}, "cylinder": {"kind": "cylinder", "point": [[0, 0, 4], [0, 0, 6]]}, "cone": {"kind": "cone", "point": [[0.2, 0, 6], [0.2, 0, 4]]},
              "lens": {"kind": "lens", "point": [[0, 0, 4], [0, 0, 5]], "ray": 1, "curvature": [2, 2]}, "torus": {"kind": "torus", "position": [1, 0, 5], "major_radius": 1, "minor_radius": 0.5}, "geometry": {"kind": "geometry", "scale": [2, 1, 0.5], "translation": [0, 0, 5], "geometry": {"kind": "sphere"}},
              "plane": {"kind": "plane", "position": [0, 0, 5]}, "disk": {"kind": "disk", "position": [0, 0, 5]}, "annulus": {"kind": "annulus", "position": [0.7, 0, 5]}, "tube": {"kind": "tube", "point": [[0, -1, 5], [0, 1, 5]]}, "triangle": {"kind": "triangle", "point": [[-1, -1, 5], [1, -1, 5], [0, 1, 5]]},
              "spherical_cap": {"kind": "spherical_cap", "position": [0, 0, 5]}}
    for kind, shape in shapes.items():
        one("optics.body.closed", f"A {kind} of glass, index 1", "open-shape closed-shape", scene([("g", shape), ("w", behind)], {"g": {**glass, "ka": 0.2}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 4}))
    for level in (1, 2, 3, 4):
        one("optics.depth optics.body.entering optics.body.leaving", f"A cube of glass, a depth of {level}", "depth weight", scene([("g", shapes["cube"]), ("w", behind)], {"g": {**glass, "ka": 0.1}, "w": wall}, [AMBIENT], raytracer={"recursive_level": level}))
    one("optics.body.leaving", "The ray starts inside: it leaves, with kt and without the colour", "weight tint", scene([("g", {"kind": "sphere", "position": [0, 0, 1], "ray": 3}), ("w", behind)], {"g": glass, "w": wall}, [AMBIENT], raytracer={"recursive_level": 2}))
    one("optics.body.entering", "It enters and meets a wall inside", "weight tint", scene([("g", {"kind": "sphere", "position": [0, 0, 100], "ray": 97}), ("w", behind)], {"g": glass, "w": wall}, [AMBIENT], raytracer={"recursive_level": 2}))
    # A wall of stripes shows where the ray goes: disks one beside the other.
    room = [("w", {"kind": "plane", "position": [0, 0, 12]}), ("a", {"kind": "plane", "position": [0, -3, 0], "normal": [0, 1, 0]}), ("b", {"kind": "plane", "position": [3, 0, 0], "normal": [1, 0, 0]}), ("c", {"kind": "plane", "position": [-3, 0, 0], "normal": [1, 0, 0]})]
    paints = {"w": wall, "a": {"color": [0.2, 0.9, 0.4], "ka": 1, "kd": 0, "ks": 0}, "b": {"color": [0.3, 0.3, 0.9], "ka": 1, "kd": 0, "ks": 0}, "c": {"color": [0.9, 0.1, 0.6], "ka": 1, "kd": 0, "ks": 0}}
    lamps = [("ambient_light", {"color": [0.1, 0.1, 0.1]}), ("point_light", {"position": [0, 2, 7]})]
    lit = {name: {**m, "ka": 0.5, "kd": 0.8} for name, m in paints.items()}
    for index in (1, 1.2, 1.5, 2, 2.5, 0.8):
        for shape, what in (({"kind": "sphere", "position": [0.6, 0.2, 5], "ray": 1}, "sphere"), ({"kind": "geometry", "rotation": [25, 40, 0], "translation": [0, 0, 5], "scale": [2, 2, 1], "geometry": {"kind": "cube"}}, "turned cube")):
            one("optics.refract optics.body.entering optics.body.leaving", f"A {what} of index {index} in a lit room: where the ray goes shows in the light", "direction index-swapped", scene([("g", shape), *room], {"g": {**glass, "refractive_index": index}, **lit}, lamps, raytracer={"recursive_level": 6}))
    inside = lambda size, turn: {"kind": "geometry", "scale": [4, 4, 4], "rotation": [0, turn, 0], "translation": [1, 0, 1], "geometry": {"kind": "cube"}}
    for index in (1.1, 1.3, 1.4, 1.42, 1.6, 2):
        one("optics.body.total optics.refract.total", f"Out of a turned cube of index {index}: total reflection from 1.4143 on", "total-reflection", scene([("g", inside(4, 45)), ("w", {"kind": "plane", "position": [0, 0, 50]}), ("w", {"kind": "plane", "position": [40, 0, 0], "normal": [1, 0, 0]})], {"g": {**glass, "refractive_index": index}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    both = {**BARE, "color": [0.8, 0.9, 0.4], "kr": 0.3, "kt": 0.6}
    for index in (1, 1.5):
        one("optics.body.order optics.sum optics.colour", f"Mirror and glass at once, index {index}", "weight order", scene([("g", {"kind": "sphere", "position": [0.3, 0, 5], "ray": 1}), *room, ("w", {"kind": "plane", "position": [0, 0, -4]})], {"g": {**both, "refractive_index": index}, **lit}, lamps, raytracer={"recursive_level": 4}))
    one("optics.body.order", "Mirror and glass: the reflected ray keeps the medium of the ray", "medium", scene([("g", {"kind": "sphere", "position": [0, 0, 1], "ray": 2}), *room], {"g": {**both, "refractive_index": 1.5}, **lit}, lamps, raytracer={"recursive_level": 4}))
    one("optics.body.total", "Total reflection with kr: the reflected ray is that of the mirror, weighted with kr", "weight", scene([("g", inside(4, 45)), *room], {"g": {**both, "refractive_index": 1.8}, **paints}, [AMBIENT], raytracer={"recursive_level": 2}))
    # Media: the ray leaves the turned cube into a larger sphere.
    outer = {"kind": "sphere", "position": [0, 0, 1], "ray": 200}
    far_wall = ("w", {"kind": "plane", "position": [0, 0, 50]})
    for first, second in ((1.8, 1.2), (2.3, 1.2), (1.5, 1.5), (1.2, 1.8), (2, 1.05), (1.6, 1)):
        one("optics.medium.at optics.medium.start", f"In the cube of index {first} and in a sphere of {second}: the mean", "medium-mean", scene([("g", inside(4, 45)), ("o", outer), far_wall], {"g": {**glass, "refractive_index": first}, "o": {**glass, "refractive_index": second}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    for index in (1.7, 1.9):
        one("optics.medium.opaque light.material.index", f"An opaque sphere around the cube of index {index} counts with 1", "medium-opaque", scene([("g", inside(4, 45)), ("o", outer), far_wall], {"g": {**glass, "refractive_index": index}, "o": {"refractive_index": 3}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    one("optics.medium.opaque light.material.index", "Two opaque spheres and the cube: the mean of three", "medium-opaque medium-mean", scene([("g", inside(4, 45)), ("o", outer), ("o", {"kind": "sphere", "position": [0, 0, 1], "ray": 150}), far_wall], {"g": {**glass, "refractive_index": 2.1}, "o": {"refractive_index": 3}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    one("optics.medium.opaque light.material.index", "The same with an index of 2.4: the mean is beyond the critical angle", "medium-opaque medium-mean", scene([("g", inside(4, 45)), ("o", outer), ("o", {"kind": "sphere", "position": [0, 0, 1], "ray": 150}), far_wall], {"g": {**glass, "refractive_index": 2.4}, "o": {"refractive_index": 3}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    nested = [("o", {"kind": "sphere", "position": [0.2, 0, 6], "ray": 2}), ("g", {"kind": "sphere", "position": [0.5, 0.1, 6], "ray": 1}), *room]
    for a, b in ((1.5, 1.2), (1.2, 1.5), (1.3, 1.3), (2, 1)):
        one("optics.medium.at optics.medium.left-out optics.body.entering", f"A sphere of {b} in one of {a}: entering the inner one the index is its own, leaving it that of the outer one", "medium-mean medium-own", scene(nested, {"o": {**glass, "refractive_index": a}, "g": {**glass, "refractive_index": b}, **lit}, lamps, raytracer={"recursive_level": 7}))
    touching = [("o", {"kind": "cube", "position": [0, 0, 5], "size": 2}), ("g", {"kind": "cube", "position": [0, 0, 7], "size": 2}), *room]
    one("optics.medium.left-out optics.medium.at", "Two cubes that touch: neither contains the other's face", "medium-surface tie", scene(touching, {"o": {**glass, "refractive_index": 1.5}, "g": {**glass, "color": [0.5, 0.9, 0.7], "refractive_index": 1.3}, **lit}, lamps, raytracer={"recursive_level": 7}))
    one("optics.medium.start", "The eye is outside, the ray's origin inside of the body", "medium-eye", scene([("g", inside(4, 45)), far_wall], {"g": {**glass, "refractive_index": 1.5}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}, camera={"position": [0, 0, -4], "look_at": [0, 0, 0], "near_clipping_plane": 5}))
    one("optics.medium.start", "The eye is inside, the ray's origin outside", "medium-eye", scene([("o", {"kind": "sphere", "position": [0, 0, 0], "ray": 0.5}), ("g", {"kind": "sphere", "position": [0.5, 0, 5], "ray": 1}), *room], {"o": {**glass, "refractive_index": 2.2}, "g": {**glass, "refractive_index": 1.5}, **lit}, lamps, raytracer={"recursive_level": 5}))
    one("optics.medium.start", "Inside of a sphere from the start: the first refraction leaves it", "medium-eye", scene([("o", {"kind": "sphere", "position": [0.5, 0, 1], "ray": 1.5}), *room], {"o": {**glass, "refractive_index": 1.3}, **lit}, lamps, raytracer={"recursive_level": 3}))
    for kt in (0.2, 1):
        one("light.material.tint optics.body.entering", f"kt {kt}: the tint is kt times the colour, once for the body", "tint", scene([("g", shapes["sphere"]), ("w", behind)], {"g": {**glass, "kt": kt}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}))
    one("light.material.tint", "Two bodies, one behind the other", "tint", scene([("g", shapes["sphere"]), ("h", {"kind": "cube", "position": [0, 0, 8], "size": 2}), ("w", behind)], {"g": glass, "h": {**BARE, "color": [0.5, 0.9, 0.8], "kt": 0.9}, "w": wall}, [AMBIENT], raytracer={"recursive_level": 5}))
    one("optics.colour light.shadow.transparent", "Direct light on glass is not reduced by kt", "weight", scene([("g", shapes["sphere"]), ("w", behind)], {"g": {"color": [0.9, 0.8, 0.5], "ka": 0.2, "kd": 0.3, "ks": 0, "kt": 0.5}, "w": wall}, [("ambient_light", {"color": [0.5, 0.5, 0.5]}), NOON], raytracer={"recursive_level": 3}))
    one("optics.secondary.origin", "The far clipping plane is counted from where a refracted ray starts", "far", scene([("g", shapes["cube"]), ("w", behind)], {"g": glass, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}, camera={"far_clipping_plane": 6.5}))
    one("optics.secondary.origin", "The wall is beyond the far clipping plane of the refracted ray", "far", scene([("g", shapes["cube"]), ("w", behind)], {"g": glass, "w": wall}, [AMBIENT], raytracer={"recursive_level": 3}, camera={"far_clipping_plane": 5.5}))


def by_hand(rules, comment, flags, scene, made):
    CASES.append(case(rules, comment, flags, {"text": text(scene), "column": 250, "row": 250}, made, source=HAND))


def budget():
    """Mirrors at z = 3 and z = -1, and rays that go to and fro between them: ray k + 1 is the k-th reflection."""
    back = {"kind": "plane", "position": [0, 0, -1]}
    facing = [("m", PLANE), ("m", back)]
    for level in (20000, 40000, 60000):
        by_hand("optics.budget.stack optics.depth", f"A depth of {level}: so many times 0.00001, without an end of the stack", "stack-overflow", scene(facing, {"m": {**BARE, "ka": 0.00001, "kr": 1}}, [AMBIENT], raytracer={"recursive_level": level}), [level * 255 // 100000] * 3 + [255])
    for level in (80000, 1000000):
        by_hand("optics.budget", f"A depth of {level}: 65,536 rays are followed, each sees 0.00001", "budget", scene(facing, {"m": {**BARE, "ka": 0.00001, "kr": 1}}, [AMBIENT], raytracer={"recursive_level": level}), [167, 167, 167, 255])
    # With a slope of 1/4 the ray k ends at x = k - 1/2 if nothing is in its way; a wall at x = w is met by the ray w + 1.
    slanted = {"position": [0, 0, 1], "look_at": [1, 0, 5]}
    for wall, seen in ((65534, 153), (65535, 153), (65536, 0), (65537, 0)):
        by_hand("optics.budget optics.budget.stack", f"What the ray {wall + 1} sees: the ray 65,536 is the last", "budget off-by-one", scene([*facing, ("w", {"kind": "plane", "position": [wall, 0, 0], "normal": [1, 0, 0]})], {"m": {**BARE, "kr": 1}, "w": {"ka": 0.6}}, [AMBIENT], camera=slanted, raytracer={"recursive_level": 100000}), [seen] * 3 + [255])
    for level, seen in ((7, 0), (8, 153)):
        by_hand("optics.depth", f"A wall that the ray 8 sees, a depth of {level}", "depth off-by-one", scene([*facing, ("w", {"kind": "plane", "position": [7, 0, 0], "normal": [1, 0, 0]})], {"m": {**BARE, "kr": 1}, "w": {"ka": 0.6}}, [AMBIENT], camera=slanted, raytracer={"recursive_level": level}), [seen] * 3 + [255])


def edges():
    """Two triangles with a common edge, and a ray that is aimed at a point of it which no binary64 is exactly on: it meets one of them, or both."""
    chance = random.Random(750)
    for _ in range(8):
        a, b = ([round(chance.uniform(-9, 9), 1), round(chance.uniform(-9, 9), 1), round(chance.uniform(4, 9), 1)] for _ in range(2))
        k = chance.uniform(0.2, 0.8)
        aim = [x + k * (y - x) for x, y in zip(a, b)]
        side = [b[1] - a[1], a[0] - b[0], 0]
        size = max(abs(x) for x in side)
        left, right = ([round(x + s * 9 * y / size, 1) for x, y in zip(aim, side)] for s in (1, -1))
        white = {"w": {"kd": 1}}
        by_hand("geometry.triangle.watertight geometry.triangle.edges", "On the common edge of two triangles: no ray slips through", "leak", scene([("w", {"kind": "triangle", "point": [a, b, left]}), ("w", {"kind": "triangle", "point": [a, b, right]})], white, [], camera={"look_at": aim, "near_clipping_plane": 0.1}, raytracer={"reflexion_algorithm": "no_light"}), [255, 255, 255, 255])


def cases():
    """All of them, for the generator of scene.pixel."""
    CASES.clear()
    for part in (materials_and_terms, lights, shadows, waves, mirrors, bodies, budget, edges):
        part()
    return list(CASES)
