// What is wrong with the scene: a list, and marks in the text. Each entry says its severity in words and by a sign; one that is about the text leads to its place.

import { announceLater } from "./announcement.js";
import { byId, element } from "./element.js";
import { say } from "./words.js";

const signs = { error: "✕", warning: "▲", note: "i" };

export class Diagnostics {
  /** Of the text in an editor. */
  constructor(editor) {
    this.editor = editor;
    this.told = null;
  }

  /** Whether the text is not drawn for them. */
  get hasFaults() {
    return this.told !== null && ((this.told.faults && !this.told.drawn) || this.complaint !== undefined);
  }

  /** Why a text without faults is not drawn. */
  get complaint() {
    return this.told?.complaint;
  }

  take(message) {
    const before = this.told?.diagnostics.length;
    this.told = message;
    this.show();
    if (before !== undefined && before !== message.diagnostics.length) announceLater(byId("diagnostics-title").textContent);
  }

  show() {
    if (!this.told) return;
    this.editor.mark(this.told.diagnostics.filter((d) => d.own));
    list(this.told.diagnostics, (d) => this.editor.goTo(d.line, d.column, d.endColumn));
  }
}

/** Lists diagnostics; `go` is told which one to go to. */
function list(diagnostics, go) {
  const errors = diagnostics.filter((d) => d.severity !== "note").length;
  const notes = diagnostics.length - errors;
  byId("diagnostics-title").textContent = [errors > 0 || notes === 0 ? say("faults", errors) : null, notes > 0 ? say("remarks", notes) : null].filter(Boolean).join(", ");
  byId("diagnostics").replaceChildren(...diagnostics.map((d) => entry(d, go)));
}

function entry(d, go) {
  const place = d.own ? say("place", d.line, d.column) : `${d.file}, ${say("place", d.line, d.column)}`;
  const advice = [
    [say("expected"), d.expected],
    [say("used"), d.used],
  ].filter(([, text]) => text);
  const content = [
    element("span", { class: "sign", "aria-hidden": "true" }, signs[d.severity] ?? "•"),
    element("span", { class: "told" }, element("span", { class: "head" }, element("span", { class: "severity" }, d.severityName), " ", element("span", { class: "place" }, place)), " ", element("span", { class: "message" }, d.message)),
    advice.map(([name, text]) => element("span", { class: "advice" }, element("span", { class: "name" }, name), " ", text)),
  ];
  const holder = d.own ? element("button", { type: "button", click: () => go(d) }, content) : element("div", {}, content);
  return element("li", { class: d.severity, "data-line": d.line, "data-column": d.column, "data-code": d.code, "data-severity": d.severity, "data-own": String(d.own) }, holder);
}
