#!/usr/bin/env python3
"""Writes all vector files of the conformance suite anew: python3 conformance/generators/generate.py [--check]

With --check nothing is written; the exit code is 1 if a file is not what the generators make.
"""

import sys

sys.dont_write_bytecode = True

import importlib  # noqa: E402
import os  # noqa: E402

import suite  # noqa: E402

if __name__ == "__main__":
    names = sorted(name[:-3] for name in os.listdir(os.path.dirname(os.path.abspath(__file__))) if name.endswith(".py"))
    modules = [importlib.import_module(name) for name in names if name not in ("generate", "suite")]
    generators = [module for module in modules if hasattr(module, "operations")]
    suite.main(*sorted(generators, key=lambda module: getattr(module, "LAST", False)))
