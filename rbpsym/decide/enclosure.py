"""Rigorous enclosures of real numbers by pairs of fractions.

A number is a `Fraction` where it is exact, else an `Enclosure`. Every function rounds
outwards, so that disjoint enclosures prove that two numbers differ.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from math import isqrt

from rbpsym.field.ring import backend
from rbpsym.frozen import Frozen

BITS = 256
_ONE = 1 << BITS
MOST_EXPONENT = 4000
LARGEST_ANGLE = 1 << 64
GUARD = 64  # binary places beyond those that are kept


class Outside(ArithmeticError):
    """A value that does not exist, or that cannot be enclosed (division by an interval with 0)."""


class Enclosure(Frozen):
    """A real number known to lie between two fractions."""

    lower: Fraction
    upper: Fraction

    def __add__(self, other: Number | int) -> Enclosure:
        low, high = ends(other)
        return outward(self.lower + low, self.upper + high)

    __radd__ = __add__

    def __neg__(self) -> Enclosure:
        return Enclosure(-self.upper, -self.lower)

    def __sub__(self, other: Number | int) -> Enclosure:
        return self + (-other)

    def __rsub__(self, other: Number | int) -> Enclosure:
        return -self + other

    def __mul__(self, other: Number | int) -> Number:
        low, high = ends(other)
        if low == high == 0:
            return Fraction(0)
        products = (self.lower * low, self.lower * high, self.upper * low, self.upper * high)
        return outward(min(products), max(products))

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> Number:
        if exponent < 0:
            return reciprocal(self) ** -exponent
        result: Number = Fraction(1)
        for _ in range(exponent):
            result = result * self
        if exponent % 2 or not isinstance(result, Enclosure):
            return result
        return Enclosure(max(result.lower, Fraction(0)), result.upper)

    def __str__(self) -> str:
        return f"{float((self.lower + self.upper) / 2):.12g}…"


Number = Fraction | Enclosure


def ends(number: Number | int) -> tuple[Fraction, Fraction]:
    """Lower and upper bound of a number."""
    if isinstance(number, Enclosure):
        return number.lower, number.upper
    exact = number if isinstance(number, Fraction) else Fraction(number)
    return exact, exact


def outward(lower: Fraction, upper: Fraction) -> Enclosure:
    """The enclosure, its bounds rounded outwards to BITS binary places where they are long."""
    if lower.denominator > _ONE:
        lower = Fraction(lower.numerator * _ONE // lower.denominator, _ONE)
    if upper.denominator > _ONE:
        upper = Fraction(-(-upper.numerator * _ONE // upper.denominator), _ONE)
    return Enclosure(lower, upper)


def sign_of(number: Number) -> int | None:
    """1, 0 or -1; None if the enclosure does not tell."""
    low, high = ends(number)
    if low > 0:
        return 1
    if high < 0:
        return -1
    return 0 if low == high else None


def are_disjoint(a: Number, b: Number) -> bool:
    """True only if the two numbers differ."""
    return sign_of(a - b) in (1, -1)


def reciprocal(number: Number) -> Number:
    """1 / number. Raises Outside if it may be zero."""
    if not sign_of(number):
        raise Outside("it divides by what vanishes there")
    if isinstance(number, Fraction):
        return 1 / number
    return outward(1 / number.upper, 1 / number.lower)


def monotone(lower: Callable[[Fraction], Number], number: Number) -> Number:
    """A rising function of a number, from the function of fractions."""
    if isinstance(number, Fraction):
        return lower(number)
    return Enclosure(ends(lower(number.lower))[0], ends(lower(number.upper))[1])


def root(number: Number) -> Number:
    """The square root, exact for squares. Raises Outside if it may be negative."""
    if ends(number)[0] < 0:
        raise Outside("square root of a negative number")
    return monotone(_root, number)


def _root(value: Fraction) -> Number:
    p, q = isqrt(value.numerator), isqrt(value.denominator)
    if p * p == value.numerator and q * q == value.denominator:
        return Fraction(p, q)
    scaled = isqrt(value.numerator * value.denominator << 2 * BITS)
    whole = value.denominator << BITS
    return Enclosure(Fraction(scaled, whole), Fraction(scaled + 1, whole))


@lru_cache(maxsize=8192)
def _enclosed(name: str, value: Fraction) -> Enclosure:
    """A function of a fraction, by the backend of the field."""
    middle, radius = backend().enclosed(name, value, BITS + GUARD)
    return outward(middle - radius, middle + radius)


def pi() -> Number:
    """π."""
    return 4 * _enclosed("atan", Fraction(1))


def atan(number: Number) -> Number:
    """The inverse tangent."""
    return Fraction(0) if number == 0 else monotone(lambda value: _enclosed("atan", value), number)


def asin(number: Number) -> Number:
    """The inverse sine. Raises Outside beyond [-1, 1]."""
    if number == 0:
        return Fraction(0)
    if number in (1, -1):
        return pi() * number * Fraction(1, 2)
    return atan(number * reciprocal(root(1 - number * number)))


def acos(number: Number) -> Number:
    """The inverse cosine."""
    return Fraction(0) if number == 1 else pi() * Fraction(1, 2) - asin(number)


def elliptic_k(number: Number) -> Number:
    """The complete elliptic integral K(m). Raises Outside for m ≥ 1."""
    if ends(number)[1] >= 1:
        raise Outside("an elliptic integral of a modulus that is not less than 1")
    return monotone(lambda value: _enclosed("elliptic_k", value), number)


def turn_of(number: Number) -> tuple[Number, Number]:
    """(cos, sin) of a number: both have slopes of at most 1, so that the radius carries over."""
    if number == 0:
        return Fraction(1), Fraction(0)
    low, high = ends(number)
    if max(abs(low), abs(high)) > LARGEST_ANGLE:
        return Enclosure(Fraction(-1), Fraction(1)), Enclosure(Fraction(-1), Fraction(1))
    middle, radius = (low + high) / 2, (high - low) / 2
    cos, sin = (_enclosed(name, middle) for name in ("cos", "sin"))
    return _wider(cos, radius), _wider(sin, radius)


def _wider(number: Enclosure, radius: Fraction) -> Enclosure:
    return outward(number.lower - radius, number.upper + radius)


def exp(number: Number) -> Number:
    """The exponential function. Raises Outside where it is too large or too small to be enclosed."""
    if max(map(abs, ends(number))) > MOST_EXPONENT:
        raise Outside("an exponential that is too large or too small to be enclosed")
    return Fraction(1) if number == 0 else monotone(lambda value: _enclosed("exp", value), number)


def ln(number: Number) -> Number:
    """The natural logarithm. Raises Outside if the number may be ≤ 0."""
    if ends(number)[0] <= 0:
        raise Outside("logarithm of a number that is not positive")
    return Fraction(0) if number == 1 else monotone(lambda value: _enclosed("log", value), number)
