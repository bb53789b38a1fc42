"""The cases of scene.picture: small scenes with their pictures, drawn by a tracer of a few lines that shares nothing with the program but the specification.

It counts in binary64 without the orders of operations that rules fix. Therefore a scene is taken only where that cannot matter: each pixel is traced five times, with rays that
are moved by 1e-9, and all must give the same bytes, each of them at least 4e-5 of a step away from the next one (binary32 rounds by 3e-5).
"""

import math
import sys

sys.dont_write_bytecode = True

import camera_rays  # noqa: E402
import roots_maths  # noqa: E402
from suite import add, case, cross, dot, main, png, sub, times  # noqa: E402

SOURCE = "a ray tracer of its own in the generator, rays moved by 1e-9 giving the same bytes"
FIRST = 1e-8


def unit(a):
    return times(1 / math.sqrt(dot(a, a)), a)


def quadratic(a, b, c):
    """Roots, roughly: what is near to a tangent is refused by the moved rays."""
    if a == 0 or b * b < 4 * a * c:
        return []
    q = -(b + math.copysign(math.sqrt(b * b - 4 * a * c), b)) / 2
    return sorted([q / a, c / q if q else 0.0])


# Shapes: crossings(o, d) is a list of (parameter, outward unit normal), in order


class Shape:
    closed = True

    def __init__(self, **values):
        self.values = values

    def text(self, indent="  "):
        lines = [indent + self.word]
        for name, value in self.values.items():
            if name == "inner":
                lines += value.text(indent + "  ").split("\n")[:-1]
            else:
                for one in value if isinstance(value, list) and isinstance(value[0], list) else [value]:
                    lines.append(f"{indent}  {name} {' '.join(map(repr, one)) if isinstance(one, list) else repr(one)}")
        return "\n".join(lines + [indent + "end"]) + "\n"

    def __getattr__(self, name):
        return self.__dict__["values"][name]

    def inside(self, p, d=(0.31, 0.57, -0.76)):
        return self.closed and len([t for t, _ in self.crossings(p, d) if t > 0]) % 2 == 1


class Sphere(Shape):
    word = "sphere"

    def crossings(self, o, d):
        w = sub(o, self.position)
        return [(t, unit(sub(add(o, times(t, d)), self.position))) for t in quadratic(dot(d, d), 2 * dot(w, d), dot(w, w) - self.ray**2)]


class Plane(Shape):
    word, closed = "plane", False

    def crossings(self, o, d):
        n = unit(self.normal)
        a = dot(n, d)
        if abs(a) < 1e-12:
            return []
        t = -dot(n, sub(o, self.position)) / a
        return [(t, n)] if self.covers(sub(add(o, times(t, d)), self.position)) else []

    def covers(self, w):
        return True


class Disk(Plane):
    word = "disk"

    def covers(self, w):
        return dot(w, w) <= self.ray**2


class Annulus(Plane):
    word = "annulus"

    def covers(self, w):
        return self.inner_ray**2 <= dot(w, w) <= self.ray**2


class Triangle(Shape):
    word, closed = "triangle", False

    def crossings(self, o, d):
        p0, p1, p2 = self.point
        n = cross(sub(p1, p0), sub(p2, p0))
        a = dot(n, d)
        if a == 0:
            return []
        t = dot(n, sub(p0, o)) / a
        v = add(o, times(t, d))
        sides = [dot(n, cross(sub(q, p), sub(v, p))) for p, q in ((p0, p1), (p1, p2), (p2, p0))]
        return [(t, unit(n))] if all(s >= 0 for s in sides) else []


class Convex(Shape):
    """A body that is what half spaces and round bars share: between the last entry and the first exit."""

    def crossings(self, o, d):
        low, high = (-math.inf, None), (math.inf, None)
        for span in self.spans(o, d):
            if span is None:
                return []
            low, high = max(low, span[0], key=lambda x: x[0]), min(high, span[1], key=lambda x: x[0])
        return [low, high] if low[0] <= high[0] else []


