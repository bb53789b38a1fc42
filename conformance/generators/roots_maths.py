"""The cases of roots.*: chapter 4.2.

Real roots of the polynomial with exactly the given coefficients, in whole numbers and fractions: equal roots by the greatest common divisor of the polynomial and its
derivative, the places of the others by Sturm's theorem and bisection to 200 bits. The bound of a comparison follows from roots.residual: at a single root x the error is at
most 8 eps s / |p'(x)|, s the sum of the sizes of the terms.
"""

import math
import random
import sys

sys.dont_write_bytecode = True

from fractions import Fraction  # noqa: E402

from suite import EXACT, Raw, case, main, nearest  # noqa: E402

TINY, LEAST, MOST = 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308
EPS = Fraction(1, 2**53)


# Polynomials with fractions for coefficients, the leading one first


def stripped(p):
    while p and p[0] == 0:
        p = p[1:]
    return p


def value(p, x):
    total = Fraction(0)
    for c in p:
        total = total * x + c
    return total


def derivative(p):
    n = len(p) - 1
    return [c * (n - i) for i, c in enumerate(p[:-1])]


def divided(p, q):
    p, quotient = list(p), []
    while len(p) >= len(q):
        factor = p[0] / q[0]
        quotient.append(factor)
        p = [a - factor * b for a, b in zip(p, q + [Fraction(0)] * (len(p) - len(q)))][1:]
    return quotient, stripped(p)


def common(p, q):
    while q:
        p, q = q, divided(p, q)[1]
        q = [c / q[0] for c in q] if q else q
    return [c / p[0] for c in p]


