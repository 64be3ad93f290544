"""Common divisors and factors in ℚ[x0, x1, ...]: by flint, or by sympy where flint is missing.

Both give the same: what is found is scaled and put in order here. Polynomials have no negative powers; sines and
cosines count as independent.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from importlib.util import find_spec
from types import ModuleType
from typing import Any

from rbpsym.algebra.poly import Coefficient, Monomial, Poly

Powers = tuple[int, ...]


@lru_cache(maxsize=1)
def backend() -> ModuleType:
    """The module whose `element`, `cofactors` and `factor_list` are asked."""
    from rbpsym.algebra import flint_ring, sympy_bridge

    return flint_ring if find_spec("flint") else sympy_bridge


def element(poly: Poly, order: Sequence[int], ring: ModuleType) -> Any:
    """The polynomial as an element of ℚ[x0, x1, ...], its atoms in this order."""
    place = {index: k for k, index in enumerate(order)}
    terms, zeros = {}, [0] * len(order)
    for m, c in poly.terms.items():
        powers = zeros[:]
        for index, exponent in m:
            powers[place[index]] = exponent
        terms[tuple(powers)] = c
    return ring.element(terms, len(order))


def _poly(terms: Iterable[tuple[Powers, Any]], order: Sequence[int]) -> Poly:
    return Poly({_monomial(powers, order): number(c) for powers, c in terms})


def _monomial(powers: Powers, order: Sequence[int]) -> Monomial:
    return tuple([(index, int(e)) for index, e in zip(order, powers, strict=True) if e])


def number(c: Any) -> Coefficient:
    """A rational number of either ring as one of ours."""
    return int(c.numerator) if c.denominator == 1 else Fraction(int(c.numerator), int(c.denominator))


def cofactors(a: Poly, b: Poly) -> tuple[Poly, Poly]:
    """a/g and b/g for the greatest common divisor g (the same two where there is none)."""
    ring, order = backend(), sorted(a.atoms() | b.atoms())
    found = ring.cofactors(element(a, order, ring), element(b, order, ring))
    return (a, b) if found is None else tuple(_poly(part.terms(), order) for part in found)


@lru_cache(maxsize=4096)
def factors(poly: Poly) -> tuple[Coefficient, tuple[tuple[Poly, int], ...]]:
    """Rational coefficient and irreducible factors over ℚ with multiplicities.

    Each factor has whole coefficients without common divisor, that of its first term is positive.
    """
    ring, order = backend(), sorted(poly.atoms())
    if not order:
        return poly.constant_value() or 0, ()
    coefficient, found = ring.factor_list(element(poly, order, ring))
    listed = sorted(([list(factor.terms()), k] for factor, k in found), key=_key)
    return number(coefficient), tuple((_poly(terms, order), int(k)) for terms, k in listed)


def _key(item: list) -> tuple:
    """By the degree in the first generator, the multiplicity, and the coefficients."""
    terms, k = item
    return terms[0][0][0], k, _nested(terms, 0, len(terms[0][0]))


def _nested(terms: list[tuple[Powers, Any]], place: int, count: int) -> Any:
    """The coefficients by falling powers of the generators, one within the other."""
    if place == count:
        return terms[0][1] if terms else 0
    parts: dict[int, list] = {}
    for term in terms:
        parts.setdefault(int(term[0][place]), []).append(term)
    return [_nested(parts.get(k, []), place + 1, count) for k in range(max(parts, default=-1), -1, -1)]
