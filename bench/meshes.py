"""Meshes for the benchmarks, written line by line: the same triangles for every program."""

from math import cos, isqrt, pi, sin
from pathlib import Path


def bumpy_sphere(path, triangles, smooth=False):
    """Writes an OBJ file of exactly so many triangles (an even number): a sphere of radius about 1 with bumps of several sizes.

    It has d + 1 strips from pole to pole, cut c times around, with 2 c d triangles; d divides their number and is
    as close below c / 2 as can be. Smooth ones have normals (those of the sphere without bumps).
    """
    strips = next(d for d in range(max(1, isqrt(triangles // 4)), 0, -1) if (triangles // 2) % d == 0)
    around = triangles // (2 * strips)
    # The poles, then `strips` rings.
    places = (
        [(0.0, 0.0)]
        + [(pi * (j + 1) / (strips + 1), 2 * pi * i / around) for j in range(strips) for i in range(around)]
        + [(pi, 0.0)]
    )
    last = len(places)

    def vertex(j, i):
        return 1 if j < 0 else last if j >= strips else 2 + j * around + i % around

    def corner(j, i):
        k = vertex(j, i)
        return f"{k}//{k}" if smooth else str(k)

    with open(path, "w") as out:
        out.write(f"# a bumpy sphere of {triangles} triangles\n")
        for down, turn in places:
            x, y, z = sin(down) * cos(turn), sin(down) * sin(turn), cos(down)
            r = 1 + 0.06 * sin(5 * x + 1) * sin(6 * y) * sin(4 * z + 2) + 0.015 * sin(23 * x) * sin(29 * y + 1) * sin(31 * z)
            out.write(f"v {r * x:.7f} {r * y:.7f} {r * z:.7f}\n")
            if smooth:
                out.write(f"vn {x:.5f} {y:.5f} {z:.5f}\n")
        for j in range(-1, strips):
            for i in range(around):
                if j >= 0:
                    out.write(f"f {corner(j, i)} {corner(j + 1, i)} {corner(j, i + 1)}\n")
                if j + 1 < strips:
                    out.write(f"f {corner(j, i + 1)} {corner(j + 1, i)} {corner(j + 1, i + 1)}\n")


def povray_mesh(obj, output, name):
    """Declares an OBJ file's triangles, with their normals, as a mesh2 of POV-Ray."""
    points, normals, faces = [], [], []
    for line in Path(obj).read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append(",".join(rest))
        elif word == "vn":
            normals.append(",".join(rest))
        elif word == "f":
            faces.append([[int(number) - 1 for number in corner.split("//")] for corner in rest])
    with open(output, "w") as out:

        def part(word, lines):
            out.write(f"  {word} {{\n    {len(lines)}")
            out.writelines(f",\n    <{line}>" for line in lines)
            out.write("\n  }\n")

        out.write(f"#declare {name} = mesh2 {{\n")
        part("vertex_vectors", points)
        part("normal_vectors", normals)
        part("face_indices", [",".join(str(corner[0]) for corner in face) for face in faces])
        part("normal_indices", [",".join(str(corner[1]) for corner in face) for face in faces])
        out.write("}\n")
