"""Factors of polynomials for `reading`, divisors that are kept as generators of their own, and sets of signs as bit masks."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache

from rbpsym.errors import LimitError
from rbpsym.field import Poly, Scalar, accumulate, atoms, factors, generator, reduce_roots, reduce_squares, root

Factors = dict[Poly, int]
MOST_TERMS = 400
PARTS = 60  # powers of x are those of exp(ln x/60), so that roots up to the sixth are


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
    """Normal form modulo sin² + cos² = 1, √x² = x and exp(ln x/2) = √x (up to a non-zero factor)."""
    for index in poly.atoms():
        base = _base(index)
        if base is not None:
            powers, half = poly.by_power(index), PARTS // 2
            least = min(0, *powers)
            taken = [(part, *divmod(power - least, half)) for power, part in powers.items()]
            poly = accumulate((1, part * root(base).num ** n * generator(index) ** rest) for part, n, rest in taken)
    return reduce_roots(reduce_squares(poly))


def _base(index: int) -> Scalar | None:
    """x of exp(ln x/60)."""
    found = atoms.atom(index)
    terms = found.arg.num.terms if found.kind == "exp" else {}
    inner = [atoms.atom(m[0][0]) for m, c in terms.items() if len(terms) == len(m) == c * PARTS == 1]
    return inner[0].arg if inner and inner[0].kind == "ln" else None


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


MINUS, ZERO, PLUS = 1, 2, 4
ANY, NONZERO = MINUS | ZERO | PLUS, MINUS | PLUS
PLUS_ZERO, MINUS_ZERO = PLUS | ZERO, MINUS | ZERO
DECIDED = (PLUS, MINUS, ZERO)
BITS = {-1: MINUS, 0: ZERO, 1: PLUS}

NAMES: dict[int, str | None] = {
    PLUS: "positive",
    MINUS: "negative",
    ZERO: "zero",
    PLUS_ZERO: "nonnegative",
    MINUS_ZERO: "nonpositive",
    NONZERO: "nonzero",
    ANY: None,
    0: None,
}


def members(mask: int) -> list[int]:
    """The signs in a mask, as -1, 0, 1."""
    return [sign for sign, bit in BITS.items() if mask & bit]


def _sum_of(a: int, b: int) -> int:
    """The mask of the sum of two numbers of known signs."""
    if a == 0 or a == b:
        return BITS[b]
    return BITS[a] if b == 0 else ANY


def _table(rule: Callable[[int, int], int]) -> tuple[tuple[int, ...], ...]:
    rows = []
    for a in range(8):
        row = []
        for b in range(8):
            mask = 0
            for x in members(a):
                for y in members(b):
                    mask |= rule(x, y)
            row.append(mask)
        rows.append(tuple(row))
    return tuple(rows)


_SUM, _PRODUCT = _table(_sum_of), _table(lambda a, b: BITS[a * b])


def plus(a: int, b: int) -> int:
    """Signs that a sum may have."""
    return _SUM[a][b]


def times(a: int, b: int) -> int:
    """Signs that a product may have."""
    return _PRODUCT[a][b]


def flip(a: int) -> int:
    """Signs of the negative."""
    return _PRODUCT[a][MINUS]


def power(a: int, exponent: int) -> int:
    """Signs of an integer power; a base of a negative power is not zero."""
    if exponent < 0:
        a &= NONZERO
    return a if exponent % 2 else (a & ZERO) | (PLUS if a & NONZERO else 0)
