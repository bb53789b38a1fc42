"""What a ray sees (specification 6.4 to 6.6, 7.3 to 7.6)."""

import language as L
import light
import optics
import vector as V
from waves import Waves

BUDGET = 65536                         # optics.budget

# light.algorithm: ambient, lambert, highlight
TERMS = {"ambient": (True, False, None), "diffuse": (False, True, None),
         "phong_specular": (False, False, light.phong),
         "blinn_specular": (False, False, light.blinn), "no_specular": (True, True, None),
         "phong": (True, True, light.phong), "blinn": (True, True, light.blinn)}


class Light:
    """A light of a scene: what it gives at a point."""

    def __init__(self, item):
        v = item.values
        self.kind = item.block
        self.colour = v["color"][:3]
        if item.block is L.DIRECTIONAL:
            self.direction = V.unit(v["orientation"])
        elif item.block is not L.AMBIENT:
            self.amplification = v["amplification"]
            self.attenuation = (v["constant_attenuator"], v["linear_attenuator"],
                                v["quadratic_attenuator"])
            self.waves = None if item.block is L.POINT else Waves(item)
            self.position = v["position"] if item.block is L.POINT else self.waves.position

    def gives(self, world, material, point, n, view, terms):
        """light.sum, one light's part of it."""
        ambient, lambert, highlight = terms
        if self.kind is L.AMBIENT:                         # light.source.ambient
            return light.ambient(self.colour, material.ambient) if ambient else light.BLACK
        if self.kind is L.DIRECTIONAL:                     # light.source.directional
            d, factor, distance = self.direction, 1.0, float("inf")
        else:                                              # light.source.point
            away = V.subtract(point, self.position)
            distance = V.modulus(away)
            if distance == 0:                              # light.source.at-zero
                return light.BLACK
            d = (away[0] / distance, away[1] / distance, away[2] / distance)
            constant, linear, quadratic = self.attenuation
            denominator = constant + linear * distance + quadratic * distance * distance
            if denominator == 0:                           # light.source.zero-denominator
                return light.BLACK
            factor = self.amplification / denominator
        if V.dot(n, V.negate(d)) <= 0:                     # light.shadow.turned-away
            return light.BLACK
        if self.kind is not L.DIRECTIONAL and self.waves is not None:
            # light.wave.gives, light.wave.shadow
            colour = self.waves.colour
            if world.shadowed(colour, point, d, distance) is None:
                return light.BLACK
            return V.scale(factor * self.waves.intensity(point), colour)
        colour = world.shadowed(self.colour, point, d, distance)
        if colour is None:
            return light.BLACK
        sum_ = light.BLACK
        if lambert:
            sum_ = V.add(sum_, light.lambert(colour, material.diffuse, n, d))
        if highlight:
            sum_ = V.add(sum_, highlight(colour, material.specular, n, d, view,
                                         material.shininess))
        return V.scale(factor, sum_)


class Shader:
    def __init__(self, scene, world):
        self.world = world
        self.algorithm = scene.raytracer.values["reflexion_algorithm"]
        self.terms = TERMS.get(self.algorithm)
        self.levels = scene.raytracer.values["recursive_level"]
        self.far = scene.camera.values["far_clipping_plane"]
        self.lights = [Light(item) for item in scene.lights]

    def colour(self, ray):
        """The colour that a primary ray sees, with alpha."""
        if self.algorithm == "no_light":                   # light.algorithm.no-light
            found = self.world.closest(ray, self.far)
            if found is None:
                return (0.0, 0.0, 0.0, 1.0)                # camera.background
            material = found[0].material
            return material.diffuse + (material.alpha,)
        return self.followed(ray) + (1.0,)                 # light.opaque

    def followed(self, ray):
        """optics.colour, optics.depth, optics.budget, optics.budget.stack, optics.sum: a stack
        of rays with their weights, depth first, the reflected ray before the refracted one."""
        total = light.BLACK
        stack = [(ray, (1.0, 1.0, 1.0), 1, None)]
        count = 0
        while stack and count < BUDGET:
            ray, weight, depth, medium = stack.pop()
            count += 1
            found = self.world.closest(ray, self.far)
            if found is None:                              # optics.background
                continue
            primitive, hit = found
            material, v = primitive.material, ray[1]
            outwards = not V.dot(v, hit.normal) < 0        # geometry.hit.shading-normal
            n = V.negate(hit.normal) if outwards else hit.normal
            direct = light.BLACK
            for source in self.lights:
                direct = V.add(direct, source.gives(self.world, material, hit.point, n, v,
                                                    self.terms))
            total = V.add(total, light.product(weight, direct))
            if depth >= self.levels:
                continue
            if medium is None and (material.kr != 0 or material.kt != 0):
                medium = self.world.medium(ray[0])         # optics.medium.start
            refracted = None
            if material.kt != 0 and primitive.shape.closed:    # optics.body.closed
                if V.dot(v, hit.normal) > 0:               # optics.body.leaving
                    n2 = self.world.medium(hit.point, primitive)
                    share = (material.kt,) * 3
                else:                                      # optics.body.entering
                    n2, share = material.index, material.tint
                direction = optics.refract(v, n, medium, n2)
                if direction is not None:                  # optics.body.total
                    refracted = ((hit.point, direction), light.product(weight, share),
                                 depth + 1, n2)
            if refracted is not None:
                stack.append(refracted)
            if material.kr != 0:                           # optics.mirror, optics.body.order
                stack.append(((hit.point, optics.reflect(v, n)), V.scale(material.kr, weight),
                              depth + 1, medium))
        return total
