#!/usr/bin/env python3
"""Checks grammar.abnf, the grammar of Dioptre's files, and what it says of them.

1. The file is ABNF (RFC 5234): every rule can be read, is defined once, and is
   used or is one that files begin with; no rule begins with itself.
2. Every scene of the folder scenes belongs to the rule "scene", except
   mistakes.txt, which must not; configuration.cfg belongs to "configuration".
3. Every example of scene.check in the chapters belongs to "scene", or not, as
   its diagnostics say (rule grammar.scene); every one belongs to "text".

Standard library only. Exit code 0 if all is well, 1 if something is not.
"""

import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
STARTS = ["text", "scene", "configuration", "comparisons"]

# Diagnostics of texts that do not belong to "scene" (grammar.scene).
ALWAYS = set(
    "unknown-word misplaced-word stray-end misspelt-end missing-end unclosed-comment missing-value"
    " not-a-number not-an-integer wrong-count unknown-choice second-shape".split()
)
# Diagnostics that may hide one of those.
SOMETIMES = set(
    "repeated-property out-of-range number-too-large no-shape zero-normal collinear-points equal-points"
    " inner-beyond-outer curvature-below-radius lens-too-thin".split()
)


class GrammarError(Exception):
    """Something is wrong with the grammar; the message says where."""


# ---------------------------------------------------------------------------
# Reading ABNF. A rule becomes a tree of tuples:
#   ("set", ranges)  ("word", text)  ("name", rule)
#   ("all", parts)   ("any", parts)  ("repeat", least, most, part)

TOKEN = re.compile(
    r"""(?P<blank>[ \t]+|;[^\n]*)
      | (?P<name>[A-Za-z][A-Za-z0-9-]*)
      | (?P<string>"[\x20-\x21\x23-\x7E]*")
      | (?P<number>%[xX][0-9A-Fa-f]+(?:-[0-9A-Fa-f]+|(?:\.[0-9A-Fa-f]+)+)?)
      | (?P<repeat>[0-9]*\*[0-9]*|[0-9]+)
      | (?P<mark>=/|[=/()\[\]])""",
    re.VERBOSE,
)


def tokens_of(line, number):
    place = 0
    found = []
    while place < len(line):
        match = TOKEN.match(line, place)
        if not match:
            raise GrammarError(f"grammar.abnf:{number}: cannot read {line[place:]!r}")
        if match.lastgroup != "blank":
            found.append((match.lastgroup, match.group(), number))
        place = match.end()
    return found


class Reader:
    """Reads the elements of one rule."""

    def __init__(self, tokens):
        self.tokens = tokens
        self.place = 0

    def peek(self):
        return self.tokens[self.place][:2] if self.place < len(self.tokens) else ("end", "")

    def take(self):
        token = self.tokens[self.place]
        self.place += 1
        return token

    def fail(self, what):
        number = self.tokens[min(self.place, len(self.tokens) - 1)][2]
        raise GrammarError(f"grammar.abnf:{number}: {what}")

    def alternation(self):
        parts = [self.concatenation()]
        while self.peek() == ("mark", "/"):
            self.take()
            parts.append(self.concatenation())
        if len(parts) > 1 and all(part[0] == "set" for part in parts):
            return ("set", sorted(r for part in parts for r in part[1]))
        return parts[0] if len(parts) == 1 else ("any", parts)

    def concatenation(self):
        parts = [self.repetition()]
        while self.peek()[0] in ("name", "string", "number", "repeat") or self.peek() in (("mark", "("), ("mark", "[")):
            parts.append(self.repetition())
        return parts[0] if len(parts) == 1 else ("all", parts)

    def repetition(self):
        if self.peek()[0] != "repeat":
            return self.element()
        counts = self.take()[1]
        least, star, most = counts.partition("*")
        if not star:
            return ("repeat", int(counts), int(counts), self.element())
        return ("repeat", int(least or 0), int(most) if most else None, self.element())

    def element(self):
        kind, text = self.peek()
        if kind == "name":
            self.take()
            return ("name", text.lower())
        if kind == "string":
            self.take()
            return ("word", text[1:-1].lower())
        if kind == "number":
            self.take()
            digits = text[2:]
            if "-" in digits:
                low, high = (int(d, 16) for d in digits.split("-"))
                return ("set", [(low, high)])
            sets = [("set", [(int(d, 16),) * 2]) for d in digits.split(".")]
            return sets[0] if len(sets) == 1 else ("all", sets)
        if text in ("(", "["):
            self.take()
            inner = self.alternation()
            if self.peek() != ("mark", ")" if text == "(" else "]"):
                self.fail(f"'{text}' is not closed")
            self.take()
            return inner if text == "(" else ("repeat", 0, 1, inner)
        return self.fail(f"{text!r} where an element was expected")


