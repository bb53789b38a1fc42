#!/usr/bin/env python3
"""Checks the form of the specification and of the conformance suite: python3 conformance/check.py [--counts] [FOLDER]

Every vector file is valid by schema/vectors.schema.json; it is called as its operation is; names of cases are unique and begin with the operation; their rules are in spec/;
the files that they name are there; every rule of spec/ has an example. With --counts there are enough cases as well: at least 20 for each operation, 3 for each rule that any
case names, 1500 in all.

Prints what is wrong, with its place, and what there is; exit code 1 if anything is wrong. Python 3.9, standard library only.
"""

import argparse
import collections
import json
import os
import re
import sys

sys.dont_write_bytecode = True

import run  # noqa: E402

LEAST_FOR_OPERATION, LEAST_FOR_RULE, LEAST = 20, 3, 1500


def validate(schema, value, root, place):
    """What is wrong with a value by the part of JSON Schema that ours uses."""
    if "$ref" in schema:
        target = root
        for name in schema["$ref"].lstrip("#/").split("/"):
            target = target[name]
        yield from validate(target, value, root, place)
        return
    kinds = {"object": dict, "array": list, "string": str}
    if "type" in schema and not isinstance(value, kinds[schema["type"]]):
        yield f"{place}: this is not of type {schema['type']}"
        return
    if "enum" in schema and value not in schema["enum"]:
        yield f"{place}: {value!r} is not one of {', '.join(schema['enum'])}"
    if "anyOf" in schema and all(any(validate(one, value, root, place)) for one in schema["anyOf"]):
        yield f"{place}: {value!r} has none of the forms that it may have"
    if isinstance(value, str):
        if len(value) < schema.get("minLength", 0):
            yield f"{place}: this is empty"
        if "pattern" in schema and not re.search(schema["pattern"].replace("$", r"\Z"), value):
            yield f"{place}: {value!r} does not have the form {schema['pattern']}"
    if isinstance(value, list):
        if len(value) < schema.get("minItems", 0):
            yield f"{place}: there are too few"
        if schema.get("uniqueItems") and len({json.dumps(item) for item in value}) < len(value):
            yield f"{place}: something stands here twice"
        for i, item in enumerate(value):
            yield from validate(schema.get("items", {}), item, root, f"{place}[{i}]")
    if isinstance(value, dict):
        for name in schema.get("required", []):
            if name not in value:
                yield f"{place}: '{name}' is missing"
        known, others = schema.get("properties", {}), schema.get("additionalProperties", True)
        for name, inner in value.items():
            if name in known:
                yield from validate(known[name], inner, root, f"{place}.{name}")
            elif others is False:
                yield f"{place}: nothing is called '{name}' here"
            elif isinstance(others, dict):
                yield from validate(others, inner, root, f"{place}.{name}")


def duplicates(pairs):
    """An object of a JSON file, in which no name may stand twice."""
    names = [name for name, _ in pairs]
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f"the name '{name}' stands twice in one object")
    return dict(pairs)


def files_of(case):
    return [part["file"] for part in (case.get("in"), case.get("ok")) if isinstance(part, dict) and "file" in part]


def check_vectors(folder, labels):
    """What is wrong with the vector files of a folder, and their cases."""
    faults, cases = [], []
    with open(os.path.join(folder, "schema", "vectors.schema.json"), encoding="utf-8") as file:
        schema = json.load(file)
    vectors, pictures = os.path.join(folder, "vectors"), os.path.join(folder, "pictures")
    names = sorted(os.listdir(vectors)) if os.path.isdir(vectors) else []
    seen, named = {}, set()
    for name in names:
        path = os.path.join(vectors, name)
        try:
            with open(path, encoding="utf-8") as file:
                whole = json.load(file, object_pairs_hook=duplicates, parse_constant=lambda constant: float("nan"))
        except ValueError as error:
            faults.append(f"{path}: {error}")
            continue
        wrong = list(validate(schema, whole, schema, "$"))
        faults += [f"{path}: {fault}" for fault in wrong]
        if wrong:
            continue
        operation = whole["operation"]
        if name != operation + ".json":
            faults.append(f"{path}: the operation of this file is {operation}")
        if run.PROFILE_OF.get(operation) != whole["profile"]:
            faults.append(f"{path}: there is no operation {operation} in the profile {whole['profile']}")
        for case in whole["cases"]:
            place = f"{path}: {case['id']}"
            if not case["id"].startswith(operation + "/"):
                faults.append(f"{place}: the name does not begin with {operation}/")
            if case["id"] in seen:
                faults.append(f"{place}: there is another case of this name in {seen[case['id']]}")
            seen[case["id"]] = path
            faults += [f"{place}: there is no rule {rule} in the specification" for rule in case["rules"] if labels and rule not in labels]
            for file in files_of(case):
                named.add(file)
                if os.path.basename(file) != file or not os.path.isfile(os.path.join(pictures, file)):
                    faults.append(f"{place}: there is no file {file} among the pictures")
            cases.append({**case, "operation": operation})
        try:
            run.read_vectors(path, pictures)
        except run.Fault as fault:
            faults.append(str(fault))
    if os.path.isdir(pictures):
        faults += [f"{os.path.join(pictures, file)}: no case names this file" for file in sorted(os.listdir(pictures)) if file not in named]
    return faults, cases


def check_counts(cases):
    by_operation = collections.Counter(case["operation"] for case in cases)
    by_rule = collections.Counter(rule for case in cases for rule in case["rules"])
    faults = [f"{operation}: {by_operation[operation]} cases, {LEAST_FOR_OPERATION} are wanted" for operation in run.PROFILE_OF if by_operation[operation] < LEAST_FOR_OPERATION]
    faults += [f"{rule}: {count} cases, {LEAST_FOR_RULE} are wanted" for rule, count in sorted(by_rule.items()) if count < LEAST_FOR_RULE]
    return faults + ([f"{len(cases)} cases in all, {LEAST} are wanted"] if len(cases) < LEAST else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--counts", action="store_true", help="ask for enough cases, too")
    parser.add_argument("folder", nargs="?", default=os.path.dirname(os.path.abspath(__file__)), metavar="FOLDER")
    options = parser.parse_args()
    faults, rules = [], []
    specification = os.path.join(os.path.dirname(os.path.abspath(options.folder)), "spec")
    if os.path.isdir(specification):
        try:
            rules = run.read_specification(specification)
        except run.Fault as fault:
            faults.append(str(fault))
    wrong, cases = check_vectors(options.folder, {rule["label"] for rule in rules})
    faults += wrong + (check_counts(cases) if options.counts else [])
    for fault in faults:
        print(fault)
    examples = sum(len(rule["cases"]) for rule in rules)
    print(f"{len(rules)} rules with {examples} examples, {len(cases)} cases, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8", errors="backslashreplace")
    sys.exit(main())
