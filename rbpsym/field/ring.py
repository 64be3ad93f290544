"""Common divisors and factors in ℚ[x0, x1, ...]: by flint, or by sympy where flint is missing.

Both give the same factors in the same order; cofactors may differ by a number. Sines and cosines count as independent.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from importlib.util import find_spec
from operator import sub
from types import ModuleType
from typing import Any

from rbpsym.field.poly import Coefficient, Monomial, Poly, ratio

Powers = tuple[int, ...]


@lru_cache(maxsize=1)
def backend() -> ModuleType:
    """The module whose `element`, `cofactors` and `factor_list` are asked."""
    from rbpsym.field import flint_ring, sympy_bridge

    return flint_ring if find_spec("flint") else sympy_bridge


def element(poly: Poly, order: Sequence[int], ring: ModuleType) -> Any:
    """The polynomial as an element of ℚ[x0, x1, ...], its atoms in this order."""
    return ring.element(dict(zip(_rows(poly, order), poly.terms.values(), strict=True)), len(order))


def _rows(poly: Poly, order: Sequence[int]) -> list[Powers]:
    """The powers of the atoms, term by term."""
    place, zeros, rows = {index: k for k, index in enumerate(order)}, [0] * len(order), []
    for m in poly.terms:
        powers = zeros[:]
        for index, exponent in m:
            powers[place[index]] = exponent
        rows.append(tuple(powers))
    return rows


def _poly(terms: Iterable[tuple[Powers, Any]], order: Sequence[int]) -> Poly:
    return Poly({tuple([(i, int(e)) for i, e in zip(order, powers, strict=True) if e]): number(c) for powers, c in terms})


def number(c: Any) -> Coefficient:
    """A rational number of either ring as one of ours."""
    return ratio(int(c.numerator), int(c.denominator))


def cofactors(a: Poly, b: Poly) -> tuple[Poly, Poly]:
    """a/g and b/g for the greatest common divisor g of two Laurent polynomials (the same two where there is none)."""
    ring, order = backend(), sorted(a.atoms() | b.atoms())
    (x, low), (y, below) = _lifted(a, order, ring), _lifted(b, order, ring)
    found = ring.cofactors(x, y)
    if found is None:
        return a, b
    return _poly(found[0].terms(), order).scaled(1, low), _poly(found[1].terms(), order).scaled(1, below)


def _lifted(poly: Poly, order: Sequence[int], ring: ModuleType) -> tuple[Any, Monomial]:
    """The polynomial without its greatest common monomial, and that."""
    rows = _rows(poly, order)
    low = [min(column) for column in zip(*rows, strict=True)]
    if any(low):
        rows = [tuple(map(sub, row, low)) for row in rows]
    powers = tuple([(index, e) for index, e in zip(order, low, strict=True) if e])
    return ring.element(dict(zip(rows, poly.terms.values(), strict=True)), len(order)), powers


@lru_cache(maxsize=4096)
def factors(poly: Poly) -> tuple[Coefficient, tuple[tuple[Poly, int], ...]]:
    """Rational coefficient and irreducible factors over ℚ with multiplicities.

    There may be no negative powers. Each factor has whole coefficients without common divisor, the first of them
    positive.
    """
    ring, order = backend(), sorted(poly.atoms())
    if not order:
        return poly.constant_value() or 0, ()
    coefficient, found = ring.factor_list(element(poly, order, ring))
    listed = sorted(([list(factor.terms()), k] for factor, k in found), key=_key)
    return number(coefficient), tuple((_poly(terms, order), int(k)) for terms, k in listed)


def _key(item: Any) -> tuple[Any, ...]:
    """By the degree in the first generator, the multiplicity, and the coefficients."""
    terms, k = item
    return terms[0][0][0], k, _nested(terms, 0, len(terms[0][0]))


def _nested(terms: list[tuple[Powers, Any]], place: int, count: int) -> Any:
    """The coefficients by falling powers of the generators, one within the other."""
    if place == count:
        return terms[0][1] if terms else 0
    parts: dict[int, list[tuple[Powers, Any]]] = {}
    for term in terms:
        parts.setdefault(int(term[0][place]), []).append(term)
    return [_nested(parts.get(k, []), place + 1, count) for k in range(max(parts, default=-1), -1, -1)]
