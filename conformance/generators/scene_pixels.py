"""The cases of scene.pixel: chapters 8 and 10 here, chapters 6 and 7 in light_pixels.py.

Bytes are made as picture.byte says: a channel rounded to binary32, the product with 255 rounded to binary32, the sum with 1/2 in binary64, cut.
"""

import random
import struct
import sys

sys.dont_write_bytecode = True

import light_pixels  # noqa: E402
from camera_rays import uniform  # noqa: E402
from suite import HAND, ORDERED, case, main, next_up  # noqa: E402


def single(x):
    """Rounded to binary32. (255 times a binary32 number is exact in binary64.)"""
    return struct.unpack("<f", struct.pack("<f", x))[0]


def byte(c):
    if not c > 0:
        return 0
    return 255 if c >= 1 else int(single(single(c) * 255.0) + 0.5)


def bytes_of(colour, division=False):
    r, g, b, a = colour
    if division:
        most = max(r, g, b, 1)
        r, g, b = r / most, g / most, b / most
    return [byte(r), byte(g), byte(b), byte(a)]


def material(colour, kd=1, name="m", more=""):
    return f"material\n  name {name}\n  color {' '.join(map(repr, colour))}\n  kd {kd!r}\n{more}end\n"


def plane(z=3, name="m"):
    return f"primitive\n  material_name {name}\n  plane\n    position 0 0 {z!r}\n  end\nend\n"


def tracer(*lines, algorithm="no_light"):
    return "raytracer\n" + "".join(f"  {line}\n" for line in (["reflexion_algorithm " + algorithm] if algorithm else []) + list(lines)) + "end\n"


def flat(rules, comment, flags, colour, kd=1, division=False):
    """A plane in no_light: the pixel has kd times the colour, and the colour's alpha."""
    full = list(colour) + [1.0] * (4 - len(colour))
    text = tracer(*(["color_normalization division_factor"] if division else [])) + plane() + material(colour, kd)
    return case(rules, comment, flags, {"text": text, "column": 250, "row": 250}, bytes_of([kd * c for c in full[:3]] + [full[3]], division), source=ORDERED)


def pixel(rules, comment, flags, text, ok, column=250, row=250, source=HAND):
    return case(rules, comment, flags, {"text": text, "column": column, "row": row}, ok, source=source)


