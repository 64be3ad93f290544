"""What an answer supposes stands beside it: what the phases before ask for, and nothing that is sure anyhow."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.errors import NotApplicable
from rbpsym.typeset.machine import to_machine
from tests.ask.test_unseen import asked

BOWL, FLOOR, TABLE = ("7*mu*cos(theta_0) - 2*sin(theta_0) >= 0",), ("b - h >= 0",), ("1 - mu >= 0",)
TOLD = (
    ("ball-out-of-bowl", "angular velocity of ball when freed begins", BOWL),
    ("ball-out-of-bowl", "largest theta in phase freed", BOWL),
    ("ball-out-of-bowl", "energy lost until freed", BOWL),
    ("block-drawn-until-floor", "impulse of G when landed begins", FLOOR),
    ("block-drawn-until-floor", "mu for which x where x comes to rest = 2*h", FLOOR),
    ("block-on-shaken-table", "largest A for which it does not slip", TABLE),
    ("sprung-gable", "B at the start", ()),
    ("sprung-gable", "C_x at the start", ()),
    ("rod-strikes-puck", "energy lost when struck begins", ()),
    ("rod-strikes-puck", "impulse of J when struck begins", ()),
    ("ring-and-spring", "does theta reach 0",
     ("k*R*(sqrt(2) - 2) + 2*m*g > 0", "k*R*(1 - sqrt(2)) + m*g > 0")),
)  # fmt: skip


@pytest.mark.parametrize(("name", "question", "supposed"), TOLD, ids=lambda value: str(value)[:40])
def test_what_an_answer_supposes_is_told(name: str, question: str, supposed: tuple[str, ...]) -> None:
    found = answered(asked(name), question)
    assert found.verdict.is_proved and len(found.values) <= 2 and not found.each
    assert tuple(map(to_machine, found.valid)) == supposed


def test_a_blow_that_is_not_named_is_not_that_before_an_unknown_phase() -> None:
    with pytest.raises(NotApplicable, match="the phase before “lying”"):
        answered(asked("rod-strikes-puck"), "energy lost")
