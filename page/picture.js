// Pictures as bytes: the one that is being drawn, the one before, and where they differ.
//
// The bytes are kept here beside the canvas, as a canvas does not give back exactly what was put there where it is transparent.

const coarseKind = 0;
const headerLength = 16;

/** So many finished pictures are remembered: this one, the one before, and the one before that, which is the one before again when this one's rendering is given up. */
const kept = 3;

const isSame = (one, other) => one.render === other?.render && one.version === other.version;

/** A picture: its size and its bytes, four a pixel. */
export class Picture {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.image = new ImageData(width, height);
  }

  get data() {
    return this.image.data;
  }

  /** Red, green, blue and alpha of a pixel; null outside of the picture. */
  at(column, row) {
    if (column < 0 || row < 0 || column >= this.width || row >= this.height) return null;
    const k = 4 * (row * this.width + column);
    return [...this.data.subarray(k, k + 4)];
  }

  /** Puts it on a canvas of its own size. */
  show(canvas) {
    canvas.width = this.width;
    canvas.height = this.height;
    canvas.getContext("2d").putImageData(this.image, 0, 0);
  }

  sameSize(other) {
    return this.width === other.width && this.height === other.height;
  }
}

/** The picture on the canvas: the old one stays until the first rows of the new one come; coarse blocks stay until the rows come. */
export class Drawing {
  constructor(canvas) {
    this.canvas = canvas;
    this.picture = null;
    this.start = null;
    this.shown = null;
    this.history = [];
  }

  /** Whether all of the picture is there. */
  get isFinished() {
    return this.history.at(-1)?.picture === this.picture;
  }

  /** The last finished picture before this one. */
  get previous() {
    return this.history.findLast(({ start }) => !isSame(start, this.shown))?.picture ?? null;
  }

  /** A rendering begins. */
  begin(start) {
    this.start = start;
  }

  /** Takes rows in; says whether they were the first ones of their rendering. */
  take(buffer) {
    const header = new DataView(buffer);
    const [kind, render, length, count] = [0, 4, 8, 12].map((k) => header.getUint32(k, true));
    if (this.start?.render !== render) return false;
    const isFirst = this.shown !== this.start;
    if (isFirst) this.#turnOver();
    for (let i = 0, at = headerLength; i < count; i++, at += 4 + length) {
      const row = header.getUint32(at, true);
      const bytes = new Uint8Array(buffer, at + 4, length);
      if (kind === coarseKind) this.#coarseRow(row, bytes);
      else this.#fineRow(row, bytes);
    }
    return isFirst;
  }

  /** The rendering has come to its end. The program may send a picture once more: the last good one when a newer one is given up, and all after a lost connection. */
  end(render) {
    if (this.shown?.render !== render) return;
    this.history = [...this.history.filter(({ start }) => !isSame(start, this.shown)), { start: this.shown, picture: this.picture }].slice(-kept);
  }

  /** The first rows of a new picture. */
  #turnOver() {
    const { width, height } = this.start;
    const old = this.picture;
    this.picture = new Picture(width, height);
    if (old && this.picture.sameSize(old)) this.picture.data.set(old.data);
    else this.picture.show(this.canvas);
    this.isFine = new Uint8Array(height);
    this.shown = this.start;
  }

  #fineRow(row, bytes) {
    const { width, height, data } = this.picture;
    if (row >= height || bytes.length !== 4 * width) return;
    data.set(bytes, 4 * width * row);
    this.isFine[row] = 1;
    this.#put(row, 1);
  }

  #coarseRow(k, bytes) {
    const { width, height, data } = this.picture;
    const block = this.start.coarse;
    for (let row = block * k; row < Math.min(height, block * (k + 1)); row++) {
      if (this.isFine[row]) continue;
      for (let column = 0; column < width; column++) {
        const from = 4 * Math.floor(column / block);
        data.set(bytes.subarray(from, from + 4), 4 * (row * width + column));
      }
      this.#put(row, 1);
    }
  }

  #put(row, rows) {
    this.canvas.getContext("2d").putImageData(this.picture.image, 0, 0, 0, row, this.picture.width, rows);
  }
}

/** Where two pictures of one size differ: how many pixels, by how much at most, where first, and a picture that marks them on a pale one. */
export function differences(now, before) {
  const marked = new Picture(now.width, now.height);
  let [count, largest, first] = [0, 0, null];
  for (let k = 0; k < now.data.length; k += 4) {
    let distance = 0;
    for (let c = 0; c < 4; c++) distance = Math.max(distance, Math.abs(now.data[k + c] - before.data[k + c]));
    if (distance > 0) {
      count += 1;
      first ??= { column: (k / 4) % now.width, row: Math.floor(k / 4 / now.width) };
      largest = Math.max(largest, distance);
      marked.data.set([214, 0, 110, 255], k);
    } else {
      const grey = 190 + 0.22 * (0.3 * now.data[k] + 0.59 * now.data[k + 1] + 0.11 * now.data[k + 2]);
      marked.data.set([grey, grey, grey, 255], k);
    }
  }
  return { count, largest, first, marked };
}
