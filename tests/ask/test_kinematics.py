"""Motions that are given need no masses: what is asked of them is told, and what hangs on a mass is refused."""

import pytest

from rbpsym import ask, derive, load_text
from rbpsym.errors import StatementError

WHEEL = """
[parameters]
R = "length: radius"
v = "speed: of the axle"
a = "acceleration: of the axle"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v"
{more}
[coordinates.phi]
start = "0"
[bodies.wheel]
shape = "disk"
radius = "R"
center = ["x", "R"]
angle = "-phi"
points = {{ P = ["0", "R"] }}
[constraints.N]
type = "rolling"
body = "wheel"
line = "y = 0"
"""
COLLAR = """
[parameters]
b = "length"
u = "speed"
a = "acceleration"
omega = "angular speed"
alpha = "angular acceleration"
[coordinates.theta]
start = "0"
speed = "omega"
acceleration = "alpha"
[coordinates.r]
dimension = "length"
start = "b"
speed = "u"
acceleration = "a"
[bodies.arm]
shape = "rod"
length = "2*b"
start = "O"
angle = "theta"
[bodies.collar]
shape = "particle"
center = ["r*cos(theta)", "r*sin(theta)"]
"""
FOUR_BAR = """
[parameters]
a = "length"
d = "length"
Omega = "angular speed"
[coordinates.theta]
start = "pi/2"
speed = "Omega"
[coordinates.beta]
start = "0"
[coordinates.gamma]
start = "3*pi/4"
[points]
C = ["a + d", "0"]
[bodies.crank]
shape = "rod"
length = "a"
start = "O"
angle = "theta"
[bodies.coupler]
shape = "rod"
length = "d"
start = "crank.end"
angle = "beta"
[bodies.rocker]
shape = "rod"
length = "sqrt(2)*a"
start = "C"
angle = "gamma"
[constraints.E]
type = "pin"
points = ["coupler.end", "rocker.end"]
"""
ROD = """
[parameters]
L = "length"
u = "speed: of the foot"
[coordinates.theta]
start = "theta_0"
speed = "u/(L*sin(theta_0))"
[bodies.rod]
shape = "rod"
length = "L"
start = ["L*cos(theta)", "0"]
angle = "pi - theta"
"""
STEADY, GROWING = WHEEL.format(more=""), WHEEL.format(more='acceleration = "a"')


@pytest.mark.parametrize(
    ("text", "question", "wanted"),
    [
        (STEADY, "velocity of wheel.P where phi = pi/2", "(v, -v)"),
        (STEADY, "acceleration of wheel.P at the start", "(0, -v**2/R)"),
        (STEADY, "angular velocity of wheel", "-v/R"),
        (GROWING, "acceleration of wheel.P at the start", "(2*a, -v**2/R)"),
        (GROWING, "speed of wheel.P where x = R*pi", "0"),
        (COLLAR, "acceleration of collar at the start", "(a - b*omega**2, b*alpha + 2*u*omega)"),
        (FOUR_BAR, "angular velocity of coupler at the start", "-a*Omega/d"),
        (FOUR_BAR, "angular acceleration of rocker at the start", "Omega**2*(1 + a/d)"),
        (FOUR_BAR, "instantaneous centre of coupler at the start", "(0, a + d)"),
    ],
)
def test_a_given_motion_needs_no_masses(text: str, question: str, wanted: str) -> None:
    [found] = ask(load_text(text), question)
    assert found.verdict.is_proved
    assert found.text.replace(" ", "") == wanted.replace(" ", "")


@pytest.mark.parametrize(
    ("text", "question", "said"),
    [
        (STEADY, "N", "it hangs on masses"),
        (STEADY, "kinetic energy", "hangs on masses, which are not stated (m_wheel)"),
        (ROD, "acceleration of rod.end at the start", "the acceleration of theta is not stated"),
    ],
)
def test_what_hangs_on_a_mass_is_refused(text: str, question: str, said: str) -> None:
    with pytest.raises(StatementError) as refused:
        ask(load_text(text), question)
    assert said in refused.value.what


def test_a_speed_that_hangs_on_the_place_is_that_of_the_start_alone() -> None:
    [found] = ask(load_text(ROD), "velocity of rod.end at the start")
    assert found.verdict.is_proved


def test_nothing_is_said_of_forces() -> None:
    found = derive(load_text(GROWING))
    assert found.steps and all(step.certificate.verdict.is_proved for step in found.steps)
    assert found.lagrange is None
