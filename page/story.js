// The story of a pixel: the tree of its rays with the shapes that each was tried on, the light where it hits, and the way to four bytes.
//
// It is built from the object that `dioptre explain --format json` prints; what that holds is told in src/Dioptre/Explain/Json.hs.

import { byId, drawn, element, folded } from "./element.js";
import { bytes, colour, degrees, short, swatch, value } from "./figures.js";
import { numberLine } from "./roots.js";
import { chooseRay } from "./rays.js";
import { bouncesOf, named } from "./tree.js";
import { counted, say, sayIn } from "./words.js";

const shapesTold = 8;
const raysAdded = 8;
const samplesTold = 16;
const raysSearched = 400;

/** Fills the panel with a story and its text. */
export function tellStory(story, text) {
  const [first] = story.samples;
  const several = story.sampling > 1;
  byId("story-content").replaceChildren(
    ...[
      element("p", { class: "answer" }, swatch(story.pixel.slice(0, 3).map((byte) => byte / 255)), element("strong", {}, bytes(story.pixel)), " ", answer(story)),
      element("p", { class: "aside" }, say("light", story.algorithm, story.level)),
      several ? story.samples.slice(0, samplesTold).map((sample, k) => folded({ class: "sample" }, [say("through", k + 1, short(sample.offset[0], 4), short(sample.offset[1], 4)), " ", colour(sample.colour)], () => rayStory("1", sample.ray, story), k === 0)) : rayStory("1", first.ray, story),
      several && story.sampling > samplesTold && element("p", { class: "aside" }, say("andMore", story.sampling - samplesTold)),
      part(say("colour"), ...sum(story)),
      legend(first.ray),
      folded({ class: "in-words" }, say("inWords"), () => element("pre", {}, text)),
    ]
      .flat(Infinity)
      .filter(Boolean),
  );
}

const part = (title, ...content) => element("section", { class: "part" }, element("h4", {}, title), ...content);

function answer(story) {
  if (story.sampling > 1) return say("manyRays", story.sampling);
  const { hit } = story.samples[0].ray;
  return hit ? say("sees", shapeName(hit.shape)) : say("seesNothing");
}

/** A shape by its kind and material, or its model. */
function shapeName(shape) {
  const kind = sayIn("kind", shape.kind);
  if (shape.primitive !== undefined) return `${kind}${shape.material === undefined ? "" : ` ${say("quoted", shape.material)}`} (${say("primitive", shape.primitive + 1)})`;
  return `${kind} (${say("ofModel", shape.part + 1, shape.file ?? say("model", shape.model + 1))})`;
}

// Rays

function rayStory(name, ray, story) {
  const isFirst = ray.cause === "camera";
  return element(
    "section",
    { class: `ray-story ${ray.cause}`, "data-ray": name, tabindex: -1, pointerover: choosing(name), focusin: choosing(name), pointerleave: choosing(null) },
    element("h3", {}, `${say("ray", name)}, ${sayIn("cause", ray.cause)}`, " ", element("span", { class: "formula" }, "r(t) = o + t d")),
    definitions([
      ["o", value(ray.origin)],
      ["d", value(ray.direction)],
    ]),
    !isFirst &&
      definitions([
        [say("weight"), value(ray.weight)],
        [say("index"), value(ray.index)],
      ]),
    trials(ray, story.far, isFirst),
    ray.hit ? hitStory(name, ray, story) : element("p", {}, say("meetsNothing")),
  );
}

/** The ray under the pointer, or with the focus, stands out on the picture. */
const choosing = (name) => (event) => {
  event.stopPropagation();
  chooseRay(name);
};

const definitions = (pairs) => element("dl", {}, pairs.filter(Boolean).map(([name, ...told]) => [element("dt", {}, name), element("dd", {}, told)]));

// Shapes that a ray was tried on

function trials(ray, far, isFirst) {
  const order = (e) => (e.verdict === "closest" ? -1 : e.t ?? (e.roots.length > 0 ? 1e100 : 1e101));
  const encounters = [...ray.encounters].sort((a, b) => order(a) - order(b));
  const count = encounters.length + ray.notMet + ray.untold;
  if (count === 0) return element("p", {}, say("noShape"));
  const one = (e, k) => encounter(e, far, isFirst && k === 0);
  return folded(
    { class: "trials" },
    say("tried", counted(count)),
    () => [
      encounters.slice(0, shapesTold).map(one),
      encounters.length > shapesTold && folded({ class: "more" }, say("moreShapes", encounters.length - shapesTold), () => encounters.slice(shapesTold).map((e) => encounter(e, far, false))),
      ray.notMet > 0 && element("p", { class: "aside" }, say("others", counted(ray.notMet))),
      ray.untold > 0 && element("p", { class: "aside" }, say("untold", counted(ray.untold))),
    ],
    isFirst,
  );
}

function encounter(e, far, open) {
  const { shape } = e;
  const summary = [
    element("span", { class: "shape" }, shapeName(shape)),
    e.t !== undefined && element("span", { class: "at" }, "t = ", value(e.t)),
    element("span", { class: "verdict" }, sayIn("verdict", e.verdict), shape.transformed ? ` · ${say("transformed")}` : ""),
  ];
  return folded({ class: `encounter ${e.verdict}`, "data-shape": shape.number, "data-verdict": e.verdict }, summary, () => equation(e, far), open);
}

