"""The words of the language, and one table for all objects (specification 2.4, 3.5 to 3.7).

It serves the reader (checking.py), the writer (canonical.py) and the shapes of the protocol
(operations.py).
"""

import math

import vector as V
from shapes.triangle import collinear

SMALLEST_LENGTH = 1e-10                # numbers.tolerances


class Property:
    """A property: its spellings, the form of its value, its default, its range, its places."""

    def __init__(self, words, form, default, low=None, high=None, places=1, choices=(), unit="",
                 points=False):
        self.words = words.split()
        self.name = self.words[0]      # the key among an object's values
        self.written = "position" if points else self.name
        self.form, self.default, self.low, self.high = form, default, low, high
        self.places, self.choices, self.unit = places, choices, unit


class Block:
    """An object: its spellings, its properties in the order of the table, and what makes it
    impossible (a function from the values to a code or None)."""

    def __init__(self, words, properties, impossible=lambda v: None, has_shape=False):
        self.words = words.split()
        self.name = self.words[0]
        self.properties = properties
        self.by_word = {w: p for p in properties for w in p.words}
        self.impossible = impossible
        self.has_shape = has_shape

    def defaults(self):
        """object.defaults"""
        return {p.name: list(p.default) if p.places > 1 else p.default for p in self.properties}


def vector(words, default, **more):
    return Property(words, "vector", default, **more)


def real(words, default, low=None, high=None, **more):
    return Property(words, "real", default, low, high, **more)


def size(words, default, **more):
    return Property(words, "real", default, SMALLEST_LENGTH, None, **more)


def integer(words, default, low, **more):
    return Property(words, "integer", default, low, **more)


def text(words, default="none"):
    return Property(words, "text", default)


def choice(words, choices, default):
    choices = choices.split()
    return Property(words, "choice", choices[0] if default is None else default, choices=choices)


X, Y, Z, O = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
ONES = (1.0, 1.0, 1.0)


# Impossible objects (object.impossible: the first code that fits, in the order of the table)

def _short(v):
    return V.modulus(v) < SMALLEST_LENGTH


def _camera(v):
    """code.nowhere-to-look, code.up-along-front, code.far-before-near"""
    look = V.subtract(v["look_at"], v["position"])
    if _short(look):
        return "nowhere-to-look"
    front = V.unit(look)
    if _short(v["up"]) or _short(V.cross(V.cross(front, V.unit(v["up"])), front)):
        return "up-along-front"
    if v["far_clipping_plane"] < v["near_clipping_plane"]:
        return "far-before-near"
    return None


def _viewport(v):
    """code.too-many-pixels"""
    return "too-many-pixels" if v["width"] * v["height"] > 268435456 else None


def _dark(v):
    """code.no-attenuation"""
    if v["constant_attenuator"] == v["linear_attenuator"] == v["quadratic_attenuator"] == 0:
        return "no-attenuation"
    return None


def _invisible(v):
    """code.invisible-wavelength"""
    return None if 380 <= v["wave_length"] <= 780 else "invisible-wavelength"


def grid(width, height, n):
    """The numbers of places of a plane aperture across and up (light.wave.grid)."""
    if n < 2:
        return n, n
    if width < height:
        return n, math.ceil(height / (width / (n - 1))) + 1
    return math.ceil(width / (height / (n - 1))) + 1, n


def _linear(v):
    """code.too-many-oscillators"""
    if v["nb_oscillator"] > 1000000:
        return "too-many-oscillators"
    return _dark(v) or _invisible(v)


def _planar(v):
    """code.too-many-oscillators, code.up-along-front"""
    found = _dark(v) or _invisible(v)
    if found:
        return found
    nx, ny = grid(v["width"], v["height"], v["nb_oscillator"])
    if nx * ny > 1000000:
        return "too-many-oscillators"
    if _short(v["front"]) or _short(v["up"]):
        return "up-along-front"
    if _short(V.cross(V.unit(v["front"]), V.unit(v["up"]))):
        return "up-along-front"
    return None


def _directional(v):
    """code.zero-orientation"""
    return "zero-orientation" if _short(v["orientation"]) else None


