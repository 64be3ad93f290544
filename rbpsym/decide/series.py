"""Power series in one variable, as far as some order, with coefficients that are enclosed by fractions.

A series is a tuple of coefficients; every function rounds outwards as `enclosure` does. Two series of which one coefficient
surely differs belong to different functions. Of two that are known to different orders the result is known to the lower one.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rbpsym.decide import enclosure as e
from rbpsym.decide.enclosure import Number, Outside

Series = tuple[Number, ...]
ZERO = Fraction(0)


def constant(value: Number, length: int) -> Series:
    """The same value always."""
    return (value, *(ZERO,) * (length - 1))


def added(a: Series, b: Series) -> Series:
    """a + b."""
    return tuple(x + y for x, y in zip(a, b, strict=False))


def scaled(a: Series, by: Number) -> Series:
    """a times a number."""
    return tuple(x * by for x in a)


def product(a: Series, b: Series) -> Series:
    """a b."""
    return tuple(_mixed(a, b, k, range(k + 1)) for k in range(min(len(a), len(b))))


def _mixed(a: Series, b: Series, k: int, places: range) -> Number:
    total: Number = ZERO
    for i in places:
        total = total + a[i] * b[k - i]
    return total


def reciprocal(a: Series) -> Series:
    """1 / a. Raises Outside if a may begin with zero."""
    first = e.reciprocal(a[0])
    found: Series = (first,)
    for k in range(1, len(a)):
        found = (*found, -(_mixed((ZERO, *a[1:]), (*found, ZERO), k, range(1, k + 1)) * first))
    return found


def power(a: Series, exponent: int) -> Series:
    """a to an integer power. Raises Outside for a negative one of what may begin with zero."""
    base, found = (a if exponent > 0 else reciprocal(a)), constant(Fraction(1), len(a))
    for _ in range(abs(exponent)):
        found = product(found, base)
    return found


def root(a: Series) -> Series:
    """√a, where the variable grows from 0. Raises Outside where it may begin with an odd power and is not zero at all."""
    if all(x == 0 for x in a):
        return a
    if len(a) > 2 and a[0] == a[1] == 0:  # √(t² b) = t √b
        return (ZERO, *root(a[2:]))
    found: Series = (e.root(a[0]),)
    half = e.reciprocal(2 * found[0])
    for k in range(1, len(a)):
        found = (*found, (a[k] - _mixed(found, found, k, range(1, k))) * half)
    return found


def exp(a: Series) -> Series:
    """eᵃ."""
    found: Series = (e.exp(a[0]),)
    for k in range(1, len(a)):
        found = (*found, _mixed(_slope(a), found, k, range(1, k + 1)) * Fraction(1, k))
    return found


def turn(first: tuple[Number, Number], a: Series) -> tuple[Series, Series]:
    """(cos a, sin a), of which the first coefficients are given."""
    cos: Series = first[:1]
    sin: Series = first[1:]
    slope = _slope(a)
    for k in range(1, len(a)):
        up, down = (_mixed(slope, one, k, range(1, k + 1)) * Fraction(1, k) for one in (cos, sin))
        cos, sin = (*cos, -down), (*sin, up)
    return cos, sin


def _slope(a: Series) -> Series:
    """k a_k at place k: the derivative times the variable."""
    return tuple(x * k for k, x in enumerate(a))


def _integrated(first: Number, a: Series, slope: Series) -> Series:
    """∫ slope da, which begins with `first`."""
    grown = product(_slope(a), slope)
    return (first, *(x * Fraction(1, k) for k, x in enumerate(grown) if k))


def _one_less(a: Series, sign: int) -> Series:
    """1 ± a²."""
    return added(constant(Fraction(1), len(a)), scaled(product(a, a), Fraction(sign)))


def _sign(a: Series) -> Series:
    found = e.sign_of(a[0])
    if not found:
        raise Outside("a sign that the enclosure does not tell")
    return constant(Fraction(found), len(a))


FUNCTIONS: dict[str, Callable[[Series], Series]] = {
    "root": root,
    "exp": exp,
    "ln": lambda a: _integrated(e.ln(a[0]), a, reciprocal(a)),
    "atan": lambda a: _integrated(e.atan(a[0]), a, reciprocal(_one_less(a, 1))),
    "asin": lambda a: _integrated(e.asin(a[0]), a, reciprocal(root(_one_less(a, -1)))),
    "acos": lambda a: _integrated(e.acos(a[0]), a, scaled(reciprocal(root(_one_less(a, -1))), Fraction(-1))),
    "sign": _sign,
}
