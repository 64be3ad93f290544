"""Nested roots: √(A + B√C) = √((A + D)/2) ± √((A - D)/2) where A² - B² C is a square D²."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import isqrt
from typing import TYPE_CHECKING

from rbpsym.algebra import ONE, UNIT, Coefficient, Monomial, Poly, Scalar, atoms
from rbpsym.equality.factoring import reduced, split

if TYPE_CHECKING:
    from rbpsym.equality.factoring import Factors
    from rbpsym.equality.reading import Reading

HALF = Fraction(1, 2)


@dataclass(frozen=True, slots=True)
class Denested:
    """`image` is the root of one factor (with the coefficient); `others` are left to be taken."""

    image: Poly
    others: Factors


def denested(reading: Reading, coefficient: Fraction, found: Factors) -> Denested | None:
    """The root of a factor with a root inside, if it can be written without nesting."""
    for factor, k in found.items():
        if k % 2 and len(factor) > 1 and any(_is_root(index) for index in factor.atoms()):
            others = {f: e for f, e in found.items() if f != factor} | {factor: k - 1}
            signs = [reading.sign(f) for f, e in others.items() if e % 2]
            image = _root_of(reading, factor.scaled(coefficient)) if -1 not in signs else None
            if image is not None:
                return Denested(image, others)
    return None


def _is_root(index: int) -> bool:
    return atoms.atom(index).kind == "root"


def _parts(poly: Poly) -> dict[Monomial, Poly]:
    """The terms by their product of roots."""
    parts: dict[Monomial, dict[Monomial, Coefficient]] = {}
    for m, c in poly.terms.items():
        roots = tuple(item for item in m if _is_root(item[0]))
        parts.setdefault(roots, {})[tuple(item for item in m if not _is_root(item[0]))] = c
    return {roots: Poly(terms) for roots, terms in parts.items()}


def _root_of(reading: Reading, poly: Poly) -> Poly | None:
    parts = _parts(poly)
    if len(parts) != 2 or UNIT not in parts:
        return None
    a = parts.pop(UNIT)
    [(roots, b)] = parts.items()
    square = reduce(lambda product, item: product * atoms.atom(item[0]).arg.num, roots, ONE)
    d = square_root(reading, reduced(a * a - b * b * square))
    if d is None or reading.sign(a) < 0:
        return None
    low, high = (reading.power(_root_index(x), 1) for x in (a - d, a + d))
    return high + low if reading.sign(b) > 0 else high - low


def _root_index(twice: Poly) -> int:
    return atoms.intern("root", Scalar(twice.scaled(HALF)))


def square_root(reading: Reading, poly: Poly) -> Poly | None:
    """|D| if the polynomial is a square D²."""
    if not poly.terms:
        return poly
    rational, powers = poly.content()
    coefficient, found = split(poly.scaled(1 / rational, tuple((i, -e) for i, e in powers)), reading.deep)
    number = _number_root(coefficient * rational)
    factors = [*found, *((Poly({((i, 1),): 1}), e) for i, e in powers)]
    if number is None or any(k % 2 for _, k in factors):
        return None
    result = Poly({UNIT: number})
    for factor, k in factors:
        result = result * reading.absolute(factor, k // 2)
    return result


def _number_root(value: Fraction) -> Fraction | None:
    if value < 0:
        return None
    p, q = isqrt(value.numerator), isqrt(value.denominator)
    return Fraction(p, q) if p * p == value.numerator and q * q == value.denominator else None
