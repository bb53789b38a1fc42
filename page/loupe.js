// How the picture is looked at: the zoom, the part that is seen, and the cursor on one pixel.
//
// Two stages, one for the picture and one for the picture before, are zoomed and scrolled together. A scale of 8 shows each pixel as 8 by 8.

import { byId } from "./element.js";

const scales = [0.125, 0.25, 0.5, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
const gridFrom = 8;
const smallestCursor = 7;

export class Loupe {
  /** Told of `look` (a pixel or null, and whether it was by the keyboard), `pick` (a pixel) and `scaled`. */
  constructor(listener) {
    this.listener = listener;
    this.stages = [byId("stage"), byId("stage-previous")];
    this.canvas = byId("picture");
    this.size = { width: 0, height: 0 };
    this.zoom = "fit";
    this.scale = 1;
    this.cursor = null;
    for (const stage of this.stages) {
      const sheet = stage.querySelector(".sheet");
      sheet.addEventListener("pointermove", (event) => listener.look(this.#pixelUnder(event, sheet), false));
      sheet.addEventListener("pointerleave", () => listener.look(this.cursor, false));
      sheet.addEventListener("click", (event) => this.#pick(this.#pixelUnder(event, sheet)));
      stage.addEventListener("scroll", () => this.#together(stage));
      stage.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
      new ResizeObserver(() => this.layOut()).observe(stage);
    }
    this.canvas.addEventListener("keydown", (event) => this.#key(event));
    byId("zoom-in").addEventListener("click", () => this.step(1));
    byId("zoom-out").addEventListener("click", () => this.step(-1));
    byId("zoom-fit").addEventListener("click", () => this.fit());
  }

  /** Looks at pictures of another size. */
  resize(width, height) {
    if (this.size.width === width && this.size.height === height) return;
    this.size = { width, height };
    if (this.cursor && (this.cursor.column >= width || this.cursor.row >= height)) this.cursor = null;
    this.layOut();
  }

  fit() {
    this.zoom = "fit";
    this.layOut();
  }

  /** The next scale in that direction, with the pixel at an anchor (by default the cursor, or the middle) staying where it is. */
  step(direction, anchor = this.#anchor()) {
    const next = direction > 0 ? scales.find((s) => s > this.scale * 1.001) : scales.findLast((s) => s < this.scale * 0.999);
    if (next === undefined) return;
    const stage = this.stages[0];
    this.zoom = next;
    this.layOut();
    const sheet = stage.querySelector(".sheet");
    stage.scrollTo(sheet.offsetLeft + anchor.x * next - anchor.dx, sheet.offsetTop + anchor.y * next - anchor.dy);
  }

  /** Puts the cursor on a pixel, or takes it away. */
  place(pixel) {
    this.cursor = pixel;
    this.#placeCursor();
  }

  /** Gives the sheets their size on the screen. */
  layOut() {
    const { width, height } = this.size;
    if (width === 0) return;
    if (this.zoom === "fit") this.scale = fitting(this.stages[0], width, height);
    else this.scale = this.zoom;
    for (const stage of this.stages) {
      const sheet = stage.querySelector(".sheet");
      sheet.style.width = `${width * this.scale}px`;
      sheet.style.height = `${height * this.scale}px`;
      sheet.classList.toggle("pixelated", this.scale >= 2 || Number.isInteger(this.scale));
      const grid = sheet.querySelector(".grid");
      grid.hidden = this.scale < gridFrom;
      grid.style.backgroundSize = `${this.scale}px ${this.scale}px`;
    }
    byId("zoom").textContent = `${Math.round(100 * this.scale)}\u202f%`;
    this.#placeCursor();
    this.listener.scaled(this.scale);
  }

  #placeCursor() {
    for (const stage of this.stages) {
      const mark = stage.querySelector(".cursor");
      mark.hidden = this.cursor === null;
      if (this.cursor === null) continue;
      const side = Math.max(smallestCursor, this.scale);
      const middle = (k) => (k + 0.5) * this.scale - side / 2;
      mark.style.width = mark.style.height = `${side}px`;
      mark.style.transform = `translate(${middle(this.cursor.column)}px, ${middle(this.cursor.row)}px)`;
    }
  }

  #pick(pixel) {
    if (!pixel) return;
    this.canvas.focus({ preventScroll: true });
    this.place(pixel);
    this.listener.look(pixel, false);
    this.listener.pick(pixel);
  }

  #pixelUnder(event, sheet) {
    const box = sheet.getBoundingClientRect();
    const column = Math.floor((event.clientX - box.left) / this.scale);
    const row = Math.floor((event.clientY - box.top) / this.scale);
    const { width, height } = this.size;
    return column >= 0 && row >= 0 && column < width && row < height ? { column, row } : null;
  }

  /** The point of the picture that a change of scale keeps in place: in pixels of the picture, and where in the stage it is. */
  #anchor() {
    const stage = this.stages[0];
    const sheet = stage.querySelector(".sheet").getBoundingClientRect();
    const box = stage.getBoundingClientRect();
    if (this.cursor) return { x: this.cursor.column + 0.5, y: this.cursor.row + 0.5, dx: stage.clientWidth / 2, dy: stage.clientHeight / 2 };
    const [dx, dy] = [stage.clientWidth / 2, stage.clientHeight / 2];
    return { x: (box.left + dx - sheet.left) / this.scale, y: (box.top + dy - sheet.top) / this.scale, dx, dy };
  }

  #wheel(event) {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const stage = event.currentTarget;
    const sheet = stage.querySelector(".sheet").getBoundingClientRect();
    const box = stage.getBoundingClientRect();
    const at = { x: (event.clientX - sheet.left) / this.scale, y: (event.clientY - sheet.top) / this.scale };
    this.step(event.deltaY < 0 ? 1 : -1, { ...at, dx: event.clientX - box.left, dy: event.clientY - box.top });
  }

  #key(event) {
    const far = event.shiftKey ? 10 : 1;
    const way = { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] }[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey || this.size.width === 0) return;
    if (way) {
      event.preventDefault();
      this.#move(...way);
    } else if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      this.#pick(this.cursor ?? this.#middle());
    }
  }

  #middle() {
    return { column: Math.floor(this.size.width / 2), row: Math.floor(this.size.height / 2) };
  }

  #move(right, down) {
    const from = this.cursor;
    const within = (k, size) => Math.min(size - 1, Math.max(0, k));
    const to = from ? { column: within(from.column + right, this.size.width), row: within(from.row + down, this.size.height) } : this.#middle();
    this.place(to);
    this.#reveal(to);
    this.listener.look(to, true);
  }

  /** Scrolls so that a pixel is seen. */
  #reveal({ column, row }) {
    const stage = this.stages[0];
    const margin = Math.max(24, 2 * this.scale);
    const into = (scroll, seen, at) => Math.max(at + margin - seen, Math.min(at - margin, scroll));
    const sheet = stage.querySelector(".sheet");
    stage.scrollTo(into(stage.scrollLeft, stage.clientWidth, sheet.offsetLeft + (column + 0.5) * this.scale), into(stage.scrollTop, stage.clientHeight, sheet.offsetTop + (row + 0.5) * this.scale));
  }

  #together(stage) {
    const other = this.stages.find((one) => one !== stage);
    if (other.scrollTop !== stage.scrollTop) other.scrollTop = stage.scrollTop;
    if (other.scrollLeft !== stage.scrollLeft) other.scrollLeft = stage.scrollLeft;
  }
}

/** The scale at which all of a picture is seen: pixels stay whole where each is seen large. */
function fitting(stage, width, height) {
  const style = getComputedStyle(stage);
  const room = Math.min((stage.clientWidth - 2 * parseFloat(style.paddingLeft)) / width, (stage.clientHeight - 2 * parseFloat(style.paddingTop)) / height);
  if (room <= 0) return 1;
  return room >= 2 ? Math.floor(room) : room;
}
