// The scene's text: the one that lies on the program's desk, the one that is typed here and may not have arrived there, and whether the file has it.

import { Editor } from "./editor.js";
import { byId } from "./element.js";
import { say } from "./words.js";

export class SceneText {
  /** `tell` says something to the program, `isOpen` whether it can be told; `changed` is called when there is something to show. */
  constructor({ tell, isOpen, changed }) {
    Object.assign(this, { tell, isOpen, changed });
    Object.assign(this, { page: null, file: "", canSave: false, mostBytes: Infinity });
    // The version of the text that stands in the editor, or in which is typed there.
    this.version = 1;
    Object.assign(this, { text: "", isSaved: true, isInConflict: false, isFirst: true, sent: null, isUnsent: false, tooLong: null });
    this.editor = new Editor({
      typed: () => this.showSaved(),
      rested: () => this.send(),
    });
  }

  /** The program has greeted the page: it says which page this is, and of which file. */
  greet({ page, file, canSave, limits }) {
    Object.assign(this, { page, file, canSave, mostBytes: limits.text, isFirst: true });
  }

  /** Sends what is typed. */
  send() {
    const { text } = this.editor;
    const size = new TextEncoder().encode(text).length;
    this.tooLong = size > this.mostBytes ? size : null;
    this.isUnsent = this.tooLong !== null || !this.isOpen();
    // A text that is there already would not be answered.
    if (!this.isUnsent && (this.sent ?? this.text) !== text) {
      this.tell({ type: "edit", version: this.version, text });
      this.sent = text;
    }
    this.changed();
  }

  save(overwrite = false) {
    this.editor.flush();
    if (this.canSave) this.tell({ type: "save", overwrite });
  }

  /** The text on the desk. The page's own typing stays as it is; other texts replace it, but what was typed here and has not yet arrived there wins. */
  take({ version, text, saved, conflict, by, page }) {
    const isOwn = by === "page" && page === this.page;
    const isWaiting = this.sent !== null && this.sent !== text;
    Object.assign(this, { text, isSaved: saved, isInConflict: conflict === true });
    if (this.isFirst) {
      const isTyped = this.isUnsent || this.editor.isPending || this.sent !== null;
      this.isFirst = false;
      this.version = version;
      this.sent = null;
      if (!isTyped) this.editor.replace(text);
      else if (!this.editor.isPending) this.send();
      return;
    }
    const isFree = !this.editor.isPending && !this.isUnsent;
    if (isOwn || isFree) this.version = version;
    if (isOwn && isWaiting) return;
    this.sent = null;
    if (isFree) this.editor.replace(text);
  }

  /** Says whether the file has it. */
  showSaved() {
    const isSaved = this.isSaved && !this.editor.isPending && !this.isUnsent && this.sent === null;
    byId("file").textContent = this.file;
    byId("saved").textContent = this.file ? say(isSaved ? "saved" : "unsaved") : "";
    byId("saved").classList.toggle("unsaved", !isSaved);
    byId("save").disabled = !this.canSave || isSaved || !this.isOpen();
    document.title = this.file ? `${isSaved ? "" : "• "}${this.file} – Dioptre` : "Dioptre";
  }
}
