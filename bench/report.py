"""The tables of docs/performance.md and the plots beside it, from what was measured last."""

import json
from math import log10

from measure import HERE, Fault

RESULTS = HERE / "results"
DOCS = HERE.parent / "docs"
PAGE = DOCS / "performance.md"

SCENES = ["plane-and-cubes", "six-spheres", "six-spheres-mirror", "teapot", "teapot-primary"]


def results(name):
    path = RESULTS / f"{name}.json"
    return json.loads(path.read_text()) if path.exists() else None


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"] + ["| " + " | ".join(row) + " |" for row in rows]


# The tables


def scenes():
    names = SCENES + sorted(
        {path.stem for path in RESULTS.glob("*.json") if (HERE / path.stem / "scene.pov").exists()} - set(SCENES)
    )
    rows = [
        [
            f"[{name}](../bench/{name}/)",
            f"{r['times_as_fast']:g}x",
            f"{r['times_as_fast_processor']:g}x",
            f"{r['times_as_fast_start_up']:g}x",
            f"{r['memory_mb']} MB",
            f"{r['povray_memory_mb']} MB",
            f"{r['pixels_apart_percent']:g}%",
        ]
        for name in names
        if (r := results(name))
    ]
    head = ["scene", "faster, whole program", "processor time", "start-up", "our memory", "POV-Ray's", "pixels that differ"]
    return table(head, rows)


def others():
    lines = []
    if r := results("two-processors"):
        lines.append(
            "- By two threads on two processors, tracing only: "
            + ", ".join(f"{row['scene']} {row['times_as_fast']:g} times as fast as by one" for row in r["rows"])
            + ". The machine itself, by two programs of one thread at once: "
            + ", ".join(f"{row['two_programs']:g}" for row in r["rows"])
            + " times as much."
        )
    if r := results("teapot-multiple"):
        lines.append(
            f"- Five instances of the teapot (31600 triangles), lit, 500 x 500: {r['share_of_plane_and_cubes']:g} of the time that POV-Ray takes "
            f"for plane-and-cubes at 2000 x 2000; {r['memory_mb']} MB resident."
        )
    if r := results("embree"):
        lines.append(
            f"- Primary rays on the teapot, tracing only, 2000 x 2000: {r['speed_of_embrees']:g} of the speed of Embree, one ray at a time. "
            f"{r['hits']} of our rays hit, and {r['embree_hits']} of Embree's."
        )
    return lines


def scalar():
    r = results("scalar")
    if not r:
        return []
    rows = [
        [
            f"[{row['scene']}](../bench/{row['scene']}/)",
            f"{row['speed_of_scalars']:g}",
            f"{row['ray_ns']:g} ns",
            f"{row['scalar_ray_ns']:g} ns",
            f"{row['rays']}",
            f"{row['scalar_rays']}",
            f"{row['pixels_apart_percent']:g}%",
        ]
        for row in r["rows"]
    ]
    return table(["scene", "our speed by its", "a ray", "its", "rays", "its", "pixels that differ"], rows)


def growth():
    r = results("growth")
    if not r:
        return []
    rows = [
        [
            f"{row['triangles']}",
            f"{row['ray_ns']:g} ns",
            f"{row['embree_ray_ns']:g} ns" if "embree_ray_ns" in row else "",
            f"{row['tests_per_ray']:g}",
            # The program tells milliseconds.
            f"{row['indexing_ms']:g} ms" if row["indexing_ms"] >= 1 else "less than 1 ms",
            f"{row['indexing_ns_per_triangle']:g} ns" if row["indexing_ms"] >= 1 else "",
            f"{row['embree_indexing_ms']:g} ms" if "embree_indexing_ms" in row else "",
            f"{row['reading_ms']:g} ms",
            f"{row['memory_mb']} MB",
        ]
        for row in r["rows"]
    ]
    head = ["triangles", "a ray", "Embree's", "tests a ray", "indexing", "for each triangle", "Embree's", "reading", "resident"]
    write_plots(r["rows"])
    first, last = r["rows"][0], r["rows"][-1]
    decades = log10(last["triangles"] / first["triangles"])
    return [
        *table(head, rows),
        "",
        f"With ten times as many triangles, a ray costs {(last['ray_ns'] / first['ray_ns']) ** (1 / decades):.2g} times as much on average. "
        f"A triangle takes {r['bytes_per_triangle']:g} bytes of resident memory at the most (with what is needed to read the file).",
    ]


