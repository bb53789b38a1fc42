"""Requests and answers, one JSON object a line (specification 0.4)."""

import json
import json.scanner
import sys

from operations import OPERATIONS

START = {"implementation": "dioptre-python-port", "language": "Python", "version": "1.0.0",
         "profiles": ["maths", "geometry", "optics", "lighting", "scene", "picture"]}


class Malformed(Exception):
    """A line that is no request (protocol.malformed)."""


def _integer(digits):
    """A whole number; one of very many digits only as the float that it is read as."""
    return int(digits) if len(digits) < 1000 else float(digits)


def _constant(word):
    raise Malformed("%s is not JSON" % word)               # NaN and infinities


def _decoder():
    """A reader of JSON that nests as deep as Python does, where the quick one gives up."""
    decoder = json.JSONDecoder(parse_int=_integer, parse_constant=_constant)
    decoder.scan_once = json.scanner.py_make_scanner(decoder)
    return decoder


def _loads(text):
    try:
        return json.loads(text, parse_int=_integer, parse_constant=_constant)
    except RecursionError:
        return _decoder().decode(text)


def parse(line):
    """A request from the bytes of a line (protocol.request, protocol.malformed)."""
    try:
        request = _loads(line.decode("utf-8"))
    except (ValueError, RecursionError) as problem:
        raise Malformed("not JSON: %s" % problem)
    if not isinstance(request, dict):
        raise Malformed("not an object")
    number = request.get("id")
    if isinstance(number, float) and number.is_integer():
        number = int(number)
    if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < 2 ** 53:
        raise Malformed("id is not a whole number from 0 to 2^53 - 1")
    if not isinstance(request.get("op"), str):
        raise Malformed("op is not a string")
    return number, request["op"], request.get("in", {})


def answer(number, op, given):
    """The answer to a request (protocol.answer, protocol.start, protocol.unknown,
    protocol.refused)."""
    if op == "start":
        return {"id": number, "ok": START}
    if op not in OPERATIONS:
        return {"id": number, "skip": "not implemented"}
    if not isinstance(given, dict):
        return {"id": number, "error": "in is not an object"}
    try:
        return {"id": number, "ok": OPERATIONS[op](given)}
    except Exception as problem:                           # a refusal, or no finite result
        return {"id": number, "error": "%s: %s" % (type(problem).__name__, problem)}


def line_for(request_line):
    """The line of an answer to a line of a request; what is not finite becomes an error."""
    try:
        number, op, given = parse(request_line)
    except Malformed as problem:
        return json.dumps({"error": str(problem)})
    result = answer(number, op, given)
    try:
        return json.dumps(result, allow_nan=False)
    except ValueError:
        return json.dumps({"id": number, "error": "the result is not finite"})


def serve(source, sink):
    """protocol.lines: one answer a line, flushed at once, until the end of the input."""
    for line in source:
        sink.write(line_for(line) + "\n")
        sink.flush()


def main():
    serve(sys.stdin.buffer, sys.stdout)
