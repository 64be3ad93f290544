"""A second road to answers that no rule checks: by numbers at seeded sets, and by the problem with the values put in."""

from __future__ import annotations

from itertools import islice

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.seen import scene
from rbpsym.ask.special import special_problem
from rbpsym.decide.equal import scalars_equal
from rbpsym.mechanics.numbers import number, samples
from tests.ask.test_answers import asked
from tests.ask.test_unseen import ANSWERS
from tests.ask.test_unseen import asked as unseen

SETS, NEAR = 20, 1e-9
DEPENDS = (
    ("rod-pendulum", "period of theta"),
    ("disk-on-incline", "acceleration of s"),
    ("disk-on-incline", "friction coefficient needed at N"),
    ("ball-slipping-to-rolling", "speed of x when rolling begins"),
    ("ball-slipping-to-rolling", "time until rolling"),
    ("yo-yo", "tension T"),
    ("sliding-ladder", "theta where N_w vanishes"),
    ("center-of-percussion", "impulse of F_x when struck begins"),
)


@pytest.mark.parametrize(("name", "quantity"), DEPENDS)
def test_what_depends_on_a_parameter_changes_with_it(name: str, quantity: str) -> None:
    value, problem = answered(asked(name), quantity).value, asked(name).problem
    for parameter in (one.name for one in problem.parameters):
        said = answered(asked(name), f"does {quantity} depend on {parameter}")
        changes = [
            abs(number(value, one) - number(value, one | {parameter: one[parameter] * 1.01})) > NEAR * abs(number(value, one))
            for one in islice(samples(problem), SETS)
        ]
        assert said.verdict.is_proved and said.holds_so is any(changes), parameter


SPECIAL = (
    ("atwood-with-massive-pulley", "acceleration of x", "M_p = M_1"),
    ("rod-pendulum", "F_y where theta = 0", "theta_0 = pi/2"),
    ("ball-slipping-to-rolling", "time until rolling", "mu = 1/2"),
    ("center-of-percussion", "impulse of F_x when struck begins", "b = ell/2"),
    ("yo-yo", "tension T", "R = 2*b"),
    ("disk-on-incline", "acceleration of s", "beta = pi/6"),
)


@pytest.mark.parametrize(("name", "quantity", "values"), SPECIAL)
def test_a_special_value_is_that_of_the_special_problem(name: str, quantity: str, values: str) -> None:
    found = answered(asked(name), f"{quantity} with {values}")
    other = answered(Asked(special_problem(scene(asked(name)), values)), quantity)
    assert found.verdict.is_proved and other.verdict.is_proved
    assert scalars_equal(found.value, other.value, other.study.assumptions).is_proved


UNFOLLOWED = {"winding-string"}  # nothing is wound up at its start: the simulation lets the string pass the post


@pytest.mark.heavy(of=6)
@pytest.mark.parametrize("name", dict.fromkeys(name for name, _, _ in ANSWERS if name not in UNFOLLOWED))
def test_what_is_told_is_what_the_simulation_shows(name: str) -> None:
    from tests.ask.simulated import compared

    found = compared(unseen(name), 1)
    assert not found.wrong and found.compared


YES_OR_NO = (
    ("ball-in-a-loop", "does theta reach pi"),
    ("cylinder-off-cylinder", "does N vanish before theta = pi/4"),
    ("disk-on-incline", "does it slip"),
    ("inverted-pendulum-on-torsion-spring", "is theta = 0 stable"),
)


@pytest.mark.parametrize(("name", "question"), YES_OR_NO)
def test_a_condition_is_never_beside_a_plain_yes_or_no(name: str, question: str) -> None:
    found = answered(asked(name), question)
    assert found.verdict.is_proved and (found.holds_so is None) is bool(found.valid)