def slab(o, d, n, low, high):
    """Where a line is between two planes low <= <n, p> <= high."""
    at, way = dot(n, o), dot(n, d)
    if abs(way) < 1e-12:
        return ((-math.inf, None), (math.inf, None)) if low <= at <= high else None
    pair = [((low - at) / way, times(-1, n)), ((high - at) / way, n)]
    return tuple(sorted(pair, key=lambda x: x[0]))


class Cube(Convex):
    word = "cube"

    def spans(self, o, d):
        for i in range(3):
            n = [0.0, 0.0, 0.0]
            n[i] = 1.0
            yield slab(o, d, n, self.position[i] - self.size / 2, self.position[i] + self.size / 2)


def across(a, s):
    return sub(a, times(dot(a, s), s))


class Cylinder(Convex):
    word = "cylinder"

    def bar(self, o, d):
        s = unit(sub(self.position[1], self.position[0]))
        w, e = across(sub(o, self.position[0]), s), across(d, s)
        return s, [(t, unit(add(w, times(t, e)))) for t in quadratic(dot(e, e), 2 * dot(w, e), dot(w, w) - self.ray**2)]

    def spans(self, o, d):
        s, pair = self.bar(o, d)
        yield tuple(pair) if pair else None
        yield slab(o, d, s, dot(s, self.position[0]), dot(s, self.position[1]))


class Tube(Cylinder):
    word, closed = "tube", False

    def crossings(self, o, d):
        s, pair = self.bar(o, d)
        low, high = dot(s, self.position[0]), dot(s, self.position[1])
        return [(t, n) for t, n in pair if low <= dot(s, add(o, times(t, d))) <= high]


class Cone(Shape):
    word = "cone"

    def crossings(self, o, d):
        base, apex = self.position
        s = unit(sub(apex, base))
        tall = math.sqrt(dot(sub(apex, base), sub(apex, base)))
        k = self.ray / tall
        w, e = across(sub(o, apex), s), across(d, s)
        h, g = dot(sub(o, apex), s), dot(d, s)
        found = []
        for t in quadratic(dot(e, e) - (k * g) ** 2, 2 * (dot(w, e) - k * k * h * g), dot(w, w) - (k * h) ** 2):
            if -tall <= h + t * g <= 0:
                found.append((t, unit(add(unit(add(w, times(t, e))), times(k, s)))))
        if abs(g) > 1e-12:
            t = (-tall - h) / g
            v = add(w, times(t, e))
            if dot(v, v) <= self.ray**2:
                found.append((t, times(-1, s)))
        return sorted(found, key=lambda x: x[0])


class Torus(Shape):
    word = "torus"

    def crossings(self, o, d):
        n, w = unit(self.normal), sub(o, self.position)
        m, r = self.major_radius, self.minor_radius
        a, b, c = dot(d, d), 2 * dot(w, d), dot(w, w) + m * m - r * r
        h, g = dot(w, n), dot(d, n)
        # (a t^2 + b t + c)^2 = 4 m^2 (|p|^2 - (h + g t)^2)
        k = 4 * m * m
        p = [a * a, 2 * a * b, b * b + 2 * a * c - k * (a - g * g), 2 * b * c - k * (b - 2 * h * g), c * c - k * (dot(w, w) - h * h)]
        found = []
        for t in map(float, roots_maths.real_roots(p)):
            q = add(w, times(t, d))
            ring = times(m, unit(across(q, n)))
            found.append((t, unit(sub(q, ring))))
        return found


class Geometry(Shape):
    word = "geometry"

    def rotated(self, a, back=False):
        turns = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
        for i, j, k in reversed(turns) if back else turns:
            angle = math.radians(self.rotation[i]) * (-1 if back else 1)
            c, s = math.cos(angle), math.sin(angle)
            made = list(a)
            made[j], made[k] = c * a[j] - s * a[k], s * a[j] + c * a[k]
            a = made
        return a

    def crossings(self, o, d):
        undo = lambda a: [x / s for x, s in zip(self.rotated(a, True), self.scale)]
        found = self.inner.crossings(undo(sub(o, self.translation)), undo(d))
        return [(t, unit(self.rotated([x / s for x, s in zip(n, self.scale)]))) for t, n in found]

    @property
    def closed(self):
        return self.inner.closed


