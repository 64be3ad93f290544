"""Limits and greatest values, as their checkers see them: what is so is proved, and nothing else."""

from fractions import Fraction

import pytest

from rbpsym.algebra.calculus import root
from rbpsym.algebra.scalar import UNITY, lift, symbol
from rbpsym.algebra.trig import cosine, sine
from rbpsym.derivation.checks_parameters import _goes_to, slope_said
from rbpsym.equality.assumptions import Assumptions

x, a, small = symbol("x"), symbol("a"), symbol("epsilon")
GIVEN = Assumptions({"a": "positive", "epsilon": "positive"}, {"x": (lift(0), 2 * a)})
LIMITS = {
    "sine": (sine(small * a), 1, a),
    "cosine": (UNITY - cosine(small), 2, UNITY / 2),
    "pole": (a / small + 1, -1, a),
    "pole of a square": ((a + small) / small**2, -2, a),
    "quotient": (sine(small) / (small + small**2), 0, UNITY),
    "root": (root(a * a + small) - a, 1, 1 / (2 * a)),
}


@pytest.mark.parametrize("name", LIMITS)
def test_a_limit_is_that_of_its_order(name):
    value, order, end = LIMITS[name]
    assert _goes_to(value, "epsilon", order, end, GIVEN).is_proved
    for wrong in (end * 2, -end, end + 1):
        assert not _goes_to(value, "epsilon", order, wrong, GIVEN).is_proved
    assert not _goes_to(value, "epsilon", order + 1, end, GIVEN).is_proved


@pytest.mark.parametrize("sense", [1, -1])
def test_a_value_is_greatest_where_its_slope_changes_its_sign_and_nowhere_else(sense):
    value = x * (2 * a - x) * sense
    assert slope_said(value, "x", a, GIVEN, sense).is_proved
    assert not slope_said(value, "x", a, GIVEN, -sense).is_proved
    for wrong in (a / 2, a * Fraction(3, 2), 2 * a):
        assert not slope_said(value, "x", wrong, GIVEN, sense).is_proved
