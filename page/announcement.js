// What is said to those who listen to the page instead of looking at it.

import { byId } from "./element.js";

/** What lasts longer, in seconds, is worth a word. */
export const patience = 1;

let waiting = null;

/** Says it now. */
export function announce(text) {
  clearTimeout(waiting);
  byId("announcement").textContent = text;
}

/** Says it when there has been nothing else to say for a while: somebody is typing. */
export function announceLater(text) {
  clearTimeout(waiting);
  waiting = setTimeout(() => announce(text), 1000 * patience);
}
