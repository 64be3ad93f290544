"""Factors of polynomials for `reading`, and divisors that are kept as generators of their own."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from rbpsym.algebra import Poly, accumulate, atoms, generator, reduce_roots, reduce_squares
from rbpsym.errors import LimitError

Factors = dict[Poly, int]
MOST_TERMS = 400


def divisor(poly: Poly, exponent: int) -> Poly:
    """A power (mostly negative) of a polynomial as a power of one generator."""
    return generator(atoms.intern("factor", poly)) ** exponent


def cleared(poly: Poly) -> tuple[Poly, Factors]:
    """The polynomial without `factor` generators, and what it must be divided by."""
    divisors: Factors = {}
    for index in poly.atoms():
        found = atoms.atom(index)
        if found.kind == "factor":
            poly, divisors[found.arg] = _without(poly, index, found.arg)
    return poly, {factor: k for factor, k in divisors.items() if k}


def _without(poly: Poly, index: int, factor: Poly) -> tuple[Poly, int]:
    parts = poly.by_power(index)
    least = min((0, *parts))
    return accumulate((1, part * factor ** (k - least)) for k, part in parts.items()), -least


def reduced(poly: Poly) -> Poly:
    """Normal form modulo sin² + cos² = 1 and √x² = x (up to a non-zero factor)."""
    return reduce_roots(reduce_squares(poly))


def split(poly: Poly, deep: bool) -> tuple[Fraction, tuple[tuple[Poly, int], ...]]:
    """Coefficient and factors; each factor has a positive leading coefficient."""
    if len(poly) == 1:
        return Fraction(poly.constant_value() or 0), ()
    if deep:
        return _factor_list(poly)
    lead = poly.terms[min(poly.terms)]
    return (Fraction(1), ((poly, 1),)) if lead > 0 else (Fraction(-1), ((-poly, 1),))


@lru_cache(maxsize=512)
def _factor_list(poly: Poly) -> tuple[Fraction, tuple[tuple[Poly, int], ...]]:
    from rbpsym.algebra.ring import factors

    if len(poly) > MOST_TERMS:
        raise LimitError("a radicand is too large to be factored")
    coefficient, found = factors(poly)
    total, parts = Fraction(coefficient), []
    for factor, k in found:
        rational, _ = factor.content()
        rational = -rational if factor.terms[min(factor.terms)] < 0 else rational
        total *= rational**k
        parts.append((factor.scaled(1 / rational), k))
    return total, tuple(parts)


def primes(value: Fraction) -> dict[int, int]:
    """Prime factors with exponents (a large rest counts as one)."""
    found: dict[int, int] = {}
    for number, direction in ((value.numerator, 1), (value.denominator, -1)):
        p = 2
        while p * p <= number and p < 10_000:
            while number % p == 0:
                number, found[p] = number // p, found.get(p, 0) + direction
            p += 1
        if number > 1:
            found[number] = found.get(number, 0) + direction
    return found
