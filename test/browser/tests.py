"""The tests. Each does on the page what a user does, and compares what is seen with what the other commands say. Its name says what holds."""

import http.server
import os
import re
import socket
import tempfile
import threading
import time
from pathlib import Path

import png
from page import Page
from program import ENVIRONMENT, PROJECT, Program, checked, explained, rendered, until
from selenium.webdriver.common.keys import Keys
from trial import holds, same

TESTS = []


def test(function):
    """Puts a test on the list."""
    TESTS.append(function)
    return function


SCENE = """camera
  position [-5.0, 0.0, 2.0]
  look_at  [0.0, 0.0, 0.0]
  up       [0.0, 0.0, 1.0]
end

viewport
  width  160 pixels
  height 120 pixels
  image_file_name ball
end

raytracer
  sampling 1
  recursive_level 3
end

primitive
  material_name paint
  sphere
    position [0.0, 0.0, 0.0]
    ray      1.7
  end
end

primitive
  material_name floor
  plane
    position [0.0, 0.0, -1.7]
    normal   [0.0, 0.0, 1.0]
  end
end

material
  name  paint
  color red
  kr    0.3
end

material
  name  floor
  color 0.6 0.7 0.8
end

ambient_light
end

point_light
  position [-5.0, 3.0, 5.0]
end
"""

# What the tests type over what stands there once.
RAY, WIDER, FAULTY = "ray      1.7", "ray      2.2", "rey      1.7"

# So many rays that nobody waits for the end.
SLOW = SCENE.replace("width  160", "width  400").replace("height 120", "height 300").replace("sampling 1\n", "sampling 8000\n")


def rays_of(ray):
    """A ray of a story and all that come from it, depth first."""
    yield ray
    for bounce in (ray.get("hit") or {}).get("bounces", []):
        if "ray" in bounce:
            yield from rays_of(bounce["ray"])


# ---------------------------------------------------------------------------
# The picture


@test
def the_render_appears_pixel_for_pixel_as_render_writes_it(trial):
    path = trial.scene((PROJECT / "scenes" / "torus.txt").read_text())
    file = rendered(trial.dioptre, path)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    same(page.picture(), png.pixels(file), "the pixels on the canvas")
    same(page.diagnostics(), [], "what is wrong with the scene")
    holds(re.search(r"Drawn in [\d.,]+ s: [\d,]+ rays", page.text("status")), f"the page does not tell of the rays: {page.text('status')}")


@test
def the_picture_is_downloaded_as_the_file_that_render_writes(trial):
    path = trial.scene(SCENE)
    file = rendered(trial.dioptre, path)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    page.click("#download")
    downloaded = trial.browser.downloads / "ball.png"
    page.wait(lambda: downloaded.exists() and downloaded.stat().st_size >= len(file), "the picture is downloaded")
    same(downloaded.read_bytes(), file, "the bytes of the downloaded file")


@test
def a_slow_picture_shows_coarse_blocks_first_and_how_far_it_is(trial):
    path = trial.scene(SLOW)
    page = trial.open(trial.view(path))
    # The last strip of blocks, while the rows there are far away.
    blocks = """
        const canvas = document.getElementById("picture");
        const block = 8, row = canvas.height - canvas.height % block - block;
        if (row < 0) return null;
        const { data } = canvas.getContext("2d").getImageData(0, row, canvas.width, block);
        const at = (x, y) => [...data.subarray(4 * (y * canvas.width + x), 4 * (y * canvas.width + x) + 4)];
        const corners = [];
        for (let x = 0; x < canvas.width; x += block) {
          corners.push(at(x, 0));
          for (let k = 0; k < block * block; k++) if (at(x + k % block, Math.floor(k / block)).join() !== corners.at(-1).join()) return null;
        }
        return corners.every((one) => one[3] === 255) ? { row, corners } : null;
    """
    found = page.wait(lambda: page.read(blocks), "there are coarse blocks")
    same(page.state, "drawing", "the state meanwhile")
    same(page.render, None, "the finished picture meanwhile")
    holds(any(corner[:3] != [0, 0, 0] for corner in found["corners"]), "all blocks are black")
    # A block has the colour of its middle, with all its samples.
    column = 5
    _, _, middle = png.pixels(rendered(trial.dioptre, path, "--crop", 8 * column + 4, found["row"] + 4, 1, 1))
    same(found["corners"][column], list(middle), "a block's colour")
    page.wait(lambda: page.read("const { hidden, value, max } = document.getElementById('progress'); return !hidden && 0 < value && value < max"), "progress is shown")
    holds(page.text("status").startswith("Drawing for "), f"the page does not tell how long it has been drawing: {page.text('status')}")


