"""Rules that find the sign of a polynomial; each is exact and takes the study in which it works."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from math import lcm
from operator import or_
from typing import TYPE_CHECKING

from rbpsym.decide import bounds as b
from rbpsym.decide import enclosure
from rbpsym.decide.constants import is_algebraic, is_zero_number
from rbpsym.decide.factoring import ANY, DECIDED, MINUS, NONZERO, PLUS, ZERO, flip, plus, power, times
from rbpsym.decide.points import Point, names_of
from rbpsym.field import ONE, UNITY, Poly, Scalar, atoms, generator, inverse, is_exponential, quotient
from rbpsym.field import ZERO as ZERO_POLY
from rbpsym.field import substitute as put
from rbpsym.field.division import turnings
from rbpsym.field.normal import bases_of, in_bases, normal, partner, shorten, substitute, without_squares
from rbpsym.field.ring import factors
from rbpsym.field.roots import without_even_roots

if TYPE_CHECKING:
    from rbpsym.decide.signs import SignStudy

Linear = tuple[Poly, Poly]
Rule = tuple[Callable[["SignStudy", Poly], int], str]  # with what it is called in a certificate


def _by_terms(study: SignStudy, poly: Poly) -> int:
    """The sum of the signs of all terms."""
    mask = ZERO
    for m, c in poly.terms.items():
        term = study.monomial(m)
        mask = plus(mask, term if c > 0 else flip(term))
        if mask == ANY:
            return ANY
    return mask


def _by_number(study: SignStudy, poly: Poly) -> int:
    """A number, by enclosing it."""
    if names_of([Scalar(poly)]):
        return ANY
    try:
        found = enclosure.sign_of(Point({}).poly(poly))
    except enclosure.Outside:
        return ANY
    if found is None and all(is_algebraic(index) for index in poly.atoms()) and is_zero_number(poly):
        return ZERO
    return {1: PLUS, 0: ZERO, -1: MINUS, None: ANY}[found]


def _by_content(study: SignStudy, poly: Poly) -> int:
    """A monomial taken out."""
    _, powers = poly.content()
    if not powers:
        return ANY
    return times(study.monomial(powers), study.poly(poly.scaled(1, inverse(powers))))


def _by_quadratic(study: SignStudy, poly: Poly) -> int:
    """A y² + B y + C without real zeros, y being some power of a generator."""
    mask = ANY
    for index in poly.atoms():
        parts = poly.by_power(index)
        half = max(parts) // 2
        if half > 0 and set(parts) <= {0, half, 2 * half} and 2 * half in parts:
            mask &= _quadratic(study, *(parts.get(k * half, ZERO_POLY) for k in (2, 1, 0)))
    return mask


def _quadratic(study: SignStudy, a: Poly, linear: Poly, constant: Poly) -> int:
    inner = linear * linear - (a * constant).scaled(4)
    if study.samples.seen(Scalar(inner)) & PLUS or study.samples.has_both_signs(a):
        return ANY
    lead = study.poly(a)
    if lead not in (PLUS, MINUS):
        return ANY
    discriminant = study.poly(inner)
    discriminant = study.poly(normal(inner)) if discriminant == ANY else discriminant
    return {MINUS: lead, ZERO: lead | ZERO, MINUS | ZERO: lead | ZERO}.get(discriminant, ANY)


def _by_exponentials(study: SignStudy, poly: Poly) -> int:
    """Several exponentials of multiples of one quantity as powers of one."""
    found = [index for index in poly.atoms() if is_exponential(index)]
    if len(found) < 2:
        return ANY
    first = atoms.atom(found[0]).arg
    ratios = {index: Fraction(number) for index in found if (number := (atoms.atom(index).arg / first).number()) is not None}
    if len(ratios) < len(found):
        return ANY
    parts = lcm(*(ratio.denominator for ratio in ratios.values()))
    one = generator(atoms.intern("exp", first / parts))
    return study.poly(substitute(poly, {index: one ** int(ratio * parts) for index, ratio in ratios.items()}))


def _by_squares(study: SignStudy, poly: Poly) -> int:
    """The same with sin² or cos² replaced through the other."""
    mask = ANY
    for index in sorted(poly.atoms()):
        if partner(index) is not None:
            other = without_squares(poly, index)
            if other is not poly and other != poly:
                mask &= study.poly(other)
    return mask


def _by_double_angle(study: SignStudy, poly: Poly) -> int:
    """A + B sin x cos x lies between A - B/2 and A + B/2."""
    for index in sorted(poly.atoms()):
        parts, other = poly.by_power(index), partner(index)
        if other is not None and other > index and set(parts) == {0, 1} and set(parts[1].by_power(other)) == {1}:
            mean, swing = parts[0].scaled(2), parts[1].by_power(other)[1]
            if set(mean.by_power(other)) == {0}:
                ends = study.poly(mean + swing) | study.poly(mean - swing)
                return ANY if ends & NONZERO == NONZERO else ends  # between ends of both signs it may vanish
    return ANY


SHORT = 6  # terms of a sum of which squares are compared without a sign of its parts


def _by_wave(study: SignStudy, poly: Poly) -> int:
    """A cos x + B sin x + C with C² ≥ A² + B²: it has the sign of C."""
    for index in sorted(poly.atoms()) if len(poly) <= SHORT else ():
        other = partner(index)
        parts = poly.by_power(index) if other is not None and other > index else {}
        rest = parts.get(0, ZERO_POLY).by_power(other) if parts and other is not None else {}
        if set(parts) - {0, 1} or set(rest) - {0, 1} or not rest.get(0) or other in parts.get(1, ZERO_POLY).atoms():
            continue
        whole, waves = rest[0], [one for one in (parts.get(1), rest.get(1)) if one]
        room = without_even_roots(Scalar(sum((-one * one for one in waves), whole * whole)))
        more = ANY if study.samples.seen(room) & MINUS else study.scalar(room)
        if not more & MINUS:
            return study.poly(whole) | more & ZERO
    return ANY


def _by_one_angle(study: SignStudy, poly: Poly) -> int:
    """The same with cos 2x, sin 3x … in the angle x."""
    image = in_bases(poly, bases_of(poly))
    return ANY if image == poly else study.poly(image)


def _by_turned_angle(study: SignStudy, poly: Poly) -> int:
    """The same with A - B as an angle of its own, A being no more than an angle: cos A = cos(B + (A - B))."""
    plain = {atoms.symbol_name(index) for index in poly.atoms()}
    images = (image for image, _ in turnings(poly) if plain.isdisjoint(image))
    others = (normal(put(Scalar(poly), image).num) for image in images)
    return next((mask for one in others if len(one) < len(poly) and (mask := study.poly(one)) != ANY), ANY)


def _by_bounds(study: SignStudy, poly: Poly) -> int:
    """One sign on the whole range of some generator (those whose bounds hold others first)."""
    mask = ANY
    for index in sorted(poly.atoms(), key=lambda i: _order(study.bounds(i))):
        limits = study.bounds(index)
        if limits.lower is not None or limits.upper is not None:
            mask &= _on_range(study, poly, index, limits)
        if mask in DECIDED:
            return mask
    return mask


def _order(limits: b.Bounds) -> int:
    ends = [end for end in (limits.lower, limits.upper) if end is not None]
    return -len(names_of(ends))


def _on_range(study: SignStudy, poly: Poly, index: int, limits: b.Bounds) -> int:
    parts = poly.by_power(index)
    if min(parts) < 0 or max(parts) > 8 or max(parts) < 1:
        return ANY
    lower, upper, mask = limits.lower, limits.upper, ANY
    if lower is not None and upper is not None:
        mask = _common(study, _finite(parts, lower, upper), (limits.lower_in, limits.upper_in))
        if mask in DECIDED or not names_of([lower, upper]):
            return mask
    if lower is not None:
        mask &= _common(study, _shifted(parts, lower, 1), (limits.lower_in, False))
    if upper is not None:
        mask &= _common(study, _shifted(parts, upper, -1), (limits.upper_in, False))
    return mask


def _common(study: SignStudy, coefficients: list[Scalar], reached: tuple[bool, bool]) -> int:
    """The sign of Σ coefficient × positive function; an end that is reached leaves one term."""
    mask, last = ZERO, len(coefficients) - 1
    signs = []
    if study.samples.seen(*coefficients) == NONZERO:
        return ANY
    for coefficient in coefficients:
        signs.append(study.scalar(coefficient))
        mask = plus(mask, signs[-1])
        if mask == ANY:
            return ANY
    if reached[0]:
        mask |= signs[0]
    return mask | signs[last] if reached[1] else mask


def _finite(parts: dict[int, Poly], lower: Scalar, upper: Scalar) -> list[Scalar]:
    """Coefficients in u of (1 + u)^n p((lower + upper u)/(1 + u)), u > 0."""
    ends = lower.num * upper.den, upper.num * lower.den
    return _expanded(parts, ends, (ONE, ONE), lower.den * upper.den)


def _shifted(parts: dict[int, Poly], end: Scalar, direction: int) -> list[Scalar]:
    """Coefficients in u of p(end ± u), u > 0."""
    return _expanded(parts, (end.num, end.den.scaled(direction)), (ONE, ZERO_POLY), end.den)


def _expanded(parts: dict[int, Poly], above: Linear, below: Linear, den: Poly) -> list[Scalar]:
    """Coefficients in u of belowⁿ p(above / (below × den)), both linear in u."""
    degree = max(parts)
    total = [ZERO_POLY] * (degree + 1)
    for k, part in parts.items():
        term = [part * den ** (degree - k)]
        for factor, times_taken in ((above, k), (below, degree - k)):
            for _ in range(times_taken):
                term = _times_linear(term, factor)
        total = [a + b for a, b in zip(total, term, strict=True)]
    return [without_even_roots(quotient(coefficient, den**degree)) for coefficient in total]


def _times_linear(coefficients: list[Poly], factor: Linear) -> list[Poly]:
    low = [value * factor[0] for value in coefficients] + [ZERO_POLY]
    high = [ZERO_POLY] + [value * factor[1] for value in coefficients]
    return [x + y for x, y in zip(low, high, strict=True)]


def _by_root(study: SignStudy, poly: Poly) -> int:
    """A + B√x: it has the sign of A where A² > B² x, that of B where A² < B² x, and is 0, or 2A, between."""
    found = []
    for index in poly.atoms():
        parts, arg = poly.by_power(index), atoms.atom(index).arg
        if atoms.atom(index).kind != "root" or set(parts) != {0, 1}:
            continue
        if study.samples.seen(Scalar(parts[0]), Scalar(-parts[1])) != NONZERO:  # of opposite signs, wherever it was looked
            a, factor = study.poly(parts[0]), study.poly(parts[1])
            if a in (PLUS, MINUS) and factor == flip(a):
                return times(a, study.scalar(_gap_of_squares(parts, arg)))
        if len(poly) <= SHORT:
            square = without_even_roots(_gap_of_squares(parts, arg))
            found.append((quotient(shorten(square.num), square.den), parts[0], parts[1]))
    for square, *sides in sorted(found, key=lambda item: len(item[0].num)):
        if study.samples.seen(square) == NONZERO:
            continue
        a, factor = map(study.poly, sides)
        more = ANY if a == factor == ANY else study.scalar(square)
        cases = ((PLUS, a & NONZERO), (MINUS, factor & NONZERO), (ZERO, ZERO | a & factor))
        mask = reduce(or_, (said for case, said in cases if more & case), 0)
        if mask not in (0, ANY):
            return mask
    return ANY


def _gap_of_squares(parts: Mapping[int, Poly], arg: Scalar) -> Scalar:
    return Scalar(parts[0] * parts[0]) - Scalar(parts[1] * parts[1]) * arg




def _by_factors(study: SignStudy, poly: Poly) -> int:
    """The product of the signs of irreducible factors."""
    if not study.factoring or len(poly) < 2 or all(sum(abs(exponent) for _, exponent in m) < 2 for m in poly.terms):
        return ANY
    _, powers = poly.content()
    coefficient, found = factors(poly.scaled(1, inverse(powers)))
    odd = (factor for factor, exponent in found if exponent % 2)
    if found == ((found[0][0], 1),) or any(study.samples.has_both_signs(factor) for factor in odd):
        return ANY
    mask = times(study.monomial(powers), PLUS if coefficient > 0 else MINUS)
    for factor, exponent in found:
        mask = times(mask, power(study.poly(factor), exponent))
    return mask


def _by_logarithms(study: SignStudy, poly: Poly) -> int:
    """Σ k ln x with whole numbers k: that of Π xᵏ - 1."""
    product, scale = UNITY, lcm(*(c.denominator for c in poly.terms.values()))
    for m, c in poly.terms.items():
        found = atoms.atom(m[0][0]) if len(m) == 1 and m[0][1] == 1 else None
        times_taken = int(c * scale)
        if found is None or found.kind != "ln" or abs(times_taken) > MOST_OF_ONE:
            return ANY
        product = product * found.arg**times_taken
    return study.scalar(product - 1)


MOST_OF_ONE = 8  # times a logarithm


QUICK: tuple[Rule, ...] = ((_by_terms, "all terms have this sign"), (_by_number, "it is a number"))
RULES: tuple[Rule, ...] = (
    (_by_logarithms, "what the logarithms are of is compared with 1"),
    (_by_content, "a common factor is taken out"),
    (_by_root, "squares are compared"),
    (_by_quadratic, "a quadratic with this discriminant has no change of sign"),
    (_by_wave, "by |A cos x + B sin x| ≤ √(A² + B²)"),
    (_by_bounds, "it has this sign on the whole range of a generator"),
    (_by_exponentials, "all exponentials are powers of one"),
    (_by_squares, "by sin² + cos² = 1"),
    (_by_factors, "the signs of its factors"),
    (_by_double_angle, "by |sin 2x| ≤ 1"),
    (_by_one_angle, "all angles are multiples of one"),
    (_by_turned_angle, "a difference of angles is an angle of its own"),
)