# Light


DEFAULTS = {"color": [1, 1, 1], "ka": 0.2, "kd": 0.8, "ks": 0.5, "kr": 0, "kt": 0, "shininess": 20, "plasticity": 0, "refractive_index": 1}
TERMS = {"ambient": "a", "diffuse": "d", "phong_specular": "p", "blinn_specular": "b", "no_specular": "ad", "phong": "adp", "blinn": "adb"}


def words(value):
    return " ".join(map(repr, value)) if isinstance(value, list) else str(value) if isinstance(value, str) else repr(value)


class Scene:
    def __init__(self, camera, width, height, shapes, materials, lights, **raytracer):
        self.camera, self.width, self.height, self.raytracer = camera, width, height, raytracer
        self.shapes, self.lights = shapes, lights
        self.materials = {name: {**DEFAULTS, **values} for name, values in materials.items()}
        self.given = materials

    def text(self):
        names = {"near": "near_clipping_plane", "far": "far_clipping_plane"}
        lines = ["camera"] + [f"  {names.get(n, n)} {words(v)}" for n, v in self.camera.items()] + ["end", "", "viewport", f"  width {self.width}", f"  height {self.height}", "end", ""]
        lines += ["raytracer"] + [f"  {n} {words(v)}" for n, v in self.raytracer.items()] + ["end", ""]
        for name, shape in self.shapes:
            lines += ["primitive", f"  material_name {name}"] + shape.text().split("\n")[:-1] + ["end", ""]
        for name, values in self.given.items():
            lines += ["material", f"  name {name}"] + [f"  {n} {words(v)}" for n, v in values.items()] + ["end", ""]
        for kind, values in self.lights:
            lines += [kind] + [f"  {n} {words(v)}" for n, v in values.items()] + ["end", ""]
        return "\n".join(lines)

    def nearest(self, o, d):
        best = None
        for name, shape in self.shapes:
            for t, n in shape.crossings(o, d):
                if FIRST < t < self.camera.get("far", 100) and (best is None or t < best[0]):
                    best = (t, n, shape, self.materials[name])
        return best

    def shade(self, o, d, depth, medium):
        """What a ray sees: red, green, blue, alpha."""
        hit = self.nearest(o, d)
        if hit is None:
            return [0, 0, 0, 1]
        t, n, shape, m = hit
        p = add(o, times(t, d))
        algorithm = self.raytracer.get("reflexion_algorithm", "blinn")
        if algorithm == "no_light":
            return times(m["kd"], m["color"][:3]) + [m["color"][3] if len(m["color"]) == 4 else 1]
        shown = n if dot(d, n) < 0 else times(-1, n)
        colour = self.direct(p, shown, d, m, TERMS[algorithm])
        if depth < self.raytracer.get("recursive_level", 1):
            if m["kr"]:
                far = self.shade(p, sub(d, times(2 * dot(d, shown), shown)), depth + 1, medium)
                colour = [c + m["kr"] * f for c, f in zip(colour, far)]
            if m["kt"] and shape.closed:
                entering = dot(d, n) < 0
                beyond = m["refractive_index"] if entering else 1.0
                r, c = medium / beyond, -dot(d, shown)
                under = 1 - r * r * (1 - c * c)
                if under > 0:
                    way = d if r == 1 else add(times(r, d), times(r * c - math.sqrt(under), shown))
                    weight = times(m["kt"], m["color"][:3]) if entering else [m["kt"]] * 3
                    colour = [c + w * f for c, w, f in zip(colour, weight, self.shade(p, way, depth + 1, beyond))]
        return list(colour[:3]) + [1]

    def direct(self, p, n, v, m, terms):
        total = [0.0, 0.0, 0.0]
        surface = m["color"][:3]
        shiny = [m["ks"] * (m["plasticity"] + (1 - m["plasticity"]) * c) for c in surface]
        for kind, light in self.lights:
            colour = light.get("color", [1, 1, 1])[:3]
            if kind == "ambient_light":
                if "a" in terms:
                    total = [x + l * m["ka"] * s for x, l, s in zip(total, colour, surface)]
                continue
            if kind == "directional_light":
                d, distance, factor = unit(light["orientation"]), math.inf, 1.0
            else:
                w = sub(p, light["position"])
                distance = math.sqrt(dot(w, w))
                d = times(1 / distance, w)
                factor = light.get("amplification", 1) / (light.get("constant_attenuator", 1) + light.get("linear_attenuator", 0) * distance + light.get("quadratic_attenuator", 0) * distance**2)
            if -dot(n, d) <= 0:
                continue
            for name, shape in self.shapes:
                if any(FIRST < t < distance for t, _ in shape.crossings(p, times(-1, d))):
                    tint = self.materials[name]
                    colour = [c * tint["kt"] * k for c, k in zip(colour, tint["color"])]
            if max(colour) < 1e-10:
                continue
            if "d" in terms:
                total = [x + factor * -dot(n, d) * l * m["kd"] * s for x, l, s in zip(total, colour, surface)]
            if "b" in terms or "p" in terms:
                if "b" in terms:
                    cosine = dot(n, unit(times(-1, add(v, d))))
                else:
                    cosine = dot(sub(d, times(2 * dot(d, n), n)), times(-1, v))
                if cosine >= 0:
                    total = [x + factor * cosine ** m["shininess"] * l * s for x, l, s in zip(total, colour, shiny)]
        return total

    def pixel(self, column, row, moved):
        """A pixel's colour before it is made bytes, its rays moved a little."""
        sampling, coordinate = self.raytracer.get("sampling", 1), self.raytracer.get("pixel_coordinate", "top_left")
        total = [0.0, 0.0, 0.0]
        for sample in range(sampling):
            x, y = camera_rays.place(column, row, sample, self.width, coordinate, sampling, self.raytracer.get("seed", 0))
            values = {n: v for n, v in self.camera.items() if n != "far"}
            key = (float(x), float(y))
            if key not in self.rays:
                self.rays[key] = [list(map(float, a)) for a in camera_rays.ray(x, y, width=self.width, height=self.height, **values)]
            o, d = self.rays[key]
            o, d = add(o, moved), unit(add(d, times(-1, [moved[1], moved[2], moved[0]])))
            medium = [self.materials[name]["refractive_index"] for name, shape in self.shapes if self.materials[name]["kt"] and shape.inside(o)]
            seen = self.shade(o, d, 1, sum(medium) / len(medium) if medium else 1.0)
            if sampling == 1:
                return seen
            total = [a + b for a, b in zip(total, seen)]
        return [c / sampling for c in total[:3]] + [1]

    def levels(self, colour):
        if self.raytracer.get("color_normalization") == "division_factor":
            most = max(1, *colour[:3])
            colour = [c / most for c in colour[:3]] + [colour[3]]
        return [min(max(c, 0), 1) * 255 for c in colour]

    def draw(self):
        self.rays, pixels = {}, bytearray()
        for row in range(self.height):
            for column in range(self.width):
                seen = [self.levels(self.pixel(column, row, moved)) for moved in ([0, 0, 0], [1e-9, 0, 0], [-1e-9, 5e-10, 0], [0, -1e-9, 5e-10], [3e-10, 1e-9, -1e-9])]
                for channel in zip(*seen):
                    whole = {int(c + 0.5) for c in channel}
                    if len(whole) > 1 or any(0 < c < 255 and abs(c - math.floor(c) - 0.5) < 4e-5 for c in channel):
                        raise ValueError(f"pixel ({column}, {row}) is not safe: {channel}")
                pixels += bytes(int(c + 0.5) for c in seen[0])
        return bytes(pixels)


