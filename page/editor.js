// The scene's text: an area to type in, with line numbers, and behind it a layer of marks on what is faulty.
//
// A line is never wrapped, so that each is as high as every other, and only the faulty lines have to stand in the layer.
//
// A text that comes from elsewhere is put in as an edit of what stands there, which the browser undoes as it undoes typing. Setting the area's value, or a range of it, would
// forget what can be undone. The command for that, `execCommand`, is called obsolete and has no successor. Of its words Chromium takes seconds for `insertText` of a few
// hundred lines, as it lays out the page for each, and milliseconds for `insertHTML`, of which an area keeps the text only.

import { byId, element } from "./element.js";

const restingTime = 150;

/** So many letters at once are put in such that this can be undone. It takes about as long as can be waited for, and more letters by far longer. */
const mostUndone = 100000;

export class Editor {
  /** Told of `typed` at once, and of `rested` when typing has rested. */
  constructor(listener) {
    this.listener = listener;
    this.area = byId("editor");
    this.isBlank = true;
    this.area.addEventListener("input", () => {
      if (this.isReplacing) return;
      this.isBlank = false;
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

  /** Takes over a text; the caret stays where it was. Undoing brings back the text before, unless this is the first one. */
  replace(text) {
    this.#forget();
    if (text === this.area.value) return;
    const { selectionStart, selectionEnd, selectionDirection, scrollTop, scrollLeft } = this.area;
    const change = difference(this.area.value, text);
    if (!this.isBlank) this.#edit(change);
    if (this.area.value !== text) this.area.value = text;
    this.isBlank = false;
    this.area.setSelectionRange(moved(selectionStart, change), moved(selectionEnd, change), selectionDirection);
    this.area.scrollTo(scrollLeft, scrollTop);
    this.#number();
  }

  /** Does it as if it were typed. Where the browser cannot, nothing happens. */
  #edit({ start, end, inserted }) {
    const before = document.activeElement;
    this.area.focus({ preventScroll: true });
    // While a dialog is open the area cannot have the keyboard, and a command would go elsewhere.
    if (document.activeElement === this.area && inserted.length <= mostUndone) {
      this.isReplacing = true;
      this.area.setSelectionRange(start, end);
      if (inserted === "") document.execCommand("delete");
      else document.execCommand("insertHTML", false, asMarkup(inserted)) || document.execCommand("insertText", false, inserted);
      this.isReplacing = false;
    }
    if (before === this.area) return;
    this.area.blur();
    before?.focus({ preventScroll: true });
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

/** One text as an edit of another: what is inserted instead of the letters from `start` to `end`. */
function difference(old, text) {
  const least = Math.min(old.length, text.length);
  let start = 0;
  while (start < least && old[start] === text[start]) start += 1;
  let same = 0;
  while (same < least - start && old[old.length - 1 - same] === text[text.length - 1 - same]) same += 1;
  // The two halves of a letter beyond 16 bits stay together.
  if (isHighHalf(old[start - 1])) start -= 1;
  if (same > 0 && isHighHalf(old[old.length - 1 - same])) same -= 1;
  return { start, end: old.length - same, inserted: text.slice(start, text.length - same) };
}

const isHighHalf = (unit) => unit >= "\ud800" && unit <= "\udbff";

/** Where a place of the old text is after an edit. */
function moved(place, { start, end, inserted }) {
  if (place <= start) return place;
  return place >= end ? place - end + start + inserted.length : Math.min(place, start + inserted.length);
}

const asMarkup = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

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
