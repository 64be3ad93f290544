"""Bounds of waves and inverse functions hold what they bound, and are as narrow as they are said to be."""

import math
from fractions import Fraction

import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.bounds import FULL_WAVE, Bounds, of_cosine, of_inverse, of_wave
from rbpsym.decide.factoring import MINUS, PLUS, split
from rbpsym.field.poly import generator
from rbpsym.field.scalar import NOTHING, PI, lift, symbol
from rbpsym.field.trig import cosine
from rbpsym.mechanics.numbers import number

TWELFTH = PI * Fraction(1, 12)
ENDS = range(-36, 37)  # twelfths of π


def is_nonnegative(value) -> bool:
    return number(value, {}) >= -1e-12


def ends_of(found) -> tuple[float, float]:
    return number(found.lower, {}), number(found.upper, {})


@pytest.mark.parametrize("width", [1, 5, 6, 7, 11, 12, 13, 30])
def test_a_cosine_lies_within_its_bounds(width):
    for low in ENDS:
        found = of_cosine(Bounds(TWELFTH * low, TWELFTH * (low + width)), is_nonnegative)
        lower, upper = ends_of(found)
        seen = [math.cos(math.pi / 12 * (low + width * k / 60)) for k in range(1, 60)]
        assert lower - 1e-12 <= min(seen) and max(seen) <= upper + 1e-12
        if any(abs(value - upper) < 1e-12 for value in seen):
            assert found.upper_in
        if any(abs(value - lower) < 1e-12 for value in seen):
            assert found.lower_in


@pytest.mark.parametrize("half", range(-3, 4))
def test_on_a_half_turn_the_bounds_are_the_values_at_the_ends(half):
    for low, high in ((0, 12), (0, 4), (3, 9), (7, 12)):
        ends = TWELFTH * (12 * half + low), TWELFTH * (12 * half + high)
        found = of_cosine(Bounds(*ends), is_nonnegative)
        assert ends_of(found) == pytest.approx(sorted(number(cosine(end), {}) for end in ends), abs=1e-12)


@pytest.mark.parametrize("turn", range(-2, 3))
def test_about_a_greatest_or_least_value_a_cosine_has_one_sign(turn):
    for low, high in ((-6, 6), (-1, 2)):
        found = of_cosine(Bounds(TWELFTH * (12 * turn + low), TWELFTH * (12 * turn + high)), is_nonnegative)
        assert ends_of(found) == ((-1, 0) if turn % 2 else (0, 1))
    assert of_cosine(Bounds(TWELFTH * (12 * turn - 7), TWELFTH * (12 * turn + 18)), is_nonnegative) == FULL_WAVE


@pytest.mark.parametrize("turn", range(-2, 3))
def test_within_a_turn_a_cosine_comes_to_the_opposite_value_at_the_ends_alone(turn):
    """1 + cos q > 0 between -π and π, and 1 + cos q ≥ 0 if these belong to it."""
    for closed in (False, True):
        ends = TWELFTH * (12 * turn - 12), TWELFTH * (12 * turn + 12)
        found = of_cosine(Bounds(*ends, closed, closed), is_nonnegative)
        assert ends_of(found) == (-1, 1)
        assert (found.lower_in, found.upper_in) == ((True, closed) if turn % 2 else (closed, True))


INVERSES = {"asin": (math.asin, (-1, 1)), "acos": (math.acos, (-1, 1)), "atan": (math.atan, (-1e9, 1e9))}


@pytest.mark.parametrize("kind", INVERSES)
@pytest.mark.parametrize("sign", [PLUS, MINUS, PLUS | MINUS])
def test_an_inverse_function_takes_all_values_within_its_bounds(kind, sign):
    function, (low, high) = INVERSES[kind]
    seen = function(low if sign & MINUS else 0), function(high if sign & PLUS else 0)
    found = of_inverse(kind, sign)
    assert ends_of(found) == pytest.approx((min(seen), max(seen)), abs=1e-8)
    assert found.lower_in is (kind != "atan" or min(seen) == 0) and found.upper_in is (kind != "atan" or max(seen) == 0)


X, Y = generator(1_000_001), generator(1_000_002)
ONE = lift(1).num


FACTORED = [((X * X - Y * Y), 2), ((Y - X) * (X + ONE), 2), (-((X + Y) ** 3), 3), ((X + ONE).scaled(-6), 1)]


@pytest.mark.parametrize("deep", [False, True])
@pytest.mark.parametrize(("whole", "count"), FACTORED)
def test_factors_multiply_to_the_polynomial_and_lead_with_plus(whole, count, deep):
    coefficient, parts = split(whole, deep)
    product = ONE.scaled(coefficient)
    for factor, k in parts:
        product = product * factor**k
        assert factor.terms[min(factor.terms)] > 0
    assert product == whole
    assert sum(k for _, k in parts) == (count if deep else 1)


def test_a_range_narrows_the_cosine_of_its_own_angle_alone():
    """cos θ ≥ cos E from -E to E; of a sum with θ in it that says nothing."""
    top, theta = symbol("E"), symbol("theta")
    given = Assumptions({"E": "positive"}, {"E": (NOTHING, PI), "theta": (-top, top)})
    assert of_wave("cos", theta.num, given, lambda value: True).lower == cosine(top)
    for angle in (theta + symbol("phi"), symbol("phi") + theta, theta * 2, theta + 1):
        assert of_wave("cos", angle.num, given, lambda value: False) == FULL_WAVE