# Scenes


def scenes():
    """name: (rules, comment, flags, scene)"""
    eye = {"position": [0.13, 0.71, -4.9], "look_at": [0.02, 0.03, 0.05], "angle": 50}
    matt = {"color": [0.9, 0.5, 0.2]}
    floor = ("floor", Plane(position=[0.0, -1.0, 0.0], normal=[0.0, 1.0, 0.0]))
    ground = {"color": [0.5, 0.6, 0.7], "ks": 0}
    sun = ("directional_light", {"orientation": [1.0, -2.0, 1.5]})
    lamp = ("point_light", {"position": [-2.0, 3.0, -2.5], "amplification": 6.2, "constant_attenuator": 1, "linear_attenuator": 0.5, "quadratic_attenuator": 0.25})
    sky = ("ambient_light", {"color": [0.6, 0.7, 0.8]})
    ball = Sphere(position=[0.1, 0.0, 0.2], ray=1.0)
    three = [("a", Sphere(position=[-1.1, -0.2, 0.4], ray=0.8)), ("b", Sphere(position=[0.9, 0.3, 1.1], ray=0.9)), ("c", Sphere(position=[0.3, -0.6, -0.8], ray=0.4))]
    colours = {"a": {"color": [0.9, 0.1, 0.2]}, "b": {"color": [0.2, 0.8, 0.1], "plasticity": 1}, "c": {"color": [0.1, 0.3, 1], "shininess": 5}}
    shape = lambda *shapes: [("m", s) for s in shapes]
    every = [sky, sun, lamp]
    turned = [25.0, -40.0, 65.0]
    made = {
        "plain-triangle": ("camera.axes picture.rows camera.pixel-coordinate", "A triangle in no_light: which way is up, and right.", "mirrored transposed", Scene({"angle": 70}, 16, 16, [("m", Triangle(point=[[-1.0, -0.8, 2.6], [1.7, -0.2, 3.0], [0.2, 1.5, 2.2]]))], {"m": {"color": [1, 0.45, 0.25], "kd": 1}}, [], reflexion_algorithm="no_light", pixel_coordinate="center")),
        "wide": ("camera.size camera.every-pixel picture.rows", "A wide picture.", "aspect transposed", Scene(eye, 32, 8, three, colours, every, pixel_coordinate="center")),
        "tall": ("camera.size camera.every-pixel picture.rows", "A tall picture.", "aspect transposed", Scene(eye, 8, 33, three, colours, every, pixel_coordinate="center")),
        "one-column": ("camera.every-pixel camera.point picture.rows", "A picture of one column.", "size", Scene(eye, 1, 21, three, colours, every, pixel_coordinate="bottom_right")),
        "alpha": ("picture.alpha camera.sampling.one light.algorithm.no-light", "Alpha of no_light, and the opaque background.", "alpha", Scene(eye, 12, 12, three, {"a": {"color": [0.9, 0.1, 0.2, 0.25]}, "b": {"color": [0.3, 0.8, 0.1, 0]}, "c": {"color": [0.1, 0.3, 1, 3]}}, every, reflexion_algorithm="no_light", pixel_coordinate="center")),
        "sphere": ("geometry.sphere.normal light.blinn light.lambert", "A sphere under all three lights.", "normal", Scene(eye, 24, 24, [("m", ball)], {"m": matt}, every, pixel_coordinate="center")),
        "shadows": ("light.shadow.opaque light.shadow.ray light.shadow.itself light.source.point", "Three spheres on a floor, shadows of two lights.", "shadow", Scene(eye, 32, 32, three + [floor], {**colours, "floor": ground}, [lamp, sun], pixel_coordinate="center")),
        "tinted-shadow": ("light.shadow.transparent light.shadow.product", "Shadows of coloured glass, once a shape.", "shadow tint", Scene(eye, 24, 24, three + [floor], {"a": {"color": [0.9, 0.4, 0.2], "kt": 0.8}, "b": {"color": [0.2, 0.8, 0.5], "kt": 0.9}, "c": {"color": [0.4, 0.5, 1], "kt": 0.7}, "floor": {**ground, "kd": 1}}, [("directional_light", {"orientation": [0.5, -2.0, 0.6]})], pixel_coordinate="center")),
        "plane-shapes": ("geometry.disk.parameters geometry.annulus.parameters geometry.triangle.both-sides geometry.hit.closest", "A disk, a ring and a triangle through one another.", "rim", Scene(eye, 32, 32, [("a", Disk(position=[-0.8, 0.1, 0.5], normal=[0.4, 0.5, -1.0], ray=1.1)), ("b", Annulus(position=[0.7, 0.2, 0.4], normal=[-0.6, 0.3, 1.0], ray=1.2, inner_ray=0.5)), ("c", Triangle(point=[[-1.6, -1.1, -0.4], [0.1, 1.5, 1.9], [1.8, -0.9, 0.2]]))], colours, every, pixel_coordinate="center")),
        "cube": ("geometry.cube.slabs geometry.cube.normal transform.order transform.inverse picture.deterministic", "A cube, turned and stretched.", "order normal", Scene(eye, 32, 32, shape(Geometry(scale=[1.0, 1.6, 0.7], rotation=turned, translation=[0.1, 0.0, 0.3], inner=Cube(position=[0.05, -0.1, 0.0], size=1.3))), {"m": matt}, every, pixel_coordinate="center")),
        "cylinder": ("geometry.cylinder.interval geometry.cylinder.normal", "A cylinder with a slanting axis.", "rim normal", Scene(eye, 32, 32, shape(Cylinder(position=[[-0.7, -0.8, 0.4], [0.6, 0.9, -0.3]], ray=0.6)), {"m": matt}, every, pixel_coordinate="center")),
        "tube": ("geometry.tube.ends geometry.tube.normal geometry.hit.shading-normal", "A tube: its inside is lit.", "rim normal", Scene(eye, 32, 32, shape(Tube(position=[[-0.2, 0.3, -1.1], [0.6, -0.2, 1.6]], ray=0.9)), {"m": matt}, every, pixel_coordinate="center")),
        "cone": ("geometry.cone.interval geometry.cone.normal geometry.cone.beyond-apex", "A cone that lies.", "apex normal", Scene(eye, 32, 32, shape(Cone(position=[[1.1, -0.5, -0.6], [-1.2, 0.6, 0.7]], ray=0.9)), {"m": matt}, every, pixel_coordinate="center")),
        "torus": ("geometry.torus.equation roots.quartic.count picture.deterministic", "A torus, seen from the side.", "quartic", Scene(eye, 20, 20, shape(Torus(position=[0.1, 0.1, 0.2], normal=[0.3, 1.0, -0.8], major_radius=1.1, minor_radius=0.4)), {"m": matt}, [sky, sun], pixel_coordinate="center")),
        "nested": ("transform.inverse transform.normal shape.geometry.nested", "A sphere in two transformations, one of them mirrored.", "order inverse-transpose", Scene(eye, 24, 24, shape(Geometry(scale=[-1.0, 1.3, 0.8], rotation=[0.0, 0.0, 30.0], translation=[0.2, 0.1, 0.3], inner=Geometry(scale=[1.5, 0.6, 1.0], rotation=[10.0, 35.0, 0.0], translation=[0.1, -0.2, 0.1], inner=Sphere(position=[0.0, 0.1, 0.0], ray=0.9)))), {"m": matt}, every, pixel_coordinate="center")),
        "mirrors": ("optics.mirror optics.depth optics.colour", "Mirrors that see one another, four levels.", "recursion", Scene(eye, 24, 24, three + [floor], {"a": {"color": [0.9, 0.1, 0.2], "kr": 0.5}, "b": {"color": [0.2, 0.8, 0.1], "kr": 0.7}, "c": {"color": [0.1, 0.3, 1]}, "floor": {**ground, "kr": 0.25}}, [sky, lamp], recursive_level=4, pixel_coordinate="center")),
        "glass": ("optics.refract optics.body.entering optics.body.leaving", "A ball of glass before two others, three levels.", "refraction", Scene(eye, 24, 24, [("g", Sphere(position=[0.2, 0.1, -1.3], ray=0.9)), ("a", Sphere(position=[-1.1, -0.2, 1.9], ray=0.9)), ("b", Sphere(position=[1.3, 0.5, 2.6], ray=1.1)), floor], {"g": {"color": [0.8, 0.9, 1], "kd": 0.1, "kt": 0.9, "refractive_index": 1.5}, "a": colours["a"], "b": colours["b"], "floor": ground}, [sky, lamp], recursive_level=3, pixel_coordinate="center")),
        "diamond": ("optics.refract.total optics.body.total optics.depth transform.inverse", "A cube of a high index: total reflection inside.", "refraction", Scene(eye, 20, 20, [("g", Geometry(scale=[1.0, 1.0, 1.0], rotation=[20.0, 35.0, 10.0], translation=[0.1, 0.1, -0.6], inner=Cube(position=[0.0, 0.0, 0.0], size=1.5))), ("a", Sphere(position=[-1.1, -0.2, 2.9], ray=1.3)), floor], {"g": {"color": [1, 0.95, 0.9], "kd": 0.1, "ks": 0.2, "kt": 0.95, "kr": 0.3, "refractive_index": 2.4}, "a": colours["a"], "floor": ground}, [sky, sun], recursive_level=4, pixel_coordinate="center")),
        "bright": ("picture.clamp light.colour.above-one", "Lights that are too bright: clamped.", "clamp", Scene(eye, 16, 16, three, colours, [("ambient_light", {"color": [3.0, 2.0, 1.0]}), ("directional_light", {"orientation": [1.0, -2.0, 1.5], "color": [3.0, 2.5, 2.0]})], pixel_coordinate="center")),
        "divided": ("picture.division light.colour.above-one", "The same, divided.", "division", Scene(eye, 16, 16, three, colours, [("ambient_light", {"color": [3.0, 2.0, 1.0]}), ("directional_light", {"orientation": [1.0, -2.0, 1.5], "color": [3.0, 2.5, 2.0]})], pixel_coordinate="center", color_normalization="division_factor")),
        "sampled": ("camera.sampling.mean camera.random camera.generator camera.seed", "Four random samples a pixel, seed 3.", "generator", Scene(eye, 12, 10, three, {"a": {"color": [0.9, 0.1, 0.2]}, "b": {"color": [0.2, 0.8, 0.1]}, "c": {"color": [0.1, 0.3, 1]}}, [], reflexion_algorithm="no_light", pixel_coordinate="random", sampling=4, seed=3)),
        "random": ("camera.random camera.sampling.one camera.seed", "One random sample a pixel, seed 2147483647.", "generator", Scene(eye, 16, 11, three, colours, [sky, sun], pixel_coordinate="random", seed=2147483647)),
        "clipped": ("camera.near camera.far", "Spheres that the near and the far plane cut.", "near far", Scene({**eye, "position": [0.13, 0.71, -3.0], "near": 2.3, "far": 2.35}, 24, 24, three, colours, [sky, sun], pixel_coordinate="center")),
        "large": ("camera.every-pixel picture.deterministic light.algorithm", "A picture of 64 x 64 with Phong's highlights.", "size", Scene({**eye, "up": [0.3, 1.0, 0.0]}, 64, 64, three + [floor], {**colours, "floor": ground}, every, reflexion_algorithm="phong", pixel_coordinate="center")),
    }
    for algorithm in TERMS:
        made["algorithm-" + algorithm.replace("_", "-")] = ("light.algorithm", f"The algorithm {algorithm}.", "algorithm", Scene(eye, 10, 10, three, colours, every, reflexion_algorithm=algorithm, pixel_coordinate="center"))
    return made


DRAWN = {}


def drawn():
    if not DRAWN:
        for name, (rules, comment, flags, scene) in scenes().items():
            try:
                DRAWN[name] = (rules, comment, flags, scene, scene.draw())
            except ValueError as error:
                raise ValueError(f"{name}: {error}") from error
    return DRAWN


def pictures():
    made = {}
    for name, (_, _, _, scene, pixels) in drawn().items():
        made[name + ".txt"] = scene.text().encode("utf-8")
        made[name + ".png"] = png(scene.width, scene.height, pixels)
    return made


def operations():
    made = [case(rules, comment, flags, {"file": name + ".txt"}, {"file": name + ".png"}, source=SOURCE) for name, (rules, comment, flags, _, _) in drawn().items()]
    return {"scene.picture": made}


if __name__ == "__main__":
    main(sys.modules[__name__])
