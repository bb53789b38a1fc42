"""The canonical text of a scene (specification 3.9), and how numbers are written (1.3)."""

import math

from shapes.triangle import flat_normal


def _digits(x):
    """The fewest digits that read back as x > 0, the nearest of those, and the e with x = 0.DIGITS 10^e
    (numbers.writing): those of repr.
    """
    mantissa, _, exponent = repr(x).partition("e")
    whole, _, fraction = mantissa.partition(".")
    digits = (whole + fraction).lstrip("0")
    e = len(digits) - len(fraction) + int(exponent or "0")
    return digits.rstrip("0"), e


def number(x):
    """A real number (numbers.writing)."""
    if x == 0:
        return "-0.0" if math.copysign(1.0, x) < 0 else "0.0"
    sign = "-" if x < 0 else ""
    digits, e = _digits(abs(x))
    if 0.001 <= abs(x) < 1e7:
        if e <= 0:
            return sign + "0." + "0" * -e + digits
        digits = digits.ljust(e, "0")
        return sign + digits[:e] + "." + (digits[e:] or "0")
    return "%s%s.%se%d" % (sign, digits[0], digits[1:] or "0", e - 1)


def value(prop, x):
    """canonical.values"""
    if prop.form == "real":
        return number(x) + prop.unit
    if prop.form == "integer":
        return str(x) + prop.unit
    if prop.form == "colour":
        return "[ " + ", ".join(number(c) for c in x) + " ]"
    if prop.form in ("vector", "direction", "scale", "coordinates"):
        return "[" + ", ".join(number(c) for c in x) + "]"
    return x


def write(item, depth, out):
    """An object with its properties and its shape (canonical.layout, canonical.words)."""
    stack = []
    while item is not None:
        indent = " " * (2 * min(10, depth))
        out.append(indent + item.block.name)
        inside = " " * (2 * min(10, depth + 1))
        room = max(0, 30 - 2 * (depth + 1))
        for prop in item.block.properties:
            places = item.values[prop.name] if prop.places > 1 else [item.values[prop.name]]
            for x in places:
                if x is None:                              # shape.btriangle.normals
                    x = flat_normal(*item.values["point"])
                out.append(inside + (prop.written + " ").ljust(room) + value(prop, x))
        stack.append(indent + "end #end " + item.block.name)
        item, depth = item.shape, depth + 1
    out.extend(reversed(stack))


def text(scene):
    """canonical.order"""
    out = []
    for word, items in (("Rendering", [scene.camera, scene.viewport, scene.raytracer]),
                        ("Models", scene.models), ("Primitives", scene.primitives),
                        ("Materials", scene.materials), ("Lights", scene.lights)):
        out.extend(("/*", "   " + word, "*/", ""))
        for item in items:
            write(item, 0, out)
            out.append("")
    return "\n".join(out) + "\n"
