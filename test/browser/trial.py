"""What a test has at hand: scenes in folders of their own, the program, the page, and what the other commands say."""

import contextlib
import tempfile
from pathlib import Path

import png
from page import Page
from program import Failure, Program, rendered


class Trial:
    """A test's folder, browser and program. What it starts ends with it."""

    def __init__(self, dioptre, browser, folder, ends):
        self.dioptre, self.browser, self.folder, self.ends = dioptre, browser, folder, ends
        self.note = ""
        self.expected_errors = []

    def scene(self, text, name="scene.txt"):
        """A scene's file with that text, alone in a folder."""
        folder = Path(tempfile.mkdtemp(dir=self.folder))
        path = folder / name
        path.write_text(text)
        return path

    def view(self, path, *options, language="en"):
        """`dioptre view` of a scene's file."""
        return self.ends.enter_context(Program(self.dioptre, "view", path.name, "--no-browser", "--language", language, *options, folder=path.parent))

    def open(self, program, script=""):
        """The program's page, in which a script runs before its own."""
        return Page(self.browser, program.address, script)

    def rendered(self, text, *options):
        """The pixels that `dioptre render` draws of a text."""
        return png.pixels(rendered(self.dioptre, self.scene(text), *options))

    def expect_errors(self, pattern):
        """Errors on the browser's console that the test is about."""
        self.expected_errors.append(pattern)


@contextlib.contextmanager
def trying(dioptre, browser):
    """What a test has at hand. Whatever happens, what it started is ended."""
    with tempfile.TemporaryDirectory(prefix="dioptre-browser-test-") as folder, contextlib.ExitStack() as ends:
        trial = Trial(dioptre, browser, folder, ends)
        try:
            yield trial
        finally:
            # Before their programs end, for which pages would look.
            browser.close_tabs()


def same(found, expected, what):
    if found != expected:
        raise Failure(f"{what}: {shortened(found)} instead of {shortened(expected)}")


def holds(condition, what):
    if not condition:
        raise Failure(what)


def shortened(value):
    text = repr(value)
    return text if len(text) <= 200 else f"{text[:200]}..."
