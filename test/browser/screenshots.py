"""Pictures of the page, for looking at."""

import re
import shutil

from program import PROJECT
from trial import trying


def larger(name, side):
    """A scene of the project's, as a square picture of another size."""
    return re.sub(r"(?m)^(  (?:width|height) +)\d+", rf"\g<1>{side}", (PROJECT / "scenes" / name).read_text())


def take_screenshots(dioptre, browser, folder):
    folder.mkdir(parents=True, exist_ok=True)

    def drawing(trial):
        text = re.sub(r"(?m)^(  sampling +)\d+", r"\g<1>36", larger("model-forest.txt", 600))
        path = trial.scene(text, "forest.txt")
        shutil.copytree(PROJECT / "models", path.with_name("models"))
        page = trial.open(trial.view(path))
        page.wait(lambda: page.read("const { value, max } = document.getElementById('progress'); return value > max / 3"), "a third of the picture is there")
        return page

    def done(trial, *options, **language):
        page = trial.open(trial.view(trial.scene(larger("torus.txt", 600), "torus.txt"), *options, **language))
        page.wait_for_state("done")
        return page

    def fault(trial):
        page = done(trial)
        page.type_over("look_at             [0.0, 0.0, 0.0]", "look_at             [0.0, 0.0]")
        page.type_over("angle               50.0 degrees", "angel               50.0 degrees")
        page.wait(lambda: len(page.diagnostics()) == 2, "two faults are listed")
        page.read("document.getElementById('editor').scrollTop = 0")
        return page

    def story(trial, **language):
        page = trial.open(trial.view(trial.scene(larger("mirror.txt", 480), "mirror.txt"), **language))
        page.wait_for_state("done")
        page.click_pixel(280, 268)
        page.wait_for_story(280, 268)
        return page

    def dark(trial):
        page = story(trial)
        page.click("#theme")
        return page

    for name, shown in (("drawing", drawing), ("done", done), ("fault", fault), ("story", story), ("done-fr", lambda trial: done(trial, language="fr")), ("dark", dark)):
        with trying(dioptre, browser) as trial:
            page = shown(trial)
            # When what moves has come to rest
            page.wait(lambda: page.read("return document.getAnimations().every((one) => one.playState !== 'running')"), "nothing moves")
            page.driver.save_screenshot(str(folder / f"view-{name}.png"))
