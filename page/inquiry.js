// The question why a pixel has its colour: asked of the program, answered in the panel and with rays over the picture.
//
// The answer is about a rendering. Its rays are drawn by that rendering's projection, and the question is asked again when the next one is done.

import { announce, patience } from "./announcement.js";
import { byId } from "./element.js";
import { clearRays, drawRays } from "./rays.js";
import { tellStory } from "./story.js";
import { say } from "./words.js";

const renderingsKept = 3;

export class Inquiry {
  /** `tell` says something to the program; `scale` is the picture's on the screen. */
  constructor({ tell, scale }) {
    Object.assign(this, { tell, scale });
    Object.assign(this, { id: 0, pixel: null, story: null, render: null });
    this.projections = new Map();
  }

  /** Another run of the program counts its renderings anew. */
  greet() {
    this.projections.clear();
  }

  /** A rendering begins. */
  begin({ render, projection }) {
    this.projections.set(render, projection);
    for (const one of this.projections.keys()) if (this.projections.size > renderingsKept && one !== this.render) this.projections.delete(one);
  }

  ask(pixel) {
    this.pixel = pixel;
    this.id += 1;
    byId("story").hidden = false;
    byId("story").classList.add("waiting");
    byId("story").dataset.column = pixel.column;
    byId("story").dataset.row = pixel.row;
    byId("story-title").textContent = say("storyOf", pixel.column, pixel.row);
    document.body.classList.add("has-story");
    if (!this.tell({ type: "explain", id: this.id, ...pixel })) byId("story-note").textContent = say("lost");
  }

  /** Asks the same again. */
  repeat() {
    if (this.pixel) this.ask(this.pixel);
  }

  /** The answer. */
  take({ id, render, story, text }) {
    if (id !== this.id || !this.pixel) return;
    Object.assign(this, { story, render });
    byId("story").classList.remove("waiting");
    byId("story-note").textContent = "";
    tellStory(story, text);
    this.showRays(true);
    announce(byId("story-content").querySelector(".answer").textContent);
  }

  /** There is no answer, and why. */
  refuse(id, why) {
    if (id !== this.id) return;
    this.story = null;
    byId("story").classList.remove("waiting");
    byId("story-note").textContent = why;
    byId("story-content").replaceChildren();
    clearRays();
  }

  /** Says that the answer is about another rendering than the one that is being drawn. */
  age({ render, seconds }) {
    if (this.story && this.render !== render && seconds > patience) byId("story-note").textContent = say("stale");
  }

  showRays(isNew) {
    const projection = this.projections.get(this.render);
    if (this.story && projection) drawRays(this.story, projection, this.scale(), isNew);
    else clearRays();
  }

  close() {
    if (byId("story").hidden) return;
    const hadFocus = byId("story").contains(document.activeElement);
    byId("story").hidden = true;
    delete byId("story").dataset.column;
    delete byId("story").dataset.row;
    byId("story-content").replaceChildren();
    document.body.classList.remove("has-story");
    Object.assign(this, { pixel: null, story: null, render: null });
    clearRays();
    if (hadFocus) byId("picture").focus();
  }
}
