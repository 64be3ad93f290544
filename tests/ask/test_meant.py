"""Words whose meaning must not be guessed: distances are no components, an angle is that of the body, “within” is a bound, heat
is what rubs; what comes back has been where it turned round, and asks what that asks for. Answers worked out by hand first."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from tests.ask.test_unseen import asked
from tests.ask.test_unseen import test_it_finds_what_is_worked_out_by_hand as found

WEIGHTS, RISE = "(2*m_1 + 2*m_2 + M)", "v_0**2*(2*m_1 + 2*m_2 + M)/(4*g*(m_1 - m_2))"
ANSWERS = (
    ("started-against-weights", "angle through which the pulley turns until it stops", f"-{RISE}/R"),
    ("started-against-weights", "number of turns of pulley until it stops", f"{RISE}/(2*pi*R)"),
    ("started-against-weights", "time until it comes back", f"v_0*{WEIGHTS}/(g*(m_1 - m_2))"),
    ("started-against-weights", "speed of left when it comes back", "v_0"),
    ("block-drawn-back", "stopping distance", "2*(a - mu*m*g/k)"),
    ("block-drawn-back", "stopping distance of x", "2*(a - mu*m*g/k)"),
    ("block-drawn-back", "total way of x", "2*(a - mu*m*g/k)"),
    ("block-drawn-back", "heat produced until it stops", "2*mu*m*g*(a - mu*m*g/k)"),
    ("block-drawn-back", "a for which it stops within D", "mu*m*g/k + D/2"),
    ("wheel-spun-forward", "least speed of phi", "(R*w_0 + v_0)/(2*R)"),
    ("wheel-spun-forward", "largest speed of phi", "w_0"),
    ("puck-on-dome", "speed with which it leaves", "sqrt((2*g*R + v_0**2)/3)"),  # N's point: it was 0, the rate of a force
)


@pytest.mark.parametrize(("name", "question", "worked_out"), ANSWERS, ids=lambda value: str(value)[:60])
def test_it_finds_what_is_worked_out_by_hand(name: str, question: str, worked_out: str) -> None:
    found(name, question, worked_out)


@pytest.mark.parametrize("question", ["time until it comes back", "speed of y where y = -h/2", "energy lost until y = 0"])
def test_what_comes_back_holds_where_it_could_turn_round(question: str) -> None:
    """Before it does the string must not run out."""
    one = asked("started-against-weights")
    [condition] = answered(one, question).valid
    [(value, _, _)] = t.relations(condition)
    wanted = scalar(read_infix(f"4*g*h*(m_1 - m_2) - v_0**2*{WEIGHTS}", one.world(0).names))
    assert scalars_equal(scalar(value), wanted, one.first.assumptions).is_proved


def test_within_is_a_bound() -> None:
    assert answered(asked("block-drawn-back"), "a for which it stops within D").relation == "<="


def test_what_is_driven_has_no_heat_but_that_of_what_rubs() -> None:
    with pytest.raises(StatementError, match="does work too"):
        answered(asked("block-on-pulled-block"), "heat produced until x = 1 m")


def test_the_greatest_of_all_phases_asks_for_what_its_phase_asks_for() -> None:
    """Two constant tensions, of which the larger one needs that the block comes back."""
    one = asked("block-drawn-to-and-fro")
    assert {*answered(one, "T in phase back").valid} == {*answered(one, "largest T").valid} != set()


def test_what_rests_in_the_first_phase_has_its_swing_in_the_next() -> None:
    """A plate on a spring, on which clay falls: nothing is told of it as it rests, and the clay does not come back at once."""
    one = asked("clay-onto-plate")
    assert answered(one, "amplitude of y").values == answered(one, "amplitude of y in phase stuck").values
    assert not answered(one, "largest speed of y").verdict.is_proved
    with pytest.raises(StatementError, match="comes back"):
        answered(one, "time until it comes back")


@pytest.mark.parametrize("question", ["largest b", "largest speed of b", "total angle of b"])
def test_what_slips_on_something_that_moves_goes_on_where_it_comes_to_rest(question: str) -> None:
    """The slower shaft is turned round, and may come to turn faster than at first."""
    with pytest.raises(StatementError):
        answered(asked("clutch-against"), question)
