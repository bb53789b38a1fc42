// The viewer's page: the scene's text on one side, its picture on the other, the story of a pixel between them.
//
// The program has one desk with one text and one rendering, and every page shows it. This module joins the parts: it takes the program's messages to
// them (see `messages`) and what is done on the page back to the program. What the page is doing stands in `body[data-state]`:
// connecting, drawing, done, faults (the text cannot be drawn as it is) or lost (the program cannot be reached). Where a picture is wholly shown, `data-render` is the number of
// its rendering and `data-version` that of its text.

import { Comparison } from "./comparison.js";
import { Connection } from "./connection.js";
import { listDiagnostics } from "./diagnostics.js";
import { Editor } from "./editor.js";
import { byId, element } from "./element.js";
import { bytes, swatch } from "./figures.js";
import { Loupe } from "./loupe.js";
import { Drawing } from "./picture.js";
import { chooseRay, clearRays, drawRays } from "./rays.js";
import { tellStory } from "./story.js";
import { followTheme } from "./theme.js";
import { counted, currentLanguage, keyList, otherLanguage, say, seconds, speak } from "./words.js";

const desk = { page: null, file: "", canSave: false, limits: { text: Infinity }, text: "", isSaved: true, isInConflict: false, diagnostics: null, sent: null, isFirstScene: true };
const rendering = { phase: "connecting", told: null, isLost: false };
const asked = { id: 0, pixel: null, story: null, text: "" };
const starts = new Map();
let announcement = null;

/** What lasts longer, in seconds, is worth a word. */
const patience = 1;

followTheme(byId("theme"));
speak(currentLanguage());

// ---------------------------------------------------------------------------
// The text

const editor = new Editor({
  typed: () => showSaved(),
  rested: () => sendText(),
});

function sendText() {
  const { text } = editor;
  const size = new TextEncoder().encode(text).length;
  rendering.tooLong = size > desk.limits.text ? size : null;
  desk.isUnsent = rendering.tooLong !== null || !connection.isOpen;
  // A text that is there already would not be answered.
  if (!desk.isUnsent && (desk.sent ?? desk.text) !== text) {
    tell({ type: "edit", text });
    desk.sent = text;
  }
  show();
}

function save(overwrite = false) {
  editor.flush();
  if (desk.canSave) tell({ type: "save", overwrite });
}

/** The text on the desk. The page's own typing stays as it is; other texts replace it, but what was typed here and has not yet arrived there wins. */
function takeScene({ text, saved, conflict, by, page }) {
  const isOwn = by === "page" && page === desk.page;
  const isWaiting = desk.sent !== null && desk.sent !== text;
  Object.assign(desk, { text, isSaved: saved, isInConflict: conflict === true });
  if (desk.isFirstScene) {
    const isTyped = desk.isUnsent || editor.isPending || desk.sent !== null;
    desk.isFirstScene = false;
    desk.sent = null;
    if (isTyped) editor.isPending || sendText();
    else if (editor.text !== text) editor.replace(text);
    return;
  }
  if (isOwn && isWaiting) return;
  desk.sent = null;
  if (!editor.isPending && !desk.isUnsent && editor.text !== text) editor.replace(text);
}

function showSaved() {
  const isSaved = desk.isSaved && !editor.isPending && !desk.isUnsent && desk.sent === null;
  byId("file").textContent = desk.file;
  byId("saved").textContent = desk.file ? say(isSaved ? "saved" : "unsaved") : "";
  byId("saved").classList.toggle("unsaved", !isSaved);
  byId("save").disabled = !desk.canSave || isSaved || rendering.isLost;
  document.title = desk.file ? `${isSaved ? "" : "• "}${desk.file} – Dioptre` : "Dioptre";
}

function takeDiagnostics(message) {
  const before = desk.diagnostics?.diagnostics.length;
  desk.diagnostics = message;
  editor.mark(message.diagnostics.filter((d) => d.own));
  listDiagnostics(message.diagnostics, (d) => editor.goTo(d.line, d.column, d.endColumn));
  if (before !== undefined && before !== message.diagnostics.length) announceLater(byId("diagnostics-title").textContent);
}

// ---------------------------------------------------------------------------
// The picture

const drawing = new Drawing(byId("picture"));

const loupe = new Loupe({
  look: (pixel, byKeyboard) => readOut(pixel, byKeyboard),
  pick: (pixel) => ask(pixel),
  scaled: () => showRays(false),
});

const comparison = new Comparison(drawing, () => loupe.layOut());

function takeRows(buffer) {
  if (!drawing.take(buffer)) return;
  delete document.body.dataset.render;
  delete document.body.dataset.version;
  const { width, height } = drawing.picture;
  byId("picture").setAttribute("aria-label", say("canvas", width, height));
  loupe.resize(width, height);
  comparison.show();
}

