// The rays of a story as a tree, with their names: a ray's name is that of the ray it comes from and its place there, as in 1.2.1.

/** The bounces of a ray's hit, each with the name of its ray, or null where none is followed. */
export function bouncesOf(name, ray) {
  let k = 0;
  return (ray.hit?.bounces ?? []).map((bounce) => [bounce, bounce.ray ? `${name}.${++k}` : null]);
}

/** A ray and all that come from it, depth first, each with its name; no more than `most` of them. */
export function named(name, ray, most = Infinity) {
  const found = [];
  const visit = (n, r) => {
    if (found.length >= most) return;
    found.push([n, r]);
    for (const [bounce, next] of bouncesOf(n, r)) if (next) visit(next, bounce.ray);
  };
  visit(name, ray);
  return found;
}