def _normal(v):
    """code.zero-normal"""
    return "zero-normal" if _short(v["normal"]) else None


def _annulus(v):
    """code.inner-beyond-outer"""
    return _normal(v) or ("inner-beyond-outer" if v["inner_ray"] > v["ray"] else None)


def _cap(v):
    """code.curvature-below-radius"""
    return _normal(v) or ("curvature-below-radius" if abs(v["curvature"]) < v["ray"] else None)


def _triangle(v):
    """code.collinear-points"""
    return "collinear-points" if collinear(*v["point"]) else None


def ends(v):
    """code.equal-points"""
    return "equal-points" if v["point"][0] == v["point"][1] else None


def lens(v):
    """code.curvature-below-radius, code.lens-too-thin, geometry.lens.possible"""
    if ends(v):
        return ends(v)
    radius = v["ray"]
    if any(abs(c) < radius for c in v["curvature"]):
        return "curvature-below-radius"
    thickness = V.distance(*v["point"])
    for c in v["curvature"]:
        s = (radius * radius) / (abs(c) + math.sqrt((abs(c) - radius) * (abs(c) + radius)))
        thickness = thickness + (s if c > 0 else -s)
    return None if thickness > 0 else "lens-too-thin"


# Objects of the scene (3.5, 3.6)

CAMERA = Block("camera", [
    vector("position", O), vector("look_at", Z), vector("up haut", Y),
    real("angle", 60.0, 10.0, 170.0, unit=" degrees"),
    size("near_clipping_plane", 1.0), size("far_clipping_plane", 100.0)], _camera)

VIEWPORT = Block("viewport", [
    integer("width largeur", 500, 1, unit=" pixels"),
    integer("height hauteur", 500, 1, unit=" pixels"),
    Property("image_file_name nom_fichier_image", "output", "image")], _viewport)

RAYTRACER = Block("raytracer", [
    integer("task", 1, 1), integer("sampling", 1, 1), integer("recursive_level", 1, 1),
    choice("reflexion_algorithm algorithme_reflexion",
           "no_light ambient diffuse phong_specular blinn_specular no_specular phong blinn", "blinn"),
    choice("pixel_coordinate coordonnee_pixel",
           "top_left top_right bottom_left bottom_right center random", None),
    choice("space espace", "linear voxel multi_voxel", None),
    choice("color_normalization", "clamp_channel division_factor", None),
    integer("seed graine", 0, 0)])

PRIMITIVE = Block("primitive", [text("material_name nom_materiel")], has_shape=True)


def _material():
    return [text("name nom"), Property("color couleur", "colour", (1.0, 1.0, 1.0, 1.0)),
            real("ka", 0.2, 0.0, 1.0), real("kd", 0.8, 0.0, 1.0), real("ks", 0.5, 0.0, 1.0),
            real("kr", 0.0, 0.0, 1.0), real("kt", 0.0, 0.0, 1.0),
            real("shininess brillance", 20.0, 0.0, 200.0), real("plasticity p", 0.0, 0.0, 1.0),
            real("refractive_index n", 1.0, 1e-10, 10.0)]


MATERIAL = Block("material materiel color_material blinn_material", _material())
TEXTURE_MATERIAL = Block("texture_material texture_materiel",
                         _material() + [text("texture_ka"), text("texture_kd"), text("texture_ks")])

MODEL = Block("model", [
    text("file fichier"), Property("scale homothetie", "scale", ONES), vector("rotation", O),
    vector("translation", O),
    choice("uv_format", "default origin_uv_top_left origin_uv_bottom_left", None)])


def _colour():
    return Property("color couleur", "colour", (1.0, 1.0, 1.0, 1.0))


def _attenuation():
    return [real("amplification", 1.0, 0.0), real("constant_attenuator", 1.0, 0.0),
            real("linear_attenuator", 0.0, 0.0), real("quadratic_attenuator", 0.0, 0.0)]


def _waves():
    return [size("wave_length longueur_onde", 550.0, unit=" nm"),
            integer("period_iteration", 10, 1), integer("nb_oscillator", 2, 0)]


