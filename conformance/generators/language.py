"""The scene language as chapters 2 and 3 have it, as far as expected results of scene.check need it: marks for diagnostics, and the canonical text.

In a text, `«code»` stands directly before the place at which a diagnostic of that code is expected; the marks are taken out before the text is sent. The canonical text is
written from what a scene differs in from the defaults, by the tables of 3.5 to 3.7.
"""

import re
import sys
from fractions import Fraction

sys.dont_write_bytecode = True

from suite import HAND, case  # noqa: E402

WARNINGS = {"decimal-comma", "missing-material", "repeated-material", "sampling-without-random", "no-model-file", "behind-opening"}
NOTES = {"no-material-name", "replaced-object"}
MARK = re.compile("«([a-z-]+)»")


def severity(code):
    return "warning" if code in WARNINGS else "note" if code in NOTES else "error"


def marked(text):
    """A text without its marks, and the diagnostics that they stand for, in the order of their places."""
    lines, found = [], []
    for number, line in enumerate(text.split("\n"), 1):
        plain = ""
        at = 0
        for mark in MARK.finditer(line):
            plain += line[at : mark.start()]
            found.append({"code": mark.group(1), "severity": severity(mark.group(1)), "line": number, "column": len(plain) + 1})
            at = mark.end()
        lines.append(plain + line[at:])
    return "\n".join(lines), found


def check(rules, comment, flags, text, canonical=None):
    """A case of scene.check: the text with marks, and the canonical text if it is compared. It shows the rules of all codes that are marked."""
    plain, found = marked(text)
    rules = list(dict.fromkeys(rules.split() + ["code." + one["code"] for one in found]))
    places = [(one["line"], one["column"]) for one in found]
    expected = {"diagnostics": found}
    if canonical is not None:
        expected["canonical"] = canonical
    compare = "exact" if len(set(places)) == len(places) else {"diagnostics": "set"}
    return case(rules, comment, flags, {"text": plain}, expected, compare, HAND)


# Writing numbers: numbers.writing


def between(x):
    """The interval of the numbers that read back as the binary64 number x > 0, and whether its ends do: ties go to the even one."""
    import math

    mantissa, exponent = math.frexp(x)
    step = Fraction(2) ** max(exponent - 53, -1074)
    below = step / 2 if mantissa == 0.5 and exponent - 53 > -1074 else step
    return Fraction(x) - below / 2, Fraction(x) + step / 2, Fraction(x) / step % 2 == 0


def digits_of(x):
    """The fewest digits that read back as x > 0, of several such the nearest to it, and the exponent of the first."""
    low, high, closed = between(x)
    value, exponent = Fraction(x), 0
    while value >= Fraction(10) ** (exponent + 1):
        exponent += 1
    while value < Fraction(10) ** exponent:
        exponent -= 1
    for count in range(1, 19):
        unit = Fraction(10) ** (exponent - count + 1)
        first = value // unit
        fits = [n for n in (first, first + 1) if low < n * unit < high or closed and n * unit in (low, high)]
        if fits:
            best = min(fits, key=lambda n: abs(n * unit - value))
            text = str(best)
            return text.rstrip("0") or "0", exponent + len(text) - count
    raise ValueError(x)


def real(x):
    x = float(x)
    if x == 0:
        return "-0.0" if str(x) == "-0.0" else "0.0"
    sign, size = ("-", -x) if x < 0 else ("", x)
    digits, exponent = digits_of(size)
    if size < 0.001 or size >= 1e7:
        return f"{sign}{digits[0]}.{digits[1:] or '0'}e{exponent}"
    if exponent < 0:
        return f"{sign}0.{'0' * (-exponent - 1)}{digits}"
    digits = digits.ljust(exponent + 1, "0")
    return f"{sign}{digits[: exponent + 1]}.{digits[exponent + 1 :] or '0'}"


FORMS = {
    "real": real, "integer": str, "text": str, "degrees": lambda x: real(x) + " degrees", "pixels": lambda n: f"{n} pixels", "nm": lambda x: real(x) + " nm",
    "vector": lambda a: "[" + ", ".join(map(real, a)) + "]", "colour": lambda a: "[ " + ", ".join(map(real, a)) + " ]",
}

# Tables: word, form, default; a property with several places has a tuple of defaults.

ORIGIN, WHITE = [0, 0, 0], [1, 1, 1, 1]
POSITION, COLOUR, RAY, NORMAL = ("position", "vector", ORIGIN), ("color", "colour", WHITE), ("ray", "real", 1), ("normal", "vector", [0, 0, 1])
ENDS = ("position", "vector", (ORIGIN, [0, 0, 1]))
CORNERS = ("point", "vector", (ORIGIN, [0, 1, 0], [1, 1, 0]))
TRANSFORMATION = [("scale", "vector", [1, 1, 1]), ("rotation", "vector", ORIGIN), ("translation", "vector", ORIGIN)]
MATERIAL = [("name", "text", "none"), COLOUR, ("ka", "real", 0.2), ("kd", "real", 0.8), ("ks", "real", 0.5), ("kr", "real", 0), ("kt", "real", 0), ("shininess", "real", 20), ("plasticity", "real", 0), ("refractive_index", "real", 1)]
FALL = [("amplification", "real", 1), ("constant_attenuator", "real", 1), ("linear_attenuator", "real", 0), ("quadratic_attenuator", "real", 0)]
WAVE = [("wave_length", "nm", 550), ("period_iteration", "integer", 10), ("nb_oscillator", "integer", 2)]
APERTURE = [COLOUR, POSITION] + FALL + WAVE + [("width", "real", 0.001), ("height", "real", 0.001), ("front", "vector", [0, 0, 1]), ("up", "vector", [0, 1, 0])]