function equation(e, far) {
  const letter = e.moved ? "s" : "t";
  return element(
    "div",
    { class: "equation" },
    e.frame && [element("p", { class: "aside" }, say("ownFrame")), definitions([["o", value(e.frame.origin)], ["d", value(e.frame.direction)]])],
    e.moved && element("p", { class: "formula" }, e.moved.k === 1 ? "t = t0 + s" : "t = (t0 + s) k", ", t0 = ", value(e.moved.t0), e.moved.k === 1 ? null : [", k = ", value(e.moved.k)]),
    e.conditions.map((condition) => conditionOf(condition, letter)),
    numberLine(e, far),
    element("ul", { class: "roots" }, e.roots.map((root) => rootOf(root, e.conditions.length > 1))),
  );
}

function conditionOf(condition, letter) {
  if (condition.of === "reach") return element("p", {}, say("reach", short(condition.distance), short(condition.reach)));
  const name = condition.of.startsWith("faces ") ? say("faces", condition.of.slice("faces ".length)) : sayIn("patch", condition.of);
  const title = (formula) => element("p", { class: "condition" }, element("span", { class: "patch" }, name), " ", element("span", { class: "formula" }, formula));
  if (condition.rate) {
    const { rate, start, low, high } = condition;
    return [title(`${short(low)} ≤ ${start.formula} + ${rate.formula} ${letter} ≤ ${short(high)}`), coefficients([{ ...start, name: "" }, { ...rate, name: "" }])];
  }
  const variable = condition.shift ? `${letter}′` : letter;
  return [
    title(`${polynomial(condition.degree, variable)}${condition.shift ? `, ${letter} = ${variable} + ${short(condition.shift)}` : ""}`),
    coefficients([...condition.coefficients, ...(condition.discriminant === undefined ? [] : [{ name: "", formula: "B² - 4 A C", value: condition.discriminant }])]),
    element("p", { class: "letters" }, `${say("where")} `, condition.letters.map(powers).join(", ")),
  ];
}

const powers = (text) => text.replace(/\^2/g, "²").replace(/\^3/g, "³").replace(/\^4/g, "⁴");

const polynomial = (degree, letter) => `${[..."ABCDE"].slice(0, degree + 1).map((name, k) => `${name}${["", ` ${letter}`, ` ${letter}²`, ` ${letter}³`, ` ${letter}⁴`][degree - k]}`).join(" + ")} = 0`;

const coefficients = (rows) =>
  element("table", { class: "coefficients" }, element("tbody", {}, rows.map((c) => element("tr", {}, element("th", { scope: "row" }, c.name), element("td", { class: "formula" }, `${c.name ? "= " : ""}${powers(c.formula)}`), element("td", {}, "= ", value(c.value, 8))))));

const marks = { kept: "●", outside: "✕" };

function rootOf(root, hasOthers) {
  const fate = root.fate === "outside" && !root.measured && hasOthers ? say("elsewhere") : sayIn("fate", root.fate);
  return element(
    "li",
    { class: `root ${root.fate}`, "data-t": root.t, "data-fate": root.fate },
    element("span", { class: "mark", "aria-hidden": "true" }, marks[root.fate] ?? "○"),
    " t = ",
    value(root.t, 8),
    " ",
    element("span", { class: "fate" }, fate),
    root.measured && (root.fate === "kept" || root.fate === "outside") && element("span", { class: "measured" }, measuredAt(root.measured)),
  );
}

/** What was measured at a root's point, to know whether it is on the shape. */
function measuredAt({ distance, radius, innerRadius, t1, t2, height, length }) {
  if (t1 !== undefined) return `t1 = ${short(t1)}, t2 = ${short(t2)}, 1 - t1 - t2 = ${short(1 - t1 - t2)}`;
  if (height !== undefined) return sayIn("measured", "height", short(height), short(length));
  if (innerRadius !== undefined) return sayIn("measured", "innerRadius", short(distance), short(innerRadius));
  return sayIn("measured", "radius", short(distance), short(radius));
}

// Hits

function hitStory(name, ray, story) {
  const { hit } = ray;
  const isTurned = hit.normal.some((c, k) => c !== hit.outward[k]);
  const bounces = bouncesOf(name, ray);
  return [
    part(
      say("hit"),
      element("p", { class: "shape" }, shapeName(hit.shape)),
      definitions([
        [say("point"), value(hit.point)],
        [say("normal"), value(hit.normal), isTurned && element("span", { class: "aside" }, ` ${say("turned")}`)],
        ["uv", value(hit.uv)],
      ]),
    ),
    hit.lights ? lights(hit, ray) : part(say("lights"), element("p", {}, say("unlit"), " ", colour(ray.own))),
    bounces.length > 0 && part(say("bounces"), bounces.map(([bounce, next]) => bounceStory(bounce, next, story))),
  ];
}

