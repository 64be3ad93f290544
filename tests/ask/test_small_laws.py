"""Small parts of questions and answers, each by what it states: ways, limits, conditions that always hold, vectors."""

from __future__ import annotations

import pytest

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import symbol
from rbpsym.ask.asking import answered
from rbpsym.ask.limits import leading
from rbpsym.ask.seen import scene, way_to
from rbpsym.ask.special import _term
from rbpsym.ask.telling import latex_of
from rbpsym.ask.wanted import Wanted
from rbpsym.ask.yesno import _always
from rbpsym.equality.assumptions import Assumptions
from rbpsym.errors import StatementError
from rbpsym.mechanics.numbers import number
from rbpsym.notation.infix import read_infix
from tests.ask.test_answers import asked

NEAR = 1e-6


LIMITS = {
    "(3*x + 1)/(x**2 + x)": [("0", 1), ("0", -1), (None, 1)],
    "x**3 - x": [("1", 1), ("1", -1), (None, 1), (None, -1)],
    "sqrt(x + x**2)": [("0", 1), (None, 1)],
    "1/sqrt(x - 1)": [("1", 1), (None, 1)],
    "1/sqrt(1 - x)": [("1", -1), (None, -1)],
}


@pytest.mark.parametrize("text", LIMITS)
def test_near_a_limit_a_quantity_is_its_leading_term(text):
    value = scalar(read_infix(text, {"x"}))
    for to, side in LIMITS[text]:
        place = None if to is None else scalar(read_infix(to, ()))
        there = {"x": side / NEAR if to is None else float(to) + side * NEAR}
        term = _term(leading(value, "x", place, side), "x", place, side)
        assert number(term, there) == pytest.approx(number(value, there), rel=0.01), (to, side)


def test_a_coordinate_does_not_come_to_where_it_starts_but_to_the_other_side():
    world, begin = scene(asked("rod-pendulum")), symbol("theta_0")
    with pytest.raises(StatementError, match="starts there"):
        way_to(world, "theta", begin, world.motion.assumptions)
    way, _ = way_to(world, "theta", -begin, world.motion.assumptions)
    assert way.sense < 0


@pytest.mark.parametrize(("sign", "closed"), [("positive", True), ("positive", False), ("nonnegative", True)])
def test_what_holds_for_the_sign_of_a_quantity_always_holds(sign, closed):
    assert _always(Wanted((symbol("x"),), Assumptions({"x": sign}), closed=closed))


@pytest.mark.parametrize(("sign", "closed"), [("nonnegative", False), ("real", True)])
def test_what_may_vanish_is_not_always_positive(sign, closed):
    assert not _always(Wanted((symbol("x"),), Assumptions({"x": sign}), closed=closed))


@pytest.mark.parametrize(("quantity", "parts"), [("velocity of stick.cm", 2), ("N", 1)])
def test_a_vector_stands_in_brackets(quantity, parts):
    found = answered(asked("falling-stick"), quantity)
    assert len(found.nodes) == parts and latex_of(found).startswith(r"\left(") is (parts > 1)
