// The line that says which pixel is looked at, and its four bytes.

import { announce } from "./announcement.js";
import { byId, element } from "./element.js";
import { bytes, swatch } from "./figures.js";
import { say } from "./words.js";

/** Tells of a pixel of a picture, and of the same pixel of the picture before if there is one. Where there is no pixel, it says how to ask about one. */
export function readOut(pixel, picture, previous, byKeyboard) {
  const at = pixel && picture?.at(pixel.column, pixel.row);
  if (!at) return byId("readout").replaceChildren(element("span", { class: "aside" }, say("pixelHint")));
  const field = (four) => [swatch(four.map((byte) => byte / 255)), " ", bytes(four)];
  const before = previous?.at(pixel.column, pixel.row);
  byId("readout").replaceChildren(...[say("pixel", pixel.column, pixel.row), "  ", field(at), before ? [`  ${say("was")} `, field(before)] : []].flat(Infinity));
  if (byKeyboard) announce(`${say("pixel", pixel.column, pixel.row)}: ${at.join(" ")}`);
}
