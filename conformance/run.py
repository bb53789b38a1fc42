#!/usr/bin/env python3
"""Runs the conformance suite against a port: python3 conformance/run.py [options] -- COMMAND [ARGUMENT]...

The same as `dioptre conform`, for those who have Python 3.9 and no Haskell. It needs nothing beyond the standard library. A port is a program that
answers the protocol of spec/00-conformance.md; conformance/README.md says how to write one.

  --profile P    only this profile (may be repeated)
  --rule R       only this rule, or the rules whose labels begin with R and a dot
  --case C       only this case
  --timeout S    seconds that the port may be silent (10)
  --format F     text or json
  --suite FOLDER the folder of the suite (the one in which this file is)

Exit codes: 0 nothing failed, 1 something did, 2 wrong usage or no such case, 3 no suite, or a port that cannot be started.
"""

import argparse
import base64
import json
import math
import os
import queue
import re
import signal
import struct
import subprocess
import sys
import threading
import time
import zlib

PROFILES = {
    "maths": ["vector.add", "vector.subtract", "vector.dot", "vector.cross", "vector.distance", "vector.angle", "vector.scale", "vector.modulus", "vector.normalize",
              "roots.linear", "roots.quadratic", "roots.cubic", "roots.quartic",
              "transform.matrix", "transform.position", "transform.direction", "transform.normal", "transform.ray"],
    "geometry": ["ray.position", "intersect.plane", "intersect.sphere", "intersect.tube", "intersect.cones", "intersect.torus",
                 "geometry.hit", "geometry.contains", "triangle.barycentric"],
    "optics": ["optics.reflect", "optics.refract"],
    "lighting": ["light.ambient", "light.lambert", "light.blinn", "light.phong"],
    "scene": ["scene.check", "camera.ray"],
    "picture": ["scene.pixel", "scene.picture"],
}
PROFILE_OF = {operation: profile for profile, operations in PROFILES.items() for operation in operations}
TAKES_TEXT = ["scene.check", "camera.ray", "scene.pixel", "scene.picture"]


class Fault(Exception):
    """Something is wrong with the suite: a place and a sentence."""


# Reading the suite


def read_json(text):
    """JSON as the protocol has it: every number is a binary64, and NaN is none."""

    def refuse(name):
        raise ValueError(name + " is not JSON")

    return json.loads(text, parse_int=float, parse_constant=refuse)


