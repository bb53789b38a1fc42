"""Values of properties: tokens and forms (specification 2.6, 3.3)."""

import re
import unicodedata

import vector as V
from language import COLOURS, SMALLEST_LENGTH

TOKEN = re.compile(r"[^ \t\f,()\[\]<>]+")
REAL = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?\Z")
INTEGER = re.compile(r"[+-]?[0-9]+\Z")
COMMA = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?,[0-9]")
LARGEST = 1e100                        # value.real.largest


class Refused(Exception):
    """A value that its form does not take: a code, and a column."""

    def __init__(self, code, column):
        super().__init__(code)
        self.code, self.column = code, column


def parse(prop, line):
    """The value of a property as its form reads it, or Refused."""
    value, column = line.value, line.value_column
    if not value:
        raise Refused("missing-value", line.column)
    if prop.form == "text":                                # form.text
        return value
    if prop.form == "output":                              # code.unsafe-name
        if any(c in "/\\" or unicodedata.category(c) == "Cc" for c in value):
            raise Refused("unsafe-name", column)
        return value
    tokens = [(m.group(), column + m.start()) for m in TOKEN.finditer(value)]
    if not tokens:
        raise Refused("missing-value", column)
    return _FORMS[prop.form](prop, tokens, column)


def has_decimal_comma(prop, line):
    """code.decimal-comma"""
    return prop.form == "real" and COMMA.match(line.value) is not None


def is_number(word):
    """Whether a token is a real number that is not too large."""
    return REAL.match(word) is not None and abs(float(word)) <= LARGEST


def number(token):
    """A real number (value.real, value.real.largest, numbers.reading)."""
    word, column = token
    if not REAL.match(word):
        raise Refused("not-a-number", column)
    x = float(word)
    if abs(x) > LARGEST:
        raise Refused("number-too-large", column)
    return x


def in_range(prop, x, column):
    if (prop.low is not None and x < prop.low) or (prop.high is not None and x > prop.high):
        raise Refused("out-of-range", column)
    return x


def whole(word):
    """A whole number of any size."""
    digits = word.lstrip("+-").lstrip("0")
    size = int(digits[:30] or "0") if len(digits) <= 30 else 10 ** 30
    return -size if word.startswith("-") else size


def _real(prop, tokens, column):
    """form.real, value.single"""
    return in_range(prop, number(tokens[0]), tokens[0][1])


def _integer(prop, tokens, column):
    """form.integer, value.integer"""
    word, at = tokens[0]
    if not INTEGER.match(word):
        raise Refused("not-an-integer", at)
    x = whole(word)
    if not -2147483648 <= x <= 2147483647:
        raise Refused("number-too-large", at)
    return in_range(prop, x, at)


def _count(tokens, column, least, most):
    """code.wrong-count"""
    if len(tokens) < least:
        raise Refused("wrong-count", column)
    if len(tokens) > most:
        raise Refused("wrong-count", tokens[most][1])


def _vector(prop, tokens, column):
    """form.vector"""
    _count(tokens, column, 3, 3)
    return tuple(number(t) for t in tokens)


def _direction(prop, tokens, column):
    """form.direction, code.zero-vector"""
    v = _vector(prop, tokens, column)
    if V.modulus(v) < SMALLEST_LENGTH:
        raise Refused("zero-vector", column)
    return v


def _scale(prop, tokens, column):
    """form.direction, code.zero-component"""
    v = _vector(prop, tokens, column)
    if 0 in v:
        raise Refused("zero-component", column)
    return v


def _coordinates(prop, tokens, column):
    """form.coordinates"""
    _count(tokens, column, 2, 2)
    return tuple(number(t) for t in tokens)


def _channel(token):
    x = number(token)
    if x < 0:
        raise Refused("out-of-range", token[1])
    return x


def _colour(prop, tokens, column):
    """form.colour"""
    _count(tokens, column, 1, 4)
    if len(tokens) <= 2:
        name = COLOURS.get(tokens[0][0].lower())
        if name is None:
            raise Refused("unknown-choice", tokens[0][1])
        return name + ((_channel(tokens[1]) if len(tokens) == 2 else 1.0),)
    channels = tuple(_channel(t) for t in tokens)
    return channels if len(channels) == 4 else channels + (1.0,)


def _choice(prop, tokens, column):
    """form.choice"""
    word, at = tokens[0]
    if word.lower() in prop.choices:
        return word.lower()
    if not INTEGER.match(word):
        raise Refused("unknown-choice", at)
    if not 0 <= whole(word) < len(prop.choices):
        raise Refused("out-of-range", at)
    return prop.choices[whole(word)]


_FORMS = {"real": _real, "integer": _integer, "vector": _vector, "direction": _direction,
          "scale": _scale, "coordinates": _coordinates, "colour": _colour, "choice": _choice}
