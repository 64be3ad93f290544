"""Questions that have no answer: each gets its sentence, and exit code 2."""

from __future__ import annotations

import pytest

from rbpsym.ask.asking import answered
from rbpsym.errors import RbpsymError
from tests.ask.test_answers import asked

WRONG = [
    ("rod-pendulum", "", "it is empty"),
    ("rod-pendulum", "x" * 500, "at most 400 characters"),
    ("rod-pendulum", "velocty of rod.end", "did you mean"),
    ("rod-pendulum", "foo", "means nothing"),
    ("rod-pendulum", "speed of foo", "unknown symbol"),
    ("rod-pendulum", "velocity of rodd.cm", "did you mean “rod”?"),
    ("rod-pendulum", "velocity of rod.tip", "has no point “tip”"),
    ("rod-pendulum", "tension T", "no force “T”"),
    ("rod-pendulum", "F_y where theta = 4", "does not come to this value"),
    ("rod-pendulum", "F_y where phi = 0", "“phi” is no coordinate"),
    ("rod-pendulum", "F_y where theta = M", "must be an angle"),
    ("rod-pendulum", "F_y where theta = foo", "unknown symbol"),
    ("rod-pendulum", "F_y when N vanishes", "there is no force “N”"),
    ("rod-pendulum", "F_y when rolling begins", "no phase or blow “rolling”"),
    ("rod-pendulum", "F_y right after the blow J", "no phase or blow “J”"),
    ("rod-pendulum", "time", "the time until when?"),
    ("rod-pendulum", "time until theta = 0", "no closed form was found for the time"),
    ("rod-pendulum", "F_y at the start as a function of theta", "is no function"),
    ("rod-pendulum", "F_y at the start where theta = 0", "twice"),
    ("rod-pendulum", "F_y as a function of t", "no closed form was found for “F_y” as a function of the time"),
    ("rod-pendulum", "F_y when F_y stops slipping", "there is no contact"),
    ("rod-pendulum", "component of mass of rod along rod", "is no vector"),
    ("rod-pendulum", "frequency of M", "no stable equilibrium"),
    ("rod-pendulum", "impulse of F when struck begins", "no phase “struck”"),
    ("rod-pendulum", "direction of mass of rod", "is no vector"),
    ("sliding-ladder", "N_w where theta = 2", "does not come to this value"),
    ("sliding-ladder", "F_y in equilibrium", "means nothing"),
    ("sliding-ladder", "N_w in equilibrium", "no stable equilibrium"),
    ("sliding-ladder", "period of theta", "no stable equilibrium"),
    ("center-of-percussion", "F_y at the end of phase struck", "nothing ends this phase"),
    ("ball-slipping-to-rolling", "time until roling", "did you mean “rolling”?"),
]


@pytest.mark.parametrize(("name", "question", "told"), WRONG, ids=lambda value: str(value)[:60])
def test_what_has_no_answer_gets_a_sentence(name: str, question: str, told: str) -> None:
    with pytest.raises(RbpsymError) as caught:
        answered(asked(name), question)
    assert told in str(caught.value)
    assert caught.value.exit_code == 2