def png_pixels(path):
    """Width, height and RGBA bytes of a PNG of 8 bits a channel, with or without alpha, not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise Fault(f"{path}: this is not a PNG file")
    at, packed, header = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += size + 12
    if header is None or header[2] != 8 or header[3] not in (2, 6) or header[6] != 0:
        raise Fault(f"{path}: only 8-bit RGB and RGBA PNG files that are not interlaced are read")
    width, height, channels = header[0], header[1], 3 if header[3] == 2 else 4
    raw, stride, pixels = zlib.decompress(packed), width * channels, bytearray()
    before = bytearray(stride)
    for row in range(height):
        how = raw[row * (stride + 1)]
        line = bytearray(raw[row * (stride + 1) + 1 : (row + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            up, corner = before[i], before[i - channels] if i >= channels else 0
            if how == 1:
                guess = left
            elif how == 2:
                guess = up
            elif how == 3:
                guess = (left + up) // 2
            elif how == 4:
                p = left + up - corner
                guess = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
            else:
                guess = 0
            line[i] = (line[i] + guess) & 255
        before = line
        for x in range(width):
            pixels += line[x * channels : x * channels + channels] + (b"\xff" if channels == 3 else b"")
    return width, height, bytes(pixels)


def with_files(case, pictures):
    """A case whose `in` or `ok` names a file among the pictures, with the contents of the file."""
    sent, expected = case["in"], case["ok"]
    if isinstance(sent, dict) and isinstance(sent.get("file"), str):
        with open(os.path.join(pictures, os.path.basename(sent["file"])), "rb") as file:
            case["in"] = {**{name: value for name, value in sent.items() if name != "file"}, "text": file.read().decode("utf-8")}
    if isinstance(expected, dict) and isinstance(expected.get("file"), str):
        width, height, pixels = png_pixels(os.path.join(pictures, os.path.basename(expected["file"])))
        case["ok"] = {"width": float(width), "height": float(height), "rgba": base64.b64encode(pixels).decode("ascii")}
    return case


def read_vectors(path, pictures):
    """The cases of a vector file."""
    try:
        with open(path, "rb") as file:
            whole = read_json(file.read().decode("utf-8"))
        operation, profile = whole["operation"], whole["profile"]
        if PROFILE_OF.get(operation) != profile:
            raise Fault(f"{path}: there is no operation {operation} in the profile {profile}")
        cases = []
        for case in whole["cases"]:
            compare = case.get("compare", "exact")
            parse_compare(compare)
            made = {"id": case["id"], "profile": profile, "operation": operation, "rules": case["rules"], "comment": case.get("comment", ""),
                    "flags": case.get("flags", []), "in": case["in"], "ok": case["ok"], "compare": compare}
            cases.append(with_files(made, pictures))
        return cases
    except (ValueError, KeyError, TypeError, OSError, zlib.error) as error:
        raise Fault(f"{path}: {type(error).__name__}: {error}") from error


LABEL = re.compile(r"[a-z0-9-]+(\.[a-z0-9-]+)+\Z")


def read_chapter(path):
    """The rules of a chapter of the specification: (label, line, cases, number of shown blocks). Raises a Fault on the first mistake of form."""
    name = "spec/" + os.path.basename(path)
    with open(path, encoding="utf-8", newline="") as file:
        lines = file.read().replace("\r\n", "\n").split("\n")
    rules, at = [], 0
    while at < len(lines):
        line, start = lines[at], at + 1
        at += 1
        fence = len(line) - len(line.lstrip("`"))
        if fence >= 3:
            body = []
            while True:
                if at >= len(lines):
                    raise Fault(f"{name}:{start}: this block is never closed")
                closing = lines[at].rstrip(" ")
                at += 1
                if len(closing) >= fence and set(closing) == {"`"}:
                    break
                body.append(lines[at - 1])
            info = line[fence:].split()
            if info[:1] in (["example"], ["shown"]):
                if not rules:
                    raise Fault(f"{name}:{start}: no rule stands before this block")
                add_block(name, start, info, body, rules[-1])
        elif line.startswith("**`") and "`**" in line:
            label = line[3 : line.index("`**")]
            if not LABEL.match(label):
                raise Fault(f"{name}:{start}: '{label}' is not a label")
            rules.append({"label": label, "file": name, "line": start, "cases": [], "shown": 0})
    return rules


def add_block(name, start, info, body, rule):
    def fault(sentence):
        return Fault(f"{name}:{start}: {sentence}")

    expected_name = f"{rule['label']}-{len(rule['cases']) + rule['shown'] + 1}"
    if len(info) < 2 or info[1] != expected_name:
        raise fault(f"this block should be called {expected_name}, not {' '.join(info[1:2])}")
    if info[0] == "shown":
        if len(info) != 2 or not any(line.strip() for line in body):
            raise fault("a block 'shown ID' says something")
        rule["shown"] += 1
        return
    if len(info) not in (3, 4):
        raise fault("a block begins with 'example ID OPERATION' and perhaps a comparison")
    operation, compare = info[2], info[3] if len(info) == 4 else "exact"
    if operation not in PROFILE_OF:
        raise fault(f"there is no operation {operation}")
    if "---" not in body:
        raise fault("there is no line --- in this block")
    divider = len(body) - 1 - body[::-1].index("---")
    before, after = body[:divider], body[divider + 1 :]
    try:
        parse_compare(compare)
        if operation in TAKES_TEXT:
            sent = read_json(before[0] if before else "")
            sent["text"] = "".join(line + "\n" for line in before[1:])
        else:
            sent = read_json("\n".join(before))
        if not isinstance(sent, dict):
            raise ValueError("what is sent is not an object")
        expected = read_json("\n".join(after))
    except (ValueError, TypeError) as error:
        raise fault(str(error)) from error
    rule["cases"].append({"id": info[1], "profile": PROFILE_OF[operation], "operation": operation, "rules": [rule["label"]], "comment": f"{name}:{start}",
                          "flags": [], "in": sent, "ok": expected, "compare": compare})


def read_specification(folder):
    """All rules of the specification in a folder."""
    rules, seen = [], {}
    for file in sorted(os.listdir(folder)):
        if file.endswith(".md"):
            rules += read_chapter(os.path.join(folder, file))
    for rule in rules:
        if rule["label"] in seen:
            raise Fault(f"{rule['file']}:{rule['line']}: there is another rule called {rule['label']}")
        seen[rule["label"]] = True
        if not rule["cases"] and not rule["shown"]:
            raise Fault(f"{rule['file']}:{rule['line']}: {rule['label']} has no example")
    return rules


def read_suite(folder):
    """The examples of the specification beside the suite, and the vectors: by profiles, then by operations."""
    cases = []
    specification = os.path.join(os.path.dirname(os.path.abspath(folder)), "spec")
    if os.path.isdir(specification):
        cases += [case for rule in read_specification(specification) for case in rule["cases"]]
    vectors = os.path.join(folder, "vectors")
    try:
        names = sorted(name for name in os.listdir(vectors) if name.endswith(".json"))
    except OSError as error:
        raise Fault(str(error)) from error
    for name in names:
        cases += read_vectors(os.path.join(vectors, name), os.path.join(folder, "pictures"))
    seen = set()
    for case in cases:
        if case["id"] in seen:
            raise Fault(f"two cases are called {case['id']}")
        seen.add(case["id"])
    order = list(PROFILES)
    return sorted(cases, key=lambda case: (order.index(case["profile"]), case["operation"]))


# Comparing


def parse_compare(compare):
    """A comparison as a pair of its kind and its number, or a dictionary of them."""
    if isinstance(compare, dict):
        return {name: parse_compare(inner) for name, inner in compare.items()}
    if not isinstance(compare, str):
        raise ValueError("a comparison is a word or an object")
    kind, colon, number = compare.partition(":")
    if kind in ("exact", "set") and not colon:
        return kind, None
    if kind in ("ulp", "levels") and re.fullmatch(r"\+?[0-9]{1,10}", number):
        return kind, int(number)
    if kind in ("abs", "rel") and re.fullmatch(r"\+?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?", number):
        return kind, float(number)
    raise ValueError(f"no comparison is called '{compare}'")


def rank(x):
    """The number of a binary64 in the row of them all, 0 for zero."""
    bits = struct.unpack("<q", struct.pack("<d", x))[0]
    return bits if bits >= 0 else -(2**63) - bits


def near(how, expected, got):
    kind, number = how if isinstance(how, tuple) else ("exact", None)
    if kind == "ulp":
        return abs(rank(expected) - rank(got)) <= number
    if kind == "abs":
        return abs(got - expected) <= number
    if kind == "rel":
        return abs(got - expected) <= number * abs(expected)
    return expected == got


def same_bytes(most, expected, got):
    try:
        a, b = base64.b64decode(expected, validate=True), base64.b64decode(got, validate=True)
    except ValueError:
        return False
    return len(a) == len(b) and (a == b or all(abs(p - q) <= most for p, q in zip(a, b)))


def first_difference(how, expected, got, place="$"):
    """The place at which a result first differs from the expected one; None where it passes."""
    number = isinstance(how, tuple) and how[0]
    if isinstance(expected, float) and isinstance(got, float):
        return None if near(how, expected, got) else place
    if isinstance(expected, str) and isinstance(got, str) and number == "levels":
        return None if same_bytes(how[1], expected, got) else place
    if isinstance(expected, list) and isinstance(got, list):
        if len(expected) != len(got):
            return place
        if number == "set":
            rest = list(got)
            for item in expected:
                for i, other in enumerate(rest):
                    if first_difference(how, item, other) is None:
                        del rest[i]
                        break
                else:
                    return place
            return None
        for i, (item, other) in enumerate(zip(expected, got)):
            found = first_difference(how, item, other, f"{place}[{i}]")
            if found:
                return found
        return None
    if isinstance(expected, dict) and isinstance(got, dict):
        for name in sorted(expected):
            if name not in got:
                return f"{place}.{name}"
            inner = how.get(name, ("exact", None)) if isinstance(how, dict) else how
            found = first_difference(inner, expected[name], got[name], f"{place}.{name}")
            if found:
                return found
        for name in sorted(got):
            if name not in expected:
                return f"{place}.{name}"
        return None
    return None if type(expected) is type(got) and expected == got else place


def judge(case, answer):
    """("passed" | "failed" | "not implemented", what is to be told of it)"""
    if "ok" in answer:
        got, expected = answer["ok"], case["ok"]
        seen = got
        if case["operation"] == "scene.check" and isinstance(got, dict) and isinstance(expected, dict):
            seen = {name: value for name, value in got.items() if name in expected}
        place = first_difference(parse_compare(case["compare"]), expected, seen)
        return ("passed", {}) if place is None else ("failed", {"got": abbreviated(got), "differsAt": place})
    if "skip" in answer:
        return "not implemented", {}
    return "failed", {"error": shortened(str(answer["error"]))}


def shortened(text):
    return text if len(text) <= 2000 else text[:2000] + "..."


def plain(value):
    """The value with whole numbers as whole numbers, which is how they are sent."""
    if isinstance(value, list):
        return [plain(item) for item in value]
    if isinstance(value, dict):
        return {name: plain(inner) for name, inner in value.items()}
    if isinstance(value, float) and abs(value) < 2**53 and value == int(value):
        return int(value)
    return value


def abbreviated(value, depth=6):
    """A value of which a person can read the whole."""
    if isinstance(value, str):
        return shortened(value)
    if isinstance(value, list):
        return "..." if depth == 0 else [abbreviated(item, depth - 1) for item in value[:50]] + ["..."] * (len(value) > 50)
    if isinstance(value, dict):
        return "..." if depth == 0 else {name: abbreviated(inner, depth - 1) for name, inner in sorted(value.items())[:50]}
    return plain(value)


# Running a port that may do anything


LONGEST = 1024 * 1024
MOST_ASTRAY = 1000
WINDOW = 64
STRIKES = 20


class Port:
    """A child process, the head of a group of its own. What it says comes line by line, None for the end and False for a line that is too long."""

    def __init__(self, command, longest):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
        self.lines, self.requests, self.last_words = queue.Queue(4), queue.Queue(), b""
        self.gone = False
        self.threads = [threading.Thread(target=work, daemon=True) for work in (self.write, lambda: self.read(longest), self.listen)]
        for thread in self.threads:
            thread.start()

    def write(self):
        try:
            while True:
                line = self.requests.get()
                if line is None:
                    self.process.stdin.close()
                    return
                self.process.stdin.write(line)
                self.process.stdin.flush()
        except (OSError, ValueError):
            return

    def put(self, line):
        while not self.gone:
            try:
                self.lines.put(line, timeout=0.1)
                return
            except queue.Full:
                pass

    def read(self, longest):
        pending, size = [], 0
        try:
            while not self.gone:
                chunk = os.read(self.process.stdout.fileno(), 65536)
                if not chunk:
                    break
                *ended, rest = chunk.split(b"\n")
                for piece in ended:
                    size += len(piece)
                    self.put(False if size > longest else b"".join(pending + [piece]))
                    pending, size = [], 0
                size += len(rest)
                pending = [] if size > longest else pending + [rest]
        except (OSError, ValueError):
            pass
        if size:
            self.put(False if size > longest else b"".join(pending))
        self.put(None)

    def listen(self):
        try:
            while True:
                chunk = os.read(self.process.stderr.fileno(), 65536)
                if not chunk:
                    return
                self.last_words = (self.last_words + chunk)[-1000:]
        except (OSError, ValueError):
            return

    def say(self, request):
        self.requests.put(json.dumps(request, ensure_ascii=False, separators=(",", ":")).encode("utf-8") + b"\n")

    def close(self):
        self.requests.put(None)

    def hear(self, seconds):
        """The next line within so many seconds; raises queue.Empty."""
        return self.lines.get(timeout=max(0, seconds)) if seconds > 0 else self.lines.get_nowait()

    def ending(self):
        """Why a port that has closed its output is no use any more, in words."""
        try:
            code = self.process.wait(1)
        except subprocess.TimeoutExpired:
            self.kill()
            code = self.process.wait()
        self.threads[2].join(0.2)
        words = self.last_words.decode("utf-8", "replace").strip()
        how = f"the port was ended by signal {-code}" if code < 0 else f"the port ended with exit code {code}"
        return how + (f"; it said: {words}" if words else "")

    def kill(self):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except OSError:
            pass

    def stop(self):
        self.gone = True
        self.kill()
        self.process.wait()
        self.requests.put(None)
        for thread in self.threads:
            thread.join(0.5)
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            try:
                pipe.close()
            except (OSError, ValueError):
                pass


class Runner:
    """Asks a port, as often as it must be started. No trouble is laid at the door of a case that did not make it: when a port fails with several requests outstanding, these are
    asked again one at a time, and the one that is alone when it fails is to blame."""

    def __init__(self, command, cases, timeout, told=lambda: None):
        self.command, self.cases, self.timeout, self.told = command, dict(enumerate(cases, 1)), timeout, told
        self.verdicts, self.suspects, self.others = {}, [], list(self.cases)
        self.strikes, self.last_trouble, self.ever_answered = 0, None, False
        self.introduction, self.asks_who = None, True
        self.complaints, self.complaint_count = [], 0
        self.longest = LONGEST * (64 if any(case["operation"] == "scene.picture" for case in cases) else 1)

    def run(self):
        while (self.suspects or self.others) and self.strikes < (STRIKES if self.ever_answered else 3):
            port = Port(self.command, self.longest)
            try:
                self.session(port)
            finally:
                port.stop()
        for number in self.suspects + self.others:
            why = "the port was given up" + (f" ({self.last_trouble})" if self.last_trouble else "")
            self.give(number, ("failed", {"trouble": why}))
        return [(case, *self.verdicts[number]) for number, case in self.cases.items()]

    def complain(self, complaint):
        self.complaint_count += 1
        if len(self.complaints) < 5 and complaint not in self.complaints:
            self.complaints.append(complaint)

    def give(self, number, verdict):
        self.verdicts[number] = verdict
        self.told()

    def blame(self, numbers, told):
        for number in sorted(numbers):
            if number == 0:
                self.complain("the port does not answer start")
            else:
                self.give(number, ("failed", told))

    def failed(self, outstanding, trouble):
        if len(outstanding) == 1:
            self.strikes += 1
            self.last_trouble = trouble
            self.blame(outstanding, {"trouble": trouble})
        else:
            self.suspects = sorted(outstanding) + self.suspects

    def ask(self, port, number):
        case = self.cases[number]
        port.say({"id": number, "op": case["operation"], "in": plain(case["in"])})

    def may_be_long(self, number):
        return number in self.cases and self.cases[number]["operation"] == "scene.picture"

    def session(self, port):
        outstanding, astray, unnamed, meaning, since = set(), 0, 0, {}, time.monotonic()
        if self.asks_who:
            port.say({"id": 0, "op": "start"})
            outstanding.add(0)
        while True:
            if not outstanding or 0 not in outstanding:
                if self.suspects:
                    if not outstanding:
                        outstanding.add(self.suspects[0])
                        self.ask(port, self.suspects.pop(0))
                else:
                    while self.others and len(outstanding) < WINDOW:
                        outstanding.add(self.others[0])
                        self.ask(port, self.others.pop(0))
                if not outstanding:
                    self.farewell(port)
                    return
            all_astray = astray + unnamed > 0 and astray + unnamed >= len(outstanding)
            patience = min(1, self.timeout) if all_astray else self.timeout
            try:
                line = port.hear(since + patience - time.monotonic())
            except queue.Empty:
                if all_astray:
                    self.blame(outstanding, meaning)
                    outstanding, astray, unnamed, since = set(), 0, 0, time.monotonic()
                elif outstanding == {0}:
                    self.complain("the port does not answer start")
                    self.asks_who = False
                    outstanding, astray, unnamed, since = set(), 0, 0, time.monotonic()
                else:
                    return self.failed(outstanding, f"the port was silent for {self.timeout} s")
                continue
            if line is None:
                return self.failed(outstanding, port.ending())
            if line is False or (len(line) > LONGEST and not any(map(self.may_be_long, outstanding))):
                return self.failed(outstanding, f"the port said a line longer than {LONGEST} bytes")
            excerpt = line[:800].decode("utf-8", "replace")[:200]
            number, answer, complaint = None, None, None
            try:
                answer = read_json(line.decode("utf-8"))
                if not isinstance(answer, dict):
                    complaint = "a line that is not a JSON object"
                elif not any(name in answer for name in ("ok", "skip", "error")):
                    complaint = "an answer without 'ok', 'skip' or 'error'"
                else:
                    number = answer.get("id")
                    if not (isinstance(number, float) and 0 <= number < 2**53 and number == int(number)):
                        complaint = "an answer without 'id'"
            except (ValueError, RecursionError):
                complaint = "a line that is not JSON"
            if complaint:
                nameless = complaint.endswith("'id'")
                astray, unnamed = astray + (not nameless), unnamed + nameless
                if astray + unnamed > MOST_ASTRAY:
                    return self.failed(outstanding, f"the port said what is no answer: {excerpt}")
                self.complain(f"{complaint}: {excerpt}")
                refused = nameless and "ok" not in answer and "skip" not in answer
                meaning = {"error": shortened(str(answer["error"]))} if refused else {"trouble": f"the port said what is no answer: {excerpt}"}
            elif number not in outstanding:
                self.complain(f"an answer to no request: {excerpt}")
            else:
                number = int(number)
                outstanding.discard(number)
                astray, since, self.ever_answered = 0, time.monotonic(), True
                if number == 0:
                    if "ok" in answer:
                        self.introduction = self.introduction or answer["ok"]
                    else:
                        self.complain("the port does not answer start")
                        self.asks_who = False
                elif len(line) > LONGEST and not self.may_be_long(number):
                    self.give(number, ("failed", {"trouble": f"the port said a line longer than {LONGEST} bytes"}))
                else:
                    self.give(number, judge(self.cases[number], answer))

    def farewell(self, port):
        port.close()
        deadline = time.monotonic() + min(2, self.timeout)
        while True:
            try:
                line = port.hear(deadline - time.monotonic())
            except queue.Empty:
                self.complain("the port goes on after the end of its input")
                return
            if line is None:
                return
            if line:
                self.complain(f"an answer to no request: {line[:800].decode('utf-8', 'replace')[:200]}")


# Telling


def score(results):
    counts = {"passed": 0, "failed": 0, "not implemented": 0}
    for _, verdict, _ in results:
        counts[verdict] += 1
    return counts["passed"], counts["failed"], counts["not implemented"]


def clean(text):
    return "".join("·" if ord(c) < 32 or ord(c) == 127 else c for c in text)


def shown(value):
    text = json.dumps(abbreviated(value), ensure_ascii=False, separators=(",", ":"), sort_keys=True)
    return text if len(text) <= 1000 else text[:1000] + "..."


def in_words(runner, results):
    lines = []
    for case, verdict, told in results:
        if verdict != "failed":
            continue
        if "differsAt" in told:
            got = f"{shown(told['got'])}, which differs at {told['differsAt']}"
        elif "error" in told:
            got = "an error: " + told["error"]
        else:
            got = "no answer: " + told["trouble"]
        lines.append("failed " + case["id"])
        for name, text in (("rules", ", ".join(case["rules"])), ("comment", case["comment"]), ("finds", ", ".join(case["flags"])), ("in", shown(case["in"])),
                           ("expected", f"{shown(case['ok'])}  ({shown(case['compare']) if isinstance(case['compare'], dict) else case['compare']})"), ("got", got)):
            if text or name != "finds":
                lines.append(f"  {name:<10}{clean(text)}")
        lines.append("")
    skipped = list(dict.fromkeys(case["operation"] for case, verdict, _ in results if verdict == "not implemented"))
    if skipped:
        lines += ["not implemented: " + ", ".join(skipped), ""]
    if runner.complaints:
        lines += ["remark: " + clean(complaint) for complaint in runner.complaints]
        if runner.complaint_count > len(runner.complaints):
            lines.append(f"and {runner.complaint_count - len(runner.complaints)} more like these")
        lines.append("")
    lines.append(clean(shown(runner.introduction)) if runner.introduction is not None else "a port that does not say who it is")
    lines.append(f"{'profile':<12}{'passed':>9}{'failed':>9}{'not implemented':>17}")
    for profile in PROFILES:
        here = [result for result in results if result[0]["profile"] == profile]
        if here:
            lines.append("{:<12}{:>9}{:>9}{:>17}".format(profile, *score(here)))
    lines.append("{:<12}{:>9}{:>9}{:>17}".format("all", *score(results)))
    return "\n".join(lines)


def in_json(runner, results):
    def counts(some):
        return dict(zip(("passed", "failed", "notImplemented"), score(some)))

    profiles = [p for p in PROFILES if any(case["profile"] == p for case, _, _ in results)]
    return {
        "port": runner.introduction,
        "profiles": [{"profile": p, **counts([r for r in results if r[0]["profile"] == p])} for p in profiles],
        "total": counts(results),
        "failures": [
            {"case": c["id"], "profile": c["profile"], "operation": c["operation"], "rules": c["rules"], "comment": c["comment"], "flags": c["flags"], "in": c["in"],
             "expected": c["ok"], "compare": c["compare"], **told}
            for c, verdict, told in results if verdict == "failed"
        ],
        "notImplemented": [c["id"] for c, verdict, _ in results if verdict == "not implemented"],
        "complaints": runner.complaints,
    }


def positive(text):
    seconds = float(text)
    if not 0 < seconds < math.inf:
        raise ValueError
    return seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--profile", action="append", default=[], metavar="P")
    parser.add_argument("--rule", metavar="R")
    parser.add_argument("--case", metavar="C")
    parser.add_argument("--timeout", type=positive, default=10.0, metavar="S")
    parser.add_argument("--format", choices=["text", "json"], default="text")
    parser.add_argument("--suite", default=os.path.dirname(os.path.abspath(__file__)), metavar="FOLDER")
    parser.add_argument("command", nargs="+", metavar="COMMAND")
    options = parser.parse_args()
    try:
        cases = read_suite(options.suite)
    except Fault as fault:
        print(fault, file=sys.stderr)
        return 3
    cases = [
        case for case in cases
        if (not options.profile or case["profile"] in options.profile)
        and (options.rule is None or any(label == options.rule or label.startswith(options.rule + ".") for label in case["rules"]))
        and (options.case is None or case["id"] == options.case)
    ]
    if not cases:
        print("no case of the suite is selected", file=sys.stderr)
        return 2
    done = [0]

    def told():
        done[0] += 1
        if sys.stderr.isatty():
            print(f"\r{done[0]} of {len(cases)}", end="\n" if done[0] == len(cases) else "", file=sys.stderr)

    runner = Runner(options.command, cases, options.timeout, told)
    try:
        results = runner.run()
    except OSError as error:
        print(error, file=sys.stderr)
        return 3
    print(json.dumps(in_json(runner, results), ensure_ascii=False) if options.format == "json" else in_words(runner, results))
    return 1 if any(verdict == "failed" for _, verdict, _ in results) else 0


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8", errors="backslashreplace")
    sys.exit(main())
