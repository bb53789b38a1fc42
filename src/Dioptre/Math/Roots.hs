{-# LANGUAGE BangPatterns #-}
{-# LANGUAGE HexFloatLiterals #-}

-- |
-- Module      : Dioptre.Math.Roots
-- Description : Real roots of polynomials: total, ascending, exact in number
--
-- Where a ray meets a curved shape, a polynomial in the ray's parameter is zero. This module finds the real
-- zeros.
--
-- >      y                                  discriminant   list
-- >      |  \       /   \     /   \    /
-- >      |   \     /     \   /     \__/          > 0       [x1, x2]
-- >   ---+----x1--x2------x=x----------- x       = 0       [x, x]
-- >      |     \_/                               < 0       []
--
-- What every function here promises:
--
-- * __Total.__ Every choice of coefficients has an answer; NaN or an infinity among them gives @[]@.
-- * __Ascending, with multiplicity.__ @(x - 2)^2@ gives @[2, 2]@. @0 x + 0 = 0@, which every number solves, has no
--   isolated root and gives @[]@.
-- * __The exact degree.__ \"The leading coefficient is zero\" means zero and nothing else; then the next lower degree
--   decides. However small, a coefficient that is not zero counts.
-- * __The exact number.__ There are as many roots as the polynomial with these very coefficients has. No tolerance is
--   involved: a tangent ray is tangent when its discriminant is zero, not when it is small.
-- * __Finite, no @-0@.__ A root too large for a 'Double' is dropped; a root that vanishes is @0@.
-- * __Scale does not matter.__ Multiplying all coefficients by @2^m@ or by @-2^m@ leaves the roots alone bit for bit,
--   as long as no coefficient loses digits to it.
-- * __The same bits everywhere.__ Only @+ - * /@ and @sqrt@ of IEEE 754 binary64 are used, in the order written at each
--   function, so a port to another language can reproduce each root exactly.
--
-- The lists are meant to be consumed with a @foldr@, and then are never built: see Note [Lists that vanish].
--
-- Sources:
--
-- * W. Kahan, /On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic/ (2004),
--   <https://people.eecs.berkeley.edu/~wkahan/Qdrtcs.pdf>: why the discriminant deserves care.
-- * S. Boldo, /Kahan's Algorithm for a Correct Discriminant Computation at Last Formally Proven/ (2009),
--   <https://doi.org/10.1109/TC.2008.200>, program and proof at <http://toccata.lri.fr/gallery/discri.fr.html>.
-- * F. Goualard, /The Ins and Outs of Solving Quadratic Equations with Floating-Point Arithmetic/ (2023), programs at
--   <https://github.com/goualard-f/QuadraticEquation.jl>: overflow and underflow, and what others do about them.
module Dioptre.Math.Roots
  ( -- * Solving
    linearRoots,
    quadraticRoots,
    clearlyNone,
  )
where

import Dioptre.Math.ErrorFree (halves, productError)
import Dioptre.Math.Order (finite)
import GHC.Exts (build)

-- | The root of @a x + b@, or none.
--
-- The root is @-b \/ a@ rounded once, so it is the double nearest to the exact one.
--
-- >>> linearRoots 2 (-3)
-- [1.5]
-- >>> linearRoots 5 0
-- [0.0]
-- >>> linearRoots 0 0
-- []
-- >>> linearRoots 1e-300 1e300
-- []
--
-- The rule, in the order of its steps:
--
-- 1. @a = 0@, or @a@ or @b@ not finite: @[]@.
-- 2. @x = 0 - b \/ a@ (subtracting from zero turns @-0@ into @0@); @[x]@ if it is finite, else @[]@.
--
-- Spec: numbers.negative-zero, numbers.tolerances.only, roots.total, roots.identity, roots.finite,
--   roots.no-negative-zero, roots.linear.root.
linearRoots :: Double -> Double -> [Double]
linearRoots a b = build (ascending (linear a b))
{-# INLINE linearRoots #-}

-- | The real roots of @a x^2 + b x + c@, ascending, a double root twice; 'linearRoots' @b c@ when @a@ is zero.
--
-- Each root is within 4 ulp of the exact one (Note [Four ulp]), roots that nearly touch included, and their number is
-- exact (Note [The sign of the discriminant]). They are the roots of the coefficients as given: what was
-- rounded before they came here cannot be made good.
--
-- >>> quadraticRoots 1 (-3) 2
-- [1.0,2.0]
-- >>> quadraticRoots 1 (-4) 4
-- [2.0,2.0]
-- >>> quadraticRoots 1 0 1
-- []
-- >>> quadraticRoots 0 2 (-3)
-- [1.5]
--
-- The textbook's @(-b - sqrt (b^2 - 4 a c)) \/ 2 a@ answers 7.450580596923828e-9 for the first root of the next one,
-- and overflows on the one after:
--
-- >>> quadraticRoots 1 (-1e8) 1
-- [1.0e-8,1.0e8]
-- >>> quadraticRoots 1e200 (-3e200) 2e200
-- [1.0,2.0]
--
-- The rule, in the order of its steps. All of it, up to the quotients of step 7, is binary64 /whose exponent has no
-- bounds/: nothing overflows, nothing underflows. The quotients are rounded once, to binary64. For coefficients of
-- ordinary size that is plain arithmetic; for others see Note [Exponents without bounds].
--
-- 1. A coefficient that is not finite: @[]@. @a = 0@: the root of @b x + c@. @b = c = 0@: @[0, 0]@.
-- 2. @u = b * b@, @v = (4 * a) * c@, @w = u + |v|@, @d = u - v@.
-- 3. If @d < 0@: @[]@.
-- 4. If not @d > w \/ 4@: @d = (u - v) + (e - f)@, where @e@ is what rounding took from @u = b * b@, and @f@ what it
--    took from @v = (4 * a) * c@; if that is negative, @[]@. What rounding took from @z = x * y@ is
--    @x2 * y2 - (((z - x1 * y1) - x1 * y2) - x2 * y1)@, with @x1 = g - (g - x)@, @x2 = x - x1@, @g = (2^27 + 1) * x@,
--    and in the same way from @y@.
-- 5. @s = sqrt d@.
-- 6. @p = (b - s) \/ 2@ if @b < 0@, else @p = (b + s) \/ 2@.
-- 7. If @b = 0@: with @h = |p \/ a|@, the roots are @-h@ and @h@. Else they are @0 - p \/ a@ and @0 - c \/ p@, the
--    smaller one first. Those that are not finite are dropped.
--
-- Cost: a miss takes four products, two sums and a handful of comparisons; a hit, a square root and two quotients more,
-- and, where the two products of step 2 nearly cancel (a small sphere far away), some 35 operations of step 4.
-- Nothing is allocated. Where @a@ or @b@ is zero, and where exponents are extreme, the work is done out of line, at
-- several times the cost and with some 300 bytes.
--
-- Spec: numbers.not-finite, numbers.tolerances.only, roots.total, roots.ascending, roots.degree, roots.finite,
--   roots.no-negative-zero, roots.scale, roots.quadratic.count, roots.quadratic.place, roots.quadratic.b-zero,
--   roots.quadratic.same, geometry.sphere.tangent.
quadraticRoots :: Double -> Double -> Double -> [Double]
quadraticRoots a b c = build (ascending (quadratic a b c))
{-# INLINE quadraticRoots #-}

-- | Finite roots in ascending order, before they become a list.
data Roots
  = None
  | One !Double
  | Two !Double !Double

-- | The roots as a list, in the form that 'build' asks for. See Note [Lists that vanish].
ascending :: Roots -> (Double -> list -> list) -> list -> list
ascending roots cons nil = case roots of
  None -> nil
  One x -> cons x nil
  Two x y -> cons x (cons y nil)
{-# INLINE ascending #-}

linear :: Double -> Double -> Roots
linear a b
  | a /= 0 && finite a && finite x = One x
  | otherwise = None
  where
    x = opposite (b / a)
{-# INLINE linear #-}

-- | The steps as the machine does them, where its exponents suffice. The rest is for @quadraticElsewhere@.
--
-- A copy of this stands wherever a shape solves its equation, so it holds the ordinary case and nothing else.
quadratic :: Double -> Double -> Double -> Roots
quadratic a b c
  -- Most rays miss. (Rounding keeps order: u < v, as computed, proves D < 0, however small the products are, and
  -- whatever a and b are. Where v is out of range, nothing is proved: 4 a may be.)
  | u < v && finite v = None
  | roomy (u + abs v) && roomy (abs a) && b /= 0 = solved (/) a b c u v
  | otherwise = quadraticElsewhere a b c
  where
    !u = b * b
    !v = (4 * a) * c
{-# INLINE quadratic #-}

-- | Whether it is clear at once that @a x^2 + 2 h x + c@ has no root, as it is for most rays and most shapes: rounding
-- keeps order, so that h h < a c, as computed, proves it, however small or large the products are.
--
-- Law: then 'quadraticRoots' @a (2 h) c@ has none.
clearlyNone :: Double -> Double -> Double -> Bool
clearlyNone a h c = h * h < a * c
{-# INLINE clearlyNone #-}

-- | Whether a magnitude is far from both ends of the range of exponents; false for zero, infinity and NaN. (From 2^-400
-- to 2^400. See Note [Literals].)
roomy :: Double -> Bool
roomy x = x > 0x1p-100 * 0x1p-100 * 0x1p-100 * 0x1p-100 && x < 0x1p100 * 0x1p100 * 0x1p100 * 0x1p100
{-# INLINE roomy #-}

-- | Step 1 in full, @b = 0@, and any exponents whatever. See Note [Exponents without bounds].
--
-- Spec: roots.scale, roots.quadratic.b-zero.
quadraticElsewhere :: Double -> Double -> Double -> Roots
quadraticElsewhere a b c
  | not (finite a && finite b && finite c) = None
  | a == 0 = linear b c
  | b == 0 && c == 0 = Two 0 0
  | b == 0 = if a' * c' > 0 then None else representable (Two (negate h) h)
  | c == 0 || bExponent > 100 = representable (pair (b / a) (c / b))
  | otherwise = representable (solved over a' b' c' (b' * b') ((4 * a') * c'))
  where
    k = (exponent c - exponent a) `div` 2
    bExponent = exponent b + k - exponent c
    a' = scaleFloat (2 * k - exponent c) a
    b' = scaleFloat (max (-100) bExponent) (significand b)
    c' = significand c
    p = 0.5 * sqrt (negate ((4 * a') * c'))
    h = abs (p `over` a')
    -- 2^k n / m, rounded once: each side takes half of the power, which is exact
    n `over` m = scaleFloat (k `div` 2) n / scaleFloat (k `div` 2 - k) m
{-# NOINLINE quadraticElsewhere #-}

-- | The roots without those that overflowed.
--
-- Spec: geometry.hit.finite.
representable :: Roots -> Roots
representable (Two x y)
  | finite x && finite y = Two x y
  | finite x = One x
  | finite y = One y
  | otherwise = None
representable roots = roots

-- | Steps 3 to 7 for @b@ other than zero, given a way to divide, the coefficients and the products @u@ and @v@.
solved :: (Double -> Double -> Double) -> Double -> Double -> Double -> Double -> Double -> Roots
solved over a b c u v
  | d < 0 = None
  | d > 0.25 * w = rooted d
  | delta >= 0 = rooted delta
  | otherwise = None
  where
    !d = u - v
    !w = u + abs v
    delta = refined a b c
    rooted discriminant = let !p = halfSum b discriminant in pair (p `over` a) (c `over` p)
{-# INLINE solved #-}

-- | Step 4: the discriminant by Kahan's formula, to 2 ulp. It needs @u@ and @v@ within a factor of 2 of each other.
-- See Note [The sign of the discriminant].
--
-- Spec: roots.quadratic.count.
refined :: Double -> Double -> Double -> Double
refined a b c = (u - v) + (productError b (halves b) u - productError (4 * a) (halves c) v)
  where
    !u = b * b
    !v = (4 * a) * c
{-# NOINLINE refined #-}

-- | The number with the other sign, except that the opposite of zero is @0@ and not @-0@.
opposite :: Double -> Double
opposite x = 0 - x
{-# INLINE opposite #-}

{- HLINT ignore opposite "Use negate" -}

-- | Steps 5 and 6: half of the sum of @b@ and the root of the discriminant, which takes the sign of @b@ so that nothing
-- cancels.
halfSum :: Double -> Double -> Double
halfSum b delta
  | b < 0 = 0.5 * (b - s)
  | otherwise = 0.5 * (b + s)
  where
    !s = sqrt delta
{-# INLINE halfSum #-}

-- | Step 7 for @b@ other than zero: the roots in order, from @p \/ a@ and @c \/ p@.
--
-- Rounding may carry two close roots past each other, so they are compared, not told apart by signs.
pair :: Double -> Double -> Roots
pair larger smaller
  | x <= y = Two x y
  | otherwise = Two y x
  where
    !x = opposite larger
    !y = opposite smaller
{-# INLINE pair #-}

{- Note [Literals]
   ~~~~~~~~~~~~~~~
A literal with an exponent beyond 100, of 10 or of 2, is a rational number that GHC from 9.2 on makes at run time,
wherever it is looked at, lest an exponent of a thousand million keep the compiler busy: it costs a hundred times as
much as what it is compared with. A product of smaller literals is computed by the compiler, exactly, and rounded
once.

Every other literal is a double in the program, be it decimal or hexadecimal, written here or named in another module,
and so is 1 + x for such an x. Only infinity has none: 1 / 0 is divided when the program runs.
-}

{- Note [The sign of the discriminant]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
A ray that grazes a sphere has one common point with it, or two, or none, and only the sign of D = b^2 - 4 a c can
tell. It is had exactly, and for less than one might fear. Rounding never reverses an order: if b^2 <= 4 a c, then
also u <= v for the rounded products. Hence

  * u < v proves D < 0, and u > v proves D > 0;
  * u = v leaves it open. Then D = e - f exactly, e and f being what rounding took from the products. The rounded
    difference of two numbers has the sign of the exact one, and is zero only if that is. So step 4 decides, and
    decides right.

How large D is takes more. Where d > w/4, rounding has taken no more than 5 eps of it (see Note [Four ulp]). In between,
3/5 u <= v <= u, up to rounding, so u - v is exact (Sterbenz: two numbers within a factor of 2 of each other), and
D = (u - v) + (e - f) but for the rounding of the last two operations, which leave it within 2 ulp (Boldo). This
does not lose the sign again: if u > v, then e - f > v - u, which is a double, so rounding cannot carry e - f
below it, and the sum is not negative.

e and f are doubles themselves, and are found exactly ("Dioptre.Math.ErrorFree"). None of this may underflow: where
it is used, w > 2^-400, so that e and f are multiples of 2^-510.
-}

{- Note [Four ulp]
   ~~~~~~~~~~~~~~~
Each root is within 4 ulp of the root of the polynomial as given. Errors are relative, eps = 2^-53, second order left out.

  * v <= 0: nothing cancels, d errs by 2 eps, s = sqrt d by 1 + 1 = 2 eps, p by at most 2 + 1 = 3 eps.
  * 0 < v and d > w/4: d errs by at most eps w/d + eps <= 5 eps, s by 5/2 + 1 = 7/2 eps. But s is less than half of
    |b| + s, whose other part has no error: p errs by at most 7/4 + 1 < 3 eps.
  * 0 < v and d <= w/4: d errs by 2 ulp, which is at most 4 eps, s by 2 + 1 = 3 eps, p by at most 3/2 + 1 < 3 eps.

The quotients p/a and c/p inherit 3 eps, which is at most 3 ulp, and are rounded, which is at most 1/2 ulp more. That
leaves 1/2 ulp for the second order, which needs a millionth of a millionth of it. Putting the two roots in order does
not enlarge the error: if |x - X| <= h and |y - Y| <= h, then the same holds between the lesser of x, y and
the lesser of X, Y, and between the greater ones.

The sign-matched p never cancels. The textbook's -b + s does: to use it for the root near zero of x^2 - 10^8 x + 1 is to
lose every digit.
-}

{- Note [Exponents without bounds]
   ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
Rounding to 53 bits commutes with powers of two. As long as nothing overflows or underflows, all of a, b, c may thus be
multiplied by 2^m, or the variable by 2^k, and every intermediate result changes its exponent and nothing else. The rule
of 'quadraticRoots' is stated for exponents without bounds, where this always holds. Here is why the program follows it.

'quadratic' does plain arithmetic where w and |a| are within 2^-400 and 2^400, and b is not zero:

  * If one of u and v underflows, it is below 2^-1022 and the other above 2^-401: then d and w are the other one,
    whatever the digits that were lost.
  * 'refined' meets u and v close to w/2, so |b| is between 2^-202 and 2^200, and |c| between 2^-804 and 2^800: far
    from the ends.
  * |p| is between 2^-202 and 2^201, so p/a does not overflow, and since |c/p| <= |p/a| up to rounding nor does c/p.
    Either may underflow; a quotient that does is rounded once, as the rule says.

Elsewhere, x = 2^k y, and division by a power of two, bring a' to between 1/4 and 1 and c' to between 1/2 and 1. Both are
exact, subnormal or not. One k cannot do the same for b, but b is not always needed in full:

  * |b'| >= 2^100: u outweighs v by so much that d = u and p = b. The roots are -b/a and -c/b, of the coefficients as
    they were.
  * |b'| < 2^-101: v outweighs u by so much that d = -v and p = +-s/2. Only the sign of b matters, and any b' below
    2^-100 will do.

The roots 2^k y come from one division, each of whose sides takes a part of 2^k: rounded once, even when subnormal.

It follows that scaling by +-2^m never changes a bit of any root, provided that it is exact: that no coefficient
overflows or loses digits to underflow. One that does is another coefficient, and no solver could know. As to -1, it
leaves d alone and changes the sign of p and of what p divides and is divided by. Where b = 0 the sign of p means
nothing, so step 7 uses p/a for both roots: c/p may differ from it in the last bit, and would tell.
-}

{- Note [Lists that vanish]
   ~~~~~~~~~~~~~~~~~~~~~~~~
A list says what roots are: some numbers, in order. It is also free, if whoever reads it folds it:

    closest a b c = foldr nearer id (quadraticRoots a b c) infinity
      where nearer t continue !best = if t > epsilon && t < best then continue t else continue best

GHC.Exts rewrites foldr k z (build g) to g k z. For that to happen the list is made by one 'build' on the outside, not
by one in each branch; the functions are INLINE, all the way to the case on Roots; and those that do the rare work are
not, so that the copies stay small. Roots is not built either: in 'quadratic' each constructor meets the case in
'ascending', which turns it into a jump. What remains is arithmetic on unboxed numbers, and RootsSpec measures that a loop
of it allocates nothing.

Degrees three and four build real lists, out of line: beside their work a cell is nothing ("Dioptre.Math.Quartic").
-}