function readOut(pixel, byKeyboard) {
  const at = pixel && drawing.picture?.at(pixel.column, pixel.row);
  if (!at) return byId("readout").replaceChildren(element("span", { class: "aside" }, say("pixelHint")));
  const field = (four) => [swatch(four.map((byte) => byte / 255)), " ", bytes(four)];
  const before = comparison.isOn ? drawing.previous?.at(pixel.column, pixel.row) : null;
  byId("readout").replaceChildren(...[say("pixel", pixel.column, pixel.row), "  ", field(at), before ? [`  ${say("was")} `, field(before)] : []].flat(Infinity));
  if (byKeyboard) announce(`${say("pixel", pixel.column, pixel.row)}: ${at.join(" ")}`);
}

// ---------------------------------------------------------------------------
// The story of a pixel

function ask(pixel) {
  asked.pixel = pixel;
  asked.id += 1;
  byId("story").hidden = false;
  byId("story").classList.add("waiting");
  byId("story").dataset.column = pixel.column;
  byId("story").dataset.row = pixel.row;
  byId("story-title").textContent = say("storyOf", pixel.column, pixel.row);
  document.body.classList.add("has-story");
  if (!tell({ type: "explain", id: asked.id, ...pixel })) byId("story-note").textContent = say("lost");
}

function takeStory({ id, render, story, text }) {
  if (id !== asked.id || !asked.pixel) return;
  Object.assign(asked, { story, text, render });
  byId("story").classList.remove("waiting");
  byId("story-note").textContent = "";
  tellStory(story, text);
  showRays(true);
  announce(byId("story-content").querySelector(".answer").textContent);
}

function showRays(isNew) {
  const start = starts.get(asked.render);
  if (asked.story && start) drawRays(asked.story, start.projection, loupe.scale, isNew);
  else clearRays();
}

function closeStory() {
  if (byId("story").hidden) return;
  const hadFocus = byId("story").contains(document.activeElement);
  byId("story").hidden = true;
  delete byId("story").dataset.column;
  delete byId("story").dataset.row;
  byId("story-content").replaceChildren();
  document.body.classList.remove("has-story");
  Object.assign(asked, { pixel: null, story: null, render: null });
  clearRays();
  if (hadFocus) byId("picture").focus();
}

// ---------------------------------------------------------------------------
// What the program says

const messages = {
  hello(message) {
    Object.assign(desk, { page: message.page, file: message.file, canSave: message.canSave, limits: message.limits, isFirstScene: true });
    rendering.isLost = false;
    starts.clear();
    speakAgain(message.language);
  },
  scene: takeScene,
  diagnostics: takeDiagnostics,
  start(message) {
    starts.set(message.render, message);
    for (const render of starts.keys()) if (starts.size > 3 && render !== asked.render) starts.delete(render);
    drawing.begin(message);
    Object.assign(rendering, { phase: "drawing", told: null, height: message.height });
  },
  progress(message) {
    if (rendering.phase === "drawing") rendering.told = message;
    if (asked.story && asked.render !== message.render && message.seconds > patience) byId("story-note").textContent = say("stale");
  },
  done(message) {
    drawing.end(message.render);
    Object.assign(rendering, { phase: "done", told: message });
    Object.assign(document.body.dataset, { render: message.render, version: drawing.shown?.version });
    comparison.show();
    readOut(loupe.cursor, false);
    if (message.seconds > patience) announce(statusText());
    const { pixel } = asked;
    if (pixel && asked.render !== message.render && drawing.picture?.at(pixel.column, pixel.row)) {
      loupe.place(pixel);
      ask(pixel);
    }
  },
  cancelled(message) {
    if (drawing.start?.render === message.render) rendering.phase = "stopped";
  },
  story: takeStory,
  refused({ id, message }) {
    if (id === undefined) rendering.refusal = message;
    else if (id === asked.id) {
      asked.story = null;
      byId("story").classList.remove("waiting");
      byId("story-note").textContent = message;
      byId("story-content").replaceChildren();
      clearRays();
    }
  },
  language(message) {
    speakAgain(message.language);
    if (asked.pixel) ask(asked.pixel);
  },
};

const connection = new Connection({
  message(message) {
    messages[message.type]?.(message);
    show();
  },
  rows: takeRows,
  lost() {
    rendering.isLost = true;
    show();
  },
});

/** Says something to the program; whatever was refused before is forgotten. */
function tell(message) {
  rendering.refusal = null;
  return connection.send(message);
}

// ---------------------------------------------------------------------------
// What is going on

