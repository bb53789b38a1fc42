"""Running programs and measuring them: whole processes, one processor unless more are asked for, in turn, medians."""

import os
import re
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent


class Missing(Exception):
    """A program that a benchmark needs and that is not here."""


class Fault(Exception):
    """A benchmark that cannot go on: a program that failed, or results that do not agree."""


# The programs


def find_dioptre():
    path = os.environ.get("DIOPTRE")
    if not path:
        if not shutil.which("stack"):
            raise Missing("there is no stack to ask for the program; set DIOPTRE to its path")
        asked = subprocess.run(
            ["stack", "path", "--local-install-root"], cwd=HERE.parent, capture_output=True, text=True, check=False
        )
        path = f"{asked.stdout.strip()}/bin/dioptre"
    if not os.access(path, os.X_OK):
        raise Missing(f"{path}: no program here; run `stack build` first, or set DIOPTRE")
    return os.path.abspath(path)


def find(program, package):
    path = shutil.which(program)
    if not path:
        raise Missing(f"{program} is needed (Debian: apt install {package})")
    return path


def dioptre_command(scene, output, *options, threads=1):
    return [find_dioptre(), "render", str(scene), "-o", str(output), "--threads", str(threads), "--language", "en", *map(str, options)]


def povray_command(scene, output, width, height):
    return [find("povray", "povray"), "-D", "-A", "+FN8", "+WT1", "File_Gamma=1", "All_Console=Off",
            f"+W{width}", f"+H{height}", f"+L{Path(scene).parent}", f"+I{scene}", f"+O{output}"]  # fmt: skip


# What Dioptre says of its own work

SAID = re.compile(
    r"(?P<rays>\d+) rays?, (?P<tests>\d+) intersection tests?[^;]*; reading (?P<reading>[\d.]+) s"
    r"(?:, indexing (?P<indexing>[\d.]+) s)?, tracing (?P<tracing>[\d.]+) s"
)


def dioptre_says(messages):
    """The numbers of Dioptre's last line. There is no time of indexing where nothing is indexed."""
    found = SAID.search(messages)
    if not found:
        raise Fault(f"Dioptre's line of statistics was not found in:\n{messages}")
    return {key: float(value or 0) for key, value in found.groupdict().items()}


def dioptres_say(messages):
    """The means of the same, of several programs."""
    said = [dioptre_says(found.group(0)) for found in SAID.finditer(messages)]
    if len(said) < 2:
        raise Fault(f"Dioptre's lines of statistics were not found in:\n{messages}")
    return {key: statistics.mean(numbers[key] for numbers in said) for key in said[0]}


# Measuring


def measured(command, where, says=None, processors=1):
    """Wall and processor seconds and MB of one run of a program on so many processors, and what `says` reads in its messages.

    What Linux calls the most resident memory of a process includes what it had before it became the program, as a copy
    of this one. So nothing large may happen here.
    """
    here = sorted(os.sched_getaffinity(0))
    if processors > len(here):
        raise Missing(f"{processors} processors are needed, and there is {len(here)}")
    with open(where / "messages", "wb") as messages:
        start = time.monotonic()
        child = subprocess.Popen(
            command, cwd=where, stdin=subprocess.DEVNULL, stdout=messages, stderr=messages,
            preexec_fn=lambda: os.sched_setaffinity(0, here[:processors]),
        )  # fmt: skip
        _, status, used = os.wait4(child.pid, 0)
        wall = time.monotonic() - start
        child.returncode = os.waitstatus_to_exitcode(status)
    said = (where / "messages").read_text(errors="replace")
    if child.returncode != 0:
        raise Fault(f"{' '.join(map(str, command))}: exit code {child.returncode}\n{said}")
    numbers = {"wall": wall, "processor": used.ru_utime + used.ru_stime, "memory": used.ru_maxrss / 1024}
    return {**numbers, **(says(said) if says else {})}


def in_turn(runs, rounds, where, processors=1):
    """The medians of each command's runs, A B A B ... `runs` are pairs of a command and what reads its messages."""
    results = [[] for _ in runs]
    for _ in range(rounds):
        for (command, says), its_results in zip(runs, results):
            its_results.append(measured(command, where, says, processors))
    return [{key: statistics.median(result[key] for result in its_results) for key in its_results[0]} for its_results in results]


def rounded(ratio):
    """Two digits: more would be noise."""
    return float(f"{ratio:.2g}")


def say(text):
    print(text, file=sys.stdout, flush=True)
