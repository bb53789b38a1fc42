// The rays of a story over the picture: reflected and refracted ones from hit to hit, and the ways to the lights.
//
// Points are carried to the screen in homogeneous coordinates: (X, Y, W) = M (x, y, z, w), seen at (X / W, Y / W). A direction has w = 0, so
// a ray that meets nothing, or the way to a light at infinity, ends in a point like any other. A segment is clipped before the division, to
// the sides of a frame around the picture: what lies behind the eye has W < 0 and falls away with them.

import { byId, drawn } from "./element.js";
import { named } from "./tree.js";

const mostRays = 400;
const mostNames = 12;
const margin = 1;

/** Draws a story, given M and the picture's scale on the screen; one that is new ray by ray, in the order in which they are followed. The first ray is a point: the pixel. */
export function drawRays(story, projection, scale, isNew) {
  const frame = { projection, scale, width: story.width, height: story.height, names: [] };
  const rays = story.samples.slice(0, 1).flatMap((sample) => named("1", sample.ray, mostRays));
  byId("overlay").classList.toggle("new", isNew);
  byId("overlay").replaceChildren(
    drawn("defs", {}, ["reflection", "refraction"].map((cause) => drawn("marker", { id: `arrow-${cause}`, viewBox: "0 0 8 8", refX: 4, refY: 4, markerWidth: 8, markerHeight: 8, markerUnits: "userSpaceOnUse", orient: "auto" }, drawn("path", { class: `arrow ${cause}`, d: "M 1 0.5 L 7.5 4 L 1 7.5 z" })))),
    ...rays.map(([name, ray], k) => group(name, ray, k, frame)),
  );
}

/** Takes them away. */
export const clearRays = () => byId("overlay").replaceChildren();

/** Makes one ray stand out, with the ways to its lights; none if the name is null. */
export function chooseRay(name) {
  for (const one of byId("overlay").querySelectorAll("[data-ray]")) one.classList.toggle("chosen", one.dataset.ray === name);
  byId("overlay").classList.toggle("has-chosen", name !== null);
}

function group(name, ray, k, frame) {
  const from = [...ray.origin, 1];
  const to = ray.hit ? [...ray.hit.point, 1] : [...ray.direction, 0];
  const made = drawn("g", { class: `ray ${ray.cause}${ray.hit ? "" : " lost"}`, "data-ray": name, "data-hit": ray.hit ? "true" : "false" });
  if (ray.hit) made.append(drawn("g", { class: "ways" }, (ray.hit.lights ?? []).map((light) => way(light, ray.hit, frame))));
  if (ray.cause !== "camera") {
    const seen = segment(from, to, frame);
    if (seen) made.append(line(seen, "casing"), line(seen, "beam", `url(#arrow-${ray.cause})`));
  }
  const at = ray.hit && point(to, frame);
  if (at) {
    made.append(drawn("circle", { class: "hit", cx: at[0], cy: at[1], r: 3.5 }));
    if (k > 0 && k <= mostNames) made.append(nameAt(name, at, frame.names));
  }
  made.style.animationDelay = `${Math.min(k, 30) * 60}ms`;
  return made;
}

/** A ray's name beside its hit, at the first place around it that no other name has taken. */
function nameAt(name, [x, y], taken) {
  const width = 7 * name.length;
  const places = [-6, 14, -19, 27, -32, 40].flatMap((dy) => [[x + 7, y + dy], [x - 7 - width, y + dy]]);
  const isFree = ([left, base]) => taken.every((one) => Math.abs(one.base - base) > 12 || left > one.right || left + width < one.left);
  const [left, base] = places.find(isFree) ?? places[0];
  taken.push({ left, right: left + width, base });
  return drawn("text", { class: "ray-name", x: left, y: base }, name);
}

/** From the hit to a light; in shadow with a cross at what is in the way. */
function way(light, hit, frame) {
  if (light.arrival !== "arrives" && light.arrival !== "shadow") return null;
  const [x, y, z] = hit.point;
  const back = light.direction.map((c) => -c);
  const along = (s) => [x + s * back[0], y + s * back[1], z + s * back[2], 1];
  const end = light.distance === undefined ? [...back, 0] : along(light.distance);
  const seen = segment([x, y, z, 1], end, frame);
  const blocked = light.byDistance === undefined ? null : point(along(light.byDistance), frame);
  const source = light.distance === undefined ? null : point(end, frame);
  return drawn(
    "g",
    { class: `way ${light.arrival}`, "data-light": light.light },
    seen && [line(seen, "casing"), line(seen, "beam")],
    blocked && drawn("path", { class: "blocker", d: `M ${blocked[0] - 5} ${blocked[1] - 5} l 10 10 m 0 -10 l -10 10` }),
    source && drawn("circle", { class: "source", cx: source[0], cy: source[1], r: 5 }),
  );
}

function line([[x1, y1], [x2, y2]], name, arrow) {
  return drawn("polyline", { class: name, points: `${x1},${y1} ${(x1 + x2) / 2},${(y1 + y2) / 2} ${x2},${y2}`, "marker-mid": arrow });
}

const projected = (at, { projection }) => projection.map((row) => row.reduce((sum, m, k) => sum + m * at[k], 0));

const onScreen = ([x, y, w], { scale }) => [(scale * x) / w, (scale * y) / w];

/** Where a point is seen; null behind the eye or outside of the frame. */
function point(at, frame) {
  const p = projected(at, frame);
  return p[2] > 0 && planes(frame).every((plane) => plane(p) >= 0) ? onScreen(p, frame) : null;
}

/** The part of a segment that is seen, by its two ends; null if there is none. */
function segment(from, to, frame) {
  let [a, b] = [projected(from, frame), projected(to, frame)];
  for (const plane of planes(frame)) {
    const [da, db] = [plane(a), plane(b)];
    if (da < 0 && db < 0) return null;
    const between = () => a.map((c, k) => c + (da / (da - db)) * (b[k] - c));
    if (da < 0) a = between();
    else if (db < 0) b = between();
  }
  return a[2] > 0 && b[2] > 0 ? [onScreen(a, frame), onScreen(b, frame)] : null;
}

/** The sides of a frame wider than the picture, each not negative inside. Two opposite ones together say that W is not negative. */
function planes({ width, height }) {
  const [mx, my] = [margin * width, margin * height];
  return [([x, , w]) => x + mx * w, ([x, , w]) => (width + mx) * w - x, ([, y, w]) => y + my * w, ([, y, w]) => (height + my) * w - y];
}