def whole(p):
    """The polynomial times a number above zero, its coefficients whole numbers without a common divisor."""
    shared = math.lcm(*[c.denominator for c in p])
    p = [int(c * shared) for c in p]
    divisor = math.gcd(*p)
    return [c // divisor for c in p]


def sign_at(p, m, k):
    """The sign of a polynomial of whole numbers at m / 2^k."""
    total, power = 0, 0
    for c in p:
        total = total * m + (c << power)
        power += k
    return (total > 0) - (total < 0)


def sturm(p):
    chain = [p, derivative(p)]
    while len(chain[-1]) > 1:
        rest = divided(chain[-2], chain[-1])[1]
        if not rest:
            break
        chain.append([Fraction(-c) for c in whole(rest)])
    return [whole(q) for q in chain]


def changes(chain, m, k):
    signs = [s for s in (sign_at(p, m, k) for p in chain) if s != 0]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def single_roots(p):
    """The real roots of a polynomial without equal ones, each as a fraction to a relative error of 2^-200 (exactly, where the bisection meets it)."""
    if len(p) < 2:
        return []
    if len(p) == 2:
        return [-p[1] / p[0]]
    chain, found = sturm(p), []
    largest = max(abs(c / p[0]) for c in p[1:]) + 2
    bound = 1 << max(1, largest.numerator.bit_length() - largest.denominator.bit_length() + 1)

    # Each entry: an interval (low / 2^k, high / 2^k] and how many roots are in it.
    waiting = [(-bound, bound, 0, changes(chain, -bound, 0) - changes(chain, bound, 0))]
    while waiting:
        low, high, k, many = waiting.pop()
        if many > 1:
            low, high, k = 2 * low, 2 * high, k + 1
            middle = (low + high) // 2
            left = changes(chain, low, k) - changes(chain, middle, k)
            waiting += [(low, middle, k, left), (middle, high, k, many - left)]
        elif many == 1:
            found.append(refined(chain[0], low, high, k))
    return found


def refined(p, low, high, k):
    """The only root in (low / 2^k, high / 2^k]."""
    sign = sign_at(p, high, k)
    if sign == 0:
        return Fraction(high, 1 << k)
    while (high - low) << 200 >= abs(low + high):
        low, high, k = 2 * low, 2 * high, k + 1
        middle = (low + high) // 2
        at = sign_at(p, middle, k)
        if at == 0:
            return Fraction(middle, 1 << k)
        low, high = (low, middle) if at == sign else (middle, high)
    return Fraction(low + high, 2 << k)


KNOWN = {}


def real_roots(coefficients):
    """All real roots, ascending, as often as their multiplicity."""
    p = stripped([Fraction(c) for c in coefficients])
    key = tuple(p)
    if key not in KNOWN:
        found = []
        while len(p) > 1:
            shared = common(p, derivative(p))
            found += single_roots(divided(p, shared)[0])
            p = shared
        KNOWN[key] = sorted(found)
    return KNOWN[key]


def bound(coefficients, roots):
    """A relative error that roots.residual allows to every single root, with a factor 2 for the terms of second order, and at least 1e-15."""
    p = stripped([Fraction(c) for c in coefficients])
    slope, worst = derivative(p), Fraction(1, 10**15)
    for x in roots:
        if x != 0:
            size = value([abs(c) for c in p], abs(x))
            worst = max(worst, 16 * EPS * size / abs(value(slope, x)) / abs(x))
    return f"rel:{float(worst) * 1.06:.1e}"


def separated(coefficients):
    """Whether no two different real roots lie closer than 2^-20 of their size."""
    roots = sorted(set(real_roots(coefficients)))
    return all(abs(b - a) > Fraction(1, 2**20) * max(abs(a), abs(b)) for a, b in zip(roots, roots[1:]))


def finite(x):
    try:
        return math.isfinite(nearest(x))
    except OverflowError:
        return False


def sent(*coefficients):
    return dict(zip("abcde", coefficients))


# Degree one


def linear_answer(a, b):
    if a == 0:
        return []
    x = -Fraction(b) / Fraction(a)
    return [nearest(x)] if finite(x) else []


def roots_linear():
    table = [
        ("A root of 1.5.", "roots.linear.root", "sign", 2, -3), ("A negative root.", "roots.linear.root", "sign", 2, 3), ("A third.", "roots.linear.root", "reciprocal", 3, -1), ("Minus a third.", "roots.linear.root", "reciprocal", 3, 1),
        ("Both negative.", "roots.linear.root", "sign", -7, -22), ("5/49: 5 x (1/49) is another number.", "roots.linear.root", "reciprocal", 49, -5), ("3/5.", "roots.linear.root", "reciprocal", -5, 3), ("1/1.", "roots.linear.root", "swapped-index", 1, 1),
        ("A small and a large one.", "roots.linear.root roots.degree", "epsilon", 1e-12, 1), ("The coefficient of x is below 1e-100, and counts.", "roots.degree roots.linear.root", "epsilon", 1e-101, 3), ("It is the smallest number, and counts.", "roots.degree", "epsilon", TINY, 1e-320),
        ("The root is zero, not -0.", "roots.no-negative-zero roots.linear.root", "negative-zero", 5, 0), ("The root is zero, b is -0.", "roots.no-negative-zero numbers.negative-zero", "negative-zero", 5, Raw("-0.0")), ("The root is zero, a is negative.", "roots.no-negative-zero", "negative-zero", -5, 0),
        ("0 x + 0 = 0.", "roots.identity roots.total", "zero", 0, 0), ("0 x + 1 = 0.", "roots.identity roots.total", "zero", 0, 1), ("-0 x - 3 = 0.", "roots.identity roots.degree", "zero negative-zero", Raw("-0.0"), -3), ("-0 x + 0 = 0.", "roots.identity", "zero negative-zero", Raw("-0.0"), Raw("-0.0")),
        ("0 x + the smallest number.", "roots.identity", "epsilon", 0, TINY), ("The root overflows.", "roots.finite numbers.not-finite conformance.total", "overflow", 1e-300, 1e300), ("The root overflows to the other side.", "roots.finite numbers.not-finite", "overflow", -1e-300, 1e300),
        ("The largest number.", "roots.finite", "overflow", 1, -MOST), ("The largest number, doubled by a = 1/2, overflows.", "roots.finite", "overflow", 0.5, MOST), ("The smallest number.", "roots.total numbers.subnormal", "flush-to-zero", 1, TINY), ("A subnormal root.", "numbers.subnormal", "flush-to-zero", 3, 1e-310),
        ("The root underflows to 0.", "numbers.subnormal roots.no-negative-zero", "flush-to-zero negative-zero", 1e300, 1e-300), ("The largest coefficients.", "roots.scale roots.total", "overflow", MOST, -MOST), ("The smallest coefficients.", "roots.scale", "underflow", TINY, -2 * TINY),
        ("2^900 times 3 x - 1.", "roots.scale", "overflow", 3 * 2.0**900, -(2.0**900)), ("-2^-900 times 3 x - 1.", "roots.scale", "underflow sign", -3 * 2.0**-900, 2.0**-900), ("Neighbours.", "roots.linear.root", "rounding", 1.0000000000000002, -1),
        ("Random digits.", "roots.linear.root", "reciprocal rounding", 0.7312871236, -5.1235812), ("Random digits.", "roots.linear.root", "reciprocal rounding", -812.12312, -0.00123123), ("Random digits.", "roots.linear.root", "reciprocal rounding", 6.02214076e23, 6.62607015e-34),
    ]
    return [case(rules, comment, flags, sent(a, b), linear_answer(float(a), float(b)), "exact", EXACT) for comment, rules, flags, a, b in table]


# Degree two


def root_bits(n, bits=400):
    """The square root of a fraction above zero, with so many bits."""
    n = Fraction(n)
    shift = bits - (n.numerator.bit_length() - n.denominator.bit_length()) // 2
    shift = max(shift, 0)
    return Fraction(math.isqrt((n.numerator << (2 * shift)) // n.denominator), 1 << shift)


def quadratic_answer(a, b, c):
    if a == 0:
        return linear_answer(b, c)
    a, b, c = Fraction(a), Fraction(b), Fraction(c)
    inside = b * b - 4 * a * c
    if inside < 0:
        return []
    s = root_bits(inside) if inside else Fraction(0)
    q = (b + s) / 2 if b >= 0 else (b - s) / 2
    found = sorted([-q / a, -c / q] if q else [Fraction(0), Fraction(0)])
    return [nearest(x) for x in found if finite(x)]


def near_tangents(seed, count):
    """Coefficients below 2^53 whose discriminant is small and not what a rounded one says: (a, b, c). A change of variables with the determinant 1 leaves the discriminant alone."""
    source, made = random.Random(seed), []
    bases = [(1, 1, 0), (1, 0, -1), (1, 1, 1), (1, 0, 1), (1, 1, -1), (2, 1, 3), (-1, 1, -1), (-1, 1, 1)]
    while len(made) < count:
        size = source.choice((14, 18, 22, 25))
        p, r = source.randint(2 ** (size - 1), 2**size), source.choice((-1, 1)) * source.randint(2 ** (size - 1), 2**size)
        if math.gcd(p, r) != 1:
            continue
        s = pow(p, -1, abs(r))
        q = (p * s - 1) // r
        x, y, z = bases[len(made) % len(bases)]
        a, b, c = x * p * p + y * p * r + z * r * r, 2 * x * p * q + y * (p * s + q * r) + 2 * z * r * s, x * q * q + y * q * s + z * s * s
        if max(abs(a), abs(b), abs(c)) < 2**53 and b * b - 4 * a * c != float(b) * float(b) - 4.0 * float(a) * float(c):
            made.append((a, b, c))
    return made


def roots_quadratic():
    count, place, scale = "roots.quadratic.count", "roots.quadratic.place", "roots.scale"
    table = [
        ("1 and 2.", place + " roots.ascending conformance.means", "unsorted", 1, -3, 2), ("1 and 2, with a negative leading coefficient.", place + " roots.ascending", "unsorted", -1, 3, -2), ("-2 and -1.", place + " roots.ascending", "unsorted sign", 1, 3, 2), ("-2 and -1, a negative.", place + " roots.ascending", "unsorted sign", -1, -3, -2),
        ("-1 and 2.", place + " roots.ascending", "unsorted sign", 1, -1, -2), ("-2 and 1.", place + " roots.ascending", "unsorted sign", 1, 1, -2), ("-1 and 2, a negative.", place + " roots.ascending", "unsorted sign", -1, 1, 2), ("-2 and 1, a negative.", place + " roots.ascending", "unsorted sign", -1, -1, 2),
        ("Irrational roots of one sign.", place, "sign", 1, -3, 1), ("Irrational roots of both signs.", place, "sign", 1, -2, -1), ("The golden ratio.", place, "sign", 1, -1, -1), ("A leading coefficient other than 1.", place, "missing-normalisation", 3, -7, 2), ("The same halved.", place + " " + scale, "missing-normalisation", 1.5, -3.5, 1),
        ("0.1 x^2 + 0.7 x + 0.3.", place, "rounding", 0.1, 0.7, 0.3), ("No real root.", count, "sign", 1, 0, 1), ("No real root, both coefficients negative.", count, "sign", -1, 0, -1), ("No real root: 1, 1, 1.", count, "missing-factor", 1, 1, 1), ("No real root: 1, 3, 3, though 9 > 3.", count, "missing-factor", 1, 3, 3),
        ("Two roots where b^2 - 4ac is 1.", count, "missing-factor", 1, 5, 6), ("A double root: 2.", count + " roots.ascending roots.multiple", "double-root", 1, -4, 4), ("A double root: -1/3.", count + " roots.multiple", "double-root", 9, 6, 1), ("A double root, a negative: 2.", count + " roots.multiple", "double-root sign", -1, 4, -4),
        ("A double root: 0.", count + " roots.quadratic.b-zero", "double-root negative-zero", 1, 0, 0), ("A double root: 0, a negative.", count + " roots.no-negative-zero", "double-root negative-zero", -3, Raw("-0.0"), 0), ("A double root: 1 + 2^-26.", count + " roots.multiple", "double-root", 2.0**52, -2.0 * (2.0**52 + 2.0**26), 2.0**52 + 2.0**27 + 1),
        ("Two roots that are one step from each other: the discriminant is 4.", count + " " + place, "rounded-discriminant epsilon", 94906265.625, -189812534, 94906268.375), ("b b and 4 a c round to the same: the discriminant is 4.", count + " " + place, "rounded-discriminant", 1, 268435458, 18014398777917440),
        ("The discriminant is 4, of numbers of 2^54.", count + " " + place, "rounded-discriminant epsilon", 134217729, -268435456, 134217727), ("The discriminant is -23 and rounds to 0.", count, "rounded-discriminant", 132533782, 473675193, 423228299), ("The discriminant is 4 and rounds to 0.", count, "rounded-discriminant", 74396803, 389152506, 508891736),
        ("The discriminant is 1e-20: two roots.", count + " numbers.tolerances.only", "epsilon", 1, -2e-10, 0.75e-20), ("The discriminant is -4e-20: none.", count + " numbers.tolerances.only", "epsilon", 1, 0, 1e-20), ("The discriminant is -4e-300: none.", count + " numbers.tolerances.only", "epsilon", 1, 0, 1e-300), ("A tangent whose discriminant is 0, of small numbers.", count + " numbers.tolerances.only", "epsilon", 2.0**-60, 2.0**-59, 2.0**-60),
        ("The roots' sizes are 1e8 and 1e-8.", place, "catastrophic-cancellation", 1, -1e8, 1), ("The same with negative roots.", place, "catastrophic-cancellation sign", 1, 1e8, 1), ("The same, a negative.", place, "catastrophic-cancellation sign", -1, 1e8, -1), ("The roots' sizes are 1e9 and 1e-9, of both signs.", place, "catastrophic-cancellation", 1, 1e9, -1), ("The same the other way round.", place, "catastrophic-cancellation sign", 1, -1e9, -1),
        ("The sizes are 1e200 and 1e-200.", place + " " + scale, "catastrophic-cancellation overflow", 1e-200, -1, 1e-200), ("Root 1 and root -1e77: the smaller one is not lost.", place + " numbers.tolerances.only", "epsilon", 8.636168555094445e-78, 1, -1), ("c = 0: one root is 0.", place + " roots.no-negative-zero", "negative-zero", 2, -3, 0), ("c = 0, the other root is negative.", place + " roots.no-negative-zero", "negative-zero", 2, 3, 0),
        ("c = 0, a negative.", place + " roots.no-negative-zero", "negative-zero", -2, 3, Raw("-0.0")), ("A leading coefficient of 1e-10.", "roots.degree " + place, "epsilon", 1e-10, 1, -1), ("A leading coefficient of 1e-11.", "roots.degree " + place, "epsilon", 1e-11, 1, 1), ("A leading coefficient of 1e-20.", "roots.degree " + place, "epsilon", 1e-20, -3, 1),
        ("The smallest leading coefficient: the far root overflows.", "roots.degree roots.finite", "epsilon overflow", TINY, 1, -1), ("a = 0: the linear equation.", "roots.degree", "degree", 0, 2, -3), ("a = -0: the linear equation.", "roots.degree numbers.negative-zero", "degree negative-zero", Raw("-0.0"), 2, -3), ("a = 0, and b = 0: none.", "roots.degree roots.identity", "degree", 0, 0, 3), ("All zero: none.", "roots.identity roots.total", "degree", 0, 0, 0),
        ("a = 0, c = 0: zero.", "roots.degree roots.no-negative-zero", "degree negative-zero", 0, -4, 0), ("One root overflows, the other stays.", "roots.finite", "overflow", 1e-300, 1e100, -1e100), ("The same with other signs.", "roots.finite", "overflow", 1e-300, -1e100, -1e100), ("The large root overflows to the other side.", "roots.finite", "overflow sign", -1e-300, 1e100, 1e100), ("Both roots overflow.", "roots.finite numbers.not-finite", "overflow", 1e-320, 0, -1e300),
        ("b b overflows.", scale, "overflow", 1e200, -3e200, 2e200), ("The same, negative.", scale, "overflow sign", -1e200, 3e200, -2e200), ("4 a c overflows, b b does not.", scale, "overflow", 1e160, 1e100, -1e160), ("The largest numbers.", scale + " roots.total", "overflow", MOST, MOST, -MOST), ("The largest numbers, no root.", scale + " roots.total", "overflow", MOST, MOST, MOST),
        ("2^900 times x^2 - 3 x + 1.", scale, "overflow", 2.0**900, -3 * 2.0**900, 2.0**900), ("-2^-900 times x^2 - 3 x + 1.", scale, "underflow sign", -(2.0**-900), 3 * 2.0**-900, -(2.0**-900)), ("2^-1070 times x^2 - 3 x + 2: subnormal numbers.", scale, "underflow", 2.0**-1070, -3 * 2.0**-1070, 2 * 2.0**-1070), ("The smallest numbers.", scale + " roots.quadratic.b-zero", "underflow", TINY, 0, -4 * TINY),
        ("Squares that underflow: a tangent stays one.", scale + " " + count, "underflow double-root", 2.0**-600, 2.0**-599, 2.0**-600), ("Squares that underflow: no root stays none.", scale + " " + count, "underflow", 2.0**-600, 2.0**-599, 1.0000000000000002 * 2.0**-600), ("Squares that underflow: two stay two.", scale + " " + count, "underflow", 2.0**-600, 2.0**-599, 0.9999999999999999 * 2.0**-600),
        ("2^500 times a polynomial with the discriminant -23.", scale + " " + count, "overflow rounded-discriminant", 132533782 * 2.0**500, 473675193 * 2.0**500, 423228299 * 2.0**500), ("2^-540 times the same.", scale + " " + count, "underflow rounded-discriminant", 132533782 * 2.0**-540, 473675193 * 2.0**-540, 423228299 * 2.0**-540),
        ("2^500 times a polynomial with the discriminant 4.", scale + " " + count, "overflow rounded-discriminant", 74396803 * 2.0**500, 389152506 * 2.0**500, 508891736 * 2.0**500), ("-2^-540 times the same.", scale + " " + count, "underflow rounded-discriminant sign", -74396803 * 2.0**-540, -389152506 * 2.0**-540, -508891736 * 2.0**-540),
        ("Coefficients of very different sizes.", scale + " " + place, "overflow", 1e-150, 1e150, 1e10), ("Sizes the other way round.", scale + " " + place, "overflow", 1e150, 1e150, 1e-150), ("b is far smaller than sqrt(a c).", place, "rounding", 1, 1e-30, -2), ("b is far smaller, and there is no root.", count, "rounding", 1, 1e-30, 2),
        ("Subnormal roots.", "numbers.subnormal " + place, "flush-to-zero", 1, 0, -1e-320), ("One step above a double root: none.", count, "epsilon", 1, -2, 1.0000000000000002), ("One step below a double root: two.", count + " " + place, "epsilon", 1, -2, 0.9999999999999999), ("b one step away from a double root: two.", count + " " + place, "epsilon", 1, -2.0000000000000004, 1), ("b one step the other way: none.", count, "epsilon", 1, -1.9999999999999998, 1),
        ("a one step above: none.", count, "epsilon", 1.0000000000000002, -2, 1), ("a one step below: two.", count + " " + place, "epsilon", 0.9999999999999999, -2, 1), ("b negative, one step: roots that nearly touch, negative.", count + " " + place, "epsilon sign", 1, 2.0000000000000004, 1),
    ]
    made = []
    for comment, rules, flags, a, b, c in table:
        answer = quadratic_answer(float(a), float(b), float(c))
        exactly = "exact" if not answer else "ulp:4"
        made.append(case(rules, comment, flags, sent(a, b, c), answer, exactly, EXACT))
    for a, c, comment in [(2, -8, "-2 and 2."), (3, -1, "Thirds."), (1, -2, "The square root of 2."), (-1, 7, "Both signs turned."), (1e300, -1e-300, "Small roots."), (1e-300, -1e300, "Large roots."), (0.1, -0.3, "Rounded coefficients.")]:
        made.append(case("roots.quadratic.b-zero roots.quadratic.place", comment + " The two are the same number but for the sign.", "sign asymmetric", sent(a, 0, c), quadratic_answer(float(a), 0.0, float(c)), "ulp:4", EXACT))
    for a, b, c in near_tangents(21, 18):
        answer = quadratic_answer(float(a), float(b), float(c))
        made.append(case("roots.quadratic.count roots.quadratic.place", f"The discriminant is {b * b - 4 * a * c}, and the rounded one another number.", "rounded-discriminant", sent(a, b, c), answer, "ulp:4" if answer else "exact", EXACT))
    source = random.Random(22)
    for _ in range(10):
        a, b, c = (source.uniform(-5, 5) * 2.0 ** source.randint(-8, 8) for _ in range(3))
        answer = quadratic_answer(a, b, c)
        made.append(case("roots.quadratic.count roots.quadratic.place", "Random digits.", "rounding", sent(a, b, c), answer, "ulp:4" if answer else "exact", EXACT))
    return made


# Degrees three and four


def general(rules, comment, flags, coefficients):
    """A case whose roots are single, or multiple exactly."""
    plain = [float(c) for c in coefficients]
    roots = real_roots(plain)
    if not separated(plain):
        raise ValueError(f"{comment}: roots too close to each other")
    answer = [nearest(x) for x in roots if finite(x)]
    single = [x for x in set(roots) if roots.count(x) == 1]
    compare = "exact"
    if len(single) < len(roots):
        compare = "rel:1e-10"
        if single and float(bound(plain, single)[4:]) > 1e-10:
            raise ValueError(f"{comment}: {bound(plain, single)} is too wide")
    elif any(answer):
        compare = bound(plain, roots)
    if all(x == 0 for x in answer):
        compare = "exact"
    return case(rules, comment, flags, sent(*coefficients), answer, compare, EXACT)


def expanded(leading, roots, factors=()):
    """Coefficients of leading (x - r1) (x - r2) ... times other factors, as fractions."""
    p = [Fraction(leading)]
    for factor in [[1, -Fraction(r)] for r in roots] + [list(f) for f in factors]:
        q = [Fraction(0)] * (len(p) + len(factor) - 1)
        for i, a in enumerate(p):
            for j, b in enumerate(factor):
                q[i + j] += a * Fraction(b)
        p = q
    for c in p:
        if Fraction(float(c)) != c:
            raise ValueError(f"{p} are not binary64 numbers")
    return [int(c) if c.denominator == 1 and abs(c) < 2**53 else float(c) for c in p]


def roots_cubic():
    count, multiple, zero, scale, simple = "roots.cubic.count", "roots.multiple", "roots.zero-root", "roots.scale", "roots.simple roots.residual"
    E = expanded
    table = [
        (count + " conformance.means", "1, 2, 3.", "unsorted", E(1, [1, 2, 3])), (count + " roots.ascending", "1, 2, 3, the leading coefficient negative.", "unsorted sign", E(-2, [1, 2, 3])), (count + " roots.ascending", "-3, -2, -1.", "sign", E(1, [-1, -2, -3])), (count + " roots.ascending", "-1, 2, 5: not symmetric.", "sign", E(1, [-1, 2, 5])),
        (count, "-7, 1/2, 4, leading coefficient 4.", "missing-normalisation", E(4, [-7, Fraction(1, 2), 4])), (count, "One root: 2.", "cubic-discriminant", [1, 0, 0, -8]), (count, "One root: -2.", "cubic-discriminant sign", [1, 0, 0, 8]), (count, "One root, and the derivative has no zero.", "cubic-discriminant", [1, 1, 3, 7]),
        (count, "One root beyond both extrema, to the right.", "cubic-discriminant", [1, 0, -3, -3]), (count, "One root beyond both extrema, to the left.", "cubic-discriminant sign", [1, 0, -3, 3]), (count, "Three roots, x^3 - 3 x - 1.", "trigonometric", [1, 0, -3, -1]), (count, "Three roots, x^3 - 3 x + 1.", "trigonometric sign", [1, 0, -3, 1]),
        (simple, "The square roots of 2, and 0.", "rounding", [1, 0, -2, 0]), (simple, "The cube root of 2.", "rounding", [1, 0, 0, -2]), (simple, "The cube root of -3/7.", "rounding sign", [7, 0, 0, 3]), (simple, "x^3 - 2 x - 5, Newton's example.", "newton", [1, 0, -2, -5]), (simple, "x^3 - 2 x + 2, where Newton's method goes round from 0.", "newton loop", [1, 0, -2, 2]),
        (simple, "0.1 x^3 + 0.7 x^2 - 0.3 x - 0.9.", "rounding", [0.1, 0.7, -0.3, -0.9]), (count + " " + zero, "0, and two complex ones.", "zero-root", [-2, 0, -2, 0]), (zero, "0, 1, 2.", "zero-root", E(1, [0, 1, 2])), (zero, "0, -1, -2.", "zero-root sign", E(-3, [0, -1, -2])), (zero + " " + multiple, "0, 0, 5.", "zero-root double-root", [1, -5, 0, 0]), (zero + " " + multiple, "-5, 0, 0.", "zero-root double-root sign", [2, 10, 0, 0]),
        (zero + " " + multiple, "0, three times.", "zero-root triple-root", [1, 0, 0, 0]), (zero + " " + multiple, "0, three times, of -0.", "zero-root negative-zero", [-4, Raw("-0.0"), 0, Raw("-0.0")]), (zero + " " + multiple, "0, and 3 twice.", "zero-root double-root", E(1, [0, 3, 3])), (zero + " " + multiple, "0, and -3/2 twice.", "zero-root double-root", E(4, [0, Fraction(-3, 2), Fraction(-3, 2)])),
        (multiple, "-1, 2, 2.", "double-root", E(1, [-1, 2, 2])), (multiple, "2, 2, 7.", "double-root", E(1, [2, 2, 7])), (multiple, "-2, -2, 1, the leading coefficient negative.", "double-root sign", E(-1, [-2, -2, 1])), (multiple, "-5, 1/4, 1/4.", "double-root", E(16, [-5, Fraction(1, 4), Fraction(1, 4)])), (multiple, "3, 3, 3.", "triple-root", E(1, [3, 3, 3])),
        (multiple, "-1/2, three times.", "triple-root sign", E(8, [Fraction(-1, 2)] * 3)), (multiple, "Far double root: 1, 1000, 1000.", "double-root", E(1, [1, 1000, 1000])), (multiple, "Near double root: 1/1024, 1/1024, 3.", "double-root", E(2.0**20, [2.0**-10, 2.0**-10, 3])),
        ("roots.degree", "a = 0: 1 and 2.", "degree", [0, 1, -3, 2]), ("roots.degree", "a = -0: 1 and 2.", "degree negative-zero", [Raw("-0.0"), 1, -3, 2]), ("roots.degree", "a = b = 0: 3/2.", "degree", [0, 0, 2, -3]), ("roots.degree roots.identity", "a = b = c = 0: none.", "degree", [0, 0, 0, 1]), ("roots.identity roots.total", "All zero: none.", "degree", [0, 0, 0, 0]),
        ("roots.degree roots.quadratic.count", "a = 0, and no real root.", "degree", [0, 1, 1, 1]), ("roots.degree", "A leading coefficient of 1e-11 counts: a third root, far away.", "epsilon", [1e-11, 1, -3, 2]), ("roots.degree", "One of -1e-16, too.", "epsilon sign", [-1e-16, 1, 0, -1]), ("roots.degree", "One of 1e-30, too.", "epsilon", [1e-30, 1, 1, -6]), ("roots.finite roots.degree", "The far root overflows, the others stay.", "overflow epsilon", [1e-320, 1, -3, 2]),
        (scale, "2^900 times 1, 2, 3.", "overflow", [2.0**900, -6 * 2.0**900, 11 * 2.0**900, -6 * 2.0**900]), (scale, "-2^-1000 times 1, 2, 3.", "underflow sign", [-(2.0**-1000), 6 * 2.0**-1000, -11 * 2.0**-1000, 6 * 2.0**-1000]), (scale, "2^-1070 times 1, 2, 3: subnormal numbers.", "underflow", [2.0**-1070, -6 * 2.0**-1070, 11 * 2.0**-1070, -6 * 2.0**-1070]),
        (scale, "Roots of 2^300, 2^301 and -2^300.", "overflow", E(1, [2.0**300, 2.0**301, -(2.0**300)])), (scale, "Roots of 2^-300, 2^-301 and -2^-300.", "underflow", E(1, [2.0**-300, 2.0**-301, -(2.0**-300)])), (scale + " " + simple, "Roots of sizes 1e-6, 1, 1e6.", "catastrophic-cancellation", E(2.0**20, [2.0**-20, 1, 2.0**20])), (scale + " roots.total", "The largest numbers.", "overflow", [MOST, -MOST, -MOST, MOST / 2]),
        (scale + " roots.total", "The largest numbers, one root.", "overflow", [MOST, MOST, MOST, MOST]), (simple, "A root of 1e-17 beside larger ones.", "epsilon", [1, -3, 2, -2e-17]), (simple, "A root of 1e-40 beside larger ones.", "epsilon", [1, -3, 2, 2e-40]), (count, "Two complex roots near the real line: x^2 + 2^-16, shifted by 1.", "epsilon", E(2.0**16, [5], [[1, -2, 1 + 2.0**-16]])),
        (count, "Two real roots a 2^-8 apart.", "epsilon", E(1, [-3, 1 - 2.0**-9, 1 + 2.0**-9])), (count, "Two real roots a 2^-14 apart.", "epsilon", E(1, [4, 1 - 2.0**-15, 1 + 2.0**-15])), (count, "Roots at the inflection point's side: (x - 1)^3 = 2^-9.", "triple-root", [1, -3, 3, -1 - 2.0**-9]), (count, "(x + 1)^3 = -8.", "triple-root sign", [1, 3, 3, 9]),
    ]
    made = [general(rules, comment, flags, coefficients) for rules, comment, flags, coefficients in table]
    for r, other in [(Fraction(1, 3), 1), (Fraction(-2, 7), 3), (Fraction(11, 10), -2)]:
        p = [Fraction(1), -(2 * r + other), r * r + 2 * r * other, -r * r * other]
        made.append(case(multiple, f"{r} twice and {other}, the coefficients rounded.", "double-root rounding", sent(*map(float, p)), sorted([float(r), float(r), float(other)]), "rel:1e-10", EXACT))
    source = random.Random(31)
    while len(made) < 80:
        p = [source.uniform(-5, 5) for _ in range(4)]
        roots = real_roots(p)
        if separated(p) and float(bound(p, roots)[4:]) < 1e-12:
            made.append(general(count + " " + simple, "Random digits.", "rounding", p))
    return made


def roots_quartic():
    count, multiple, zero, scale, simple = "roots.quartic.count", "roots.multiple", "roots.zero-root", "roots.scale", "roots.simple roots.residual"
    E = expanded
    table = [
        (count + " conformance.means", "1, 2, 3, 4.", "unsorted", E(1, [1, 2, 3, 4])), (count + " roots.ascending", "The same, negative.", "unsorted sign", E(-3, [1, 2, 3, 4])), (count + " roots.ascending", "-4, -3, -2, -1.", "sign", E(1, [-1, -2, -3, -4])), (count + " roots.ascending", "-5, -1, 2, 7: not symmetric.", "sign", E(1, [-5, -1, 2, 7])),
        (count, "-3, 1/2, 5, 9/4, leading coefficient 8.", "missing-normalisation", E(8, [-3, Fraction(1, 2), 5, Fraction(9, 4)])), (count, "No root: x^4 + 1.", "count", [1, 0, 0, 0, 1]), (count, "No root: -x^4 - x^2 - 3.", "count sign", [-1, 0, -1, 0, -3]), (count, "No root above the axis with two minima.", "count", [1, 0, -4, 1, 8]), (count, "Two roots: -2 and 2.", "count", [1, 0, 0, 0, -16]),
        (count, "Two roots: 1 and 3, and two complex ones.", "count", E(1, [1, 3], [[1, 1, 1]])), (count, "Two roots: -4 and -1, and two complex ones.", "count sign", E(-2, [-4, -1], [[1, -2, 5]])), (count, "Two roots of both signs, and two complex ones far away.", "count", E(1, [-1, 2], [[1, -20, 200]])), (count, "One minimum below the axis, the left one.", "count", [1, 0, -4, 2, 3]), (count, "One minimum below the axis, the right one.", "count sign", [1, 0, -4, -2, 3]),
        (simple, "The square roots of 2 and 3.", "biquadratic", [1, 0, -5, 0, 6]), (simple, "Biquadratic, two roots.", "biquadratic", [1, 0, 1, 0, -6]), (count, "Biquadratic, no root.", "biquadratic", [1, 0, 5, 0, 6]), (count, "Biquadratic with a negative discriminant.", "biquadratic", [1, 0, -1, 0, 1]), (simple, "x^4 - x - 1.", "newton", [1, 0, 0, -1, -1]), (simple, "x^4 = 2.", "rounding", [1, 0, 0, 0, -2]),
        (simple, "The line through the middle of a torus of radii 2 and 1/2, across.", "torus", E(1, [-2.5, -1.5, 1.5, 2.5])), (simple, "0.1 x^4 - 0.7 x^3 - 0.3 x^2 + 0.9 x + 0.2.", "rounding", [0.1, -0.7, -0.3, 0.9, 0.2]),
        (zero, "0, 1, 2, 3.", "zero-root", E(1, [0, 1, 2, 3])), (zero, "-3, -2, 0, 5.", "zero-root sign", E(-1, [0, -2, -3, 5])), (zero, "0 and 2, and two complex ones.", "zero-root", E(1, [0, 2], [[1, 0, 1]])), (zero + " " + multiple, "0, 0, 1, 2.", "zero-root double-root", E(1, [0, 0, 1, 2])), (zero + " " + multiple, "-4, 0, 0, 0.", "zero-root triple-root", [1, 4, 0, 0, 0]), (zero + " " + multiple, "0, four times.", "zero-root", [7, 0, 0, 0, 0]),
        (zero + " " + multiple, "0, four times, of -0.", "zero-root negative-zero", [-7, Raw("-0.0"), Raw("-0.0"), Raw("-0.0"), Raw("-0.0")]), (zero + " " + multiple, "0, 0, and no other.", "zero-root", [1, 0, 1, 0, 0]),
        (multiple, "-1, -1, 1, 1.", "double-root", E(1, [-1, -1, 1, 1])), (multiple, "2, four times.", "fourfold-root", E(1, [2, 2, 2, 2])), (multiple, "-1/2, four times.", "fourfold-root sign", E(16, [Fraction(-1, 2)] * 4)), (multiple, "-2, 1, 1, 1.", "triple-root", E(1, [-2, 1, 1, 1])), (multiple, "1, 1, 1, 5.", "triple-root", E(1, [1, 1, 1, 5])), (multiple, "1, 3, 3, 6.", "double-root", E(1, [1, 3, 3, 6])),
        (multiple, "-2, -2, 1, 4.", "double-root", E(-1, [-2, -2, 1, 4])), (multiple, "-2, 1, 4, 4.", "double-root", E(1, [-2, 1, 4, 4])), (multiple, "2, 2, and two complex ones: a line that touches.", "double-root tangent", E(1, [2, 2], [[1, 0, 1]])), (multiple, "-3, -3, and two complex ones.", "double-root tangent sign", E(-5, [-3, -3], [[1, 2, 5]])), (multiple, "1/4, 1/4, 2, 2.", "double-root", E(16, [Fraction(1, 4), Fraction(1, 4), 2, 2])),
        (multiple, "A line on top of a torus of radii 2 and 1/2: two double roots.", "double-root tangent torus", E(1, [-2, -2, 2, 2])),
        (count, "Two complex double roots: none.", "count double-root", [1, 0, 2, 0, 1]), (count, "Two complex double roots beside the real line.", "count double-root", E(1, [], [[1, -2, 2], [1, -2, 2]])),
        ("roots.degree", "a = 0: 1, 2, 3.", "degree", [0, 1, -6, 11, -6]), ("roots.degree", "a = -0: 1, 2, 3.", "degree negative-zero", [Raw("-0.0"), 1, -6, 11, -6]), ("roots.degree", "a = b = 0: 1 and 2.", "degree", [0, 0, 1, -3, 2]), ("roots.degree", "a = b = c = 0: 7/2.", "degree", [0, 0, 0, 2, -7]), ("roots.degree roots.identity", "Only the last one: none.", "degree", [0, 0, 0, 0, 5]), ("roots.identity roots.total", "All zero: none.", "degree", [0, 0, 0, 0, 0]),
        ("roots.degree", "A leading coefficient of 1e-11 counts.", "epsilon", [1e-11, 1, -6, 11, -6]), ("roots.degree", "One of -1e-20, too.", "epsilon sign", [-1e-20, 0, 1, 0, -1]), ("roots.degree roots.finite", "The far root overflows, the others stay.", "overflow epsilon", [1e-320, 1, -6, 11, -6]),
        (scale, "2^900 times 1, 2, 3, 4.", "overflow", [c * 2.0**900 for c in E(1, [1, 2, 3, 4])]), (scale, "-2^-1000 times 1, 2, 3, 4.", "underflow sign", [c * -(2.0**-1000) for c in E(1, [1, 2, 3, 4])]), (scale, "2^-1070 times 1, 2, 3, 4: subnormal numbers.", "underflow", [c * 2.0**-1070 for c in E(1, [1, 2, 3, 4])]), (scale + " " + multiple, "-2^600 times a polynomial with double roots.", "overflow double-root", [c * -(2.0**600) for c in E(1, [-1, -1, 1, 1])]),
        (scale, "Roots around 2^200.", "overflow", E(1, [2.0**200, 3 * 2.0**200, -(2.0**200), -5 * 2.0**200])), (scale, "Roots around 2^-200.", "underflow", E(1, [2.0**-200, 3 * 2.0**-200, -(2.0**-200), -5 * 2.0**-200])), (scale + " roots.total", "The largest numbers.", "overflow", [MOST, -MOST, -MOST, MOST, -MOST / 4]), (scale + " roots.total", "The largest numbers, no root.", "overflow", [MOST, MOST / 2, MOST, MOST / 2, MOST]),
        (simple, "Sizes from 2^-12 to 2^12.", "catastrophic-cancellation", E(1, [2.0**-12, -1, 3, 2.0**12])), (simple, "A root of 1e-18 beside larger ones.", "epsilon", [1, -6, 11, -6, 6e-18]), (simple, "A root of 1e-50 beside larger ones.", "epsilon", [1, -6, 11, -6, -6e-50]), (simple, "Roots 1, 1.0009765625, 3, -5.", "epsilon", E(1, [1, 1.0009765625, 3, -5])),
        (count, "Two roots a 2^-12 apart around 2.", "epsilon", E(1, [2 - 2.0**-12, 2 + 2.0**-12, -1, 5])), (count, "Complex roots that near: none there.", "epsilon", E(1, [-1, 5], [[1, -4, 4 + 2.0**-24]])),
    ]
    made = [general(rules, comment, flags, coefficients) for rules, comment, flags, coefficients in table]
    made.append(case(count, "Meant as (x^2 - 1)(x^2 - 1.000001): of the coefficients as they are.", "epsilon merged", sent(1, 0, -2.000001, 0, 1.000001), [nearest(x) for x in real_roots([1.0, 0.0, -2.000001, 0.0, 1.000001])], "rel:1e-9", EXACT))
    for r, s in [(Fraction(1, 3), Fraction(7, 5)), (Fraction(-2, 7), Fraction(3, 11)), (Fraction(11, 10), Fraction(-21, 10))]:
        p = [Fraction(1), -2 * (r + s), r * r + 4 * r * s + s * s, -2 * (r * r * s + r * s * s), r * r * s * s]
        made.append(case(multiple, f"{r} and {s}, twice each, the coefficients rounded.", "double-root rounding", sent(*map(float, p)), sorted([float(r), float(r), float(s), float(s)]), "rel:1e-10", EXACT))
    for r, u, v in [(Fraction(1, 3), 2, 5), (Fraction(-6, 7), -3, 1)]:
        q = [Fraction(1), Fraction(-(u + v)), Fraction(u * v)]
        p = [q[0], q[1] - 2 * r * q[0], q[2] - 2 * r * q[1] + r * r * q[0], -2 * r * q[2] + r * r * q[1], r * r * q[2]]
        made.append(case(multiple, f"{r} twice, {u} and {v}, the coefficients rounded.", "double-root rounding", sent(*map(float, p)), sorted([float(r), float(r), float(u), float(v)]), "rel:1e-10", EXACT))
    source = random.Random(41)
    while len(made) < 95:
        p = [source.uniform(-5, 5) for _ in range(5)]
        roots = real_roots(p)
        if separated(p) and float(bound(p, roots)[4:]) < 1e-12 and (roots or source.random() < 0.2):
            made.append(general(count + " " + simple, "Random digits.", "rounding", p))
    return made


def operations():
    return {"roots.linear": roots_linear(), "roots.quadratic": roots_quadratic(), "roots.cubic": roots_cubic(), "roots.quartic": roots_quartic()}


if __name__ == "__main__":
    main(sys.modules[__name__])