def byte_cases():
    made = [
        flat("picture.byte", "Quarters.", "rounding", [0.25, 0.5, 0.75]), flat("picture.byte", "Thirds and sevenths.", "rounding", [1 / 3, 1 / 7, 6 / 7]), flat("picture.byte", "Every k / 255 is k: small ones.", "rounding", [1 / 255, 2 / 255, 3 / 255]),
        flat("picture.byte", "Every k / 255 is k: in the middle.", "rounding", [126 / 255, 127 / 255, 128 / 255]), flat("picture.byte", "Every k / 255 is k: large ones.", "rounding", [252 / 255, 253 / 255, 254 / 255]),
        flat("picture.byte", "Half of the first step, below and above it.", "rounding", [0.5 / 255, next_up(0.5 / 255, -(10**10)), next_up(0.5 / 255, 10**10)]), flat("picture.byte", "The last half step.", "rounding", [254.5 / 255, next_up(254.5 / 255, -(10**10)), next_up(254.5 / 255, 10**10)]),
        flat("picture.byte", "The binary32 in it: 0.29999999 and 0.2999999999.", "binary64", [0.29999999, 0.2999999999, 0.3]), flat("picture.byte picture.byte.range", "Just below 1.", "truncation", [0.9999999999999999, 0.998, 0.9981]),
        flat("picture.byte", "No gamma: a tenth is 26.", "gamma", [0.1, 0.01, 0.9]), flat("picture.byte", "255 and not 256.", "scale", [0.996, 0.9961, 0.00390625]),
        flat("picture.byte.range", "0, tiny, and huge.", "clamp", [0, 1e-100, 1e100]), flat("picture.byte.range numbers.negative-zero", "-0 is 0, and the smallest number.", "clamp negative-zero", [-0.0, 5e-324, 1.0]), flat("picture.byte.range picture.alpha", "Alpha, too: 0.", "alpha", [1, 1, 1, 0]), flat("picture.byte.range picture.alpha", "Alpha, too: tiny.", "alpha", [1, 1, 1, 1e-300]),
        flat("picture.clamp", "Each channel for itself.", "clamp", [4, 0.8, 0.4]), flat("picture.clamp", "One a little above 1.", "clamp", [1.0000000000000002, 0.9, 1.5]), flat("picture.clamp", "All above.", "clamp", [2, 3, 1e50]), flat("picture.clamp", "After kd: 2 times 0.3.", "clamp order", [2, 3, 4], 0.3),
        flat("picture.division", "Divided by the largest: red.", "division", [2, 0.8, 0.3], 1, True), flat("picture.division", "Green.", "division swapped-index", [0.5, 4, 1], 1, True), flat("picture.division", "Blue.", "division swapped-index", [1.5, 2.5, 5], 1, True), flat("picture.division", "A colour that fits is left alone.", "division", [0.8, 0.4, 0.2], 1, True),
        flat("picture.division", "One that just fits.", "division", [1, 0.5, 0.25], 1, True), flat("picture.division", "Black.", "division zero", [0, 0, 0], 1, True), flat("picture.division", "The largest numbers.", "division overflow", [1e100, 1e99, 5e99], 1, True), flat("picture.division", "After kd.", "division order", [4, 2, 1], 0.5, True), flat("picture.division", "A little above 1.", "division", [1.0000000000000002, 0.5, 0.2], 1, True),
        flat("picture.alpha picture.division", "Alpha is not divided.", "alpha division", [2, 0.4, 0, 0.25], 1, True), flat("picture.alpha picture.division", "Alpha does not divide.", "alpha division", [0.8, 0.4, 0.2, 3], 1, True), flat("picture.alpha picture.clamp", "Alpha above 1.", "alpha clamp", [0.5, 0.5, 0.5, 7], 1), flat("picture.alpha", "Alpha is not multiplied by kd.", "alpha", [1, 0.5, 0.25, 0.5], 0.5),
        flat("picture.alpha picture.division", "Alpha above 1 and a bright colour.", "alpha division", [4, 2, 1, 2], 1, True),
        flat("picture.pixel", "Red, green, blue, alpha.", "order", [0.1, 0.3, 0.6, 0.9]), flat("picture.pixel", "Not multiplied with one another.", "premultiplied", [1, 0.8, 0.4, 0]), flat("picture.pixel picture.alpha", "A half transparent one.", "premultiplied", [1, 0.8, 0.4, 0.5]),
    ]
    source = random.Random(71)
    for _ in range(6):
        made.append(flat("picture.byte picture.pixel", "Random digits.", "rounding", [source.random() for _ in range(4)]))
    made.append(flat("picture.division picture.byte", "Random digits, bright.", "division rounding", [source.uniform(0, 9) for _ in range(3)], 1, True))
    return made