function lights(hit, ray) {
  const { surface } = hit;
  return part(
    say("lights"),
    folded({ class: "surface" }, [say("surface"), " ", swatch(surface.diffuse)], () => [
      definitions([
        [say("ambient"), colour(surface.ambient)],
        [say("diffuse"), colour(surface.diffuse)],
        [say("specular"), colour(surface.specular)],
        [say("shininess"), value(surface.shininess)],
      ]),
      surface.picture && element("p", { class: "aside" }, say("fromPicture")),
    ]),
    hit.lights.length === 0 && element("p", {}, say("noLights")),
    element("ol", { class: "lights" }, hit.lights.map(lightOf)),
    element("p", { class: "together" }, say("together"), " ", colour(ray.own)),
  );
}

function lightOf(light) {
  const arrival = light.by ? say("shadowOf", shapeName(light.by)) : light.through ? say("throughShapes", light.through.map(shapeName).join(", ")) : sayIn("arrival", light.arrival);
  const details = [
    light.filter && [say("times"), value(light.filter)],
    light.byDistance !== undefined && [say("distance"), value(light.byDistance)],
    light.byDistance === undefined && light.distance !== undefined && [say("distance"), value(light.distance)],
    light.attenuation !== undefined && light.attenuation !== 1 && [say("attenuation"), value(light.attenuation)],
    light.cosine !== undefined && [say("cosine"), value(light.cosine)],
    ...light.terms.map((one) => [sayIn("term", one.term), colour(one.colour)]),
  ];
  return element("li", { class: `light ${light.arrival}`, "data-arrival": light.arrival }, element("p", {}, element("strong", {}, sayIn("lightKind", light.kind)), " ", swatch(light.colour), " ", arrival), definitions(details));
}

// Bounces

function bounceStory(bounce, next, story) {
  const isMirror = bounce.kind === "reflection";
  const head = [
    element("strong", {}, isMirror ? say("mirror") : say(bounce.entering ? "entering" : "leaving")),
    ` ${isMirror ? "kr" : "kt"} = ${short(bounce.coefficient)}`,
    !isMirror && `, n1 = ${short(bounce.n1)}, n2 = ${short(bounce.n2)}`,
    `, ${say("angleIn")} `,
    degrees(bounce.angleIn),
    next && [`, ${say("angleOut")} `, degrees(bounce.angleOut)],
  ];
  if (!next) return element("p", { class: "bounce" }, head, ": ", sayIn("obstacle", bounce.notFollowed));
  const isShallow = bounce.ray.depth <= 2;
  return folded({ class: `bounce ${bounce.kind}`, pointerover: choosing(next), "data-ray": next }, [head, " → ", say("ray", next), " ", swatch(bounce.ray.own)], () => rayStory(next, bounce.ray, story), isShallow);
}

// Colours

function sum(story) {
  const [sample] = story.samples;
  const isUnchanged = story.colour.every((c, k) => c === story.normalized[k]);
  return [
    element(
      "table",
      { class: "sum" },
      element(
        "tbody",
        {},
        story.sampling > 1 ? line(say("mean"), colour(story.colour)) : [contributions(sample.ray), line(say("sum"), colour(story.colour))],
        isUnchanged ? line("", say("unchanged")) : line(say("normalized"), colour(story.normalized)),
        line(say("rounded"), element("strong", {}, bytes(story.pixel))),
      ),
    ),
    sample.cut && element("p", {}, say("cut")),
  ];
}

const line = (name, ...cells) => element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, cells));

/** What each ray adds, where there are several and not all is black. */
function contributions(first) {
  const rays = named("1", first);
  const bright = rays.filter(([, ray]) => ray.contribution.some((c) => c !== 0));
  if (rays.length === 1) return [];
  return [
    bright.slice(0, raysAdded).map(([name, ray]) => line(say("ray", name), value(ray.own, 4), " × ", value(ray.weight, 4), " = ", colour(ray.contribution))),
    bright.length > raysAdded && line("", say("andMore", counted(bright.length - raysAdded))),
  ];
}

// The overlay's legend

/** What the lines on the picture mean, of those that there are. */
function legend(first) {
  const rays = named("1", first, raysSearched).map(([, ray]) => ray);
  const has = (arrival) => rays.some((ray) => ray.hit?.lights?.some((light) => light.arrival === arrival && light.direction));
  const entries = [
    [rays.some((ray) => ray.cause === "reflection"), "ray reflection", "reflection"],
    [rays.some((ray) => ray.cause === "refraction"), "ray refraction", "refraction"],
    [has("arrives"), "way arrives", "reached"],
    [has("shadow"), "way shadow", "shadow"],
  ].filter(([isThere]) => isThere);
  const sample = (look) => drawn("svg", { class: "sample-line", viewBox: "0 0 28 8", "aria-hidden": "true" }, drawn("g", { class: look }, ["casing", "beam"].map((name) => drawn("line", { class: name, x1: 1, x2: 27, y1: 4, y2: 4 }))));
  return entries.length > 0 && part(say("onPicture"), element("ul", { class: "legend" }, entries.map(([, look, name]) => element("li", {}, sample(look), " ", sayIn("legend", name)))));
}
