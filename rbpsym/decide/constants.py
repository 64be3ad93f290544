"""Which algebraic numbers are zero: by a separation bound (Burnikel, Fleischer, Mehlhorn, Schirra).

A number built from integers, square roots and cosines of rational multiples of π is a quotient
of algebraic integers whose conjugates are at most u (above) and l (below) in size. If its degree
is at most D and it is not zero, its size is at least 1/(u^(D-1) l). An enclosure that is smaller
proves that it is zero.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import gcd, lcm, log2

from rbpsym.decide import enclosure
from rbpsym.decide.points import Point, all_atoms
from rbpsym.field import ONE, PI_TERM, UNIT, Monomial, Poly, Scalar, atoms
from rbpsym.frozen import Frozen

SLACK = 1.0001  # the logarithms below are floats


class Size(Frozen):
    """Binary logarithms of the bounds u and l."""

    above: float
    below: float

    def __mul__(self, other: Size) -> Size:
        return Size(self.above + other.above, self.below + other.below)

    def __add__(self, other: Size) -> Size:
        large, small = sorted((self.above + other.below, other.above + self.below), reverse=True)
        return Size(large + log2(1 + 2 ** max(small - large, -1000)), self.below + other.below)

    def __pow__(self, exponent: int) -> Size:
        if exponent < 0:
            return Size(self.below, self.above) ** -exponent
        return Size(self.above * exponent, self.below * exponent)


def is_zero_form(poly: Poly) -> bool:
    """Whether all coefficients vanish, numbers such as 2cos(π/5) - φ taken for coefficients."""
    groups: dict[Monomial, dict[Monomial, int | Fraction]] = {}
    for m, c in poly.terms.items():
        rest = tuple(item for item in m if not is_algebraic(item[0]))
        inner = tuple(item for item in m if is_algebraic(item[0]))
        groups.setdefault(rest, {})[inner] = c
    return all(is_zero_number(Poly(terms)) for terms in groups.values())


@lru_cache(maxsize=8192)
def is_algebraic(index: int) -> bool:
    """Whether a generator is an algebraic number: a root or cosine of numbers."""
    found = atoms.atom(index)
    if found.kind in ("cos", "sin"):
        return set(found.arg.terms) <= {PI_TERM}
    return found.kind == "root" and all(is_algebraic(inner) for inner in found.arg.atoms())


def is_zero_number(poly: Poly) -> bool:
    """Whether an algebraic number is surely zero."""
    if not poly.terms or set(poly.terms) == {UNIT}:
        return not poly.terms
    size, degree = _size(poly), _degree(poly)
    try:
        low, high = enclosure.ends(Point({}).poly(poly))
    except enclosure.Outside:
        return False
    bits = ((degree - 1) * size.above + size.below) * SLACK + 1
    largest = max(abs(low), abs(high))
    return bits < enclosure.BITS and largest * 2 ** int(bits + 1) < 1


def _size(poly: Poly) -> Size:
    total = None
    for m, c in poly.terms.items():
        term = Size(log2(abs(c.numerator)), log2(c.denominator))
        for index, exponent in m:
            term = term * _atom_size(index) ** exponent
        total = term if total is None else total + term
    return total or Size(0, 0)


@lru_cache(maxsize=4096)
def _atom_size(index: int) -> Size:
    found = atoms.atom(index)
    if found.kind != "root":
        return Size(1, 1)  # 2 cos is an algebraic integer of size ≤ 2, divided by 2
    size = _size(found.arg.num)
    size = size if found.arg.den is ONE else size * _size(found.arg.den) ** -1
    return Size(size.above / 2, size.below / 2)


def _degree(poly: Poly) -> int:
    """A bound on the degree: each root doubles it, all cosines lie in one real cyclotomic field."""
    degree, order = 1, 1
    for index in all_atoms([Scalar(poly)]):
        found = atoms.atom(index)
        if found.kind == "root":
            degree *= 2
        elif found.kind in ("cos", "sin"):
            order = lcm(order, _order(found.kind, Fraction(found.arg.terms[PI_TERM])))
    return degree * max(1, sum(gcd(k, order) == 1 for k in range(1, order + 1)) // 2)  # Euler's φ


def _order(kind: str, turns: Fraction) -> int:
    """n where the number is cos(2πk/n)."""
    angle = turns if kind == "cos" else Fraction(1, 2) - turns
    return (angle / 2).denominator
