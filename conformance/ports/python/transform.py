"""Scale, then rotations about x, y, z, then a translation (specification 4.3)."""

import math

import vector as V


def _cos_sin(degrees):
    """Cosine and sine of an angle in degrees, reduced to quarter turns (transform.quarters)."""
    rest = math.fmod(degrees, 360.0)
    turns = round(rest / 90.0)
    rest -= 90.0 * turns
    if rest == 0:
        c, s = 1.0, 0.0
    else:
        c, s = math.cos(math.radians(rest)), math.sin(math.radians(rest))
    for _ in range(turns % 4):
        c, s = -s, c
    return c + 0.0, s + 0.0


class Transformation:
    """p' = L p + T with L = Rz Ry Rx S (transform.matrix, transform.order)."""

    def __init__(self, scale=(1.0, 1.0, 1.0), rotation=V.ZERO, translation=V.ZERO):
        cx, sx = _cos_sin(rotation[0])
        cy, sy = _cos_sin(rotation[1])
        cz, sz = _cos_sin(rotation[2])
        turn = ((cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx),
                (sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx),
                (-sy, cy * sx, cy * cx))                   # transform.tolerance
        self.rows = tuple(tuple(row[i] * scale[i] for i in range(3)) for row in turn)
        # transform.inverse: the columns of the rotation, each divided by its factor
        self.inverse = tuple(tuple(turn[j][i] / scale[i] for j in range(3)) for i in range(3))
        self.translation = translation

    def matrix(self):
        """Four rows of four numbers (transform.matrix)."""
        return [list(self.rows[i]) + [self.translation[i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]

    def direction(self, d):
        """L d (transform.direction)."""
        return tuple(V.dot(row, d) for row in self.rows)

    def position(self, p):
        """L p + T (transform.position)."""
        return V.add(self.direction(p), self.translation)

    def ray(self, ray):
        """The ray from the image of the origin, not made unit (transform.ray)."""
        return (self.position(ray[0]), self.direction(ray[1]))

    def normal(self, n):
        """(L^-1)^T n made unit, or None (transform.normal, transform.normal.mirror)."""
        r = self.inverse
        return V.unit(tuple((r[0][j] * n[0] + r[1][j] * n[1]) + r[2][j] * n[2] for j in range(3)))

    def direction_back(self, d):
        """L^-1 d (transform.inverse)."""
        return tuple(V.dot(row, d) for row in self.inverse)

    def position_back(self, p):
        """L^-1 (p - T) (transform.inverse)."""
        return self.direction_back(V.subtract(p, self.translation))