def _aperture():
    return ([_colour(), vector("position", O)] + _attenuation() + _waves()
            + [size("width largeur", 0.001), size("height hauteur", 0.001),
               vector("front devant", Z), vector("up haut", Y)])


AMBIENT = Block("ambient_light lumiere_ambiante", [_colour()])
DIRECTIONAL = Block("directional_light lumiere_directionnelle",
                    [_colour(), vector("orientation", (0.0, 0.0, -1.0))], _directional)
POINT = Block("point_light lumiere_ponctuelle",
              [_colour(), vector("position", O)] + _attenuation(), _dark)
LINEAR = Block("linear_aperture_light",
               [_colour(), vector("point position", (O, (0.0, 0.0001, 0.0)), places=2, points=True)]
               + _attenuation() + _waves(), _linear)
RECTANGULAR = Block("rectangular_aperture_light", _aperture(), _planar)
ELLIPTICAL = Block("elliptical_aperture_light", _aperture(), _planar)
MASK = Block("aperture_mask_light", _aperture() + [text("mask masque")], _planar)

LIGHTS = (AMBIENT, DIRECTIONAL, POINT, LINEAR, RECTANGULAR, ELLIPTICAL, MASK)
MATERIALS = (MATERIAL, TEXTURE_MATERIAL)
SCENE_BLOCKS = {w: b for b in (CAMERA, VIEWPORT, RAYTRACER, PRIMITIVE, MODEL) + MATERIALS + LIGHTS
                for w in b.words}

# Shapes (3.7)


def _flat():
    return [vector("position", O), vector("normal normale", Z)]


def _disk():
    return _flat() + [size("ray rayon", 1.0)]


def _corners():
    return [vector("point", (O, Y, (1.0, 1.0, 0.0)), places=3)]


def _axis():
    return [vector("point position", (O, Z), places=2, points=True), size("ray rayon", 1.0)]


SHAPES = {w: b for b in (
    Block("sphere", [vector("position", O), size("ray rayon", 1.0)]),
    Block("plane plan", _flat(), _normal),
    Block("disk disque", _disk(), _normal),
    Block("annulus anneau", _disk() + [real("inner_ray rayon_interieur", 0.5, 0.0)], _annulus),
    Block("triangle", _corners(), _triangle),
    Block("btriangle", _corners() + [
        Property("normal normale", "direction", (None, None, None), places=3),
        Property("uv", "coordinates", ((0.0, 0.0),) * 3, places=3)], _triangle),
    Block("tube", _axis(), ends),
    Block("cylinder cylindre", _axis(), ends),
    Block("cone", _axis(), ends),
    Block("cube", [vector("position", O), size("size taille", 1.0)]),
    Block("spherical_cap calotte_spherique", _disk() + [real("curvature courbure", 1.0)], _cap),
    Block("lens lentille", _axis() + [real("curvature courbure", (1.0, 1.0), places=2)], lens),
    Block("torus tore", _flat() + [size("major_radius", 1.0), size("minor_radius", 0.2)], _normal),
    Block("geometry geometrie", [Property("scale homothetie", "scale", ONES),
                                 vector("rotation", O), vector("translation", O)], has_shape=True),
) for w in b.words}

# All words and their roles (word.roles)

ENDS = {"end", "fin"}
OTHER_BLOCKS = set("""texture_comparator texture_comparateur view_frustum viewfrustum
    default_material scene model_msr console_comparator comparateur_console particle particule
    particles_system systeme_particules""".split())
OTHER_PROPERTIES = set("""electric_charge charge_electrique application read_data read_scene
    write_data write_scene log_file_name log_console log_file viewport_image_count
    language langue""".split())
PROPERTIES = OTHER_PROPERTIES | {
    w for b in list(SCENE_BLOCKS.values()) + list(SHAPES.values()) for w in b.by_word}
WORDS = ENDS | set(SCENE_BLOCKS) | set(SHAPES) | OTHER_BLOCKS | PROPERTIES

COLOURS = {"black": (0.0, 0.0, 0.0), "noir": (0.0, 0.0, 0.0), "white": ONES, "blanc": ONES,
           "red": X, "rouge": X, "green": Y, "vert": Y, "blue": Z, "bleu": Z}
