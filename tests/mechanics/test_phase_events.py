"""Phases that begin when a speed vanishes or a time is reached: their state, and what is refused."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import ask
from rbpsym.errors import NotApplicable, RbpsymError
from rbpsym.mechanics.phases import stages
from rbpsym.statement.loader import load_text
from rbpsym.statement.model import Problem


def thrown(phase: str, gravity: str = "-1") -> Problem:
    """A ball thrown up, or down."""
    return load_text(thrown_text(phase, gravity))


def thrown_text(phase: str, gravity: str) -> str:
    """The file of it."""
    return f"""
[parameters]
m = "mass: m"
g = "acceleration: g"
v_0 = "speed: v"
T = "time: T"
[coordinates.y]
dimension = "length"
start = "0"
speed = "v_0"
[bodies.ball]
shape = "particle"
mass = "m"
center = ["0", "y"]
[interactions.W]
type = "gravity"
direction = ["0", "{gravity}"]
[constraints.N]
type = "guide"
point = "ball.center"
line = "x = 0"
[[phases]]
name = "next"
{phase}
"""


ASKED = [
    ("event = 'rests'\nof = 'y'", "y when next begins", "v_0**2/(2*g)"),
    ("event = 'rests'\nof = 'y'", "time until next", "v_0/g"),
    ("event = 'rests'\nof = 'y'", "speed of y when next begins", "0"),
    ("event = 'time'\nat = 'T'", "speed of y when next begins", "v_0 - g*T"),
    ("event = 'time'\nat = 'T'", "time until next", "T"),
]


@pytest.mark.parametrize(("phase", "question", "expected"), ASKED)
def test_how_a_phase_begins(phase: str, question: str, expected: str) -> None:
    from rbpsym.expr.infix import read_infix
    from rbpsym.field.evaluate import scalar
    from rbpsym.field.normal import is_zero

    [found] = ask(thrown(phase), question)
    assert is_zero(found.value - scalar(read_infix(expected, ("v_0", "g", "T")))), found.text
    assert found.verdict.is_proved


WRONG = [
    ("event = 'rests'", "has no “of”|of"),
    ("event = 'rests'\nof = 'x'", "there is no coordinate “x”"),
    ("event = 'rests'\nof = 'y'\nat = '0'", "asks for no “at”"),
    ("event = 'time'", "at"),
    ("event = 'time'\nat = 'v_0'", "must be a time"),
    ("event = 'time'\nat = '-T'", "positive|negative"),
    ("event = 'time'\nat = 'T'\nof = 'y'", "asks for no “of”"),
]


@pytest.mark.parametrize(("phase", "told"), WRONG)
def test_wrong_events_get_a_sentence(phase: str, told: str) -> None:
    with pytest.raises(RbpsymError, match=told):
        thrown(phase)


def test_what_never_rests_is_said() -> None:
    with pytest.raises(RbpsymError, match="never reached"):
        stages(thrown("event = 'rests'\nof = 'y'", gravity="1"))


def test_where_a_phase_has_begun_it_may_come_back_to() -> None:
    """A spring brings the ball back to where it has met it: that was said never to happen."""
    spring = 'k = "stiffness: k"\nL = "length: L"\n[coordinates.y]'
    met = 'event = "reaches"\nof = "y"\nat = "L"\n'
    cord = '[phases.interactions.S]\ntype = "spring"\nbetween = ["O", "ball.center"]\nstiffness = "k"\nnatural_length = "L"\n'
    text = thrown_text(met + cord + '[[phases]]\nname = "slack"\n' + met + 'without = ["S"]', "1")
    with pytest.raises(NotApplicable, match="comes back to where it is first"):
        stages(load_text(text.replace("[coordinates.y]", spring)))
