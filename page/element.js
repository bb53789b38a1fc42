// Elements of the page, each made in one expression.
//
// Whatever comes from the program or from a scene is put in as text, never as markup.

const svgNamespace = "http://www.w3.org/2000/svg";

/** The element with an id. */
export const byId = (id) => document.getElementById(id);

/** An element of HTML with attributes (functions listen to the event of that name; null and false are left out) and children. */
export const element = (tag, attributes, ...children) => furnished(document.createElement(tag), attributes, children);

/** The same for SVG. */
export const drawn = (tag, attributes, ...children) => furnished(document.createElementNS(svgNamespace, tag), attributes, children);

function furnished(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") made.addEventListener(name, value);
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

/** A fold whose content is made when it is opened first: a story may have thousands of rays. */
export function folded(attributes, summary, content, open = false) {
  const fold = element("details", attributes, element("summary", {}, summary));
  let isFilled = false;
  const fill = () => {
    if (isFilled) return;
    isFilled = true;
    fold.append(...[content()].flat(Infinity).filter(Boolean));
  };
  fold.addEventListener("toggle", () => fold.open && fill());
  fold.open = open;
  if (open) fill();
  return fold;
}
