"""Sparse Laurent polynomials over ℚ in atoms: {monomial: coefficient}.

A monomial is a tuple of (atom index, exponent), sorted by index, exponents non-zero
integers (negative ones allowed). Polys are immutable and hashable; no relation between
atoms (sin² + cos² = 1, √x² = x) is applied here: see `field.normal`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from math import gcd, lcm
from typing import Any

from rbpsym.errors import LimitError
from rbpsym.field.effort import spend

Monomial = tuple[tuple[int, int], ...]
Coefficient = int | Fraction
UNIT: Monomial = ()
MOST_TERMS = 20_000


def times(a: Monomial, b: Monomial) -> Monomial:
    """The product of two monomials."""
    if not a:
        return b
    if not b:
        return a
    if a[-1][0] < b[0][0]:
        return a + b
    if b[-1][0] < a[0][0]:
        return b + a
    return _merge(a, b)


@lru_cache(maxsize=65536)
def _merge(a: Monomial, b: Monomial) -> Monomial:
    powers = dict(a)
    for index, exponent in b:
        powers[index] = powers.get(index, 0) + exponent
    return tuple(sorted(item for item in powers.items() if item[1]))


def inverse(a: Monomial) -> Monomial:
    """1 / monomial."""
    return tuple((index, -exponent) for index, exponent in a)


def tidy(value: Coefficient) -> Coefficient:
    """An int where the fraction is one."""
    return value.numerator if type(value) is Fraction and value.denominator == 1 else value


def size_of(value: Coefficient) -> Coefficient:
    """The number without its sign."""
    return -value if value < 0 else value


@lru_cache(maxsize=65536)
def ratio(numerator: int, denominator: int) -> Coefficient:
    """A quotient of whole numbers, an int where it is one."""
    return numerator // denominator if numerator % denominator == 0 else Fraction(numerator, denominator)


class Poly:
    """A Laurent polynomial. Build with `Poly.of`, `constant`, `monomial`; use + - * and **."""

    __slots__ = ("_atoms", "_denominator", "_hash", "terms")

    def __init__(self, terms: Mapping[Monomial, Coefficient], denominator: int = 0) -> None:
        """`denominator`: the common one of the coefficients, where it is known."""
        self.terms = terms
        self._hash: int | None = None
        self._atoms: frozenset[int] | None = None
        self._denominator = denominator

    def __hash__(self) -> int:
        if self._hash is None:
            self._hash = hash(sum([hash(m) * c.numerator for m, c in self.terms.items()]))
        return self._hash

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Poly) and self.terms == other.terms)

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __len__(self) -> int:
        return len(self.terms)

    def __repr__(self) -> str:
        return f"Poly({dict(self.terms)!r})"

    def __add__(self, other: Poly) -> Poly:
        if not self.terms:
            return other
        if not other.terms:
            return self
        return _sum(self, other, 1)

    def __sub__(self, other: Poly) -> Poly:
        return _sum(self, other, -1) if other.terms else self

    def __neg__(self) -> Poly:
        return Poly({m: -c for m, c in self.terms.items()}, self._denominator)

    def __mul__(self, other: Poly) -> Poly:
        if len(self.terms) * len(other.terms) > 40 * MOST_TERMS:
            raise LimitError("the expression grows beyond what can be expanded exactly")
        spend(len(self.terms) * len(other.terms))
        if other is ONE or not self.terms:
            return self
        if self is ONE or not other.terms:
            return other
        if len(other.terms) == 1:
            [(m, c)] = other.terms.items()
            return self.scaled(c, m)
        if len(self.terms) == 1:
            [(m, c)] = self.terms.items()
            return other.scaled(c, m)
        result: dict[Monomial, int] = {}
        below, factors = other.whole()
        denominator, terms = self.whole()
        for m1, c1 in terms.items():
            for m2, c2 in factors.items():
                m = times(m1, m2)
                result[m] = result.get(m, 0) + c1 * c2
        return divided(result, denominator * below)

    def __pow__(self, exponent: int) -> Poly:
        if len(self.terms) == 1 or exponent < 0:
            [(m, c)] = self.terms.items()
            power: Coefficient = 1
            if c != 1:
                power = c**exponent if exponent >= 0 else Fraction(1) / Fraction(c) ** -exponent
            return Poly({tuple((i, e * exponent) for i, e in m) if exponent else UNIT: tidy(power)})
        result, base = ONE, self
        while exponent:
            if exponent & 1:
                result = result * base
            exponent >>= 1
            base = base * base if exponent else base
        return result

    def scaled(self, coefficient: Coefficient, by: Monomial = UNIT) -> Poly:
        """The product with coefficient × monomial."""
        if not coefficient:
            return ZERO
        if coefficient == 1:
            return self if not by else Poly({times(m, by): c for m, c in self.terms.items()}, self._denominator)
        if self._denominator == 1 and type(coefficient) is int:
            return Poly({times(m, by): c * coefficient for m, c in self.terms.items()}, 1)
        above, below = coefficient.numerator, coefficient.denominator
        return Poly({times(m, by): ratio(c.numerator * above, c.denominator * below) for m, c in self.terms.items()})

    def whole(self) -> tuple[int, Mapping[Monomial, int]]:
        """The common denominator, and the terms multiplied by it."""
        if not self._denominator:
            fractions = {type(c) for c in self.terms.values()} - {int}
            self._denominator = lcm(*[c.denominator for c in self.terms.values()]) if fractions else 1
        terms: Any = self.terms
        d = self._denominator
        return d, terms if d == 1 else {m: c.numerator * (d // c.denominator) for m, c in self.terms.items()}

    def atoms(self) -> frozenset[int]:
        """Indices of all atoms that occur."""
        if self._atoms is None:
            self._atoms = frozenset([index for m in self.terms for index, _ in m])
        return self._atoms

    def is_monomial(self) -> bool:
        """Whether it has exactly one term."""
        return len(self.terms) == 1

    def constant_value(self) -> Coefficient | None:
        """The number it is, or None if an atom occurs."""
        if not self.terms:
            return 0
        return self.terms.get(UNIT) if len(self.terms) == 1 else None

    def by_power(self, index: int) -> dict[int, Poly]:
        """Coefficients by the power of one atom."""
        parts: dict[int, dict[Monomial, Coefficient]] = {}
        for m, c in self.terms.items():
            power = next((e for i, e in m if i == index), 0)
            rest = tuple(item for item in m if item[0] != index) if power else m
            parts.setdefault(power, {})[rest] = c
        return {power: Poly(part) for power, part in parts.items()}

    def content(self) -> tuple[Fraction, Monomial]:
        """The positive rational and the monomial that can be taken out of all terms."""
        numerator, denominator = 0, 1
        lowest: dict[int, int] | None = None
        for m, c in self.terms.items():
            numerator = gcd(numerator, c.numerator)
            denominator = lcm(denominator, c.denominator)
            lowest = dict(m) if lowest is None else _lower(lowest, dict(m))
        powers = tuple(sorted(item for item in (lowest or {}).items() if item[1]))
        return Fraction(numerator or 1, denominator), powers


def _lower(a: dict[int, int], b: dict[int, int]) -> dict[int, int]:
    return {i: min(a.get(i, 0), b.get(i, 0)) for i in a.keys() | b.keys()}


def clean(terms: dict[Monomial, Coefficient]) -> Poly:
    """A Poly from raw terms: zeros dropped, whole fractions made ints."""
    if len(terms) > MOST_TERMS:
        raise LimitError(f"the expression has more than {MOST_TERMS} terms when multiplied out")
    return Poly({m: tidy(c) for m, c in terms.items() if c})


def divided(terms: dict[Monomial, int], denominator: int) -> Poly:
    """A Poly from whole raw terms and what they are divided by."""
    if len(terms) > MOST_TERMS:
        raise LimitError(f"the expression has more than {MOST_TERMS} terms when multiplied out")
    if denominator == 1:
        return Poly({m: c for m, c in terms.items() if c} if 0 in terms.values() else terms, 1)
    return Poly({m: ratio(c, denominator) for m, c in terms.items() if c})


def _sum(a: Poly, b: Poly, sign: int) -> Poly:
    """a ± b."""
    if not a._denominator == b._denominator == 1:
        return accumulate(((1, a), (sign, b)))
    spend(len(a.terms) + len(b.terms))
    result: dict[Monomial, Any] = dict(a.terms)
    for m, c in b.terms.items():
        result[m] = result.get(m, 0) + sign * c
    return divided(result, 1)


def accumulate(parts: Iterable[tuple[Coefficient, Poly]]) -> Poly:
    """Σ coefficient × poly, in one pass."""
    result: dict[Monomial, int] = {}
    found = [(factor, *poly.whole()) for factor, poly in parts]
    denominator = lcm(*[factor.denominator * below for factor, below, _ in found])
    for factor, below, terms in found:
        spend(len(terms))
        number = factor.numerator * (denominator // (factor.denominator * below))
        if number == 1 and not result:
            result = dict(terms)
            continue
        for m, c in terms.items():
            result[m] = result.get(m, 0) + number * c
    return divided(result, denominator)


@lru_cache(maxsize=1024)
def constant(value: Coefficient) -> Poly:
    """A number as a Poly."""
    return Poly({UNIT: tidy(value)}) if value else ZERO


@lru_cache(maxsize=8192)
def generator(index: int) -> Poly:
    """One atom as a Poly."""
    return Poly({((index, 1),): 1}, 1)


ZERO, ONE = Poly({}, 1), Poly({UNIT: 1}, 1)