# ---------------------------------------------------------------------------
# Edits


@test
def an_edit_on_the_page_changes_the_picture(trial):
    page = trial.open(trial.view(trial.scene(SCENE)))
    page.wait_for_picture(trial.rendered(SCENE))
    page.type_over(RAY, WIDER)
    page.wait_for_picture(trial.rendered(SCENE.replace(RAY, WIDER)))
    trial.note = f"{page.seconds_since_typing():.2f} s after the last letter"


@test
def an_edit_of_the_file_from_outside_changes_picture_and_text(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_picture(trial.rendered(SCENE))
    wider = SCENE.replace(RAY, WIDER)
    start = time.time()
    path.write_text(wider)
    page.wait_for_picture(trial.rendered(wider))
    trial.note = f"{page.finished_at() - start:.2f} s after it was written"
    same(page.typed, wider, "the text in the editor")
    same(page.text("saved"), "saved", "what the page says of the file")
    # Other editors write beside the file, and put that in its place.
    beside = path.with_name("scene.txt.new")
    beside.write_text(SCENE)
    os.replace(beside, path)
    page.wait_for_picture(trial.rendered(SCENE))
    same(page.typed, SCENE, "the text in the editor")


@test
def a_texture_that_comes_or_is_saved_changes_the_picture(trial):
    path = trial.scene(SCENE.replace("material\n  name  paint\n", "texture_material\n  name  paint\n  texture_kd skin.png\n"))
    skin = path.with_name("skin.png")
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    same([one["code"] for one in page.diagnostics()], [one["code"] for one in checked(trial.dioptre, path)], "what is wrong while there is no texture")
    holds(page.diagnostics(), "nothing is wrong while there is no texture")
    before = page.picture()
    for text in (SCENE, SCENE.replace(RAY, WIDER)):
        texture = rendered(trial.dioptre, trial.scene(text))
        start = time.time()
        skin.write_bytes(texture)
        expected = png.pixels(rendered(trial.dioptre, path))
        holds(expected != before, "the texture does not matter")
        page.wait_for_picture(expected)
        trial.note = f"{page.finished_at() - start:.2f} s after it was written"
        same(page.diagnostics(), [], "what is wrong")
        same((page.text("saved"), page.read("return document.body.dataset.version")), ("saved", "1"), "the text")
        before = expected


@test
def a_second_page_sees_what_is_typed_on_the_first(trial):
    program = trial.view(trial.scene(SCENE))
    second = trial.open(program)
    first = trial.open(program)
    first.wait_for_state("done")
    first.type_over(RAY, WIDER)
    wider = SCENE.replace(RAY, WIDER)
    first.wait_for_picture(trial.rendered(wider))
    first.close()
    trial.browser.driver.switch_to.window(second.handle)
    second.wait_for_picture(trial.rendered(wider))
    same(second.typed, wider, "the text in the other page's editor")


@test
def what_is_typed_is_not_overtaken_by_a_late_message(trial):
    # Every message of the program arrives half a second late, in their order.
    late = """
        const listen = WebSocket.prototype.addEventListener;
        WebSocket.prototype.addEventListener = function (kind, listener) {
          listen.call(this, kind, kind === "message" ? (event) => setTimeout(listener, 500, event) : listener);
        };
    """
    # Notes each text of the editor, and how often it has been told of the scene.
    watch = """
        window.texts = [];
        const editor = document.getElementById("editor");
        const note = () => { if (editor.value !== texts.at(-1)) texts.push(editor.value); requestAnimationFrame(note); };
        note();
        editor.addEventListener("input", note);
    """
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path), late)
    page.wait_for_picture(trial.rendered(SCENE))
    page.read(watch + "return true")
    page.type_over(RAY, "ray      1.")
    # Each is sent off on its own, and its echo comes when the next ones have been typed.
    for letter in "23456789":
        page.press(letter)
        page.wait(lambda: page.seconds_of_rest() > 0.2, "typing has rested")
    typed = SCENE.replace(RAY, "ray      1.23456789")
    page.wait_for_picture(trial.rendered(typed))
    same(page.typed, typed, "the text in the editor")
    texts = page.read("return texts")
    same(len(set(texts)), len(texts), "how many different texts there were, of all")
    # What somebody else writes meanwhile to the file is not taken over, and is not lost.
    page.press("1")
    path.write_text(SCENE + "# by somebody else\n")
    page.wait(lambda: page.is_seen("reload"), "the page offers to take the file's text")
    same(page.typed, typed.replace("1.23456789", "1.234567891"), "the text in the editor")


