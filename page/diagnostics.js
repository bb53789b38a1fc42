// The list of what is wrong with the scene. Each entry says its severity in words and by a sign; one that is about the text leads to its place.

import { byId, element } from "./element.js";
import { say } from "./words.js";

const signs = { error: "✕", warning: "▲", note: "i" };

/** Lists diagnostics; `go` is told which one to go to. */
export function listDiagnostics(diagnostics, go) {
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
