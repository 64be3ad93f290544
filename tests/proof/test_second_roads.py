"""Limits, zeros and greatest values, as their checkers see them: what is so is proved, and nothing else."""

from fractions import Fraction

import pytest

from rbpsym.ask.finding import ground
from rbpsym.decide.assumptions import Assumptions
from rbpsym.field.calculus import root
from rbpsym.field.scalar import NOTHING, PI, UNITY, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.proof.checks.parameters import _goes_to, nowhere_else, slope_said, vanishes_there
from rbpsym.proof.rules import RULES

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


@pytest.mark.parametrize(
    ("value", "places"), [(x - a, ()), (x - symbol("b"), ()), (x - a, (a / 2,)), (x * x - a * a / 4, ()), (x * (x - a), (x,))]
)
def test_that_there_is_no_other_zero_is_not_seen_where_there_is_one(value, places):
    data = {"value": value, "name": "x", "places": places, "given": GIVEN}
    assert not vanishes_there(None, ground(("vanishes_for", data))).is_proved


@pytest.mark.parametrize(("value", "places"), [(x + a, ()), (x * x + a * x, ()), (x - 3 * a, ()), (x - a, (a,))])
def test_that_there_is_no_other_zero_is_seen_where_its_sign_is_known(value, places):
    data = {"value": value, "name": "x", "places": places, "given": GIVEN}
    assert vanishes_there(None, ground(("vanishes_for", data))).is_proved


SAID = {  # a rule, with data with which it passes, and with which it does not
    "greatest_of": ({"best": 2 * a, "others": ((a, GIVEN),), "sense": 1}, {"best": a, "others": ((2 * a, GIVEN),), "sense": 1}),
    "one_zero": ({"equation": x - a}, {"equation": x + a}),
    "changes": ({"value": a * x}, {"value": a * a}),
    "no_change": ({"value": a + x - x, "best": a}, {"value": a + x, "best": a}),
    "least_on_way": ({"holds": True}, {"holds": False}),
}


@pytest.mark.parametrize("rule", SAID)
def test_a_rule_of_answers_passes_what_is_so_and_nothing_else(rule):
    always = {"name": "x", "names": ("x",), "given": GIVEN, "value": None, "along": "x", "parts": ((x + a, None, a),)}
    for data, is_so in zip(SAID[rule], (True, False), strict=True):
        assert RULES[rule][0](None, ground((rule, {**always, **data}))).is_proved == is_so


def test_an_end_that_may_be_reached_is_a_place_too():
    """sin x vanishes at both ends of half a turn."""
    ends = {"x": (NOTHING, PI)}
    assert nowhere_else(sine(x), "x", [NOTHING], Assumptions({}, ends)).is_proved
    assert not nowhere_else(sine(x), "x", [NOTHING], Assumptions({}, ends, frozenset({("x", 0), ("x", 1)}))).is_proved
    assert nowhere_else(sine(x) - cosine(x), "x", [PI / 4], Assumptions({}, ends, frozenset({("x", 0), ("x", 1)}))).is_proved
