// The keys that mean something on the whole page, and their list.

import { byId, element } from "./element.js";
import { keyList } from "./words.js";

/** Listens to the keys. `anywhere` has the acts of Ctrl and a key, `inPicture` those of a plain key while nothing is typed, `escape` that of Esc. */
export function listenToKeys({ anywhere, inPicture, escape }) {
  document.addEventListener("keydown", (event) => {
    const isInPicture = event.target === document.body || (event.target.closest("#looking, #story") && !event.target.closest("select"));
    const withControl = event.ctrlKey || event.metaKey;
    const acts = withControl ? anywhere : isInPicture && !event.altKey ? inPicture : {};
    if (event.key === "Escape" && !byId("keys").open) escape();
    else acts[event.key.toLowerCase()]?.(event);
  });
  byId("keys-button").addEventListener("click", showKeys);
  byId("close-keys").addEventListener("click", () => byId("keys").close());
}

/** Shows the list. */
export const showKeys = () => byId("keys").showModal();

/** Fills the list, in the language of the page. */
export const listKeys = () => byId("key-list").replaceChildren(...keyList().flatMap(([key, what]) => [element("dt", {}, element("kbd", {}, key)), element("dd", {}, what)]));
