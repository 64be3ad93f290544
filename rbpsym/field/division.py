"""Exact division and cancelling of common factors of Laurent polynomials, and whether one vanishes on an ideal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import combinations
from typing import Any

from rbpsym.field import atoms, calculus, sympy_bridge
from rbpsym.field.normal import Bases, bases_of, in_bases, normal, partner, partner_of, reduce_squares, short, shorten, substitute
from rbpsym.field.poly import ONE, Poly, generator, inverse
from rbpsym.field.ring import cofactors, element, factors
from rbpsym.field.scalar import UNITY, Scalar, quotient, symbol

LARGEST_GCD = 1_000_000  # products of terms, above which a common factor is not looked for


def cancel(num: Poly, den: Poly) -> tuple[Poly, Poly]:
    """num and den without their common factor (sin² + cos² = 1 used to shorten them first)."""
    num, den = shorten(num), shorten(den)
    if len(den) < 2 or not num.terms:
        return num, den
    found = _cancel_plain(num, den)
    if found[1] is not den or not _has_partners(num, den):
        return found
    reduced = reduce_squares(num), reduce_squares(den)
    if not reduced[0].terms or not reduced[1].terms:
        return reduced
    found = _cancel_plain(*reduced)
    return found if found[1] is not reduced[1] else (num, den)


def _cancel_plain(num: Poly, den: Poly) -> tuple[Poly, Poly]:
    """The same (identical `den`) if no common factor is found."""
    if len(num) * len(den) > LARGEST_GCD or not num.atoms() & den.atoms():
        return num, den
    return cofactors(num, den)


def _has_partners(num: Poly, den: Poly) -> bool:
    """Whether a sine and the cosine of the same angle occur, one of them below."""
    everywhere = num.atoms() | den.atoms()
    return any(partner(index) in everywhere for index in den.atoms())


def divide(num: Poly, den: Poly) -> Poly | None:
    """num / den if den divides num (as Laurent polynomials), else None."""
    if not num.terms or den.is_monomial():
        return num * den**-1 if num.terms else num
    above, below = cofactors(num, den)
    return above * below**-1 if below.is_monomial() else None


LINEAR = 2  # terms of 1 ± cos q, what is left of sin² q where the other one goes: its poles are half of those of 1/sin q


def without_poles(value: Scalar) -> Scalar:
    """The value without those factors below the line that sin² + cos² = 1 takes away: (1 - cos² q)/sin q as sin q, and with the
    fewest poles of (1 + cos q)/sin q = sin q/(1 - cos q)."""
    powers = tuple((i, -e) for i, e in value.num.content()[1] if e < 0 and partner(i))
    num, den = value.num.scaled(1, powers), value.den.scaled(1, powers)
    if not _waves(den):
        return value
    for image, back in turnings(den, in_pairs=True):
        if len(normal(calculus.substitute(Scalar(den), image).num)) < len(normal(den)):
            return calculus.substitute(without_poles(calculus.substitute(value, image)), back)
    bases = bases_of(num, den)
    num, den = reduce_squares(in_bases(num, bases)), in_bases(den, bases)
    coefficient, found = factors(den)
    above, below = Scalar(num) / coefficient, UNITY
    for factor in (factor for factor, exponent in found for _ in range(exponent)):
        rest = _divided(above, factor)
        stays = _waves(rest.num, -1) or (_waves(rest.den) and not (len(factor) == 1 and len(rest.den) == LINEAR))
        above, below = (above, below * Scalar(factor)) if stays else (rest, below)
    less = short(above / below)
    return value if less == value else without_poles(less)


def turnings(poly: Poly, *, in_pairs: bool = False) -> Iterator[tuple[dict[str, Scalar], dict[str, Scalar]]]:
    """Images that make a difference of angles in it an angle of its own, cos A = cos(B + (A - B)), each with its way back; one
    of two that stand in it apart, too (`in_pairs`)."""
    found = dict.fromkeys(Scalar(atoms.atom(index).arg) for index in sorted(poly.atoms()) if partner(index))
    pairs = (one - other for one, other in combinations((angle for angle in found if len(angle.num) == 1), 2) if in_pairs)
    for angle in (*(angle for angle in found if len(angle.num) > 1), *pairs):
        for name in sorted(calculus.names_in(angle) - {"pi"}):
            slope, letter = calculus.derivative(angle, name), f"{name}°"
            if slope.number() is not None:
                yield {name: symbol(name) + (symbol(letter) - angle) / slope}, {letter: angle}


def _divided(value: Scalar, factor: Poly) -> Scalar:
    """value/f as value f̄/(f f̄), f̄ having -sin for sin: below the line stand cosines alone, and common factors go."""
    num, den = value.num, reduce_squares(factor) * value.den
    for index in [i for i in factor.atoms() if atoms.atom(i).kind == "sin"]:
        other = substitute(den, {index: -generator(index)})
        num, den = _cancel_plain(reduce_squares(num * other), reduce_squares(den * other))
    return quotient(num, den)


def _waves(poly: Poly, sense: int = 1) -> bool:
    """Whether sines or cosines stand in it in powers of that sign."""
    return any(exponent * sense > 0 and partner(index) for m in poly.terms for index, exponent in m)


MOST_TERMS = 400


def vanishes_on(value: Scalar, relations: Iterable[Scalar]) -> bool:
    """Whether the numerator lies in the ideal of the relations' numerators (True is a proof)."""
    vanishing = tuple(r.num for r in relations)
    bases = bases_of(value.num, *vanishing)
    target = _ordinary(in_bases(value.num, bases))
    if len(target) > MOST_TERMS:
        return False
    basis, order = _basis(vanishing, bases, tuple(sorted(target.atoms())))
    return not element(target, order, sympy_bridge).rem(list(basis))


@lru_cache(maxsize=64)
def _basis(relations: tuple[Poly, ...], bases: Bases, more: tuple[int, ...]) -> tuple[Any, tuple[int, ...]]:
    """A Gröbner basis of the relations and of sin² + cos² = 1, with the order of its atoms."""
    ideal = [_ordinary(in_bases(relation, bases)) for relation in relations]
    used = sorted(set(more).union(*(p.atoms() for p in ideal)))
    circles = [i for i in used if atoms.atom(i).kind in ("cos", "sin")]
    for index in circles:
        other = partner_of(index)
        used = sorted({*used, other})
        ideal.append(generator(index) * generator(index) + generator(other) * generator(other) - ONE)
    elements = [element(p, used, sympy_bridge) for p in dict.fromkeys(ideal)]
    return sympy_bridge.groebner_basis(elements), tuple(used)


def _ordinary(poly: Poly) -> Poly:
    """Negative powers multiplied away."""
    low = tuple((i, min(0, *(dict(m).get(i, 0) for m in poly.terms))) for i in sorted(poly.atoms()))
    return poly.scaled(1, inverse(tuple(item for item in low if item[1])))
