// The number line of a shape's roots: where along the ray t fulfils which condition, between the near and the far limit.
//
// A shape with one equation has its roots on the line itself. One with several conditions, all of which must hold, has a lane for each
// above the line: for a range of t a bar, for an equation its roots.

import { drawn } from "./element.js";
import { short } from "./figures.js";
import { say, sayIn } from "./words.js";

const width = 390;
const [left, right] = [14, 376];
const laneHeight = 15;
const labelHeight = 13;

/** The line of an encounter, for a ray that sees as far as `far`. */
export function numberLine(encounter, far) {
  const { roots, conditions } = encounter;
  const { low, high } = span(roots, far);
  const x = (t) => left + ((Math.min(high, Math.max(low, t)) - low) / (high - low)) * (right - left);
  const lanes = conditions.length > 1 ? conditions.map((_, k) => k).filter((k) => conditions[k].of !== "reach") : [];
  const axis = 8 + lanes.length * laneHeight + 12;
  const laneOf = (root) => (lanes.includes(root.condition) ? 8 + lanes.indexOf(root.condition) * laneHeight + 6 : axis);
  const labelled = labels(roots, x);
  const height = axis + 12 + labelHeight * (1 + Math.max(0, ...labelled.map((one) => one.level)));
  const kept = roots.find((root) => root.fate === "kept");
  const isFarSeen = far <= high;
  return drawn(
    "svg",
    { class: "number-line", viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": roots.length > 0 ? say("numberLine", roots.map((root) => `${short(root.t)} (${sayIn("fate", root.fate)})`).join(", ")) : say("noRoots") },
    lanes.map((k, i) => lane(conditions[k], roots.filter((root) => root.condition === k), x, 8 + i * laneHeight + 6)),
    drawn("line", { class: "behind", x1: left, x2: x(0), y1: axis, y2: axis }),
    drawn("line", { class: "seen", x1: x(0), x2: x(far), y1: axis, y2: axis }),
    isFarSeen ? drawn("line", { class: "behind", x1: x(far), x2: right, y1: axis, y2: axis }) : drawn("path", { class: "break", d: `M ${right - 9} ${axis + 5} l 5 -10 M ${right - 4} ${axis + 5} l 5 -10` }),
    limit(x(0), axis, say("origin"), "near"),
    limit(isFarSeen ? x(far) : right, axis, `${say("far")} ${short(far)}`, "far-limit"),
    kept && drawn("line", { class: "kept-line", x1: x(kept.t), x2: x(kept.t), y1: 2, y2: axis + 8 }),
    roots.map((root) => tick(root, x(root.t), laneOf(root))),
    labelled.map(({ root, at, level }) => drawn("text", { class: `label ${root.fate}`, x: at, y: axis + 19 + level * labelHeight, "text-anchor": "middle" }, root.t < low ? `‹ ${short(root.t, 4)}` : root.t > high ? `${short(root.t, 4)} ›` : short(root.t, 4))),
  );
}

/** What part of the line is drawn: from the origin over the roots, the farthest ones left out at an edge. */
function span(roots, far) {
  const before = roots.map((root) => root.t).filter((t) => t >= 0 && t < far);
  const behind = roots.map((root) => root.t).filter((t) => t < 0);
  const reach = Math.max(0, ...before) || Math.min(far, Math.max(1, ...behind.map(Math.abs)));
  const high = roots.some((root) => root.t >= far) ? far * 1.1 : Math.min(1.25 * reach, far * 1.1);
  const low = behind.length > 0 ? Math.max(Math.min(...behind) - 0.08 * high, -0.7 * high) : -0.08 * high;
  return { low, high };
}

function limit(x, axis, text, name) {
  return [drawn("line", { class: `limit ${name}`, x1: x, x2: x, y1: axis - 7, y2: axis + 7 }), drawn("text", { class: "limit-label", x: Math.min(x, right), y: axis - 10, "text-anchor": name === "near" ? "middle" : "end" }, text)];
}

/** A root: filled where it is kept, a ring where the shape is met again, a cross where it is not on the shape, faint where it is not seen. */
function tick(root, x, y) {
  const attributes = { class: `tick ${root.fate}`, "data-fate": root.fate, "data-t": root.t };
  const title = drawn("title", {}, `t = ${root.t}: ${sayIn("fate", root.fate)}`);
  if (root.fate === "outside") return drawn("path", { ...attributes, d: `M ${x - 3.2} ${y - 3.2} l 6.4 6.4 m 0 -6.4 l -6.4 6.4` }, title);
  return drawn("circle", { ...attributes, cx: x, cy: y, r: root.fate === "kept" ? 5 : 3.6 }, title);
}

function lane(condition, roots, x, y) {
  const ends = condition.rate && fulfilled(condition, roots, x);
  return [drawn("line", { class: "lane", x1: left, x2: right, y1: y, y2: y }), ends && drawn("rect", { class: "range", x: ends[0], y: y - 3.5, width: Math.max(1, ends[1] - ends[0]), height: 7 })];
}

/** Where a range of t begins and ends on the screen; a condition without roots holds everywhere or nowhere. */
function fulfilled({ low, high, start }, roots, x) {
  if (roots.length === 2) return roots.map((root) => x(root.t));
  return low <= start.value && start.value <= high ? [left, right] : null;
}

/** Where the roots' values are written: the kept one first, each in the highest row that is free there. */
function labels(roots, x) {
  const rows = [];
  const ordered = [...roots].sort((a, b) => (b.fate === "kept") - (a.fate === "kept") || a.t - b.t);
  const seen = new Set();
  return ordered
    .filter((root) => !seen.has(root.t) && seen.add(root.t))
    .map((root) => {
      const half = 4 + 3.2 * (short(root.t, 4).length + 1);
      const at = Math.min(right + 8 - half, Math.max(left - 8 + half, x(root.t)));
      let level = rows.findIndex((row) => row.every(([a, b]) => at + half < a || at - half > b));
      if (level < 0) level = rows.push([]) - 1;
      rows[level].push([at - half, at + half]);
      return { root, at, level };
    });
}