def read_grammar(source):
    rules = {}
    pending = []
    for number, line in enumerate(source.split("\n"), 1):
        found = tokens_of(line, number)
        if not found:
            continue
        if line[0] in " \t":
            if not pending:
                raise GrammarError(f"grammar.abnf:{number}: a rule begins at the left margin")
            pending[-1].extend(found)
        else:
            pending.append(found)
    for found in pending:
        (kind, name, number) = found[0]
        name = name.lower()
        if kind != "name" or len(found) < 3 or found[1][1] not in ("=", "=/"):
            raise GrammarError(f"grammar.abnf:{number}: a rule is a name, '=' and elements")
        reader = Reader(found[2:])
        tree = reader.alternation()
        if reader.peek()[0] != "end":
            reader.fail(f"{reader.peek()[1]!r} where nothing more was expected")
        if found[1][1] == "=/":
            if name not in rules:
                raise GrammarError(f"grammar.abnf:{number}: nothing to add to: {name}")
            tree = ("any", [rules[name], tree])
        elif name in rules:
            raise GrammarError(f"grammar.abnf:{number}: {name} is defined again")
        rules[name] = tree
    return rules


# ---------------------------------------------------------------------------
# Checking the grammar itself


def names_in(tree):
    if tree[0] == "name":
        yield tree[1]
    elif tree[0] in ("all", "any"):
        for part in tree[1]:
            yield from names_in(part)
    elif tree[0] == "repeat":
        yield from names_in(tree[3])


def nullable_rules(rules):
    """The rules that the empty text belongs to."""
    found = set()

    def empty(tree):
        if tree[0] == "name":
            return tree[1] in found
        if tree[0] == "word":
            return tree[1] == ""
        if tree[0] == "all":
            return all(map(empty, tree[1]))
        if tree[0] == "any":
            return any(map(empty, tree[1]))
        return tree[0] == "repeat" and (tree[1] == 0 or empty(tree[3]))

    while True:
        more = {name for name, tree in rules.items() if name not in found and empty(tree)}
        if not more:
            return found, empty
        found |= more


def first_names(tree, empty):
    """The rules that a text of this tree may begin with."""
    if tree[0] == "name":
        return {tree[1]}
    if tree[0] == "any":
        return set().union(*(first_names(part, empty) for part in tree[1]))
    if tree[0] == "repeat":
        return first_names(tree[3], empty)
    found = set()
    if tree[0] == "all":
        for part in tree[1]:
            found |= first_names(part, empty)
            if not empty(part):
                break
    return found


def check_grammar(rules):
    problems = []
    used = {name for tree in rules.values() for name in names_in(tree)}
    problems += [f"grammar.abnf: {name} is used and not defined" for name in sorted(used - set(rules))]
    problems += [f"grammar.abnf: {name} is defined and not used" for name in sorted(set(rules) - used - set(STARTS))]
    problems += [f"grammar.abnf: {name} is missing" for name in STARTS if name not in rules]
    if problems:
        return problems
    _, empty = nullable_rules(rules)
    begins = {name: first_names(tree, empty) for name, tree in rules.items()}
    for name in rules:
        reached, fresh = set(), set(begins[name])
        while fresh:
            reached |= fresh
            fresh = set().union(*(begins[n] for n in fresh)) - reached
        if name in reached:
            problems.append(f"grammar.abnf: {name} begins with itself")
    return problems


