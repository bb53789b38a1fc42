// Numbers, vectors and colours, as they are shown: short, with all their digits in the title.
//
// They are written as in scenes, with a decimal point, whatever the language, so that they can be copied there. Only times and counts
// of the rendering follow the language (words.js).

import { element } from "./element.js";

/** A number in about as many digits. */
export function short(x, digits = 6) {
  const size = Math.abs(x);
  if (size === 0) return "0";
  if (size >= 1e-4 && size < 1e7) return String(Number(x.toPrecision(digits)));
  return x.toExponential(3).replace(/\.?0+e/, "e").replace("e+", "e");
}

/** Several numbers in brackets. */
export const brackets = (xs, digits) => `[${xs.map((x) => short(x, digits)).join(", ")}]`;

/** A number or a vector, short, with all digits in the title. */
export const value = (x, digits) =>
  element("span", { class: "value", title: Array.isArray(x) ? `[${x.join(", ")}]` : String(x) }, Array.isArray(x) ? brackets(x, digits) : short(x, digits));

/** An angle in radians, shown in degrees. */
export const degrees = (angle) => element("span", { class: "value", title: `${(angle * 180) / Math.PI}°` }, `${short((angle * 180) / Math.PI, 5)}°`);

/** A small field of a colour with channels from 0 to 1. */
export function swatch(colour) {
  const field = element("span", { class: "swatch", "aria-hidden": "true" });
  field.style.backgroundColor = `rgb(${colour.slice(0, 3).map((c) => Math.round(255 * Math.min(1, Math.max(0, c)))).join(" ")})`;
  return field;
}

/** A colour as a field and as numbers. */
export const colour = (c) => element("span", { class: "colour" }, swatch(c), value(c, 4));

/** The four bytes of a pixel. */
export const bytes = (pixel) => `(${[...pixel].join(", ")})`;
