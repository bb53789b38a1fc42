"""Fields of requests: whatever is missing, of the wrong type or without sense is refused
(protocol.refused, protocol.forms, protocol.rays, protocol.shapes)."""

import math

import language as L
import vector as V
from shapes import build


class Refused(Exception):
    """What is wrong with a request."""


def field(o, name):
    if name not in o:
        raise Refused("the field %s is missing" % name)
    return o[name]


def to_number(x, name):
    """protocol.numbers: nearest to the decimal number; too large ones cannot be sent."""
    if isinstance(x, bool) or not isinstance(x, (int, float)):
        raise Refused("%s is not a number" % name)
    try:
        x = float(x)
    except OverflowError:
        x = math.inf
    if not math.isfinite(x):
        raise Refused("%s is too large" % name)
    return x


def number(o, name):
    return to_number(field(o, name), name)


def at_least(o, name, low):
    x = number(o, name)
    if x < low:
        raise Refused("%s is less than %g" % (name, low))
    return x


def positive(o, name):
    x = number(o, name)
    if not x > 0:
        raise Refused("%s is not greater than 0" % name)
    return x


def whole(o, name, low, high, default=None):
    """A whole number from low up and below high."""
    if name not in o and default is not None:
        return default
    x = number(o, name)
    if x != int(x) or not low <= x < high:
        raise Refused("%s is no whole number from %d below %d" % (name, low, high))
    return int(x)


def to_vector(x, name, length=3):
    if not isinstance(x, list) or len(x) != length:
        raise Refused("%s is not an array of %d numbers" % (name, length))
    return tuple(to_number(c, name) for c in x)


def vector(o, name, default=None):
    if default is not None and name not in o:
        return default
    return to_vector(field(o, name), name)


def direction(o, name, least=0.0):
    """A vector that is not zero; where it makes a plane or the like, not too short either."""
    v = vector(o, name)
    if V.is_zero(v) or V.modulus(v) < least:
        raise Refused("%s has no direction" % name)
    return v


def unit(o, name):
    """A direction, made unit (protocol.directions, protocol.sizes)."""
    return V.unit(direction(o, name))


def colour(o, name):
    x = field(o, name)
    c = to_vector(x, name, 4 if isinstance(x, list) and len(x) == 4 else 3)
    if min(c) < 0:
        raise Refused("%s has a channel below 0" % name)
    return c[:3]


def ray(o, name="ray"):
    r = field(o, name)
    if not isinstance(r, dict):
        raise Refused("%s is not an object" % name)
    return vector(r, "origin"), direction(r, "direction")


def text(o):
    x = field(o, "text")
    if not isinstance(x, str):
        raise Refused("text is not a string")
    return x


def shape(o, name):
    """protocol.shapes: a shape by the table of 3.7, nested ones from the outside in."""
    chain = []
    x = field(o, name)
    while True:
        block, values, inner = _one_shape(x)
        chain.append((block, values))
        if not block.has_shape:
            break
        x = inner
    made = None
    for block, values in reversed(chain):
        made = build(block.name, dict(values, geometry=made))
    return made


def _one_shape(x):
    if not isinstance(x, dict):
        raise Refused("a shape is not an object")
    kind = field(x, "kind")
    block = L.SHAPES.get(kind) if isinstance(kind, str) else None
    if block is None or block.name != kind:
        raise Refused("there is no shape of this kind")
    values = block.defaults()
    properties = {p.name: p for p in block.properties}
    for name, given in x.items():
        if name == "kind" or (name == "geometry" and block.has_shape):
            continue
        prop = properties.get(name)
        if prop is None:
            raise Refused("%s is no property of %s" % (name, kind))
        if prop.places == 1:
            values[name] = _value(prop, given)
        else:
            if not isinstance(given, list) or len(given) > prop.places:
                raise Refused("%s is not an array of at most %d values" % (name, prop.places))
            for i, one in enumerate(given):
                values[name][i] = _value(prop, one)
    code = block.impossible(values)
    if code:
        raise Refused(code)
    return block, values, field(x, "geometry") if block.has_shape else None


def _written(x, name):
    """A number that a scene could have (value.real.largest)."""
    x = to_number(x, name)
    if abs(x) > 1e100:
        raise Refused("%s is too large" % name)
    return x


def _value(prop, x):
    """A property's value, which its form takes (3.3)."""
    if prop.form == "real":
        x = _written(x, prop.name)
        if (prop.low is not None and x < prop.low) or (prop.high is not None and x > prop.high):
            raise Refused("%s is out of range" % prop.name)
        return x
    if prop.form == "coordinates":
        return tuple(_written(c, prop.name) for c in to_vector(x, prop.name, 2))
    v = tuple(_written(c, prop.name) for c in to_vector(x, prop.name))
    if prop.form == "direction" and V.modulus(v) < L.SMALLEST_LENGTH:
        raise Refused("%s is too short" % prop.name)
    if prop.form == "scale" and 0 in v:
        raise Refused("%s has a zero" % prop.name)
    return v