TABLE = {
    "camera": [POSITION, ("look_at", "vector", [0, 0, 1]), ("up", "vector", [0, 1, 0]), ("angle", "degrees", 60), ("near_clipping_plane", "real", 1), ("far_clipping_plane", "real", 100)],
    "viewport": [("width", "pixels", 500), ("height", "pixels", 500), ("image_file_name", "text", "image")],
    "raytracer": [("task", "integer", 1), ("sampling", "integer", 1), ("recursive_level", "integer", 1), ("reflexion_algorithm", "text", "blinn"), ("pixel_coordinate", "text", "top_left"), ("space", "text", "linear"),
                  ("color_normalization", "text", "clamp_channel"), ("seed", "integer", 0)],
    "model": [("file", "text", "none")] + TRANSFORMATION + [("uv_format", "text", "default")],
    "primitive": [("material_name", "text", "none")],
    "material": MATERIAL,
    "texture_material": MATERIAL + [("texture_ka", "text", "none"), ("texture_kd", "text", "none"), ("texture_ks", "text", "none")],
    "ambient_light": [COLOUR],
    "directional_light": [COLOUR, ("orientation", "vector", [0, 0, -1])],
    "point_light": [COLOUR, POSITION] + FALL,
    "linear_aperture_light": [COLOUR, ("position", "vector", (ORIGIN, [0, 0.0001, 0]))] + FALL + WAVE,
    "rectangular_aperture_light": APERTURE,
    "elliptical_aperture_light": APERTURE,
    "aperture_mask_light": APERTURE + [("mask", "text", "none")],
    "sphere": [POSITION, RAY],
    "plane": [POSITION, NORMAL],
    "disk": [POSITION, NORMAL, RAY],
    "annulus": [POSITION, NORMAL, RAY, ("inner_ray", "real", 0.5)],
    "triangle": [CORNERS],
    "btriangle": [CORNERS, ("normal", "vector", ([0, 0, -1],) * 3), ("uv", "vector", ([0, 0],) * 3)],
    "tube": [ENDS, RAY],
    "cylinder": [ENDS, RAY],
    "cone": [ENDS, RAY],
    "cube": [POSITION, ("size", "real", 1)],
    "spherical_cap": [POSITION, NORMAL, RAY, ("curvature", "real", 1)],
    "lens": [ENDS, RAY, ("curvature", "real", (1, 1))],
    "torus": [POSITION, NORMAL, ("major_radius", "real", 1), ("minor_radius", "real", 0.2)],
    "geometry": TRANSFORMATION,
}


def block(word, values, depth=0, inside=None):
    """The lines of an object: its word, its properties, the shape in it (word, values, shape in that), its end."""
    unknown = set(values) - {name for name, _, _ in TABLE[word]}
    if unknown:
        raise ValueError(f"{word} has no {unknown}")
    indent = lambda d: " " * (2 * min(10, d))
    lines = [indent(depth) + word]
    for name, form, default in TABLE[word]:
        given = values.get(name, default)
        for one in given if isinstance(default, tuple) else [given]:
            lines.append(indent(depth + 1) + (name + " ").ljust(max(0, 30 - 2 * (depth + 1))) + FORMS[form](one))
    if inside:
        lines += block(inside[0], inside[1], depth + 1, inside[2] if len(inside) > 2 else None)
    return lines + [indent(depth) + f"end #end {word}"]


def canonical(camera=(), viewport=(), raytracer=(), models=(), primitives=(), materials=(), lights=()):
    """The canonical text. Models: their values; primitives: (name of the material, shape); materials: values, or (word, values); lights: (word, values)."""
    remark = lambda word: ["/*", "   " + word, "*/", ""]
    lines = remark("Rendering")
    for word, values in (("camera", camera), ("viewport", viewport), ("raytracer", raytracer)):
        lines += block(word, dict(values)) + [""]
    lines += remark("Models")
    for values in models:
        lines += block("model", values) + [""]
    lines += remark("Primitives")
    for name, shape in primitives:
        lines += block("primitive", {"material_name": name}, 0, shape) + [""]
    lines += remark("Materials")
    for one in materials:
        word, values = one if isinstance(one, tuple) else ("material", one)
        lines += block(word, values) + [""]
    lines += remark("Lights")
    for word, values in lights:
        lines += block(word, values) + [""]
    return "".join(line + "\n" for line in lines)


def substitute(name):
    """The material that stands in for one that the scene does not have."""
    return {"name": name, "kd": 0.6, "ks": 0.7}
