"""Real roots of polynomials up to degree four (specification 4.2).

Degree two is plain arithmetic with an exact discriminant. Degrees three and four lie
between the zeros of the derivative, which are found in the same way; signs are taken from
floats where these are certain, and from whole numbers where they are not.
"""

import math
import struct
from fractions import Fraction

EPS = 2.0 ** -53


def _finite(*coefficients):
    """roots.total: from NaN or infinity, inside a program, no root."""
    return all(map(math.isfinite, coefficients))


def linear(a, b):
    """The root of a x + b (roots.linear.root, roots.identity, roots.finite)."""
    if a == 0 or not _finite(a, b):
        return []
    root = 0.0 - b / a
    return [root + 0.0] if math.isfinite(root) else []


def quadratic(a, b, c):
    """The roots of a x^2 + b x + c, ascending.

    Keeps roots.degree, roots.quadratic.count (the sign of the discriminant is exact),
    roots.quadratic.place, roots.quadratic.b-zero, roots.scale and roots.finite.
    """
    if not _finite(a, b, c):
        return []
    if a == 0:
        return linear(b, c)
    if b == 0 and c == 0:
        return [0.0, 0.0]
    sizes = [abs(x) for x in (a, b, c) if x != 0]
    largest, smallest = max(sizes), min(sizes)
    if not (1e-30 < smallest and largest < 1e30):
        top = math.frexp(largest)[1]
        if top - math.frexp(smallest)[1] > 230:
            return _wide_quadratic(a, b, c)
        a, b, c = (math.ldexp(x, -top) for x in (a, b, c))
    return _plain_quadratic(a, b, c)


def _plain_quadratic(a, b, c):
    """The reference algorithm, for coefficients whose products neither over- nor underflow."""
    u = b * b
    v = (4 * a) * c
    w = u + abs(v)
    d = u - v
    if d < 0:
        return []
    if not d > w / 4:
        exact = Fraction(b) * Fraction(b) - 4 * Fraction(a) * Fraction(c)
        if exact < 0:
            return []
        d = float(exact)
    s = math.sqrt(d)
    p = (b - s) / 2 if b < 0 else (b + s) / 2
    if b == 0:
        h = abs(p / a)
        pair = [-h, h] if h != 0 else [0.0, 0.0]
    else:
        pair = sorted((0.0 - p / a, 0.0 - c / p))
    return [x + 0.0 for x in pair if math.isfinite(x)]


def _wide_quadratic(a, b, c):
    """Coefficients of very different sizes: whole numbers, and each root rounded once."""
    return [x for x, _ in _integer_quadratic(*_integers((a, b, c)))]


def _integer_quadratic(a, b, c):
    """Roots, correctly rounded, with multiplicity, of a quadratic of whole numbers."""
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return []
    if discriminant == 0:
        root = _nearest(Fraction(-b, 2 * a))
        return [] if root is None else [(root, 1), (root, 1)]
    shift = max(0, 400 - discriminant.bit_length()) + 200
    shift += shift & 1
    size = math.isqrt(discriminant << (2 * shift))
    big = (b << shift) + (size if b >= 0 else -size)       # 2^shift (b + sgn(b) sqrt D)
    first = _nearest(Fraction(-big, (2 * a) << shift))
    second = _nearest(Fraction(-((2 * c) << shift), big))
    return [(x, 1) for x in sorted(x for x in (first, second) if x is not None)]


def _nearest(fraction):
    """The float nearest to a fraction, or None beyond the largest (roots.finite)."""
    try:
        return float(fraction) + 0.0
    except OverflowError:
        return None


def cubic(a, b, c, d):
    """The roots of a x^3 + b x^2 + c x + d (roots.cubic.count and what follows it)."""
    if not _finite(a, b, c, d):
        return []
    if a == 0:
        return quadratic(b, c, d)
    if d == 0:
        return sorted(quadratic(a, b, c) + [0.0])          # roots.zero-root
    return _roots((a, b, c, d))


