// The picture beside the one before it: side by side, or with the pixels marked in which they differ.

import { byId } from "./element.js";
import { differences } from "./picture.js";
import { counted, percent, say } from "./words.js";

const modes = ["off", "side", "difference"];

export class Comparison {
  /** Of a drawing; `changed` is called when the stages change. */
  constructor(drawing, changed) {
    this.drawing = drawing;
    this.changed = changed;
    this.select = byId("compare");
    this.select.addEventListener("change", () => this.show());
  }

  get isOn() {
    return this.select.value !== "off";
  }

  /** The next way to compare. */
  next() {
    this.select.value = modes[(modes.indexOf(this.select.value) + 1) % modes.length];
    this.show();
  }

  /** Shows what there is to compare now. */
  show() {
    const mode = this.select.value;
    const { picture, isFinished, previous } = this.drawing;
    const isComparable = isFinished && previous?.sameSize(picture);
    byId("stages").dataset.compare = mode;
    byId("figure-previous").hidden = mode !== "side";
    byId("caption").hidden = byId("caption-previous").hidden = mode !== "side";
    byId("difference").hidden = mode !== "difference" || !isComparable;
    byId("difference-text").hidden = mode === "off";
    if (mode === "side" && previous) previous.show(byId("previous"));
    if (mode !== "off") byId("difference-text").textContent = this.#told(isComparable, mode);
    this.changed();
  }

  #told(isComparable, mode) {
    const { picture, previous } = this.drawing;
    const size = (one) => `${one.width} × ${one.height}`;
    if (!previous) return say("none");
    if (!previous.sameSize(picture)) return say("sizes", size(previous), size(picture));
    if (!isComparable) return say("waitToCompare");
    const { count, largest, first, marked } = differences(picture, previous);
    if (mode === "difference") marked.show(byId("difference"));
    return count === 0 ? say("same") : say("differ", counted(count), percent(count / (picture.width * picture.height)), largest, first);
  }
}