def view_cases():
    red, blue, white = material([1, 0, 0], name="red"), material([0, 0, 1], name="blue"), material([1, 1, 1], name="white")
    p, t = pixel, tracer
    near = lambda *lines: "camera\n" + "".join(f"  {line}\n" for line in lines) + "end\n"
    black, seen = [0, 0, 0, 255], [255, 255, 255, 255]
    made = [
        p("camera.near", "What lies before the near plane is not seen.", "near", t() + plane(0.5, "red") + plane(3, "blue") + red + blue, [0, 0, 255, 255]),
        p("camera.near geometry.hit.smallest-parameter", "What lies on it is not, either.", "near epsilon", t() + plane(1, "red") + plane(3, "blue") + red + blue, [0, 0, 255, 255]),
        p("camera.near geometry.hit.smallest-parameter", "1e-7 behind it is.", "near epsilon", t() + plane(1.0000001, "red") + plane(3, "blue") + red + blue, [255, 0, 0, 255]),
        p("camera.near geometry.hit.smallest-parameter", "1e-9 behind it is not.", "near epsilon", t() + plane(1.000000001, "red") + plane(3, "blue") + red + blue, [0, 0, 255, 255]),
        p("camera.near", "A near plane farther away.", "near", near("near_clipping_plane 4") + t() + plane(3, "red") + plane(5, "blue") + red + blue, [0, 0, 255, 255]),
        p("camera.far", "At far: not seen, strictly.", "far compare", near("far_clipping_plane 2") + t() + plane(3, "white") + white, black),
        p("camera.far", "One step nearer: seen.", "far compare", near("far_clipping_plane 2.0000000000000004") + t() + plane(3, "white") + white, seen),
        p("camera.far", "It is counted from the near plane.", "far", near("near_clipping_plane 2", "far_clipping_plane 3") + t() + plane(4.5, "white") + white, seen),
        p("camera.far", "100 by default: seen at 100.9.", "far default", t() + plane(100.9, "white") + white, seen),
        p("camera.far", "100 by default: not seen at 101.", "far default", t() + plane(101, "white") + white, black),
        p("camera.far", "Behind far there is black, whatever is nearer than the near plane.", "far near", near("far_clipping_plane 1") + t() + plane(0.5, "white") + plane(2.5, "white") + white, black),
        p("camera.background", "Nothing: black, opaque.", "background alpha", t(), black, 7, 8), p("camera.background", "Nothing, with blinn.", "background", "ambient_light\nend\n", black, 0, 0), p("camera.background", "Nothing, with division_factor.", "background division", t("color_normalization division_factor"), black, 499, 499), p("camera.background", "Nothing, sampled.", "background sampling", t("sampling 3", "pixel_coordinate random"), black),
        p("camera.background", "A plane behind the camera.", "background sign", t() + plane(-3, "white") + white, black),
        p("camera.independent", "space and task change nothing: voxel.", "space", t("space voxel", "task 64") + plane(5, "red") + plane(3, "blue") + red + blue, [0, 0, 255, 255]), p("camera.independent", "Nor does multi_voxel.", "space", t("space multi_voxel", "task 3") + plane(5, "red") + plane(3, "blue") + red + blue, [0, 0, 255, 255]),
        p("camera.independent geometry.hit.tie", "Equal parameters: the first in the text, in any space.", "tie space", t("space voxel") + plane(3, "red") + plane(3, "blue") + red + blue, [255, 0, 0, 255]),
        p("camera.sampling.one", "Alpha is kept without sampling.", "sampling alpha", t() + plane() + material([1, 1, 1, 0.25]), [255, 255, 255, 64]), p("camera.sampling.one", "sampling 1, written.", "sampling alpha", t("sampling 1") + plane() + material([1, 0.5, 1, 0.5]), [255, 128, 255, 128]), p("camera.sampling.one", "sampling 1 and random.", "sampling alpha", t("sampling 1", "pixel_coordinate random") + plane() + material([1, 1, 0.5, 0]), [255, 255, 128, 0]),
        p("camera.sampling.opaque", "A mean is opaque.", "sampling alpha", t("sampling 2") + plane() + material([1, 1, 1, 0.25]), seen), p("camera.sampling.opaque", "A mean of nothing is.", "sampling alpha", t("sampling 2", "pixel_coordinate random"), black), p("camera.sampling.opaque", "One of an alpha of 0 is.", "sampling alpha", t("sampling 5", "pixel_coordinate random") + plane() + material([0, 1, 0, 0]), [0, 255, 0, 255]),
        p("camera.sampling.fixed camera.sampling.mean", "Three times the same ray.", "sampling", t("sampling 3") + plane() + material([0.6, 0.4, 0.2]), [153, 102, 51, 255]), p("camera.sampling.fixed camera.sampling.mean", "Colours above 1 are clamped after the mean.", "sampling clamp", t("sampling 4", "pixel_coordinate center") + plane() + material([3, 0.5, 0.2]), [255, 128, 51, 255]),
        p("camera.every-pixel", "The last pixel of a picture that is wide.", "size", near("far_clipping_plane 1000") + "viewport\n  width 700\n  height 3\nend\n" + t() + plane(3, "white") + white, seen, 699, 2), p("camera.every-pixel", "The last pixel of a tall one.", "size", "viewport\n  width 3\n  height 700\nend\n" + t() + plane(3, "white") + white, seen, 2, 699),
        p("scene.material.substitute", "A material that is not there: kd is 0.6.", "default", t() + plane(3, "nowhere"), bytes_of([0.6, 0.6, 0.6, 1])), p("scene.material.substitute", "No name at all: the same.", "default", t() + "primitive\n  plane\n    position 0 0 3\n  end\nend\n", bytes_of([0.6, 0.6, 0.6, 1])),
        p("scene.material.repeated", "The first of two counts.", "repeated", t() + plane() + material([1, 0, 0]) + material([0, 1, 0]), [255, 0, 0, 255]), p("scene.material.name", "Case counts.", "case", t() + plane() + material([1, 0, 0], name="M") + material([0, 1, 0]), [0, 255, 0, 255]), p("block.material", "kd is 0.8 by default.", "default", t() + plane() + "material\n  name m\nend\n", bytes_of([0.8, 0.8, 0.8, 1])),
        p("object.several-possible", "The last camera counts.", "replaced", near("far_clipping_plane 1") + near("far_clipping_plane 9") + t() + plane(3, "white") + white, seen), p("code.missing-end", "An object without its end is drawn.", "missing-end", t() + white + "primitive\n  material_name white\n  plane\n    position 0 0 3\n", seen),
        p("protocol.text block.texture-material", "A picture that is not there: the plain colour.", "files", t() + plane() + "texture_material\n  name m\n  color 1 0.5 0\n  kd 1\n  texture_kd no.png\nend\n", [255, 128, 0, 255]),
    ]
    same = lambda a, b, sphere: t() + "".join(f"primitive\n  material_name {name}\n{sphere}\nend\n" for name in (a, b)) + red + blue
    for sphere in ("  sphere\n    position 0.1 0.2 3.3\n    ray 0.7\n  end", "  sphere\n    position 0 0.3 7\n    ray 1.1\n  end", "  cylinder\n    point 0.3 -1 4\n    point -0.1 2 4.5\n    ray 0.9\n  end"):
        made.append(p("roots.quadratic.same geometry.hit.tie", "Two shapes that are the same: the first is seen.", "tie", same("red", "blue", sphere), [255, 0, 0, 255]))
        made.append(p("roots.quadratic.same geometry.hit.tie", "The same, in the other order.", "tie", same("blue", "red", sphere), [0, 0, 255, 255]))
    made.append(p("protocol.text block.model models.block", "A model has no triangles.", "files", t() + "model\n  file cube.obj\nend\n" + plane(3, "white") + white, seen))
    for x, ok in ((0, seen), (0.999, seen), (1.001, black)):
        made.append(p("limits.accuracy geometry.sphere.tangent", f"A sphere 10,000 radii away, its centre {x} beside the ray.", "epsilon cancellation", near("far_clipping_plane 20000") + t() + f"primitive\n  material_name white\n  sphere\n    position {x} 0 10000\n    ray 1\n  end\nend\n" + white, ok))
    for kind, algorithm, ok in (("ka", "ambient", [64, 32, 0, 255]), ("kd", "no_light", [204, 102, 0, 255]), ("ks", "no_light", [204, 102, 0, 255])):
        made.append(p("models.texture.none block.texture-material", f"texture_{kind} none: the material's own colour.", "files", tracer(algorithm=algorithm) + plane() + f"texture_material\n  name m\n  color 1 0.5 0\n  ka 0.25\n  kd 0.8\n  texture_{kind} none\nend\nambient_light\nend\n", ok))
    half = "camera\n  angle 90\nend\nviewport\n  width 1\n  height 1\nend\n"
    triangle = "primitive\n  material_name m\n  triangle\n    point 0 -1000 5\n    point 0 1000 5\n    point 1000 0 5\n  end\nend\n"
    for sampling, seed, colour, kd in [(8, 0, [1, 0.5, 0, 0.5], 0.9), (8, 5, [1, 0.5, 0], 0.9), (2, 1, [0.9, 0.5, 0.3], 1), (3, 2, [0.7, 0.2, 1], 1), (100, 3, [1, 0.6, 0.3], 0.7), (7, 2147483647, [1, 0.9, 0.8], 1), (64, 11, [1.9, 0.9, 0.3], 1)]:
        total = [0.0, 0.0, 0.0]
        for s in range(sampling):
            a = uniform(seed, 2 * s)
            if abs(a - 0.5) < 1e-9:
                raise ValueError("too near to the edge")
            # The triangle covers x > 0, which is where a < 1/2, down to |y| = 1000 - x.
            if a < 0.5:
                total = [x + kd * c for x, c in zip(total, colour)]
        mean = [x * (1 / sampling) for x in total]
        for c in mean:
            if 0 < c < 1 and abs(c * 255 - int(c * 255) - 0.5) < 1e-4:
                raise ValueError("too near to a step")
        made.append(pixel("camera.sampling.mean camera.random camera.generator", f"{sampling} samples of seed {seed}, half of the pixel covered.", "sampling generator", half + tracer("pixel_coordinate random", f"sampling {sampling}", f"seed {seed}") + triangle + material(colour, kd), bytes_of(mean + [1]), 0, 0, ORDERED))
    quarter = "primitive\n  material_name m\n  triangle\n    point 0 0 2\n    point 9 0 2\n    point 0 9 2\n  end\nend\n"
    for name, column, row, ok in [("top_left", 0, 0, True), ("top_right", 0, 0, None), ("center", 0, 0, True), ("center", 1, 0, False), ("center", 0, 1, False), ("center", 1, 1, False)]:
        if ok is not None:
            made.append(pixel("camera.pixel-coordinate camera.axes", f"{name} of column {column}, row {row}: a triangle in the top left quarter.", "mirrored swapped-index", "camera\n  angle 90\nend\nviewport\n  width 2\n  height 2\nend\n" + tracer(f"pixel_coordinate {name}") + quarter + material([1, 1, 1]), seen if ok else black, column, row))
    return made


def operations():
    return {"scene.pixel": byte_cases() + view_cases() + light_pixels.cases()}


if __name__ == "__main__":
    main(sys.modules[__name__])
