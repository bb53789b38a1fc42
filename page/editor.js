// The scene's text: an area to type in, with line numbers, and behind it a layer of marks on what is faulty.
//
// A line is never wrapped, so that each is as high as every other, and only the faulty lines have to stand in the layer.

import { byId, element } from "./element.js";

const restingTime = 150;

export class Editor {
  /** Told of `typed` at once, and of `rested` when typing has rested. */
  constructor(listener) {
    this.listener = listener;
    this.area = byId("editor");
    this.area.addEventListener("input", () => {
      this.#number();
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.flush(), restingTime);
      this.isPending = true;
      listener.typed();
    });
    this.area.addEventListener("scroll", () => this.#follow());
    new ResizeObserver(() => this.#follow()).observe(this.area);
  }

  get text() {
    return this.area.value;
  }

  /** Takes over a text; the caret stays where it was. */
  replace(text) {
    const { selectionStart, selectionEnd, scrollTop, scrollLeft } = this.area;
    this.area.value = text;
    this.area.setSelectionRange(selectionStart, selectionEnd);
    this.area.scrollTo(scrollLeft, scrollTop);
    this.#forget();
    this.#number();
  }

  /** Sends off at once what is waiting for typing to rest. */
  flush() {
    if (!this.isPending) return;
    this.#forget();
    this.listener.rested();
  }

  #forget() {
    clearTimeout(this.timer);
    this.isPending = false;
  }

  /** Marks faulty lines and columns. */
  mark(diagnostics) {
    const lines = this.area.value.split("\n");
    const byLine = new Map();
    for (const d of diagnostics) byLine.set(d.line, [...(byLine.get(d.line) ?? []), d]);
    const height = this.#lineHeight();
    const placed = (made, line) => {
      made.style.top = `${(line - 1) * height}px`;
      return made;
    };
    this.#layer().replaceChildren(...[...byLine].map(([line, ds]) => placed(element("div", { class: `faulty ${worst(ds)}`, "data-line": line }, underlined(lines[line - 1] ?? "", ds)), line)));
    byId("signs").replaceChildren(...[...byLine].map(([line, ds]) => placed(element("div", { class: `sign ${worst(ds)}`, title: ds.map((d) => d.message).join("\n") }), line)));
    this.#follow();
  }

  /** Puts the caret on a place of the text, and selects what stands there. */
  goTo(line, column, endColumn) {
    const lines = this.area.value.split("\n");
    const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
    const letters = [...(lines[line - 1] ?? "")];
    const unitsTo = (c) => letters.slice(0, c - 1).join("").length;
    this.area.focus();
    this.area.setSelectionRange(start + unitsTo(column), start + unitsTo(endColumn));
    this.area.scrollTo(0, (line - 1) * this.#lineHeight() - this.area.clientHeight / 3);
  }

  #layer() {
    return byId("marks");
  }

  #lineHeight() {
    return parseFloat(getComputedStyle(this.area).lineHeight);
  }

  #number() {
    const count = this.area.value.split("\n").length;
    if (count === this.count) return;
    this.count = count;
    byId("numbers").textContent = Array.from({ length: count }, (_, k) => k + 1).join("\n");
  }

  #follow() {
    const { scrollTop, scrollLeft } = this.area;
    this.#layer().style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
    for (const id of ["numbers", "signs"]) byId(id).style.transform = `translateY(${-scrollTop}px)`;
  }
}

const worst = (diagnostics) => ["error", "warning", "note"].find((severity) => diagnostics.some((d) => d.severity === severity));

/** A line's letters, those from column to endColumn within marks. Columns count code points from 1; a place without letters is one space wide. */
function underlined(line, diagnostics) {
  const letters = [...line];
  const parts = [];
  let at = 0;
  for (const d of [...diagnostics].sort((a, b) => a.column - b.column)) {
    const from = Math.max(at, d.column - 1);
    const to = Math.max(from + 1, d.endColumn - 1);
    if (d.column - 1 < at) continue;
    while (letters.length < to) letters.push(" ");
    parts.push(letters.slice(at, from).join(""), element("span", { class: `underlined ${d.severity}` }, letters.slice(from, to).join("")));
    at = to;
  }
  return parts;
}
