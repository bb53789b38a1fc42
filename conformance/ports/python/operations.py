"""The operations of the protocol (protocol.operations): functions from the object `in` to the
JSON of `ok`."""

import base64

import canonical
import inputs as I
import language as L
import light
import optics
import rays
import roots
import vector as V
from camera import Camera
from checking import check
from picture import Picture
from shapes.cone import double_cone
from shapes.planar import plane_parameters
from shapes.sphere import sphere_parameters
from shapes.torus import Torus
from shapes.triangle import barycentric, collinear
from shapes.tube import tube_parameters
from transform import Transformation

OPERATIONS = {}


def operation(name):
    def register(function):
        OPERATIONS[name] = function
        return function
    return register


# maths

def _two(function):
    return lambda o: function(I.vector(o, "a"), I.vector(o, "b"))


OPERATIONS["vector.add"] = _two(V.add)
OPERATIONS["vector.subtract"] = _two(V.subtract)
OPERATIONS["vector.cross"] = _two(V.cross)
OPERATIONS["vector.dot"] = _two(V.dot)
OPERATIONS["vector.distance"] = _two(V.distance)
OPERATIONS["vector.angle"] = _two(V.angle)
OPERATIONS["vector.scale"] = lambda o: V.scale(I.number(o, "k"), I.vector(o, "a"))
OPERATIONS["vector.modulus"] = lambda o: V.modulus(I.vector(o, "a"))
OPERATIONS["vector.normalize"] = lambda o: V.unit(I.vector(o, "a"))


def _solver(function, names):
    return lambda o: function(*[I.number(o, name) for name in names])


OPERATIONS["roots.linear"] = _solver(roots.linear, "ab")
OPERATIONS["roots.quadratic"] = _solver(roots.quadratic, "abc")
OPERATIONS["roots.cubic"] = _solver(roots.cubic, "abcd")
OPERATIONS["roots.quartic"] = _solver(roots.quartic, "abcde")


def _transformation(o):
    scale = I.vector(o, "scale", (1.0, 1.0, 1.0))
    if 0 in scale:
        raise I.Refused("scale has a zero")
    return Transformation(scale, I.vector(o, "rotation", V.ZERO), I.vector(o, "translation", V.ZERO))


OPERATIONS["transform.matrix"] = lambda o: _transformation(o).matrix()
OPERATIONS["transform.position"] = lambda o: _transformation(o).position(I.vector(o, "vector"))
OPERATIONS["transform.direction"] = lambda o: _transformation(o).direction(I.vector(o, "vector"))
OPERATIONS["transform.normal"] = lambda o: _transformation(o).normal(I.unit(o, "vector"))


def _ray(ray):
    return {"origin": ray[0], "direction": ray[1]}


OPERATIONS["transform.ray"] = lambda o: _ray(_transformation(o).ray(I.ray(o)))

# geometry

OPERATIONS["ray.position"] = lambda o: rays.position(I.ray(o), I.number(o, "t"))


@operation("intersect.plane")
def _plane(o):
    return plane_parameters(I.ray(o), I.vector(o, "position"),
                            V.unit(I.direction(o, "normal", L.SMALLEST_LENGTH)))


@operation("intersect.sphere")
def _sphere(o):
    radius = I.positive(o, "radius")
    return sphere_parameters(I.ray(o), I.vector(o, "position"), radius * radius)


@operation("intersect.tube")
def _tube(o):
    return tube_parameters(I.ray(o), I.vector(o, "point"), I.unit(o, "axis"),
                           I.positive(o, "radius"))


@operation("intersect.cones")
def _cones(o):
    return double_cone(I.ray(o), I.vector(o, "point"), I.vector(o, "apex"),
                       I.positive(o, "radius"))


@operation("intersect.torus")
def _torus(o):
    torus = Torus(I.vector(o, "position"), I.direction(o, "normal", L.SMALLEST_LENGTH),
                  I.positive(o, "major_radius"),
                  I.positive(o, "minor_radius"))
    return torus.all_parameters(I.ray(o))


@operation("geometry.hit")
def _hit(o):
    hit = I.shape(o, "geometry").hit(I.ray(o))
    if hit is None:
        return None
    return {"t": hit.t, "point": hit.point, "normal": hit.normal, "uv": hit.uv}


@operation("geometry.contains")
def _contains(o):
    return I.shape(o, "geometry").contains(I.vector(o, "point"))


@operation("triangle.barycentric")
def _barycentric(o):
    points = I.field(o, "points")
    if not isinstance(points, list) or len(points) != 3:
        raise I.Refused("points are not three")
    corners = [I.to_vector(p, "points") for p in points]
    if collinear(*corners):
        raise I.Refused("the points make no triangle")
    return barycentric(*corners, I.vector(o, "point"))


# optics

@operation("optics.reflect")
def _reflect(o):
    v, n = I.unit(o, "direction"), I.unit(o, "normal")
    return optics.reflect(v, optics.against(n, v))


@operation("optics.refract")
def _refract(o):
    v, n = I.unit(o, "direction"), I.unit(o, "normal")
    indices = [I.positive(o, name) for name in ("n1", "n2")]
    return optics.refract(v, optics.against(n, v), *indices)


# lighting

OPERATIONS["light.ambient"] = lambda o: light.ambient(I.colour(o, "light"), I.colour(o, "surface"))


@operation("light.lambert")
def _lambert(o):
    return light.lambert(I.colour(o, "light"), I.colour(o, "surface"), I.unit(o, "normal"),
                         I.vector(o, "direction"))


def _highlight(term):
    return lambda o: term(I.colour(o, "light"), I.colour(o, "surface"), I.unit(o, "normal"),
                          I.vector(o, "direction"), I.vector(o, "view"),
                          I.at_least(o, "shininess", 0.0))


OPERATIONS["light.blinn"] = _highlight(light.blinn)
OPERATIONS["light.phong"] = _highlight(light.phong)

# scene and picture


@operation("scene.check")
def _check(o):
    scene, diagnostics = check(I.text(o))
    return {"diagnostics": diagnostics, "canonical": canonical.text(scene)}


def _place(o, scene):
    view = scene.viewport.values
    return I.whole(o, "column", 0, view["width"]), I.whole(o, "row", 0, view["height"])


@operation("camera.ray")
def _camera_ray(o):
    """camera.ray.operation"""
    scene, _ = check(I.text(o))
    column, row = _place(o, scene)
    sample = I.whole(o, "sample", 0, scene.raytracer.values["sampling"], default=0)
    return _ray(Camera(scene).ray(column, row, sample))


@operation("scene.pixel")
def _pixel(o):
    scene, _ = check(I.text(o))
    return Picture(scene).pixel(*_place(o, scene))


@operation("scene.picture")
def _picture(o):
    scene, _ = check(I.text(o))
    picture = Picture(scene)
    return {"width": picture.camera.width, "height": picture.camera.height,
            "rgba": base64.b64encode(picture.bytes()).decode("ascii")}
