"""Enclosures hold the true value and are narrow; the separation bound proves only zeros."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import pytest

from rbpsym.equality import enclosure as e

TINY = Fraction(1, 10**30)
FUNCTIONS = {
    "cos": (lambda x: e.turn_of(x)[0], mpmath.cos),
    "sin": (lambda x: e.turn_of(x)[1], mpmath.sin),
    "atan": (e.atan, mpmath.atan),
    "exp": (e.exp, mpmath.exp),
    "ln": (lambda x: e.ln(abs(x) + TINY), lambda x: mpmath.log(abs(x) + mpmath.mpf(10) ** -30)),
    "root": (lambda x: e.root(abs(x)), lambda x: mpmath.sqrt(abs(x))),
    "asin": (lambda x: e.asin(x / (1 + abs(x))), lambda x: mpmath.asin(x / (1 + abs(x)))),
    "acos": (lambda x: e.acos(x / (1 + abs(x))), lambda x: mpmath.acos(x / (1 + abs(x)))),
}


def real(x: Fraction) -> mpmath.mpf:
    """A fraction in many digits."""
    return mpmath.mpf(x.numerator) / x.denominator


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_true_value_is_inside(name: str) -> None:
    ours, theirs = FUNCTIONS[name]
    source = random.Random(name)
    with mpmath.workprec(400):
        for _ in range(60):
            x = Fraction(source.randint(-300, 300), source.randint(1, 40))
            low, high = e.ends(ours(x))
            assert real(low) <= theirs(real(x)) <= real(high)
            assert high - low <= TINY * (1 + abs(high))


def test_wide_arguments_give_wide_values() -> None:
    wide = e.Enclosure(Fraction(1), Fraction(2))
    low, high = e.ends(e.turn_of(wide)[0])
    assert low <= Fraction(-41, 100) and high >= Fraction(54, 100)
    assert e.sign_of(wide - wide) is None
    assert not e.are_disjoint(wide, Fraction(3, 2))
    assert e.are_disjoint(wide, Fraction(5, 2))


def test_squares_have_exact_roots() -> None:
    assert e.root(Fraction(9, 4)) == Fraction(3, 2)
    assert isinstance(e.root(Fraction(2)), e.Enclosure)


@pytest.mark.parametrize("number", [Fraction(0), e.Enclosure(Fraction(-1), Fraction(1))])
def test_no_division_by_what_may_be_zero(number: e.Number) -> None:
    with pytest.raises(e.Outside):
        e.reciprocal(number)
