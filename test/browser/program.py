"""Dioptre as a process: started, listened to, interrupted, measured and always ended."""

import json
import os
import queue
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

LIMIT = 60
"""Nothing is waited for longer than this, in seconds."""

PROJECT = Path(__file__).resolve().parents[2]


class Missing(Exception):
    """A program that is needed and that is not here."""


class Failure(Exception):
    """What a test expected and did not find."""


def until(condition, what, limit=LIMIT):
    """The first result of a condition that is not false. `what` says what is waited for, or is a function that says it."""
    end = time.monotonic() + limit
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > end:
            raise Failure(f"waited {limit} s: {what() if callable(what) else what}")
        time.sleep(0.02)


def find_dioptre():
    """The program that `stack build` left, or $DIOPTRE."""
    path = os.environ.get("DIOPTRE")
    if not path:
        if not shutil.which("stack"):
            raise Missing("there is no stack to ask for the program; name it with --dioptre")
        asked = subprocess.run(["stack", "path", "--local-install-root"], cwd=PROJECT, capture_output=True, text=True, check=False)
        path = f"{asked.stdout.strip()}/bin/dioptre"
    if not os.access(path, os.X_OK):
        raise Missing(f"{path}: no program here; run `stack build` first, or name it with --dioptre")
    return os.path.abspath(path)


# No browser of the user's own is opened, whatever screen there is.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}


def ask(dioptre, *arguments, folder=None, codes=(0,)):
    """What the program prints on its standard output for a command that ends by itself."""
    done = subprocess.run(
        [dioptre, *map(str, arguments)], cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL, capture_output=True, timeout=LIMIT, check=False
    )  # fmt: skip
    if done.returncode not in codes:
        raise Failure(f"dioptre {' '.join(map(str, arguments))}: exit code {done.returncode}: {done.stderr.decode(errors='replace')}")
    return done.stdout.decode()


def rendered(dioptre, scene, *options):
    """The bytes of the file that `dioptre render` writes. Whatever is wrong with the scene, it is drawn."""
    with tempfile.TemporaryDirectory(prefix="dioptre-browser-render-") as folder:
        output = Path(folder) / "picture.png"
        ask(dioptre, "render", scene, "-o", output, "--quiet", *options)
        return output.read_bytes()


def explained(dioptre, scene, column, row):
    """The story of a pixel as `dioptre explain` tells it."""
    return json.loads(ask(dioptre, "explain", scene, column, row, "--format", "json"))


def checked(dioptre, scene, language="en"):
    """What `dioptre check` finds wrong."""
    return json.loads(ask(dioptre, "check", scene, "--format", "json", "--language", language, codes=(0, 1)))["diagnostics"]


class Program:
    """Dioptre with a page: `dioptre view`, or `dioptre` in a folder with a configuration. Leaving the context ends it."""

    def __init__(self, dioptre, *arguments, folder, environment=ENVIRONMENT):
        self.messages = tempfile.TemporaryFile()
        # Where Ctrl-C is ignored here, as in a shell's background, it is not ignored there.
        self.process = subprocess.Popen(
            [dioptre, *map(str, arguments)], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self.messages,
            start_new_session=True, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )  # fmt: skip
        self.lines = queue.Queue()
        self.listener = threading.Thread(target=self._listen, daemon=True)
        self.listener.start()

    def __enter__(self):
        try:
            self.address = self.line()
            parts = re.fullmatch(r"(http://127\.0\.0\.1:(\d+)/)#token=([0-9a-f]{32})", self.address)
            if not parts:
                raise Failure(f"this is no address with a token: {self.address!r}")
        except BaseException:
            self.close()
            raise
        self.site, self.port, self.token = parts[1], int(parts[2]), parts[3]
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.listener.join()
        self.process.stdout.close()
        self.messages.close()

    def _listen(self):
        for line in self.process.stdout:
            self.lines.put(line.decode().rstrip("\n"))
        self.lines.put(None)

    def line(self):
        """The next line on its standard output."""
        try:
            line = self.lines.get(timeout=LIMIT)
        except queue.Empty:
            line = None
        if line is None:
            self.messages.seek(0)
            raise Failure(f"the program printed no further line; it said: {self.messages.read().decode(errors='replace')}")
        return line

    @property
    def is_running(self):
        return self.process.poll() is None

    def ended(self):
        """Waits for its end; its exit code, negative for a signal."""
        try:
            return self.process.wait(LIMIT)
        except subprocess.TimeoutExpired:
            raise Failure(f"waited {LIMIT} s: the program ends") from None

    def interrupt(self):
        """Presses Ctrl-C; the seconds until its end."""
        start = time.monotonic()
        self.process.send_signal(signal.SIGINT)
        self.ended()
        return time.monotonic() - start

    def processor_seconds(self):
        """How long processors have worked for it."""
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
