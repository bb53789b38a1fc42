// What is going on: the page's state, the line below the picture, the bar of progress, and the way to the finished picture.
//
// What the page is doing stands in `body[data-state]`: connecting, drawing, done, faults (the text cannot be drawn as it is), lost (the program
// cannot be reached) or refused (it runs, and does not know the page's token).

import { byId } from "./element.js";
import { withToken } from "./token.js";
import { counted, say, seconds } from "./words.js";

export class Status {
  constructor() {
    Object.assign(this, { phase: "connecting", told: null, height: 1, isGreeted: false, isLost: false, isRefused: false });
  }

  greet() {
    Object.assign(this, { isGreeted: true, isLost: false, isRefused: false });
  }

  lose() {
    Object.assign(this, { isLost: true, isRefused: false });
  }

  refuse() {
    Object.assign(this, { isLost: true, isRefused: true });
  }

  begin({ height }) {
    Object.assign(this, { phase: "drawing", told: null, height });
  }

  progress(message) {
    if (this.phase === "drawing") this.told = message;
  }

  end(message) {
    Object.assign(this, { phase: "done", told: message });
  }

  stop() {
    this.phase = "stopped";
  }

  show(hasFaults) {
    const { phase, told, isLost } = this;
    document.body.dataset.state = this.#state(hasFaults);
    byId("status").textContent = this.text;
    byId("progress").hidden = phase !== "drawing" || isLost;
    byId("progress").max = this.height;
    byId("progress").value = phase === "drawing" ? told?.rows ?? 0 : 0;
    const isDone = phase === "done" && !isLost;
    byId("download").toggleAttribute("aria-disabled", !isDone);
    if (isDone) Object.assign(byId("download"), { href: withToken(told.picture), download: told.name });
    else byId("download").removeAttribute("href");
  }

  #state(hasFaults) {
    if (this.isRefused) return "refused";
    if (this.isLost) return this.isGreeted ? "lost" : "connecting";
    if (hasFaults) return "faults";
    return this.phase === "stopped" ? "drawing" : this.phase;
  }

  get text() {
    const { phase, told } = this;
    const speed = told && told.seconds > 0 ? counted(Number((told.rays / told.seconds).toPrecision(3))) : "0";
    if (this.isLost || phase === "connecting") return this.isGreeted || this.isRefused ? "" : say("connecting");
    if (phase === "stopped") return say("stopped");
    if (phase === "drawing") return told ? say("drawingFor", seconds(told.seconds), speed) : say("drawing");
    return [say("drawn", seconds(told.seconds), counted(told.rays), speed), told.cut ? say("cut") : "", told.written ? say("written", told.written) : ""].filter(Boolean).join(" ");
  }
}
