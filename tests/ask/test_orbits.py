"""What keeps turning has no rest: its steady motion is asked for, and the small oscillations about that."""

import math

import pytest

from rbpsym.ask.asking import ask
from rbpsym.errors import StatementError
from rbpsym.statement.loader import load_text

PUCK = """
[parameters]
m = "mass: puck"
k = "stiffness: spring"
ell = "length: natural length"
r_0 = "length > ell: distance at the start"
omega_0 = "angular speed: at the start"
[coordinates.r]
dimension = "length"
start = "r_0"
range = ["0", ""]
[coordinates.phi]
start = "0"
speed = "omega_0"
[bodies.puck]
shape = "particle"
mass = "m"
center = ["r*cos(phi)", "r*sin(phi)"]
[interactions.S]
type = "spring"
between = ["O", "puck.center"]
stiffness = "k"
natural_length = "ell"
"""
WEIGHT = """
[parameters]
m = "mass: puck"
M = "mass: weight"
r_0 = "length: distance at the start"
omega_0 = "angular speed: at the start"
z_0 = "length: depth of the weight at the start"
g = "acceleration: gravity"
[coordinates.r]
dimension = "length"
start = "r_0"
range = ["0", ""]
[coordinates.phi]
start = "0"
speed = "omega_0"
[bodies.puck]
shape = "particle"
mass = "m"
center = ["r*cos(phi)", "r*sin(phi)"]
[bodies.weight]
shape = "particle"
mass = "M"
center = ["0", "-z_0 + r - r_0"]
[interactions.W]
type = "gravity"
bodies = ["weight"]
[constraints.T]
type = "string"
path = ["puck.center", { around = "O" }, "weight.center"]
"""
STEADY = "with omega_0 = sqrt(k*(r_0 - ell)/(m*r_0))"
ROUND = "with omega_0 = sqrt(M*g/(m*r_0))"
ASKED = (
    (PUCK, f"frequency of r {STEADY}", "sqrt(k*(4*r_0 - 3*ell)/(m*r_0))"),
    (PUCK, f"period of r {STEADY}", "2*pi*sqrt(m*r_0/(k*(4*r_0 - 3*ell)))"),
    (PUCK, f"equilibrium of r {STEADY}", "r_0"),
    (PUCK.replace('speed = "omega_0"', ""), "frequency of r", "sqrt(k/m)"),  # what does not turn swings about its rest
    (WEIGHT, f"frequency of r {ROUND}", "sqrt(3*M*g/(r_0*(m + M)))"),
)


@pytest.mark.parametrize(("text", "question", "value"), ASKED, ids=[question for _, question, _ in ASKED])
def test_small_oscillations_about_a_steady_motion(text: str, question: str, value: str) -> None:
    [found] = ask(load_text(text), question)
    assert found.verdict.is_proved and found.text == value and not found.valid


@pytest.mark.parametrize("question", ["frequency of r", "equilibrium of r", "r as a function of t for small oscillations"])
def test_of_what_turns_no_rest_is_told(question: str) -> None:
    with pytest.raises(StatementError):
        ask(load_text(PUCK), question)


def test_the_frequency_about_a_steady_motion_is_that_of_the_motion() -> None:
    """r'' = h²/r³ - (k/m)(r - l), from a little outside of r_0 to where it turns: m = k = r_0 = 1, l = 1/2."""
    h2, r, v, step, time = 0.5, 1.001, 0.0, 1e-4, 0.0
    while time < step or v < 0:
        v += step / 2 * (h2 / r**3 - (r - 0.5))
        r += step * v
        v += step / 2 * (h2 / r**3 - (r - 0.5))
        time += step
    assert time == pytest.approx(math.pi / math.sqrt(4 - 3 * 0.5), rel=1e-3)