function show() {
  const { phase, told } = rendering;
  const hasFaults = desk.diagnostics && ((desk.diagnostics.faults && !desk.diagnostics.drawn) || desk.diagnostics.complaint);
  document.body.dataset.state = rendering.isLost ? (desk.page === null ? "connecting" : "lost") : hasFaults ? "faults" : phase === "stopped" ? "drawing" : phase;
  byId("status").textContent = statusText();
  byId("progress").hidden = phase !== "drawing" || rendering.isLost;
  byId("progress").max = rendering.height ?? 1;
  byId("progress").value = phase === "drawing" ? told?.rows ?? 0 : 0;
  showNotice(hasFaults);
  const isDone = phase === "done" && !rendering.isLost;
  byId("download").toggleAttribute("aria-disabled", !isDone);
  if (isDone) Object.assign(byId("download"), { href: told.picture, download: told.name });
  else byId("download").removeAttribute("href");
  showSaved();
}

function statusText() {
  const { phase, told } = rendering;
  const speed = told && told.seconds > 0 ? counted(Number((told.rays / told.seconds).toPrecision(3))) : "0";
  if (rendering.isLost || phase === "connecting") return desk.page === null ? say("connecting") : "";
  if (phase === "stopped") return say("stopped");
  if (phase === "drawing") return told ? say("drawingFor", seconds(told.seconds), speed) : say("drawing");
  return [say("drawn", seconds(told.seconds), counted(told.rays), speed), told.cut ? say("cut") : "", told.written ? say("written", told.written) : ""].filter(Boolean).join(" ");
}

/** At most one notice, the most pressing one, with what can be done about it. */
function showNotice(hasFaults) {
  const complaint = desk.diagnostics?.complaint;
  const notices = [
    [rendering.isLost && desk.page !== null, () => say("lost"), ["retry"]],
    [rendering.tooLong, () => say("tooLong", counted(rendering.tooLong), counted(desk.limits.text)), []],
    [desk.isInConflict, () => say("conflict"), ["reload", "overwrite"]],
    [rendering.refusal, () => rendering.refusal, []],
    [complaint, () => complaint, []],
    [hasFaults, () => say("lastGood"), ["draw-anyway"]],
  ];
  const [, text, buttons] = notices.find(([holds]) => holds) ?? [true, () => "", []];
  if (byId("notice-text").textContent !== text()) byId("notice-text").textContent = text();
  byId("notice").hidden = text() === "";
  byId("notice").classList.toggle("lost", buttons.includes("retry"));
  for (const id of ["retry", "reload", "overwrite", "draw-anyway"]) byId(id).hidden = !buttons.includes(id);
}

/** For those who listen. */
function announce(text) {
  clearTimeout(announcement);
  byId("announcement").textContent = text;
}

/** The same when there has been nothing else to say for a while: somebody is typing. */
function announceLater(text) {
  clearTimeout(announcement);
  announcement = setTimeout(() => announce(text), 1000 * patience);
}

function speakAgain(language) {
  speak(language);
  byId("language").lang = otherLanguage();
  if (drawing.picture) byId("picture").setAttribute("aria-label", say("canvas", drawing.picture.width, drawing.picture.height));
  byId("key-list").replaceChildren(...keyList().flatMap(([key, what]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, what)]));
  if (desk.diagnostics) takeDiagnostics(desk.diagnostics);
  comparison.show();
  readOut(loupe.cursor, false);
  show();
}

// ---------------------------------------------------------------------------
// Buttons and keys

byId("save").addEventListener("click", () => save());
byId("overwrite").addEventListener("click", () => save(true));
byId("reload").addEventListener("click", () => tell({ type: "reload" }));
byId("language").addEventListener("click", () => tell({ type: "language", language: otherLanguage() }));
byId("draw-anyway").addEventListener("click", () => tell({ type: "draw" }));
byId("retry").addEventListener("click", () => connection.open());
byId("close-story").addEventListener("click", closeStory);
byId("keys-button").addEventListener("click", () => byId("keys").showModal());
byId("close-keys").addEventListener("click", () => byId("keys").close());

document.addEventListener("keydown", (event) => {
  const isInPicture = event.target === document.body || (event.target.closest("#looking, #story") && !event.target.closest("select"));
  const withControl = event.ctrlKey || event.metaKey;
  if (withControl && event.key.toLowerCase() === "s") act(event, () => save());
  else if (withControl && event.key === "Enter" && event.target === editor.area) act(event, () => byId("picture").focus());
  else if (event.key === "Escape" && !byId("keys").open) closeStory();
  else if (isInPicture && !withControl && !event.altKey) {
    const acts = { "+": () => loupe.step(1), "=": () => loupe.step(1), "-": () => loupe.step(-1), 0: () => loupe.fit(), c: () => comparison.next(), e: () => editor.area.focus(), "?": () => byId("keys").showModal() };
    const done = acts[event.key.toLowerCase()];
    if (done) act(event, done);
  }
});

function act(event, done) {
  event.preventDefault();
  done();
}

addEventListener("beforeunload", (event) => {
  if (rendering.isLost && desk.isUnsent) event.preventDefault();
});

for (const leaving of ["pointerleave", "focusout"]) byId("story").addEventListener(leaving, () => chooseRay(null));
speakAgain(currentLanguage());
