"""Exact division and cancelling of common factors of Laurent polynomials, and whether one vanishes on an ideal."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import Any

from rbpsym.field import atoms, sympy_bridge
from rbpsym.field.normal import Bases, bases_of, in_bases, partner, partner_of, reduce_squares, shorten
from rbpsym.field.poly import ONE, Poly, generator, inverse
from rbpsym.field.ring import cofactors, element
from rbpsym.field.scalar import Scalar

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
