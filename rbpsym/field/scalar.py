"""Scalars: quotients of Laurent polynomials, the values of all formulas.

`num / den`; a denominator of one term is absorbed into `num` as negative powers, so most
scalars of mechanics have den = 1. Common factors are cancelled, except where the greatest
common divisor would have to be searched modulo sin² + cos² = 1. Two equal values may have
different forms: compare with `normal.is_zero(a - b)`, not with ==.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache

from rbpsym.field import atoms
from rbpsym.field.effort import remembered
from rbpsym.field.poly import ONE, UNIT, ZERO, Monomial, Poly, accumulate, constant, generator, inverse, ratio


class Scalar:
    """An element of the field; use + - * / and ** with integers; ints and Fractions mix in."""

    __slots__ = ("_hash", "den", "num")

    def __init__(self, num: Poly, den: Poly = ONE) -> None:
        self.num, self.den = num, den
        self._hash: int | None = None

    def __hash__(self) -> int:
        if self._hash is None:
            self._hash = hash((self.num, self.den))
        return self._hash

    def __eq__(self, other: object) -> bool:
        """Sameness of form (not of value: that is `normal.is_zero` of the difference)."""
        if not isinstance(other, Scalar):
            return isinstance(other, (int, Fraction)) and self.number() == other
        return self is other or (self.num == other.num and self.den == other.den)

    def __bool__(self) -> bool:
        return bool(self.num.terms)

    def __repr__(self) -> str:
        return f"Scalar({show(self)})"

    def __add__(self, other: Operand) -> Scalar:
        other = other if type(other) is Scalar else lift(other)
        if not other.num.terms:
            return self
        if not self.num.terms:
            return other
        if self.den is other.den or self.den == other.den:
            total = self.num + other.num
            return Scalar(total) if self.den is ONE else quotient(total, self.den)
        return quotient(self.num * other.den + other.num * self.den, self.den * other.den)

    __radd__ = __add__

    def __neg__(self) -> Scalar:
        return Scalar(-self.num, self.den)

    def __sub__(self, other: Operand) -> Scalar:
        other = other if type(other) is Scalar else lift(other)
        return Scalar(self.num - other.num) if self.den is ONE and other.den is ONE else self + -other

    def __rsub__(self, other: Operand) -> Scalar:
        return lift(other) + (-self)

    def __mul__(self, other: Operand) -> Scalar:
        other = other if type(other) is Scalar else lift(other)
        if self.den is ONE and other.den is ONE:
            num = self.num * other.num
            return self if num is self.num else other if num is other.num else Scalar(num)
        if not self.num.terms or not other.num.terms:
            return NOTHING
        if self.num == other.den:
            return quotient(other.num, self.den)
        if other.num == self.den:
            return quotient(self.num, other.den)
        return quotient(self.num * other.num, self.den * other.den)

    __rmul__ = __mul__

    def __truediv__(self, other: Operand) -> Scalar:
        return self * lift(other).inverse()

    def __rtruediv__(self, other: Operand) -> Scalar:
        return lift(other) * self.inverse()

    def inverse(self) -> Scalar:
        """1 / self. Raises ZeroDivisionError for the zero form."""
        if not self.num.terms:
            raise ZeroDivisionError("division by zero")
        return quotient(self.den, self.num)

    def __pow__(self, exponent: int) -> Scalar:
        if exponent < 0:
            return self.inverse() ** -exponent
        return Scalar(self.num**exponent, self.den**exponent if self.den is not ONE else ONE)

    def atoms(self) -> frozenset[int]:
        """Indices of the atoms that occur in numerator or denominator."""
        return self.num.atoms() | self.den.atoms() if self.den is not ONE else self.num.atoms()

    def number(self) -> int | Fraction | None:
        """The rational number it is, or None."""
        return self.num.constant_value() if self.den is ONE else None


Operand = Scalar | int | Fraction


def lift(value: object) -> Scalar:
    """A number as a Scalar; a Scalar as it is."""
    return value if isinstance(value, Scalar) else Scalar(constant(value))


@remembered
def quotient(num: Poly, den: Poly) -> Scalar:
    """num / den with monomials, contents and common factors cancelled.

    Raises ZeroDivisionError if den turns out to vanish by sin² + cos² = 1.
    """
    if not num.terms:
        return NOTHING
    if not den.is_monomial():
        from rbpsym.field.division import cancel

        num, den = cancel(num, den)
        if not den.terms:
            raise ZeroDivisionError("division by zero")
        if not num.terms:
            return NOTHING
    if den.is_monomial():
        [(m, c)] = den.terms.items()
        return Scalar(num.scaled(ratio(c.denominator, c.numerator), inverse(m)))
    rational, powers = den.content()
    sign = -1 if den.terms[min(den.terms, key=_order)] < 0 else 1
    factor, by = ratio(sign * rational.denominator, rational.numerator), inverse(powers)
    return Scalar(num.scaled(factor, by), den.scaled(factor, by))


def _order(m: Monomial) -> tuple[int, Monomial]:
    return (-len(m), m)


NOTHING, UNITY = Scalar(ZERO), Scalar(ONE)


def total(parts: Iterable[Scalar]) -> Scalar:
    """The sum, those with the same denominator brought together before anything is cancelled."""
    by_den: dict[Poly, list[tuple[int, Poly]]] = {}
    for part in parts:
        if part.num.terms:
            by_den.setdefault(part.den, []).append((1, part.num))
    sums = ((accumulate(found) if len(found) > 1 else found[0][1], den) for den, found in by_den.items())
    return sum((Scalar(num) if den == ONE else quotient(num, den) for num, den in sums), NOTHING)


@lru_cache(maxsize=4096)
def symbol(name: str) -> Scalar:
    """The quantity called `name` as a generator."""
    return Scalar(generator(atoms.intern("symbol", name)))


def generator_of(kind: str, arg: object) -> Scalar:
    """Any atom as a Scalar."""
    return Scalar(generator(atoms.intern(kind, arg)))


PI = Scalar(generator(atoms.PI))


def show(value: Scalar) -> str:
    """A short text for debugging (never shown to users)."""
    return _show(value.num) if value.den is ONE else f"({_show(value.num)})/({_show(value.den)})"


def _show(poly: Poly) -> str:
    return " + ".join(_term(m, c) for m, c in poly.terms.items()) or "0"


def _term(m: Monomial, c: int | Fraction) -> str:
    parts = [] if c == 1 and m != UNIT else [str(c)]
    return "*".join(parts + [name_of(i) + (f"**{e}" if e != 1 else "") for i, e in m])


def name_of(index: int) -> str:
    """A short, stable text for an atom."""
    found = atoms.atom(index)
    if found.kind == "symbol":
        return str(found.arg)
    inner = _show(found.arg) if isinstance(found.arg, Poly) else str(found.arg)
    return f"{found.kind}({inner})"