# ---------------------------------------------------------------------------
# Recognising: the ends of all texts of a tree that begin at a place


class Recogniser:
    def __init__(self, rules):
        self.rules = rules

    def belongs(self, rule, text):
        self.text = text
        self.known = {}
        return len(text) in self.ends(("name", rule), 0)

    def ends(self, tree, start):
        kind = tree[0]
        if kind == "name":
            key = (tree[1], start)
            if key not in self.known:
                self.known[key] = self.ends(self.rules[tree[1]], start)
            return self.known[key]
        if kind == "set":
            return {start + 1} if self.holds(tree[1], start) else set()
        if kind == "word":
            stop = start + len(tree[1])
            return {stop} if self.text[start:stop].lower() == tree[1] else set()
        if kind == "any":
            return set().union(*(self.ends(part, start) for part in tree[1]))
        if kind == "all":
            places = {start}
            for part in tree[1]:
                places = set().union(*(self.ends(part, place) for place in places)) if places else places
            return places
        return self.repeated(tree, start)

    def repeated(self, tree, start):
        _, least, most, part = tree
        places, found, count = {start}, set(), 0
        seen = set()
        while places:
            if count >= least:
                places = places - seen
                seen |= places
                found |= places
            if count == most:
                break
            places = set().union(*(self.ends(part, place) for place in places)) if places else places
            count += 1
        return found

    def holds(self, ranges, place):
        if place >= len(self.text):
            return False
        code = ord(self.text[place])
        return any(low <= code <= high for low, high in ranges)


# ---------------------------------------------------------------------------
# The files that the grammar is about


def decoded(path):
    """A file's text, as chapter 2.1 has it, each line with its line feed."""
    data = path.read_bytes()
    if data.startswith(b"\xef\xbb\xbf"):
        data = data[3:]
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return closed(text.replace("\r\n", "\n").replace("\r", "\n"))


def closed(text):
    return text if text == "" or text.endswith("\n") else text + "\n"


EXAMPLE = re.compile(r"^```example (\S+) scene\.check[^\n]*\n[^\n]*\n(.*?)^---\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def examples(path):
    """The examples of scene.check in a chapter: label, text, codes of its diagnostics (none where they are left out)."""
    source = path.read_bytes().decode("utf-8")
    for label, text, result in EXAMPLE.findall(source):
        result = json.loads(result)
        codes = {d["code"] for d in result["diagnostics"]} if "diagnostics" in result else None
        yield label, text, codes


def check_files(rules):
    recogniser = Recogniser(rules)
    problems = []
    counted = {"scenes": 0, "examples": 0}

    def expect(wanted, rule, text, what):
        if recogniser.belongs(rule, text) != wanted:
            problems.append(f"{what} {'does not belong' if wanted else 'belongs'} to {rule}")

    root = HERE.parent
    for path in sorted((root / "scenes").glob("*.txt")):
        text = decoded(path)
        counted["scenes"] += 1
        expect(True, "text", text, path.name)
        expect(path.name != "mistakes.txt", "scene", text, path.name)
    configuration = root / "configuration.cfg"
    if configuration.exists():
        expect(True, "configuration", decoded(configuration), configuration.name)
    for path in sorted(HERE.glob("*.md")):
        for label, text, codes in examples(path):
            counted["examples"] += 1
            expect(True, "text", text, label)
            if codes is not None and (codes & ALWAYS or not codes & SOMETIMES):
                expect(not codes & ALWAYS, "scene", text, label)
    return problems, counted


def main():
    try:
        rules = read_grammar((HERE / "grammar.abnf").read_text(encoding="utf-8"))
    except GrammarError as problem:
        print(problem, file=sys.stderr)
        return 1
    problems = check_grammar(rules)
    counted = {}
    if not problems:
        problems, counted = check_files(rules)
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"{len(rules)} rules; " + ", ".join(f"{n} {what}" for what, n in counted.items()) + f"; {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