# ---------------------------------------------------------------------------
# Undoing


@test
def what_comes_from_the_file_can_be_undone(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_picture(trial.rendered(SCENE))
    # There was nothing before the first text.
    page.click("#editor")
    page.press((Keys.CONTROL, "z"))
    same(page.typed, SCENE, "the text in the editor")
    page.type_over("color red", "color blue")
    blue = SCENE.replace("color red", "color blue")
    page.wait_for_picture(trial.rendered(blue))
    page.press((Keys.CONTROL, "s"))
    page.wait(lambda: page.text("saved") == "saved" and path.read_text() == blue, "it is saved")
    # What looks like markup, or is beyond 16 bits, is a text like any other.
    other = blue.replace(RAY, WIDER) + '# <img src=x onerror="document.title = 1"> &amp; &lt; \U0001f534\n\n  \t\n'
    another = other.replace("\U0001f534", "\U0001f535").replace("image_file_name ball\n", "")
    # One of them with the keyboard in the editor, one with it elsewhere
    caret = blue.index("material_name floor")
    page.read("document.activeElement.setSelectionRange(arguments[0], arguments[0])", caret)
    path.write_text(other)
    page.wait_for_picture(trial.rendered(other))
    same(page.typed, other, "the text in the editor")
    same(page.read("return document.activeElement.id"), "editor", "where the keyboard is")
    same(page.read("return document.activeElement.selectionStart"), other.index("material_name floor"), "where the caret is")
    page.click("#save" if page.read("return !document.getElementById('save').disabled") else "#keys-button")
    page.press(Keys.ESCAPE)
    focus = page.read("return document.activeElement.id")
    path.write_text(another)
    page.wait(lambda: page.typed == another, "the file's text is there")
    same(page.read("return document.activeElement.id"), focus, "where the keyboard is")
    # Back, step by step, and forth; the program draws what is there.
    page.click("#editor")
    for text in (other, blue):
        page.press((Keys.CONTROL, "z"))
        same(page.typed, text, "the text that Ctrl+Z brings back")
    # What was typed is undone letter by letter or word by word, as the browser likes.
    until(lambda: page.press((Keys.CONTROL, "z")) or page.typed == SCENE, "Ctrl+Z brings back what was there before all typing", 10)
    page.wait_for_picture(trial.rendered(SCENE))
    same(page.text("saved"), "not saved", "what the page says of the file")
    until(lambda: page.press((Keys.CONTROL, Keys.SHIFT, "z")) or page.typed == blue, "Ctrl+Shift+Z brings it again", 10)
    for text in (other, another):
        page.press((Keys.CONTROL, Keys.SHIFT, "z"))
        same(page.typed, text, "the text that Ctrl+Shift+Z brings back")
    page.wait(lambda: page.text("saved") == "saved", "the page says that the file has it")


@test
def a_long_text_comes_from_the_file_and_can_be_undone(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_picture(trial.rendered(SCENE))
    long = SCENE + "".join(f"# <line {k}> of many\n" for k in range(4000))
    start = time.time()
    path.write_text(long)
    page.wait(lambda: page.read("return document.getElementById('editor').value.length") == len(long), "the long text is there")
    trial.note = f"{time.time() - start:.1f} s after it was written"
    same(page.typed, long, "the text in the editor")
    page.click("#editor")
    page.press((Keys.CONTROL, "z"))
    same(page.typed, SCENE, "the text that Ctrl+Z brings back")
    # The file changes again before the program knows what the page has. (One that would keep the page waiting is only taken over.)
    longer = SCENE + "".join(f"# <line {k}> of many\n" for k in range(40000))
    path.write_text(longer)
    page.wait(lambda: page.is_seen("reload"), "the page offers to take the file's text")
    page.click("#reload")
    page.wait(lambda: page.read("return document.getElementById('editor').value.length") == len(longer), "the longer text is there", 5)


# ---------------------------------------------------------------------------
# Faults


@test
def a_fault_is_shown_where_it_is_and_the_picture_stays(trial):
    page = trial.open(trial.view(trial.scene(SCENE)))
    good = trial.rendered(SCENE)
    faulty = SCENE.replace(RAY, FAULTY)
    page.wait_for_picture(good)
    page.type_over(RAY, FAULTY)
    line = 1 + faulty[: faulty.index(FAULTY)].count("\n")
    # While it is typed there are other faults.
    (known,) = checked(trial.dioptre, trial.scene(faulty))
    page.wait(lambda: any(known["message"] in one["text"] for one in page.diagnostics()), "the fault is listed")
    same(page.state, "faults", "the state")
    (fault,) = page.diagnostics()
    same((fault["line"], fault["code"], fault["severity"]), (str(line), "unknown-word", "error"), "the fault's line, code and severity")
    holds(known["used"] in fault["text"], f"the fault is not told as `check` tells it: {fault['text']}")
    # Its line is marked, and in it the word
    ((marked, words, top, height),) = page.marks()
    same((marked, words), (line, ["rey"]), "what is marked in the editor")
    holds(abs(top - (line - 1) * height) < 2, f"the mark stands {top} below the first line, and lines are {height} high")
    # The entry leads there
    page.click("#diagnostics > li > button")
    same(page.selected, "rey", "what is selected")
    same(page.picture(), good, "the picture")
    holds(page.is_seen("draw-anyway"), "nothing offers to draw it anyway")
    # Drawn anyway
    page.click("#draw-anyway")
    page.wait_for_picture(trial.rendered(faulty))
    same([one["code"] for one in page.diagnostics()], ["unknown-word"], "the faults that are left")
    # Mended
    page.type_over(FAULTY, RAY)
    page.wait_for_picture(good)
    same(page.diagnostics(), [], "the faults that are left")
    same(page.marks(), [], "the lines that are marked")


@test
def a_first_text_with_faults_is_drawn_with_the_defaults(trial):
    text = (PROJECT / "scenes" / "mistakes.txt").read_text()
    path = trial.scene(text)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    same(page.picture(), png.pixels(rendered(trial.dioptre, path)), "the picture")
    same([(int(one["line"]), one["code"]) for one in page.diagnostics()], [(one["line"], one["code"]) for one in checked(trial.dioptre, path)], "what is wrong")


# ---------------------------------------------------------------------------
# Stories


def the_story_is_the_one_that_explain_tells(trial, page, path, column, row):
    page.wait_for_story(column, row)
    story = explained(trial.dioptre, path, column, row)
    page.unfold_story()
    same(page.told_pixel(), story["pixel"], "the pixel")
    width, _, bytes_there = page.picture()
    same(page.told_pixel(), list(bytes_there[4 * (row * width + column) :][:4]), "the pixel, beside the picture")
    rays = [ray for sample in story["samples"] for ray in rays_of(sample["ray"])]
    roots = [[root["t"], root["fate"]] for ray in rays for encounter in ray["encounters"] for root in encounter["roots"]]
    same(sorted(page.told_roots()), sorted(roots), "the roots")
    drawn = page.drawn_rays()
    same([is_hit for _, is_hit, _ in drawn], [bool(ray.get("hit")) for ray in rays], "the rays over the picture")
    return rays, drawn


@test
def a_click_on_a_pixel_tells_the_story_that_explain_tells(trial):
    path = trial.scene((PROJECT / "scenes" / "mirror.txt").read_text())
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    column, row = 208, 170
    page.click_pixel(column, row)
    rays, drawn = the_story_is_the_one_that_explain_tells(trial, page, path, column, row)
    holds(len(rays) > 2, "the pixel's ray is not reflected")
    holds(page.is_seen("overlay") and page.read("return document.querySelectorAll('#overlay .reflection .beam').length") > 0, "no reflected ray is drawn over the picture")
    # The place where the first ray hits is seen in the middle of the pixel.
    (name, _, place) = drawn[0]
    holds(name == "1" and abs(place[0] - column - 0.5) < 0.01 and abs(place[1] - row - 0.5) < 0.01, f"the hit of the pixel's ray is drawn at {place}")
    page.click("#close-story")
    page.wait(lambda: not page.is_seen("story"), "the story is closed")
    same(page.drawn_rays(), [], "the rays over the picture")


@test
def the_keyboard_finds_a_pixel_and_its_story(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    page.click("#editor")
    page.press((Keys.CONTROL, Keys.ENTER))
    same(page.read("return document.activeElement.id"), "picture", "where the keyboard is after Ctrl+Enter")
    # The first arrow puts the cursor in the middle.
    page.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_DOWN, Keys.ARROW_LEFT, (Keys.SHIFT, Keys.ARROW_DOWN))
    page.wait(lambda: page.text("readout").startswith("column 81, row 71"), "the readout tells of the cursor")
    page.press(Keys.ENTER)
    the_story_is_the_one_that_explain_tells(trial, page, path, 81, 71)
    page.press((Keys.SHIFT, Keys.ARROW_UP), Keys.ARROW_UP, Keys.ENTER)
    the_story_is_the_one_that_explain_tells(trial, page, path, 81, 60)
    page.press(Keys.ESCAPE)
    page.wait(lambda: not page.is_seen("story"), "Escape closes the story")
    same(page.drawn_rays(), [], "the rays over the picture")
    before = page.scale
    page.press("+", "+")
    page.wait(lambda: page.scale > before, "+ comes closer")
    page.press("0")
    page.wait(lambda: page.scale == before, "0 shows the whole picture")


@test
def the_story_follows_the_text(trial):
    page = trial.open(trial.view(trial.scene(SCENE)))
    page.wait_for_state("done")
    page.click_pixel(80, 60)
    page.wait_for_story(80, 60)
    page.type_over(RAY, WIDER)
    wider = trial.scene(SCENE.replace(RAY, WIDER))
    page.wait_for_picture(trial.rendered(wider.read_text()))
    story = explained(trial.dioptre, wider, 80, 60)
    (closest,) = [encounter for encounter in story["samples"][0]["ray"]["encounters"] if encounter["verdict"] == "closest"]
    (kept,) = [root["t"] for root in closest["roots"] if root["fate"] == "kept"]
    page.wait(lambda: [kept, "kept"] in page.told_roots(), "the story is about the new picture")


@test
def the_picture_is_compared_with_the_one_before(trial):
    page = trial.open(trial.view(trial.scene(SCENE)))
    before = trial.rendered(SCENE)
    page.wait_for_picture(before)
    page.type_over(RAY, WIDER)
    after = trial.rendered(SCENE.replace(RAY, WIDER))
    page.wait_for_picture(after)
    page.choose("#compare", "difference")
    count = sum(before[2][k : k + 4] != after[2][k : k + 4] for k in range(0, len(after[2]), 4))
    holds(page.text("difference-text").startswith(f"{count:,} pixels differ"), f"{count} pixels differ, and the page says: {page.text('difference-text')}")
    page.choose("#compare", "side")
    same((page.is_seen("previous"), page.is_seen("difference")), (True, False), "what is seen side by side")


# ---------------------------------------------------------------------------
# French


@test
def with_language_fr_everything_is_in_French(trial):
    faulty = SCENE.replace(RAY, FAULTY)
    page = trial.open(trial.view(trial.scene(faulty), language="fr"))
    page.wait_for_state("done")
    (known,) = checked(trial.dioptre, trial.scene(faulty), "fr")
    in_french(page, known)


@test
def the_language_button_changes_all_words(trial):
    faulty = SCENE.replace(RAY, FAULTY)
    page = trial.open(trial.view(trial.scene(faulty)))
    page.wait_for_state("done")
    english, french = (checked(trial.dioptre, trial.scene(faulty), language)[0] for language in ("en", "fr"))
    page.click_pixel(80, 60)
    page.wait_for_story(80, 60)
    same((page.language, page.text("diagnostics-title")), ("en", "1 fault"), "language and title")
    holds(english["message"] in page.diagnostics()[0]["text"], f"the fault is not in English: {page.diagnostics()[0]['text']}")
    page.click("#language")
    page.wait(lambda: page.language == "fr", "the page is in French")
    page.wait(lambda: french["message"] in page.diagnostics()[0]["text"], "the fault is in French")
    in_french(page, french)
    page.wait(lambda: "quatre octets" in page.text("story-content") and "four bytes" not in page.text("story-content"), "the story is in French")
    page.click("#language")
    page.wait(lambda: page.language == "en" and english["message"] in page.diagnostics()[0]["text"], "the page is in English again")


def in_french(page, known):
    page.wait(lambda: page.diagnostics(), "the fault is listed")
    same((page.language, page.text("diagnostics-title"), page.text("save")), ("fr", "1 faute", "Enregistrer"), "language and words")
    holds(page.text("status").startswith("Dessinée en "), f"the status is not in French: {page.text('status')}")
    told = page.diagnostics()[0]["text"]
    holds(all(one in told for one in ("erreur", known["message"], known["used"])), f"the fault is not in French: {told}")


# ---------------------------------------------------------------------------
# Who may speak with the program

PROBE = """
    const [site, token, told] = arguments;
    const named = token === null ? "" : `token=${token}`;
    const result = async (name, attempt) => [name, await Promise.race([attempt, new Promise((late) => setTimeout(() => late("no answer"), 20000))])];
    const fetched = (path) => fetch(site + path).then((answer) => (answer.ok ? "read" : "refused"), () => "refused");
    Promise.all([
      result("socket", new Promise((done) => {
        const socket = new WebSocket(`${site.replace("http", "ws")}live?${named}`);
        socket.onopen = () => done("opened");
        socket.onerror = () => done("refused");
      })),
      result("page", fetched("")),
      result("picture", fetched(`picture.png?render=1&${named}`)),
      result("image", new Promise((done) => {
        const image = new Image();
        image.onload = () => done("read");
        image.onerror = () => done("refused");
        image.src = `${site}picture.png?render=1&${named}`;
      })),
      result("script", import(site + "words.js").then(() => "read", () => "refused")),
    ]).then((results) => told(Object.fromEntries(results)));
"""


EVERYTHING = ("socket", "page", "picture", "image", "script")


class Elsewhere(http.server.BaseHTTPRequestHandler):
    """A page of somebody else's."""

    def do_GET(self):
        body = b"<!DOCTYPE html><title>elsewhere</title><p>Good day."
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


@test
def a_page_from_elsewhere_is_refused(trial):
    program = trial.view(trial.scene(SCENE))
    page = trial.open(program)
    page.wait_for_state("done")
    # What refuses the other page does not refuse its own.
    same(trial.browser.run_until_told(PROBE, program.site, program.token), {"socket": "opened"} | dict.fromkeys(EVERYTHING[1:], "read"), "what the own page gets")
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Elsewhere)
    trial.ends.callback(server.server_close)
    trial.ends.callback(server.shutdown)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    trial.expect_errors(r"127\.0\.0\.1|localhost|ERR_BLOCKED_BY_RESPONSE|CORS|WebSocket")
    for host in ("127.0.0.1", "localhost", "evil.example"):
        trial.browser.tab(f"http://{host}:{server.server_port}/")
        same(trial.browser.run("return document.title"), "elsewhere", "the title of the page from elsewhere")
        # Not even with the token
        for token in (None, program.token):
            same(trial.browser.run_until_told(PROBE, program.site, token), dict.fromkeys(EVERYTHING, "refused"), f"what a page of {host} gets with the token {token}")


@test
def without_the_token_of_this_run_nothing_is_read_or_written(trial):
    path = trial.scene(SCENE)
    program = trial.view(path)
    page = trial.open(program)
    page.wait_for_state("done")
    same(page.read("return location.href"), program.site, "the page's address when it has taken the token")
    holds(program.token not in page.read("return document.documentElement.outerHTML.replace(/picture.png[^\"]*/, '')"), "the token is seen on the page")
    other = ("0" if program.token[0] != "0" else "1") + program.token[1:]
    trial.expect_errors(r"403|WebSocket")
    for token in (None, "", other, program.token[:-1], program.token + "0", program.token.upper() + " "):
        got = trial.browser.run_until_told(PROBE, program.site, token)
        same(got, dict.fromkeys(("socket", "picture", "image"), "refused") | dict.fromkeys(("page", "script"), "read"), f"what one gets with the token {token!r}")
    # Loaded anew, the page still has it.
    page.driver.refresh()
    page.wait_for_picture(trial.rendered(SCENE))
    same(page.typed, SCENE, "the text of the page that is loaded anew")
    # Other tabs have not, and say what is to be done.
    for address in (program.site, f"{program.site}#token={other}"):
        stranger = Page(trial.browser, address)
        stranger.wait_for_state("refused")
        holds(stranger.is_seen("notice") and "the whole address" in stranger.text("notice-text"), f"the page says: {stranger.text('notice-text')!r}")
        same((stranger.typed, stranger.text("file"), stranger.render), ("", "", None), "what the page shows")
        stranger.read("location.href = arguments[0]", program.address)
        stranger.wait_for_picture(trial.rendered(SCENE))
        holds(not stranger.is_seen("notice"), "the notice stays")
    same(path.read_text(), SCENE, "the scene's file")


@test
def another_name_for_this_machine_is_refused(trial):
    program = trial.view(trial.scene(SCENE))
    # Under the name localhost there is a page, which has no token.
    trial.expect_errors(r"evil\.example.*(403|Cross-Origin-Opener-Policy)|localhost.*403")
    trial.browser.tab(f"http://evil.example:{program.port}/")
    shown = trial.browser.run("return [performance.getEntriesByType('navigation')[0].responseStatus, document.body.textContent.trim()]")
    same(shown, [403, "this server answers only to the name 127.0.0.1 or localhost / ce serveur ne répond qu'au nom 127.0.0.1 ou localhost"], "what a browser sees under another name")
    trial.browser.tab(f"http://localhost:{program.port}/")
    same(trial.browser.run("return performance.getEntriesByType('navigation')[0].responseStatus"), 200, "what a browser sees under the name localhost")


# ---------------------------------------------------------------------------
# Work that is given up


@test
def an_edit_ends_a_slow_picture_at_once(trial):
    page = trial.open(trial.view(trial.scene(SLOW)))
    page.wait_for_state("drawing")
    page.type_over("sampling 8000", "sampling 1")
    page.wait_for_picture(trial.rendered(SLOW.replace("sampling 8000", "sampling 1")))
    trial.note = f"{page.seconds_since_typing():.2f} s after the last letter"


@test
def a_fault_in_a_slow_picture_brings_the_last_good_one_back(trial):
    program = trial.view(trial.scene(SCENE))
    page = trial.open(program)
    good = trial.rendered(SCENE)
    page.wait_for_picture(good)
    page.type_over("sampling 1\n", "sampling 10000\n")
    page.wait(lambda: page.state == "drawing" and page.picture() != good, "the first blocks of the slow picture are there")
    page.type_over("recursive_level 3", "recursive_levle 3")
    page.wait_for_state("faults")
    page.wait(lambda: page.render is not None and page.picture() == good, "the last good picture is there")
    same(page.read("return document.getElementById('download').getAttribute('href')"), f"{program.site}picture.png?render={page.render}&token={program.token}", "what there is to download")


@test
def closing_the_page_ends_the_work(trial):
    program = trial.view(trial.scene(SLOW))
    page = trial.open(program)
    page.wait_for_state("drawing")
    early = program.processor_seconds()
    until(lambda: program.processor_seconds() > early + 0.5, "the program works")
    page.close()
    start = time.monotonic()

    def rests():
        before = program.processor_seconds()
        time.sleep(0.5)
        return program.processor_seconds() - before < 0.05

    until(rests, "the program rests")
    trial.note = f"at rest {time.monotonic() - start - 0.5:.1f} s after it was closed"
    # The next page finds it all again.
    again = trial.open(program)
    again.wait_for_state("drawing")
    same(again.typed, SLOW, "the text on the next page")


@test
def Ctrl_C_ends_the_program_and_leaves_nothing_behind(trial):
    path = trial.scene(SLOW)
    program = trial.view(path)
    page = trial.open(program)
    page.wait_for_state("drawing")
    page.type_over(RAY, WIDER)
    trial.expect_errors(r"WebSocket|ERR_CONNECTION_REFUSED")
    seconds = program.interrupt()
    trial.note = f"in {seconds:.2f} s"
    holds(seconds < 10, f"the program took {seconds:.1f} s to end")
    with socket.socket() as caller:
        holds(caller.connect_ex(("127.0.0.1", program.port)) != 0, "somebody still answers at its port")
    same(sorted(one.name for one in path.parent.iterdir()), ["scene.txt"], "what is in the scene's folder")
    same(path.read_text(), SLOW, "the scene's file")
    page.wait_for_state("lost")


@test
def when_the_program_ends_the_page_says_so_and_keeps_the_typed_text(trial):
    path = trial.scene(SCENE)
    program = trial.view(path)
    page = trial.open(program)
    page.wait_for_state("done")
    trial.expect_errors(r"WebSocket|ERR_CONNECTION_REFUSED|403")
    program.interrupt()
    page.wait_for_state("lost")
    holds(page.is_seen("notice") and page.text("notice-text").startswith("The program has ended"), f"the page says: {page.text('notice-text')!r}")
    page.type_over(RAY, WIDER)
    wider = SCENE.replace(RAY, WIDER)
    same(page.typed, wider, "the text in the editor")
    page.wait(lambda: page.seconds_of_rest() > 0.5, "typing has rested while there was no program")
    # The page finds the program again by itself, which does not know it. With the new address in the same tab, it draws what was typed.
    again = trial.view(path, "--port", program.port)
    page.wait_for_state("refused")
    same(page.typed, wider, "the text in the editor")
    page.driver.get(again.address)
    page.wait_for_picture(trial.rendered(wider))
    same(page.typed, wider, "the text in the editor")
    same(path.read_text(), SCENE, "the scene's file")


# ---------------------------------------------------------------------------
# Saving


@test
def the_file_is_written_only_when_it_is_asked_for(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    wider, widest = SCENE.replace(RAY, WIDER), SCENE.replace(RAY, "ray      2.4")
    page.type_over(RAY, WIDER)
    page.wait_for_picture(trial.rendered(wider))
    same((path.read_text(), page.text("saved")), (SCENE, "not saved"), "the file before it is saved, and what the page says of it")
    page.click("#save")
    page.wait(lambda: path.read_text() == wider, "the button saves the text")
    page.wait(lambda: page.text("saved") == "saved", "the page says that it is saved")
    page.type_over(WIDER, "ray      2.4")
    page.press((Keys.CONTROL, "s"))
    page.wait(lambda: path.read_text() == widest, "Ctrl+S saves the text")
    page.wait(lambda: page.text("saved") == "saved", "the page says that it is saved")
    same(sorted(one.name for one in path.parent.iterdir()), ["scene.txt"], "what is in the scene's folder")


@test
def a_file_changed_by_somebody_else_is_not_overwritten_silently(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    mine, theirs = SCENE.replace(RAY, WIDER), SCENE + "# by somebody else\n"
    page.type_over(RAY, WIDER)
    page.wait_for_picture(trial.rendered(mine))
    path.write_text(theirs)
    page.wait(lambda: page.is_seen("overwrite") and page.is_seen("reload"), "the page offers to take the file's text, or to save its own over it")
    same(page.typed, mine, "the text in the editor")
    page.press((Keys.CONTROL, "s"))
    # The answer to this shows that the program has heard Ctrl+S.
    page.click("#language")
    page.wait(lambda: page.language == "fr", "the program answers")
    same(path.read_text(), theirs, "the file after Ctrl+S")
    page.click("#overwrite")
    page.wait(lambda: path.read_text() == mine, "the own text is saved over it")
    page.wait(lambda: not page.is_seen("overwrite"), "nothing more is asked")


@test
def the_text_of_a_file_changed_by_somebody_else_can_be_taken(trial):
    path = trial.scene(SCENE)
    page = trial.open(trial.view(path))
    page.wait_for_state("done")
    page.type_over(RAY, WIDER)
    page.wait_for_picture(trial.rendered(SCENE.replace(RAY, WIDER)))
    theirs = SCENE.replace("color red", "color green")
    path.write_text(theirs)
    page.wait(lambda: page.is_seen("reload"), "the page offers to take the file's text")
    page.click("#reload")
    page.wait_for_picture(trial.rendered(theirs))
    same((page.typed, page.text("saved"), path.read_text()), (theirs, "saved", theirs), "the text, what the page says of it, and the file")


# ---------------------------------------------------------------------------
# application frame


@test
def application_frame_draws_writes_and_ends_with_its_page(trial):
    path = trial.scene(SCENE)
    configuration = path.with_name("configuration.cfg")
    configuration.write_text("application frame\nread_data scene.txt\nwrite_data out.txt\nlog_file true\nlog_file_name log.txt\nviewport_image_count 7\nlanguage en\n")
    file = rendered(trial.dioptre, path)
    # A screen, and a browser of the user's own that shows nothing: the page is opened below.
    desktop = Path(trial.ends.enter_context(tempfile.TemporaryDirectory(prefix="dioptre-browser-desktop-")))
    (desktop / "xdg-open").write_text("#!/bin/sh\n")
    (desktop / "xdg-open").chmod(0o755)
    environment = {**ENVIRONMENT, "DISPLAY": ":0", "PATH": f"{desktop}{os.pathsep}{ENVIRONMENT['PATH']}"}
    program = trial.ends.enter_context(Program(trial.dioptre, folder=path.parent, environment=environment))
    page = trial.open(program)
    page.wait_for_picture(png.pixels(file))
    same(Path(program.line()).name, "ball_007.png", "the path that is printed")
    same((path.parent / "ball_007.png").read_bytes(), file, "the picture's file")
    written = path.with_name("out.txt")
    until(written.exists, "the scene is written back")
    same(png.pixels(rendered(trial.dioptre, written)), png.pixels(file), "the picture of the scene that is written back")
    until(lambda: re.search(r"^viewport_image_count\s+8$", configuration.read_text(), re.MULTILINE), "the picture is counted")
    holds(program.is_running, "the program has ended before its page is closed")
    page.close()
    same(program.ended(), 0, "the exit code")
    same(sorted(one.name for one in path.parent.iterdir()), ["ball_007.png", "configuration.cfg", "log.txt", "out.txt", "scene.txt"], "what is in the folder")
