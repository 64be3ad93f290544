"""Enclosures hold the true value and are narrow; the separation bound proves only zeros."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import pytest

from rbpsym.decide import enclosure as e
from rbpsym.field import flint_ring, sympy_bridge

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


@pytest.mark.parametrize("power", range(-3, 6))
def test_a_power_holds_all_powers_and_an_even_one_nothing_negative(power) -> None:
    for low, high in ((-2, -1), (-1, 2), (1, 3)) if power >= 0 else ((-2, -1), (1, 3)):
        found = e.ends(e.Enclosure(Fraction(low), Fraction(high)) ** power)
        for k in range(13):
            assert found[0] <= (low + Fraction((high - low) * k, 12)) ** power <= found[1]
        assert power % 2 or found[0] >= 0
        assert max(map(abs, found)) <= max(abs(Fraction(low)), abs(Fraction(high))) ** abs(power)


def test_squares_have_exact_roots() -> None:
    assert e.root(Fraction(9, 4)) == Fraction(3, 2)
    assert isinstance(e.root(Fraction(2)), e.Enclosure)


def test_what_may_not_be_positive_has_no_logarithm() -> None:
    for number in (Fraction(0), Fraction(-1), e.Enclosure(Fraction(0), Fraction(1))):
        with pytest.raises(e.Outside):
            e.ln(number)
    low, high = e.ends(e.ln(e.Enclosure(Fraction(1, 3), Fraction(1, 2))))
    assert low <= Fraction(-109, 100) and high >= Fraction(-70, 100) and high < 0


@pytest.mark.parametrize("number", [Fraction(0), e.Enclosure(Fraction(-1), Fraction(1))])
def test_no_division_by_what_may_be_zero(number: e.Number) -> None:
    with pytest.raises(e.Outside):
        e.reciprocal(number)


@pytest.mark.parametrize("name", ["atan", "cos", "sin", "exp", "log", "elliptic_k"])
def test_both_backends_enclose_the_same_number(name: str) -> None:
    pytest.importorskip("flint")
    source = random.Random(name)
    for _ in range(25):
        x = Fraction(source.randint(-10**6, 10**6), source.randint(1, 10 ** source.randint(1, 30)))
        x = abs(x) + TINY if name == "log" else min(x, 1 - 1 / (2 + x * x)) if name == "elliptic_k" else x % 3000
        (a, near), (b, close) = (backend.enclosed(name, x, e.BITS) for backend in (flint_ring, sympy_bridge))
        assert abs(a - b) <= near + close
        assert max(near, close) <= (1 + abs(a)) / 2**200