def quartic(a, b, c, d, e):
    """The roots of a x^4 + b x^3 + c x^2 + d x + e (roots.quartic.count and what follows it)."""
    if not _finite(a, b, c, d, e):
        return []
    if a == 0:
        return cubic(b, c, d, e)
    if e == 0:
        return sorted(cubic(a, b, c, d) + [0.0])           # roots.zero-root
    return _roots((a, b, c, d, e))


def _roots(coefficients):
    found = []
    for root, times in _Polynomial(_integers(coefficients)).zeros():
        found.extend([root] * times)
    return found


def _integers(coefficients):
    """Whole numbers in the ratio of the given floats."""
    pairs = [x.as_integer_ratio() for x in coefficients]
    common = max(q for _, q in pairs)                      # all are powers of two
    return [p * (common // q) for p, q in pairs]


class _Polynomial:
    """A polynomial of whole numbers, the leading coefficient first and not zero."""

    def __init__(self, exact):
        self.exact = exact
        self.degree = len(exact) - 1
        top = max(x.bit_length() for x in exact)
        low = min(x.bit_length() for x in exact if x)
        self.quick = None
        if top - low < 400:
            shift = top - 64
            self.quick = [_scaled(x, shift) for x in exact]

    def value(self, p, q):
        """The exact value at p / q times q^degree, and the sum of its terms' sizes."""
        total, size, power = 0, 0, 1
        ap = abs(p)
        for coefficient in self.exact:
            total = total * p + coefficient * power
            size = size * ap + abs(coefficient) * power
            power *= q
        return total, size

    def sign(self, x):
        """The exact sign at the float x."""
        if self.quick is not None and 1e-20 < abs(x) < 1e20:
            total, size, ax = 0.0, 0.0, abs(x)
            for coefficient in self.quick:
                total = total * x + coefficient
                size = size * ax + abs(coefficient)
            if abs(total) > 6e-14 * size:
                return 1 if total > 0 else -1
        return self.sign_at(*x.as_integer_ratio())

    def sign_at(self, p, q):
        """The exact sign at p / q."""
        total, _ = self.value(p, q)
        return (total > 0) - (total < 0)

    def derivative(self):
        n = self.degree
        return _Polynomial([k * (n - i) for i, k in enumerate(self.exact[:-1])])

    def zeros(self):
        """Pairs of a zero and its multiplicity, ascending (roots.ascending, roots.multiple)."""
        if self.degree == 0:
            return []
        if self.exact[-1] == 0:                            # roots.zero-root
            times, rest = 0, list(self.exact)
            while rest[-1] == 0:
                rest.pop()
                times += 1
            others = _Polynomial(rest).zeros()
            return sorted(others + [(0.0, times)])
        if self.degree == 1:
            root = _nearest(Fraction(-self.exact[1], self.exact[0]))
            return [] if root is None else [(root, 1)]
        if self.degree == 2:
            # a derivative, for which roots.multiple holds as well: c = -b / (2 a),
            # p(c) = -(b^2 - 4 a c') / (4 a), T c^2 = b^2 / (4 a)
            a, b, rest = self.exact
            if abs(b * b - 4 * a * rest) << 52 <= 3 * b * b:
                root = _nearest(Fraction(-b, 2 * a))
                return [] if root is None else [(root, 2)]
            pairs = _integer_quadratic(*self.exact)
            if len(pairs) == 2 and pairs[0][0] == pairs[1][0]:
                return [(pairs[0][0], 2)]
            return pairs
        return self._between(self.derivative().zeros())

    def _between(self, turns):
        """The zeros between the zeros of the derivative (roots.cubic.count, roots.quartic.count)."""
        found = []
        bound = self._bound()
        left, left_sign = -bound, self.sign(-bound)
        looks = [(c, m, *self._at_turn(c, m)) for c, m in turns if -bound < c < bound]
        for i, (c, m, here, flat) in enumerate(looks):
            if flat is not None and self.sign(c) != 0 and any(
                    beside[3] is not None for beside in looks[max(i - 1, 0):i] + looks[i + 1:i + 2]):
                here, flat = self.sign(c), None            # two neighbours cannot both be roots
            before = here if flat is None else flat * (-1) ** (m + 1)
            if left_sign * before < 0:
                found.append((self._single(left, left_sign, c), 1))
            if flat is not None:                           # a zero of multiplicity m + 1
                found.append((c, m + 1))
                here = flat
            left, left_sign = c, here
        if left_sign * self.sign(bound) < 0:
            found.append((self._single(left, left_sign, bound), 1))
        return found

    def _at_turn(self, c, m):
        """The sign at the zero c of the derivative, of multiplicity m; or, where the value
        counts as zero (roots.multiple), the sign of the Taylor coefficient of degree m + 1."""
        total, size = self.value(*c.as_integer_ratio())
        taylor = list(self.exact)
        for _ in range(m + 1):
            n = len(taylor) - 1
            taylor = [k * (n - i) for i, k in enumerate(taylor[:-1])]
        p, q = c.as_integer_ratio()
        value, power = 0, 1
        for coefficient in taylor:
            value = value * p + coefficient * power
            power *= q
        # both sides times q^degree: T c^(m+1) q^degree is value p^(m+1) / (m+1)!
        step = abs(value * p ** (m + 1))
        near = abs(total) * 4 * math.factorial(m + 1) << (25 * (m + 1))
        if near <= 3 * step and abs(total) << 50 <= size:
            return 0, (value > 0) - (value < 0)
        return (total > 0) - (total < 0), None

    def _single(self, low, low_sign, high):
        """The one zero between low, where the sign is low_sign, and high: the nearest float
        (roots.residual, roots.simple)."""
        a, b = _index(low), _index(high)
        near = self._newton(low, low_sign, high)
        if near is not None:           # a narrow bracket around it, if it is one
            middle = _index(near)
            for c in (middle - 2, middle + 2):
                if a < c < b:
                    sign = self.sign(_from_index(c))
                    if sign == low_sign:
                        a = c
                    elif sign == -low_sign:
                        b = c
        while b - a > 1:
            middle = (a + b) // 2
            x = _from_index(middle)
            sign = self.sign(x)
            if sign == 0:
                return x + 0.0
            if sign == low_sign:
                a = middle
            else:
                b = middle
        x, y = _from_index(a), _from_index(b)
        (p, q), (r, s) = x.as_integer_ratio(), y.as_integer_ratio()
        sign = self.sign_at(p * s + r * q, 2 * q * s)      # half way
        return (y if sign == low_sign else x) + 0.0

    def _newton(self, low, low_sign, high):
        """Next to the zero between low and high, by floats; or None. It only saves time."""
        if self.quick is None or not 1e-20 < max(abs(low), abs(high)) < 1e20:
            return None
        x = 0.5 * (low + high)
        for _ in range(60):
            value = slope = 0.0
            for coefficient in self.quick:
                slope = slope * x + value
                value = value * x + coefficient
            if value == 0:
                return x
            if (value > 0) == (low_sign > 0):
                low = x
            else:
                high = x
            after = x - value / slope if slope != 0 else low
            if not low < after < high:
                after = 0.5 * (low + high)
            if abs(after - x) <= 2e-16 * abs(x):
                return after
            x = after
        return x

    def _bound(self):
        """A power of two above the size of every zero (M. Fujiwara), or the largest number."""
        lead = self.exact[0].bit_length()
        exponent = 1 + max(-((lead - 1 - k.bit_length()) // i)
                           for i, k in enumerate(self.exact[1:], 1) if k)
        return _LARGEST if exponent > 1023 else math.ldexp(1.0, max(exponent, -1070))


def _scaled(x, shift):
    """x / 2^shift as a float, to 2^-52."""
    spare = max(0, x.bit_length() - 64)
    return math.ldexp(float(x >> spare), spare - shift)


_LARGEST = math.ldexp(1.0 - EPS, 1024)


def _index(x):
    """The place of a float among all floats (numbers.ulp)."""
    bits = struct.unpack("<q", struct.pack("<d", x))[0]
    return bits if bits >= 0 else -(bits & 0x7FFFFFFFFFFFFFFF)


def _from_index(i):
    """The float at a place."""
    if i >= 0:
        return struct.unpack("<d", struct.pack("<q", i))[0]
    return -struct.unpack("<d", struct.pack("<q", -i))[0]
