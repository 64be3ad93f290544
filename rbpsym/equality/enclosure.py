"""Rigorous enclosures of real numbers by pairs of fractions.

A number is a `Fraction` where it is exact, else an `Enclosure`. Every function rounds
outwards, so that disjoint enclosures prove that two numbers differ.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from math import isqrt

from rbpsym.frozen import dataclass

BITS = 256
_ONE = 1 << BITS
MOST_EXPONENT = 4000
MEANS = 12  # of two numbers, whose distance is squared each time


class Outside(ArithmeticError):
    """A value that does not exist, or that cannot be enclosed (division by an interval with 0)."""


@dataclass(frozen=True, slots=True)
class Enclosure:
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


def around(middle: Fraction, radius: Fraction) -> Enclosure:
    """All numbers within `radius` of `middle`."""
    return outward(middle - radius, middle + radius)


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
        raise Outside("division by zero")
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


def _short(value: Fraction) -> tuple[Fraction, Fraction]:
    """A fraction of BITS binary places near the value, and the distance at most."""
    if value.denominator <= _ONE:
        return value, Fraction(0)
    return Fraction(value.numerator * _ONE // value.denominator, _ONE), Fraction(1, _ONE)


def _fixed(value: Fraction) -> int:
    """A fraction in units of 2^-BITS, rounded down."""
    return (value.numerator << BITS) // value.denominator


def _series(first: int, following: Callable[[int, int], int], tail: int) -> Enclosure:
    """Σ terms in units of 2^-BITS, each made of the last one; the rest is at most `tail` × |last term|."""
    total, term, k = 0, first, 0
    while abs(term) > 1:
        total, k = total + term, k + 1
        term = following(term, k)
    return around(Fraction(total, _ONE), Fraction((4 * k + 4) * tail, _ONE))


@lru_cache(maxsize=1)
def pi() -> Number:
    """π by Machin's formula."""
    return 16 * _small_atan(Fraction(1, 5)) - 4 * _small_atan(Fraction(1, 239))


def _small_atan(x: Fraction) -> Number:
    """atan for |x| < 1/2, by its alternating series."""
    if x == 0:
        return Fraction(0)
    return _odd_powers(x, -1)


def _odd_powers(x: Fraction, sign: int) -> Enclosure:
    """Σ signᵏ x^(2k+1)/(2k+1) for |x| < 1/2: the inverse tangent, or the hyperbolic one."""
    power, total, k = _fixed(x), 0, 0
    square = (power * power >> BITS) * sign
    while abs(power) > 1:
        total += power // (2 * k + 1)
        power, k = power * square >> BITS, k + 1
    return around(Fraction(total, _ONE), Fraction(8 * k + 8, _ONE))


def atan(number: Number) -> Number:
    """The inverse tangent."""
    return monotone(_atan, number)


@lru_cache(maxsize=4096)
def _atan(x: Fraction) -> Number:
    """Halved twice by atan x = 2 atan(x / (1 + √(1 + x²)))."""
    half: Number = x
    for _ in range(2):
        half = half * reciprocal(1 + root(1 + half * half))
    return 4 * monotone(_small_atan, half)


def asin(number: Number) -> Number:
    """The inverse sine. Raises Outside beyond [-1, 1]."""
    if number == 0:
        return Fraction(0)
    if number in (1, -1):
        return pi() * Fraction(number) * Fraction(1, 2)
    return atan(number * reciprocal(root(1 - number * number)))


def acos(number: Number) -> Number:
    """The inverse cosine."""
    return Fraction(0) if number == 1 else pi() * Fraction(1, 2) - asin(number)


def elliptic_k(number: Number) -> Number:
    """K(m) = π/(2 agm(1, √(1 - m))), where the mean lies between both sequences. Raises Outside for m ≥ 1."""
    return monotone(_elliptic_k, number)


@lru_cache(maxsize=4096)
def _elliptic_k(m: Fraction) -> Number:
    a: Number = Fraction(1)
    b = root(1 - m)
    for _ in range(MEANS):
        a, b = (a + b) * Fraction(1, 2), root(a * b)
    least, most = reciprocal(a), reciprocal(b)
    return pi() * Fraction(1, 2) * outward(min(ends(least)[0], ends(most)[0]), max(ends(least)[1], ends(most)[1]))


def turn_of(number: Number) -> tuple[Number, Number]:
    """(cos, sin) of a number."""
    if number == 0:
        return Fraction(1), Fraction(0)
    low, high = ends(number)
    middle, shift = _short((low + high) / 2)
    radius = shift + (high - low) / 2
    if abs(middle) > 4:
        turns = round(middle / Fraction(710, 113))
        return turn_of(number - 2 * turns * pi()) if turns else _wave(middle, radius)
    return _wave(middle, radius)


def _wave(x: Fraction, radius: Fraction) -> tuple[Number, Number]:
    """Both functions have slopes of at most 1, so the radius carries over."""
    unit = _fixed(x)
    square = unit * unit >> BITS
    growth = 256  # more than exp(|x|) for |x| ≤ 5: how rounding errors may grow
    cosine = _series(_ONE, lambda term, k: -term * square // ((2 * k - 1) * (2 * k) << BITS), growth)
    sine = _series(unit, lambda term, k: -term * square // ((2 * k) * (2 * k + 1) << BITS), growth)
    return _wider(cosine, radius), _wider(sine, radius)


def _wider(number: Enclosure, radius: Fraction) -> Enclosure:
    return outward(number.lower - radius, number.upper + radius)


def exp(number: Number) -> Number:
    """The exponential function."""
    return Fraction(1) if number == 0 else monotone(_exp, number)


def _exp(x: Fraction) -> Number:
    if abs(x) > MOST_EXPONENT:
        raise Outside("an exponential that is too large or too small to be enclosed")
    halvings = max(0, int(abs(x)).bit_length())
    small = _fixed(x / (1 << halvings))
    result: Number = _wider(_series(_ONE, lambda term, k: term * small // (k << BITS), 8), Fraction(4, _ONE))
    for _ in range(halvings):
        result = result * result
    return result


def ln(number: Number) -> Number:
    """The natural logarithm. Raises Outside if the number may be ≤ 0."""
    if ends(number)[0] <= 0:
        raise Outside("logarithm of a number that is not positive")
    return monotone(_ln, number)


def _ln(x: Fraction) -> Number:
    if x == 1:
        return Fraction(0)
    twos = x.numerator.bit_length() - x.denominator.bit_length()
    rest = x / Fraction(2) ** twos
    if rest > Fraction(4, 3):
        twos, rest = twos + 1, rest / 2
    return 2 * _odd_powers((rest - 1) / (rest + 1), 1) + twos * _ln_of_two()


@lru_cache(maxsize=1)
def _ln_of_two() -> Number:
    return 2 * _odd_powers(Fraction(1, 3), 1)
