// The notice over the picture: at most one, the most pressing, with what can be done about it.

import { byId } from "./element.js";

const buttons = ["retry", "reload", "overwrite", "draw-anyway"];

/** Shows the first notice that holds. Each says whether it does, its text, and the buttons that belong to it; `isGrave` where nothing goes on. */
export function showNotice(notices) {
  const { text, offers, isGrave } = { text: "", offers: [], isGrave: false, ...notices.find(({ holds }) => holds) };
  // What is said already is not said again to those who listen.
  if (byId("notice-text").textContent !== text) byId("notice-text").textContent = text;
  byId("notice").hidden = text === "";
  byId("notice").classList.toggle("lost", isGrave);
  for (const id of buttons) byId(id).hidden = !offers.includes(id);
}
