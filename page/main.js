// The viewer's page: the scene's text on one side, its picture on the other, the story of a pixel between them.
//
// The program has one desk with one text and one rendering, and every page shows it. This module joins the parts: it takes the program's messages to
// them (see `messages`) and what is done on the page back to the program. Where a picture is wholly shown, `body[data-render]` is the number of
// its rendering and `body[data-version]` that of its text; status.js tells of `body[data-state]`.

import { announce, patience } from "./announcement.js";
import { Comparison } from "./comparison.js";
import { Connection } from "./connection.js";
import { Diagnostics } from "./diagnostics.js";
import { byId } from "./element.js";
import { Inquiry } from "./inquiry.js";
import { listenToKeys, listKeys, showKeys } from "./keys.js";
import { Loupe } from "./loupe.js";
import { showNotice } from "./notice.js";
import { Drawing } from "./picture.js";
import { chooseRay } from "./rays.js";
import { readOut } from "./readout.js";
import { Status } from "./status.js";
import { SceneText } from "./text.js";
import { followTheme } from "./theme.js";
import { takeToken } from "./token.js";
import { counted, currentLanguage, otherLanguage, say, speak } from "./words.js";

takeToken();
followTheme(byId("theme"));
speak(currentLanguage());

// ---------------------------------------------------------------------------
// The parts

const status = new Status();
const text = new SceneText({ tell, isOpen: () => connection.isOpen, changed: show });
const diagnostics = new Diagnostics(text.editor);
const drawing = new Drawing(byId("picture"));
const inquiry = new Inquiry({ tell, scale: () => loupe.scale });
const loupe = new Loupe({
  look: (pixel, byKeyboard) => look(pixel, byKeyboard),
  pick: (pixel) => inquiry.ask(pixel),
  scaled: () => inquiry.showRays(false),
});
const comparison = new Comparison(drawing, () => loupe.layOut());

/** What the program has refused last. */
let refusal = null;

/** Says something to the program; whatever was refused before is forgotten. */
function tell(message) {
  refusal = null;
  return connection.send(message);
}

/** Tells of a pixel that is looked at. */
function look(pixel, byKeyboard = false) {
  readOut(pixel, drawing.picture, comparison.isOn ? drawing.previous : null, byKeyboard);
}

// ---------------------------------------------------------------------------
// What the program says

const messages = {
  hello(message) {
    text.greet(message);
    status.greet();
    inquiry.greet();
    speakAgain(message.language);
  },
  scene: (message) => text.take(message),
  diagnostics: (message) => diagnostics.take(message),
  start(message) {
    inquiry.begin(message);
    drawing.begin(message);
    status.begin(message);
  },
  progress(message) {
    status.progress(message);
    inquiry.age(message);
  },
  done(message) {
    drawing.end(message.render);
    status.end(message);
    Object.assign(document.body.dataset, { render: message.render, version: drawing.shown?.version });
    comparison.show();
    look(loupe.cursor);
    if (message.seconds > patience) announce(status.text);
    const { pixel } = inquiry;
    if (pixel && inquiry.render !== message.render && drawing.picture?.at(pixel.column, pixel.row)) {
      loupe.place(pixel);
      inquiry.repeat();
    }
  },
  cancelled(message) {
    if (drawing.start?.render === message.render) status.stop();
  },
  story: (message) => inquiry.take(message),
  refused({ id, message }) {
    if (id === undefined) refusal = message;
    else inquiry.refuse(id, message);
  },
  language(message) {
    speakAgain(message.language);
    inquiry.repeat();
  },
};

const connection = new Connection({
  message(message) {
    messages[message.type]?.(message);
    show();
  },
  rows(buffer) {
    if (!drawing.take(buffer)) return;
    delete document.body.dataset.render;
    delete document.body.dataset.version;
    describePicture();
    loupe.resize(drawing.picture.width, drawing.picture.height);
    comparison.show();
  },
  lost() {
    status.lose();
    show();
  },
  refused() {
    status.refuse();
    show();
  },
});

// ---------------------------------------------------------------------------
// What is shown of it

function show() {
  const { hasFaults, complaint } = diagnostics;
  status.show(hasFaults);
  text.showSaved();
  showNotice([
    { holds: status.isRefused, text: say("refused"), isGrave: true },
    { holds: status.isLost && status.isGreeted, text: say("lost"), offers: ["retry"], isGrave: true },
    { holds: text.tooLong !== null, text: say("tooLong", counted(text.tooLong ?? 0), counted(text.mostBytes)) },
    { holds: text.isInConflict, text: say("conflict"), offers: ["reload", "overwrite"] },
    { holds: refusal, text: refusal },
    { holds: complaint, text: complaint },
    { holds: hasFaults, text: say("lastGood"), offers: ["draw-anyway"] },
  ]);
}

function describePicture() {
  if (drawing.picture) byId("picture").setAttribute("aria-label", say("canvas", drawing.picture.width, drawing.picture.height));
}

function speakAgain(language) {
  speak(language);
  byId("language").lang = otherLanguage();
  describePicture();
  listKeys();
  diagnostics.show();
  comparison.show();
  look(loupe.cursor);
  show();
}

// ---------------------------------------------------------------------------
// What is done on the page

for (const [id, act] of Object.entries({
  save: () => text.save(),
  overwrite: () => text.save(true),
  reload: () => tell({ type: "reload" }),
  language: () => tell({ type: "language", language: otherLanguage() }),
  "draw-anyway": () => tell({ type: "draw" }),
  retry: () => connection.open(),
  "close-story": () => inquiry.close(),
}))
  byId(id).addEventListener("click", act);

const acting = (act) => (event) => {
  event.preventDefault();
  act();
};

listenToKeys({
  anywhere: {
    s: acting(() => text.save()),
    enter: (event) => event.target === text.editor.area && acting(() => byId("picture").focus())(event),
  },
  inPicture: {
    "+": acting(() => loupe.step(1)),
    "=": acting(() => loupe.step(1)),
    "-": acting(() => loupe.step(-1)),
    0: acting(() => loupe.fit()),
    c: acting(() => comparison.next()),
    e: acting(() => text.editor.area.focus()),
    "?": acting(showKeys),
  },
  escape: () => inquiry.close(),
});

// The address of another run was put into the address bar.
addEventListener("hashchange", () => takeToken() && connection.open());

addEventListener("beforeunload", (event) => {
  if (status.isLost && text.isUnsent) event.preventDefault();
});

for (const leaving of ["pointerleave", "focusout"]) byId("story").addEventListener(leaving, () => chooseRay(null));
speakAgain(currentLanguage());