def obj():
    r = results("obj")
    if not r:
        return []
    rows = [
        [row["program"], f"{row['mb_per_second']:g} MB/s", f"{row['dioptre_times_as_fast']:g}x", f"{row['memory_mb']} MB"]
        for row in r["rows"]
    ]
    return [
        f"{r['megabytes']} MB, {r['triangles']} smooth triangles:",
        "",
        *table(["program", "reads", "its time by ours", "resident"], rows),
    ]


PARTS = {"scenes": scenes, "others": others, "scalar": scalar, "growth": growth, "obj": obj}


def write_report():
    """Each part stands between two marks in the page."""
    text = PAGE.read_text()
    for name, part in PARTS.items():
        begin, end = f"<!-- {name}: written by bench/run -->", f"<!-- end of {name} -->"
        if begin not in text or end not in text:
            raise Fault(f"{PAGE}: the marks of {name} are gone")
        before, rest = text.split(begin, 1)
        text = before + "\n".join([begin, *part(), end]) + rest.split(end, 1)[1]
    PAGE.write_text(text)


# The plots

WIDTH, HEIGHT = 640, 360
LEFT, RIGHT, TOP, BOTTOM = 70, 40, 44, 46


def write_plots(rows):
    def series(key):
        return [(row["triangles"], row[key]) for row in rows if row.get(key)]

    curves = [("Dioptre", "#c0392b", series("ray_ns")), ("Embree, one ray at a time", "#2c6e9b", series("embree_ray_ns"))]
    (DOCS / "performance-ray.svg").write_text(plot("Nanoseconds for a ray, by triangles", curves, upright=False))
    curves = [("Dioptre", "#c0392b", series("indexing_ms")), ("Embree", "#2c6e9b", series("embree_indexing_ms"))]
    known = series("indexing_ms")
    if known:
        size, most = known[-1]
        curves.append(("n log n", "#888888", [(n, most * n * log10(n) / (size * log10(size))) for n, _ in known]))
    (DOCS / "performance-index.svg").write_text(plot("Milliseconds to index, by triangles", curves, upright=True))


def plot(title, curves, upright):
    """An SVG picture of curves over powers of ten; upright: the values stand on powers of ten too."""
    curves = [curve for curve in curves if curve[2]]
    places = [point for _, _, points in curves for point in points]
    if not places:
        return f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}"/>\n'
    least_x, most_x = log10(min(x for x, _ in places)), log10(max(x for x, _ in places))
    if upright:
        low = 10 ** floor_of(log10(min(y for _, y in places)))
        high = 10 ** -floor_of(-log10(max(y for _, y in places)))
        ticks = [10**k for k in range(round(log10(low)), round(log10(high)) + 1)]
    else:
        step = next(s * 10**k for k in range(9) for s in (1, 2, 5) if s * 10**k * 6 >= max(y for _, y in places))
        low, high = 0, step * -floor_of(-max(y for _, y in places) / step)
        ticks = [step * k for k in range(round(high / step) + 1)]

    def at_x(x):
        return LEFT + (WIDTH - LEFT - RIGHT) * (log10(x) - least_x) / (most_x - least_x)

    def at_y(y):
        share = (log10(y) - log10(low)) / (log10(high) - log10(low)) if upright else (y - low) / (high - low)
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * share

    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
        f'<text x="{LEFT}" y="22" font-size="15">{title}</text>',
    ]
    for y in ticks:
        lines.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{at_y(y):.1f}" y2="{at_y(y):.1f}" stroke="#dddddd"/>')
        lines.append(f'<text x="{LEFT - 8}" y="{at_y(y) + 4:.1f}" text-anchor="end">{y:g}</text>')
    for k in range(round(least_x), round(most_x) + 1):
        x = at_x(10**k)
        lines.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}" stroke="#dddddd"/>')
        lines.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 20}" text-anchor="middle">{10**k}</text>')
    for i, (name, colour, points) in enumerate(curves):
        dashes = ' stroke-dasharray="5 4"' if name == "n log n" else ""
        path = " ".join(f"{at_x(x):.1f},{at_y(y):.1f}" for x, y in points)
        lines.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"{dashes}/>')
        if not dashes:
            lines += [f'<circle cx="{at_x(x):.1f}" cy="{at_y(y):.1f}" r="4" fill="{colour}"/>' for x, y in points]
        lines.append(f'<text x="{LEFT + 12}" y="{TOP + 18 + 18 * i}" fill="{colour}">{name}</text>')
    return "\n".join([*lines, "</svg>"]) + "\n"


def floor_of(x):
    return int(x // 1)
