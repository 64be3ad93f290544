"""Questions that have no answer: each gets its sentence, and exit code 2."""

from __future__ import annotations

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.errors import RbpsymError
from rbpsym.statement.loader import load_text
from tests.ask.test_answers import asked
from tests.ask.test_unseen import HERE

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
    ("rod-pendulum", "time until theta = pi/12", "no closed form was found for the time"),
    ("rod-pendulum", "time until theta = theta_0/2", "no closed form was found for the time"),  # no half of a time
    ("rod-pendulum", "time until theta = 1/M - 1/ell", "must have one dimension"),
    ("rod-pendulum", "F_y at the start as a function of theta", "is no function"),
    ("rod-pendulum", "F_y at the start where theta = 0", "twice"),
    ("rod-pendulum", "F_y as a function of t", "no closed form was found for “F_y” as a function of the time"),
    ("rod-pendulum", "F_y when F_y stops slipping", "there is no contact"),
    ("rod-pendulum", "component of mass of rod along rod", "is no vector"),
    ("rod-pendulum", "frequency of g", "is no coordinate"),
    ("weak-torsion-spring", "equilibrium of theta", "others than the unstable one are not excluded"),
    ("rod-pendulum", "impulse of F when struck begins", "no phase “struck”"),
    ("rod-pendulum", "direction of mass of rod", "is no vector"),
    ("elastic-pendulum", "angular velocity of bob", "“bob” is a particle, which does not turn"),
    ("elastic-pendulum", "number of turns of bob until theta = 0", "ask for that of “theta”"),
    ("sliding-ladder", "N_w where theta = 2", "does not come to this value"),
    ("sliding-ladder", "F_y in equilibrium", "means nothing"),
    ("sliding-ladder", "N_w in equilibrium", "no stable equilibrium"),
    ("sliding-ladder", "period of theta", "no stable equilibrium"),
    ("center-of-percussion", "F_y at the end of phase struck", "nothing ends this phase"),
    ("ball-slipping-to-rolling", "time until roling", "did you mean “rolling”?"),
    ("rod-pendulum", "tension", "the problem has no tension"),
    ("double-atwood", "tension", "which tension is meant?"),
    ("rod-pendulum", "energy lost", "the problem has no blow"),
    ("double-compound-pendulum", "ratio of theta_1 to phi in the lowest mode", "“phi” is no coordinate"),
    ("rod-pendulum", "period of theta about theta = pi", "no stable equilibrium"),
    ("rod-pendulum", "F_y where F_x = 7*M*g", "does not have this value"),
    ("cart-and-rod", "x where x comes to rest", "no closed form"),
]


@pytest.mark.parametrize(("name", "question", "told"), WRONG, ids=lambda value: str(value)[:60])
def test_what_has_no_answer_gets_a_sentence(name: str, question: str, told: str) -> None:
    with pytest.raises(RbpsymError) as caught:
        answered(asked(name), question)
    assert told in str(caught.value)
    assert caught.value.exit_code == 2


BESIDE = """
[parameters]
m = "mass: block"
M = "mass: plank"
b = "length: place of the block"
g = "acceleration: gravity"
[coordinates.x]
meaning = "place"
dimension = "length"
start = "0"
[bodies.plank]
shape = "particle"
mass = "M"
center = ["x", "0"]
[bodies.block]
shape = "particle"
mass = "m"
center = ["x + b", "0"]
[interactions.W]
type = "gravity"
[constraints.R]
type = "guide"
point = "plank.center"
line = "y = 0"
[constraints.N]
type = "contact"
point = "block.center"
of = "plank"
line = "y = 0"
"""


def test_a_force_beside_a_particle_is_told() -> None:
    with pytest.raises(RbpsymError, match="beside its place, and a particle bears no torque"):
        answered(Asked(load_text(BESIDE, "b.toml")), "N")


def test_a_motion_that_never_comes_about_is_not_told() -> None:
    text = (HERE / "plate-pins.toml").read_text(encoding="utf-8").replace('side = "positive"', 'side = "negative"')
    with pytest.raises(RbpsymError, match="would have to pull at the start"):
        answered(Asked(load_text(text, "p.toml")), "B at the start")


EITHER_WAY = """
[parameters]
m = "mass"
M = "mass"
R = "length"
h = "length"
g = "acceleration"
[points]
Q = ["0", "0"]
[coordinates.z]
dimension = "length"
start = "-h"
[coordinates.y]
dimension = "length"
start = "-h"
[bodies.left]
shape = "particle"
mass = "m"
center = ["-R", "y"]
[bodies.right]
shape = "particle"
mass = "M"
center = ["R", "z"]
[interactions.W]
type = "gravity"
[constraints.S]
type = "string"
path = ["left.center", { around = "Q", radius = "R", sense = "cw" }, "right.center"]
"""


def test_what_rises_or_falls_by_the_parameters_has_no_largest_place_that_is_told() -> None:
    assert not answered(Asked(load_text(EITHER_WAY, "e.toml")), "largest z").verdict.is_proved
