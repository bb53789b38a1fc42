"""The viewer's page in a real browser: Chromium without a window, driven through chromedriver."""

import base64
import math
import os
import re
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path

from program import Failure, Missing, until
from selenium import webdriver
from selenium.webdriver.chromium.remote_connection import ChromiumRemoteConnection
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.action_builder import ActionBuilder
from selenium.webdriver.common.by import By

# Notes when each picture was finished, by the number of its rendering, and when something was typed last.
WATCH = """
    window.finishedAt = {};
    const note = () => { if (document.body.dataset.render) finishedAt[document.body.dataset.render] ??= Date.now(); };
    new MutationObserver(note).observe(document.body, { attributes: true, attributeFilter: ["data-render"] });
    note();
    document.getElementById("editor").addEventListener("input", () => { window.typedAt = Date.now(); });
"""


class Browser:
    """A Chromium with a tab that stays empty, so that pages can be closed. Leaving the context ends it and all of its processes."""

    def __init__(self):
        self.chromium = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
        self.chromedriver = shutil.which("chromedriver")
        if not self.chromium or not self.chromedriver:
            raise Missing("Chromium and its chromedriver are needed (Debian: apt install chromium chromium-driver)")

    def __enter__(self):
        self.folder = tempfile.mkdtemp(prefix="dioptre-browser-")
        self.downloads = Path(self.folder) / "downloads"
        self.downloads.mkdir()
        self.console = []
        self.process = None
        try:
            # A session of its own: what it starts stays in its group, and ends with it.
            self.process = subprocess.Popen(
                [self.chromedriver, "--port=0"], env={**os.environ, "HOME": self.folder, "LANGUAGE": "en"}, stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True, text=True,
            )  # fmt: skip
            self.driver = webdriver.Remote(ChromiumRemoteConnection(f"http://127.0.0.1:{self._port()}", "goog", "chrome", ignore_proxy=True), options=self._options())
        except BaseException:
            self.__exit__()
            raise
        self.empty_tab = self.driver.current_window_handle
        return self

    def __exit__(self, *_):
        if self.process:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self.process.wait()
            self.process.stdout.close()
            until(self._is_gone, "Chromium ends", 10)
        shutil.rmtree(self.folder, ignore_errors=True)

    def _is_gone(self):
        try:
            os.killpg(self.process.pid, 0)
        except ProcessLookupError:
            return True
        # What is left may be dead, and only waits for somebody to ask.
        states = (path.read_text().rpartition(")")[2].split() for path in Path("/proc").glob("[0-9]*/stat") if path.exists())
        return not any(int(fields[2]) == self.process.pid and fields[0] != "Z" for fields in states)

    def _port(self):
        for line in self.process.stdout:
            found = re.search(r"started successfully on port (\d+)", line)
            if found:
                return int(found[1])
        raise Failure("chromedriver does not start")

    def _options(self):
        options = webdriver.ChromeOptions()
        options.binary_location = self.chromium
        arguments = ["headless=new", "no-sandbox", "disable-gpu", "disable-dev-shm-usage", "no-first-run", "no-proxy-server", "disable-background-networking",
                     "disable-component-update", "lang=en-US", "host-resolver-rules=MAP *.example 127.0.0.1", f"user-data-dir={self.folder}/profile"]  # fmt: skip
        for argument in arguments:
            options.add_argument(f"--{argument}")
        options.add_experimental_option("prefs", {"download.default_directory": str(self.downloads), "intl.accept_languages": "en-US"})
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        options.set_capability("unhandledPromptBehavior", "accept")
        return options

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def run_until_told(self, script, *arguments):
        """A script that calls its last argument with its result."""
        return self.driver.execute_async_script(script, *arguments)

    def tab(self, address, script=""):
        """Opens an address in a tab of its own, of 1280 by 800 pixels. A script runs before the page's own."""
        self.driver.switch_to.new_window("tab")
        self.driver.set_script_timeout(60)
        self.device("Emulation.setDeviceMetricsOverride", width=1280, height=800, deviceScaleFactor=1, mobile=False)
        self.device("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "light"}])
        if script:
            self.device("Page.addScriptToEvaluateOnNewDocument", source=script)
        self.driver.get(address)
        return self.driver.current_window_handle

    def device(self, command, **parameters):
        return self.driver.execute("executeCdpCommand", {"cmd": command, "params": parameters})["value"]

    def errors(self):
        """The errors that pages have logged since the last time."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def close_tabs(self):
        """Closes all but the empty one."""
        for handle in self.driver.window_handles:
            if handle != self.empty_tab:
                self.driver.switch_to.window(handle)
                self.driver.close()
        self.driver.switch_to.window(self.empty_tab)


class Page:
    """The viewer's page in a tab."""

    def __init__(self, browser, address, script=""):
        self.browser = browser
        self.driver = browser.driver
        self.handle = browser.tab(address, script)
        self.read(WATCH + "return true")

    def close(self):
        self.driver.switch_to.window(self.handle)
        self.driver.close()
        self.driver.switch_to.window(self.browser.empty_tab)

    def read(self, script, *arguments):
        return self.browser.run(script, *arguments)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    # What it shows

    @property
    def state(self):
        return self.read("return document.body.dataset.state")

    @property
    def render(self):
        """The number of the rendering that is wholly shown; None while there is none."""
        return self.read("return document.body.dataset.render ?? null")

    @property
    def language(self):
        return self.read("return document.documentElement.lang")

    @property
    def typed(self):
        """The text in the editor."""
        return self.read("return document.getElementById('editor').value")

    @property
    def scale(self):
        """How large a pixel of the picture is seen."""
        return self.read("const canvas = document.getElementById('picture'); return canvas.getBoundingClientRect().width / canvas.width")

    def text(self, identifier):
        return self.read("return document.getElementById(arguments[0]).textContent", identifier)

    def is_seen(self, identifier):
        return self.read("const one = document.getElementById(arguments[0]); return one.checkVisibility() && one.getClientRects().length > 0", identifier)

    def told(self):
        """What a failure says about it."""
        return f"{self.state}, rendering {self.render}: {self.text('status')} {self.text('notice-text')}"

    def picture(self):
        """Width, height and bytes of the picture on the canvas, as `png.pixels` has them."""
        width, height, data = self.read(
            """
            const canvas = document.getElementById("picture");
            const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
            const parts = [];
            for (let k = 0; k < data.length; k += 8192) parts.push(String.fromCharCode(...data.subarray(k, k + 8192)));
            return [canvas.width, canvas.height, btoa(parts.join(""))];
            """
        )
        return width, height, base64.b64decode(data)

    def diagnostics(self):
        """The list of what is wrong: what each entry is about, and its text."""
        return self.read("return [...document.querySelectorAll('#diagnostics > li')].map((li) => ({ ...li.dataset, text: li.textContent }))")

    def marks(self):
        """The lines that are marked in the editor: number, words that are underlined, how far below the first line the mark stands, and how high a line is."""
        return self.read(
            """
            const area = document.getElementById("editor");
            const style = getComputedStyle(area);
            const first = area.getBoundingClientRect().top + parseFloat(style.paddingTop) - area.scrollTop;
            return [...document.querySelectorAll("#marks .faulty")].map((mark) => [
              Number(mark.dataset.line),
              [...mark.querySelectorAll(".underlined")].map((word) => word.textContent),
              mark.getBoundingClientRect().top - first,
              parseFloat(style.lineHeight),
            ]);
            """
        )

    @property
    def selected(self):
        """What is selected in the area that has the keyboard."""
        return self.read("const { value, selectionStart, selectionEnd } = document.activeElement; return value.slice(selectionStart, selectionEnd)")

    # Waiting

    def wait(self, condition, what, limit=60):
        """Waits for a condition of this page."""
        return until(condition, lambda: f"{what}; the page: {self.told()}", limit)

    def wait_for_state(self, *states):
        self.wait(lambda: self.state in states, f"the page is {' or '.join(states)}")

    def wait_for_picture(self, expected):
        """Waits until the picture is wholly there, and has the expected pixels."""
        self.wait(lambda: self.render is not None and self.state == "done" and self.picture() == expected, "the expected picture is there")

    def finished_at(self):
        """When the picture that is shown was finished, in seconds since 1970."""
        return self.read("return finishedAt[document.body.dataset.render]") / 1000

    def seconds_since_typing(self):
        """How long after the last letter was typed the picture that is shown was finished."""
        return self.finished_at() - self.read("return typedAt") / 1000

    def seconds_of_rest(self):
        """How long ago the last letter was typed."""
        return self.read("return Date.now() - typedAt") / 1000

    # What is done with it

    def press(self, *keys):
        """Presses keys, one after the other. A tuple is pressed together."""
        actions = ActionChains(self.driver)
        for key in keys:
            *held, last = key if isinstance(key, tuple) else (key,)
            for one in held:
                actions.key_down(one)
            actions.send_keys(last)
            for one in held:
                actions.key_up(one)
        actions.perform()

    def type_over(self, old, new):
        """Selects a part of the text that stands there once, and types another instead."""
        count = self.read(
            """
            const [editor, old] = [document.getElementById("editor"), arguments[0]];
            const start = editor.value.indexOf(old);
            editor.focus();
            editor.setSelectionRange(start, start + old.length);
            return editor.value.split(old).length - 1;
            """,
            old,
        )
        if count != 1:
            raise Failure(f"{old!r} stands {count} times in the editor")
        self.press(*new)

    def click(self, selector):
        self.find(selector).click()

    def click_pixel(self, column, row):
        """Clicks on a pixel of the picture."""
        scale = self.scale
        if scale < 1:
            raise Failure(f"at a scale of {scale} not every pixel can be clicked on")
        left, top = self.read("const { left, top } = document.getElementById('picture').getBoundingClientRect(); return [left, top]")
        actions = ActionBuilder(self.driver)
        actions.pointer_action.move_to_location(math.ceil(left + column * scale), math.ceil(top + row * scale))
        actions.pointer_action.click()
        actions.perform()

    def choose(self, selector, value):
        """Chooses an option."""
        self.find(f"{selector} option[value={value}]").click()

    # Stories

    def wait_for_story(self, column, row):
        """Waits for the story of a pixel."""
        self.wait(
            lambda: self.read(
                """
                const { dataset, hidden, classList } = document.getElementById("story");
                return !hidden && !classList.contains("waiting") && Number(dataset.column) === arguments[0] && Number(dataset.row) === arguments[1];
                """,
                column,
                row,
            ),
            f"the story of pixel {column}, {row} is told",
        )

    def unfold_story(self):
        """Opens every fold of the story. What is in a fold comes when it is opened."""
        self.wait(
            lambda: self.read(
                """
                const folds = [...document.querySelectorAll("#story details")];
                for (const one of folds) one.open = true;
                return folds.every((one) => one.childElementCount > 1);
                """
            ),
            "the story has no more folds to open",
        )

    def told_pixel(self):
        """The four bytes that the story begins with."""
        return [int(byte) for byte in re.findall(r"\d+", self.read("return document.querySelector('#story .answer strong').textContent"))]

    def told_roots(self):
        """The roots that the story lists, each with what became of it."""
        return self.read("return [...document.querySelectorAll('#story .root')].map(({ dataset }) => [Number(dataset.t), dataset.fate])")

    def drawn_rays(self):
        """The rays over the picture: name, whether something is hit, and where that is seen, in pixels of the picture."""
        return self.read(
            """
            return [...document.querySelectorAll("#overlay [data-ray]")].map((ray) => {
              const hit = ray.querySelector(":scope > .hit");
              return [ray.dataset.ray, ray.dataset.hit === "true", hit && [hit.getAttribute("cx") / arguments[0], hit.getAttribute("cy") / arguments[0]]];
            });
            """,
            self.scale,
        )
